"""Checked rows of an inventory: the piece, where it stands, and the measures to compare."""

from __future__ import annotations

import re
from collections.abc import Callable, Hashable, Mapping
from copy import copy
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any

from cachetools import LRUCache

from stayput.catalogue import phrase
from stayput.contents.contents import Contents, emptied
from stayput.errors import (
    InputError,
    no_length,
    not_allowed,
    too_many,
    unknown,
    visible,
    whole_within,
    within,
)
from stayput.inventory.cells import (
    LENGTHS,
    Cell,
    Unusable,
    is_empty,
    number_of,
    numbers_of,
    plain,
    shown,
    storey_of,
    text_of,
)
from stayput.inventory.columns import TOTAL_ROW, plain_name
from stayput.inventory.scenarios import Scenarios, checked_table, stated_building
from stayput.inventory.store import ground_spec
from stayput.measures import MEASURES, Measure, hold
from stayput.measures.measure import refuse_conflicts
from stayput.model.room import WALLS, Floor, Room, Wall
from stayput.model.state import refuse_bad_start
from stayput.saved import to_text
from stayput.scenario.pieces import PieceTable
from stayput.vocabulary import plain_word

if TYPE_CHECKING:
    from stayput.model.body import Body
    from stayput.scenario import Scenario
    from stayput.scenario.tables import BuildingTable

MOST_CACHED = 100_000
"""Bodies, and rooms with their measures, that are cached for rows with the same values."""

MOST_OPTIONS = 20
"""Most sets of measures that a row compares."""

OF_THE_BODY = ("preset", "width", "length", "height", "mass", "cg_offset", "load")
OF_THE_ROOM = ("floor", "gap", "wall", "fixed", "measures")
SIZES = {**dict.fromkeys(("width", "length", "height"), (*LENGTHS, "m")), "mass": (0.1, 50_000.0, "kg")}
"""What a piece of an inventory may have; beyond, its numbers are in another unit than is stated."""

OF_THE_CONTENTS = ("contents", "doors", "drawers", "lip", "load")

NO_MEASURE = NOTHING = "none"
"""What a row says of a piece without a measure, or with nothing inside where the scenario has contents."""

_WORDS_OF_FIXINGS = {
    NO_MEASURE: "none|no|n|0|false|free|loose|unfixed|unanchored|unsecured|not fixed|not anchored|not secured"
    "|なし|無し|無|未|未固定|未実施|未対策|固定なし|×",
    "l_bracket": "yes|y|1|true|fixed|anchored|secured|bolted|screwed|bracket|brackets|l-bracket|l-brackets"
    "|有|有り|あり|固定あり|○|◯|〇|✓|✔|済|済み|固定|固定済|固定済み|実施済|対策済|l字金具|l字型金具|l型金具",
    "belt": "strap|straps|strapped|ベルト",
    "tension_pole": "突っ張り棒|突張り棒|つっぱり棒|ポール",
    "gel_mats": "粘着マット|耐震マット|ジェルマット",
    "wedge_stopper": "ストッパー|転倒防止板",
    "chain": "chained|チェーン",
}
"""What tables write: of a piece that is fixed, and nobody says how, as of one with L-brackets."""

FIXINGS = {
    **{plain_word(word): kind for kind, measure in MEASURES.items() for word in (kind, *measure.label)},
    **{word: kind for kind, words in _WORDS_OF_FIXINGS.items() for word in words.split("|")},
}
"""What fixes a piece, by what tables call it, each as `plain_word` gives it."""

WALL_WORDS = {
    **dict.fromkeys(("間柱", "柱", "下地あり"), "stud"),
    **dict.fromkeys(("石こうボード", "石膏ボード", "下地なし", "gypsum board", "drywall"), "plasterboard"),
    **dict.fromkeys(("コンクリート",), "concrete"),
    **dict.fromkeys(("付け鴨居", "長押"), "hanging strip"),
}
"""Constructions of walls, by what tables call them."""

ANY_MASS = 100.0
"""Mass of a piece whose row has none [kg]: how it moves alone does not depend on it."""

