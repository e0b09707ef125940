"""Rocking and slide-rocking: a body on one fulcrum, from one event to the next."""

from __future__ import annotations

import math

from stayput.compiled import inline, inner
from stayput.mechanics.columns import CLOSED, CORNER, ENDED, LIMIT, SLIP, TURNED_OVER
from stayput.mechanics.contact import JAMMED
from stayput.mechanics.geometry import HALF_TURN, along, arm_at, sin_cos
from stayput.mechanics.motion import loads, note_sample, pass_time
from stayput.mechanics.roots import closed_level, falls_inside, first_zero, narrowed, secant
from stayput.mechanics.series import rock_series, slide_rock_series, step_within, tilt_after

NEAR_LIMIT = 0.01
"""A margin smaller than this part of g at either end of a step is also looked at in its middle."""

SLACK_FORCE, SLACK_SLIP = 1e-8, 5e-11
"""A margin that starts at its limit has passed it when it is this far beyond [m/s², m/s]."""

BORNE = 1e9
"""What a wall adds to the friction of a fulcrum that stands at it [m/s²]."""

LOCATED = 1e-13
"""A limit is located to this part of a second [s]."""


@inline
def margins(law, sigma, kappa, omega, A, G, slip):
    """What must stay positive on a fulcrum, and the tilt acceleration.

    Sticking: μN − T and μN + T. Slipping: N, as long as the slip is not jammed, and the slip rate in its
    direction. law holds whether it
    sticks, I, −1/(I+r²), μ or μ', d, and the sign of N: under the paper's rules the fulcrum can pull, and a
    wall at the base can keep one that sticks from slipping to the side d.
    """
    stick, I, q, mu, d, sign = law
    if stick:
        alpha = q * (kappa * A + sigma * G)
        N = G + alpha * sigma - omega * omega * kappa
        T = A + alpha * kappa + omega * omega * sigma
        return (
            sign * mu * N - T + (BORNE if d < 0.0 else 0.0),
            sign * mu * N + T + (BORNE if d > 0.0 else 0.0),
            alpha,
        )
    k = sigma - sign * mu * d * kappa
    M = I + k * sigma
    alpha = -k * (G - omega * omega * kappa) / M
    N = sign * (G + alpha * sigma - omega * omega * kappa)
    return (N if M > 0.5 * JAMMED * I else -1.0), d * slip, alpha


@inline
def slip_after(flow, mu_d, sigma, kappa, omega, t):
    """Slip rate of the fulcrum after a time t.

    The friction on a slipping fulcrum, −μ'd N, makes ẋ + μ'd ż change with the loads alone: flow holds
    its value and that of x + μ'd z at the start of the step, and the load A + μ'd Γ with its rate.
    """
    return flow[0] - t * (flow[2] + 0.5 * t * flow[3]) - omega * (mu_d * sigma + kappa)


@inline
def place_after(flow, mu_d, kappa, t):
    """Place of G along the plane after a time t of slipping."""
    return flow[1] - mu_d * kappa + t * (flow[0] - t * (flow[2] / 2.0 + t * flow[3] / 6.0))


@inline
def state_after(t, law, con, foot, sin0, cos0, series, flow, load):
    """State at a time t in a step: θ, θ̇, sin θ, cos θ, σ, κ, slip rate, place of the fulcrum, margins, θ̈."""
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
    """The margins at a time t in a step."""
    end = state_after(t, law, con, 0.0, sin0, cos0, series, flow, load)
    return end[8], end[9]


@inline
def limit_level(m0, slack):
    """Value at which a margin counts as passed in a step that starts with m0; see `closed_level`."""
    return 0.0 if m0 > slack else min(m0, 0.0) - slack


@inner
def first_limit(f0, g0, f1, g1, h, law, con, sin0, cos0, series, flow, load):
    """Time of the first margin that becomes negative in a step, or −1."""
    f_level, g_level = limit_level(f0, SLACK_FORCE), limit_level(g0, SLACK_FORCE if law[0] else SLACK_SLIP)
    fm, gm = margins_after(0.5 * h, law, con, sin0, cos0, series, flow, load)
    first = -1.0
    u = falls_inside(f0 - f_level, fm - f_level, f1 - f_level)
    if u > 0.0:
        first = _locate(True, f_level, f0, u * h, law, con, sin0, cos0, series, flow, load)
    u = falls_inside(g0 - g_level, gm - g_level, g1 - g_level)
    if u > 0.0:
        t = _locate(False, g_level, g0, u * h, law, con, sin0, cos0, series, flow, load)
        if t >= 0.0 and (first < 0.0 or t < first):
            first = t
    return first


