"""N. Makris and Y. Roussos (2000), Rocking response of rigid blocks under near-source ground motions,
Géotechnique 50(3), 243-262; X. Zhang and N. Makris (2001), Rocking response of free-standing blocks under
cycloidal pulses, J. Eng. Mech. 127(5), 473-483.

Half-sine pulses (Housner's 1963 condition for them is wrong), and the island of safety of one full sine
between overturning with one impact and without. Numbers of the nonlinear equations.
"""

import math

import pytest
from setups import STICKING, G, block, both_laws, first, impacts, simulate, threshold

import stayput as sp

ON_STICKING = sp.Room(STICKING)


def one_sine(part_of_g: float, period: float, quiet: float) -> sp.Motion:
    return sp.sine(part_of_g * G, 1.0 / period, period, dt=period / 2000, quiet=quiet)


@both_laws
@pytest.mark.parametrize(("ratio", "reference"), [(3, 2.2973), (5, 3.2989), (8, 4.8073)])
def test_half_sine_overturns(law, ratio, reference):
    b, h = 0.2, 0.8
    omega = ratio * math.sqrt(3 * G / (4 * math.hypot(b, h)))
    length = math.pi / omega

    def falls(part: float) -> bool:
        motion = sp.pulse("half-sine", part * G * b / h, length, dt=length / 1000, quiet=8.0)
        return simulate(block(b, h), ON_STICKING, motion, law).overturned

    assert threshold(falls, 0.95 * reference, 1.05 * reference, halvings=16) == pytest.approx(
        reference, rel=5e-5
    )


def after_the_sine(part: float, law: str) -> sp.Run:
    return simulate(sp.Body(0.4, 1.8, 100.0), ON_STICKING, one_sine(part, 0.5, 10.0), law)


@both_laws
@pytest.mark.parametrize(
    ("below", "edge", "above"), [(0.40, 0.45479, 0.60), (1.20, 1.29455, 1.33), (1.33, 1.36757, 1.45)]
)
def test_edges_of_the_safe_island_of_one_sine(law, below, edge, above):
    found = threshold(lambda part: after_the_sine(part, law).overturned, below, above, halvings=16)
    assert found == pytest.approx(edge, rel=1e-4)


@both_laws
@pytest.mark.parametrize(("part", "falls", "landings"), [(0.5, True, 1), (1.33, False, 2), (1.40, True, 0)])
def test_how_it_falls_on_either_side_of_the_island(law, part, falls, landings):
    run = after_the_sine(part, law)
    assert run.overturned is falls
    if falls:
        assert run.floor_impacts == landings
    else:
        assert run.floor_impacts >= landings
        assert abs(run.residual_tilt) < 0.02
        assert run.peak_tilt > 0.1


@both_laws
def test_time_history_of_one_sine(law):
    b, h, period = 0.225, 0.9, 0.5
    run = simulate(block(b, h), ON_STICKING, one_sine(0.4, period, 2.5), law)
    uplift = first(run, sp.EventKind.UPLIFT).time
    assert uplift == pytest.approx(math.asin(b / h / 0.4) * period / (2 * math.pi), abs=1e-6)
    assert uplift == pytest.approx(0.053725, abs=1e-6)
    assert [e.time for e in impacts(run)[:2]] == pytest.approx([0.363999, 1.19991], rel=2e-5)
    assert run.peak_tilt / math.atan(b / h) == pytest.approx(0.41983, rel=2e-4)
