"""Shared by the routes: the server's state, threads for work, and JSON responses."""

from __future__ import annotations

import asyncio
import threading
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

from starlette.responses import Response

from stayput.app.jobs import StoppedError
from stayput.app.refusals import RefusedError, refused, unprinted
from stayput.app.replies import Problem, Reply
from stayput.app.scenes import (
    read_pieces,
    read_room_scene,
    read_scene,
    several_pieces,
    uploaded_motions,
)
from stayput.app.turns import CLIENT, Turns
from stayput.app.verification import job_reply
from stayput.errors import InputError
from stayput.rooms.verdict import RoomVerdict

if TYPE_CHECKING:
    from collections.abc import Callable

    from starlette.requests import Request

    from stayput.app.jobs import AnyVerdict, Job, Jobs, JobWork
    from stayput.app.limits import Limits
    from stayput.app.motions import Motions
    from stayput.app.readers import ReaderPool
    from stayput.app.verdict_replies import JobReply
    from stayput.scenario import AssemblyScenario, Scenario
    from stayput.scenario.room import RoomScenario
    from stayput.verification import Verdict

POLL_INTERVAL = 0.5
"""How often a long request checks whether its client has left [s]."""

P = ParamSpec("P")
T = TypeVar("T")


class Workers:
    """A bounded pool of threads that compute, off the event loop; where clients wait, they take turns.

    Parameters
    ----------
    threads : int
        How many threads.
    waiting : int
        How many requests may wait for one.
    """

    def __init__(self, threads: int, waiting: int) -> None:
        self._pool = ThreadPoolExecutor(threads, "stayput-worker")
        self._free, self._most = threads, waiting
        self.waiting: Turns[asyncio.Future[None]] = Turns()

    async def run(self, work: Callable[P, T], *args: P.args, **kwargs: P.kwargs) -> T:
        """Do some work on a thread.

        Raises
        ------
        RefusedError
            Too much is waiting, or the input is refused.
        """

        def quietly() -> T:
            with unprinted():
                return work(*args, **kwargs)

        await self._turn()
        try:
            return await asyncio.get_running_loop().run_in_executor(self._pool, quietly)
        except InputError as error:
            raise RefusedError(422, error.about(None)) from None
        except MemoryError:
            raise refused(503, "app.little_memory") from None
        finally:
            self._next()

    async def _turn(self) -> None:
        """Wait for a free thread."""
        if self._free and not len(self.waiting):
            self._free -= 1
            return
        client = CLIENT.get()
        # half of the places are for other addresses
        if len(self.waiting) >= self._most or self.waiting.of_address(client.address) > self._most // 2:
            raise refused(503, "app.busy", retry_after=2)
        turn: asyncio.Future[None] = asyncio.get_running_loop().create_future()
        self.waiting.add(client, turn)
        try:
            await turn
        except asyncio.CancelledError:
            if turn.done() and not turn.cancelled():
                self._next()
            self.waiting.remove(turn)
            raise

    def _next(self) -> None:
        """Give a thread that has become free to whose turn it is."""
        while (turn := self.waiting.take()) is not None:
            if not turn.done():
                turn.set_result(None)
                return
        self._free += 1

    def close(self) -> None:
        """Shut the threads down; work that has not begun is dropped."""
        self._pool.shutdown(wait=False, cancel_futures=True)


def problems(*statuses: int) -> dict[int | str, dict[str, Any]]:
    """Return the entries of refusals in the description of the API."""
    words = {
        400: "The body is not JSON.",
        404: "There is none of this id.",
        409: "The job is not done, or one needs this.",
        413: "The body is too large.",
        422: "The input is refused.",
        429: "There are too many already.",
        503: "The server is busy.",
    }
    return {status: {"model": Problem, "description": words[status]} for status in statuses}


