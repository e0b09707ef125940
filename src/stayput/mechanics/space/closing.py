"""Which contacts are closed in a step, how far all others are apart, and when they meet."""

from stayput.compiling import inline, inner
from stayput.mechanics.space.body import bend, in_body, place_of, sag
from stayput.mechanics.space.contact import lever_a, lever_b, velocity_at
from stayput.mechanics.space.impact import hits_square, mark_what_hits
from stayput.mechanics.space.pairs import MOST_TOUCHING, place_corners, touch, turning_opens
from stayput.mechanics.space.rolling import set_rolling
from stayput.mechanics.space.solve import IMPACT, ask_for_bend, prepare, rise, spread_friction
from stayput.mechanics.space.touching import (
    ENTERS,
    RIM_POINTS,
    ROOM,
    bend_of_rim,
    flat_within,
    gap_of,
    gap_of_point,
    lever_of_point,
    lever_on_rim,
    lowest_lever,
    may_touch,
    note_gaps,
    plane_from,
)
from stayput.mechanics.space.vectors import added, dot, normal_of

NO_PLANE = -1
"""The plane of a contact between bodies."""

CLOSED = 1e-7
"""Gap from a plane up to which a contact is closed [m]: one that closes early turns a body back early."""

TOGETHER, AT_ONCE = 1e-6, 1e-6
"""The same of what was closed in the step before, and in steps shorter than this, as of impacts [m, s]:
corners that land together hit together, and stay so.
"""

CLOSED_BETWEEN, TOGETHER_BETWEEN = 1e-6, 2e-6
"""The same between bodies, and of what was closed in the step before [m]."""

MOST_RISE = 1e-4
"""How far beyond that a rim is looked at, which may be off the plane in mid-step (`rise`) [m]."""

SAME = 0.25
"""How far on a body a contact with another may have moved in a step, over its radius: farther it is new."""

OPEN = 2.0
"""In place of whether a contact stuck in the step before: it was open."""

ENTERS_BODIES = 1e-5
"""How far bodies may enter each other in a step [m]."""


@inner
def keep(contacts, count, kept, marks):
    """Note impulses, what sticks, when that changed, where it is, and whether it only stood, by contact.

    Impulses of impacts say nothing of those of the next step, which begins without.
    """
    mark_what_hits(contacts, count, marks, IMPACT)
    for k in range(kept.shape[0]):
        kept[k, 0] = kept[k, 1] = kept[k, 2] = 0.0
        kept[k, 3] = OPEN
    for c in contacts[:count]:
        part = 0.0 if marks[c.a] else 1.0
        kept[c.key, 0], kept[c.key, 1], kept[c.key, 2] = part * c.pn, part * c.ps, part * c.pt
        kept[c.key, 3], kept[c.key, 4] = float(c.stuck), c.when
        kept[c.key, 5], kept[c.key, 6], kept[c.key, 7], kept[c.key, 8] = c.x, c.y, c.z, float(c.stood)
        kept[c.key, 9] = part * c.pr


@inline
def _square_from(touching, m, s, old):
    """Return the squared distance of a point that touches from where a contact was on its body."""
    here = in_body(s, added((touching[m, 0], touching[m, 1], touching[m, 2]), -1.0, place_of(s)))
    away = added(here, -1.0, (old[5], old[6], old[7]))
    return dot(away, away)


@inner
def _unused(kept, touching, count):
    """Return the number of a contact that no point has, if it can be of one that was open."""
    spare = 0
    for q in range(MOST_TOUCHING):
        taken = False
        for m in range(count):
            taken = taken or touching[m, 4] == q
        if not taken:
            spare = q
            if kept[q, 3] == OPEN:
                break
    return spare


@inner
def _recognize(kept, touching, count, body, s):
    """Set the last column of points that touch to the numbers of their contacts among those of their pair.

    Each closed one of the step before goes on at the point that is nearest to where it was on body a, unless
    that is nearer to another. So a point that lands is a new one, whatever touched before.
    """
    for m in range(count):
        touching[m, 4] = -1.0
    for q in range(MOST_TOUCHING):
        nearest, at = (SAME * body.radius) ** 2, -1
        if kept[q, 3] != OPEN:
            for m in range(count):
                square = _square_from(touching, m, s, kept[q])
                if square < nearest:
                    nearest, at = square, m
        if at >= 0:
            other = int(touching[at, 4])
            if other < 0 or nearest < _square_from(touching, at, s, kept[other]):
                touching[at, 4] = float(q)
    for m in range(count):
        if touching[m, 4] < 0.0:
            touching[m, 4] = float(_unused(kept, touching, count))


@inline
def _close(contacts, count, key, kept, ratio, surface):
    """Add a contact whose bodies, normal and levers are set; its impulses begin with those kept."""
    c = contacts[count]
    c.key = key
    _rub(c, surface)
    c.stuck, c.stood = 1 if kept[key, 3] == 1.0 else 0, int(kept[key, 8])
    c.pn, c.ps, c.pt = ratio * kept[key, 0], ratio * kept[key, 1], ratio * kept[key, 2]
    c.roll, c.pr = 0.0, ratio * kept[key, 9]
    return count + 1


