"""Files that a user saves: the scenario, histories as a table, films, the report."""

from __future__ import annotations

import csv
import io
import shutil
import tempfile
import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from starlette.responses import Response

from stayput.app.messages import refused
from stayput.app.middleware import REPORT_POLICY
from stayput.app.running import own_measures, runs_of
from stayput.files import harmless
from stayput.report.animation import animate_run
from stayput.report.names import names_of
from stayput.scenario.shaking import RECORD_FILES

if TYPE_CHECKING:
    from stayput.app.limits import Limits
    from stayput.app.motions import Motions
    from stayput.catalogue import Language
    from stayput.scenario import Scenario
    from stayput.simulation.run import Run
    from stayput.verification import Verdict

KINDS = {
    ".csv": {"Content-Type": "text/csv; charset=utf-8"},
    ".gif": {"Content-Type": "image/gif"},
    ".html": {"Content-Type": "text/html; charset=utf-8", "Content-Security-Policy": REPORT_POLICY},
    ".mp4": {"Content-Type": "video/mp4"},
    ".toml": {"Content-Type": "application/toml; charset=utf-8"},
}
"""Headers of files by the ends of their names."""

_drawing = threading.Lock()  # Matplotlib draws on one thread at a time


def attachment(content: str | bytes, name: str) -> Response:
    """Return a file to be saved."""
    headers = {"Content-Disposition": f'attachment; filename="{name}"', **KINDS[Path(name).suffix]}
    return Response(content, headers=headers)


def scene_toml(scenario: Scenario, motions: Motions) -> str:
    """Return a scene as a scenario file; an uploaded record goes by its own file's name.

    Parameters
    ----------
    scenario : Scenario
        The scene.
    motions : Motions
        The uploaded motions, whose names replace their ids.
    """
    shaking = scenario.shaking
    names = {key: value for key in RECORD_FILES if isinstance(value := getattr(shaking, key), str)}
    if not names:
        return scenario.to_toml()
    changed = shaking.model_copy(update={key: motions.with_file_names(value) for key, value in names.items()})
    note = "# Put the record's file beside this one.\n"
    return note + scenario.model_copy(update={"shaking": changed}).to_toml()


def run_csv(scenario: Scenario, *, held: bool, sample: int | None = None) -> str:
    """Return the histories of a run as a table, one line for each piece and sample.

    The floor's motion stands beside them, and the forces of each device: pull along its normal,
    negative where it pushes, and shear along its tangent; in the plane also how the piece moves.

    Parameters
    ----------
    scenario : Scenario
        The scene.
    held : bool
        Whether the user's measures are in place.
    sample : int, optional
        As of `runs_of`.
    """
    run = _shown(scenario, held=held, sample=sample)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    modes = list[str](run.mode.tolist())
    tables = [(name, _of_piece(run, number)) for number, name in enumerate(names_of(run, "en"))]
    writer.writerow(["piece", *tables[0][1], *(["mode"] if modes else [])])
    for name, columns in tables:
        for sample, values in enumerate(zip(*(column.tolist() for column in columns.values()), strict=True)):
            writer.writerow(
                [harmless(name), *(f"{value:.9g}" for value in values), *modes[sample : sample + 1]]
            )
    return text.getvalue()


def _of_piece(run: Run, number: int) -> dict[str, NDArray[np.float64]]:
    """Return the histories of a piece, by the names of their columns."""
    piece, motion = run.pieces[number], run.motion
    return {
        "time_s": run.time,
        **dict(zip(("x_m", "y_m", "z_m"), run.place[number].T, strict=True)),
        **dict(zip(("qw", "qx", "qy", "qz"), run.attitude[number].T, strict=True)),
        "tilt_rad": piece.tilt,
        "yaw_rad": piece.yaw,
        "slide_x_m": piece.slide_in_plan[:, 0],
        "slide_y_m": piece.slide_in_plan[:, 1],
        **{
            f"floor_{axis}_{what}": np.interp(run.time, motion.time, values)
            for axis in motion.components
            for part in [motion.component(axis)]
            for what, values in (
                ("acceleration_m_s2", part.x),
                ("velocity_m_s", part.velocity),
                ("displacement_m", part.displacement),
            )
        },
        **_forces(run),
    }


def film_kinds() -> tuple[str, ...]:
    """Return the kinds of films that can be made here: MP4 where there is ffmpeg."""
    return ("html", "gif", *(["mp4"] if shutil.which("ffmpeg") else []))


def film(
    scenario: Scenario,
    kind: str,
    language: Language,
    limits: Limits,
    *,
    held: bool,
    sample: int | None = None,
    seconds: float | None = None,
    note: str = "",
    named: Callable[[str], str] = str,
    progress: Callable[[int, int], None] | None = None,
) -> bytes:
    """Return a run as a film: a page that plays it, a GIF, or an MP4.

    Parameters
    ----------
    scenario : Scenario
        The scene.
    kind : str
        "html", "gif" or "mp4".
    language : str
        "en" or "ja".
    limits : Limits
        How long a GIF or MP4 may be.
    held : bool
        Whether the user's measures are in place.
    sample : int, optional
        As of `runs_of`.
    seconds : float, optional
        How much of the run is shown, in which something happens [s]; by default all.
    note : str
        A sentence that stands in every frame of a GIF or MP4.
    named : callable
        Puts the users' names for their files into a text.
    progress : callable, optional
        Called with each frame that is drawn; it may raise.

    Raises
    ------
    RefusedError
        The motion is too long for a GIF or MP4, or there is nothing here that makes an MP4.
    """
    if kind not in film_kinds():
        raise refused(422, "app.no_video", "kind", value=kind, allowed=", ".join(film_kinds()))
    motion = scenario.motion()
    if kind != "html" and seconds is None and motion.duration > limits.film:
        raise refused(422, "app.long_film", "scene.shaking", value=motion.duration, most=limits.film)
    with tempfile.TemporaryDirectory(prefix="stayput-film-") as folder:
        path = Path(folder, f"run.{kind}")
        shown = _shown(scenario, held=held, sample=sample)
        run = replace(shown, motion=replace(shown.motion, name=named(shown.motion.name)))
        animate_run(run, path, language=language, seconds=seconds, note=note, progress=progress)
        return path.read_bytes()


def _shown(scenario: Scenario, *, held: bool, sample: int | None) -> Run:
    """Return the run of a scene."""
    return runs_of(scenario, own_measures(scenario) if held else (), sample=sample)[0]


def _forces(run: Run) -> dict[str, NDArray[np.float64]]:
    """Return the forces of a run's devices by the names of their columns."""
    columns: dict[str, NDArray[np.float64]] = {}
    for number, device in enumerate(run.devices, 1):
        name = f"device_{number}_{device.kind}" + (f"_{device.place}" if device.place else "")
        for direction, values in (("pull", device.pull), ("shear", device.shear)):
            columns[f"{name.replace(' ', '_')}_{direction}_n"] = values
    return columns


def report_page(verdict: Verdict, language: str, motions: Motions) -> bytes:
    """Return the report of a verdict: one HTML file.

    Parameters
    ----------
    verdict : Verdict
        The result of the verification.
    language : str
        "en" or "ja".
    motions : Motions
        The uploaded motions, whose names replace their ids.
    """
    from stayput.report.room.report import room_html
    from stayput.report.verdict.html import report_html  # Matplotlib takes its time to load

    if verdict.scenario.plan is not None:
        return motions.with_file_names(room_html(verdict, language)).encode("utf-8")
    with _drawing:
        return motions.with_file_names(report_html(verdict, language)).encode("utf-8")
