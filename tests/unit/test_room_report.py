"""The report of a room: its plan to scale, and every number of the verdict in both languages."""

import csv
import html
import io
import math
import re
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from html_pages import Page, check_alone, check_readable

from stayput.catalogue import phrase, say
from stayput.errors import InputError
from stayput.fragility.paired import difference
from stayput.fragility.probabilities import probability
from stayput.measures import Belt
from stayput.model.floor_plan import PLACE_NAMES, rectangle
from stayput.montecarlo.counting import EVENTS, Member, Quantiles
from stayput.report.room.report import room_html, sections
from stayput.report.verdict import numbers
from stayput.scenario import Scenario
from stayput.simulation.space_fate import Stability
from stayput.verification import Verdict
from stayput.verification.changes import Change, with_changes
from stayput.verification.events import CELL, Zones
from stayput.verification.people import DoorVerdict, HitVerdict, PairedEstimate, People, PlaceVerdict
from stayput.verification.room_words import (
    best_sentence,
    people_in,
    piece_changed,
    piece_within,
    sentence_of_room,
)
from stayput.verification.verdict import OptionVerdict, PieceVerdict

HOSTILE = "<script>alert('&')</script>"
SCENARIO = {
    "title": "Bedroom <1>",
    "plan": {"width": 4.0, "length": 3.0},
    "furniture": [
        {"name": HOSTILE, "preset": "bookcase", "against": "left_wall", "along": 1.0},
        {"name": "vase", "diameter": 0.3, "height": 0.6, "mass": 8.0, "at": [3.5, 2.5]},
    ],
    "places": [
        {"kind": "bed", "at": [2.0, 0.8], "heading": math.pi / 2.0},
        {"kind": "cot", "name": f"cot {HOSTILE}", "at": [1.4, 2.3]},
    ],
    "doors": [
        {"wall": "right_wall", "start": 0.5, "width": 0.8},
        {"name": "hall & co", "wall": "far_side_wall", "start": 2.0, "opens": "outwards", "way_out": False},
        {"name": "glass", "wall": "near_side_wall", "start": 3.0, "opens": "sliding"},
    ],
    "windows": [{"wall": "left_wall", "start": 2.0, "width": 0.9}],
}
MOTIONS, SAMPLES = 10, 8


def shares(share, seed):
    return np.random.default_rng(seed).random((MOTIONS, SAMPLES)) < share


NEVER = probability(np.zeros((MOTIONS, SAMPLES), np.bool_))


def made(**changed):
    """Return a verdict made by hand, in which each number differs from the others."""
    scenario = Scenario.parse({**SCENARIO, **changed})
    scene, names = scenario.scene(), scenario.names
    plan = scene.plan
    assert plan is not None
    chance = [probability(shares(0.05 + 0.04 * n, n)) for n in range(22)]
    left = iter(chance)
    pieces = []
    for n, standing in enumerate(scene.pieces):
        fell = np.zeros((round(plan.width / CELL), round(plan.length / CELL)))
        fell[10 * n : 10 * n + 5, 4:6] = 0.35
        own = {event: next(left) for event in EVENTS}
        zones = Zones(fell, 0.0 * fell, rectangle(standing.at[:2], 0.3, 0.8, standing.heading))
        slide, harm = Quantiles(0.021 + n, 0.043 + n), 123.0 - 100.0 * n
        pieces.append(PieceVerdict(names[n], own, slide, slide, Stability.FALLS, None, harm, zones))
    by = [
        HitVerdict(
            name,
            13.0 + n,
            next(left),
            *(Quantiles(*two) for two in ((1.1 + n, 2.2 + n), (31.0 + n, 1720.0 + 100 * n))),
            by_falling=n == 0,
        )
        for n, name in enumerate(names)
    ]
    hit, shut_in = next(left), next(left)
    places = tuple(
        PlaceVerdict(
            place,
            NEVER,
            next(left) if n == 0 else NEVER,
            NEVER,
            tuple(by) if n == 0 else (),
            next(left),
            n == 9,
        )
        for n, place in enumerate(plan.places)
    )
    doors = tuple(DoorVerdict(door, next(left), n == 1) for n, door in enumerate(plan.doors))
    outlooks = (PairedEstimate(chance, None) for chance in (NEVER, hit, NEVER, shut_in, NEVER))
    people = People(*outlooks, 0.317, 45.6, places, doors)
    bare = OptionVerdict(
        option=scenario.stated,
        rank=3,
        runs=MOTIONS * SAMPLES,
        probabilities=pieces[0].probabilities,
        change=None,
        slide=pieces[0].slide,
        tilt=pieces[0].tilt,
        typical=Member(0, 0),
        worst=Member(0, 0),
        pieces=tuple(pieces),
        devices=(),
        curves={},
        capacities={},
        people=people,
    )
    moved = Change("bed" if plan.places else "vase", at=(2.5, 1.6), heading=0.0)
    bare_runs, some = shares(0.7, 40), shares(0.2, 41)
    same = difference(some, some)

    def option(n, change, after):
        hits = PairedEstimate(chance[n], difference(after, bare_runs)), PairedEstimate(chance[5 + n], same)
        return replace(
            bare,
            option=with_changes(scenario.stated, [change], names),
            rank=1 + n,
            change=same,
            pieces=tuple(
                replace(
                    piece, probabilities=piece.probabilities | {"overturned": chance[10 + n]}, change=same
                )
                for piece in pieces
            ),
            people=replace(
                people,
                **dict(zip(("hit", "shut_in"), hits, strict=True)),
                blocked=PairedEstimate(NEVER, same),
                risk=0.21 + 0.01 * n,
            ),
        )

    others = [option(0, Change(names[0], Belt()), bare_runs), option(1, moved, some)]
    return Verdict(
        scenario=scenario,
        intensity=6.27,
        options=(*others, bare),
        complete=True,
        motions=MOTIONS,
        runs=4321,
        slide_limit=0.15,
        seed=77,
        seconds=12.3,
    )


