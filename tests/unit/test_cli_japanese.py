"""Every command in Japanese, by --lang and by the locale: no English words in what it says and reports."""

from __future__ import annotations

import re
from codecs import BOM_UTF8
from typing import TYPE_CHECKING

import pytest
from commands import cli

from long_cases import long
from stayput.cli.messages import of_locale
from stayput.model.body import FURNITURE

if TYPE_CHECKING:
    from pathlib import Path

SCENARIO = """
title = "事務室の書棚"
[furniture]
preset = "bookcase"
[room]
floor = "wood flooring"
left_wall = { gap = 0.02 }
ceiling = { height = 2.4 }
[shaking]
SHAKING
suite = { family = "near-fault", count = 4 }
[uncertainty]
samples = 2
[[measures]]
type = "tension_pole"
name = "ポール/とストッパー 😀"
[[measures]]
type = "l_bracket"
name = "ポール とストッパー"
"""

INVENTORY = """id,preset,building,storey,measures,value
書棚,bookcase,10 RC,5,l_bracket;tension_pole+wedge_stopper,1000
悪い行,だんす,,,,
"""


_PATH = re.compile(r"\S*/\S*/\S*")
_WORD = re.compile(r"[A-Za-zω]+")

ALLOWED = set(
    _WORD.findall(  # names, quantities and units; files, and what is typed
        "stayput Mavroeidis Papageorgiou Worden FEMA P A B C Dask UTF RC PFA PFV PGA PGV CAV SI Sa Sd Sva ω "
        "D Tm T MMI ζ S km g gal x y z m cm s kg N Hz e p I L F V "
        "csv png svg html xml md ja nrml pelicun report OpenQuake NRML Ctrl"
    )
)
"""Latin words of a Japanese text."""


def english(text: str, *also: str) -> set[str]:
    """Return the Latin words of a text, beside those allowed and paths."""
    return set(_WORD.findall(_PATH.sub("", text))) - ALLOWED - set(also)


@pytest.fixture
def scenario(tmp_path: Path) -> Path:
    return written(tmp_path, 'intensity = "6-upper"')


def written(folder: Path, shaking: str) -> Path:
    path = folder / "事務室 1.toml"
    path.write_text(SCENARIO.replace("SHAKING", shaking), encoding="utf-8")
    return path


def japanese(*arguments: object, code: int = 0) -> str:
    done = cli(*arguments, "--lang", "ja")
    assert done.exit_code == code, done.output
    return done.output


@pytest.mark.parametrize(
    "arguments",
    [
        ("motion", "info", "near-fault"),
        ("motion", "spectrum", "near-fault"),
        ("motion", "info", "near-fault", "--building", "3", "--set", "shaking.mmi=8"),
        ("motion", "info", "near-fault", "--building", "3", "--set", "shaking.building.nonlinear=false"),
        ("simulate",),
        ("simulate", "--set", "shaking.mmi=8", "--set", "dimensions=3", "--set", "furniture.length=0.8"),
    ],
)
def test_what_is_printed(arguments: tuple[str, ...]) -> None:
    assert not english(japanese(*arguments))


@pytest.mark.usefixtures("japanese_font")
def test_long_cells_are_folded_and_nothing_is_lost(tmp_path: Path) -> None:
    furniture = "[furniture]\ndiameter = 0.5\nheight = 1.6\nmass = 250.0\n"
    file = tmp_path / "drum.toml"
    file.write_text(f'{furniture}[shaking]\nbuiltin = "near-fault"\nscale = 0.01\n', encoding="utf-8")
    said = re.sub(r"\s", "", japanese("simulate", file))
    assert "全成分を合わせた最大加速度" in said
    assert "…" not in said


def test_what_is_written_is_named(tmp_path: Path) -> None:
    for arguments in (
        ("motion", "plot", "near-fault", tmp_path / "波形.png"),
        ("motion", "convert", "near-fault", tmp_path / "波形.csv"),
        ("motion", "suite", "--count", "2", "--target", "japan", "--out", tmp_path / "波群"),
    ):
        assert not english(japanese(*arguments), "suite")


