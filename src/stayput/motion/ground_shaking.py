"""How strongly the ground shakes, from what people know: an intensity, a peak, or an earthquake's distance.

Motions are scaled to an intensity. They are scaled to a peak acceleration or velocity or a spectral
acceleration too, each to that value itself: to make an intensity of it first, by a regression, would add
the regression's error. A modified Mercalli intensity and an earthquake become a peak velocity by published
models, with their scatter:

- Worden, Gerstenberger, Rhoades and Wald (2012), Bulletin of the Seismological Society of America 102,
  204-221: peak velocity at a modified Mercalli intensity, for California.
- Si and Midorikawa (1999), Journal of Structural and Construction Engineering (AIJ) 523, 63-70: peak velocity
  on ground with a shear-wave velocity of 600 m/s, by moment magnitude, shortest distance to the fault, depth
  and kind of earthquake, for Japan.
- Fujimoto and Midorikawa (2006), Journal of Japan Association for Earthquake Engineering 6 (1), 11-22: how
  much larger it is at the surface, by the mean shear-wave velocity of the uppermost 30 m.

The scatter is between places and earthquakes that are the same to the model. None of this is a seismic
hazard: it says how strong one earthquake is, and not how likely.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from statistics import NormalDist
from typing import TYPE_CHECKING, Literal

import numpy as np

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, excerpt
from stayput.model.parameters import arguments, check_fields, choice, parameter, quantity
from stayput.motion.floors import of_the_ground
from stayput.motion.intensity import factor_to_intensity, mercalli, pgv_of_mercalli
from stayput.motion.processing import LARGEST_ACCELERATION
from stayput.motion.response import DAMPING
from stayput.uncertainty import random_bits

if TYPE_CHECKING:
    from stayput.motion.record import Motion

StrengthMeasure = Literal["JMA", "PGA", "PGV", "SA"]
"""What a strength is of: JMA's intensity, the peak of the larger horizontal component, or the geometric mean
of the spectral accelerations of both."""

EARTHQUAKE_TERMS = {"crustal": 0.0, "interface": -0.02, "intraslab": 0.12}
"""Kinds of earthquake, and what each adds to log₁₀ PGV (Si and Midorikawa 1999)."""

EARTHQUAKE_SCATTER = 0.23
"""Standard deviation of log₁₀ PGV (Si and Midorikawa 1999)."""

MERCALLI_SCATTER = 0.38
"""Standard deviation of log₁₀ PGV at a modified Mercalli intensity (Worden et al. 2012)."""

_STREAM = 200_000
"""Key of the draws of strengths; other draws have the motion's number there, which is 100 000 at most."""


@dataclass(frozen=True, slots=True)
class EarthquakeSource:
    """An earthquake and the ground where it is felt, as the ground-motion model takes them.

    Outside the ranges of magnitude, distance and depth the model has no records behind it.

    Parameters
    ----------
    magnitude : float
        Moment magnitude.
    distance : float
        Shortest distance to the fault [km].
    depth : float
        Depth of the middle of the fault [km].
    kind : str
        Where it breaks: in the crust, between two plates or within a plate that dives.
    vs30 : float
        Mean shear-wave velocity of the uppermost 30 m of the ground [m/s]: about 600 on rock, 180 on soft
        soil.
    """

    magnitude: float = field(metadata=quantity("", 5.8, 8.3, ("Magnitude", "マグニチュード")))
    distance: float = field(metadata=quantity("km", 3.0, 300.0, ("Distance", "断層からの距離")))
    depth: float = parameter(10.0, "km", 0.0, 120.0, ("Depth", "震源の深さ"))
    kind: str = choice("crustal", EARTHQUAKE_TERMS, ("Kind of earthquake", "地震の種類"))
    vs30: float = parameter(300.0, "m/s", 100.0, 1500.0, ("Ground", "地盤の平均S波速度"))

    def __post_init__(self) -> None:
        check_fields(self)

    @property
    def pgv(self) -> float:
        """Median peak velocity at the surface, of the larger horizontal component [m/s]."""
        m, x = self.magnitude, self.distance
        on_rock = (
            0.58 * m
            + 0.0038 * self.depth
            + EARTHQUAKE_TERMS[self.kind]
            - 1.29
            - math.log10(x + 0.0028 * 10.0 ** (0.5 * m))
            - 0.002 * x
        )
        amplified = 2.367 - 0.852 * math.log10(self.vs30)
        return 0.01 * 10.0 ** (on_rock + amplified)


