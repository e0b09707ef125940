"""`verify`: which measures keep furniture standing, of a scenario or of Python objects, which make one."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, fields, replace
from os import PathLike
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from stayput.building.building import Building
from stayput.building.model import ShearModel
from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, list_of, not_allowed, shown, within, word_of
from stayput.fragility.intensity_measures import IntensityMeasure, intensity_measure
from stayput.measures import MEASURES, Measure
from stayput.measures.measure import refuse_conflicts
from stayput.model.body import Body
from stayput.model.floor_plan import FloorPlan, PersonPlace
from stayput.model.room import WALLS_AROUND, Ceiling, Floor, Room, Wall
from stayput.montecarlo.counting import SLIDE_LIMIT
from stayput.motion.record import Motion
from stayput.motion.suites.suite import Suite
from stayput.scenario.measures import NOTHING, Option, table_of
from stayput.scenario.scenario import Scenario
from stayput.simulation.case import Case
from stayput.simulation.piece import Piece
from stayput.simulation.scene import Joint, Scene
from stayput.uncertainty import Uncertainty
from stayput.verification.compare import compare

AXES = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)

SAME_HEIGHT = 1e-6
"""How far what stands on a piece may be above or below its top, by rounding [m]."""

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from stayput.verification.verdict import Verdict


StatedShaking = Motion | Suite | Sequence[Motion] | str | float | Mapping[str, Any]
"""Motions; the JMA intensity of the ground, or its class; or the keys of ``[shaking]`` of a scenario file."""

MeasureSet = Measure | str | Sequence[Measure | str]
"""A measure, or several together; each a value, or the name of its kind: `MEASURES`."""

MeasureSets = Sequence[MeasureSet] | Mapping[str, MeasureSet]
"""Sets of measures that are compared, under names of one's own or not."""


