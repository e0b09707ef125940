"""Parameters of measures: defaults with their unit, range, confidence, and names in English and Japanese.

How well a result is founded is told by a grade, that of the weakest of the inputs that decide it.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, cast

from stayput.catalogue import LANGUAGES, phrase, say
from stayput.errors import InputError, within
from stayput.uncertainty import Confidence

if TYPE_CHECKING:
    from collections.abc import Mapping

    from stayput.catalogue import Phrase

GIVEN = "given"
"""Tag of a value that the user has given himself, beside those of `stayput.uncertainty.Confidence`."""


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


@dataclass(frozen=True, slots=True)
class Parameter:
    """What is known of one parameter of a measure.

    Attributes
    ----------
    name : str
        Its name in Python and in a scenario.
    default : float, int, str or None
        Its default; None where it is taken from the room.
    unit : str
        SI unit; "" for a plain number.
    low, high : float
        Smallest and largest value that is accepted.
    confidence : Confidence
        How well founded the default is.
    label : tuple of str
        What it is called, in English and Japanese.
    choices : tuple of str
        The words that are accepted, where it is a word.
    decides : bool
        Whether the outcome hangs on it and only the product or the wall can tell it: strength, grip, slack.
        How many there are and where is the user's choice; stiffness and damping change little beside these.
    """

    name: str
    default: float | int | str | None
    unit: str
    low: float
    high: float
    confidence: Confidence
    label: tuple[str, str]
    choices: tuple[str, ...] = ()
    decides: bool = False

    def tag(self, value: object) -> str:
        """Return how well founded a value is: its confidence if it is the default, else `GIVEN`."""
        return self.confidence.value if value == self.default else GIVEN


def parameter(
    default: float | None,
    unit: str,
    low: float,
    high: float,
    label: tuple[str, str],
    confidence: Confidence = Confidence.LOW,
    *,
    decides: bool = False,
) -> Any:
    """Return the field of a measure for a number; a default that is an int takes whole numbers only."""
    about = {
        "unit": unit,
        "low": low,
        "high": high,
        "confidence": confidence,
        "label": label,
        "decides": decides,
    }
    return dataclasses.field(default=default, metadata=about)


def choice(
    default: str, choices: tuple[str, ...], label: tuple[str, str], confidence: Confidence = Confidence.LOW
) -> Any:
    """Return the field of a measure for one of several words."""
    about = {
        "unit": "",
        "low": 0.0,
        "high": 0.0,
        "confidence": confidence,
        "label": label,
        "choices": choices,
    }
    return dataclasses.field(default=default, metadata=about)


def parameters(measure: Any) -> tuple[Parameter, ...]:
    """Return the parameters of a measure, or of a kind of measure, in their order."""
    return tuple(Parameter(f.name, cast("Any", f.default), **f.metadata) for f in dataclasses.fields(measure))


def check(about: Parameter, value: Any, measure: Phrase) -> None:
    """Refuse a value that a parameter cannot have.

    Raises
    ------
    InputError
        Not one of the words, not a number, out of range, or not whole where it counts something.
    """
    name = phrase("measures.parameter", measure=measure, name=(about.name, about.label[1]))
    if about.choices:
        if value not in about.choices:
            words = tuple(say("measures.or", lang).join(map(repr, about.choices)) for lang in LANGUAGES)
            raise InputError("measures.wrong_word", about.name, name=name, value=repr(value), words=words)
    elif value is not None or about.default is not None:
        number = within(name, cast("float", value), about.low, about.high, about.unit, about.name)
        if isinstance(about.default, int) and not number.is_integer():
            raise InputError("common.not_whole", about.name, name=name, value=number)
