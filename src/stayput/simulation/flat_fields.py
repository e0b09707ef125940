"""A case as flat fields (numbers by their dotted paths), and as the rows that the mechanics read."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from stayput.errors import within
from stayput.mechanics.columns import CASE
from stayput.model.body import Body
from stayput.model.room import Ceiling, Floor, Room, Wall
from stayput.model.state import State, refuse_bad_start

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

NumberOrColumn: TypeAlias = "float | NDArray[np.float64]"


def body_fields(body: Body) -> dict[str, float]:
    """Return a body's numbers by their paths; an inertia that follows from the section is NaN."""
    return {
        "body.width": body.width,
        "body.height": body.height,
        "body.mass": body.mass,
        "body.inertia": math.nan if body.inertia is None else body.inertia,
        "body.cg_offset.x": body.cg_offset[0],
        "body.cg_offset.z": body.cg_offset[1],
        "body.base_heights.left": body.base_heights[0],
        "body.base_heights.right": body.base_heights[1],
    }


OWN_FRICTION = tuple(
    f"{side}_edge_{kind}_friction" for side in ("left", "right") for kind in ("static", "kinetic")
)
"""Names of the coefficients of one base corner alone."""


def _nan_for_none(value: float | None) -> float:
    return math.nan if value is None else value


def floor_fields(floor: Floor) -> dict[str, float]:
    """Return a floor's numbers by their paths; an edge's friction that is the base's is NaN."""
    return {
        "room.floor.static_friction": floor.static_friction,
        "room.floor.kinetic_friction": floor.kinetic_friction,
        "room.floor.edge_static_friction": _nan_for_none(floor.edge_static_friction),
        "room.floor.edge_kinetic_friction": _nan_for_none(floor.edge_kinetic_friction),
        **{f"room.floor.{name}": _nan_for_none(getattr(floor, name)) for name in OWN_FRICTION},
        "room.floor.restitution": floor.restitution,
        "room.floor.normal_restitution": floor.normal_restitution,
    }


def surface_fields(name: str, surface: Wall | Ceiling | None) -> dict[str, float]:
    """Return the numbers of ``left_wall``, ``right_wall`` or ``ceiling``; far away where there is none."""
    distance = "height" if name == "ceiling" else "gap"
    if surface is None:
        surface = Wall(0.0)
        place = math.inf
    else:
        place = surface.height if isinstance(surface, Ceiling) else surface.gap
    return {
        f"room.{name}.{distance}": place,
        f"room.{name}.restitution": surface.restitution,
        f"room.{name}.friction": surface.friction,
    }


WALLS_AND_CEILING = ("left_wall", "right_wall", "ceiling")


def room_fields(room: Room) -> dict[str, float]:
    """Return a room's numbers by their paths."""
    numbers = floor_fields(room.floor)
    for name in WALLS_AND_CEILING:
        numbers |= surface_fields(name, getattr(room, name))
    return numbers


