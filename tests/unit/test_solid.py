"""`Solid`: moments beside closed forms and samples, the frame, what is refused, and what stands."""

from __future__ import annotations

import math
import pickle
from collections import Counter
from dataclasses import FrozenInstanceError, replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from stayput import Body
from stayput.errors import InputError
from stayput.model.polyhedron import convex_hull, inertia_of, size_of, triangulated, uniform_solid
from stayput.model.shapes import SIDES
from stayput.model.solid import MOST_VERTICES, Solid

HEXAGON = [(math.cos(a), math.sin(a)) for a in np.arange(6) * math.pi / 3]
KITE = [(0.0, 0.0), (0.5, -0.2), (0.9, 0.1), (0.4, 0.6)]
RNG = np.random.default_rng(17)


def assert_closed(vertices: np.ndarray, faces: tuple[np.ndarray, ...]) -> None:
    edges = Counter((int(a), int(b)) for face in faces for a, b in zip(face, np.roll(face, -1), strict=True))
    assert set(edges.values()) == {1}
    assert all((b, a) in edges for a, b in edges)
    assert len(vertices) - len(edges) // 2 + len(faces) == 2  # Euler
    outside = convex_hull(vertices).planes
    assert (vertices @ outside[:, :3].T - outside[:, 3]).max() <= 2e-6 * size_of(vertices)


# Closed forms


def test_a_box_has_the_moments_of_a_box():
    b, l, h, m = 0.3, 0.8, 1.8, 200.0
    box = Body.box(b, l, h, m).solid
    expected = np.diag([l * l + h * h, b * b + h * h, b * b + l * l]) * m / 12.0
    np.testing.assert_allclose(box.inertia, expected, rtol=1e-15, atol=0.0)
    assert box.centre_of_gravity.tolist() == [0.0, 0.0, h / 2]
    assert (len(box.vertices), len(box.faces)) == (8, 6)
    assert {len(face) for face in box.faces} == {4}
    assert np.array_equal(box.vertices.min(axis=0), [-b / 2, -l / 2, 0.0])
    assert np.array_equal(box.vertices.max(axis=0), [b / 2, l / 2, h])


def test_a_cylinder_has_the_moments_of_a_cylinder():
    r, h, m = 0.15, 1.2, 60.0
    cylinder = Body.cylinder(2 * r, h, m).solid
    across, along = m * (3 * r * r + h * h) / 12.0, m * r * r / 2.0
    np.testing.assert_allclose(cylinder.inertia, np.diag([across, across, along]), rtol=1e-14, atol=0.0)
    assert cylinder.centre_of_gravity.tolist() == [0.0, 0.0, pytest.approx(h / 2, rel=1e-15)]
    assert cylinder.inertia[0, 0] == cylinder.inertia[1, 1]
    assert np.array_equal(cylinder.rims, [[0, 0, 0, 0, 0, -1, r], [0, 0, h, 0, 0, 1, r]])


@pytest.mark.parametrize(("bottom", "top"), [(0.5, 0.2), (0.2, 0.5), (0.3, 0.3)])
def test_a_cone_is_a_stack_of_discs(bottom, top):
    h, m, count = 0.8, 7.0, 20_000
    cone = Body.cone(bottom, top, h, m).solid
    z = (np.arange(count) + 0.5) * h / count
    radius = bottom / 2 + (top - bottom) / 2 * z / h
    mass = radius**2 * m / (radius**2).sum()
    z_g = (mass * z).sum() / m
    along = (mass * radius**2).sum() / 2.0
    across = (mass * (radius**2 / 4.0 + (z - z_g) ** 2)).sum()
    assert cone.centre_of_gravity[2] == pytest.approx(z_g, rel=1e-8)
    np.testing.assert_allclose(np.diag(cone.inertia), [across, across, along], rtol=1e-8)


