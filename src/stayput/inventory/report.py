"""What an assessment came to, in sentences for its report and the terminal, and the report: one HTML page."""

from __future__ import annotations

import math
import re
from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from stayput.catalogue import LANGUAGES, Language, Phrase, is_phrase, phrase
from stayput.fragility.probabilities import percent
from stayput.inventory.items import NO_MEASURE
from stayput.inventory.results import Finding, least_motions
from stayput.measures import MEASURES
from stayput.montecarlo.counting import OVERTURNED, RANKING_ORDER
from stayput.report.names import given_name
from stayput.report.page import framed, rendered
from stayput.report.palette import INK, PAPER, rgb
from stayput.verification.contents import MOTIONS
from stayput.verification.words import SAFE
from stayput.wording import counted, joined

if TYPE_CHECKING:
    from stayput.inventory.summary import Summary, Total

_SHEET = re.compile(r"sheet (?P<name>'.*?')(?:; not (?P<others>.*))?")
"""How a sheet of a workbook is called in the facts."""

NOTHING: Phrase = ("", "")
"""What is said where there is nothing to say."""


def tell(key: str, **values: object) -> Phrase:
    """Return a text about an assessment."""
    return phrase(f"inventory_report.{key}", **values)


def in_language(content: Any, language: Language) -> Any:
    """Return lists and mappings with the phrases in them in a language."""
    if is_phrase(content):
        return content[LANGUAGES.index(language)]
    if isinstance(content, dict):
        items = cast("dict[str, Any]", content).items()
        return {key: in_language(value, language) for key, value in items}
    if isinstance(content, list | tuple):
        return [in_language(value, language) for value in cast("Sequence[Any]", content)]
    return content


def in_one(sentences: Iterable[Phrase]) -> Phrase:
    """Return sentences after each other; empty ones are left out."""
    kept = [sentence for sentence in sentences if sentence != NOTHING]
    return joined(kept, (" ", "")) if kept else NOTHING


def named(name: str) -> Phrase:
    """Return a name, in each language where stayput gave it."""
    return name, given_name(name, "ja")


def counted_phrase(number: int, noun: str, counter: str) -> Phrase:
    """Return a number with its noun in English, and with its counter in Japanese."""
    return counted(number, noun), f"{number:,}{counter}"


def pieces_counted(number: int) -> Phrase:
    """Return a number of pieces."""
    return counted_phrase(number, "piece", "点")


def rows_counted(number: int) -> Phrase:
    """Return a number of rows."""
    return counted_phrase(number, "row", "行")


def empty_told(facts: Mapping[str, Any]) -> Phrase:
    """Return in which columns cells are empty, and what holds there; empty where none is."""
    empty = facts["empty cells"].items()
    counts = [tell("empty_column", column=column, rows=rows_counted(rows)) for column, rows in empty]
    return tell("empty_cells", columns=joined(counts)) if counts else NOTHING


def first_of(items: Sequence[str], total: int) -> Phrase:
    """Return the first few of more items, as "2, 3, 4, …"."""
    shown = [*items, "…"] if total > len(items) else items
    return ", ".join(shown), "、".join(shown)


def rows_told(finding: Mapping[str, Any]) -> Phrase:
    """Return how many rows have a finding in common, and which are the first of them."""
    places = first_of([str(row["row"]) for row in finding["first"]], finding["rows"])
    return tell("rows_alike", rows=rows_counted(finding["rows"]), places=places)


def reason_told(finding: Mapping[str, Any]) -> Phrase:
    """Return the reason of a finding; that of its first row as an example, where others differ from it."""
    reason = finding["reason"], finding["reason_ja"]
    return reason if finding["same"] else tell("such_as", reason=reason)


def notes_told(facts: Mapping[str, Any]) -> list[Phrase]:
    """Return what is special about some rows: their shape, mass and fixing, and measures not possible."""
    rows = facts["without mass"]
    notes = [tell("without_mass", rows=rows_counted(rows))] if rows else []
    notes += each_told("fixed", facts["fixed"])
    return notes + each_told("not_possible", facts["measures not possible"])


