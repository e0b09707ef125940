"""The report of an assessment: one HTML page with maps of risk by storey."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any

from stayput.catalogue import say
from stayput.fragility.probabilities import percent
from stayput.inventory.items import NO_MEASURE
from stayput.inventory.results import Finding
from stayput.inventory.words import (
    against_event,
    amount,
    building_named,
    counted_phrase,
    done,
    expected,
    first_of,
    further,
    impossible_told,
    interval_told,
    measures_named,
    narrow_told,
    pieces_counted,
    reason_told,
    rows_counted,
    rows_told,
    share_of,
    share_told,
    tell,
)
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.names import given_name
from stayput.report.page import framed, rendered
from stayput.report.palette import INK, PAPER, rgb

if TYPE_CHECKING:
    from collections.abc import Mapping

    from stayput.inventory.summary import Summary, Total

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
