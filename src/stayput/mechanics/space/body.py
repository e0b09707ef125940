"""A body by itself: its pose, and how it drifts between impulses.

With the angular momentum L in the room's axes the rotation rate in the body's is ω = J⁻¹ Rᵀ L. Without a
moment L stays, so that a free body keeps momentum to rounding, and its rotation is integrated by Runge and
Kutta's method of fourth order in the quaternion.
"""

from stayput.compiling import inline, inner
from stayput.mechanics.space.vectors import added, cross, dot, quaternion_rate, turned_back, unit_quaternion


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
def in_room(s, a):
    """Return a vector of the body's axes in the room's."""
    return (
        s.rxx * a[0] + s.rxy * a[1] + s.rxz * a[2],
        s.ryx * a[0] + s.ryy * a[1] + s.ryz * a[2],
        s.rzx * a[0] + s.rzy * a[1] + s.rzz * a[2],
    )


@inline
def in_body(s, a):
    """Return a vector of the room's axes in the body's."""
    return (
        s.rxx * a[0] + s.ryx * a[1] + s.rzx * a[2],
        s.rxy * a[0] + s.ryy * a[1] + s.rzy * a[2],
        s.rxz * a[0] + s.ryz * a[1] + s.rzz * a[2],
    )


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
def set_attitude(body, s, q):
    """Set the quaternion, and what goes with it: the rotation R, R J⁻¹ Rᵀ, and the rotation rate."""
    w, x, y, z = unit_quaternion(q)
    s.qw, s.qx, s.qy, s.qz = w, x, y, z
    a, b, c = 2.0 * x, 2.0 * y, 2.0 * z
    s.rxx, s.rxy, s.rxz = 1.0 - (b * y + c * z), a * y - c * w, a * z + b * w
    s.ryx, s.ryy, s.ryz = a * y + c * w, 1.0 - (a * x + c * z), b * z - a * w
    s.rzx, s.rzy, s.rzz = a * z - b * w, b * z + a * w, 1.0 - (a * x + b * y)
    # J⁻¹ᐟ²Rᵀ, whose square is R J⁻¹ Rᵀ
    k1, k2, k3 = body.r1, body.r2, body.r3
    x1, x2, x3 = k1 * s.rxx, k2 * s.rxy, k3 * s.rxz
    y1, y2, y3 = k1 * s.ryx, k2 * s.ryy, k3 * s.ryz
    z1, z2, z3 = k1 * s.rzx, k2 * s.rzy, k3 * s.rzz
    s.jxx, s.jxy, s.jxz = (
        x1 * x1 + x2 * x2 + x3 * x3,
        x1 * y1 + x2 * y2 + x3 * y3,
        x1 * z1 + x2 * z2 + x3 * z3,
    )
    s.jyy, s.jyz = y1 * y1 + y2 * y2 + y3 * y3, y1 * z1 + y2 * z2 + y3 * z3
    s.jzz = z1 * z1 + z2 * z2 + z3 * z3
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
    k1, k2, k3 = body.r1, body.r2, body.r3
    return quaternion_rate(q, (k1 * k1 * spin[0], k2 * k2 * spin[1], k3 * k3 * spin[2]))


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
    set_attitude(body, s, q)


@inline
def sag(body, s, h):
    """Return how far below the chord of a step the path of a body's point bends, at most."""
    return 0.125 * h * h * body.radius * (s.wx * s.wx + s.wy * s.wy + s.wz * s.wz)


@inline
def nudge(body, s, move, turn):
    """Move a body by a small way and turn it by a small vector; its momenta stay."""
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
    set_attitude(body, s, q)


@inline
def stop(s):
    """Bring a body to rest."""
    s.vx = s.vy = s.vz = s.lx = s.ly = s.lz = s.wx = s.wy = s.wz = 0.0
