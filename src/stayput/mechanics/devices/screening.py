"""Step screening: elements whose event functions provably keep their sign within the step.

The forces of a line deviate from straight lines between the ends of a step by no more than a bound; a margin
larger than the bound at both ends cannot vanish inside, and the costly event search is skipped.
"""

from __future__ import annotations

from stayput.compiled import inline, inner
from stayput.mechanics.devices.branch_law import utilization_of
from stayput.mechanics.devices.columns import FRICTION, SLACK, YIELDING

PLACE_OFF, RATE_OFF = 4 / 27, 0.75
"""Largest deviation of a cubic, and of its slope, from the chord, per difference of end and chord slopes.

The maximum of u (1 − u)² on [0, 1] is 4/27.
"""


@inline
def _deviations(line, h):
    """Bounds on the deviation of spring and damper force from the chord within the step [N/kg]."""
    mean = (line.e - line.e0) / h
    start, end = line.rate0 - mean, line.rate - mean
    place = PLACE_OFF * h * (abs(start) + abs(end))
    return line.stiffness * place, line.damping * (RATE_OFF * abs(start + end))


@inline
def _distance_from_contact(line, e):
    """Distance of a slack line from pulling and from pushing, the lesser, as a force of its spring."""
    beyond = line.stiffness * e
    return min(line.high_at_0 - beyond, beyond - line.low_at_0)


@inline
def _max_utilization(line):
    """Upper bound of a line's squared utilization within the step."""
    high, low = max(line.force0, line.force) + line.deviation, min(line.force0, line.force) - line.deviation
    if line.tangent == 0:
        return utilization_of(line, max(0.0, high))
    return max(utilization_of(line, high), utilization_of(line, low))


@inline
def _keeps_sign(line, h, pressing):
    """Whether no margin of a line on its own can change sign; sets its deviation.

    ``pressing`` is the deviation of the push that limits its friction.
    """
    state = line.state
    if state in (YIELDING, FRICTION):
        line.deviation = 0.0
        return False
    spring, damper = _deviations(line, h)
    if state == SLACK:
        line.deviation = 0.0
        return min(_distance_from_contact(line, line.e0), _distance_from_contact(line, line.e)) > spring
    line.deviation = spring + damper
    # the friction limit deviates with the push
    return min(line.low0, line.low1, line.high0, line.high1) > line.deviation + line.high_per_push * pressing


@inner
def no_line_event(work, h):
    """Whether no line margin can change sign in a step whose both ends have been evaluated.

    The rows keep the bounds on how far their forces may exceed those at both ends.
    """
    none = True
    r = 0
    while r < work.lines:
        line = work.line[r]
        inactive = _keeps_sign(line, h, 0.0)
        line.inactive = inactive
        r += 1
        if r < work.lines and work.line[r].tangent != 0:
            beside = work.line[r]
            inactive = _keeps_sign(beside, h, line.deviation) and inactive
            if inactive and beside.interacts != 0:
                inactive = _max_utilization(line) + _max_utilization(beside) < 1.0
            line.inactive = beside.inactive = inactive
            r += 1
        none = none and inactive
    return none
