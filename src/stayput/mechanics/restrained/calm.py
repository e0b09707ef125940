"""Lines to which nothing happens in a step: their margins are farther off than their forces can swing."""

from __future__ import annotations

from stayput.compiled import inline, inner
from stayput.mechanics.restrained.columns import RUBBING, SLACK, SLIPPING
from stayput.mechanics.restrained.laws import used_of

PLACE_OFF, RATE_OFF = 4 / 27, 0.75
"""A cubic is off the straight line between its ends by no more than these times the rates' differences."""


@inline
def _swings(line, h):
    """How far the forces of spring and of damper may be from straight lines between both ends [N/kg]."""
    mean = (line.e - line.e0) / h
    start, end = line.rate0 - mean, line.rate - mean
    place = PLACE_OFF * h * (abs(start) + abs(end))
    return line.stiffness * place, line.damping * (RATE_OFF * abs(start + end))


@inline
def _away_from_slack(line, e):
    """Least distance of a slack line from pulling and from pushing, as a force of its spring."""
    beyond = line.stiffness * e
    return min(line.high_at_0 - beyond, beyond - line.low_at_0)


@inline
def _most_used(line):
    """Largest part that a line can use of the strength where pull and shear act together, squared."""
    high, low = max(line.force0, line.force) + line.swing, min(line.force0, line.force) - line.swing
    if line.tangent == 0:
        return used_of(line, max(0.0, high))
    return max(used_of(line, high), used_of(line, low))


@inline
def _is_calm(line, h, pressing):
    """Whether no margin of a line alone can be passed; the swings are set. ``pressing`` is the push's."""
    state = line.state
    if state in (SLIPPING, RUBBING):
        line.swing = 0.0
        return False
    spring, damper = _swings(line, h)
    if state == SLACK:
        line.swing = 0.0
        return min(_away_from_slack(line, line.e0), _away_from_slack(line, line.e)) > spring
    line.swing = spring + damper
    # friction's limit swings with the push
    return min(line.low0, line.low1, line.high0, line.high1) > line.swing + line.high_rubs * pressing


@inner
def none_stirs(work, h):
    """Whether no margin can be passed in a step of which both ends have been measured.

    The rows keep by how much their forces may be larger inside than at both ends.
    """
    none = True
    r = 0
    while r < work.lines:
        line = work.line[r]
        calm = _is_calm(line, h, 0.0)
        line.calm = calm
        r += 1
        if r < work.lines and work.line[r].tangent != 0:
            beside = work.line[r]
            calm = _is_calm(beside, h, line.swing) and calm
            if calm and beside.joins != 0:
                calm = _most_used(line) + _most_used(beside) < 1.0
            line.calm = beside.calm = calm
            r += 1
        none = none and calm
    return none
