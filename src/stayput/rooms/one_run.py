"""What happens to people, doors and ways out in one run of a room that is shown."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from stayput.rooms.events import EndOfRuns, events_of
from stayput.rooms.tracks import tracks_of

if TYPE_CHECKING:
    from stayput.scenario.room import RoomScenario
    from stayput.simulation.space_run import SpaceRun


class RunInRoom(NamedTuple):
    """What happens in one run of a room.

    Parameters
    ----------
    hits : tuple of (str, str)
        Pieces and the places of people that they come into.
    blocked : tuple of str
        Doors that are blocked at the end.
    shut_in : tuple of str
        Places from which no way leads out at the end.
    """

    hits: tuple[tuple[str, str], ...]
    blocked: tuple[str, ...]
    shut_in: tuple[str, ...]


def happens_in(run: SpaceRun, scenario: RoomScenario) -> RunInRoom:
    """Return what happens in a run of a room."""
    plan = scenario.floor_plan()
    tracks = tracks_of(run.standing, run, run.motion.dt)
    events = events_of(EndOfRuns(plan), [[track] for track in tracks])
    return RunInRoom(
        tuple(
            (name, place.name)
            for place, hits in zip(plan.places, events.hits, strict=True)
            for name, one in zip(scenario.names, hits, strict=True)
            if one.happened[0]
        ),
        tuple(door.name for door, own in zip(plan.doors, events.blocked, strict=True) if own[0]),
        tuple(place.name for place, own in zip(plan.places, events.shut_in, strict=True) if own[0]),
    )
