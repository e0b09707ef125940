"""The bits of an ensemble: whatever its threads, its chunks and the order of its cases."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from mechanics_cases import SEEDS

import stayput as sp

COUNT = 60
MOTIONS = [
    sp.near_fault().trimmed(5.0, 12.0),
    sp.sine(5.0, 1.3, 4.0),
    sp.pulse("half-sine", 6.0, 0.4, quiet=4.0),
]


def columns(rng: np.random.Generator) -> dict[str, object]:
    static = rng.uniform(0.1, 0.9, COUNT)
    return {
        "body.width": rng.uniform(0.2, 0.6, COUNT),
        "body.height": rng.uniform(0.5, 2.0, COUNT),
        "room.floor.static_friction": static,
        "room.floor.kinetic_friction": static * rng.uniform(0.5, 1.0, COUNT),
        "room.right_wall.gap": rng.uniform(0.0, 0.3, COUNT),
        "motion": [MOTIONS[n] for n in rng.integers(0, len(MOTIONS), COUNT)],
        "motion.scale": rng.uniform(0.3, 1.5, COUNT),
        "contact": list(rng.choice(["coulomb", "paper"], COUNT)),
    }


def bits(results: dict[str, np.ndarray]) -> dict[str, bytes]:
    return {name: values.tobytes() for name, values in results.items()}


@given(seed=SEEDS, threads=st.integers(1, 4), chunk=st.integers(1, 70))
def test_threads_and_chunks_change_no_bit(seed: int, threads: int, chunk: int) -> None:
    case = sp.Case(sp.Body(1.0, 1.0), sp.Room(), MOTIONS[0])
    asked = columns(np.random.default_rng(seed))
    assert bits(sp.simulate_many(case, asked, threads=threads, chunk=chunk)) == bits(
        sp.simulate_many(case, asked, threads=1, chunk=1000)
    )


@given(seed=SEEDS)
def test_the_order_of_the_cases_changes_no_bit(seed: int) -> None:
    case = sp.Case(sp.Body(1.0, 1.0), sp.Room(), MOTIONS[0])
    rng = np.random.default_rng(seed)
    asked, order = columns(rng), rng.permutation(COUNT)
    mixed = {name: [values[n] for n in order] for name, values in asked.items()}  # type: ignore[index]
    found = sp.simulate_many(case, asked, chunk=7)
    again = sp.simulate_many(case, mixed, chunk=7)
    assert bits({name: values[order] for name, values in found.items()}) == bits(again)