def with_people(verdict, **changed):
    """Return a verdict whose room as it is has other people in it."""
    bare = replace(verdict.without, people=replace(people_in(verdict), **changed))
    return replace(verdict, options=(*verdict.others, bare))


@pytest.fixture(scope="module", params=["en", "ja"])
def page(request):
    verdict = made()
    return verdict, request.param, room_html(verdict, request.param)


def counting_hours(people):
    return people.hit.chance.scaled(people.risk / people.hit.chance.estimate)


def barred(verdict):
    """Return the chances that the report draws as bars, in its order."""
    return [
        *(
            chance
            for one in people_in(verdict).places
            for chance in (
                *(one.hit, one.crushed, one.touched),
                *[one.by_day] * (one.place.day > 0.0),
                *[one.by_night] * (one.place.night > 0.0),
            )
        ),
        *(one.probability for place in people_in(verdict).places for one in place.by),
        *(one.blocked for one in people_in(verdict).doors if not one.at_rest),
        *(one.shut_in for one in people_in(verdict).places),
        *(one.probabilities[event] for one in verdict.without.pieces for event in ("overturned", "slid")),
        *(
            chance
            for one in verdict.others
            for chance in (
                one.people.hit.chance,
                one.people.shut_in.chance,
                *(piece_changed(one, verdict) or ())[:1],
                counting_hours(one.people),
                one.probabilities["device_failed"],
            )
        ),
    ]


def test_it_says_the_verdict_and_every_number_of_it(page):
    verdict, language, text = page
    told = Page(text).words
    assert " ".join(sentence_of_room(verdict, language).split()) in told
    people = people_in(verdict)
    for chance in (people.hit.chance, people.shut_in.chance, *barred(verdict)):
        assert numbers.probability(chance, language) in told
        # a share that is told by its interval has none beside it
        assert "–" in chance.brief or numbers.interval(chance, language) in told
    for one in verdict.others:
        assert verdict.label(one, language) in told
        assert numbers.change(one.people.hit.change, language) in told
    for number in ("6.27", "4,321", "77", "stayput"):
        assert number in told
    for told_of in (numbers.probability, numbers.interval):
        assert told_of(counting_hours(people), language) in told
    assert ("15 cm") in told


@pytest.mark.parametrize("fell", [0, 5])
def test_an_interval_ends_where_its_bound_in_brief_does(fell):
    chance = probability(np.arange(5)[:, np.newaxis] < fell)
    (bound,) = re.findall(r"[<>](\d+) %", numbers.probability(chance, "en"))
    assert bound in numbers.interval(chance, "en").split()
    wide = probability(np.arange(40).reshape(2, 20) < 1)
    assert re.fullmatch(r"<0\.1 to \d+ %", numbers.interval(wide, "en"))


