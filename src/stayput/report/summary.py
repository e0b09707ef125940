"""A run in words, in English and Japanese, as plain numbers, and as a dataset of xarray."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from operator import itemgetter
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.catalogue import LANGUAGES, Phrase, phrase, say
from stayput.catalogue.names import OUTCOMES
from stayput.report.history import peak_told
from stayput.report.names import motion_place, names_of, piece_at_first, piece_name, place_named
from stayput.simulation.outcome import HISTORIES, QUANTITIES, Event, EventKind, Hit, Outcome
from stayput.wording import FAR, inside, joined, with_aside

if TYPE_CHECKING:
    import xarray as xr

    from stayput.measures import DeviceResult
    from stayput.simulation.run import PieceRun, Run


_DEVICE_VALUES = {
    "peak_pull": ("peak_pull", "N", "largest pull that it bore"),
    "peak_push": ("peak_push", "N", "largest push that it bore"),
    "peak_shear": ("peak_shear", "N", "largest shear that it bore"),
    "used": ("utilisation", "", "largest force over its strength; at least 1 where it failed"),
    "failed_at": ("failure_time", "s", "time at which it failed, or nan"),
}
"""Attribute of a device, unit and meaning of each of its values in the dataset."""


def run_to_dataset(run: Run) -> xr.Dataset:
    """Return histories over ``piece`` and ``time``, results over ``piece``, and the events over ``event``.

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

    moved = ("piece", "time")
    histories: dict[str, tuple[tuple[str, ...], Any, str, str]] = {
        "place": ((*moved, "axis"), run.place, "m", "centre of gravity, in axes that move with the floor"),
        "attitude": ((*moved, "part"), run.attitude, "", "unit quaternion that turns the piece's frame"),
        "velocity": ((*moved, "axis"), run.velocity, "m/s", "rate of the place"),
        "rotation_rate": ((*moved, "axis"), run.rotation_rate, "rad/s", "along the room's axes"),
        "tilt": (moved, [piece.tilt for piece in run.pieces], "rad", "angle from rest"),
        "yaw": (moved, [piece.yaw for piece in run.pieces], "rad", "turn about the vertical"),
        "slide": (moved, [piece.slide for piece in run.pieces], "m", "how far the base has slid or rolled"),
        "slide_in_plan": (
            (*moved, "level_axis"),
            [piece.slide_in_plan for piece in run.pieces],
            "m",
            "the same along x and y",
        ),
    }
    if run.engine == "plane":
        histories["slide_rate"] = (("time",), run.slide_rate, *HISTORIES["slide_rate"][1:])
        histories["mode"] = (("time",), run.mode, "", "how the body moves")
    else:
        pressing = "force of the room, and of other bodies, on a piece"
        histories["force"] = ((*moved, "by", "axis"), run.force, "N", pressing)
    data = xr.Dataset(
        {name: (dims, values, _attributes(*about)) for name, (dims, values, *about) in histories.items()},
        {
            "time": ("time", run.time, _attributes("s", "time since the record's first sample")),
            "piece": list(run.names),
            "axis": list("xyz"),
            "level_axis": list("xy"),
            "part": list("wxyz"),
            **({"by": ["room", "bodies"]} if run.engine == "space" else {}),
        },
        {"description": sentence(run), "motion": run.motion.name, "engine": run.engine},
    )
    data["outcome"] = ("piece", [piece.outcome.value for piece in run.pieces])
    for column in QUANTITIES:
        if column.name.startswith("device_"):
            data[column.name] = ((), getattr(run, column.name), column.attributes)
        elif column.name not in ("outcome", "events"):
            values = [getattr(piece, column.name) for piece in run.pieces]
            data[column.name] = ("piece", values, column.attributes)
    fell = _attributes("s", "time at which it fell off what it stood on, or nan")
    data["fall_time"] = ("piece", [piece.fall_time for piece in run.pieces], fell)
    if run.engine == "plane":
        _add_events(data, run)
    if run.devices:
        _add_devices(data, run.devices)
    return data