def test_the_corners_of_a_round_body_lie_on_its_rims_and_mirror_each_other():
    cone = Body.cone(0.5, 0.2, 0.8, 7.0).solid
    assert (len(cone.vertices), len(cone.faces)) == (2 * SIDES, SIDES + 2)
    assert_closed(cone.vertices, cone.faces)
    for x, y, z, _, _, _, radius in cone.rims:
        ring = cone.vertices[cone.vertices[:, 2] == z]
        np.testing.assert_allclose(np.hypot(ring[:, 0] - x, ring[:, 1] - y), radius, rtol=1e-15)
        here = {tuple(point) for point in np.abs(ring[:, :2]).tolist()}
        assert len(here) == SIDES // 4 + 1
        assert {(b, a) for a, b in here} == here
    inscribed = uniform_solid(cone.vertices, triangulated(cone.faces))
    polygon = SIDES * math.sin(2 * math.pi / SIDES) / (2 * math.pi)
    assert inscribed.volume == pytest.approx(polygon * math.pi * 0.8 * (0.25**2 + 0.025 + 0.1**2) / 3)


@pytest.mark.parametrize("outline", [HEXAGON, KITE, KITE[::-1]], ids=["hexagon", "kite", "turned kite"])
def test_a_prism_s_moments_are_those_of_its_outline_s_triangles(outline):
    h, m = 0.7, 30.0
    prism = Solid([(x, y, z) for z in (0.0, h) for x, y in outline], m)
    corners = np.array(outline)
    area, first, second = 0.0, np.zeros(2), np.zeros((2, 2))
    for i in range(1, len(corners) - 1):
        triangle = corners[[0, i, i + 1]]
        (a, b), (c, d) = triangle[1] - triangle[0], triangle[2] - triangle[0]
        part = (a * d - b * c) / 2.0
        middles = (triangle + np.roll(triangle, 1, axis=0)) / 2  # exact for second degree
        area, first = area + part, first + part * triangle.mean(axis=0)
        second = second + part * (middles.T @ middles) / 3
    g = first / area
    spread = np.zeros((3, 3))
    spread[:2, :2] = second / area - np.outer(g, g)
    spread[2, 2] = h * h / 12
    np.testing.assert_allclose(prism.centre_of_gravity, [*g, h / 2], atol=1e-15)
    np.testing.assert_allclose(prism.inertia, m * inertia_of(spread), atol=1e-13)
    assert len(prism.faces) == len(outline) + 2
    assert_closed(prism.vertices, prism.faces)


# A planar body in space


def test_a_uniform_planar_body_becomes_the_uniform_box():
    body = Body(0.3, 1.8, 200.0, length=0.8)
    solid, box = body.solid, Body.box(0.3, 0.8, 1.8, 200.0).solid
    assert np.array_equal(np.sort(solid.vertices, axis=0), np.sort(box.vertices, axis=0))
    np.testing.assert_allclose(solid.inertia, box.inertia, rtol=1e-15)
    assert solid.feet is None
    assert solid.stands


def test_a_planar_body_s_inertia_and_centre_stay():
    body = Body(0.4, 1.6, 90.0, cg_offset=(0.03, -0.2), inertia=11.0, length=0.7)
    solid = body.solid
    assert solid.inertia[1, 1] == pytest.approx(11.0, rel=1e-15)
    assert solid.centre_of_gravity.tolist() == [0.03, 0.0, pytest.approx(0.6)]
    spread, alone = 11.0 / body.uniform_inertia, 90.0 * 0.7**2 / 12
    assert solid.inertia[0, 0] == pytest.approx(alone + spread * 90.0 * 1.6**2 / 12)
    assert solid.inertia[2, 2] == pytest.approx(alone + spread * 90.0 * 0.4**2 / 12)


