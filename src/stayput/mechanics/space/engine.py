"""The engine in space: steps between samples of the floor's motion, shortened where bodies meet.

A step of length h is symmetric (Strang): bodies drift freely for h/2, get gravity, the floor's acceleration
and the impulses of all contacts that are closed there, and drift for h/2 again. Between impacts it is of
second order; free flight keeps energy and momentum. A step in which a body would enter or hit another is
shortened to where they meet, and the impact has a step of its own, the shortest: in a longer one it would be
solved with velocities that lack what half of that step brings. What a body has entered (`ENTERS`) is moved
out without a change of velocity.

Axes move with the floor: its acceleration acts on bodies against its direction.
"""

from __future__ import annotations

import math
from typing import Any

from stayput.compiling import entry, inline, inner
from stayput.mechanics.space.body import (
    angular_response,
    attitude,
    copy_pose,
    drift,
    in_room,
    nudge,
    place_of,
    sag,
    set_attitude,
    stop,
    velocity,
)
from stayput.mechanics.space.closing import (
    CLOSED,
    ENTERS_BODIES,
    OPEN,
    find_contacts,
    keep,
    note_all_gaps,
)
from stayput.mechanics.space.contact import mobility, turns_back, velocity_at
from stayput.mechanics.space.devices import give, hold, note_forces, note_loads, stretch
from stayput.mechanics.space.impact import bounces, mend
from stayput.mechanics.space.landing import land
from stayput.mechanics.space.notes import note_hits, note_pose, note_pressing, note_weight
from stayput.mechanics.space.pairs import place_corners, touch
from stayput.mechanics.space.rest import note_stances, stays_at_rest
from stayput.mechanics.space.solve import IMPACT, apply, has_slipped, slide, solve
from stayput.mechanics.space.touching import (
    ENTERS,
    RIM_ENTERS,
    gap_of,
    lever_of_point,
    lowest_lever,
    may_touch,
    plane_normal,
)
from stayput.mechanics.space.vectors import added, cross, dot, norm

IGNORED = 1e-12
"""Depth up to which a body that has entered another stays [m]: rounding."""

SHORTEST, SHORTEST_OF_SEVERAL = 1e-7, 1e-6
"""Shortest step to where corners of a body alone meet planes; and to where rims or bodies do, which meet more
often: a rim that rolls and rebounds hits without end [s].
"""

SHORT_STEPS = 8
"""Shortest steps in a row after which they are twice as long: bodies meet that do not come apart."""

DEEP = 1e-5
"""Depth from which on they are made shorter again [m]."""

MOST_ROUNDS = 8
"""Rounds of devices and contacts in a step: their dampers feel what the contacts do."""

MOST_UNCONVERGED, FEW = 0.02, 1000
"""Share of steps whose impulses did not converge from which on a run is given up (its forces are rough), and
number of them from which on it ends at once.
"""

PAUSE = 4
TOLERANCE = 5e-3
MUCH = 10.0
SLOW = 0.01
ROLLS = 50.0

RESTS = 4e-5
"""Acceleration from rest up to which a body rests on, exactly [m/s²]."""


@inner
def _nudge_along(body, s, lever, n, size):
    turn = angular_response(s, cross(lever, n))
    by = size / body.mass
    nudge(body, s, (by * n[0], by * n[1], by * n[2]), (size * turn[0], size * turn[1], size * turn[2]))


@inner
def _move_out(body, s, lever, plane):
    """Move a body out of a plane that it has entered at a point, as an impulse would."""
    gap = gap_of(s, lever, plane)
    if gap < 0.0:
        n = plane_normal(plane)
        _nudge_along(body, s, lever, n, -gap / mobility(body, s, lever, n))


