"""Records of phones: turned by hand, and with a clock that is off the nominal rate."""

from __future__ import annotations

import numpy as np
import pytest

import stayput as sp

HEAD = "Time (s),Acceleration x (m/s^2),Acceleration y (m/s^2),Acceleration z (m/s^2)"


def phone(angle: float, steps: tuple[float, ...] = (0.01,), samples: int = 3000) -> str:
    """Return the record of a phone that is turned by an angle in its middle third."""
    times = np.cumsum(np.resize(np.repeat(steps, samples // len(steps)), samples))
    turn = angle * np.clip(3.0 * np.arange(samples) / samples - 1.0, 0.0, 1.0)
    rows = zip(times, 9.8 * np.sin(turn), 0.3 * np.sin(np.arange(samples)), 9.8 * np.cos(turn), strict=True)
    return "\n".join([HEAD, *(f"{t:.9f},{x:.5f},{y:.5f},{z:.5f}" for t, x, y, z in rows), ""])


@pytest.mark.parametrize("angle", [0.3, 3.1, -1.5])
@pytest.mark.parametrize("given", [{}, {"remove_mean": True}])
def test_a_phone_that_is_turned_is_refused_as_that(refusal, angle, given):
    assert refusal(phone(angle), **given).code == "motion.turned"


def test_a_phone_that_lies_still_or_a_little_tilted_is_read_without_its_mean(read, refusal):
    assert refusal(phone(0.0)).code == "motion.gravity"
    assert read(phone(0.0), remove_mean=True)[0].pga == pytest.approx(0.0, abs=1e-6)


def test_strong_shaking_is_not_taken_for_turning(read):
    wave = sp.sine(8.0, 1.0, 30.0)
    rows = (f"{t:.4f},{a:.4f},0,{9.80665 + 0.5 * a:.4f}" for t, a in zip(wave.time, wave.x, strict=True))
    assert read("\n".join([HEAD, *rows, ""]), remove_mean=True)[0].pga == pytest.approx(8.0, rel=1e-2)


def test_a_rate_that_varies_is_refused_with_its_mean_which_is_read(read, refusal):
    text = phone(0.0, (0.01004, 0.010022))
    error = refusal(text)
    assert (error.code, error.field) == ("motion.varying_step", "dt")
    assert "must be equal, or taken as equal with their mean given: dt 0.01003" in str(error)
    mean = float(str(error).split()[-1].rstrip("."))
    assert read(text, dt=mean, remove_mean=True)[0].dt == mean
    assert refusal(text, dt=0.01).code == "motion.not_the_files_own"


@pytest.mark.parametrize("steps", [(0.01, 0.0125), (0.01, 0.02), (0.01, 0.0112)])
def test_steps_that_vary_by_more_or_lack_a_sample_are_irregular(refusal, steps):
    for given in ({}, {"dt": 0.011}):
        assert refusal(phone(0.0, steps), **given).code == "motion.irregular_sampling"
