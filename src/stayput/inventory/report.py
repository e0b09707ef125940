"""The report of an assessment: one HTML page with maps of risk by storey."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup

from stayput.fragility.probabilities import percent
from stayput.inventory.items import NO_MEASURE
from stayput.report.palette import INK, PAPER, rgb
from stayput.report.verdict.svg import element, label
from stayput.verification.contents import MOTIONS
from stayput.wording import counted

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from stayput.inventory.summary import Summary, Total

MOST_BUILDINGS = 40
"""Buildings that a map shows: those where most is expected to overturn."""

REJECTS_SHOWN = 20

SHOWS = "share that overturns, per cent"

CELL, ROW, LEFT, TOP, SLANT = 46.0, 24.0, 64.0, 10.0, 4.7
"""Sizes of a map [px]: of a cell, room for the storeys and above, height of a slanted letter."""

LONGEST_NAME = 22
"""Characters of a building's name that a map shows."""

RAMP = ("#f7fbff", "#fdd49e", "#fc8d59", "#d7301f", "#7f0000")
"""Colours from 0 to 100 %: light to dark, so that they tell without hue as well."""


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


def storey_map(totals: Mapping[tuple[str, int], Total], best: bool, name: str) -> str:
    """Return a map of risk: storeys over buildings, each cell with its share in per cent, as SVG.

    Parameters
    ----------
    totals : mapping
        Totals by building and storey.
    best : bool
        Whether with the best measures.
    name : str
        What the map shows, for those who hear it.
    """
    fallen: dict[str, float] = {}
    for (building, _), total in totals.items():
        fallen[building] = fallen.get(building, 0.0) + total.fallen
    buildings = sorted(sorted(fallen, key=lambda name: -fallen[name])[:MOST_BUILDINGS], key=_by_number)
    storeys = _storeys({storey for building, storey in totals if building in buildings})
    longest = min(max(len(building or "no building") for building in buildings), LONGEST_NAME)
    height = TOP + ROW * len(storeys) + 24.0 + SLANT * longest
    width = LEFT + CELL * len(buildings) + 1.2 * SLANT * longest
    parts: list[str] = []
    for j, storey in enumerate(storeys):
        y = TOP + ROW * j
        floor = f"{storey}F" if storey else "ground"
        parts.append(label(LEFT - 8.0, y + 0.7 * ROW, floor, "axis", "end"))
        for i, building in enumerate(buildings):
            total = totals.get((building, storey))
            if total is not None:
                where = f"{building or 'no building'}, {floor}"
                parts.append(_map_cell(LEFT + CELL * i, y, total, best, where))
    y = TOP + ROW * len(storeys) + 12.0
    for i, building in enumerate(buildings):
        x = LEFT + CELL * (i + 0.5)
        text = building if len(building) <= LONGEST_NAME else f"{building[: LONGEST_NAME - 1]}…"
        tooltip = element("title", Markup.escape(building)) if text != building else ""
        parts.append(
            element(
                "text",
                tooltip + str(Markup.escape(text or "no building")),
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


def _by_number(name: str) -> list[tuple[bool, int, str]]:
    """Return a sort key that takes the numbers in a name by size: 2 wood before 10 RC."""
    parts = re.findall(r"\d+|\D+", name)
    return [(not part.isdecimal(), int(part) if part.isdecimal() else 0, part) for part in parts]


def _storeys(storeys: set[int]) -> list[int]:
    """Return the storeys of a map from the top: none is left out between, or heights would mislead."""
    above = range(max(storeys), 0, -1)
    return [*above, 0] if 0 in storeys else list(above)


def _map_cell(x: float, y: float, total: Total, best: bool, where: str) -> str:
    share = total.share_best if best else total.share
    fill = "#ffffff" if math.isnan(share) else colour(share)
    text_shown = "?" if math.isnan(share) else percent(share)
    title = element("title", Markup.escape(f"{where}: {text_shown} % of {counted(total.pieces, 'piece')}"))
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


def _share(value: float | None) -> str:
    if value is None:
        return ""
    return "unknown" if math.isnan(value) else f"{percent(value)} %"


def _amount(value: float | None) -> str:
    return "" if value is None else f"{value:,.0f}"


def report_html(
    summary: Summary,
    facts: Mapping[str, Any],
    manifest: Mapping[str, Any],
    rejects: Sequence[Mapping[str, Any]],
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
    rejects : sequence
        The first rows that were not assessed.
    """
    maps: list[dict[str, Any]] = []
    for event in summary.events:
        totals = {(b, s): total for (e, b, s), total in summary.places.items() if e == event}
        buildings = len({building for building, _ in totals})
        maps.append(
            {
                "event": event,
                "total": summary.events[event],
                "left_out": max(0, buildings - MOST_BUILDINGS),
                "without": Markup(storey_map(totals, False, f"{event}, no measure: {SHOWS}")),
                "best": Markup(storey_map(totals, True, f"{event}, best measures: {SHOWS}")),
            }
        )
    environment = Environment(
        loader=PackageLoader("stayput.inventory", "."),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["percent"] = percent
    environment.filters["amount"] = _amount
    page = environment.get_template("report.html")
    return page.render(
        counted=counted,
        share=_share,
        maps=maps,
        worst=summary.worst,
        contents=any(row["contents_out_share"] is not None for row in summary.worst),
        by_cost=any(row["best_by_cost"] is not None for row in summary.worst),
        followed=MOTIONS,
        facts=facts,
        manifest=manifest,
        rejects=rejects[:REJECTS_SHOWN],
        no_measure=NO_MEASURE,
        ramp=[(share, colour(share), _ink(colour(share))) for share in (0.0, 0.25, 0.5, 0.75, 1.0)],
    )
