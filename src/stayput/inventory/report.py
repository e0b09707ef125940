"""What an assessment came to, in sentences for its report and the terminal, and the report: one HTML page."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any

from stayput.catalogue import phrase, say
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
from stayput.wording import counted

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, Sequence

    from stayput.catalogue import Phrase
    from stayput.inventory.summary import Summary, Total

_SHEET = re.compile(r"sheet (?P<name>'.*?')(?:; not (?P<others>.*))?")
"""How a sheet of a workbook is called in the facts."""


def tell(key: str, language: str, **values: object) -> str:
    """Return a text about an assessment."""
    return say(f"inventory_report.{key}", language, **values)


def joined(sentences: Iterable[str], language: str) -> str:
    """Return sentences after each other; empty ones are left out."""
    return (" " if language == "en" else "").join(filter(None, sentences))


def counted_phrase(number: int, noun: str, counter: str) -> Phrase:
    """Return a number with its noun in English, and with its counter in Japanese."""
    return counted(number, noun), f"{number:,}{counter}"


def pieces_counted(number: int) -> Phrase:
    """Return a number of pieces."""
    return counted_phrase(number, "piece", "点")


def rows_counted(number: int) -> Phrase:
    """Return a number of rows."""
    return counted_phrase(number, "row", "行")


def narrow_told(facts: Mapping[str, Any], language: str) -> str:
    """Return how many rows are narrower than deep; empty where none is."""
    narrow = facts["narrower than deep"]
    return tell("narrow", language, rows=rows_counted(narrow)) if narrow else ""


def empty_told(facts: Mapping[str, Any], language: str) -> str:
    """Return in which columns cells are empty, and what holds there; empty where none is."""
    counts = [
        tell("empty_column", language, column=column, rows=rows_counted(rows))
        for column, rows in facts["empty cells"].items()
    ]
    columns = say("common.listed", language).join(counts)
    return tell("empty_cells", language, columns=columns) if counts else ""


def first_of(items: Sequence[str], total: int, language: str) -> str:
    """Return the first few of more items, as "2, 3, 4, …"."""
    return (", " if language == "en" else "、").join([*items, "…"] if total > len(items) else items)


def rows_told(finding: Mapping[str, Any], language: str) -> str:
    """Return how many rows have a finding in common, and which are the first of them."""
    places = first_of([str(row["row"]) for row in finding["first"]], finding["rows"], language)
    return tell("rows_alike", language, rows=rows_counted(finding["rows"]), places=places)


def reason_told(finding: Mapping[str, Any], language: str) -> str:
    """Return the reason of a finding; that of its first row as an example, where others differ from it."""
    reason = finding["reason" if language == "en" else "reason_ja"]
    return reason if finding["same"] else tell("such_as", language, reason=reason)


def impossible_told(facts: Mapping[str, Any], language: str) -> list[str]:
    """Return which sets of measures cannot be put in place, in which rows, and why."""
    return [
        tell(
            "not_possible",
            language,
            name=measures_named(finding["about"], language),
            rows=rows_told(finding, language),
            reason=reason_told(finding, language),
        )
        for finding in facts["measures not possible"]
    ]


def share_told(value: float | None, language: str) -> str:
    """Return a share in per cent; empty where there is none."""
    if value is None:
        return ""
    if math.isnan(value):
        return say("common.unknown", language)
    return tell("share", language, value=percent(value))


def interval_told(value: Callable[[str], float], language: str) -> str:
    """Return a probability with its interval, of a function of "", "_low" and "_high"."""
    estimate, low, high = (percent(value(end)) for end in ("", "_low", "_high"))
    return say("fragility.probability", language, estimate=estimate, low=low, high=high)


def share_of(total: Total, which: str, language: str) -> str:
    """Return the share that overturns with its interval; with "_best" of the best measures."""
    if total.pieces == total.unknown:
        return tell("given_up", language)
    return interval_told(lambda end: total.share(f"{which}{end}"), language)


def amount(value: float | None) -> str:
    """Return an amount of money; empty where there is none."""
    return "" if value is None else f"{value:,.0f}"


def building_named(building: str, language: str) -> str:
    """Return a building's name, in a language where stayput gave it, or that there is none."""
    return given_name(building, language) if building else tell("no_building", language)


def measures_named(name: str, language: str) -> str:
    """Return a set of measures as it is called in a language; a name of one's own stays as it is."""
    if language == "en":
        return name
    parts = map(str.strip, name.split("+"))
    return "+".join(say(MEASURES[part].label, language) if part in MEASURES else part for part in parts)


