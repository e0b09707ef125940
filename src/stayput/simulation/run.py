"""`Run`: what the pieces did under one motion, whichever engine followed them; `PieceRun`: what one did."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, Literal, TypedDict, TypeVar, Unpack, overload

import numpy as np
from numpy.typing import NDArray

from stayput.errors import InputError, list_of, name_of, refuse_same_names, shown
from stayput.mechanics.space.columns import PLANE, SPRING
from stayput.model.state import State
from stayput.saved import InNetcdf
from stayput.simulation.outcome import SEVERITY, Event, EventKind, Hit, Outcome
from stayput.simulation.space_records import matrices
from stayput.wording import check_language

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from stayput.measures.element import DeviceResult
    from stayput.measures.measure import Held, Measure
    from stayput.model.body import Body
    from stayput.model.floor_plan import FloorPlan
    from stayput.model.room import Room
    from stayput.motion.record import Motion
    from stayput.report.page import Player
    from stayput.simulation.piece import Piece
    from stayput.simulation.space_engine import Gaps

Contact = Literal["coulomb", "paper"]
"""The contact law: unilateral contact with Coulomb friction, or the rules of the paper as written.

The paper is *A fundamental study on development of a verification system for earthquake-proof measures for
furniture* (14WCEE, 2008).
"""

RunHistory = Literal["tilt", "slide", "yaw", "plan", "acceleration"]
"""What `Run.plot` draws."""

Dimensions = Literal[2, 3]
"""In the plane, or in space."""

Engine = Literal["plane", "space"]
"""The engine that followed a run."""

LAWS: tuple[Contact, ...] = ("coulomb", "paper")
"""The contact laws, in the order of their numbers in the mechanics."""

Value = TypeVar("Value")


class _FilmOptions(TypedDict, total=False):
    """Options of `Run.animate`."""

    fps: float
    speed: float
    language: str


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class PieceRun:
    """What one piece did; of `Run.pieces`.

    Tilts and slides that are followed in the plane have the sign of the plane, + clockwise and + right.

    Attributes
    ----------
    outcome : Outcome
        What became of it; FAILED where the run was given up, which never counts as standing.
    overturn_time : float
        When it overturned [s], or nan. In the plane it lay at 90° from upright then. In space it was tilted
        by 90°, touched the floor with more than its base, or, from when on it stayed tilted by more than 45°,
        ended touching another body.
    fall_time : float
        When it fell off what it stood on [s], or nan: left that for the floor, or ended lower than it stood
        and touches none of it.
    peak_slide, peak_tilt : float
        Largest magnitudes until it overturned or fell off [m, rad], at any time, not only at samples; in
        space the slide at samples and where it hits the room, and the tilt of what fell at samples. Tilts are
        from the position of rest, which is itself tilted over a wedge.
    residual_slide, residual_tilt : float
        Values at the end, or where it overturned or fell off [m, rad].
    floor_impacts, wall_impacts, body_impacts : int
        How often it landed on the floor, hit the walls and the ceiling, and hit other bodies: at 1 cm/s or
        faster, but in the plane landings of any speed. Points that close at once on a surface are one hit;
        in the plane walls and ceiling are one.
    tilt : ndarray, shape (samples,)
        Angle from rest [rad]; of a body that lies on its round side without what it has rolled.
    slide : ndarray, shape (samples,)
        How far the base has slid or rolled in plan over what it stands on [m]: of a piece on another as seen
        from that, of several the one over which it slides farthest; in the plane x' at the fulcrum.
    slide_in_plan : ndarray, shape (samples, 2)
        The same along x and y [m].
    yaw : ndarray, shape (samples,)
        Turn about the vertical from how it stood [rad]; while it is tilted by more than 60° the last before.
    held : Held or None
        The measures in place, and what they made of body and room; None of what is no piece of furniture.

    Examples
    --------
    >>> import stayput as sp
    >>> chest = sp.Piece(sp.Body.box(0.4, 0.8, 0.9, 40.0), name="chest")
    >>> upper = sp.Piece(sp.Body.box(0.4, 0.8, 0.9, 30.0), name="upper part", on="chest")
    >>> piece = sp.simulate(sp.Scene([chest, upper]), sp.near_fault())["upper part"]
    >>> print(piece.outcome, piece.fell_off)
    fell off True
    """

    outcome: Outcome
    overturn_time: float
    fall_time: float
    peak_slide: float
    residual_slide: float
    peak_tilt: float
    residual_tilt: float
    floor_impacts: int
    wall_impacts: int
    body_impacts: int
    tilt: NDArray[np.float64]
    slide: NDArray[np.float64]
    slide_in_plan: NDArray[np.float64]
    yaw: NDArray[np.float64]
    held: Held | None = None

    def __repr__(self) -> str:
        return f"PieceRun({_happened(self)})"

    @property
    def body(self) -> Body:
        """The piece of furniture, with what its measures changed of it.

        Raises
        ------
        InputError
            It is a solid.
        """
        if self.held is None:
            raise InputError("runs.no_body", "body")
        return self.held.body

    @property
    def overturned(self) -> bool:
        """Whether it overturned."""
        return math.isfinite(self.overturn_time)

    @property
    def fell_off(self) -> bool:
        """Whether it fell off what it stood on; it may have overturned as well."""
        return math.isfinite(self.fall_time)


def _happened(piece: PieceRun) -> str:
    after = f" after {piece.overturn_time:.2f} s" if piece.overturned else ""
    return f"{piece.outcome.value}{after} (slide {piece.peak_slide:.3g} m, tilt {piece.peak_tilt:.3g} rad)"


class _OfPiece(Generic[Value]):
    """An attribute of a run that is that of its only piece."""

    def __init__(self, value: Callable[[PieceRun], Value]) -> None:
        self._value = value

    def __set_name__(self, _: type, name: str) -> None:
        self._name = name

    def __get__(self, run: Run | None, _: type) -> Value:
        return self if run is None else self._value(run.only_piece(self._name))  # pyright: ignore[reportReturnType]


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class Run(InNetcdf):
    """What the pieces did under one motion, in axes that move with the floor; made by `simulate`.

    Numbers of a piece are those of `PieceRun`: ``run["bookcase"].overturn_time``, by its name or its number.
    Of a run of one piece they are attributes of the run, too: ``run.overturn_time``; of several only
    ``outcome`` is, that of the piece that fared worst.

    Samples of the plane end with the last one before the body turned over.

    Attributes
    ----------
    engine : {"plane", "space"}
        Which engine followed it.
    names : tuple of str
        What the pieces are called.
    pieces : tuple of PieceRun
        What each did.
    room : Room
        Where they stood, with what measures changed of it.
    motion : Motion
        How the floor moved.
    time : ndarray, shape (samples,)
        Times of the samples [s].
    place, velocity : ndarray, shape (pieces, samples, 3)
        Of the centres of gravity [m, m/s]; in the plane x is right of where the middle of the base stood at
        slide 0, and velocities are differences between samples.
    attitude : ndarray, shape (pieces, samples, 4)
        Unit quaternions w, x, y, z that turn the pieces' frames into the room's.
    rotation_rate : ndarray, shape (pieces, samples, 3)
        Along the room's axes [rad/s].
    devices : tuple of DeviceResult
        What became of each device and joint.
    gravity : float
        Acceleration of gravity g [m/s²].
    contact, initial
        Of the plane: as given to `simulate`.
    slide_rate : ndarray, shape (samples,)
        Of the plane: rate of the slide [m/s].
    mode : ndarray of str, shape (samples,)
        Of the plane: values of `Mode`.
    events : tuple of Event
        Of the plane: every impact, slip, stick, uplift, lift-off, rest and failure of a device, in order;
        where a run was asked for fewer than it has, the first ones and the last.
    unlisted : mapping of EventKind to int
        How many events of each kind `events` leaves out.
    standing : tuple of Piece
        Of space: the bodies, as they stood at first.
    planes : ndarray of PLANE
        Of space: floor, walls and ceiling as the engine saw them.
    force : ndarray, shape (pieces, samples, 2, 3)
        Of space: what pressed on each in the step before a sample [N]: the room, and the other bodies.
    hits : tuple of Hit
        Of space: the first hits, up to `stayput.simulation.space_engine.MOST_HITS`, in order.
    gaps : tuple of Gaps
        Of space: how far the bodies are from the room and from each other, at first and at the end.
    springs : ndarray of SPRING
        Of space: where each device and joint holds, as the engine saw it.
    steps, unconverged : int
        Of space: steps of the engine, and those whose contact forces did not converge; a few where contacts
        jam.
    given_up : bool
        Whether it took too much work: bodies stay where they were then, and what became of them is not known.
    plan : FloorPlan, optional
        The room's places, doors and windows, which pictures show; nothing of them moves or holds anything.

    Examples
    --------
    >>> import stayput as sp
    >>> run = sp.simulate(sp.Body(width=0.6, height=1.8, mass=120.0), sp.Room(), sp.near_fault())
    >>> run.outcome, round(run.peak_slide, 2), round(run.peak_tilt, 2)  # m, rad
    (<Outcome.ROCKED: 'rocked'>, 0.17, 0.13)
    >>> round(float(run.time[abs(run.tilt).argmax()]), 2)  # when it tilts most [s]
    7.49
    """

    engine: Engine
    names: tuple[str, ...]
    pieces: tuple[PieceRun, ...]
    room: Room
    motion: Motion
    time: NDArray[np.float64]
    place: NDArray[np.float64]
    attitude: NDArray[np.float64]
    velocity: NDArray[np.float64]
    rotation_rate: NDArray[np.float64]
    devices: tuple[DeviceResult, ...] = ()
    contact: Contact = "coulomb"
    initial: State = field(default_factory=State)
    gravity: float = math.nan
    slide_rate: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))
    mode: NDArray[np.str_] = field(default_factory=lambda: np.zeros(0, np.str_))
    events: tuple[Event, ...] = ()
    unlisted: Mapping[EventKind, int] = field(default_factory=dict[EventKind, int])
    standing: tuple[Piece, ...] = ()
    planes: NDArray[np.void] = field(default_factory=lambda: np.zeros(0, PLANE))
    force: NDArray[np.float64] = field(default_factory=lambda: np.zeros((0, 0, 2, 3)))
    hits: tuple[Hit, ...] = ()
    gaps: tuple[Gaps, ...] = ()
    springs: NDArray[np.void] = field(default_factory=lambda: np.zeros(0, SPRING))
    steps: int = 0
    unconverged: int = 0
    given_up: bool = False
    plan: FloorPlan | None = None

    overturned = _OfPiece(lambda piece: piece.overturned)
    overturn_time = _OfPiece(lambda piece: piece.overturn_time)
    peak_slide = _OfPiece(lambda piece: piece.peak_slide)
    residual_slide = _OfPiece(lambda piece: piece.residual_slide)
    peak_tilt = _OfPiece(lambda piece: piece.peak_tilt)
    residual_tilt = _OfPiece(lambda piece: piece.residual_tilt)
    floor_impacts = _OfPiece(lambda piece: piece.floor_impacts)
    wall_impacts = _OfPiece(lambda piece: piece.wall_impacts)
    tilt = _OfPiece(lambda piece: piece.tilt)
    slide = _OfPiece(lambda piece: piece.slide)
    yaw = _OfPiece(lambda piece: piece.yaw)
    held = _OfPiece(lambda piece: piece.held)
    body = _OfPiece(lambda piece: piece.body)

    def __repr__(self) -> str:
        each = ", ".join(
            f"{name}: {_happened(piece)}" if len(self.pieces) > 1 else _happened(piece)
            for name, piece in zip(self.names[:4], self.pieces[:4], strict=True)
        )
        more = f", and {len(self.pieces) - 4} more" if len(self.pieces) > 4 else ""
        where = "the plane" if self.engine == "plane" else "space"
        return f"Run({each}{more}; in {where}, {len(self.time)} samples)"

    def _repr_html_(self) -> str:
        from stayput.report.notebook import run_html

        return run_html(self)

    def __getitem__(self, piece: str | int) -> PieceRun:
        """Return what a piece did, by its name or its number from 0 on."""
        try:
            return self.pieces[self.names.index(piece) if isinstance(piece, str) else piece]
        except (ValueError, TypeError, IndexError):
            known = ", ".join(self.names)
            raise InputError("runs.no_piece", "piece", value=shown(piece), allowed=known) from None

    def __iter__(self) -> Iterator[PieceRun]:
        return iter(self.pieces)

    @property
    def piece(self) -> PieceRun:
        """What the only piece did.

        Raises
        ------
        InputError
            There are several.
        """
        return self.only_piece("outcome")

    def only_piece(self, wanted: str) -> PieceRun:
        """Return what the only piece did, or refuse what is wanted of several."""
        if len(self.pieces) != 1:
            example = f"run[{self.names[0]!r}].{wanted}"
            raise InputError("runs.several", "piece", example=example, allowed=", ".join(self.names))
        return self.pieces[0]

    @property
    def outcome(self) -> Outcome:
        """What became of the piece that fared worst."""
        return max((piece.outcome for piece in self.pieces), key=SEVERITY.index)

    def named(self, names: Sequence[str]) -> Run:
        """Return the run with other names of its pieces.

        Raises
        ------
        InputError
            Names that are no texts, the same twice, or not one for each piece.
        """
        texts = tuple(name_of("names", name) for name in list_of("names", names))
        refuse_same_names("pieces", texts)
        if len(texts) != len(self.pieces):
            raise InputError("runs.number_of_names", "names", count=len(texts), pieces=len(self.pieces))
        return replace(self, names=texts)

    @property
    def turn(self) -> NDArray[np.float64]:
        """Rotations of the pieces' frames into the room's, shape (pieces, samples, 3, 3)."""
        return matrices(self.attitude)

    @property
    def end(self) -> float:
        """When the run ends [s]: with its last sample, or as the body turns over in the plane."""
        return max(float(self.time[-1]), *(p.overturn_time for p in self.pieces if p.overturned), 0.0)

    def count(self, kind: EventKind) -> int:
        """Return how many events of a kind there were, listed or not."""
        return sum(event.kind is kind for event in self.events) + self.unlisted.get(kind, 0)

    @property
    def events_total(self) -> int:
        """How many events there were, listed or not."""
        return len(self.events) + sum(self.unlisted.values())

    @property
    def measures(self) -> tuple[Measure, ...]:
        """The measures that were in place, on all pieces."""
        return tuple(measure for p in self.pieces if p.held is not None for measure in p.held.measures)

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

    def to_dataset(self) -> xr.Dataset:
        """Return histories, events and results over ``piece`` and ``time``, with units in attrs."""
        from stayput.report.summary import run_to_dataset

        return run_to_dataset(self)

    def plot(
        self, ax: Axes | None = None, *, what: RunHistory = "tilt", language: str = "en", **line: Any
    ) -> Axes:
        """Draw one history of every piece, or their ways as seen from above, on axes.

        In the plane the modes are bands behind it, and the events are marked. On axes that have a run already
        only the lines are drawn, in another colour.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        what : {"tilt", "slide", "yaw", "plan", "acceleration"}
            The tilt [°], the slide [cm], the turn in plan [°], the ways in plan [m], or the floor's
            acceleration [m/s²].
        language : str
            Language of the texts, "en" or "ja".
        **line
            How the line of a single piece looks, as for ``Axes.plot``: ``label``, ``color``, ...

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
        """Return a figure with the floor's acceleration, tilts, slides, and modes or ways in plan.

        Examples
        --------
        >>> import stayput as sp
        >>> run = sp.simulate(sp.Body(0.3, 1.8, 90.0), sp.Room(), sp.near_fault())
        >>> run.figure("Bookcase").savefig("run.svg")  # or .pdf, .png
        """
        from stayput.report.plot import plot_run

        return plot_run(self, title=title, language=check_language(language))

    @overload
    def animate(self, path: None = ..., **film: Unpack[_FilmOptions]) -> Player: ...
    @overload
    def animate(self, path: str | Path, **film: Unpack[_FilmOptions]) -> Path: ...
    def animate(
        self, path: str | Path | None = None, *, fps: float = 20.0, speed: float = 1.0, language: str = "en"
    ) -> Path | Player:
        """Write an animation (GIF, MP4 or HTML), or without a path return one that notebooks play.

        See `stayput.report.animation.animate_run`, which has more to choose from.
        """
        from stayput.report.animation import animate_run, run_player

        if path is None:
            return run_player(self, speed, language)
        return animate_run(self, path, fps=fps, speed=speed, language=language)


def default_names(count: int) -> tuple[str, ...]:
    """Return what pieces are called that nobody named: "piece", or "piece 1" and so on."""
    return ("piece",) if count == 1 else tuple(f"piece {number}" for number in range(1, count + 1))
