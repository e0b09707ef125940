"""The solvers are compiled once, before the first test of any run.

Compiling takes about a minute, which no test with a time limit, and no example with a deadline, should pay.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import pytest


def load_solvers() -> None:
    """Run each compiled entry point of the mechanics once: from the cache on disk, or compiled into it."""
    from stayput import Body, Room, State
    from stayput.mechanics.devices.runner import no_elements, trace_with_devices
    from stayput.mechanics.runner import shaking, trace
    from stayput.simulation.flat_fields import case_columns

    (case,) = case_columns(Body(0.4, 1.6), Room(), State(), 9.81)
    motion = shaking(np.zeros(2), None, 0.01, 0)
    trace(case, motion)
    trace_with_devices(case, no_elements(1), motion)


def pytest_sessionstart(session: pytest.Session) -> None:
    """Load the solvers in each process of a run.

    Under pytest-xdist the controller comes here before it starts its workers (its own hook is the last): it
    alone compiles, and the workers load from the disk.
    """
    if not session.config.option.collectonly:
        load_solvers()
