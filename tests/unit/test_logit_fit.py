"""The fit of a curve to runs: against an integration of its own, in repeated studies, and at its edges."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.special import expit, ndtr

from stayput.fragility.fit import LogitFit, RunsAround
from stayput.fragility.intensity_measures import JMA_INTENSITY, PGA, IntensityMeasure

U = np.array([-0.4, 0.0, 0.4])


def independent(fell: list[int], runs: list[int], measure: IntensityMeasure = JMA_INTENSITY) -> LogitFit:
    return LogitFit.of(measure, U, np.array(fell, float), np.array(runs, float))


def integrated(
    fell: list[int], runs: list[int], slope: float, scatter: float, at: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return the quantiles of p at a coordinate, and of where half fall, by sums over a fine even grid."""
    k, n = np.array(fell), np.array(runs)
    middle = (n * U).sum() / n.sum()
    a = np.linspace(-9.0, 9.0, 901)[:, np.newaxis, np.newaxis]
    log_b = np.linspace(np.log(slope) - 4.0 * scatter, np.log(slope) + 4.0 * scatter, 151)[:, np.newaxis]
    least, most = np.array([0.0, 0.01, 0.03, 0.0, 0.0]), np.array([1.0, 0.99, 0.97, 0.85, 0.65])
    share = expit(a)
    log_weight = (
        0.5 * np.log(share * (1.0 - share)) - 0.5 * ((log_b - np.log(slope)) / scatter) ** 2 + 0 * least
    )
    for x, falls, of in zip(U - middle, k, n, strict=True):
        p = np.clip(least + (most - least) * expit(a + np.exp(log_b) * x), 1e-300, 1.0 - 1e-16)
        log_weight = log_weight + falls * np.log(p) + (of - falls) * np.log1p(-p)
    weight = np.exp(log_weight - log_weight.max()).ravel()
    shares = (least + (most - least) * expit(a + np.exp(log_b) * (at - middle))).ravel()
    risen = (0.5 - least) / (most - least)
    half = (middle + (np.log(risen / (1.0 - risen)) - a) / np.exp(log_b)).ravel()
    found = []
    for values in (shares, half):
        order = np.argsort(values)
        summed = np.cumsum(weight[order])
        found.append(np.interp([0.025, 0.5, 0.975], summed / summed[-1], values[order]))
    return found[0], found[1]


@pytest.mark.parametrize(
    ("fell", "runs"), [([1, 6, 17], [20, 20, 20]), ([0, 0, 0], [14, 13, 13]), ([3, 70, 90], [100, 90, 95])]
)
@pytest.mark.parametrize(
    ("measure", "slope", "scatter"),
    [(JMA_INTENSITY, 4.8 * 0.5 * np.log(10.0), 0.45), (PGA, 3.3, 0.6)],
    ids=["intensity", "peak"],
)
def test_posterior_is_that_of_a_direct_integration(
    fell: list[int], runs: list[int], measure: IntensityMeasure, slope: float, scatter: float
) -> None:
    fit = independent(fell, runs, measure)
    for at in (-0.75, 0.0, 0.3):
        shares, half = integrated(fell, runs, slope, scatter, at)
        # its 61 points of a are up to a sixth of a standard deviation apart
        assert fit.probability(at) == pytest.approx(shares, abs=0.05 * (shares[2] - shares[0]))
        assert fit.coordinate(0.5) == pytest.approx(half, abs=0.05 * (half[2] - half[0]))


RUNS = np.array([13, 14, 13])
MOTION = np.arange(40)
LEVEL = np.repeat(U, RUNS)


@cache
def _ends(fell: tuple[int, ...]) -> np.ndarray:
    """Return lower and upper ends at -0.75, 0 and 0.75 of so many falls of `RUNS`, each of its own motion."""
    happened = np.concatenate([np.arange(n) < k for k, n in zip(fell, RUNS, strict=True)])
    return around(happened).fit().probability([-0.75, 0.0, 0.75])[[0, 2]]


def around(
    happened: np.ndarray, missing: np.ndarray | None = None, motion: np.ndarray = MOTION
) -> RunsAround:
    given_up = np.zeros(len(happened), bool) if missing is None else missing
    return RunsAround(JMA_INTENSITY, LEVEL, happened, given_up, motion)


@pytest.mark.parametrize(("slope", "far"), [(3.5, 0.93), (5.5, 0.93), (8.0, 0.85)])
def test_intervals_hold_the_truth(slope: float, far: float) -> None:
    rng = np.random.default_rng(1)
    middles = rng.uniform(-3.5, 3.5, 600)
    held = np.zeros(3)
    for middle in middles:
        low, high = _ends(tuple(rng.binomial(RUNS, expit(middle + slope * U)).tolist()))
        true = expit(middle + slope * np.array([-0.75, 0.0, 0.75]))
        held += (low <= true) & (true <= high)
    held /= len(middles)
    assert held[1] >= 0.93
    assert min(held[0], held[2]) >= far


