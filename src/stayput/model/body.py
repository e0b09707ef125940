"""What stands: section, mass, centre of gravity and moment of inertia of a body, and presets of furniture."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field, fields
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import phrase
from stayput.errors import InputError, finite, instance_of, list_of, no_length, not_allowed, numbers
from stayput.model.parameters import (
    DENSITY_RANGE,
    GRAVITY,
    MASS_RANGE,
    SIZE_RANGE,
    STANDARD_GRAVITY,
    check_fields,
    choice,
    parameter,
    parameter_of,
    quantity,
)
from stayput.model.polyhedron import enclosed_volume, triangulated
from stayput.model.shapes import Shapes, section_of
from stayput.model.solid import BASES, Solid, corners_of_box
from stayput.uncertainty import Confidence
from stayput.wording import Brief

if TYPE_CHECKING:
    from matplotlib.axes import Axes


MOST_INSET = 0.45
"""Largest inset of a base corner, as a part of the width."""

UNSTATED_LENGTH = (0.05, 5.0)
"""Shortest and longest length that a body may have whose length is not stated [m]."""

_SIZE, _MASS = ("m", *SIZE_RANGE), ("kg", *MASS_RANGE)
_OFFSET = ("m", -SIZE_RANGE[1], SIZE_RANGE[1])
_PART_SIZE = ("m", 0.0, SIZE_RANGE[1])


@dataclass(frozen=True, slots=True, repr=False)
class Part(Brief):
    """A uniform rectangle that is part of a body: a board, a shelf's load, a drawer.

    Parameters
    ----------
    mass : float
        Mass [kg].
    x : float
        Position of its centre right of the middle of the body's base [m].
    z : float
        Height of its centre above the body's base [m].
    width, height : float
        Size in the plane of shaking [m]; 0 for a thin board or a point mass.

    Examples
    --------
    >>> import stayput as sp
    >>> shelves = [sp.Part(mass=20.0, x=0.0, z=height) for height in (0.3, 0.8, 1.3)]
    >>> body = sp.Body.from_parts(0.3, 1.8, shelves)
    >>> body.mass
    60.0
    """

    mass: float = field(metadata=quantity("kg", 0.0, MASS_RANGE[1], ("Part mass", "部分の質量")))
    x: float = field(metadata=quantity(*_OFFSET, ("Part x", "部分のx座標")))
    z: float = field(metadata=quantity(*_OFFSET, ("Part z", "部分のz座標")))
    width: float = parameter(0.0, *_PART_SIZE, ("Part width", "部分の幅"))
    height: float = parameter(0.0, *_PART_SIZE, ("Part height", "部分の高さ"))

    def __post_init__(self) -> None:
        check_fields(self)


@dataclass(frozen=True, slots=True, repr=False)
class Body(Shapes, Brief):
    """A rigid body: a piece of furniture by its section in the plane of shaking, or any convex shape.

    `hull`, `box`, `cylinder`, `cone` and `mesh` make bodies of a shape of their own. These move in
    space; in the plane they are the box around them.

    Parameters
    ----------
    width : float
        Base length b along the shaking [m]: of a bookcase, its *depth*.
    height : float
        Height h [m].
    mass : float
        Mass m [kg]. Without devices and other bodies the motion does not depend on it; forces do.
    cg_offset : tuple of float
        Offset (e_x, e_z) of the centre of gravity G from the centroid [m], + right, + up.
        G must lie inside the section.
    inertia : float, optional
        Moment of inertia J_G about the centre of gravity [kg m²]; default m(b²+h²)/12, the uniform
        rectangle's.
    base_heights : tuple of float
        Height of the left and the right base corner in the body's own frame [m]. (0, 0) is a flat
        base; a wedge of 5 mm under the right (front) edge is (0, −0.005): the body then rests
        tilted back.
    base_insets : tuple of float
        Distance of the left and the right base corner from the side face above it [m]: feet, casters or a
        plinth stand inside the outline of the piece.
    length : float, optional
        Length across the shaking [m]: of a bookcase, its *width*. Nothing in the plane depends on it; in
        space the body is a box with it.
    base : str
        What bears on the floor, with which friction resists turning in plan: "flat", the whole base; "edges",
        its outline (a plinth, side boards); "feet", its corners (feet, casters). Nothing in the plane depends
        on it.
    shape : Solid, optional
        Its shape in space, where it is another than the box: what `hull` and the others make. The other
        fields are those of the box around it.

    Raises
    ------
    InputError
        A size, mass, inertia or offset that is not finite or not possible, no such base, or another field
        than follows from the shape.

    Examples
    --------
    >>> import stayput as sp
    >>> bookcase = sp.Body(width=0.3, height=1.8, mass=90.0, cg_offset=(0.03, -0.2))  # heavy in front
    >>> bookcase.centre_of_gravity  # from the middle of the base [m]
    (0.03, 0.7)
    >>> [round(a, 2) for a in bookcase.overturning_acceleration()]  # that tips it back and forward [m/s²]
    [2.52, 1.68]
    """

    width: float = field(metadata=quantity(*_SIZE, ("Body width", "家具の奥行き")))
    height: float = field(metadata=quantity(*_SIZE, ("Body height", "家具の高さ")))
    mass: float = field(metadata=quantity(*_MASS, ("Body mass", "家具の質量")))
    cg_offset: tuple[float, float] = parameter(
        (0.0, 0.0), *_OFFSET, ("Body cg_offset", "重心のずれ（cg_offset）")
    )
    inertia: float | None = parameter(None, "kg m²", 1e-12, 1e12, ("Body inertia", "家具の慣性モーメント"))
    base_heights: tuple[float, float] = parameter((0.0, 0.0), *_OFFSET, ("Body base height", "底の角の高さ"))
    base_insets: tuple[float, float] = parameter(
        (0.0, 0.0), *_OFFSET, ("Body base inset", "底の角の内側への距離")
    )
    length: float | None = parameter(None, *_SIZE, ("Body length", "家具の幅（length）"))
    base: str = choice(BASES[0], BASES, ("Base", "底面"))
    shape: Solid | None = None

    def __post_init__(self) -> None:
        check_fields(self, but=("cg_offset", "inertia", "base_heights", "base_insets"))
        if self.shape is not None:
            section = section_of(instance_of("shape", self.shape, Solid))
            for about, value in zip(fields(self), section, strict=True):
                if getattr(self, about.name) != value:
                    raise InputError("model.not_of_its_shape", about.name, name=about.name)
            return
        for name in ("cg_offset", "base_heights", "base_insets"):
            numbers(parameter_of(Body, name).label, getattr(self, name), name, count=2)
        label = parameter_of(Body, "cg_offset").label
        e_x, e_z = (finite(label, value, "cg_offset") for value in self.cg_offset)
        if abs(e_x) >= self.width / 2 or abs(e_z) >= self.height / 2:
            inside = phrase("model.inside_the_section", width=self.width / 2, height=self.height / 2)
            raise not_allowed(label, f"({e_x:g}, {e_z:g}) m", inside, "cg_offset")
        if self.inertia is not None:
            largest = 4.0 * self.mass * (self.width**2 + self.height**2)
            bounds = (1e-6 * self.uniform_inertia, largest)
            parameter_of(Body, "inertia").check(self.inertia, bounds=bounds)
        bounds = (-self.width / 2, min(self.width, self.height) / 4)
        for value in self.base_heights:
            parameter_of(Body, "base_heights").check(value, bounds=bounds)
        for value in self.base_insets:
            parameter_of(Body, "base_insets").check(value, bounds=(0.0, MOST_INSET * self.width))
        (left, _), (right, _), _, _ = self.corners
        if not left < 0.0 < right:
            label, bearing = parameter_of(Body, "base_insets").label, phrase("model.bearing_insets", x=e_x)
            raise not_allowed(label, repr(self.base_insets), bearing, "base_insets")

    def _repr_html_(self) -> str:
        from stayput.report.notebook import body_html

        return body_html(self)

    def plot(self, ax: Axes | None = None, *, language: str = "en") -> Axes:
        """Draw the section to scale, with the centre of gravity and R and α of the base corners.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        language : str
            Language of the texts, "en" or "ja".
        """
        from stayput.model.room import Room

        return Room().plot(ax, body=self, language=language)

    @property
    def solid(self) -> Solid:
        """Its shape and mass in space.

        Raises
        ------
        InputError
            No length.
        """
        return self.shape or _solid_of(self)

    @property
    def vertices(self) -> NDArray[np.float64]:
        """The corners of its `solid` [m], shape (n, 3), without making that; it raises the same."""
        if self.shape is not None:
            return self.shape.vertices
        if self.length is None:
            raise no_length()
        u, v = zip(*self.corners, strict=True)
        return np.array(corners_of_box(u, v, self.length))

    @property
    def uniform_inertia(self) -> float:
        """Moment of inertia about G of the uniform rectangle, m(b²+h²)/12 [kg m²]."""
        return self.mass * (self.width**2 + self.height**2) / 12.0

    @property
    def inertia_about_cg(self) -> float:
        """Moment of inertia J_G about G [kg m²]."""
        return self.uniform_inertia if self.inertia is None else self.inertia

    @property
    def base_width(self) -> float:
        """Distance between the base corners along the width [m]: the width less the `base_insets`."""
        return self.width - self.base_insets[0] - self.base_insets[1]

    @property
    def centre_of_gravity(self) -> tuple[float, float]:
        """G in the body's frame: right of the middle of the base, above the base [m]."""
        return self.cg_offset[0], self.height / 2 + self.cg_offset[1]

    @property
    def corners(self) -> tuple[tuple[float, float], ...]:
        """The corners A, B (base, left and right), C, D (top, left and right) relative to G [m]."""
        x_g, z_g = self.centre_of_gravity
        left, right = -self.width / 2 - x_g, self.width / 2 - x_g
        (z_a, z_b), (in_a, in_b) = self.base_heights, self.base_insets
        top = self.height - z_g
        return (left + in_a, z_a - z_g), (right - in_b, z_b - z_g), (left, top), (right, top)

    @property
    def sides(self) -> tuple[tuple[float, float], ...]:
        """The ends of the side faces relative to G: lower left and right, upper left and right [m].

        The lower ones are the base corners but for the `base_insets`.
        """
        (_, low_left), (_, low_right), top_left, top_right = self.corners
        return (top_left[0], low_left), (top_right[0], low_right), top_left, top_right

    @property
    def resting_tilt(self) -> float:
        """Tilt at which both base corners stand on the floor [rad]; 0 for a flat base."""
        (u_a, v_a), (u_b, v_b), _, _ = self.corners
        return math.atan2(v_b - v_a, u_b - u_a)

    @property
    def corners_at_rest(self) -> tuple[tuple[float, float], ...]:
        """The corners A, B, C, D from G when it rests, right and up [m]; a tilt turns them from there."""
        cos, sin = math.cos(self.resting_tilt), math.sin(self.resting_tilt)
        return tuple((u * cos + v * sin, v * cos - u * sin) for u, v in self.corners)

    @property
    def slenderness(self) -> tuple[float, float]:
        """Angles α_A and α_B between the body's own axis and the lines from G to the corners A and B [rad].

        Over a wedge the body rests at `resting_tilt`: the angles from the vertical are then α_A + that and
        α_B − that.
        """
        (u_a, v_a), (u_b, v_b), _, _ = self.corners
        return math.atan2(-u_a, -v_a), math.atan2(u_b, -v_b)

    @property
    def size(self) -> tuple[float, float]:
        """Size parameters R_A and R_B, the distances of the corners A and B from G [m] (Housner 1963)."""
        a, b, _, _ = self.corners
        return math.hypot(*a), math.hypot(*b)

    def frequency_parameter(self, gravity: float = STANDARD_GRAVITY) -> tuple[float, float]:
        """Return p = √(m g R/J) about the corners A and B, with J = J_G + m R² [rad/s].

        That of the uniform rectangle is √(3g/4R) (Housner 1963). A body that rocks by small angles beside α
        rises and falls with p, not with a period of its own: larger bodies are slower at the same shape.

        Examples
        --------
        >>> block = Body(width=0.4, height=1.2, mass=100.0)
        >>> [round(p, 3) for p in block.frequency_parameter()]
        [3.41, 3.41]
        """
        g = GRAVITY.check(gravity)
        left, right = (
            math.sqrt(self.mass * g * R / (self.inertia_about_cg + self.mass * R**2)) for R in self.size
        )
        return left, right

    def overturning_acceleration(self, gravity: float = STANDARD_GRAVITY) -> tuple[float, float]:
        """Return the static overturning accelerations g tan α about the corners A and B [m/s²] (West 1882).

        Held for long, more of it tips the body; less of it does not even lift an edge. Over a wedge α is
        measured from the tilt of rest.

        Examples
        --------
        >>> block = Body(width=0.4, height=1.2, mass=100.0)
        >>> [round(a, 3) for a in block.overturning_acceleration()]
        [3.269, 3.269]
        """
        g = GRAVITY.check(gravity)
        left, right = self.slenderness
        return g * math.tan(left + self.resting_tilt), g * math.tan(right - self.resting_tilt)

    @classmethod
    def from_parts(cls, width: float, height: float, parts: Iterable[Part]) -> Body:
        """Make a body from its parts: mass, centre of gravity and inertia follow (parallel axes).

        Parameters
        ----------
        width, height : float
            Outer section [m].
        parts : iterable of Part
            The carcass, the shelves and their loads.

        Raises
        ------
        InputError
            No parts, no mass, or a centre of gravity outside the section.
        """
        _check_size(width, height)
        pieces = list_of("parts", parts, Part)
        mass = sum(p.mass for p in pieces)
        if not mass > 0.0:
            raise not_allowed("model.total_mass", f"{mass:g} kg", "common.above_zero", "mass")
        x_g = sum(p.mass * p.x for p in pieces) / mass
        z_g = sum(p.mass * p.z for p in pieces) / mass
        inertia = sum(
            p.mass * ((p.width**2 + p.height**2) / 12.0 + (p.x - x_g) ** 2 + (p.z - z_g) ** 2) for p in pieces
        )
        return cls(width, height, mass, (x_g, z_g - height / 2), inertia)

    @classmethod
    def bookcase(cls, width: float, height: float, mass: float, loads: Iterable[float]) -> Body:
        """Make a bookcase: a uniform carcass and equally spaced shelves with a load on each.

        Parameters
        ----------
        width, height : float
            Outer section [m].
        mass : float
            Mass of the empty carcass [kg], spread over the section.
        loads : iterable of float
            Load on each shelf from the lowest up [kg]; each fills its compartment.
        """
        shelves = list_of("loads", loads)
        _check_size(width, height)
        if not shelves:
            raise InputError("common.empty", "loads")
        clear = height / len(shelves)
        carcass = Part(mass, 0.0, height / 2, width, height)
        books = (Part(load, 0.0, (i + 0.5) * clear, width, clear) for i, load in enumerate(shelves))
        return cls.from_parts(width, height, (carcass, *books))


