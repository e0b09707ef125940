"""Median overturning capacity of bare furniture over four sizes and five spectra.

The formula is that of Kaneko and Hayashi (2004), whose coefficients are common knowledge that was not
re-checked (`stayput.estimates`).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from stayput.errors import InputError, within
from stayput.estimates import kaneko_hayashi_branch, kaneko_hayashi_median
from stayput.progress import bar
from stayput.studies.capacity.figures import draw_medians, draw_shares
from stayput.studies.capacity.runs import OTHERS, SIZES, STATED, Setting, amplitudes, body_of, overturning
from stayput.studies.capacity.spectra import CORNERS, DRAWN, as_drawn, of_spectra
from stayput.studies.capacity.tables import medians_table, variations_table
from stayput.studies.capacity.text import text_of
from stayput.studies.study import Study

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.studies.capacity.runs import Found
    from stayput.studies.capacity.spectra import Shakings


@dataclass(frozen=True, slots=True, eq=False)
class _Row:
    """All sizes in one setting under motions of one kind."""

    setting: str
    shakings: Shakings
    found: list[Found]


def capacity(
    motions: int = 60,
    *,
    corners: Sequence[float] = CORNERS,
    sizes: Sequence[str] = SIZES,
    step: float = 0.04,
    variations: bool = True,
    seed: int = 1,
) -> Study:
    """Compare the peak acceleration that overturns half with Kaneko and Hayashi's formula.

    Bodies are uniform rectangles that do not slip and stand free. Every motion is scaled to every amplitude
    (incremental dynamic analysis); a range in which a body stands above its first overturning is kept as it
    is. The median is that of a lognormal curve, fitted by maximum likelihood to the shares that overturn.

    Parameters
    ----------
    motions : int
        Motions of each kind, at least 2.
    corners : sequence of float
        Corner periods of the spectra that the motions meet [s], 0.16 to 5.
    sizes : sequence of str
        Names of furniture presets.
    step : float
        Relative step of the amplitudes; an island narrower than this can be missed.
    variations : bool
        Whether to run other landings, a wall, and motions as they are drawn, too.
    seed : int
        Seed of the motions.

    Returns
    -------
    Study
        Figures "medians" and "shares". Data over ``run`` (a setting under motions of one kind), ``body``,
        ``motion`` and ``amplitude``.

    Raises
    ------
    InputError
        A value out of range, or a preset that is not known.
    """
    count = int(within("Number of motions", motions, 2, 1000))
    factors = amplitudes(within("Step", step, 0.005, 0.2))
    bodies = {size: body_of(_known(size)) for size in sizes}
    spectra = of_spectra(tuple(corners), count, seed)
    work: list[tuple[Setting, Shakings]] = [(STATED, one) for one in spectra]
    if variations:
        work += [(setting, one) for setting in OTHERS for one in spectra]
        for family in DRAWN:
            for vertical in (False, True):
                name = f"{family} motions as drawn, {'x and vertical' if vertical else 'x alone'}"
                shakings = as_drawn(family, count, seed, vertical=vertical)
                work.append((Setting(name, STATED.room), shakings))
    rows: list[_Row] = []
    with bar(len(work) * len(bodies) * count * len(factors), "Overturning") as tell:
        for setting, shakings in work:
            found: list[Found] = []
            for body in bodies.values():
                found.append(overturning(body, setting.room, shakings, factors))
                tell(count * len(factors))
            rows.append(_Row(setting.name, shakings, found))
    data = _together(rows, tuple(sizes), factors)
    return Study(
        name="capacity",
        title="Overturning capacity of bare furniture beside Kaneko and Hayashi's formula",
        text=text_of(data),
        data=data,
        figures={"medians": draw_medians(data), "shares": draw_shares(data)},
        tables={
            "Median peak acceleration that overturns, A₅₀ [m/s²], by simulation and by the formula": (
                medians_table(data)
            ),
            **(
                {"The ratio to the formula under other conditions": variations_table(data)}
                if variations
                else {}
            ),
        },
    )


def _known(size: str) -> str:
    from stayput.furniture import FURNITURE

    if size not in FURNITURE:
        raise InputError(f"The size is {size!r}; it must be one of {', '.join(FURNITURE)}.")
    return size


def _together(rows: list[_Row], sizes: tuple[str, ...], factors: NDArray[np.float64]) -> xr.Dataset:
    """Return all results in one dataset."""
    bodies = [body_of(size) for size in sizes]
    frequency = np.array([np.median(row.shakings.frequencies) for row in rows])
    formula = np.array(
        [[kaneko_hayashi_median(b.width, b.height, float(fe)) for b in bodies] for fe in frequency]
    )

    def each(name: str) -> NDArray[np.float64]:
        return np.array([[getattr(found, name) for found in row.found] for row in rows])

    interval = each("interval")
    over = ("run", "body")
    of_formula = {"long_name": "simulated median over the formula's, each motion with its own Fe"}
    first = each("first")
    return xr.Dataset(
        {
            "ratio": (over, each("ratio"), of_formula),
            "ratio_low": (over, interval[..., 0], {"long_name": "lower end of its 95 % interval"}),
            "ratio_high": (over, interval[..., 1], {"long_name": "upper end of its 95 % interval"}),
            "first_ratio": (
                over,
                np.median(first, axis=-1),
                {"long_name": "median of the first amplitudes that overturn, over the formula's median"},
            ),
            "dispersion": (
                over,
                np.array([[found.curve.dispersion for found in row.found] for row in rows]),
                {"long_name": "standard deviation of ln A at overturning"},
            ),
            "islands": (over, each("islands"), {"long_name": "share of motions with safe islands"}),
            "given_up": (over, each("given_up").astype(np.int64), {"long_name": "runs that were given up"}),
            "formula": (over, formula, {"units": "m/s2", "long_name": "A50 of the formula at the median Fe"}),
            "share": (
                (*over, "amplitude"),
                each("shares"),
                {"long_name": "share of the motions that overturn"},
            ),
            "first": ((*over, "motion"), first, {"long_name": "first amplitude that overturns, over A50"}),
            "pga": (("run", "motion"), np.array([row.shakings.peaks[0] for row in rows]), {"units": "m/s2"}),
            "pgv": (("run", "motion"), np.array([row.shakings.peaks[1] for row in rows]), {"units": "m/s"}),
        },
        {
            "setting": ("run", [row.setting for row in rows]),
            "motions": ("run", [row.shakings.name for row in rows]),
            "corner": ("run", [row.shakings.corner for row in rows], {"units": "s"}),
            "frequency": ("run", frequency, {"units": "Hz", "long_name": "median of Fe = A/(2 pi V)"}),
            "body": list(sizes),
            "width": ("body", [body.width for body in bodies], {"units": "m"}),
            "height": ("body", [body.height for body in bodies], {"units": "m"}),
            "branch": (
                "body",
                [kaneko_hayashi_branch(body.width, body.height) for body in bodies],
                {"units": "Hz", "long_name": "Fb, from which on the velocity counts"},
            ),
            "amplitude": ("amplitude", factors, {"long_name": "A/A50"}),
        },
        {"motions_of_each_kind": len(rows[0].shakings.motions)},
    )
