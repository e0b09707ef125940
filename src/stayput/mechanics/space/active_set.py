"""Accelerations of a lone body on contacts that are known to press, and to stick or to slip.

With velocities ν scaled so that the mass matrix is 1, rows G of what contacts forbid, columns F of their
forces λ and the velocities ν₀' without them

    ν' = ν₀' + Σ F λ,        G ν' + b = 0,

where b is what the contact's point is accelerated by the rotation. Of a contact that sticks the rows are
those along its normal and tangents, and F = Gᵀ; of one that slips the row is that along the normal, and F has
friction against the slip too. Where there are more contacts than the body needs G F is singular; a small part
of its diagonal is added, so that they share alike, and the solution refined, so that this is not felt.

On the floor friction acts about the centre of pressure (`stayput.mechanics.space.solve.spread_friction`),
which follows from the forces. Rounds "forces, centre of pressure, forces" may diverge where an edge turns
about itself; with the secant of the last two (Aitken's relaxation) they do not.
"""

from __future__ import annotations

import math

from stayput.compiling import inline, inner
from stayput.mechanics.space.body import angular_response, in_body, in_room, nudge, place_of, rotation
from stayput.mechanics.space.columns import LINE
from stayput.mechanics.space.constants import (
    EXTRAPOLATED,
    LEAST_RELAXATION,
    MOST_INDEPENDENT,
    MOST_RELAXATION,
    NEAR_PRESSURE,
    ON_MIXED_EDGE,
    PRESSURE_ROUNDS,
    PRESSURE_TOLERANCE,
    REFINEMENTS,
    SHARING,
    SLIP_BEGIN_SPEED,
    SLIP_END_SPEED,
)
from stayput.mechanics.space.contact import velocity_at
from stayput.mechanics.space.touching import gap_of, lever_of_point
from stayput.mechanics.space.vectors import added, cross, dot, normal_of, scaled, tangents

FREE, TOTAL, FORCES, REST, BENDS, RATES, LAST_TOTAL, LAST_FORCES = range(8)
"""Vectors: the change of the scaled velocities without contacts, and with them; forces, what they miss, and
what contacts are accelerated by the rotation; changes of velocity and angular momentum; the second and third
as they were in the round before.
"""


@inline
def _lever(c):
    return c.rx, c.ry, c.rz


@inline
def _friction_lever(c):
    return c.fx, c.fy, c.fz


@inline
def _centre_of_pressure(flow, pressing):
    """Return the middle of the forces on the floor, and whether there are any contacts."""
    weight = x = y = 0.0
    for c in pressing[: flow.count]:
        if c.floor:
            share = max(c.pn, 0.0) + 1e-300
            weight, x, y = weight + share, x + share * c.rx, y + share * c.ry
    return (x / weight, y / weight, True) if weight > 0.0 else (0.0, 0.0, False)


@inner
def set_levers(flow, pressing, points, s):
    """Set the levers of the contacts, and the centre of pressure that the last forces had."""
    for c in pressing[: flow.count]:
        c.rx, c.ry, c.rz = lever_of_point(s, points[c.point])
    x, y, on_floor = _centre_of_pressure(flow, pressing)
    if on_floor:
        flow.cx, flow.cy = x, y


@inline
def _is_spread(flow, pressing):
    """Return whether the friction of any contact depends on the centre of pressure."""
    for c in pressing[: flow.count]:
        if c.floor and c.kappa < 1.0:
            return True
    return False


@inner
def set_friction_levers(flow, pressing, planes, s):
    """Set where friction acts, and how fast contacts slip there."""
    for c in pressing[: flow.count]:
        c.fx, c.fy, c.fz = c.rx, c.ry, c.rz
        if c.kappa < 1.0:
            c.fx, c.fy = flow.cx + c.kappa * (c.rx - flow.cx), flow.cy + c.kappa * (c.ry - flow.cy)
        first, second = tangents(normal_of(planes[c.plane]))
        u = velocity_at(s, _friction_lever(c))
        c.us, c.ut = dot(first, u), dot(second, u)


@inline
def note_slips(flow, pressing):
    """Note how contacts slip as a step begins."""
    for c in pressing[: flow.count]:
        c.ds, c.dt = c.us, c.ut


@inline
def _slip_direction(c):
    """Return the direction of the slip, or that at the step's beginning where it has turned back."""
    s, t = c.us, c.ut
    if s * c.ds + t * c.dt <= 0.0:
        s, t = c.ds, c.dt
    size = math.sqrt(s * s + t * t)
    return (s / size, t / size) if size > 0.0 else (0.0, 0.0)


