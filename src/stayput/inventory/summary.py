"""What is made of the results: sums, the pieces at greatest risk, and the files of other programs.

CSV and GeoJSON have a row for each piece and event and all columns of the Parquet files but the sets of
measures one by one. What is not a number, or infinite, is empty there.
"""

from __future__ import annotations

import csv
import heapq
import io
import json
import math
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import chain, islice
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from stayput.errors import unknown
from stayput.files import CSV_ENCODING, arrow, harmless
from stayput.inventory.plan import REJECTED, ROWS_PER_PART
from stayput.inventory.results import ENDS, PIECES, Finding, schema
from stayput.verification.words import SAFE, SMALL

if TYPE_CHECKING:
    from stayput.inventory.folder import Workspace
    from stayput.inventory.store import Store

WORST = 50
"""Pieces that the report lists."""

REJECTS = "rejects.parquet"
FORMATS = ("csv", "geojson")
"""Formats beside Parquet, by the endings of their files."""

_KINDS = {"event": "string", "building": "string", "storey": "int32", "currency": "string"}
"""Types of columns of the summary; those that count rows or pieces are whole too, all others are not."""

READ = (
    *("row", "id", "name", "event", "building", "storey", "count", "fixed"),
    *("best", "best_lessens", "finding"),
    *(f"{which}overturned{end}" for which in ("", "best_") for end in ENDS),
    *("best_by_cost", "expected_loss", "best_expected_loss", "contents_out_share", "best_contents_out_share"),
)
"""Columns of the results that are read to sum them up."""


@dataclass(slots=True)
class Total:
    """Sums over rows; those of ``fallen`` and ``out`` by the keys of `share`."""

    rows: int = 0
    pieces: int = 0
    fallen: defaultdict[str, float] = field(default_factory=lambda: defaultdict(float))
    loss: float | None = None
    loss_best: float | None = None
    unknown: int = 0
    findings: Counter[str] = field(default_factory=Counter[str])
    lessened: Counter[tuple[str, str]] = field(default_factory=Counter[tuple[str, str]])
    filled: int = 0
    out: defaultdict[str, float] = field(default_factory=lambda: defaultdict(float))

    def add(self, row: dict[str, Any]) -> None:
        """Add a row; one whose runs were all given up counts as unknown."""
        self.rows += 1
        self.pieces += row["count"]
        if row["finding"] is None:
            self.unknown += row["count"]
            return
        self.findings[row["finding"]] += row["count"]
        if row["best_lessens"] is not None:
            self.lessened[row["finding"], row["best_lessens"]] += row["count"]
        taken = "best_" if row["finding"] == Finding.HELPED else ""
        for end in ENDS:
            self.fallen[end] += row["count"] * row[f"overturned{end}"]
            self.fallen[f"_best{end}"] += row["count"] * row[f"{taken}overturned{end}"]
        if row["expected_loss"] is not None:
            self.loss = (self.loss or 0.0) + row["expected_loss"]
            self.loss_best = (self.loss_best or 0.0) + row[f"{taken}expected_loss"]
        out, best = row["contents_out_share"], row[f"{taken}contents_out_share"]
        if out is not None and best is not None:
            self.filled += row["count"]
            self.out[""] += row["count"] * out
            self.out["_best"] += row["count"] * best

    def share(self, which: str = "") -> float:
        """Return the expected share that overturns, or its "_low" or "_high" end; "_best…" with measures."""
        known = self.pieces - self.unknown
        return self.fallen[which] / known if known else float("nan")

    def untold(self, which: str = "") -> bool:
        """Return whether hardly any overturned, and the runs are too few to say that hardly any does."""
        return self.share(which) < SMALL and self.share(f"{which}_high") >= SAFE

    def share_out(self, which: str = "") -> float | None:
        """Return the expected share of the contents that come out, on average over the pieces that have some.

        It is none where no piece has; "_best" is with the best measures.
        """
        return self.out[which] / self.filled if self.filled else None

    @property
    def numbers(self) -> dict[str, float | int | None]:
        """The sums as the summary has them: pieces counts every piece of a row.

        ``best`` is with the best measure of those rows that one clearly helps, without it in the others:
        their gain may be chance. The ends of the interval are means of the rows' own; `Finding` says what
        pieces are counted by. Shares of contents are means over pieces that have some.
        """
        return {
            "rows": self.rows,
            "pieces": self.pieces,
            "expected_overturned": self.fallen[""],
            **{f"share_overturned{end}": self.share(end) for end in ENDS},
            "expected_overturned_best": self.fallen["_best"],
            **{f"share_overturned_best{end}": self.share(f"_best{end}") for end in ENDS},
            "expected_loss": self.loss,
            "expected_loss_best": self.loss_best,
            **{f"pieces_{finding}": self.findings[finding] for finding in Finding},
            "contents_out_share": self.share_out(),
            "contents_out_share_best": self.share_out("_best"),
        }


Place = tuple[str, str, int]
"""Event, building ("" on the ground) and storey (0 on the ground)."""