def test_insets_and_heights_of_a_planar_body_become_feet():
    body = Body(0.4, 1.6, 90.0, base_insets=(0.02, 0.05), base_heights=(0.0, -0.004), length=1.0)
    solid = body.solid
    assert sorted(map(tuple, solid.feet.tolist())) == [
        (pytest.approx(-0.18), -0.5, pytest.approx(0.004)),
        (pytest.approx(-0.18), 0.5, pytest.approx(0.004)),
        (pytest.approx(0.15), -0.5, 0.0),
        (pytest.approx(0.15), 0.5, 0.0),
    ]
    assert np.array_equal(solid.base_points, solid.feet)
    lower = solid.vertices[solid.vertices[:, 2] < 0.5]
    assert sorted({(x, z) for x, _, z in lower.tolist()}) == [(-0.2, pytest.approx(0.004)), (0.2, 0.0)]
    up = solid.up_at_rest
    assert math.atan2(up[0], up[2]) == pytest.approx(-body.resting_tilt, rel=1e-12)
    assert np.linalg.norm(up) == pytest.approx(1.0, rel=1e-15)


def test_a_planar_body_without_a_length_is_refused():
    with pytest.raises(
        InputError, match="length is missing; it must be the size across the shaking"
    ) as refused:
        _ = Body(0.4, 1.6, 100.0).solid
    assert refused.value.field == "length"


# Axes and frames


@pytest.mark.parametrize(
    "solid",
    [
        Body.box(0.3, 0.8, 1.8, 9.0).solid,
        Body.box(1, 1, 1, 9.0).solid,
        Body.cylinder(1, 2, 3.0).solid,
        Solid([(x, y, z) for z in (0.0, 1.0) for x, y in HEXAGON], 9.0),
    ],
)
def test_the_axes_of_a_symmetric_body_are_those_of_its_frame(solid):
    moments, axes = solid.principal
    assert np.array_equal(axes, np.eye(3))
    np.testing.assert_allclose(moments, np.diag(solid.inertia), rtol=1e-15)


def test_axes_that_were_turned_are_found():
    box = Body.box(0.3, 0.8, 1.8, 200.0).solid
    angle = 0.4
    turn = np.array(
        [[math.cos(angle), -math.sin(angle), 0], [math.sin(angle), math.cos(angle), 0], [0, 0, 1]]
    )
    moments, axes = Solid(box.vertices @ turn.T, 200.0).principal
    np.testing.assert_allclose(axes, turn, atol=1e-12)
    np.testing.assert_allclose(moments, np.diag(box.inertia), rtol=1e-12)


def test_what_is_of_its_own_takes_the_place_of_what_follows():
    own = np.diag([3.0, 2.5, 2.0])
    box = Body.box(1.0, 1.0, 1.0, 12.0, centre_of_gravity=(0.1, 0.0, 0.4), inertia=own).solid
    assert np.array_equal(box.inertia, own)
    assert box.centre_of_gravity.tolist() == [0.1, 0.0, 0.4]
    low = Body.cylinder(0.3, 1.0, 20.0, centre_of_gravity=(0.0, 0.0, 0.2)).solid
    assert np.array_equal(low.inertia, Body.cylinder(0.3, 1.0, 20.0).solid.inertia)


def test_a_solid_is_a_value():
    cone = Body.cone(0.5, 0.2, 0.8, 7.0, feet=[(0.1, 0, 0), (-0.1, 0.1, 0), (-0.1, -0.1, 0)]).solid
    again = pickle.loads(pickle.dumps(cone))
    assert again == cone
    assert hash(again) == hash(cone)
    assert cone != Body.cone(0.5, 0.2, 0.8, 7.0).solid
    assert cone != "cone"
    assert replace(cone, mass=8.0).mass == 8.0
    assert replace(cone, feet=None, base="flat") == Body.cone(0.5, 0.2, 0.8, 7.0).solid
    for array in (*again.principal, *again.faces):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0.0
    arrays = (again.vertices, again.inertia, again.centre_of_gravity, again.feet, again.rims, again.normals)
    for array in (*arrays, again.up_at_rest):
        array[0] = 0.1  # a copy
    assert again == cone
    assert again.up_at_rest.tolist() == [0.0, 0.0, 1.0]
    np.testing.assert_array_equal(again.normals, cone.normals)
    with pytest.raises(FrozenInstanceError):
        again.vertices = cone.vertices
    turn = Rotation.from_rotvec([0.3, 0.2, 0.1])
    for points in (cone.centre_of_gravity, cone.vertices, cone.feet, cone.normals, cone.up_at_rest):
        np.testing.assert_allclose(turn.apply(points), points @ turn.as_matrix().T, atol=1e-12)
    assert repr(cone) == "Solid(0.5 × 0.5 × 0.8 m, 7 kg, 64 corners, 34 faces)"


