r"""How the shelves of a piece move: the acceleration of a point of it, in axes that turn with it.

A point of the body at u to its front and v above its centre of gravity G, in the body's axes, is at

    P = G + u f + v n,  f = cos θ e − sin θ m,  n = sin θ e + cos θ m

in the frame of the floor. f and n are the body's own x and z; θ is its pitch, by which it is turned about its
own y. e is the direction that it faces, horizontal and perpendicular to its own y, and m is perpendicular to
both; in the plane they are right and up. Things on a shelf feel, along it to the front and perpendicular to
it,

    a = (ẍ_G + P̈ + g z) · f',  n = (ẍ_G + P̈ + g z) · n'

with f' and n' at ψ = θ less the slope of the shelf, ẍ_G the floor's acceleration and z the vertical: on a
floor that shakes by (a, n − g) they would feel the same. P̈ holds all that turning adds: tangential,
centripetal and that of G, and the impulses of landings and of walls. What acts along the length of the shelf,
the body's own y, is left out.

The positions are known at samples; their second differences are the mean of P̈ over two steps with the weights
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
from numpy.typing import NDArray

from stayput.mechanics import columns as col
from stayput.mechanics.runner import Shaking, shaking, trace
from stayput.motion.processing import refine
from stayput.simulation.outcome import Outcome

if TYPE_CHECKING:
    from stayput.simulation.space import Trace
    from stayput.simulation.space_engine import SpaceShaking

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
        Horizontal velocity in the frame of the floor, in the direction that the piece faces [m/s].
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
    """A piece of furniture as it moves, in the plane (d = 2: x and z) or in space (d = 3), at samples.

    Attributes
    ----------
    dt : float
        Time between the samples [s], no more than `STEP`.
    gravity : float
        g [m/s²].
    floor, place : ndarray of float64, shape [d, n]
        Acceleration of the floor [m/s²], and the centre of gravity [m].
    tilt : ndarray of float64, shape [n]
        θ of the module, from upright [rad].
    facing, upright : ndarray of float64, shape [d, n] or [d, 1]
        e and m of the module.
    centre : tuple of float
        The centre of gravity in the body's axes: right of the middle of the base, above the base [m].
    overturned, failed : bool
        Whether it turned over, or fell off another, after the last sample; whether its run was given up.
    """

    dt: float
    gravity: float
    floor: NDArray[np.float64]
    place: NDArray[np.float64]
    tilt: NDArray[np.float64]
    facing: NDArray[np.float64]
    upright: NDArray[np.float64]
    centre: tuple[float, float]
    overturned: bool
    failed: bool

    @classmethod
    def of(cls, case: np.void, elements: NDArray[np.void], shaken: Shaking, height: float) -> Carrier:
        """Follow a piece in the plane on a floor that moves.

        Parameters
        ----------
        case : CASE record
            The piece where it stands.
        elements : ndarray of ELEMENT, shape [n]
            What holds it.
        shaken : Shaking
            How the floor moves.
        height : float
            Height of the piece [m].
        """
        floor, cut = shaken.floor, parts(shaken.floor.dt)
        dt = floor.dt / cut
        along, up = refine(floor.ax, cut), refine(floor.az, cut)
        traced = trace(case, shaking(along, up, dt, col.COULOMB), elements)
        (u_a, u_b, _, _), (v_a, v_b, _, _) = case["u"].tolist(), case["v"].tolist()
        history, outcome = traced.history, traced.result["outcome"]
        return cls(
            dt=dt,
            gravity=float(case["gravity"]),
            floor=float(case["scale"]) * np.stack([along, up])[:, : len(history)],
            place=np.stack([history[:, col.H_X], history[:, col.H_Z]]),
            tilt=history[:, col.H_TILT] + math.atan2(v_b - v_a, u_b - u_a),
            facing=np.array([[1.0], [0.0]]),
            upright=np.array([[0.0], [1.0]]),
            centre=_centre(case, height),
            overturned=bool(outcome == col.OVERTURNED_OUTCOME),
            failed=bool(outcome == col.FAILED_OUTCOME),
        )

    @classmethod
    def of_trace(cls, shaken: SpaceShaking, traced: Trace, height: float) -> Carrier:
        """Return a piece that moved by itself in space; the rest as for `in_space`."""
        turn, fate, case = traced.turns[0], traced.fates_over_time()[0], traced.bodies[0].floor.copy()
        case["gravity"] = traced.gravity
        failed = fate.outcome is Outcome.FAILED
        return cls.in_space(case, shaken, traced.trace.place[0], turn, fate.fell, height, failed)

    @classmethod
    def in_space(
        cls,
        case: np.void,
        shaken: SpaceShaking,
        place: NDArray[np.float64],
        turn: NDArray[np.float64],
        fell: int | None,
        height: float,
        failed: bool,
    ) -> Carrier:
        """Return a piece that moved in space.

        Parameters
        ----------
        case : CASE record
            The piece.
        shaken : SpaceShaking
            How the floor moved, before the factor of the case.
        place, turn : ndarray of float64, shape [n, 3] and [n, 3, 3]
            Its centre of gravity [m], and the rotation of its frame into the room's.
        fell : int or None
            The sample at which it overturned or fell off.
        height : float
            Height of the piece [m].
        failed : bool
            Whether the run was given up.
        """
        reached = len(place) if fell is None else max(1, fell)
        front, up = (np.ascontiguousarray(turn[:reached, :, axis].T) for axis in (0, 2))
        tilt = np.arctan2(-front[2], up[2])
        sin, cos = np.sin(tilt), np.cos(tilt)
        return cls(
            dt=shaken.dt,
            gravity=float(case["gravity"]),
            floor=float(case["scale"]) * shaken.acceleration[:reached].T,
            place=place[:reached].T,
            tilt=tilt,
            facing=cos * front + sin * up,
            upright=cos * up - sin * front,
            centre=_centre(case, height),
            overturned=fell is not None,
            failed=failed,
        )

    def _axes(self, turn: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return f and n of the module at a pitch, shape [d, n] each."""
        sin, cos = np.sin(turn), np.cos(turn)
        return cos * self.facing - sin * self.upright, sin * self.facing + cos * self.upright

    @cached_property
    def axes(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Those of the piece, which all points share."""
        return self._axes(self.tilt)

    def point(self, right: float, height: float, slope: float = 0.0) -> PointMotion:
        """Return the motion of a point of the piece, in the middle of its length.

        Parameters
        ----------
        right, height : float
            Its place right of the middle of the base and above the base [m].
        slope : float
            Inclination of the shelf there [rad], + where the front edge is the higher one.
        """
        front, up = self.axes
        place = self.place + (right - self.centre[0]) * front + (height - self.centre[1]) * up
        felt = self.floor + _second_difference(place, self.dt)
        turn = self.tilt - slope
        if slope != 0.0:
            front, up = self._axes(turn)
        above_gravity = (felt * up).sum(axis=0) - self.gravity * (1.0 - up[-1])
        felt[-1] += self.gravity
        rates = np.gradient(place, self.dt, axis=1) if place.shape[1] > 1 else np.zeros(place.shape)
        return PointMotion(
            along=(felt * front).sum(axis=0),
            up=above_gravity,
            velocity=(rates * self.facing).sum(axis=0),
            height=place[-1],
            turn=turn,
        )


def parts(dt: float) -> int:
    """Return into how many parts a time step [s] is cut."""
    return math.ceil(dt / STEP * (1.0 - 1e-9))


def _centre(case: np.void, height: float) -> tuple[float, float]:
    """Return the centre of gravity of a case in the body's axes; see `Carrier`."""
    u, v = case["u"].tolist(), case["v"].tolist()
    return -0.5 * (u[0] + u[1]), height - v[2]


def _second_difference(values: NDArray[np.float64], dt: float) -> NDArray[np.float64]:
    """Return second differences over dt², shape [d, n]; 0 at both ends: the piece starts at rest."""
    differences = np.zeros(values.shape)
    differences[:, 1:-1] = (values[:, 2:] - 2.0 * values[:, 1:-1] + values[:, :-2]) / dt**2
    return differences
