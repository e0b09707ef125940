"""Who does the tasks: threads of this process, or the workers of a Dask cluster."""

from __future__ import annotations

import time
from collections import OrderedDict
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import stayput
from stayput.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterator

    from stayput.inventory.floors import Floor, Ground
    from stayput.inventory.work import Done, Shaken, Task

BUILDINGS = 3
"""Buildings whose floors are kept on threads: those of tasks under way and the next."""

TRIES = 10
"""Times that a task may take its worker with it before that is taken for its own fault."""

LOOK_AGAIN = 2.0
"""Seconds after which the number of workers is asked for anew."""

POLL = 0.01
"""Seconds between looks whether a task is done; a task takes about one."""

PATIENCE = 10.0
"""Seconds without any worker after which it is said that one is waited for."""


class Threads:
    """Threads of this process.

    Parameters
    ----------
    threads : int
        How many.
    ground : callable
        Gives the motions of a scenario.
    """

    def __init__(self, threads: int, ground: Callable[[int], Ground]) -> None:
        self.threads, self.ground = threads, ground
        self.pool = ThreadPoolExecutor(threads)
        self.floors: OrderedDict[Shaken, Future[dict[int, Floor]]] = OrderedDict()
        self.tasks: set[Future[Done]] = set()

    def width(self) -> int:
        """Return the number of threads."""
        return self.threads

    def waiting(self) -> int:
        """Return how many tasks are not done."""
        return len(self.tasks)

    def hand_in(self, task: Task) -> None:
        """Take a task; its floors stand before it in the queue, so no thread waits for them in vain."""
        shaken = task.shaken
        if shaken not in self.floors:
            self.floors[shaken] = self.pool.submit(shaken.floors, self.ground(shaken.station))
            if len(self.floors) > BUILDINGS:
                self.floors.popitem(last=False)
        floors = self.floors[shaken]
        self.tasks.add(self.pool.submit(lambda: task.run(floors.result())))

    def done(self) -> Iterator[Done]:
        """Give what is done."""
        finished, self.tasks = wait(self.tasks, return_when=FIRST_COMPLETED)
        for future in finished:
            yield future.result()

    def close(self) -> None:
        """End the threads; tasks under way, a moment's work, are waited for."""
        self.pool.shutdown(wait=True, cancel_futures=True)


def same_version(version: str) -> None:
    """Refuse a worker that has another version.

    Raises
    ------
    InputError
        It has.
    """
    if version != stayput.__version__:
        raise InputError(
            f"A worker has stayput {stayput.__version__}; it must have that of this command, {version}."
        )


def run_task(task: Task, floors: dict[int, Floor], version: str) -> Done:
    """Run a task on a worker."""
    same_version(version)
    return task.run(floors)


def make_floors(shaken: Shaken, ground: Ground) -> dict[int, Floor]:
    """Make the floors of a building on a worker."""
    return shaken.floors(ground)


def as_it_is(value: Any) -> Any:
    """Return a value: as a task of its own it is sent once, and made again where its worker is lost."""
    return value


class Cluster:
    """The workers of a Dask cluster, which may come and go.

    The motions of the ground and the floors of each building are tasks of their own: they are sent or
    computed once, kept on the workers, and handed between them.

    Parameters
    ----------
    client : dask.distributed.Client
        The way to them.
    ground : callable
        Gives the motions of a scenario.
    say : callable, optional
        Told when there is no worker.
    """

    def __init__(
        self, client: Any, ground: Callable[[int], Ground], say: Callable[[str], None] | None = None
    ) -> None:
        from dask.distributed import as_completed

        self.client, self.ground, self.say = client, ground, say
        self.grounds: dict[int, Any] = {}
        self.floors: OrderedDict[Shaken, Any] = OrderedDict()
        self.tasks: dict[Any, Task] = {}
        self.tries: dict[Task, int] = {}
        self.finished: Any = as_completed(loop=client.loop)
        self.seen_at, self.threads = 0.0, 1
        self.alone_since: float | None = None

    def width(self) -> int:
        """Return the number of the workers' threads, as it was a moment ago; 1 where there is none.

        Raises
        ------
        InputError
            The scheduler is gone.
        """
        if time.monotonic() - self.seen_at > LOOK_AGAIN:
            with self._reached():
                workers = self.client.scheduler_info(n_workers=-1)["workers"].values()
            self.threads = max(1, sum(worker["nthreads"] for worker in workers))
            self.seen_at = time.monotonic()
            self._miss(bool(workers))
        return self.threads

    def _miss(self, there: bool) -> None:
        """Say once that there is no worker; one may come at any time, so that it is no error."""
        if there:
            self.alone_since = None
        elif self.alone_since is None:
            self.alone_since = self.seen_at
        elif self.say is not None and self.seen_at - self.alone_since > PATIENCE:
            self.say("The cluster has no worker; waiting for one.")
            self.alone_since = float("inf")

    @contextmanager
    def _reached(self) -> Generator[None]:
        """Turn what a client says of a scheduler that is gone into a sentence."""
        from concurrent.futures import CancelledError

        from distributed.client import FutureCancelledError
        from distributed.comm.core import CommClosedError

        gone = CancelledError, FutureCancelledError, CommClosedError, TimeoutError, OSError
        try:
            yield
        except Exception as error:
            if not isinstance(error, gone) and self.client.status == "running":
                raise
            raise InputError(
                f"The cluster is gone ({type(error).__name__}); what is complete is kept, and the same "
                "command goes on from it."
            ) from error

    def waiting(self) -> int:
        """Return how many tasks are not done."""
        return len(self.tasks)

    def hand_in(self, task: Task) -> None:
        """Take a task."""
        with self._reached():
            floors = self._floors(task.shaken)
            future = self.client.submit(run_task, task, floors, stayput.__version__, pure=False)
        self.tasks[future] = task
        self.finished.add(future)

    def _floors(self, shaken: Shaken) -> Any:
        if shaken not in self.floors:
            if shaken.station not in self.grounds:
                ground = self.ground(shaken.station)
                self.grounds[shaken.station] = self.client.submit(as_it_is, ground, pure=False)
            ground = self.grounds[shaken.station]
            self.floors[shaken] = self.client.submit(make_floors, shaken, ground, pure=False)
            if len(self.floors) > max(BUILDINGS, self.threads):
                self.floors.popitem(last=False)
        return self.floors[shaken]

    def done(self) -> Iterator[Done]:
        """Give what is done; what was lost with its worker too often is handed in anew.

        Raises
        ------
        InputError
            The scheduler is gone, or a task ends every worker that it is given to.
        """
        from distributed.scheduler import KilledWorker

        while not self.finished.has_ready():
            time.sleep(POLL)
            self.width()
        future = next(self.finished)
        task = self.tasks.pop(future)
        with self._reached():
            try:
                found: Done | None = future.result()
            except KilledWorker:
                found = None
            future.release()
        if found is not None:
            self.tries.pop(task, None)
            yield found
            return
        self.tries[task] = self.tries.get(task, 0) + 1
        if self.tries[task] >= TRIES:
            raise InputError(f"A task ended {TRIES} times with its workers; they may need more memory.")
        self.floors.clear()
        self.grounds.clear()
        self.hand_in(task)

    def close(self) -> None:
        """Drop what is not done."""
        import contextlib

        with contextlib.suppress(Exception):  # a cluster that is gone needs no telling
            self.client.cancel(list(self.tasks), force=True)
        self.tasks.clear()
        self.floors.clear()
        self.grounds.clear()
