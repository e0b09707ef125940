"""Impacts under ``contact="coulomb"``: simultaneous impulses at all closed contacts.

Newton's restitution in the normal direction, Amontons–Coulomb friction between the impulses, then the
factor e of Eq. 3.14 on the rotation rate where the fulcrum changes. Newton's restitution with friction
can create energy (Kane's paradox); where it would, the impulses are those of a plastic impact, scaled by
1 + e. These never do: with the velocities v⁺ after the plastic impact the impulses' work on them, p·v⁺, is
that of friction on slip, not above zero, and the energy changes by (1 + e) p·v⁺ − ½(1 − e²) p·M⁻¹p.
"""

import math

from stayput.compiling import inner
from stayput.mechanics.columns import CONTACTS, FLOOR_BITS, PLANE, ROCK
from stayput.mechanics.contact import both_slip, fill_rows, one_slips, one_sticks, sticks_beside
from stayput.mechanics.fulcrum import NEAR_LIMIT, margins
from stayput.mechanics.geometry import (
    STICK_RATE,
    arm,
    gap_rate,
    set_pivot_velocity,
    slip_rate,
    to_plane_axes,
    to_room_axes,
)

TOLERANCE = 1e-13
"""Tolerance of the inequalities between velocities [m/s]."""

CLOSING = 1e-11
"""Closing rate above which a contact takes an impulse [m/s]."""

MAX_SEQUENTIAL_IMPULSES = 200
"""Single impulses in a row after which the body is brought to a complete stop."""


@inner
def _tabulate(rows, contacts, closed, case, s):
    """Fill the rows of an impact: velocities before it, and the normal velocities required after it."""
    count = fill_rows(rows, contacts, closed, s.sin, s.cos, case)
    for row in rows[:count]:
        con = contacts[row.index]
        row.bias_n, row.bias_t = gap_rate(con, s), slip_rate(con, s)
        rebound = -con.restitution * min(row.bias_n, 0.0)
        row.target = rebound if rebound > s.settle_rate else 0.0
        if abs(row.bias_t) <= STICK_RATE:
            row.mu_slip = row.mu_stick
            row.flat_slip_right = row.flat_slip_left = row.flat_stick
        else:
            row.mu_stick = row.mu_slip
            row.flat_stick = row.flat_slip_right if row.bias_t > 0.0 else row.flat_slip_left
        row.slipping = 0.0  # the direction of slip during an impact is part of the solution
    return count


@inner
def _smaller_change(best, ok, fx, fz, fl, I):
    """Of two sets of impulses the consistent one; where both are, the one with less change of motion."""
    size = fx * fx + fz * fz + fl * fl / I
    if ok and (not best[0] or size < best[1]):
        return True, size, fx, fz, fl
    return best


@inner
def _consistent_impulses(rows, count, I):
    """Find the consistent set of impulses: active sets of one contact first, then of two.

    Among consistent sets of the same size, the one that changes the motion least.
    """
    best = (False, 0.0, 0.0, 0.0, 0.0)
    for i in range(count):
        if rows[i].bias_n >= -CLOSING:
            continue
        ok, fx, fz, fl = one_sticks(rows, count, i, I, TOLERANCE)
        best = _smaller_change(best, ok, fx, fz, fl, I)
        if ok:
            continue
        for side in (1.0, -1.0):
            ok, fx, fz, fl = one_slips(rows, count, i, side, I, TOLERANCE)
            best = _smaller_change(best, ok, fx, fz, fl, I)
    if best[0]:
        return best[0], best[2], best[3], best[4]
    for i in range(count):
        for j in range(count):
            if i == j:
                continue
            for side in (1.0, -1.0):
                ok, fx, fz, fl = sticks_beside(rows, count, i, j, side, I, TOLERANCE)
                best = _smaller_change(best, ok, fx, fz, fl, I)
                if j < i:
                    continue
                same = PLANE[rows[i].index] == PLANE[rows[j].index]
                for side_j in (1.0, -1.0):
                    if same and side_j != side:
                        continue
                    ok, fx, fz, fl = both_slip(rows, count, i, side, j, side_j, I, TOLERANCE)
                    best = _smaller_change(best, ok, fx, fz, fl, I)
    return best[0], best[2], best[3], best[4]


