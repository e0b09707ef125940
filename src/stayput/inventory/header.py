"""Reading the header of an inventory: which column is which, in which unit, or what is unclear about it."""

from __future__ import annotations

from dataclasses import dataclass, field
from difflib import get_close_matches
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.inventory.cells import (
    converting_reader,
    in_own_unit,
    is_empty,
    number_of,
    number_or_none,
    refuse_without_unit,
    shown,
)
from stayput.inventory.columns import (
    ALONG_THE_WALL,
    COLUMNS,
    LISTS,
    LOOKS_LIKE_COUNT,
    LOOKS_LIKE_SIZE,
    SIZES_TOGETHER,
    TOTALS,
    UNITS,
    WIDTHS,
    header_name,
    plain_name,
)
from stayput.inventory.headings import refuse_headings_elsewhere
from stayput.inventory.mapping import IGNORE, ColumnMapping
from stayput.inventory.vocabulary import preset_called, storey_called, storey_meant
from stayput.vocabulary import WORDS, meant

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from stayput.catalogue import Phrase
    from stayput.inventory.cells import Cell, CellReader
    from stayput.inventory.columns import HeaderName, NumberUnit

MOST = 200
"""Most columns of a table."""

LIKENESS = 0.8
"""From this likeness on a column counts as a misspelt one."""

UNKNOWN_SHOWN = 12
"""Most columns that a proposal has with a "?" for what they are."""

DOUBTS_SHOWN = 3
"""Most doubts that a sentence tells."""


class AlongTheWall(NamedTuple):
    """A column of sizes along the wall, and how its cells are read."""

    place: int
    read: CellReader


@dataclass(frozen=True, slots=True)
class Header:
    """Positions of the columns in a row.

    Parameters
    ----------
    places : mapping of str to int
        Place of each known column.
    width : int
        Number of columns.
    unnamed : tuple of int
        Places without a name: they must be empty.
    unused : tuple of str
        Columns that are not known; they are reported and not used.
    readers : mapping of str to callable
        How the cells of a column are read that are in another unit or spelling than the column's own.
    renamed : tuple of str
        What was taken for what, as "width = 奥行 [mm]".
    called : mapping of str to str
        What the table calls the columns that it calls otherwise.
    along_the_wall : AlongTheWall, optional
        The size along the wall, which tells a piece that is narrower than deep.
    """

    places: Mapping[str, int]
    width: int
    unnamed: tuple[int, ...] = ()
    unused: tuple[str, ...] = ()
    readers: Mapping[str, CellReader] | None = None
    renamed: tuple[str, ...] = ()
    called: Mapping[str, str] = field(default_factory=dict[str, str])
    along_the_wall: AlongTheWall | None = None

    def width_of(self, row: Sequence[Cell]) -> float | None:
        """Return the size of a row's piece along the wall [m], or None where the row does not say it."""
        if self.along_the_wall is None:
            return None
        place, read = self.along_the_wall
        try:
            return number_of("width", read(row[place]), "m")
        except InputError:  # the column is not used otherwise, so a row is not refused for it
            return None

    def cells(self, row: Sequence[Cell]) -> dict[str, Cell]:
        """Return the known cells of a row by their columns.

        Raises
        ------
        InputError
            More or fewer cells than columns, one below no name, or one that cannot be read in its unit.
        """
        if len(row) != self.width:
            raise InputError("inventory.row_length", cells=len(row), columns=self.width)
        for place in self.unnamed:
            if not is_empty(row[place]):
                raise InputError("inventory.cell_without_name", cell=place + 1, value=shown(row[place]))
        cells = {name: row[place] for name, place in self.places.items()}
        for name, read in (self.readers or {}).items():
            cells[name] = read(cells[name])
        if "name" in cells and is_empty(cells.get("preset")):
            cells["preset"] = preset_called(cells["name"])
        return cells


class _Doubt(NamedTuple):
    """What is unclear about a column, and the part of ``--columns`` that would settle it."""

    about: Phrase
    settled: str


