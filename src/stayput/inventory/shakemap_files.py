"""Reading shake maps: CSV, and the grids of USGS ShakeMap (grid.xml and uncertainty.xml)."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, not_allowed, quoted, unknown, warn, within
from stayput.files import table_lines
from stayput.inventory.columns import header_name
from stayput.inventory.folder import unreadable
from stayput.inventory.shakemap import MapField, ShakeMap, field_of, field_of_grid, unwrapped

PLACE = ("lat", "lon")
LIMITS = ((-90.0, 90.0, "°"), (-180.0, 360.0, "°"))

SIGMA = "sigma"
"""Column of the standard deviation: of an intensity itself, else of the natural logarithm."""

LARGEST_SIGMA = 3.0
"""Largest standard deviation."""

PREFERRED = ("pgv", "pga", "mmi")
"""Fields of a grid in the order in which one is taken: JMA's intensity follows the velocity most closely."""


class MapGrid(NamedTuple):
    """A grid of places.

    Parameters
    ----------
    lats, lons : ndarray
        Its latitudes and longitudes, both increasing [°].
    values : dict
        Each field, shape (lats, lons).
    units : dict
        The unit of each field, as it is stated.
    event : str
        The earthquake and the version of its map, as they are stated; "" where they are not.
    """

    lats: NDArray[np.float64]
    lons: NDArray[np.float64]
    values: dict[str, NDArray[np.float64]]
    units: dict[str, str]
    event: str = ""


