"""How strongly the ground shakes in a scene, in words, before anything is simulated."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from stayput.app.refusals import refused
from stayput.app.replies import ShakingReply, Words
from stayput.catalogue import phrase
from stayput.montecarlo.hazard import Ground
from stayput.motion.intensity import intensity_class, published_intensity
from stayput.verification.words import class_phrase

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.scenario import AssemblyScenario, Scenario

ALIKE = 0.05
"""A standard deviation of intensities that is not mentioned."""


def shaking_reply(scenario: Scenario | AssemblyScenario) -> ShakingReply:
    """Return how strongly the ground shakes in a scene.

    Raises
    ------
    RefusedError
        A motion that is still.
    """
    ground = Ground(scenario.ground())
    shaking, strength = scenario.shaking, scenario.shaking.strength
    factors = ground.stated(strength, shaking.scale, scenario.uncertainty.seed)
    intensities = ground.intensities(factors)
    if not np.isfinite(intensities).all():
        raise refused(422, "motion.still_floor", "scene.shaking")
    middle, deviation = float(np.median(intensities)), float(np.std(intensities))
    told = None if strength is None else phrase("verification.strength", strength=strength.told(len(factors)))
    return ShakingReply(
        intensity=middle,
        deviation=deviation,
        intensity_class=None if ground.motions.floor else intensity_class(middle),
        sentence=Words.of(_sentence(middle, deviation, ground.motions.floor)),
        about=None if told is None else Words.of(told),
    )


def _sentence(middle: float, deviation: float, floor: str) -> Phrase:
    """Return an intensity in words, with the classes within a standard deviation."""
    at = published_intensity(middle)
    low, high = class_phrase(middle - deviation, floor), class_phrase(middle + deviation, floor)
    if deviation < ALIKE:
        return phrase("earthquake.amounts", at=at, strength=class_phrase(middle, floor))
    if low == high:
        return phrase("earthquake.amounts_about", at=at, deviation=deviation, strength=low)
    return phrase("earthquake.amounts_between", at=at, deviation=deviation, low=low, high=high)
