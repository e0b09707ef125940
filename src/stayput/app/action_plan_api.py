"""Routes of the plan to buy and do: a page to print, computed when asked for, and how far that has come."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

from fastapi import Depends, Query, Request
from starlette.responses import Response

from stayput.app.middleware import REPORT_POLICY
from stayput.app.refusals import RefusedError, refused
from stayput.app.requests import Name  # noqa: TC001 - FastAPI reads the annotations
from stayput.app.room_replies import PlanProgressReply
from stayput.app.service import json_response, problems
from stayput.app.turns import Turn
from stayput.catalogue import LANGUAGES, Language
from stayput.errors import InputError
from stayput.report.room.card import plan_html
from stayput.rooms.decisions import changes_between
from stayput.rooms.planning import action_plan
from stayput.rooms.steps import Home
from stayput.rooms.verdict import RoomVerdict

if TYPE_CHECKING:
    from collections.abc import Callable

    from fastapi import APIRouter

    from stayput.app.jobs import Job
    from stayput.app.service import Service
    from stayput.rooms.steps import ActionPlan
    from stayput.simulation.space_engine import Stop


def _asked_home(
    *,
    no_drilling: Annotated[bool, Query(description="Nothing may be screwed to a wall.")] = False,
    tatami: Annotated[bool, Query(description="The floor is tatami.")] = False,
    plasterboard: Annotated[bool, Query(description="The walls have no studs to screw to.")] = False,
    dropped_ceiling: Annotated[bool, Query(description="The ceiling hangs on wires.")] = False,
) -> Home:
    return Home(no_drilling, tatami, plasterboard, dropped_ceiling)


AskedHome = Annotated[Home, Depends(_asked_home)]
"""What the home of a plan is like, by the query."""


def add_action_plan(router: APIRouter, service: Service) -> None:
    """Add the routes to those of the API."""

    def finished(name: str) -> tuple[Job, RoomVerdict]:
        job = service.jobs.get(name)
        if job.state != "done" or not isinstance(job.verdict, RoomVerdict):
            raise refused(409, "app.no_plan_yet", state=job.state)
        return job, job.verdict

    @router.get(
        "/jobs/{name}/plan",
        response_class=Response,
        tags=["verification"],
        responses={200: {"content": {"text/html": {}}}, **problems(404, 409, 422, 503)},
    )
    async def plan(
        request: Request,
        name: Name,
        home: AskedHome,
        lang: Annotated[Language, Query()] = "en",
    ) -> Response:
        """Return what to buy and do in the room of a job: one page to print."""
        job, verdict = finished(name)
        reports, key = job.reports, _key(lang, home)

        def work(left: Stop) -> Response:
            def note_progress(runs: int) -> None:
                job.plan_runs[str(home)] += runs
                turn.go_on()

            if key not in reports:
                job.plan_runs[str(home)] = 0
                with Turn(service.turns, lambda: not left.is_set()) as turn:
                    made = _plan(job, verdict, home, service.limits.threads, note_progress)
                for language in LANGUAGES:  # the page's language may be changed
                    reports[_key(language, home)] = plan_html(made, language).encode("utf-8")
            headers = {"Content-Security-Policy": REPORT_POLICY}
            return Response(reports[key], headers=headers, media_type="text/html; charset=utf-8")

        return await service.while_awaited(service.planners, request, work)

    @router.get(
        "/jobs/{name}/plan/progress",
        response_model=PlanProgressReply,
        tags=["verification"],
        responses=problems(404, 409, 422),
    )
    async def progress(name: Name, home: AskedHome) -> Response:
        """Return how far a plan has come that another request is waiting for, or whether it is there."""
        job, _ = finished(name)
        made = _key(LANGUAGES[0], home) in job.reports
        return json_response(PlanProgressReply(made=made, runs=job.plan_runs.get(str(home), 0)))


def _plan(
    job: Job, verdict: RoomVerdict, home: Home, threads: int | None, on_progress: Callable[[int], None]
) -> ActionPlan:
    """Return the plan of a room; changes that are tried in it are its steps.

    Raises
    ------
    RefusedError
        The room cannot have been as it is said to have been before these changes.
    """
    before = verdict.scenario if job.before is None else job.before
    try:
        return action_plan(
            replace(verdict, scenario=before),
            decided=changes_between(before, verdict.scenario),
            no_drilling=home.no_drilling,
            tatami=home.tatami,
            plasterboard=home.plasterboard,
            dropped_ceiling=home.dropped_ceiling,
            threads=threads,
            progress=False,
            on_progress=on_progress,
        )
    except InputError as error:
        if job.before is None:
            raise
        told = error.told("en"), error.told("ja")
        raise RefusedError(422, InputError("app.before_refused", "before", why=told)) from None


def _key(language: Language, home: Home) -> str:
    """Return the name under which a job keeps the page of a plan."""
    return f"{language} {home}"