def test_points_that_are_no_corners_are_left_out():
    grid = np.linspace(0.0, 1.0, 5)
    points = np.array(np.meshgrid(grid, grid, grid)).reshape(3, -1).T
    cube = Solid(points, 1.0)
    assert (len(cube.vertices), len(cube.faces)) == (8, 6)
    assert_closed(cube.vertices, cube.faces)


# What stands


def test_a_box_stands_where_its_centre_is_above_its_base():
    assert Body.box(0.3, 0.8, 1.8, 200.0).solid.up_at_rest.tolist() == [0.0, 0.0, 1.0]
    beside = [(0.14, -0.39, 0.0), (0.14, 0.39, 0.0), (0.05, 0.39, 0.0), (0.05, -0.39, 0.0)]
    overhanging = Body.box(0.3, 0.8, 1.8, 200.0, feet=beside).solid
    assert not overhanging.stands
    assert Body.box(0.3, 0.8, 1.8, 200.0, feet=beside, centre_of_gravity=(0.1, 0.0, 0.9)).solid.stands


@pytest.mark.parametrize(("x", "stands"), [(0.0999, True), (0.1, False), (0.1001, False)])
def test_a_cone_stands_on_its_rim(x, stands):
    vase = Body.cone(0.2, 0.6, 0.5, 2.0, centre_of_gravity=(0.0, x, 0.45)).solid
    assert vase.stands == stands


