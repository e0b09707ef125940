"""CSV that is safe to open in a spreadsheet, which runs texts that look like formulas; names of columns."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Sequence

from stayput.errors import InputError, excerpt

CSV_ENCODING = "utf-8-sig"
"""Encoding of the CSV files that people open: by its byte order mark Excel tells that they are UTF-8."""

FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "＝", "＋", "－", "＠")
"""How a text begins that a spreadsheet takes for a formula; East Asian ones take the wide signs as well."""


def harmless(cell: object) -> object:
    """Return a cell as it is written: nothing for None, a quote before a text that looks like a formula."""
    if cell is None:
        return ""
    return f"'{cell}" if isinstance(cell, str) and cell.startswith(FORMULA) else cell


def csv_text(names: Sequence[str], rows: Iterable[Iterable[object]], end: str = "\r\n") -> str:
    """Return a table as CSV, whose lines end in CR LF or in LF alone; see `harmless`.

    With LF alone `csv` leaves a lone carriage return without quotes, and it would end the row: it becomes
    a blank.
    """
    text = io.StringIO()
    lines = csv.writer(text, lineterminator=end)
    for row in (names, *rows):
        cells = map(harmless, row)
        lines.writerow(
            cell.replace("\r", " ") if isinstance(cell, str) and end == "\n" else cell for cell in cells
        )
    return text.getvalue()


_NEXT_PAIR = re.compile(r",(?=[^,=]*=)")
"""The comma before a pair; another one is in a table's name of a column."""


def named_columns(text: str, otherwise: str, field: str = "columns") -> list[tuple[str, str]]:
    """Return the names and the columns of a text such as "width=奥行,height=高さ[cm]".

    Parameters
    ----------
    text : str
        The text.
    otherwise : str
        Id of the sentence that refuses a part of it.
    field : str
        What the text is of.

    Raises
    ------
    InputError
        A part that has no name or no column.
    """
    pairs: list[tuple[str, str]] = []
    for part in _NEXT_PAIR.split(text):
        name, _, column = (side.strip() for side in part.partition("="))
        if not (name and column):
            raise InputError(otherwise, field, name=field, value=excerpt(part))
        pairs.append((name, column))
    return pairs
