r"""How the shelves of a piece move: the acceleration of a point of it, in axes that turn with it.

A point of the body at (u, v) from its centre of gravity G, in the body's axes, is at

    X = x + u cos θ + v sin θ,  Z = z − u sin θ + v cos θ

in the frame of the floor. Things on a shelf feel, along it and perpendicular to it,

    a = (ẍ_G + Ẍ) cos ψ − (z̈_G + Z̈ + g) sin ψ,  n = (ẍ_G + Ẍ) sin ψ + (z̈_G + Z̈ + g) cos ψ

with ψ = θ less the slope of the shelf: on a floor that shakes by (a, n − g) they would feel the same. Ẍ and Z̈
hold all that tilting adds: tangential, centripetal and that of G, and the impulses of landings and of walls.

The positions are known at samples; their second differences are the mean of Ẍ over two steps with the weights
of a triangle. So an impulse becomes a triangle of its own area: linear between the samples, the acceleration
has the momentum of the true one, whatever happens between them. Where the piece does not move the differences
are 0, and the shelf has the floor's acceleration to the bit.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from stayput.mechanics import columns as col
from stayput.mechanics.runner import shaking, trace
from stayput.motion.processing import refine

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.mechanics.records import Excitation

STEP = 0.0025
"""Longest time between the samples at which the piece is followed [s]: an impact lasts two of them."""


@dataclass(frozen=True, slots=True, eq=False)
class PointMotion:
    """Motion of a point of a piece.

    Attributes
    ----------
    along, up : ndarray of float64, shape [n]
        Acceleration that things there feel along the shelf, less gravity perpendicular to it: a and n − g
        of the module [m/s²].
    velocity : ndarray of float64, shape [n]
        Horizontal velocity in the frame of the floor [m/s].
    height : ndarray of float64, shape [n]
        Height above the floor [m].
    turn : ndarray of float64, shape [n]
        ψ, by which the shelf leans forwards [rad].
    """

    along: NDArray[np.float64]
    up: NDArray[np.float64]
    velocity: NDArray[np.float64]
    height: NDArray[np.float64]
    turn: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Carrier:
    """A piece of furniture as it moves, at samples no farther apart than `STEP`.

    Attributes
    ----------
    dt : float
        Time between the samples [s].
    gravity : float
        g [m/s²].
    along, up : ndarray of float64, shape [n]
        Acceleration of the floor [m/s²].
    x, z, tilt : ndarray of float64, shape [n]
        Centre of gravity [m] and θ, from upright [rad].
    centre : tuple of float
        The centre of gravity in the body's axes: right of the middle of the base, above the base [m].
    overturned, failed : bool
        Whether it turned over, after the last sample; whether its run was given up.
    """

    dt: float
    gravity: float
    along: NDArray[np.float64]
    up: NDArray[np.float64]
    x: NDArray[np.float64]
    z: NDArray[np.float64]
    tilt: NDArray[np.float64]
    centre: tuple[float, float]
    overturned: bool
    failed: bool

    @classmethod
    def of(cls, case: np.void, elements: NDArray[np.void], floor: Excitation, height: float) -> Carrier:
        """Follow a piece on a floor that moves.

        Parameters
        ----------
        case : CASE record
            The piece where it stands.
        elements : ndarray of ELEMENT, shape [n]
            What holds it.
        floor : Excitation
            How the floor moves.
        height : float
            Height of the piece [m].
        """
        parts = math.ceil(floor.dt / STEP * (1.0 - 1e-9))
        dt = floor.dt / parts
        along, up = refine(floor.ax, parts), refine(floor.az, parts)
        traced = trace(case, shaking(along, up, dt, col.COULOMB), elements)
        history = traced.history
        (u_a, u_b, _, _), (v_a, v_b, v_top, _) = case["u"].tolist(), case["v"].tolist()
        reached, scale = len(history), float(case["scale"])
        return cls(
            dt=dt,
            gravity=float(case["gravity"]),
            along=scale * along[:reached],
            up=scale * up[:reached],
            x=history[:, col.H_X],
            z=history[:, col.H_Z],
            tilt=history[:, col.H_TILT] + math.atan2(v_b - v_a, u_b - u_a),
            centre=(-0.5 * (u_a + u_b), height - v_top),
            overturned=bool(traced.result["outcome"] == col.OVERTURNED_OUTCOME),
            failed=bool(traced.result["outcome"] == col.FAILED_OUTCOME),
        )

    @cached_property
    def rotation(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Sine and cosine of θ, which all points share."""
        return np.sin(self.tilt), np.cos(self.tilt)

    def point(self, right: float, height: float, slope: float = 0.0) -> PointMotion:
        """Return the motion of a point of the piece.

        Parameters
        ----------
        right, height : float
            Its place right of the middle of the base and above the base [m].
        slope : float
            Inclination of the shelf there [rad], + where the front edge is the higher one.
        """
        u, v = right - self.centre[0], height - self.centre[1]
        sin, cos = self.rotation
        x, z = self.x + u * cos + v * sin, self.z - u * sin + v * cos
        a_x = self.along + _second_difference(x, self.dt)
        a_z = self.up + _second_difference(z, self.dt)
        turn = self.tilt - slope
        if slope != 0.0:
            sin, cos = np.sin(turn), np.cos(turn)
        return PointMotion(
            along=a_x * cos - (a_z + self.gravity) * sin,
            up=a_x * sin + a_z * cos - self.gravity * (1.0 - cos),
            velocity=np.gradient(x, self.dt) if len(x) > 1 else np.zeros(len(x)),
            height=z,
            turn=turn,
        )


def _second_difference(values: NDArray[np.float64], dt: float) -> NDArray[np.float64]:
    """Return second differences over dt², shape [n]; 0 at both ends, from which the piece starts at rest."""
    found = np.zeros(len(values))
    found[1:-1] = (values[2:] - 2.0 * values[1:-1] + values[:-2]) / dt**2
    return found
