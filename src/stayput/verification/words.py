"""The sentences of a verdict on a piece or on several: which apply, and the values in them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from stayput.catalogue import LANGUAGES, Phrase, phrase, say
from stayput.catalogue.names import CONTENTS, INTENSITIES
from stayput.fragility.probabilities import percent
from stayput.montecarlo.counting import DEVICE_FAILED, OVERTURNED, SLID
from stayput.motion.floors import floor_phrase
from stayput.motion.intensity import intensity_class
from stayput.verification.options import Impossible, Option, label
from stayput.wording import FAR, inside, is_open, joined, with_aside

if TYPE_CHECKING:
    from stayput.fragility import Probability
    from stayput.rooms.verdict import RoomVerdict
    from stayput.scenario.pieces import AssemblyOption
    from stayput.verification.verdict import AssemblyOptionVerdict, AssemblyVerdict, OptionVerdict, Verdict

    Ranked = Verdict | AssemblyVerdict

ALIKE = 0.05
"""Shares that differ by less than this, and not clearly, are called about the same."""

SMALL = 0.005
"""A share below this is not mentioned."""

SAFE = 0.05
"""A piece is called safe where the upper ends of the 95 % intervals of its risks are below this.

Seismic margins ask the same: high confidence (95 %) of a low probability of failure (5 %), HCLPF.
"""


def class_phrase(intensity: float, floor: str = "") -> Phrase:
    """Return the class of a JMA intensity; of an upper floor's motion also that it is not the place's."""
    strength = INTENSITIES[intensity_class(intensity)]
    if not floor:
        return strength
    return phrase("ground_shaking.of_floor", strength=strength, floor=floor_phrase(floor))


def shaking_phrase(verdict: Verdict | AssemblyVerdict | RoomVerdict) -> Phrase:
    """Return how strong shaking is: its class, and what was stated where that is not the class itself."""
    shaking, strength = verdict.scenario.shaking, class_phrase(verdict.intensity, verdict.floor)
    if shaking.strength is None or isinstance(shaking.intensity, str):
        return strength
    return phrase("ground_shaking.of_class", strength=strength, stated=shaking.strength.brief)


def class_label(intensity: float, language: str, floor: str = "") -> str:
    """Return the class of a JMA intensity: "6-upper", or "震度6強"; see `class_phrase`."""
    return say(class_phrase(intensity, floor), language)


def share_text(share: float) -> Phrase:
    """Return a share in per cent, with a word where only a bound is told: "12 %", "under 0.1 %"."""
    shown = percent(share)
    number = shown.lstrip("<>")
    both = (f"{number} %", f"{number}%")
    bound = {"<": "common.under", ">": "common.over"}.get(shown[0])
    return both if bound is None else phrase(bound, share=both)


def doubt(chance: Probability) -> Phrase | str:
    """Return, behind a statement that something hardly happens, how often it may where runs are too few."""
    if chance.high < SAFE:
        return ""
    return phrase("verification.not_ruled_out", share=share_text(chance.high))


def falls_phrase(share: float) -> Phrase:
    """Return how often it overturns: "in 12 % of the cases", "12%の場合に転倒します"."""
    key = {0.0: "verification.never_falls", 1.0: "verification.always_falls"}.get(share, "verification.falls")
    return phrase(key, share=share_text(share))


def title(option: Option, verdict: Verdict, language: str) -> str:
    """Return an option's label, in brackets behind its name where that is the user's own."""
    return _titled(option.label(language), option, verdict, language)


def _title_inside(option: Option, verdict: Verdict) -> Phrase:
    """Return an option's label within a sentence."""
    english = _titled(inside(option.label("en")), option, verdict, "en")
    return english, title(option, verdict, "ja")


def _titled(label: str, option: Option, verdict: Verdict, language: str) -> str:
    options = (result.option for result in (*verdict.options, *verdict.impossible))
    alone = sum(other.label(language) == option.label(language) for other in options) == 1
    if option.own_name:
        return with_aside(option.name, label, language)
    return label if alone or not option.measures else with_aside(label, option.name, language)