def engine_told(facts: Mapping[str, Any]) -> Phrase:
    """Return which pieces are run in the plane, and what that leaves out; nothing where none are."""
    rows = facts["in the plane"]
    return tell("in_plane", rows=rows_counted(rows)) if rows else NOTHING


def each_told(key: str, findings: Sequence[Mapping[str, Any]]) -> list[Phrase]:
    """Return a text for each finding, with its rows, its reason and the measures that it is about."""
    return [
        tell(key, name=measures_named(each["about"]), rows=rows_told(each), reason=reason_told(each))
        for each in findings
    ]


def share_told(value: float | None) -> Phrase:
    """Return a share in per cent; empty where there is none."""
    return NOTHING if value is None else tell("share", value=percent(value))


def interval_told(value: Callable[[str], float]) -> Phrase:
    """Return a probability with its interval, of a function of "", "_low" and "_high"."""
    estimate, low, high = (percent(value(end)) for end in ("", "_low", "_high"))
    return phrase("fragility.probability", estimate=estimate, low=low, high=high)


def share_of(total: Total, which: str) -> Phrase:
    """Return the share that overturns with its interval; with "_best" of the best measures."""
    if total.pieces == total.unknown:
        return tell("given_up")
    return interval_told(lambda end: total.share(f"{which}{end}"))


def amount(value: float | None, currency: str) -> str:
    """Return an amount of money in a currency, "" where it is not known; empty where there is none."""
    return "" if value is None else f"{value:,.0f} {currency}".rstrip()


def measures_named(name: str) -> Phrase:
    """Return a set of measures as it is called in each language; a name of one's own stays as it is."""
    parts = map(str.strip, name.split("+"))
    return name, "+".join(MEASURES[part].label[1] if part in MEASURES else part for part in parts)


def read_as(facts: Mapping[str, Any]) -> Phrase:
    """Return how a table was read, and how many of its rows are empty."""
    how: Phrase = facts["read as"], facts["read as"]
    encoding, _, between = facts["read as"].partition(" with ")
    if between in ("tabs", "semicolons", "bars"):
        how = tell(f"with_{between}", encoding=encoding)
    elif sheet := _SHEET.fullmatch(facts["read as"]):
        how = tell("sheet" if sheet["others"] is None else "sheet_of_several", **sheet.groupdict())
    empty = facts["empty rows"]
    return tell("and_empty", how=how, count=empty) if empty else how


def expected(total: Total) -> Phrase:
    """Return how many pieces are expected to overturn, without and with the best measures."""
    best = NOTHING
    if total.fallen["_best"] < total.fallen[""]:
        best = tell("expected_best", fallen=f"{total.fallen['_best']:,.1f}", share=share_of(total, "_best"))
    return tell(
        "expected",
        fallen=f"{total.fallen['']:,.1f}",
        pieces=pieces_counted(total.pieces),
        verb=("is" if total.pieces == 1 else "are", ""),
        share=share_of(total, ""),
        best=best,
    )


def findings_told(total: Total) -> Phrase:
    """Return what the runs show: of how many pieces a measure helps, none is needed, or nothing is shown."""
    sentences: list[Phrase] = []
    for finding in filter(total.findings.get, Finding):
        lessened = [
            tell("against_counted", count=count, against=tell(f"against_{event}"))
            for event in RANKING_ORDER
            if (count := total.lessened[finding, event])
        ]
        against, pieces = joined(lessened) if lessened else "", pieces_counted(total.findings[finding])
        values = {"pieces": pieces, "against": against, "safe": percent(SAFE), "least": least_motions()}
        sentences.append(tell(f"{finding}_counted", **values))
    return in_one(sentences)


def further(total: Total, currency: str) -> Phrase:
    """Return what else is known of the pieces: what helps, the loss, what comes out, what is unknown."""
    sentences = [findings_told(total)]
    if total.loss is not None:
        loss, best = (amount(value, currency) for value in (total.loss, total.loss_best))
        unstated = "" if currency else tell("currency_unstated")
        sentences.append(tell("expected_loss", loss=loss, best=best, unstated=unstated))
    sentences.append(inside_told(total))
    if total.unknown:
        sentences.append(tell("nothing_known", pieces=pieces_counted(total.unknown)))
    return in_one(sentences)


