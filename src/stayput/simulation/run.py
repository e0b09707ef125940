"""One body, one motion: `simulate` and its result, `Run`."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal, cast, overload

import numpy as np

from stayput.errors import InputError, finite, instance_of, list_of, whole_within, word_of
from stayput.measures.measure import Held, Measure, element_rows, hold
from stayput.measures.results import DeviceResult, device_results
from stayput.mechanics import columns as col
from stayput.model.body import Body
from stayput.model.room import Room
from stayput.model.state import State, refuse_bad_start
from stayput.motion.record import Motion
from stayput.motion.units import GRAVITY, STANDARD_GRAVITY
from stayput.simulation.flat_fields import case_columns
from stayput.simulation.outcome import Event, EventKind, Mode, Outcome
from stayput.wording import brief, check_language

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path
    from typing import Self

    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.mechanics.runner import Shaking, Traced
    from stayput.model.solid import Solid
    from stayput.report.embedding import Player
    from stayput.simulation.space_run import SpaceRun
    from stayput.simulation.standing import Assembly, Standing

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
class Run:
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
        from stayput.report.dataset import run_to_dataset

        return run_to_dataset(self)

    def save(self, path: str | Path) -> Path:
        """Write the run to a file (.nc) that `load` reads again, to the bit and with its inputs.

        Any program that knows NetCDF reads the histories in it.

        Raises
        ------
        InputError
            A path that cannot be written, or a class of one's own in it, such as a measure.
        """
        from stayput.saved import save_netcdf

        return save_netcdf(self, self.to_dataset(), path)

    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Read the run that `save` wrote.

        Raises
        ------
        InputError
            No such file, or one of something else.
        """
        from stayput.saved import load_netcdf

        return load_netcdf(cls, path)

    def plot(self, ax: Axes | None = None, *, what: RunHistory = "tilt", language: str = "en") -> Axes:
        """Draw one history on axes, with the modes as bands and the events marked.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        what : {"tilt", "slide", "acceleration"}
            The tilt [°], the slide [cm], or the floor's acceleration [m/s²].
        language : str
            Language of the texts, "en" or "ja".

        Returns
        -------
        Axes
            Those that were drawn on; ``run.plot().figure.savefig("run.pdf")`` saves them.

        Raises
        ------
        InputError
            Another history, or another language.
        """
        from stayput.report.figures import axes_of, drawn
        from stayput.report.plot import draw_run

        axis = axes_of(ax)
        draw_run(axis, self, what, check_language(language))
        return drawn(axis)

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

        return run_player(self, language) if path is None else animate_run(self, path, language=language)


@dataclass(frozen=True, slots=True, repr=False)
class Case:
    """What `simulate` takes, as a value; `run` simulates it."""

    body: Body
    room: Room
    motion: Motion
    contact: Contact = "coulomb"
    initial: State = field(default_factory=State)
    gravity: float = STANDARD_GRAVITY
    measures: tuple[Measure, ...] = ()
    dimensions: Dimensions | None = None

    def __repr__(self) -> str:
        return brief(self)

    def plot(self, ax: Axes | None = None, *, language: str = "en") -> Axes:
        """Draw the body with its measures in the room, to scale and from the side.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        language : str
            Language of the texts, "en" or "ja".
        """
        from stayput.report.figures import axes_of, drawn
        from stayput.report.section import draw_section

        axis = axes_of(ax)
        draw_section(axis, hold(self.body, self.room, self.measures), check_language(language))
        return drawn(axis)

    def __post_init__(self) -> None:
        instance_of("body", self.body, Body)
        instance_of("room", self.room, Room)
        Motion.given(self.motion)
        instance_of("initial", self.initial, State)
        object.__setattr__(self, "measures", list_of("measures", self.measures, Measure))
        law_number(self.contact)
        GRAVITY.check(self.gravity)
        if self.dimensions is not None:
            whole_within("model.dimensions", self.dimensions, 2, 3, "", "dimensions")
        if not self.in_space:
            self.room.refuse_side_walls()

    @property
    def in_space(self) -> bool:
        """Whether it is simulated in space: as asked, else where body and motion have a third direction."""
        if self.dimensions is not None:
            return self.dimensions == 3
        return self.body.length is not None and self.motion.y is not None and self.contact == "coulomb"

    def run(self) -> Run | SpaceRun:
        """Simulate the case."""
        return simulate(
            self.body,
            self.room,
            self.motion,
            self.measures,
            contact=self.contact,
            initial=self.initial,
            gravity=self.gravity,
            dimensions=self.dimensions,
        )


