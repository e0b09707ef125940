"""The assumptions of verdicts, each with how well founded it is."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, NamedTuple

from stayput.catalogue import Phrase, phrase, say
from stayput.catalogue.names import CONTENTS, DOORS, DRAWERS, PIECES
from stayput.model.parameters import GIVEN, parameter_of
from stayput.report.names import named
from stayput.scenario.tables import floor_of
from stayput.verification.events import CELL, PASSAGE
from stayput.verification.options import building_tag, floor_tag, furniture_tag

if TYPE_CHECKING:
    from stayput.measures import Measure
    from stayput.model.room import Ceiling, Wall
    from stayput.scenario import Scenario
    from stayput.scenario.measures import UncertaintyTable
    from stayput.verification import Verdict

MODEL = "model"
"""Tag of a limit of the model, beside those of `stayput.measures.measure.GRADE_OF`."""


class Assumption(NamedTuple):
    """An assumption of a verdict.

    Parameters
    ----------
    what, value : tuple
        What it is and its value, in English and in Japanese.
    confidence : str
        "low", "medium", "high", "given" or "model".
    """

    what: Phrase
    value: Phrase
    confidence: str


def told(assumptions: Iterable[Assumption], language: str) -> list[tuple[str, str, str]]:
    """Return assumptions as rows of a table: what, its value, and how well founded it is."""
    return [(say(item.what, language), say(item.value, language), item.confidence) for item in assumptions]


def assumptions(verdict: Verdict) -> list[Assumption]:
    """Return the assumptions of a verdict, apart from the parameters of the measures; limits come last."""
    scenario = verdict.scenario
    in_room = scenario.plan is not None
    measures = [measure for result in verdict.options for measure in result.option.measures]
    several = () if scenario.alone else (_drawn_between, settlement_assumptions, _rolling)
    return [
        *([_furniture(scenario)] if scenario.alone else _pieces(scenario)),
        *_room(scenario, measures, gaps=not in_room),
        *_contents(scenario),
        *_shaking(scenario, verdict.motions),
        *([_direction(scenario.points)] if scenario.dimensions == 3 else ()),
        *_draws(scenario.uncertainty),
        *(each for of_several in several for each in of_several(scenario)),
        _limit("several.limit_body" if scenario.dimensions == 3 else "report.limit_body"),
        *(
            _limit(f"room_report.limit_{key}", passage=PASSAGE, cell=100.0 * CELL)
            for key in (*["persons"] * bool(scenario.places), "passage")
            if in_room
        ),
        *(_limit(f"report.limit_{key}") for key in ("contacts", "devices")),
    ]


def _limit(key: str, **values: object) -> Assumption:
    """Return what the model leaves out, by the key of its name; that of its text ends in "_text"."""
    return Assumption(phrase(key), phrase(f"{key}_text", **values), MODEL)


def _shaking(scenario: Scenario, count: int) -> Iterator[Assumption]:
    """Yield the motions, of which there are so many, how strong they are, and the building."""
    yield Assumption(_text("motions"), *motions_told(scenario, count))
    strength = scenario.shaking.strength
    if strength is not None and strength.measure != "JMA":  # whose intensity stands in the title
        tag = GIVEN if strength.scatter == 0.0 else "medium"
        yield Assumption(_text("strength"), strength.told(count), tag)
    if (table := scenario.shaking.building) is not None:
        name = _in_both(table.building().name)
        value = _text("building_text", name=name, storey=scenario.shaking.storey)
        yield Assumption(_text("building"), value, building_tag(table))


def _draws(uncertainty: UncertaintyTable) -> Iterator[Assumption]:
    """Yield what is drawn, and what is not since it was measured."""
    for name, marginal in uncertainty.quantities.marginals.items():
        if name not in uncertainty.as_stated:
            value = _text(type(marginal).__name__.lower(), **asdict(marginal))
            yield Assumption(_text(f"quantity_{name}"), value, marginal.confidence.value)
    for name in uncertainty.as_stated:
        yield Assumption(_text(f"quantity_{name}"), _text("as_stated"), GIVEN)


def _text(key: str, **values: object) -> Phrase:
    return phrase(f"report.{key}", **values)


def _in_both(name: str) -> Phrase:
    return named(name, "en"), named(name, "ja")


def _furniture(scenario: Scenario) -> Assumption:
    """Return the size, the mass and the centre of gravity of a scenario's piece."""
    table, body = scenario.piece, scenario.piece.body()
    x, z = body.centre_of_gravity
    forward = _text("forward", across=x) if x else ""
    length = "" if body.length is None else _text("length", length=body.length)
    sizes = {"width": body.width, "length": length, "height": body.height, "mass": body.mass}
    value = _text("piece_text", **sizes, up=z, forward=forward)
    return Assumption(_text("piece"), value, furniture_tag(table))


