"""A run in words and as a record of plain numbers."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from stayput.simulation import Event, EventKind, Outcome

if TYPE_CHECKING:
    from stayput.measures import DeviceResult
    from stayput.motion import Motion
    from stayput.simulation import Run

_TIMES = {1: "once", 2: "twice"}


def sentence(run: Run, name: str = "body") -> str:
    """Say in one plain sentence what became of the body.

    Parameters
    ----------
    run : Run
        The run.
    name : str
        What the body is called: "bookcase".
    """
    subject = f"The {name}"
    hits = _after_hitting(run)
    match run.outcome:
        case Outcome.OVERTURNED:
            side = "right" if run.tilt[-1] > 0.0 else "left"
            return f"{subject} overturned to the {side} {run.overturn_time:.1f} s into the motion{hits}."
        case Outcome.FAILED:
            return (
                f"{subject} could not be followed beyond {run.time[-1]:.2f} s, because too many events "
                "crowded together, so this run says nothing about whether it stands."
            )
        case Outcome.LEANING:
            side = "right" if run.tilt[-1] > 0.0 else "left"
            return f"{subject} did not overturn but was left leaning to the {side}{hits}."
        case Outcome.RESTED:
            return f"{subject} stayed put: it neither slid nor rocked."
        case Outcome.SLID:
            slid = _length(run.peak_slide)
            return f"{subject} slid by up to {slid} without rocking{hits}, and stayed upright."
        case Outcome.ROCKED:
            slid = f" and slid by up to {_length(run.peak_slide)}" if run.peak_slide >= 5e-4 else ""
            tilt = math.degrees(run.peak_tilt)
            return f"{subject} rocked by up to {_angle(tilt)}{slid}{hits}, and stayed upright."


def motion_label(motion: Motion) -> str:
    """Return what a motion is called in a picture; a computed one is always called synthetic."""
    plain = motion.synthetic and "synthetic" not in motion.name.lower()
    return f"{motion.name} (synthetic)" if plain else motion.name


def summary(run: Run) -> dict[str, Any]:
    """Return the run's results as plain values: what ``--json`` prints.

    Returns
    -------
    dict
        Keys carry their units; a time that does not exist is None. ``wall_impacts`` counts the hits on
        the walls and the ceiling, as `Run.wall_impacts` does.
    """
    return {
        "outcome": run.outcome.value,
        "overturned": run.overturned,
        "overturn_time_s": _number(run.overturn_time),
        "peak_tilt_rad": _number(run.peak_tilt),
        "peak_slide_m": _number(run.peak_slide),
        "residual_slide_m": _number(run.residual_slide),
        "residual_tilt_rad": _number(run.residual_tilt),
        "floor_impacts": run.floor_impacts,
        "wall_impacts": run.wall_impacts,
        "end_time_s": _number(float(run.time[-1])),
        "contact": run.contact,
        "gravity_m_s2": run.gravity,
        "motion": {
            "name": run.motion.name,
            "synthetic": run.motion.synthetic,
            "dt_s": run.motion.dt,
            "duration_s": _number(run.motion.duration),
            "pga_m_s2": _number(run.motion.pga),
        },
        "measures": [measure.kind for measure in run.measures],
        "devices": [_device(device) for device in run.devices],
        "events": [_event(event) for event in run.events],
    }


def rows(run: Run) -> list[tuple[str, str]]:
    """Return the results as a person reads them: what, and its value with its unit."""
    motion = run.motion
    walls = "Wall impacts" if run.room.ceiling is None else "Wall and ceiling impacts"
    return [
        ("Motion", f"{motion_label(motion)}, {motion.duration:g} s, peak {motion.pga:.2f} m/s²"),
        ("Outcome", run.outcome.value),
        ("Overturned at", f"{run.overturn_time:.2f} s" if run.overturned else "-"),
        ("Peak tilt", f"{math.degrees(run.peak_tilt):.2f}°"),
        ("Peak slide", f"{100.0 * run.peak_slide:.2f} cm"),
        ("Residual slide", f"{100.0 * run.residual_slide:+.2f} cm"),
        ("Floor impacts", str(run.floor_impacts)),
        (walls, str(run.wall_impacts)),
        *_device_rows(run),
    ]


def _device(device: DeviceResult) -> dict[str, Any]:
    return {
        "measure": device.kind,
        "place": device.place,
        "peak_pull_N": device.peak_pull,
        "peak_push_N": device.peak_push,
        "peak_shear_N": device.peak_shear,
        "utilisation": device.utilisation,
        "failed": device.failed,
        "failure_time_s": _number(device.failure_time),
        "cause": device.cause,
    }


def _device_rows(run: Run) -> list[tuple[str, str]]:
    """Return a row for each device: its largest force, how much of its strength that is, and its failure."""
    found: list[tuple[str, str]] = []
    for device in run.devices:
        name = " ".join(filter(None, (device.label[0], device.place)))
        peak = max(device.peak_pull, device.peak_push, device.peak_shear)
        used = f", {100.0 * device.utilisation:.0f} % of its strength" if device.utilisation > 0.0 else ""
        fate = f"; {device.cause} at {device.failure_time:.2f} s" if device.failed else "; holds"
        found.append((name, f"{peak:.0f} N{used}{fate}"))
    return found


def _event(event: Event) -> dict[str, Any]:
    return {
        "time_s": event.time,
        "kind": event.kind.value,
        "mode": event.mode.value,
        "tilt_rad": event.tilt,
        "tilt_rate_rad_s": event.tilt_rate,
        "slide_m": event.slide,
        "slide_rate_m_s": event.slide_rate,
    }


def _after_hitting(run: Run) -> str:
    kinds = [event.kind for event in run.events]
    hits = {"wall": kinds.count(EventKind.WALL_IMPACT), "ceiling": kinds.count(EventKind.CEILING_IMPACT)}
    told = [f"the {what} {_TIMES.get(n, f'{n} times')}" for what, n in hits.items() if n]
    return f" after hitting {' and '.join(told)}" if told else ""


def _length(metres: float) -> str:
    if metres < 5e-4:
        return "less than a millimetre"
    return f"{1e3 * metres:.0f} mm" if metres < 0.01 else f"{1e2 * metres:.1f} cm"


def _angle(degrees: float) -> str:
    return "less than 0.1°" if degrees < 0.05 else f"{degrees:.1f}°"


def _number(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
