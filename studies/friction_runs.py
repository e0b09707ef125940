"""Runs of the friction study: sines by amplitude, frequency and phase, and the one nearest the paper."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from stayput.model.body import Body
from stayput.model.room import Floor, Room
from stayput.motion import sine
from stayput.simulation.case import Case
from stayput.simulation.sweep import sweep

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from numpy.typing import NDArray

    from stayput.motion import Motion
    from stayput.simulation.run import Contact

PAPER_BODY = Body(0.5, 1.0, 100.0)
"""The paper's Table 4.1."""

PAPER_ROWS = ((0.4, 0.1), (0.4, 0.3), (0.6, 0.1))
"""Static and kinetic friction of the paper's three runs (§4.2)."""

PAPER_SLIDES = (0.0544, 0.0310, 0.0234)
"""The paper's largest slides in these runs [m] (§4.2)."""

PHASES = (0.0, 90.0)
"""Phases of the sines that are searched [°]."""

HELD = "only slides"
"""The model that is kept from rocking."""

FREE: dict[Contact, str] = {"paper": "free, law of the paper", "coulomb": "free, Coulomb law"}
"""The models that may rock, by contact law."""

WIDE = 20.0
"""Width over height of the body that only slides: it would rock beyond 20 g. A slide knows no shape."""

ROUNDS, POINTS = 3, 9
"""Rounds of the finer search about the grid's nearest sine, and its points each way."""

STATIC, KINETIC = "room.floor.static_friction", "room.floor.kinetic_friction"


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
    rocks : bool
        Whether the body rocks in one of the three runs.
    """

    phase: float
    frequency: float
    amplitude: float
    slides: NDArray[np.float64]
    deviation: float
    rocks: bool

    def __str__(self) -> str:
        """Return amplitude, frequency and phase."""
        return f"{self.amplitude:.2f} m/s², {self.frequency:.2f} Hz, phase {self.phase:.0f}°"


def models(motion: Motion) -> dict[str, Case]:
    """Return the body that only slides, and the paper's body free to rock under both laws, by name."""
    held = Body(WIDE * PAPER_BODY.height, PAPER_BODY.height, PAPER_BODY.mass)
    room = Room(Floor(*PAPER_ROWS[0]))
    free = {FREE[law]: Case(PAPER_BODY, room, motion, contact=law) for law in FREE}
    return {HELD: Case(held, room, motion), **free}


def unit_sine(frequency: float, duration: float, phase: float) -> Motion:
    """Return a sine of 1 m/s², so that ``motion.scale`` is its amplitude; the phase in degrees."""
    return sine(1.0, frequency, duration, np.radians(phase), dt=min(0.005, 0.02 / frequency))


def slides_under(
    case: Case, phases: Sequence[float], frequencies: NDArray[np.float64], amplitudes: NDArray[np.float64]
) -> xr.Dataset:
    """Return the outcomes of the paper's three rows, over phase, frequency and amplitude.

    Parameters
    ----------
    case : Case
        The body and the contact law; its motion gives the duration.
    phases, frequencies, amplitudes : array_like
        [°, Hz, m/s²].

    Returns
    -------
    xarray.Dataset, dimensions (row, phase, frequency, amplitude)
        ``peak_slide`` [m], NaN where the body turns over, ``rocks`` and ``overturned``.
    """
    duration = case.motion.duration
    motions = [unit_sine(f, duration, phase) for phase in phases for f in frequencies]
    static, kinetic = zip(*PAPER_ROWS, strict=True)
    result = sweep(
        case,
        {(STATIC, KINETIC): (static, kinetic), "motion": motions, "motion.scale": amplitudes},
        progress=False,
    )
    shape = len(PAPER_ROWS), len(phases), len(frequencies), len(amplitudes)
    coords = {"static_friction": ("row", list(static)), "kinetic_friction": ("row", list(kinetic))}
    axes = {"phase": list(phases), "frequency": frequencies, "amplitude": amplitudes}
    return _outcomes(result, ("row", *axes), coords | axes, lambda values: values.reshape(shape))


def slide_map(case: Case, amplitude: float, coefficients: NDArray[np.float64]) -> xr.Dataset:
    """Return slides and rocking over static and kinetic friction, NaN where kinetic is above static.

    Returns
    -------
    xarray.Dataset, dimensions (static_friction, kinetic_friction)
        ``peak_slide`` [m], NaN where the body turns over, ``rocks`` and ``overturned``, 0 or 1.
    """
    s, k = np.meshgrid(coefficients, coefficients, indexing="ij")
    possible = k <= s
    scaled = replace(case, motion=case.motion.scaled(amplitude))
    result = sweep(scaled, {(STATIC, KINETIC): (s[possible], k[possible])}, progress=False)

    def square(values: NDArray[np.generic]) -> NDArray[np.float64]:
        full = np.full(possible.shape, np.nan)
        full[possible] = values
        return full

    axes = {"static_friction": coefficients, "kinetic_friction": coefficients}
    return _outcomes(result, tuple(axes), axes, square)


def _outcomes(
    result: xr.Dataset,
    dims: tuple[str, ...],
    coords: Mapping[str, object],
    shaped: Callable[[NDArray[np.generic]], NDArray[np.generic]],
) -> xr.Dataset:
    values = {
        "peak_slide": np.where(result.overturned, np.nan, result.peak_slide),
        "rocks": result.peak_tilt.to_numpy().ravel() > 0.0,
        "overturned": result.overturned.to_numpy().ravel(),
    }
    return xr.Dataset({name: (dims, shaped(array)) for name, array in values.items()}, coords)


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
    steps = [float(np.diff(grid[name]).mean()) for name in ("frequency", "amplitude")]
    for _ in range(ROUNDS):
        f, A = (
            np.linspace(float(best[name]) - step, float(best[name]) + step, POINTS)
            for name, step in zip(("frequency", "amplitude"), steps, strict=True)
        )
        finer = slides_under(case, (float(best.phase),), f, A)
        best = finer.isel(deviation(finer).argmin(...))  # type: ignore[arg-type]
        steps = [2.0 * step / (POINTS - 1) for step in steps]
    phase, frequency, amplitude = (float(best[name]) for name in ("phase", "frequency", "amplitude"))
    slides, rocks = best.peak_slide.to_numpy(), bool(best.rocks.any())
    return Nearest(phase, frequency, amplitude, slides, float(deviation(best)), rocks)