@pytest.mark.parametrize(
    ("feet", "stands"),
    [
        ([(0.1, 0.0, 0.0), (-0.1, 0.1, 0.0), (-0.1, -0.1, 0.0)], True),
        ([(0.1, 0.0, 0.0), (0.01, 0.1, 0.0), (0.01, -0.1, 0.0)], False),
        ([(0.0, 0.1, 0.0), (0.0, -0.1, 0.0), (0.1, 0.0, 0.0)], False),  # G above the line between two
        ([(0.1, 0.0, 0.0), (-0.1, 0.0, 0.0)], False),
        ([(0.0, 0.0, 0.0)], False),
        ([(0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (-0.1, 0.1, 0.0), (-0.1, -0.1, 0.0)], True),
    ],
)
def test_feet_must_stand_around_the_centre(feet, stands):
    assert Body.box(0.3, 0.3, 0.6, 20.0, feet=feet).solid.stands == stands


def test_four_feet_of_which_one_is_short_stand_on_three():
    corners = [(x, y, 0.0) for x in (-0.1, 0.1) for y in (-0.2, 0.2)]
    corners[0] = (-0.1, -0.2, 0.003)
    table = Body.box(0.3, 0.5, 0.7, 10.0, feet=corners, centre_of_gravity=(0.02, 0.0, 0.5)).solid
    assert table.up_at_rest.tolist() == [0.0, 0.0, 1.0]  # on the other three
    leaning = Body.box(0.3, 0.5, 0.7, 10.0, feet=corners, centre_of_gravity=(-0.05, -0.05, 0.5)).solid
    up = leaning.up_at_rest
    heights = leaning.feet @ up
    on_the_floor = np.abs(heights - heights.min()) < 1e-12
    assert on_the_floor.sum() == 3
    assert on_the_floor[0]


def test_a_hull_on_its_tip_does_not_stand():
    tip = Solid([(0, 0, 0), (1, 0, 1), (-1, 0, 1), (0, 1, 1), (0, -1, 1)], 1.0)
    assert len(tip.base_points) == 1
    assert not tip.stands


# What is refused


def many_corners(count):
    points = RNG.normal(size=(count, 3))
    return points / np.linalg.norm(points, axis=1)[:, None]


CUBE = Body.box(1.0, 1.0, 1.0, 12.0).solid


@pytest.mark.parametrize(
    ("make", "sentence", "field"),
    [
        (lambda: Body.box(0.0, 1, 1, 1), r"Width is 0 m; it must be between 0.001 and 30 m", "width"),
        (lambda: Body.box(1, 1, 1800, 1), "Height is 1800 m", "height"),
        (lambda: Body.box(1, "1", 1, 1), "Length is '1'; it must be a number", "length"),
        (lambda: Body.box(1, 1, 1, -1), "Mass is -1 kg", "mass"),
        (lambda: Body.cylinder(math.nan, 1, 1), "Diameter is nan", "diameter"),
        (lambda: Body.cone(1, 0, 1, 1), "Top diameter is 0 m", "top"),
        (lambda: Solid([(0, 0, 0)], 1.0), "each side must be between", "vertices"),
        (
            lambda: Solid([(0, 0)], 1.0),
            r"The shape of the vertices is \(1, 2\); it must be \(n, 3\)",
            "vertices",
        ),
        (lambda: Solid([(0, 0, 0), (1, 2)], 1.0), "shape of the vertices is irregular", "vertices"),
        (lambda: Solid([(0, 0, math.nan)], 1.0), "the vertices is NaN or too large", "vertices"),
        (lambda: Solid([(0, 0, 0), (1, 1, 1), (2, 2, 2), (1, 2, 1.5)], 1.0), "lie in a plane", "vertices"),
        (lambda: Solid([(0, 0, 0), (1, 1, 1), (2, 2, 2)], 1.0), "lie in a plane", "vertices"),
        (lambda: Solid(1800 * CUBE.vertices, 1.0), "1800 × 1800 × 1800 m; each side", "vertices"),
        (
            lambda: Solid(many_corners(600), 1.0),
            f"600 corners; it must have at most {MOST_VERTICES}",
            "vertices",
        ),
        (
            lambda: replace(CUBE, centre_of_gravity=(0.7, 0, 0.5)),
            r"\(0.7, 0, 0.5\) m lies 0.2 m outside",
            "centre_of_gravity",
        ),
        (
            lambda: replace(CUBE, centre_of_gravity=(0, 0)),
            r"centre of gravity is \(2,\); it must be \(3,\)\.",
            "centre_of_gravity",
        ),
        (lambda: replace(CUBE, inertia=[2, 2, 2]), r"it must be \(3, 3\)", "inertia"),
        (lambda: replace(CUBE, inertia=[[2, 0.1, 0], [0, 2, 0], [0, 0, 2]]), "not symmetric", "inertia"),
        (lambda: replace(CUBE, inertia=np.diag([1, 1, 2.1])), "at most the sum of the others", "inertia"),
        (lambda: replace(CUBE, inertia=np.diag([-1, 1, 1])), "must be positive", "inertia"),
        (lambda: replace(CUBE, inertia=2e6 * np.eye(3)), "it must be between .* for this body", "inertia"),
        (lambda: replace(CUBE, feet=np.zeros((33, 3))), "The number of feet is 33", "feet"),
        (lambda: replace(CUBE, feet=[]), r"shape of the feet is \(0,\)", "feet"),
        (lambda: replace(CUBE, rims=[(0, 0, 0, 0, 0, 2, 0.5)]), "an axis of length 1", "rims"),
    ],
)
def test_what_is_no_body_is_refused(make, sentence, field):
    with pytest.raises(InputError, match=sentence) as refused:
        make()
    assert refused.value.field == field
    assert not refused.value.told("ja").isascii()


@pytest.mark.parametrize("foot", [(0.0, 0.0, 5.0), (200.0, 0.0, 0.0), (0.0, 0.0, -3.0)])
def test_a_foot_that_is_not_at_the_foot_of_the_body_is_refused(foot):
    with pytest.raises(InputError, match="feet must be below the middle of the body"):
        Body.box(0.4, 0.4, 1.0, 10.0, feet=[foot, (0.1, 0.1, 0.0), (-0.1, 0.1, 0.0)])
