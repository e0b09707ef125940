"""Motions whose response spectrum meets a target: their Fourier amplitudes are changed, their phases kept.

Where a spectrum is too low at period T, the Fourier amplitudes about the frequency 1/T are raised by the
ratio, and so again till nothing more is to be won (as SIMQKE does; Gasparini and Vanmarcke 1976). The filter
is smooth, so a motion keeps its envelope.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.errors import InputError, excerpt
from stayput.execution import Pool
from stayput.motion.processing import ending_at_rest, fft_length
from stayput.motion.record import COMPONENTS, Motion
from stayput.motion.response import spectrum_of_samples
from stayput.motion.suites.ground_motion import cosine_taper
from stayput.motion.suites.target import band_periods
from stayput.progress import bar

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.motion.suites.target import TargetSpectrum

VERTICAL = ((0.1, 0.8), (0.3, 0.5))
"""Periods [s] and the vertical over the horizontal spectrum, log-log linear (default, low confidence)."""

ITERATIONS = 8
"""How often the filter is corrected; the best iteration counts."""

RELAXATION = 0.8
"""Share of the misfit of ln Sa that one iteration takes off: all of it overshoots where periods interact."""

PADDING = 2.0
"""Still floor before and after a motion, for its filtered waves to fade in [longest periods of the band]."""

BAND_MARGIN = 1.25
"""Factor by which the filter goes on beyond the band, so that the band's ends are met too."""


class _FilteredComponent:
    """A component's transform, whose amplitudes are multiplied."""

    def __init__(self, a: NDArray[np.float64], dt: float, longest: float) -> None:
        self.dt, self.pad = dt, math.ceil(PADDING * longest / dt)
        self.n = len(a) + 2 * self.pad
        self.n_fft = fft_length(
            self.n + self.pad
        )  # zeros at the end keep filtered waves from wrapping around
        f = np.fft.rfftfreq(self.n_fft, dt)
        self.transform = np.fft.rfft(np.pad(a, self.pad), self.n_fft)
        self.log_f = np.log(np.maximum(f, 0.1 * f[1]))  # finite at 0 Hz, below all others

    def changed(self, periods: NDArray[np.float64], log_gain: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the acceleration with the gains exp(log_gain) at 1/periods, brought back to rest.

        At longer periods they fall as 1/T², so that no displacement grows that the target does not ask
        for; at shorter ones they stay.
        """
        log_edges = -np.log(periods[::-1])
        fall = np.minimum(self.log_f - log_edges[0], 0.0)
        gain = np.exp(np.interp(self.log_f, log_edges, log_gain[::-1]) + 2.0 * fall)
        a = np.fft.irfft(self.transform * gain, self.n_fft)[: self.n]
        t = self.dt * np.arange(self.n, dtype=np.float64)
        return ending_at_rest(a * cosine_taper(t, self.dt * self.pad))

    def log_sa(
        self, periods: NDArray[np.float64], log_gain: NDArray[np.float64], damping: float
    ) -> NDArray[np.float64]:
        """Return ln Sa at periods, with the gains exp(log_gain) there, shape (m,)."""
        spectrum = spectrum_of_samples(self.changed(periods, log_gain), self.dt, periods, damping)
        return np.log(np.maximum(spectrum.sa, 1e-12))


def vertical_ratio(periods: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the ratio of the vertical target to the horizontal one at periods [s], shape of them."""
    at, ratio = zip(*VERTICAL, strict=True)
    return np.exp(np.interp(np.log(periods), np.log(at), np.log(ratio)))


def matched(
    motions: Sequence[Motion],
    target: TargetSpectrum,
    band: tuple[float, float],
    *,
    together: bool = False,
    threads: int | None = None,
) -> list[Motion]:
    """Return motions whose Fourier amplitudes are changed till their Sa meet a target over a band.

    x and y each meet the target, the vertical component 0.8 of it at short periods and 0.5 at long ones
    (`VERTICAL`). Motions get longer by twice the band's longest period at either end; velocity and
    displacement end at zero. The motions are synthetic from then on.

    Parameters
    ----------
    motions : sequence of Motion
        The motions.
    target : TargetSpectrum
        What they meet.
    band : (float, float)
        Shortest and longest period that count [s].
    together : bool
        Whether one filter serves all, so that only their geometric mean meets the target and their
        variability stays; by default each motion meets it.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.

    Raises
    ------
    InputError
        A still component, or a band outside the target.
    """
    inside = band_periods(band)
    target(inside)
    low = max(float(target.periods[0]), inside[0] / BAND_MARGIN)
    high = min(float(target.periods[-1]), inside[-1] * BAND_MARGIN)
    periods = band_periods((low, high))
    target.refuse_floors(motions)
    for motion in motions:
        for name, a in motion.components.items():
            if not np.any(a):
                raise InputError("motion.still_component", component=name, motion=excerpt(motion.name))
    which = "one filter for the whole suite" if together else "a filter of its own"
    note = (
        f"Fourier amplitudes changed to {target.name}, {band[0]:g}-{band[1]:g} s, {which}; baseline at rest"
    )
    filtered = [
        {name: _FilteredComponent(a, motion.dt, band[1]) for name, a in motion.components.items()}
        for motion in motions
    ]
    shared = _suite_gains(filtered, target, periods, threads) if together else None

    def match(motion: Motion, parts: dict[str, _FilteredComponent]) -> Motion:
        gains = _suite_gains([parts], target, periods, 1) if shared is None else shared
        changed: dict[str, Any] = {name: part.changed(periods, gains[name]) for name, part in parts.items()}
        source = f"{motion.source}; {note}" if motion.source else note
        return replace(motion, **changed, synthetic=True, source=source)

    results: list[Motion] = []
    with Pool(threads) as pool, bar(len(motions), "progress.matching", unit="progress.motions") as done:
        pairs = zip(motions, filtered, strict=True)
        for motion in pool.in_order(partial(match, *pair) for pair in pairs):
            results.append(motion)
            done(1)
    return results


def _suite_gains(
    filtered: Sequence[dict[str, _FilteredComponent]],
    target: TargetSpectrum,
    periods: NDArray[np.float64],
    threads: int | None,
) -> dict[str, NDArray[np.float64]]:
    """Return the log gains with which the geometric mean of each component that is there meets the target."""
    gains: dict[str, NDArray[np.float64]] = {}
    for name in COMPONENTS:
        parts = [components[name] for components in filtered if name in components]
        if not parts:
            continue
        wanted = np.log(target(periods))
        if name == "z":
            wanted += np.log(vertical_ratio(periods))
        gain = gains[name] = np.zeros(len(periods))
        least = np.inf
        with Pool(threads) as pool:
            for _ in range(ITERATIONS):
                calls = (partial(part.log_sa, periods, gain, target.damping) for part in parts)
                misfit = wanted - sum(pool.in_order(calls)) / len(parts)
                error = float(np.mean(np.abs(misfit)))
                if error < least:
                    gains[name], least = gain, error
                gain = gain + RELAXATION * misfit
    return gains
