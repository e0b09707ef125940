"""Records of the engine in space: bodies, where they are, planes of the room, contacts.

A body's own axes are its principal axes through its centre of gravity G. Places, velocities and momenta are
in the room's axes, which move with the floor: x along the depth, y across, z up.
"""

from __future__ import annotations

import numpy as np

SOLID = np.dtype(
    [
        ("mass", "f8"),
        ("i1", "f8"),
        ("i2", "f8"),
        ("i3", "f8"),
        ("first_point", "i8"),
        ("points", "i8"),
        ("hull", "i8"),
        ("first_rim", "i8"),
        ("rims", "i8"),
        ("first_face", "i8"),
        ("faces", "i8"),
        ("first_edge", "i8"),
        ("edges", "i8"),
        ("radius", "f8"),
    ],
    align=True,
)
"""A body: mass, principal moments of inertia; its points, of which the first are the corners of its convex
hull, rims, faces and edges; and the radius about G of a ball around it.
"""

POINT = np.dtype([("x", "f8"), ("y", "f8"), ("z", "f8"), ("floor", "i8"), ("walls", "i8")], align=True)
"""A point of a body in its axes: whether it may touch the floor, and walls and ceiling."""

RIM = np.dtype(
    [(name, "f8") for name in ("x", "y", "z", "ax", "ay", "az", "radius")]
    + [(name, "i8") for name in ("floor", "walls")],
    align=True,
)
"""A circular edge of a body: its centre, the direction of its axis, its radius; the rest as of a point."""

FACE = np.dtype(
    [("nx", "f8"), ("ny", "f8"), ("nz", "f8"), ("first", "i8"), ("count", "i8")],
    align=True,
)
"""A face of a hull: its outward normal in the body's axes, and its corners in a list of points,
counter-clockwise as seen from outside.
"""

PLANE = np.dtype(
    [(name, "f8") for name in ("nx", "ny", "nz", "offset", "mu_static", "mu_kinetic", "restitution")]
    + [("floor", "i8")],
    align=True,
)
"""A plane n·x = offset of the room, its normal into the room: the floor, a wall, the ceiling."""

PAIR = np.dtype(
    [("a", "i8"), ("b", "i8"), ("mu_static", "f8"), ("mu_kinetic", "f8"), ("restitution", "f8")],
    align=True,
)
"""Two bodies that may touch, and what holds there."""

POSE = np.dtype(
    [(name, "f8") for name in ("x", "y", "z", "qw", "qx", "qy", "qz")]
    + [(name, "f8") for name in ("vx", "vy", "vz", "lx", "ly", "lz", "wx", "wy", "wz")]
    + [(name, "f8") for name in ("jxx", "jxy", "jxz", "jyy", "jyz", "jzz")],
    align=True,
)
"""Where a body is and how it moves: G, the quaternion that turns its axes into the room's, velocity of G,
angular momentum, rotation rate, and the inverse of the inertia in the room's axes.
"""

CONTACT = np.dtype(
    [(name, "i8") for name in ("a", "b", "key", "stuck")]
    + [(name, "f8") for name in ("nx", "ny", "nz", "sx", "sy", "sz", "tx", "ty", "tz")]
    + [(name, "f8") for name in ("rax", "ray", "raz", "rbx", "rby", "rbz", "gap", "bent")]
    + [(name, "f8") for name in ("mu_static", "mu_kinetic", "mu", "target", "target_s", "target_t")]
    + [(name, "f8") for name in ("pn", "ps", "pt", "dn", "ds", "dt", "on", "os", "ot")]
    + [(name, "f8") for name in ("wnn", "wns", "wnt", "wss", "wst", "wtt", "stiff")],
    align=True,
)
"""A closed contact: bodies a and b (−1: the room), the normal towards a and two tangents, the levers about
both G, its gap and the acceleration by which free flight opens it, coefficients of friction, the velocity
wanted, impulses, their changes by a step of Newton's method, those before it, and the inverse mass that they
see.
"""

HISTORY = ("x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wx", "wy", "wz")
"""Columns of a body's history."""
