"""One integration step, and what it evaluates: accelerations and event margins of a body in its mode.

The equations are those of the solver without devices, with the elements' force (F_x, F_z, F_θ) beside the
loads: on a plane A − F·t takes the place of A, Γ − F·n that of Γ, and F_θ adds to the moment.

On a sticking fulcrum, the commonest motion, there is one degree of freedom, the tilt. Every point of the body
moves on a circle about the fulcrum. Along a fixed direction its coordinate is e = a + p cos θ + q sin θ, its
rate θ̇ l, and the lever arm of a force there l = q cos θ − p sin θ; so are the elongations of lines and the
gaps of contacts. With the moment M of the lines about the fulcrum,

    (I + r²) θ̈ = M − κ A − σ Γ

whose solution is a series (`moment`). In every other mode a step is one of the Dormand–Prince method of order
5(4) (1980), with its error estimate; its dense output is the quintic Hermite interpolant of position, rate
and acceleration. After each step the state is projected back onto the constraints of the mode: a sticking
corner stays where it was, a slipping one on its plane.
"""

import math

from stayput.compiling import inline, inner
from stayput.mechanics import columns as col
from stayput.mechanics.contact import PAINLEVE_LIMIT, slide_on_two_planes
from stayput.mechanics.devices.lines import evaluate_lines, line_force, set_lines
from stayput.mechanics.devices.moment import expand_tilt, sum_lines, tilt_at
from stayput.mechanics.dormand_prince import ERROR, RATES, STAGES, TIMES
from stayput.mechanics.geometry import (
    GAP_TOLERANCE,
    arm,
    arm_at,
    contact_point,
    own_friction,
    project_on_both,
    project_on_plane,
    set_pivot_velocity,
    sin_cos,
    slip_rate,
    to_plane_axes,
    to_room_axes,
    value_or,
)
from stayput.mechanics.roots import last_reversal

POSITIONS = RATES @ RATES
"""Weights of the stage accelerations in the positions: the method applied to the rates."""

POSITIONS_ERROR = ERROR @ RATES


@inline
def _on_corner(con, case, d, sin, cos, vx, vz, omega, A, Γ, fl):
    """Tangential and normal acceleration of G, θ̈ and the event margins of a body slipping on one corner."""
    I = case.inertia
    sigma, kappa = arm_at(con, sin, cos)
    spin = omega * omega
    mu_d = con.mu_kinetic * d
    k = sigma - mu_d * kappa
    M = I + k * sigma
    alpha = (fl - k * (Γ - kappa * spin)) / M
    off_plane = sigma * alpha - kappa * spin
    N = Γ + off_plane
    slip = to_plane_axes(con, vx, vz)[0] - omega * kappa
    return -mu_d * N - A, off_plane, alpha, (N if M > 0.5 * PAINLEVE_LIMIT * I else -1.0), d * slip


@inline
def shared_friction(case, first, second, d, shift):
    """Kinetic coefficient of the flat base under a body that slides, the load shifted by ``shift`` [m].

    ``first`` and ``second`` are (coefficient, σ, κ) of A and B. The leading corner carries the whole load at
    the coefficient ``tips``, the trailing one at ``sits``. Where the base's own coefficient is beyond either,
    the corner that carries the load has its edge's, unless that would put the other corner down again: then
    it is the one at which the other just carries nothing; see `contact.base_friction`.
    """
    lead, trail = (second, first) if d > 0.0 else (first, second)
    tips, sits = d * (lead[1] - shift) / lead[2], d * (trail[1] - shift) / trail[2]
    mu = case.kinetic_friction
    if mu > tips:
        return min(mu, max(lead[0], tips))
    return max(mu, min(trail[0], sits))


@inline
def kinetic_pair(contacts, case, s, d, sigma_i, sigma_j, kappa, Γ, fl):
    """Kinetic coefficients of both corners of a body that slides flat."""
    first, second = contacts[s.i].mu_kinetic, contacts[s.j].mu_kinetic
    if col.PLANE[s.i] > 0:
        return first, second
    mu = shared_friction(case, (first, sigma_i, kappa), (second, sigma_j, kappa), d, fl / Γ)
    return value_or(own_friction(case, col.A_FLOOR)[1], mu), value_or(own_friction(case, col.B_FLOOR)[1], mu)


