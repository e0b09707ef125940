"""Rocking and slide-rocking: integration of a body on one fulcrum to its next event."""

import math

from stayput.compiling import inline, inner
from stayput.mechanics.columns import CLOSED, CONTACTS, CORNER, ENDED, LIMIT, PLANE, SLIDE_ROCK, TURNED_OVER
from stayput.mechanics.contact import PAINLEVE_LIMIT
from stayput.mechanics.geometry import (
    GAP_TOLERANCE,
    RIGHT_ANGLE,
    arm_at,
    contact_point,
    sin_cos,
    slide_of,
    to_plane_axes,
    to_room_axes,
)
from stayput.mechanics.records import advance_clock, loads, record_sample
from stayput.mechanics.roots import (
    SLACK_FORCE,
    SLACK_SLIP,
    first_closing,
    illinois_update,
    last_reversal,
    level_of,
    parabola_negative_at,
    secant,
)
from stayput.mechanics.series import rock_series, slide_rock_series, step_within, tilt_after

NEAR_LIMIT = 0.01
"""Margin, as a part of g, below which at either end of a step it is also evaluated at the midpoint."""

WALL_SUPPORT = 1e9
"""Friction limit added on the side of a wall that blocks the fulcrum's slip [m/s²]: practically infinite."""

NEARLY_ZERO = 1e-9
"""Part of the rate at the end of a step up to which that at its start may be zero but for rounding."""

LOCATED = 1e-13
"""Tolerance to which a crossing is located [s]."""


@inline
def margins(law, sigma, kappa, omega, A, G, slip):
    """Event margins of a body on a fulcrum, positive while the mode lasts, and the tilt acceleration.

    Sticking: μN − T and μN + T. Slipping: N (negative where the slip jams), and the slip rate in its
    direction.

    ``law`` is (whether it sticks, I, −1/(I+r²), μ or μ', d, sign of N). Under the paper's rules the fulcrum
    can pull, and a wall at the base can block a sticking fulcrum's slip to the side d.
    """
    stick, I, q, mu, d, sign = law
    if stick:
        alpha = q * (kappa * A + sigma * G)
        N = G + alpha * sigma - omega * omega * kappa
        T = A + alpha * kappa + omega * omega * sigma
        return (
            sign * mu * N - T + (WALL_SUPPORT if d < 0.0 else 0.0),
            sign * mu * N + T + (WALL_SUPPORT if d > 0.0 else 0.0),
            alpha,
        )
    k = sigma - sign * mu * d * kappa
    M = I + k * sigma
    alpha = -k * (G - omega * omega * kappa) / M
    N = sign * (G + alpha * sigma - omega * omega * kappa)
    return (N if M > 0.5 * PAINLEVE_LIMIT * I else -1.0), d * slip, alpha


@inline
def slip_after(flow, mu_d, sigma, kappa, omega, t):
    """Slip rate of the fulcrum after a time t.

    As the friction of a slipping fulcrum is −μ'd N, ẋ + μ'd ż depends on the loads alone. ``flow`` is the
    value of that sum and of x + μ'd z at the start of the step, and the load A + μ'd Γ with its rate.
    """
    return flow[0] - t * (flow[2] + 0.5 * t * flow[3]) - omega * (mu_d * sigma + kappa)


@inline
def place_after(flow, mu_d, kappa, t):
    """Position of G along the plane after a time t of slipping."""
    return flow[1] - mu_d * kappa + t * (flow[0] - t * (flow[2] / 2.0 + t * flow[3] / 6.0))


@inline
def state_after(t, law, con, foot, sin0, cos0, series, flow, load):
    """State at a time t in a step: θ, θ̇, sin θ, cos θ, σ, κ, slip rate, fulcrum position, margins, θ̈."""
    theta, omega = tilt_after(series, t)
    sin, cos = sin_cos(theta, series[0], sin0, cos0)
    sigma, kappa = arm_at(con, sin, cos)
    slip, place = 0.0, foot
    if not law[0]:
        mu_d = law[3] * law[4] * law[5]
        slip = slip_after(flow, mu_d, sigma, kappa, omega, t)
        place = place_after(flow, mu_d, kappa, t) + sigma
    f, g, alpha = margins(law, sigma, kappa, omega, load[0] + load[1] * t, load[2] + load[3] * t, slip)
    return theta, omega, sin, cos, sigma, kappa, slip, place, f, g, alpha


@inner
def margins_after(t, law, con, sin0, cos0, series, flow, load):
    """Event margins at a time t in a step."""
    end = state_after(t, law, con, 0.0, sin0, cos0, series, flow, load)
    return end[8], end[9]


