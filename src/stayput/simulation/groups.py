"""Pieces run each by themselves until they meet: what one does has the bits that it has alone.

Pieces run together where they are joined or stand on or close beside each other, and where they come together
in runs without each other, which are then made again with both.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import combinations
from typing import TYPE_CHECKING, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from stayput.mechanics.space.touching import ROOM
from stayput.simulation.convex import separation
from stayput.simulation.space_engine import MOST_HITS, Gaps, SpaceTrace
from stayput.simulation.tracks import STIRS, Track, at_rest, body_at, bounds_of, meet

if TYPE_CHECKING:
    from stayput.simulation.scene import Scene

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
    bounds, none = [bounds_of(track.corners()) for track in at_first], np.zeros(1, np.intp)
    pairs = [(joint.first, joint.second) for joint in scene.joints]
    for a, b in combinations(range(count), 2):
        (low, high), (least, most) = bounds[a], bounds[b]
        if (low <= most + BESIDE).all() and (least <= high + BESIDE).all():
            gap = separation(body_at(at_first[a], none), body_at(at_first[b], none))
            if gap[0] <= BESIDE:
                pairs.append((a, b))
    return _merged([(number,) for number in range(count)], pairs)


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
        error=max(trace.error for trace in traces.values()),
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