@overload
def simulate(
    body: Body,
    room: Room,
    motion: Motion,
    measures: Sequence[Measure] = ...,
    *,
    dimensions: Literal[2],
    contact: Contact = ...,
    initial: State | None = ...,
    gravity: float = ...,
    most_events: int | None = ...,
) -> Run: ...


@overload
def simulate(
    body: Body | Solid | Standing | Assembly,
    room: Room,
    motion: Motion,
    measures: Sequence[Measure] = ...,
    *,
    dimensions: Literal[3],
    initial: State | None = ...,
    gravity: float = ...,
    step: float | None = ...,
) -> SpaceRun: ...


@overload
def simulate(
    body: Solid | Standing | Assembly,
    room: Room,
    motion: Motion,
    *,
    gravity: float = ...,
    step: float | None = ...,
) -> SpaceRun: ...


@overload
def simulate(
    body: Body,
    room: Room,
    motion: Motion,
    measures: Sequence[Measure] = ...,
    *,
    dimensions: Dimensions | None = ...,
    contact: Contact = ...,
    initial: State | None = ...,
    gravity: float = ...,
    most_events: int | None = ...,
    step: float | None = ...,
) -> Run | SpaceRun: ...


def simulate(
    body: Body | Solid | Standing | Assembly,
    room: Room,
    motion: Motion,
    measures: Sequence[Measure] = (),
    *,
    dimensions: Dimensions | None = None,
    contact: Contact = "coulomb",
    initial: State | None = None,
    gravity: float = STANDARD_GRAVITY,
    most_events: int | None = None,
    step: float | None = None,
) -> Run | SpaceRun:
    """Simulate one body, or an assembly of several in space, in one room under one motion of the floor.

    A `Body` is simulated in the plane, or where it has a length and the motion a component ``y``, in space;
    ``dimensions`` chooses. A `Solid` or `Standing` by itself, and an `Assembly`, are simulated in space.

    Parameters
    ----------
    body : Body, Solid, Standing or Assembly
        What stands.
    room : Room
        Where it stands. The walls are at either end of x; in space there may be side walls at the ends of y.
    motion : Motion
        Acceleration of the floor: ``x`` along the shaking, ``z`` up, and in space ``y`` across.
    measures : sequence of Measure
        What holds a `Body`; see `stayput.measures`.
    dimensions : int, optional
        2 for the plane, 3 for space.
    contact : {"coulomb", "paper"}
        Contact law: unilateral contact with Coulomb friction, or the rules of *A fundamental study on
        development of a verification system for earthquake-proof measures for furniture* (14WCEE, 2008)
        as written, which know no vertical motion.
    initial : State, optional
        Initial state; default at rest.
    gravity : float
        Acceleration of gravity g [m/s²].
    most_events : int, optional
        Most events that are listed, at least 2; by default all are, of which a run can have 10⁶. In the
        plane alone.
    step : float, optional
        Longest step of the engine in space [s], 1e-6 to 0.01; default
        `stayput.simulation.space_engine.STEP`.

    Returns
    -------
    Run or SpaceRun
        Outcome, peaks, events and histories: a `Run` in the plane, a `SpaceRun` in space.

    Raises
    ------
    InputError
        Input that is refused, in one sentence.

    Examples
    --------
    >>> from stayput import Body, Room, simulate, sine
    >>> run = simulate(Body(0.4, 1.8, 100.0, length=0.9), Room(), sine(3.0, 1.0, 5.0), dimensions=3)
    >>> run.outcome
    <Outcome.OVERTURNED: 'overturned'>
    """
    from stayput.mechanics.runner import shaking

    start = State() if initial is None else initial
    if not isinstance(body, Body):
        return _simulate_solids(body, room, motion, measures, dimensions, contact, start, gravity, step)
    given = Case(
        body, room, motion, contact, start, gravity, list_of("measures", measures, Measure), dimensions
    )
    if given.in_space:
        from stayput.simulation.space import simulate_piece

        if contact != "coulomb":
            raise InputError("model.paper_in_space", "contact")
        return simulate_piece(body, room, motion, given.measures, start, gravity, step)
    if most_events is not None:
        count = finite("most_events", most_events, "most_events")
        if count < 2.0 or not count.is_integer():
            raise InputError("model.most_events", "most_events", value=most_events)
    refuse_bad_start(body, room, start)
    held = hold(body, room, given.measures)
    refuse_bad_start(held.body, held.room, start)
    columns, elements = case_columns(held.body, held.room, start, gravity), element_rows(held)
    shaken = shaking(motion.x, motion.z, motion.dt, law_number(contact))
    traced, devices, forces = trace_held(columns[0], elements, shaken)
    results = device_results(held, elements, devices, forces, held.body.mass)
    case = Case(held.body, held.room, motion, contact, start, gravity)
    return run_of(case, traced, held, results, most_events)


