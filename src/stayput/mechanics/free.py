"""Flight, and leaning: a body off the floor, or sliding on two planes at once."""

from __future__ import annotations

import math

from stayput.mechanics.columns import CLOSED, ENDED, LIMIT, TURNED_OVER
from stayput.mechanics.compiled import inner
from stayput.mechanics.contact import press_of_two, tabulate_forces
from stayput.mechanics.geometry import (
    GAP_TOLERANCE,
    HALF_TURN,
    along,
    arm,
    gap_and_rates,
    slide_of,
    slip_rate,
)
from stayput.mechanics.modes import close_both
from stayput.mechanics.motion import loads, note_sample, pass_time
from stayput.mechanics.roots import first_zero

LARGEST_TURN = 0.05
"""Largest rotation in a step of flight [rad]."""

LEAN_STEPS = 4
"""Runge–Kutta steps in a sample while the body slides on two planes."""


@inner
def _fallen(s, a, a_rate, G, G_rate, t):
    """State of a flight after a time t: place, rates, accelerations."""
    return (
        s.x + t * (s.vx - t * (a / 2.0 + t * a_rate / 6.0)),
        s.z + t * (s.vz - t * (G / 2.0 + t * G_rate / 6.0)),
        s.theta + t * s.omega,
        s.vx - t * (a + 0.5 * t * a_rate),
        s.vz - t * (G + 0.5 * t * G_rate),
        s.omega,
        -a - t * a_rate,
        -G - t * G_rate,
        0.0,
    )


@inner
def note_peaks(case, s):
    """Keep the largest tilt and slide so far."""
    s.peak_tilt = max(s.peak_tilt, abs(s.theta))
    s.peak_slide = max(s.peak_slide, abs(slide_of(case, s)[0]))


@inner
def advance_flight(contacts, case, s, ax, az, dt, history):
    """Let the body fly to where a contact closes."""
    last = ax.shape[0] - 1
    while s.k < last:
        a, a_rate, G, G_rate = loads(case, ax, az, dt, s.k, s.tau)
        h = dt - s.tau
        if abs(s.omega) * h > LARGEST_TURN:
            h = LARGEST_TURN / abs(s.omega)
        outcome = ENDED
        start = _fallen(s, a, a_rate, G, G_rate, 0.0)
        tilt = abs(s.theta + h * s.omega)
        if tilt >= HALF_TURN:
            h, outcome = (HALF_TURN - abs(s.theta)) / abs(s.omega), TURNED_OVER
        c = 0
        while s.present >> c:
            if s.present >> c & 1:
                g0, v0, c0 = gap_and_rates(contacts[c], start)
                g1, v1, c1 = gap_and_rates(contacts[c], _fallen(s, a, a_rate, G, G_rate, h))
                t = first_zero(g0, v0, c0, g1, v1, c1, h)
                if t >= 0.0:
                    for _ in range(2):
                        g, v, _ = gap_and_rates(contacts[c], _fallen(s, a, a_rate, G, G_rate, t))
                        if v < 0.0 and t > 0.0:
                            t = min(h, max(0.5 * t, t - g / v))
                    h, outcome, s.hit = t, CLOSED, 1 << c
            c += 1
        s.x, s.z, s.theta, s.vx, s.vz, s.omega, _, _, _ = _fallen(s, a, a_rate, G, G_rate, h)
        s.alpha = 0.0
        s.steps += 1
        note_peaks(case, s)
        if pass_time(s, h, dt):
            note_sample(history, case, s)
        if outcome != ENDED:
            return outcome
    return ENDED


@inner
def _lean_rates(rows, contacts, s, I, theta, omega, a, G):
    """Accelerations of a body that slides on both its contacts, and their normal forces."""
    tabulate_forces(rows, contacts, s.closed, theta, omega, a, G)
    first_is_i = 0 if s.i < s.j else 1
    Ni, Nj, fx, fz, fl = press_of_two(rows[first_is_i], float(s.d), rows[1 - first_is_i], float(s.dj), I)
    return fx - a, fz - G, fl / I, Ni, Nj