@inline
def _set_row(row, body, s, lever, along):
    arm = in_body(s, cross(lever, along))
    row[0], row[1], row[2] = body.rm * along[0], body.rm * along[1], body.rm * along[2]
    row[3], row[4], row[5] = body.r1 * arm[0], body.r2 * arm[1], body.r3 * arm[2]


@inner
def _set_rows(flow, pressing, planes, body, s, system):
    """Set rows and columns of all contacts and what they are accelerated; return how many rows there are."""
    rows, columns, _, vectors, _ = system
    spin, number = rotation(s), 0
    for c in pressing[: flow.count]:
        n = normal_of(planes[c.plane])
        first, second = tangents(n)
        c.first = number
        _set_row(rows[number], body, s, _lever(c), n)
        vectors[BENDS, number] = dot(n, cross(spin, cross(spin, _lever(c))))
        _set_row(rows[number + 1], body, s, _friction_lever(c), first)
        _set_row(rows[number + 2], body, s, _friction_lever(c), second)
        if c.sticks:
            moves = cross(spin, cross(spin, _friction_lever(c)))
            vectors[BENDS, number + 1], vectors[BENDS, number + 2] = dot(first, moves), dot(second, moves)
            for i in range(6):
                for axis in range(3):
                    columns[number + axis, i] = rows[number + axis, i]
            number += 3
        else:
            along, across = _slip_direction(c)
            for i in range(6):
                columns[number, i] = rows[number, i] - c.mu_kinetic * (
                    along * rows[number + 1, i] + across * rows[number + 2, i]
                )
            number += 1
    return number


@inline
def _product(row, other):
    return (
        row[0] * other[0]
        + row[1] * other[1]
        + row[2] * other[2]
        + row[3] * other[3]
        + row[4] * other[4]
        + row[5] * other[5]
    )


@inner
def _factorize(matrix, pivots, number):
    """Replace a matrix by its factors L and U, with rows exchanged."""
    for k in range(number):
        largest = k
        for i in range(k + 1, number):
            if abs(matrix[i, k]) > abs(matrix[largest, k]):
                largest = i
        pivots[k] = largest
        if largest != k:
            for j in range(number):
                matrix[k, j], matrix[largest, j] = matrix[largest, j], matrix[k, j]
        over = 1.0 / matrix[k, k]
        for i in range(k + 1, number):
            factor = over * matrix[i, k]
            matrix[i, k] = factor
            for j in range(k + 1, number):
                matrix[i, j] -= factor * matrix[k, j]


@inner
def _solve(matrix, pivots, number, b):
    """Solve equations whose factors are known, in place."""
    for k in range(number):
        other = pivots[k]
        b[k], b[other] = b[other], b[k]
    for i in range(number):
        for j in range(i):
            b[i] -= matrix[i, j] * b[j]
    for i in range(number - 1, -1, -1):
        for j in range(i + 1, number):
            b[i] -= matrix[i, j] * b[j]
        b[i] /= matrix[i, i]


@inline
def _solve_few(matrix, number, b):
    """Solve up to three equations in place, by Cramer's rule."""
    if number == 1:
        b[0] /= matrix[0, 0]
    elif number == 2:
        over = 1.0 / (matrix[0, 0] * matrix[1, 1] - matrix[0, 1] * matrix[1, 0])
        b[0], b[1] = (
            over * (matrix[1, 1] * b[0] - matrix[0, 1] * b[1]),
            over * (matrix[0, 0] * b[1] - matrix[1, 0] * b[0]),
        )
    else:
        x = matrix[0, 0], matrix[1, 0], matrix[2, 0]
        y = matrix[0, 1], matrix[1, 1], matrix[2, 1]
        z = matrix[0, 2], matrix[1, 2], matrix[2, 2]
        yz, right = cross(y, z), (b[0], b[1], b[2])
        over = 1.0 / dot(x, yz)
        b[0], b[1], b[2] = (
            over * dot(right, yz),
            over * dot(right, cross(z, x)),
            over * dot(right, cross(x, y)),
        )


@inline
def _are_independent(flow, pressing, number):
    """Return whether so many rows of the contacts are taken to be independent."""
    mixed_edge = number == ON_MIXED_EDGE and flow.count == 2 and pressing[0].floor and pressing[1].floor
    return number <= MOST_INDEPENDENT or mixed_edge


