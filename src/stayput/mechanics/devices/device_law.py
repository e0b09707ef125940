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

On a branch force and margins are linear, so the law is the numbers of a `columns.LAW`, which hold to the
next event: F = F₀ + k e + c ė, or where the line slips by friction, a multiple of the normal line's push. The
margins are: of an ELASTIC line, linear in F; of a SLACK line, the distance of its spring from pulling or
pushing; of a YIELDING line, unloading and the elongation left to rupture; of a FRICTION line, whether it
keeps slipping, and the slip left until it is lost: a friction line with an ultimate elongation is lost where
its slip |p| from where it was at first reaches it, whatever it slipped to and fro.
"""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.devices import columns as col

SLIP_RATE_TIME = 1e-3
"""Time constant that turns a slip rate into a force margin where there is no damper [s]."""


@inline
def slips_by_friction(el, i):
    """Whether the limit of a line is friction, not strength."""
    return i == col.TANGENT and el.friction == el.friction  # False for NaN


@inline
def limit(el, i, plus, push):
    """Largest force of a line to one side [N/kg]; infinite where pull and shear interact instead."""
    if slips_by_friction(el, i):
        return el.friction * push
    if el.interaction != 0 and (plus or i == col.TANGENT):
        return math.inf
    return el.limit_plus[i] if plus else el.limit_minus[i]


@inline
def elastic_elongation(el, link, i, e):
    """Elastic elongation beyond the slack on the line's branch, as if it did not slip [m]."""
    branch = link.branch[i]
    if branch == col.MINUS or (branch == col.SLIP_MINUS and el.slack_minus[i] < math.inf):
        return e - link.plastic[i] + el.slack_minus[i]
    return e - link.plastic[i] - el.slack_plus[i]


@inner
def set_law(line, el, link, i):
    """Set the law of a line on its branch, in a `columns.LAW` or in a row of `columns.LINE`."""
    branch = link.branch[i]
    k = el.stiffness[i]
    line.stiffness, line.damping = k, el.damping[i]
    bears = i == col.NORMAL and branch in (col.MINUS, col.BOND, col.SLIP_MINUS)
    line.bears_friction = 1 if bears else 0
    line.per_plus = line.per_minus = 0.0
    if el.interaction != 0:
        line.per_plus = 1.0 / el.limit_plus[i]
        line.per_minus = 0.0 if i == col.NORMAL else 1.0 / el.limit_minus[i]
    # on SLACK, and where one of these means nothing
    line.state = col.SLACK
    line.constant = line.k = line.c = line.per_push = 0.0
    line.low_at_0 = k * (link.plastic[i] - el.slack_minus[i])
    line.high_at_0 = k * (link.plastic[i] + el.slack_plus[i])
    line.low_per_force = line.high_per_force = line.low_per_push = line.high_per_push = 0.0
    if branch in (col.SLIP_PLUS, col.SLIP_MINUS):
        plus = branch == col.SLIP_PLUS
        side = 1.0 if plus else -1.0
        line.low_per_force = side
        if slips_by_friction(el, i):
            line.state, line.per_push, line.low_per_push = col.FRICTION, side * el.friction, el.friction
            line.low_at_0 = side * k * elastic_elongation(el, link, i, 0.0)
            left = el.ultimate[i] - side * link.plastic[i]
            line.high_at_0 = k * left if el.ultimate[i] > 0.0 else math.inf
        else:
            most = limit(el, i, plus, 0.0)
            line.state, line.constant = col.YIELDING, side * most
            line.low_at_0 = side * k * elastic_elongation(el, link, i, 0.0) - most
            line.high_at_0 = k * (el.ultimate[i] - link.plastic_sum[i])
    elif branch != col.OPEN:
        line.state, line.k, line.c = col.ELASTIC, k, el.damping[i]
        line.constant = k * elastic_elongation(el, link, i, 0.0)
        line.low_at_0, line.low_per_force, line.high_per_force = 0.0, 1.0, -1.0
        line.high_at_0 = limit(el, i, branch != col.MINUS, 0.0)
        if slips_by_friction(el, i):
            line.high_per_push = el.friction
        if branch == col.BOND:
            line.low_at_0, line.low_per_push = limit(el, i, False, 0.0), line.high_per_push
        elif branch == col.MINUS:
            line.low_per_force, line.high_per_force = -1.0, 1.0