@inner
def _move_all_out(world, poses, scratch):
    """Move bodies out of each other and of planes that they have entered."""
    bodies, points, rims, planes, pairs, faces, loops, edges = world
    corners, polygons, touching, axes = scratch[3], scratch[4], scratch[5], scratch[8]
    place_corners(bodies, poses, points, corners)
    for j in range(pairs.shape[0]):
        a, b = pairs[j].a, pairs[j].b
        body, other, s, r = bodies[a], bodies[b], poses[a], poses[b]
        _, found, n = touch(body, s, other, r, 0.0, axes[j], faces, loops, edges, corners, polygons, touching)
        for m in range(found):
            if touching[m, 3] < 0.0:
                place = touching[m, 0], touching[m, 1], touching[m, 2]
                lever, arm = added(place, -1.0, place_of(s)), added(place, -1.0, place_of(r))
                both = mobility(body, s, lever, n) + mobility(other, r, arm, n)
                size = -touching[m, 3] / both / found  # each of them moves all of a face
                _nudge_along(body, s, lever, n, size)
                _nudge_along(other, r, arm, n, -size)
        if found:
            place_corners(bodies[a : a + 1], poses[a : a + 1], points, corners)
            place_corners(bodies[b : b + 1], poses[b : b + 1], points, corners)
    for b in range(bodies.shape[0]):
        body, s = bodies[b], poses[b]
        for j in range(planes.shape[0]):
            plane = planes[j]
            for i in range(body.first_point, body.first_point + body.points):
                if may_touch(points[i], plane):
                    _move_out(body, s, lever_of_point(s, points[i]), plane)
            for i in range(body.first_rim, body.first_rim + body.rims):
                if may_touch(rims[i], plane):
                    _move_out(body, s, lowest_lever(s, rims[i], plane), plane)


@inline
def _moves(s):
    return s.vx != 0.0 or s.vy != 0.0 or s.vz != 0.0 or s.lx != 0.0 or s.ly != 0.0 or s.lz != 0.0


@inline
def _speed(body, s):
    """Return a bound of the speed of a body: of G, and of a turn about it at its radius of gyration."""
    gyration = math.sqrt((body.i1 + body.i2 + body.i3) / (2.0 * body.mass))
    return math.sqrt(s.vx * s.vx + s.vy * s.vy + s.vz * s.vz) + gyration * math.sqrt(
        s.wx * s.wx + s.wy * s.wy + s.wz * s.wz
    )


@inner
def _impact(contacts, count, kept, h):
    """Return when within a step the first contact hits that was open before, by its gap in mid-step."""
    first = h
    for k in range(count):
        c = contacts[k]
        if c.closing < -IMPACT and kept[c.key, 3] == OPEN:
            first = min(first, 0.5 * h - c.gap / c.closing)
    return first


@inner
def _any_closes_fast(contacts, count):
    for k in range(count):
        if contacts[k].closing < -IMPACT:
            return True
    return False


@inner
def _step(world, held, before, after, push, h, shortest, scratch, kept, ratio, work):
    """Step from ``before`` to ``after``; return the number of contacts.

    ``push`` is the acceleration that acts on all bodies: gravity, and against that of the floor.
    """
    bodies, contacts, system = world[0], scratch[0], scratch[7]
    springs, pulls, _ = held
    for b in range(bodies.shape[0]):
        copy_pose(before[b], after[b])
        if _moves(after[b]):
            drift(bodies[b], after[b], 0.5 * h)
    count = find_contacts(world, after, push, scratch, kept, ratio, h)
    meets = _impact(contacts, count, kept, h)
    if meets < h and h > shortest:
        return count, meets
    if not _any_closes_fast(contacts, count):
        slide(contacts, count, after, h)
    stretch(springs, pulls, after)
    for b in range(bodies.shape[0]):
        s = after[b]
        s.vx += h * push[0]
        s.vy += h * push[1]
        s.vz += h * push[2]
    work[0] += 1.0
    apply(contacts, count, bodies, after, 1.0)
    hold(springs, pulls, bodies, after, h)
    alone = count == 0 and springs.shape[0] == 0
    converged = alone or solve(contacts, count, held, bodies, after, system, h, work)
    settled = alone
    for _ in range(MOST_ROUNDS):
        settled = not hold(springs, pulls, bodies, after, h)
        if settled:
            break
        converged = solve(contacts, count, held, bodies, after, system, h, work)
    if bounces(contacts, count):
        none = springs[:0], pulls[:0], held[2][:0]
        converged = mend(contacts, count, none, bodies, after, system, h, work) and converged
    if not (converged and settled):
        work[1] += 1.0
    land(contacts, count, bodies, before, after)
    for k in range(count):
        c = contacts[k]
        c.stuck = 0
        # one that bears nothing has not slipped either where it does not move: the next step may press it
        if not has_slipped(c, after, h) or (c.pn > 0.0 and turns_back(c, before, after)):
            c.stuck = 1
    for b in range(bodies.shape[0]):
        s = after[b]
        if _speed(bodies[b], s) <= RESTS * h:
            if not _moves(before[b]):
                copy_pose(before[b], s)
            stop(s)
        else:
            drift(bodies[b], s, 0.5 * h)
    return count, meets


