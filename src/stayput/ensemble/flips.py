"""Flips between standing and falling along an amplitude, and their places by bisection."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    Runs: TypeAlias = (
        "Callable[[NDArray[np.intp], NDArray[np.float64]], tuple[NDArray[np.bool_], NDArray[np.int32]]]"
    )
    """Tells of points and amplitudes, shape (k,) each, whether the body falls, and its landings."""

MOST_HALVINGS = 60
"""An interval that begins at zero could be halved without end."""


@dataclass(frozen=True, slots=True, eq=False)
class Flips:
    """Flips, ordered by point and then by amplitude.

    Attributes
    ----------
    point : ndarray of int, shape (n,)
        The point that each belongs to.
    lower, upper : ndarray of float64, shape (n,)
        Amplitudes on both sides of it.
    direction : ndarray of int8, shape (n,)
        +1 where it falls above, −1 where it stands above.
    """

    point: NDArray[np.intp]
    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    direction: NDArray[np.int8]

    def __len__(self) -> int:
        return len(self.point)

    @property
    def number(self) -> NDArray[np.intp]:
        """Number of each flip among those of its point, from 0 at the lowest, shape (n,)."""
        return np.arange(len(self)) - np.searchsorted(self.point, self.point)

    @property
    def fallen_side(self) -> NDArray[np.float64]:
        """The amplitude beside each flip at which the body falls, shape (n,)."""
        return np.where(self.direction > 0, self.upper, self.lower)

    def only(self, chosen: NDArray[np.bool_]) -> Flips:
        """Return some of them."""
        return Flips(self.point[chosen], self.lower[chosen], self.upper[chosen], self.direction[chosen])

    def along_with(self, other: Flips) -> Flips:
        """Return these and others, in order."""
        point, lower = np.append(self.point, other.point), np.append(self.lower, other.lower)
        order = np.lexsort((lower, point))
        upper, direction = np.append(self.upper, other.upper), np.append(self.direction, other.direction)
        return Flips(point[order], lower[order], upper[order], direction[order])


def flips_of(falls: NDArray[np.bool_], amplitudes: NDArray[np.float64]) -> Flips:
    """Return the flips between neighbouring amplitudes; ``falls`` has shape (points, amplitudes)."""
    point, place = np.nonzero(falls[:, 1:] != falls[:, :-1])
    direction = np.where(falls[point, place], -1, 1).astype(np.int8)
    return Flips(point, amplitudes[place], amplitudes[place + 1], direction)


def refined(flips: Flips, runs: Runs, tolerance: float) -> Flips:
    """Bisect all flips together until the sides of each are within ``tolerance``, relative to the upper.

    Where several flips lie between two sides, the one that is followed is any of the same direction.
    """
    lower, upper = flips.lower.copy(), flips.upper.copy()
    for _ in range(MOST_HALVINGS):
        wide = np.flatnonzero(upper - lower > tolerance * upper)
        if not len(wide):
            break
        middle = 0.5 * (lower[wide] + upper[wide])
        falls, _ = runs(flips.point[wide], middle)
        below = falls == (flips.direction[wide] < 0)
        lower[wide] = np.where(below, middle, lower[wide])
        upper[wide] = np.where(below, upper[wide], middle)
    return Flips(flips.point, lower, upper, flips.direction)


def hidden_flips(
    falls: NDArray[np.bool_],
    landings: NDArray[np.int32],
    amplitudes: NDArray[np.float64],
    runs: Runs,
    tolerance: float,
) -> Flips:
    """Look for islands that lie between two neighbouring amplitudes at which the body falls.

    Between a fall after n landings and one after another number there is an amplitude at which the body
    comes to the point of balance and stays there as long as one likes; when it then comes back after the
    shaking, it stands. So the change of the number is bisected until a run stands, or the sides are within
    ``tolerance``.

    Parameters
    ----------
    falls, landings : ndarray, shape (points, amplitudes)
        What was sampled.
    amplitudes : ndarray, shape (amplitudes,)
        Increasing.
    runs, tolerance
        As for `refined`.

    Returns
    -------
    Flips
        Two for each island found: back to standing, and to falling again. Not refined.
    """
    changes = falls[:, 1:] & falls[:, :-1] & (landings[:, 1:] != landings[:, :-1])
    point, place = np.nonzero(changes)
    lower, upper = amplitudes[place], amplitudes[place + 1]
    below = landings[point, place]
    island = np.full(len(point), np.nan)
    for _ in range(MOST_HALVINGS):
        todo = np.flatnonzero(np.isnan(island) & (upper - lower > tolerance * upper))
        if not len(todo):
            break
        middle = 0.5 * (lower[todo] + upper[todo])
        fallen, landed = runs(point[todo], middle)
        island[todo] = np.where(fallen, np.nan, middle)
        same = landed == below[todo]
        lower[todo] = np.where(fallen & same, middle, lower[todo])
        upper[todo] = np.where(fallen & ~same, middle, upper[todo])
    met = ~np.isnan(island)
    up = np.ones(np.count_nonzero(met), np.int8)
    back = Flips(point[met], lower[met], island[met], -up)
    return back.along_with(Flips(point[met], island[met], upper[met], up))
