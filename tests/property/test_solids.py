"""Random convex hulls: closed, with the moments that trimesh gives, which turn and shift; damaged meshes."""

from __future__ import annotations

import tempfile
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from damage import damaged
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from stayput import Body
from stayput.errors import InputError
from stayput.model.polyhedron import (
    TOLERANCE,
    convex_hull,
    inertia_of,
    principal_axes,
    size_of,
    triangulated,
    uniform_solid,
)
from stayput.model.solid import Solid

trimesh = pytest.importorskip("trimesh", reason="trimesh is not installed")

SEEDS = st.integers(0, 2**32 - 1)


def turned(rng: np.random.Generator) -> np.ndarray:
    """A random rotation."""
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0.0 else q[:, [1, 0, 2]]


@st.composite
def points(draw: st.DrawFn) -> np.ndarray:
    """Points of a body: in a cloud, on a grid (many in a plane), on two rings; with seven digits or all."""
    rng = np.random.default_rng(draw(SEEDS))
    kind = draw(st.sampled_from(["cloud", "grid", "rings"]))
    if kind == "cloud":
        found = rng.normal(size=(draw(st.integers(4, 60)), 3))
    elif kind == "grid":
        found = rng.integers(0, 4, size=(draw(st.integers(8, 40)), 3)).astype(float)
    else:
        angles = np.linspace(0.0, 2.0 * np.pi, draw(st.integers(3, 40)), endpoint=False)
        rings = [
            (r * np.cos(angles), r * np.sin(angles), z + 0.0 * angles) for r, z in ((1.0, 0.0), (0.6, 1.7))
        ]
        found = np.concatenate([np.column_stack(ring) for ring in rings])
    assume(len(found) > 3 and np.linalg.svd(found - found.mean(axis=0), compute_uv=False)[-1] > 0.05)
    found = found * rng.uniform(0.3, 1.5, 3)
    if draw(st.booleans()):
        found = found @ turned(rng).T
    return found.astype(np.float32).astype(float) if draw(st.booleans()) else found


@given(points())
def test_a_hull_is_closed_convex_and_holds_the_points(cloud):
    hull = convex_hull(cloud)
    edges = Counter((int(a), int(b)) for f in hull.faces for a, b in zip(f, np.roll(f, -1), strict=True))
    assert set(edges.values()) == {1}
    assert all((b, a) in edges for a, b in edges)
    assert len(hull.vertices) - len(edges) // 2 + len(hull.faces) == 2
    assert min(Counter(int(corner) for face in hull.faces for corner in face).values()) > 2
    faces = hull.planes
    assert (cloud @ faces[:, :3].T - faces[:, 3]).max() < 10 * TOLERANCE * size_of(cloud)
    again = convex_hull(hull.vertices)
    assert np.array_equal(again.vertices, hull.vertices)
    assert all(np.array_equal(a, b) for a, b in zip(again.faces, hull.faces, strict=True))


@given(points())
def test_moments_are_those_of_trimesh(cloud):
    body = Solid(cloud, 7.0)
    mesh = trimesh.Trimesh(body.vertices, triangulated(body.faces), process=False)
    assert mesh.is_volume
    mesh.density = 7.0 / mesh.volume
    np.testing.assert_allclose(body.centre_of_gravity, mesh.center_mass, atol=1e-12 * size_of(cloud))
    np.testing.assert_allclose(body.inertia, mesh.moment_inertia, atol=1e-11 * np.trace(body.inertia))


@given(points(), SEEDS)
def test_moments_turn_and_shift_with_the_body(cloud, seed):
    rng = np.random.default_rng(seed)
    turn, shift = turned(rng), rng.normal(size=3)
    body, moved = Solid(cloud, 7.0), Solid(cloud @ turn.T + shift, 7.0)
    assume(len(body.vertices) == len(moved.vertices))  # else one had a corner within the tolerance of a plane
    np.testing.assert_allclose(moved.centre_of_gravity, turn @ body.centre_of_gravity + shift, atol=1e-6)
    np.testing.assert_allclose(
        moved.inertia, turn @ body.inertia @ turn.T, atol=1e-6 * np.trace(body.inertia)
    )


