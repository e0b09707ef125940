"""`Solid`: a convex rigid body in space, and the shapes that furniture has."""

# ruff: noqa: RUF009 - descriptors, one for each field, are no defaults

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields, replace
from functools import lru_cache, partial
from typing import TYPE_CHECKING, Any, TypedDict, cast

import numpy as np

from stayput.errors import InputError, instance_of, within
from stayput.model.body import BASES, Body
from stayput.model.flat_fields import case_columns
from stayput.model.inertia import inertia_of, principal_axes, uniform_cone
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.polyhedron import (
    TOLERANCE,
    check_filled,
    check_size,
    convex_hull,
    enclosed_volume,
    size_of,
    triangulated,
    uniform_solid,
    up_at_rest,
)
from stayput.model.room import Floor, Room
from stayput.model.solid_fields import (
    Copied,
    checked_base,
    checked_centre,
    checked_feet,
    checked_inertia,
    checked_mass,
    checked_rims,
    numbers,
    read_convex_mesh,
    read_only,
    side,
)
from stayput.model.state import State

if TYPE_CHECKING:
    from pathlib import Path
    from typing import Unpack

    from numpy.typing import ArrayLike, NDArray


MOST_VERTICES = 500
"""Most corners of a body."""

SIDES = 32
"""Sides of the polygons that stand for circles."""

DENSITY_RANGE = (1.0, 25_000.0)
"""Smallest and largest density that is accepted [kg/m³]."""


class OwnFields(TypedDict, total=False):
    """What a shape may have in place of what follows from filling it evenly; see `Solid`."""

    centre_of_gravity: ArrayLike | None
    inertia: ArrayLike | None
    feet: ArrayLike | None
    base: str | None


