"""How bodies in space have moved, and what becomes of them: which overturn, fall off, or are left leaning.

How firmly a piece stands is told on one scale, at a time of a run and over many runs.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from enum import StrEnum
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from stayput.mechanics.columns import ROCKING_TILT
from stayput.simulation.outcome import Outcome
from stayput.simulation.space_engine import TOUCHES, Gaps
from stayput.simulation.space_records import matrices

if TYPE_CHECKING:
    from stayput.model.solid import Solid
    from stayput.simulation.piece import Piece, RoundSide
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
        It leans past its critical angle for good, has overturned, or has come off what it stood on.
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

    What a measure is made to let it slide is no move. What leans past its critical angle and comes back does
    not fall.
    """
    piece, standing, turn = run.pieces[body], run.standing[body], matrices(run.attitude[body])
    reach = round(AROUND * (len(run.time) - 1) / max(float(np.ptp(run.time)), AROUND))

    def around(values: NDArray[np.float64]) -> NDArray[np.float64]:
        return sliding_window_view(np.pad(values, reach, "edge"), 2 * reach + 1)

    free = 0.0 if piece.held is None else piece.held.free_slide
    beyond = 1.0 - np.minimum(1.0, free / np.maximum(piece.slide, SHIFTS))
    ways = (*(beyond * piece.slide_in_plan.T), heights(standing.solid, run.place[body], turn))
    moves = (around(np.abs(piece.tilt)).max(axis=1) > ROCKS) | (np.ptp(around(piece.yaw), axis=1) > ROCKS)
    moves |= np.any([np.ptp(around(way), axis=1) > SHIFTS for way in ways], axis=0)
    fell = run.time >= np.fmin(piece.overturn_time, piece.fall_time)
    upright = np.flatnonzero(~(fell | past_critical(standing, run.place[body], turn)))
    falls = np.arange(len(fell)) > upright.max(initial=-1)
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
    return (np.einsum("si,si->s", towards, lowest) < 0.0) & (tilts(piece.rest, turn) > ROCKING_TILT)


