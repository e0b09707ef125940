"""Scenarios in space: dimensions and heading, several pieces, the command line, verdicts, reports."""

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from commands import cli

import stayput as sp
from real_records import MOTIONS, recorded
from stayput.measures import MEASURES
from stayput.scenario import Scenario
from stayput.simulation.case import Case
from stayput.verification.option_runner import OptionRunner, drawn_run
from stayput.verification.options import compared_options

BOOKCASE = {
    "furniture": {"preset": "bookcase"},
    "room": {"left_wall": {"gap": 0.02}},
    "shaking": {"suite": {"family": "near-fault", "count": 3}, "intensity": "6-upper"},
    "measures": [{"type": "l_bracket"}],
    "dimensions": 3,
    "uncertainty": {"samples": 6},
}
DRESSER = Path(__file__).parents[2] / "examples" / "dresser.toml"


def run(*arguments: object) -> str:
    found = cli(*arguments)
    assert found.exit_code == 0, found.output
    return found.output


def test_the_heading_turns_the_motion_to_the_piece() -> None:
    ahead = Scenario.parse(BOOKCASE)
    aside = Scenario.parse({**BOOKCASE, "furniture": {"preset": "bookcase", "heading": math.pi / 2}})
    first, second = ahead.motion(), aside.motion()
    assert first.y is not None
    np.testing.assert_allclose(second.x, first.y, atol=1e-12)
    assert second.intensity == pytest.approx(first.intensity, abs=1e-9)
    alone = Scenario.parse(
        {
            "furniture": {"preset": "chest", "heading": 0.5},
            "shaking": {"sine": {"amplitude": 1.0, "frequency": 1.0}},
        }
    ).motion()
    assert alone.y is not None
    np.testing.assert_allclose(alone.y, -math.tan(0.5) * alone.x, atol=1e-12)


@pytest.mark.parametrize(
    "stated",
    [
        {"preset": "bookcase", "height": 2.1},
        {"preset": "bookcase", "shelves": [20.0, 20.0, 10.0]},
        {"preset": "chest", "cg_offset": [0.02, -0.1], "inertia": 20.0},
        {
            "width": 0.4,
            "length": 0.9,
            "height": 1.2,
            "mass": 40.0,
            "base_insets": [0.02, 0.05],
            "base": "feet",
        },
        {"width": 0.4, "length": 0.9, "height": 1.2, "mass": 40.0, "base_heights": [0.0, -0.004]},
    ],
)
def test_a_piece_of_a_list_is_what_it_is_alone(stated: dict[str, Any]) -> None:
    """Its body, and what it does in the same room under the same motion, to the bit."""
    shared = {"room": {"floor": "vinyl"}, "shaking": {"builtin": "near-fault"}, "dimensions": 3}
    alone = Scenario.parse({"furniture": stated, **shared})
    listed = Scenario.parse({"furniture": [{"name": "it", **stated}], **shared})
    assert listed.piece.body() == alone.piece.body()
    first, second = alone.case().run(), listed.run()
    assert first.engine == "space"
    assert np.array_equal(first.place, second.place)


def test_a_body_with_a_length_under_two_components_is_simulated_in_space() -> None:
    motion, room = sp.near_fault().scaled(0.3), sp.Room()
    body = sp.Body(0.4, 1.8, 100.0)
    long = sp.Body(0.4, 1.8, 100.0, length=0.9)
    assert sp.simulate(body, room, motion).engine == "plane"
    assert sp.simulate(long, room, motion).engine == "space"
    assert sp.simulate(long, room, motion, dimensions=2).engine == "plane"
    assert sp.simulate(long, room, sp.sine(1.0, 1.0, 2.0)).engine == "plane"
    with pytest.raises(sp.InputError, match="length"):
        sp.simulate(body, room, motion, dimensions=3)
    with pytest.raises(sp.InputError, match="is given for what is no lone Body"):
        sp.simulate(sp.Body.box(0.4, 0.9, 1.8, 100.0), room, motion, [sp.MEASURES["belt"]()], dimensions=3)


