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
