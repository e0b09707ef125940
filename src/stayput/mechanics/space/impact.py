"""Impacts that have no impulses by the usual law, or whose impulses would make energy.

As in the plane (`stayput.mechanics.impact`): where Newton's restitution with friction makes energy, impulses
are those of a plastic impact, times 1 + the least restitution of the contacts that bounce. Where no impulses
are found for all contacts at once, those of one pair (two bodies, or a body and a plane) follow one another,
each by itself, the pair first whose contacts close fastest: with restitution, or plastic where that makes
energy. Each plastic one takes energy. Where they do not end, a body between planes stops.
"""

from __future__ import annotations

from stayput.compiling import inline, inner
from stayput.mechanics.space.body import kinetic_energy, stop
from stayput.mechanics.space.contact import normal_of, slip
from stayput.mechanics.space.solve import IMPACT, apply, apply_one, solve, update, update_surely
from stayput.mechanics.space.touching import ROOM
from stayput.mechanics.space.vectors import added, dot, norm

MADE = 1e-9
"""Share of the kinetic energy that rounding may make."""

MOST_IN_A_ROW = 200
"""Most impacts of single pairs in a step."""

SQUARE = 1e-3
"""Slip of a contact that closes, as a share of its closing velocity, up to which it does not slip."""

SWEEPS_OF_PAIR, SURE_AFTER = 50, 40
"""Most sweeps for the impulses of one pair, and after how many each contact is solved surely."""

SURELY = 360.0
"""Work of an update by bisection, of one by sweeps: half of the halvings and steps that it may take."""

CLOSING = 1e-9
"""Velocity beyond that wanted from which on a contact closes [m/s]."""

SETTLED = 1e-11
"""Change of a velocity in a sweep at which the impulses of one pair are accepted [m/s]."""


@inner
def _energy(bodies, poses):
    found = 0.0
    for b in range(bodies.shape[0]):
        found += kinetic_energy(bodies[b], poses[b])
    return found


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
    u, n = slip(c, poses), normal_of(c)
    across = added(u, -c.closing, n)
    return c.closing < -IMPACT and norm(across) <= SQUARE * -c.closing


@inner
def mark_what_hits(contacts, count, marks, speed):
    """Mark with 1 the bodies at contacts that close faster than a speed, and all that presses on these."""
    for b in range(marks.shape[0]):
        marks[b] = 0
    found = False
    for k in range(count):
        c = contacts[k]
        if c.closing < -speed and c.pn > 0.0:
            marks[c.a] = 1
            found = True
    while found:
        found = False
        for k in range(count):
            c = contacts[k]
            if c.b != ROOM and c.pn > 0.0 and marks[c.a] != marks[c.b]:
                marks[c.a] = marks[c.b] = 1
                found = True


@inner
def _bounce_alike(contacts, count, bodies, poses, marks, factor):
    """Give all that presses on bodies that hit, or on what touches them, a further part of its impulse."""
    mark_what_hits(contacts, count, marks, IMPACT)
    for k in range(count):
        c = contacts[k]
        if marks[c.a]:
            apply_one(c, bodies, poses, factor)
            c.pn, c.ps, c.pt = (1.0 + factor) * c.pn, (1.0 + factor) * c.ps, (1.0 + factor) * c.pt


@inline
def _beyond(c, poses):
    """Return the normal velocity beyond that which a contact may close with."""
    return dot(normal_of(c), slip(c, poses)) - min(c.target, 0.0)


@inner
def _meet(contacts, count, pair, bodies, poses, restitution):
    """Find the impulses of the contacts of one pair by themselves, and add them to the sums.

    Returns
    -------
    float
        The work that it took: updates of contacts.
    """
    done = 0.0
    still = SQUARE * -_beyond(pair, poses)
    for k in range(count):
        c = contacts[k]
        if c.a == pair.a and c.b == pair.b and c.plane == pair.plane:
            u, n = slip(c, poses), normal_of(c)
            closing = dot(n, u)
            c.mu = c.mu_static if norm(added(u, -closing, n)) <= still else c.mu_kinetic
            if c.bounce > 0.0:
                c.target = -restitution * c.bounce * closing if closing < -IMPACT else 0.0
            c.pn = c.ps = c.pt = 0.0
    for number in range(SWEEPS_OF_PAIR):
        change = 0.0
        for k in range(count):
            c = contacts[k]
            if c.a == pair.a and c.b == pair.b and c.plane == pair.plane:
                if number < SURE_AFTER:
                    change = max(change, update(c, bodies, poses))
                    done += 1.0
                else:
                    change = max(change, update_surely(c, bodies, poses))
                    done += SURELY
        if change <= SETTLED:
            break
    for k in range(count):
        c = contacts[k]
        if c.a == pair.a and c.b == pair.b and c.plane == pair.plane:
            c.dn, c.ds, c.dt = c.dn + c.pn, c.ds + c.ps, c.dt + c.pt
    return done


@inner
def _stop_jammed(contacts, count, poses):
    """Stop bodies that still close on the room, which are jammed; return whether nothing closes then."""
    for k in range(count):
        c = contacts[k]
        if c.b == ROOM and _beyond(c, poses) < -CLOSING:
            stop(poses[c.a])
    for k in range(count):
        if _beyond(contacts[k], poses) < -CLOSING:
            return False
    return True


@inner
def _one_after_the_other(contacts, count, bodies, poses, restitution, work):
    """Let pairs meet by themselves until none closes; return whether none does.

    ``restitution`` is a factor on that of the contacts, 0 or 1; what it takes is added to ``work``.
    """
    ended = False
    for k in range(count):
        contacts[k].dn = contacts[k].ds = contacts[k].dt = 0.0  # sums of the impulses
    for _ in range(MOST_IN_A_ROW):
        first, fastest = -1, -CLOSING
        for k in range(count):
            closing = _beyond(contacts[k], poses)
            if closing < fastest:
                first, fastest = k, closing
        ended = first < 0
        if ended:
            break
        work[2] += _meet(contacts, count, contacts[first], bodies, poses, restitution)
    for k in range(count):
        c = contacts[k]
        c.pn, c.ps, c.pt = c.dn, c.ds, c.dt
    return ended or _stop_jammed(contacts, count, poses)


@inner
def mend(contacts, count, held, bodies, poses, system, h, converged, work):
    """Replace impulses that make energy, or have not converged where bodies bounce or enter each other.

    Returns
    -------
    bool
        Whether those that there are now hold at all contacts.
    """
    after, enters = _energy(bodies, poses), False
    for k in range(count):
        enters = enters or _beyond(contacts[k], poses) < -IMPACT
    apply(contacts, count, bodies, poses, -1.0)
    most = _energy(bodies, poses) * (1.0 + MADE)
    if after <= most and (converged or not (bounces(contacts, count) or enters)):
        apply(contacts, count, bodies, poses, 1.0)
        return converged
    if converged:
        least = 1.0
        for k in range(count):
            c = contacts[k]
            if c.bounce > 0.0:
                c.target, least = 0.0, min(least, c.bounce)
            c.pn = c.ps = c.pt = 0.0
        if solve(contacts, count, held, bodies, poses, system, h):
            _bounce_alike(contacts, count, bodies, poses, system[3], least)
            return True
        apply(contacts, count, bodies, poses, -1.0)
    ended = _one_after_the_other(contacts, count, bodies, poses, 1.0, work)
    if _energy(bodies, poses) > most:
        apply(contacts, count, bodies, poses, -1.0)
        ended = _one_after_the_other(contacts, count, bodies, poses, 0.0, work)
    return ended
