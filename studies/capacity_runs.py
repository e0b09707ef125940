"""Runs of the capacity study: its motions, each scaled to every amplitude, and what they overturn."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError
from stayput.estimates import kaneko_hayashi_median
from stayput.fragility import IntensityMeasure, Trials, fragility_curve
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME
from stayput.model.body import Body
from stayput.model.furniture import FURNITURE
from stayput.model.gravity import STANDARD_GRAVITY
from stayput.model.room import Floor, Room, Wall
from stayput.model.state import State
from stayput.motion.suites import Suite, TargetSpectrum, synthetic_suite
from stayput.simulation.columns import run_columns
from stayput.simulation.flat_fields import case_columns

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.fragility import FragilityCurve
    from stayput.motion import Motion

CORNERS = (0.2, 0.4, 0.8, 1.6, 3.2)
"""Corner periods of the spectra, from constant acceleration to constant velocity [s]."""

FAMILY = "crustal"
"""Family of the motions that are made to meet the spectra."""

DRAWN = ("near-fault", "crustal")
"""Families of the motions that are taken as they are drawn."""

_TABLE = np.geomspace(0.02, 10.0, 200)
"""Periods of a target's table [s]."""

SIZES = ("bookcase", "cupboard", "chest", "refrigerator")
"""Presets whose sizes are taken; each is a uniform rectangle here, as the formula has it."""

STICKING = 3.0
"""Friction of the floor: no body slips."""

LANDING_FACTOR = 0.9
"""Factor on Housner's rate after a landing, where landings are made to lose more."""

BEHIND = Wall(0.02)
"""The wall of the variation with one."""

AMPLITUDE = IntensityMeasure(
    "A/A50", ("peak acceleration over the formula's median", "最大加速度の、式の中央値に対する比"), ""
)
"""What the curves are fitted over: A/A₅₀, with each motion's own Fe in A₅₀."""

LOWEST, HIGHEST = 0.4, 4.0
"""Ends of the amplitudes A/A₅₀ to which every motion is scaled."""


def target(corner: float) -> TargetSpectrum:
    """Return a spectrum of the shape of Japan's design spectrum at bedrock, with another corner period.

    3.2 + 30T (T < 0.16 s), 8.0 (to the corner T_c), 8.0 T_c/T m/s². Its strength does not matter here.

    Parameters
    ----------
    corner : float
        T_c [s].
    """
    flat = np.where(corner > _TABLE, 8.0, 8.0 * corner / _TABLE)
    sa = np.where(_TABLE < 0.16, 3.2 + 30.0 * _TABLE, flat)
    return TargetSpectrum(_TABLE, sa, f"corner at {corner:g} s")


