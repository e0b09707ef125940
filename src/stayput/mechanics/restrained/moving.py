"""A body with elements that moves: step by step to the next event, of the contacts or of the elements."""

from __future__ import annotations

import math

from stayput.compiled import inline, inner
from stayput.mechanics.columns import CLOSED, ENDED, FLIGHT, LIMIT, STICK, TURNED_OVER
from stayput.mechanics.geometry import HALF_TURN, along, arm_at, gap, note_peaks
from stayput.mechanics.motion import loads, note_sample, pass_time
from stayput.mechanics.restrained.elements import (
    begin_step,
    least_margin,
    note_forces_within,
    note_sample_forces,
    suspicious,
)
from stayput.mechanics.restrained.rates import accelerations
from stayput.mechanics.restrained.step import (
    STAGES,
    between,
    place_of_foot,
    quintics,
    set_state,
    state_of,
    take_step,
)
from stayput.mechanics.roots import closed_level, falls_inside, first_zero, narrowed, secant

SLACK_FORCE, SLACK_SLIP = 1e-8, 5e-11
"""A margin of the contacts that starts at its limit has passed it when it is this far beyond [m/s², m/s]."""

NEAR_LIMIT = 0.01
"""A margin smaller than this part of g at either end of a step is also looked at in its middle."""

SHORTEST = 1e-6
"""A step is not made shorter than this to keep within the tolerance [s]."""

LARGEST_TURN = 0.1
"""A step does not turn the body by more than about this [rad]."""

LOCATED = 1e-12
"""An event is located to this part of a second [s]."""


@inline
def _level(margin, slack):
    return 0.0 if margin > slack else min(margin, 0.0) - slack


@inner
def _least(elements, links, contacts, s, levels, f, g):
    """Least of all margins above their levels, in a state whose rates have just been worked out.

    ``s.hit`` gets the bits of the contacts that have closed. The record s holds the state.
    """
    least = min(f - levels[0], g - levels[1], HALF_TURN - abs(s.theta))
    s.hit = 0
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1:
            over = gap(contacts[c], s) - contacts[c].level
            if over < 0.0:
                s.hit |= 1 << c
            least = min(least, over)
        c += 1
    return min(least, least_margin(elements, links))


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
def _set_levels(contacts, s):
    """Set the gaps at which the other contacts close in the step that begins."""
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1:
            contacts[c].level = closed_level(gap(contacts[c], s))
        c += 1


@inner
def _first_gap(contacts, case, s, y0, k0, base, y1, k1, h):
    """Time of the first gap that closes within a step, or h."""
    first = h
    # no more than this a corner comes nearer to a plane and goes back again in the step
    reach = abs(case.u[0]) + abs(case.u[1]) + abs(case.v[0]) + abs(case.v[2])
    swing = h * (abs(y0[3]) + abs(y0[4]) + abs(y1[3]) + abs(y1[4]) + reach * (abs(y0[5]) + abs(y1[5])))
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1 and gap(contacts[c], s) < swing:
            con = contacts[c]
            g0, v0, c0 = _gap_now(con, y0, k0, base[1], base[2])
            g1, v1, c1 = _gap_now(con, y1, k1, s.sin, s.cos)
            t = first_zero(g0 - con.level, v0, c0, g1 - con.level, v1, c1, h)
            if t >= 0.0:
                first = min(first, t * (1.0 + 1e-6))
        c += 1
    return first


@inner
def _note_largest_tilt(s, y0, k0, y1, k1, h):
    """Keep the tilt where the rotation turns inside a step."""
    if y0[5] * y1[5] >= 0.0 or abs(y0[2]) + h * (abs(y0[5]) + abs(y1[5])) <= s.peak_tilt:
        return
    curves = quintics(y0, k0, y1, k1, h)
    t = h * y0[5] / (y0[5] - y1[5])
    for _ in range(2):
        rate, slope = between(curves, h, t)[5], (y1[5] - y0[5]) / h
        t = min(h, max(0.0, t - rate / slope))
    s.peak_tilt = max(s.peak_tilt, abs(between(curves, h, t)[2]))


