"""Where bodies come together: with the place of a person, and with each other.

Two convex bodies are apart where an axis separates them: the normal of a face of one, or the cross product of
an edge of each (Gottschalk, Lin and Manocha 1996). The largest gap along such an axis is never more than the
distance, and below 0 exactly where they overlap; its rate just before they touch is how fast they close.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.model.floor_plan import PersonPlace, rectangle
from stayput.rooms.tracks import at_rest

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from stayput.rooms.tracks import Track
    from stayput.simulation.standing import Standing

SLIGHT = 1e-6
"""Length of a cross product of two unit vectors up to which they are parallel."""


class RoomContact(NamedTuple):
    """A contact of a piece with the place of a person, or with another piece.

    The piece moves on as if nobody were there: speed and energy are upper bounds.

    Parameters
    ----------
    time : float
        When they first touch [s].
    speed : float
        The largest speed at which they close in before they touch, and while they do [m/s].
    energy : float
        The largest kinetic energy of the piece, of two together, while they touch [J].
    """

    time: float
    speed: float
    energy: float


class _Convex(NamedTuple):
    """A convex body at k samples: corners (k, n, 3), directions of faces (k, f, 3) and of edges (k, e, 3)."""

    corners: NDArray[np.float64]
    normals: NDArray[np.float64]
    edges: NDArray[np.float64]


def separation(one: _Convex, other: _Convex) -> NDArray[np.float64]:
    """Return the largest gap along any axis that may separate two bodies [m], shape (k,)."""
    crossed = np.cross(one.edges[:, :, np.newaxis], other.edges[:, np.newaxis])
    crossed = crossed.reshape(len(crossed), -1, 3)
    size = np.linalg.norm(crossed, axis=2)
    slight = size <= SLIGHT
    crossed = crossed / np.where(slight, 1.0, size)[..., np.newaxis]
    axes = np.concatenate([one.normals, other.normals, crossed], axis=1)
    first, second = (body.corners @ np.swapaxes(axes, 1, 2) for body in (one, other))
    gaps = np.maximum(
        first.min(axis=1) - second.max(axis=1),
        second.min(axis=1) - first.max(axis=1),
    )
    faces = one.normals.shape[1] + other.normals.shape[1]
    gaps[:, faces:][slight] = -np.inf  # parallel edges span no axis
    return gaps.max(axis=1)


def _body_at(track: Track, chosen: NDArray[np.intp]) -> _Convex:
    back = np.swapaxes(track.turn[chosen], 1, 2)
    return _Convex(track.corners(chosen), track.shape.normals @ back, track.shape.edges @ back)


def _box_of(place: PersonPlace, count: int) -> _Convex:
    plan = rectangle(place.at, place.width, place.length, place.heading)
    corners = np.concatenate([np.column_stack((plan, np.full(4, z))) for z in (place.low, place.high)])
    sides = np.diff(plan[:3], axis=0) / np.linalg.norm(np.diff(plan[:3], axis=0), axis=1)[:, np.newaxis]
    axes = np.concatenate([np.column_stack((sides, np.zeros(2))), [[0.0, 0.0, 1.0]]])
    corners, axes = (np.broadcast_to(values, (count, *values.shape)) for values in (corners, axes))
    return _Convex(corners, axes, axes)


def inside_each_other(one: Standing, other: Standing | PersonPlace) -> float:
    """Return how deep a piece stands in another, or where a person is, at first [m]; 0 where it does not."""
    first = np.zeros(1, np.intp)
    box = _box_of(other, 1) if isinstance(other, PersonPlace) else _body_at(at_rest(other), first)
    return max(0.0, -float(separation(_body_at(at_rest(one), first), box)[0]))


def contact_with_place(track: Track, place: PersonPlace) -> RoomContact | None:
    """Return the first contact of a piece with the place of a person, or None.

    Parameters
    ----------
    track : Track
        The piece's.
    place : PersonPlace
        The place; what stands in it from the beginning does not hit it by staying there.
    """
    if track.stays:
        return None
    corners = track.corners()
    low, high = corners.min(axis=1), corners.max(axis=1)
    own = rectangle(place.at, place.width, place.length, place.heading)
    least, most = (*own.min(axis=0), place.low), (*own.max(axis=0), place.high)
    near = ((low <= most) & (high >= least)).all(axis=1)
    return _first(
        track.sample,
        near,
        track.dt,
        lambda chosen: separation(_body_at(track, chosen), _box_of(place, len(chosen))),
        lambda chosen: track.energy[chosen],
    )


def contact_between(one: Track, other: Track) -> RoomContact | None:
    """Return the first contact of two pieces that were run each by itself under the same motion, or None."""
    if one.stays and other.stays:
        return None
    sample = np.union1d(one.sample, other.sample)
    first, second = (np.searchsorted(track.sample, sample, side="right") - 1 for track in (one, other))
    a, b = one.corners()[first], other.corners()[second]
    near = ((a.min(axis=1) <= b.max(axis=1)) & (a.max(axis=1) >= b.min(axis=1))).all(axis=1)
    return _first(
        sample,
        near,
        one.dt,
        lambda chosen: separation(_body_at(one, first[chosen]), _body_at(other, second[chosen])),
        lambda chosen: one.energy[first[chosen]] + other.energy[second[chosen]],
    )


def _first(
    sample: NDArray[np.intp],
    near: NDArray[np.bool_],
    dt: float,
    gap_at: Callable[[NDArray[np.intp]], NDArray[np.float64]],
    energy_at: Callable[[NDArray[np.intp]], NDArray[np.float64]],
) -> RoomContact | None:
    """Return the contact from the first overlap after a gap on; ``near``: where two bodies may overlap."""
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
    steps = np.diff(gaps)
    together = (gaps[1:] <= 0.0) & (np.diff(chosen) == 1) & (np.arange(len(steps)) >= first)
    touching = chosen[1:][together]
    return RoomContact(time, float(-steps[together].min()) / dt, float(energy_at(touching).max()))
