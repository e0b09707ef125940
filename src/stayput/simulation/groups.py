"""Bodies that cannot reach each other run each by themselves: what each does has the bits that it has alone.

A body lies in the sphere about its centre of gravity that holds it whichever way it turns. Bodies run
together where they are joined, and where their spheres meet: at first, or at any time of runs without each
other, which are then made again with both.
"""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from stayput.mechanics.space.touching import ROOM
from stayput.simulation.space_engine import MOST_HITS, Gaps, SpaceTrace

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from numpy.typing import NDArray

    from stayput.model.solid import Solid

Group: TypeAlias = tuple[int, ...]
"""Numbers of bodies, in order."""

PER_BODY = ("place", "attitude", "velocity", "rotation_rate", "pressing", "peak_tilt")
"""Arrays of a `SpaceTrace` whose first axis is that of the bodies."""


def run_in_groups(
    run: Callable[[Group, NDArray[np.void]], SpaceTrace],
    solids: list[Solid],
    poses: NDArray[np.void],
    springs: NDArray[np.void],
    dt: float,
) -> SpaceTrace:
    """Run bodies, those together that can reach each other.

    Parameters
    ----------
    run : callable
        Runs a group with its springs, whose bodies are numbered by their places in the group.
    solids : list of Solid
        The bodies.
    poses : ndarray of POSE, shape (bodies,)
        Where they are at first.
    springs : ndarray of SPRING
        What holds and joins them.
    dt : float
        Time between the samples [s].
    """
    if len(solids) == 1:
        return run((0,), springs)
    reach = np.array(
        [np.linalg.norm(solid.vertices - solid.centre_of_gravity, axis=1).max() for solid in solids]
    )
    places = np.stack([poses[axis] for axis in "xyz"], 1)
    bonds = [(int(spring["body"]), int(spring["other"])) for spring in springs if spring["other"] != ROOM]
    near = [
        (a, b)
        for a, b in combinations(range(len(solids)), 2)
        if np.linalg.norm(places[a] - places[b]) <= reach[a] + reach[b]
    ]
    groups = _merged([(body,) for body in range(len(solids))], [*bonds, *near])
    traces: dict[Group, SpaceTrace] = {}
    while True:
        for group in groups:
            if group not in traces:
                traces[group] = run(group, _of_group(springs, group))
        meeting = [
            (group[0], other[0])
            for group, other in combinations(groups, 2)
            if _meet(group, other, traces, reach, dt)
        ]
        if not meeting:
            break
        groups = _merged(groups, meeting)
    if len(groups) == 1:
        return traces[groups[0]]
    return _joined({group: traces[group] for group in groups}, springs)


def _merged(groups: list[Group], pairs: Iterable[tuple[int, int]]) -> list[Group]:
    """Return groups of which those are one that have a body of a pair each."""
    for a, b in pairs:
        joined = sorted({body for group in groups if a in group or b in group for body in group})
        groups = [group for group in groups if group[0] not in joined] + [tuple(joined)]
    return sorted(groups)


def _of_group(springs: NDArray[np.void], group: Group) -> NDArray[np.void]:
    chosen = springs[np.isin(springs["body"], group)].copy()
    chosen["body"] = np.searchsorted(group, chosen["body"])
    joined = chosen["other"] != ROOM
    chosen["other"][joined] = np.searchsorted(group, chosen["other"][joined])
    return chosen


def _meet(
    group: Group, other: Group, traces: dict[Group, SpaceTrace], reach: NDArray[np.float64], dt: float
) -> bool:
    """Return whether the spheres of two groups meet at a sample, or may have on the way to the next."""
    here, there = traces[group], traces[other]
    for i, body in enumerate(group):
        for j, further in enumerate(other):
            apart = np.linalg.norm(here.place[i] - there.place[j], axis=1)
            speed = np.linalg.norm(here.velocity[i] - there.velocity[j], axis=1)
            if (apart <= reach[body] + reach[further] + dt * speed).any():
                return True
    return False


def _joined(traces: dict[Group, SpaceTrace], springs: NDArray[np.void]) -> SpaceTrace:
    """Return the runs of groups as one."""
    order = np.argsort([body for group in traces for body in group])
    arrays = {
        name: np.concatenate([getattr(trace, name) for trace in traces.values()])[order] for name in PER_BODY
    }
    of_springs = np.argsort(
        np.concatenate([np.flatnonzero(np.isin(springs["body"], group)) for group in traces])
    )
    hits = np.concatenate([_numbered(trace.hits, group) for group, trace in traces.items()])
    numbers = np.concatenate([trace.hit_numbers[:-1] for trace in traces.values()])[order]
    total = np.sum([trace.hit_numbers[-1:] for trace in traces.values()], axis=0)
    return SpaceTrace(
        **arrays,
        forces=np.concatenate([trace.forces for trace in traces.values()], axis=1)[:, of_springs],
        springs=springs,
        devices=np.concatenate([trace.devices for trace in traces.values()])[of_springs],
        hits=hits[np.argsort(hits["time"], kind="stable")][:MOST_HITS],
        hit_numbers=np.concatenate([numbers, total]),
        gaps=(_gaps(traces, order, 0), _gaps(traces, order, 1)),
        steps=sum(trace.steps for trace in traces.values()),
        unconverged=sum(trace.unconverged for trace in traces.values()),
        error=max(trace.error for trace in traces.values()),
        given_up=any(trace.given_up for trace in traces.values()),
    )


def _numbered(hits: NDArray[np.void], group: Group) -> NDArray[np.void]:
    """Return the hits of a group with the numbers of its bodies among all."""
    hits, numbers = hits.copy(), np.append(group, ROOM)
    hits["a"], hits["b"] = numbers[hits["a"]], numbers[hits["b"]]
    return hits


def _gaps(traces: dict[Group, SpaceTrace], order: NDArray[np.intp], when: int) -> Gaps:
    """Return the gaps of all bodies, at first (0) or at the end (1); groups are infinitely far apart."""
    room = np.concatenate([trace.gaps[when].room for trace in traces.values()])
    bodies, first = np.full((len(room), len(room)), np.inf), 0
    for trace in traces.values():
        last = first + len(trace.gaps[when].room)
        bodies[first:last, first:last] = trace.gaps[when].bodies
        first = last
    return Gaps(room[order], bodies[np.ix_(order, order)])
