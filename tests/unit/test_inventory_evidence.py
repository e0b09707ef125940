"""What the results of an inventory say of a row: statements that hold over the intervals of its runs."""

from __future__ import annotations

import math

import numpy as np
import pytest
from inventories import CITY, city, rows_of_results, table

from stayput.catalogue import say
from stayput.fragility.paired import difference
from stayput.inventory import assess
from stayput.inventory.report import UNTOLD, findings_told
from stayput.inventory.results import Finding, choose, finding_of, least_motions, numbers_of
from stayput.inventory.store import RECORD
from stayput.inventory.summary import READ, Total
from stayput.inventory.work import fill_changes, fill_record
from stayput.montecarlo.counting import EVENTS, Members, Outcomes


def test_costs_choose_what_is_worth_them():
    records = chances([0.5, 0, 0, 0], [0.1, 0, 0, 0], [0.05, 0, 0, 0])
    sizes = [0, 1, 1]
    assert choose(records, sizes, None, None).best == 2
    chosen = choose(records, sizes, [100.0, 1000.0], 10_000.0)
    assert (chosen.best, chosen.by_cost) == (2, 1)
    assert chosen.gain == pytest.approx(3900.0)
    assert choose(records, sizes, [1e6, 1e6], 10_000.0).by_cost == 0
    assert choose(records, sizes, [100.0, 1000.0], None).by_cost == 1
    worse = chances([0.5, 0, 0, 0], [0.6, 0, 0, 0], [0.6, 0, 0, 0])
    assert choose(worse, sizes, [100.0, 1000.0], None).best == 0


def of_runs(*columns):
    """Outcomes of columns of shape (motions, samples)."""
    return Outcomes(Members.of_samples(*columns[0].shape), *(column.ravel() for column in columns))


def chances(*rows, motions=100, samples=10):
    """Records of options by the shares of the runs in which each of `EVENTS` happens, the same first ones."""
    place = np.arange(motions * samples).reshape(motions, samples) / (motions * samples)
    outcomes = list[Outcomes]()
    for row in rows:
        overturned, slid, hit_wall, failed = (place < share - 1e-9 for share in row)
        given_up = np.full(place.shape, math.isnan(row[0]))
        outcomes.append(of_runs(overturned, given_up, hit_wall, failed, 1.0 * slid, 0.0 * place))
    return records_of(outcomes)


def records_of(outcomes):
    """Records of options by their outcomes, that without a measure first."""
    records = np.zeros(len(outcomes), RECORD)
    for record, of_option in zip(records, outcomes, strict=True):
        fill_record(record, of_option, 0.1)
        fill_changes(record, of_option, outcomes[0], 0.1, len(outcomes) - 1)
    return records


def row_of(records, not_possible=()):
    """What `finding_of` reads of a row whose options have these records."""
    options = [str(place) for place in range(len(records))]
    return numbers_of(records[0]) | {"options": options, "not_possible": not_possible}


@pytest.mark.parametrize(
    ("motions", "samples", "without", "held", "finding"),
    [
        (4, 1, 0.25, 0.0, Finding.MAY_BE_CHANCE),
        (40, 10, 0.02, 0.01, Finding.MAY_BE_CHANCE),
        (40, 10, 0.3, 0.0, Finding.HELPED),
        (4, 1, 0.0, 0.0, Finding.TOO_FEW_RUNS),
        (75, 10, 0.0, 0.0, Finding.TOO_FEW_RUNS),
        (4, 1, 0.75, 0.75, Finding.TOO_FEW_RUNS),  # no measure could be seen to prevent them
        (76, 1, 0.0, 0.0, Finding.NEEDS_NONE),
        (200, 10, 0.002, 0.002, Finding.NEEDS_NONE),
        (40, 10, 0.5, 0.5, Finding.NOT_HELPED),
        (40, 10, 0.02, 0.02, Finding.NOT_HELPED),
        (4, 1, math.nan, 0.0, None),
    ],
)
def test_what_is_said_of_a_row_holds_over_its_intervals(motions, samples, without, held, finding):
    records = chances([without, 0, 0, 0], [held, 0, 0, 0], motions=motions, samples=samples)
    choice = choose(records, [0, 1], [1.0], None)
    assert finding_of(row_of(records), choice) == finding
    assert choice.by_cost == (1 if finding == Finding.HELPED else 0)
    assert least_motions() == 76


