"""Bodies, contacts and coordinates, as the compiled functions see them.

A body can touch the room with its four corners A, B (base) and C, D (top); each pair of a corner and a
plane that it can meet is one *contact*, numbered 0..7. Every plane is described in its own axes: the
tangent t and the normal n into the room, turned by φ from the floor's. In those axes each contact obeys
the floor's equations, with the loads (A, Γ) = (t·(ẍ_G, G), n·(ẍ_G, G)), G = g + z̈_G, and the corner at
p = (r sin(β−θ), −r cos(β−θ)) from the centre of gravity; β is the corner's angle in the plane's axes.
"""

from __future__ import annotations

import math

from stayput.mechanics.columns import CONTACTS, CORNER, FLOOR_BITS, PLANE
from stayput.mechanics.compiled import inner

GAP_TOLERANCE = 1e-10
"""A contact is closed when its gap is not larger than this [m]."""

HALF_TURN = math.pi / 2


@inner
def resting_tilt(case):
    """Tilt at which both base corners stand on the floor [rad]."""
    return math.atan2(case.v[1] - case.v[0], case.u[1] - case.u[0])


@inner
def half_base(case):
    """Half the distance between the base corners [m]."""
    return 0.5 * math.hypot(case.u[1] - case.u[0], case.v[1] - case.v[0])


@inner
def _across(case, corner, tilt):
    """Corner right of G at a tilt [m]."""
    return case.u[corner] * math.cos(tilt) + case.v[corner] * math.sin(tilt)


@inner
def resting_place(case, tilt):
    """G with both base corners on the floor and the middle of the base at x = 0 [m]."""
    return -0.5 * (_across(case, 0, tilt) + _across(case, 1, tilt)), (
        case.u[0] * math.sin(tilt) - case.v[0] * math.cos(tilt)
    )


@inner
def set_up_contacts(case, contacts):
    """Fill the contact table of a case and return the bits of the contacts that its room has."""
    present = FLOOR_BITS
    if math.isfinite(case.right_distance):
        present |= 0b00001100
    if math.isfinite(case.left_distance):
        present |= 0b00110000
    if math.isfinite(case.ceiling_distance):
        present |= 0b11000000
    # the clear distance to a wall is that of the body at rest, with the middle of its base at x = 0
    tilt = resting_tilt(case)
    x = resting_place(case, tilt)[0]
    rightmost = x + max(_across(case, 1, tilt), _across(case, 3, tilt))
    leftmost = x + min(_across(case, 0, tilt), _across(case, 2, tilt))
    for c in range(CONTACTS):
        if not present >> c & 1:
            continue
        plane = PLANE[c]
        u, v = case.u[CORNER[c]], case.v[CORNER[c]]
        row = contacts[c]
        row.r = math.sqrt(u * u + v * v)
        beta = math.atan2(u, -v)
        if plane == 0:
            row.beta, row.cos, row.sin = beta, 1.0, 0.0
            row.offset = 0.0
            row.mu_static, row.mu_kinetic = case.edge_static_friction, case.edge_kinetic_friction
            row.restitution = case.normal_restitution
        elif plane == 1:
            row.beta, row.cos, row.sin = beta - HALF_TURN, 0.0, 1.0
            row.offset = rightmost + case.right_distance
            row.mu_static = row.mu_kinetic = case.right_friction
            row.restitution = case.right_restitution
        elif plane == 2:
            row.beta, row.cos, row.sin = beta + HALF_TURN, 0.0, -1.0
            row.offset = case.left_distance - leftmost
            row.mu_static = row.mu_kinetic = case.left_friction
            row.restitution = case.left_restitution
        else:
            row.beta, row.cos, row.sin = beta + math.pi, -1.0, 0.0
            row.offset = case.ceiling_distance
            row.mu_static = row.mu_kinetic = case.ceiling_friction
            row.restitution = case.ceiling_restitution
    return present


@inner
def arm(row, theta):
    """Corner relative to G in the plane's axes: along the tangent σ, and G above the corner κ [m]."""
    angle = row.beta - theta
    return row.r * math.sin(angle), row.r * math.cos(angle)


@inner
def along(row, x, z):
    """Components of a vector along the plane's tangent and normal."""
    return row.cos * x + row.sin * z, row.cos * z - row.sin * x


@inner
def gap_and_rates(row, state):
    """Gap of a contact [m] with its first and second rates.

    The state is x, z, θ, their rates and their second rates.
    """
    x, z, theta, vx, vz, omega, ax, az, alpha = state
    sigma, kappa = arm(row, theta)
    _, height = along(row, x, z)
    _, rate = along(row, vx, vz)
    _, acceleration = along(row, ax, az)
    gap = height + row.offset - kappa
    return gap, rate - omega * sigma, acceleration - alpha * sigma + omega * omega * kappa


@inner
def slip_rate(row, s):
    """Rate of the contact's corner along its plane [m/s]."""
    _, kappa = arm(row, s.theta)
    tangential, _ = along(row, s.vx, s.vz)
    return tangential - s.omega * kappa


@inner
def slide_of(case, s):
    """Slide and its rate, measured at the lower base corner: the fulcrum [m, m/s]."""
    lower = 1 if s.theta > resting_tilt(case) else 0
    u, v = case.u[lower], case.v[lower]
    sin, cos = math.sin(s.theta), math.cos(s.theta)
    rest = half_base(case) if lower == 1 else -half_base(case)
    return s.x + u * cos + v * sin - rest, s.vx + s.omega * (v * cos - u * sin)
