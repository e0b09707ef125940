"""Jobs: verifications in the background, with their progress; each can be cancelled at any time.

Where there are several they go on by turns, which change where a job notes its progress: so a long job does
not keep a short one waiting. Threads and turns are shared among clients: a client is a page at an address;
the header `CLIENT_HEADER` says which of the pages there it is.
"""

from __future__ import annotations

import asyncio
import logging
import secrets
import threading
import time
from collections import Counter
from collections.abc import Callable, Collection
from concurrent.futures import ThreadPoolExecutor
from contextvars import ContextVar
from dataclasses import dataclass, field
from operator import itemgetter
from typing import TYPE_CHECKING, Literal, NamedTuple, ParamSpec, Protocol, TypeVar
from weakref import WeakValueDictionary

from stayput.app.messages import RefusedError, refused, unprinted
from stayput.errors import InputError
from stayput.execution import Stop

if TYPE_CHECKING:
    from stayput.app.limits import Limits
    from stayput.scenario import Scenario
    from stayput.verification import Verdict

    JobWork = Callable[..., Verdict]


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

    def in_order(self) -> list[Turn]:
        """Return the queue as it is served: the first turn of each address, then the second of each, ..."""
        earlier: Counter[str] = Counter()
        ranks: list[int] = []
        for turn in self.queue:
            ranks.append(earlier[turn.address])
            earlier[turn.address] += 1
        return [turn for _, turn in sorted(zip(ranks, self.queue, strict=True), key=itemgetter(0))]


class Turn:
    """The place of some work among the others; within ``with`` it has its turn.

    Parameters
    ----------
    turns : Turns
        The others.
    wanted : callable
        Returns whether the work is to go on.
    address : str
        Whose work it is; an address with much of it waits no less than one with little.
    """

    def __init__(self, turns: Turns, wanted: Callable[[], bool], address: str) -> None:
        self._turns, self._wanted, self._began = turns, wanted, 0.0
        self.address = address
        with turns.changed:
            turns.queue.append(self)

    def __enter__(self) -> Turn:
        """Wait for the turn; raise `StoppedError` where the work is no longer wanted."""
        turns = self._turns
        with turns.changed:
            while self._wanted() and self not in turns.in_order()[: turns.at_once]:
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
        with self._turns.changed:
            order = self._turns.in_order()
        return order.index(self) if self in order else None


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
        self._own: WeakValueDictionary[Client | str, asyncio.Semaphore] = WeakValueDictionary()
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
        of_page = self._own.setdefault(client, asyncio.Semaphore(self._threads))
        # A page can invent its name, not its address: all pages of an address together wait like one.
        of_address = self._own.setdefault(client.address, asyncio.Semaphore(self._threads))
        try:
            async with of_page, of_address, self._free:
                return await asyncio.get_running_loop().run_in_executor(self._pool, quietly)
        except MemoryError:
            raise refused(503, "app.little_memory") from None
        finally:
            self.asking -= Counter([client.address])

    def close(self) -> None:
        """Shut the threads down; work that has not begun is dropped."""
        self._pool.shutdown(wait=False, cancel_futures=True)


JobState = Literal["waiting", "running", "done", "cancelled", "failed"]
_log = logging.getLogger("stayput.app")


@dataclass(slots=True, eq=False)
class Job:
    """A verification.

    Attributes
    ----------
    id : str
        Its name; nobody can guess it.
    state : str
        Where it stands.
    done, total : int
        Simulations done, and in all.
    client : Client
        Who has asked for it.
    motions : frozenset of str
        The uploaded motions that it reads.
    verdict : Verdict or None
        Its result; while it runs, as far as it is known.
    error : InputError or None
        Why it failed.
    lease : float or None
        How long it goes on without being asked for [s]; None: to its end.
    reports : dict of bytes
        Pages that were made of the verdict, by their names.
    plan_runs : dict of int
        Runs made for plans to buy and do, by what the home is like.
    before : Scenario or None
        The room before the changes that are tried in it, where some are.
    """

    id: str
    total: int
    client: Client
    motions: frozenset[str] = frozenset()
    lease: float | None = None
    state: JobState = "waiting"
    done: int = 0
    verdict: Verdict | None = None
    error: InputError | None = None
    began: float = field(default_factory=time.monotonic)
    ended: float | None = None
    last_used: float = field(default_factory=time.monotonic)
    reports: dict[str, bytes] = field(default_factory=dict[str, bytes])
    plan_runs: dict[str, int] = field(default_factory=dict[str, int])
    before: Scenario | None = None
    stop: Stop = field(default_factory=Stop)
    turn: Turn = field(init=False)

    @property
    def seconds(self) -> float:
        """How long it has taken since it was asked for [s]."""
        return (time.monotonic() if self.ended is None else self.ended) - self.began

    @property
    def position(self) -> int | None:
        """How many have their turn before it; None once it has begun."""
        return self.turn.position if self.state == "waiting" else None

    @property
    def wanted(self) -> bool:
        """Whether it is to go on: it is not cancelled, and its lease has not run out."""
        abandoned = self.lease is not None and time.monotonic() - self.last_used > self.lease
        return not (abandoned or self.stop.is_set())


