"""Where two convex bodies touch: the axis that separates them most, and points on it.

Two convex polyhedra are apart along the normal of a face of either, or along the common normal of an edge of
each (the separating axis theorem). Where a face separates them most, the face of the other that looks against
it most is cut to its outline, and what is left of its corners touches; else the two edges touch in one point.
"""

from __future__ import annotations

import math

from stayput.compiled import inline, inner
from stayput.mechanics.elementary import sine_and_cosine
from stayput.mechanics.space.body import attitude, place_of
from stayput.mechanics.space.touching import lever_of_point
from stayput.mechanics.space.vectors import added, cross, dot, norm, tangents, turned

MOST_TOUCHING = 8
"""Most points in which two bodies touch."""

PREFER_FACES = 1e-6
"""By how much edges must separate bodies more than faces do, which touch in more points [m]."""

PARALLEL = 1e-6
"""Sine of the angle up to which edges are parallel: they have no common normal that faces have not."""


@inner
def place_corners(bodies, poses, points, corners):
    """Set the places of all points in the room."""
    for b in range(bodies.shape[0]):
        body, s = bodies[b], poses[b]
        for i in range(body.first_point, body.first_point + body.points):
            place = added(place_of(s), 1.0, lever_of_point(s, points[i]))
            corners[i, 0], corners[i, 1], corners[i, 2] = place


@inline
def _corner(corners, i):
    return corners[i, 0], corners[i, 1], corners[i, 2]


@inline
def _normal(s, face):
    """Return a face's outward normal in the room's axes."""
    return turned(attitude(s), (face.nx, face.ny, face.nz))


@inner
def _least(body, corners, axis):
    """Return the least of axis·x over the hull of a body."""
    found = math.inf
    for i in range(body.first_point, body.first_point + body.hull):
        found = min(found, dot(axis, _corner(corners, i)))
    return found


@inner
def _best_face(body, s, other, faces, loops, corners):
    """Return the face of a body beyond which the other lies farthest, and how far."""
    best, found = -math.inf, -1
    for f in range(body.first_face, body.first_face + body.faces):
        n = _normal(s, faces[f])
        apart = _least(other, corners, n) - dot(n, _corner(corners, loops[faces[f].first]))
        if apart > best:
            best, found = apart, f
    return found, best


@inner
def _best_edges(a, b, away, best, edges, corners):
    """Return the edges of two bodies whose common normal separates them most, how far, and the normal from a.

    ``away`` is the direction from a to b; edges that separate them less than ``best`` do not count.
    """
    first, second, axis = -1, -1, away
    for i in range(a.first_edge, a.first_edge + a.edges):
        along_a = added(_corner(corners, edges[i, 1]), -1.0, _corner(corners, edges[i, 0]))
        for j in range(b.first_edge, b.first_edge + b.edges):
            along_b = added(_corner(corners, edges[j, 1]), -1.0, _corner(corners, edges[j, 0]))
            n = cross(along_a, along_b)
            size = norm(n)
            if size <= PARALLEL * norm(along_a) * norm(along_b):
                continue
            if dot(n, away) < 0.0:
                size = -size
            n = n[0] / size, n[1] / size, n[2] / size
            # only edges that are outermost along their normal can touch
            reach = dot(n, _corner(corners, edges[i, 0]))
            start = dot(n, _corner(corners, edges[j, 0]))
            if start - reach <= best:
                continue
            apart = _least(b, corners, n) + _least(a, corners, (-n[0], -n[1], -n[2]))
            if apart > best:
                best, first, second, axis = apart, i, j, n
    return first, second, best, axis


@inner
def _crossing(edges, corners, i, j):
    """Return the middle of the shortest way between the lines of two edges."""
    p, q = _corner(corners, edges[i, 0]), _corner(corners, edges[j, 0])
    u = added(_corner(corners, edges[i, 1]), -1.0, p)
    v = added(_corner(corners, edges[j, 1]), -1.0, q)
    w = added(p, -1.0, q)
    uu, uv, vv, uw, vw = dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w)
    det = uu * vv - uv * uv
    x, y = added(p, (uv * vw - vv * uw) / det, u), added(q, (uu * vw - uv * uw) / det, v)
    return 0.5 * (x[0] + y[0]), 0.5 * (x[1] + y[1]), 0.5 * (x[2] + y[2])


@inner
def _facing(body, s, faces, n):
    """Return the face of a body that looks most against a direction."""
    least, found = math.inf, -1
    for f in range(body.first_face, body.first_face + body.faces):
        looks = dot(n, _normal(s, faces[f]))
        if looks < least:
            least, found = looks, f
    return found


