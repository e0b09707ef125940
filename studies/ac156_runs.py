"""Pieces under the motions of AC156's tests, and on floors under earthquakes of the same S_DS."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from stayput.building import Building
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME
from stayput.model.body import Body
from stayput.model.furniture import FURNITURE
from stayput.model.gravity import STANDARD_GRAVITY
from stayput.model.room import Floor, Room
from stayput.model.state import State
from stayput.motion.suites import asce7, synthetic_suite
from stayput.simulation.columns import run_columns
from stayput.simulation.flat_fields import case_columns
from stayput.standards import ac156, ac156_motion, asce43_sliding

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.motion import Motion
    from stayput.motion.suites import Suite

HEIGHTS = (0.0, 0.5, 1.0)
"""z/h of the floors: the ground, the middle storey, the roof."""

PIECES = (
    "bookcase",
    "cupboard",
    "wardrobe",
    "refrigerator",
    "upright piano",
    "vending machine",
    "server rack",
)
"""Presets of furniture that are tested, unanchored."""

ROOMS = {"vinyl": Room(Floor.of("vinyl")), "no sliding": Room(Floor(3.0, 3.0))}
"""Floors that the pieces stand on."""

BUILDINGS = {
    "3-storey RC": Building(3, "RC"),
    "10-storey RC": Building(10, "RC"),
    "20-storey steel": Building(20, "steel"),
    "base-isolated 8-storey RC": Building(8, "base-isolated"),
}
"""Buildings, all by their defaults; storeys yield."""

LONG_PERIOD_RATIO = 0.6
"""S_D1 over S_DS of the earthquakes' spectrum (assumed)."""


@dataclass(frozen=True, slots=True)
class TestMethod:
    """A way to test: edition of ASCE 7, frequency from which on motions meet the spectrum [Hz]."""

    name: str
    edition: str
    lowest: float


TESTS = (
    TestMethod("AC156, ASCE 7-16", "7-16", 1.3),
    TestMethod("AC156, ASCE 7-22", "7-22", 1.3),
    TestMethod("7-16, met from 0.1 Hz on", "7-16", 0.1),
)
"""Tests: two that AC156 asks for, and one that also meets its spectrum below the cut-off."""

SLIDER, SLIDING_FRICTION = Body(1.2, 0.5, 200.0), 0.3
"""A piece too squat to rock, and its friction, for the sliding distance."""


def test_motions(kind: TestMethod, height_ratio: float, count: int, seed: int) -> list[Motion]:
    """Return motions along x and z that test at S_DS 1 g; at another S_DS they are that many times these."""
    required = ac156(1.0, height_ratio, kind.edition)
    motions = (
        ac156_motion(required, number, seed=seed, lowest=kind.lowest) for number in range(1, count + 1)
    )
    return [replace(motion, y=None) for motion in motions]


def earthquakes(sds: float, count: int, seed: int) -> Suite:
    """Return earthquakes of all families, each scaled to come nearest to the spectrum of ASCE 7."""
    return synthetic_suite(count=count, seed=seed).to_spectrum(asce7(sds, LONG_PERIOD_RATIO * sds))


def floors(ground: Sequence[Motion], building: Building) -> list[tuple[Motion, ...]]:
    """Return the motions along x and z of the floors at each of `HEIGHTS`."""
    storeys = [1 + round(ratio * building.storeys) for ratio in HEIGHTS]
    by_motion = building.floor_motions([replace(motion, y=None) for motion in ground], storeys)
    return list(zip(*by_motion, strict=True))


def fallen(
    bodies: Sequence[Body], rooms: Sequence[Room], motions: Sequence[Motion]
) -> tuple[NDArray[np.bool_], int]:
    """Run every body in every room under every motion.

    Returns
    -------
    fell : ndarray of bool, shape (bodies, rooms, motions)
        Whether it overturned.
    given_up : int
        Runs that were given up, counted as standing.
    """
    stands = [case_columns(body, room, State(), STANDARD_GRAVITY) for body in bodies for room in rooms]
    cases = np.repeat(np.concatenate(stands), len(motions))
    place = np.tile(np.arange(len(motions)), len(stands))
    results, _ = run_columns(cases, None, motions, place, progress=False)
    shape = len(bodies), len(rooms), len(motions)
    fell = (results["outcome"] == OVERTURNED_OUTCOME).reshape(shape)
    return fell, int((results["outcome"] == FAILED_OUTCOME).sum())


def slides(motions: Sequence[Motion]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the squat piece's peak slide by simulation and by ASCE 43-05 [m], each of shape (n,)."""
    room = Room(Floor(SLIDING_FRICTION, SLIDING_FRICTION))
    cases = np.repeat(case_columns(SLIDER, room, State(), STANDARD_GRAVITY), len(motions))
    results, _ = run_columns(cases, None, motions, np.arange(len(motions)), progress=False)
    estimates = [asce43_sliding(motion, SLIDING_FRICTION).distance for motion in motions]
    return results["peak_slide"], np.array(estimates)


def bodies() -> list[Body]:
    """Return the bodies of `PIECES`."""
    presets = (FURNITURE[name] for name in PIECES)
    return [Body(preset.width, preset.height, preset.mass) for preset in presets]
