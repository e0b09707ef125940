"""Invariants of the solver, for bodies, rooms and motions that Hypothesis draws and for large samples."""

from __future__ import annotations

import math
from collections import Counter
from typing import TYPE_CHECKING

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from strategies import (
    COULOMB,
    LAWS,
    SEEDS,
    Seeded,
    Standing,
    batches,
    clearances,
    mirrored,
    motions,
    random_motion,
    random_standing,
    scaled,
    stacked,
    standings,
    up,
)

from stayput import Floor, Motion, Room, State, simulate
from stayput.mechanics.runner import run_cases, shaking
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.state import standing_corners
from stayput.simulation.outcome import Outcome

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.simulation.run import Run

MANY = 50
"""Cases an example, where they run by the column."""

FEW_EVENTS = 20_000
"""Events after which these tests give a case up: far above what a motion of some seconds needs."""

INTEGRATED = 1e-8
"""Part of the energy by which the integration of a step may be out."""

CLOSE = 1e-12
"""Tolerance of the tilt's series where two runs take other steps [rad]."""

SETTLED = 4e-3
"""Rates below which a bounce is over, with some slack: the impulse that ends it is not followed [m/s]."""

FEW_STRANGE, MOST_SAME = 0.04, 0.85
"""Part of the cases that may come out differently though they are not sensitive, and that must not."""

FAILED, OVERTURNED = list(Outcome).index(Outcome.FAILED), list(Outcome).index(Outcome.OVERTURNED)


def run(cases: NDArray[np.void], motion: Motion, law: int, **kwargs: float) -> NDArray[np.void]:
    return run_cases(cases, shaking(motion.x, up(motion), motion.dt, law), max_events=FEW_EVENTS, **kwargs)


def many(seed: int, *, walls: bool = True) -> tuple[list[Standing], Motion]:
    source = Seeded(np.random.default_rng(seed))
    motion = random_motion(source)
    return [random_standing(source, walls=walls) for _ in range(MANY)], motion


def traced(case: Standing, motion: Motion, law: int) -> Run:
    """Run a case with its history; one that would be given up is left to the test that every run ends."""
    result = run(case.columns(), motion, law)
    assume(result["outcome"][0] != FAILED)
    return simulate(case.body, case.room, motion, contact=LAWS[law], initial=case.start)


def corners(found: Run) -> NDArray[np.float64]:
    """Places of the corners at the samples, shape [n, 4, 2] [m]."""
    sin, cos = np.sin(found.tilt), np.cos(found.tilt)
    return np.stack(
        [
            np.stack(
                [found.place[0, :, 0] + u * cos + v * sin, found.place[0, :, 2] + v * cos - u * sin], axis=1
            )
            for u, v in found.body.corners_at_rest
        ],
        axis=1,
    )


def foot(found: Run) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Where the lower base corner is, from the centre of gravity, in the room's axes [m]."""
    right = (found.tilt > 0.0) | ((found.tilt == 0.0) & (found.rotation_rate[0, :, 1] > 0.0))
    u, v = np.array(found.body.corners_at_rest)[right.astype(int)].T
    sin, cos = np.sin(found.tilt), np.cos(found.tilt)
    return u * cos + v * sin, v * cos - u * sin


