"""A step of the engine in space, and two halves of it from which it is extrapolated.

A step of length h is symmetric (Strang): bodies drift freely for h/2, get gravity, the floor's acceleration
and the impulses of all contacts that are closed there, and drift for h/2 again. While contacts and devices
do not change its error is c h³ and that of its halves c h³/4, so that 4/3 of the halves less 1/3 of the whole
is of the fifth order (Richardson); their difference tells whether it may be as long as it is.
"""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.space.body import attitude, drift, place_of, set_attitude, stop, velocity
from stayput.mechanics.space.closing import OPEN, find_contacts, keep
from stayput.mechanics.space.contact import turn, turns_back
from stayput.mechanics.space.devices import give, hold, note_forces, stretch
from stayput.mechanics.space.events import changes, changes_at, gives_way, note_pressing
from stayput.mechanics.space.impact import bounces, land, mend
from stayput.mechanics.space.solve import IMPACT, any_closes_fast, apply, has_slipped, slide, solve
from stayput.mechanics.space.vectors import added, norm, scaled

MOST_ROUNDS = 8
"""Rounds of devices and contacts in a step: their dampers feel what the contacts do."""

RESTS = 4e-5
"""Acceleration from rest up to which a body rests on, exactly [m/s²]."""

CHANGED, RUBS = -1.0, -2.0
"""In place of the difference of a step and its halves: what happens within it."""

HARMLESS = 0.2
"""Share of the difference that is allowed up to which that makes none."""

LASTS = 0.01
"""Time for which a difference of velocities is taken to last, beside one of places [s]."""


@inline
def push_at(a0, a1, part, gravity):
    """Return the acceleration that acts on bodies at a part of the way between samples of the floor's."""
    a = added(a0, part, added(a1, -1.0, a0))
    return -a[0], -a[1], -a[2] - gravity


@inline
def mean_push(acceleration, k, t, h, dt, gravity):
    """Return the mean of what acts in a step of length h at the time t after sample k of the floor's motion.

    It is within the time between two samples, or as long as that between three.
    """
    if h <= dt:
        return push_at(acceleration[k], acceleration[k + 1], (t + 0.5 * h) / dt, gravity)
    first = push_at(acceleration[k], acceleration[k + 1], 0.5, gravity)
    return scaled(0.5, added(first, 1.0, push_at(acceleration[k + 1], acceleration[k + 2], 0.5, gravity)))


@inline
def moves(s):
    """Return whether a body moves."""
    return s.vx != 0.0 or s.vy != 0.0 or s.vz != 0.0 or s.lx != 0.0 or s.ly != 0.0 or s.lz != 0.0


@inline
def _speed(body, s):
    """Return a bound of the speed of a body: of G, and of a turn about it at its radius of gyration."""
    gyration = math.sqrt((body.i1 + body.i2 + body.i3) / (2.0 * body.mass))
    return math.sqrt(s.vx * s.vx + s.vy * s.vy + s.vz * s.vz) + gyration * math.sqrt(
        s.wx * s.wx + s.wy * s.wy + s.wz * s.wz
    )


@inner
def fastest(bodies, poses):
    """Return a bound of the speeds of all bodies."""
    speed = 0.0
    for b in range(bodies.shape[0]):
        speed = max(speed, _speed(bodies[b], poses[b]))
    return speed


@inner
def _impact(contacts, count, kept, ratio, h):
    """Return when within a step the first contact hits that was open before, by its gap in mid-step.

    Before the first step, whose ``ratio`` is 0, all that does not close counts as closed, so that it sticks.
    """
    first = h
    for c in contacts[:count]:
        if c.closing < -IMPACT and (kept[c.key, 3] == OPEN or ratio == 0.0):
            first = min(first, 0.5 * h - c.gap / c.closing)
    return first


@inner
def step(world, held, before, after, push, h, shortest, scratch, kept, ratio, work):
    """Step from ``before`` to ``after``.

    ``push`` is the acceleration that acts on all bodies: gravity, and against that of the floor. Impulses
    begin with those ``kept`` times ``ratio``.

    Returns
    -------
    tuple
        The number of contacts, and when in the step the first hits that was open before. Where that is before
        its end, and it is not the ``shortest``, nothing is solved. At last when the first on the floor stood
        that turns back, with a static friction above its kinetic one.
    """
    bodies, contacts, system = world[0], scratch[0], scratch[7]
    springs, pulls, _ = held
    for b in range(bodies.shape[0]):
        after[b] = before[b]
        if moves(after[b]):
            drift(bodies[b], after[b], 0.5 * h)
    count = find_contacts(world, after, push, scratch, kept, ratio, h)
    meets = _impact(contacts, count, kept, ratio, h)
    if meets < h and h > shortest:
        return count, meets, h
    if not any_closes_fast(contacts, count):
        slide(contacts, count, after, h)
    stretch(springs, pulls, after)
    for s in after:
        s.vx += h * push[0]
        s.vy += h * push[1]
        s.vz += h * push[2]
    work[0] += 1.0
    apply(contacts, count, bodies, after, 1.0)
    for c in contacts[:count]:
        if c.pr != 0.0:
            turn(c, bodies, after, c.pr)
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
    stands = 1.0
    for c in contacts[:count]:
        # one that bears nothing has not slipped either where it does not move: the next step may press it
        c.stuck = 0 if has_slipped(c, after, h) else 1
        c.stood = 1 if c.stuck == 1 and kept[c.key, 3] == 0.0 else 0
        c.when = changes_at(c, kept, ratio, before, after)
        if c.stuck == 0 and c.pn > 0.0 and turns_back(c, before, after):
            c.stuck = c.stood = 1
            if c.floor and c.mu_static > c.mu_kinetic:
                stands = min(stands, c.when)
    for b in range(bodies.shape[0]):
        s = after[b]
        if _speed(bodies[b], s) <= RESTS * h:
            if not moves(before[b]):
                after[b] = before[b]
            stop(s)
        else:
            drift(bodies[b], s, 0.5 * h)
    return count, meets, stands * h


