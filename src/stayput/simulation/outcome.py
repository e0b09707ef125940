"""What became of a body."""

from __future__ import annotations

from enum import StrEnum


class Outcome(StrEnum):
    """Outcome of a run."""

    RESTED = "rested"
    SLID = "slid"
    ROCKED = "rocked"
    LEANING = "leaning"
    OVERTURNED = "overturned"
    FAILED = "failed"