def velocities(found: Run) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Rates of the centre of gravity at the samples, nan upwards where a body in flight hides them [m/s]."""
    px, pz = foot(found)
    vx, vz = found.slide_rate - found.rotation_rate[0, :, 1] * pz, found.rotation_rate[0, :, 1] * px
    flies = found.mode == "flight"
    away = found.place[0, :, 2] + pz > 1e-9  # also a body that leans on a wall alone
    vz[flies | away] = np.nan
    n, dt = len(found.time), found.motion.dt
    eventful = np.zeros(n, bool)
    for event in found.events:
        eventful[max(0, min(n - 1, math.ceil(event.time / dt - 1e-9))) :][:1] = True
        eventful[max(0, min(n - 1, math.floor(event.time / dt + 1e-9))) :][:1] = True
    up_there = up(found.motion)[:n]
    near = clearances(found.body, found.room, corners(found)).min(axis=1) < 1e-9
    free = flies & ~near
    k = np.flatnonzero(free[:-1] & free[1:] & ~eventful[1:] & ~eventful[:-1])
    # z falls with g + z̈, which is linear between the samples
    fall = STANDARD_GRAVITY / 2 + up_there[k] / 3 + up_there[k + 1] / 6
    vz[k] = (found.place[0, k + 1, 2] - found.place[0, k, 2]) / dt + fall * dt
    return vx, vz


def energies(found: Run, a: NDArray[np.float64], G: NDArray[np.float64]) -> NDArray[np.float64]:
    """Energy per mass under steady loads, in which it can only be lost [m²/s²]."""
    vx, vz = velocities(found)
    inertia = found.body.inertia_about_cg / found.body.mass
    return (
        0.5 * (vx**2 + vz**2 + inertia * found.rotation_rate[0, :, 1] ** 2)
        + G * found.place[0, :, 2]
        + a * found.place[0, :, 0]
    )


SAMPLES = st.one_of(st.tuples(batches(), motions(longest=800)), SEEDS.map(many))
"""A few cases that Hypothesis can shrink, and large samples, each with a motion."""


@pytest.mark.parametrize("law", [0, 1], ids=LAWS)
@settings(max_examples=2 * settings.default.max_examples)
@given(sample=SAMPLES)
def test_every_run_ends_with_finite_results(law: int, sample: tuple[list[Standing], Motion]) -> None:
    cases, motion = sample
    results = run(stacked(cases), motion, law)
    for name in results.dtype.names:
        assert np.isfinite(results[name]).all(), name
    given_up = np.flatnonzero(results["outcome"] == FAILED)
    assert len(given_up) == 0, [(i, cases[i]) for i in given_up]
    assert (results["end"] <= (len(motion.x) - 1) * motion.dt * (1 + 1e-12)).all()
    assert (results["peak_tilt"] >= np.abs(results["residual_tilt"])).all()
    assert (results["peak_slide"] >= np.abs(results["residual_slide"])).all()


@given(case=standings(), motion=motions(longest=600), law=st.sampled_from([0, 1]))
def test_histories_are_finite_and_agree_with_the_results(case: Standing, motion: Motion, law: int) -> None:
    found = traced(case, motion, law)
    for name in ("place", "attitude", "velocity", "rotation_rate", "tilt", "slide"):
        assert np.isfinite(getattr(found, name)).all(), name
    assert np.abs(found.tilt).max() <= found.peak_tilt * (1 + 1e-12) + 1e-12
    assert np.abs(found.slide).max() <= found.peak_slide * (1 + 1e-12) + 1e-12
    times = [event.time for event in found.events]
    assert times == sorted(times)
    batch = run(case.columns(), motion, law)[0]
    assert batch["peak_tilt"] == found.peak_tilt
    assert batch["residual_slide"] == found.residual_slide
    assert batch["events"] == len(found.events)


def check_energy_never_grows(case: Standing, motion: Motion, found: Run) -> None:
    """The loads stay level for a while, then jump: at level loads each impact and slip only loses energy."""
    n = len(found.time)
    a, G = motion.x[:n], STANDARD_GRAVITY + up(motion)[:n]
    level = (a[1:] == a[:-1]) & (G[1:] == G[:-1])
    here = energies(found, a, G)[:-1]
    after = energies(found, np.append(a[0], a[:-1]), np.append(G[0], G[:-1]))[1:]  # under the loads before
    speed = np.nanmax(np.abs(np.stack(velocities(found))), initial=1.0)
    size = np.abs(G).max() * case.body.height + np.abs(a).max() * np.ptp(found.place[0, :, 0]) + speed**2
    grown = (after - here)[level]
    worst = np.nanmax(grown, initial=0.0)
    assert worst <= INTEGRATED * size, (worst / size, case, motion)


def check_no_corner_is_behind_a_plane(case: Standing, motion: Motion, found: Run) -> None:
    least = clearances(case.body, case.room, corners(found)).min(axis=0)
    scale = max(1.0, np.abs(found.place[0, :, 0]).max())
    assert (least >= -1e-9 * scale).all(), (least, case, motion)


def on_a_plain_floor(case: Standing) -> Standing:
    """Return the case without walls, and with a floor without restitution."""
    floor = case.room.floor
    floor = Floor(floor.static_friction, floor.kinetic_friction, *floor.edge_friction)
    return Standing(case.body, Room(floor), case.start)


def check_floor_pushes_within_its_friction_cone(case: Standing, motion: Motion, found: Run) -> None:
    """Over any time, impacts included, the floor's impulse points up and its drag is at most μ of it."""
    floor = case.room.floor
    n, dt = len(found.time), motion.dt
    vx, vz = velocities(found)
    pushed = np.diff(vz) + dt * (STANDARD_GRAVITY + (up(motion)[: n - 1] + up(motion)[1:n]) / 2)
    dragged = np.diff(vx) + dt * (motion.x[: n - 1] + motion.x[1:n]) / 2
    mu = max(floor.static_friction, *floor.edge_friction)
    slack = SETTLED * max(1.0, np.nanmax(np.abs(vz), initial=0.0), np.abs(vx).max())
    known = np.isfinite(pushed)
    assert (pushed[known] >= -slack).all(), (pushed[known].min(), case, motion)
    beyond = (np.abs(dragged) - mu * pushed)[known]
    assert beyond.max(initial=0.0) <= slack, (beyond.max(), case, motion)


