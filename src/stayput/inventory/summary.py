"""Sums over the results, by event, building and storey, and the pieces at greatest risk."""

from __future__ import annotations

import heapq
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from stayput.inventory.arrow import parquet
from stayput.inventory.items import NO_MEASURE
from stayput.verification.words import SMALL

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from pathlib import Path

WORST = 50
"""Pieces that the report lists."""

COLUMNS = (
    "event",
    "building",
    "storey",
    "rows",
    "pieces",
    "expected_overturned",
    "share_overturned",
    "expected_overturned_best",
    "share_overturned_best",
    "expected_loss",
    "expected_loss_best",
    "pieces_helped",
    "contents_out_share",
    "contents_out_share_best",
)
"""Columns of the summary: pieces counts every piece of a row; ``best`` is with each row's best measure.
Helped are those that one of their measures helps. Shares of contents are means over pieces that have some."""

READ = (
    "row",
    "id",
    "name",
    "event",
    "building",
    "storey",
    "count",
    "overturned",
    "overturned_low",
    "overturned_high",
    "slid",
    "best",
    "best_overturned",
    "best_overturned_low",
    "best_overturned_high",
    "best_by_cost",
    "expected_loss",
    "best_expected_loss",
    "contents_out_share",
    "best_contents_out_share",
)


def needs_none(row: Mapping[str, Any]) -> bool:
    """Return whether a row's piece needs no measure: none helps, and it hardly ever overturns or slides."""
    return row["best"] == NO_MEASURE and row["overturned"] < SMALL and not row["slid"] >= SMALL


@dataclass(slots=True)
class Total:
    """Sums over rows."""

    rows: int = 0
    pieces: int = 0
    fallen: float = 0.0
    fallen_best: float = 0.0
    loss: float | None = None
    loss_best: float | None = None
    unknown: int = 0
    helped: int = 0
    safe: int = 0
    filled: int = 0
    out: float = 0.0
    out_best: float = 0.0

    def add(self, row: dict[str, Any]) -> None:
        """Add a row; one whose runs were all given up counts as unknown."""
        self.rows += 1
        self.pieces += row["count"]
        if row["overturned"] != row["overturned"]:
            self.unknown += row["count"]
            return
        self.helped += row["count"] * (row["best"] != NO_MEASURE)
        self.safe += row["count"] * needs_none(row)
        self.fallen += row["count"] * row["overturned"]
        self.fallen_best += row["count"] * row["best_overturned"]
        if row["expected_loss"] is not None:
            self.loss = (self.loss or 0.0) + row["expected_loss"]
            self.loss_best = (self.loss_best or 0.0) + row["best_expected_loss"]
        out, best = row["contents_out_share"], row["best_contents_out_share"]
        if out is not None and best is not None:
            self.filled += row["count"]
            self.out += row["count"] * out
            self.out_best += row["count"] * best

    @property
    def share(self) -> float:
        """Expected share that overturns."""
        known = self.pieces - self.unknown
        return self.fallen / known if known else float("nan")

    @property
    def share_best(self) -> float:
        """The same with the best measures."""
        known = self.pieces - self.unknown
        return self.fallen_best / known if known else float("nan")

    @property
    def share_out(self) -> float | None:
        """Expected share of the contents that come out, on average over the pieces; none without contents."""
        return self.out / self.filled if self.filled else None

    @property
    def share_out_best(self) -> float | None:
        """The same with the best measures."""
        return self.out_best / self.filled if self.filled else None


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

    def rows(self) -> list[list[Any]]:
        """Return the rows of the summary, in the order of `COLUMNS`."""
        return [
            [
                event,
                building or None,
                storey or None,
                total.rows,
                total.pieces,
                total.fallen,
                total.share,
                total.fallen_best,
                total.share_best,
                total.loss,
                total.loss_best,
                total.helped,
                total.share_out,
                total.share_out_best,
            ]
            for (event, building, storey), total in sorted(self.places.items())
        ]


def _rows(folder: Path) -> Iterator[dict[str, Any]]:
    for path in sorted(folder.glob("*.parquet")):
        file: Any = parquet().ParquetFile(path)
        with file:
            for batch in file.iter_batches(8192, columns=list(READ)):
                yield from batch.to_pylist()


def summarise(folder: Path) -> Summary:
    """Return the summary of the parts of a folder, read a few rows at a time."""
    summary = Summary()
    heap: list[tuple[tuple[float, float, float, int], int, dict[str, Any]]] = []
    for number, row in enumerate(_rows(folder)):
        place = row["event"], row["building"] or "", row["storey"] or 0
        for total in (
            summary.places.setdefault(place, Total()),
            summary.events.setdefault(row["event"], Total()),
        ):
            total.add(row)
        if row["overturned"] == row["overturned"]:
            risk = row["expected_loss"] or 0.0, row["overturned"], row["overturned_high"]
            entry = ((*risk, -number), number, row)
            if len(heap) < WORST:
                heapq.heappush(heap, entry)
            else:
                heapq.heappushpop(heap, entry)
    summary.worst = [row for _, _, row in sorted(heap, reverse=True)]
    return summary
