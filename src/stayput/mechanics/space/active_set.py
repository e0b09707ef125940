"""Accelerations of a lone body on contacts that are known to press, and to stick or to slip.

With velocities ν scaled so that the mass matrix is 1, the rows G of contacts, and the columns F of their forces λ,

    ν' = ν₀' + Σ F λ,        G ν' + b = 0,

where b is what the contact's point is accelerated by the rotation. Of a contact that sticks the rows are those
along its normal and tangents, and F = Gᵀ; of one that slips the row is that along the normal, and F has
friction against the slip too. λ is −(G ν' + b) times a penalty: so six equations give ν', whatever the number
of contacts, and where there are more than the body needs these share alike.

On the floor friction acts about the centre of pressure (`stayput.mechanics.space.solve.spread_friction`), which
follows from the forces. Rounds "forces, centre of pressure, forces" may diverge where an edge turns about
itself; the secant of the last two (Anderson's mixing) does not.
"""

from __future__ import annotations

import math

from stayput.compiling import inline, inner
from stayput.mechanics.space.body import angular_response, in_body, in_room, nudge, place_of, rotation, velocity
from stayput.mechanics.space.columns import LINE
from stayput.mechanics.space.constants import (
    CONSTRAINT_PENALTY,
    PRESSURE_ROUNDS,
    PRESSURE_TOLERANCE,
    SLIP_BEGIN_SPEED,
    SLIP_END_SPEED,
)
from stayput.mechanics.space.contact import velocity_at
from stayput.mechanics.space.touching import gap_of, lever_of_point
from stayput.mechanics.space.vectors import added, cross, dot, normal_of, scaled, tangents

ALONG_NORMAL, ALONG_FIRST, ALONG_SECOND, OF_FORCE = range(4)
"""Rows of a contact: of its velocity along the normal and both tangents; and the column of its force."""


@inline
def _lever(c):
    return c.rx, c.ry, c.rz


@inline
def _friction_lever(c):
    return c.fx, c.fy, c.fz


@inner
def set_levers(flow, pressing, points, s):
    """Set the levers of the contacts, and the centre of pressure that the last forces had."""
    weight = x = y = 0.0
    for c in pressing[: flow.count]:
        c.rx, c.ry, c.rz = lever_of_point(s, points[c.point])
        if c.floor:
            share = max(c.pn, 0.0) + 1e-300
            weight, x, y = weight + share, x + share * c.rx, y + share * c.ry
    if weight > 0.0:
        flow.cx, flow.cy = x / weight, y / weight


@inner
def _set_friction_levers(flow, pressing, planes, s):
    """Set where friction acts, and how fast contacts slip there."""
    for c in pressing[: flow.count]:
        c.fx, c.fy, c.fz = c.rx, c.ry, c.rz
        if c.kappa < 1.0:
            c.fx, c.fy = flow.cx + c.kappa * (c.rx - flow.cx), flow.cy + c.kappa * (c.ry - flow.cy)
        first, second = tangents(normal_of(planes[c.plane]))
        u = velocity_at(s, _friction_lever(c))
        c.us, c.ut = dot(first, u), dot(second, u)
        if flow.begins:
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


@inline
def _square(row):
    return (
        row[0] * row[0] + row[1] * row[1] + row[2] * row[2] + row[3] * row[3] + row[4] * row[4] + row[5] * row[5]
    )


@inner
def _set_rows(flow, pressing, planes, body, s, rows):
    """Set the rows of all contacts, and their penalties."""
    for k in range(flow.count):
        c = pressing[k]
        n = normal_of(planes[c.plane])
        first, second = tangents(n)
        _set_row(rows[k, ALONG_NORMAL], body, s, _lever(c), n)
        _set_row(rows[k, ALONG_FIRST], body, s, _friction_lever(c), first)
        _set_row(rows[k, ALONG_SECOND], body, s, _friction_lever(c), second)
        c.firm = CONSTRAINT_PENALTY / _square(rows[k, ALONG_NORMAL])
        if c.sticks:
            c.grip_s = CONSTRAINT_PENALTY / _square(rows[k, ALONG_FIRST])
            c.grip_t = CONSTRAINT_PENALTY / _square(rows[k, ALONG_SECOND])
        else:
            along, across = _slip_direction(c)
            for i in range(6):
                rows[k, OF_FORCE, i] = rows[k, ALONG_NORMAL, i] - c.mu_kinetic * (
                    along * rows[k, ALONG_FIRST, i] + across * rows[k, ALONG_SECOND, i]
                )


@inline
def _add_product(matrix, factor, column, row):
    for i in range(6):
        share = factor * column[i]
        for j in range(6):
            matrix[i, j] += share * row[j]


