"""Motions written to files are read back as they were."""

import numpy as np
import pytest

from stayput import InputError, near_fault, read_motion, sine
from stayput.motion.record import Motion


def test_columns_hold_every_bit(tmp_path):
    motion = near_fault()
    back = read_motion(motion.write(tmp_path / "a.csv"))
    assert back.dt == motion.dt
    assert back.components.keys() == {"x", "y", "z"}
    for name, values in motion.components.items():
        assert np.array_equal(back.components[name], values)


@pytest.mark.parametrize("dt", [0.005, 1.0 / 128.0, 0.02])
def test_columns_keep_the_time_step(tmp_path, dt):
    motion = Motion(dt, np.random.default_rng(1).normal(size=5000), name="made up, with a comma\nand lines")
    back = read_motion(motion.write(tmp_path / "a.csv"))
    assert back.dt == pytest.approx(dt, rel=1e-12)
    assert np.array_equal(back.x, motion.x)
    assert back.y is None


def test_a_missing_component_is_written_as_still(tmp_path):
    motion = Motion(0.01, np.ones(10), z=np.arange(10.0))
    back = read_motion(motion.write(tmp_path / "a.csv"))
    assert back.y is not None
    assert not back.y.any()
    assert np.array_equal(back.z, motion.z)


def test_at2_in_g(tmp_path):
    motion = sine(3.0, 1.0, 4.0)
    back = read_motion(motion.write(tmp_path / "a.AT2"))
    assert back.x == pytest.approx(motion.x, rel=1e-14, abs=1e-300)
    assert back.dt == motion.dt


def test_synthetic_stays_labelled(tmp_path):
    assert read_motion(near_fault().write(tmp_path / "a.csv")).synthetic
    assert read_motion(near_fault().component("x").write(tmp_path / "a.at2")).synthetic
    recorded = Motion(0.01, np.ones(10), name="station")
    assert not read_motion(recorded.write(tmp_path / "b.csv")).synthetic


def test_stated_unit_is_not_contradicted(tmp_path):
    path = sine(3.0, 1.0, 4.0).write(tmp_path / "a.csv")
    assert read_motion(path, unit="m/s2").pga == pytest.approx(3.0)
    with pytest.raises(InputError, match=r"must be the one that the file states, 'm/s²'"):
        read_motion(path, unit="gal")


def test_at2_holds_one_component(tmp_path):
    with pytest.raises(InputError, match="has x, y, z and an AT2 file holds one"):
        near_fault().write(tmp_path / "a.at2")
    assert not list(tmp_path.iterdir())


def test_unknown_ending(tmp_path):
    with pytest.raises(InputError, match=r"ends in \.csv, \.at2"):
        near_fault().write(tmp_path / "a.xlsx")
