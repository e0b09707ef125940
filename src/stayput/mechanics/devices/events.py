"""Event detection within a step of a body with elements: the first margin that crosses its level.

Margins are the gaps of open contacts, the forces and slip rates of closed ones, those of the elements' lines,
and the rotation left to 90°. A step is first taken whole. Where a margin is negative at its end, or a quintic
or parabola suggests that it is negative inside, the least of the margins is bracketed on the dense output.
That is as accurate as the step, so it also provides the state at the event.
"""

from __future__ import annotations

from stayput.compiled import inline, inner
from stayput.mechanics.columns import CONTACTS, ROCK
from stayput.mechanics.devices.active_elements import (
    event_weight,
    first_crossing_candidate,
    least_weighted_line,
    set_line_weights,
    weighted_margin,
)
from stayput.mechanics.devices.moment import tilt_at
from stayput.mechanics.devices.step import (
    between,
    evaluate_state,
    project_on_constraints,
    quintics,
    set_state,
)
from stayput.mechanics.geometry import RIGHT_ANGLE, arm_at, gap, sin_cos, to_plane_axes
from stayput.mechanics.roots import (
    MIN_START_VALUE,
    closed_level,
    first_zero,
    illinois_update,
    parabola_negative_at,
    secant,
)

SEARCH_TOLERANCE, LOCATED = 1e-10, 1e-12
"""Tolerance of the event search, and least advance beyond it to where a margin is negative [s]."""

F_WEIGHT, G_WEIGHT, TURN_WEIGHT = CONTACTS, CONTACTS + 1, CONTACTS + 2


@inline
def _gap(contacts, s, work, c):
    """Gap of a contact [m]; on a sticking fulcrum a function of the tilt alone."""
    if s.kind == ROCK:
        reach = work.reach[c]
        return reach[0] + (reach[1] * s.cos + reach[2] * s.sin)
    return gap(contacts[c], s)


@inline
def least_margin(contacts, s, work, levels, f, g, least):
    """Least of all margins above their levels; ``least`` is that of the lines.

    The state has just been evaluated. ``s.hit`` gets the bits of the contacts that have closed.
    """
    least = min(least, f - levels[0], g - levels[1], RIGHT_ANGLE - abs(s.theta))
    s.hit = 0
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1:
            work.gap[c] = _gap(contacts, s, work, c)
            over = work.gap[c] - work.level[c]
            if over < 0.0:
                s.hit |= 1 << c
            least = min(least, over)
        c += 1
    return least


@inner
def _set_weights(contacts, s, work, levels, f, g):
    """Set the scales for a search that ends where `least_margin` has just been evaluated."""
    weight = work.weight
    weight[F_WEIGHT], weight[G_WEIGHT] = event_weight(f - levels[0]), event_weight(g - levels[1])
    weight[TURN_WEIGHT] = event_weight(RIGHT_ANGLE - abs(s.theta))
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        weight[c] = event_weight(work.gap[c] - work.level[c]) if others >> c & 1 else 0.0
        c += 1
    set_line_weights(work)


@inner
def _least_weighted(contacts, s, work, levels, f, g):
    """Least of the margins that are negative at the end of a search, each scaled to −1 there.

    Scaling makes gaps, forces and rates comparable, so that margins of other sizes do not mislead the
    secants.
    """
    weight = work.weight
    least = min(
        weighted_margin(f - levels[0], weight[F_WEIGHT]),
        weighted_margin(g - levels[1], weight[G_WEIGHT]),
        weighted_margin(RIGHT_ANGLE - abs(s.theta), weight[TURN_WEIGHT]),
        least_weighted_line(work),
    )
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1 and weight[c] > 0.0:
            least = min(least, weight[c] * (_gap(contacts, s, work, c) - work.level[c]))
        c += 1
    return least


@inner
def note_gaps(contacts, s, work):
    """Store the gaps of the open contacts in the state of s."""
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1:
            work.gap[c] = _gap(contacts, s, work, c)
        c += 1


