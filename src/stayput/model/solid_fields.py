"""What the fields of a `Solid` may be: arrays of numbers, or the mesh of an STL or OBJ file; or a refusal."""

from __future__ import annotations

import os
from errno import ENOENT
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, absent, instance_of, not_allowed, reason_of, unknown, within
from stayput.model import polyhedron
from stayput.model.parameters import MASS_RANGE, SIZE_RANGE

MOST_FEET = 32
"""Most feet of a body."""

LARGEST = 1e12
"""Largest number that is accepted, of any unit."""


class Copied:
    """An array of a frozen value, of which every reader has a copy.

    What is read-only is no input for the compiled code of other libraries, such as SciPy's rotations.
    """

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    def __get__(self, value: Any, owner: type) -> Any:
        if value is None:  # the class has no default
            raise AttributeError(self._name)
        array = value.__dict__[self._name]
        return None if array is None else array.copy()

    def __set__(self, value: Any, array: Any) -> None:
        value.__dict__[self._name] = array


def array_of_shape(name: str, value: ArrayLike, shape: tuple[int | None, ...]) -> NDArray[np.float64]:
    """Return a copy of numbers as an array of a shape, None for any length, that cannot be written to."""
    called, actual = phrase(f"solids.{name}"), ("irregular", "不規則")
    try:
        array = np.array(value, np.float64)
        actual = str(array.shape)
    except (TypeError, ValueError, OverflowError):
        array = np.zeros(0)
    fits = array.ndim == len(shape) and all(
        side in (None, length) for side, length in zip(shape, array.shape, strict=True)
    )
    if not fits or not array.size:
        shape_of = phrase("common.shape_of", name=called)
        raise not_allowed(shape_of, actual, str(shape).replace("None", "n"), name)
    check_numbers(array, called, name)
    return read_only(array)


def check_numbers(array: NDArray[np.float64], called: Phrase, field: str) -> None:
    """Refuse numbers of which one is NaN, infinite, or so large that its square is of no use."""
    if not np.abs(array).max() <= LARGEST:
        raise InputError("solids.not_finite", field, name=called, largest=LARGEST)


def read_only(array: Any) -> Any:
    """Return an array after it was made read-only."""
    array.setflags(write=False)
    return array


def side(name: str, value: float) -> float:
    """Return a length of a body [m], or refuse one that is not possible."""
    return within(f"solids.{name}", value, *SIZE_RANGE, "m", name)


def checked_mass(value: float) -> float:
    """Return a mass [kg], or refuse one that is not possible."""
    return within("solids.mass", value, *MASS_RANGE, "kg", "mass")


def checked_centre(hull: polyhedron.Hull, value: ArrayLike) -> NDArray[np.float64]:
    """Return the centre of gravity, or refuse one outside the hull."""
    point = array_of_shape("centre_of_gravity", value, (3,))
    depth = float((hull.planes[:, :3] @ point - hull.planes[:, 3]).max())
    if depth > polyhedron.TOLERANCE * polyhedron.size_of(hull.vertices):
        text = f"({', '.join(f'{x:.4g}' for x in point)})"
        raise InputError("solids.cg_outside", "centre_of_gravity", point=text, depth=depth)
    return point


def checked_inertia(hull: polyhedron.Hull, mass: float, value: ArrayLike | None) -> NDArray[np.float64]:
    """Return the inertia tensor, made symmetric to the bit, or refuse what no body of the shape has."""
    tensor = array_of_shape("inertia", hull.inertia(mass) if value is None else value, (3, 3))
    difference = float(np.abs(tensor - tensor.T).max())
    if difference > 1e-9 * np.abs(tensor).max():
        raise InputError("solids.inertia_not_symmetric", "inertia", difference=difference)
    tensor = (tensor + tensor.T) / 2.0
    moments = np.linalg.eigvalsh(tensor)
    text = f"{', '.join(f'{moment:.4g}' for moment in moments)} kg m²"
    if not (moments[0] > 0.0 and moments[2] <= (1.0 + 1e-9) * (moments[0] + moments[1])):
        raise not_allowed("solids.moments", text, "solids.possible_moments", "inertia")
    # what other units would give: kg mm², g m²
    high = 4.0 * mass * float((np.ptp(hull.vertices, axis=0) ** 2).sum())
    if not 1e-7 * high <= moments[0] <= moments[2] <= high:  # the filled hull has no moment as large as high
        low = 1e-7 * float(np.linalg.eigvalsh(hull.inertia(mass))[0])
        if not low <= moments[0] <= moments[2] <= high:
            allowed = phrase("solids.usual_moments", low=low, high=high)
            raise not_allowed("solids.moments", text, allowed, "inertia")
    return read_only(tensor)


