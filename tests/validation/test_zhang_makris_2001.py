"""J. Zhang and N. Makris (2001), Rocking response of free-standing blocks under cycloidal pulses, J. Eng.
Mech. 127(5), 473-483: bands of overturning with impact and without, of the nonlinear equations; and the edges
of other pulses with reference numbers, as the boundary tracer finds them.

e is the ratio of the rotation rates at a landing; the floor's restitution is on top of Housner's ratio.
"""

import math

import numpy as np
import pytest
from equations import Rocking
from setups import STICKING, G, block

import stayput as sp
from stayput.simulation.boundary import trace_boundary

ALPHA, E, P = 0.25, 0.9, 2.14
BANDS = [3.032, 6.743, 7.493]
FACTOR = E / (1.0 - 1.5 * math.sin(ALPHA) ** 2)


def their_block() -> sp.Body:
    R = 3.0 * G / (4.0 * P**2)
    return sp.Body(2.0 * R * math.sin(ALPHA), 2.0 * R * math.cos(ALPHA), 100.0)


@pytest.mark.parametrize("law", ["coulomb", "paper"])
def test_bands_at_five(law):
    length = 2.0 * math.pi / (5.0 * P)
    motion = sp.sine(ALPHA * G, 1.0 / length, length, dt=length / 500, quiet=10.0)
    room = sp.Room(sp.Floor(3.0, 3.0, restitution=FACTOR))
    found = trace_boundary(
        sp.Case(their_block(), room, motion, law, gravity=G), np.arange(1.0, 12.0, 0.25), tolerance=1e-5
    )
    assert found["amplitude"].values == pytest.approx(BANDS, rel=2e-4)
    assert found["direction"].values.tolist() == [1, -1, 1]
    assert found["floor_impacts"].values.tolist() == [1, 1, 0]


@pytest.mark.parametrize(("edge", "falls_above"), list(zip(BANDS, [True, False, True], strict=True)))
@pytest.mark.parametrize("side", [-1, 1])
def test_bands_by_equations_written_anew(edge, falls_above, side):
    """The reference numbers themselves, by SciPy."""
    body, omega = their_block(), 5.0 * P
    amplitude = edge * (1.0 + 1e-3 * side) * ALPHA * G
    length = 2.0 * math.pi / omega

    def along(t: float) -> float:
        return amplitude * math.sin(omega * t) if t < length else 0.0

    uplift = math.asin(G * math.tan(ALPHA) / amplitude) / omega
    kinks = np.append(length, length + 0.1 * np.arange(1, 60))
    peer = Rocking(body, along, lambda _: 0.0, list(kinks), FACTOR)
    states = peer.run(0.0, 0.0, -1, start=uplift, most=4)
    assert (np.abs(states[0]).max() > math.pi / 2) is np.bool_(falls_above == (side > 0))


def test_island_of_one_sine_of_half_a_second():
    motion = sp.sine(G, 2.0, 0.5, dt=1e-3, quiet=10.0)
    found = trace_boundary(
        sp.Case(sp.Body(0.4, 1.8, 100.0), sp.Room(STICKING), motion, gravity=G), np.arange(0.2, 2.0, 0.05)
    )
    assert found["amplitude"].values == pytest.approx([0.45479, 1.29455, 1.36757], rel=5e-4)


@pytest.mark.parametrize(("ratio", "reference"), [(3, 2.2973), (5, 3.2989), (8, 4.8073)])
def test_half_sine(ratio, reference):
    b, h = 0.2, 0.8
    length = math.pi / (ratio * math.sqrt(3 * G / (4 * math.hypot(b, h))))
    motion = sp.pulse("half-sine", G * b / h, length, quiet=8.0)
    case = sp.Case(block(b, h), sp.Room(STICKING), motion, gravity=G)
    found = trace_boundary(case, np.arange(0.5, 8.0, 0.25), edge="first")
    assert float(found["amplitude"]) == pytest.approx(reference, rel=1e-3)
    assert int(found["islands"]) == 0


@pytest.mark.parametrize(("length", "reference"), [(0.1, 0.97221), (0.2, 0.55697), (0.5, 0.32219)])
def test_rectangular_pulse(length, reference):
    motion = sp.pulse("rectangular", G, length, dt=5e-4, quiet=8.0)
    case = sp.Case(block(0.2, 0.8), sp.Room(STICKING), motion, gravity=G)
    found = trace_boundary(case, np.arange(0.2, 1.5, 0.05), edge="first")
    assert float(found["amplitude"]) == pytest.approx(reference, rel=3e-3)
