"""Impulses beyond Newton's law with friction: of landings, and where they would make energy.

The impulses of a rigid landing are at the edge that lands, and leave Housner's rate. A flat base lands over
a region, where it loses less (`stayput.model.soft_base.landing_factor`), and the floor may take more (the
paper's Eq. 3.14): both are a factor on the rate, about the point that has landed, which stays where it is.

As in the plane (`stayput.mechanics.impact`): where Newton's restitution with friction makes energy, impulses
are those of a plastic impact, times 1 + the least restitution of the contacts that bounce.
"""

from __future__ import annotations

import math

from stayput.compiling import inline, inner
from stayput.mechanics.space.body import kinetic_energy, rotation, velocity
from stayput.mechanics.space.contact import lever_a, opening, slip
from stayput.mechanics.space.solve import IMPACT, apply, apply_one, solve
from stayput.mechanics.space.touching import ROOM
from stayput.mechanics.space.vectors import added, cross, dot, norm, scaled

RISES = 1e-4
"""Speed from which on the old edge has left the floor [m/s]."""


@inner
def _edges(contacts, count, b, poses):
    """Return the levers of where a body has landed on the floor and of what it has left; whether both are."""
    landed, left = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
    weight, many = 0.0, 0
    for c in contacts[:count]:
        if c.a != b or not c.floor:
            continue
        if c.closing < -IMPACT and c.pn > 0.0:
            landed = added(landed, c.pn, lever_a(c))
            weight += c.pn
        elif c.closing >= -IMPACT and opening(c, poses) > RISES:
            left = added(left, 1.0, lever_a(c))
            many += 1
    if weight == 0.0 or many == 0:
        return landed, left, False
    return scaled(1.0 / weight, landed), scaled(1.0 / many, left), True


@inline
def _factor(body, s, landed, left):
    """Return the factor on the rate; 1 where the centre of gravity is not between the edges."""
    w = rotation(s)
    level = math.sqrt(w[0] * w[0] + w[1] * w[1])
    size = norm(w)
    if level <= 1e-9 * size or size == 0.0:
        return 1.0
    over = w[1] / level, -w[0] / level, 0.0
    a2 = -dot(over, landed) * dot(over, left)
    if a2 <= 0.0:
        return 1.0
    K = dot(w, (s.lx, s.ly, s.lz)) / (size * size * body.mass) + landed[2] * landed[2]
    xi = body.landing_place
    at_corner = max(1e-3, (K - a2) / (K + a2))
    inside = (K - xi * a2) / (K + xi * a2)
    return body.restitution * (max(1.0, inside / at_corner) if xi < 1.0 else 1.0)


@inner
def land(contacts, count, bodies, before, after):
    """Scale the rotation of bodies whose other edge has landed in a step."""
    for b in range(bodies.shape[0]):
        body, s = bodies[b], after[b]
        if body.restitution == 1.0 and body.landing_place == 1.0:
            continue
        landed, left, both = _edges(contacts, count, b, after)
        if not both:
            continue
        change = _factor(body, s, landed, left) - 1.0
        # with the change q the energy is that after the landing and a q² + b q, and not above that before
        w, v = rotation(s), velocity(s)
        d = cross(landed, w)
        turning = dot(w, (s.lx, s.ly, s.lz))
        square = 0.5 * (body.mass * dot(d, d) + turning)
        linear = body.mass * dot(v, d) + turning
        if square == 0.0:
            continue
        if change > 0.0:
            room = linear * linear + 4.0 * square * max(
                kinetic_energy(body, before[b]) - kinetic_energy(body, s), 0.0
            )
            change = max(0.0, min(change, (math.sqrt(room) - linear) / (2.0 * square)))
        else:
            change = min(0.0, max(change, -linear / square))
        s.vx, s.vy, s.vz = added(v, change, d)
        s.lx, s.ly, s.lz = (1.0 + change) * s.lx, (1.0 + change) * s.ly, (1.0 + change) * s.lz
        s.wx, s.wy, s.wz = scaled(1.0 + change, w)


MADE = 1e-9
"""Share of the kinetic energy that rounding may make."""

SQUARE = 1e-3
"""Slip of a contact that closes, as a share of its closing velocity, up to which it does not slip."""


@inner
def _energy(bodies, poses):
    energy = 0.0
    for b in range(bodies.shape[0]):
        energy += kinetic_energy(bodies[b], poses[b])
    return energy


@inner
def bounces(contacts, count):
    """Return whether any contact closes so fast that it bounces."""
    for k in range(count):
        if contacts[k].bounce > 0.0:
            return True
    return False


@inline
def hits_square(c, poses):
    """Return whether a contact closes in an impact and does not slip before it."""
    us, ut = slip(c, poses)
    return c.closing < -IMPACT and math.sqrt(us * us + ut * ut) <= SQUARE * -c.closing


@inner
def mark_what_hits(contacts, count, marks, speed):
    """Mark with 1 the bodies at contacts that close faster than a speed, and all that presses on these."""
    for b in range(marks.shape[0]):
        marks[b] = 0
    spread = False
    for c in contacts[:count]:
        if c.closing < -speed and c.pn > 0.0:
            marks[c.a] = 1
            spread = True
    while spread:
        spread = False
        for c in contacts[:count]:
            if c.b != ROOM and c.pn > 0.0 and marks[c.a] != marks[c.b]:
                marks[c.a] = marks[c.b] = 1
                spread = True


@inner
def _bounce_alike(contacts, count, bodies, poses, marks, factor):
    """Give all that presses on bodies that hit, or on what touches them, a further part of its impulse."""
    mark_what_hits(contacts, count, marks, IMPACT)
    for c in contacts[:count]:
        if marks[c.a]:
            apply_one(c, bodies, poses, factor)
            c.pn, c.ps, c.pt = (1.0 + factor) * c.pn, (1.0 + factor) * c.ps, (1.0 + factor) * c.pt


@inner
def mend(contacts, count, held, bodies, poses, system, h, work):
    """Replace impulses that make energy by those of a plastic impact, times 1 + the least restitution.

    Plastic impulses p give velocities with p·u⁺ ≤ 0, so that 1 + e times these make no energy for any e ≤ 1.

    Returns
    -------
    bool
        Whether the impulses that there are now hold at all contacts.
    """
    after = _energy(bodies, poses)
    apply(contacts, count, bodies, poses, -1.0)
    if after <= _energy(bodies, poses) * (1.0 + MADE):
        apply(contacts, count, bodies, poses, 1.0)
        return True
    least = 1.0
    for c in contacts[:count]:
        if c.bounce > 0.0:
            c.target, least = 0.0, min(least, c.bounce)
        c.pn = c.ps = c.pt = 0.0
    converged = solve(contacts, count, held, bodies, poses, system, h, work)
    _bounce_alike(contacts, count, bodies, poses, system[3], least)
    return converged
