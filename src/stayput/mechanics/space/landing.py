"""A base that lands on its other edge: the rotation rate after it, by the floor's laws.

The impulses of a rigid landing are at the edge that lands, and leave Housner's rate. A flat base lands over
a region, where it loses less (`stayput.model.soft_base.landing_factor`), and the floor may take more (the
paper's Eq. 3.14): both are a factor on the rate, about the point that has landed, which stays where it is.
"""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.space.body import kinetic_energy, rotation, velocity
from stayput.mechanics.space.contact import lever_a, opening
from stayput.mechanics.space.solve import IMPACT
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
