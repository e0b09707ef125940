"""Fragility curves: recovery of known ones, intervals, and runs that say little."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.special import expit, logit, ndtr

from stayput import InputError
from stayput.fragility.curve import REACH, Capacity, FragilityCurve
from stayput.fragility.fit import EFOLDS
from stayput.fragility.intensity_measures import JMA_INTENSITY, PFV, PGA
from stayput.fragility.trials import Trials

LEVELS = np.linspace(5.0, 7.0, 11)


def curve_of(trials: Trials) -> FragilityCurve:
    return FragilityCurve("bookcase", trials)


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
    im, runs = np.geomspace(0.5, 20.0, 40), np.full(40, 10**7)
    u = np.log(im / 3.0)
    curve = curve_of(Trials.from_counts(PGA, im, np.rint(runs * expit(3.5 * u)), runs))
    assert curve.fit.slope == pytest.approx(3.5, rel=1e-3)
    for share in (0.1, 0.5, 0.9):
        there = curve.capacity(share)
        assert there.estimate == pytest.approx(3.0 * np.exp(logit(share) / 3.5), rel=1e-3)
        assert there.low <= there.estimate <= there.high
    grid = curve.grid(20)
    assert curve.probability(grid) == pytest.approx(expit(3.5 * np.log(grid / 3.0)), abs=1e-3)
    # the lognormal beside it is nowhere 1 % off
    assert curve.lognormal is not None
    nearest = ndtr(np.log(grid / curve.lognormal.median) / curve.lognormal.dispersion)
    assert nearest == pytest.approx(curve.probability(grid), abs=0.01)


def test_layouts_agree() -> None:
    fallen = _runs(1)
    by_cells = curve_of(Trials.from_runs(JMA_INTENSITY, LEVELS, fallen))
    level, motion, _ = np.indices(fallen.shape)
    one_by_one = Trials.of_runs(
        JMA_INTENSITY,
        LEVELS[level].ravel(),
        fallen.ravel(),
        np.zeros(fallen.size, bool),
        motion.ravel(),
        groups=11,
    )
    by_runs = curve_of(one_by_one)
    assert by_runs.capacity(0.3).estimate == pytest.approx(by_cells.capacity(0.3).estimate, rel=1e-6)
    assert [level.probability for level in by_runs.levels] == [level.probability for level in by_cells.levels]
    counted = Trials.from_counts(JMA_INTENSITY, LEVELS, fallen.sum(axis=(1, 2)), np.full(11, 640))
    # runs of a motion that are alike say less than as many that are independent
    width = [np.ptp(np.array(curve.band([6.0])), axis=0)[0] for curve in (by_cells, curve_of(counted))]
    assert width[0] > 2.5 * width[1]


def test_missing_runs_are_left_out() -> None:
    fallen = _runs(2)
    missing = np.zeros_like(fallen)
    missing[:, 30:] = True
    curve = curve_of(Trials.from_runs(JMA_INTENSITY, LEVELS, fallen, missing))
    fewer = curve_of(Trials.from_runs(JMA_INTENSITY, LEVELS, fallen[:, :30]))
    assert curve.capacity(0.1) == fewer.capacity(0.1)
    assert curve.trials.missing == missing.sum()


def test_levels_of_another_measure_are_grouped_by_the_one_asked() -> None:
    # motions of one level differ by a factor of 2 in the peak: what falls at a peak, not at a level, is shown
    fallen = _runs(3)
    factors = np.linspace(0.7, 1.4, 40)
    peaks = 10.0 ** (0.5 * (LEVELS[:, np.newaxis] - 6.0)) * factors
    curve = curve_of(Trials.from_runs(PGA, peaks, fallen))
    assert len(curve.levels) == len(LEVELS)
    assert all(a.highest <= b.lowest for a, b in pairwise(curve.levels))
    assert [level.im for level in curve.levels] == sorted(level.im for level in curve.levels)


def test_one_motion_has_the_interval_of_its_own_runs() -> None:
    fell = np.array([0, 2, 12, 20, 24, 25, 38, 40])
    fallen = np.arange(40) < fell[:, np.newaxis, np.newaxis]
    levels = np.array([5.30, 5.45, 5.61, 5.76, 5.92, 6.07, 6.22, 6.5])
    curve = curve_of(Trials.from_runs(JMA_INTENSITY, levels, fallen))
    alone = curve_of(Trials.from_counts(JMA_INTENSITY, levels, fell, np.full(8, 40)))
    assert curve.one_motion
    assert not alone.one_motion
    assert curve.fit.design_effect == 1.0
    assert curve.capacity().estimate == pytest.approx(alone.capacity().estimate, abs=0.005)
    assert 5.4 < curve.capacity(0.1).estimate < 5.65
    assert "for the one motion alone" in curve.text


def test_nothing_is_told_far_from_what_was_run() -> None:
    curve = curve_of(Trials.from_runs(JMA_INTENSITY, LEVELS, _runs(5)))
    first, last = curve.ends
    assert (first, last) == pytest.approx((5.0 - REACH / EFOLDS, 7.0 + REACH / EFOLDS))
    assert np.isnan(curve.probability([first - 0.01, last + 0.01])).all()
    assert np.isnan(np.array(curve.band([first - 0.01, last + 0.01]))).all()
    p = curve.probability(curve.grid(500))
    low, high = curve.band(curve.grid(500))
    assert (low <= p).all()
    assert (p <= high).all()
    assert (np.diff(p) >= 0.0).all()


def _counts(fell: list[int], runs: int = 100, im: tuple[float, ...] = (5.0, 5.5, 6.0, 6.5)) -> Trials:
    return Trials.from_counts(JMA_INTENSITY, np.array(im[: len(fell)]), fell, [runs] * len(fell))


@pytest.mark.parametrize(
    ("fell", "half", "tenth"),
    [
        ([0, 0, 0, 0], "> 7.22", "> 6.86 (more than 6.78)"),
        ([100, 100, 100, 100], "< 4.35", "< 3.93"),
        ([1, 2, 4, 9], "> 6.86 (more than 6.83)", "6.51 (more than 6.29)"),
        ([90, 93, 97, 99], "< 4.64 (at most 4.66)", "< 4.23"),
    ],
)
def test_in_words_where_there_is_no_number(fell: list[int], half: str, tenth: str) -> None:
    curve = curve_of(_counts(fell))
    found = curve.capacity(0.5)
    assert (found.text, curve.capacity(0.1).text) == (half, tenth)
    assert np.isnan(found.estimate)
    assert curve.lognormal is None
    assert curve.lognormal_texts == ("", "")
    assert curve.text == f"Half fall at JMA {half}, 10 % at {tenth}."


def test_a_capacity_beyond_the_curve_is_no_less_than_a_smaller_share_s() -> None:
    """The lower end for a half is less here than the intensity at which a tenth are told to fall."""
    curve = curve_of(_counts([0, 0, 0, 0], runs=12))
    half, tenth = curve.capacity(0.5), curve.capacity(0.1)
    assert half.low < tenth.estimate < half.bound == pytest.approx(curve.ends[1])
    assert half.value[0] == f"> {half.bound:.2f}"
    nothing = Capacity(JMA_INTENSITY, 0.5, np.nan, -np.inf, np.inf, 6.5)
    assert nothing.texts == nothing.value


def test_fewer_runs_say_less() -> None:
    many, few = (curve_of(_counts([0, 0, 0, 0], runs=runs)).capacity(0.5) for runs in (100, 10))
    assert 6.0 < few.low < many.low
    assert few.text.startswith("> ")


def test_a_sudden_rise_is_steep_and_between_its_levels() -> None:
    found = curve_of(_counts([0, 0, 100, 100]))
    half = found.capacity()
    assert 5.5 < half.low < half.estimate < half.high < 6.0
    assert found.fit.slope > 15.0


def test_one_level_has_the_usual_slope() -> None:
    curve = curve_of(_counts([20]))
    assert 4.5 < curve.fit.slope < 7.0
    assert curve.probability([5.0])[0] == pytest.approx(0.2, abs=0.02)
    assert np.isnan(curve.probability([5.5])[0])


def test_shares_that_do_not_rise_are_a_flat_curve() -> None:
    curve = curve_of(_counts([30, 30, 30, 30]))
    assert curve.fit.slope < 1.5
    assert curve.probability([5.0, 6.5]) == pytest.approx([0.3, 0.3], abs=0.15)


def test_open_ends_are_said() -> None:
    found = curve_of(_counts([0, 2, 3, 5], runs=12)).capacity(0.5)
    assert found.text.endswith(f"(more than {found.low:.2f})")
    assert found.high == np.inf
    peak = curve_of(Trials.from_counts(PFV, [0.1, 0.2, 0.4], [7, 8, 11], [12, 12, 12])).capacity(0.5)
    assert peak.low == 0.0
    assert "(at most " in peak.text
    assert "cm/s" in peak.text
    few = curve_of(Trials.from_counts(PFV, [0.2], [1], [2])).capacity(0.5)
    assert few.texts == (
        f"{PFV.text(few.estimate)} (interval wider than what was run)",
        f"{PFV.text(few.estimate)}（区間は計算した範囲より広い）",
    )


def test_tiny_and_lopsided_samples_never_break() -> None:
    rng = np.random.default_rng(11)
    with np.errstate(all="raise", under="ignore"):
        for _ in range(150):
            levels = int(rng.integers(1, 5))
            runs = rng.integers(1, 6, levels)
            fell = rng.binomial(runs, rng.random(levels))
            im = np.sort(rng.uniform(0.1, 10.0, levels))
            curve = curve_of(Trials.from_counts(PGA, im, fell, runs))
            for share in (0.1, 0.5):
                found = curve.capacity(share)
                beyond = np.exp(REACH) * (1.0 + 1e-12)
                inside = im[0] / beyond <= found.estimate <= im[-1] * beyond
                assert np.isnan(found.estimate) or inside
                assert found.low <= found.high
                assert found.text
            assert curve.text


def test_one_motion_that_decides_is_no_certainty() -> None:
    # each motion overturns all samples from its own level on: 40 facts, not 7040
    rng = np.random.default_rng(12)
    capacity = 6.0 + 0.4 * rng.standard_normal((40, 1)) + np.zeros((40, 16))
    many = curve_of(Trials.from_runs(JMA_INTENSITY, LEVELS, capacity <= LEVELS[:, None, None]))
    once = curve_of(Trials.from_runs(JMA_INTENSITY, LEVELS, capacity[:, :1] <= LEVELS[:, None, None]))
    widths = [curve.capacity().high - curve.capacity().low for curve in (many, once)]
    assert widths[0] == pytest.approx(widths[1], rel=0.05)


@pytest.mark.parametrize(
    ("call", "part"),
    [
        (lambda: Trials.from_runs(JMA_INTENSITY, LEVELS[:4], _runs(1)), r"\(4,\)"),
        (lambda: Trials.from_runs(PGA, -LEVELS, _runs(1)), "-5"),
        (lambda: Trials.from_runs(JMA_INTENSITY, LEVELS, _runs(1), np.ones((11, 40, 16), bool)), "given up"),
        (lambda: Trials.from_counts(PGA, [1.0, 2.0], [3, 1], [2, 2]), "3 falls of 2"),
        (lambda: Trials.from_counts(PGA, [1.0, np.nan], [1, 1], [2, 2]), "nan"),
        (lambda: Trials.from_counts(PGA, [1.0], [1, 1], [2, 2]), "must be 1 numbers"),
        (lambda: curve_of(_counts([1, 2, 4, 9])).capacity(0.0), "0"),
    ],
)
def test_refused(call: object, part: str) -> None:
    with pytest.raises(InputError, match=part):
        call()  # type: ignore[operator]


def test_results_are_said_in_both_languages() -> None:
    curve = curve_of(Trials.from_counts(PGA, [2.0, 4.0, 8.0], [4, 19, 36], [40, 40, 40]))
    assert curve.text == "Half fall at PGA 4.04 m/s² (3.46 to 4.72), 10 % at 2.06 m/s² (1.46 to 2.67)."
    assert curve.texts[1].startswith("半数が転倒する地面の最大加速度は4.04 m/s²（3.46～4.72）")
    assert curve.lognormal_texts == (
        "Nearest lognormal curve: median 4.04 m/s², dispersion 0.493.",
        "最も近い対数正規分布：中央値 4.04 m/s²、ばらつき 0.493。",
    )
    none = curve_of(Trials.from_counts(PGA, [2.0, 4.0], [0, 0], [40, 40])).capacity(0.5)
    assert none.texts == (f"> {PGA.text(none.low)}", f"{PGA.text(none.low)}超")
