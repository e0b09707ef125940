"""The paper's §4.3 and Eq. 4.1 (14WCEE, 2008): the critical amplitudes of the study `critical_ratio`."""

import numpy as np
import pytest

import stayput as sp
from studies.critical_ratio import (
    EQUATION_4_1,
    Conditions,
    critical_amplitudes,
    critical_ratio,
    first_overturning,
    fitted,
    regression,
)

STEP = 0.05


def rows_of(table, **wanted):
    return table.query(" and ".join(f"{name} == {value!r}" for name, value in wanted.items()))


@pytest.fixture(scope="module")
def study():
    return critical_ratio(ratios=[0.2, 0.3, 0.4, 0.5, 0.6], frequencies=np.arange(0.5, 2.01, 0.25), step=STEP)


@pytest.fixture(scope="module")
def table(study):
    return study.data.to_dataframe()


def test_eq_4_1_within_a_tenth_on_average(table):
    main = rows_of(table, part="main")
    off = (main["first"] / main["eq_4_1"] - 1.0).abs()
    assert len(off) == 35
    assert off.notna().all()
    assert off.mean() <= 0.10
    assert off.max() <= 0.25


def test_the_regression_fits_our_values(table):
    main = rows_of(table, part="main")
    assert (main["first"] / main["fit"] - 1.0).abs().mean() < 0.06


def test_the_residuals_of_the_regression_run_in_curves(table):
    """Residuals of chance would hardly follow their neighbours along b/h: the form does not quite fit."""
    main = rows_of(table, part="main")
    off = (main["first"] / main["fit"] - 1.0).to_numpy().reshape(7, 5)
    neighbours = np.sum(off[:, 1:] * off[:, :-1]) / np.sum(off**2)
    assert neighbours > 0.3


def test_where_the_base_slides_coulombs_law_overturns_less(table):
    """μ of the base is below b/h: under Coulomb's law most bodies slide on and do not begin to rock."""
    sway = rows_of(table, part="sway")
    low = sway[sway["friction"] < sway["corner_friction"]]
    paper, coulomb = (rows_of(low, contact=law) for law in ("paper", "coulomb"))
    assert coulomb["first"].notna().sum() <= paper["first"].notna().sum()
    assert coulomb["safe_share"].mean() > 0.5 > paper["safe_share"].mean()


def test_the_summary_has_the_papers_coefficients(study):
    first = study.summary.iloc[0]
    assert first["published"] == "6.898"
    off = study.quantities["c1"].value - EQUATION_4_1[0]
    assert float(first["difference"]) == pytest.approx(off, abs=1e-3)
    assert study.quantities["never"].value == 0


def test_the_same_numbers_in_eq_4_1_as_printed():
    """b/h = (S1 + 1.6468 S2 − 0.8758)/(6.8983 exp(1.227 S2))."""
    S1, S2 = 9.0, 1.1
    ratio = (S1 + 1.6468 * S2 - 0.8758) / (6.8983 * np.exp(1.227 * S2))
    assert regression((np.array([ratio]), np.array([S2])), *EQUATION_4_1) == pytest.approx([S1])


@pytest.mark.parametrize("relative", [True, False])
def test_the_regression_recovers_known_coefficients(relative):
    ratio, frequency = (
        axis.ravel() for axis in np.meshgrid(np.linspace(0.2, 0.6, 9), np.linspace(0.5, 2, 7))
    )
    known = np.array([9.0, 0.8, 1.5, -0.7])
    exact = regression((ratio, frequency), *known)
    coefficients, half_widths = fitted(ratio, frequency, exact, relative=relative)
    assert coefficients == pytest.approx(known, rel=1e-6)
    assert half_widths == pytest.approx(0.0, abs=1e-5)


