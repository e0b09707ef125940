"""Which points of bodies touch which planes of the room, and how far away the others are."""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.space.body import angular_response, bend, in_body, in_room, place_of, rotation
from stayput.mechanics.space.vectors import added, cross, dot, norm, normal_of, scaled

ROOM = -1
"""The other body of a contact with a plane of the room."""

ENTERS = 1e-8
"""How far a corner or a rim may enter a plane in a step [m]; one that goes deeper ends where they meet."""

FLAT = 1e-9
"""Sine of the angle up to which no point of a rim is the lowest: rounding."""

FAR = 0.5
"""Angle on a rim by which its lowest point may move in a step that follows it [rad]."""

NEARLY_FLAT = 1e-6
"""How far one side of a rim that lies flat may be off a plane [m]: a load beside its middle tips it."""

DIAGONAL = math.sqrt(0.5)

RIM_POINTS = 9
"""Points of a rim that may touch a plane: where it is lowest, and eight around where it lies flat."""


@inline
def lever_of_point(s, point):
    """Return a body's point from G, in the room's axes."""
    return in_room(s, (point.x, point.y, point.z))


@inline
def flat_within(rim, closed):
    """Return the sine of the angle up to which all of a rim is within a distance from a plane."""
    return max(FLAT, 0.5 * max(closed, NEARLY_FLAT) / rim.radius)


@inline
def lever_on_rim(s, rim, plane, number, towards, flat):
    """Return a point of a rim from G, and whether it may touch the plane.

    Number 0 is the lowest point of a rim that is tilted; 1 to 8 stand around a rim that lies flat, to an
    angle whose sine is ``flat``, the first in the direction ``towards`` along which the body is pushed, where
    the edge is that of the circle.
    """
    n = normal_of(plane)
    axis, centre = in_room(s, (rim.ax, rim.ay, rim.az)), in_room(s, (rim.x, rim.y, rim.z))
    slope = dot(n, axis)
    down = slope * axis[0] - n[0], slope * axis[1] - n[1], slope * axis[2] - n[2]
    size = norm(down)
    if number == 0:
        if size <= flat:
            return centre, False
        return added(centre, rim.radius / size, down), True
    if size > flat:
        return centre, False
    along = added(towards, -dot(towards, axis), axis)
    size = norm(along)
    if size <= 1e-12:
        along = in_room(s, (rim.ay, rim.az, rim.ax))
        along = added(along, -dot(along, axis), axis)
        size = norm(along)
    along = along[0] / size, along[1] / size, along[2] / size
    across = cross(axis, along)
    far = rim.radius if number % 2 == 1 else -rim.radius
    if number <= 2:
        return added(centre, far, along), True
    if number <= 4:
        return added(centre, far, across), True
    aside = 1.0 if number <= 6 else -1.0
    return added(added(centre, DIAGONAL * far, along), DIAGONAL * aside * far, across), True


@inner
def bend_of_rim(body, s, rim, plane, number, h):
    """Return the acceleration in free flight, without gravity, of what touches at point ``number`` of a rim.

    That of the body's point there, which as the rim rolls is another one: u = v + ω × r changes by
    ω' × r + ω × r', with r' of the lowest point r = c + R d/|d|, d = (n·a) a − n, where the axis is a and the
    centre c. Its normal part is that of the gap.
    """
    n, axis, spin = normal_of(plane), in_room(s, (rim.ax, rim.ay, rim.az)), rotation(s)
    centre = in_room(s, (rim.x, rim.y, rim.z))
    slope = dot(n, axis)
    down = added(scaled(slope, axis), -1.0, n)
    size = norm(down)
    if number > 0 or size <= FLAT:
        return bend(body, s, centre)
    turn = cross(spin, axis)
    change = added(scaled(dot(n, turn), axis), slope, turn)
    down = scaled(1.0 / size, down)
    moves = added(change, -dot(down, change), down)
    if norm(moves) * h > FAR * size:
        return bend(body, s, centre)
    moves = added(cross(spin, centre), rim.radius / size, moves)
    slows = angular_response(s, cross(spin, (s.lx, s.ly, s.lz)))
    return added(cross(spin, moves), -1.0, cross(slows, added(centre, rim.radius, down)))


@inline
def may_touch(feature, plane):
    """Return whether a point or a rim may touch a plane."""
    return feature.floor if plane.floor else feature.walls


@inline
def plane_from(s, plane):
    """Return the distance of G from a plane, and the plane's normal in the body's axes."""
    return dot(normal_of(plane), place_of(s)) - plane.offset, in_body(s, normal_of(plane))


@inline
def gap_of_point(point, height, n):
    """Return the distance of a body's point from a plane, by `plane_from`: below 0 inside it."""
    return height + point.x * n[0] + point.y * n[1] + point.z * n[2]


@inline
def gap_of(s, lever, plane):
    """Return the distance of a point, given from G, from a plane: below 0 inside it."""
    return dot(normal_of(plane), added(place_of(s), 1.0, lever)) - plane.offset


@inner
def note_gaps(bodies, poses, points, rims, planes, gaps):
    """Set the gaps of all features and planes, inf where they may not touch.

    A feature is a point, or a rim, whose gap is that of its lowest point.

    Returns
    -------
    float
        The least gap.
    """
    least = math.inf
    features = points.shape[0] + rims.shape[0]
    for b in range(bodies.shape[0]):
        body, s = bodies[b], poses[b]
        for j in range(planes.shape[0]):
            plane = planes[j]
            height, n = plane_from(s, plane)
            for i in range(body.first_point, body.first_point + body.points):
                gap = math.inf
                if may_touch(points[i], plane):
                    gap = gap_of_point(points[i], height, n)
                gaps[j * features + i] = gap
                least = min(least, gap)
            for i in range(body.first_rim, body.first_rim + body.rims):
                gap = math.inf
                if may_touch(rims[i], plane):
                    gap = gap_of(s, lowest_lever(s, rims[i], plane), plane)
                gaps[j * features + points.shape[0] + i] = gap
                least = min(least, gap)
    return least


@inline
def lowest_lever(s, rim, plane):
    """Return a lowest point of a rim from G: any where it lies flat."""
    lever, tilted = lever_on_rim(s, rim, plane, 0, (1.0, 0.0, 0.0), FLAT)
    if not tilted:
        lever, _ = lever_on_rim(s, rim, plane, 1, (1.0, 0.0, 0.0), FLAT)
    return lever
