"""The paper's 15 % rule (§4.4), and how far it holds under other sines and aspect ratios."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from stayput.motion import sine
from stayput.simulation import LAWS
from stayput.studies.walls.map import DURATION, WALLS, table_4_2, turnover

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.ensemble.axes import Axes
    from stayput.motion import Motion

WIDE = 1.0
"""The rule is for bodies wider than this [m]."""

NEAR = 0.15
"""The rule is for walls nearer than this share of the width [–]."""

TURNS_OVER = (0.8, 1.0)
"""Widths of which the paper says that they turn over even at a small distance [m]."""

WIDTHS = np.linspace(1.05, 1.95, 10)
"""Widths that test the rule [m]."""

SHARES = np.linspace(0.0, 0.30, 16)
"""Distances that test the rule, over the width [–]; beyond 15 % they say where turnover begins."""

STEP = 0.01
"""Time step of the sines, where that is fine enough [s]."""


def sine_of(amplitude: float, frequency: float) -> Motion:
    """Return a sine of Table 4.2's duration [m/s², Hz]."""
    return sine(amplitude, frequency, DURATION, dt=min(STEP, 0.02 / frequency))


def ruled(widths: NDArray[np.float64], gaps: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return which widths and distances the rule is for, shape [width, gap]."""
    b, l_w = np.broadcast_arrays(widths[:, None], gaps)
    return (b > WIDE + 1e-9) & (l_w < NEAR * b - 1e-9)


def rule_tested(
    amplitudes: Sequence[float], frequencies: Sequence[float], ratios: Sequence[float]
) -> xr.Dataset:
    """Test the rule under sines, for aspect ratios and both laws, with a wall on the left or the right.

    Returns
    -------
    xarray.Dataset
        Over contact law, aspect ratio, frequency and amplitude: ``nearest_wall``, over the width, that turns
        over a body of `WIDTHS`, nan where none of `SHARES` does; ``broken_share``, the share of the rule's
        widths, distances and sides at which the body turns over; ``free_share``, the share of the widths
        that turn over without a wall; ``free_tilt``, the largest tilt of any of them without a wall [rad].
    """
    gaps = WIDTHS[:, None] * SHARES
    near = ruled(WIDTHS, gaps)
    nearest: list[NDArray[np.float64]] = []
    broken: list[NDArray[np.float64]] = []
    alone: list[NDArray[np.float64]] = []
    tilts: list[NDArray[np.float64]] = []
    given_up = 0
    for ratio in ratios:
        case = table_4_2(sine_of(1.0, frequencies[0]), ratio)
        sines = [sine_of(1.0, frequency) for frequency in frequencies]
        others: Axes = {"contact": LAWS, "motion": sines, "motion.scale": amplitudes}
        found = turnover(case, WIDTHS, gaps, others, WALLS[:2])
        somewhere = found.walled.any((-3, -2))
        nearest.append(np.where(somewhere.any(-1), SHARES[somewhere.argmax(-1)], np.nan))
        broken.append(found.walled[..., near].mean((-2, -1)))
        alone.append(found.free.mean(-1))
        tilts.append(found.free_tilt.max(-1))
        given_up += found.given_up
    dims = ("contact", "aspect_ratio", "frequency", "amplitude")
    columns = {
        "nearest_wall": (nearest, "nearest wall that turns a body wider than 1 m over, over its width"),
        "broken_share": (broken, "share of the rule's widths, distances and sides that turn over"),
        "free_share": (alone, "share of the widths above 1 m that turn over without a wall"),
        "free_tilt": (tilts, "largest tilt of the widths above 1 m without a wall [rad]"),
    }
    return xr.Dataset(
        {
            name: (dims, np.stack(values, axis=1), {"long_name": meaning})
            for name, (values, meaning) in columns.items()
        },
        {
            "contact": list(LAWS),
            "aspect_ratio": list(ratios),
            "frequency": ("frequency", list(frequencies), {"units": "Hz"}),
            "amplitude": ("amplitude", list(amplitudes), {"units": "m/s2"}),
        },
        {"rule_given_up": given_up},
    )