def kinetic_frictions(case: Standing) -> tuple[float, float]:
    """Return the friction of a base that slides to the right, and to the left.

    Where a body would tip over its leading corner but that corner's friction cannot keep it tipped, the
    base slides on with the friction at which the trailing corner bears nothing.
    """
    (x_a, z_a), (x_b, _) = standing_corners(case.body, State())[:2]
    x, z = place_at_rest(case)
    edge = case.room.floor.edge_friction[1]
    flat = case.room.floor.kinetic_friction
    return tuple(min(flat, max(edge, reach / (z - z_a))) for reach in (x_b - x, x - x_a))  # type: ignore[return-value]


def place_at_rest(case: Standing) -> tuple[float, float]:
    """Return the place of the centre of gravity of a body at rest at slide 0 [m]."""
    (u, v), tilt = case.body.corners[0], case.body.resting_tilt
    x_a, z_a = standing_corners(case.body, State())[0]
    return (x_a - u * math.cos(tilt) - v * math.sin(tilt), z_a - v * math.cos(tilt) + u * math.sin(tilt))


def check_friction_opposes_a_flat_slide(case: Standing, motion: Motion, found: Run) -> None:
    n, dt = len(found.time), motion.dt
    happened = np.zeros(n, bool)
    for event in found.events:
        first, last = math.floor(event.time / dt - 1e-6), math.ceil(event.time / dt + 1e-6)
        happened[max(0, first) : last + 1] = True
    steady = (found.mode == "slide") & ~happened & (found.slide_rate != 0.0)
    k = np.flatnonzero(steady[:-1] & steady[1:])
    G = STANDARD_GRAVITY + (up(motion)[k] + up(motion)[k + 1]) / 2
    side = np.sign(found.slide_rate[k])
    drag = -np.where(side > 0.0, *kinetic_frictions(case)) * G * side
    gained = (drag - (motion.x[k] + motion.x[k + 1]) / 2) * dt
    assert np.allclose(np.diff(found.slide_rate)[k], gained, rtol=1e-9, atol=1e-11), (case, motion)


def check_tilt_and_slide_are_continuous(case: Standing, motion: Motion, found: Run) -> None:
    """From each known state the next one is reached by its rate, and by what the rate can change."""
    states = list(
        zip(found.time, found.tilt, found.rotation_rate[0, :, 1], found.slide, found.slide_rate, strict=True)
    )
    samples = len(states)
    states += [(e.time, e.tilt, e.tilt_rate, e.slide, e.slide_rate) for e in found.events]
    order = sorted(range(len(states)), key=lambda i: (states[i][0], i >= samples))
    table = np.array([states[i] for i in order])
    step = np.diff(table[:, 0])
    rates, slips = np.abs(table[:, 2]).max(), np.abs(table[:, 4]).max()
    reach = math.hypot(case.body.width, case.body.height)
    load = STANDARD_GRAVITY + np.abs(motion.x).max() + np.abs(up(motion)).max()
    turn = 2.0 * load * reach * case.body.mass / case.body.inertia_about_cg
    for column, largest, push in ((1, rates, turn), (3, slips + rates * reach, load + turn * reach)):
        jump = np.abs(np.diff(table[:, column]))
        assert (jump <= 3.0 * largest * step + push * step**2 + 1e-8).all(), (jump.max(), case, motion)


