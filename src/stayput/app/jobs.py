"""Jobs: verifications in the background, with their progress; each can be cancelled at any time.

Where there are several they go on by turns, which change where a job notes its progress: so a long job does
not keep a short one waiting.
"""

from __future__ import annotations

import logging
import secrets
import threading
import time
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

from stayput.app.refusals import RefusedError, refused, unprinted
from stayput.app.turns import CLIENT, Client, StoppedError, Turn, Turns, first_to_go
from stayput.errors import InputError
from stayput.execution import Stop

if TYPE_CHECKING:
    from collections.abc import Callable

    from stayput.app.limits import Limits
    from stayput.scenario import Scenario
    from stayput.verification import Verdict

    JobWork = Callable[..., Verdict]

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
            job.turn = Turn(self._turns, lambda: job.wanted)
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
