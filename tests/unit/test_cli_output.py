"""Output that cannot be written: a full disk, a reader that has gone, a closed output."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = [sys.executable, "-c", "from stayput.cli import main; main()"]
BODY = ["--body", "0.5x1.0x50", "--motion", "sine:2,1,1"]
INFO = ["motion", "info", "near-fault"]
COMMANDS = [["simulate", *BODY, "--json"], INFO, ["simulate", "--help"], ["--version"]]
"""A value of each way to print: JSON, a table, the text of the options, and a line."""


def given(arguments: list[str], **options):
    # no thread of a crash reporter or profiler speaks here: all that is on standard error is ours
    return subprocess.run(
        [*PROGRAM, *arguments], stderr=subprocess.PIPE, text=True, timeout=300, check=False, **options
    )


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full on this system")
@pytest.mark.parametrize("arguments", COMMANDS, ids=" ".join)
def test_a_full_disk_is_said_in_a_sentence(arguments):
    with Path("/dev/full").open("w") as full:
        done = given(arguments, stdout=full)
    assert done.stderr == "The output could not be written: no space left on device.\n"
    assert done.returncode == 2


@pytest.mark.parametrize("arguments", COMMANDS, ids=" ".join)
def test_a_reader_that_has_gone_is_no_error_to_speak_of(arguments):
    reader, writer = os.pipe()
    os.close(reader)
    done = given(arguments, stdout=writer)
    os.close(writer)
    assert done.stderr == ""
    assert done.returncode == 141


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full on this system")
def test_where_nothing_can_be_said_the_exit_code_says_it():
    with Path("/dev/full").open("w") as full:
        done = subprocess.run([*PROGRAM, *INFO], stdout=full, stderr=full, check=False)
    assert done.returncode == 2


def shelled(redirected, *arguments):
    """What a shell sees of the program whose streams it has redirected: code, output, error output."""
    line = ["sh", "-c", f'"$@" {redirected}', "sh", *PROGRAM, *map(str, arguments)]
    done = subprocess.run(line, capture_output=True, text=True, encoding="utf-8", check=False)
    return done.returncode, done.stdout, done.stderr


ON_POSIX = pytest.mark.skipif(os.name != "posix", reason="a shell redirects streams")


@ON_POSIX
@pytest.mark.parametrize(("also", "place"), [("", 0), ("<&-", 1)])
def test_a_closed_output_loses_the_result_and_is_said(also, place):
    said = (
        "The output could not be written: it is closed.",
        "出力を書き込めませんでした（閉じられています）。",
    )
    found = shelled(f">&- {also}", *INFO, "--lang", ("en", "ja")[place])
    assert found == (2, "", f"{said[place]}\n")


@ON_POSIX
def test_a_command_that_prints_nothing_needs_no_output(tmp_path):
    found = shelled(">&-", "motion", "convert", "near-fault", tmp_path / "a.csv", "--quiet")
    assert found == (0, "", "")


@ON_POSIX
@pytest.mark.parametrize("there", ["2>&-", "2>/dev/full"])
def test_a_result_does_not_need_standard_error(there):
    plain = given(INFO, stdout=subprocess.PIPE)
    assert shelled(there, *INFO) == (0, plain.stdout, "")


@ON_POSIX
@pytest.mark.parametrize(("flag", "place"), [("SCENARIO", 0), ("--motion", 1)])
def test_a_closed_input_is_refused(flag, place):
    said = (
        f"{flag}, standard input, cannot be read: it is closed.\n",
        f"{flag}（標準入力）を読み込めません（閉じられています）。\n",
    )
    words = ("-",) if flag == "SCENARIO" else (flag, "-")
    assert shelled("<&-", "simulate", *words, "--lang", ("en", "ja")[place]) == (2, "", said[place])