@inner
def _same_contacts(kept, other):
    """Return whether the same contacts are closed, and the same of them stick."""
    for key in range(kept.shape[0]):
        if kept[key, 3] != other[key, 3]:
            return False
    return True


@inner
def _rub_alike(kept, other):
    """Return whether the same of the contacts stick that are closed in both."""
    for key in range(kept.shape[0]):
        if kept[key, 3] + other[key, 3] == 1.0:
            return False
    return True


@inner
def _bear_alike(kept, other):
    """Return whether the same contacts bear something."""
    for key in range(kept.shape[0]):
        if (kept[key, 0] > 0.0) != (other[key, 0] > 0.0):
            return False
    return True


@inner
def _extrapolate(bodies, poses):
    """Extrapolate from a step (row 1) and its halves (row 3) to none, into row 1; return their difference.

    A symmetric step leaves an error of its length cubed, so that the halves are off by a third of the
    difference; what is left is of the fifth order.

    Returns
    -------
    float
        The largest way [m] by which a body's points differ, with what velocities add in a time √(R/g).
    """
    found = 0.0
    for b in range(bodies.shape[0]):
        body, coarse, fine = bodies[b], poses[1, b], poses[3, b]
        d = coarse.x - fine.x, coarse.y - fine.y, coarse.z - fine.z
        v = coarse.vx - fine.vx, coarse.vy - fine.vy, coarse.vz - fine.vz
        w = coarse.wx - fine.wx, coarse.wy - fine.wy, coarse.wz - fine.wz
        q, r = attitude(coarse), attitude(fine)
        q = q[0] - r[0], q[1] - r[1], q[2] - r[2], q[3] - r[3]
        turn = 2.0 * math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
        error = norm(d) + body.radius * turn + SLOW * (norm(v) + body.radius * norm(w))
        found = max(found, error * (ROLLS if body.rims > 0 else 1.0))
        third = 1.0 / 3.0
        coarse.x, coarse.y, coarse.z = added(place_of(fine), -third, d)
        coarse.vx, coarse.vy, coarse.vz = added(velocity(fine), -third, v)
        l = coarse.lx - fine.lx, coarse.ly - fine.ly, coarse.lz - fine.lz
        coarse.lx, coarse.ly, coarse.lz = added((fine.lx, fine.ly, fine.lz), -third, l)
        q = r[0] - third * q[0], r[1] - third * q[1], r[2] - third * q[2], r[3] - third * q[3]
        if _moves(fine):
            set_attitude(body, coarse, q)
        else:
            copy_pose(fine, coarse)
    return found


@inner
def _refine(world, held, poses, a0, a1, t, h, dt, start, gravity, scratch, ratio, work):
    """Replace a step (row 1 of poses) by what it and its halves, with row 2 in between, leave at length 0.

    Returns
    -------
    float
        The difference of the step and its halves; −1 where contacts or devices changed.
    """
    contacts, kept = scratch[0], scratch[1]
    springs, pulls, devices = held
    for half in range(2):
        f = (t + (0.25 + 0.5 * half) * h) / dt
        push = _push(added(a0, f, added(a1, -1.0, a0)), gravity)
        count, meets = _step(
            world, held, poses[2 * half], poses[2 + half], push, 0.5 * h, 0.0, scratch,
            kept[2 * half], 0.5 * ratio if half == 0 else 1.0, work,
        )  # fmt: skip
        if meets < 0.5 * h:
            return -1.0
        keep(contacts, count, kept[2], scratch[7][3])
        lost = give(springs, pulls, devices, poses[2 + half], start + t + (0.5 + 0.5 * half) * h)
        if lost or not (_same_contacts(kept[1], kept[2]) and _bear_alike(kept[1], kept[2])):
            return -1.0
    return _extrapolate(world[0], poses)


