"""Rocking and slide-rocking: a body on one fulcrum, from one event to the next."""

from __future__ import annotations

import math

from stayput.mechanics.columns import CLOSED, CORNER, ENDED, LIMIT, PLANE, SLIP, TURNED_OVER
from stayput.mechanics.compiled import inner
from stayput.mechanics.geometry import HALF_TURN, along, arm, gap_and_rates
from stayput.mechanics.motion import loads, note_sample, pass_time
from stayput.mechanics.roots import falls_inside, first_zero, illinois
from stayput.mechanics.series import rock_series, slide_rock_series, step_within, tilt_after

SLACK = 4e-12
"""A corner that swings past a plane at a tangent touches it only if it comes this far behind it [m]."""

STALLED = 8
"""After this many events without time passing, a tiny step is taken without looking for events."""

TINY_STEP = 1e-6
"""That step [s]."""

NEAR_LIMIT = 0.05
"""A margin smaller than this part of g at either end of a step is also looked at in its middle."""


@inner
def set_tilt_bounds(contacts, case, s):
    """Set the range of tilt within which no other contact closes while the fulcrum stays where it is.

    A contact on another plane counts only when the fulcrum sticks; a slipping one moves towards it.
    """
    s.low, s.high, s.low_hit, s.high_hit = -HALF_TURN, HALF_TURN, 0, 0
    con = contacts[s.i]
    sigma, kappa = arm(con, s.theta)
    x = s.x + con.cos * sigma + con.sin * kappa
    z = s.z + con.sin * sigma - con.cos * kappa
    corner = CORNER[s.i]
    c = 0
    while s.present >> c:
        other = contacts[c]
        u, v = case.u[CORNER[c]] - case.u[corner], case.v[CORNER[c]] - case.v[corner]
        reach = math.hypot(u, v)
        counts = s.present >> c & 1 and reach > 0.0 and (s.kind != SLIP or PLANE[c] == PLANE[s.i])
        if counts:
            clear = along(other, x, z)[1] + other.offset + SLACK
            # gap = clear + reach cos(θ − centre)
            centre = math.atan2(-other.sin * v - other.cos * u, other.cos * v - other.sin * u)
            if clear < reach:
                half = math.acos(max(-1.0, -clear / reach))
                if s.theta - centre > math.pi:
                    centre += 2.0 * math.pi
                elif s.theta - centre < -math.pi:
                    centre -= 2.0 * math.pi
                if centre - half > s.low:
                    s.low, s.low_hit = centre - half, 1 << c
                if centre + half < s.high:
                    s.high, s.high_hit = centre + half, 1 << c
        c += 1


@inner
def margins(stick, I, mu, d, sigma, kappa, omega, A, G, slip):
    """What must stay positive on a fulcrum, and the tilt acceleration.

    Sticking: μN − T and μN + T. Slipping: N and the slip rate in its direction.
    """
    if stick:
        alpha = -(kappa * A + sigma * G) / (I + sigma * sigma + kappa * kappa)
        N = G + alpha * sigma - omega * omega * kappa
        T = A + alpha * kappa + omega * omega * sigma
        return mu * N - T, mu * N + T, alpha
    k = sigma - mu * d * kappa
    alpha = -k * (G - omega * omega * kappa) / (I + k * sigma)
    return G + alpha * sigma - omega * omega * kappa, d * slip, alpha


@inner
def slip_after(flow, mu_d, sigma, kappa, omega, t):
    """Slip rate of the fulcrum after a time t.

    The friction on a slipping fulcrum, −μ'd N, makes ẋ + μ'd ż change with the loads alone: flow holds
    its value and that of x + μ'd z at the start of the step, and the load A + μ'd Γ with its rate.
    """
    return flow[0] - t * (flow[2] + 0.5 * t * flow[3]) - omega * (mu_d * sigma + kappa)


@inner
def margins_after(t, stick, I, mu, d, con, series, flow, load):
    """The margins at a time t in a step."""
    theta, omega = tilt_after(series, t)
    sigma, kappa = arm(con, theta)
    slip = slip_after(flow, mu * d, sigma, kappa, omega, t)
    return margins(stick, I, mu, d, sigma, kappa, omega, load[0] + load[1] * t, load[2] + load[3] * t, slip)


@inner
def first_limit(f0, g0, f1, g1, h, near, watch_force, stick, I, mu, d, con, series, flow, load):
    """Time of the first margin that becomes negative in a step, or −1."""
    if min(min(f0, g0), min(f1, g1)) > near:
        return -1.0
    fm, gm, _ = margins_after(0.5 * h, stick, I, mu, d, con, series, flow, load)
    u = falls_inside(f0, fm, f1)
    first = -1.0
    if u > 0.0 and watch_force:
        first = _locate(True, u * h, stick, I, mu, d, con, series, flow, load)
    u = falls_inside(g0, gm, g1)
    if u > 0.0:
        t = _locate(False, u * h, stick, I, mu, d, con, series, flow, load)
        if t >= 0.0 and (first < 0.0 or t < first):
            first = t
    return first