def scenario_of(
    stands: Tables,
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
    stands : tuple
        What stands where.
    shaking, measures, uncertainty, building, storey
        As for `verify`.
    tables : mapping
        Further tables of a scenario file, such as ``{"uncertainty": {"samples": 100}}``.

    Raises
    ------
    InputError
        Something of another kind, or what a scenario file may not say.
    """
    shaking = _plain(shaking)
    motions = _motions(shaking)
    stated: dict[str, Any] = {}
    if motions is None:
        table = {"intensity": shaking} if isinstance(shaking, str | float | int) else shaking
        stated = dict(cast("Mapping[str, Any]", table))
    for name, value, kind in (("building", building, (Building, ShearModel)), ("storey", storey, int)):
        if value is not None:
            if name in stated:
                raise InputError("scenario.only_one", name, other=f"shaking.{name}")
            stated[name] = instance_of(name, _plain(value), kind)
    data: dict[str, Any] = {**stands[0], **_plain(dict(tables)), "shaking": stated}
    sets = named_sets(() if measures is None else measures)
    if measures is not None and isinstance(data["furniture"], list):
        raise InputError("common.left_out", "measures", where=phrase("scenario.of_a_lone_piece"))
    in_files = all(_in_files(named.measures) for named in sets)
    if sets and in_files:
        data["measures"] = [
            {"name": named.name, "combine": [table_of(item) for item in named.measures]} for named in sets
        ]
    scenario = Scenario.parse(data)
    if uncertainty is not None:
        instance_of("uncertainty", uncertainty, Uncertainty)
    compared = None if in_files and (sets or measures is None) else sets
    return scenario.with_python(motions, compared, uncertainty, stands[1] if any(stands[1]) else None)


Tables = tuple[dict[str, Any], list[dict[str, Any]]]
"""Tables of a scenario file that say what stands where, and of each piece the fields that no file states."""


def tables_of(what: Body | Case | Scene, room: Room) -> Tables:
    """Return the tables of a scenario file of a body in a room, of a case, or of a scene.

    Raises
    ------
    InputError
        The paper's contact law, which knows no devices; a case of another shape.
    """
    if isinstance(what, Body):
        if what.shape is not None:
            return tables_of(Scene([Piece(what)], room), room)
        return {"furniture": _set_fields(what), "room": _room_table(instance_of("room", room, Room))}, []
    if isinstance(what, Scene):
        return _tables_of_scene(what)
    if what.contact != "coulomb":
        raise not_allowed("model.contact", repr(what.contact), "verification.needs_coulomb", "contact")
    if what.body.shape is not None:
        raise InputError("model.another_shape", "body")
    tables: dict[str, Any] = {
        "furniture": _set_fields(what.body) | _measures_table(what.measures),
        "room": _room_table(what.room),
        "initial": asdict(what.initial),
        "gravity": what.gravity,
        "direction": 0.0,
    }
    if what.dimensions is not None:
        tables["dimensions"] = what.dimensions
    return tables, [_own_measures(what.measures)]


def _tables_of_scene(scene: Scene) -> Tables:
    beyond = [_beyond_files(piece) for piece in scene.pieces]
    furniture = [_piece_table(scene, number) for number in range(len(scene.pieces))]
    room, plan = _room_table(scene.room), scene.plan
    tables: dict[str, Any] = {"furniture": furniture, "room": room}
    if plan is not None:
        if plan.walls != FloorPlan.__dataclass_fields__["walls"].default:
            room["walls"] = plan.walls
        tables["plan"] = {"width": plan.width, "length": plan.length}
        tables["doors"], tables["windows"] = [*map(asdict, plan.doors)], [*map(asdict, plan.windows)]
        tables["places"] = [_place_table(place) for place in plan.places]
    elif len(furniture) == 1 and not beyond[0].keys() - {"measures"} and _stands_plainly(scene.pieces[0]):
        return tables | {"furniture": furniture[0]}, beyond
    static, kinetic = scene.friction
    tables |= {"static_friction": static, "kinetic_friction": kinetic}
    tables["joints"] = [_joint_table(joint, scene.names) for joint in scene.joints]
    return tables, beyond


def _stands_plainly(piece: Piece) -> bool:
    """Return whether a piece stands as a lone piece of a file does, in whose axes the walls are."""
    return piece.at == (0.0, 0.0, 0.0) and piece.heading == 0.0


def _piece_table(scene: Scene, number: int) -> dict[str, Any]:
    piece, name = scene.pieces[number], scene.names[number]
    body, (x, y, z) = piece.body, piece.at
    # a mesh is what a file says of any shape; the body itself takes its place
    table = _set_fields(body) if body.shape is None else {"mesh": name, "unit": "m", "mass": body.mass}
    table["name"] = name
    if not _stands_plainly(piece):
        table |= {"at": [x, y, z], "heading": piece.heading}
    for below in range(number if z > 0.0 else 0):
        other = scene.pieces[below]
        (low_x, high_x), (low_y, high_y), (_, top) = map(other.reach, AXES)
        if abs(top - z) <= SAME_HEIGHT and low_x <= x <= high_x and low_y <= y <= high_y:
            table |= {"on": scene.names[below], "at": [x - other.at[0], y - other.at[1]]}
    return table | _measures_table(piece.measures)


def _beyond_files(piece: Piece) -> dict[str, Any]:
    """Return the fields of a piece that a file cannot state: a shape, how it moves at first, own devices."""
    moves = {name: getattr(piece, name) for name in ("tilt", "velocity", "rotation_rate")}
    beyond: dict[str, Any] = {name: value for name, value in moves.items() if any(value)}
    if piece.body.shape is not None:
        beyond["body"] = piece.body
    return beyond | _own_measures(piece.measures)


def _measures_table(measures: Sequence[Measure]) -> dict[str, Any]:
    """Return the key of a piece that states measures which files know."""
    return {"measures": [*map(table_of, measures)]} if measures and _in_files(measures) else {}


def _own_measures(measures: Sequence[Measure]) -> dict[str, Any]:
    """Return the field of a piece with measures that files do not know."""
    return {} if _in_files(measures) else {"measures": tuple(measures)}


def _in_files(measures: Sequence[Measure]) -> bool:
    """Return whether files know all of these measures."""
    return all(type(measure) is MEASURES.get(measure.kind) for measure in measures)


def _joint_table(joint: Joint, names: Sequence[str]) -> dict[str, Any]:
    stated = {key: value for key, value in _set_fields(joint).items() if value != math.inf}
    return stated | {"first": names[joint.first], "second": names[joint.second]}


def _place_table(place: PersonPlace) -> dict[str, Any]:
    table = _set_fields(place)
    return table | {"kind": "bed" if table.pop("blocks") else "desk"}


def named_sets(measures: MeasureSets) -> list[Option]:
    """Return measures that are compared under their names: one's own, or those of their kinds."""
    if isinstance(measures, Mapping):
        return [Option(name, (_together(members),)) for name, members in measures.items()]
    sets = (Option(NOTHING, (_together(members),)) for members in list_of("measures", measures))
    return [replace(option, name=option.generated_name) for option in sets]


def _together(measures: MeasureSet) -> tuple[Measure, ...]:
    each = measures if isinstance(measures, tuple | list) else (measures,)
    made = [
        MEASURES[word_of("measures", item, MEASURES, "measures")]() if isinstance(item, str) else item
        for item in cast("Sequence[Measure | str]", each)
    ]
    together = list_of("measures", made, Measure)
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


def _set_fields(
    value: Body | Floor | Wall | Ceiling | Joint | PersonPlace, base: Floor | None = None
) -> dict[str, Any]:
    """Return the fields of a value that say something, or differ from another; with lists for tuples."""
    table: dict[str, Any] = {}
    for field in fields(value):
        entry: object = getattr(value, field.name)
        if entry is not None and (base is None or entry != getattr(base, field.name)):
            table[field.name] = [*cast("tuple[float, ...]", entry)] if isinstance(entry, tuple) else entry
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
    what: Scenario | Case | Scene | Body,
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
    threads: int | None = None,
    progress: bool | None = None,
    on_progress: Callable[[int, int], None] | None = None,
    on_verdict: Callable[[Verdict], None] | None = None,
) -> Verdict:
    """Compare measures over motions and over draws of the uncertain quantities.

    Every option meets the same motions and the same draws. They run in looks, those of which more has to be
    known more often, until that is known which people read, to the precision that is asked for or a usual
    one: see `stayput.verification.race`. A number of samples that is asked for is made of all options.

    Parameters
    ----------
    what : Body, Scene, Case or Scenario
        What stands. A scene has its room. A case has its room and its motion, which comes from where it says;
        a scenario says everything. Where the motions of a body or a scene come from is drawn, if they have
        two components. Of several pieces joints and measures on each are compared, and of a room single
        changes of it. The measures of pieces and cases themselves are in place in what others are compared
        with, and are compared with none where there are no others.
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
        What a lone piece is compared with: each a `Measure`, of one's own as well, or the name of its kind,
        "belt", or several that are in place together; a mapping names them. With none in it only the
        furniture without measures is verified, or with its own. The usual ones by default.
    changes : bool
        Whether single changes are tried in a room that names no options: a measure on each piece that does
        harm or falls, another place for it, and for those whom it hits.
    uncertainty : Uncertainty, optional
        The quantities that are drawn for a body or a case, by the names of `stayput.uncertainty.USUAL`; what
        is not in it is as stated. All, as they are usually, by default.
    samples : int, optional
        Runs with each option, spread evenly over the motions, and one of each motion at least: 8 samples of a
        suite of 40 motions are 40 runs. Beside a precision the most runs.
    seed : int, optional
        Seed of the draws.
    precision : float, optional
        Half-width of the 95 % interval of the probability of overturning that is enough, of a body or a case.
    levels : array_like, optional
        JMA intensities of the ground, increasing, at which all options run for the fragility curves beside
        what is stated; with none in it there are no curves. By default the curves of a lone piece come from
        the runs of the ranking, of which two in five are beside the stated shaking; others have none.
    intensity_measures : sequence of IntensityMeasure, optional
        What else the curves are drawn against, beside the usual measures: ``MMI`` of
        `stayput.fragility.intensity_measures`, or its ``spectral_acceleration`` at a period.
    slide_limit : float
        Slide that counts as too far [m].
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    progress : bool, optional
        Whether to draw a bar on standard error; default on a terminal.
    on_progress : callable, optional
        Called with the runs made and with the most that there may be, for a bar of one's own; an exception
        that it raises stops the work.
    on_verdict : callable, optional
        Called with the ranking after each look, before it is `complete`.

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
    instance_of("changes", _plain(changes), bool)
    limit = within("verification.slide_limit", slide_limit, 0.0, 1e3, "m", "slide_limit")
    settings = {"samples": samples, "seed": seed, "precision": precision}
    stated = {key: value for key, value in settings.items() if value is not None}
    place: dict[str, Any] = {"building": building, "storey": storey}
    in_python = {"room": room, "shaking": shaking, **place, "measures": measures, "uncertainty": uncertainty}
    if isinstance(what, str | PathLike):
        raise InputError("common.only_a_path", "what", value=repr(str(what)), reader="read")
    subject = instance_of("what", what, (Scenario, Case, Scene, Body))
    tables: dict[str, Any] = {"uncertainty": stated} if stated else {}
    if isinstance(subject, Scenario):
        _refuse_beside(subject, in_python | settings)
        scenario = subject
    else:
        if isinstance(subject, Case):
            _refuse_beside(subject, {key: in_python[key] for key in ("room", "shaking", *place)})
            shaking = subject.motion
        elif isinstance(subject, Scene):
            _refuse_beside(subject, {"room": room})
        if shaking is None:
            raise InputError("scenario.missing", "shaking", allowed=phrase("verification.no_shaking"))
        stands = tables_of(subject, Room() if room is None else room)
        scenario = scenario_of(stands, shaking, measures, uncertainty, **place, tables=tables)
    further = list_of("intensity_measures", intensity_measures, IntensityMeasure)
    known = dict.fromkeys(intensity_measure(measure.key, "intensity_measures") for measure in further)
    return compare(
        scenario,
        changes=changes,
        levels=levels,
        further=[*known],
        slide_limit=limit,
        threads=threads,
        progress=progress,
        on_progress=on_progress,
        on_verdict=on_verdict,
    )


def _refuse_beside(what: Scenario | Case | Scene, stated: dict[str, Any]) -> None:
    """Refuse what something says already, given beside it."""
    for name, value in stated.items():
        if value is not None:
            where = phrase("verification.said_already", kind=type(what).__name__)
            raise InputError("common.left_out", name, where=where)
