"""The sentences of a verdict on several pieces; they are in `stayput.catalogue.several`."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from stayput.catalogue import phrase, say
from stayput.montecarlo.counting import DEVICE_FAILED, OVERTURNED
from stayput.verification.several_options import label
from stayput.verification.words import (
    ALIKE,
    SMALL,
    doubt,
    falls_phrase,
    length,
    of_the_cases,
    sentence_of,
    shaking_phrase,
    share_text,
)
from stayput.wording import inside, with_aside

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.verification.several_options import RejectedOption
    from stayput.verification.several_verdict import AssemblyOptionVerdict, AssemblyVerdict

OFTEN = 0.05
"""From this share on a failing device is mentioned."""


def title_of_several(
    result: AssemblyOptionVerdict | RejectedOption, verdict: AssemblyVerdict, language: str
) -> str:
    """Return what an option consists of, after its name where that is the user's own."""
    content = label(result.option, verdict.scenario)
    if not is_own(result, verdict):
        return say(content, language)
    return with_aside(result.option.name, inside(content[0]) if language == "en" else content[1], language)


def is_own(result: AssemblyOptionVerdict | RejectedOption, verdict: AssemblyVerdict) -> bool:
    """Return whether an option has a name of the user's own."""
    return result.option in verdict.scenario.options


def headline_of_several(verdict: AssemblyVerdict, language: str) -> str:
    """Return the verdict in one sentence."""
    without, best = verdict.without, verdict.best
    share = without.probabilities[OVERTURNED].estimate
    if math.isnan(share):
        return say("several.no_run", language)
    held = best.probabilities[OVERTURNED].estimate
    strength = shaking_phrase(verdict)
    falls = falls_phrase(share)
    if best.option.count and held < share - SMALL:
        unclear = best.change is not None and not best.change.clear
        then = "verification.then_never" if held == 0.0 else "verification.then_falls"
        english, japanese = (title_of_several(best, verdict, each) for each in ("en", "ja"))
        english = f"“{best.option.name}”" if is_own(best, verdict) else inside(english)
        return say(
            "several.better",
            language,
            strength=strength,
            falls=falls,
            option=(english, japanese),
            then=phrase(then, share=share_text(held)),
            chance=phrase("verification.may_be_chance") if unclear else "",
        )
    if share < SMALL:
        key = "stays_upright"
    elif len(verdict.options) > 1:
        key = "none_helps"
    else:
        key = "none_possible" if verdict.rejected else "bare_falls"
    unsure = doubt(without.probabilities[OVERTURNED])
    return say(f"several.{key}", language, strength=strength, falls=falls, doubt=unsure)


def reason_of_several(result: AssemblyOptionVerdict, verdict: AssemblyVerdict, language: str) -> str:
    """Return why an option stands where it does, in one sentence."""
    if math.isnan(result.probabilities[OVERTURNED].estimate):
        return say("verification.no_run", language)
    return sentence_of([say(part, language) for part in _reasons(result, verdict)], language)


def _reasons(result: AssemblyOptionVerdict, verdict: AssemblyVerdict) -> list[Phrase]:
    bare = verdict.without.probabilities[OVERTURNED].estimate
    held = result.probabilities[OVERTURNED].estimate
    values = {"bare": share_text(bare), "held": (of_the_cases(held), share_text(held)[1])}
    change = result.change
    parts: list[Phrase] = []
    if change is None:
        parts.append(phrase("several.overturns", falls=falls_phrase(bare)))
    elif not change.clear and not abs(change.estimate) >= ALIKE:  # nor where it is unknown
        parts.append(phrase("several.about_as_often"))
    elif not change.clear:
        parts.append(phrase("several.by_chance", **values))
    else:
        key = "several.less_often" if change.estimate < 0.0 else "several.more_often"
        parts.append(phrase(key, **values))
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
