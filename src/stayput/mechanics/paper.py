"""The paper's contact rules (``contact="paper"``), as written: the fulcrum never lifts, no vertical motion.

Sliding starts at |ẍ_G| > μg, rocking at |ẍ_G| > (b/h)g whether or not the base slides; while the body
rocks the fulcrum sticks, or slips with the rotational coefficients. A landing follows Eq. 3.14 and leaves
the slip rate as it is. A wall impact reverses the rotation rate (Eq. 3.15, θ̇' = −e_w θ̇) and, where
the base itself meets the wall, the slip rate.
"""

import math

from stayput.compiling import inner
from stayput.mechanics import columns as col
from stayput.mechanics.contact import PAINLEVE_LIMIT
from stayput.mechanics.flat import load_weighted_friction
from stayput.mechanics.fulcrum import margins
from stayput.mechanics.geometry import (
    FLAT_TOLERANCE,
    STICK_RATE,
    arm,
    arm_at,
    gap_rate,
    own_friction,
    set_pivot_velocity,
    slip_rate,
    stand_flat,
    to_plane_axes,
    turn_to,
    value_or,
)
from stayput.mechanics.modes import LOOKAHEAD

WALL_BITS = 0b11111100  # and the ceiling
RIGHT_BITS, LEFT_BITS, CEILING_BITS = 0b00001100, 0b00110000, 0b11000000


@inner
def _rock_on(contacts, s, kind, fulcrum, slip, d, sign):
    """Set a rocking mode about a corner that moves along the floor at the rate ``slip``."""
    set_pivot_velocity(contacts[fulcrum], s)
    s.vx += slip
    s.kind, s.i, s.j, s.d, s.dj = kind, fulcrum, -1, int(d), int(sign)
    s.closed = 1 << fulcrum


@inner
def choose_paper_mode(contacts, case, s, touch, a, a_rate):
    """Set the mode that the paper's rules give, for the load `modes.LOOKAHEAD` later."""
    a += LOOKAHEAD * a_rate
    if abs(s.theta - s.rest) < FLAT_TOLERANCE and s.omega == 0.0:
        _choose_flat(contacts, case, s, touch, a)
        s.alpha = 0.0
        return
    right = s.theta > s.rest or (s.theta == s.rest and s.omega > 0.0)
    fulcrum = col.B_FLOOR if right else col.A_FLOOR
    slides = _slides_under_ceiling(contacts, case, s, touch, fulcrum)
    if not slides and not _leans(contacts, case, s, touch, fulcrum, a):
        _choose_fulcrum(contacts, case, s, touch, fulcrum, slip_rate(contacts[fulcrum], s), a)
    s.alpha = 0.0


@inner
def _choose_flat(contacts, case, s, touch, a):
    g = case.gravity
    stand_flat(case, s)
    sigma_a, kappa_a = arm(contacts[col.A_FLOOR], s)
    sigma_b, kappa_b = arm(contacts[col.B_FLOOR], s)
    low, high = -sigma_b / kappa_b, -sigma_a / kappa_a  # of ẍ_G/g: beyond them the body rocks
    left = value_or(own_friction(case, col.A_FLOOR)[0], case.static_friction)
    right = value_or(own_friction(case, col.B_FLOOR)[0], case.static_friction)
    slide_low = load_weighted_friction(contacts, s, left, right, 1.0)
    slide_high = load_weighted_friction(contacts, s, left, right, -1.0)
    slip = s.vx if abs(s.vx) > STICK_RATE else 0.0
    s.vz = 0.0
    if touch & RIGHT_BITS:  # flush against a wall it neither rocks nor slides that way
        low, slide_low, slip = -math.inf, math.inf, min(slip, 0.0)
    if touch & LEFT_BITS:
        high, slide_high, slip = math.inf, math.inf, max(slip, 0.0)
    if touch & CEILING_BITS:  # nor does it rock under a ceiling that it touches
        low, high = -math.inf, math.inf
    if a < low * g and _starts_rocking(contacts, case, s, col.B_FLOOR, slip, a):
        return
    if a > high * g and _starts_rocking(contacts, case, s, col.A_FLOOR, slip, a):
        return
    s.i, s.j, s.closed = col.A_FLOOR, col.B_FLOOR, col.FLOOR_BITS | touch & WALL_BITS
    s.vx = slip
    if slip == 0.0 and max(low, -slide_low) * g <= a <= min(high, slide_high) * g:
        s.kind = col.REST
        _bound(s, max(low, -slide_low), min(high, slide_high))
        return
    s.kind = col.SLIDE
    _bound(s, low if a >= low * g else -math.inf, high if a <= high * g else math.inf)  # else it cannot rock
    s.d = s.dj = int(math.copysign(1.0, slip if slip != 0.0 else -a))


