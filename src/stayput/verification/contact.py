"""Where pieces come into the place of a person."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.model.floor_plan import rectangle
from stayput.simulation.convex import box_of, separation
from stayput.simulation.tracks import body_at, bounds_of, touching_of

if TYPE_CHECKING:
    from stayput.model.floor_plan import PersonPlace
    from stayput.simulation.tracks import Touching, Track

SPACING = 0.1
"""Distance between the points of a place at which the speed of a piece is looked at [m]."""

ENTERS_BY = 0.05
"""How far a piece must come into the place of a person to hit who is there [m]: a convention.

What stands beside a bed and is held slides some centimetres to and fro: it nudges the bed's edge in every
earthquake, and hits nobody.
"""

ROUNDING = 1e-9
"""Share by which rounding may change how far a point goes."""


class RoomContact(NamedTuple):
    """A contact of a piece with the place of a person; the piece moves on as if nobody were there.

    Parameters
    ----------
    time : float
        When they first touch [s].
    speed : float
        The largest of the part of the piece that is within the place: an upper bound [m/s].
    energy : float
        The largest kinetic energy of the piece while it touches: also an upper bound [J].
    """

    time: float
    speed: float
    energy: float


def contact_with_place(track: Track, place: PersonPlace) -> RoomContact | None:
    """Return the first contact of a piece with the place of a person that it comes into, or None.

    Parameters
    ----------
    track : Track
        The piece's.
    place : PersonPlace
        The place; what stands in it from the beginning does not hit it by staying there.
    """
    if track.stays:
        return None
    low, high = bounds_of(track.corners())
    corners = rectangle(place.at, place.width, place.length, place.heading)
    least, most = (*corners.min(axis=0), place.low), (*corners.max(axis=0), place.high)
    near = np.all((low <= most) & (high >= least), axis=1)
    touching = touching_of(
        track.sample, near, track.dt, lambda k: separation(body_at(track, k), box_of(place, len(k)))
    )
    if touching is None or touching.deepest < ENTERS_BY:
        return None
    speed = _speed_within(track, place, touching)
    return RoomContact(touching.time, speed, float(track.energy[touching.places].max()))


def _speed_within(track: Track, place: PersonPlace, touching: Touching) -> float:
    """Return the largest speed of those points of a piece that are within a place while they touch [m/s].

    Points of the place, `SPACING` apart, that are in the piece; none where it is all between them. It is not
    less than the speed at which they close in.
    """
    x, y, z = (
        np.linspace(low, high, max(2, math.ceil((high - low) / SPACING) + 1))
        for low, high in (
            (-0.5 * place.width, 0.5 * place.width),
            (-0.5 * place.length, 0.5 * place.length),
            (place.low, place.high),
        )
    )
    grid = np.stack(np.meshgrid(x, y, z, indexing="ij"), axis=-1).reshape(-1, 3)
    cos, sin = math.cos(place.heading), math.sin(place.heading)
    points = grid @ np.array([[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]]) + [*place.at, 0.0]
    shape = track.shape
    reach = shape.corners @ shape.normals.T
    low, high = reach.min(axis=0), reach.max(axis=0)
    fastest = 0.0
    # the way of a point is affine in its place: none of a piece goes farther than the corner that does most
    ways = track.corners(touching.places) - track.corners(touching.places - 1)
    farthest = np.linalg.norm(ways, axis=2).max(axis=1) * (1.0 + ROUNDING)
    for number in np.argsort(-farthest, kind="stable").tolist():
        if farthest[number] <= max(fastest, touching.closing * track.dt):
            break
        k = int(touching.places[number])
        seen = (points - track.place[k]) @ track.turn[k]
        along = seen @ shape.normals.T
        inside = ((along >= low) & (along <= high)).all(axis=1)
        if inside.any():
            before = seen[inside] @ track.turn[k - 1].T + track.place[k - 1]
            fastest = max(fastest, float(np.linalg.norm(points[inside] - before, axis=1).max()))
    return max(touching.closing, fastest / track.dt)
