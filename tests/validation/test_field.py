"""The field: published medians of unanchored furniture, what they rest on, and where bare furniture lies."""

import numpy as np
import pytest

import studies
from stayput import Body
from stayput.estimates import LOSS_MODEL_RATIO, kaneko_hayashi_median, kaneko_hayashi_velocity
from studies.baseline import FREE, IDEAL_BLOCK, LOSS_MODEL, WALL, field_of


@pytest.fixture(scope="module")
def study() -> studies.Study:
    return studies.baseline(4, samples=2)


@pytest.mark.parametrize("piece", LOSS_MODEL, ids=lambda piece: piece.name)
def test_fema_p58_is_a_constant_part_of_kaneko_hayashi(piece):
    """Nine velocities that are one part of another formula are a formula with a margin, no observations."""
    formula = kaneko_hayashi_velocity(Body(piece.width, piece.height, 100.0))
    assert piece.velocity / formula == pytest.approx(LOSS_MODEL_RATIO, rel=0.06)


def test_the_velocity_is_the_branch_of_the_formula_above_fb():
    frequency = 5.0
    wanted = kaneko_hayashi_median(Body(0.4, 1.8, 100.0), frequency) / (2.0 * np.pi * frequency)
    assert kaneko_hayashi_velocity(Body(0.4, 1.8, 100.0)) == pytest.approx(wanted)


def test_the_default_verdict_lies_above_the_formulas(study):
    """Free furniture as drawn: 1.0 to 1.35 times Kaneko and Hayashi; a wall behind: more than 1.6 times."""
    free, wall, ideal = (field_of(study.data, name) for name in (FREE, WALL, IDEAL_BLOCK))
    assert 1.0 < free < 1.35
    assert free < ideal
    assert wall > 1.6
    assert field_of(study.data, FREE, "loss_model") / free == pytest.approx(1.0 / LOSS_MODEL_RATIO, rel=0.05)


def test_soft_floors_lower_the_capacity_and_losses_raise_it(study):
    mean = study.data["ratio"].mean("piece")
    carpet = "a flat base on carpet, 1 mm"
    assert float(mean.sel(effect=carpet)) < 0.85
    assert float(mean.sel(effect="landings push at 1/3 of half the base")) < 0.97
    assert float(mean.sel(effect="landings of 0.9 times Housner's rate")) > 1.05
    assert float(mean.sel(effect="a wall 2 cm behind")) > 1.4


def test_shares_at_home_follow_the_words_of_jma(study):
    """5-upper: may fall; 6-lower: some; 6-upper: more; 7: nearly all move or fall, Kobe: 60 % of rooms."""
    share = study.data["share"].mean("home")
    upper5, lower6, upper6, seven = (float(share.interp(level=level)) for level in (5.25, 5.75, 6.25, 6.75))
    assert upper5 < 0.05
    assert upper5 < lower6 < 0.2
    assert 0.2 < upper6 < 0.6
    assert 0.5 < seven < 0.9


def test_shares_rise_with_the_storey_as_in_kobe(study):
    """Kobe, as reported: about 20 % on low, 40 % on middle and over 60 % on upper storeys."""
    share = study.data["storey_share"].mean("home")
    for level in (5.25, 5.75, 6.25):
        low, middle, high = share.sel(ground=level).to_numpy()
        assert low <= middle <= high
    assert float(share.sel(ground=5.75, storey=10)) > 0.3