def _add_events(data: xr.Dataset, run: Run) -> None:
    """Add the events over ``event``."""
    for name, about in EVENT_VALUES.items():
        values = np.array([getattr(event, name) for event in run.events], dtype=np.float64)
        data[f"event_{name}"] = ("event", values, _attributes(*about))
    for name in ("kind", "mode"):
        words = [getattr(event, name).value for event in run.events]
        data[f"event_{name}"] = ("event", np.array(words, dtype=np.str_))


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


LEFT_AND_RIGHT = ("left", "right")
"""Sides of a picture: −x, +x; keys of the catalogue."""

BACK_AND_FRONT = ("back", "front")
"""The same sides of a piece that stands with its back to −x."""

_SMALLEST_SLIDE = 5e-4
"""A peak slide below this is not worth a number [m]."""

EVENT_VALUES = {
    "time": ("s", "time of the event"),
    "tilt": ("rad", "tilt just after the event"),
    "tilt_rate": ("rad/s", "tilt rate just after the event"),
    "slide": ("m", "slide just after the event"),
    "slide_rate": ("m/s", "slide rate just after the event"),
}


def sentence(run: Run) -> str:
    """Return the outcome of a run in one plain English sentence."""
    return sentences(run)[0]


def sentences(run: Run, sides: tuple[str, str] = LEFT_AND_RIGHT) -> Phrase:
    """Return the outcome of a run in one plain sentence, in English and Japanese.

    Parameters
    ----------
    run : Run
        The run.
    sides : tuple of str
        What the sides to −x and +x of the plane are called: `LEFT_AND_RIGHT` or `BACK_AND_FRONT`.
    """
    first = piece_at_first(run.names[0])
    if run.engine == "plane":
        return _in_plane(run, first, sides)
    if run.given_up:
        return phrase("space.failed")
    if len(run.pieces) == 1:
        return _in_space(run.piece, first)
    fallen = [
        (min(time for time in (piece.overturn_time, piece.fall_time) if math.isfinite(time)), name)
        for piece, name in zip(run.pieces, map(piece_name, run.names), strict=True)
        if piece.overturned or piece.fell_off
    ]
    if not fallen:
        return phrase("space.none_fell", count=len(run.pieces))
    which = joined(
        phrase("space.fell_at", name=name, time=time) for time, name in sorted(fallen, key=itemgetter(0))
    )
    return phrase("space.some_fell", fallen=len(fallen), count=len(run.pieces), which=which)


def _in_plane(run: Run, name: Phrase, sides: tuple[str, str]) -> Phrase:
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


def _in_space(piece: PieceRun, name: Phrase) -> Phrase:
    if piece.overturned:
        return phrase("space.overturned", name=name, time=piece.overturn_time)
    if piece.outcome is Outcome.RESTED:
        return phrase("runs.rested", name=name)
    angle, way, turn = math.degrees(piece.peak_tilt), piece.peak_slide, math.degrees(np.abs(piece.yaw).max())
    if piece.outcome is Outcome.SLID and way < 1e-3 and turn >= 1.0:
        return phrase("space.turned", name=name, angle=turn)
    tilt = phrase("space.least_angle") if angle < 0.1 else phrase("space.up_to_angle", angle=angle)
    slide = phrase("runs.slid_least") if way < 1e-3 else phrase("runs.slid_up_to", length=length(way))
    key = piece.outcome.value if piece.outcome in (Outcome.ROLLED, Outcome.LEANING) else "upright"
    return phrase(f"space.{key}", name=name, tilt=tilt, slide=slide)


def sentences_of_piece(run: Run) -> Phrase:
    """Return the outcome for a piece of furniture, and the first device that failed."""
    outcome, devices = sentences(run, BACK_AND_FRONT), run.devices
    failed = min((d for d in devices if d.failed), key=lambda d: d.failure_time, default=None)
    if failed is None:
        return outcome
    device = (inside(failed.label[0]), failed.label[1])
    return phrase("runs.first_to_fail", outcome=outcome, device=device, time=failed.failure_time)