@inline
def set_gap_levels(s, work):
    """Set the gaps at which the open contacts close in the step that begins."""
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1:
            work.level[c] = closed_level(work.gap[c])
        c += 1


@inline
def _gap_rates(contacts, s, work, c, y, k, sin, cos):
    """Gap of a contact in a state, with its first and second derivatives."""
    if s.kind == ROCK:
        reach = work.reach[c]
        lever, fall = reach[2] * cos - reach[1] * sin, reach[1] * cos + reach[2] * sin
        return reach[0] + fall, y[5] * lever, k[2] * lever - y[5] * y[5] * fall
    con = contacts[c]
    sigma, kappa = arm_at(con, sin, cos)
    place, rate, fall = (
        to_plane_axes(con, y[0], y[1])[1],
        to_plane_axes(con, y[3], y[4])[1],
        to_plane_axes(con, k[0], k[1])[1],
    )
    return (
        place + con.offset - kappa,
        rate - y[5] * sigma,
        fall - k[2] * sigma + y[5] * y[5] * kappa,
    )


@inline
def excursion_bound(case, y0, y1, h):
    """Upper bound of the distance by which a corner can approach a plane and return in a step [m]."""
    reach = abs(case.u[0]) + abs(case.u[1]) + abs(case.v[0]) + abs(case.v[2])
    return h * (abs(y0[3]) + abs(y0[4]) + abs(y1[3]) + abs(y1[4]) + reach * (abs(y0[5]) + abs(y1[5])))


@inline
def gaps_stay_open(s, work, excursion):
    """Whether no gap can close in a step within which corners move no farther than ``excursion``."""
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1 and work.gap[c] < excursion:
            return False
        c += 1
    return True


@inner
def _first_gap_candidate(contacts, s, work, y0, k0, base, y1, k1, excursion, h):
    """Earliest time at which a gap closes within a step, or h."""
    first = h
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1 and work.gap[c] < excursion:
            level = work.level[c]
            g0, v0, c0 = _gap_rates(contacts, s, work, c, y0, k0, base[1], base[2])
            g1, v1, c1 = _gap_rates(contacts, s, work, c, y1, k1, s.sin, s.cos)
            t = first_zero(g0 - level, v0, c0, g1 - level, v1, c1, h)
            if t >= 0.0:
                first = min(first, t + SEARCH_TOLERANCE)
        c += 1
    return first


@inner
def _evaluate_inside(contacts, rows, case, s, work, base, load, curves, h, t):
    """Set the state to a time t into a step, by its dense output; return `step.evaluate_state` there."""
    if s.kind == ROCK:
        s.theta, s.omega = tilt_at(work, t)
        s.sin, s.cos = sin_cos(s.theta, base[0], base[1], base[2])
    else:
        set_state(s, between(curves, h, t), base)
    return evaluate_state(contacts, rows, case, s, work, load, t)


@inner
def _least_weighted_at(contacts, rows, case, s, work, base, load, curves, h, t, levels):
    """Least scaled margin a time t into a step, by its dense output."""
    _, f, g, _ = _evaluate_inside(contacts, rows, case, s, work, base, load, curves, h, t)
    return _least_weighted(contacts, s, work, levels, f, g)


@inner
def _negative_at(contacts, rows, case, s, work, base, load, curves, h, t, levels):
    """Whether a margin is negative a time t into a step, by its dense output; if so, set the scales."""
    _, f, g, least = _evaluate_inside(contacts, rows, case, s, work, base, load, curves, h, t)
    if least_margin(contacts, s, work, levels, f, g, least) >= 0.0:
        return False
    _set_weights(contacts, s, work, levels, f, g)
    return True


