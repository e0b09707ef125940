"""Rooms: their files, what is refused, and verdicts that hang together."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import stayput as sp
from stayput.catalogue import LANGUAGES
from stayput.fragility.paired import Difference
from stayput.measures import Belt, LBracket, TensionPole
from stayput.model.floor_plan import FACING
from stayput.montecarlo.several import DrawOfSeveral, drawn_shaking
from stayput.report.room.data import room_data
from stayput.report.room.report import simulations_of_room
from stayput.rooms import runs as room_runs
from stayput.rooms.changes import (
    Change,
    measures_tried,
)
from stayput.rooms.runs import RoomPart, groups_of
from stayput.rooms.verify import question_of
from stayput.rooms.words import (
    best_sentence,
    door_name,
    label_of,
    often,
    piece_name,
    piece_within,
    place_name,
)

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.rooms.runs import Question
    from stayput.rooms.verdict import RoomVerdict

BEDROOM: dict[str, Any] = {
    "plan": {"width": 3.6, "length": 2.7},
    "furniture": [
        {"name": "bookcase", "preset": "bookcase", "against": "left_wall", "along": 1.9},
        {"name": "stool", "diameter": 0.3, "height": 0.7, "mass": 5.0, "at": [3.2, 0.3]},
    ],
    "places": [{"kind": "bed", "at": [1.4, 1.9], "heading": math.pi / 2}],
    "doors": [{"wall": "right_wall", "start": 1.2}],
    "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 3}},
    "uncertainty": {"samples": 6},
}


def changed(**tables: Any) -> sp.Scenario:
    return sp.Scenario.parse({**BEDROOM, **tables})


def piece(**keys: Any) -> list[dict[str, Any]]:
    return [{**BEDROOM["furniture"][0], **keys}]


def verified(**tables: Any) -> RoomVerdict:
    return sp.verify_room(changed(**tables), changes=False, progress=False)


@pytest.fixture(scope="module")
def verdict() -> RoomVerdict:
    return sp.verify_room(changed(), progress=False)


@pytest.mark.parametrize(
    ("wall", "facing"),
    [
        ("left_wall", (1.0, 0.0)),
        ("right_wall", (-1.0, 0.0)),
        ("near_side_wall", (0.0, 1.0)),
        ("far_side_wall", (0.0, -1.0)),
    ],
)
def test_a_piece_against_a_wall_faces_into_the_room(wall: str, facing: tuple[float, float]):
    room = changed(furniture=piece(against=wall, along=1.3, gap=0.05), places=[])
    standing = room.scene().pieces[0]
    np.testing.assert_allclose(standing.turn[:2, 0], facing, atol=1e-15)
    assert getattr(room.surroundings(), wall).gap == pytest.approx(0.05)
    along = (0.0, 1.0, 0.0) if "_side" not in wall else (1.0, 0.0, 0.0)
    assert standing.reach(along) == pytest.approx((0.9, 1.7))


@pytest.mark.parametrize(
    ("tables", "told"),
    [
        ({"furniture": piece(along=None)}, "along"),
        ({"furniture": piece(along=0.2)}, "must be between 0 and 3.6 m along x"),
        ({"furniture": [*piece(), {**piece(along=1.5)[0], "name": "other"}]}, "must stand beside it"),
        ({"places": [{"kind": "bed", "at": [1.2, 1.9], "heading": 1.5707963}]}, "into “bed”"),
        ({"places": [{"kind": "bed", "at": [3.4, 1.9]}]}, "reaches out of the room"),
        ({"places": [{"kind": "hammock", "at": [1.0, 1.0]}]}, "hammock"),
        ({"places": [{"kind": "bed", "at": [2.0, 1.9], "low": 0.8}]}, "must be more than low"),
        (
            {"places": [{"at": [1.4, 1.9]}, {"at": [2.6, 1.9]}]},
            "places[1].name is 'bed'; it must not be that of places[0]",
        ),
        ({"doors": [{"wall": "right_wall", "start": 2.2}]}, "must be at most 2.7 m"),
        ({"doors": [{"wall": "back_wall", "start": 0.2}]}, "back_wall"),
        ({"room": {"left_wall": {"gap": 0.1}}}, "left_wall"),
        ({"plan": {"width": 31.0, "length": 3.0}}, "must be a number between 0.5 and 30 m"),
        ({"room": {"ceiling": {"height": 1.5}}}, "furniture[0] (“bookcase”) is 1.8 m high"),
        ({"options": [{"name": "none of them"}]}, "options is given beside [plan]"),
    ],
)
def test_what_is_wrong_is_refused_with_the_value(tables: dict[str, Any], told: str):
    with pytest.raises(sp.InputError, match=r"must|missing|unknown|not|give") as refusal:
        sp.verify_room(changed(**tables), changes=False, progress=False)
    assert told in str(refusal.value)
    assert refusal.value.told("ja") != str(refusal.value)
    with pytest.raises(sp.InputError, match=re.escape(str(refusal.value))):
        changed(**tables).run()


def test_against_is_refused_without_a_plan():
    with pytest.raises(sp.InputError, match=r"furniture\[0\].against .* must be"):
        sp.Scenario.parse({"furniture": piece()}).scene()


def test_pieces_on_or_joined_to_each_other_run_together():
    furniture = [
        *piece(),
        {"name": "box", "width": 0.3, "length": 0.3, "height": 0.3, "mass": 5.0, "on": "bookcase"},
        {"name": "chest", "preset": "chest", "against": "near_side_wall", "along": 2.0},
    ]
    room = changed(furniture=furniture)
    assert groups_of(room) == ((0, 1), (2,))
    parts = [RoomPart.of(room.scene(), group) for group in groups_of(room)]
    assert [part.in_plane for part in parts] == [False, True]
    # what holds a piece to the wall is loaded by shaking along the wall too
    for measure, in_plane in ((Belt(), False), (LBracket(), False), (TensionPole(), True)):
        (chest,) = parts[1].scene.pieces
        held = parts[1].scene.with_piece(0, replace(chest, measures=(measure,)))
        assert parts[1]._replace(scene=held).in_plane is in_plane
    assert parts[1].scene.around.near_side_wall.gap == pytest.approx(0.02)


def test_the_verdict_hangs_together(verdict: RoomVerdict):
    (place,) = verdict.places
    assert verdict.hit == place.hit
    chances = [one.probability.estimate for one in place.by]
    assert max(chances) <= place.hit.estimate <= sum(chances)
    assert verdict.risk == pytest.approx(place.hit.estimate * 8.0 / 24.0)
    bookcase = next(one for one in verdict.pieces if one.name == "bookcase")
    assert verdict.pieces[0] is bookcase
    assert bookcase.risk == pytest.approx(chances[0] * 8.0 / 24.0)
    assert bookcase.in_plane
    for one in verdict.pieces:  # it lies where it fell, and stands where it did not
        fell = one.probabilities["overturned"].estimate
        assert one.fell.max() <= fell + 1e-12
        assert one.stood.max() <= 1.0 - fell + 1e-12
    # where it ends is in the room; a piece that overturns covers more of the floor
    assert 0.24 * 0.9 < bookcase.covers.sum() * 0.05**2 < 1.8 * 0.8 * 1.2
    assert verdict.runs > 2 * 3 * 2


def test_changes_are_compared_run_by_run(verdict: RoomVerdict):
    assert verdict.changes
    order = [(not one.helps, round(one.risk, 4)) for one in verdict.changes]
    assert order == sorted(order)
    for one in verdict.changes:
        assert one.hit_change.estimate == pytest.approx(one.hit.estimate - verdict.hit.estimate)
        assert one.helps <= (one.risk < verdict.risk or one.shut_in.estimate < verdict.shut_in.estimate)
    kinds = {(one.change.what, one.change.measure is None) for one in verdict.changes}
    assert {("bookcase", False), ("bookcase", True), ("bed", True)} <= kinds


def test_the_order_of_the_file_changes_no_number(verdict: RoomVerdict):
    turned = verified(furniture=BEDROOM["furniture"][::-1])
    assert (turned.hit, turned.shut_in, turned.risk) == (verdict.hit, verdict.shut_in, verdict.risk)
    chances = [{one.name: one.probabilities for one in each.pieces} for each in (turned, verdict)]
    assert chances[0] == chances[1]


def test_a_change_says_what_is_clearly_better_and_what_worse(verdict: RoomVerdict):
    def differing(estimate: float, low: float, high: float) -> Difference:
        return Difference(estimate, low, high, more=0, fewer=0, pairs=40, missing=0)

    fewer, more, same = differing(-0.5, -0.7, -0.2), differing(0.5, 0.2, 0.7), differing(0.0, -0.1, 0.1)
    unclear = differing(0.13, -0.05, 0.3)  # more are hit, though not clearly
    alike = dict.fromkeys(("hit_change", "shut_in_change", "blocked_change"), same)
    alike |= {"overturned_change": (same, fewer)}
    for changes, told in (
        ({}, (("overturned",), (), True)),
        ({"blocked_change": more}, (("overturned",), ("blocked",), False)),
        ({"shut_in_change": fewer, "hit_change": unclear}, (("shut_in", "overturned"), (), False)),
    ):
        change = replace(verdict.changes[0], **{**alike, **changes})
        assert (change.better, change.worse, change.helps) == told


def test_where_a_change_moves_something_it_is_as_if_it_stood_there(verdict: RoomVerdict):
    along = (one for one in verdict.changes if one.change.what == "bookcase" and one.change.heading == 0.0)
    moved = next(one for one in along if one.change.at is not None)
    there = piece(along=moved.change.at[1]) + BEDROOM["furniture"][1:]
    again = verified(furniture=there)
    # the same tracks but for rounding of the place
    assert again.hit.estimate == pytest.approx(moved.hit.estimate, abs=0.17)
    bed = next(one for one in verdict.changes if one.change.what == "bed")
    elsewhere = [{**BEDROOM["places"][0], "at": list(bed.change.at), "heading": bed.change.heading}]
    again = verified(places=elsewhere)
    assert again.hit.estimate == bed.hit.estimate


def test_the_verdict_is_told_as_it_gets_better_and_ends_the_same_for_any_number_of_threads(
    verdict: RoomVerdict, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(room_runs, "FIRST_RUNS", 3)
    told: list[RoomVerdict] = []
    last = sp.verify_room(changed(), progress=False, threads=3, on_verdict=told.append)
    first, second, *_ = told
    assert (first.samples, second.samples) == (1, 2)
    assert (first.hit.runs, last.hit.runs) == (3, 6)
    assert [len(one.changes) for one in told if one.changes] == list(range(1, len(last.changes) + 1))
    assert not any(one.complete for one in told)
    assert last.complete
    for name in ("fell", "stood"):
        for one, other in zip(last.pieces, verdict.pieces, strict=True):
            assert np.array_equal(getattr(one, name), getattr(other, name))
    assert {**room_data(last), "seconds": None} == {**room_data(verdict), "seconds": None}


def test_a_room_turned_by_180_degrees_with_its_shaking_has_the_same_verdict():
    one = verified(direction=0.5)
    other = verified(
        direction=0.5 + math.pi,
        furniture=[
            piece(against="right_wall", along=2.7 - 1.9)[0],
            {**BEDROOM["furniture"][1], "at": [3.6 - 3.2, 2.7 - 0.3], "heading": math.pi},
        ],
        places=[{"kind": "bed", "at": [3.6 - 1.4, 2.7 - 1.9], "heading": math.pi / 2}],
        doors=[{"wall": "left_wall", "start": 2.7 - 1.2 - 0.8, "width": 0.8}],
    )
    same = pytest.approx(0.0, abs=0.17)  # rounding grows in chaotic rocking: one of the six runs may differ
    assert one.hit.estimate - other.hit.estimate == same
    assert one.doors[0].blocked.estimate - other.doors[0].blocked.estimate == same
    for piece_of_one, piece_of_other in zip(one.pieces, other.pieces, strict=True):
        for key, found in piece_of_one.probabilities.items():
            assert found.estimate - piece_of_other.probabilities[key].estimate == same


def test_nobody_is_hit_by_what_is_fixed_well():
    brackets = [{"type": "l_bracket", "strength": 1e5}]
    safe = verified(furniture=piece(measures=brackets) + BEDROOM["furniture"][1:])
    assert safe.hit.estimate == 0.0
    assert "in none of the" in safe.sentence()
    assert "95 % interval: 0 to" in safe.sentence()


def test_a_room_without_doors_and_places_is_verified_in_several_blocks():
    shaking = {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 2}}
    empty = sp.verify_room(
        changed(doors=[], places=[], shaking=shaking, uncertainty={"samples": 24}), progress=False
    )
    assert (empty.motions, empty.samples, empty.complete) == (2, 12, True)
    assert empty.places == empty.doors == ()
    assert empty.hit.estimate == empty.risk == 0.0
    assert all("overturned" in one.better or not one.helps for one in empty.changes)
    assert all(map(empty.sentence, LANGUAGES))


def test_nobody_is_shut_in_where_there_is_no_way_out():
    closed = verified(doors=[{"wall": "right_wall", "start": 1.2, "way_out": False}])
    assert closed.shut_in.estimate == 0.0


def test_a_held_piece_with_its_back_on_a_wall_meets_floors_that_lean_either_way():
    held = piece(gap=0.0, measures=[{"type": "l_bracket"}])
    verdict = verified(furniture=held, uncertainty={"samples": 24})
    assert not verdict.pieces[0].in_plane
    assert verdict.hit.runs == 24


def test_a_room_is_simulated_with_all_its_pieces_together():
    run = changed().run()
    assert len(run.pieces) == 2
    with pytest.raises(sp.InputError, match="must go to verify_room"):
        sp.verify(changed())


def test_a_room_is_simulated_under_a_motion_of_its_direction():
    plain, pointing = changed().motion(), changed(direction=0.7).motion()
    shaking = drawn_shaking(plain, 1.0, DrawOfSeveral((), 1.0, 1.0, direction=0.7), 9.8)
    assert plain.y is not None
    assert np.allclose(pointing.x, shaking.acceleration[:, 0])
    assert np.allclose(pointing.y, shaking.acceleration[:, 1])


@pytest.mark.parametrize(
    ("openings", "kinds"),
    [
        ({"windows": []}, {"l_bracket", "belt"}),
        ({"windows": [{"wall": "left_wall", "start": 1.6, "width": 0.8}]}, set()),
        # the brackets are at 1.6725 and 2.1275 m: past the frame of one window, and above the other's sill
        ({"windows": [{"wall": "left_wall", "start": 0.5, "width": 1.12}]}, {"l_bracket", "belt"}),
        ({"windows": [{"wall": "left_wall", "start": 0.5, "width": 1.13}]}, set()),
        ({"windows": [{"wall": "left_wall", "start": 1.6, "width": 0.8, "sill": 1.9}]}, {"l_bracket"}),
        ({"windows": [{"wall": "far_side_wall", "start": 0.0, "width": 3.0}]}, {"l_bracket", "belt"}),
        ({"furniture": piece(gap=0.3)}, set()),
    ],
)
def test_nothing_is_screwed_to_a_window_or_a_wall_too_far_away(openings: dict[str, Any], kinds: set[str]):
    room = changed(places=[], **openings)
    tried = measures_tried(room, room.scene(), 0)
    assert {"l_bracket", "belt"} & {one.measure.kind for one, _ in tried if one.measure} == kinds


def test_a_verdict_of_one_motion_says_so():
    few = {"furniture": piece(), "uncertainty": {"samples": 4}}
    alone, quiet = (
        verified(**few, shaking={"intensity": intensity, "builtin": "near-fault"})
        for intensity in ("6-upper", "3")
    )
    assert alone.motions == 1
    english, japanese = (alone.sentence(language) for language in LANGUAGES)
    assert english.startswith("In shaking of JMA intensity 6-upper: in ")
    assert "runs of this one motion the bookcase hits" in english
    assert "earthquakes" not in english
    assert japanese.startswith("震度6強の揺れでは、この1つの地震動による計算")
    assert "runs of pieces: this one motion × 4 Monte Carlo samples" in simulations_of_room(alone, "en")
    assert "3: in none of the 4 runs of this one motion is anybody hit (" in quiet.sentence()
    assert "（95%区間：0～" in quiet.sentence("ja")


def test_a_verdict_of_one_record_is_not_of_earthquakes(tmp_path: Path):
    sp.near_fault().write(tmp_path / "own.csv")
    shaking = {"record": "own.csv", "intensity": "6-upper"}
    tables = {"furniture": piece(name="Bookcase 2"), "shaking": shaking, "uncertainty": {"samples": 4}}
    alone = sp.verify_room(sp.Scenario.parse({**BEDROOM, **tables}, tmp_path), progress=False)
    english, japanese = (alone.sentence(language) for language in LANGUAGES)
    assert "runs of this record bookcase 2 hits whoever is in bed" in english
    assert "この記録による計算" in japanese
    assert "「本棚2」がベッドにいる人に当たります" in japanese
    best = best_sentence(alone, "en")
    assert "The chance that somebody is hit falls from " in best
    assert "the bookcase 2" not in best
    report = alone.report(tmp_path / "room.html").read_text("utf-8")
    assert "other such earthquakes" not in report
    assert "1 motions" not in report


@pytest.mark.parametrize(
    ("share", "english", "japanese"),
    [
        (0.8, "in 8 of 10 earthquakes", "地震10回中8回で"),
        (0.03, "in 3 of 100 earthquakes", "地震100回中3回で"),
        (0.05, "in 1 of 20 earthquakes", "地震20回中1回で"),
        (0.78, "in 8 of 10 earthquakes", "地震10回中8回で"),
        (0.85, "in 17 of 20 earthquakes", "地震20回中17回で"),
        (0.0025, "in 3 of 1,000 earthquakes", "地震1,000回中3回で"),
        (0.0001, "in under 0.1 % of the earthquakes", "地震の0.1%未満で"),
        (1.0, "in all earthquakes", "地震のすべてで"),
    ],
)
def test_how_often_is_a_count(share: float, english: str, japanese: str):
    assert often(share, ("earthquakes", "地震")) == (english, japanese)


def test_a_verdict_of_an_earthquake_counts_the_scatter_of_its_strength():
    source = {"magnitude": 7.0, "distance": 10.0}
    shaking = {"earthquake": source, "suite": {"family": "near-fault", "count": 2}}
    found = verified(furniture=piece(), shaking=shaking, uncertainty={"samples": 2})
    assert "with the scatter of their strength around JMA intensity" in found.sentence()
    assert "ばらつき" in found.sentence("ja")


def test_a_move_says_from_which_wall_it_is_measured(verdict: RoomVerdict):
    moves = {
        # where it stands it is along the wall that it stands at already
        "left_wall": (
            (0.15, 0.4),
            "move the bookcase along the left wall until its middle is 0.40 m from the near wall",
            "「本棚」を左の壁に沿って、手前の壁から中心まで0.40 mの位置へ移動",
        ),
        "far_side_wall": ((1.3, 2.55), "its middle 1.30 m from the left wall", "左の壁から中心まで1.30 m"),
    }
    for wall, (at, english, japanese) in moves.items():
        label = label_of(Change("bookcase", at=at, heading=FACING[wall]), verdict)
        assert english in label[0]
        assert japanese in label[1]


@pytest.mark.parametrize(
    ("name", "alone", "within"),
    [
        ("chest", ("chest of drawers", "整理だんす"), ("the chest of drawers", "「整理だんす」")),
        *(
            (name, ("chest of drawers 2", "整理だんす2"), ("chest of drawers 2", "「整理だんす2」"))
            for name in ("Chest of drawers 2", "整理だんす 2")
        ),
        *(
            (name, (name, name), (f"“{name}”", f"「{name}」"))
            for name in ("Dad's chest 2", "chest two", "chest ２", "2", "chest2", "Chest")
        ),
    ],
)
def test_default_names_are_translated_and_the_user_s_own_are_quoted(
    name: str, alone: tuple[str, str], within: tuple[str, str]
):
    assert (piece_name(name), piece_within(name)) == (alone, within)
    assert place_name(sp.PersonPlace.of("desk", (1.0, 1.0), name="desk 2")) == ("desk 2", "机2")
    assert door_name(sp.Door("left_wall", 0.5, 0.8, name="door 2")) == ("door 2", "ドア2")


@pytest.fixture(scope="module")
def two() -> tuple[Question, list[RoomPart]]:
    """Two pieces that run by themselves, the first also with brackets."""
    room = changed(
        furniture=[*piece(), {"name": "chest", "preset": "chest", "against": "near_side_wall", "along": 1.6}],
        doors=[],
        shaking={"intensity": "6-upper", "suite": {"family": "near-fault", "count": 2}},
        uncertainty={"samples": 4},
    )
    question = question_of(room, 1)
    parts = [RoomPart.of(question.whole, group) for group in groups_of(room)]
    tried = measures_tried(room, question.whole, 0)
    return question, parts + [held for change, held in tried if isinstance(change.measure, LBracket)]


def test_parts_come_in_their_order_each_as_if_it_ran_alone(two: tuple[Question, list[RoomPart]]):
    question, parts = two
    alone = [question.run([part])[0] for part in parts]
    for threads in (1, 3):
        together = question._replace(threads=threads).runs_of_each(parts)
        for one, own in zip(together, alone, strict=True):
            assert np.array_equal(one.results, own.results)
            assert one.peaks == own.peaks
            for run, track in zip(one.tracks, own.tracks, strict=True):
                assert np.array_equal(run[0].place, track[0].place)


def test_what_became_of_a_part_is_known_before_the_last_has_run(two: tuple[Question, list[RoomPart]]):
    (question, parts), ended = two, list[int]()
    found = question._replace(advance=ended.append).runs_of_each(parts)
    next(found)
    assert sum(ended) < 2 * len(parts) * 2
    found.close()
