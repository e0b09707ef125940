"""Where a step of a body with elements ends early: the first margin that falls below its level.

Margins are the gaps of open contacts, the forces and rates of slip of closed ones, those of the elements'
branches, and what is left of a right angle. A step is first taken whole. Where a margin is negative at its
end, or a quintic or a parabola says that it is on the way, the least of all margins is bracketed on the
quintics of the motion, and the step is taken again to that time.
"""

from __future__ import annotations

from stayput.compiled import inline, inner
from stayput.mechanics.columns import CONTACTS
from stayput.mechanics.geometry import HALF_TURN, along, arm_at, gap
from stayput.mechanics.restrained.calm import none_stirs
from stayput.mechanics.restrained.elements import (
    least_margin,
    least_weighed_margin,
    note_margins,
    suspicious,
    weighed,
    weight_of,
)
from stayput.mechanics.restrained.rates import accelerations
from stayput.mechanics.restrained.step import between, quintics, set_state, take_step
from stayput.mechanics.roots import closed_level, falls_inside, first_zero, narrowed, secant

NEARLY, LOCATED = 1e-10, 1e-12
"""An event is located to these parts of a second, on the quintics and by steps [s]."""

BEYOND = 1e-9
"""Least part of its value at the end that a margin is taken to have at the start of a search."""

F_WEIGHT, G_WEIGHT, TURN_WEIGHT = CONTACTS, CONTACTS + 1, CONTACTS + 2


@inline
def level_of(margin, slack):
    """Value at which a margin counts as passed in a step that starts with it; see `roots.closed_level`."""
    return 0.0 if margin > slack else min(margin, 0.0) - slack


@inner
def least_of_all(elements, links, contacts, s, work, levels, f, g):
    """Least of all margins above their levels, in a state whose accelerations have just been worked out.

    ``s.hit`` gets the bits of the contacts that have closed. The weights are set for a search that ends here.
    """
    force, slip, turn = f - levels[0], g - levels[1], HALF_TURN - abs(s.theta)
    weight = work.weight
    weight[F_WEIGHT], weight[G_WEIGHT], weight[TURN_WEIGHT] = (
        weight_of(force),
        weight_of(slip),
        weight_of(turn),
    )
    least = min(force, slip, turn)
    s.hit = 0
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        weight[c] = 0.0
        if others >> c & 1:
            work.gap[c] = gap(contacts[c], s)
            over = work.gap[c] - contacts[c].level
            weight[c] = weight_of(over)
            if over < 0.0:
                s.hit |= 1 << c
            least = min(least, over)
        c += 1
    return min(least, least_margin(elements, links))


@inner
def _least_weighed(elements, links, contacts, s, work, levels, f, g):
    """Least of the margins that were negative where a search ends, as parts of what they are there.

    Each falls from above zero to −1, so a search by secants is not misled by margins of other sizes.
    """
    weight = work.weight
    least = min(
        weighed(f - levels[0], weight[F_WEIGHT]),
        weighed(g - levels[1], weight[G_WEIGHT]),
        weighed(HALF_TURN - abs(s.theta), weight[TURN_WEIGHT]),
    )
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1 and weight[c] > 0.0:
            least = min(least, weight[c] * (gap(contacts[c], s) - contacts[c].level))
        c += 1
    return min(least, least_weighed_margin(elements, links))


@inline
def _gap_now(con, y, k, sin, cos):
    """Gap of a contact in a state, with its first and second rate."""
    sigma, kappa = arm_at(con, sin, cos)
    place, rate, fall = along(con, y[0], y[1])[1], along(con, y[3], y[4])[1], along(con, k[0], k[1])[1]
    return (
        place + con.offset - kappa,
        rate - y[5] * sigma,
        fall - k[2] * sigma + y[5] * y[5] * kappa,
    )


@inner
def note_all(elements, links, contacts, s, work):
    """Keep the gaps and the elements' margins at the place last looked at."""
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1:
            work.gap[c] = gap(contacts[c], s)
        c += 1
    note_margins(elements, links)


@inner
def set_gap_levels(contacts, s, work):
    """Set the gaps at which the other contacts close in the step that begins."""
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1:
            contacts[c].level = closed_level(work.gap[c])
        c += 1


@inner
def _first_gap(contacts, case, s, work, y0, k0, base, y1, k1, h):
    """Time of the first gap that closes within a step, or h."""
    first = h
    # no more than this a corner comes nearer to a plane and goes back again in the step
    reach = abs(case.u[0]) + abs(case.u[1]) + abs(case.v[0]) + abs(case.v[2])
    swing = h * (abs(y0[3]) + abs(y0[4]) + abs(y1[3]) + abs(y1[4]) + reach * (abs(y0[5]) + abs(y1[5])))
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1 and work.gap[c] < swing:
            con = contacts[c]
            g0, v0, c0 = _gap_now(con, y0, k0, base[1], base[2])
            g1, v1, c1 = _gap_now(con, y1, k1, s.sin, s.cos)
            t = first_zero(g0 - con.level, v0, c0, g1 - con.level, v1, c1, h)
            if t >= 0.0:
                first = min(first, t * (1.0 + 1e-6))
        c += 1
    return first