@inline
def _next_length(h, error, tolerance):
    """Length of step that would have an error of the tolerance, with a margin, from one that has ``error``."""
    if 2048.0 * error <= tolerance:
        return 4.0 * h
    return h * min(4.0, max(0.2, 0.9 * math.exp(0.2 * math.log(tolerance / error))))


@inner
def _look_at(elements, links, contacts, rows, case, s, base, load, t, y):
    """Set the state to y; return its accelerations and the contacts' margins there, a time t into a step."""
    set_state(s, y, base)
    ax, az, alpha, f, g = accelerations(elements, links, contacts, rows, case, s, load, t)
    return (ax, az, alpha), f, g


@inner
def _margin_at(elements, links, contacts, rows, case, s, base, load, curves, h, t, levels):
    """Least margin a time t into a step, on its quintics."""
    y = between(curves, h, t)
    _, f, g = _look_at(elements, links, contacts, rows, case, s, base, load, t, y)
    return _least(elements, links, contacts, s, levels, f, g)


@inner
def _locate(elements, links, contacts, rows, case, s, base, load, curves, h, low, high, m_high, levels):
    """Time just after which the least margin falls below zero, between ``low`` and ``high``."""
    m_low = _margin_at(elements, links, contacts, rows, case, s, base, load, curves, h, low, levels)
    bracket = (low, max(m_low, SLACK_SLIP), high, m_high, 0)
    for _ in range(100):
        if bracket[2] - bracket[0] <= LOCATED:
            break
        t = secant(bracket[0], bracket[1], bracket[2], bracket[3])
        m = _margin_at(elements, links, contacts, rows, case, s, base, load, curves, h, t, levels)
        if m <= 0.0 and bracket[2] - t <= LOCATED:
            return t
        bracket = narrowed(bracket, t, m)
    return bracket[2]


@inner
def _first_event(elements, links, contacts, rows, case, s, base, load, start, end, least, near, h, levels):
    """Time of the first event in a step that has been taken to its end, or −1.

    ``start`` and ``end`` are states, accelerations and margins. Beside the end, places are looked at where
    gaps, and parabolas through the margins, say that one may be negative.
    """
    y0, k0, f0, g0 = start
    y1, k1, f1, g1 = end
    probe = min(_first_gap(contacts, case, s, y0, k0, base, y1, k1, h), suspicious(elements, links, h))
    if not near and probe >= h and least >= 0.0:
        return -1.0
    curves = quintics(y0, k0, y1, k1, h)
    if near:
        y = between(curves, h, 0.5 * h)
        _, f, g = _look_at(elements, links, contacts, rows, case, s, base, load, 0.5 * h, y)
        u = falls_inside(f0 - levels[0], f - levels[0], f1 - levels[0])
        if u > 0.0:
            probe = min(probe, u * h)
        u = falls_inside(g0 - levels[1], g - levels[1], g1 - levels[1])
        if u > 0.0:
            probe = min(probe, u * h)
    low = 0.0
    if probe < h:
        m = _margin_at(elements, links, contacts, rows, case, s, base, load, curves, h, probe, levels)
        if m < 0.0:
            return _locate(
                elements, links, contacts, rows, case, s, base, load, curves, h, low, probe, m, levels
            )
        low = probe
    if least < 0.0:
        return _locate(
            elements, links, contacts, rows, case, s, base, load, curves, h, low, h, least, levels
        )
    return -1.0


@inner
def _go_to(elements, links, contacts, rows, case, s, work, base, load, y0, levels, t, h):
    """Take the step that ends at an event, and a hair longer where the margin is not yet below zero there.

    Returns its length, the margins, and the least: negative, unless the event was one of the quintics alone.
    """
    least = f = g = 0.0
    more = LOCATED
    for _ in range(5):
        f, g, _ = take_step(elements, links, contacts, rows, case, s, work, base, load, y0, t)
        least = _least(elements, links, contacts, s, levels, f, g)
        if least < 0.0 or t >= h:
            break
        t, more = min(h, t + more), 30.0 * more
    return t, f, g, least


