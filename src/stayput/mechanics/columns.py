"""Record layouts (NumPy dtypes) and integer codes (contacts, modes, events) of the compiled solver."""

from __future__ import annotations

from typing import Any

import numpy as np


def floats(*names: str) -> list[tuple[str, str]]:
    """Return the fields of a record that are numbers."""
    return [(name, "f8") for name in names]


def integers(*names: str) -> list[tuple[str, str]]:
    """Return the fields of a record that are whole numbers."""
    return [(name, "i8") for name in names]


def record(*fields: tuple[Any, ...]) -> np.dtype[np.void]:
    """Return the layout of a record with some fields, each where the processor reads it fastest."""
    return np.dtype([*fields], align=True)


CASE = record(
    ("inertia", "f8"),  # I = J_G/m [m²]
    ("u", "f8", (4,)),  # corners A, B, C, D relative to G, + right [m]
    ("v", "f8", (4,)),  # the same, + up [m]
    *floats("gravity", "scale"),  # g [m/s²], factor on the motion, all components
    *floats("static_friction", "kinetic_friction"),  # μ and μ', flat base
    *floats("edge_static_friction", "edge_kinetic_friction"),
    # of the corners A and B alone, tipped or flat; NaN: as above
    *floats("left_edge_static_friction", "left_edge_kinetic_friction"),
    *floats("right_edge_static_friction", "right_edge_kinetic_friction"),
    *floats("restitution", "normal_restitution"),  # e, factor on the rate at a change of fulcrum; e_n
    # distances of walls, inf where there is none, and the height of the ceiling above the floor [m]
    *floats("right_distance", "right_restitution", "right_friction"),
    *floats("left_distance", "left_restitution", "left_friction"),
    *floats("ceiling_distance", "ceiling_restitution", "ceiling_friction"),
    *floats("tilt", "tilt_rate", "slide", "slide_rate"),  # initial state [rad, rad/s, m, m/s]
    # read in space alone: mass [kg]; across the section [m], NaN where the body has none; half of what
    # the feet span of it; moments about the horizontal in the section and the vertical, over m [m²]; what
    # bears, by its place in `BASES`; e without the place of a landing, and that; how far ahead the floor's
    # force lies of what rolls [m]; walls to −y and +y
    *floats("mass", "length", "half_base", "roll_inertia", "yaw_inertia", "base"),
    *floats("floor_restitution", "landing_place", "rolling_resistance"),
    *floats("near_side_distance", "near_side_restitution", "near_side_friction"),
    *floats("far_side_distance", "far_side_restitution", "far_side_friction"),
)
"""One case without its motion; the batch runs an array of these."""

STATE = record(
    *floats("x", "z"),  # G, right of where the middle of the base stood, above the floor [m]
    *floats("theta", "sin", "cos"),  # from the upright body's position, unlike reported tilts [rad]
    *floats("vx", "vz", "omega"),
    ("alpha", "f8"),  # θ̈ just before the last event, for the look-ahead when a mode is chosen
    ("tau", "f8"),  # time since the sample k [s]
    ("k", "i8"),
    *integers("kind", "i", "j", "d", "dj"),  # the mode, with its contacts and slip directions
    *integers("closed", "present"),  # bits of the closed contacts, and of those that exist in this room
    # a body at rest stays there while the load (ẍ_G, G) lies between two rays
    *floats("low", "low_up", "high", "high_up"),
    ("rest", "f8"),  # tilt with both base corners on the floor [rad]
    *floats("foot_a", "foot_b"),  # x of the corners A and B at rest with slide 0 [m]
    ("settle_rate", "f8"),  # a contact that opens no faster than this after an impact stays closed [m/s]
    ("hit", "i8"),  # bits of the contacts that closed in the last event
    *floats("peak_tilt", "peak_slide"),
    *integers("floor_impacts", "wall_impacts", "events", "steps"),
    ("moved", "i8"),  # bits: 1 slid, 2 rocked, 4 flew
)

# contacts: a corner of the body (A, B of the base, C, D of the top) on a plane (0 floor, 1 right wall,
# 2 left wall, 3 ceiling)
A_FLOOR, B_FLOOR, B_RIGHT, D_RIGHT, A_LEFT, C_LEFT, C_CEILING, D_CEILING = range(8)
CORNER = (0, 1, 1, 3, 0, 2, 2, 3)
PLANE = (0, 0, 1, 1, 2, 2, 3, 3)
FLOOR_BITS = 0b00000011
CONTACTS = 8

CONTACT = record(
    *floats("sigma", "kappa"),  # r sin β and r cos β: the corner from G in the plane's axes, at θ = 0 [m]
    *floats("offset", "cos", "sin"),  # of the plane, along its normal [m], and its direction
    *floats("mu_static", "mu_kinetic", "restitution"),
    ("level", "f8"),  # gap [m], or rate of slip [m/s], at which the present step ends
)
"""One contact: a corner and a plane."""

ROW = record(
    *floats("nx", "nz", "nl", "tx", "tz", "tl"),  # unit normal and tangent, each with its lever arm [m]
    *floats("bias_n", "bias_t"),  # normal and tangential rates without contact forces
    ("target", "f8"),  # normal rate that a pressing contact must have
    *floats("mu_stick", "mu_slip"),  # static and kinetic coefficients of this corner alone in contact
    *floats("flat_stick", "flat_slip_right", "flat_slip_left"),  # with the other corner of the plane
    ("slipping", "f8"),  # direction of slip, 0 where there is none
    ("index", "i8"),  # which contact
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

HIT_SPEED = 0.01
"""Closing speed from which on a contact that closes counts as a hit [m/s]."""

ROCKING_TILT = 1e-4
"""Tilt from which on a body has rocked [rad]: about how deep contacts in space may be, over a narrow base."""

# bits of state.moved
MOVED_SLIDING, MOVED_ROCKING, MOVED_FLYING = 1, 2, 4

RESULT = record(
    ("outcome", "i8"),
    ("end", "f8"),  # s
    *floats("peak_slide", "residual_slide"),  # m
    *floats("peak_tilt", "residual_tilt"),  # from rest, as all tilts that are reported [rad]
    *integers("floor_impacts", "wall_impacts", "events", "steps"),
)
"""Result of one case in a batch."""