def length(metres: float) -> str:
    """Return a length as a person reads it: "0.3 cm", "12 cm", "1.5 m"."""
    if metres >= 0.995:
        return f"{metres:.1f} m"
    return f"{100.0 * metres:.0f} cm" if metres >= 0.095 else f"{100.0 * metres:.1f} cm"


def slides_off(option: OptionVerdict, verdict: Verdict) -> bool:
    """Return whether a tenth of the runs slide beyond `FAR` where the room is open to a side."""
    room = verdict.scenario.room.room()
    return math.isfinite(option.slide.p90) and option.slide.p90 > FAR and is_open(room)


def headline(verdict: Verdict, language: str) -> str:
    """Return the verdict in one sentence."""
    sentences = [say(_headline(verdict), language)]
    if verdict.best.installed is not None:
        share = share_text(verdict.best.installed.usual[OVERTURNED])
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
        share = share_text(option.installed.usual[OVERTURNED])
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
    share = option.contents.out.estimate
    if math.isnan(share):
        return phrase("verification.contents_unknown", contents=contents_name(verdict))
    key = "verification.contents_stay" if share == 0.0 else "verification.contents_out"
    return phrase(key, share=share_text(share), contents=contents_name(verdict))


def _of_contents(verdict: Verdict) -> Phrase:
    best, without = verdict.best, verdict.without
    assert best.contents is not None
    assert without.contents is not None
    share, bare = best.contents.out.estimate, without.contents.out.estimate
    clause = contents_out(best, verdict)
    stands = best.probabilities[OVERTURNED].estimate < SMALL and share >= SMALL
    aside = ""
    if best.option.measures and math.isfinite(bare):
        aside = phrase("verification.contents_without", share=share_text(bare))
    # "it" is the piece of the sentence before: that one must be of the same measure, and of no installation
    if stands and best.installed is None and (_helps(best, without) or not best.option.measures):
        return phrase("verification.stands_but", clause=clause, aside=aside)
    if not best.option.measures:
        return phrase("verification.contents_alone", clause=clause)
    measure, held = _title_inside(best.option, verdict), "held" if best.installed is None else "well_held"
    held = phrase(f"verification.{held}")
    return phrase("verification.contents_with", measure=measure, held=held, clause=clause, aside=aside)


def _helps(option: OptionVerdict, without: OptionVerdict) -> bool:
    """Return whether fewer overturn with an option than without a measure, by a share that is mentioned."""
    held, bare = option.probabilities[OVERTURNED].estimate, without.probabilities[OVERTURNED].estimate
    return bool(option.option.measures) and held < bare - SMALL


def _headline(verdict: Verdict) -> Phrase:
    what = phrase("verification.this_piece", name=verdict.scenario.piece.title)
    if math.isnan(verdict.without.probabilities[OVERTURNED].estimate):
        return phrase("verification.no_bare_run", none=phrase("verification.none"))
    if _helps(verdict.best, verdict.without):
        option = phrase("verification.if_there", option=_title_inside(verdict.best.option, verdict))
        return _better(verdict, what, option)
    more = phrase("verification.none_helps") if len(verdict.options) > 1 else ""
    return _falls_or_stands(verdict, "verification.stays_upright", what, more)


def _better(verdict: Ranked, what: Phrase, option: Phrase, bare: Phrase | str = "") -> Phrase:
    """Return how often something overturns without anything, and with the best option."""
    best, share = verdict.best, verdict.without.probabilities[OVERTURNED].estimate
    held, unclear = best.probabilities[OVERTURNED].estimate, best.change is not None and not best.change.clear
    return phrase(
        "verification.better",
        strength=shaking_phrase(verdict),
        what=what,
        falls=falls_phrase(share),
        bare=bare,
        option=option,
        then=phrase(f"verification.then_{'falls' if held else 'never'}", share=share_text(held)),
        chance=phrase("verification.may_be_chance") if unclear else "",
    )


