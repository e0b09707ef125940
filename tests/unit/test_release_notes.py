"""The notes of a release are its part of the changelog."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

from typer.main import get_command

import stayput
from stayput.cli import app

ROOT = Path(__file__).parents[2]


def printed(*arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(ROOT / "docs" / "release_notes.py"), *arguments]
    return subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=False)


def test_a_version_has_its_part_alone():
    done = printed("0.1.0")
    assert done.stdout == printed("v0.1.0").stdout
    assert done.returncode == 0
    assert done.stdout.startswith("### Added")
    assert "`simulate`: one body, one motion" in done.stdout
    assert "## [" not in done.stdout
    assert "`sweep`" not in done.stdout  # of the version after


def test_the_newest_release_is_the_default_and_what_is_to_come_can_be_asked_for():
    assert printed().stdout == printed(stayput.__version__).stdout
    assert "`sweep`" in printed("Unreleased").stdout


def test_an_unknown_version_is_refused():
    done = printed("9.9.9")
    assert done.returncode == 2
    assert done.stdout == ""
    assert "'9.9.9'" in done.stderr
    assert "0.1.0" in done.stderr


TO_COME = printed("Unreleased").stdout
TABLE = re.search(r"^\| before.*?\n\n", TO_COME, re.DOTALL | re.MULTILINE)[0]


def flags_of(command):
    """All flags of a command and of those below it."""
    own = {flag for parameter in command.params for flag in parameter.opts}
    return own.union(*map(flags_of, getattr(command, "commands", {}).values()))


def test_what_is_gone_is_not_there():
    for row in TABLE.strip().splitlines()[2:]:
        for name in re.findall("`([^`]+)`", row.split("|")[1]):
            command, names = get_command(app), name.removeprefix("stayput ").split()
            while names[0] in getattr(command, "commands", {}):
                command = command.commands[names.pop(0)]
            assert names[0] not in flags_of(command), name
            assert names[0] not in dir(stayput), name


def test_tables_flags_and_names_that_are_told_are_there():
    tables = {field.alias or name for name, field in stayput.Scenario.model_fields.items()}
    assert set(re.findall(r"`\[+(\w+)\]+`", TO_COME)) <= tables
    flags = set(re.findall(r"(?<![\w-])--[\w-]+", TO_COME.replace(TABLE, "")))
    assert flags <= flags_of(get_command(app)) | {"--lang"}
    for name in re.findall(r"`run\.(\w+)", TO_COME):
        assert hasattr(stayput.Run, name) != (name in ("x", "z", "tilt_rate")), name
