"""Many cases at once: the same numbers as one by one, whatever the way they are asked for.

Scales are powers of two, so that a motion scaled before and one scaled in the mechanics have the same bits.
"""

import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from interrupts import hears_interrupts

import stayput as sp
from stayput.model.parameters import parameters
from stayput.simulation.grid import Grid
from stayput.simulation.many import run_grid
from stayput.simulation.outcome import OUTCOMES, QUANTITIES
from waiting import PATIENCE

WALLED = sp.Room(sp.Floor(0.4, 0.3), right_wall=sp.Wall(0.1))
PULSE = sp.pulse("ricker", 6.0, frequency=1.0, quiet=3.0, dt=0.01)
SHORT = sp.sine(5.0, 1.5, 3.0, dt=0.01)
CASE = sp.Case(sp.Body(0.4, 1.6, 100.0), WALLED, PULSE)
RESULTS = [q.name for q in QUANTITIES if q.name not in ("outcome", "events", "overturned")]


def same(point, run):
    """Whether a point of a dataset, or a row of results, is what the run says, to the bit."""
    assert OUTCOMES[int(point["outcome"])] == run.outcome.value
    assert bool(point["overturned"]) == run.overturned
    assert int(point["events"]) == len(run.events)
    for name in RESULTS:
        assert np.array_equal(np.float64(point[name]), np.float64(getattr(run, name)), equal_nan=True), name


def test_a_sweep_holds_what_single_runs_say():
    axes = {"body.width": [0.3, 0.5], "room.right_wall.gap": [0.0, 0.2], "motion.scale": [0.5, 1.0, -2.0]}
    data = sp.sweep(CASE, axes)
    assert dict(data.sizes) == {name: len(values) for name, values in axes.items()}
    for width in axes["body.width"]:
        for gap in axes["room.right_wall.gap"]:
            for scale in axes["motion.scale"]:
                point = data.sel({"body.width": width, "room.right_wall.gap": gap, "motion.scale": scale})
                room = sp.Room(WALLED.floor, right_wall=sp.Wall(gap))
                same(point, sp.simulate(sp.Body(width, 1.6, 100.0), room, PULSE.scaled(scale)))
    assert data["peak_slide"].attrs["units"] == data["body.width"].attrs["units"] == "m"
    assert data["outcome"].attrs["flag_meanings"].split() == [
        outcome.replace(" ", "_") for outcome in OUTCOMES
    ]


def test_paths_in_a_tuple_go_together():
    data = sp.sweep(CASE, {("body.width", "body.height"): ([0.3, 0.5], [1.2, 2.0]), "motion.scale": [1.0]})
    assert dict(data.sizes) == {"body.width": 2, "motion.scale": 1}
    assert list(data["body.height"].values) == [1.2, 2.0]
    same(
        data.isel({"body.width": 1, "motion.scale": 0}), sp.simulate(sp.Body(0.5, 2.0, 100.0), WALLED, PULSE)
    )


def word_of(about, number):
    """Return a number, or of a field of words the word at that place."""
    return about.choices[number] if about.choices else number


