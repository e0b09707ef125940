"""A scene: body, room and devices of one or more runs over time, which every picture and page draws.

`PlaneScene.data` is the one form in which a scene leaves Python: for the page's API, the animation's HTML
file and the report. ``report/canvas/painter.js`` draws it; `stayput.report.frames` draws a scene with Pillow.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.measures.sketch import shapes, sketch
from stayput.model.state import wall_faces
from stayput.report.history import History, history, turned
from stayput.report.summary import attributes, device_results

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.model.body import Body
    from stayput.motion import Motion
    from stayput.simulation.outcome import Mode
    from stayput.simulation.run import Run

DRIFT_CORNER = 0.1
"""Ground displacement slower than this is taken out of the picture [Hz]."""

SHIFT_SHOWN = 0.5
"""Largest displacement of the floor that is drawn, in sizes of the body; a larger one is drawn smaller."""

FACE_SHOWN = 1.0
"""A wall or a ceiling farther away than this does not widen the picture, in sizes of the body."""

LENGTH_DIGITS = 5
"""Digits of lengths [m] and angles [rad] in a scene's data: 0.01 mm."""

TIME_DIGITS = 4
"""Digits of times [s] in a scene's data."""


@dataclass(frozen=True, slots=True)
class Pose:
    """One body and its room at one instant.

    Parameters
    ----------
    time : float
        Time [s].
    x, z : float
        Centre of gravity in the room [m].
    tilt : float
        Tilt from rest [rad].
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


@dataclass(frozen=True, slots=True)
class View:
    """The part of the room in the picture, common to all runs of a scene.

    Parameters
    ----------
    left, right, low, high : float
        Its ends [m].
    """

    left: float
    right: float
    low: float
    high: float

    @property
    def grid(self) -> float:
        """Distance of the still dotted lines [m]: a round number, some five to a dozen in a picture."""
        rough = max(self.right - self.left, 1.3 * (self.high - self.low)) / 8.0
        power = 10.0 ** math.floor(math.log10(rough))
        return power * next(step for step in (1.0, 2.0, 5.0, 10.0) if step * power >= rough)

    def data(self) -> dict[str, float]:
        """Return the view as plain values: its ends and ``grid_m``."""
        ends = {"left_m": self.left, "right_m": self.right, "low_m": self.low, "high_m": self.high}
        return {name: round(end, LENGTH_DIGITS) for name, end in ends.items()} | {"grid_m": self.grid}


@dataclass(frozen=True, slots=True, eq=False)
class PlaneScene:
    """Runs under one motion of the floor, ready to be drawn.

    Parameters
    ----------
    runs : tuple of Run
        The runs; those side by side are drawn to one scale.
    histories : tuple of History
        Where each body is when, until it lies.
    motion : Motion
        How the floor moves.
    start, end : float
        What part of the time is shown [s].
    shift : ndarray, shape (n,)
        The floor's displacement in the picture at the motion's samples, + right [m].
    shift_scale : float
        What part of the floor's displacement the picture shows, at most 1.
    view : View
        What part of the room is shown.
    """

    runs: tuple[Run, ...]
    histories: tuple[History, ...]
    motion: Motion
    start: float
    end: float
    shift: NDArray[np.float64]
    shift_scale: float
    view: View

    def pose(self, time: float) -> Pose:
        """Return the first run's pose at a time [s], linear between samples; the last one after its end."""
        shown = self.histories[0]
        instant = min(max(time, float(shown.time[0])), shown.end)
        sample = int(np.searchsorted(shown.time, instant, side="right")) - 1
        x, z, tilt = (float(np.interp(instant, shown.time, v)) for v in (shown.x, shown.z, shown.tilt))
        shift = float(np.interp(instant, self.motion.time, self.shift))
        return Pose(instant, x, z, tilt, shift, shown.mode[sample])

    def devices(self, pose: Pose) -> list[dict[str, Any]]:
        """Return the shapes of the first run's devices in a pose; see `stayput.measures.shapes`."""
        run = self.runs[0]
        if run.held is None:
            return []
        failed = [n for n, device in enumerate(run.devices) if device.failure_time <= pose.time]
        return shapes(run.held, pose.x, pose.z, pose.tilt + run.body.resting_tilt, failed)

    def data(self, rate: float | None = None) -> dict[str, Any]:
        """Return the scene as plain values for JSON.

        Parameters
        ----------
        rate : float, optional
            Poses a second; by default those of the motion's samples.

        Returns
        -------
        dict
            ``floor``: ``time_s``, ``x_m`` (displacement in the picture), ``acceleration_m_s2`` (the largest
            around each time, with its sign), ``scale_shown``. ``view``: ``left_m``, ``right_m``, ``low_m``,
            ``high_m``, ``grid_m``. ``runs``: see `run_data`.
        """

        def poses(shown: History) -> NDArray[np.float64]:
            last = max(self.start, min(self.end, shown.end))
            return shown.time if rate is None else frames(self.start, last, rate)

        times = self.motion.time if rate is None else frames(self.start, self.end, rate)
        times = times[(times >= self.start) & (times <= self.end)]
        return {
            "floor": {
                "time_s": rounded(times, TIME_DIGITS),
                "x_m": rounded(np.interp(times, self.motion.time, self.shift)),
                "acceleration_m_s2": rounded(_accelerations(self.motion, times, rate), 3),
                "scale_shown": self.shift_scale,
            },
            "view": self.view.data(),
            "runs": [
                run_data(run, shown, poses(shown))
                for run, shown in zip(self.runs, self.histories, strict=True)
            ],
        }


