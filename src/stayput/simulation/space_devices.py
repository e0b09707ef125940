"""Devices of a piece in space as the engine reads them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.mechanics.devices.columns import NONE
from stayput.mechanics.space.columns import LAW_OF_ELEMENT, SPRING
from stayput.mechanics.space.touching import ROOM

if TYPE_CHECKING:
    from numpy.typing import NDArray

SMOOTH = 0.3
"""Largest angle by which a device's own vibration turns in a step [rad]: it is stepped to a per cent then."""


def springs_of(
    elements: NDArray[np.void],
    mass: float,
    turn: NDArray[np.float64],
    place: NDArray[np.float64],
    axes: NDArray[np.float64],
    body: int = 0,
) -> NDArray[np.void]:
    """Return what holds a body to the room, in newtons.

    Parameters
    ----------
    elements : ndarray of ELEMENT, shape (n,)
        The devices, per unit mass.
    mass : float
        Mass of the body [kg].
    turn : ndarray, shape (3, 3)
        The rotation of its frame into the room's as it rests, tilted about y alone.
    place : ndarray, shape (3,)
        Where its centre of gravity is as it rests, from the middle of its base [m].
    axes : ndarray, shape (3, 3)
        Its principal axes in its frame, as columns.
    body : int
        Its number.
    """
    elements = elements[elements["kind"] != NONE]
    springs = np.zeros(len(elements), SPRING)
    springs["body"], springs["other"], springs["kind"] = body, ROOM, elements["kind"]
    points = np.stack([elements["u"], elements["y"], elements["v"]], 1)
    at_point = place + points @ turn.T
    anchors = np.stack([elements["x"], elements["y"], elements["z"]], 1)
    anchors = np.where(np.isnan(elements["x"])[:, None], at_point, anchors)
    normals = np.stack([-elements["sin"], np.zeros(len(elements)), elements["cos"]], 1)
    for name, vectors in (("p", points @ axes), ("a", anchors), ("n", normals)):
        for number, axis in enumerate("xyz"):
            springs[f"{name}{axis}"] = vectors[:, number]
    springs["length"] = elements["length"]
    for name in LAW_OF_ELEMENT:
        springs[name] = elements[name]
    for name in ("stiffness", "damping", "limit_plus", "limit_minus"):
        springs[name] *= mass
    return springs


def longest_step(springs: NDArray[np.void], bodies: NDArray[Any], longest: float) -> float:
    """Return the longest step in which the devices' vibrations are followed [s].

    The fastest vibration of bodies that springs join is no faster than all of them together, each by itself
    with the others held.
    """
    squares = [_fastest_square(springs, body, number) for number, body in enumerate(bodies)]
    joined = bool((springs["other"] != ROOM).any())
    square = sum(squares) if joined else max(squares)
    return min(longest, SMOOTH / math.sqrt(square)) if square > 0.0 else longest


def _fastest_square(springs: NDArray[np.void], body: Any, number: int) -> float:
    """Return the largest ω² of a free body on its springs, each taken to be as stiff in all directions."""
    stiffness = np.zeros((6, 6))
    for spring in springs:
        for owner, names in ((spring["body"], ("px", "py", "pz")), (spring["other"], ("ax", "ay", "az"))):
            if owner == number:
                x, y, z = (float(spring[name]) for name in names)
                turned = np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]])
                rows = np.hstack([np.eye(3), turned])
                stiffness += float(np.max(spring["stiffness"])) * rows.T @ rows
    moments = [body["mass"]] * 3 + [body["i1"], body["i2"], body["i3"]]
    root = 1.0 / np.sqrt(moments)
    return float(np.linalg.eigvalsh(root[:, np.newaxis] * stiffness * root)[-1]) if len(springs) else 0.0
