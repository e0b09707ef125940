"""A scene: a scenario as JSON, within the server's limits, that names no file of the server."""

from __future__ import annotations

import json
import math
import re
from typing import TYPE_CHECKING, Any, cast

from stayput.app.refusals import RefusedError, field_of
from stayput.errors import InputError
from stayput.scenario import Scenario

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from stayput.app.limits import Limits
    from stayput.app.motions import Motions

TABLES = tuple(field.alias or name for name, field in Scenario.model_fields.items())
"""Keys of a scene."""

ID = re.compile(r"[0-9a-f]{32}")
"""What the id of an uploaded motion or of a job looks like."""

YOURS = "yours"
"""Name of the user's own set of measures."""


def read_scene(
    data: Mapping[str, Any], measures: Sequence[Mapping[str, Any]], limits: Limits, motions: Motions
) -> Scenario:
    """Make a scenario of a scene.

    Parameters
    ----------
    data : mapping
        The scene as it came.
    measures : sequence of mapping
        The user's measures, in place together; they take the place of the scene's.
    limits : Limits
        What is accepted.
    motions : Motions
        The motions that were uploaded.

    Raises
    ------
    RefusedError
        What is wrong with it.
    """
    scene = dict(data)
    if measures:
        scene["measures"] = [{"name": YOURS, "combine": [dict(one) for one in measures]}]
    _refuse_half_characters(scene)
    shaking = scene.get("shaking")
    if isinstance(shaking, dict):
        _check_shaking(cast("dict[str, Any]", shaking), limits, motions)
    listed = scene.get("measures")
    if isinstance(listed, list) and len(cast("list[Any]", listed)) > limits.options:
        raise RefusedError(422, f"At most {limits.options} measures can be compared.", "scene.measures")
    try:
        scenario = Scenario.parse(scene, motions.folder)
    except InputError as error:
        raise refusal(error, bool(measures)) from None
    if scenario.uncertainty.samples > limits.samples:
        told = f"uncertainty.samples is {scenario.uncertainty.samples}; this server allows {limits.samples}."
        raise RefusedError(422, told, "scene.uncertainty.samples")
    return scenario


def refusal(error: InputError, own: bool = False) -> RefusedError:
    """Return a refusal with the sentence of an error; ``own``: measures came beside the scene."""
    sentence = str(error)
    field = field_of(sentence, TABLES)
    if own and field is not None and field.startswith("scene.measures"):
        field = field.replace("scene.measures[0].combine", "measures").replace("scene.measures", "measures")
        sentence = sentence.replace("measures[0].combine", "measures").removeprefix("In [measures]: ")
    return RefusedError(422, sentence, field)


def _refuse_half_characters(scene: dict[str, Any]) -> None:
    """Refuse texts that are no Unicode (halves of pairs), which could not be sent back."""
    try:
        json.dumps(scene, ensure_ascii=False).encode("utf-8")
    except UnicodeEncodeError:
        raise RefusedError(422, "A text holds half a character; it must be Unicode.", "scene") from None


def _check_shaking(shaking: dict[str, Any], limits: Limits, motions: Motions) -> None:
    """Refuse what would read a file, or be too long, before any of it is made."""
    for key in ("record", "vertical"):
        name = shaking.get(key)
        if isinstance(name, str):
            if not ID.fullmatch(name) or not motions.knows(name):
                told = f"shaking.{key} is not a motion that this server has; it must be uploaded (again)."
                raise RefusedError(422, told, f"scene.shaking.{key}")
            motions.touch(name)
    suite = shaking.get("suite")
    if isinstance(suite, str):
        told = "shaking.suite is a folder; this server takes suites by family and count only."
        raise RefusedError(422, told, "scene.shaking.suite")
    if isinstance(suite, dict):
        _at_most(cast("dict[str, Any]", suite), "shaking.suite", "count", limits.suite)
    building = shaking.get("building")
    if isinstance(building, dict):
        table = cast("dict[str, Any]", building)
        _at_most(table, "shaking.building", "storeys", limits.storeys)
        masses = table.get("masses")
        if isinstance(masses, list) and len(cast("list[Any]", masses)) > limits.storeys:
            told = f"shaking.building.masses are {len(cast('list[Any]', masses))}; this server allows "
            raise RefusedError(422, f"{told}{limits.storeys}.", "scene.shaking.building.masses")
    sine = shaking.get("sine")
    if isinstance(sine, dict):
        _check_sine(cast("dict[str, Any]", sine), limits)


def _check_sine(sine: dict[str, Any], limits: Limits) -> None:
    duration, quiet, dt = (
        _number(sine.get(key, usual)) for key, usual in (("duration", 30.0), ("quiet", 0.0), ("dt", 0.005))
    )
    length = duration + quiet
    if length > limits.duration:
        told = f"shaking.sine lasts {length:g} s; this server allows {limits.duration:g} s."
        raise RefusedError(422, told, "scene.shaking.sine.duration")
    step = min(dt, duration)  # at least one step in the shaking
    samples = length / step if step > 0.0 else 0.0
    if samples > limits.samples_of_motion:
        told = f"shaking.sine.dt is {dt:g} s, which makes {samples:.0f} samples"
        raise RefusedError(
            422, f"{told}; this server allows {limits.samples_of_motion}.", "scene.shaking.sine.dt"
        )


def _at_most(table: dict[str, Any], name: str, key: str, most: int) -> None:
    value = _number(table.get(key, 0))
    if value > most:
        raise RefusedError(
            422, f"{name}.{key} is {value:g}; this server allows {most}.", f"scene.{name}.{key}"
        )


def _number(value: object) -> float:
    """Return a number, or 0 for what the scenario's own check refuses."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return 0.0
    try:
        number = float(value)
    except OverflowError:  # a whole number of hundreds of digits
        return math.copysign(1e300, value)
    return number if math.isfinite(number) else 0.0
