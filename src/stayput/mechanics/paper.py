"""The paper's rules (``contact="paper"``), as written: the fulcrum never lifts, nothing moves up.

Sliding starts at |ẍ_G| > μg, rocking at |ẍ_G| > (b/h)g whether or not the base slides; while the body
rocks the fulcrum sticks, or slips with the rotational coefficients. A landing follows Eq. 3.14 and leaves
the slip rate as it is. A hit on a wall turns the rotation rate round (Eq. 3.15, θ̇' = −e_w θ̇) and, where
the base itself meets the wall, the slip rate.
"""

from __future__ import annotations

import math

from stayput.mechanics.columns import A_FLOOR, B_FLOOR, CONTACTS, CORNER, FLAT, FLOOR_BITS, HELD, PLANE, SLIP, STICK
from stayput.mechanics.compiled import inner
from stayput.mechanics.contact import STUCK
from stayput.mechanics.fulcrum import margins
from stayput.mechanics.geometry import arm, arm_at, slip_rate, stand_flat, turn_to
from stayput.mechanics.modes import MOMENT, pivot_on

WALL_BITS = 0b11111100  # and the ceiling
RIGHT_BITS, LEFT_BITS, CEILING_BITS = 0b00001100, 0b00110000, 0b11000000


@inner
def _place_on(contacts, case, s, fulcrum, slip):
    """Let the body rock on a corner that moves along the floor at the rate ``slip``."""
    pivot_on(contacts[fulcrum], s)
    s.vx += slip
    s.i, s.j, s.dj = fulcrum, -1, 0
    s.closed = 1 << fulcrum


@inner
def choose_paper_mode(contacts, case, s, touch, a, a_rate):
    """Set the mode that the paper's rules give, for the load a moment ahead."""
    a += MOMENT * a_rate
    if s.theta == s.rest and s.omega == 0.0:
        _choose_flat(contacts, case, s, touch, a)
    elif not _leans(contacts, case, s, touch, a):
        right = s.theta > s.rest or (s.theta == s.rest and s.omega > 0.0)
        fulcrum = B_FLOOR if right else A_FLOOR
        _choose_fulcrum(contacts, case, s, fulcrum, slip_rate(contacts[fulcrum], s), a)
    s.alpha = 0.0


@inner
def _choose_flat(contacts, case, s, touch, a):
    g = case.gravity
    stand_flat(case, s)
    sigma_a, kappa_a = arm(contacts[A_FLOOR], s)
    sigma_b, kappa_b = arm(contacts[B_FLOOR], s)
    low, high = -sigma_b / kappa_b, -sigma_a / kappa_a  # of ẍ_G/g: beyond them the body rocks
    slide_low = slide_high = case.static_friction
    slip = s.vx if abs(s.vx) > STUCK else 0.0
    s.vz = 0.0
    if touch & RIGHT_BITS:  # flush against a wall it neither rocks nor slides that way
        low, slide_low, slip = -math.inf, math.inf, min(slip, 0.0)
    if touch & LEFT_BITS:
        high, slide_high, slip = math.inf, math.inf, max(slip, 0.0)
    if touch & CEILING_BITS:  # nor does it rock under a ceiling that it touches
        low, high = -math.inf, math.inf
    if a < low * g and _starts_rocking(contacts, case, s, B_FLOOR, slip, a):
        return
    if a > high * g and _starts_rocking(contacts, case, s, A_FLOOR, slip, a):
        return
    s.i, s.j, s.closed = A_FLOOR, B_FLOOR, FLOOR_BITS | touch & WALL_BITS
    s.vx = slip
    if slip == 0.0 and max(low, -slide_low) * g <= a <= min(high, slide_high) * g:
        s.kind = HELD
        _bound(s, max(low, -slide_low), min(high, slide_high))
        return
    s.kind = FLAT
    _bound(s, low if a >= low * g else -math.inf, high if a <= high * g else math.inf)  # else it cannot rock
    s.d = s.dj = int(math.copysign(1.0, slip if slip != 0.0 else -a))


@inner
def _bound(s, low, high):
    """Keep the mode while ẍ_G/g is between these."""
    s.low, s.low_up = (low, 1.0) if low > -math.inf else (-1.0, 0.0)
    s.high, s.high_up = (high, 1.0) if high < math.inf else (1.0, 0.0)


