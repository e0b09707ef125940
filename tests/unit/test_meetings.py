"""Pieces that strike each other: told of the room as it is, and of what the best change brings about."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import stayput as sp
from stayput.fragility.probabilities import probability_of_counts
from stayput.verification.meetings import Meeting, more_meetings, notes_of_rooms, with_meetings
from stayput.verification.option_runner import OptionRunner


def meeting(first: str, second: str, fell: int) -> Meeting:
    return Meeting(first, second, probability_of_counts([fell], [16]))


def verdict_of(without: list[Meeting], best: list[Meeting]) -> Any:
    return SimpleNamespace(
        without=SimpleNamespace(meetings=without),
        helping=SimpleNamespace(meetings=best),
        label=lambda _option, language: {"en": "Move the shelf", "ja": "棚を移動"}[language],
        kinds=(0, 1),
    )


def test_what_the_best_change_brings_about_is_told() -> None:
    verdict = verdict_of(
        [meeting("shelf", "bed", 3)], [meeting("shelf", "crate", 13), meeting("shelf", "bed", 2)]
    )
    assert [each[:2] for each in more_meetings(verdict.helping, verdict.without)] == [("shelf", "crate")]
    as_it_is, then = (english for english, _ in notes_of_rooms(verdict))
    assert as_it_is.startswith("In 3 of 16 runs")
    assert then.startswith("Move the shelf: then “shelf” and “crate” strike each other in 13 of 16 runs.")


def test_a_piece_that_is_moved_falls_onto_another() -> None:
    room = {
        "plan": {"width": 3.6, "length": 2.7},
        "furniture": [
            {"name": "bookcase", "preset": "bookcase", "against": "left_wall", "along": 1.9},
            {"name": "chest", "preset": "chest", "against": "near_side_wall", "along": 1.6},
        ],
        "places": [{"kind": "bed", "at": [1.4, 1.9], "heading": 1.5708}],
        "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 8}},
        "uncertainty": {"samples": 8},
    }
    verdict = sp.verify(sp.Scenario.parse(room), progress=False)
    moved = next(option for option in verdict if option.option.moved)
    runner = OptionRunner(verdict.scenario, verdict.slide_limit, 1)
    (falls_on_it,) = with_meetings(runner, moved).meetings
    assert falls_on_it[:2] == ("bookcase", "chest")
    assert falls_on_it.chance.fell >= 4
    assert verdict.without.meetings == ()
