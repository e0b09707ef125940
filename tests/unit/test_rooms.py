"""Rooms: their files, what is refused, and verdicts that hang together."""

from __future__ import annotations

import math
import re
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import stayput as sp
from stayput.catalogue import LANGUAGES
from stayput.fragility.paired import Difference
from stayput.fragility.probabilities import probability
from stayput.measures import LBracket
from stayput.model.floor_plan import FACING
from stayput.montecarlo.counting import SLIDE_LIMIT, Members
from stayput.montecarlo.scene_draws import SceneDraw, drawn_shaking
from stayput.report.room.report import room_markdown, simulations_of_room
from stayput.report.verdict.data import verdict_data
from stayput.simulation.groups import groups_at_first
from stayput.verification.changes import Change, loose_pieces, refuse_unheld, with_changes
from stayput.verification.option_runner import OptionRunner
from stayput.verification.options import TRIED_ALONE
from stayput.verification.room_words import (
    best_sentence,
    door_name,
    label_of,
    often,
    people_in,
    piece_name,
    piece_within,
    pieces_in,
    place_name,
)

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.verification import Verdict
    from stayput.verification.people import People
    from stayput.verification.verdict import OptionVerdict

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


def verified(**tables: Any) -> Verdict:
    return sp.verify(changed(**tables), changes=False, progress=False)


@pytest.fixture(scope="module")
def verdict() -> Verdict:
    return sp.verify(changed(), progress=False)


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
        ({"places": [{"name": "Bookcase", "at": [2.0, 1.0]}]}, "it must not be that of furniture[0]"),
        ({"doors": [{"wall": "right_wall", "start": 2.2}]}, "must be at most 2.7 m"),
        ({"doors": [{"wall": "back_wall", "start": 0.2}]}, "back_wall"),
        ({"room": {"left_wall": {"gap": 0.1}}}, "left_wall"),
        ({"plan": {"width": 31.0, "length": 3.0}}, "must be a number between 0.5 and 30 m"),
        ({"room": {"ceiling": {"height": 1.5}}}, "furniture[0] (“bookcase”) is 1.8 m high"),
        ({"options": [{"name": "none"}]}, "options[0].name is 'none'"),
    ],
)
def test_what_is_wrong_is_refused_with_the_value(tables: dict[str, Any], told: str):
    with pytest.raises(sp.InputError, match=r"must|missing|unknown|not|give") as refusal:
        sp.verify(changed(**tables), changes=False, progress=False)
    assert told in str(refusal.value)
    assert not re.match(r"(\S+): \1 ", str(refusal.value))  # the key once
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
    assert groups_at_first(room.scene()) == [(0, 1), (2,)]
    assert loose_pieces(room) == {2}


def of_people(option: OptionVerdict) -> People:
    assert option.people is not None
    return option.people


def test_the_verdict_hangs_together(verdict: Verdict):
    people = people_in(verdict)
    (place,) = people.places
    assert people.hit.chance == place.hit
    chances = [one.probability.estimate for one in place.by]
    assert max(chances) <= place.hit.estimate <= sum(chances)
    assert people.risk == pytest.approx(place.hit.estimate * 8.0 / 24.0)
    bookcase = next(one for one in verdict.without.pieces if one.name == "bookcase")
    assert pieces_in(verdict)[0] is bookcase
    energy = place.by[0].energy
    assert 0.0 < bookcase.harm <= chances[0] * energy.p90 * 8.0 / 24.0
    assert people.harm <= sum(one.harm for one in verdict.without.pieces) + 1e-9
    assert place.by[0].by_falling
    for one in verdict.without.pieces:  # it lies where it fell, and stands where it did not
        assert one.zones is not None
        fell = one.probabilities["overturned"].estimate
        assert one.zones.fell.max() <= fell + 1e-12
        assert one.zones.stood.max() <= 1.0 - fell + 1e-12
    # where it ends is in the room; a piece that overturns covers more of the floor
    assert bookcase.zones is not None
    covers = bookcase.zones.fell + bookcase.zones.stood
    assert 0.24 * 0.9 < covers.sum() * 0.05**2 < 1.8 * 0.8 * 1.2
    assert {option.runs for option in verdict.options} == {6}
    assert verdict.runs >= 3 * 6  # of each kind without anything


