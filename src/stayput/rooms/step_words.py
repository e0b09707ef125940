"""The sentences of a plan to buy and do; they are in `stayput.catalogue.action_plan`."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from stayput.catalogue import Phrase, phrase
from stayput.measures import MEASURES
from stayput.montecarlo.counting import OVERTURNED
from stayput.rooms.steps import ActionPlan, Fix, PlanStep, cost_class_of, fails_to_hold, merit
from stayput.simulation.placing import placed
from stayput.simulation.space_fate import MAY_FALL_FROM
from stayput.verification.people import DECIDING_EVENTS
from stayput.verification.room_words import label_of, people_in, piece_name
from stayput.verification.words import class_phrase
from stayput.wording import inside, joined

if TYPE_CHECKING:
    from stayput.fragility.probabilities import Probability
    from stayput.measures import Held
    from stayput.rooms.purchases import Purchase
    from stayput.rooms.steps import NotTaken, Trial
    from stayput.verification.verdict import OptionVerdict

KILOGRAM = 9.80665
"""Weight of a kilogram, for people who read loads in kgf [N]."""


def newtons(force: float, whole: Callable[[float], int] = math.ceil) -> Phrase:
    """Return a force in newtons and kgf, rounded up as one is asked for, or down as one is held."""
    step = 10.0 if force < 1000.0 else 50.0
    rounded = step * whole(force / step)
    return phrase("action_plan.newtons", newtons=rounded, kilograms=whole(rounded / KILOGRAM))


def forces_asked(purchase: Purchase) -> list[tuple[str, float]]:
    """Return in which directions a product is rated, and how strong it must be there [N].

    It is not in a direction in which nothing can fail, or in which there is hardly any force.
    """
    if purchase.needed is None or purchase.holds is None:
        return []
    return [
        (name, getattr(purchase.needed, name))
        for name, holds in purchase.holds._asdict().items()
        if math.isfinite(holds) and getattr(purchase.needed, name) >= 1.0
    ]


def product(purchase: Purchase) -> Phrase:
    """Return what to buy and how many: "Screwed L-brackets × 3"."""
    if not hasattr(purchase.measure, "count"):
        return purchase.measure.label
    return phrase("action_plan.product", measure=purchase.measure.label, count=purchase.count)


def products(fix: Fix) -> Phrase:
    """Return all that is put on a piece, as it stands within a sentence."""
    english, japanese = joined((product(purchase) for purchase in fix.purchases), "action_plan.plus")
    return inside(english), japanese


def to_buy(purchase: Purchase, fix: Fix) -> Phrase:
    """Return what to buy, with its rated strength; of what is too weak it is not told."""
    called = purchase.measure.to_buy(product(purchase), fix.piece.body)
    forces = [phrase(f"action_plan.{name}", force=newtons(force)) for name, force in forces_asked(purchase)]
    if not forces or not purchase.enough:
        return called
    return phrase("action_plan.rated", product=called, forces=joined(forces, "action_plan.and"))


def where(purchase: Purchase, fix: Fix) -> Phrase:
    """Return where a device goes."""
    return purchase.measure.placed_at(held_by(fix), fix.piece.at[2])


def checks(fix: Fix) -> list[Phrase]:
    """Return what to look at before the measures are bought, each once."""
    room = held_by(fix).room
    sentences = (sentence for purchase in fix.purchases for sentence in purchase.measure.checks(room))
    return list(dict.fromkeys(sentences))


def not_strong_enough(fix: Fix, plan: ActionPlan) -> tuple[Phrase, Phrase] | None:
    """Return that a fix is too weak or has no reserve, and what it bears, if it is so."""
    if fix.enough:
        return None
    sentences = [_bears(purchase) for purchase in fix.purchases if not purchase.enough]
    key = "action_plan.weak" if fix.too_weak else "action_plan.no_reserve"
    strength = class_phrase(plan.verdict.intensity, plan.verdict.floor)
    weak = phrase(key, strength=strength, in_runs=in_runs(fix))
    return weak, joined(sentences, "action_plan.next")


def in_runs(tried: Fix | Trial) -> Phrase:
    """Return how often measures give way and the piece overturns with them."""
    return phrase("action_plan.in_runs", fails=tried.gives_way.share, share=tried.overturns.share)


def why_not(tried: Trial, taken: Trial | None = None) -> Phrase:
    """Return why measures that have run on a piece were not taken; where none were, they do not help."""
    effect = tried.effect
    if fails_to_hold(tried.gives_way, tried.overturns):
        return phrase("action_plan.too_weak", in_runs=in_runs(tried))
    if taken is None:
        return phrase("action_plan.helps_not", share=tried.overturns.share)
    people = effect.people
    assert people is not None
    chances = {key: getattr(people, key).chance for key in DECIDING_EVENTS} | {OVERTURNED: tried.overturns}
    for (key, chance), less, more in zip(chances.items(), merit(tried), merit(taken), strict=False):
        if less > more:
            what = phrase(f"rooms.chance_of_{key}")
            return phrase("action_plan.helps_less", what=what, share=chance.share)
    costlier = cost_class_of(tried.measures) > cost_class_of(taken.measures)
    return phrase("action_plan.costs_more" if costlier else "action_plan.brings_no_more")


def sets_not_taken(reasons: NotTaken) -> Phrase:
    """Return which sets of measures were not taken on a piece, each with the reason."""
    clauses: list[Phrase] = []
    for kinds, why in reasons.items():
        measures = joined((MEASURES[kind].label for kind in kinds), "action_plan.plus")
        clauses.append(joined((measures, why), "common.colon"))
    return joined(clauses, "action_plan.next")


def _bears(purchase: Purchase) -> Phrase:
    """Return what a device that is too weak bears, in the direction in which most is missing."""
    assert purchase.needed is not None
    assert purchase.holds is not None
    pairs = zip(purchase.needed, purchase.holds, strict=True)
    needed, holds = max(pairs, key=lambda pair: pair[0] / pair[1] if pair[1] > 0.0 else 0.0)
    return phrase(
        "action_plan.weak_bears",
        measure=purchase.measure.label,
        needed=newtons(needed),
        holds=newtons(holds, math.floor),
        fails=purchase.fails or "",
    )


def chances_after(
    effect: OptionVerdict, plan: ActionPlan, before: OptionVerdict | None = None
) -> dict[str, tuple[Probability, Probability]]:
    """Return what may happen with something, by the key of its words, and how likely it is before that.

    That is in the room as it is where it is left out.
    """
    people, was = effect.people, (plan.verdict.without if before is None else before).people
    assert people is not None
    assert was is not None
    return {key: (getattr(people, key).chance, getattr(was, key).chance) for key in DECIDING_EVENTS}


def worth_telling(
    effect: OptionVerdict, plan: ActionPlan, before: OptionVerdict | None = None
) -> dict[str, tuple[Probability, Probability]]:
    """Return those of them that happen; none in a room without places."""
    return {
        key: (chance, was)
        for key, (chance, was) in chances_after(effect, plan, before).items()
        if (key == "hit" and people_in(plan.verdict).places) or was.estimate != 0.0 or chance.estimate != 0.0
    }


def falls(plan: ActionPlan) -> Phrase | None:
    """Return which pieces overturn often, before the steps and after all of them; None where none does."""
    now, then = plan.verdict.without.pieces, () if plan.together is None else plan.together.pieces
    before, after = (
        {piece.name: piece.probabilities[OVERTURNED] for piece in pieces} for pieces in (now, then)
    )
    names = plan.verdict.scenario.names

    def sentence(name: str) -> Phrase:
        was = before[name].texts
        if name not in after:
            return phrase("action_plan.piece_falls", piece=piece_name(name), was=was)
        now = after[name].texts
        return phrase("action_plan.piece_falls_then", piece=piece_name(name), was=was, now=now)

    shares = {name: max(before[name].estimate, after.get(name, before[name]).estimate) for name in names}
    often = [name for name in names if shares[name] >= MAY_FALL_FROM]
    often.sort(key=lambda name: -before[name].estimate)
    return joined(map(sentence, often)) if often else None


def effects(effect: OptionVerdict, plan: ActionPlan, before: OptionVerdict | None = None) -> Phrase:
    """Return what changes of who is hit, who is shut in, and which door is blocked; all where nothing does.

    Parameters
    ----------
    effect : OptionVerdict
        What something brings.
    plan : ActionPlan
        The plan.
    before : OptionVerdict, optional
        From what it changes; from the room as it is where it is left out.
    """
    rows = worth_telling(effect, plan, before)
    changed = {key: pair for key, pair in rows.items() if pair[0].share != pair[1].share}
    return joined(
        phrase("action_plan.changes", what=phrase(f"rooms.chance_of_{key}"), was=was.texts, now=chance.texts)
        for key, (chance, was) in (changed or rows).items()
    )


def changes_nothing(effect: OptionVerdict, plan: ActionPlan, before: OptionVerdict | None = None) -> bool:
    """Return whether no share that is shown is another one than before, or than in the room as it is."""
    return all(chance.share == was.share for chance, was in chances_after(effect, plan, before).values())


def what_it_brings(number: int, plan: ActionPlan) -> Iterator[Phrase]:
    """Yield what the step of a number, from 1 on, brings alone, and after the steps before it.

    A step without which the others bring less may change nothing alone: then it is said with which it does.
    One that only keeps a piece from overturning changes nothing for people.
    """
    step = plan.steps[number - 1]
    if not step.for_people and (not step.decided or changes_nothing(step.alone, plan)):
        yield phrase("action_plan.only_falls" if _steadies(step) else "action_plan.no_gain")
        return
    alone = effects(step.alone, plan)
    if not step.alone.helps:
        alone = phrase("action_plan.unclear", chance=alone)
    if len(plan.steps) == 1:
        yield alone
        return
    before = None if number == 1 else plan.steps[number - 2].together
    after = before is not None and not changes_nothing(step.together, plan, before)
    if changes_nothing(step.alone, plan):
        others = range(1, number) if after else (n for n in range(1, len(plan.steps) + 1) if n != number)
        steps = joined([(str(other), str(other)) for other in others], "action_plan.and")
        yield phrase("action_plan.only_together", steps=steps)
    else:
        yield phrase("action_plan.alone", chance=alone)
    if after:
        yield phrase("action_plan.after_others", chance=effects(step.together, plan, before))


def _steadies(step: PlanStep) -> bool:
    """Return whether a piece overturns less often with a step."""
    was, fix = step.overturned, step.fix
    return was is not None and fix is not None and fix.overturns.estimate < was.estimate


def heading(step: PlanStep, plan: ActionPlan) -> Phrase:
    """Return what a step consists of."""
    if step.fix is None:
        assert step.move is not None
        return capital(label_of(step.move, plan.verdict))
    return measures_on(step.what, step.fix)


def measures_on(name: str, fix: Fix) -> Phrase:
    """Return what is put on a piece: "Bookcase: belts × 2"."""
    return joined((capital(piece_name(name)), products(fix)), "common.colon")


def capital(words: Phrase) -> Phrase:
    """Return words as they begin a line."""
    english, japanese = words
    return english[:1].upper() + english[1:], japanese


def held_by(fix: Fix) -> Held:
    """Return a piece with its measures in place, each device by itself."""
    held = placed(fix.scene)[fix.body].held
    assert held is not None
    return held
