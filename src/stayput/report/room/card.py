"""A plan to buy and do as one HTML page that prints on one sheet for up to four pieces."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

import stayput
from stayput.catalogue import Phrase, phrase, say
from stayput.measures.measure import MEANINGS
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.page import framed, rendered
from stayput.report.room.elevation import SIZES, elevation_scale, elevation_svg, plan_scale, sizes_of
from stayput.report.room.plan import numbered_plan
from stayput.report.room.sheet import PlanSheet
from stayput.rooms import step_words
from stayput.rooms.purchases import MARGIN, QUANTILE
from stayput.rooms.steps import COST_BOUNDS, ActionPlan, Fix, PlanStep
from stayput.uncertainty import USUAL, Lognormal
from stayput.verification.demand import DEMAND_RUNS
from stayput.verification.meetings import more_meetings
from stayput.verification.room_words import motion_phrase, people_in, piece_name, piece_within
from stayput.verification.words import shaking_phrase
from stayput.wording import joined

if TYPE_CHECKING:
    from stayput.fragility.probabilities import Probability
    from stayput.report.room.elevation import CardSizes

PLAN_LETTERS = 17.0
"""Size of the names on the plan [px]; that in card.css."""


SHEETS = ("canvas/plan.css", "room/plan.css", "room/card.css")
"""Style sheets of the card: the look of plans, of their figures, and its own."""


def plan_html(plan: ActionPlan, language: str = "en") -> str:
    """Return a plan as a page to print that loads nothing from elsewhere, in "en" or "ja"."""
    tell = partial(say, language=language)
    title, named = _own(language, "title"), plan.verdict.scenario.title
    sizes = sizes_of(plan)
    drawn = [step.fix for step in plan.steps if step.fix is not None]
    elevations = elevation_scale(drawn, sizes)
    drawing, scale, legend = _plan(plan, sizes, language)
    beside = phrase("action_plan.elevations", scale=elevations) if drawn else ""
    content = {
        **framed(language, "action_plan", f"{title} – {named}" if named else title, SHEETS),
        "name": named,
        "sentences": [*map(tell, _sentences(plan))],
        "letters": sizes.letters,
        "dense": sizes == SIZES[-1],
        "plan": drawing,
        "legend": legend,
        "scale": _own(language, "scale", plan=scale, elevations=beside),
        "rows": [_row(number, plan, elevations, language) for number in range(1, len(plan.steps) + 1)],
        "dead_end": _dead_end(plan, language),
        "checks": _checks(plan, language),
        "not_taken": [
            (tell(step_words.capital(piece_name(name))), tell(step_words.sets_not_taken(reasons)))
            for name, reasons in plan.not_taken.items()
        ],
        "rough": any(step.grade == max(MEANINGS) for step in plan.steps),
        "weakest": _weakest(plan, language),
        "notes": [*map(tell, _notes(plan))],
    }
    return rendered("room/card.html", content)


def _sentences(plan: ActionPlan) -> Iterator[Phrase]:
    """Yield how it is, how it would be, and what was asked for."""
    verdict, together, falling = plan.verdict, plan.together, step_words.falls(plan)
    chances = step_words.worth_telling(verdict.without if together is None else together, plan)
    if chances:
        only, strength = motion_phrase(verdict), shaking_phrase(verdict)
        key = "action_plan.shaking" if only is None else "action_plan.shaking_of_one"
        shaking = phrase(key, strength=strength, motion=only or "")
        now = joined(_chance(key, was) for key, (_, was) in chances.items())
        yield phrase("action_plan.now", shaking=shaking, chances=now)
    if chances and together is not None:
        key = "action_plan.then_one" if len(plan.steps) == 1 else "action_plan.then"
        then = joined(_chance(key, chance) for key, (chance, _) in chances.items())
        yield phrase(key, last=len(plan.steps), chances=then)
    if together is not None:
        for first, second, chance in more_meetings(together, verdict.without):
            names = {"first": piece_within(first), "second": piece_within(second)}
            yield phrase("action_plan.meets", fell=chance.fell, runs=chance.runs, **names)
    harmless = falling is None and not any(was.estimate for _, was in chances.values())
    if harmless and together is None and not plan.unsolved and not plan.not_enough:
        yield phrase("action_plan.nothing")
    if falling is not None:
        yield phrase("action_plan.falls", pieces=falling)
    in_place = [
        phrase("rooms.fix", measure=measure.label, piece=piece_within(name))
        for name, measures in zip(verdict.scenario.names, verdict.scenario.stated.on, strict=True)
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


def _chance(key: str, chance: Probability) -> Phrase:
    return phrase("action_plan.chance", what=phrase(f"rooms.chance_of_{key}"), share=chance.texts)


def _plan(
    plan: ActionPlan, sizes: CardSizes, language: str
) -> tuple[Markup, int, tuple[tuple[str, str], ...]]:
    """Return the room with the steps' numbers to a round scale on paper, that scale, and what marks mean."""
    numbers: dict[str, str] = {}
    for number, step in enumerate(plan.steps, 1):
        numbers[step.what] = f"{numbers[step.what]}+{number}" if step.what in numbers else f"{number}"
    moves = [step.move for step in plan.steps if step.move is not None]
    drawing = numbered_plan(plan.verdict, moves, language, numbers, PLAN_LETTERS)
    drawn = plan.verdict.scenario.scene().plan
    assert drawn is not None
    sheet = PlanSheet(drawn)
    metres = [size / sheet.scale for size in sheet.size]
    scale = plan_scale(metres, sizes)
    wide = f"{1e3 * metres[0] / scale:.1f}mm"
    return Markup(re.sub("<svg ", f'<svg style="width:{wide}" ', drawing.svg, count=1)), scale, drawing.legend


