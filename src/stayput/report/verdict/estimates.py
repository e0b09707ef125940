"""Quick estimates by formulas, as texts beside the simulation."""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.fragility import JMA_INTENSITY
from stayput.report.verdict import numbers
from stayput.report.verdict.words import word
from stayput.verification.verdict import OVERTURNED

if TYPE_CHECKING:
    from stayput.verification import Verdict


def estimate_rows(verdict: Verdict, language: str) -> list[tuple[str, str, str]]:
    """Return each formula, what it says, and the simulation beside it, as texts.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    language : str
        "en" or "ja".
    """
    found = verdict.estimates
    simulated = numbers.probability(verdict.without.probabilities[OVERTURNED], language)
    capacity = verdict.without.curves[JMA_INTENSITY].capacity(0.5) if verdict.without.curves else None
    rocking, _ = numbers.angles(verdict.without.tilt, language)

    def told(key: str, **values: object) -> str:
        return word(key, language, **values)

    median = numbers.capacity(capacity, language)
    colon = told("colon")
    beside = f"{told('overturned')}{colon}{simulated}"
    return [
        (
            told("west"),
            told("west told", value=f"{found.rocking_acceleration:.2f}"),
            f"{told('tilt')}{colon}{rocking}",
        ),
        (
            told("ishiyama"),
            told(
                "ishiyama told",
                value=f"{100.0 * found.overturning_velocity:.0f}",
                share=numbers.share(found.possible, language),
            ),
            beside,
        ),
        (
            told("kaneko"),
            told("kaneko told", share=numbers.share(found.overturning_ratio, language)),
            f"{beside}{told('listed')}{told('capacity short', share='50')}{colon}{median}",
        ),
    ]