def piece_results(run: Run) -> list[dict[str, Any]]:
    """Return the results of each piece as plain values, in SI units that the keys name.

    A number that does not exist is None. ``wall_impacts`` counts the hits on the walls and the ceiling, and
    ``impacts_on_bodies`` those on other pieces. ``place_m`` and ``attitude`` are those at the end, what is
    left of tilt and slide is that until it overturned or fell off.
    """
    lost, plane = run.given_up, run.engine == "plane"

    def left(piece: PieceRun) -> tuple[float, ...]:
        fell = float(np.fmin(piece.overturn_time, piece.fall_time))  # nan, which sorts last, if it did not
        last = piece.slide_in_plan[: int(np.searchsorted(run.time, fell)) + 1][-1]
        return (piece.residual_slide, 0.0) if plane else tuple(last.tolist())

    return [
        {
            "name": name,
            "outcome": piece.outcome.value,
            "overturned": None if lost else piece.overturned,
            "overturn_time_s": number(piece.overturn_time),
            "fell_off": None if lost else piece.fell_off,
            **attributes(piece, "fall_time_s", "peak_tilt_rad", "peak_slide_m", "residual_tilt_rad"),
            "residual_slide_m": [number(way) for way in left(piece)],
            "residual_yaw_rad": number(piece.yaw[-1]),
            "place_m": [number(part) for part in place[-1].tolist()],
            "attitude": [number(part) for part in attitude[-1].tolist()],
            **attributes(piece, "floor_impacts", "wall_impacts"),
            "impacts_on_bodies": piece.body_impacts,
        }
        for name, piece, place, attitude in zip(run.names, run.pieces, run.place, run.attitude, strict=True)
    ]