LONGEST_NAME = 100
"""Letters of what a piece is called that are kept."""


@dataclass(frozen=True, slots=True, eq=False)
class Exposure:
    """A checked row of an inventory under one event.

    Parameters
    ----------
    row : dict
        What the plan's row says of it.
    ground : str
        Spec of the shaking of its building.
    storey : int
        The storey that it moves with: 1 on the ground.
    piece : str
        Spec of the piece with its contents in its room.
    options : list of str
        Specs of the sets of measures, that without a measure first.
    """

    row: dict[str, Any]
    ground: str
    storey: int
    piece: str
    options: list[str]


class ResultCache(LRUCache["Hashable", Any]):
    """Cache of results, refusals among them."""

    def result(self, key: Hashable, make: Callable[[], Any]) -> Any:
        """Return the result for a key, or raise the refusal: a copy, since each raise adds to a traceback."""
        if key not in self:
            try:
                self[key] = make()
            except InputError as error:
                self[key] = error.with_traceback(None)
        if isinstance(value := self[key], InputError):
            raise copy(value)
        return value


class RowReader:
    """Checks rows.

    Parameters
    ----------
    scenarios : Scenarios
        The scenarios.

    Attributes
    ----------
    roofs : dict of str to int
        Number of the roof of each building that has a piece there.
    """

    def __init__(self, scenarios: Scenarios) -> None:
        self.scenarios = scenarios
        self.bodies, self.rooms, self.buildings, self.grounds = (ResultCache(MOST_CACHED) for _ in range(4))
        self.roofs: dict[str, int] = {}

    def exposures(self, row: int, cells: Mapping[str, Cell]) -> list[Exposure]:
        """Return what a row says under each event.

        Raises
        ------
        InputError
            The first thing that is wrong.
        """
        piece = text_of("id", cells.get("id")) or numbered(cells.get("name"), row)
        for name in ("id", "name"):
            called = cells.get(name)
            if isinstance(called, str) and TOTAL_ROW.fullmatch(plain_name(called)):
                raise not_allowed(name, shown(called), "inventory.of_a_piece", name)
        count = number_of("count", cells.get("count"))
        count = 1 if count is None else whole_within("count", count, 1, 1_000_000, field="count")
        value = limited("value", cells, 0.0, 1e15)
        lat, lon = limited("lat", cells, -90.0, 90.0, "°"), limited("lon", cells, -180.0, 360.0, "°")
        if (lat is None) != (lon is None):
            name, other = ("lat", "lon") if lat is None else ("lon", "lat")
            raise InputError("scenario.needs_both", name, name=other, other=name)
        weighed = not is_empty(cells.get("mass")) or not is_empty(cells.get("preset"))
        if not weighed and is_empty(cells.get("load")):
            cells = {**cells, "mass": ANY_MASS}
        body = self.bodies.result(_values(cells, OF_THE_BODY), partial(body_of, cells))
        costs = numbers_of("costs", cells.get("costs"))
        about = {"row": row, "id": piece, "name": name_of(cells.get("name")), "count": count}
        about |= {"value": value, "lat": lat, "lon": lon, "weighed": weighed}
        about["in_plane"] = body.length is None or self.scenarios.in_plane
        exposures: list[Exposure] = []
        for event, station, level in self.scenarios.events_at(lat, lon):
            label, building, storey = self._building(cells, station)
            spec, options, not_possible, fixed = self._room(cells, body, station, weighed)
            if costs and len(costs) != len(options) - 1:
                due = phrase("common.so_many_numbers", count=len(options) - 1)
                raise not_allowed("costs", shown(cells.get("costs")), due, "costs")
            possible = [n for n, name in enumerate(options) if name not in not_possible]
            names, specs = list(options), list(options.values())
            here = {
                **about,
                "event": event,
                "station": self.scenarios.all[station].name,
                "level": None if level is None else level.level,
                "shaking_scatter": None if level is None else level.scatter,
                "building": label,
                "storey": None if label is None else storey,
                "fixed": fixed,
                "options": [names[n] for n in possible],
                "costs": [costs[n - 1] for n in possible[1:]] if costs and possible[1:] else None,
                "not_possible": [*not_possible.values()],
            }
            place = station, level, None if building is None else label
            ground = self.grounds.result(place, partial(ground_spec, station, level, building))
            moves_with = max(storey, 1)  # a basement moves as the ground does
            held = [specs[n] for n in possible]
            exposures.append(Exposure(here, ground, moves_with, spec, held))
        for cost in costs:
            within("costs", cost, 0.0, 1e15, field="costs")
        return exposures

    def _room(
        self, cells: Mapping[str, Cell], body: Body, station: int, weighed: bool
    ) -> tuple[str, dict[str, str], dict[str, dict[str, str]], str | None]:
        """Return the piece's spec in its room, those of the options, reasons against some, and its fixing.

        Every option is added to what fixes the piece already. Without a mass only those are possible whose
        forces do not depend on it.
        """
        scenario = self.scenarios.all[station].scenario

        def make() -> tuple[str, dict[str, str], dict[str, dict[str, str]], str | None]:
            room = room_of(cells, scenario)
            if body.length is None and (scenario.stated_dimensions == 3 or room.has_side_walls):
                raise no_length("length")
            refuse_bad_start(body, room, scenario.initial.state())
            options, fixed = options_of(cells, scenario), fixing_of(cells, scenario)
            dimensions = 2 if body.length is None or self.scenarios.in_plane else 3
            not_possible: dict[str, dict[str, str]] = {}
            for name, measures in options.items():
                refuse_conflicts(measures)
                try:
                    refuse_conflicts((*fixed, *measures))
                    held = hold(body, room, _ordered((*fixed, *measures)), dimensions=dimensions)
                    if not weighed and (held.elements or held.body != body):
                        raise InputError("inventory.without_mass", "mass")
                except InputError as error:  # no wall behind, no ceiling, an anchor above the ceiling
                    if name == NO_MEASURE:
                        raise error.about("fixed" if weighed else "mass") from None
                    reasons = {"reason": error.told("en"), "reason_ja": error.told("ja")}
                    not_possible[name] = {"name": name, "code": error.code, **reasons}
            contents = contents_of(cells, body, scenario)
            if contents is not None and not weighed:
                raise InputError("inventory.without_mass", "mass")
            specs = {name: to_text(list(_ordered((*fixed, *each)))) for name, each in options.items()}
            called = "+".join(measure.kind for measure in fixed) or None
            return to_text((body, room, contents)), specs, not_possible, called

        key = station, body, weighed, _values(cells, (*OF_THE_ROOM, *OF_THE_CONTENTS))
        return self.rooms.result(key, make)

    def _building(
        self, cells: Mapping[str, Cell], station: int
    ) -> tuple[str | None, BuildingTable | None, int]:
        """Return the building's name, what moves its floor (none: the ground alone), and the storey."""
        stated = text_of("building", cells.get("building"))
        shaking, cell = self.scenarios.all[station].scenario.shaking, cells.get("storey")
        building = shaking.building
        if stated is not None:
            building = self.buildings.result(stated, lambda: self._named(stated))
        if building is None:
            if plain("storey", cell) is not None:
                raise InputError("inventory.building_missing", "building")
            return None, None, 1
        highest, name = building.highest(), stated or building.building().name
        storey = storey_of(cell, highest) or (shaking.storey if stated is None else None)
        if storey is None:
            raise InputError("scenario.needs_both", "storey", name="building", other="storey")
        if storey == highest:
            self.roofs[name] = storey
        return name, building if storey > 0 else None, storey

    def _named(self, name: str) -> BuildingTable:
        named = self.scenarios.buildings
        building = named[name] if name in named else stated_building(name)
        if building is None:
            known = ", ".join(named) or phrase("inventory.nothing")
            raise InputError("inventory.unknown_building", "building", value=shown(name), known=known)
        return building


