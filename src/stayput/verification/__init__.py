"""Verification: probabilities, capacity and ranking of measures, for a scenario."""

from __future__ import annotations

from stayput.verification.compare import LEVELS, SLIDE_LIMIT, verify
from stayput.verification.options import Option, options_of
from stayput.verification.verdict import EVENTS, DeviceSummary, OptionVerdict, Quantiles, Verdict

__all__ = [
    "EVENTS",
    "LEVELS",
    "SLIDE_LIMIT",
    "DeviceSummary",
    "Option",
    "OptionVerdict",
    "Quantiles",
    "Verdict",
    "options_of",
    "verify",
]
