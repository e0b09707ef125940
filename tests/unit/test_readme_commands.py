"""The README's commands and its Python run as they are told, in an empty folder beside the examples."""

import re
import shlex
import shutil
from pathlib import Path

import pytest
from typer.testing import CliRunner

from stayput.cli import app

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
CONSOLE = re.compile(r"```console\n(.*?)```", re.DOTALL)
PYTHON = re.compile(r"```python\n(.*?)```", re.DOTALL)
TOLD = [
    shlex.split(line.removeprefix("$ stayput "), comments=True)
    for block in CONSOLE.findall(README)
    for line in block.splitlines()
    if line.startswith("$ stayput ")
]
SERVES = [["app"]]
"""Runs until it is stopped: the tests of the app start it as a process of its own."""

WRITES = ("--plot", "--animate", "--report", "--out")

FEWER = {
    "bookcase.toml": {"count = 20": "count = 6", "samples = 40": "samples = 6"},
    "bedroom.toml": {"count = 20": "count = 6", "samples = 40": "samples = 6"},
    "kitchen.toml": {
        'intensity = "6-lower"': 'intensity = "6-lower"\nsuite = { count = 6 }',
        "samples = 200": "samples = 6",
    },
}
"""Fewer runs of the examples: as they are, the bookcase takes four seconds and the kitchen thirty."""


@pytest.fixture
def beside_examples(tmp_path, monkeypatch):
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    for name, changes in FEWER.items():
        file = tmp_path / "examples" / name
        text = file.read_text(encoding="utf-8")
        for usual, fewer in changes.items():
            assert usual in text
            text = text.replace(usual, fewer)
        file.write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_commands_are_found():
    assert len(TOLD) >= 8
    assert SERVES[0] in TOLD


@pytest.mark.parametrize("words", [words for words in TOLD if words not in SERVES], ids=" ".join)
def test_a_command_of_the_readme_runs(words, beside_examples):
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 0, result.output
    assert result.output.strip()
    written = {words[n + 1] for n, word in enumerate(words) if word in WRITES}
    assert all((beside_examples / name).exists() for name in written)


def test_the_readmes_python_runs(beside_examples, capsys):
    told = {}
    for block in PYTHON.findall(README):
        exec(block, told)
    assert "overturned" in capsys.readouterr().out
    for name in ("bookcase.png", "bookcase.html", "verdict.html"):
        assert (beside_examples / name).stat().st_size > 10_000
