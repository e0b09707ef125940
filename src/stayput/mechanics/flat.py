"""Rest and flat sliding: the modes without rotation, in closed form."""

import math

from stayput.compiling import entry, inner
from stayput.mechanics.columns import A_FLOOR, B_FLOOR, CLOSED, CONTACTS, ENDED, LIMIT, PLANE
from stayput.mechanics.contact import base_friction, cross, is_single_ray
from stayput.mechanics.devices.elements import note_forces_of_links, range_within_facets, time_within_facets
from stayput.mechanics.geometry import STICK_RATE, arm, gap, own_friction, to_plane_axes, value_or
from stayput.mechanics.records import advance_clock, loads, lowest_product, record_sample
from stayput.mechanics.roots import first_closing

BLOCK = 16
"""Samples per block of load extremes, by which rest is skipped."""


MIN_SLIP_TIME = 1e-8
"""Shortest slip [s]: the mode was chosen at `modes.LOOKAHEAD`, so a slip that starts now may still seem to
stop.
"""


@entry
def block_extremes(values, low, high):
    """Smallest and largest value over each block of the record's segments."""
    n = values.shape[0]
    for block in range(low.shape[0]):
        smallest = largest = values[block * BLOCK]
        for k in range(block * BLOCK + 1, min(n, (block + 1) * BLOCK + 1)):
            smallest, largest = min(smallest, values[k]), max(largest, values[k])
        low[block], high[block] = smallest, largest


@inner
def _stays_at_rest(case, held, s, extremes, block):
    """Whether the body stays at rest throughout a block of the record, by the extremes of its loads."""
    a_low, a_high, z_low, z_high = extremes
    k = case.scale
    a0, a1, z0, z1 = k * a_low[block], k * a_high[block], k * z_low[block], k * z_high[block]
    if k < 0.0:
        a0, a1, z0, z1 = a1, a0, z1, z0
    z0, z1 = case.gravity + z0, case.gravity + z1
    if held is not None:
        return range_within_facets(held.work, a0, a1, z0, z1)
    if (
        is_single_ray(s.low, s.low_up, s.high, s.high_up)
        and lowest_product(s.low, a0, a1) + lowest_product(s.low_up, z0, z1) < 0.0
    ):
        return False
    return (
        lowest_product(s.low_up, a0, a1) + lowest_product(-s.low, z0, z1) >= 0.0
        and lowest_product(-s.high_up, a0, a1) + lowest_product(s.high, z0, z1) >= 0.0
    )


@inner
def _time_until_positive(f0, f1, h):
    """Time in a step at which a linear function becomes positive, or h."""
    if f1 <= 0.0:
        return h
    if f0 >= 0.0:
        return 0.0
    return min(h, h * f0 / (f0 - f1))


@inner
def _time_in_cone(s, a0, G0, a1, G1, h):
    """Time in a step, with these loads at its ends, at which the load leaves the state's cone, or h."""
    return min(
        _time_until_positive(-cross(a0, G0, s.low, s.low_up), -cross(a1, G1, s.low, s.low_up), h),
        _time_until_positive(-cross(s.high, s.high_up, a0, G0), -cross(s.high, s.high_up, a1, G1), h),
    )


@inner
def _time_at_rest(held, s, a0, G0, a1, G1, h):
    """Time in a step, with these loads at its ends, at which rest ends, or h."""
    if held is not None:
        return time_within_facets(held.work, a0, G0, a1, G1, h)
    t = _time_in_cone(s, a0, G0, a1, G1, h)
    if is_single_ray(s.low, s.low_up, s.high, s.high_up):
        along0, along1 = a0 * s.low + G0 * s.low_up, a1 * s.low + G1 * s.low_up
        t = min(t, _time_until_positive(-along0, -along1, h))
    return t


