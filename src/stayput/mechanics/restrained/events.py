"""Where a step of a body with elements ends early: the first margin that falls below its level.

Margins are the gaps of open contacts, the forces and rates of slip of closed ones, those of the elements'
lines, and what is left of a right angle. A step is first taken whole. Where a margin is negative at its
end, or a quintic or a parabola says that it is on the way, the least of all margins is bracketed on the
quintics of the motion. These are as good as the step, so the state at the event is theirs.
"""

from __future__ import annotations

from stayput.compiled import inline, inner
from stayput.mechanics.columns import CONTACTS, STICK
from stayput.mechanics.geometry import HALF_TURN, along, arm_at, gap, sin_cos
from stayput.mechanics.restrained.acting import (
    least_weighed_line,
    set_line_weights,
    suspicious,
    weighed,
    weight_of,
)
from stayput.mechanics.restrained.step import (
    between,
    measure_here,
    meet_constraints,
    quintics,
    set_state,
)
from stayput.mechanics.roots import closed_level, falls_inside, first_zero, horner, narrowed, secant

NEARLY, LOCATED = 1e-10, 1e-12
"""An event is located to these parts of a second, in the search and where a margin must be below zero [s]."""

BEYOND = 1e-9
"""Least part of its value at the end that a margin is taken to have at the start of a search."""

F_WEIGHT, G_WEIGHT, TURN_WEIGHT = CONTACTS, CONTACTS + 1, CONTACTS + 2


@inline
def _gap(contacts, s, work, c):
    """Distance of a contact's corner from its plane [m]."""
    if s.kind == STICK:
        reach = work.reach[c]
        return reach[0] + (reach[1] * s.cos + reach[2] * s.sin)
    return gap(contacts[c], s)


@inline
def least_of_all(contacts, s, work, levels, f, g, least):
    """Least of all margins above their levels; ``least`` is the lines'.

    The state has just been measured. ``s.hit`` gets the bits of the contacts that have closed.
    """
    least = min(least, f - levels[0], g - levels[1], HALF_TURN - abs(s.theta))
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
    """Set the weights for a search that ends where `least_of_all` has just looked."""
    weight = work.weight
    weight[F_WEIGHT], weight[G_WEIGHT] = weight_of(f - levels[0]), weight_of(g - levels[1])
    weight[TURN_WEIGHT] = weight_of(HALF_TURN - abs(s.theta))
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        weight[c] = weight_of(work.gap[c] - work.level[c]) if others >> c & 1 else 0.0
        c += 1
    set_line_weights(work)