def read_as(facts: Mapping[str, Any]) -> Phrase:
    """Return how a table was read, in both languages, and how many of its rows are empty."""
    how: Phrase = facts["read as"], facts["read as"]
    encoding, _, between = facts["read as"].partition(" with ")
    if between in ("tabs", "semicolons", "bars"):
        how = phrase(f"inventory_report.with_{between}", encoding=encoding)
    elif sheet := _SHEET.fullmatch(facts["read as"]):
        key = "sheet" if sheet["others"] is None else "sheet_of_several"
        how = phrase(f"inventory_report.{key}", **sheet.groupdict())
    empty = facts["empty rows"]
    return phrase("inventory_report.and_empty", how=how, count=empty) if empty else how


def expected(total: Total, language: str) -> str:
    """Return how many pieces are expected to overturn, without and with the best measures."""
    best = ""
    if total.fallen_best < total.fallen:
        shared, fallen = share_of(total, "_best", language), f"{total.fallen_best:,.1f}"
        best = tell("expected_best", language, fallen=fallen, share=shared)
    return tell(
        "expected",
        language,
        fallen=f"{total.fallen:,.1f}",
        pieces=pieces_counted(total.pieces),
        verb=("is" if total.pieces == 1 else "are", ""),
        share=share_of(total, "", language),
        best=best,
    )


def against_event(event: str) -> Phrase:
    """Return what a measure helps against that lessens an event."""
    return phrase(f"inventory_report.against_{event}")


def findings_told(total: Total, language: str) -> str:
    """Return what the runs show: of how many pieces a measure helps, none is needed, or nothing is shown."""
    sentences: list[str] = []
    for finding in filter(total.findings.get, Finding):
        lessened = [
            tell("against_counted", language, count=count, against=against_event(event))
            for event in RANKING_ORDER
            if (count := total.lessened[finding, event])
        ]
        values = {"against": say("common.listed", language).join(lessened), "safe": percent(SAFE)}
        pieces, least = pieces_counted(total.findings[finding]), least_motions()
        sentences.append(tell(f"{finding}_counted", language, pieces=pieces, least=least, **values))
    return joined(sentences, language)


def further(total: Total, language: str) -> str:
    """Return what else is known of the pieces: what helps, the loss, what comes out, what is unknown."""
    sentences = [findings_told(total, language)]
    if total.loss is not None:
        loss, best = amount(total.loss), amount(total.loss_best)
        sentences.append(tell("expected_loss", language, loss=loss, best=best))
    sentences.append(inside_told(total, language))
    if total.unknown:
        sentences.append(tell("nothing_known", language, pieces=pieces_counted(total.unknown)))
    return joined(sentences, language)


def inside_told(total: Total, language: str) -> str:
    """Return what share of the contents comes out; empty where there are none."""
    if total.share_out is None:
        return ""
    share, best = (share_told(share, language) for share in (total.share_out, total.share_out_best))
    return tell("inside_out", language, pieces=pieces_counted(total.filled), share=share, best=best)


def done(facts: Mapping[str, Any], manifest: Mapping[str, Any], contents: bool, language: str) -> list[str]:
    """Return what was read and computed, a sentence or two each.

    Parameters
    ----------
    facts : mapping
        What is known of the plan.
    manifest : mapping
        What the manifest says of the assessment.
    contents : bool
        Whether there is anything inside the pieces.
    language : str
        "en" or "ja".
    """
    read = [tell("read", language, rows=rows_counted(facts["rows"]), how=read_as(facts))]
    read += [*reversed(_columns_told(facts, language)), empty_told(facts, language)]
    choices = counted_phrase(facts["choices"], "combination", "通り")
    sentences = [
        joined(read, language),
        *(_scenario(scenario, language) for scenario in manifest["scenarios"]),
        tell("units", language, choices=choices, units=f"{facts['units']:,}"),
        say("verification.in_plane", language),
        tell("slide_limit", language, limit=manifest["slide limit"]),
    ]
    if contents:
        sentences.append(tell("contents_followed", language, most=MOTIONS))
    sentences += [tell("intervals", language), tell("best_chosen", language)]
    if manifest["shake map"]:
        sentences.append(tell("shake_map", language, map=tuple(manifest["shake map"])))
    return [*sentences, tell("version", language, version=manifest["version"])]