def scene_of(runs: Sequence[Run], start: float = 0.0, end: float | None = None) -> PlaneScene:
    """Make runs under one motion ready to be drawn.

    Parameters
    ----------
    runs : sequence of Run
        The runs.
    start, end : float
        What part of the time is shown [s]; by default until the last run ends.
    """
    motion, body = runs[0].motion, runs[0].body
    histories = tuple(history(run) for run in runs)
    until = max(shown.end for shown in histories) if end is None else end
    ground = ground_displacement(motion)
    inside = (motion.time >= start) & (motion.time <= until)
    largest = float(np.abs(ground[inside]).max(initial=0.0))
    size = max(body.width, body.height)
    scale = min(1.0, SHIFT_SHOWN * size / largest) if largest > 0.0 else 1.0
    shift = scale * ground
    view = _view(runs, histories, start, until, motion.time, shift)
    return PlaneScene(tuple(runs), histories, motion, start, until, shift, scale, view)


def run_data(run: Run, shown: History, at: NDArray[np.float64]) -> dict[str, Any]:
    """Return one run of a scene as plain values for JSON, in SI units that the keys name.

    Parameters
    ----------
    run : Run
        The run.
    shown : History
        Its histories as they are shown.
    at : ndarray
        Times of the poses [s].

    Returns
    -------
    dict
        - ``body``: ``width_m``, ``height_m``, ``mass_kg``, ``inertia_kg_m2``, ``centre_of_gravity_m`` (from
          the middle of the base), ``corners_m`` (base left, base right, top right, top left, from the centre
          of gravity), ``base_heights_m``, ``resting_tilt_rad`` (to which ``tilt_rad`` adds),
          ``slenderness_rad``;
        - ``room``: ``left_wall_x_m``, ``right_wall_x_m``, ``ceiling_z_m``, null where there is none; x = 0 is
          the middle of the base at the start;
        - ``time_s``, ``x_m``, ``z_m`` (centre of gravity in the room), ``tilt_rad``, ``slide_m``;
        - ``modes``: pairs of the time from which the body moves in a mode, and the mode;
        - ``devices``: what became of each, with ``pull_n`` and ``shear_n`` at the times above;
        - ``shapes``: ``kind``, ``points`` (frame "body" or "room", right, up), ``role``, ``device`` (its
          place in ``devices``, or null), ``when`` ("always", or while the device is "whole" or "broken").
    """
    body = run.body
    a, b, c, d = body.corners
    histories = {"x_m": shown.x, "z_m": shown.z, "tilt_rad": shown.tilt, "slide_m": shown.slide}
    return {
        "body": {
            "width_m": body.width,
            "height_m": body.height,
            "mass_kg": body.mass,
            "inertia_kg_m2": body.inertia_about_cg,
            "centre_of_gravity_m": body.centre_of_gravity,
            "corners_m": [a, b, d, c],
            "base_heights_m": body.base_heights,
            "resting_tilt_rad": body.resting_tilt,
            "slenderness_rad": min(body.slenderness),
        },
        "room": room_data(run),
        "time_s": rounded(at, TIME_DIGITS),
        **{key: rounded(np.interp(at, shown.time, values)) for key, values in histories.items()},
        "modes": [(round(start, TIME_DIGITS), mode.value) for start, _, mode in shown.spans()],
        "devices": [
            {
                **device_results(device),
                "pull_n": rounded(np.interp(at, run.time, device.pull), 1),
                "shear_n": rounded(np.interp(at, run.time, device.shear), 1),
            }
            for device in run.devices
        ],
        "shapes": [
            {**attributes(part, "kind", "role", "when"), "points": list(part.points), "device": part.element}
            for part in (() if run.held is None else sketch(run.held))
        ],
    }


