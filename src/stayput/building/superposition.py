"""Modal superposition: the floors of a linear building, and of one whose storeys yield.

**Linear.** Each mode is an oscillator under the ground's acceleration a,

    q̈ⱼ + 2ζⱼωⱼ q̇ⱼ + ωⱼ² qⱼ = −Γⱼ a(t),    u = Σⱼ φⱼ qⱼ

and a is linear between its samples, so the step from (q, q̇) at one sample to the next is known exactly
(`stayput.motion.oscillator`). It is exact for any step: nothing can become unstable, and no mode is too fast.
The absolute acceleration of the floors is ü + a = −Σⱼ φⱼ (2ζⱼωⱼ q̇ⱼ + ωⱼ² qⱼ), because Σⱼ φⱼ Γⱼ = 1. Every
mode is kept, and every sum is taken in the order of the modes, so that the bits never change.

**Yielding.** A storey's shear is bilinear: Q = k δ − κ p with κ = (1 − r) k, r the ratio of the stiffness
after yielding to that before it, δ the drift, and p the plastic drift of an elastoplastic spring beside an
elastic one. That spring yields at δ_y = Q_y/k: |δ − p| ≤ δ_y, and p changes only where this is an equality.
So

    q̈ⱼ + 2ζⱼωⱼ q̇ⱼ + ωⱼ² qⱼ = −Γⱼ a + Pⱼ,    Pⱼ = Σₛ dₛⱼ κₛ pₛ

with dₛⱼ the drift of storey s in mode j. Over a sub-step a and p are taken as linear, and the step of the
modes is exact again; p at its end is such that the law of every storey holds there. The one approximation is
that p is linear over a sub-step. Without yielding it is the linear building.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stayput.building.model import ShearModel, parts_of_step
from stayput.compiling import entry, inline, inner
from stayput.errors import InputError
from stayput.motion.oscillator import step_coefficients
from stayput.motion.processing import refine

STEP_ROWS = 10
"""Rows of a step's coefficients: those of `step_coefficients`, then 2ζω and ω²."""

ENERGIES = 5
"""Columns of the energies: input, kinetic, strain, damping, plastic."""

FLOW_TOLERANCE = 1e-12
"""The sweeps end when no plastic drift changes by more than this part of its δ_y."""

MOST_SWEEPS = 10_000
"""Bound on the sweeps over the storeys in a sub-step; some ten are usual."""


@entry
def fill_step(
    omega: NDArray[np.float64], zeta: NDArray[np.float64], h: float, step: NDArray[np.float64]
) -> None:
    """Fill the coefficients of a step h [s] of every mode, shape (STEP_ROWS, n)."""
    for j in range(len(omega)):
        uu, uv, u0, u1, vu, vv, v0, v1 = step_coefficients(omega[j], zeta[j], h)
        step[0, j], step[1, j], step[2, j], step[3, j] = uu, uv, u0, u1
        step[4, j], step[5, j], step[6, j], step[7, j] = vu, vv, v0, v1
        step[8, j], step[9, j] = 2.0 * zeta[j] * omega[j], omega[j] * omega[j]


@inner
def combine(weights: NDArray[np.float64], values: NDArray[np.float64], out: NDArray[np.float64]) -> None:
    """Fill out = Σⱼ weights[j] values[j], every sum in the order of j; weights has shape (n, rows)."""
    for r in range(len(out)):
        out[r] = 0.0
    for j in range(len(values)):
        value = values[j]
        for r in range(len(out)):
            out[r] += weights[j, r] * value


@inline
def _advance(
    step: NDArray[np.float64], j: int, q: float, rate: float, a0: float, a1: float
) -> tuple[float, float]:
    """Return q and q̇ of mode j after a step over which its load goes from −a0 to −a1 along a line."""
    return (
        step[0, j] * q + step[1, j] * rate + step[2, j] * a0 + step[3, j] * a1,
        step[4, j] * q + step[5, j] * rate + step[6, j] * a0 + step[7, j] * a1,
    )