@inner
def _least_weighed(contacts, s, work, levels, f, g):
    """Least of the margins that were negative where a search ends, as parts of what they are there.

    Each falls from above zero to −1, so a search by secants is not misled by margins of other sizes.
    """
    weight = work.weight
    least = min(
        weighed(f - levels[0], weight[F_WEIGHT]),
        weighed(g - levels[1], weight[G_WEIGHT]),
        weighed(HALF_TURN - abs(s.theta), weight[TURN_WEIGHT]),
        least_weighed_line(work),
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
    """Keep the gaps of the open contacts in the state of s."""
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1:
            work.gap[c] = _gap(contacts, s, work, c)
        c += 1


@inline
def set_gap_levels(s, work):
    """Set the gaps at which the other contacts close in the step that begins."""
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1:
            work.level[c] = closed_level(work.gap[c])
        c += 1


@inline
def _gap_rates(contacts, s, work, c, y, k, sin, cos):
    """Gap of a contact in a state, with its first and second rate."""
    if s.kind == STICK:
        reach = work.reach[c]
        lever, fall = reach[2] * cos - reach[1] * sin, reach[1] * cos + reach[2] * sin
        return reach[0] + fall, y[5] * lever, k[2] * lever - y[5] * y[5] * fall
    con = contacts[c]
    sigma, kappa = arm_at(con, sin, cos)
    place, rate, fall = along(con, y[0], y[1])[1], along(con, y[3], y[4])[1], along(con, k[0], k[1])[1]
    return (
        place + con.offset - kappa,
        rate - y[5] * sigma,
        fall - k[2] * sigma + y[5] * y[5] * kappa,
    )


@inline
def swing_of(case, y0, y1, h):
    """No more than this a corner comes nearer to a plane and goes back again in a step [m]."""
    reach = abs(case.u[0]) + abs(case.u[1]) + abs(case.v[0]) + abs(case.v[2])
    return h * (abs(y0[3]) + abs(y0[4]) + abs(y1[3]) + abs(y1[4]) + reach * (abs(y0[5]) + abs(y1[5])))


@inline
def gaps_stay(s, work, swing):
    """Whether no gap can close in a step within which no corner swings farther than this."""
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1 and work.gap[c] < swing:
            return False
        c += 1
    return True


@inner
def _first_gap(contacts, s, work, y0, k0, base, y1, k1, swing, h):
    """Time of the first gap that closes within a step, or h."""
    first = h
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1 and work.gap[c] < swing:
            level = work.level[c]
            g0, v0, c0 = _gap_rates(contacts, s, work, c, y0, k0, base[1], base[2])
            g1, v1, c1 = _gap_rates(contacts, s, work, c, y1, k1, s.sin, s.cos)
            t = first_zero(g0 - level, v0, c0, g1 - level, v1, c1, h)
            if t >= 0.0:
                first = min(first, t + NEARLY)
        c += 1
    return first


@inner
def _look(contacts, rows, case, s, work, base, load, curves, h, t):
    """Go to a time t into a step, on its quintics; what `step.measure_here` tells of it."""
    if s.kind == STICK:
        s.theta, rate = horner(curves[2], t / h)
        s.omega = rate / h
        s.sin, s.cos = sin_cos(s.theta, base[0], base[1], base[2])
    else:
        set_state(s, between(curves, h, t), base)
    return measure_here(contacts, rows, case, s, work, load, t)


@inner
def _weighed_at(contacts, rows, case, s, work, base, load, curves, h, t, levels):
    """Least weighed margin a time t into a step, on its quintics."""
    _, f, g, _ = _look(contacts, rows, case, s, work, base, load, curves, h, t)
    return _least_weighed(contacts, s, work, levels, f, g)


@inner
def _negative_at(contacts, rows, case, s, work, base, load, curves, h, t, levels):
    """Whether a margin is negative a time t into a step, on its quintics; if so, the weights are set."""
    _, f, g, least = _look(contacts, rows, case, s, work, base, load, curves, h, t)
    if least_of_all(contacts, s, work, levels, f, g, least) >= 0.0:
        return False
    _set_weights(contacts, s, work, levels, f, g)
    return True


@inner
def _locate(contacts, rows, case, s, work, base, load, curves, h, low, high, levels):
    """Time about which a margin falls below zero that is negative at ``high``, where the weights were set."""
    last, f_last = high, -1.0
    if s.hit:  # the time of a gap is known as well already
        t = max(low, high - 2.0 * NEARLY)
        m = _weighed_at(contacts, rows, case, s, work, base, load, curves, h, t, levels)
        if m > 0.0:
            return high - NEARLY
        last, f_last = t, m
    m = _weighed_at(contacts, rows, case, s, work, base, load, curves, h, low, levels)
    bracket = (low, max(m, BEYOND), last, f_last, 0)
    for _ in range(100):
        t = secant(bracket[0], bracket[1], bracket[2], bracket[3])
        if abs(t - last) <= NEARLY or bracket[2] - bracket[0] <= NEARLY:
            return t
        m = _weighed_at(contacts, rows, case, s, work, base, load, curves, h, t, levels)
        bracket = narrowed(bracket, t, m)
        last = t
    return last


@inner
def _first_dip(contacts, rows, case, s, work, base, load, curves, f0, g0, f1, g1, h, levels):
    """Earliest time at which a parabola has a margin of the closed contacts below its level, or h."""
    _, f, g, _ = _look(contacts, rows, case, s, work, base, load, curves, h, 0.5 * h)
    u = falls_inside(f0 - levels[0], f - levels[0], f1 - levels[0])
    v = falls_inside(g0 - levels[1], g - levels[1], g1 - levels[1])
    return h * min(u if u > 0.0 else 1.0, v if v > 0.0 else 1.0)


@inner
def first_event(contacts, rows, case, s, work, base, load, start, end, least, near, calm, swing, h, levels):
    """Time of the first event in a step that has been taken to its end, or −1; whether it looked inside.

    ``start`` and ``end`` are states, accelerations and margins. Beside the end, places are looked at where
    gaps, and parabolas through the margins, say that one may be negative.
    """
    y0, k0, f0, g0 = start
    y1, k1, f1, g1 = end
    probe = _first_gap(contacts, s, work, y0, k0, base, y1, k1, swing, h)
    if not calm:
        probe = min(probe, suspicious(work, h))
    if not near and probe >= h and least >= 0.0:
        return -1.0, False
    curves = quintics(y0, k0, y1, k1, h)
    if near:
        dip = _first_dip(contacts, rows, case, s, work, base, load, curves, f0, g0, f1, g1, h, levels)
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
def go_to(contacts, rows, case, s, work, base, load, start, end, levels, t, h):
    """Set the state to that of an event in a step of length h, a hair later where no margin is below zero.

    It is that of the quintics, with the mode's constraints met. Returns its time, accelerations, the
    contacts' margins and the least of all: negative unless the event was one of the quintics alone.
    """
    curves = quintics(start[0], start[1], end[0], end[1], h)
    k, f, g, least = end[1], end[2], end[3], 0.0
    before, more = -1.0, LOCATED
    for _ in range(6):
        set_state(s, between(curves, h, t), base)
        meet_constraints(contacts, case, s, work)
        k, f, g, least = measure_here(contacts, rows, case, s, work, load, t)
        m = _least_weighed(contacts, s, work, levels, f, g)
        if m < 0.0 or t >= h:
            break
        more = LOCATED + (more * m / (before - m) if before > m else 10.0 * more)
        t, before = min(h, t + more), m
    return t, k, f, g, least_of_all(contacts, s, work, levels, f, g, least)
