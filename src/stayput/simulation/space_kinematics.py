"""How a body in space has moved: tilt, yaw and slide from its poses, and whether it lies."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.model.solid import Solid
    from stayput.simulation.standing import Standing

ON_THE_FLOOR = 1e-4
"""Height up to which a point lies on the floor [m]."""

TOUCHES = 1e-5
"""Gap up to which a body touches a wall or the ceiling [m]."""


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


def lies(solid: Solid, place: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return whether a body touches the floor with more than its base, shape (samples,).

    More than its base is what is above the lowest tenth of its height.

    Parameters
    ----------
    solid : Solid
        The body.
    place, turn : ndarray, shape (samples, 3) and (samples, 3, 3)
        As for `slides`.
    """
    vertices = solid.vertices
    above = vertices[vertices[:, 2] > vertices[:, 2].min() + 0.1 * np.ptp(vertices[:, 2])]
    heights = place[:, 2, np.newaxis] + turn[:, 2] @ (above - solid.centre_of_gravity).T
    return heights.min(axis=1) <= ON_THE_FLOOR


def touches(
    solid: Solid, planes: NDArray[np.void], place: NDArray[np.float64], turn: NDArray[np.float64]
) -> bool:
    """Return whether a body touches a wall or the ceiling.

    Parameters
    ----------
    solid : Solid
        The body.
    planes : ndarray of PLANE
        The room, the floor first.
    place, turn : ndarray, shape (3,) and (3, 3)
        Its pose.
    """
    corners = place + (solid.vertices - solid.centre_of_gravity) @ turn.T
    normals = np.stack([planes[axis][1:] for axis in ("nx", "ny", "nz")], 1)
    return bool(((corners @ normals.T - planes["offset"][1:]) <= TOUCHES).any())
