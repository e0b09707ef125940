"""What a shell offers for a flag's value when Tab is pressed. Nothing here loads the mechanics."""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable


def words(listed: Callable[[], Iterable[str]]) -> Callable[[str], list[str]]:
    """Return the completion of a flag that takes one of some words.

    Parameters
    ----------
    listed : callable
        Gives the words; called when Tab is pressed.
    """

    def complete(incomplete: str) -> list[str]:
        fitting = [word for word in listed() if word.startswith(incomplete)]
        if "bash" in os.environ.get("_STAYPUT_COMPLETE", ""):  # the other shells quote by themselves
            return [re.sub(r"([^\w.-])", r"\\\1", word) for word in fitting]
        return fitting

    return complete


def measures() -> Iterable[str]:
    """Return the types of measure."""
    from stayput.measures import MEASURES

    return MEASURES


def surfaces() -> Iterable[str]:
    """Return the surfaces of a floor."""
    from stayput.model.room import SURFACES

    return SURFACES


def intensity_classes() -> Iterable[str]:
    """Return the classes of JMA's intensity, the weakest first."""
    from stayput.motion.intensity import CLASSES

    return [name for name, _ in CLASSES]


def intensity_measures() -> Iterable[str]:
    """Return what fragility curves are over."""
    from stayput.fragility import INTENSITY_MEASURES

    return INTENSITY_MEASURES


def families() -> Iterable[str]:
    """Return the families of synthetic motions."""
    from stayput.motion.suites import FAMILIES, MIXED

    return [MIXED, *FAMILIES]