@dataclass(frozen=True, eq=False, repr=False, init=False)
class Solid:
    """A convex rigid body in space.

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

    Examples
    --------
    >>> import stayput as sp
    >>> base = [(x, y, 0.0) for x in (-0.2, 0.2) for y in (-0.3, 0.3)]
    >>> wedge = sp.Solid([*base, (-0.2, -0.3, 1.2), (-0.2, 0.3, 1.2)], mass=30.0)  # m, kg
    >>> [round(place, 3) + 0.0 for place in wedge.centre_of_gravity.tolist()]  # m
    [-0.067, 0.0, 0.4]

    Turned a quarter about the vertical:

    >>> from scipy.spatial.transform import Rotation
    >>> quarter = Rotation.from_euler("z", 90, degrees=True)
    >>> (quarter.apply(wedge.centre_of_gravity).round(3) + 0.0).tolist()  # m
    [0.0, -0.067, 0.4]
    """

    vertices: NDArray[np.float64] = cast("Any", Copied())
    faces: tuple[NDArray[np.int64], ...] = field(init=False)
    mass: float
    centre_of_gravity: NDArray[np.float64] = cast("Any", Copied())
    inertia: NDArray[np.float64] = cast("Any", Copied())
    feet: NDArray[np.float64] | None = cast("Any", Copied())
    rims: NDArray[np.float64] = cast("Any", Copied())
    base: str
    normals = cast("NDArray[np.float64]", Copied())  # which follow from the fields, and are none
    up_at_rest = cast("NDArray[np.float64] | None", Copied())
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
        points = numbers("vertices", vertices, (None, 3))
        check_size(points, "vertices")
        hull = convex_hull(points)
        if len(hull.vertices) > MOST_VERTICES:
            raise InputError("solids.too_many", "vertices", count=len(hull.vertices), most=MOST_VERTICES)
        mass = checked_mass(mass)
        uniform = uniform_solid(hull.vertices, triangulated(hull.faces))
        usual = mass * inertia_of(uniform.second_moments)
        fields: dict[str, Any] = {
            "vertices": read_only(hull.vertices),
            "faces": tuple(read_only(face) for face in hull.faces),
            "mass": mass,
            "centre_of_gravity": checked_centre(
                hull, uniform.centroid if centre_of_gravity is None else centre_of_gravity
            ),
            "inertia": checked_inertia(hull, mass, usual, usual if inertia is None else inertia),
            "feet": None if feet is None else checked_feet(hull, feet),
            "rims": checked_rims(rims),
            "base": checked_base(("flat" if feet is None else "feet") if base is None else base),
        }
        fields["normals"] = read_only(hull.planes[:, :3])
        moments, axes = principal_axes(fields["inertia"])
        fields["principal"] = read_only(moments), read_only(axes)
        for name, value in fields.items():
            object.__setattr__(self, name, value)
        object.__setattr__(self, "up_at_rest", self._up_at_rest())

    def __repr__(self) -> str:
        sides = " × ".join(f"{side:.4g}" for side in np.ptp(self.vertices, axis=0))
        return f"Solid({sides} m, {self.mass:g} kg, {len(self.vertices)} corners, {len(self.faces)} faces)"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Solid):
            return NotImplemented
        mine, theirs = self._inputs, other._inputs
        return all(np.array_equal(mine[name], theirs[name]) for name in mine)

    def __hash__(self) -> int:
        return hash((self.mass, self.vertices.tobytes(), self.centre_of_gravity.tobytes()))

    def __reduce__(self) -> tuple[Any, ...]:  # so that a pickled solid comes back checked and read-only
        return partial(Solid, **self._inputs), ()

    @property
    def _inputs(self) -> dict[str, Any]:
        """All that a solid is made of, by the names of its arguments."""
        return {one.name: getattr(self, one.name) for one in fields(self) if one.init}

    @property
    def base_points(self) -> NDArray[np.float64]:
        """The points that touch a level floor: the feet, or the lowest corners [m], shape (k, 3)."""
        if self.feet is not None:
            return self.feet
        heights = self.vertices[:, 2]
        return self.vertices[heights <= heights.min() + TOLERANCE * size_of(self.vertices)]

    @property
    def standing_rim(self) -> NDArray[np.float64] | None:
        """The circular edge that touches a level floor all around, if there is one."""
        lowest = float(self.vertices[:, 2].min()) + TOLERANCE * size_of(self.vertices)
        level = (self.rims[:, 2] <= lowest) & (np.abs(self.rims[:, 5]) > 1.0 - 1e-9)
        return self.rims[np.argmax(level)] if self.feet is None and level.any() else None

    def _up_at_rest(self) -> NDArray[np.float64] | None:
        tolerance = TOLERANCE * size_of(self.vertices)
        if (rim := self.standing_rim) is not None:
            stands = math.dist(self.centre_of_gravity[:2], rim[:2]) < rim[6]
            return read_only(np.array([0.0, 0.0, 1.0])) if stands else None
        up = up_at_rest(self.base_points, self.centre_of_gravity, tolerance)
        return None if up is None else read_only(up)

    @property
    def stands(self) -> bool:
        """Whether it rests on its base: G lies above what the points of the base span."""
        return self.up_at_rest is not None

    @classmethod
    def box(cls, width: float, length: float, height: float, mass: float, **own: Unpack[OwnFields]) -> Solid:
        """Make a box, by default filled evenly.

        Parameters
        ----------
        width, length, height : float
            Sides along x, y and z [m]: the depth of a piece of furniture, its length across, its height.
        mass : float
            Mass [kg].
        **own
            `centre_of_gravity`, `inertia`, `feet` and `base` as for `Solid`.
        """
        sides = np.array([side("width", width), side("length", length), side("height", height)])
        corners = np.array([(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (0.0, 1.0)])
        mass = checked_mass(mass)
        filled = _filled(sides[2] / 2, mass * inertia_of(np.diag(sides**2) / 12.0), own)
        return cls(sides * corners, mass, **filled)

    @classmethod
    def cylinder(cls, diameter: float, height: float, mass: float, **own: Unpack[OwnFields]) -> Solid:
        """Make an upright cylinder, by default filled evenly; see `cone`.

        Parameters
        ----------
        diameter, height : float
            Sizes [m].
        mass : float
            Mass [kg].
        **own
            `centre_of_gravity`, `inertia`, `feet` and `base` as for `Solid`.
        """
        across = side("diameter", diameter)
        return cls.cone(across, across, height, mass, **own)

    @classmethod
    def cone(cls, bottom: float, top: float, height: float, mass: float, **own: Unpack[OwnFields]) -> Solid:
        """Make an upright truncated cone, by default filled evenly.

        Centre of gravity and inertia are those of the round body. Corners and faces are those of the
        inscribed body with `SIDES` sides, some of whose corners lie in front, behind and at either side.

        Parameters
        ----------
        bottom, top : float
            Diameters of the lower and the upper end [m].
        height : float
            Height [m].
        mass : float
            Mass [kg].
        **own
            `centre_of_gravity`, `inertia`, `feet` and `base` as for `Solid`.
        """
        R, r, h = side("bottom", bottom) / 2, side("top", top) / 2, side("height", height)
        z_g, second_moments = uniform_cone(R, r, h)
        mass = checked_mass(mass)
        filled = _filled(z_g, mass * inertia_of(second_moments), own)
        ends = [np.column_stack((radius * _circle(), np.full(SIDES, z))) for radius, z in ((R, 0.0), (r, h))]
        rims = [(0.0, 0.0, 0.0, 0.0, 0.0, -1.0, R), (0.0, 0.0, h, 0.0, 0.0, 1.0, r)]
        return cls(np.concatenate(ends), mass, rims=rims, **filled)

    @classmethod
    def prism(cls, outline: ArrayLike, height: float, mass: float, **own: Unpack[OwnFields]) -> Solid:
        """Make an upright prism, by default filled evenly.

        Parameters
        ----------
        outline : array_like, shape (k, 2)
            The corners of its convex base in order, either way round: x and y [m]. The middle of the
            rectangle around them becomes the origin.
        height : float
            Height [m].
        mass : float
            Mass [kg].
        **own
            `centre_of_gravity`, `inertia`, `feet` and `base` as for `Solid`.
        """
        corners = numbers("outline", outline, (None, 2))
        corners = corners - (corners.min(axis=0) + corners.max(axis=0)) / 2
        h = side("height", height)
        points = np.concatenate([np.column_stack((corners, np.full(len(corners), z))) for z in (0.0, h)])
        check_size(points, "outline")
        made = cls(points, mass, **own)
        x, y = corners.T
        area = abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2.0
        check_filled(area * h, enclosed_volume(made.vertices, triangulated(made.faces)), "outline")
        return made

    @classmethod
    def of(cls, body: Body, length: float | None = None, *, settlement: float = 0.0) -> Solid:
        """Make the box in space whose section a planar body is.

        Its moments of inertia are those of `stayput.model.inertia.moments_of_furniture`. Base corners that
        are inset, or at unequal heights, become feet at both ends of the length; the insets are along x
        alone.

        Parameters
        ----------
        body : Body
            The section.
        length : float, optional
            Length across the shaking [m]; default the body's.
        settlement : float
            That of the `Floor` under it [m]: the feet are those of the narrower base that takes as much
            energy to overturn as the one that sinks in.

        Raises
        ------
        InputError
            No length, or a number that is not possible.
        """
        instance_of("body", body, Body)
        stands = body if length is None else replace(body, length=length)
        floor = Floor(settlement=settlement)
        return cls.of_case(case_columns(stands, Room(floor), State(), STANDARD_GRAVITY)[0])

    @classmethod
    def of_case(cls, case: np.void) -> Solid:
        """Make the box of a row of `CASE`; see `of`.

        Raises
        ------
        InputError
            No length.
        """
        if math.isnan(case["length"]):
            raise InputError("solids.no_length", "length")
        names = ("mass", "length", "half_base", "roll_inertia", "inertia", "yaw_inertia")
        # 0 added: −0 is the same key as 0, and should be the same number
        u, v = (tuple((case[name] + 0.0).tolist()) for name in ("u", "v"))
        return _box_of_section(u, v, *(float(case[name]) + 0.0 for name in names), BASES[int(case["base"])])

    @classmethod
    def from_mesh(
        cls,
        file: str | Path,
        *,
        unit: str,
        mass: float | None = None,
        density: float | None = None,
        up: str = "z",
        **own: Unpack[OwnFields],
    ) -> Solid:
        """Make a body from the closed and convex mesh of an STL or OBJ file, by default filled evenly.

        The middle of the box around it, at its lowest height, becomes the origin.

        Parameters
        ----------
        file : str or Path
            STL, binary or ASCII, or OBJ.
        unit : str
            Unit of the file's numbers: "mm", "cm", "m", "in" or "ft".
        mass : float, optional
            Mass [kg]; or
        density : float, optional
            Density [kg/m³] of what fills it.
        up : str
            Axis of the file that points up, "x", "y" or "z"; y and x of the body follow cyclically: with
            "y" the file's z is the body's x, the front.
        **own
            `centre_of_gravity`, `inertia`, `feet` and `base` as for `Solid`, in its frame.

        Raises
        ------
        InputError
            A file or mesh that `stayput.model.solid_fields.read_convex_mesh` refuses, no mass or two, or what
            `Solid` refuses.
        """
        if (mass is None) == (density is None):
            raise InputError("solids.mass_or_density", "mass")
        vertices, faces, _ = read_convex_mesh(file, unit, up)
        if density is not None:
            density = within("solids.density", density, *DENSITY_RANGE, "kg/m³", "density")
            mass = density * enclosed_volume(vertices, triangulated(faces))
        assert mass is not None
        low, high = vertices.min(axis=0), vertices.max(axis=0)
        origin = np.array([*(low + high)[:2] / 2, low[2]])
        return cls(vertices - origin, mass, **own)


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
    (a, b, c, d), (v_a, v_b, top, _) = u, v
    half, middle, low = 0.5 * length, 0.5 * (c + d), min(v_a, v_b)
    outline = [(x - middle, z - low) for x, z in ((c, v_a), (d, v_b), (c, top), (d, top))]
    feet = [(x - middle, y, z - low) for x, z in ((a, v_a), (b, v_b)) for y in (-half_base, half_base)]
    on_corners = (a, b, half_base) == (c, d, half) and v_a == v_b
    return Solid(
        [(x, y, z) for x, z in outline for y in (-half, half)],
        mass,
        centre_of_gravity=(-middle, 0.0, -low),
        inertia=mass * np.diag([roll_inertia, inertia, yaw_inertia]),
        feet=None if on_corners else feet,
        base=base,
    )


def _filled(z_g: float, inertia: NDArray[np.float64], own: OwnFields) -> OwnFields:
    """Return the fields of an evenly filled body with G on its axis, and in their place those of its own."""
    filled: OwnFields = {"centre_of_gravity": (0.0, 0.0, z_g), "inertia": inertia}
    given = cast("OwnFields", {name: value for name, value in own.items() if value is not None})
    return filled | given


def _circle() -> NDArray[np.float64]:
    """Return x and y of the corners of the polygon in the unit circle, shape (SIDES, 2).

    An eighth of the circle gives the others, so that they mirror each other to the bit.
    """
    eighth = np.exp(2j * math.pi * np.arange(SIDES // 8) / SIDES)
    # from 45° back to 90°: the mirror image in the diagonal
    quarter = np.concatenate([eighth, [math.sqrt(0.5) * (1 + 1j)], (1j * eighth[:0:-1].conj())])
    whole = np.concatenate([quarter * turn for turn in (1, 1j, -1, -1j)])
    return np.column_stack((whole.real, whole.imag))
