"""What happens in a room: who is hit by what, which doors are blocked, who is shut in, what collides."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.rooms.contact import contact_between, contact_with_place
from stayput.rooms.tracks import tracks_of
from stayput.rooms.ways import Ways

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.model.floor_plan import FloorPlan, PersonPlace
    from stayput.rooms.tracks import Track
    from stayput.scenario.room import RoomScenario
    from stayput.simulation.space_run import SpaceRun


class Hits(NamedTuple):
    """Contacts of one piece with one place, by run; NaN where there is none.

    Parameters
    ----------
    time, speed, energy : ndarray, shape (runs,)
        As of `stayput.rooms.contact.RoomContact` [s, m/s, J].
    """

    time: NDArray[np.float64]
    speed: NDArray[np.float64]
    energy: NDArray[np.float64]

    @property
    def happened(self) -> NDArray[np.bool_]:
        """Whether there is one."""
        return ~np.isnan(self.time)


@dataclass(frozen=True, slots=True, eq=False)
class Events:
    """What happened in the runs of a room.

    Parameters
    ----------
    hits : tuple of tuple of Hits
        Of each place by each piece.
    blocked : ndarray of bool, shape (doors, runs)
        Whether a door is blocked at the end.
    shut_in : ndarray of bool, shape (places, runs)
        Whether no way leads out from a place at the end; never in a room without a way out.
    """

    hits: tuple[tuple[Hits, ...], ...]
    blocked: NDArray[np.bool_]
    shut_in: NDArray[np.bool_]

    @property
    def runs(self) -> int:
        """How many runs there are."""
        return self.shut_in.shape[1]

    def hit(self, place: int) -> NDArray[np.bool_]:
        """Return whether a place is hit by any piece, shape (runs,)."""
        return np.any([one.happened for one in self.hits[place]], axis=0)


def hits_of(place: PersonPlace, tracks: Sequence[Track]) -> Hits:
    """Return the contacts of a piece, whose tracks are given by run, with a place."""
    found = np.full((3, len(tracks)), np.nan)
    for run, track in enumerate(tracks):
        contact = contact_with_place(track, place)
        if contact is not None:
            found[:, run] = contact
    return Hits(*found)


class EndOfRuns:
    """Which doors are blocked and who is shut in at the end of runs; equal floors are looked at once.

    Parameters
    ----------
    plan : FloorPlan
        The room.
    """

    def __init__(self, plan: FloorPlan) -> None:
        self.plan = plan
        self.ways = Ways(plan)
        self._known: dict[bytes, tuple[list[bool], list[bool]]] = {}
        self._covered: dict[int, tuple[Track, NDArray[np.bool_]]] = {}

    def of(self, tracks: Sequence[Track]) -> tuple[list[bool], list[bool]]:
        """Return which doors are blocked and who is shut in where the pieces of a run come to lie."""
        covered = np.zeros((len(self.ways.x), len(self.ways.y)), np.bool_)
        for track in tracks:
            covered |= self.covered_by(track)
        key = np.packbits(covered).tobytes()
        if key not in self._known:
            self._known[key] = self.ways.shut_in(covered)
        return self._known[key]

    def of_all(self, tracks: Sequence[Sequence[Track]]) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Return the same of all runs, shape (doors, runs) and (places, runs), from tracks [body][run]."""
        found = [self.of(run) for run in zip(*tracks, strict=True)]
        blocked, shut_in = (
            np.array([pair[i] for pair in found], np.bool_).reshape(len(found), -1).T for i in (0, 1)
        )
        return blocked, shut_in

    def covered_by(self, track: Track) -> NDArray[np.bool_]:
        """Return which cells of the floor a piece covers at the end of a run, shape (nx, ny)."""
        # the track is kept with its floor, so that its identity is not another's
        known = self._covered.get(id(track))
        if known is None:
            known = track, self.ways.covered([track.outline(len(track.sample) - 1)])
            self._covered[id(track)] = known
        return known[1]


def events_of(ends: EndOfRuns, tracks: Sequence[Sequence[Track]]) -> Events:
    """Return what happened.

    Parameters
    ----------
    ends : EndOfRuns
        Of the plan.
    tracks : sequence of sequence of Track, [body][run]
        Where the pieces were.
    """
    hits = tuple(tuple(hits_of(place, own) for own in tracks) for place in ends.plan.places)
    return Events(hits, *ends.of_all(tracks))


def collisions(tracks: Sequence[Sequence[Track]]) -> dict[tuple[int, int], NDArray[np.bool_]]:
    """Return which pairs of pieces come together in which runs, shape (runs,); without pairs that never do.

    The pieces ran each by themselves: what they do after they have met is not known.
    """
    found: dict[tuple[int, int], NDArray[np.bool_]] = {}
    for b in range(len(tracks)):
        for a in range(b):
            pairs = zip(tracks[a], tracks[b], strict=True)
            met = np.array([contact_between(one, other) is not None for one, other in pairs])
            if met.any():
                found[a, b] = met
    return found


def shares_covered(ends: EndOfRuns, tracks: Sequence[Track], which: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Return in what share of all runs a piece ends on each cell of the floor, in one of some of them.

    Parameters
    ----------
    ends : EndOfRuns
        Of the plan.
    tracks : sequence of Track
        The piece in each run.
    which : ndarray of bool, shape (runs,)
        The runs that count.
    """
    counts = np.zeros((len(ends.ways.x), len(ends.ways.y)))
    for track, counted in zip(tracks, which, strict=True):
        if counted:
            counts += ends.covered_by(track)
    return counts / len(tracks)


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