@inner
def _prepare(contacts, first, count, kept, surface, bodies, poses, h):
    """Prepare the contacts from ``first`` on, which are of the same two bodies."""
    spread_friction(contacts, first, count, bodies)
    for k in range(first, count):
        c = contacts[k]
        prepare(c, bodies, poses, surface.restitution)
        if kept[c.key, 3] == OPEN and hits_square(c, poses):
            c.stuck, c.mu = 1, c.mu_static
    ask_for_bend(contacts, first, count, bodies, h)


@inline
def _on_plane(c, b, lever, gap, j, plane, bent):
    c.a, c.b, c.plane, c.floor = b, ROOM, j, plane.floor
    c.nx, c.ny, c.nz = normal_of(plane)
    c.rax, c.ray, c.raz = lever
    c.gap = gap
    c.bx, c.by, c.bz = bent


@inline
def _rub(c, what):
    """Give a contact the friction of a surface, or of a point or a body on the floor."""
    c.mu_static, c.mu_kinetic = what.mu_static, what.mu_kinetic


@inline
def _touch_pair(world, poses, scratch, j, closed):
    """Find where a pair of bodies touches; see `touch`. The corners of all bodies have been placed."""
    bodies, _, _, _, pairs, faces, loops, edges = world
    corners, polygons, touching, axes = scratch[3], scratch[4], scratch[5], scratch[8]
    a, b = pairs[j].a, pairs[j].b
    body, other, s, r = bodies[a], bodies[b], poses[a], poses[b]
    return touch(body, s, other, r, closed, axes[j], faces, loops, edges, corners, polygons, touching)


@inner
def _find_between(world, poses, scratch, kept, ratio, h, count):
    """Fill in the contacts between bodies, after ``count`` of those with the room; return their number."""
    bodies, points, rims, planes, pairs, _, _, edges = world
    contacts, corners, touching, axes = scratch[0], scratch[3], scratch[5], scratch[8]
    place_corners(bodies, poses, points, corners)
    first_key = planes.shape[0] * (points.shape[0] + rims.shape[0] * RIM_POINTS)
    for j in range(pairs.shape[0]):
        a, b = pairs[j].a, pairs[j].b
        bends = sag(bodies[a], poses[a], h) + sag(bodies[b], poses[b], h)
        _, touched, n = _touch_pair(world, poses, scratch, j, TOGETHER_BETWEEN + bends)
        first, mine = count, kept[first_key + j * MOST_TOUCHING : first_key + (j + 1) * MOST_TOUCHING]
        _recognize(mine, touching, touched, bodies[a], poses[a])
        for m in range(touched):
            c = contacts[count]
            c.a, c.b, c.plane, c.floor = a, b, NO_PLANE, 0
            c.nx, c.ny, c.nz = n
            place = touching[m, 0], touching[m, 1], touching[m, 2]
            c.rax, c.ray, c.raz = added(place, -1.0, place_of(poses[a]))
            c.rbx, c.rby, c.rbz = added(place, -1.0, place_of(poses[b]))
            bent = bend(bodies[a], poses[a], lever_a(c))
            bent = added(bent, -1.0, bend(bodies[b], poses[b], lever_b(c)))
            slips = added(velocity_at(poses[a], lever_a(c)), -1.0, velocity_at(poses[b], lever_b(c)))
            more = turning_opens(bodies[a], poses[a], poses[b], n, slips, axes[j], edges, corners)
            bent = added(bent, more, n)
            c.bx, c.by, c.bz = bent
            c.gap = touching[m, 3]
            key = first_key + j * MOST_TOUCHING + int(touching[m, 4])
            if c.gap - rise(n, bent, h) > (CLOSED_BETWEEN if kept[key, 3] == OPEN else TOGETHER_BETWEEN):
                continue
            c.x, c.y, c.z = in_body(poses[a], lever_a(c))
            count = _close(contacts, count, key, kept, ratio, pairs[j])
        if count > first:
            _prepare(contacts, first, count, kept, pairs[j], bodies, poses, h)
    return count


