"""What a user keeps: a scenario file, histories and rankings as tables, the report."""

from __future__ import annotations

import csv
import io
import threading
from typing import TYPE_CHECKING

from starlette.responses import Response

from stayput.app.running import run_of, yours
from stayput.report.history import history
from stayput.scenario.writing import scenario_toml

if TYPE_CHECKING:
    from stayput.app.motions import Motions
    from stayput.scenario import Scenario
    from stayput.verification import Verdict

_drawing = threading.Lock()  # Matplotlib draws on one thread at a time


def attachment(content: str | bytes, name: str, kind: str) -> Response:
    """Return a file to be saved."""
    headers = {"Content-Disposition": f'attachment; filename="{name}"', "Content-Type": kind}
    return Response(content, headers=headers)


def scene_toml(scenario: Scenario, motions: Motions) -> str:
    """Return a scene as a scenario file; an uploaded record goes by its own file's name.

    Parameters
    ----------
    scenario : Scenario
        The scene.
    motions : Motions
        What was uploaded.
    """
    shaking = scenario.shaking
    names = {key: value for key in ("record", "vertical") if isinstance(value := getattr(shaking, key), str)}
    if not names:
        return scenario_toml(scenario)
    changed = shaking.model_copy(update={key: motions.label(value) for key, value in names.items()})
    note = "# Put the record's file beside this one.\n"
    return note + scenario_toml(scenario.model_copy(update={"shaking": changed}))


def run_csv(scenario: Scenario, *, held: bool) -> str:
    """Return the histories of a run as a table, one line for each sample of the record.

    Parameters
    ----------
    scenario : Scenario
        The scene.
    held : bool
        Whether the user's measures are in place.
    """
    run = run_of(scenario, scenario.case().motion, yours(scenario) if held else ())
    shown = history(run)
    names = ("time_s", "x_m", "z_m", "tilt_rad", "slide_m", "mode")
    columns = (shown.time, shown.x, shown.z, shown.tilt, shown.slide)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(names)
    for *values, mode in zip(*(column.tolist() for column in columns), shown.mode, strict=True):
        writer.writerow([*(f"{value:.9g}" for value in values), mode.value])
    return text.getvalue()


def report_page(verdict: Verdict, language: str, motions: Motions) -> bytes:
    """Return the report of a verdict: one HTML file.

    Parameters
    ----------
    verdict : Verdict
        What came out.
    language : str
        "en" or "ja".
    motions : Motions
        What was uploaded.
    """
    from stayput.report.verdict.html import report_html  # Matplotlib takes its time to load

    with _drawing:
        return motions.named(report_html(verdict, language)).encode("utf-8")
