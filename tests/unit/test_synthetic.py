"""Sines, pulses and the built-in record, against their closed forms."""

import hashlib
import math

import numpy as np
import pytest

from stayput.errors import InputError
from stayput.motion.synthetic import near_fault, pulse, sine


def test_sine_and_cosine_are_the_closed_form():
    motion = sine(5.0, 0.8)
    assert motion.duration == pytest.approx(30.0)
    assert motion.dt == pytest.approx(0.005)
    assert motion.x == pytest.approx(5.0 * np.sin(2 * np.pi * 0.8 * motion.time), abs=1e-9)
    cosine = sine(5.0, 0.8, phase=math.pi / 2)
    assert cosine.x[0] == pytest.approx(5.0)
    assert motion.synthetic
    assert "5 m/s²" in motion.name


def test_one_full_sine_and_quiet_after_it():
    motion = sine(4.0, 2.0, duration=1 / 2.0, quiet=10.0)
    assert motion.duration == pytest.approx(10.5)
    assert np.all(motion.x[101:] == 0.0)
    assert motion.velocity[-1] == pytest.approx(0.0, abs=1e-12)
    assert motion.pgv == pytest.approx(4.0 / (math.pi * 2.0), rel=1e-3)


def test_step_divides_a_duration_that_is_no_multiple_of_it():
    motion = sine(1.0, 3.0, duration=1 / 3.0)
    assert motion.dt < 0.005
    assert motion.duration == pytest.approx(1 / 3.0, rel=1e-12)


def test_a_cosine_that_stops_keeps_its_impulse():
    quarter = sine(1.0, 1.0, duration=1.0, phase=math.pi / 2, quiet=1.0)
    assert quarter.velocity[-1] == pytest.approx(0.0, abs=1e-12)  # not +½·A·dt
    assert quarter.x[200:203] == pytest.approx([0.5, 0.0, 0.0])


@pytest.mark.parametrize(
    "change",
    [
        {"amplitude": math.nan},
        {"amplitude": 2e4},
        {"frequency": 0.0},
        {"frequency": -1.0},
        {"frequency": 11.0},
        {"duration": 0.0},
        {"duration": 1e9},
        {"duration": 1e5, "dt": 1e-5},
        {"dt": 0.0},
        {"dt": 0.1},
        {"phase": math.inf},
        {"quiet": -1.0},
    ],
)
def test_sines_that_are_refused(change):
    with pytest.raises(InputError):
        sine(**{"amplitude": 1.0, "frequency": 1.0, **change})


@pytest.mark.parametrize("duration", [0.1, 0.2, 0.5, 0.0333])
def test_rectangular_pulse_has_the_exact_impulse_and_hardly_any_ramp(duration):
    motion = pulse("rectangular", 3.0, duration)
    assert motion.velocity[-1] == pytest.approx(3.0 * duration, rel=1e-12)
    assert motion.pgv == pytest.approx(3.0 * duration, rel=1e-12)
    assert motion.x[0] == 3.0
    ramp = np.flatnonzero((motion.x > 0.0) & (motion.x < 3.0))
    assert ramp.tolist() == [round(duration / motion.dt)]
    assert motion.dt <= 1e-3
    assert motion.duration == pytest.approx(duration + 10.0, abs=motion.dt)
    t, v = motion.duration, 3.0 * duration
    assert motion.displacement[-1] == pytest.approx(v * (t - duration / 2), rel=1e-6)


def test_half_sine_pulse():
    motion = pulse("half-sine", 2.0, 0.4)
    assert motion.pga == pytest.approx(2.0)
    assert motion.velocity[-1] == pytest.approx(2.0 * 2.0 * 0.4 / math.pi, rel=1e-5)
    assert motion.x[0] == pytest.approx(0.0, abs=1e-12)


