"""Invariants of suites: same seed same bits, another seed other bits, scaling that is exact."""

from __future__ import annotations

import hashlib
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from stayput.motion.processing import QUANTUM, displacement, ending_at_rest, velocity
from stayput.motion.suites.families import FAMILIES, Draws
from stayput.motion.suites.synthesis import synthetic_motion, synthetic_suite

if TYPE_CHECKING:
    from stayput.motion.suites.suite import Suite

SEED = 11


def digest(family: str, number: int) -> str:
    motion = synthetic_motion(family, number, SEED)
    return hashlib.sha256(b"".join(a.tobytes() for a in motion.components.values())).hexdigest()


ASKED = [(family, number) for family in FAMILIES for number in (1, 2)]


def test_another_process_finds_the_same_bits():
    script = "\n".join(
        (
            "import hashlib",
            "from stayput.motion.suites.synthesis import synthetic_motion",
            f"for family, number in {list(reversed(ASKED))!r}:",
            f"    motion = synthetic_motion(family, number, {SEED})",
            "    bits = b''.join(a.tobytes() for a in motion.components.values())",
            "    print(hashlib.sha256(bits).hexdigest())",
        )
    )
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert ran.stdout.split()[::-1] == [digest(*one) for one in ASKED]


def test_threads_find_the_same_bits_in_any_order():
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda one: digest(*one), ASKED * 2))
    assert found[: len(ASKED)] == found[len(ASKED) :] == [digest(*one) for one in ASKED]


def test_seeds_numbers_and_families_are_independent():
    motions = [synthetic_motion("crustal", n, seed) for n in (1, 2) for seed in (1, 2)]
    assert len({motion.x.tobytes() for motion in motions}) == 4
    draws = [Draws(*key).uniform(0.0, 1.0) for key in ((1, 2), (2, 1), (1, 2, 0), (1,))]
    assert len(set(draws)) == 4


@given(seed=st.integers(0, 2**32 - 1), n=st.integers(1, 501))
def test_draws_are_in_their_ranges(seed: int, n: int) -> None:
    draw = Draws(seed)
    assert 2.0 <= draw.uniform(2.0, 3.0) <= 3.0
    assert 2.0 <= draw.log_uniform(2.0, 3.0) <= 3.0
    assert -2.0 <= draw.normal() <= 2.0
    assert draw.choice((0.2, 0.8)) in (0, 1)
    noise = draw.noise(n)
    assert noise.shape == (n,)
    assert np.all(np.isfinite(noise))


def test_the_draws_are_the_same_with_every_version_of_the_libraries():
    draw = Draws(1, 2, 3)
    assert draw.uniform(0.0, 1.0) == 0.7955955324543236  # raw bits of PCG64: exact
    assert draw.normal() == pytest.approx(0.2192083517428792, rel=1e-12)


def test_noise_is_standard_normal():
    noise = Draws(3).noise(200_000)
    assert noise.mean() == pytest.approx(0.0, abs=0.01)
    assert noise.std() == pytest.approx(1.0, abs=0.01)
    assert np.mean(np.abs(noise) < 1.0) == pytest.approx(0.6827, abs=0.005)
    assert np.corrcoef(noise[:-1], noise[1:])[0, 1] == pytest.approx(0.0, abs=0.01)


@given(seed=st.integers(0, 2**32 - 1), n=st.integers(60, 4000), size=st.floats(0.01, 20.0))
def test_whatever_is_settled_ends_at_rest(seed: int, n: int, size: float) -> None:
    a = size * Draws(seed).noise(n)
    a[0] = a[-1] = 0.0
    rest = ending_at_rest(a)
    assert rest[0] == rest[-1] == 0.0
    whole = np.rint(rest / QUANTUM).astype(np.int64)
    assert int(whole.sum()) == 0
    assert int(np.sum(whole * np.arange(n, dtype=np.int64))) == 0
    assert abs(velocity(rest, 0.01)[-1]) < 1e-9
    assert abs(displacement(rest, 0.01)[-1]) < 1e-9


@settings(deadline=None)
@given(intensity=st.floats(1.0, 7.0))
def test_every_motion_reaches_an_intensity_exactly(intensity: float) -> None:
    suite: Suite = synthetic_suite(count=4).to_intensity(intensity)
    assert suite.intensities == pytest.approx([intensity] * 4, abs=1e-9)
