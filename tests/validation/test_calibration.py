"""The intervals hold the truth as often as they say: studies repeated on populations that are known.

A smaller version of the documentation's calibration page. Each count of intervals that hold the truth is
binomial: the bounds are 93 to 97 % (to 100 % for few motions, whose intervals are wide on purpose), less and
more three standard errors of that many studies.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from interval_coverage import CHANGE, FAMILIES, PROBABILITY, QUANTITIES, Coverage, Mixture, coverage

from stayput.fragility.paired import difference
from stayput.fragility.probabilities import probability
from stayput.uncertainty import random_bits

STUDIES = 300
NO_GAIN = Mixture("no gain", (replace(FAMILIES[0].kinds[0], gain=0.0),), apart=(0.2, 0.1))
"""A measure that changes single runs, but not how many fall."""


def _error(share: float, studies: int) -> float:
    return 3.0 * math.sqrt(share * (1.0 - share) / studies)


LEAST = 0.93 - _error(0.93, STUDIES)
MOST = 0.97 + _error(0.97, STUDIES)


@pytest.fixture(scope="module", params=FAMILIES, ids=lambda family: family.name)
def family(request: pytest.FixtureRequest) -> Mixture:
    return request.param


@pytest.fixture(scope="module")
def twenty(family: Mixture) -> Coverage:
    return coverage(family, 20, 2, STUDIES, seed=3)


def _least(family: Mixture, quantity: str) -> float:
    """Return the least share that holds; a capacity leans by up to 0.1 where the truth has a shoulder."""
    return 0.75 if family is not FAMILIES[0] and quantity.startswith("I") else LEAST


@pytest.mark.parametrize("quantity", QUANTITIES)
def test_intervals_of_twenty_motions_hold_the_truth(family: Mixture, twenty: Coverage, quantity: str) -> None:
    assert _least(family, quantity) <= twenty.held[quantity] <= 1.0


@pytest.mark.parametrize("design", [(5, 4), pytest.param((40, 10), marks=pytest.mark.long)])
def test_intervals_of_few_and_of_many_motions_hold_the_truth(
    family: Mixture, design: tuple[int, int]
) -> None:
    found = coverage(family, *design, STUDIES, seed=3)
    assert all(share >= _least(family, quantity) for quantity, share in found.held.items())
    if design == (40, 10):
        assert max(found.held[quantity] for quantity in QUANTITIES[:3]) <= MOST + 0.01
        true, lean = family.truth(), 0.02 if family is FAMILIES[0] else 0.11
        assert found.median["I10"] == pytest.approx(true["I10"], abs=max(lean, 0.07))
        assert found.median["I50"] == pytest.approx(true["I50"], abs=lean)


@cache
def _changes(family: Mixture, motions: int, samples: int, studies: int) -> np.ndarray:
    """Return lower end, estimate and upper end of the difference of each study."""
    bits = random_bits(7, motions, samples)
    rows: list[tuple[float, float, float]] = []
    for _ in range(studies):
        falls = family.draw(motions, samples, bits)
        found = difference(falls.held, falls.bare)
        rows.append((found.low, found.estimate, found.high))
    return np.array(rows)


@pytest.mark.parametrize("design", [(20, 2), pytest.param((40, 10), marks=pytest.mark.long)])
def test_intervals_of_differences_are_no_wider_than_they_need_be(
    family: Mixture, design: tuple[int, int]
) -> None:
    studies = 800
    low, estimate, high = _changes(family, *design, studies).T
    true = family.truth()[CHANGE]
    held = float(np.mean((low <= true) & (true <= high)))
    assert 0.93 - _error(0.93, studies) <= held <= 0.97 + _error(0.97, studies)
    # half the width of an interval of 95 % beside 1.96 true standard errors
    assert 0.9 < float(np.median(high - low)) / (2.0 * 1.96 * float(np.std(estimate))) < 1.2


def test_difference_of_eighteen_points_is_called_clear_as_often_as_it_can_be(family: Mixture) -> None:
    low, estimate, high = _changes(family, 20, 2, 800).T
    assert family.truth()[CHANGE] == pytest.approx(-0.18, abs=0.002)
    clear = float(np.mean((low > 0.0) | (high < 0.0)))
    at_best = float(np.mean(np.abs(estimate) > 1.96 * float(np.std(estimate))))
    assert clear > at_best - 0.15


@pytest.mark.parametrize("motions", [5, 20, 40])
def test_no_difference_is_seldom_called_clear(motions: int) -> None:
    low, _, high = _changes(NO_GAIN, motions, 4, 500).T
    assert float(np.mean((low > 0.0) | (high < 0.0))) < 0.05 + _error(0.05, 500)


@pytest.mark.parametrize(("motions", "comparisons"), [(5, 8), (20, 3), (20, 8), (40, 8)])
def test_the_best_of_several_that_do_nothing_is_seldom_called_clear(motions: int, comparisons: int) -> None:
    bits, studies, wrong, alone = random_bits(11), 300, 0, 0
    for _ in range(studies):
        # what each set changes is drawn anew for the same motions: as samples of one study, side by side
        falls = NO_GAIN.draw(motions, 4 * comparisons, bits)
        sets = [np.s_[:, 4 * k : 4 * k + 4] for k in range(comparisons)]
        best = min(sets, key=lambda each: float(falls.held[each].mean() - falls.bare[each].mean()))
        pair = falls.held[best], falls.bare[best]
        wrong += difference(*pair, comparisons=comparisons).high < 0.0
        alone += difference(*pair).high < 0.0
    assert wrong / studies < 0.05 + _error(0.05, studies)
    assert wrong < alone  # as if it had been the only one


@pytest.mark.parametrize("shape", [(20, 2), (5, 4), (40, 10), (1, 10)])
def test_counts_without_a_scatter_have_honest_intervals(shape: tuple[int, int]) -> None:
    nothing = np.zeros(shape, bool)
    # of motions that decide alone, n of n standing tells that at most 1 − 0.025^(1/n) of them fall
    units = shape[0] if shape[0] > 1 else shape[1]
    exact = 1.0 - 0.025 ** (1.0 / units)
    found = probability(nothing)
    assert (found.low, found.estimate) == (0.0, 0.0)
    assert found.high == pytest.approx(exact, rel=0.15)
    every = probability(~nothing)
    assert (every.low, every.high) == (pytest.approx(1.0 - found.high), 1.0)
    same = difference(~nothing, ~nothing)
    assert (same.low, same.high) == pytest.approx((-same.high, exact), rel=0.2)


def test_the_same_seed_gives_the_same_bits(family: Mixture) -> None:
    first, second = (coverage(family, 5, 4, 20, seed=9) for _ in range(2))
    assert (first.held, first.median) == (second.held, second.median)
    assert coverage(family, 5, 4, 20, seed=10).median != first.median


def test_truths_are_those_of_many_runs(family: Mixture) -> None:
    falls = family.draw(40_000, 1, random_bits(1))
    true = family.truth()
    assert float(falls.bare.mean()) == pytest.approx(true[PROBABILITY], abs=0.01)
    assert float(falls.held.mean() - falls.bare.mean()) == pytest.approx(true[CHANGE], abs=0.01)
    shares = falls.by_level.mean(axis=(1, 2))
    assert shares == pytest.approx([family.share(level) for level in family.levels], abs=0.01)