def rows_of(verdict, key):
    """Return the rows of one of a report's tables, each value with what stands beside it."""
    (rows,) = (one.rows for one in sections(verdict, verdict.others, "en") if one.key == key)
    return [[(cell.value, cell.aside) for cell in row] for row in rows]


def test_the_tables_hold_the_numbers_of_their_rows():
    verdict = made()
    hits = rows_of(verdict, "what_hits")
    assert [(row[0][0], *row[1], row[5][0]) for row in hits] == [
        ("bed", HOSTILE, "falls on them", "13 kg"),
        ("bed", "vase", "touches them without falling", "14 kg"),
    ]
    assert [row[3:5] for row in hits] == [
        [("1.1 m/s", "90 %: 2.2 m/s"), ("31 J", "90 %: 1.7 kJ")],
        [("2.1 m/s", "90 %: 3.2 m/s"), ("32 J", "90 %: 1.8 kJ")],
    ]
    pieces = rows_of(verdict, "pieces")
    assert [row[4][0] for row in pieces] == ["123 J", "23 J"]
    assert pieces[0][3] == ("2.1 cm", "90 %: 4.3 cm")


def test_hours_have_intervals_as_their_neighbours_have():
    verdict = made()
    for place, row in zip(people_in(verdict).places, rows_of(verdict, "places"), strict=True):
        for chance, time, (value, _) in zip(
            (place.by_day, place.by_night), (place.place.day, place.place.night), row[4:], strict=True
        ):
            assert value == (chance if time else "0 %")


@pytest.mark.parametrize("language", ["en", "ja"])
def test_a_piece_that_hits_somebody_is_not_told_as_merely_overturning(language):
    """What else falls on somebody is told so beside the first piece, with its interval."""
    verdict = made()
    (place, *_) = people_in(verdict).places
    by = tuple(replace(hit, by_falling=True) for hit in place.by)
    several = with_people(verdict, places=(replace(place, by=by),))
    pieces = several.without.pieces
    assert [piece.falls for piece in pieces] == [True, True]
    told = sentence_of_room(several, language)
    for hit in by:
        words = {"often": "", "piece": piece_within(hit.piece), "interval": ""}
        where = phrase("rooms.in_place", place=PLACE_NAMES["bed"])
        assert say("rooms.falls_on", language, place=where, **words).strip() in told
    alone = say(pieces[1].probabilities["overturned"].share, language)
    assert alone not in told
    seldom = replace(by[1], probability=NEVER)
    rarely = with_people(verdict, places=(replace(place, by=(by[0], seldom)),))
    assert alone in sentence_of_room(rarely, language)  # what hits in no run is told as overturning


@pytest.mark.parametrize("language", ["en", "ja"])
def test_changes_that_share_a_rank_are_told_as_ties(language):
    """In the sentence, the report, Markdown and CSV; how often devices fail stands there where they do."""
    verdict, failed = made(), probability(shares(0.2, 7))
    belts, moved = verdict.others
    belts = replace(belts, people=moved.people, probabilities=belts.probabilities | {"device_failed": failed})
    moved = replace(moved, probabilities=moved.probabilities | {"device_failed": NEVER}, rank=1)
    tied = replace(verdict, options=(belts, moved, verdict.without))
    told = {"en": "Others may help as much (1).", "ja": "ほかに1件が同じくらい効く可能性"}[language]
    assert told in best_sentence(tied, language)
    assert told not in best_sentence(verdict, language)
    (section,) = (one for one in sections(tied, tied.others, language) if one.key == "changes")
    assert say("report.rank", language) == section.columns[1]
    assert say("report.device_failed", language) == section.columns[-1]
    assert [(row[1].value, row[-1].value) for row in section.rows] == [("1", failed), ("1", "")]
    assert tied.to_markdown(language).count("| 1 |") == 2
    rows = [row for row in csv.DictReader(io.StringIO(tied.to_csv())) if row["event"].endswith("_with")]
    assert {row["rank"] for row in rows} == {"1"}
    assert [row["of"] for row in rows if row["event"] == "device_failed_with"] == [tied.label(belts)]


