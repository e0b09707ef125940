"""A plan to buy and do as one HTML page that prints on one sheet of A4 for up to five pieces."""

from __future__ import annotations

import re
from importlib import resources
from typing import TYPE_CHECKING, Any, NamedTuple

from markupsafe import Markup

import stayput
from stayput.catalogue import phrase, say
from stayput.measures.parameters import MEANINGS
from stayput.report.action_plan.elevation import elevation_svg
from stayput.report.embedding import inks_css
from stayput.report.room.drawing import plan_with
from stayput.report.room.sheet import PlanSheet
from stayput.report.verdict.html import rendered, write_page
from stayput.rooms.forces import MARGIN, QUANTILE
from stayput.rooms.step_words import (
    cautions,
    checks,
    effects,
    heading,
    joined,
    to_buy,
    where,
    with_ends,
)
from stayput.rooms.steps import COST_BOUNDS
from stayput.rooms.words import piece_name
from stayput.uncertainty import USUAL, Lognormal
from stayput.verification.words import class_phrase, share_text

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from pathlib import Path

    from stayput.catalogue import Phrase
    from stayput.rooms.steps import ActionPlan, PlanStep
    from stayput.rooms.verdict import RoomEffect

PLAN_SCALES = (25, 40, 50, 75, 100, 150, 200, 300, 500, 1000)
"""Scales that a plan is drawn to: metres of the room in a metre of paper."""

PLAN_SPACE = (0.082, 0.060)
"""Most that the plan takes up on paper, wide and high [m]."""

ELEVATION_SCALES = (75, 100)
"""Scales of the elevations: of few pieces, and of more than `FEW`."""

FEW = 3
"""Most pieces that fit on one sheet with the larger elevations."""


class CardRow(NamedTuple):
    """A step as it is read.

    Parameters
    ----------
    number : int
        Its place in the order.
    heading : str
        What to do.
    cost : str
        Its cost class.
    level : int
        The same as a number.
    grade : str
        How well its inputs are known.
    known : tuple of str
        What the grade means, and which inputs are the weakest, for the screen; on paper see `listed_once`.
    drawing : Markup
        The piece with its devices; empty where something is moved.
    lines : tuple of (str, str)
        What to buy, where it goes and so on, each with its heading.
    """

    number: int
    heading: str
    cost: str
    level: int
    grade: str
    known: tuple[str, ...]
    drawing: Markup
    lines: tuple[tuple[str, str], ...]


SHEETS = ("canvas/plan.css", "room/plan.css", "action_plan/card.css")
"""Style sheets of the card: the look of plans, of their figures, and its own."""


def write_plan(plan: ActionPlan, path: str | Path, language: str = "en") -> Path:
    """Write a plan: one HTML file that loads nothing from elsewhere, to print.

    Raises
    ------
    InputError
        Another language, or a path that cannot be written.
    """
    return write_page(path, language, lambda: plan_html(plan, language))


def plan_html(plan: ActionPlan, language: str = "en") -> str:
    """Return the page of a plan, in "en" or "ja"."""
    return rendered("action_plan/card.html", _content(plan, language))


def _content(plan: ActionPlan, language: str) -> dict[str, Any]:
    def own(key: str, **values: object) -> str:
        return say(f"action_plan.{key}", language, **values)

    verdict = plan.verdict
    drawing, scale = _plan(plan, language)
    return {
        "language": language,
        "own": own,
        "version": stayput.__version__,
        "title": verdict.scenario.title or own("title"),
        "sentences": [say(told, language) for told in _sentences(plan)],
        "rough": any(step.grade == max(MEANINGS) for step in plan.steps),
        "plan": drawing,
        "scale": own("scale", plan=scale, elevation=_elevation_scale(plan)),
        "rows": [_row(number, step, plan, language) for number, step in enumerate(plan.steps, 1)],
        "checks": listed_once(plan, _checks, language),
        "weakest": listed_once(plan, lambda step: [joined(one.label for one in step.weakest)], language),
        "notes": [say(note, language) for note in _notes(plan)],
        "style": Markup(inks_css() + "".join(map(_file, SHEETS))),
    }


