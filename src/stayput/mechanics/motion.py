"""The floor's motion at an instant, and what is noted at the record's samples."""

from __future__ import annotations

from stayput.compiled import inline, inner
from stayput.mechanics.columns import (
    FLAT,
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
    HELD,
    LEAN_MODE,
    REST_MODE,
    ROCK_MODE,
    SLIDE_MODE,
    SLIDE_ROCK_MODE,
    SLIP,
    STICK,
)
from stayput.mechanics.geometry import slide_of


@inline
def loads(case, ax, az, per_second, k, tau):
    """Floor acceleration and g + z̈_G in the sample k after a time tau, with their rates.

    ``per_second`` is the factor on the motion over the time between samples [1/s].
    """
    a_rate = per_second * (ax[k + 1] - ax[k])
    G_rate = per_second * (az[k + 1] - az[k])
    return case.scale * ax[k] + a_rate * tau, a_rate, case.gravity + case.scale * az[k] + G_rate * tau, G_rate


@inner
def named_mode(s):
    """The state's mode, as the user knows it."""
    on_floor = s.closed & FLOOR_BITS
    if s.kind == HELD:
        return REST_MODE if on_floor == FLOOR_BITS else LEAN_MODE
    if not on_floor:
        return FLIGHT_MODE
    if s.kind == FLAT:
        return SLIDE_MODE
    if s.kind == STICK:
        return ROCK_MODE
    if s.kind == SLIP:
        return SLIDE_ROCK_MODE
    return FLIGHT_MODE if s.kind == FLIGHT else LEAN_MODE


@inner
def note_sample(history, case, s):
    """Write the state down, when the time is that of a sample and a history is kept."""
    if history.shape[0] == 0:
        return
    row = history[s.k]
    row[H_X], row[H_Z], row[H_TILT], row[H_TILT_RATE] = s.x, s.z, s.theta, s.omega
    row[H_SLIDE], row[H_SLIDE_RATE] = slide_of(case, s)
    row[H_MODE], row[H_REACHED] = named_mode(s), 1.0


@inline
def pass_time(s, h, dt):
    """Move the clock by a step that ends at, or before, the next sample; True at the sample."""
    if s.tau + h >= dt * (1.0 - 1e-14):
        s.k += 1
        s.tau = 0.0
        return True
    s.tau += h
    return False
