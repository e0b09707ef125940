"""Runs with measures: what became of the devices, and the same bits in every way of running."""

import math

import numpy as np
import pytest

import stayput as sp
from stayput.measures import (
    AgainstWall,
    AntiSlipSheet,
    BaseIsolator,
    Belt,
    GelMats,
    LBracket,
    TensionPole,
    WedgeStopper,
    element_rows,
    hold,
)
from stayput.measures.element import failed, utilisation
from stayput.model.flat_fields import case_columns
from stayput.report.animation import film_of
from stayput.report.summary import rows, summary
from stayput.simulation.many import run_columns
from stayput.simulation.outcome import QUANTITIES

ROOM = sp.Room(left_wall=sp.Wall(0.03), ceiling=sp.Ceiling(2.4))
BOOKCASE = sp.Body(0.3, 1.8, 200.0)
SHAKE = sp.near_fault().trimmed(4.0, 12.0)
RESULTS = [q.name for q in QUANTITIES if q.name not in ("outcome", "events", "overturned")]


def ramp(rate=0.5, duration=20.0, dt=0.01):
    """A floor that accelerates to the left ever more, so that the body is pushed to the right."""
    return sp.Motion(dt, x=-rate * np.arange(0.0, duration, dt), name="ramp")


def test_a_bracket_holds_a_bookcase_that_falls_without_it():
    shake = SHAKE.scaled(0.85)
    assert sp.simulate(BOOKCASE, ROOM, shake).overturned
    held = sp.simulate(BOOKCASE, ROOM, shake, [LBracket()])
    (bracket,) = held.devices
    assert (held.overturned, bracket.failed, bracket.cause) == (False, False, None)
    assert 0.0 < bracket.utilisation < 1.0
    strength = 2.0 * LBracket().drawn("stud", 1.8, 2.4).strength
    assert bracket.peak_pull == pytest.approx(bracket.utilisation * strength)
    assert bracket.weakest == ("the screws pull out of the stud", "下地からねじが抜ける")
    assert held.device_failures == 0
    assert math.isnan(held.device_failure_time)


def test_a_bracket_that_is_too_weak_is_drawn_out_and_the_bookcase_falls():
    run = sp.simulate(BOOKCASE, ROOM, SHAKE, [LBracket(strength=100.0)])
    (bracket,) = run.devices
    assert (run.overturned, bracket.failed, bracket.cause) == (True, True, "drawn out")
    assert run.device_failure_time == bracket.failure_time < run.overturn_time
    failure = next(event for event in run.events if event.kind is sp.EventKind.DEVICE_FAILURE)
    assert failure.time == bracket.failure_time


def test_a_belt_breaks_where_the_moments_about_the_front_edge_say():
    """F z = m (a z_G − g x_B): the rod at the top, level, without slack; a = 0.5 t."""
    belt = Belt(count=1, strength=300.0, angle=0.0, slack=0.0, stiffness=1e6, ultimate=0.0)
    room = sp.Room(sp.Floor(3.0, 3.0), left_wall=sp.Wall(0.0))
    run = sp.simulate(sp.Body(0.4, 1.8, 100.0), room, ramp(), [belt])
    a = (300.0 * 1.8 / 100.0 + 9.80665 * 0.2) / 0.9
    assert run.devices[0].cause == "pulled off"
    assert run.devices[0].failure_time == pytest.approx(a / 0.5, rel=5e-4)
    assert run.devices[0].peak_pull == pytest.approx(300.0, rel=1e-4)


def test_forces_are_those_of_the_histories():
    run = sp.simulate(BOOKCASE, ROOM, SHAKE, [Belt()])
    (belt,) = run.devices
    assert belt.pull.shape == belt.shear.shape == run.time.shape
    assert belt.pull.max() <= belt.peak_pull
    assert belt.pull.max() > 0.8 * belt.peak_pull
    assert belt.pull.min() == belt.shear.max() == 0.0


def test_without_elements_a_run_is_that_of_the_body_and_the_room_alone():
    sheet, wall = AntiSlipSheet(), AgainstWall()
    room = sp.Room(sp.Floor(0.8, 0.7), left_wall=sp.Wall(0.0), ceiling=sp.Ceiling(2.4))
    run, plain = sp.simulate(BOOKCASE, ROOM, SHAKE, [sheet, wall]), sp.simulate(BOOKCASE, room, SHAKE)
    assert run.devices == ()
    assert run.measures == (sheet, wall)
    for name in ("slide", "tilt", "place"):
        assert getattr(run, name).tobytes() == getattr(plain, name).tobytes()
    assert run.events == plain.events


def test_the_papers_law_knows_no_devices():
    with pytest.raises(
        sp.InputError, match=r"^Contact is 'paper'; it must be 'coulomb' with measures of force elements"
    ):
        sp.simulate(BOOKCASE, ROOM, SHAKE, [Belt()], contact="paper")
    case = sp.Case(BOOKCASE, ROOM, SHAKE, contact="paper", measures=(Belt(),))
    with pytest.raises(sp.InputError, match="must be 'coulomb' with measures of force elements"):
        sp.simulate_many(case, {"motion.scale": [0.5, 1.0]})
    sp.simulate(BOOKCASE, ROOM, SHAKE, [AntiSlipSheet()], contact="paper")


