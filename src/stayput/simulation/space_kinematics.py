"""How a body in space has moved: tilt, yaw and slide from its poses, and how high its lowest point is."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.model.solid import Solid
    from stayput.simulation.standing import Standing


UPRIGHT = math.pi / 3.0
"""Tilt up to which a turn about the vertical says which way a body faces [rad]."""


def tilts(rest: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the angle between the vertical and what points up at rest [rad], of any shape.

    Parameters
    ----------
    rest : ndarray, shape (3, 3)
        The rotation of the body's frame into the room's as it rests.
    turn : ndarray, shape (..., 3, 3)
        The same as it moves.
    """
    x, y, z = (_along(turn, axis, rest[2]) for axis in range(3))
    return np.arctan2(np.hypot(x, y), z)


def _along(turn: NDArray[np.float64], axis: int, vector: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the component of a turned vector along an axis; of many samples faster than a product."""
    a, b, c = vector
    return a * turn[..., axis, 0] + b * turn[..., axis, 1] + c * turn[..., axis, 2]


def yaws(rest: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return by what a body has turned about the vertical from how it rests [rad], without jumps.

    The rotation from rest is one about a horizontal axis after one about the vertical, which this is.

    Parameters
    ----------
    rest, turn : ndarray, shape (3, 3) and (samples, 3, 3)
        As for `tilts`.
    """
    sine = _along(turn, 1, rest[0]) - _along(turn, 0, rest[1])
    cosine = _along(turn, 0, rest[0]) + _along(turn, 1, rest[1])
    return np.unwrap(np.arctan2(sine, cosine))


def upright_yaws(rest: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the same as `yaws` while a body is tilted by up to `UPRIGHT`; then the last before."""
    upright = tilts(rest, turn) <= UPRIGHT
    last = np.maximum.accumulate(np.where(upright, np.arange(len(turn)), 0))
    return yaws(rest, turn)[last]


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
    lowest = np.stack([_along(turn, 2, foot) for foot in feet]).argmin(axis=0)
    lows = feet[lowest].T
    first = one.place + feet @ one.turn.T
    foot = first[:, 2].argmin()
    stood = (first[foot] + (feet - feet[foot]) @ one.rest.T)[:, :2]
    middle = 0.5 * (stood.min(axis=0) + stood.max(axis=0))
    x, y = (stood[lowest] - middle).T
    angle = yaws(one.rest, turn)
    cos, sin = np.cos(angle), np.sin(angle)
    stays = cos * x - sin * y, sin * x + cos * y
    return np.stack([place[:, i] + _along(turn, i, lows) - middle[i] - stays[i] for i in range(2)], axis=1)


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
    lows = [_along(turn, 2, corner) for corner in corners]
    for x, y, z, *axis, radius in solid.rims[solid.rims[:, 2] > above]:
        centre = np.array([x, y, z]) - solid.centre_of_gravity
        reach = radius * np.hypot(_along(turn, 0, np.array(axis)), _along(turn, 1, np.array(axis)))
        lows.append(_along(turn, 2, centre) - reach)
    return place[:, 2] + np.min(lows, axis=0)
