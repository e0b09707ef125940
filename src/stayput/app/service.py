"""What the routes work with, and how they answer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from starlette.responses import Response

from stayput.app.fields import Problem, Reply
from stayput.app.scenes import read_scene

if TYPE_CHECKING:
    from stayput.app.jobs import Jobs
    from stayput.app.limits import Limits
    from stayput.app.motions import Motions
    from stayput.app.readers import Readers
    from stayput.app.workers import Workers
    from stayput.scenario import Scenario


def problems(*statuses: int) -> dict[int | str, dict[str, Any]]:
    """Return what the description of the API says of refusals."""
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
    """What the routes work with.

    Attributes
    ----------
    limits : Limits
        What is accepted.
    workers, slow : Workers
        Threads that compute: what is short, and what is not.
    readers : Readers
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
    readers: Readers
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
        self.readers.close()
        self.motions.close()

    def scene(self, data: dict[str, Any], measures: list[dict[str, Any]]) -> Scenario:
        """Make a scenario of a scene."""
        return read_scene(data, measures, self.limits, self.motions)


def json_response(reply: Reply, status: int = 200, headers: dict[str, str] | None = None) -> Response:
    """Return an answer; to be called on a worker where the reply is large."""
    text = reply.model_dump_json(by_alias=True)
    return Response(text, status, headers, "application/json")
