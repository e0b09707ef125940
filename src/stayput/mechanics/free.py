"""Flight, and leaning: a body off the floor, or sliding on two planes at once."""

from __future__ import annotations

import math

from stayput.compiled import inner
from stayput.mechanics.columns import CLOSED, ENDED, LIMIT, TURNED_OVER
from stayput.mechanics.contact import press_of_two, tabulate
from stayput.mechanics.geometry import (
    HALF_TURN,
    along,
    arm_at,
    gap,
    note_peaks,
    slip_rate,
    turn_to,
)
from stayput.mechanics.modes import close_both
from stayput.mechanics.motion import loads, note_sample, pass_time
from stayput.mechanics.roots import closed_level, first_zero, narrowed, secant

LARGEST_TURN = 0.05
"""Largest rotation in a step of flight [rad]."""

LOCATED = 1e-13
"""The end of a lean is located to this part of a second [s]."""

SLACK_PRESS, SLACK_SLIP = 1e-8, 5e-11
"""A lean is over when a contact pulls, or slips back, by more than this [m/s², m/s]."""

SHORTEST = 1e-6
"""A step of a lean is not made shorter than this to keep within the tolerance [s]."""


@inner
def _slide_rate_after(case, s, a, a_rate, corner, t):
    """Rate of a corner's place along the floor after a time t of flight [m/s]."""
    theta = s.theta + t * s.omega
    up = case.v[corner] * math.cos(theta) - case.u[corner] * math.sin(theta)
    return s.vx - t * (a + 0.5 * t * a_rate) + s.omega * up


@inner
def _turn_of_slide(case, s, a, a_rate, h):
    """Time in a step of flight at which the slide turns; the whole step where it does not."""
    corner = 1 if s.theta > s.rest else 0
    rate0 = _slide_rate_after(case, s, a, a_rate, corner, 0.0)
    rate1 = _slide_rate_after(case, s, a, a_rate, corner, h)
    if rate0 * rate1 >= 0.0:
        return h
    bracket = (0.0, abs(rate0), h, -abs(rate1), 0)
    for _ in range(30):
        t = secant(bracket[0], bracket[1], bracket[2], bracket[3])
        rate = _slide_rate_after(case, s, a, a_rate, corner, t)
        bracket = narrowed(bracket, t, math.copysign(1.0, rate0) * rate)
        if bracket[2] - bracket[0] <= 1e-9:
            break
    return bracket[2]


@inner
def _fly(s, a, a_rate, G, G_rate, t):
    """Move the state of a flight by a time t."""
    s.x += t * (s.vx - t * (a / 2.0 + t * a_rate / 6.0))
    s.z += t * (s.vz - t * (G / 2.0 + t * G_rate / 6.0))
    s.vx -= t * (a + 0.5 * t * a_rate)
    s.vz -= t * (G + 0.5 * t * G_rate)
    turn_to(s, s.theta + t * s.omega)


@inner
def _flying_gap(con, s, a, a_rate, G, G_rate, t):
    """Gap of a contact after a time t of flight, with its first and second rates."""
    theta = s.theta + t * s.omega
    sigma, kappa = arm_at(con, math.sin(theta), math.cos(theta))
    x = s.x + t * (s.vx - t * (a / 2.0 + t * a_rate / 6.0))
    z = s.z + t * (s.vz - t * (G / 2.0 + t * G_rate / 6.0))
    height = along(con, x, z)[1]
    rate = along(con, s.vx - t * (a + 0.5 * t * a_rate), s.vz - t * (G + 0.5 * t * G_rate))[1]
    fall = along(con, -a - t * a_rate, -G - t * G_rate)[1]
    return height + con.offset - kappa, rate - s.omega * sigma, fall + s.omega * s.omega * kappa


@inner
def advance_flight(contacts, case, s, ax, az, dt, history):
    """Let the body fly to where a contact closes."""
    last = ax.shape[0] - 1
    per_second = case.scale / dt
    while s.k < last:
        a, a_rate, G, G_rate = loads(case, ax, az, per_second, s.k, s.tau)
        h = dt - s.tau
        if abs(s.omega) * h > LARGEST_TURN:
            h = LARGEST_TURN / abs(s.omega)
        outcome = ENDED
        if abs(s.theta + h * s.omega) >= HALF_TURN:
            h, outcome = (HALF_TURN - abs(s.theta)) / abs(s.omega), TURNED_OVER
        c = 0
        while s.present >> c:
            if s.present >> c & 1:
                con = contacts[c]
                g0, v0, c0 = _flying_gap(con, s, a, a_rate, G, G_rate, 0.0)
                g1, v1, c1 = _flying_gap(con, s, a, a_rate, G, G_rate, h)
                level = closed_level(g0)
                t = first_zero(g0 - level, v0, c0, g1 - level, v1, c1, h)
                if t >= 0.0:
                    for _ in range(2):  # on the motion itself
                        g, v, _ = _flying_gap(con, s, a, a_rate, G, G_rate, t)
                        if v < 0.0:
                            t = min(h, max(0.5 * t, t - (g - level) / v))
                    h, outcome, s.hit = t, CLOSED, 1 << c
            c += 1
        turn = _turn_of_slide(case, s, a, a_rate, h)
        _fly(s, a, a_rate, G, G_rate, turn)
        note_peaks(case, s)
        a, G = a + a_rate * turn, G + G_rate * turn
        _fly(s, a, a_rate, G, G_rate, h - turn)
        note_peaks(case, s)
        s.alpha = 0.0
        s.steps += 1
        if pass_time(s, h, dt):
            note_sample(history, case, s)
        if outcome != ENDED:
            return outcome
    return ENDED


