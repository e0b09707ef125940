"""Fragility curves: recovery of known ones, intervals, and runs that give no curve."""

from __future__ import annotations

import re
from itertools import pairwise

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.special import ndtr, ndtri

from stayput import InputError
from stayput.fragility.curve import CurveState, fragility_curve
from stayput.fragility.intensity_measures import JMA_INTENSITY, PFV, PGA, PGV
from stayput.fragility.trials import Trials, pooled

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
    im, runs = np.geomspace(0.5, 20.0, 40), np.full(40, 10**9)
    fell = np.rint(runs * ndtr(np.log(im / 3.0) / 0.45))
    curve = fragility_curve(Trials.from_counts(PGA, im, fell, runs))
    found = curve.lognormal
    assert found is not None
    assert (found.median, found.dispersion) == pytest.approx((3.0, 0.45), rel=1e-6)
    assert found.misfit < 1e-6
    for share in (0.1, 0.5, 0.9):
        there = curve.capacity(share)
        assert there.estimate == pytest.approx(3.0 * np.exp(0.45 * ndtri(share)), rel=0.005)
        assert there.low <= there.estimate <= there.high
    # between levels the chord of the lower tail lies above the curve: the capacity is never told too high
    assert curve.capacity(0.1).estimate < 3.0 * np.exp(0.45 * ndtri(0.1))


def test_lognormal_is_the_largest_likelihood() -> None:
    im, fell, runs = np.array([0.2, 0.4, 0.5, 0.9, 1.3]), np.array([0, 3, 2, 11, 18]), np.full(5, 20)

    def minus(x: np.ndarray) -> float:
        p = ndtr(np.log(im / np.exp(x[0])) / np.exp(x[1]))
        return -float((fell * np.log(p) + (runs - fell) * np.log1p(-p)).sum())

    other = minimize(minus, (-0.3, -0.5), method="Nelder-Mead", options={"xatol": 1e-9, "fatol": 1e-12})
    found = fragility_curve(Trials.from_counts(PGV, im, fell, runs)).lognormal
    assert found is not None
    assert (found.median, found.dispersion) == pytest.approx(tuple(np.exp(other.x)), rel=1e-6)


def test_pooling_is_the_nearest_rising_curve() -> None:
    rng = np.random.default_rng(2)
    for _ in range(20):
        runs = rng.integers(1, 30, 8).astype(float)
        fell = rng.binomial(runs.astype(int), rng.random(8)).astype(float)
        rising = pooled(fell, runs)
        assert (np.diff(rising) >= 0.0).all()
        # the minimax formula of isotonic regression
        direct = [
            max(
                min(fell[a : b + 1].sum() / runs[a : b + 1].sum() for b in range(place, 8))
                for a in range(place + 1)
            )
            for place in range(8)
        ]
        assert rising == pytest.approx(direct)


def test_layouts_agree() -> None:
    fallen = _runs(1)
    by_runs = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, fallen))
    counted = Trials.from_counts(JMA_INTENSITY, LEVELS, fallen.sum(axis=(1, 2)), np.full(11, 640))
    by_counts = fragility_curve(counted)
    assert by_counts.capacity(0.3).estimate == pytest.approx(by_runs.capacity(0.3).estimate, rel=1e-12)
    assert by_counts.lognormal is not None
    assert by_runs.lognormal is not None
    assert by_counts.lognormal.dispersion == pytest.approx(by_runs.lognormal.dispersion, rel=1e-9)
    # runs of a motion that are alike say less than as many that are independent
    width = [np.ptp(np.array(curve.band([6.0])), axis=0)[0] for curve in (by_runs, by_counts)]
    assert width[0] > 2.5 * width[1]


def test_missing_runs_are_left_out() -> None:
    fallen = _runs(2)
    missing = np.zeros_like(fallen)
    missing[:, 30:] = True
    curve = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, fallen, missing))
    fewer = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, fallen[:, :30]))
    assert curve.capacity(0.1) == fewer.capacity(0.1)
    assert curve.trials.missing == missing.sum()