def checked_feet(hull: polyhedron.Hull, value: ArrayLike) -> NDArray[np.float64]:
    """Return feet, shape (f, 3) [m], or refuse none, too many, or one that is not at the foot of the body."""
    feet = array_of_shape("feet", value, (None, 3))
    within("solids.number_of_feet", len(feet), 1, MOST_FEET, "", "feet")
    low, high = hull.vertices.min(axis=0), hull.vertices.max(axis=0)
    reach = 0.5 * polyhedron.size_of(hull.vertices)
    most = np.array([*(high[:2] + reach), 0.5 * (low[2] + high[2])])
    astray = ((feet < low - reach) | (feet > most)).any(axis=1)
    if astray.any():
        text = f"({', '.join(f'{x:.4g}' for x in feet[astray][0])})"
        raise InputError("solids.foot_astray", "feet", point=text, reach=reach)
    return feet


def checked_rims(value: ArrayLike) -> NDArray[np.float64]:
    """Return circular edges, shape (r, 7), or refuse those that are no circles."""
    if not np.size(np.asarray(value)):
        return read_only(np.zeros((0, 7)))
    rims = array_of_shape("rims", value, (None, 7))
    axes, radii = np.linalg.norm(rims[:, 3:6], axis=1), rims[:, 6]
    if np.abs(axes - 1.0).max() > 1e-9 or radii.min() <= 0.0:
        raise InputError("solids.rims_wrong", "rims")
    return rims


UNITS = {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "in": 0.0254, "ft": 0.3048}
"""Units of length that a mesh may be in [m]."""

UP = {"x": (1, 2, 0), "y": (2, 0, 1), "z": (0, 1, 2)}
"""The file's axes that become x, y and z, by the one that points up."""

FORMATS = {".stl": "STL", ".obj": "OBJ"}
"""Formats by the endings of files' names."""

MOST_BYTES = 200_000_000
"""Largest file that is read."""

SAME_PLACE = 1e-8
"""Corners as near as this, as a part of the mesh's size, are at the same place."""

LEAST_FILLED = 0.999
"""Smallest part of its convex hull that a mesh must fill to be taken for it."""

_USUAL_SIZE = (0.05, 10.0)


def read_convex_mesh(file: str | Path, unit: str, up: str) -> polyhedron.Hull:
    """Return the convex hull of the closed and convex mesh in a file [m].

    Parameters
    ----------
    file : str or Path
        STL, binary or ASCII, or OBJ.
    unit : str
        A key of `UNITS`.
    up : str
        The axis of the file that points up: "x", "y" or "z"; the other two follow, and the shape is not
        mirrored.

    Raises
    ------
    InputError
        A file that is none of these, or a mesh that is empty, of an absurd size, open, inside out, flat or
        not convex.
    """
    if unit not in UNITS:
        raise unknown("solids.unit", unit, UNITS, "unit")
    if up not in UP:
        raise unknown("solids.up", up, UP, "up")
    instance_of("file", file, (str, os.PathLike))
    corners = UNITS[unit] * _corners(Path(file))[:, UP[up]]
    polyhedron.check_size(corners, "unit", _hint(polyhedron.size_of(corners), unit))
    points, triangles = _joined(corners)
    _check_closed(triangles)
    hull = polyhedron.convex_hull(points)
    volume = polyhedron.enclosed_volume(points, triangles)
    if volume <= 0.0:
        raise InputError("solids.mesh_inside_out", "file")
    share = volume / polyhedron.enclosed_volume(hull.vertices, polyhedron.triangulated(hull.faces))
    if share < LEAST_FILLED:
        raise InputError("solids.not_convex", "file", share=share, least=LEAST_FILLED)
    return hull


