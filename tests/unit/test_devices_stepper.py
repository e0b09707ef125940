"""Adaptive stepping: a tighter tolerance converges to the same result."""

import numpy as np
import pytest
from mechanics_runs import case_of, tie

from stayput.mechanics.runner import shaking, trace


def test_a_tighter_tolerance_takes_more_steps_to_the_same_result():
    rows = tie((0.0, 0.8), (-0.5, 1.6), damping=np.array([[20.0, 0.0]]))
    motion = shaking(3.0 * np.sin(0.1 * np.arange(100)), None, 0.01, 0)
    rough, fine = (trace(case_of(tilt=0.01), motion, rows, error=tolerance) for tolerance in (1e-6, 1e-11))
    assert fine.result["steps"] > rough.result["steps"]
    assert rough.result["peak_tilt"] == pytest.approx(fine.result["peak_tilt"], abs=1e-5)
