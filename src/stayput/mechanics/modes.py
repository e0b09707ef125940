"""Mode selection after an event: the consistent active set of contacts, and velocities that agree with it.

Active sets are tried from the fewest contacts to the most, except that a body which can rest on one plane
does: a wall or ceiling presses only where the body would move into it, never by self-stress that nothing has
set up. At the instant of an event a force is exactly at its limit, so the choice is made for the loads and
the state a moment later (`LOOKAHEAD`).
"""

from __future__ import annotations

import math

from stayput.compiled import inner
from stayput.mechanics.columns import (
    A_FLOOR,
    B_FLOOR,
    FAILED,
    FLIGHT,
    FLOOR_BITS,
    LEAN,
    PLANE,
    REST,
    ROCK,
    SLIDE,
    SLIDE_ROCK,
)
from stayput.mechanics.contact import (
    STICK_RATE,
    both_slip,
    cross,
    fill_rows,
    holding_cone,
    is_single_ray,
    no_contact_closes,
    one_slips,
    one_sticks,
)
from stayput.mechanics.geometry import arm, gap, gap_rate, slip_rate, stand_flat, to_plane_axes, turn_to

LOOKAHEAD = 1e-9
"""Time ahead of the event at which the contact forces are evaluated to choose the mode [s]."""

TOLERANCE = 1e-11
"""Tolerance of the inequalities between accelerations [m/s²]."""

FLAT_TOLERANCE = 1e-8
"""Rotation off flat below which a body on both base corners is set exactly flat [rad]."""


MAX_SETTLING = 10.0
"""Largest velocity removed when a bounce ends, in multiples of the rate at which its gap may still open."""


@inner
def set_mode(s, kind, i, d, j, dj):
    """Set the mode, its contacts and their slip directions; all other contacts are open."""
    s.kind, s.i, s.d, s.j, s.dj = kind, i, d, j, dj
    s.closed = 0
    if i >= 0:
        s.closed |= 1 << i
    if j >= 0:
        s.closed |= 1 << j


@inner
def close_slow_contacts(contacts, touching, settle_rate, case, s):
    """Bits of the contacts that open no faster than ``settle_rate``, their gap rates removed."""
    closed, moving = 0, 0.0
    c = 0
    while touching >> c:
        if touching >> c & 1:
            rate = gap_rate(contacts[c], s)
            if rate <= settle_rate:
                closed |= 1 << c
                moving = max(moving, abs(rate))
        c += 1
    if moving > STICK_RATE:
        remove_gap_rates(contacts, closed, settle_rate, case.inertia, s)
    return closed


@inner
def choose_mode(rows, contacts, touching, settle_rate, case, s, a, a_rate, G, G_rate):
    """Set the mode of a body whose gaps ``touching`` are zero, and velocities that agree with it.

    A contact that opens no faster than ``settle_rate`` [m/s] is closed; after an impact that is the rate at
    which a bounce has ended. ``a`` and ``G`` are the floor's acceleration and g + z̈_G now, with their rates.
    """
    closed = close_slow_contacts(contacts, touching, settle_rate, case, s)
    turn = LOOKAHEAD * s.omega
    omega = s.omega + LOOKAHEAD * s.alpha
    a, G = a + LOOKAHEAD * a_rate, G + LOOKAHEAD * G_rate
    count = fill_rows(rows, contacts, closed, s.sin + turn * s.cos, s.cos - turn * s.sin, case)
    at_rest = True
    for k in range(count):
        row = rows[k]
        con = contacts[row.index]
        tangential, normal = to_plane_axes(con, -a, -G)
        row.bias_n = normal - omega * omega * row.tl
        row.bias_t = tangential + omega * omega * row.nl
        row.target = 0.0
        slip = slip_rate(con, s)
        row.slipping = 0.0 if abs(slip) <= STICK_RATE else (1.0 if slip > 0.0 else -1.0)
        at_rest = at_rest and abs(slip) <= STICK_RATE

    # The order of cases is the order of preference where several active sets are consistent; see the module.
    if no_contact_closes(rows, count, TOLERANCE):
        set_mode(s, FLIGHT, -1, 0, -1, 0)
        s.alpha = 0.0
    elif not (
        (at_rest and _rest_on_plane(rows, count, closed, case, s, a, G))
        or try_to_stick(rows, count, contacts, case, s)
        or try_to_slide(rows, count, contacts, case, s, True)
        or try_to_slip(rows, count, contacts, case, s)
        or (at_rest and _rest_on_all(rows, count, closed, case, s, a, G))
        or try_to_slide(rows, count, contacts, case, s, False)
    ):
        set_mode(s, FAILED, -1, 0, -1, 0)


