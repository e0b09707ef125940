"""Flags that commands share: the shaking over a file's, the language; what is refused of a command line."""

import json
import os
from pathlib import Path

import pytest
from typer.testing import CliRunner

import stayput as sp
from stayput.cli import app

BLOCK = """
[furniture]
width = 0.3
height = 1.5
mass = 60.0
[room]
back_wall = { gap = 0.02 }
[shaking]
builtin = "near-fault"
SHAKING
[uncertainty]
samples = 4
[[measures]]
type = "belt"
"""
ROOM = """
[plan]
width = 3.6
length = 2.7
[[furniture]]
name = "bookcase"
preset = "bookcase"
against = "left_wall"
along = 1.35
[[places]]
kind = "bed"
at = [1.6, 1.35]
[shaking]
builtin = "near-fault"
SHAKING
[uncertainty]
samples = 2
"""


def cli(*arguments):
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


def verified(folder, text, shaking, *flags):
    file = folder / "scene.toml"
    file.write_text(text.replace("SHAKING", shaking), encoding="utf-8")
    done = cli("verify", file, "--json", "--threads", "2", *flags)
    assert done.exit_code == 0, done.output
    found = json.loads(done.stdout)
    return {key: value for key, value in found.items() if key not in ("seconds", "title", "scenario_toml")}


@pytest.mark.parametrize(
    ("said", "flags"),
    [
        ("pga = 3.0", ("--pga", "3")),
        ("pgv = 0.4", ("--set", "shaking.pgv=0.4")),
        ('intensity = "6-lower"', ("--intensity", "6-lower")),
        (
            "earthquake = { magnitude = 7.0, distance = 20.0, kind = 'intraslab' }",
            ("--set", "shaking.earthquake={ magnitude = 7, distance = 20, kind = 'intraslab' }"),
        ),
        (
            "scale = 0.8\nbuilding = { storeys = 4 }\nstorey = 3",
            ("--set", "shaking.scale=0.8", "--building", "4", "--storey", "3"),
        ),
    ],
)
def test_flags_of_verify_stand_in_the_place_of_what_the_file_says(tmp_path, said, flags):
    assert verified(tmp_path, BLOCK, "scale = 0.5", *flags) == verified(tmp_path, BLOCK, said)


def test_a_room_takes_the_same_flags(tmp_path):
    strong = verified(tmp_path, ROOM, "scale = 0.1", "--pga", "8")
    assert strong == verified(tmp_path, ROOM, "pga = 8.0")
    assert strong != verified(tmp_path, ROOM, "scale = 0.1")


def test_a_record_of_a_flag_begins_in_the_working_folder_and_a_mesh_in_the_file_s(tmp_path, monkeypatch):
    here, there = tmp_path / "here", tmp_path / "there"
    for folder in (here, there):
        folder.mkdir()
    sp.sine(amplitude=0.5, frequency=1.0, duration=2.0).write(here / "mine.csv")
    (there / "cube.obj").write_text(cube(), encoding="utf-8")
    (there / "scene.toml").write_text(
        '[[furniture]]\nname = "cube"\nmesh = "cube.obj"\nunit = "m"\nmass = 50.0\n'
        '[shaking]\nbuiltin = "near-fault"\n',
        encoding="utf-8",
    )
    monkeypatch.chdir(here)
    done = cli("simulate", there / "scene.toml", "--motion", "mine.csv", "--json")
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["motion"]["name"] == "mine"


def cube():
    """Return a cube of 1 m as an OBJ file, its faces seen from outside."""
    lines = [f"v {x} {y} {z}" for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    sides = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
    for a, b, c, d in sides:
        lines += [f"f {a} {b} {c}", f"f {a} {c} {d}"]
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("simulate", "--pga", "strong"), "--pga is 'strong'; it must be a number.\n"),
        (("simulate", "--storey", "1.5"), "--storey is '1.5'; it must be a whole number.\n"),
        (("app", "--port", "99999"), "--port is '99999'; it must be a whole number between 0 and 65535.\n"),
        (("simulate", "--pgx", "1"), "There is no flag '--pgx'; `stayput simulate --help` lists those"),
        (("verify",), "SCENARIO.toml is missing; `stayput verify --help` says"),
        (("verfy",), "No such command 'verfy' (did you mean 'verify'?); `"),
        (("--colour",), "There is no flag '--colour'"),
        (
            ("verify", "x.toml", "--lang", "ja", "--pga", "3m"),
            "--pgaが'3m'になっています。数値を指定してください。\n",
        ),
        (("verify", "none.toml", "--lang=ja"), "シナリオファイル'none.toml'"),
    ],
)
def test_a_command_line_is_refused_in_one_sentence(words, said):
    done = CliRunner().invoke(app, list(words), prog_name="stayput")
    assert done.exit_code == 2
    assert done.stdout == ""
    assert done.stderr.startswith(said)
    assert done.stderr.count("\n") == 1


