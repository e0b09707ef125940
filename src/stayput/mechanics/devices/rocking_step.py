"""Rocking on a sticking fulcrum, the commonest motion: one degree of freedom, the tilt.

Every point of the body moves on a circle about the fulcrum. Along a fixed direction its coordinate is
e = a + p cos θ + q sin θ, its rate θ̇ l, and the lever arm of a force there l = q cos θ − p sin θ; so are the
elongations of lines and the gaps of contacts. With the moment M of the lines about the fulcrum,

    (I + r²) θ̈ = M − κ A − σ Γ
"""

from __future__ import annotations

from stayput.compiled import inline, inner
from stayput.mechanics.columns import CORNER
from stayput.mechanics.devices.active_elements import evaluate_lines, line_force
from stayput.mechanics.devices.branch_law import set_lines
from stayput.mechanics.devices.dormand_prince import (
    POSITIONS,
    POSITIONS_ERROR,
    RATES,
    RATES_ERROR,
    STAGES,
    TIMES,
)
from stayput.mechanics.geometry import arm, sin_cos, to_plane_axes
from stayput.mechanics.projection import set_pivot_velocity

P3, P4, P5, P6, P7 = (tuple(POSITIONS[i, :i].tolist()) for i in range(2, STAGES))
R2, R3, R4, R5, R6, R7 = (tuple(RATES[i, :i].tolist()) for i in range(1, STAGES))
PW, RW = tuple(POSITIONS_ERROR.tolist()), tuple(RATES_ERROR.tolist())
T2, T3, T4, T5 = TIMES[1:5].tolist()


@inner
def set_about_fulcrum(elements, links, contacts, case, s, work):
    """Set the line coefficients, and the gap functions of the open contacts, about the fulcrum."""
    con, corner = contacts[s.i], CORNER[s.i]
    foot = work.foot = to_plane_axes(con, s.x, s.z)[0] + arm(con, s)[0]
    x, z = con.cos * foot + con.sin * con.offset, con.sin * foot - con.cos * con.offset
    set_lines(elements, links, case, corner, x, z, work)
    others = s.present & ~s.closed
    c = 0
    while others >> c:
        if others >> c & 1:
            other, reach = contacts[c], work.reach[c]
            u, v = case.u[CORNER[c]] - case.u[corner], case.v[CORNER[c]] - case.v[corner]
            reach[0] = to_plane_axes(other, x, z)[1] + other.offset
            reach[1], reach[2] = other.cos * v - other.sin * u, -other.sin * v - other.cos * u
        c += 1


@inline
def stand_on_fulcrum(con, s, foot):
    """Set position and velocity of G from the tilt, with the sticking corner at its place along the plane."""
    sigma, kappa = arm(con, s)
    right, height = foot - sigma, kappa - con.offset
    s.x, s.z = con.cos * right - con.sin * height, con.sin * right + con.cos * height
    set_pivot_velocity(con, s)


@inline
def evaluate_on_fulcrum(con, case, s, work, load, t):
    """As `accelerations.evaluate_at`, from the tilt and its rate alone."""
    fx, fz, moment, least = evaluate_lines(work, s.sin, s.cos, False, 0.0, 0.0, 0.0, 0.0, s.omega)
    A, Γ = to_plane_axes(con, load[0] + load[1] * t, load[2] + load[3] * t)
    sigma, kappa = arm(con, s)
    alpha = (moment - kappa * A - sigma * Γ) / (case.inertia + sigma * sigma + kappa * kappa)
    spin = s.omega * s.omega
    tangential, normal = kappa * alpha + sigma * spin, sigma * alpha - kappa * spin
    along_plane, off_plane = to_plane_axes(con, fx, fz)
    N, T = Γ - off_plane + normal, A - along_plane + tangential
    k = con.cos * tangential - con.sin * normal, con.sin * tangential + con.cos * normal, alpha
    return k, con.mu_static * N - T, con.mu_static * N + T, least


@inline
def _alpha(work, law, t, base, theta, omega):
    """Tilt acceleration a time t into the step."""
    sigma0, kappa0, q, A, A_rate, Γ, Γ_rate = law
    sin, cos = sin_cos(theta, base[0], base[1], base[2])
    _, _, moment = line_force(work, sin, cos, False, 0.0, 0.0, 0.0, 0.0, omega)
    sigma, kappa = sigma0 * cos - kappa0 * sin, kappa0 * cos + sigma0 * sin
    return q * (moment - (kappa * (A + A_rate * t) + sigma * (Γ + Γ_rate * t)))


@inner
def take_fulcrum_step(con, case, s, work, base, load, omega, alpha, h):
    """Take one step of a body on a sticking fulcrum, as `step.take_step`.

    The stages are written out with the tableau's weights as constants, without its zeros: Numba does not
    unroll loops over tuples, and this is the innermost loop.
    """
    A, Γ = to_plane_axes(con, load[0], load[2])
    A_rate, Γ_rate = to_plane_axes(con, load[1], load[3])
    q = 1.0 / (case.inertia + con.sigma * con.sigma + con.kappa * con.kappa)
    law = (con.sigma, con.kappa, q, A, A_rate, Γ, Γ_rate)
    th, w, hh = base[0], omega, h * h
    t = T2 * h
    k1 = alpha
    k2 = _alpha(work, law, t, base, th + t * w, w + h * (R2[0] * k1))
    t = T3 * h
    place, rate = P3[0] * k1, R3[0] * k1 + R3[1] * k2
    k3 = _alpha(work, law, t, base, th + (t * w + hh * place), w + h * rate)
    t = T4 * h
    place, rate = P4[0] * k1 + P4[1] * k2, R4[0] * k1 + R4[1] * k2 + R4[2] * k3
    k4 = _alpha(work, law, t, base, th + (t * w + hh * place), w + h * rate)
    t = T5 * h
    place = P5[0] * k1 + P5[1] * k2 + P5[2] * k3
    rate = R5[0] * k1 + R5[1] * k2 + R5[2] * k3 + R5[3] * k4
    k5 = _alpha(work, law, t, base, th + (t * w + hh * place), w + h * rate)
    place = P6[0] * k1 + P6[1] * k2 + P6[2] * k3 + P6[3] * k4
    rate = R6[0] * k1 + R6[1] * k2 + R6[2] * k3 + R6[3] * k4 + R6[4] * k5
    k6 = _alpha(work, law, h, base, th + (h * w + hh * place), w + h * rate)
    place = P7[0] * k1 + P7[1] * k2 + P7[2] * k3 + P7[3] * k4 + P7[4] * k5
    rate = R7[0] * k1 + R7[2] * k3 + R7[3] * k4 + R7[4] * k5 + R7[5] * k6
    s.theta, s.omega = th + (h * w + hh * place), w + h * rate
    s.sin, s.cos = sin_cos(s.theta, base[0], base[1], base[2])
    stand_on_fulcrum(con, s, work.foot)
    end, f, g, least = evaluate_on_fulcrum(con, case, s, work, load, h)
    k7 = end[2]
    place = PW[0] * k1 + PW[1] * k2 + PW[2] * k3 + PW[3] * k4 + PW[4] * k5 + PW[5] * k6
    rate = RW[0] * k1 + RW[2] * k3 + RW[3] * k4 + RW[4] * k5 + RW[5] * k6 + RW[6] * k7
    return end, f, g, least, hh * max(abs(place), abs(rate))
