"""A verdict on a room as a self-contained HTML page."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from markupsafe import Markup, escape

from stayput.catalogue import say
from stayput.report.page import framed, rendered, write_page
from stayput.report.room.assumptions import assumptions_of_room
from stayput.report.room.drawing import change_plan, legend, room_plan
from stayput.report.room.rows import (
    change_rows,
    collision_rows,
    door_rows,
    hit_rows,
    piece_rows,
    place_rows,
)
from stayput.report.room.tables import sentences, simulations_of_room
from stayput.report.verdict import numbers
from stayput.report.verdict.words import word
from stayput.rooms.events import PASSAGE
from stayput.rooms.verdict import DAY_HOURS
from stayput.verification.words import class_label

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.rooms.verdict import RoomVerdict

SHEETS = ("verdict/report.css", "canvas/plan.css", "room/plan.css", "room/room.css")
"""Style sheets of the report: those of a verdict, of plans, of their figures, and its own."""


def write_room_report(verdict: RoomVerdict, path: str | Path, language: str = "en") -> Path:
    """Write the report of a verdict on a room: one HTML file that loads nothing from elsewhere.

    Parameters
    ----------
    verdict : RoomVerdict
        The verdict.
    path : str or Path
        The file, whose name ends in .html.
    language : str
        "en" or "ja".

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    InputError
        Another language, or a path that cannot be written.
    """
    return write_page(path, language, lambda: room_html(verdict, language))


def room_html(verdict: RoomVerdict, language: str = "en") -> str:
    """Return the text of a report; see `write_room_report`."""
    return rendered("room/room.html", _content(verdict, language))


def _content(verdict: RoomVerdict, language: str) -> dict[str, Any]:
    text = partial(word, language=language)
    headline, *others = sentences(verdict, language)
    moved = change_plan(verdict, language)
    kind = say("rooms.report", language)
    return {
        **framed(language, "room_report", verdict.scenario.title or kind, SHEETS),
        "kind": kind,
        "text": text,
        "numbers": numbers,
        "verdict": verdict,
        "headline": headline,
        "others": others,
        "strength": text(
            "instrumental",
            **{
                "class": class_label(verdict.intensity, language, verdict.floor),
                "value": f"{verdict.intensity:.2f}",
            },
        ),
        "simulations": simulations_of_room(verdict, language),
        "plan": Markup(room_plan(verdict, language)),
        "legend": [(Markup(swatch), name) for swatch, name in legend(verdict, language)],
        "hours": {"day": DAY_HOURS, "night": 24.0 - DAY_HOURS},
        "passage": PASSAGE,
        "ways_out": any(one.door.way_out for one in verdict.doors),
        "limit": numbers.length(verdict.slide_limit, language),
        "places": place_rows(verdict, language),
        "hits": hit_rows(verdict, language),
        "doors": door_rows(verdict, language),
        "pieces": piece_rows(verdict, language),
        "collisions": collision_rows(verdict, language),
        "changes": change_rows(verdict, language),
        "moved": None if moved is None else (Markup(moved[0]), moved[1]),
        "assumptions": [
            (entry.what(language), entry.value(language), entry.confidence)
            for entry in assumptions_of_room(verdict)
        ],
        "toml": escape(verdict.scenario.to_toml()),
    }