@inner
def _locate(is_f, level, m0, high, law, con, sin0, cos0, series, flow, load):
    """Time at which a margin falls below its level, at or before ``high``; −1 where it is not below there."""
    f, g = margins_after(high, law, con, sin0, cos0, series, flow, load)
    m_high = (f if is_f else g) - level
    if m_high >= 0.0:
        return -1.0
    bracket = (0.0, m0 - level, high, m_high, 0)
    last = high
    for _ in range(100):
        t = secant(bracket[0], bracket[1], bracket[2], bracket[3])
        if abs(t - last) <= LOCATED:
            return t
        f, g = margins_after(t, law, con, sin0, cos0, series, flow, load)
        bracket = narrowed(bracket, t, (f if is_f else g) - level)
        last = t
    return last


@inline
def distance(other, u, v, sin, cos):
    """Corner (u, v) of the fulcrum's from it: across and along the normal of another contact's plane [m].

    Its rate of change with θ is the first, that of the first is minus the second.
    """
    x, z = u * cos + v * sin, v * cos - u * sin
    return -other.sin * z - other.cos * x, other.cos * z - other.sin * x


@inner
def first_contact(contacts, case, s, start, end, h, foot0, foot1, series, flow, mu_d):
    """Time at which another contact closes in a step, or −1, and its bit.

    Parameters
    ----------
    start, end : tuple of float
        sin θ, cos θ, θ̇, θ̈ and, of the fulcrum along its plane, place [m], rate and second rate.
    foot0, foot1 : float
        Place of the fulcrum in the room at the start of the step [m].
    """
    con, corner = contacts[s.i], CORNER[s.i]
    sin0, cos0, omega0, alpha0, place0, slip0, push0 = start
    sin1, cos1, omega1, alpha1, place1, slip1, push1 = end
    # no more than this the body turns and the fulcrum runs in the step
    turn = h * (abs(omega0) + abs(omega1) + h * (abs(alpha0) + abs(alpha1)))
    run = h * (abs(slip0) + abs(slip1) + h * (abs(push0) + abs(push1)))
    first, hit = -1.0, 0
    others = s.present & ~(1 << s.i)
    c = 0
    while others >> c:
        if others >> c & 1 and (CORNER[c] != corner or s.kind == SLIP):
            other = contacts[c]
            u, v = case.u[CORNER[c]] - case.u[corner], case.v[CORNER[c]] - case.v[corner]
            clear = along(other, foot0, foot1)[1] + other.offset
            across0, up0 = distance(other, u, v, sin0, cos0)
            if clear + up0 > (abs(u) + abs(v)) * turn + run:
                c += 1
                continue  # too far away to be reached in this step
            aside = along(other, con.cos, con.sin)[1]  # of the fulcrum's plane from the other
            across1, up1 = distance(other, u, v, sin1, cos1)
            level = closed_level(clear + up0)
            g0, g1 = clear + up0 - level, clear + up1 + aside * (place1 - place0) - level
            v0, v1 = omega0 * across0 + aside * slip0, omega1 * across1 + aside * slip1
            c0 = alpha0 * across0 - omega0 * omega0 * up0 + aside * push0
            c1 = alpha1 * across1 - omega1 * omega1 * up1 + aside * push1
            t = first_zero(g0, v0, c0, g1, v1, c1, h)
            if t > 0.0:  # on the series itself
                theta, omega = tilt_after(series, t)
                sin, cos = sin_cos(theta, series[0], sin0, cos0)
                across, up = distance(other, u, v, sin, cos)
                sigma, kappa = arm_at(con, sin, cos)
                moved, slip = 0.0, 0.0
                if s.kind == SLIP:
                    moved = place_after(flow, mu_d, kappa, t) + sigma - place0
                    slip = slip_after(flow, mu_d, sigma, kappa, omega, t)
                rate = omega * across + aside * slip
                if rate < 0.0:
                    t = min(h, max(0.5 * t, t - (clear + up + aside * moved - level) / rate))
            if t >= 0.0 and (first < 0.0 or t < first):
                first, hit = t, 1 << c
        c += 1
    return first, hit


