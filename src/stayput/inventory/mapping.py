"""The mapping of ``--columns``: which of a table's columns are which, where its names do not say it."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from stayput.catalogue import phrase
from stayput.errors import InputError, reason_of, unknown
from stayput.inventory.cells import shown
from stayput.inventory.columns import COLUMNS, UNITS, NumberUnit, header_name, plain_name
from stayput.scenario.toml import read_toml
from stayput.spreadsheets import named_columns

if TYPE_CHECKING:
    from collections.abc import Sequence

IGNORE = "ignore"
"""Name under which columns are listed that are not to be used."""

FILES = (".toml", ".json")

LARGEST_FILE = 2**20
"""Most bytes of a file with a mapping."""

_UNIT = re.compile(r"(.+?)\s*\[([^\[\]]*)\]", re.DOTALL)


@dataclass(frozen=True, slots=True)
class ColumnMapping:
    """Which columns of a table hold what.

    Parameters
    ----------
    pairs : tuple of (str, str)
        Names of `COLUMNS`, each with the table's name of it, which may have a unit behind it in brackets.
    ignored : tuple of str
        The table's names of columns that are not to be used.
    """

    pairs: tuple[tuple[str, str], ...] = ()
    ignored: tuple[str, ...] = ()

    @property
    def key(self) -> list[Any]:
        """The mapping in a form that can be written as JSON."""
        return [list(map(list, self.pairs)), list(self.ignored)]

    def places(self, names: Sequence[str]) -> tuple[dict[str, tuple[int, NumberUnit | None]], set[int]]:
        """Return the place of each mapped column with the unit that is stated, and the places not to use.

        Raises
        ------
        InputError
            A name that the table does not have, or a unit that is none.
        """
        found: dict[str, tuple[int, NumberUnit | None]] = {}
        for name, header in self.pairs:
            place, unit = _find(name, header, names)
            if place in {other for other, _ in found.values()}:
                raise InputError("inventory.column_twice", "columns", name=shown(header))
            found[name] = place, unit
        return found, {_find(IGNORE, header, names)[0] for header in self.ignored}


def _find(name: str, header: str, names: Sequence[str]) -> tuple[int, NumberUnit | None]:
    """Return the place of the column of a header, which may have its unit behind it in brackets."""
    units = UNITS.get(COLUMNS[name].unit, {}) if name in COLUMNS else {}
    place = _place(header, names)
    if place is not None:
        return place, units.get(header_name(header).unit)
    matched = _UNIT.fullmatch(header.strip())
    place = None if matched is None else _place(matched[1], names)
    said: dict[str, Any] = {"name": name, "header": shown(header)}
    if matched is None or place is None:
        listed = ", ".join(shown(each) for each in names if each)[:300] or phrase("inventory.nothing")
        raise InputError("inventory_tables.mapped_missing", "columns", **said, names=listed)
    stated, written = units.get(plain_name(matched[2])), units.get(header_name(names[place]).unit)
    if stated is None or written not in (None, stated):
        known = dict.fromkeys(unit.name for unit in ([written] if written else units.values()))
        raise InputError("inventory_tables.mapped_unit", "columns", **said, known=", ".join(known) or "-")
    return place, stated


def _place(header: str, names: Sequence[str]) -> int | None:
    """Return the place of the column of a name: as it is written, else the only one but for a unit."""
    wanted = plain_name(header)
    if not wanted:
        return None
    same = [place for place, name in enumerate(names) if plain_name(name) == wanted]
    same = same or [place for place, name in enumerate(names) if name and header_name(name).base == wanted]
    if len(same) > 1:
        raise InputError("inventory_tables.mapped_unclear", "columns", header=shown(header))
    return same[0] if same else None


def read_columns(columns: str | Path | Mapping[str, Any] | None) -> ColumnMapping:
    """Return the mapping of a text such as "width=奥行,height=高さ[cm]", a TOML or JSON file, or a mapping.

    Raises
    ------
    InputError
        A file that cannot be read, a column that is none, or something else than names.
    """
    if columns is None:
        return ColumnMapping()
    if isinstance(columns, Mapping):
        return _mapping(list(columns.items()))
    if str(columns).lower().endswith(FILES):
        return _mapping(list(_file(Path(columns)).items()))
    return _mapping(named_columns(str(columns), "inventory_tables.mapping"))


def _file(path: Path) -> dict[str, Any]:
    if path.suffix.lower() == ".toml":
        return dict(read_toml(path))
    try:
        with path.open("rb") as file:
            content: Any = json.loads(file.read(LARGEST_FILE).decode("utf-8-sig"))
    except OSError as error:
        reason, called = reason_of(error), phrase("inventory.input_columns")
        raise InputError("inventory.unreadable", file=called, path=repr(str(path)), reason=reason) from None
    except (ValueError, RecursionError):
        content = None
    if not isinstance(content, dict):
        raise InputError("inventory_tables.mapping_file", "columns", path=repr(str(path)))
    return cast("dict[str, Any]", content)


def _mapping(items: Sequence[tuple[str, object]]) -> ColumnMapping:
    pairs: dict[str, str] = {}
    ignored: list[str] = []
    for name, header in items:
        headers = cast("list[object]", header) if isinstance(header, list | tuple) else [header]
        for each in headers:
            if not isinstance(each, str) or not each.strip() or (name != IGNORE and len(headers) > 1):
                raise InputError("inventory_tables.mapping", "columns", value=shown(each))
            if name == IGNORE:
                ignored.append(each)
            elif name not in COLUMNS:
                known = (*COLUMNS, IGNORE)
                raise unknown("inventory_tables.column_name", name, known, field="columns")
            elif name in pairs:
                raise InputError("inventory.column_twice", "columns", name=shown(name))
            else:
                pairs[name] = each
    return ColumnMapping(tuple(pairs.items()), tuple(ignored))
