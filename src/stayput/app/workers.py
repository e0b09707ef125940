"""Threads for what computes: never on the event loop, and never more at a time than was allowed."""

from __future__ import annotations

import asyncio
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, ParamSpec, TypeVar

from stayput.app.refusals import RefusedError, refused
from stayput.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Callable

P = ParamSpec("P")
T = TypeVar("T")


class Workers:
    """A bounded pool of threads.

    Parameters
    ----------
    threads : int
        How many threads.
    waiting : int
        How many requests may wait for one.
    """

    def __init__(self, threads: int, waiting: int) -> None:
        self._pool = ThreadPoolExecutor(threads, "stayput-worker")
        self._most = threads + waiting
        self._busy = 0

    async def run(self, work: Callable[P, T], *args: P.args, **kwargs: P.kwargs) -> T:
        """Do some work on a thread.

        Raises
        ------
        RefusedError
            Too much is waiting, or the input is refused.
        """
        if self._busy >= self._most:
            raise refused(503, "app.busy", retry_after=2)
        self._busy += 1
        try:
            return await asyncio.get_running_loop().run_in_executor(self._pool, lambda: work(*args, **kwargs))
        except InputError as error:
            raise RefusedError(422, error.about(None)) from None
        except MemoryError:
            raise refused(503, "app.little_memory") from None
        finally:
            self._busy -= 1

    def close(self) -> None:
        """Let the threads go; what waits is dropped."""
        self._pool.shutdown(wait=False, cancel_futures=True)