CHECKS = {
    "energy": check_energy_never_grows,
    "corners": check_no_corner_is_behind_a_plane,
    "friction cone": check_floor_pushes_within_its_friction_cone,
    "friction": check_friction_opposes_a_flat_slide,
    "continuity": check_tilt_and_slide_are_continuous,
}


@pytest.mark.parametrize("check", CHECKS)
@given(data=st.data())
def test_laws_hold(check: str, data: st.DataObject) -> None:
    case = data.draw(standings(walls=check != "friction cone"))
    motion = data.draw(motions(kind=3 if check == "energy" else None, longest=800))
    case = on_a_plain_floor(case) if check == "friction cone" else case
    CHECKS[check](case, motion, traced(case, motion, COULOMB))


# 29, 114: bodies that chatter at a wall; 11853: without friction the body stands only while the floor does
# not fall faster than it
@pytest.mark.parametrize("seed", [*range(20), 29, 114, 11853])
@pytest.mark.parametrize("check", CHECKS)
def test_laws_hold_for_a_large_sample(check: str, seed: int) -> None:
    source = Seeded(np.random.default_rng(seed))
    for _ in range(10):
        motion = random_motion(source, kind=3 if check == "energy" else None, longest=800)
        case = random_standing(source, walls=check != "friction cone")
        case = on_a_plain_floor(case) if check == "friction cone" else case
        if run(case.columns(), motion, COULOMB)["outcome"][0] != FAILED:
            CHECKS[check](case, motion, simulate(case.body, case.room, motion, initial=case.start))


@pytest.mark.parametrize("law", [0, 1], ids=LAWS)
@given(seed=SEEDS)
def test_mirrored_case_runs_as_its_mirror_image(law: int, seed: int) -> None:
    cases, motion = many(seed)
    back = Motion(motion.dt, -motion.x, z=motion.z)
    one, other = run(stacked(cases), motion, law), run(stacked([mirrored(c) for c in cases]), back, law)
    judge(cases, motion, law, one, other, alike(one, other, 1e-9, mirrored=True))


def alike(
    one: NDArray[np.void],
    other: NDArray[np.void],
    tolerance: float,
    *,
    mirrored: bool = False,
    k: float = 1.0,
) -> NDArray[np.bool_]:
    """Whether the outcomes are the same and peaks and ends agree, those of ``other`` with slides × k."""
    same = one["outcome"] == other["outcome"]
    side = -1.0 if mirrored else 1.0
    factors = {"peak_tilt": 1.0, "peak_slide": k, "residual_tilt": side, "residual_slide": side * k}
    for name, factor in factors.items():
        expected = factor * one[name]
        same &= np.abs(expected - other[name]) <= tolerance * (1.0 + np.abs(expected))
    return same


def judge(
    cases: list[Standing],
    motion: Motion,
    law: int,
    one: NDArray[np.void],
    other: NDArray[np.void],
    same: NDArray[np.bool_],
) -> None:
    """Nearly all cases that end must be the same, and none overturn in one run only if it is not sensitive.

    This is about the share of a large sample, which is therefore made from a seed.

    Rounding, and the height at which a bounce is over, may grow to something that is seen where
    impacts pile up, even in a case that a small change of the motion leaves as it is.
    """
    ended = (one["outcome"] != FAILED) & (other["outcome"] != FAILED)
    strange = np.flatnonzero(ended & ~same & (sensitivity(cases, motion, law) <= 1e-7))
    shown = [(int(i), one[i], other[i], cases[i]) for i in strange]
    assert len(strange) <= FEW_STRANGE * len(cases), shown
    assert ((one["outcome"] == OVERTURNED) == (other["outcome"] == OVERTURNED))[strange].all(), shown
    assert same[ended].mean() >= MOST_SAME


def sensitivity(cases: list[Standing], motion: Motion, law: int) -> NDArray[np.float64]:
    """How much the results change when motion and inertia do by a part in 10⁹; inf where the outcome does."""
    columns = stacked(cases)
    one = run(columns, motion, law)
    change = np.zeros(len(cases))
    inertia = columns["inertia"].copy()
    for factor in (1.0 - 1e-9, 1.0 + 1e-9):
        columns["scale"], columns["inertia"] = factor, factor * inertia
        other = run(columns, motion, law)
        for name in ("peak_tilt", "peak_slide", "residual_tilt", "residual_slide"):
            change = np.maximum(change, np.abs(one[name] - other[name]) / (1.0 + np.abs(one[name])))
        change[one["outcome"] != other["outcome"]] = np.inf
    return change