def test_levels_of_another_measure_are_grouped_by_the_one_asked() -> None:
    # motions of one level differ by a factor of 2 in the peak: what falls at a peak, not at a level, is shown
    fallen = _runs(3)
    factors = np.linspace(0.7, 1.4, 40)
    peaks = 10.0 ** (0.5 * (LEVELS[:, np.newaxis] - 6.0)) * factors
    curve = fragility_curve(Trials.from_runs(PGA, peaks, fallen))
    assert len(curve.levels) == len(LEVELS)
    assert all(a.highest <= b.lowest for a, b in pairwise(curve.levels))
    assert [level.im for level in curve.levels] == sorted(level.im for level in curve.levels)


def _bent(rng: np.random.Generator, motions: int, samples: int) -> np.ndarray:
    """Draw falls under two kinds of motions: of three in ten a tenth of the shaking is enough."""
    early = rng.random((motions, 1)) < 0.3
    mean = np.where(early, 5.3, 6.3) + 0.2 * rng.standard_normal((motions, 1))
    return mean + 0.1 * rng.standard_normal((motions, samples)) <= LEVELS[:, np.newaxis, np.newaxis]


def test_test_of_the_lognormal_knows_that_runs_of_a_motion_are_alike() -> None:
    refused = {True: 0, False: 0}
    for seed in range(150):
        fallen = _runs(seed, 30, 6)
        curve = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, fallen))
        alike = Trials.from_counts(JMA_INTENSITY, LEVELS, fallen.sum(axis=(1, 2)), np.full(11, 180))
        for motions, found in ((True, curve.lognormal), (False, fragility_curve(alike).lognormal)):
            assert found is not None
            refused[motions] += not found.fits
    # 5 % of 150, and three standard errors of that count; taken as independent, runs refuse good curves
    assert refused[True] <= 7.5 + 3.0 * np.sqrt(7.5)
    assert refused[False] > 25


def test_curve_that_bends_is_not_called_lognormal() -> None:
    rng, refused = np.random.default_rng(4), 0
    for _ in range(40):
        curve = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, _bent(rng, 40, 8)))
        assert curve.lognormal is not None
        refused += not curve.lognormal.fits
        if not curve.lognormal.fits:
            assert "does not fit" in curve.lognormal.text
    assert refused >= 32


def test_one_motion_has_no_band() -> None:
    # 62 % observed at 6.07 and 2 of 40 at 5.45, as of one record under forty draws
    levels = np.array([5.30, 5.45, 5.61, 5.76, 5.92, 6.07, 6.22, 6.5])
    fell = np.array([0, 2, 12, 20, 24, 25, 38, 40])
    fallen = np.arange(40) < fell[:, np.newaxis, np.newaxis]
    curve = fragility_curve(Trials.from_runs(JMA_INTENSITY, levels, fallen))
    assert curve.one_motion
    assert np.isnan(np.array(curve.band(levels))).all()
    assert curve.probability([6.07])[0] == 25 / 40
    tenth = curve.capacity(0.1)
    assert 5.45 < tenth.estimate < 5.61
    assert (tenth.low, tenth.high) == (-np.inf, np.inf)
    assert tenth.text == "5.48 (one motion: no interval)"
    assert "One motion tells nothing" in curve.text
    assert curve.lognormal is None


def test_band_of_a_curve_that_barely_rises_stays_with_what_fell() -> None:
    fallen = np.zeros((20, 20, 2), bool)
    fallen[-1, 0, 0] = True  # 1 of 40, at the top level only
    levels = np.linspace(4.1, 6.95, 20)
    curve = fragility_curve(Trials.from_runs(JMA_INTENSITY, levels, fallen))
    assert curve.state is CurveState.FITTED
    _, high = curve.band(curve.grid(200))
    assert high.max() < 0.25
    assert curve.capacity(0.1).text == "> 6.95 (unsure)"
    assert curve.capacity(0.5).text == "> 6.95"


def test_nothing_is_told_outside_what_was_run() -> None:
    curve = fragility_curve(Trials.from_runs(JMA_INTENSITY, LEVELS, _runs(5)))
    assert np.isnan(curve.probability([4.99, 7.01])).all()
    assert np.isnan(np.array(curve.band([4.99, 7.01]))).all()
    grid = curve.grid(500)
    low, high = curve.band(grid)
    p = curve.probability(grid)
    assert (low <= p).all()
    assert (p <= high).all()
    assert (np.diff(p) >= 0.0).all()


