"""Impacts under ``contact="coulomb"``: impulses at all closed contacts at once.

Newton's restitution in the normal direction, Amontons–Coulomb friction between the impulses, then the
factor e of Eq. 3.14 on the rotation rate where the fulcrum changes. Newton's restitution with friction
can create energy (Kane's paradox); where it would, the impulses are those of a plastic impact, scaled by
1 + e, which never do.
"""

from __future__ import annotations

import math

from stayput.compiled import inner
from stayput.mechanics.columns import FLOOR_BITS, PLANE
from stayput.mechanics.contact import (
    STUCK,
    both_slip,
    one_slips,
    one_sticks,
    sticks_beside,
    tabulate,
)
from stayput.mechanics.geometry import along, arm, gap_rate, slip_rate

TOLERANCE = 1e-13
"""Slack of the inequalities between rates [m/s]."""

CLOSING = 1e-11
"""A contact that closes faster than this takes an impulse [m/s]."""

ROUNDS = 200
"""Single impulses in a row before a pile-up of contacts is taken to stop dead."""


@inner
def _tabulate(rows, contacts, closed, case, s):
    """List the contacts of an impact, with the rates before it and the normal rates wanted after it."""
    count = tabulate(rows, contacts, closed, s.sin, s.cos, case)
    for k in range(count):
        row = rows[k]
        con = contacts[row.index]
        row.bias_n, row.bias_t = gap_rate(con, s), slip_rate(con, s)
        rebound = -con.restitution * min(row.bias_n, 0.0)
        row.target = rebound if rebound > s.settle else 0.0
        if abs(row.bias_t) <= STUCK:
            row.mu_slip = row.mu_stick
            row.flat_slip_right = row.flat_slip_left = row.flat_stick
        else:
            row.mu_stick = row.mu_slip
            row.flat_stick = row.flat_slip_right if row.bias_t > 0.0 else row.flat_slip_left
        row.slipping = 0.0  # the direction of slip during an impact is part of the solution
    return count


@inner
def _lesser(best, ok, fx, fz, fl, I):
    """Of two sets of impulses the consistent one, or of two such the one that changes the motion less."""
    size = fx * fx + fz * fz + fl * fl / I
    if ok and (not best[0] or size < best[1]):
        return True, size, fx, fz, fl
    return best


@inner
def _consistent(rows, count, I):
    """Find the consistent set of impulses: one contact, else two; where more than one is, the least."""
    best = (False, 0.0, 0.0, 0.0, 0.0)
    for i in range(count):
        if rows[i].bias_n >= -CLOSING:
            continue
        ok, fx, fz, fl = one_sticks(rows, count, i, I, TOLERANCE)
        best = _lesser(best, ok, fx, fz, fl, I)
        if ok:
            continue
        for side in (1.0, -1.0):
            ok, fx, fz, fl = one_slips(rows, count, i, side, I, TOLERANCE)
            best = _lesser(best, ok, fx, fz, fl, I)
    if best[0]:
        return best[0], best[2], best[3], best[4]
    for i in range(count):
        for j in range(count):
            if i == j:
                continue
            for side in (1.0, -1.0):
                ok, fx, fz, fl = sticks_beside(rows, count, i, j, side, I, TOLERANCE)
                best = _lesser(best, ok, fx, fz, fl, I)
                if j < i:
                    continue
                same = PLANE[rows[i].index] == PLANE[rows[j].index]
                for side_j in (1.0, -1.0):
                    if same and side_j != side:
                        continue
                    ok, fx, fz, fl = both_slip(rows, count, i, side, j, side_j, I, TOLERANCE)
                    best = _lesser(best, ok, fx, fz, fl, I)
    return best[0], best[2], best[3], best[4]


@inner
def _one_after_another(rows, contacts, closed, case, s):
    """Where more than two contacts must press: single impulses at the contact that closes fastest."""
    I = case.inertia
    for _ in range(ROUNDS):
        count = _tabulate(rows, contacts, closed, case, s)
        worst, fastest = -1, -1e-9
        for k in range(count):
            if rows[k].bias_n < fastest:
                worst, fastest = k, rows[k].bias_n
        if worst < 0:
            return
        ok, fx, fz, fl = one_sticks(rows, 0, worst, I, TOLERANCE)
        if not ok:
            ok, fx, fz, fl = one_slips(rows, 0, worst, 1.0, I, TOLERANCE)
        if not ok:
            ok, fx, fz, fl = one_slips(rows, 0, worst, -1.0, I, TOLERANCE)
        if not ok:
            break
        s.vx += fx
        s.vz += fz
        s.omega += fl / I
    s.vx = s.vz = s.omega = 0.0


