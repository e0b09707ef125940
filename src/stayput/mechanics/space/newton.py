"""Newton's method for the impulses of a step: all contacts at once, each as what it now is.

A contact that is closed asks for the normal velocity that it wants, one that sticks also for no slip, and one
that slips for p_t = μ p_n τ with τ = −u_t/|u_t|. Linearised at the impulses p of the last sweep, each law is

    p + δp = p + δp₀ − D δu,    δu = J δv,    M δv = Σ Jᵀ δp,

so that δv comes from the bodies' velocities alone, (M + Σ Jᵀ D J) δv = Σ Jᵀ δp₀: six equations a body,
whatever the number of contacts, and never singular where a body has more of them than it needs. What is asked
of a velocity is a penalty of ``FIRM`` times the inverse mass that the contact sees; a next step takes away
what it leaves. Velocities are scaled so that M is 1.

A damper asks for the same, D being half the step times its damping matrix: with the contacts alone, and its
force corrected after them, the two would take turns, and a contact might slip by a force that is not there.
"""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.space.body import in_body
from stayput.mechanics.space.contact import (
    beyond_target,
    first_tangent,
    friction_lever_a,
    friction_lever_b,
    lever_a,
    lever_b,
    push,
    second_tangent,
)
from stayput.mechanics.space.devices import (
    arm_of_pull,
    change_impulse,
    change_of_impulse,
    damps,
    lever_of_pull,
)
from stayput.mechanics.space.rolling import add_resistance, hold_rolling
from stayput.mechanics.space.touching import ROOM
from stayput.mechanics.space.vectors import added, cross, normal_of

AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
"""The room's axes, along which devices are written."""

FIRM = 1e7
"""Penalty of a velocity that a contact forbids, times the inverse mass that it sees."""


@inline
def _set_row(rows, k, side, axis, body, s, lever, along, sign):
    arm = in_body(s, cross(lever, along))
    factor = sign * body.rm
    for i in range(3):
        rows[k, side, axis, i] = factor * along[i]
    rows[k, side, axis, 3] = sign * arm[0] * body.r1
    rows[k, side, axis, 4] = sign * arm[1] * body.r2
    rows[k, side, axis, 5] = sign * arm[2] * body.r3


@inner
def _set_rows_of(rows, k, side, body, s, lever, friction_lever, axes, sign):
    """Set the velocity along three axes, of which the first has another lever, by a body's scaled one."""
    _set_row(rows, k, side, 0, body, s, lever, axes[0], sign)
    _set_row(rows, k, side, 1, body, s, friction_lever, axes[1], sign)
    _set_row(rows, k, side, 2, body, s, friction_lever, axes[2], sign)


@inline
def _begin_with(starts, a, b):
    """Let the rows of the later one of two bodies begin with the other."""
    low, high = min(a, b), max(a, b)
    starts[high] = min(starts[high], low)


@inner
def set_rows(contacts, count, held, bodies, poses, system):
    """Set the Jacobians of all contacts and dampers, and where the rows of each body in the matrix begin."""
    rows, _, _, starts, _ = system
    for b in range(bodies.shape[0]):
        starts[b] = b
    for k in range(count):
        c = contacts[k]
        axes = normal_of(c), first_tangent(c), second_tangent(c)
        _set_rows_of(rows, k, 0, bodies[c.a], poses[c.a], lever_a(c), friction_lever_a(c), axes, 1.0)
        if c.b != ROOM:
            _set_rows_of(rows, k, 1, bodies[c.b], poses[c.b], lever_b(c), friction_lever_b(c), axes, -1.0)
            _begin_with(starts, c.a, c.b)
    springs, pulls, _ = held
    for d in range(springs.shape[0]):
        spring, pull = springs[d], pulls[d]
        if damps(spring, pull):
            k, b, o, lever, arm = count + d, spring.body, spring.other, lever_of_pull(pull), arm_of_pull(pull)
            _set_rows_of(rows, k, 0, bodies[b], poses[b], lever, lever, AXES, 1.0)
            if o != ROOM:
                _set_rows_of(rows, k, 1, bodies[o], poses[o], arm, arm, AXES, -1.0)
                _begin_with(starts, b, o)


@inline
def _law(c, u):
    """Return δp₀ and D of a contact by how much the velocity u in its frame is beyond what is wanted."""
    if c.pn <= 0.0:
        zero = 0.0, 0.0, 0.0
        return zero, zero, zero, zero
    firm = FIRM / c.wnn
    change = -firm * u[0]
    most = c.mu * c.pn
    size = math.sqrt(c.ps * c.ps + c.pt * c.pt)
    if size < most * (1.0 - 1e-12):
        grip = FIRM / c.stiff
        return (change, -grip * u[1], -grip * u[2]), (firm, 0.0, 0.0), (0.0, grip, 0.0), (0.0, 0.0, grip)
    ways, wayt = 0.0, 0.0
    if size > 0.0:
        ways, wayt = c.ps / size, c.pt / size
    speed = math.sqrt(u[1] * u[1] + u[2] * u[2])
    grip = min(FIRM / c.stiff, most / speed if speed > 0.0 else math.inf)
    across = -wayt * u[1] + ways * u[2]  # the velocity across the slip
    mu = c.mu
    return (
        (change, mu * change * ways + grip * across * wayt, mu * change * wayt - grip * across * ways),
        (firm, 0.0, 0.0),
        (mu * firm * ways, grip * wayt * wayt, -grip * ways * wayt),
        (mu * firm * wayt, -grip * ways * wayt, grip * ways * ways),
    )


