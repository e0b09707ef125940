"""Many calls, a bounded number at a time: on threads, or on any executor of `concurrent.futures`.

Nothing here knows what the calls compute. A caller opens a pool, gives it an iterable of calls and takes the
results as they come or in the order of the calls::

    with Pool(threads) as pool:
        for result in pool.in_order(partial(function, argument) for argument in arguments):
            ...

The iterable is consumed as results are taken, never far ahead of them, so neither calls nor results pile up
in memory.
"""

from __future__ import annotations

import itertools
import math
import os
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from contextvars import ContextVar
from functools import partial
from threading import Event, Lock, current_thread, main_thread
from typing import TYPE_CHECKING, Any, Generic, Self, TypeVar
from uuid import uuid4
from weakref import WeakValueDictionary

from cachetools import LRUCache

import stayput
from stayput.errors import InputError, instance_of, whole_within

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

T = TypeVar("T")

MOST_THREADS = 4096
"""Most threads that are accepted."""

WIDTH = 128
"""Calls that a given executor is taken to compute at a time; it does not tell how many."""

AHEAD = 2
"""Calls handed in for each thread: one being computed, and another so that no thread waits."""

SHARED_KEPT = 4
"""Shared values that a process of a given executor keeps: those of the calls under way and the next."""


def cores() -> int:
    """Return how many cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def thread_count(threads: int | None) -> int:
    """Return the number of threads asked for, by default one for each core.

    Raises
    ------
    InputError
        Less than one thread, or more than `MOST_THREADS`.
    """
    if threads is None:
        return cores()
    return whole_within("common.threads", threads, 1, MOST_THREADS, field="threads")


_STOP: ContextVar[Stop | None] = ContextVar("stop", default=None)


class Stop(Event):
    """Ends runs of other threads once it is set: by their limit of work, at which they look in each step.

    One that is made where another ends the runs is set with it.
    """

    def __init__(self) -> None:
        super().__init__()
        self.above = _STOP.get()
        self.limits: dict[int, NDArray[np.float64]] = {}

    def set(self) -> None:
        """End the runs, and those that are still to come."""
        super().set()
        for limit in list(self.limits.values()):
            limit[0] = -math.inf

    @contextmanager
    def ending_runs(self) -> Generator[None]:
        """End the runs of this thread within the block."""
        token = _STOP.set(self)
        try:
            yield
        finally:
            _STOP.reset(token)


def endable(run: Callable[[], object], limit: NDArray[np.float64]) -> None:
    """Do a long run in compiled code, which ends on Ctrl-C, or by the `Stop` of this thread.

    Python hears Ctrl-C on its main thread alone, and there between its own instructions: the run has another.

    Parameters
    ----------
    run : callable
        The run; it releases the interpreter's lock.
    limit : ndarray, shape (1,)
        Of its work, which it looks at in each step and does not write.
    """
    if current_thread() is main_thread():
        with Pool(1) as pool:  # an exception in the block ends the run
            list(pool.in_order([partial(endable, run, limit)]))
        return
    stops: list[Stop] = []
    stop = _STOP.get()
    while stop is not None:
        stops.append(stop)
        stop = stop.above
    for stop in stops:
        stop.limits[id(limit)] = limit
        if stop.is_set():
            limit[0] = -math.inf
    try:
        run()
    finally:
        for stop in stops:
            del stop.limits[id(limit)]


class Pool:
    """Computes calls, which are functions without arguments; each result comes with its number or in order.

    It is a context manager: at the end of the block calls that have not begun are dropped; where an exception
    ends it (Ctrl-C among them), runs under way on its threads end too. It computes one iterable of calls at a
    time.

    Parameters
    ----------
    threads : int, optional
        How many threads, for functions that release the interpreter's lock; by default one for each core that
        this process may use. With an executor: how many calls it computes at a time, by default `WIDTH`.
    executor : concurrent.futures.Executor, optional
        Computes the calls instead; it is not shut down. Where it has processes of its own, calls must be
        picklable, and a `Shared` value is sent to each process once.

    Raises
    ------
    InputError
        A number of threads out of range, or no executor.

    Examples
    --------
    >>> with Pool(2) as pool:
    ...     list(pool.in_order(partial(pow, 2, n) for n in range(5)))
    [1, 2, 4, 8, 16]
    """

    def __init__(self, threads: int | None = None, executor: Executor | None = None) -> None:
        if executor is not None:
            instance_of("executor", executor, Executor)
        self.width = thread_count(WIDTH if threads is None and executor is not None else threads)
        self._on_threads = executor is None
        self._executor = ThreadPoolExecutor(self.width) if executor is None else executor
        self._under_way: dict[Future[Any], tuple[int, Callable[[], Any], dict[str, Callable[[], Any]]]] = {}
        self._submitted = itertools.count()
        self._stop = Stop()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, *exception: object) -> None:
        self._drop()
        if kind is not None:
            self._stop.set()
        if self._on_threads:
            self._executor.shutdown(wait=True, cancel_futures=True)

    def as_completed(self, calls: Iterable[Callable[[], T]]) -> Generator[tuple[int, T]]:
        """Yield the number of each call and its result, as they are completed.

        What a call raises is raised here, and what is not completed then is dropped.

        Parameters
        ----------
        calls : iterable of callable
            The calls; consumed on this thread, up to `AHEAD` calls for each thread before their results.

        Raises
        ------
        InputError
            The executor is lost.
        """
        return self._results(calls, in_order=False)

    def in_order(self, calls: Iterable[Callable[[], T]]) -> Iterator[T]:
        """Yield the results in the order of the calls; else as `as_completed`."""
        return (result for _, result in self._results(calls, in_order=True))

    def _results(self, calls: Iterable[Callable[[], T]], *, in_order: bool) -> Generator[tuple[int, T]]:
        if self._on_threads and self.width == 1 and current_thread() is not main_thread():
            # another thread would do nothing but take its time to start
            yield from ((number, call()) for number, call in enumerate(calls))
            return
        todo = enumerate(calls)
        completed: dict[int, Future[T]] = {}
        yielded = 0
        try:
            while True:
                # A completed call counts until it is given: a slow first call must not let results pile up.
                while len(self._under_way) + len(completed) < AHEAD * self.width:
                    numbered = next(todo, None)
                    if numbered is None:
                        break
                    self._hand_in(*numbered, {})
                number = yielded if in_order else next(iter(completed), None)
                if number in completed:
                    yielded += 1
                    yield number, completed.pop(number).result()
                elif self._under_way:
                    completed.update(self._wait())
                else:
                    return
        finally:
            self._drop()

    def _hand_in(self, number: int, call: Callable[[], Any], sent: dict[str, Callable[[], Any]]) -> None:
        """Submit a call, to a given executor with the shared values that its process lacked."""
        if self._on_threads:
            future = self._executor.submit(self._stop.ending_runs()(call))
        else:
            try:
                # The number makes each submission another one for executors that remember results.
                future = self._executor.submit(
                    _elsewhere, stayput.__version__, next(self._submitted), call, sent
                )
            except Exception as error:
                raise _lost(error) from error
        self._under_way[future] = number, call, sent

    def _wait(self) -> dict[int, Future[Any]]:
        """Wait for calls; return those that are completed by their numbers."""
        completed: dict[int, Future[Any]] = {}
        for future in wait(self._under_way, return_when=FIRST_COMPLETED).done:
            number, call, sent = self._under_way.pop(future)
            if self._on_threads:
                completed[number] = future
                continue
            try:
                lacking, raised, result = future.result()
            except Exception as error:
                raise _lost(error) from error
            if lacking is not None:
                self._hand_in(number, call, {**sent, lacking: _shared[lacking].once.compute})
                continue
            completed[number] = Future()
            if raised is None:
                completed[number].set_result(result)
            else:
                completed[number].set_exception(raised)
        return completed

    def _drop(self) -> None:
        for future in self._under_way:
            future.cancel()
        self._under_way.clear()


class _Once(Generic[T]):
    """A call that is computed when its result is first asked for, by one thread."""

    def __init__(self, compute: Callable[[], T]) -> None:
        self.compute, self._lock = compute, Lock()
        self._made: list[T] = []

    def __call__(self) -> T:
        with self._lock:
            if not self._made:
                self._made.append(self.compute())
        return self._made[0]


class Shared(Generic[T]):
    """A value that many calls need: computed once in each process, which is sent the arguments once.

    With a call only its key is sent; a process that lacks it says so, and is sent the arguments.

    Parameters
    ----------
    function : callable
        The function.
    *arguments
        Its arguments.
    """

    def __init__(self, function: Callable[..., T], *arguments: object) -> None:
        self.key = uuid4().hex
        self.once: _Once[T] = _Once(partial(function, *arguments))
        _shared[self.key] = self

    def __reduce__(self) -> tuple[Any, ...]:
        return _SharedElsewhere, (self.key,)

    @property
    def value(self) -> T:
        """The value; computed where it is asked for first."""
        return self.once()


_shared: WeakValueDictionary[str, Shared[Any]] = WeakValueDictionary()
_kept: LRUCache[str, _Once[Any]] = LRUCache(SHARED_KEPT)
_kept_lock = Lock()


class _LackingError(Exception):
    """A shared value that this process was not sent, by its key."""


class _SharedElsewhere:
    """A `Shared` value as a call has it in another process."""

    def __init__(self, key: str) -> None:
        self.key = key

    @property
    def value(self) -> Any:
        with _kept_lock:
            once = _kept.get(self.key)
        if once is None:
            raise _LackingError(self.key)
        return once()


def _elsewhere(
    version: str, _number: int, call: Callable[[], T], sent: dict[str, Callable[[], Any]]
) -> tuple[str | None, Exception | None, T | None]:
    """Compute a call of a given executor; return the key of what it lacks, what it raises, its result.

    What it raises is returned: an exception of the executor's future is then the executor's own.
    """
    if version != stayput.__version__:
        return None, InputError("common.worker_version", worker=stayput.__version__, version=version), None
    with _kept_lock:
        for key, compute in sent.items():
            if key not in _kept:
                _kept[key] = _Once(compute)
    try:
        return None, None, call()
    except _LackingError as lacking:
        return lacking.args[0], None, None
    except Exception as error:
        return None, error, None


def _lost(error: Exception) -> InputError:
    return InputError("common.executor_lost", reason=f"{type(error).__name__}: {error}"[:200])