@inner
def _flat(contacts, case, s, d, sin, cos, vx, vz, A, Γ, fl):
    """Tangential acceleration and event margins of a body that slides on both corners of a plane."""
    first, second = contacts[s.i], contacts[s.j]
    sigma_i, kappa = arm_at(first, sin, cos)
    sigma_j, _ = arm_at(second, sin, cos)
    mu_i, mu_j = kinetic_pair(contacts, case, s, d, sigma_i, sigma_j, kappa, Γ, fl)
    # N_i + N_j = Γ and p_i N_i + p_j N_j = F_θ
    p_i, p_j = sigma_i - d * mu_i * kappa, sigma_j - d * mu_j * kappa
    N_j = (fl - p_i * Γ) / (p_j - p_i)
    N_i = Γ - N_j
    return -A - d * (mu_i * N_i + mu_j * N_j), min(N_i, N_j), d * to_plane_axes(first, vx, vz)[0]


@inner
def _on_two_planes(rows, contacts, case, s, a, G, fl):
    """Accelerations and event margins of a body that slides on two planes at once."""
    ax, az, alpha, Ni, Nj = slide_on_two_planes(rows, contacts, case, s, s.sin, s.cos, s.omega, a, G, fl)
    least = -1.0 if math.isnan(Ni) else min(Ni, Nj)
    slip_i, slip_j = slip_rate(contacts[s.i], s), slip_rate(contacts[s.j], s)
    return ax, az, alpha, least, min(float(s.d) * slip_i, float(s.dj) * slip_j)


@inline
def _accelerations_under(contacts, rows, case, s, load, t, fx, fz, fl):
    """Accelerations of x, z and θ, and two margins, under this line force and its moment about G."""
    a, G = load[0] + load[1] * t - fx, load[2] + load[3] * t - fz
    sin, cos, vx, vz, omega = s.sin, s.cos, s.vx, s.vz, s.omega
    kind = s.kind
    if kind == col.FLIGHT:
        return -a, -G, fl / case.inertia, math.inf, math.inf
    if kind == col.LEAN:
        return _on_two_planes(rows, contacts, case, s, a, G, fl)
    con = contacts[s.i]
    A, Γ = to_plane_axes(con, a, G)
    if kind == col.SLIDE:
        normal = alpha = 0.0
        tangential, f, g = _flat(contacts, case, s, float(s.d), sin, cos, vx, vz, A, Γ, fl)
    else:
        tangential, normal, alpha, f, g = _on_corner(con, case, float(s.d), sin, cos, vx, vz, omega, A, Γ, fl)
    return *to_room_axes(con, tangential, normal), alpha, f, g


@inline
def accelerations(contacts, rows, case, s, work, load, t):
    """Accelerations of x, z and θ in the state and mode of s a time t into the step, and two event margins.

    The margins are forces [m/s²], but the second is a slip rate [m/s] where there is slip. Not for a
    sticking fulcrum; see `rocking_step`.
    """
    fx, fz, fl = line_force(work, s.sin, s.cos, True, s.x, s.z, s.vx, s.vz, s.omega)
    return _accelerations_under(contacts, rows, case, s, load, t, fx, fz, fl)


@inner
def evaluate_at(contacts, rows, case, s, work, load, t):
    """As `accelerations`, with the least margin of the lines; stores the values in their rows."""
    fx, fz, fl, least = evaluate_lines(work, s.sin, s.cos, True, s.x, s.z, s.vx, s.vz, s.omega)
    ax, az, alpha, f, g = _accelerations_under(contacts, rows, case, s, load, t, fx, fz, fl)
    return (ax, az, alpha), f, g, least


