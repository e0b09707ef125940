"""The columns of an inventory, and what a header may say."""

from __future__ import annotations

import re
from dataclasses import dataclass
from difflib import get_close_matches
from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.inventory.cells import shown

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from stayput.inventory.cells import Cell

COLUMNS: dict[str, str] = {
    "id": "what the piece is called; every row its own",
    "preset": "a common piece of furniture",
    "width": "size along the shaking [m]",
    "height": "height [m]",
    "mass": "mass; with a load, that of the empty piece [kg]",
    "cg_offset": "centre of gravity right of and above the centroid, as right;up [m]",
    "load": "load, spread evenly, or of each shelf from the lowest up, as 10;10;5 [kg]",
    "floor": "a surface, or static;kinetic friction",
    "gap": "distance to the wall behind [m]",
    "building": "a building of the scenario, or storeys and structure such as 10 RC",
    "storey": "storey, 1 on the ground",
    "measures": "what to compare, as gel_mats;tension_pole+wedge_stopper",
    "costs": "cost of each of these measures for one piece, in the currency of value",
    "count": "how many such pieces stand there",
    "value": "loss if one such piece overturns",
    "lat": "latitude [°]",
    "lon": "longitude [°]",
}
"""Columns of an inventory, and what each holds."""

MOST = 200
"""Most columns of a table."""

LIKENESS = 0.8
"""From this likeness on a column counts as a misspelt one."""

_UNIT = re.compile(r"_(?:in_)?(?:mm|cm|m|inch|inches|in|ft|g|kg|t|lb|lbs|deg|yen|usd|eur)$")


@dataclass(frozen=True, slots=True)
class Header:
    """Where each column is.

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
            told = f"it must have one for each of {self.width} columns"
            raise InputError(f"The row has {len(row)} cells; {told}.")
        for place in self.unnamed:
            if row[place] not in (None, ""):
                raise InputError(f"Cell {place + 1} is {shown(row[place])}, in a column without a name.")
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
        raise InputError(f"The table has {len(cells)} columns; it must have at most {MOST}.")
    names = [str(cell).strip().lower() if isinstance(cell, str) else "" for cell in cells]
    if "id" not in names:
        told = ", ".join(shown(name) for name in names if name)[:200] or "nothing"
        if len(names) == 1 and any(mark in names[0] for mark in ";\t|"):
            raise InputError(f"The first row is {shown(names[0])}; commas must be between the columns.")
        raise InputError(
            f"The first row names {told}; it must name every column, id among them "
            "(is the header merged, or of two rows?)."
        )
    unused: list[str] = []
    for name in names:
        if name and names.count(name) > 1:
            raise InputError(f"The column {shown(name)} is there twice; each must be there once.")
        if name in COLUMNS or not name:
            continue
        base = _UNIT.split(re.split(r"\s*[\[(（]", name)[0].strip().replace(" ", "_").replace("-", "_"))[0]
        near = [base] if base in COLUMNS else get_close_matches(base, COLUMNS, 1, LIKENESS)
        if near:
            raise InputError(
                f"The column {shown(name)} is unknown (did you mean {near[0]!r}? It holds: "
                f"{COLUMNS[near[0]]}); the columns are {', '.join(COLUMNS)}."
            )
        unused.append(name[:200])
    return Header(
        {name: place for place, name in enumerate(names) if name in COLUMNS},
        len(names),
        tuple(place for place, name in enumerate(names) if not name),
        tuple(unused),
    )
