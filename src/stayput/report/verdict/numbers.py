"""Numbers of a verdict as a person reads them, in English and Japanese."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from stayput.fragility.probabilities import percent
from stayput.report.verdict.words import word

if TYPE_CHECKING:
    from stayput.fragility import Capacity, Difference, Probability
    from stayput.verification import Quantiles

NO_NUMBER = "–"
"""What stands where there is nothing to tell."""


def share(value: float, language: str) -> str:
    """Return a share in per cent: "12 %", "12%"."""
    return f"{percent(value)} %" if language == "en" else f"{percent(value)}%"


def probability(found: Probability, language: str) -> str:
    """Return a probability: "12 %"; unknown without any run."""
    return word("unknown", language) if found.runs == 0 else share(found.estimate, language)


def interval(found: Probability, language: str) -> str:
    """Return the interval of a probability: "7 to 20 %"."""
    if found.runs == 0:
        return ""
    low, high = percent(found.low), share(found.high, language)
    return f"{low} to {high}" if language == "en" else f"{low}〜{high}"


def with_interval(found: Probability, language: str) -> str:
    """Return a probability with its interval: "12 % (7 to 20 %)"."""
    told, ends = probability(found, language), interval(found, language)
    return told + word("aside", language, told=ends) if ends else told


def change(found: Difference | None, language: str) -> str:
    """Return a difference of probabilities: "−35 points (−48 to −20)"."""
    if found is None or found.pairs == 0:
        return NO_NUMBER
    ends = word("between", language, low=percent(found.low), high=percent(found.high))
    joint, sign = " " if language == "en" else "", "+" if found.estimate > 0.0 else ""
    told = f"{sign}{percent(found.estimate)}{joint}{word('points', language)}"
    return told + word("aside", language, told=ends)


def length(metres: float, language: str) -> str:
    """Return a length: "0.3 cm", "12 cm"; infinite is a fall."""
    if math.isnan(metres):
        return NO_NUMBER
    if math.isinf(metres):
        return word("falls", language)
    return f"{100.0 * metres:.0f} cm" if metres >= 0.095 else f"{100.0 * metres:.1f} cm"


def angle(radians: float, language: str) -> str:
    """Return an angle: "2.3°"; infinite is a fall."""
    if math.isnan(radians):
        return NO_NUMBER
    return word("falls", language) if math.isinf(radians) else f"{math.degrees(radians):.1f}°"


def force(newtons: float, language: str) -> str:
    """Return a force: "350 N", "1.2 kN"."""
    if not math.isfinite(newtons):
        return word("unknown", language)
    if newtons >= 9950.0:
        return f"{newtons / 1000.0:.0f} kN"
    return f"{newtons / 1000.0:.1f} kN" if newtons >= 995.0 else f"{newtons:.3g} N"


def used(found: Quantiles, language: str) -> tuple[str, ...]:
    """Return median and 90 % quantile of a utilisation; nothing where there is no strength to reach."""
    return tuple(share(value, language) for value in (found.median, found.p90)) if found.p90 > 0.0 else ()


def moment(seconds: float, language: str) -> str:
    """Return a time: "12.3 s"."""
    return word("seconds", language, value=f"{seconds:.1f}") if math.isfinite(seconds) else NO_NUMBER


def lengths(found: Quantiles, language: str) -> tuple[str, str]:
    """Return median and 90 % quantile of a length."""
    return length(found.median, language), length(found.p90, language)


def angles(found: Quantiles, language: str) -> tuple[str, str]:
    """Return median and 90 % quantile of an angle."""
    return angle(found.median, language), angle(found.p90, language)


def forces(found: Quantiles, language: str) -> tuple[str, str]:
    """Return median and 90 % quantile of a force."""
    return force(found.median, language), force(found.p90, language)


def capacity(found: Capacity | None, language: str, *, brief: bool = False) -> str:
    """Return a capacity without its interval: "6.12", "> 6.90", "5.50 to 5.75"; what is unsure is marked."""
    if found is None:
        return NO_NUMBER
    show = found.measure.text
    if math.isfinite(found.estimate):
        return show(found.estimate)
    above = found.above > _least(found)
    below = math.isfinite(found.below)
    if not above and not below:
        return word("unknown", language)
    if above and below:
        told = word("between", language, low=show(found.above, unit=False), high=show(found.below))
    else:
        told = f"> {show(found.above)}" if above else f"< {show(found.below)}"
    mark = "?" if brief else word("aside", language, told=word("unsure", language))
    return told if found.sure else told + mark


def capacity_interval(found: Capacity | None, language: str) -> str:
    """Return the interval of a capacity: "5.95 to 6.33"; empty where the capacity is not a number."""
    if found is None or not math.isfinite(found.estimate):
        return ""
    show = found.measure.text
    first, last = show(found.low, unit=False), show(found.high, unit=False)
    if math.isinf(found.high):
        return (
            word("unknown", language) if found.low <= _least(found) else word("at least", language, low=first)
        )
    if found.low <= _least(found):
        return word("at most", language, high=last)
    return word("between", language, low=first, high=last)


def _least(found: Capacity) -> float:
    """Return what stands for no lower end of a capacity."""
    return -math.inf if found.measure.is_logarithm else 0.0