def test_changes_are_compared_run_by_run_and_what_is_clear_ranks_first(verdict: Verdict):
    assert verdict.others
    as_it_is = verdict.without
    severities = [
        (one.standing, one.standing == 0 and one is not as_it_is, *of_people(one).severity)
        for one in verdict.options
    ]
    assert severities == sorted(severities)
    assert {one.rank for one in verdict.options if one.standing == 0} == {as_it_is.rank}
    now = people_in(verdict)
    for one in verdict.others:
        then = of_people(one)
        assert then.hit.change is not None
        assert then.hit.change.estimate == pytest.approx(then.hit.chance.estimate - now.hit.chance.estimate)
    changes = [verdict.changes(one) for one in verdict.others]
    kinds = {(change.what, change.measure is None) for (change,) in changes}
    assert {("bookcase", False), ("bookcase", True), ("bed", True)} <= kinds


def test_the_names_of_the_pieces_change_no_number(verdict: Verdict):
    renamed = verified(furniture=[{**piece, "name": f"my {piece['name']}"} for piece in BEDROOM["furniture"]])
    assert people_in(renamed).hit == people_in(verdict).hit
    chances = [[piece.probabilities for piece in each.without.pieces] for each in (renamed, verdict)]
    assert chances[0] == chances[1]


def test_a_change_says_what_is_clearly_better_and_what_worse(verdict: Verdict):
    def differing(estimate: float, low: float, high: float) -> Difference:
        return Difference(estimate, low, high, more=0, fewer=0, pairs=40, missing=0)

    fewer, more, same = differing(-0.5, -0.7, -0.2), differing(0.5, 0.2, 0.7), differing(0.0, -0.1, 0.1)
    unclear = differing(0.13, -0.05, 0.3)  # more are hit, though not clearly
    option = verdict.others[0]
    pieces = tuple(
        replace(piece, change=change) for piece, change in zip(option.pieces, (same, fewer), strict=True)
    )
    for changes, told in (
        ({}, (("overturned",), (), True)),
        ({"blocked": more}, (("overturned",), ("blocked",), False)),
        ({"shut_in": fewer, "hit": unclear}, (("shut_in", "overturned"), (), False)),
    ):
        people = of_people(option)
        alike = dict.fromkeys(("hit", "shut_in", "blocked"), same) | changes
        outlooks = {name: getattr(people, name)._replace(change=diff) for name, diff in alike.items()}
        change = replace(option, pieces=pieces, people=replace(people, **outlooks))
        assert (change.better, change.worse, change.helps) == told


def test_where_a_change_moves_something_it_is_as_if_it_stood_there(verdict: Verdict):
    moves = {
        change.what: (one, change) for one in verdict.others for change in verdict.changes(one) if change.at
    }
    option, bed = moves["bed"]
    assert bed.at is not None
    elsewhere = [{**BEDROOM["places"][0], "at": list(bed.at), "heading": bed.heading}]
    assert people_in(verified(places=elsewhere)).hit.chance == of_people(option).hit.chance
    option, moved = moves["bookcase"]
    assert moved.at is not None
    there = [{"name": "bookcase", "preset": "bookcase", "at": [*moved.at], "heading": moved.heading}]
    again = verified(furniture=there + BEDROOM["furniture"][1:])
    assert people_in(again).hit.chance == of_people(option).hit.chance


def test_the_verdict_is_told_as_it_gets_better_and_ends_the_same_for_any_number_of_threads(verdict: Verdict):
    told: list[Verdict] = []
    last = sp.verify(changed(), progress=False, threads=3, on_verdict=told.append)
    compared = [len(one.others) for one in told]  # the room as it is, and then with its changes too
    assert compared == sorted(compared)
    assert (compared[0], compared[-1]) == (0, len(last.others))
    assert not any(one.complete for one in told)
    assert last.complete
    for one, other in zip(last.without.pieces, verdict.without.pieces, strict=True):
        assert one.zones is not None
        assert other.zones is not None
        for name in ("fell", "stood"):
            assert np.array_equal(getattr(one.zones, name), getattr(other.zones, name))
    assert {**verdict_data(last), "seconds": None} == {**verdict_data(verdict), "seconds": None}


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
    first, second = people_in(one), people_in(other)
    assert first.hit.chance.estimate - second.hit.chance.estimate == same
    assert first.doors[0].blocked.estimate - second.doors[0].blocked.estimate == same
    for piece_of_one, piece_of_other in zip(one.without.pieces, other.without.pieces, strict=True):
        for key, found in piece_of_one.probabilities.items():
            assert found.estimate - piece_of_other.probabilities[key].estimate == same


