"""Executors: many calls on threads of this process, or on the workers of a Dask cluster.

Nothing here knows what the calls compute. A caller makes an executor, gives it an iterable of calls and takes
the results as they come or in the order of the calls::

    with ThreadExecutor(threads) as executor:
        for result in executor.in_order(Call(function, argument) for argument in arguments):
            ...

The iterable is consumed as results are taken, never far ahead of them, so neither calls nor results pile up
in memory.
"""

from __future__ import annotations

import os
import time
from abc import ABC, abstractmethod
from collections import OrderedDict
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Any, Generic, TypeVar, cast
from uuid import uuid4

import stayput
from stayput.catalogue import say
from stayput.errors import InputError, whole_within
from stayput.progress import language_of_bars

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterable, Iterator
    from typing import Self

T = TypeVar("T")

MOST_THREADS = 4096
"""Most threads that are accepted."""

SHARED_KEPT = 3
"""Shared values kept at a time: those of the calls under way and the next."""

MOST_TRIES = 10
"""Times that a call may be lost with its worker before the call itself is taken for the cause."""

WORKERS_CHECKED_EVERY = 2.0
"""Time after which the workers of a cluster are counted anew [s]."""

POLL_INTERVAL = 0.01
"""Time between looks for finished calls of a cluster [s]; a call takes much longer."""

PATIENCE = 10.0
"""Time without any worker after which the user is told [s]."""


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


class Call(Generic[T]):
    """A function and its arguments, to be called by an executor.

    Parameters
    ----------
    function : callable
        The function; for a cluster one of a module, or a method of an object that can be pickled.
    *arguments
        Its arguments. One that is a `Shared` call stands for that call's result.
    """

    __slots__ = ("arguments", "function")

    def __init__(self, function: Callable[..., T], *arguments: object) -> None:
        self.function, self.arguments = function, arguments


class Shared(Call[T]):
    """A call whose result is an argument of other calls.

    It is computed once, by the executor, and on a cluster passed between the workers without this process.
    """

    __slots__ = ()

    @classmethod
    def value(cls, value: T) -> Shared[T]:
        """Share a value that is there already: it is sent to a cluster once, not with every call."""
        return Shared(_itself, value)


def _itself(value: T) -> T:
    return value


class Executor(ABC):
    """Computes calls, a bounded number at a time.

    It is a context manager: at the end of the block, by an exception too (Ctrl-C among them), calls that have
    not begun are dropped. It computes one iterable of calls at a time.
    """

    ahead = 2
    """Calls handed in for each thread: one being computed, and another so that no thread waits."""

    def __init__(self) -> None:
        self._under_way: dict[Any, tuple[int, Call[Any]]] = {}
        self._shared: OrderedDict[Shared[Any], Any] = OrderedDict()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    def as_completed(self, calls: Iterable[Call[T]]) -> Generator[tuple[int, T]]:
        """Yield the number of each call and its result, as they are completed.

        What a call raises is raised here, and what is not completed then is dropped.

        Parameters
        ----------
        calls : iterable of Call
            The calls; consumed on this thread, up to `ahead` calls for each thread before their results.
        """
        return self._results(calls, in_order=False)

    def in_order(self, calls: Iterable[Call[T]]) -> Iterator[T]:
        """Yield the results in the order of the calls; else as `as_completed`."""
        return (result for _, result in self._results(calls, in_order=True))

    def _results(self, calls: Iterable[Call[T]], *, in_order: bool) -> Generator[tuple[int, T]]:
        todo = enumerate(calls)
        completed: dict[int, Callable[[], T]] = {}
        given = 0
        try:
            while True:
                # A completed call counts until it is given: a slow first call must not let results pile up.
                while len(self._under_way) + len(completed) < self.ahead * self.width():
                    numbered = next(todo, None)
                    if numbered is None:
                        break
                    self._hand_in(*numbered)
                number = given if in_order else next(iter(completed), None)
                if number in completed:
                    given += 1
                    yield number, completed.pop(number)()
                elif self._under_way:
                    completed.update(self._wait())
                else:
                    return
        finally:
            self._drop()

    def _hand_in(self, number: int, call: Call[Any]) -> Any:
        handle = self._start(call)
        self._under_way[handle] = number, call
        return handle

    def _arguments(self, call: Call[Any]) -> Iterator[Any]:
        """Return a call's arguments, with the handle of its result for each that is shared."""
        for value in call.arguments:
            yield self._handle(cast("Shared[Any]", value)) if isinstance(value, Shared) else value

    def _handle(self, shared: Shared[Any]) -> Any:
        """Return the handle of a shared value; one that is used no longer is forgotten in time.

        A value that is forgotten while calls that need it are under way stays alive with them.
        """
        if shared not in self._shared:
            self._shared[shared] = self._start(shared)
        self._shared.move_to_end(shared)
        while len(self._shared) > self._shared_kept():
            self._shared.popitem(last=False)
        return self._shared[shared]

    def _shared_kept(self) -> int:
        return SHARED_KEPT

    @abstractmethod
    def width(self) -> int:
        """Return how many calls are computed at a time."""

    @abstractmethod
    def close(self) -> None:
        """Drop what is not completed."""

    @abstractmethod
    def _start(self, call: Call[Any]) -> Any:
        """Begin a call; return a handle of its result."""

    @abstractmethod
    def _wait(self) -> list[tuple[int, Callable[[], Any]]]:
        """Wait for calls; return for each its number and what returns its result, or raises its error."""

    @abstractmethod
    def _drop(self) -> None:
        """Drop calls that have not begun, and shared values."""


