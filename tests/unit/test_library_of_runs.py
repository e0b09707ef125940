"""Tests of the library of runs: what a kind of piece does serves all its copies, wherever they stand."""

from __future__ import annotations

from copy import deepcopy
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import stayput as sp
from stayput.measures import LBracket
from stayput.mechanics.columns import FAILED_OUTCOME
from stayput.montecarlo.counting import MOTIONS_IN_BLOCK, QUARTERS, Members
from stayput.montecarlo.library import standings_of
from stayput.montecarlo.scene_draws import SceneDraws
from stayput.scenario import Scenario
from stayput.simulation.groups import groups_of_falls
from stayput.simulation.outcome import OUTCOMES
from stayput.verification.contest import Contest, drawn_run

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
    "shaking": {"intensity": "6-upper", "suite": {"family": "mixed", "count": 8}},
    "uncertainty": {"samples": 32},
}


def ran(table: dict[str, Any], runs: int = 32) -> Runs:
    contest = Contest(Scenario.parse(table), 0.1, 1)
    (made,) = contest.run([contest.scenario.stated], contest.members.chosen(slice(runs)), keep=True)
    return made


def made_runs(table: dict[str, Any], runs: int = 32) -> int:
    counts: list[int] = []
    contest = Contest(Scenario.parse(table), 0.1, 1, advance=counts.append)
    contest.run([contest.scenario.stated], contest.members.chosen(slice(runs)))
    return sum(counts)


def test_four_copies_at_four_walls_take_the_runs_of_one() -> None:
    # eight motions from four directions: each is met by one of the four pieces from each
    assert made_runs(ROOM) == 32


def test_copies_read_the_same_number() -> None:
    # every copy meets all motions from all directions, in another order
    runs = ran(ROOM)
    for piece in range(1, 4):
        for name in ("outcome", "peak_slide", "peak_tilt"):
            first, other = (np.sort(runs.results[name][:, column]) for column in (0, piece))
            assert np.array_equal(first, other)


def test_a_quarter_turn_of_the_room_turns_the_run() -> None:
    # what the piece at the left wall does, that at the near wall does under a quarter turn of the direction
    runs = ran(ROOM)
    members = runs.members
    for run, (motion, sample, _) in enumerate(members):
        later = np.flatnonzero((members.motion == motion) & (members.sample == (sample + 1) % QUARTERS))[0]
        west, south = runs.tracks[run, 0], runs.tracks[later, 1]
        moved, turned = (track.place - track.place[0] for track in (west, south))
        assert np.allclose(turned, np.column_stack((-moved[:, 1], moved[:, 0], moved[:, 2])), atol=1e-12)


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
    contest = Contest(Scenario.parse(ROOM), 0.1, 1, advance=counts.append)
    base, members = contest.scenario.stated, contest.members.chosen(slice(32))
    on = [tuple((LBracket(),) if piece == held else () for piece in range(4)) for held in range(4)]
    options = [type(base)(f"on {held}", measures) for held, measures in enumerate(on)]
    each = contest.run([base, *options], members)
    assert sum(counts) == 64  # those without and with brackets
    held = [np.sort(runs.results["peak_tilt"][:, piece]) for piece, runs in enumerate(each[1:])]
    assert all(np.array_equal(held[0], other) for other in held[1:])


@pytest.mark.parametrize("run", [0, 9, 18, 27])
def test_a_run_made_again_is_the_one_that_was_counted(run: int) -> None:
    runs, scenario = ran(ROOM), Scenario.parse(ROOM)
    again = drawn_run(scenario, scenario.stated, runs.members[run])
    for piece, result in zip(again.pieces, runs.results[run], strict=True):
        assert result["outcome"] != FAILED_OUTCOME
        assert piece.outcome == OUTCOMES[result["outcome"]]
        assert piece.peak_slide == pytest.approx(result["peak_slide"], abs=1e-9)


def test_members_meet_all_directions_before_other_motions() -> None:
    members = Members.in_quarters(20, 60)
    block = MOTIONS_IN_BLOCK * QUARTERS
    assert len({(motion, sample) for motion, sample, _ in members}) == 60
    assert set(members.motion[:block].tolist()) == set(range(MOTIONS_IN_BLOCK))
    assert all((members.sample[:block][members.motion[:block] == 0] == np.arange(QUARTERS)).tolist())
    assert len(np.unique(members.cluster)) == 60
