"""A verification refuses a piece that stands in the ceiling or in a wall, as a simulation does."""

import pytest

import stayput as sp

SCENARIO = {"furniture": {"preset": "cupboard"}, "shaking": {"intensity": 5.5}, "uncertainty": {"samples": 4}}


@pytest.mark.parametrize("height", [0.5, 1.79])
def test_a_piece_inside_the_ceiling_is_refused(height: float) -> None:
    scenario = sp.Scenario.parse({**SCENARIO, "room": {"ceiling": {"height": height}}})
    with pytest.raises(sp.InputError, match="inside the ceiling"):
        sp.verify(scenario, levels=[])


def test_a_piece_that_is_tilted_into_its_wall_is_refused() -> None:
    tilted = {"room": {"back_wall": {"gap": 0.0}}, "initial": {"tilt": -0.05}}
    with pytest.raises(sp.InputError, match="inside the"):
        sp.verify(sp.Scenario.parse({**SCENARIO, **tilted}), levels=[])


def test_the_most_likely_level_is_told_where_the_interval_is_open() -> None:
    stone = sp.Fallen(sp.Body(0.24, 0.62, 95.0), fell=18, total=20, room=sp.Room(sp.Floor(0.6, 0.5)))
    found = sp.intensity_from_fallen([stone], motions=sp.synthetic_suite("crustal", 12), samples=4)
    assert found.high == float("inf")
    assert found.low < found.most_likely <= 7.5


def test_a_sheet_on_carpet_is_warned_of() -> None:
    body = sp.Body(0.4, 1.8, 100.0)
    sheet = sp.MEASURES["anti_slip_sheet"]()
    assert not sheet.cautions(body, sp.Room(sp.Floor.of("vinyl")))
    (said,) = sheet.cautions(body, sp.Room(sp.Floor.of("carpet")))
    assert "soft" in said[0]
