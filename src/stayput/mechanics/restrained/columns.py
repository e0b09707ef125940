"""The tables of force elements: what a device is, where it stands now, and what became of it.

All forces are per unit mass of the body, as everywhere in the mechanics: newtons divided by the body's
mass, so N/kg. An element joins a point of the body to a place in the room. It has up to two *lines*,
NORMAL and TANGENT, each a spring with a damper, slack, strength and plastic elongation; see `lines`.
"""

from __future__ import annotations

import numpy as np

from stayput.mechanics.columns import CONTACTS

# kinds of element
NONE, AXIAL, PLANAR = range(3)

# lines of an element
NORMAL, TANGENT = range(2)

ELEMENT = np.dtype(
    [
        ("kind", "i8"),  # NONE (no element), AXIAL or PLANAR
        ("u", "f8"),  # the point of the body relative to G, in the body's axes: + right [m]
        ("v", "f8"),  # the same, + up [m]
        ("x", "f8"),  # its anchor, right of where the middle of the base stood [m]
        ("z", "f8"),  # anchor above the floor [m]; NaN for both: where the point is at rest and slide 0
        ("cos", "f8"),  # PLANAR: direction of the plane; its normal (−sin, cos) points into the room
        ("sin", "f8"),
        ("length", "f8"),  # AXIAL: distance between point and anchor at no elongation [m]
        # the lines, NORMAL first; elongation is + away from the anchor or plane, or along the tangent
        ("stiffness", "f8", (2,)),  # [N/(kg m)]; 0: no such line
        ("damping", "f8", (2,)),  # [N s/(kg m)]
        ("slack_plus", "f8", (2,)),  # elongation at which it pulls [m]; inf: never, negative: preload
        ("slack_minus", "f8", (2,)),  # shortening at which it pushes [m]; inf: never, negative: preload
        ("limit_plus", "f8", (2,)),  # strength in pull, or to the tangent's side [N/kg]; inf: none
        ("limit_minus", "f8", (2,)),  # strength in push, or to the other side [N/kg]
        ("ultimate", "f8", (2,)),  # plastic elongation, summed, at which it parts [m]; 0: brittle
        ("friction", "f8"),  # the tangent slips at this times the normal line's push; NaN: it does not
        ("interaction", "i8"),  # 1: breaks where (pull/strength)² + (shear/strength)² is 1
        ("drops_out", "i8"),  # 1: gone for good once it pushes no more
    ],
    align=True,
)
"""One device: rows of these, shape [n] for a case, are what the kernel takes beside a CASE.

An element both of whose slacks add up to zero is bonded: it pulls and pushes as one spring. Any other
touches on one side at a time, and its force there, with that of the damper, never has the other sign.
"""

DEVICE = np.dtype(
    [
        ("peak_pull", "f8"),  # largest normal force away from the anchor at any time [N/kg]
        ("peak_push", "f8"),  # largest one towards it [N/kg]
        ("peak_shear", "f8"),  # largest magnitude of the tangential force [N/kg]
        ("plastic", "f8", (2,)),  # plastic elongation or slip at the end [m]
        ("failure", "i8"),  # HOLDS, or why it failed
        ("failure_time", "f8"),  # [s], NaN where it holds
    ],
    align=True,
)
"""What became of one device."""

# why a device failed: where pull and shear act together, by the one that used more of its strength
HOLDS, PULLED, PUSHED, SHEARED, DRAWN_OUT, DROPPED_OUT = range(6)

# columns of the history of forces, one row a sample and element
F_NORMAL, F_TANGENT = range(2)
FORCES = 2

# branches of a line: what its law is until the next event
OPEN, PLUS, MINUS, BOND, SLIP_PLUS, SLIP_MINUS = range(6)

LINK = np.dtype(
    [
        ("lines", "i8"),  # how many lines there are; 0: none, or gone
        ("branch", "i8", (2,)),
        ("x", "f8"),  # the anchor [m]
        ("z", "f8"),
        ("plastic", "f8", (2,)),  # [m]
        ("spent", "f8", (2,)),  # plastic elongation, summed [m]
        ("e", "f8", (2,)),  # elongation where it was last measured, with its rate, force and push
        ("rate", "f8", (2,)),
        ("force", "f8", (2,)),
        ("push", "f8"),
        ("push_rate", "f8"),
    ],
    align=True,
)
"""Where an element stands from one event to the next; room for the compiled functions."""

