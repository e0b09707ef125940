"""`Study`, the result of every study: numbers beside the published ones, data, tables and a figure."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd

from stayput.files import folder_draft
from stayput.report.figures import new_figure, style

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00")
"""Colours of lines, of Okabe and Ito."""

YES, PARTLY, NO = "yes", "partly", "no"
"""Whether something published comes out of a study."""


@dataclass(frozen=True, slots=True)
class Quantity:
    """A number of a study, or words where the result is no number, beside the published one.

    Attributes
    ----------
    label : str
        What it is, with its unit in brackets.
    value : float or str
        The result of the run.
    published : float or str, optional
        The value of the paper, the test, the survey or the formula; of a count, what it is of.
    form : str
        Format specification of both numbers.
    """

    label: str
    value: float | str
    published: float | str | None = None
    form: str = ".3g"

    def __str__(self) -> str:
        """Return the value as the summary and the documentation show it."""
        return self._shown(self.value)

    @property
    def row(self) -> dict[str, str]:
        """Its row in the summary."""
        numbers = [value for value in (self.published, self.value) if isinstance(value, int | float)]
        known = len(numbers) == 2 and all(map(np.isfinite, numbers))
        return {
            "quantity": self.label,
            "published": "" if self.published is None else self._shown(self.published),
            "stayput": str(self),
            "difference": f"{numbers[1] - numbers[0]:+{self.form}}" if known else "",
        }

    def _shown(self, value: float | str) -> str:
        if isinstance(value, str):
            return value
        return format(value, self.form) if np.isfinite(value) else "none"


def claim(source: str, published: str, ours: str, met: int, wanted: int) -> dict[str, str]:
    """Return the row of something published: it comes out, or partly, by how many of its parts are met."""
    outcome = YES if met >= wanted else PARTLY if met else NO
    return {"source": source, "published": published, "ours": ours, "comes out": outcome}


@dataclass(frozen=True, slots=True, eq=False)
class Study:
    """A study's outcome.

    Attributes
    ----------
    name : str
        The name of its module.
    title : str
        What it is about.
    quantities : dict of str to Quantity
        Key numbers of this run; the documentation's texts quote them by these names.
    data : xarray.Dataset
        All results, with units in the attributes.
    figure : Figure
        Its figure.
    tables : dict of str to pandas.DataFrame
        Small tables by their caption.
    claims : list of dict
        What was published of tests and surveys, beside ours, as `claim` has it; misses among them.
    """

    name: str
    title: str
    quantities: dict[str, Quantity]
    data: xr.Dataset
    figure: Figure
    tables: dict[str, pd.DataFrame]
    claims: tuple[dict[str, str], ...] = ()

    @property
    def summary(self) -> pd.DataFrame:
        """The quantities as a table: quantity, published, stayput, difference (stayput − published)."""
        return pd.DataFrame([quantity.row for quantity in self.quantities.values()])

    def markdown(self) -> str:
        """Return the summary and the tables in Markdown."""
        tables = [f"**{caption}**\n\n{as_markdown(table)}" for caption, table in self.tables.items()]
        return "\n\n".join((f"# {self.title}", as_markdown(self.summary), *tables)) + "\n"

    def write(self, folder: str | Path) -> list[Path]:
        """Write data (NetCDF), tables (CSV), Markdown and figure into a folder, all or none."""
        tables = {"": self.summary} | {f"_{n}": t for n, t in enumerate(self.tables.values(), 1)}
        files = [f"{self.name}.nc", f"{self.name}.md", f"{self.name}.png"]
        with folder_draft(Path(folder)) as draft:
            (draft / files[0]).write_bytes(self.data.to_netcdf(engine="scipy"))
            (draft / files[1]).write_text(self.markdown(), encoding="utf-8")
            self.figure.savefig(draft / files[2])
            for ending, table in tables.items():
                files.append(f"{self.name}{ending}.csv")
                table.to_csv(draft / files[-1], index=False)
        return [Path(folder) / file for file in files]


def as_markdown(table: pd.DataFrame) -> str:
    """Return a small table in Markdown; numbers to the right, missing values empty."""
    heads = [str(column) for column in table.columns]
    rule = ["--:" if table[column].dtype.kind in "ifb" else ":--" for column in table.columns]
    shown = [map(_cell, row) for row in table.itertuples(index=False)]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in (heads, rule, *shown))


def _cell(value: object) -> str:
    return ("" if np.isnan(value) else f"{value:.4g}") if isinstance(value, float) else str(value)


def span(values: ArrayLike, form: str = ".2f") -> str:
    """Return the smallest and the largest of some numbers as text, or one where both read the same.

    Examples
    --------
    >>> span([0.5, 2.0, 1.0])
    '0.50 to 2.00'
    """
    array = np.asarray(values, np.float64)
    if not np.isfinite(array).any():
        return "none"
    low, high = format(np.nanmin(array), form), format(np.nanmax(array), form)
    return low if low == high else f"{low} to {high}"


def panels(
    columns: int, rows: int = 1, *, width: float = 4.6, height: float = 4.4, **shared: Any
) -> tuple[Figure, list[Axes]]:
    """Return a figure of styled axes, row by row; ``width`` and ``height`` of each in inches."""
    figure = new_figure(width * columns, height * rows)
    axes: list[Axes] = figure.subplots(rows, columns, squeeze=False, **shared).ravel().tolist()
    for axis in axes:
        style(axis, zero=False)
    return figure, axes


def label_edges(axes: list[Axes], columns: int, below: str, left: str) -> None:
    """Label the axes of the lowest row and of the first column."""
    for axis in axes[-columns:]:
        axis.set_xlabel(below)
    for axis in axes[::columns]:
        axis.set_ylabel(left)