@inner
def turned_over_at(series, theta1, h):
    """Time at which the tilt reaches a right angle before the end of a step."""
    bound = math.copysign(HALF_TURN, theta1)
    low, high = 0.0, h
    for _ in range(60):
        t = 0.5 * (low + high)
        if abs(tilt_after(series, t)[0]) >= HALF_TURN:
            high = t
        else:
            low = t
        if high - low <= LOCATED:
            break
    tilt, rate = tilt_after(series, high)
    return high - (tilt - bound) / rate if rate != 0.0 else high


@inner
def largest_tilt(series, omega1, h):
    """Magnitude of the tilt where the rotation turns inside a step."""
    t = h * series[1] / (series[1] - omega1)
    for _ in range(2):
        rate = tilt_after(series, t)[1]
        bend = 2.0 * series[2] + t * (6.0 * series[3] + t * (12.0 * series[4] + t * 20.0 * series[5]))
        if bend != 0.0:
            t = min(h, max(0.0, t - rate / bend))
    return abs(tilt_after(series, t)[0])


@inline
def slip_push(law, end, A):
    """Acceleration of the slip of the fulcrum in a state from `state_after`, under the load A."""
    return -law[3] * law[4] * end[8] - A - end[10] * end[5] - end[1] * end[1] * end[4]


@inline
def first_event(contacts, case, s, law, start, end, h, near, series, flow, load):
    """Why and when the motion ends in a step from ``start`` to ``end``; ENDED where it does not."""
    con = contacts[s.i]
    foot = start[7]
    stick, d, mu_d = law[0], law[4], law[3] * law[4] * law[5]
    push0, push1 = 0.0, 0.0
    if not stick:
        push0, push1 = slip_push(law, start, load[0]), slip_push(law, end, load[0] + load[1] * h)
    first, s.hit = first_contact(
        contacts,
        case,
        s,
        (start[2], start[3], start[1], start[10], foot, start[6], push0),
        (end[2], end[3], end[1], end[10], end[7], end[6], push1),
        h,
        con.cos * foot + con.sin * con.offset,
        con.sin * foot - con.cos * con.offset,
        series,
        flow,
        mu_d,
    )
    why = CLOSED if first >= 0.0 else ENDED
    if abs(end[0]) >= HALF_TURN:
        t = turned_over_at(series, end[0], h)
        if first < 0.0 or t < first:
            first, why = t, TURNED_OVER
    f0, g0, f1, g1 = start[8], start[9], end[8], end[9]
    # a slip rate can fall to zero inside the step only if it falls first and rises afterwards
    close = min(g0, g1) <= near if stick else g1 <= 0.0 or (d * push0 < 0.0 < d * push1)
    if close or min(f0, f1) <= near:
        t = first_limit(f0, g0, f1, g1, h, law, con, start[2], start[3], series, flow, load)
        if t >= 0.0 and (first < 0.0 or t < first):
            first, why = t, LIMIT
    return why, first


@inner
def advance_fulcrum(contacts, case, s, ax, az, dt, tolerance, max_step, history):
    """Move a body that rocks on the fulcrum s.i, sticking or slipping, to its next event.

    Parameters
    ----------
    tolerance : float
        Largest last term of the series in a step [rad].
    max_step : float
        Longest step [s].

    Returns
    -------
    int
        ENDED, CLOSED (s.hit says which contacts), LIMIT (a force or the slip rate) or TURNED_OVER.
    """
    con = contacts[s.i]
    stick = s.kind != SLIP
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
    xi, v_xi = along(con, s.x, s.z)[0], along(con, s.vx, s.vz)[0]
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
        s.peak_tilt = max(s.peak_tilt, abs(end[0]))
        if omega * end[1] < 0.0 and abs(theta) + h * (abs(omega) + abs(end[1])) > s.peak_tilt:
            s.peak_tilt = max(s.peak_tilt, largest_tilt(series, end[1], h))
        start = end
        if pass_time(s, h, dt) and history.shape[0] > 0:
            write_back(con, start, s)
            note_sample(history, case, s)
    s.alpha = start[10]
    write_back(con, start, s)
    return why


@inline
def write_back(con, state, s):
    """Put a state from `state_after` into the room's axes."""
    s.theta, s.omega, s.sin, s.cos, sigma, kappa, slip, foot, _, _, _ = state
    xi, v_xi = foot - sigma, slip + s.omega * kappa
    height, lift = kappa - con.offset, s.omega * sigma
    s.x, s.z = con.cos * xi - con.sin * height, con.sin * xi + con.cos * height
    s.vx, s.vz = con.cos * v_xi - con.sin * lift, con.sin * v_xi + con.cos * lift
