"""What a flag gives is refused by the flag's name, and what a file says by its key's; in both languages."""

import re

import pytest
from typer.main import get_command
from typer.testing import CliRunner

from stayput.cli import app
from stayput.cli.as_typed import SET_BY, as_typed
from stayput.errors import InputError

KEY = re.compile(r"\b(?:furniture|room|shaking)(?:\.|\])|(?<!-)\b(?:contact|dimensions)\b")
FILE = """
[furniture]
width = 0.4
height = 1.6
mass = 60.0
[room]
floor = "carpet"
[shaking]
builtin = "near-fault"
[[measures]]
type = "belt"
"""
SHAKING = [
    (("--motion", "sine:0,0"), "--motion: the frequency is 0;", "--motionの周波数が0に"),
    (("--motion", "sine:1,1,0"), "--motion: the duration is 0;", "--motionの継続時間が0に"),
    (("--dt", "0"), "--dt is 0;", "--dtが0に"),
    (("--dt", "0.01"), "--dt is given without a record", "--dtは揺れの方向の記録"),
    (("--remove-mean",), "--remove-mean is given without a record", "--remove-meanは揺れの方向の記録"),
    (("--unit", "gal"), "--unit is given without a record", "--unitは揺れの方向の記録"),
    (("--component", "x"), "--component is given without a record", "--componentは揺れの方向の記録"),
    (("--columns", "t=1,x=2"), "--columns is given without a record", "--columnsは揺れの方向の記録"),
    (("--skip-lines", "3"), "--skip-lines is given without a record", "--skip-linesは揺れの方向の記録"),
    (("--decimal-comma",), "--decimal-comma is given without a record", "--decimal-commaは揺れの方向の記録"),
    (("--location", "00"), "--location is given without a record", "--locationは揺れの方向の記録"),
    (("--skip-lines", "-1", "--motion", "a.csv"), "--skip-lines is -1;", "--skip-linesが-1に"),
    (("--columns", "x", "--motion", "a.csv"), "--columns has 'x';", "--columnsに「x」が"),
    (("--columns", "t=1", "--motion", "a.csv"), "--columns has 't=1';", "--columnsに「t=1」が"),
    (("--columns", "t=1,x=1", "--motion", "a.csv"), "--columns has 't=1,x=1';", "--columnsに「t=1,x=1」が"),
    (("--columns", "x=1,w=2", "--motion", "a.csv"), "--columns is 'w';", "--columnsが'w'に"),
    (("--y", "a.csv"), "--y is given without a record", "--yは揺れの方向の記録"),
    (("--z", "a.csv"), "--z is given without a record", "--zは揺れの方向の記録"),
]
STRENGTH = [
    (("--intensity", "99"), "--intensity is 99;", "--intensityが99に"),
    (("--intensity", "6-uper"), "--intensity is '6-uper' (did", "--intensityが'6-uper'に"),
    (("--pga", "0"), "--pga is 0;", "--pgaが0に"),
    (("--pgv", "-2.5"), "--pgv is -2.5;", "--pgvが-2.5に"),
    (("--mmi", "99"), "--mmi is 99;", "--mmiが99に"),
    (("--sa", "0,8"), "--sa: the period is 0;", "--saの周期が0に"),
    (("--sa", "0.3,0"), "--sa: the spectral acceleration is 0;", "--saの加速度応答スペクトルの値が0に"),
    (("--earthquake", "99,9"), "--earthquake: the magnitude is 99;", "--earthquakeのマグニチュードが99に"),
    (("--earthquake", "7,0"), "--earthquake: the distance is 0;", "--earthquakeの距離が0に"),
    (("--earthquake", "7,9,-1"), "--earthquake: the depth is -1;", "--earthquakeの深さが-1に"),
    (
        ("--earthquake", "7,9,9,1"),
        "--earthquake: the ground's shear-wave velocity is 1;",
        "--earthquakeの地盤のS波速度が1に",
    ),
    (("--earthquake", "7,9,here"), "--earthquake: the kind is 'here';", "--earthquakeの種類が'here'に"),
]
FLOOR_SHAKING = [
    *SHAKING,
    *STRENGTH,
    (("--scale", "1e9"), "--scale is 1000000000;", "--scaleが1000000000に"),
    (("--building", "0"), "--building: the number of storeys is 0;", "--buildingの階数が0に"),
    (("--building", "5,mud"), "--building: the structure is 'mud';", "--buildingの構造が'mud'に"),
    (("--building", "5"), "--building is given without --storey;", "--buildingだけがあります。--storeyも"),
    (("--storey", "5"), "--storey is given without --building;", "--storeyだけがあります。--buildingも"),
    (("--storey", "0", "--building", "5"), "--storey is 0;", "--storeyが0に"),
    (("--storey", "9", "--building", "5"), "--storey is 9;", "--storeyが9に"),
]
STANDING = [
    (("--body", "0x1x1"), "--body: the width is 0;", "--bodyの奥行きが0に"),
    (("--body", "1x0x1"), "--body: the height is 0;", "--bodyの高さが0に"),
    (("--body", "1x1x0"), "--body: the mass is 0;", "--bodyの質量が0に"),
    (("--floor", "carpt"), "--floor is 'carpt' (did you mean 'carpet'?);", "--floorが'carpt'に"),
    (("--friction", "-1"), "--friction: the static friction is -1;", "--frictionの静止摩擦係数が-1に"),
    (("--friction", "1,-1"), "--friction: the kinetic friction is -1;", "--frictionの動摩擦係数が-1に"),
    (("--friction", "0.3,0.4"), "--friction: Floor kinetic friction is 0.4;", "--friction：床の動摩擦係数は"),
    (("--wall", "-1"), "--wall is -1;", "--wallが-1に"),
    (("--right-wall", "-1"), "--right-wall is -1;", "--right-wallが-1に"),
    (("--near-side-wall", "-1"), "--near-side-wall is -1;", "--near-side-wallが-1に"),
    (("--far-side-wall", "-1"), "--far-side-wall is -1;", "--far-side-wallが-1に"),
    (("--far-side-wall", "1"), "--far-side-wall is a wall at the side", "--far-side-wallは家具の側面"),
    (("--dimensions", "4"), "--dimensions is 4;", "--dimensionsが4に"),
    (
        ("--dimensions", "3", "--body", "1x2x3"),
        "--length is missing; where --dimensions is 3 the",
        "--lengthがありません。--dimensionsが3の",
    ),
    (("--length", "0"), "--length is 0;", "--lengthが0に"),
    (("--heading", "99"), "--heading is 99;", "--headingが99に"),
]
OF_A_BUILDING = [
    (("--storeys", "0"), "--storeys: The number of storeys is 0;", "--storeys：建物の階数が0に"),
    (("--structure", "mud"), "--structure is 'mud';", "--structureが'mud'に"),
    (("--period", "99"), "--period is 99 s;", "--periodが99 sに"),
    (("--damping", "9"), "--damping is 9;", "--dampingが9に"),
    (("--storey", "99"), "--storey: The storey is 99;", "--storey：階が99に"),
]


