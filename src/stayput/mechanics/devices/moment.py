"""Moment of all lines about a sticking fulcrum, as one function of the tilt and its rate, and its series.

A line of fixed direction has the elongation e = a + p cos θ + q sin θ and the lever l = q cos θ − p sin θ,
and its force is linear in e and ė = θ̇ l. So the moments −F l of all such lines add up to eight coefficients:

    M = m₀ + m₁ cos θ + m₂ sin θ + m₃ cos 2θ + m₄ sin 2θ + θ̇ (m₅ + m₆ cos 2θ + m₇ sin 2θ)

The direction of an AXIAL line turns, but the square of its point's distance d from the anchor is
d² = a² + β cos θ + γ sin θ, and its lever d' = ½ (γ cos θ − β sin θ)/d; its moment is −(F/d) ½ (d²)'.

With the loads linear in time, all of these are power series, whose coefficients follow one after the other.
"""

import math

import numpy as np

from stayput.compiling import inline, inner
from stayput.mechanics.devices.columns import BOND, FRICTION, NORMAL, ORDER, SLACK
from stayput.mechanics.elementary import fifth_root

LEAST_ORDER = 6
"""Terms of the tilt that are always computed."""

LAST_TERM = 0.3
"""Largest last term of the tilt, as a part of the tolerance: the rate's is as many times larger as there are
terms.
"""

WAVY = 0.01
"""Part of the second and third terms above which the others make a step wavy."""

OVER = np.array([1.0 / max(1, n) for n in range(ORDER + 2)])
"""1/n."""


@inline
def _add_product(m, factor, at_0, k, c, first, second):
    """Add factor × (at_0 + k (p cos θ + q sin θ) + c θ̇ (q cos θ − p sin θ)) (q' cos θ − p' sin θ).

    ``first`` is (p, q), ``second`` is (p', q').
    """
    p, q = first
    p2, q2 = second
    cosine, sine = 0.5 * (p * q2 + q * p2), 0.5 * (q * q2 - p * p2)
    k, c = factor * k, factor * c
    m[0] += 0.5 * k * (p * q2 - q * p2)
    m[1] += factor * at_0 * q2
    m[2] -= factor * at_0 * p2
    m[3] += k * cosine
    m[4] += k * sine
    m[5] += 0.5 * c * (q * q2 + p * p2)
    m[6] += c * sine
    m[7] -= c * cosine


@inline
def _divide_bond(normal, F):
    """Let a bonded normal line, beside which friction slips, end its branch where push turns into pull.

    There the friction has a kink, which a series cannot pass.
    """
    if F < 0.0:
        normal.high_at_0 = 0.0
    else:
        normal.bears_friction, normal.low_at_0 = 0, 0.0


@inner
def sum_lines(links, work):
    """Sum up the moments of the lines of fixed direction, and list the AXIAL ones, about the fulcrum."""
    m = work.moment
    for j in range(8):
        m[j] = 0.0
    work.axials = 0
    for r in range(work.lines):
        line = work.line[r]
        if line.state == SLACK:
            continue
        if line.axial != 0:
            work.axial[work.axials].row = r
            work.axials += 1
        elif line.state == FRICTION:
            normal, link = work.line[r - 1], links[line.element]
            if link.branch[NORMAL] == BOND:
                _divide_bond(normal, link.force[NORMAL])
            if normal.bears_friction != 0:  # the push of the normal line is −F
                at_0 = normal.constant + normal.k * normal.a
                first, second = (normal.p, normal.q), (line.p, line.q)
                _add_product(m, line.per_push, at_0, normal.k, normal.c, first, second)
        else:
            place = line.p, line.q
            _add_product(m, -1.0, line.constant + line.k * line.a, line.k, line.c, place, place)


@inline
def _begin_axial(work, sin, cos):
    """Set the zeroth coefficients of the AXIAL lines."""
    for axial in work.axial[: work.axials]:
        line = work.line[axial.row]
        x, z = line.x, line.z
        # the point is at (u cos θ + v sin θ, v cos θ − u sin θ)
        axial.beta, axial.gamma = -2.0 * (line.u * x + line.v * z), 2.0 * (line.u * z - line.v * x)
        dx, dz = line.u * cos + line.v * sin - x, line.v * cos - line.u * sin - z
        axial.far[0] = math.sqrt(dx * dx + dz * dz)


@inline
def _axial_moment(work, n, lane):
    """Coefficient n of the moment of the AXIAL lines; that of cosine and sine is known up to n + 1."""
    moment = 0.0
    for axial in work.axial[: work.axials]:
        line = work.line[axial.row]
        far, beta, gamma = axial.far, axial.beta, axial.gamma
        over = 1.0 / far[0]
        product = 0.0
        for i in range(1, n + 1):
            product += far[i] * far[n + 1 - i]
        far[n + 1] = 0.5 * over * (beta * lane[n + 1, 0] + gamma * lane[n + 1, 1] - product)
        F = line.k * far[n] + (n + 1) * line.c * far[n + 1]
        if n == 0:
            F += line.constant + line.k * line.a
        for i in range(1, n + 1):
            F -= far[i] * axial.pull[n - i]
        axial.pull[n] = F * over
        axial.lever[n] = 0.5 * (gamma * lane[n, 0] - beta * lane[n, 1])
        for i in range(n + 1):
            moment -= axial.lever[i] * axial.pull[n - i]
    return moment


