"""How far a body slides over its static and kinetic friction (the paper, §4.2).

The paper does not give its input (Fig. 4.2), so the sine is searched whose three slides come nearest.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput.model.body import Body
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.room import Floor, Room
from stayput.motion.synthetic import sine
from stayput.report.palette import ALARM, INK
from stayput.scenario.sweep import sweep
from stayput.simulation.case import Case
from studies.study import Quantity, Study, panels

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

    from stayput.motion.record import Motion

PAPER_BODY = Body(0.5, 1.0, 100.0)
"""The paper's Table 4.1."""

PAPER_ROWS = ((0.4, 0.1), (0.4, 0.3), (0.6, 0.1))
"""Static and kinetic friction of the paper's three runs (§4.2)."""

PAPER_SLIDES = (0.0544, 0.0310, 0.0234)
"""The paper's largest slides in these runs [m] (§4.2)."""

AMPLITUDES, FREQUENCIES = np.round(np.arange(4.0, 15.01, 0.2), 1), np.round(np.arange(0.5, 6.01, 0.1), 1)
"""What is searched [m/s², Hz]: from 0.4 g, where the paper's first body begins to slide."""

PHASES = (0.0, 90.0)
"""Phases of the sines that are searched [°]."""

MODELS = {"held": "only slides", "paper": "free, law of the paper", "coulomb": "free, Coulomb law"}
"""The model that is kept from rocking, and those that may rock, by contact law."""

WIDE = 20.0
"""Width over height of the body that only slides: it would rock beyond 20 g. A slide knows no shape."""

ROUNDS, POINTS = 3, 9
"""Rounds of the finer search about the grid's nearest sine, and its points each way."""


@dataclass(frozen=True, slots=True)
class Nearest:
    """The sine whose three slides come nearest to the paper's.

    Attributes
    ----------
    phase, frequency, amplitude : float
        [°, Hz, m/s²].
    slides : ndarray, shape (3,)
        Peak slides of `PAPER_ROWS` [m].
    deviation : float
        Largest relative deviation of these from the paper's.
    """

    phase: float
    frequency: float
    amplitude: float
    slides: NDArray[np.float64]
    deviation: float

    def __str__(self) -> str:
        """Return amplitude, frequency and phase."""
        return f"{self.amplitude:.2f} m/s², {self.frequency:.2f} Hz, phase {self.phase:.0f}°"


def model(name: str, motion: Motion) -> Case:
    """Return the case of one of `MODELS`, with the first row's friction."""
    width = WIDE if name == "held" else PAPER_BODY.width
    body = Body(width, PAPER_BODY.height, PAPER_BODY.mass)
    return Case(body, Room(Floor(*PAPER_ROWS[0])), motion, "paper" if name == "paper" else "coulomb")


def unit_sine(frequency: float, duration: float, phase: float) -> Motion:
    """Return a sine of 1 m/s², so that ``motion.scale`` is its amplitude; the phase in degrees."""
    return sine(1.0, frequency, duration, np.radians(phase), dt=min(0.005, 0.02 / frequency))


def slides_under(
    case: Case, phases: Sequence[float], frequencies: NDArray[np.float64], amplitudes: NDArray[np.float64]
) -> xr.Dataset:
    """Return the outcomes of the paper's three rows, over row, phase, frequency and amplitude.

    Returns
    -------
    xarray.Dataset
        ``peak_slide`` [m], NaN where the body turns over, ``rocks`` and ``overturned``.
    """
    motions = [unit_sine(f, case.motion.duration, phase) for phase in phases for f in frequencies]
    friction = ("room.floor.static_friction", "room.floor.kinetic_friction")
    rows = {friction: tuple(zip(*PAPER_ROWS, strict=True))}
    result = sweep(case, {**rows, "motion": motions, "motion.scale": amplitudes}, progress=False)
    axes = {"phase": list(phases), "frequency": frequencies, "amplitude": amplitudes}
    shape = len(PAPER_ROWS), *map(len, axes.values())
    values = {
        "peak_slide": np.where(result.overturned, np.nan, result.peak_slide),
        "rocks": result.peak_tilt.to_numpy() > 0.0,
        "overturned": result.overturned.to_numpy(),
    }
    return xr.Dataset({name: (("row", *axes), array.reshape(shape)) for name, array in values.items()}, axes)