WAVE = {"sine": {"amplitude": 4.0, "frequency": 1.0, "duration": 1.0}}
HELD: dict[str, Any] = {
    "furniture": {"preset": "bookcase"},
    "room": {"left_wall": {"gap": 0.02}},
    "shaking": WAVE,
    "measures": [{"type": "l_bracket"}],
    "uncertainty": {"samples": 1},
}
PAIR = {
    "furniture": [{"preset": "bookcase"}, {"preset": "chest", "at": [2.0, 0.0]}],
    "options": [{"name": "held", "measures": {"bookcase": [{"type": "l_bracket"}]}}],
    "measures": None,
}
NO_LENGTH = {"furniture": {"width": 0.3, "height": 1.8, "mass": 90.0}}


@pytest.mark.parametrize(
    ("changes", "engine", "english", "japanese"),
    [
        ({}, "space", "a real earthquake shakes in three directions", "実際の地震は3方向に揺れ"),
        (PAIR, "space", "a real earthquake shakes in three directions", "実際の地震は3方向に揺れ"),
        (
            {"dimensions": 2},
            "plane",
            "as asked: the shaking along its length is left out, and",
            "指定のとおり",
        ),
        (NO_LENGTH, "plane", "since its length is not stated", "家具の幅（length）が指定されていないため"),
    ],
)
def test_the_headline_says_what_a_verdict_on_a_held_piece_leaves_out(
    changes: dict[str, Any], engine: str, english: str, japanese: str
) -> None:
    tables = {key: value for key, value in {**HELD, **changes}.items() if value is not None}
    verdict = sp.verify(Scenario.parse(tables), levels=[])
    answer = json.loads(verdict.to_json())
    assert (answer["engine"], answer["components"]) == (engine, ["x"])
    assert english in answer["verdict"]["en"]
    assert japanese in answer["verdict"]["ja"]


def test_only_what_nothing_holds_or_shakes_across_is_simulated_in_the_plane() -> None:
    scenario = Scenario.parse(HELD)
    free, held = scenario.case(), scenario.case(scenario.options[0].measures)
    assert (free.in_space, held.in_space) == (False, True)
    assert (free.run().engine, held.run().engine) == ("plane", "space")
    verdict = sp.verify(free, measures=[], samples=1, levels=[])
    assert json.loads(verdict.to_json())["engine"] == "plane"
    assert verdict.sentence().endswith("cases.")


@recorded
def test_brackets_that_hold_under_one_component_of_a_record_fail_under_all_three() -> None:
    record, across, vertical = (str(MOTIONS / f"jma_kobe_1995_{axis}.AT2") for axis in ("ns", "ew", "ud"))
    place = {"building": {"storeys": 10, "structure": "RC"}, "storey": 8}
    three = {"record": record, "across": across, "vertical": vertical, **place}
    falls = {}
    for name, changes in (("space", {}), ("plane", {"dimensions": 2})):
        tables = {**HELD, "shaking": three, "uncertainty": {"samples": 12}, **changes}
        verdict = sp.verify(Scenario.parse(tables), levels=[])
        falls[name] = next(each for each in verdict.options if each.option.measures)
        assert json.loads(verdict.to_json())["components"] == (
            ["x", "y", "z"] if name == "space" else ["x", "z"]
        )
    plane, space = (falls[name].probabilities["overturned"].fell for name in ("plane", "space"))
    assert plane <= 1
    assert space >= 4


def test_sweeps_in_space_have_the_bits_of_single_runs() -> None:
    body = sp.Body(0.4, 1.8, 100.0, length=0.9)
    case = Case(body, sp.Room(left_wall=sp.Wall(0.02)), sp.near_fault(), dimensions=3)
    scales = [0.4, 0.8, 1.2]
    data = sp.sweep(case, {"motion.scale": scales}, threads=2)
    again = sp.sweep(case, {"motion.scale": scales}, threads=1, chunk=1)
    assert data.peak_tilt.values.tobytes() == again.peak_tilt.values.tobytes()
    for place, scale in enumerate(scales):
        one = sp.simulate(body, case.room, sp.near_fault().scaled(scale), dimensions=3)
        assert bool(data.overturned[place]) == bool(one[0].overturned)
        if not one[0].overturned:
            assert float(data.peak_tilt[place]) == pytest.approx(float(one[0].peak_tilt), rel=1e-12)