@inner
def _find_forces(system, number, independent):
    """Find the forces of so many rows; the velocities' change is with them then."""
    rows, columns, matrix, vectors, pivots = system
    forces, rest, total = vectors[FORCES], vectors[REST], vectors[TOTAL]
    few = number <= MOST_INDEPENDENT
    for i in range(number):
        for j in range(number):
            matrix[i, j] = _product(rows[i], columns[j])
        if not independent:
            matrix[i, i] += SHARING * _product(rows[i], rows[i])
        forces[i] = 0.0
    if not few:
        _factorize(matrix, pivots, number)
    for _ in range(1 if independent else REFINEMENTS):
        for i in range(number):
            rest[i] = -_product(rows[i], total) - vectors[BENDS, i]
        if few:
            _solve_few(matrix, number, rest)
        else:
            _solve(matrix, pivots, number, rest)
        for i in range(number):
            forces[i] += rest[i]
            for j in range(6):
                total[j] += rest[i] * columns[i, j]


@inline
def _take_forces(flow, pressing, forces):
    """Set the forces of all contacts to those found."""
    for c in pressing[: flow.count]:
        c.pn = forces[c.first]
        if c.sticks:
            c.ps, c.pt = forces[c.first + 1], forces[c.first + 2]
        else:
            along, across = _slip_direction(c)
            c.ps, c.pt = -c.mu_kinetic * c.pn * along, -c.mu_kinetic * c.pn * across


@inline
def _extrapolate(vectors, rows, part):
    """Go on from the last two rounds by a part of the way from one to the other."""
    for i in range(6):
        vectors[TOTAL, i] += part * (vectors[TOTAL, i] - vectors[LAST_TOTAL, i])
    for i in range(rows):
        vectors[FORCES, i] += part * (vectors[FORCES, i] - vectors[LAST_FORCES, i])


@inner
def accelerate(flow, pressing, body, points, planes, s, push, system):
    """Set how velocity and angular momentum change, and the forces of all contacts.

    Parameters
    ----------
    push : tuple
        The acceleration that acts on the body; force and moment of its devices stand in ``flow``.
    system : tuple
        Rows and columns float64[n, 6], matrix float64[n, n], vectors float64[8, n] and pivots int64[n];
        row ``RATES`` of the vectors has the changes.
    """
    vectors = system[3]
    free, total, rates = vectors[FREE], vectors[TOTAL], vectors[RATES]
    spin = rotation(s)
    gyro = cross(spin, (s.lx, s.ly, s.lz))
    turning = in_body(s, added((flow.mx, flow.my, flow.mz), -1.0, gyro))
    free[0] = push[0] / body.rm + body.rm * flow.fx
    free[1] = push[1] / body.rm + body.rm * flow.fy
    free[2] = push[2] / body.rm + body.rm * flow.fz
    free[3], free[4], free[5] = body.r1 * turning[0], body.r2 * turning[1], body.r3 * turning[2]
    set_levers(flow, pressing, points, s)
    spread = _is_spread(flow, pressing)
    last_x = last_y = 0.0
    for number in range(PRESSURE_ROUNDS):
        for i in range(6):
            total[i] = free[i]
        if flow.count == 0:
            break
        set_friction_levers(flow, pressing, planes, s)
        rows = _set_rows(flow, pressing, planes, body, s, system)
        _find_forces(system, rows, _are_independent(flow, pressing, rows))
        _take_forces(flow, pressing, vectors[FORCES])
        if not spread:
            break
        x, y, _ = _centre_of_pressure(flow, pressing)
        x, y = x - flow.cx, y - flow.cy
        if abs(x) + abs(y) <= PRESSURE_TOLERANCE:
            break
        if number > 0:
            dx, dy = x - last_x, y - last_y
            square = dx * dx + dy * dy
            secant = -flow.relaxation * (last_x * dx + last_y * dy) / square if square > 0.0 else 1.0
            flow.relaxation = min(MOST_RELAXATION, max(LEAST_RELAXATION, secant))
            part = -(x * dx + y * dy) / square if square > 0.0 else math.inf
            misses = abs(x + part * dx) + abs(y + part * dy)
            near = abs(x) + abs(y) <= NEAR_PRESSURE and abs(part) <= EXTRAPOLATED
            if near and misses <= PRESSURE_TOLERANCE:
                _extrapolate(vectors, rows, part)
                _take_forces(flow, pressing, vectors[FORCES])
                break
        for i in range(6):
            vectors[LAST_TOTAL, i] = total[i]
        for i in range(rows):
            vectors[LAST_FORCES, i] = vectors[FORCES, i]
        flow.cx, flow.cy = flow.cx + flow.relaxation * x, flow.cy + flow.relaxation * y
        last_x, last_y = x, y
    rates[0], rates[1], rates[2] = body.rm * total[0], body.rm * total[1], body.rm * total[2]
    turning = total[3] / body.r1, total[4] / body.r2, total[5] / body.r3
    rates[3], rates[4], rates[5] = added(in_room(s, turning), 1.0, gyro)


