"""Force law of one line of a device: spring and damper with slack, strength and plastic elongation.

With the elongation e, its plastic part p, the slacks s₊ and s₋ (push), stiffness k and damping c, the line
is on one *branch* until the next event:

    OPEN     F = 0
    PLUS     F = k (e − p − s₊) + c ė,  F ≥ 0
    MINUS    F = k (e − p + s₋) + c ė,  F ≤ 0
    BOND     the same where s₊ + s₋ = 0, of either sign
    SLIP     F = its limit (yield or friction); p follows where the spring alone is at the limit

A branch ends where one of its *margins*, which are positive within it, falls below zero. The margins of two
neighbouring branches have opposite signs in the same state, so a line cannot alternate between them without
moving. On SLIP p is updated only at its end: until then the elongation is measured from where the slip began.
"""

from __future__ import annotations

import math

from stayput.compiled import inline, inner
from stayput.mechanics.devices.columns import (
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

SLIP_RATE_TIME = 1e-3
"""Time constant that turns a slip rate into a force margin where there is no damper [s]."""


@inline
def slips_by_friction(el, i):
    """Whether the limit of a line is friction, not strength."""
    return i == TANGENT and el.friction == el.friction  # False for NaN


@inline
def limit(el, i, plus, push):
    """Largest force of a line to one side [N/kg]; infinite where pull and shear interact instead."""
    if slips_by_friction(el, i):
        return el.friction * push
    if el.interaction != 0 and (plus or i == TANGENT):
        return math.inf
    return el.limit_plus[i] if plus else el.limit_minus[i]


@inline
def elastic_elongation(el, link, i, e):
    """Elastic elongation beyond the slack on the line's branch, as if it did not slip [m]."""
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
    return el.stiffness[i] * elastic_elongation(el, link, i, e) + el.damping[i] * rate


@inline
def clipped_to_branch(el, link, i, F, push):
    """Clip F to the range of forces of the line's branch.

    A force evaluated with the branch from before an impact, or just after the event, is outside it.
    """
    branch = link.branch[i]
    most = 0.0 if branch == MINUS else limit(el, i, True, push)
    least = 0.0 if branch == PLUS else -limit(el, i, False, push)
    if el.interaction != 0:
        most = min(most, el.limit_plus[i])
        least = max(least, -el.limit_minus[i]) if i == TANGENT else least
    return min(most, max(least, F))


@inline
def elastic_push(el, link, e, rate):
    """Push of the normal line, on which the tangent's friction acts, and its rate (0 where it yields)."""
    branch = link.branch[NORMAL]
    if branch == SLIP_MINUS:
        return el.limit_minus[NORMAL], 0.0
    if branch in (MINUS, BOND):
        push = -el.stiffness[NORMAL] * elastic_elongation(el, link, NORMAL, e)
        if push > 0.0:
            return push, -el.stiffness[NORMAL] * rate
    return 0.0, 0.0


@inline
def _slip_margins(el, link, i, e, rate, push, push_rate):
    plus = link.branch[i] == SLIP_PLUS
    side = 1.0 if plus else -1.0
    k, c = el.stiffness[i], el.damping[i]
    most = limit(el, i, plus, push)
    beyond = k * side * elastic_elongation(el, link, i, e) - most
    if slips_by_friction(el, i):
        return SLIP_RATE_TIME * (k * side * rate - el.friction * push_rate), math.inf
    back = min(beyond, 0.0) + (c if c > 0.0 else k * SLIP_RATE_TIME) * side * rate
    return back, k * (el.ultimate[i] - link.plastic_sum[i]) - max(beyond, 0.0)


@inline
def margins(el, link, i, e, rate, push, push_rate):
    """Event margins of a line, positive while it is on its branch [N/kg].

    OPEN: neither pulled nor pushed by spring and damper. PLUS, MINUS: the force keeps its sign; it is below
    the limit. BOND: it is below either limit. SLIP: it does not unload; it has not ruptured.
    """
    branch = link.branch[i]
    k, c = el.stiffness[i], el.damping[i]
    if branch == OPEN:
        over = k * (e - link.plastic[i] - el.slack_plus[i])
        under = k * (e - link.plastic[i] + el.slack_minus[i])
        return -min(over, over + c * rate), max(under, under + c * rate)
    if branch in (SLIP_PLUS, SLIP_MINUS):
        return _slip_margins(el, link, i, e, rate, push, push_rate)
    F = k * elastic_elongation(el, link, i, e) + c * rate
    if branch == PLUS:
        return F, limit(el, i, True, push) - F
    if branch == MINUS:
        return -F, limit(el, i, False, push) + F
    return limit(el, i, False, push) + F, limit(el, i, True, push) - F


@inline
def utilization(el, i, F):
    """Squared utilization (force/strength)² of a line; a push of the normal line counts as zero."""
    if i == NORMAL and F < 0.0:
        return 0.0
    used = F / (el.limit_plus[i] if F > 0.0 else el.limit_minus[i])
    return used * used


@inline
def interaction_margin(el, pull, shear):
    """1 − (pull/strength)² − (shear/strength)² where the two interact, else infinity."""
    if el.interaction == 0:
        return math.inf
    return 1.0 - utilization(el, NORMAL, pull) - utilization(el, TANGENT, shear)


@inner
def reset_branch(el, link, i):
    """Reset a line to its initial branch, BOND or OPEN, with no elongation."""
    bonded = el.slack_plus[i] + el.slack_minus[i] == 0.0
    link.branch[i] = BOND if bonded else OPEN
    link.plastic[i] = link.plastic_sum[i] = link.e[i] = link.rate[i] = link.force[i] = 0.0


@inner
def _end_slip(el, link, i, plus):
    """End of slip: record the plastic elongation, resume the elastic branch."""
    side = 1.0 if plus else -1.0
    most = limit(el, i, plus, link.push)
    grown = max(0.0, side * elastic_elongation(el, link, i, link.e[i]) - most / el.stiffness[i])
    link.plastic[i] += side * grown
    link.plastic_sum[i] += grown
    bonded = el.slack_plus[i] + el.slack_minus[i] == 0.0
    link.branch[i] = BOND if bonded else (PLUS if plus else MINUS)


@inline
def note_force(device, i, F):
    """Update the peak force of a line."""
    if i == TANGENT:
        device.peak_shear = max(device.peak_shear, abs(F))
    elif F > 0.0:
        device.peak_pull = max(device.peak_pull, F)
    else:
        device.peak_push = max(device.peak_push, -F)


@inner
def fail(link, device, why, time):
    """Remove a failed device for the rest of the run."""
    link.lines = 0
    link.force[NORMAL] = link.force[TANGENT] = 0.0
    device.failure, device.failure_time = why, time


@inner
def _reach_limit(el, link, device, i, plus, time):
    """Line at its limit: start slip if it is ductile or limited by friction, else fail."""
    if el.ultimate[i] > 0.0 or slips_by_friction(el, i):
        before = link.branch[i]
        link.branch[i] = SLIP_PLUS if plus else SLIP_MINUS
        # slip starts only if its own margin is positive: a line already unloading goes back at once
        back, _ = margins(el, link, i, link.e[i], link.rate[i], link.push, link.push_rate)
        if back <= 0.0:
            link.branch[i] = before
            _end_slip(el, link, i, plus)
        return
    note_force(device, i, limit(el, i, True, link.push) if plus else -limit(el, i, False, link.push))
    if i == TANGENT:
        fail(link, device, SHEARED, time)
    else:
        fail(link, device, PULLED if plus else PUSHED, time)


@inner
def _update_line(el, link, device, i, time):
    """Update a line's branch for the elongation and rate last evaluated."""
    low, high = margins(el, link, i, link.e[i], link.rate[i], link.push, link.push_rate)
    branch = link.branch[i]
    if branch in (SLIP_PLUS, SLIP_MINUS):
        if high < 0.0:
            fail(link, device, DRAWN_OUT, time)
        elif low <= 0.0:
            _end_slip(el, link, i, branch == SLIP_PLUS)
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
def update_element(el, link, device, time):
    """Update the branches of an element; whether it has just failed."""
    i = 0
    while i < link.lines:
        _update_line(el, link, device, i, time)
        if i < link.lines:
            if i == NORMAL:
                link.push, link.push_rate = elastic_push(el, link, link.e[i], link.rate[i])
            link.force[i] = force(el, link, i, link.e[i], link.rate[i], link.push)
        i += 1
    if link.lines == 2 and interaction_margin(el, link.force[NORMAL], link.force[TANGENT]) < 0.0:
        pull, shear = link.force[NORMAL], link.force[TANGENT]
        # a damper's force jumps in an impact: the peak recorded at failure is scaled back to the strength
        of_pull, of_shear = utilization(el, NORMAL, pull), utilization(el, TANGENT, shear)
        part = 1.0 / math.sqrt(of_pull + of_shear)
        note_force(device, NORMAL, part * pull if pull > 0.0 else pull)
        note_force(device, TANGENT, part * shear)
        pulled = of_pull >= of_shear
        fail(link, device, PULLED if pulled else SHEARED, time)
    return link.lines == 0
