"""Where two convex bodies touch: the axis that separates them most, and points on it.

Two convex polyhedra are apart along the normal of a face of either, or along the common normal of an edge of
each (the separating axis theorem). Where a face separates them most, the face of the other that looks against
it most is cut to its outline, and what is left of its corners touches; else the two edges touch in one point.
"""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.elementary import sine_and_cosine
from stayput.mechanics.space.body import in_room, place_of, rotation
from stayput.mechanics.space.touching import lever_of_point
from stayput.mechanics.space.vectors import added, cross, dot, norm, normal_of, tangents

MOST_TOUCHING = 8
"""Most points in which two bodies touch."""

PREFER_FACES = 1e-6
"""By how much edges must separate bodies more than faces do, which touch in more points [m]."""

SHALLOW = 5e-5
"""Depth up to which no other axis is tried where bodies touch [m]."""

NEAR = 0.01
"""Share of both radii up to which edges are near the other body: others are tried where these do not tell."""

OUTERMOST = 1e-9
"""How far inside its body's outermost corner along a normal an edge lies that touches there [m]: rounding."""

CROSSES = 0.1
"""Sine of the angle from which on it is told how fast two edges touch elsewhere."""

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
def _along(edges, corners, i):
    """Return an edge, from the one of its ends to the other."""
    return added(_corner(corners, edges[i, 1]), -1.0, _corner(corners, edges[i, 0]))


@inline
def _has_face(body, face):
    """Return whether a face of the list is one of a body's."""
    return body.first_face <= face < body.first_face + body.faces


@inline
def _normal(s, face):
    """Return a face's outward normal in the room's axes."""
    return in_room(s, normal_of(face))


@inner
def _least(body, corners, axis):
    """Return the least of axis·x over the hull of a body."""
    least = math.inf
    for i in range(body.first_point, body.first_point + body.hull):
        least = min(least, dot(axis, _corner(corners, i)))
    return least


@inner
def _best_face(body, s, other, faces, loops, corners):
    """Return the face of a body beyond which the other lies farthest, and how far."""
    best, face = -math.inf, -1
    for f in range(body.first_face, body.first_face + body.faces):
        n = _normal(s, faces[f])
        apart = _least(other, corners, n) - dot(n, _corner(corners, loops[faces[f].first]))
        if apart > best:
            best, face = apart, f
    return face, best


@inner
def _bounds(body, near, corners):
    """Return the least and the greatest coordinates of what is nearer to the hull of a body than ``near``."""
    low, high = (math.inf, math.inf, math.inf), (-math.inf, -math.inf, -math.inf)
    for i in range(body.first_point, body.first_point + body.hull):
        x, y, z = _corner(corners, i)
        low = min(low[0], x - near), min(low[1], y - near), min(low[2], z - near)
        high = max(high[0], x + near), max(high[1], y + near), max(high[2], z + near)
    return low, high


@inline
def _is_outside(edge, low, high, corners):
    """Return whether all of an edge lies beyond a side of a box."""
    p, q = _corner(corners, edge[0]), _corner(corners, edge[1])
    return (
        max(p[0], q[0]) < low[0]
        or max(p[1], q[1]) < low[1]
        or max(p[2], q[2]) < low[2]
        or min(p[0], q[0]) > high[0]
        or min(p[1], q[1]) > high[1]
        or min(p[2], q[2]) > high[2]
    )


@inline
def _across(along, other, away):
    """Return the unit vector across two edges that points ``away``, and whether there is one."""
    n = cross(along, other)
    size = norm(n)
    if size <= PARALLEL * norm(along) * norm(other):
        return n, False
    if dot(n, away) < 0.0:
        size = -size
    return (n[0] / size, n[1] / size, n[2] / size), True


@inner
def _best_edges(a, b, away, best, near, edges, corners):
    """Return the edges of two bodies whose common normal separates them most, how far, and the normal from a.

    ``away`` is the direction from a to b; edges that separate them less than ``best`` do not count, and none
    that is farther from the other body than ``near``.
    """
    first, second, axis = -1, -1, away
    low_a, high_a = _bounds(a, near, corners)
    low_b, high_b = _bounds(b, near, corners)
    for i in range(a.first_edge, a.first_edge + a.edges):
        if _is_outside(edges[i], low_b, high_b, corners):
            continue
        along_a = _along(edges, corners, i)
        for j in range(b.first_edge, b.first_edge + b.edges):
            if _is_outside(edges[j], low_a, high_a, corners):
                continue
            n, crossed = _across(along_a, _along(edges, corners, j), away)
            if not crossed:
                continue
            # only edges that are outermost along their normal can touch
            reach = dot(n, _corner(corners, edges[i, 0]))
            start = dot(n, _corner(corners, edges[j, 0]))
            if start - reach <= best:
                continue
            apart = _least(b, corners, n) + _least(a, corners, (-n[0], -n[1], -n[2]))
            # of parallel edges, which separate alike, those that are outermost touch
            if apart > best and start - reach <= apart + OUTERMOST:
                best, first, second, axis = apart, i, j, n
    return first, second, best, axis


