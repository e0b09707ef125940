"""Parts of a room that run one behind the other."""

from __future__ import annotations

import math

import numpy as np

import stayput as sp
from stayput.measures import LBracket
from stayput.rooms.changes import measures_tried
from stayput.rooms.runs import groups_of, part_with, runs_of_each
from stayput.rooms.verify import question_of

ROOM = sp.RoomScenario.parse(
    {
        "plan": {"width": 3.6, "length": 2.7},
        "furniture": [
            {"name": "bookcase", "preset": "bookcase", "against": "left_wall", "along": 1.9},
            {"name": "chest", "preset": "chest", "against": "near_side_wall", "along": 1.6},
        ],
        "places": [{"kind": "bed", "at": [1.4, 1.9], "heading": math.pi / 2}],
        "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 2}},
        "uncertainty": {"samples": 4},
    }
)


def test_parts_come_in_their_order_each_as_if_it_ran_alone():
    question = question_of(ROOM, 1)
    parts = [part_with(ROOM, group, question.whole) for group in groups_of(ROOM)]
    parts += [
        held
        for change, held in measures_tried(ROOM, question.whole, (0,), 0)
        if isinstance(change.measure, LBracket)
    ]
    alone = [question.run([part])[0] for part in parts]
    for threads in (1, 3):
        together = runs_of_each(parts, question.drawn, question.floors, ROOM.gravity, threads=threads)
        for one, own in zip(together, alone, strict=True):
            assert np.array_equal(one.results, own.results)
            assert one.peaks == own.peaks
            for run, track in zip(one.tracks, own.tracks, strict=True):
                assert np.array_equal(run[0].place, track[0].place)


def test_what_became_of_a_part_is_known_before_the_last_has_run():
    question, ended = question_of(ROOM, 1), 0

    def count(runs: int) -> None:
        nonlocal ended
        ended += runs

    parts = [part_with(ROOM, group, question.whole) for group in groups_of(ROOM)]
    found = question._replace(advance=count).runs_of_each(parts)
    next(found)
    assert ended < 2 * len(parts) * 2
    found.close()
