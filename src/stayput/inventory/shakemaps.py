"""Reading shake maps: CSV, and the grids of USGS ShakeMap (XML)."""

from __future__ import annotations

import csv
import re
from contextlib import suppress
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, quoted, reason_of, warn, within
from stayput.inventory.columns import header_name
from stayput.inventory.map_fields import field_of, field_of_grid
from stayput.inventory.places import LIMITS, PLACE, ShakeMap, unwrapped
from stayput.inventory.shakemap_grid import check_file, is_xml, read_grid

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from stayput.inventory.map_fields import MapField
    from stayput.inventory.shakemap_grid import MapGrid

SIGMA = "sigma"
"""Column of the standard deviation: of an intensity itself, else of the natural logarithm."""

LARGEST_SIGMA = 3.0
"""Largest standard deviation."""

PREFERRED = ("pgv", "pga", "mmi")
"""Fields of a grid in the order in which one is taken: JMA's intensity follows the velocity most closely."""


def read_shakemap(path: Path, field: str | None = None, uncertainty: Path | None = None) -> ShakeMap:
    """Read a shake map: a grid of USGS ShakeMap, or CSV on a regular grid or at any places.

    A CSV has lat, lon, a column as `stayput.inventory.map_fields.field_of` reads it, and may have sigma.

    Parameters
    ----------
    path : Path
        The file.
    field : str, optional
        Which of its columns or fields counts, where there are several; of a grid by default PGV, else PGA,
        else MMI.
    uncertainty : Path, optional
        The grid's uncertainty (XML).

    Raises
    ------
    InputError
        A file that cannot be read, other columns, a value out of range, a place twice, or no place.
    """
    try:
        for file in filter(None, (path, uncertainty)):
            check_file(file)
        if is_xml(path):
            return _of_grid(path, field, uncertainty)
        if uncertainty is not None:
            raise InputError("inventory_tables.uncertainty_of_csv", "uncertainty")
        return _of_csv(path, field)
    except OSError as error:
        reason = reason_of(error)
        file = phrase("inventory.the_shake_map")
        shown = repr(str(error.filename or path))
        raise InputError("inventory.unreadable", file=file, path=shown, reason=reason) from None


def _of_grid(path: Path, wanted: str | None, uncertainty: Path | None) -> ShakeMap:
    grid = read_grid(path)
    fields = [field for name, unit in grid.units.items() if (field := field_of_grid(name, unit)) is not None]
    preferred = next((name for name in PREFERRED if name in _names(fields)), None)
    field = _chosen(fields, wanted or preferred, path)
    values = _in_range(grid.values[field.name], field)
    deviations = None
    if uncertainty is not None:
        other = read_grid(uncertainty)
        _check_event(grid, path, other, uncertainty)
        deviations = _deviations(other, grid, field, uncertainty)
    levels, scatters = field.levels(values), field.scatters(values, deviations)
    return ShakeMap(field.measure, grid.lats, grid.lons, levels, scatters)


def _names(fields: Sequence[MapField]) -> dict[str, MapField]:
    return {field.name.lower(): field for field in fields}


def _chosen(fields: Sequence[MapField], wanted: str | None, path: Path) -> MapField:
    known = _names(fields)
    if wanted is None or wanted.strip().lower() not in known:
        raise InputError(
            "inventory_tables.map_field",
            "field",
            path=repr(str(path)),
            known=", ".join(field.name for field in fields) or phrase("inventory.nothing"),
        )
    return known[wanted.strip().lower()]


def _in_range(values: np.ndarray[Any, Any], field: MapField) -> np.ndarray[Any, Any]:
    """Return values of a grid; one above what can be is refused, one below is taken for the lowest."""
    finite = values[~np.isnan(values)]
    if finite.size and not (finite.min() >= min(field.low, 0.0) and finite.max() <= field.high):
        wrong = float(finite.max() if finite.max() > field.high else finite.min())
        name = phrase("inventory_tables.in_the_map", name=field.name)
        within(name, wrong, min(field.low, 0.0), field.high, field.unit, "shakemap")
    return values


def _check_event(grid: MapGrid, path: Path, other: MapGrid, uncertainty: Path) -> None:
    """Refuse the uncertainty of another earthquake or version; warn where one of the two does not say it."""
    named: dict[str, Any] = {"path": repr(str(path)), "other": repr(str(uncertainty))}
    if not (grid.event and other.event):
        warn(InputWarning("inventory_tables.event_unstated", "uncertainty", **named))
    elif grid.event != other.event:
        events: dict[str, Any] = {"event": quoted(grid.event), "other_event": quoted(other.event)}
        raise InputError("inventory_tables.other_event", "uncertainty", **named, **events)


