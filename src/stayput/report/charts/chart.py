"""A chart with its caption, its inputs, and its numbers, and the files that it is kept as."""

from __future__ import annotations

import csv
import io
import threading
from dataclasses import dataclass
from typing import TYPE_CHECKING

import matplotlib as mpl

import stayput
from stayput.catalogue import say
from stayput.report.figures import FONT, new_figure, saved
from stayput.report.fonts import drawable, with_face, wrapped
from stayput.report.palette import INK, MUTED
from stayput.spreadsheets import CSV_ENCODING, text_cell

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from matplotlib.figure import Figure

KINDS = {"svg": "image/svg+xml", "pdf": "application/pdf", "csv": "text/csv; charset=utf-8"}
"""Media types of the files that a chart is kept as."""

_drawing = threading.Lock()  # the settings of Matplotlib are the same for all threads


@dataclass(frozen=True, slots=True)
class ChartSource:
    """What a chart is of.

    Parameters
    ----------
    inputs : tuple of (str, str)
        What it rests on and its value, as they are read.
    scenario : str
        The scenario file's text.
    seed : int
        Seed of what was drawn.
    language : str
        "en" or "ja".
    """

    inputs: tuple[tuple[str, str], ...]
    scenario: str
    seed: int
    language: str

    def lines(self) -> list[str]:
        """Return inputs, version and seed as they are read."""
        colon, listed = (say(f"common.{key}", self.language) for key in ("colon", "listed"))
        inputs = listed.join(f"{what}{colon}{value}" for what, value in self.inputs)
        made = say("figures.made", self.language, version=stayput.__version__, seed=self.seed)
        return [say("figures.inputs", self.language, inputs=inputs), made]


@dataclass(frozen=True, slots=True)
class Chart:
    """A chart to be kept.

    Parameters
    ----------
    title : str
        What it shows.
    caption : str
        What is to be read from it, and how.
    source : ChartSource
        What it is of.
    columns : mapping of sequence
        Its numbers by the names of their columns; None where there is none.
    draw : callable
        Draws it into a figure.
    size : tuple of float
        Width and height without the caption [in].
    """

    title: str
    caption: str
    source: ChartSource
    columns: Mapping[str, Sequence[object]]
    draw: Callable[[Figure], None]
    size: tuple[float, float] = (8.4, 5.0)

    def file(self, kind: str) -> bytes:
        """Return it as a file of one of `KINDS`."""
        return self._csv().encode(CSV_ENCODING) if kind == "csv" else self._picture(kind)

    def _csv(self) -> str:
        """Return its numbers as a table, after what it is of in lines that begin with "#"."""
        text = io.StringIO()
        about = [self.title, self.caption, *self.source.lines(), "", *self.source.scenario.splitlines()]
        for line in "\n".join(about).splitlines():
            text.write(f"# {line}".rstrip() + "\n")
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(self.columns)
        for row in zip(*self.columns.values(), strict=True):
            writer.writerow([_cell(value) for value in row])
        return text.getvalue()

    def _picture(self, kind: str) -> bytes:
        """Return its picture with the caption below; the scenario file stands in the file's description."""
        width, height = self.size
        small = FONT - 1.5
        words, face = with_face("\n".join([self.caption, *self.source.lines()]), small * 10.0)
        lines = [wrapped(part, face, (width - 0.6) * 720.0) for part in words.split("\n")]
        below = "\n".join(lines)
        room = 0.2 + (below.count("\n") + 1) * 1.32 * small / 72.0
        with _drawing, mpl.rc_context({"svg.hashsalt": "stayput"}):
            figure = new_figure(width, height + room)
            rect = (0.0, room / (height + room), 1.0, height / (height + room))
            figure.set_layout_engine("constrained", rect=rect)
            figure.suptitle(drawable(self.title), fontsize=FONT + 1.5, color=INK)
            self.draw(figure)
            up = (room - 0.1) / (height + room)
            figure.text(0.15 / width, up, below, fontsize=small, color=MUTED, va="top", linespacing=1.3)
            content = io.BytesIO()
            saved(figure, None).savefig(content, format=kind, metadata=self._metadata(kind))
        return content.getvalue()

    def _metadata(self, kind: str) -> dict[str, object]:
        about = "\n".join([self.caption, *self.source.lines(), "", self.source.scenario])
        creator = f"stayput {stayput.__version__}"
        if kind == "svg":
            return {"Title": self.title, "Description": about, "Creator": creator, "Date": None}
        return {"Title": self.title, "Subject": about, "Creator": creator, "CreationDate": None}


def _cell(value: object) -> object:
    if isinstance(value, str):
        return text_cell(value)
    if isinstance(value, float):
        return "" if value != value else f"{value:.9g}"
    return "" if value is None else value
