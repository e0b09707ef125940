"""Numba decorators: strict IEEE arithmetic, and an on-disk cache for the entry points only.

No fast-math flags: results are bit-identical on every x86-64 processor, whatever its vector width. Inner
functions get no Python wrappers and no cache files of their own, which would take most of a cold compile.
Nothing is allocated inside, so reference counting (NRT) is off: it would cost as much as the mechanics, and
more with every thread that shares a motion.
"""

from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

from numba import njit
from numba.core.event import Event, Listener
from numba.core.event import install_listener as _install_listener  # pyright: ignore[reportUnknownVariableType]
from numba.core.types import unliteral  # pyright: ignore[reportUnknownVariableType]

from stayput.compiled_files import cache_on_disk

if TYPE_CHECKING:
    from collections.abc import Callable, Generator

_type_of_literal: Any = unliteral  # pyright: ignore[reportUnknownVariableType]
compile_with: Any = njit  # Numba's type stubs leave out some of the options
P = ParamSpec("P")
T = TypeVar("T")

SETTINGS = {"error_model": "numpy", "_nrt": False}
"""Division by zero gives infinity or NaN, as in IEEE arithmetic, not an exception; no reference counting."""

WITHIN = SETTINGS | {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}


def inner(function: Callable[P, T]) -> Callable[P, T]:
    """Compile a function that only compiled functions call."""
    return _without_literals(compile_with(**WITHIN)(function))


def inline(function: Callable[P, T]) -> Callable[P, T]:
    """Compile a small function into its callers (force-inlined): one that every step of every case calls."""
    return _without_literals(compile_with(**WITHIN, forceinline=True)(function))


def _without_literals(compiled: Any) -> Any:
    """Compile a function once for each argument type.

    By default Numba specializes a function for each literal (as ``True`` or ``0.0``) that it is called with,
    which multiplies the time of a cold start.
    """
    template = getattr(compiled, "get_call_template", None)  # not where NUMBA_DISABLE_JIT is set
    if template is not None:

        def template_of(args: Any, kws: Any) -> Any:
            return template(tuple(_type_of_literal(kind) for kind in args), kws)

        compiled.get_call_template = template_of
    return compiled


def entry(function: Callable[P, T]) -> Callable[P, T]:
    """Compile a function that Python calls: releases the GIL, and caches the code on disk."""
    compiled = compile_with(**SETTINGS, nogil=True)(function)
    if hasattr(compiled, "stats"):  # not where NUMBA_DISABLE_JIT leaves the function as it is
        # the cache is valid for the sources of all folders whose compiled functions this module imports
        called = [value.py_func for value in function.__globals__.values() if hasattr(value, "py_func")]
        cache_on_disk(compiled, {Path(part.__code__.co_filename).parent for part in (function, *called)})
    return compiled


class _FirstCompilation(Listener):
    """Calls back at the first compilation."""

    def __init__(self, callback: Callable[[], None]) -> None:
        self.callback: Callable[[], None] | None = callback

    def on_start(self, event: Event) -> None:
        if self.callback is not None:
            callback, self.callback = self.callback, None
            callback()

    def on_end(self, event: Event) -> None:
        pass


@contextmanager
def on_compilation(callback: Callable[[], None]) -> Generator[None]:
    """Call ``callback`` once, before the first compilation; never if all code is in the cache."""
    with _install_listener("numba:compile", _FirstCompilation(callback)):
        yield