def _values(cells: Mapping[str, Cell], names: tuple[str, ...]) -> Hashable:
    return tuple(plain(name, cells.get(name)) for name in names)


def limited(name: str, cells: Mapping[str, Cell], low: float, high: float, unit: str = "") -> float | None:
    """Return the number in a column between limits; None where the cell is empty."""
    value = number_of(name, cells.get(name), unit)
    return None if value is None else within(name, value, low, high, unit, name)


def name_of(cell: Cell) -> str | None:
    """Return what a piece is called, in one line, or None where the cell says nothing of use."""
    if cell is None or isinstance(cell, Unusable):
        return None
    whole = int(cell) if isinstance(cell, float) and cell.is_integer() else cell
    return visible(" ".join(str(whole).split())[:LONGEST_NAME].strip()) or None


def numbered(called: Cell, row: int) -> str:
    """Return the id of a piece whose row has none: what it is called, with its row."""
    name = called.strip()[:LONGEST_NAME].strip() if isinstance(called, str) else ""
    return f"{name} #{row}" if name else f"row {row}"


def body_of(cells: Mapping[str, Cell]) -> Body:
    """Return the body of a row.

    Raises
    ------
    InputError
        What is missing or cannot be.
    """
    table: dict[str, Any] = {"preset": text_of("preset", cells.get("preset"))}
    table |= {name: limited(name, cells, *limits) for name, limits in SIZES.items()}
    if offset := numbers_of("cg_offset", cells.get("cg_offset"), "m"):
        table["cg_offset"] = list(offset)
    if load := numbers_of("load", cells.get("load"), "kg"):
        table["shelves"] = list(load)
    stated = {name: value for name, value in table.items() if value is not None}
    try:
        return checked_table(PieceTable, stated, "furniture").body()
    except InputError as error:
        # A row has columns where a scenario has keys of its table [furniture].
        known = error.renamed("furniture.shelves", "load").renamed("furniture.", "")
        raise known.anywhere() from None


