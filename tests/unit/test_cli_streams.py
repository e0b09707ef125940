"""``-`` in the place of a file: what comes on standard input, and results that go to standard output."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from typing import TYPE_CHECKING

import numpy as np
import pytest
from commands import SLENDER, cli

import stayput as sp
from stayput.cli import flags, streams

if TYPE_CHECKING:
    from pathlib import Path


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scenario.toml").write_text(SLENDER, encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize(
    "command", [("simulate",), ("simulate", "--measure", "belt"), ("verify", "--csv", "-")]
)
def test_a_scenario_on_standard_input_is_as_good_as_a_file(here: Path, command: tuple[str, ...]) -> None:
    name, *flags = command
    from_file, from_stream = cli(name, "scenario.toml", *flags), cli(name, "-", *flags, given=SLENDER)
    assert from_stream.exit_code == 0, from_stream.output
    assert from_stream.stdout == from_file.stdout


def test_a_refused_scenario_is_called_standard_input(here: Path) -> None:
    done = cli("verify", "-", given=SLENDER.replace("height = 1.5", "height = -1.5"))
    assert done.exit_code == 2
    assert done.stderr.startswith("standard input: furniture.height is -1.5")
    done = cli("verify", "-", given="[furniture")
    assert "'standard input'" in done.stderr


def test_streams_are_told_in_japanese(here: Path) -> None:
    wrong = SLENDER.replace("height = 1.5", "height = -1.5")
    assert "standard input" not in (told := cli("verify", "-", "--lang", "ja", given=wrong).stderr)
    assert told.startswith("標準入力")
    assert "標準入力" in cli("motion", "info", "-", "--lang", "ja", given="").stderr
    done = cli("motion", "info", "-", "--lang", "ja", given=sp.sine(3.0, 1.0, 4.0).text())
    assert done.stdout.startswith("標準入力")
    done = cli("motion", "spectrum", "near-fault", "--out", "-", "--plot", "図.png", "--lang", "ja")
    assert done.stdout.startswith("period_s,")
    assert done.stderr == "図.pngを書き出しました\n"


def test_a_record_goes_through_two_commands_bit_by_bit(here: Path) -> None:
    motion = sp.near_fault()
    printed = cli("motion", "convert", "near-fault", "-")
    assert printed.exit_code == 0
    assert printed.stdout == motion.text(".csv")
    assert printed.stderr == ""
    again = cli("motion", "convert", "-", "again.csv", given=printed.stdout)
    assert again.exit_code == 0, again.output
    read = sp.read_motion(here / "again.csv")
    for name, values in motion.components.items():
        assert np.array_equal(read.components[name], values)


def test_what_is_printed_of_a_record_has_the_format_that_is_asked_for(here: Path) -> None:
    done = cli("motion", "convert", "near-fault", "-", "--only", "x", "--format", "at2")
    assert done.stdout == sp.near_fault().component("x").text(".at2")
    assert cli("motion", "convert", "near-fault", "-", "--format", "mp3").exit_code == 2
    refused = cli("motion", "convert", "near-fault", "out.csv", "--format", "at2", "--only", "x")
    assert refused.exit_code == 2
    assert not (here / "out.csv").exists()


def test_a_refusal_of_a_record_on_standard_input_names_no_temporary_file() -> None:
    done = cli("motion", "info", "-", given="")
    assert done.exit_code == 2
    assert done.stderr.startswith("The motion file 'standard input' is empty; it must be a text of a record")
    done = cli("motion", "info", "-", given=sp.near_fault().component("x").text(".at2")[:2000])
    assert done.stderr.startswith("standard input (PEER AT2): ")


def test_one_table_on_standard_output_and_another_in_a_file(here: Path) -> None:
    done = cli("verify", "scenario.toml", "--csv", "-", "--markdown", "verdict.md")
    assert done.stdout.startswith("rank,option,")
    assert done.stderr == "Wrote verdict.md\n"
    assert (here / "verdict.md").read_text(encoding="utf-8").startswith("#")
    done = cli("verify", "scenario.toml", "--markdown", "-", "--quiet")
    assert done.stdout.startswith("#")


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("verify", "scenario.toml", "--csv", "-", "--json"), "--csv and --json are both standard output"),
        (("verify", "scenario.toml", "--csv", "-", "--markdown", "-"), "are both standard output"),
        (("motion", "info", "-", "--set", "shaking.across=-"), "are both -;"),
        (("simulate", "-", "--set", "shaking.across=-"), "are both -;"),
        (
            ("simulate", "--motion", "-", "--set", "shaking.across=-"),
            "--set shaking.across and --motion are both -;",
        ),
        (("verify", "scenario.toml", "--report", "-"), ".html"),
        (("simulate", "--plot", "-"), ".png"),
    ],
)
def test_a_stream_is_for_one_thing(here: Path, arguments: tuple[str, ...], told: str) -> None:
    done = cli(*arguments, given=SLENDER)
    assert done.exit_code == 2
    assert told in done.stderr
    assert done.stderr.count("\n") == 1
    assert done.stdout == ""


def test_an_inventory_on_standard_input_is_the_same_assessment_as_its_file(here: Path) -> None:
    pytest.importorskip("pyarrow")
    rows = "id,preset\na,bookcase\nb,chest\n"
    (here / "inventory.csv").write_text(rows, encoding="utf-8")
    flags = ("--scenario", "scenario.toml", "--out", "results", "--quiet")
    piped = cli("assess", "-", *flags, given=rows)
    assert piped.exit_code == 0, piped.output
    assert piped.stderr == ""
    assert "Wrote" not in piped.stdout
    assert cli("assess", "inventory.csv", *flags).exit_code == 0  # of which the folder holds the results
    refused = cli(
        "assess", "-", "--scenario", "scenario.toml", "--out", "none", given="id,preset\na,bokcase\n"
    )
    assert refused.exit_code == 2
    assert refused.stderr.startswith("No row of the inventory could be assessed")


def test_a_scenario_on_standard_input_finds_its_records_in_the_working_folder(here: Path) -> None:
    pytest.importorskip("pyarrow")
    (here / "inventory.csv").write_text("id,preset\na,bookcase\n", encoding="utf-8")
    sp.near_fault().write(here / "quake.csv")
    text = SLENDER.replace('builtin = "near-fault"', 'record = "quake.csv"')
    flags = ("inventory.csv", "--scenario", "-", "--out", "results")
    done = cli("assess", *flags, "--json", "--quiet", given=text)
    assert done.exit_code == 0, done.output
    assert list(json.loads(done.stdout)["events"]) == ["standard input"]
    assert cli("assess", *flags, given=text).exit_code == 0  # the same assessment again
    twice = cli("assess", "-", "--scenario", "-", "--out", "none", given=text)
    assert twice.exit_code == 2
    wrong = cli("assess", *flags, given=text.replace("samples", "sampels"))
    assert wrong.exit_code == 2
    assert wrong.stderr.startswith("standard input: ")


@pytest.mark.parametrize(
    "given", [{"PYTHONIOENCODING": "ascii"}, {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}]
)
def test_letters_that_the_terminal_lacks_are_written_out(here: Path, given: dict[str, str]) -> None:
    command = [sys.executable, "-m", "stayput", "simulate", "scenario.toml", "--lang", "ja"]
    done = subprocess.run(command, env=os.environ | given, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr
    assert "\\u" in done.stdout


@pytest.mark.parametrize(
    ("language", "said"),
    [("en", "--motion is -, standard input, which has more than 9 bytes"), ("ja", "9バイトを超えて")],
)
def test_an_input_without_an_end_is_refused(
    monkeypatch: pytest.MonkeyPatch, language: str, said: str
) -> None:
    monkeypatch.setattr(flags, "LARGEST_RECORD", 9)
    monkeypatch.setattr(streams, "_CHUNK", 4)
    result = cli("simulate", "--motion", "-", "--lang", language, given="0 " * 1000)
    assert result.exit_code == 2
    assert said in result.stderr
