"""The columns of an inventory, and reading its header."""

from __future__ import annotations

import re
from dataclasses import dataclass
from difflib import get_close_matches
from typing import TYPE_CHECKING

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.inventory.cells import shown

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from stayput.inventory.cells import Cell

COLUMNS = (
    "id",
    "preset",
    "width",
    "height",
    "mass",
    "cg_offset",
    "load",
    "contents",
    "doors",
    "drawers",
    "lip",
    "floor",
    "gap",
    "wall",
    "building",
    "storey",
    "measures",
    "costs",
    "count",
    "value",
    "lat",
    "lon",
)
"""Columns of an inventory; what each holds stands in the catalogue under ``inventory.column_<name>``."""

MOST = 200
"""Most columns of a table."""

LIKENESS = 0.8
"""From this likeness on a column counts as a misspelt one."""

_UNIT = re.compile(r"_(?:in_)?(?:mm|cm|m|inch|inches|in|ft|g|kg|t|lb|lbs|deg|yen|usd|eur)$")


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
    """

    places: Mapping[str, int]
    width: int
    unnamed: tuple[int, ...] = ()
    unused: tuple[str, ...] = ()

    def cells(self, row: Sequence[Cell]) -> dict[str, Cell]:
        """Return the known cells of a row by their columns.

        Raises
        ------
        InputError
            More or fewer cells than columns, or one below no name.
        """
        if len(row) != self.width:
            raise InputError("inventory.row_length", cells=len(row), columns=self.width)
        for place in self.unnamed:
            if row[place] not in (None, ""):
                raise InputError("inventory.cell_without_name", cell=place + 1, value=shown(row[place]))
        return {name: row[place] for name, place in self.places.items()}


def header_of(cells: Sequence[Cell]) -> Header:
    """Read the first row of a table.

    An unknown column that looks like a known one is refused; any other is left out and named in
    ``unused``.

    Raises
    ------
    InputError
        Too many columns, two of one name, no ``id``, a unit in a name, or a name that looks misspelt.
    """
    if len(cells) > MOST:
        raise InputError("inventory.too_many_columns", columns=len(cells), most=MOST)
    names = [str(cell).strip().lower() if isinstance(cell, str) else "" for cell in cells]
    if "id" not in names:
        listed = ", ".join(shown(name) for name in names if name)[:200] or phrase("inventory.nothing")
        if len(names) == 1 and any(mark in names[0] for mark in ";\t|"):
            raise InputError("inventory.commas", row=shown(names[0]))
        raise InputError("inventory.no_id", "id", names=listed)
    unused: list[str] = []
    for name in names:
        if name and names.count(name) > 1:
            raise InputError("inventory.column_twice", name, name=shown(name))
        if name in COLUMNS or not name:
            continue
        base = _UNIT.split(re.split(r"\s*[\[(（]", name)[0].strip().replace(" ", "_").replace("-", "_"))[0]
        near = [base] if base in COLUMNS else get_close_matches(base, COLUMNS, 1, LIKENESS)
        if near:
            raise InputError(
                "inventory.unknown_column",
                name,
                name=shown(name),
                near=repr(near[0]),
                holds=phrase(f"inventory.column_{near[0]}"),
                columns=", ".join(COLUMNS),
            )
        unused.append(name[:200])
    return Header(
        {name: place for place, name in enumerate(names) if name in COLUMNS},
        len(names),
        tuple(place for place, name in enumerate(names) if not name),
        tuple(unused),
    )
