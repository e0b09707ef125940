"""Motions whose response spectrum meets a target: their Fourier amplitudes are changed, their phases kept.

Where a spectrum is too low at period T, the Fourier amplitudes about the frequency 1/T are raised by the
ratio, and so again till nothing more is to be won (as SIMQKE does; Gasparini and Vanmarcke 1976). The filter is
smooth, so a motion keeps its envelope.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.fft import next_fast_len

from stayput.errors import InputError
from stayput.motion.suites.envelopes import ends_tapered
from stayput.motion.suites.settling import settled
from stayput.motion.suites.target import band_periods

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.motion.record import Motion
    from stayput.motion.suites.target import TargetSpectrum

ROUNDS = 12
"""How often the filter is corrected; the best round counts."""

CAUTION = 0.8
"""Share of the misfit's logarithm that a round takes off."""

TAPER = 1.0
"""Over which a changed motion fades in and out [s], or a tenth of it where that is shorter."""

WIDER = 1.25
"""The filter goes on beyond the band by this factor, so that the band's ends are met too."""


@dataclass(frozen=True, slots=True)
class _Filtered:
    """A component's transform, whose amplitudes are multiplied."""

    transform: NDArray[np.complex128]
    log_f: NDArray[np.float64]
    dt: float
    n: int
    n_fft: int

    @classmethod
    def of(cls, a: NDArray[np.float64], dt: float) -> _Filtered:
        n_fft = next_fast_len(len(a) + round(20.0 / dt), real=True)
        f = np.fft.rfftfreq(n_fft, dt)
        return cls(np.fft.rfft(a, n_fft), np.log(np.maximum(f, 0.1 * f[1])), dt, len(a), n_fft)

    def changed(self, periods: NDArray[np.float64], log_gain: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the acceleration with the gains exp(log_gain) at 1/periods, brought back to rest."""
        gain = np.exp(np.interp(self.log_f, -np.log(periods[::-1]), log_gain[::-1]))
        a = np.fft.irfft(self.transform * gain, self.n_fft)[: self.n]
        t = self.dt * np.arange(self.n)
        return settled(a * ends_tapered(t, min(TAPER, 0.1 * float(t[-1]))))


def _log_sa(
    a: NDArray[np.float64], dt: float, periods: NDArray[np.float64], damping: float
) -> NDArray[np.float64]:
    from stayput.motion.oscillator import RESPONSES, peak_responses  # Numba takes its time to load

    peaks = np.empty((len(periods), RESPONSES))
    peak_responses(a, dt, periods, damping, peaks)
    return np.log(np.maximum(peaks[:, 2], 1e-12))


def _gains(
    parts: Sequence[_Filtered], target: TargetSpectrum, periods: NDArray[np.float64], threads: int | None
) -> NDArray[np.float64]:
    """Return the log gains with which the geometric mean of some components meets a target, shape (m,)."""
    wanted = np.log(target(periods))
    gain = np.zeros(len(periods))
    best, least = gain, np.inf
    with ThreadPoolExecutor(threads) as pool:
        for _ in range(ROUNDS):
            now = gain
            rows = list(
                pool.map(
                    lambda part: _log_sa(part.changed(periods, now), part.dt, periods, target.damping),  # noqa: B023
                    parts,
                )
            )
            misfit = wanted - np.mean(rows, axis=0)
            error = float(np.mean(np.abs(misfit)))
            if error < least:
                best, least = gain, error
            gain = gain + CAUTION * misfit
    return best


def _with_gains(
    motion: Motion,
    parts: dict[str, _Filtered],
    gains: dict[str, NDArray[np.float64]],
    periods: NDArray[np.float64],
    note: str,
) -> Motion:
    changed: dict[str, Any] = {name: part.changed(periods, gains[name]) for name, part in parts.items()}
    source = f"{motion.source}; {note}" if motion.source else note
    return replace(motion, **changed, synthetic=True, source=source)


def matched(
    motions: Sequence[Motion],
    target: TargetSpectrum,
    band: tuple[float, float],
    *,
    together: bool = False,
    threads: int | None = None,
) -> list[Motion]:
    """Return motions whose Fourier amplitudes are changed till their Sa meet a target over a band.

    x and y each meet the target; the vertical component gets the mean of their filters, and so keeps its
    ratio to them. Velocity and displacement end at zero. The motions are synthetic from then on.

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
    low = max(float(target.periods[0]), inside[0] / WIDER)
    high = min(float(target.periods[-1]), inside[-1] * WIDER)
    periods = band_periods((low, high))
    for motion in motions:
        for name, a in motion.components.items():
            if not np.any(a):
                raise InputError(f"The {name} component of {motion.name!r} is still; it cannot meet a target.")
    said = "one filter for the whole suite" if together else "a filter of its own"
    note = f"Fourier amplitudes changed to {target.name}, {band[0]:g}-{band[1]:g} s, {said}; baseline at rest"
    filtered = [
        {name: _Filtered.of(a, motion.dt) for name, a in motion.components.items()} for motion in motions
    ]
    if together:
        shared = _suite_gains(filtered, target, periods, threads)
        return [
            _with_gains(m, parts, shared, periods, note)
            for m, parts in zip(motions, filtered, strict=True)
        ]

    def one(motion: Motion, parts: dict[str, _Filtered]) -> Motion:
        return _with_gains(motion, parts, _suite_gains([parts], target, periods, 1), periods, note)

    with ThreadPoolExecutor(threads) as pool:
        return list(pool.map(one, motions, filtered))


def _suite_gains(
    filtered: Sequence[dict[str, _Filtered]],
    target: TargetSpectrum,
    periods: NDArray[np.float64],
    threads: int | None,
) -> dict[str, NDArray[np.float64]]:
    """Return the log gains of each component: x's and y's own, and their mean for z."""
    gains = {
        name: _gains(parts, target, periods, threads)
        for name in ("x", "y")
        if (parts := [components[name] for components in filtered if name in components])
    }
    return gains | {"z": np.mean(list(gains.values()), axis=0)}