@inner
def _locate(is_f, high, stick, I, mu, d, con, series, flow, load):
    """Time at which a margin becomes negative, at or before ``high``; −1 where it is not negative there."""
    f, g, _ = margins_after(high, stick, I, mu, d, con, series, flow, load)
    m_high = f if is_f else g
    if m_high >= 0.0:
        return -1.0
    low, m_low = high, m_high
    for _ in range(20):  # towards the start, to where it is still positive
        low *= 0.25
        f, g, _ = margins_after(low, stick, I, mu, d, con, series, flow, load)
        m_low = f if is_f else g
        if m_low > 0.0:
            break
        high, m_high = low, m_low
    if m_low <= 0.0:
        return 0.0
    for _ in range(100):
        if high - low <= 1e-13:
            break
        t = illinois(low, m_low, high, m_high)
        f, g, _ = margins_after(t, stick, I, mu, d, con, series, flow, load)
        m = f if is_f else g
        if m > 0.0:
            low, m_low, m_high = t, m, 0.5 * m_high
        else:
            high, m_high, m_low = t, m, 0.5 * m_low
    return high


@inner
def first_bound(low, high, alpha0, theta1, omega1, alpha1, h, series):
    """Time at which the tilt reaches a bound in a step, or −1, and whether it is the upper one."""
    theta, omega = series[0], series[1]
    t_low = first_zero(theta - low, omega, alpha0, theta1 - low, omega1, alpha1, h)
    t_high = first_zero(high - theta, -omega, -alpha0, high - theta1, -omega1, -alpha1, h)
    upper = t_high >= 0.0 and (t_low < 0.0 or t_high < t_low)
    t = t_high if upper else t_low
    if t > 0.0:  # on the series itself
        bound = high if upper else low
        for _ in range(2):
            tilt, rate = tilt_after(series, t)
            if rate != 0.0:
                t = min(h, max(0.5 * t, t - (tilt - bound) / rate))
    return t, upper


@inner
def other_planes(s):
    """Bits of the contacts on other planes than the fulcrum's."""
    return s.present & ~(0b11 << 2 * PLANE[s.i])


@inner
def first_wall(contacts, bits, h, start, end):
    """Time at which a contact on another plane closes while the fulcrum slips, or −1, and its bit."""
    first, hit = -1.0, 0
    c = 0
    while bits >> c:
        if bits >> c & 1:
            g0, v0, c0 = gap_and_rates(contacts[c], start)
            g1, v1, c1 = gap_and_rates(contacts[c], end)
            t = first_zero(g0, v0, c0, g1, v1, c1, h)
            if t >= 0.0 and (first < 0.0 or t < first):
                first, hit = t, 1 << c
        c += 1
    return first, hit


@inner
def place_after(flow, mu_d, kappa, t):
    """Place of G along the plane after a time t of slipping."""
    return flow[1] - mu_d * kappa + t * (flow[0] - t * (flow[2] / 2.0 + t * flow[3] / 6.0))


@inner
def whole_state(con, sigma, kappa, xi, v_xi, theta, omega, alpha, drive, mu_d):
    """Place, rates and accelerations of a body on a slipping fulcrum, for the gaps to other planes."""
    height, lift = kappa - con.offset, omega * sigma
    rise = alpha * sigma - omega * omega * kappa
    a_xi = drive - mu_d * rise
    cf, sf = con.cos, con.sin
    return (
        cf * xi - sf * height,
        sf * xi + cf * height,
        theta,
        cf * v_xi - sf * lift,
        sf * v_xi + cf * lift,
        omega,
        cf * a_xi - sf * rise,
        sf * a_xi + cf * rise,
        alpha,
    )


@inner
def largest_tilt(series, omega1, h):
    """Tilt of largest magnitude in a step, where the rotation turns inside it; 0 where it does not."""
    if series[1] * omega1 >= 0.0:
        return 0.0
    t = h * series[1] / (series[1] - omega1)
    for _ in range(2):
        rate = tilt_after(series, t)[1]
        bend = 2.0 * series[2] + t * (6.0 * series[3] + t * (12.0 * series[4] + t * 20.0 * series[5]))
        if bend != 0.0:
            t = min(h, max(0.0, t - rate / bend))
    return abs(tilt_after(series, t)[0])


