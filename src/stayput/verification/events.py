"""What happens in a room: who is hit by what, which doors open, and who gets out.

The floor is a grid of square cells. A person passes where the nearest obstacle is half of `PASSAGE` away.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.mechanics.columns import OVERTURNED_OUTCOME
from stayput.model.floor_plan import Door, FloorPlan, PersonPlace, rectangle
from stayput.montecarlo.scenes import FALLS, RoomEvents
from stayput.simulation import groups
from stayput.simulation.groups import Touching, Track, at_rest, body_at, touching_of
from stayput.simulation.piece import Piece, box_of, separation
from stayput.simulation.space_records import Path

if TYPE_CHECKING:
    from stayput.montecarlo.runs import Runs
    from stayput.simulation.run import Run

CELL = 0.05
"""Side of a cell [m]."""

PASSAGE = 0.5
"""Width that a person needs to walk through, or out of a door [m]: about that of the shoulders."""

SPACING = 0.1
"""Distance between the points of a place at which the speed of a piece is looked at [m]."""

ENTERS_BY = 0.05
"""How far a piece must come into the place of a person to hit or touch who is there [m]: a convention.

What stands beside a bed and is held slides some centimetres to and fro: it nudges the bed's edge in every
earthquake, and touches nobody.
"""

ROUNDING = 1e-9
"""Share by which rounding may change how far a point goes."""


REACH = math.ceil(0.5 * PASSAGE / CELL)
"""Cells around what is covered that may be too near to it."""


def _around(cells: NDArray[np.intp]) -> slice:
    """Return the part of an axis on which cells may be too near to some."""
    return slice(max(0, int(cells[0]) - REACH), int(cells[-1]) + REACH + 1)


def _images() -> Any:
    """Return SciPy's functions of images, whose results depend on their arguments as types do not tell."""
    from scipy import ndimage  # loading it takes longer than a run

    return ndimage