def _counts(fell: list[int], runs: int = 100, im: tuple[float, ...] = (5.0, 5.5, 6.0, 6.5)) -> Trials:
    return Trials.from_counts(JMA_INTENSITY, np.array(im[: len(fell)]), fell, [runs] * len(fell))


@pytest.mark.parametrize(
    ("fell", "state", "half"),
    [
        ([0, 0, 0, 0], CurveState.NONE_FELL, "> 6.50"),
        ([100, 100, 100, 100], CurveState.ALL_FELL, "< 5.00"),
        ([0, 0, 100, 100], CurveState.ABRUPT, "between 5.50 and 6.00"),
        ([0, 30, 100, 100], CurveState.FITTED, "between 5.50 and 6.00"),
        ([0, 70, 100, 100], CurveState.FITTED, "between 5.00 and 5.50"),
        ([0, 0, 0, 30], CurveState.FITTED, "> 6.50"),
        ([20], CurveState.ONE_LEVEL, "> 5.00"),
        ([80], CurveState.ONE_LEVEL, "< 5.00"),
        ([50, 40, 30, 20], CurveState.NO_TREND, "unknown"),
        ([30, 30, 30, 30], CurveState.NO_TREND, "unknown"),
        ([100, 100, 0, 0], CurveState.NO_TREND, "unknown"),
        ([1, 2, 4, 9], CurveState.FITTED, "> 6.50"),
        ([90, 93, 97, 99], CurveState.FITTED, "< 5.00"),
    ],
)
def test_in_words_where_there_is_no_number(fell: list[int], state: CurveState, half: str) -> None:
    curve = fragility_curve(_counts(fell))
    found = curve.capacity(0.5)
    assert (curve.state, found.text) == (state, half)
    assert np.isnan(found.estimate)
    assert curve.text
    if state is not CurveState.FITTED:
        assert curve.lognormal is None
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
    assert re.search(r"\(more than \d\.\d\d\)$", found.text)
    assert found.high == np.inf
    peak = fragility_curve(Trials.from_counts(PFV, [0.1, 0.2, 0.4], [5, 8, 11], [12, 12, 12])).capacity(0.5)
    assert peak.low == 0.0
    assert "(at most " in peak.text
    assert "cm/s" in peak.text
    few = fragility_curve(Trials.from_counts(PFV, [0.1, 0.2, 0.4], [3, 3, 4], [7, 7, 7])).capacity(0.5)
    assert few.texts == (
        f"{PFV.text(few.estimate)} (interval wider than what was run)",
        f"{PFV.text(few.estimate)}（区間は計算した範囲より広い）",
    )


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
                inside = im[0] * (1.0 - 1e-12) <= found.estimate <= im[-1] * (1.0 + 1e-12)
                assert np.isnan(found.estimate) or inside
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
    assert curve.state is CurveState.FITTED
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
        (lambda: Trials.from_counts(PGA, [1.0], [1, 1], [2, 2]), "must be 1 numbers"),
        (lambda: fragility_curve(_counts([1, 2, 4, 9])).capacity(0.0), "0"),
    ],
)
def test_refused(call: object, part: str) -> None:
    with pytest.raises(InputError, match=part):
        call()  # type: ignore[operator]


def test_results_are_said_in_both_languages() -> None:
    curve = fragility_curve(Trials.from_counts(PGA, [2.0, 4.0, 8.0], [4, 19, 36], [40, 40, 40]))
    assert curve.text == "Half fall at PGA 4.17 m/s² (3.22 to 5.23), 10 % at 2 m/s² (at most 2.59)."
    assert curve.texts[1].startswith("半数が転倒する地面の最大加速度は4.17 m/s²（3.22～5.23）")
    assert curve.lognormal is not None
    assert curve.lognormal.texts[1].startswith("対数正規分布の曲線が合います：中央値 4.07 m/s²")
    none = fragility_curve(Trials.from_counts(PGA, [2.0, 4.0], [0, 0], [40, 40]))
    assert none.capacity(0.5).texts == ("> 4 m/s²", "4 m/s²超")
    assert none.texts[1] == "地面の最大加速度4 m/s²まで、80件の計算はどれも転倒しませんでした。"