def read_shakemap(path: Path, field: str | None = None, uncertainty: Path | None = None) -> ShakeMap:
    """Read a shake map: a grid of USGS ShakeMap, or CSV on a regular grid or at any places.

    A CSV has lat, lon, a column as `stayput.inventory.shakemap.field_of` reads it, and may have sigma.

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
        if is_xml(path):
            return _of_grid(path, field, uncertainty)
        if uncertainty is not None:
            where = phrase("inventory_tables.of_csv")
            raise InputError("common.left_out", "uncertainty", where=where)
        return _of_csv(path, field)
    except OSError as error:
        raise unreadable(error.filename or path, error) from None


def _of_grid(path: Path, wanted: str | None, uncertainty: Path | None) -> ShakeMap:
    grid = read_grid(path)
    fields = [field for name, unit in grid.units.items() if (field := field_of_grid(name, unit)) is not None]
    preferred = next((name for name in PREFERRED if name in _names(fields)), None)
    field = _chosen(fields, wanted or preferred)
    # a value below what can be is taken for the lowest
    least = min(field.low, 0.0)
    values = _in_range(grid.values[field.name], field.name, least, field.high, field.unit, "shakemap")
    deviations = None
    if uncertainty is not None:
        other = read_grid(uncertainty)
        _check_event(grid, path, other, uncertainty)
        deviations = _deviations(other, grid, field, uncertainty)
    levels, scatters = field.levels(values), field.scatters(values, deviations)
    return ShakeMap(field.measure, grid.lats, grid.lons, levels, scatters)


def _names(fields: Sequence[MapField]) -> dict[str, MapField]:
    return {field.name.lower(): field for field in fields}


def _chosen(fields: Sequence[MapField], wanted: str | None) -> MapField:
    known = _names(fields)
    if wanted is None or wanted.strip().lower() not in known:
        raise unknown("field", wanted, [field.name for field in fields] or PREFERRED, "field")
    return known[wanted.strip().lower()]


def _in_range(
    values: NDArray[np.float64], name: str, low: float, high: float, unit: str, field: str
) -> NDArray[np.float64]:
    """Return values of a grid, of which none that is known is out of a range."""
    finite = values[~np.isnan(values)]
    if finite.size and not (finite.min() >= low and finite.max() <= high):
        wrong = float(finite.max() if finite.max() > high else finite.min())
        within(phrase("inventory.on_the_map", name=name), wrong, low, high, unit, field)
    return values


def _check_event(grid: MapGrid, path: Path, other: MapGrid, uncertainty: Path) -> None:
    """Refuse the uncertainty of another earthquake or version; warn where one of the two does not say it."""
    named: dict[str, Any] = {"path": path, "other": uncertainty}
    if not (grid.event and other.event):
        warn(InputWarning("inventory_tables.event_unstated", "uncertainty", **named))
    elif grid.event != other.event:
        events: dict[str, Any] = {"event": quoted(grid.event), "other_event": quoted(other.event)}
        raise InputError("inventory_tables.other_event", "uncertainty", **named, **events)


def _deviations(other: MapGrid, grid: MapGrid, field: MapField, path: Path) -> NDArray[np.float64]:
    name = next((each for each in other.values if each.lower() == f"std{field.name}".lower()), None)
    if name is None or np.isnan(other.values[name]).all():
        allowed = phrase("inventory_tables.no_deviations", name=f"STD{field.name}")
        raise not_allowed("inventory.the_uncertainty", path, allowed, "uncertainty")
    if not (np.array_equal(other.lats, grid.lats) and np.array_equal(other.lons, grid.lons)):
        raise not_allowed("inventory.the_uncertainty", path, "inventory_tables.other_grid", "uncertainty")
    unit = other.units[name]
    if re.fullmatch(r"intensity|mmi|" if field.mercalli else r"ln( *\(.*\))?", unit.strip().lower()) is None:
        known = "intensity" if field.mercalli else f"ln({field.unit})"
        raise not_allowed(phrase("inventory_tables.unit_of", name=name), repr(unit), known, "uncertainty")
    return _in_range(other.values[name], name, 0.0, LARGEST_SIGMA, "", "uncertainty")


def _of_csv(path: Path, wanted: str | None) -> ShakeMap:
    rows: dict[tuple[float, float], tuple[int, float, float]] = {}
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            reader: Any = csv.reader(table_lines(file, path))
            nothing: list[str] = []
            first: list[str] = next(reader, nothing)
            header = [_column(name) for name in first]
            field, has_sigma = _field(header, wanted)
            names = (*PLACE, field.name, *([SIGMA] if has_sigma else []))
            columns = [header.index(name) for name in names]
            limits = (*LIMITS, (field.low, field.high, field.unit), (0.0, LARGEST_SIGMA, ""))
            for number, row in enumerate(reader, 2):
                if any(cell.strip() for cell in row):
                    if len(row) != len(header):
                        other_length = InputError("inventory.row_length", cells=len(row), columns=len(header))
                        raise other_length.at(phrase("inventory.row", row=number))
                    lat, lon, value, *sigma = (
                        _checked(number, name, row[n], limit)
                        for name, n, limit in zip(names, columns, limits, strict=False)
                    )
                    before = rows.setdefault((lat, lon), (number, value, sigma[0] if sigma else 0.0))[0]
                    if before != number:
                        name = phrase("inventory.in_row_of_the_map", name="lat, lon", row=number)
                        value, other = f"{lat:g}, {lon:g}", phrase("inventory.row", row=before)
                        raise InputError("scenario.same_name", name=name, value=value, other=other)
    except (UnicodeDecodeError, csv.Error):
        raise not_allowed("inventory.the_map", path, "inventory.map_not_csv", "shakemap") from None
    if not rows:
        raise not_allowed("inventory.the_map", path, "inventory.map_empty", "shakemap")
    _, values, sigmas = np.array(list(rows.values())).T
    levels, scatters = field.levels(values), field.scatters(values, sigmas if has_sigma else None)
    lat, lon = np.array(list(rows)).T
    lon = unwrapped(lon)
    lats, lons = np.unique(lat), np.unique(lon)
    if min(len(lats), len(lons)) < 2 or len(lats) * len(lons) != len(rows):
        return ShakeMap(field.measure, lat, lon, levels, scatters)
    shape, order = (len(lats), len(lons)), np.lexsort((lon, lat))
    on_grid = None if scatters is None else scatters[order].reshape(shape)
    return ShakeMap(field.measure, lats, lons, levels[order].reshape(shape), on_grid)


def _column(name: str) -> str:
    """Return the name of a map's column: lat and lon by any of their names."""
    meant = header_name(name).column
    return meant if meant in PLACE else name.strip().lower()


