"""How a body in space has moved: tilt, yaw and slide from its poses, and how high its lowest point is."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.model.solid import Solid
    from stayput.simulation.standing import Standing


def tilts(rest: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the angle between the vertical and what points up at rest [rad], of any shape.

    Parameters
    ----------
    rest : ndarray, shape (3, 3)
        The rotation of the body's frame into the room's as it rests.
    turn : ndarray, shape (..., 3, 3)
        The same as it moves.
    """
    up = turn @ rest[2]
    return np.arctan2(np.hypot(up[..., 0], up[..., 1]), up[..., 2])


def yaws(rest: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return by what a body has turned about the vertical from how it rests [rad], without jumps.

    The rotation from rest is one about a horizontal axis after one about the vertical, which this is.

    Parameters
    ----------
    rest, turn : ndarray, shape (3, 3) and (samples, 3, 3)
        As for `tilts`.
    """
    moved = turn @ rest.T
    angles = np.arctan2(moved[:, 1, 0] - moved[:, 0, 1], moved[:, 0, 0] + moved[:, 1, 1])
    return np.unwrap(angles)


def slides(one: Standing, place: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return how far the base has slid in plan [m], shape (samples, 2).

    It is the way of the foot that is lowest, less that which it moved as the body turned about the vertical
    through the middle of its base; for a body in the plane the slide of its fulcrum. The feet of a body that
    begins tilted count from where they would come down.

    Parameters
    ----------
    one : Standing
        The body at first.
    place : ndarray, shape (samples, 3)
        Where its centre of gravity is [m].
    turn : ndarray, shape (samples, 3, 3)
        The rotation of its frame into the room's.
    """
    feet = one.solid.base - one.solid.centre_of_gravity
    at = place[:, np.newaxis] + np.einsum("sij,fj->sfi", turn, feet)
    lowest = at[..., 2].argmin(axis=1)
    samples = np.arange(len(place))
    first = one.place + feet @ one.turn.T
    foot = first[:, 2].argmin()
    stood = (first[foot] + (feet - feet[foot]) @ one.rest.T)[:, :2]
    middle = 0.5 * (stood.min(axis=0) + stood.max(axis=0))
    arms = stood[lowest] - middle
    angle = yaws(one.rest, turn)
    cos, sin = np.cos(angle), np.sin(angle)
    turned = np.stack([cos * arms[:, 0] - sin * arms[:, 1], sin * arms[:, 0] + cos * arms[:, 1]], axis=1)
    return at[samples, lowest, :2] - middle - turned


def heights(
    solid: Solid, place: NDArray[np.float64], turn: NDArray[np.float64], above: float = -math.inf
) -> NDArray[np.float64]:
    """Return how high the lowest point of a body is [m], shape (samples,).

    Parameters
    ----------
    solid : Solid
        The body.
    place, turn : ndarray, shape (samples, 3) and (samples, 3, 3)
        As for `slides`.
    above : float
        Only what is above this height in the body's frame counts [m].
    """
    corners = np.concatenate([solid.vertices, solid.base])
    corners = corners[corners[:, 2] > above] - solid.centre_of_gravity
    rims = solid.rims[solid.rims[:, 2] > above]
    centres = rims[:, :3] - solid.centre_of_gravity
    axes = np.einsum("sij,rj->sri", turn, rims[:, 3:6])
    lows = centres @ turn[:, 2].T - rims[:, 6, np.newaxis] * np.hypot(axes[..., 0], axes[..., 1]).T
    found = np.concatenate([corners @ turn[:, 2].T, lows]).min(axis=0)
    return place[:, 2] + found