def _room(scenario: Scenario, measures: Sequence[Measure], *, gaps: bool) -> Iterator[Assumption]:
    """Yield the floor, the gaps to the walls, the ceiling, and what measures on these meet there."""
    room, table = scenario.surroundings(), scenario.room.floor
    floor = room.floor
    name = table if isinstance(table, str) else table.surface
    surface = "" if name is None else _text("surface", name=_in_both(name))
    value = _text("frictions", surface=surface, static=floor.static_friction, kinetic=floor.kinetic_friction)
    yield Assumption(_text("floor"), value, floor_tag(scenario))
    for key, wall in (
        ("wall", room.left_wall),
        ("front_wall", room.right_wall),
        ("near_side_wall", room.near_side_wall),
        ("far_side_wall", room.far_side_wall),
    ):
        if gaps and wall is not None:
            text = f"{'report' if scenario.alone else 'several'}.gap_text"
            yield Assumption(_text(key), phrase(text, gap=100.0 * wall.gap), GIVEN)
    if room.left_wall is not None and any(measure.drilled for measure in measures):
        yield _fixed_to("wall_fixing", room.left_wall)
    if room.ceiling is not None:
        yield Assumption(_text("ceiling"), _text("height_text", height=room.ceiling.height), GIVEN)
        if any(measure.needs == "ceiling" for measure in measures):
            yield _fixed_to("ceiling_fixing", room.ceiling)


def _fixed_to(key: str, surface: Wall | Ceiling) -> Assumption:
    """Return what devices meet in a wall or a ceiling; its default is taken, not known."""
    tag = parameter_of(type(surface), "construction").tag(surface.construction)
    return Assumption(_text(key), phrase(f"page.choice_{surface.construction}"), tag)


def _contents(scenario: Scenario) -> Iterator[Assumption]:
    contents = scenario.contents
    if contents is None:
        return
    static, kinetic = contents.friction
    front = ""
    if contents.doors != "none":
        front = _text("inside_doors", doors=DOORS[contents.doors])
    elif contents.drawers != "none":
        front = _text("inside_drawers", drawers=DRAWERS[contents.drawers])
    value = _text(
        "inside_text",
        kind=CONTENTS[contents.kind],
        shelves=contents.levels,
        mass=sum(contents.masses(scenario.piece.body())),
        static=static,
        kinetic=kinetic,
        lip=100.0 * contents.lip,
        front=front,
    )
    yield Assumption(_text("inside"), value, contents.tag)


def motions_told(scenario: Scenario, count: int) -> tuple[Phrase, str]:
    """Return what the motions are, of which there are so many, and how well founded that is."""
    shaking = scenario.shaking
    name = shaking.record or (shaking.suite if isinstance(shaking.suite, str) else None)
    if shaking.in_python is not None:
        name = shaking.in_python.name or shaking.in_python[0].name
    if name is not None:
        mean = phrase("motion.less_mean") if shaking.remove_mean else ""
        return _text("motions_read", count=count, name=name, mean=mean), GIVEN
    if shaking.of_a_suite:
        family = "mixed" if shaking.suite is None or isinstance(shaking.suite, str) else shaking.suite.family
        return _text("motions_synthetic", count=count, family=_in_both(family)), "low"
    name, tag = ("near-fault", "low") if shaking.sine is None else ("sine", GIVEN)
    return _text("motion_synthetic", name=_in_both(name)), tag


def _pieces(scenario: Scenario) -> Iterator[Assumption]:
    """Yield several pieces and the friction between them."""
    for piece in scenario.pieces:
        body = piece.body_in(scenario.folder)
        sizes = {name: getattr(body, name) for name in ("width", "length", "height", "mass")}
        size = phrase("several.piece_box", **sizes)
        called = PIECES.get(piece.title, (piece.title, piece.title))
        if piece.preset is None:
            yield Assumption(called, size, GIVEN)
        else:
            kind = PIECES[piece.preset]
            yield Assumption(called, (f"{kind[0]}: {size[0]}", f"{kind[1]}：{size[1]}"), "low")
    if len(scenario.pieces) > 1:
        friction = {"static": scenario.static_friction, "kinetic": scenario.kinetic_friction}
        tag = GIVEN if scenario.model_fields_set & {"static_friction", "kinetic_friction"} else "low"
        yield Assumption(phrase("several.between"), _text("frictions", surface="", **friction), tag)


def _drawn_between(scenario: Scenario) -> Iterator[Assumption]:
    """Yield how what is between several pieces is drawn."""
    if len(scenario.pieces) > 1:
        yield Assumption(phrase("several.drawn_between"), phrase("several.drawn_between_text"), "low")


def settlement_assumptions(scenario: Scenario) -> Iterator[Assumption]:
    """Yield for which pieces the sinking into a soft floor is left out, or less than it may be."""
    if floor_of(scenario.room.floor).settlement == 0.0:
        return
    pieces, limit = scenario.pieces, phrase("several.limit_settlement")
    if any(piece.on is None and not piece.is_furniture for piece in pieces):
        yield Assumption(limit, phrase("several.settlement_of_solids"), MODEL)
    if any(piece.on is not None for piece in pieces):
        yield Assumption(limit, phrase("several.settlement_of_stacks"), MODEL)


def _rolling(scenario: Scenario) -> Iterator[Assumption]:
    """Yield how round pieces roll, where there are any."""
    if any(len(piece.body_in(scenario.folder).solid.rims) for piece in scenario.pieces):
        yield _limit("several.rolling")


def _direction(radians: float | None) -> Assumption:
    what = phrase("room_report.direction")
    if radians is None:
        return Assumption(what, phrase("room_report.direction_drawn"), MODEL)
    return Assumption(what, phrase("room_report.direction_given", degrees=math.degrees(radians)), GIVEN)
