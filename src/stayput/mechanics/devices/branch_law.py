"""Coefficients of each line's force law on its present branch, where force and margins are linear.

They are set when a mode begins and hold to the next event. The force is F = F₀ + k e + c ė, or where the line
slips by friction, a multiple of the normal line's push. The margins (see `device_law`) are: of an ELASTIC
line, linear in F; of a SLACK line, the distance of its spring from pulling or pushing; of a YIELDING line,
unloading and the elongation left to rupture; of a FRICTION line, whether it keeps slipping. The elongation
about the *origin*, G or a fulcrum that sticks, is e = a + n·(x, z) + p cos θ + q sin θ; its derivative by θ
is the lever of the force about that origin.
"""

from __future__ import annotations

import math

from stayput.compiled import inline, inner
from stayput.mechanics.devices.columns import (
    AXIAL,
    BOND,
    ELASTIC,
    FRICTION,
    MINUS,
    NORMAL,
    OPEN,
    SLACK,
    SLIP_MINUS,
    SLIP_PLUS,
    TANGENT,
    YIELDING,
)
from stayput.mechanics.devices.device_law import SLIP_RATE_TIME, elastic_elongation, limit, slips_by_friction


@inline
def _set_place(el, link, line, i, u, v, x, z):
    """Set the geometry of a line about an origin at (x, z), from which its point is at (u, v)."""
    line.axial = 1 if el.kind == AXIAL else 0
    line.u, line.v, line.x, line.z = u, v, link.x - x, link.z - z
    nx, nz = (-el.sin, el.cos) if i == NORMAL else (el.cos, el.sin)
    line.nx, line.nz = nx, nz
    line.p, line.q = nx * u + nz * v, nx * v - nz * u
    line.reach = math.sqrt(u * u + v * v)
    line.a = -el.length if el.kind == AXIAL else -(nx * line.x + nz * line.z)


@inline
def _set_taut(el, link, line, i):
    branch = link.branch[i]
    k = el.stiffness[i]
    line.state, line.k, line.c, line.per_push = ELASTIC, k, el.damping[i], 0.0
    line.constant = k * elastic_elongation(el, link, i, 0.0)
    mu = el.friction if slips_by_friction(el, i) else 0.0
    plus, minus = limit(el, i, True, 0.0), limit(el, i, False, 0.0)
    line.low_at_0, line.low_F, line.low_per_push = 0.0, 1.0, 0.0
    line.high_at_0, line.high_F, line.high_per_push = plus, -1.0, mu
    if branch == BOND:
        line.low_at_0, line.low_per_push = minus, mu
    elif branch == MINUS:
        line.low_F, line.high_at_0, line.high_F = -1.0, minus, 1.0


@inline
def _set_slack(el, link, line, i):
    k = el.stiffness[i]
    line.state = SLACK
    line.constant = line.k = line.c = line.per_push = 0.0
    line.high_at_0 = k * (link.plastic[i] + el.slack_plus[i])
    line.low_at_0 = k * (link.plastic[i] - el.slack_minus[i])


@inline
def _set_slipping(el, link, line, i):
    plus = link.branch[i] == SLIP_PLUS
    side = 1.0 if plus else -1.0
    line.k = line.c = 0.0
    line.low_F = side
    if slips_by_friction(el, i):
        line.state, line.constant, line.per_push = FRICTION, 0.0, side * el.friction
        line.low_per_push = el.friction
        return
    most = limit(el, i, plus, 0.0)
    line.state, line.constant, line.per_push = YIELDING, side * most, 0.0
    line.low_at_0 = side * el.stiffness[i] * elastic_elongation(el, link, i, 0.0) - most
    line.high_at_0 = el.stiffness[i] * (el.ultimate[i] - link.plastic_sum[i])


