"""Drawn scenes of one piece under one component along its depth, in the plane and in space.

Half of the motions are sines, half the built-in near-fault motion; of nine pieces one is free and the others
are held by the usual measures with their default parameters, each device in space by itself.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import stayput as sp
from long_cases import long
from stayput.measures import MEASURES

SETS = (
    (),
    ("l_bracket",),
    ("belt",),
    ("tension_pole",),
    ("gel_mats",),
    ("felt_glides",),
    ("anti_slip_sheet",),
    ("wedge_stopper",),
    ("wedge_stopper", "tension_pole"),
)


def scene(number: int, rng: np.random.Generator) -> tuple[Any, ...]:
    width, height, length = rng.uniform(0.25, 0.6), rng.uniform(0.9, 2.1), rng.uniform(0.5, 1.4)
    centre = rng.uniform(-0.1, 0.1) * width, rng.uniform(-0.2, 0.1) * height
    body = sp.Body(width, height, rng.uniform(20.0, 200.0), cg_offset=centre, length=length)
    friction = rng.uniform(0.2, 0.9)
    floor = sp.Floor(friction, rng.uniform(0.7, 1.0) * friction)
    room = sp.Room(floor, left_wall=sp.Wall(rng.uniform(0.005, 0.08)), ceiling=sp.Ceiling(2.4))
    if number % 2:
        motion = sp.sine(rng.uniform(2.0, 7.0), rng.uniform(0.6, 3.0), 4.0)
    else:
        motion = sp.near_fault().component("x").scaled(rng.uniform(0.3, 1.2))
    return body, room, motion, [MEASURES[kind]() for kind in SETS[number % len(SETS)]]


@pytest.mark.parametrize("count", [54, *long(200)])
def test_peaks_and_outcomes(count: int) -> None:
    rng = np.random.default_rng(7)
    tilts, slides, differ = [], [], 0
    for number in range(count):
        plane, space = (sp.simulate(*given, dimensions=d) for given in [scene(number, rng)] for d in (2, 3))
        falls = plane.overturned, space.overturned
        differ += falls[0] != falls[1]
        if not any(falls):
            tilts.append(abs(space.peak_tilt - plane.peak_tilt) / max(plane.peak_tilt, 1e-3))
            slides.append(abs(space.peak_slide - plane.peak_slide) / max(plane.peak_slide, 1e-3))
    assert differ <= 0.01 * count  # chaos: a piece that stands on its edge falls to either side
    assert len(tilts) > 0.75 * count
    for errors in (tilts, slides):
        assert np.median(errors) < 0.002
        assert np.quantile(errors, 0.75) < 0.01


@pytest.mark.parametrize(("amplitude", "outcome"), [(2.5, "rested"), (3.0, "rocked")])
def test_a_tilt_too_small_to_be_rocking_is_none_in_both(amplitude: float, outcome: str) -> None:
    """From 2.45 m/s², g b/h, its edge leaves the floor: at 2.5 m/s² by 5e-6 rad."""
    body, room = sp.Body(0.4, 1.6, 100.0, length=0.8), sp.Room(sp.Floor(1.0, 0.9))
    motion = sp.sine(amplitude, frequency=4.0, duration=0.5)
    runs = [sp.simulate(body, room, motion, dimensions=count) for count in (2, 3)]
    assert [str(run.outcome) for run in runs] == [outcome] * 2
    assert all(run.peak_tilt > 0.0 for run in runs)