def _scenario(scenario: Mapping[str, Any], language: str) -> str:
    level, suite = scenario["intensity"], scenario["suite"]
    return tell(
        "scenario",
        language,
        name=scenario["name"],
        strength="" if level is None else phrase("inventory_report.at_intensity", value=level),
        suite=given_name(suite, language) if suite else phrase("inventory_report.one_motion"),
        motions=counted_phrase(scenario["motions"], "motion", "本"),
        synthetic=phrase("inventory_report.synthetic") if scenario["synthetic"] else "",
        samples=counted_phrase(scenario["samples"], "Monte Carlo sample", "組"),
        seed=scenario["seed"],
    )


def printed_lines(
    facts: Mapping[str, Any], events: Mapping[str, Total], runs: int, on_map: bool, language: str
) -> list[str]:
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
    language : str
        "en" or "ja".
    """
    rows, pieces = rows_counted(facts["rows"]), f"{facts['pieces']:,}"
    lines = [tell("printed_read", language, rows=rows, how=read_as(facts), pieces=pieces)]
    lines += _columns_told(facts, language)
    if facts["rejects"]:
        lines.append(tell("printed_rejects", language, rows=rows_counted(facts["rejects"])))
    for finding in facts["rejects alike"]:
        alike, reason = rows_told(finding, language), reason_told(finding, language)
        lines.append(tell("reason_of_rows", language, rows=alike, reason=reason))
    lines.append(empty_told(facts, language))
    without = facts["pieces"] - facts["with coordinates"]
    if without and (on_map or without < facts["pieces"]):
        lines.append(tell("without_coordinates", language, pieces=pieces_counted(without)))
    choices = counted_phrase(facts["choices"], "combination", "通り")
    done_runs = counted_phrase(runs, "run", "回")
    lines.append(tell("printed_runs", language, choices=choices, units=f"{facts['units']:,}", runs=done_runs))
    for name, total in events.items():
        lines.append(tell("of_event", language, event=name, expected=expected(total, language)))
        lines += findings_told(total, language), inside_told(total, language)
    lines += [narrow_told(facts, language), *impossible_told(facts, language)]
    return list(filter(None, lines))


def _columns_told(facts: Mapping[str, Any], language: str) -> list[str]:
    """Return how the columns were understood, and which were not used."""
    return [
        tell(key, language, columns=", ".join(facts[name]))
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
    place = min(max(share, 0.0), 1.0) * (len(RAMP) - 1)
    low = min(int(place), len(RAMP) - 2)
    mix = (
        round(a + (place - low) * (b - a)) for a, b in zip(rgb(RAMP[low]), rgb(RAMP[low + 1]), strict=True)
    )
    return "#" + "".join(f"{value:02x}" for value in mix)


def _ink(fill: str) -> str:
    red, green, blue = rgb(fill)
    return INK if 0.299 * red + 0.587 * green + 0.114 * blue > 140.0 else PAPER


def storey_map(
    totals: Mapping[tuple[str, int], Total], best: bool, language: str = "en", roofs: Mapping[str, int] = {}
) -> dict[str, Any]:
    """Return a map of risk: storeys over buildings, each cell with its share in per cent.

    Parameters
    ----------
    totals : mapping
        Totals by building and storey.
    best : bool
        Whether with the best measures.
    language : str
        "en" or "ja".
    roofs : mapping
        Number of the roof of each building that has a piece there.
    """
    fallen: dict[str, float] = {}
    for (building, _), total in totals.items():
        fallen[building] = fallen.get(building, 0.0) + total.fallen
    buildings = sorted(sorted(fallen, key=lambda name: -fallen[name])[:MOST_BUILDINGS], key=_by_number)
    rows: list[dict[str, Any]] = []
    for storey in _storeys({storey for building, storey in totals if building in buildings}):
        here = [building for building in buildings if (building, storey) in totals]
        roof = bool(here) and all(roofs.get(building) == storey for building in here)
        cells: list[dict[str, str] | None] = [None] * len(buildings)
        for building in here:
            floor = _floor(storey, language, roofs.get(building) == storey)
            where = tell("place", language, building=building_named(building, language), floor=floor)
            cells[buildings.index(building)] = _map_cell(totals[building, storey], best, where, language)
        rows.append({"floor": _floor(storey, language, roof), "cells": cells})
    return {"buildings": [building_named(building, language) for building in buildings], "rows": rows}


def _map_cell(total: Total, best: bool, where: str, language: str) -> dict[str, str]:
    which = "_best" if best else ""
    share, untold = total.share(which), total.untold(which)
    unknown = math.isnan(share)
    fill = "#ffffff" if unknown else UNTOLD if untold else colour(share)
    text = "?" if unknown else share_of(total, which, language)
    text = tell("cell", language, place=where, share=text, pieces=pieces_counted(total.pieces))
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


def _floor(storey: int, language: str, roof: bool) -> str:
    """Return what a storey is called, the ground being 0."""
    if roof:
        return say("motion.roof", language)
    if not storey:
        return tell("on_ground", language)
    return tell("floor" if storey > 0 else "basement", language, storey=abs(storey))


def report_html(
    summary: Summary, facts: Mapping[str, Any], manifest: Mapping[str, Any], language: str = "en"
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
    maps = [_map(event, summary, facts["roofs"], language) for event in summary.events]
    contents = any(row["contents_out_share"] is not None for row in summary.worst)
    rows = rows_counted(facts["rows"] - facts["empty rows"])
    head = framed(language, "inventory_report", tell("title", language), ["inventory/inventory.css"])
    page = {
        **head,
        "maps": maps,
        "narrow": narrow_told(facts, language),
        "several": len(maps) > 1,
        "worst": [_piece(row, facts["roofs"], language) for row in summary.worst],
        "contents": contents,
        "by_cost": any(row["best_by_cost"] is not None for row in summary.worst),
        "impossible": impossible_told(facts, language),
        "rejects": [
            {
                "rows": rows_told(finding, language),
                "pieces": first_of([_called(row) for row in finding["first"]], finding["rows"], language),
                "reason": reason_told(finding, language),
            }
            for finding in facts["rejects alike"]
        ],
        "rejects_counted": tell("rejects_counted", language, rejects=f"{facts['rejects']:,}", rows=rows),
        "done": done(facts, manifest, contents, language),
        "ramp": [
            (share_told(share, language), colour(share), _ink(colour(share)))
            for share in (0.0, 0.25, 0.5, 0.75, 1.0)
        ]
        + [(tell(Finding.TOO_FEW_RUNS, language), UNTOLD, _ink(UNTOLD))],
    }
    return rendered("inventory/inventory.html", page)


def _map(event: str, summary: Summary, roofs: Mapping[str, int], language: str) -> dict[str, Any]:
    totals = {(b, s): total for (e, b, s), total in summary.places.items() if e == event}
    total, buildings = summary.events[event], len({building for building, _ in totals})
    left_out = buildings - MOST_BUILDINGS
    more = counted_phrase(left_out, "more building", "棟")
    verb = ("is" if left_out == 1 else "are", "")
    return {
        "event": event,
        "expected": expected(total, language),
        "more": further(total, language),
        "left_out": tell("left_out", language, buildings=more, verb=verb) if left_out > 0 else "",
        "without": storey_map(totals, False, language, roofs),
        "best": storey_map(totals, True, language, roofs),
    }


def _piece(row: Mapping[str, Any], roofs: Mapping[str, int], language: str) -> dict[str, Any]:
    """Return the cells of a piece at risk."""
    helped, best = row["best"] != NO_MEASURE, measures_named(row["best"], language)
    by_cost, storey, lessens = row["best_by_cost"], row["storey"], row["best_lessens"]
    if lessens not in (None, OVERTURNED):  # which the columns beside it do not show
        best = tell("best_against", language, measure=best, against=against_event(lessens))
    return {
        **{key: row[key] for key in ("row", "event", "count")},
        "piece": _called(row),
        "building": given_name(row["building"] or "", language),
        "storey": _floor(storey, language, roofs.get(row["building"]) == storey) if storey else "",
        "overturned": interval_told(lambda end: row[f"overturned{end}"], language),
        "out": share_told(row["contents_out_share"], language),
        "best": best if row["finding"] == Finding.HELPED else tell(row["finding"], language, measure=best),
        "best_overturned": interval_told(lambda end: row[f"best_overturned{end}"], language)
        if helped
        else "",
        "best_out": share_told(row["best_contents_out_share"], language) if helped else "",
        "best_by_cost": tell("not_worth", language)
        if by_cost == NO_MEASURE
        else measures_named(by_cost or "", language),
        "loss": amount(row["expected_loss"]),
    }


def _called(row: Mapping[str, Any]) -> str:
    """Return a piece's id with its name, unless the id has been made of the name."""
    piece, name = row["id"], row["name"]
    return piece if not name or piece in (name, f"{name} #{row['row']}") else f"{piece} {name}".strip()
