"""Hostile flags, mutated by their grammar: a command does what is asked, or says what is wrong.

HYPOTHESIS_PROFILE=thorough tries many more.
"""

from __future__ import annotations

import contextlib
import json

import pytest
from hypothesis import given
from hypothesis import strategies as st
from typer.testing import CliRunner

from stayput.cli import app

pytestmark = pytest.mark.hostile

SETTINGS = (
    "shaking.scale=1.5",
    "shaking.unit=gal",
    "shaking.columns=t=1,x=2",
    "shaking.skip_lines=2",
    "room.floor={ static_friction = 0.4, kinetic_friction = 0.3 }",
    "room.left_wall.gap=0.02",
    "furniture[0].mass=30",
    "measures[0].type=belt",
)
SHAKING = {"--intensity": "6-upper", "--pga": "4.5", "--building": "3,RC", "--storey": "2"}
FLAGS = {
    "simulate": {
        "--body": "0.4x1.8x100",
        "--motion": "sine:5,0.8,2",
        "--floor": "carpet",
        "--measure": "anti_slip_sheet",
        **SHAKING,
    },
    "motion info": SHAKING,
    "assess": {
        "--scenario": "no-such.toml",
        "--out": "no-such-folder/out",
        "--slide-limit": "0.1",
        "--threads": "2",
        "--memory": "2GB",
    },
}
NEEDED = {
    "simulate": ["--json"],
    "motion info": ["sine:1,1,2", "--json"],
    "assess": ["no-such.csv", "--scenario", "x.toml", "--out", "x"],
}
NUMBERS = ["nan", "inf", "-inf", "-1", "0", "1e999", "1e-320", "1e308", "9" * 400, "1_0", "0x1", "１", ""]
MARKS = [*"x,:; -=\u00d7\u3000\u202e'\"\n~\\\ufffd", "%s", "{}", "../"]
places = st.integers(0, 10**6)


@st.composite
def mutated(draw, text: str) -> str:
    """A value with something put in, which may take the place of what follows."""
    place = draw(places) % (len(text) + 1)
    anything = st.text(st.characters(exclude_characters="\0", codec="utf-8"), max_size=10)
    put_in = draw(st.sampled_from([*NUMBERS, *MARKS, text[place:]]) | anything)
    return text[:place] + put_in + draw(st.sampled_from(["", text[place:], text[place + 1 :]]))


@st.composite
def lines(draw) -> list[str]:
    """A command with some flags, one or more of them mutated."""
    command = draw(st.sampled_from(sorted(FLAGS)))
    flags = FLAGS[command]
    chosen = draw(st.lists(st.sampled_from(sorted(flags)), min_size=1, max_size=4))
    wrong = draw(places) % len(chosen)
    found = [*command.split(), *NEEDED[command]]
    for place, flag in enumerate(chosen):
        value = draw(mutated(flags[flag])) if place == wrong or draw(st.booleans()) else flags[flag]
        found += [f"{flag}={value}"]
    for setting in draw(st.lists(st.sampled_from(SETTINGS), max_size=2)):
        found += ["--set", draw(mutated(setting)) if draw(st.booleans()) else setting]
    return found


@given(lines())
def test_flags_are_taken_or_refused_in_a_sentence(tmp_path_factory, line):
    with contextlib.chdir(tmp_path_factory.getbasetemp()):
        done = CliRunner().invoke(app, line)
    assert done.exception is None or isinstance(done.exception, SystemExit), (line, done.exception)
    assert done.exit_code in (0, 2), (line, done.output)
    if done.exit_code == 0:
        json.loads(done.stdout)
    else:
        assert done.stderr.strip(), line
        assert "Traceback" not in done.output
