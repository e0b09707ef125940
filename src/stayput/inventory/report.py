"""The report of an assessment: one HTML page with maps of risk by storey."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any
from unicodedata import east_asian_width

from markupsafe import Markup

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
from stayput.report.verdict.svg import element, label

if TYPE_CHECKING:
    from collections.abc import Mapping

    from stayput.inventory.summary import Summary, Total

MOST_BUILDINGS = 40
"""Buildings that a map shows: those where most is expected to overturn."""

CELL, ROW, LEFT, TOP, SLANT = 46.0, 24.0, 64.0, 10.0, 4.7
"""Sizes of a map [px]: of a cell, room for the storeys and above, height of a slanted letter."""

LONGEST_NAME = 40
"""Cells of a building's name that a map shows; a Japanese letter has two."""

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
    totals: Mapping[tuple[str, int], Total],
    best: bool,
    name: str,
    language: str = "en",
    roofs: Mapping[str, int] = {},
) -> str:
    """Return a map of risk: storeys over buildings, each cell with its share in per cent, as SVG.

    Parameters
    ----------
    totals : mapping
        Totals by building and storey.
    best : bool
        Whether with the best measures.
    name : str
        What the map shows, for those who hear it.
    language : str
        "en" or "ja".
    roofs : mapping
        Number of the roof of each building that has a piece there.
    """
    fallen: dict[str, float] = {}
    for (building, _), total in totals.items():
        fallen[building] = fallen.get(building, 0.0) + total.fallen
    buildings = sorted(sorted(fallen, key=lambda name: -fallen[name])[:MOST_BUILDINGS], key=_by_number)
    called = {building: building_named(building, language) for building in buildings}
    storeys = _storeys({storey for building, storey in totals if building in buildings})
    longest = min(max(map(_cells, called.values())), LONGEST_NAME)
    height = TOP + ROW * len(storeys) + 24.0 + SLANT * longest
    width = LEFT + CELL * len(buildings) + 1.2 * SLANT * longest
    parts: list[str] = []
    for j, storey in enumerate(storeys):
        y = TOP + ROW * j
        here = [building for building in buildings if (building, storey) in totals]
        roof = bool(here) and all(roofs.get(building) == storey for building in here)
        parts.append(label(LEFT - 8.0, y + 0.7 * ROW, _floor(storey, language, roof), "axis", "end"))
        for i, building in enumerate(buildings):
            total = totals.get((building, storey))
            if total is not None:
                floor = _floor(storey, language, roofs.get(building) == storey)
                where = tell("place", language, building=called[building], floor=floor)
                parts.append(_map_cell(LEFT + CELL * i, y, total, best, where, language))
    y = TOP + ROW * len(storeys) + 12.0
    for i, building in enumerate(buildings):
        x = LEFT + CELL * (i + 0.5)
        text = _shortened(called[building])
        tooltip = element("title", Markup.escape(called[building])) if text != called[building] else ""
        parts.append(
            element(
                "text",
                tooltip + str(Markup.escape(text)),
                x=x,
                y=y,
                class_="axis",
                text_anchor="start",
                transform=f"rotate(40 {x:.1f} {y:.1f})",
            )
        )
    box = f"0 0 {width:.0f} {height:.0f}"
    title = element("title", Markup.escape(name))
    return element(
        "svg", title + "".join(parts), viewBox=box, width=width, height=height, role="img", aria_label=name
    )


def _cells(text: str) -> int:
    """Return the width of a text, in which a Japanese letter has two cells."""
    return sum(2 if east_asian_width(letter) in "WF" else 1 for letter in text)


def _shortened(name: str) -> str:
    """Return a name in at most `LONGEST_NAME` cells."""
    if _cells(name) <= LONGEST_NAME:
        return name
    while _cells(name) >= LONGEST_NAME:
        name = name[:-1]
    return f"{name}…"


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


def _map_cell(x: float, y: float, total: Total, best: bool, where: str, language: str) -> str:
    which = "_best" if best else ""
    share, untold = total.share(which), total.untold(which)
    fill = "#ffffff" if math.isnan(share) else UNTOLD if untold else colour(share)
    text_shown = "?" if math.isnan(share) else f"{percent(share)}?" if untold else percent(share)
    shown = "?" if math.isnan(share) else share_of(total, which, language)
    told = tell("cell", language, place=where, share=shown, pieces=pieces_counted(total.pieces))
    title = element("title", Markup.escape(told))
    box = element("rect", title, x=x, y=y, width=CELL - 2.0, height=ROW - 2.0, fill=fill, class_="cell")
    text = element(
        "text",
        str(Markup.escape(text_shown)),
        x=x + 0.5 * CELL - 1.0,
        y=y + 0.68 * ROW,
        class_="share",
        text_anchor="middle",
        fill=_ink(fill),
    )
    return box + text


def report_html(
    summary: Summary,
    facts: Mapping[str, Any],
    manifest: Mapping[str, Any],
    language: str = "en",
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
                "rows": rows_told(found, language),
                "pieces": first_of([_called(row) for row in found["first"]], found["rows"], language),
                "reason": reason_told(found, language),
            }
            for found in facts["rejects alike"]
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
    names = {best: tell("map_best" if best else "map_without", language) for best in (False, True)}
    return {
        "event": event,
        "expected": expected(total, language),
        "more": further(total, language),
        "left_out": tell("left_out", language, buildings=more, verb=verb) if left_out > 0 else "",
        "without": Markup(storey_map(totals, False, f"{event}: {names[False]}", language, roofs)),
        "best": Markup(storey_map(totals, True, f"{event}: {names[True]}", language, roofs)),
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
