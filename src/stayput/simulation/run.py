"""`Run`: what one body did under one motion, in the plane."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np

from stayput.mechanics import columns as col
from stayput.saved import InNetcdf
from stayput.simulation.outcome import HISTORIES, Event, EventKind, Mode, Outcome
from stayput.wording import check_language

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.measures.element import DeviceResult
    from stayput.measures.measure import Held, Measure
    from stayput.mechanics.runner import Traced
    from stayput.model.body import Body
    from stayput.model.room import Room
    from stayput.model.state import State
    from stayput.motion.record import Motion
    from stayput.report.page import Player
    from stayput.simulation.case import Case

Contact = Literal["coulomb", "paper"]
"""The contact law: unilateral contact with Coulomb friction, or the rules of the paper as written.

The paper is *A fundamental study on development of a verification system for earthquake-proof measures for
furniture* (14WCEE, 2008).
"""

RunHistory = Literal["tilt", "slide", "acceleration"]
"""What `Run.plot` draws over time."""

Dimensions = Literal[2, 3]
"""In the plane, or in space."""

LAWS: tuple[Contact, ...] = ("coulomb", "paper")
"""The contact laws, in the order of their numbers in the mechanics."""


_KINDS, _MODES = tuple(EventKind), tuple(Mode)


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class Run(InNetcdf):
    """Result of one body under one motion; made by `simulate`.

    Histories hold one value per sample of the record, shape [n], up to the end of the run: the record's
    last sample, or the last one before the body turned over.

    Attributes
    ----------
    outcome : Outcome
        The verdict; FAILED where the run was given up, which never counts as standing.
    overturn_time : float
        Time at which the body lay at 90° from upright [s], or nan.
    peak_slide, peak_tilt : float
        Largest magnitudes at any time, not only at samples [m, rad]. Tilts are from the position of rest,
        which is itself tilted over a wedge.
    residual_slide, residual_tilt : float
        Values at the end [m, rad].
    floor_impacts : int
        Number of landings on the floor.
    wall_impacts : int
        Number of hits on the walls and the ceiling; `events` tells the two apart.
    time : ndarray of float64
        Times of the samples [s].
    slide, slide_rate : ndarray of float64
        x' at the fulcrum and its rate [m, m/s].
    tilt, tilt_rate : ndarray of float64
        θ from rest and θ̇ [rad, rad/s].
    x, z : ndarray of float64
        Centre of gravity right of where the middle of the base stood at slide 0, and above the floor [m].
    mode : ndarray of str
        Values of `Mode`.
    events : tuple of Event
        Every impact, slip, stick, uplift, lift-off, rest and failure of a device, in order; where a run was
        asked for fewer than it has, the first ones and the last.
    unlisted : mapping of EventKind to int
        How many events of each kind `events` leaves out.
    held : Held or None
        The measures in place; `body` and `room` are what they made of those that were given.
    devices : tuple of DeviceResult
        What became of each device.

    Examples
    --------
    >>> import stayput as sp
    >>> run = sp.simulate(sp.Body(width=0.6, height=1.8, mass=120.0), sp.Room(), sp.near_fault())
    >>> run.outcome, round(run.peak_slide, 2), round(run.peak_tilt, 2)  # m, rad
    (<Outcome.ROCKED: 'rocked'>, 0.17, 0.13)
    >>> round(float(run.time[abs(run.tilt).argmax()]), 2)  # when it tilts most [s]
    7.49
    """

    body: Body
    room: Room
    motion: Motion
    contact: Contact
    initial: State
    gravity: float
    outcome: Outcome
    overturn_time: float
    peak_slide: float
    residual_slide: float
    peak_tilt: float
    residual_tilt: float
    floor_impacts: int
    wall_impacts: int
    time: NDArray[np.float64]
    slide: NDArray[np.float64]
    slide_rate: NDArray[np.float64]
    tilt: NDArray[np.float64]
    tilt_rate: NDArray[np.float64]
    x: NDArray[np.float64]
    z: NDArray[np.float64]
    mode: NDArray[np.str_]
    events: tuple[Event, ...]
    held: Held | None = None
    devices: tuple[DeviceResult, ...] = ()
    unlisted: Mapping[EventKind, int] = field(default_factory=dict[EventKind, int])

    def __repr__(self) -> str:
        fell = f" after {self.overturn_time:.2f} s" if self.outcome is Outcome.OVERTURNED else ""
        slide, tilt = f"{self.peak_slide:.3g} m", f"{self.peak_tilt:.3g} rad"
        return f"Run({self.outcome.value}{fell}; peaks: slide {slide}, tilt {tilt}; {len(self.time)} samples)"

    def _repr_html_(self) -> str:
        from stayput.report.notebook import run_html

        return run_html(self)

    def count(self, kind: EventKind) -> int:
        """Return how many events of a kind there were, listed or not."""
        return sum(event.kind is kind for event in self.events) + self.unlisted.get(kind, 0)

    @property
    def events_total(self) -> int:
        """How many events there were, listed or not."""
        return len(self.events) + sum(self.unlisted.values())

    @property
    def measures(self) -> tuple[Measure, ...]:
        """The measures that were in place."""
        return () if self.held is None else self.held.measures

    @property
    def device_failures(self) -> int:
        """Number of devices that failed."""
        return sum(device.failed for device in self.devices)

    @property
    def device_failure_time(self) -> float:
        """When the first device failed [s], or nan."""
        return min((device.failure_time for device in self.devices if device.failed), default=math.nan)

    @property
    def device_utilisation(self) -> float:
        """Largest force in a device over its strength; at least 1 where one failed, 0 without devices."""
        return max((device.utilisation for device in self.devices), default=0.0)

    @property
    def overturned(self) -> bool:
        """Whether it lay at 90° from upright."""
        return self.outcome is Outcome.OVERTURNED

    def to_dataset(self) -> xr.Dataset:
        """Return the histories over time and the events, with units in attrs, as an `xarray.Dataset`."""
        from stayput.report.summary import run_to_dataset

        return run_to_dataset(self)

    def plot(
        self, ax: Axes | None = None, *, what: RunHistory = "tilt", language: str = "en", **line: Any
    ) -> Axes:
        """Draw one history on axes, with the modes as bands and the events marked.

        On axes that have a run already only the line is drawn, in another colour.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        what : {"tilt", "slide", "acceleration"}
            The tilt [°], the slide [cm], or the floor's acceleration [m/s²].
        language : str
            Language of the texts, "en" or "ja".
        **line
            How the line looks, as for ``Axes.plot``: ``label``, ``color``, ...

        Returns
        -------
        Axes
            Those that were drawn on; ``run.plot().figure.savefig("run.pdf")`` saves them.

        Raises
        ------
        InputError
            Another history, or another language.
        """
        from stayput.report.figures import plotted
        from stayput.report.plot import draw_run

        return plotted(ax, draw_run, self, what, check_language(language), **line)

    def figure(self, title: str = "", *, language: str = "en") -> Figure:
        """Return a figure with the floor's acceleration, the tilt, the slide and the modes over time.

        Examples
        --------
        >>> import stayput as sp
        >>> run = sp.simulate(sp.Body(0.3, 1.8, 90.0), sp.Room(), sp.near_fault())
        >>> run.figure("Bookcase").savefig("run.svg")  # or .pdf, .png
        """
        from stayput.report.plot import plot_run

        return plot_run(self, title=title, language=check_language(language))

    @overload
    def animate(self, path: None = ..., language: str = ...) -> Player: ...
    @overload
    def animate(self, path: str | Path, language: str = ...) -> Path: ...
    def animate(self, path: str | Path | None = None, language: str = "en") -> Path | Player:
        """Write an animation (GIF, MP4 or HTML), or without a path return one that notebooks play.

        See `stayput.report.animation.animate_run`, which has more to choose from.
        """
        from stayput.report.animation import animate_run, run_player

        return (
            run_player(self, language=language)
            if path is None
            else animate_run(self, path, language=language)
        )


def run_of(
    case: Case, traced: Traced, held: Held, devices: tuple[DeviceResult, ...], most_events: int | None = None
) -> Run:
    """Return the `Run` of the mechanics' numbers, with names of modes, events and outcome."""
    history = traced.history.T.copy()
    first, cut, last = _split(traced.events, most_events)
    result = traced.result
    outcome = list(Outcome)[int(result["outcome"])]
    inputs: dict[str, Any] = {
        name: getattr(case, name) for name in ("body", "room", "motion", "contact", "initial", "gravity")
    }
    numbers: dict[str, Any] = {
        name: result[name].item()
        for name in (
            "peak_slide",
            "residual_slide",
            "peak_tilt",
            "residual_tilt",
            "floor_impacts",
            "wall_impacts",
        )
    }
    histories: dict[str, Any] = {name: history[column] for name, (column, _, _) in HISTORIES.items()}
    return Run(
        **inputs,
        **numbers,
        **histories,
        outcome=outcome,
        overturn_time=float(result["end"]) if outcome is Outcome.OVERTURNED else math.nan,
        time=np.arange(history.shape[1], dtype=np.float64) * case.motion.dt,
        mode=np.array(_MODES)[history[col.H_MODE].astype(np.intp)],
        events=tuple(_event(row) for part in (first, last) for row in part.tolist()),
        held=held,
        devices=devices,
        unlisted=dict(Counter(_KINDS[int(kind)] for kind in cut["kind"])),
    )


def _split(events: NDArray[np.void], most: int | None) -> tuple[NDArray[np.void], ...]:
    """Return the first rows, those between that are too many, and the last row if some are."""
    if most is None or len(events) <= most:
        return events, events[:0], events[:0]
    return events[: most - 1], events[most - 1 : -1], events[-1:]


def _event(row: tuple[float, ...]) -> Event:
    time, kind, mode, *state = row
    return Event(time, _KINDS[int(kind)], _MODES[int(mode)], *state)
