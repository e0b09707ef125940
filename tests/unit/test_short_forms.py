"""What Python shows of a value: short, and of its key numbers; never its arrays."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from few_runs import copy_examples

import stayput as sp
from stayput.fragility.intensity_measures import PGA
from stayput.measures import LBracket

BODY = sp.Body(0.3, 1.8, 90.0)
ROOM = sp.Room(sp.Floor.of("carpet"), left_wall=sp.Wall(0.02))
SHAKING: dict[str, Any] = {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 4}}


@pytest.fixture(scope="module")
def run() -> sp.Run:
    return sp.simulate(BODY, ROOM, sp.near_fault())


@pytest.fixture(scope="module")
def verdict() -> sp.Verdict:
    return sp.verify(BODY, ROOM, shaking=SHAKING, measures=[LBracket()], samples=8, levels=[], progress=False)


@pytest.mark.parametrize("value", [BODY, ROOM, ROOM.floor, ROOM.left_wall, sp.State(tilt=0.1), sp.Room()])
def test_what_is_set_is_shown_as_python_makes_it(value: Any):
    names = {name: getattr(sp, name) for name in ("Body", "Room", "Floor", "Wall", "State", "Ceiling")}
    assert eval(repr(value), names) == value
    assert "None" not in repr(value)


@pytest.mark.parametrize("pair", [(0.4, 0.3), (0.5, 0.4), (0.4, 0.2)])
def test_a_floor_shows_both_coefficients(pair: tuple[float, float]):
    assert repr(sp.Floor(*pair)) == "Floor(static_friction={}, kinetic_friction={})".format(*pair)


def test_a_run_shows_its_outcome_and_peaks(run: sp.Run):
    assert run.outcome.value in repr(run)
    assert len(repr(run)) < 300


def test_a_verdict_shows_its_ranking(verdict: sp.Verdict):
    assert verdict.best.option.name in repr(verdict)
    assert len(repr(verdict)) < 300
    assert "rank 1" in repr(verdict.best)
    assert len(repr(verdict.best)) < 200


def test_a_curve_shows_its_measure_and_capacity():
    trials = sp.Trials.from_counts(PGA, [2.0, 4.0, 8.0], [4, 19, 36], [40, 40, 40])
    shown = repr(sp.FragilityCurve("bookcase", trials))
    assert shown.startswith("FragilityCurve('bookcase', PGA")
    assert len(shown) < 200


SHORT: tuple[tuple[Any, str], ...] = (
    (sp.Building(12, "steel"), "Building(storeys=12, structure='steel')"),
    (sp.Building().model, "ShearModel('10-storey RC building', 10 masses, T1 = 0.6 s)"),
    (sp.japanese_design(), "TargetSpectrum('"),
    (sp.near_fault().spectrum(), "ResponseSpectrum(100 periods"),
    (sp.Uncertainty({"friction": sp.Lognormal(1.0, 0.3)}), "Uncertainty(friction)"),
    (sp.Trials.from_counts(PGA, [2.0, 4.0], [1, 3], [4, 4]), "Trials(PGA, 4 of 8 fell)"),
)


@pytest.mark.parametrize(("value", "shown"), SHORT, ids=lambda one: type(one).__name__)
def test_other_values_are_short_too(value: Any, shown: str):
    assert repr(value).startswith(shown)
    assert len(repr(value)) < 200


def test_results_of_several_pieces_and_of_rooms_are_short(tmp_path: Path):
    copy_examples(tmp_path)
    several = sp.verify(sp.read(tmp_path / "examples/television.toml"), progress=False)
    assert repr(several).startswith("Verdict(JMA ")
    room = sp.verify(sp.read(tmp_path / "examples/bedroom.toml"), changes=False, progress=False)
    assert repr(room).startswith("Verdict(JMA ")
    assert max(len(repr(several)), len(repr(room))) < 200
