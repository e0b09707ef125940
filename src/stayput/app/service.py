"""Shared by the routes: the server's state, threads for work, and JSON responses."""

from __future__ import annotations

import asyncio
import tempfile
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from starlette.responses import Response

from stayput.app.jobs import Job, Jobs, StoppedError, Turns, Workers
from stayput.app.messages import Problem, RefusedError, Reply, VerificationRequest, problem, refused
from stayput.app.motions import Motions, Readers
from stayput.app.scenes import read_scene, short_enough, unchanged, uploaded_motions
from stayput.app.verification import JobReply, verdict_reply
from stayput.catalogue import phrase
from stayput.execution import Stop

if TYPE_CHECKING:
    from starlette.requests import Request

    from stayput.app.limits import Limits
    from stayput.scenario import Scenario
    from stayput.verification import Verdict

POLL_INTERVAL = 0.5
"""How often a long request checks whether its client has left [s]."""


OF_BODY = (400, 413, 422, 503)
"""Statuses by which a body is refused."""

OF_JOB = (404, 409, 422, 503)
"""Statuses by which what a job has made is refused."""


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


def of_file(statuses: tuple[int, ...], *kinds: str) -> dict[str, Any]:
    """Return how a route is described that answers with a file of one of some kinds, or refuses."""
    answer: dict[int | str, Any] = {200: {"content": {kind: {} for kind in kinds}}}
    return {"response_class": Response, "responses": answer | problems(*statuses)}


