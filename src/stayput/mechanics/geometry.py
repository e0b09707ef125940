"""Bodies, contacts and coordinates, as the compiled functions see them, and projection onto closed contacts.

A body can touch the room with its four corners A, B (base) and C, D (top); each pair of a corner and a
plane that it can meet is one *contact*, numbered 0..7. Where the base corners stand inside the side faces
(feet, a plinth), the lower ends of these meet the walls; see `contact_point`.

Every plane is described in its own axes: the tangent t and the normal n into the room, turned by φ from the
floor's. In those axes each contact obeys the floor's equations, with the loads (A, Γ) = (t·(ẍ_G, G),
n·(ẍ_G, G)), G = g + z̈_G, and the corner at σ = r sin(β−θ) along t from the centre of gravity and
κ = r cos(β−θ) below it, along n.
"""

import math

from stayput.compiling import inline, inner
from stayput.mechanics import columns as col
from stayput.mechanics.elementary import sine_and_cosine, slope_angle

GAP_TOLERANCE = 1e-10
"""Gap up to which a contact is closed [m]."""

STICK_RATE = 1e-10
"""Slip rate up to which a contact sticks [m/s]."""

RIGHT_ANGLE = math.pi / 2

MIN_REBOUND = 1e-9
"""Rebound height, as a part of the base length, below which a bounce has ended.

At 1e-7, what was left of a rate decided how far 3 in 100 bodies went that the load was about to tip.
"""


@inner
def turn_to(s, theta):
    """Set the tilt of the state."""
    s.theta = theta
    s.sin, s.cos = sine_and_cosine(theta)


@inline
def sin_cos(theta, theta0, sin0, cos0):
    """Sine and cosine of a tilt near theta0, whose own are known: a Taylor series, to rounding."""
    turn = theta - theta0
    if abs(turn) > 0.1:
        return sine_and_cosine(theta)
    t2 = turn * turn
    t4 = t2 * t2
    s = turn * (1.0 - t2 * (1.0 / 6.0) + t4 * (1.0 / 120.0 - t2 * (1.0 / 5040.0) + t4 * (1.0 / 362880.0)))
    c = t2 * (0.5 - t2 * (1.0 / 24.0) + t4 * (1.0 / 720.0 - t2 * (1.0 / 40320.0) + t4 * (1.0 / 3628800.0)))
    return sin0 + (cos0 * s - sin0 * c), cos0 - (sin0 * s + cos0 * c)


@inline
def corner_right(case, corner, s):
    """Horizontal distance of a corner from G, + right [m]."""
    return case.u[corner] * s.cos + case.v[corner] * s.sin


@inline
def corner_up(case, corner, s):
    """Vertical distance of a corner from G, + up [m]."""
    return case.v[corner] * s.cos - case.u[corner] * s.sin


@inner
def stand_flat(case, s):
    """Set the body down on both base corners, its horizontal position unchanged."""
    turn_to(s, s.rest)
    s.z = -corner_up(case, 0, s)


@inline
def contact_point(case, c):
    """Point of the body that a contact is about, relative to G, + right and + up [m].

    It is the contact's corner; of a base corner at a wall, the lower end of the side face above it.
    """
    corner = col.CORNER[c]
    side = corner + 2 if corner < 2 and col.PLANE[c] != 0 else corner
    return case.u[side], case.v[corner]


@inline
def own_friction(case, c):
    """Static and kinetic friction of a base corner alone, NaN where it has none; ``c`` is its contact."""
    if c == col.A_FLOOR:
        return case.left_edge_static_friction, case.left_edge_kinetic_friction
    return case.right_edge_static_friction, case.right_edge_kinetic_friction


@inline
def value_or(value, other):
    """Return the value, or the other one where it is NaN."""
    return other if math.isnan(value) else value


@inner
def set_up(case, contacts, s):
    """Fill the contact table of a case and the constants of its state, with the body at rest at slide 0."""
    run, rise = case.u[1] - case.u[0], case.v[1] - case.v[0]
    s.rest = slope_angle(run, rise)
    stand_flat(case, s)
    s.x = -0.5 * (corner_right(case, 0, s) + corner_right(case, 1, s))
    s.foot_a, s.foot_b = s.x + corner_right(case, 0, s), s.x + corner_right(case, 1, s)
    base = math.sqrt(run * run + rise * rise)
    s.settle_rate = math.sqrt(2.0 * MIN_REBOUND * base * case.gravity)
    s.present = col.FLOOR_BITS
    if math.isfinite(case.right_distance):
        s.present |= 0b00001100
    if math.isfinite(case.left_distance):
        s.present |= 0b00110000
    if math.isfinite(case.ceiling_distance):
        s.present |= 0b11000000
    # the clear distance to a wall is that of the body at rest at slide 0
    low_right = s.x + (case.u[3] * s.cos + case.v[1] * s.sin)
    low_left = s.x + (case.u[2] * s.cos + case.v[0] * s.sin)
    rightmost = max(low_right, s.x + corner_right(case, 3, s))
    leftmost = min(low_left, s.x + corner_right(case, 2, s))
    for c in range(col.CONTACTS):
        if not s.present >> c & 1:
            continue
        plane = col.PLANE[c]
        u, v = contact_point(case, c)
        con = contacts[c]
        if plane == 0:
            con.cos, con.sin, con.offset = 1.0, 0.0, 0.0
            static, kinetic = own_friction(case, c)
            con.mu_static = value_or(static, case.edge_static_friction)
            con.mu_kinetic = value_or(kinetic, case.edge_kinetic_friction)
            con.restitution = case.normal_restitution
        elif plane == 1:
            con.cos, con.sin, con.offset = 0.0, 1.0, rightmost + case.right_distance
            con.mu_static = con.mu_kinetic = case.right_friction
            con.restitution = case.right_restitution
        elif plane == 2:
            con.cos, con.sin, con.offset = 0.0, -1.0, case.left_distance - leftmost
            con.mu_static = con.mu_kinetic = case.left_friction
            con.restitution = case.left_restitution
        else:
            con.cos, con.sin, con.offset = -1.0, 0.0, case.ceiling_distance
            con.mu_static = con.mu_kinetic = case.ceiling_friction
            con.restitution = case.ceiling_restitution
        con.sigma, con.kappa = con.cos * u + con.sin * v, con.sin * u - con.cos * v


