"""Impulses of all contacts at once, where sweeps and Newton's steps do not converge: an augmented Lagrangian.

With the shift s = μ |u_t| of the normal velocity (de Saxcé and Feng 1998) Coulomb's law says that the impulse
p lies in the cone of friction |p_t| ≤ μ p_n, u + s n lies in its dual cone, and p·(u + s n) = 0. With s held
these are the conditions of a convex problem: least ½|v − v₀|² with u + s n in the dual cone, whose
multipliers are p. v₀ are the velocities without impulses of contacts, scaled so that the mass matrix is 1.
With multipliers λ and penalties ρ of the contacts

    φ(v) = ½|v − v₀|² + ½ Σ |Π(λ − ρ(u + s n))|² / ρ,        Π the projection onto the cone,

is convex with a continuous gradient. Newton's method with a line search finds its minimum from anywhere. Then
λ ← Π(λ − ρ(u + s n)), s ← μ |u_t| and ρ grows, until λ fits the velocities it gives. Any s ≥ 0 gives
p·u = −s p_n ≤ 0, so that even impulses that have not converged make no energy where nothing bounces. All
contacts change together: their order does not matter. Dampers take part with D, half the damping of a step.
"""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.space.contact import beyond_target
from stayput.mechanics.space.devices import change_impulse, change_of_impulse, damps
from stayput.mechanics.space.newton import add_pair, by_rows, clear_system, damping_of, solve_in_place
from stayput.mechanics.space.touching import ROOM
from stayput.mechanics.space.vectors import added, dot

FIRST_PENALTY, LARGEST_PENALTY, PENALTY_GROWTH = 1e3, 1e4, 1e1
"""Penalties, times the inverse mass that a contact sees: from about 1e6 on rounding enters the velocities."""

MOST_ROUNDS = 64
"""Most updates of multipliers and shifts."""

MOST_NEWTON_STEPS = 60
"""Most steps of Newton's method between two updates."""

MOST_EVALUATIONS = 14
"""Most evaluations of the slope in a line search."""

SLOPE = 0.1
"""Share of the first slope along a direction at which the line search ends."""

LEAST_RELAXATION, MOST_RELAXATION = 0.3, 4.0
"""Bounds of Aitken's factor on the change of the shifts, which may oscillate or creep."""

MOST_STALLED = 3
"""Updates in a row without progress, after which impulses that are good enough are taken."""

STEP_WORK = 5.0
"""Work of a step of Newton's method for each contact, in updates of a contact by a sweep."""


@inline
def _projection(c, zn, zs, zt):
    """Return the projection of z onto a contact's cone, and its derivative: nn, ns, nt, ss, st, tt."""
    mu, size = c.mu, math.sqrt(zs * zs + zt * zt)
    if mu > 0.0 and zn > 0.0 and size <= mu * zn:
        return zn, zs, zt, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0
    if mu * size <= -zn:
        return 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    nn = 1.0 / (1.0 + mu * mu)
    pn = (zn + mu * size) * nn
    if size == 0.0:
        return pn, 0.0, 0.0, nn, 0.0, 0.0, 0.0, 0.0, 0.0
    s, t = zs / size, zt / size
    along, across = mu * mu * nn, mu * pn / size
    ss, tt = along * s * s + across * t * t, along * t * t + across * s * s
    return pn, mu * pn * s, mu * pn * t, nn, mu * nn * s, mu * nn * t, ss, (along - across) * s * t, tt


@inline
def _impulse_at(c, part):
    """Return a contact's impulse, and its derivative, at a part of the way along the direction."""
    return _projection(
        c,
        c.ln - c.rho * (c.un + c.shift + part * c.en),
        c.ls - c.rho * (c.us + part * c.es),
        c.lt - c.rho * (c.ut + part * c.et),
    )


