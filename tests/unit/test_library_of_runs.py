"""Tests of the library of runs: what a kind of piece does serves all its copies, wherever they stand."""

from __future__ import annotations

from copy import deepcopy
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import stayput as sp
from stayput.measures import LBracket
from stayput.mechanics.columns import FAILED_OUTCOME
from stayput.montecarlo.library import standings_of
from stayput.montecarlo.scene_draws import SceneDraws
from stayput.scenario import Scenario
from stayput.simulation.groups import groups_of_falls
from stayput.simulation.outcome import OUTCOMES
from stayput.verification.option_runner import OptionRunner, drawn_run

if TYPE_CHECKING:
    from stayput.montecarlo.runs import Runs

SHELF = {"width": 0.3, "height": 1.8, "mass": 60.0, "length": 0.9}

ROOM: dict[str, Any] = {
    "plan": {"width": 6.0, "length": 5.0},
    "furniture": [
        {"name": "west", **SHELF, "against": "left_wall", "along": 2.5},
        {"name": "south", **SHELF, "against": "near_side_wall", "along": 3.0},
        {"name": "east", **SHELF, "against": "right_wall", "along": 2.5},
        {"name": "north", **SHELF, "against": "far_side_wall", "along": 3.0},
    ],
    "places": [{"kind": "desk", "at": [1.4, 2.5]}],
    "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 8}},
    "uncertainty": {"samples": 16},
}


SIDE_BY_SIDE: dict[str, Any] = {
    **ROOM,
    "furniture": [
        {"name": f"shelf {number}", **SHELF, "against": "left_wall", "along": 0.9 + 1.0 * number}
        for number in range(4)
    ],
}


def ran(table: dict[str, Any], runs: int = 16) -> Runs:
    runner = OptionRunner(Scenario.parse(table), 0.1, 1)
    (made,) = runner.run([runner.scenario.stated], runner.members.chosen(slice(runs)), keep=True)
    return made


def made_runs(table: dict[str, Any], runs: int = 16) -> int:
    counts: list[int] = []
    runner = OptionRunner(Scenario.parse(table), 0.1, 1, advance=counts.append)
    runner.run([runner.scenario.stated], runner.members.chosen(slice(runs)))
    return sum(counts)


def test_copies_that_face_the_same_way_take_the_runs_of_one() -> None:
    assert made_runs(SIDE_BY_SIDE, 8) == 8
    assert made_runs(ROOM, 8) == 32  # they meet a motion from four directions


def test_copies_read_the_same_number() -> None:
    verdict = sp.verify(Scenario.parse(ROOM), changes=False, progress=False)
    first, *others = verdict.without.pieces
    assert first.probabilities["overturned"].runs == 4 * verdict.without.runs
    for other in others:
        assert other.probabilities == first.probabilities
        assert (other.slide, other.tilt) == (first.slide, first.tilt)
    assert any("are of one kind" in note for note in verdict.notes())


def test_a_motion_from_a_quarter_turn_on_turns_the_run() -> None:
    table = {**ROOM, "direction": 0.3}
    west = ran(table, 8).tracks[:, 0]
    south = ran({**table, "direction": 0.3 + 0.5 * np.pi}, 8).tracks[:, 1]
    for run, turned_run in zip(west, south, strict=True):
        moved, turned = (track.place - track.place[0] for track in (run, turned_run))
        if len(moved) == len(turned):  # rounding of the direction is enlarged by impacts
            assert np.allclose(
                turned[:50], np.column_stack((-moved[:, 1], moved[:, 0], moved[:, 2]))[:50], atol=1e-6
            )


def test_a_name_changes_nothing_and_a_further_piece_no_other() -> None:
    first = ran(ROOM, 8)
    renamed = deepcopy(ROOM)
    renamed["furniture"][0]["name"] = "my own"
    assert (ran(renamed, 8).results == first.results).all()
    further = deepcopy(ROOM)
    chest = {"name": "chest", "width": 0.45, "height": 0.9, "mass": 50.0, "length": 0.8}
    further["furniture"].append({**chest, "against": "left_wall", "along": 0.5})
    assert (ran(further, 8).results[:, :4] == first.results).all()


