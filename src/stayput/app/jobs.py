"""Jobs: verifications in the background, with their progress; each can be cancelled at any time."""

from __future__ import annotations

import logging
import secrets
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

from stayput.app.refusals import RefusedError, refused
from stayput.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Callable

    from stayput.app.limits import Limits
    from stayput.verification import Verdict

JobState = Literal["waiting", "running", "done", "cancelled", "failed"]
_log = logging.getLogger("stayput.app")


class StoppedError(Exception):
    """Raised within a job that is to stop."""


@dataclass(slots=True)
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
    motions : frozenset of str
        The uploaded motions that it reads.
    verdict : Verdict or None
        Its result.
    error : InputError or None
        Why it failed.
    lease : float or None
        How long it goes on without being asked for [s]; None: to its end.
    """

    id: str
    total: int
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
    stop: threading.Event = field(default_factory=threading.Event)

    @property
    def seconds(self) -> float:
        """How long it has taken since it was asked for [s]."""
        return (time.monotonic() if self.ended is None else self.ended) - self.began

    @property
    def wanted(self) -> bool:
        """Whether it is to go on: it is not cancelled, and its lease has not run out."""
        abandoned = self.lease is not None and time.monotonic() - self.last_used > self.lease
        return not (abandoned or self.stop.is_set())

    def note_progress(self, done: int, total: int) -> None:
        """Note how many simulations are done.

        Raises
        ------
        StoppedError
            It is no longer wanted.
        """
        if not self.wanted:
            raise StoppedError
        self.done, self.total = done, total


class Jobs:
    """All jobs: running, waiting, or ended and kept for a while.

    Parameters
    ----------
    limits : Limits
        How many.
    """

    def __init__(self, limits: Limits) -> None:
        self._limits = limits
        self._pool = ThreadPoolExecutor(limits.jobs_running, "stayput-job")
        self._jobs: dict[str, Job] = {}
        self._lock = threading.Lock()

    def start(
        self,
        work: Callable[[Callable[[int, int], None]], Verdict],
        total: int,
        motions: frozenset[str] = frozenset(),
        lease: float | None = None,
    ) -> Job:
        """Begin a job, now or when a thread is free.

        Parameters
        ----------
        work : callable
            Does it; called with a function that takes its progress, and raises when it is to stop.
        total : int
            About how many simulations there are.
        motions : frozenset of str
            The uploaded motions that it reads.
        lease : float, optional
            How long it goes on without being asked for [s].

        Raises
        ------
        RefusedError
            Too many jobs already.
        """
        with self._lock:
            self._expire()
            active = sum(job.state in ("waiting", "running") for job in self._jobs.values())
            if active >= self._limits.jobs_running + self._limits.jobs_waiting:
                raise refused(429, "app.many_jobs", retry_after=10, count=active)
            job = Job(secrets.token_hex(16), total, motions, lease)
            self._jobs[job.id] = job
        self._pool.submit(self._run, job, work)
        return job

    def motions(self) -> set[str]:
        """Return the uploaded motions that jobs at work or waiting read."""
        with self._lock:
            active = [job.motions for job in self._jobs.values() if job.state in ("waiting", "running")]
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
            raise refused(404, "app.no_such_job")
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
        job.stop.set()
        with self._lock:
            if job.state in ("waiting", "running"):
                self._cancel(job)
            else:
                self._jobs.pop(name, None)
        return job

    def close(self) -> None:
        """Stop all jobs."""
        with self._lock:
            for job in self._jobs.values():
                job.stop.set()
        self._pool.shutdown(wait=False, cancel_futures=True)

    def _run(self, job: Job, work: Callable[[Callable[[int, int], None]], Verdict]) -> None:
        with self._lock:
            if not job.wanted:
                self._cancel(job)
                return
            job.state = "running"
        try:
            verdict = work(job.note_progress)
        except StoppedError:
            self._end(job, "cancelled")
        except RefusedError as refusal:
            job.error = refusal.error
            self._end(job, "failed")
        except InputError as error:
            job.error = error
            self._end(job, "failed")
        except Exception:
            if job.stop.is_set():  # the server ends, and with it what the job works with
                self._end(job, "cancelled")
                return
            _log.exception("A verification failed")
            job.error = InputError("app.verification_failed")
            self._end(job, "failed")
        else:
            job.verdict = verdict
            self._end(job, "done")

    def _end(self, job: Job, state: JobState) -> None:
        with self._lock:
            if job.state == "running":
                job.state, job.ended = state, time.monotonic()

    @staticmethod
    def _cancel(job: Job) -> None:
        """Mark a job that has not ended as cancelled."""
        job.stop.set()
        if job.ended is None:
            job.state, job.ended = "cancelled", time.monotonic()

    def _expire(self) -> None:
        """Cancel abandoned jobs; forget those that ended long ago, and the oldest of too many."""
        now = time.monotonic()
        for job in self._jobs.values():
            if job.ended is None and not job.wanted:
                self._cancel(job)
        ended = [job for job in self._jobs.values() if job.ended is not None]
        surplus = len(self._jobs) - self._limits.jobs_kept
        for place, job in enumerate(sorted(ended, key=lambda job: job.last_used)):
            if place < surplus or now - job.last_used > self._limits.keep:
                del self._jobs[job.id]
