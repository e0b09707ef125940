"""Motion: what it accepts, and its peaks against integrals done by hand."""

import math
import pickle
import subprocess
import sys

import numpy as np
import pytest

from stayput.errors import InputError
from stayput.motion.record import Motion

NOISE = np.random.default_rng(7).normal(size=200)


@pytest.mark.parametrize(
    ("x", "message"),
    [
        ([0.0, math.nan], "finite"),
        ([0.0, math.inf, 1.0], "sample 1"),
        ([1.0], "between 2 and"),
        ([], "between 2 and"),
        ([[0.0, 1.0]], "one row"),
        (["a", "b"], "real numbers"),
        ([1j, 0j], "real numbers"),
        ([True, False], "real numbers"),
        ([0.0, 2e3], "1000"),
        ([[1.0], [1.0, 2.0]], "one row"),
        (None, "real numbers"),
        (np.ma.masked_array([1.0, 2.0], [False, True]), "gaps"),
    ],
)
def test_samples_that_are_refused(x, message):
    with pytest.raises(InputError, match=message):
        Motion(0.01, x)


@pytest.mark.parametrize("dt", [0.0, -0.01, math.nan, math.inf, 1e-7, 2.0, "fast", None])
def test_time_steps_that_are_refused(dt):
    with pytest.raises(InputError, match="dt"):
        Motion(dt, [0.0, 1.0])


@pytest.mark.parametrize("other", ["y", "z"])
def test_components_are_as_long_as_x(other):
    with pytest.raises(InputError, match=f"{other} has 3 values; it must have 2"):
        Motion(0.01, [0.0, 1.0], **{other: [0.0, 1.0, 0.0]})


def test_samples_are_a_read_only_copy():
    given = np.array([0.0, 1.0, 2.0])[::-1]
    motion = Motion(0.01, given)
    given[0] = 9.0
    assert motion.x[0] == 2.0
    assert motion.x.flags.c_contiguous
    with pytest.raises(ValueError, match="read-only"):
        motion.x[0] = 1.0


def test_a_pickled_motion_is_equal_and_still_read_only():
    motion = Motion(0.01, [0.0, 1.0], z=[0.5, 0.25], name="n", synthetic=True, source="s")
    back = pickle.loads(pickle.dumps(motion))
    assert back == motion
    assert hash(back) == hash(motion)
    assert not back.z.flags.writeable


def test_equality_looks_at_everything():
    motion = Motion(0.01, [0.0, 1.0], z=[0.5, 0.25])
    assert motion != Motion(0.01, [0.0, 1.0])
    assert motion != Motion(0.02, [0.0, 1.0], z=[0.5, 0.25])
    assert motion != Motion(0.01, [0.0, 1.5], z=[0.5, 0.25])
    assert motion != Motion(0.01, [0.0, 1.0], z=[0.5, 0.25], name="other")
    assert motion != "motion"


def test_time_and_duration():
    motion = Motion(0.5, [0.0, 1.0, 0.0])
    assert motion.duration == 1.0
    assert motion.time.tolist() == [0.0, 0.5, 1.0]
    assert len(motion) == 3


def test_velocity_and_displacement_of_a_triangle():
    motion = Motion(1.0, [0.0, 1.0, 0.0])
    assert motion.velocity == pytest.approx([0.0, 0.5, 1.0])
    assert motion.displacement == pytest.approx([0.0, 1 / 6, 1.0])


def test_peak_velocity_lies_where_the_acceleration_changes_sign():
    motion = Motion(1.0, [1.0, -1.0])  # v = τ − τ²
    assert motion.velocity == pytest.approx([0.0, 0.0])
    assert motion.pgv == pytest.approx(0.25)


def test_peak_displacement_lies_where_the_velocity_changes_sign():
    motion = Motion(1.0, [1.0, -2.0])  # v = τ − 3τ²/2, d = τ²/2 − τ³/2
    assert motion.displacement == pytest.approx([0.0, 0.0])
    assert motion.pgd == pytest.approx(2 / 27)


def test_peaks_are_those_of_a_hundred_times_finer_record():
    motion = Motion(0.02, NOISE)
    fine = motion.resampled(0.02 / 100)
    assert motion.pga == fine.pga
    assert motion.pgv >= np.abs(fine.velocity).max() - 1e-12
    assert motion.pgv == pytest.approx(np.abs(fine.velocity).max(), rel=1e-4)
    assert motion.pgv > np.abs(motion.velocity).max() * 1.0001  # the samples alone miss it here
    assert motion.pgd == pytest.approx(np.abs(fine.displacement).max(), rel=1e-6)
    assert motion.arias == pytest.approx(fine.arias, rel=1e-12)
    assert motion.significant_duration == pytest.approx(fine.significant_duration, abs=1e-9)


def test_arias_intensity_of_a_line_through_zero():
    assert Motion(1.0, [1.0, -1.0]).arias == pytest.approx(math.pi / (2 * 9.80665) / 3)


def test_significant_duration_of_a_constant_and_of_a_ramp():
    assert Motion(0.5, np.ones(21)).significant_duration == pytest.approx(9.0)
    assert Motion(1.0, [0.0, 1.0]).significant_duration == pytest.approx(0.95 ** (1 / 3) - 0.05 ** (1 / 3))


def test_a_still_floor_has_no_peaks():
    motion = Motion(0.01, np.zeros(10))
    assert (motion.pga, motion.pgv, motion.pgd, motion.arias, motion.significant_duration) == (0, 0, 0, 0, 0)


@pytest.mark.parametrize("size", [1e-300, 1e-160, 1e-80, 1e3])
def test_peaks_of_tiny_and_huge_records_are_finite(size):
    motion = Motion(0.01, size * NOISE / np.abs(NOISE).max())
    peaks = motion.peaks()["x"]
    assert math.isfinite(peaks.pgd)
    assert 0.0 <= peaks.significant_duration <= motion.duration


def test_peaks_list_every_component_with_its_own_numbers():
    motion = Motion(0.01, NOISE, z=2.0 * NOISE)
    peaks = motion.peaks()
    assert list(peaks) == ["x", "z"]
    assert peaks["z"].pgv == pytest.approx(2.0 * motion.pgv)
    assert motion.component("z").arias == pytest.approx(4.0 * motion.arias)
    with pytest.raises(InputError, match="'y'; it must be one of 'x', 'z'"):
        motion.component("y")


def test_representation_is_one_short_line():
    text = repr(Motion(0.01, NOISE, z=NOISE, name="Kobe"))
    assert "Kobe" in text
    assert len(text) < 120


def test_import_is_light():
    code = (
        "import sys, stayput.motion.synthetic as m; m.near_fault(); "
        "print([n for n in ('obspy', 'numba', 'scipy', 'matplotlib', 'xarray') if n in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
