"""stayput verifies earthquake-proof measures for furniture.

Will it stay put, what happens if it does not, and what helps? Public names are listed once, in the stub
``__init__.pyi``, and load on first use, so that ``import stayput`` stays light.
"""

__version__ = "0.1.0"


# Type checkers read the stub and never come here; the library itself is not fully typed.
def __getattr__(name):  # pyright: ignore
    import lazy_loader  # which takes longer to load than all else that the command line needs of this module

    public = lazy_loader.attach_stub(__name__, __file__)  # pyright: ignore
    globals().update(zip(("__getattr__", "__dir__", "__all__"), public, strict=True))  # pyright: ignore
    return getattr(__import__(__name__), name)  # pyright: ignore


def __dir__():  # pyright: ignore
    return __getattr__("__all__")  # pyright: ignore