@dataclass(frozen=True, slots=True)
class GroundStrength:
    """What the motions of the ground are scaled to.

    Parameters
    ----------
    measure : str
        What the level is of.
    level : float
        The median: JMA's intensity, or the common logarithm of a peak or spectral acceleration [m/s², m/s].
    scatter : float
        Standard deviation of the level.
    about : Phrase
        What was stated, without a full stop.
    brief : Phrase
        The same within a sentence: its value alone.
    source : Phrase
        The model by which it is a strength, where it has scatter.
    period : float
        Period of a spectral acceleration [s].
    """

    measure: StrengthMeasure
    level: float
    scatter: float = 0.0
    about: Phrase = ("", "")
    brief: Phrase = ("", "")
    source: Phrase = ("", "")
    period: float = 0.0

    @property
    def median(self) -> float:
        """JMA's intensity, or the peak or spectral acceleration [m/s², m/s]."""
        return self.level if self.measure == "JMA" else 10.0**self.level

    def drawn(self, motions: int, seed: int) -> list[GroundStrength]:
        """Return the strength of each of several motions, without scatter.

        The scatter is cut into as many equally likely parts as there are motions; each motion has the middle
        of one of them, widened so that their standard deviation is the stated one. The seed says which motion
        has which part. One motion alone has the median.

        Parameters
        ----------
        motions : int
            How many motions.
        seed : int
            Seed; the same seed gives the same bits.
        """
        if self.scatter == 0.0 or motions == 1:
            return [replace(self, scatter=0.0)] * motions
        normal = NormalDist()
        steps = [normal.inv_cdf((i + 0.5) / motions) for i in range(motions)]
        spread = math.sqrt(sum(step * step for step in steps) / motions)
        order = np.argsort(random_bits(seed, _STREAM).random_raw(motions), kind="stable")
        return [
            replace(self, level=self.level + self.scatter * steps[place] / spread, scatter=0.0)
            for place in order.tolist()
        ]

    def told(self, motions: int) -> Phrase:
        """Return what was stated, and how so many motions have their strengths by it; without a full stop."""
        if self.scatter == 0.0:
            return self.about
        how = phrase(f"ground_shaking.{'median_alone' if motions == 1 else 'each_drawn'}")
        pgv, spread = 100.0 * self.median, 10.0**self.scatter
        return phrase(
            "ground_shaking.scattered", about=self.about, source=self.source, pgv=pgv, spread=spread, how=how
        )

    def factor(self, motion: Motion) -> float:
        """Return the factor on a motion that gives it the median strength.

        Raises
        ------
        InputError
            A still motion, or one of an upper floor.
        """
        if self.measure == "JMA":
            return factor_to_intensity(of_the_ground(motion, "strength").intensity, self.level)
        return self.median / self.peak(motion)

    def peak(self, motion: Motion) -> float:
        """Return the peak or spectral acceleration of a motion that the level is of [m/s², m/s].

        Raises
        ------
        InputError
            A still motion, or one of an upper floor.
        """
        of_the_ground(motion, "strength")
        if self.measure == "SA":
            return horizontal_sa(motion, self.period)
        return horizontal_peak(motion, self.measure)


def horizontal_sa(motion: Motion, period: float) -> float:
    """Return the geometric mean of Sa of the horizontal components [m/s²]; of a motion without y it is x's.

    Parameters
    ----------
    motion : Motion
        The motion.
    period : float
        The period [s]; the damping is 5 %.

    Raises
    ------
    InputError
        A component that is still.
    """
    values = {name: float(motion.spectrum(period, DAMPING, name).sa[0]) for name in motion.horizontal}
    for name, sa in values.items():
        if not sa > 0.0:
            raise InputError("motion.still_component", component=name, motion=excerpt(motion.name))
    return math.prod(values.values()) ** (1.0 / len(values))


def larger_peak(motion: Motion, measure: StrengthMeasure) -> float:
    """Return PGA [m/s²] or PGV [m/s] of the larger horizontal component of a motion; 0 of a still one."""
    single = map(motion.component, motion.horizontal)
    return max(part.pga if measure == "PGA" else part.pgv for part in single)