class _Reading:
    """The columns of a header as they are understood one after another.

    Parameters
    ----------
    names : sequence of str
        The names as they are written; "" where there is none.
    sample : sequence
        Some of the rows.
    mapping : ColumnMapping
        What is stated.
    """

    def __init__(
        self, names: Sequence[str], sample: Sequence[Sequence[Cell]], mapping: ColumnMapping
    ) -> None:
        self.names, self.sample, self.mapping = names, sample, mapping
        self.parts = [header_name(name) for name in names]
        mapped, self.ignored = mapping.places(names)
        self.places = {name: place for name, (place, _) in mapped.items()}
        self.units: dict[str, NumberUnit | None] = {name: unit for name, (_, unit) in mapped.items()}
        self.in_own_units: set[str] = set()
        self.stated = {name for name, (_, unit) in mapped.items() if unit is not None}
        self.doubts: list[_Doubt] = []
        self.proposed: set[str] = set()
        self.unused: list[str] = [names[place][:200] for place in sorted(self.ignored)]
        self.mapped = frozenset(self.places.values())
        taken = {*self.mapped, *self.ignored}
        self.free = [place for place, name in enumerate(names) if name and place not in taken]

    def doubt(self, key: str, settled: str, **values: object) -> None:
        """Note that something is unclear."""
        self.doubts.append(_Doubt(phrase(f"inventory_tables.{key}", **values), settled))

    def numbers(self, place: int) -> list[float]:
        """Return the numbers of a column in the sample."""
        values = (number_or_none(row[place]) for row in self.sample if place < len(row))
        return [value for value in values if value is not None]

    def take_canonical(self) -> None:
        """Take the columns that are called as stayput calls them."""
        for place in list(self.free):
            name = self.names[place].lower()
            if name in COLUMNS and name not in self.places:
                self.places[name], self.units[name] = place, None
                self.free.remove(place)

    def take_aliases(self) -> None:
        """Take the columns that are called as inventories usually call them."""
        for place in list(self.free):
            part, name = self.parts[place], self.parts[place].column
            if part.base in ALONG_THE_WALL or name is None:
                continue
            self.free.remove(place)
            if name in self.places:
                self._second(name, place)
            elif part.note:
                self.doubt(
                    "doubt_note", self._proposed(name, place), header=self._shown(place), note=part.note
                )
            else:
                self.places[name] = place
                self._take_unit(name, place, part)

    def propose_foreign(self) -> None:
        """Doubt the columns that are called so in other languages."""
        found: dict[str, int] = {}
        for place in self.free:
            name = self.parts[place].in_another_language
            if self.parts[place].base == "nombre" and self.numbers(place):
                name = "count"  # in French; in Spanish it is what a piece is called
            if name is not None and name not in self.places:
                found.setdefault(name, place)
        if found:
            settled = ",".join(self._proposed(name, place) for name, place in found.items())
            headers = [self._shown(place) for place in found.values()]
            self.doubt("doubt_language", settled, headers=", ".join(headers[:DOUBTS_SHOWN]))
        self.proposed.update(found)
        self.free = [place for place in self.free if place not in found.values()]

    def _second(self, name: str, place: int) -> None:
        """Take in another column of a name that is taken: a total beside a price is left out."""
        first = self.places[name]
        if name == "width" and self.names[first].lower() == "width" and name not in self.stated:
            proposal = f"{self._proposed('width', place)},{IGNORE}={self.names[first]}"
            self.doubt("doubt_width", proposal, depth=self._shown(place), width=self._shown(first))
        elif name == "value" and self.parts[place].base in TOTALS and self.parts[first].base not in TOTALS:
            self.unused.append(self.names[place][:200])
        elif name == "value" and self.parts[first].base in TOTALS:
            del self.places[name]
            self.unused.append(self.names[first][:200])
            self.places[name] = place
            self._take_unit(name, place, self.parts[place])
        elif name in ("name", "id"):
            self.unused.append(self.names[place][:200])
        else:
            proposal = f"{IGNORE}={self.names[place]}"
            self.doubt("doubt_twice", proposal, a=self._shown(first), b=self._shown(place), name=name)

    def _take_unit(self, name: str, place: int, part: HeaderName) -> None:
        known = UNITS.get(COLUMNS[name].unit, {})
        self.units[name] = known.get(part.unit)
        if part.unit and self.units[name] is None:
            self.doubt("doubt_unit", self._proposed(name, place), header=self._shown(place))
        elif COLUMNS[name].unit in ("m", "kg") and not part.unit:
            cells = [row[place] for row in self.sample if place < len(row)]
            if not self.numbers(place) and any(in_own_unit(cell, COLUMNS[name].unit) for cell in cells):
                self.in_own_units.add(name)
                return
            self.doubt("doubt_no_unit", self._proposed(name, place), header=self._shown(place))

    def take_rest(self) -> None:
        """Look at what is left: doubtful where it would change a result, else not used."""
        known = self.proposed.union(self.places)
        for place in self.free:
            part, header = self.parts[place], self._shown(place)
            if part.base in ALONG_THE_WALL:
                if "width" not in known:
                    settled = f"width=?,{IGNORE}={self.names[place]}"
                    self.doubt("doubt_no_depth", settled, header=header)
                    continue
            elif LOOKS_LIKE_COUNT.fullmatch(part.base) and "count" not in known:
                self.doubt("doubt_count", f"count={self.names[place]}", header=header)
                continue
            elif SIZES_TOGETHER.fullmatch(part.base) and not {"width", "height"} <= known:
                self.doubt("doubt_sizes", f"{IGNORE}={self.names[place]}", header=header)
                continue
            elif _is_size(part) and not {"width", "height"} <= known:
                self.doubt("doubt_size", f"?={self.names[place]}", header=header)
                continue
            else:
                _refuse_misspelt(self.names[place], part)
            self.unused.append(self.names[place][:200])

    def look_at_cells(self) -> None:
        """Doubt what the cells speak against: storeys for a surface, totals for the value of one piece."""
        floor = self.places.get("floor")
        if floor is not None and "storey" not in self.places:
            cells = [str(row[floor]) for row in self.sample if floor < len(row) and row[floor]]
            if cells and all(storey_called(cell) is not None for cell in cells):
                self.doubt("doubt_floor", f"storey={self.names[floor]}", header=self._shown(floor))
        value = self.places.get("value")
        by_alias = value is not None and value not in self.mapped and self.parts[value].base in TOTALS
        if value is not None and by_alias and "count" in self.places:
            self.doubt("doubt_total", f"{IGNORE}={self.names[value]}", header=self._shown(value))

    def unknown(self) -> list[str]:
        """Return the part of a mapping for each column of which nothing is known."""
        return [f"?={name}" for name in self.unused[len(self.ignored) :][:UNKNOWN_SHOWN]]

    def proposal(self, others: Sequence[str] = ()) -> str:
        """Return the mapping to give: what is given already, but for what is doubted, and what settles it."""
        settled = ",".join(dict.fromkeys((*(doubt.settled for doubt in self.doubts), *others)))
        kept = [f"{name}={header}" for name, header in self.mapping.pairs if f",{name}=" not in f",{settled}"]
        ignored = [f"{IGNORE}={header}" for header in self.mapping.ignored]
        return ",".join([*kept, *ignored, settled])

    def along_the_wall(self) -> tuple[int, NumberUnit | None] | None:
        """Return the place and the unit of the size along the wall; one without a unit has the depth's."""
        depth = self.places.get("width")
        for place, part in enumerate(self.parts):
            if place not in self.places.values() and part.base in WIDTHS:
                unit = UNITS["m"].get(part.unit)
                return place, unit or (None if depth is None else self.units["width"])
        return None

    def _shown(self, place: int) -> str:
        return shown(self.names[place])

    def _proposed(self, name: str, place: int) -> str:
        """Return the part of a mapping that is likely meant, with "?" for a unit that is not written."""
        kind = COLUMNS[name].unit
        known = kind not in ("m", "kg") or self.parts[place].unit in UNITS[kind]
        return f"{name}={self.names[place]}" if known else f"{name}={self.names[place]}[?]"


