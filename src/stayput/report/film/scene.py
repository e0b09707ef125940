"""A scene: bodies, room and floor of a run over time, which every film and page draws.

`FilmScene.data` is the one form in which it leaves Python. ``report/canvas/space.js`` draws it;
`stayput.report.film.frames` draws it with Pillow.
"""

from __future__ import annotations

import base64
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.measures.measure import Held, element_rows
from stayput.mechanics.space.touching import ROOM
from stayput.model.flat_fields import case_columns
from stayput.report.film.shape import SolidShape, StillShape, rounded, shape_of, still_of
from stayput.report.history import sampled, with_overturning
from stayput.report.palette import LINE_COLOURS
from stayput.simulation.placing import held_body
from stayput.simulation.space_fate import Stability, over_time
from stayput.simulation.space_records import matrices, planes_of

if TYPE_CHECKING:
    from stayput.motion.record import Motion
    from stayput.simulation.run import Run


def posed(run: Run) -> Run:
    """Return a run with all that a picture in space draws; one in space, or made so before, as it is.

    A body without a length is as long as it is wide. Like devices of a measure, which in the plane act as
    one, are each drawn where they hold. A body that has overturned lies as it fell until the motion ends.
    """
    if run.standing:
        return run
    held, motion = run.piece.held, run.motion
    assert held is not None  # only of solids, which the plane does not take
    length = held.body.length or held.body.width
    body, parts = replace(held.body, length=length), [part.spread(length) for part in held.elements]
    case = case_columns(body, held.room, run.initial, run.gravity)[0]
    each = Held(body, held.room, tuple(element for part in parts for element in part))
    stood = held_body(case, element_rows(each))
    first = [float(stood.pose[axis]) for axis in "xyz"]
    whole = with_overturning(run)
    lasting = sampled(whole, np.minimum(np.arange(len(motion)), len(whole.time) - 1))
    return replace(
        lasting,
        time=motion.time,
        motion=replace(motion, y=None),
        place=lasting.place + (np.array(first) - run.place[0, 0]),
        standing=(stood.piece,),
        planes=planes_of([stood.piece], held.room),
        springs=stood.springs,
        devices=tuple(device for part, device in zip(parts, run.devices, strict=True) for _ in part),
    )


DRIFT_CORNER = 0.1
"""Ground displacement slower than this is taken out of the picture [Hz]."""

SHIFT_SHOWN = 0.5
"""Largest displacement of the floor that is drawn, in sizes of the bodies; a larger one is drawn smaller."""

TIME_DIGITS = 4
"""Digits of times [s] in a scene's data."""

RATE = 60.0
"""Most poses a second in a scene; pages and films turn between them."""

_FARTHEST = 2.5
"""How far from where the bodies begin the view follows them, in sizes of all of them."""

_POSES_VIEWED = 200
"""Poses from which the view is chosen."""

_DIRECTIONS = 300
"""Directions in which the outermost points are looked for."""


class DrawnTie(NamedTuple):
    """A device or a joint as it is drawn.

    Parameters
    ----------
    body : int
        The body that it holds.
    point : ndarray, shape (3,)
        Where, in the frame of the body [m].
    other : int or None
        The other body that it holds; None for the room.
    anchor : ndarray, shape (3,)
        Where there, in the frame of the other or the room [m].
    lost : float
        When it failed [s]; inf for never.
    """

    body: int
    point: NDArray[np.float64]
    other: int | None
    anchor: NDArray[np.float64]
    lost: float


