"""How far bodies in space are from the room and from each other, as the engine notes it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.simulation.space_records import surface_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

DEEPEST = 1e-6
"""How deep a body may begin inside another or a plane, by rounding [m]."""

TOUCHES = 1e-5
"""Gap up to which a body touches another or the room [m]."""


class Gaps(NamedTuple):
    """Gaps at an instant [m], negative where one is inside the other.

    Parameters
    ----------
    room : ndarray, shape (bodies, planes)
        From floor, walls and ceiling.
    bodies : ndarray, shape (bodies, bodies)
        From each other: where they do not touch no more than how far they are apart; inf from itself.
    """

    room: NDArray[np.float64]
    bodies: NDArray[np.float64]


def gaps_of(world: tuple[Any, ...], noted: NDArray[np.float64]) -> Gaps:
    """Return the gaps that the engine has noted.

    Parameters
    ----------
    world : tuple
        Bodies and room, from `stayput.simulation.space_records.world_of`.
    noted : ndarray, shape (features,)
        Gaps of points and rims from each plane, then of pairs of bodies.
    """
    bodies, points, rims, planes, pairs = world[:5]
    alone = len(planes) * (len(points) + len(rims))
    from_planes = noted[:alone].reshape(len(planes), -1)
    room = np.full((len(bodies), len(planes)), np.inf)
    for least, body in zip(room, bodies, strict=True):
        own = slice(body["first_point"], body["first_point"] + body["points"])
        first_rim = len(points) + body["first_rim"]
        round_edges = slice(first_rim, first_rim + body["rims"])
        least[:] = np.concatenate([from_planes[:, own], from_planes[:, round_edges]], axis=1).min(axis=1)
    between = np.full((len(bodies), len(bodies)), np.inf)
    between[pairs["a"], pairs["b"]] = between[pairs["b"], pairs["a"]] = noted[alone:]
    return Gaps(room, between)


def refuse_overlaps(planes: NDArray[np.void], gaps: Gaps) -> None:
    """Raise `InputError` where a body begins inside the room or another."""
    alone = len(gaps.room) == 1
    for j, plane in enumerate(planes):
        for number, least in enumerate(gaps.room[:, j].tolist()):
            if least < -DEEPEST:
                body = phrase("simulation.the_body") if alone else f"members[{number}]"
                surface = phrase(f"simulation.{surface_of(plane)}")
                raise InputError(
                    "simulation.begins_inside", "members", body=body, surface=surface, depth=-least
                )
    for second, first in np.argwhere(np.tril(gaps.bodies < -DEEPEST)).tolist():
        raise InputError(
            "simulation.begin_in_each_other",
            "members",
            first=f"members[{first}]",
            second=f"members[{second}]",
            depth=-float(gaps.bodies[second, first]),
        )