@inner
def _load_in_cone(cone, a, G):
    """Whether the load (a, G) lies in a cone from `contact.holding_cone`."""
    exists, lx, lz, hx, hz = cone
    between = cross(a, G, lx, lz) >= 0.0 and cross(hx, hz, a, G) >= 0.0
    return exists and between and (a * lx + G * lz >= 0.0 or not is_single_ray(lx, lz, hx, hz))


@inner
def _set_rest(cone, closed, case, s):
    set_mode(s, REST, -1, 0, -1, 0)
    s.closed = closed
    _, s.low, s.low_up, s.high, s.high_up = cone
    s.vx = s.vz = s.omega = s.alpha = 0.0
    if closed & FLOOR_BITS == FLOOR_BITS and abs(s.theta - s.rest) < FLAT_TOLERANCE:
        stand_flat(case, s)


@inner
def _rest_on_plane(rows, count, closed, case, s, a, G):
    """Try rest on two corners of one plane; whether it is consistent."""
    for k in range(count - 1):
        if PLANE[rows[k].index] == PLANE[rows[k + 1].index]:
            cone = holding_cone(rows, k, 2, -1)
            if _load_in_cone(cone, a, G):
                _set_rest(cone, closed, case, s)
                return True
    return False


@inner
def _rest_on_all(rows, count, closed, case, s, a, G):
    """Try rest on all closed contacts, those of walls and ceiling pressed; whether it is consistent.

    They stay pressed while the load pushes the body towards them: at the other end the range of loads is that
    of the floor alone.
    """
    both = closed & FLOOR_BITS == FLOOR_BITS
    tips = B_FLOOR if a > 0.0 else A_FLOOR  # the corner that the load lifts
    for way in range(3 if both and count > 2 else 1):
        lifted = (-1, tips, 1 - tips)[way]
        cone = holding_cone(rows, 0, count, lifted)
        if not _load_in_cone(cone, a, G):
            continue
        exists, lx, lz, hx, hz = cone
        if both and lifted < 0:
            exists, low_x, low_z, high_x, high_z = holding_cone(rows, 0, 2, -1)
        else:  # the load whose line passes through the foot and G
            exists = closed & FLOOR_BITS != 0
            foot = rows[1 if lifted == 0 else 0]
            low_x, low_z = high_x, high_z = foot.nl, -foot.tl
        if exists and cross(high_x, high_z, a, G) < 0.0:
            shorter = (True, low_x, low_z, hx, hz)
        else:
            shorter = (True, lx, lz, high_x, high_z)
        if exists and _load_in_cone(shorter, a, G):
            cone = shorter
        _set_rest(cone, closed, case, s)
        return True
    return False


@inner
def try_to_stick(rows, count, contacts, case, s):
    """Try active sets of one sticking contact; whether one is consistent."""
    for i in range(count):
        if rows[i].slipping == 0.0:
            ok, _, _, fl = one_sticks(rows, count, i, case.inertia, TOLERANCE)
            if ok:
                set_mode(s, ROCK, rows[i].index, 0, -1, 0)
                s.alpha = fl / case.inertia
                set_pivot_velocity(contacts[s.i], s)
                return True
    return False


@inner
def try_to_slip(rows, count, contacts, case, s):
    """Try active sets of one slipping contact; whether one is consistent."""
    for i in range(count):
        for side in (1.0, -1.0):
            if rows[i].slipping == -side:
                continue
            ok, _, _, fl = one_slips(rows, count, i, side, case.inertia, TOLERANCE)
            if ok:
                set_mode(s, SLIDE_ROCK, rows[i].index, int(side), -1, 0)
                s.alpha = fl / case.inertia
                project_on_plane(contacts[s.i], s)
                return True
    return False


@inner
def try_to_slide(rows, count, contacts, case, s, flat):
    """Try active sets of two slipping contacts, on one plane (``flat``) or on two; whether one is consistent.

    On two planes several may be consistent where a corner at a wall does not move; the one with the least
    force is free of self-stress.
    """
    consistent, least = False, math.inf
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
                        consistent, least = True, size
                        set_mode(s, SLIDE if flat else LEAN, first, int(side_i), second, int(side_j))
                        s.alpha = fl / I
    if consistent:
        _project_pair(contacts, case, s)
    return consistent


