"""The contact problem of a step: impulses at all closed contacts at once.

With the impulses p of the contacts the velocities after a step of length h are

    v⁺ = v + h g + Σ pᵢ/m,    L⁺ = L + Σ rᵢ × pᵢ,

and each contact asks (Moreau 1988; Jean 1999) for u_n⁺ ≥ −e u_n⁻, p_n ≥ 0, one of them equal, and by
Coulomb's law for |p_t| ≤ μ p_n, with p_t against u_t⁺ where it slips. A sweep changes the impulse of each
contact as if those of the others stayed as they are (projected Jacobi), from those of the step before, or
from none after an impact. After it Newton's method solves for all contacts at once, each as the sweep left
it: open, sticking or slipping. Where that leads nowhere the augmented Lagrangian takes over. A body on more
than three points has no unique impulses; its motion is unique without friction, and taken as found with it.

A contact sticks by its static coefficient as long as it did before the step; where it slips in the solution
its kinetic one takes over and all is solved again. In an impact (as in the plane) the coefficient is that of
before: static where the contact did not slip, also of one that closes then, and kinetic where it did.
"""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.space.augmented_lagrangian import find_impulses
from stayput.mechanics.space.body import angular_response
from stayput.mechanics.space.columns import LINE
from stayput.mechanics.space.contact import (
    beyond_target,
    first_tangent,
    friction_lever_a,
    friction_lever_b,
    lever_a,
    lever_b,
    opening,
    push,
    second_tangent,
    slip,
)
from stayput.mechanics.space.newton import improve, set_rows
from stayput.mechanics.space.rolling import resist
from stayput.mechanics.space.touching import ROOM
from stayput.mechanics.space.vectors import added, cross, dot, norm, normal_of, scaled, tangents

IMPACT = 1e-3
"""Closing velocity from which on a contact bounces [m/s]."""

ACCURACY = 5e-6
"""Change of any contact's acceleration in a sweep at which the impulses are accepted [m/s²]."""

ROUNDING = 1e-8
"""The same as a velocity, as a share of the fastest with which contacts close or open."""

STICKS, STICKS_FOR = 1e-4, 1e-4
"""Acceleration from rest up to which a contact has not slipped [m/s²], and the least time for which it counts
[s]: in a shorter step, as that of an impact, rounding alone is more.
"""

ASTRAY = 3.0
"""By how much more than before a step of Newton's method a sweep may change after one that leads on."""

MOST_TRIES = 4
"""Steps of Newton's method in a row that may lead astray: contacts may have to stick or slip anew."""

MOST_STALLS = 3
"""Steps of Newton's method in a row that may bring nothing: it and sweeps lead in a circle."""

GAINS = 0.9
"""Share of the change before a sweep from which on a step of Newton's method brings nothing."""

SLIDES = 10.0
"""Speed, over the length of a step, from which on a contact slips all along it [m/s²]."""

CLOSES = 1e-2
"""Shortest time in which a gap that counts as closed does close [s]: not all at once in a short step, so that
a step and its halves do alike.
"""

ASIDE = 1e-9
"""How far what slips may rub from where it should, as a share of a contact's distance from the middle."""

TINY = 1e-12
"""What a contact without an impulse counts among others, as a velocity [m/s]."""

SLIPS_ON = 2
"""Instead of 1 for a contact that stood in the last step, and in this one slips on."""

MOST_SPREADS = 2
"""Most solutions for a lone body, each with its friction about the middle of the forces of the one before."""

MOST_SWEEPS = 24
"""Sweeps after which the augmented Lagrangian takes over."""

MOST_SLIPS = 4
"""Most solutions of a step, each with the kinetic friction of the contacts that slip in the one before."""

ROUGH = 5e-3
"""Acceleration that impulses may leave where none better are found [m/s²]."""

ROUGH_CLOSING, ROUGH_SPEED, ROUGH_LEAST = 2e-4, 1e-3, 1e-7
"""The same as shares of the fastest closing and relative velocities, and a least velocity [m/s]."""