def inside_told(total: Total) -> Phrase:
    """Return what share of the contents comes out; empty where there are none."""
    if not total.filled:
        return NOTHING
    share, best = (share_told(total.share_out(which)) for which in ("", "_best"))
    return tell("inside_out", pieces=pieces_counted(total.filled), share=share, best=best)


def done(facts: Mapping[str, Any], manifest: Mapping[str, Any], contents: bool) -> list[Phrase]:
    """Return what was read and computed, a sentence or two each.

    Parameters
    ----------
    facts : mapping
        What is known of the plan.
    manifest : mapping
        What the manifest says of the assessment.
    contents : bool
        Whether there is anything inside the pieces.
    """
    read = tell("read", rows=rows_counted(facts["rows"]), how=read_as(facts))
    choices = counted_phrase(facts["choices"], "combination", "通り")
    return [
        in_one([read, *reversed(_columns_told(facts)), empty_told(facts)]),
        *map(_scenario, manifest["scenarios"]),
        tell("units", choices=choices, units=f"{facts['units']:,}"),
        tell("slide_limit", limit=manifest["slide limit"]),
        *([tell("contents_followed", most=MOTIONS)] if contents else []),
        tell("intervals"),
        tell("best_chosen"),
        *([tell("shake_map", map=tuple(manifest["shake map"]))] if manifest["shake map"] else []),
        tell("version", version=manifest["version"]),
    ]


def _scenario(scenario: Mapping[str, Any]) -> Phrase:
    level, suite = scenario["intensity"], scenario["suite"]
    return tell(
        "scenario",
        name=scenario["name"],
        strength="" if level is None else tell("at_intensity", value=level),
        suite=named(suite) if suite else tell("one_motion"),
        motions=counted_phrase(scenario["motions"], "motion", "本"),
        synthetic=tell("synthetic") if scenario["synthetic"] else "",
        samples=counted_phrase(scenario["samples"], "Monte Carlo sample", "組"),
        seed=scenario["seed"],
    )


def printed_lines(
    facts: Mapping[str, Any], events: Mapping[str, Total], runs: int, on_map: bool
) -> list[Phrase]:
    """Return what a terminal shows of an assessment, line by line.

    Parameters
    ----------
    facts : mapping
        What is known of the plan.
    events : mapping
        Totals by event.
    runs : int
        Simulations that were done.
    on_map : bool
        Whether the pieces are exported for a map.
    """
    rows, pieces = rows_counted(facts["rows"]), f"{facts['pieces']:,}"
    read = tell("printed_read", rows=rows, how=read_as(facts), pieces=pieces)
    lines = [engine_told(facts), read, *_columns_told(facts)]
    if facts["rejects"]:
        lines.append(tell("printed_rejects", rows=rows_counted(facts["rejects"])))
    lines += [*each_told("reason_of_rows", facts["rejects alike"]), empty_told(facts)]
    without = facts["pieces"] - facts["with coordinates"]
    if without and (on_map or without < facts["pieces"]):
        lines.append(tell("without_coordinates", pieces=pieces_counted(without)))
    choices = counted_phrase(facts["choices"], "combination", "通り")
    done_runs = counted_phrase(runs, "run", "回")
    lines.append(tell("printed_runs", choices=choices, units=f"{facts['units']:,}", runs=done_runs))
    for name, total in events.items():
        lines.append(tell("of_event", event=name, expected=expected(total)))
        lines += findings_told(total), inside_told(total)
    lines += notes_told(facts)
    return [line for line in lines if line != NOTHING]


def _columns_told(facts: Mapping[str, Any]) -> list[Phrase]:
    """Return how the columns were understood, and which were not used."""
    return [
        tell(key, columns=", ".join(facts[name]))
        for key, name in (("renamed", "columns renamed"), ("not_used", "columns not used"))
        if facts[name]
    ]