@inner
def first_limit(f0, g0, f1, g1, h, law, con, sin0, cos0, series, flow, load):
    """Time of the first crossing of a margin in a step, or −1.

    A parabola through start, middle and end says where a margin may be negative: also inside the step, where
    it is positive at both ends.
    """
    f_level, g_level = level_of(f0, SLACK_FORCE), level_of(g0, SLACK_FORCE if law[0] else SLACK_SLIP)
    fm, gm = margins_after(0.5 * h, law, con, sin0, cos0, series, flow, load)
    first = -1.0
    u = parabola_negative_at(f0 - f_level, fm - f_level, f1 - f_level)
    if u > 0.0:
        first = _locate(True, f_level, f0, u * h, law, con, sin0, cos0, series, flow, load)
    u = parabola_negative_at(g0 - g_level, gm - g_level, g1 - g_level)
    if u > 0.0:
        t = _locate(False, g_level, g0, u * h, law, con, sin0, cos0, series, flow, load)
        if t >= 0.0 and (first < 0.0 or t < first):
            first = t
    return first


@inner
def _locate(is_f, level, m0, high, law, con, sin0, cos0, series, flow, load):
    """Time at which a margin crosses its level before ``high``; −1 where it is not below it at ``high``."""
    f, g = margins_after(high, law, con, sin0, cos0, series, flow, load)
    m_high = (f if is_f else g) - level
    if m_high >= 0.0:
        return -1.0
    # at the start the margin is at or above its level, at ``high`` below: an Illinois search between the two
    bracket = (0.0, m0 - level, high, m_high, 0)
    last = high
    for _ in range(100):
        t = secant(bracket[0], bracket[1], bracket[2], bracket[3])
        if abs(t - last) <= LOCATED:
            return t
        f, g = margins_after(t, law, con, sin0, cos0, series, flow, load)
        bracket = illinois_update(bracket, t, (f if is_f else g) - level)
        last = t
    return last


@inline
def distance(other, u, v, sin, cos):
    """Offset of a corner from the fulcrum, across and along the normal of another contact's plane [m].

    (u, v) is the offset in the body's axes. With θ the second component changes at the rate of the first, and
    the first at minus the second.
    """
    x, z = u * cos + v * sin, v * cos - u * sin
    return -other.sin * z - other.cos * x, other.cos * z - other.sin * x


@inner
def first_contact(contacts, case, s, start, end, h, foot0, foot1, series, flow, mu_d):
    """Time at which another contact first closes in a step, or −1, and its bit.

    Parameters
    ----------
    start, end : tuple of float
        sin θ, cos θ, θ̇, θ̈, and the fulcrum's position along its plane [m] with its first and second
        derivatives.
    foot0, foot1 : float
        x and z of the fulcrum at the start of the step [m].
    """
    con, corner = contacts[s.i], CORNER[s.i]
    sin0, cos0, omega0, alpha0, place0, slip0, push0 = start
    sin1, cos1, omega1, alpha1, place1, slip1, push1 = end
    # upper bounds of rotation and fulcrum travel in the step, by which distant contacts are skipped
    turn = h * (abs(omega0) + abs(omega1) + h * (abs(alpha0) + abs(alpha1)))
    run = h * (abs(slip0) + abs(slip1) + h * (abs(push0) + abs(push1)))
    first, hit = -1.0, 0
    others = s.present & ~(1 << s.i)
    for c in range(CONTACTS):
        if others >> c & 1 and (CORNER[c] != corner or s.kind == SLIDE_ROCK):
            other = contacts[c]
            u, v = contact_point(case, c)
            u, v = u - case.u[corner], v - case.v[corner]
            clear = to_plane_axes(other, foot0, foot1)[1] + other.offset
            across0, up0 = distance(other, u, v, sin0, cos0)
            if clear + up0 > (abs(u) + abs(v)) * turn + run:
                continue  # out of reach in this step
            aside = to_plane_axes(other, con.cos, con.sin)[1]  # fulcrum's plane along the other's normal
            across1, up1 = distance(other, u, v, sin1, cos1)
            g0, g1 = clear + up0, clear + up1 + aside * (place1 - place0)
            v0, v1 = omega0 * across0 + aside * slip0, omega1 * across1 + aside * slip1
            c0 = alpha0 * across0 - omega0 * omega0 * up0 + aside * push0
            c1 = alpha1 * across1 - omega1 * omega1 * up1 + aside * push1
            t, level = first_closing(g0, v0, c0, g1, v1, c1, h)
            if t >= 0.0 and s.kind != SLIDE_ROCK and clear + GAP_TOLERANCE > math.sqrt(u * u + v * v):
                continue  # the corner's circle about the fulcrum touches the plane at most
            if t > 0.0:  # one Newton step on the series itself, since first_closing works on a quintic
                theta, omega = tilt_after(series, t)
                sin, cos = sin_cos(theta, series[0], sin0, cos0)
                corner_right, up = distance(other, u, v, sin, cos)
                sigma, kappa = arm_at(con, sin, cos)
                moved, slip = 0.0, 0.0
                if s.kind == SLIDE_ROCK:
                    moved = place_after(flow, mu_d, kappa, t) + sigma - place0
                    slip = slip_after(flow, mu_d, sigma, kappa, omega, t)
                rate = omega * corner_right + aside * slip
                if rate < 0.0:
                    t = min(h, max(0.5 * t, t - (clear + up + aside * moved - level) / rate))
            if t >= 0.0 and (first < 0.0 or t < first):
                first, hit = t, 1 << c
    return first, hit


