"""The contact problem of a step: impulses at all closed contacts at once.

With the impulses p of the contacts the velocities after a step of length h are

    v⁺ = v + h g + Σ pᵢ/m,    L⁺ = L + Σ rᵢ × pᵢ,

and each contact asks (Moreau 1988; Jean 1999) for u_n⁺ ≥ −e u_n⁻, p_n ≥ 0, one of them equal, and by
Coulomb's law for |p_t| ≤ μ p_n, with p_t against u_t⁺ where it slips. The impulses are found contact by
contact, again and again, each with the others as they are (projected Gauss–Seidel), from those of the step
before. A body on more than three points has no unique impulses; its motion is unique without friction, and
taken as found with it.

A contact sticks by its static coefficient as long as it did before the step; where it slips in the solution
its kinetic one takes over and all is solved again.
"""

from __future__ import annotations

import math

from stayput.compiled import inline, inner
from stayput.mechanics.space.body import angular_response, rotation, velocity
from stayput.mechanics.space.touching import ROOM
from stayput.mechanics.space.vectors import added, cross, dot, scaled, tangents

IMPACT = 1e-3
"""Closing velocity from which on a contact bounces [m/s]."""

ACCURACY = 1e-7
"""Change of any contact's acceleration in a sweep at which the impulses are accepted [m/s²]."""

STICKS = 1e-4
"""Acceleration from rest up to which a contact has not slipped [m/s²]."""

MOST_SWEEPS = 20_000
"""Sweeps after which a step is taken as it is, and counted as not converged."""


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
def give_impulse(body, s, lever, factor, p):
    """Apply an impulse times a factor at a body's point, given from G."""
    s.vx += factor * p[0] / body.mass
    s.vy += factor * p[1] / body.mass
    s.vz += factor * p[2] / body.mass
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


@inline
def _seen(body, s, lever, along, by):
    """Return the velocity in one direction that a unit impulse in another gives a body's point."""
    turned = angular_response(s, cross(lever, by))
    return dot(along, by) / body.mass + dot(along, cross(turned, lever))


@inline
def _inverse_mass(c, bodies, poses, along, by):
    found = _seen(bodies[c.a], poses[c.a], lever_a(c), along, by)
    if c.b != ROOM:
        found += _seen(bodies[c.b], poses[c.b], lever_b(c), along, by)
    return found


@inner
def prepare(c, bodies, poses, restitution):
    """Set a contact's frame, inverse masses and the normal velocity wanted; its normal and levers are set."""
    n = normal_of(c)
    s, t = tangents(n)
    c.sx, c.sy, c.sz = s
    c.tx, c.ty, c.tz = t
    c.wnn = _inverse_mass(c, bodies, poses, n, n)
    c.wns = _inverse_mass(c, bodies, poses, n, s)
    c.wnt = _inverse_mass(c, bodies, poses, n, t)
    c.wss = _inverse_mass(c, bodies, poses, s, s)
    c.wst = _inverse_mass(c, bodies, poses, s, t)
    c.wtt = _inverse_mass(c, bodies, poses, t, t)
    half, off = 0.5 * (c.wss - c.wtt), c.wst
    c.stiff = 0.5 * (c.wss + c.wtt) + math.sqrt(half * half + off * off)
    c.closing = dot(n, slip(c, poses))
    c.target = -restitution * c.closing if c.closing < -IMPACT else 0.0
    c.mu = c.mu_static if c.stuck else c.mu_kinetic


@inner
def _update(c, bodies, poses):
    """Find a contact's impulse with the others as they are; return the largest change of its velocities."""
    u = slip(c, poses)
    n, s, t = normal_of(c), first_tangent(c), second_tangent(c)
    pn = max(0.0, c.pn - (dot(n, u) - c.target) / c.wnn)
    ps = pt = 0.0
    if pn > 0.0:
        us = dot(s, u) + c.wns * (pn - c.pn)
        ut = dot(t, u) + c.wnt * (pn - c.pn)
        # where it sticks nothing slips
        det = c.wss * c.wtt - c.wst * c.wst
        ps = c.ps - (c.wtt * us - c.wst * ut) / det
        pt = c.pt - (c.wss * ut - c.wst * us) / det
        if ps * ps + pt * pt > (c.mu * pn) ** 2:
            # a step against the slip, back onto the cone; the larger stiffness makes it converge
            ps, pt = c.ps - us / c.stiff, c.pt - ut / c.stiff
            size = math.sqrt(ps * ps + pt * pt)
            if size > c.mu * pn:
                ps, pt = ps * c.mu * pn / size, pt * c.mu * pn / size
    dn, ds, dt = pn - c.pn, ps - c.ps, pt - c.pt
    if dn == 0.0 and ds == 0.0 and dt == 0.0:
        return 0.0
    c.pn, c.ps, c.pt = pn, ps, pt
    p = added(added((dn * n[0], dn * n[1], dn * n[2]), ds, s), dt, t)
    push(c, bodies, poses, p)
    return max(abs(dn) * c.wnn, max(abs(ds), abs(dt)) * c.stiff)


@inner
def slip_rate(c, poses):
    """Return how fast a contact slips."""
    u = slip(c, poses)
    us, ut = dot(first_tangent(c), u), dot(second_tangent(c), u)
    return math.sqrt(us * us + ut * ut)


@inner
def _let_slip(contacts, count, poses, h):
    """Give contacts that slip by their static coefficient their kinetic one; return whether any did."""
    found = False
    for k in range(count):
        c = contacts[k]
        if c.mu > c.mu_kinetic and c.pn > 0.0 and slip_rate(c, poses) > STICKS * h:
            c.mu = c.mu_kinetic
            found = True
    return found


@inner
def begin(contacts, count, bodies, poses):
    """Apply the impulses that the contacts have from the step before."""
    for k in range(count):
        c = contacts[k]
        n, s, t = normal_of(c), first_tangent(c), second_tangent(c)
        push(c, bodies, poses, added(added(scaled(c.pn, n), c.ps, s), c.pt, t))


@inner
def solve(contacts, count, bodies, poses, h):
    """Find the impulses of a step; the velocities are with those of ``contacts``, before and after.

    Returns
    -------
    bool
        Whether they converged.
    """
    for _ in range(MOST_SWEEPS):
        change = 0.0
        for k in range(count):
            change = max(change, _update(contacts[k], bodies, poses))
        if change <= ACCURACY * h and not _let_slip(contacts, count, poses, h):
            return True
    return False
