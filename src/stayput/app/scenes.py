"""A scene: a scenario as JSON, within the server's limits, that names no file of the server."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, cast

from stayput.app.messages import RefusedError, refused
from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError
from stayput.model.parameters import parameter_of
from stayput.motion.synthetic import sine
from stayput.scenario import Scenario
from stayput.scenario.measures import YOURS
from stayput.scenario.shaking import RECORD_FILES, ShakingTable, SuiteTable

if TYPE_CHECKING:
    from stayput.app.limits import Limits
    from stayput.app.motions import Motions

TABLES = frozenset(field.alias or name for name, field in Scenario.model_fields.items())
"""Keys of a scene."""


def read_scene(
    data: Mapping[str, Any], measures: Sequence[Mapping[str, Any]], limits: Limits, motions: Motions
) -> Scenario:
    """Make a scenario of a scene: of one piece, of several, or of a room with a plan.

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
        scene["measures"] = [{"name": YOURS, "combine": [dict(measure) for measure in measures]}]
    _few_entries(scene.get("measures"), "measures", limits.options)
    _refuse_half_characters(scene)
    _check_shaking(_table(scene.get("shaking")), limits, motions)
    try:
        scenario = Scenario.parse(scene, motions.folder)
    except InputError as error:
        raise refusal(error, bool(measures)) from None
    for number, piece in enumerate(scenario.pieces):
        if piece.mesh is not None:
            raise refused(422, "app.no_mesh", f"scene.{scenario.key_of(number)}.mesh", name=piece.title)
    _few_entries([*scenario.pieces], "furniture", limits.pieces)
    if scenario.samples > limits.samples:
        raise too_many("uncertainty.samples", scenario.samples, limits.samples)
    return scenario


def short_enough(scenario: Scenario, limits: Limits) -> Scenario:
    """Return a scenario that is to be run once, if its motion is not too long for its pieces.

    Raises
    ------
    RefusedError
        It is too long, or its record cannot be read.
    """
    if scenario.alone:
        return scenario
    count = len(scenario.pieces)
    try:
        motion = scenario.motion()
    except InputError as error:
        raise refusal(error) from None
    most = min(limits.duration, limits.samples_of_motion * motion.dt, limits.seconds_of_pieces / count)
    if motion.duration > most:
        name = phrase("app.duration_for_pieces", count=count)
        raise too_many("shaking", round(motion.duration), round(most), name)
    return scenario


def too_many(field: str, value: float, most: float, name: str | Phrase = "") -> RefusedError:
    """Return the refusal of more than the server allows of what a field says, or of something by its name."""
    called = phrase(name) if name else field
    return refused(422, "app.many", f"scene.{field}", name=called, value=value, most=most)


def motions_of(shaking: ShakingTable) -> int:
    """Return how many motions a verification takes."""
    if not shaking.of_a_suite:
        return 1
    made = shaking.suite if isinstance(shaking.suite, SuiteTable) else SuiteTable()
    return made.count


def uploaded_motions(scenario: Scenario) -> frozenset[str]:
    """Return the uploaded motions that a scene reads."""
    shaking = scenario.shaking
    return frozenset(name for key in RECORD_FILES if isinstance(name := getattr(shaking, key), str))


def unchanged(scenario: Scenario) -> dict[str, object]:
    """Return what changes leave as it is: all but where pieces and people are, and measures."""
    moved = {"at", "heading", "against", "along", "gap", "measures"}
    same = scenario.model_dump(exclude={"title": True, "places": True, "furniture": {"__all__": moved}})
    places = [replace(place.place(), at=(0.0, 0.0), heading=0.0) for place in scenario.places]
    return {**same, "places": places}


def refusal(error: InputError, beside: bool = False) -> RefusedError:
    """Return a refusal with the sentence of an error; ``beside``: measures came beside the scene."""
    field = error.field or ""
    if re.split(r"[.\[]", field)[0] not in TABLES:
        return RefusedError(422, error.about(None))
    if beside and field.startswith("measures"):
        known = error.renamed("measures[0].combine", "measures").anywhere()
        return RefusedError(422, known)
    return RefusedError(422, error.about(f"scene.{field}"))


def _refuse_half_characters(scene: dict[str, Any]) -> None:
    """Refuse texts that are no Unicode (halves of pairs), which could not be sent back."""
    try:
        json.dumps(scene, ensure_ascii=False, default=str).encode("utf-8")
    except UnicodeEncodeError:
        raise refused(422, "app.half_character", "scene") from None


def _check_shaking(shaking: dict[str, Any], limits: Limits, motions: Motions) -> None:
    """Refuse a shaking that names a file of the server or is too long, before any motion is made."""
    for key in RECORD_FILES:
        name, place = shaking.get(key), f"shaking.{key}"
        if isinstance(name, str) and motions.used(name) is None:
            raise refused(422, "app.no_such_record", f"scene.{place}", name=place)
    if isinstance(shaking.get("suite"), str):
        raise refused(422, "app.suite_folder", "scene.shaking.suite")
    suite, building, harmonic = (_table(shaking.get(key)) for key in ("suite", "building", "sine"))
    _at_most(suite, "shaking.suite", "count", limits.suite)
    _at_most(building, "shaking.building", "storeys", limits.storeys)
    _few_entries(building.get("masses"), "shaking.building.masses", limits.storeys)
    if harmonic:
        _check_sine(harmonic, limits)


def _check_sine(table: dict[str, Any], limits: Limits) -> None:
    duration, quiet, dt = (
        _number(table.get(key, parameter_of(sine, key).default)) for key in ("duration", "quiet", "dt")
    )
    length = duration + quiet
    if length > limits.duration:
        raise too_many("shaking.sine.duration", length, limits.duration, "app.duration")
    step = min(dt, duration)  # at least one step in the shaking
    samples = length / step if step > 0.0 else 0.0
    if samples > (most := limits.samples_of_motion):
        raise too_many("shaking.sine.dt", round(samples), most, "app.samples")


def _table(value: object) -> dict[str, Any]:
    """Return a table; an empty one for what is none, which the scenario's own check refuses."""
    return cast("dict[str, Any]", value) if isinstance(value, dict) else {}


def _at_most(table: dict[str, Any], name: str, key: str, most: int) -> None:
    value = _number(table.get(key, 0))
    if value > most:
        raise too_many(f"{name}.{key}", value, most)


def _few_entries(value: object, name: str, most: int) -> None:
    if isinstance(value, list) and (count := len(cast("list[Any]", value))) > most:
        raise too_many(name, count, most, phrase("app.entries", name=name))


def _number(value: object) -> float:
    """Return a number; 0 for a value that the scenario's own check refuses."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return 0.0
    try:
        number = float(value)
    except OverflowError:  # a whole number of hundreds of digits
        return 1e300 if value > 0 else -1e300
    return number if math.isfinite(number) else 0.0
