"""The limits of rest: below them a body never moves, just above them it does."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import (
    COULOMB,
    LAWS,
    SEEDS,
    Seeded,
    Source,
    Standing,
    random_body,
    random_samples,
    sources,
    up,
)

from stayput import Floor, Motion, Room, State, Wall
from stayput.mechanics.runner import run_cases, shaking
from stayput.model.parameters import STANDARD_GRAVITY

if TYPE_CHECKING:
    from numpy.typing import NDArray


def run(cases: NDArray[np.void], motion: Motion, law: int) -> NDArray[np.void]:
    return run_cases(cases, shaking(motion.x, up(motion), motion.dt, law), max_events=20_000)


def resting_case(source: Source) -> tuple[Standing, float]:
    """Return a body that can stand, with flush walls or none, and what it bears of ẍ_G/G."""
    while True:
        body = random_body(source)
        a, b = body.corners[:2]
        tilt = body.resting_tilt
        sin, cos = math.sin(tilt), math.cos(tilt)
        (x_a, z_a), (x_b, z_b) = ((u * cos + v * sin, v * cos - u * sin) for u, v in (a, b))
        bears = min(-x_a / -z_a, x_b / -z_b)
        if bears > 1e-3:
            break
    static = source.uniform(0.05, 1.2)
    wall = Wall(0.0, 0.3, source.uniform(0.0, 1.0))
    how = source.whole(0, 3)
    room = Room(
        Floor(static, static * source.uniform(0.0, 1.0)), wall if how & 1 else None, wall if how & 2 else None
    )
    return Standing(body, room, State()), min(static, bears)


def check_body_below_its_limits_never_moves(source: Source, law: int, count: int) -> None:
    dt = source.uniform(0.01, 0.05)
    n = int(600.0 / dt)
    vertical = source.whole(0, 1)
    z = random_samples(source, n, dt, 0.5 * STANDARD_GRAVITY, 0) * vertical
    x = random_samples(source, n, dt, 1.0, source.whole(0, 3))
    G = STANDARD_GRAVITY + (z if law == COULOMB else np.zeros(n))
    for _ in range(count):
        case, ratio = resting_case(source)
        least = np.minimum(G, np.minimum(np.append(G[1:], G[-1]), np.insert(G[:-1], 0, G[0])))
        motion = Motion(dt, 0.99 * ratio * least * x / max(1.0, np.abs(x).max()), z=z)
        result = run(case.columns(), motion, law)[0]
        assert result["outcome"] == 0, (result, case, motion)
        assert result["residual_slide"] == 0.0
        assert result["peak_slide"] == 0.0
        assert result["peak_tilt"] == result["residual_tilt"] == 0.0
        assert result["events"] == 0


def check_body_just_above_its_limits_moves(source: Source, count: int) -> None:
    for _ in range(count):
        case, ratio = resting_case(source)
        case = Standing(case.body, Room(case.room.floor), State())
        x = np.zeros(200)
        x[50:150] = 1.01 * ratio * STANDARD_GRAVITY * (1 if source.whole(0, 1) else -1)
        both = [run(case.columns(), Motion(0.01, sign * x), COULOMB)[0] for sign in (1.0, -1.0)]
        assert any(result["events"] > 0 for result in both), case


@pytest.mark.parametrize("law", [0, 1], ids=LAWS)
@given(source=sources())
def test_body_below_its_limits_never_moves(law: int, source: Source) -> None:
    check_body_below_its_limits_never_moves(source, law, 1)


@given(source=sources())
def test_body_just_above_its_limits_moves(source: Source) -> None:
    check_body_just_above_its_limits_moves(source, 1)


@given(seed=SEEDS, law=st.sampled_from([0, 1]))
def test_limits_of_rest_hold_for_a_large_sample(seed: int, law: int) -> None:
    source = Seeded(np.random.default_rng(seed))
    check_body_below_its_limits_never_moves(source, law, 10)
    check_body_just_above_its_limits_moves(source, 10)