@inner
def set_about_fulcrum(elements, links, contacts, case, s, work):
    """Set the line coefficients, and the gap functions of the open contacts, about the fulcrum."""
    con, corner = contacts[s.i], col.CORNER[s.i]
    foot = work.foot = to_plane_axes(con, s.x, s.z)[0] + arm(con, s)[0]
    x, z = con.cos * foot + con.sin * con.offset, con.sin * foot - con.cos * con.offset
    set_lines(elements, links, case, corner, x, z, work)
    sum_lines(links, work)
    others = s.present & ~s.closed
    for c in range(col.CONTACTS):
        if others >> c & 1:
            other, reach = contacts[c], work.reach[c]
            u, v = contact_point(case, c)
            u, v = u - case.u[corner], v - case.v[corner]
            reach[0] = to_plane_axes(other, x, z)[1] + other.offset
            reach[1], reach[2] = other.cos * v - other.sin * u, -other.sin * v - other.cos * u
            if reach[0] + GAP_TOLERANCE > math.sqrt(u * u + v * v):
                reach[0] = math.inf  # the corner's circle about the fulcrum touches the plane at most


@inline
def stand_on_fulcrum(con, s, foot):
    """Set position and velocity of G from the tilt, with the sticking corner at its place along the plane."""
    sigma, kappa = arm(con, s)
    s.x, s.z = to_room_axes(con, foot - sigma, kappa - con.offset)
    set_pivot_velocity(con, s)


@inline
def _under(con, case, s, load, t, fx, fz, moment):
    """Accelerations of x, z and θ, and the two margins of the fulcrum, under these forces of the lines."""
    A, Γ = to_plane_axes(con, load[0] + load[1] * t, load[2] + load[3] * t)
    sigma, kappa = arm(con, s)
    alpha = (moment - kappa * A - sigma * Γ) / (case.inertia + sigma * sigma + kappa * kappa)
    spin = s.omega * s.omega
    tangential, normal = kappa * alpha + sigma * spin, sigma * alpha - kappa * spin
    along_plane, off_plane = to_plane_axes(con, fx, fz)
    N, T = Γ - off_plane + normal, A - along_plane + tangential
    k = *to_room_axes(con, tangential, normal), alpha
    return k, con.mu_static * N - T, con.mu_static * N + T


@inline
def evaluate_on_fulcrum(con, case, s, work, load, t):
    """As `accelerations.evaluate_at`, from the tilt and its rate alone."""
    fx, fz, moment, least = evaluate_lines(work, s.sin, s.cos, False, 0.0, 0.0, 0.0, 0.0, s.omega)
    k, f, g = _under(con, case, s, load, t, fx, fz, moment)
    return k, f, g, least


@inner
def begin_fulcrum_step(con, case, work, base, load, omega, tolerance, h):
    """Expand the tilt of a body on a sticking fulcrum; return the length of the step, at most h.

    Where the series does not reach as far as h, two even steps are better than a long one and a sliver.
    """
    A, Γ = to_plane_axes(con, load[0], load[2])
    A_rate, Γ_rate = to_plane_axes(con, load[1], load[3])
    q = 1.0 / (case.inertia + con.sigma * con.sigma + con.kappa * con.kappa)
    loads = A, A_rate, Γ, Γ_rate
    longest = expand_tilt(work, con, q, loads, base[0], omega, base[1], base[2], h, tolerance)
    return h if longest >= h else min(longest, 0.5 * h)


@inner
def end_fulcrum_step(con, case, s, work, base, load, h):
    """Set the state to that at h in the step, by the series; as `evaluate_on_fulcrum`."""
    s.theta, s.omega = tilt_at(work, h)
    s.sin, s.cos = sin_cos(s.theta, base[0], base[1], base[2])
    stand_on_fulcrum(con, s, work.foot)
    return evaluate_on_fulcrum(con, case, s, work, load, h)


@inner
def turning_tilt_on_fulcrum(work, omega0, alpha0, omega1, h):
    """Extreme tilt inside a step, where the rotation reverses; that at its start where it does not."""
    t, slope = last_reversal(omega0, alpha0, omega1, h)
    for _ in range(2):
        t = min(h, max(0.0, t - tilt_at(work, t)[1] / slope))
    return tilt_at(work, t)[0]


