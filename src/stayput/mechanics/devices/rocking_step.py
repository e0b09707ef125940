"""Rocking on a sticking fulcrum, the commonest motion: one degree of freedom, the tilt.

Every point of the body moves on a circle about the fulcrum. Along a fixed direction its coordinate is
e = a + p cos θ + q sin θ, its rate θ̇ l, and the lever arm of a force there l = q cos θ − p sin θ; so are the
elongations of lines and the gaps of contacts. With the moment M of the lines about the fulcrum,

    (I + r²) θ̈ = M − κ A − σ Γ
"""

from __future__ import annotations

import math

from stayput.compiling import inline, inner
from stayput.mechanics.columns import CORNER
from stayput.mechanics.devices.active_elements import evaluate_lines, line_force
from stayput.mechanics.devices.lines import set_lines
from stayput.mechanics.devices.moment import expand_tilt, sum_lines, tilt_at
from stayput.mechanics.geometry import GAP_TOLERANCE, arm, contact_point, sin_cos, to_plane_axes
from stayput.mechanics.projection import set_pivot_velocity
from stayput.mechanics.roots import last_reversal


@inner
def set_about_fulcrum(elements, links, contacts, case, s, work):
    """Set the line coefficients, and the gap functions of the open contacts, about the fulcrum."""
    con, corner = contacts[s.i], CORNER[s.i]
    foot = work.foot = to_plane_axes(con, s.x, s.z)[0] + arm(con, s)[0]
    x, z = con.cos * foot + con.sin * con.offset, con.sin * foot - con.cos * con.offset
    set_lines(elements, links, case, corner, x, z, work)
    sum_lines(links, work)
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1:
            other, reach = contacts[c], work.reach[c]
            u, v = contact_point(case, c)
            u, v = u - case.u[corner], v - case.v[corner]
            reach[0] = to_plane_axes(other, x, z)[1] + other.offset
            reach[1], reach[2] = other.cos * v - other.sin * u, -other.sin * v - other.cos * u
            if reach[0] + GAP_TOLERANCE > math.sqrt(u * u + v * v):
                reach[0] = math.inf  # the corner's circle about the fulcrum touches the plane at most
        c += 1


@inline
def stand_on_fulcrum(con, s, foot):
    """Set position and velocity of G from the tilt, with the sticking corner at its place along the plane."""
    sigma, kappa = arm(con, s)
    right, height = foot - sigma, kappa - con.offset
    s.x, s.z = con.cos * right - con.sin * height, con.sin * right + con.cos * height
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
    k = con.cos * tangential - con.sin * normal, con.sin * tangential + con.cos * normal, alpha
    return k, con.mu_static * N - T, con.mu_static * N + T


@inline
def evaluate_on_fulcrum(con, case, s, work, load, t):
    """As `accelerations.evaluate_at`, from the tilt and its rate alone."""
    fx, fz, moment, least = evaluate_lines(work, s.sin, s.cos, False, 0.0, 0.0, 0.0, 0.0, s.omega)
    k, f, g = _under(con, case, s, load, t, fx, fz, moment)
    return k, f, g, least


@inner
def margins_on_fulcrum(con, case, s, work, load, t):
    """The fulcrum's two margins in the state of s; stores nothing."""
    fx, fz, moment = line_force(work, s.sin, s.cos, False, 0.0, 0.0, 0.0, 0.0, s.omega)
    _, f, g = _under(con, case, s, load, t, fx, fz, moment)
    return f, g


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
