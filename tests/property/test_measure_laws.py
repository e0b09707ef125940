"""What holds for every measure, whatever its numbers."""

from __future__ import annotations

import dataclasses

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

import stayput as sp
from stayput.measures import MEASURES, Belt, GelMats, LBracket, Measure, TensionPole, WedgeStopper

ROOM = sp.Room(sp.Floor(0.5, 0.4), left_wall=sp.Wall(0.03), ceiling=sp.Ceiling(2.4))
SHAKE = sp.near_fault().trimmed(5.0, 10.0)
DT = 0.01
RAMP = sp.Motion(DT, x=-0.5 * np.arange(0.0, 20.0, DT), name="ramp")
BRACKET, BELT = LBracket(strength=1500.0, stiffness=2e5), Belt(strength=1000.0, stiffness=5e4)
MATS, POLE = GelMats(area=0.0025), TensionPole(strength=500.0, stiffness=4e4)
KINDS = [(BRACKET,), (MATS, POLE), (WedgeStopper(), POLE), (BELT,)]


@given(weak=st.floats(20.0, 500.0), more=st.floats(1.0, 3.0), slack=st.floats(0.0, 0.005))
def test_a_stronger_brittle_bracket_never_fails_earlier_in_a_slow_pull(
    weak: float, more: float, slack: float
) -> None:
    # not so of one that yields: a stronger one holds the top until the base slips, and is shaken then
    body = sp.Body(0.4, 1.8, 100.0)
    times: list[float] = []
    for strength in (weak, more * weak):
        brittle = LBracket(strength=strength, slack=slack, ultimate=0.0)
        (bracket,) = sp.simulate(body, ROOM, RAMP, [brittle]).devices
        times.append(bracket.failure_time if bracket.failed else np.inf)
    assert times[0] <= times[1] + 1e-6


def heavier(measure: Measure, factor: float) -> Measure:
    """Return a measure with its forces, and its stiffness, this times as large."""
    forces = {"strength", "stiffness", "preload", "sideways_stiffness", "tension", "shear", "modulus"}
    names = {field.name: getattr(measure, field.name) for field in dataclasses.fields(measure)}
    numbers = {name for name in forces & names.keys() if not isinstance(names[name], str)}
    return type(measure)(**{name: factor * v if name in numbers else v for name, v in names.items()})


@given(measures=st.sampled_from(KINDS), scale=st.sampled_from([0.5, 0.75, 1.0]), power=st.integers(-1, 1))
def test_forces_scale_with_the_mass(measures: tuple[Measure, ...], scale: float, power: int) -> None:
    factor = 4.0**power  # a power of four leaves the bits, also under the dampers' square root
    light = sp.simulate(sp.Body(0.35, 1.8, 100.0), ROOM, SHAKE.scaled(scale), measures)
    body = sp.Body(0.35, 1.8, factor * 100.0)
    heavy = sp.simulate(body, ROOM, SHAKE.scaled(scale), [heavier(m, factor) for m in measures])
    assert heavy.tilt.tobytes() == light.tilt.tobytes()
    for one, other in zip(light.devices, heavy.devices, strict=True):
        assert other.peak_push == factor * one.peak_push
        assert other.peak_pull == factor * one.peak_pull
        assert np.array_equal(other.failure_time, one.failure_time, equal_nan=True)


ROWS = st.lists(
    st.tuples(st.floats(0.25, 0.6), st.floats(0.1, 0.4), st.floats(0.3, 1.2)), min_size=4, max_size=12
)


@given(kind=st.sampled_from(sorted(MEASURES)), rows=ROWS, threads=st.integers(1, 4), chunk=st.integers(1, 20))
def test_threads_and_chunks_change_no_bit_with_measures(
    kind: str, rows: list[tuple[float, float, float]], threads: int, chunk: int
) -> None:
    width, friction, scale = (list(column) for column in zip(*rows, strict=True))
    columns = {"body.width": width, "room.floor.kinetic_friction": friction, "motion.scale": scale}
    case = sp.Case(sp.Body(0.4, 1.8, 100.0), ROOM, SHAKE, measures=(MEASURES[kind](),))
    one = sp.simulate_many(case, columns, threads=1, chunk=100)
    other = sp.simulate_many(case, columns, threads=threads, chunk=chunk)
    assert {k: v.tobytes() for k, v in one.items()} == {k: v.tobytes() for k, v in other.items()}
