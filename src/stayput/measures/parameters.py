"""Parameters of measures: words to choose from, how a wrong value is refused, and grades of their confidence.

How well a result is founded is told by a grade, that of the weakest of the inputs that decide it.
"""

from __future__ import annotations

from enum import StrEnum
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from stayput.catalogue import LANGUAGES, phrase, say
from stayput.errors import InputError
from stayput.model.parameters import GIVEN, parameter
from stayput.uncertainty import Confidence

if TYPE_CHECKING:
    from collections.abc import Mapping

    from stayput.catalogue import Phrase
    from stayput.model.parameters import Parameter


class Grade(StrEnum):
    """How well an input, or a result that rests on it, is founded; the order is from the best."""

    A = "A"
    B = "B"
    C = "C"


GRADE_OF: Mapping[str, Grade] = MappingProxyType(
    {
        GIVEN: Grade.A,
        Confidence.HIGH.value: Grade.A,
        Confidence.MEDIUM.value: Grade.B,
        Confidence.LOW.value: Grade.C,
    }
)
"""The grade of each tag: what the user gives counts as known."""

MEANINGS: Mapping[Grade, tuple[str, str]] = MappingProxyType(
    {
        Grade.A: (
            "measured, from a standard, or given by you",
            "測定値・規格値、または利用者の指定",
        ),
        Grade.B: (
            "published or usual values that scatter",
            "公表値または一般的な値。ばらつきあり",
        ),
        Grade.C: (
            "assumed defaults; replace them by your own",
            "仮定した既定値。実際の値に置き換えが必要",
        ),
    }
)
"""What each grade means, in English and Japanese."""


def choice(
    default: str, choices: tuple[str, ...], label: Phrase, confidence: Confidence = Confidence.LOW
) -> Any:
    """Return the field of a measure for one of several words."""
    return parameter(default, "", 0.0, 0.0, label, confidence=confidence, choices=choices)


def check(about: Parameter, value: Any, measure: Phrase) -> None:
    """Refuse a value that a parameter cannot have.

    Raises
    ------
    InputError
        Not one of the words, not a number, out of range, or not whole where it counts something.
    """
    name = phrase("measures.parameter", measure=measure, name=(about.name, about.label[1]))
    if not about.choices:
        if value is not None or about.default is not None:
            about.check(value, called=name)
    elif value not in about.choices:
        words = tuple(say("measures.or", lang).join(map(repr, about.choices)) for lang in LANGUAGES)
        raise InputError("measures.wrong_word", about.name, name=name, value=repr(value), words=words)