def deviation(slides: xr.Dataset) -> xr.DataArray:
    """Return the largest relative deviation of the three slides from the paper's; NaN where it turns over."""
    paper = xr.DataArray(list(PAPER_SLIDES), dims="row")
    return abs(slides.peak_slide / paper - 1.0).max("row", skipna=False)


def effects(slides: xr.Dataset) -> tuple[xr.DataArray, xr.DataArray]:
    """Return how much less the body slides for 0.2 more static, and for 0.2 more kinetic friction [m]."""
    base, more_kinetic, more_static = (slides.peak_slide.isel(row=row) for row in range(3))
    return base - more_static, base - more_kinetic


def nearest_sine(case: Case, grid: xr.Dataset) -> Nearest:
    """Return the sine of the grid that comes nearest to the paper, refined between the grid's lines."""
    best = grid.isel(deviation(grid).argmin(...))  # type: ignore[arg-type]
    steps = {name: float(np.diff(grid[name]).mean()) for name in ("frequency", "amplitude")}
    for _ in range(ROUNDS):
        f, A = (
            np.linspace(float(best[name]) - step, float(best[name]) + step, POINTS)
            for name, step in steps.items()
        )
        finer = slides_under(case, (float(best.phase),), f, A)
        best = finer.isel(deviation(finer).argmin(...))  # type: ignore[arg-type]
        steps = {name: 2.0 * step / (POINTS - 1) for name, step in steps.items()}
    phase, frequency, amplitude = (float(best[name]) for name in ("phase", "frequency", "amplitude"))
    return Nearest(phase, frequency, amplitude, best.peak_slide.to_numpy(), float(deviation(best)))


def friction(
    *, amplitudes: ArrayLike = AMPLITUDES, frequencies: ArrayLike = FREQUENCIES, duration: float = 10.0
) -> Study:
    """Study the slide over static and kinetic friction, as the paper's §4.2.

    Parameters
    ----------
    amplitudes, frequencies : array_like
        The sines that are searched [m/s², Hz]; at least two of each, rising.
    duration : float
        Length of the shaking [s].

    Returns
    -------
    Study
        Data over ``model``, ``row`` (the paper's pairs of coefficients), ``phase``, ``frequency`` and
        ``amplitude``.
    """
    A, f = np.asarray(amplitudes, np.float64), np.asarray(frequencies, np.float64)
    cases = {name: model(name, unit_sine(f[0], duration, 0.0)) for name in MODELS}
    parts = {name: slides_under(case, PHASES, f, A) for name, case in cases.items()}
    nearest = {name: nearest_sine(case, parts[name]) for name, case in cases.items()}
    data = xr.concat(list(parts.values()), xr.Variable("model", list(MODELS)))
    static, kinetic = zip(*PAPER_ROWS, strict=True)
    data = data.assign_coords(static_friction=("row", list(static)), kinetic_friction=("row", list(kinetic)))
    for name, unit in {"phase": "degree", "frequency": "Hz", "amplitude": "m/s2", "peak_slide": "m"}.items():
        data[name].attrs["units"] = unit
    return Study(
        name="friction",
        title="Sliding and the coefficients of friction",
        quantities=_quantities(data, nearest),
        data=data,
        figure=_drawn(data, nearest),
        tables={"The nearest sine for each model, with its three slides [cm]": nearest_table(nearest)},
    )


