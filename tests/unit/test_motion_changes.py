"""What a motion's methods make of it: scaled, turned, trimmed, padded, resampled, corrected, combined."""

import math

import numpy as np
import pytest

from stayput.errors import InputError
from stayput.motion.record import Motion
from stayput.motion.synthetic import sine

NOISE = np.random.default_rng(3).normal(size=101)
THREE = Motion(0.01, NOISE, NOISE[::-1], 0.5 * NOISE, name="three", source="test")


def test_scaled_scales_every_component_and_says_so():
    double = THREE.scaled(-2.0)
    for name, values in THREE.components.items():
        assert np.array_equal(double.components[name], -2.0 * values)
    assert double.source == "test; scaled by -2"
    with pytest.raises(InputError, match="factor is nan"):
        THREE.scaled(math.nan)


def test_flipped_turns_the_horizontal_only():
    flipped = THREE.flipped()
    assert np.array_equal(flipped.x, -THREE.x)
    assert np.array_equal(flipped.y, -THREE.y)
    assert np.array_equal(flipped.z, THREE.z)


def test_rotated_by_a_quarter_and_back():
    quarter = THREE.rotated(math.pi / 2)
    assert quarter.x == pytest.approx(THREE.y)
    assert quarter.y == pytest.approx(-THREE.x)
    assert THREE.rotated(0.3).rotated(-0.3).x == pytest.approx(THREE.x)
    assert THREE.rotated(math.pi).x == pytest.approx(THREE.flipped().x)
    with pytest.raises(InputError, match="no y component"):
        Motion(0.01, NOISE).rotated(1.0)


def test_trimmed_keeps_both_ends():
    cut = THREE.trimmed(0.1, 0.3)
    assert len(cut) == 21
    assert cut.x[0] == THREE.x[10]
    assert cut.z[-1] == THREE.z[30]
    assert np.array_equal(THREE.trimmed().x, THREE.x)
    assert np.array_equal(THREE.trimmed(end=THREE.duration).x, THREE.x)


@pytest.mark.parametrize(("start", "end"), [(0.5, 0.5), (0.5, 0.4), (-0.1, 0.5), (0.0, 1.2), (math.nan, 1.0)])
def test_trims_that_are_refused(start, end):
    with pytest.raises(InputError):
        THREE.trimmed(start, end)


def test_padded_adds_a_still_floor():
    padded = THREE.padded(0.05, 0.1)
    assert len(padded) == len(THREE) + 15
    assert np.all(padded.y[:5] == 0.0)
    assert np.array_equal(padded.z[5:-10], THREE.z)
    with pytest.raises(InputError, match="before is -1 s"):
        THREE.padded(-1.0)


def test_refining_keeps_the_function():
    fine = THREE.resampled(0.002)
    assert fine.dt == pytest.approx(0.002)
    assert np.array_equal(fine.x[::5], THREE.x)
    assert fine.x == pytest.approx(np.interp(fine.time, THREE.time, THREE.x), abs=1e-12)
    assert fine.duration == pytest.approx(THREE.duration)


def test_coarsening_keeps_what_is_slow_and_drops_what_is_fast():
    t = np.arange(4001) * 0.005
    slow, fast = np.sin(2 * np.pi * 2.0 * t), np.sin(2 * np.pi * 30.0 * t)  # new Nyquist frequency: 25 Hz
    middle = slice(100, -100)
    kept = Motion(0.005, slow).resampled(0.02)
    assert np.abs(kept.x[middle] - slow[::4][middle]).max() < 1e-3
    assert np.abs(Motion(0.005, fast).resampled(0.02).x[middle]).max() < 1e-3
    assert np.abs(fast[::4][middle]).max() > 0.9  # plain decimation would have folded it down
    assert Motion(0.005, np.ones(100)).resampled(0.02).x == pytest.approx(np.ones(25))


@pytest.mark.parametrize("dt", [0.004, 0.015, 0.0, math.nan, 1e-9, "0.02s"])
def test_other_time_steps_are_refused(dt):
    with pytest.raises(InputError, match="dt"):
        THREE.resampled(dt)


def test_resampling_beyond_measure_is_refused():
    with pytest.raises(InputError, match="must have at most 20,000,000"):
        Motion(1.0, NOISE).resampled(1e-6)
    assert len(THREE.resampled(1.0)) == 2  # one new step is the least
    with pytest.raises(InputError, match=r"must be between 1e-06 and 0\.5 s"):
        THREE.trimmed(0.0, 0.5).resampled(1.0)


