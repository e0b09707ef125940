"""How firmly a piece stands, on one scale: at a time of a run, and over many runs."""

from __future__ import annotations

import math
from enum import StrEnum
from typing import TYPE_CHECKING

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from stayput.simulation.space_fate import ROCKED, heights, lies_on_floor, tilts
from stayput.simulation.space_records import matrices

if TYPE_CHECKING:
    from stayput.simulation.piece import Piece
    from stayput.simulation.run import Run


class Stability(StrEnum):
    """How firmly a piece stands, the worst last.

    Attributes
    ----------
    STAYS
        It stays where and as it stands.
    MOVES
        It slides, rocks or hops, and does not fall.
    MAY_FALL
        It falls in some runs; of many runs alone.
    FALLS
        It leans past its critical angle, has overturned, or has come off what it stood on.
    """

    STAYS = "stays"
    MOVES = "moves"
    MAY_FALL = "may_fall"
    FALLS = "falls"


MAY_FALL_FROM, FALLS_FROM = 0.05, 0.5
"""Shares of the runs in which a piece falls from which on it may fall, and falls."""

ROCKS = math.radians(0.5)
"""Tilt, or turn in plan, from which on a piece moves [rad]."""

SHIFTS = 1e-3
"""Way of its foot from which on a piece moves [m]."""

AROUND = 0.5
"""How long before and after a time counts for whether a piece moves then [s]: it rocks on through upright."""


def expected(falls: float, moves: float) -> Stability:
    """Return how firmly a piece stands over many runs.

    Parameters
    ----------
    falls, moves : float
        Shares of the runs in which it falls, and in which it falls or moves; NaN without any run, after which
        nothing is known that could not fall.
    """
    if falls >= FALLS_FROM:
        return Stability.FALLS
    if not falls < MAY_FALL_FROM:
        return Stability.MAY_FALL
    return Stability.MOVES if moves >= MAY_FALL_FROM else Stability.STAYS


def over_time(run: Run, body: int) -> NDArray[np.str_]:
    """Return how firmly a body of a run in space stands at each sample, shape (samples,).

    It falls while it leans past its critical angle, held or not, and from when it overturned or fell off on.
    """
    piece, standing, turn = run.pieces[body], run.standing[body], matrices(run.attitude[body])
    reach = round(AROUND * (len(run.time) - 1) / max(float(np.ptp(run.time)), AROUND))

    def around(values: NDArray[np.float64]) -> NDArray[np.float64]:
        return sliding_window_view(np.pad(values, reach, "edge"), 2 * reach + 1)

    ways = (*piece.slide_in_plan.T, heights(standing.solid, run.place[body], turn))
    moves = (around(np.abs(piece.tilt)).max(axis=1) > ROCKS) | (np.ptp(around(piece.yaw), axis=1) > ROCKS)
    moves |= np.any([np.ptp(around(way), axis=1) > SHIFTS for way in ways], axis=0)
    fell = run.time >= np.fmin(piece.overturn_time, piece.fall_time)
    falls = fell | past_critical(standing, run.place[body], turn)
    return np.where(falls, Stability.FALLS, np.where(moves, Stability.MOVES, Stability.STAYS))


def past_critical(piece: Piece, place: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return whether a piece would fall by itself, shape (samples,): what it tilts about no longer holds it.

    That is where its centre of gravity lies beyond its lowest foot, in the direction in which it is tilted.
    What lies on its round side has none, and falls where it stands on an end.

    Parameters
    ----------
    piece : Piece
        The piece at first.
    place, turn : ndarray, shape (samples, 3) and (samples, 3, 3)
        Its centre of gravity [m] and the rotation of its frame into the room's.
    """
    if piece.round_side is not None:
        return lies_on_floor(piece, place, turn)
    feet = (piece.solid.base_points - piece.solid.centre_of_gravity) @ np.swapaxes(turn, 1, 2)
    lowest = feet[np.arange(len(feet)), feet[:, :, 2].argmin(axis=1), :2]
    towards = (turn @ piece.rest[2])[:, :2]
    return (np.einsum("si,si->s", towards, lowest) < 0.0) & (tilts(piece.rest, turn) > ROCKED)