@inner
def find_contacts(world, poses, push, scratch, kept, ratio, h):
    """Fill in the closed contacts; return their number. Impulses begin with those kept, times a ratio."""
    bodies, points, rims, planes, pairs, _, _, _ = world
    contacts = scratch[0]
    count, closed = 0, (TOGETHER if h < AT_ONCE else CLOSED)
    for j in range(planes.shape[0]):
        plane = planes[j]
        first_key = planes.shape[0] * points.shape[0] + j * rims.shape[0] * RIM_POINTS
        for b in range(bodies.shape[0]):
            body, s, first, touches = bodies[b], poses[b], count, 0
            height, n = plane_from(s, plane)
            bends = sag(body, s, h)
            for i in range(body.first_point, body.first_point + body.points):
                if may_touch(points[i], plane):
                    gap, key = gap_of_point(points[i], height, n), j * points.shape[0] + i
                    if gap > TOGETHER + bends:
                        continue
                    lever = lever_of_point(s, points[i])
                    bent = bend(body, s, lever)
                    within = closed if kept[key, 3] == OPEN else TOGETHER
                    least = gap - rise(normal_of(plane), bent, h)
                    if least <= within:
                        touches += 1 if least <= closed else 0
                        _on_plane(contacts[count], b, lever, gap, j, plane, bent)
                        count = _close(contacts, count, key, kept, ratio, plane)
                        if plane.floor and points[i].mu_static >= 0.0:  # not NaN
                            _rub(contacts[count - 1], points[i])
                        elif plane.floor:
                            _rub(contacts[count - 1], body)
            if plane.floor and touches <= 2:  # on a corner or an edge
                for k in range(first, count):
                    if not points[contacts[k].key - j * points.shape[0]].mu_static >= 0.0:
                        contacts[k].mu_static, contacts[k].mu_kinetic = body.edge_static, body.edge_kinetic
            for i in range(body.first_rim, body.first_rim + body.rims):
                if may_touch(rims[i], plane):
                    flat = flat_within(rims[i], closed)
                    for number in range(RIM_POINTS):
                        lever, there = lever_on_rim(s, rims[i], plane, number, push, flat)
                        gap, key = gap_of(s, lever, plane), first_key + i * RIM_POINTS + number
                        if not there or gap > closed + MOST_RISE:
                            continue
                        bent = bend_of_rim(body, s, rims[i], plane, number, h)
                        within = closed if kept[key, 3] == OPEN else TOGETHER
                        if gap - rise(normal_of(plane), bent, h) <= within:
                            _on_plane(contacts[count], b, lever, gap, j, plane, bent)
                            count = _close(contacts, count, key, kept, ratio, plane)
                            if plane.floor:
                                _rub(contacts[count - 1], body)
                            if plane.floor and number == 0:
                                set_rolling(contacts[count - 1], s, rims[i], body.rolling)
            if count > first:
                _prepare(contacts, first, count, kept, plane, bodies, poses, h)
    return _find_between(world, poses, scratch, kept, ratio, h, count) if pairs.shape[0] > 0 else count


@inner
def note_all_gaps(world, poses, scratch, gaps):
    """Set the gaps of all features and planes and of all pairs of bodies.

    Returns
    -------
    tuple
        The least gap, and the least of what is left until bodies are too deep in planes or each other.
    """
    bodies, points, rims, planes, pairs, _, _, _ = world
    corners = scratch[3]
    least = note_gaps(bodies, poses, points, rims, planes, gaps)
    left = least + ENTERS
    if pairs.shape[0] == 0:
        return least, left
    place_corners(bodies, poses, points, corners)
    first = planes.shape[0] * (points.shape[0] + rims.shape[0])
    for j in range(pairs.shape[0]):
        apart, _, _ = _touch_pair(world, poses, scratch, j, CLOSED_BETWEEN)
        gaps[first + j] = apart
        least, left = min(least, apart), min(left, apart + ENTERS_BODIES)
    return least, left


@inline
def _meets(s, lever, plane, gap, later, first, h):
    """Return when within a step a point meets a plane that it enters, or ``first`` where that is earlier.

    By Newton's method from the end of the step, and not before where a straight line meets it.
    """
    start = max(gap, 0.0)
    meets = h * start / (start - later)
    rate = dot(normal_of(plane), velocity_at(s, lever))
    return min(first, max(meets, h - later / rate)) if rate < 0.0 else min(first, meets)


@inner
def meeting(world, poses, gaps, later, h):
    """Return when within a step, with ``poses`` at its end, bodies first meet planes or each other.

    The gaps are those of points and rims, plane by plane, and at last those of pairs of bodies. What touches
    at first may go deeper by as much as its path bends.
    """
    bodies, points, rims, planes, pairs = world[0], world[1], world[2], world[3], world[4]
    first = h
    for j in range(planes.shape[0]):
        plane, before = planes[j], j * (points.shape[0] + rims.shape[0])
        round_edges = before + points.shape[0]
        for b in range(bodies.shape[0]):
            body, s = bodies[b], poses[b]
            bent = sag(body, s, h)
            for i in range(body.first_point, body.first_point + body.points):
                gap, end = gaps[before + i], later[before + i]
                if end < -ENTERS - (bent if gap <= CLOSED else 0.0):
                    first = _meets(s, lever_of_point(s, points[i]), plane, gap, end, first, h)
            for i in range(body.first_rim, body.first_rim + body.rims):
                gap, end = gaps[round_edges + i], later[round_edges + i]
                if end < -ENTERS - (bent if gap <= CLOSED else 0.0):
                    first = _meets(s, lowest_lever(s, rims[i], plane), plane, gap, end, first, h)
    between = gaps.shape[0] - pairs.shape[0]
    for k in range(between, gaps.shape[0]):
        a, b = pairs[k - between].a, pairs[k - between].b
        bent = sag(bodies[a], poses[a], h) + sag(bodies[b], poses[b], h)
        if later[k] < -ENTERS_BODIES - (bent if gaps[k] <= CLOSED_BETWEEN else 0.0):
            start = max(gaps[k], 0.0)
            first = min(first, h * start / (start - later[k]))
    return first
