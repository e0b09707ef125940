"""Run the validation and write its tables and its plot: the numbers of the validation page.

The documentation's build calls `write`; ``python docs/validation_run.py`` prints the known solutions.
"""

from __future__ import annotations

import inspect
import sys
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from reference_setup import Row

HERE = Path(__file__).parent
for folder in (HERE, HERE.parent / "benchmarks"):
    if str(folder) not in sys.path:
        sys.path.insert(0, str(folder))

import convergence  # noqa: E402
from reference_cases import CASES  # noqa: E402
from reference_space import SPACE_CASES  # noqa: E402


def markdown(heads: list[str], rows: list[list[str]], align: str) -> str:
    """Return a Markdown table; ``align`` has a letter (l or r) for each column."""
    rule = [":--" if letter == "l" else "--:" for letter in align]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in (heads, rule, *rows)) + "\n"


def six(value: float) -> str:
    """Write six digits."""
    return f"{value:.6g}"


def small(size: float) -> str:
    """Write an error."""
    return f"{size:.0e}" if size > 1e-15 else "0"


def case_section(number: int, case: Callable[[], Iterator[Row]]) -> str:
    """Run one reference case; return its heading, text and table. Fails where it misses its tolerance."""
    title, _, text = (inspect.getdoc(case) or "").partition("\n\n")
    rows = list(case())
    missed = [f"{row.case}, {row.quantity}: {row.computed:g}" for row in rows if row.error > row.tolerance]
    if missed:
        raise RuntimeError(f"Validation missed its tolerance: {'; '.join(missed)}")
    several = len({row.case for row in rows}) > 1
    heads = ["case", "quantity", "reference", "kind", "stayput", "error", "allowed"]
    lines = [
        [r.case, r.quantity, six(r.reference), r.source, six(r.computed), small(r.error), f"{r.tolerance:g}"]
        for r in rows
    ]
    if not several:
        text = f"{text.removesuffix('.')}; {rows[0].case}."
        heads, lines = heads[1:], [line[1:] for line in lines]
    table = markdown(heads, lines, "llrlrrr"[-len(heads) :])
    return f"### {number}. {title.removesuffix('.')}\n\n{text}\n\n{table}"


def cases_sections(cases: tuple[Callable[[], Iterator[Row]], ...]) -> str:
    """Run reference cases."""
    return "\n".join(case_section(number, case) for number, case in enumerate(cases, 1))


def convergence_table(found: list[convergence.Curve]) -> str:
    """Return the errors over the step, with the fitted order."""
    heads = ["problem, step", *(f"{step:g} s" for step in convergence.STEPS), "order"]
    rows = [[c.name, *(f"{error:.1e}" for error in c.errors), f"{c.order:.1f}"] for c in found]
    return markdown(heads, rows, "l" + "r" * (len(heads) - 1))


def work_table() -> str:
    """Return the work–precision table."""
    heads = [
        "sampled every [s]",
        "tolerance [rad]",
        "median error",
        "99 %",
        "largest",
        "flipped verdicts",
        "cases/s on one core",
    ]
    rows = [
        [f"{step:g}", f"{tolerance:.0e}", *map(small, (half, most, worst)), str(flips), f"{rate:,.0f}"]
        for step, tolerance, half, most, worst, flips, rate in convergence.work_precision()
    ]
    return markdown(heads, rows, "rrrrrrr")


def write(folder: Path) -> None:
    """Run everything and write the tables and the plot into a folder."""
    found = convergence.curves()
    (folder / "validation_cases.md").write_text(cases_sections(CASES), encoding="utf-8")
    (folder / "validation_space.md").write_text(cases_sections(SPACE_CASES), encoding="utf-8")
    (folder / "validation_convergence.md").write_text(convergence_table(found), encoding="utf-8")
    (folder / "validation_work.md").write_text(work_table(), encoding="utf-8")
    convergence.plot(found, folder / "convergence.svg")


if __name__ == "__main__":
    print(cases_sections(CASES + SPACE_CASES))
