"""Route of rooms: a verdict as a job, which gets better while it runs."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from stayput.app.refusals import RefusedError, refused
from stayput.app.requests import RoomRequest  # noqa: TC001 - FastAPI reads the annotations
from stayput.app.scenes import motions_of, read_room_scene, refusal
from stayput.app.service import problems
from stayput.app.verdict_replies import JobReply
from stayput.errors import InputError
from stayput.rooms.runs import groups_of
from stayput.rooms.verify import refuse_what_stands_wrong, verify_room

if TYPE_CHECKING:
    from collections.abc import Callable

    from fastapi import APIRouter
    from starlette.responses import Response

    from stayput.app.limits import Limits
    from stayput.app.service import Service
    from stayput.rooms.verdict import RoomVerdict
    from stayput.scenario.room import RoomScenario


def add_rooms(router: APIRouter, service: Service) -> None:
    """Add the route of rooms to those of the API."""

    @router.post(
        "/room",
        status_code=202,
        response_model=JobReply,
        tags=["verification"],
        responses=problems(400, 413, 422, 429, 503),
    )
    async def start(body: RoomRequest) -> Response:
        """Begin the verification of a room: it goes on as a job, whose result gets better while it runs."""

        def prepare() -> tuple[RoomScenario, int, RoomScenario | None]:
            scenario = read_room_scene(body.scene, service.limits, service.motions)
            return scenario, _checked(scenario, service.limits), _before(body, scenario, service)

        scenario, runs, before = await service.workers.run(prepare)

        def work(
            on_progress: Callable[[int, int], None], on_verdict: Callable[[RoomVerdict], None]
        ) -> RoomVerdict:
            return verify_room(
                scenario,
                changes=body.changes,
                slide_limit=body.slide_limit_m,
                threads=service.limits.threads,
                progress=False,
                on_progress=on_progress,  # which stops it by an exception
                on_verdict=on_verdict,
            )

        return service.begun(work, runs, scenario, body.lease_s, before)


def _before(body: RoomRequest, scenario: RoomScenario, service: Service) -> RoomScenario | None:
    """Return the room before the changes that are tried in it.

    Raises
    ------
    RefusedError
        What is wrong with it; one that differs in more than what changes change.
    """
    if body.before is None:
        return None
    try:
        before = read_room_scene(body.before, service.limits, service.motions)
    except RefusedError as refused_scene:
        error = refused_scene.error
        field = error.field and error.field.replace("scene", "before", 1)
        raise RefusedError(refused_scene.status_code, error.about(field)) from None
    given, asked = _unchanged(before), _unchanged(scenario)
    others = [name for name, value in given.items() if value != asked[name]]
    if others:
        raise refused(422, "app.another_room", "before", others=", ".join(others))
    return before


def _unchanged(scenario: RoomScenario) -> dict[str, object]:
    """Return what changes leave as it is: all but where pieces and people are, and measures."""
    moved = {"at", "heading", "against", "along", "gap", "measures"}
    same = scenario.model_dump(exclude={"title": True, "places": True, "furniture": {"__all__": moved}})
    places = [replace(one.place(), at=(0.0, 0.0), heading=0.0) for one in scenario.places]
    return {**same, "places": places}


def _checked(scenario: RoomScenario, limits: Limits) -> int:
    """Return how many simulations of the room as it is there are.

    Raises
    ------
    RefusedError
        More than this server allows, or a piece that cannot stand where it does.
    """
    try:
        refuse_what_stands_wrong(scenario, scenario.floor_plan(), scenario.assembly(scenario.stated))
    except InputError as error:
        raise refusal(error) from None
    motions = motions_of(scenario.shaking)
    runs = len(groups_of(scenario)) * motions * max(1, -(-scenario.uncertainty.samples // motions))
    if runs > limits.runs_of_room:
        raise refused(422, "app.many_runs", "scene.uncertainty.samples", runs=runs, most=limits.runs_of_room)
    return runs
