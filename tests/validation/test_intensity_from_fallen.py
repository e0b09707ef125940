"""`intensity_from_fallen` where the truth is known: places shaken by a motion that the model has not."""

import math

import numpy as np
import pytest

import stayput as sp
from stayput.fallen import _kernel, estimate_from_counts
from stayput.montecarlo.runs import run_levels
from stayput.montecarlo.sampling import draws, rows_of
from stayput.montecarlo.scaled_motions import ScaledMotions

STONES = (sp.Body(0.242, 0.605, 95.0), sp.Body(0.303, 0.76, 190.0))
BASE = sp.Room(sp.Floor(0.6, 0.5))
LEVELS = np.linspace(4.5, 7.5, 31)
MOTIONS, SAMPLES = 32, 12


@pytest.fixture(scope="module")
def runs() -> np.ndarray:
    """Return falls of both stones, shape (kinds, levels, motions), of `SAMPLES` runs each."""
    suite = sp.synthetic_suite("crustal", MOTIONS)
    scaled_motions, drawn = ScaledMotions(suite), draws(MOTIONS, SAMPLES, 1)
    rows = [rows_of(stone, BASE, (), drawn, 9.80665) for stone in STONES]
    falls = run_levels(rows, LEVELS, scaled_motions.at, threads=1)
    return np.array([kind.overturned.sum(axis=2) for kind in falls], float)


def estimate(runs, fell, totals, scatter=0.2):
    return estimate_from_counts(LEVELS, runs, np.full(runs.shape, float(SAMPLES)), fell, totals, scatter)


def test_intervals_hold_the_truth(runs):
    """Each motion in turn shakes a cemetery of 40 stones; the model knows only the others.

    The intensity scatters from stone to stone by more than the model takes for granted, and by less.
    """
    rng = np.random.default_rng(1)
    for scatter, least in ((0.4, 0.9), (0.2, 0.93), (0.0, 0.85)):
        shares = _kernel(LEVELS, scatter) @ runs / SAMPLES
        held, errors = [], []
        for motion in range(MOTIONS):
            others = np.delete(runs, motion, axis=2)
            for place in (13, 15, 18, 21):
                fell = [rng.binomial(20, shares[kind, place, motion]) for kind in range(2)]
                found = estimate(others, fell, [20, 20])
                held.append(found.low <= LEVELS[place] <= found.high)
                errors.append(found.intensity - LEVELS[place])
        assert np.mean(held) > least
        assert abs(np.nanmean(errors)) < 0.15


def test_more_stones_narrow_it_down_to_what_one_motion_leaves(runs):
    few, many, most = (estimate(runs, [n // 2, n // 4], [n, n]) for n in (4, 12, 40_000))
    widths = [found.high - found.low for found in (few, many, most)]
    assert widths[0] > widths[1] > widths[2] > 0.2


def test_none_and_all(runs):
    none, every = estimate(runs, [0, 0], [20, 20]), estimate(runs, [20, 20], [20, 20])
    assert none.low == -math.inf
    assert every.high == math.inf
    assert math.isnan(none.intensity)
    assert none.high < 7.0
    assert every.low > 5.5
    assert none.log_likelihood[0] > none.log_likelihood[-1]


def test_more_that_fell_is_stronger_shaking(runs):
    found = [estimate(runs, [fell, fell // 2], [20, 20]).intensity for fell in (4, 8, 12, 16)]
    assert np.all(np.diff(found) > 0.0)


def test_scatter_from_piece_to_piece_smooths_the_shares(runs):
    sharp, smooth = (estimate(runs, [5, 5], [20, 20], scatter) for scatter in (0.0, 0.3))
    weak = np.flatnonzero(sharp.shares[0] == 0.0)[-1]
    assert smooth.shares[0, weak] > 0.0
    assert np.all(np.diff(smooth.shares, axis=1) >= -0.02)


def test_from_bodies_to_the_estimate(runs):
    suite = sp.synthetic_suite("crustal", MOTIONS)
    pieces = [sp.Fallen(stone, fell, 20, BASE) for stone, fell in zip(STONES, (9, 6), strict=True)]
    options = {"motions": suite, "samples": SAMPLES, "levels": LEVELS, "scatter": 0.2}
    found = sp.intensity_from_fallen(pieces, **options, threads=1)
    expected = estimate(runs, [9, 6], [20, 20])
    assert (found.intensity, found.low, found.high) == (expected.intensity, expected.low, expected.high)
    assert found.intensity == sp.intensity_from_fallen(pieces, **options, threads=2).intensity


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: sp.intensity_from_fallen([]), "pieces is empty"),
        (lambda: sp.Fallen(STONES[0], 5, 4), "that fell"),
        (lambda: sp.Fallen(STONES[0], 0, 0), "Number of pieces"),
        (lambda: sp.Fallen(STONES[0], 1.5, 4), "whole"),
        (lambda: sp.intensity_from_fallen([sp.Fallen(STONES[0], 1, 4)], levels=[5.0, 6.0]), "three"),
        (lambda: sp.intensity_from_fallen([sp.Fallen(STONES[0], 1, 4)], levels=[6.0, 5.0, 7.0]), "three"),
        (lambda: sp.intensity_from_fallen([sp.Fallen(STONES[0], 1, 4)], scatter=-0.1), "Scatter"),
        (lambda: sp.intensity_from_fallen([sp.Fallen(STONES[0], 1, 4)], samples=0), "Samples"),
    ],
)
def test_refusals(make, words):
    with pytest.raises(sp.InputError, match=words):
        make()
