"""Adaptive stepping of a moving body with elements to its next event, of contacts or of elements.

Steps are screened for elements whose event functions provably keep their sign within the step: the forces of
a line deviate from straight lines between the ends of a step by no more than a bound; a margin larger than
the bound at both ends cannot vanish inside, and the costly event search is skipped. The bound is that of the
cubic through elongation and rate at both ends; on a sticking fulcrum, where steps are long, what the tilt
deviates from a cubic is added.
"""

from stayput.compiling import inline, inner
from stayput.mechanics.columns import ENDED, FLIGHT, LIMIT, ROCK
from stayput.mechanics.devices.columns import FRICTION, SLACK, YIELDING
from stayput.mechanics.devices.device_law import SLIP_RATE_TIME, utilization_of
from stayput.mechanics.devices.events import (
    excursion_bound,
    first_event,
    gaps_stay_open,
    least_margin,
    note_gaps,
    set_gap_levels,
)
from stayput.mechanics.devices.lines import (
    begin_step,
    note_forces_within,
    reaches_peak,
    record_forces,
    set_lines,
)
from stayput.mechanics.devices.moment import deviation_from_cubic, is_wavy
from stayput.mechanics.devices.step import (
    begin_fulcrum_step,
    end_fulcrum_step,
    evaluate_state,
    set_about_fulcrum,
    take_free_step,
    turning_tilt_on_fulcrum,
)
from stayput.mechanics.elementary import fifth_root
from stayput.mechanics.fulcrum import NEAR_LIMIT
from stayput.mechanics.geometry import arm_at, reason_of_end, state_of, to_plane_axes, update_peaks
from stayput.mechanics.records import advance_clock, loads, record_sample
from stayput.mechanics.roots import SLACK_FORCE, SLACK_SLIP, hermite, horner, last_reversal, level_of

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


REST_RATE = 1e-9
"""Rate up to which a slipping corner, or a moving body, is at rest [m/s]."""

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
        ends = (y0, k0, f0, g0), (y1, k1, f1, g1)
        excursion = excursion_bound(case, y0, y1, h)
        if near or least < 0.0 or not inactive or not gaps_stay_open(s, work, excursion):
            hit, h, k1, f1, g1, least = first_event(
                contacts, rows, case, s, work, base, load, ends, least, near, inactive, excursion, h, levels
            )
            if hit:
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