@inline
def _stage(work, i):
    return work.stage[i, 0], work.stage[i, 1], work.stage[i, 2]


@inline
def _keep_as_first(work, k):
    work.stage[0, 0], work.stage[0, 1], work.stage[0, 2] = k


@inline
def _why_over(s):
    if s.hit:
        return CLOSED
    return TURNED_OVER if abs(s.theta) >= HALF_TURN else LIMIT


@inner
def advance_moving(
    elements,
    links,
    devices,
    contacts,
    rows,
    case,
    s,
    work,
    ax,
    az,
    dt,
    tolerance,
    max_step,
    history,
    forces,
):
    """Move a body with elements in its mode to its next event.

    Parameters
    ----------
    tolerance : float
        Largest error of a step: of place, tilt, and the step's length times their rates [m, rad].
    max_step : float
        Longest step [s].

    Returns
    -------
    int
        ENDED, CLOSED (s.hit says which contacts), LIMIT (a force, a slip rate or an element) or TURNED_OVER.
    """
    last = ax.shape[0] - 1
    per_second = case.scale / dt
    if s.kind == STICK:
        work.foot = place_of_foot(contacts, s)
    slips = s.kind != STICK and s.kind != FLIGHT
    slack_f, slack_g = work.patience * SLACK_FORCE, work.patience * (SLACK_SLIP if slips else SLACK_FORCE)
    near_limit = NEAR_LIMIT * case.gravity
    base = s.theta, s.sin, s.cos
    load = loads(case, ax, az, per_second, s.k, s.tau)
    y0 = state_of(s)
    k0, f0, g0 = _look_at(elements, links, contacts, rows, case, s, base, load, 0.0, y0)
    why = ENDED
    while s.k < last and why == ENDED:
        base = s.theta, s.sin, s.cos
        load = loads(case, ax, az, per_second, s.k, s.tau)
        levels = _level(f0, slack_f), _level(g0, slack_g)
        _set_levels(contacts, s)
        begin_step(elements, links, work.patience)
        _keep_as_first(work, k0)
        whole = min(dt - s.tau, max_step)
        if abs(s.omega) * whole > LARGEST_TURN:
            whole = LARGEST_TURN / abs(s.omega)
        h = min(whole, work.longest)
        if h > 0.8 * whole:
            h = whole
        while True:
            f1, g1, error = take_step(elements, links, contacts, rows, case, s, work, base, load, y0, h)
            s.steps += 1
            proposed = _next_length(h, error, tolerance)
            if error <= tolerance or h <= SHORTEST:
                break
            h = work.longest = max(proposed, SHORTEST)
        work.longest = proposed if h < whole else max(proposed, work.longest)
        y1, k1 = state_of(s), _stage(work, STAGES - 1)
        least = _least(elements, links, contacts, s, levels, f1, g1)
        near = min(f0, f1) < near_limit or (not slips and min(g0, g1) < near_limit)
        start, end = (y0, k0, f0, g0), (y1, k1, f1, g1)
        t = _first_event(
            elements, links, contacts, rows, case, s, base, load, start, end, least, near, h, levels
        )
        if t >= 0.0:
            h, f1, g1, least = _go_to(
                elements, links, contacts, rows, case, s, work, base, load, y0, levels, t, h
            )
            y1, k1 = state_of(s), _stage(work, STAGES - 1)
            if least < 0.0:
                why = _why_over(s)
        elif near:
            k1, f1, g1 = _look_at(elements, links, contacts, rows, case, s, base, load, h, y1)
        _note_largest_tilt(s, y0, k0, y1, k1, h)
        note_forces_within(elements, links, devices, h)
        note_peaks(case, s)
        y0, k0, f0, g0 = y1, k1, f1, g1
        if pass_time(s, h, dt):
            note_sample(history, case, s)
            note_sample_forces(forces, links, s)
    s.alpha = k0[2]
    return why
