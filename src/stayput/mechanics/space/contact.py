"""A closed contact: its frame and levers, how fast it slips, and an impulse at it."""

from __future__ import annotations

from stayput.compiling import inline
from stayput.mechanics.space.body import angular_response, rotation, velocity
from stayput.mechanics.space.touching import ROOM
from stayput.mechanics.space.vectors import added, cross, dot


@inline
def normal_of(c):
    """Return a contact's normal, towards body a."""
    return c.nx, c.ny, c.nz


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
def velocity_at(s, lever):
    """Return the velocity of a body's point, given from G."""
    return added(velocity(s), 1.0, cross(rotation(s), lever))


@inline
def slip(c, poses):
    """Return the relative velocity of body a at a contact, in the room's axes."""
    u = velocity_at(poses[c.a], lever_a(c))
    if c.b != ROOM:
        u = added(u, -1.0, velocity_at(poses[c.b], lever_b(c)))
    return u


@inline
def turns_back(c, before, after):
    """Return whether a contact slips against the way in which it slipped before: it has stood between."""
    u, v, n = slip(c, before), slip(c, after), normal_of(c)
    return dot(u, v) - dot(n, u) * dot(n, v) < 0.0


@inline
def beyond_target(c, poses):
    """Return the relative velocity less that wanted, along the normal and the tangents."""
    u = slip(c, poses)
    return (
        dot(normal_of(c), u) - c.target,
        dot(first_tangent(c), u) - c.target_s,
        dot(second_tangent(c), u) - c.target_t,
    )


@inline
def mobility(body, s, lever, n):
    """Return how far a unit of impulse along n moves a body's point along n, in velocity."""
    arm = cross(lever, n)
    return 1.0 / body.mass + dot(arm, angular_response(s, arm))


@inline
def give_impulse(body, s, lever, factor, p):
    """Apply an impulse times a factor at a body's point, given from G."""
    share = factor * body.rm * body.rm
    s.vx += share * p[0]
    s.vy += share * p[1]
    s.vz += share * p[2]
    moment = cross(lever, p)
    moment = factor * moment[0], factor * moment[1], factor * moment[2]
    s.lx += moment[0]
    s.ly += moment[1]
    s.lz += moment[2]
    w = angular_response(s, moment)
    s.wx += w[0]
    s.wy += w[1]
    s.wz += w[2]


@inline
def push(c, bodies, poses, p):
    """Apply an impulse at a contact, to body a and against body b."""
    give_impulse(bodies[c.a], poses[c.a], lever_a(c), 1.0, p)
    if c.b != ROOM:
        give_impulse(bodies[c.b], poses[c.b], lever_b(c), -1.0, p)