@inner
def _sequential_impulses(rows, contacts, closed, case, s, plastic):
    """Sequential impulses, each at the contact that closes fastest: where no set of two is consistent.

    Plastic ones never create energy, each by itself.
    """
    I = case.inertia
    for _ in range(MAX_SEQUENTIAL_IMPULSES):
        count = _tabulate(rows, contacts, closed, case, s)
        worst, fastest = -1, -1e-9
        for k in range(count):
            if rows[k].bias_n < fastest:
                worst, fastest = k, rows[k].bias_n
        if worst < 0:
            return
        if plastic:
            rows[worst].target = 0.0
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
def energy(I, vx, vz, omega):
    """Twice the kinetic energy per unit mass [m²/s²]."""
    return vx * vx + vz * vz + I * omega * omega


@inner
def collide(rows, contacts, closed, case, s):
    """Apply the impact at the closed contacts to the velocities of the state."""
    I = case.inertia
    most = energy(I, s.vx, s.vz, s.omega) * (1.0 + 1e-12)
    count = _tabulate(rows, contacts, closed, case, s)
    landing = False
    for k in range(count):
        landing = landing or rows[k].bias_n < -CLOSING
    if not landing:
        return
    ok, fx, fz, fl = _consistent_impulses(rows, count, I)
    if ok and energy(I, s.vx + fx, s.vz + fz, s.omega + fl / I) > most:
        # Newton's restitution would create energy: plastic impulses instead, times 1 + the least restitution
        factor = 1.0
        for k in range(count):
            if rows[k].bias_n < -CLOSING:
                factor = min(factor, rows[k].target / -rows[k].bias_n)
            rows[k].target = 0.0
        ok, fx, fz, fl = _consistent_impulses(rows, count, I)
        fx, fz, fl = (1.0 + factor) * fx, (1.0 + factor) * fz, (1.0 + factor) * fl
    if ok:
        s.vx, s.vz, s.omega = s.vx + fx, s.vz + fz, s.omega + fl / I
        return
    start = s.vx, s.vz, s.omega
    _sequential_impulses(rows, contacts, closed, case, s, False)
    if energy(I, s.vx, s.vz, s.omega) > most:
        s.vx, s.vz, s.omega = start
        _sequential_impulses(rows, contacts, closed, case, s, True)


@inner
def scale_change_of_fulcrum(contacts, fulcrum, case, s, before):
    """Multiply the rotation rate by the floor's restitution, keeping the velocity of the new fulcrum.

    The factor is bounded where it would create energy: above 1 by the energy before the impact, twice per
    unit mass; on a slipping fulcrum, where less rotation can mean more energy, below 1 by that after it. A
    landing corner that bounces is no fulcrum: above 1 it has no factor.
    """
    con = contacts[fulcrum]
    sigma, kappa = arm(con, s)
    slip = slip_rate(con, s)
    tangential, normal = to_plane_axes(con, s.vx, s.vz)
    lift = normal - s.omega * sigma
    inertia = case.inertia + sigma * sigma + kappa * kappa
    if s.omega == 0.0 or (case.restitution > 1.0 and lift > STICK_RATE):
        return
    spin = inertia * s.omega
    across = kappa * slip + sigma * lift
    if case.restitution <= 1.0:
        factor = min(1.0, max(case.restitution, -2.0 * across / spin - 1.0))
    else:
        # the energy is spin ω f² + 2 across ω f + slip² + lift² with the factor f
        room = across * across + inertia * (before - slip * slip - lift * lift)
        most = (math.sqrt(max(0.0, room)) * math.copysign(1.0, s.omega) - across) / spin
        factor = max(1.0, min(case.restitution, most))
    change = (factor - 1.0) * s.omega
    s.omega += change
    s.vx, s.vz = to_room_axes(con, tangential + kappa * change, normal + sigma * change)


@inner
def closing_contacts(contacts, bits, s, speed):
    """Bits of those contacts whose gap closes faster than a speed."""
    closing_bits = 0
    for c in range(CONTACTS):
        if bits >> c & 1 and gap_rate(contacts[c], s) < -speed:
            closing_bits |= 1 << c
    return closing_bits