def test_every_number_of_a_case_can_change():
    columns = {
        "body.width": [0.4, 0.5],
        "body.height": [1.5, 1.7],
        "body.mass": [50.0, 150.0],
        "body.inertia": [20.0, 60.0],
        "body.cg_offset.x": [0.02, -0.03],
        "body.cg_offset.z": [-0.1, 0.2],
        "body.base_heights.left": [0.0, 0.002],
        "body.base_heights.right": [-0.003, 0.0],
        "body.base_insets.left": [0.01, 0.0],
        "body.base_insets.right": [0.0, 0.02],
        "room.floor.static_friction": [0.5, 0.6],
        "room.floor.kinetic_friction": [0.4, 0.2],
        "room.floor.edge_static_friction": [0.7, 0.8],
        "room.floor.edge_kinetic_friction": [0.6, 0.3],
        "room.floor.left_edge_static_friction": [0.7, 0.5],
        "room.floor.left_edge_kinetic_friction": [0.4, 0.1],
        "room.floor.right_edge_static_friction": [0.9, 0.6],
        "room.floor.right_edge_kinetic_friction": [0.5, 0.2],
        "room.floor.restitution": [0.9, 0.7],
        "room.floor.normal_restitution": [0.1, 0.2],
        "room.floor.landing_place": [1.0, 0.5],
        "room.floor.settlement": [0.0002, 0.0],
        "room.floor.rolling_resistance": [0.0, 0.002],
        "room.left_wall.gap": [0.05, 0.2],
        "room.left_wall.restitution": [0.2, 0.5],
        "room.left_wall.friction": [0.1, 0.4],
        "room.left_wall.construction": [0, 1],
        "room.right_wall.gap": [0.1, 0.3],
        "room.right_wall.restitution": [0.1, 0.6],
        "room.right_wall.friction": [0.2, 0.5],
        "room.right_wall.construction": [3, 2],
        "room.ceiling.height": [1.8, 2.4],
        "room.ceiling.restitution": [0.4, 0.1],
        "room.ceiling.friction": [0.3, 0.6],
        "room.ceiling.construction": [0, 3],
        "initial.tilt": [0.01, -0.01],
        "initial.tilt_rate": [0.1, -0.2],
        "initial.slide": [0.01, 0.02],
        "initial.slide_rate": [0.1, -0.1],
        "gravity": [9.81, 3.7],
        "motion.scale": [2.0, 0.5],
        "motion": [PULSE, SHORT],
        "contact": ["coulomb", "paper"],
    }
    results = sp.simulate_many(CASE, columns)
    for n in range(2):
        c = {name: values[n] for name, values in columns.items()}
        body = sp.Body(
            c["body.width"],
            c["body.height"],
            c["body.mass"],
            (c["body.cg_offset.x"], c["body.cg_offset.z"]),
            c["body.inertia"],
            (c["body.base_heights.left"], c["body.base_heights.right"]),
            (c["body.base_insets.left"], c["body.base_insets.right"]),
        )
        floor = sp.Floor(*(c[f"room.floor.{about.name}"] for about in parameters(sp.Floor)))
        left, right = (
            sp.Wall(*(word_of(about, c[f"room.{side}_wall.{about.name}"]) for about in parameters(sp.Wall)))
            for side in ("left", "right")
        )
        ceiling = sp.Ceiling(
            *(word_of(about, c[f"room.ceiling.{about.name}"]) for about in parameters(sp.Ceiling))
        )
        start = sp.State(*(c[f"initial.{name}"] for name in sp.State.__slots__))
        run = sp.simulate(
            body,
            sp.Room(floor, left, right, ceiling),
            c["motion"].scaled(c["motion.scale"]),
            contact=c["contact"],
            initial=start,
            gravity=c["gravity"],
        )
        same({name: values[n] for name, values in results.items()}, run)


def test_objects_can_be_values():
    bodies = [sp.Body(0.3, 1.8, 100.0), sp.Body.bookcase(0.4, 1.8, 20.0, [30.0, 5.0])]
    floors = [sp.Floor.of("carpet"), sp.Floor.of("vinyl")]
    walls = [None, sp.Wall(0.05, friction=0.6)]
    data = sp.sweep(CASE, {"body": bodies, "room.floor": floors, "room.right_wall": walls})
    for i, body in enumerate(bodies):
        for j, floor in enumerate(floors):
            for k, wall in enumerate(walls):
                run = sp.simulate(body, sp.Room(floor, right_wall=wall), PULSE)
                same(data.isel({"body": i, "room.floor": j, "room.right_wall": k}), run)


def test_motions_of_any_length_and_step_go_together():
    motions = [PULSE, SHORT, PULSE.scaled(0.3), sp.sine(4.0, 2.0, 1.0, dt=0.002)]
    data = sp.sweep(CASE, {"motion": motions, "contact": ["paper", "coulomb"]}, chunk=3)
    for i, motion in enumerate(motions):
        for j, law in enumerate(["paper", "coulomb"]):
            run = sp.simulate(CASE.body, WALLED, motion, contact=law)
            same(data.isel(motion=i, contact=j), run)


def test_histories_are_those_of_single_runs_and_nan_after_the_end():
    data = sp.sweep(CASE, {"motion.scale": [0.5, 4.0]}, histories=("tilt", "slide"))
    for n, scale in enumerate((0.5, 4.0)):
        run = sp.simulate(CASE.body, WALLED, PULSE.scaled(scale))
        for name in ("tilt", "slide"):
            found = data[name].values[n]
            assert np.array_equal(found[: len(run.time)], getattr(run, name))
            assert np.isnan(found[len(run.time) :]).all()
    assert np.array_equal(data["time"], PULSE.time)
    assert data["tilt"].attrs["units"] == "rad"


