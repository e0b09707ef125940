"""Parameters of measures: defaults with their unit, range, confidence, and names in English and Japanese."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import Any, cast

from stayput.errors import InputError, within
from stayput.uncertainty import Confidence


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
    """

    name: str
    default: float | int | str | None
    unit: str
    low: float
    high: float
    confidence: Confidence
    label: tuple[str, str]
    choices: tuple[str, ...] = ()


def parameter(
    default: float | None,
    unit: str,
    low: float,
    high: float,
    label: tuple[str, str],
    confidence: Confidence = Confidence.LOW,
) -> Any:
    """Return the field of a measure for a number; a default that is an int takes whole numbers only."""
    about = {"unit": unit, "low": low, "high": high, "confidence": confidence, "label": label}
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


def check(about: Parameter, value: Any, title: str) -> None:
    """Refuse a value that a parameter cannot have.

    Raises
    ------
    InputError
        Not one of the words, not a number, out of range, or not whole where it counts something.
    """
    name = f"{title} {about.name}"
    if about.choices:
        if value not in about.choices:
            words = " or ".join(repr(word) for word in about.choices)
            raise InputError(f"{name} is {value!r}; it must be {words}.")
    elif value is not None or about.default is not None:
        number = within(name, cast("float", value), about.low, about.high, about.unit)
        if isinstance(about.default, int) and not number.is_integer():
            raise InputError(f"{name} is {number:g}; it must be a whole number.")
