"""A run of the engine in space, from its records to its histories, and the gaps that it notes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError
from stayput.execution import endable
from stayput.mechanics.devices.columns import DEVICE, FORCES
from stayput.mechanics.space.columns import HISTORY, HIT, POSE, PULL
from stayput.mechanics.space.engine import FEW, MOST_UNCONVERGED, run_in_space
from stayput.mechanics.space.touching import ROOM
from stayput.motion.processing import refine
from stayput.simulation.space_records import scratch_of, surface_of

if TYPE_CHECKING:
    from stayput.motion.record import Motion

DEEPEST = 1e-6
"""How deep a body may begin inside another or a plane, by rounding [m]."""

TOUCHES = 1e-5
"""Gap up to which a body touches another or the room [m]."""


@dataclass(frozen=True, slots=True, eq=False)
class SpaceShaking:
    """A motion prepared for the engine in space: the floor's acceleration, shape (samples, 3), and its dt."""

    acceleration: NDArray[np.float64]
    dt: float

    @classmethod
    def of(cls, motion: Motion) -> SpaceShaking:
        """Return a motion along x, y and z."""
        components = motion.components
        each = [components.get(name, np.zeros(len(motion.x))) for name in "xyz"]
        return cls(np.stack(each, axis=1), motion.dt)

    def refined(self, parts: int) -> SpaceShaking:
        """Return the same with each step cut into so many parts, between which it is linear."""
        finer = [refine(component, parts) for component in self.acceleration.T]
        return SpaceShaking(np.stack(finer, axis=1), self.dt / parts)


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


def gaps_of(world: tuple[Any, ...], noted: NDArray[np.float64], back: NDArray[np.int64]) -> Gaps:
    """Return the gaps that the engine has noted.

    Parameters
    ----------
    world : tuple
        Bodies and room, from `stayput.simulation.space_records.world_of`.
    noted : ndarray, shape (features,)
        Gaps of points and rims from each plane, then of pairs of bodies.
    back : ndarray of int, shape (bodies,)
        The bodies' numbers in ``world``, in the order in which their gaps are returned.
    """
    bodies, points, rims, planes, pairs = world[:5]
    alone = len(planes) * (len(points) + len(rims))
    from_planes = noted[:alone].reshape(len(planes), -1)
    room = np.full((len(bodies), len(planes)), np.inf)
    for least, body in zip(room, bodies, strict=True):
        corners = slice(body["first_point"], body["first_point"] + body["points"])
        first_rim = len(points) + body["first_rim"]
        round_edges = slice(first_rim, first_rim + body["rims"])
        least[:] = np.concatenate([from_planes[:, corners], from_planes[:, round_edges]], axis=1).min(axis=1)
    between = np.full((len(bodies), len(bodies)), np.inf)
    between[pairs["a"], pairs["b"]] = between[pairs["b"], pairs["a"]] = noted[alone:]
    return Gaps(room[back], between[back][:, back])


def refuse_overlaps(planes: NDArray[np.void], gaps: Gaps, names: Sequence[str | Phrase]) -> None:
    """Raise `InputError` where a body begins inside the room or another."""
    for j, n in np.argwhere(gaps.room.T < -DEEPEST).tolist():
        surface, depth = phrase(f"simulation.{surface_of(planes[j])}"), -float(gaps.room[n, j])
        raise InputError("simulation.begins_inside", "pieces", piece=names[n], surface=surface, depth=depth)
    for second, first in np.argwhere(np.tril(gaps.bodies < -DEEPEST)).tolist():
        pair: dict[str, Any] = {"first": names[first], "second": names[second]}
        depth = -float(gaps.bodies[second, first])
        raise InputError("simulation.begin_in_each_other", "pieces", **pair, depth=depth)


SMOOTH, SMOOTH_REFINED = 0.3, 3.0
"""Largest angle by which a device's own vibration turns in a step [rad], which is stepped to a per cent then,
and in a refined one, whose halves grow from 4 on.
"""

STEP = 1e-3
"""Longest step that is not extrapolated [s]."""

