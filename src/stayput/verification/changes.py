"""Changes of a room: a measure on a piece, another place for it, the bed elsewhere; and what fits where."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from stayput.errors import InputError, finite, instance_of, numbers
from stayput.measures import MEASURES, Measure
from stayput.measures.wall import REACH, WallDevice, most_on_studs
from stayput.model.floor_plan import FACING, FloorPlan, PersonPlace, rectangle
from stayput.scenario.measures import Moved, Option
from stayput.simulation.groups import outline_of
from stayput.simulation.piece import BEHIND, Piece, inside_each_other
from stayput.simulation.placing import placed
from stayput.simulation.space_engine import DEEPEST
from stayput.verification.events import PASSAGE

if TYPE_CHECKING:
    from stayput.scenario import Scenario
    from stayput.simulation.scene import Scene

FRAME = 0.05
"""Nearest to a door or a window that something is screwed to the wall [m]: there is its frame."""

STRIDE = 0.2
"""Distance between the places that are tried, in a room where they are no more than `MOST_SPREAD` [m]."""

MOST_SPREAD = 20
"""Most steps between places that are tried along a side: in a large room they are further apart."""


@dataclass(frozen=True, slots=True)
class Change:
    """A single change.

    Parameters
    ----------
    what : str
        The piece, or the place of a person.
    measure : Measure, optional
        What is put on the piece.
    at : tuple of float, optional
        Where it is moved to: its middle in plan [m].
    heading : float, optional
        What it faces there [rad].

    Raises
    ------
    InputError
        Something of another kind.
    """

    what: str
    measure: Measure | None = None
    at: tuple[float, float] | None = None
    heading: float | None = None

    def __post_init__(self) -> None:
        instance_of("what", self.what, str)
        if self.measure is not None:
            instance_of("measure", self.measure, Measure)
        if self.at is not None:
            for number in numbers("at", self.at, "at", 2).tolist():
                finite("at", number, "at")
        if self.heading is not None:
            finite("heading", self.heading, "heading")


@dataclass(frozen=True, eq=False)
class FreeFloor:
    """Where something may be put in a room as it is furnished.

    Parameters
    ----------
    plan : FloorPlan
        The room.
    pieces : sequence of Piece
        The pieces as they stand.
    """

    plan: FloorPlan
    pieces: Sequence[Piece]

    def fits(
        self,
        corners: NDArray[np.float64],
        *,
        height: float,
        but_piece: int | None = None,
        but_place: str = "",
    ) -> bool:
        """Return whether something with a convex outline may be put there.

        It may not be in a wall, in a piece or a person's place, before a door, or before a window whose sill
        it is higher than; nor leave no passage along a long side of a bed, unless the bed has none now.

        Parameters
        ----------
        corners : ndarray, shape (n, 2)
            Its outline, counter-clockwise [m].
        height : float
            Its height [m].
        but_piece : int, optional
            A piece that does not count: that which is moved.
        but_place : str
            A place that does not count.
        """
        if (corners < -1e-9).any() or (corners > np.array([self.plan.width, self.plan.length]) + 1e-9).any():
            return False
        solid = [outline for number, outline in enumerate(self._outlines) if number != but_piece]
        taken = [*solid, *(place.corners for place in self.plan.places if place.name != but_place)]
        taken += [
            _before(self.plan, door.wall, door.start, door.width, door.width) for door in self.plan.doors
        ]
        taken += [
            _before(self.plan, window.wall, window.start, window.width, BEHIND)
            for window in self.plan.windows
            if height > window.sill
        ]
        if any(overlap(corners, other) for other in taken):
            return False
        beds, needed = self._beds, self._with_passage_now
        if but_place in beds:
            beds, needed = {**beds, but_place: corners}, {*needed, but_place}
        elif not but_place:
            solid.append(corners)
        return self._with_passage(beds, solid) >= needed

    @cached_property
    def _outlines(self) -> list[NDArray[np.float64]]:
        """What the pieces cover as they stand."""
        return [
            outline_of(piece.solid.vertices @ piece.turn.T + np.asarray(piece.at)) for piece in self.pieces
        ]

    @cached_property
    def _beds(self) -> dict[str, NDArray[np.float64]]:
        """What people lie or sit on that takes the floor, by name."""
        return {place.name: place.corners for place in self.plan.places if place.blocks}

    @cached_property
    def _with_passage_now(self) -> set[str]:
        return self._with_passage(self._beds, self._outlines)

    def _with_passage(
        self, beds: Mapping[str, NDArray[np.float64]], solid: Sequence[NDArray[np.float64]]
    ) -> set[str]:
        """Return which of the beds have a free passage along one of their long sides."""
        room = np.array([self.plan.width, self.plan.length])

        def free(strip: NDArray[np.float64], but: str) -> bool:
            others = [*solid, *(bed for name, bed in beds.items() if name != but)]
            inside = (strip >= -1e-9).all() and (strip <= room + 1e-9).all()
            return bool(inside) and not any(overlap(strip, other) for other in others)

        return {name for name, bed in beds.items() if any(free(strip, name) for strip in passages(bed))}


def passages(bed: NDArray[np.float64]) -> Iterator[NDArray[np.float64]]:
    """Yield the floor along the long sides of a bed that a person needs to get up and walk there [m]."""
    sides = np.roll(bed, -1, axis=0) - bed
    lengths = np.hypot(*sides.T)
    for start, side, length in zip(bed, sides, lengths, strict=True):
        if length >= lengths.max() - 1e-9:
            out = PASSAGE / length * np.array([side[1], -side[0]])
            yield np.array([start, start + out, start + out + side, start + side])


def _before(plan: FloorPlan, wall: str, start: float, width: float, depth: float) -> NDArray[np.float64]:
    """Return the rectangle of the floor before an opening."""
    ends = [plan.on_wall(wall, along, into) for along in (start, start + width) for into in (0.0, depth)]
    (x_low, y_low), (x_high, y_high) = np.min(ends, axis=0), np.max(ends, axis=0)
    return rectangle((0.5 * (x_low + x_high), 0.5 * (y_low + y_high)), x_high - x_low, y_high - y_low)


def overlap(first: NDArray[np.float64], second: NDArray[np.float64]) -> bool:
    """Return whether two convex outlines overlap by more than rounding."""
    if ((first.min(axis=0) >= second.max(axis=0)) | (second.min(axis=0) >= first.max(axis=0))).any():
        return False  # the rectangles around most pairs are apart, which is told faster
    for corners in (first, second):
        sides = np.roll(corners, -1, axis=0) - corners
        outwards = np.column_stack((sides[:, 1], -sides[:, 0]))
        outwards /= np.linalg.norm(outwards, axis=1)[:, np.newaxis]
        other = second if corners is first else first
        apart = (other @ outwards.T).min(axis=0) - np.einsum("ij,ij->i", corners, outwards)
        if (apart >= -1e-6).any():
            return False
    return True


def changes_in(option: Option, base: Option, names: Sequence[str]) -> tuple[Change, ...]:
    """Return what an option changes of another one: measures on pieces, and what is moved."""
    fixed = [
        Change(name, measure)
        for name, now, was in zip(names, option.on, base.on, strict=True)
        for number, measure in enumerate(now)
        if now[: number + 1].count(measure) > was.count(measure)
    ]
    moved = (Change(move.what, at=move.at, heading=move.heading) for move in option.moved)
    return *fixed, *moved


def with_changes(option: Option, changes: Iterable[Change], names: Sequence[str]) -> Option:
    """Return an option with changes, called by what they are."""
    on, moved, parts = [*option.on], [*option.moved], list[str]()
    for change in changes:
        if change.measure is not None:
            body = names.index(change.what)
            on[body] = (*on[body], change.measure)
            parts.append(f"{change.measure.kind} on {change.what}")
        else:
            assert change.at is not None
            assert change.heading is not None
            moved = [move for move in moved if move.what != change.what]
            moved.append(Moved(change.what, change.at, change.heading))
            parts.append(f"{change.what} at ({change.at[0]:g}, {change.at[1]:g}), {change.heading:.3g} rad")
    return replace(option, name=" + ".join(parts), on=tuple(on), moved=tuple(moved))


def loose_pieces(scenario: Scenario) -> set[int]:
    """Return the pieces that neither stand on, bear nor are joined to others."""
    names, pieces = scenario.names, scenario.pieces
    bonds = [(number, names.index(piece.on)) for number, piece in enumerate(pieces) if piece.on]
    bonds += [(names.index(joint.first), names.index(joint.second)) for joint in scenario.joints]
    return set(range(len(pieces))) - {number for bond in bonds for number in bond}


def measures_for(kinds: Sequence[str], scene: Scene, body: int) -> tuple[Measure, ...]:
    """Return measures as they are tried on a piece: on a wall with studs no more than one device on each."""
    on_studs = scene.plan is not None and scene.plan.walls == "stud"
    most = most_on_studs(scene.pieces[body].body.length or 0.0)
    measures = (MEASURES[kind]() for kind in kinds)
    return tuple(
        replace(measure, count=min(measure.count, most))
        if on_studs and isinstance(measure, WallDevice)
        else measure
        for measure in measures
    )


def refuse_unheld(scene: Scene, body: int) -> None:
    """Raise `InputError` where the measures of a scene cannot be put in place, those of a piece on a wall.

    A device on a wall needs one within `REACH`, with no door or window where it is screwed on.

    Parameters
    ----------
    scene : Scene
        The pieces, as they would be held.
    body : int
        Which of them.
    """
    (on_it,) = placed(scene.part([body]))
    held = on_it.held
    assert held is not None
    others = (piece for number, piece in enumerate(scene.pieces) if number != body)
    if any(inside_each_other(on_it.piece, piece) > DEEPEST for piece in others):
        raise InputError("rooms.leans_into", "measures")
    on_wall = {measure.kind for measure in held.measures if measure.drilled}
    if not on_wall:
        return
    wall_behind = held.room.left_wall
    if wall_behind is None or wall_behind.gap > REACH:
        raise InputError("rooms.wall_too_far", "measures", most=REACH)
    member, plan = scene.pieces[body], scene.plan
    assert plan is not None
    wall = wall_faced(member.heading)
    axis = 1 if wall in ("left_wall", "right_wall") else 0
    across = (-math.sin(member.heading), math.cos(member.heading))[axis]
    for element in held.elements:
        along = member.at[axis] + across * element.across
        height = member.at[2] + element.point[1] + element.rise
        if element.kind in on_wall and _in_an_opening(plan, wall, along, height):
            raise InputError("rooms.at_an_opening", "measures")


def wall_faced(heading: float) -> str:
    """Return the wall to which something that faces a direction [rad] has its back."""
    return min(FACING, key=lambda name: abs(math.remainder(FACING[name] - heading, 2.0 * math.pi)))


def _in_an_opening(plan: FloorPlan, wall: str, along: float, height: float) -> bool:
    """Return whether a point of a wall is in or at a door or a window, whose upper edges are not known."""
    openings = [(door, 0.0) for door in plan.doors] + [(window, window.sill) for window in plan.windows]
    return any(
        opening.wall == wall
        and height > low - FRAME
        and opening.start - FRAME < along < opening.start + opening.width + FRAME
        for opening, low in openings
    )


def places_at_walls(
    whole: Scene, body: int, floor: FreeFloor
) -> Iterator[tuple[str, list[tuple[float, float]]]]:
    """Yield the walls to which a piece may stand, and where its middle may be.

    Parameters
    ----------
    whole : Scene
        All pieces, as stated.
    body : int
        The piece.
    floor : FreeFloor
        Where it may be put.
    """
    solid, plan = whole.pieces[body].solid, floor.plan
    half_depth, half_length = (0.5 * np.ptp(solid.vertices[:, :2], axis=0)).tolist()
    height = float(solid.vertices[:, 2].max())
    for wall, heading in FACING.items():
        places: list[tuple[float, float]] = []
        # as far from a wall beside it as from that behind it, where the skirting board ends
        for along in _spread(half_length + BEHIND, plan.side(wall) - half_length - BEHIND):
            at = plan.on_wall(wall, along, half_depth + BEHIND)
            corners = rectangle(at, 2.0 * half_depth, 2.0 * half_length, heading)
            if floor.fits(corners, height=height, but_piece=body):
                places.append(at)
        if places:
            yield wall, places


def _spread(low: float, high: float) -> list[float]:
    """Return places from low to high, `STRIDE` apart or more; none where high is below low."""
    if high < low:
        return []
    steps = min(MOST_SPREAD, max(1, math.ceil((high - low) / STRIDE)))
    return np.linspace(low, high, steps + 1).tolist()


def other_places(place: PersonPlace, floor: FreeFloor) -> list[PersonPlace]:
    """Return where else the place of a person may be: at the same height, turned by 90° or not.

    Parameters
    ----------
    place : PersonPlace
        The place.
    floor : FreeFloor
        Where it may be put.
    """
    places: list[PersonPlace] = []
    for heading in (place.heading, place.heading + math.pi / 2.0):
        half_x, half_y = (
            0.5 * np.ptp(rectangle((0.0, 0.0), place.width, place.length, heading), axis=0)
        ).tolist()
        for x in _spread(half_x, floor.plan.width - half_x):
            for y in _spread(half_y, floor.plan.length - half_y):
                corners = rectangle((x, y), place.width, place.length, heading)
                if floor.fits(corners, height=place.high, but_place=place.name):
                    places.append(replace(place, at=(x, y), heading=math.remainder(heading, 2.0 * math.pi)))
    return places
