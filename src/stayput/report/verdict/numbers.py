"""Numbers of a verdict as a person reads them, in English and Japanese."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from stayput.catalogue import TEXTS, say
from stayput.fragility.probabilities import Probability, percent
from stayput.verification.words import length as length_of
from stayput.wording import FAR, is_open

if TYPE_CHECKING:
    from stayput.fragility.curve import Capacity
    from stayput.fragility.paired import Difference
    from stayput.model.room import Room
    from stayput.montecarlo.counting import Quantiles


NO_NUMBER = "–"
"""What stands in place of a number that there is none of."""


def share(value: float, language: str) -> str:
    """Return a share in per cent: "12 %", "12%"."""
    return f"{percent(value)} %" if language == "en" else f"{percent(value)}%"


def probability(chance: Probability, language: str) -> str:
    """Return a probability in brief: "25 %", "<9 %"; unknown without any run."""
    joint = " " if language == "en" else ""
    return word("unknown", language) if chance.runs == 0 else f"{chance.brief}{joint}%"


def interval(chance: Probability, language: str) -> str:
    """Return the interval of a probability: "7 to 20 %"; an end that is told in brief is rounded as there."""
    if chance.runs == 0:
        return ""
    bound, joint = "" if "–" in chance.brief else chance.brief, " " if language == "en" else ""
    low = bound[1:] if bound.startswith(">") else percent(chance.low)
    high = f"{bound[1:] if bound.startswith('<') else percent(chance.high)}{joint}%"
    return f"{low} to {high}" if language == "en" else f"{low}～{high}"


def change(difference: Difference | None, language: str) -> str:
    """Return a difference of probabilities: "−48 to −20 points", "no clear difference"."""
    return NO_NUMBER if difference is None or difference.pairs == 0 else say(difference.texts, language)


def length(metres: float, language: str) -> str:
    """Return a length: "0.3 cm", "12 cm"; infinite is a fall."""
    if math.isnan(metres):
        return NO_NUMBER
    if math.isinf(metres):
        return word("falls", language)
    return length_of(metres)


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


def mass(kilograms: float) -> str:
    """Return a mass: "4.5 kg", "120 kg"."""
    return f"{kilograms:.0f} kg" if kilograms >= 9.95 else f"{kilograms:.2g} kg"


def speed(metres_a_second: float) -> str:
    """Return a speed: "1.8 m/s"."""
    return f"{metres_a_second:.1f} m/s" if math.isfinite(metres_a_second) else NO_NUMBER


def energy(joules: float) -> str:
    """Return an energy: "0.8 J", "230 J", "1.4 kJ"."""
    if not math.isfinite(joules):
        return NO_NUMBER
    if joules >= 995.0:
        return f"{joules / 1000.0:.1f} kJ"
    return f"{joules:.0f} J" if joules >= 9.95 else f"{joules:.1f} J"


def used(quantiles: Quantiles, language: str) -> tuple[str, ...]:
    """Return median and 90 % quantile of a utilisation; nothing where there is no strength to reach."""
    return _both(quantiles, share, language) if quantiles.p90 > 0.0 else ()


def _both(quantiles: Quantiles, show: Callable[[float, str], str], language: str) -> tuple[str, str]:
    return show(quantiles.median, language), show(quantiles.p90, language)


def moment(seconds: float, language: str) -> str:
    """Return a time: "12.3 s"."""
    return word("seconds", language, value=f"{seconds:.1f}") if math.isfinite(seconds) else NO_NUMBER


def slides(quantiles: Quantiles, room: Room, language: str) -> tuple[str, str]:
    """Return median and 90 % quantile of a slide; in an open room what is beyond `FAR` is "> 3 m"."""

    def show(slide: float, language: str) -> str:
        beyond = math.isfinite(slide) and slide > FAR and is_open(room)
        return f"> {FAR:g} m" if beyond else length(slide, language)

    return _both(quantiles, show, language)


def angles(quantiles: Quantiles, language: str) -> tuple[str, str]:
    """Return median and 90 % quantile of an angle."""
    return _both(quantiles, angle, language)


def forces(quantiles: Quantiles, language: str) -> tuple[str, str]:
    """Return median and 90 % quantile of a force."""
    return _both(quantiles, force, language)


def capacity(reached: Capacity | None, language: str) -> str:
    """Return a capacity without its interval: "6.12", "> 6.90", "< 5.50"."""
    return NO_NUMBER if reached is None else say(reached.value, language)


def capacity_interval(reached: Capacity | None, language: str) -> str:
    """Return the interval of a capacity: "5.95 to 6.33"; empty where all of it lies beyond the curve."""
    return say(reached.ends, language) if reached is not None and reached.has_interval else ""


def word(key: str, language: str, **values: object) -> str:
    """Return a text of the report in "en" or "ja", with values in it.

    Parameters
    ----------
    key : str
        Its key in `stayput.catalogue.report`, or in `stayput.catalogue.common`.
    language : str
        "en" or "ja".
    **values
        What stands in its braces.
    """
    module = "report" if f"report.{key}" in TEXTS else "common"
    return say(f"{module}.{key}", language, **values)
