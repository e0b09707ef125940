"""Flags that commands share: ``--set`` and the shaking over a file's; what is refused of a command line."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from commands import BEDROOM, SLENDER, cli
from typer.testing import CliRunner

import stayput as sp
from stayput.cli import app
from stayput.cli.flags import changed, value_of


def verified(folder, text, shaking, *flags):
    file = folder / "scene.toml"
    file.write_text(text.replace('"near-fault"', f'"near-fault"\n{shaking}'), encoding="utf-8")
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
    assert verified(tmp_path, SLENDER, "scale = 0.5", *flags) == verified(tmp_path, SLENDER, said)


def test_a_room_takes_the_same_flags(tmp_path):
    strong = verified(tmp_path, BEDROOM, "scale = 0.1", "--pga", "8")
    assert strong == verified(tmp_path, BEDROOM, "pga = 8.0")
    assert strong != verified(tmp_path, BEDROOM, "scale = 0.1")


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


def test_report_and_plan_may_not_be_one_file(tmp_path):
    file = tmp_path / "room.toml"
    file.write_text(BEDROOM, encoding="utf-8")
    (tmp_path / "sub").mkdir()
    done = cli("verify", file, "--report", tmp_path / "r.html", "--card", tmp_path / "sub" / ".." / "r.html")
    assert done.exit_code == 2
    assert "--report and --card are both" in done.stderr
    assert not (tmp_path / "r.html").exists()


READ = {
    "room.toml": ("simulate room.toml --plot .png", "simulate room.toml --animate .gif"),
    "record.csv": (
        "verify room.toml --card .html",
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
    text = BEDROOM.replace('builtin = "near-fault"', 'record = "record.csv"')
    Path("room.toml").write_text(text, encoding="utf-8")
    before = Path(source).read_bytes()
    *command, ending = words.split()
    out = Path(f"out{ending}")
    link(source, out)
    done = cli(*command, out)
    assert done.exit_code == 2
    assert f"'{out}'; it must be another file than '{source}'" in done.stderr
    assert out.samefile(source)
    assert Path(source).read_bytes() == before


@pytest.mark.parametrize("mark", ["\x1b[31m", "\u202e", "\n", "\u200b"])
def test_names_with_control_characters_are_refused_and_never_printed(tmp_path, mark):
    named = {"furniture": {"preset": "bookcase", "name": f"a{mark}b"}}
    with pytest.raises(sp.InputError, match=r"it must be a text of .* without control characters") as refused:
        sp.Scenario.parse(named)
    for make, place in ((sp.Door, ("left_wall", 0.0, 0.8)), (sp.PersonPlace.of, ("bed", (1.0, 1.0)))):
        with pytest.raises(sp.InputError, match="must be a text of one or more characters"):
            make(*place, name=f"a{mark}b")
    record = sp.sine(amplitude=1.0, frequency=1.0, duration=1.0)
    motion = sp.Motion(record.dt, record.x, name=f"a{mark}b")
    measure_refuses = sp.InputError(f"My own words{mark}.")
    for told in (str(refused.value), motion.name, str(measure_refuses)):
        assert mark not in told


BOTH = (("en", 0), ("ja", 1))


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "scene.toml"
    path.write_text(SLENDER, encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("4", 4),
        ("4.5", 4.5),
        (".5", 0.5),
        ("-3.", -3.0),
        ("true", True),
        ('"4"', "4"),
        ("[0.1, 0.2]", [0.1, 0.2]),
        ("{ gap = 0.1 }", {"gap": 0.1}),
        ("6-upper", "6-upper"),
        ("wood flooring", "wood flooring"),
        ("6強", "6強"),
        ("00", "00"),
        ("", ""),
        ("1\nother = 2", "1\nother = 2"),
        ("[" * 99, "[" * 99),
    ],
)
def test_a_value_is_tomls_or_a_text(text: str, value: object) -> None:
    found = value_of(text)
    assert (found, type(found)) == (value, type(value))


@pytest.mark.parametrize(
    ("tables", "settings", "wanted"),
    [
        ({}, ["a.b.c=1"], {"a": {"b": {"c": 1}}}),
        ({"a": {"b": 1, "c": 2}}, ["a.b=3"], {"a": {"b": 3, "c": 2}}),
        ({"a": "carpet"}, ["a.gap=1"], {"a": {"gap": 1}}),
        ({"a": [{"b": 1}, {"b": 2}]}, ["a[1].b=3"], {"a": [{"b": 1}, {"b": 3}]}),
        ({"a": [{"b": 1}]}, ["a[1].b=3"], {"a": [{"b": 1}, {"b": 3}]}),
        ({}, ["a[0]=3"], {"a": [3]}),
        ({}, ["a.b=1", "a={ c = 2 }"], {"a": {"c": 2, "b": 1}}),
    ],
)
def test_a_key_is_set_where_it_stands_and_nothing_else(
    tables: dict[str, object], settings: list[str], wanted: dict[str, object]
) -> None:
    before = json.dumps(tables)
    assert changed(tables, {"set": settings}) == wanted
    assert json.dumps(tables) == before


@pytest.mark.parametrize(
    ("shaking", "setting", "wanted"),
    [
        ({"builtin": "near-fault", "pga": 3}, "scale=2", {"builtin": "near-fault", "scale": 2}),
        ({"intensity": 5.0}, "scale=2", {"suite": {}, "scale": 2}),
        ({"sa": {"period": 0.3, "value": 8}}, "sa.value=4", {"sa": {"period": 0.3, "value": 4}}),
        ({"builtin": "near-fault", "storey": 3}, "suite.count=4", {"storey": 3, "suite": {"count": 4}}),
        (
            {"record": "a.csv", "unit": "gal"},
            "component=180",
            {"record": "a.csv", "unit": "gal", "component": "180"},
        ),
    ],
)
def test_a_motion_or_a_strength_stands_in_the_place_of_the_files(
    shaking: dict[str, object], setting: str, wanted: dict[str, object]
) -> None:
    assert changed({"shaking": shaking}, {"set": [f"shaking.{setting}"]}) == {"shaking": wanted}


@pytest.mark.parametrize("command", ["simulate", "verify"])
@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--set", "pga"), ("--set is 'pga'; it must be written like", "--setが'pga'になっています")),
        (("--set", "shaking..pga=1"), ("--set is", "--setが")),
        (
            ("--set", "shaking.pgaa=1"),
            ("shaking.pgaa is unknown (did you mean 'pga'?)", "shaking.pgaaというキー"),
        ),
        (("--set", "shaking.pga="), ("shaking.pga is ''; it must be", "shaking.pgaが''に")),
        (
            ("--set", "furniture[0].mass=3"),
            ("'furniture[0].mass' is no key", "'furniture[0].mass'というキー"),
        ),
        (
            ("--set", "measures[5].type=belt"),
            ("'measures[5].type' is no key", "'measures[5].type'というキー"),
        ),
        (
            ("--pga", "3", "--set", "shaking.pga=4"),
            ("--set shaking.pga is given beside --pga;", "--pgaと--set shaking.pgaの"),
        ),
        (
            ("--pga", "3", "--intensity", "6"),
            ("shaking.pga is given beside shaking.intensity", "shaking.intensityとshaking.pga"),
        ),
        (("--motion", "sine:0,0"), ("shaking.sine.frequency is 0;", "shaking.sine.frequencyが0に")),
        (("--motion", "sine:1"), ("--motion is 'sine:1'; it must be written", "--motionが'sine:1'に")),
        (
            ("--building", "5,mud"),
            ("shaking.building.structure is 'mud';", "shaking.building.structureが'mud'に"),
        ),
    ],
)
def test_what_is_wrong_is_refused_as_in_a_file(
    file: Path, command: str, words: tuple[str, ...], told: tuple[str, str]
) -> None:
    for language, place in BOTH:
        done = cli(command, file, *words, "--lang", language)
        assert (done.exit_code, done.stdout) == (2, "")
        assert done.stderr.startswith(told[place])
        assert done.stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--body", "0x1x1"), ("furniture.width is 0;", "furniture.widthが0に")),
        (("--body", "1x1"), ("--body is '1x1'; it must be written", "--bodyが'1x1'に")),
        (("--floor", "carpt"), ("room.floor is 'carpt' (did", "room.floorが'carpt'に")),
        (
            ("--body", "1x1x1", "--set", "furniture={}"),
            ("--set furniture is given beside --body", "--bodyと--set furniture"),
        ),
    ],
)
def test_what_simulate_alone_takes(words: tuple[str, ...], told: tuple[str, str]) -> None:
    for language, place in BOTH:
        done = cli("simulate", *words, "--lang", language)
        assert done.exit_code == 2
        assert done.stderr.startswith(told[place])


def test_what_the_file_gets_wrong_is_told_with_its_name(file: Path) -> None:
    file.write_text(SLENDER.replace("width = 0.3", "width = 0.0"), encoding="utf-8")
    done = cli("simulate", file, "--set", "room.left_wall.gap=0.1", "--pga", "3")
    assert done.stderr.startswith("scene.toml: furniture.width is 0.0;")


def test_a_piece_of_several_is_named_by_its_place() -> None:
    dresser = Path(__file__).parents[2] / "examples/dresser.toml"
    done = cli("simulate", dresser, "--set", "furniture[0].mass=-1")
    assert done.stderr.startswith("furniture[0].mass is -1;")


def test_a_file_begins_in_the_working_folder(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    here = file.parent / "here"
    here.mkdir()
    sp.sine(3.0, 1.0, 2.0).write(here / "2024.csv")
    monkeypatch.chdir(here)
    done = cli("simulate", file, "--set", "shaking.record=2024.csv", "--json")
    assert json.loads(done.stdout)["motion"]["pga_m_s2"] == pytest.approx(3.0)


def test_an_assessment_takes_it_of_each_of_its_scenarios(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("pyarrow")
    monkeypatch.chdir(file.parent)
    events = file.parent / "events"
    events.mkdir()
    text = SLENDER.partition("[uncertainty]")[0].partition("[room]")[2]
    stated = text.replace('"near-fault"', '"near-fault"\npga = 4')
    for folder, content in ((events, text), (file.parent, stated)):
        for name in "ab":
            (folder / f"{name}.toml").write_text(f"[room]{content}", encoding="utf-8")
    (file.parent / "inventory.csv").write_text("id,preset\na,bookcase\n", encoding="utf-8")

    def found(out: str, *words: object) -> dict[str, object]:
        done = cli("assess", "inventory.csv", "--out", out, *words, "--json", "--quiet")
        assert done.exit_code == 0, done.output
        return json.loads(done.stdout)["events"]

    both = found("both", "--scenario", "events", "--set", "shaking.pga=4")
    one = found("one", "--scenario", "a.toml")
    assert both["a"] == both["b"] == one["a"]
    assert found("weak", "--scenario", "events", "--set", "shaking.pga=0.5") != both
    for language, told in (("en", "a.toml: shaking.pga is 0;"), ("ja", "a.toml：shaking.pgaが0に")):
        line = "assess inventory.csv --scenario events --out none --set shaking.pga=0 --lang"
        refused = cli(*line.split(), language)
        assert refused.exit_code == 2
        assert refused.stderr.startswith(told)


def test_a_key_that_no_file_may_have_is_refused_by_python_too() -> None:
    with pytest.raises(sp.InputError, match="only one of the two must be given"):
        changed({}, {"set": ["title=a", "title=b"]})
