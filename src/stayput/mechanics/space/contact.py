"""A closed contact: its frame and levers, how fast it slips, and an impulse at it."""

import math

from stayput.compiling import inline
from stayput.mechanics.space.body import angular_response, rotation, velocity
from stayput.mechanics.space.touching import ROOM
from stayput.mechanics.space.vectors import added, cross, dot, normal_of, scaled


@inline
def first_tangent(c):
    """Return a contact's first tangent."""
    return c.sx, c.sy, c.sz


@inline
def second_tangent(c):
    """Return a contact's second tangent."""
    return c.tx, c.ty, c.tz


@inline
def lever_a(c):
    """Return the contact from G of body a."""
    return c.rax, c.ray, c.raz


@inline
def lever_b(c):
    """Return the contact from G of body b."""
    return c.rbx, c.rby, c.rbz


@inline
def friction_lever_a(c):
    """Return where the friction of the contact acts, from G of body a."""
    return c.fax, c.fay, c.faz


@inline
def friction_lever_b(c):
    """Return where the friction of the contact acts, from G of body b."""
    return c.fbx, c.fby, c.fbz


@inline
def velocity_at(s, lever):
    """Return the velocity of a body's point, given from G."""
    return added(velocity(s), 1.0, cross(rotation(s), lever))


@inline
def opening(c, poses):
    """Return how fast a contact opens."""
    u = velocity_at(poses[c.a], lever_a(c))
    if c.b != ROOM:
        u = added(u, -1.0, velocity_at(poses[c.b], lever_b(c)))
    return dot(normal_of(c), u)


@inline
def slip(c, poses):
    """Return the velocity of body a, relative to b, along the tangents where friction acts."""
    u = velocity_at(poses[c.a], friction_lever_a(c))
    if c.b != ROOM:
        u = added(u, -1.0, velocity_at(poses[c.b], friction_lever_b(c)))
    return dot(first_tangent(c), u), dot(second_tangent(c), u)


@inline
def turns_back(c, before, after):
    """Return whether a contact slips against the way in which it slipped before."""
    u, v = slip(c, before), slip(c, after)
    return u[0] * v[0] + u[1] * v[1] < 0.0


@inline
def stands_at(c, before, after):
    """Return when a contact that slips stands, over a step's length, with its friction always against that.

    It is taken to slow down evenly; inf where it does not.
    """
    u, v = slip(c, before), slip(c, after)
    speed = math.sqrt(u[0] * u[0] + u[1] * u[1])
    if speed == 0.0:
        return 0.0
    along, friction = (u[0] * v[0] + u[1] * v[1]) / speed, (u[0] * c.ps + u[1] * c.pt) / speed
    slows = speed - along + c.stiff * (c.mu_kinetic * c.pn + friction)
    return speed / slows if slows > 0.0 else math.inf


@inline
def beyond_target(c, poses):
    """Return the relative velocity less that wanted, along the normal and the tangents."""
    us, ut = slip(c, poses)
    return opening(c, poses) - c.target, us - c.target_s, ut - c.target_t


@inline
def mobility(body, s, lever, n):
    """Return how far a unit of impulse along n moves a body's point along n, in velocity."""
    arm = cross(lever, n)
    return 1.0 / body.mass + dot(arm, angular_response(s, arm))


@inline
def give_impulse(body, s, lever, factor, p):
    """Apply an impulse times a factor at a body's point, given from G."""
    _give(body, s, factor, p, cross(lever, p))


@inline
def _give(body, s, factor, p, moment):
    share = factor * body.rm * body.rm
    s.vx += share * p[0]
    s.vy += share * p[1]
    s.vz += share * p[2]
    moment = factor * moment[0], factor * moment[1], factor * moment[2]
    s.lx += moment[0]
    s.ly += moment[1]
    s.lz += moment[2]
    w = angular_response(s, moment)
    s.wx += w[0]
    s.wy += w[1]
    s.wz += w[2]


@inline
def rolling_axis(c):
    """Return the axis about which a contact rolls."""
    return c.qx, c.qy, c.qz


@inline
def turn(c, bodies, poses, pr):
    """Apply an impulse of moment about the axis about which a contact rolls."""
    _give(bodies[c.a], poses[c.a], 1.0, (0.0, 0.0, 0.0), scaled(pr, rolling_axis(c)))


@inline
def push(c, bodies, poses, pn, ps, pt):
    """Apply an impulse along the axes of a contact, to body a and against body b."""
    normal, friction = scaled(pn, normal_of(c)), added(scaled(ps, first_tangent(c)), pt, second_tangent(c))
    p = added(normal, 1.0, friction)
    moment = added(cross(lever_a(c), normal), 1.0, cross(friction_lever_a(c), friction))
    _give(bodies[c.a], poses[c.a], 1.0, p, moment)
    if c.b != ROOM:
        moment = added(cross(lever_b(c), normal), 1.0, cross(friction_lever_b(c), friction))
        _give(bodies[c.b], poses[c.b], -1.0, p, moment)
