"""Cases of a test that only ``make test-all`` runs."""

from __future__ import annotations

from typing import Any

import pytest


def long(*cases: Any) -> list[Any]:
    """Return cases, of one value or a tuple of several, that ``make test`` leaves out."""
    given = (case if isinstance(case, tuple) else (case,) for case in cases)
    return [pytest.param(*values, marks=pytest.mark.long) for values in given]