def _is_size(part: HeaderName) -> bool:
    """Return whether a column seems to be a size: by its name, or by its unit."""
    return LOOKS_LIKE_SIZE.fullmatch(part.base) is not None or part.unit in UNITS["m"]


def header_of(
    cells: Sequence[Cell],
    sample: Sequence[Sequence[Cell]] = (),
    mapping: ColumnMapping | None = None,
    decimal_comma: bool = False,
) -> Header:
    """Read the first row of a table.

    Columns are known by stayput's names, by those that inventories usually have, and by a mapping. A column
    that would change a result, and of which it is not certain what it holds or in which unit, is refused
    with a mapping that it looks like. Any other is left out and named in ``unused``.

    Parameters
    ----------
    cells : sequence
        The first row.
    sample : sequence, optional
        Some of the rows below, whose numbers tell a wrong unit.
    mapping : ColumnMapping, optional
        Which column is which.
    decimal_comma : bool
        Whether numbers may have a comma in the place of a point.

    Raises
    ------
    InputError
        Too many columns, two of one name, no name of a piece and no size, one that is unclear or misspelt.
    """
    if len(cells) > MOST:
        raise InputError("inventory.too_many_columns", columns=len(cells), most=MOST)
    names = [cell.strip() if isinstance(cell, str) else "" for cell in cells]
    if len(names) == 1 and "|" in names[0]:
        raise InputError("inventory.commas", row=shown(names[0]))
    refuse_headings_elsewhere(names, sample)
    reading = _Reading(names, sample, mapping or ColumnMapping())
    _refuse_twice(names)
    reading.take_canonical()
    reading.take_aliases()
    reading.propose_foreign()
    reading.take_rest()
    known = reading.proposed.union(reading.places)
    if not {"name", "preset"} & known and not {"width", "height"} <= known:
        _refuse_unknown(names, reading)
    reading.look_at_cells()
    if reading.doubts:
        _refuse_doubts(reading)
    places = {name: reading.places[name] for name in COLUMNS if name in reading.places}
    readers = {
        name: reader
        for name in places
        if (reader := _reader(name, reading.units[name], decimal_comma)) is not None
    }
    for name in reading.in_own_units:
        readers[name] = _each_in_own_unit(name, readers.get(name))
    across = reading.along_the_wall()
    return Header(
        places,
        len(names),
        tuple(place for place, name in enumerate(names) if not name),
        tuple(reading.unused),
        readers,
        tuple(
            _understood(name, names[place][:60], reading.units[name], bool(reading.parts[place].unit))
            for name, place in places.items()
            if names[place].lower() != name or reading.units[name] is not None
        ),
        {name: names[place] for name, place in places.items() if names[place].lower() != name},
        None
        if across is None
        else AlongTheWall(across[0], converting_reader("width", across[1], "m", False, decimal_comma)),
    )