@inner
def _crossing(edges, corners, i, j):
    """Return the middle of the shortest way between two edges' lines, and whether it is on both edges."""
    p, q = _corner(corners, edges[i, 0]), _corner(corners, edges[j, 0])
    u, v = _along(edges, corners, i), _along(edges, corners, j)
    w = added(p, -1.0, q)
    uu, uv, vv, uw, vw = dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w)
    det = uu * vv - uv * uv
    f, g = (uv * vw - vv * uw) / det, (uu * vw - uv * uw) / det
    x, y = added(p, f, u), added(q, g, v)
    middle = 0.5 * (x[0] + y[0]), 0.5 * (x[1] + y[1]), 0.5 * (x[2] + y[2])
    return middle, 0.0 <= f <= 1.0 and 0.0 <= g <= 1.0


@inline
def _has_corner(face, loops, i):
    for k in range(face.first, face.first + face.count):
        if loops[k] == i:
            return True
    return False


@inner
def _facing(body, s, faces, loops, corners, n):
    """Return the face of a body that looks most against a direction, of those at its corner farthest back.

    Of a body with slanted faces another one may look more that way and lie farther back.
    """
    nearest, outermost = math.inf, -1
    for i in range(body.first_point, body.first_point + body.hull):
        reach = dot(n, _corner(corners, i))
        if reach < nearest:
            nearest, outermost = reach, i
    least, face = math.inf, -1
    for f in range(body.first_face, body.first_face + body.faces):
        if _has_corner(faces[f], loops, outermost):
            looks = dot(n, _normal(s, faces[f]))
            if looks < least:
                least, face = looks, f
    return face


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
        far, farthest = -math.inf, -1
        for m in range(count):
            reach = dot(way, (polygon[m, 0], polygon[m, 1], polygon[m, 2]))
            if reach > far:
                far, farthest = reach, m
        known = False
        for m in range(kept):
            known = known or touching[m, 4] == farthest
        if not known:
            for c in range(4):
                touching[kept, c] = polygon[farthest, c]
            touching[kept, 4] = farthest
            kept += 1
    return kept


@inner
def _meet_on_face(a, s, b, r, face, closed, faces, loops, corners, polygons, touching):
    """Find where a face of one of two bodies touches the other.

    Returns
    -------
    tuple
        How many points touch, and the normal from b to a.
    """
    if _has_face(a, face):
        n = _normal(s, faces[face])
        incident, towards = _facing(b, r, faces, loops, corners, n), (-n[0], -n[1], -n[2])
    else:
        n = _normal(r, faces[face])
        incident, towards = _facing(a, s, faces, loops, corners, n), n
    now, count = _cut(face, incident, n, faces, loops, corners, polygons)
    level = dot(n, _corner(corners, loops[faces[face].first]))
    left = 0
    for m in range(count):
        p = polygons[now, m, 0], polygons[now, m, 1], polygons[now, m, 2]
        gap = dot(n, p) - level
        if gap <= closed:
            polygons[now, left, 0], polygons[now, left, 1], polygons[now, left, 2] = p
            polygons[now, left, 3] = gap
            left += 1
    if left > MOST_TOUCHING:
        return _thin_out(polygons[now], left, n, touching), towards
    for m in range(left):
        for c in range(4):
            touching[m, c] = polygons[now, m, c]
    return left, towards


@inner
def _apart_along(a, s, b, r, axis_of, edges, faces, loops, corners):
    """Return how far the face or the two edges in ``axis_of`` keep two bodies apart, and the normal from a.

    Edges that are not outermost along their normal, or parallel, tell nothing: −inf.
    """
    if axis_of[1] < 0:
        face = axis_of[0]
        on_a = _has_face(a, face)
        n = _normal(s, faces[face]) if on_a else _normal(r, faces[face])
        level = dot(n, _corner(corners, loops[faces[face].first]))
        return _least(b if on_a else a, corners, n) - level, n
    i, j = axis_of[0], axis_of[1]
    p, q = _corner(corners, edges[i, 0]), _corner(corners, edges[j, 0])
    away = added(place_of(r), -1.0, place_of(s))
    n, crossed = _across(_along(edges, corners, i), _along(edges, corners, j), away)
    if not crossed:
        return -math.inf, n
    apart = _least(b, corners, n) + _least(a, corners, (-n[0], -n[1], -n[2]))
    return apart if dot(n, added(q, -1.0, p)) <= apart + OUTERMOST else -math.inf, n