def test_ricker_pulse_peaks_in_its_middle_and_leaves_nothing():
    motion = pulse("ricker", 3.0, frequency=2.0)
    assert motion.pga == pytest.approx(3.0)
    assert motion.time[motion.x.argmax()] == pytest.approx(0.75)
    assert motion.x.min() == pytest.approx(-6.0 * math.exp(-1.5), rel=1e-3)
    assert abs(motion.velocity[-1]) < 1e-6
    assert abs(motion.displacement[-1]) < 1e-5


@pytest.mark.parametrize(("gamma", "nu"), [(2.0, 0.0), (2.0, math.pi / 2), (1.0, 0.4), (3.3, 2.0)])
def test_mavroeidis_papageorgiou_velocity_is_the_closed_form(gamma, nu):
    f = 1 / 0.9
    motion = pulse("mavroeidis-papageorgiou", 0.9, frequency=f, gamma=gamma, nu=nu, quiet=1.0)
    tau = motion.time - gamma / (2 * f)
    v = 0.45 * (1 + np.cos(2 * np.pi * f * tau / gamma)) * np.cos(2 * np.pi * f * tau + nu)
    v[np.abs(tau) > gamma / (2 * f)] = 0.0
    assert np.abs(motion.velocity - v).max() < 1e-4
    assert abs(motion.velocity[-1]) < 1e-6


@pytest.mark.parametrize(
    ("args", "kwargs", "message"),
    [
        (("triangle", 1.0, 0.1), {}, "must be one of"),
        (("rectangular", 1.0), {}, "duration"),
        (("rectangular", 1.0), {"frequency": 1.0}, "duration"),
        (("rectangular", 1.0, 0.1, 1.0), {}, "duration"),
        (("ricker", 1.0, 0.1), {}, "frequency"),
        (("ricker", 1.0), {}, "frequency"),
        (("half-sine", math.nan, 0.1), {}, "amplitude"),
        (("half-sine", 1.0, 0.1), {"dt": 0.05}, "dt"),
        (("half-sine", 1.0, -0.1), {}, "duration"),
        (("mavroeidis-papageorgiou", 1.0), {"frequency": 1.0, "gamma": 0.5}, "gamma"),
        (("half-sine", 1.0, 0.1), {"quiet": 1e5, "dt": 1e-5}, "samples"),
    ],
)
def test_pulses_that_are_refused(args, kwargs, message):
    with pytest.raises(InputError, match=message):
        pulse(*args, **kwargs)


def test_near_fault_is_like_kobe_and_says_that_it_is_synthetic():
    motion = near_fault()
    assert "synthetic" in motion.name
    assert motion.synthetic
    assert (motion.dt, motion.duration) == (0.01, 30.0)
    peaks = motion.peaks()
    assert 6.0 < peaks["x"].pga < 8.5
    assert 0.8 < peaks["x"].pgv < 1.0
    assert 0.1 < peaks["x"].pgd < 0.3
    assert 0.5 < peaks["y"].pga / peaks["x"].pga < 0.9
    assert 0.35 < peaks["z"].pga / peaks["x"].pga < 0.7
    assert 4.0 < peaks["x"].significant_duration < 10.0


def test_near_fault_comes_to_rest_where_it_began():
    for name in "xyz":
        motion = near_fault().component(name)
        assert motion.x[0] == motion.x[-1] == 0.0
        assert abs(motion.velocity[-1]) < 1e-12
        assert abs(motion.displacement[-1]) < 1e-5


def test_near_fault_is_the_same_bits_every_time():
    whole = [np.rint(values * 1e6) for values in near_fault().components.values()]
    for values, micro in zip(near_fault().components.values(), whole, strict=True):
        assert np.array_equal(values, micro * 1e-6)
    digest = hashlib.sha256(b"".join(micro.astype("<i8").tobytes() for micro in whole)).hexdigest()
    assert digest == "5fe2f3ca484c73378a6b75a9c0f51ab32dd76dc4c79532fe20ce819863c29c03"
