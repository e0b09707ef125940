"""All measures of how strongly a motion shakes, in one record."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.motion.intensity import (
    intensity_class,
    jma_from_pgv,
    kawasumi,
    long_period_class,
    long_period_response,
    mercalli,
    published_intensity,
)
from stayput.motion.response import PERIODS
from stayput.motion.spectrum import mean_period

if TYPE_CHECKING:
    from stayput.motion.record import Motion

HOUSNER_PERIODS = np.linspace(0.1, 2.5, 121)
"""Periods over which a spectrum intensity is taken [s]; steps of 0.02 s."""


DRIFTING = 0.8
"""A displacement drifts where its peak is below this share once a line is taken off the acceleration."""


@dataclass(frozen=True, slots=True)
class DisplacementPeak:
    """Peak displacement of one component, and how far it is one of the record's baseline.

    Parameters
    ----------
    pgd : float
        Largest magnitude of the displacement of the record as it is [m].
    corrected : float
        The same of the record less a line, as `Motion.baseline_corrected` takes it off [m].
    """

    pgd: float
    corrected: float

    @property
    def drifts(self) -> bool:
        """Whether the peak is mostly one of the baseline: of an offset, a tilt, a start that is cut off."""
        return self.corrected < DRIFTING * self.pgd

    @classmethod
    def of(cls, motion: Motion, component: str = "x") -> DisplacementPeak:
        """Return the peak of one component of a motion."""
        alone = motion.component(component)
        return cls(alone.pgd, alone.baseline_corrected().pgd)


@dataclass(frozen=True, slots=True)
class SpectralMeasures:
    """Measures of one component from the response of oscillators.

    Parameters
    ----------
    housner_intensity : float
        ∫ PSv dT from 0.1 to 2.5 s at 5 % [m] (Housner 1952).
    spectrum_intensity : float
        SI: the mean of Sv from 0.1 to 2.5 s at 20 % [m/s], as gas meters in Japan use it.
    predominant_period : float
        Period of the largest Sa at 5 % [s]; NaN of a still floor.
    mean_period : float
        Tm of the Fourier spectrum, 0.25 to 20 Hz [s] (Rathje and others 1998); NaN of a still floor.
    """

    housner_intensity: float
    spectrum_intensity: float
    predominant_period: float
    mean_period: float

    @classmethod
    def of(cls, motion: Motion, component: str = "x") -> SpectralMeasures:
        """Return the measures of one component of a motion."""
        a = motion.components[component]
        spectrum = motion.spectrum(PERIODS, 0.05, component)
        housner = motion.spectrum(HOUSNER_PERIODS, 0.05, component).psv
        damped = motion.spectrum(HOUSNER_PERIODS, 0.20, component).sv
        span = float(HOUSNER_PERIODS[-1] - HOUSNER_PERIODS[0])
        moves = bool(np.any(a))
        return cls(
            housner_intensity=float(np.trapezoid(housner, HOUSNER_PERIODS)),
            spectrum_intensity=float(np.trapezoid(damped, HOUSNER_PERIODS)) / span,
            predominant_period=float(spectrum.periods[int(np.argmax(spectrum.sa))]) if moves else math.nan,
            mean_period=mean_period(a, motion.dt),
        )


@dataclass(frozen=True, slots=True)
class Intensities:
    """Intensities of a whole motion on several scales.

    Parameters
    ----------
    intensity : float
        JMA's instrumental intensity, not rounded; −inf of a still floor.
    published : float
        The same as JMA publishes it, with one decimal.
    intensity_class : str
        "0" to "7", with "5-lower" to "6-upper".
    long_period_response : float
        Largest Sva at 5 % over 1.6 to 7.8 s [m/s].
    long_period_class : int
        JMA's class of long-period motion, 0 to 4.
    from_pgv : float
        JMA's intensity as a regression on PGV has it (Midorikawa and others 1999). This and the next two are
        of the ground: NaN of a motion of an upper floor.
    kawasumi : float
        Intensity as Kawasumi (1951) has it from PGA.
    mercalli : float
        Modified Mercalli intensity from PGA and PGV (Worden and others 2012).
    """

    intensity: float
    published: float
    intensity_class: str
    long_period_response: float
    long_period_class: int
    from_pgv: float
    kawasumi: float
    mercalli: float

    @classmethod
    def of(cls, motion: Motion) -> Intensities:
        """Return the intensities of a motion, of as many components as it has."""
        intensity, response = motion.intensity, long_period_response(motion.x, motion.y, motion.dt)
        horizontal = [peaks for name, peaks in motion.peaks().items() if name != "z"]
        pga, pgv = max(peaks.pga for peaks in horizontal), max(peaks.pgv for peaks in horizontal)
        moves = pga > 0.0
        stills = (-math.inf, -math.inf, 1.0)
        converted = (jma_from_pgv(pgv), kawasumi(pga), mercalli(pga, pgv)) if moves else stills
        from_pgv, from_pga, modified = (math.nan,) * 3 if motion.floor else converted
        return cls(
            intensity=intensity,
            published=published_intensity(intensity),
            intensity_class=intensity_class(intensity),
            long_period_response=response,
            long_period_class=long_period_class(response),
            from_pgv=from_pgv,
            kawasumi=from_pga,
            mercalli=modified,
        )