def _quantities(data: xr.Dataset, nearest: dict[str, Nearest]) -> dict[str, Quantity]:
    quantities: dict[str, Quantity] = {}
    paper = [100.0 * slide for slide in PAPER_SLIDES]
    for key, near in nearest.items():
        name = MODELS[key]
        slides: list[float] = (100.0 * near.slides).tolist()
        quantities[f"sine_{key}"] = Quantity(f"Nearest sine, {name}", str(near))
        off = 100.0 * near.deviation
        quantities[f"deviation_{key}"] = Quantity(f"Its largest deviation, {name} [%]", off, form=".0f")
        for row, pair in enumerate(PAPER_ROWS):
            label = f"Peak slide at (μ, μ') = {pair}, {name} [cm]"
            quantities[f"slide_{row + 1}_{key}"] = Quantity(label, slides[row], paper[row], ".2f")
        for effect, kind, row in (("μ", "static", 2), ("μ'", "kinetic", 1)):
            label = f"0.2 more {effect} shortens it by, {name} [cm]"
            ours, published = slides[0] - slides[row], paper[0] - paper[row]
            quantities[f"by_{kind}_{key}"] = Quantity(label, ours, published, ".2f")
        static, kinetic = effects(data.sel(model=key))
        known = static.notnull() & kinetic.notnull() & (data.peak_slide.sel(model=key, row=0) > 0.0)
        share = 100.0 * float((kinetic > static).sum()) / max(1, int(known.sum()))
        label = f"Sines under which μ' matters more, {name} [%]"
        quantities[f"share_{key}"] = Quantity(label, share, form=".0f")
        lowest = float(data.amplitude.where(kinetic > static).min("amplitude").median()) / STANDARD_GRAVITY
        label = f"Lowest amplitude at which it does, median, {name} [g]"
        quantities[f"flip_{key}"] = Quantity(label, lowest, form=".2f")
    return quantities


def nearest_table(nearest: dict[str, Nearest]) -> pd.DataFrame:
    """Return a row for each model, and one for the paper."""
    pairs = [f"({static:g}, {kinetic:g})" for static, kinetic in PAPER_ROWS]
    rows: list[dict[str, object]] = [
        {
            "model": MODELS[key],
            "A [m/s²]": near.amplitude,
            "f [Hz]": near.frequency,
            "phase [°]": near.phase,
            **dict(zip(pairs, 100.0 * near.slides, strict=True)),
            "largest deviation [%]": 100.0 * near.deviation,
        }
        for key, near in nearest.items()
    ]
    paper = dict(zip(pairs, 100.0 * np.array(PAPER_SLIDES), strict=True))
    return pd.DataFrame([*rows, {"model": "the paper", **paper}])


def _drawn(data: xr.Dataset, nearest: dict[str, Nearest]) -> Figure:
    """Draw which coefficient matters more over amplitude and frequency, a panel for each model."""
    figure, axes = panels(len(MODELS), sharex=True, sharey=True)
    for axis, (key, near) in zip(axes, nearest.items(), strict=True):
        of_model = data.sel(model=key, phase=near.phase)
        static, kinetic = effects(of_model)
        base = of_model.peak_slide.isel(row=0)
        more = ((static - kinetic) / base.where(base > 0.0)).transpose("amplitude", "frequency")
        levels = np.linspace(-1.0, 1.0, 11)
        drawn = axis.contourf(data.frequency, data.amplitude, more, levels, cmap="PuOr_r", extend="both")
        axis.plot(near.frequency, near.amplitude, "*", color=ALARM, markeredgecolor="white", markersize=16.0)
        axis.set_facecolor("#ededed")
        axis.axhline(PAPER_ROWS[2][0] * STANDARD_GRAVITY, color=INK, linestyle="--", linewidth=1.2)
        axis.set(title=f"{MODELS[key]}, phase {near.phase:.0f}°", xlabel="frequency [Hz]")
        if key == "coulomb":
            figure.colorbar(drawn, ax=axes, label="effect of μ less that of μ', over the first slide")
    axes[0].set_ylabel("amplitude [m/s²]")
    figure.suptitle("Which 0.2 more shortens the slide more; star: nearest sine; line: 0.6 g")
    return figure
