"""The strength of an earthquake and of a modified Mercalli intensity, against the papers and their users.

Si and Midorikawa (1999) as Japan's hazard maps take it (National Research Institute for Earth Science and
Disaster Prevention, Technical Note 336, 2009, equation 3.5.1-1; OpenQuake's hazard library has it too);
Fujimoto and Midorikawa (2006); Worden et al. (2012) as the US Geological Survey's ShakeMap has it;
Midorikawa, Fujimoto and Muramatsu (1999), I = 2.68 + 1.72 log PGV; Wald, Quitoriano, Heaton and
Kanamori (1999).
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from stayput.motion.ground_shaking import (
    EARTHQUAKE_SCATTER,
    MERCALLI_SCATTER,
    EarthquakeSource,
    horizontal_peak,
    strength_of_earthquake,
    strength_of_mercalli,
)
from stayput.motion.intensity import jma_from_pgv, mercalli, mercalli_beyond, pgv_of_mercalli
from stayput.motion.suites.families import FAMILIES
from stayput.motion.suites.synthesis import synthetic_suite

ROCK = 600.0
"""Shear-wave velocity of the ground that the paper's equation is for [m/s]."""


@pytest.mark.parametrize(
    ("magnitude", "distance", "depth", "kind", "cm_s"),
    [
        # log PGV = 0.58 M + 0.0038 D + d - 1.29 - log(X + 0.0028 10^(0.5 M)) - 0.002 X, worked out by hand
        (6.0, 10.0, 10.0, "crustal", 12.61),
        (7.0, 20.0, 10.0, "crustal", 20.31),
        (8.0, 100.0, 30.0, "interface", 13.70),
        (7.0, 60.0, 50.0, "intraslab", 13.25),
    ],
)
def test_peak_velocity_on_rock_is_that_of_si_and_midorikawa(
    magnitude: float, distance: float, depth: float, kind: str, cm_s: float
) -> None:
    source = EarthquakeSource(magnitude, distance, depth, kind, ROCK)
    assert 100.0 * source.pgv == pytest.approx(cm_s, rel=0.001)


def test_the_kinds_of_earthquake_are_as_far_apart_as_in_the_paper() -> None:
    logs = {
        kind: math.log10(EarthquakeSource(7.0, 50.0, 30.0, kind, ROCK).pgv)
        for kind in ("crustal", "interface", "intraslab")
    }
    assert logs["interface"] - logs["crustal"] == pytest.approx(-0.02)
    assert logs["intraslab"] - logs["crustal"] == pytest.approx(0.12)


def test_ground_of_400_metres_a_second_amplifies_by_the_factor_of_the_hazard_maps() -> None:
    """The maps take 1.41 from 600 to 400 m/s (Technical Note 336)."""
    rock, ground = (EarthquakeSource(7.0, 30.0, vs30=vs30).pgv for vs30 in (600.0, 400.0))
    assert ground / rock == pytest.approx(1.41, abs=0.005)
    assert EarthquakeSource(7.0, 30.0, vs30=600.0).pgv > EarthquakeSource(7.0, 30.0, vs30=1500.0).pgv


def test_the_scatter_is_the_papers() -> None:
    assert strength_of_earthquake(EarthquakeSource(7.0, 30.0)).scatter == EARTHQUAKE_SCATTER == 0.23
    assert strength_of_mercalli(8.0).scatter == MERCALLI_SCATTER == 0.38


@pytest.mark.parametrize(
    ("mmi", "cm_s"), [(3.0, 0.295), (5.0, 4.65), (6.0, 9.64), (7.0, 20.0), (8.0, 41.4), (9.0, 85.8)]
)
def test_peak_velocity_of_a_mercalli_intensity_is_that_of_worden(mmi: float, cm_s: float) -> None:
    """Table of ShakeMap's scale by Worden et al. (2012): 4.65, 9.64, 20, 41.4 and 85.8 cm/s of V to IX."""
    assert 100.0 * pgv_of_mercalli(mmi) == pytest.approx(cm_s, rel=0.005)


@pytest.mark.parametrize("mmi", [3.0, 5.0, 7.0, 9.0])
def test_the_regression_read_backwards_gives_the_intensity(mmi: float) -> None:
    """The acceleration is that which the same paper's other line has at this intensity."""
    a = (mmi - 1.78) / 1.55 if mmi < 4.22 else (mmi + 1.60) / 3.70
    assert mercalli(0.01 * 10.0**a, pgv_of_mercalli(mmi)) == pytest.approx(mmi, abs=1e-9)


LEGEND = [
    (4, 2.8, 1.4),
    (5, 6.2, 4.7),
    (6, 12.0, 9.6),
    (7, 22.0, 20.0),
    (8, 40.0, 41.0),
    (9, 75.0, 86.0),
    (10, 139.0, 178.0),
]
"""ShakeMap's legend by Worden et al. (2012): intensity, PGA [% of g], PGV [cm/s]."""


@pytest.mark.parametrize(("mmi", "percent", "cm_s"), LEGEND)
def test_mercalli_intensity_is_that_of_the_legend_of_shakemap(mmi: int, percent: float, cm_s: float) -> None:
    assert mercalli_beyond(0.0980665 * percent, 0.01 * cm_s) == pytest.approx(mmi, abs=0.05)


@pytest.mark.parametrize(("mmi", "percent", "cm_s"), LEGEND[1:5])
def test_the_older_relation_of_california_is_within_a_third_of_a_degree(
    mmi: int, percent: float, cm_s: float
) -> None:
    """Wald et al. (1999) for V to VIII: 3.66 log PGA - 1.66 (cm/s²) and 3.47 log PGV + 2.35 (cm/s)."""
    gal = 9.80665 * percent
    older = 0.5 * (3.66 * math.log10(gal) - 1.66 + 3.47 * math.log10(cm_s) + 2.35)
    assert mercalli_beyond(0.01 * gal, 0.01 * cm_s) == pytest.approx(older, abs=0.34)


def test_beyond_the_ends_of_the_scale_the_lines_go_on() -> None:
    assert mercalli_beyond(30.0, 5.0) > mercalli(30.0, 5.0) == 10.0
    assert mercalli_beyond(1e-4, 1e-5) < mercalli(1e-4, 1e-5) == 1.0


def test_built_in_motions_have_the_intensity_that_recorded_ones_have_at_their_peak_velocity() -> None:
    """Scaled to a peak velocity they are as strong as Midorikawa et al. (1999) found records, within 0.1."""
    apart = [
        motion.intensity - jma_from_pgv(horizontal_peak(motion, "PGV"))
        for family in FAMILIES
        for motion in synthetic_suite(family, 12, 1).to_intensity(5.75)
    ]
    assert abs(float(np.mean(apart))) < 0.1
    assert float(np.std(apart)) < 0.3