@inner
def deepest(touching, count):
    """Return the least gap of points that touch: a corner that hangs over beside a face is deep in none."""
    least = touching[0, 3]
    for m in range(1, count):
        least = min(least, touching[m, 3])
    return least


@inner
def touch(a, s, b, r, closed, axis_of, faces, loops, edges, corners, polygons, touching):
    """Find where two bodies touch.

    Parameters
    ----------
    a, s, b, r : SOLID, POSE, SOLID, POSE
        The bodies, and where they are.
    closed : float
        Gap up to which they touch [m].
    axis_of : int64[2]
        The face, and −1, or the two edges that separated them last, (−1, −1) if none has: tried first, and
        set. Where they still keep them apart, or touch, no other tells more: points of both that are as near
        to each other as an axis keeps the bodies apart are the nearest.
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
    if axis_of[0] >= 0:
        apart, n = _apart_along(a, s, b, r, axis_of, edges, faces, loops, corners)
        if apart > closed:
            return apart, 0, none
        if apart >= -SHALLOW:
            if axis_of[1] < 0:
                count, towards = _meet_on_face(
                    a, s, b, r, axis_of[0], closed, faces, loops, corners, polygons, touching
                )
                if count:
                    return deepest(touching, count), count, towards
            else:
                point, crosses = _crossing(edges, corners, axis_of[0], axis_of[1])
                if crosses:
                    touching[0, 0], touching[0, 1], touching[0, 2] = point
                    touching[0, 3] = apart
                    return apart, 1, (-n[0], -n[1], -n[2])
    face_a, apart_a = _best_face(a, s, b, faces, loops, corners)
    face_b, apart_b = _best_face(b, r, a, faces, loops, corners)
    apart = max(apart_a, apart_b)
    # of two faces alike the first body's, so that it does not change
    face = face_a if apart_a >= apart_b - PREFER_FACES else face_b
    axis_of[0], axis_of[1] = face, -1
    if apart > closed:
        return apart, 0, none
    count, towards = _meet_on_face(a, s, b, r, face, closed, faces, loops, corners, polygons, touching)
    if count and apart >= -SHALLOW:
        return deepest(touching, count), count, towards
    near = NEAR * (a.radius + b.radius)
    edge_a, edge_b, apart_e, axis = _best_edges(a, b, away, apart, near, edges, corners)
    if edge_a < 0 and not count:
        # the faces that separate them most do not lie on each other: edges that do nearly as well must touch
        edge_a, edge_b, apart_e, axis = _best_edges(a, b, away, apart - SHALLOW, math.inf, edges, corners)
    if edge_a < 0 or (count and apart_e <= apart + PREFER_FACES):
        return apart, count, towards
    axis_of[0], axis_of[1] = edge_a, edge_b
    if apart_e > closed:
        return apart_e, 0, none
    point, _ = _crossing(edges, corners, edge_a, edge_b)
    touching[0, 0], touching[0, 1], touching[0, 2] = point
    touching[0, 3] = apart_e
    return apart_e, 1, (-axis[0], -axis[1], -axis[2])


@inner
def turning_opens(a, s, r, n, u, axis_of, edges, corners):
    """Return the acceleration by which a pair opens since what it touches with turns, beside that of points.

    A gap g = n·(x − y) has g″ = n·(x″ − y″) + 2 n′·u while the points x of body a and y of b slide with u
    along each other. The normal n of a face turns with its body, n′ = ω × n. That of two edges e and f turns
    with both, and the points move along these with α and β, u = β f − α e: there 2 n′·u is
    2 α n·(ω_a × e) − 2 β n·(ω_b × f). ``axis_of`` is that of `touch`.
    """
    if axis_of[1] < 0:
        return 2.0 * dot(cross(rotation(s) if _has_face(a, axis_of[0]) else rotation(r), n), u)
    e, f = _along(edges, corners, axis_of[0]), _along(edges, corners, axis_of[1])
    aside_e, aside_f = cross(n, e), cross(n, f)
    if abs(dot(e, aside_f)) <= CROSSES * norm(e) * norm(f):
        return 0.0
    alpha, beta = -dot(u, aside_f) / dot(e, aside_f), dot(u, aside_e) / dot(f, aside_e)
    return 2.0 * (alpha * dot(n, cross(rotation(s), e)) - beta * dot(n, cross(rotation(r), f)))