def test_the_confidence_intervals_hold_as_often_as_they_say():
    """95 % of 400 noisy samples, within three standard deviations of that count, for each coefficient."""
    ratio, frequency = (
        axis.ravel() for axis in np.meshgrid(np.linspace(0.2, 0.6, 5), np.linspace(0.5, 2, 5))
    )
    known = np.array([7.0, 1.2, -1.6, 0.9])
    exact = regression((ratio, frequency), *known)
    rng = np.random.default_rng(1)
    inside = np.zeros(4)
    for _ in range(400):
        noisy = exact + rng.normal(0.0, 0.3, exact.size)
        coefficients, half_widths = fitted(ratio, frequency, noisy, relative=False)
        inside += np.abs(coefficients - known) <= half_widths
    assert inside / 400 == pytest.approx(0.95, abs=3.0 * np.sqrt(0.95 * 0.05 / 400))


def test_sizes_collapse_at_the_same_frequency_over_p(table):
    sizes = rows_of(table, part="size")
    assert sizes["height"].nunique() == 3
    per_curve = sizes.assign(at=sizes["omega_over_p"].round(9)).groupby(["ratio", "at"])["scaled"]
    assert (per_curve.count() == 3).all()
    assert (per_curve.max() / per_curve.min() - 1.0).max() < 1e-3


def test_a_larger_body_needs_more_at_one_frequency():
    found = critical_amplitudes([Conditions(height=h, ratio=0.4) for h in (0.7, 1.4, 2.8)], STEP)
    assert (np.diff(found["first"]) > 1.0).all()


def test_the_edge_is_the_first_amplitude_that_turns_it_over():
    """`mechanics` no. 5: one full sine, 0.4 × 1.8 m: over from 0.45479 g, safe from 1.29455 to 1.36757 g."""
    g = 9.81
    case = sp.Case(
        sp.Body(0.4, 1.8, 100.0), sp.Room(sp.Floor(3.0, 3.0)), sp.sine(g, 2.0, 0.5, quiet=10.0), gravity=g
    )
    scales = np.linspace(0.2, 1.5, 66)
    edges = first_overturning(case, {"body.mass": [100.0]}, scales[None, :])
    assert edges["first"] == pytest.approx([0.45479], rel=0.005)
    assert 1.29 < edges["last_safe"][0] < 1.37
    above = scales > 0.45479
    island = (scales > 1.29455) & (scales < 1.36757)
    assert edges["safe_share"][0] == pytest.approx(island.sum() / above.sum(), abs=1e-9)


@pytest.mark.parametrize("number", [0, 7, 20])
def test_single_runs_flip_at_the_edge(table, number):
    """It may flip back just above: edges of rocking can be ragged at every scale."""
    row = rows_of(table, part="main").iloc[number]
    body = sp.Body(row["ratio"] * 1.4, 1.4, 100.0)
    room = sp.Room(sp.Floor(3.0, 3.0, restitution=0.3))
    wave = sp.sine(1.0, row["frequency"], 10.0, np.pi / 2, dt=0.01 / row["frequency"])

    def over(factors):
        waves = [wave.scaled(row["first"] * factor) for factor in factors]
        return [sp.simulate(body, room, scaled, contact="paper").overturned for scaled in waves]

    assert not any(over(1.0 - np.linspace(2e-5, 1e-4, 9)))
    assert any(over(1.0 + np.linspace(0.0, 2e-5, 21)))


def test_a_body_that_never_turns_over_has_no_edge():
    found = critical_amplitudes([Conditions(ratio=0.4, friction=0.1, corner_friction=0.1)], 0.5)
    assert found["first"].isna().all()
    assert found["safe_share"].isna().all()
    assert found["last_safe"].iloc[0] == pytest.approx(14.0 * 0.4 * 9.80665)


def test_both_laws_agree_where_nothing_slips(table):
    sway = rows_of(table, part="sway", friction=3.0).set_index(["contact", "frequency"])["first"]
    assert sway["coulomb"].to_numpy() == pytest.approx(sway["paper"].to_numpy(), rel=0.02)