@pytest.mark.parametrize("shaking", ['intensity = "6-upper"', "sa = { period = 0.3, value = 8 }"])
def test_a_verdict_and_its_report(tmp_path: Path, shaking: str) -> None:
    page = tmp_path / "報告.html"
    assert not english(japanese("verify", written(tmp_path, shaking), "--report", page))
    told = page.read_text(encoding="utf-8").replace("\N{NO-BREAK SPACE}", " ")
    assert ("周期0.3秒の加速度応答800 gal = 8 m/s²" in told) == shaking.startswith("sa")


@pytest.mark.parametrize("im", ["MMI", "PGA", "SA(0.3)", *long("JMA", "PFV")])
def test_fragility_with_names_that_loss_tools_do_not_take(scenario: Path, tmp_path: Path, im: str) -> None:
    out = tmp_path / "脆弱性 1"
    said = japanese("verify", scenario, "--im", im, "--curves", out)
    identifiers = {word for name in re.findall(r"measure_\w+", said) for word in _WORD.findall(name)}
    assert not english(said, *identifiers, "curves", "observed", "fragility")
    drawn = (out / "fragility.svg").read_text(encoding="utf-8")
    assert "転倒確率" in re.sub(r"<!-- (.*?) -->", r"\1", drawn)
    rows = (out / "curves.csv").read_bytes()
    assert rows.startswith(BOM_UTF8)  # by which Excel tells its encoding
    rows = rows.decode("utf-8")
    assert "ポール/とストッパー 😀" in rows


def test_an_inventory_in_both_languages(tmp_path: Path) -> None:
    table, event = tmp_path / "家具 一覧.csv", written(tmp_path, "mmi = 8")
    table.write_text(INVENTORY, encoding="utf-8")
    event.write_text(event.read_text(encoding="utf-8").partition("[[measures]]")[0], encoding="utf-8")
    event.write_text(re.sub(r'\[furniture\]\npreset = "bookcase"', "", event.read_text(encoding="utf-8")))
    out = tmp_path / "結果 1"
    said = japanese("assess", table, "--scenario", event, "--out", out)
    assert not english(said, "rejects", "preset")  # as the table heads its column
    page = (out / "report.ja.html").read_text(encoding="utf-8")
    shown = re.sub(r"<[^>]*>", " ", page.partition("<body>")[2])
    assert not english(shown, "rejects", "summary", "preset", *re.findall(r"'([a-z ]+)'", shown), *PRESETS)
    assert "だんす" in page
    assert '<html lang="en">' in (out / "report.html").read_text(encoding="utf-8")


KNOWN = ("JMA", "SA", "toml", "help", "shaking")
"""What refusals list."""

PRESETS = {word for preset in FURNITURE for word in preset.split()}


@pytest.mark.parametrize(
    "arguments",
    [
        ("verify", "ない.toml"),
        ("assess", "ない.csv", "--scenario", "ない.toml", "--out", "結果"),
        ("verify", "ない.toml", "--curves", "結果", "--im", "MMX"),
        ("verify", "ない.toml", "--curves", "結果", "--im", "SA(99)"),
        ("simulate", "--set", "shaking.pga=much"),
        ("motion", "info", "near-fault", "--building", "3", "--set", "shaking.mmi=13"),
        ("motion", "info", "ない.csv"),
        ("app", "--port", "70000"),
    ],
)
def test_refusals_are_japanese(arguments: tuple[str, ...]) -> None:
    said = japanese(*arguments, code=2)
    assert "。" in said or "次のいずれか" in said
    unquoted = re.sub(r"'[^']*'", "", said)
    assert not english(unquoted, *_WORD.findall(" ".join(arguments)), *KNOWN)


@pytest.mark.parametrize(
    ("variables", "language"),
    [
        ({"LANG": "ja_JP.UTF-8"}, "ja"),
        ({"LANG": "en_US.UTF-8", "LC_ALL": "ja_JP.UTF-8"}, "ja"),
        ({"LANG": "ja_JP.UTF-8", "LC_MESSAGES": "C"}, "en"),
        ({"LANG": "C.UTF-8"}, "en"),
    ],
)
def test_the_locale_says_the_language(
    variables: dict[str, str], language: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("LANG", "LC_ALL", "LC_MESSAGES"):
        monkeypatch.setenv(name, variables.get(name, ""))
    assert of_locale() == language
    said = cli("verify", "none.toml").output
    assert ("ファイル" in said) == (language == "ja")
