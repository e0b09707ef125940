"""A plan to buy and do as one HTML page that prints on one sheet for up to four pieces."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, NamedTuple

from markupsafe import Markup

import stayput
from stayput.catalogue import phrase, say
from stayput.measures.measure import MEANINGS
from stayput.report.action_plan.elevation import elevation_svg
from stayput.report.action_plan.paper import elevation_scale, is_dense, plan_scale, sizes_of
from stayput.report.page import framed, rendered, write_page
from stayput.report.room.drawing import numbered_plan
from stayput.report.room.sheet import PlanSheet
from stayput.rooms.forces import MARGIN, QUANTILE
from stayput.rooms.step_words import (
    chances_after,
    changes_nothing,
    checks,
    effects,
    falls,
    heading,
    joined,
    to_buy,
    too_weak,
    what_it_brings,
    where,
    with_ends,
)
from stayput.rooms.steps import COST_BOUNDS
from stayput.rooms.words import motion_phrase, piece_name, piece_within
from stayput.uncertainty import USUAL, Lognormal
from stayput.verification.words import shaking_phrase, share_text

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from pathlib import Path

    from stayput.catalogue import Phrase
    from stayput.fragility import Probability
    from stayput.report.action_plan.paper import CardSizes
    from stayput.rooms.steps import ActionPlan, Fix, PlanStep
    from stayput.rooms.verdict import RoomEffect

PLAN_LETTERS = 17.0
"""Size of the names on the plan [px]; that in card.css."""


class CardBlock(NamedTuple):
    """What is said of a move or of measures as it is read.

    Parameters
    ----------
    warning : tuple of (str, str) or None
        That it is not strong enough, and up to what it is.
    lines : tuple of (str, str)
        What to buy, what it brings and so on, each with its heading.
    """

    warning: tuple[str, str] | None
    lines: tuple[tuple[str, str], ...]


class CardRow(NamedTuple):
    """A step as it is read.

    Parameters
    ----------
    number : int
        Its place in the order.
    heading : str
        What to do.
    decided : str
        That it had been decided on before the plan was made; empty if it had not.
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
    done : CardBlock
        What to buy, where it goes and so on.
    other : tuple of (str, CardBlock) or None
        The other way as to drilling, with its heading: without it, or with it where it is not allowed.
    """

    number: int
    heading: str
    decided: str
    cost: str
    level: int
    grade: str
    known: tuple[str, ...]
    drawing: Markup
    done: CardBlock
    other: tuple[str, CardBlock] | None


class CardDeadEnd(NamedTuple):
    """What else can be done where the steps are not enough.

    Parameters
    ----------
    heading : str
        For which pieces.
    sentences : tuple of str
        What can be done.
    drilled : tuple of (str, CardBlock)
        What could be done with drilling on a piece that has no step, with its name.
    """

    heading: str
    sentences: tuple[str, ...]
    drilled: tuple[tuple[str, CardBlock], ...]


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
    title, named = say("action_plan.title", language), plan.verdict.scenario.title
    sizes = sizes_of(plan)
    drawn = [step.fix for step in plan.steps if step.fix is not None]
    elevations = elevation_scale(drawn, sizes)
    drawing, scale, legend = _plan(plan, sizes, language)
    return {
        **framed(language, "action_plan", f"{title} – {named}" if named else title, SHEETS),
        "name": named,
        "sentences": [say(told, language) for told in _sentences(plan)],
        "letters": sizes.letters,
        "dense": is_dense(sizes),
        "plan": drawing,
        "legend": legend,
        "scale": say(
            f"action_plan.scale{'' if drawn else '_alone'}", language, plan=scale, elevation=elevations
        ),
        "rows": [_row(number, plan, elevations, language) for number in range(1, len(plan.steps) + 1)],
        "dead_end": _dead_end(plan, language),
        "checks": _checks(plan, language),
        "rough": any(map(_is_rough, plan.steps)),
        "weakest": listed_once(plan, lambda step: [joined(one.label for one in step.weakest)], language),
        "notes": [say(note, language) for note in _notes(plan)],
    }


def _is_rough(step: PlanStep) -> bool:
    return step.grade == max(MEANINGS)


def _told(plan: ActionPlan, together: RoomEffect) -> dict[str, tuple[Probability, float]]:
    """Return the chances after all steps and before that are worth telling; none in a room without places."""
    return {
        key: (chance, was)
        for key, (chance, was) in chances_after(together).items()
        if (key == "hit" and plan.verdict.places) or was != 0.0 or chance.estimate != 0.0
    }


def _sentences(plan: ActionPlan) -> Iterator[Phrase]:
    """Yield how it is, how it would be, and what was asked for."""
    verdict, together, falling = plan.verdict, plan.together, falls(plan)
    strength = shaking_phrase(verdict)
    if together is None and falling is None and not plan.unsolved:
        yield phrase("action_plan.nothing")
    told = {} if together is None else _told(plan, together)
    if told:
        now = joined(
            phrase(f"action_plan.chance_{key}", share=share_text(was)) for key, (_, was) in told.items()
        )
        only = motion_phrase(verdict)
        key = "action_plan.now" if only is None else "action_plan.now_of_one"
        yield phrase(key, strength=strength, motion=only or "", chances=now)
        then = joined(
            phrase(f"action_plan.chance_{key}", share=with_ends(chance)) for key, (chance, _) in told.items()
        )
        key = "action_plan.then_one" if len(plan.steps) == 1 else "action_plan.then"
        yield phrase(key, last=len(plan.steps), chances=then)
    if falling is not None:
        yield phrase("action_plan.falls", pieces=falling)
    in_place = [
        phrase("rooms.fix", measure=measure.label, piece=piece_within(name))
        for name, measures in zip(verdict.scenario.names, verdict.scenario.stated.measures, strict=True)
        for measure in measures
    ]
    if in_place:
        yield phrase("action_plan.in_place", measures=joined(in_place))
    if plan.unsolved:
        pieces = joined(piece_name(name) for name in plan.unsolved)
        yield phrase("action_plan.unsolved", pieces=pieces)
    asked = [name for name in plan.home.__dataclass_fields__ if getattr(plan.home, name)]
    if asked:
        conditions = joined(phrase(f"action_plan.{name}") for name in asked)
        yield phrase("action_plan.home", conditions=conditions)


def _plan(
    plan: ActionPlan, sizes: CardSizes, language: str
) -> tuple[Markup, int, tuple[tuple[str, str], ...]]:
    """Return the room with the steps' numbers to a round scale on paper, that scale, and what marks mean."""
    numbers: dict[str, str] = {}
    for number, step in enumerate(plan.steps, 1):
        numbers[step.what] = f"{numbers[step.what]}+{number}" if step.what in numbers else f"{number}"
    moves = [step.move for step in plan.steps if step.move is not None]
    drawing = numbered_plan(plan.verdict, moves, language, numbers, PLAN_LETTERS)
    sheet = PlanSheet(plan.verdict.plan)
    metres = [size / sheet.scale for size in sheet.size]
    scale = plan_scale(metres, sizes)
    wide = f"{1e3 * metres[0] / scale:.1f}mm"
    return Markup(re.sub("<svg ", f'<svg style="width:{wide}" ', drawing.svg, count=1)), scale, drawing.legend


