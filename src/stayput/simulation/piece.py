"""`Piece`: a body where it stands, with the measures that hold it; convex bodies, apart or inside each other.

Two convex bodies are apart where an axis separates them: the normal of a face of one, or the cross product of
an edge of each (Gottschalk, Lin and Manocha 1996). The largest gap along such an axis is never more than the
distance, and below 0 exactly where they overlap; its rate just before they touch is how fast they close.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, list_of, name_of, numbers, within, word_of
from stayput.measures.measure import Measure, refuse_conflicts
from stayput.model.body import Body
from stayput.model.floor_plan import PersonPlace, rectangle
from stayput.model.room import WALLS_AROUND

if TYPE_CHECKING:
    from stayput.model.solid import Solid


SLIGHT = 1e-6
"""Length of a cross product of two unit vectors up to which they are parallel."""

PARALLEL = 1e-9
"""Largest difference of the parts of two unit vectors that count as parallel."""


@dataclass(frozen=True, slots=True, eq=False)
class ConvexShape:
    """A convex body for questions of where it is.

    Parameters
    ----------
    corners : ndarray, shape (n, 3)
        From its centre of gravity, along the axes of its frame [m].
    normals, edges : ndarray, shape (f, 3) and (e, 3)
        Directions of its faces and of its edges, no two of them parallel.
    mass : float
        Mass [kg].
    inertia : ndarray, shape (3, 3)
        About the centre of gravity [kg m²].
    """

    corners: NDArray[np.float64]
    normals: NDArray[np.float64]
    edges: NDArray[np.float64]
    mass: float
    inertia: NDArray[np.float64]

    @classmethod
    @lru_cache(maxsize=256)
    def of(cls, solid: Solid) -> ConvexShape:
        """Return that of a solid; what stands in several options is the same."""
        edges = np.concatenate(
            [solid.vertices[np.roll(face, -1)] - solid.vertices[face] for face in solid.faces]
        )
        edges = edges / np.linalg.norm(edges, axis=1)[:, np.newaxis]
        return cls(
            solid.vertices - solid.centre_of_gravity,
            _different(solid.normals),
            _different(edges),
            solid.mass,
            solid.inertia,
        )


def _different(directions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return unit vectors without those that are parallel to one before."""
    parallel = 1.0 - np.abs(directions @ directions.T) <= PARALLEL
    return directions[~np.tril(parallel, -1).any(axis=1)]


class Convex(NamedTuple):
    """A convex body at k samples: corners (k, n, 3), directions of faces (k, f, 3) and of edges (k, e, 3)."""

    corners: NDArray[np.float64]
    normals: NDArray[np.float64]
    edges: NDArray[np.float64]


def separation(body: Convex, other: Convex) -> NDArray[np.float64]:
    """Return the largest gap along any axis that may separate two bodies [m], shape (k,)."""
    crossed = np.cross(body.edges[:, :, np.newaxis], other.edges[:, np.newaxis])
    crossed = crossed.reshape(len(crossed), -1, 3)
    size = np.linalg.norm(crossed, axis=2)
    slight = size <= SLIGHT
    crossed = crossed / np.where(slight, 1.0, size)[..., np.newaxis]
    axes = np.concatenate([body.normals, other.normals, crossed], axis=1)
    first, second = (convex.corners @ np.swapaxes(axes, 1, 2) for convex in (body, other))
    gaps = np.maximum(first.min(axis=1) - second.max(axis=1), second.min(axis=1) - first.max(axis=1))
    faces = body.normals.shape[1] + other.normals.shape[1]
    gaps[:, faces:][slight] = -np.inf  # parallel edges span no axis
    return gaps.max(axis=1)


def box_of(place: PersonPlace, count: int) -> Convex:
    """Return the place of a person at so many samples."""
    plan = rectangle(place.at, place.width, place.length, place.heading)
    corners = np.concatenate([np.column_stack((plan, np.full(4, z))) for z in (place.low, place.high)])
    sides = np.diff(plan[:3], axis=0) / np.linalg.norm(np.diff(plan[:3], axis=0), axis=1)[:, np.newaxis]
    axes = np.concatenate([np.column_stack((sides, np.zeros(2))), [[0.0, 0.0, 1.0]]])
    corners, axes = (np.broadcast_to(values, (count, *values.shape)) for values in (corners, axes))
    return Convex(corners, axes, axes)


def inside_each_other(piece: Piece, other: Piece | PersonPlace) -> float:
    """Return how deep a piece stands in another, or where a person is, at first [m]; 0 where it does not."""
    box = box_of(other, 1) if isinstance(other, PersonPlace) else _at_first(other)
    return max(0.0, -float(separation(_at_first(piece), box)[0]))


