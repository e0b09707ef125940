"""What became of a body: outcome, modes and events; and columns of results, with their units and meanings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stayput.measures.element import failed, utilisation
from stayput.mechanics import columns as col
from stayput.mechanics.columns import OVERTURNED_OUTCOME, RESULT, record


class Outcome(StrEnum):
    """Outcome of a run.

    Attributes
    ----------
    RESTED, SLID, ROCKED
        It stands: it did not move, slid at most, or tilted for a while.
    LEANING
        It is left tilted against a wall, the ceiling or a body beside it.
    OVERTURNED
        It turned over and cannot come back.
    FAILED
        The run was given up, which never counts as standing.
    FELL_OFF
        It came off the body that it stood on, for the floor or something lower; of several bodies alone.
    ROLLED
        It lay on its round side and moved more by rolling than by slip; in space alone.

    Examples
    --------
    >>> import stayput as sp
    >>> body = sp.Body(width=0.4, height=1.8, mass=100.0)
    >>> for friction in (0.2, 0.5):  # each under a fifth, two fifths and the whole of a motion
    ...     room = sp.Room(sp.Floor(friction, friction))
    ...     runs = [sp.simulate(body, room, sp.near_fault().scaled(factor)) for factor in (0.2, 0.4, 1.0)]
    ...     print(friction, *(run.outcome for run in runs))
    0.2 rested slid slid
    0.5 rested rocked overturned
    """

    RESTED = "rested"
    SLID = "slid"
    ROCKED = "rocked"
    LEANING = "leaning"
    OVERTURNED = "overturned"
    FAILED = "failed"
    FELL_OFF = "fell off"
    ROLLED = "rolled"


SEVERITY = ("rested", "slid", "rolled", "rocked", "leaning", "overturned", "fell off", "failed")
"""Outcomes, the worst last."""


class Mode(StrEnum):
    """How the body moves at an instant.

    Examples
    --------
    >>> import stayput as sp
    >>> run = sp.simulate(sp.Body(width=0.4, height=1.8, mass=100.0), sp.Room(), sp.sine(4.0, 1.0, 2.0))
    >>> for mode in (sp.Mode.REST, sp.Mode.ROCK):
    ...     print(f"{mode}: {(run.mode == mode).mean():.0%} of the time")
    rest: 5% of the time
    rock: 95% of the time
    """

    REST = "rest"
    SLIDE = "slide"
    ROCK = "rock"
    SLIDE_ROCK = "slide-rock"
    FLIGHT = "flight"
    LEAN = "lean"
    OVERTURNED = "overturned"


class EventKind(StrEnum):
    """Kind of an event.

    Examples
    --------
    >>> import stayput as sp
    >>> run = sp.simulate(sp.Body(0.4, 1.8, 100.0), sp.Room(left_wall=sp.Wall(0.02)), sp.near_fault())
    >>> [str(event.kind) for event in run.events[:4]]
    ['uplift', 'floor impact', 'wall impact', 'floor impact']
    >>> next(round(event.time, 1) for event in run.events if event.kind is sp.EventKind.WALL_IMPACT)  # s
    6.7
    """

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
    DEVICE_FAILURE = "device failure"


@dataclass(frozen=True, slots=True)
class Event:
    """An instant at which the body's mode changes, with the state just after it.

    Parameters
    ----------
    time : float
        Time since the record's first sample [s].
    kind : EventKind
        What happened.
    mode : Mode
        The mode that follows.
    tilt, tilt_rate : float
        θ and θ̇ [rad, rad/s].
    slide, slide_rate : float
        x' at the fulcrum and its rate [m, m/s].

    Examples
    --------
    >>> import stayput as sp
    >>> body = sp.Body(width=0.4, height=1.8, mass=80.0)
    >>> run = sp.simulate(body, sp.Room(), sp.sine(amplitude=4.0, frequency=1.0, duration=2.0))
    >>> event = run.events[0]
    >>> print(event.kind, round(event.time, 3))
    uplift 0.092
    """

    time: float
    kind: EventKind
    mode: Mode
    tilt: float
    tilt_rate: float
    slide: float
    slide_rate: float


@dataclass(frozen=True, slots=True)
class Hit:
    """A body that closed on something faster than 1 cm/s.

    Parameters
    ----------
    time : float
        When [s].
    body : int
        Which body.
    other : int or None
        Which other body; None for the room.
    surface : str
        What of the room: "floor", or as a field of `Room`, such as "left_wall"; empty for another body.
    speed : float
        How fast they closed at the point that closed first in the list of contacts [m/s].
    impulse : float
        The impulse there in the step [N s].

    Examples
    --------
    >>> import stayput as sp
    >>> shaking = sp.sine(amplitude=0.0, frequency=1.0, duration=1.0)
    >>> box = sp.Body.box(width=0.3, length=0.3, height=0.3, mass=10.0)
    >>> run = sp.simulate(sp.Piece(box, at=(0.0, 0.0, 0.02)), sp.Room(), shaking)
    >>> first = run.hits[0]
    >>> print(first.surface, round(first.speed, 2))
    floor 0.63
    """

    time: float
    body: int
    other: int | None
    surface: str
    speed: float
    impulse: float


HISTORIES: dict[str, tuple[int, str, str]] = {
    "slide": (col.H_SLIDE, "m", "displacement of the base relative to the floor, + right"),
    "slide_rate": (col.H_SLIDE_RATE, "m/s", "rate of the slide"),
    "tilt": (col.H_TILT, "rad", "rotation, + clockwise"),
    "tilt_rate": (col.H_TILT_RATE, "rad/s", "rate of the tilt"),
    "x": (col.H_X, "m", "centre of gravity right of where the middle of the base stood"),
    "z": (col.H_Z, "m", "centre of gravity above the floor"),
}
"""Column in the mechanics' history, unit and meaning of each history."""


