"""Cases in numbers: body, room and initial state by their paths, and the rows that the mechanics read."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from stayput.body import Body
from stayput.catalogue import phrase
from stayput.errors import InputError, within
from stayput.mechanics.columns import CASE
from stayput.room import Ceiling, Floor, Room, Wall

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

Numbers: TypeAlias = "float | NDArray[np.float64]"


@dataclass(frozen=True, slots=True)
class State:
    """Initial state of a body that stands on the floor.

    Parameters
    ----------
    tilt, tilt_rate : float
        Tilt from the position of rest, + to the right, and its rate [rad, rad/s]; the body turns about
        the corner on the side it tilts to.
    slide, slide_rate : float
        Displacement of that corner from its place at rest, and its rate [m, m/s].

    Raises
    ------
    InputError
        A value that is not finite, or a tilt of 90° and more.
    """

    tilt: float = 0.0
    tilt_rate: float = 0.0
    slide: float = 0.0
    slide_rate: float = 0.0

    def __post_init__(self) -> None:
        within("scene.tilt", self.tilt, -1.57, 1.57, "rad", "tilt")
        within("scene.tilt_rate", self.tilt_rate, -1e3, 1e3, "rad/s", "tilt_rate")
        within("scene.slide", self.slide, -1e3, 1e3, "m", "slide")
        within("scene.slide_rate", self.slide_rate, -1e3, 1e3, "m/s", "slide_rate")


def standing_corners(body: Body, start: State) -> tuple[tuple[float, float], ...]:
    """Places of the corners A, B, C, D in the room, for a body that stands on the floor [m]."""
    tilt = body.resting_tilt + start.tilt
    sin, cos = math.sin(tilt), math.cos(tilt)
    turned = [(u * cos + v * sin, v * cos - u * sin) for u, v in body.corners]
    (u_a, v_a), (u_b, v_b), _, _ = body.corners
    half = 0.5 * math.hypot(u_b - u_a, v_b - v_a)
    right = start.tilt > 0.0 or (start.tilt == 0.0 and start.tilt_rate > 0.0)
    foot = 1 if right else 0
    x = start.slide + (half if right else -half) - turned[foot][0]
    z = -turned[foot][1]
    return tuple((x + u, z + v) for u, v in turned)


def leaves_of_body(body: Body) -> dict[str, float]:
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


def leaves_of_floor(floor: Floor) -> dict[str, float]:
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


def leaves_of_surface(name: str, surface: Wall | Ceiling | None) -> dict[str, float]:
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


SURFACES = ("left_wall", "right_wall", "ceiling")


def leaves_of_room(room: Room) -> dict[str, float]:
    """Return a room's numbers by their paths."""
    found = leaves_of_floor(room.floor)
    for name in SURFACES:
        found |= leaves_of_surface(name, getattr(room, name))
    return found


def from_leaves(numbers: Mapping[str, float]) -> tuple[Body, Room, State]:
    """Return the body, the room and the initial state of numbers by path; the inverse of `leaves`.

    Raises
    ------
    InputError
        Numbers that make no body, room or state, or a body that stands inside a wall or the ceiling.
    """

    def given(path: str) -> float | None:
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
        inertia=given("body.inertia"),
        base_heights=(numbers["body.base_heights.left"], numbers["body.base_heights.right"]),
    )
    floor = Floor(
        *part("room.floor", "static_friction", "kinetic_friction"),
        edge_static_friction=given("room.floor.edge_static_friction"),
        edge_kinetic_friction=given("room.floor.edge_kinetic_friction"),
        restitution=numbers["room.floor.restitution"],
        normal_restitution=numbers["room.floor.normal_restitution"],
        **{name: given(f"room.floor.{name}") for name in OWN_FRICTION},
    )
    left, right = surface("left_wall", Wall), surface("right_wall", Wall)
    room = Room(floor, left, right, surface("ceiling", Ceiling))  # type: ignore[arg-type]
    start = State(*part("initial", "tilt", "tilt_rate", "slide", "slide_rate"))
    within("scene.gravity", numbers["gravity"], 0.01, 1e3, "m/s²", "gravity")
    within("scene.motion_scale", numbers["motion.scale"], -1e6, 1e6, field="motion.scale")
    refuse_bad_start(body, room, start)
    return body, room, start


def wall_faces(body: Body, room: Room) -> tuple[float, float]:
    """Return where the faces of the left and the right wall stand [m]; infinitely far where there is none.

    A gap is clear of the whole body as it stands at rest at slide 0, a tilted one's top corners as well.
    """
    across = [x for x, _ in standing_corners(body, State())]
    left, right = room.left_wall, room.right_wall
    return (
        -math.inf if left is None else min(across) - left.gap,
        math.inf if right is None else max(across) + right.gap,
    )


def refuse_bad_start(body: Body, room: Room, start: State) -> None:
    """Raise `InputError` where the initial state lays the body down, or into a wall or the ceiling."""
    if abs(body.resting_tilt + start.tilt) >= math.pi / 2:
        tilt, rest = math.degrees(body.resting_tilt + start.tilt), math.degrees(body.resting_tilt)
        raise InputError("scene.laid_down", "initial.tilt", tilt=tilt, rest=rest)
    corners = standing_corners(body, start)
    left, right = wall_faces(body, room)
    top = max(z for _, z in corners)
    if room.right_wall is not None:
        clear = right - max(x for x, _ in corners)
        _refuse_negative("scene.right_wall", clear)
    if room.left_wall is not None:
        clear = min(x for x, _ in corners) - left
        _refuse_negative("scene.left_wall", clear)
    if room.ceiling is not None:
        _refuse_negative("scene.ceiling", room.ceiling.height - top)


def _refuse_negative(place: str, clear: float) -> None:
    if clear < -1e-12:
        raise InputError("scene.inside", depth=-clear, place=phrase(place))


def leaves(body: Body, room: Room, start: State, gravity: float) -> dict[str, float]:
    """Return all numbers of a case by their dotted paths; the factor on the motion is 1."""
    return {
        **leaves_of_body(body),
        **leaves_of_room(room),
        "initial.tilt": start.tilt,
        "initial.tilt_rate": start.tilt_rate,
        "initial.slide": start.slide,
        "initial.slide_rate": start.slide_rate,
        "gravity": gravity,
        "motion.scale": 1.0,
    }


def case_rows(numbers: Mapping[str, Numbers], count: int) -> NDArray[np.void]:
    """Return ``count`` rows of `CASE` from numbers by path, each one value or ``count`` of them."""
    rows = np.zeros(count, CASE)
    b, h, m = numbers["body.width"], numbers["body.height"], numbers["body.mass"]
    given = numbers["body.inertia"]
    rows["inertia"] = np.where(np.isnan(given), m * (b**2 + h**2) / 12.0, given) / m
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
    for name, column in zip(SURFACES, ("left", "right", "ceiling"), strict=True):
        rows[f"{column}_distance"] = numbers[f"room.{name}.{'height' if name == 'ceiling' else 'gap'}"]
        rows[f"{column}_restitution"] = numbers[f"room.{name}.restitution"]
        rows[f"{column}_friction"] = numbers[f"room.{name}.friction"]
    for name in ("tilt", "tilt_rate", "slide", "slide_rate"):
        rows[name] = numbers[f"initial.{name}"]
    rows["gravity"], rows["scale"] = numbers["gravity"], numbers["motion.scale"]
    return rows


def case_columns(body: Body, room: Room, start: State, gravity: float) -> NDArray[np.void]:
    """Return one row of `CASE`, shape [1]; the factor on the motion is 1."""
    return case_rows(leaves(body, room, start, gravity), 1)
