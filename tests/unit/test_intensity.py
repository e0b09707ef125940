"""Intensities, their classes, scaling to them, conversions and the measures in one record."""

import math

import numpy as np
import pytest

from stayput import InputError
from stayput.motion.ground_shaking import mercalli_of
from stayput.motion.intensity import (
    CLASSES,
    SpectralMeasures,
    intensity_class,
    intensity_of_class,
    jma_from_pgv,
    kawasumi,
    long_period_response,
    mercalli,
    published_intensity,
)
from stayput.motion.record import Motion
from stayput.motion.response import fourier_amplitude, konno_ohmachi, mean_period
from stayput.motion.synthetic import near_fault, sine
from stayput.scenario.shaking import ShakingTable


@pytest.mark.parametrize(
    ("intensity", "published"),
    [
        (5.154, 5.1),
        (5.194, 5.1),
        (5.195, 5.2),
        (5.199, 5.2),
        (4.994, 4.9),
        (4.9951, 5.0),
        (-0.31, -0.4),
        (-math.inf, 0.0),
    ],
)
def test_published_rounds_the_third_decimal_and_cuts_the_second(intensity, published):
    assert published_intensity(intensity) == published


def test_class_is_that_of_the_published_value():
    assert intensity_class(4.9949) == "5-lower"
    assert intensity_class(4.9951) == "5-upper"
    assert intensity_class(6.49) == "6-upper"
    assert intensity_class(6.4951) == "7"
    assert intensity_class(-2.0) == "0"


@pytest.mark.parametrize("name", [name for name, _ in CLASSES])
def test_the_middle_of_a_class_belongs_to_it(name):
    assert intensity_class(intensity_of_class(name)) == name


@pytest.mark.parametrize("name", ["6強", "震度6強", "６強", "震度６強", "6-UPPER"])
def test_a_class_may_be_called_as_people_call_it(name):
    assert intensity_of_class(name) == intensity_of_class("6-upper")
    assert ShakingTable(intensity=name).intensity == "6-upper"


@pytest.mark.parametrize("name", ["震度6", "強"])
def test_a_class_that_could_be_another_is_refused(name):
    with pytest.raises(InputError, match="must be one of"):
        intensity_of_class(name)


def test_unknown_class():
    with pytest.raises(InputError, match=r"'6-middle'; it must be one of '0', '1', .*'6-upper', '7'"):
        near_fault().to_intensity("6-middle")


@pytest.mark.parametrize("wanted", [2.0, 5.0, 6.0, 6.5, 7.3])
def test_scaled_exactly(wanted):
    scaled = near_fault().to_intensity(wanted)
    assert scaled.intensity == pytest.approx(wanted, abs=1e-9)
    assert f"to JMA intensity {wanted:g}" in scaled.source


def test_scale_moves_intensity_by_two_log_k():
    motion = near_fault()
    assert motion.scaled(3.7).intensity - motion.intensity == pytest.approx(2.0 * math.log10(3.7))


def test_a_class_is_scaled_to_its_middle():
    assert near_fault().to_intensity("6-lower").intensity == pytest.approx(5.75, abs=1e-9)


def test_still_floor_has_none_and_cannot_be_scaled():
    still = Motion(0.01, np.zeros(500))
    assert still.intensity == -math.inf
    with pytest.raises(InputError, match="still floor"):
        still.to_intensity(5.0)
    assert (published_intensity(still.intensity), intensity_class(still.intensity)) == (0.0, "0")
    assert (long_period_response(still.x, still.y, still.dt), mercalli_of(still)) == (0.0, 1.0)
    assert math.isnan(SpectralMeasures.of(still).mean_period)


@pytest.mark.parametrize("wanted", [math.nan, 12.0])
def test_absurd_intensity(wanted):
    with pytest.raises(InputError, match="Intensity is"):
        near_fault().to_intensity(wanted)


def test_too_short_for_an_intensity():
    with pytest.raises(InputError, match=r"lasts 0\.1 s; an intensity needs at least 0\.3 s"):
        _ = Motion(0.01, np.ones(11)).intensity


def test_order_of_components_does_not_matter():
    motion = near_fault()
    turned = Motion(motion.dt, motion.z, motion.x, motion.y)
    assert turned.intensity == pytest.approx(motion.intensity, abs=1e-12)


def test_conversions_at_hand_computed_points():
    assert jma_from_pgv(1.0) == pytest.approx(2.68 + 1.72 * 2.0)
    assert kawasumi(1.0) == pytest.approx(4.7)
    assert mercalli(3.0, 0.3) == pytest.approx(
        0.5 * (-1.60 + 3.70 * math.log10(300) + 2.89 + 3.16 * math.log10(30))
    )
    assert mercalli(1e-4, 1e-5) == 1.0
    assert mercalli(50.0, 20.0) == 10.0


def test_mercalli_has_no_step_where_its_branches_meet():
    a, v = 10.0**1.57 / 100.0, 10.0**0.53 / 100.0
    assert mercalli(a * 0.9999, v * 0.9999) == pytest.approx(mercalli(a * 1.0001, v * 1.0001), abs=0.01)


def test_conversion_of_nothing():
    with pytest.raises(InputError, match="PGV is 0 m/s; it must be larger than 0"):
        jma_from_pgv(0.0)


def test_cav_of_a_sine_is_its_mean_magnitude():
    assert sine(2.0, 1.0, 10.0, dt=0.005).peaks()["x"].cav == pytest.approx(
        2.0 * 2.0 / math.pi * 10.0, rel=1e-4
    )


def test_cav_between_samples_of_other_sign():
    assert Motion(1.0, np.array([1.0, -1.0])).peaks()["x"].cav == pytest.approx(0.5)


def test_fourier_amplitude_of_a_sine():
    f, amplitude = fourier_amplitude(sine(3.0, 2.0, 20.0, dt=0.01).x[:-1], 0.01)
    assert f[np.argmax(amplitude)] == pytest.approx(2.0)
    assert amplitude.max() == pytest.approx(3.0 * 20.0 / 2.0, rel=1e-6)


def test_smoothing_keeps_a_flat_spectrum():
    f = np.linspace(0.0, 50.0, 2000)
    assert konno_ohmachi(f, np.full(2000, 4.0), np.array([0.5, 5.0, 20.0])) == pytest.approx([4.0, 4.0, 4.0])


@pytest.mark.parametrize("period", [0.2, 1.0, 2.0])
def test_periods_of_a_sine(period):
    motion = sine(1.0, 1.0 / period, 40.0, dt=0.01)
    assert mean_period(motion.x, motion.dt) == pytest.approx(period, rel=0.01)
    assert SpectralMeasures.of(motion).predominant_period == pytest.approx(period, rel=0.03)


def test_housner_intensity_is_the_area_under_psv():
    motion = near_fault()
    periods = np.linspace(0.1, 2.5, 1201)
    area = np.trapezoid(motion.spectrum(periods).psv, periods)
    assert SpectralMeasures.of(motion).housner_intensity == pytest.approx(area, rel=2e-3)