def refused(*words):
    """Return the sentences in English and in Japanese by which a command is refused."""
    for language in ("en", "ja"):
        done = CliRunner().invoke(app, [*words, "--lang", language])
        assert done.exit_code == 2, done.output
        assert done.stdout == ""
        yield done.stderr


@pytest.mark.parametrize(
    ("command", "words", "english", "japanese"),
    [
        *(("example", *each) for each in (*FLOOR_SHAKING, *STANDING)),
        *(("simulate", *each) for each in (*FLOOR_SHAKING, *STANDING)),
        *(("verify", *each) for each in FLOOR_SHAKING),
    ],
)
def test_what_a_flag_gets_wrong_is_named_by_the_flag(tmp_path, command, words, english, japanese):
    file = tmp_path / "scene.toml"
    file.write_text(FILE, encoding="utf-8")
    beginning = ("simulate",) if command == "example" else (command, str(file))
    for said, wanted in zip(refused(*beginning, *words), (english, japanese), strict=True):
        assert said.startswith(wanted)
        assert not KEY.search(said)


@pytest.mark.parametrize(("words", "english", "japanese"), [*SHAKING, *STRENGTH, *OF_A_BUILDING])
def test_a_building_is_refused_by_its_flags(words, english, japanese):
    for said, wanted in zip(refused("building", *words), (english, japanese), strict=True):
        assert said.startswith(wanted)
        assert not KEY.search(said)