def _at_first(piece: Piece) -> Convex:
    shape = ConvexShape.of(piece.solid)
    corners, normals, edges = (
        values[np.newaxis] @ piece.turn.T for values in (shape.corners, shape.normals, shape.edges)
    )
    return Convex(corners + piece.place, normals, edges)


_VECTORS = (
    ("at", 100.0, "m"),
    ("tilt", math.pi, "rad"),
    ("velocity", 100.0, "m/s"),
    ("rotation_rate", 1e3, "rad/s"),
)
"""Fields of three numbers, the most of each, and their units."""


def vector_of(name: str, vector: object, most: float, unit: str) -> tuple[float, ...]:
    """Return three numbers, or raise `InputError`."""
    called = phrase(f"simulation.{name}")
    values = numbers(called, vector, name, count=3).tolist()
    return tuple(within(called, value, -most, most, unit, name) for value in values)


BEHIND = 0.02
"""Usual gap between a piece and the wall at its back [m]."""

LEVEL = 1e-4
"""How much higher one end of what lies on its round side may be than the other [m]."""


class RoundSide(NamedTuple):
    """The side on which a round body lies at first, in the body's frame.

    Parameters
    ----------
    axis, up : ndarray, shape (3,)
        Its axis, and what points up across that.
    line : ndarray, shape (2, 3)
        The ends of the line on which it lies [m].
    radius : float
        The mean of both ends [m].
    """

    axis: NDArray[np.float64]
    up: NDArray[np.float64]
    line: NDArray[np.float64]
    radius: float