def falling(piece: Piece, place: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return whether a piece falls, shape (samples,): it is past its critical angle, or has come down.

    The arguments are those of `past_critical`; its height at the first sample is that at which it stood.
    """
    return past_critical(piece, place, turn) | (place[:, 2] < place[0, 2] - LEFT)


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


def _along(
    turn: NDArray[np.float64], axis: int, vector: NDArray[np.float64] | Sequence[NDArray[np.float64]]
) -> NDArray[np.float64]:
    """Return the component of a turned vector along an axis; of many samples faster than a product."""
    a, b, c = vector
    return a * turn[..., axis, 0] + b * turn[..., axis, 1] + c * turn[..., axis, 2]


def yaws(rest: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return by what a body has turned about the vertical from how it rests [rad].

    The rotation from rest is one about a horizontal axis after one about the vertical, which this is.

    Parameters
    ----------
    rest, turn : ndarray, shape (3, 3) and (samples, 3, 3)
        As for `tilts`.
    """
    sine = _along(turn, 1, rest[0]) - _along(turn, 0, rest[1])
    cosine = _along(turn, 0, rest[0]) + _along(turn, 1, rest[1])
    return np.arctan2(sine, cosine)


def upright_yaws(rest: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the same without jumps while a body is tilted by up to `UPRIGHT`; then the last before."""
    upright = tilts(rest, turn) <= UPRIGHT
    last = np.maximum.accumulate(np.where(upright, np.arange(len(turn)), 0))
    return np.unwrap(yaws(rest, turn)[last])


def unrolled(piece: Piece, turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return rotations without what a body that lies on its round side has rolled: its first side is down."""
    side = piece.round_side
    if side is None:
        return turn
    phi = _rolled_by(side, turn)[..., np.newaxis, np.newaxis]
    x, y, z = side.axis
    across = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return turn @ (np.eye(3) + np.sin(phi) * across + (1.0 - np.cos(phi)) * (across @ across))


def _rolled_by(side: RoundSide, turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return how far round a body its line of contact has moved [rad], shape (samples,)."""
    across = np.cross(side.axis, side.up)
    return np.unwrap(np.arctan2(_along(turn, 2, across), _along(turn, 2, side.up)))


def rolled(piece: Piece, turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return how far a body that lies on its round side has rolled in plan [m], shape (samples, 2).

    It is the way of a body of the mean radius R that does not slip: R dφ, φ what has passed over the line of
    contact, across the axis as that lies at the time. One that slips or spins has other ways.
    """
    side = piece.round_side
    if side is None:
        return np.zeros((len(turn), 2))
    ahead = np.stack([-_along(turn, 1, side.axis), _along(turn, 0, side.axis)], axis=1)
    ahead /= np.linalg.norm(ahead, axis=1)[:, np.newaxis]
    steps = side.radius * np.diff(_rolled_by(side, turn), prepend=0.0)
    return np.cumsum(steps[:, np.newaxis] * ahead, axis=0)


def slides(piece: Piece, place: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return how far the base has slid in plan [m], shape (samples, 2).

    It is the way of the foot that is lowest, less that which it moved as the body turned about the vertical
    through the middle of its base; for a body in the plane the slide of its fulcrum. What lies on its round
    side has feet at both ends of the line of contact. The feet of a body that begins tilted count from where
    they would come down.

    Parameters
    ----------
    piece : Piece
        The body at first.
    place : ndarray, shape (samples, 3)
        Where its centre of gravity is [m].
    turn : ndarray, shape (samples, 3, 3)
        The rotation of its frame into the room's.
    """
    side = piece.round_side
    feet = (piece.solid.base_points if side is None else side.line) - piece.solid.centre_of_gravity
    lowest = np.stack([_along(turn, 2, foot) for foot in feet]).argmin(axis=0)
    first = piece.place + feet @ piece.turn.T
    foot = first[:, 2].argmin()
    stood = (first[foot] + (feet - feet[foot]) @ piece.rest.T)[:, :2]
    middle = 0.5 * (stood.min(axis=0) + stood.max(axis=0))
    # of contiguous numbers many are worked out faster
    lows, (x, y) = [along[lowest] for along in feet.T], [along[lowest] for along in (stood - middle).T]
    angle = yaws(piece.rest, turn)
    cos, sin = np.cos(angle), np.sin(angle)
    stays = cos * x - sin * y, sin * x + cos * y
    return np.stack([place[:, i] + _along(turn, i, lows) - middle[i] - stays[i] for i in range(2)]).T


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
    corners = np.concatenate([solid.vertices, solid.base_points])
    corners = corners[corners[:, 2] > above] - solid.centre_of_gravity
    lows = [_along(turn, 2, corner) for corner in corners]
    for x, y, z, *axis, radius in solid.rims[solid.rims[:, 2] > above]:
        centre = np.array([x, y, z]) - solid.centre_of_gravity
        reach = radius * np.hypot(_along(turn, 0, np.array(axis)), _along(turn, 1, np.array(axis)))
        lows.append(_along(turn, 2, centre) - reach)
    return place[:, 2] + np.min(lows, axis=0)


SLID = 1e-6
"""Way from which on a body has slid [m]."""

LEANS = 1e-3
"""Tilt at the end from which on a body leans on what it touches [rad]: beside a wall it may still rock."""

LIFTED = 1e-4
"""How far a body comes up or down when it has left what it stood on [m]."""

LIES = math.pi / 4
"""Tilt from which on a body lies on what it touches: that pushes it up more than aside [rad]."""

ON_THE_FLOOR = 1e-4
"""Height up to which a point lies on the floor [m]."""

BASE = 0.1
"""Share of the height of a body that counts as its base."""

LEFT = 0.01
"""How far a body has come from where it stood on another, or down, when it has left its place [m]."""


class Fate(NamedTuple):
    """What became of a body, the samples at which it overturned and fell off, where it did, and how it moved.

    Its tilts [rad], how far it has slid in plan over what it stood on at first [m], and that along x and y,
    shape (samples, 2).
    """

    outcome: Outcome
    overturned: int | None
    fell_off: int | None
    tilt: NDArray[np.float64]
    way: NDArray[np.float64]
    slide: NDArray[np.float64]

    @property
    def fell(self) -> int | None:
        """The first sample at which it overturned or fell off; None where it did neither."""
        return min((i for i in (self.overturned, self.fell_off) if i is not None), default=None)

    def at_all(self, sample: NDArray[np.intp], repeats: NDArray[np.intp]) -> Fate:
        """Return it at all samples, of that at some of them; see `moved_samples`."""
        overturned, fell_off = (None if at is None else int(sample[at]) for at in self[1:3])
        over_time = self.tilt[repeats], self.way[repeats], self.slide[repeats]
        return Fate(self.outcome, overturned, fell_off, *over_time)


def fates_of(
    pieces: Sequence[Piece],
    place: NDArray[np.float64],
    turn: NDArray[np.float64],
    gaps: tuple[Gaps, Gaps],
    given_up: bool = False,
) -> list[Fate]:
    """Return what became of bodies.

    Parameters
    ----------
    pieces : sequence of Piece
        The bodies as they stood at first.
    place, turn : ndarray, shape (bodies, samples, 3) and (bodies, samples, 3, 3)
        Their poses.
    gaps : tuple of Gaps
        At first and at the end.
    given_up : bool
        Whether the run took too much work: then what became of them is not known.
    """
    first, last = gaps
    touching = last.bodies <= TOUCHES
    bears = _bears(pieces, first)
    fates: list[Fate] = []
    for b, piece in enumerate(pieces):
        turns, bearers = unrolled(piece, turn[b]), np.flatnonzero(bears[:, b]).tolist()
        tilt = tilts(piece.rest, turns)
        relative_poses = [_seen_from(a, b, place, turn) for a in bearers] or [(place[b], turn[b])]
        slid = max((_slid(piece, *poses) for poses in relative_poses), key=lambda each: each.way.max())
        if given_up or not np.isfinite(place[b]).all():
            fates.append(Fate(Outcome.FAILED, None, None, tilt, slid.way, slid.slide))
            continue
        overturned = _first(_lies(piece, place[b], turns, tilt))
        if overturned is None and touching[b].any():
            overturned = _since(tilt > LIES)
        fell_off = _falls_off(b, pieces, place, turn, bears, touching)
        # what it stands on and what stands on it do not hold it aside
        beside = touching[b] & ~bears[:, b] & ~bears[b]
        held = (last.room[b, 1:] <= TOUCHES).any() or beside.any()
        if fell_off is not None:
            outcome = Outcome.FELL_OFF
        elif overturned is not None:
            outcome = Outcome.OVERTURNED
        elif tilt[-1] > LEANS and held:
            outcome = Outcome.LEANING
        elif tilt.max() > ROCKING_TILT:
            outcome = Outcome.ROCKED
        elif slid.rolled:
            outcome = Outcome.ROLLED
        elif np.ptp(place[b, :, 2]) > LIFTED:  # as in the plane, in the air too
            outcome = Outcome.ROCKED
        else:
            moves = slid.way.max() > SLID or slid.turned > ROCKING_TILT
            outcome = Outcome.SLID if moves else Outcome.RESTED
        fates.append(Fate(outcome, overturned, fell_off, tilt, slid.way, slid.slide))
    return fates


class _Slid(NamedTuple):
    """How a body has slid: along x and y and in sum [m], whether it has rolled, and its turn in plan."""

    slide: NDArray[np.float64]
    way: NDArray[np.float64]
    rolled: bool
    turned: float


def _slid(piece: Piece, place: NDArray[np.float64], turn: NDArray[np.float64]) -> _Slid:
    """Return how a body has slid over what it stands on; see `slides`."""
    turns = unrolled(piece, turn)
    slide, rolls = slides(piece, place, turns), False
    x, y = slide.T
    distance = np.sqrt(x * x + y * y)
    if piece.round_side is not None:
        most = int(distance.argmax())
        rolls = max(SLID, 2.0 * np.linalg.norm((slide - rolled(piece, turn))[most])) < distance[most]
    turn_in_plan = np.abs(turns[:, :2, :2] - turns[0, :2, :2]).max()
    return _Slid(slide, distance, bool(rolls), float(turn_in_plan))


def _seen_from(
    a: int, b: int, place: NDArray[np.float64], turn: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the poses of a body as they are seen from another, as if that stayed where it stood at first."""
    back, first = np.swapaxes(turn[a], 1, 2), turn[a, 0]
    places = (back @ (place[b] - place[a])[:, :, np.newaxis])[:, :, 0]
    turns = back @ turn[b]
    # differences from the first sample: what does not move stays where it is, to the bit
    return place[b, 0] + (places - places[0]) @ first.T, turn[b, 0] + first @ (turns - turns[0])


def lies_on_floor(piece: Piece, place: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return whether a body is tilted by 90°, or touches the floor with more than its base, shape (samples,).

    More than its base is what is above the lowest tenth of its height, and above its feet. What lies on its
    round side at first has overturned where it stands on an end: where it is tilted by more than 45°.
    """
    return _lies(piece, place, turn, tilts(piece.rest, turn))


def _lies(
    piece: Piece, place: NDArray[np.float64], turn: NDArray[np.float64], tilt: NDArray[np.float64]
) -> NDArray[np.bool_]:
    """Return the same, given its tilt [rad]."""
    if piece.round_side is not None:
        return tilt > LIES
    z = piece.solid.vertices[:, 2]
    base = max(z.min() + BASE * np.ptp(z), piece.solid.base_points[:, 2].max())
    low = heights(piece.solid, place, turn, above=float(base))
    return (tilt >= math.pi / 2) | (low <= ON_THE_FLOOR)


def _bears(pieces: Sequence[Piece], first: Gaps) -> NDArray[np.bool_]:
    """Return which body bears which at first, shape (bodies, bodies): those that touch it from below.

    What stands on the floor too is borne by that.
    """
    if len(pieces) == 1:
        return np.zeros((1, 1), np.bool_)
    reach = [piece.reach((0.0, 0.0, 1.0)) for piece in pieces]
    low, top = (np.array(ends) for ends in zip(*reach, strict=True))
    below = top[:, np.newaxis] <= low + ON_THE_FLOOR
    return (first.bodies <= TOUCHES) & below & (first.room[:, 0] > TOUCHES)


def _falls_off(
    b: int,
    pieces: Sequence[Piece],
    place: NDArray[np.float64],
    turn: NDArray[np.float64],
    bears: NDArray[np.bool_],
    touching: NDArray[np.bool_],
) -> int | None:
    """Return the sample at which a body falls off what bears it, or None.

    It does where it touches the floor, or ends lower than it stood and touches none of what bore it. One that
    came down together with that, as pieces do that are joined, has not.
    """
    under = np.flatnonzero(bears[:, b])
    if len(under) == 0:
        return None
    left = np.ones(place.shape[1], np.bool_)
    for a in under.tolist():
        seen = np.einsum("sji,sj->si", turn[a], place[b] - place[a])
        left &= np.linalg.norm(seen - seen[0], axis=1) > LEFT
    low = heights(pieces[b].solid, place[b], turn[b])
    down = _first(left & (low <= ON_THE_FLOOR))
    if down is None and not touching[b, under].any():
        down = _since(left & (low < low[0] - LEFT))
    return down


def _first(happens: NDArray[np.bool_]) -> int | None:
    """Return the first sample at which something happens."""
    samples = np.flatnonzero(happens)
    return int(samples[0]) if len(samples) else None


def _since(happens: NDArray[np.bool_]) -> int | None:
    """Return the sample from which on something happens until the end."""
    if not happens[-1]:
        return None
    others = np.flatnonzero(~happens)
    return int(others[-1]) + 1 if len(others) else 0
