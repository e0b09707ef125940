"""Verdicts on the terminal: tables that fit its width in both languages, and the shaking as it was stated."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from commands import cli
from rich.cells import cell_len

from stayput.catalogue import LANGUAGES, say

if TYPE_CHECKING:
    from pathlib import Path

PIECE = """
[furniture]
preset = "bookcase"
[room]
back_wall = { gap = 0.02 }
[shaking]
intensity = "6-lower"
suite = { family = "near-fault", count = 2 }
[uncertainty]
samples = 4
"""

ROOM = """
[plan]
width = 3.6
length = 2.7
[[furniture]]
name = "bookcase"
preset = "bookcase"
against = "left_wall"
along = 1.9
[[places]]
kind = "bed"
at = [1.4, 1.9]
heading = 1.5707963
[shaking]
intensity = "6-upper"
suite = { family = "near-fault", count = 2 }
[uncertainty]
samples = 2
"""


def printed(folder: Path, scenario: str, width: int, *flags: str, command: str = "verify") -> str:
    file = folder / "scenario.toml"
    file.write_text(scenario, encoding="utf-8")
    done = cli(command, file, *flags, COLUMNS=str(width))
    assert done.exit_code == 0, done.output
    return done.stdout


@pytest.mark.parametrize("language", LANGUAGES)
def test_changes_of_a_room_are_a_list_where_their_table_would_break(tmp_path: Path, language: str) -> None:
    narrow, wide = (printed(tmp_path, ROOM, width, "--lang", language) for width in (80, 200))
    heading = say("rooms.hit_less", language)
    assert narrow.count(f"{heading} ") == 3  # beside each value
    assert wide.count(heading) == 1
    assert all(cell_len(line) <= 80 for line in narrow.splitlines())
    assert len({line for line in narrow.splitlines() if line.startswith(("Move", "「", "ベッドを"))}) == 3


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_ranking_that_is_too_wide_leaves_out_its_capacities(tmp_path: Path, language: str) -> None:
    narrow, wide = (printed(tmp_path, PIECE, width, "--lang", language).splitlines() for width in (60, 100))
    (told, *_) = (line for line in wide if "I50" in line)
    assert told.rstrip().endswith("I50")
    table = narrow[: next(n for n, line in enumerate(narrow) if line.startswith("–"))]
    table = [line for line in table if line[:1] in "123456789 "]
    assert any("I50" in line for line in table) == (language == "ja")  # which is narrower
    assert all(cell_len(line) <= 60 for line in table)


@pytest.mark.parametrize(
    ("flags", "english", "japanese"),
    [
        (("--pga", "4"), "peak ground acceleration 400 gal = 4 m/s²", "地面の最大加速度400 gal = 4 m/s²"),
        (
            ("--set", "shaking.pgv=0.5"),
            "peak ground velocity 50 cm/s = 0.5 m/s",
            "地面の最大速度50 cm/s = 0.5 m/s",
        ),
        (("--set", "shaking.mmi=8"), "modified Mercalli intensity 8", "改正メルカリ震度8"),
        (
            ("--set", "shaking.earthquake={ magnitude = 7, distance = 20 }"),
            "magnitude 7 at 20 km",
            "マグニチュード7、断層までの距離20 km",
        ),
        (("--intensity", "5.8"), "6-lower (5.8)", "震度6弱（計測震度5.8）"),
        ((), "JMA intensity 6-lower the", "震度6弱"),
    ],
)
def test_the_shaking_is_named_as_it_was_stated(
    tmp_path: Path, flags: tuple[str, ...], english: str, japanese: str
) -> None:
    for language, told in zip(LANGUAGES, (english, japanese), strict=True):
        text = printed(tmp_path, PIECE, 400, "--lang", language, *flags)
        assert told in text.splitlines()[0]


def test_simulate_names_the_stated_shaking(tmp_path: Path) -> None:
    assert "peak ground velocity 50 cm/s = 0.5 m/s" in printed(
        tmp_path, PIECE, 200, "--set", "shaking.pgv=0.5", command="simulate"
    )
