"""Draws of uncertain quantities: their distributions, and the same bits for a seed."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import kstest, lognorm, truncnorm

from stayput import InputError
from stayput.uncertainty import USUAL, Confidence, Lognormal, Normal, Uncertainty, Uniform

SHARES = np.array([0.001, 0.025, 0.3, 0.5, 0.9, 0.999])


PINNED = {
    "a": ["0x1.0983f6f6117a3p-2", "0x1.64114289bc506p-1", "0x1.71ae362d0dc3ep-1"],
    "b": ["0x1.42b266dabbef0p-1", "0x1.cdbe9afa0c3d5p-2", "0x1.83c45ba4237f4p-1"],
}


def test_quantiles_are_scipys() -> None:
    sigma = np.sqrt(np.log(1.0 + 0.2**2))
    assert Lognormal(0.4, 0.2).quantile(SHARES) == pytest.approx(lognorm.ppf(SHARES, sigma, scale=0.4))
    cut = truncnorm.ppf(SHARES, -1.0, 2.0, loc=5.0, scale=0.5)
    assert Normal(5.0, 0.5, low=4.5, high=6.0).quantile(SHARES) == pytest.approx(cut)
    assert Uniform(0.9, 1.0).quantile(SHARES) == pytest.approx(0.9 + 0.1 * SHARES)
    logs = truncnorm.ppf(SHARES, np.log(0.8) / sigma, np.inf, scale=sigma)
    assert Lognormal(1.0, 0.2, low=0.8).quantile(SHARES) == pytest.approx(np.exp(logs))


def test_coefficient_of_variation_is_met() -> None:
    drawn = Uncertainty({"x": Lognormal(2.0, 0.3)}).sample(2**18, 1)["x"]
    assert drawn.std() / drawn.mean() == pytest.approx(0.3, rel=0.01)
    assert np.median(drawn) == pytest.approx(2.0, rel=3e-3)


def test_draws_are_uniform_and_independent() -> None:
    drawn = Uncertainty({name: Uniform(0.0, 1.0) for name in "abc"}).sample(2000, 3, motions=5)
    columns = np.concatenate(list(drawn.values()))
    assert columns.shape == (15, 2000)
    assert min(kstest(column, "uniform").pvalue for column in columns) > 1e-3
    # quantities, motions, and one draw and the next
    apart = np.corrcoef(columns) - np.eye(15)
    assert np.abs(apart).max() < 4.0 / np.sqrt(2000)
    assert abs(np.corrcoef(columns[:, 1:].ravel(), columns[:, :-1].ravel())[0, 1]) < 4.0 / np.sqrt(30_000)


def test_same_seed_same_bits_whatever_else_is_drawn() -> None:
    known = Uncertainty(USUAL)
    few = known.sample(8, 11, motions=3)
    more = known.sample(50, 11, motions=40)
    longer = Uncertainty({"another": Uniform(0.0, 1.0), **USUAL}).sample(8, 11, motions=3)
    for name, values in few.items():
        assert (more[name][:3, :8] == values).all()
        assert (longer[name] == values).all()
        assert (known.sample(5, 11, motions=3, start=3)[name] == values[:, 3:]).all()
        assert (known.sample(8, 11)[name] == values[0]).all()
        assert not (known.sample(8, 12)[name] == values[0]).any()


def test_bits_are_pinned() -> None:
    drawn = Uncertainty({"a": Uniform(0.0, 1.0), "b": Uniform(0.0, 1.0)}).sample(3, 1)
    assert {name: [value.hex() for value in values.tolist()] for name, values in drawn.items()} == PINNED


def test_motions_are_independent_of_each_other() -> None:
    drawn = Uncertainty({"a": Uniform(0.0, 1.0)}).sample(1, 5, motions=2000)["a"][:, 0]
    assert drawn.mean() == pytest.approx(0.5, abs=0.02)
    assert abs(np.corrcoef(drawn[:-1], drawn[1:])[0, 1]) < 0.06


def test_usual_ranges_are_tagged() -> None:
    graded = {name for name, marginal in USUAL.items() if marginal.confidence != Confidence.LOW}
    assert graded == {"landing_place"}
    drawn = Uncertainty(USUAL).sample(2**14, 1)
    assert drawn["friction"].std() == pytest.approx(0.2, rel=0.05)
    assert drawn["restitution"].min() >= 0.9
    assert Uncertainty().sample(4, 1) == {}


def test_streams_are_independent():
    known = Uncertainty({"mass": Uniform(0.0, 1.0)})
    columns = [known.sample(256, 1, motions=40, stream=name)["mass"].ravel() for name in ("", "a", "b")]
    assert np.abs(np.corrcoef(columns) - np.eye(3)).max() < 4.0 / np.sqrt(len(columns[0]))
    more = known.sample(300, 1, motions=40, stream="a")["mass"]
    assert (more[:, :256].ravel() == columns[1]).all()
    assert (known.sample(44, 1, motions=40, start=256, stream="a")["mass"] == more[:, 256:]).all()


@pytest.mark.parametrize(
    ("call", "part"),
    [
        (lambda: Lognormal(0.0, 0.2), "Median is 0"),
        (lambda: Lognormal(1.0, -0.2), "-0.2"),
        (lambda: Lognormal(1.0, 0.2, low=3.0, high=2.0), "low must be below high"),
        (lambda: Normal(np.nan, 1.0), "nan"),
        (lambda: Normal(0.0, np.inf), "inf"),
        (lambda: Uniform(1.0, 1.0), "low must be below high"),
        (lambda: Uncertainty(USUAL).sample(0, 1), "Draws"),
        (lambda: Uncertainty(USUAL).sample(4, -1), "Seed"),
        (lambda: Uncertainty(USUAL).sample(4, 1, motions=0), "Motions"),
    ],
)
def test_refused(call: object, part: str) -> None:
    with pytest.raises(InputError, match=part):
        call()  # type: ignore[operator]
