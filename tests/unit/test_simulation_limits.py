"""What a run may start from and what it may end as: tilts, frictions, numbers that are none."""

import math

import numpy as np
import pytest

import stayput as sp
from stayput.mechanics.columns import FAILED_OUTCOME
from stayput.mechanics.runner import run_cases, shaking
from stayput.model.flat_fields import case_columns

STILL = sp.Motion(0.01, np.zeros(200))
WEDGED = sp.Body(0.3, 1.2, 100.0, base_heights=(0.0, -0.05))
REST = WEDGED.resting_tilt


def test_a_start_beyond_a_right_angle_is_refused():
    assert pytest.approx(-math.atan(0.05 / 0.3)) == REST
    beyond = sp.State(tilt=-1.5)
    with pytest.raises(sp.InputError, match=r"tilted by -95\.4\d*° at the start, -9\.46\d*° of it at rest"):
        sp.simulate(WEDGED, sp.Room(), STILL, initial=beyond)
    with pytest.raises(sp.InputError, match="less than 90° to either side"):
        sp.simulate(WEDGED, sp.Room(), STILL, initial=sp.State(tilt=-math.pi / 2 - REST))
    case = sp.Case(WEDGED, sp.Room(), STILL)
    with pytest.raises(sp.InputError, match=r"Case 1 of 2: The body is tilted by"):
        sp.sweep(case, {"initial.tilt": [0.0, -1.5]}, progress=False)


@pytest.mark.parametrize("contact", ["coulomb", "paper"])
def test_a_start_just_below_a_right_angle_falls_at_once(contact):
    run = sp.simulate(WEDGED, sp.Room(), STILL, contact=contact, initial=sp.State(tilt=-1.56 - REST))
    assert run.outcome is sp.Outcome.OVERTURNED
    assert 0.0 < run.overturn_time < 0.1
    assert run.peak_tilt == pytest.approx(math.pi / 2 + REST, abs=1e-9)


@pytest.mark.parametrize("law", [0, 1])
@pytest.mark.parametrize("field", ["tilt", "tilt_rate", "slide", "slide_rate", "inertia", "static_friction"])
def test_what_is_not_a_number_never_stands(law, field):
    """Inputs are checked before; should a number be lost all the same, the run has failed."""
    columns = case_columns(sp.Body(0.4, 1.6, 100.0), sp.Room(), sp.State(tilt=0.05), 9.81)
    columns[field] = math.nan
    motion = shaking(np.sin(np.arange(300) * 0.1), None, 0.01, law)
    (outcome,) = run_cases(columns, motion, max_events=1000)["outcome"]
    assert outcome == FAILED_OUTCOME or field == "static_friction"


@pytest.mark.parametrize("mu", [10.0, 1e3, 1e6])
def test_a_body_of_any_friction_does_not_slip(mu):
    """A researcher who wants no slip gives a large coefficient: rocking is that of reference bodies."""
    motion = sp.sine(amplitude=3.0, frequency=2.0, duration=6.0)
    sticks = sp.simulate(sp.Body(0.4, 1.6, 100.0), sp.Room(sp.Floor(3.0, 3.0)), motion)
    run = sp.simulate(sp.Body(0.4, 1.6, 100.0), sp.Room(sp.Floor(mu, mu)), motion)
    assert run.peak_slide == pytest.approx(0.0, abs=1e-12)
    assert run.tilt == pytest.approx(sticks.tilt, abs=1e-12)
    thrown = sp.simulate(
        sp.Body(0.4, 1.6, 100.0), sp.Room(sp.Floor(mu, mu)), motion, initial=sp.State(slide_rate=0.5)
    )
    assert thrown.outcome is not sp.Outcome.FAILED
    with pytest.raises(sp.InputError, match="friction"):
        sp.Floor(2e6, 2e6)


def strip(mu, kinetic, **fields):
    """A floor on which a strip of rubber lies under the front edge."""
    return sp.Floor(mu, kinetic, right_edge_static_friction=0.8, right_edge_kinetic_friction=0.7, **fields)


def test_friction_of_a_strip_never_drives_a_base_under_the_paper_s_rules():
    """Flat on a strip a base is held by at least what slows its slide, so friction cannot push it along."""
    body, motion = sp.Body(0.53, 0.74, 100.0), sp.near_fault().component("x")
    run = sp.simulate(body, sp.Room(strip(0.56, 0.49, restitution=0.7)), motion, contact="paper")
    bare = sp.simulate(body, sp.Room(sp.Floor(0.56, 0.49, restitution=0.7)), motion, contact="paper")
    assert run.peak_slide <= bare.peak_slide + 0.01
    # at a load between the corners' coefficients it slides to the side of the larger one no sooner
    for load in (5.0, -5.0):
        held = sp.simulate(
            body, sp.Room(strip(0.56, 0.49)), sp.Motion(0.01, np.full(100, load)), contact="paper"
        )
        assert held.outcome is sp.Outcome.RESTED


def test_a_strip_beside_a_wall_ends_under_the_paper_s_rules():
    rng = np.random.default_rng(5)
    rows = []
    while len(rows) < 400:
        mu = rng.uniform(0.03, 0.8)
        floor = strip(mu, mu * rng.uniform(0.6, 1.0), restitution=rng.choice([1.0, 0.7]))
        wall = sp.Wall(rng.choice([0.0, 0.005, 0.02, 0.2]), rng.choice([0.0, 0.3, 0.6]), 0.3)
        body = sp.Body(rng.uniform(0.2, 0.8), rng.uniform(0.5, 2.0), 100.0)
        rows.append(case_columns(body, sp.Room(floor, left_wall=wall), sp.State(), 9.80665)[0])
    motion = sp.near_fault()
    results = run_cases(np.array(rows), shaking(motion.x, None, motion.dt, 1), max_events=5000)
    assert not np.count_nonzero(results["outcome"] == FAILED_OUTCOME)


def test_the_largest_slide_is_that_of_any_time_also_off_the_floor():
    """A body that turns about a corner at a wall has its base in the air, where its slide turns freely."""
    rng = np.random.default_rng(2)
    motion = sp.near_fault().component("x").trimmed(0.0, 12.0)
    inside = 0
    for _ in range(150):
        body = sp.Body(rng.uniform(0.38, 0.46), rng.uniform(0.35, 0.46), 100.0, cg_offset=(0.0, 0.089))
        walls = (sp.Wall(rng.uniform(0.03, 0.1), 0.0, 0.2) for _ in range(2))
        place = sp.Room(sp.Floor(0.85, 0.75), *walls)
        run = sp.simulate(body, place, motion.scaled(rng.uniform(1.5, 2.5)))
        largest = np.abs(run.slide).max()
        assert largest <= run.peak_slide * (1.0 + 1e-9) + 1e-15
        inside += run.peak_slide > largest
    assert inside
