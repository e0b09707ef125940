"""What the validation tests share: floors, records, events, and the search for a threshold.

Every reference number is for g = 9.81 m/s². Half sizes (b, h) are those of the sources on rocking.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import pytest

import stayput as sp

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

G = 9.81
STICKING = sp.Floor(3.0, 3.0)
"""A floor on which no fulcrum of these tests slips; Housner's landing (e = 1)."""

both_laws = pytest.mark.parametrize("law", ["coulomb", "paper"])


def block(b: float, h: float, mass: float = 100.0, **more: object) -> sp.Body:
    """Body of half sizes b and h; without devices its mass has no effect."""
    return sp.Body(2.0 * b, 2.0 * h, mass, **more)


def room(static: float, kinetic: float | None = None, **more: object) -> sp.Room:
    """Floor with these coefficients of friction, and nothing else."""
    return sp.Room(sp.Floor(static, static if kinetic is None else kinetic, **more))


def constant(acceleration: float, duration: float, dt: float = 0.01, *, up: float = 0.0) -> sp.Motion:
    """Floor acceleration that is there from the first instant."""
    n = round(duration / dt) + 1
    return sp.Motion(dt, np.full(n, acceleration), z=np.full(n, up))


def still(duration: float, dt: float = 0.01) -> sp.Motion:
    return constant(0.0, duration, dt)


def simulate(
    body: sp.Body, place: sp.Room, motion: sp.Motion, law: str = "coulomb", **state: float
) -> sp.Run:
    """Simulate with the gravity of the reference numbers."""
    return sp.simulate(body, place, motion, contact=law, initial=sp.State(**state), gravity=G)


def events(run: sp.Run, kind: sp.EventKind) -> list[sp.Event]:
    return [event for event in run.events if event.kind is kind]


def impacts(run: sp.Run) -> list[sp.Event]:
    return events(run, sp.EventKind.FLOOR_IMPACT)


def first(run: sp.Run, kind: sp.EventKind) -> sp.Event:
    return events(run, kind)[0]


def threshold(happens: Callable[[float], bool], low: float, high: float, *, halvings: int = 20) -> float:
    """Value between ``low`` and ``high`` at which it begins to happen, or ceases to."""
    at_low, at_high = happens(low), happens(high)
    assert at_low != at_high, f"the threshold is not between {low} and {high}"
    for _ in range(halvings):
        middle = 0.5 * (low + high)
        if happens(middle) == at_low:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def extrema(times: NDArray[np.float64], values: NDArray[np.float64]) -> list[float]:
    """Local maxima of a sampled smooth function, by parabolas through three samples."""
    found = []
    for k in range(1, len(values) - 1):
        a, b, c = values[k - 1 : k + 2]
        if a < b >= c:
            found.append(b - 0.125 * (c - a) ** 2 / (a - 2.0 * b + c))
    return found


def turned(point: Sequence[float], tilt: float) -> NDArray[np.float64]:
    """Point of the body's frame, turned clockwise."""
    u, v = point
    return np.array(
        [u * math.cos(tilt) + v * math.sin(tilt), v * math.cos(tilt) - u * math.sin(tilt)], dtype=np.float64
    )
