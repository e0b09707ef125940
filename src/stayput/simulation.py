"""One body, one motion: `simulate` and its result, `Run`."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING

from stayput.errors import within
from stayput.room import Room

if TYPE_CHECKING:
    from pathlib import Path

    import numpy as np
    import xarray as xr
    from numpy.typing import NDArray

    from stayput.body import Body
    from stayput.motion import Motion

STANDARD_GRAVITY = 9.80665
"""Standard acceleration of gravity [m/s²]."""


class Outcome(StrEnum):
    """What became of the body."""

    RESTED = "rested"
    SLID = "slid"
    ROCKED = "rocked"
    LEANING = "leaning"
    OVERTURNED = "overturned"
    FAILED = "failed"


class Mode(StrEnum):
    """How the body moves at an instant."""

    REST = "rest"
    SLIDE = "slide"
    ROCK = "rock"
    SLIDE_ROCK = "slide-rock"
    FLIGHT = "flight"
    LEAN = "lean"
    OVERTURNED = "overturned"


class EventKind(StrEnum):
    """What happens at an event."""

    SLIP = "slip"
    STICK = "stick"
    UPLIFT = "uplift"
    FLOOR_IMPACT = "floor impact"
    WALL_IMPACT = "wall impact"
    CEILING_IMPACT = "ceiling impact"
    LIFT_OFF = "lift-off"
    WALL_RELEASE = "wall release"
    REST = "rest"
    OVERTURNED = "overturned"
    FAILED = "failed"


@dataclass(frozen=True, slots=True)
class Event:
    """An event, with the state just after it."""

    time: float
    kind: EventKind
    mode: Mode
    tilt: float
    tilt_rate: float
    slide: float
    slide_rate: float


@dataclass(frozen=True, slots=True)
class State:
    """Initial state: tilt [rad], tilt rate [rad/s], slide [m], slide rate [m/s]."""

    tilt: float = 0.0
    tilt_rate: float = 0.0
    slide: float = 0.0
    slide_rate: float = 0.0


@dataclass(frozen=True, slots=True)
class Run:
    """Result of `simulate` (fields and units as documented in the theory page)."""

    body: Body
    room: Room
    motion: Motion
    contact: str
    initial: State
    gravity: float
    outcome: Outcome
    overturn_time: float  # s or nan
    peak_slide: float  # m, largest magnitude
    residual_slide: float  # m, signed
    peak_tilt: float  # rad, largest magnitude
    floor_impacts: int
    wall_impacts: int
    time: NDArray[np.float64]  # s, the record's samples until the end
    slide: NDArray[np.float64]  # m
    slide_rate: NDArray[np.float64]  # m/s
    tilt: NDArray[np.float64]  # rad
    tilt_rate: NDArray[np.float64]  # rad/s
    x: NDArray[np.float64]  # m, centre of gravity right of where the middle of the base stood at slide 0
    z: NDArray[np.float64]  # m, centre of gravity above the floor
    mode: NDArray[np.str_]  # values of Mode
    events: tuple[Event, ...]

    @property
    def overturned(self) -> bool:
        """Whether |tilt| reached 90°."""
        return self.outcome is Outcome.OVERTURNED

    def to_dataset(self) -> xr.Dataset:
        """The histories as an xarray.Dataset over time, with units in attrs."""
        raise NotImplementedError

    def plot(self, path: str | Path | None = None) -> object:
        """Plot (stayput.report.plot.plot_run)."""
        from stayput.report.plot import plot_run

        return plot_run(self, path)

    def animate(self, path: str | Path) -> Path:
        """Animate (stayput.report.animation.animate_run)."""
        from stayput.report.animation import animate_run

        return animate_run(self, path)
