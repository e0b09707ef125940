"""What a sentence names to be typed: each flag is one of the command line, each key one of a scenario."""

from __future__ import annotations

import re

import pytest
import typer.main

from stayput.app.limits import Limits
from stayput.app.reader import ReadingTask, read
from stayput.catalogue import TEXTS
from stayput.cli import app
from stayput.cli.messages import _flag, _flags_of
from stayput.motion.readers.columns import OPTIONS
from stayput.scenario.shaking import ShakingTable

FLAG = re.compile(r"(?<![a-z-])--[a-z][a-z_-]*")


@pytest.fixture(scope="module")
def flags() -> set[str]:
    return {"--help", *_flags_of(typer.main.get_command(app))}


def named_in(sentence: str) -> tuple[set[str], set[str]]:
    """Return the flags and the keys of the shaking that a sentence names."""
    return set(FLAG.findall(sentence)), set(re.findall(r"--set shaking\.([a-z_]+)", sentence))


def test_each_flag_in_the_catalogue_is_one(flags: set[str]) -> None:
    for key, texts in TEXTS.items():
        for text in texts:
            found, keys = named_in(text)
            assert found <= flags, key
            assert keys <= ShakingTable.model_fields.keys(), key


@pytest.mark.parametrize("option", sorted({"unit", "component", *OPTIONS}))
def test_each_option_of_reading_is_called_by_a_flag(flags: set[str], option: str) -> None:
    found, keys = named_in(_flag(option, flags) or "")
    assert found
    assert found <= flags
    assert keys <= ShakingTable.model_fields.keys()


@pytest.mark.parametrize(
    "text", ["# factor = 2\n0 1\n0.01 2\n", "0;1\n0,01;2\n0,02;3\n", "1 2 3\n", "4000\n1 2\n3 4\n"]
)
def test_the_page_names_flags_that_there_are(flags: set[str], tmp_path, text: str) -> None:
    file = tmp_path / "record.txt"
    file.write_text(text)
    refusal = read(ReadingTask(str(file), {"unit": "gal"}, Limits())).refusal
    assert refusal is not None
    for language in ("en", "ja"):
        found, keys = named_in(refusal.told(language))
        assert found
        assert found <= flags
        assert keys <= ShakingTable.model_fields.keys()