class ThreadExecutor(Executor):
    """Threads of this process, for functions that release the interpreter's lock.

    Parameters
    ----------
    threads : int, optional
        How many; by default one for each core that this process may use.

    Raises
    ------
    InputError
        A number of threads out of range.

    Examples
    --------
    >>> with ThreadExecutor(2) as executor:
    ...     list(executor.in_order(Call(pow, 2, n) for n in range(5)))
    [1, 2, 4, 8, 16]
    """

    def __init__(self, threads: int | None = None) -> None:
        super().__init__()
        self._threads = thread_count(threads)
        self._pool = ThreadPoolExecutor(self._threads)

    def width(self) -> int:
        """Return the number of threads."""
        return self._threads

    def close(self) -> None:
        """Drop what has not begun, and wait for the calls that have."""
        self._drop()
        self._pool.shutdown(wait=True, cancel_futures=True)

    def _start(self, call: Call[Any]) -> Future[Any]:
        # A call may wait for a shared value on its thread without a deadlock: threads take their work from
        # the queue in order, and there the shared value stands before the call.
        return self._pool.submit(_on_thread, call.function, tuple(self._arguments(call)))

    def _wait(self) -> list[tuple[int, Callable[[], Any]]]:
        completed = wait(self._under_way, return_when=FIRST_COMPLETED).done
        return [(self._under_way.pop(future)[0], future.result) for future in completed]

    def _drop(self) -> None:
        for future in self._under_way:
            future.cancel()
        self._under_way.clear()
        self._shared.clear()


def _on_thread(function: Callable[..., T], arguments: tuple[Any, ...]) -> T:
    return function(*(value.result() if isinstance(value, Future) else value for value in arguments))