@inner
def expand_tilt(work, con, q, load, theta, omega, sin, cos, h, tolerance):
    """Set the coefficients of the tilt and of its rate about a sticking fulcrum, from its state.

    There are as many as a step of length h needs, or `ORDER`; returns the longest step, at most h, whose last
    two terms of the tilt are within the tolerance.

    Parameters
    ----------
    q : float
        1/(I + r²).
    load : tuple of float
        A, its rate, Γ, its rate.
    tolerance : float
        Largest error of the step [rad].
    """
    A, A_rate, Γ, Γ_rate = load
    m, tilt, rate, lane = work.moment, work.tilt, work.rate, work.lane
    # −κ A − σ Γ with κ = κ₀ cos θ + σ₀ sin θ and σ = σ₀ cos θ − κ₀ sin θ
    of_cos, of_sin = m[1] - (con.kappa * A + con.sigma * Γ), m[2] - (con.sigma * A - con.kappa * Γ)
    of_cos_rate, of_sin_rate = (
        con.kappa * A_rate + con.sigma * Γ_rate,
        con.sigma * A_rate - con.kappa * Γ_rate,
    )
    lane[0, 0], lane[0, 1] = cos, sin
    lane[0, 2], lane[0, 3] = cos * cos - sin * sin, 2.0 * sin * cos
    tilt[0], tilt[1], rate[0] = theta, omega, omega
    _begin_axial(work, sin, cos)
    power, before, last, order = h, 0.0, math.inf, 1
    most = LAST_TERM * tolerance
    while order < ORDER:
        n = order - 1
        a = b = c = d = 0.0  # coefficients n of θ̇ times cos θ, sin θ, cos 2θ, sin 2θ
        k = 0
        while k < n:  # two terms at a time
            w, v, row = rate[k], rate[k + 1], n - k
            a += w * lane[row, 0] + v * lane[row - 1, 0]
            b += w * lane[row, 1] + v * lane[row - 1, 1]
            c += w * lane[row, 2] + v * lane[row - 1, 2]
            d += w * lane[row, 3] + v * lane[row - 1, 3]
            k += 2
        if k == n:
            w = rate[n]
            a, b, c, d = a + w * lane[0, 0], b + w * lane[0, 1], c + w * lane[0, 2], d + w * lane[0, 3]
        over = OVER[order]
        lane[order, 0], lane[order, 1] = -over * b, over * a
        lane[order, 2], lane[order, 3] = -2.0 * over * d, 2.0 * over * c
        moment = of_cos * lane[n, 0] + of_sin * lane[n, 1] + (m[3] * lane[n, 2] + m[4] * lane[n, 3])
        if n == 0:
            moment += m[0]
        else:
            moment -= of_cos_rate * lane[n - 1, 0] + of_sin_rate * lane[n - 1, 1]
        if work.axials > 0:
            moment += _axial_moment(work, n, lane)
        moment += m[5] * rate[n] + (m[6] * c + m[7] * d)
        rate[order] = q * over * moment
        order += 1
        tilt[order] = OVER[order] * rate[order - 1]
        power *= h
        before, last = last, abs(tilt[order]) * power
        if order >= LEAST_ORDER and max(last, 0.1 * before) <= most:
            break
    work.order = order
    last = max(last, 0.1 * before)
    if last <= most:
        return h
    return h * (0.95 * fifth_root(math.sqrt(most / last)))


@inline
def tilt_at(work, t):
    """Tilt and tilt rate a time t into the step: Horner's scheme for even and odd powers."""
    tilt, rate = work.tilt, work.rate
    i = work.order - 1  # made odd, by a coefficient that is zero
    square = t * t
    if i & 1 == 0:
        even, odd = tilt[i], tilt[i + 1]
        even_rate, odd_rate = rate[i], 0.0
    else:
        i += 1
        even, odd = tilt[i], 0.0
        even_rate = odd_rate = 0.0
    while i > 0:
        i -= 2
        even, odd = even * square + tilt[i], odd * square + tilt[i + 1]
        even_rate, odd_rate = even_rate * square + rate[i], odd_rate * square + rate[i + 1]
    return even + t * odd, even_rate + t * odd_rate


@inline
def deviation_from_cubic(work, h):
    """Bound on how far the tilt deviates in a step from the cubic through its values and rates at both ends.

    That of tⁿ is at most (n − 2)(n − 3)/32 hⁿ, since u²(1 − u)² ≤ 1/16.
    """
    tilt = work.tilt
    bound, power = 0.0, h * h * h
    for n in range(4, work.order + 1):
        power *= h
        bound += (n - 2) * (n - 3) * abs(tilt[n]) * power
    return bound * (1.0 / 32.0)


@inline
def is_wavy(work, h, beyond):
    """Whether the tilt deviates from the cubic by a notable part of how far that deviates from the chord."""
    tilt = work.tilt
    return beyond > WAVY * (h * h * (abs(tilt[2]) + h * abs(tilt[3])))
