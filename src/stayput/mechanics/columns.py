"""The tables that the compiled functions read and write, and the numbers of modes and contacts."""

from __future__ import annotations

import numpy as np

CASE = np.dtype(
    [
        ("inertia", "f8"),  # I = J_G/m [m²]
        ("u", "f8", (4,)),  # corners A, B, C, D relative to G, + right [m]
        ("v", "f8", (4,)),  # the same, + up [m]
        ("gravity", "f8"),  # g [m/s²]
        ("scale", "f8"),  # factor on the motion, all components
        ("static_friction", "f8"),  # μ, flat base
        ("kinetic_friction", "f8"),  # μ', flat base
        ("edge_static_friction", "f8"),
        ("edge_kinetic_friction", "f8"),
        ("left_edge_static_friction", "f8"),  # of the corner A alone, tipped or flat; NaN: as above
        ("left_edge_kinetic_friction", "f8"),
        ("right_edge_static_friction", "f8"),  # of B
        ("right_edge_kinetic_friction", "f8"),
        ("restitution", "f8"),  # e, factor on the rate at a change of fulcrum
        ("normal_restitution", "f8"),  # e_n of a landing corner
        ("right_distance", "f8"),  # [m], inf where there is no wall
        ("right_restitution", "f8"),
        ("right_friction", "f8"),
        ("left_distance", "f8"),
        ("left_restitution", "f8"),
        ("left_friction", "f8"),
        ("ceiling_distance", "f8"),  # height above the floor
        ("ceiling_restitution", "f8"),
        ("ceiling_friction", "f8"),
        ("tilt", "f8"),  # initial state [rad, rad/s, m, m/s]
        ("tilt_rate", "f8"),
        ("slide", "f8"),
        ("slide_rate", "f8"),
    ],
    align=True,
)
"""One case, apart from its motion; a column of these is what the batch runs."""

STATE = np.dtype(
    [
        ("x", "f8"),  # G, right of where the middle of the base stood [m]
        ("z", "f8"),  # G above the floor [m]
        ("theta", "f8"),
        ("sin", "f8"),  # of θ
        ("cos", "f8"),
        ("vx", "f8"),
        ("vz", "f8"),
        ("omega", "f8"),
        ("alpha", "f8"),  # θ̈ just before the last event, for looking a moment ahead
        ("tau", "f8"),  # time since the sample k [s]
        ("k", "i8"),
        ("kind", "i8"),  # the mode: one of the constants below, with its contacts and slip directions
        ("i", "i8"),
        ("j", "i8"),
        ("d", "i8"),
        ("dj", "i8"),
        ("closed", "i8"),  # bits of the contacts that touch
        ("present", "i8"),  # bits of the contacts that this room has
        ("low", "f8"),  # the loads (ẍ_G, G) that leave a held body at rest lie between two rays:
        ("low_up", "f8"),  # (low, low_up) and (high, high_up)
        ("high", "f8"),
        ("high_up", "f8"),
        ("rest", "f8"),  # tilt with both base corners on the floor [rad]
        ("foot_a", "f8"),  # place of A at rest and slide 0 [m]
        ("foot_b", "f8"),
        ("settle", "f8"),  # rate at which a contact opens in a bounce that is over [m/s]
        ("hit", "i8"),  # bits of the contacts that closed in the last event
        ("peak_tilt", "f8"),
        ("peak_slide", "f8"),
        ("floor_impacts", "i8"),
        ("wall_impacts", "i8"),
        ("events", "i8"),
        ("steps", "i8"),
        ("moved", "i8"),  # bits: 1 slid, 2 rocked, 4 flew
    ],
    align=True,
)

# contacts: corner on plane
A_FLOOR, B_FLOOR, B_RIGHT, D_RIGHT, A_LEFT, C_LEFT, C_CEILING, D_CEILING = range(8)
CORNER = (0, 1, 1, 3, 0, 2, 2, 3)
PLANE = (0, 0, 1, 1, 2, 2, 3, 3)
FLOOR_BITS = 0b00000011
CONTACTS = 8