@inner
def _energy(I, vx, vz, omega):
    return vx * vx + vz * vz + I * omega * omega


@inner
def collide(rows, contacts, closed, case, s):
    """Change the velocities of the state by the impact at the closed contacts."""
    I = case.inertia
    before = _energy(I, s.vx, s.vz, s.omega)
    count = _tabulate(rows, contacts, closed, case, s)
    landing = False
    for k in range(count):
        landing = landing or rows[k].bias_n < -CLOSING
    if not landing:
        return
    ok, fx, fz, fl = _consistent(rows, count, I)
    if not ok:
        _one_after_another(rows, contacts, closed, case, s)
        return
    if _energy(I, s.vx + fx, s.vz + fz, s.omega + fl / I) > before * (1.0 + 1e-12):
        factor = 1.0
        for k in range(count):
            if rows[k].bias_n < -CLOSING:
                factor = min(factor, rows[k].target / -rows[k].bias_n)
            rows[k].target = 0.0
        ok, fx, fz, fl = _consistent(rows, count, I)
        fx, fz, fl = (1.0 + factor) * fx, (1.0 + factor) * fz, (1.0 + factor) * fl
    s.vx += fx
    s.vz += fz
    s.omega += fl / I


@inner
def damp_change_of_fulcrum(contacts, fulcrum, case, s):
    """Multiply the rotation rate by the floor's restitution, the velocity of the new fulcrum kept.

    On a slipping fulcrum less rotation can mean more energy; the factor is then the one that keeps it.
    """
    con = contacts[fulcrum]
    sigma, kappa = arm(con, s)
    slip = slip_rate(con, s)
    tangential, normal = along(con, s.vx, s.vz)
    lift = normal - s.omega * sigma
    inertia = case.inertia + sigma * sigma + kappa * kappa
    if s.omega == 0.0:
        return
    same_energy = -2.0 * (kappa * slip + sigma * lift) / (inertia * s.omega) - 1.0
    factor = min(1.0, max(case.restitution, same_energy))
    change = (factor - 1.0) * s.omega
    s.omega += change
    tangential, normal = tangential + kappa * change, normal + sigma * change
    s.vx = con.cos * tangential - con.sin * normal
    s.vz = con.sin * tangential + con.cos * normal


@inner
def closing(contacts, bits, s):
    """Those of the contacts whose gap is closing."""
    found = 0
    c = 0
    while bits >> c:
        if bits >> c & 1 and gap_rate(contacts[c], s) < -CLOSING:
            found |= 1 << c
        c += 1
    return found


@inner
def land(rows, contacts, closed, arrived, case, s):
    """Carry out the impact of the contacts ``arrived`` together with all that are closed."""
    collide(rows, contacts, closed | arrived, case, s)
    landed = arrived & FLOOR_BITS
    if case.restitution < 1.0 and (landed == 1 or landed == 2) and closed & FLOOR_BITS == FLOOR_BITS - landed:
        other = 2 - landed  # contact number of the old fulcrum: B (1) where A (bit 1) has landed
        if gap_rate(contacts[other], s) > STUCK:
            damp_change_of_fulcrum(contacts, landed - 1, case, s)


@inner
def stop(contacts, c, I, s):
    """Stop the corner of a contact by an impulse there; whether its friction and the others allow it."""
    con = contacts[c]
    sigma, kappa = arm(con, s)
    slip, lift = slip_rate(con, s), gap_rate(con, s)
    # impulses N and T that take the corner's rates away
    nn, tt, nt = 1.0 + sigma * sigma / I, 1.0 + kappa * kappa / I, sigma * kappa / I
    det = nn * tt - nt * nt
    N, T = (-lift * tt + slip * nt) / det, (-slip * nn + lift * nt) / det
    omega = s.omega - (sigma * N + kappa * T) / I
    vx, vz = s.vx + con.cos * T - con.sin * N, s.vz + con.sin * T + con.cos * N
    return N >= 0.0 and math.fabs(T) <= con.mu_static * N, vx, vz, omega


@inner
def unjam(contacts, touching, case, s):
    """Stop the corner that no force can keep slipping (Painlevé): an impact without a collision.

    The corner is one whose stop lets no other contact close; where there is none, all motion stops.
    """
    c = 0
    while touching >> c:
        if touching >> c & 1 and abs(slip_rate(contacts[c], s)) > STUCK:
            before = s.vx, s.vz, s.omega
            ok, s.vx, s.vz, s.omega = stop(contacts, c, case.inertia, s)
            if ok and not closing(contacts, touching & ~(1 << c), s):
                return
            s.vx, s.vz, s.omega = before
        c += 1
    s.vx = s.vz = s.omega = 0.0