def _sentences(plan: ActionPlan) -> Iterator[Phrase]:
    """Yield how it is, how it would be, and what was asked for."""
    verdict, together = plan.verdict, plan.together
    strength = class_phrase(verdict.intensity)
    if together is None:
        if not plan.unsolved:
            yield phrase("action_plan.nothing")
    else:
        changes = together.hit_change, together.shut_in_change, together.blocked_change
        before = [
            (key, share_text(chance.estimate - change.estimate))
            for (key, chance), change in zip(_chances(together).items(), changes, strict=True)
        ]
        told = _told(plan, together)
        now = joined(phrase(f"action_plan.chance_{key}", share=share) for key, share in before if key in told)
        yield phrase("action_plan.now", strength=strength, chances=now)
        then = joined(
            phrase(f"action_plan.chance_{key}", share=with_ends(chance))
            for key, chance in _chances(together).items()
            if key in told
        )
        key = "action_plan.then_one" if len(plan.steps) == 1 else "action_plan.then"
        yield phrase(key, last=len(plan.steps), chances=then)
    if plan.unsolved:
        pieces = joined(piece_name(name) for name in plan.unsolved)
        yield phrase("action_plan.unsolved", pieces=pieces)
    asked = [name for name in plan.home.__dataclass_fields__ if getattr(plan.home, name)]
    if asked:
        conditions = joined(phrase(f"action_plan.{name}") for name in asked)
        yield phrase("action_plan.home", conditions=conditions)


def _chances(effect: RoomEffect) -> dict[str, Any]:
    return {"hit": effect.hit, "shut_in": effect.shut_in, "blocked": effect.blocked}


def _told(plan: ActionPlan, effect: RoomEffect) -> set[str]:
    """Return what is worth telling: hits where there are people, ways out where they are ever closed."""
    changes = effect.hit_change, effect.shut_in_change, effect.blocked_change
    happens = {
        key
        for (key, chance), change in zip(_chances(effect).items(), changes, strict=True)
        if chance.estimate != 0.0 or change.estimate != 0.0
    }
    return happens | ({"hit"} if plan.verdict.places else set())


def _plan(plan: ActionPlan, language: str) -> tuple[Markup, int]:
    """Return the room with the steps' numbers, to a round scale on paper, and that scale."""
    numbers: dict[str, str] = {}
    for number, step in enumerate(plan.steps, 1):
        numbers[step.what] = f"{numbers[step.what]}+{number}" if step.what in numbers else f"{number}"
    move = next((step.move for step in plan.steps if step.move is not None), None)
    drawing = plan_with(plan.verdict, move, language, numbers)
    sheet = PlanSheet(plan.verdict.plan)
    metres = [size / sheet.scale for size in sheet.size]
    scale = next(
        (
            one
            for one in PLAN_SCALES
            if all(size / one <= space for size, space in zip(metres, PLAN_SPACE, strict=True))
        ),
        PLAN_SCALES[-1],
    )
    wide = f"{1e3 * metres[0] / scale:.1f}mm"
    return Markup(re.sub("<svg ", f'<svg style="width:{wide}" ', drawing, count=1)), scale


def _elevation_scale(plan: ActionPlan) -> int:
    return ELEVATION_SCALES[sum(step.fix is not None for step in plan.steps) > FEW]


def listed_once(
    plan: ActionPlan, of: Callable[[PlanStep], Iterable[Phrase]], language: str
) -> list[tuple[str, str]]:
    """Return what is said of steps, each sentence once, with the numbers of the steps before it."""
    found: dict[str, list[int]] = {}
    for number, step in enumerate(plan.steps, 1):
        for told in of(step):
            found.setdefault(say(told, language), []).append(number)
    return [(", ".join(map(str, numbers)), told) for told, numbers in found.items()]