class DaskExecutor(Executor):
    """The workers of a Dask cluster, which may come and go.

    Parameters
    ----------
    client : dask.distributed.Client
        A client of the cluster.
    notify : callable, optional
        Called with a sentence when the cluster has had no worker for a while.
    cluster_lost : str
        Id in the catalogue of what is said when the scheduler is lost; ``{reason}`` is the exception's name.
    """

    ahead = 4
    """More than for threads, as a worker's next call must have come over the network."""

    def __init__(
        self,
        client: Any,
        notify: Callable[[str], None] | None = None,
        cluster_lost: str = "common.cluster_lost",
    ) -> None:
        from dask.distributed import as_completed

        super().__init__()
        self._client, self._notify, self._cluster_lost = client, notify, cluster_lost
        self._tries: dict[int, int] = {}
        self._completed: Any = as_completed(loop=client.loop)
        self._threads, self._counted_at = 1, 0.0
        self._alone_since: float | None = None

    def width(self) -> int:
        """Return the number of the workers' threads, as it was a moment ago; 1 where there is no worker.

        Raises
        ------
        InputError
            The scheduler is lost.
        """
        now = time.monotonic()
        if now - self._counted_at > WORKERS_CHECKED_EVERY:
            with self._reaching():
                workers = self._client.scheduler_info(n_workers=-1)["workers"].values()
            self._threads = max(1, sum(worker["nthreads"] for worker in workers))
            self._counted_at = now
            self._notice_missing(bool(workers), now)
        return self._threads

    def close(self) -> None:
        """Cancel what is not completed."""
        self._drop()

    def _start(self, call: Call[Any]) -> Any:
        function = call.function
        # The name before the dash is the one under which Dask learns how long such calls take.
        key = f"{getattr(function, '__name__', 'call')}-{uuid4().hex}"
        arguments = self._arguments(call)
        with self._reaching():
            return self._client.submit(
                _on_worker, stayput.__version__, function, *arguments, key=key, pure=False
            )

    def _hand_in(self, number: int, call: Call[Any]) -> Any:
        future = super()._hand_in(number, call)
        self._completed.add(future)
        return future

    def _wait(self) -> list[tuple[int, Callable[[], Any]]]:
        while not self._completed.has_ready():
            time.sleep(POLL_INTERVAL)
            self.width()  # notices that the scheduler is lost, which would never complete a future
        results: list[tuple[int, Callable[[], Any]]] = []
        for future in self._completed.next_batch(block=False):
            # One that was dropped is reported too.
            if future in self._under_way:
                results += self._result_of(future)
        return results

    def _result_of(self, future: Any) -> list[tuple[int, Callable[[], Any]]]:
        """Return the number and the result of a completed call, or hand it in again and return nothing.

        A worker that dies takes with it the call that it computes and the results that it holds. Dask
        computes them again on other workers, and gives up a call with `KilledWorker` when several workers
        have died with it (``distributed.scheduler.allowed-failures``). Where workers come and go, the call
        may not be the cause, so it is handed in again up to `MOST_TRIES` times; and with new shared values,
        as Dask may have given up those as well.
        """
        from distributed.scheduler import KilledWorker

        number, call = self._under_way.pop(future)
        with self._reaching():
            try:
                result = future.result()
            except KilledWorker:
                self._tries[number] = self._tries.get(number, 0) + 1
                if self._tries[number] >= MOST_TRIES:
                    raise InputError("common.workers_killed", tries=MOST_TRIES) from None
                self._shared.clear()
                self._hand_in(number, call)
                return []
            finally:
                future.release()
        self._tries.pop(number, None)
        return [(number, lambda: result)]

    def _drop(self) -> None:
        futures = [*self._under_way, *self._shared.values()]
        self._under_way.clear()
        self._shared.clear()
        self._tries.clear()
        if futures:
            with suppress(Exception):  # of a cluster that is lost nothing needs to be cancelled
                self._client.cancel(futures, force=True)

    def _shared_kept(self) -> int:
        return max(SHARED_KEPT, self._threads)

    def _notice_missing(self, there: bool, now: float) -> None:
        """Tell the user once that there is no worker; it is no error, as one may come at any time."""
        if there:
            self._alone_since = None
        elif self._alone_since is None:
            self._alone_since = now
        elif self._notify is not None and now - self._alone_since > PATIENCE:
            self._notify(say("common.no_worker", language_of_bars()))
            self._alone_since = float("inf")

    @contextmanager
    def _reaching(self) -> Generator[None]:
        """Turn what a client raises when its scheduler is lost into an `InputError`."""
        from distributed.client import FutureCancelledError
        from distributed.comm.core import CommClosedError

        lost = CancelledError, FutureCancelledError, CommClosedError, TimeoutError, OSError
        try:
            yield
        except InputError:
            raise
        except Exception as error:
            # A call may raise what it likes as long as the client is connected.
            if not isinstance(error, lost) and self._client.status == "running":
                raise
            raise InputError(self._cluster_lost, reason=type(error).__name__) from error


def _on_worker(version: str, function: Callable[..., T], *arguments: Any) -> T:
    """Compute a call on a worker, where Dask has put the results of shared calls in place.

    Raises
    ------
    InputError
        The worker has another version of stayput, whose results may be others.
    """
    if version != stayput.__version__:
        raise InputError("common.worker_version", worker=stayput.__version__, version=version)
    return function(*arguments)