@inner
def _rub_alike(kept, other):
    """Return whether the same of the contacts stick that are closed in both."""
    for key in range(kept.shape[0]):
        if changes(kept, other, key):
            return False
    return True


@inner
def _bear_alike(kept, other):
    """Return whether the same contacts are closed and bear something."""
    for key in range(kept.shape[0]):
        if (kept[key, 3] == OPEN) != (other[key, 3] == OPEN) or (kept[key, 0] > 0.0) != (other[key, 0] > 0.0):
            return False
    return True


@inner
def _extrapolate(bodies, poses, third):
    """Extrapolate from a step (row 1) and its halves (row 3), into row 1; return by how much they differ.

    Its place is the halves' and a part of that difference: −1/3, or 0 where it is not of third order.

    Returns
    -------
    float
        The largest difference of a body's points [m], with what that of velocities adds.
    """
    largest = 0.0
    for b in range(bodies.shape[0]):
        body, whole, halves = bodies[b], poses[1, b], poses[3, b]
        d = added(place_of(whole), -1.0, place_of(halves))
        v = added(velocity(whole), -1.0, velocity(halves))
        w = whole.wx - halves.wx, whole.wy - halves.wy, whole.wz - halves.wz
        q, r = attitude(whole), attitude(halves)
        q = q[0] - r[0], q[1] - r[1], q[2] - r[2], q[3] - r[3]
        turn = 2.0 * math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
        largest = max(largest, norm(d) + body.radius * turn + LASTS * (norm(v) + body.radius * norm(w)))
        if not moves(halves):
            poses[1, b] = poses[3, b]
            continue
        whole.x, whole.y, whole.z = added(place_of(halves), third, d)
        whole.vx, whole.vy, whole.vz = added(velocity(halves), third, v)
        momentum = halves.lx, halves.ly, halves.lz
        more = added((whole.lx, whole.ly, whole.lz), -1.0, momentum)
        whole.lx, whole.ly, whole.lz = added(momentum, third, more)
        q = r[0] + third * q[0], r[1] + third * q[1], r[2] + third * q[2], r[3] + third * q[3]
        set_attitude(body, whole, q)
    return largest


@inner
def _note_switches(kept, half):
    """Note in row 1 of what is kept which contacts begin or end to slip in a half, and when in the whole."""
    for key in range(kept.shape[1]):
        if changes(kept[1], kept[2], key):
            kept[1, key, 3], kept[1, key, 4] = kept[2, key, 3], 0.5 * (half + kept[2, key, 4])


@inner
def refine(world, held, poses, acceleration, k, dt, t, h, gravity, scratch, ratio, allowed, output):
    """Extrapolate a step from row 0 of the poses to row 1, by two halves, to row 2 and to row 3.

    It begins at the time t after sample k of the floor's acceleration. Its contacts are in row 1 of those
    kept, and those of its end will be in row 2. Devices give way as they do in the halves.

    Returns
    -------
    tuple
        The difference of the step and its halves [m]; `CHANGED` where contacts do or a device is lost, `RUBS`
        where some begin or end to slip, which then is in row 1 of those kept. Where devices hold a body and
        the difference is far below the one that is ``allowed``, the halves are taken in these cases too. At
        last the number of contacts in the second.
    """
    contacts, kept, work = scratch[0], scratch[1], output[5]
    springs, pulls, devices = held
    status, count = (0.0 if _rub_alike(kept[0], kept[1]) else RUBS), 0
    for half in range(2):
        if status < 0.0 and springs.shape[0] == 0:
            return status, count
        second = half if h > dt else 0  # whether it is in the time after the next sample
        push = mean_push(acceleration, k + second, t + 0.5 * half * h - second * dt, 0.5 * h, dt, gravity)
        before, factor = kept[2 * half], 0.5 * ratio if half == 0 else 1.0
        count, meets, _ = step(
            world, held, poses[2 * half], poses[2 + half], push, 0.5 * h, 0.0, scratch, before, factor, work
        )
        if meets < 0.5 * h:
            return min(status, CHANGED), count
        keep(contacts, count, kept[2], scratch[7][3])
        if give(springs, pulls, devices, poses[2 + half], dt * k + t + 0.5 * (1 + half) * h):
            return min(status, CHANGED), count
        if h > dt and half == 0:
            note_pressing(output[0], k + 1, contacts, count, 0.5 * h)
            note_forces(pulls, output[1][k + 1])
        if status == 0.0 and not _rub_alike(kept[1], kept[2]):
            _note_switches(kept, half)
            status = RUBS
        if status == 0.0 and not _bear_alike(kept[1], kept[2]):
            status = CHANGED
    if status == 0.0 and gives_way(contacts, count, kept, h > dt):
        return (CHANGED if h > dt else RUBS), count
    if status == 0.0:
        return _extrapolate(world[0], poses, -1.0 / 3.0), count
    error = _extrapolate(world[0], poses, 0.0) if springs.shape[0] > 0 else math.inf
    return (error if error <= HARMLESS * allowed else status), count
