"""A body by itself: its pose, and how it drifts between impulses.

With the angular momentum L in the room's axes the rotation rate in the body's is ω = J⁻¹ Rᵀ L. Without a
moment L stays, so that a free body keeps momentum to rounding, and its rotation is integrated by Runge and
Kutta's method of fourth order in the quaternion.
"""

from __future__ import annotations

from stayput.compiled import inline, inner
from stayput.mechanics.space.vectors import (
    added,
    cross,
    dot,
    quaternion_rate,
    turned,
    turned_back,
    unit_quaternion,
)


@inline
def place_of(s):
    """Return G."""
    return s.x, s.y, s.z


@inline
def attitude(s):
    """Return the quaternion."""
    return s.qw, s.qx, s.qy, s.qz


@inline
def velocity(s):
    """Return the velocity of G."""
    return s.vx, s.vy, s.vz


@inline
def rotation(s):
    """Return the rotation rate ω."""
    return s.wx, s.wy, s.wz


@inline
def kinetic_energy(body, s):
    """Return the kinetic energy."""
    v, w = velocity(s), rotation(s)
    return 0.5 * (body.mass * dot(v, v) + dot(w, (s.lx, s.ly, s.lz)))


@inline
def angular_response(s, moment):
    """Return J⁻¹ times an impulse of moment, in the room's axes."""
    return (
        s.jxx * moment[0] + s.jxy * moment[1] + s.jxz * moment[2],
        s.jxy * moment[0] + s.jyy * moment[1] + s.jyz * moment[2],
        s.jxz * moment[0] + s.jyz * moment[1] + s.jzz * moment[2],
    )


@inline
def update_inertia(body, s):
    """Set the inverse inertia in the room's axes, R J⁻¹ Rᵀ, and the rotation rate."""
    q = attitude(s)
    e1, e2, e3 = turned(q, (1.0, 0.0, 0.0)), turned(q, (0.0, 1.0, 0.0)), turned(q, (0.0, 0.0, 1.0))
    k1, k2, k3 = 1.0 / body.i1, 1.0 / body.i2, 1.0 / body.i3
    s.jxx = k1 * e1[0] * e1[0] + k2 * e2[0] * e2[0] + k3 * e3[0] * e3[0]
    s.jxy = k1 * e1[0] * e1[1] + k2 * e2[0] * e2[1] + k3 * e3[0] * e3[1]
    s.jxz = k1 * e1[0] * e1[2] + k2 * e2[0] * e2[2] + k3 * e3[0] * e3[2]
    s.jyy = k1 * e1[1] * e1[1] + k2 * e2[1] * e2[1] + k3 * e3[1] * e3[1]
    s.jyz = k1 * e1[1] * e1[2] + k2 * e2[1] * e2[2] + k3 * e3[1] * e3[2]
    s.jzz = k1 * e1[2] * e1[2] + k2 * e2[2] * e2[2] + k3 * e3[2] * e3[2]
    s.wx, s.wy, s.wz = angular_response(s, (s.lx, s.ly, s.lz))


@inline
def bend(body, s, lever):
    """Return the acceleration of a body's point, given from G, in free flight without gravity."""
    spin = rotation(s)
    moment = cross(spin, (s.lx, s.ly, s.lz))
    change = angular_response(s, moment)
    return added(cross(spin, cross(spin, lever)), -1.0, cross(change, lever))


@inline
def _free_rate(body, q, momentum):
    spin = turned_back(q, momentum)
    return quaternion_rate(q, (spin[0] / body.i1, spin[1] / body.i2, spin[2] / body.i3))


@inline
def _ahead(q, h, k):
    return q[0] + h * k[0], q[1] + h * k[1], q[2] + h * k[2], q[3] + h * k[3]


@inner
def drift(body, s, h):
    """Move a body freely for h, without gravity: its momenta stay."""
    s.x += h * s.vx
    s.y += h * s.vy
    s.z += h * s.vz
    momentum = s.lx, s.ly, s.lz
    if momentum[0] == 0.0 and momentum[1] == 0.0 and momentum[2] == 0.0:
        return
    q = attitude(s)
    k1 = _free_rate(body, q, momentum)
    k2 = _free_rate(body, _ahead(q, 0.5 * h, k1), momentum)
    k3 = _free_rate(body, _ahead(q, 0.5 * h, k2), momentum)
    k4 = _free_rate(body, _ahead(q, h, k3), momentum)
    sixth = h / 6.0
    q = (
        q[0] + sixth * (k1[0] + 2.0 * k2[0] + 2.0 * k3[0] + k4[0]),
        q[1] + sixth * (k1[1] + 2.0 * k2[1] + 2.0 * k3[1] + k4[1]),
        q[2] + sixth * (k1[2] + 2.0 * k2[2] + 2.0 * k3[2] + k4[2]),
        q[3] + sixth * (k1[3] + 2.0 * k2[3] + 2.0 * k3[3] + k4[3]),
    )
    s.qw, s.qx, s.qy, s.qz = unit_quaternion(q)
    update_inertia(body, s)


@inline
def sag(body, s, h):
    """Return how far below the chord of a step the path of a body's point bends, at most."""
    return 0.125 * h * h * body.radius * (s.wx * s.wx + s.wy * s.wy + s.wz * s.wz)


@inline
def nudge(s, move, turn):
    """Move a body by a small way and turn it by a small vector; its velocities stay."""
    s.x += move[0]
    s.y += move[1]
    s.z += move[2]
    q = attitude(s)
    half = 0.5 * turn[0], 0.5 * turn[1], 0.5 * turn[2]
    q = (
        q[0] - half[0] * q[1] - half[1] * q[2] - half[2] * q[3],
        q[1] + half[0] * q[0] + half[1] * q[3] - half[2] * q[2],
        q[2] + half[1] * q[0] + half[2] * q[1] - half[0] * q[3],
        q[3] + half[2] * q[0] + half[0] * q[2] - half[1] * q[1],
    )
    s.qw, s.qx, s.qy, s.qz = unit_quaternion(q)


@inline
def stop(s):
    """Bring a body to rest."""
    s.vx = s.vy = s.vz = s.lx = s.ly = s.lz = s.wx = s.wy = s.wz = 0.0


@inline
def copy_pose(source, target):
    """Copy a pose."""
    target.x, target.y, target.z = source.x, source.y, source.z
    target.qw, target.qx, target.qy, target.qz = source.qw, source.qx, source.qy, source.qz
    target.vx, target.vy, target.vz = source.vx, source.vy, source.vz
    target.lx, target.ly, target.lz = source.lx, source.ly, source.lz
    target.wx, target.wy, target.wz = source.wx, source.wy, source.wz
    target.jxx, target.jxy, target.jxz = source.jxx, source.jxy, source.jxz
    target.jyy, target.jyz, target.jzz = source.jyy, source.jyz, source.jzz