class Jobs:
    """All jobs: running, waiting, or ended and kept for a while.

    Parameters
    ----------
    limits : Limits
        How many.
    turns : Turns
        Among which they go on.
    """

    def __init__(self, limits: Limits, turns: Turns) -> None:
        self._limits = limits
        self._jobs: dict[str, Job] = {}
        self._lock = threading.RLock()
        self._turns = turns

    def start(
        self,
        work: JobWork,
        total: int,
        motions: frozenset[str] = frozenset(),
        lease: float | None = None,
        before: Scenario | None = None,
    ) -> Job:
        """Begin a job, now or when it is its turn.

        Parameters
        ----------
        work : callable
            Does it; called with ``on_progress``, which takes its progress, waits there for the job's turn,
            and raises when it is to stop, and with ``on_verdict``, which takes what is known of the verdict.
        total : int
            About how many simulations there are.
        motions : frozenset of str
            The uploaded motions that it reads.
        lease : float, optional
            How long it goes on without being asked for [s].
        before : Scenario, optional
            The room before the changes that are tried in it.

        Raises
        ------
        RefusedError
            Too many jobs already, of all, of this address or of this page.
        """
        client, limits = CLIENT.get(), self._limits
        with self._lock:
            self._expire()
            active = [job for job in self._jobs.values() if job.ended is None]
            from_address = [job for job in active if job.client.address == client.address]
            if (
                len(active) >= limits.jobs_running + limits.jobs_waiting
                or len(from_address) >= limits.jobs_per_address
                or sum(job.client == client for job in from_address) >= limits.jobs_per_page
            ):
                raise refused(429, "app.many_jobs", retry_after=10, count=len(active))
            job = Job(secrets.token_hex(16), total, client, motions, lease, before=before)
            self._jobs[job.id] = job
            job.turn = Turn(self._turns, lambda: job.wanted, client.address)
        threading.Thread(target=self._run, args=(job, work), name="stayput-job").start()
        return job

    def motions(self) -> set[str]:
        """Return the uploaded motions that jobs at work or waiting read."""
        with self._lock:
            active = [job.motions for job in self._jobs.values() if job.ended is None]
        return set[str]().union(*active)

    def get(self, name: str) -> Job:
        """Return a job.

        Raises
        ------
        RefusedError
            There is none of this name.
        """
        with self._lock:
            self._expire()
            job = self._jobs.get(name)
        if job is None:
            raise refused(404, "app.no_such_id")
        job.last_used = time.monotonic()
        return job

    def cancel(self, name: str) -> Job:
        """Stop a job, or forget one that has ended.

        Raises
        ------
        RefusedError
            There is none of this name.
        """
        job = self.get(name)
        with self._lock:
            if job.ended is None:
                self._cancel(job)
            else:
                self._jobs.pop(name, None)
        return job

    def close(self) -> None:
        """Stop all jobs."""
        with self._lock:
            for job in self._jobs.values():
                self._cancel(job)

    def _run(self, job: Job, work: JobWork) -> None:
        def note_verdict(verdict: Verdict) -> None:
            with self._lock:
                if job.ended is None:
                    job.verdict = verdict

        def note_progress(done: int, total: int) -> None:
            job.done, job.total = done, total
            job.turn.go_on()

        try:
            with job.turn, unprinted(), job.stop.ending_runs():
                with self._lock:
                    if job.ended is None:
                        job.state = "running"
                verdict = work(on_progress=note_progress, on_verdict=note_verdict)
        except StoppedError:
            self._end(job, "cancelled")
        except (RefusedError, InputError) as error:
            self._end(job, "failed", error=error.error if isinstance(error, RefusedError) else error)
        except Exception:
            if job.stop.is_set():  # the server ends, and with it what the job works with
                self._end(job, "cancelled")
                return
            _log.exception("A verification failed")
            self._end(job, "failed", error=InputError("app.failed"))
        else:
            self._end(job, "done", verdict=verdict)

    def _end(
        self, job: Job, state: JobState, verdict: Verdict | None = None, error: InputError | None = None
    ) -> None:
        """Let a job's thread go; a job that was cancelled meanwhile stays so."""
        with self._lock:
            if job.ended is None:
                job.verdict, job.error, job.ended = verdict, error, time.monotonic()
                job.state = state

    def _cancel(self, job: Job) -> None:
        """Let a job be cancelled, where it has not ended."""
        job.stop.set()
        job.turn.leave()
        self._end(job, "cancelled")

    def _expire(self) -> None:
        """Cancel abandoned jobs; forget those that ended long ago, and of too many those of who has most."""
        now = time.monotonic()
        for job in list(self._jobs.values()):
            if job.ended is None and not job.wanted:
                self._cancel(job)
            elif job.ended is not None and now - job.last_used > self._limits.keep:
                del self._jobs[job.id]
        while len(self._jobs) > self._limits.jobs_kept and (
            ended := [job for job in self._jobs.values() if job.ended is not None]
        ):
            del self._jobs[first_to_go(ended).id]