@entry
def linear_histories(
    a: NDArray[np.float64],
    step: NDArray[np.float64],
    gamma: NDArray[np.float64],
    shapes: NDArray[np.float64],
    drifts: NDArray[np.float64],
    scratch: NDArray[np.float64],
    acceleration: NDArray[np.float64],
    drift: NDArray[np.float64],
) -> None:
    """Compute the floors' absolute accelerations and the storeys' drifts at the samples of the ground.

    Parameters
    ----------
    a : ndarray, shape (m,)
        Acceleration of the ground [m/s²].
    step : ndarray, shape (STEP_ROWS, n)
        Coefficients of one step, of `fill_step`.
    gamma : ndarray, shape (n,)
        Participation of the modes.
    shapes : ndarray, shape (n, floors)
        A row for each mode, a column for each floor that is wanted.
    drifts : ndarray, shape (n, storeys)
        The same for the drifts; no columns where none are wanted.
    scratch : ndarray, shape (3, n)
        Working memory.
    acceleration : ndarray, shape (m, floors)
        Filled [m/s²].
    drift : ndarray, shape (m, storeys)
        Filled [m].
    """
    q, rate, force = scratch[0], scratch[1], scratch[2]
    for j in range(len(q)):
        q[j], rate[j], force[j] = 0.0, 0.0, 0.0
    combine(shapes, force, acceleration[0])
    combine(drifts, q, drift[0])
    for k in range(1, len(a)):
        before, now = a[k - 1], a[k]
        for j in range(len(q)):
            q[j], rate[j] = _advance(step, j, q[j], rate[j], gamma[j] * before, gamma[j] * now)
            force[j] = -(step[8, j] * rate[j] + step[9, j] * q[j])
        combine(shapes, force, acceleration[k])
        combine(drifts, q, drift[k])


