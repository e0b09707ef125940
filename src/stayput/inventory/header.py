"""Reading the header of an inventory: which column is which, in which unit, or what is unclear about it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from difflib import get_close_matches
from functools import partial

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, unknown
from stayput.files import named_columns
from stayput.inventory import cells as reading
from stayput.inventory import columns as column
from stayput.vocabulary import WORDS, meant

LIKENESS = 0.8
"""From this likeness on a column counts as a misspelt one."""

UNKNOWN_SHOWN = 12
"""Most columns that a proposal has with a "?" for what they are."""

SHOWN = 3
"""Most doubts or headings that a sentence tells."""

ROWS_OF_A_TITLE = 20
"""Most rows above the headings that are taken for a title."""


class Header:
    """The first row of a table: which column is which, and in which unit.

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

    Attributes
    ----------
    places : dict of str to int
        Place of each known column.
    unused : list of str
        Columns that are not known; they are reported and not used.
    called : dict of str to str
        What the table calls the columns that it calls otherwise.
    renamed : list of str
        What was taken for what, as "width = 奥行 [mm]".

    Raises
    ------
    InputError
        Two columns of one name, no name of a piece and no size, one that is unclear or misspelt.
    """

    def __init__(
        self,
        cells: Sequence[reading.Cell],
        sample: Sequence[Sequence[reading.Cell]] = (),
        mapping: column.ColumnMapping | None = None,
        decimal_comma: bool = False,
    ) -> None:
        self.names = names = [cell.strip() if isinstance(cell, str) else "" for cell in cells]
        self.sample, self.decimal_comma = sample, decimal_comma
        self.mapping = mapping or column.ColumnMapping()
        _refuse_headings_elsewhere(names, sample)
        _refuse_buildings(names)
        self.parts = [column.header_name(name) for name in names]
        mapped, self.ignored = self.mapping.places(names)
        self.places = {name: place for name, (place, _) in mapped.items()}
        self.units: dict[str, column.NumberUnit | None] = {name: unit for name, (_, unit) in mapped.items()}
        self.mapped = frozenset(self.places.values())
        self.in_own_units: set[str] = set()
        self.without_unit: set[str] = set()
        self.doubts: list[tuple[Phrase, str]] = []  # each with the part of --columns that would settle it
        self.unused: list[str] = [names[place][:200] for place in sorted(self.ignored)]
        taken = {*self.mapped, *self.ignored}
        self.free = [place for place, name in enumerate(names) if name and place not in taken]
        for name, times in Counter(map(column.plain_name, names)).items():
            if name and times > 1:
                raise InputError("common.twice", name, name=reading.shown(name))
        self._take_known()
        self._take_rest()
        self._ask_for_units()
        self._take_length()
        self._refuse_what_is_unclear()
        self.places = {name: self.places[name] for name in column.COLUMNS if name in self.places}
        self.called = {n: names[place] for n, place in self.places.items() if names[place].lower() != n}
        self.readers = {name: self._readers(name) for name in self.places}
        self.renamed: list[str] = []
        for name, place in self.places.items():
            unit, written = self.units[name], self.parts[place].unit
            if name in self.called or unit is not None:
                stated = "" if unit is None or written else f" [{unit.name}]"
                self.renamed.append(f"{name} = {names[place][:60]}{stated}")

    def cells(self, row: Sequence[reading.Cell]) -> dict[str, reading.Cell]:
        """Return the known cells of a row by their columns.

        Raises
        ------
        InputError
            More or fewer cells than columns, one below no name, or one that cannot be read in its unit.
        """
        if len(row) != len(self.names):
            raise InputError("inventory.row_length", cells=len(row), columns=len(self.names))
        for place, (name, cell) in enumerate(zip(self.names, row, strict=True), 1):
            if not name and not reading.is_empty(cell):
                raise InputError("inventory.cell_without_name", cell=place, value=reading.shown(cell))
        cells = {name: row[place] for name, place in self.places.items()}
        for name, readers in self.readers.items():
            for read in readers:
                cells[name] = read(cells[name])
        if "name" in cells and reading.is_empty(cells.get("preset")):
            cells["preset"] = reading.preset_called(cells["name"])
        return cells

    def _doubt(self, key: str, place: int, settled: str | None = None, **values: object) -> None:
        """Note what is unclear about a column, and what settles it: by default that it is ignored."""
        about = phrase(f"inventory_tables.doubt_{key}", header=reading.shown(self.names[place]), **values)
        self.doubts.append((about, settled or f"{column.IGNORE}={self.names[place]}"))

    def _column(self, place: int) -> list[reading.Cell]:
        """Return the cells of a column in the sample."""
        return [row[place] for row in self.sample if place < len(row)]

    def _take_known(self) -> None:
        """Take columns by stayput's names, then by usual ones."""
        for place in list(self.free):
            name = self.names[place].lower()
            if name in column.COLUMNS and name not in self.places:
                self.places[name], self.units[name] = place, None
                self.free.remove(place)
        for name, place in list(self.places.items()):
            kind = column.COLUMNS[name].unit
            if self.units[name] is None and kind in ("m", "kg") and self.names[place].lower() != name:
                self._ask_for_unit(name, place)
        for place in sorted(self.free, key=lambda place: self.parts[place].base not in column.TOTAL_MASSES):
            part, name = self.parts[place], self.parts[place].column
            if part.base in column.ALONG_THE_WALL or name is None:
                continue
            self.free.remove(place)
            if name in self.places:
                self._second(name, place)
            elif part.note:
                self._doubt("note", place, self._proposed(name, place), note=part.note)
            else:
                self._take(name, place)

    def _second(self, name: str, place: int) -> None:
        """Take in another column of a name that is taken: a total beside a price is left out."""
        first = self.places[name]
        total, first_total = (self.parts[each].base in column.TOTALS for each in (place, first))
        if name == "width" and self.names[first].lower() == name and self.units[name] is None:
            settled = f"{self._proposed('width', place)},{self._proposed('length', first)}"
            self._doubt("width", place, settled, width=reading.shown(self.names[first]))
            if not _is_own(column.UNITS["m"].get(self.parts[place].unit)):
                self.without_unit.add(name)
        elif self.parts[first].base in column.TOTAL_MASSES:
            self._doubt("masses", place, first=reading.shown(self.names[first]))
        elif name == "value" and first_total:
            self.unused.append(self.names[first][:200])
            self._take(name, place)
        elif name in ("name", "id") or (name == "value" and total):
            self.unused.append(self.names[place][:200])
        else:
            self._doubt("twice", place, first=reading.shown(self.names[first]), name=name)

    def _take(self, name: str, place: int) -> None:
        kind, written = column.COLUMNS[name].unit, self.parts[place].unit
        self.places[name], self.units[name] = place, column.UNITS.get(kind, {}).get(written)
        if self.units[name] is None and (written or kind in ("m", "kg")):
            self._ask_for_unit(name, place)

    def _ask_for_unit(self, name: str, place: int) -> None:
        """Doubt a column without a known unit, unless its cells have units of their own."""
        cells, kind = self._column(place), column.COLUMNS[name].unit
        bare = not self.parts[place].unit and all(reading.number_or_none(cell) is None for cell in cells)
        if bare and any(reading.in_own_unit(cell, kind) for cell in cells):
            self.in_own_units.add(name)
        else:
            self.without_unit.add(name)
            self._doubt("unit", place, f"{name}={self.names[place]}[?]")

    def _ask_for_units(self) -> None:
        """Doubt stayput's own columns without a unit where others of their kind have or lack another one.

        In a table in cm a bare height is hardly one in m.
        """
        along = [
            column.UNITS["m"].get(part.unit) for part in self.parts if part.base in column.ALONG_THE_WALL
        ]
        asked = self.in_own_units | self.without_unit
        for kind in ("m", "kg", "currency"):
            names = [name for name in self.places if column.COLUMNS[name].unit == kind]
            stated = [self.units[name] for name in names] + (along if kind == "m" else [])
            currencies = {unit.currency for unit in stated if unit is not None}
            if len(currencies) > 1:
                raise InputError(
                    "inventory_tables.currencies", "value", currencies=", ".join(sorted(currencies))
                )
            if asked.intersection(names) or not all(unit is None or _is_own(unit) for unit in stated):
                for name in names:
                    if self.units[name] is None and name not in asked:
                        self._ask_for_unit(name, self.places[name])

    def _take_rest(self) -> None:
        """Look at what is left: doubtful where it would change a result, else not used."""
        sized = {"width", "height"} <= self.places.keys()
        for place in self.free:
            base, unit, header = self.parts[place].base, self.parts[place].unit, self.names[place]
            across = base in column.ALONG_THE_WALL
            if base in column.RACK_UNITS and "height" not in self.places:
                self._doubt("rack_units", place, f"height={header}[U]")
            elif across and "width" not in self.places:
                self._doubt("no_depth", place, f"width=?,{column.IGNORE}={header}")
            elif not across and column.LOOKS_LIKE_COUNT.fullmatch(base) and "count" not in self.places:
                self._doubt("count", place, f"count={header}")
            elif not (across or sized) and (
                column.LOOKS_LIKE_SIZE.fullmatch(base) or unit in column.UNITS["m"]
            ):
                self._doubt("size", place, f"?={header}")
            elif not across and get_close_matches(base.replace(" ", "_"), column.COLUMNS, 1, LIKENESS):
                raise unknown("inventory_tables.column_name", header, column.COLUMNS, header)
            elif not across:
                self.unused.append(header[:200])

    def _take_length(self) -> None:
        """Take the first size along the wall, where no column is called so by stayput's name or the mapping.

        One without a unit has the depth's.
        """
        along = [place for place in self.free if self.parts[place].base in column.ALONG_THE_WALL]
        known = "length" in self.places or "width" not in self.places
        self.along = [] if known else along[:1]
        for place in self.along:
            unit = column.UNITS["m"].get(self.parts[place].unit)
            self.places["length"], self.units["length"] = place, unit or self.units["width"]
        self.unused += [self.names[place][:200] for place in along if place not in self.along]

    def _look_at_cells(self) -> None:
        """Doubt what the cells speak against: storeys for a surface, totals for the value of one piece."""
        floor, value = self.places.get("floor"), self.places.get("value")
        if floor is not None and "storey" not in self.places:
            cells = [str(cell) for cell in self._column(floor) if cell]
            if cells and all(reading.storey_called(cell) is not None for cell in cells):
                self._doubt("floor", floor, f"storey={self.names[floor]}")
        if value is None or value in self.mapped or "count" not in self.places:
            return
        if self.parts[value].base in column.TOTALS:
            self._doubt("total", value)

    def _proposal(self, others: Sequence[str] = ()) -> str:
        """Return the mapping to give: what is given already, but for what is doubted, and what settles it.

        Each name stands once, and each column; of several columns for one name all but the first get a "?".
        """
        doubted = ",".join((*(part for _, part in self.doubts), *others))
        settled = dict[str, tuple[str, str]]()
        for name, header in named_columns(doubted, "inventory_tables.mapping"):
            bare = header if header in self.names else header.removesuffix("[?]").removesuffix("[U]")
            again = name in {other for other, _ in settled.values()} - {column.IGNORE, "?"}
            if name == column.IGNORE or not (bare in settled or (again and bare == "?")):
                settled[bare] = ("?", bare) if again else (name, header)
        kept = [pair for pair in self.mapping.pairs if pair[0] not in dict(settled.values())]
        kept += [(column.IGNORE, header) for header in self.mapping.ignored]
        return ",".join(f"{name}={header}" for name, header in (*kept, *settled.values()))

    def _refuse_what_is_unclear(self) -> None:
        """Refuse a header of which something is doubted, or nothing says what the pieces are."""
        sized = {"width", "height"} <= self.places.keys()
        if not {"name", "preset"} & self.places.keys() and not sized:
            if not any(self.names):
                raise InputError("inventory.first_row", "inventory", reason=phrase("inventory.is_empty"))
            if not_known := self.unused[len(self.ignored) :][:UNKNOWN_SHOWN]:
                proposal = self._proposal([f"?={name}" for name in not_known])
                columns = ", ".join(column.COLUMNS)
                raise InputError(
                    "inventory_tables.no_known_column", "columns", proposal=proposal, columns=columns
                )
        self._look_at_cells()
        if not self.doubts:
            return
        doubts = [about for about, _ in self.doubts[:SHOWN]]
        if more := len(self.doubts) - len(doubts):
            doubts.append(phrase("inventory_tables.more_doubts", count=more))
        proposal = self._proposal()
        raise InputError(
            "inventory_tables.unclear",
            "columns",
            doubts=("; ".join(en for en, _ in doubts), "；".join(ja for _, ja in doubts)),
            proposal=proposal,
            fill=phrase("inventory_tables.fill") if "?" in proposal else "",
        )

    def _readers(self, name: str) -> list[reading.CellReader]:
        """Return what makes the column's own text or number of its cells, one after another."""
        if reader := {"storey": reading.storey_meant, "fixed": reading.fixing_known}.get(name):
            return [reader]
        kind, unit = column.COLUMNS[name].unit, self.units[name]
        if name == "length" and self.places[name] in self.along:
            return [partial(reading.length_or_none, stated=unit, decimal_comma=self.decimal_comma)]
        readers: list[reading.CellReader] = []
        if name in self.in_own_units:
            readers.append(partial(reading.refuse_without_unit, name))
        if name in WORDS:
            readers.append(partial(meant, name))
        numeric = bool(kind) or name in (*column.LISTS, "count")
        if unit is not None or kind == "currency" or (self.decimal_comma and numeric):
            about = {"unit": kind, "stated": unit, "decimal_comma": self.decimal_comma}
            readers.append(
                partial(reading.numbers_read if name in column.LISTS else reading.number_of, name, **about)
            )
        return readers

    def _proposed(self, name: str, place: int) -> str:
        """Return the part of a mapping that is likely meant, with "?" for a unit that is not written."""
        kind = column.COLUMNS[name].unit
        known = kind not in ("m", "kg") or self.parts[place].unit in column.UNITS[kind]
        return f"{name}={self.names[place]}" if known else f"{name}={self.names[place]}[?]"


