"""Runs that are not made at weak levels: the rule, what it counts, and the same verdict without it."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import stayput as sp
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME, RESULT, ROCKED
from stayput.mechanics.devices.columns import DEVICE
from stayput.mechanics.runner import no_elements
from stayput.model.flat_fields import case_columns
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.state import State
from stayput.montecarlo import runs as module
from stayput.montecarlo.hazard import FloorMotions
from stayput.montecarlo.runs import (
    CALM_SLIDE,
    CALM_TILT,
    GROUP,
    calm_runs,
    group_starts,
    overturning_tilts,
    run_levels,
)
from stayput.montecarlo.sampling import Rows
from stayput.report.verdict.data import verdict_data
from stayput.scenario import Scenario
from stayput.verification import verify

BODY = sp.Body(0.4, 1.6, 100.0)
LEVELS = np.linspace(5.0, 6.2, 9)  # 0.15 apart


def rows(motions, samples):
    case = case_columns(BODY, sp.Room(), State(), STANDARD_GRAVITY)
    count = motions * samples
    return Rows(np.repeat(case, count), no_elements(0, count), np.full(count, 100.0))


@pytest.fixture
def world(monkeypatch):
    """Runs made by hand: `tilt(level, case)` over the overturning one, 1 and more of which is a fall."""
    made = []

    def answered(tilt):
        def run_columns(cases, elements, motions, motion, *, threads, on_progress):
            results = np.zeros(len(cases), RESULT)
            share = tilt(cases["scale"], cases["slide_rate"])
            results["outcome"] = np.where(share >= 1.0, OVERTURNED_OUTCOME, ROCKED)
            results["peak_tilt"] = share * np.arctan(0.4 / 1.6)
            made.append(len(cases))
            if on_progress is not None:
                on_progress(len(cases))
            return results, np.zeros(elements.shape, DEVICE)

        monkeypatch.setattr(module, "run_columns", run_columns)
        return made

    return answered


def floors(motions):
    """Floors whose scale is the level itself."""
    return lambda level: FloorMotions((None,) * motions, np.full(motions, level), {})


def numbered(motions, samples):
    """Rows whose number stands in a field that the answers read."""
    found = rows(motions, samples)
    found.cases["slide_rate"] = np.arange(len(found.cases))
    return found


def test_a_group_has_enough_runs():
    assert group_starts(5, 16).tolist() == [0, 1, 2, 3, 4]
    assert group_starts(7, 4).tolist() == [0, 2, 4]  # the last has three motions
    assert group_starts(20, 1).tolist() == [0, GROUP]
    assert group_starts(1, GROUP).tolist() == [0]
    assert group_starts(3, 2).tolist() == []


def test_a_calm_run_is_far_from_a_fall():
    case = case_columns(BODY, sp.Room(), State(), STANDARD_GRAVITY)
    assert overturning_tilts(case) == pytest.approx(np.arctan(0.4 / 1.6))
    results = np.zeros(7, RESULT)
    results["outcome"] = [ROCKED] * 5 + [OVERTURNED_OUTCOME, FAILED_OUTCOME]
    alpha, width = np.arctan(0.25), 0.4
    results["peak_tilt"][:3] = [0.99 * CALM_TILT * alpha, 1.01 * CALM_TILT * alpha, 0.0]
    results["peak_slide"][2:4] = [1.01 * CALM_SLIDE * width, 0.99 * CALM_SLIDE * width]
    used = np.array([0.89, 0.0, 0.0, 0.0, 0.91, 0.0, 0.0])
    assert calm_runs(np.repeat(case, 7), results, used).tolist() == [True, *(False,) * 2, True, *(False,) * 3]


def test_the_overturning_tilt_is_that_of_the_nearer_corner():
    leaning = case_columns(
        sp.Body(0.4, 1.6, 100.0, cg_offset=(0.1, 0.0)), sp.Room(), State(), STANDARD_GRAVITY
    )
    assert overturning_tilts(leaning) == pytest.approx(np.arctan(0.1 / 0.8))


def test_two_calm_levels_settle_all_below(world):
    made = world(lambda level, _: np.where(level > 5.7, 2.0, 0.1))
    seen = []
    (falls,), count = run_levels([rows(2, 8)], LEVELS, floors(2), progress=seen.append)
    assert falls.overturned.shape == (9, 2, 8)
    assert falls.overturned.all(axis=(1, 2)).tolist() == (LEVELS > 5.7).tolist()
    assert not falls.missing.any()
    # four levels at which all fall, and two calm ones
    assert (len(made), count) == (6, 6 * 16)
    assert sum(seen) == 9 * 16


def test_one_calm_level_between_falls_settles_nothing(world):
    world(lambda level, _: np.where(np.isclose(level, 5.6), 0.1, 2.0))
    (falls,), count = run_levels([rows(2, 8)], LEVELS, floors(2))
    assert count == 9 * 16
    assert falls.overturned.all(axis=(1, 2)).sum() == 8


def test_one_run_of_a_group_that_is_not_calm_keeps_all_of_it_going(world):
    world(lambda _, number: np.where(number == 9, 0.5, 0.1))
    for motions, samples, going in ((2, 8, 1), (4, 4, 2), (1, 16, 1)):
        (falls,), count = run_levels([numbered(motions, samples)], LEVELS, floors(motions))
        assert count == 2 * 16 + 7 * going * samples
        assert not falls.overturned.any()


def test_levels_that_are_too_near_are_not_two(world):
    world(lambda level, _: np.full(level.shape, 0.1))
    near = np.linspace(5.0, 6.2, 25)  # 0.05 apart
    _, count = run_levels([rows(1, 8)], near, floors(1))
    assert count == 4 * 8


def test_all_runs_are_made_where_it_is_asked_or_there_are_few(world):
    made = world(lambda level, _: np.full(level.shape, 0.1))
    assert run_levels([rows(2, 8)], LEVELS, floors(2), every_run=True)[1] == 9 * 16
    assert run_levels([rows(1, GROUP - 1)], LEVELS, floors(1))[1] == 9 * (GROUP - 1)
    assert len(made) == 18


@given(strength=st.lists(st.floats(4.5, 7.0), min_size=24, max_size=24), width=st.floats(0.02, 1.0))
def test_where_falls_rise_with_the_level_nothing_changes(strength, width):
    """Property: pieces that tilt the more the stronger it shakes have the same falls as with every run."""
    limits = np.array(strength)
    with pytest.MonkeyPatch.context() as patch:

        def run_columns(cases, elements, motions, motion, **_):
            results = np.zeros(len(cases), RESULT)
            share = np.exp((cases["scale"] - limits[cases["slide_rate"].astype(int)]) / width)
            results["outcome"] = np.where(share >= 1.0, OVERTURNED_OUTCOME, ROCKED)
            results["peak_tilt"] = share * np.arctan(0.25)
            return results, np.zeros(elements.shape, DEVICE)

        patch.setattr(module, "run_columns", run_columns)
        (few,), made = run_levels([numbered(6, 4)], LEVELS, floors(6))
        (every,), all_made = run_levels([numbered(6, 4)], LEVELS, floors(6), every_run=True)
    assert np.array_equal(few.overturned, every.overturned)
    assert made <= all_made == 9 * 24


ROOM = {"floor": "wood flooring", "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}}
FREE = {"floor": {"static_friction": 0.25, "kinetic_friction": 0.2}, "right_wall": {"gap": 0.3}}
SCENARIOS = {
    "a bookcase with all usual measures": {
        "dimensions": 2,
        "shaking": {"intensity": "6-upper", "suite": {"count": 4, "seed": 3}},
        "uncertainty": {"samples": 16},
    },
    "a slippery floor between walls": {
        "dimensions": 2,
        "furniture": {"preset": "cupboard"},
        "room": {**FREE, "left_wall": {"gap": 0.1}},
        "shaking": {"intensity": 5.5, "suite": {"family": "near-fault", "count": 6}},
        "uncertainty": {"samples": 48, "seed": 5},
    },
    "devices that fail, upstairs in a building that yields": {
        "dimensions": 2,
        "shaking": {
            "intensity": 5.8,
            "suite": {"family": "crustal", "count": 4},
            "building": {"storeys": 5},
            "storey": 4,
        },
        "measures": [
            {"type": "l_bracket_board"},
            {"type": "belt", "strength": 300.0},
            {"type": "tension_pole", "preload": 60.0},
            {"type": "gel_mats", "realism": 0.4},
        ],
        "uncertainty": {"samples": 32, "seed": 7},
    },
    "one motion, an elastic building, in space": {
        "furniture": {"preset": "television"},
        "measures": [{"type": "felt_glides"}],
        "shaking": {
            "builtin": "near-fault",
            "building": {"storeys": 3, "structure": "wood", "nonlinear": False},
            "storey": 2,
        },
        "uncertainty": {"samples": 16},
    },
    "fewer samples than a group has runs": {
        "dimensions": 2,
        "furniture": {"preset": "refrigerator"},
        "shaking": {"intensity": 6.0, "suite": {"family": "crustal", "count": 12}},
        "uncertainty": {"samples": 12},
    },
}


@pytest.mark.parametrize("name", SCENARIOS)
def test_the_verdict_is_that_of_every_run(name):
    scenario = Scenario.parse({"furniture": {"preset": "bookcase"}, "room": ROOM} | SCENARIOS[name])
    seen = []
    usual = verify(scenario, on_progress=lambda done, total: seen.append((done, total)))
    every = verify(scenario, every_run=True)
    told, whole = verdict_data(usual), verdict_data(every)
    assert (told.pop("runs") + told.pop("settled_runs"), 0) == (whole.pop("runs"), whole.pop("settled_runs"))
    assert usual.settled > 0
    told.pop("seconds"), whole.pop("seconds")
    assert told == whole
    assert seen[-1] == (every.runs, every.runs)
    assert [done for done, _ in seen] == sorted(done for done, _ in seen)
    for one, other in zip(usual.options, every.options, strict=True):
        for measure, curve in one.curves.items():
            assert np.array_equal(curve.trials.fell, other.curves[measure].trials.fell)


def test_the_bar_ends_where_few_samples_are_enough():
    scenario = Scenario.parse(
        {
            "furniture": {"preset": "chest"},
            "shaking": {"intensity": 5.0, "suite": {"count": 2}},
            "uncertainty": {"samples": 40, "precision": 0.49},
            "measures": [{"type": "felt_glides"}],
        }
    )
    seen = []
    verdict = verify(scenario, levels=[5.0, 5.5], on_progress=lambda done, total: seen.append((done, total)))
    assert verdict.samples < 20
    assert verdict.runs + verdict.settled == 2 * 2 * verdict.samples * 3
    assert seen[-1] == (240, 240)
