"""The assumptions of a verdict, each with how well founded it is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from stayput.catalogue import phrase, say
from stayput.catalogue.names import CONTENTS, DOORS, DRAWERS
from stayput.model.parameters import GIVEN, parameter_of
from stayput.report.names import named
from stayput.uncertainty import Lognormal, Normal, Uniform
from stayput.verification.grades import building_tag, floor_tag, furniture_tag

if TYPE_CHECKING:
    from collections.abc import Iterator

    from stayput.catalogue import Phrase
    from stayput.model.room import Ceiling, Floor, Wall
    from stayput.scenario import AssemblyScenario, Scenario
    from stayput.scenario.measures import UncertaintyTable
    from stayput.uncertainty import Marginal
    from stayput.verification import Verdict

MODEL = "model"
"""Tag of a limit of the model, beside those of `stayput.measures.measure.GRADE_OF`."""


@dataclass(frozen=True, slots=True)
class Assumption:
    """An assumption of a verdict.

    Parameters
    ----------
    texts : tuple
        What it is and its value, in English and in Japanese.
    confidence : str
        "low", "medium", "high", "given" or "model".
    """

    texts: tuple[Phrase, Phrase]
    confidence: str

    def what(self, language: str) -> str:
        """Return its label."""
        return say(self.texts[0], language)

    def value(self, language: str) -> str:
        """Return its value."""
        return say(self.texts[1], language)


LIMITS = ("body", "contacts", "devices")
"""What the model leaves out, by the keys of its texts."""


def assumptions(verdict: Verdict) -> list[Assumption]:
    """Return the assumptions of a verdict, apart from the parameters of the measures."""
    scenario = verdict.scenario
    return [
        furniture_assumption(scenario),
        *room_assumptions(scenario),
        *_contents(scenario),
        *shaking_assumptions(scenario, verdict.motions),
        *drawn_assumptions(scenario.uncertainty),
        *(Assumption((_text(f"limit_{key}"), _text(f"limit_{key}_text")), MODEL) for key in LIMITS),
    ]


def shaking_assumptions(scenario: Scenario | AssemblyScenario, count: int) -> Iterator[Assumption]:
    """Yield the motions, of which there are so many, how strong they are, and the building."""
    yield _motions(scenario, count)
    strength = scenario.shaking.strength
    if strength is not None and strength.measure != "JMA":  # whose intensity stands in the title
        tag = GIVEN if strength.scatter == 0.0 else "medium"
        yield Assumption((_text("strength"), strength.told(count)), tag)
    if scenario.shaking.building is not None:
        yield _building(scenario)


def drawn_assumptions(uncertainty: UncertaintyTable) -> Iterator[Assumption]:
    """Yield what is drawn, and what is not since it was measured."""
    for name, marginal in uncertainty.quantities.marginals.items():
        if name not in uncertainty.as_stated:
            yield _drawn(name, marginal)
    for name in uncertainty.as_stated:
        yield Assumption((_text(f"quantity_{name}"), _text("as_stated")), GIVEN)


def _text(key: str, **values: object) -> Phrase:
    return phrase(f"report.{key}", **values)


def _in_both(name: str) -> Phrase:
    return named(name, "en"), named(name, "ja")


def furniture_assumption(scenario: Scenario) -> Assumption:
    """Return the size, the mass and the centre of gravity of a scenario's piece."""
    table, body = scenario.furniture, scenario.furniture.body()
    x, z = body.centre_of_gravity
    forward = _text("forward", across=x) if x else ""
    value = _text("piece_text", width=body.width, height=body.height, mass=body.mass, up=z, forward=forward)
    return Assumption((_text("piece"), value), furniture_tag(table))


def room_assumptions(scenario: Scenario | AssemblyScenario) -> Iterator[Assumption]:
    """Yield the floor, the walls and the ceiling."""
    yield floor_assumption(scenario, scenario.room.room().floor)
    yield from _walls(scenario)