@inner
def _starts_rocking(contacts, case, s, fulcrum, slip, a):
    """Rock on a corner that slips on, where that opens the other corner, or else on one that sticks."""
    con = contacts[fulcrum]
    I, g = case.inertia, case.gravity
    sigma, kappa = arm(con, s)
    q = -1.0 / (I + sigma * sigma + kappa * kappa)
    if slip != 0.0:
        d = math.copysign(1.0, slip)
        alpha = margins((False, I, q, con.mu_kinetic, d), sigma, kappa, 0.0, a, g, slip)[2]
        if (alpha > 0.0) == (fulcrum == B_FLOOR):
            _slip(contacts, case, s, fulcrum, slip, d)
            return True
    f, f2, alpha = margins((True, I, q, con.mu_static, 0.0), sigma, kappa, 0.0, a, g, 0.0)
    if f >= 0.0 and f2 >= 0.0:
        s.kind, s.d = STICK, 0
        _place_on(contacts, case, s, fulcrum, 0.0)
        return True
    d = -1.0 if f < 0.0 else 1.0
    alpha = margins((False, I, q, con.mu_kinetic, d), sigma, kappa, 0.0, a, g, 0.0)[2]
    if slip == 0.0 and (alpha > 0.0) == (fulcrum == B_FLOOR):
        _slip(contacts, case, s, fulcrum, 0.0, d)
        return True
    return False


@inner
def _choose_fulcrum(contacts, case, s, fulcrum, slip, a):
    """Rock on: the fulcrum slips on, sticks where it can, or starts to slip."""
    con = contacts[fulcrum]
    if abs(slip) > STUCK:
        _slip(contacts, case, s, fulcrum, slip, math.copysign(1.0, slip))
        return
    turn = MOMENT * s.omega
    sigma, kappa = arm_at(con, s.sin + turn * s.cos, s.cos - turn * s.sin)
    omega = s.omega + MOMENT * s.alpha
    q = -1.0 / (case.inertia + sigma * sigma + kappa * kappa)
    f, f2, _ = margins(
        (True, case.inertia, q, con.mu_static, 0.0), sigma, kappa, omega, a, case.gravity, 0.0
    )
    if f >= 0.0 and f2 >= 0.0:
        s.kind, s.d = STICK, 0
        _place_on(contacts, case, s, fulcrum, 0.0)
        return
    _slip(contacts, case, s, fulcrum, slip, -1.0 if f < 0.0 else 1.0)


@inner
def _slip(contacts, case, s, fulcrum, slip, d):
    s.kind = SLIP
    s.d = int(d)
    _place_on(contacts, case, s, fulcrum, slip)


@inner
def _leans(contacts, case, s, touch, a):
    """Hold a tilted body against a wall while its weight and the load press it there."""
    if not touch & WALL_BITS or s.omega != 0.0:
        return False
    fulcrum = B_FLOOR if s.theta > s.rest else A_FLOOR
    sigma, kappa = arm(contacts[fulcrum], s)
    ratio = -sigma / kappa
    presses = a < ratio * case.gravity if fulcrum == B_FLOOR else a > ratio * case.gravity
    if not presses:
        return False
    s.kind = HELD
    s.closed = 1 << fulcrum | touch & WALL_BITS
    _bound(s, -math.inf if fulcrum == B_FLOOR else ratio, ratio if fulcrum == B_FLOOR else math.inf)
    s.vx = s.vz = 0.0
    return True


@inner
def collide_by_paper(contacts, case, s):
    """Change the velocities of the state by the paper's collision rules."""
    old = s.i if s.kind != FLAT else A_FLOOR
    slip = slip_rate(contacts[old], s)
    if s.hit & FLOOR_BITS:
        new = B_FLOOR if s.hit & 2 else A_FLOOR
        turn_to(s, s.rest)
        sigma, kappa = arm(contacts[new], s)
        sigma_old, kappa_old = arm(contacts[old], s)
        kept = case.inertia + sigma * sigma_old + kappa * kappa_old
        s.omega *= max(0.0, case.restitution * kept / (case.inertia + sigma * sigma + kappa * kappa))
        if abs(s.omega * (sigma - sigma_old)) <= s.settle:
            s.omega = 0.0
        _place_on(contacts, case, s, new, slip)
        return
    c = 0
    while c < CONTACTS - 1 and not s.hit >> c & 1:
        c += 1
    wall = contacts[c]
    reach = slip * (0.0, 1.0, -1.0, 0.0)[PLANE[c]]  # towards the wall; the ceiling leaves the slip as it is
    if CORNER[c] >= 2:
        s.omega *= -wall.restitution
        _, lever = arm(contacts[old], s)
        if abs(s.omega * lever) <= s.settle:
            s.omega = 0.0
    if (CORNER[c] < 2 or s.kind == SLIP) and reach > 0.0:
        slip *= -wall.restitution
    if s.kind == FLAT:
        s.vx = slip if abs(slip) > s.settle else 0.0
        return
    _place_on(contacts, case, s, old, slip)
