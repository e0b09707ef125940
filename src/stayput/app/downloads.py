"""Files that a user saves: the scenario, histories as a table, films, the report."""

from __future__ import annotations

import csv
import io
import shutil
import tempfile
import threading
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from starlette.responses import Response

from stayput.app.refusals import refused
from stayput.app.running import own_measures, run_of
from stayput.app.space_running import name_in, pieces_run, space_run_of
from stayput.report.animation import animate_run
from stayput.report.history import history
from stayput.rooms.verdict import RoomVerdict
from stayput.rooms.words import names_in
from stayput.scenario import AssemblyScenario, Scenario
from stayput.scenario.shaking import RECORD_FILES

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from stayput.app.jobs import AnyVerdict
    from stayput.app.limits import Limits
    from stayput.app.motions import Motions
    from stayput.catalogue import Language
    from stayput.motion import Motion
    from stayput.simulation.run import Run
    from stayput.simulation.space_run import SpaceRun

AnyRun = TypeVar("AnyRun", "Run", "SpaceRun")

_drawing = threading.Lock()  # Matplotlib draws on one thread at a time


def attachment(content: str | bytes, name: str, kind: str) -> Response:
    """Return a file to be saved."""
    headers = {"Content-Disposition": f'attachment; filename="{name}"', "Content-Type": kind}
    return Response(content, headers=headers)


def scene_toml(scenario: Scenario | AssemblyScenario, motions: Motions) -> str:
    """Return a scene as a scenario file; an uploaded record goes by its own file's name.

    Parameters
    ----------
    scenario : Scenario or AssemblyScenario
        The scene.
    motions : Motions
        The uploaded motions, whose names replace their ids.
    """
    shaking = scenario.shaking
    names = {key: value for key in RECORD_FILES if isinstance(value := getattr(shaking, key), str)}
    if not names:
        return scenario.to_toml()
    changed = shaking.model_copy(update={key: motions.label(value) for key, value in names.items()})
    note = "# Put the record's file beside this one.\n"
    return note + scenario.model_copy(update={"shaking": changed}).to_toml()


def run_csv(scenario: Scenario | AssemblyScenario, *, held: bool) -> str:
    """Return the histories of a run as a table, one line for each sample of the record.

    In space there is one line for each body and sample, with the floor's acceleration.

    The floor's motion stands beside them, and the forces of each device: pull along its normal, negative
    where it pushes, and shear along its tangent.

    Parameters
    ----------
    scenario : Scenario or AssemblyScenario
        The scene.
    held : bool
        Whether the user's measures are in place.
    """
    if not isinstance(scenario, Scenario) or scenario.dimensions == 3:
        return _space_csv(scenario, held=held)
    motion = scenario.motion()
    run = run_of(scenario, motion, own_measures(scenario) if held else ())
    histories = history(run)
    columns = {
        "time_s": histories.time,
        "x_m": histories.x,
        "z_m": histories.z,
        "tilt_rad": histories.tilt,
        "slide_m": histories.slide,
        **_floor(motion, histories.time),
        **_forces(run, histories.time),
    }
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([*columns, "mode"])
    for *values, mode in zip(*(column.tolist() for column in columns.values()), histories.mode, strict=True):
        writer.writerow([*(f"{value:.9g}" for value in values), mode.value])
    return text.getvalue()


def _space_csv(scenario: Scenario | AssemblyScenario, *, held: bool) -> str:
    run, names = _shown_in_space(scenario, held=held)
    motion, slides = run.motion, run.slide
    floor = {
        f"floor_{axis}_acceleration_m_s2": np.interp(run.time, motion.time, values)
        for axis, values in motion.components.items()
    }
    devices, text = _forces(run, run.time), io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    for number, name in enumerate(names("en")):
        columns = {
            "time_s": run.time,
            **dict(zip(("x_m", "y_m", "z_m"), run.place[number].T, strict=True)),
            **{f"q{part}": values for part, values in zip("wxyz", run.attitude[number].T, strict=True)},
            "tilt_rad": run.tilt[number],
            "yaw_rad": run.yaw[number],
            "slide_x_m": slides[number, :, 0],
            "slide_y_m": slides[number, :, 1],
            **floor,
            **devices,
        }
        if number == 0:
            writer.writerow(["body", *columns])
        for values in zip(*(column.tolist() for column in columns.values()), strict=True):
            writer.writerow([name, *(f"{value:.9g}" for value in values)])
    return text.getvalue()


