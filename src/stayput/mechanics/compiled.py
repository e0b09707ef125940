"""How the mechanics are compiled: strict IEEE arithmetic, and code on disk for the entry points alone.

No fast-math flags: the same bits come out on every x86-64 processor, whatever its vector width. The inner
functions get no Python wrappers and no files of their own, which would make up most of a cold compile.
Nothing is allocated inside, so reference counting is off: it would cost as much as the mechanics, and
more with every thread that shares a motion.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

from numba import njit

if TYPE_CHECKING:
    from collections.abc import Callable

compile_with: Any = njit  # Numba's type stubs leave out some of the options
P = ParamSpec("P")
T = TypeVar("T")


def inner(function: Callable[P, T]) -> Callable[P, T]:
    """Compile a function that only compiled functions call."""
    return compile_with(no_cpython_wrapper=True, no_cfunc_wrapper=True, _nrt=False)(function)


def inline(function: Callable[P, T]) -> Callable[P, T]:
    """Compile a small function into its callers: one of those that every step of every case passes."""
    options = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True, "_nrt": False, "forceinline": True}
    return compile_with(**options)(function)


def entry(function: Callable[P, T]) -> Callable[P, T]:
    """Compile a function that Python calls, without the interpreter's lock, and keep the code on disk."""
    return compile_with(cache=True, nogil=True, _nrt=False)(function)
