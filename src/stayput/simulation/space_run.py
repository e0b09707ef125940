"""`SpaceRun`: what bodies in space did under one motion of the floor."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, TypedDict, Unpack, overload

import numpy as np

from stayput.model.parameters import STANDARD_GRAVITY
from stayput.saved import InNetcdf
from stayput.simulation.space_fate import fates_of, slides, tilts, unrolled, upright_yaws
from stayput.simulation.space_records import matrices

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.measures.element import DeviceResult
    from stayput.measures.measure import Held
    from stayput.model.floor_plan import FloorPlan
    from stayput.model.room import Room
    from stayput.motion import Motion
    from stayput.report.page import Player
    from stayput.simulation.outcome import Outcome
    from stayput.simulation.space_engine import Gaps
    from stayput.simulation.space_fate import Fate
    from stayput.simulation.standing import Piece

SpaceDrawing = Literal["tilt", "yaw", "plan", "acceleration"]
"""What `SpaceRun.plot` draws."""

SEVERITY = ("rested", "slid", "rolled", "rocked", "leaning", "overturned", "fell off", "failed")
"""Outcomes, the worst last."""


class _Film(TypedDict, total=False):
    """Options of `SpaceRun.animate`."""

    names: Sequence[str] | None
    fps: float
    speed: float
    language: str


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


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class SpaceRun(InNetcdf):
    """What bodies in space did, in axes that move with the floor.

    Parameters
    ----------
    pieces : tuple of Piece
        The bodies, as they stood at first.
    room : Room
        Where they stood.
    motion : Motion
        How the floor moved.
    planes : ndarray of PLANE
        Floor, walls and ceiling as the engine saw them.
    time : ndarray, shape (samples,)
        Time [s].
    place : ndarray, shape (bodies, samples, 3)
        Of the centres of gravity [m].
    attitude : ndarray, shape (bodies, samples, 4)
        Unit quaternions w, x, y, z that turn the bodies' frames into the room's.
    velocity, rotation_rate : ndarray, shape (bodies, samples, 3)
        Of the centres of gravity [m/s], and of the bodies [rad/s], in the room's axes.
    force : ndarray, shape (bodies, samples, 2, 3)
        What pressed on each body in the step before a sample [N]: the room, and the other bodies.
    hits : tuple of Hit
        The first hits, up to `stayput.simulation.space_engine.MOST_HITS`, in order.
    hit_numbers : ndarray of int, shape (bodies, 3)
        How often each body hit the floor, walls and ceiling, and other bodies.
    peak_tilt : ndarray, shape (bodies,)
        Largest tilt of each body at any step [rad].
    gaps : tuple of Gaps
        How far the bodies are from the room and from each other, at first and at the end.
    devices : tuple of DeviceResult
        What became of each device and joint.
    springs : ndarray of SPRING
        Where each of these holds, as the engine saw it.
    steps : int
        Steps of the engine.
    unconverged : int
        Steps whose contact forces did not converge; a few where contacts jam.
    estimated_error : float
        Of places, as a scale: what steps between events differ from two of half their length, over three, in
        sum [m]. Events, impacts, and what shaking makes of an error come on top.
    held : tuple of Held or None
        The measures in place on each body; None of one that is no piece of furniture.
    given_up : bool
        Whether it took too much work: bodies stay where they were then, and what became of them is not known.
    plan : FloorPlan, optional
        The room's places, doors and windows, which pictures show; nothing of them moves or holds anything.
    gravity : float
        Acceleration of gravity g [m/s²].

    Examples
    --------
    >>> import stayput as sp
    >>> box = sp.Body.box(width=0.3, length=0.5, height=1.5, mass=30.0)
    >>> run = sp.simulate(box, sp.Room(), sp.near_fault().scaled(0.2))
    >>> run.outcomes, run.place.shape[1:]
    ((<Outcome.RESTED: 'rested'>,), (3001, 3))
    """

    pieces: tuple[Piece, ...]
    room: Room
    motion: Motion
    planes: NDArray[np.void]
    time: NDArray[np.float64]
    place: NDArray[np.float64]
    attitude: NDArray[np.float64]
    velocity: NDArray[np.float64]
    rotation_rate: NDArray[np.float64]
    force: NDArray[np.float64]
    hits: tuple[Hit, ...]
    hit_numbers: NDArray[np.int64]
    peak_tilt: NDArray[np.float64]
    gaps: tuple[Gaps, Gaps]
    devices: tuple[DeviceResult, ...]
    springs: NDArray[np.void]
    steps: int
    unconverged: int
    estimated_error: float = 0.0
    held: tuple[Held | None, ...] = ()
    given_up: bool = False
    plan: FloorPlan | None = None
    gravity: float = STANDARD_GRAVITY

    def __repr__(self) -> str:
        became = ", ".join(
            f"{outcome.value} (slide {slide:.3g} m, tilt {tilt:.3g} rad)"
            for outcome, slide, tilt in zip(self.outcomes[:4], self.peak_slide, self.peak_tilt, strict=False)
        )
        more = f", and {len(self.pieces) - 4} more" if len(self.pieces) > 4 else ""
        return f"SpaceRun({became}{more}; {len(self.time)} samples)"

    def _repr_html_(self) -> str:
        from stayput.report.notebook import space_run_html

        return space_run_html(self)

    @property
    def turn(self) -> NDArray[np.float64]:
        """Rotations of the bodies' frames into the room's, shape (bodies, samples, 3, 3)."""
        return matrices(self.attitude)

    @property
    def _unrolled(self) -> list[NDArray[np.float64]]:
        return [unrolled(one, turn) for one, turn in zip(self.pieces, self.turn, strict=True)]

    @property
    def tilt(self) -> NDArray[np.float64]:
        """Angles between what points up at rest and the vertical, shape (bodies, samples) [rad].

        Of a body that lies on its round side, without what it has rolled.
        """
        each = zip(self.pieces, self._unrolled, strict=True)
        return np.stack([tilts(one.rest, turn) for one, turn in each])

    @property
    def yaw(self) -> NDArray[np.float64]:
        """Turns about the vertical from how the bodies stood, shape (bodies, samples) [rad].

        Of a body that is tilted by more than 60°, as those that lie and roll, the last before.
        """
        each = zip(self.pieces, self._unrolled, strict=True)
        return np.stack([upright_yaws(one.rest, turn) for one, turn in each])

    @property
    def slide(self) -> NDArray[np.float64]:
        """How far the bases have slid or rolled in plan, shape (bodies, samples, 2) [m]."""
        each = zip(self.pieces, self.place, self._unrolled, strict=True)
        return np.stack([slides(one, place, turn) for one, place, turn in each])

    @property
    def overturn_time(self) -> NDArray[np.float64]:
        """When each body had turned over, shape (bodies,) [s]; nan where it has not.

        It has where it is tilted by 90°, touches the floor with more than its base, or, from when on it stays
        tilted by more than 45°, ends touching another body.
        """
        return self._times([fate.overturned for fate in self.fates])

    @property
    def overturned(self) -> NDArray[np.bool_]:
        """Whether each body overturned, shape (bodies,)."""
        return np.isfinite(self.overturn_time)

    @property
    def fall_time(self) -> NDArray[np.float64]:
        """When each body fell off what it stood on, shape (bodies,) [s]; nan where it has not.

        It has where it left that for the floor, or ends lower than it stood and touches none of it.
        """
        return self._times([fate.fell_off for fate in self.fates])

    @property
    def fell_off(self) -> NDArray[np.bool_]:
        """Whether each body fell off what it stood on, shape (bodies,); it may have overturned as well."""
        return np.isfinite(self.fall_time)

    def _times(self, samples: Sequence[int | None]) -> NDArray[np.float64]:
        """Return the times of samples [s], nan where there is none."""
        return np.array([math.nan if sample is None else self.time[sample] for sample in samples])

    @property
    def fates(self) -> list[Fate]:
        """What became of each body, when, and how far it tilted and slid."""
        return fates_of(self.pieces, self.place, self.turn, self.gaps, self.given_up)

    @property
    def outcomes(self) -> tuple[Outcome, ...]:
        """What became of each body."""
        return tuple(fate.outcome for fate in self.fates)

    @property
    def outcome(self) -> Outcome:
        """What became of the body that fared worst."""
        return max(self.outcomes, key=SEVERITY.index)

    @property
    def peak_slide(self) -> NDArray[np.float64]:
        """Largest slide of each body until it overturned or fell off, at a sample, shape (bodies,) [m]."""
        values = np.hypot(self.slide[..., 0], self.slide[..., 1])
        ends = np.nan_to_num(np.fmin(self.overturn_time, self.fall_time), nan=math.inf)
        return np.where(self.time <= ends[:, np.newaxis], values, 0.0).max(axis=1)

    @property
    def residual_slide(self) -> NDArray[np.float64]:
        """Slide of each body at the end, shape (bodies, 2) [m]."""
        return self.slide[:, -1]

    def to_dataset(self) -> xr.Dataset:
        """Return the histories as a dataset over ``body``, ``time`` and components."""
        import xarray as xr

        about = {"long_name": "time", "units": "s"}
        pressing = {"units": "N", "long_name": "force of the room, and of other bodies, on a body"}
        return xr.Dataset(
            {
                "place": (("body", "time", "axis"), self.place, {"units": "m"}),
                "attitude": (("body", "time", "part"), self.attitude, {"long_name": "unit quaternion"}),
                "velocity": (("body", "time", "axis"), self.velocity, {"units": "m/s"}),
                "rotation_rate": (("body", "time", "axis"), self.rotation_rate, {"units": "rad/s"}),
                "force": (("body", "time", "by", "axis"), self.force, pressing),
                "tilt": (("body", "time"), self.tilt, {"units": "rad"}),
                "yaw": (("body", "time"), self.yaw, {"units": "rad"}),
                "slide": (("body", "time", "level_axis"), self.slide, {"units": "m"}),
                "outcome": ("body", [outcome.value for outcome in self.outcomes]),
                "overturn_time": ("body", self.overturn_time, {"units": "s"}),
                "fall_time": ("body", self.fall_time, {"units": "s"}),
            },
            {
                "time": ("time", self.time, about),
                "axis": list("xyz"),
                "level_axis": list("xy"),
                "part": list("wxyz"),
                "by": ["room", "bodies"],
            },
        )

    def plot(
        self,
        ax: Axes | None = None,
        *,
        what: SpaceDrawing = "tilt",
        names: Sequence[str] | None = None,
        language: str = "en",
    ) -> Axes:
        """Draw one history of every body, or their ways as seen from above, on axes.

        Parameters
        ----------
        ax : Axes, optional
            Where to draw; by default in a new figure of pyplot.
        what : {"tilt", "yaw", "plan", "acceleration"}
            The tilt or the turn in plan [°], the ways in plan [m], or the floor's acceleration [m/s²].
        names : sequence of str, optional
            What the bodies are called; by default by their numbers.
        language : str
            Language of the texts, "en" or "ja".

        Raises
        ------
        InputError
            Something else to draw, another language, or not a name for each body.
        """
        from stayput.report.figures import plotted
        from stayput.report.space.plot import draw_space_run

        return plotted(ax, draw_space_run, self, what, names, language)

    def figure(self, title: str = "", *, names: Sequence[str] | None = None, language: str = "en") -> Figure:
        """Return a figure with the floor's acceleration, tilts and turns over time, and the ways in plan."""
        from stayput.report.space.plot import plot_space_run

        return plot_space_run(self, names=names, title=title, language=language)

    @overload
    def animate(self, path: None = ..., **film: Unpack[_Film]) -> Player: ...
    @overload
    def animate(self, path: str | Path, **film: Unpack[_Film]) -> Path: ...
    def animate(
        self,
        path: str | Path | None = None,
        *,
        names: Sequence[str] | None = None,
        fps: float = 20.0,
        speed: float = 1.0,
        language: str = "en",
    ) -> Path | Player:
        """Write an animation (GIF, MP4 or HTML), or without a path return one that notebooks play.

        See `stayput.report.animation.animate_run`, which has more to choose from.
        """
        from stayput.report.animation import animate_run, run_player

        if path is None:
            return run_player(self, names, speed, language)
        return animate_run(self, path, names=names, fps=fps, speed=speed, language=language)
