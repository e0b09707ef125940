"""The results as other programs open them: CSV and GeoJSON.

They have a row for each piece and event and all columns of the Parquet files but the sets of measures one by
one. What is not a number, or infinite, is empty.
"""

from __future__ import annotations

import csv
import json
import math
from typing import TYPE_CHECKING, Any, cast

from stayput.errors import InputError, unknown
from stayput.inventory.arrow import parquet
from stayput.inventory.results import PIECES, part_names
from stayput.spreadsheets import harmless

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence
    from pathlib import Path

    from stayput.inventory.workspace import Workspace

FORMATS = ("csv", "geojson")
"""Formats beside Parquet, by the endings of their files."""

ROWS_AT_A_TIME = 5000


def formats_of(export: str | Sequence[str]) -> tuple[str, ...]:
    """Return the formats of a text such as "csv,geojson", or of several, in the order of `FORMATS`.

    Raises
    ------
    InputError
        Another format.
    """
    stated = export.split(",") if isinstance(export, str) else list(export)
    names = [name.strip().lower() for name in stated if name.strip()]
    for name in names:
        if name not in FORMATS:
            raise unknown("inventory_tables.export", name, FORMATS, field="export")
    return tuple(name for name in FORMATS if name in names)


def refuse_nowhere(formats: Sequence[str], located: int) -> None:
    """Refuse a map where no piece says where it stands."""
    if "geojson" in formats and not located:
        raise InputError("inventory_tables.nowhere", "export", formats="geojson")


def export_results(folder: Path, space: Workspace, parts: int, formats: Sequence[str]) -> list[Path]:
    """Write the results in other formats beside their Parquet files, each atomically; return the files."""
    writers: dict[str, Callable[[Path, Path, int], None]] = {
        "csv": _write_csv,
        "geojson": _write_geojson,
    }
    paths: list[Path] = []
    for name in formats:
        draft, path = space.draft(), folder / f"pieces.{name}"
        try:
            writers[name](draft, folder / PIECES, parts)
            space.publish(draft, path)
        finally:
            draft.unlink(missing_ok=True)
        paths.append(path)
    return paths


def _rows(pieces: Path, parts: int) -> Iterator[list[dict[str, Any]]]:
    """Yield the rows of the results some at a time, each with plain values only."""
    for name in part_names(parts):
        file: Any = parquet().ParquetFile(pieces / name)
        columns = [field.name for field in file.schema_arrow if field.name != "options"]
        with file:
            for batch in file.iter_batches(ROWS_AT_A_TIME, columns=columns):
                yield [{column: _plain(value) for column, value in row.items()} for row in batch.to_pylist()]


def _plain(value: Any) -> str | float | int | None:
    match value:
        case float():
            return value if math.isfinite(value) else None
        case list():  # the sets of measures that cannot be put in place
            sets = cast("list[dict[str, str]]", value)
            return "; ".join(f"{each['name']}: {each['reason']}" for each in sets) or None
        case _:
            return value


def _position(row: dict[str, Any]) -> tuple[float, float] | None:
    """Return the longitude, from -180° to 180°, and the latitude of a row."""
    lat, lon = row["lat"], row["lon"]
    if lat is None or lon is None:
        return None
    return (lon - 360.0 if lon > 180.0 else lon), lat


def _write_csv(draft: Path, pieces: Path, parts: int) -> None:
    with draft.open("x", encoding="utf-8-sig", newline="") as file:
        lines = csv.writer(file)
        for number, rows in enumerate(_rows(pieces, parts)):
            if number == 0:
                lines.writerow(rows[0])
            lines.writerows(map(harmless, row.values()) for row in rows)


def _write_geojson(draft: Path, pieces: Path, parts: int) -> None:
    """Write GeoJSON (RFC 7946): a feature a line; one without a place has no geometry."""
    with draft.open("x", encoding="utf-8") as file:
        file.write('{"type": "FeatureCollection", "features": [')
        mark = "\n"
        for rows in _rows(pieces, parts):
            for row in rows:
                place = _position(row)
                geometry = None if place is None else {"type": "Point", "coordinates": list(place)}
                feature = {"type": "Feature", "geometry": geometry, "properties": row}
                file.write(mark + json.dumps(feature, ensure_ascii=False, allow_nan=False))
                mark = ",\n"
        file.write("\n]}\n")