def _falls_or_stands(
    verdict: Ranked, upright: str, what: Phrase, more: Phrase | str, bare: Phrase | str = ""
) -> Phrase:
    """Return how often something overturns without anything, or that it stays upright, by its own id."""
    chance, strength = verdict.without.probabilities[OVERTURNED], shaking_phrase(verdict)
    if chance.estimate < SMALL:
        return phrase(upright, strength=strength, what=what, doubt=doubt(chance))
    falls = falls_phrase(chance.estimate)
    return phrase("verification.bare_falls", strength=strength, what=what, falls=falls, bare=bare, more=more)


def reason(option: OptionVerdict, verdict: Verdict, language: str) -> str:
    """Return why an option stands where it does, in one plain sentence."""
    if math.isnan(option.probabilities[OVERTURNED].estimate):
        return say("verification.no_run", language)
    return sentence_of([say(part, language) for part in _reasons(option, verdict)], language)


def _overturns(option: OptionVerdict | AssemblyOptionVerdict, verdict: Ranked, where: str) -> Phrase:
    """Return how often something overturns with an option, beside how often without anything.

    What overturns, and what there is none of, is told by the catalogue's module ``where``.
    """
    bare, held = (ranked.probabilities[OVERTURNED].estimate for ranked in (verdict.without, option))
    it, change = phrase(f"{where}.it"), option.change
    if change is None:
        return phrase("verification.overturns", it=it, falls=falls_phrase(bare))
    english, japanese = share_text(held)
    amount = {0.0: "none", 1.0: "all"}.get(held, english)
    values = {"bare": share_text(bare), "held": (f"in {amount} of the cases", japanese)}
    if change.clear:
        key = "verification.less_often" if change.estimate < 0.0 else "verification.more_often"
    else:  # alike also where the difference is unknown
        key = f"{where}.by_chance" if abs(change.estimate) >= ALIKE else "verification.about_as_often"
    return phrase(key, it=it, none=phrase(f"{where}.none"), **values)


def sentence_of(clauses: list[str], language: str) -> str:
    """Return clauses as a sentence; in Japanese each is one."""
    text = "; ".join(clauses) if language == "en" else "。".join(clauses)
    return f"{text[:1].upper()}{text[1:]}." if language == "en" else f"{text}。"


def _reasons(option: OptionVerdict, verdict: Verdict) -> list[Phrase]:
    shares = {event: chance.estimate for event, chance in option.probabilities.items()}
    held = shares[OVERTURNED]
    parts = [_overturns(option, verdict, "verification")]
    if option.contents is not None:
        parts.append(contents_out(option, verdict))
        if (leaving := option.contents.leaving) is not None:
            middle, highest = length(leaving.height), length(leaving.highest)
            key = "verification.from_the_top" if middle == highest else "verification.from_shelves"
            shelves = phrase(key, height=middle, highest=highest)
            parts.append(phrase("verification.contents_leave", from_where=shelves, fast=leaving.fast))
    if shares[DEVICE_FAILED] >= 0.05:
        parts.append(phrase("verification.device_fails", share=share_text(shares[DEVICE_FAILED])))
        worst = max(option.devices, key=lambda device: device.failed.estimate, default=None)
        if worst is not None and worst.weakest is not None:
            parts.append(phrase("verification.gives_way", weakest=worst.weakest))
    if (installed := option.installed) is not None:
        usual, badly = installed.usual[OVERTURNED], installed.badly[OVERTURNED]
        alike = share_text(usual) == share_text(held) or badly.low <= held <= badly.high
        parts.append(
            phrase(
                "verification.alike_as_installed" if alike else "verification.as_installed",
                well=share_text(held),
                usual=share_text(usual),
                share=percent(installed.share),
                how=joined(installed.how),
            )
        )
    if slides_off(option, verdict):
        parts.append(phrase("verification.slides_far", far=FAR))
    elif math.isfinite(option.slide.p90) and option.slide.p90 >= 0.01:
        parts.append(phrase("verification.slides", length=length(option.slide.p90)))
    elif shares[SLID] < SMALL and shares[OVERTURNED] < SMALL:
        parts.append(phrase("verification.stays_where_it_is"))
    scenario = verdict.scenario
    body, room = scenario.piece.body(), scenario.room.room()
    cautions = (caution for measure in option.option.measures for caution in measure.cautions(body, room))
    return [*parts, *(phrase("verification.caution", caution=caution) for caution in cautions)]


