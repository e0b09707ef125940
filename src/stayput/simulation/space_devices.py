"""Devices of a piece in space as the engine reads them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.measures.element import CAUSES, DeviceResult, damper, utilisation
from stayput.mechanics.devices.columns import AXIAL, F_NORMAL, F_TANGENT, HOLDS, NONE, PLANAR
from stayput.mechanics.space.columns import LAW_OF_ELEMENT, SPRING
from stayput.mechanics.space.touching import ROOM

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.simulation.standing import Joint, Standing

JOINT = "joint"
"""Kind of a joint among the devices."""

JOINT_LABEL = ("Joint", "接合部")

SMOOTH = 0.3
"""Largest angle by which a device's own vibration turns in a step [rad]: it is stepped to a per cent then."""


def springs_of(
    elements: NDArray[np.void],
    turn: NDArray[np.float64],
    place: NDArray[np.float64],
    axes: NDArray[np.float64],
    body: int = 0,
) -> NDArray[np.void]:
    """Return what holds a body to the room, per unit mass.

    Parameters
    ----------
    elements : ndarray of ELEMENT, shape (n,)
        The devices, per unit mass.
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
    return springs


def joint_springs(standing: Sequence[Standing], joints: Sequence[Joint]) -> NDArray[np.void]:
    """Return what joins the members of an assembly, as they stand at first, in newtons."""
    springs = np.zeros(len(joints), SPRING)
    for spring, joint in zip(springs, joints, strict=True):
        first, second = standing[joint.first], standing[joint.second]
        at = np.asarray(joint.at)
        to = at if joint.to is None else np.asarray(joint.to)
        spring["body"], spring["other"] = joint.first, joint.second
        spring["kind"] = PLANAR if joint.to is None else AXIAL
        axes = second.turn @ second.solid.principal[1]
        upwards = 1.0 if first.place[2] >= second.place[2] else -1.0
        for name, vector in (
            ("p", (at - first.place) @ first.turn @ first.solid.principal[1]),
            ("a", (to - second.place) @ axes),
            ("n", np.array([0.0, 0.0, upwards]) @ axes),
        ):
            for axis, value in zip("xyz", vector, strict=True):
                spring[f"{name}{axis}"] = value
        spring["length"] = float(np.linalg.norm(to - at))
        damping = damper(joint.damping, joint.stiffness, min(first.solid.mass, second.solid.mass))
        spring["stiffness"], spring["damping"] = joint.stiffness, damping
        spring["slack_plus"], spring["limit_plus"] = joint.slack, (joint.strength, joint.shear)
        spring["slack_minus"] = 0.0 if joint.to is None else math.inf
        spring["limit_minus"] = math.inf, joint.shear
        spring["friction"], spring["interaction"] = math.nan, int(joint.to is None)
    return springs


def joint_results(
    joints: Sequence[Joint],
    springs: NDArray[np.void],
    devices: NDArray[np.void],
    forces: NDArray[np.float64],
) -> tuple[DeviceResult, ...]:
    """Return what became of the joints of an assembly, by the devices and forces of its run."""
    used = utilisation(springs, devices)
    return tuple(
        DeviceResult(
            JOINT,
            JOINT_LABEL,
            place,
            float(device["peak_pull"]),
            float(device["peak_push"]),
            float(device["peak_shear"]),
            float(used[n]),
            int(device["failure"]) != HOLDS,
            float(device["failure_time"]),
            CAUSES[int(device["failure"])],
            forces[:, n, F_NORMAL],
            forces[:, n, F_TANGENT],
            between=(joint.first, joint.second),
        )
        for n, (joint, place, device) in enumerate(zip(joints, _places(joints), devices, strict=True))
    )


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


def _places(joints: Sequence[Joint]) -> list[str]:
    """Return what the joints are called: by the members they join, and numbered where these have several."""
    pairs = [f"{joint.first}-{joint.second}" for joint in joints]
    return [
        f"{pair}, {pairs[: number + 1].count(pair)}" if pairs.count(pair) > 1 else pair
        for number, pair in enumerate(pairs)
    ]
