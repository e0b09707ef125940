"""Adaptive stepping of a moving body with elements to its next event, of contacts or of elements."""

from __future__ import annotations

from stayput.compiling import inline, inner
from stayput.mechanics.columns import ENDED, FLIGHT, LIMIT, ROCK
from stayput.mechanics.devices.active_elements import (
    SLACK_FORCE,
    begin_step,
    level_of,
    note_forces_within,
    reaches_peak,
    record_forces,
)
from stayput.mechanics.devices.events import (
    excursion_bound,
    first_event,
    gaps_stay_open,
    least_margin,
    note_gaps,
    set_gap_levels,
)
from stayput.mechanics.devices.lines import set_lines
from stayput.mechanics.devices.moment import deviation_from_cubic, is_wavy
from stayput.mechanics.devices.rocking_step import (
    begin_fulcrum_step,
    end_fulcrum_step,
    set_about_fulcrum,
    turning_tilt_on_fulcrum,
)
from stayput.mechanics.devices.screening import no_line_event
from stayput.mechanics.devices.step import (
    evaluate_state,
    state_of,
    take_free_step,
)
from stayput.mechanics.elementary import fifth_root
from stayput.mechanics.geometry import arm_at, reason_of_end, to_plane_axes, update_peaks
from stayput.mechanics.roots import hermite, horner, last_reversal
from stayput.mechanics.sampling import advance_clock, loads, record_sample

SLACK_SLIP = 5e-11
"""Slack of a slip rate that starts a step at zero [m/s]; see `active_elements.SLACK_FORCE`."""

REST_RATE = 1e-9
"""Rate up to which a slipping corner, or a moving body, is at rest [m/s]."""

NEAR_LIMIT = 0.01
"""Margin, as a part of g, below which at either end of a step it is also evaluated at the midpoint."""

FORCE_SWING = 2.0
"""Change of a contact's margin per force of the lines, 1 + μ: what they may swing inside a step is added."""

MIN_STEP = 1e-6
"""Least step; it is accepted whatever its error [s]."""

MAX_ROTATION = 0.1
"""Approximate largest rotation in a step [rad]."""


@inner
def _turning_tilt(theta0, omega0, alpha0, theta1, omega1, alpha1, h):
    """Extreme tilt inside a step, where the rotation reverses; that at its start where it does not."""
    curve = hermite(theta0, omega0, alpha0, theta1, omega1, alpha1, h)
    t, slope = last_reversal(omega0, alpha0, omega1, h)
    for _ in range(2):
        t = min(h, max(0.0, t - horner(curve, t / h)[1] / (h * slope)))
    return horner(curve, t / h)[0]


@inline
def _slip_push(con, y, k, sin, cos):
    """Acceleration along its plane of a contact's corner in the state y with accelerations k [m/s²]."""
    sigma, kappa = arm_at(con, sin, cos)
    return to_plane_axes(con, k[0], k[1])[0] - k[2] * kappa - y[5] * y[5] * sigma


@inline
def _next_length(h, error, tolerance):
    """Step length for the tolerance, from a step h with this error (fifth order; factor 0.2 to 4)."""
    if 2048.0 * error <= tolerance:  # the factor would be over 4; also where the error is zero
        return 4.0 * h
    return h * min(4.0, max(0.2, 0.9 * fifth_root(tolerance / error)))


@inner
def _set_laws(elements, links, contacts, case, s, work):
    if s.kind == ROCK:
        set_about_fulcrum(elements, links, contacts, case, s, work)
    else:
        set_lines(elements, links, case, -1, 0.0, 0.0, work)