@inner
def _solve_flow(
    elastic: NDArray[np.float64],
    coupling: NDArray[np.float64],
    yield_drift: NDArray[np.float64],
    kappa: NDArray[np.float64],
    flow: NDArray[np.float64],
) -> None:
    """Find the increments of the plastic drifts over a sub-step by Gauss-Seidel sweeps.

    ``elastic`` is δ − p if no storey flows; a flow of storey t adds coupling[s, t] κₜ flowₜ to the drift of
    s. A sweep meets the law of one storey after another, given the flow of the others. With g = κ flow that
    is coordinate descent on the convex function ½ gᵀ(κ⁻¹ − coupling) g − gᵀ elastic + Σ δ_y |g|, which
    converges.
    """
    for s in range(len(flow)):
        flow[s] = 0.0
    for _ in range(MOST_SWEEPS):
        change = 0.0
        for s in range(len(flow)):
            trial = elastic[s]
            for t in range(len(flow)):
                if t != s:
                    trial += coupling[s, t] * kappa[t] * flow[t]
            excess = max(abs(trial) - yield_drift[s], 0.0) / (1.0 - coupling[s, s] * kappa[s])
            new = excess if trial > 0.0 else -excess
            change = max(change, abs(new - flow[s]) / yield_drift[s])
            flow[s] = new
        if change <= FLOW_TOLERANCE:
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
    work, work_rate, damped, damped_rate = 0.0, 0.0, 0.0, 0.0
    for j in range(len(q)):
        second = load[j] - gamma[j] * a - step[8, j] * rate[j] - step[9, j] * q[j]
        work -= gamma[j] * a * rate[j]
        work_rate -= gamma[j] * (slope * rate[j] + a * second)
        damped += step[8, j] * rate[j] * rate[j]
        damped_rate += 2.0 * step[8, j] * rate[j] * second
    return work, work_rate, damped, damped_rate


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
    """Compute the same for storeys that yield, and the energies.

    Parameters
    ----------
    a, gamma, shapes
        As for `linear_histories`.
    substeps : int
        Sub-steps of a step.
    h : float
        Length of a sub-step [s].
    step : ndarray, shape (STEP_ROWS, n)
        Coefficients of one sub-step, of `fill_step`.
    drifts : ndarray, shape (n, n)
        A row for each mode, a column for each storey: all of them, as each may yield.
    coupling : ndarray, shape (n, n)
        Drift of a storey at the end of a sub-step for a unit force κp in another [m/N].
    storeys : ndarray, shape (3, n)
        k, κ [N/m] and δ_y [m] of the storeys.
    scratch : ndarray, shape (8, n)
        Working memory.
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
    work, damped, dissipated = 0.0, 0.0, 0.0
    for k in range(1, len(a)):
        slope = (a[k] - a[k - 1]) / (substeps * h)
        for part in range(substeps):
            before = a[k - 1] + (a[k] - a[k - 1]) * (part / substeps)
            now = a[k - 1] + (a[k] - a[k - 1]) * ((part + 1) / substeps)
            power, power_rate, loss, loss_rate = _powers(before, slope, step, gamma, q, rate, load)
            for j in range(len(q)):
                a0, a1 = gamma[j] * before - load[j], gamma[j] * now - load[j]
                q[j], rate[j] = _advance(step, j, q[j], rate[j], a0, a1)
            combine(drifts, q, delta)
            yields = False
            for s in range(len(q)):
                elastic[s] = delta[s] - plastic[s]
                yields = yields or abs(elastic[s]) > yield_drift[s]
            if yields:
                _solve_flow(elastic, coupling, yield_drift, kappa, flow)
                for s in range(len(q)):
                    plastic[s] += flow[s]
                    dissipated += kappa[s] * yield_drift[s] * abs(flow[s])
                # The modes' step is linear in its load, so what the flow adds to P is put in afterwards.
                for j in range(len(q)):
                    more = 0.0
                    for s in range(len(q)):
                        more += drifts[j, s] * kappa[s] * flow[s]
                    q[j] -= step[3, j] * more
                    rate[j] -= step[7, j] * more
                    load[j] += more
                combine(drifts, q, delta)
            power1, power_rate1, loss1, loss_rate1 = _powers(now, slope, step, gamma, q, rate, load)
            # The trapezoidal rule with the slopes at its ends (Hermite): exact for a cubic.
            work += 0.5 * h * (power + power1) + h * h / 12.0 * (power_rate - power_rate1)
            damped += 0.5 * h * (loss + loss1) + h * h / 12.0 * (loss_rate - loss_rate1)
        kinetic, strain = 0.0, 0.0
        for j in range(len(q)):
            force[j] = load[j] - (step[8, j] * rate[j] + step[9, j] * q[j])
            kinetic += 0.5 * rate[j] * rate[j]
        for s in range(len(q)):
            drift[k, s] = delta[s]
            rest = delta[s] - plastic[s]
            strain += 0.5 * (stiffness[s] - kappa[s]) * delta[s] * delta[s] + 0.5 * kappa[s] * rest * rest
        combine(shapes, force, acceleration[k])
        energy[k, 0], energy[k, 1], energy[k, 2] = work, kinetic, strain
        energy[k, 3], energy[k, 4] = damped, dissipated


SUBSTEPS_IN_A_PERIOD = (400.0, 16.0)
"""Fewest sub-steps in the longest and in the shortest period where storeys may yield.