@inline
def _row(array, i, j, k):
    """Return a row of six: as a tuple, so that what is written meanwhile need not be read again."""
    return (
        array[i, j, k, 0],
        array[i, j, k, 1],
        array[i, j, k, 2],
        array[i, j, k, 3],
        array[i, j, k, 4],
        array[i, j, k, 5],
    )


@inline
def _plus(u, factor, v):
    """Return u + factor · v, of rows of six."""
    return (
        u[0] + factor * v[0],
        u[1] + factor * v[1],
        u[2] + factor * v[2],
        u[3] + factor * v[3],
        u[4] + factor * v[4],
        u[5] + factor * v[5],
    )


@inline
def _combined(factors, rows):
    """Return the sum of three rows times a factor each."""
    a, u = factors[0], rows[0]
    first = a * u[0], a * u[1], a * u[2], a * u[3], a * u[4], a * u[5]
    return _plus(_plus(first, factors[1], rows[1]), factors[2], rows[2])


@inline
def _put(array, i, j, k, u):
    """Set a row of six."""
    array[i, j, k, 0] = u[0]
    array[i, j, k, 1] = u[1]
    array[i, j, k, 2] = u[2]
    array[i, j, k, 3] = u[3]
    array[i, j, k, 4] = u[4]
    array[i, j, k, 5] = u[5]


@inline
def _weigh(rows, k, side, d):
    """Set D times the Jacobian of a side of a contact, and return it."""
    J = _row(rows, k, side, 0), _row(rows, k, side, 1), _row(rows, k, side, 2)
    x, y, z = _combined(d[0], J), _combined(d[1], J), _combined(d[2], J)
    _put(rows, k, side, 3, x)
    _put(rows, k, side, 4, y)
    _put(rows, k, side, 5, z)
    return x, y, z


@inline
def _add_block(matrix, first, second, rows, k, left, right):
    """Add leftᵀ D right, of the sides of a contact, to the block of two bodies, with D right given."""
    for i in range(6):
        along = rows[k, left, 0, i], rows[k, left, 1, i], rows[k, left, 2, i]
        _put(matrix, first, second, i, _plus(_row(matrix, first, second, i), 1.0, _combined(along, right)))


@inner
def _add_moment(vector, body, rows, k, side, p):
    for i in range(6):
        vector[body, i] += (
            rows[k, side, 0, i] * p[0] + rows[k, side, 1, i] * p[1] + rows[k, side, 2, i] * p[2]
        )


@inner
def _factorize(matrix, b):
    """Factorize the block of a body into L, whose diagonal is 1, and R, with one over its diagonal."""
    for k in range(6):
        inverse = 1.0 / matrix[b, b, k, k]
        matrix[b, b, k, k] = inverse
        for i in range(k + 1, 6):
            factor = matrix[b, b, i, k] * inverse
            matrix[b, b, i, k] = factor
            for j in range(k + 1, 6):
                matrix[b, b, i, j] -= factor * matrix[b, b, k, j]


@inline
def _is_zero(matrix, a, b):
    """Return whether all of a block is 0, as that of bodies that nothing joins."""
    for i in range(6):
        for j in range(6):
            if matrix[a, b, i, j] != 0.0:
                return False
    return True


@inner
def _eliminate(matrix, vector, starts, b):
    """Take a body's rows from those of the bodies after it whose rows begin with it or before."""
    for o in range(b + 1, starts.shape[0]):
        if starts[o] <= b and not _is_zero(matrix, o, b):
            for i in range(1, 6):
                row = _row(matrix, b, o, i)
                for k in range(i):
                    row = _plus(row, -matrix[b, b, i, k], _row(matrix, b, o, k))
                _put(matrix, b, o, i, row)
            for k in range(6):
                for i in range(6):
                    factor = matrix[o, b, i, k] * matrix[b, b, k, k]
                    matrix[o, b, i, k] = factor
                    vector[o, i] -= factor * vector[b, k]
                    for j in range(k + 1, 6):
                        matrix[o, b, i, j] -= factor * matrix[b, b, k, j]
    for o in range(b + 1, starts.shape[0]):
        if starts[o] <= b and not _is_zero(matrix, o, b):
            for p in range(b + 1, starts.shape[0]):
                if starts[p] <= b and not _is_zero(matrix, b, p):
                    for i in range(6):
                        row = _row(matrix, o, p, i)
                        for k in range(6):
                            row = _plus(row, -matrix[o, b, i, k], _row(matrix, b, p, k))
                        _put(matrix, o, p, i, row)


