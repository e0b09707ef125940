"""Which mode follows: the one consistent set of contact forces, and the velocities that go with it.

The patterns are tried from the fewest contacts to the most, save that a body which can stay at rest on
one plane does: a wall or a ceiling presses only where the body would move into it, and never by a
self-stress that nothing has set up. At the instant of an event a force is exactly at its limit; the
choice is therefore made for the loads and the state a moment later.
"""

from __future__ import annotations

import math

from stayput.compiled import inner
from stayput.mechanics.columns import (
    A_FLOOR,
    B_FLOOR,
    FAILED,
    FLAT,
    FLIGHT,
    FLOOR_BITS,
    HELD,
    PLANE,
    SLIP,
    STICK,
    WEDGE,
)
from stayput.mechanics.contact import (
    STUCK,
    both_slip,
    holding_cone,
    none_presses,
    one_ray,
    one_slips,
    one_sticks,
    tabulate,
    turned,
)
from stayput.mechanics.geometry import along, arm, gap, gap_rate, slip_rate, stand_flat, turn_to

MOMENT = 1e-9
"""How far ahead the forces are looked at when a mode is chosen [s]."""

TOLERANCE = 1e-11
"""Slack of the inequalities between accelerations [m/s²]."""

ALL_BUT_FLAT = 1e-8
"""A body on both base corners is put flat where it is no more out of it than this [rad]."""


@inner
def set_mode(s, kind, i, d, j, dj):
    """Set the mode, its contacts and their directions of slip; only these are closed."""
    s.kind, s.i, s.d, s.j, s.dj = kind, i, d, j, dj
    s.closed = 0
    if i >= 0:
        s.closed |= 1 << i
    if j >= 0:
        s.closed |= 1 << j


@inner
def choose_mode(rows, contacts, touching, settle, case, s, a, a_rate, G, G_rate):
    """Set the mode of a body whose contacts ``touching`` are closed, and its velocities.

    A contact that opens no faster than ``settle`` [m/s] is closed: after an impact, the rate of a bounce
    that is over; else none. ``a`` and ``G`` are the floor's acceleration and g + z̈_G now, with their rates.
    """
    closed, moving = 0, 0.0
    c = 0
    while touching >> c:
        if touching >> c & 1:
            rate = gap_rate(contacts[c], s)
            if rate <= settle:
                closed |= 1 << c
                moving = max(moving, abs(rate))
        c += 1
    if moving > STUCK:
        stay_closed(contacts, closed, settle, case.inertia, s)
    turn = MOMENT * s.omega
    omega = s.omega + MOMENT * s.alpha
    a, G = a + MOMENT * a_rate, G + MOMENT * G_rate
    count = tabulate(rows, contacts, closed, s.sin + turn * s.cos, s.cos - turn * s.sin, case)
    still = True
    for k in range(count):
        row = rows[k]
        con = contacts[row.index]
        tangential, normal = along(con, -a, -G)
        row.bias_n = normal - omega * omega * row.tl
        row.bias_t = tangential + omega * omega * row.nl
        row.target = 0.0
        slip = slip_rate(con, s)
        row.slipping = 0.0 if abs(slip) <= STUCK else (1.0 if slip > 0.0 else -1.0)
        still = still and abs(slip) <= settle

    if none_presses(rows, count, TOLERANCE):
        set_mode(s, FLIGHT, -1, 0, -1, 0)
        s.alpha = 0.0
    elif not (
        (still and _hold_on_plane(rows, count, closed, case, s, a, G))
        or try_to_stick(rows, count, contacts, case, s)
        or try_to_slide(rows, count, contacts, case, s, True)
        or try_to_slip(rows, count, contacts, case, s)
        or (still and _hold(rows, count, closed, case, s, a, G))
        or try_to_slide(rows, count, contacts, case, s, False)
    ):
        set_mode(s, FAILED, -1, 0, -1, 0)


@inner
def _bears(cone, a, G):
    """Whether the load lies in a cone from `holding_cone`."""
    found, lx, lz, hx, hz = cone
    between = turned(a, G, lx, lz) >= 0.0 and turned(hx, hz, a, G) >= 0.0
    return found and between and (a * lx + G * lz >= 0.0 or not one_ray(lx, lz, hx, hz))


