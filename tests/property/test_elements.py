"""Invariants of bodies that devices hold, over random bodies, rooms, motions and devices."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import (
    SEEDS,
    STANDARD_GRAVITY,
    Seeded,
    Standing,
    held_batches,
    mirrored,
    mirrored_elements,
    motions,
    random_elements,
    random_motion,
    random_standing,
    stacked,
    up,
)

from stayput import Motion
from stayput.mechanics.devices import columns as el
from stayput.mechanics.runner import run_cases_with_devices, shaking, trace

if TYPE_CHECKING:
    from numpy.typing import NDArray

FAILED = 5


def many(
    seed: int, count: int = 12, *, walls: bool = True
) -> tuple[list[Standing], NDArray[np.void], Motion]:
    source = Seeded(np.random.default_rng(seed))
    cases = [random_standing(source, walls=walls) for _ in range(count)]
    motion = random_motion(source, longest=400)
    return cases, np.stack([random_elements(source, case) for case in cases]), motion


def run(cases: list[Standing], elements: NDArray[np.void], motion: Motion):
    return run_cases_with_devices(
        stacked(cases), elements, shaking(motion.x, up(motion), motion.dt, 0), max_events=50_000
    )


Sample = tuple[list[Standing], "NDArray[np.void]", Motion]

SAMPLES = st.one_of(
    st.tuples(held_batches(), motions(longest=400)).map(lambda drawn: (*drawn[0], drawn[1])), SEEDS.map(many)
)
"""A few cases that Hypothesis can shrink, and larger samples: bodies, their devices and a motion."""


@settings(max_examples=50, deadline=None)
@given(sample=SAMPLES)
def test_every_run_with_devices_ends_with_finite_results(sample: Sample) -> None:
    cases, elements, motion = sample
    results, devices = run(cases, elements, motion)
    for name in ("end", "peak_slide", "residual_slide", "peak_tilt", "residual_tilt"):
        assert np.isfinite(results[name]).all()
    for name in ("peak_pull", "peak_push", "peak_shear", "plastic"):
        assert np.isfinite(devices[name]).all()
    failed = devices["failure"] != el.HOLDS
    assert np.array_equal(np.isfinite(devices["failure_time"]), failed)
    assert not failed[elements["kind"] == el.NONE].any()


def test_hardly_a_run_is_given_up() -> None:
    """Fewer than one wild case in a thousand; each is reported, none counted as standing."""
    given_up = total = 0
    for seed in range(60):
        cases, elements, motion = many(seed, 20)
        results, _ = run(cases, elements, motion)
        given_up += int((results["outcome"] == FAILED).sum())
        total += len(cases)
    assert given_up <= total // 1000


@settings(max_examples=30, deadline=None)
@given(sample=SAMPLES, data=st.data())
def test_same_bits_with_devices_in_any_company_and_with_histories(
    sample: Sample, data: st.DataObject
) -> None:
    cases, elements, motion = sample
    order = np.array(data.draw(st.permutations(range(len(cases)))))
    results, devices = run(cases, elements, motion)
    again, devices_again = run([cases[n] for n in order], elements[order], motion)
    assert again.tobytes() == results[order].tobytes()
    assert devices_again.tobytes() == devices[order].tobytes()
    found = trace(cases[0].columns()[0], shaking(motion.x, up(motion), motion.dt, 0), elements[0])
    if results["outcome"][0] != FAILED:  # which may be after fewer events than a run alone is given
        assert found.result["outcome"] == results["outcome"][0]
        assert found.result["peak_tilt"] == results["peak_tilt"][0]
        assert found.devices.tobytes() == devices[0].tobytes()


@settings(max_examples=15, deadline=None)
@given(seed=SEEDS)
def test_mirrored_case_runs_as_its_mirror_image(seed: int) -> None:
    """While it is not chaotic: over the first half second, and for most of a large sample."""
    cases, elements, motion = many(seed, walls=False)
    n = max(3, int(0.5 / motion.dt))
    short = Motion(motion.dt, motion.x[:n], z=up(motion)[:n])
    back = Motion(motion.dt, -motion.x[:n], z=up(motion)[:n])
    results, devices = run(cases, elements, short)
    images, their_devices = run([mirrored(case) for case in cases], mirrored_elements(elements), back)
    alike = np.abs(results["peak_tilt"] - images["peak_tilt"]) <= 1e-4 + 1e-3 * results["peak_tilt"]
    assert alike.mean() > 0.7
    calm = alike & (results["events"] < 5) & (results["outcome"] != FAILED)
    assert devices["peak_pull"][calm] == pytest.approx(their_devices["peak_pull"][calm], rel=0.05, abs=0.05)


def stored(elements: NDArray[np.void], forces: NDArray[np.float64]) -> NDArray[np.float64]:
    """Energy of springs without damping, from their forces [J/kg]."""
    k = np.where(elements["stiffness"] > 0.0, elements["stiffness"], np.inf)
    return (0.5 * forces**2 / k).sum(axis=(1, 2))


def seeded(seed: int) -> tuple[Standing, NDArray[np.void]]:
    source = Seeded(np.random.default_rng(seed))
    case = random_standing(source)
    return case, random_elements(source, case)


@settings(max_examples=40, deadline=None)
@given(held=st.one_of(held_batches(1).map(lambda drawn: (drawn[0][0], drawn[1][0])), SEEDS.map(seeded)))
def test_energy_with_devices_never_grows_under_steady_loads(held: tuple[Standing, NDArray[np.void]]) -> None:
    """Kinetic energy, height and springs: friction, impacts, dampers and failures only take from it."""
    case, elements = held
    elements["damping"] = 0.0
    n, dt = 200, 0.01
    still = shaking(np.zeros(n), None, dt, 0)
    found = trace(case.columns()[0], still, elements, error=1e-9)
    h = found.history
    # G's rates, by central differences of its places, are too coarse where it hits; so at rest alone
    omega, inertia = h[:, 3], case.columns()["inertia"][0]
    potential = STANDARD_GRAVITY * h[:, 1] + stored(elements, found.forces)
    energy = potential + 0.5 * inertia * omega**2
    start = potential[0] + 0.5 * _speed(case) ** 2 + 0.5 * inertia * omega[0] ** 2
    assert energy.max() <= start * (1.0 + 1e-6) + 1e-6


def _speed(case: Standing) -> float:
    """Largest speed that G can have at the start [m/s]."""
    reach = max(np.hypot(u, v) for u, v in case.body.corners)
    return abs(case.start.slide_rate) + reach * abs(case.start.tilt_rate)