@inner
def _locate(contacts, rows, case, s, work, base, load, curves, h, low, high, levels):
    """Time of the first crossing before ``high``, where a margin is negative and the scales were set."""
    last, f_last = high, -1.0
    if s.hit:  # the closing time of a gap is already this accurate: confirm it before searching
        t = max(low, high - 2.0 * SEARCH_TOLERANCE)
        m = _least_weighted_at(contacts, rows, case, s, work, base, load, curves, h, t, levels)
        if m > 0.0:
            return high - SEARCH_TOLERANCE
        last, f_last = t, m
    m = _least_weighted_at(contacts, rows, case, s, work, base, load, curves, h, low, levels)
    bracket = (low, max(m, MIN_START_VALUE), last, f_last, 0)
    for _ in range(100):
        t = secant(bracket[0], bracket[1], bracket[2], bracket[3])
        if abs(t - last) <= SEARCH_TOLERANCE or bracket[2] - bracket[0] <= SEARCH_TOLERANCE:
            return t
        m = _least_weighted_at(contacts, rows, case, s, work, base, load, curves, h, t, levels)
        bracket = illinois_update(bracket, t, m)
        last = t
    return last


@inner
def _first_margin_candidate(contacts, rows, case, s, work, base, load, curves, f0, g0, f1, g1, h, levels):
    """Earliest time at which a parabola has a margin of the closed contacts below its level, or h."""
    _, f, g, _ = _evaluate_inside(contacts, rows, case, s, work, base, load, curves, h, 0.5 * h)
    u = parabola_negative_at(f0 - levels[0], f - levels[0], f1 - levels[0])
    v = parabola_negative_at(g0 - levels[1], g - levels[1], g1 - levels[1])
    return h * min(u if u > 0.0 else 1.0, v if v > 0.0 else 1.0)


@inner
def first_event(
    contacts, rows, case, s, work, base, load, start, end, least, near, inactive, excursion, h, levels
):
    """Time of the first event in a completed step, or −1; and whether the state was moved inside the step.

    ``start`` and ``end`` are (state, accelerations, two margins). The search covers, in order: the earliest
    candidate inside the step (closing gaps, parabolas through the margins), then the end of the step.
    """
    y0, k0, f0, g0 = start
    y1, k1, f1, g1 = end
    probe = _first_gap_candidate(contacts, s, work, y0, k0, base, y1, k1, excursion, h)
    if not inactive:
        probe = min(probe, first_crossing_candidate(work, h))
    if not near and probe >= h and least >= 0.0:
        return -1.0, False
    curves = quintics(y0, k0, y1, k1, h)
    if near:
        dip = _first_margin_candidate(
            contacts, rows, case, s, work, base, load, curves, f0, g0, f1, g1, h, levels
        )
        probe = min(probe, dip)
    low = 0.0
    if probe < h:
        if _negative_at(contacts, rows, case, s, work, base, load, curves, h, probe, levels):
            t = _locate(contacts, rows, case, s, work, base, load, curves, h, 0.0, probe, levels)
            return t, True
        low = probe
    if least >= 0.0:
        return -1.0, True
    _negative_at(contacts, rows, case, s, work, base, load, curves, h, h, levels)
    return _locate(contacts, rows, case, s, work, base, load, curves, h, low, h, levels), True


@inner
def move_to_event(contacts, rows, case, s, work, base, load, start, end, levels, t, h):
    """Set the state to an event at t in a step of length h, slightly later if no margin is negative yet.

    It is that of the dense output, projected onto the mode's constraints. Returns the time, accelerations,
    the contacts' margins and the least of all: negative, unless the dense output alone had an event.
    """
    curves = quintics(start[0], start[1], end[0], end[1], h)
    k, f, g, least = end[1], end[2], end[3], 0.0
    before, more = -1.0, LOCATED
    for _ in range(6):
        if s.kind == ROCK:
            s.theta, s.omega = tilt_at(work, t)
            s.sin, s.cos = sin_cos(s.theta, base[0], base[1], base[2])
        else:
            set_state(s, between(curves, h, t), base)
        project_on_constraints(contacts, case, s, work)
        k, f, g, least = evaluate_state(contacts, rows, case, s, work, load, t)
        m = _least_weighted(contacts, s, work, levels, f, g)
        if m < 0.0 or t >= h:
            break
        more = LOCATED + (more * m / (before - m) if before > m else 10.0 * more)
        t, before = min(h, t + more), m
    return t, k, f, g, least_margin(contacts, s, work, levels, f, g, least)