# what a line's law is between two events
TAUT, SLACK, SLIPPING, RUBBING = range(4)

LINE = np.dtype(
    [
        ("element", "i8"),  # the element it is of
        ("tangent", "i8"),  # 1: its tangent, whose row follows that of its normal line
        ("axial", "i8"),
        ("state", "i8"),
        ("pushes", "i8"),  # 1: what it pushes is what its tangent's friction follows
        ("joins", "i8"),  # 1: this tangent and its normal line break together
        # where it is: e = a + n·(x, z) + p cos θ + q sin θ about the origin; AXIAL: from (x, z) to the point
        ("nx", "f8"),
        ("nz", "f8"),
        ("a", "f8"),
        ("p", "f8"),
        ("q", "f8"),
        ("u", "f8"),  # the point from the origin
        ("v", "f8"),
        ("x", "f8"),
        ("z", "f8"),
        # its force is constant + k e + c ė + rubs × push
        ("constant", "f8"),
        ("k", "f8"),
        ("c", "f8"),
        ("rubs", "f8"),
        # its margins, see `laws`: of TAUT ones low + low_F F + low_rubs push, and the same for high
        ("low_at_0", "f8"),
        ("low_F", "f8"),
        ("low_rubs", "f8"),
        ("high_at_0", "f8"),
        ("high_F", "f8"),
        ("high_rubs", "f8"),
        ("stiffness", "f8"),  # of the spring, the damper, whatever the branch
        ("damping", "f8"),
        ("per_plus", "f8"),  # 1/strength, where pull and shear act together
        ("per_minus", "f8"),
        # elongation, rate and force where last measured, and at the start of the step
        ("e", "f8"),
        ("rate", "f8"),
        ("force", "f8"),
        ("e0", "f8"),
        ("rate0", "f8"),
        ("force0", "f8"),
        ("swing", "f8"),  # by which the force may be larger inside the step than at both ends [N/kg]
        ("calm", "i8"),  # 1: no margin of its element can be passed in the step
        # margins at the start of the step and where last measured, and the levels at which they end it
        ("low0", "f8"),
        ("high0", "f8"),
        ("joint0", "f8"),
        ("low1", "f8"),
        ("high1", "f8"),
        ("joint1", "f8"),
        ("low", "f8"),
        ("high", "f8"),
        ("joint", "f8"),
        ("low_weight", "f8"),  # of the margins in the search for an event; 0: takes no part
        ("high_weight", "f8"),
        ("joint_weight", "f8"),
    ],
    align=True,
)
"""One line of an element that acts, from one event to the next: its law as numbers."""

MOST_FACETS = 40
MOST_ELEMENTS = 12
MOST_LINES = 2 * MOST_ELEMENTS

WORK = np.dtype(
    [
        ("stage", "f8", (7, 3)),  # accelerations of x, z and θ in the stages of a step
        ("weight", "f8", (CONTACTS + 3,)),  # of gaps, the mode's two margins and a right angle; as in LINE
        ("lines", "i8"),  # number of lines that act
        ("line", LINE, (MOST_LINES,)),
        ("level", "f8", (CONTACTS,)),  # gaps at which the open contacts close in the present step [m]
        ("gap", "f8", (CONTACTS,)),  # of the open contacts, where all margins were last looked at [m]
        ("reach", "f8", (CONTACTS, 3)),  # gaps on a fulcrum: a + p cos θ + q sin θ [m]
        ("longest", "f8"),  # step that the last error allowed [s]
        ("still", "f8"),  # rate below which nothing moves after the present event [m/s]
        ("foot", "f8"),  # place of a fulcrum that sticks, along its plane [m]
        ("patience", "f8"),  # factor on the slacks of limits; grows where events crowd
        ("crowded", "i8"),  # events in a row with next to no time between them
        ("failed", "i8"),  # devices that failed in the present event
        ("facets", "i8"),  # number of rows of ``facet`` that hold the body
        # the body is held where c₀ + c₁ẍ_G + c₂G ≥ 0 for all; c₃ is for the elements' moment
        ("facet", "f8", (MOST_FACETS, 4)),
    ],
    align=True,
)
"""What the kernel remembers beside the state."""
