"""How inner loops are compiled: strict IEEE arithmetic, and code on disk for the entry points alone.

No fast-math flags: the same bits come out on every x86-64 processor, whatever its vector width. The inner
functions get no Python wrappers and no files of their own, which would make up most of a cold compile.
Nothing is allocated inside, so reference counting is off: it would cost as much as the mechanics, and
more with every thread that shares a motion.
"""

from __future__ import annotations

from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

from numba import njit
from numba.core.event import Event, Listener
from numba.core.event import install_listener as _install_listener  # pyright: ignore[reportUnknownVariableType]
from numba.core.types import unliteral  # pyright: ignore[reportUnknownVariableType]

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterable

_without_value: Any = unliteral  # pyright: ignore[reportUnknownVariableType]
compile_with: Any = njit  # Numba's type stubs leave out some of the options
P = ParamSpec("P")
T = TypeVar("T")

SETTINGS = {"error_model": "numpy", "_nrt": False}
"""A division by zero gives infinity or NaN, as in IEEE arithmetic, instead of an exception."""

WITHIN = SETTINGS | {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}


def inner(function: Callable[P, T]) -> Callable[P, T]:
    """Compile a function that only compiled functions call."""
    return _whatever_the_constants(compile_with(**WITHIN)(function))


def inline(function: Callable[P, T]) -> Callable[P, T]:
    """Compile a small function into its callers: one of those that every step of every case passes."""
    return _whatever_the_constants(compile_with(**WITHIN, forceinline=True)(function))


def _whatever_the_constants(compiled: Any) -> Any:
    """Compile a function once for all constants that it is called with, not anew for each: a cold start."""
    template = getattr(compiled, "get_call_template", None)  # not where NUMBA_DISABLE_JIT is set
    if template is not None:

        def template_of(args: Any, kws: Any) -> Any:
            return template(tuple(_without_value(kind) for kind in args), kws)

        compiled.get_call_template = template_of
    return compiled


def entry(function: Callable[P, T]) -> Callable[P, T]:
    """Compile a function that Python calls, without the interpreter's lock, and keep the code on disk."""
    compiled = compile_with(**SETTINGS, cache=True, nogil=True)(function)
    if hasattr(compiled, "stats"):  # not where NUMBA_DISABLE_JIT leaves the function as it is
        called = [value.py_func for value in function.__globals__.values() if hasattr(value, "py_func")]
        sources = {Path(part.__code__.co_filename).parent for part in (function, *called)}
        _forget_outdated(Path(compiled.stats.cache_path), sources)
    return compiled


def _forget_outdated(folder: Path, sources: Iterable[Path]) -> None:
    """Drop code on disk that is older than a file of the source folders: Numba looks at the entry's alone."""
    edited = max(file.stat().st_mtime for source in sources for file in source.glob("*.py"))
    with suppress(OSError):
        for index in folder.glob("*.nbi"):
            if index.stat().st_mtime < edited:
                index.unlink(missing_ok=True)


class _Once(Listener):
    """Calls back at the first compilation."""

    def __init__(self, tell: Callable[[], None]) -> None:
        self.tell: Callable[[], None] | None = tell

    def on_start(self, event: Event) -> None:
        if self.tell is not None:
            tell, self.tell = self.tell, None
            tell()

    def on_end(self, event: Event) -> None:
        pass


@contextmanager
def told_of_compilation(tell: Callable[[], None]) -> Generator[None]:
    """Call ``tell`` once, before anything is compiled; never if all code lies on disk already."""
    with _install_listener("numba:compile", _Once(tell)):
        yield
