"""The single changes of a room in the files that are kept, on the terminal, and in its tables."""

import csv
import io
from dataclasses import replace

import pytest
from test_room_report import made, shares

from stayput.catalogue import say
from stayput.cli.verdicts import print_verdict
from stayput.fragility.paired import difference
from stayput.report.room.report import sections
from stayput.verification.room_words import piece_changed


def test_the_csv_says_what_each_change_brings():
    verdict = made()
    rows = list(csv.DictReader(io.StringIO(verdict.to_csv())))
    held, moved = verdict.others
    label = verdict.label(held)
    found = {row["event"]: row for row in rows if row["of"] == label}
    own = piece_changed(held, verdict)
    assert own is not None
    for event, chance, change in (
        ("hit_with", *held.people.hit),
        ("shut_in_with", *held.people.shut_in),
        ("overturned_with", *own),
    ):
        told = [float(found[event][key]) for key in ("probability", "low", "high")]
        assert told == [chance.estimate, chance.low, chance.high]
        told = [float(found[event][key]) for key in ("change", "change_low", "change_high")]
        assert told == [change.estimate, change.low, change.high]
    place = verdict.label(moved)
    assert [row["event"] for row in rows if row["of"] == place] == [
        *("hit_with", "shut_in_with", "device_failed_with")
    ]
    assert {row["change"] for row in rows if not row["event"].endswith("_with")} == {""}


@pytest.mark.parametrize("language", ["en", "ja"])
def test_the_terminal_lists_the_changes_that_help_and_the_next_three(
    language: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setenv("COLUMNS", "400")
    verdict = made()
    chance, helping = verdict.others
    assert (chance.helps, helping.helps) == (False, True)
    label, better = (verdict.label(one, language) for one in (chance, helping))
    for others, shown in ((3, 3), (4, 4), (5, 3), (15, 3)):
        print_verdict(
            replace(verdict, options=((helping,) + (chance,) * others + (verdict.without,))), language
        )
        told = capsys.readouterr().out
        listed = told[told.index(say("room_report.changes", language)) :]
        assert (listed.count(label), listed.count(better)) == (shown, 1)
        assert listed.index(better) < listed.index(label)
        assert (say("rooms.more_changes", language, count=others - shown) in told) == (others > shown)


def test_it_says_of_each_change_whether_it_clearly_helps_or_makes_something_worse():
    verdict = made()
    first = verdict.others[0]
    hit = first.people.hit._replace(change=difference(shares(0.9, 1), shares(0.1, 2)))
    worse = replace(first, people=replace(first.people, hit=hit))
    both = replace(verdict, options=(*verdict.options, worse))
    (changes,) = (one for one in sections(both, both.others, "en") if one.key == "changes")
    assert [row[0].value for row in changes.rows] == [both.label(one, "en") for one in both.others]
    assert [row[0].tag for row in changes.rows] == ["model", "high", "low"]
    assert changes.rows[2][0].text("en").endswith("(clearly more hit)")