def test_nobody_is_hit_by_what_is_fixed_well():
    brackets = [{"type": "l_bracket", "strength": 1e5}]
    safe = verified(furniture=piece(measures=brackets) + BEDROOM["furniture"][1:])
    assert people_in(safe).hit.chance.estimate == 0.0
    assert "in these runs nobody is hit; somebody may be in under " in safe.sentence()


def test_a_room_without_doors_and_places_is_verified_in_several_blocks():
    shaking = {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 2}}
    empty = sp.verify(
        changed(furniture=piece(), doors=[], places=[], shaking=shaking, uncertainty={"samples": 24}),
        progress=False,
    )
    assert (empty.motions, empty.complete) == (2, True)
    assert {one.runs for one in empty} == {24}
    people = people_in(empty)
    assert people.places == people.doors == ()
    assert people.hit.chance.estimate == people.risk == people.harm == 0.0
    assert all("overturned" in one.better or not one.helps for one in empty.others)
    assert all(map(empty.sentence, LANGUAGES))


def test_nobody_is_shut_in_where_there_is_no_way_out():
    closed = verified(doors=[{"wall": "right_wall", "start": 1.2, "way_out": False}])
    assert people_in(closed).shut_in.chance.estimate == 0.0


def test_a_held_piece_with_its_back_on_a_wall_meets_floors_that_lean_either_way():
    held = piece(gap=0.0, measures=[{"type": "l_bracket"}])
    verdict = verified(furniture=held, uncertainty={"samples": 24})
    assert people_in(verdict).hit.chance.runs == 24


def test_a_room_is_simulated_with_all_its_pieces_together():
    run = changed().run()
    assert len(run.pieces) == 2


def test_a_room_is_simulated_under_a_motion_of_its_direction():
    plain, pointing = changed().motion(), changed(direction=0.7).motion()
    shaking = drawn_shaking(plain, 1.0, SceneDraw((), 1.0, 1.0, direction=0.7), 9.8)
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
    runner = OptionRunner(room, SLIDE_LIMIT, 1)
    possible: set[str] = set()
    for kind in TRIED_ALONE:
        option = with_changes(room.stated, [Change("bookcase", sp.MEASURES[kind]())], room.names)
        with suppress(sp.InputError):
            refuse_unheld(runner.scene(option), 0)
            possible.add(kind)
    assert {"l_bracket", "belt"} & possible == kinds


def test_a_verdict_of_one_motion_says_so():
    few = {"furniture": piece(), "uncertainty": {"samples": 4}}
    alone, quiet = (
        verified(**few, shaking={"intensity": intensity, "builtin": "near-fault"})
        for intensity in ("6-upper", "3")
    )
    assert alone.motions == 1
    english, japanese = (alone.sentence(language) for language in LANGUAGES)
    assert english.startswith("In shaking of JMA intensity 6-upper: in ")
    assert "runs of this one motion the bookcase falls on" in english
    assert "earthquakes" not in english
    assert japanese.startswith("震度6強の揺れでは、この1つの地震動による計算")
    assert "4 times as it is and with each change" in simulations_of_room(alone, "en")
    assert "in these runs nobody is hit; somebody may be in under " in quiet.sentence()
    assert "人に当たる家具はありません（この1つの地震動による計算の" in quiet.sentence("ja")


def test_a_verdict_of_one_record_is_not_of_earthquakes(tmp_path: Path):
    sp.near_fault().write(tmp_path / "own.csv")
    shaking = {"record": "own.csv", "intensity": "7"}
    tables = {"furniture": piece(name="Bookcase 2"), "shaking": shaking, "uncertainty": {"samples": 8}}
    alone = sp.verify(sp.Scenario.parse({**BEDROOM, **tables}, tmp_path), progress=False)
    english, japanese = (alone.sentence(language) for language in LANGUAGES)
    assert "runs of this record bookcase 2 falls on whoever is in bed" in english
    assert "この記録による計算" in japanese
    assert "「本棚2」がベッドにいる人の上に倒れます" in japanese
    best = best_sentence(alone, "en")
    assert "The chance that somebody is hit falls by " in best
    assert "the bookcase 2" not in best
    report = alone.report(tmp_path / "room.html").read_text("utf-8")
    assert "other such earthquakes" not in report
    assert "1 motions" not in report


