"""The law of each line as numbers: its branch lasts from one event to the next, and on it all is linear.

The force is F = F₀ + k e + c ė, and where it slips by friction, that times the normal line's push. The
margins (see `lines`) are: of a TAUT line linear in F; of a SLACK one how far its spring is from being
stretched or pushed; of one that is SLIPPING whether it springs back, and what is left before it parts; of one
that is RUBBING whether it slips on. The elongation about the *origin*, G or a fulcrum that sticks, is
e = a + n·(x, z) + p cos θ + q sin θ; its derivative by θ is the lever of the force about that origin.
"""

from __future__ import annotations

import math

from stayput.compiled import inline, inner
from stayput.mechanics.restrained.columns import (
    AXIAL,
    BOND,
    MINUS,
    NORMAL,
    OPEN,
    RUBBING,
    SLACK,
    SLIP_MINUS,
    SLIP_PLUS,
    SLIPPING,
    TANGENT,
    TAUT,
)
from stayput.mechanics.restrained.lines import RELAXATION, limit, slips_by_friction, stretch


@inline
def _set_place(el, link, line, i, u, v, x, z):
    """Set where a line is about an origin at (x, z), from which its point is at (u, v)."""
    line.axial = 1 if el.kind == AXIAL else 0
    line.u, line.v, line.x, line.z = u, v, link.x - x, link.z - z
    nx, nz = (-el.sin, el.cos) if i == NORMAL else (el.cos, el.sin)
    line.nx, line.nz = nx, nz
    line.p, line.q = nx * u + nz * v, nx * v - nz * u
    line.a = -el.length if el.kind == AXIAL else -(nx * line.x + nz * line.z)


@inline
def _set_taut(el, link, line, i):
    branch = link.branch[i]
    k = el.stiffness[i]
    line.state, line.k, line.c, line.rubs = TAUT, k, el.damping[i], 0.0
    line.constant = k * stretch(el, link, i, 0.0)
    mu = el.friction if slips_by_friction(el, i) else 0.0
    plus, minus = limit(el, i, True, 0.0), limit(el, i, False, 0.0)
    line.low_at_0, line.low_F, line.low_rubs = 0.0, 1.0, 0.0
    line.high_at_0, line.high_F, line.high_rubs = plus, -1.0, mu
    if branch == BOND:
        line.low_at_0, line.low_rubs = minus, mu
    elif branch == MINUS:
        line.low_F, line.high_at_0, line.high_F = -1.0, minus, 1.0


@inline
def _set_slack(el, link, line, i):
    k = el.stiffness[i]
    line.state = SLACK
    line.constant = line.k = line.c = line.rubs = 0.0
    line.high_at_0 = k * (link.plastic[i] + el.slack_plus[i])
    line.low_at_0 = k * (link.plastic[i] - el.slack_minus[i])


@inline
def _set_slipping(el, link, line, i):
    plus = link.branch[i] == SLIP_PLUS
    side = 1.0 if plus else -1.0
    line.k = line.c = 0.0
    line.low_F = side
    if slips_by_friction(el, i):
        line.state, line.constant, line.rubs = RUBBING, 0.0, side * el.friction
        line.low_rubs = el.friction
        return
    most = limit(el, i, plus, 0.0)
    line.state, line.constant, line.rubs = SLIPPING, side * most, 0.0
    line.low_at_0 = side * el.stiffness[i] * stretch(el, link, i, 0.0) - most
    line.high_at_0 = el.stiffness[i] * (el.ultimate[i] - link.spent[i])


@inner
def set_lines(elements, links, case, corner, x, z, work):
    """List the lines that act, about an origin at (x, z).

    Parameters
    ----------
    corner : int
        The corner of the body that is at the origin; −1 where G is, whose place is then given later.
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
            line.pushes = 1 if i == NORMAL and branch in (MINUS, BOND) else 0
            line.joins = 1 if i == TANGENT and el.interaction != 0 else 0
            line.per_plus = line.per_minus = 0.0
            if el.interaction != 0:
                line.per_plus = 1.0 / el.limit_plus[i]
                line.per_minus = 0.0 if i == NORMAL else 1.0 / el.limit_minus[i]
            _set_place(el, link, line, i, u, v, x, z)
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
    """Elongation of a line and its rate, its direction, and the lever of its force about the origin.

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
    return line.constant + line.k * e + line.c * rate + line.rubs * push


@inline
def push_of(line, F, rate):
    """Push that the friction of the next row follows, and its rate; there is no damper beside friction."""
    if line.pushes != 0 and F < 0.0:
        return -F, -line.k * rate
    return 0.0, 0.0


@inline
def margins_of(line, e, rate, F, push, push_rate):
    """What must stay positive while a line is on its branch, as forces; as `lines.margins`."""
    state = line.state
    if state == TAUT:
        return (
            line.low_at_0 + line.low_F * F + line.low_rubs * push,
            line.high_at_0 + line.high_F * F + line.high_rubs * push,
        )
    k, c = line.stiffness, line.damping
    if state == SLACK:
        over, under = k * e - line.high_at_0, k * e - line.low_at_0
        return -min(over, over + c * rate), max(under, under + c * rate)
    side = line.low_F
    if state == RUBBING:
        return RELAXATION * (k * side * rate - line.low_rubs * push_rate), math.inf
    beyond = line.low_at_0 + k * side * e
    back = min(beyond, 0.0) + (c if c > 0.0 else k * RELAXATION) * side * rate
    return back, line.high_at_0 - max(beyond, 0.0)


@inline
def used_of(line, F):
    """Square of the part of its strength that a line uses; a push uses none of the pull's."""
    used = F * (line.per_plus if F > 0.0 else line.per_minus)
    return used * used
