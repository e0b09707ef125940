"""One step of a body that moves: the method of Dormand and Prince, of fifth order, with its error.

After the step the constraints of the mode are met exactly again: a corner that sticks is where it was, one
that slips on its plane. Between both ends the motion is the quintic through places, rates and accelerations.
"""

from __future__ import annotations

from stayput.compiled import inline, inner
from stayput.mechanics.columns import FLAT, SLIP, STICK, WEDGE
from stayput.mechanics.geometry import sin_cos
from stayput.mechanics.modes import close_both, stay_on_plane
from stayput.mechanics.restrained.dormand_prince import (
    PLACES,
    PLACES_WRONG,
    RATES,
    RATES_WRONG,
    STAGES,
    TIMES,
)
from stayput.mechanics.restrained.fulcrum_step import (
    measure_on_fulcrum,
    stand_on_fulcrum,
    take_fulcrum_step,
)
from stayput.mechanics.restrained.rates import accelerations, measure_at
from stayput.mechanics.roots import hermite, horner


@inline
def _weighed(stage, i, c):
    """Sums of the accelerations of the stages before i that make its place and its rate."""
    place = rate = 0.0
    for j in range(i):
        place, rate = place + PLACES[i, j] * stage[j, c], rate + RATES[i, j] * stage[j, c]
    return place, rate


@inline
def take_step(contacts, rows, case, s, work, base, load, y0, k0, h):
    """Set the state to that a time h after y0, with the accelerations k0.

    On a fulcrum that sticks only the tilt is integrated, on a flat base only the place.

    Returns
    -------
    tuple
        At the end the accelerations, the contacts' two margins and the lines' least one; the error, of places
        and of h times their rates [m, rad].
    """
    if s.kind == STICK:
        return take_fulcrum_step(contacts[s.i], case, s, work, base, load, y0[5], k0[2], h)
    return _take_free_step(contacts, rows, case, s, work, base, load, y0, k0, h)


@inner
def _take_free_step(contacts, rows, case, s, work, base, load, y0, k0, h):
    x0, z0, theta0, vx0, vz0, omega0 = y0
    stage = work.stage
    stage[0, 0], stage[0, 1], stage[0, 2] = k0
    turns = s.kind != FLAT
    for i in range(1, STAGES):
        t = h * TIMES[i]
        if turns:
            place, rate = _weighed(stage, i, 2)
            s.theta, s.omega = theta0 + (t * omega0 + h * h * place), omega0 + h * rate
            s.sin, s.cos = sin_cos(s.theta, base[0], base[1], base[2])
        place, rate = _weighed(stage, i, 0)
        s.x, s.vx = x0 + (t * vx0 + h * h * place), vx0 + h * rate
        place, rate = _weighed(stage, i, 1)
        s.z, s.vz = z0 + (t * vz0 + h * h * place), vz0 + h * rate
        if i < STAGES - 1:
            stage[i, 0], stage[i, 1], stage[i, 2], _, _ = accelerations(
                contacts, rows, case, s, work, load, t
            )
    meet_constraints(contacts, case, s, work)
    end, f, g, least = measure_at(contacts, rows, case, s, work, load, h)
    stage[STAGES - 1, 0], stage[STAGES - 1, 1], stage[STAGES - 1, 2] = end
    error = 0.0
    for c in range(3 if turns else 2):
        place = rate = 0.0
        for j in range(STAGES):
            place, rate = place + PLACES_WRONG[j] * stage[j, c], rate + RATES_WRONG[j] * stage[j, c]
        error = max(error, h * h * max(abs(place), abs(rate)))
    return end, f, g, least, error


@inner
def measure_here(contacts, rows, case, s, work, load, t):
    """In the state of s: accelerations, the contacts' two margins and the lines' least one."""
    if s.kind == STICK:
        return measure_on_fulcrum(contacts[s.i], case, s, work, load, t)
    return measure_at(contacts, rows, case, s, work, load, t)


@inline
def set_state(s, y, base):
    """Put a state into the record."""
    s.x, s.z, s.theta, s.vx, s.vz, s.omega = y
    s.sin, s.cos = sin_cos(y[2], base[0], base[1], base[2])


@inline
def state_of(s):
    """(x, z, θ, ẋ, ż, θ̇) of the record."""
    return s.x, s.z, s.theta, s.vx, s.vz, s.omega


@inner
def meet_constraints(contacts, case, s, work):
    """Put a state back to the planes on which the mode's contacts slip, or to the place where one sticks."""
    if s.kind == STICK:
        stand_on_fulcrum(contacts[s.i], s, work.foot)
    elif s.kind == SLIP or s.kind == FLAT:
        stay_on_plane(contacts[s.i], s)
    elif s.kind == WEDGE:
        close_both(contacts[s.i], contacts[s.j], case.inertia, s)


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
    """State a time t into a step of length h."""
    u = t / h
    x, vx = horner(curves[0], u)
    z, vz = horner(curves[1], u)
    theta, omega = horner(curves[2], u)
    return x, z, theta, vx / h, vz / h, omega / h
