"""The one exception that stayput raises for input it refuses."""

from __future__ import annotations

import math


class InputError(ValueError):
    """Input that is refused: one sentence with what is wrong, the value, and what is allowed."""


def finite(name: str, value: float) -> float:
    """Return ``value`` as a float, or raise `InputError` when it is not a finite number."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise InputError(f"{name} is {value!r}; it must be a number.") from None
    if not math.isfinite(number):
        raise InputError(f"{name} is {number}; it must be a finite number.")
    return number


def within(name: str, value: float, low: float, high: float, unit: str = "") -> float:
    """Return ``value`` as a float, or raise `InputError` when it is not in [low, high]."""
    number = finite(name, value)
    if not low <= number <= high:
        suffix = f" {unit}" if unit else ""
        raise InputError(f"{name} is {number:g}{suffix}; it must be between {low:g} and {high:g}{suffix}.")
    return number
