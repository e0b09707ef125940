"""Fragility curves: recovery of known ones, intervals, and runs that give no curve."""

from __future__ import annotations

import time

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.special import ndtr, ndtri

from stayput import InputError
from stayput.fragility import JMA_INTENSITY, PFV, PGA, PGV, State, Trials, bootstrap, fragility_curve

LEVELS = np.linspace(5.0, 7.0, 11)


def _runs(
    seed: int, motions: int = 40, samples: int = 16, between: float = 0.4, within: float = 0.2
) -> np.ndarray:
    """Return falls [level, motion, sample] of capacities of mean 6 whose deviation has two parts."""
    rng = np.random.default_rng(seed)
    capacity = (
        6.0 + between * rng.standard_normal((motions, 1)) + within * rng.standard_normal((motions, samples))
    )
    return capacity[np.newaxis] <= LEVELS[:, np.newaxis, np.newaxis]


def test_counts_on_a_curve_give_that_curve() -> None:
    im, runs = np.array([1.0, 2.0, 4.0, 8.0]), np.full(4, 10**9)
    fell = np.rint(runs * ndtr(np.log(im / 3.0) / 0.45))
    curve = fragility_curve(Trials.from_counts(PGA, im, fell, runs))
    assert (curve.median, curve.dispersion) == pytest.approx((3.0, 0.45), rel=1e-6)
    assert curve.misfit < 1e-6
    assert curve.log_dispersion == curve.dispersion


def test_fit_is_the_largest_likelihood() -> None:
    im, fell, runs = np.array([0.2, 0.4, 0.5, 0.9, 1.3]), np.array([0, 3, 2, 11, 18]), np.full(5, 20)

    def minus(x: np.ndarray) -> float:
        p = ndtr(np.log(im / np.exp(x[0])) / np.exp(x[1]))
        return -float((fell * np.log(p) + (runs - fell) * np.log1p(-p)).sum())

    other = minimize(minus, (-0.3, -0.5), method="Nelder-Mead", options={"xatol": 1e-9, "fatol": 1e-12})
    curve = fragility_curve(Trials.from_counts(PGV, im, fell, runs))
    assert (curve.median, curve.dispersion) == pytest.approx(tuple(np.exp(other.x)), rel=1e-6)


def test_layouts_agree() -> None:
    fallen = _runs(1)
    by_runs = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, fallen))
    counted = Trials.from_counts(JMA_INTENSITY, LEVELS, fallen.sum(axis=(1, 2)), np.full(11, 640))
    by_counts = fragility_curve(counted)
    level, motion, _ = np.indices(fallen.shape)
    names = [f"motion {m}" for m in motion.ravel()]
    by_rows = fragility_curve(
        Trials.from_rows(JMA_INTENSITY, LEVELS[level.ravel()], fallen.ravel(), names, groups=11)
    )
    for other in (by_counts, by_rows):
        assert (other.median, other.dispersion) == pytest.approx(
            (by_runs.median, by_runs.dispersion), rel=1e-9
        )
    assert by_rows.covariance == pytest.approx(by_runs.covariance, rel=1e-9)
    assert [row.probability for row in by_rows.levels] == [row.probability for row in by_runs.levels]
    # runs of a motion that are alike say less than as many that are independent
    width = [np.ptp(np.array(curve.band([6.0])), axis=0)[0] for curve in (by_runs, by_counts)]
    assert width[0] > 3.0 * width[1]


def test_scale_of_the_measure_does_not_matter() -> None:
    im, fell, runs = np.array([1.0, 2.0, 4.0]), [2, 9, 18], [20, 20, 20]
    small = fragility_curve(Trials.from_counts(PGA, im, fell, runs))
    large = fragility_curve(Trials.from_counts(PGA, 1e6 * im, fell, runs))
    assert large.median == pytest.approx(1e6 * small.median)
    assert large.dispersion_interval == pytest.approx(small.dispersion_interval)


def test_missing_runs_are_left_out() -> None:
    fallen = _runs(2)
    missing = np.zeros_like(fallen)
    missing[:, 30:] = True
    curve = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, fallen, missing))
    fewer = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, fallen[:, :30]))
    assert (curve.median, curve.capacity(0.1)) == (fewer.median, fewer.capacity(0.1))
    assert curve.trials.missing == missing.sum()