@inner
def turned_over_at(series, theta1, h):
    """Time at which the tilt reaches 90° in a step, by bisection and one Newton step."""
    bound = math.copysign(RIGHT_ANGLE, theta1)
    low, high = 0.0, h
    for _ in range(60):
        t = 0.5 * (low + high)
        if abs(tilt_after(series, t)[0]) >= RIGHT_ANGLE:
            high = t
        else:
            low = t
        if high - low <= LOCATED:
            break
    tilt, rate = tilt_after(series, high)
    return high - (tilt - bound) / rate if rate != 0.0 else high


@inner
def turning_tilt(series, omega1, h):
    """Extreme tilt inside a step, where the rotation reverses; that at its start where it does not."""
    t, slope = last_reversal(series[1], 2.0 * series[2], omega1, h)
    for _ in range(2):
        t = min(h, max(0.0, t - tilt_after(series, t)[1] / slope))
    return tilt_after(series, t)[0]


@inline
def slip_push(law, end, A):
    """Slip acceleration of the fulcrum in a state from `state_after`, under the load A."""
    return -law[3] * law[4] * end[8] - A - end[10] * end[5] - end[1] * end[1] * end[4]


@inline
def first_event(contacts, case, s, law, start, end, h, near, series, flow, load):
    """Kind and time of the first event in a step from ``start`` to ``end``; ENDED where there is none."""
    con = contacts[s.i]
    foot = start[7]
    stick, d, mu_d = law[0], law[4], law[3] * law[4] * law[5]
    push0, push1 = 0.0, 0.0
    if not stick:
        push0, push1 = slip_push(law, start, load[0]), slip_push(law, end, load[0] + load[1] * h)
    begins = start[2], start[3], start[1], start[10], foot, start[6], push0
    ends = end[2], end[3], end[1], end[10], end[7], end[6], push1
    foot0, foot1 = con.cos * foot + con.sin * con.offset, con.sin * foot - con.cos * con.offset
    first, s.hit = first_contact(contacts, case, s, begins, ends, h, foot0, foot1, series, flow, mu_d)
    why = CLOSED if first >= 0.0 else ENDED
    if abs(end[0]) >= RIGHT_ANGLE:
        t = turned_over_at(series, end[0], h)
        if first < 0.0 or t < first:
            first, why = t, TURNED_OVER
    f0, g0, f1, g1 = start[8], start[9], end[8], end[9]
    # a slip rate positive at both ends can be zero inside only if it first decreases and then increases
    close = min(g0, g1) <= near if stick else g1 <= 0.0 or (d * push0 < 0.0 < d * push1)
    if close or min(f0, f1) <= near:
        t = first_limit(f0, g0, f1, g1, h, law, con, start[2], start[3], series, flow, load)
        if t >= 0.0 and (first < 0.0 or t < first):
            first, why = t, LIMIT
    return why, first


@inner
def _note_slides(con, case, s, law, foot, series, flow, load, start, end, h):
    """Update the peak slide in a step of a body that rotates about a corner at a wall or the ceiling.

    Its base is off the floor, so the slide reverses without an event.
    """
    write_back(con, start, s)
    rate0 = slide_of(case, s)[1]
    write_back(con, end, s)
    slide, rate1 = slide_of(case, s)
    s.peak_slide = max(s.peak_slide, abs(slide))
    if rate0 * rate1 > 0.0:
        return
    low, high = 0.0, h
    for _ in range(30):  # bisection; in so small a rotation the slide rate has one zero
        t = 0.5 * (low + high)
        write_back(con, state_after(t, law, con, foot, start[2], start[3], series, flow, load), s)
        slide, rate = slide_of(case, s)
        low, high = (low, t) if rate * rate1 > 0.0 else (t, high)
    s.peak_slide = max(s.peak_slide, abs(slide))


