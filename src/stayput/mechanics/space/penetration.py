"""Bodies are moved out of each other, and out of planes, without a change of velocity."""

from __future__ import annotations

from stayput.compiling import inner
from stayput.mechanics.space.body import angular_response, nudge, place_of, sag
from stayput.mechanics.space.closing import ENTERS_BODIES
from stayput.mechanics.space.contact import mobility
from stayput.mechanics.space.pairs import deepest, place_corners, touch
from stayput.mechanics.space.touching import gap_of, lever_of_point, lowest_lever, may_touch
from stayput.mechanics.space.vectors import added, cross, normal_of

BODY_PENETRATION_SLOP = 0.5 * ENTERS_BODIES
"""Depth up to which bodies stay in each other [m]: what is moved out of one is moved into what bears it."""


@inner
def _nudge_along(body, s, lever, n, size):
    turn = angular_response(s, cross(lever, n))
    by = size / body.mass
    nudge(body, s, (by * n[0], by * n[1], by * n[2]), (size * turn[0], size * turn[1], size * turn[2]))


@inner
def _move_point_out(body, s, lever, plane, bent):
    """Move a body out of a plane that a point has entered by more than ``bent``, as an impulse would."""
    gap = gap_of(s, lever, plane)
    if gap < -bent:
        n = normal_of(plane)
        _nudge_along(body, s, lever, n, -gap / mobility(body, s, lever, n))


@inner
def move_out(world, poses, scratch, h):
    """Move bodies out of each other and of planes, where deeper than paths bend in a step (0: refined)."""
    bodies, points, rims, planes, pairs, faces, loops, edges = world
    corners, polygons, touching, axes = scratch[3], scratch[4], scratch[5], scratch[8]
    place_corners(bodies, poses, points, corners)
    for j in range(pairs.shape[0]):
        a, b = pairs[j].a, pairs[j].b
        body, other, s, r = bodies[a], bodies[b], poses[a], poses[b]
        _, count, n = touch(body, s, other, r, 0.0, axes[j], faces, loops, edges, corners, polygons, touching)
        bent = sag(body, s, h) + sag(other, r, h)
        if count and deepest(touching, count) >= -bent - BODY_PENETRATION_SLOP:
            continue
        for m in range(count):
            if touching[m, 3] < -bent:
                place = touching[m, 0], touching[m, 1], touching[m, 2]
                lever, arm = added(place, -1.0, place_of(s)), added(place, -1.0, place_of(r))
                both = mobility(body, s, lever, n) + mobility(other, r, arm, n)
                size = -touching[m, 3] / both / count  # each of them moves all of a face
                _nudge_along(body, s, lever, n, size)
                _nudge_along(other, r, arm, n, -size)
        if count:
            place_corners(bodies[a : a + 1], poses[a : a + 1], points, corners)
            place_corners(bodies[b : b + 1], poses[b : b + 1], points, corners)
    for b in range(bodies.shape[0]):
        body, s = bodies[b], poses[b]
        bent = sag(body, s, h)
        for plane in planes:
            for i in range(body.first_point, body.first_point + body.points):
                if may_touch(points[i], plane):
                    _move_point_out(body, s, lever_of_point(s, points[i]), plane, bent)
            for i in range(body.first_rim, body.first_rim + body.rims):
                if may_touch(rims[i], plane):
                    _move_point_out(body, s, lowest_lever(s, rims[i], plane), plane, bent)
