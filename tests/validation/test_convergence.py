"""Convergence: the order of the scheme through impacts, slips and stops, and the times of events.

The record is smooth and coarse, so that steps divide its samples; the reference is the same run with very
short steps, and `test_integration` compares that with another integrator.
"""

import math

import numpy as np
import pytest
from scipy.integrate import quad
from setups import G, block, both_laws, impacts, room, simulate, still

import stayput as sp
from stayput.mechanics.columns import H_SLIDE, H_TILT
from stayput.mechanics.runner import Traced, shaking, trace
from stayput.model.flat_fields import case_columns

DT = 0.2  # s, of the record
STEPS = [DT / n for n in (2, 4, 8, 16)]
TIME = np.arange(16) * DT
BODY = sp.Body(0.5, 1.6, 100.0, cg_offset=(0.03, -0.1))
IMPACT, SLIP, STICK = (
    list(sp.EventKind).index(sp.EventKind(kind)) for kind in ("floor impact", "slip", "stick")
)
CASES = {  # amplitude, frequency, phase, friction, tilt; number of impacts, slips and sticks
    "three impacts": (1.873, 0.6028, 5.9886, 2.9184, 0.0726, (3, 0, 0)),
    "impacts, slip and sticks": (3.7259, 0.7814, 0.7856, 0.2828, 0.1408, (5, 1, 2)),
}
EXPECTED_ORDER = 5.5  # six and more are seen


def traced(name: str, law: str, step: float) -> Traced:
    """Run with steps of this length, whatever the error."""
    amplitude, frequency, phase, friction, tilt, _ = CASES[name]
    along = amplitude * np.sin(2 * math.pi * frequency * TIME + phase)
    floor = sp.Floor(friction, 0.85 * friction)
    case = case_columns(BODY, sp.Room(floor), sp.State(tilt=tilt), G)[0]
    number = ("coulomb", "paper").index(law)
    return trace(case, shaking(along, None, DT, number), tolerance=np.inf, max_step=step)


def errors(run: Traced, reference: Traced) -> list[float]:
    """Largest errors of tilt, slide and the times of the events."""
    assert [(e.kind, e.mode) for e in run.events] == [(e.kind, e.mode) for e in reference.events]
    history = np.abs(run.history - reference.history).max(axis=0)
    times = max(abs(e.time - r.time) for e, r in zip(run.events, reference.events, strict=True))
    return [history[H_TILT], history[H_SLIDE], times]


@both_laws
@pytest.mark.parametrize("name", CASES)
def test_order_through_events(law, name):
    reference = traced(name, law, DT / 256)
    kinds = [event.kind for event in reference.events]
    if law == "coulomb":
        assert tuple(kinds.count(kind) for kind in (IMPACT, SLIP, STICK)) == CASES[name][-1]
    else:
        assert kinds.count(IMPACT) >= 3
    table = np.array([errors(traced(name, law, step), reference) for step in STEPS])
    for column, what in enumerate(("tilt", "slide", "event times")):
        if table[0, column] < 1e-13:  # nothing slides on a sticking fulcrum
            assert what == "slide"
            assert CASES[name][-1][1] == 0
            continue
        order = np.polyfit(np.log(STEPS), np.log(table[:, column]), 1)[0]
        assert order >= EXPECTED_ORDER, f"{what}: order {order:.2f}, errors {table[:, column]}"
    assert table[-1].max() < 1e-7


@both_laws
def test_default_steps_are_as_good_as_short_ones(law):
    for name, (amplitude, frequency, phase, friction, tilt, _) in CASES.items():
        reference = traced(name, law, DT / 256)
        along = amplitude * np.sin(2 * math.pi * frequency * TIME + phase)
        floor = sp.Room(sp.Floor(friction, 0.85 * friction))
        run = simulate(BODY, floor, sp.Motion(DT, along), law, tilt=tilt)
        assert run.tilt == pytest.approx(reference.history[:, H_TILT], abs=3e-6)
        assert run.slide == pytest.approx(reference.history[:, H_SLIDE], abs=3e-6)
        assert [e.time for e in run.events] == pytest.approx([e.time for e in reference.events], abs=3e-6)


@both_laws
@pytest.mark.parametrize("part", [0.1, 0.5, 0.95])
def test_time_of_the_first_landing(law, part):
    """∫dθ/θ̇ by the energy of a free rocking block: to 1e-9 s."""
    b, h = 0.2, 0.8
    radius, alpha = math.hypot(b, h), math.atan(b / h)
    start = part * alpha

    def inverse_rate(u: float) -> float:
        tilt = start - u * u  # the rate is zero at the start
        half, middle = (start - tilt) / 2, alpha - (start + tilt) / 2
        drop = 2.0 * math.sin(middle) * math.sin(half)  # cos(α−θ₀) − cos(α−θ)
        return 2.0 * u / math.sqrt(1.5 * G / radius * drop) if u > 0 else 0.0

    tiny = 1e-6
    time, _ = quad(inverse_rate, tiny, math.sqrt(start), epsabs=1e-14, epsrel=1e-13)
    time += tiny * inverse_rate(tiny)
    run = simulate(block(b, h), room(3.0), still(3.0), law, tilt=start)
    assert impacts(run)[0].time == pytest.approx(time, abs=1e-9)