def room_of(cells: Mapping[str, Cell], scenario: Scenario) -> Room:
    """Return the room of a row: the scenario's, with the row's floor, gap and wall.

    Raises
    ------
    InputError
        No such surface or wall, a number that cannot be, or a wall without a gap to it.
    """
    room = scenario.room.room()
    floor, gap = plain("floor", cells.get("floor")), limited("gap", cells, 0.0, 1e4, "m")
    if floor is not None:
        try:
            room = replace(room, floor=_floor(floor, room.floor))
        except InputError as error:
            raise error.about("floor") from None
    if gap is not None:
        room = replace(room, left_wall=replace(room.left_wall or Wall(0.0), gap=gap))
    stated = text_of("wall", cells.get("wall"))
    if stated is not None:
        wall = WALL_WORDS.get(plain_word(stated), stated)
        if wall not in WALLS:
            japanese = ", ".join(map(repr, WALL_WORDS))
            raise unknown("wall", stated, WALLS, "wall", listed=(", ".join(map(repr, WALLS)), japanese))
        if room.left_wall is None:
            raise InputError("scenario.needs_both", "wall", other="gap")
        room = replace(room, left_wall=replace(room.left_wall, construction=wall))
    return room


def _floor(value: str | float, default: Floor) -> Floor:
    losses = {name: getattr(default, name) for name in ("restitution", "normal_restitution")}
    if isinstance(value, str) and ";" not in value:
        return Floor.of(value, **losses)
    pair = numbers_of("floor", value)
    if len(pair) != 2:
        raise not_allowed("floor", shown(value), "inventory.floor", "floor")
    return Floor(*pair, **losses)