@inner
def _sag(bodies, poses, h):
    """Return how far the path of a body's point bends in a step, at most, seen from another body."""
    found = 0.0
    for b in range(bodies.shape[0]):
        found = max(found, sag(bodies[b], poses[b], h))
    return found if bodies.shape[0] == 1 else 2.0 * found


@inline
def _meets(s, lever, plane, gap, later, deepest, first, h):
    """Return when within a step a point meets a plane that it enters, or ``first`` where that is earlier.

    By Newton's method from the end of the step, and not before where a straight line meets it.
    """
    if later >= deepest:
        return first
    start = max(gap, 0.0)
    meets = h * start / (start - later)
    rate = dot(plane_normal(plane), velocity_at(s, lever))
    return min(first, max(meets, h - later / rate)) if rate < 0.0 else min(first, meets)


@inner
def _meeting(world, poses, gaps, later, bent, h):
    """Return when within a step, with ``poses`` at its end, bodies first meet planes or each other.

    The gaps are those of points and rims, plane by plane, and at last those of pairs of bodies. What touches
    at first may go deeper by ``bent``.
    """
    bodies, points, rims, planes, pairs = world[0], world[1], world[2], world[3], world[4]
    first = h
    for j in range(planes.shape[0]):
        plane, before = planes[j], j * (points.shape[0] + rims.shape[0])
        for b in range(bodies.shape[0]):
            body, s = bodies[b], poses[b]
            for i in range(body.first_point, body.first_point + body.points):
                gap, end = gaps[before + i], later[before + i]
                deepest = -ENTERS - (bent if gap < bent else 0.0)
                if end < deepest:
                    first = _meets(s, lever_of_point(s, points[i]), plane, gap, end, deepest, first, h)
            for i in range(body.first_rim, body.first_rim + body.rims):
                gap, end = gaps[before + points.shape[0] + i], later[before + points.shape[0] + i]
                deepest = -RIM_ENTERS - (bent if gap < bent else 0.0)
                if end < deepest:
                    first = _meets(s, lowest_lever(s, rims[i], plane), plane, gap, end, deepest, first, h)
    between = gaps.shape[0] - pairs.shape[0]
    for k in range(between, gaps.shape[0]):
        if later[k] < -ENTERS_BODIES - (bent if gaps[k] < bent else 0.0):
            start = max(gaps[k], 0.0)
            first = min(first, h * start / (start - later[k]))
    return first


@inline
def note_peaks(bodies, poses, peaks):
    """Note the largest 1 − cos of the bodies' tilts."""
    for b in range(bodies.shape[0]):
        up = in_room(poses[b], (bodies[b].ux, bodies[b].uy, bodies[b].uz))
        peaks[b] = max(peaks[b], min(1.0 - up[2], 2.0))


@inline
def _at_rest(poses):
    for b in range(poses.shape[0]):
        if _moves(poses[b]):
            return False
    return True


@inline
def _push(a, gravity):
    """Return the acceleration that acts on bodies where the floor has the acceleration a."""
    return -a[0], -a[1], -a[2] - gravity