@inner
def advance_fulcrum(contacts, case, s, motion, settings, history):
    """Advance a body that rocks on the fulcrum s.i, sticking or slipping, to its next event.

    Each pass of the loop takes one step: expand the tilt in a Taylor series, choose the step by its last
    term, evaluate the state at the end, find the first event inside, and shorten the step to it. The state is
    kept in the axes of the fulcrum's plane and written back when the history or the end needs it.

    Returns
    -------
    int
        ENDED, CLOSED (s.hit says which contacts), LIMIT (a force or the slip rate) or TURNED_OVER.
    """
    ax, az, dt = motion.ax, motion.az, motion.dt
    tolerance, max_step = settings.tolerance, settings.max_step
    con = contacts[s.i]
    stick = s.kind != SLIDE_ROCK
    I, cf, sf = case.inertia, con.cos, con.sin
    d, sign = float(s.d), -1.0 if s.dj < 0 else 1.0
    mu = con.mu_static if stick else con.mu_kinetic
    mu_d = sign * mu * d
    q = -1.0 / (I + con.sigma * con.sigma + con.kappa * con.kappa)
    law = (stick, I, q, mu, d, sign)
    near = NEAR_LIMIT * case.gravity
    last = ax.shape[0] - 1
    per_second = case.scale / dt

    a, a_rate, G, G_rate = loads(case, ax, az, per_second, s.k, s.tau)
    sigma, kappa = arm_at(con, s.sin, s.cos)
    xi, v_xi = to_plane_axes(con, s.x, s.z)[0], to_plane_axes(con, s.vx, s.vz)[0]
    slip = v_xi - s.omega * kappa
    f, g, alpha = margins(law, sigma, kappa, s.omega, cf * a + sf * G, cf * G - sf * a, slip)
    start = (s.theta, s.omega, s.sin, s.cos, sigma, kappa, slip, xi + sigma, f, g, alpha)
    why = ENDED
    while s.k < last and why == ENDED:
        theta, omega, sin, cos, sigma, kappa, slip, foot, f, g, alpha = start
        xi, v_xi = foot - sigma, slip + omega * kappa
        a, a_rate, G, G_rate = loads(case, ax, az, per_second, s.k, s.tau)
        load = (cf * a + sf * G, cf * a_rate + sf * G_rate, cf * G - sf * a, cf * G_rate - sf * a_rate)
        if stick:
            series = rock_series(q, sigma, kappa, theta, omega, load)
        else:
            series = slide_rock_series(I, mu_d, sigma, kappa, theta, omega, load)
        flow = (  # see slip_after
            v_xi + mu_d * omega * sigma,
            xi + mu_d * kappa,
            load[0] + mu_d * load[2],
            load[1] + mu_d * load[3],
        )
        h = step_within(min(dt - s.tau, max_step), series, tolerance)
        end = state_after(h, law, con, foot, sin, cos, series, flow, load)
        why, event = first_event(contacts, case, s, law, start, end, h, near, series, flow, load)
        if why != ENDED:
            h = event
            end = state_after(h, law, con, foot, sin, cos, series, flow, load)
        s.steps += 1
        s.peak_tilt = max(s.peak_tilt, abs(end[0] - s.rest))
        turns = omega * end[1] <= NEARLY_ZERO * end[1] * end[1]
        if turns and abs(theta - s.rest) + h * (abs(omega) + abs(end[1]) + h * abs(alpha)) > s.peak_tilt:
            s.peak_tilt = max(s.peak_tilt, abs(turning_tilt(series, end[1], h) - s.rest))
        if PLANE[s.i] > 0:
            _note_slides(con, case, s, law, foot, series, flow, load, start, end, h)
        start = end
        if advance_clock(s, h, dt) and history.shape[0] > 0:
            write_back(con, start, s)
            record_sample(history, case, s)
    s.alpha = start[10]
    write_back(con, start, s)
    return why


@inline
def write_back(con, state, s):
    """Write a state from `state_after` into the record, in the room's axes."""
    s.theta, s.omega, s.sin, s.cos, sigma, kappa, slip, foot, _, _, _ = state
    s.x, s.z = to_room_axes(con, foot - sigma, kappa - con.offset)
    s.vx, s.vz = to_room_axes(con, slip + s.omega * kappa, s.omega * sigma)