def options_of(cells: Mapping[str, Cell], scenario: Scenario) -> dict[str, tuple[Measure, ...]]:
    """Return the options of a row by name, that without a measure first; the scenario's by default.

    Raises
    ------
    InputError
        No such measure, one given twice, or too many.
    """
    named = {measure_set.name: measure_set.measures for measure_set in scenario.options}
    text = text_of("measures", cells.get("measures"), 1000)
    if text is None:
        return {NO_MEASURE: (), **{name: _ordered(measures) for name, measures in named.items()}}
    options: dict[str, tuple[Measure, ...]] = {NO_MEASURE: ()}
    parts = text.split(";")
    if len(parts) > MOST_OPTIONS:
        raise too_many("measures", len(parts), "inventory.parts", MOST_OPTIONS, "measures")
    for part in parts:
        names = [name.strip() for name in part.split("+")]
        measures: tuple[Measure, ...] = ()
        for name in names:
            if name not in named and name not in MEASURES:
                raise unknown("measures", name, dict.fromkeys((*named, *MEASURES)), "measures")
            measures += named[name] if name in named else (MEASURES[name](),)
        together = "+".join(names)
        if together in options:
            raise InputError("common.twice", "measures", name=shown(together))
        options[together] = _ordered(measures)
    return options


def fixing_of(cells: Mapping[str, Cell], scenario: Scenario) -> tuple[Measure, ...]:
    """Return the measures that fix a row's piece already; none where it stands free, or nothing is said.

    Raises
    ------
    InputError
        It is fixed, and how is not known.
    """
    text = text_of("fixed", cells.get("fixed")) or NO_MEASURE
    known = {kind: (measure(),) for kind, measure in MEASURES.items()} | {NO_MEASURE: ()}
    named = {measure_set.name: measure_set.measures for measure_set in scenario.options}
    measures: tuple[Measure, ...] = ()
    for part in map(str.strip, re.split("[+＋、;]", text)):
        kind = part if part in named else FIXINGS.get(plain_word(part))
        if kind is None or (kind == NO_MEASURE and part != text):
            labels = (measure.label for measure in MEASURES.values())
            words = zip(("yes", "あり"), ("no", "なし"), *labels, strict=True)
            english, japanese = (", ".join(map(repr, each)) for each in words)
            raise unknown("fixed", text, FIXINGS, "fixed", listed=(english, japanese))
        measures += (known | named)[kind]
    refuse_conflicts(measures)
    return measures


def _ordered(measures: tuple[Measure, ...]) -> tuple[Measure, ...]:
    return tuple(sorted(measures, key=lambda measure: measure.kind))


def contents_of(cells: Mapping[str, Cell], body: Body, scenario: Scenario) -> Contents | None:
    """Return what is in a row's piece: the scenario's contents, with what the row says; None for nothing.

    A load shelf by shelf is that of the contents; one that is spread evenly is their share of the mass.

    Parameters
    ----------
    cells : mapping
        The row.
    body : Body
        The piece with its load.
    scenario : Scenario
        Where the piece stands.

    Raises
    ------
    InputError
        No such contents, doors or drawers; doors, drawers or a lip without contents; contents that are too
        heavy for the piece.
    """
    kind = text_of("contents", cells.get("contents"))
    words = {name: text_of(name, cells.get(name)) for name in ("doors", "drawers")}
    stated: dict[str, Any] = {**words, "lip": number_of("lip", cells.get("lip"), "m")}
    stated = {name: value for name, value in stated.items() if value is not None}
    table = scenario.contents_table
    if kind == NOTHING or (kind is None and table is None and not stated):
        return None
    if kind is None and table is None:
        raise InputError("scenario.needs_both", "contents", name=next(iter(stated)), other="contents")
    values: dict[str, Any] = {} if table is None else table.model_dump(exclude_unset=True)
    values |= stated if kind is None else {"kind": kind, **stated}
    loads = numbers_of("load", cells.get("load"), "kg")
    if len(loads) == 1:
        values |= {"loads": None, "mass_share": loads[0] / body.mass}
    elif loads:  # they say how many shelves there are, and what is on all of them
        values = {name: value for name, value in values.items() if name not in ("shelves", "mass_share")}
        values["loads"] = loads
    elif values.get("loads"):
        values["loads"] = tuple(values["loads"])
    try:
        contents = Contents(**values)
    except InputError as error:
        columns = {"kind": "contents", "loads": "load"}
        raise error.about(columns.get(error.field or "", error.field)) from None
    emptied(body, contents)  # refuses what is too heavy
    return contents