@inner
def _set_up_step(contacts, count, held, system):
    """Set the Hessian of φ and minus its gradient at the present velocities."""
    rows, matrix, vector, starts, gained = system
    clear_system(matrix, vector, starts)
    for b in range(starts.shape[0]):
        for i in range(6):
            vector[b, i] = -gained[b, i]
    for k in range(count):
        c = contacts[k]
        c.en = c.es = c.et = 0.0
        pn, ps, pt, nn, ns, nt, ss, st, tt = _impulse_at(c, 0.0)
        c.dn, c.ds, c.dt = pn, ps, pt
        if nn > 0.0:
            r = c.rho
            D = (r * nn, r * ns, r * nt), (r * ns, r * ss, r * st), (r * nt, r * st, r * tt)
            add_pair(matrix, vector, c.a, c.b, rows, k, (pn, ps, pt), D)
    springs, pulls, _ = held
    for d in range(springs.shape[0]):
        spring, pull = springs[d], pulls[d]
        if damps(spring, pull):
            p = _left_of(spring, pull, rows, count + d, gained)
            add_pair(matrix, vector, spring.body, spring.other, rows, count + d, p, damping_of(pull))


@inline
def _damped(D, u):
    return dot(D[0], u), dot(D[1], u), dot(D[2], u)


@inline
def _left_of(spring, pull, rows, k, gained):
    """Return the change of a damper's impulse at the velocities gained, which answer it."""
    answer = _damped(damping_of(pull), by_rows(rows, k, 0, spring.body, spring.other, gained))
    return added((pull.dx, pull.dy, pull.dz), -1.0, answer)


@inner
def _slope(contacts, count, part, slope, curvature):
    """Return the slope of φ at a part of the way along the direction, and its curvature there.

    Those without contacts are given: slope at the beginning, curvature all along.
    """
    slope, total = slope + part * curvature, curvature
    for c in contacts[:count]:
        pn, ps, pt, nn, ns, nt, ss, st, tt = _impulse_at(c, part)
        x, y, z = c.en, c.es, c.et
        slope -= pn * x + ps * y + pt * z
        total += c.rho * (nn * x * x + ss * y * y + tt * z * z + 2.0 * (ns * x * y + nt * x * z + st * y * z))
    return slope, total


@inner
def _line_search(contacts, count, slope, curvature):
    """Return about where along the direction φ is least: the whole way, or a root of its slope."""
    first = slope
    for c in contacts[:count]:
        first -= c.dn * c.en + c.ds * c.es + c.dt * c.et
    there, growth = _slope(contacts, count, 1.0, slope, curvature)
    enough = SLOPE * abs(first)
    if there <= enough:
        return 1.0
    low, high, part = 0.0, 1.0, 1.0
    for _ in range(MOST_EVALUATIONS):
        part -= there / growth
        if not low < part < high:
            part = 0.5 * (low + high)
        there, growth = _slope(contacts, count, part, slope, curvature)
        if abs(there) <= enough:
            break
        low, high = (low, part) if there > 0.0 else (part, high)
    return part


@inner
def _minimize(contacts, count, held, system, within, work):
    """Bring the velocities to the minimum of φ, within an error of the velocity at any contact [m/s]."""
    rows, matrix, vector, starts, gained = system
    springs, pulls, _ = held
    for number in range(MOST_NEWTON_STEPS + 1):
        _set_up_step(contacts, count, held, system)
        error = 0.0
        for k in range(count):
            c = contacts[k]
            c.gn, c.gs, c.gt = by_rows(rows, k, 0, c.a, c.b, vector)
            error = max(error, max(abs(c.gn), max(abs(c.gs), abs(c.gt))))
        if error <= within or number == MOST_NEWTON_STEPS:
            return
        solve_in_place(matrix, vector, starts)
        work[2] += STEP_WORK * (1.0 + count)
        slope = curvature = 0.0
        for b in range(starts.shape[0]):
            for i in range(6):
                slope += gained[b, i] * vector[b, i]
                curvature += vector[b, i] * vector[b, i]
        for d in range(springs.shape[0]):
            spring, pull = springs[d], pulls[d]
            if damps(spring, pull):
                e = by_rows(rows, count + d, 0, spring.body, spring.other, vector)
                slope -= dot(_left_of(spring, pull, rows, count + d, gained), e)
                curvature += dot(_damped(damping_of(pull), e), e)
        for k in range(count):
            c = contacts[k]
            c.en, c.es, c.et = by_rows(rows, k, 0, c.a, c.b, vector)
        part = _line_search(contacts, count, slope, curvature)
        for b in range(starts.shape[0]):
            for i in range(6):
                gained[b, i] += part * vector[b, i]
        for c in contacts[:count]:
            c.un, c.us, c.ut = c.un + part * c.en, c.us + part * c.es, c.ut + part * c.et


