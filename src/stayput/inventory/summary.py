"""Sums over the results, by event, building and storey, and the pieces at greatest risk."""

from __future__ import annotations

import heapq
from collections import Counter
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from stayput.inventory.arrow import parquet
from stayput.inventory.results import Finding
from stayput.verification.words import SAFE, SMALL

if TYPE_CHECKING:
    from collections.abc import Iterator
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
    "share_overturned_low",
    "share_overturned_high",
    "expected_overturned_best",
    "share_overturned_best",
    "share_overturned_best_low",
    "share_overturned_best_high",
    "expected_loss",
    "expected_loss_best",
    *(f"pieces_{finding}" for finding in Finding),
    "contents_out_share",
    "contents_out_share_best",
)
"""Columns of the summary: pieces counts every piece of a row; ``best`` is with the best measure of those rows
that one clearly helps, without it in the others: their gain may be chance. The ends of the interval are means
of the rows' own; `Finding` says what pieces are counted by. Shares of contents are means over pieces that
have some."""

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
    "best",
    "best_overturned",
    "best_overturned_low",
    "best_overturned_high",
    "best_lessens",
    "finding",
    "best_by_cost",
    "expected_loss",
    "best_expected_loss",
    "contents_out_share",
    "best_contents_out_share",
)


@dataclass(slots=True)
class Total:
    """Sums over rows."""

    rows: int = 0
    pieces: int = 0
    fallen: float = 0.0
    fallen_low: float = 0.0
    fallen_high: float = 0.0
    fallen_best: float = 0.0
    fallen_best_low: float = 0.0
    fallen_best_high: float = 0.0
    loss: float | None = None
    loss_best: float | None = None
    unknown: int = 0
    found: Counter[str] = field(default_factory=Counter[str])
    lessened: Counter[tuple[str, str]] = field(default_factory=Counter[tuple[str, str]])
    filled: int = 0
    out: float = 0.0
    out_best: float = 0.0

    def add(self, row: dict[str, Any]) -> None:
        """Add a row; one whose runs were all given up counts as unknown."""
        self.rows += 1
        self.pieces += row["count"]
        if row["finding"] is None:
            self.unknown += row["count"]
            return
        self.found[row["finding"]] += row["count"]
        if row["best_lessens"] is not None:
            self.lessened[row["finding"], row["best_lessens"]] += row["count"]
        taken = "best_" if row["finding"] == Finding.HELPED else ""
        for end in ("", "_low", "_high"):
            for sums, column in ((f"fallen{end}", "overturned"), (f"fallen_best{end}", f"{taken}overturned")):
                setattr(self, sums, getattr(self, sums) + row["count"] * row[f"{column}{end}"])
        if row["expected_loss"] is not None:
            self.loss = (self.loss or 0.0) + row["expected_loss"]
            self.loss_best = (self.loss_best or 0.0) + row[f"{taken}expected_loss"]
        out, best = row["contents_out_share"], row[f"{taken}contents_out_share"]
        if out is not None and best is not None:
            self.filled += row["count"]
            self.out += row["count"] * out
            self.out_best += row["count"] * best

    def share(self, which: str = "") -> float:
        """Return the expected share that overturns, or its "_low" or "_high" end; "_best…" with measures."""
        known = self.pieces - self.unknown
        return getattr(self, f"fallen{which}") / known if known else float("nan")

    def untold(self, which: str = "") -> bool:
        """Return whether hardly any overturned, and the runs are too few to say that hardly any does."""
        return self.share(which) < SMALL and self.share(f"{which}_high") >= SAFE

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
                *(total.share(end) for end in ("", "_low", "_high")),
                total.fallen_best,
                *(total.share(f"_best{end}") for end in ("", "_low", "_high")),
                total.loss,
                total.loss_best,
                *(total.found[finding] for finding in Finding),
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
        if row["finding"] is not None:
            risk = row["expected_loss"] or 0.0, row["overturned"], row["overturned_high"]
            entry = ((*risk, -number), number, row)
            if len(heap) < WORST:
                heapq.heappush(heap, entry)
            else:
                heapq.heappushpop(heap, entry)
    summary.worst = [row for _, _, row in sorted(heap, reverse=True)]
    return summary
