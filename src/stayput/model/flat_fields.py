"""A case as flat fields (numbers by their dotted paths), and as the rows that the mechanics read."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from stayput.errors import InputError, within
from stayput.mechanics.columns import CASE
from stayput.model.body import Body
from stayput.model.parameters import GRAVITY, STANDARD_GRAVITY, Parameter, parameters
from stayput.model.polyhedron import moments_of_furniture
from stayput.model.room import WALLS_AROUND, Ceiling, Floor, Room, Wall
from stayput.model.soft_base import landing_factor, narrower_base, rigid_half_base
from stayput.model.state import State, refuse_bad_start

NumberOrColumn: TypeAlias = "float | NDArray[np.float64]"


PAIRS = {"cg_offset": ("x", "z"), "base_heights": ("left", "right"), "base_insets": ("left", "right")}
"""Fields of two numbers, and the words that name each in its path."""

KINDS: dict[str, type] = {
    "body": Body,
    "room.floor": Floor,
    **{f"room.{wall}": Wall for wall in WALLS_AROUND},
    "room.ceiling": Ceiling,
    "initial": State,
}
"""What numbers belong to, by the beginnings of their paths."""

SCALE = Parameter("motion.scale", 1.0, "", -1e6, 1e6, ("Scale of the motion", "地震動の倍率"))


@cache
def _paths(path: str, kind: type) -> tuple[tuple[Parameter, tuple[str, ...]], ...]:
    """Return the fields of what numbers belong to, and the paths of the numbers of each: of a pair two."""
    each = ((about, f"{path}.{about.name}", PAIRS.get(about.name, ())) for about in parameters(kind))
    return tuple((about, tuple(f"{name}.{word}" for word in words) or (name,)) for about, name, words in each)


UNITS = {GRAVITY.name: GRAVITY.unit} | {
    name: about.unit for path, kind in KINDS.items() for about, names in _paths(path, kind) for name in names
}
"""Units by path."""


def unit_of(path: str) -> str:
    """Return the unit of a path's numbers in ASCII, empty where they have none."""
    return UNITS.get(path, "").replace("²", "2")


def fields_of(path: str, value: Body | Room | Floor | Wall | Ceiling | State | None) -> dict[str, float]:
    """Return the numbers of a value by their paths, which begin with its own.

    One that follows from others, None, is NaN; a word is its place among its choices. A wall or a ceiling
    that is None is far away.
    """
    if isinstance(value, Room):
        numbers_at = dict[str, float]()
        for name in ("floor", *WALLS_AND_CEILING):
            numbers_at |= fields_of(f"{path}.{name}", getattr(value, name))
        return numbers_at
    if value is None:
        return {**_far_away(path)}
    numbers_at = dict[str, float]()
    for about, names in _paths(path, type(value)):
        content: Any = getattr(value, about.name)
        if about.name in PAIRS:
            numbers_at |= zip(names, content, strict=True)
        elif about.choices:
            numbers_at[names[0]] = about.choices.index(content)
        else:
            numbers_at[names[0]] = math.nan if content is None else content
    return numbers_at


@cache
def _far_away(path: str) -> dict[str, float]:
    """Return the numbers of a wall or a ceiling that is not there."""
    name = path.removeprefix("room.")
    none = Ceiling(1.0) if name == "ceiling" else Wall(0.0)
    return fields_of(path, none) | {distance_to(name): math.inf}


def distance_to(name: str) -> str:
    """Return the path of how far a wall or the ceiling is, infinite for none."""
    return f"room.{name}.{'height' if name == 'ceiling' else 'gap'}"


WALLS_AND_CEILING = (*WALLS_AROUND, "ceiling")
"""What a room may have beside its floor, by the names in `Room`."""


def from_flat_fields(numbers: Mapping[str, float]) -> tuple[Body, Room, State]:
    """Return the body, the room and the initial state of numbers by path; the inverse of `flat_fields`.

    Raises
    ------
    InputError
        Numbers that make no body, room or state, or a body that stands inside a wall or the ceiling.
    """
    surfaces = {
        name: None if numbers[distance_to(name)] == math.inf else _made(f"room.{name}", numbers)
        for name in WALLS_AND_CEILING
    }
    body, start = _made("body", numbers), _made("initial", numbers)
    room = Room(_made("room.floor", numbers), **surfaces)
    for about in (GRAVITY, SCALE):
        about.check(numbers[about.name])
    refuse_bad_start(body, room, start)
    return body, room, start