@inner
def _lean_rates(rows, contacts, case, s, theta, omega, a, G):
    """Accelerations of a body that slides on both its contacts, and their normal forces."""
    tabulate(rows, contacts, s.closed, math.sin(theta), math.cos(theta), case)
    for k in range(2):
        row = rows[k]
        row.bias_n = along(contacts[row.index], -a, -G)[1] - omega * omega * row.tl
        row.target = 0.0
    i, j = (0, 1) if s.i < s.j else (1, 0)
    Ni, Nj, fx, fz, fl = press_of_two(rows[i], float(s.d), rows[j], float(s.dj), case.inertia)
    return fx - a, fz - G, fl / case.inertia, Ni, Nj


@inner
def _lean(rows, contacts, case, s, start, load, h):
    """Set the state to that a time h after the start: a step of the classical Runge–Kutta method."""
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
    close_both(contacts[s.i], contacts[s.j], case.inertia, s)


@inner
def _set_levels(contacts, s):
    """Set, for a step, the gaps at which other contacts close and the rates at which these two slip back."""
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1:
            contacts[c].level = closed_level(gap(contacts[c], s))
        c += 1
    first, second = contacts[s.i], contacts[s.j]
    first.level = min(float(s.d) * slip_rate(first, s), 0.0) - SLACK_SLIP
    second.level = min(float(s.dj) * slip_rate(second, s), 0.0) - SLACK_SLIP


@inner
def _lean_margin(rows, contacts, case, s, load, h):
    """What must stay positive while the body slides on both contacts, h after the start: the least of all."""
    a, G = load[0] + h * load[1], load[2] + h * load[3]
    _, _, s.alpha, Ni, Nj = _lean_rates(rows, contacts, case, s, s.theta, s.omega, a, G)
    least = min(Ni, Nj) + SLACK_PRESS
    first, second = contacts[s.i], contacts[s.j]
    slip = min(
        float(s.d) * slip_rate(first, s) - first.level, float(s.dj) * slip_rate(second, s) - second.level
    )
    least = min(least, slip, HALF_TURN - abs(s.theta))
    s.hit = 0
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1:
            over = gap(contacts[c], s) - contacts[c].level
            if over < 0.0:
                s.hit |= 1 << c
            least = min(least, over)
        c += 1
    return -1.0 if math.isnan(Ni) else least


@inner
def _why_over(s):
    if s.hit:
        return CLOSED
    return TURNED_OVER if abs(s.theta) >= HALF_TURN else LIMIT


@inner
def advance_lean(rows, contacts, case, s, ax, az, dt, tolerance, max_step, history):
    """Slide the body on two planes at once, to where it sticks, a contact opens or another closes."""
    last = ax.shape[0] - 1
    per_second = case.scale / dt
    longest = min(dt, max_step)
    while s.k < last:
        load = loads(case, ax, az, per_second, s.k, s.tau)
        start = s.x, s.z, s.theta, s.vx, s.vz, s.omega
        _set_levels(contacts, s)
        first = _lean_margin(rows, contacts, case, s, load, 0.0)
        h = min(dt - s.tau, longest)
        _lean(rows, contacts, case, s, start, load, h)
        while h > SHORTEST:  # two halves must agree with the whole
            whole = s.theta
            _lean(rows, contacts, case, s, start, load, 0.5 * h)
            half = s.x, s.z, s.theta, s.vx, s.vz, s.omega
            late = load[0] + 0.5 * h * load[1], load[1], load[2] + 0.5 * h * load[3], load[3]
            _lean(rows, contacts, case, s, half, late, 0.5 * h)
            if abs(s.theta - whole) <= 15.0 * tolerance:
                longest = min(dt, max_step, 2.0 * longest)
                break
            h = longest = 0.5 * h
            _lean(rows, contacts, case, s, start, load, h)
        outcome = ENDED
        margin = _lean_margin(rows, contacts, case, s, load, h)
        if margin < 0.0:
            bracket = (0.0, max(first, SLACK_SLIP), h, margin, 0)
            for _ in range(200):
                t = secant(bracket[0], bracket[1], bracket[2], bracket[3])
                if bracket[2] - bracket[0] <= LOCATED:
                    break
                _lean(rows, contacts, case, s, start, load, t)
                bracket = narrowed(bracket, t, _lean_margin(rows, contacts, case, s, load, t))
            h = bracket[2]
            _lean(rows, contacts, case, s, start, load, h)
            _lean_margin(rows, contacts, case, s, load, h)
            outcome = _why_over(s)
        s.steps += 1
        note_peaks(case, s)
        if pass_time(s, h, dt):
            note_sample(history, case, s)
        if outcome != ENDED:
            return outcome
    return ENDED