@pytest.mark.parametrize(
    "measures", [(LBracket(),), (GelMats(), TensionPole()), (WedgeStopper(), TensionPole())], ids=str
)
def test_many_runs_have_the_bits_of_single_ones(measures):
    columns = {
        "body.width": [0.3, 0.4, 0.3, 0.5],
        "body.mass": [200.0, 100.0, 50.0, 300.0],
        "motion.scale": [1.0, 0.5, 1.0, 1.0],
        "room.left_wall.gap": [0.02, 0.05, 0.1, 0.0],
    }
    found = sp.simulate_many(sp.Case(BOOKCASE, ROOM, SHAKE, measures=measures), columns)
    for n in range(4):
        width, mass, scale, gap = (values[n] for values in columns.values())
        room = sp.Room(left_wall=sp.Wall(gap), ceiling=sp.Ceiling(2.4))
        run = sp.simulate(sp.Body(width, 1.8, mass), room, SHAKE.scaled(scale), measures)
        for name in RESULTS:
            single = np.float64(getattr(run, name))
            assert np.array_equal(np.float64(found[name][n]), single, equal_nan=True), name


def test_a_sweep_keeps_devices_and_histories_of_held_bodies():
    case = sp.Case(BOOKCASE, ROOM, SHAKE, measures=(Belt(),))
    data = sp.sweep(case, {"motion.scale": [0.25, 0.5, 1.0]}, histories=("tilt",))
    assert list(data["device_utilisation"].values) == sorted(data["device_utilisation"].values)
    run = sp.simulate(BOOKCASE, ROOM, SHAKE, [Belt()])
    assert data["tilt"].values[2].tobytes() == run.tilt.tobytes()


def test_a_measure_that_fits_not_every_case_is_refused_before_any_is_run():
    case = sp.Case(BOOKCASE, ROOM, SHAKE, measures=(LBracket(),))
    with pytest.raises(sp.InputError, match=r"^Case 1 of 3: .*it must be between 0 and 0.15"):
        sp.simulate_many(case, {"room.left_wall.gap": [0.1, 0.5, 0.1]})


def test_columns_of_cases_with_a_row_of_elements_each():
    given = LBracket(strength=1500.0)
    held = [hold(BOOKCASE, ROOM, measures) for measures in ((), (given,), (given,))]
    cases = np.concatenate([case_columns(one.body, one.room, sp.State(), 9.80665) for one in held])
    elements = np.zeros((3, 1), element_rows(held[1]).dtype)
    elements[1], elements[2] = element_rows(held[1]), element_rows(held[2], 0.1)
    motions = [SHAKE.scaled(0.5), SHAKE]
    results, devices = run_columns(cases, elements, motions, np.array([1, 1, 1]), threads=2)
    measures = ([], [given], [LBracket(strength=150.0)])
    singles = [sp.simulate(BOOKCASE, ROOM, SHAKE, one) for one in measures]
    for n, run in enumerate(singles):
        assert results["peak_tilt"][n] == run.peak_tilt
        assert results["residual_slide"][n] == run.residual_slide
    assert failed(elements, devices).tolist() == [[False], [False], [True]]
    assert devices["failure_time"][2, 0] == singles[2].device_failure_time
    assert utilisation(elements, devices)[0] == 0.0
    free, none = run_columns(cases[:1], None, motions, np.array([1]))
    assert free[0] == results[0]
    assert none.shape == (1, 0)


def test_devices_are_in_the_dataset_the_summary_and_the_table():
    run = sp.simulate(BOOKCASE, ROOM, SHAKE, [GelMats(), TensionPole()])
    data = run.to_dataset()
    assert list(data["device"].values) == ["gel_mats back", "gel_mats front", "tension_pole"]
    assert data["device_pull"].dims == ("time", "device")
    assert data["device_peak_push"].attrs["units"] == "N"
    assert data["device_cause"].values[0] == run.devices[0].cause
    said = summary(run)
    assert said["measures"] == ["gel_mats", "tension_pole"]
    assert said["devices"][2]["peak_push_N"] == run.devices[2].peak_push
    assert {"Tension poles", "Adhesive gel mats back"} <= {what for what, _ in rows(run)}


def test_a_film_shows_a_device_whole_till_it_fails():
    run = sp.simulate(BOOKCASE, ROOM, SHAKE, [LBracket(strength=100.0)])
    assert {tie.lost for tie in film_of(run).scene.ties} == {run.device_failure_time}


@pytest.mark.parametrize("length", [None, 0.9], ids=["plane", "space"])
def test_what_a_piece_slides_within_the_stroke_of_its_isolator_does_not_count(length):
    chest, stroke = sp.Body(0.8, 0.6, 100.0, length=length), 0.3
    options, shake = {"isolator": [BaseIsolator(stroke=stroke)]}, SHAKE.scaled(0.7)
    assert sp.simulate(chest, sp.Room(), shake, options["isolator"]).peak_slide > 0.15
    verdict = sp.verify(chest, shaking=shake, measures=options, samples=2, levels=[], progress=False)
    isolated = next(option for option in verdict.options if option.option.name == "isolator")
    assert isolated.probabilities["slid"].estimate == 0.0
    assert isolated.slide.p90 < 0.05
    assert isolated.rank == 1


@pytest.mark.parametrize("dimensions", [2, 3])
@pytest.mark.parametrize("kind", sorted(sp.MEASURES))
def test_every_measure_is_simulated_in_the_plane_and_in_space(kind: str, dimensions: int) -> None:
    body = sp.Body(0.4, 1.8, 60.0, length=0.9)
    room = sp.Room(left_wall=sp.Wall(0.05), ceiling=sp.Ceiling(2.2))
    run = sp.simulate(body, room, sp.sine(1.0, 1.0, 1.0), [sp.MEASURES[kind]()], dimensions=dimensions)
    assert run.outcome is not sp.Outcome.FAILED
    if kind == "against_wall":
        assert run.room.left_wall == sp.Wall(0.0)