@pytest.mark.parametrize(
    ("words", "english", "japanese"),
    [
        (("motion", "info", "sine:0,0"), "MOTION: the frequency is 0;", "MOTIONの周波数が0に"),
        (("motion", "plot", "sine:1,0", "a.png"), "MOTION: the frequency is 0;", "MOTIONの周波数が0に"),
        (("motion", "spectrum", "near-fault", "--dt", "0"), "--dt is 0;", "--dtが0に"),
        (("motion", "spectrum", "near-fault", "--damping", "7"), "--damping is 7;", "--dampingが7に"),
        (("motion", "info", "near-fault", "--unit", "g"), "--unit is given without", "--unitは揺れの方向の"),
        (
            ("motion", "convert", "near-fault", "a.csv", "--intensity", "99"),
            "--intensity is 99;",
            "--intensityが99に",
        ),
        (("fragility", "FILE", "--out", "x", "--im", "XX"), "--im", "--im"),
        (("fragility", "FILE", "--out", "x", "--measure", "XX"), "--measure is 'XX'", "--measureが'XX'に"),
    ],
)
def test_other_commands_are_refused_by_their_flags_too(tmp_path, monkeypatch, words, english, japanese):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "FILE").write_text(FILE, encoding="utf-8")
    for said, wanted in zip(refused(*words), (english, japanese), strict=True):
        assert said.startswith(wanted)
        assert not KEY.search(said)


def test_every_flag_that_sets_a_key_has_a_wrong_value_above():
    tried = {words[0] for words, _, _ in (*FLOOR_SHAKING, *STANDING, *OF_A_BUILDING)}
    tried |= {"--motion", "--x"}  # which is as --motion
    commands = get_command(app).commands
    names = {name for command in ("simulate", "verify", "building") for name in flags_of(commands[command])}
    assert {flag for name, flag in names if name in SET_BY} <= tried
    assert set(SET_BY) <= {name for name, _ in names}


def flags_of(command):
    return {(param.name, flag) for param in command.params for flag in param.opts[:1]}


def test_what_the_file_gets_wrong_keeps_the_name_of_its_key(tmp_path):
    file = tmp_path / "scene.toml"
    file.write_text(FILE.replace("0.4", "0.0"), encoding="utf-8")
    english, japanese = refused("simulate", str(file), "--wall", "0.1", "--pga", "3")
    assert english.startswith("scene.toml: furniture.width is 0.0;")
    assert japanese.startswith("scene.toml：furniture.widthが0.0に")


def test_a_storey_of_the_file_is_named_by_its_key_beside_the_building_of_a_flag(tmp_path):
    file = tmp_path / "scene.toml"
    building = "[shaking]\nbuilding = { storeys = 9 }\nstorey = 9"
    file.write_text(FILE.replace("[shaking]", building), encoding="utf-8")
    english, _ = refused("simulate", str(file), "--building", "3")
    assert english == "shaking.storey is 9; it must be between 1 and 4, the roof.\n"


def test_a_refusal_that_no_flag_stands_for_stays_as_it_is():
    body = {"body": "--body"}
    for field in ("furniture.shelves", "contents", None):
        error = InputError("model.paper_in_space", field)
        assert as_typed(error, body, body).told("en") == error.told("en")