@pytest.mark.parametrize("order", [0, 1, 2, 3])
def test_baseline_correction_takes_off_the_polynomial_it_names(order):
    t = np.linspace(0.0, 1.0, 2001)
    drift = sum((k + 1.0) * t**k for k in range(order + 1))
    clean = Motion(0.005, drift).baseline_corrected(order)
    assert np.abs(clean.velocity).max() < 1e-4 * np.abs(Motion(0.005, drift).velocity).max()


def test_baseline_correction_leaves_no_trend_and_is_only_done_on_request():
    motion = Motion(0.01, np.sin(np.arange(2000) * 0.06) + 0.2, z=np.ones(2000))
    corrected = motion.baseline_corrected(1)
    assert abs(motion.velocity[-1]) > 3.0
    t, v = corrected.time, corrected.velocity
    for trend in (t, t * t):  # what is left stands at right angles to what was fitted
        assert abs(v @ trend) < 1e-9 * np.linalg.norm(v) * np.linalg.norm(trend)
    assert np.abs(corrected.z).max() < 1e-9
    with pytest.raises(InputError, match="order"):
        motion.baseline_corrected(7)


def test_combine_takes_the_x_of_each():
    ns, ew, ud = (
        Motion(0.02, NOISE, name="ns"),
        Motion(0.02, -NOISE, name="ew"),
        Motion(0.02, 2 * NOISE[:-1], name="ud"),
    )
    both = Motion.combine(ns, ew, ud, name="station")
    assert both.name == "station"
    assert len(both) == 100
    assert np.array_equal(both.y, -NOISE[:-1])
    assert np.array_equal(both.z, 2 * NOISE[:-1])
    assert "cut to 100 samples: x from 101, y from 101" in both.source
    assert Motion.combine(x=ns, z=ud).y is None
    assert not both.synthetic
    assert Motion.combine(ns, Motion(0.02, NOISE, synthetic=True)).synthetic


def test_combine_refuses_what_does_not_belong_together():
    ns = Motion(0.02, NOISE)
    with pytest.raises(InputError, match=r"dt of y is 0\.01 s"):
        Motion.combine(ns, Motion(0.01, -NOISE))
    with pytest.raises(InputError, match="within 1 %"):
        Motion.combine(ns, Motion(0.02, -NOISE[:50]))


def test_changes_keep_name_and_synthetic():
    motion = sine(1.0, 1.0, 2.0)
    for changed in (
        motion.scaled(2),
        motion.flipped(),
        motion.trimmed(0, 1),
        motion.padded(1),
        motion.resampled(0.01),
    ):
        assert changed.synthetic
        assert changed.name == motion.name


class _Stats:
    def __init__(self, channel, delta=0.01, start=0.0):
        self.network, self.station, self.channel = "BO", "AKT013", channel
        self.delta, self.starttime, self.calib = delta, start, 123.0


class _Trace:
    def __init__(self, data, channel, **stats):
        self.data, self.stats = data, _Stats(channel, **stats)


def test_traces_become_components_with_the_unit_given_and_no_calibration():
    motion = Motion.from_obspy(
        [_Trace(NOISE, "HNZ"), _Trace(2 * NOISE, "HNE"), _Trace(NOISE, "HNN")], "gal", component="NS"
    )
    assert motion.x == pytest.approx(0.01 * NOISE)
    assert motion.y == pytest.approx(0.02 * NOISE)
    assert motion.z == pytest.approx(0.01 * NOISE)
    assert motion.name == "BO.AKT013, HNN"


@pytest.mark.parametrize(
    ("traces", "message"),
    [
        ([], "is empty"),
        ([_Trace(NOISE, "HNE"), _Trace(NOISE, "HNE")], "in several parts"),
        ([_Trace(NOISE, "HNE"), _Trace(NOISE, "HNN", start=1.0)], "starts 1 s after"),
        ([_Trace(NOISE, "HNE"), _Trace(NOISE, "HNN", delta=0.02)], "must be that of x"),
        ([_Trace(np.ma.masked_array(NOISE, NOISE > 1), "HNE")], "gaps"),
    ],
)
def test_traces_that_are_refused(traces, message):
    with pytest.raises(InputError, match=message):
        Motion.from_obspy(traces, "gal")


def test_traces_in_counts_are_refused():
    with pytest.raises(InputError, match="unit of acceleration is 'counts'"):
        Motion.from_obspy([_Trace(NOISE, "HNE")], "counts")


def test_real_obspy_stream():
    obspy = pytest.importorskip("obspy", reason="ObsPy is not installed")
    stream = obspy.Stream(
        [obspy.Trace(NOISE.copy(), {"channel": c, "delta": 0.01}) for c in ("HNN", "HNE", "HNZ")]
    )
    motion = Motion.from_obspy(stream, "m/s²", name="mine")
    assert np.array_equal(motion.x, NOISE)
    assert list(motion.components) == ["x", "y", "z"]
    assert motion.name == "mine, HNN"