@dataclass(frozen=True, slots=True, eq=False)
class FilmScene:
    """A run, ready to be drawn.

    Parameters
    ----------
    run : Run
        The run, with what `stayput.report.film.scene` adds to one in the plane.
    names : tuple of str
        What the bodies are called.
    shapes : tuple of SolidShape
        What is drawn of each.
    time : ndarray, shape (n,)
        Times of the poses, evenly spaced [s].
    place : ndarray, shape (bodies, n, 3)
        Centres of gravity [m].
    attitude : ndarray, shape (bodies, n, 4)
        Unit quaternions w, x, y, z.
    shift : ndarray, shape (n, 3)
        Displacement of the floor in the picture [m].
    shift_scale : float
        What part of the floor's displacement the picture shows, at most 1.
    ties : tuple of DrawnTie
        The devices and joints.
    points : ndarray, shape (k, 3)
        The outermost points of the bodies over time and of what holds them, which the picture shows [m].
    still : tuple of StillShape
        Places of people, doors and windows.
    stability : tuple of tuple
        Of each body the times from which on it stands how firmly [s], the first being the start.
    """

    run: Run
    names: tuple[str, ...]
    shapes: tuple[SolidShape, ...]
    time: NDArray[np.float64]
    place: NDArray[np.float64]
    attitude: NDArray[np.float64]
    shift: NDArray[np.float64]
    shift_scale: float
    ties: tuple[DrawnTie, ...]
    points: NDArray[np.float64]
    still: tuple[StillShape, ...]
    stability: tuple[tuple[tuple[float, Stability], ...], ...]

    @property
    def start(self) -> float:
        """Time of the first pose [s]."""
        return float(self.time[0])

    @property
    def end(self) -> float:
        """Time of the last pose [s]."""
        return float(self.time[-1])

    @property
    def low(self) -> NDArray[np.float64]:
        """Lowest corner of the box around what the picture shows, shape (3,) [m]."""
        return self.points.min(axis=0)

    @property
    def high(self) -> NDArray[np.float64]:
        """Highest corner of that box, shape (3,) [m]."""
        return self.points.max(axis=0)

    @property
    def grid(self) -> float:
        """Distance of the lines on the floor [m]: a round number, some five to a dozen in a picture."""
        wide, long, tall = self.high - self.low
        rough = max(wide, long, 1.3 * tall) / 8.0
        power = 10.0 ** math.floor(math.log10(rough))
        return power * next(step for step in (1.0, 2.0, 5.0, 10.0) if step * power >= rough)

    @property
    def view(self) -> str:
        """From where it is seen at first: a key of `stayput.report.film.frames.VIEWS`."""
        return "side" if self.run.engine == "plane" else "free"

    @property
    def planes(self) -> list[tuple[float, float, float, float]]:
        """Walls and ceiling: planes n·x = offset, as n into the room and the offset [m]."""
        planes = self.run.planes
        return [tuple(plane[name].item() for name in ("nx", "ny", "nz", "offset")) for plane in planes[1:]]

    def corners(
        self, body: int, turn: NDArray[np.float64], place: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Return the corners of a body in a pose, shape (vertices, 3) [m]."""
        solid = self.run.standing[body].solid
        return place + (solid.vertices - solid.centre_of_gravity) @ turn.T

    def pose(self, time: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return places, shape (bodies, 3) [m], and rotations, shape (bodies, 3, 3), at a time [s]."""
        places, attitudes = _between(self.time, self.place, self.attitude, np.array([time]))
        return places[:, 0], matrices(attitudes[:, 0])

    def stability_at(self, body: int, time: float) -> Stability:
        """Return how firmly a body stands at a time [s]."""
        steps = self.stability[body]
        return next((step for start, step in reversed(steps) if start <= time), steps[0][1])

    def shift_at(self, time: float) -> NDArray[np.float64]:
        """Return the displacement of the floor in the picture at a time [s], shape (3,) [m]."""
        return np.array([float(np.interp(time, self.time, self.shift[:, axis])) for axis in range(3)])

    def data(self) -> dict[str, Any]:
        """Return the scene as plain values for JSON.

        Long histories are texts: the base 64 of 32-bit floating-point numbers, least byte first.

        Returns
        -------
        dict
            ``poses``: ``start_s``, ``end_s``, ``count``. ``floor``: ``shift_m`` (at the poses), ``dt_s`` and
            ``acceleration_m_s2`` by components (at the motion's samples). ``planes``: walls and ceiling.
            ``view``: ``from`` (see `FilmScene.view`), ``low_m``, ``high_m``, ``grid_m``, ``points_m``.
            ``bodies``: ``name``, ``line`` (colour of its lines), ``shape`` (see `SolidShape.data`),
            ``centre_of_gravity_m``, ``footprint_m`` (where it first stood on the floor), ``stability`` (see
            `FilmScene.stability`), and at the poses ``place_m``, ``attitude``, ``tilt_rad``, ``slide_m``,
            ``yaw_rad``; tilt and slide have signs in the plane.
            ``still``: see `StillShape.data`.
            ``ties``: ``body``, ``point_m``, ``other``, ``anchor_m``, ``lost_s`` or None; see `DrawnTie`.
        """
        run = self.run
        return {
            "poses": {
                "start_s": round(self.start, TIME_DIGITS),
                "end_s": round(self.end, TIME_DIGITS),
                "count": len(self.time),
            },
            "floor": {
                "shift_m": packed(self.shift),
                "dt_s": run.motion.dt,
                "acceleration_m_s2": {name: packed(a) for name, a in run.motion.components.items()},
            },
            "planes": self.planes,
            "view": {
                "from": self.view,
                "low_m": rounded(self.low),
                "high_m": rounded(self.high),
                "grid_m": self.grid,
                "points_m": [rounded(point, 3) for point in self.points],
            },
            "bodies": [
                {
                    "name": self.names[b],
                    "line": LINE_COLOURS[b % len(LINE_COLOURS)],
                    "shape": self.shapes[b].data(),
                    "centre_of_gravity_m": rounded(standing.solid.centre_of_gravity),
                    "footprint_m": [rounded(corner) for corner in self.footprint(b)],
                    "stability": [(round(time, TIME_DIGITS), step) for time, step in self.stability[b]],
                    "place_m": packed(self.place[b]),
                    "attitude": packed(self.attitude[b]),
                    "tilt_rad": packed(self._at_poses(piece.tilt)),
                    "slide_m": packed(self._at_poses(piece.slide)),
                    "yaw_rad": packed(self._at_poses(piece.yaw)),
                }
                for b, (standing, piece) in enumerate(zip(run.standing, run.pieces, strict=True))
            ],
            "still": [shape.data() for shape in self.still],
            "ties": [
                {
                    "body": tie.body,
                    "point_m": rounded(tie.point),
                    "other": tie.other,
                    "anchor_m": rounded(tie.anchor),
                    "lost_s": None if math.isinf(tie.lost) else round(tie.lost, TIME_DIGITS),
                }
                for tie in self.ties
            ],
        }

    def ends(
        self, tie: DrawnTie, places: NDArray[np.float64], turns: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Return both ends of a device where the bodies are, of `pose`, shape (2, 3) [m]."""

        def seen(body: int | None, point: NDArray[np.float64]) -> NDArray[np.float64]:
            if body is None:
                return point
            solid = self.run.standing[body].solid
            return places[body] + turns[body] @ (point - solid.centre_of_gravity)

        return np.stack([seen(tie.body, tie.point), seen(tie.other, tie.anchor)])

    def _at_poses(self, history: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.asarray(np.interp(self.time, self.run.time, history))

    def footprint(self, body: int) -> NDArray[np.float64]:
        """Return the outline of a body's base as it first stands on the floor, shape (k, 3) [m]; or none."""
        shape, turn = self.shapes[body], matrices(self.attitude[body, 0])
        corners = self.corners(body, turn, self.place[body, 0])
        lowest = int(np.argmin(shape.solid.normals @ turn[2]))
        base = corners[shape.solid.faces[lowest]]
        on_floor = base[:, 2].max() < 0.02 * float(np.ptp(corners, axis=0).max())
        return base * [1.0, 1.0, 0.0] if on_floor else np.empty((0, 3))


_STEP = 2.0**-16
"""To what histories are rounded in a scene: 0.015 mm. Bits that are 0 take a third off what is sent."""


def packed(values: NDArray[np.float64]) -> str:
    """Return values as the base 64 of 32-bit floating-point numbers, rounded to `_STEP`."""
    rounded_values = np.round(values / _STEP) * _STEP + 0.0
    return base64.b64encode(rounded_values.astype("<f4").tobytes()).decode("ascii")


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


def scene_of(run: Run, names: tuple[str, ...], beside: Sequence[Run] = ()) -> FilmScene:
    """Make a run ready to be drawn.

    Parameters
    ----------
    run : Run
        The run, of two samples at least; one in the plane as `posed` makes it.
    names : tuple of str
        What the bodies are called.
    beside : sequence of Run
        Runs that are shown beside each other, this one among them: each picture has room for all of them, so
        that they are to one scale.
    """
    start, end = float(run.time[0]), float(run.time[-1])
    count = min(len(run.time), math.ceil((end - start) * RATE) + 1)
    times = np.linspace(start, end, count)
    place, attitude = _between(run.time, run.place, run.attitude, times)
    views = [_outermost(other) for other in beside or (run,)]
    still, ties = still_of(run), [tie for other in beside or (run,) for tie in _ties(other)]
    fixed = [
        *(shape.points for shape in still),
        *(tie.anchor[np.newaxis] for tie in ties if tie.other is None),
    ]
    points = _at_the_rim(np.concatenate([*(points for points, _ in views), *fixed]))
    size = max(size for _, size in views)
    ground = np.zeros((len(run.motion), 3))
    for name in run.motion.components:
        ground[:, "xyz".index(name)] = ground_displacement(run.motion.component(name))
    largest = float(np.linalg.norm(ground, axis=1).max())
    scale = min(1.0, SHIFT_SHOWN * size / largest) if largest > 0.0 else 1.0
    shift = np.column_stack([scale * np.interp(times, run.motion.time, along) for along in ground.T])
    shapes = tuple(shape_of(piece.solid) for piece in run.standing)
    stability = tuple(_steps(run, body) for body in range(len(shapes)))
    return FilmScene(
        run, names, shapes, times, place, attitude, shift, scale, _ties(run), points, still, stability
    )


def _steps(run: Run, body: int) -> tuple[tuple[float, Stability], ...]:
    """Return from which times on a body stands how firmly [s]."""
    steps = over_time(run, body)
    starts = [0, *(np.flatnonzero(steps[1:] != steps[:-1]) + 1).tolist()]
    return tuple((float(run.time[start]), Stability(steps[start])) for start in starts)


def _ties(run: Run) -> tuple[DrawnTie, ...]:
    """Return the devices and joints of a run."""

    def in_frame(body: int, spring: np.void, names: tuple[str, str, str]) -> NDArray[np.float64]:
        solid = run.standing[body].solid
        return solid.centre_of_gravity + solid.principal[1] @ [float(spring[name]) for name in names]

    ties: list[DrawnTie] = []
    under_ceiling = {measure.kind for measure in run.measures if measure.needs == "ceiling"}
    for spring, device in zip(run.springs, run.devices, strict=True):
        body, other, anchor = int(spring["body"]), int(spring["other"]), ("ax", "ay", "az")
        if other == ROOM:
            end = np.array([float(spring[name]) for name in anchor])
            if device.kind in under_ceiling and run.room.ceiling is not None:
                end[2] = run.room.ceiling.height
        else:
            end = in_frame(other, spring, anchor)
        point, lost = in_frame(body, spring, ("px", "py", "pz")), device.failure_time
        held, lost = None if other == ROOM else other, lost if device.failed else math.inf
        ties.append(DrawnTie(body, point, held, end, lost))
    return tuple(ties)


def _between(
    time: NDArray[np.float64],
    place: NDArray[np.float64],
    attitude: NDArray[np.float64],
    wanted: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return places, shape (bodies, n, 3), and attitudes, shape (bodies, n, 4), at n times between samples.

    Places are linear in time; attitudes turn evenly about a fixed axis, the short way round.
    """
    first = np.clip(np.searchsorted(time, wanted, side="right") - 1, 0, len(time) - 2)
    share = np.clip((wanted - time[first]) / (time[first + 1] - time[first]), 0.0, 1.0)[:, np.newaxis]
    places = place[:, first] + share * (place[:, first + 1] - place[:, first])
    q, r = attitude[:, first], attitude[:, first + 1]
    cosine = np.einsum("bni,bni->bn", q, r)[..., np.newaxis]
    r = np.where(cosine < 0.0, -r, r)
    angle = np.arccos(np.minimum(np.abs(cosine), 1.0))
    nearly = angle < 1e-6
    sine = np.where(nearly, 1.0, np.sin(angle))
    parts = (np.where(nearly, s, np.sin(s * angle) / sine) for s in (1.0 - share, share))
    attitudes = sum(part * quaternion for part, quaternion in zip(parts, (q, r), strict=True))
    return places, attitudes / np.linalg.norm(attitudes, axis=-1, keepdims=True)


def _outermost(run: Run) -> tuple[NDArray[np.float64], float]:
    """Return the outermost points of the bodies over time, near the start, and their size at first [m]."""
    some = np.linspace(0, len(run.time) - 1, min(len(run.time), _POSES_VIEWED)).astype(np.intp)
    paths: list[NDArray[np.float64]] = []
    for b, piece in enumerate(run.standing):
        arms = piece.solid.vertices - piece.solid.centre_of_gravity
        turns = np.swapaxes(matrices(run.attitude[b, some]), 1, 2)
        paths.append(run.place[b, some, np.newaxis] + arms @ turns)
    first = np.concatenate([corners[0] for corners in paths])
    size = float(np.ptp(first, axis=0).max())
    reach = _FARTHEST * size
    points = np.concatenate([corners.reshape(-1, 3) for corners in paths])
    points = np.clip(points, first.min(axis=0) - reach, first.max(axis=0) + reach)
    return _at_the_rim(points), size


def _at_the_rim(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the outermost of some points in directions all around, evenly spread on a spiral."""
    height = np.linspace(-1.0, 1.0, _DIRECTIONS)
    turn = math.pi * (3.0 - math.sqrt(5.0)) * np.arange(_DIRECTIONS)
    across = np.sqrt(1.0 - height**2)
    directions = np.column_stack((across * np.cos(turn), across * np.sin(turn), height))
    along = np.einsum("di,ip->dp", directions, np.ascontiguousarray(points.T))  # with a thread of its own
    return points[np.unique(along.argmax(axis=1))]