def test_a_measure_without_a_change_run_by_run_is_not_best():
    fell, no, still = np.array([[1], [1], [0], [0]], bool), np.zeros((4, 1), bool), np.zeros((4, 1))
    slides = ([0, 1, 1, 1], [0, 0, 1, 1])  # one that slid also fell
    outcomes = [of_runs(fell, no, no, no, np.array(slid, float)[:, None], still) for slid in slides]
    choice = choose(records_of(outcomes), [0, 1], None, None)
    assert (choice.best, choice.event, choice.change) == (0, None, None)


def test_a_difference_is_that_of_a_verification_run_by_run():
    """By the same function, from the same runs, whichever event ranks the best first."""
    rng = np.random.default_rng(1)
    bare, held = rng.random((2, 30, 9)) < [[[0.4]], [[0.2]]]
    given_up, slid = rng.random((2, 30, 9)) < 0.05
    no, still = np.zeros((30, 9), bool), np.zeros((30, 9))
    outcomes = [of_runs(fell, given_up, no, no, 1.0 * slid, still) for fell in (bare, held)]
    choice = choose(records_of(outcomes), [0, 1], None, None)
    change = difference(held, bare, given_up)
    assert (choice.event, choice.change) == ("overturned", (change.estimate, change.low, change.high))


@pytest.mark.parametrize(("falls", "slides"), [(0.3, 0.0), (0.4, 0.6), (-1.0, 0.3)])
def test_measures_that_do_nothing_are_seldom_said_to_help(falls, slides):
    """Chosen among eight by the runs that score it, the best of them seems to help every piece."""
    rng = np.random.default_rng(3)
    rows, sets, shape = 100, 8, (20, 5)
    seeming = helped = by_cost = strong = 0
    for _ in range(rows):
        of_motion = rng.random((2, shape[0], 1)) - 0.5  # what the runs of a motion have in common
        no, outcomes = np.zeros(shape, bool), list[Outcomes]()
        for _ in range(1 + sets):
            fell, slid = rng.random((2, *shape)) + 0.4 * of_motion < [[[falls]], [[slides]]]
            outcomes.append(of_runs(fell, no, no, no, 1.0 * slid, 0.0 * slid))
        records = records_of(outcomes)
        choice = choose(records, [0] + [1] * sets, [1.0] * sets, None)
        seeming += choice.change is not None
        helped += finding_of(row_of(records), choice) == Finding.HELPED
        by_cost += choice.by_cost > 0
        records = records_of([*outcomes[:-1], of_runs(no, no, no, no, 0.0 * slid, 0.0 * slid)])
        choice = choose(records, [0] + [1] * sets, None, None)
        strong += (choice.best, finding_of(row_of(records), choice)) == (sets, Finding.HELPED)
    assert seeming > 0.8 * rows
    assert max(helped, by_cost) / rows < 0.05 + 3.0 * math.sqrt(0.05 * 0.95 / rows)
    assert strong > 0.9 * rows


@pytest.mark.parametrize(
    ("without", "held", "best"),
    [
        ((1.0, 0.7, 1.0, 0.0), (1.0, 0.3, 1.0, 0.0), 0),  # it overturns all the same
        ((0.6, 0.6, 0.0, 0.0), (0.6, 0.1, 0.0, 0.0), 0),
        ((0.6, 0.9, 0.0, 0.0), (0.6, 0.1, 0.0, 0.0), 1),  # of those that stand fewer slide
        ((0.0, 0.9, 0.0, 0.0), (0.0, 0.1, 0.0, 0.0), 1),
        ((0.3, 0.9, 0.0, 0.0), (0.301, 0.35, 0.0, 0.0), 0),  # alike in the ranking, but not less
        ((0.5, 0.5, 0.5, 0.0), (0.4, 1.0, 1.0, 1.0), 1),
        ((0.0, 0.0, 0.5, 0.0), (0.0, 0.0, 0.4, 0.2), 0),
        ((math.nan,) * 4, (math.nan,) * 4, 0),
        ((0.3, 0.3, 0.0, 0.0), (math.nan,) * 4, 0),
    ],
)
def test_a_measure_is_best_only_where_it_helps(without, held, best):
    named = dict(zip(("overturned", "slid", "hit_wall", "device_failed"), range(4), strict=True))
    rows = [[row[named[event]] for event in EVENTS] for row in (without, held)]
    assert choose(chances(*rows), [0, 1], None, None).best == best