@inline
def _weighted_sums(stage, i, c):
    """Weighted sums of the accelerations of the stages before i, for its position and its rate."""
    place = rate = 0.0
    for j in range(i):
        place, rate = place + POSITIONS[i, j] * stage[j, c], rate + RATES[i, j] * stage[j, c]
    return place, rate


@inner
def take_free_step(contacts, rows, case, s, work, base, load, y0, k0, h):
    """Set the state to that a time h after the state y0 with accelerations k0.

    On a flat base only the position is integrated.

    Returns
    -------
    tuple
        At the end: accelerations, the contacts' two margins, the lines' least margin; and the error estimate,
        the largest of positions and h times rates [m, rad].
    """
    x0, z0, theta0, vx0, vz0, omega0 = y0
    stage = work.stage
    stage[0, 0], stage[0, 1], stage[0, 2] = k0
    turns = s.kind != col.SLIDE
    for i in range(1, STAGES):
        t = h * TIMES[i]
        if turns:
            place, rate = _weighted_sums(stage, i, 2)
            s.theta, s.omega = theta0 + (t * omega0 + h * h * place), omega0 + h * rate
            s.sin, s.cos = sin_cos(s.theta, base[0], base[1], base[2])
        place, rate = _weighted_sums(stage, i, 0)
        s.x, s.vx = x0 + (t * vx0 + h * h * place), vx0 + h * rate
        place, rate = _weighted_sums(stage, i, 1)
        s.z, s.vz = z0 + (t * vz0 + h * h * place), vz0 + h * rate
        if i < STAGES - 1:
            stage[i, 0], stage[i, 1], stage[i, 2], _, _ = accelerations(
                contacts, rows, case, s, work, load, t
            )
    project_on_constraints(contacts, case, s, work)
    end, f, g, least = evaluate_at(contacts, rows, case, s, work, load, h)
    stage[STAGES - 1, 0], stage[STAGES - 1, 1], stage[STAGES - 1, 2] = end
    error = 0.0
    for c in range(3 if turns else 2):
        place = rate = 0.0
        for j in range(STAGES):
            place, rate = place + POSITIONS_ERROR[j] * stage[j, c], rate + ERROR[j] * stage[j, c]
        error = max(error, h * h * max(abs(place), abs(rate)))
    return end, f, g, least, error


@inner
def evaluate_state(contacts, rows, case, s, work, load, t):
    """Accelerations, the contacts' two margins and the lines' least margin in the state of s."""
    if s.kind == col.ROCK:
        return evaluate_on_fulcrum(contacts[s.i], case, s, work, load, t)
    return evaluate_at(contacts, rows, case, s, work, load, t)


@inner
def contact_margins(contacts, rows, case, s, work, load, t):
    """The contacts' two margins in the state of s; stores nothing."""
    if s.kind == col.ROCK:
        fx, fz, moment = line_force(work, s.sin, s.cos, False, 0.0, 0.0, 0.0, 0.0, s.omega)
        _, f, g = _under(contacts[s.i], case, s, load, t, fx, fz, moment)
    else:
        _, _, _, f, g = accelerations(contacts, rows, case, s, work, load, t)
    return f, g


@inline
def set_state(s, y, base):
    """Write (x, z, θ, ẋ, ż, θ̇) into the state record."""
    s.x, s.z, s.theta, s.vx, s.vz, s.omega = y
    s.sin, s.cos = sin_cos(y[2], base[0], base[1], base[2])


@inner
def project_on_constraints(contacts, case, s, work):
    """Project the state onto the mode's constraints: contacts on their planes, a sticking corner in place."""
    if s.kind == col.ROCK:
        stand_on_fulcrum(contacts[s.i], s, work.foot)
    elif s.kind == col.SLIDE_ROCK or s.kind == col.SLIDE:
        project_on_plane(contacts[s.i], s)
    elif s.kind == col.LEAN:
        project_on_both(contacts[s.i], contacts[s.j], case.inertia, s)
