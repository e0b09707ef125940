"""JMA's intensity: the agency's published records, its definition, and harmonic motions in closed form.

Published by the agency: a0 = 127.85 gal and intensity 5.1 for Yonago, 2000-10-06 (its own worked example);
intensity 5.7 for Uki, 2016-04-14, and 6.4 for Kobe, 1995-01-17.
"""

import math

import numpy as np
import pytest

from real_records import MOTIONS, recorded
from stayput.motion.intensity import (
    filtered_level,
    intensity_class,
    intensity_filter,
    long_period_class,
    long_period_response,
    published_intensity,
)
from stayput.motion.readers import read_motion
from stayput.motion.record import Motion
from stayput.motion.synthetic import sine


@pytest.mark.parametrize(("frequency", "expected"), [(1.0, 4.937), (0.5, 5.041), (5.0, 4.166)])
def test_sine_of_100_gal(frequency, expected):
    assert sine(1.0, frequency, 60.0, dt=0.01).intensity == pytest.approx(expected, abs=0.003)


def test_sine_is_weighted_by_the_filter_alone():
    motion = sine(2.0, 2.0, 60.0, dt=0.005)
    level = 200.0 * float(intensity_filter(np.array([2.0]))[0])
    assert filtered_level(motion.components.values(), motion.dt) == pytest.approx(level, rel=2e-4)


def test_definition_counts_the_time_at_or_above_the_level():
    rng = np.random.default_rng(4)
    motion = Motion(0.01, *rng.normal(size=(3, 4000)))
    weight = intensity_filter(np.fft.rfftfreq(4000, 0.01))
    rows = [np.fft.irfft(np.fft.rfft(100.0 * a) * weight, 4000) for a in motion.components.values()]
    vector = np.sqrt(np.sum(np.square(rows), axis=0))
    level = filtered_level(motion.components.values(), motion.dt)
    assert 0.01 * np.count_nonzero(vector >= level * (1 - 1e-12)) == pytest.approx(0.3)
    assert 0.01 * np.count_nonzero(vector > level * (1 + 1e-12)) < 0.3


@recorded
def test_yonago_2000_the_agencys_worked_example():
    motion = read_motion(MOTIONS / "jma_yonago_2000.csv")
    assert filtered_level(motion.components.values(), motion.dt) == pytest.approx(127.85, rel=1e-3)
    assert published_intensity(motion.intensity) == 5.1


@recorded
def test_uki_2016():
    intensity = read_motion(MOTIONS / "jma_uki_2016.csv").intensity
    assert published_intensity(intensity) == 5.7
    assert intensity_class(intensity) == "6-lower"


@recorded
def test_kobe_1995():
    ns, ew, ud = (read_motion(MOTIONS / f"jma_kobe_1995_{name}.AT2") for name in ("ns", "ew", "ud"))
    intensity = Motion.combine(ns, ew, ud).intensity
    assert published_intensity(intensity) == 6.4
    assert intensity_class(intensity) == "6-upper"


def test_long_period_response_at_resonance():
    # floor velocity 10 cm/s at 3 s; at resonance the oscillator moves 1/(2ζ) as far, a quarter of a wave late
    motion = sine(0.1 * 2.0 * math.pi / 3.0, 1.0 / 3.0, 300.0, math.pi / 2.0, dt=0.01)
    sva = long_period_response(motion.x, motion.y, motion.dt)
    assert sva == pytest.approx(0.1 * math.hypot(1.0, 1.0 / (2.0 * 0.05)), rel=1e-3)
    assert sva == pytest.approx(1.005, rel=1e-3)
    assert long_period_class(sva) == 4


def test_long_period_components_are_added_as_vectors():
    wave = sine(0.05, 0.25, 120.0, dt=0.01).x
    alone = long_period_response(wave, None, 0.01)
    assert long_period_response(0.6 * wave, 0.8 * wave, 0.01) == pytest.approx(alone, rel=1e-12)
    assert long_period_response(0.0 * wave, wave, 0.01) == pytest.approx(alone, rel=1e-12)


@pytest.mark.parametrize(
    ("response", "expected"), [(0.0499, 0), (0.05, 1), (0.15, 2), (0.4999, 2), (0.5, 3), (1.0, 4)]
)
def test_long_period_bounds(response, expected):
    assert long_period_class(response) == expected
