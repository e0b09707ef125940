"""Record layouts (NumPy dtypes) and integer codes (contacts, modes, events) of the compiled solver."""

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
        # read in space alone
        ("length", "f8"),  # across the section [m], NaN where the body has none
        ("half_base", "f8"),  # half of what the feet span of it [m]
        ("roll_inertia", "f8"),  # about the horizontal in the section and the vertical, over m [m²]
        ("yaw_inertia", "f8"),
        ("landing_place", "f8"),
        ("near_side_distance", "f8"),  # across the section, to −y [m]
        ("near_side_restitution", "f8"),
        ("near_side_friction", "f8"),
        ("far_side_distance", "f8"),  # to +y
        ("far_side_restitution", "f8"),
        ("far_side_friction", "f8"),
    ],
    align=True,
)
"""One case without its motion; the batch runs an array of these."""

STATE = np.dtype(
    [
        ("x", "f8"),  # G, right of where the middle of the base stood [m]
        ("z", "f8"),  # G above the floor [m]
        ("theta", "f8"),  # from the upright body's position, unlike the tilts that are reported [rad]
        ("sin", "f8"),  # of θ
        ("cos", "f8"),
        ("vx", "f8"),
        ("vz", "f8"),
        ("omega", "f8"),
        ("alpha", "f8"),  # θ̈ just before the last event, for the look-ahead when a mode is chosen
        ("tau", "f8"),  # time since the sample k [s]
        ("k", "i8"),
        ("kind", "i8"),  # the mode: one of the constants below, with its contacts and slip directions
        ("i", "i8"),
        ("j", "i8"),
        ("d", "i8"),
        ("dj", "i8"),
        ("closed", "i8"),  # bits of the closed contacts
        ("present", "i8"),  # bits of the contacts that exist in this room
        ("low", "f8"),  # a body at rest stays there while the load (ẍ_G, G) lies between two rays:
        ("low_up", "f8"),  # (low, low_up) and (high, high_up)
        ("high", "f8"),
        ("high_up", "f8"),
        ("rest", "f8"),  # tilt with both base corners on the floor [rad]
        ("foot_a", "f8"),  # x of corner A at rest with slide 0 [m]
        ("foot_b", "f8"),
        ("settle_rate", "f8"),  # a contact that opens no faster than this after an impact stays closed [m/s]
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

# contacts: a corner of the body (A, B of the base, C, D of the top) on a plane (0 floor, 1 right wall,
# 2 left wall, 3 ceiling)
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
        ("nx", "f8"),  # unit normal, and its lever arm about G [m]
        ("nz", "f8"),
        ("nl", "f8"),
        ("tx", "f8"),  # unit tangent, and its lever arm [m]
        ("tz", "f8"),
        ("tl", "f8"),
        ("bias_n", "f8"),  # normal and tangential rates without contact forces
        ("bias_t", "f8"),
        ("target", "f8"),  # normal rate that a pressing contact must have
        ("mu_stick", "f8"),  # static and kinetic coefficients while this corner alone is in contact
        ("mu_slip", "f8"),
        ("flat_stick", "f8"),  # the same while the plane's other corner is closed too
        ("flat_slip_right", "f8"),
        ("flat_slip_left", "f8"),
        ("slipping", "f8"),  # direction of slip, 0 where there is none
        ("index", "i8"),  # which contact
    ],
    align=True,
)
"""A closed contact in the contact problem (see `contact`): its row of the Jacobian, rates and friction."""

# Modes of the solver: which contacts carry load, and whether they slip. `sampling.public_mode` maps them to
# `stayput.Mode`: REST of a tilted body held by a wall, and LEAN (slipping on two planes at once), are both
# Mode.LEAN, the theory page's "lean"; any mode without a floor contact is Mode.FLIGHT.
REST, SLIDE, ROCK, SLIDE_ROCK, LEAN, FLIGHT, OVERTURNED, FAILED = range(8)

# why an integration in one mode returned: end of record, contact closed, force or slip limit, overturned
ENDED, CLOSED, LIMIT, TURNED_OVER = range(4)

# columns of the history; one row per sample
H_X, H_Z, H_TILT, H_TILT_RATE, H_SLIDE, H_SLIDE_RATE, H_MODE, H_REACHED = range(8)
HISTORY = 8

# public modes, in the order of `stayput.simulation.run.Mode`
REST_MODE, SLIDE_MODE, ROCK_MODE, SLIDE_ROCK_MODE, FLIGHT_MODE, LEAN_MODE, OVERTURNED_MODE = range(7)

# columns of the event list, and event kinds in the order of `stayput.simulation.run.EventKind`
E_TIME, E_KIND, E_MODE, E_TILT, E_TILT_RATE, E_SLIDE, E_SLIDE_RATE = range(7)
EVENT_FIELDS = ("time", "kind", "mode", "tilt", "tilt_rate", "slide", "slide_rate")
EVENT = len(EVENT_FIELDS)
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

# of a device's branch alone, while the mode stays; excluded from Run.events
INTERNAL_EVENT = -1

# contact laws, in the order of `stayput.simulation.run.LAWS`
COULOMB, PAPER = range(2)

# outcomes, in the order of `stayput.simulation.run.Outcome`
RESTED, SLID, ROCKED, LEANING, OVERTURNED_OUTCOME, FAILED_OUTCOME = range(6)

# bits of state.moved
MOVED_SLIDING, MOVED_ROCKING, MOVED_FLYING = 1, 2, 4

RESULT = np.dtype(
    [
        ("outcome", "i8"),
        ("end", "f8"),  # s
        ("peak_slide", "f8"),  # m
        ("residual_slide", "f8"),
        ("peak_tilt", "f8"),  # from rest, as all tilts that are reported [rad]
        ("residual_tilt", "f8"),
        ("floor_impacts", "i8"),
        ("wall_impacts", "i8"),
        ("events", "i8"),
        ("steps", "i8"),
    ],
    align=True,
)
"""Result of one case in a batch."""
