"""Functions that are compiled once, whose machine code is kept on disk and runs without Numba.

Why not ``numba.njit(cache=True)`` alone: its cold start took twice as long, since each function was optimized
with all that it calls before its callers were; a start that finds its code imported Numba, which takes most
of a second; and its files carry no checksums, while LLVM aborts the process on a damaged one. So Numba is a
front end (`stayput.compiling.front_end`), and the machine code is ours (`stayput.compiling.machine_code`).
This was tried with Numba 0.62 to 0.68. Where the inside of another Numba differs, functions are compiled by
``njit`` itself, at each start: slower to begin, and the same afterwards.

Strict IEEE arithmetic: no fast-math flags, so results are bit-identical on every x86-64 processor, whatever
its vector width. Nothing is allocated inside, so reference counting (NRT) is off: it would cost as much as
the mechanics, and more with every thread that shares a motion.

A function that Python calls is an *entry*. Its arguments are floats, whole numbers, arrays (also of records)
and tuples of arrays; what it computes it writes into arrays. At the first call with arguments of some types
its machine code is loaded from disk, or compiled with all that it calls where there is none.
"""

from __future__ import annotations

import ctypes
import logging
import threading
from collections.abc import Callable, Generator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar, cast

import numpy as np
from numpy.typing import NDArray

from stayput.errors import InputError
from stayput.progress import bar

if TYPE_CHECKING:
    from stayput.compiling.machine_code import MachineCode

P = ParamSpec("P")
T = TypeVar("T")

_LOG = logging.getLogger("stayput")
_compiling = threading.RLock()
_announcements: list[Callable[[], None]] = []
_ALONE = "This version of Numba compiles stayput in its own way, which takes longer and at each start"
_by_numba_alone = threading.Event()
"""Set where the inside of the installed Numba is not as the front end needs it."""


class _Inner:
    """A function that only compiled functions call."""

    def __init__(self, function: Callable[..., Any], *, forceinline: bool) -> None:
        self.py_func, self._forceinline = function, forceinline
        self.__doc__, self.__name__ = function.__doc__, function.__name__
        self.__module__, self.__code__ = function.__module__, function.__code__

    @property
    def dispatcher(self) -> Any:
        """The function as Numba compiles it."""
        return _dispatcher(self.py_func, self._forceinline, _by_numba_alone.is_set())

    @property
    def _numba_type_(self) -> Any:
        """How Numba sees it where a compiled function calls it."""
        return self.dispatcher._numba_type_


@cache
def _dispatcher(function: Callable[..., Any], forceinline: bool, by_numba_alone: bool) -> Any:
    """Return a function as the front end compiles it, or as Numba alone does."""
    if by_numba_alone:
        return _numba().njit(error_model="numpy", nogil=True, forceinline=forceinline)(function)
    from stayput.compiling.front_end import dispatcher

    return dispatcher(function, forceinline=forceinline)


def inner(function: Callable[P, T]) -> Callable[P, T]:
    """Compile a function that only compiled functions call."""
    return _Inner(function, forceinline=False)  # type: ignore[return-value]


def inline(function: Callable[P, T]) -> Callable[P, T]:
    """Compile a small function into its callers: one that every step of every case calls."""
    return _Inner(function, forceinline=True)  # type: ignore[return-value]


class Entry:
    """A compiled function that Python calls.

    Parameters
    ----------
    function : callable
        Its source; it returns nothing.
    """

    def __init__(self, function: Callable[..., None]) -> None:
        self.py_func = function
        self.__doc__, self.__name__ = function.__doc__, function.__name__
        self.__module__ = function.__module__
        self._loaded: dict[tuple[Any, ...], Callable[..., None]] = {}

    def __call__(self, *arguments: Any) -> None:
        """Call it; other threads run meanwhile.

        Raises
        ------
        TypeError
            An argument of another kind, or an array that is not contiguous.
        """
        kinds = tuple(map(kind_of, arguments))
        call = self._loaded.get(kinds)
        if call is None:
            with _compiling:
                call = self._loaded.get(kinds)
                if call is None:
                    call = self._loaded[kinds] = self._load(kinds)
        call(*arguments)

    def _load(self, kinds: tuple[Any, ...]) -> Callable[..., None]:
        """Return what calls its machine code for arguments of some types."""
        from stayput.compiling.machine_code import MachineCode

        # it is made of the sources in the folders of all functions that it names, and of theirs
        folder = Path(self.py_func.__code__.co_filename).parent
        others = {Path(f.__code__.co_filename).parent for f in _named_in(self.py_func, set())} - {folder}
        code = MachineCode(f"{self.__module__}.{self.__name__}", kinds, (folder, *sorted(others)))
        if (address := code.load()) is not None:
            return self._caller(address, kinds)
        for announce in _announcements:
            announce()
        _announcements.clear()
        if not _by_numba_alone.is_set():
            try:
                return self._caller(self._compiled(code, kinds), kinds)
            except InputError:
                raise
            except Exception as error:  # whatever a Numba that nobody has tried yet raises
                _by_numba_alone.set()
                _LOG.warning(f"{_ALONE} ({type(error).__name__}: {error}).".replace("\n", " "))
        return _dispatcher(self.py_func, False, True)

    def _compiled(self, code: MachineCode, kinds: tuple[Any, ...]) -> int:
        """Compile it, keep its machine code on disk, and return its address."""
        from stayput.compiling.front_end import bitcode
        from stayput.compiling.machine_code import uninterrupted

        # how many functions there will be depends on what the arguments rule out: the bar has no end
        with bar(None, "progress.compiling", unit="progress.functions") as advance:
            compiled = bitcode(self.py_func, tuple(map(_numba_type, kinds)), lambda function: advance(1))
            return uninterrupted(lambda: code.add(compiled))

    def _caller(self, address: int, kinds: tuple[Any, ...]) -> Callable[..., None]:
        """Return a function of Python that calls machine code."""
        types: list[Any] = []
        for kind in kinds:
            _append_types(kind, types)
        run = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_void_p, *types)(address)

        def call(*arguments: Any) -> None:
            values: list[Any] = []
            copies: list[tuple[NDArray[Any], NDArray[Any]]] = []
            for argument in arguments:
                _append_values(argument, values, copies)
            if status := run(ctypes.byref(ctypes.c_void_p()), ctypes.byref(ctypes.c_void_p()), *values):
                raise RuntimeError(f"{self.__name__} ended with the status {status}.")
            for array, copy in copies:
                if array.flags.writeable:
                    array[...] = copy

        return call


