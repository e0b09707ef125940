"""Where the headings of an inventory stand: in its first row alone, or else the table is refused."""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.inventory.cells import is_empty, shown
from stayput.inventory.columns import is_heading

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.inventory.cells import Cell

ROWS_OF_A_TITLE = 20
"""Most rows above the headings that are taken for a title."""

SHOWN = 3
"""Most headings that a sentence shows."""


def headings_in(row: Sequence[Cell]) -> list[str]:
    """Return the headings in a row, of which there are two at least, and half of what it holds; else none."""
    filled = [cell for cell in row if not is_empty(cell)]
    found = [cell for cell in filled if isinstance(cell, str) and is_heading(cell)]
    return found if len(found) > 1 and 2 * len(found) >= len(filled) else []


def refuse_headings_elsewhere(names: Sequence[str], sample: Sequence[Sequence[Cell]]) -> None:
    """Refuse headings that stand below a title, or go over two rows.

    Parameters
    ----------
    names : sequence of str
        The first row.
    sample : sequence
        Some of the rows below.
    """
    known, below_a_title = sum(map(is_heading, names)), not headings_in(names)
    for row, cells in enumerate(sample[: ROWS_OF_A_TITLE if below_a_title else 1], 2):
        found = headings_in(cells)
        if len(found) > (known if below_a_title else 0):
            raise InputError(
                f"inventory_tables.{'headings_below' if below_a_title else 'two_rows_of_headings'}",
                "inventory",
                row=row,
                found=", ".join(map(shown, found[:SHOWN])),
            )