def _blocks(obstacles: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return the cells from which the nearest obstacle is less than half of `PASSAGE` away."""
    clear: NDArray[np.float64] = CELL * (_images().distance_transform_edt(~obstacles) - 0.5)
    return clear < 0.5 * PASSAGE - 0.5 * CELL


def _middles(side: float) -> NDArray[np.float64]:
    return CELL * (np.arange(max(1, round(side / CELL)), dtype=np.float64) + 0.5)


@dataclass(frozen=True, eq=False)
class WalkableGrid:
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

    @cached_property
    def _taken(self) -> NDArray[np.bool_]:
        """Cells under what people lie and sit on."""
        return self.covered(place.corners for place in self.plan.places if place.blocks)

    def opens(self, door: Door, covered: NDArray[np.bool_]) -> bool:
        """Return whether a door opens as far as a person needs, given which cells furniture covers.

        Parameters
        ----------
        door : Door
            One of the plan that opens inwards needs the floor that it sweeps; any leaves its width free.
        covered : ndarray of bool, shape (nx, ny)
            As of `covered`.
        """
        if door.width < PASSAGE:
            return False
        return door.opens != "inwards" or not (self._cells_swept[door] & covered).any()

    @cached_property
    def _cells_swept(self) -> dict[Door, NDArray[np.bool_]]:
        return {door: self._swept(door) for door in self.plan.doors}

    @cached_property
    def _cells_at_doors(self) -> list[NDArray[np.bool_]]:
        return [self._at_door(door) for door in self.plan.doors]

    @cached_property
    def _cells_at_places(self) -> list[NDArray[np.bool_]]:
        return [self._at_place(place) for place in self.plan.places]

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

    def too_near(self, covered: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Return the cells in which a person who walks is too near to covered ones, shape (nx, ny).

        Of what covers more it is what is too near to any part of it.
        """
        near = np.zeros_like(covered)
        if covered.any():
            x, y = (_around(np.flatnonzero(covered.any(axis=axis))) for axis in (1, 0))
            near[x, y] = _blocks(covered[x, y])
        return near

    @cached_property
    def _too_near_always(self) -> NDArray[np.bool_]:
        """Cells in which one is too near to walls, or to what people lie and sit on."""
        # a frame of one cell stands for the walls, whose faces are half a cell from the first middles
        return _blocks(np.pad(self._taken, 1, constant_values=True))[1:-1, 1:-1]

    def _walkable(self, near: NDArray[np.bool_]) -> NDArray[np.int64]:
        """Return to which of the connected parts of the walkable floor cells belong, 0 for none."""
        return _images().label(~(near | self._too_near_always), structure=np.ones((3, 3)))[0]

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

    def shut_in(self, covered: NDArray[np.bool_], near: NDArray[np.bool_]) -> tuple[list[bool], list[bool]]:
        """Return which doors are blocked, and from which places no way leads out.

        A door is blocked where it does not open, or nobody gets near it from the largest part of the floor.

        Parameters
        ----------
        covered, near : ndarray of bool, shape (nx, ny)
            Cells on which furniture lies or stands, and those `too_near` to them.
        """
        parts = self._walkable(near)
        sizes = np.bincount(parts.ravel())
        main = {int(sizes[1:].argmax()) + 1} if len(sizes) > 1 else set[int]()
        at_doors = [
            self._beside(parts, near) if self.opens(door, covered) else set[int]()
            for door, near in zip(self.plan.doors, self._cells_at_doors, strict=True)
        ]
        exits = any(door.way_out for door in self.plan.doors)  # else nobody is shut in by furniture
        ways = set[int]().union(
            *(near for door, near in zip(self.plan.doors, at_doors, strict=True) if door.way_out)
        )
        return (
            [not near & main for near in at_doors],
            [exits and not self._beside(parts, near) & ways for near in self._cells_at_places],
        )


class RoomContact(NamedTuple):
    """A contact of a piece with the place of a person; the piece moves on as if nobody were there.

    Parameters
    ----------
    time : float
        When they first touch [s].
    speed : float
        The largest of the part of the piece that is within the place: an upper bound [m/s].
    energy : float
        The largest kinetic energy of the piece while it touches: also an upper bound [J].
    falls : bool
        Whether the piece falls into the place: speed and energy are then those of its fall.
    """

    time: float
    speed: float
    energy: float
    falls: bool


def contact_with_place(track: Track, place: PersonPlace) -> RoomContact | None:
    """Return the first contact of a piece with the place of a person that it comes into, or None.

    Parameters
    ----------
    track : Track
        The piece's.
    place : PersonPlace
        The place; what stands in it from the beginning does not hit it by staying there.
    """
    if track.stays:
        return None
    corners = rectangle(place.at, place.width, place.length, place.heading)
    least, most = (*corners.min(axis=0), place.low), (*corners.max(axis=0), place.high)
    if groups.apart(track.span, np.array([least, most])):
        return None
    low, high = track.bounds
    near = np.all((low <= most) & (high >= least), axis=1)
    touching = touching_of(
        track.sample, near, track.dt, lambda k: separation(body_at(track, k), box_of(place, len(k)))
    )
    if touching is None or touching.depths.max() < ENTERS_BY:
        return None
    falls = track.falls[touching.places]
    # what falls away from a place that it nudged comes no deeper into it
    into = bool(touching.depths[falls].max(initial=0.0) > touching.depths[~falls].max(initial=0.0))
    if into:
        touching = touching._replace(places=touching.places[falls])
    speed = _speed_within(track, place, touching)
    return RoomContact(touching.time, speed, float(track.energy[touching.places].max()), into)


def _speed_within(track: Track, place: PersonPlace, touching: Touching) -> float:
    """Return the largest speed of those points of a piece that are within a place while they touch [m/s].

    Points of the place, `SPACING` apart, that are in the piece; none where it is all between them. It is not
    less than the speed at which they close in.
    """
    x, y, z = (
        np.linspace(low, high, max(2, math.ceil((high - low) / SPACING) + 1))
        for low, high in (
            (-0.5 * place.width, 0.5 * place.width),
            (-0.5 * place.length, 0.5 * place.length),
            (place.low, place.high),
        )
    )
    grid = np.stack(np.meshgrid(x, y, z, indexing="ij"), axis=-1).reshape(-1, 3)
    cos, sin = math.cos(place.heading), math.sin(place.heading)
    points = grid @ np.array([[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]]) + [*place.at, 0.0]
    shape = track.shape
    reach = shape.corners @ shape.normals.T
    low, high = reach.min(axis=0), reach.max(axis=0)
    fastest = 0.0
    # the way of a point is affine in its place: none of a piece goes farther than the corner that does most
    ways = track.corners(touching.places) - track.corners(touching.places - 1)
    farthest = np.linalg.norm(ways, axis=2).max(axis=1) * (1.0 + ROUNDING)
    for number in np.argsort(-farthest, kind="stable").tolist():
        if farthest[number] <= max(fastest, touching.closing * track.dt):
            break
        k = int(touching.places[number])
        seen = (points - track.place[k]) @ track.turn[k]
        along = seen @ shape.normals.T
        inside = ((along >= low) & (along <= high)).all(axis=1)
        if inside.any():
            before = seen[inside] @ track.turn[k - 1].T + track.place[k - 1]
            fastest = max(fastest, float(np.linalg.norm(points[inside] - before, axis=1).max()))
    return max(touching.closing, fastest / track.dt)


class RoomEventDetector:
    """Looks at what happens in runs of a room: who is hit, which doors are blocked, who is shut in.

    What a piece does to a place, and equal floors, are looked at once.
    """

    def __init__(self) -> None:
        self._grids: dict[str, WalkableGrid] = {}
        self._ends: dict[tuple[str, bytes], tuple[list[bool], list[bool]]] = {}
        self._covered: dict[int, tuple[Track, NDArray[np.bool_], NDArray[np.bool_]]] = {}
        self._contacts: dict[tuple[int, PersonPlace], tuple[Track, RoomContact | None]] = {}

    def __call__(self, plan: FloorPlan, tracks: Sequence[Track]) -> RoomEvents:
        """Return what happened in a run, where the pieces had these tracks."""
        hits = np.full((len(plan.places), len(tracks), len(RoomContact._fields)), np.nan)
        for at, place in enumerate(plan.places):
            for body, track in enumerate(tracks):
                if (id(track), place) not in self._contacts:
                    self._contacts[id(track), place] = track, contact_with_place(track, place)
                contact = self._contacts[id(track), place][1]
                if contact is not None:
                    hits[at, body] = contact
        blocked, shut_in = self.ends(plan, tracks)
        return RoomEvents(hits, np.array(blocked, np.bool_), np.array(shut_in, np.bool_))

    def ends(self, plan: FloorPlan, tracks: Sequence[Track]) -> tuple[list[bool], list[bool]]:
        """Return which doors are blocked and who is shut in where the pieces of a run come to lie."""
        name, grid = self.grid(plan)
        of_pieces = [self.covered_by(grid, track) for track in tracks]
        covered, near = np.zeros((2, len(grid.x), len(grid.y)), np.bool_)
        for cells, _ in of_pieces:
            covered |= cells
        key = name, np.packbits(covered).tobytes()
        if key not in self._ends:
            for _, cells in of_pieces:
                near |= cells
            self._ends[key] = grid.shut_in(covered, near)
        return self._ends[key]

    def grid(self, plan: FloorPlan) -> tuple[str, WalkableGrid]:
        """Return the floor of a room, and what it is known by."""
        name = repr(plan)
        if name not in self._grids:
            self._grids[name] = WalkableGrid(plan)
        return name, self._grids[name]

    def covered_by(self, grid: WalkableGrid, track: Track) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Return which cells of the floor a piece covers at the end of a run, and those too near to it."""
        if id(track) not in self._covered:  # the track is kept with it, so that the id stays its own
            covered = grid.covered([track.outline(len(track.sample) - 1)])
            self._covered[id(track)] = track, covered, grid.too_near(covered)
        return self._covered[id(track)][1:]


class Zones(NamedTuple):
    """Where a piece ends in a room.

    Parameters
    ----------
    fell, stood : ndarray, shape (nx, ny)
        Shares of the runs in which it ends on each cell of the floor having overturned, and without; see
        `WalkableGrid`.
    outline : ndarray, shape (n, 2)
        Its outline in plan as it stands [m].
    """

    fell: NDArray[np.float64]
    stood: NDArray[np.float64]
    outline: NDArray[np.float64]


def zones_of(
    runs: Runs, pieces: Sequence[Piece], detector: RoomEventDetector, plan: FloorPlan
) -> list[Zones | None]:
    """Return where each piece ends in runs; None where its tracks were not kept."""
    if not runs.tracks.size:
        return [None] * len(pieces)
    _, grid = detector.grid(plan)
    zones: list[Zones | None] = []
    for body, piece in enumerate(pieces):
        fell = runs.results[:, body]["outcome"] == OVERTURNED_OUTCOME
        counts = np.zeros((2, len(grid.x), len(grid.y)))
        for track, overturned in zip(runs.tracks[:, body], fell.tolist(), strict=True):
            counts[0 if overturned else 1] += detector.covered_by(grid, track)[0]
        zones.append(Zones(counts[0] / len(fell), counts[1] / len(fell), at_rest(piece).outline(0)))
    return zones


class RunInRoom(NamedTuple):
    """What happens in one run of a room.

    Parameters
    ----------
    hits : tuple of (str, str)
        Pieces that fall and the places of people that they come into.
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
    path = Path.of(run.place, run.attitude)
    tracks = groups.tracks_of(run.standing, run, run.motion.dt, path)
    seen = RoomEventDetector()(plan, tracks)
    return RunInRoom(
        tuple(
            (name, place.name)
            for place, hits in zip(plan.places, seen.hits, strict=True)
            for piece, name, hit in zip(run.pieces, run.names, hits, strict=True)
            if (piece.overturned or piece.fell_off) and hit[FALLS] == 1.0
        ),
        tuple(door.name for door, blocked in zip(plan.doors, seen.blocked, strict=True) if blocked),
        tuple(place.name for place, shut in zip(plan.places, seen.shut_in, strict=True) if shut),
    )