@given(points(), SEEDS)
def test_parts_make_the_whole_by_parallel_axes(cloud, seed):
    """A plane through the centroid cuts the body in two; their moments about its centre add up."""
    hull = convex_hull(cloud)
    whole = uniform_solid(hull.vertices, triangulated(hull.faces))
    normal = turned(np.random.default_rng(seed))[0]
    height = (hull.vertices - whole.centroid) @ normal
    edges = {(int(a), int(b)) for f in hull.faces for a, b in zip(f, np.roll(f, -1), strict=True)}
    cut = [
        hull.vertices[a] + (hull.vertices[b] - hull.vertices[a]) * height[a] / (height[a] - height[b])
        for a, b in edges
        if height[a] < 0.0 < height[b]
    ]
    volume, moments = 0.0, np.zeros((3, 3))
    for side in (hull.vertices[height >= 0.0], hull.vertices[height < 0.0]):
        part = convex_hull(np.concatenate([side, cut]))
        filled = uniform_solid(part.vertices, triangulated(part.faces))
        arm = filled.centroid - whole.centroid
        volume += filled.volume
        moments += filled.volume * (filled.second_moments + np.outer(arm, arm))
    # the cut goes through faces that are flat to 1e-6 of the size
    assert volume == pytest.approx(whole.volume, rel=1e-4)
    np.testing.assert_allclose(
        moments / volume, whole.second_moments, atol=1e-4 * np.trace(whole.second_moments)
    )


@given(SEEDS, st.sampled_from([(1.0, 1.0, 1.0), (1.0, 1.0, 1.0 + 1e-9), (1.0, 2.0, 3.0), (1e-6, 1.0, 1.0)]))
def test_principal_axes_give_the_tensor_again(seed, second_moments):
    turn = turned(np.random.default_rng(seed))
    inertia = turn @ inertia_of(np.diag(second_moments)) @ turn.T
    moments, axes = principal_axes((inertia + inertia.T) / 2)
    np.testing.assert_allclose(axes @ np.diag(moments) @ axes.T, inertia, atol=1e-12 * np.trace(inertia))
    np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-14)
    assert np.linalg.det(axes) == pytest.approx(1.0)


def assert_refused_or_a_body(file: Path, **given: float) -> None:
    try:
        body = Body.mesh(file, unit="m", **given).solid
    except InputError as error:
        refused = error
    else:
        assert np.linalg.eigvalsh(body.inertia)[0] > 0.0
        return
    assert refused.field in ("file", "unit", "vertices", "inertia", "mass")
    assert not refused.told("ja").isascii()


def ascii_stl() -> str:
    box = Body.box(0.3, 0.8, 1.8, 200.0).solid
    corners = box.vertices[triangulated(box.faces)].tolist()
    rows = ["solid box"]
    for triangle in corners:
        rows += ["facet normal 0 0 1", "outer loop", *(f"vertex {x} {y} {z}" for x, y, z in triangle)]
        rows += ["endloop", "endfacet"]
    return "\n".join([*rows, "endsolid box"])


def obj() -> str:
    box = Body.box(0.3, 0.8, 1.8, 200.0).solid
    rows = [
        "mtllib box.mtl",
        "o box",
        *(f"v {x} {y} {z}" for x, y, z in box.vertices.tolist()),
        "usemtl wood",
    ]
    return "\n".join([*rows, *("f " + " ".join(str(corner + 1) for corner in face) for face in box.faces)])


@pytest.mark.hostile
@pytest.mark.parametrize(("text", "suffix"), [(ascii_stl(), ".stl"), (obj(), ".obj")], ids=["STL", "OBJ"])
@given(data=st.data())
@settings(deadline=None)
def test_a_damaged_mesh_is_refused_or_makes_a_body(text, suffix, data):
    content = data.draw(damaged(text)).encode(errors="replace")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / f"damaged{suffix}"
        file.write_bytes(content)
        assert_refused_or_a_body(file, mass=10.0)


@pytest.mark.hostile
@given(data=st.data())
@settings(deadline=None)
def test_a_damaged_binary_mesh_is_refused_or_makes_a_body(data):
    shape = trimesh.creation.box((0.3, 0.8, 1.8))
    content = bytearray(shape.export(file_type="stl"))
    for _ in range(data.draw(st.integers(1, 8))):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    content = content[: data.draw(st.integers(0, len(content)))] if data.draw(st.booleans()) else content
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "damaged.stl"
        file.write_bytes(content)
        assert_refused_or_a_body(file, density=600.0)


@given(st.permutations(range(8)), SEEDS, st.sampled_from([0.0, 0.05, 0.3]))
def test_eight_corners_are_what_qhull_finds_of_them_and_a_point_inside(order, seed, bent):
    """A box needs no Qhull; with a ninth point, or where it is bent, it goes the general way."""
    rng = np.random.default_rng(seed)
    box = np.array([(x, y, z) for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
    box[:, 2] += np.where(box[:, 2] > 0.5, 0.0, bent * box[:, 0])  # a slanted base
    corners = (box * rng.uniform(0.3, 2.0, 3))[list(order)]
    found = convex_hull(corners)
    general = convex_hull(np.concatenate([corners, corners.mean(axis=0)[np.newaxis]]))
    assert np.array_equal(found.vertices, general.vertices)
    assert [face.tolist() for face in found.faces] == [face.tolist() for face in general.faces]
    np.testing.assert_allclose(found.planes, general.planes, atol=1e-12)
    assert len(convex_hull(corners + rng.uniform(-0.1, 0.1, corners.shape)).faces) > 6
