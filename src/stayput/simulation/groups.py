"""Pieces run each by themselves until they meet: what one does has the bits that it has alone.

Pieces run together where they are joined or stand on or close beside each other, and where they come together
in runs without each other, which are then made again with both. Tracks say how bodies moved while they were
away from where they stood, and so which met. A body that comes back to where it stood takes up no other part
of the room: samples at which nothing changes, and tracks of less than `STIRS`, are left out.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, reduce
from itertools import combinations
from typing import TYPE_CHECKING, NamedTuple, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from stayput.mechanics.space.touching import ROOM
from stayput.simulation.piece import Convex, ConvexShape, Piece, separation
from stayput.simulation.space_engine import MOST_HITS, Gaps, SpaceTrace
from stayput.simulation.space_fate import falling
from stayput.simulation.space_records import Path, moved_samples

if TYPE_CHECKING:
    from stayput.simulation.placement import Placement
    from stayput.simulation.run import Run
    from stayput.simulation.scene import Scene


STIRS = 0.01
"""Way of a body's corner up to which it stays where it stood [m]."""


@dataclass(frozen=True, eq=False)
class Track:
    """Where a body was in a run.

    Parameters
    ----------
    piece : Piece
        The body as it stood at first.
    sample : ndarray of int, shape (k,)
        Samples of the motion at which it has just moved; the first is 0.
    place : ndarray, shape (k, 3)
        Of its centre of gravity in the room [m].
    turn : ndarray, shape (k, 3, 3)
        The rotation of its frame into the room's.
    energy : ndarray, shape (k,)
        Kinetic energy [J].
    dt : float
        Time between samples [s].
    """

    piece: Piece
    sample: NDArray[np.intp]
    place: NDArray[np.float64]
    turn: NDArray[np.float64]
    energy: NDArray[np.float64]
    dt: float

    @property
    def shape(self) -> ConvexShape:
        """The body."""
        return ConvexShape.of(self.piece.solid)

    @cached_property
    def falls(self) -> NDArray[np.bool_]:
        """Whether it falls at these samples: see `stayput.simulation.space_fate.falling`."""
        return falling(self.piece, self.place, self.turn)

    @property
    def stays(self) -> bool:
        """Whether it has not stirred."""
        return len(self.sample) == 1

    @cached_property
    def bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The least and the most of its corners at these samples [m], each of shape (k, 3)."""
        # a product for each axis instead of many small ones; then one corner after the other: these are few
        along = [self.shape.corners @ self.turn[:, axis].T for axis in range(3)]
        low, high = (
            np.stack([reduce(extreme, of_corners) for of_corners in along], axis=1) + self.place
            for extreme in (np.minimum, np.maximum)
        )
        return low, high

    @cached_property
    def span(self) -> NDArray[np.float64]:
        """The least and the most of its corners at any time [m], shape (2, 3)."""
        low, high = self.bounds
        return np.stack([low.min(axis=0), high.max(axis=0)])

    def corners(self, chosen: slice | NDArray[np.intp] = slice(None)) -> NDArray[np.float64]:
        """Return where its corners are at some of the samples [m], shape (k, n, 3)."""
        corners = self.shape.corners @ np.swapaxes(self.turn[chosen], 1, 2)
        return corners + self.place[chosen][:, np.newaxis]

    def outline(self, number: int) -> NDArray[np.float64]:
        """Return what it covers in plan at the number-th of its samples: corners in order, shape (n, 2)."""
        return outline_of(self.corners(np.array([number]))[0])

    def placed(self, axes: Placement) -> Track:
        """Return it in the room in which its axes stand."""
        turn = np.swapaxes(axes.directions(np.swapaxes(self.turn, 1, 2)), 1, 2)
        return replace(self, place=axes.points(self.place), turn=turn)


def at_rest(piece: Piece, dt: float = 1.0) -> Track:
    """Return the track of a piece that stays where it stands."""
    pose = piece.place[np.newaxis], piece.turn[np.newaxis]
    return Track(piece, np.zeros(1, np.intp), *pose, np.zeros(1), dt)


def outline_of(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the convex outline in plan of points [m], counter-clockwise, shape (n, 2)."""
    from scipy.spatial import ConvexHull  # which a lone piece need not load

    plan = corners[:, :2]
    return plan[ConvexHull(plan).vertices]


