"""Records of the engine in space: bodies, where they are, planes of the room, contacts.

A body's own axes are its principal axes through its centre of gravity G. Places, velocities and momenta are
in the room's axes, which move with the floor: x along the depth, y across, z up.
"""

from stayput.mechanics.columns import floats, integers, record
from stayput.mechanics.devices.columns import ELEMENT

_NAMES = ELEMENT.names or ()

LAW_OF_ELEMENT = _NAMES[_NAMES.index("stiffness") :]
"""Columns of an `ELEMENT` that are its law: those after its geometry."""

SOLID = record(
    *floats("mass", "i1", "i2", "i3", "rm", "r1", "r2", "r3"),
    *integers("first_point", "points", "hull", "first_rim", "rims"),
    *integers("first_face", "faces", "first_edge", "edges"),
    *floats("radius", "restitution", "landing_place", "rolling", "kappa"),
    *floats("mu_static", "mu_kinetic", "edge_static", "edge_kinetic", "ux", "uy", "uz"),
)
"""A body: mass, principal moments of inertia, and the roots of one over each; its points, of which the first
are the corners of its convex hull, rims, faces and edges; the radius about G of a ball around it; of the
floor under it restitution, place of a landing and arm of rolling resistance; where friction acts
(`stayput.model.even_base`); friction on that floor, and on one corner or edge alone; and what points up at
rest.
"""

POINT = record(*floats("x", "y", "z", "mu_static", "mu_kinetic"), *integers("floor", "walls"))
"""A point of a body in its axes: friction of its own on the floor (NaN: the body's), whether it may touch
the floor, and walls and ceiling.
"""

RIM = record(*floats("x", "y", "z", "ax", "ay", "az", "radius"), *integers("floor", "walls"))
"""A circular edge of a body: its centre, the direction of its axis, its radius; the rest as of a point."""

FACE = record(*floats("nx", "ny", "nz"), *integers("first", "count"))
"""A face of a hull: its outward normal in the body's axes, and its corners in a list of points,
counter-clockwise as seen from outside.
"""

PLANE = record(*floats("nx", "ny", "nz", "offset", "mu_static", "mu_kinetic", "restitution"), ("floor", "i8"))
"""A plane n·x = offset of the room, its normal into the room: the floor, a wall, the ceiling.

What a body has of the floor stands with the body, as measures under it change that.
"""

PAIR = record(*integers("a", "b"), *floats("mu_static", "mu_kinetic", "restitution"))
"""Two bodies that may touch, and what holds there."""

POSE = record(
    *floats("x", "y", "z", "qw", "qx", "qy", "qz"),
    *floats("vx", "vy", "vz", "lx", "ly", "lz", "wx", "wy", "wz"),
    *floats(*(f"r{i}{j}" for i in "xyz" for j in "xyz")),
    *floats("jxx", "jxy", "jxz", "jyy", "jyz", "jzz"),
)
"""Where a body is and how it moves: G, the quaternion that turns its axes into the room's, velocity of G,
angular momentum, rotation rate, and of that quaternion the rotation matrix and the inverse of the inertia in
the room's axes.
"""

CONTACT = record(
    *integers("a", "b", "key", "stuck", "stood", "plane", "floor"),
    *floats("nx", "ny", "nz", "sx", "sy", "sz", "tx", "ty", "tz"),
    *floats("rax", "ray", "raz", "rbx", "rby", "rbz", "gap", "bx", "by", "bz"),
    *floats("fax", "fay", "faz", "fbx", "fby", "fbz"),
    *floats("mu_static", "mu_kinetic", "mu", "closing", "bounce"),
    *floats("target", "target_s", "target_t"),
    *floats("pn", "ps", "pt", "dn", "ds", "dt"),
    *floats("wnn", "wns", "wnt", "wss", "wst", "wtt", "stiff"),
    *floats("ln", "ls", "lt", "un", "us", "ut", "en", "es", "et", "gn", "gs", "gt"),
    *floats("shift", "change", "rho", "when", "x", "y", "z"),
    *floats("roll", "qx", "qy", "qz", "pr", "dr", "grip"),
)
"""A closed contact: bodies a and b (−1: the room), whether it sticks, and has done so since the last step
alone; the plane of the room (−1: none) and whether it is the floor, the normal towards a and two tangents,
the levers about both G, its gap and the acceleration by which free flight opens it, the levers of friction
about both G, coefficients of friction, the normal velocity before, its restitution (0: it does not bounce)
and the velocity wanted, impulses, their changes by a step of Newton's method, and the inverse mass that they
see; of the augmented Lagrangian the multipliers, velocities, their changes along the direction and by the
gradient, the shift of the normal velocity and its change, and the penalty; when it begins or ends to slip,
over the step's length (`stayput.mechanics.space.events`); of two bodies where it is in the axes of body a;
and of a rim that may roll (`stayput.mechanics.space.rolling`) the arm of its resistance, the axis, the
impulse of moment, its change by a step of Newton's method and by how much that falls with the rate.
"""