def _field(header: list[str], wanted: str | None) -> tuple[MapField, bool]:
    fields = [field for name in header if (field := field_of(name)) is not None]
    expected = sorted((*PLACE, *(field.name for field in fields)))
    names = sorted(name for name in header if name != SIGMA)
    if not fields or (wanted is None and len(fields) > 1) or names != expected or header.count(SIGMA) > 1:
        columns = ", ".join(header) or phrase("inventory.nothing")
        raise InputError("inventory.map_columns", "shakemap", columns=columns)
    return (fields[0] if wanted is None else _chosen(fields, wanted)), SIGMA in header


def _checked(number: int, name: str, cell: str, limit: tuple[float, float, str]) -> float:
    """Return the number in a cell within its limits; a text that is none is refused by them too."""
    value: Any = cell
    with suppress(ValueError):
        value = cell if "_" in cell else float(cell)  # Python takes 5_0 for 50
    return within(phrase("inventory.in_row_of_the_map", name=name, row=number), value, *limit)


def is_xml(path: Path) -> bool:
    """Return whether a file begins as XML does, in UTF-8 or UTF-16."""
    with path.open("rb") as file:
        start = file.read(64).replace(b"\0", b"")
    return start.lstrip(b"\xef\xbb\xbf\xfe\xff \r\n\t").startswith(b"<")


def read_grid(path: Path) -> MapGrid:
    """Read a grid of ShakeMap.

    Raises
    ------
    InputError
        No such grid, or a broken one.
    """
    try:
        root = ElementTree.parse(path).getroot()
    except (ElementTree.ParseError, ValueError, LookupError) as error:
        raise _refused(path, "broken", said=str(error)[:200]) from None
    size = next(root.iterfind("{*}grid_specification"), root)
    try:
        shape = int(size.get("nlat", "")), int(size.get("nlon", ""))
        fields = {int(field.get("index", "")): field for field in root.iterfind("{*}grid_field")}
    except ValueError:
        raise _refused(path, "kind") from None
    units = {fields[n].get("name", "").strip().upper(): fields[n].get("units", "") for n in sorted(fields)}
    if not {"LAT", "LON"} <= units.keys() or len(units) < len(fields):
        raise _refused(path, "kind")
    due, text = shape[0] * shape[1] * len(units), root.findtext("{*}grid_data", "").strip()
    try:
        table = np.loadtxt(io.StringIO(text), comments=None, ndmin=2) if text else np.empty((0, len(units)))
    except ValueError:
        raise _refused(path, "numbers") from None
    if table.size != due or table.shape[1] != len(units):
        raise _refused(path, "count", count=table.size, due=due)
    if min(shape) < 2:
        raise _refused(path, "places")
    values = dict(zip(units, np.moveaxis(table.reshape(*shape, len(units)), -1, 0), strict=True))
    lat, lon = values.pop("LAT"), values.pop("LON")
    lats, lons = lat[:, 0], lon[0]
    known = np.abs(lats).max() <= 90.0 and np.abs(lons).max() <= 360.0
    if not (known and np.all(lat == lats[:, None]) and np.all(lon == lons)):
        raise _refused(path, "places")
    lons = unwrapped(lons)
    down, left = (-1 if axis[-1] < axis[0] else 1 for axis in (lats, lons))
    lats, lons = lats[::down], lons[::left]
    if not (np.all(np.diff(lats) > 0.0) and np.all(np.diff(lons) > 0.0)):
        raise _refused(path, "places")
    turned = {name: np.ascontiguousarray(field[::down, ::left]) for name, field in values.items()}
    said = (root.get(name, "").strip() for name in ("event_id", "shakemap_version"))
    return MapGrid(lats, lons, turned, units, ", version ".join(filter(None, said)))


def _refused(path: Path, key: str, **values: object) -> InputError:
    reason = phrase(f"inventory_tables.grid_{key}", **values)
    return InputError("common.unreadable", "shakemap", file=path, reason=reason)
