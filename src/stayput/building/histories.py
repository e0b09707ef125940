"""The response of a building to one component of the ground's motion: its steps, histories and energies."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.building.modes import parts_of_step
from stayput.building.superposition import (
    ENERGIES,
    STEP_ROWS,
    fill_step,
    linear_histories,
    yielding_histories,
)
from stayput.errors import InputError
from stayput.motion.integrals import peak_velocity
from stayput.motion.processing import refine

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.building.model import ShearModel

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

    def peaks(self) -> NDArray[np.float64]:
        """Return the peaks of the floors' accelerations [m/s²] and velocities [m/s], shape (2, floors)."""
        columns = [np.ascontiguousarray(a) for a in self.acceleration.T]
        return np.array([[np.abs(a).max() for a in columns], [peak_velocity(a, self.dt) for a in columns]])


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
    acceleration[:, [i for i, floor in enumerate(floors) if floor >= 0]] = masses
    return Histories(h, acceleration, drift, energy)
