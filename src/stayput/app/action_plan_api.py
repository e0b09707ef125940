"""Route of the plan to buy and do: a page to print, computed when it is asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from fastapi import Query, Request
from starlette.responses import Response

from stayput.app.jobs import StoppedError
from stayput.app.middleware import REPORT_POLICY
from stayput.app.refusals import refused
from stayput.app.requests import Name  # noqa: TC001 - FastAPI reads the annotations
from stayput.app.service import problems
from stayput.catalogue import LANGUAGES, Language
from stayput.report.action_plan.html import plan_html
from stayput.rooms.planning import action_plan
from stayput.rooms.steps import Home
from stayput.rooms.verdict import RoomVerdict

if TYPE_CHECKING:
    import threading

    from fastapi import APIRouter

    from stayput.app.service import Service


def add_action_plan(router: APIRouter, service: Service) -> None:
    """Add the route to those of the API."""

    @router.get(
        "/jobs/{name}/plan",
        response_class=Response,
        tags=["verification"],
        responses={200: {"content": {"text/html": {}}}, **problems(404, 409, 422, 503)},
    )
    async def plan(
        request: Request,
        name: Name,
        lang: Annotated[Language, Query()] = "en",
        no_drilling: Annotated[bool, Query(description="Nothing may be screwed to a wall.")] = False,
        tatami: Annotated[bool, Query(description="The floor is tatami.")] = False,
        plasterboard: Annotated[bool, Query(description="The walls have no studs to screw to.")] = False,
        dropped_ceiling: Annotated[bool, Query(description="The ceiling hangs on wires.")] = False,
    ) -> Response:
        """Return what to buy and do in the room of a job: one page to print."""
        job = service.jobs.get(name)
        verdict = job.verdict
        if job.state != "done" or not isinstance(verdict, RoomVerdict):
            raise refused(409, "app.no_plan_yet", state=job.state)
        home = Home(no_drilling, tatami, plasterboard, dropped_ceiling)
        reports = job.reports

        def work(client_left: threading.Event) -> Response:
            def go_on(_runs: int) -> None:
                if client_left.is_set():
                    raise StoppedError

            key = f"{lang} {home}"
            if key not in reports:
                made = action_plan(
                    verdict,
                    no_drilling=home.no_drilling,
                    tatami=home.tatami,
                    plasterboard=home.plasterboard,
                    dropped_ceiling=home.dropped_ceiling,
                    threads=service.limits.threads,
                    progress=False,
                    on_progress=go_on,
                )
                for language in LANGUAGES:  # the page's language may be changed
                    reports[f"{language} {home}"] = plan_html(made, language).encode("utf-8")
            headers = {"Content-Security-Policy": REPORT_POLICY}
            return Response(reports[key], headers=headers, media_type="text/html; charset=utf-8")

        return await service.while_awaited(service.planners, request, work)
