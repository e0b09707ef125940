"""Impacts whose impulses by the usual law would make energy.

As in the plane (`stayput.mechanics.impact`): where Newton's restitution with friction makes energy, impulses
are those of a plastic impact, times 1 + the least restitution of the contacts that bounce.
"""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.space.body import kinetic_energy
from stayput.mechanics.space.contact import slip
from stayput.mechanics.space.solve import IMPACT, apply, apply_one, solve
from stayput.mechanics.space.touching import ROOM

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