def test_a_far_wall_counts_where_a_piece_reaches_it() -> None:
    # 2 m from the wall opposite a shelf of 1.8 m stands free of it, unless it slides: then it runs with it
    corridor = deepcopy(ROOM)
    corridor["plan"] = {"width": 2.3, "length": 5.0}
    corridor["furniture"] = corridor["furniture"][:1]
    del corridor["places"]
    scene = Scenario.parse(corridor).scene()
    (standing,) = standings_of(scene, SceneDraws(Scenario.parse(corridor), 1))
    assert standing.kind.scene.room.right_wall is None
    assert standing.walled.scene.room.right_wall is not None
    corners = [track.span[1, 0] for track in ran(corridor).tracks[:, 0]]
    assert max(corners) <= 2.3 + 1e-3


def test_pieces_in_rows_run_together_and_others_do_not() -> None:
    def groups(*stand: tuple[float, float, float]) -> list[tuple[int, ...]]:
        body = sp.Body(**SHELF)
        pieces = [sp.Piece(body, (x, y, 0.0), heading) for x, y, heading in stand]
        return groups_of_falls(sp.Scene(pieces))

    assert groups((0.0, 0.0, 0.0), (1.2, 0.0, 0.0)) == [(0, 1)]  # an aisle of 0.9 m
    assert groups((0.0, 0.0, 0.0), (2.5, 0.0, 0.0)) == [(0,), (1,)]
    assert groups((0.0, 0.0, 0.0), (0.0, 1.0, 0.0)) == [(0,), (1,)]  # side by side
    assert groups((0.0, 0.0, 0.0), (1.2, 0.0, np.pi / 2.0)) == [(0,), (1,)]  # it strikes the narrow side
    assert groups((0.0, 0.0, 0.0), (1.2, 0.0, 0.0), (2.4, 0.0, np.pi)) == [(0, 1, 2)]


def test_measures_run_by_kind() -> None:
    counts: list[int] = []
    runner = OptionRunner(Scenario.parse(SIDE_BY_SIDE), 0.1, 1, advance=counts.append)
    base, members = runner.scenario.stated, runner.members.chosen(slice(8))
    on = [tuple((LBracket(),) if piece == held else () for piece in range(4)) for held in range(4)]
    options = [type(base)(f"on {held}", measures) for held, measures in enumerate(on)]
    each = runner.run([base, *options], members)
    assert sum(counts) == 16  # those without and with brackets
    for piece, runs in enumerate(each[1:]):
        assert (runs.results[:, piece] != each[0].results[:, piece]).any()


def test_a_run_made_again_is_the_one_that_was_counted() -> None:
    runs, scenario = ran(ROOM), Scenario.parse(ROOM)
    for run in (0, 5, 15):
        again = drawn_run(scenario, scenario.stated, runs.members[run])
        for piece, result in zip(again.pieces, runs.results[run], strict=True):
            assert result["outcome"] != FAILED_OUTCOME
            assert piece.outcome == OUTCOMES[result["outcome"]]
            assert piece.peak_slide == pytest.approx(result["peak_slide"], abs=1e-9)


def anchor(strength: float) -> sp.Measure:
    """A bracket of one's own, whose class says nothing of its strength."""

    @dataclass(frozen=True)
    class Anchor(LBracket):
        def elements(self, *around: Any) -> Any:
            return LBracket(strength=strength).elements(*around)

        def __repr__(self) -> str:
            return "Anchor()"

    return Anchor()


class Rope(sp.Measure):
    """A measure of one's own that is no dataclass, so that all compare equal."""

    kind, label, about = "rope", ("Rope", "ロープ"), ("a rope", "ロープ")

    def __init__(self, strength: float) -> None:
        object.__setattr__(self, "strength", strength)

    def apply(self, body: sp.Body, room: sp.Room) -> Any:
        raise NotImplementedError


@pytest.mark.parametrize("of", [anchor, Rope])
def test_measures_of_ones_own_that_say_the_same_are_other_kinds(of: Any) -> None:
    scene = [sp.Scene([sp.Piece(sp.Body(**SHELF), measures=[of(force)])]) for force in (50.0, 5000.0)]
    draws = SceneDraws(Scenario.parse(ROOM), 1)
    weak, strong = (standings_of(each, draws)[0].kind.key for each in scene)
    assert weak != strong
    assert weak == standings_of(scene[0], draws)[0].kind.key