CONTACT = np.dtype(
    [
        ("sigma", "f8"),  # r sin β and r cos β: the corner from G in the plane's axes, at θ = 0 [m]
        ("kappa", "f8"),
        ("offset", "f8"),  # of the plane, along its normal [m]
        ("cos", "f8"),  # direction of the plane
        ("sin", "f8"),
        ("mu_static", "f8"),
        ("mu_kinetic", "f8"),
        ("restitution", "f8"),
        ("level", "f8"),  # gap [m], or rate of slip [m/s], at which the present step ends
    ],
    align=True,
)
"""One contact: a corner and a plane."""

ROW = np.dtype(
    [
        ("nx", "f8"),  # normal, and its lever about G
        ("nz", "f8"),
        ("nl", "f8"),
        ("tx", "f8"),  # tangent, and its lever
        ("tz", "f8"),
        ("tl", "f8"),
        ("bias_n", "f8"),  # rates without forces at the contacts
        ("bias_t", "f8"),
        ("target", "f8"),  # the normal rate of a contact that presses
        ("mu_stick", "f8"),  # coefficients of friction of the corner alone
        ("mu_slip", "f8"),
        ("flat_stick", "f8"),  # and where the plane's other corner is closed too
        ("flat_slip_right", "f8"),
        ("flat_slip_left", "f8"),
        ("slipping", "f8"),  # direction of slip, 0 where there is none
        ("index", "i8"),  # which contact
    ],
    align=True,
)
"""A closed contact in the small contact problem."""

# modes
HELD, FLAT, STICK, SLIP, WEDGE, FLIGHT, OVERTURNED, FAILED = range(8)

# why a mode ended
ENDED, CLOSED, LIMIT, TURNED_OVER = range(4)

# columns of the history, one row a sample
H_X, H_Z, H_TILT, H_TILT_RATE, H_SLIDE, H_SLIDE_RATE, H_MODE, H_REACHED = range(8)
HISTORY = 8

# modes as the user knows them, in the order of `stayput.simulation.Mode`
REST_MODE, SLIDE_MODE, ROCK_MODE, SLIDE_ROCK_MODE, FLIGHT_MODE, LEAN_MODE, OVERTURNED_MODE = range(7)

# columns of the list of events, and their kinds in the order of `stayput.simulation.EventKind`
E_TIME, E_KIND, E_MODE, E_TILT, E_TILT_RATE, E_SLIDE, E_SLIDE_RATE = range(7)
EVENT = 7
(
    SLIP_EVENT,
    STICK_EVENT,
    UPLIFT_EVENT,
    FLOOR_IMPACT_EVENT,
    WALL_IMPACT_EVENT,
    CEILING_IMPACT_EVENT,
    LIFT_OFF_EVENT,
    WALL_RELEASE_EVENT,
    REST_EVENT,
    OVERTURNED_EVENT,
    FAILED_EVENT,
    DEVICE_FAILURE_EVENT,
) = range(12)

# outcomes, in the order of `stayput.simulation.Outcome`
RESTED, SLID, ROCKED, LEANING, OVERTURNED_OUTCOME, FAILED_OUTCOME = range(6)

# bits of state.moved
MOVED_SLIDING, MOVED_ROCKING, MOVED_FLYING = 1, 2, 4

RESULT = np.dtype(
    [
        ("outcome", "i8"),
        ("end", "f8"),  # s
        ("peak_slide", "f8"),  # m
        ("residual_slide", "f8"),
        ("peak_tilt", "f8"),  # rad
        ("residual_tilt", "f8"),
        ("floor_impacts", "i8"),
        ("wall_impacts", "i8"),
        ("events", "i8"),
        ("steps", "i8"),
    ],
    align=True,
)
"""What the batch keeps of a case."""