@inline
def force_of(line, e, rate, push):
    """Force of a line, + where it pulls the point back against a positive elongation."""
    return line.constant + line.k * e + line.c * rate + line.per_push * push


@inline
def push_of(line, F, rate):
    """Push that loads the friction of the next line, and its rate; friction excludes a damper."""
    if line.bears_friction != 0 and F < 0.0:
        return -F, -line.k * rate
    return 0.0, 0.0


@inline
def margins_of(line, e, rate, F, push, push_rate):
    """Event margins of a line, positive while it is on its branch [N/kg].

    OPEN: neither pulled nor pushed by spring and damper. PLUS, MINUS: the force keeps its sign; it is below
    the limit. BOND: it is below either limit. SLIP: it does not unload; it has not ruptured.
    """
    state = line.state
    if state == col.ELASTIC:
        return (
            line.low_at_0 + line.low_per_force * F + line.low_per_push * push,
            line.high_at_0 + line.high_per_force * F + line.high_per_push * push,
        )
    k, c = line.stiffness, line.damping
    if state == col.SLACK:
        over, under = k * e - line.high_at_0, k * e - line.low_at_0
        return -min(over, over + c * rate), max(under, under + c * rate)
    side = line.low_per_force
    if state == col.FRICTION:
        slipped = line.low_at_0 + k * side * e - line.low_per_push * push
        back = SLIP_RATE_TIME * (k * side * rate - line.low_per_push * push_rate)
        return back, line.high_at_0 - slipped
    beyond = line.low_at_0 + k * side * e
    back = min(beyond, 0.0) + (c if c > 0.0 else k * SLIP_RATE_TIME) * side * rate
    return back, line.high_at_0 - max(beyond, 0.0)


@inline
def clipped(line, F, push):
    """Clip F to the range of forces of the line's branch; ``push`` may be infinite where it is not known.

    A force evaluated with the branch from before an impact, or just after the event, is outside it.
    """
    if line.state != col.ELASTIC:
        return F
    low, high = line.low_at_0, line.high_at_0
    if line.low_per_push != 0.0:
        low += line.low_per_push * push
    if line.high_per_push != 0.0:
        high += line.high_per_push * push
    if line.per_plus > 0.0:  # with interaction, neither pull nor shear alone exceeds its strength
        F = min(F, 1.0 / line.per_plus)
    if line.per_minus > 0.0:
        F = max(F, -1.0 / line.per_minus)
    if line.low_per_force < 0.0:  # MINUS: the force is below zero
        return min(low, max(-high, F))
    return min(high, max(-low, F))


@inline
def utilization_of(line, F):
    """Squared utilization (force/strength)² of a line; a push of the normal line counts as zero.

    It is zero where pull and shear do not interact.
    """
    used = F * (line.per_plus if F > 0.0 else line.per_minus)
    return used * used


@inner
def reset_branch(el, link, i):
    """Reset a line to its initial branch, BOND or OPEN, with no elongation."""
    bonded = el.slack_plus[i] + el.slack_minus[i] == 0.0
    link.branch[i] = col.BOND if bonded else col.OPEN
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
    link.branch[i] = col.BOND if bonded else (col.PLUS if plus else col.MINUS)


@inline
def note_force(device, i, F):
    """Update the peak force of a line."""
    if i == col.TANGENT:
        device.peak_shear = max(device.peak_shear, abs(F))
    elif F > 0.0:
        device.peak_pull = max(device.peak_pull, F)
    else:
        device.peak_push = max(device.peak_push, -F)


