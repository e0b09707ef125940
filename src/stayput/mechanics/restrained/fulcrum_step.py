"""The commonest step: on a fulcrum that sticks, where only the tilt changes.

Seen from the fulcrum, a point of the body turns on a circle. Along a direction of the room that is fixed, its
place is e = e₀ + p cos θ + q sin θ, its rate θ̇ l and the lever of a force there l = q cos θ − p sin θ. On its
branch the force of a line is linear in both. So the stages of a step are a few products each, without the
records that the other modes read and write.
"""

from __future__ import annotations

import math

from stayput.compiled import inline, inner
from stayput.mechanics.columns import CORNER
from stayput.mechanics.geometry import along, arm, sin_cos
from stayput.mechanics.modes import pivot_on
from stayput.mechanics.restrained.columns import (
    AXIAL,
    BOND,
    MINUS,
    NORMAL,
    OPEN,
    SLIP_MINUS,
    SLIP_PLUS,
)
from stayput.mechanics.restrained.dormand_prince import (
    PLACES,
    PLACES_WRONG,
    RATES,
    RATES_WRONG,
    STAGES,
    TIMES,
)
from stayput.mechanics.restrained.elements import measure
from stayput.mechanics.restrained.lines import limit, slips_by_friction, stretch
from stayput.mechanics.restrained.rates import on_fulcrum

P3, P4, P5, P6, P7 = (tuple(PLACES[i, :i].tolist()) for i in range(2, STAGES))
R2, R3, R4, R5, R6, R7 = (tuple(RATES[i, :i].tolist()) for i in range(1, STAGES))
PW, RW = tuple(PLACES_WRONG.tolist()), tuple(RATES_WRONG.tolist())
T2, T3, T4, T5 = TIMES[1:5].tolist()


@inline
def _set_law(el, link, i):
    """Set the law of a line on its branch: F = k e + c ė + F₀, and friction times the normal line's push."""
    branch = link.branch[i]
    stiffness, damping, constant, rubs = el.stiffness[i], el.damping[i], 0.0, 0.0
    if branch in (OPEN, SLIP_PLUS, SLIP_MINUS):
        stiffness = damping = 0.0
        if branch != OPEN:
            plus = branch == SLIP_PLUS
            side = 1.0 if plus else -1.0
            if slips_by_friction(el, i):
                pressed = link.branch[NORMAL] == MINUS or link.branch[NORMAL] == BOND
                rubs = side * el.friction if pressed else 0.0
            else:
                constant = side * limit(el, i, plus, 0.0)
    else:
        constant = stiffness * stretch(el, link, i, 0.0)
    link.stiffness[i], link.damping[i], link.constant[i], link.rubs[i] = stiffness, damping, constant, rubs


@inner
def set_laws(elements, links, contacts, case, s, foot):
    """Set the places of the elements' points about the fulcrum, and the laws of their lines."""
    con, corner = contacts[s.i], CORNER[s.i]
    x, z = con.cos * foot + con.sin * con.offset, con.sin * foot - con.cos * con.offset
    for n in range(elements.shape[0]):
        el, link = elements[n], links[n]
        u, v = el.u - case.u[corner], el.v - case.v[corner]
        link.du, link.dv, link.dx, link.dz = u, v, x - link.x, z - link.z
        nx, nz = -el.sin, el.cos
        for i in range(link.lines):
            link.p[i], link.q[i] = nx * u + nz * v, nx * v - nz * u
            _set_law(el, link, i)
            if el.kind != AXIAL:
                link.constant[i] += link.stiffness[i] * (nx * link.dx + nz * link.dz)
            nx, nz = el.cos, el.sin


@inline
def _moment(elements, links, sin, cos, omega):
    """Moment of the elements about the fulcrum."""
    moment = 0.0
    for n in range(elements.shape[0]):
        link = links[n]
        if link.lines == 0:
            continue
        if elements[n].kind == AXIAL:
            if link.branch[NORMAL] == OPEN:
                continue
            el = elements[n]
            right, up = link.du * cos + link.dv * sin, link.dv * cos - link.du * sin
            dx, dz = link.dx + right, link.dz + up
            far = math.sqrt(dx * dx + dz * dz)
            lever = (dx * up - dz * right) / far if far > 0.0 else 0.0
            e = far - el.length
            k, c = link.stiffness[NORMAL], link.damping[NORMAL]
            moment -= lever * (link.constant[NORMAL] + k * e + c * (omega * lever))
            continue
        F = 0.0
        for i in range(link.lines):
            if link.branch[i] == OPEN:
                continue
            p, q = link.p[i], link.q[i]
            lever = q * cos - p * sin
            push = link.rubs[i] * max(0.0, -F)
            e, rate = p * cos + q * sin, omega * lever
            F = link.constant[i] + link.stiffness[i] * e + link.damping[i] * rate + push
            moment -= lever * F
    return moment


