"""The plan of a room as SVG: walls, openings, places of persons, pieces, and where the pieces come to lie."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from string import ascii_lowercase
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import Phrase, say
from stayput.catalogue.names import STABILITY
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.room import sheet as paper
from stayput.report.verdict import numbers, svg
from stayput.verification.events import CELL
from stayput.verification.room_words import door_name, people_in, piece_name, place_name

if TYPE_CHECKING:
    from stayput.fragility.probabilities import Probability
    from stayput.model.floor_plan import Door, FloorPlan
    from stayput.simulation.space_fate import Stability
    from stayput.verification.changes import Change
    from stayput.verification.verdict import OptionVerdict, Verdict


ENDS = ("stood", "fell")
"""How a piece ends on a spot, by the names of their shares."""

STEPS = 10
"""Steps of the share of the runs in which a piece ends on a spot."""


@dataclass(frozen=True, slots=True, eq=False)
class DrawnPiece:
    """A piece on a plan.

    Parameters
    ----------
    name : str
        What it is called.
    outline : ndarray, shape (n, 2)
        As it stands, counter-clockwise [m].
    heading : float
        Where its front faces [rad].
    stability : Stability, optional
        How firmly it stands, where the plan shows what happens.
    fell, stood : ndarray, shape (nx, ny), optional
        Shares of the runs in which it ends on each cell of the floor having overturned, and without.
    """

    name: str
    outline: NDArray[np.float64]
    heading: float
    stability: Stability | None = None
    fell: NDArray[np.float64] | None = None
    stood: NDArray[np.float64] | None = None


class DrawnPlan(NamedTuple):
    """A plan as SVG, and what the marks mean that stand on it in the place of names, if any."""

    svg: str
    legend: tuple[tuple[str, str], ...] = ()


def plan_svg(
    plan: FloorPlan,
    pieces: Sequence[DrawnPiece],
    kinds: Sequence[str],
    language: str,
    *,
    notes: Mapping[str, str] | None = None,
    moved: Iterable[tuple[NDArray[np.float64], NDArray[np.float64]]] = (),
    numbered: Mapping[str, str] | None = None,
    letters: float = paper.FONT,
) -> DrawnPlan:
    """Return the plan of a room, to scale and with y upwards; its style is canvas/plan.css.

    Where it has numbers and names would lie on one another, these numbers stand in their place, and letters
    for what has no number.

    Parameters
    ----------
    plan : FloorPlan
        Walls, doors, windows and places.
    pieces : sequence of DrawnPiece
        The pieces, those that stand on others after these.
    kinds : sequence of str
        The kind of each place, of `stayput.model.floor_plan.PLACES`.
    language : str
        "en" or "ja".
    notes : mapping of str, optional
        What is told of a piece, a place or a door, by its name.
    moved : iterable of tuple of ndarray
        Outlines before and after of what is moved [m].
    numbered : mapping of str, optional
        The number before the name of a piece or a place.
    letters : float
        Size of the letters of names [px].
    """
    sheet, noted, marks = paper.PlanSheet(plan), notes or {}, numbered or {}
    colon = say("common.colon", language)
    content, labels, keys, names = [paper.walls_svg(sheet)], list[paper.PlanLabel](), list[str](), list[str]()

    def titles(key: str, called: Phrase, aside: str = "") -> tuple[str, str]:
        """Return a name as it stands on the plan, and what a screen reader says of it."""
        name = say(called, language)
        name = f"{marks[key]} {name}" if key in marks else name
        return name, f"{name}{aside}{colon}{noted[key]}" if key in noted else f"{name}{aside}"

    def add(key: str, name: str, drawn: str, box: paper.Box, mark: str = "") -> None:
        content.append(drawn)
        labels.append(paper.PlanLabel(paper.wrapped(name), noted.get(key, ""), box))
        keys.append(mark)
        names.append(name)

    for place, kind in zip(plan.places, kinds, strict=True):
        name, title = titles(place.name, place_name(place))
        box = sheet.box_of(place.corners)
        add(place.name, name, paper.place_svg(sheet, place, kind, title), box, place.name)
    called = [titles(piece.name, piece_name(piece.name)) for piece in pieces]
    content += [
        paper.titled(title, covers_svg(sheet, covers, end))
        for end in ENDS
        for piece, (_, title) in zip(pieces, called, strict=True)
        if (covers := getattr(piece, end)) is not None
    ]
    for piece, (name, title) in zip(pieces, called, strict=True):
        box = sheet.box_of(piece.outline)
        add(piece.name, name, paper.titled(title, _piece_svg(sheet, piece)), box, piece.name)
    content += [paper.window_svg(sheet, window, language) for window in plan.windows]
    things = [label.box for label in labels]
    for door in plan.doors:
        opens = say("common.aside", language, content=say(f"room_report.{door.opens}", language))
        name, title = titles(door.name, door_name(door), opens)
        add(door.name, name, paper.door_svg(sheet, door, title), _before(sheet, door))
    boxes = paper.places_of_names(labels, things, sheet.floor, letters)
    legend: list[tuple[str, str]] = []
    if marks and paper.overlap(boxes):
        short = iter(ascii_lowercase)
        for i, (key, name) in enumerate(zip(keys, names, strict=True)):
            if (mark := marks.get(key) or next(short, None)) is not None:
                labels[i] = labels[i]._replace(lines=(mark,))
                legend += [] if key in marks else [(mark, name)]
        boxes = paper.places_of_names(labels, things, sheet.floor, letters)
    content += [_moved_svg(sheet, before, after) for before, after in moved]
    content += [paper.scale_svg(sheet, language), paper.names_svg(labels, boxes, letters)]
    listed = say("common.listed", language).join(names)
    alt = say("room_report.plan_alt", language, width=plan.width, length=plan.length, content=listed)
    return DrawnPlan(svg.drawing(*sheet.size, content, alt, "plan-room"), tuple(legend))


def _before(sheet: paper.PlanSheet, door: Door) -> paper.Box:
    """Return the floor before a door."""
    ends = (door.start, door.start + door.width)
    return sheet.box_of(
        [sheet.plan.on_wall(door.wall, along, into) for along in ends for into in (0.0, door.width)]
    )


def _piece_svg(sheet: paper.PlanSheet, piece: DrawnPiece) -> str:
    """Return the outline of a piece, and a line along a side that faces to the front and is most of it."""
    drawn = sheet.polygon(piece.outline, f"standing {piece.stability or 'unknown'}")
    x, y = math.cos(piece.heading), math.sin(piece.heading)
    across, inwards = float(np.ptp(piece.outline @ [-y, x])), 2.0 / sheet.scale * np.array([x, y])
    for start, end in zip(piece.outline, np.roll(piece.outline, -1, axis=0), strict=True):
        side = end - start
        length = float(np.hypot(*side))
        if length > 0.5 * across and side[1] * x - side[0] * y > 0.99 * length:
            drawn += sheet.polyline(np.array([start, end]) - inwards, "front")
    return drawn


def covers_svg(sheet: paper.PlanSheet, covers: NDArray[np.float64], end: str) -> str:
    """Return the cells on which a piece comes to one of `ENDS`, darker where it does so more often."""
    steps = np.ceil(STEPS * covers - 1e-9).astype(np.intp)
    return "".join(
        svg.element("path", d=_cells(sheet, steps == step), class_=f"cover {end} step{step}")
        for step in range(1, STEPS + 1)
        if (steps == step).any()
    )


def _cells(sheet: paper.PlanSheet, chosen: NDArray[np.bool_]) -> str:
    """Return the outline of cells of the floor: one rectangle for those that are side by side along x."""
    padded = np.pad(chosen, ((1, 1), (0, 0))).astype(np.int8)
    change = np.diff(padded, axis=0).T
    rows, starts = np.nonzero(change == 1)
    _, ends = np.nonzero(change == -1)
    parts: list[str] = []
    for row, start, end in zip(rows.tolist(), starts.tolist(), ends.tolist(), strict=True):
        x0, y1 = sheet.place(start * CELL, row * CELL)
        x1, y0 = sheet.place(min(end * CELL, sheet.plan.width), min((row + 1) * CELL, sheet.plan.length))
        parts.append(f"M{x0:.1f} {y0:.1f}H{x1:.1f}V{y1:.1f}H{x0:.1f}Z")
    return "".join(parts)


def _moved_svg(sheet: paper.PlanSheet, before: NDArray[np.float64], after: NDArray[np.float64]) -> str:
    """Return where something was moved from, and an arrow from there."""
    start, end = (np.array(sheet.place(*corners.mean(axis=0).tolist())) for corners in (before, after))
    away = end - start
    length = float(np.hypot(*away))
    parts = [sheet.polygon(before, "was")]
    if length > 1.0:
        along = away / length
        across = np.array([-along[1], along[0]])
        back = end - 10.0 * along
        head = [end, back + 5.0 * across, back - 5.0 * across]
        parts += [
            svg.polyline([start[0], back[0]], [start[1], back[1]], "move"),
            svg.polygon([(float(x), float(y)) for x, y in head], "head"),
        ]
    return "".join(parts)


def _swatch_svg(*looks: str) -> str:
    """Return boxes of looks beside each other, for a legend."""
    wide = 80 if looks[1:] else 12
    ends = np.linspace(0.0, wide, len(looks) + 1).tolist()
    boxes = "".join(
        svg.box(x0, 0.0, x1, 12.0, look) for look, (x0, x1) in zip(looks, pairwise(ends), strict=True)
    )
    return svg.element("svg", boxes, viewBox=f"0 0 {wide} 12", width=wide, height=12, aria_hidden="true")


def room_plan(verdict: Verdict, language: str) -> str:
    """Return the plan of the room with where its pieces come to lie, and who is hit how often."""

    def text(key: str, chance: Probability) -> str:
        return say(f"room_report.{key}", language, share=numbers.probability(chance, language))

    people, pieces = people_in(verdict), verdict.without.pieces
    notes = {piece.name: text("overturns", piece.probabilities[OVERTURNED]) for piece in pieces}
    notes |= {place.place.name: text("is_hit", place.hit) for place in people.places}
    already = say("rooms.already", language)
    notes |= {
        door.door.name: already if door.at_rest else text("is_blocked", door.blocked) for door in people.doors
    }
    kinds = [table.kind for table in verdict.scenario.places]
    return plan_svg(_plan(verdict), _pieces(verdict), kinds, language, notes=notes).svg


def legend(language: str) -> list[tuple[str, str]]:
    """Return what the colours of pieces and of cells mean."""
    steps = range(1, STEPS + 1)
    return [
        *((_swatch_svg(f"shown {step}"), say(name, language)) for step, name in STABILITY.items()),
        *(
            (_swatch_svg(*(f"cover {end} step{step}" for step in steps)), say(f"room_report.{end}", language))
            for end in ENDS
        ),
    ]


def change_plan(verdict: Verdict, language: str) -> tuple[str, str] | None:
    """Return a plan with the best option that helps and moves something, and what it is."""
    best = next((option for option in verdict.others if option.helps and option.option.moved), None)
    if best is None:
        return None
    moves = [change for change in verdict.changes(best) if change.at is not None]
    return numbered_plan(verdict, moves, language, option=best).svg, verdict.label(best, language)


def numbered_plan(
    verdict: Verdict,
    moves: Iterable[Change],
    language: str,
    numbered: Mapping[str, str] | None = None,
    letters: float = paper.FONT,
    option: OptionVerdict | None = None,
) -> DrawnPlan:
    """Return a plan of the room with some things moved, and numbers before names or in their place.

    Parameters
    ----------
    verdict : Verdict
        The room.
    moves : iterable of Change
        What is moved.
    language : str
        "en" or "ja".
    numbered : mapping of str, optional
        The number of a piece or a place.
    letters : float
        Size of the letters of names [px].
    option : OptionVerdict, optional
        What becomes of the pieces then, for their colours; they have none by default.
    """
    stands = [None if option is None else each.stability for each in (option or verdict.without).pieces]
    pieces = [
        replace(piece, stability=each, fell=None, stood=None)
        for piece, each in zip(_pieces(verdict), stands, strict=True)
    ]
    plan, names = _plan(verdict), verdict.scenario.names
    moved: list[tuple[NDArray[np.float64], NDArray[np.float64]]] = []
    for change in moves:
        assert change.at is not None
        assert change.heading is not None
        if change.what in names:
            body = names.index(change.what)
            before = pieces[body]
            at, angle = verdict.scenario.scene().pieces[body].at[:2], change.heading - before.heading
            cos, sin = math.cos(angle), math.sin(angle)
            turned = (before.outline - np.asarray(at)) @ np.array([[cos, sin], [-sin, cos]])
            pieces[body] = replace(before, outline=turned + np.asarray(change.at), heading=change.heading)
            moved.append((before.outline, pieces[body].outline))
        else:
            number = [place.name for place in plan.places].index(change.what)
            place = plan.places[number]
            other = replace(place, at=change.at, heading=change.heading)
            moved.append((place.corners, other.corners))
            plan = plan.with_places({number: other})
    kinds = [table.kind for table in verdict.scenario.places]
    return plan_svg(plan, pieces, kinds, language, moved=moved, numbered=numbered, letters=letters)


def _pieces(verdict: Verdict) -> list[DrawnPiece]:
    """Return the pieces in the order of the file, in which what stands on another comes after it."""
    standing, pieces = verdict.scenario.scene(verdict.without.option).pieces, verdict.without.pieces
    return [
        DrawnPiece(result.name, zones.outline, piece.heading, result.stability, zones.fell, zones.stood)
        for result, piece in zip(pieces, standing, strict=True)
        if (zones := result.zones) is not None
    ]


def _plan(verdict: Verdict) -> FloorPlan:
    plan = verdict.scenario.scene(verdict.without.option).plan
    assert plan is not None
    return plan