@inner
def _bound(s, low, high):
    """Set the range of ẍ_G/g in which the mode lasts."""
    s.low, s.low_up = (low, 1.0) if low > -math.inf else (-1.0, 0.0)
    s.high, s.high_up = (high, 1.0) if high < math.inf else (1.0, 0.0)


@inner
def _opens(law, sigma, kappa, slip, a, g, fulcrum):
    """Whether rocking on a slipping fulcrum lifts the other corner of a flat body."""
    alpha = margins(law, sigma, kappa, 0.0, a, g, slip)[2]
    return (alpha > 0.0) == (fulcrum == col.B_FLOOR)


@inner
def _starts_rocking(contacts, case, s, fulcrum, slip, a):
    """Start rocking about a fulcrum that keeps slipping where that lifts the other corner, else sticks."""
    con = contacts[fulcrum]
    I, g = case.inertia, case.gravity
    sigma, kappa = arm(con, s)
    q = -1.0 / (I + sigma * sigma + kappa * kappa)
    if slip != 0.0:
        d = math.copysign(1.0, slip)
        if _opens((False, I, q, con.mu_kinetic, d, 1.0), sigma, kappa, slip, a, g, fulcrum):
            _rock_on(contacts, s, col.SLIDE_ROCK, fulcrum, slip, d, 1.0)
            return True
    f, f2, _ = margins((True, I, q, con.mu_static, 0.0, 1.0), sigma, kappa, 0.0, a, g, 0.0)
    if f >= 0.0 and f2 >= 0.0:
        _rock_on(contacts, s, col.ROCK, fulcrum, 0.0, 0.0, 1.0)
        return True
    d = -1.0 if f < 0.0 else 1.0
    if slip == 0.0 and _opens((False, I, q, con.mu_kinetic, d, 1.0), sigma, kappa, 0.0, a, g, fulcrum):
        _rock_on(contacts, s, col.SLIDE_ROCK, fulcrum, 0.0, d, 1.0)
        return True
    return False


@inner
def _choose_fulcrum(contacts, case, s, touch, fulcrum, slip, a):
    """Choose whether the fulcrum of a rocking body keeps slipping, sticks, or starts to slip.

    Under these rules the fulcrum can pull; its friction then follows the magnitude of the normal force. A
    slip that no friction is consistent with (Painlevé) stops.
    """
    con = contacts[fulcrum]
    I, g = case.inertia, case.gravity
    turn = LOOKAHEAD * s.omega
    sigma, kappa = arm_at(con, s.sin + turn * s.cos, s.cos - turn * s.sin)
    omega = s.omega + LOOKAHEAD * s.alpha
    q = -1.0 / (I + sigma * sigma + kappa * kappa)
    d = math.copysign(1.0, slip)
    if abs(slip) <= STICK_RATE:
        N = g + q * (kappa * a + sigma * g) * sigma - omega * omega * kappa
        sign = math.copysign(1.0, N)
        f, f2, _ = margins((True, I, q, con.mu_static, 0.0, sign), sigma, kappa, omega, a, g, 0.0)
        if f >= 0.0 and f2 >= 0.0:
            _rock_on(contacts, s, col.ROCK, fulcrum, 0.0, 0.0, sign)
            return
        d = -1.0 if f < 0.0 else 1.0
        if touch & 1 << (col.A_LEFT if d < 0.0 else col.B_RIGHT):
            _rock_on(contacts, s, col.ROCK, fulcrum, 0.0, d, sign)
            return
    sign = math.copysign(1.0, g - omega * omega * kappa)
    if I + (sigma - sign * con.mu_kinetic * d * kappa) * sigma > PAINLEVE_LIMIT * I:
        _rock_on(contacts, s, col.SLIDE_ROCK, fulcrum, slip, d, sign)
    else:
        _rock_on(contacts, s, col.ROCK, fulcrum, 0.0, 0.0, 1.0)


