"""Elements to which nothing happens in a step: their margins are farther off than their forces can swing."""

from __future__ import annotations

from stayput.compiled import inline, inner
from stayput.mechanics.restrained.columns import NORMAL, OPEN, SLIP_MINUS, SLIP_PLUS, TANGENT
from stayput.mechanics.restrained.lines import share, slips_by_friction

PLACE_OFF, RATE_OFF = 4 / 27, 0.75
"""A cubic is off the straight line between its ends by no more than these times the rates' differences."""


@inline
def _swings(el, link, i, h):
    """How far the forces of spring and of damper may be from straight lines between both ends [N/kg]."""
    mean = (link.e[i] - link.e0[i]) / h
    start, end = link.rate0[i] - mean, link.rate[i] - mean
    place = PLACE_OFF * h * (abs(start) + abs(end))
    return el.stiffness[i] * place, el.damping[i] * (RATE_OFF * abs(start + end))


@inline
def _away_from_slack(el, link, i, e):
    """Least distance of an open line from either slack, as a force of its spring."""
    k, beyond = el.stiffness[i], e - link.plastic[i]
    return min(k * (el.slack_plus[i] - beyond), k * (beyond + el.slack_minus[i]))


@inline
def _most_used(el, link, i):
    """Largest part that a line can use of the strength where pull and shear act together, squared."""
    F0, F1, swing = link.force0[i], link.force[i], link.swing[i]
    if i == NORMAL:
        return share(el, i, max(0.0, max(F0, F1) + swing))
    return max(share(el, i, max(F0, F1) + swing), share(el, i, min(F0, F1) - swing))


@inner
def none_stirs(elements, links, h):
    """Whether no margin of the elements can be passed in a step of which both ends have been measured.

    The links keep by how much their forces may be larger inside than at both ends.
    """
    none = True
    for n in range(elements.shape[0]):
        el, link = elements[n], links[n]
        calm = True
        pressing = 0.0
        for i in range(link.lines):
            branch = link.branch[i]
            if branch in (SLIP_PLUS, SLIP_MINUS):
                link.swing[i] = 0.0
                calm = False
                continue
            spring, damper = _swings(el, link, i, h)
            if branch == OPEN:
                link.swing[i] = 0.0
                away = min(
                    _away_from_slack(el, link, i, link.e0[i]), _away_from_slack(el, link, i, link.e[i])
                )
                calm = calm and away > spring
                continue
            swing = link.swing[i] = spring + damper
            if i == NORMAL:
                pressing = spring
            elif slips_by_friction(el, i):
                swing += el.friction * pressing
            least = min(min(link.low0[i], link.low1[i]), min(link.high0[i], link.high1[i]))
            calm = calm and least > swing
        if calm and link.lines == 2 and el.interaction != 0:
            calm = _most_used(el, link, NORMAL) + _most_used(el, link, TANGENT) < 1.0
        link.calm = 1 if calm else 0
        none = none and calm
    return none
