"""A run in words, in English and Japanese, as plain numbers, and as a dataset."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.catalogue import LANGUAGES, phrase, say
from stayput.catalogue.names import ANY_PIECE, OUTCOMES, PIECES
from stayput.report.history import history
from stayput.report.names import motion_place, place_named
from stayput.simulation.outcome import HISTORIES, QUANTITIES, Event, EventKind, Outcome
from stayput.wording import FAR, inside, with_aside

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    import xarray as xr

    from stayput.catalogue import Phrase
    from stayput.measures import DeviceResult
    from stayput.motion import Motion
    from stayput.simulation.run import Run

LEFT_AND_RIGHT = ("left", "right")
"""Sides of a picture: −x, +x; keys of the catalogue."""

BACK_AND_FRONT = ("back", "front")
"""The same sides of a piece that stands with its back to −x."""

_SMALLEST_SLIDE = 5e-4
"""A peak slide below this is not worth a number [m]."""

_EVENT_VALUES = {
    "time": ("s", "time of the event"),
    "tilt": ("rad", "tilt just after the event"),
    "tilt_rate": ("rad/s", "tilt rate just after the event"),
    "slide": ("m", "slide just after the event"),
    "slide_rate": ("m/s", "slide rate just after the event"),
}

_DEVICE_VALUES = {
    "peak_pull": ("peak_pull", "N", "largest pull"),
    "peak_push": ("peak_push", "N", "largest push"),
    "peak_shear": ("peak_shear", "N", "largest shear"),
    "used": ("utilisation", "", "largest force over its strength; at least 1 where it failed"),
    "failed_at": ("failure_time", "s", "time at which it failed, or nan"),
}
"""Attribute of a device, unit and meaning of each of its values in the dataset."""


def sentence(run: Run, name: str = "body") -> str:
    """Return the outcome of a run in one plain English sentence.

    Parameters
    ----------
    run : Run
        The run.
    name : str
        What the body is called: "bookcase".
    """
    return sentences(run, (name, name))[0]


def sentences(run: Run, name: Phrase, sides: tuple[str, str] = LEFT_AND_RIGHT) -> Phrase:
    """Return the outcome of a run in one plain sentence, in English and Japanese.

    Parameters
    ----------
    run : Run
        The run.
    name : Phrase
        What the body is called.
    sides : tuple of str
        What the sides to −x and +x are called: `LEFT_AND_RIGHT` or `BACK_AND_FRONT`.
    """
    key = f"runs.{run.outcome.value}"
    if run.outcome is Outcome.ROCKED and run.peak_slide < _SMALLEST_SLIDE:
        key = "runs.rocked_only"
    return phrase(
        key,
        name=name,
        hits=_hits(run),
        side=phrase(f"runs.side_{sides[int(run.tilt[-1] > 0.0)]}"),
        tilt=_tilt(run),
        slide=_slide(run),
        time=run.overturn_time,
        end=float(run.time[-1]),
    )


def piece_sentences(run: Run, preset: str | None, own_name: str | None = None) -> Phrase:
    """Return the outcome for a piece of furniture, and the first device that failed.

    Parameters
    ----------
    run : Run
        The run.
    preset : str, optional
        Preset of the piece.
    own_name : str, optional
        What the user calls it.
    """
    outcome = sentences(run, piece_name(preset, own_name), BACK_AND_FRONT)
    return with_first_failure(outcome, run.devices)


def piece_name(preset: str | None, own_name: str | None = None) -> Phrase:
    """Return what a piece of furniture is called: by its user, else by its preset."""
    return (own_name, own_name) if own_name else PIECES.get(preset or "", ANY_PIECE)


def with_first_failure(outcome: Phrase, devices: Iterable[DeviceResult]) -> Phrase:
    """Return the sentence of an outcome, with the first device that failed where one did."""
    failed = min((d for d in devices if d.failed), key=lambda d: d.failure_time, default=None)
    if failed is None:
        return outcome
    device = (inside(failed.label[0]), failed.label[1])
    return phrase("runs.first_to_fail", outcome=outcome, device=device, time=failed.failure_time)


def results(run: Run) -> dict[str, Any]:
    """Return the results of a run as plain values, in SI units that the keys name.

    A time that does not exist is None. ``wall_impacts`` counts the hits on the walls and the ceiling, as
    `Run.wall_impacts` does.
    """
    return {
        "outcome": run.outcome.value,
        "overturned": run.overturned,
        "overturn_time_s": number(run.overturn_time),
        "peak_tilt_rad": number(run.peak_tilt),
        "peak_slide_m": number(run.peak_slide),
        "residual_slide_m": number(run.residual_slide),
        "residual_tilt_rad": number(run.residual_tilt),
        "floor_impacts": run.floor_impacts,
        "wall_impacts": run.wall_impacts,
    }


def device_results(device: DeviceResult) -> dict[str, Any]:
    """Return a device's results as plain values, in SI units that the keys name."""
    return {
        "kind": device.kind,
        "label": by_language(device.label),
        "name": device.place,
        "peak_pull_n": device.peak_pull,
        "peak_push_n": device.peak_push,
        "peak_shear_n": device.peak_shear,
        "utilisation": number(device.utilisation),
        "failed": device.failed,
        "failure_time_s": number(device.failure_time),
        "cause": device.cause,
        "weakest": None if device.weakest is None else by_language(device.weakest),
    }


