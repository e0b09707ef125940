"""`FloorPlan`: a room seen from above, with its doors and windows, and the places where people are.

x goes from the left wall to the right one, y from the near wall to the far one, as in `stayput.Room`; the
origin is the corner of the left and the near wall.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput import errors
from stayput.catalogue import Phrase, phrase
from stayput.model.parameters import check_fields, choice, parameter, quantity
from stayput.model.room import WALLS, WALLS_AROUND
from stayput.wording import name_quoted

ROOM_SIZE = (0.5, 30.0)
"""Least and largest side of a room [m]."""

HINGES = ("start", "end")
"""At which end of a door, along its wall, the hinge is."""

OPENS = ("inwards", "outwards", "sliding")
"""How a door opens."""

MOST_PLACES = 50
"""Most doors, windows or places of a room."""


class PlacePreset(NamedTuple):
    """A common place of a person.

    Parameters
    ----------
    width, length : float
        Sides [m].
    low, high : float
        Heights above the floor between which the person is [m].
    day, night : float
        Shares of the day and of the night in which somebody is there.
    blocks : bool
        Whether what the person lies or sits on takes the floor, so that nobody walks there.
    """

    width: float
    length: float
    low: float
    high: float
    day: float
    night: float
    blocks: bool


PLACES: dict[str, PlacePreset] = {
    "bed": PlacePreset(1.0, 2.0, 0.45, 0.75, 0.0, 1.0, True),
    "futon": PlacePreset(1.0, 2.0, 0.0, 0.3, 0.0, 1.0, False),
    "cot": PlacePreset(0.7, 1.25, 0.4, 0.7, 0.5, 1.0, True),
    "desk": PlacePreset(0.6, 0.6, 0.0, 1.25, 0.3, 0.0, False),
    "sofa": PlacePreset(0.8, 1.5, 0.4, 1.2, 0.3, 0.0, True),
    "play area": PlacePreset(1.5, 1.5, 0.0, 1.0, 0.3, 0.0, False),
}
"""Places by kind: conventions of this program, to be changed."""

PLACE_NAMES: dict[str, Phrase] = {kind: phrase(f"rooms.{kind}") for kind in PLACES}
"""What places by kind are called."""

DOOR_HEIGHT = 1.8
"""A window whose sill is so high may be above a door [m]."""

_WALL = quantity("", 0.0, 0.0, phrase("rooms.wall"), choices=WALLS_AROUND)
_ALONG = quantity("m", 0.0, ROOM_SIZE[1], ("start", "始まり"))
_OPENING = quantity("m", 0.1, 20.0, ("width", "幅"))


@dataclass(frozen=True, slots=True)
class Door:
    """A door in one of the walls.

    Parameters
    ----------
    wall : str, a field of `stayput.Room`
        The wall that it is in.
    start : float
        Where it begins along the wall, from the corner at the lower x or y [m].
    width : float
        Clear width [m].
    hinge : str, one of `HINGES`
        At which end of it, along the wall, the hinge is.
    opens : str, one of `OPENS`
        How it opens.
    way_out : bool
        Whether it leads out.
    name : str
        What it is called.

    Raises
    ------
    InputError
        A number out of range, or a word that is not known.

    Examples
    --------
    >>> import stayput as sp
    >>> try:
    ...     sp.FloorPlan(3.6, 2.7, [sp.Door("right_wall", start=2.2, width=0.8)])
    ... except sp.InputError as error:
    ...     print(error)
    The opening ends at 3 m along its wall; it must be at most 2.7 m, where the wall ends.
    """

    wall: str = field(metadata=_WALL)
    start: float = field(metadata=_ALONG)
    width: float = field(metadata=_OPENING)
    hinge: str = choice(HINGES[0], HINGES, phrase("rooms.hinge"))
    opens: str = choice(OPENS[0], OPENS, phrase("rooms.opens"))
    way_out: bool = True
    name: str = "door"

    def __post_init__(self) -> None:
        errors.instance_of("way_out", self.way_out, bool)
        errors.name_of("name", self.name)
        check_fields(self)


@dataclass(frozen=True, slots=True)
class Window:
    """A window in one of the walls: nothing that is higher than its sill is moved in front of it.

    Parameters
    ----------
    wall : str, a field of `stayput.Room`
        The wall that it is in.
    start : float
        Where it begins along the wall, from the corner at the lower x or y [m].
    width : float
        Clear width [m].
    sill : float
        Height of its lower edge [m].

    Raises
    ------
    InputError
        A number out of range, or a wall that is not known.

    Examples
    --------
    >>> import stayput as sp
    >>> sp.Window("far_side_wall", start=0.5, width=1.6).sill
    0.8
    """

    wall: str = field(metadata=_WALL)
    start: float = field(metadata=_ALONG)
    width: float = field(metadata=_OPENING)
    sill: float = parameter(0.8, "m", 0.0, 10.0, ("sill", "窓の下端の高さ"))

    def __post_init__(self) -> None:
        check_fields(self)


_SIDE = quantity("m", 0.1, 20.0, ("side", "辺の長さ"))
_HEIGHT = quantity("m", 0.0, 10.0, ("height", "高さ"))
_SHARE = quantity("", 0.0, 1.0, ("share", "割合"))


@dataclass(frozen=True, slots=True)
class PersonPlace:
    """Where a person is: a box above a rectangle of the floor.

    Parameters
    ----------
    name : str
        What it is called.
    at : tuple of float
        The middle of the rectangle: x and y [m].
    width, length : float
        Its sides along its own x and y [m].
    low, high : float
        Heights above the floor between which the person is [m].
    heading : float
        By what it is turned, from x towards y [rad]. The head of a bed is at −y of its own frame.
    day, night : float
        Shares of the day and of the night in which somebody is there.
    blocks : bool
        Whether what the person lies or sits on takes the floor, so that nobody walks there.

    Raises
    ------
    InputError
        A number out of range, or heights in the wrong order.

    Examples
    --------
    >>> from math import pi
    >>> import stayput as sp
    >>> bed = sp.PersonPlace.of("bed", at=(1.4, 1.9), heading=pi / 2)
    >>> bed.low, bed.high  # between which heights somebody lies [m]
    (0.45, 0.75)
    >>> bed.corners.round(2).tolist()  # m
    [[2.4, 1.4], [2.4, 2.4], [0.4, 2.4], [0.4, 1.4]]
    """

    name: str
    at: tuple[float, float]
    width: float = field(metadata=_SIDE)
    length: float = field(metadata=_SIDE)
    low: float = field(metadata=_HEIGHT)
    high: float = field(metadata=_HEIGHT)
    heading: float = parameter(0.0, "rad", -2.0 * math.pi, 2.0 * math.pi, ("heading", "向き"))
    day: float = field(default=1.0, metadata=_SHARE)
    night: float = field(default=1.0, metadata=_SHARE)
    blocks: bool = False

    def __post_init__(self) -> None:
        errors.name_of("name", self.name)
        errors.instance_of("blocks", self.blocks, bool)
        check_fields(self)
        if not self.low < self.high:
            raise errors.InputError("rooms.heights_in_order", "high", low=self.low, high=self.high)
        at = errors.numbers("rooms.at", self.at, "at", count=2)
        x, y = (
            errors.within("rooms.at", value, -ROOM_SIZE[1], ROOM_SIZE[1], "m", "at") for value in at.tolist()
        )
        object.__setattr__(self, "at", (x, y))

    @classmethod
    def of(
        cls, kind: str, at: tuple[float, float], heading: float = 0.0, name: str | None = None
    ) -> PersonPlace:
        """Make a place of one of the kinds of `PLACES`, called by its kind unless it has a name."""
        preset = PLACES[errors.word_of("rooms.kind", kind, PLACES, "kind")]
        return cls(name or kind, at, heading=heading, **preset._asdict())

    @property
    def corners(self) -> NDArray[np.float64]:
        """Its corners in plan, counter-clockwise [m], shape (4, 2)."""
        return rectangle(self.at, self.width, self.length, self.heading)


def rectangle(
    middle: tuple[float, float], width: float, length: float, heading: float = 0.0
) -> NDArray[np.float64]:
    """Return the corners of a turned rectangle, counter-clockwise [m], shape (4, 2)."""
    half = 0.5 * np.array([[-width, -length], [width, -length], [width, length], [-width, length]])
    cos, sin = math.cos(heading), math.sin(heading)
    return half @ np.array([[cos, sin], [-sin, cos]]) + np.asarray(middle)


@dataclass(frozen=True, slots=True)
class FloorPlan:
    """A rectangular room seen from above.

    Parameters
    ----------
    width, length : float
        Its sides along x and y [m].
    doors : sequence of Door
        Its doors.
    windows : sequence of Window
        Its windows.
    places : sequence of PersonPlace
        Where people are.
    walls : str
        What devices on the walls are fixed to, of `stayput.model.room.WALLS`.

    Raises
    ------
    InputError
        A number out of range, an opening beyond its wall, a place outside, or two of one name.

    Examples
    --------
    >>> import stayput as sp
    >>> plan = sp.FloorPlan(width=3.6, length=2.7, doors=[sp.Door("right_wall", 0.2, 0.8)])
    >>> free = plan.distances([0.5, 0.5], [1.0, 1.5])  # of a piece from (0.5, 0.5) to (1.0, 1.5) [m]
    >>> {wall: round(distance, 2) for wall, distance in free.items()}
    {'left_wall': 0.5, 'right_wall': 2.6, 'near_side_wall': 0.5, 'far_side_wall': 1.2}
    """

    width: float = field(metadata=quantity("m", *ROOM_SIZE, ("room width", "部屋の幅（x方向）")))
    length: float = field(metadata=quantity("m", *ROOM_SIZE, ("room length", "部屋の奥行き（y方向）")))
    doors: Sequence[Door] = ()
    windows: Sequence[Window] = ()
    places: Sequence[PersonPlace] = ()
    walls: str = choice(WALLS[0], WALLS, ("Wall construction", "壁の下地"))

    def __post_init__(self) -> None:
        for name, kind in (("doors", Door), ("windows", Window), ("places", PersonPlace)):
            object.__setattr__(self, name, errors.list_of(name, getattr(self, name), kind))
        check_fields(self)
        for kind, items in (("doors", self.doors), ("windows", self.windows), ("places", self.places)):
            if len(items) > MOST_PLACES:
                raise errors.too_many(kind, len(items), "common.items", MOST_PLACES, kind)
        for kind, items in (("doors", self.doors), ("windows", self.windows)):
            for number, item in enumerate(items):
                end, most = item.start + item.width, self.side(item.wall)
                if end > most + 1e-9:
                    raise errors.InputError("rooms.beyond_wall", f"{kind}[{number}]", end=end, most=most)
        self._refuse_overlaps()
        for kind, items in (("doors", self.doors), ("places", self.places)):
            errors.refuse_same_names(kind, [item.name for item in items])
        for number, place in enumerate(self.places):
            low, high = place.corners.min(axis=0), place.corners.max(axis=0)
            if (low < -1e-6).any() or (high > np.array([self.width, self.length]) + 1e-6).any():
                raise errors.InputError(
                    "rooms.outside",
                    f"places[{number}].at",
                    name=name_quoted(place.name, PLACE_NAMES),
                    width=self.width,
                    length=self.length,
                )

    def _refuse_overlaps(self) -> None:
        """Refuse two openings at one place of a wall; a window may be above a door."""
        openings: list[tuple[str, Door | Window, float, float]] = []
        openings += [(f"doors[{n}]", door, 0.0, DOOR_HEIGHT) for n, door in enumerate(self.doors)]
        openings += [(f"windows[{n}]", pane, pane.sill, math.inf) for n, pane in enumerate(self.windows)]
        for (name, first, low, high), (other, second, bottom, top) in combinations(openings, 2):
            start = max(first.start, second.start)
            end = min(first.start + first.width, second.start + second.width)
            if first.wall == second.wall and end - start > 1e-9 and low < top and bottom < high:
                raise errors.InputError(
                    "rooms.openings_overlap", other, name=other, other=name, overlap=end - start
                )

    def with_places(self, others: Mapping[int, PersonPlace]) -> FloorPlan:
        """Return the same with other places of persons in the place of those of some numbers."""
        places = [others.get(number, place) for number, place in enumerate(self.places)]
        return replace(self, places=places)

    def side(self, wall: str) -> float:
        """Return how long a wall is [m]."""
        return self.length if wall in ("left_wall", "right_wall") else self.width

    def on_wall(self, wall: str, along: float, into: float = 0.0) -> tuple[float, float]:
        """Return the point of the plan that is so far along a wall, and so far from it into the room [m]."""
        return {
            "left_wall": (into, along),
            "right_wall": (self.width - into, along),
            "near_side_wall": (along, into),
            "far_side_wall": (along, self.length - into),
        }[wall]

    def distances(self, low: NDArray[np.float64], high: NDArray[np.float64]) -> dict[str, float]:
        """Return how far what reaches from ``low`` to ``high`` in plan is from each wall [m]."""
        return {
            "left_wall": float(low[0]),
            "right_wall": float(self.width - high[0]),
            "near_side_wall": float(low[1]),
            "far_side_wall": float(self.length - high[1]),
        }


FACING = {
    "left_wall": 0.0,
    "near_side_wall": math.pi / 2.0,
    "right_wall": math.pi,
    "far_side_wall": -math.pi / 2.0,
}
"""Heading of a piece whose back is to a wall [rad]."""
