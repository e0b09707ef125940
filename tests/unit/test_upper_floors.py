"""Motions of an upper floor are not told as the ground's: they are labelled, or refused."""

from __future__ import annotations

import csv
import json
import math
from dataclasses import replace
from functools import partial

import pytest
from inventories import CITY, table
from test_rooms import BEDROOM
from typer.testing import CliRunner

import stayput as sp
from long_cases import long
from stayput.app.running import shaking_reply
from stayput.cli import app
from stayput.fragility.intensity_measures import (
    FLOOR_JMA,
    JMA_INTENSITY,
    MMI,
    PFA,
    PFV,
    PGA,
    PGV,
    spectral_acceleration,
)
from stayput.motion.ground_shaking import mercalli_of
from stayput.report.fragility import plot_options
from stayput.report.plot import plot_run
from stayput.report.verdict.data import verdict_data
from stayput.report.verdict.exports import demand_of
from stayput.report.verdict.html import report_html
from stayput.report.verdict.tables import verdict_csv, verdict_markdown
from stayput.scenario.shaking import STRENGTHS
from stayput.verification.words import class_label

GROUND = sp.synthetic_suite("crustal", 3).to_intensity(5.0)
FLOORS = sp.Suite(tuple(sp.Building(8).floor_motion(motion, 6) for motion in GROUND), "floors")
BODY = sp.Body(width=0.35, height=1.8, mass=90.0, length=0.9)
STRENGTH = {
    "intensity": "6-upper",
    "pga": 4.0,
    "pgv": 0.5,
    "sa": {"period": 0.3, "value": 4.0},
    "mmi": 7.0,
    "earthquake": {"magnitude": 7.0, "distance": 20.0},
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("floors")
    for number, motion in enumerate(FLOORS):
        motion.write(folder / f"m{number}_6F.csv")
    return folder


@pytest.fixture(scope="module")
def verdict():
    room = sp.Room(left_wall=sp.Wall(0.02))
    brackets = [sp.measures.LBracket()]
    return sp.verify(
        BODY, room, shaking=FLOORS, measures=brackets, samples=6, levels=[5.0, 6.0], progress=False
    )


def refused(call, *parts):
    with pytest.raises(sp.InputError) as caught:
        call()
    for part in ("is of storey 6, not of the ground", *parts):
        assert part in caught.value.told("en")
    assert "6階の揺れで、地面の揺れではありません" in caught.value.told("ja")


def test_what_is_said_of_the_ground_alone_refuses_a_floor_in_one_sentence():
    floor = FLOORS[0]
    stones = [sp.Fallen(sp.Body(0.24, 0.62, 95.0), 3, 9)]
    for call, allowed in (
        (lambda: floor.to_intensity("6-upper"), "a factor (scale)"),
        (lambda: FLOORS.to_intensity(5.5), "a factor (scale)"),
        (lambda: sp.Building(5).floor_motion(floor, 2), "give it no building"),
        (lambda: list(sp.Building(5).floor_motions([GROUND[0], floor], [2])), "give it no building"),
        (lambda: sp.Building(5).floor_peaks([floor]), "give it no building"),
        (lambda: sp.Building(5).respond(floor), "give it no building"),
        (lambda: sp.intensity_from_fallen(stones, motions=FLOORS), "motions of the ground alone"),
        (lambda: sp.verify(BODY, shaking=sp.Suite((GROUND[0], floor))), "or of upper floors alone"),
        *(
            (
                lambda im=im: sp.verify(
                    BODY, shaking=FLOORS, samples=3, levels=[5.0], intensity_measures=[im]
                ),
                "PFA",
            )
            for im in (PGA, PGV, MMI, spectral_acceleration(0.3))
        ),
    ):
        refused(call, allowed)
    assert floor.scaled(2.0).floor == "storey 6"


@pytest.mark.parametrize("target", [sp.japanese_design(), sp.asce7(1.0, 0.6)])
def test_a_design_spectrum_of_the_ground_takes_no_floor(target):
    for call in (
        lambda: FLOORS.to_spectrum(target),
        lambda: FLOORS.matched(target),
        lambda: FLOORS.selected(target, 1),
        lambda: FLOORS.deviation(target),
    ):
        refused(call, "here motions of the ground alone may be given")


def test_another_spectrum_may_be_of_a_floor_and_the_label_stays():
    required = sp.ac156(1.0, 0.7).horizontal
    own = sp.TargetSpectrum([0.05, 5.0], [8.0, 1.0])
    for target in (required, own):
        assert FLOORS.to_spectrum(target).floor == FLOORS.selected(target, 2).floor == "storey 6"
    assert FLOORS.matched(required, (0.2, 1.0)).floor == "storey 6"


def test_a_target_on_the_command_line_refuses_a_floor(folder, tmp_path):
    line = ["motion", "suite", "--records", str(folder), "--target", "japan", "--out", str(tmp_path / "out")]
    done = CliRunner().invoke(app, line)
    assert not (tmp_path / "out").exists()
    assert isinstance(done.exception, (SystemExit, sp.InputError))
    assert "is of floor 6, not of the ground" in done.output + str(done.exception)


@pytest.mark.parametrize(
    ("motion", "labels"),
    [
        (FLOORS[0], ("Acceleration of\nstorey 6 [m/s²]", "床（6階）の\n加速度 [m/s²]")),
        (
            replace(GROUND[0], floor="roof"),
            ("Acceleration of\nthe roof [m/s²]", "床（屋上）の\n加速度 [m/s²]"),
        ),
        (GROUND[0], ("Floor\nacceleration [m/s²]", "床の\n加速度 [m/s²]")),
    ],
)
def test_the_picture_of_a_run_says_which_floor_moves(motion, labels):
    run = sp.simulate(BODY, sp.Room(), replace(motion, y=None))
    in_space = sp.simulate(BODY, sp.Room(), motion)
    for language, label in zip(("en", "ja"), labels, strict=True):
        assert plot_run(run, language=language).axes[0].get_ylabel() == label
        for one in (run, in_space):
            assert one.plot(what="acceleration", language=language).get_ylabel() == label


def test_the_legend_of_capacities_says_that_a_floor_moves(folder, tmp_path):
    file = tmp_path / "room.toml"
    given = (
        f'furniture = {{ preset = "bookcase" }}\n[shaking]\nsuite = "{folder}"\n[uncertainty]\nsamples = 2\n'
    )
    file.write_text(given, encoding="utf-8")
    for language, name in zip(("en", "ja"), FLOOR_JMA.names, strict=True):
        line = ["verify", str(file), "--lang", language, "--quiet"]
        done = CliRunner().invoke(app, line, env={"COLUMNS": "400"})
        told = done.stdout.replace("\n", " " if language == "en" else "")
        assert f"{'overturn (' if language == 'en' else '転倒する値（'}{name}" in told, done.output


@pytest.mark.parametrize("key", STRENGTHS)
def test_the_strength_of_the_ground_is_not_that_of_a_floor(folder, key):
    shaking = {"suite": str(folder), key: STRENGTH[key]}
    scenario = sp.Scenario.parse({"furniture": {"preset": "bookcase"}, "shaking": shaking})
    motion, motions = (partial(make, folder) for make in (scenario.shaking.motion, scenario.shaking.motions))
    for call in (lambda: sp.verify(scenario, progress=False), motion, motions):
        with (
            pytest.warns(sp.InputWarning),
            pytest.raises(sp.InputError, match="how strongly the ground shakes"),
        ):
            call()


def test_an_inventory_takes_no_floors(folder, tmp_path):
    text = CITY.replace('suite = { family = "crustal", count = 3, seed = 1 }', f'suite = "{folder}"')
    file = tmp_path / "city.toml"
    file.write_text(text.replace("intensity = 6.0\n", ""), encoding="utf-8")
    with (
        pytest.warns(sp.InputWarning),
        pytest.raises(sp.InputError, match="here motions of the ground alone"),
    ):
        sp.assess(table(tmp_path, ["a,chest"], "id,preset"), file, tmp_path / "out", progress=False)


@pytest.mark.parametrize(
    ("language", "told"),
    [
        *long(
            (
                "en",
                (
                    "by the motion on storey 6, not of the place",
                    "The motions are of storey 6, not of the ground",
                ),
            )
        ),
        (
            "ja",
            ("6階の揺れによる値で、その場所の震度ではない", "地震動は6階の揺れで、地面の揺れではありません"),
        ),
    ],
)
def test_every_form_of_a_verdict_says_which_floor_it_is_of(verdict, language, told):
    assert told[0] in verdict.sentence(language)
    for text in (verdict_markdown(verdict, language), report_html(verdict, language)):
        assert all(part in text for part in told)
        assert "AC156, z/h" not in text


def test_its_data_and_curves_carry_the_label(verdict):
    data = verdict_data(verdict)
    assert (data["motion_floor"], data["intensity_class"]) == ("storey 6", None)
    estimates = data["estimates"]
    assert (estimates["equipment_loads"], estimates["ac156_height_ratio"]) == ([], None)
    assert estimates["overturning_ratio"] > 0.0  # goes by the floor's own peaks
    curves = verdict.without.curves
    assert list(curves) == [JMA_INTENSITY, PFA, PFV]
    assert curves[JMA_INTENSITY].measure == FLOOR_JMA
    assert not demand_of(FLOOR_JMA)[0]
    assert "floor_jma_50_percent" in verdict_csv(verdict)
    assert "\njma_intensity" not in verdict_csv(verdict)
    for language, name in zip(("en", "ja"), FLOOR_JMA.names, strict=True):
        (axis,) = plot_options(verdict, JMA_INTENSITY, language=language).axes
        assert axis.get_xlabel().lower() == name.lower()
        texts = [text.get_text() for text in axis.texts]
        assert class_label(6.25, language) not in texts  # classes are of a place


def test_the_ground_is_told_as_before():
    verdict = sp.verify(BODY, shaking=GROUND, samples=3, levels=[5.0], progress=False)
    data = verdict_data(verdict)
    assert (data["motion_floor"], data["intensity_class"]) == (None, "5-upper")
    assert data["estimates"]["ac156_height_ratio"] == 0.0
    assert len(data["estimates"]["equipment_loads"]) == 3
    assert list(verdict.without.curves) == [JMA_INTENSITY, PGA, PGV, PFA, PFV]


def test_several_pieces_and_rooms_say_it_too(folder):
    shaking = {"suite": str(folder)}
    pieces = [{"name": name, "preset": "chest", "at": [x, 0.5]} for name, x in (("a", 0.6), ("b", 3.0))]
    given = {"furniture": pieces, "shaking": shaking, "uncertainty": {"samples": 3}}
    with pytest.warns(sp.InputWarning):
        verdicts = [
            sp.verify(sp.Scenario.parse(given), progress=False),
            sp.verify(sp.Scenario.parse({**BEDROOM, **given}), changes=False, progress=False),
        ]
    for verdict in verdicts:
        assert verdict_data(verdict)["motion_floor"] == "floor 6"
        assert verdict_data(verdict)["intensity_class"] is None
        assert "by the motion on floor 6, not of the place" in verdict.sentence("en")
        assert "6階の揺れによる値で、その場所の震度ではない" in verdict.sentence("ja")


def test_intensities_of_a_place_are_not_converted_from_a_floor(folder):
    assert math.isnan(mercalli_of(FLOORS[0]))
    file = str(folder / "m0_6F.csv")
    told = json.loads(CliRunner().invoke(app, ["motion", "info", file, "--json"]).stdout)
    assert told["floor"] == "floor 6"
    assert {told[key] for key in ("jma_class", "long_period_class", "modified_mercalli")} == {None}
    for language, part in (("en", "not the intensity of the place"), ("ja", "その場所の震度ではない")):
        shown = (
            CliRunner()
            .invoke(app, ["motion", "info", file, "--lang", language], env={"COLUMNS": "200"})
            .stdout
        )
        assert part in shown
        assert "Mercalli" not in shown


def test_a_suite_s_table_names_the_floors(folder, tmp_path):
    done = CliRunner().invoke(
        app, ["motion", "suite", "--records", str(folder), "--out", str(tmp_path / "suite")]
    )
    assert done.exit_code == 0, done.output
    rows = csv.DictReader((tmp_path / "suite" / "suite.csv").read_text(encoding="utf-8-sig").splitlines())
    assert [row["floor"] for row in rows] == ["floor 6"] * len(FLOORS)


def test_the_page_is_told_of_the_floor(folder):
    tables = {"furniture": {"preset": "bookcase"}, "shaking": {"suite": str(folder)}}
    scenario = sp.Scenario.parse(tables)
    with pytest.warns(sp.InputWarning):
        reply = shaking_reply(scenario)
    assert reply.intensity_class is None
    assert "not of the place" in reply.sentence.en


@pytest.mark.parametrize(
    ("floor", "english", "japanese"),
    [
        ("", "A", "A"),
        ("roof", "A, recorded on the roof", "A（屋上の記録）"),
        ("floor 12", "A, recorded on floor 12", "12階の記録"),
    ],
)
def test_the_table_of_a_run_says_where_its_motion_was_recorded(floor, english, japanese):
    from stayput.report.names import motion_place

    motion = replace(GROUND[0], name="A", floor=floor, synthetic=False)
    assert motion_place(motion) == english
    assert japanese in motion_place(motion, "ja")
