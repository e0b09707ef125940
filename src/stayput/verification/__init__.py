"""Verification: probabilities, capacity and ranking of measures, for a scenario."""

from __future__ import annotations

from stayput.verification.entry import verify
from stayput.verification.verdict import Verdict

__all__ = ["Verdict", "verify"]
