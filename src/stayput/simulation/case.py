"""One body, one motion: `Case` and `simulate`."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field, fields, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from stayput import errors
from stayput.catalogue import phrase
from stayput.measures.element import device_results
from stayput.measures.measure import Held, Measure, element_rows, hold
from stayput.mechanics import columns as col
from stayput.model.body import Body
from stayput.model.flat_fields import case_columns
from stayput.model.parameters import GRAVITY, STANDARD_GRAVITY
from stayput.model.room import Room
from stayput.model.state import State, refuse_bad_start
from stayput.motion.record import Motion
from stayput.simulation.outcome import Event, EventKind, Mode, Outcome
from stayput.simulation.run import LAWS, Contact, Dimensions, PieceRun, Run, default_names
from stayput.wording import Brief, check_language

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from stayput.mechanics.runner import Traced
    from stayput.simulation.piece import Piece
    from stayput.simulation.scene import Scene

_KINDS, _MODES = tuple(EventKind), tuple(Mode)


@dataclass(frozen=True, slots=True, repr=False)
class Case(Brief):
    """What `simulate` takes, as a value; `run` simulates it.

    Examples
    --------
    >>> from dataclasses import replace
    >>> import stayput as sp
    >>> bare = sp.Case(sp.Body(0.3, 1.8, 90.0), sp.Room(left_wall=sp.Wall(0.02)), sp.near_fault())
    >>> held = replace(bare, measures=[sp.MEASURES["l_bracket"]()])
    >>> print(f"{bare.run().outcome}; with brackets: {held.run().outcome}")
    overturned; with brackets: rocked
    """

    body: Body
    room: Room
    motion: Motion
    contact: Contact = "coulomb"
    initial: State = field(default_factory=State)
    gravity: float = STANDARD_GRAVITY
    measures: tuple[Measure, ...] = ()
    dimensions: Dimensions | None = None

    def plot(self, ax: Axes | None = None, *, language: str = "en") -> Axes:
        """Draw the body with its measures in the room, to scale and from the side.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        language : str
            Language of the texts, "en" or "ja".
        """
        from stayput.report.figures import plotted
        from stayput.report.section import draw_section

        return plotted(ax, draw_section, hold(self.body, self.room, self.measures), check_language(language))

    def __post_init__(self) -> None:
        errors.instance_of("body", self.body, Body)
        errors.instance_of("room", self.room, Room)
        Motion.given(self.motion)
        errors.instance_of("initial", self.initial, State)
        object.__setattr__(self, "measures", errors.list_of("measures", self.measures, Measure))
        law_number(self.contact)
        GRAVITY.check(self.gravity)
        if self.dimensions is not None:
            errors.whole_within("model.dimensions", self.dimensions, 2, 3, "", "dimensions")
        if not self.in_space:
            if self.body.shape is not None:
                object.__setattr__(self, "body", replace(self.body, shape=None))
            if self.dimensions is None and self.body.length is None and self.room.has_side_walls:
                raise errors.no_length()
            self.room.refuse_side_walls()

    @property
    def in_space(self) -> bool:
        """Whether it is simulated in space: as asked, else where `needs_space` says so."""
        if self.dimensions is not None:
            return self.dimensions == 3
        if self.contact != "coulomb":
            return self.body.shape is not None
        across, held = self.motion.y is not None, bool(self.measures)
        return needs_space(self.body, self.room, across=across, held=held)

    def run(self, most_events: int | None = None) -> Run:
        """Simulate the case.

        Parameters
        ----------
        most_events : int, optional
            Most events that are listed; see `simulate`.
        """
        arguments = {field.name: getattr(self, field.name) for field in fields(self)}
        return simulate(**arguments, most_events=most_events)


def needs_space(body: Body, room: Room, *, across: bool, held: bool) -> bool:
    """Return whether a lone body is simulated in space, under all components of the motion.

    The plane is exact for a free box that the floor shakes along its depth alone. What holds a piece bears
    the shaking along its length too, so a held piece is in the plane only where it has no length.

    Parameters
    ----------
    body, room
        What stands, and where.
    across : bool
        Whether the floor shakes it along its length too.
    held : bool
        Whether measures hold it, or what it is compared with.
    """
    if body.shape is not None:
        return True
    return body.length is not None and (across or held or room.has_side_walls)


def simulate(
    body: Body | Piece | Scene,
    room: Room | Motion,
    motion: Motion | None = None,
    measures: Sequence[Measure] = (),
    *,
    dimensions: Dimensions | None = None,
    contact: Contact = "coulomb",
    initial: State | None = None,
    gravity: float = STANDARD_GRAVITY,
    most_events: int | None = None,
    step: float | None = None,
) -> Run:
    """Simulate a scene, or a body or a piece in a room, under one motion of the floor.

    ``simulate(scene, motion)`` and ``simulate(body, room, motion)``: a `Body` is simulated in the plane; in
    space where it has a shape of its own, or a length and measures, side walls or a motion with a component
    ``y``; ``dimensions`` chooses. A `Piece` and a `Scene` are simulated in space.

    Parameters
    ----------
    body : Body, Piece or Scene
        What stands.
    room : Room
        Where a body or a piece stands. The walls are at either end of x; in space there may be side walls at
        the ends of y.
    motion : Motion
        Acceleration of the floor: ``x`` along the shaking, ``z`` up, and in space ``y`` across.
    measures : sequence of Measure
        What holds a `Body`; see `stayput.measures`. A `Piece` has its own.
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
        Longest step of the engine in space that is not extrapolated [s], 1e-6 to 0.01; default
        `stayput.simulation.space_engine.STEP`.

    Returns
    -------
    Run
        Outcome, peaks and histories; `Run.engine` tells whether in the plane or in space.

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
    from stayput.mechanics.runner import shaking, trace

    start, asked = State() if initial is None else initial, errors.list_of("measures", measures, Measure)
    if step is not None:
        step = errors.within("simulation.step", step, 1e-6, 0.01, "s", "step")
    if not isinstance(body, Body) or (body.shape is not None and dimensions != 2):
        from stayput.simulation.space import simulate_scene

        of_a_body = {"measures": bool(asked), "initial": start != State(), "contact": contact != "coulomb"}
        scene, motion = _in_scene(body, room, motion, **of_a_body, dimensions=dimensions not in (None, 3))
        return simulate_scene(scene, motion, gravity, step)
    around, shaken = errors.instance_of("room", room, Room), Motion.given(motion)
    checked = Case(body, around, shaken, contact, start, gravity, asked, dimensions)
    body = checked.body
    refuse_bad_start(body, around, start)
    if checked.in_space:
        from stayput.simulation.space import simulate_scene

        if contact != "coulomb":
            raise errors.not_allowed("model.contact", repr(contact), "model.coulomb_in_space", "contact")
        return simulate_scene(scene_of(body, around, asked), shaken, gravity, step, start)
    if most_events is not None:
        most_events = errors.whole_within("most_events", most_events, 2, 10**9, "", "most_events")
    held = hold(body, around, checked.measures)
    refuse_bad_start(held.body, held.room, start)
    columns, elements = case_columns(held.body, held.room, start, gravity), element_rows(held)
    of_floor = shaking(shaken.x, shaken.z, shaken.dt, law_number(contact))
    traced = trace(columns[0], of_floor, elements)
    case = Case(held.body, held.room, shaken, contact, start, gravity)
    return run_of(case, traced, held, elements, most_events)


