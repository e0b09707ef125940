"""stayput verifies earthquake-proof measures for furniture.

Will it stay put, what happens if it does not, and what helps? Public names are listed once, in the stub
``__init__.pyi``, and load on first use, so that ``import stayput`` stays light.
"""

__version__ = "0.1.0"


# Type checkers read the stub and never come here; the library itself is not fully typed.
def __getattr__(name):  # pyright: ignore
    if "_load" not in globals():
        import lazy_loader  # takes longer to load than all else that the command line needs of this module

        public = lazy_loader.attach_stub(__name__, __file__)  # pyright: ignore
        globals().update(zip(("_load", "__dir__", "__all__"), public, strict=True))  # pyright: ignore
    return globals().get(name) or globals()["_load"](name)  # pyright: ignore


def __dir__():  # pyright: ignore
    return __getattr__("__all__")  # pyright: ignore
