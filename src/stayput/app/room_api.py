"""Routes of rooms: a verdict as a job, which gets better while it runs, and its plan to buy and do."""

from __future__ import annotations

from dataclasses import asdict, replace
from functools import partial
from typing import TYPE_CHECKING, Annotated

from fastapi import Depends, Query, Request
from starlette.responses import Response

from stayput.app.middleware import REPORT_POLICY
from stayput.app.refusals import RefusedError, refused
from stayput.app.requests import Name, RoomRequest  # noqa: TC001 - FastAPI reads the annotations
from stayput.app.scenes import motions_of, refusal, too_many
from stayput.app.service import OF_BODY, OF_JOB, json_response, of_file, problems
from stayput.app.turns import Turn
from stayput.app.verdict_replies import JobReply, PlanProgressReply
from stayput.catalogue import LANGUAGES, Language
from stayput.errors import InputError
from stayput.report.room.card import plan_html
from stayput.rooms.decisions import changes_between
from stayput.rooms.planning import action_plan
from stayput.rooms.steps import Home
from stayput.verification import verify

if TYPE_CHECKING:
    from collections.abc import Callable

    from fastapi import APIRouter

    from stayput.app.jobs import Job
    from stayput.app.limits import Limits
    from stayput.app.service import Service
    from stayput.execution import Stop
    from stayput.rooms.steps import ActionPlan
    from stayput.scenario import Scenario
    from stayput.verification import Verdict


AskedHome = Annotated[Home, Depends()]
"""What the home of a plan is like, by the query."""


def add_rooms(router: APIRouter, service: Service) -> None:
    """Add the routes of rooms to those of the API."""

    @router.post("/room", status_code=202, response_model=JobReply, responses=problems(*OF_BODY, 429))
    async def start(body: RoomRequest) -> Response:
        """Begin the verification of a room: it goes on as a job, whose result gets better while it runs."""

        def prepare() -> tuple[Scenario, int, Scenario | None]:
            scenario = service.room(body.scene)
            return scenario, _checked(scenario, service.limits), _before(body, scenario, service)

        scenario, runs, before = await service.workers.run(prepare)

        return service.begun(partial(verify, changes=body.changes), body, scenario, runs, before)

    def finished(name: str) -> tuple[Job, Verdict]:
        job, verdict = service.done(name)
        if verdict.scenario.plan is None:
            raise refused(409, "app.no_report_yet", state=job.state)
        return job, verdict

    @router.get("/jobs/{name}/plan", **of_file(OF_JOB, "text/html"))
    async def plan(
        request: Request, name: Name, home: AskedHome, lang: Annotated[Language, Query()] = "en"
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

    refusals = problems(404, 409, 422)

    @router.get("/jobs/{name}/plan/progress", response_model=PlanProgressReply, responses=refusals)
    async def progress(name: Name, home: AskedHome) -> Response:
        """Return how far a plan has come that another request is waiting for, or whether it is there."""
        job, _ = finished(name)
        made = _key(LANGUAGES[0], home) in job.reports
        return json_response(PlanProgressReply(made=made, runs=job.plan_runs.get(str(home), 0)))


def _before(body: RoomRequest, scenario: Scenario, service: Service) -> Scenario | None:
    """Return the room before the changes that are tried in it.

    Raises
    ------
    RefusedError
        What is wrong with it; one that differs in more than what changes change.
    """
    if body.before is None:
        return None
    try:
        before = service.room(body.before)
    except RefusedError as refused_scene:
        error = refused_scene.error
        field = error.field and error.field.replace("scene", "before", 1)
        raise RefusedError(refused_scene.status_code, error.about(field)) from None
    unchanged, asked = _unchanged(before), _unchanged(scenario)
    others = [name for name, value in unchanged.items() if value != asked[name]]
    if others:
        raise refused(422, "app.another_room", "before", others=", ".join(others))
    return before


def _unchanged(scenario: Scenario) -> dict[str, object]:
    """Return what changes leave as it is: all but where pieces and people are, and measures."""
    moved = {"at", "heading", "against", "along", "gap", "measures"}
    same = scenario.model_dump(exclude={"title": True, "places": True, "furniture": {"__all__": moved}})
    places = [replace(place.place(), at=(0.0, 0.0), heading=0.0) for place in scenario.places]
    return {**same, "places": places}


def _checked(scenario: Scenario, limits: Limits) -> int:
    """Return how many simulations of the room as it is there are.

    Raises
    ------
    RefusedError
        More than this server allows, or a piece that cannot stand where it does.
    """
    try:
        with scenario.naming_keys():
            scenario.scene().refuse_wrong_places()
    except InputError as error:
        raise refusal(error) from None
    motions = motions_of(scenario.shaking)
    runs = motions * max(1, -(-scenario.samples // motions))
    if runs > limits.runs_of_room:
        raise too_many("uncertainty.samples", runs, limits.runs_of_room, "app.runs")
    return runs


def _plan(
    job: Job, verdict: Verdict, home: Home, threads: int | None, on_progress: Callable[[int], None]
) -> ActionPlan:
    """Return the plan of a room; changes that are tried in it are its steps.

    Raises
    ------
    RefusedError
        The room cannot have been as it is said to have been before these changes.
    """
    before = home.of(verdict.scenario if job.before is None else job.before)
    try:
        return action_plan(
            replace(verdict, scenario=before),
            decided=changes_between(before, verdict.scenario),
            **asdict(home),
            threads=threads,
            progress=False,
            on_progress=on_progress,
        )
    except InputError as error:
        if job.before is None:
            raise
        sentences = error.told("en"), error.told("ja")
        raise RefusedError(422, InputError("app.before_refused", "before", why=sentences)) from None


def _key(language: Language, home: Home) -> str:
    """Return the name under which a job keeps the page of a plan."""
    return f"{language} {home}"
