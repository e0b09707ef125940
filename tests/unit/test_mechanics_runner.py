"""Python interface of the solver: a batch gives the bits of single runs."""

import numpy as np
import pytest
from mechanics_runs import case_of

from stayput.mechanics import columns as col
from stayput.mechanics.runner import run_cases, shaking, trace

RECORD = 4.0 * np.sin(0.06 * np.arange(500))


@pytest.mark.parametrize("law", [0, 1])
def test_a_batch_gives_the_bits_of_each_case_alone_and_of_its_history(law):
    motion = shaking(RECORD, 0.3 * RECORD, 0.01, law)
    cases = np.array([case_of(tilt=tilt) for tilt in (0.0, 0.02, -0.1)])
    results = run_cases(cases, motion)
    for n in range(3):
        assert results[n].tobytes() == run_cases(cases[n : n + 1], motion)[0].tobytes()
        run = trace(cases[n], motion)
        assert run.result.tobytes() == results[n].tobytes()
        assert len(run.events) == results["events"][n]


def test_the_papers_law_has_no_vertical_motion():
    assert not shaking(RECORD, RECORD, 0.01, 1).floor.az.any()
    assert shaking(RECORD, RECORD, 0.01, 0).floor.az.any()


def test_events_carry_the_state_just_after_them():
    run = trace(case_of(tilt=0.1), shaking(np.zeros(300), None, 0.01, 0))
    landing = run.events[0]
    assert landing.tilt == pytest.approx(0.0, abs=1e-12)
    assert landing.mode == col.ROCK_MODE