@inner
def advance_rest(case, held, s, motion, output):
    """Advance a body at rest, exactly unmoved, until the contacts can no longer balance the load."""
    ax, az, dt, history = motion.ax, motion.az, motion.dt, output.history
    last = ax.shape[0] - 1
    per_second = case.scale / dt
    keeps = history.shape[0] > 0
    while s.k < last:
        at_block = s.tau == 0.0 and s.k % BLOCK == 0 and not keeps
        if at_block and _stays_at_rest(case, held, s, motion.extremes, s.k // BLOCK):
            s.k = min(last, s.k + BLOCK)
            continue
        h = dt - s.tau
        a0, _, G0, _ = loads(case, ax, az, per_second, s.k, s.tau)
        a1, G1 = case.scale * ax[s.k + 1], case.gravity + case.scale * az[s.k + 1]
        t = _time_at_rest(held, s, a0, G0, a1, G1, h)
        if t < h:
            s.tau += t
            return LIMIT
        s.k += 1
        s.tau = 0.0
        record_sample(history, case, s)
        if held is not None:
            note_forces_of_links(output.forces, held.links, s)
    return ENDED


@inner
def _first_stop(v, p, p_rate, h):
    """First time in (0, h] at which v − pτ − p'τ²/2, positive or just starting, comes to zero; −1 if not."""
    if v == 0.0:  # divide out a start at zero
        if p_rate != 0.0:
            t = -2.0 * p / p_rate
            if MIN_SLIP_TIME < t <= h:
                return t
        return -1.0
    if p_rate == 0.0:
        t = v / p if p > 0.0 else -1.0
        return t if t <= h else -1.0
    disc = p * p + 2.0 * p_rate * v
    if disc < 0.0:
        return -1.0
    root = math.sqrt(disc)
    # v = pτ + p'τ²/2: the two roots, free of cancellation
    q = -(p + math.copysign(root, p))
    t1, t2 = q / p_rate, -2.0 * v / q if q != 0.0 else math.inf
    first = math.inf
    if t1 > 0.0:
        first = t1
    if 0.0 < t2 < first:
        first = t2
    return first if first <= h else -1.0


@inner
def advance_slide(contacts, case, s, motion, friction, lifts, history):
    """Advance a body that slides flat with the coefficient ``friction`` to its next event."""
    ax, az, dt = motion.ax, motion.az, motion.dt
    con = contacts[s.i]
    cf, sf = con.cos, con.sin
    d = float(s.d)
    others = s.present & ~(0b11 << 2 * PLANE[s.i])
    last = ax.shape[0] - 1
    per_second = case.scale / dt
    while s.k < last:
        a, a_rate, G, G_rate = loads(case, ax, az, per_second, s.k, s.tau)
        N, N_rate = cf * G - sf * a, cf * G_rate - sf * a_rate
        drive = d * (cf * a + sf * G) + friction * N  # deceleration in the direction of slip
        drive_rate = d * (cf * a_rate + sf * G_rate) + friction * N_rate
        h = dt - s.tau
        v = d * to_plane_axes(con, s.vx, s.vz)[0]
        if abs(v) <= STICK_RATE:
            v = 0.0
        outcome = ENDED
        t = _first_stop(v, drive, drive_rate, h)
        if t >= 0.0:
            h, outcome = t, LIMIT
        if lifts and N + N_rate * h < 0.0:
            t = _time_until_positive(-N, -N - N_rate * h, h)
            if t < h or outcome == ENDED:
                h, outcome = t, LIMIT
        if not lifts:  # the paper's body rocks where the load is beyond (b/h)g, sliding or not
            t = _time_in_cone(s, a, G, a + a_rate * h, G + G_rate * h, h)
            if t < h:
                h, outcome = t, LIMIT
        for c in range(CONTACTS):
            side = d * to_plane_axes(contacts[c], cf, sf)[1]  # + where the slip opens the gap
            if others >> c & 1 and side != 0.0:
                g0 = gap(contacts[c], s)
                g1 = g0 + side * h * (v - h * (drive / 2.0 + h * drive_rate / 6.0))
                v1, a1 = v - h * (drive + 0.5 * h * drive_rate), drive + h * drive_rate
                t, level = first_closing(g0, side * v, -side * drive, g1, side * v1, -side * a1, h)
                if t >= 0.0:
                    rate = side * (v - t * (drive + 0.5 * t * drive_rate))
                    left = g0 - level + side * t * (v - t * (drive / 2.0 + t * drive_rate / 6.0))
                    if rate < 0.0:  # one Newton step on the exact motion; first_closing uses its quintic
                        t = min(h, max(0.5 * t, t - left / rate))
                    h, outcome, s.hit = t, CLOSED, 1 << c
        shift = d * h * (v - h * (drive / 2.0 + h * drive_rate / 6.0))
        speed = d * (v - h * (drive + 0.5 * h * drive_rate))
        s.x, s.z = s.x + cf * shift, s.z + sf * shift
        s.vx, s.vz = cf * speed, sf * speed
        if outcome == LIMIT and abs(speed) < 1e-10:
            s.vx = s.vz = 0.0
        s.steps += 1
        if advance_clock(s, h, dt):
            record_sample(history, case, s)
        if outcome != ENDED:
            return outcome
    return ENDED


@inner
def load_weighted_friction(contacts, s, left, right, d):
    """Kinetic coefficient of a flat base slipping to side d: the mean of its corners', weighted by load.

    A corner's share of the load is proportional to the other's lever arm about G, friction included. A corner
    that friction would lift carries none: under the paper's rules a body that would tip goes on sliding flat.
    """
    if left == right:
        return left
    sigma, kappa = arm(contacts[B_FLOOR], s)
    on_left = max(0.0, sigma - d * right * kappa)
    on_right = max(0.0, d * left * kappa - arm(contacts[A_FLOOR], s)[0])
    return (left * on_left + right * on_right) / (on_left + on_right)


@inner
def slide_friction(contacts, case, s):
    """Kinetic coefficient of a body that slides flat; on the floor, weighted by the corners' loads."""
    con = contacts[s.i]
    if PLANE[s.i] > 0:
        return con.mu_kinetic
    leading = contacts[B_FLOOR if s.d > 0 else A_FLOOR]
    sigma, kappa = arm(leading, s)
    base = base_friction(case, leading.mu_kinetic, abs(sigma), kappa)
    left, right = (
        value_or(own_friction(case, A_FLOOR)[1], base),
        value_or(own_friction(case, B_FLOOR)[1], base),
    )
    return load_weighted_friction(contacts, s, left, right, float(s.d))
