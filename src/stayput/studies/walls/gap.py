"""Turnover over width and wall distance under a sine (the paper, §4.4, Figs. 4.5 and 4.6)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from stayput.errors import InputError, within
from stayput.simulation import LAWS
from stayput.studies.study import Study
from stayput.studies.walls.gap_figures import draw_map, draw_rule
from stayput.studies.walls.gap_text import by_width, of_inputs, summary, text_of
from stayput.studies.walls.map import RATIO, WALLS, increasing, table_4_2, turnover
from stayput.studies.walls.rule import rule_tested, sine_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike, NDArray

    from stayput.motion import Motion


def wall_gap(
    amplitude: float = 5.0,
    frequency: float = 0.8,
    *,
    widths: ArrayLike | None = None,
    gaps: ArrayLike | None = None,
    amplitudes: Sequence[float] = (4.0, 5.0, 6.0, 8.0, 10.0),
    frequencies: Sequence[float] = (0.5, 0.8, 1.0, 1.5),
    ratios: Sequence[float] = (0.25, 0.3, RATIO, 0.4, 0.5),
) -> Study:
    """Map turnover over width and wall distance under a sine, and test the paper's 15 % rule.

    The rule: bodies wider than 1 m and nearer to the wall than 15 % of their width do not turn over. The
    map has the coefficients of the paper's Table 4.2, both contact laws, and a wall on the left, on the
    right and on both sides. The paper's input (Fig. 4.2) is not given in its text; ours is a stated one.

    Parameters
    ----------
    amplitude, frequency : float
        The map's sine [m/s², Hz], 30 s.
    widths : array_like, shape [width], optional
        The map's widths b [m]; default 0.4 to 1.6 m by 0.025 m.
    gaps : array_like, shape [gap], optional
        The map's distances l_w from the body to the wall [m]; default 0 to 0.8 m by 0.01 m.
    amplitudes, frequencies, ratios : sequence of float
        Sines [m/s², Hz] and aspect ratios b/h [–] under which the rule is tested, all combinations.

    Returns
    -------
    Study
        ``data`` holds ``overturned`` over law, wall, width and distance, and ``overturned_free`` without a
        wall; and what `stayput.studies.wall_rule.rule_tested` gives, over law, aspect ratio and sine.

    Raises
    ------
    InputError
        A value out of range, or widths or distances that do not increase.
    """
    b = increasing("Width", np.linspace(0.4, 1.6, 49) if widths is None else widths, 0.01, 10.0)
    l_w = increasing("Wall gap", np.linspace(0.0, 0.8, 81) if gaps is None else gaps, 0.0, 100.0)
    sizes = _some("Amplitude", (amplitude, *amplitudes), 0.1, 100.0, "m/s²")
    speeds = _some("Frequency", (frequency, *frequencies), 0.05, 5.0, "Hz")
    shapes = _some("Aspect ratio", (RATIO, *ratios), 0.05, 2.0)
    motion = sine_of(sizes[0], speeds[0])
    tested = rule_tested(sizes[1:], speeds[1:], shapes[1:])
    data = xr.merge([_map(motion, b, l_w), tested], combine_attrs="no_conflicts")
    tables = {"Without a wall, and the nearest wall [m] that turns it over": by_width(data)}
    tables["Inputs (sine and aspect ratio) that break the 15 % rule"] = summary(data)
    for law in LAWS[::-1]:
        caption = f"Nearest wall that turns over a body wider than 1 m [% of its width], law {law!r}"
        tables[caption] = of_inputs(data, law)
    return Study(
        name="wall-gap",
        title="Turnover beside a wall under a sine",
        text=text_of(data),
        data=data,
        figures={"map": draw_map(data), "rule": draw_rule(data)},
        tables=tables,
    )


def _some(what: str, values: Sequence[float], low: float, high: float, unit: str = "") -> list[float]:
    """Return numbers within limits; the first is the map's, and one at least must follow it."""
    if len(values) < 2:
        raise InputError(f"{what} has no values to test the rule with; there must be at least one.")
    return [within(what, value, low, high, unit) for value in values]


def _map(motion: Motion, widths: NDArray[np.float64], gaps: NDArray[np.float64]) -> xr.Dataset:
    found = turnover(table_4_2(motion), widths, gaps, {"contact": LAWS})
    return xr.Dataset(
        {
            "overturned": (
                ("contact", "wall", "body.width", "gap"),
                found.walled,
                {"long_name": "whether it turns over"},
            ),
            "overturned_free": (
                ("contact", "body.width"),
                found.free,
                {"long_name": "whether it turns over without a wall"},
            ),
        },
        {
            "contact": list(LAWS),
            "wall": list(WALLS),
            "body.width": ("body.width", widths, {"units": "m"}),
            "gap": ("gap", gaps, {"units": "m", "long_name": "distance from the body to the wall"}),
        },
        {"motion": motion.name, "map_aspect_ratio": RATIO, "map_given_up": found.given_up},
    )