def floor_assumption(scenario: Scenario | AssemblyScenario, floor: Floor) -> Assumption:
    """Return the floor that a scenario's room has."""
    table = scenario.room.floor
    name = table if isinstance(table, str) else table.surface
    surface = "" if name is None else _text("surface", name=_in_both(name))
    value = _text("frictions", surface=surface, static=floor.static_friction, kinetic=floor.kinetic_friction)
    return Assumption((_text("floor"), value), floor_tag(scenario))


def _walls(scenario: Scenario | AssemblyScenario) -> Iterator[Assumption]:
    room = scenario.room.room()
    for key, wall in (
        ("wall", room.left_wall),
        ("front_wall", room.right_wall),
        ("near_side_wall", room.near_side_wall),
        ("far_side_wall", room.far_side_wall),
    ):
        if wall is not None:
            yield Assumption((_text(key), _text("gap_text", gap=100.0 * wall.gap)), GIVEN)
    if room.left_wall is not None:
        yield fixed_to("wall_fixing", room.left_wall)
    if room.ceiling is not None:
        yield from ceiling_assumptions(room.ceiling)


def ceiling_assumptions(ceiling: Ceiling) -> Iterator[Assumption]:
    """Yield the height of a ceiling, and what poles push against in it."""
    yield Assumption((_text("ceiling"), _text("height_text", height=ceiling.height)), GIVEN)
    yield fixed_to("ceiling_fixing", ceiling)


def fixed_to(key: str, surface: Wall | Ceiling) -> Assumption:
    """Return what devices meet in a wall or a ceiling; its default is taken, not known."""
    tag = parameter_of(type(surface), "construction").tag(surface.construction)
    return Assumption((_text(key), phrase(f"page.choice_{surface.construction}")), tag)


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
        mass=sum(contents.masses(scenario.furniture.body())),
        static=static,
        kinetic=kinetic,
        lip=100.0 * contents.lip,
        front=front,
    )
    yield Assumption((_text("inside"), value), contents.tag)


def _motions(scenario: Scenario | AssemblyScenario, count: int) -> Assumption:
    shaking = scenario.shaking
    heading = _text("motions")
    name = shaking.record or (shaking.suite if isinstance(shaking.suite, str) else None)
    if shaking.in_python is not None:
        name = shaking.in_python.name or shaking.in_python[0].name
    if name is not None:
        mean = phrase("motion.less_mean") if shaking.remove_mean else ""
        return Assumption((heading, _text("motions_read", count=count, name=name, mean=mean)), GIVEN)
    if shaking.of_a_suite:
        family = "mixed" if shaking.suite is None or isinstance(shaking.suite, str) else shaking.suite.family
        value = _text("motions_synthetic", count=count, family=_in_both(family))
        return Assumption((heading, value), "low")
    name = "sine" if shaking.sine is not None else "near-fault"
    value = _text("motion_synthetic", name=_in_both(name))
    return Assumption((heading, value), GIVEN if shaking.sine is not None else "low")


def _building(scenario: Scenario | AssemblyScenario) -> Assumption:
    table = scenario.shaking.building
    assert table is not None
    value = _text("building_text", name=_in_both(table.building().name), storey=scenario.shaking.storey)
    return Assumption((_text("building"), value), building_tag(table))


def _drawn(name: str, marginal: Marginal) -> Assumption:
    return Assumption((_text(f"quantity_{name}"), _distribution(marginal)), marginal.confidence.value)


def _distribution(marginal: Marginal) -> Phrase:
    """Return a distribution in words."""
    match marginal:
        case Lognormal():
            return _text("lognormal", median=marginal.median, cov=marginal.cov)
        case Normal():
            return _text("normal", mean=marginal.mean, deviation=marginal.deviation)
        case Uniform():
            return _text("uniform", low=marginal.low, high=marginal.high)
        case _:
            raise TypeError(type(marginal).__name__)