@pytest.mark.parametrize("law", [0, 1], ids=LAWS)
@given(seed=SEEDS, k=st.sampled_from([0.25, 4.0]))
def test_similar_cases_run_alike(law: int, seed: int, k: float) -> None:
    """Lengths × k and times × √k at the same accelerations: the tilt stays, the slide grows k times."""
    cases, motion = many(seed)
    slower = Motion(motion.dt * math.sqrt(k), motion.x, z=motion.z)
    cases = [c for c in cases if c.body.width * k >= 1e-3]
    one = run(stacked(cases), motion, law)
    other = run(stacked([scaled(c, k) for c in cases]), slower, law)
    judge(cases, motion, law, one, other, alike(one, other, 1e-5, k=k))


@settings(max_examples=2 * settings.default.max_examples)
@given(sample=SAMPLES, law=st.sampled_from([0, 1]), data=st.data())
def test_same_bits_in_any_company(
    sample: tuple[list[Standing], Motion], law: int, data: st.DataObject
) -> None:
    cases, motion = sample
    order = np.array(data.draw(st.permutations(range(len(cases)))))
    columns = stacked(cases)
    results = run(columns, motion, law)
    assert results.tobytes() == run(columns, motion, law).tobytes()
    assert results[order].tobytes() == run(columns[order], motion, law).tobytes()
    for i in order[:10]:
        assert results[i].tobytes() == run(columns[i : i + 1], motion, law)[0].tobytes()


@settings(max_examples=2 * settings.default.max_examples)
@given(sample=SAMPLES)
def test_history_changes_no_bit(sample: tuple[list[Standing], Motion]) -> None:
    cases, motion = sample
    results = run(stacked(cases), motion, COULOMB)
    for i in np.flatnonzero(results["outcome"] != FAILED)[:5]:
        found = simulate(cases[i].body, cases[i].room, motion, initial=cases[i].start)
        assert (found.peak_tilt, found.peak_slide) == (results["peak_tilt"][i], results["peak_slide"][i])
        assert (found.residual_tilt, found.residual_slide) == (
            results["residual_tilt"][i],
            results["residual_slide"][i],
        )


def halved(motion: Motion) -> Motion:
    """Return the same piecewise linear record with twice the samples."""

    def between(values: NDArray[np.float64]) -> NDArray[np.float64]:
        finer = np.empty(2 * len(values) - 1)
        finer[::2], finer[1::2] = values, 0.5 * (values[1:] + values[:-1])
        return finer

    return Motion(motion.dt / 2, between(motion.x), z=None if motion.z is None else between(motion.z))


@pytest.mark.parametrize("law", [0, 1], ids=LAWS)
@given(seed=SEEDS)
@example(seed=434467)  # a slip that comes to Painlevé's limit as it goes
def test_finer_samples_of_the_same_motion_change_nothing(law: int, seed: int) -> None:
    cases, motion = many(seed)
    one, other = (run(stacked(cases), record, law, tolerance=CLOSE) for record in (motion, halved(motion)))
    judge(cases, motion, law, one, other, alike(one, other, 1e-6))


def test_random_cases_reach_every_mode_and_outcome() -> None:
    """What the properties are checked on: all modes, kinds of events and outcomes occur."""
    outcomes: Counter[str] = Counter()
    modes: Counter[str] = Counter()
    kinds: Counter[str] = Counter()
    source = Seeded(np.random.default_rng(20))
    for _ in range(150):
        motion, case = random_motion(source, longest=600), random_standing(source)
        if run(case.columns(), motion, COULOMB)["outcome"][0] == FAILED:
            continue
        found = simulate(case.body, case.room, motion, initial=case.start)
        outcomes[found.outcome] += 1
        modes.update(set(found.mode.tolist()))
        kinds.update({event.kind.value for event in found.events})
    assert set(outcomes) >= {"rested", "slid", "rocked", "leaning", "overturned"}
    assert set(modes) >= {"rest", "slide", "rock", "slide-rock", "flight", "lean"}
    assert len(kinds) >= 9
