"""Bodies by their shape in space: the convex hull of points, boxes, cones, prisms, meshes."""

from __future__ import annotations

import math
from functools import lru_cache
from pathlib import Path
from typing import Any, Self, TypedDict, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.errors import InputError, within
from stayput.model.parameters import DENSITY_RANGE
from stayput.model.polyhedron import enclosed_volume, inertia_of, triangulated, uniform_cone
from stayput.model.solid import Solid
from stayput.model.solid_fields import checked_mass, read_convex_mesh, side

SIDES = 32
"""Sides of the polygons that stand for circles."""


class OwnFields(TypedDict, total=False):
    """What a shape may have in place of what follows from filling it evenly; see `Shapes.hull`."""

    centre_of_gravity: ArrayLike
    inertia: ArrayLike
    feet: ArrayLike
    base: str


def section_of(shape: Solid) -> tuple[Any, ...]:
    """Return the fields of a `stayput.Body` of a shape, in their order: those of the box around it.

    Its base corners are those of the points on which the shape stands, as inset as they are.
    """
    low, high = shape.vertices.min(axis=0), shape.vertices.max(axis=0)
    width, length, height = (high - low).tolist()
    x, _, z = (shape.centre_of_gravity - (low + high) / 2).tolist()
    stands = shape.base_points[:, 0]
    insets = float(stands.min() - low[0]), float(high[0] - stands.max())
    return (
        width,
        height,
        shape.mass,
        (x, z),
        float(shape.inertia[1, 1]),
        (0.0, 0.0),
        insets,
        length,
        shape.base,
        shape,
    )


class Shapes:
    """The ways to make a `stayput.Body` of another shape than a box with a section.

    Its frame has x along the depth (front +x, back −x), y across, z up, as it stands upright.
    """

    __slots__ = ()

    @classmethod
    @lru_cache(maxsize=256)
    def of_shape(cls, shape: Solid) -> Self:
        """Make the body of a solid."""
        make: Any = cls
        return make(*section_of(shape))

    @classmethod
    def hull(
        cls, vertices: ArrayLike, mass: float, *, rims: ArrayLike = (), **extra: Unpack[OwnFields]
    ) -> Self:
        """Make the convex hull of points, by default filled evenly.

        Parameters
        ----------
        vertices : array_like, shape (k, 3)
            The points [m]; those that are no corners are left out. A `stayput.Piece` stands where the origin
            is.
        mass : float
            Mass m [kg].
        rims : array_like, shape (r, 7), optional
            Circular edges: centre [m], unit axis out of the body, radius [m]. The corners on them stand for
            the circles, which they are inscribed in; a plane meets the circle itself.
        **extra
            ``centre_of_gravity``: G, inside the body, shape (3,) [m]. ``inertia``: the tensor about G along
            the axes of the frame, shape (3, 3) [kg m²]. ``feet``: the points that touch the floor in place of
            the lowest corners: feet, casters, a plinth, shape (f, 3) [m]. ``base``: what bears on the floor,
            as of a `stayput.Body`; default "feet" with ``feet``, otherwise "flat".

        Raises
        ------
        InputError
            Numbers that are not finite or not sane, points in a plane, too many corners, G outside, or a
            tensor that no body has.

        Examples
        --------
        >>> import stayput as sp
        >>> base = [(x, y, 0.0) for x in (-0.2, 0.2) for y in (-0.3, 0.3)]
        >>> wedge = sp.Body.hull([*base, (-0.2, -0.3, 1.2), (-0.2, 0.3, 1.2)], mass=30.0)  # m, kg
        >>> [round(place, 3) + 0.0 for place in wedge.solid.centre_of_gravity.tolist()]  # m
        [-0.067, 0.0, 0.4]
        """
        return cls.of_shape(Solid(vertices, mass, rims=rims, **extra))

    @classmethod
    def box(cls, width: float, length: float, height: float, mass: float, **extra: Unpack[OwnFields]) -> Self:
        """Make a box, by default filled evenly.

        Parameters
        ----------
        width, length, height : float
            Sides along x, y and z [m]: the depth of a piece of furniture, its length across, its height.
        mass : float
            Mass [kg].
        **extra
            As for `hull`.
        """
        sides = np.array([side("width", width), side("length", length), side("height", height)])
        corners = np.array([(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (0.0, 1.0)])
        mass = checked_mass(mass)
        inertia = mass * inertia_of(np.diag(sides**2) / 12.0)
        filled: OwnFields = {"centre_of_gravity": (0.0, 0.0, sides[2] / 2), "inertia": inertia}
        return cls.hull(sides * corners, mass, **(filled | extra))

    @classmethod
    def cylinder(cls, diameter: float, height: float, mass: float, **extra: Unpack[OwnFields]) -> Self:
        """Make an upright cylinder, by default filled evenly; see `cone`.

        Parameters
        ----------
        diameter, height : float
            Sizes [m].
        mass : float
            Mass [kg].
        **extra
            As for `hull`.
        """
        across = side("diameter", diameter)
        return cls.cone(across, across, height, mass, **extra)

    @classmethod
    def cone(cls, bottom: float, top: float, height: float, mass: float, **extra: Unpack[OwnFields]) -> Self:
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
        **extra
            As for `hull`.
        """
        R, r, h = side("bottom", bottom) / 2, side("top", top) / 2, side("height", height)
        z_g, second_moments = uniform_cone(R, r, h)
        mass = checked_mass(mass)
        inertia = mass * inertia_of(second_moments)
        filled: OwnFields = {"centre_of_gravity": (0.0, 0.0, z_g), "inertia": inertia}
        ends = [np.column_stack((radius * _circle(), np.full(SIDES, z))) for radius, z in ((R, 0.0), (r, h))]
        rims = [(0.0, 0.0, 0.0, 0.0, 0.0, -1.0, R), (0.0, 0.0, h, 0.0, 0.0, 1.0, r)]
        return cls.hull(np.concatenate(ends), mass, rims=rims, **(filled | extra))

    @classmethod
    def mesh(
        cls,
        file: str | Path,
        *,
        unit: str,
        mass: float | None = None,
        density: float | None = None,
        up: str = "z",
        **extra: Unpack[OwnFields],
    ) -> Self:
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
        **extra
            As for `hull`, in the frame of the body.

        Raises
        ------
        InputError
            A file or mesh that `stayput.model.solid_fields.read_convex_mesh` refuses, no mass or two, or what
            `hull` refuses.
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
        return cls.hull(vertices - origin, mass, **extra)


def _circle() -> NDArray[np.float64]:
    """Return x and y of the corners of the polygon in the unit circle, shape (SIDES, 2).

    An eighth of the circle gives the others, so that they mirror each other to the bit.
    """
    eighth = np.exp(2j * math.pi * np.arange(SIDES // 8) / SIDES)
    # from 45° back to 90°: the mirror image in the diagonal
    quarter = np.concatenate([eighth, [math.sqrt(0.5) * (1 + 1j)], (1j * eighth[:0:-1].conj())])
    whole = np.concatenate([quarter * turn for turn in (1, 1j, -1, -1j)])
    return np.column_stack((whole.real, whole.imag))