MOST_BUILDINGS = 40
"""Buildings that a map shows: those where most is expected to overturn."""

RAMP = ("#f7fbff", "#fdd49e", "#fc8d59", "#d7301f", "#7f0000")
"""Colours from 0 to 100 %: light to dark, so that they tell without hue as well."""

UNTOLD = "#c8ccd0"
"""Colour where the runs are too few to tell."""


def colour(share: float) -> str:
    """Return the colour of a share."""
    stops = np.linspace(0.0, 1.0, len(RAMP))
    mix = (round(np.interp(share, stops, parts)) for parts in zip(*map(rgb, RAMP), strict=True))
    return "#" + "".join(f"{value:02x}" for value in mix)


def _ink(fill: str) -> str:
    red, green, blue = rgb(fill)
    return INK if 0.299 * red + 0.587 * green + 0.114 * blue > 140.0 else PAPER


def storey_map(
    totals: Mapping[tuple[str, int], Total], best: bool, roofs: Mapping[str, int] = {}
) -> dict[str, Any]:
    """Return a map of risk: storeys over buildings, each cell with its share in per cent.

    Parameters
    ----------
    totals : mapping
        Totals by building and storey.
    best : bool
        Whether with the best measures.
    roofs : mapping
        Number of the roof of each building that has a piece there.
    """
    fallen = defaultdict[str, float](float)
    for (building, _), total in totals.items():
        fallen[building] += total.fallen[""]
    buildings = sorted(sorted(fallen, key=lambda name: -fallen[name])[:MOST_BUILDINGS], key=_by_number)
    called = {building: named(building) if building else tell("no_building") for building in buildings}
    rows: list[dict[str, Any]] = []
    for storey in _storeys({storey for building, storey in totals if building in buildings}):
        here = [building for building in buildings if (building, storey) in totals]
        roof = bool(here) and all(roofs.get(building) == storey for building in here)
        cells = dict[str, dict[str, Any]]()
        for building in here:
            floor = _floor(storey, roofs.get(building) == storey)
            where = tell("place", building=called[building], floor=floor)
            cells[building] = _map_cell(totals[building, storey], best, where)
        rows.append({"floor": _floor(storey, roof), "cells": [*map(cells.get, buildings)]})
    return {"buildings": [*called.values()], "rows": rows}


def _map_cell(total: Total, best: bool, where: Phrase) -> dict[str, Any]:
    which = "_best" if best else ""
    share, untold = total.share(which), total.untold(which)
    unknown = math.isnan(share)
    fill = "#ffffff" if unknown else UNTOLD if untold else colour(share)
    text = "?" if unknown else share_of(total, which)
    text = tell("cell", place=where, share=text, pieces=pieces_counted(total.pieces))
    shown = ("" if unknown else percent(share)) + ("?" if unknown or untold else "")
    return {"fill": fill, "ink": _ink(fill), "shown": shown, "told": text}


def _by_number(name: str) -> list[tuple[bool, int, str]]:
    """Return a sort key that takes the numbers in a name by size: 2 wood before 10 RC."""
    parts = re.findall(r"\d+|\D+", name)
    return [(not part.isdecimal(), int(part) if part.isdecimal() else 0, part) for part in parts]


def _storeys(storeys: set[int]) -> list[int]:
    """Return the storeys of a map from the top: none is left out between, or heights would mislead."""
    low = min(0, *storeys)
    return [n for n in range(max(storeys), low - 1, -1) if n or 0 in storeys]


def _floor(storey: int, roof: bool) -> Phrase:
    """Return what a storey is called, the ground being 0."""
    if roof:
        return phrase("motion.roof")
    if not storey:
        return tell("on_ground")
    return tell("floor" if storey > 0 else "basement", storey=abs(storey))