SPRING = record(
    *integers("body", "other", "kind"),
    *floats("px", "py", "pz", "ax", "ay", "az", "nx", "ny", "nz", "length"),
    *((name, ELEMENT[name]) for name in LAW_OF_ELEMENT),
)
"""A device: the body, and the other one (−1: the room); its point and its anchor from both G, in the axes of
the body and of the other, and the normal of its plane; its law is that of an `ELEMENT`, in newtons.
"""

PULL = record(
    *integers("lost", "pushes"),
    *floats("plastic", "plastic_sum", "tx", "ty", "tz", "slip_sum"),
    *floats("lx", "ly", "lz", "ox", "oy", "oz", "nx", "ny", "nz"),
    *floats("e", "xx", "xy", "xz", "ux", "uy", "uz", "px", "py", "pz"),
    *floats("dx", "dy", "dz", "cn", "ct", "force", "shear"),
)
"""How a device is stretched: whether it is lost, and has pushed; its plastic elongation and slip (a vector in
the anchor's axes) and their sums; in a step the levers about both G, the normal, elongations, the rate
before, the impulse, its change by a step of Newton's method, by how much it falls with the
velocity along the normal and across, and the forces.
"""

HISTORY = (
    *("x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz"),
    *("room_x", "room_y", "room_z", "bodies_x", "bodies_y", "bodies_z"),
)
"""Columns of a body's history; the last six are what the room and other bodies pressed on it [N]."""

HIT = record(*integers("a", "b", "plane"), *floats("time", "speed", "impulse", *HISTORY[:7]))
"""A hit: body a, and body b (−1: the room) or a plane of the room; when, how fast they closed, how hard; and
where body a was.
"""

LINE = 0.5
"""κ of even pressure along a line, beside its ends (`stayput.model.even_base`)."""

ON_FLOOR, ON_ROOM, ON_BODY = range(3)
"""Columns of the numbers of hits: on the floor, on walls and ceiling, on other bodies."""

BY_ROOM, BY_BODIES = 13, 16
"""First columns of those forces."""

PRESSING = record(
    *integers("key", "point", "plane", "floor", "sticks", "first"),
    *floats("mu_static", "mu_kinetic", "kappa", "ax", "ay", "az"),
    *floats("rx", "ry", "rz", "fx", "fy", "fz"),
    *floats("pn", "ps", "pt", "us", "ut", "ds", "dt"),
)
"""A contact that presses in a flow: its key, point and plane, whether that is the floor, whether it sticks,
and its first row; its friction, κ, and where it was in the room as the flow began; the levers about G of it
and of its friction; its forces along the normal and the tangents [N], how fast it slips along these, and how
it slipped as the step began.
"""

FLOW = record(
    *integers("ready", "moved", "begins", "count", "all_stick", "on_edge", "kinked", "refused", "pause"),
    *floats("step", "step_off_edge", "margin", "gap", "cx", "cy", "relaxation"),
    *floats("fx", "fy", "fz", "mx", "my", "mz", "px", "py", "pz"),
    *floats("qw", "qx", "qy", "qz", "angle", "rate", "change", "angle0", "rate0", "change0"),
    *floats("ex", "ey", "ez", "ox", "oy", "oz", "gx", "gy", "gz", "bx", "by", "bz", "ax", "ay", "az"),
    *floats("ix", "iy", "iz", "inertia", "half"),
)
"""A flow: whether the body is on one, has moved by one last, and is at its beginning; how many contacts
press, whether all stick, and whether they are an edge; whether a device may have changed at the end of the
last step; whether the last flow ended before it began, and how many general steps are to be taken before the
next; the length of its next step [s], and of that of the last flow off an edge; the least margin of its
forces and slips, and the least gap of what else may touch; the centre of pressure on the floor from G, and
the factor on its change in a round; force and moment of the devices about G; what the room presses on the
body.

On an edge that sticks: the attitude as the flow began; the angle turned since, its rate and acceleration, now
and as the step began; the edge's direction e and middle o, from there G at first as a part g along the edge
and b across it, with a = e × b; the moments of inertia times e in the body's axes, the moment of inertia
about the edge, and half its length.
"""
