"""The synthetic families: plausible numbers, a baseline at rest, and variability from motion to motion.

The ranges are wide on purpose: what strong-motion records of such earthquakes show, not what one has.
"""

import math

import numpy as np
import pytest

from stayput.montecarlo.counting import OFFSETS, Members
from stayput.motion.processing import QUANTUM, displacement, ending_at_rest, velocity
from stayput.motion.response import mean_period
from stayput.motion.suites.families import ETA, FAMILIES, MIX, PointSource, SoilLayer, saragoni_hart
from stayput.motion.suites.synthesis import mixed_order, synthetic_suite

COUNT = 24

# Medians of x: D5–95 [s], mean period Tm [s], PGV/PGA [s].
# D5–95: a rupture takes about 5 to 10 s at M 7 and a minute or more at M 8.5; the path adds.
# Tm: stiff to middle soil has 0.3 to 0.7 s; a velocity pulse and late waves of a basin lengthen it.
# PGV/PGA: about 0.1 s for crustal records, 0.08 to 0.2 s with a pulse (JMA Kobe 1995: 0.9 m/s over 8.2 m/s²).
PLAUSIBLE = {
    "near-fault": ((4.0, 12.0), (0.40, 1.0), (0.08, 0.20)),
    "crustal": ((6.0, 20.0), (0.25, 0.7), (0.05, 0.12)),
    "subduction": ((40.0, 100.0), (0.35, 1.0), (0.08, 0.20)),
    "basin": ((40.0, 120.0), (0.50, 2.0), (0.12, 0.40)),
}


@pytest.mark.parametrize("family", FAMILIES)
def test_duration_period_and_velocity_are_plausible(family):
    suite = synthetic_suite(family, COUNT)
    found = (
        [motion.significant_duration for motion in suite],
        [mean_period(motion.x, motion.dt) for motion in suite],
        [motion.pgv / motion.pga for motion in suite],
    )
    for values, (low, high) in zip(found, PLAUSIBLE[family], strict=True):
        assert low < float(np.median(values)) < high


@pytest.mark.parametrize("family", FAMILIES)
def test_velocity_and_displacement_end_at_zero_and_samples_are_whole_quanta(family):
    for motion in synthetic_suite(family, 4):
        for a in motion.components.values():
            assert a[0] == a[-1] == 0.0
            assert abs(velocity(a, motion.dt)[-1]) < 1e-12
            assert abs(displacement(a, motion.dt)[-1]) < 1e-10
            assert np.abs(a / QUANTUM - np.rint(a / QUANTUM)).max() < 1e-6


@pytest.mark.parametrize("family", FAMILIES)
def test_records_vary_and_less_so_once_scaled_to_an_intensity(family):
    periods = np.geomspace(0.1, 3.0, 20)
    suite = synthetic_suite(family, COUNT)
    assert 0.3 < suite.log_std(periods).mean() < 1.1
    assert 0.25 < suite.to_intensity(6.0).log_std(periods).mean() < 0.7


def test_the_vertical_is_strongest_at_short_periods():
    suite = synthetic_suite("crustal", COUNT)
    ratio = suite.median([0.06, 0.1, 1.0], component="z") / suite.median([0.06, 0.1, 1.0], component="y")
    assert 0.6 < ratio[0] < 1.2
    assert ratio[2] < 0.75 * ratio[0]


def test_horizontal_components_have_their_own_phases_and_like_strengths():
    suite = synthetic_suite("crustal", COUNT)
    for motion in suite:
        assert abs(np.corrcoef(motion.x, motion.y)[0, 1]) < 0.4
    logs = [np.log(suite.spectra([0.2, 1.0], component=name)) for name in "xy"]
    assert np.corrcoef(logs[0][:, 1], logs[1][:, 1])[0, 1] > 0.6
    assert np.all((logs[0] - logs[1]).std(axis=0) > 0.1)


