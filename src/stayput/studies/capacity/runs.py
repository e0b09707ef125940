"""Every motion scaled to every amplitude, on bodies that do not slip: medians beside the formula's."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.body import Body
from stayput.cases import State, case_columns
from stayput.ensemble.columns import run_columns
from stayput.estimates import kaneko_hayashi_median
from stayput.fragility import IntensityMeasure, Trials, fragility_curve
from stayput.furniture import FURNITURE
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME
from stayput.motion.units import STANDARD_GRAVITY
from stayput.room import Floor, Room, Wall

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.fragility import FragilityCurve
    from stayput.studies.capacity.spectra import Shakings

SIZES = ("bookcase", "cupboard", "chest", "refrigerator")
"""Presets whose sizes are taken; each is a uniform rectangle here, as the formula has it."""

STICKING = 3.0
"""Friction of the floor: no body slips."""

TAMED = 0.9
"""Factor on Housner's rate after a landing, where landings are made to lose more."""

BEHIND = Wall(0.02)
"""The wall of the variation with one."""

AMPLITUDE = IntensityMeasure("A/A50", "peak acceleration over the formula's median", "")
"""What the curves are fitted over: A/A₅₀, with each motion's own Fe in A₅₀."""

LOWEST, HIGHEST = 0.4, 4.0
"""Ends of the amplitudes A/A₅₀ to which every motion is scaled."""


@dataclass(frozen=True, slots=True)
class Setting:
    """Under what conditions the bodies stand.

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
        f"landings of {TAMED:g} times Housner's rate", Room(Floor(STICKING, STICKING, restitution=TAMED))
    ),
    Setting(f"a wall {100 * BEHIND.gap:g} cm behind", Room(Floor(STICKING, STICKING), left_wall=BEHIND)),
)
"""Variations under the same motions."""


def body_of(size: str) -> Body:
    """Return a preset's body."""
    preset = FURNITURE[size]
    return Body(preset.width, preset.height, preset.mass)


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """What became of one body under motions of one kind.

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
        """Median of the fitted curve: the simulation's A₅₀ over the formula's."""
        return self.curve.median

    @property
    def interval(self) -> tuple[float, float]:
        """Its 95 % interval."""
        capacity = self.curve.capacity(0.5)
        return capacity.low, capacity.high


def amplitudes(step: float) -> NDArray[np.float64]:
    """Return the amplitudes A/A₅₀, in relative steps of about ``step``."""
    count = 1 + round(np.log(HIGHEST / LOWEST) / step)
    return np.geomspace(LOWEST, HIGHEST, count)


def overturning(body: Body, room: Room, shakings: Shakings, factors: NDArray[np.float64]) -> Found:
    """Scale every motion to every amplitude and see what overturns.

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
    size = body.width, body.height
    formula = np.array([kaneko_hayashi_median(*size, float(fe)) for fe in shakings.frequencies])
    shape = len(pga), len(factors)
    cases = np.repeat(case_columns(body, room, State(), STANDARD_GRAVITY), shape[0] * shape[1])
    cases["scale"] = np.outer(formula / pga, factors).ravel()
    place = np.repeat(np.arange(shape[0]), shape[1])
    results, _ = run_columns(cases, None, shakings.motions, place, progress=False)
    fell, lost = (
        (results["outcome"] == outcome).reshape(shape) for outcome in (OVERTURNED_OUTCOME, FAILED_OUTCOME)
    )
    trials = Trials.from_runs(AMPLITUDE, factors, fell.T[:, :, np.newaxis], lost.T[:, :, np.newaxis])
    any_fell = fell.any(axis=1)
    return Found(
        formula=formula,
        curve=fragility_curve(trials),
        shares=fell.mean(axis=0),
        first=np.where(any_fell, factors[fell.argmax(axis=1)], np.inf),
        islands=float((np.maximum.accumulate(fell, axis=1) & ~fell).any(axis=1).mean()),
        given_up=int(lost.sum()),
    )