def test_more_falls_are_a_higher_probability() -> None:
    at = np.linspace(-0.75, 0.75, 7)
    for place in range(3):
        found = []
        for more in range(0, 14, 3):
            fell = [2, 6, 11]
            fell[place] = more
            found.append(independent(fell, [13, 13, 13]).probability(at)[:, [1, 3, 5]])
        assert (np.diff(found, axis=0)[:, :, place] > -1e-9).all()
    curve = independent([2, 6, 11], [13, 13, 13]).probability(at)
    assert (np.diff(curve, axis=1) > 0.0).all()
    assert (np.diff(curve, axis=0) > 0.0).all()


def test_difference_holds_the_truth_and_is_sharpened_by_pairs() -> None:
    rng, held, clear = np.random.default_rng(3), 0, 0
    widths = {True: [], False: []}
    studies, gain, slope = 80, 0.22, 5.5
    for _ in range(studies):
        middle = rng.uniform(-1.5, 1.5)
        # of the load that decides three quarters are the same in both runs of a pair
        common = rng.standard_normal(40)
        own = 0.5 * rng.standard_normal((2, 40))
        load = (np.sqrt(0.75) * common + own) * 1.702 / slope
        bare, with_it = LEVEL + middle / slope - np.array([[0.0], [gain]]) + load > 0.0
        first, second = around(with_it), around(bare)
        found = first.difference(second)
        true = _probit(middle - gain * slope) - _probit(middle)
        held += found.low <= true <= found.high
        clear += found.clear
        alone = first.difference(
            around(np.concatenate([rng.permutation(part) for part in np.split(bare, [13, 27])]))
        )
        for pairs, each in ((True, found), (False, alone)):
            widths[pairs].append(each.high - each.low)
    assert held / studies >= 0.93
    assert clear > 0.2 * studies
    assert np.mean(widths[True]) < 0.95 * np.mean(widths[False])


def _probit(logit: float) -> float:
    return float(ndtr(logit / 1.702))


@pytest.mark.parametrize("happened", [np.zeros(40, bool), np.ones(40, bool), LEVEL > 0.0])
def test_pairs_that_are_all_equal_are_not_certain(happened: np.ndarray) -> None:
    found = around(happened).difference(around(happened))
    assert found.estimate == 0.0
    assert found.low < -0.03
    assert found.high > 0.03
    assert (found.pairs, found.more, found.fewer) == (14, 0, 0)


def test_more_comparisons_widen() -> None:
    rng = np.random.default_rng(5)
    first, second = (around(rng.random(40) < share) for share in (0.2, 0.6))
    one, eight = (first.difference(second, comparisons=count) for count in (1, 8))
    assert eight.low < one.low < one.estimate == eight.estimate < one.high < eight.high
    back = second.difference(first)
    assert (back.low, back.estimate, back.high) == pytest.approx((-one.high, -one.estimate, -one.low))


def test_missing_runs_widen() -> None:
    happened, missing = expit(5.5 * LEVEL) > np.linspace(0.05, 0.95, 40), np.arange(40) % 8 == 0
    every, some = (around(happened, lost).probability() for lost in (None, missing))
    assert some.low < every.low
    assert some.high > every.high
    assert (some.runs, some.missing) == (
        14 - (missing & (LEVEL == 0.0)).sum(),
        (missing & (LEVEL == 0.0)).sum(),
    )
    none = around(happened, np.ones(40, bool)).probability()
    assert (none.low, none.high, none.runs) == (0.0, 1.0, 0)
    assert np.isnan(none.estimate)
    lost = around(happened, np.ones(40, bool)).difference(around(happened))
    assert (lost.low, lost.high, lost.pairs) == (-1.0, 1.0, 0)


def test_runs_of_a_motion_that_are_alike_tell_less() -> None:
    rng = np.random.default_rng(7)
    own = expit(5.5 * LEVEL) > rng.random(40)
    alike = RunsAround(JMA_INTENSITY, *(np.tile(column, 4) for column in (LEVEL, own, ~own & own, MOTION)))
    once, again = around(own).fit(), alike.fit()
    assert again.design_effect > 2.0
    widths = [np.ptp(fit.probability(0.0)[[0, 2]]) for fit in (once, again)]
    assert widths[1] == pytest.approx(widths[0], rel=0.25)


def test_a_single_fall_far_below_the_others_does_not_flatten_the_curve() -> None:
    steep, with_it = (
        LogitFit.of(
            JMA_INTENSITY, np.linspace(-1.5, 1.5, 7), np.array([k, 0, 0, 20, 40, 40, 40.0]), np.full(7, 40.0)
        )
        for k in (0, 1)
    )
    assert with_it.slope > 0.6 * steep.slope
    assert with_it.probability(0.75)[1] > 0.9