@inline
def _alpha(elements, links, law, t, base, theta, omega):
    """Acceleration of the tilt a time t into the step."""
    sigma0, kappa0, q, A, A_rate, Γ, Γ_rate = law
    sin, cos = sin_cos(theta, base[0], base[1], base[2])
    sigma, kappa = sigma0 * cos - kappa0 * sin, kappa0 * cos + sigma0 * sin
    loads = kappa * (A + A_rate * t) + sigma * (Γ + Γ_rate * t)
    return q * (_moment(elements, links, sin, cos, omega) - loads)


@inner
def take_fulcrum_step(elements, links, contacts, case, s, work, base, load, y0, h):
    """Take a step as `stayput.mechanics.restrained.step.take_step`, of a body on a fulcrum that sticks."""
    con = contacts[s.i]
    A, Γ = along(con, load[0], load[2])
    A_rate, Γ_rate = along(con, load[1], load[3])
    q = 1.0 / (case.inertia + con.sigma * con.sigma + con.kappa * con.kappa)
    law = (con.sigma, con.kappa, q, A, A_rate, Γ, Γ_rate)
    th, w, hh = y0[2], y0[5], h * h
    t = T2 * h
    k1 = work.stage[0, 2]
    k2 = _alpha(elements, links, law, t, base, th + t * w, w + h * (R2[0] * k1))
    t = T3 * h
    place, rate = P3[0] * k1, R3[0] * k1 + R3[1] * k2
    k3 = _alpha(elements, links, law, t, base, th + (t * w + hh * place), w + h * rate)
    t = T4 * h
    place, rate = P4[0] * k1 + P4[1] * k2, R4[0] * k1 + R4[1] * k2 + R4[2] * k3
    k4 = _alpha(elements, links, law, t, base, th + (t * w + hh * place), w + h * rate)
    t = T5 * h
    place = P5[0] * k1 + P5[1] * k2 + P5[2] * k3
    rate = R5[0] * k1 + R5[1] * k2 + R5[2] * k3 + R5[3] * k4
    k5 = _alpha(elements, links, law, t, base, th + (t * w + hh * place), w + h * rate)
    place = P6[0] * k1 + P6[1] * k2 + P6[2] * k3 + P6[3] * k4
    rate = R6[0] * k1 + R6[1] * k2 + R6[2] * k3 + R6[3] * k4 + R6[4] * k5
    k6 = _alpha(elements, links, law, h, base, th + (h * w + hh * place), w + h * rate)
    place = P7[0] * k1 + P7[1] * k2 + P7[2] * k3 + P7[3] * k4 + P7[4] * k5
    rate = R7[0] * k1 + R7[2] * k3 + R7[3] * k4 + R7[4] * k5 + R7[5] * k6
    s.theta, s.omega = th + (h * w + hh * place), w + h * rate
    s.sin, s.cos = sin_cos(s.theta, base[0], base[1], base[2])
    sigma, kappa = arm(con, s)
    right, height = work.foot - sigma, kappa - con.offset
    s.x, s.z = con.cos * right - con.sin * height, con.sin * right + con.cos * height
    pivot_on(con, s)
    fx, fz, fl = measure(elements, links, s.sin, s.cos, s.x, s.z, s.vx, s.vz, s.omega)
    A, Γ = along(con, load[0] + load[1] * h - fx, load[2] + load[3] * h - fz)
    tangential, normal, k7, f, g = on_fulcrum(
        con, case, True, 0.0, s.sin, s.cos, s.vx, s.vz, s.omega, A, Γ, fl
    )
    end = work.stage[STAGES - 1]
    end[0], end[1] = con.cos * tangential - con.sin * normal, con.sin * tangential + con.cos * normal
    end[2] = k7
    place = PW[0] * k1 + PW[1] * k2 + PW[2] * k3 + PW[3] * k4 + PW[4] * k5 + PW[5] * k6
    rate = RW[0] * k1 + RW[2] * k3 + RW[3] * k4 + RW[4] * k5 + RW[5] * k6 + RW[6] * k7
    return f, g, hh * max(abs(place), abs(rate))
