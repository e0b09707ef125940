"""Flight (no contact), and lean: sliding on two planes at once, such as floor and wall."""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.columns import CLOSED, CONTACTS, ENDED, TURNED_OVER
from stayput.mechanics.contact import slide_on_two_planes
from stayput.mechanics.elementary import sine_and_cosine
from stayput.mechanics.geometry import (
    RIGHT_ANGLE,
    gap,
    gap_rates,
    project_on_both,
    reason_of_end,
    slip_rate,
    state_of,
    turn_to,
    update_peaks,
)
from stayput.mechanics.records import advance_clock, loads, record_sample
from stayput.mechanics.roots import (
    MIN_START_VALUE,
    SLACK_FORCE,
    SLACK_SLIP,
    between,
    closed_level,
    first_closing,
    illinois_update,
    last_reversal,
    parabola_negative_at,
    quintics,
    secant,
)

MAX_ROTATION = 0.05
"""Largest rotation in a step of flight [rad]: the quintics of the gaps assume a small one."""

LOCATED = 1e-13
"""Tolerance to which the end of a lean is located [s]."""

MIN_STEP = 1e-6
"""Least step of a lean; it is accepted whatever its error [s]."""


@inline
def _flown(s, load, t):
    """State after a time t of free flight under linear loads, as of `state_of`, and sin θ and cos θ."""
    a, a_rate, G, G_rate = load
    theta = s.theta + t * s.omega
    sin, cos = sine_and_cosine(theta)
    x = s.x + t * (s.vx - t * (a / 2.0 + t * a_rate / 6.0))
    z = s.z + t * (s.vz - t * (G / 2.0 + t * G_rate / 6.0))
    y = x, z, theta, s.vx - t * (a + 0.5 * t * a_rate), s.vz - t * (G + 0.5 * t * G_rate), s.omega
    return y, sin, cos


@inline
def _slide_rate(case, corner, flown):
    """Horizontal velocity of a corner in flight [m/s]."""
    y, sin, cos = flown
    return y[3] + y[5] * (case.v[corner] * cos - case.u[corner] * sin)


@inner
def _turn_of_slide(case, s, load, h, start, end):
    """Time in a step of flight at which the slide reverses (its peak), or 0."""
    corner = 1 if s.theta > s.rest else 0
    rate0, rate1 = _slide_rate(case, corner, start), _slide_rate(case, corner, end)
    bend = -load[0] - s.omega * s.omega * (case.u[corner] * s.cos + case.v[corner] * s.sin)
    t, slope = last_reversal(rate0, bend, rate1, h)
    for _ in range(2):
        t = min(h, max(0.0, t - _slide_rate(case, corner, _flown(s, load, t)) / slope))
    return t


@inner
def _fly(s, load, t):
    """Advance the state by a time t of free flight."""
    y, s.sin, s.cos = _flown(s, load, t)
    s.x, s.z, s.theta, s.vx, s.vz, _ = y


@inline
def _flying_gap(con, load, t, flown):
    """Gap of a contact after a time t of flight, with its first and second derivatives."""
    y, sin, cos = flown
    return gap_rates(con, y, (-load[0] - t * load[1], -load[2] - t * load[3], 0.0), sin, cos)


@inner
def advance_flight(contacts, case, s, motion, history):
    """Advance a body in flight to where a contact closes or it overturns."""
    ax, az, dt = motion.ax, motion.az, motion.dt
    last = ax.shape[0] - 1
    per_second = case.scale / dt
    while s.k < last:
        load = loads(case, ax, az, per_second, s.k, s.tau)
        h = dt - s.tau
        if abs(s.omega) * h > MAX_ROTATION:
            h = MAX_ROTATION / abs(s.omega)
        outcome = ENDED
        if abs(s.theta + h * s.omega) >= RIGHT_ANGLE:
            h, outcome = (RIGHT_ANGLE - abs(s.theta)) / abs(s.omega), TURNED_OVER
        start, end = (state_of(s), s.sin, s.cos), _flown(s, load, h)
        for c in range(CONTACTS):
            if s.present >> c & 1:
                con = contacts[c]
                g0, v0, c0 = _flying_gap(con, load, 0.0, start)
                g1, v1, c1 = _flying_gap(con, load, h, end)
                t, level = first_closing(g0, v0, c0, g1, v1, c1, h)
                if t >= 0.0:
                    for _ in range(2):  # Newton steps on the exact motion; first_closing uses its quintic
                        g, v, _ = _flying_gap(con, load, t, _flown(s, load, t))
                        if v < 0.0:
                            t = min(h, max(0.5 * t, t - (g - level) / v))
                    h, outcome, s.hit = t, CLOSED, 1 << c
                    end = _flown(s, load, h)
        turn = _turn_of_slide(case, s, load, h, start, end)
        _fly(s, load, turn)
        update_peaks(case, s)
        a, a_rate, G, G_rate = load
        _fly(s, (a + a_rate * turn, a_rate, G + G_rate * turn, G_rate), h - turn)
        update_peaks(case, s)
        s.alpha = 0.0
        s.steps += 1
        if advance_clock(s, h, dt):
            record_sample(history, case, s)
        if outcome != ENDED:
            return outcome
    return ENDED


