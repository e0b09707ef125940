"""Meshes from STL and OBJ files: what was written comes back, and what encloses no convex body is refused."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import numpy as np
import pytest

from stayput import Body
from stayput.errors import InputError
from stayput.model.polyhedron import triangulated
from stayput.model.solid import Solid
from stayput.model.solid_fields import UNITS

trimesh = pytest.importorskip("trimesh", reason="trimesh is not installed")

SHAPES = {
    "box": Body.box(0.3, 0.8, 1.8, 200.0).solid,
    "cylinder": Body.cylinder(0.4, 1.3, 60.0).solid,
    "cone": Body.cone(0.3, 0.55, 0.9, 12.0).solid,
    "prism": Solid(
        [(x, y, z) for z in (0.0, 0.7) for x, y in ((0.0, 0.0), (0.5, -0.2), (0.9, 0.1), (0.4, 0.6))], 30.0
    ),
    "hull": Solid(np.random.default_rng(5).uniform(-0.5, 0.5, (40, 3)), 8.0),
}


def write_stl(path: Path, vertices: np.ndarray, triangles: np.ndarray) -> Path:
    lines = ["solid thing"]
    for triangle in vertices[triangles]:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += [f"vertex {x!r} {y!r} {z!r}" for x, y, z in triangle.tolist()]
        lines += ["endloop", "endfacet"]
    path.write_text("\n".join([*lines, "endsolid thing\n"]), encoding="ascii")
    return path


def write_binary_stl(path: Path, vertices: np.ndarray, triangles: np.ndarray) -> Path:
    row = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    rows = np.zeros(len(triangles), row)
    rows["corners"] = vertices[triangles]
    path.write_bytes(b"\0" * 80 + np.uint32(len(rows)).tobytes() + rows.tobytes())
    return path


def write_obj(path: Path, vertices: np.ndarray, faces: tuple[np.ndarray, ...] | np.ndarray) -> Path:
    """Faces are polygons, each with a normal of its own, so that no two share a corner as OBJ has it."""
    lines = ["# a thing", *(f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist())]
    for number, face in enumerate(faces, 1):
        lines += [f"vn {number} 0 0", "f " + " ".join(f"{corner + 1}//{number}" for corner in face)]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    return path


def in_order(points: np.ndarray) -> np.ndarray:
    return points[np.lexsort(np.round(points, 7).T)]


def framed(solid: Solid) -> np.ndarray:
    """Corners with the middle of the box around them, at its lowest height, as the origin."""
    low, high = solid.vertices.min(axis=0), solid.vertices.max(axis=0)
    return solid.vertices - [*(low + high)[:2] / 2, low[2]]


def assert_same(read: Solid, written: Solid, tolerance: float) -> None:
    filled = Solid(framed(written), written.mass)
    np.testing.assert_allclose(in_order(read.vertices), in_order(filled.vertices), atol=tolerance)
    np.testing.assert_allclose(read.centre_of_gravity, filled.centre_of_gravity, atol=tolerance)
    np.testing.assert_allclose(read.inertia, filled.inertia, atol=tolerance * np.trace(filled.inertia))
    assert sorted(map(len, read.faces)) == sorted(map(len, filled.faces))


@pytest.mark.parametrize("name", SHAPES)
def test_a_file_comes_back(name, tmp_path):
    solid = SHAPES[name]
    vertices, triangles = shell(solid)
    for file, unit, tolerance in (
        (write_stl(tmp_path / "thing.stl", vertices, triangles), "m", 1e-9),
        (write_obj(tmp_path / "thing.obj", 1000.0 * vertices + 500.0, solid.faces), "mm", 1e-9),
        (write_binary_stl(tmp_path / "binary.STL", vertices, triangles), "m", 2e-7),  # of seven digits
    ):
        assert_same(Body.mesh(str(file), unit=unit, mass=solid.mass).solid, solid, tolerance)


def test_a_binary_stl_file_of_such_numbers_comes_back_to_the_bit(tmp_path):
    box = Body.box(0.25, 0.75, 1.5, 20.0).solid
    file = write_binary_stl(tmp_path / "box.stl", box.vertices, triangulated(box.faces))
    read = Body.mesh(file, unit="m", mass=20.0).solid
    assert np.array_equal(in_order(read.vertices), in_order(box.vertices))
    np.testing.assert_allclose(read.inertia, box.inertia, atol=1e-14 * np.trace(box.inertia))


@pytest.mark.parametrize("kind", ["stl", "stl_ascii", "obj"])
def test_what_trimesh_writes_is_read(kind, tmp_path):
    shape = trimesh.creation.icosphere(subdivisions=2, radius=300.0)
    file = tmp_path / f"ball.{kind[:3]}"
    shape.export(file, file_type=kind)
    ball = Body.mesh(file, unit="mm", density=500.0).solid
    assert len(ball.vertices) == len(shape.vertices)
    assert ball.mass == pytest.approx(500.0 * 1e-9 * shape.volume, rel=1e-6)
    expected = 500.0 * 1e-15 * shape.moment_inertia
    np.testing.assert_allclose(ball.inertia, expected, atol=1e-6 * np.trace(expected))


@pytest.mark.parametrize("unit", UNITS)
@pytest.mark.parametrize("up", ["x", "y", "z"])
def test_units_and_the_direction_up(unit, up, tmp_path):
    box = SHAPES["box"]
    turned = np.roll(box.vertices, "xyz".index(up) + 1, axis=1) / UNITS[unit]
    assert np.ptp(turned[:, "xyz".index(up)]) == pytest.approx(1.8 / UNITS[unit])
    file = write_stl(tmp_path / "box.stl", turned, triangulated(box.faces))
    read = Body.mesh(file, unit=unit, density=100.0, up=up).solid
    np.testing.assert_allclose(in_order(read.vertices), in_order(box.vertices), atol=1e-9)
    assert read.mass == pytest.approx(100.0 * 0.3 * 0.8 * 1.8)
    assert read.stands


def shell(solid: Solid) -> tuple[np.ndarray, np.ndarray]:
    return solid.vertices, triangulated(solid.faces)


BOX, TRIANGLES = shell(SHAPES["box"])
TURNED = np.concatenate([TRIANGLES[:1, ::-1], TRIANGLES[1:]])
TWO_BOXES = np.concatenate([BOX, BOX + np.array([0.0, 1.0, 0.0])]), np.concatenate([TRIANGLES, TRIANGLES + 8])
DENTED_PYRAMID = (
    np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 0.1), (0.5, 0.5, 0.5)]),
    np.array([(4, 1, 0), (4, 2, 1), (4, 3, 2), (4, 0, 3), (5, 0, 1), (5, 1, 2), (5, 2, 3), (5, 3, 0)]),
)
FLAT = (
    np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 1.0), (0.0, 1.0, 1.0), (1.0, 1.0, 2.0)]),
    np.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]),
)


@pytest.mark.parametrize(
    ("mesh", "sentence", "field"),
    [
        ((BOX, TRIANGLES[1:]), r"do not join exactly two triangles \(3\); it must be closed", "file"),
        ((BOX, TRIANGLES[:, ::-1]), "face inwards", "file"),
        ((BOX, TURNED), "face inwards", "file"),
        (TWO_BOXES, r"fills 0\.8889 of its convex hull; it must be convex and fill at least 0\.999", "file"),
        (DENTED_PYRAMID, r"fills 0\.8 of its convex hull", "file"),
        ((BOX * [1, 1, 0], TRIANGLES), r"The body is 0\.3 × 0\.8 × 0 m; each side must be between", "unit"),
        (FLAT, "lie in a plane", "vertices"),
        ((1000 * BOX, TRIANGLES), r"The body is 300 × 800 × 1800 m; .*\(is the unit 'mm'\?\)\.$", "unit"),
        ((1e-3 * BOX, TRIANGLES), r"each side must be between 0\.001 and 30 m\.$", "unit"),
        ((1e9 * BOX, TRIANGLES), r"each side must be between 0\.001 and 30 m\.$", "unit"),
        (
            (np.where(BOX > 1.0, np.nan, BOX), TRIANGLES),
            "One of the numbers of the vertices is NaN or too large",
            "file",
        ),
        (
            (np.where(BOX > 1.0, np.inf, BOX), TRIANGLES),
            "One of the numbers of the vertices is NaN or too large",
            "file",
        ),
    ],
)
def test_meshes_of_no_convex_body_are_refused(mesh, sentence, field, tmp_path):
    for write, suffix in ((write_stl, ".stl"), (write_binary_stl, ".stl"), (write_obj, ".obj")):
        file = write(tmp_path / f"thing{suffix}", *mesh)
        with pytest.raises(InputError, match=sentence) as refused:
            Body.mesh(file, unit="m", mass=10.0)
        assert refused.value.field == field
        assert not refused.value.told("ja").isascii()


def test_a_ball_with_too_many_corners_is_refused(tmp_path):
    shape = trimesh.creation.icosphere(subdivisions=3, radius=0.3)
    file = tmp_path / "ball.stl"
    shape.export(file)
    with pytest.raises(InputError, match="has 642 corners; it must have at most 500"):
        Body.mesh(file, unit="m", mass=10.0)


@pytest.mark.parametrize(
    ("name", "content", "sentence"),
    [
        ("empty.stl", b"", "a closed surface"),
        ("blank.obj", b" \n\n", "a closed surface"),
        ("none.stl", b"solid none\nendsolid none\n", "^No triangles can be read from"),
        ("none.stl", b"\0" * 84, "^No triangles can be read from"),
        ("points.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "^No triangles can be read from"),
        ("far.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "a mesh in the format OBJ"),
        ("text.stl", b"a letter to my aunt\n" * 20, "a mesh in the format STL"),
        ("cut.stl", b"\0" * 80 + b"\x0c\0\0\0" + b"\0" * 99, "a mesh in the format STL"),
        ("thing.step", b"ISO-10303-21;", "it must be a file that ends in .stl, .obj"),
        ("thing", b"", "it must be a file that ends in .stl, .obj"),
    ],
)
def test_files_that_are_no_mesh_are_refused(name, content, sentence, tmp_path):
    file = tmp_path / name
    file.write_bytes(content)
    with pytest.raises(InputError, match=sentence) as refused:
        Body.mesh(file, unit="m", mass=10.0)
    assert name in str(refused.value)
    assert refused.value.field == "file"


def test_the_python_of_the_page_runs(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    write_stl(tmp_path / "stone.stl", 1000.0 * SHAPES["cone"].vertices, triangulated(SHAPES["cone"].faces))
    page = Path(__file__).parents[2] / "docs" / "space.md"
    blocks = re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    (tmp_path / "examples").symlink_to(page.parents[1] / "examples")
    exec("".join(blocks), {})
    assert capsys.readouterr().out.count("True") >= 5


def test_a_file_that_cannot_be_opened_is_refused(tmp_path):
    with pytest.raises(InputError, match=r"cannot be read: no such file or directory\.$"):
        Body.mesh(tmp_path / "nowhere.stl", unit="m", mass=10.0)
    with pytest.raises(InputError, match=r"cannot be read: no such file or directory\.$"):
        Body.mesh("a\0.stl", unit="m", mass=10.0)
    (tmp_path / "folder.stl").mkdir()
    with pytest.raises(InputError, match="cannot be read: is a directory"):
        Body.mesh(tmp_path / "folder.stl", unit="m", mass=10.0)


def test_a_file_of_too_many_bytes_is_refused(tmp_path, monkeypatch):
    file = write_stl(tmp_path / "box.stl", BOX, TRIANGLES)
    monkeypatch.setattr("stayput.model.solid_fields.MOST_BYTES", 1000)
    with pytest.raises(InputError, match="at most 1000 are read"):
        Body.mesh(file, unit="m", mass=10.0)


@pytest.mark.parametrize(
    ("given", "sentence", "field"),
    [
        ({"unit": "m"}, "either a mass", "mass"),
        ({"unit": "m", "mass": 1.0, "density": 1.0}, "give one of them", "mass"),
        ({"unit": "m", "density": 0.1}, "Density is 0.1 kg/m³; it must be between 1 and 25000", "density"),
        ({"unit": "m", "mass": -3.0}, "Mass is -3 kg", "mass"),
        ({"unit": "metre", "mass": 1.0}, "The unit is 'metre'; it must be one of 'mm', 'cm', 'm'", "unit"),
        ({"unit": "m", "mass": 1.0, "up": "w"}, "The direction up is 'w'; it must be one of", "up"),
        (
            {"unit": "m", "mass": 1.0, "centre_of_gravity": (0, 0, 2)},
            "lies 0.2 m outside",
            "centre_of_gravity",
        ),
    ],
)
def test_what_is_given_wrongly_is_refused(given, sentence, field, tmp_path):
    file = write_stl(tmp_path / "box.stl", BOX, TRIANGLES)
    with pytest.raises(InputError, match=sentence) as refused:
        Body.mesh(file, **given)
    assert refused.value.field == field


def test_without_trimesh_the_refusal_says_how_to_get_it(tmp_path, monkeypatch):
    file = write_stl(tmp_path / "box.stl", BOX, TRIANGLES)
    monkeypatch.setitem(sys.modules, "trimesh", None)
    with pytest.raises(InputError, match=r"A mesh needs trimesh, which is not installed; .*\[space\]"):
        Body.mesh(file, unit="m", mass=10.0)


def test_what_is_no_path_is_refused():
    with pytest.raises(InputError, match="file is None; it must be of type"):
        Body.mesh(None, unit="m", mass=1.0)  # type: ignore[arg-type]
