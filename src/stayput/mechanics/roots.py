"""First zero of a smooth function within a step, from its values and derivatives at both ends."""

import math

from stayput.compiling import inline, inner

CONTACT_SLACK, SLACK_FORCE, SLACK_SLIP = 1e-13, 1e-8, 5e-11
"""Gap, force and slip rate at the start of a step up to which they are taken as just at their limit, beyond
which they must be by as much to count as an event [m, m/s², m/s]; see `level_of`.
"""

MIN_START_VALUE = 1e-9
"""Least starting value of a margin in a search, relative to its value at the end: keeps the secant off zero.
"""


PARTS = 8
"""Parts of a step in each of which a function may have a minimum."""


@inline
def level_of(margin, slack):
    """Value below which a margin is crossed in a step that starts with it.

    Rounding must not report a contact that has just been closed, and opens or rests, as closed again, nor a
    force that has just reached its limit. It counts only when it is beyond by a slack more, which takes time,
    so the event cannot repeat endlessly.
    """
    return 0.0 if margin > slack else min(margin, 0.0) - slack


@inline
def closed_level(g0):
    """Gap at which a contact counts as closed in a step that starts with the gap g0 [m]."""
    return level_of(g0, CONTACT_SLACK)


@inline
def hermite(g0, v0, c0, g1, v1, c1, h):
    """Coefficients, in u = τ/h, of the quintic Hermite interpolant of value, rate and second rate."""
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


@inline
def horner(quintic, u):
    """Value and derivative of a quintic, by Horner's scheme."""
    c0, c1, c2, c3, c4, c5 = quintic
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


@inline
def quintics(y0, k0, y1, k1, h):
    """Quintics of x, z and θ over a step between states with these accelerations."""
    return (
        hermite(y0[0], y0[3], k0[0], y1[0], y1[3], k1[0], h),
        hermite(y0[1], y0[4], k0[1], y1[1], y1[4], k1[1], h),
        hermite(y0[2], y0[5], k0[2], y1[2], y1[5], k1[2], h),
    )


@inline
def between(curves, h, t):
    """Interpolated state a time t into a step of length h."""
    u = t / h
    x, vx = horner(curves[0], u)
    z, vz = horner(curves[1], u)
    theta, omega = horner(curves[2], u)
    return x, z, theta, vx / h, vz / h, omega / h


@inner
def root_between(quintic, low, high):
    """Zero of a quintic from ``low``, where it is positive, to ``high``, where not: safeguarded Newton."""
    a0, a1, a2, _, _, _ = quintic
    root = math.sqrt(max(0.0, a1 * a1 - 4.0 * a2 * a0)) - a1
    u = 2.0 * a0 / root if root > 0.0 else high  # first guess: the zero of the parabola at the start
    if not low < u < high:
        u = high
    for _ in range(60):
        p, q = horner(quintic, u)
        if p > 0.0:
            low = u
        else:
            high = u
        new = u - p / q if q != 0.0 else low
        if not low < new < high:
            new = 0.5 * (low + high)
        if abs(new - u) <= 1e-6 * new:  # quadratic convergence: the next step would change it by 1e-12
            return new
        u = new
    return u


@inner
def lowest_inside(quintic, low, high):
    """Minimizer of a quintic that falls at ``low`` and rises at ``high``: safeguarded Newton."""
    _, _, a2, a3, a4, a5 = quintic
    u = 0.5 * (low + high)
    for _ in range(20):
        _, slope = horner(quintic, u)
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
    return u


@inline
def stays_positive(g0, v0, c0, g1, v1, c1, h):
    """Sufficient test that f, positive at the start, has no zero in the step; False is inconclusive."""
    if g1 < 0.0:
        return False
    if min(g0, g1) > 0.25 * h * h * max(abs(c0), abs(c1)):
        return True  # too large to dip to zero and return
    cm = 1.5 * (v1 - v0) / h - 0.25 * (c0 + c1)  # of the quintic's middle
    if max(c0, cm, c1) <= 0.0:
        return True  # concave: least at an end
    if min(c0, cm, c1) < 0.0:
        return False
    if v0 >= 0.0 or v1 <= 0.0:
        return True  # monotone
    return g0 * (v1 - v0) + v0 * (g0 - g1 + v1 * h) > 0.0  # convex: above where its tangents meet