def _made(path: str, numbers: Mapping[str, float]) -> Any:
    """Return the value that numbers belong to; the inverse of `fields_of`."""
    stated: dict[str, Any] = {}
    for about, names in _paths(path, KINDS[path]):
        values = tuple(numbers[name] for name in names)
        if about.name in PAIRS:
            stated[about.name] = values
        elif about.choices:
            stated[about.name] = _word(about, values[0])
        elif about.default is not None or not math.isnan(values[0]):
            stated[about.name] = values[0]
    return KINDS[path](**stated)


def _word(about: Parameter, place: float) -> str:
    """Return the word at a place among its choices."""
    last = len(about.choices) - 1
    return about.choices[int(within(about.label, place, 0, last, "", about.name))]


def flat_fields(body: Body, room: Room, start: State, gravity: float) -> dict[str, float]:
    """Return all numbers of a case by their dotted paths; the factor on the motion is 1.

    Raises
    ------
    InputError
        A body of another shape than its section has.
    """
    if body.shape is not None:
        raise InputError("model.another_shape", "body")
    return {
        **fields_of("body", body),
        **fields_of("room", room),
        **fields_of("initial", start),
        "gravity": gravity,
        "motion.scale": 1.0,
    }


def case_rows(numbers: Mapping[str, NumberOrColumn], count: int) -> NDArray[np.void]:
    """Return ``count`` rows of `CASE` from numbers by path, each one value or ``count`` of them."""
    rows = np.zeros(count, CASE)
    _fill_in_room(rows, numbers)
    b, h, m = numbers["body.width"], numbers["body.height"], numbers["body.mass"]
    inertia = numbers["body.inertia"]
    rows["inertia"] = np.where(np.isnan(inertia), m * (b**2 + h**2) / 12.0, inertia) / m
    settlement = numbers["room.floor.settlement"]
    x_g, z_g = numbers["body.cg_offset.x"], h / 2 + numbers["body.cg_offset.z"]
    left, right, top = -b / 2 - x_g, b / 2 - x_g, h - z_g
    (foot_left, low), (foot_right, high) = narrower_base(
        (left + numbers["body.base_insets.left"], right - numbers["body.base_insets.right"]),
        (numbers["body.base_heights.left"], numbers["body.base_heights.right"]),
        z_g,
        settlement,
    )
    corners = (foot_left, low - z_g), (foot_right, high - z_g), (left, top), (right, top)
    for corner, (u, v) in enumerate(corners):
        rows["u"][:, corner], rows["v"][:, corner] = u, v
    for about in parameters(State):
        rows[about.name] = numbers[f"initial.{about.name}"]
    rows["floor_restitution"] = rows["restitution"]
    rows["restitution"] *= landing_factor(
        numbers["room.floor.landing_place"], -foot_left * foot_right, z_g, rows["inertia"]
    )
    length = numbers["body.length"]
    rows["mass"], rows["length"] = m, length
    rows["half_base"] = rigid_half_base(length / 2, z_g, settlement)
    rows["roll_inertia"], _, rows["yaw_inertia"] = moments_of_furniture(b, length, h, rows["inertia"])
    rows["base"] = numbers["body.base"]
    rows["gravity"], rows["scale"] = numbers["gravity"], numbers["motion.scale"]
    return rows


def _fill_in_room(rows: NDArray[np.void], numbers: Mapping[str, NumberOrColumn]) -> None:
    """Write the columns of rows of `CASE` that a room gives by itself."""
    for about in parameters(Floor):
        if about.name in (CASE.names or ()):
            rows[about.name] = numbers[f"room.floor.{about.name}"]
    for name in ("static_friction", "kinetic_friction"):
        edge = numbers[f"room.floor.edge_{name}"]
        rows[f"edge_{name}"] = np.where(np.isnan(edge), numbers[f"room.floor.{name}"], edge)
    for name in WALLS_AND_CEILING:
        column = name.removesuffix("_wall")
        rows[f"{column}_distance"] = numbers[distance_to(name)]
        rows[f"{column}_restitution"] = numbers[f"room.{name}.restitution"]
        rows[f"{column}_friction"] = numbers[f"room.{name}.friction"]


def room_row(room: Room) -> np.void:
    """Return a row of `CASE` of a room without a body."""
    row = np.zeros(1, CASE)
    _fill_in_room(row, fields_of("room", room))
    row["floor_restitution"] = row["restitution"]
    return row[0]


def case_columns(body: Body, room: Room, start: State, gravity: float) -> NDArray[np.void]:
    """Return one row of `CASE`, shape [1]; the factor on the motion is 1."""
    return case_rows(flat_fields(body, room, start, gravity), 1)


def row_alone(body: Body) -> np.void:
    """Return the row of `CASE` of a body at rest on a floor that does not give way, far from walls."""
    return case_columns(body, Room(), State(), STANDARD_GRAVITY)[0]
