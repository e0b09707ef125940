"""Verification: probabilities, capacity and ranking of measures, for a scenario."""

from __future__ import annotations

from stayput.verify.options import Option, options_of
from stayput.verify.verdict import EVENTS, DeviceSummary, OptionVerdict, Quantiles, Verdict
from stayput.verify.verify import LEVELS, SLIDE_LIMIT, verify

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
