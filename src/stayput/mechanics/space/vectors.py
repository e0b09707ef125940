"""Vectors and quaternions as tuples of floats, which compiled functions keep in registers."""

import math

from stayput.compiling import inline


@inline
def dot(a, b):
    """Return a·b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@inline
def cross(a, b):
    """Return a × b."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@inline
def added(a, factor, b):
    """Return a + factor · b."""
    return a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]


@inline
def scaled(factor, a):
    """Return factor · a."""
    return factor * a[0], factor * a[1], factor * a[2]


@inline
def normal_of(what):
    """Return the normal of a plane, contact, face or device."""
    return what.nx, what.ny, what.nz


@inline
def norm(a):
    """Return |a|."""
    return math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])


@inline
def turned(q, a):
    """Return a vector a of a body's axes in the room's, by the unit quaternion q."""
    w, x, y, z = q
    t = cross((x, y, z), a)
    t = 2.0 * t[0], 2.0 * t[1], 2.0 * t[2]
    u = cross((x, y, z), t)
    return a[0] + w * t[0] + u[0], a[1] + w * t[1] + u[1], a[2] + w * t[2] + u[2]


@inline
def turned_back(q, a):
    """Return a vector a of the room's axes in a body's."""
    return turned((q[0], -q[1], -q[2], -q[3]), a)


@inline
def quaternion_rate(q, w):
    """Return q̇ = q w / 2 at a rotation rate w in the body's axes."""
    return (
        0.5 * (-q[1] * w[0] - q[2] * w[1] - q[3] * w[2]),
        0.5 * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]),
        0.5 * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]),
        0.5 * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]),
    )


@inline
def unit_quaternion(q):
    """Return q over its length."""
    size = math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
    return q[0] / size, q[1] / size, q[2] / size, q[3] / size


@inline
def tangents(n):
    """Return two directions that make a right-handed frame with the unit vector n."""
    if abs(n[0]) < 0.5:
        s = 1.0 - n[0] * n[0], -n[0] * n[1], -n[0] * n[2]
    else:
        s = -n[1] * n[0], 1.0 - n[1] * n[1], -n[1] * n[2]
    size = norm(s)
    s = s[0] / size, s[1] / size, s[2] / size
    return s, cross(n, s)
