"""Rest on the floor in closed form: what push of gravity and shaking a body that stands still can bear.

The floor's forces on a body at rest are one force through the point where what acts on it (the push through
G, and devices, whose forces stay as they are) meets the floor. They hold it where this point lies within what
the body stands on and the force is inside the cone of friction: forces at its feet that share the weight so,
each along it, then do so. Bodies that also touch walls or each other bear it without them. What a body bears
is convex in the push, so that one which bears the pushes at two samples bears all between.

Devices may leave a moment M about the vertical through that point c. Friction at c + κ (r − c) of contacts r
(`stayput.model.even_base`) bears it by forces across r − c and in proportion to it: their sum is 0 as that of
w (r − c) is, with the shares w of the weight N. The largest is μ w N, so that they bear

    M = μ N κ Σ w |r − c|² / max |r − c|,        Σ w |r − c|² = Σ w |r − p|² − |c − p|²,

at least μ N ϱ with ϱ = κ (min |r − p|² − |c − p|²)/(max |r − p| + |c − p|) for any p, here the middle of the
contacts. Together with a force H the body stays, forces being added, where H/(μ N) + M/(μ N ϱ) ≤ 1.
"""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.space.body import place_of
from stayput.mechanics.space.stepping import push_at
from stayput.mechanics.space.touching import RIM_POINTS, flat_within, gap_of, lever_of_point, lever_on_rim
from stayput.mechanics.space.vectors import added

HELD = 1e-9
"""How exactly it is told when the floor holds no more what is at rest, in samples."""

STAYS, SLIPS, TIPS = range(3)
"""What becomes of bodies at rest."""


@inline
def _lies(body, s, points, floor, i, closed):
    """Return a point of a body from G, and whether it lies on the floor."""
    point = points[body.first_point + i]
    lever = lever_of_point(s, point)
    return lever, point.floor and gap_of(s, lever, floor) <= closed


@inner
def _sides(body, s, points, floor, closed, sides):
    """Set the sides n·x ≤ d about G of the polygon of a body's points on the floor; return their number.

    They are found one after the other round the polygon (Jarvis' march), the point farthest back in x first.
    """
    first, start = -1, (0.0, 0.0, 0.0)
    for i in range(body.points):
        lever, lies = _lies(body, s, points, floor, i, closed)
        if lies and (first < 0 or lever[0] < start[0] or (lever[0] == start[0] and lever[1] < start[1])):
            first, start = i, lever
    if first < 0:
        return 0
    now, here, count = first, start, 0
    while count < body.points:
        following, there = -1, here
        for i in range(body.points):
            if i != now:
                lever, lies = _lies(body, s, points, floor, i, closed)
                along, other = added(there, -1.0, here), added(lever, -1.0, here)
                out = along[0] * other[1] - along[1] * other[0]
                farther = math.hypot(other[0], other[1]) > math.hypot(along[0], along[1])
                if lies and (following < 0 or out < 0.0 or (out == 0.0 and farther)):
                    following, there = i, lever
        if following < 0:
            return 0
        n = there[1] - here[1], here[0] - there[0]
        side = sides[body.first_point + count]
        side[0], side[1], side[2] = n[0], n[1], n[0] * here[0] + n[1] * here[1]
        now, here, count = following, there, count + 1
        if now == first:
            break
    return count if count > 2 else 0


@inner
def _spread(body, s, points, floor, closed, spread):
    """Set the middle of a body's points on the floor, their least squared and largest distance from it."""
    x = y = 0.0
    count, least, most = 0, math.inf, 0.0
    for i in range(body.points):
        lever, lies = _lies(body, s, points, floor, i, closed)
        if lies:
            x, y, count = x + lever[0], y + lever[1], count + 1
    if count > 0:
        x, y = x / count, y / count
    for i in range(body.points):
        lever, lies = _lies(body, s, points, floor, i, closed)
        if lies:
            far = (lever[0] - x) ** 2 + (lever[1] - y) ** 2
            least, most = min(least, far), max(most, math.sqrt(far))
    spread[0], spread[1], spread[2], spread[3] = x, y, least, most


@inline
def _least_arm(kappa, spread, x, y):
    """Return ϱ with the force through a point of the floor from G."""
    aside = math.hypot(x - spread[0], y - spread[1])
    return kappa * max(0.0, spread[2] - aside * aside) / (spread[3] + aside)