def test_a_command_without_words_still_shows_its_help():
    done = cli("motion")
    assert done.exit_code == 2
    assert "Commands:" in done.output


def test_report_and_plan_may_not_be_one_file(tmp_path):
    file = tmp_path / "room.toml"
    file.write_text(ROOM.replace("SHAKING", ""), encoding="utf-8")
    (tmp_path / "sub").mkdir()
    done = cli("verify", file, "--report", tmp_path / "r.html", "--plan", tmp_path / "sub" / ".." / "r.html")
    assert done.exit_code == 2
    assert "--report and --plan are both" in done.stderr
    assert not (tmp_path / "r.html").exists()


@pytest.mark.parametrize("link", [os.symlink, os.link])
@pytest.mark.parametrize(
    ("words", "ending"),
    [
        (("verify", "room.toml", "--plan"), ".html"),
        (("verify", "room.toml", "--report"), ".html"),
        (("verify", "room.toml", "--markdown"), ".md"),
        (("verify", "room.toml", "--csv"), ".csv"),
        (("simulate", "room.toml", "--plot"), ".png"),
        (("simulate", "room.toml", "--animate"), ".gif"),
    ],
)
def test_no_output_takes_the_place_of_the_scenario_or_of_its_record(
    tmp_path, monkeypatch, link, words, ending
):
    monkeypatch.chdir(tmp_path)
    record = sp.sine(amplitude=1.0, frequency=1.0, duration=1.0).write("record.csv")
    text = ROOM.replace('builtin = "near-fault"\nSHAKING', 'record = "record.csv"')
    Path("room.toml").write_text(text, encoding="utf-8")
    other = sp.sine(amplitude=2.0, frequency=1.0, duration=1.0).write("other.csv")
    for number, (source, flags) in enumerate(
        [("room.toml", ()), (record, ()), (other, ("--motion", "other.csv"))]
    ):
        before = Path(source).read_bytes()
        out = Path(f"out{number}{ending}")
        link(source, out)
        done = cli(*words, out, *flags)
        assert done.exit_code == 2
        assert done.stderr.startswith(f"The file to write is '{out}'; it must be another one than '{source}'")
        assert out.samefile(source)
        assert Path(source).read_bytes() == before


@pytest.mark.parametrize(
    ("words", "ending"),
    [
        (("motion", "convert", "record.csv"), ".csv"),
        (("motion", "plot", "record.csv"), ".svg"),
        (("motion", "spectrum", "record.csv", "--out"), ".csv"),
        (("motion", "spectrum", "record.csv", "--plot"), ".pdf"),
        (("motion", "convert", "record.csv", "--building", "9", "--storey", "3"), ".csv"),
        (("motion", "plot", "record.csv", "--building", "9"), ".png"),
    ],
)
def test_no_output_takes_the_place_of_a_record(tmp_path, monkeypatch, words, ending):
    monkeypatch.chdir(tmp_path)
    record = sp.sine(amplitude=1.0, frequency=1.0, duration=1.0).write("record.csv")
    before = record.read_bytes()
    out = Path(f"out{ending}")
    out.symlink_to(record)
    done = cli(*words, out)
    assert done.exit_code == 2
    assert "it must be another one than 'record.csv', which is read" in done.stderr
    assert out.is_symlink()
    assert record.read_bytes() == before


@pytest.mark.parametrize("mark", ["\x1b[31m", "\u202e", "\n", "\u200b"])
def test_names_with_control_characters_are_refused_and_never_printed(tmp_path, mark):
    named = {"furniture": {"preset": "bookcase", "name": f"a{mark}b"}}
    with pytest.raises(sp.InputError, match=r"it must be a text of .* without control characters") as refused:
        sp.Scenario.parse(named)
    with pytest.raises(sp.InputError, match="must be a text without control characters"):
        sp.Door("left_wall", 0.0, 0.8, name=f"a{mark}b")
    with pytest.raises(sp.InputError, match="must be a text without control characters"):
        sp.PersonPlace.of("bed", (1.0, 1.0), name=f"a{mark}b")
    record = sp.sine(amplitude=1.0, frequency=1.0, duration=1.0)
    motion = sp.Motion(record.dt, record.x, name=f"a{mark}b")
    measure_refuses = sp.InputError(f"My own words{mark}.")
    for told in (str(refused.value), motion.name, str(measure_refuses)):
        assert mark not in told