@inner
def margin_of(flow, pressing, weight):
    """Return the least margin of the contacts: what is left until one lifts, gives way or is about to stand.

    Forces are over the weight, slips over the speed at which a flow begins.
    """
    left = math.inf
    for c in pressing[: flow.count]:
        left = min(left, c.pn / weight)
        if c.sticks:
            left = min(left, (c.mu_static * c.pn - math.sqrt(c.ps * c.ps + c.pt * c.pt)) / weight)
        else:
            size = math.sqrt(c.ds * c.ds + c.dt * c.dt)
            along = (c.us * c.ds + c.ut * c.dt) / size if size > 0.0 else 0.0
            left = min(left, (along - SLIP_END_SPEED) / SLIP_BEGIN_SPEED)
    return left


@inner
def note_pressing_force(flow, pressing, planes):
    """Note what the room presses on the body."""
    force = 0.0, 0.0, 0.0
    for c in pressing[: flow.count]:
        n = normal_of(planes[c.plane])
        first, second = tangents(n)
        force = added(force, 1.0, added(added(scaled(c.pn, n), c.ps, first), c.pt, second))
    flow.px, flow.py, flow.pz = force


@inner
def project(flow, pressing, body, points, planes, s, system):
    """Put contacts that press back onto their planes, and take away the velocities that they forbid.

    What sticks is put back where it stuck at first too, if all does: else the centre of friction moves.
    """
    if flow.count == 0:
        return
    rows, columns, _, vectors, _ = system
    total = vectors[TOTAL]
    for velocities in range(2):
        set_levers(flow, pressing, points, s)
        set_friction_levers(flow, pressing, planes, s)
        for i in range(6):
            total[i] = 0.0
        if velocities:
            turn = in_body(s, (s.lx, s.ly, s.lz))
            total[0], total[1], total[2] = s.vx / body.rm, s.vy / body.rm, s.vz / body.rm
            total[3], total[4], total[5] = body.r1 * turn[0], body.r2 * turn[1], body.r3 * turn[2]
        number = 0
        for c in pressing[: flow.count]:
            plane = planes[c.plane]
            n = normal_of(plane)
            _set_row(rows[number], body, s, _lever(c), n)
            vectors[BENDS, number] = 0.0 if velocities else gap_of(s, _lever(c), plane)
            number += 1
            if c.sticks and (velocities or flow.all_stick):
                away = 0.0, 0.0, 0.0
                if not velocities:
                    away = added(added(place_of(s), 1.0, _lever(c)), -1.0, (c.ax, c.ay, c.az))
                friction_at = _friction_lever(c) if velocities else _lever(c)
                for along in tangents(n):
                    _set_row(rows[number], body, s, friction_at, along)
                    vectors[BENDS, number] = dot(along, away)
                    number += 1
        for k in range(number):
            for i in range(6):
                columns[k, i] = rows[k, i]
        _find_forces(system, number, _are_independent(flow, pressing, number))
        move = body.rm * total[0], body.rm * total[1], body.rm * total[2]
        if velocities:
            s.vx, s.vy, s.vz = move
            turn = total[3] / body.r1, total[4] / body.r2, total[5] / body.r3
            s.lx, s.ly, s.lz = in_room(s, turn)
            s.wx, s.wy, s.wz = angular_response(s, (s.lx, s.ly, s.lz))
        else:
            turn = body.r1 * total[3], body.r2 * total[4], body.r3 * total[5]
            nudge(body, s, move, in_room(s, turn))


@inline
def kappa_of(body, on_floor):
    """Return κ of a body on so many contacts on the floor, as `spread_friction` of the general law has it."""
    return min(body.kappa, LINE) if on_floor == 2 and body.kappa < 1.0 else body.kappa
