"""What programs of a shell do: ``-h``, ``-q``, completion, the module, flags over a file."""

from __future__ import annotations

import os
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest
from commands import cli

import stayput as sp
from stayput.cli.flags import words
from stayput.fragility.intensity_measures import INTENSITY_MEASURES
from stayput.measures import MEASURES
from stayput.model.room import SURFACES
from stayput.motion.intensity import CLASSES
from stayput.motion.suites.families import FAMILIES
from stayput.motion.suites.synthesis import MIXED
from stayput.progress import bar, is_drawn, is_quiet, keep_quiet

if TYPE_CHECKING:
    from pathlib import Path


def test_the_module_is_the_program() -> None:
    printed = [
        subprocess.run([sys.executable, *start, "-V"], capture_output=True, text=True, check=True).stdout
        for start in (("-m", "stayput"), ("-c", "from stayput.cli import main; main()"))
    ]
    assert printed == [f"stayput {sp.__version__}\n"] * 2


@pytest.mark.parametrize("before", [True, False])
def test_quiet_leaves_results_and_refusals(tmp_path: Path, before: bool) -> None:
    motion = sp.Motion(0.01, [0.0, 60.0, -60.0, *[0.0] * 100])  # more than 5 g, which is warned of
    file, out = motion.write(tmp_path / "large.csv"), tmp_path / "again.csv"

    def run(*words: object):
        return cli("--quiet", *words) if before else cli(*words, "-q")

    loud, quiet = cli("motion", "info", file), run("motion", "info", file)
    assert "Warning" in loud.stderr
    assert quiet.stderr == ""
    assert quiet.stdout == loud.stdout
    assert "Wrote" not in run("motion", "plot", file, tmp_path / "plot.svg").stdout
    assert run("motion", "convert", file, tmp_path / "copy.csv").output == ""
    assert run("motion", "info", out).stderr.endswith("cannot be read: no such file or directory.\n")
    assert not is_quiet()  # the commands have ended


def test_quiet_draws_no_bar(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setenv("FORCE_COLOR", "1")
    assert is_drawn()
    keep_quiet(True)
    try:
        assert not is_drawn()
        with bar(10, "progress.simulating") as advance:
            advance(10)
    finally:
        keep_quiet(False)
    assert capsys.readouterr() == ("", "")


def test_a_film_is_drawn_with_a_bar_of_its_frames(tmp_path: Path) -> None:
    file = tmp_path / "film.gif"
    words = ["simulate", "--motion", "sine:1,1,1", "--animate", file, "--fps", "5"]
    done = cli(*words, FORCE_COLOR="1", COLUMNS="120")
    assert done.exit_code == 0
    assert "Drawing" in done.stderr


def completed(line: str, shell: str = "zsh", locale: str = "C.UTF-8") -> str:
    """Return what a shell is offered at the end of a line."""
    given = {"_STAYPUT_COMPLETE": f"complete_{shell}", "_TYPER_COMPLETE_FISH_ACTION": "get-args"}
    if shell == "bash":
        given |= {"COMP_WORDS": line, "COMP_CWORD": str(len(line.split(" ")) - 1)}
    else:
        given |= {"_TYPER_COMPLETE_ARGS": line, "LC_ALL": locale, "PYTHONUTF8": "1"}
    look = "import sys\nfrom stayput.cli import main\ntry: main()\nfinally: assert 'numba' not in sys.modules"
    start, environment = [sys.executable, "-c", look], os.environ | given
    done = subprocess.run(start, env=environment, capture_output=True, encoding="utf-8", check=True)
    assert "cli_help" not in done.stdout
    return done.stdout


@pytest.mark.parametrize(
    ("line", "offered"),
    [
        ("stayput simulate --measure tension", "tension_pole"),
        ("stayput simulate --floor wood", r"wood\ flooring"),
        ("stayput verify --intens", "--intensity"),
    ],
)
def test_completion_offers_measures_surfaces_and_flags(line: str, offered: str) -> None:
    assert completed(line, "bash").split("\n") == [offered, ""]


@pytest.mark.parametrize(
    ("shell", "locale", "flag", "command"),
    [
        ("zsh", "ja_JP.UTF-8", "この説明を表示して終了する", "揺れを調べる、変換する、作る"),
        ("fish", "ja_JP.UTF-8", "この説明を表示して終了する", "揺れを調べる、変換する、作る"),
        ("zsh", "C.UTF-8", "Any key of the scenario", "Look at a motion"),
    ],
)
def test_a_shell_shows_sentences_beside_flags_and_commands(
    shell: str, locale: str, flag: str, command: str
) -> None:
    assert flag in completed("stayput verify --", shell, locale)
    assert command in completed("stayput ", shell, locale)


def test_every_list_of_words_has_its_words() -> None:
    offered = {
        "measures:MEASURES": MEASURES,
        "catalogue.names:SURFACES": SURFACES,
        "catalogue.names:INTENSITIES": [name for name, _ in CLASSES],
        "catalogue.names:FAMILIES": [MIXED, *FAMILIES],
        "fragility.intensity_measures:INTENSITY_MEASURES": INTENSITY_MEASURES,
    }
    for listed, every in offered.items():
        assert words(listed)("") == list(every)
        assert words(listed)("?") == []
