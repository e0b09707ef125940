"""One body, one motion: `Case` and `simulate`."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Literal, TypedDict, Unpack, overload

from stayput.errors import InputError, instance_of, list_of, whole_within, word_of
from stayput.measures.element import device_results
from stayput.measures.measure import Measure, element_rows, hold
from stayput.model.body import Body
from stayput.model.flat_fields import case_columns
from stayput.model.parameters import GRAVITY, STANDARD_GRAVITY
from stayput.model.room import Room
from stayput.model.state import State, refuse_bad_start
from stayput.motion.record import Motion
from stayput.simulation.run import LAWS, Contact, Dimensions, Run, run_of
from stayput.wording import Brief, check_language

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from stayput.simulation.space_run import SpaceRun
    from stayput.simulation.standing import Assembly, Piece


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
            if self.body.shape is not None:
                object.__setattr__(self, "body", replace(self.body, shape=None))
            self.room.refuse_side_walls()

    @property
    def in_space(self) -> bool:
        """Whether it is simulated in space: as asked, else where body and motion have a third direction."""
        if self.dimensions is not None:
            return self.dimensions == 3
        across = self.body.length is not None and self.motion.y is not None
        return self.body.shape is not None or (across and self.contact == "coulomb")

    def run(self) -> Run | SpaceRun:
        """Simulate the case."""
        how = _Options(contact=self.contact, initial=self.initial, gravity=self.gravity)
        return simulate(self.body, self.room, self.motion, self.measures, dimensions=self.dimensions, **how)


class _Options(TypedDict, total=False):
    """Options of `simulate` beside the dimensions."""

    contact: Contact
    initial: State | None
    gravity: float
    most_events: int | None
    step: float | None


@overload
def simulate(
    body: Body,
    room: Room,
    motion: Motion,
    measures: Sequence[Measure] = ...,
    *,
    dimensions: Literal[2],
    **options: Unpack[_Options],
) -> Run: ...
@overload
def simulate(
    body: Body,
    room: Room,
    motion: Motion,
    measures: Sequence[Measure] = ...,
    *,
    dimensions: Literal[3],
    **options: Unpack[_Options],
) -> SpaceRun: ...
@overload
def simulate(body: Piece | Assembly, room: Room, motion: Motion, **options: Unpack[_Options]) -> SpaceRun: ...
@overload
def simulate(
    body: Body,
    room: Room,
    motion: Motion,
    measures: Sequence[Measure] = ...,
    *,
    dimensions: Dimensions | None = ...,
    **options: Unpack[_Options],
) -> Run | SpaceRun: ...
def simulate(
    body: Body | Piece | Assembly,
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

    A `Body` is simulated in the plane, or where it has a length and the motion a component ``y``, or a shape
    of its own, in space; ``dimensions`` chooses. A `Piece` and an `Assembly` are simulated in space.

    Parameters
    ----------
    body : Body, Piece or Assembly
        What stands.
    room : Room
        Where it stands. The walls are at either end of x; in space there may be side walls at the ends of y.
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
    from stayput.mechanics.runner import shaking, trace

    start, asked = State() if initial is None else initial, list_of("measures", measures, Measure)
    if not isinstance(body, Body) or (body.shape is not None and dimensions != 2):
        from stayput.simulation.space import simulate_assembly

        of_a_body = {"measures": bool(asked), "initial": start != State(), "contact": contact != "coulomb"}
        assembly = _assembly_of(body, **of_a_body, dimensions=dimensions not in (None, 3))
        instance_of("room", room, Room)
        return simulate_assembly(assembly, room, Motion.given(motion), gravity, step)
    given = Case(body, room, motion, contact, start, gravity, asked, dimensions)
    body = given.body
    refuse_bad_start(body, room, start)
    if given.in_space:
        from stayput.simulation.space import checked_step, simulate_held

        if contact != "coulomb":
            raise InputError("model.paper_in_space", "contact")
        placed = hold(body, room, given.measures, dimensions=3)
        return simulate_held(placed, element_rows(placed), motion, start, gravity, checked_step(step))
    if most_events is not None:
        most_events = whole_within("most_events", most_events, 2, 10**9, "", "most_events")
    held = hold(body, room, given.measures)
    refuse_bad_start(held.body, held.room, start)
    columns, elements = case_columns(held.body, held.room, start, gravity), element_rows(held)
    shaken = shaking(motion.x, motion.z, motion.dt, law_number(contact))
    traced = trace(columns[0], shaken, elements)
    results = device_results(held, elements, traced.devices, traced.forces, held.body.mass)
    case = Case(held.body, held.room, motion, contact, start, gravity)
    return run_of(case, traced, held, results, most_events)


def _assembly_of(what: object, **asked: bool) -> Assembly:
    """Return what stands as an assembly; raise `InputError` for what only a `Body` by its section has."""
    from stayput.simulation.standing import Assembly, Piece

    given = instance_of("body", what, (Body, Piece, Assembly))
    for name in asked:
        if asked[name]:
            raise InputError("model.of_a_body", name, name=name)
    return (
        given
        if isinstance(given, Assembly)
        else Assembly([Piece(given) if isinstance(given, Body) else given])
    )


def law_number(contact: str) -> int:
    """Return the number of a contact law in the mechanics."""
    return LAWS.index(word_of("model.contact", contact, LAWS, "contact"))
