"""A scenario of Python objects: a body, a room, motions and measures in the place of a file's tables."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields, replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from stayput.building.building import Building
from stayput.building.model import ShearModel
from stayput.errors import InputError, instance_of, list_of, not_allowed, shown
from stayput.measures import MEASURES, Measure
from stayput.measures.measure import refuse_conflicts
from stayput.model.body import Body
from stayput.model.room import WALLS_AROUND, Ceiling, Floor, Room, Wall
from stayput.motion.record import Motion
from stayput.motion.suites.suite import Suite
from stayput.scenario.measures import table_of
from stayput.scenario.option import NOTHING, Option
from stayput.scenario.scenario import Scenario
from stayput.uncertainty import Uncertainty

if TYPE_CHECKING:
    from stayput.simulation.case import Case

StatedShaking = Motion | Suite | Sequence[Motion] | str | float | Mapping[str, Any]
"""Motions; the JMA intensity of the ground, or its class; or the keys of ``[shaking]`` of a scenario file."""

MeasureSets = Sequence[Measure | Sequence[Measure]] | Mapping[str, Measure | Sequence[Measure]]
"""MeasureSets that are compared: each by itself or several together, under names of one's own or not."""


def scenario_of(
    body: Body,
    room: Room,
    shaking: StatedShaking,
    measures: MeasureSets | None = None,
    uncertainty: Uncertainty | None = None,
    *,
    building: Building | ShearModel | None = None,
    storey: int | None = None,
    tables: Mapping[str, Any] = MappingProxyType({}),
) -> Scenario:
    """Make a scenario of Python objects.

    Parameters
    ----------
    body : Body
        What stands.
    room : Room
        Where it stands.
    shaking : Motion, Suite, sequence of Motion, str, float or mapping
        Motions as they are; or the JMA intensity of the ground or its class, "6-upper", under the built-in
        suite; or what ``[shaking]`` of a scenario file says.
    measures : sequence or mapping, optional
        What is compared; each a `Measure`, of one's own as well, or several that are in place together. None
        are with none in it; the usual ones by default.
    uncertainty : Uncertainty, optional
        The quantities that are drawn, by the names of `stayput.uncertainty.USUAL`; all others are as stated.
    building : Building or ShearModel, optional
        What stands between the ground, of which the motions are then, and the body.
    storey : int, optional
        The storey where the body stands.
    tables : mapping
        Further tables and keys of a scenario file, such as ``{"uncertainty": {"samples": 100}}``.

    Raises
    ------
    InputError
        Something of another kind, or what a scenario file may not say.
    """
    shaking = _plain(shaking)
    motions = _motions(shaking)
    if instance_of("body", body, Body).shape is not None:
        raise InputError("model.another_shape", "body")
    data: dict[str, Any] = {
        "furniture": _set_fields(body),
        "room": _room_table(instance_of("room", room, Room)),
    }
    stated: dict[str, Any] = {}
    if motions is None:
        table = {"intensity": shaking} if isinstance(shaking, str | float | int) else shaking
        stated = dict(cast("Mapping[str, Any]", table))
    for name, value, kind in (("building", building, (Building, ShearModel)), ("storey", storey, int)):
        if value is not None:
            if name in stated:
                raise InputError("scenario.only_one", name, other=f"shaking.{name}")
            stated[name] = instance_of(name, _plain(value), kind)
    data["shaking"] = stated
    sets = named_sets(() if measures is None else measures)
    in_files = all(type(item) is MEASURES.get(item.kind) for named in sets for item in named.measures)
    if sets and in_files:
        data["measures"] = [
            {"name": named.name, "combine": [table_of(item) for item in named.measures]} for named in sets
        ]
    scenario = Scenario.parse(data | _plain(dict(tables)))
    if uncertainty is not None:
        instance_of("uncertainty", uncertainty, Uncertainty)
    compared = None if in_files and (sets or measures is None) else sets
    return scenario.with_python(motions, compared, uncertainty)


def scenario_of_case(
    case: Case,
    measures: MeasureSets | None = None,
    uncertainty: Uncertainty | None = None,
    *,
    tables: Mapping[str, Any] = MappingProxyType({}),
) -> Scenario:
    """Make a scenario of a case; its own measures are compared with none, beside others."""
    if case.contact != "coulomb":
        raise not_allowed("model.contact", repr(case.contact), "verification.needs_coulomb", "contact")
    in_place = named_sets([case.measures]) if case.measures else []
    own_tables = {
        "initial": asdict(case.initial),
        "gravity": case.gravity,
        "dimensions": 3 if case.in_space else 2,
        "direction": 0.0,
    }
    further = named_sets(() if measures is None else measures)
    sets = {named.name: named.measures for named in (*in_place, *further)}
    tables = dict(tables) | own_tables
    compared = None if measures is None and not in_place else sets
    return scenario_of(case.body, case.room, case.motion, compared, uncertainty, tables=tables)


def named_sets(measures: MeasureSets) -> list[Option]:
    """Return measures that are compared under their names: one's own, or those of their kinds."""
    if isinstance(measures, Mapping):
        return [Option(name, (_together(members),)) for name, members in measures.items()]
    sets = (Option(NOTHING, (_together(members),)) for members in list_of("measures", measures))
    return [replace(option, name=option.generated_name) for option in sets]


def _together(measures: Measure | Sequence[Measure]) -> tuple[Measure, ...]:
    together = list_of("measures", measures if isinstance(measures, tuple | list) else (measures,), Measure)
    refuse_conflicts(together)
    return together


def _plain(value: Any) -> Any:
    """Return a value with Python's own numbers in the place of NumPy's single ones, also within mappings."""
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in cast("Mapping[Any, Any]", value).items()}
    single = isinstance(value, np.generic | np.ndarray) and value.ndim == 0
    return cast("np.generic", value).item() if single else cast("Any", value)


def _motions(shaking: StatedShaking) -> Suite | None:
    """Return motions that were given as such; None where it is said otherwise how the ground is shaken."""
    if isinstance(shaking, Motion):
        return Suite((shaking,))
    if isinstance(shaking, Suite):
        return shaking
    if isinstance(shaking, str | float | int | Mapping):
        return None
    if hasattr(shaking, "__array__"):
        raise InputError("motion.only_samples", "shaking", value=shown(shaking))
    return Suite(list_of("shaking", shaking, Motion))


def _set_fields(value: Body | Floor | Wall | Ceiling, base: Floor | None = None) -> dict[str, Any]:
    """Return the fields of a value that say something, or differ from another; with lists for tuples."""
    table: dict[str, Any] = {}
    for field in fields(value):
        entry: object = getattr(value, field.name)
        if entry is not None and (base is None or entry != getattr(base, field.name)):
            table[field.name] = [*cast("tuple[float, float]", entry)] if isinstance(entry, tuple) else entry
    return table


def _room_table(room: Room) -> dict[str, Any]:
    surface = room.floor.surface
    base = Floor.of(surface) if surface else Floor()
    table: dict[str, Any] = {
        "floor": _set_fields(room.floor, base) | ({"surface": surface} if surface else {})
    }
    for name in (*WALLS_AROUND, "ceiling"):
        around: Wall | Ceiling | None = getattr(room, name)
        if around is not None:
            table[name] = _set_fields(around)
    return table