@inline
def _residual(c):
    """Return by how much the law changes a contact's impulse at the velocities it gives [m/s]."""
    un, us, ut = c.un + c.gn, c.us + c.gs, c.ut + c.gt
    pn = max(0.0, c.ln - un / c.wnn)
    ps, pt = c.ls - us / c.stiff, c.lt - ut / c.stiff
    size, most = math.sqrt(ps * ps + pt * pt), c.mu * pn
    if size > most:
        ps, pt = ps * most / size, pt * most / size
    return max(abs(pn - c.ln) * c.wnn, max(abs(ps - c.ls), abs(pt - c.lt)) * c.stiff)


@inner
def find_impulses(contacts, count, held, bodies, poses, system, accuracy, enough, h, work):
    """Find the impulses of all contacts and dampers; the velocities are without those of contacts.

    The search begins with the impulses ``ln``, ``ls``, ``lt``. `set_rows` has been called. Impulses of
    dampers are changed and applied; of the contacts ``pn``, ``ps``, ``pt`` are set, but not applied.

    Returns
    -------
    float
        The residual [m/s]: at most ``accuracy``, or the least that was found.
    """
    rows, gained = system[0], system[4]
    springs, pulls, _ = held
    for d in range(springs.shape[0]):
        spring, pull = springs[d], pulls[d]
        if damps(spring, pull):
            pull.dx, pull.dy, pull.dz = change_of_impulse(spring, pull, poses, h)
    for b in range(gained.shape[0]):
        for i in range(6):
            gained[b, i] = 0.0
    for k in range(count):
        c = contacts[k]
        for i in range(6):
            gained[c.a, i] += rows[k, 0, 0, i] * c.ln + rows[k, 0, 1, i] * c.ls + rows[k, 0, 2, i] * c.lt
            if c.b != ROOM:
                gained[c.b, i] += rows[k, 1, 0, i] * c.ln + rows[k, 1, 1, i] * c.ls + rows[k, 1, 2, i] * c.lt
    for k in range(count):
        c = contacts[k]
        un, us, ut = beyond_target(c, poses)
        x, y, z = by_rows(rows, k, 0, c.a, c.b, gained)
        c.un, c.us, c.ut = un + x, us + y, ut + z
        c.shift = c.mu * math.sqrt(c.us * c.us + c.ut * c.ut) if c.ln > 0.0 else 0.0
        c.change = 0.0
    least, residual, penalty, stalled, relaxation = math.inf, math.inf, FIRST_PENALTY, 0, 1.0
    for number in range(MOST_ROUNDS):
        for k in range(count):
            contacts[k].rho = penalty / (contacts[k].wnn + contacts[k].stiff)
        _minimize(contacts, count, held, system, max(0.1 * accuracy, min(0.01 * residual, 1e-5)), work)
        residual = product = square = 0.0
        for c in contacts[:count]:
            c.ln, c.ls, c.lt = c.dn, c.ds, c.dt
            residual = max(residual, _residual(c))
            change = c.mu * math.sqrt(c.us * c.us + c.ut * c.ut) - c.shift
            product += c.change * (change - c.change)
            square += (change - c.change) ** 2
            c.change = change
        stalled = stalled + 1 if residual > 0.5 * least else 0
        if residual < least:
            least = residual
            for c in contacts[:count]:
                c.pn, c.ps, c.pt = c.ln, c.ls, c.lt
        if residual <= accuracy or (stalled >= MOST_STALLED and least <= enough):
            break
        if number > 1 and square > 0.0:
            relaxation = min(MOST_RELAXATION, max(LEAST_RELAXATION, -relaxation * product / square))
        for c in contacts[:count]:
            c.shift = max(0.0, c.shift + relaxation * c.change)
        penalty = min(LARGEST_PENALTY, PENALTY_GROWTH * penalty)
    for d in range(springs.shape[0]):
        spring, pull = springs[d], pulls[d]
        if damps(spring, pull):
            change_impulse(spring, pull, bodies, poses, _left_of(spring, pull, rows, count + d, gained))
    return least