@inner
def _stay_held(cone, closed, case, s):
    set_mode(s, HELD, -1, 0, -1, 0)
    s.closed = closed
    _, s.low, s.low_up, s.high, s.high_up = cone
    s.vx = s.vz = s.omega = s.alpha = 0.0
    if closed & FLOOR_BITS == FLOOR_BITS and abs(s.theta - s.rest) < ALL_BUT_FLAT:
        stand_flat(case, s)


@inner
def _hold_on_plane(rows, count, closed, case, s, a, G):
    """Try to hold the body still by both its corners on one plane."""
    for k in range(count - 1):
        if PLANE[rows[k].index] == PLANE[rows[k + 1].index]:
            cone = holding_cone(rows, k, 2, -1)
            if _bears(cone, a, G):
                _stay_held(cone, closed, case, s)
                return True
    return False


@inner
def _hold(rows, count, closed, case, s, a, G):
    """Try to hold the body still by all its contacts, those on other planes than the floor's pressed.

    They press as long as the load moves the body their way: the other end of the range is that of the
    floor alone.
    """
    both = closed & FLOOR_BITS == FLOOR_BITS
    tips = B_FLOOR if a > 0.0 else A_FLOOR  # the corner that the load lifts
    for way in range(3 if both and count > 2 else 1):
        lifted = (-1, tips, 1 - tips)[way]
        cone = holding_cone(rows, 0, count, lifted)
        if not _bears(cone, a, G):
            continue
        found, lx, lz, hx, hz = cone
        if both and lifted < 0:
            found, low_x, low_z, high_x, high_z = holding_cone(rows, 0, 2, -1)
        else:  # the load whose line passes through the foot and G
            found = closed & FLOOR_BITS != 0
            foot = rows[1 if lifted == 0 else 0]
            low_x, low_z = high_x, high_z = foot.nl, -foot.tl
        if found and turned(high_x, high_z, a, G) < 0.0:
            shorter = (True, low_x, low_z, hx, hz)
        else:
            shorter = (True, lx, lz, high_x, high_z)
        if found and _bears(shorter, a, G):
            cone = shorter
        _stay_held(cone, closed, case, s)
        return True
    return False


@inner
def try_to_stick(rows, count, contacts, case, s):
    """Try one contact that sticks, the others opening."""
    for i in range(count):
        if rows[i].slipping == 0.0:
            ok, _, _, fl = one_sticks(rows, count, i, case.inertia, TOLERANCE)
            if ok:
                set_mode(s, STICK, rows[i].index, 0, -1, 0)
                s.alpha = fl / case.inertia
                pivot_on(contacts[s.i], s)
                return True
    return False


@inner
def try_to_slip(rows, count, contacts, case, s):
    """Try one contact that slips, the others opening."""
    for i in range(count):
        for side in (1.0, -1.0):
            if rows[i].slipping == -side:
                continue
            ok, _, _, fl = one_slips(rows, count, i, side, case.inertia, TOLERANCE)
            if ok:
                set_mode(s, SLIP, rows[i].index, int(side), -1, 0)
                s.alpha = fl / case.inertia
                stay_on_plane(contacts[s.i], s)
                return True
    return False


@inner
def try_to_slide(rows, count, contacts, case, s, flat):
    """Try two contacts that both press and slip: on one plane (``flat``), or on two.

    On two planes more than one way may be consistent where a corner at a wall stands still; the one with
    the least force is that without self-stress.
    """
    found, least = False, math.inf
    I = case.inertia
    for i in range(count):
        for j in range(i + 1, count):
            first, second = rows[i].index, rows[j].index
            if (PLANE[first] == PLANE[second]) != flat:
                continue
            for side_i in (1.0, -1.0):
                if rows[i].slipping == -side_i:
                    continue
                for side_j in (1.0, -1.0):
                    if (flat and side_i != side_j) or rows[j].slipping == -side_j:
                        continue
                    ok, fx, fz, fl = both_slip(rows, count, i, side_i, j, side_j, I, TOLERANCE)
                    size = fx * fx + fz * fz + fl * fl / I
                    if ok and size < least:
                        found, least = True, size
                        set_mode(s, FLAT if flat else WEDGE, first, int(side_i), second, int(side_j))
                        s.alpha = fl / I
    if found:
        _settle_pair(contacts, case, s)
    return found


