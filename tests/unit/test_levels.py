"""Runs at other levels that are not made: what the rule counts, and that the curves hardly move by it."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import stayput as sp
from stayput.mechanics.columns import OVERTURNED_OUTCOME, RESULT, ROCKED
from stayput.mechanics.devices.columns import DEVICE
from stayput.mechanics.runner import no_elements
from stayput.model.flat_fields import case_columns
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.state import State
from stayput.montecarlo import runs as module
from stayput.montecarlo.counting import Outcomes
from stayput.montecarlo.runs import run_levels, settled_levels
from stayput.montecarlo.sampling import Rows
from stayput.montecarlo.scaled_motions import FloorMotions
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


def test_bisection_finds_where_each_draw_begins_to_fall(world):
    made = world(lambda level, number: np.where(level > 5.0 + 0.1 * number, 2.0, 0.1))
    seen = []
    (falls,), count = run_levels([numbered(2, 8)], LEVELS, floors(2), progress=seen.append)
    assert falls.overturned.shape == (9, 2, 8)
    limits = 5.0 + 0.1 * np.arange(16).reshape(2, 8)
    assert np.array_equal(falls.overturned, LEVELS[:, np.newaxis, np.newaxis] > limits)
    assert not falls.missing.any()
    assert count == sum(made) <= 16 * 4  # 2⁴ > 9 levels
    assert sum(seen) == 9 * 16


def test_what_became_of_a_draw_at_another_shaking_is_known(world):
    made = world(lambda level, _: np.where(level > 5.7, 2.0, 0.1))
    for intensity, fell in ((5.76, True), (5.74, True), (5.6, False), (6.2, True), (5.0, False)):
        made.clear()
        stated = Outcomes(*np.zeros((6, 2, 8)).astype(bool))
        stated = replace(stated, overturned=np.full((2, 8), fell))
        known = [(np.full(2, intensity), stated)]
        (falls,), count = run_levels([rows(2, 8)], LEVELS, floors(2), known=known)
        assert falls.overturned.all(axis=(1, 2)).tolist() == (LEVELS > 5.7).tolist()
        assert count == sum(made) <= (16 if intensity == 5.6 else 16 * 5)  # at the next level it falls
    # each motion has one run of each draw, at the next level
    both = [(np.array([5.61, 5.74]), replace(stated, overturned=np.array([[False] * 8, [True] * 8])))]
    assert run_levels([rows(2, 8)], LEVELS[[0, 4, 5, 8]], floors(2), known=both)[1] == 8 + 8


def test_a_run_that_is_given_up_leaves_the_levels_open_that_it_was_to_tell():
    def run(level, chosen):
        return chosen & (level > 5.5), chosen & (level < 5.3)

    (falls,), made = settled_levels((1, 1, 1), LEVELS, run)
    assert made == 2  # at 5.6 it falls; at 5.15 it is given up
    assert falls.overturned[:, 0, 0].tolist() == [False] * 4 + [True] * 5
    assert falls.missing[:, 0, 0].tolist() == [True] * 4 + [False] * 5


def test_all_runs_are_made_where_it_is_asked(world):
    made = world(lambda level, _: np.where(np.isclose(level, 5.6), 0.1, 2.0))
    (falls,), count = run_levels([rows(2, 8)], LEVELS, floors(2), every_run=True)
    assert count == sum(made) == 9 * 16
    assert falls.overturned.all(axis=(1, 2)).sum() == 8  # it stands at one level between others


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
    "one sample of each motion": {
        "dimensions": 2,
        "furniture": {"preset": "refrigerator"},
        "shaking": {"intensity": 6.0, "suite": {"family": "crustal", "count": 12}},
        "uncertainty": {"samples": 12},
    },
}


@pytest.mark.parametrize("name", SCENARIOS)
def test_the_verdict_is_that_of_every_run(name):
    """But for the curves, which stay in their intervals: rocking is not monotonic in the intensity."""
    scenario = Scenario.parse({"furniture": {"preset": "bookcase"}, "room": ROOM} | SCENARIOS[name])
    seen = []
    usual = verify(scenario, on_progress=lambda done, total: seen.append((done, total)))
    every = verify(scenario, every_run=True)
    assert usual.runs < 0.5 * every.runs == 0.5 * (usual.runs + usual.settled)
    assert every.settled == 0
    assert seen[-1] == (every.runs, every.runs)
    assert [done for done, _ in seen] == sorted(done for done, _ in seen)
    moved = []
    for one, other in zip(usual.options, every.options, strict=True):
        assert (one.option.name, one.rank) == (other.option.name, other.rank)
        assert one.probabilities == other.probabilities
        (curve, *_), (known, *_) = ([*each.curves.values()] for each in (one, other))
        for pair in zip(curve.levels, known.levels, strict=True):
            told, true = (level.probability for level in pair)
            assert told.low <= true.high
            assert true.low <= told.high
            moved.append(abs(told.estimate - true.estimate))
    assert np.mean(moved) < 0.03


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
