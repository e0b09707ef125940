"""Damaged scenario files: each is refused with one sentence, or survives being written and read again."""

import time

import pytest
from damage import damaged
from hypothesis import given, settings

from stayput.errors import LONGEST_SENTENCE, InputError
from stayput.scenario import Scenario, read

pytestmark = pytest.mark.hostile

WHOLE = """\
title = "Bookcase, 5th floor of 10"  # a comment, with [brackets] and "quotes"
gravity = 9.80665

[furniture]
preset = "bookcase"
width = 0.3
cg_offset = [0.01, -0.05]

[room]
floor = { static_friction = 0.45, kinetic_friction = 0.35, restitution = 0.1 }
left_wall.gap = 0.02
ceiling = { height = 2.4 }

[shaking]
intensity = "6-upper"
vertical = true
storey = 5

[shaking.building]
storeys = 10
structure = "RC"

[initial]
tilt = 0.01

[[measures]]
type = "tension_pole"
name = '突っ張り棒'

[[measures]]
combine = [{ type = "anti_slip_sheet" }, { type = "belt" }]

[uncertainty]
samples = 40
seed = 1
"""

hostile = settings(max_examples=max(100, settings.default.max_examples))


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    return tmp_path_factory.mktemp("hostile") / "scenario.toml"


def _read(file, content: bytes) -> Scenario | None:
    file.write_bytes(content)
    start = time.process_time()
    scenario, said = None, None
    try:
        scenario = read(file)
    except InputError as error:
        said = str(error)
    assert time.process_time() - start < 2.0
    if said is not None:
        assert said.startswith("scenario.toml: ")
        assert said.endswith(".")
        assert "\n" not in said
        assert len(said) <= LONGEST_SENTENCE
    return scenario


def _check(file, text: str) -> None:
    scenario = _read(file, text.encode("utf-8", "replace"))
    if scenario is not None:
        written = scenario.to_toml()
        assert _read(file, written.encode()) == scenario


def test_the_undamaged_file_is_read(file):
    assert _read(file, WHOLE.encode()) is not None
    _check(file, WHOLE)


@hostile
@given(text=damaged(WHOLE))
def test_one_piece_of_damage(file, text):
    _check(file, text)
