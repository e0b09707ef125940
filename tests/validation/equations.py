"""Equations of motion written anew from Newton's laws, integrated by SciPy, to compare with.

Positions are relative to G, turned clockwise by the tilt θ; a point p of the body moves at
v_G + θ̇(p_z, −p_x) and a force F at p turns it by p_z F_x − p_x F_z. Mass is 1.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from scipy.integrate import solve_ivp
from setups import G, turned

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    import stayput as sp

EXACT = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-14}


def record(values: NDArray[np.float64] | None, dt: float) -> Callable[[float], float]:
    """Return a record as a function of time."""
    if values is None:
        return lambda _: 0.0
    times = np.arange(len(values)) * dt
    return lambda t: float(np.interp(t, times, values))


@dataclass
class Rocking:
    """A body that rocks on sticking corners and lands with the moment of momentum about the new one.

    ``along`` and ``up`` are the floor's acceleration, smooth between the times ``kinks``.
    """

    body: sp.Body
    along: Callable[[float], float]
    up: Callable[[float], float]
    kinks: Sequence[float]
    restitution: float = 1.0
    landings: list[float] = field(default_factory=list)
    rates: list[float] = field(default_factory=list)
    largest: float = 0.0

    @property
    def inertia(self) -> float:
        return self.body.inertia_about_cg / self.body.mass

    def lever(self, side: int, theta: float) -> NDArray[np.float64]:
        """G from the corner on this side."""
        return -turned(self.body.corners[1 if side > 0 else 0], theta)

    def acceleration(self, t: float, theta: float, side: int) -> float:
        x, z = self.lever(side, theta)
        return (x * (G + self.up(t)) - z * self.along(t)) / (self.inertia + x * x + z * z)

    def land(self, omega: float, side: int) -> float:
        """Rate of the body about the corner on the other side."""
        rest = self.body.resting_tilt
        old, new = self.lever(side, rest), self.lever(-side, rest)
        return self.restitution * omega * (self.inertia + new @ old) / (self.inertia + new @ new)

    def run(
        self, tilt: float, rate: float, side: int, start: float = 0.0, most: int = 5
    ) -> NDArray[np.float64]:
        """Tilt (from the room's vertical) and its rate at the kinks up to ``most`` landings, shape (2, n)."""
        rest = self.body.resting_tilt
        y, t = np.array([rest + tilt, rate]), start
        states = [y.copy()]
        for end in self.kinks:
            if end <= start:
                continue
            while t < end:

                def landing(_: float, y: NDArray[np.float64], side: int = side) -> float:
                    return side * (y[0] - rest)

                landing.terminal, landing.direction = True, -1  # type: ignore[attr-defined]

                def turning(_: float, y: NDArray[np.float64]) -> float:
                    return y[1]

                part = solve_ivp(
                    lambda t, y, side=side: [y[1], self.acceleration(t, y[0], side)],
                    (t, end),
                    y,
                    events=(landing, turning),
                    max_step=0.02,
                    **EXACT,
                )
                y, t = part.y[:, -1].copy(), float(part.t[-1])
                self.largest = max([self.largest, *(abs(float(y[0])) for y in part.y_events[1])])
                if part.status == 1:
                    y = np.array([rest, self.land(y[1], side)])
                    side = -side
                    self.landings.append(t)
                    self.rates.append(float(y[1]))
                    if len(self.landings) == most:
                        return np.array(states).T
            states.append(y.copy())
        return np.array(states).T


def ladder(body: sp.Body, theta: float, omega: float, floor: float, wall: float) -> NDArray[np.float64]:
    """Forces on a body whose corner B slips to the left on the floor while D slips down the right wall.

    Unknowns: acceleration of G to the right and up, θ̈, and the normal forces of floor and wall;
    ``floor`` and ``wall`` are the coefficients of friction.
    """
    inertia = body.inertia_about_cg / body.mass
    (bx, bz), (dx, dz) = turned(body.corners[1], theta), turned(body.corners[3], theta)
    matrix = np.array(
        [
            [1, 0, 0, -floor, 1],
            [0, 1, 0, -1, -wall],
            [0, 0, inertia, -(bz * floor - bx), -(-dz - dx * wall)],
            [0, 1, -bx, 0, 0],
            [1, 0, dz, 0, 0],
        ]
    )
    return np.linalg.solve(matrix, [0.0, -G, 0.0, omega**2 * bz, omega**2 * dx])
