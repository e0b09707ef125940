"""Where bodies come together: with the place of a person, and with each other."""

from __future__ import annotations

import math
from functools import reduce
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.model.floor_plan import rectangle
from stayput.simulation.convex import Convex, box_of, separation

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from stayput.model.floor_plan import PersonPlace
    from stayput.rooms.tracks import Track

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


def _body_at(track: Track, chosen: NDArray[np.intp]) -> Convex:
    back = np.swapaxes(track.turn[chosen], 1, 2)
    return Convex(track.corners(chosen), track.shape.normals @ back, track.shape.edges @ back)


def _bounds(corners: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the least and the most of corners (k, n, 3), shape (k, 3): one by one, as n is small."""
    one_by_one = np.moveaxis(corners, 1, 0)
    return reduce(np.minimum, one_by_one), reduce(np.maximum, one_by_one)


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
    low, high = _bounds(track.corners())
    corners = rectangle(place.at, place.width, place.length, place.heading)
    least, most = (*corners.min(axis=0), place.low), (*corners.max(axis=0), place.high)
    near = np.all((low <= most) & (high >= least), axis=1)
    touching = _touching(
        track.sample, near, track.dt, lambda k: separation(_body_at(track, k), box_of(place, len(k)))
    )
    if touching is None or touching.deepest < ENTERS_BY:
        return None
    speed = _speed_within(track, place, touching)
    return RoomContact(touching.time, speed, float(track.energy[touching.places].max()))


def _speed_within(track: Track, place: PersonPlace, touching: _Touching) -> float:
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


def meet(track: Track, other: Track) -> bool:
    """Return whether two pieces come together that were run each by itself under the same motion."""
    if track.stays and other.stays:
        return False
    sample = np.union1d(track.sample, other.sample)
    first, second = (np.searchsorted(run.sample, sample, side="right") - 1 for run in (track, other))
    (low, high), (least, most) = _bounds(track.corners()), _bounds(other.corners())
    near = np.all((low[first] <= most[second]) & (high[first] >= least[second]), axis=1)

    def gap_at(k: NDArray[np.intp]) -> NDArray[np.float64]:
        return separation(_body_at(track, first[k]), _body_at(other, second[k]))

    return _touching(sample, near, track.dt, gap_at) is not None


class _Touching(NamedTuple):
    """How two bodies touch.

    Parameters
    ----------
    time : float
        When they first touch [s].
    closing : float
        How fast they close in then [m/s].
    places : ndarray of int
        At which samples they touch.
    deepest : float
        How far they are in each other at most [m].
    """

    time: float
    closing: float
    places: NDArray[np.intp]
    deepest: float


def _touching(
    sample: NDArray[np.intp],
    near: NDArray[np.bool_],
    dt: float,
    gap_at: Callable[[NDArray[np.intp]], NDArray[np.float64]],
) -> _Touching | None:
    """Return how two bodies touch from their first overlap after a gap on; ``near``: where they may."""
    close = np.flatnonzero(near)
    if not len(close):
        return None
    # the sample before each too: the gap there tells how fast it closes
    chosen = np.unique(np.concatenate([close, np.maximum(close - 1, 0)]))
    gaps = gap_at(chosen)
    closes = np.flatnonzero((gaps[1:] <= 0.0) & (gaps[:-1] > 0.0) & (np.diff(chosen) == 1))
    if not len(closes):
        return None
    first = int(closes[0])
    gap, overlap = float(gaps[first]), -float(gaps[first + 1])
    # a piece that stood still until then has moved in the last step alone
    time = dt * (float(sample[chosen[first + 1]]) - overlap / (gap + overlap))
    together = (gaps[1:] <= 0.0) & (np.arange(1, len(gaps)) > first)
    deepest = -float(gaps[1:][together].min())
    return _Touching(time, (gap + overlap) / dt, chosen[1:][together], deepest)