LONGER, LONGER_HELD = 10.0, 20.0
"""The longest refined step over that; where devices hold a body, which may vibrate on them for as long as the
floor shakes.
"""

MOST_HITS = 10_000
"""Most hits that are listed."""

FIRST_WORK, WORK_A_SECOND = 2.5e8, 2.5e7
"""Work after which a run is given up, and more for each body and second, in contact updates (0.04 µs)."""


class SpaceTrace(NamedTuple):
    """What the engine returns.

    Parameters
    ----------
    place : ndarray, shape (bodies, samples, 3)
        Of the centres of gravity [m].
    attitude : ndarray, shape (bodies, samples, 4)
        Unit quaternions that turn the bodies' principal axes into the room's.
    velocity, rotation_rate : ndarray, shape (bodies, samples, 3)
        In the room's axes [m/s, rad/s].
    pressing : ndarray, shape (bodies, samples, 2, 3)
        What pressed on the bodies in the step before: the room, and other bodies [N].
    forces : ndarray, shape (samples, devices, 2)
        Of the devices, along the normal and the plane [N].
    springs : ndarray of SPRING, shape (devices,)
        The devices.
    devices : ndarray of DEVICE, shape (devices,)
        What became of them; forces in newtons.
    hits : ndarray of HIT
        The first hits.
    hit_numbers : ndarray of int64, shape (bodies + 1, 3)
        Hits of each body on floor, walls and ceiling, and other bodies; in the last row of all.
    peak_tilt : ndarray, shape (bodies,)
        Largest tilt at any step [rad].
    gaps : tuple of Gaps
        At first and at the end.
    steps, unconverged : int
        Steps, and those whose contact forces did not converge.
    given_up : bool
        Whether it took too much work, where bodies stay where they were then, or too many steps did not
        converge.
    """

    place: NDArray[np.float64]
    attitude: NDArray[np.float64]
    velocity: NDArray[np.float64]
    rotation_rate: NDArray[np.float64]
    pressing: NDArray[np.float64]
    forces: NDArray[np.float64]
    springs: NDArray[np.void]
    devices: NDArray[np.void]
    hits: NDArray[np.void]
    hit_numbers: NDArray[np.int64]
    peak_tilt: NDArray[np.float64]
    gaps: tuple[Gaps, Gaps]
    steps: int
    unconverged: int
    given_up: bool