@inner
def last_reversal(rate0, bend0, rate1, h):
    """Time in a step at which a rate changed last to the sign that it ends with, and its slope there.

    Both are of the parabola with these values at both ends and this slope at the start. Where that does not
    reverse, they are zero and infinity.
    """
    way = -math.copysign(1.0, rate1)
    rate, bend = way * rate0, way * bend0
    bow = -(abs(rate1) + rate + bend * h) / (h * h)
    disc = bend * bend - 4.0 * bow * rate
    if disc <= 0.0 or max(rate, bend) <= 0.0 or (rate <= 0.0 and bow >= 0.0):
        return 0.0, math.inf
    root = math.sqrt(disc)
    return min(h, -0.5 * (bend + root) / bow if bend > 0.0 else 2.0 * rate / (root - bend)), -way * root


@inline
def first_closing(g0, v0, c0, g1, v1, c1, h):
    """Time on (0, h] at which a gap first closes, or −1, and the gap at which it counts as closed.

    That is `closed_level`; a gap that starts closed, opens and returns closes at zero.

    Parameters
    ----------
    g0, v0, c0, g1, v1, c1 : float
        Gap, its first and second derivative at both ends.
    h : float
        Length of the step [s].
    """
    level = closed_level(g0)
    if stays_positive(g0 - level, v0, c0, g1 - level, v1, c1, h) and (level == 0.0 or g1 >= 0.0):
        return -1.0, level
    return _closing_of_quintic(hermite(g0, v0, c0, g1, v1, c1, h), level, h)


@inner
def _closing_of_quintic(quintic, level, h):
    """As `first_closing`, for the quintic of the gap."""
    u = _first_zero((quintic[0] - level, *quintic[1:]))
    if level < 0.0:
        high = u if u >= 0.0 else 1.0
        end, slope = horner(quintic, high)
        widest, _ = last_reversal(quintic[1], 2.0 * quintic[2], slope, high)
        if end < 0.0 and horner(quintic, widest)[0] > CONTACT_SLACK:
            return h * root_between(quintic, widest, high), 0.0
    return h * u if u >= 0.0 else -1.0, level


@inline
def _first_zero(quintic):
    """First zero on (0, 1] of a quintic that is positive at 0, or −1."""
    end, slope = horner(quintic, 1.0)
    if end < 0.0 and slope <= 0.0:
        return root_between(quintic, 0.0, 1.0)
    slope = quintic[1]
    for n in range(PARTS):  # a minimum lies where it falls and then rises; the first zero is before it
        u = (n + 1) / PARTS
        before, slope = slope, horner(quintic, u)[1]
        if before < 0.0 <= slope:
            low = lowest_inside(quintic, u - 1.0 / PARTS, u)
            if horner(quintic, low)[0] < 0.0:
                return root_between(quintic, 0.0, low)
    return root_between(quintic, 0.0, 1.0) if end < 0.0 else -1.0


@inner
def parabola_negative_at(f0, fm, f1):
    """Fraction of a step at which the parabola through start, middle and end is negative, or −1."""
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


@inline
def secant(low, f_low, high, f_high):
    """Secant estimate of a bracketed zero, kept off the ends of the bracket."""
    guess = low + (high - low) * f_low / (f_low - f_high)
    edge = 1e-3 * (high - low)
    if math.isnan(guess):
        guess = 0.5 * (low + high)
    return min(max(guess, low + edge), high - edge)


@inline
def illinois_update(bracket, t, f):
    """Update a bracket (low, its value, high, its value, last side) by f(t): the Illinois method.

    The value at an end retained twice is halved, so that the next secant falls beyond the zero (Dowell and
    Jarratt 1971).
    """
    low, f_low, high, f_high, side = bracket
    if f > 0.0:
        return t, f, high, (0.5 * f_high if side > 0 else f_high), 1
    return low, (0.5 * f_low if side < 0 else f_low), t, f, -1
