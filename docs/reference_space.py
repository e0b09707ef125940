"""Reference cases in space for the validation page: closed forms, and what `simulate` computes in space.

As in `reference_cases`, each function is a case and its docstring the page's text. The derivations stand with
the tests: `tests/validation/test_space_*.py` and `test_rolling_disc.py`. g = 9.80665 m/s².
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from reference_setup import CLOSED, Row, still
from scipy.special import ellipk

import stayput as sp

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from numpy.typing import NDArray

G = 9.80665
STICKING = sp.Room(sp.Floor(5.0, 5.0, rolling_resistance=0.0))


def tilted(cylinder: sp.Body, angle: float) -> tuple[sp.Body, NDArray[np.float64]]:
    """Return an upright cylinder that begins tilted towards x, and its axis."""
    c, s = math.cos(angle), math.sin(angle)
    turn = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
    rims = cylinder.solid.rims
    body = sp.Body.hull(
        cylinder.solid.vertices @ turn.T,
        cylinder.mass,
        centre_of_gravity=turn @ cylinder.solid.centre_of_gravity,
        inertia=turn @ cylinder.solid.inertia @ turn.T,
        rims=np.column_stack((rims[:, :3] @ turn.T, rims[:, 3:6] @ turn.T, rims[:, 6])),
    )
    return body, turn[:, 2]


def rolled(
    cylinder: sp.Body, angle: float, rotation: NDArray[np.float64], duration: float, step: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return tilts and directions [rad] of a cylinder that begins tilted on its rim and rolls at ω."""
    body, n = tilted(cylinder, angle)
    r, d = float(cylinder.solid.rims[0, 6]), float(cylinder.solid.centre_of_gravity[2])
    lever = r * np.array([math.cos(angle), 0.0, -math.sin(angle)]) - d * n
    velocity = tuple(-np.cross(rotation, lever))
    start = sp.Piece(
        body, (0.0, 0.0, r * math.sin(angle) + 1e-9), velocity=velocity, rotation_rate=tuple(rotation)
    )
    run = sp.simulate(start, STICKING, still(duration, duration / 4000), step=step)
    axis = run.turn[0] @ n
    return np.arccos(np.clip(axis[:, 2], -1.0, 1.0)), np.unwrap(np.arctan2(axis[:, 1], axis[:, 0]))


def free_top() -> Iterator[Row]:
    """A free top.

    A box that is thrown into the air turning about its middle axis turns over each half period of Jacobi's
    elliptic functions, 2 K(m)/rate.
    """
    box = sp.Body.box(0.3, 0.5, 0.9, 40.0)
    large, middle, small = np.diag(box.solid.inertia)
    for nudge in (0.1, 0.01):
        spin, side = 12.0, nudge * math.sqrt(small / large)
        twice = large * side**2 + middle * spin**2 + small * nudge**2
        square = (large * side) ** 2 + (middle * spin) ** 2 + (small * nudge) ** 2
        rate = math.sqrt((large - middle) * (square - twice * small) / (large * middle * small))
        m = (middle - small) * (twice * large - square) / ((large - middle) * (square - twice * small))
        if m > 1.0:
            rate, m = rate * math.sqrt(m), 1.0 / m
        known = 2.0 * ellipk(m) / rate
        start = sp.Piece(box, (0.0, 0.0, 90.0), velocity=(0.0, 0.0, 30.0), rotation_rate=(side, spin, nudge))
        run = sp.simulate(start, sp.Room(), still(2.2 * known), step=5e-4)
        own = np.einsum("si,si->s", run.turn[0, :, :, 1], run.rotation_rate[0])
        k = np.flatnonzero(np.diff(np.sign(own)))[:2]
        flips = run.time[k] + 1e-3 * own[k] / (own[k] - own[k + 1])
        yield Row(
            f"nudged by {nudge:g} rad/s", "between flips [s]", CLOSED, known, float(np.diff(flips)[0]), 1e-5
        )


def circular_shaking() -> Iterator[Row]:
    """Circular shaking.

    Under an acceleration a that goes round at ω a block slides at V = √(a² − μ² g²)/ω, on a circle.
    """
    omega, a, mu, dt = 2.0 * math.pi, 4.0, 0.2, 0.002
    t = dt * np.arange(1001)
    speed = math.sqrt(a * a - (mu * G) ** 2) / omega
    first = -a * speed / complex(mu * G, omega * speed)
    start = sp.Piece(sp.Body.box(0.9, 0.9, 0.3, 30.0), velocity=(first.real, first.imag, 0.0))
    motion = sp.Motion(dt=dt, x=a * np.cos(omega * t), y=a * np.sin(omega * t), name="circle")
    run = sp.simulate(start, sp.Room(sp.Floor(mu, mu)), motion)
    found = float(np.linalg.norm(run.velocity[0, -500:, :2], axis=1).mean())
    yield Row("steps of 1 ms", "V [m/s]", CLOSED, speed, found, 1e-4)


def precession() -> Iterator[Row]:
    """Steady precession.

    A cylinder of 0.4 m × 1 m rolls round on its rim, tilted by θ, at the rate Ω: its angular momentum goes
    round as the floor's force asks, which fixes its turn about its own axis.
    """
    can = sp.Body.cylinder(0.4, 1.0, 30.0)
    m, A, C, r, d = 30.0, can.solid.inertia[0, 0], can.solid.inertia[2, 2], 0.2, 0.5
    for tilt, rate in ((0.1, 2.0), (0.1, 6.0), (0.3, 9.0)):
        s, c = math.sin(tilt), math.cos(tilt)
        height, out = r * s + d * c, r * c - d * s
        moment = A * rate**2 * s * c + m * height * rate**2 * d * s - m * G * out
        own = moment / (C * rate * s + m * height * rate * r)
        rotation = own * np.array([s, 0.0, c]) - rate * s * np.array([c, 0.0, -s])
        _, directions = rolled(can, tilt, rotation, 0.5, 5e-5)
        yield Row(
            f"θ = {tilt:g}, Ω = {rate:g} rad/s",
            "turn in 0.5 s [rad]",
            CLOSED,
            0.5 * rate,
            directions[-1],
            2e-3,
        )


def rocking_can() -> Iterator[Row]:
    """A rocking can.

    Tipped and let go nearly without a spin, it rises again with its contact turned by
    π √(1 + m R²/(A + m d²)), whatever the start (Srinivasan & Ruina 2008).
    """
    tilt = 0.03
    for diameter, height in ((0.4, 1.0), (0.6, 0.5)):
        can = sp.Body.cylinder(diameter, height, 30.0)
        r, rest = diameter / 2.0, can.solid.inertia[0, 0] + 30.0 * (height / 2.0) ** 2
        falls = math.sqrt(2.0 * tilt * (rest + 30.0 * r * r) / (30.0 * G * r))
        n = np.array([math.sin(tilt), 0.0, math.cos(tilt)])
        rotation = 0.05 * (np.array([0.0, 0.0, 1.0]) - n[2] * n)
        tilts, directions = rolled(can, tilt, rotation, 2.3 * falls, 2e-5)
        low = int(np.argmin(tilts))
        high = low + int(np.argmax(tilts[low:]))
        known = math.pi * math.sqrt(1.0 + 30.0 * r * r / rest)
        yield Row(f"{diameter:g} m × {height:g} m", "turn [rad]", CLOSED, known, directions[high], 1e-2)


SPACE_CASES: tuple[Callable[[], Iterator[Row]], ...] = (free_top, circular_shaking, precession, rocking_can)