@pytest.mark.parametrize(
    ("axes", "words"),
    [
        ({"body.widht": [0.3]}, "did you mean 'body.width'"),
        ({"body.width": []}, "a list of 1 or more"),
        ({"body.width": ["wide"]}, "must be numbers"),
        ({"body.width": [[0.3, 0.4]]}, r"must be a list of 1 or more numbers"),
        ({"body.width": [0.3, np.nan]}, "must be a finite number"),
        ({"body.width": [0.3, -0.4]}, "Case 1 of 2: Body width is -0.4 m"),
        ({"room.floor.kinetic_friction": [0.2, 0.41]}, "Case 1 of 2: Floor kinetic friction is 0.41"),
        ({"room.right_wall.gap": [0.1], "initial.tilt": [0.0, 0.5]}, "Case 1 of 2: The body stands"),
        ({"initial.slide": [0.0, 0.2]}, "inside the wall in front"),
        ({"room.ceiling.height": [2.0, 1.59]}, "inside the ceiling"),
        ({"body.cg_offset.z": [0.0, 0.9]}, "must be inside the section"),
        ({"gravity": [9.8, 0.0]}, "Gravity is 0"),
        ({"room.left_wall.friction": [0.1]}, "left wall that is not there"),
        ({("body.width", "body.height"): ([0.3, 0.4], [1.0])}, "must have as many"),
        ({("body.width", "body.height"): ([0.3],)}, "one list for each path"),
        ({("body.width",): ([0.3],), "body.width": [0.4]}, "given twice"),
        ({"body": [sp.Body(1, 1, 100.0)], "body.width": [0.4]}, "given twice"),
        ({("body.width", "body.width"): ([0.3], [0.4])}, "given twice"),
        ({"motion": []}, "is empty"),
        ({"motion": [3]}, "of type Motion"),
        ({"room.right_wall": ["brick"]}, "of type Wall"),
        ({"contact": ["glue"]}, "'glue'"),
    ],
)
def test_what_is_refused(axes, words):
    with pytest.raises(sp.InputError, match=words) as caught:
        sp.sweep(CASE, axes)
    assert "\n" not in str(caught.value)


def test_a_refusal_tells_its_case_and_axis_in_japanese():
    with pytest.raises(sp.InputError) as caught:
        sp.sweep(CASE, {"body.width": [0.3, -0.4]})
    assert caught.value.told("ja").startswith("2件中のケース1：")
    with pytest.raises(sp.InputError) as caught:
        sp.sweep(CASE, {("body.width", "body.height"): ([0.3, 0.4], [1.0])})
    assert caught.value.told("ja").startswith("軸('body.width', 'body.height')の値の数が")


def test_histories_that_are_refused():
    with pytest.raises(sp.InputError, match="History is 'tlit'"):
        sp.sweep(CASE, {"motion.scale": [1.0]}, histories=("tlit",))
    with pytest.raises(sp.InputError, match="one time step"):
        sp.sweep(CASE, {"motion": [PULSE, sp.sine(1, 1, 1, dt=0.002)]}, histories=("tilt",))
    with pytest.raises(sp.InputError, match="numbers; it must have at most"):
        sp.sweep(CASE, {"motion.scale": np.linspace(0, 1, 10**6)}, histories=("tilt",))


def test_the_work_in_hand_does_not_grow_with_the_number_of_cases(monkeypatch):
    at_once = []
    block = Grid.block

    def counted(grid, start, stop):
        at_once.append(stop - start)
        return block(grid, start, stop)

    axes = {"body.width": np.linspace(0.2, 0.6, 100), "motion.scale": np.linspace(0.01, 0.02, 100)}
    from stayput.simulation.grid import make_grid

    grid = make_grid(CASE, axes)
    monkeypatch.setattr(Grid, "block", counted)
    run_grid(grid, chunk=500, threads=2)
    assert at_once == [500] * 20


@pytest.mark.processes
@pytest.mark.skipif(os.name == "nt", reason="POSIX signals")
def test_ctrl_c_stops_soon():
    """Long before the sweep would have ended, which the program says from what a hundredth of it takes."""
    program = """
import time, numpy as np, stayput as sp
case = sp.Case(sp.Body(0.4, 1.6, 100.0), sp.Room(), sp.near_fault())
for count in (2, 10_000):
    began = time.perf_counter()
    sp.sweep(case, {"motion.scale": np.linspace(0.5, 1.5, count)}, threads=2)
print(100 * (time.perf_counter() - began), flush=True)
sp.sweep(case, {"motion.scale": np.linspace(0.5, 1.5, 1_000_000)}, threads=2)
"""
    running = subprocess.Popen(
        [sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        preexec_fn=hears_interrupts,
    )  # fmt: skip
    try:
        whole = float(running.stdout.readline())
        time.sleep(0.02 * whole)
        sent = time.perf_counter()
        running.send_signal(signal.SIGINT)
        _, errors = running.communicate(timeout=PATIENCE)
        assert time.perf_counter() - sent < 0.5 * whole
        assert "KeyboardInterrupt" in errors
    finally:
        running.kill()


@pytest.mark.parametrize("kept", [(), ("tilt",)])
def test_a_number_of_threads_that_is_none_is_refused(kept):
    with pytest.raises(sp.InputError, match="Threads is 0; it must be between 1 and"):
        sp.sweep(CASE, {"motion.scale": [1.0]}, histories=kept, threads=0)
