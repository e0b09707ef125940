"""Files that a user saves: the scenario, histories as a table, the report."""

from __future__ import annotations

import csv
import io
import threading
from typing import TYPE_CHECKING

import numpy as np
from starlette.responses import Response

from stayput.app.running import own_measures, run_of
from stayput.report.history import history

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.app.motions import Motions
    from stayput.motion import Motion
    from stayput.scenario import Scenario
    from stayput.simulation.run import Run
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
        The uploaded motions, whose names replace their ids.
    """
    shaking = scenario.shaking
    names = {key: value for key in ("record", "vertical") if isinstance(value := getattr(shaking, key), str)}
    if not names:
        return scenario.to_toml()
    changed = shaking.model_copy(update={key: motions.label(value) for key, value in names.items()})
    note = "# Put the record's file beside this one.\n"
    return note + scenario.model_copy(update={"shaking": changed}).to_toml()


def run_csv(scenario: Scenario, *, held: bool) -> str:
    """Return the histories of a run as a table, one line for each sample of the record.

    The floor's motion stands beside them, and the forces of each device: pull along its normal, negative
    where it pushes, and shear along its tangent.

    Parameters
    ----------
    scenario : Scenario
        The scene.
    held : bool
        Whether the user's measures are in place.
    """
    motion = scenario.case().motion
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


def _forces(run: Run, time: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    """Return the forces of a run's devices at some times, by the names of their columns."""
    columns: dict[str, NDArray[np.float64]] = {}
    for number, device in enumerate(run.devices, 1):
        name = f"device_{number}_{device.kind}" + (f"_{device.place}" if device.place else "")
        for direction, values in (("pull", device.pull), ("shear", device.shear)):
            columns[f"{name.replace(' ', '_')}_{direction}_n"] = np.interp(time, run.time, values)
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
    from stayput.report.verdict.html import report_html  # Matplotlib takes its time to load

    with _drawing:
        return motions.named(report_html(verdict, language)).encode("utf-8")
