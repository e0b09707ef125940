"""`Solid`: the shape and mass of a convex rigid body in space."""

# ruff: noqa: RUF009 - descriptors, one for each field, are no defaults

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields
from functools import lru_cache, partial
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.errors import no_length, too_many
from stayput.model import polyhedron, solid_fields

MOST_VERTICES = 500
"""Most corners of a body."""

BASES = ("flat", "edges", "feet")
"""What of a base bears on the floor: all of it, its outline, or its corners."""


@dataclass(frozen=True, eq=False, repr=False, init=False)
class Solid:
    """A convex rigid body in space: what `stayput.Body.solid` is.

    Its frame has x along the depth (front +x, back −x), y across, z up, as it stands upright; the origin is
    the middle of the base of its outline. Arrays that are read from it are copies, or cannot be written to.

    Parameters
    ----------
    vertices : array_like, shape (k, 3)
        Points whose convex hull it is [m]; those that are no corners are left out.
    mass : float
        Mass m [kg].
    centre_of_gravity : array_like, shape (3,), optional
        G, inside the body [m]; default that of the evenly filled hull.
    inertia : array_like, shape (3, 3), optional
        Inertia tensor about G along the axes of the frame [kg m²]; default that of the evenly filled hull,
        about its own centre.
    feet : array_like, shape (f, 3), optional
        The points that touch the floor in place of the lowest corners: feet, casters, a plinth [m].
    rims : array_like, shape (r, 7), optional
        Circular edges: centre [m], unit axis out of the body, radius [m]. The corners on them stand for the
        circles, which they are inscribed in; a plane meets the circle itself.
    base : str, optional
        What bears on the floor, as of a `Body`: "flat", "edges" or "feet"; default "feet" of a body with
        ``feet``, otherwise "flat".

    Attributes
    ----------
    vertices : ndarray, shape (n, 3)
        Corners [m].
    faces : tuple of ndarray
        Indices of the corners of each face, counter-clockwise as seen from outside; corners of a face may lie
        out of its plane by 1e-6 of the size.
    mass : float
        Mass [kg].
    centre_of_gravity : ndarray, shape (3,)
        G [m].
    inertia : ndarray, shape (3, 3)
        Inertia tensor about G [kg m²].
    feet : ndarray, shape (f, 3), or None
        Feet [m].
    rims : ndarray, shape (r, 7)
        Circular edges.
    base : str
        What bears on the floor.
    normals : ndarray, shape (n, 3)
        Outward unit normals of the faces.
    principal : tuple of ndarray
        Principal moments [kg m²], shape (3,), and the rotation R, shape (3, 3), of the axes: its columns. The
        inertia is R diag(moments) Rᵀ; see `principal_axes`, which brings R near to the identity.
    up_at_rest : ndarray, shape (3,), or None
        What points up, in the frame of the body, while it rests on its base; None where it does not stand.
        It is (0, 0, 1) but for feet of unequal heights.

    Raises
    ------
    InputError
        Numbers that are not finite or not sane, points in a plane, too many corners, G outside, or a tensor
        that no body has.
    """

    vertices: NDArray[np.float64] = cast("Any", solid_fields.Copied())
    faces: tuple[NDArray[np.int64], ...] = field(init=False)
    mass: float
    centre_of_gravity: NDArray[np.float64] = cast("Any", solid_fields.Copied())
    inertia: NDArray[np.float64] = cast("Any", solid_fields.Copied())
    feet: NDArray[np.float64] | None = cast("Any", solid_fields.Copied())
    rims: NDArray[np.float64] = cast("Any", solid_fields.Copied())
    base: str
    normals = cast("NDArray[np.float64]", solid_fields.Copied())  # which follow from the fields, and are none
    up_at_rest = cast("NDArray[np.float64] | None", solid_fields.Copied())
    principal: tuple[NDArray[np.float64], NDArray[np.float64]] = field(init=False)

    def __init__(
        self,
        vertices: ArrayLike,
        mass: float,
        *,
        centre_of_gravity: ArrayLike | None = None,
        inertia: ArrayLike | None = None,
        feet: ArrayLike | None = None,
        rims: ArrayLike = (),
        base: str | None = None,
    ) -> None:
        points = solid_fields.array_of_shape("vertices", vertices, (None, 3))
        polyhedron.check_size(points, "vertices")
        hull = polyhedron.convex_hull(points)
        if len(hull.vertices) > MOST_VERTICES:
            raise too_many(
                "mechanics.the_body", len(hull.vertices), "solids.corners", MOST_VERTICES, "vertices"
            )
        mass = solid_fields.checked_mass(mass)
        centre = hull.filled.centroid if centre_of_gravity is None else centre_of_gravity
        fields: dict[str, Any] = {
            "vertices": solid_fields.read_only(hull.vertices),
            "faces": tuple(solid_fields.read_only(face) for face in hull.faces),
            "mass": mass,
            "centre_of_gravity": solid_fields.checked_centre(hull, centre),
            "inertia": solid_fields.checked_inertia(hull, mass, inertia),
            "feet": None if feet is None else solid_fields.checked_feet(hull, feet),
            "rims": solid_fields.checked_rims(rims),
            "base": ("flat" if feet is None else "feet") if base is None else base,
        }
        fields["normals"] = solid_fields.read_only(hull.planes[:, :3])
        moments, axes = polyhedron.principal_axes(fields["inertia"])
        fields["principal"] = solid_fields.read_only(moments), solid_fields.read_only(axes)
        for name, value in fields.items():
            object.__setattr__(self, name, value)
        object.__setattr__(self, "up_at_rest", self._up_at_rest())

    def __repr__(self) -> str:
        sides = " × ".join(f"{side:.4g}" for side in np.ptp(self.vertices, axis=0))
        return f"Solid({sides} m, {self.mass:g} kg, {len(self.vertices)} corners, {len(self.faces)} faces)"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Solid):
            return NotImplemented
        if other is self:
            return True
        mine, theirs = self._inputs, other._inputs
        return all(np.array_equal(mine[name], theirs[name]) for name in mine)

    def __hash__(self) -> int:
        return hash((self.mass, self.vertices.tobytes(), self.centre_of_gravity.tobytes()))

    def __reduce__(self) -> tuple[Any, ...]:  # so that a pickled solid comes back checked and read-only
        return partial(Solid, **self._inputs), ()

    @property
    def _inputs(self) -> dict[str, Any]:
        """All that a solid is made of, by the names of its arguments."""
        return {about.name: getattr(self, about.name) for about in fields(self) if about.init}

    @property
    def base_points(self) -> NDArray[np.float64]:
        """The points that touch a level floor: the feet, or the lowest corners [m], shape (k, 3)."""
        if self.feet is not None:
            return self.feet
        heights = self.vertices[:, 2]
        return self.vertices[
            heights <= heights.min() + polyhedron.TOLERANCE * polyhedron.size_of(self.vertices)
        ]

    @property
    def standing_rim(self) -> NDArray[np.float64] | None:
        """The circular edge that touches a level floor all around, if there is one."""
        if self.feet is not None or not len(self.rims):
            return None
        lowest = float(self.vertices[:, 2].min()) + polyhedron.TOLERANCE * polyhedron.size_of(self.vertices)
        level = (self.rims[:, 2] <= lowest) & (np.abs(self.rims[:, 5]) > 1.0 - 1e-9)
        return self.rims[np.argmax(level)] if level.any() else None

    def _up_at_rest(self) -> NDArray[np.float64] | None:
        tolerance = polyhedron.TOLERANCE * polyhedron.size_of(self.vertices)
        if (rim := self.standing_rim) is not None:
            stands = math.dist(self.centre_of_gravity[:2], rim[:2]) < rim[6]
            return solid_fields.read_only(np.array([0.0, 0.0, 1.0])) if stands else None
        up = polyhedron.up_at_rest(self.base_points, self.centre_of_gravity, tolerance)
        return None if up is None else solid_fields.read_only(up)

    @property
    def stands(self) -> bool:
        """Whether it rests on its base: G lies above what the points of the base span."""
        return self.up_at_rest is not None

    @classmethod
    def of_case(cls, case: np.void) -> Solid:
        """Make the box of a row of `CASE`.

        Its moments of inertia are those of `stayput.model.polyhedron.moments_of_furniture`. Base corners that
        are inset, or at unequal heights, become feet at both ends of the length; the insets are along x
        alone. Over a floor that gives, the feet are those of the narrower base that takes as much energy to
        overturn.

        Raises
        ------
        InputError
            No length.
        """
        if math.isnan(case["length"]):
            raise no_length()
        names = ("mass", "length", "half_base", "roll_inertia", "inertia", "yaw_inertia")
        # 0 added: −0 is the same key as 0, and should be the same number
        u, v = (tuple((case[name] + 0.0).tolist()) for name in ("u", "v"))
        return _box_of_section(u, v, *(float(case[name]) + 0.0 for name in names), BASES[int(case["base"])])