The sub-step is a matter of accuracy, not of stability: the modes' steps are exact, and only the plastic
drifts are taken as linear over a sub-step. The error falls with its square, and with these numbers the
energies balance to 2e-4.
"""

MOST_SUBSTEPS = 5000
"""Most sub-steps in a step: beyond, a very stiff building would take too long."""


@dataclass(frozen=True, slots=True, eq=False)
class Energy:
    """Energies of a building's motion relative to the ground, over time.

    Parameters
    ----------
    input : ndarray, shape (n,)
        Work of the inertia forces −M1a [J].
    kinetic, strain, damping, plastic : ndarray, shape (n,)
        What became of it: kinetic and elastic energy, and what damping and yielding have taken up [J].
    """

    input: NDArray[np.float64]
    kinetic: NDArray[np.float64]
    strain: NDArray[np.float64]
    damping: NDArray[np.float64]
    plastic: NDArray[np.float64]

    @property
    def imbalance(self) -> float:
        """Largest |input − all others| over the largest input: the error of the solution."""
        rest = self.input - self.kinetic - self.strain - self.damping - self.plastic
        scale = float(np.abs(self.input).max())
        return float(np.abs(rest).max()) / scale if scale > 0.0 else 0.0


@dataclass(frozen=True, slots=True, eq=False)
class Histories:
    """Histories under one component of the ground's motion.

    Parameters
    ----------
    dt : float
        Time step [s]: the ground's, or a whole part of it.
    acceleration : ndarray, shape (n, floors)
        Absolute acceleration of the wanted floors [m/s²].
    drift : ndarray, shape (n, masses)
        Drift below each mass [m]; no columns where the drifts are not computed.
    energy : Energy or None
        Energies where storeys may yield.
    """

    dt: float
    acceleration: NDArray[np.float64]
    drift: NDArray[np.float64]
    energy: Energy | None


def component_response(
    model: ShearModel, a: NDArray[np.float64], dt: float, floors: Sequence[int], *, drifts: bool = False
) -> Histories:
    """Return the histories of the wanted floors under one component of the ground's motion.

    Parameters
    ----------
    model : ShearModel
        The building.
    a : ndarray, shape (n,)
        Acceleration of the ground [m/s²].
    dt : float
        Its time step [s].
    floors : sequence of int
        Masses from 0, the lowest; −1 is the ground.
    drifts : bool
        Whether the drifts of a linear building are wanted too; those of a yielding one are always there.

    Raises
    ------
    InputError
        A period so short that the sub-steps of yielding storeys would be too many.
    """
    modes = model.modes
    parts = parts_of_step(modes, dt)
    ground = refine(a, parts)
    h = dt / parts
    shapes = np.ascontiguousarray(modes.shapes[[i for i in floors if i >= 0]].T)
    drift_shapes = np.ascontiguousarray(modes.drifts.T)
    masses = np.empty((len(ground), shapes.shape[1]))
    step = np.empty((STEP_ROWS, len(modes.omega)))
    if model.yield_shears is None:
        shown = drift_shapes if drifts else drift_shapes[:, :0].copy()
        drift, energy = np.empty((len(ground), shown.shape[1])), None
        fill_step(modes.omega, np.array(model.damping), h, step)
        scratch = np.empty((3, len(modes.omega)))
        linear_histories(ground, step, modes.participation, shapes, shown, scratch, masses, drift)
    else:
        longest, shortest = float(modes.periods[0]), float(modes.periods[-1])
        wanted = min(longest / SUBSTEPS_IN_A_PERIOD[0], shortest / SUBSTEPS_IN_A_PERIOD[1])
        substeps = math.ceil(h / wanted - 1e-9)
        if substeps > MOST_SUBSTEPS:
            least = SUBSTEPS_IN_A_PERIOD[1] * h / MOST_SUBSTEPS
            raise InputError("building.period_too_short", "stiffnesses", period=shortest, least=least)
        fill_step(modes.omega, np.array(model.damping), h / substeps, step)
        stiffness, softened = np.array(model.stiffnesses), 1.0 - np.array(model.post_yield)
        storeys = np.stack((stiffness, softened * stiffness, np.array(model.yield_shears) / stiffness))
        # Row 3 of a step is what a unit of a at its end adds to q, so −Σ d · row 3 · d is what a unit of the
        # force κp at the end of the sub-step adds to the drifts.
        coupling = -np.einsum("js,j,jt->st", drift_shapes, step[3], drift_shapes, optimize=False)
        drift, energies = np.empty((len(ground), len(stiffness))), np.empty((len(ground), ENERGIES))
        yielding_histories(
            ground,
            substeps,
            h / substeps,
            step,
            modes.participation,
            shapes,
            drift_shapes,
            np.ascontiguousarray(coupling),
            storeys,
            np.empty((8, len(stiffness))),
            masses,
            drift,
            energies,
        )
        energy = Energy(*np.ascontiguousarray(energies.T))
    acceleration = np.empty((len(ground), len(floors)))
    acceleration[:, [i for i, floor in enumerate(floors) if floor < 0]] = ground[:, None]
    # whole 1e-6 m/s², as motions of the ground are: the last digits depend on the processor, runs shall not
    acceleration[:, [i for i, floor in enumerate(floors) if floor >= 0]] = np.round(masses, 6)
    return Histories(h, acceleration, drift, energy)