@inner
def land(rows, contacts, closed, arrived, case, s):
    """Apply the impact of the newly closed contacts ``arrived`` together with those already closed."""
    before = energy(case.inertia, s.vx, s.vz, s.omega)
    collide(rows, contacts, closed | arrived, case, s)
    landed = arrived & FLOOR_BITS
    if (
        case.restitution != 1.0
        and (landed == 1 or landed == 2)
        and closed & FLOOR_BITS == FLOOR_BITS - landed
    ):
        other = 2 - landed  # contact number of the old fulcrum: B (1) where A (bit 1) has landed
        if gap_rate(contacts[other], s) > STICK_RATE:
            scale_change_of_fulcrum(contacts, landed - 1, case, s, before)


@inner
def stop_corner(contacts, c, I, s):
    """Impulse that stops a contact's corner: whether its friction allows it, and the velocities after it."""
    con = contacts[c]
    sigma, kappa = arm(con, s)
    slip, lift = slip_rate(con, s), gap_rate(con, s)
    # impulses N and T that bring the corner's velocity to zero
    nn, tt, nt = 1.0 + sigma * sigma / I, 1.0 + kappa * kappa / I, sigma * kappa / I
    det = nn * tt - nt * nt
    N, T = (-lift * tt + slip * nt) / det, (-slip * nn + lift * nt) / det
    omega = s.omega - (sigma * N + kappa * T) / I
    vx, vz = s.vx + con.cos * T - con.sin * N, s.vz + con.sin * T + con.cos * N
    return N >= 0.0 and math.fabs(T) <= con.mu_static * N, vx, vz, omega


@inner
def impact_without_collision(contacts, touching, case, s):
    """Stop a corner whose slip no finite force is consistent with: Painlevé's impact without collision.

    The corner chosen is one whose stop closes no other contact; where there is none, all motion stops.
    """
    for c in range(CONTACTS):
        if touching >> c & 1 and abs(slip_rate(contacts[c], s)) > STICK_RATE:
            before = s.vx, s.vz, s.omega
            ok, s.vx, s.vz, s.omega = stop_corner(contacts, c, case.inertia, s)
            if ok and not closing_contacts(contacts, touching & ~(1 << c), s, CLOSING):
                return
            s.vx, s.vz, s.omega = before
    s.vx = s.vz = s.omega = 0.0


@inner
def stop_on_landing(contacts, touch, case, s):
    """Apply the impact, if the landing corner sticks and the other lifts; whether it did.

    The body rocked on one base corner, lands on the other, and touches nothing else. A landing that bounces,
    slips or ends the rocking is the general case.
    """
    if s.kind != ROCK or touch != FLOOR_BITS or s.hit | s.closed != FLOOR_BITS or s.hit == s.closed:
        return False
    new, old = s.hit - 1, s.closed - 1  # contacts 0 and 1 have the bits 1 and 2
    con = contacts[new]
    if con.restitution > 0.0 or abs(slip_rate(con, s)) > STICK_RATE:
        return False
    before = s.vx, s.vz, s.omega
    ok, s.vx, s.vz, s.omega = stop_corner(contacts, new, case.inertia, s)
    if ok and case.restitution != 1.0:
        scale_change_of_fulcrum(contacts, new, case, s, energy(case.inertia, before[0], before[1], before[2]))
    if ok and gap_rate(contacts[old], s) > s.settle_rate:
        return True
    s.vx, s.vz, s.omega = before
    return False


@inner
def pivot_on_landing(contacts, touch, case, s, a, G):
    """Handle the landing of a bare body under the loads (a, G), if the fast path applies; whether it did.

    A force near its limit is the general case too.
    """
    before = s.vx, s.vz, s.omega
    if not stop_on_landing(contacts, touch, case, s):
        return False
    new = s.hit - 1
    con = contacts[new]
    sigma, kappa = arm(con, s)
    q = -1.0 / (case.inertia + sigma * sigma + kappa * kappa)
    law = (True, case.inertia, q, con.mu_static, 0.0, 1.0)
    f, g, alpha = margins(law, sigma, kappa, s.omega, a, G, 0.0)
    if min(f, g) > NEAR_LIMIT * case.gravity:
        s.i, s.d, s.j, s.dj, s.closed, s.alpha = new, 0, -1, 0, s.hit, alpha
        set_pivot_velocity(con, s)
        return True
    s.vx, s.vz, s.omega = before
    return False
