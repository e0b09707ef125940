"""One integration step by the Dormand–Prince method of order 5(4), with its error estimate.

After the step the state is projected back onto the constraints of the mode: a sticking corner stays where it
was, a slipping one on its plane. Dense output is the quintic Hermite interpolant of position, rate and
acceleration.
"""

from __future__ import annotations

from stayput.compiling import inline, inner
from stayput.mechanics.columns import LEAN, ROCK, SLIDE, SLIDE_ROCK
from stayput.mechanics.devices.accelerations import accelerations, evaluate_at
from stayput.mechanics.devices.dormand_prince import (
    POSITIONS,
    POSITIONS_ERROR,
    RATES,
    RATES_ERROR,
    STAGES,
    TIMES,
)
from stayput.mechanics.devices.rocking_step import (
    evaluate_on_fulcrum,
    margins_on_fulcrum,
    stand_on_fulcrum,
)
from stayput.mechanics.geometry import sin_cos
from stayput.mechanics.projection import project_on_both, project_on_plane


@inline
def _weighted_sums(stage, i, c):
    """Weighted sums of the accelerations of the stages before i, for its position and its rate."""
    place = rate = 0.0
    for j in range(i):
        place, rate = place + POSITIONS[i, j] * stage[j, c], rate + RATES[i, j] * stage[j, c]
    return place, rate


@inner
def take_free_step(contacts, rows, case, s, work, base, load, y0, k0, h):
    """Set the state to that a time h after the state y0 with accelerations k0.

    On a flat base only the position is integrated.

    Returns
    -------
    tuple
        At the end: accelerations, the contacts' two margins, the lines' least margin; and the error estimate,
        the largest of positions and h times rates [m, rad].
    """
    x0, z0, theta0, vx0, vz0, omega0 = y0
    stage = work.stage
    stage[0, 0], stage[0, 1], stage[0, 2] = k0
    turns = s.kind != SLIDE
    for i in range(1, STAGES):
        t = h * TIMES[i]
        if turns:
            place, rate = _weighted_sums(stage, i, 2)
            s.theta, s.omega = theta0 + (t * omega0 + h * h * place), omega0 + h * rate
            s.sin, s.cos = sin_cos(s.theta, base[0], base[1], base[2])
        place, rate = _weighted_sums(stage, i, 0)
        s.x, s.vx = x0 + (t * vx0 + h * h * place), vx0 + h * rate
        place, rate = _weighted_sums(stage, i, 1)
        s.z, s.vz = z0 + (t * vz0 + h * h * place), vz0 + h * rate
        if i < STAGES - 1:
            stage[i, 0], stage[i, 1], stage[i, 2], _, _ = accelerations(
                contacts, rows, case, s, work, load, t
            )
    project_on_constraints(contacts, case, s, work)
    end, f, g, least = evaluate_at(contacts, rows, case, s, work, load, h)
    stage[STAGES - 1, 0], stage[STAGES - 1, 1], stage[STAGES - 1, 2] = end
    error = 0.0
    for c in range(3 if turns else 2):
        place = rate = 0.0
        for j in range(STAGES):
            place, rate = place + POSITIONS_ERROR[j] * stage[j, c], rate + RATES_ERROR[j] * stage[j, c]
        error = max(error, h * h * max(abs(place), abs(rate)))
    return end, f, g, least, error


@inner
def evaluate_state(contacts, rows, case, s, work, load, t):
    """Accelerations, the contacts' two margins and the lines' least margin in the state of s."""
    if s.kind == ROCK:
        return evaluate_on_fulcrum(contacts[s.i], case, s, work, load, t)
    return evaluate_at(contacts, rows, case, s, work, load, t)


@inner
def contact_margins(contacts, rows, case, s, work, load, t):
    """The contacts' two margins in the state of s; stores nothing."""
    if s.kind == ROCK:
        return margins_on_fulcrum(contacts[s.i], case, s, work, load, t)
    _, _, _, f, g = accelerations(contacts, rows, case, s, work, load, t)
    return f, g


@inline
def set_state(s, y, base):
    """Write (x, z, θ, ẋ, ż, θ̇) into the state record."""
    s.x, s.z, s.theta, s.vx, s.vz, s.omega = y
    s.sin, s.cos = sin_cos(y[2], base[0], base[1], base[2])


@inline
def state_of(s):
    """Read (x, z, θ, ẋ, ż, θ̇) from the state record."""
    return s.x, s.z, s.theta, s.vx, s.vz, s.omega


@inner
def project_on_constraints(contacts, case, s, work):
    """Project the state onto the mode's constraints: contacts on their planes, a sticking corner in place."""
    if s.kind == ROCK:
        stand_on_fulcrum(contacts[s.i], s, work.foot)
    elif s.kind == SLIDE_ROCK or s.kind == SLIDE:
        project_on_plane(contacts[s.i], s)
    elif s.kind == LEAN:
        project_on_both(contacts[s.i], contacts[s.j], case.inertia, s)