def report_html(
    summary: Summary, facts: Mapping[str, Any], manifest: Mapping[str, Any], language: Language = "en"
) -> str:
    """Return the report as HTML.

    Parameters
    ----------
    summary : Summary
        What the results come to.
    facts : mapping
        What is known of the plan.
    manifest : mapping
        What the manifest says of the assessment.
    language : str
        "en" or "ja".
    """
    roofs, rejects = facts["roofs"], facts["rejects alike"]
    contents = any(row["contents_out_share"] is not None for row in summary.worst)
    rows = rows_counted(facts["rows"] - facts["empty rows"])
    shares = [(share_told(share), colour(share)) for share in (0.0, 0.25, 0.5, 0.75, 1.0)]
    content = {
        "maps": [_map(event, summary, roofs, facts["currency"]) for event in summary.events],
        "several": len(summary.events) > 1,
        "worst": [_piece(row, roofs, facts["currency"]) for row in summary.worst],
        "contents": contents,
        "by_cost": any(row["best_by_cost"] is not None for row in summary.worst),
        "engine": engine_told(facts),
        "notes": notes_told(facts),
        "rejects": [
            {
                "rows": rows_told(finding),
                "pieces": first_of([_called(row) for row in finding["first"]], finding["rows"]),
                "reason": reason_told(finding),
            }
            for finding in rejects
        ],
        "rejects_counted": tell("rejects_counted", rejects=f"{facts['rejects']:,}", rows=rows),
        "done": done(facts, manifest, contents),
        "ramp": [(name, fill, _ink(fill)) for name, fill in (*shares, (tell(Finding.TOO_FEW_RUNS), UNTOLD))],
    }
    title = in_language(tell("title"), language)
    head = framed(language, "inventory_report", title, ["inventory/inventory.css"])
    return rendered("inventory/inventory.html", head | in_language(content, language))


def _map(event: str, summary: Summary, roofs: Mapping[str, int], currency: str) -> dict[str, Any]:
    totals = {(b, s): total for (e, b, s), total in summary.places.items() if e == event}
    total, buildings = summary.events[event], len({building for building, _ in totals})
    left_out = buildings - MOST_BUILDINGS
    more = counted_phrase(left_out, "more building", "棟")
    verb = ("is" if left_out == 1 else "are", "")
    without, best = storey_map(totals, False, roofs), storey_map(totals, True, roofs)
    return {
        "event": event,
        "expected": expected(total),
        "more": further(total, currency),
        "left_out": tell("left_out", buildings=more, verb=verb) if left_out > 0 else "",
        "without": without,
        "best": best if best != without else None,
    }


def _piece(row: Mapping[str, Any], roofs: Mapping[str, int], currency: str) -> dict[str, Any]:
    """Return the cells of a piece at risk."""
    helped, best = row["best"] != NO_MEASURE, measures_named(row["best"])
    by_cost, storey, lessens = row["best_by_cost"], row["storey"], row["best_lessens"]
    if lessens not in (None, OVERTURNED):  # which the columns beside it do not show
        best = tell("best_against", measure=best, against=tell(f"against_{lessens}"))
    return {
        **{key: row[key] for key in ("row", "event", "count")},
        "piece": _called(row),
        "fixed": measures_named(row["fixed"] or ""),
        "building": named(row["building"] or ""),
        "storey": _floor(storey, roofs.get(row["building"]) == storey) if storey else "",
        "overturned": interval_told(lambda end: row[f"overturned{end}"]),
        "out": share_told(row["contents_out_share"]),
        "best": best if row["finding"] == Finding.HELPED else tell(row["finding"], measure=best),
        "best_overturned": interval_told(lambda end: row[f"best_overturned{end}"]) if helped else "",
        "best_out": share_told(row["best_contents_out_share"]) if helped else "",
        "best_by_cost": tell("not_worth") if by_cost == NO_MEASURE else measures_named(by_cost or ""),
        "loss": amount(row["expected_loss"], currency),
    }


def _called(row: Mapping[str, Any]) -> str:
    """Return a piece's id with its name, unless the id has been made of the name."""
    piece, name = row["id"], row["name"]
    return piece if not name or piece in (name, f"{name} #{row['row']}") else f"{piece} {name}".strip()
