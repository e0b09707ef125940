"""A Dask cluster of two processes for tests, and the death of one of them."""

from __future__ import annotations

import contextlib
import os
import signal
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

import forks

from waiting import PATIENCE, wait_until

if TYPE_CHECKING:
    from collections.abc import Callable, Generator

WORKERS = 2

_KILLER = ThreadPoolExecutor(1)


@contextlib.contextmanager
def two_processes() -> Generator[Any]:
    """A client of a cluster of two worker processes of one thread, each watched by a nanny.

    The processes are forked, for speed, by a server that has the package loaded.
    """
    import dask
    from dask.distributed import Client, LocalCluster

    forks.context()
    settings = {
        "distributed.deploy.lost-worker-timeout": PATIENCE,  # else given up after 15 s
        "distributed.worker.multiprocessing-method": forks.METHOD,
    }
    with (
        dask.config.set(settings),
        LocalCluster(
            n_workers=WORKERS, threads_per_worker=1, dashboard_address=None, host="127.0.0.1"
        ) as cluster,
        Client(cluster, set_as_default=False) as client,
    ):
        yield client


def _alive(client: Any) -> dict[str, int]:
    """Addresses and process ids of the workers, as their nannies know them.

    One that is only starting is left out: a nanny whose worker is killed then gives up.
    """
    processes = [nanny.process for nanny in client.cluster.workers.values() if nanny.process is not None]
    return {
        process.worker_address: pid
        for process in processes
        if process.status.name == "running" and (pid := process.pid) is not None
    }


def workers(client: Any) -> dict[str, int]:
    """Addresses and process ids of the workers, when all of them are really there.

    A worker that was killed a moment ago may still be known to the scheduler, and one that its nanny starts
    anew may not be known yet, so none of them is asked itself.
    """

    def there() -> bool:
        found = _alive(client)
        return len(found) == WORKERS and set(client.scheduler_info(n_workers=-1)["workers"]) == set(found)

    wait_until(there)
    return _alive(client)


@contextlib.contextmanager
def killed_when(client: Any, victim: int, ready: Callable[[], bool]) -> Generator[None]:
    """Kill a worker as soon as something is so, at the latest as the block ends, and wait for its death."""
    over = threading.Event()

    def kill() -> None:
        wait_until(lambda: over.is_set() or ready(), every=0.005)
        os.kill(victim, signal.SIGKILL)
        wait_until(lambda: victim not in _alive(client).values())

    death = _KILLER.submit(kill)
    try:
        yield
    finally:
        over.set()
        death.result()  # its nanny has seen it