def tracks_of(pieces: Sequence[Piece], trace: SpaceTrace | Run, dt: float, path: Path) -> list[Track]:
    """Return the tracks of the bodies of a run.

    Parameters
    ----------
    pieces : sequence of Piece
        The bodies.
    trace : SpaceTrace or Run
        How they moved.
    dt : float
        Time between samples [s].
    path : Path
        Their poses where they move.
    """
    tracks: list[Track] = []
    for b, piece in enumerate(pieces):
        shape, place, turn = ConvexShape.of(piece.solid), path.place[b], path.turn[b]
        moved = stirring(shape, place, turn)
        sample = path.sample[moved]
        v, w = trace.velocity[b, sample], trace.rotation_rate[b, sample]
        spin = np.einsum("kji,kj->ki", turn[moved], w)
        energy = 0.5 * (
            shape.mass * np.sum(v * v, axis=1) + np.einsum("ki,ij,kj->k", spin, shape.inertia, spin)
        )
        poses = place[moved], np.ascontiguousarray(turn[moved])
        tracks.append(Track(piece, sample, *poses, energy, dt))
    return tracks


def stirring(shape: ConvexShape, place: NDArray[np.float64], turn: NDArray[np.float64]) -> NDArray[np.intp]:
    """Return the samples at which a body is elsewhere than at the sample before, and the first."""
    if not np.isfinite(place).all():
        return np.zeros(1, np.intp)
    moved, _ = moved_samples(place, turn)
    reach = np.linalg.norm(shape.corners, axis=1).max()
    way = np.linalg.norm(place[moved] - place[0], axis=1)
    way += reach * np.linalg.norm(turn[moved] - turn[0], axis=(1, 2))
    away = np.flatnonzero(way > STIRS)
    # up to the sample after the last at which it is away: it may have come back
    return moved[: away[-1] + 2] if len(away) else moved[:1]


def body_at(track: Track, chosen: NDArray[np.intp]) -> Convex:
    """Return the body of a track at some of its samples."""
    back = np.swapaxes(track.turn[chosen], 1, 2)
    return Convex(track.corners(chosen), track.shape.normals @ back, track.shape.edges @ back)


def apart(span: NDArray[np.float64], other: NDArray[np.float64]) -> bool:
    """Return whether two boxes do not touch, given their least and most corners, shape (2, 3)."""
    return bool((span[0] > other[1]).any() or (other[0] > span[1]).any())


def meet(track: Track, other: Track) -> bool:
    """Return whether two pieces come together that were run each by itself under the same motion."""
    if (track.stays and other.stays) or apart(track.span, other.span):
        return False
    sample = np.union1d(track.sample, other.sample)
    first, second = (np.searchsorted(run.sample, sample, side="right") - 1 for run in (track, other))
    (low, high), (least, most) = track.bounds, other.bounds
    near = np.all((low[first] <= most[second]) & (high[first] >= least[second]), axis=1)

    def gap_at(k: NDArray[np.intp]) -> NDArray[np.float64]:
        return separation(body_at(track, first[k]), body_at(other, second[k]))

    return touching_of(sample, near, track.dt, gap_at) is not None


class Touching(NamedTuple):
    """How two bodies touch.

    Parameters
    ----------
    time : float
        When they first touch [s].
    closing : float
        How fast they close in then [m/s].
    places : ndarray of int
        At which samples they touch.
    depths : ndarray, shape of places
        How far they are in each other there [m].
    """

    time: float
    closing: float
    places: NDArray[np.intp]
    depths: NDArray[np.float64]


def touching_of(
    sample: NDArray[np.intp],
    near: NDArray[np.bool_],
    dt: float,
    gap_at: Callable[[NDArray[np.intp]], NDArray[np.float64]],
) -> Touching | None:
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
    return Touching(time, (gap + overlap) / dt, chosen[1:][together], -gaps[1:][together])


