"""One step of a body that moves: the method of Dormand and Prince, of fifth order, with its error.

After the step the constraints of the mode are met exactly again: a corner that sticks is where it was, one
that slips on its plane. Between both ends the motion is the quintic through places, rates and accelerations.
"""

from __future__ import annotations

from stayput.compiled import inline, inner
from stayput.mechanics.columns import FLAT, SLIP, STICK, WEDGE
from stayput.mechanics.geometry import along, arm, sin_cos
from stayput.mechanics.modes import close_both, pivot_on, stay_on_plane
from stayput.mechanics.restrained.rates import rates
from stayput.mechanics.roots import hermite, horner


@inline
def _after_two(y, h, p, k, q, l):
    """State after a time h at the rate p·k + q·l."""
    return (
        y[0] + h * (p * k[0] + q * l[0]),
        y[1] + h * (p * k[1] + q * l[1]),
        y[2] + h * (p * k[2] + q * l[2]),
        y[3] + h * (p * k[3] + q * l[3]),
        y[4] + h * (p * k[4] + q * l[4]),
        y[5] + h * (p * k[5] + q * l[5]),
    )


@inline
def _sum_of_five(p, k, q, l, r, m, u, n, w, o):
    return (
        p * k[0] + q * l[0] + r * m[0] + u * n[0] + w * o[0],
        p * k[1] + q * l[1] + r * m[1] + u * n[1] + w * o[1],
        p * k[2] + q * l[2] + r * m[2] + u * n[2] + w * o[2],
        p * k[3] + q * l[3] + r * m[3] + u * n[3] + w * o[3],
        p * k[4] + q * l[4] + r * m[4] + u * n[4] + w * o[4],
        p * k[5] + q * l[5] + r * m[5] + u * n[5] + w * o[5],
    )


@inner
def dormand_prince(elements, links, contacts, rows, case, s, base, load, y, k1, h):
    """State after a step, and an estimate of its error, the larger of place and h times rate [m, rad]."""
    y2 = _after_two(y, h, 1.0 / 5.0, k1, 0.0, k1)
    k2, _, _ = rates(elements, links, contacts, rows, case, s, base, load, h * (1.0 / 5.0), y2)
    y3 = _after_two(y, h, 3.0 / 40.0, k1, 9.0 / 40.0, k2)
    k3, _, _ = rates(elements, links, contacts, rows, case, s, base, load, h * (3.0 / 10.0), y3)
    slope = _sum_of_five(44.0 / 45.0, k1, -56.0 / 15.0, k2, 32.0 / 9.0, k3, 0.0, k1, 0.0, k1)
    y4 = _after_two(y, h, 1.0, slope, 0.0, k1)
    k4, _, _ = rates(elements, links, contacts, rows, case, s, base, load, h * (4.0 / 5.0), y4)
    slope = _sum_of_five(
        19372.0 / 6561.0, k1, -25360.0 / 2187.0, k2, 64448.0 / 6561.0, k3, -212.0 / 729.0, k4, 0.0, k1
    )
    y5 = _after_two(y, h, 1.0, slope, 0.0, k1)
    k5, _, _ = rates(elements, links, contacts, rows, case, s, base, load, h * (8.0 / 9.0), y5)
    slope = _sum_of_five(
        9017.0 / 3168.0, k1, -355.0 / 33.0, k2, 46732.0 / 5247.0, k3, 49.0 / 176.0, k4, -5103.0 / 18656.0, k5
    )
    y6 = _after_two(y, h, 1.0, slope, 0.0, k1)
    k6, _, _ = rates(elements, links, contacts, rows, case, s, base, load, h, y6)
    slope = _sum_of_five(
        35.0 / 384.0, k1, 500.0 / 1113.0, k3, 125.0 / 192.0, k4, -2187.0 / 6784.0, k5, 11.0 / 84.0, k6
    )
    y7 = _after_two(y, h, 1.0, slope, 0.0, k1)
    k7, _, _ = rates(elements, links, contacts, rows, case, s, base, load, h, y7)
    wrong = _sum_of_five(
        71.0 / 57600.0, k1, -71.0 / 16695.0, k3, 71.0 / 1920.0, k4, -17253.0 / 339200.0, k5, 22.0 / 525.0, k6
    )
    wrong = _after_two(wrong, 1.0, -1.0 / 40.0, k7, 0.0, k7)
    places = max(abs(wrong[0]), abs(wrong[1]), abs(wrong[2]))
    return y7, h * max(places, h * max(abs(wrong[3]), abs(wrong[4]), abs(wrong[5])))


@inline
def set_state(s, y, base):
    """Put a state into the record."""
    s.x, s.z, s.theta, s.vx, s.vz, s.omega = y
    s.sin, s.cos = sin_cos(y[2], base[0], base[1], base[2])


@inline
def state_of(s):
    """(x, z, θ, ẋ, ż, θ̇) of the record."""
    return s.x, s.z, s.theta, s.vx, s.vz, s.omega


@inner
def meet_constraints(contacts, case, s, foot):
    """Put a state back to where the mode's contacts keep it; ``foot``: place of a corner that sticks."""
    if s.kind == STICK:
        con = contacts[s.i]
        sigma, kappa = arm(con, s)
        right, height = foot - sigma, kappa - con.offset
        s.x, s.z = con.cos * right - con.sin * height, con.sin * right + con.cos * height
        pivot_on(con, s)
    elif s.kind == SLIP or s.kind == FLAT:
        stay_on_plane(contacts[s.i], s)
    elif s.kind == WEDGE:
        close_both(contacts[s.i], contacts[s.j], case.inertia, s)


@inner
def place_of_foot(contacts, s):
    """Place of the corner that sticks, along its plane [m]."""
    con = contacts[s.i]
    return along(con, s.x, s.z)[0] + arm(con, s)[0]


@inline
def quintics(y0, k0, y1, k1, h):
    """Quintics of x, z and θ over a step."""
    return (
        hermite(y0[0], y0[3], k0[3], y1[0], y1[3], k1[3], h),
        hermite(y0[1], y0[4], k0[4], y1[1], y1[4], k1[4], h),
        hermite(y0[2], y0[5], k0[5], y1[2], y1[5], k1[5], h),
    )


@inline
def between(curves, h, t):
    """State a time t into a step of length h."""
    u = t / h
    x, vx = horner(curves[0], u)
    z, vz = horner(curves[1], u)
    theta, omega = horner(curves[2], u)
    return x, z, theta, vx / h, vz / h, omega / h
