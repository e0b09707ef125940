"""Elementary functions with the same bits on every machine, and in a browser.

C libraries differ in the last bit of sine, cosine, exponential and logarithm. These functions are made of
additions, multiplications, divisions and square roots alone, which IEEE 754 defines to the bit. Sine and
cosine are within one unit in the last place, or 1e-25 where they are smaller than that can be of use.
"""

from __future__ import annotations

import math

from stayput.compiled import inline, inner

_TWO_OVER_PI = 2.0 / math.pi

# π/2 in two parts: the first has 33 bits, so that its product with a small whole number is exact
_HALF_PI, _HALF_PI_REST = 6746518852.0 / 2.0**32, 6.077100506506192e-11

# Taylor coefficients after x and 1 − x²/2; on |x| ≤ π/4 the first that is left out is below 1e-18
_S = tuple((-1.0) ** k / math.factorial(2 * k + 1) for k in range(1, 9))
_C = tuple((-1.0) ** k / math.factorial(2 * k) for k in range(2, 9))


@inner
def sine_and_cosine(x):
    """Sine and cosine of an angle up to 10⁵ [rad]: reduced to |r| ≤ π/4, then their Taylor series.

    Farther off they are less precise, and beyond 10⁹ they are those of zero: a trial step may turn the body
    so far, and is rejected, but by an error that is a number.
    """
    if 1e9 < abs(x) < math.inf:
        return 0.0, 1.0
    turns = math.floor(x * _TWO_OVER_PI + 0.5)
    high, low = x - turns * _HALF_PI, turns * _HALF_PI_REST
    r = high - low
    rest = (high - r) - low  # what r lacks
    z = r * r
    p = _S[1] + z * (_S[2] + z * (_S[3] + z * (_S[4] + z * (_S[5] + z * (_S[6] + z * _S[7])))))
    sin = r + (rest + r * z * (_S[0] + z * p))
    q = z * z * (_C[0] + z * (_C[1] + z * (_C[2] + z * (_C[3] + z * (_C[4] + z * (_C[5] + z * _C[6]))))))
    half = 0.5 * z
    most = 1.0 - half
    cos = most + (((1.0 - most) - half) + (q - r * rest))
    quarter = turns - 4.0 * math.floor(0.25 * turns)
    if quarter == 0.0:
        return sin, cos
    if quarter == 1.0:
        return cos, -sin
    if quarter == 2.0:
        return -sin, -cos
    return -cos, sin


@inner
def slope_angle(run, rise):
    """Angle of a line that rises by ``rise`` over ``run`` > 0 [rad]: Newton's method on the tangent."""
    t = rise / run
    angle = t / (1.0 + 0.28 * t * t)
    if abs(t) > 1.0:
        angle = math.copysign(0.5 * math.pi, t) - run / rise / (1.0 + 0.28 / (t * t))
    for _ in range(4):
        sin, cos = sine_and_cosine(angle)
        angle += (rise * cos - run * sin) / (run * cos + rise * sin)
    return angle


@inline
def fifth_root(x):
    """Fifth root of a positive number, to a hundredth: the length of a step needs no more."""
    a = math.sqrt(math.sqrt(math.sqrt(x)))
    b = math.sqrt(math.sqrt(math.sqrt(math.sqrt(a))))
    return a * math.sqrt(a) * b * math.sqrt(b)  # 1/5 = 1/8 + 1/16 + 1/128 + 1/256 + …


@inline
def sixth_root(x):
    """Sixth root of a positive number, to a hundredth."""
    a = math.sqrt(math.sqrt(math.sqrt(x)))
    b = math.sqrt(math.sqrt(a))
    c = math.sqrt(math.sqrt(b))
    return a * b * c * math.sqrt(math.sqrt(c))  # 1/6 = 1/8 + 1/32 + 1/128 + 1/512 + …