@inner
def solve_in_place(matrix, vector, starts):
    """Solve matrix · x = vector, whose rows and columns begin with those of the bodies in ``starts``.

    Elimination of a body after the other without exchange of rows: where contacts slip the matrix is not
    symmetric, but what is added to 1 is nearly positive.
    """
    for b in range(starts.shape[0]):
        _factorize(matrix, b)
        for k in range(6):
            for i in range(k + 1, 6):
                vector[b, i] -= matrix[b, b, i, k] * vector[b, k]
        _eliminate(matrix, vector, starts, b)
    for b in range(starts.shape[0] - 1, -1, -1):
        for back in range(6):
            k = 5 - back
            vector[b, k] *= matrix[b, b, k, k]
            for i in range(k):
                vector[b, i] -= matrix[b, b, i, k] * vector[b, k]
        for o in range(starts[b], b):
            for i in range(6):
                for k in range(6):
                    vector[o, i] -= matrix[o, b, i, k] * vector[b, k]


@inner
def add_pair(matrix, vector, a, b, rows, k, p, d):
    """Add what a contact or a device of two bodies asks for, by its δp₀ and D."""
    mine = _weigh(rows, k, 0, d)
    _add_moment(vector, a, rows, k, 0, p)
    _add_block(matrix, a, a, rows, k, 0, mine)
    if b != ROOM:
        others = _weigh(rows, k, 1, d)
        _add_moment(vector, b, rows, k, 1, p)
        _add_block(matrix, b, b, rows, k, 1, others)
        _add_block(matrix, a, b, rows, k, 0, others)
        _add_block(matrix, b, a, rows, k, 1, mine)


@inline
def damping_of(pull):
    """Return D of a device in the room's axes."""
    n, more = normal_of(pull), pull.cn - pull.ct
    return (
        (pull.ct + more * n[0] * n[0], more * n[0] * n[1], more * n[0] * n[2]),
        (more * n[1] * n[0], pull.ct + more * n[1] * n[1], more * n[1] * n[2]),
        (more * n[2] * n[0], more * n[2] * n[1], pull.ct + more * n[2] * n[2]),
    )


@inner
def clear_system(matrix, vector, starts):
    """Set the matrix to 1, the scaled masses, and the vector to 0."""
    for b in range(starts.shape[0]):
        for o in range(starts[b], b + 1):
            for i in range(6):
                for j in range(6):
                    matrix[b, o, i, j] = matrix[o, b, i, j] = 0.0
        for i in range(6):
            matrix[b, b, i, i] = 1.0
            vector[b, i] = 0.0


@inner
def improve(contacts, count, held, bodies, poses, system, h):
    """Take one step of Newton's method; velocities go with the impulses. `set_rows` has been called."""
    rows, matrix, vector, starts, _ = system
    clear_system(matrix, vector, starts)
    for k in range(count):
        c = contacts[k]
        if c.pn > 0.0:
            p, d1, d2, d3 = _law(c, beyond_target(c, poses))
            c.dn, c.ds, c.dt = p
            add_pair(matrix, vector, c.a, c.b, rows, k, p, (d1, d2, d3))
            hold_rolling(c, bodies, poses, matrix, vector, FIRM)
    springs, pulls, _ = held
    for d in range(springs.shape[0]):
        spring, pull = springs[d], pulls[d]
        if damps(spring, pull):
            p = change_of_impulse(spring, pull, poses, h)
            pull.dx, pull.dy, pull.dz = p
            add_pair(matrix, vector, spring.body, spring.other, rows, count + d, p, damping_of(pull))
    solve_in_place(matrix, vector, starts)
    for k in range(count):
        c = contacts[k]
        if c.pn > 0.0:
            x, y, z = by_rows(rows, k, 3, c.a, c.b, vector)
            c.dn, c.ds, c.dt = c.dn - x, c.ds - y, c.dt - z
            _add_impulse(c, bodies, poses)
            add_resistance(c, bodies, poses, vector)
    for d in range(springs.shape[0]):
        spring, pull = springs[d], pulls[d]
        if damps(spring, pull):
            by = by_rows(rows, count + d, 3, spring.body, spring.other, vector)
            change_impulse(spring, pull, bodies, poses, added((pull.dx, pull.dy, pull.dz), -1.0, by))


@inline
def by_rows(rows, k, first, a, b, v):
    """Return three rows of a contact or a device times scaled velocities of its bodies.

    From row 0 on that is the relative velocity there, and from row 3 on D times it.
    """
    x = y = z = 0.0
    for side in range(1 if b == ROOM else 2):
        body = b if side else a
        for i in range(6):
            w = v[body, i]
            x += rows[k, side, first, i] * w
            y += rows[k, side, first + 1, i] * w
            z += rows[k, side, first + 2, i] * w
    return x, y, z


@inline
def _add_impulse(c, bodies, poses):
    """Change a contact's impulse by what was found, as far as its cone lets it."""
    pn = max(0.0, c.pn + c.dn)
    ps, pt = c.ps + c.ds, c.pt + c.dt
    size, most = math.sqrt(ps * ps + pt * pt), c.mu * pn
    if size > most:
        ps, pt = ps * most / size, pt * most / size
    push(c, bodies, poses, pn - c.pn, ps - c.ps, pt - c.pt)
    c.pn, c.ps, c.pt = pn, ps, pt
