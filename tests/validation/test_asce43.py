"""ASCE/SEI 43-05, appendix A, as far as legible: the sliding distance of a harmonic floor and of noise."""

import math

import numpy as np
import pytest

import stayput as sp

G = 9.80665


def test_effective_friction_counts_the_vertical_peak():
    a = np.zeros(2000)
    a[1000:1010] = 0.5 * G
    shaking = sp.sine(3.0, 2.0, 20.0, dt=0.01)
    motion = sp.Motion(0.01, shaking.x[:2000], z=a)
    estimate = sp.asce43_sliding(motion, 0.4)
    assert estimate.effective_friction == pytest.approx(0.4 * (1.0 - 0.4 * 0.5))
    assert estimate.coefficient == pytest.approx(2.0 * estimate.effective_friction * G)


def test_the_frequency_is_where_the_spectrum_first_reaches_the_coefficient():
    motion = sp.near_fault()
    estimate = sp.asce43_sliding(motion, 0.3)
    period = [1.0 / estimate.frequency]
    sa = math.hypot(*(float(motion.spectrum(period, 0.10, name).sa[0]) for name in ("x", "y")))
    assert sa == pytest.approx(estimate.coefficient, rel=0.02)
    slower = 1.0 / np.geomspace(0.999 * estimate.frequency, 0.1, 50)
    below = [motion.spectrum(slower, 0.10, name).sa for name in ("x", "y")]
    assert np.hypot(*below).max() < estimate.coefficient * 1.02
    assert estimate.distance == pytest.approx(
        estimate.coefficient / (2.0 * math.pi * estimate.frequency) ** 2
    )


def test_a_spectrum_that_stays_below_has_no_distance():
    estimate = sp.asce43_sliding(sp.sine(0.1, 2.0, 10.0), 0.5)
    assert math.isnan(estimate.frequency)
    assert math.isnan(estimate.distance)


def test_it_lies_above_simulated_sliding():
    """Over near-fault motions the presumed distance is 1.3 to 6 times the peak slide of a squat body."""
    body, mu = sp.Body(1.2, 0.5, 200.0), 0.3
    room = sp.Room(sp.Floor(mu, mu))
    ratios = []
    for motion in sp.synthetic_suite("near-fault", 12).to_intensity(6.3):
        along = sp.Motion(motion.dt, motion.x, z=motion.z)
        estimate = sp.asce43_sliding(along, mu)
        ratios.append(estimate.distance / sp.simulate(body, room, along).peak_slide)
    assert np.min(ratios) > 1.0
    assert np.max(ratios) < 8.0


def test_refusals():
    with pytest.raises(sp.InputError, match="friction"):
        sp.asce43_sliding(sp.near_fault(), 0.0)


def test_what_leaves_no_friction_is_beyond_the_method():
    along = sp.sine(3.0, 2.0, 20.0)

    def with_peak(factor):
        return sp.Motion(along.dt, along.x, z=factor * G * along.x / 3.0)

    assert sp.asce43_sliding(with_peak(2.4), 0.4).effective_friction == pytest.approx(0.4 * 0.04, rel=1e-3)
    for factor in (2.51, 4.0):
        with pytest.raises(sp.InputError, match=r"vertical acceleration is .* under 24.5 m/s²"):
            sp.asce43_sliding(with_peak(factor), 0.4)


def test_a_spectrum_that_is_above_from_the_first_frequency_on_has_no_distance():
    assert math.isnan(sp.asce43_sliding(sp.sine(3.0, 0.1, 60.0), 0.01).distance)