@inner
def _closes_by_turning(contacts, c, fulcrum, omega, s):
    """Whether a rotation about the fulcrum closes another contact."""
    sigma, kappa = arm(contacts[fulcrum], s)
    side, _ = arm(contacts[c], s)
    return omega * (to_plane_axes(contacts[c], kappa, sigma)[1] - side) < 0.0


@inner
def _slides_under_ceiling(contacts, case, s, touch, fulcrum):
    """Slide a tilted body, without rotation, where friction presses it to the ceiling; whether it does."""
    con = contacts[fulcrum]
    slip = slip_rate(con, s)
    if s.omega != 0.0 or abs(slip) <= STICK_RATE or not touch & CEILING_BITS:
        return False
    sigma, kappa = arm(con, s)
    alpha = math.copysign(1.0, slip) * con.mu_kinetic * kappa - sigma  # in sign
    for c in (col.C_CEILING, col.D_CEILING):
        if touch >> c & 1 and _closes_by_turning(contacts, c, fulcrum, alpha, s):
            s.kind = col.SLIDE
            s.i = s.j = fulcrum
            s.d = s.dj = int(math.copysign(1.0, slip))
            s.closed = 1 << fulcrum | touch & CEILING_BITS
            s.vx, s.vz = slip, 0.0
            _bound(s, -math.inf, math.inf)
            return True
    return False


@inner
def _leans(contacts, case, s, touch, fulcrum, a):
    """Rest a tilted body against a wall while weight and load press it there; whether they do."""
    if s.omega != 0.0:
        return False
    sigma, kappa = arm(contacts[fulcrum], s)
    ratio = -sigma / kappa
    alpha = ratio * case.gravity - a  # in sign
    walls = touch & WALL_BITS
    for c in range(col.CONTACTS):
        if walls >> c & 1 and _closes_by_turning(contacts, c, fulcrum, alpha, s):
            s.kind = col.REST
            s.closed = 1 << fulcrum | walls
            _bound(s, -math.inf if alpha > 0.0 else ratio, ratio if alpha > 0.0 else math.inf)
            s.vx = s.vz = 0.0
            return True
    return False


@inner
def collide_by_paper(contacts, case, s):
    """Apply the paper's impact rules to the velocities of the state."""
    old = s.i
    slip = slip_rate(contacts[old], s)
    if s.hit & col.FLOOR_BITS:
        new = col.B_FLOOR if s.hit & 2 else col.A_FLOOR
        turn_to(s, s.rest)
        sigma, kappa = arm(contacts[new], s)
        sigma_old, kappa_old = arm(contacts[old], s)
        transferred = case.inertia + sigma * sigma_old + kappa * kappa_old
        s.omega *= max(0.0, case.restitution * transferred / (case.inertia + sigma * sigma + kappa * kappa))
        if abs(s.omega * (sigma - sigma_old)) <= s.settle_rate:
            s.omega = 0.0
        _rock_on(contacts, s, s.kind, new, slip, s.d, s.dj)
        return
    for top in (False, True):  # base corners before top corners
        for c in range(col.CONTACTS):
            if s.hit >> c & 1 and (col.CORNER[c] >= 2) == top and gap_rate(contacts[c], s) < 0.0:
                _bounce(contacts, c, s)


@inner
def _bounce(contacts, c, s):
    """Reverse the motion that closes a contact with a wall or the ceiling: rotation, slip, or both."""
    wall, old = contacts[c], s.i
    slip = slip_rate(contacts[old], s)
    # + towards the wall; a ceiling does not affect the slip
    reach = slip * (0.0, 1.0, -1.0, 0.0)[col.PLANE[c]]
    if s.kind != col.SLIDE and _closes_by_turning(contacts, c, old, s.omega, s):
        s.omega *= -wall.restitution
        _, lever = arm(contacts[old], s)
        if abs(s.omega * lever) <= s.settle_rate:
            s.omega = 0.0
    if (col.CORNER[c] < 2 or s.kind != col.ROCK) and reach > 0.0:
        slip *= -wall.restitution
    if s.kind == col.SLIDE:
        s.vx = slip if abs(slip) > s.settle_rate else 0.0
        return
    _rock_on(contacts, s, s.kind, old, slip, s.d, s.dj)
