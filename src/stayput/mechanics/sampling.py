"""Interpolation of the floor's motion between samples, and the history recorded at the samples."""

from __future__ import annotations

from stayput.compiling import inline, inner
from stayput.mechanics.columns import (
    FLIGHT,
    FLIGHT_MODE,
    FLOOR_BITS,
    H_MODE,
    H_REACHED,
    H_SLIDE,
    H_SLIDE_RATE,
    H_TILT,
    H_TILT_RATE,
    H_X,
    H_Z,
    LEAN_MODE,
    REST,
    REST_MODE,
    ROCK,
    ROCK_MODE,
    SLIDE,
    SLIDE_MODE,
    SLIDE_ROCK,
    SLIDE_ROCK_MODE,
)
from stayput.mechanics.geometry import slide_of


@inline
def loads(case, ax, az, per_second, k, tau):
    """Floor acceleration and g + z̈_G at a time tau after sample k, with their rates.

    ``per_second`` is the scale factor of the motion divided by the time step [1/s].
    """
    a_rate = per_second * (ax[k + 1] - ax[k])
    G_rate = per_second * (az[k + 1] - az[k])
    return case.scale * ax[k] + a_rate * tau, a_rate, case.gravity + case.scale * az[k] + G_rate * tau, G_rate


@inline
def lowest_product(p, low, high):
    """Minimum of p × value over values between low and high, as of a load within a block of the record."""
    return p * low if p >= 0.0 else p * high


@inner
def public_mode(s):
    """Public mode (`stayput.Mode`) of the state."""
    on_floor = s.closed & FLOOR_BITS
    if s.kind == REST:
        return REST_MODE if on_floor == FLOOR_BITS else LEAN_MODE
    if not on_floor:
        return FLIGHT_MODE
    if s.kind == SLIDE:
        return SLIDE_MODE
    if s.kind == ROCK:
        return ROCK_MODE
    if s.kind == SLIDE_ROCK:
        return SLIDE_ROCK_MODE
    return FLIGHT_MODE if s.kind == FLIGHT else LEAN_MODE


@inner
def record_sample(history, case, s):
    """Write the state into the history's row of sample k, unless no history is kept."""
    if history.shape[0] == 0:
        return
    row = history[s.k]
    row[H_X], row[H_Z], row[H_TILT], row[H_TILT_RATE] = s.x, s.z, s.theta - s.rest, s.omega
    row[H_SLIDE], row[H_SLIDE_RATE] = slide_of(case, s)
    row[H_MODE], row[H_REACHED] = public_mode(s), 1.0


@inline
def advance_clock(s, h, dt):
    """Advance the clock by a step that ends no later than the next sample; True at the sample."""
    if s.tau + h >= dt * (1.0 - 1e-14):  # rounding must not leave a sliver of a step before the sample
        s.k += 1
        s.tau = 0.0
        return True
    s.tau += h
    return False