def _understood(name: str, header: str, unit: NumberUnit | None, written: bool) -> str:
    return f"{name} = {header}" if unit is None or written else f"{name} = {header} [{unit.name}]"


def _reader(name: str, unit: NumberUnit | None, decimal_comma: bool) -> CellReader | None:
    """Return how a column's cells are read, or None where they are taken as they are."""
    kind, converted = COLUMNS[name].unit, unit is not None and unit.times != unit.over
    if name == "storey":
        return storey_meant
    words = partial(meant, name) if name in WORDS else None
    numeric = bool(kind) or name in (*LISTS, "count")
    if not converted and kind != "currency" and not (decimal_comma and numeric):
        return words
    numbers = converting_reader(name, unit, kind, name in LISTS, decimal_comma)
    return numbers if words is None else lambda cell: numbers(words(cell))


def _each_in_own_unit(name: str, read: CellReader | None) -> CellReader:
    """Return the reader of a column whose numbers have units of their own, each."""
    refuse = partial(refuse_without_unit, name)
    return refuse if read is None else lambda cell: read(refuse(cell))


def _refuse_twice(names: Sequence[str]) -> None:
    plain = [plain_name(name) for name in names]
    for name in plain:
        if name and plain.count(name) > 1:
            raise InputError("inventory.column_twice", name, name=shown(name))


def _refuse_unknown(names: Sequence[str], reading: _Reading) -> None:
    """Refuse a header in which nothing says what the pieces are, but columns that are not known may."""
    if not any(names):
        raise InputError("inventory.no_names", "inventory")
    if not (unknown := reading.unknown()):
        return
    raise InputError(
        "inventory_tables.no_known_column",
        "columns",
        proposal=reading.proposal(unknown),
        columns=", ".join(COLUMNS),
    )


def _refuse_misspelt(name: str, part: HeaderName) -> None:
    """Refuse a column that looks like a known one."""
    near = get_close_matches(part.base.replace(" ", "_"), COLUMNS, 1, LIKENESS)
    if near:
        raise InputError(
            "inventory.unknown_column",
            name,
            name=shown(name),
            near=repr(near[0]),
            holds=phrase(f"inventory.column_{near[0]}"),
            columns=", ".join(COLUMNS),
        )


def _refuse_doubts(reading: _Reading) -> None:
    told = [doubt.about for doubt in reading.doubts[:DOUBTS_SHOWN]]
    more = len(reading.doubts) - len(told)
    if more:
        told.append(phrase("inventory_tables.more_doubts", count=more))
    sized = {"width", "height"} <= reading.proposed.union(reading.places)
    proposal = reading.proposal(reading.unknown() if reading.proposed and not sized else ())
    raise InputError(
        "inventory_tables.unclear",
        "columns",
        doubts=("; ".join(en for en, _ in told), "；".join(ja for _, ja in told)),
        proposal=proposal,
        fill=phrase("inventory_tables.fill") if "?" in proposal else "",
    )
