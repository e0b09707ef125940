"""Accelerations of a body in its mode under the loads, the contact forces and those of the elements.

The equations are those of the solver without devices, with the elements' force (F_x, F_z, F_θ) beside the
loads: on a plane A − F·t takes the place of A, Γ − F·n that of Γ, and F_θ adds to the moment.
"""

from __future__ import annotations

import math

from stayput.compiling import inline, inner
from stayput.mechanics.columns import A_FLOOR, B_FLOOR, FLIGHT, LEAN, PLANE, SLIDE
from stayput.mechanics.contact import PAINLEVE_LIMIT, fill_rows, forces_of_slipping_pair
from stayput.mechanics.devices.active_elements import evaluate_lines, line_force
from stayput.mechanics.geometry import arm_at, own_friction, to_plane_axes, value_or


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
    if PLANE[s.i] > 0:
        return first, second
    mu = shared_friction(case, (first, sigma_i, kappa), (second, sigma_j, kappa), d, fl / Γ)
    return value_or(own_friction(case, A_FLOOR)[1], mu), value_or(own_friction(case, B_FLOOR)[1], mu)


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
def _on_two_planes(rows, contacts, case, s, sin, cos, vx, vz, omega, a, G, fl):
    """Accelerations and event margins of a body that slides on two planes at once."""
    I = case.inertia
    fill_rows(rows, contacts, s.closed, sin, cos, case)
    for k in range(2):
        row = rows[k]
        row.bias_n = to_plane_axes(contacts[row.index], -a, -G)[1] - omega * omega * row.tl + row.nl * fl / I
        row.target = 0.0
    i, j = (0, 1) if s.i < s.j else (1, 0)
    ri, rj = rows[i], rows[j]
    Ni, Nj, fx, fz, moment = forces_of_slipping_pair(ri, float(s.d), rj, float(s.dj), I)
    least = -1.0 if math.isnan(Ni) else min(Ni, Nj)
    slip_i = ri.tx * vx + ri.tz * vz + ri.tl * omega
    slip_j = rj.tx * vx + rj.tz * vz + rj.tl * omega
    return fx - a, fz - G, (moment + fl) / I, least, min(float(s.d) * slip_i, float(s.dj) * slip_j)


@inline
def _accelerations_under(contacts, rows, case, s, load, t, fx, fz, fl):
    """Accelerations of x, z and θ, and two margins, under this line force and its moment about G."""
    a, G = load[0] + load[1] * t - fx, load[2] + load[3] * t - fz
    sin, cos, vx, vz, omega = s.sin, s.cos, s.vx, s.vz, s.omega
    kind = s.kind
    if kind == FLIGHT:
        return -a, -G, fl / case.inertia, math.inf, math.inf
    if kind == LEAN:
        return _on_two_planes(rows, contacts, case, s, sin, cos, vx, vz, omega, a, G, fl)
    con = contacts[s.i]
    A, Γ = to_plane_axes(con, a, G)
    if kind == SLIDE:
        normal = alpha = 0.0
        tangential, f, g = _flat(contacts, case, s, float(s.d), sin, cos, vx, vz, A, Γ, fl)
    else:
        tangential, normal, alpha, f, g = _on_corner(con, case, float(s.d), sin, cos, vx, vz, omega, A, Γ, fl)
    return con.cos * tangential - con.sin * normal, con.sin * tangential + con.cos * normal, alpha, f, g


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
