"""Damaged scenario files: each is refused with one sentence, or survives being written and read again."""

import time
import tracemalloc

import pytest
from damage import damaged
from hypothesis import given, settings
from hypothesis import strategies as st

from stayput.errors import LONGEST_SENTENCE, InputError
from stayput.scenario import Scenario, read_scenario

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
back_wall.gap = 0.02
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
        scenario = read_scenario(file)
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


@hostile
@given(text=damaged(WHOLE).flatmap(lambda once: damaged(once) if once else st.just(once)))
def test_two_pieces_of_damage(file, text):
    _check(file, text)


VALUES = st.recursive(
    st.one_of(
        st.integers(-(10**30), 10**30).map(str),
        st.sampled_from(
            ["1e999", "nan", "-inf", "true", "0x10", "1_000", "07:32:00", "1979-05-27", "''", '"a"']
        ),
        st.floats(allow_nan=False, allow_infinity=False).map(repr),
        st.text(alphabet="a.[]{}'#=", max_size=30).map(lambda text: f'"{text}"'),
    ),
    lambda inner: (
        st.lists(inner, max_size=4).map(lambda items: f"[{', '.join(items)}]")
        | st.lists(inner, max_size=3).map(
            lambda items: (
                "{" + ", ".join(f"{key} = {one}" for key, one in zip("abc", items, strict=False)) + "}"
            )
        )
    ),
    max_leaves=12,
)


@hostile
@given(data=st.data())
def test_any_value_in_the_place_of_one(file, data):
    lines = WHOLE.split("\n")
    place = data.draw(st.sampled_from([i for i, line in enumerate(lines) if " = " in line]))
    key = lines[place].split(" = ")[0]
    lines[place] = f"{key} = {data.draw(VALUES)}"
    _check(file, "\n".join(lines))


@hostile
@given(
    part=st.sampled_from(
        ["a.", "[", "{a=", "[[", "9", "[a]\n", "a.b.c.", '"', "'", '"""', "\\", "#", "é", "[a.b]\n"]
    ),
    count=st.integers(1, 20_000),
)
def test_long_repetitions_take_little_memory(file, part, count):
    text = WHOLE + "x = " + part * count
    tracemalloc.start()
    try:
        _read(file, text.encode())
        assert tracemalloc.get_traced_memory()[1] < 100e6
    finally:
        tracemalloc.stop()