def device_results(device: DeviceResult) -> dict[str, Any]:
    """Return a device's results as plain values, in SI units that the keys name."""
    return {
        "kind": device.kind,
        "label": by_language(device.label),
        "name": device.place,
        **attributes(device, "peak_pull_n", "peak_push_n", "peak_shear_n"),
        **attributes(device, "utilisation", "failed", "failure_time_s", "cause"),
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
    """Return a run's results as plain values: what ``--json`` prints; see `piece_results`.

    What only one of the engines knows stands there for that engine alone.
    """
    of_engine: dict[str, Any]
    if run.engine == "plane":
        of_engine = {"contact": run.contact, "gravity_m_s2": run.gravity}
        of_engine["events"] = [_event(event) for event in run.events]
    else:
        of_engine = {
            "hits": [_hit(hit, run.names) for hit in run.hits],
            "steps": run.steps,
            "unconverged_steps": run.unconverged,
        }
    return {
        "engine": run.engine,
        "outcome": run.outcome.value,
        "end_time_s": number(run.end),
        "pieces": piece_results(run),
        "motion": {
            **attributes(run.motion, "name", "source", "synthetic", "dt_s", "duration_s", "pga_m_s2"),
            "floor": run.motion.floor or None,
        },
        "measures": [measure.kind for measure in run.measures],
        "devices": [
            {key: device[name] for key, name in DEVICE_KEYS.items()}
            | ({} if result.member is None else {"piece": run.names[result.member]})
            for result in run.devices
            for device in [device_results(result)]
        ],
        **of_engine,
    }


def rows(run: Run, language: str = "en") -> list[tuple[str, str]]:
    """Return the results as rows of a table: label, and value with its unit; of each piece in turn."""
    motion, plane, names = run.motion, run.engine == "plane", names_of(run, language)
    shaken = {"name": motion_place(motion, language), "duration": motion.duration, "peak": peak_told(run)}
    table = [(say("runs.row_motion", language), say("runs.row_motion_value", language, **shaken))]
    for b, (name, piece) in enumerate(zip(names, run.pieces, strict=True)):
        open_side = say("runs.open_side", language) if plane and slides_off(run) else ""
        rolls = not plane and len(run.standing[b].solid.rims) > 0
        values = {
            "outcome": outcome_named(piece.outcome, language),
            "overturned": f"{piece.overturn_time:.2f} s" if piece.overturned else "-",
            "fell_off": f"{piece.fall_time:.2f} s" if piece.fell_off else "-",
            "tilt": f"{math.degrees(piece.peak_tilt):.2f}°",
            "way" if rolls else "slide": f"{100.0 * piece.peak_slide:.2f} cm{open_side}",
            "residual": f"{100.0 * piece.residual_slide:{'+' if plane else ''}z.2f} cm",
            "yaw": f"{math.degrees(np.abs(piece.yaw).max()):.1f}°",
            "floor": str(piece.floor_impacts),
            "walls" if run.room.ceiling is None else "walls_and_ceiling": str(piece.wall_impacts),
            "bodies": str(piece.body_impacts),
        }
        absent = {"yaw"} if plane else set[str]()
        absent |= {"fell_off", "bodies"} if len(names) == 1 else set()
        table += [(name, "")] if len(names) > 1 else []
        table += [
            (say(f"runs.row_{row}", language), value) for row, value in values.items() if row not in absent
        ]
    table += device_rows(run.devices, names if len(names) > 1 else (), language)
    if run.unconverged:
        table.append((say("runs.row_rough", language), f"{run.unconverged:,} / {run.steps:,}"))
    return table


def outcome_named(outcome: Outcome, language: str) -> str:
    """Return an outcome in a word: in English as `Run.outcome` has it, but that of a failed run."""
    as_is = language == "en" and outcome is not Outcome.FAILED
    return outcome.value if as_is else say(OUTCOMES[outcome.value], language)


def place_called(device: DeviceResult, members: Sequence[str], language: str = "en") -> str:
    """Return where a device is; of a joint which bodies it joins, by what these are called."""
    if device.between is None or not members:
        return place_named(device.place, language)
    _, comma, number = device.place.partition(", ")  # of several joints of the same two
    return " – ".join(members[body] for body in device.between) + comma + number


def device_rows(
    devices: Sequence[DeviceResult], members: Sequence[str] = (), language: str = "en"
) -> list[tuple[str, str]]:
    """Return a row for each device: the largest force that it bore, in its strength too, and its failure.

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
        rows_of_devices.append((name, f"{say('runs.row_bore', language, peak=peak)}{used}{fate}"))
    return rows_of_devices


def _event(event: Event) -> dict[str, Any]:
    numbers = {
        f"{name}_{unit.replace('/', '_')}": getattr(event, name) for name, (unit, _) in EVENT_VALUES.items()
    }
    return {"kind": event.kind.value, "mode": event.mode.value, **numbers}


def _hit(hit: Hit, names: Sequence[str]) -> dict[str, Any]:
    return {
        "time_s": hit.time,
        "body": names[hit.body],
        "on": hit.surface if hit.other is None else names[hit.other],
        "speed_m_s": hit.speed,
        "impulse_n_s": hit.impulse,
    }


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


_UNIT = re.compile("_(bytes|count|kg|m|m_s|m_s2|n|rad|s)$")


def attribute(value: object, key: str) -> Any:
    """Return the attribute of a value that a key names, with its unit behind it."""
    return getattr(value, key if hasattr(value, key) else _UNIT.sub("", key))


def attributes(value: object, *keys: str) -> dict[str, Any]:
    """Return attributes of a value by keys; None in place of a number that is not finite; see `attribute`."""
    return {key: number(part) if isinstance(part := attribute(value, key), float) else part for key in keys}


def by_language(text: Phrase) -> dict[str, str]:
    """Return a text by its languages."""
    return dict(zip(LANGUAGES, text, strict=True))