@dataclass(frozen=True)
class Piece:
    """A body where it stands in a room, with the measures that hold it to that.

    Parameters
    ----------
    body : Body
        The body, with a length.
    at : tuple of float
        Where the middle of its base is, of a body with a shape of its own the origin of its frame: along x,
        across y, up z [m].
    heading : float
        By what it is turned about the vertical, from x towards y [rad]. Its back is at −x of its own frame.
    measures : sequence of Measure
        What holds a body that is made by its section: to the wall that its back faces, to the ceiling, and to
        the floor where it stands on that.
    tilt : tuple of float
        By what it is turned before that: a rotation vector along the axes of its frame [rad]; (0, 0.1, 0)
        tilts it to its front. A box that rests on feet of unequal height leans by itself.
    velocity, rotation_rate : tuple of float
        Of its centre of gravity [m/s], and of itself [rad/s], along x, y and z of the room, at first.
    name : str, optional
        What it is called; of several each has a name of its own.
    on : str, optional
        The piece of a `Scene` on whose top it stands, from the middle of whose base ``at`` counts then.
    against : str, optional
        The wall of a scene's plan to which its back stands, of `WALLS_AROUND`, in the place of ``at`` and
        ``heading``.
    along, gap : float
        Where its middle is along that wall, from the lower x or y, and what is between both [m].

    Attributes
    ----------
    solid : Solid
        Its shape and mass in space.

    Raises
    ------
    InputError
        A body without a length, a number out of range, two measures for one place, or two places of the
        piece: beside ``against`` there is ``along`` and no other, and what is ``on`` a piece has no height.

    Examples
    --------
    >>> import stayput as sp
    >>> from stayput.measures import LBracket
    >>> body, room = sp.Body(width=0.3, height=1.8, mass=80.0, length=0.9), sp.Room(left_wall=sp.Wall(0.02))
    >>> for measures in ([], [LBracket()]):
    ...     print(sp.simulate(sp.Piece(body, measures=measures), room, sp.near_fault()).outcome)
    overturned
    rocked

    Let go on its front edge; atan(0.4/1.8) is 0.219 rad:

    >>> from math import sin
    >>> shelf = sp.Body(width=0.4, length=0.9, height=1.8, mass=60.0)
    >>> still = sp.sine(amplitude=0.0, frequency=1.0, duration=3.0)
    >>> for tilt in (0.19, 0.24):
    ...     tilted = sp.Piece(shelf, at=(0.0, 0.0, 0.2 * sin(tilt)), tilt=(0.0, tilt, 0.0))
    ...     print(tilt, sp.simulate(tilted, sp.Room(), still).outcome)
    0.19 rocked
    0.24 overturned
    """

    body: Body
    at: tuple[float, float, float] = (0.0, 0.0, 0.0)
    heading: float = 0.0
    measures: Sequence[Measure] = ()
    tilt: tuple[float, float, float] = (0.0, 0.0, 0.0)
    velocity: tuple[float, float, float] = (0.0, 0.0, 0.0)
    rotation_rate: tuple[float, float, float] = (0.0, 0.0, 0.0)
    name: str | None = None
    on: str | None = None
    against: str | None = None
    along: float | None = None
    gap: float = BEHIND

    def __post_init__(self) -> None:
        instance_of("body", self.body, Body)
        object.__setattr__(self, "measures", list_of("measures", self.measures, Measure))
        refuse_conflicts(self.measures)
        for name, most, unit in _VECTORS:
            object.__setattr__(self, name, vector_of(name, getattr(self, name), most, unit))
        within("simulation.heading", self.heading, -2.0 * math.pi, 2.0 * math.pi, "rad", "heading")
        for name in ("name", "on"):
            if getattr(self, name) is not None:
                name_of(name, getattr(self, name))
        for name in ("along", "gap") if self.along is not None else ("gap",):
            within(name, getattr(self, name), 0.0, 100.0, "m", name)
        if self.on is not None and self.at[2] != 0.0:
            raise InputError("scenario.only_one", "at[2]", other="on")
        if self.against is None:
            for name, default in (("along", None), ("gap", BEHIND)):
                if getattr(self, name) != default:
                    raise InputError("scenario.needs_both", name, other="against")
        else:
            word_of("against", self.against, WALLS_AROUND, "against")
            if self.along is None:
                raise InputError("scenario.needs_both", "along", name="against", other="along")
            for name in ("at", "heading", "on"):
                if getattr(self, name) not in (None, 0.0, (0.0, 0.0, 0.0)):
                    raise InputError("scenario.only_one", name, other="against")
        if any(self.body.base_heights) or self.body.length is None:
            _ = self.solid  # which may be refused

    @cached_property
    def solid(self) -> Solid:
        """Its shape and mass in space."""
        return self.body.solid

    @cached_property
    def turn(self) -> NDArray[np.float64]:
        """The rotation of its frame into the room's at first, shape (3, 3)."""
        return self._facing @ rotation_by(np.asarray(self.tilt))

    @cached_property
    def round_side(self) -> RoundSide | None:
        """The side on which a cylinder or a truncated cone lies at first; None of what does not lie so."""
        rims, up = self.solid.rims, self.turn[2]
        if len(rims) != 2:
            return None
        axis = rims[1, 3:6]
        across = up - (axis @ up) * axis
        if not across.any():  # it stands upright
            return None
        across /= np.linalg.norm(across)
        line = rims[:, :3] - rims[:, 6:] * across
        low = min((line @ up).min(), (self.solid.base_points @ up).min())
        lies = bool((line @ up <= low + LEVEL).all())
        return RoundSide(axis, across, line, float(rims[:, 6].mean())) if lies else None

    @cached_property
    def rest(self) -> NDArray[np.float64]:
        """The same at rest, shape (3, 3): on its base, leaning on unequal feet, or on its round side."""
        if self.round_side is not None:
            return self.turn
        up = self.solid.up_at_rest
        return self._facing if up is None else self._facing @ _to_vertical(up)

    @cached_property
    def _vertices(self) -> NDArray[np.float64]:
        return self.body.vertices

    @property
    def _facing(self) -> NDArray[np.float64]:
        cos, sin = math.cos(self.heading), math.sin(self.heading)
        return np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])

    @cached_property
    def place(self) -> NDArray[np.float64]:
        """Where its centre of gravity is at first [m], shape (3,)."""
        return np.asarray(self.at) + self.turn @ self.solid.centre_of_gravity

    def reach(self, direction: tuple[float, float, float]) -> tuple[float, float]:
        """Return how far its corners and round edges reach along a unit vector, least and most [m]."""
        in_frame = self.turn.T @ direction
        ends, shape = self._vertices @ in_frame, self.body.shape
        if shape is not None and len(rims := shape.rims):
            reach = rims[:, 6] * np.linalg.norm(np.cross(rims[:, 3:6], in_frame), axis=1)
            centres = rims[:, :3] @ in_frame
            ends = np.concatenate([ends, centres - reach, centres + reach])
        place = float(np.dot(self.at, direction))
        return place + float(ends.min()), place + float(ends.max())


def rotation_by(vector: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the rotation about a vector by its length [rad] (Rodrigues), shape (3, 3)."""
    if not vector.any():
        return np.eye(3)
    angle = float(np.linalg.norm(vector))
    x, y, z = vector / angle
    across = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + math.sin(angle) * across + (1.0 - math.cos(angle)) * (across @ across)


def _to_vertical(up: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the least rotation that brings a unit vector that points up to the vertical, shape (3, 3)."""
    x, y, z = up
    square = 1.0 + z
    return np.array(
        [[1.0 - x * x / square, -x * y / square, -x], [-x * y / square, 1.0 - y * y / square, -y], [x, y, z]]
    )