def _deviations(other: MapGrid, grid: MapGrid, field: MapField, path: Path) -> np.ndarray[Any, Any]:
    name = next((each for each in other.values if each.lower() == f"std{field.name}".lower()), None)
    if name is None:
        raise InputError(
            "inventory_tables.no_deviation", "uncertainty", path=repr(str(path)), name=f"STD{field.name}"
        )
    same = all(np.array_equal(a, b) for a, b in ((other.lats, grid.lats), (other.lons, grid.lons)))
    if not same:
        raise InputError("inventory_tables.other_grid", "uncertainty", path=repr(str(path)))
    if not _states_deviations(other.units[name], field):
        known = "intensity" if field.mercalli else f"ln({field.unit})"
        raise InputError(
            "inventory_tables.deviation_unit", "uncertainty", name=name, unit=other.units[name], known=known
        )
    values = other.values[name]
    finite = values[~np.isnan(values)]
    if not finite.size:
        raise InputError("inventory_tables.no_deviations", "uncertainty", path=repr(str(path)), name=name)
    if finite.size and not 0.0 <= finite.min() <= finite.max() <= LARGEST_SIGMA:
        wrong = float(finite.max() if finite.max() > LARGEST_SIGMA else finite.min())
        called = phrase("inventory_tables.in_the_map", name=name)
        within(called, wrong, 0.0, LARGEST_SIGMA, "", "uncertainty")
    return values


def _states_deviations(unit: str, field: MapField) -> bool:
    """Return whether a unit is that of deviations: of an intensity itself, else of the natural logarithm."""
    plain = unit.strip().lower()
    return (
        plain in ("intensity", "mmi", "")
        if field.mercalli
        else re.fullmatch(r"ln *\(.*\)|ln", plain) is not None
    )


def _of_csv(path: Path, wanted: str | None) -> ShakeMap:
    rows: dict[tuple[float, float], tuple[int, float, float]] = {}
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            reader: Any = csv.reader(file)
            nothing: list[str] = []
            first: list[str] = next(reader, nothing)
            header = [_column(name) for name in first]
            field, has_sigma = _field(header, wanted, path)
            names = (*PLACE, field.name, *([SIGMA] if has_sigma else []))
            columns = [header.index(name) for name in names]
            limits = (*LIMITS, (field.low, field.high, field.unit), (0.0, LARGEST_SIGMA, ""))
            for number, row in enumerate(reader, 2):
                if any(cell.strip() for cell in row):
                    if len(row) != len(header):
                        raise InputError(
                            "inventory.map_cells", row=number, cells=len(row), columns=len(header)
                        )
                    lat, lon, value, *sigma = (
                        _checked(number, name, row[n], limit)
                        for name, n, limit in zip(names, columns, limits, strict=False)
                    )
                    before = rows.setdefault((lat, lon), (number, value, sigma[0] if sigma else 0.0))[0]
                    if before != number:
                        raise InputError(
                            "inventory.map_place_twice", row=number, lat=lat, lon=lon, before=before
                        )
    except (UnicodeDecodeError, csv.Error):
        raise InputError("inventory.map_not_csv", "shakemap", path=repr(str(path))) from None
    if not rows:
        raise InputError("inventory.map_empty", "shakemap", path=repr(str(path)))
    _, values, sigmas = np.array(list(rows.values())).T
    levels, scatters = field.levels(values), field.scatters(values, sigmas if has_sigma else None)
    lat, lon = np.array(list(rows)).T
    lon = unwrapped(lon)
    lats, lons = np.unique(lat), np.unique(lon)
    if min(len(lats), len(lons)) < 2 or len(lats) * len(lons) != len(rows):
        return ShakeMap(field.measure, lat, lon, levels, scatters)

    def on_grid(values: np.ndarray[Any, Any] | None) -> np.ndarray[Any, Any] | None:
        if values is None:
            return None
        grid = np.empty((len(lats), len(lons)))
        grid[np.searchsorted(lats, lat), np.searchsorted(lons, lon)] = values
        return grid

    gridded = on_grid(levels)
    assert gridded is not None
    return ShakeMap(field.measure, lats, lons, gridded, on_grid(scatters))


def _column(name: str) -> str:
    """Return the name of a map's column: lat and lon by any of their names."""
    meant = header_name(name).column
    return meant if meant in PLACE else name.strip().lower()


def _field(header: list[str], wanted: str | None, path: Path) -> tuple[MapField, bool]:
    fields = [field for name in header if (field := field_of(name)) is not None]
    expected = sorted((*PLACE, *(field.name for field in fields)))
    given = sorted(name for name in header if name != SIGMA)
    if not fields or (wanted is None and len(fields) > 1) or given != expected or header.count(SIGMA) > 1:
        columns = ", ".join(header) or phrase("inventory.of_an_empty_file")
        raise InputError("inventory.map_columns", "shakemap", columns=columns)
    return (fields[0] if wanted is None else _chosen(fields, wanted, path)), SIGMA in header


def _checked(number: int, name: str, cell: str, limit: tuple[float, float, str]) -> float:
    """Return the number in a cell within its limits; a text that is none is refused by them too."""
    value: Any = cell
    with suppress(ValueError):
        value = cell if "_" in cell else float(cell)  # Python takes 5_0 for 50
    return within(phrase("inventory.in_row_of_the_map", name=name, row=number), value, *limit)