def _weakest(plan: ActionPlan, language: str) -> list[tuple[str, str]]:
    """Return the weakest inputs of the steps, each list of them once, with the steps' numbers before it."""
    numbered: dict[str, list[str]] = {}
    for number, step in enumerate(plan.steps, 1):
        inputs = say(joined(item.label for item in step.weakest), language)
        numbered.setdefault(inputs, []).append(str(number))
    return [(", ".join(numbers), inputs) for inputs, numbers in numbered.items()]


def _checks(plan: ActionPlan, language: str) -> list[tuple[str, str]]:
    """Return what to look at before which steps, or before which of their variants without drilling."""
    numbered: dict[tuple[bool, Phrase], list[str]] = {}
    for number, step in enumerate(plan.steps, 1):
        empty = "" if step.overturned is None else phrase("action_plan.empty")
        move = [phrase("action_plan.check_move", empty=empty)]
        ways = [move if step.fix is None else step_words.checks(step.fix)]
        ways += [] if step.instead is None else [step_words.checks(step.instead)]
        for undrilled, way in enumerate(ways):
            if way:
                key = bool(undrilled), joined(way, "action_plan.next")
                numbered.setdefault(key, []).append(str(number))
    steps = {key: ", ".join(numbers) for key, numbers in numbered.items()}
    return [
        (_own(language, "steps_instead", steps=of) if undrilled else of, say(sentence, language))
        for (undrilled, sentence), of in steps.items()
    ]


def _row(number: int, plan: ActionPlan, scale: int, language: str) -> dict[str, Any]:
    """Return a step as it is read; what is known of its inputs is for the screen, see `_weakest`."""
    step, text = plan.steps[number - 1], partial(_own, language)
    grade = {"grade": step.grade.value, "meaning": MEANINGS[step.grade]}
    return {
        "number": number,
        "heading": say(step_words.heading(step, plan), language),
        "decided": text("decided") if step.decided else "",
        "cost": text("cost", level=step.cost_class) if step.cost_class else text("free"),
        "grade": step.grade.value,
        "known": [text("grade", **grade), text("weakest", inputs=joined(x.label for x in step.weakest))],
        "drawing": "" if step.fix is None else Markup(elevation_svg(step.fix, step.what, scale, language)),
        "done": _block(step.fix, _lines(number, plan), plan, language),
        "other": _other(step, plan, language),
    }


def _own(language: str, key: str, **values: object) -> str:
    return say(f"action_plan.{key}", language, **values)


def _other(step: PlanStep, plan: ActionPlan, language: str) -> tuple[str, dict[str, Any]] | None:
    """Return the other way as to drilling with its heading: without it, or with it where not allowed."""
    fix = step.instead or plan.drilled.get(step.what)
    if fix is None or step.fix is None:
        return None
    assert step.overturned is not None
    lines = _lines_of_other(fix, step.overturned, plan)
    return _own(language, "instead" if step.instead else "drilled"), _block(fix, lines, plan, language)