DEVICE_KEYS = {"measure": "kind", "place": "name"} | {
    key: key.lower()
    for key in (
        *("peak_pull_N", "peak_push_N", "peak_shear_N"),
        *("utilisation", "failed", "failure_time_s", "cause", "weakest"),
    )
}
"""Keys of a device in what ``--json`` prints, and those of `device_results`."""


def summary(run: Run) -> dict[str, Any]:
    """Return the run's results as plain values: what ``--json`` prints; see `results`."""
    devices = [device_results(device) for device in run.devices]
    return {
        **results(run),
        "end_time_s": history(run).end,
        "contact": run.contact,
        "gravity_m_s2": run.gravity,
        "motion": motion_data(run.motion),
        "measures": [measure.kind for measure in run.measures],
        "devices": [{key: device[name] for key, name in DEVICE_KEYS.items()} for device in devices],
        "events": [_event(event) for event in run.events],
    }


def motion_data(motion: Motion) -> dict[str, Any]:
    """Return what a motion is as plain values."""
    return {
        **attributes(motion, "name", "source", "synthetic"),
        "dt_s": motion.dt,
        "duration_s": number(motion.duration),
        "pga_m_s2": number(motion.pga),
        "floor": motion.floor or None,
    }


def rows(run: Run, language: str = "en") -> list[tuple[str, str]]:
    """Return the results as rows of a table in a language: label, and value with its unit."""
    motion = run.motion
    open_side = say("runs.open_side", language) if slides_off(run) else ""
    shaken = {"name": motion_place(motion, language), "duration": motion.duration, "peak": motion.pga}
    values = {
        "motion": say("runs.row_motion_value", language, **shaken),
        "outcome": outcome_named(run.outcome, language),
        "overturned": f"{run.overturn_time:.2f} s" if run.overturned else "-",
        "tilt": f"{math.degrees(run.peak_tilt):.2f}°",
        "slide": f"{100.0 * run.peak_slide:.2f} cm{open_side}",
        "residual": f"{100.0 * run.residual_slide:+z.2f} cm",
        "floor": str(run.floor_impacts),
        "walls" if run.room.ceiling is None else "walls_and_ceiling": str(run.wall_impacts),
    }
    labelled = [(say(f"runs.row_{key}", language), value) for key, value in values.items()]
    return [*labelled, *device_rows(run.devices, language=language)]


def outcome_named(outcome: Outcome, language: str) -> str:
    """Return an outcome in a word: in English as `Run.outcome` has it, but that of a failed run."""
    own = language == "en" and outcome is not Outcome.FAILED
    return outcome.value if own else say(OUTCOMES[outcome.value], language)


def place_called(device: DeviceResult, members: Sequence[str], language: str = "en") -> str:
    """Return where a device is; of a joint which bodies it joins, by what these are called."""
    if device.between is None or not members:
        return place_named(device.place, language)
    _, comma, number = device.place.partition(", ")  # of several joints of the same two
    return " – ".join(members[body] for body in device.between) + comma + number


def device_rows(
    devices: Sequence[DeviceResult], members: Sequence[str] = (), language: str = "en"
) -> list[tuple[str, str]]:
    """Return a row for each device: its largest force, how much of its strength that is, and its failure.

    ``members`` are what the pieces of an assembly are called.
    """
    rows_of_devices: list[tuple[str, str]] = []
    number = LANGUAGES.index(language)
    for device in devices:
        name = " ".join(filter(None, (device.label[number], place_called(device, members, language))))
        if device.member is not None and members:
            name = with_aside(name, members[device.member], language)
        peak = max(device.peak_pull, device.peak_push, device.peak_shear)
        share = 100.0 * device.utilisation
        used = say("runs.row_used", language, share=share) if share > 0.0 else ""
        if device.failed:
            cause = device.weakest or phrase(f"runs.cause_{str(device.cause).replace(' ', '_')}")
            fate = say("runs.row_failed", language, cause=cause, time=device.failure_time)
        else:
            fate = say("runs.row_holds", language)
        rows_of_devices.append((name, f"{peak:.0f} N{used}{fate}"))
    return rows_of_devices


def _event(event: Event) -> dict[str, Any]:
    numbers = {
        f"{name}_{unit.replace('/', '_')}": getattr(event, name) for name, (unit, _) in _EVENT_VALUES.items()
    }
    return {"kind": event.kind.value, "mode": event.mode.value, **numbers}