@dataclass(slots=True)
class Service:
    """State of the server that the routes share.

    Attributes
    ----------
    limits : Limits
        What is accepted.
    workers, slow, planners : Workers
        Threads that compute: what is short, what is not, and plans to buy and do, which take longest.
    readers : ReaderPool
        Processes that read uploads.
    motions : Motions
        What was uploaded.
    jobs : Jobs
        Verifications.
    ready : bool
        Whether everything is compiled.
    closed : bool
        Whether the server ends.
    """

    limits: Limits
    workers: Workers
    slow: Workers
    planners: Workers
    readers: ReaderPool
    motions: Motions
    jobs: Jobs
    ready: bool = False
    closed: bool = False

    def close(self) -> None:
        """Stop all jobs, let the threads go, and remove the folder."""
        self.closed = True
        self.jobs.close()
        self.workers.close()
        self.slow.close()
        self.planners.close()
        self.readers.close()
        self.motions.close()

    async def while_awaited(
        self, workers: Workers, request: Request, work: Callable[[threading.Event], Response]
    ) -> Response:
        """Do slow work on a thread; it is told by an event when its client has left.

        Parameters
        ----------
        workers : Workers
            Whose thread it is.
        request : Request
            The request that it answers.
        work : callable
            Does it; called with the event, after which it raises `StoppedError` as soon as it can.
        """
        client_left = threading.Event()

        def unless_left() -> Response:
            if client_left.is_set():
                raise StoppedError
            return work(client_left)

        async def watch() -> None:
            while not await request.is_disconnected():
                await asyncio.sleep(POLL_INTERVAL)
            client_left.set()

        watcher = asyncio.create_task(watch())
        try:
            return await workers.run(unless_left)
        except StoppedError:
            return Response(status_code=204)  # which nobody reads
        finally:
            watcher.cancel()

    def scene(self, data: dict[str, Any], measures: list[dict[str, Any]]) -> Scenario:
        """Make a scenario of a scene."""
        return read_scene(data, measures, self.limits, self.motions)

    def stated(self, data: dict[str, Any], measures: list[dict[str, Any]]) -> Scenario | AssemblyScenario:
        """Make a scenario of a scene of one piece, of several, or of a room, that need not run here."""
        if "plan" in data and not measures:
            return read_room_scene(data, self.limits, self.motions)
        return self.shaken(data, measures)

    def reply_of(self, job: Job) -> JobReply:
        """Return how a job stands."""
        return job_reply(job, self.jobs.position(job), self.motions.with_file_names)

    def begun(
        self,
        work: JobWork,
        runs: int,
        scenario: Scenario | AssemblyScenario,
        lease: float | None,
        before: RoomScenario | None = None,
    ) -> Response:
        """Begin a job, and return where it stands and where to look for it; see `Jobs.start`."""
        job = self.jobs.start(work, runs, uploaded_motions(scenario), lease, before)
        return json_response(self.reply_of(job), 202, {"Location": f"/api/v1/jobs/{job.id}"})

    def done(self, name: str) -> tuple[Job, AnyVerdict]:
        """Return a job that is done, and its verdict.

        Raises
        ------
        RefusedError
            There is no such job, or it has no verdict yet.
        """
        job = self.jobs.get(name)
        if job.state != "done" or job.verdict is None:
            raise refused(409, "app.no_report_yet", state=job.state)
        return job, job.verdict

    def verdict(self, name: str) -> tuple[Job, Verdict]:
        """Return a job of the verification of one piece that is done, and its verdict.

        Raises
        ------
        RefusedError
            There is no such job, it has no verdict yet, or it is of a room.
        """
        job, verdict = self.done(name)
        if isinstance(verdict, RoomVerdict):
            raise refused(409, "app.of_a_room")
        return job, verdict

    def shaken(self, data: dict[str, Any], measures: list[dict[str, Any]]) -> Scenario | AssemblyScenario:
        """Make a scenario of a scene of one piece or several."""
        read = read_pieces if several_pieces(data) else read_scene
        return read(data, measures, self.limits, self.motions)


def json_response(
    reply: Reply,
    status: int = 200,
    headers: dict[str, str] | None = None,
) -> Response:
    """Return a reply as a JSON response; call it on a worker where the reply is large."""
    return Response(reply.model_dump_json(by_alias=True), status, headers, "application/json")
