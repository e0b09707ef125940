"""A run in space as rows of a table, and as plain numbers."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.catalogue import phrase, say
from stayput.errors import InputError, list_of
from stayput.report.history import peak_of
from stayput.report.names import motion_place
from stayput.report.summary import (
    DEVICE_KEYS,
    device_results,
    device_rows,
    length,
    motion_data,
    number,
    outcome_named,
    piece_name,
    with_first_failure,
)
from stayput.simulation.outcome import Outcome

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.catalogue import Phrase
    from stayput.simulation.space_run import Hit, SpaceRun


def space_rows(
    run: SpaceRun, names: Sequence[str] | None = None, language: str = "en"
) -> list[tuple[str, str]]:
    """Return the results as rows of a table: label, and value with its unit; of each body in turn.

    Parameters
    ----------
    run : SpaceRun
        The run.
    names : sequence of str, optional
        What the bodies are called; by default by their numbers.
    language : str
        "en" or "ja".
    """
    motion = run.motion
    shaken = {"name": motion_place(motion, language), "duration": motion.duration, "peak": peak_of(motion)}
    rows = [(say("runs.row_motion", language), say("space.row_motion_value", language, **shaken))]
    times, falls, outcomes = run.overturn_time, run.fall_time, run.outcomes
    called = names_of(run, names, language)
    tilts, slides, yaws = run.peak_tilt, run.peak_slide, run.yaw
    for b, name in enumerate(called):
        if len(called) > 1:
            rows.append((name, ""))
        values = {
            "outcome": outcome_named(outcomes[b], language),
            "overturned": _seconds(times[b]),
            "fell_off": _seconds(falls[b]),
            "tilt": f"{math.degrees(tilts[b]):.2f}°",
            "way" if len(run.pieces[b].solid.rims) else "slide": f"{100.0 * slides[b]:.2f} cm",
            "yaw": f"{math.degrees(np.abs(yaws[b]).max()):.1f}°",
            "floor": str(run.hit_numbers[b, 0]),
            "walls" if run.room.ceiling is None else "walls_and_ceiling": str(run.hit_numbers[b, 1]),
        }
        if len(called) > 1:
            values["bodies"] = str(run.hit_numbers[b, 2])
        else:
            del values["fell_off"]
        rows += [(say(f"runs.row_{key}", language), value) for key, value in values.items()]
    rows += device_rows(run.devices, called if len(called) > 1 else (), language)
    rows.append((say("runs.row_error", language), f"{100.0 * run.estimated_error:.2g} cm"))
    if run.unconverged:
        rows.append((say("runs.row_rough", language), f"{run.unconverged:,} / {run.steps:,}"))
    return rows


def space_summary(run: SpaceRun, names: Sequence[str] | None = None) -> dict[str, Any]:
    """Return the results as plain values, in SI units that the keys name: what ``--json`` prints.

    Parameters
    ----------
    run, names
        As for `space_rows`.
    """
    times, falls, outcomes = run.overturn_time, run.fall_time, run.outcomes
    called = names_of(run, names, "en")
    slides, turns = run.slide, run.yaw
    devices = [device_results(device) for device in run.devices]
    return {
        "outcome": run.outcome.value,
        "end_time_s": number(float(run.time[-1])),
        "bodies": [
            {
                "name": name,
                "outcome": outcomes[b].value,
                "overturned": None if run.given_up else math.isfinite(times[b]),
                "overturn_time_s": number(float(times[b])),
                "fell_off": None if run.given_up else math.isfinite(falls[b]),
                "fall_time_s": number(float(falls[b])),
                "peak_tilt_rad": number(float(run.peak_tilt[b])),
                "peak_slide_m": number(float(run.peak_slide[b])),
                "residual_slide_m": [number(float(way)) for way in slides[b, -1]],
                "residual_yaw_rad": number(float(turns[b, -1])),
                "place_m": [number(float(place)) for place in run.place[b, -1]],
                "attitude": [number(float(part)) for part in run.attitude[b, -1]],
                "floor_impacts": int(run.hit_numbers[b, 0]),
                "wall_impacts": int(run.hit_numbers[b, 1]),
                "impacts_on_bodies": int(run.hit_numbers[b, 2]),
            }
            for b, name in enumerate(called)
        ],
        "motion": motion_data(run.motion),
        "measures": [measure.kind for one in run.held if one is not None for measure in one.measures],
        "devices": [
            {key: device[name] for key, name in DEVICE_KEYS.items()}
            | ({} if result.member is None else {"body": called[result.member]})
            for device, result in zip(devices, run.devices, strict=True)
        ],
        "hits": [_hit(hit, called) for hit in run.hits],
        "steps": run.steps,
        "unconverged_steps": run.unconverged,
        "estimated_error_m": run.estimated_error,
    }


def _seconds(time: float) -> str:
    return "-" if math.isnan(time) else f"{time:.2f} s"


def _hit(hit: Hit, names: Sequence[str]) -> dict[str, Any]:
    return {
        "time_s": hit.time,
        "body": names[hit.body],
        "on": hit.surface if hit.other is None else names[hit.other],
        "speed_m_s": hit.speed,
        "impulse_n_s": hit.impulse,
    }


def names_of(run: SpaceRun, names: Sequence[str] | None, language: str) -> tuple[str, ...]:
    """Return what the bodies are called: the names given, or by their numbers where there are several.

    Raises
    ------
    InputError
        Names that are no texts, or not one for each body.
    """
    count = len(run.pieces)
    if names is None:
        if count == 1:
            return (say("runs.body", language),)
        return tuple(say("space.numbered", language, number=number) for number in range(1, count + 1))
    given = list_of("names", names, str)
    if len(given) != count:
        raise InputError("space.number_of_names", "names", count=len(given), bodies=count)
    return given


def became(run: SpaceRun, names: Sequence[str]) -> Phrase:
    """Return what became of the bodies of a run, in one sentence."""
    if run.given_up or len(names) == 1:
        return _of_one(run, names[0])
    times = np.fmin(run.overturn_time, run.fall_time).tolist()
    fallen = [b for b, time in enumerate(times) if math.isfinite(time)]
    if not fallen:
        return phrase("space.none_fell", count=len(names))
    fallen.sort(key=times.__getitem__)
    each = [phrase("space.fell_at", name=names[b], time=times[b]) for b in fallen]
    commas = phrase("common.listed")
    which = tuple(comma.join(texts) for comma, texts in zip(commas, zip(*each, strict=True), strict=True))
    return phrase("space.some_fell", fallen=len(fallen), count=len(names), which=which)


def piece_became(run: SpaceRun, preset: str | None, own_name: str | None = None) -> Phrase:
    """Return what became of a piece of furniture, and the first device that failed.

    Parameters
    ----------
    run : SpaceRun
        The run of the piece alone.
    preset, own_name : str, optional
        Its preset, and what the user calls it.
    """
    english, japanese = piece_name(preset, own_name)
    outcome = _of_one(run, english)[0], _of_one(run, japanese)[1]
    return with_first_failure(outcome, run.devices)


def _of_one(run: SpaceRun, name: str) -> Phrase:
    if run.given_up:
        return phrase("space.failed")
    if run.overturned[0]:
        return phrase("space.overturned", name=name, time=float(run.overturn_time[0]))
    angle, way = math.degrees(run.peak_tilt[0]), float(run.peak_slide[0])
    if run.outcome is Outcome.RESTED:
        return phrase("runs.rested", name=name)
    turn = math.degrees(np.abs(run.yaw[0]).max())
    if run.outcome is Outcome.SLID and way < 1e-3 and turn >= 1.0:
        return phrase("space.turned", name=name, angle=turn)
    tilt = phrase("space.least_angle") if angle < 0.1 else phrase("space.up_to_angle", angle=angle)
    slide = phrase("runs.slid_least") if way < 1e-3 else phrase("runs.slid_up_to", length=length(way))
    key = run.outcome.value if run.outcome in (Outcome.ROLLED, Outcome.LEANING) else "upright"
    return phrase(f"space.{key}", name=name, tilt=tilt, slide=slide)
