"""One line of an element: a spring with a damper, slack, strength and plastic elongation.

With the elongation e, its plastic part p, the slacks s₊ and s₋ (push), stiffness k and damping c, the line
is on one *branch* until the next event:

    OPEN     F = 0
    PLUS     F = k (e − p − s₊) + c ė,  F ≥ 0
    MINUS    F = k (e − p + s₋) + c ė,  F ≤ 0
    BOND     the same where s₊ + s₋ = 0, of either sign
    SLIP     F = its limit: p follows where the spring alone is at the limit

A branch ends where one of its *margins*, which are positive within it, falls below zero. The margins of two
neighbouring branches have opposite signs in the same state, so a line cannot go to and fro between them
without moving. On SLIP p is brought up to date at its end: till then the strain that it would have had
without slip is measured from where the slip began.
"""

from __future__ import annotations

import math

from stayput.compiled import inline, inner
from stayput.mechanics.restrained.columns import (
    BOND,
    DRAWN_OUT,
    DROPPED_OUT,
    MINUS,
    NORMAL,
    OPEN,
    PLUS,
    PULLED,
    PUSHED,
    SHEARED,
    SLIP_MINUS,
    SLIP_PLUS,
    TANGENT,
)

RELAXATION = 1e-3
"""Time by which a rate of slip is weighed against a force, where there is no damper to do it [s]."""


@inline
def slips_by_friction(el, i):
    """Whether the limit of a line is friction."""
    return i == TANGENT and el.friction == el.friction


@inline
def limit(el, i, plus, push):
    """Largest force of a line alone to one side [N/kg]; none where pull and shear act together."""
    if slips_by_friction(el, i):
        return el.friction * push
    if el.interaction != 0 and (plus or i == TANGENT):
        return math.inf
    return el.limit_plus[i] if plus else el.limit_minus[i]


@inline
def stretch(el, link, i, e):
    """Elastic elongation beyond the slack, if nothing slipped, on the line's branch [m]."""
    branch = link.branch[i]
    if branch == MINUS or (branch == SLIP_MINUS and el.slack_minus[i] < math.inf):
        return e - link.plastic[i] + el.slack_minus[i]
    return e - link.plastic[i] - el.slack_plus[i]


@inline
def force(el, link, i, e, rate, push):
    """Force of a line on its branch, + where it pulls the point back against a positive elongation."""
    branch = link.branch[i]
    if branch == OPEN:
        return 0.0
    if branch == SLIP_PLUS:
        return limit(el, i, True, push)
    if branch == SLIP_MINUS:
        return -limit(el, i, False, push)
    return el.stiffness[i] * stretch(el, link, i, e) + el.damping[i] * rate


@inline
def elastic_push(el, link, e, rate):
    """Push of the normal line's spring, which friction follows, and its rate."""
    branch = link.branch[NORMAL]
    if branch in (MINUS, BOND):
        push = -el.stiffness[NORMAL] * stretch(el, link, NORMAL, e)
        if push > 0.0:
            return push, -el.stiffness[NORMAL] * rate
    return 0.0, 0.0


@inline
def _slip_margins(el, link, i, e, rate, push, push_rate):
    plus = link.branch[i] == SLIP_PLUS
    side = 1.0 if plus else -1.0
    k, c = el.stiffness[i], el.damping[i]
    most = limit(el, i, plus, push)
    beyond = k * side * stretch(el, link, i, e) - most
    if slips_by_friction(el, i):
        return RELAXATION * (k * side * rate - el.friction * push_rate), math.inf
    back = min(beyond, 0.0) + (c if c > 0.0 else k * RELAXATION) * side * rate
    return back, k * (el.ultimate[i] - link.spent[i]) - max(beyond, 0.0)


@inline
def margins(el, link, i, e, rate, push, push_rate):
    """What must stay positive while a line is on its branch, as forces [N/kg].

    OPEN: not stretched, and not pushed, by spring and damper. PLUS, MINUS: the force keeps its sign;
    it is below the limit. BOND: it is below either limit. SLIP: it does not spring back; it does not part.
    """
    branch = link.branch[i]
    k, c = el.stiffness[i], el.damping[i]
    if branch == OPEN:
        over = k * (e - link.plastic[i] - el.slack_plus[i])
        under = k * (e - link.plastic[i] + el.slack_minus[i])
        return -min(over, over + c * rate), max(under, under + c * rate)
    if branch in (SLIP_PLUS, SLIP_MINUS):
        return _slip_margins(el, link, i, e, rate, push, push_rate)
    F = k * stretch(el, link, i, e) + c * rate
    if branch == PLUS:
        return F, limit(el, i, True, push) - F
    if branch == MINUS:
        return -F, limit(el, i, False, push) + F
    return limit(el, i, False, push) + F, limit(el, i, True, push) - F