@dataclass(slots=True)
class Summary:
    """Totals of the results.

    Parameters
    ----------
    places : dict
        Totals by event, building and storey.
    events : dict
        Totals by event.
    worst : list
        Rows of the greatest risk, the worst first.
    """

    places: dict[Place, Total] = field(default_factory=dict[Place, Total])
    events: dict[str, Total] = field(default_factory=dict[str, Total])
    worst: list[dict[str, Any]] = field(default_factory=list[dict[str, Any]])

    def write(self, folder: Path, space: Workspace, currency: str) -> None:
        """Write the totals by event, building and storey as Parquet and CSV, losses in a currency or ""."""
        money = {"currency": currency or None}
        rows: list[dict[str, Any]] = [
            {"event": event, "building": building or None, "storey": storey or None, **total.numbers, **money}
            for (event, building, storey), total in sorted(self.places.items())
        ]
        pa = arrow()
        named = ["event", "building", "storey", *Total().numbers, *money]
        kinds = {
            name: "int64" if name.startswith(("rows", "pieces")) else "float64" for name in named
        } | _KINDS
        schema = pa.schema([(name, getattr(pa, kind)()) for name, kind in kinds.items()])
        with space.durable(folder / "summary.parquet") as file:
            arrow("parquet").write_table(pa.Table.from_pylist(rows, schema=schema), file)
        _write_csv(folder / "summary.csv", space, named, (row.values() for row in rows))


def summarise(folder: Path) -> Summary:
    """Return the summary of the parts of a folder, read a few rows at a time."""
    summary = Summary()

    def known_rows() -> Iterator[dict[str, Any]]:
        for row in _rows(folder, READ):
            place = row["event"], row["building"] or "", row["storey"] or 0
            summary.places.setdefault(place, Total()).add(row)
            summary.events.setdefault(row["event"], Total()).add(row)
            if row["finding"] is not None:
                yield row

    def risk(row: dict[str, Any]) -> tuple[float, float, float]:
        return row["expected_loss"] or 0.0, row["overturned"], row["overturned_high"]

    summary.worst = heapq.nlargest(WORST, known_rows(), risk)
    return summary


def write_rejects(folder: Path, space: Workspace, store: Store) -> None:
    """Write the rows that were not assessed, with their reasons, as Parquet and CSV."""
    pa = arrow()
    schema = pa.schema([(name, pa.string() if n else pa.int64()) for n, name in enumerate(REJECTED)])
    with (
        space.durable(folder / REJECTS) as file,
        arrow("parquet").ParquetWriter(file, schema, compression="zstd") as parquet,
    ):
        rejects = store.rejects()
        while lines := list(islice(rejects, ROWS_PER_PART)):
            rows = [dict(zip(REJECTED, line, strict=True)) for line in lines]
            parquet.write_table(pa.Table.from_pylist(rows, schema=schema))
    lines = ((row, " ".join(piece.split()), *texts) for row, piece, *texts in store.rejects())
    _write_csv(folder / "rejects.csv", space, REJECTED, lines)


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


def export_results(folder: Path, space: Workspace, formats: Sequence[str]) -> None:
    """Write the results in other formats beside their Parquet files, each atomically."""
    names = [name for name in schema({}).names if name != "options"]
    for name in formats:
        path = folder / f"pieces.{name}"
        rows = ({key: _plain(row[key]) for key in names} for row in _rows(folder / PIECES, names))
        if name == "csv":
            _write_csv(path, space, names, (row.values() for row in rows))
        else:
            _write_geojson(path, space, rows)


def _plain(value: Any) -> str | float | int | None:
    match value:
        case float():
            return value if math.isfinite(value) else None
        case list():  # the sets of measures that cannot be put in place
            sets = cast("list[dict[str, str]]", value)
            return "; ".join(f"{each['name']}: {each['reason']}" for each in sets) or None
        case _:
            return value


def _write_csv(path: Path, space: Workspace, names: Sequence[str], rows: Iterable[Iterable[object]]) -> None:
    with space.durable(path) as file:
        text = io.TextIOWrapper(file, CSV_ENCODING, newline="")
        csv.writer(text).writerows(map(harmless, row) for row in chain([names], rows))
        text.detach()


def _write_geojson(path: Path, space: Workspace, rows: Iterable[dict[str, Any]]) -> None:
    """Write GeoJSON (RFC 7946): a feature a line; one without a place has no geometry."""
    with space.durable(path) as file:
        mark = b'{"type": "FeatureCollection", "features": [\n'
        for row in rows:
            lat, lon = row["lat"], row["lon"]
            geometry = None
            if lat is not None and lon is not None:
                geometry = {"type": "Point", "coordinates": [lon - 360.0 if lon > 180.0 else lon, lat]}
            feature = {"type": "Feature", "geometry": geometry, "properties": row}
            file.write(mark + json.dumps(feature, ensure_ascii=False, allow_nan=False).encode())
            mark = b",\n"
        file.write(b"\n]}\n")


def _rows(folder: Path, columns: Sequence[str]) -> Iterator[dict[str, Any]]:
    """Yield columns of the results row by row, read some at a time."""
    for path in sorted(folder.glob("*.parquet")):
        with arrow("parquet").ParquetFile(path) as file:
            for batch in file.iter_batches(8192, columns=list(columns)):
                yield from batch.to_pylist()