def horizontal_peak(motion: Motion, measure: StrengthMeasure) -> float:
    """Return the same of a motion that is to be scaled by it, which may not be still.

    Raises
    ------
    InputError
        A still motion.
    """
    peak = larger_peak(motion, measure)
    if not peak > 0.0:
        raise InputError("motion.still_floor")
    return peak


def mercalli_of(motion: Motion) -> float:
    """Return the modified Mercalli intensity of a motion, 1 of a still one; NaN of one of an upper floor."""
    if motion.floor:
        return math.nan
    if not any(map(np.any, motion.horizontal.values())):
        return 1.0
    return mercalli(horizontal_peak(motion, "PGA"), horizontal_peak(motion, "PGV"))


def _of_peak(measure: StrengthMeasure, value: float, period: float = 0.0) -> GroundStrength:
    """Return the strength of a peak or spectral acceleration [m/s², m/s], at a period [s]."""
    brief = phrase(f"ground_shaking.{measure.lower()}", value=value, hundredfold=100.0 * value, period=period)
    about = phrase("ground_shaking.scaled", stated=brief)
    return GroundStrength(measure, math.log10(value), about=about, brief=brief, period=period)


def strength_of_intensity(intensity: float) -> GroundStrength:
    """Return the strength of a JMA intensity."""
    about = phrase("ground_shaking.intensity", value=intensity)
    return GroundStrength(
        "JMA", intensity, about=about, brief=phrase("ground_shaking.value", value=intensity)
    )


@arguments(pga=quantity("m/s²", 1e-3, LARGEST_ACCELERATION, ("Peak ground acceleration", "地面の最大加速度")))
def strength_of_pga(pga: float) -> GroundStrength:
    """Return the strength of a peak acceleration.

    Parameters
    ----------
    pga : float
        Peak acceleration of the ground [m/s²], of the larger horizontal component, that every motion is
        scaled to, in the place of an intensity.
    """
    return _of_peak("PGA", pga)


@arguments(pgv=quantity("m/s", 1e-4, 10.0, ("Peak ground velocity", "地面の最大速度")))
def strength_of_pgv(pgv: float) -> GroundStrength:
    """Return the strength of a peak velocity.

    Parameters
    ----------
    pgv : float
        Peak velocity of the ground [m/s], of the larger horizontal component, that every motion is scaled
        to, in the place of an intensity.
    """
    return _of_peak("PGV", pgv)


@arguments(
    period=quantity("s", 0.01, 10.0, ("Period", "周期")),
    value=quantity("m/s²", 1e-3, LARGEST_ACCELERATION, ("Spectral acceleration", "加速度応答")),
)
def strength_of_sa(period: float, value: float) -> GroundStrength:
    """Return the strength of a spectral acceleration at a period.

    Parameters
    ----------
    period : float
        Natural period of the oscillator [s], whose damping is 5 %.
    value : float
        Spectral acceleration [m/s²], the geometric mean of the horizontal components, that every motion is
        scaled to, in the place of an intensity.
    """
    return _of_peak("SA", value, period)


@arguments(mmi=quantity("", 2.0, 10.0, ("Modified Mercalli intensity", "改正メルカリ震度")))
def strength_of_mercalli(mmi: float) -> GroundStrength:
    """Return the strength of a modified Mercalli intensity.

    Parameters
    ----------
    mmi : float
        Modified Mercalli intensity, in the place of a JMA intensity: motions are scaled to the peak velocity
        and its scatter of Worden et al. (2012).
    """
    about = phrase("ground_shaking.mmi", value=mmi)
    source = phrase("ground_shaking.mmi_source")
    return GroundStrength("PGV", math.log10(pgv_of_mercalli(mmi)), MERCALLI_SCATTER, about, about, source)


def strength_of_earthquake(earthquake: EarthquakeSource) -> GroundStrength:
    """Return the strength of an earthquake at a distance."""
    about = phrase(
        "ground_shaking.earthquake",
        magnitude=earthquake.magnitude,
        distance=earthquake.distance,
        depth=earthquake.depth,
        kind=phrase(f"ground_shaking.{earthquake.kind}"),
        vs30=earthquake.vs30,
    )
    source = phrase("ground_shaking.earthquake_source")
    brief = phrase("ground_shaking.magnitude", magnitude=earthquake.magnitude, distance=earthquake.distance)
    return GroundStrength("PGV", math.log10(earthquake.pgv), EARTHQUAKE_SCATTER, about, brief, source)