def run_world(
    world: tuple[Any, ...],
    poses: NDArray[np.void],
    springs: NDArray[np.void],
    acceleration: NDArray[np.float64],
    dt: float,
    step: float,
    gravity: float,
    stop_after_rest: float,
    names: Sequence[str | Phrase],
) -> SpaceTrace:
    """Run bodies in a room.

    Parameters
    ----------
    world : tuple
        Bodies and room, from `world_of`.
    poses : ndarray of POSE, shape (bodies,)
        Where the bodies are at first.
    springs : ndarray of SPRING
        What holds them.
    acceleration : ndarray, shape (samples, 3)
        Of the floor [m/s²].
    dt, step : float
        Time between samples, and longest step that is not extrapolated [s].
    gravity : float
        g [m/s²].
    stop_after_rest : float
        How long all bodies lie before the run ends [s]: they stay where they are then.
    names : sequence of str or Phrase
        What refusals call the bodies.

    Raises
    ------
    InputError
        Bodies that begin inside each other, the floor or the ceiling.
    """
    bodies, samples = len(poses), len(acceleration)
    # impacts enlarge rounding: bodies run in the order of their places, however they are listed
    order = np.lexsort((poses["z"], poses["y"], poses["x"]))
    back = np.argsort(order)
    world, numbered = (world[0][order], *world[1:]), springs.copy()  # all pairs have one law
    numbered["body"], numbered["other"] = back[springs["body"]], np.append(back, ROOM)[springs["other"]]
    order_of_springs = np.lexsort((numbered["other"], numbered["body"]))
    numbered, back_of_springs = numbered[order_of_springs], np.argsort(order_of_springs)
    both = np.zeros((4, bodies), POSE)
    both[0] = poses[order]
    held = numbered, np.zeros(len(springs), PULL), np.zeros(len(springs), DEVICE)
    held[2]["failure_time"] = np.nan
    histories = np.zeros((bodies, samples, len(HISTORY)))
    forces, hits = np.zeros((samples, len(springs), FORCES)), np.empty(MOST_HITS, HIT)
    numbers, peaks, work = np.zeros((bodies + 1, 3), np.int64), np.zeros(bodies), np.zeros(4)
    work[3] = (FIRST_WORK + WORK_A_SECOND * bodies * dt * (samples - 1)) * max(1.0, STEP / step)
    output = histories, forces, hits, numbers, peaks, work
    omega, longer = fastest_vibration(numbered, world[0]), LONGER_HELD if len(springs) else LONGER
    longest, refined = min(step, dt, SMOOTH / omega), min(longer * step, SMOOTH_REFINED / omega)
    times = np.array([dt, longest, gravity, stop_after_rest, refined])
    scratch = scratch_of(world, len(springs))
    run_in_space(world, held, both, acceleration[:1], times, scratch, output)  # notes gaps, takes no step
    first = gaps_of(world, scratch[2][0], back)
    refuse_overlaps(world[3], first, names)
    endable(partial(run_in_space, world, held, both, acceleration, times, scratch, output), work[3:4])
    histories = histories[back] if bodies > 1 else histories  # no copy
    return SpaceTrace(
        histories[..., 0:3],
        histories[..., 3:7],
        histories[..., 7:10],
        histories[..., 10:13],
        histories[..., 13:19].reshape(bodies, samples, 2, 3),
        forces if (np.diff(back_of_springs) > 0).all() else forces[:, back_of_springs],
        springs,
        held[2][back_of_springs],
        _hits_of(hits[: min(len(hits), numbers[-1, 0])], order),
        np.concatenate([numbers[:-1][back], numbers[-1:]]),
        2.0 * np.arcsin(np.sqrt(0.5 * peaks[back])),
        (first, gaps_of(world, scratch[2][0], back)),
        int(work[0]),
        int(work[1]),
        bool(work[2] > work[3] or work[1] > max(FEW, MOST_UNCONVERGED * work[0])),
    )


def _hits_of(hits: NDArray[np.void], order: NDArray[np.int64]) -> NDArray[np.void]:
    """Return hits with the numbers that the bodies were given in; of two bodies the later one first."""
    hits = hits.copy()
    other = np.append(order, ROOM)[hits["b"]]
    hits["a"], hits["b"] = np.maximum(order[hits["a"]], other), np.minimum(order[hits["a"]], other)
    return hits


def fastest_vibration(springs: NDArray[np.void], bodies: NDArray[Any]) -> float:
    """Return a bound of the largest ω of bodies on their devices: above 0, also where there are none [rad/s].

    The fastest vibration of bodies that springs join is no faster than all of them together, each by itself
    with the others held.
    """
    squares = [_fastest_square(springs, body, n) for n, body in enumerate(bodies) if len(springs)]
    joined = bool((springs["other"] != ROOM).any())
    return math.sqrt(max(sum(squares) if joined else max(squares, default=0.0), 1e-30))


def _fastest_square(springs: NDArray[np.void], body: Any, number: int) -> float:
    """Return the largest ω² of a free body on its springs, each taken to be as stiff in all directions."""
    stiffness = np.zeros((6, 6))
    for spring in springs:
        for owner, names in ((spring["body"], ("px", "py", "pz")), (spring["other"], ("ax", "ay", "az"))):
            if owner == number:
                x, y, z = (float(spring[name]) for name in names)
                turned = np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]])
                rows = np.hstack([np.eye(3), turned])
                stiffness += float(np.max(spring["stiffness"])) * rows.T @ rows
    moments = [body["mass"]] * 3 + [body["i1"], body["i2"], body["i3"]]
    root = 1.0 / np.sqrt(moments)
    return float(np.linalg.eigvalsh(root[:, np.newaxis] * stiffness * root)[-1])
