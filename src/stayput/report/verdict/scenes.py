"""What the page's script draws of a pair of runs: small whole numbers, each the step from the one before."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.cases import wall_faces
from stayput.measures import sketch
from stayput.report.palette import MODE_COLOURS
from stayput.report.verdict.words import MODES, place
from stayput.simulation import Mode

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from stayput.measures import Held
    from stayput.report.verdict.pairs import Pair, Side

STEP = 0.02
"""Time between the poses that are kept [s]; the script draws straight lines between them."""

LENGTH, ANGLE = 1e-4, 1e-4
"""What one step of a number means [m, rad]."""

_WALL_SHOWN = 1.0
"""A wall or a ceiling farther away than this is left out, in sizes of the piece."""


def scene(pair: Pair, language: str) -> dict[str, Any]:
    """Return what is drawn of a pair of runs, as plain values.

    Parameters
    ----------
    pair : Pair
        The runs.
    language : str
        "en" or "ja".
    """
    count = int((pair.end - pair.start) / STEP + 1e-9) + 1
    time = pair.start + STEP * np.arange(count, dtype=np.float64)
    moved, scale = pair.shift
    shift = np.interp(time, pair.motion.time, moved)
    sides = [_side(side, time, language) for side in pair.sides]
    view = _view(pair, time, shift)
    return {
        "start": float(pair.start),
        "step": STEP,
        "count": count,
        "length": LENGTH,
        "angle": ANGLE,
        "telling": round(pair.telling, 3),
        "view": [round(end, 4) for end in view],
        "grid": grid(view),
        "part": scale,
        "shift": steps(shift, LENGTH),
        "sides": sides,
        "colours": {mode.value: colour for mode, colour in MODE_COLOURS.items()},
        "modes": {mode.value: MODES[mode][place(language)] for mode in Mode},
    }


def grid(view: tuple[float, float, float, float]) -> float:
    """Return the distance of the still dotted lines [m]."""
    wide = view[1] - view[0]
    return next((step for step in (0.1, 0.2, 0.5, 1.0, 2.0) if wide / step < 12.0), 5.0)


def steps(values: ArrayLike, unit: float) -> list[int]:
    """Return values as whole numbers of a unit: the first one, then the differences."""
    whole = np.rint(np.asarray(values, np.float64) / unit).astype(np.int64)
    return np.diff(whole, prepend=0).tolist()


def _side(side: Side, time: NDArray[np.float64], language: str) -> dict[str, Any]:
    run, shown = side.run, side.shown
    held = run.held
    assert held is not None
    left, right, ceiling = _faces(held)
    kept = [(float(start), mode.value) for start, _, mode in shown.spans()]
    return {
        "label": side.option.label(language),
        "corners": [[round(u, 4), round(v, 4)] for u, v in (run.body.corners[i] for i in (0, 1, 3, 2))],
        "left": left,
        "right": right,
        "ceiling": ceiling,
        "x": steps(np.interp(time, shown.time, shown.x), LENGTH),
        "z": steps(np.interp(time, shown.time, shown.z), LENGTH),
        "tilt": steps(np.interp(time, shown.time, shown.tilt), ANGLE),
        "slide": steps(np.interp(time, shown.time, shown.slide), LENGTH),
        "modes": _modes(kept, float(time[0])),
        "shapes": _shapes(held),
        "failures": [round(d.failure_time, 3) if d.failed else None for d in run.devices],
    }


def _modes(spans: list[tuple[float, str]], start: float) -> list[list[float | str]]:
    """Return when each mode begins, none that ends before the start and none twice."""
    found: list[list[float | str]] = []
    for time, mode in spans:
        if found and time <= start:
            found.clear()
        if not found or found[-1][1] != mode:
            found.append([round(time, 3), mode])
    return found


def _faces(held: Held) -> tuple[float | None, float | None, float | None]:
    far = _WALL_SHOWN * max(held.body.width, held.body.height)
    at_left, at_right = wall_faces(held.body, held.room)
    left, right, ceiling = held.room.left_wall, held.room.right_wall, held.room.ceiling
    return (
        None if left is None or left.gap > far else at_left,
        None if right is None or right.gap > far else at_right,
        None if ceiling is None or ceiling.height > held.body.height + far else ceiling.height,
    )


def _shapes(held: Held) -> list[dict[str, Any]]:
    """Return the devices' shapes, what goes with the body relative to its centre of gravity."""
    x, z = held.body.centre_of_gravity
    return [
        {
            "kind": shape.kind,
            "role": shape.role,
            "element": shape.element,
            "when": shape.when,
            "points": [
                [1, round(u - x, 4), round(v - z, 4)] if frame == "body" else [0, round(u, 4), round(v, 4)]
                for frame, u, v in shape.points
            ],
        }
        for shape in sketch(held)
    ]


def _view(
    pair: Pair, time: NDArray[np.float64], shift: NDArray[np.float64]
) -> tuple[float, float, float, float]:
    """Return the left, right, lower and upper end of what both scenes show [m]."""
    body = pair.sides[0].run.body
    size = max(body.width, body.height)
    lows: list[float] = []
    highs: list[float] = []
    tops: list[float] = []
    for side in pair.sides:
        shown = side.shown
        x, z, tilt = (np.interp(time, shown.time, v) for v in (shown.x, shown.z, shown.tilt))
        cos, sin = np.cos(tilt), np.sin(tilt)
        for u, v in side.run.body.corners:
            across = x + u * cos + v * sin + shift
            lows.append(float(across.min()))
            highs.append(float(across.max()))
            tops.append(float((z - u * sin + v * cos).max()))
        held = side.run.held
        assert held is not None
        left, right, ceiling = _faces(held)
        if left is not None:
            lows.append(left + float(shift.min()))
        if right is not None:
            highs.append(right + float(shift.max()))
        if ceiling is not None:
            tops.append(ceiling)
    margin = 0.12 * size
    return min(lows) - margin, max(highs) + margin, -0.1 * size, max(tops) + 0.06 * size