@dataclass(frozen=True, slots=True)
class ResultColumn:
    """A column of results."""

    name: str
    dtype: str
    unit: str
    meaning: str

    @property
    def attributes(self) -> dict[str, Any]:
        """What a dataset says of it; of the outcome also what its flags mean."""
        about: dict[str, Any] = {"long_name": self.meaning} | ({"units": self.unit} if self.unit else {})
        if self.name == "outcome":
            meanings = " ".join(outcome.replace(" ", "_") for outcome in OUTCOMES)
            about |= {"flag_values": np.arange(len(OUTCOMES), dtype=np.int8), "flag_meanings": meanings}
        return about


QUANTITIES = (
    ResultColumn("outcome", "i1", "", "what became of the body: the flag's place in flag_meanings"),
    ResultColumn("overturned", "?", "", "whether it overturned: in the plane, whether its tilt reached 90°"),
    ResultColumn("overturn_time", "f8", "s", "time at which it overturned, or nan"),
    ResultColumn("peak_slide", "f8", "m", "largest magnitude of the slide"),
    ResultColumn("residual_slide", "f8", "m", "slide at the end"),
    ResultColumn("peak_tilt", "f8", "rad", "largest magnitude of the tilt"),
    ResultColumn("residual_tilt", "f8", "rad", "tilt at the end"),
    ResultColumn("device_failure_time", "f8", "s", "time at which the first device failed, or nan"),
    ResultColumn(
        "device_utilisation",
        "f8",
        "",
        "largest force in a device over its strength; at least 1 where one failed",
    ),
    ResultColumn("floor_impacts", "i4", "", "landings on the floor"),
    ResultColumn("wall_impacts", "i4", "", "hits on the walls and the ceiling"),
    ResultColumn("device_failures", "i4", "", "devices that failed"),
    ResultColumn("events", "i4", "", "all events"),
)
"""The columns of results."""

CASE_RESULT = record(
    *((name, RESULT[name]) for name in RESULT.names or ()),
    ("device_failures", "i4"),
    ("device_failure_time", "f8"),  # of the first [s], NaN where none fails
    ("device_utilisation", "f8"),
)
"""Result of one case: the fields of `mechanics.columns.RESULT`, and a summary of its devices."""


def case_results(
    elements: NDArray[np.void], results: NDArray[np.void], devices: NDArray[np.void]
) -> NDArray[np.void]:
    """Return rows of `CASE_RESULT`, shape [m], from ELEMENT [m, n], RESULT [m] and DEVICE [m, n]."""
    rows, gone = np.zeros(len(results), CASE_RESULT), failed(elements, devices)
    first = np.where(gone, devices["failure_time"], np.inf).min(axis=-1, initial=np.inf)
    for name in RESULT.names or ():
        rows[name] = results[name]
    rows["device_failures"] = gone.sum(axis=-1)
    rows["device_failure_time"] = np.where(np.isfinite(first), first, np.nan)
    rows["device_utilisation"] = utilisation(elements, devices).max(axis=-1, initial=0.0)
    return rows


OUTCOMES = tuple(outcome.value for outcome in Outcome)
"""Names of the outcomes, in the order of the flags."""


def columns_of(
    results: NDArray[np.void], quantities: Sequence[ResultColumn] = QUANTITIES
) -> dict[str, NDArray[np.generic]]:
    """Return rows of `CASE_RESULT`, or of `mechanics.columns.RESULT`, as columns by name."""
    overturned = results["outcome"] == OVERTURNED_OUTCOME
    values = {name: results[name] for name in results.dtype.names or ()}
    values |= {"overturned": overturned, "overturn_time": np.where(overturned, results["end"], np.nan)}
    return {column.name: values[column.name].astype(column.dtype) for column in quantities}
