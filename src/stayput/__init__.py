"""stayput verifies earthquake-proof measures for furniture.

Will it stay put, what happens if it does not, and what helps? Public names are listed once, in the stub
``__init__.pyi``, and load on first use, so that ``import stayput`` stays light.
"""

__version__ = "0.1.0"


SUCCESSORS = {
    "fragility_curve": "FragilityCurve",
    "read_scenario": "read",
    "read_room": "read",
    "read_assembly": "read",
    "verify_room": "verify",
    "RoomVerdict": "Verdict",
    "AssemblyVerdict": "Verdict",
    "RoomScenario": "Scenario",
    "AssemblyScenario": "Scenario",
    "Solid": "Body",
    "Standing": "Piece",
    "Assembly": "Scene",
    "SpaceRun": "Run",
    "simulate_in_space": "simulate",
    "response_spectrum": "Motion.spectrum",
}
"""Public names that are gone, and the names that do what they did."""


# Type checkers read the stub and never come here; the library itself is not fully typed.
def __getattr__(name):  # pyright: ignore
    if name in SUCCESSORS:
        from stayput.catalogue import say

        successor = f"stayput.{SUCCESSORS[name]}"
        raise AttributeError(say("cli.gone", name=f"stayput.{name}", successor=successor))
    if "_load" not in globals():
        import lazy_loader  # takes longer to load than all else that the command line needs of this module

        public = lazy_loader.attach_stub(__name__, __file__)  # pyright: ignore
        globals().update(zip(("_load", "__dir__", "__all__"), public, strict=True))  # pyright: ignore
    return globals().get(name) or globals()["_load"](name)  # pyright: ignore


def __dir__():  # pyright: ignore
    return __getattr__("__all__")  # pyright: ignore