@inner
def advance_step_by_step(held, contacts, rows, case, s, motion, settings, output):
    """Advance a body with elements in its mode to its next event.

    Each pass of the loop takes one step: choose its length, repeat it until the error is within the
    tolerance, screen the margins, search the step for its first event and move the state there, then update
    peaks and history. Laws of the lines are set once, since their branches change only at events.

    Returns
    -------
    int
        ENDED, CLOSED (s.hit says which contacts), LIMIT (a force, a slip rate or an element) or TURNED_OVER.
    """
    elements, links, devices, work = held.elements, held.links, held.devices, held.work
    ax, az, dt = motion.ax, motion.az, motion.dt
    tolerance, max_step = settings.error, settings.max_step
    history, forces = output.history, output.forces
    last = ax.shape[0] - 1
    per_second = case.scale / dt
    slips = s.kind != ROCK and s.kind != FLIGHT
    slack_f, slack_g = (
        work.slack_factor * SLACK_FORCE,
        work.slack_factor * (SLACK_SLIP if slips else SLACK_FORCE),
    )
    near_limit = NEAR_LIMIT * case.gravity
    _set_laws(elements, links, contacts, case, s, work)
    load = loads(case, ax, az, per_second, s.k, s.tau)
    y0 = state_of(s)
    k0, f0, g0, _ = evaluate_state(contacts, rows, case, s, work, load, 0.0)
    note_gaps(contacts, s, work)
    why = ENDED
    while s.k < last and why == ENDED:
        base = s.theta, s.sin, s.cos
        load = loads(case, ax, az, per_second, s.k, s.tau)
        levels = level_of(f0, slack_f), level_of(g0, slack_g)
        set_gap_levels(s, work)
        begin_step(work)
        whole = min(dt - s.tau, max_step)
        if abs(s.omega) * whole > MAX_ROTATION:
            whole = MAX_ROTATION / abs(s.omega)
        if s.kind == ROCK:
            con = contacts[s.i]
            h = begin_fulcrum_step(con, case, work, base, load, y0[5], tolerance, whole)
            k1, f1, g1, least = end_fulcrum_step(con, case, s, work, base, load, h)
            s.steps += 1
            beyond = deviation_from_cubic(work, h)
            inactive, deviation = no_line_event(work, h, beyond)
            close = min(f0, g0, f1, g1) < near_limit + FORCE_SWING * deviation
            if is_wavy(work, h, beyond) and (close or not inactive or reaches_peak(work, devices)):
                h *= 0.5
                k1, f1, g1, least = end_fulcrum_step(con, case, s, work, base, load, h)
                beyond = deviation_from_cubic(work, h)
                inactive, deviation = no_line_event(work, h, beyond)
        else:
            h = min(whole, work.step_limit)
            if h > 0.8 * whole:  # rather one slightly longer step than a sliver before the sample
                h = whole
            while True:
                k1, f1, g1, least, error = take_free_step(
                    contacts, rows, case, s, work, base, load, y0, k0, h
                )
                s.steps += 1
                if error <= tolerance or h <= MIN_STEP:
                    break
                h = work.step_limit = max(_next_length(h, error, tolerance), MIN_STEP)
            if h < whole or work.step_limit < dt:
                proposed = _next_length(h, error, tolerance)
                work.step_limit = proposed if h < whole else max(proposed, work.step_limit)
            beyond = 0.0
            inactive, deviation = no_line_event(work, h, beyond)
        y1 = state_of(s)
        least = least_margin(contacts, s, work, levels, f1, g1, least)
        reserve = near_limit + FORCE_SWING * deviation
        if slips:  # a slip rate can be zero inside only if it first decreases and then increases
            con, d = contacts[s.i], float(s.d)
            before, after = _slip_push(con, y0, k0, base[1], base[2]), _slip_push(con, y1, k1, s.sin, s.cos)
            near = d * before < 0.0 < d * after
        else:
            near = min(g0, g1) < reserve
        near = near or min(f0, f1) < reserve
        start, end = (y0, k0, f0, g0), (y1, k1, f1, g1)
        excursion = excursion_bound(case, y0, y1, h)
        if near or least < 0.0 or not inactive or not gaps_stay_open(s, work, excursion):
            found, h, k1, f1, g1, least = first_event(
                contacts,
                rows,
                case,
                s,
                work,
                base,
                load,
                start,
                end,
                least,
                near,
                inactive,
                excursion,
                h,
                levels,
            )
            if found:
                y1 = state_of(s)
                if least < 0.0:
                    why = reason_of_end(s)
                no_line_event(work, h, beyond)
        if abs(y0[2] - s.rest) + h * (abs(y0[5]) + abs(y1[5]) + h * abs(k0[2])) > s.peak_tilt:
            if s.kind == ROCK:
                turning = turning_tilt_on_fulcrum(work, y0[5], k0[2], y1[5], h)
            else:
                turning = _turning_tilt(y0[2], y0[5], k0[2], y1[2], y1[5], k1[2], h)
            s.peak_tilt = max(s.peak_tilt, abs(turning - s.rest))
        note_forces_within(work, devices, h)
        update_peaks(case, s)
        y0, k0, f0, g0 = y1, k1, f1, g1
        if advance_clock(s, h, dt):
            record_sample(history, case, s)
            record_forces(forces, work, s)
    s.alpha = k0[2]
    # a slip that has reversed at the event has stopped, however little beyond zero its rate was located
    work.still_rate = max(REST_RATE, -4.0 * g0) if slips and why == LIMIT else REST_RATE
    return why