@inline
def _times(row, matrix):
    """Return a row times the vector in the last column of a matrix."""
    return (
        row[0] * matrix[0, 6]
        + row[1] * matrix[1, 6]
        + row[2] * matrix[2, 6]
        + row[3] * matrix[3, 6]
        + row[4] * matrix[4, 6]
        + row[5] * matrix[5, 6]
    )


@inline
def _ask(matrix, factor, column, row, wanted, x):
    """Add a penalty on row · (x + y) + wanted to the equations of y."""
    _add_product(matrix, factor, column, row)
    miss = wanted
    for i in range(6):
        miss += row[i] * x[i]
    for i in range(6):
        matrix[i, 6] -= factor * miss * column[i]


@inline
def _clear(matrix):
    for i in range(6):
        for j in range(7):
            matrix[i, j] = 0.0
        matrix[i, i] = 1.0


@inner
def _solve(matrix):
    """Solve six equations in place, their right-hand side and then the solution in the last column."""
    for k in range(6):
        largest = k
        for i in range(k + 1, 6):
            if abs(matrix[i, k]) > abs(matrix[largest, k]):
                largest = i
        if largest != k:
            for j in range(k, 7):
                matrix[k, j], matrix[largest, j] = matrix[largest, j], matrix[k, j]
        over = 1.0 / matrix[k, k]
        for i in range(k + 1, 6):
            factor = over * matrix[i, k]
            for j in range(k + 1, 7):
                matrix[i, j] -= factor * matrix[k, j]
    for i in range(5, -1, -1):
        total = matrix[i, 6]
        for j in range(i + 1, 6):
            total -= matrix[i, j] * matrix[j, 6]
        matrix[i, 6] = total / matrix[i, i]


@inner
def _find_forces(flow, pressing, planes, s, rows, matrix, free):
    """Set the forces of all contacts with their levers as they are, and the acceleration in ``matrix``."""
    spin = rotation(s)
    _clear(matrix)
    for k in range(flow.count):
        c = pressing[k]
        n = normal_of(planes[c.plane])
        turns = dot(n, cross(spin, cross(spin, _lever(c))))
        if c.sticks:
            first, second = tangents(n)
            moves = cross(spin, cross(spin, _friction_lever(c)))
            _ask(matrix, c.firm, rows[k, ALONG_NORMAL], rows[k, ALONG_NORMAL], turns, free)
            _ask(matrix, c.grip_s, rows[k, ALONG_FIRST], rows[k, ALONG_FIRST], dot(first, moves), free)
            _ask(matrix, c.grip_t, rows[k, ALONG_SECOND], rows[k, ALONG_SECOND], dot(second, moves), free)
        else:
            _ask(matrix, c.firm, rows[k, OF_FORCE], rows[k, ALONG_NORMAL], turns, free)
    _solve(matrix)
    for i in range(6):
        matrix[i, 6] += free[i]
    for k in range(flow.count):
        c = pressing[k]
        n = normal_of(planes[c.plane])
        turns = dot(n, cross(spin, cross(spin, _lever(c))))
        c.pn = -c.firm * (_times(rows[k, ALONG_NORMAL], matrix) + turns)
        if c.sticks:
            first, second = tangents(n)
            moves = cross(spin, cross(spin, _friction_lever(c)))
            c.ps = -c.grip_s * (_times(rows[k, ALONG_FIRST], matrix) + dot(first, moves))
            c.pt = -c.grip_t * (_times(rows[k, ALONG_SECOND], matrix) + dot(second, moves))
        else:
            along, across = _slip_direction(c)
            c.ps, c.pt = -c.mu_kinetic * c.pn * along, -c.mu_kinetic * c.pn * across


@inline
def _centre_of_pressure(flow, pressing):
    """Return the middle of the forces on the floor, and whether it matters where that is."""
    weight = x = y = 0.0
    matters = False
    for c in pressing[: flow.count]:
        if c.floor:
            share = max(c.pn, 0.0) + 1e-300
            weight, x, y = weight + share, x + share * c.rx, y + share * c.ry
            matters = matters or c.kappa < 1.0
    return (x / weight, y / weight, matters) if matters else (0.0, 0.0, False)


