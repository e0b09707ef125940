"""Tip-over by statics, beside the dynamic engine with gravity that tilts slowly and loads that move slowly.

A load and open drawers are parts of the body, a pull at the height of the centre of gravity is a horizontal
acceleration, and carpet is gravity of another direction: the simulated body falls where the margin is below
1, and stands where it is above.
"""

import math

import numpy as np
import pytest

import stayput as sp
from stayput.estimates import ALL_DRAWERS, LOAD, ONE_DRAWER, PULL

G = 9.80665
ROOM = sp.Room(sp.Floor(3.0, 3.0))
CHEST = sp.Body(0.45, 1.2, 40.0)


def case(body, name, **given):
    return next(one for one in sp.tip_over(body, sp.Everyday(**given)) if one.name == name)


def falls(body, forward):
    """Tell whether a body falls to the front under a horizontal load, over the weight, that comes slowly."""
    ramp = np.minimum(np.linspace(0.0, 1.6, 3201), 1.0)
    run = sp.simulate(body, ROOM, sp.Motion(0.01, -forward * G * ramp))
    assert not run.overturned or run.tilt[-1] > 0.0
    return run.overturned


@pytest.mark.parametrize("factor", [0.97, 1.03])
def test_a_pull(factor):
    limit = CHEST.mass * G * 0.225 / 0.6
    pulled = case(CHEST, PULL, pull=factor * limit, pull_height=0.6, carpet=0.0)
    assert pulled.margin == pytest.approx(1.0 / factor)
    assert falls(CHEST, factor * limit / (CHEST.mass * G)) is pulled.tips


@pytest.mark.parametrize("factor", [0.97, 1.03])
@pytest.mark.parametrize("carpet", [0.005, 0.02])
def test_open_drawers_with_a_load(factor, carpet):
    """With the load at the top of the front of a drawer, all being open; the tilt turns gravity."""
    stated = {"drawers": 4, "drawer_share": 0.4, "drawer_extension": 0.2, "carpet": carpet}
    unloaded, loaded = (case(CHEST, ALL_DRAWERS, **stated, load=load) for load in (0.0, 1.0))
    spare, less = (one.restoring - one.overturning for one in (unloaded, loaded))
    load = factor * spare / (spare - less)
    assert load > 0.0
    tipped = case(CHEST, ALL_DRAWERS, **stated, load=load)
    assert tipped.tips is (factor > 1.0)
    parts = [
        sp.Part(0.6 * 40.0, 0.0, 0.6, 0.45, 1.2),
        sp.Part(0.4 * 40.0, 0.2, 0.6, 0.45, 1.2),
        sp.Part(load, 0.225 + 0.2, 1.2),
    ]
    assert falls(sp.Body.from_parts(0.45, 1.2, parts), math.tan(math.atan2(carpet, 0.45))) is tipped.tips


def test_a_centre_of_gravity_off_the_middle_and_a_rising_base():
    body = sp.Body(0.5, 1.0, 30.0, (0.1, 0.2), base_heights=(0.02, 0.0))
    cos, sin = math.cos(body.resting_tilt), math.sin(body.resting_tilt)
    u, v = 0.25 - 0.1, -0.7  # the front foot from G in the body's axes
    x, z = u * cos + v * sin, v * cos - u * sin
    pulled = case(body, PULL, pull=10.0, carpet=0.0)
    assert pulled.restoring == pytest.approx(30.0 * G * x)
    assert pulled.overturning == pytest.approx(10.0)
    on_carpet = case(body, PULL, pull=0.0, carpet=0.1)
    tilt = math.atan2(0.1, 0.5)
    assert on_carpet.restoring - on_carpet.overturning == pytest.approx(
        30.0 * G * (x * math.cos(tilt) + z * math.sin(tilt))
    )


def test_cases_and_their_order():
    assert {one.name for one in sp.tip_over(CHEST)} == {PULL, LOAD}
    cases = sp.tip_over(CHEST, sp.Everyday(drawers=3))
    assert {one.name for one in cases} == {PULL, ONE_DRAWER, ALL_DRAWERS}
    margins = [one.margin for one in cases]
    assert margins == sorted(margins)
    assert case(CHEST, ALL_DRAWERS, drawers=3).margin < case(CHEST, ONE_DRAWER, drawers=3).margin
    one = case(CHEST, ONE_DRAWER, drawers=1)
    assert one.margin == pytest.approx(case(CHEST, ALL_DRAWERS, drawers=1).margin)


def test_feet_inside_the_outline_tip_earlier():
    """By hand: feet 0.1 m inside the edges, carpet that lifts the back by 0.05 m, a load at the edge."""
    body, given = sp.Body(0.4, 1.8, 100.0, base_insets=(0.1, 0.1)), sp.Everyday(carpet=0.05)
    tilt, weight = math.atan2(0.05, 0.2), 100.0 * G
    restoring = weight * (0.1 * math.cos(tilt) - 0.9 * math.sin(tilt))
    found = {one.name: one for one in sp.tip_over(body, given)}
    assert found[PULL].restoring == pytest.approx(restoring)
    load = 27.2 * G * (0.1 * math.cos(tilt) + 1.8 * math.sin(tilt))
    assert found[LOAD].overturning == pytest.approx(load)
    assert found[PULL].margin == 0.0  # the carpet alone tips it


def test_a_carpeted_floor_lifts_the_back_as_the_rule_says():
    for floor, lifted in (("carpet", 0.011), ("wood flooring", 0.0)):
        scenario = sp.Scenario.parse({"furniture": {"preset": "chest"}, "room": {"floor": floor}})
        assert scenario.everyday.everyday("chest", floor).carpet == lifted


def test_nothing_tips_what_nothing_pulls():
    still = sp.Everyday(load=0.0, pull=0.0, carpet=0.0)
    assert all(one.margin == math.inf for one in sp.tip_over(CHEST, still))


def test_the_scenario_s_table_and_the_verdict_s_line():
    data = {
        "furniture": {"preset": "chest"},
        "everyday": {"load": 40.0, "drawer_extension": 0.3},
        "shaking": {"intensity": 5.0, "suite": {"count": 1}},
        "uncertainty": {"samples": 1},
    }
    given = sp.Scenario.parse(data).everyday.everyday("chest")
    assert (given.drawers, given.load, given.drawer_extension) == (4, 40.0, 0.3)
    assert sp.Scenario.parse({**data, "everyday": {"drawers": 0}}).everyday.everyday("chest").drawers == 0
    light = {**data, "everyday": {"load": 0.0, "pull": 1.0}}
    tips, stays = (sp.verify(sp.Scenario.parse(one), levels=[]) for one in (data, light))
    note = tips.notes()[-1]
    assert note.startswith("Without an earthquake, 40 kg on one of its 4 drawers with all of them open tips ")
    assert "not a certificate" in note
    assert "地震がなくても" in tips.notes("ja")[-1]
    furniture, everyday = stays.scenario.piece, stays.scenario.everyday
    margin = min(one.margin for one in sp.tip_over(furniture.body(), everyday.everyday("chest")))
    note = stays.notes()[-1]
    assert "the piece withstands 0 kg on one of its 4 drawers" in note
    assert f"; the margin is {margin:.2f}, the moment of its own weight over" in note