def corners_of_box(
    u: tuple[float, ...], v: tuple[float, ...], length: float
) -> list[tuple[float, float, float]]:
    """Return the corners of a box in space [m], of which ``u`` and ``v`` are those of a row of `CASE`."""
    (_, _, c, d), (v_a, v_b, top, _), half = u, v, 0.5 * length
    middle, low = 0.5 * (c + d), min(v_a, v_b)
    outline = [(x - middle, z - low) for x, z in ((c, v_a), (d, v_b), (c, top), (d, top))]
    return [(x, y, z) for x, z in outline for y in (-half, half)]


# A verification shakes the same pieces with each measure.
@lru_cache(maxsize=512)
def _box_of_section(
    u: tuple[float, ...],
    v: tuple[float, ...],
    mass: float,
    length: float,
    half_base: float,
    roll_inertia: float,
    inertia: float,
    yaw_inertia: float,
    base: str,
) -> Solid:
    """Return a box with feet where they are not the corners of its base; see `Solid.of_case`."""
    (a, b, c, d), (v_a, v_b, _, _) = u, v
    half, middle, low = 0.5 * length, 0.5 * (c + d), min(v_a, v_b)
    feet = [(x - middle, y, z - low) for x, z in ((a, v_a), (b, v_b)) for y in (-half_base, half_base)]
    on_corners = (a, b, half_base) == (c, d, half) and v_a == v_b
    return Solid(
        corners_of_box(u, v, length),
        mass,
        centre_of_gravity=(-middle, 0.0, -low),
        inertia=mass * np.diag([roll_inertia, inertia, yaw_inertia]),
        feet=None if on_corners else feet,
        base=base,
    )