@inline
def _inverse_masses(body, s, lever, friction_lever, n, u, v):
    """Return the velocities of a body at a contact by unit impulses: nn, nu, nv, uu, uv, vv."""
    a, b, c = cross(lever, n), cross(friction_lever, u), cross(friction_lever, v)
    ra, rb, rc = angular_response(s, a), angular_response(s, b), angular_response(s, c)
    k = body.rm * body.rm
    return k + dot(a, ra), dot(a, rb), dot(a, rc), k + dot(b, rb), dot(b, rc), k + dot(c, rc)


@inner
def prepare(c, bodies, poses, restitution):
    """Set a contact's frame, inverse masses and the velocity wanted; its normal and levers are set."""
    n = normal_of(c)
    s, t = tangents(n)
    c.sx, c.sy, c.sz = s
    c.tx, c.ty, c.tz = t
    _set_inverse_masses(c, bodies, poses)
    c.closing = opening(c, poses)
    c.bounce = restitution if c.closing < -IMPACT else 0.0
    c.target = -c.bounce * c.closing
    c.target_s = c.target_t = 0.0
    c.mu = c.mu_static if c.stuck else c.mu_kinetic


@inline
def _set_inverse_masses(c, bodies, poses):
    n, s, t = normal_of(c), first_tangent(c), second_tangent(c)
    w = _inverse_masses(bodies[c.a], poses[c.a], lever_a(c), friction_lever_a(c), n, s, t)
    c.wnn, c.wns, c.wnt, c.wss, c.wst, c.wtt = w
    if c.b != ROOM:
        w = _inverse_masses(bodies[c.b], poses[c.b], lever_b(c), friction_lever_b(c), n, s, t)
        c.wnn, c.wns, c.wnt = c.wnn + w[0], c.wns + w[1], c.wnt + w[2]
        c.wss, c.wst, c.wtt = c.wss + w[3], c.wst + w[4], c.wtt + w[5]
    half, off = 0.5 * (c.wss - c.wtt), c.wst
    c.stiff = 0.5 * (c.wss + c.wtt) + math.sqrt(half * half + off * off)


@inline
def _pressing(c, bodies):
    """Return how much a contact counts among others: by its force in the step before, or all alike."""
    return c.pn + TINY * bodies[c.a].mass


@inner
def _middle(contacts, first, count, bodies):
    """Return the middle of the forces of the contacts from ``first`` on, from both G."""
    weight, arm, other = 0.0, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
    for k in range(first, count):
        c = contacts[k]
        share = _pressing(c, bodies)
        weight += share
        arm, other = added(arm, share, lever_a(c)), added(other, share, lever_b(c))
    return scaled(1.0 / weight, arm), scaled(1.0 / weight, other)


@inline
def _kappa(c, count, bodies):
    """Return κ of as many contacts of the same two bodies."""
    if not (c.floor or c.b != ROOM):
        return 1.0
    kappa = bodies[c.b if c.b != ROOM and c.nz < 0.0 else c.a].kappa
    return min(kappa, LINE) if count == 2 and kappa < 1.0 else kappa


@inner
def spread_friction(contacts, first, count, bodies):
    """Set where the friction of the contacts from ``first`` on acts; they are of the same two bodies.

    On the floor, or of one body on another, it acts at c + κ (r − c), with c the middle of the forces and κ
    of the body that stands on the other: so it resists turning as even pressure on the base does
    (`stayput.model.even_base`). On an edge κ is 1/2, that of a line.
    """
    kappa = _kappa(contacts[first], count - first, bodies)
    arm, other = _middle(contacts, first, count, bodies)
    for k in range(first, count):
        c = contacts[k]
        c.fax, c.fay, c.faz = added(scaled(1.0 - kappa, arm), kappa, lever_a(c))
        c.fbx, c.fby, c.fbz = added(scaled(1.0 - kappa, other), kappa, lever_b(c))


@inner
def end_of(contacts, first, count):
    """Return the end of the contacts from ``first`` on that are of the same body and plane, or two bodies."""
    c, end = contacts[first], first + 1
    while end < count and (contacts[end].a, contacts[end].b, contacts[end].plane) == (c.a, c.b, c.plane):
        end += 1
    return end