def _hits(run: Run) -> Phrase:
    """Return the clause about impacts on walls and ceiling; empty where there was none."""
    counts = {"wall": run.count(EventKind.WALL_IMPACT), "ceiling": run.count(EventKind.CEILING_IMPACT)}
    parts: list[Phrase] = []
    for what, n in counts.items():
        times = phrase({1: "runs.once", 2: "runs.twice"}.get(n, "runs.times"), n=n)
        parts += [phrase(f"runs.hits_{what}", times=times)] if n else []
    if not parts:
        return "", ""
    english, japanese = zip(*parts, strict=True)
    return phrase("runs.hits", parts=(" and ".join(english), "、".join(japanese)))


def _slide(run: Run) -> Phrase:
    """Return how far a body slid: "up to 2.0 cm", or beyond what a room is."""
    if slides_off(run):
        return phrase("runs.slid_far", far=FAR)
    if run.peak_slide < _SMALLEST_SLIDE:
        return phrase("runs.slid_least")
    return phrase("runs.slid_up_to", length=length(run.peak_slide))


def _tilt(run: Run) -> Phrase:
    degrees = math.degrees(run.peak_tilt)
    return phrase("runs.tilted_least") if degrees < 0.05 else phrase("runs.tilted_up_to", angle=degrees)


def slides_off(run: Run) -> bool:
    """Return whether a body slid beyond `FAR` to a side without a wall."""
    if not run.peak_slide > FAR:
        return False
    farthest = run.slide[np.abs(run.slide).argmax()]
    return (run.room.right_wall if farthest > 0.0 else run.room.left_wall) is None


def length(metres: float) -> str:
    """Return a length of a run in the unit that people use for it: "3 mm", "2.0 cm", "1.24 m"."""
    if metres >= 0.9995:
        return f"{metres:.2f} m"
    return f"{1e3 * metres:.0f} mm" if metres < 9.5e-3 else f"{1e2 * metres:.1f} cm"


def number(value: float) -> float | None:
    """Return a number, or None in place of one that is not finite."""
    return float(value) if math.isfinite(value) else None


def attributes(value: object, *names: str) -> dict[str, Any]:
    """Return attributes of a value by their names; None in place of a number that is not finite."""
    return {name: number(own) if isinstance(own := getattr(value, name), float) else own for name in names}


def by_language(text: Phrase) -> dict[str, str]:
    """Return a text by its languages."""
    return dict(zip(LANGUAGES, text, strict=True))


def run_to_dataset(run: Run) -> xr.Dataset:
    """Return the histories over ``time``, the events over ``event``, and the results as scalars.

    Parameters
    ----------
    run : Run
        The run.

    Returns
    -------
    xarray.Dataset
        Every variable with a unit has ``units`` and ``long_name`` in its attributes.
    """
    import xarray as xr  # which takes its time to load

    data = xr.Dataset(
        coords={
            "time": ("time", run.time, {"units": "s", "long_name": "time since the record's first sample"})
        },
        attrs={
            "description": sentence(run),
            "outcome": run.outcome.value,
            "overturned": int(run.overturned),
            "contact": run.contact,
            "gravity": run.gravity,
            "motion": run.motion.name,
        },
    )
    for name, (_, unit, meaning) in HISTORIES.items():
        data[name] = ("time", getattr(run, name), {"units": unit, "long_name": meaning})
    data["mode"] = ("time", run.mode, {"long_name": "how the body moves"})
    for name, (unit, meaning) in _EVENT_VALUES.items():
        values = np.array([getattr(event, name) for event in run.events], dtype=np.float64)
        data[f"event_{name}"] = ("event", values, {"units": unit, "long_name": meaning})
    data["event_kind"] = ("event", np.array([event.kind.value for event in run.events], dtype=np.str_))
    data["event_mode"] = ("event", np.array([event.mode.value for event in run.events], dtype=np.str_))
    for column in QUANTITIES:
        if column.name not in ("outcome", "overturned", "events"):  # which are told above
            data[column.name] = ((), getattr(run, column.name), column.attributes)
    if run.devices:
        _add_devices(data, run.devices)
    return data


def _attributes(unit: str, meaning: str) -> dict[str, str]:
    return {"units": unit, "long_name": meaning} if unit else {"long_name": meaning}


def _add_devices(data: xr.Dataset, devices: tuple[DeviceResult, ...]) -> None:
    """Add the devices' results over ``device``, and their forces over ``time`` too."""
    names = [" ".join(filter(None, (device.kind, device.place))) for device in devices]
    data["device"] = ("device", np.array(names, dtype=np.str_), {"long_name": "measure and place"})
    for name, (attribute, unit, meaning) in _DEVICE_VALUES.items():
        values = np.array([getattr(device, attribute) for device in devices], dtype=np.float64)
        data[f"device_{name}"] = ("device", values, _attributes(unit, meaning))
    causes = np.array([device.cause or "" for device in devices], dtype=np.str_)
    data["device_cause"] = ("device", causes, {"long_name": "why it failed; empty where it holds"})
    for name, meaning in (("pull", "force along its normal, + pull"), ("shear", "force along its tangent")):
        forces = np.stack([getattr(device, name) for device in devices], axis=-1)
        data[f"device_{name}"] = (("time", "device"), forces, {"units": "N", "long_name": meaning})
