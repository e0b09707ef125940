"""The HTML player: one file with the run's histories in it, drawn by the browser as fast as its screen."""

from __future__ import annotations

import html
import json
import math
from importlib import resources
from typing import TYPE_CHECKING, Any

from stayput.report.palette import MODE_COLOURS, ROLE_COLOURS

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from stayput.report.film import Film
    from stayput.report.props import Prop

_LENGTH_DIGITS = 5  # 0.01 mm
_ANGLE_DIGITS = 6
_TILT_SHOWN = 3.0  # the tilt's strip ends here, in critical angles, so that the rocking before a fall is seen


def player_page(film: Film, speed: float, hold: float) -> str:
    """Return the page's text.

    Parameters
    ----------
    film : Film
        What is shown.
    speed : float
        Seconds of the run in one second, to start with.
    hold : float
        How long the last pose is held before the film starts again [s].
    """
    # "</" would end the script element in which the numbers stand
    data = json.dumps(_data(film, speed, hold), allow_nan=False, separators=(",", ":")).replace("</", "<\\/")
    page = resources.files("stayput.report").joinpath("player.html").read_text(encoding="utf-8")
    return page.replace("{{title}}", html.escape(film.title)).replace("{{data}}", data)


def _data(film: Film, speed: float, hold: float) -> dict[str, Any]:
    run, motion = film.history, film.motion
    shown = (motion.time >= run.time[0]) & (motion.time <= run.end)
    return {
        "title": film.title,
        "motion": film.motion_title,
        "caption": film.caption,
        "speed": speed,
        "hold_s": hold,
        "corners_m": [film.body.corners[i] for i in (0, 1, 3, 2)],
        "view_m": film.view,
        "grid_m": film.grid,
        "left_wall_m": film.left_wall,
        "right_wall_m": film.right_wall,
        "ceiling_m": film.ceiling,
        "time_s": _rounded(run.time, _ANGLE_DIGITS),
        "x_m": _rounded(run.x, _LENGTH_DIGITS),
        "z_m": _rounded(run.z, _LENGTH_DIGITS),
        "tilt_rad": _rounded(run.tilt, _ANGLE_DIGITS),
        "tilt_shown_rad": _TILT_SHOWN * max(film.body.slenderness),
        "slide_m": _rounded(run.slide, _LENGTH_DIGITS),
        "shift_m": _rounded(film.shift, _LENGTH_DIGITS),
        "acceleration_time_s": _rounded(motion.time[shown], _ANGLE_DIGITS),
        "acceleration_m_s2": _rounded(motion.x[shown], 3),
        "modes": [[round(start, 4), mode.value] for start, _, mode in run.spans()],
        "devices": [_prop(prop) for prop in film.props],
        "colours": {mode.value: colour for mode, colour in MODE_COLOURS.items()},
    }


def _prop(prop: Prop) -> dict[str, Any]:
    """Return a device's shape: points are 1 for those that go with the body, right and up."""
    shown = [
        [int(on_body), round(x, _LENGTH_DIGITS), round(z, _LENGTH_DIGITS)] for on_body, x, z in prop.points
    ]
    times = {"start_s": prop.start, "end_s": prop.end}
    ends = {name: round(time, 4) if math.isfinite(time) else None for name, time in times.items()}
    return {"filled": prop.filled, "points_m": shown, "colour": ROLE_COLOURS[prop.role], **ends}


def _rounded(values: NDArray[np.float64], digits: int) -> list[float]:
    return [float(value) for value in values.round(digits)]
