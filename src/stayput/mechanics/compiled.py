"""How the mechanics are compiled: strict IEEE arithmetic, and code on disk for the entry points alone.

No fast-math flags: the same bits come out on every x86-64 processor, whatever its vector width. The inner
functions get no Python wrappers and no files of their own, which would make up most of a cold compile.
Nothing is allocated inside, so reference counting is off: it would cost as much as the mechanics, and
more with every thread that shares a motion.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import ParamSpec, TypeVar

from numba import njit

P = ParamSpec("P")
T = TypeVar("T")


def inner(function: Callable[P, T]) -> Callable[P, T]:
    """Compile a function that only compiled functions call."""
    return njit(no_cpython_wrapper=True, no_cfunc_wrapper=True, _nrt=False)(function)


def entry(function: Callable[P, T]) -> Callable[P, T]:
    """Compile a function that Python calls, without the interpreter's lock, and keep the code on disk."""
    return njit(cache=True, nogil=True, _nrt=False)(function)