SIDES = {"near_side_wall": {"gap": 0.01, "restitution": 0.1}, "far_side_wall": {"gap": 0.02}}


def test_side_walls_of_scenarios_and_of_the_command_line() -> None:
    box = {"name": "box", "width": 0.4, "length": 0.4, "height": 0.4, "mass": 5.0}
    several = Scenario.parse({"furniture": [box], "room": SIDES})
    alone = Scenario.parse({**BOOKCASE, "room": SIDES})
    for scenario in (several, alone):
        room = scenario.room.room()
        assert (room.near_side_wall, room.far_side_wall) == (sp.Wall(0.01, 0.1), sp.Wall(0.02))
    keys = "room.near_side_wall.gap=0.001 room.far_side_wall.gap=0.002 dimensions=3 furniture.length=0.3"
    flags = (f"--set={key}" for key in keys.split())
    printed = json.loads(run("simulate", "--body", "0.2x1.2x40", *flags, "--json"))
    # the built-in motion has a component across, and the walls stop it
    assert {"near_side_wall", "far_side_wall"} <= {hit["on"] for hit in printed["hits"]}
    found = cli("simulate", "--set", "room.near_side_wall.gap=0.1", "--set", "dimensions=2")
    assert found.exit_code == 2
    assert "for a wall at the side, room.near_side_wall" in found.output


def test_side_walls_are_refused_in_the_plane() -> None:
    body, motion = sp.Body(0.4, 1.8, 100.0, length=0.9), sp.sine(2.0, 1.0, 2.0)
    case = Case(body, sp.Room(), motion)
    walled = sp.Room(far_side_wall=sp.Wall(0.1))
    attempts = (
        lambda: sp.simulate(body, walled, motion, dimensions=2),
        lambda: sp.sweep(case, {"room.near_side_wall.gap": [0.1, 0.2]}),
        lambda: sp.sweep(case, {"room": [sp.Room(), walled]}),
        lambda: sp.sweep(case, {"room.far_side_wall": [None, sp.Wall(0.1)]}),
    )
    for attempt in attempts:
        with pytest.raises(sp.InputError, match=r"must be 3 for a wall at the side, .*side_wall"):
            attempt()


def test_sweeps_over_side_walls() -> None:
    body, motion = sp.Body(0.4, 1.2, 100.0, length=0.3), sp.near_fault()
    case = Case(body, sp.Room(far_side_wall=sp.Wall(0.5)), motion, dimensions=3)
    walls = [sp.Wall(0.0, 0.0, 0.1), sp.Wall(0.02, 0.5, 0.6), None]
    data = sp.sweep(case, {"room.near_side_wall": walls, "room.far_side_wall.gap": [0.01, 0.3]}, threads=2)
    assert len(np.unique(data.peak_tilt.values)) == 6
    for place, wall in enumerate(walls):
        room = sp.Room(near_side_wall=wall, far_side_wall=sp.Wall(0.3))
        one = sp.simulate(body, room, motion, dimensions=3)
        assert int(data.wall_impacts[place, 1]) == int(one[0].wall_impacts)
        if not one[0].overturned:
            assert float(data.peak_tilt[place, 1]) == float(one[0].peak_tilt)
    with pytest.raises(sp.InputError, match="near side wall that is not there"):
        sp.sweep(case, {"room.near_side_wall.friction": [0.1]})


def test_what_is_refused() -> None:
    own = {"width": 0.4, "height": 1.8, "mass": 100.0}
    with pytest.raises(sp.InputError, match="length is missing"):
        Scenario.parse({"furniture": own, "dimensions": 3})


def test_what_does_not_sink_is_named() -> None:
    drum = {"name": "my drum", "diameter": 0.4, "height": 0.9, "mass": 20.0}
    floor = {"static_friction": 0.6, "kinetic_friction": 0.5, "settlement": 0.0005}
    still = {"sine": {"amplitude": 0.1, "frequency": 1.0, "duration": 0.1}}
    scenario = Scenario.parse({"furniture": drum, "room": {"floor": floor}, "shaking": still})
    with pytest.warns(sp.InputWarning, match="by 0.5 mm, is left out for “my drum”"):
        scenario.run()