@inner
def set_lines(elements, links, case, corner, x, z, work):
    """Set the rows of the active lines, about an origin at (x, z).

    Parameters
    ----------
    corner : int
        Corner of the body at the origin; −1 where the origin is G, whose position is then given later.
    """
    count = 0
    for n in range(elements.shape[0]):
        el, link = elements[n], links[n]
        u, v = el.u, el.v
        if corner >= 0:
            u, v = u - case.u[corner], v - case.v[corner]
        for i in range(link.lines):
            line = work.line[count]
            line.element, line.tangent = n, i
            line.stiffness, line.damping = el.stiffness[i], el.damping[i]
            branch = link.branch[i]
            line.bears_friction = 1 if i == NORMAL and branch in (MINUS, BOND, SLIP_MINUS) else 0
            line.interacts = 1 if i == TANGENT and el.interaction != 0 else 0
            line.per_plus = line.per_minus = 0.0
            if el.interaction != 0:
                line.per_plus = 1.0 / el.limit_plus[i]
                line.per_minus = 0.0 if i == NORMAL else 1.0 / el.limit_minus[i]
            _set_place(el, link, line, i, u, v, x, z)
            if corner < 0:
                line.reach = math.inf
            if branch == OPEN:
                _set_slack(el, link, line, i)
            elif branch in (SLIP_PLUS, SLIP_MINUS):
                _set_slipping(el, link, line, i)
            else:
                _set_taut(el, link, line, i)
            count += 1
    work.lines = count


@inline
def place_of(line, sin, cos, moves, x, z, vx, vz, omega):
    """Elongation of a line and its rate, its direction, and the lever arm of its force about the origin.

    The origin, where it ``moves``, is at (x, z) with the rates ẋ and ż.
    """
    if line.axial == 0:
        nx, nz = line.nx, line.nz
        lever = line.q * cos - line.p * sin
        e, rate = line.a + (line.p * cos + line.q * sin), omega * lever
        if moves:
            e, rate = e + (nx * x + nz * z), rate + (nx * vx + nz * vz)
        return e, rate, nx, nz, lever
    dx, dz = line.u * cos + line.v * sin, line.v * cos - line.u * sin
    right, up = dx, dz
    dx, dz = dx - line.x, dz - line.z
    if moves:
        dx, dz = dx + x, dz + z
    far = math.sqrt(dx * dx + dz * dz)
    nx, nz = (dx / far, dz / far) if far > 0.0 else (0.0, 0.0)
    lever = nx * up - nz * right
    rate = omega * lever
    if moves:
        rate += nx * vx + nz * vz
    return far + line.a, rate, nx, nz, lever


@inline
def force_of(line, e, rate, push):
    """Force of a line, + where it pulls the point back against a positive elongation."""
    return line.constant + line.k * e + line.c * rate + line.per_push * push


@inline
def push_of(line, F, rate):
    """Push that loads the friction of the next row, and its rate; friction excludes a damper."""
    if line.bears_friction != 0 and F < 0.0:
        return -F, -line.k * rate
    return 0.0, 0.0


@inline
def margins_of(line, e, rate, F, push, push_rate):
    """Event margins of a line, positive while it is on its branch [N/kg]; as `device_law.margins`."""
    state = line.state
    if state == ELASTIC:
        return (
            line.low_at_0 + line.low_F * F + line.low_per_push * push,
            line.high_at_0 + line.high_F * F + line.high_per_push * push,
        )
    k, c = line.stiffness, line.damping
    if state == SLACK:
        over, under = k * e - line.high_at_0, k * e - line.low_at_0
        return -min(over, over + c * rate), max(under, under + c * rate)
    side = line.low_F
    if state == FRICTION:
        return SLIP_RATE_TIME * (k * side * rate - line.low_per_push * push_rate), math.inf
    beyond = line.low_at_0 + k * side * e
    back = min(beyond, 0.0) + (c if c > 0.0 else k * SLIP_RATE_TIME) * side * rate
    return back, line.high_at_0 - max(beyond, 0.0)


@inline
def clipped_to_margins(line, F):
    """Clip F to the range of forces of the line's branch; see `device_law.clipped_to_branch`."""
    if line.state != ELASTIC or line.high_per_push != 0.0:  # friction's limit moves with the push
        return F
    if line.per_plus > 0.0:  # with interaction, neither pull nor shear alone exceeds its strength
        F = min(F, 1.0 / line.per_plus)
    if line.per_minus > 0.0:
        F = max(F, -1.0 / line.per_minus)
    if line.low_F < 0.0:  # MINUS: the force is below zero
        return min(line.low_at_0, max(-line.high_at_0, F))
    return min(line.high_at_0, max(-line.low_at_0, F))


@inline
def utilization_of(line, F):
    """Squared utilization (force/strength)² of a line; a push of the normal line counts as zero."""
    used = F * (line.per_plus if F > 0.0 else line.per_minus)
    return used * used
