"""What every study gives: data, a figure, tables and a text, and its files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.report.figures import saved
from stayput.report.files import draft

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.figure import Figure


@dataclass(frozen=True, slots=True, eq=False)
class Study:
    """A study's outcome.

    Attributes
    ----------
    name : str
        Its name on the command line.
    title : str
        What it is about.
    text : str
        What was done and found, in Markdown paragraphs with the numbers of this run.
    data : xarray.Dataset
        All results, with units in the attributes.
    figures : dict of str to Figure
        Figures by name; the first is the main one.
    tables : dict of str to pandas.DataFrame
        Small tables by their caption.
    """

    name: str
    title: str
    text: str
    data: xr.Dataset
    figures: dict[str, Figure]
    tables: dict[str, pd.DataFrame]

    def markdown(self) -> str:
        """Return the text and the tables."""
        parts = [f"# {self.title}", self.text.strip()]
        parts += [f"**{caption}**\n\n{table_as_markdown(table)}" for caption, table in self.tables.items()]
        return "\n\n".join(parts) + "\n"

    def write(self, folder: str | Path) -> list[Path]:
        """Write NetCDF, CSV, figures (PNG) and text into a folder, which is made; return the files.

        Raises
        ------
        InputError
            A folder that cannot be written to.
        """
        folder = Path(folder)
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            reason = (error.strerror or str(error)).lower()
            raise InputError(f"The folder is {str(folder)!r}; it cannot be made: {reason}.") from error
        files = [folder / f"{self.name}.nc", folder / f"{self.name}.csv", folder / f"{self.name}.md"]
        with draft(files[0]) as path:
            self.data.to_netcdf(path, engine="scipy")
        with draft(files[1]) as path:
            self.data.to_dataframe().reset_index().to_csv(path, index=False)
        with draft(files[2]) as path:
            path.write_text(self.markdown(), encoding="utf-8")
        for name, figure in self.figures.items():
            files.append(folder / f"{self.name}_{name}.png")
            saved(figure, files[-1])
        return files


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