@inner
def _spread_anew(contacts, count, bodies, poses):
    """Let friction act about the middle of the forces that were found, where anything slips.

    What sticks moves alike wherever it rubs, as long as all bears: where a contact of a lone body bears
    nothing the others may stick where they are alone. In groups that is left out: pulled joints then let go.

    Returns
    -------
    bool
        Whether it was anywhere, so that the impulses have to be found again.
    """
    moved, first = False, 0
    while first < count:
        c, end, slips = contacts[first], end_of(contacts, first, count), False
        for k in range(first, end):
            d = contacts[k]
            size = math.sqrt(d.ps * d.ps + d.pt * d.pt)
            slips = slips or (d.pn > 0.0 and size > d.mu * d.pn * (1.0 - 1e-9))
            slips = slips or (d.pn == 0.0 and bodies.shape[0] == 1)
        kappa = _kappa(c, end - first, bodies)
        if kappa < 1.0 and end - first > 1 and slips:
            arm, _ = _middle(contacts, first, end, bodies)
            out = added(lever_a(c), -1.0, arm)
            if norm(added(added(arm, kappa, out), -1.0, friction_lever_a(c))) > ASIDE * norm(out):
                if not moved:
                    apply(contacts, count, bodies, poses, -1.0)
                moved = True
                spread_friction(contacts, first, end, bodies)
                for k in range(first, end):
                    d = contacts[k]
                    _set_inverse_masses(d, bodies, poses)
                    # with its static one, what stood on another body would hold again while that slips
                    if d.stood == 0 or (d.b == ROOM and d.stood != SLIPS_ON):
                        d.mu = d.mu_static if d.stuck else d.mu_kinetic
        first = end
    if moved:
        apply(contacts, count, bodies, poses, 1.0)
    return moved


@inline
def rise(n, bent, h):
    """Return how far off a plane a point is in the middle of a step that free flight bends away from it."""
    return 0.125 * h * h * max(0.0, dot(n, bent))


@inner
def ask_for_bend(contacts, first, count, bodies, h):
    """Let the contacts from ``first`` on ask for what free flight bends; they are of the same two bodies.

    From the impulses of a step to those of the next the path of a point bends: so that it ends where it
    begins, it has to leave with half the bend. Along the normal each contact asks for its own, but leaves no
    faster than it came; along the tangents all ask for the same, that of the middle of their forces, as no
    rigid motion could give each its own.
    """
    weight, bent = 0.0, (0.0, 0.0, 0.0)
    gap = math.inf
    for k in range(first, count):
        c = contacts[k]
        bends = c.bx, c.by, c.bz
        gap = min(gap, c.gap - rise(normal_of(c), bends, h))
        share = _pressing(c, bodies)
        weight += share
        bent = added(bent, share, bends)
    half = scaled(-0.5 * h / weight, bent)
    closes = max(0.0, gap) / max(h, CLOSES)
    for k in range(first, count):
        c = contacts[k]
        c.target_s, c.target_t = dot(first_tangent(c), half), dot(second_tangent(c), half)
        if c.target == 0.0:
            bends = c.bx, c.by, c.bz
            c.target = min(max(0.0, -c.closing), -0.5 * h * dot(normal_of(c), bends) - closes)


@inner
def slide(contacts, count, poses, h):
    """Let friction act against the mean of the velocities before and after where contacts slip all along.

    So a step is of second order there. What might come to rest within it takes the velocity after it.
    """
    for c in contacts[:count]:
        if not c.stuck:
            s, t = slip(c, poses)
            if s * s + t * t > (SLIDES * h) ** 2:
                c.target_s, c.target_t = -s, -t


