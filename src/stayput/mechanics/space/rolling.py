"""Rolling resistance: a moment M against the rolling of a rim on the floor.

A rim that is tilted rolls about the horizontal q below its axis a, q = (a − (n·a) n)/|a − (n·a) n|, at the
rate ω·q. Coulomb's law of rolling has an arm f [m] by which the floor's force N may lie ahead of the contact:

    |M| ≤ f N,    M = −f N sign(ω·q) where it rolls.

What tips over a rim turns across q, and feels nothing of it.
"""

from stayput.compiling import inline, inner
from stayput.mechanics.space.body import angular_response, in_body, in_room, rotation
from stayput.mechanics.space.contact import rolling_axis, turn
from stayput.mechanics.space.vectors import added, dot, norm, normal_of, scaled


@inline
def set_rolling(c, s, rim, arm):
    """Let a contact of a tilted rim resist rolling with an arm f [m]."""
    axis, n = in_room(s, (rim.ax, rim.ay, rim.az)), normal_of(c)
    level = added(axis, -dot(n, axis), n)
    c.roll, (c.qx, c.qy, c.qz) = arm, scaled(1.0 / norm(level), level)


@inner
def _bear(c, bodies, poses, moment, pn):
    """Give a contact a moment, as far as it bears it with a normal impulse; return the change."""
    most = c.roll * pn
    change = min(max(moment, -most), most) - c.pr
    c.pr += change
    turn(c, bodies, poses, change)
    return change


@inner
def resist(c, bodies, poses):
    """Find a contact's moment with all else as it is; return the change of the velocity of its point.

    The change of its normal impulse that a sweep has proposed counts already.
    """
    if c.roll == 0.0:
        return 0.0
    s, q = poses[c.a], rolling_axis(c)
    gives = dot(q, angular_response(s, q))
    change = _bear(c, bodies, poses, c.pr - dot(q, rotation(s)) / gives, c.pn + c.dn)
    return abs(change) * gives * bodies[c.a].radius


@inline
def _rate(c, bodies, poses):
    """Return the rate at which a contact rolls, by the scaled rotation of its body."""
    body, q = bodies[c.a], in_body(poses[c.a], rolling_axis(c))
    return q[0] * body.r1, q[1] * body.r2, q[2] * body.r3


@inner
def hold_rolling(c, bodies, poses, matrix, vector, firm):
    """Add to Newton's system that a contact does not roll which bears less than it can.

    ``firm`` is the penalty of the rate, times the inverse inertia that the contact sees.
    """
    c.grip = 0.0
    if abs(c.pr) < c.roll * c.pn * (1.0 - 1e-12):
        row = _rate(c, bodies, poses)
        c.grip = firm / dot(row, row)
        c.dr = -c.grip * dot(rolling_axis(c), rotation(poses[c.a]))
        for i in range(3):
            vector[c.a, 3 + i] += row[i] * c.dr
            for j in range(3):
                matrix[c.a, c.a, 3 + i, 3 + j] += c.grip * row[i] * row[j]


@inner
def add_resistance(c, bodies, poses, vector):
    """Change a contact's moment by what was found, as far as it bears it."""
    if c.grip > 0.0:
        gained = vector[c.a, 3], vector[c.a, 4], vector[c.a, 5]
        _bear(c, bodies, poses, c.pr + c.dr - c.grip * dot(_rate(c, bodies, poses), gained), c.pn)