@inner
def look_at(elements, links, contacts, rows, case, s, base, load, t, y):
    """Set the state to y; return its accelerations and the contacts' margins there, a time t into a step."""
    set_state(s, y, base)
    ax, az, alpha, f, g = accelerations(elements, links, contacts, rows, case, s, load, t)
    return (ax, az, alpha), f, g


@inner
def _margin_at(elements, links, contacts, rows, case, s, work, base, load, curves, h, t, levels, weighs):
    """Least margin a time t into a step, on its quintics: of all, or weighed."""
    y = between(curves, h, t)
    _, f, g = look_at(elements, links, contacts, rows, case, s, base, load, t, y)
    if weighs:
        return _least_weighed(elements, links, contacts, s, work, levels, f, g)
    return least_of_all(elements, links, contacts, s, work, levels, f, g)


@inner
def _locate(elements, links, contacts, rows, case, s, work, base, load, curves, h, low, high, levels):
    """Time about which a margin falls below zero that is negative at ``high``, on the quintics."""
    _margin_at(elements, links, contacts, rows, case, s, work, base, load, curves, h, high, levels, False)
    m = _margin_at(elements, links, contacts, rows, case, s, work, base, load, curves, h, low, levels, True)
    bracket = (low, max(m, BEYOND), high, -1.0, 0)
    last = high
    for _ in range(100):
        t = secant(bracket[0], bracket[1], bracket[2], bracket[3])
        if abs(t - last) <= NEARLY or bracket[2] - bracket[0] <= NEARLY:
            return t
        m = _margin_at(elements, links, contacts, rows, case, s, work, base, load, curves, h, t, levels, True)
        bracket = narrowed(bracket, t, m)
        last = t
    return last


@inner
def first_event(
    elements, links, contacts, rows, case, s, work, base, load, start, end, least, near, h, levels
):
    """Time of the first event in a step that has been taken to its end, or −1; whether it looked inside.

    ``start`` and ``end`` are states, accelerations and margins. Beside the end, places are looked at where
    gaps, and parabolas through the margins, say that one may be negative.
    """
    y0, k0, f0, g0 = start
    y1, k1, f1, g1 = end
    probe = _first_gap(contacts, case, s, work, y0, k0, base, y1, k1, h)
    if not none_stirs(elements, links, h):
        probe = min(probe, suspicious(elements, links, h))
    if not near and probe >= h and least >= 0.0:
        return -1.0, False
    curves = quintics(y0, k0, y1, k1, h)
    if near:
        y = between(curves, h, 0.5 * h)
        _, f, g = look_at(elements, links, contacts, rows, case, s, base, load, 0.5 * h, y)
        u = falls_inside(f0 - levels[0], f - levels[0], f1 - levels[0])
        if u > 0.0:
            probe = min(probe, u * h)
        u = falls_inside(g0 - levels[1], g - levels[1], g1 - levels[1])
        if u > 0.0:
            probe = min(probe, u * h)
    low = 0.0
    if probe < h:
        m = _margin_at(
            elements, links, contacts, rows, case, s, work, base, load, curves, h, probe, levels, False
        )
        if m < 0.0:
            t = _locate(
                elements, links, contacts, rows, case, s, work, base, load, curves, h, low, probe, levels
            )
            return t, True
        low = probe
    if least >= 0.0:
        return -1.0, True
    t = _locate(elements, links, contacts, rows, case, s, work, base, load, curves, h, low, h, levels)
    return t, True


@inner
def go_to(elements, links, contacts, rows, case, s, work, base, load, y0, levels, t, h):
    """Take the step that ends at an event, and a hair longer where the margin is not yet below zero there.

    Returns its length, the margins, and the least: negative, unless the event was one of the quintics alone.
    """
    f = g = 0.0
    before, more = -1.0, LOCATED
    for _ in range(6):
        f, g, _ = take_step(elements, links, contacts, rows, case, s, work, base, load, y0, t)
        m = _least_weighed(elements, links, contacts, s, work, levels, f, g)
        if m < 0.0 or t >= h:
            break
        more = LOCATED + (more * m / (before - m) if before > m else 10.0 * more)
        t, before = min(h, t + more), m
    return t, f, g, least_of_all(elements, links, contacts, s, work, levels, f, g)