def listed_once(
    plan: ActionPlan, of: Callable[[PlanStep], Iterable[Phrase]], language: str
) -> list[tuple[str, str]]:
    """Return what is said of steps, each sentence once, with the numbers of the steps before it."""
    found: dict[str, list[int]] = {}
    for number, step in enumerate(plan.steps, 1):
        for told in of(step):
            found.setdefault(say(told, language), []).append(number)
    return [(", ".join(map(str, numbers)), told) for told, numbers in found.items()]


def _checks(plan: ActionPlan, language: str) -> list[tuple[str, str]]:
    """Return what to look at before which steps, or before which of their variants without drilling."""
    found: dict[tuple[bool, tuple[Phrase, ...]], list[str]] = {}
    for number, step in enumerate(plan.steps, 1):
        if step.fix is not None:
            own = tuple(checks(step.fix))
        else:
            own = (phrase(f"action_plan.check_move{'_place' if step.overturned is None else ''}"),)
        found.setdefault((False, own), []).append(str(number))
        if step.instead is not None:
            found.setdefault((True, tuple(checks(step.instead))), []).append(str(number))
    lines: list[tuple[str, str]] = []
    for (undrilled, own), numbers in found.items():
        steps = ", ".join(numbers)
        label = say("action_plan.steps_instead", language, steps=steps) if undrilled else steps
        lines.append((label, say(joined(own, "action_plan.next"), language)))
    return lines


def _row(number: int, plan: ActionPlan, scale: int, language: str) -> CardRow:
    step = plan.steps[number - 1]

    def own(key: str, **values: object) -> str:
        return say(f"action_plan.{key}", language, **values)

    meaning = say(MEANINGS[step.grade], language)
    inputs = joined(one.label for one in step.weakest)
    return CardRow(
        number,
        say(heading(step, plan), language),
        own("decided") if step.decided else "",
        own("free") if step.fix is None else own("cost", level=step.cost_class),
        step.cost_class,
        step.grade.value,
        (own("grade", grade=step.grade.value, meaning=meaning), own("weakest", inputs=inputs)),
        Markup("") if step.fix is None else Markup(elevation_svg(step.fix, step.what, scale, language)),
        _block(step.fix, _lines(number, plan), plan, language),
        _other(step, plan, language),
    )