@pytest.mark.parametrize(
    ("motions", "samples", "between", "within"), [(40, 8, 0.4, 0.2), (20, 1, 0.4, 0.05), (40, 8, 0.1, 0.4)]
)
def test_capacity_intervals_hold_the_truth(motions: int, samples: int, between: float, within: float) -> None:
    beta, trials = np.hypot(between, within), 150
    held = {0.1: 0, 0.5: 0}
    for seed in range(trials):
        curve = fragility_curve(
            Trials.from_runs(JMA_INTENSITY, LEVELS, _runs(seed, motions, samples, between, within))
        )
        for share in held:
            found = curve.capacity(share)
            held[share] += found.low <= 6.0 + beta * ndtri(share) <= found.high
    # 93 % (what the formula gives with so few motions) less three standard errors
    assert min(held.values()) >= trials * 0.93 - 3.0 * np.sqrt(trials * 0.93 * 0.07)


def test_formula_and_bootstrap_agree() -> None:
    curve = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, _runs(3)))
    drawn = bootstrap(curve, 400, seed=4)
    assert drawn.unfitted == 0
    for share in (0.1, 0.5):
        found, (low, high) = curve.capacity(share), drawn.capacity_interval(share)
        assert (high - low) == pytest.approx(found.high - found.low, rel=0.25)
        assert 0.5 * (high + low) == pytest.approx(0.5 * (found.high + found.low), abs=0.05)
    assert (bootstrap(curve, 50, seed=4).ab == drawn.ab[:50]).all()
    assert not (bootstrap(curve, 50, seed=5).ab == drawn.ab[:50]).any()


def test_hundreds_of_curves_in_a_second() -> None:
    curve = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, _runs(3)))
    start = time.perf_counter()
    bootstrap(curve, 800)
    assert time.perf_counter() - start < 1.0


def test_capacity_is_read_off_the_band() -> None:
    curve = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, _runs(5)))
    found = curve.capacity(0.3)
    low, high = curve.band([found.high, found.low])
    assert curve.probability(found.estimate) == pytest.approx(0.3)
    assert (low[0], high[1]) == pytest.approx((0.3, 0.3))


def _counts(fell: list[int], runs: int = 100, im: tuple[float, ...] = (5.0, 5.5, 6.0, 6.5)) -> Trials:
    return Trials.from_counts(JMA_INTENSITY, np.array(im[: len(fell)]), fell, [runs] * len(fell))


@pytest.mark.parametrize(
    ("fell", "state", "half"),
    [
        ([0, 0, 0, 0], State.NONE_FELL, "> 6.50"),
        ([100, 100, 100, 100], State.ALL_FELL, "< 5.00"),
        ([0, 0, 100, 100], State.ABRUPT, "between 5.50 and 6.00"),
        ([0, 30, 100, 100], State.ABRUPT, "between 5.50 and 6.00"),
        ([0, 70, 100, 100], State.ABRUPT, "between 5.00 and 5.50"),
        ([0, 0, 0, 30], State.ABRUPT, "> 6.50"),
        ([20], State.ONE_LEVEL, "> 5.00"),
        ([80], State.ONE_LEVEL, "< 5.00"),
        ([50, 40, 30, 20], State.NO_TREND, "unknown"),
        ([30, 30, 30, 30], State.NO_TREND, "unknown"),
        ([100, 100, 0, 0], State.NO_TREND, "unknown"),
        ([1, 2, 4, 9], State.FITTED, "> 6.50"),
        ([90, 93, 97, 99], State.FITTED, "< 5.00"),
    ],
)
def test_in_words_where_there_is_no_number(fell: list[int], state: State, half: str) -> None:
    curve = fragility_curve(_counts(fell))
    found = curve.capacity(0.5)
    assert (curve.state, found.text) == (state, half)
    assert np.isnan(found.estimate)
    assert curve.text
    if state is not State.FITTED:
        assert np.isnan(curve.median)
        assert np.isnan(curve.probability([6.0])[0])