@entry
def run_in_space(
    world: Any,
    held: Any,
    poses: Any,
    acceleration: Any,
    numbers: Any,
    scratch: Any,
    output: Any,
) -> None:
    """Run bodies under a motion of the floor.

    Parameters
    ----------
    world : tuple
        What stands in the room, and the room: SOLID[n], POINT[p], RIM[r], PLANE[w], PAIR[m], FACE[f], corners
        of the faces int64[l], edges int64[e, 2].
    held : tuple
        What holds them: SPRING[d], PULL[d], DEVICE[d]; the last is the result, in newtons.
    poses : POSE[2, n]
        The initial poses in the first row, and the last at the end; the other is working memory.
    acceleration : float64[samples, 3]
        Of the floor [m/s²], linear between samples.
    numbers : float64[3]
        Time between samples [s], longest step [s], gravity [m/s²].
    scratch : tuple
        Working memory: CONTACT[c], impulses that are kept float64[keys, 4], gaps float64[2, features], places
        of the points float64[p, 3], polygons float64[2, corners, 4], points that touch float64[8, 5]; what
        bodies stand on: sides float64[p, 3], their numbers int64[n], circles float64[n, 3], least friction
        float64[n], forces and moments of devices float64[n, 6], middles and distances float64[n, 4]; Newton's
        method: Jacobians, and D times these, float64[c + d, 2, 6, 6], matrix float64[n, n, 6, 6], vector
        float64[n, 6], first bodies of rows int64[n]; the axes that separated pairs last int64[m, 2], −1 at
        first.
    output : tuple
        Histories at the samples float64[n, samples, 19]; forces of the devices there float64[samples, d, 2],
        along the normal, + where it pulls, and the plane; HIT[h], the first hits; numbers of hits by body and
        kind int64[n + 1, 3], in the last row of all hits; the largest 1 − cos of the bodies' tilts at any
        step float64[n]; steps, steps whose impulses did not converge, work in updates of a contact (some
        0.1 µs each), and the most of it, float64[4]: added to. Beyond it, and where too many steps do not
        converge, bodies stay where they are.
    """
    dt, longest, gravity = numbers[0], numbers[1], numbers[2]
    bodies, floor = world[0], world[3][0]
    contacts, kept, gaps = scratch[0], scratch[1], scratch[2]
    histories, forces, hits, hit_numbers, peaks, work = output
    now, trial = poses[0], poses[1]
    for b in range(bodies.shape[0]):
        set_attitude(bodies[b], now[b], attitude(now[b]))
    note_pose(histories, 0, now)
    note_all_gaps(world, now, scratch, gaps[0])
    parts = math.ceil(dt / longest * (1.0 - 1e-12))
    least_refined, most = 0.25 * longest, MUCH * longest
    size, rough = longest, 0
    event = least_event = longest / 4.0
    last, count = 0.0, 0
    alone = poses.shape[1] == 1 and world[2].shape[0] == 0
    least_step = SHORTEST if alone else SHORTEST_OF_SEVERAL
    short, shortest = 0, least_step
    noted = bears = False
    for k in range(acceleration.shape[0] - 1):
        a0, a1 = acceleration[k], acceleration[k + 1]
        # what preloaded devices bear at rest is known after a step
        if (last > 0.0 or held[0].shape[0] == 0) and _at_rest(now):
            if not noted:
                note_stances(world, now, CLOSED, scratch[6])
                note_loads(held[0], held[1], last, scratch[6][4])
                noted = True
            if stays_at_rest(bodies, now, floor, _push(a0, gravity), scratch[6]) and stays_at_rest(
                bodies, now, floor, _push(a1, gravity), scratch[6]
            ):
                note_pose(histories, k + 1, now)
                note_weight(histories, k + 1, bodies, _push(a1, gravity), scratch[6][4])
                note_forces(held[1], forces[k + 1])
                bears = False
                continue
            # what walls and other bodies help to bear is convex in the push too: steps at both samples tell
            h = dt / parts
            if not bears:
                ratio = h / last if last > 0.0 else 0.0
                count, meets = _step(
                    world, held, now, trial, _push(a0, gravity), h, h, scratch, kept[0], ratio, work
                )
                bears = _at_rest(trial)
                if bears:
                    keep(contacts, count, kept[0], scratch[7][3])
                    last = h
            if bears:
                count, meets = _step(
                    world, held, now, trial, _push(a1, gravity), h, h, scratch, kept[0], h / last, work
                )
                bears = _at_rest(trial)
            if bears:
                keep(contacts, count, kept[0], scratch[7][3])
                give(held[0], held[1], held[2], trial, dt * (k + 1))
                last = h
                note_pose(histories, k + 1, now)
                note_pressing(histories, k + 1, contacts, count, last)
                note_forces(held[1], forces[k + 1])
                continue
        noted = bears = False
        t = 0.0
        while t < dt:
            if work[2] > work[3] or work[1] > max(FEW, MOST_UNCONVERGED * work[0]):
                for b in range(bodies.shape[0]):
                    stop(now[b])
                for later in range(k + 1, histories.shape[1]):
                    note_pose(histories, later, now)
                return
            h = (dt - t) / math.ceil((dt - t) / size * (1.0 - 1e-12))
            refined = False
            while True:
                f = (t + 0.5 * h) / dt
                push = _push(added(a0, f, added(a1, -1.0, a0)), gravity)
                ratio = h / last if last > 0.0 else 0.0
                count, meets = _step(
                    world, held, now, trial, push, h, shortest, scratch, kept[0], ratio, work
                )
                if meets < h and h > shortest:
                    h = max(shortest, min(meets, h - shortest))
                    continue
                least, left = note_all_gaps(world, trial, scratch, gaps[1])
                bent = _sag(bodies, trial, h)
                if left < 0.0:
                    meets = min(meets, _meeting(world, trial, gaps[0], gaps[1], bent, h))
                if meets < h and h > shortest:
                    h = max(shortest, min(meets, h - shortest))
                    continue
                if (
                    rough > 0
                    or h < max(0.5 * least_event, 2.0 * shortest)
                    or _any_closes_fast(contacts, count)
                ):
                    if h > longest:
                        h = longest
                        continue
                    break
                keep(contacts, count, kept[1], scratch[7][3])
                error = -1.0
                if _rub_alike(kept[0], kept[1]):
                    for d in range(held[1].shape[0]):
                        scratch[9][d], scratch[10][d] = held[1][d], held[2][d]
                    error = _refine(
                        world, held, poses, a0, a1, t, h, dt, dt * k, gravity, scratch, ratio, work
                    )
                    if error < 0.0:
                        for d in range(held[1].shape[0]):
                            held[1][d], held[2][d] = scratch[9][d], scratch[10][d]
                refined = 0.0 <= error <= TOLERANCE * h or (error >= 0.0 and h <= 2.0 * least_refined)
                if refined:
                    least, left = note_all_gaps(world, trial, scratch, gaps[1])
                    meets = _meeting(world, trial, gaps[0], gaps[1], bent, h) if left < 0.0 else h
                    refined = meets == h
                if refined:
                    event = max(least_event, 0.5 * event)
                    grows = 0.8 * math.sqrt(TOLERANCE * h / max(error, 1e-15))
                    size = min(most, max(2.0 * least_refined, h * min(4.0, max(0.5, grows))))
                    work[4] += error
                    bent = 0.0
                    break
                if error >= 0.0:
                    for d in range(held[1].shape[0]):
                        held[1][d], held[2][d] = scratch[9][d], scratch[10][d]
                if meets < h:
                    h = max(shortest, min(meets, h - shortest))
                    continue
                if error < 0.0:
                    if h > event:
                        h = max(event, 0.5 * h)
                        continue
                    event = min(2.0 * event, longest)
                    if event == longest:
                        rough = PAUSE
                    count, meets = _step(
                        world, held, now, trial, push, h, shortest, scratch, kept[0], ratio, work
                    )
                    break
                h *= 0.25 if error > 16.0 * TOLERANCE * h else 0.5
            short = short + 1 if h <= shortest else 0
            if short == 0:
                shortest = least_step
            elif least < -DEEP:
                shortest = max(least_step, 0.5 * shortest)
            elif short % SHORT_STEPS == 0:
                shortest *= 2.0
            if least < -IGNORED - bent:
                _move_all_out(world, trial, scratch)
                note_all_gaps(world, trial, scratch, gaps[1])
            if refined:
                note_peaks(bodies, poses[2], peaks)
                for key in range(kept.shape[1]):
                    for i in range(4):
                        kept[0, key, i] = kept[2, key, i]
                last = 0.5 * h
            else:
                if h > least_step * 1.5:
                    rough = max(0, rough - 1)
                size = min(max(size, 2.0 * h), longest)
                note_hits(contacts, count, kept[0], dt * k + t + h, hits, hit_numbers)
                keep(contacts, count, kept[0], scratch[7][3])
                last = h
                give(held[0], held[1], held[2], trial, dt * k + t + h)
            for b in range(bodies.shape[0]):
                copy_pose(trial[b], now[b])
            note_peaks(bodies, now, peaks)
            for place in range(gaps.shape[1]):
                gaps[0, place] = gaps[1, place]
            t = dt if t + h >= dt - 1e-12 else t + h
        note_pose(histories, k + 1, now)
        note_pressing(histories, k + 1, contacts, count, last)
        note_forces(held[1], forces[k + 1])
