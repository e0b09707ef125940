"""The commands that README, docs, examples and Makefile tell are there, and those of the README run."""

import re
import shlex
import tomllib
from pathlib import Path

import pytest
from few_runs import copy_examples
from PIL import Image
from typer.main import get_command
from typer.testing import CliRunner

import stayput as sp
from stayput.cli import app

ROOT = Path(__file__).parents[2]
TOLD = [
    ROOT / "README.md",
    ROOT / "Makefile",
    *(ROOT / "docs").glob("*.md"),
    *(ROOT / "examples").glob("*.toml"),
]
README = TOLD[0].read_text(encoding="utf-8")
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


OF_THE_README = [shlex.split(found[1], comments=True) for found in COMMAND.finditer(README)]
SERVES = [["app"]]
"""Runs until it is stopped: the tests of the app start it as a process of its own."""

WRITES = ("--plot", "--animate", "--report", "--out")


@pytest.fixture
def beside_examples(tmp_path, monkeypatch):
    copy_examples(tmp_path)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("words", [words for words in OF_THE_README if words not in SERVES], ids=" ".join)
def test_a_command_of_the_readme_runs(words, beside_examples):
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 0, result.output
    assert result.output.strip()
    written = {words[n + 1] for n, word in enumerate(words) if word in WRITES}
    assert all((beside_examples / name).exists() for name in written)


@pytest.mark.long
def test_the_readmes_picture_shows_what_its_command_prints():
    """``python docs/index_picture.py`` draws it anew."""
    with Image.open(ROOT / "docs" / "verdict.png") as picture:
        drawn = picture.info["Description"]
    verdict = sp.verify(sp.read(ROOT / "examples" / "bookcase.toml"), progress=False)
    assert drawn == verdict.sentence("en")


def test_the_readmes_python_runs(beside_examples, capsys):
    told = {}
    for block in re.findall(r"```python\n(.*?)```", README, re.DOTALL):
        exec(block.replace('shaking="6-upper"', 'shaking="6-upper", samples=4'), told)
    assert "overturned" in capsys.readouterr().out
    for name in ("bookcase.png", "bookcase.html", "verdict.html"):
        assert (beside_examples / name).stat().st_size > 10_000