OFTEN = 0.05
"""From this share on a failing device is mentioned."""


def title_of_several(
    result: AssemblyOptionVerdict | Impossible[AssemblyOption], verdict: AssemblyVerdict, language: str
) -> str:
    """Return what an option consists of, after its name where that is the user's own."""
    content = label(result.option, verdict.scenario.names)
    if not is_own(result, verdict):
        return say(content, language)
    return with_aside(result.option.name, inside(content[0]) if language == "en" else content[1], language)


def is_own(result: AssemblyOptionVerdict | Impossible[AssemblyOption], verdict: AssemblyVerdict) -> bool:
    """Return whether an option has a name of the user's own."""
    return result.option in verdict.scenario.options


def headline_of_several(verdict: AssemblyVerdict, language: str) -> str:
    """Return the verdict in one sentence."""
    best, bare = verdict.best, verdict.without.probabilities[OVERTURNED].estimate
    if math.isnan(bare):
        return say("verification.no_bare_run", language, none=phrase("several.none"))
    what, without = phrase("several.what"), phrase("several.without")
    if best.option.count and best.probabilities[OVERTURNED].estimate < bare - SMALL:
        english, japanese = (title_of_several(best, verdict, each) for each in LANGUAGES)
        english = f"“{best.option.name}”" if is_own(best, verdict) else inside(english)
        option = phrase("several.if_there", option=(english, japanese))
        return say(_better(verdict, what, option, without), language)
    more: Phrase | str = ""
    if len(verdict.options) > 1 or verdict.rejected:
        more = phrase("several.none_helps" if len(verdict.options) > 1 else "several.none_possible")
    return say(_falls_or_stands(verdict, "several.stays_upright", what, more, without), language)


def reason_of_several(result: AssemblyOptionVerdict, verdict: AssemblyVerdict, language: str) -> str:
    """Return why an option stands where it does, in one sentence."""
    if math.isnan(result.probabilities[OVERTURNED].estimate):
        return say("verification.no_run", language)
    return sentence_of([say(part, language) for part in _reasons_of_several(result, verdict)], language)


def _reasons_of_several(result: AssemblyOptionVerdict, verdict: AssemblyVerdict) -> list[Phrase]:
    parts = [_overturns(result, verdict, "several")]
    shares = [piece.probabilities[OVERTURNED].estimate for piece in result.pieces]
    counted = verdict.scenario.counted
    worst = max(counted, key=lambda number: shares[number])
    if len(counted) > 1 and shares[worst] >= SMALL:
        name = result.pieces[worst].name
        parts.append(phrase("several.most_often", name=name, share=share_text(shares[worst])))
    for number, piece in enumerate(result.pieces):
        if number not in counted and shares[number] >= SMALL:
            parts.append(phrase("several.loose", name=piece.name, falls=falls_phrase(shares[number])))
    failing = result.probabilities[DEVICE_FAILED].estimate
    if failing >= OFTEN:
        parts.append(phrase("verification.device_fails", share=share_text(failing)))
        parts += _gives_way(result)
    if math.isfinite(result.slide.p90) and result.slide.p90 >= 0.01:
        parts.append(phrase("several.slides", length=length(result.slide.p90)))
    return parts


def _gives_way(result: AssemblyOptionVerdict) -> list[Phrase]:
    """Return which device fails most often, as a clause."""
    worst = max(result.devices, key=lambda device: device.summary.failed.estimate)
    if len(worst.pieces) == 2:
        first, second = worst.pieces
        return [phrase("several.joint_fails", first=first, second=second)]
    weakest = worst.summary.weakest
    return [] if weakest is None else [phrase("several.device_of", name=worst.pieces[0], weakest=weakest)]