Group: TypeAlias = tuple[int, ...]
"""Numbers of pieces, in order."""

PER_BODY = ("place", "attitude", "velocity", "rotation_rate", "pressing", "peak_tilt")
"""Arrays of a `SpaceTrace` whose first axis is that of the bodies."""

BESIDE = 2.0 * STIRS
"""Distance up to which pieces run together from the beginning [m]: tracks leave out ways of half of it."""

RunT = TypeVar("RunT")


def groups_at_first(scene: Scene) -> list[Group]:
    """Return which pieces of a scene run together from the beginning, in the order of the first of each."""
    count, at_first = len(scene.pieces), [at_rest(piece) for piece in scene.pieces]
    none = np.zeros(1, np.intp)
    pairs = [(joint.first, joint.second) for joint in scene.joints]
    for a, b in combinations(range(count), 2):
        (low, high), (least, most) = at_first[a].bounds, at_first[b].bounds
        if (low <= most + BESIDE).all() and (least <= high + BESIDE).all():
            gap = separation(body_at(at_first[a], none), body_at(at_first[b], none))
            if gap[0] <= BESIDE:
                pairs.append((a, b))
    return _merged([(number,) for number in range(count)], pairs)


def groups_of_falls(scene: Scene) -> list[Group]:
    """Return which pieces of a scene a verification runs together, in the order of the first of each.

    Those of which one stands on the other, that are joined, or that stand in rows: parallel, and so close
    that one falls onto the other's base. What else meets hardly changes who falls, and takes most time.
    """
    pieces, pairs = scene.pieces, [(joint.first, joint.second) for joint in scene.joints]
    bodies = [body_at(at_rest(piece), np.zeros(1, np.intp)) for piece in pieces]
    spans = [span_of(body) for body in bodies]
    floors = [swept_floor(piece) for piece in pieces]
    swept = [span_of(floor) for floor in floors]
    falls = [piece.turn[:2, falls_across(piece)] for piece in pieces]
    for a, b in combinations(range(len(pieces)), 2):
        (low, high), (least, most) = spans[a], spans[b]
        overlaps = (low <= most + BESIDE).all() and (least <= high + BESIDE).all()
        stands = min(abs(low[2] - most[2]), abs(least[2] - high[2])) <= BESIDE
        if (overlaps and stands) or any(
            abs(falls[striker] @ falls[struck]) > math.sqrt(0.5)  # to within 45°: it strikes the broad side
            and not apart(swept[striker], spans[struck])
            and separation(floors[striker], bodies[struck])[0] <= 0.0
            for striker, struck in ((a, b), (b, a))
        ):
            pairs.append((a, b))
    return _merged([(number,) for number in range(len(pieces))], pairs)


def span_of(body: Convex) -> NDArray[np.float64]:
    """Return the least and the most of the corners of a body that is at one place [m], shape (2, 3)."""
    return np.stack([body.corners[0].min(axis=0), body.corners[0].max(axis=0)])


MUCH_DEEPER = 1.5
"""A piece falls to its front or back, unless it is deeper than long by this factor: to its sides then."""


def falls_across(piece: Piece) -> int:
    """Return along which axis of its own frame a piece mostly falls: x (0), to front or back, or y (1)."""
    depth, length = np.ptp(piece.solid.vertices[:, :2], axis=0)
    return 0 if depth <= MUCH_DEEPER * length else 1


def swept_floor(piece: Piece) -> Convex:
    """Return the floor over which a piece comes in falling, to either side."""
    low, high = piece.solid.vertices.min(axis=0), piece.solid.vertices.max(axis=0)
    reach = np.zeros(2)
    reach[falls_across(piece)] = high[2] - low[2] + piece.at[2]
    (x_low, y_low), (x_high, y_high) = low[:2] - reach, high[:2] + reach
    corners = np.array(
        [(x, y, z) for x in (x_low, x_high) for y in (y_low, y_high) for z in (-piece.at[2], high[2])]
    )
    axes = np.eye(3)[np.newaxis] @ piece.turn.T
    return Convex((corners @ piece.turn.T + np.asarray(piece.at))[np.newaxis], axes, axes)


