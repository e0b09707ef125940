"""Free flight of a body of three moments of inertia, beside Jacobi's elliptic functions."""

import math

import numpy as np
import pytest
from in_space import energy, inertia_over_time, still
from scipy.special import ellipj, ellipk

import stayput as sp

STONE = sp.Body.box(0.3, 0.5, 0.9, 40.0)


def free_top(moments: np.ndarray, start: np.ndarray, times: np.ndarray) -> tuple[np.ndarray, float]:
    """Rotation rates in the principal axes, and the period, of Euler's equations (Landau & Lifshitz I, § 37).

    For I₁ < I₂ < I₃ and L² > 2 E I₂, with ω₂ = 0 at first: ω₁ = a₁ cn τ, ω₂ = a₂ sn τ, ω₃ = a₃ dn τ with
    τ = t √((I₃ − I₂)(L² − 2 E I₁)/(I₁ I₂ I₃)) and m = (I₂ − I₁)(2 E I₃ − L²)/((I₃ − I₂)(L² − 2 E I₁)).
    """
    i1, i2, i3 = moments
    E, L = moments @ start**2, (moments * start) @ (moments * start)  # 2 E and L²
    assert E * i2 < L
    rate = math.sqrt((i3 - i2) * (L - E * i1) / (i1 * i2 * i3))
    m = (i2 - i1) * (E * i3 - L) / ((i3 - i2) * (L - E * i1))
    sn, cn, dn, _ = ellipj(rate * times, m)
    a2 = math.sqrt((E * i3 - L) / (i2 * (i3 - i2)))
    turns = np.sign(start[0] * start[2])  # ω₂' = (I₃ − I₁) ω₃ ω₁/I₂
    return np.column_stack((start[0] * cn, turns * a2 * sn, start[2] * dn)), 4.0 * ellipk(m) / rate


@pytest.mark.parametrize("start", [(3.0, 0.0, 4.0), (-4.0, 0.0, 6.0), (0.5, 0.0, 6.0)])
def test_the_free_top(start: tuple[float, float, float]) -> None:
    """The stone's axes x, y, z have the moments I₃ > I₂ > I₁: the principal axes in order are z, y, −x."""
    x, y, z = np.diag(STONE.solid.inertia)
    moments = np.array([z, y, x])
    assert z < y < x
    first = np.array(start)
    duration = free_top(moments, first, np.zeros(1))[1]
    motion = still(duration, duration / 200)
    spin = (-start[2], start[1], start[0])
    errors = []
    for step in (1e-3, 2.5e-4):
        thrown = sp.Piece(STONE, (0.0, 0.0, 90.0), velocity=(1.0, -2.0, 3.0), rotation_rate=spin)
        run = sp.simulate(thrown, sp.Room(), motion, step=step)
        own = np.einsum("sij,si->sj", run.turn[0], run.rotation_rate[0])
        exact, _ = free_top(moments, first, run.time)
        errors.append(np.abs(np.column_stack((own[:, 2], own[:, 1], -own[:, 0])) - exact).max())
        assert np.ptp(energy(run)) < 1e-9 * energy(run)[0]
        momentum = np.einsum("sij,sj->si", inertia_over_time(run), run.rotation_rate[0])
        assert np.abs(momentum - momentum[0]).max() < 1e-9 * np.abs(momentum[0]).max()
    assert errors[1] < 1e-9 * np.linalg.norm(first)
    assert errors[1] < errors[0] / 30.0 or errors[0] < 1e-11  # Runge and Kutta's fourth order


@pytest.mark.parametrize("nudge", [0.1, 0.01])
def test_the_time_between_flips(nudge: float) -> None:
    """About its middle axis it turns over each half period, 2 K(m)/rate: longer, the less it is nudged."""
    x, y, z = np.diag(STONE.solid.inertia)
    # with ω₁ = 0 at first the quarter of the period is shifted: the same ω₁, ω₃ beside a large ω₂
    spin, side = 12.0, nudge * math.sqrt(z / x)
    E = x * side**2 + y * spin**2 + z * nudge**2
    L = (x * side) ** 2 + (y * spin) ** 2 + (z * nudge) ** 2
    rate = math.sqrt((x - y) * (L - E * z) / (x * y * z))
    m = (y - z) * (E * x - L) / ((x - y) * (L - E * z))
    if m > 1.0:  # nearer to the other axis: L² < 2 E I₂
        rate, m = rate * math.sqrt(m), 1.0 / m
    half = 2.0 * ellipk(m) / rate
    thrown = sp.Piece(STONE, (0.0, 0.0, 90.0), velocity=(0.0, 0.0, 30.0), rotation_rate=(side, spin, nudge))
    run = sp.simulate(thrown, sp.Room(), still(2.2 * half, 0.001), step=5e-4)
    own = np.einsum("si,si->s", run.turn[0, :, :, 1], run.rotation_rate[0])
    k = np.flatnonzero(np.diff(np.sign(own)))
    crossed = run.time[k] + 0.001 * own[k] / (own[k] - own[k + 1])
    assert len(crossed) >= 2
    np.testing.assert_allclose(np.diff(crossed), half, rtol=1e-5)
