"""What happens in a room: who is hit by what, what collides, which doors open, and who gets out.

The floor is a grid of square cells. A person passes where the nearest obstacle is half of `PASSAGE` away.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from scipy import ndimage

from stayput.rooms.contact import contact_with_place, meet
from stayput.rooms.tracks import Track, tracks_of

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from numpy.typing import NDArray

    from stayput.model.floor_plan import Door, FloorPlan, PersonPlace
    from stayput.simulation.run import Run

_images: Any = ndimage  # its results depend on its arguments, which its types do not tell

CELL = 0.05
"""Side of a cell [m]."""

PASSAGE = 0.5
"""Width that a person needs to walk through, or out of a door [m]: about that of the shoulders."""


def _middles(side: float) -> NDArray[np.float64]:
    return CELL * (np.arange(max(1, round(side / CELL)), dtype=np.float64) + 0.5)


@dataclass(frozen=True, eq=False)
class Ways:
    """The floor of a room as a grid, for questions of where one can walk.

    Parameters
    ----------
    plan : FloorPlan
        The room.
    """

    plan: FloorPlan

    @cached_property
    def x(self) -> NDArray[np.float64]:
        """Middles of the cells along x [m], shape (nx,)."""
        return _middles(self.plan.width)

    @cached_property
    def y(self) -> NDArray[np.float64]:
        """Middles of the cells along y [m], shape (ny,)."""
        return _middles(self.plan.length)

    def covered(self, outlines: Iterable[NDArray[np.float64]]) -> NDArray[np.bool_]:
        """Return which cells have their middles in one of convex outlines, shape (nx, ny).

        Parameters
        ----------
        outlines : iterable of ndarray, shape (n, 2)
            Their corners, counter-clockwise [m].
        """
        over = np.zeros((len(self.x), len(self.y)), np.bool_)
        for corners in outlines:
            (x_low, y_low), (x_high, y_high) = corners.min(axis=0), corners.max(axis=0)
            xs = slice(*np.searchsorted(self.x, (x_low, x_high)))
            ys = slice(*np.searchsorted(self.y, (y_low, y_high)))
            x, y = self.x[xs, np.newaxis], self.y[np.newaxis, ys]
            inside = np.ones((x.size, y.size), np.bool_)
            for (x1, y1), (x2, y2) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
                inside &= (x2 - x1) * (y - y1) - (y2 - y1) * (x - x1) >= 0.0
            over[xs, ys] |= inside
        return over

    def cells(self, corners: NDArray[np.float64]) -> NDArray[np.intp]:
        """Return the numbers of the cells that a convex outline covers, x-major."""
        return np.flatnonzero(self.covered([corners]))

    @cached_property
    def _taken(self) -> NDArray[np.bool_]:
        """Cells under what people lie and sit on."""
        return self.covered(place.corners for place in self.plan.places if place.blocks)

    def opens(self, door: Door, covered: NDArray[np.bool_]) -> bool:
        """Return whether a door opens as far as a person needs, given which cells furniture covers.

        Parameters
        ----------
        door : Door
            One that opens inwards needs the floor that it sweeps; any leaves its width free.
        covered : ndarray of bool, shape (nx, ny)
            As of `covered`.
        """
        if door.width < PASSAGE:
            return False
        return door.opens != "inwards" or not (self._swept(door) & covered).any()

    def _swept(self, door: Door) -> NDArray[np.bool_]:
        """Return the cells that a door sweeps until its edge is a person's width from the other jamb."""
        plan = self.plan
        hinge, jamb = (
            np.array(plan.on_wall(door.wall, along)) for along in (door.start, door.start + door.width)
        )
        if door.hinge == "end":
            hinge, jamb = jamb, hinge
        shut = (jamb - hinge) / door.width
        inwards = np.array(plan.on_wall(door.wall, door.start, 1.0)) - plan.on_wall(door.wall, door.start)
        x, y = self.x[:, np.newaxis] - hinge[0], self.y[np.newaxis] - hinge[1]
        along, into = x * shut[0] + y * shut[1], x * inwards[0] + y * inwards[1]
        angle = 2.0 * math.asin(min(1.0, 0.5 * PASSAGE / door.width))
        return (np.hypot(along, into) <= door.width) & (np.arctan2(into, along) <= angle)

    def _walkable(self, covered: NDArray[np.bool_]) -> NDArray[np.int64]:
        """Return to which of the connected parts of the walkable floor cells belong, 0 for none."""
        # a frame of one cell stands for the walls, whose faces are half a cell from the first middles
        obstacles = np.pad(covered | self._taken, 1, constant_values=True)
        clear: NDArray[np.float64] = CELL * (_images.distance_transform_edt(~obstacles)[1:-1, 1:-1] - 0.5)
        return _images.label(clear >= 0.5 * PASSAGE - 0.5 * CELL, structure=np.ones((3, 3)))[0]

    def _beside(self, parts: NDArray[np.int64], reach: NDArray[np.bool_]) -> set[int]:
        return set(np.unique(parts[reach]).tolist()) - {0}

    def _at_door(self, door: Door) -> NDArray[np.bool_]:
        """Return the cells from which one steps through a door."""
        middle = np.array(self.plan.on_wall(door.wall, door.start + 0.5 * door.width))
        apart = np.hypot(self.x[:, np.newaxis] - middle[0], self.y[np.newaxis] - middle[1])
        return apart <= PASSAGE

    def _at_place(self, place: PersonPlace) -> NDArray[np.bool_]:
        """Return the cells onto which one steps from a place: in it, or up to a passage's width beside it."""
        cos, sin = math.cos(place.heading), math.sin(place.heading)
        x, y = self.x[:, np.newaxis] - place.at[0], self.y[np.newaxis] - place.at[1]
        along, across = np.abs(cos * x + sin * y), np.abs(cos * y - sin * x)
        return (along <= 0.5 * place.width + PASSAGE) & (across <= 0.5 * place.length + PASSAGE)

    def shut_in(self, covered: NDArray[np.bool_]) -> tuple[list[bool], list[bool]]:
        """Return which doors are blocked, and from which places no way leads out.

        A door is blocked where it does not open, or nobody gets near it from the largest part of the floor.

        Parameters
        ----------
        covered : ndarray of bool, shape (nx, ny)
            Cells on which furniture lies or stands, as of `covered`.
        """
        parts = self._walkable(covered)
        sizes = np.bincount(parts.ravel())
        main = {int(sizes[1:].argmax()) + 1} if len(sizes) > 1 else set[int]()
        at_doors = [
            self._beside(parts, self._at_door(door)) if self.opens(door, covered) else set[int]()
            for door in self.plan.doors
        ]
        exits = any(door.way_out for door in self.plan.doors)  # else nobody is shut in by furniture
        ways = set[int]().union(
            *(near for door, near in zip(self.plan.doors, at_doors, strict=True) if door.way_out)
        )
        return (
            [not near & main for near in at_doors],
            [exits and not self._beside(parts, self._at_place(place)) & ways for place in self.plan.places],
        )


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
        return np.any([hits.happened for hits in self.hits[place]], axis=0)