def from_flat_fields(numbers: Mapping[str, float]) -> tuple[Body, Room, State]:
    """Return the body, the room and the initial state of numbers by path; the inverse of `flat_fields`.

    Raises
    ------
    InputError
        Numbers that make no body, room or state, or a body that stands inside a wall or the ceiling.
    """

    def number_or_none(path: str) -> float | None:
        return None if math.isnan(numbers[path]) else numbers[path]

    def part(prefix: str, *names: str) -> list[float]:
        return [numbers[f"{prefix}.{name}"] for name in names]

    def surface(name: str, kind: type[Wall] | type[Ceiling]) -> Wall | Ceiling | None:
        distance = "height" if kind is Ceiling else "gap"
        values = part(f"room.{name}", distance, "restitution", "friction")
        return None if values[0] == math.inf else kind(*values)

    body = Body(
        *part("body", "width", "height", "mass"),
        cg_offset=(numbers["body.cg_offset.x"], numbers["body.cg_offset.z"]),
        inertia=number_or_none("body.inertia"),
        base_heights=(numbers["body.base_heights.left"], numbers["body.base_heights.right"]),
    )
    floor = Floor(
        *part("room.floor", "static_friction", "kinetic_friction"),
        edge_static_friction=number_or_none("room.floor.edge_static_friction"),
        edge_kinetic_friction=number_or_none("room.floor.edge_kinetic_friction"),
        restitution=numbers["room.floor.restitution"],
        normal_restitution=numbers["room.floor.normal_restitution"],
        **{name: number_or_none(f"room.floor.{name}") for name in OWN_FRICTION},
    )
    left, right = surface("left_wall", Wall), surface("right_wall", Wall)
    room = Room(floor, left, right, surface("ceiling", Ceiling))  # type: ignore[arg-type]
    start = State(*part("initial", "tilt", "tilt_rate", "slide", "slide_rate"))
    within("model.gravity", numbers["gravity"], 0.01, 1e3, "m/s²", "gravity")
    within("model.motion_scale", numbers["motion.scale"], -1e6, 1e6, field="motion.scale")
    refuse_bad_start(body, room, start)
    return body, room, start


def flat_fields(body: Body, room: Room, start: State, gravity: float) -> dict[str, float]:
    """Return all numbers of a case by their dotted paths; the factor on the motion is 1."""
    return {
        **body_fields(body),
        **room_fields(room),
        "initial.tilt": start.tilt,
        "initial.tilt_rate": start.tilt_rate,
        "initial.slide": start.slide,
        "initial.slide_rate": start.slide_rate,
        "gravity": gravity,
        "motion.scale": 1.0,
    }


def case_rows(numbers: Mapping[str, NumberOrColumn], count: int) -> NDArray[np.void]:
    """Return ``count`` rows of `CASE` from numbers by path, each one value or ``count`` of them."""
    rows = np.zeros(count, CASE)
    b, h, m = numbers["body.width"], numbers["body.height"], numbers["body.mass"]
    inertia = numbers["body.inertia"]
    rows["inertia"] = np.where(np.isnan(inertia), m * (b**2 + h**2) / 12.0, inertia) / m
    x_g, z_g = numbers["body.cg_offset.x"], h / 2 + numbers["body.cg_offset.z"]
    left, right, top = -b / 2 - x_g, b / 2 - x_g, h - z_g
    for corner, (u, v) in enumerate(
        (
            (left, numbers["body.base_heights.left"] - z_g),
            (right, numbers["body.base_heights.right"] - z_g),
            (left, top),
            (right, top),
        )
    ):
        rows["u"][:, corner], rows["v"][:, corner] = u, v
    for name in ("static_friction", "kinetic_friction", "restitution", "normal_restitution"):
        rows[name] = numbers[f"room.floor.{name}"]
    for name in ("static_friction", "kinetic_friction"):
        edge = numbers[f"room.floor.edge_{name}"]
        rows[f"edge_{name}"] = np.where(np.isnan(edge), numbers[f"room.floor.{name}"], edge)
    for name in OWN_FRICTION:
        rows[name] = numbers[f"room.floor.{name}"]
    for name, column in zip(WALLS_AND_CEILING, ("left", "right", "ceiling"), strict=True):
        rows[f"{column}_distance"] = numbers[f"room.{name}.{'height' if name == 'ceiling' else 'gap'}"]
        rows[f"{column}_restitution"] = numbers[f"room.{name}.restitution"]
        rows[f"{column}_friction"] = numbers[f"room.{name}.friction"]
    for name in ("tilt", "tilt_rate", "slide", "slide_rate"):
        rows[name] = numbers[f"initial.{name}"]
    rows["gravity"], rows["scale"] = numbers["gravity"], numbers["motion.scale"]
    return rows


def case_columns(body: Body, room: Room, start: State, gravity: float) -> NDArray[np.void]:
    """Return one row of `CASE`, shape [1]; the factor on the motion is 1."""
    return case_rows(flat_fields(body, room, start, gravity), 1)
