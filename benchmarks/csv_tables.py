"""Tables of benchmarks: printed as Markdown, and written as CSV to where the documentation reads them."""

from __future__ import annotations

import csv
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from pathlib import Path


def tell(name: str, heads: Sequence[str], rows: Iterable[Sequence[str]], folder: Path | None) -> None:
    """Print a table, whose columns but the first are numbers, and write it as ``name``.csv to a folder."""
    lines = [heads, *rows]
    for cells in (heads, [":--", *["--:"] * (len(heads) - 1)], *lines[1:]):
        print(f"| {' | '.join(cells)} |")
    print(flush=True)
    if folder is not None:
        folder.mkdir(parents=True, exist_ok=True)
        with (folder / f"{name}.csv").open("w", newline="", encoding="utf-8") as file:
            csv.writer(file, lineterminator="\n").writerows(lines)


def three(value: float) -> str:
    """Return a number with three digits, or all before the point."""
    return f"{value:,.0f}" if abs(value) >= 100.0 else f"{value:.3g}"
