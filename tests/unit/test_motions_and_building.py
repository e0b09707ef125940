"""Motions of one's own for the ground, and a building between it and the furniture."""

from __future__ import annotations

import numpy as np
import pytest

import stayput as sp

BODY, ROOM = sp.Body(0.3, 1.8, 90.0), sp.Room(left_wall=sp.Wall(0.01))
GROUND = [sp.near_fault(), sp.near_fault().scaled(0.5), sp.sine(3.0, 1.5, 4.0)]
TOWER = sp.Building(6, "RC")
FEW = {"samples": 3, "levels": [], "measures": [], "progress": False}
OWN = [
    TOWER,
    sp.Building(4, "steel", nonlinear=False, damping=0.03, period=0.4, vertical_amplification=2.0),
    sp.Building(5, "base-isolated", isolation=sp.Isolation(period=3.0)),
    sp.ShearModel([2e5, 2e5], [2e8, 1.5e8], 0.03),
    TOWER.model,
]


def test_a_suite_of_the_ground_becomes_one_of_a_floor():
    ground = sp.Suite(tuple(GROUND), "records")
    for building in OWN:
        floor = building.floor_motion(ground, 2)
        assert (type(floor), floor.name) == (sp.Suite, "records")
        assert list(floor) == [building.floor_motion(motion, 2) for motion in GROUND]


@pytest.mark.parametrize("building", OWN, ids=lambda building: building.name)
def test_verify_shakes_the_building_by_own_motions(building, tmp_path):
    for shaking in (GROUND, sp.Suite(tuple(GROUND))):
        verdict = sp.verify(BODY, ROOM, shaking=shaking, building=building, storey=2, **FEW)
        found = verdict.scenario.shaking.motions(tmp_path)
        assert list(found) == list(building.floor_motion(sp.Suite(tuple(GROUND)), 2))
    on_floor = sp.verify(BODY, ROOM, shaking=found, **FEW)
    assert verdict.options[0].slide == on_floor.options[0].slide
    again = sp.Verdict.load(verdict.save(tmp_path / "verdict.json"))
    assert again.scenario.shaking.building.building() == building
    for language in ("en", "ja"):
        assert verdict.to_markdown(language) == again.to_markdown(language)
    says_all = not isinstance(building, sp.ShearModel) and building.isolation == sp.Isolation()
    assert ("building" not in verdict.scenario.to_toml().splitlines()[-1]) == says_all
    if says_all:
        parsed = sp.Scenario.parse(
            {
                "furniture": {"preset": "chest"},
                "shaking": {"building": building, "storey": np.int64(2).item()},
            }
        )
        assert (
            sp.Scenario.parse({**parsed.model_dump(exclude_unset=True)}).shaking.building.building()
            == building
        )


def test_a_building_beside_an_intensity_is_that_of_a_table():
    stated = {"intensity": 5.5, "suite": {"count": 2}}
    beside = sp.verify(BODY, ROOM, shaking=stated, building=TOWER, storey=5, **FEW)
    table = {**stated, "building": {"storeys": 6, "structure": "RC"}, "storey": 5}
    within = sp.verify(BODY, ROOM, shaking={**stated, "building": TOWER, "storey": 5}, **FEW)
    assert beside.scenario == within.scenario
    assert beside.options[0].slide == sp.verify(BODY, ROOM, shaking=table, **FEW).options[0].slide


@pytest.mark.parametrize(
    ("given", "english", "japanese"),
    [
        ({"building": TOWER}, "storey", "storeyも必要です"),
        ({"storey": 2}, "building", "buildingも必要です"),
        ({"building": TOWER, "storey": 8}, "must be a whole number from 1 to 7", "1～7（屋上）"),
        ({"building": "RC", "storey": 1}, "must be of type Building | ShearModel", "型の値を指定"),
        ({"building": TOWER, "storey": 2.5}, "must be of type int", "型の値を指定"),
    ],
)
def test_what_does_not_go_together_is_refused(given, english, japanese):
    with pytest.raises(sp.InputError) as refused:
        sp.verify(BODY, ROOM, shaking=GROUND, **given, **FEW)
    assert english in str(refused.value)
    assert japanese in refused.value.told("ja")


def test_what_says_it_already_takes_no_building_beside_it():
    with pytest.raises(sp.InputError, match="building is given beside"):
        sp.verify(BODY, ROOM, shaking={"building": TOWER, "storey": 2}, building=TOWER, storey=2, **FEW)
    for what in (sp.Case(BODY, ROOM, GROUND[0]), sp.Scenario.parse({"furniture": {"preset": "chest"}})):
        with pytest.raises(sp.InputError, match="building"):
            sp.verify(what, building=TOWER, storey=2, levels=[])
