"""Record layouts of force elements: their parameters, their present state and their results.

All forces are per unit mass of the body, as everywhere in the mechanics: newtons divided by the body's
mass, so N/kg. An element joins a point of the body to a place in the room. It has up to two *lines*,
NORMAL and TANGENT, each a spring with a damper, slack, strength and plastic elongation; see `device_law`.
"""

from stayput.mechanics.columns import CONTACTS, floats, integers, record

# kinds of element
NONE, AXIAL, PLANAR = range(3)

# lines of an element
NORMAL, TANGENT = range(2)

ELEMENT = record(
    ("kind", "i8"),  # NONE (no element), AXIAL or PLANAR
    # attachment point on the body relative to G, in the body's axes: + right, + up, and along the length,
    # which is read in space alone [m]
    *floats("u", "v", "y"),
    # anchor right of the initial middle of the base and above the floor [m]; NaN: at the point, for the
    # body at rest at slide 0
    *floats("x", "z"),
    *floats("cos", "sin"),  # PLANAR: direction of the plane; its normal (−sin, cos) points into the room
    ("length", "f8"),  # AXIAL: distance between point and anchor at no elongation [m]
    # the lines, NORMAL first; elongation is + away from the anchor or plane, or along the tangent
    ("stiffness", "f8", (2,)),  # [N/(kg m)]; 0: no such line
    ("damping", "f8", (2,)),  # [N s/(kg m)]
    ("slack_plus", "f8", (2,)),  # elongation at which it pulls [m]; inf: never, negative: preload
    ("slack_minus", "f8", (2,)),  # shortening at which it pushes [m]; inf: never, negative: preload
    ("limit_plus", "f8", (2,)),  # strength in pull, or to the tangent's side [N/kg]; inf: none
    ("limit_minus", "f8", (2,)),  # strength in push, or to the other side [N/kg]
    # accumulated plastic elongation at rupture [m], 0: brittle; of friction: slip
    ("ultimate", "f8", (2,)),
    ("friction", "f8"),  # friction limit of the tangent per push of the normal line; NaN: none
    ("interaction", "i8"),  # 1: breaks where (pull/strength)² + (shear/strength)² = 1
    ("drops_out", "i8"),  # 1: fails once it no longer pushes
)
"""One device; the solver takes an array of these, shape [n], beside each CASE.

An element whose two slacks add up to zero is bonded: it pulls and pushes as one spring. Any other is in
contact on one side at a time, and its force there, damper included, never changes sign.
"""

DEVICE = record(
    ("peak_pull", "f8"),  # largest normal force away from the anchor at any time [N/kg]
    ("peak_push", "f8"),  # largest one towards it [N/kg]
    ("peak_shear", "f8"),  # largest magnitude of the tangential force [N/kg]
    ("plastic", "f8", (2,)),  # plastic elongation or slip at the end [m]
    ("failure", "i8"),  # HOLDS, or why it failed
    ("failure_time", "f8"),  # [s], NaN where it holds
)
"""Result of one device."""

# failure modes of a device; where pull and shear interact, the one with the larger utilization
HOLDS, PULLED, PUSHED, SHEARED, DRAWN_OUT, DROPPED_OUT = range(6)

# columns of the force history, one row per sample and element
F_NORMAL, F_TANGENT = range(2)
FORCES = 2

# branches of a line's force law, each valid from one event to the next
OPEN, PLUS, MINUS, BOND, SLIP_PLUS, SLIP_MINUS = range(6)

# form of a line's law on its present branch
ELASTIC, SLACK, YIELDING, FRICTION = range(4)

LAW = record(
    ("state", "i8"),
    ("bears_friction", "i8"),  # 1: its push is the normal force of its tangent's friction
    *floats("constant", "k", "c", "per_push"),  # force: constant + k e + c ė + per_push × push
    # margins, see `device_law`: of an ELASTIC line low_at_0 + low_per_force F + low_per_push × push
    *floats("low_at_0", "low_per_force", "low_per_push", "high_at_0", "high_per_force", "high_per_push"),
    *floats("stiffness", "damping"),  # of spring and damper, whatever the branch
    *floats("per_plus", "per_minus"),  # 1/strength where pull and shear interact, else 0
)
"""The law of a line on its present branch."""

