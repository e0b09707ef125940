"""Who asks, and whose turn it is: threads and long work are shared among clients.

A client is a page at an address; the header `CLIENT_HEADER` says which of the pages there it is.
"""

from __future__ import annotations

import asyncio
import threading
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from contextvars import ContextVar
from typing import TYPE_CHECKING, NamedTuple, ParamSpec, Protocol, TypeVar
from weakref import WeakValueDictionary

from stayput.app.refusals import refused, unprinted

if TYPE_CHECKING:
    from collections.abc import Callable, Collection

P = ParamSpec("P")
T = TypeVar("T")

CLIENT_HEADER = "x-stayput-client"
"""Header in which a page says which of the pages at its address it is."""

SLICE = 0.5
"""How long work goes on while other work waits [s]."""

CHECK_INTERVAL = 1.0
"""How often work that waits for its turn looks whether it is wanted [s]."""


class Client(NamedTuple):
    """Who asks."""

    address: str
    page: str


NOBODY = Client("", "")
"""Who asks where that is not known."""

CLIENT: ContextVar[Client] = ContextVar("client", default=NOBODY)
"""Who has sent the request that is being answered."""


class OfClient(Protocol):
    """Something that is kept for a client."""

    client: Client
    last_used: float


AnyOfClient = TypeVar("AnyOfClient", bound=OfClient)


def first_to_go(kept: Collection[AnyOfClient]) -> AnyOfClient:
    """Return what goes where too much is kept: the oldest of the page with most, at the address with most."""
    of_address = Counter(item.client.address for item in kept)
    of_page = Counter(item.client for item in kept)
    return max(kept, key=lambda x: (of_address[x.client.address], of_page[x.client], -x.last_used))


class StoppedError(Exception):
    """Raised within work that is no longer wanted."""


class Turns:
    """Long work, of which some goes on and the rest waits for its turn.

    Parameters
    ----------
    at_once : int
        How many go on at a time.
    """

    def __init__(self, at_once: int) -> None:
        self.at_once = at_once
        self.queue: list[Turn] = []
        self.changed = threading.Condition()


class Turn:
    """The place of some work among the others; within ``with`` it has its turn.

    Parameters
    ----------
    turns : Turns
        The others.
    wanted : callable
        Returns whether the work is to go on.
    """

    def __init__(self, turns: Turns, wanted: Callable[[], bool]) -> None:
        self._turns, self._wanted, self._began = turns, wanted, 0.0
        with turns.changed:
            turns.queue.append(self)

    def __enter__(self) -> Turn:
        """Wait for the turn; raise `StoppedError` where the work is no longer wanted."""
        turns = self._turns
        with turns.changed:
            while self._wanted() and self not in turns.queue[: turns.at_once]:
                turns.changed.wait(CHECK_INTERVAL)
        if not self._wanted():
            self.leave()
            raise StoppedError
        self._began = time.monotonic()
        return self

    def __exit__(self, *_: object) -> None:
        self.leave()

    def go_on(self) -> None:
        """Let others go on, where some wait and this work has had its slice; raises as ``with`` does."""
        if not self._wanted():
            raise StoppedError
        turns = self._turns
        if time.monotonic() - self._began >= SLICE and len(turns.queue) > turns.at_once:
            with turns.changed:
                self.leave()
                turns.queue.append(self)
            self.__enter__()

    def leave(self) -> None:
        """Give up the place; nothing happens where that has been done."""
        with self._turns.changed:
            if self in self._turns.queue:
                self._turns.queue.remove(self)
            self._turns.changed.notify_all()

    @property
    def position(self) -> int | None:
        """How many have their turn before this work; None where it has no place."""
        queue = self._turns.queue.copy()
        return queue.index(self) if self in queue else None


class Workers:
    """A bounded pool of threads that compute, off the event loop; no client keeps others waiting for long.

    Parameters
    ----------
    threads : int
        How many threads; a client has no more in use or next in the queue.
    waiting : int
        How many requests may wait for one; half of the places are for other addresses.
    """

    def __init__(self, threads: int, waiting: int) -> None:
        self._pool = ThreadPoolExecutor(threads, "stayput-worker")
        self._threads, self._waiting = threads, waiting
        self._free = asyncio.Semaphore(threads)
        self._own: WeakValueDictionary[Client, asyncio.Semaphore] = WeakValueDictionary()
        self.asking: Counter[str] = Counter()
        """Requests at work or waiting, by their addresses."""

    async def run(self, work: Callable[P, T], *args: P.args, **kwargs: P.kwargs) -> T:
        """Do some work on a thread.

        Raises
        ------
        RefusedError
            Too much is waiting.
        """

        def quietly() -> T:
            with unprinted():
                return work(*args, **kwargs)

        client = CLIENT.get()
        others = self._threads + self._waiting // 2
        if self.asking.total() >= self._threads + self._waiting or self.asking[client.address] > others:
            raise refused(503, "app.busy", retry_after=2)
        self.asking[client.address] += 1
        of_client = self._own.setdefault(client, asyncio.Semaphore(self._threads))
        try:
            async with of_client, self._free:
                return await asyncio.get_running_loop().run_in_executor(self._pool, quietly)
        except MemoryError:
            raise refused(503, "app.little_memory") from None
        finally:
            self.asking -= Counter([client.address])

    def close(self) -> None:
        """Shut the threads down; work that has not begun is dropped."""
        self._pool.shutdown(wait=False, cancel_futures=True)
