"""Random bodies and stacks in space stay finite, enter the floor by microns only, and make no energy.

The cases are those of `benchmarks/space_cases.py`, of which `space_random.py` runs many more.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import stayput as sp
from benchmark_modules import benchmark

_, drawn, cases = (benchmark(name) for name in ("csv_tables", "space_cases", "space_random"))


def thrown(seed: int, **kind: Any) -> Any:
    """One body, or with boxes alone a stack, thrown at a still or a shaken floor."""
    rng = np.random.default_rng(seed)
    return drawn.case_of(rng, drawn.shapes(rng, 6) if not kind else kind["pool"])


@given(st.integers(0, 2**32 - 1))
def test_one_body(seed: int) -> None:
    case = thrown(seed)
    found = cases.run_one(case._replace(bodies=case.bodies[:1]))
    assert found.finite
    assert found.depth < 3e-6
    assert not found.made > 2e-5  # nan on a shaken floor


@given(st.integers(0, 2**32 - 1))
def test_boxes_on_each_other(seed: int) -> None:
    rng = np.random.default_rng(seed)
    pool = [sp.Body.box(*rng.uniform(0.1, 1.5, 3), float(rng.uniform(1.0, 200.0))) for _ in range(4)]
    found = cases.run_one(thrown(seed, pool=pool))
    assert found.finite
    assert found.depth < 3e-6
    assert not found.made > 1e-4  # nan on a shaken floor


@pytest.mark.parametrize(
    ("family", "number"), [("nearly flat rims", 490), ("nearly flat rims", 1383), ("cylinders", 1425)]
)
def test_bodies_that_turn_fast_and_fall_nearly_flat(family: str, number: int) -> None:
    found = cases.run_one(cases.case_number(family, 1, number))
    assert found.made < 1e-6
    assert found.depth < 3e-6


@pytest.mark.parametrize(("family", "number"), [("towers", 39), ("pyramids", 8), ("stacks on ice", 1)])
def test_towers_and_pyramids_run_to_their_end(family: str, number: int) -> None:
    found = cases.run_one(cases.case_number(family, 1, number))
    assert not found.given_up
    assert found.unconverged < 0.01 * found.steps
    assert found.between < 5e-5