def _in_scene(
    what: object, room: Room | Motion, motion: Motion | None, **asked: bool
) -> tuple[Scene, Motion]:
    """Return the scene of what stands and its motion; refuse what only a `Body` by its section has."""
    from stayput.simulation.piece import Piece
    from stayput.simulation.scene import Scene

    standing = errors.instance_of("body", what, (Body, Piece, Scene))
    for name in asked:
        if asked[name]:
            raise errors.InputError("common.left_out", name, where=phrase("model.of_a_body"))
    if not isinstance(standing, Scene):
        return Scene(
            [Piece(standing) if isinstance(standing, Body) else standing],
            errors.instance_of("room", room, Room),
        ), Motion.given(motion)
    if motion is not None:
        raise errors.InputError("common.left_out", "room", where=phrase("model.room_of_a_scene"))
    return standing, Motion.given(room)


def scene_of(body: Body, room: Room, measures: Sequence[Measure]) -> Scene:
    """Return the scene of a body in a room with its measures."""
    from stayput.simulation.piece import Piece
    from stayput.simulation.scene import Scene

    return Scene([Piece(body, measures=measures)], room).in_room_of_measures()


def law_number(contact: str) -> int:
    """Return the number of a contact law in the mechanics."""
    return LAWS.index(errors.word_of("model.contact", contact, LAWS, "contact"))


def run_of(
    case: Case, traced: Traced, held: Held, elements: NDArray[np.void], most_events: int | None
) -> Run:
    """Return the `Run` of the numbers of the mechanics in the plane."""
    history = traced.history.T.copy()
    x, z, tilt, tilt_rate, slide = history[: col.H_SLIDE + 1]
    first, cut, last = _split(traced.events, most_events)
    result, outcome = traced.result, list(Outcome)[int(traced.result["outcome"])]
    none, dt = np.zeros_like(x), case.motion.dt
    half = 0.5 * (tilt + held.body.resting_tilt)
    rates = [np.gradient(values, dt) if len(values) > 1 else none for values in (x, z)]
    piece = PieceRun(
        outcome=outcome,
        overturn_time=float(result["end"]) if outcome is Outcome.OVERTURNED else math.nan,
        fall_time=math.nan,
        peak_slide=result["peak_slide"].item(),
        residual_slide=result["residual_slide"].item(),
        peak_tilt=result["peak_tilt"].item(),
        residual_tilt=result["residual_tilt"].item(),
        floor_impacts=result["floor_impacts"].item(),
        wall_impacts=result["wall_impacts"].item(),
        body_impacts=0,
        tilt=tilt,
        slide=slide,
        slide_in_plan=np.column_stack((slide, none)),
        yaw=none,
        held=held,
    )
    return Run(
        "plane",
        default_names(1),
        (piece,),
        case.room,
        case.motion,
        np.arange(len(x), dtype=np.float64) * dt,
        place=np.column_stack((x, none, z))[np.newaxis],
        attitude=np.column_stack((np.cos(half), none, np.sin(half), none))[np.newaxis],
        velocity=np.column_stack((rates[0], none, rates[1]))[np.newaxis],
        rotation_rate=np.column_stack((none, tilt_rate, none))[np.newaxis],
        devices=device_results(held, elements, traced.devices, traced.forces, held.body.mass),
        contact=case.contact,
        initial=case.initial,
        gravity=case.gravity,
        slide_rate=history[col.H_SLIDE_RATE],
        mode=np.array(_MODES)[history[col.H_MODE].astype(np.intp)],
        events=tuple(_event(row) for part in (first, last) for row in part.tolist()),
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
