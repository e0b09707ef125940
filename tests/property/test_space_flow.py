"""The law stands twice: with all contacts for a step, and for a flow with contacts that are known to press.

At random states on a corner, an edge or a base the impulses of a short step over its length are the forces of
the flow.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import stayput as sp
from stayput.compiling import entry
from stayput.mechanics.space.active_set import note_slips, set_friction_levers, set_levers
from stayput.mechanics.space.body import set_attitude
from stayput.mechanics.space.closing import OPEN, keep
from stayput.mechanics.space.flow import begin_flow
from stayput.mechanics.space.flow_step import evaluate
from stayput.mechanics.space.stepping import step
from stayput.mechanics.space.stuck_edge import begin_on_edge, press_on_edge, turn_on_edge
from stayput.simulation import space_engine

SHORT = 1e-6
"""Length of the step [s]."""

GRAVITY = 9.80665


@entry
def forces_of(world: Any, held: Any, poses: Any, scratch: Any, push: Any, work: Any, forces: Any) -> None:
    """Set the forces of all points, of a step in row 0, of a flow in row 1; row 2 tells whether it flows."""
    contacts, kept, memory = scratch[0], scratch[1][0], scratch[12]
    flow, pressing, body = memory[0][0], memory[1], world[0][0]
    weight = body.mass * GRAVITY
    p = push[0], push[1], push[2]
    set_attitude(body, poses[0, 0], (poses[0, 0].qw, poses[0, 0].qx, poses[0, 0].qy, poses[0, 0].qz))
    count = 0
    for _ in range(60):  # friction acts about the centre of pressure of the step before
        count, _, _ = step(world, held, poses[0], poses[1], p, SHORT, SHORT, scratch, kept, 1.0, work)
        for c in contacts[:count]:
            c.stuck, c.when = int(kept[c.key, 3]), 1.0
        keep(contacts, count, kept, scratch[7][3])
    for c in contacts[:count]:
        forces[0, c.key, 0], forces[0, c.key, 1], forces[0, c.key, 2] = (
            c.pn / SHORT,
            c.ps / SHORT,
            c.pt / SHORT,
        )
    begin_flow(world, poses[0], contacts, count, SHORT, GRAVITY, memory)
    forces[2, 0, 0] = flow.ready
    if flow.ready == 0:
        return
    poses[1, 0] = poses[0, 0]
    set_levers(flow, pressing, world[1], poses[1, 0])
    set_friction_levers(flow, pressing, world[3], poses[1, 0])
    note_slips(flow, pressing)
    if flow.on_edge:
        begin_on_edge(flow, pressing, body, world[1], poses[1, 0])
        change = turn_on_edge(flow, world, held, poses[1], 0.0, flow.rate, p)
        forces[2, 0, 1] = press_on_edge(flow, pressing, body, poses[1, 0], 0.0, flow.rate, change, p, weight)
    else:
        evaluate(flow, world, held, poses[1], p, memory, memory[3][0])
    for k in range(flow.count):
        c = pressing[k]
        forces[1, c.key, 0], forces[1, c.key, 1], forces[1, c.key, 2] = c.pn, c.ps, c.pt


def memory_of(monkeypatch: pytest.MonkeyPatch, body: sp.Body, floor: sp.Floor) -> tuple[Any, ...]:
    """Return world, devices, poses and working memory of a lone body."""
    passed: list[Any] = []
    run = space_engine.run_in_space
    monkeypatch.setattr(space_engine, "run_in_space", lambda *given: (passed.append(given), run(*given))[1])
    sp.simulate(sp.Piece(body), sp.Room(floor), sp.Motion(dt=0.01, x=np.zeros(2)))
    world, held, poses, _, _, scratch, _ = passed[-1]
    return world, held, poses, scratch


def turn_of(q: np.ndarray) -> np.ndarray:
    w, x, y, z = q
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def product(q: np.ndarray, r: np.ndarray) -> np.ndarray:
    return np.array([q[0] * r[0] - q[1:] @ r[1:], *(q[0] * r[1:] + r[0] * q[1:] + np.cross(q[1:], r[1:]))])


def about(axis: np.ndarray, angle: float) -> np.ndarray:
    return np.array([math.cos(0.5 * angle), *(math.sin(0.5 * angle) * axis)])


@pytest.mark.long  # it compiles steps and flows into an entry of its own
@pytest.mark.parametrize(
    ("points", "sticks"), [(1, True), (2, True), (1, False), (2, False), (4, False)]
)  # what sticks on four rests
def test_a_flow_has_the_forces_of_a_short_step(
    points: int, sticks: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    rng = np.random.default_rng([points, sticks])
    compared = 0
    for _ in range(40):
        body = sp.Body.box(*rng.uniform(0.3, 0.8, 2), rng.uniform(0.8, 1.8), 80.0)
        friction = float(rng.uniform(0.4, 0.9))
        with monkeypatch.context() as patched:
            world, held, poses, scratch = memory_of(patched, body, sp.Floor(friction, 0.8 * friction))
        s, solid = poses[0, 0], world[0][0]
        corners = np.array([[point[axis] for axis in "xyz"] for point in world[1]])
        # onto an edge, or on along it onto a corner
        q = np.array([s["qw"], s["qx"], s["qy"], s["qz"]])
        tilt = rng.uniform(0.02, 0.15) if points < 4 else 0.0
        q = product(about(np.array([0.0, 1.0, 0.0]), tilt), q)
        if points == 1:
            q = product(about(np.array([1.0, 0.0, 0.0]), rng.uniform(0.02, 0.1)), q)
        q = product(about(np.array([0.0, 0.0, 1.0]), rng.uniform(0.0, 6.0)), q)
        levers = corners @ turn_of(q).T
        low = np.argsort(levers[:, 2])[:points]
        lever = levers[low].mean(axis=0)
        spin = rng.normal(0.0, 0.3, 3)
        if points == 2:
            along = levers[low[1]] - levers[low[0]]
            spin = along / np.linalg.norm(along) * 0.3 * rng.normal()
        if points == 4:
            spin[:] = 0.0
        if not sticks and points == 2:
            spin[2] += 0.1 * rng.normal()
        velocity = -np.cross(spin, lever)
        if not sticks:
            velocity[:2] += 0.1 * rng.normal(size=2)
        place = -levers[:, 2].min()
        moments = np.array([solid["i1"], solid["i2"], solid["i3"]])
        momentum = turn_of(q) @ (moments * (turn_of(q).T @ spin))
        for name, number in zip(
            ("x", "y", "z", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "lx", "ly", "lz"),
            (0.0, 0.0, place, *q, *velocity, *momentum),
            strict=True,
        ):
            poses[0, 0][name] = number
        kept = scratch[1][0]
        kept[:, 3] = OPEN
        kept[low, 3], kept[low, 4] = float(sticks), 1.0
        forces = np.zeros((3, len(corners), 3))
        push = np.array([*rng.normal(0.0, 0.2 if points == 4 else 0.8, 2), -GRAVITY])
        forces_of(world, held, poses, scratch, push, np.zeros(4), forces)
        weight = solid["mass"] * GRAVITY
        stepped, flowing = forces[0], forces[1]
        if not forces[2, 0, 0] or flowing[low, 0].min() <= 0.0:
            continue  # a corner lifts
        if sticks and (np.linalg.norm(flowing[low, 1:], axis=1) > 0.95 * friction * flowing[low, 0]).any():
            continue  # friction gives way
        if points == 4 or (points == 2 and sticks):  # that share as they like, along an edge
            stepped, flowing = stepped.sum(axis=0), flowing.sum(axis=0)
        # where something slips, sweeps end a little beside the direction of its friction
        assert flowing == pytest.approx(stepped, abs=(1e-4 if sticks else 5e-4) * weight)
        compared += 1
    assert compared >= 4


def test_a_step_that_an_event_cut_short_does_not_shorten_later_ones() -> None:
    """Devices that yield end steps early; a flow that began so short was left at once for plain steps."""
    motion = sp.synthetic_suite("mixed", 4, seed=1)[3].to_intensity("6-upper")
    room = sp.Room(sp.Floor.of("wood flooring"), left_wall=sp.Wall(0.02))
    body, bracket = sp.Body(0.3, 1.8, 100.0, length=0.9), sp.MEASURES["l_bracket"]()
    run = sp.simulate(body, room, motion, measures=[bracket], dimensions=3)
    assert run.steps < 200.0 * motion.duration  # 245 a second where it was so


def test_a_body_that_creeps_against_a_wall_stops() -> None:
    """Else its contacts stick and slip in turn: in some of these runs in ten thousand steps of 1 µs."""
    motion = sp.synthetic_suite("mixed", 40, seed=5)[35].to_intensity("6-upper").scaled(0.80308651)
    room = sp.Room(sp.Floor(0.31030512, 0.24824409), left_wall=sp.Wall(0.01042447))
    for wider in np.linspace(0.0, 1e-6, 6).tolist():
        body = sp.Body(0.29432098 + wider, 1.79184916, 80.0, length=0.9)
        assert sp.simulate(body, room, motion, dimensions=3).steps < 200 * motion.duration