@pytest.mark.parametrize(
    ("motions", "finding", "cells", "sentences"),
    [
        (80, "needs_none", ("needs none", "対策不要"), ("No measure is needed for 1 piece", "対策不要です")),
        (
            3,
            "too_few_runs",
            ("not enough runs to tell", "計算数が足りず判定できない"),
            ("76 motions at least", "少なくとも76本の地震動が必要"),
        ),
    ],
)
def test_a_piece_that_never_overturns_needs_no_measure_where_the_runs_can_tell(
    tmp_path, motions, finding, cells, sentences
):
    file = table(tmp_path, ["a,2,0.2,80,wedge"], "id,width,height,mass,measures")
    quiet = city(tmp_path, CITY.replace("6.0", "3.0").replace("count = 3", f"count = {motions}"))
    done = assess(file, quiet, tmp_path / "out", export="csv", progress=False)
    total = done.summary.events["city"]
    (row,) = rows_of_results(done)
    assert row["finding"] == finding
    assert dict(total.findings) == {finding: 1}
    assert f",{finding}," in (tmp_path / "out" / "pieces.csv").read_text(encoding="utf-8-sig")
    assert done.folder.joinpath("summary.csv").read_text(encoding="utf-8-sig").count(f"pieces_{finding}") == 1
    for language, cell, sentence in zip(("en", "ja"), cells, sentences, strict=True):
        page = done.report(language).read_text(encoding="utf-8")
        assert f'<td class="words">{cell}</td>' in page
        assert sentence in page
        assert sentence in say(findings_told(total), language)
        assert (UNTOLD in page.partition('<div class="maps">')[2]) == (finding == "too_few_runs")
    for name in ("summary.csv", "rejects.csv"):  # by the mark a spreadsheet knows UTF-8
        assert (tmp_path / "out" / name).read_bytes().startswith(b"\xef\xbb\xbf")


def test_a_measure_that_only_keeps_a_piece_in_its_place_is_said_to(tmp_path):
    """It overturns with it as often as without."""
    low = table(tmp_path, ["a,1,0.5,80,l_bracket"], "id,width,height,mass,measures")
    strong = CITY.replace("6.0", "6.8").replace("count = 3", "count = 30")
    done = assess(low, city(tmp_path, strong), tmp_path / "out", progress=False)
    (row,) = rows_of_results(done)
    assert (row["overturned"], row["best_lessens"], row["finding"]) == (0.0, "slid", "helped")
    for language, cell in (
        ("en", "l_bracket, against sliding too far"),
        ("ja", "L型金具（ねじ留め）、移動の抑制"),
    ):
        assert f">{cell}</td>" in done.report(language).read_text(encoding="utf-8")


def test_what_a_measure_helps_against_is_counted():
    row = dict.fromkeys(READ, 0.0) | {"count": 2, "expected_loss": None, "best_contents_out_share": None}
    total = Total()
    for finding, event in (("helped", "slid"), ("helped", "overturned"), ("may_be_chance", "hit_wall")):
        total.add(row | {"finding": finding, "best_lessens": event})
    total.add(row | {"finding": "not_helped", "best_lessens": None})
    english, japanese = findings_told(total)
    assert "helps 4 pieces by more than chance (2 against overturning; 2 against sliding too far)" in english
    assert "For 2 pieces a measure does better (2 against hitting a wall), which may" in english
    assert "4点には、偶然の差を超えて効果のある対策があります（転倒の防止2点、移動の抑制2点）" in japanese
    assert "対策がありますが（壁への衝突の防止2点）、計算数が少なく" in japanese
