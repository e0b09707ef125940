"""Names on a plan: where each stands so that they overlap as little as can be."""

from __future__ import annotations

import itertools
import unicodedata
from typing import TYPE_CHECKING, NamedTuple

from stayput.report.verdict import svg

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.report.room.sheet import Box

FONT = 13.0
"""Size of the letters [px]; that of ``.plan-room text`` in canvas/plan.css."""

LINE = 16.0 / 13.0
"""Height of a line, in sizes of the letters."""

LONGEST = 11.0
"""Longest line, in widths of a full-width letter."""

NARROW = 0.56
"""Width of a letter that is not full-width, in the same."""

WIDER = 1.2
"""How much wider names may be in the fonts of some systems."""

OTHER_NAME, OUTSIDE, OTHER_THING, FARTHER = 30.0, 20.0, 2.0, 0.15
"""What it costs that a name lies on another, beyond the floor, on another thing; and each next place."""


class PlanLabel(NamedTuple):
    """A name and where what it names is.

    Parameters
    ----------
    lines : tuple of str
        Its lines.
    note : str
        What is told below it; empty for nothing.
    box : tuple of float
        The rectangle of what it names [px].
    """

    lines: tuple[str, ...]
    note: str
    box: Box

    @property
    def texts(self) -> list[tuple[str, str]]:
        """All lines with their classes."""
        lines = [(line, "name halo") for line in self.lines]
        return [*lines, (self.note, "note halo")] if self.note else lines


def wrapped(name: str) -> tuple[str, ...]:
    """Return a name as at most two lines, cut where it is longer."""
    words, lines = name.split(), [""]
    for word in words:
        joined = f"{lines[-1]} {word}".strip()
        if lines[-1] and _width(joined) > LONGEST:
            lines.append(word)
        else:
            lines[-1] = joined
    kept = lines[:2]
    if len(lines) > 2:
        kept[-1] += "…"
    return tuple(_cut(line) for line in kept)


def _cut(line: str) -> str:
    if _width(line) <= LONGEST:
        return line
    while _width(line + "…") > LONGEST:
        line = line[:-1]
    return f"{line.rstrip('…')}…"


def _width(text: str) -> float:
    return sum(1.0 if unicodedata.east_asian_width(letter) in "WF" else NARROW for letter in text)


def names_svg(labels: Sequence[PlanLabel], boxes: Sequence[Box], letters: float = FONT) -> str:
    """Return names as texts in the rectangles where they stand, with letters of a size [px]."""
    line = LINE * letters
    return "".join(
        svg.label(0.5 * (box[0] + box[2]), box[1] + line * (row + 0.78), text, class_)
        for label, box in zip(labels, boxes, strict=True)
        for row, (text, class_) in enumerate(label.texts)
    )


def overlap(boxes: Sequence[Box]) -> bool:
    """Return whether any two rectangles share an area."""
    return any(_shared(first, second) > 0.0 for first, second in itertools.combinations(boxes, 2))


def places_of_names(
    labels: Sequence[PlanLabel], things: Sequence[Box], floor: Box, letters: float = FONT
) -> list[Box]:
    """Return rectangles in which names stand, the first of them placed first.

    Parameters
    ----------
    labels : sequence of PlanLabel
        The names.
    things : sequence of tuple of float
        Rectangles on which they rather do not stand [px].
    floor : tuple of float
        The rectangle that they should not leave [px].
    letters : float
        Size of the letters [px].
    """
    taken: list[Box] = []
    for label in labels:
        others = [thing for thing in things if thing != label.box]
        candidates = _candidates(label, letters)
        costs = [_cost(box, taken, others, floor) + FARTHER * place for place, box in enumerate(candidates)]
        taken.append(candidates[costs.index(min(costs))])
    return taken


def _candidates(label: PlanLabel, letters: float) -> list[Box]:
    """Return rectangles for a name: in the middle of what it names, then at its sides."""
    x0, y0, x1, y1 = label.box
    wide = WIDER * letters * max(_width(line) for line, _ in label.texts) + 4.0
    high = LINE * letters * len(label.texts)
    x, y = 0.5 * (x0 + x1), 0.5 * (y0 + y1)
    dx, dy, gap = 0.5 * wide, 0.5 * high, 3.0
    middles = [
        (x, y),
        *((x, end) for end in (y0 + dy, y1 - dy)),
        *((end, y) for end in (x1 + dx + gap, x0 - dx - gap, x0 + dx, x1 - dx)),
        *((x, end) for end in (y1 + dy + gap, y0 - dy - gap)),
        *((across, end) for across in (x1 + dx + gap, x0 - dx - gap) for end in (y0 + dy, y1 - dy)),
        *((across, end) for across in (x0 + dx, x1 - dx) for end in (y1 + dy + gap, y0 - dy - gap)),
    ]
    return [(a - dx, b - dy, a + dx, b + dy) for a, b in middles]


def _cost(box: Box, taken: Sequence[Box], others: Sequence[Box], floor: Box) -> float:
    area = (box[2] - box[0]) * (box[3] - box[1])
    on_names = sum(_shared(box, one) for one in taken)
    on_things = sum(_shared(box, one) for one in others)
    return (OTHER_NAME * on_names + OTHER_THING * on_things + OUTSIDE * (area - _shared(box, floor))) / area


def _shared(first: Box, second: Box) -> float:
    """Return the area that two rectangles share [px²]."""
    wide = min(first[2], second[2]) - max(first[0], second[0])
    high = min(first[3], second[3]) - max(first[1], second[1])
    return max(0.0, wide) * max(0.0, high)
