"""The first zero of a smooth function on a step, from its values and rates at both ends."""

from __future__ import annotations

import math

from stayput.mechanics.compiled import inner

TOUCHING = 1e-12
"""A value that is not larger than this counts as zero at the start of a step [m, rad]."""


@inner
def hermite(g0, v0, c0, g1, v1, c1, h):
    """Coefficients, in u = τ/h, of the quintic with these values, rates and second rates at both ends."""
    a1, a2 = v0 * h, 0.5 * c0 * h * h
    b1, b2 = v1 * h, c1 * h * h
    e0 = g1 - g0 - a1 - a2
    e1 = b1 - a1 - 2.0 * a2
    e2 = b2 - 2.0 * a2
    return (
        g0,
        a1,
        a2,
        10.0 * e0 - 4.0 * e1 + 0.5 * e2,
        -15.0 * e0 + 7.0 * e1 - e2,
        6.0 * e0 - 3.0 * e1 + 0.5 * e2,
    )


@inner
def horner(c0, c1, c2, c3, c4, c5, u):
    """Value and derivative of a quintic."""
    p = c5
    q = p
    p = p * u + c4
    q = q * u + p
    p = p * u + c3
    q = q * u + p
    p = p * u + c2
    q = q * u + p
    p = p * u + c1
    q = q * u + p
    return p * u + c0, q


@inner
def root_between(c0, c1, c2, c3, c4, c5, low, high):
    """Zero of a quintic between ``low``, where it is positive, and ``high``, where it is not."""
    u = 0.5 * (low + high)
    for _ in range(60):
        p, q = horner(c0, c1, c2, c3, c4, c5, u)
        if p > 0.0:
            low = u
        else:
            high = u
        if q != 0.0:
            new = u - p / q
        else:
            new = low
        if not low < new < high:
            new = 0.5 * (low + high)
        if abs(new - u) <= 1e-14:
            return new
        u = new
    return u


@inner
def first_zero(g0, v0, c0, g1, v1, c1, h):
    """Time of the first zero that a positive function falls through on (0, h], or −1.

    The function may start at zero (a contact that has just opened); that zero is divided out.
    Between the ends its second rate is taken to change sign at most once.

    Parameters
    ----------
    g0, v0, c0, g1, v1, c1 : float
        Value, rate and second rate at both ends.
    h : float
        Length of the step [s].

    Returns
    -------
    float
        Time since the start of the step [s]; −1 where there is no zero; 0 where the function falls from
        its start.
    """
    if g1 >= -TOUCHING and not (c0 > 0.0 or c1 > 0.0):
        return -1.0  # concave: smallest at an end
    if g1 > TOUCHING and g0 > TOUCHING and v0 >= 0.0 and c0 >= 0.0 and v1 >= 0.0:
        return -1.0
    a0, a1, a2, a3, a4, a5 = hermite(g0, v0, c0, g1, v1, c1, h)
    # the first place where the function is negative: the end, or a minimum inside
    last = 1.0 if g1 < -TOUCHING else -1.0
    bend = c0 / (c0 - c1) if c0 * c1 < 0.0 else 1.0
    left, right = (0.0, bend) if c0 > 0.0 or bend == 1.0 else (bend, 1.0)  # the convex part
    _, slope_left = horner(a0, a1, a2, a3, a4, a5, left)
    _, slope_right = horner(a0, a1, a2, a3, a4, a5, right)
    if slope_left < 0.0 < slope_right:
        low, high = left, right
        u = left + (right - left) * slope_left / (slope_left - slope_right)
        for _ in range(20):
            _, slope = horner(a0, a1, a2, a3, a4, a5, u)
            bend = 2.0 * a2 + u * (6.0 * a3 + u * (12.0 * a4 + u * 20.0 * a5))
            if slope < 0.0:
                low = u
            else:
                high = u
            new = u - slope / bend if bend > 0.0 else 0.5 * (low + high)
            if not low < new < high:
                new = 0.5 * (low + high)
            if abs(new - u) < 1e-7:
                break
            u = new
        value, _ = horner(a0, a1, a2, a3, a4, a5, u)
        if value < -TOUCHING:
            last = u
    if last < 0.0:
        return -1.0
    if g0 > TOUCHING:
        return h * root_between(a0, a1, a2, a3, a4, a5, 0.0, last)
    # starts at zero: divide it out, twice if it starts with no rate, three times if with no second rate
    if a1 > 1e-15:
        return h * root_between(a1, a2, a3, a4, a5, 0.0, 0.0, last)
    if a1 < -1e-15:
        return 0.0
    if a2 > 1e-16:
        return h * root_between(a2, a3, a4, a5, 0.0, 0.0, 0.0, last)
    if a2 < -1e-16 or a3 <= 0.0:
        return 0.0
    return h * root_between(a3, a4, a5, 0.0, 0.0, 0.0, 0.0, last)


@inner
def falls_inside(f0, fm, f1):
    """Where, as a fraction of a step, a function with these values at start, middle and end is negative.

    Returns −1 where the parabola through them is nowhere negative.
    """
    if fm < 0.0:
        return 0.5
    curvature = 2.0 * (f0 - 2.0 * fm + f1)
    slope = f1 - f0 - curvature
    if curvature > 0.0 and slope < 0.0 < slope + 2.0 * curvature:
        u = -0.5 * slope / curvature
        if f0 + u * (slope + curvature * u) < 0.0:
            return u
    if f1 < 0.0:
        return 1.0
    return -1.0


@inner
def illinois(low, f_low, high, f_high):
    """Next guess of a bracketed zero by the secant, kept off the ends of the bracket."""
    guess = low + (high - low) * f_low / (f_low - f_high)
    edge = 1e-3 * (high - low)
    if math.isnan(guess):
        guess = 0.5 * (low + high)
    return min(max(guess, low + edge), high - edge)