def run_in_groups(
    groups: list[Group], run: Callable[[Group], RunT], tracks_of: Callable[[RunT], Sequence[Track]]
) -> dict[Group, RunT]:
    """Run pieces, those together that meet.

    Parameters
    ----------
    groups : list of Group
        Those that run together from the beginning; see `groups_at_first`.
    run : callable
        Runs a group.
    tracks_of : callable
        Returns where its pieces were, in their order.
    """
    ran: dict[Group, RunT] = {}
    while True:
        ran |= {group: run(group) for group in groups if group not in ran}
        tracks = {group: tracks_of(ran[group]) for group in groups} if len(groups) > 1 else {}
        meeting = [
            (group[0], other[0])
            for group, other in combinations(groups, 2)
            if any(meet(track, further) for track in tracks[group] for further in tracks[other])
        ]
        if not meeting:
            return {group: ran[group] for group in groups}
        groups = _merged(groups, meeting)


def _merged(groups: list[Group], pairs: Iterable[tuple[int, int]]) -> list[Group]:
    """Return groups of which those are one that have a piece of a pair each."""
    for a, b in pairs:
        joined = sorted({number for group in groups if a in group or b in group for number in group})
        groups = [group for group in groups if group[0] not in joined] + [tuple(joined)]
    return sorted(groups)


def joined_traces(traces: dict[Group, SpaceTrace], springs_of: Sequence[Sequence[int]]) -> SpaceTrace:
    """Return the runs of groups as one.

    Parameters
    ----------
    traces : dict
        The run of each group; its bodies are numbered by their places in the group.
    springs_of : sequence of sequence of int
        Where the springs of each trace are among all.
    """
    order = np.argsort([body for group in traces for body in group])
    arrays = {
        name: np.concatenate([getattr(trace, name) for trace in traces.values()])[order] for name in PER_BODY
    }
    of_springs = np.argsort(np.concatenate([np.array(places, np.intp) for places in springs_of]))
    hits = np.concatenate([_numbered(trace.hits, group, "a", "b") for group, trace in traces.items()])
    springs = [_numbered(trace.springs, group, "body", "other") for group, trace in traces.items()]
    numbers = np.concatenate([trace.hit_numbers[:-1] for trace in traces.values()])[order]
    total = np.sum([trace.hit_numbers[-1:] for trace in traces.values()], axis=0)
    return SpaceTrace(
        **arrays,
        forces=np.concatenate([trace.forces for trace in traces.values()], axis=1)[:, of_springs],
        springs=np.concatenate(springs)[of_springs],
        devices=np.concatenate([trace.devices for trace in traces.values()])[of_springs],
        hits=hits[np.argsort(hits["time"], kind="stable")][:MOST_HITS],
        hit_numbers=np.concatenate([numbers, total]),
        gaps=(_gaps(traces, order, 0), _gaps(traces, order, 1)),
        steps=sum(trace.steps for trace in traces.values()),
        unconverged=sum(trace.unconverged for trace in traces.values()),
        given_up=any(trace.given_up for trace in traces.values()),
    )


def _numbered(rows: NDArray[np.void], group: Group, *names: str) -> NDArray[np.void]:
    """Return rows of a group with the numbers of its bodies among all."""
    rows, numbers = rows.copy(), np.append(group, ROOM)
    for name in names:
        rows[name] = numbers[rows[name]]
    return rows


def _gaps(traces: dict[Group, SpaceTrace], order: NDArray[np.intp], when: int) -> Gaps:
    """Return the gaps of all bodies, at first (0) or at the end (1); groups are infinitely far apart."""
    room = np.concatenate([trace.gaps[when].room for trace in traces.values()])
    bodies, first = np.full((len(room), len(room)), np.inf), 0
    for trace in traces.values():
        last = first + len(trace.gaps[when].room)
        bodies[first:last, first:last] = trace.gaps[when].bodies
        first = last
    return Gaps(room[order], bodies[np.ix_(order, order)])
