"""The commands that the README, the docs, the examples and the Makefile tell are commands that there are."""

import re
import shlex
import tomllib
from pathlib import Path

import pytest
from typer.main import get_command

from stayput.cli import app

ROOT = Path(__file__).parents[2]
TOLD = [
    ROOT / "README.md",
    ROOT / "Makefile",
    *(ROOT / "docs").glob("*.md"),
    *(ROOT / "examples").glob("*.toml"),
]
COMMAND = re.compile(r"^(?:\$ |# +|\t\$\(BIN\)/)stayput ([^\n]+)$", re.MULTILINE)


def commands():
    for file in TOLD:
        for found in COMMAND.finditer(file.read_text(encoding="utf-8")):
            words = shlex.split(found[1], comments=True)
            yield pytest.param(words, id=f"{file.name}: {' '.join(words)}")


def test_the_commands_are_found():
    named = [param.id for param in commands()]
    for file in ("README.md", "Makefile", "getting-started.md", "verify.md", "bookcase.toml"):
        assert any(name.startswith(file) for name in named)


@pytest.mark.parametrize("words", list(commands()))
def test_a_command_can_be_given_as_it_is_told(words):
    command, left = get_command(app), words
    while hasattr(command, "commands"):
        name, *left = left
        command = command.commands[name]
    given = command.make_context(words[0], left).params
    files = [value for value in given.values() if isinstance(value, Path) and value.parts[0] == "examples"]
    assert all((ROOT / file).exists() for file in files)


@pytest.mark.parametrize(
    ("file", "extra", "command"),
    [("README.md", "app", "app"), ("README.md", "inventory", "assess"), ("docs/app.md", "app", "app")],
)
def test_an_extra_is_installed_before_the_command_that_needs_it(file, extra, command):
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert extra in project["optional-dependencies"]
    lines = (ROOT / file).read_text(encoding="utf-8").splitlines()
    needs = next(n for n, line in enumerate(lines) if line.startswith(f"$ stayput {command}"))
    installs = (re.match(r"\$ pip install .*\.\[([a-z,]+)\]", line) for line in lines[:needs])
    assert any(extra in found[1].split(",") for found in installs if found)
