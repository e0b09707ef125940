"""A verdict in plain sentences, English and Japanese."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from stayput.fragility.probabilities import percent
from stayput.motion.intensity import intensity_class
from stayput.verification.verdict import DEVICE_FAILED, HIT_WALL, OVERTURNED, SLID

if TYPE_CHECKING:
    from stayput.verification.options import Option
    from stayput.verification.verdict import OptionVerdict, Verdict

LANGUAGES = ("en", "ja")

ALIKE = 0.05
"""Shares that differ by less than this, and not clearly, are called about the same."""

_CLASSES_JA = {"5-lower": "5弱", "5-upper": "5強", "6-lower": "6弱", "6-upper": "6強"}

EVENT_LABELS = {
    OVERTURNED: ("overturns", "転倒"),
    SLID: ("slides too far", "大きく移動"),
    HIT_WALL: ("hits a wall", "壁に衝突"),
    DEVICE_FAILED: ("a device fails", "器具が破損"),
}
"""The events, in English and Japanese."""


def class_label(intensity: float, language: str) -> str:
    """Return the class of a JMA intensity: "6-upper", or "震度6強"."""
    name = intensity_class(intensity)
    return name if language == "en" else f"震度{_CLASSES_JA.get(name, name)}"


def _percent(share: float, language: str) -> str:
    return f"{percent(share)} %" if language == "en" else f"{percent(share)}%"


def _of_the_cases(share: float) -> str:
    """Return a share in English: "in 12 % of the cases", "in none of the cases"."""
    amount = {0.0: "none", 1.0: "all"}.get(share, _percent(share, "en"))
    return f"in {amount} of the cases"


def _centimetres(length: float) -> str:
    return f"{100.0 * length:.0f} cm" if length >= 0.095 else f"{100.0 * length:.1f} cm"


def title(option: Option, verdict: Verdict, language: str) -> str:
    """Return what an option is called; with the user's name for it where another has the same measures."""
    label = option.label(language)
    alike = sum(one.option.label(language) == label for one in verdict.options)
    if alike == 1:
        return label
    return f"{label} ({option.name})" if language == "en" else f"{label}（{option.name}）"


def headline(verdict: Verdict, language: str) -> str:
    """Return the verdict in one sentence."""
    without, best = verdict.without, verdict.best
    name = verdict.scenario.furniture.title
    falls = without.probabilities[OVERTURNED].estimate
    if math.isnan(falls):
        told = "No run without a measure could be followed to its end, so nothing can be said."
        return told if language == "en" else "対策なしの計算が最後まで進まなかったため、判定できません。"
    strength = class_label(verdict.intensity, language)
    if best.option.measures and best.probabilities[OVERTURNED].estimate < falls - 0.005:
        held = best.probabilities[OVERTURNED].estimate
        label = title(best.option, verdict, language)
        unclear = best.change is not None and not best.change.clear
        if language == "en":
            chance = ", which may be chance: the runs are too few" if unclear else ""
            return (
                f"In shaking of JMA intensity {strength} the {name} overturns {_of_the_cases(falls)}; "
                f"with {_lowered(label)}, {_of_the_cases(held).removesuffix(' of the cases')}{chance}."
            )
        chance = "計算数が少なく、偶然の差かもしれません。" if unclear else ""
        told = f"{strength}の揺れで、この家具は{_percent(falls, language)}の場合に転倒します。"
        if held == 0.0:
            return f"{told}{label}があれば、計算した場合のいずれでも転倒しません。{chance}"
        return f"{told}{label}があれば{_percent(held, language)}です。{chance}"
    if language == "en":
        if falls < 0.005:
            return f"In shaking of JMA intensity {strength} the {name} stays upright without any measure."
        return (
            f"In shaking of JMA intensity {strength} the {name} overturns {_of_the_cases(falls)}, "
            "and no measure that was compared makes it clearly less."
        )
    if falls < 0.005:
        return f"{strength}の揺れでも、この家具は対策なしで転倒しません。"
    told = f"{strength}の揺れで、この家具は{_percent(falls, language)}の場合に転倒します。"
    return f"{told}比較した対策では明らかには減りません。"


def _lowered(label: str) -> str:
    return label[:1].lower() + label[1:] if not label[:2].isupper() and label[1:2] != "-" else label


def reason(option: OptionVerdict, verdict: Verdict, language: str) -> str:
    """Return why an option stands where it does, in one plain sentence."""
    english = language == "en"
    shares = {event: found.estimate for event, found in option.probabilities.items()}
    falls = verdict.without.probabilities[OVERTURNED].estimate
    if math.isnan(shares[OVERTURNED]):
        told = "No run could be followed to its end."
        return told if english else "最後まで進んだ計算がありません。"
    parts: list[str] = []
    if option.change is None:
        parts.append(
            f"it overturns {_of_the_cases(falls)}"
            if english
            else f"{_percent(falls, language)}の場合に転倒します"
        )
    elif not option.change.clear and not abs(option.change.estimate) >= ALIKE:  # nor where it is unknown
        parts.append(
            "it overturns about as often as without a measure"
            if english
            else "転倒する割合は対策なしと明らかな差がありません"
        )
    elif not option.change.clear:
        bare, held = _percent(falls, language), _percent(shares[OVERTURNED], language)
        parts.append(
            f"it overturns {_of_the_cases(shares[OVERTURNED])} instead of {bare}, which may be chance"
            if english
            else f"転倒は対策なしの{bare}に対し{held}ですが、偶然の差かもしれません"
        )
    elif option.change.estimate < 0.0:
        parts.append(
            f"it overturns {_of_the_cases(shares[OVERTURNED])} instead of {_percent(falls, language)}"
            if english
            else f"転倒は{_percent(falls, language)}から{_percent(shares[OVERTURNED], language)}に減ります"
        )
    else:
        parts.append(
            f"it overturns more often than without a measure, {_of_the_cases(shares[OVERTURNED])}"
            if english
            else f"転倒は対策なしより増えて{_percent(shares[OVERTURNED], language)}です"
        )
    if shares[DEVICE_FAILED] >= 0.05:
        parts.append(
            f"a device fails in {_percent(shares[DEVICE_FAILED], language)}"
            if english
            else f"器具は{_percent(shares[DEVICE_FAILED], language)}の場合に破損または脱落します"
        )
    if math.isfinite(option.slide.p90) and option.slide.p90 >= 0.01:
        parts.append(
            f"in nine of ten it slides by {_centimetres(option.slide.p90)} at most"
            if english
            else f"10回中9回は移動が{_centimetres(option.slide.p90)}以内です"
        )
    elif shares[SLID] < 0.005 and shares[OVERTURNED] < 0.005:
        parts.append("it stays where it is" if english else "その場に留まります")
    text = "; ".join(parts) if english else "。".join(parts)
    return f"{text[:1].upper()}{text[1:]}." if english else f"{text}。"
