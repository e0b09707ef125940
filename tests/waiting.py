"""Waiting for what comes in its own time: as long as it takes, on any machine."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

PATIENCE = 180.0
"""How long anything may take on a machine that has much else to do [s]."""


def wait_until(so: Callable[[], object], every: float = 0.02) -> None:
    """Look again and again until something is so; fail where it never is."""
    until = time.monotonic() + PATIENCE
    while not so():
        assert time.monotonic() < until, "It did not come."
        time.sleep(every)
