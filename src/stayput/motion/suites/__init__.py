"""Suites of motions: synthetic families, a user's own records, target spectra."""

from __future__ import annotations

from stayput.motion.suites.families import FAMILIES, MIX
from stayput.motion.suites.suite import Suite, read_suite
from stayput.motion.suites.synthesis import MIXED, synthetic_motion, synthetic_suite
from stayput.motion.suites.target import TargetSpectrum, asce7, japanese_design, read_target

__all__ = [
    "FAMILIES",
    "MIX",
    "MIXED",
    "Suite",
    "TargetSpectrum",
    "asce7",
    "japanese_design",
    "read_suite",
    "read_target",
    "synthetic_motion",
    "synthetic_suite",
]
