"""Step screening: elements whose event functions provably keep their sign within the step.

The forces of a line deviate from straight lines between the ends of a step by no more than a bound; a margin
larger than the bound at both ends cannot vanish inside, and the costly event search is skipped. The bound is
that of the cubic through elongation and rate at both ends; on a sticking fulcrum, where steps are long, what
the tilt deviates from a cubic is added.
"""

from __future__ import annotations

from stayput.compiling import inline, inner
from stayput.mechanics.devices.columns import FRICTION, SLACK, YIELDING
from stayput.mechanics.devices.device_law import SLIP_RATE_TIME, utilization_of

PLACE_OFF, RATE_OFF = 4 / 27, 0.75
"""Largest deviation of a cubic, and of its slope, from the chord, per difference of end and chord slopes.

The maximum of u (1 − u)² on [0, 1] is 4/27.
"""

RATE_PER_PLACE = 5.0
"""Bound of the rate's deviation from the cubic's, times h, per bound of the place's deviation from it."""


@inline
def _deviations(line, h, beyond):
    """Bounds on the deviation of elongation [m] and its rate [m/s] from the chord within the step."""
    mean = (line.e - line.e0) / h
    start, end = line.rate0 - mean, line.rate - mean
    place, rate = PLACE_OFF * h * (abs(start) + abs(end)), RATE_OFF * abs(start + end)
    if beyond == 0.0:
        return place, rate
    return place + line.reach * beyond, rate + line.reach * beyond * (RATE_PER_PLACE / h)


@inline
def _distance_from_contact(line, e):
    """Distance of a slack line from pulling and from pushing, the lesser, as a force of its spring."""
    over = line.stiffness * e
    return min(line.high_at_0 - over, over - line.low_at_0)


@inline
def _max_utilization(line):
    """Upper bound of a line's squared utilization within the step."""
    high, low = max(line.force0, line.force) + line.deviation, min(line.force0, line.force) - line.deviation
    if line.tangent == 0:
        return utilization_of(line, max(0.0, high))
    return max(utilization_of(line, high), utilization_of(line, low))


@inline
def _keeps_sign(line, h, beyond, pressing, pressing_rate):
    """Whether no margin of a line on its own can change sign; sets its deviation.

    ``pressing`` is the deviation of the push that limits its friction, ``pressing_rate`` that of its rate.
    """
    line.deviation = 0.0
    if line.reach == 0.0:  # the point is the fulcrum
        return True
    place, rate = _deviations(line, h, beyond)
    state, k = line.state, line.stiffness
    if state == SLACK:
        return min(_distance_from_contact(line, line.e0), _distance_from_contact(line, line.e)) > k * place
    least = min(line.low0, line.low1)
    if state == FRICTION:
        left = min(line.high0, line.high1)
        return (
            least > SLIP_RATE_TIME * (k * rate + line.low_per_push * pressing_rate)
            and left > k * place + line.low_per_push * pressing
        )
    if state == YIELDING:
        side, damping = line.low_per_force, max(line.damping, k * SLIP_RATE_TIME)
        back = min(line.low_at_0 + k * side * line.e0, line.low_at_0 + k * side * line.e, 0.0)
        back += damping * (min(side * line.rate0, side * line.rate) - rate)
        return back > k * place and min(line.high0, line.high1) > k * place
    line.deviation = k * place + line.damping * rate
    # the friction limit deviates with the push
    return min(least, line.high0, line.high1) > line.deviation + line.high_per_push * pressing


@inner
def no_line_event(work, h, beyond):
    """Whether no line margin can change sign in a step whose both ends have been evaluated; and a bound.

    That is the sum of how far the forces may exceed those at both ends [N/kg]; the rows keep each.

    Parameters
    ----------
    beyond : float
        Bound on the deviation of the tilt from the cubic through its values and rates at both ends [rad].
    """
    none, whole = True, 0.0
    r = 0
    while r < work.lines:
        line = work.line[r]
        inactive = _keeps_sign(line, h, beyond, 0.0, 0.0)
        line.inactive = inactive
        r += 1
        if r < work.lines and work.line[r].tangent != 0:
            beside = work.line[r]
            rate = 0.0
            if beside.state == FRICTION:
                _, rate = _deviations(line, h, beyond)
            inactive = _keeps_sign(beside, h, beyond, line.deviation, line.k * rate) and inactive
            if inactive and beside.interacts != 0:
                inactive = _max_utilization(line) + _max_utilization(beside) < 1.0
            line.inactive = beside.inactive = inactive
            r += 1
            whole += beside.deviation
        none, whole = none and inactive, whole + line.deviation
    return none, whole
