"""Probabilities, differences and stopping, on counts with a known answer or drawn from a known truth."""

from __future__ import annotations

import numpy as np
import pytest

from stayput import InputError
from stayput.fragility.paired import difference, score_interval
from stayput.fragility.probabilities import probability, wilson


def test_wilson_of_published_counts() -> None:
    # Newcombe (1998), Statistics in Medicine 17, 857, table I, method 3
    assert wilson(81, 263) == pytest.approx((0.2553, 0.3662), abs=5e-5)
    assert wilson(15, 148) == pytest.approx((0.0624, 0.1605), abs=5e-5)
    assert wilson(0, 20) == pytest.approx((0.0, 0.1611), abs=5e-5)
    assert wilson(1, 29) == pytest.approx((0.0061, 0.1718), abs=5e-5)


def test_runs_that_are_all_alike_count_as_one_a_motion() -> None:
    one = probability(np.arange(40).reshape(40, 1) < 8)
    copies = probability(np.repeat(np.arange(40).reshape(40, 1) < 8, 16, axis=1))
    assert (copies.estimate, copies.design_effect) == (one.estimate, 16.0)
    assert (copies.low, copies.high) == pytest.approx((one.low, one.high))


def test_nothing_seen_is_not_certain() -> None:
    found = probability(np.zeros((40, 16), bool))
    assert found.estimate == 0.0 == found.low
    assert found.high == pytest.approx(wilson(0, 40, 2.0227)[1], rel=0.02)
    assert probability(np.ones((40, 16), bool)).low == pytest.approx(1.0 - found.high)


def test_one_fall_among_many_is_no_proof_that_runs_are_independent() -> None:
    fallen = np.zeros((40, 16), bool)
    before = probability(fallen).high
    fallen[0, 0] = True
    assert 5.0 * wilson(1, 640)[1] < probability(fallen).high < before


def test_one_motion_speaks_of_its_own_runs() -> None:
    found = probability(np.arange(50).reshape(1, 50) < 10)
    assert found.design_effect == 1.0
    assert (found.low, found.high) == pytest.approx(wilson(10, 50), abs=0.005)


def test_given_up_runs_are_neither_standing_nor_fallen() -> None:
    fallen = np.arange(40).reshape(40, 1) < 8
    missing = np.arange(40).reshape(40, 1) >= 36
    found = probability(fallen, missing)
    assert (found.fell, found.runs, found.missing, found.motions) == (8, 36, 4, 36)
    as_standing, as_fallen = probability(fallen), probability(fallen | missing)
    assert (found.low, found.high) == (as_standing.low, as_fallen.high)
    nothing = probability(fallen, np.ones_like(fallen))
    assert (nothing.low, nothing.high, nothing.text) == (0.0, 1.0, "unknown (no run)")


def _falls(rng: np.random.Generator, motions: int, samples: int, margin: float, between: float) -> np.ndarray:
    """Draw falls whose margins have a share ``between`` of their variance in common within a motion."""
    common = np.sqrt(between) * rng.standard_normal((motions, 1))
    return common + np.sqrt(1.0 - between) * rng.standard_normal((motions, samples)) < margin


def test_score_interval_of_paired_proportions() -> None:
    # its ends are where the score is the quantile; checked on a grid of differences by the restricted
    # likelihood, maximised numerically over the share q of pairs that differ for the second only
    more, fewer, pairs, z = 4.0, 16.0, 60.0, 1.959964
    q = np.linspace(1e-6, 1.0, 400_001)
    with np.errstate(invalid="ignore", divide="ignore"):
        for end in score_interval(more, fewer, pairs):
            height = more * np.log(q + end) + fewer * np.log(q) + (40.0) * np.log(1.0 - 2.0 * q - end)
            likeliest = q[np.nanargmax(height)]
            score = (more - fewer - pairs * end) / np.sqrt(pairs * (2.0 * likeliest + end * (1.0 - end)))
            assert abs(score) == pytest.approx(z, abs=1e-4)


def test_difference_of_pairs_that_are_all_equal_is_not_certain() -> None:
    same = np.zeros((40, 16), bool)
    for both in (same, ~same):
        found = difference(both, both)
        # as of 40 pairs: 1 - 0.025^(1/40) = 8.8 % could differ for the one or the other
        assert found.estimate == 0.0
        assert (found.low, found.high) == pytest.approx((-0.0876, 0.0876), abs=1e-4)
    everywhere = difference(~same, same)
    assert (everywhere.estimate, everywhere.high) == (1.0, 1.0)
    assert everywhere.low < 0.93


def test_one_motion_speaks_of_its_own_pairs() -> None:
    first, second = np.arange(50).reshape(1, 50) < 5, np.arange(50).reshape(1, 50) < 20
    found = difference(first, second)
    assert (found.low, found.high) == pytest.approx(score_interval(0, 15, 50))


def test_few_motions_that_agree_are_not_sure() -> None:
    # a fall in one draw of each of five motions, none with the measure: 5 of 20, and five facts
    bare = np.zeros((5, 4), bool)
    bare[:, 0] = True
    found = difference(np.zeros((5, 4), bool), bare)
    assert found.estimate == -0.25
    assert found.high > -0.1


def test_pairing_sharpens_a_difference() -> None:
    rng = np.random.default_rng(7)
    load = rng.standard_normal((40, 1)) + 0.3 * rng.standard_normal((40, 16))
    bare, held = load > 0.0, load > 0.4
    paired = difference(held, bare)
    strangers = difference(held, bare[::-1])
    assert paired.clear
    assert paired.high - paired.low < 0.6 * (strangers.high - strangers.low)
    same = difference(bare, bare)
    assert same.estimate == 0.0
    assert not same.clear


def test_pairs_with_a_given_up_run_do_not_count() -> None:
    first, second = np.ones((10, 2), bool), np.zeros((10, 2), bool)
    found = difference(first, second, np.arange(20).reshape(10, 2) >= 10)
    assert (found.pairs, found.missing, found.more, found.estimate) == (10, 10, 10, 1.0)
    assert difference(first, second, np.ones((10, 2), bool)).text == "unknown (no pair of runs)"


@pytest.mark.parametrize(
    ("call", "part"),
    [
        (lambda: probability(np.zeros((3, 4))), "float64"),
        (lambda: probability(np.zeros(3, bool)), r"\(3,\)"),
        (lambda: probability(np.zeros((0, 3), bool)), r"\(0, 3\)"),
        (lambda: probability(np.zeros((3, 4), bool), np.zeros((3, 3), bool)), r"\(3, 3\)"),
        (lambda: difference(np.zeros((3, 4), bool), np.zeros((3, 5), bool)), r"\(3, 5\)"),
    ],
)
def test_refused(call: object, part: str) -> None:
    with pytest.raises(InputError, match=part):
        call()  # type: ignore[operator]