@inner
def pivot_on(con, s):
    """Give G the velocity of a rotation about the contact's corner."""
    sigma, kappa = arm(con, s)
    tangential, normal = s.omega * kappa, s.omega * sigma
    s.vx = con.cos * tangential - con.sin * normal
    s.vz = con.sin * tangential + con.cos * normal


@inner
def stay_on_plane(con, s):
    """Take away the velocity of the contact's corner off its plane, and the corner's distance to it."""
    sigma, kappa = arm(con, s)
    tangential, _ = along(con, s.vx, s.vz)
    normal = s.omega * sigma
    s.vx = con.cos * tangential - con.sin * normal
    s.vz = con.sin * tangential + con.cos * normal
    along_plane, _ = along(con, s.x, s.z)
    height = kappa - con.offset
    s.x = con.cos * along_plane - con.sin * height
    s.z = con.sin * along_plane + con.cos * height


@inner
def _settle_pair(contacts, case, s):
    """Place and velocities with both contacts closed: flat on their plane, or as they turn on two."""
    first, second = contacts[s.i], contacts[s.j]
    if s.kind == FLAT:
        s.omega = s.alpha = 0.0
        if s.closed == FLOOR_BITS and abs(s.theta - s.rest) < ALL_BUT_FLAT:
            stand_flat(case, s)
        stay_on_plane(first, s)
        return
    close_both(first, second, case.inertia, s)


@inner
def _without(j, e):
    """Take the part along a unit vector out of a vector."""
    p = j[0] * e[0] + j[1] * e[1] + j[2] * e[2]
    return j[0] - p * e[0], j[1] - p * e[1], j[2] - p * e[2]


@inner
def stay_closed(contacts, closed, settle, I, s):
    """Take away the rates of the gaps of closed contacts, and of slip where it is no more than ``settle``.

    The change is the least in the metric of mass, so energy never grows: the velocities (v_x, v_z, √I ω)
    lose their part in the space of the contacts' normals and tangents.
    """
    root = math.sqrt(I)
    v = (s.vx, s.vz, root * s.omega)
    nothing = (0.0, 0.0, 0.0)
    e1, e2, e3 = nothing, nothing, nothing
    for tangential in (False, True):
        c = 0
        while closed >> c:
            con = contacts[c]
            if closed >> c & 1 and not (tangential and abs(slip_rate(con, s)) > settle):
                sigma, kappa = arm(con, s)
                j = (con.cos, con.sin, -kappa / root) if tangential else (-con.sin, con.cos, -sigma / root)
                new = _without(_without(_without(j, e1), e2), e3)
                size = math.sqrt(new[0] * new[0] + new[1] * new[1] + new[2] * new[2])
                if size > 1e-6:
                    e1, e2, e3 = (new[0] / size, new[1] / size, new[2] / size), e1, e2
                    v = _without(v, e1)
            c += 1
    s.vx, s.vz, s.omega = v[0], v[1], v[2] / root


@inner
def _least_change(first, second, gap1, gap2, I, s):
    """Changes of x, z and θ, or of their rates, that take two gaps, or their rates, away."""
    sigma1, _ = arm(first, s)
    sigma2, _ = arm(second, s)
    aa, bb = 1.0 + sigma1 * sigma1 / I, 1.0 + sigma2 * sigma2 / I
    ab = first.sin * second.sin + first.cos * second.cos + sigma1 * sigma2 / I
    det = aa * bb - ab * ab
    if abs(det) < 1e-14:
        return 0.0, 0.0, 0.0
    p, q = -(gap1 * bb - gap2 * ab) / det, -(gap2 * aa - gap1 * ab) / det
    return (
        -(p * first.sin + q * second.sin),
        p * first.cos + q * second.cos,
        -(p * sigma1 + q * sigma2) / I,
    )


@inner
def _stop_both(first, second, I, s):
    rate1, rate2 = gap_rate(first, s), gap_rate(second, s)
    dx, dz, turn = _least_change(first, second, rate1, rate2, I, s)
    s.vx, s.vz, s.omega = s.vx + dx, s.vz + dz, s.omega + turn


@inner
def close_both(first, second, I, s):
    """Move the state, by the least change in the metric of mass, to where both contacts are closed."""
    dx, dz, turn = _least_change(first, second, gap(first, s), gap(second, s), I, s)
    s.x, s.z = s.x + dx, s.z + dz
    turn_to(s, s.theta + turn)
    _stop_both(first, second, I, s)