@inline
def arm_at(con, sin, cos):
    """Lever arms σ and κ of a contact at the tilt with this sine and cosine [m]."""
    return con.sigma * cos - con.kappa * sin, con.kappa * cos + con.sigma * sin


@inline
def arm(con, s):
    """Lever arms σ and κ of a contact in the present state [m]."""
    return arm_at(con, s.sin, s.cos)


@inline
def to_plane_axes(con, x, z):
    """Components of a vector along the plane's tangent and normal."""
    return con.cos * x + con.sin * z, con.cos * z - con.sin * x


@inline
def to_room_axes(con, tangential, normal):
    """Right and up components of a vector that is given along the plane's tangent and normal."""
    return con.cos * tangential - con.sin * normal, con.sin * tangential + con.cos * normal


@inline
def gap(con, s):
    """Distance of the contact's corner from its plane [m]."""
    _, kappa = arm(con, s)
    return to_plane_axes(con, s.x, s.z)[1] + con.offset - kappa


@inline
def gap_rate(con, s):
    """Rate of change of the gap, + opening [m/s]."""
    sigma, _ = arm(con, s)
    return to_plane_axes(con, s.vx, s.vz)[1] - s.omega * sigma


@inline
def gap_rates(con, y, k, sin, cos):
    """Gap of a contact in a state y, as of `state_of`, with accelerations k: value, first and second rate."""
    sigma, kappa = arm_at(con, sin, cos)
    height, rate = to_plane_axes(con, y[0], y[1])[1], to_plane_axes(con, y[3], y[4])[1]
    bend = to_plane_axes(con, k[0], k[1])[1] - k[2] * sigma + y[5] * y[5] * kappa
    return height + con.offset - kappa, rate - y[5] * sigma, bend


@inline
def state_of(s):
    """Read (x, z, θ, ẋ, ż, θ̇) from the state record."""
    return s.x, s.z, s.theta, s.vx, s.vz, s.omega


@inline
def slip_rate(con, s):
    """Velocity of the contact's corner along its plane [m/s]."""
    _, kappa = arm(con, s)
    return to_plane_axes(con, s.vx, s.vz)[0] - s.omega * kappa


@inner
def touching(contacts, s):
    """Bits of the contacts whose gap is within `GAP_TOLERANCE`."""
    bits = 0
    for c in range(col.CONTACTS):
        if s.present >> c & 1 and gap(contacts[c], s) <= GAP_TOLERANCE:
            bits |= 1 << c
    return bits


@inline
def reason_of_end(s):
    """Why a step ended in an event: a contact closed (s.hit), the body overturned, or a limit was reached."""
    if s.hit:
        return col.CLOSED
    return col.TURNED_OVER if abs(s.theta) >= RIGHT_ANGLE else col.LIMIT


@inner
def slide_of(case, s):
    """Slide and its rate, measured at the fulcrum (the lower base corner) [m, m/s]."""
    lower = 1 if s.theta > s.rest else 0
    foot = s.foot_b if lower == 1 else s.foot_a
    return s.x + corner_right(case, lower, s) - foot, s.vx + s.omega * corner_up(case, lower, s)


@inner
def update_peaks(case, s):
    """Update the peak tilt (from rest) and the peak slide."""
    s.peak_tilt = max(s.peak_tilt, abs(s.theta - s.rest))
    s.peak_slide = max(s.peak_slide, abs(slide_of(case, s)[0]))


FLAT_TOLERANCE = 1e-8
"""Rotation off flat below which a body on both base corners is set exactly flat [rad]."""

MAX_SETTLING = 10.0
"""Largest velocity removed when a bounce ends, in multiples of the rate at which its gap may still open."""


@inner
def set_pivot_velocity(con, s):
    """Set the velocity of G to that of a pure rotation about the contact's corner."""
    sigma, kappa = arm(con, s)
    s.vx, s.vz = to_room_axes(con, s.omega * kappa, s.omega * sigma)


@inner
def project_on_plane(con, s):
    """Project the state so that the contact's corner is on its plane and moves along it."""
    sigma, kappa = arm(con, s)
    s.vx, s.vz = to_room_axes(con, to_plane_axes(con, s.vx, s.vz)[0], s.omega * sigma)
    s.x, s.z = to_room_axes(con, to_plane_axes(con, s.x, s.z)[0], kappa - con.offset)


@inner
def project_pair(contacts, case, s):
    """Project the state so that both contacts are closed: flat on their plane, or leaning on two."""
    first, second = contacts[s.i], contacts[s.j]
    if s.kind == col.SLIDE:
        s.omega = s.alpha = 0.0
        if s.closed == col.FLOOR_BITS and abs(s.theta - s.rest) < FLAT_TOLERANCE:
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
        for c in range(col.CONTACTS):
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
    return (-(p * first.sin + q * second.sin), p * first.cos + q * second.cos, -(p * sigma1 + q * sigma2) / I)


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