def _dead_end(plan: ActionPlan, language: str) -> dict[str, Any] | None:
    """Return what else can be done where nothing is enough, and for which pieces; None where all is.

    Beside it is what comes nearest on a piece, and what would be enough if drilling were allowed.
    """
    names = [step.what for step in plan.steps if step.fix is not None and step.fix.too_weak]
    names += [*plan.not_enough, *plan.unsolved]
    if not names:
        return None
    text = partial(_own, language)
    before = {piece.name: piece.probabilities[OVERTURNED] for piece in plan.verdict.without.pieces}
    blocks = [(step_words.measures_on(name, fix), name, fix) for name, fix in plan.not_enough.items()]
    blocks += [
        (phrase("action_plan.drilled_on", piece=piece_name(name)), name, fix)
        for name, fix in plan.drilled.items()
        if name in (*plan.not_enough, *plan.unsolved)
    ]
    unclear = any(not fix.too_weak for fix in plan.not_enough.values())
    keys = ["more_runs"] * unclear + ["ask_landlord"] * plan.home.no_drilling
    keys += ["out_of_reach"] * bool(people_in(plan.verdict).places) + ["lower_piece"]
    return {
        "heading": text("not_enough", pieces=joined(map(piece_name, dict.fromkeys(names)))),
        "sentences": [*map(text, keys)],
        "ways": [
            (say(title, language), _block(fix, _lines_of_other(fix, before[name], plan), plan, language))
            for title, name, fix in blocks
        ],
    }


def _block(
    fix: Fix | None, lines: Iterable[tuple[str, Phrase]], plan: ActionPlan, language: str
) -> dict[str, Any]:
    """Return what is said of a move or of measures: that they are too weak, and lines with headings."""
    weak = None if fix is None else step_words.not_strong_enough(fix, plan)
    return {
        "warning": None if weak is None else [say(sentence, language) for sentence in weak],
        "lines": [(_own(language, key), say(sentence, language)) for key, sentence in lines],
    }


def _lines(number: int, plan: ActionPlan) -> Iterator[tuple[str, Phrase]]:
    """Yield what is said of a step, with the keys of its headings."""
    step = plan.steps[number - 1]
    fix = step.fix
    if fix is not None:
        if fix.cost_class:
            yield "buy", joined(step_words.to_buy(purchase, fix) for purchase in fix.purchases)
        places = [step_words.where(purchase, fix) for purchase in fix.purchases]
        yield "where", joined(places, "action_plan.next")
    sentences: list[Phrase] = []
    if (was := step.overturned) is not None:  # else it is the place of a person that is moved
        body = plan.verdict.scenario.names.index(step.what)
        moved = step.alone.pieces[body].probabilities[OVERTURNED]
        now = moved if fix is None else fix.overturns
        if fix is not None or now.share != was.share:
            sentences.append(_overturns(was, now))
    sentences += step_words.what_it_brings(number, plan)
    yield "reaches" if fix is not None and fix.too_weak else "effect", joined(sentences, "action_plan.next")
    if fix is not None and fix.cautions:
        yield "caution", joined(fix.cautions, "action_plan.next")


def _lines_of_other(fix: Fix, was: Probability, plan: ActionPlan) -> Iterator[tuple[str, Phrase]]:
    """Yield the same of another way, for a piece that overturns so often as the room is."""
    sentences = [_overturns(was, fix.overturns)]
    if not fix.alone.helps:
        sentences.append(phrase("action_plan.no_gain"))
    elif not step_words.changes_nothing(fix.alone, plan):
        sentences.append(step_words.effects(fix.alone, plan))
    yield "effect" if fix.sound else "reaches", joined(sentences, "action_plan.next")
    if fix.sound:
        yield "buy", joined(step_words.to_buy(purchase, fix) for purchase in fix.purchases)
    if fix.cautions:
        yield "caution", joined(fix.cautions, "action_plan.next")


def _overturns(was: Probability, now: Probability) -> Phrase:
    return phrase("action_plan.overturns", was=was.texts, now=now.texts)


def _notes(plan: ActionPlan) -> Iterator[Phrase]:
    """Yield how marks, strengths, costs and shares are to be read."""
    meanings = [
        phrase("action_plan.grade", grade=grade.value, meaning=meaning) for grade, meaning in MEANINGS.items()
    ]
    yield phrase("action_plan.grades", meanings=joined(meanings))
    verdict = plan.verdict
    if any(step.fix is not None for step in plan.steps):
        scatter = USUAL["strength"]
        assert isinstance(scatter, Lognormal)
        values = {"share": 100.0 * QUANTILE, "margin": MARGIN, "cov": scatter.cov}
        yield phrase("action_plan.strengths", runs=min(verdict.without.runs, DEMAND_RUNS), **values)
        (low, low_euro), (high, high_euro) = COST_BOUNDS
        yield phrase("action_plan.costs", low=low, low_euro=low_euro, high=high, high_euro=high_euro)
    motions = motion_phrase(verdict) or phrase("action_plan.same_motions", count=verdict.motions)
    made = {"motions": motions, "seed": verdict.seed, "version": stayput.__version__}
    of_steps = replace(verdict, options=(verdict.without, *(step.together for step in plan.steps)))
    yield phrase("action_plan.runs", runs=of_steps.runs_each, **made)
    yield phrase("action_plan.limits")