def test_the_pulse_of_a_near_fault_motion_lies_along_x():
    suite = synthetic_suite("near-fault", COUNT)
    ratio = [motion.pgv / motion.component("y").pgv for motion in suite]
    assert float(np.median(ratio)) > 1.5
    assert 0.4 < float(np.median([motion.pgv for motion in suite])) < 1.2


def test_the_late_waves_of_a_basin_are_long_and_come_late():
    for motion in synthetic_suite("basin", 6):
        v = motion.velocity
        late = v[len(v) // 3 : 2 * len(v) // 3]
        crossings = np.count_nonzero(np.diff(np.sign(late)) != 0)
        period = 2.0 * len(late) * motion.dt / crossings
        assert 2.0 < period < 12.0
        assert np.abs(late).max() > 0.01 * np.abs(v).max()


def test_lengths_are_those_of_the_families():
    for family, (low, high) in {
        "near-fault": (30, 30),
        "crustal": (40, 60),
        "subduction": (100, 240),
        "basin": (240, 300),
    }.items():
        for motion in synthetic_suite(family, COUNT):
            assert low - 1e-9 <= motion.duration <= high + 1e-9


def test_the_envelope_peaks_and_ends_where_boore_says():
    t = np.linspace(0.0, 30.0, 3001)
    w = saragoni_hart(t, 5.0, 20.0)
    assert w.max() == pytest.approx(1.0, abs=1e-9)
    assert t[w.argmax()] == pytest.approx(5.0 + 0.2 * 20.0)
    assert np.interp(25.0, t, w) == pytest.approx(ETA, rel=1e-6)
    assert not w[t < 5.0].any()


def test_a_source_has_its_moment_its_plateau_and_its_fall():
    source = PointSource(magnitude=7.0, distance=30.0, stress_drop=10.0, kappa=0.0)
    assert source.moment == pytest.approx(3.548e19, rel=1e-3)  # 10^19.55 N m
    assert source.corner_frequency == pytest.approx(0.4906 * 3500 * (1e7 / 3.548e19) ** (1 / 3), rel=1e-3)
    f = np.array([1e-3, 2e-3])
    low = source.amplitude(f)
    assert low[1] / low[0] == pytest.approx(4.0, rel=0.02)  # ω² below the corners
    # without path and κ, high frequencies are those of the ω² source of the stress drop
    high = np.array([30.0])
    damped = np.exp(-math.pi * 1e3 * source.effective_distance / (180.0 * 3500.0) * high**0.55)
    spread = 1.0 / source.effective_distance
    c = 0.55 * 2.0 * math.sqrt(0.5) / (4.0 * math.pi * 2800.0 * 3500.0**3 * 1e3)
    plateau = c * source.moment * (2.0 * math.pi * source.corner_frequency) ** 2 * spread
    assert source.amplitude(high) / damped == pytest.approx([plateau], rel=1e-3)


def test_a_soil_layer_resonates_at_its_period_by_the_impedance_ratio():
    layer = SoilLayer(period=0.5, impedance=0.4, damping=0.0)
    assert layer.amplification(np.array([0.0, 2.0, 4.0])) == pytest.approx([1.0, 2.5, 1.0])


def test_settling_leaves_a_record_that_is_at_rest_alone():
    motion = synthetic_suite("crustal", 1)[0]
    assert np.abs(ending_at_rest(motion.x) - motion.x).max() <= 2.0 * QUANTUM


@pytest.mark.parametrize("motions", [20, 40, 100])
def test_each_level_of_a_verification_has_its_share_of_each_family(motions):
    """The levels are taken in turn, as the families of a mixed suite are: no two turns may coincide."""
    members = Members.in_turn(motions, 3 * motions // 2, beside=True)
    family = np.array(mixed_order(motions))[members.motion]
    for level in range(len(OFFSETS)):
        there = members.level == level
        for name, share in MIX.items():
            assert abs((family[there] == name).sum() - share * there.sum()) < 2.0