@inner
def _propose(c, poses, part):
    """Set a part of the change of a contact's impulse with the others as they are.

    Returns
    -------
    float
        The whole change of its velocity.
    """
    un, us, ut = beyond_target(c, poses)
    pn = max(0.0, c.pn - part * un / c.wnn)
    ps = pt = 0.0
    if pn > 0.0:
        us += c.wns * (pn - c.pn)
        ut += c.wnt * (pn - c.pn)
        # where it sticks nothing slips
        det = c.wss * c.wtt - c.wst * c.wst
        ps = c.ps - part * (c.wtt * us - c.wst * ut) / det
        pt = c.pt - part * (c.wss * ut - c.wst * us) / det
        if ps * ps + pt * pt > (c.mu * pn) ** 2:
            # a step against the slip, back onto the cone; the larger stiffness makes it converge
            ps, pt = c.ps - part * us / c.stiff, c.pt - part * ut / c.stiff
            size = math.sqrt(ps * ps + pt * pt)
            if size > c.mu * pn:
                ps, pt = ps * c.mu * pn / size, pt * c.mu * pn / size
    c.dn, c.ds, c.dt = pn - c.pn, ps - c.ps, pt - c.pt
    return max(abs(c.dn) * c.wnn, max(abs(c.ds), abs(c.dt)) * c.stiff) / part


@inner
def _sweep(contacts, count, bodies, poses):
    """Change the impulses of all contacts as each would alone; return the largest change of a velocity.

    All at once: one by one, of two corners that land together the first might bear all, where friction allows
    several solutions, and a box would turn in plan by what is symmetric. Those of a lone body all bear the
    same, so that each changes by its share: else Newton's method takes what does slip or open for the rest.
    """
    change, part = 0.0, 1.0 / count if bodies.shape[0] == 1 else 1.0
    for k in range(count):
        change = max(change, _propose(contacts[k], poses, part))
    for c in contacts[:count]:
        change = max(change, resist(c, bodies, poses))
    for c in contacts[:count]:
        if c.dn != 0.0 or c.ds != 0.0 or c.dt != 0.0:
            c.pn, c.ps, c.pt = c.pn + c.dn, c.ps + c.ds, c.pt + c.dt
            push(c, bodies, poses, c.dn, c.ds, c.dt)
    return change


@inner
def slip_rate(c, poses):
    """Return how fast a contact slips."""
    _, us, ut = beyond_target(c, poses)
    return math.sqrt(us * us + ut * ut)


@inline
def has_slipped(c, poses, h):
    """Return whether a contact has slipped in a step."""
    return slip_rate(c, poses) > STICKS * max(h, STICKS_FOR)


@inner
def any_closes_fast(contacts, count):
    """Return whether any contact closes so fast that it is an impact."""
    for k in range(count):
        if contacts[k].closing < -IMPACT:
            return True
    return False


@inner
def _in_impact(contacts, count, c):
    """Return whether a body of a contact is hit in this step."""
    for other in contacts[:count]:
        same = other.a == c.a or other.a == c.b or other.b == c.a or (c.b != ROOM and other.b == c.b)
        if same and other.closing < -IMPACT:
            return True
    return False


@inner
def _gives(contacts, count, c, poses, h):
    """Return whether a contact slips by its static coefficient, and is in no impact."""
    slips = c.mu > c.mu_kinetic and c.pn > 0.0 and has_slipped(c, poses, h)
    return slips and not _in_impact(contacts, count, c)


@inner
def _gives_beside(contacts, count, d, poses, h):
    """Return whether a contact of another pair gives way on one of the bodies of a contact."""
    for c in contacts[:count]:
        beside = d.a == c.a or d.a == c.b or (d.b != ROOM and (d.b == c.a or d.b == c.b))
        if beside and not c.stood and (d.a != c.a or d.b != c.b) and _gives(contacts, count, c, poses, h):
            return True
    return False


@inner
def _let_slip(contacts, count, poses, h):
    """Give contacts that slip by their static coefficient their kinetic one; return whether any did.

    In an impact a contact that did not slip before keeps its static one. Where one would slip since another
    that turned back stands, that one goes on to slip: it has not stuck yet.
    """
    slips = False
    for d in contacts[:count]:
        if d.stood and d.mu > d.mu_kinetic and _gives_beside(contacts, count, d, poses, h):
            d.mu, d.stood = d.mu_kinetic, SLIPS_ON
            slips = True
    if slips:
        return True
    for k in range(count):
        if _gives(contacts, count, contacts[k], poses, h):
            contacts[k].mu = contacts[k].mu_kinetic
            slips = True
    return slips