def hits_of(place: PersonPlace, tracks: Sequence[Track]) -> Hits:
    """Return the contacts of a piece, whose tracks are given by run, with a place."""
    contacts = np.full((3, len(tracks)), np.nan)
    for run, track in enumerate(tracks):
        contact = contact_with_place(track, place)
        if contact is not None:
            contacts[:, run] = contact
    return Hits(*contacts)


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
        ends = [self.of(run) for run in zip(*tracks, strict=True)]
        blocked, shut_in = (
            np.array([pair[i] for pair in ends], np.bool_).reshape(len(ends), -1).T for i in (0, 1)
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
    hits = tuple(tuple(hits_of(place, piece_tracks) for piece_tracks in tracks) for place in ends.plan.places)
    return Events(hits, *ends.of_all(tracks))


def collisions(tracks: Sequence[Sequence[Track]]) -> dict[tuple[int, int], NDArray[np.bool_]]:
    """Return which pairs of pieces come together in which runs, shape (runs,); without pairs that never do.

    The pieces ran each by themselves: what they do after they have met is not known.
    """
    met_by: dict[tuple[int, int], NDArray[np.bool_]] = {}
    for b in range(len(tracks)):
        for a in range(b):
            pairs = zip(tracks[a], tracks[b], strict=True)
            met = np.array([meet(*pair) for pair in pairs])
            if met.any():
                met_by[a, b] = met
    return met_by


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


def happens_in(run: Run) -> RunInRoom:
    """Return what happens in a run of a room."""
    plan = run.plan
    assert plan is not None
    tracks = tracks_of(run.standing, run, run.motion.dt)
    events = events_of(EndOfRuns(plan), [[track] for track in tracks])
    return RunInRoom(
        tuple(
            (name, place.name)
            for place, hits in zip(plan.places, events.hits, strict=True)
            for name, hit in zip(run.names, hits, strict=True)
            if hit.happened[0]
        ),
        tuple(door.name for door, blocked in zip(plan.doors, events.blocked, strict=True) if blocked[0]),
        tuple(place.name for place, shut in zip(plan.places, events.shut_in, strict=True) if shut[0]),
    )
