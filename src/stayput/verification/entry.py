"""`verify`: which measures keep furniture standing, of a scenario or of Python objects, which make one."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, fields, replace
from os import PathLike
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from stayput.building.building import Building
from stayput.building.model import ShearModel
from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, list_of, not_allowed, shown, within
from stayput.fragility.intensity_measures import IntensityMeasure, intensity_measure
from stayput.measures import MEASURES, Measure
from stayput.measures.measure import refuse_conflicts
from stayput.model.body import Body
from stayput.model.room import WALLS_AROUND, Ceiling, Floor, Room, Wall
from stayput.montecarlo.counting import SLIDE_LIMIT
from stayput.motion.record import Motion
from stayput.motion.suites.suite import Suite
from stayput.scenario.measures import NOTHING, Option, table_of
from stayput.scenario.scenario import Scenario
from stayput.simulation.case import Case
from stayput.uncertainty import Uncertainty
from stayput.verification.compare import compare

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from stayput.verification.verdict import Verdict


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
    own_tables: dict[str, Any] = {"initial": asdict(case.initial), "gravity": case.gravity, "direction": 0.0}
    if case.dimensions is not None:
        own_tables["dimensions"] = case.dimensions
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


def verify(
    what: Scenario | Case | Body,
    room: Room | None = None,
    *,
    shaking: StatedShaking | None = None,
    building: Building | ShearModel | None = None,
    storey: int | None = None,
    measures: MeasureSets | None = None,
    changes: bool = True,
    uncertainty: Uncertainty | None = None,
    samples: int | None = None,
    seed: int | None = None,
    precision: float | None = None,
    levels: ArrayLike | None = None,
    intensity_measures: Sequence[IntensityMeasure] = (),
    slide_limit: float = SLIDE_LIMIT,
    every_run: bool = False,
    threads: int | None = None,
    progress: bool | None = None,
    on_progress: Callable[[int, int], None] | None = None,
    on_verdict: Callable[[Verdict], None] | None = None,
) -> Verdict:
    """Compare measures over motions and over draws of the uncertain quantities.

    Every option meets the same motions and the same draws. At the stated shaking samples are added until
    every probability has the precision that is asked for, or the most samples are done; then come the levels
    of the fragility curves, without the runs whose outcome stronger shaking tells: see
    `stayput.montecarlo.runs`.

    Parameters
    ----------
    what : Body, Case or Scenario
        What stands. A case has its room, its motion, which comes from where it says, and its own measures; a
        scenario says everything. Where the motions of a body come from is drawn, if it has a length. Of
        several pieces joints and measures on each are compared, and of a room single changes of it.
    room : Room, optional
        Where a body stands; on a wooden floor without walls by default.
    shaking : Motion, Suite, sequence of Motion, str, float or mapping
        How a body is shaken: by motions as they are; by the built-in suite to a JMA intensity of the ground
        or its class, "6-upper"; or as ``[shaking]`` of a scenario file says, ``{"pga": 4.0}``.
    building : Building or ShearModel, optional
        The building in which a body stands; the shaking is that of the ground below it.
    storey : int, optional
        The storey of the building where a body stands.
    measures : sequence or mapping, optional
        What a body or a case is compared with: each a `Measure`, of one's own as well, or several that are in
        place together; a mapping names them. With none in it only the furniture without measures is verified,
        or with a case's own. The usual ones by default.
    changes : bool
        Whether single changes are tried in a room that names no options: a measure on each piece that does
        harm or falls, another place for it, and for those whom it hits.
    uncertainty : Uncertainty, optional
        The quantities that are drawn for a body or a case, by the names of `stayput.uncertainty.USUAL`; what
        is not in it is as stated. All, as they are usually, by default.
    samples, seed : int, optional
        Most samples of each set of measures, and the seed of the draws, of a body or a case.
    precision : float, optional
        Half-width of the 95 % interval of the probability of overturning that is enough, of a body or a case.
    levels : array_like, optional
        JMA intensities of the ground for the fragility curves, increasing; with none in it there are no
        curves. Default `stayput.verification.LEVELS`; of several pieces and rooms none.
    intensity_measures : sequence of IntensityMeasure, optional
        What else the curves are drawn against, beside the usual measures: ``MMI`` of
        `stayput.fragility.intensity_measures`, or its ``spectral_acceleration`` at a period.
    slide_limit : float
        Slide that counts as too far [m].
    every_run : bool
        Whether to make all runs of the curves, to check those that are settled without.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    progress : bool, optional
        Whether to draw a bar on standard error; default on a terminal.
    on_progress : callable, optional
        Called with the runs made or settled and with all runs, for a bar of one's own; an exception that it
        raises stops the work.
    on_verdict : callable, optional
        Called with the ranking as it gets better, before it is `complete`: after some samples, after all and
        each change, and then come the curves and all else. The samples' bits do not depend on it.

    Returns
    -------
    Verdict
        The options, the best first.

    Raises
    ------
    InputError
        The paper's contact law, which knows no devices; measures of which none can be applied; a record
        that cannot be read; what a scenario says already, given beside it.

    Examples
    --------
    >>> import stayput as sp
    >>> bookcase, room = sp.Body(0.3, 1.8, 90.0), sp.Room(left_wall=sp.Wall(0.01))
    >>> brackets = sp.MEASURES["l_bracket"]()
    >>> verdict = sp.verify(bookcase, room, shaking="6-lower", measures=[brackets], samples=20, levels=[])
    >>> verdict.best.option.name
    'l_bracket'

    Motions of the ground, and a building between it and the bookcase:

    >>> tower, records = sp.Building(6, "RC"), [sp.near_fault(), sp.near_fault().scaled(0.5)]
    >>> verdict = sp.verify(bookcase, room, shaking=records, building=tower, storey=5, samples=4, levels=[])
    >>> verdict.motions
    2
    """
    for name, switch in (("changes", changes), ("every_run", every_run)):
        instance_of(name, _plain(switch), bool)
    limit = within("verification.slide_limit", slide_limit, 0.0, 1e3, "m", "slide_limit")
    settings = {"samples": samples, "seed": seed, "precision": precision}
    stated = {key: value for key, value in settings.items() if value is not None}
    place: dict[str, Any] = {"building": building, "storey": storey}
    in_python = {"room": room, "shaking": shaking, **place, "measures": measures, "uncertainty": uncertainty}
    if isinstance(what, str | PathLike):
        raise InputError("common.only_a_path", "what", value=repr(str(what)), reader="read_scenario")
    subject = instance_of("what", what, (Scenario, Case, Body))
    tables: dict[str, Any] = {"uncertainty": stated} if stated else {}
    match subject:
        case Body():
            if shaking is None:
                raise InputError("scenario.missing", "shaking", allowed=phrase("verification.no_shaking"))
            scenario = scenario_of(
                subject, room or Room(), shaking, measures, uncertainty, **place, tables=tables
            )
        case Case():
            _refuse_beside(subject, {key: in_python[key] for key in ("room", "shaking", *place)})
            scenario = scenario_of_case(subject, measures, uncertainty, tables=tables)
        case _:
            _refuse_beside(subject, in_python | settings)
            scenario = subject
    further = list_of("intensity_measures", intensity_measures, IntensityMeasure)
    known = dict.fromkeys(intensity_measure(measure.key, "intensity_measures") for measure in further)
    return compare(
        scenario,
        changes=changes,
        levels=levels,
        further=[*known],
        slide_limit=limit,
        every_run=every_run,
        threads=threads,
        progress=progress,
        on_progress=on_progress,
        on_verdict=on_verdict,
    )


def _refuse_beside(what: Scenario | Case, stated: dict[str, Any]) -> None:
    """Refuse what something says already, given beside it."""
    for name, value in stated.items():
        if value is not None:
            where = phrase("verification.said_already", kind=type(what).__name__)
            raise InputError("common.left_out", name, where=where)
