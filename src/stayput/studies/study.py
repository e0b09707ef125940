"""What every study gives: data, a figure, tables and a text, and its files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.files import draft
from stayput.report.figures import saved

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
        return "\n\n".join((f"# {self.title}", self.text.strip(), *self.captioned_tables())) + "\n"

    def captioned_tables(self) -> list[str]:
        """Return each table in Markdown below its caption."""
        return [f"**{caption}**\n\n{table_as_markdown(table)}" for caption, table in self.tables.items()]

    def write(self, folder: str | Path) -> list[Path]:
        """Write NetCDF, CSV, figures (PNG) and text into a folder, which is made; return the files.

        Quantities that do not lie over the dimensions of the main ones have a CSV file of their own.

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
        frames = in_frames(self.data)
        names = [self.name, *(f"{self.name}_{frame[0]}" for frame in frames[1:])]
        files = [
            folder / f"{self.name}.nc",
            folder / f"{self.name}.md",
            *(folder / f"{name}.csv" for name in names),
        ]
        with draft(files[0]) as path:
            self.data.to_netcdf(path, engine="scipy")
        with draft(files[1]) as path:
            path.write_text(self.markdown(), encoding="utf-8")
        for target, frame in zip(files[2:], frames, strict=True):
            with draft(target) as path:
                self.data[frame].to_dataframe().reset_index().to_csv(path, index=False)
        for name, figure in self.figures.items():
            files.append(folder / f"{self.name}_{name}.png")
            saved(figure, files[-1])
        return files


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
