"""What a body does: its outcome, the modes of its motion, and the events between them."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


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
    """

    RESTED = "rested"
    SLID = "slid"
    ROCKED = "rocked"
    LEANING = "leaning"
    OVERTURNED = "overturned"
    FAILED = "failed"
    FELL_OFF = "fell off"


class Mode(StrEnum):
    """How the body moves at an instant.

    Examples
    --------
    >>> import stayput as sp
    >>> body = sp.Body(width=0.4, height=1.8, mass=80.0)
    >>> run = sp.simulate(body, sp.Room(), sp.sine(amplitude=4.0, frequency=1.0, duration=2.0))
    >>> sorted({str(event.mode) for event in run.events})
    ['rock']
    """

    REST = "rest"
    SLIDE = "slide"
    ROCK = "rock"
    SLIDE_ROCK = "slide-rock"
    FLIGHT = "flight"
    LEAN = "lean"
    OVERTURNED = "overturned"


class EventKind(StrEnum):
    """Kind of an event."""

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