@inner
def _lean_step(rows, contacts, case, s, x, z, theta, vx, vz, omega, a, a_rate, G, G_rate, h):
    """One step of the classical Runge–Kutta method, put back onto both contacts; the state is set."""
    I = case.inertia
    k1x, k1z, k1t, _, _ = _lean_rates(rows, contacts, s, I, theta, omega, a, G)
    e = 0.5 * h
    am, Gm = a + e * a_rate, G + e * G_rate
    v2x, v2z, w2 = vx + e * k1x, vz + e * k1z, omega + e * k1t
    k2x, k2z, k2t, _, _ = _lean_rates(rows, contacts, s, I, theta + e * omega, w2, am, Gm)
    v3x, v3z, w3 = vx + e * k2x, vz + e * k2z, omega + e * k2t
    k3x, k3z, k3t, _, _ = _lean_rates(rows, contacts, s, I, theta + e * w2, w3, am, Gm)
    v4x, v4z, w4 = vx + h * k3x, vz + h * k3z, omega + h * k3t
    ae, Ge = a + h * a_rate, G + h * G_rate
    k4x, k4z, k4t, _, _ = _lean_rates(rows, contacts, s, I, theta + h * w3, w4, ae, Ge)
    s.x = x + h * (vx + 2.0 * (v2x + v3x) + v4x) / 6.0
    s.z = z + h * (vz + 2.0 * (v2z + v3z) + v4z) / 6.0
    s.theta = theta + h * (omega + 2.0 * (w2 + w3) + w4) / 6.0
    s.vx = vx + h * (k1x + 2.0 * (k2x + k3x) + k4x) / 6.0
    s.vz = vz + h * (k1z + 2.0 * (k2z + k3z) + k4z) / 6.0
    s.omega = omega + h * (k1t + 2.0 * (k2t + k3t) + k4t) / 6.0
    close_both(contacts[s.i], contacts[s.j], I, s)
    _, _, s.alpha, Ni, Nj = _lean_rates(rows, contacts, s, I, s.theta, s.omega, ae, Ge)
    return Ni, Nj


@inner
def _lean_ends(contacts, s, Ni, Nj):
    """Why the body cannot go on sliding on both contacts, in the state reached: ENDED where it can."""
    others = s.present & ~s.closed
    s.hit = 0
    c = 0
    while others >> c:
        if others >> c & 1:
            con = contacts[c]
            _, kappa = arm(con, s.theta)
            if along(con, s.x, s.z)[1] + con.offset - kappa < -0.1 * GAP_TOLERANCE:
                s.hit |= 1 << c
        c += 1
    if s.hit:
        return CLOSED
    if abs(s.theta) >= HALF_TURN:
        return TURNED_OVER
    slips = s.d * slip_rate(contacts[s.i], s), s.dj * slip_rate(contacts[s.j], s)
    if not (Ni >= 0.0 and Nj >= 0.0) or slips[0] < 0.0 or slips[1] < 0.0:
        return LIMIT
    return ENDED


@inner
def advance_lean(rows, contacts, case, s, ax, az, dt, history):
    """Slide the body on two planes at once, to where it sticks, a contact opens or another closes."""
    last = ax.shape[0] - 1
    while s.k < last:
        a, a_rate, G, G_rate = loads(case, ax, az, dt, s.k, s.tau)
        h = min(dt - s.tau, dt / LEAN_STEPS)
        x, z, theta, vx, vz, omega = s.x, s.z, s.theta, s.vx, s.vz, s.omega
        Ni, Nj = _lean_step(rows, contacts, case, s, x, z, theta, vx, vz, omega, a, a_rate, G, G_rate, h)
        outcome = _lean_ends(contacts, s, Ni, Nj)
        if outcome != ENDED and s.stalls > 8:
            outcome = LIMIT
        elif outcome != ENDED:
            low, high = 0.0, h
            while high - low > 1e-13:
                h = 0.5 * (low + high)
                Ni, Nj = _lean_step(
                    rows, contacts, case, s, x, z, theta, vx, vz, omega, a, a_rate, G, G_rate, h
                )
                found = _lean_ends(contacts, s, Ni, Nj)
                if found == ENDED:
                    low = h
                else:
                    high, outcome = h, found
            h = high
            Ni, Nj = _lean_step(rows, contacts, case, s, x, z, theta, vx, vz, omega, a, a_rate, G, G_rate, h)
            outcome = _lean_ends(contacts, s, Ni, Nj)
            if outcome == LIMIT and abs(s.omega) < 1e-9 and not math.isnan(Ni):
                s.vx = s.vz = s.omega = 0.0
        s.steps += 1
        note_peaks(case, s)
        if pass_time(s, h, dt):
            note_sample(history, case, s)
        if outcome != ENDED:
            return outcome
    return ENDED
