"""What an animation shows, before it is drawn: poses, the ground's displacement, the view, the words."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.cases import wall_faces
from stayput.errors import InputError
from stayput.report.history import History, history, turned
from stayput.report.props import Prop, props_of
from stayput.report.summary import motion_label, sentence

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.body import Body
    from stayput.motion import Motion
    from stayput.simulation import Mode, Run

DRIFT_CORNER = 0.1
"""Ground displacement slower than this is taken out of the picture [Hz]."""

_SHIFT_SHOWN = 0.5  # largest displacement shown, in sizes of the body
_WALL_SHOWN = 1.5  # a wall or a ceiling farther away than this is left out of the picture, in sizes


@dataclass(frozen=True, slots=True)
class Pose:
    """The body and the room at one instant.

    Parameters
    ----------
    time : float
        Time [s].
    x, z : float
        Centre of gravity in the room [m].
    tilt : float
        Tilt [rad].
    shift : float
        The room's displacement in the picture, + right [m].
    mode : Mode
        How the body moves.
    """

    time: float
    x: float
    z: float
    tilt: float
    shift: float
    mode: Mode


@dataclass(frozen=True, slots=True, eq=False)
class Film:
    """A run made ready for showing.

    Parameters
    ----------
    body : Body
        What stands.
    motion : Motion
        How the floor moves.
    history : History
        Where the body is when.
    title : str
        What became of the body, in one sentence.
    motion_title : str
        What the motion is called, and its peak.
    shift : ndarray, shape (n,)
        The room's displacement in the picture at the history's times, + right [m].
    shift_scale : float
        What part of the ground's displacement the picture shows, at most 1.
    view : tuple of float
        Left, right, lower and upper end of what is shown [m].
    left_wall, right_wall, ceiling : float or None
        Where the faces of the room stand, when they are in view [m].
    props : tuple of Prop
        The devices.
    """

    body: Body
    motion: Motion
    history: History
    title: str
    motion_title: str
    shift: NDArray[np.float64]
    shift_scale: float
    view: tuple[float, float, float, float]
    left_wall: float | None
    right_wall: float | None
    ceiling: float | None
    props: tuple[Prop, ...] = ()

    @property
    def caption(self) -> str:
        """Say what is shown of the ground's motion."""
        part = "" if self.shift_scale >= 1.0 else f", drawn at {100.0 * self.shift_scale:.0f} % of its size"
        return (
            "The room moves with the ground: the record integrated twice, without its drift below "
            f"{DRIFT_CORNER:g}\u00a0Hz{part}. The dotted lines stand still, {self.grid:g}\u00a0m apart."
        )

    @property
    def grid(self) -> float:
        """Distance of the still dotted lines [m]: a round number, some five to a dozen of them in view."""
        rough = (self.view[1] - self.view[0]) / 10.0
        power = 10.0 ** math.floor(math.log10(rough))
        return power * next(step for step in (1.0, 2.0, 5.0, 10.0) if step * power >= rough)

    def middle(self, width: float) -> float:
        """Return what stands in the middle of a picture so wide [m]: a single wall stays at its edge."""
        left, right = self.view[:2]
        if (self.left_wall is None) == (self.right_wall is None):
            return 0.5 * (left + right)
        return left + 0.5 * width if self.right_wall is None else right - 0.5 * width

    def at(self, time: float) -> Pose:
        """Return the pose at a time [s], linear between the samples; the last one after the end."""
        shown = self.history
        instant = min(max(time, float(shown.time[0])), shown.end)
        sample = int(np.searchsorted(shown.time, instant, side="right")) - 1
        x, z, tilt, shift = (
            float(np.interp(instant, shown.time, values))
            for values in (shown.x, shown.z, shown.tilt, self.shift)
        )
        return Pose(instant, x, z, tilt, shift, shown.mode[sample])

    def times(self, fps: float, speed: float, hold: float) -> NDArray[np.float64]:
        """Return the instant that each frame shows [s].

        Parameters
        ----------
        fps : float
            Frames a second of the film.
        speed : float
            Seconds of the run shown in one second of the film.
        hold : float
            How long the last pose is held [s of the film].
        """
        start, end = float(self.history.time[0]), self.history.end
        moving = start + np.arange(math.ceil((end - start) * fps / speed - 1e-9)) * speed / fps
        return np.append(moving, np.full(max(1, round(hold * fps)), end))