class Service:
    """State of the server that the routes share.

    Parameters
    ----------
    limits : Limits
        What is accepted.

    Attributes
    ----------
    workers, slow, planners : Workers
        Threads that compute: what is short, what is not, and plans to buy and do, which take longest.
    turns : Turns
        Of verifications and plans.
    jobs : Jobs
        Verifications.
    readers : Readers
        What reads uploads.
    motions : Motions
        What was uploaded.
    ready : bool
        Whether everything is compiled.
    closed : bool
        Whether the server ends.
    """

    def __init__(self, limits: Limits) -> None:
        self.limits = limits
        self.workers = Workers(limits.workers, limits.waiting)
        self.slow = Workers(limits.slow_workers, limits.slow_waiting)
        self.planners = Workers(limits.planners, limits.slow_waiting)
        self.turns = Turns(limits.jobs_running)
        self.jobs = Jobs(limits, self.turns)
        self.readers = Readers(limits)
        folder = Path(tempfile.mkdtemp(prefix="stayput-"))
        self.motions = Motions(folder, limits, self.readers, self.jobs.motions)
        self.ready = self.closed = False

    def close(self) -> None:
        """Stop all jobs, let the threads go, and remove the folder."""
        self.closed = True
        for part in (self.jobs, self.workers, self.slow, self.planners, self.readers, self.motions):
            part.close()

    async def while_awaited(
        self, workers: Workers, request: Request, work: Callable[[Stop], Response]
    ) -> Response:
        """Do slow work on a thread, which ends when its client has left.

        Parameters
        ----------
        workers : Workers
            Whose thread it is.
        request : Request
            The request that it answers.
        work : callable
            Does it; called with what is set when the client has left. Runs in space end then by themselves.
        """
        left = Stop()

        def unless_left() -> Response:
            with left.ending_runs():
                answer = None if left.is_set() else work(left)
            if answer is None or left.is_set():
                raise StoppedError
            return answer

        async def watch() -> None:
            while not await request.is_disconnected():
                await asyncio.sleep(POLL_INTERVAL)
            left.set()

        watcher = asyncio.create_task(watch())
        try:
            return await workers.run(unless_left)
        except StoppedError:
            return Response(status_code=204)  # which nobody reads
        finally:
            watcher.cancel()

    def scene(self, data: dict[str, Any], measures: Sequence[dict[str, Any]] = ()) -> Scenario:
        """Make a scenario of a scene of one piece, of several, or of a room."""
        return read_scene(data, measures, self.limits, self.motions)

    def lone_piece(self, data: dict[str, Any], measures: Sequence[dict[str, Any]] = ()) -> Scenario:
        """Make a scenario of a scene of one piece.

        Raises
        ------
        RefusedError
            It is of several, or of a room.
        """
        scenario = self.scene(data, measures)
        if not scenario.alone:
            raise refused(422, "scenario.of_several", "scene.furniture")
        return scenario

    def room(self, data: dict[str, Any]) -> Scenario:
        """Make a scenario of a room.

        Raises
        ------
        RefusedError
            It has no plan.
        """
        scenario = self.scene(data)
        if scenario.plan is None:
            raise refused(422, "scenario.missing", "scene.plan", allowed=phrase("rooms.no_plan"))
        return scenario

    def before(self, data: dict[str, Any], scenario: Scenario) -> Scenario:
        """Make a scenario of a room before the changes that are tried in it.

        Raises
        ------
        RefusedError
            What is wrong with it; one that differs in more than what changes change.
        """
        try:
            before = self.room(data)
        except RefusedError as refused_scene:
            error = refused_scene.error
            field = error.field and error.field.replace("scene", "before", 1)
            raise RefusedError(refused_scene.status_code, error.about(field)) from None
        asked = unchanged(scenario)
        others = [name for name, value in unchanged(before).items() if value != asked[name]]
        if others:
            raise refused(422, "app.another_room", "before", others=", ".join(others))
        return before

    def reply_of(self, job: Job) -> JobReply:
        """Return how a job stands, with its verdict as far as it is known."""
        state, verdict = job.state, job.verdict  # in this order: the verdict is there when the job is done
        return JobReply.from_attributes(
            job,
            state=state,
            progress=1.0 if state == "done" else min(1.0, job.done / max(1, job.total)),
            seconds=round(job.seconds, 3),
            error=job.error and problem(job.error.rewritten(self.motions.with_file_names)),
            result=verdict and verdict_reply(verdict),
        )

    def begun(
        self,
        verification: Callable[..., Verdict],
        body: VerificationRequest,
        scenario: Scenario,
        runs: int,
        before: Scenario | None = None,
    ) -> Response:
        """Begin a job that verifies a scene, and return where it stands and where to look for it.

        Parameters
        ----------
        verification : callable
            `verify`, with what is asked beside the scene.
        body : VerificationRequest
            What was asked.
        scenario : Scenario
            The scene.
        runs, before
            As ``total`` and ``before`` of `Jobs.start`.
        """
        options = {"slide_limit": body.slide_limit_m, "threads": self.limits.threads, "progress": False}
        work = partial(verification, scenario, **options)
        job = self.jobs.start(work, runs, uploaded_motions(scenario), body.lease_s, before)
        return json_response(self.reply_of(job), 202, {"Location": f"/api/v1/jobs/{job.id}"})

    def done(self, name: str, *, of_room: bool | None = None) -> tuple[Job, Verdict]:
        """Return a job that is done, and its verdict.

        Parameters
        ----------
        name : str
            The job.
        of_room : bool, optional
            Whether it must be, or must not be, of a room.

        Raises
        ------
        RefusedError
            There is no such job, it has no verdict yet, or one of another kind.
        """
        job = self.jobs.get(name)
        verdict = job.verdict if job.state == "done" else None
        if verdict is None:
            raise refused(409, "app.no_report_yet", state=job.state)
        if of_room and verdict.scenario.plan is None:
            raise refused(409, "app.of_no_room")
        if of_room is False and verdict.scenario.plan is not None:
            raise refused(409, "app.of_a_room")
        return job, verdict

    def shaken(self, data: dict[str, Any], measures: Sequence[dict[str, Any]] = ()) -> Scenario:
        """Make a scenario of a scene that is to be run once."""
        return short_enough(self.scene(data, measures), self.limits)


def json_response(reply: Reply, status: int = 200, headers: dict[str, str] | None = None) -> Response:
    """Return a reply as a JSON response; call it on a worker where the reply is large."""
    return Response(reply.model_dump_json(by_alias=True), status, headers, "application/json")
