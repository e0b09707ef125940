"""Verification: probabilities, capacity and ranking of measures, for a scenario."""

from __future__ import annotations

from stayput.montecarlo.counting import EVENTS, SLIDE_LIMIT, Quantiles
from stayput.verification.compare import LEVELS
from stayput.verification.entry import verify
from stayput.verification.options import Option
from stayput.verification.verdict import (
    AsInstalled,
    AssemblyOptionVerdict,
    AssemblyVerdict,
    DeviceSummary,
    OptionVerdict,
    PieceVerdict,
    Verdict,
)

__all__ = [
    "EVENTS",
    "LEVELS",
    "SLIDE_LIMIT",
    "AsInstalled",
    "AssemblyOptionVerdict",
    "AssemblyVerdict",
    "DeviceSummary",
    "Option",
    "OptionVerdict",
    "PieceVerdict",
    "Quantiles",
    "Verdict",
    "verify",
]