@inner
def note_stances(world, poses, closed, stances):
    """Note what each body stands on: sides of the polygon of its points and circles that lie on the floor.

    Also noted is the least friction of its points, the middle of what it stands on, and from there the least
    distance of that squared and the largest.
    """
    bodies, points, rims, planes = world[0], world[1], world[2], world[3]
    sides, counts, discs, frictions, _, spreads = stances
    for b in range(bodies.shape[0]):
        body, s = bodies[b], poses[b]
        counts[b] = _sides(body, s, points, planes[0], closed, sides)
        frictions[b] = body.mu_static
        for i in range(body.first_point, body.first_point + body.points):
            if points[i].mu_static < frictions[b]:  # False for NaN
                frictions[b] = points[i].mu_static
        _spread(body, s, points, planes[0], closed, spreads[b])
        discs[b, 2] = 0.0
        for i in range(body.first_rim, body.first_rim + body.rims):
            if rims[i].floor:
                flat = flat_within(rims[i], closed)
                lever, lies = lever_on_rim(s, rims[i], planes[0], 1, (1.0, 0.0, 0.0), flat)
                if lies and gap_of(s, lever, planes[0]) <= closed:
                    other, _ = lever_on_rim(s, rims[i], planes[0], 2, (1.0, 0.0, 0.0), flat)
                    discs[b, 0], discs[b, 1] = 0.5 * (lever[0] + other[0]), 0.5 * (lever[1] + other[1])
                    discs[b, 2] = rims[i].radius
                    spreads[b, 0], spreads[b, 1] = discs[b, 0], discs[b, 1]
                    spreads[b, 2], spreads[b, 3] = rims[i].radius * rims[i].radius, rims[i].radius


@inner
def stays_at_rest(bodies, poses, floor, push, stances):
    """Return `STAYS` where the floor alone holds all bodies at rest.

    Else `TIPS` where one does or stands on another, `SLIPS` where one slides or turns on it, and which. What
    would do both may tip alone, with less friction than it took to stand.
    """
    sides, counts, discs, frictions, loads, spreads = stances
    for b in range(bodies.shape[0]):
        mass, load = bodies[b].mass, loads[b]
        force = mass * push[0] + load[0], mass * push[1] + load[1]
        weight = -mass * push[2] - load[2]
        if weight <= 0.0:
            return TIPS, b
        height = place_of(poses[b])[2] - floor.offset
        # times the weight, where the force meets the floor
        x, y = height * force[0] + load[4], height * force[1] - load[3]
        far = math.hypot(x - weight * discs[b, 0], y - weight * discs[b, 1])
        # without a circle its centre is no place to stand on
        if discs[b, 2] == 0.0 or far > weight * discs[b, 2]:
            if counts[b] == 0:
                return TIPS, b
            for i in range(bodies[b].first_point, bodies[b].first_point + counts[b]):
                if sides[i, 0] * x + sides[i, 1] * y > weight * sides[i, 2]:
                    return TIPS, b
        moment = load[5] - (load[4] * force[1] + load[3] * force[0]) / weight
        left = frictions[b] * weight - math.hypot(force[0], force[1])
        if left < 0.0 or abs(moment) > left * _least_arm(bodies[b].kappa, spreads[b], x / weight, y / weight):
            return SLIPS, b
    return STAYS, 0


@inner
def surely_stays(bodies, poses, floor, push, stances):
    """Return whether a lone body without loads surely stays at rest: `stays_at_rest` without roots."""
    sides, counts, discs, frictions, loads, _ = stances
    weight = -push[2]
    if discs[0, 2] != 0.0 or counts[0] == 0 or weight <= 0.0:
        return False
    for axis in range(6):
        if loads[0, axis] != 0.0:
            return False
    height, first = poses[0].z - floor.offset, bodies[0].first_point
    for i in range(first, first + counts[0]):
        if height * (sides[i, 0] * push[0] + sides[i, 1] * push[1]) > weight * sides[i, 2]:
            return False
    most = frictions[0] * weight
    return push[0] * push[0] + push[1] * push[1] < most * most


@inner
def stays_until(bodies, poses, floor, a0, a1, gravity, part, stances):
    """Return until when, from ``part`` of the time between two samples on, the floor alone holds all at rest.

    What it bears is convex in the push, so that there is one such time.

    Returns
    -------
    tuple
        The part of the time, and what then becomes of which body: 1 and `STAYS` where the floor holds all.
    """
    why, b = stays_at_rest(bodies, poses, floor, push_at(a0, a1, part, gravity), stances)
    if why != STAYS:
        return part, why, b
    end = 1.0
    why, b = stays_at_rest(bodies, poses, floor, push_at(a0, a1, end, gravity), stances)
    while why != STAYS and end - part > HELD:
        middle = 0.5 * (part + end)
        now, other = stays_at_rest(bodies, poses, floor, push_at(a0, a1, middle, gravity), stances)
        if now == STAYS:
            part = middle
        else:
            end, why, b = middle, now, other
    return end, why, b


@inline
def on_floor_alone(contacts, count, b):
    """Return whether a body touched nothing but the floor in the last step."""
    for c in contacts[:count]:
        if (c.a == b and not c.floor) or c.b == b:
            return False
    return True


@inner
def let_slip(world, b, kept):
    """Let the contacts of a body with the floor, the first plane, slip from the next step on."""
    body, rims = world[0][b], world[3].shape[0] * world[1].shape[0]
    for key in range(body.first_point, body.first_point + body.points):
        kept[key, 3] = 0.0 if kept[key, 3] == 1.0 else kept[key, 3]
    for key in range(rims + body.first_rim * RIM_POINTS, rims + (body.first_rim + body.rims) * RIM_POINTS):
        kept[key, 3] = 0.0 if kept[key, 3] == 1.0 else kept[key, 3]