def _other(step: PlanStep, plan: ActionPlan, language: str) -> tuple[str, CardBlock] | None:
    """Return the other way as to drilling, where there is one."""
    key, fix = (
        ("instead", step.instead) if step.instead is not None else ("drilled", plan.drilled.get(step.what))
    )
    if fix is None or step.fix is None:
        return None
    assert step.overturned is not None
    lines = _lines_of_other(fix, step.overturned.estimate, plan)
    return say(f"action_plan.{key}", language), _block(fix, lines, plan, language)


def _dead_end(plan: ActionPlan, language: str) -> CardDeadEnd | None:
    """Return what else can be done where the steps are not enough; None where they are."""
    names = [step.what for step in plan.steps if step.fix is not None and not step.fix.enough]
    names += plan.unsolved
    if not names:
        return None
    before = {piece.name: piece.probabilities["overturned"].estimate for piece in plan.verdict.pieces}
    told = ["ask_landlord"] if plan.home.no_drilling else []
    return CardDeadEnd(
        say("action_plan.not_enough", language, pieces=joined(map(piece_name, dict.fromkeys(names)))),
        tuple(say(f"action_plan.{key}", language) for key in (*told, "out_of_reach")),
        tuple(
            (
                say("action_plan.drilled_on", language, piece=piece_name(name)),
                _block(fix, _lines_of_other(fix, before[name], plan), plan, language),
            )
            for name, fix in plan.drilled.items()
            if name in plan.unsolved
        ),
    )


def _block(
    fix: Fix | None, lines: Iterable[tuple[str, Phrase]], plan: ActionPlan, language: str
) -> CardBlock:
    weak = None if fix is None else too_weak(fix, plan)
    return CardBlock(
        None if weak is None else (say(weak[0], language), say(weak[1], language)),
        tuple((say(f"action_plan.{key}", language), say(told, language)) for key, told in lines),
    )


def _lines(number: int, plan: ActionPlan) -> Iterator[tuple[str, Phrase]]:
    """Yield what is said of a step, with the keys of its headings."""
    step = plan.steps[number - 1]
    fix = step.fix
    if fix is not None:
        yield "buy", joined(to_buy(one, fix) for one in fix.purchases)
        yield "where", joined((where(one, fix) for one in fix.purchases), "action_plan.next")
    now = fix.overturns if fix is not None else _overturns_moved(step, plan)
    told: list[Phrase] = []
    if step.overturned is not None and now is not None:
        told.append(_overturns(step.overturned.estimate, now))
    told += what_it_brings(number, plan)
    yield "effect" if fix is None or fix.enough else "reaches", joined(told, "action_plan.next")
    if fix is not None and fix.cautions:
        yield "caution", joined(fix.cautions, "action_plan.next")


def _lines_of_other(fix: Fix, was: float, plan: ActionPlan) -> Iterator[tuple[str, Phrase]]:
    """Yield the same of another way, for a piece that overturns so often as the room is."""
    told = [_overturns(was, fix.overturns)]
    if not changes_nothing(fix.alone):
        told.append(effects(fix.alone, plan))
    yield "effect" if fix.enough else "reaches", joined(told, "action_plan.next")
    yield "buy", joined(to_buy(one, fix) for one in fix.purchases)
    if fix.cautions:
        yield "caution", joined(fix.cautions, "action_plan.next")


def _overturns(was: float, now: Probability) -> Phrase:
    return phrase("action_plan.overturns", was=share_text(was), now=with_ends(now))


def _overturns_moved(step: PlanStep, plan: ActionPlan) -> Probability | None:
    """Return how often a piece that is moved overturns there; None of a person's place, or as often."""
    if step.overturned is None:
        return None
    now = step.alone.overturned[plan.verdict.scenario.names.index(step.what)]
    return None if now.estimate == step.overturned.estimate else now


def _notes_on_products(runs: int) -> Iterator[Phrase]:
    scatter = USUAL["strength"]
    assert isinstance(scatter, Lognormal)
    yield phrase("action_plan.strengths", share=100.0 * QUANTILE, runs=runs, margin=MARGIN, cov=scatter.cov)
    (low, low_euro), (high, high_euro) = COST_BOUNDS
    yield phrase("action_plan.costs", low=low, low_euro=low_euro, high=high, high_euro=high_euro)


def _notes(plan: ActionPlan) -> Iterator[Phrase]:
    """Yield how marks, strengths, costs and shares are to be read."""
    grades = joined(
        phrase("action_plan.grade", grade=grade.value, meaning=meaning) for grade, meaning in MEANINGS.items()
    )
    verdict = plan.verdict
    runs = verdict.motions * verdict.samples
    yield phrase("action_plan.grades", meanings=grades)
    if any(step.fix is not None for step in plan.steps):
        yield from _notes_on_products(runs)
    motions = motion_phrase(verdict) or phrase("action_plan.same_motions", count=verdict.motions)
    yield phrase(
        "action_plan.runs", runs=runs, motions=motions, seed=verdict.seed, version=stayput.__version__
    )
    yield phrase("action_plan.limits")