def film_kinds() -> tuple[str, ...]:
    """Return the kinds of films that can be made here: MP4 where there is ffmpeg."""
    return ("html", "gif", *(["mp4"] if shutil.which("ffmpeg") else []))


def film(
    scenario: Scenario | AssemblyScenario,
    kind: str,
    language: Language,
    limits: Limits,
    *,
    held: bool,
    seconds: float | None = None,
    note: str = "",
    named: Callable[[str], str] = str,
    progress: Callable[[int, int], None] | None = None,
) -> bytes:
    """Return a run as a film: a page that plays it, a GIF, or an MP4.

    Parameters
    ----------
    scenario : Scenario or AssemblyScenario
        The scene.
    kind : str
        "html", "gif" or "mp4".
    language : str
        "en" or "ja".
    limits : Limits
        How long a GIF or MP4 may be.
    held : bool
        Whether the user's measures are in place.
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
    told: dict[str, Any] = {"language": language, "seconds": seconds, "note": note, "progress": progress}
    with tempfile.TemporaryDirectory(prefix="stayput-film-") as folder:
        path = Path(folder, f"run.{kind}")
        if isinstance(scenario, Scenario) and scenario.dimensions == 2:
            measures = own_measures(scenario) if held else ()
            name = name_in(scenario, language)
            run = _of_named_motion(run_of(scenario, motion, measures), named)
            animate_run(run, path, names=[name], **told)
        else:
            shown, names = _shown_in_space(scenario, held=held)
            run = _of_named_motion(shown, named)
            animate_run(run, path, names=names(language), **told)
        return path.read_bytes()


def _of_named_motion(run: AnyRun, named: Callable[[str], str]) -> AnyRun:
    """Return a run whose motion is called as its user calls its file."""
    return replace(run, motion=replace(run.motion, name=named(run.motion.name)))


def _shown_in_space(
    scenario: Scenario | AssemblyScenario, *, held: bool
) -> tuple[SpaceRun, Callable[[Language], tuple[str, ...]]]:
    """Return the run of a scene in space, and what its bodies are called in a language."""
    if isinstance(scenario, AssemblyScenario):
        return pieces_run(scenario), lambda language: names_in(scenario, language)
    measures = own_measures(scenario) if held else ()
    run = space_run_of(scenario, scenario.motion(), measures)
    return run, lambda language: (name_in(scenario, language),)


def _floor(motion: Motion, time: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    """Return the floor's motion at some times, by the names of its columns."""
    columns = {
        "floor_acceleration_m_s2": motion.x,
        "floor_velocity_m_s": motion.velocity,
        "floor_displacement_m": motion.displacement,
    }
    if motion.z is not None:
        columns["floor_vertical_acceleration_m_s2"] = motion.z
    return {name: np.interp(time, motion.time, values) for name, values in columns.items()}


def _forces(run: Run | SpaceRun, time: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    """Return the forces of a run's devices at some times, by the names of their columns."""
    columns: dict[str, NDArray[np.float64]] = {}
    for number, device in enumerate(run.devices, 1):
        name = f"device_{number}_{device.kind}" + (f"_{device.place}" if device.place else "")
        for direction, values in (("pull", device.pull), ("shear", device.shear)):
            columns[f"{name.replace(' ', '_')}_{direction}_n"] = np.interp(time, run.time, values)
    return columns


def report_page(verdict: AnyVerdict, language: str, motions: Motions) -> bytes:
    """Return the report of a verdict: one HTML file.

    Parameters
    ----------
    verdict : Verdict or RoomVerdict
        The result of the verification.
    language : str
        "en" or "ja".
    motions : Motions
        The uploaded motions, whose names replace their ids.
    """
    from stayput.report.room.html import room_html
    from stayput.report.verdict.html import report_html  # Matplotlib takes its time to load

    if isinstance(verdict, RoomVerdict):
        return motions.named(room_html(verdict, language)).encode("utf-8")
    with _drawing:
        return motions.named(report_html(verdict, language)).encode("utf-8")