def film_of(run: Run, name: str = "body") -> Film:
    """Make a run ready for showing.

    Parameters
    ----------
    run : Run
        The run.
    name : str
        What the body is called.

    Raises
    ------
    InputError
        The run has fewer than two samples.
    """
    shown = history(run)
    if len(shown.time) < 2:
        raise InputError(f"The run has {len(shown.time)} samples; an animation needs at least 2.")
    size = max(run.body.width, run.body.height)
    ground = ground_displacement(run.motion)
    largest = float(np.abs(ground).max())
    scale = min(1.0, _SHIFT_SHOWN * size / largest) if largest > 0.0 else 1.0
    shift = scale * np.interp(shown.time, run.motion.time, ground)
    left, right, ceiling = _faces(run, _WALL_SHOWN * size)
    title = f"{motion_label(run.motion)}, peak {run.motion.pga:.1f} m/s²"
    view = _view(run.body, shown, shift, (left, right, ceiling))
    told = sentence(run, name)
    props = props_of(run)
    return Film(run.body, run.motion, shown, told, title, shift, scale, view, left, right, ceiling, props)


def ground_displacement(motion: Motion) -> NDArray[np.float64]:
    """Return the ground's displacement along x for a picture [m], shape (n,).

    The acceleration is integrated twice in the frequency domain with the gain 1/(1 + (f_c/f)⁴), so
    that what is slower than f_c = `DRIFT_CORNER` does not carry the room out of view. The phase is kept.
    """
    padding = math.ceil(2.0 / DRIFT_CORNER / motion.dt)
    length = 1 << (len(motion) + 2 * padding - 1).bit_length()
    f = np.fft.rfftfreq(length, motion.dt)
    gain = -(f**2) / (f**4 + DRIFT_CORNER**4) / (2.0 * math.pi) ** 2
    shown = np.fft.irfft(gain * np.fft.rfft(motion.x, length), length)
    return np.asarray(shown[: len(motion)], dtype=np.float64)


def section(body: Body, pose: Pose) -> list[tuple[float, float]]:
    """Return the corners A, B, D, C of the tilted section in the room [m], around the outline."""
    a, b, c, d = body.corners
    places = (turned(corner, pose.tilt) for corner in (a, b, d, c))
    return [(pose.x + right, pose.z + up) for right, up in places]


def _faces(run: Run, farthest: float) -> tuple[float | None, float | None, float | None]:
    room = run.room
    at_left, at_right = wall_faces(run.body, room)
    left = None if room.left_wall is None or room.left_wall.gap > farthest else at_left
    right = None if room.right_wall is None or room.right_wall.gap > farthest else at_right
    high = None if room.ceiling is None else room.ceiling.height
    return left, right, None if high is None or high > run.body.height + farthest else high


def _view(
    body: Body,
    shown: History,
    shift: NDArray[np.float64],
    faces: tuple[float | None, float | None, float | None],
) -> tuple[float, float, float, float]:
    size = max(body.width, body.height)
    cos, sin = np.cos(shown.tilt), np.sin(shown.tilt)
    sides = [shown.x + u * cos + v * sin + shift for u, v in body.corners]
    tops = [shown.z - u * sin + v * cos for u, v in body.corners]
    left, right, ceiling = faces
    margin = 0.25 * size
    low = min(float(np.min(side)) for side in sides) - margin
    high = max(float(np.max(side)) for side in sides) + margin
    if left is not None:
        low = min(low, left + float(shift.min()) - 0.15 * size)
    if right is not None:
        high = max(high, right + float(shift.max()) + 0.15 * size)
    top = max(float(np.max(value)) for value in tops) + 0.12 * size
    if ceiling is not None:
        top = max(top, ceiling + 0.08 * size)
    return low, high, -0.14 * size, top
