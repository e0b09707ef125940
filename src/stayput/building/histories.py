"""One component of a building's response: which solution, which steps, and the arrays they fill."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from stayput.building.linear import STEP_ROWS, fill_step, linear_histories
from stayput.building.modes import parts_of_step
from stayput.building.yielding import ENERGIES, yielding_histories
from stayput.errors import InputError
from stayput.motion.processing import refine

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.building.model import ShearModel
    from stayput.motion.record import Motion

SUBSTEPS_IN_A_PERIOD = (400.0, 16.0)
"""Fewest sub-steps in the longest and in the shortest period where storeys may yield."""

MOST_SUBSTEPS = 5000
"""Most sub-steps of a step."""


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


def horizontal(ground: Motion) -> dict[str, NDArray[np.float64]]:
    """Return the horizontal components that are there, x first."""
    return {name: a for name, a in ground.components.items() if name != "z"}


@dataclass(frozen=True, slots=True, eq=False)
class Histories:
    """One component's histories: those of `FloorResponse`, for the wanted storeys."""

    dt: float
    acceleration: NDArray[np.float64]
    drift: NDArray[np.float64]
    energy: Energy | None


def component_response(
    model: ShearModel, a: NDArray[np.float64], dt: float, storeys: Sequence[int], *, drifts: bool = False
) -> Histories:
    """Return the histories of the wanted storeys under one component of the ground's motion.

    Parameters
    ----------
    model : ShearModel
        The building.
    a : ndarray, shape (n,)
        Acceleration of the ground [m/s²].
    dt : float
        Its time step [s].
    storeys : sequence of int
        Storeys, from 1.
    drifts : bool
        Whether the drifts are wanted too.
    """
    modes = model.modes
    parts = parts_of_step(modes, dt)
    ground = refine(a, parts)
    h = dt / parts
    above = [int(storey) - 2 + int(model.isolated) for storey in storeys]  # −1: the ground
    shapes = np.ascontiguousarray(modes.shapes[[i for i in above if i >= 0]].T)
    drift_shapes = np.ascontiguousarray(modes.drifts.T)
    masses = np.empty((len(ground), shapes.shape[1]))
    if model.yields:
        drift, energy = _yielding(model, ground, h, shapes, drift_shapes, masses)
    else:
        shown = drift_shapes if drifts else drift_shapes[:, :0].copy()
        drift = np.empty((len(ground), shown.shape[1]))
        step = np.empty((STEP_ROWS, len(modes.omega)))
        fill_step(modes.omega, np.array(model.damping), h, step)
        scratch = np.empty((3, len(modes.omega)))
        linear_histories(ground, step, modes.participation, shapes, shown, scratch, masses, drift)
        energy = None
    acceleration = np.empty((len(ground), len(above)))
    acceleration[:, [i for i, place in enumerate(above) if place < 0]] = ground[:, None]
    acceleration[:, [i for i, place in enumerate(above) if place >= 0]] = masses
    return Histories(h, acceleration, drift, energy)


def _yielding(
    model: ShearModel,
    ground: NDArray[np.float64],
    dt: float,
    shapes: NDArray[np.float64],
    drift_shapes: NDArray[np.float64],
    acceleration: NDArray[np.float64],
) -> tuple[NDArray[np.float64], Energy]:
    modes = model.modes
    longest, shortest = float(modes.periods[0]), float(modes.periods[-1])
    wanted = min(longest / SUBSTEPS_IN_A_PERIOD[0], shortest / SUBSTEPS_IN_A_PERIOD[1])
    substeps = math.ceil(dt / wanted - 1e-9)
    if substeps > MOST_SUBSTEPS:
        raise InputError(
            f"The building's shortest period is {shortest:g} s; with yielding storeys it must be at least "
            f"{SUBSTEPS_IN_A_PERIOD[1] * dt / MOST_SUBSTEPS:.2g} s."
        )
    h = dt / substeps
    step = np.empty((STEP_ROWS, len(modes.omega)))
    fill_step(modes.omega, np.array(model.damping), h, step)
    stiffness, ratio = np.array(model.stiffnesses), np.array(model.post_yield)
    storeys = np.stack((stiffness, (1.0 - ratio) * stiffness, np.array(model.yield_shears) / stiffness))
    coupling = -np.einsum("js,j,jt->st", drift_shapes, step[3], drift_shapes, optimize=False)
    drift = np.empty((len(ground), len(stiffness)))
    energy = np.empty((len(ground), ENERGIES))
    yielding_histories(
        ground,
        substeps,
        h,
        step,
        modes.participation,
        shapes,
        drift_shapes,
        np.ascontiguousarray(coupling),
        storeys,
        np.empty((8, len(stiffness))),
        acceleration,
        drift,
        energy,
    )
    return drift, Energy(*np.ascontiguousarray(energy.T))