@inner
def accelerate(flow, pressing, body, points, planes, s, push, rows, matrix, free, rates):
    """Set how velocity and angular momentum change, and the forces of all contacts.

    Parameters
    ----------
    push : tuple
        The acceleration that acts on the body; force and moment of its devices stand in ``flow``.
    rows, matrix, free : float64[n, 4, 6], float64[6, 7], float64[6]
        Working memory.
    rates : float64[6]
        The changes.
    """
    spin = rotation(s)
    gyro = cross(spin, (s.lx, s.ly, s.lz))
    turning = in_body(s, added((flow.mx, flow.my, flow.mz), -1.0, gyro))
    free[0] = push[0] / body.rm + body.rm * flow.fx
    free[1] = push[1] / body.rm + body.rm * flow.fy
    free[2] = push[2] / body.rm + body.rm * flow.fz
    free[3], free[4], free[5] = body.r1 * turning[0], body.r2 * turning[1], body.r3 * turning[2]
    if flow.count == 0:
        for i in range(6):
            matrix[i, 6] = free[i]
    else:
        set_levers(flow, pressing, points, s)
        px = py = gx = gy = 0.0
        for number in range(PRESSURE_ROUNDS):
            _set_friction_levers(flow, pressing, planes, s)
            _set_rows(flow, pressing, planes, body, s, rows)
            _find_forces(flow, pressing, planes, s, rows, matrix, free)
            x, y, matters = _centre_of_pressure(flow, pressing)
            dx, dy = x - flow.cx, y - flow.cy
            if not matters or abs(dx) + abs(dy) <= PRESSURE_TOLERANCE:
                break
            mix = 0.0
            if number > 0:
                ex, ey = dx - gx, dy - gy
                square = ex * ex + ey * ey
                mix = (ex * dx + ey * dy) / square if square > 0.0 else 0.0
            last_x, last_y = px, py
            px, py, gx, gy = x, y, dx, dy
            flow.cx, flow.cy = x - mix * (x - last_x), y - mix * (y - last_y)
    rates[0], rates[1], rates[2] = body.rm * matrix[0, 6], body.rm * matrix[1, 6], body.rm * matrix[2, 6]
    turning = matrix[3, 6] / body.r1, matrix[4, 6] / body.r2, matrix[5, 6] / body.r3
    rates[3], rates[4], rates[5] = added(in_room(s, turning), 1.0, gyro)


@inner
def margin_of(flow, pressing, weight):
    """Return the least of what forces have left until a contact lifts or slips, over the weight, and of slips.

    Those are over the speed at which a flow begins.
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
def project(flow, pressing, body, points, planes, s, rows, matrix, free):
    """Put contacts that press back onto their planes, and take away the velocities that they forbid.

    What sticks is put back where it stuck at first too, if all does: else the centre of friction moves.
    """
    if flow.count == 0:
        return
    for velocities in range(2):
        set_levers(flow, pressing, points, s)
        _set_friction_levers(flow, pressing, planes, s)
        _clear(matrix)
        if velocities:
            turn = in_body(s, (s.lx, s.ly, s.lz))
            free[0], free[1], free[2] = s.vx / body.rm, s.vy / body.rm, s.vz / body.rm
            free[3], free[4], free[5] = body.r1 * turn[0], body.r2 * turn[1], body.r3 * turn[2]
        else:
            for i in range(6):
                free[i] = 0.0
        for k in range(flow.count):
            c, plane = pressing[k], planes[pressing[k].plane]
            n = normal_of(plane)
            first, second = tangents(n)
            friction_at = _friction_lever(c) if velocities else _lever(c)
            _set_row(rows[k, ALONG_NORMAL], body, s, _lever(c), n)
            _set_row(rows[k, ALONG_FIRST], body, s, friction_at, first)
            _set_row(rows[k, ALONG_SECOND], body, s, friction_at, second)
            gap = 0.0 if velocities else gap_of(s, _lever(c), plane)
            firm = CONSTRAINT_PENALTY / _square(rows[k, ALONG_NORMAL])
            _ask(matrix, firm, rows[k, ALONG_NORMAL], rows[k, ALONG_NORMAL], gap, free)
            if c.sticks and (velocities or flow.all_stick):
                away = 0.0, 0.0, 0.0
                if not velocities:
                    away = added(added(place_of(s), 1.0, _lever(c)), -1.0, (c.ax, c.ay, c.az))
                for axis, along in ((ALONG_FIRST, first), (ALONG_SECOND, second)):
                    firm = CONSTRAINT_PENALTY / _square(rows[k, axis])
                    _ask(matrix, firm, rows[k, axis], rows[k, axis], dot(along, away), free)
        _solve(matrix)
        move = body.rm * matrix[0, 6], body.rm * matrix[1, 6], body.rm * matrix[2, 6]
        if velocities:
            s.vx, s.vy, s.vz = added(velocity(s), 1.0, move)
            turn = matrix[3, 6] / body.r1, matrix[4, 6] / body.r2, matrix[5, 6] / body.r3
            s.lx, s.ly, s.lz = added((s.lx, s.ly, s.lz), 1.0, in_room(s, turn))
            s.wx, s.wy, s.wz = angular_response(s, (s.lx, s.ly, s.lz))
        else:
            turn = body.r1 * matrix[3, 6], body.r2 * matrix[4, 6], body.r3 * matrix[5, 6]
            nudge(body, s, move, in_room(s, turn))


@inline
def kappa_of(body, on_floor):
    """Return κ of a body on so many contacts on the floor (`stayput.mechanics.space.solve.spread_friction`)."""
    return min(body.kappa, LINE) if on_floor == 2 and body.kappa < 1.0 else body.kappa