def _checks(step: PlanStep) -> Iterator[Phrase]:
    """Yield what to look at before a step."""
    if step.fix is not None:
        yield from checks(step.fix)
        if step.instead is not None:
            yield from checks(step.instead)
    elif step.overturned is not None:
        yield phrase("action_plan.check_move")
    else:
        yield phrase("action_plan.check_move_place")


def _row(number: int, step: PlanStep, plan: ActionPlan, language: str) -> CardRow:
    def own(key: str, **values: object) -> str:
        return say(f"action_plan.{key}", language, **values)

    meaning = say(MEANINGS[step.grade], language)
    inputs = joined(one.label for one in step.weakest)
    return CardRow(
        number,
        say(heading(step, plan), language),
        own("free") if step.fix is None else own("cost", level=step.cost_class),
        step.cost_class,
        step.grade.value,
        (own("grade", grade=step.grade.value, meaning=meaning), own("weakest", inputs=inputs)),
        Markup("")
        if step.fix is None
        else Markup(elevation_svg(step.fix, step.what, _elevation_scale(plan), language)),
        tuple((own(key), say(told, language)) for key, told in _lines(step, plan)),
    )


def _lines(step: PlanStep, plan: ActionPlan) -> Iterator[tuple[str, Phrase]]:
    """Yield what is said of a step, with the keys of its headings."""
    fix = step.fix
    if fix is not None:
        yield "buy", joined(to_buy(one, fix) for one in fix.purchases)
        yield "where", joined((where(one, fix) for one in fix.purchases), "action_plan.next")
    told: list[Phrase] = []
    if fix is not None and step.overturned is not None:
        was = share_text(step.overturned.estimate)
        told.append(phrase("action_plan.overturns", was=was, now=with_ends(fix.overturns)))
    alone = "action_plan.alone" if step.alone.helps else "action_plan.alone_unclear"
    told.append(phrase(alone, chance=effects(step.alone, plan)))
    if step is not plan.steps[0]:
        told.append(phrase("action_plan.with_others", chance=effects(step.together, plan)))
    yield "effect", joined(told, "action_plan.next")
    warned = [] if fix is None else list(cautions(fix))
    if warned:
        yield "caution", joined(warned, "action_plan.next")
    if step.instead is not None:
        other = step.instead
        parts = [joined(to_buy(one, other) for one in other.purchases)]
        if step.overturned is not None:
            was = share_text(step.overturned.estimate)
            parts.append(phrase("action_plan.overturns", was=was, now=with_ends(other.overturns)))
        parts += list(cautions(other))
        yield "instead", joined(parts, "action_plan.next")


def _notes(plan: ActionPlan) -> Iterator[Phrase]:
    """Yield how marks, strengths, costs and shares are to be read."""
    grades = joined(
        phrase("action_plan.grade", grade=grade.value, meaning=meaning) for grade, meaning in MEANINGS.items()
    )
    verdict = plan.verdict
    runs = verdict.motions * verdict.samples
    yield phrase("action_plan.grades", meanings=grades)
    scatter = USUAL["strength"]
    assert isinstance(scatter, Lognormal)
    yield phrase("action_plan.strengths", share=100.0 * QUANTILE, runs=runs, margin=MARGIN, cov=scatter.cov)
    (low, low_euro), (high, high_euro) = COST_BOUNDS
    yield phrase("action_plan.costs", low=low, low_euro=low_euro, high=high, high_euro=high_euro)
    yield phrase(
        "action_plan.runs", runs=runs, motions=verdict.motions, seed=verdict.seed, version=stayput.__version__
    )
    if not all(step.alone.helps for step in plan.steps):
        yield phrase("action_plan.unclear")
    yield phrase("action_plan.limits")


def _file(name: str) -> str:
    return resources.files("stayput.report").joinpath(name).read_text(encoding="utf-8")
