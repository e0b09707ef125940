"""Flags that commands share: the shaking over a file's, the language; what is refused of a command line."""

import json
import os
from pathlib import Path

import pytest
from commands import cli
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


READ = {
    "room.toml": ("simulate room.toml --plot .png", "simulate room.toml --animate .gif"),
    "record.csv": (
        "verify room.toml --plan .html",
        "verify room.toml --report .html",
        "verify room.toml --csv .csv",
        "motion convert record.csv .csv",
        "motion plot record.csv .svg",
        "motion spectrum record.csv --out .csv",
        "motion spectrum record.csv --plot .pdf",
        "motion plot record.csv --building 9 .png",
    ),
    "other.csv": ("verify room.toml --motion other.csv --markdown .md",),
}


@pytest.mark.parametrize("link", [os.symlink, os.link])
@pytest.mark.parametrize(("source", "words"), [(file, words) for file in READ for words in READ[file]])
def test_no_output_takes_the_place_of_what_is_read(tmp_path, monkeypatch, link, source, words):
    monkeypatch.chdir(tmp_path)
    for name, amplitude in (("record.csv", 1.0), ("other.csv", 2.0)):
        sp.sine(amplitude=amplitude, frequency=1.0, duration=1.0).write(name)
    text = ROOM.replace('builtin = "near-fault"\nSHAKING', 'record = "record.csv"')
    Path("room.toml").write_text(text, encoding="utf-8")
    before = Path(source).read_bytes()
    *command, ending = words.split()
    out = Path(f"out{ending}")
    link(source, out)
    done = cli(*command, out)
    assert done.exit_code == 2
    assert f"'{out}'; it must be another one than '{source}'" in done.stderr
    assert out.samefile(source)
    assert Path(source).read_bytes() == before


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
