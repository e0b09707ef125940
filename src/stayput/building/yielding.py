"""Floors of a building whose storeys yield: modal superposition with plastic drifts as loads.

A storey's shear is bilinear: Q = k δ − κ p with κ = (1 − r) k, r the ratio of the stiffness after yielding to
that before it, δ the drift, and p the plastic drift of an elastoplastic spring that stands beside an elastic
one. That spring yields at δ_y = Q_y/k: |δ − p| ≤ δ_y, and p changes only where this is an equality. So

    q̈ⱼ + 2ζⱼωⱼ q̇ⱼ + ωⱼ² qⱼ = −Γⱼ a + Pⱼ,    Pⱼ = Σₛ dₛⱼ κₛ pₛ

with dₛⱼ the drift of storey s in mode j. Over a sub-step a and p are linear, and then the recurrence of the
linear building is exact; p at its end is such that the law of every storey holds there. Without yielding
nothing is left but the linear building.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.building.linear import combine
from stayput.compiled import entry, inner

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

ENERGIES = 5
"""Columns of the energies: input, kinetic, strain, damping, plastic."""

CLOSE = 1e-12
"""The plastic drifts of a step are found when none changes by more than this part of its δ_y."""

MOST_SWEEPS = 10_000
"""Bound on the sweeps over the storeys in a step; some ten are usual."""


@inner
def _flow(
    elastic: NDArray[np.float64],
    coupling: NDArray[np.float64],
    yield_drift: NDArray[np.float64],
    kappa: NDArray[np.float64],
    flow: NDArray[np.float64],
) -> None:
    """Find the steps of the plastic drifts, by Gauss and Seidel's sweeps.

    ``elastic`` is δ − p without flow; a flow of storey t adds coupling[s, t] κₜ flowₜ to the drift of s.
    The problem is a symmetric, positive definite one with bounds, for which the sweeps converge.
    """
    for s in range(len(flow)):
        flow[s] = 0.0
    for _ in range(MOST_SWEEPS):
        change = 0.0
        for s in range(len(flow)):
            there = elastic[s]
            for t in range(len(flow)):
                if t != s:
                    there += coupling[s, t] * kappa[t] * flow[t]
            beyond = max(abs(there) - yield_drift[s], 0.0) / (1.0 - coupling[s, s] * kappa[s])
            new = beyond if there > 0.0 else -beyond
            change = max(change, abs(new - flow[s]) / yield_drift[s])
            flow[s] = new
        if change <= CLOSE:
            return


@inner
def _powers(
    a: float,
    slope: float,
    step: NDArray[np.float64],
    gamma: NDArray[np.float64],
    q: NDArray[np.float64],
    rate: NDArray[np.float64],
    load: NDArray[np.float64],
) -> tuple[float, float, float, float]:
    """Return the powers of the ground −ΣΓ a q̇ and of the damping Σ2ζω q̇², and their rates."""
    given, given_rate, lost, lost_rate = 0.0, 0.0, 0.0, 0.0
    for j in range(len(q)):
        second = load[j] - gamma[j] * a - step[8, j] * rate[j] - step[9, j] * q[j]
        given -= gamma[j] * a * rate[j]
        given_rate -= gamma[j] * (slope * rate[j] + a * second)
        lost += step[8, j] * rate[j] * rate[j]
        lost_rate += 2.0 * step[8, j] * rate[j] * second
    return given, given_rate, lost, lost_rate


@entry
def yielding_histories(
    a: NDArray[np.float64],
    substeps: int,
    h: float,
    step: NDArray[np.float64],
    gamma: NDArray[np.float64],
    shapes: NDArray[np.float64],
    drifts: NDArray[np.float64],
    coupling: NDArray[np.float64],
    storeys: NDArray[np.float64],
    scratch: NDArray[np.float64],
    acceleration: NDArray[np.float64],
    drift: NDArray[np.float64],
    energy: NDArray[np.float64],
) -> None:
    """Find the floors' absolute accelerations, the drifts and the energies at the samples of the ground.

    Parameters
    ----------
    a : ndarray, shape (m,)
        Acceleration of the ground [m/s²].
    substeps : int
        Sub-steps of a step.
    h : float
        Length of a sub-step [s].
    step : ndarray, shape (STEP_ROWS, n)
        Coefficients of one sub-step, of `fill_step`.
    gamma : ndarray, shape (n,)
        Participation of the modes.
    shapes : ndarray, shape (n, floors)
        A row for each mode, a column for each floor that is wanted.
    drifts : ndarray, shape (n, n)
        A row for each mode, a column for each storey.
    coupling : ndarray, shape (n, n)
        Drift of a storey at the end of a sub-step for a unit force κp in another [m/N].
    storeys : ndarray, shape (3, n)
        k, κ [N/m] and δ_y [m] of the storeys.
    scratch : ndarray, shape (8, n)
        Room to work in.
    acceleration : ndarray, shape (m, floors)
        Filled [m/s²].
    drift : ndarray, shape (m, n)
        Filled [m].
    energy : ndarray, shape (m, ENERGIES)
        Filled with those of the motion relative to the ground [J].
    """
    q, rate, load, plastic, flow, elastic, delta, force = (
        scratch[0], scratch[1], scratch[2], scratch[3], scratch[4], scratch[5], scratch[6], scratch[7]
    )  # fmt: skip
    stiffness, kappa, yield_drift = storeys[0], storeys[1], storeys[2]
    scratch[:] = 0.0
    acceleration[0] = 0.0
    drift[0] = 0.0
    energy[0] = 0.0
    given, lost, spent = 0.0, 0.0, 0.0
    for k in range(1, len(a)):
        slope = (a[k] - a[k - 1]) / (substeps * h)
        for part in range(substeps):
            before = a[k - 1] + (a[k] - a[k - 1]) * (part / substeps)
            now = a[k - 1] + (a[k] - a[k - 1]) * ((part + 1) / substeps)
            power, power_rate, loss, loss_rate = _powers(before, slope, step, gamma, q, rate, load)
            for j in range(len(q)):
                a0, a1 = gamma[j] * before - load[j], gamma[j] * now - load[j]
                u, v = q[j], rate[j]
                q[j] = step[0, j] * u + step[1, j] * v + step[2, j] * a0 + step[3, j] * a1
                rate[j] = step[4, j] * u + step[5, j] * v + step[6, j] * a0 + step[7, j] * a1
            combine(drifts, q, delta)
            yields = False
            for s in range(len(q)):
                elastic[s] = delta[s] - plastic[s]
                yields = yields or abs(elastic[s]) > yield_drift[s]
            if yields:
                _flow(elastic, coupling, yield_drift, kappa, flow)
                for s in range(len(q)):
                    plastic[s] += flow[s]
                    spent += kappa[s] * yield_drift[s] * abs(flow[s])
                for j in range(len(q)):
                    more = 0.0
                    for s in range(len(q)):
                        more += drifts[j, s] * kappa[s] * flow[s]
                    q[j] -= step[3, j] * more
                    rate[j] -= step[7, j] * more
                    load[j] += more
                combine(drifts, q, delta)
            power1, power_rate1, loss1, loss_rate1 = _powers(now, slope, step, gamma, q, rate, load)
            # the trapezium with the ends' slopes: the integral of a cubic
            given += 0.5 * h * (power + power1) + h * h / 12.0 * (power_rate - power_rate1)
            lost += 0.5 * h * (loss + loss1) + h * h / 12.0 * (loss_rate - loss_rate1)
        kinetic, strain = 0.0, 0.0
        for j in range(len(q)):
            force[j] = load[j] - (step[8, j] * rate[j] + step[9, j] * q[j])
            kinetic += 0.5 * rate[j] * rate[j]
        for s in range(len(q)):
            drift[k, s] = delta[s]
            rest = delta[s] - plastic[s]
            strain += 0.5 * (stiffness[s] - kappa[s]) * delta[s] * delta[s] + 0.5 * kappa[s] * rest * rest
        combine(shapes, force, acceleration[k])
        energy[k, 0], energy[k, 1], energy[k, 2] = given, kinetic, strain
        energy[k, 3], energy[k, 4] = lost, spent
