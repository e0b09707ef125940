"""Charts of the verdict on a room: its plan with where pieces come to lie, who is hit, what helps."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import Polygon

from stayput.catalogue import say
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.charts.chances import draw_shares
from stayput.report.charts.chart import Chart
from stayput.report.figures import FONT, style
from stayput.report.fonts import drawable
from stayput.report.palette import INK, MUTED, ROOM
from stayput.report.space.scene import body_colour
from stayput.report.space.still import STILL_LOOKS, still_shapes
from stayput.report.verdict import numbers
from stayput.rooms.ways import CELL
from stayput.rooms.words import change_label, door_name, piece_name, place_name

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from stayput.fragility import Difference, Probability
    from stayput.report.charts.chart import ChartSource
    from stayput.rooms.verdict import HitVerdict, RoomVerdict

_FELL, _STOOD = 0.75, 0.35
"""How opaque cells are on which a piece always lies, and always stands."""

_AROUND = 0.1
"""What is shown beyond the walls [m]."""

_WIDTH = 8.4
"""Width of a chart [in]."""


def plan_chart(verdict: RoomVerdict, source: ChartSource) -> Chart:
    """Return the plan of a room with the shares of the runs in which its pieces end on each cell."""
    language, plan = source.language, verdict.plan
    columns: dict[str, list[object]] = {"piece": [], "x_m": [], "y_m": [], "fell": [], "stood": []}
    for piece in verdict.pieces:
        for i, j in np.argwhere(piece.covers > 0.0).tolist():
            values = (
                piece.name,
                (i + 0.5) * CELL,
                (j + 0.5) * CELL,
                float(piece.fell[i, j]),
                float(piece.stood[i, j]),
            )
            for column, value in zip(columns.values(), values, strict=True):
                column.append(value)

    def draw(figure: Figure) -> None:
        axis: Axes = figure.subplots()
        style(axis, zero=False)
        _draw_zones(axis, verdict)
        for still in still_shapes(plan):
            for line in still.lines:
                axis.plot(*line[:, :2].T, color=STILL_LOOKS[still.role].colour, linewidth=1.0)
        for name, middle, key, chance in _notes(verdict, language):
            share = say(f"room_report.{key}", language, share=numbers.probability(chance, language))
            axis.annotate(
                drawable(f"{name}\n{share}"),
                middle,
                ha="center",
                va="center",
                fontsize=FONT - 2.0,
                color=INK,
                bbox={"boxstyle": "round,pad=0.15", "facecolor": "white", "alpha": 0.65, "linewidth": 0.0},
            )
        corners = [(0.0, 0.0), (plan.width, 0.0), (plan.width, plan.length), (0.0, plan.length)]
        axis.add_patch(Polygon(corners, fill=False, edgecolor=ROOM, linewidth=3.0))
        axis.set_aspect("equal")
        axis.set_xlim(-_AROUND, plan.width + _AROUND)
        axis.set_ylim(-_AROUND, plan.length + _AROUND)
        axis.set_xlabel(drawable(say("figures.axis_from_left", language)), fontsize=FONT)
        axis.set_ylabel(drawable(say("figures.axis_from_near", language)), fontsize=FONT)

    height = min(9.0, max(4.0, 0.85 * _WIDTH * plan.length / plan.width))
    caption = _caption(verdict, language, "room_plan_note")
    return Chart(say("figures.room_plan", language), caption, source, columns, draw, (_WIDTH, height))


def _draw_zones(axis: Axes, verdict: RoomVerdict) -> None:
    """Shade the cells on which each piece lies or stands, and outline it as it is placed."""
    look = {name: body_colour(number) for number, name in enumerate(verdict.scenario.names)}
    for piece in verdict.pieces:
        red, green, blue = (int(look[piece.name][i : i + 2], 16) / 255.0 for i in (1, 3, 5))
        shades = np.zeros((*piece.covers.shape[::-1], 4))
        shades[...] = (red, green, blue, 0.0)
        shades[..., 3] = _FELL * piece.fell.T + _STOOD * piece.stood.T
        nx, ny = piece.covers.shape
        axis.imshow(shades, origin="lower", extent=(0.0, nx * CELL, 0.0, ny * CELL), interpolation="nearest")
        axis.add_patch(
            Polygon(piece.outline, facecolor=look[piece.name], alpha=0.3, edgecolor=INK, linewidth=1.2)
        )
        axis.add_patch(Polygon(piece.outline, fill=False, edgecolor=INK, linewidth=1.2))


def _notes(verdict: RoomVerdict, language: str) -> list[tuple[str, tuple[float, float], str, Probability]]:
    """Return what each thing of the plan is called, where it is, what may happen to it, and how likely."""
    found: list[tuple[str, tuple[float, float], str, Probability]] = []
    for piece in verdict.pieces:
        x, y = piece.outline.mean(axis=0).tolist()
        found.append(
            (say(piece_name(piece.name), language), (x, y), "overturns", piece.probabilities[OVERTURNED])
        )
    found += [
        (say(place_name(one.place), language), one.place.at, "is_hit", one.hit) for one in verdict.places
    ]
    for one in verdict.doors:
        door = one.door
        middle = verdict.plan.on_wall(door.wall, door.start + 0.5 * door.width, 0.3 * door.width)
        found.append((say(door_name(door), language), middle, "is_blocked", one.blocked))
    return found


def hits_chart(verdict: RoomVerdict, source: ChartSource) -> Chart:
    """Return how likely it is that somebody is hit at each place, by any piece and by each."""
    language = source.language
    rows: list[tuple[str, HitVerdict | None, Probability]] = []
    for place in verdict.places:
        rows.append((place.place.name, None, place.hit))
        rows += [(place.place.name, one, one.probability) for one in place.by]
    called = {place.place.name: say(place_name(place.place), language) for place in verdict.places}
    labels = [
        called[name] if hit is None else f"{called[name]} – {say(piece_name(hit.piece), language)}"
        for name, hit, _ in rows
    ]
    hits = [hit for _, hit, _ in rows]
    columns: dict[str, Sequence[object]] = {
        "place": [name for name, _, _ in rows],
        "piece": [None if hit is None else hit.piece for hit in hits],
        **share_columns("hit", [chance for *_, chance in rows]),
        "runs": [chance.runs for *_, chance in rows],
        "mass_kg": [None if hit is None else hit.mass for hit in hits],
        "median_speed_m_s": [None if hit is None else hit.speed.median for hit in hits],
        "median_energy_J": [None if hit is None else hit.energy.median for hit in hits],
    }
    return _bars("room_hits", verdict, source, labels, [chance for *_, chance in rows], columns, "hit")


def changes_chart(verdict: RoomVerdict, source: ChartSource) -> Chart:
    """Return how likely the worst that happens in the room is with each single change, the best first."""
    language, changes = source.language, verdict.changes
    own = [None, *(verdict.piece_changed(one) for one in changes)]
    columns: dict[str, Sequence[object]] = {
        "change": [
            say("figures.room_as_is", language),
            *(change_label(one.change, verdict, language) for one in changes),
        ],
        **share_columns("hit", [verdict.hit, *(one.hit for one in changes)]),
        **share_columns("hit_change", [None, *(one.hit_change for one in changes)]),
        **share_columns("shut_in", [verdict.shut_in, *(one.shut_in for one in changes)]),
        **share_columns("shut_in_change", [None, *(one.shut_in_change for one in changes)]),
        **share_columns("overturned", [None if pair is None else pair[0] for pair in own]),
        **share_columns("overturned_change", [None if pair is None else pair[1] for pair in own]),
        "helps": [None, *(one.helps for one in changes)],
    }
    event, bars = _compared(verdict, language)
    labels, chances = [label for label, _ in bars], [chance for _, chance in bars]
    return _bars("room_changes", verdict, source, labels, chances, columns, event)


def _compared(verdict: RoomVerdict, language: str) -> tuple[str, list[tuple[str, Probability]]]:
    """Return the worst that happens in a room, and how likely it is as the room is and with each change.

    Where nobody is hit or shut in it is that the piece of a change overturns.
    """
    labels = [change_label(one.change, verdict, language) for one in verdict.changes]
    own = [verdict.piece_changed(one) for one in verdict.changes]
    overturned = [(label, pair[0]) for label, pair in zip(labels, own, strict=True) if pair is not None]
    as_is = say("figures.room_as_is", language)
    if verdict.hit.estimate > 0.0 or not (verdict.shut_in.estimate > 0.0 or overturned):
        chances = (one.hit for one in verdict.changes)
        return "hit", [(as_is, verdict.hit), *zip(labels, chances, strict=True)]
    if verdict.shut_in.estimate > 0.0:
        chances = (one.shut_in for one in verdict.changes)
        return "shut_in", [(as_is, verdict.shut_in), *zip(labels, chances, strict=True)]
    changed = {one.change.what for one in verdict.changes}
    pieces = [
        (
            say("figures.piece_as_is", language, piece=piece_name(piece.name)),
            piece.probabilities[OVERTURNED],
        )
        for piece in verdict.pieces
        if piece.name in changed
    ]
    return OVERTURNED, [*pieces, *overturned]


def share_columns(
    name: str, shares: Sequence[Probability | Difference | None]
) -> dict[str, Sequence[object]]:
    """Return probabilities, or changes of them, with their intervals as columns of a table."""
    return {
        f"{name}{end}": [None if one is None else float(getattr(one, key)) for one in shares]
        for end, key in (("", "estimate"), ("_low", "low"), ("_high", "high"))
    }


def _bars(
    name: str,
    verdict: RoomVerdict,
    source: ChartSource,
    labels: Sequence[str],
    chances: Sequence[Probability],
    columns: dict[str, Sequence[object]],
    event: str,
) -> Chart:
    language = source.language

    def draw(figure: Figure) -> None:
        axis: Axes = figure.subplots()
        draw_shares(axis, labels, chances, language)
        axis.set_xlabel(drawable(say(f"figures.axis_{event}", language)), fontsize=FONT, color=MUTED)

    size = (_WIDTH, 1.2 + 0.42 * len(labels))
    caption = _caption(verdict, language, f"{name}_{event}_note")
    return Chart(say(f"figures.{name}", language), caption, source, columns, draw, size)


def _caption(verdict: RoomVerdict, language: str, note: str) -> str:
    return verdict.sentence(language) + say("page.space", language) + say(f"figures.{note}", language)