def _check_size(width: float, height: float) -> None:
    """Refuse a section that is not possible before anything is computed from it; see `Body`."""
    for name, size in (("width", width), ("height", height)):
        parameter_of(Body, name).check(size)


def check_density(body: Body) -> Body:
    """Return a piece of furniture, or refuse a mass that none of its size has: grams or tonnes for kilograms.

    Bodies themselves may have any: how one moves without devices does not depend on it.
    """
    if body.shape is not None:
        small = large = enclosed_volume(body.shape.vertices, triangulated(body.shape.faces))
    else:
        shortest, longest = (body.length, body.length) if body.length else UNSTATED_LENGTH
        small, large = (body.width * body.height * length for length in (shortest, longest))
    least, most = DENSITY_RANGE
    if not least * small <= body.mass <= most * large:
        density = body.mass / (large if body.mass > most * large else small)
        raise InputError("model.density", "mass", mass=body.mass, density=density, least=least, most=most)
    return body


@dataclass(frozen=True, slots=True)
class Preset:
    """A common piece of furniture, seen from its side.

    Parameters
    ----------
    width : float
        Depth of the piece, which is its base length along the shaking [m].
    height : float
        Height [m].
    length : float
        Length across the shaking [m].
    mass : float
        Mass as it usually stands, with its load [kg].
    carcass_mass : float, optional
        Mass when it is empty [kg], for pieces whose loads may be given shelf by shelf.
    base : str
        What bears on the floor, as of a `Body`.
    base_confidence : Confidence
        How well founded that is.
    """

    width: float = field(metadata=quantity("m", *SIZE_RANGE, ("width (depth)", "奥行き")))
    height: float = field(metadata=quantity("m", *SIZE_RANGE, ("height", "高さ")))
    length: float = field(metadata=quantity("m", *SIZE_RANGE, ("length (across)", "幅")))
    mass: float = field(metadata=quantity("kg", *MASS_RANGE, ("mass", "質量")))
    carcass_mass: float | None = parameter(None, "kg", *MASS_RANGE, ("empty carcass", "空の本体の質量"))
    base: str = choice(BASES[0], BASES, ("base", "底面"))
    base_confidence: Confidence = Confidence.MEDIUM