LINK = record(
    ("lines", "i8"),  # number of active lines; 0: none, or failed
    ("branch", "i8", (2,)),
    *floats("x", "z"),  # the anchor [m]
    ("plastic", "f8", (2,)),  # [m]
    ("plastic_sum", "f8", (2,)),  # accumulated plastic elongation [m]
    # as last evaluated: elongation, rate, force and push
    ("e", "f8", (2,)),
    ("rate", "f8", (2,)),
    ("force", "f8", (2,)),
    *floats("push", "push_rate"),
    ("law", LAW, (2,)),  # as last set
)
"""Present state of an element."""

LINE = record(
    # index of its element; whether it is its tangent, whose row follows that of the normal line; AXIAL
    *integers("element", "tangent", "axial"),
    ("interacts", "i8"),  # 1: this tangent interacts with its normal line in the strength
    *((name, LAW[name]) for name in LAW.names or ()),
    # geometry: e = a + n·(x, z) + p cos θ + q sin θ about the origin; AXIAL: from (x, z) to the point
    *floats("nx", "nz", "a", "p", "q", "u", "v", "x", "z"),
    ("reach", "f8"),  # largest lever about the origin [m]
    # elongation, rate and force as last evaluated, and at the start of the step
    *floats("e", "rate", "force", "e0", "rate0", "force0"),
    ("deviation", "f8"),  # bound on how far the force exceeds its end values inside the step [N/kg]
    ("inactive", "i8"),  # 1: no margin of its element can change sign in the step
    # margins at the start of the step (0), as last evaluated (1), and the levels at which they end it
    *floats("low0", "high0", "joint0", "low1", "high1", "joint1", "low", "high", "joint"),
    *floats("low_weight", "high_weight", "joint_weight"),  # scales in the event search; 0: not searched
)
"""One line of an active element: its geometry and the coefficients of its law on the present branch."""

MAX_FACETS = 40
MAX_ELEMENTS = 12
MAX_LINES = 2 * MAX_ELEMENTS
ORDER = 10

AXIAL_SERIES = record(
    ("row", "i8"),  # of its line
    ("beta", "f8"),  # d² = constant + β cos θ + γ sin θ [m²]
    ("gamma", "f8"),
    # coefficients
    ("far", "f8", (ORDER + 1,)),  # of d, the distance from the anchor [m]
    ("pull", "f8", (ORDER + 1,)),  # of F/d
    ("lever", "f8", (ORDER + 1,)),  # of ½ (d²)'
)
"""Series of an AXIAL line of a body on a sticking fulcrum; see `moment`."""

WORK = record(
    ("order", "i8"),  # of the series
    ("tilt", "f8", (ORDER + 1,)),  # coefficients of the tilt on a sticking fulcrum
    ("rate", "f8", (ORDER + 1,)),  # of its rate
    ("lane", "f8", (ORDER + 1, 4)),  # of cos θ, sin θ, cos 2θ, sin 2θ
    ("moment", "f8", (8,)),  # of the lines about it, see `moment`
    ("axials", "i8"),
    ("axial", AXIAL_SERIES, (MAX_ELEMENTS,)),
    ("stage", "f8", (7, 3)),  # accelerations of x, z and θ at the Runge–Kutta stages
    ("weight", "f8", (CONTACTS + 3,)),  # scale of gaps, the mode's two margins, rotation to 90°
    ("lines", "i8"),  # number of active lines
    ("line", LINE, (MAX_LINES,)),
    ("level", "f8", (CONTACTS,)),  # gaps at which the open contacts close in the present step [m]
    ("gap", "f8", (CONTACTS,)),  # gaps of the open contacts as last evaluated [m]
    ("gap0", "f8", (CONTACTS,)),  # the same at the start of the step
    ("curve", "f8", (3, 6)),  # quintics of x, z and θ over the step, in u = t/h
    ("reach", "f8", (CONTACTS, 3)),  # gaps on a fulcrum: a + p cos θ + q sin θ [m]
    ("step_limit", "f8"),  # step length allowed by the last error estimate [s]
    ("still_rate", "f8"),  # rate below which a body is at rest after the present event [m/s]
    ("foot", "f8"),  # position of a sticking fulcrum along its plane [m]
    ("slack_factor", "f8"),  # factor on event slacks, see `transitions.relax_event_thresholds`
    ("crowded_events", "i8"),  # near-simultaneous events in a row
    ("failed", "i8"),  # devices that failed at the present event
    ("facets", "i8"),  # number of facets in use
    # the body is at rest where c₀ + c₁ẍ_G + c₂G ≥ 0 for all facets; c₃ multiplies the elements' moment
    ("facet", "f8", (MAX_FACETS, 4)),
)
"""Work record of the solver, beside the state."""