@inner
def fail(link, device, why, time):
    """Remove a failed device for the rest of the run."""
    link.lines = 0
    link.force[col.NORMAL] = link.force[col.TANGENT] = 0.0
    device.failure, device.failure_time = why, time


@inner
def _margins(el, link, i):
    """Event margins of a line in the state last evaluated."""
    line = link.law[i]
    set_law(line, el, link, i)
    F = force_of(line, link.e[i], link.rate[i], link.push)
    return margins_of(line, link.e[i], link.rate[i], F, link.push, link.push_rate)


@inner
def _reach_limit(el, link, device, i, plus, time):
    """Line at its limit: start slip if it is ductile or limited by friction, else fail."""
    if el.ultimate[i] > 0.0 or slips_by_friction(el, i):
        before = link.branch[i]
        link.branch[i] = col.SLIP_PLUS if plus else col.SLIP_MINUS
        # slip starts only if its own margin is positive: a line already unloading goes back at once
        back, _ = _margins(el, link, i)
        if back <= 0.0:
            link.branch[i] = before
            _end_slip(el, link, i, plus)
        return
    note_force(device, i, limit(el, i, True, link.push) if plus else -limit(el, i, False, link.push))
    if i == col.TANGENT:
        fail(link, device, col.SHEARED, time)
    else:
        fail(link, device, col.PULLED if plus else col.PUSHED, time)


@inner
def _update_line(el, link, device, i, time):
    """Update a line's branch for the elongation and rate last evaluated."""
    low, high = _margins(el, link, i)
    branch = link.branch[i]
    if branch in (col.SLIP_PLUS, col.SLIP_MINUS):
        if high < 0.0:
            fail(link, device, col.DROPPED_OUT if slips_by_friction(el, i) else col.DRAWN_OUT, time)
        elif low <= 0.0:
            _end_slip(el, link, i, branch == col.SLIP_PLUS)
        return
    if branch == col.OPEN:
        if low < 0.0:
            link.branch[i] = col.PLUS
        elif high < 0.0:
            link.branch[i] = col.MINUS
    elif branch != col.BOND and low < 0.0:
        if i == col.NORMAL and branch == col.MINUS and el.drops_out != 0:
            fail(link, device, col.DROPPED_OUT, time)
            return
        link.branch[i] = col.OPEN
    if link.branch[i] == col.OPEN:
        return
    set_law(link.law[i], el, link, i)
    F = force_of(link.law[i], link.e[i], link.rate[i], link.push)
    if limit(el, i, True, link.push) < F:
        _reach_limit(el, link, device, i, True, time)
    elif limit(el, i, False, link.push) < -F:
        _reach_limit(el, link, device, i, False, time)


@inner
def update_element(el, link, device, time):
    """Update the branches of an element; whether it has just failed."""
    of_pull = of_shear = 0.0
    i = 0
    while i < link.lines:
        _update_line(el, link, device, i, time)
        if i < link.lines:
            line = link.law[i]
            set_law(line, el, link, i)
            F = link.force[i] = force_of(line, link.e[i], link.rate[i], link.push)
            if i == col.NORMAL:
                link.push, link.push_rate = push_of(line, F, link.rate[i])
                of_pull = utilization_of(line, F)
            else:
                of_shear = utilization_of(line, F)
        i += 1
    if link.lines == 2 and of_pull + of_shear > 1.0:
        pull, shear = link.force[col.NORMAL], link.force[col.TANGENT]
        # a damper's force jumps in an impact: the peak recorded at failure is scaled back to the strength
        part = 1.0 / math.sqrt(of_pull + of_shear)
        note_force(device, col.NORMAL, part * pull if pull > 0.0 else pull)
        note_force(device, col.TANGENT, part * shear)
        fail(link, device, col.PULLED if of_pull >= of_shear else col.SHEARED, time)
    return link.lines == 0