def test_words_say_when_they_are_unsure() -> None:
    assert fragility_curve(_counts([0, 0, 0, 0])).capacity(0.1).text == "> 6.50"
    assert fragility_curve(_counts([0, 0, 0, 0], runs=10)).capacity(0.1).text == "> 6.50 (unsure)"
    assert (
        fragility_curve(_counts([0, 0, 5, 5], runs=5)).capacity(0.1).text == "between 5.50 and 6.00 (unsure)"
    )
    barely = fragility_curve(_counts([2, 3, 4, 4], runs=10)).capacity(0.5)
    assert barely.text == "> 6.50 (unsure)"


def test_open_ends_are_said() -> None:
    found = fragility_curve(_counts([0, 2, 4, 6], runs=12)).capacity(0.5)
    assert found.text.endswith("to beyond what was run)")
    assert found.high == np.inf
    peak = fragility_curve(Trials.from_counts(PFV, [0.1, 0.2, 0.4], [5, 8, 11], [12, 12, 12])).capacity(0.5)
    assert peak.low == 0.0
    assert "below what was run to" in peak.text
    assert "cm/s" in peak.text


def test_tiny_and_lopsided_samples_never_break() -> None:
    rng = np.random.default_rng(11)
    with np.errstate(all="raise", under="ignore"):
        for _ in range(300):
            levels = int(rng.integers(1, 5))
            runs = rng.integers(1, 6, levels)
            fell = rng.binomial(runs, rng.random(levels))
            im = np.sort(rng.uniform(0.1, 10.0, levels))
            curve = fragility_curve(Trials.from_counts(PGA, im, fell, runs))
            for share in (0.1, 0.5):
                found = curve.capacity(share)
                assert np.isnan(found.estimate) or im[0] <= found.estimate <= im[-1]
                assert found.low <= found.high
                assert found.text
            assert curve.text


def test_one_motion_that_decides_is_no_certainty() -> None:
    # each motion overturns all samples from its own level on: 40 facts, not 7040
    rng = np.random.default_rng(12)
    capacity = 6.0 + 0.4 * rng.standard_normal((40, 1)) + np.zeros((40, 16))
    many = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, capacity <= LEVELS[:, None, None]))
    once = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, capacity[:, :1] <= LEVELS[:, None, None]))
    assert many.capacity().text == once.capacity().text


def test_curve_that_hangs_on_one_motion_is_open() -> None:
    # the others were run at the weakest level only, far from the falls
    fallen = np.zeros((11, 5, 4), bool)
    fallen[3:, 0] = True
    fallen[2:5, 0] = np.array([[0, 0, 0, 1], [0, 0, 1, 1], [0, 1, 1, 1]])
    missing = np.zeros_like(fallen)
    missing[1:, 1:] = True
    curve = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, fallen, missing))
    assert curve.state is State.FITTED
    found = curve.capacity()
    assert (found.low, found.high) == (-np.inf, np.inf)
    assert np.array(curve.band([6.0])).ravel() == pytest.approx([0.0, 1.0])


@pytest.mark.parametrize(
    ("call", "part"),
    [
        (lambda: Trials.from_runs(JMA_INTENSITY, LEVELS[:4], _runs(1)), r"\(4,\)"),
        (lambda: Trials.from_runs(PGA, -LEVELS, _runs(1)), "-5"),
        (lambda: Trials.from_runs(JMA_INTENSITY, LEVELS, _runs(1), np.ones((11, 40, 16), bool)), "given up"),
        (lambda: Trials.from_counts(PGA, [1.0, 2.0], [3, 1], [2, 2]), "3 falls of 2"),
        (lambda: Trials.from_counts(PGA, [1.0, np.nan], [1, 1], [2, 2]), "nan"),
        (lambda: Trials.from_counts(PGA, [1.0], [1, 1], [2, 2]), "one length"),
        (lambda: Trials.from_rows(PGA, [1.0], np.zeros(2, bool)), "2 runs"),
        (lambda: fragility_curve(_counts([1, 2, 4, 9])).capacity(0.0), "0"),
        (lambda: bootstrap(fragility_curve(_counts([1, 2, 4, 9]))), "one motion"),
    ],
)
def test_refused(call: object, part: str) -> None:
    with pytest.raises(InputError, match=part):
        call()  # type: ignore[operator]