@inner
def _lean_rates(rows, contacts, case, s, theta, omega, a, G):
    """Accelerations of a body that slides on both its contacts, and their normal forces."""
    sin, cos = sine_and_cosine(theta)
    return slide_on_two_planes(rows, contacts, case, s, sin, cos, omega, a, G, 0.0)


@inner
def _lean(rows, contacts, case, s, start, load, h):
    """Set the state to that a time h after ``start``, by the classical fourth-order Runge–Kutta method."""
    x, z, theta, vx, vz, omega = start
    a, a_rate, G, G_rate = load
    e = 0.5 * h
    am, Gm, ae, Ge = a + e * a_rate, G + e * G_rate, a + h * a_rate, G + h * G_rate
    k1x, k1z, k1t, _, _ = _lean_rates(rows, contacts, case, s, theta, omega, a, G)
    w2 = omega + e * k1t
    k2x, k2z, k2t, _, _ = _lean_rates(rows, contacts, case, s, theta + e * omega, w2, am, Gm)
    w3 = omega + e * k2t
    k3x, k3z, k3t, _, _ = _lean_rates(rows, contacts, case, s, theta + e * w2, w3, am, Gm)
    w4 = omega + h * k3t
    k4x, k4z, k4t, _, _ = _lean_rates(rows, contacts, case, s, theta + h * w3, w4, ae, Ge)
    s.x = x + h * (vx + h * (k1x + k2x + k3x) / 6.0)
    s.z = z + h * (vz + h * (k1z + k2z + k3z) / 6.0)
    turn_to(s, theta + h * (omega + h * (k1t + k2t + k3t) / 6.0))
    s.vx = vx + h * (k1x + 2.0 * (k2x + k3x) + k4x) / 6.0
    s.vz = vz + h * (k1z + 2.0 * (k2z + k3z) + k4z) / 6.0
    s.omega = omega + h * (k1t + 2.0 * (k2t + k3t) + k4t) / 6.0
    project_on_both(contacts[s.i], contacts[s.j], case.inertia, s)


@inner
def _lean_within(rows, contacts, case, s, start, load, curves, h, t):
    """Set the state to that a time t into a step of length h: interpolated, and put on both planes.

    Where the contacts jam by its end, the forces have no bound and the interpolant is no number (its sixth
    coefficient stands for all); then the step is integrated anew.
    """
    if math.isnan(curves[2][5]):
        _lean(rows, contacts, case, s, start, load, t)
        return
    s.x, s.z, theta, s.vx, s.vz, s.omega = between(curves, h, t)
    turn_to(s, theta)
    project_on_both(contacts[s.i], contacts[s.j], case.inertia, s)


@inner
def _set_levels(contacts, s):
    """Set the levels at which a step ends: gaps of the open contacts, slip rates of the two closed ones."""
    others = s.present & ~s.closed
    for c in range(CONTACTS):
        if others >> c & 1:
            contacts[c].level = closed_level(gap(contacts[c], s))
    first, second = contacts[s.i], contacts[s.j]
    first.level = min(float(s.d) * slip_rate(first, s), 0.0) - SLACK_SLIP
    second.level = min(float(s.dj) * slip_rate(second, s), 0.0) - SLACK_SLIP


@inner
def _lean_margins(rows, contacts, case, s, load, h):
    """Accelerations in a lean h after the start of the step, and event margins, positive while it lasts.

    The margins are both normal forces, both slip rates, and the least of the others: rotation left to 90° and
    open gaps.
    """
    a, G = load[0] + h * load[1], load[2] + h * load[3]
    vx_rate, vz_rate, s.alpha, Ni, Nj = _lean_rates(rows, contacts, case, s, s.theta, s.omega, a, G)
    if math.isnan(Ni):  # the two contacts jam: end the lean
        Ni = Nj = -1.0
    first, second = contacts[s.i], contacts[s.j]
    others_least = RIGHT_ANGLE - abs(s.theta)
    s.hit = 0
    others = s.present & ~s.closed
    for c in range(CONTACTS):
        if others >> c & 1:
            over = gap(contacts[c], s) - contacts[c].level
            if over < 0.0:
                s.hit |= 1 << c
            others_least = min(others_least, over)
    margins = (
        Ni + SLACK_FORCE,
        Nj + SLACK_FORCE,
        float(s.d) * slip_rate(first, s) - first.level,
        float(s.dj) * slip_rate(second, s) - second.level,
        others_least,
    )
    return (vx_rate, vz_rate, s.alpha), margins