def _named_in(function: Callable[..., Any], known: set[Callable[..., Any]]) -> set[Callable[..., Any]]:
    """Add the compiled functions that a function names, and those that they name, to those known."""
    for name in function.__code__.co_names:
        named = function.__globals__.get(name)
        if isinstance(named, _Inner) and named.py_func not in known:
            known.add(named.py_func)
            _named_in(named.py_func, known)
    return known


def entry(function: Callable[P, None]) -> Callable[P, None]:
    """Compile a function that Python calls."""
    return Entry(function)  # type: ignore[return-value]


def _numba() -> Any:
    """Import Numba, whose type stubs leave out much of it."""
    import numba

    return numba


def kind_of(argument: Any) -> Any:
    """Return what a compiled function depends on in an argument.

    That is "f" or "i" for a number, "none", an array's dtype and number of dimensions, or the class of a
    tuple and what it holds.
    """
    if isinstance(argument, np.ndarray):
        if not argument.flags.c_contiguous:
            raise TypeError("An array is not contiguous; compiled functions take contiguous arrays.")
        return argument.dtype, argument.ndim
    if isinstance(argument, tuple):
        parts = cast("tuple[Any, ...]", argument)
        return type(parts), *map(kind_of, parts)
    if isinstance(argument, float):
        return "f"
    if isinstance(argument, int | np.integer):
        return "i"
    if argument is None:
        return "none"
    raise TypeError(f"A compiled function cannot take a {type(argument).__name__}.")


def _numba_type(kind: Any) -> Any:
    types = _numba().types
    match kind:
        case "f":
            return types.float64
        case "i":
            return types.int64
        case "none":
            return types.none
        case (np.dtype() as dtype, int(dimensions)):
            return types.Array(_numba().from_dtype(dtype), dimensions, "C", aligned=True)
        case _:
            cls, *parts = kind
            named = None if cls is tuple else cls
            return types.BaseTuple.from_types(tuple(map(_numba_type, parts)), named)


def _append_types(kind: Any, types: list[Any]) -> None:
    """Append the C types of an argument."""
    match kind:
        case "f":
            types.append(ctypes.c_double)
        case "i":
            types.append(ctypes.c_int64)
        case "none":
            types.append(ctypes.c_void_p)
        case (np.dtype(), int(dimensions)):
            types += [ctypes.c_void_p] * 2 + [ctypes.c_int64] * 2 + [ctypes.c_void_p]
            types += [ctypes.c_int64] * (2 * dimensions)
        case _:
            for part in kind[1:]:
                _append_types(part, types)


def _append_values(argument: Any, values: list[Any], copies: list[tuple[NDArray[Any], NDArray[Any]]]) -> None:
    """Append the C values of an argument.

    An array that is not aligned, as one that has come from another process may be, is appended to ``copies``
    with its aligned copy.
    """
    if isinstance(argument, np.ndarray):
        if not argument.flags.aligned:
            original = cast("NDArray[Any]", argument)
            argument = original.copy()
            copies.append((original, argument))
        values += (None, None, argument.size, argument.itemsize, argument.ctypes.data)
        values += (*argument.shape, *argument.strides)
    elif isinstance(argument, tuple):
        for part in argument:  # pyright: ignore[reportUnknownVariableType]
            _append_values(part, values, copies)
    else:
        values.append(argument)


@contextmanager
def on_compilation(callback: Callable[[], None]) -> Generator[None]:
    """Call ``callback`` once, before the first compilation; never if all code is on disk."""
    _announcements.append(callback)
    try:
        yield
    finally:
        if callback in _announcements:
            _announcements.remove(callback)
