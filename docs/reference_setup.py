"""What the reference cases share: rows, bodies, floors, and the search for a threshold."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

import stayput as sp

if TYPE_CHECKING:
    from collections.abc import Callable

G = 9.81
CLOSED = "formula"
SOLVED = "numerical"


@dataclass(frozen=True, slots=True)
class Row:
    """One line of the table; ``tolerance`` is the largest relative error that passes."""

    case: str
    quantity: str
    source: str
    reference: float
    computed: float
    tolerance: float

    @property
    def error(self) -> float:
        """Relative error."""
        return abs(self.computed / self.reference - 1.0)


def block(b: float, h: float) -> sp.Body:
    """Return a uniform block of half sizes b and h [m]."""
    return sp.Body(width=2 * b, height=2 * h, mass=100.0)


def slenderness(b: float, h: float) -> tuple[float, float]:
    """Return R [m] and α [rad]."""
    return math.hypot(b, h), math.atan2(b, h)


def room(static: float, kinetic: float | None = None) -> sp.Room:
    """Return a floor alone; 3 is the friction of a corner that does not slip."""
    return sp.Room(sp.Floor(static_friction=static, kinetic_friction=static if kinetic is None else kinetic))


STICKING = room(3.0)


def still(duration: float, dt: float = 1e-3) -> sp.Motion:
    """Return a floor that does not move."""
    return sp.Motion(dt, np.zeros(round(duration / dt) + 1), name="still")


def steady(acceleration: float, duration: float, dt: float) -> sp.Motion:
    """Return a floor of constant acceleration from t = 0 [m/s²]."""
    return sp.Motion(dt, np.full(round(duration / dt) + 1, acceleration), name="steady")


def simulate(body: sp.Body, place: sp.Room, motion: sp.Motion, **state: float) -> sp.Run:
    """Simulate with this page's gravity."""
    return sp.simulate(body, place, motion, initial=sp.State(**state), gravity=G)


def impacts(run: sp.Run) -> list[float]:
    """Return the times of the floor impacts [s]."""
    return [event.time for event in run.events if event.kind is sp.EventKind.FLOOR_IMPACT]


def threshold(overturns: Callable[[float], bool], low: float, high: float, width: float = 1e-6) -> float:
    """Return where ``overturns`` changes, by bisection; both ends are checked first."""
    first = overturns(low)
    if overturns(high) == first:
        raise RuntimeError(f"No threshold between {low} and {high}.")
    while high - low > width:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if overturns(middle) == first else (low, middle)
    return 0.5 * (low + high)