def _headings_in(row: Sequence[reading.Cell]) -> list[str]:
    """Return the headings in a row, of which there are two at least, and half of what it holds; else none."""
    filled = [cell for cell in row if not reading.is_empty(cell)]
    headings = [cell for cell in filled if isinstance(cell, str) and column.is_heading(cell)]
    return headings if len(headings) > 1 and 2 * len(headings) >= len(filled) else []


def _is_own(unit: column.NumberUnit | None) -> bool:
    """Return whether a unit is known, and as large as stayput's own."""
    return unit is not None and unit.times == unit.over


def _refuse_buildings(names: Sequence[str]) -> None:
    """Refuse a table of buildings in Open Exposure Data."""
    known = [name for name in names if name.lower() in column.OPEN_EXPOSURE_DATA]
    if len(known) > 2:
        raise InputError("inventory_tables.buildings", "inventory", columns=", ".join(known[:SHOWN]))


def _refuse_headings_elsewhere(names: Sequence[str], sample: Sequence[Sequence[reading.Cell]]) -> None:
    """Refuse headings that stand below a title, or go over two rows."""
    known, below_a_title = sum(map(column.is_heading, names)), not _headings_in(names)
    for row, cells in enumerate(sample[: ROWS_OF_A_TITLE if below_a_title else 1], 2):
        headings = _headings_in(cells)
        if len(headings) > (known if below_a_title else 0):
            names_found = ", ".join(map(reading.shown, headings[:SHOWN]))
            raise InputError("inventory_tables.headings_below", "inventory", row=row, found=names_found)