def _simulate_solids(
    what: object,
    room: Room,
    motion: Motion,
    measures: Sequence[Measure],
    dimensions: int | None,
    contact: str,
    initial: State,
    gravity: float,
    step: float | None,
) -> SpaceRun:
    """Simulate solids in space; raise `InputError` for what only a `Body` has."""
    from stayput.model.solid import Solid
    from stayput.simulation.space import simulate_assembly
    from stayput.simulation.standing import Assembly, Standing

    kinds = (Body, Solid, Standing, Assembly)  # a body has been taken already, and is named as allowed
    given = cast("Solid | Standing | Assembly", instance_of("body", what, kinds))
    instance_of("room", room, Room)
    Motion.given(motion)
    for name, value, usual in (
        ("measures", tuple(measures), ()),
        ("initial", initial, State()),
        ("contact", contact, "coulomb"),
    ):
        if value != usual:
            raise InputError("model.of_a_body", name, name=name, kind=type(given).__name__)
    if dimensions == 2:
        raise InputError("model.solid_in_the_plane", "dimensions", kind=type(given).__name__)
    if not isinstance(given, Assembly):
        given = Assembly([Standing(given) if isinstance(given, Solid) else given])
    return simulate_assembly(given, room, motion, gravity, step)


def trace_held(
    case: np.void, elements: NDArray[np.void], motion: Shaking
) -> tuple[Traced, NDArray[np.void], NDArray[np.float64]]:
    """Run a case with its elements, shape [n], of which there may be none.

    Returns
    -------
    tuple
        The run, DEVICE of shape [n], and forces at the samples [N/kg], shape [samples, n, 2].
    """
    from stayput.mechanics.devices.columns import DEVICE, FORCES

    if len(elements) == 0:
        from stayput.mechanics.runner import trace

        traced = trace(case, motion)
        return traced, np.zeros(0, DEVICE), np.zeros((len(traced.history), 0, FORCES))
    from stayput.mechanics.devices.runner import trace_with_devices

    traced = trace_with_devices(case, elements, motion)
    return traced.run, traced.devices, traced.forces


def law_number(contact: str) -> int:
    """Return the number of a contact law in the mechanics."""
    return LAWS.index(word_of("model.contact", contact, LAWS, "contact"))


def run_of(
    case: Case,
    traced: Traced,
    held: Held,
    devices: tuple[DeviceResult, ...],
    most_events: int | None = None,
) -> Run:
    """Return the `Run` of the mechanics' numbers, with names of modes, events and outcome."""
    modes = np.array([mode.value for mode in Mode])
    history = traced.history.T.copy()
    first, cut, last = _split(traced.listed, most_events)
    outcome = list(Outcome)[traced.outcome]
    return Run(
        body=case.body,
        room=case.room,
        motion=case.motion,
        contact=case.contact,
        initial=case.initial,
        gravity=case.gravity,
        outcome=outcome,
        overturn_time=traced.end if outcome is Outcome.OVERTURNED else math.nan,
        peak_slide=traced.peak_slide,
        residual_slide=traced.slide,
        peak_tilt=traced.peak_tilt,
        residual_tilt=traced.tilt,
        floor_impacts=traced.floor_impacts,
        wall_impacts=traced.wall_impacts,
        time=np.arange(history.shape[1], dtype=np.float64) * case.motion.dt,
        slide=history[col.H_SLIDE],
        slide_rate=history[col.H_SLIDE_RATE],
        tilt=history[col.H_TILT],
        tilt_rate=history[col.H_TILT_RATE],
        x=history[col.H_X],
        z=history[col.H_Z],
        mode=modes[history[col.H_MODE].astype(np.intp)],
        events=tuple(_event(row) for part in (first, last) for row in part.tolist()),
        held=held,
        devices=devices,
        unlisted={kind: n for kind, n in zip(EventKind, _counts(cut), strict=True) if n},
    )


def _split(events: NDArray[np.float64], most: int | None) -> tuple[NDArray[np.float64], ...]:
    """Return the first rows, those between that are too many, and the last row if some are."""
    if most is None or len(events) <= most:
        return events, events[:0], events[:0]
    return events[: most - 1], events[most - 1 : -1], events[-1:]


def _counts(events: NDArray[np.float64]) -> list[int]:
    kinds = events[:, col.E_KIND].astype(np.intp)
    return np.bincount(kinds, minlength=len(EventKind)).tolist()


def _event(row: list[float]) -> Event:
    time, kind, mode, *state = row
    return Event(time, _KINDS[int(kind)], _MODES[int(mode)], *state)