def test_how_often_is_told_in_per_cent():
    chance = probability(np.arange(40).reshape(40, 1) < 30)
    assert often(chance, ("earthquakes", "地震")) == ("in about 80 % of earthquakes", "地震の約80%で")


@pytest.mark.parametrize("stuck", [False, True])
def test_a_door_that_is_blocked_before_any_shaking_is_told_so(stuck):
    verdict = verified()
    people = people_in(verdict)
    doors = tuple(replace(door, at_rest=stuck, blocked=people.hit.chance) for door in people.doors)
    places = tuple(replace(place, shut_in_at_rest=stuck) for place in people.places)

    def with_people(**changed: Any) -> Verdict:
        bare = replace(verdict.without, people=replace(people, **changed))
        return replace(verdict, options=(bare,))

    told = with_people(doors=doors, places=places)
    assert (
        "the door is blocked already as the furniture stands, before any shaking" in told.sentence()
    ) == stuck
    assert ("so there is no way out before any shaking" in told.sentence()) == stuck
    assert ("stays blocked" in told.sentence()) != stuck
    assert ("| bed | blocked already as the furniture stands |" in room_markdown(told)) == stuck
    assert "before any shaking" not in with_people(doors=()).sentence()


def test_a_verdict_of_an_earthquake_counts_the_scatter_of_its_strength():
    source = {"magnitude": 7.0, "distance": 10.0}
    shaking = {"earthquake": source, "suite": {"family": "near-fault", "count": 2}}
    found = verified(furniture=piece(), shaking=shaking, uncertainty={"samples": 2})
    assert "with the scatter of their strength around JMA intensity" in found.sentence()
    assert "ばらつき" in found.sentence("ja")


def test_a_move_says_from_which_wall_it_is_measured(verdict: Verdict):
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


def test_a_group_runs_once_for_all_options_that_leave_it_as_it_is():
    room = changed(
        furniture=[*piece(), {"name": "chest", "preset": "chest", "against": "near_side_wall", "along": 1.6}],
        doors=[],
        shaking={"intensity": "6-upper", "suite": {"family": "near-fault", "count": 2}},
        uncertainty={"samples": 4},
    )
    option = with_changes(room.stated, [Change("bookcase", LBracket())], room.names)
    together, alone = OptionRunner(room, SLIDE_LIMIT, 3), OptionRunner(room, SLIDE_LIMIT, 1)
    members = Members.of_samples(2, 2)
    bare, held = together.run([room.stated, option], members, keep=True)
    (by_itself,) = alone.run([option], members)
    assert np.array_equal(held.results, by_itself.results)
    assert held.devices.tobytes() == by_itself.devices.tobytes()  # whose times of failure are NaN
    chests = zip(held.tracks[..., 1].ravel(), bare.tracks[..., 1].ravel(), strict=True)
    assert all(one is other for one, other in chests)  # but where they meet, which they do not here


def test_pieces_that_meet_run_together_and_what_stands_apart_changes_no_bit():
    """A bookcase falls on a chest before it: together they do what they do not do alone."""
    tables: dict[str, Any] = {
        "places": [],
        "doors": [],
        "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 2}},
        "uncertainty": {"samples": 2},
    }
    chest = {"name": "chest", "preset": "chest", "at": [1.3, 1.9]}
    far = {"name": "far", "preset": "chest", "against": "right_wall", "along": 0.6}
    results = [
        OptionRunner(room, SLIDE_LIMIT, 1).run([room.stated], Members.of_samples(2, 1))[0].results
        for room in (
            changed(furniture=furniture, **tables)
            for furniture in (piece(), [*piece(), far], [*piece(), chest], [*piece(), chest, far])
        )
    ]
    bare, with_far, with_chest, with_both = (array[..., 0] for array in results if array is not None)
    assert np.array_equal(bare, with_far)
    assert np.array_equal(with_chest, with_both)
    assert not np.array_equal(bare, with_chest)