@inline
def apply_one(c, bodies, poses, factor):
    """Apply the impulse of a contact times a factor."""
    push(c, bodies, poses, factor * c.pn, factor * c.ps, factor * c.pt)


@inner
def apply(contacts, count, bodies, poses, factor):
    """Apply the impulses of all contacts times a factor; −1 takes them back."""
    for k in range(count):
        apply_one(contacts[k], bodies, poses, factor)


@inner
def _solve_by_augmented_lagrangian(contacts, count, held, bodies, poses, system, h, work):
    """Find the impulses of a step where sweeps have not, beginning with ``ln``, ``ls``, ``lt``.

    What resists rolling stays as the sweeps left it.
    """
    apply(contacts, count, bodies, poses, -1.0)
    closing = speed = 0.0
    for c in contacts[:count]:
        closing = max(closing, abs(c.closing))
        un, us, ut = beyond_target(c, poses)
        speed = max(speed, max(abs(un), max(abs(us), abs(ut))))
    accuracy = max(10.0 * ACCURACY * h, max(10.0 * ROUNDING * closing, ROUNDING * speed))
    enough = max(
        max(accuracy, ROUGH_LEAST), max(ROUGH * h, max(ROUGH_CLOSING * closing, ROUGH_SPEED * speed))
    )
    residual = math.inf
    for _ in range(MOST_SLIPS):
        residual = find_impulses(contacts, count, held, bodies, poses, system, accuracy, enough, h, work)
        apply(contacts, count, bodies, poses, 1.0)
        if not _let_slip(contacts, count, poses, h):
            return residual <= enough
        apply(contacts, count, bodies, poses, -1.0)
        for c in contacts[:count]:
            c.ln, c.ls, c.lt = c.pn, c.ps, c.pt
    apply(contacts, count, bodies, poses, 1.0)
    return residual <= enough


@inner
def solve(contacts, count, held, bodies, poses, system, h, work):
    """Find the impulses of a step; the velocities are with those of ``contacts``, before and after.

    Returns
    -------
    bool
        Whether they converged.
    """
    set_rows(contacts, count, held, bodies, poses, system)
    if not any_closes_fast(contacts, count):
        improve(contacts, count, held, bodies, poses, system, h)
    converged = _solve(contacts, count, held, bodies, poses, system, h, work)
    for _ in range(MOST_SPREADS if bodies.shape[0] == 1 else 1):
        if not _spread_anew(contacts, count, bodies, poses):
            break
        set_rows(contacts, count, held, bodies, poses, system)
        improve(contacts, count, held, bodies, poses, system, h)
        converged = _solve(contacts, count, held, bodies, poses, system, h, work)
    return converged


@inner
def _solve(contacts, count, held, bodies, poses, system, h, work):
    last, tries, stalls = math.inf, 0, 0
    accuracy = ACCURACY * h
    for k in range(count):
        accuracy = max(accuracy, ROUNDING * abs(contacts[k].closing))
        contacts[k].ln, contacts[k].ls, contacts[k].lt = contacts[k].pn, contacts[k].ps, contacts[k].pt
    for _ in range(MOST_SWEEPS):
        work[2] += 1.0 + count
        change = _sweep(contacts, count, bodies, poses)
        if change <= accuracy:
            if not _let_slip(contacts, count, poses, h):
                return True
            change, tries = math.inf, 0  # what comes is new
        elif tries > 0 and change <= ASTRAY * last:
            tries = 0
            stalls = stalls + 1 if change > GAINS * last else 0
        if tries == MOST_TRIES or stalls == MOST_STALLS:
            break
        if tries == 0:
            last = change
        tries += 1
        improve(contacts, count, held, bodies, poses, system, h)
    return _solve_by_augmented_lagrangian(contacts, count, held, bodies, poses, system, h, work)