def room_data(run: Run) -> dict[str, float | None]:
    """Return where the faces stand: gaps are from the sides of the body as it stands at rest."""
    left, right, ceiling = run.room.left_wall, run.room.right_wall, run.room.ceiling
    at_left, at_right = wall_faces(run.body, run.room)
    return {
        "left_wall_x_m": None if left is None else at_left,
        "right_wall_x_m": None if right is None else at_right,
        "ceiling_z_m": None if ceiling is None else ceiling.height,
    }


def rounded(values: NDArray[np.float64], digits: int = LENGTH_DIGITS) -> list[float]:
    """Return values as a list with so many digits after the point; −0 is 0."""
    return (np.round(values, digits) + 0.0).tolist()


def frames(start: float, end: float, rate: float) -> NDArray[np.float64]:
    """Return the times of a picture's frames [s], with the end itself."""
    return np.append(start + np.arange(0.0, end - start, 1.0 / rate), end)


def _accelerations(motion: Motion, times: NDArray[np.float64], rate: float | None) -> NDArray[np.float64]:
    """Return the acceleration of largest size around each frame, with its sign: no peak is lost."""
    if rate is None or motion.dt >= 1.0 / rate:
        return np.interp(times, motion.time, motion.x)
    inside = (motion.time >= times[0]) & (motion.time <= times[-1])
    nearest = np.minimum(np.rint((motion.time[inside] - times[0]) * rate).astype(np.intp), len(times) - 1)
    starts = np.flatnonzero(np.diff(nearest, prepend=-1))
    if len(starts) == 0:
        return np.interp(times, motion.time, motion.x)
    high, low = (f.reduceat(motion.x[inside], starts) for f in (np.maximum, np.minimum))
    peaks = np.zeros(len(times))
    peaks[nearest[starts]] = np.where(high >= -low, high, low)
    return peaks


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
    a, b, c, d = body.corners_at_rest
    places = (turned(corner, pose.tilt) for corner in (a, b, d, c))
    return [(pose.x + right, pose.z + up) for right, up in places]


def _view(
    runs: Sequence[Run],
    histories: Sequence[History],
    start: float,
    end: float,
    time: NDArray[np.float64],
    shift: NDArray[np.float64],
) -> View:
    """Return a view of all bodies all the time, and of the walls and the ceiling where they are near."""
    size = max(runs[0].body.width, runs[0].body.height)
    lows: list[float] = []
    highs: list[float] = []
    tops: list[float] = []
    for run, shown in zip(runs, histories, strict=True):
        inside = (shown.time >= start) & (shown.time <= end)
        inside[-1] |= not inside.any()  # a run that ended before: as it lies
        x, z, tilt, at = shown.x[inside], shown.z[inside], shown.tilt[inside], shown.time[inside]
        moved, cos, sin = np.interp(at, time, shift), np.cos(tilt), np.sin(tilt)
        for u, v in run.body.corners_at_rest:
            across = x + u * cos + v * sin + moved
            lows.append(float(across.min()))
            highs.append(float(across.max()))
            tops.append(float((z - u * sin + v * cos).max()))
        room = run.room
        at_left, at_right = wall_faces(run.body, room)
        if room.left_wall is not None and room.left_wall.gap <= FACE_SHOWN * size:
            lows.append(at_left + float(moved.min()))
        if room.right_wall is not None and room.right_wall.gap <= FACE_SHOWN * size:
            highs.append(at_right + float(moved.max()))
        if room.ceiling is not None and room.ceiling.height <= run.body.height + FACE_SHOWN * size:
            tops.append(room.ceiling.height)
    return View(min(lows) - 0.15 * size, max(highs) + 0.15 * size, -0.12 * size, max(tops) + 0.08 * size)