def _corners(path: Path) -> NDArray[np.float64]:
    """Return the corners of a file's triangles in its unit, three after three, shape (3t, 3)."""
    name, suffix = repr(str(path)), path.suffix.lower()
    if suffix not in FORMATS:
        allowed = phrase("model.wrong_suffix", suffixes=", ".join(FORMATS))
        raise not_allowed("solids.mesh_file", name, allowed, "file")
    try:
        import trimesh
    except ImportError as error:
        raise absent("A mesh", error.name or "trimesh", "space") from None
    try:
        # a pipe would wait for ever, and no file has a name with NUL
        if "\0" in str(path) or path.is_fifo():
            raise FileNotFoundError(ENOENT, os.strerror(ENOENT))
        size = path.stat().st_size
        if size > MOST_BYTES:
            raise InputError("common.too_many_bytes", "file", file=name, size=size, most=MOST_BYTES)
        content = path.read_bytes()
    except OSError as error:
        reason = reason_of(error)
        raise InputError("common.unreadable", "file", file=name, reason=reason) from None
    if not content.strip():
        raise not_allowed("solids.mesh_file", name, "solids.mesh_empty", "file")
    try:
        with np.errstate(all="ignore"):
            mesh: Any = trimesh.load_mesh(
                BytesIO(content), file_type=suffix[1:], process=False, skip_materials=True
            )
        corners = np.asarray(mesh.vertices, np.float64)[np.asarray(mesh.faces, np.int64)].reshape(-1, 3)
    except Exception:  # of a file that is no mesh trimesh may raise anything
        corners = np.zeros((0, 3))
    if not len(corners):
        raise InputError("solids.mesh_unreadable", "file", file=name, format=FORMATS[suffix])
    check_numbers(corners, phrase("solids.vertices"), "file")
    return corners


def _joined(corners: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Return vertices and triangles of the corners of triangles, three after three, shape (3t, 3).

    STL has no common corners, and OBJ one for each normal: those at the same place become one vertex.
    """
    grid: NDArray[np.float64] = np.rint(
        (corners - corners.min(axis=0)) / (SAME_PLACE * polyhedron.size_of(corners))
    )
    _, first, vertex = np.unique(grid, axis=0, return_index=True, return_inverse=True)
    triangles = vertex.reshape(-1, 3).astype(np.int64)
    with_area = (triangles != np.roll(triangles, 1, axis=1)).all(axis=1)
    return corners[first], triangles[with_area]


def _hint(size: float, unit: str) -> str | Phrase:
    """Return the question for a unit in which a mesh would have a usual size, or "" where none is."""
    low, high = _USUAL_SIZE
    sizes = {other: size / UNITS[unit] * metres for other, metres in UNITS.items()}
    likely = [other for other, scaled in sizes.items() if low <= scaled <= high]
    return phrase("solids.is_the_unit", unit=likely[0]) if likely and unit not in likely else ""


def _check_closed(triangles: NDArray[np.int64]) -> None:
    """Refuse triangles that do not enclose a space, or that are not all turned alike."""
    edges = np.concatenate([triangles[:, (0, 1)], triangles[:, (1, 2)], triangles[:, (2, 0)]])
    _, count = np.unique(np.sort(edges, axis=1), axis=0, return_counts=True)
    if (count != 2).any():
        raise InputError("solids.mesh_open", "file", count=int((count != 2).sum()))
    if len(np.unique(edges, axis=0)) < len(edges):
        raise InputError("solids.mesh_inside_out", "file")
