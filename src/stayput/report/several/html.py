"""A verdict on several pieces as a self-contained HTML page."""

from __future__ import annotations

import shlex
from functools import partial
from typing import TYPE_CHECKING, Any

from markupsafe import escape

from stayput.catalogue import say
from stayput.report.page import framed, rendered, write_page
from stayput.report.several.pairs import pairs_of_several
from stayput.report.several.tables import (
    rejected_rows,
    several_assumptions,
    several_device_rows,
    several_rows,
    simulations_of_several,
)
from stayput.report.verdict import numbers
from stayput.report.verdict.tables import DEVICE_COLUMNS
from stayput.report.verdict.words import word
from stayput.verification.words import class_label, headline_of_several

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.verification import AssemblyVerdict


def write_several_report(verdict: AssemblyVerdict, path: str | Path, language: str = "en") -> Path:
    """Write a report of a verdict on several pieces: one HTML file that loads nothing from elsewhere.

    Up to four of the runs are done again for it.

    Parameters
    ----------
    verdict : AssemblyVerdict
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
        Another language, a path that cannot be written, or a record that cannot be read any more.
    """
    return write_page(path, language, lambda: rendered("several/several.html", _content(verdict, language)))


def _content(verdict: AssemblyVerdict, language: str) -> dict[str, Any]:
    scenario, text = verdict.scenario, partial(word, language=language)

    title = scenario.title or say("several.report", language)
    words = ["stayput", "verify", "scenario.toml", "--slide-limit", f"{verdict.slide_limit:g}"]
    return {
        **framed(language, "several", title, ["verdict/report.css"]),
        "text": text,
        "numbers": numbers,
        "verdict": verdict,
        "headline": headline_of_several(verdict, language),
        "strength": text(
            "instrumental",
            **{
                "class": class_label(verdict.intensity, language, verdict.floor),
                "value": f"{verdict.intensity:.2f}",
            },
        ),
        "simulations": simulations_of_several(verdict, language),
        "limit": numbers.length(verdict.slide_limit, language),
        "rows": several_rows(verdict, language),
        "rejected": rejected_rows(verdict, language),
        "pairs": pairs_of_several(verdict, language),
        "device_columns": [say("several.holds", language), *(text(key) for key in DEVICE_COLUMNS)],
        "details": [
            (row, several_device_rows(row.result, language))
            for row in several_rows(verdict, language)
            if row.result.devices
        ],
        "assumptions": [
            (entry.what(language), entry.value(language), entry.confidence)
            for entry in several_assumptions(verdict)
        ],
        "toml": escape(scenario.to_toml()),
        "command": escape(shlex.join([*words, "--lang", language, "--report", "report.html"])),
    }