@inner
def set_pivot_velocity(con, s):
    """Set the velocity of G to that of a pure rotation about the contact's corner."""
    sigma, kappa = arm(con, s)
    tangential, normal = s.omega * kappa, s.omega * sigma
    s.vx = con.cos * tangential - con.sin * normal
    s.vz = con.sin * tangential + con.cos * normal


@inner
def project_on_plane(con, s):
    """Project the state so that the contact's corner is on its plane and moves along it."""
    sigma, kappa = arm(con, s)
    tangential, _ = to_plane_axes(con, s.vx, s.vz)
    normal = s.omega * sigma
    s.vx = con.cos * tangential - con.sin * normal
    s.vz = con.sin * tangential + con.cos * normal
    along_plane, _ = to_plane_axes(con, s.x, s.z)
    height = kappa - con.offset
    s.x = con.cos * along_plane - con.sin * height
    s.z = con.sin * along_plane + con.cos * height


@inner
def _project_pair(contacts, case, s):
    """Project the state so that both contacts are closed: flat on their plane, or leaning on two."""
    first, second = contacts[s.i], contacts[s.j]
    if s.kind == SLIDE:
        s.omega = s.alpha = 0.0
        if s.closed == FLOOR_BITS and abs(s.theta - s.rest) < FLAT_TOLERANCE:
            stand_flat(case, s)
        project_on_plane(first, s)
        return
    project_on_both(first, second, case.inertia, s)


@inner
def _remove_component(j, e):
    """Remove the component of a vector along a unit vector."""
    p = j[0] * e[0] + j[1] * e[1] + j[2] * e[2]
    return j[0] - p * e[0], j[1] - p * e[1], j[2] - p * e[2]


@inner
def remove_gap_rates(contacts, closed, settle_rate, I, s):
    """Project away the gap rates of closed contacts, which are at most ``settle_rate``.

    Contacts that stick keep sticking; slip is left to friction, whatever its rate. The change is the least in
    the mass metric, so energy never grows: (v_x, v_z, √I ω) loses its component in the space of these normals
    and tangents, found by Gram–Schmidt. A direction in which more than `MAX_SETTLING` times ``settle_rate``
    would be lost is skipped: a corner right above another hardly moves in a rotation about it, however fast.
    """
    root = math.sqrt(I)
    v = (s.vx, s.vz, root * s.omega)
    zero = (0.0, 0.0, 0.0)
    e1, e2, e3 = zero, zero, zero
    for tangential in (False, True):
        c = 0
        while closed >> c:
            con = contacts[c]
            if closed >> c & 1 and not (tangential and abs(slip_rate(con, s)) > STICK_RATE):
                sigma, kappa = arm(con, s)
                j = (con.cos, con.sin, -kappa / root) if tangential else (-con.sin, con.cos, -sigma / root)
                new = _remove_component(_remove_component(_remove_component(j, e1), e2), e3)
                size = math.sqrt(new[0] * new[0] + new[1] * new[1] + new[2] * new[2])
                if size > 1e-6:  # else the direction depends on those before
                    e = new[0] / size, new[1] / size, new[2] / size
                    if abs(v[0] * e[0] + v[1] * e[1] + v[2] * e[2]) <= MAX_SETTLING * settle_rate:
                        e1, e2, e3 = e, e1, e2
                        v = _remove_component(v, e1)
            c += 1
    s.vx, s.vz, s.omega = v[0], v[1], v[2] / root


@inner
def _least_change(first, second, gap1, gap2, I, s):
    """Least change of x, z and θ, or of their rates, that brings two gaps, or gap rates, to zero."""
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
def _remove_both_gap_rates(first, second, I, s):
    rate1, rate2 = gap_rate(first, s), gap_rate(second, s)
    dx, dz, turn = _least_change(first, second, rate1, rate2, I, s)
    s.vx, s.vz, s.omega = s.vx + dx, s.vz + dz, s.omega + turn


@inner
def project_on_both(first, second, I, s):
    """Project the state, by the least change in the mass metric, so that both contacts are closed."""
    dx, dz, turn = _least_change(first, second, gap(first, s), gap(second, s), I, s)
    s.x, s.z = s.x + dx, s.z + dz
    turn_to(s, s.theta + turn)
    _remove_both_gap_rates(first, second, I, s)