@dataclass(frozen=True, slots=True, eq=False)
class Shakings:
    """Motions of one kind.

    Parameters
    ----------
    name : str
        What they are called.
    corner : float
        Corner period of the spectrum that each meets [s]; NaN where they meet none.
    motions : tuple of Motion
        The motions.
    """

    name: str
    corner: float
    motions: tuple[Motion, ...]

    @property
    def peaks(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Peak accelerations [m/s²] and velocities [m/s] of the motions, shape [motion]."""
        pga, pgv = zip(*((motion.pga, motion.pgv) for motion in self.motions), strict=True)
        return np.array(pga), np.array(pgv)

    @property
    def frequencies(self) -> NDArray[np.float64]:
        """Equivalent frequencies Fe = A/(2πV) of the motions [Hz], shape [motion]."""
        pga, pgv = self.peaks
        return pga / (2.0 * math.pi * pgv)


def of_spectra(corners: Sequence[float], count: int, seed: int) -> list[Shakings]:
    """Return motions along x alone, each of which meets the spectrum of its corner period.

    Raises
    ------
    InputError
        No corner period, or one out of range.
    """
    if not corners or not all(0.16 <= corner <= 5.0 for corner in corners):
        raise InputError("studies.corners", "corners", corners=list(corners))
    drawn = synthetic_suite(FAMILY, count, seed)
    along = Suite(tuple(motion.component("x") for motion in drawn), drawn.name)
    return [
        Shakings(f"corner at {corner:g} s", corner, along.matched(target(corner)).motions)
        for corner in corners
    ]


def as_drawn(family: str, count: int, seed: int, *, vertical: bool) -> Shakings:
    """Return motions of a family as they are drawn, along x alone or with their vertical component."""
    motions = synthetic_suite(family, count, seed).motions
    if not vertical:
        motions = tuple(motion.component("x") for motion in motions)
    return Shakings(f"{family}, as drawn", math.nan, motions)


@dataclass(frozen=True, slots=True)
class Setting:
    """The floor and the walls of a series of runs.

    Parameters
    ----------
    name : str
        What it is called in tables.
    room : Room
        Floor and walls.
    """

    name: str
    room: Room


STATED = Setting("as stated", Room(Floor(STICKING, STICKING)))
"""A body that stands free and lands by Housner's rule."""

OTHERS = (
    Setting(
        f"landings of {LANDING_FACTOR:g} times Housner's rate",
        Room(Floor(STICKING, STICKING, restitution=LANDING_FACTOR)),
    ),
    Setting(f"a wall {100 * BEHIND.gap:g} cm behind", Room(Floor(STICKING, STICKING), left_wall=BEHIND)),
)
"""Variations under the same motions."""


def body_of(size: str) -> Body:
    """Return a preset's body.

    Raises
    ------
    InputError
        There is no such preset.
    """
    if size not in FURNITURE:
        raise InputError("studies.size", "sizes", size=size, sizes=", ".join(FURNITURE))
    preset = FURNITURE[size]
    return Body(preset.width, preset.height, preset.mass)


@dataclass(frozen=True, slots=True, eq=False)
class BodyCapacity:
    """Simulated capacity of one body under motions of one kind, beside the formula's.

    Parameters
    ----------
    formula : ndarray, shape [motion]
        A₅₀ of the formula, with each motion's own Fe [m/s²].
    curve : FragilityCurve
        Share that overturns over A/A₅₀.
    shares : ndarray, shape [amplitude]
        Share of the motions that overturn it, at each amplitude.
    first : ndarray, shape [motion]
        Lowest amplitude A/A₅₀ at which it overturns; infinite where none does.
    islands : float
        Share of the motions that leave it standing somewhere above their first amplitude.
    given_up : int
        Runs that were given up.
    """

    formula: NDArray[np.float64]
    curve: FragilityCurve
    shares: NDArray[np.float64]
    first: NDArray[np.float64]
    islands: float
    given_up: int

    @property
    def ratio(self) -> float:
        """Simulated median capacity over the formula's A₅₀; NaN where the curve has none."""
        return self.curve.capacity(0.5).estimate

    @property
    def dispersion(self) -> float:
        """Dispersion β of the lognormal curve nearest to the shares; NaN where there is none."""
        return math.nan if self.curve.lognormal is None else self.curve.lognormal.dispersion

    @property
    def interval(self) -> tuple[float, float]:
        """The 95 % interval of the ratio."""
        capacity = self.curve.capacity(0.5)
        return capacity.low, capacity.high


def amplitudes(step: float) -> NDArray[np.float64]:
    """Return the amplitudes A/A₅₀, in relative steps of about ``step``."""
    count = 1 + round(np.log(HIGHEST / LOWEST) / step)
    return np.geomspace(LOWEST, HIGHEST, count)


def overturning(body: Body, room: Room, shakings: Shakings, factors: NDArray[np.float64]) -> BodyCapacity:
    """Run a body under every motion at every amplitude, and return its capacity.

    Parameters
    ----------
    body, room
        What stands, and where.
    shakings : Shakings
        The motions.
    factors : ndarray, shape [amplitude]
        Amplitudes A/A₅₀, increasing.
    """
    pga, _ = shakings.peaks
    formula = np.array([kaneko_hayashi_median(body, float(fe)) for fe in shakings.frequencies])
    shape = len(pga), len(factors)
    cases = np.repeat(case_columns(body, room, State(), STANDARD_GRAVITY), shape[0] * shape[1])
    cases["scale"] = np.outer(formula / pga, factors).ravel()
    place = np.repeat(np.arange(shape[0]), shape[1])
    results, _ = run_columns(cases, None, shakings.motions, place, progress=False)
    outcome = results["outcome"].reshape(shape)
    fell, lost = outcome == OVERTURNED_OUTCOME, outcome == FAILED_OUTCOME
    trials = Trials.from_runs(AMPLITUDE, factors, fell.T[:, :, np.newaxis], lost.T[:, :, np.newaxis])
    any_fell = fell.any(axis=1)
    return BodyCapacity(
        formula=formula,
        curve=fragility_curve(trials),
        shares=fell.mean(axis=0),
        first=np.where(any_fell, factors[fell.argmax(axis=1)], np.inf),
        islands=float((np.maximum.accumulate(fell, axis=1) & ~fell).any(axis=1).mean()),
        given_up=int(lost.sum()),
    )