def test_where_nobody_was_hit_the_hours_count_too():
    """Nobody can be hit more often than somebody is there."""
    verdict = with_people(made(), hit=PairedEstimate(NEVER, None), risk=0.0)
    text = room_html(verdict)
    (share,) = re.findall(r"counting the hours[^<]*</dt><dd><span[^>]*>([^<]*)", text)
    there = max((16.0 * one.place.day + 8.0 * one.place.night) / 24.0 for one in people_in(verdict).places)
    assert share.replace("\u00a0", " ") == numbers.probability(NEVER.scaled(there), "en").replace("<", "&lt;")


def test_it_needs_nothing_else_and_can_be_read_without_seeing_it(page):
    _, language, text = page
    check_alone(text)
    check_readable(text, language)
    tags = [tag for tag, _ in Page(text).elements]
    assert tags.count("script") == 1  # opens what is printed or linked to
    assert HOSTILE in Page(text).words  # as a text, since there is no such element
    assert tags.count("title") > 8  # the page's, and those of the plan's parts


def test_its_inputs_are_folded_into_it(page):
    verdict, _, text = page
    inputs = r"<details data-printed><summary>[^<]*</summary>\s*<pre[^>]*><code>(.*?)</code>"
    (toml,) = re.findall(inputs, text, re.DOTALL)
    assert html.unescape(toml) == verdict.scenario.to_toml()


def test_each_bar_stands_with_its_number(page):
    verdict, language, text = page
    told = re.findall(r'<span class="value">([^<]*)</span>\s*<svg class="bar"', text)
    first = [people_in(verdict).hit, *(one.people.hit for one in verdict.others[:4])]
    wanted = [*(hit.chance for hit in first), *barred(verdict)]
    shown = [numbers.probability(one, language) for one in wanted]
    assert [html.unescape(share).replace("\u00a0", " ") for share in told] == shown
    widths = [float(width) for width in re.findall(r'class="part" width="([\d.]+)"', text)]
    assert widths == [round(100.0 * one.estimate, 2) for one in wanted]


def test_a_door_that_is_blocked_at_rest_is_marked(page):
    verdict, language, text = page
    mark = say("room_report.at_rest", language)
    assert re.search(f"<td[^>]*><span[^>]*>{mark}</span></td>", text)  # in place of how often
    doors = tuple(replace(one, at_rest=False) for one in people_in(verdict).doors)
    opened = with_people(verdict, doors=doors)
    assert mark not in Page(room_html(opened, language)).words


def test_runs_that_were_given_up_are_told(page):
    verdict, language, text = page
    given_up = shares(0.1, 3)
    missing = with_people(verdict, hit=PairedEstimate(probability(shares(0.5, 4), given_up), None))
    note = say("room_report.missing", language, missing=int(given_up.sum()), all=MOTIONS * SAMPLES)
    assert note in Page(room_html(missing, language)).words
    assert 'class="note"' not in text


@pytest.mark.parametrize("language", ["en", "ja"])
def test_what_there_is_none_of_is_said(language):
    no_way_out = [{**door, "way_out": False} for door in SCENARIO["doors"]]
    without = [made(**tables) for tables in ({"doors": []}, {"doors": no_way_out, "windows": []})]
    verdict = made()
    places = tuple(replace(one, hit=NEVER, by=()) for one in people_in(verdict).places)
    nothing = with_people(verdict, places=places)
    without.append(replace(nothing, options=(nothing.without,)))
    said = ("no_doors",), ("no_way_out",), ("no_hit", "no_changes")
    for found, keys in zip(without, said, strict=True):
        words = Page(room_html(found, language)).words
        assert all(say(f"room_report.{key}", language) in words for key in keys)
        if "no_way_out" in keys:
            assert say("room_report.any_shut_in", language) not in words


def test_it_is_written_whole_and_refuses_other_names(tmp_path):
    verdict = made()
    assert verdict.report(tmp_path / "room.html").read_text(encoding="utf-8") == room_html(verdict)
    with pytest.raises(InputError):
        verdict.report(tmp_path / "room.pdf")
    with pytest.raises(InputError):
        verdict.report(tmp_path / "room.html", "fr")
    for told in (verdict.sentence, verdict.notes, verdict.to_markdown, partial(verdict.label, verdict.best)):
        with pytest.raises(InputError, match="one of 'en', 'ja'"):
            told("fr")
