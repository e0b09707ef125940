"""A Dask cluster of two processes for tests, and the death of one of them."""

from __future__ import annotations

import contextlib
import os
import signal
import time
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable, Generator
    from concurrent.futures import Future

WORKERS = 2

WAIT = 180.0
"""So long may a worker take to come back, on a machine that has much else to do [s]."""

_KILLER = ThreadPoolExecutor(1)


@contextlib.contextmanager
def two_processes() -> Generator[Any]:
    """A client of a cluster of two worker processes of one thread, each watched by a nanny."""
    import dask
    from dask.distributed import Client, LocalCluster

    with (
        dask.config.set({"distributed.deploy.lost-worker-timeout": WAIT}),  # else given up after 15 s
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

    _wait_for(there)
    return _alive(client)


def killed_when(client: Any, victim: int, ready: Callable[[], bool]) -> Future[None]:
    """Kill a worker as soon as something is so; the result is there when its nanny has seen it."""

    def kill() -> None:
        _wait_for(ready)
        os.kill(victim, signal.SIGKILL)
        _wait_for(lambda: victim not in _alive(client).values())

    return _KILLER.submit(kill)


def _wait_for(there: Callable[[], bool]) -> None:
    until = time.monotonic() + WAIT
    while not there():
        assert time.monotonic() < until
        time.sleep(0.005)
