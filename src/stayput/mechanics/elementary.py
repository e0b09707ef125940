"""Elementary functions with the same bits on every machine.

C libraries differ in the last bit of sine, cosine, exponential and logarithm. These functions are made of
additions, multiplications, divisions and square roots alone, which IEEE 754 defines to the bit. Sine and
cosine are within one unit in the last place, or 1e-25 where they are smaller than that can be of use.
"""

from __future__ import annotations

import math

from stayput.compiling import inline, inner

_TWO_OVER_PI = 2.0 / math.pi

# π/2 in two parts: the first has 33 bits, so that its product with a small whole number is exact
_HALF_PI, _HALF_PI_REST = 6746518852.0 / 2.0**32, 6.077100506506192e-11

_ONE_OVER_LN_2 = 1.0 / math.log(2.0)

# ln 2 in two parts, the first of 32 bits
_LN_2, _LN_2_REST = 2977044471.0 / 2.0**32, 1.9082149292705877e-10

# Taylor coefficients after x and 1 − x²/2; on |x| ≤ π/4 the first that is left out is below 1e-18
_S = tuple((-1.0) ** k / math.factorial(2 * k + 1) for k in range(1, 9))
_C = tuple((-1.0) ** k / math.factorial(2 * k) for k in range(2, 9))

# of the exponential, from x²/2 on; on |x| ≤ ln 2/2 the first that is left out is below 1e-18
_E = tuple(1.0 / math.factorial(k) for k in range(2, 14))


@inner
def sine_and_cosine(x: float) -> tuple[float, float]:
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
def _power_of_two(n):
    """2ⁿ for a whole number |n| ≤ 1022."""
    power, factor = 1.0, 2.0 if n > 0 else 0.5
    left = abs(n)
    while left > 0:
        if left & 1:
            power *= factor
        factor *= factor
        left >>= 1
    return power


@inner
def exponential(x: float) -> float:
    """Exponential of a number, within a unit in the last place: 2ⁿ times the Taylor series of x − n ln 2."""
    if not -746.0 < x < 710.0:  # too small or too large for a number, or none
        return 0.0 if x < 0.0 else x * math.inf
    times = math.floor(x * _ONE_OVER_LN_2 + 0.5)
    high, low = x - times * _LN_2, times * _LN_2_REST
    r = high - low
    rest = (high - r) - low  # what r lacks
    p = _E[4] + r * (
        _E[5] + r * (_E[6] + r * (_E[7] + r * (_E[8] + r * (_E[9] + r * (_E[10] + r * _E[11])))))
    )
    p = r * (_E[0] + r * (_E[1] + r * (_E[2] + r * (_E[3] + r * p))))
    value = 1.0 + (r + (rest + r * p))
    n = int(times)
    half = n // 2  # 2ⁿ itself may be beyond the largest number, or below the smallest
    return value * _power_of_two(half) * _power_of_two(n - half)


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