@inner
def _first_closing(contacts, s, y0, k0, y1, k1, h):
    """Time at which an open contact first closes in a step, if only for a while, or −1; and its bit."""
    sin0, cos0 = sine_and_cosine(y0[2])
    first, hit = -1.0, 0
    others = s.present & ~s.closed
    for c in range(CONTACTS):
        if others >> c & 1:
            con = contacts[c]
            g0, v0, c0 = gap_rates(con, y0, k0, sin0, cos0)
            g1, v1, c1 = gap_rates(con, y1, k1, s.sin, s.cos)
            t, _ = first_closing(g0, v0, c0, g1, v1, c1, h)
            if t >= 0.0 and (hit == 0 or t < first):
                first, hit = t, 1 << c
    return first, hit


@inner
def _least_of(margins, ends):
    """Least of the margins that are negative at the end of a search, each scaled to −1 there.

    Scaling makes forces and slip rates comparable; margins that stay positive would mislead the secant
    method.
    """
    least = math.inf
    for k in range(5):
        if ends[k] < 0.0:
            least = min(least, margins[k] / -ends[k])
    return least


@inline
def _first_dip(starts, middle, ends):
    """Fraction of a step at which the parabola of a force or slip rate is negative inside it, or 1."""
    first = 1.0
    for k in range(4):
        u = parabola_negative_at(starts[k], middle[k], ends[k])
        if 0.0 < u < first:
            first = u
    return first


@inner
def advance_lean(rows, contacts, case, s, motion, settings, history):
    """Advance a body that slides on two planes at once, to its next event.

    Each pass of the loop takes one step: choose its length by step doubling, evaluate the margins at its
    start, middle and end, cut it where another contact closes or a force or slip rate dips below zero, and
    where one is negative find the first crossing with the Illinois method, interpolating the state. The lean
    ends where a contact sticks, opens or jams, another closes, or the body overturns.
    """
    ax, az, dt = motion.ax, motion.az, motion.dt
    tolerance, max_step = settings.tolerance, settings.max_step
    last = ax.shape[0] - 1
    per_second = case.scale / dt
    longest = min(dt, max_step)
    while s.k < last:
        load = loads(case, ax, az, per_second, s.k, s.tau)
        start = state_of(s)
        _set_levels(contacts, s)
        k0, starts = _lean_margins(rows, contacts, case, s, load, 0.0)
        middle = starts
        h = min(dt - s.tau, longest)
        _lean(rows, contacts, case, s, start, load, h)
        while h > MIN_STEP:  # step doubling: two half steps must agree with the whole (15 = 2⁴ − 1)
            whole = s.theta
            _lean(rows, contacts, case, s, start, load, 0.5 * h)
            half = state_of(s)
            _, middle = _lean_margins(rows, contacts, case, s, load, 0.5 * h)
            late = load[0] + 0.5 * h * load[1], load[1], load[2] + 0.5 * h * load[3], load[3]
            _lean(rows, contacts, case, s, half, late, 0.5 * h)
            if abs(s.theta - whole) <= 15.0 * tolerance:
                longest = min(dt, max_step, 2.0 * longest)
                break
            h = longest = 0.5 * h
            _lean(rows, contacts, case, s, start, load, h)
        outcome = ENDED
        k1, ends = _lean_margins(rows, contacts, case, s, load, h)
        step, end = h, state_of(s)
        curves = quintics(start, k0, end, k1, step)
        dip, hit = step * _first_dip(starts, middle, ends), 0
        if not math.isnan(k1[2]):
            closing, hit = _first_closing(contacts, s, start, k0, end, k1, step)
            if hit:
                h = closing
        dips = dip < h
        if dips:
            _lean_within(rows, contacts, case, s, start, load, curves, step, dip)
            _, ends = _lean_margins(rows, contacts, case, s, load, dip)
            if min(ends[0], ends[1], ends[2], ends[3]) < 0.0:
                h, hit = dip, 0
        if dips or hit:
            _lean_within(rows, contacts, case, s, start, load, curves, step, h)
            _, ends = _lean_margins(rows, contacts, case, s, load, h)
        if hit:
            outcome, s.hit = CLOSED, hit
            ends = ends[0], ends[1], ends[2], ends[3], math.inf
        if min(ends) < 0.0:
            bracket = (0.0, max(_least_of(starts, ends), MIN_START_VALUE), h, -1.0, 0)
            for _ in range(200):
                t = secant(bracket[0], bracket[1], bracket[2], bracket[3])
                if bracket[2] - bracket[0] <= LOCATED:
                    break
                _lean_within(rows, contacts, case, s, start, load, curves, step, t)
                _, margins = _lean_margins(rows, contacts, case, s, load, t)
                bracket = illinois_update(bracket, t, _least_of(margins, ends))
            h = bracket[2]
            _lean_within(rows, contacts, case, s, start, load, curves, step, h)
            _lean_margins(rows, contacts, case, s, load, h)
            outcome = reason_of_end(s)
        s.steps += 1
        update_peaks(case, s)
        if advance_clock(s, h, dt):
            record_sample(history, case, s)
        if outcome != ENDED:
            return outcome
    return ENDED
