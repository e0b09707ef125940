"""The sentences of a verdict on a piece or on several: which apply, and the values in them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from stayput.catalogue import Phrase, phrase, say
from stayput.catalogue.names import CONTENTS, INTENSITIES, PIECES_OF_RUNS
from stayput.fragility.probabilities import Probability, percent
from stayput.montecarlo.counting import DEVICE_FAILED, OVERTURNED, SLID
from stayput.motion.floors import floor_phrase
from stayput.motion.intensity import intensity_class
from stayput.simulation.space_fate import MAY_FALL_FROM
from stayput.wording import FAR, inside, is_open, joined, name_within, with_aside

if TYPE_CHECKING:
    from stayput.scenario.measures import Option
    from stayput.verification.verdict import OptionVerdict, Verdict

SMALL = 0.005
"""A share below this is not mentioned."""

SAFE = MAY_FALL_FROM
"""A piece is called safe where the upper ends of the 95 % intervals of its risks are below this.

Seismic margins ask the same: high confidence (95 %) of a low probability of failure (5 %), HCLPF.
"""


def class_phrase(intensity: float, floor: str = "") -> Phrase:
    """Return the class of a JMA intensity; of an upper floor's motion also that it is not the place's."""
    strength = INTENSITIES[intensity_class(intensity)]
    if not floor:
        return strength
    return phrase("ground_shaking.of_floor", strength=strength, floor=floor_phrase(floor))


def shaking_phrase(verdict: Verdict) -> Phrase:
    """Return how strong shaking is: its class, and what was stated where that is not the class itself."""
    shaking, strength = verdict.scenario.shaking, class_phrase(verdict.intensity, verdict.floor)
    if shaking.strength is None or isinstance(shaking.intensity, str):
        return strength
    return phrase("ground_shaking.of_class", strength=strength, stated=shaking.strength.brief)


def class_label(intensity: float, language: str, floor: str = "") -> str:
    """Return the class of a JMA intensity: "6-upper", or "震度6強"; see `class_phrase`."""
    return say(class_phrase(intensity, floor), language)


def doubt(chance: Probability) -> Phrase | str:
    """Return, behind a statement that something hardly happens, how often it may where runs are too few."""
    if chance.high < SAFE:
        return ""
    return phrase("verification.not_ruled_out", share=chance.share)


def falls_phrase(chance: Probability) -> Phrase:
    """Return how often it overturns: "in about 25 % of the cases", "約25%の場合に転倒します"."""
    return phrase("verification.falls", share=chance.share)


def title(option: Option, verdict: Verdict, language: str) -> str:
    """Return an option's label, in brackets behind its name where that is the user's own."""
    return say(_titled(option, verdict, in_sentence=False), language)


def _titled(option: Option, verdict: Verdict, *, in_sentence: bool) -> Phrase:
    """Return the title of an option, which may stand within a sentence."""
    names, several = verdict.scenario.names, len(option.on) > 1
    labels = [other.option.label(names) for other in (*verdict.options, *verdict.impossible)]
    label, alone = option.label(names), labels.count(option.label(names)) == 1
    english = label[0]
    if in_sentence or (option.own_name and several):
        english = inside(english)
    if option.own_name:
        return with_aside(option.name, english, "en"), with_aside(option.name, label[1], "ja")
    if alone or not option.count:
        return english, label[1]
    return with_aside(english, option.name, "en"), with_aside(label[1], option.name, "ja")


def _title_inside(option: Option, verdict: Verdict) -> Phrase:
    """Return an option's title within a sentence; of several pieces the user's own name stands for it."""
    english, japanese = _titled(option, verdict, in_sentence=True)
    if option.own_name and len(option.on) > 1:
        english = f"“{option.name}”"
    return english, japanese


def length(metres: float) -> str:
    """Return a length as a person reads it: "0.3 cm", "12 cm", "1.5 m"."""
    if metres >= 0.995:
        return f"{metres:.1f} m"
    return f"{100.0 * metres:.0f} cm" if metres >= 0.095 else f"{100.0 * metres:.1f} cm"


def rounded_up(value: float, step: float) -> float:
    """Return a value that is told as "at most", in whole steps."""
    return step * math.ceil(round(value / step, 6))  # without the last digits of a quantile


def length_at_most(metres: float) -> str:
    """Return a length that is not exceeded, with the digits of `length`."""
    return length(rounded_up(metres, 0.1 if metres >= 0.995 else 0.01 if metres >= 0.095 else 0.001))


def slides_off(option: OptionVerdict, verdict: Verdict) -> bool:
    """Return whether a tenth of the runs slide beyond `FAR` where the room is open to a side."""
    room = verdict.scenario.room.room()
    return math.isfinite(option.slide.p90) and option.slide.p90 > FAR and is_open(room)


def headline(verdict: Verdict, language: str) -> str:
    """Return the verdict in one sentence."""
    sentences = [say(_headline(verdict), language)]
    slides = {option.probabilities[SLID].share for option in (verdict.best, verdict.without)}
    if verdict.best.helps and not _helps(verdict.best) and SLID in verdict.best.better and len(slides) > 1:
        sentences.append(say(_slides_less(verdict), language))
    if verdict.best.installed is not None:
        share = _as_usual(verdict.best).share
        measure = _title_inside(verdict.best.option, verdict)
        sentences.append(say("verification.best_as_installed", language, measure=measure, share=share))
    if verdict.best.contents is not None:
        sentences.append(say(_of_contents(verdict), language))
    return (" " if language == "en" else "").join(sentences)


def asides(option: OptionVerdict, verdict: Verdict) -> list[Phrase]:
    """Return sentences on what comes out of the furniture, and on the measures as people install them.

    Each only where the scenario asks for it.
    """
    sentences: list[Phrase] = []
    if option.contents is not None:
        english, japanese = contents_out(option, verdict)
        sentences.append((sentence_of([english], "en"), sentence_of([japanese], "ja")))
    if option.installed is not None:
        share = _as_usual(option).share
        sentences.append(phrase("verification.overturns_as_installed", share=share))
    return sentences


def contents_name(verdict: Verdict) -> Phrase:
    """Return what is in the furniture, within a sentence."""
    contents = verdict.scenario.contents
    assert contents is not None
    english, japanese = CONTENTS[contents.kind]
    return inside(english), japanese


def contents_out(option: OptionVerdict, verdict: Verdict) -> Phrase:
    """Return how much of what is in the furniture comes out, as a clause."""
    assert option.contents is not None
    key = "verification.contents_out" if option.contents.out.runs else "verification.contents_unknown"
    return phrase(key, share=option.contents.out.share, contents=contents_name(verdict))


def _of_contents(verdict: Verdict) -> Phrase:
    best, without = verdict.best, verdict.without
    assert best.contents is not None
    assert without.contents is not None
    bare = without.contents.out
    clause = contents_out(best, verdict)
    stands = best.probabilities[OVERTURNED].estimate < SMALL and best.contents.out.estimate >= SMALL
    aside = ""
    if best is not without and bare.runs:
        aside = phrase("verification.contents_without", share=bare.share)
    # "it" is the piece of the sentence before: that one must be of the same measure, and of no installation
    if stands and best.installed is None and (_helps(best) or best is without):
        return phrase("verification.stands_but", clause=clause, aside=aside)
    if best is without:
        return phrase("verification.contents_alone", clause=clause)
    measure, held = _title_inside(best.option, verdict), "held" if best.installed is None else "well_held"
    held = phrase(f"verification.{held}")
    return phrase("verification.contents_with", measure=measure, held=held, clause=clause, aside=aside)


def _helps(option: OptionVerdict) -> bool:
    """Return whether clearly fewer overturn with an option than without a measure."""
    return option.change is not None and option.change.high < 0.0


def _headline(verdict: Verdict) -> Phrase:
    """Return how often something overturns without anything, and with the best option where that helps."""
    where, none, strength = _where(verdict), _none(verdict), shaking_phrase(verdict)
    best, chance = verdict.best, verdict.without.probabilities[OVERTURNED]
    if math.isnan(chance.estimate):
        return phrase("verification.no_bare_run", none=none)
    unheld = verdict.scenario.alone and not verdict.without.option.count
    what = phrase(f"{where}.what", name=name_within(verdict.scenario.piece.title, PIECES_OF_RUNS))
    bare = "" if unheld else phrase("several.without", none=none)
    falls = {"strength": strength, "what": what, "falls": falls_phrase(chance), "bare": bare}
    if _helps(best):
        option = phrase(f"{where}.if_there", option=_title_inside(best.option, verdict))
        share = best.probabilities[OVERTURNED].share
        return phrase("verification.better", **falls, option=option, share=share)
    if chance.estimate < SMALL:
        upright = f"{'verification' if unheld else 'several'}.stays_upright"
        return phrase(upright, strength=strength, what=what, none=none, doubt=doubt(chance))
    more: Phrase | str = ""
    if len(verdict.options) > 1:
        more = phrase(f"{where}.none_helps")
    elif verdict.impossible and where == "several":
        more = phrase("several.none_possible")
    return phrase("verification.bare_falls", **falls, more=more)


def _slides_less(verdict: Verdict) -> Phrase:
    """Return how often something slides too far with the best option, and how often without anything."""
    best, where = verdict.best, _where(verdict)
    bare, held = (option.probabilities[SLID].share for option in (verdict.without, best))
    option = phrase(f"{where}.if_there", option=_title_inside(best.option, verdict))
    limit, it = length(verdict.slide_limit), phrase(f"{where}.it")
    return phrase("verification.slides_less", option=option, it=it, limit=limit, bare=bare, held=held)


def _where(verdict: Verdict) -> str:
    """Return the module of the catalogue that tells what overturns: this piece, or any of several."""
    return "verification" if verdict.scenario.alone else "several"


def _none(verdict: Verdict) -> Phrase:
    """Return what is not in place in the option that the others are compared with."""
    return phrase("several.none_more" if verdict.without.option.count else f"{_where(verdict)}.none")


def reason(option: OptionVerdict, verdict: Verdict, language: str, most: int | None = None) -> str:
    """Return why an option stands where it does, in one plain sentence of at most so many clauses."""
    if math.isnan(option.probabilities[OVERTURNED].estimate):
        return say("verification.no_run", language)
    return sentence_of([say(part, language) for part in _reasons(option, verdict)[:most]], language)


def _overturns(option: OptionVerdict, verdict: Verdict) -> Phrase:
    """Return how often something overturns with an option, beside how often without anything."""
    where = _where(verdict)
    bare, held = (ranked.probabilities[OVERTURNED] for ranked in (verdict.without, option))
    it, change = phrase(f"{where}.it"), option.change
    if change is None:
        return phrase("verification.overturns", it=it, falls=falls_phrase(bare))
    key = "no_clear_change"
    if change.clear:
        key = "less_often" if change.estimate < 0.0 else "more_often"
    values = {"bare": bare.share, "held": held.share, "none": _none(verdict)}
    return phrase(f"verification.{key}", it=it, **values)


def sentence_of(clauses: list[str], language: str) -> str:
    """Return clauses as a sentence; in Japanese each is one."""
    text = "; ".join(clauses) if language == "en" else "。".join(clauses)
    return f"{text[:1].upper()}{text[1:]}." if language == "en" else f"{text}。"


OFTEN = 0.05
"""From this share on a failing device is mentioned."""


def _reasons(option: OptionVerdict, verdict: Verdict) -> list[Phrase]:
    shares = {event: chance.estimate for event, chance in option.probabilities.items()}
    parts = [_overturns(option, verdict), *_of_pieces(option, verdict)]
    none = phrase(f"{_where(verdict)}.none")
    parts += [phrase(f"verification.more_{name}", none=none) for name in option.worse if name != OVERTURNED]
    if option.contents is not None:
        parts.append(contents_out(option, verdict))
        if (leaving := option.contents.leaving) is not None:
            middle, highest = length(leaving.height), length(leaving.highest)
            key = "verification.from_the_top" if middle == highest else "verification.from_shelves"
            most, fast = length_at_most(leaving.highest), rounded_up(leaving.fast, 0.01)
            shelves = phrase(key, height=middle, highest=highest, most=most)
            parts.append(phrase("verification.contents_leave", from_where=shelves, fast=fast))
    if shares[DEVICE_FAILED] >= OFTEN:
        parts.append(phrase("verification.device_fails", share=option.probabilities[DEVICE_FAILED].share))
        parts += _gives_way(option)
    if option.installed is not None:
        parts.append(_as_installed(option))
    scenario = verdict.scenario
    if scenario.alone and slides_off(option, verdict):
        parts.append(phrase("verification.slides_far", far=FAR))
    elif math.isfinite(option.slide.p90) and option.slide.p90 >= 0.01:
        parts.append(phrase(f"{_where(verdict)}.slides", length=length_at_most(option.slide.p90)))
    elif scenario.alone and shares[SLID] < SMALL and shares[OVERTURNED] < SMALL:
        parts.append(phrase("verification.stays_where_it_is"))
    if not scenario.alone:
        return parts
    body, room = scenario.piece.body(), scenario.room.room()
    cautions = (caution for measure in option.option.measures for caution in measure.cautions(body, room))
    return [*parts, *(phrase("verification.caution", caution=caution) for caution in cautions)]


def _of_pieces(option: OptionVerdict, verdict: Verdict) -> Iterator[Phrase]:
    """Yield which of several pieces overturns most often, and what that does not count overturns too."""
    chances = [piece.probabilities[OVERTURNED] for piece in option.pieces]
    counted = verdict.scenario.counted
    worst = max(counted, key=lambda number: chances[number].estimate)
    if len(counted) > 1 and chances[worst].estimate >= SMALL:
        yield phrase("several.most_often", name=option.pieces[worst].name, share=chances[worst].share)
    for number, piece in enumerate(option.pieces):
        if number not in counted and chances[number].estimate >= SMALL:
            yield phrase("several.loose", name=piece.name, falls=falls_phrase(chances[number]))


def _gives_way(option: OptionVerdict) -> Iterator[Phrase]:
    """Yield which device or joint fails most often, as a clause."""
    worst = max(option.devices, key=lambda device: device.failed.estimate, default=None)
    if worst is None:
        return
    if len(worst.pieces) == 2:
        first, second = worst.pieces
        yield phrase("several.joint_fails", first=first, second=second)
    elif worst.weakest is not None and len(option.pieces) > 1:
        yield phrase("several.device_of", name=worst.pieces[0], weakest=worst.weakest)
    elif worst.weakest is not None:
        yield phrase("verification.gives_way", weakest=worst.weakest)


def _as_usual(option: OptionVerdict) -> Probability:
    """Return how often it overturns with a measure as people install it."""
    installed, well = option.installed, option.probabilities[OVERTURNED]
    assert installed is not None
    badly, share = installed.badly[OVERTURNED], installed.share
    low, high = ((1.0 - share) * a + share * b for a, b in ((well.low, badly.low), (well.high, badly.high)))
    return replace(badly, estimate=installed.usual[OVERTURNED], low=low, high=high)


def _as_installed(option: OptionVerdict) -> Phrase:
    """Return how often it overturns as people install a measure, beside how often when well installed."""
    installed, well, usual = option.installed, option.probabilities[OVERTURNED], _as_usual(option)
    assert installed is not None
    badly = installed.badly[OVERTURNED]
    alike = usual.share == well.share or badly.low <= well.estimate <= badly.high
    return phrase(
        "verification.alike_as_installed" if alike else "verification.as_installed",
        well=well.share,
        usual=usual.share,
        share=percent(installed.share),
        how=joined(installed.how),
    )
