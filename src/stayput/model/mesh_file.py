"""Closed meshes of triangles from STL and OBJ files, read by trimesh."""

from __future__ import annotations

import os
from errno import ENOENT
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, absent, instance_of, reason_of, unknown
from stayput.model.polyhedron import (
    check_filled,
    check_size,
    convex_hull,
    enclosed_volume,
    size_of,
    triangulated,
)
from stayput.model.solid_fields import check_numbers

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.catalogue import Phrase
    from stayput.model.polyhedron import Hull

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

_USUAL_SIZE = (0.05, 10.0)


def read_convex_mesh(file: str | Path, unit: str, up: str) -> Hull:
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
    check_size(corners, "unit", _hint(size_of(corners), unit))
    points, triangles = _joined(corners)
    _check_closed(triangles)
    hull = convex_hull(points)
    volume = enclosed_volume(points, triangles)
    if volume <= 0.0:
        raise InputError("solids.mesh_inside_out", "file")
    check_filled(volume, enclosed_volume(hull.vertices, triangulated(hull.faces)), "file")
    return hull


def _corners(path: Path) -> NDArray[np.float64]:
    """Return the corners of a file's triangles in its unit, three after three, shape (3t, 3)."""
    name, suffix = repr(str(path)), path.suffix.lower()
    if suffix not in FORMATS:
        raise InputError("solids.mesh_suffix", "file", file=name, suffixes=", ".join(FORMATS))
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
            raise InputError("solids.mesh_too_large", "file", file=name, size=size, most=MOST_BYTES)
        content = path.read_bytes()
    except OSError as error:
        reason = reason_of(error)
        raise InputError("solids.mesh_no_file", "file", file=name, reason=reason) from None
    if not content.strip():
        raise InputError("solids.mesh_empty", "file", file=name)
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
    grid: NDArray[np.float64] = np.rint((corners - corners.min(axis=0)) / (SAME_PLACE * size_of(corners)))
    _, first, vertex = np.unique(grid, axis=0, return_index=True, return_inverse=True)
    triangles = vertex.reshape(-1, 3).astype(np.int64)
    with_area = (triangles != np.roll(triangles, 1, axis=1)).all(axis=1)
    return corners[first], triangles[with_area]


def _hint(size: float, unit: str) -> str | Phrase:
    """Return the question for a unit in which a mesh would have a usual size, or "" where none is."""
    low, high = _USUAL_SIZE
    sizes = {other: size / UNITS[unit] * metres for other, metres in UNITS.items()}
    likely = [other for other, told in sizes.items() if low <= told <= high]
    return phrase("solids.is_the_unit", unit=likely[0]) if likely and unit not in likely else ""


def _check_closed(triangles: NDArray[np.int64]) -> None:
    """Refuse triangles that do not enclose a space, or that are not all turned alike."""
    edges = np.concatenate([triangles[:, (0, 1)], triangles[:, (1, 2)], triangles[:, (2, 0)]])
    _, count = np.unique(np.sort(edges, axis=1), axis=0, return_counts=True)
    if (count != 2).any():
        raise InputError("solids.mesh_open", "file", count=int((count != 2).sum()))
    if len(np.unique(edges, axis=0)) < len(edges):
        raise InputError("solids.mesh_inside_out", "file")
