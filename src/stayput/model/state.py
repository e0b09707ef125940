"""How a body stands and moves at the beginning, and where it and the walls then are."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.model.parameters import check_fields, parameter
from stayput.wording import Brief

if TYPE_CHECKING:
    from stayput.model.body import Body
    from stayput.model.room import Room


@dataclass(frozen=True, slots=True, repr=False)
class State(Brief):
    """Initial state of a body that stands on the floor.

    Parameters
    ----------
    tilt : float
        Tilt from the position of rest [rad], + to the right; the body turns about the corner on the side it
        tilts to.
    tilt_rate : float
        Rate of the tilt [rad/s].
    slide : float
        Displacement of that corner from its place at rest [m], + to the right.
    slide_rate : float
        Rate of the slide [m/s].

    Raises
    ------
    InputError
        A value that is not finite, or a tilt of 90° and more.

    Examples
    --------
    >>> import stayput as sp
    >>> still = sp.sine(amplitude=0.0, frequency=1.0, duration=6.0)
    >>> room = sp.Room(sp.Floor(2.0, 2.0))
    >>> run = sp.simulate(sp.Body(0.6, 1.8, 100.0), room, still, initial=sp.State(tilt=0.2))  # let go
    >>> [round(event.time, 2) for event in run.events[:5]]  # it lands ever sooner [s]
    [0.59, 1.35, 1.94, 2.41, 2.79]
    """

    tilt: float = parameter(0.0, "rad", -1.57, 1.57, ("Initial tilt", "初期の傾き"))
    tilt_rate: float = parameter(0.0, "rad/s", -1e3, 1e3, ("Initial tilt rate", "初期の傾きの角速度"))
    slide: float = parameter(0.0, "m", -1e3, 1e3, ("Initial slide", "初期の移動量"))
    slide_rate: float = parameter(0.0, "m/s", -1e3, 1e3, ("Initial slide rate", "初期の移動速度"))

    def __post_init__(self) -> None:
        check_fields(self)


def standing_corners(
    body: Body, start: State, points: tuple[tuple[float, float], ...] | None = None
) -> tuple[tuple[float, float], ...]:
    """Places in the room of points from G, by default the corners A, B, C, D, as the body stands [m]."""
    tilt = body.resting_tilt + start.tilt
    sin, cos = math.sin(tilt), math.cos(tilt)
    left, right, _, _ = body.corners
    half = 0.5 * math.dist(left, right)
    turns_right = start.tilt > 0.0 or (start.tilt == 0.0 and start.tilt_rate > 0.0)
    u, v = right if turns_right else left
    x = start.slide + (half if turns_right else -half) - (u * cos + v * sin)
    z = -(v * cos - u * sin)
    return tuple((x + (u * cos + v * sin), z + (v * cos - u * sin)) for u, v in points or body.corners)


def wall_faces(body: Body, room: Room) -> tuple[float, float]:
    """Return where the faces of the left and the right wall stand [m]; infinitely far where there is none.

    A gap is clear of the whole body as it stands at rest at slide 0, a tilted one's top corners as well.
    """
    across = [x for x, _ in standing_corners(body, State(), body.sides)]
    left, right = room.left_wall, room.right_wall
    return (
        -math.inf if left is None else min(across) - left.gap,
        math.inf if right is None else max(across) + right.gap,
    )


def refuse_bad_start(body: Body, room: Room, start: State) -> None:
    """Raise `InputError` where the initial state lays the body down, or into a wall or the ceiling."""
    if abs(body.resting_tilt + start.tilt) >= math.pi / 2:
        tilt, rest = math.degrees(body.resting_tilt + start.tilt), math.degrees(body.resting_tilt)
        raise InputError("model.laid_down", "initial.tilt", tilt=tilt, rest=rest)
    corners = standing_corners(body, start, body.sides)
    left, right = wall_faces(body, room)
    height = math.inf if room.ceiling is None else room.ceiling.height
    for name, clear in (
        ("right_wall", right - max(x for x, _ in corners)),
        ("left_wall", min(x for x, _ in corners) - left),
        ("ceiling", height - max(z for _, z in corners)),
    ):
        if clear < -1e-12:
            raise InputError("model.inside", depth=-clear, place=phrase(f"model.{name}"))
