"""`Study`, the result of every study: its files and tables; and checks of the studies' settings."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd

from stayput.catalogue import phrase
from stayput.errors import InputError, within
from stayput.files import folder_draft
from stayput.report.figures import saved

if TYPE_CHECKING:
    from collections.abc import Iterable

    import xarray as xr
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

    from stayput.catalogue import Phrase


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

    Examples
    --------
    >>> from studies import Quantity
    >>> slide = Quantity("largest slide [cm]", value=12.345, published=11.8)
    >>> f"{slide.label}: {slide}, published {slide.published}"
    'largest slide [cm]: 12.3, published 11.8'
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


YES, PARTLY, NO = "yes", "partly", "no"
"""Whether something published comes out of a study."""


def outcome_of(met: int, wanted: int) -> str:
    """Return whether something published comes out, of which so many of the wanted parts are met."""
    return YES if met >= wanted else PARTLY if met else NO


@dataclass(frozen=True, slots=True)
class Claim:
    """Something published beside ours.

    Parameters
    ----------
    source : str
        Where it was published, and for what.
    published, ours : str
        What was found there, and here.
    outcome : str
        `YES`, `PARTLY` or `NO`: whether it comes out.
    """

    source: str
    published: str
    ours: str
    outcome: str


def claims_table(claims: Iterable[Claim]) -> pd.DataFrame:
    """Return a row for each claim."""
    return pd.DataFrame(
        [
            {
                "source": claim.source,
                "published": claim.published,
                "ours": claim.ours,
                "comes out": claim.outcome,
            }
            for claim in claims
        ]
    )


@dataclass(frozen=True, slots=True, eq=False)
class Study:
    """A study's outcome.

    Attributes
    ----------
    name : str
        Its name on the command line.
    title : str
        What it is about.
    quantities : dict of str to Quantity
        Settings and key numbers of this run; the documentation's pages quote them by these names.
    data : xarray.Dataset
        All results, with units in the attributes.
    figures : dict of str to Figure
        Figures by name; the first is the main one.
    tables : dict of str to pandas.DataFrame
        Small tables by their caption.
    claims : tuple of Claim
        What was published of tests and surveys, beside ours; misses among them.

    Examples
    --------
    >>> import studies
    >>> study = studies.tip_over()
    >>> study.title, list(study.figures)
    ('Tip-over without an earthquake', ['margins'])
    >>> for quantity in study.quantities.values():
    ...     print(f"{quantity.label}: {quantity}")
    Pieces: 8
    Pieces that some case tips over on a hard floor: 3
    Pieces that some case tips over on carpet: 4
    Smallest margin: 0.62
    """

    name: str
    title: str
    quantities: dict[str, Quantity]
    data: xr.Dataset
    figures: dict[str, Figure]
    tables: dict[str, pd.DataFrame]
    claims: tuple[Claim, ...] = ()

    @property
    def summary(self) -> pd.DataFrame:
        """The quantities as a table: quantity, published, stayput, difference (stayput − published)."""
        return pd.DataFrame([quantity.row for quantity in self.quantities.values()])

    def markdown(self) -> str:
        """Return the summary and the tables in Markdown."""
        parts = (f"# {self.title}", table_as_markdown(self.summary), *self.captioned_tables())
        return "\n\n".join(parts) + "\n"

    def captioned_tables(self) -> list[str]:
        """Return each table in Markdown below its caption."""
        return [f"**{caption}**\n\n{table_as_markdown(table)}" for caption, table in self.tables.items()]

    def write(self, folder: str | Path) -> list[Path]:
        """Write NetCDF, CSV, figures (PNG) and `markdown` into a folder, which is made; return the files.

        All are written, or none.

        Quantities that do not lie over the dimensions of the main ones have a CSV file of their own.

        Raises
        ------
        InputError
            A folder that cannot be written to.
        """
        names = [f"{self.name}.nc", f"{self.name}.md"]
        with folder_draft(Path(folder)) as unfinished:
            (unfinished / names[0]).write_bytes(self.data.to_netcdf(engine="scipy"))
            (unfinished / names[1]).write_text(self.markdown(), encoding="utf-8")
            for place, frame in enumerate(in_frames(self.data)):
                names.append(f"{self.name}{f'_{frame[0]}' if place else ''}.csv")
                table = self.data[frame].to_dataframe().reset_index()
                (unfinished / names[-1]).write_text(table.to_csv(index=False), encoding="utf-8")
            for name, figure in self.figures.items():
                names.append(f"{self.name}_{name}.png")
                saved(figure, unfinished / names[-1])
        return [Path(folder) / name for name in names]


def in_frames(data: xr.Dataset) -> list[list[str]]:
    """Return the quantities that go into one table each, so that none is repeated over others' dimensions."""
    frames: list[list[str]] = []
    for name in sorted(map(str, data.data_vars), key=lambda name: -data[name].ndim):
        dims = set(data[name].dims)
        frame = next((frame for frame in frames if dims <= set(data[frame[0]].dims)), None)
        if frame is None:
            frames.append([name])
        else:
            frame.append(name)
    return frames


def table_as_markdown(table: pd.DataFrame) -> str:
    """Return a small table in Markdown; numbers to the right, missing values empty."""
    numeric = [table[column].dtype.kind in "ifb" for column in table.columns]

    def cell(value: object) -> str:
        if isinstance(value, float):
            return "" if value != value else f"{value:.4g}"
        return str(value)

    heads = [str(column) for column in table.columns]
    rule = ["--:" if right else ":--" for right in numeric]
    rows = [[cell(value) for value in row] for row in table.itertuples(index=False)]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in (heads, rule, *rows))


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


def listed(values: ArrayLike, form: str = "g") -> str:
    """Return numbers as text with commas between them, or "none"."""
    return ", ".join(format(value, form) for value in np.ravel(values).tolist()) or "none"


def increasing(
    name: str | Phrase,
    values: ArrayLike,
    low: float = -np.inf,
    high: float = np.inf,
    unit: str = "",
    *,
    least: int = 1,
    refusal: str = "studies.not_increasing",
    **words: Any,
) -> NDArray[np.float64]:
    """Return values as an array, each within limits and above the one before.

    Parameters
    ----------
    name : str or Phrase
        What each value is called: an id of the catalogue, or a text in both languages.
    values : array_like
        The values.
    low, high : float
        Limits of each value.
    unit : str
        Their unit.
    least : int
        How many values there must be.
    refusal : str
        Id of the sentence that refuses values that are too few or do not increase.
    **words
        What that sentence needs besides ``name``, ``count`` and ``values``.

    Raises
    ------
    InputError
        Values out of range, too few, or not increasing.
    """
    array = np.array([within(name, value, low, high, unit) for value in np.ravel(values)])
    if len(array) < least or (np.diff(array) <= 0.0).any():
        raise InputError(refusal, name=phrase(name), count=len(array), values=array.tolist(), **words)
    return array


def rising(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return two or more rising values; ``name`` is the id in the catalogue of what they are.

    Raises
    ------
    InputError
        Fewer than two, or values that do not rise.
    """
    single, several = phrase("studies.one_of", name=phrase(name)), phrase(name)
    return increasing(single, values, least=2, refusal="studies.not_rising", several=several)
