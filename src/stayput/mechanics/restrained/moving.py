"""A body with elements that moves: step by step to the next event, of the contacts or of the elements."""

from __future__ import annotations

import math

from stayput.compiled import inline, inner
from stayput.mechanics.columns import CLOSED, ENDED, FLIGHT, LIMIT, STICK, TURNED_OVER
from stayput.mechanics.geometry import HALF_TURN, note_peaks
from stayput.mechanics.motion import loads, note_sample, pass_time
from stayput.mechanics.restrained.acting import (
    SLACK_FORCE,
    begin_step,
    level_of,
    note_forces_within,
    note_sample_forces,
)
from stayput.mechanics.restrained.calm import none_stirs
from stayput.mechanics.restrained.events import (
    first_event,
    gaps_stay,
    go_to,
    least_of_all,
    note_gaps,
    set_gap_levels,
    swing_of,
)
from stayput.mechanics.restrained.fulcrum_step import set_about_fulcrum
from stayput.mechanics.restrained.laws import set_lines
from stayput.mechanics.restrained.step import (
    measure_here,
    set_state,
    state_of,
    take_step,
)
from stayput.mechanics.roots import hermite, horner

SLACK_SLIP = 5e-11
"""A rate of slip that starts at its limit has passed it when it is this far beyond [m/s]; see SLACK_FORCE."""

STILL = 1e-9
"""A corner that slips, and a body that moves, no faster than this stands still [m/s]."""

NEAR_LIMIT = 0.01
"""A margin smaller than this part of g at either end of a step is also looked at in its middle."""

SHORTEST = 1e-6
"""A step is not made shorter than this to keep within the tolerance [s]."""

LARGEST_TURN = 0.1
"""A step does not turn the body by more than about this [rad]."""


@inner
def _largest_tilt(theta0, omega0, alpha0, theta1, omega1, alpha1, h):
    """Tilt where the rotation turns inside a step, on its quintic."""
    curve = hermite(theta0, omega0, alpha0, theta1, omega1, alpha1, h)
    u, slope = omega0 / (omega0 - omega1), h * (omega1 - omega0)
    for _ in range(2):
        u = min(1.0, max(0.0, u - horner(curve, u)[1] / slope))
    return abs(horner(curve, u)[0])


@inline
def _next_length(h, error, tolerance):
    """Length of a step that stays within the tolerance, from one of length h that has ``error``."""
    if 2048.0 * error <= tolerance:
        return 4.0 * h
    return h * min(4.0, max(0.2, 0.9 * math.exp(0.2 * math.log(tolerance / error))))


@inline
def _why_over(s):
    if s.hit:
        return CLOSED
    return TURNED_OVER if abs(s.theta) >= HALF_TURN else LIMIT


@inner
def _set_laws(elements, links, contacts, case, s, work):
    if s.kind == STICK:
        set_about_fulcrum(elements, links, contacts, case, s, work)
    else:
        set_lines(elements, links, case, -1, 0.0, 0.0, work)


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
    slips = s.kind != STICK and s.kind != FLIGHT
    slack_f, slack_g = work.patience * SLACK_FORCE, work.patience * (SLACK_SLIP if slips else SLACK_FORCE)
    near_limit = NEAR_LIMIT * case.gravity
    _set_laws(elements, links, contacts, case, s, work)
    load = loads(case, ax, az, per_second, s.k, s.tau)
    y0 = state_of(s)
    k0, f0, g0, _ = measure_here(contacts, rows, case, s, work, load, 0.0)
    note_gaps(contacts, s, work)
    why = ENDED
    while s.k < last and why == ENDED:
        base = s.theta, s.sin, s.cos
        load = loads(case, ax, az, per_second, s.k, s.tau)
        levels = level_of(f0, slack_f), level_of(g0, slack_g)
        set_gap_levels(s, work)
        begin_step(work)
        whole = min(dt - s.tau, max_step)
        if abs(s.omega) * whole > LARGEST_TURN:
            whole = LARGEST_TURN / abs(s.omega)
        h = min(whole, work.longest)
        if h > 0.8 * whole:
            h = whole
        while True:
            k1, f1, g1, least, error = take_step(contacts, rows, case, s, work, base, load, y0, k0, h)
            s.steps += 1
            if error <= tolerance or h <= SHORTEST:
                break
            h = work.longest = max(_next_length(h, error, tolerance), SHORTEST)
        if h < whole or work.longest < dt:
            proposed = _next_length(h, error, tolerance)
            work.longest = proposed if h < whole else max(proposed, work.longest)
        y1 = state_of(s)
        least = least_of_all(contacts, s, work, levels, f1, g1, least)
        near = min(f0, f1) < near_limit or (not slips and min(g0, g1) < near_limit)
        start, end = (y0, k0, f0, g0), (y1, k1, f1, g1)
        calm = none_stirs(work, h)
        swing = swing_of(case, y0, y1, h)
        t, looked = -1.0, False
        if near or least < 0.0 or not calm or not gaps_stay(s, work, swing):
            t, looked = first_event(
                contacts, rows, case, s, work, base, load, start, end, least, near, calm, swing, h, levels
            )
        if t >= 0.0:
            h, k1, f1, g1, least = go_to(contacts, rows, case, s, work, base, load, start, end, levels, t, h)
            y1 = state_of(s)
            if least < 0.0:
                why = _why_over(s)
            none_stirs(work, h)
        elif looked:
            set_state(s, y1, base)
            k1, f1, g1, _ = measure_here(contacts, rows, case, s, work, load, h)
            note_gaps(contacts, s, work)
        if y0[5] * y1[5] < 0.0 and abs(y0[2]) + h * (abs(y0[5]) + abs(y1[5])) > s.peak_tilt:
            s.peak_tilt = max(s.peak_tilt, _largest_tilt(y0[2], y0[5], k0[2], y1[2], y1[5], k1[2], h))
        note_forces_within(work, devices, h)
        note_peaks(case, s)
        y0, k0, f0, g0 = y1, k1, f1, g1
        if pass_time(s, h, dt):
            note_sample(history, case, s)
            note_sample_forces(forces, work, s)
    s.alpha = k0[2]
    # a slip that has turned at the event has stopped there, however little it is located beyond
    work.still = max(STILL, -4.0 * g0) if slips and why == LIMIT else STILL
    return why