def test_flags_beside_a_file_of_several_pieces() -> None:
    """Those of the shaking and the room hold, those of one piece are refused."""
    weak = json.loads(run("simulate", DRESSER, "--set", "shaking.scale=0.05", "--json"))
    assert {body["outcome"] for body in weak["pieces"]} == {"rested"}
    for flags in (["--body", "0.4x1x10"], ["--measure", "belt"]):
        said = cli("simulate", DRESSER, *flags)
        assert said.exit_code == 2
        assert f"{flags[0]} is given where furniture is not one preset or box" in said.output
    said = cli("simulate", DRESSER, "--set", "furniture.mass=0")  # of all pieces; of the first by the place
    assert "furniture[0].mass is 0" in said.output


def test_the_table_of_several_pieces() -> None:
    """A joint is called by the pieces that it joins; it says which peak it means, and what rolls."""
    said = " ".join(run("simulate", DRESSER).split())
    assert "Joint upper part – lower part" in said
    components = list(sp.near_fault().components.values())
    peak = np.sqrt(np.sum(np.square(components), axis=0)).max()
    assert f"peak of all components {peak:.2f} m/s²" in said
    assert said.count("Peak slide, rolling included") == 1  # of the vase
    assert said.count("Peak slide") == 4
    flags = "--set=shaking.scale=0.1", "--set=dimensions=2"
    planar = " ".join(run("simulate", *flags).split())
    assert f"peak along the depth {0.1 * sp.near_fault().pga:.2f} m/s²" in planar


def test_the_file_of_several_pieces() -> None:
    scenario = sp.read(DRESSER)
    pieces = scenario.scene().pieces
    assert scenario.names == ("lower part", "upper part", "vase", "chest")
    assert pieces[1].at == pytest.approx((-0.05, 0.0, 0.9))
    assert pieces[2].at[2] == pytest.approx(1.85)
    printed = json.loads(run("simulate", DRESSER, "--json"))
    assert [body["name"] for body in printed["pieces"]] == list(scenario.names)
    assert printed["devices"][0]["failed"]
    assert {hit["on"] for hit in printed["hits"]} >= {"floor", "lower part"}


def test_a_verdict_and_its_report(tmp_path: Path) -> None:
    scenario = Scenario.parse(BOOKCASE)
    verdict = sp.verify(scenario, levels=[], threads=2)
    again = sp.verify(scenario, levels=[], threads=1)
    assert verdict.options[0].tilt == again.options[0].tilt
    bracket = next(each for each in verdict.options if each.option.measures)
    assert [device.name for device in bracket.devices] == ["l_bracket left", "l_bracket right"]
    replayed = drawn_run(scenario, verdict.without.option, verdict.without.worst)
    assert bool(replayed.overturned) == (verdict.without.probabilities["overturned"].estimate > 0.0)
    verdict.report(tmp_path / "verdict.html", "en")
    page = (tmp_path / "verdict.html").read_text(encoding="utf-8")
    assert page.count("<iframe") == (4 if verdict.best.option.measures else 2)
    assert "data:image/svg+xml;base64," in page


def test_every_measure_that_can_be_put_in_place_is_verified_in_space() -> None:
    kinds = [{"type": kind} for kind in MEASURES if kind != "lower_shelves"]
    poles = {"type": "tension_pole", "name": "below a ceiling of its own", "ceiling_height": 2.3}
    scenario = Scenario.parse(
        {
            "furniture": {"preset": "bookcase"},
            "room": {"left_wall": {"gap": 0.05}, "floor": "wood flooring"},
            "shaking": {"builtin": "near-fault", "scale": 0.5},
            "measures": [*kinds, poles],
            "uncertainty": {"samples": 1},
        }
    )
    assert scenario.dimensions == 3
    options, impossible = compared_options(scenario)
    assert {one.option.name for one in impossible} == {"tension_pole"}  # no ceiling is known
    runner = OptionRunner(scenario, 0.1, 1)
    runs = runner.run(options, runner.members)
    assert len(runs) == len(kinds) + 1
    assert not any(each.missing.any() for each in runs)
    slides = {option.name: each.slide.item() for option, each in zip(options, runs, strict=True)}
    assert slides["base_isolator"] != slides["none"]
    assert slides["against_wall"] != slides["away_from_wall"]