@inner
def advance_fulcrum(contacts, case, s, ax, az, dt, tolerance, max_step, lifts, history):
    """Move a body that rocks on the fulcrum s.i, sticking or slipping, to its next event.

    Parameters
    ----------
    tolerance : float
        Largest last term of the series in a step [rad].
    max_step : float
        Longest step [s].
    lifts : bool
        Whether the fulcrum lifts when its force vanishes (not under the paper's rules).

    Returns
    -------
    int
        ENDED, CLOSED (s.hit says which contacts), LIMIT (a force or the slip rate) or TURNED_OVER.
    """
    con = contacts[s.i]
    stick = s.kind != SLIP
    I, r, cf, sf = case.inertia, con.r, con.cos, con.sin
    d = float(s.d)
    mu = con.mu_static if stick else con.mu_kinetic
    mu_d = mu * d
    q = -r / (I + r * r)
    set_tilt_bounds(contacts, case, s)
    walls = 0 if stick else other_planes(s)
    theta, omega = s.theta, s.omega
    sigma, kappa = arm(con, theta)
    xi, v_xi = along(con, s.x, s.z)[0], along(con, s.vx, s.vz)[0]
    foot = xi + sigma  # where the fulcrum sticks
    near = NEAR_LIMIT * case.gravity
    last = ax.shape[0] - 1
    outcome = ENDED
    while s.k < last and outcome == ENDED:
        a, a_rate, G, G_rate = loads(case, ax, az, dt, s.k, s.tau)
        load = (cf * a + sf * G, cf * a_rate + sf * G_rate, cf * G - sf * a, cf * G_rate - sf * a_rate)
        if stick:
            series = rock_series(q, sigma / r, kappa / r, theta, omega, load)
        else:
            series = slide_rock_series(I, mu_d, sigma, kappa, theta, omega, load)
        h = step_within(min(dt - s.tau, max_step), series[7], tolerance)
        if s.stalls > STALLED:  # two modes hand over to each other: a tiny step in this one
            h = min(h, TINY_STEP)
        s.steps += 1

        theta1, omega1 = tilt_after(series, h)
        sigma1, kappa1 = arm(con, theta1)
        flow = (  # see slip_after
            v_xi + mu_d * omega * sigma,
            xi + mu_d * kappa,
            load[0] + mu_d * load[2],
            load[1] + mu_d * load[3],
        )
        slip0, slip1 = v_xi - omega * kappa, slip_after(flow, mu_d, sigma1, kappa1, omega1, h)
        A1, G1 = load[0] + load[1] * h, load[2] + load[3] * h
        f0, g0, alpha = margins(stick, I, mu, d, sigma, kappa, omega, load[0], load[2], slip0)
        f1, g1, alpha1 = margins(stick, I, mu, d, sigma1, kappa1, omega1, A1, G1, slip1)

        outcome, event = ENDED, h
        if s.stalls <= STALLED:
            t, upper = first_bound(s.low, s.high, alpha, theta1, omega1, alpha1, h, series)
            if t >= 0.0:
                event, s.hit = t, s.high_hit if upper else s.low_hit
                outcome = CLOSED if s.hit else TURNED_OVER
            if walls:
                t, hit = first_wall(
                    contacts,
                    walls,
                    h,
                    whole_state(con, sigma, kappa, xi, v_xi, theta, omega, alpha, -flow[2], mu_d),
                    whole_state(
                        con,
                        sigma1,
                        kappa1,
                        place_after(flow, mu_d, kappa1, h),
                        slip1 + omega1 * kappa1,
                        theta1,
                        omega1,
                        alpha1,
                        -flow[2] - h * flow[3],
                        mu_d,
                    ),
                )
                if 0.0 <= t <= event:
                    event, s.hit, outcome = t, hit, CLOSED
            t = first_limit(f0, g0, f1, g1, h, near, lifts or stick, stick, I, mu, d, con, series, flow, load)
            if 0.0 <= t < event:
                event, outcome = t, LIMIT
        if outcome != ENDED:
            h = event
            theta1, omega1 = tilt_after(series, h)
            if outcome == CLOSED and s.hit & (s.low_hit | s.high_hit):
                theta1 = s.high if abs(theta1 - s.high) < abs(theta1 - s.low) else s.low
            sigma1, kappa1 = arm(con, theta1)
            slip1 = slip_after(flow, mu_d, sigma1, kappa1, omega1, h)
            A1, G1 = load[0] + load[1] * h, load[2] + load[3] * h
            alpha1 = margins(stick, I, mu, d, sigma1, kappa1, omega1, A1, G1, slip1)[2]
        s.peak_tilt = max(s.peak_tilt, abs(theta1), largest_tilt(series, omega1, h))
        if stick:
            xi, v_xi = foot - sigma1, omega1 * kappa1
        else:
            xi, v_xi = place_after(flow, mu_d, kappa1, h), slip1 + omega1 * kappa1
        theta, omega, sigma, kappa = theta1, omega1, sigma1, kappa1
        if pass_time(s, h, dt) and history.shape[0] > 0:
            write_back(con, sigma, kappa, xi, v_xi, theta, omega, s)
            note_sample(history, case, s)
        s.alpha = alpha1
        if s.stalls > STALLED:
            outcome = LIMIT  # choose again
    write_back(con, sigma, kappa, xi, v_xi, theta, omega, s)
    return outcome


@inner
def write_back(con, sigma, kappa, xi, v_xi, theta, omega, s):
    """Put the state of a body on a fulcrum back into the room's axes."""
    height, lift = kappa - con.offset, omega * sigma
    s.x, s.z = con.cos * xi - con.sin * height, con.sin * xi + con.cos * height
    s.vx, s.vz = con.cos * v_xi - con.sin * lift, con.sin * v_xi + con.cos * lift
    s.theta, s.omega = theta, omega