FURNITURE: dict[str, Preset] = {
    "bookcase": Preset(0.30, 1.80, 0.80, 200.0, 35.0, "edges"),
    "empty bookcase": Preset(0.30, 1.80, 0.80, 35.0, 35.0, "edges"),
    "wardrobe": Preset(0.60, 1.90, 1.00, 115.0, None, "edges"),
    "cupboard": Preset(0.40, 1.80, 0.885, 100.0, None, "edges"),
    "chest": Preset(0.42, 1.365, 0.885, 81.0, None, "edges"),
    "refrigerator": Preset(0.68, 1.82, 0.65, 105.0, None, "feet"),
    "television": Preset(0.27, 0.76, 1.23, 18.0, None, "feet", Confidence.LOW),
    "vending machine": Preset(0.83, 1.83, 1.10, 350.0, None, "feet"),
    "server rack": Preset(1.00, 2.00, 0.70, 500.0, None, "feet"),
    "upright piano": Preset(0.62, 1.25, 1.50, 230.0, None, "feet"),
}
"""Pieces of furniture by name: typical Japanese sizes; masses in the middle of the usual range; bases as such
pieces commonly have: plinths and side boards, adjustable feet or casters. A television may stand on a plate.
"""


@lru_cache(maxsize=256)
def _solid_of(body: Body) -> Solid:
    """Return the shape and mass in space of a body that is made by its section; options share bodies."""
    from stayput.model.flat_fields import row_alone

    return Solid.of_case(row_alone(body))