@inline
def share(el, i, F):
    """Square of the part of a line's strength that a force uses; a push uses none of the pull's."""
    if i == NORMAL and F < 0.0:
        return 0.0
    used = F / (el.limit_plus[i] if F > 0.0 else el.limit_minus[i])
    return used * used


@inline
def joint_margin(el, pull, shear):
    """1 − (pull/strength)² − (shear/strength)², where the two act together; infinity where they do not."""
    if el.interaction == 0:
        return math.inf
    return 1.0 - share(el, NORMAL, pull) - share(el, TANGENT, shear)


@inner
def first_branch(el, link, i):
    """Put a line on the branch of a bonded one, or open."""
    bonded = el.slack_plus[i] + el.slack_minus[i] == 0.0
    link.branch[i] = BOND if bonded else OPEN
    link.plastic[i] = link.spent[i] = link.e[i] = link.rate[i] = link.force[i] = 0.0


@inner
def _spring_back(el, link, i, plus):
    """End a slip: the spring keeps what its limit allows, and the rest has become plastic."""
    side = 1.0 if plus else -1.0
    most = limit(el, i, plus, link.push)
    grown = max(0.0, side * stretch(el, link, i, link.e[i]) - most / el.stiffness[i])
    link.plastic[i] += side * grown
    link.spent[i] += grown
    bonded = el.slack_plus[i] + el.slack_minus[i] == 0.0
    link.branch[i] = BOND if bonded else (PLUS if plus else MINUS)


@inner
def fail(link, device, why, time):
    """Let a device be gone for good."""
    link.lines = 0
    link.force[NORMAL] = link.force[TANGENT] = 0.0
    device.failure, device.failure_time = why, time


@inner
def _reach_limit(el, link, device, i, plus, time):
    """Let a line whose force has passed its limit slip or, where it is brittle, break."""
    if el.ultimate[i] > 0.0 or slips_by_friction(el, i):
        before = link.branch[i]
        link.branch[i] = SLIP_PLUS if plus else SLIP_MINUS
        back, _ = margins(el, link, i, link.e[i], link.rate[i], link.push, link.push_rate)
        if back <= 0.0:
            link.branch[i] = before
            _spring_back(el, link, i, plus)
    elif i == TANGENT:
        fail(link, device, SHEARED, time)
    else:
        fail(link, device, PULLED if plus else PUSHED, time)


@inner
def _settle_line(el, link, device, i, time):
    """Bring a line's branch up to date with the elongation and rate last measured."""
    low, high = margins(el, link, i, link.e[i], link.rate[i], link.push, link.push_rate)
    branch = link.branch[i]
    if branch in (SLIP_PLUS, SLIP_MINUS):
        if high < 0.0:
            fail(link, device, DRAWN_OUT, time)
        elif low <= 0.0:
            _spring_back(el, link, i, branch == SLIP_PLUS)
        return
    if branch == OPEN:
        if low < 0.0:
            link.branch[i] = PLUS
        elif high < 0.0:
            link.branch[i] = MINUS
    elif branch != BOND and low < 0.0:
        if i == NORMAL and branch == MINUS and el.drops_out != 0:
            fail(link, device, DROPPED_OUT, time)
            return
        link.branch[i] = OPEN
    if link.branch[i] == OPEN:
        return
    F = force(el, link, i, link.e[i], link.rate[i], link.push)
    if limit(el, i, True, link.push) < F:
        _reach_limit(el, link, device, i, True, time)
    elif limit(el, i, False, link.push) < -F:
        _reach_limit(el, link, device, i, False, time)


@inner
def settle(el, link, device, time):
    """Bring the branches of an element up to date; whether it has just failed."""
    i = 0
    while i < link.lines:
        _settle_line(el, link, device, i, time)
        if i < link.lines:
            if i == NORMAL:
                link.push, link.push_rate = elastic_push(el, link, link.e[i], link.rate[i])
            link.force[i] = force(el, link, i, link.e[i], link.rate[i], link.push)
        i += 1
    if link.lines == 2 and joint_margin(el, link.force[NORMAL], link.force[TANGENT]) < 0.0:
        pulled = share(el, NORMAL, link.force[NORMAL]) >= share(el, TANGENT, link.force[TANGENT])
        fail(link, device, PULLED if pulled else SHEARED, time)
    return link.lines == 0