@inner
def _cut(reference, incident, n, faces, loops, corners, polygons):
    """Cut one face to the outline of another with the normal n; return which polygon, and its corners."""
    now, count = 0, faces[incident].count
    for k in range(count):
        i = loops[faces[incident].first + k]
        polygons[0, k, 0], polygons[0, k, 1], polygons[0, k, 2] = _corner(corners, i)
    sides = faces[reference].count
    for k in range(sides):
        start = _corner(corners, loops[faces[reference].first + k])
        end = _corner(corners, loops[faces[reference].first + (k + 1) % sides])
        out = cross(added(end, -1.0, start), n)  # of the outline, which goes round counter-clockwise
        left, target = 0, 1 - now
        for m in range(count):
            p = polygons[now, m, 0], polygons[now, m, 1], polygons[now, m, 2]
            e = (m + 1) % count
            q = polygons[now, e, 0], polygons[now, e, 1], polygons[now, e, 2]
            dp, dq = dot(out, added(p, -1.0, start)), dot(out, added(q, -1.0, start))
            if dp <= 0.0:
                polygons[target, left, 0], polygons[target, left, 1], polygons[target, left, 2] = p
                left += 1
            if (dp < 0.0 and dq > 0.0) or (dp > 0.0 and dq < 0.0):
                x = added(p, dp / (dp - dq), added(q, -1.0, p))
                polygons[target, left, 0], polygons[target, left, 1], polygons[target, left, 2] = x
                left += 1
        now, count = target, left
        if count == 0:
            break
    return now, count


@inner
def _thin_out(polygon, count, n, touching):
    """Keep the outermost corners of a polygon in eight directions as ``touching``; return their number."""
    u, v = tangents(n)
    kept = 0
    for d in range(MOST_TOUCHING):
        # off the directions that boxes have
        sine, cosine = sine_and_cosine(d * (2.0 * math.pi / MOST_TOUCHING) + 0.1)
        way = added((cosine * u[0], cosine * u[1], cosine * u[2]), sine, v)
        far, found = -math.inf, -1
        for m in range(count):
            reach = dot(way, (polygon[m, 0], polygon[m, 1], polygon[m, 2]))
            if reach > far:
                far, found = reach, m
        known = False
        for m in range(kept):
            known = known or touching[m, 4] == found
        if not known:
            for c in range(4):
                touching[kept, c] = polygon[found, c]
            touching[kept, 4] = found
            kept += 1
    return kept


@inner
def touch(a, s, b, r, closed, faces, loops, edges, corners, polygons, touching):
    """Find where two bodies touch.

    Parameters
    ----------
    a, s, b, r : SOLID, POSE, SOLID, POSE
        The bodies, and where they are.
    closed : float
        Gap up to which they touch [m].
    touching : float64[8, 5]
        Set to the points (x, y, z) and their gaps.

    Returns
    -------
    tuple
        How far they are apart (a lower bound; below 0 inside each other), how many points touch, and the
        normal from b to a.
    """
    none = (0.0, 0.0, 1.0)
    away = added(place_of(r), -1.0, place_of(s))
    reach = norm(away) - a.radius - b.radius
    if reach > closed:
        return reach, 0, none
    face_a, apart_a = _best_face(a, s, b, faces, loops, corners)
    face_b, apart_b = _best_face(b, r, a, faces, loops, corners)
    apart = max(apart_a, apart_b)
    if apart > closed:
        return apart, 0, none
    edge_a, edge_b, apart_e, axis = _best_edges(a, b, away, apart, edges, corners)
    if apart_e > apart + PREFER_FACES:
        if apart_e > closed:
            return apart_e, 0, none
        point = _crossing(edges, corners, edge_a, edge_b)
        touching[0, 0], touching[0, 1], touching[0, 2] = point
        touching[0, 3] = apart_e
        return apart_e, 1, (-axis[0], -axis[1], -axis[2])
    if apart_a >= apart_b - PREFER_FACES:  # of two faces alike the first body's, so that it does not change
        reference, n = face_a, _normal(s, faces[face_a])
        incident, towards = _facing(b, r, faces, n), (-n[0], -n[1], -n[2])
    else:
        reference, n = face_b, _normal(r, faces[face_b])
        incident, towards = _facing(a, s, faces, n), n
    now, count = _cut(reference, incident, n, faces, loops, corners, polygons)
    level = dot(n, _corner(corners, loops[faces[reference].first]))
    left = 0
    for m in range(count):
        p = polygons[now, m, 0], polygons[now, m, 1], polygons[now, m, 2]
        gap = dot(n, p) - level
        if gap <= closed:
            polygons[now, left, 0], polygons[now, left, 1], polygons[now, left, 2] = p
            polygons[now, left, 3] = gap
            left += 1
    if left > MOST_TOUCHING:
        return apart, _thin_out(polygons[now], left, n, touching), towards
    for m in range(left):
        for c in range(4):
            touching[m, c] = polygons[now, m, c]
    return apart, left, towards
