"""What programs of a shell do: ``-h``, ``-q``, completion, the module, flags over a file."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from typing import TYPE_CHECKING

import pytest
from typer.main import get_command
from typer.testing import CliRunner

import stayput as sp
from stayput.cli import app
from stayput.cli.flags import words
from stayput.fragility import INTENSITY_MEASURES
from stayput.measures import MEASURES
from stayput.model.room import SURFACES
from stayput.motion.intensity import CLASSES
from stayput.motion.suites import FAMILIES, MIXED
from stayput.progress import bar, is_drawn, is_quiet, keep_quiet

if TYPE_CHECKING:
    from pathlib import Path

SCENARIO = """
[furniture]
preset = "bookcase"
[shaking]
intensity = "6-upper"
SHAKING
"""


def cli(*arguments: object):
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


def commands(group=None, before: tuple[str, ...] = ()):
    for name, command in (group or get_command(app)).commands.items():
        if hasattr(command, "commands"):
            yield from commands(command, (*before, name))
        else:
            yield (*before, name), command


@pytest.mark.parametrize("words", [(), ("motion",), *(words for words, _ in commands())], ids=" ".join)
def test_h_is_help(words: tuple[str, ...]) -> None:
    short, long = cli(*words, "-h"), cli(*words, "--help")
    assert short.exit_code == 0
    assert short.stdout == long.stdout


@pytest.mark.parametrize(("words", "command"), list(commands()), ids=lambda given: str(given))
def test_every_command_can_be_quiet(words: tuple[str, ...], command) -> None:
    assert words
    assert any("-q" in parameter.opts for parameter in command.params)


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
    assert run("motion", "info", out).stderr.endswith("must be readable.\n")
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
    words = ["simulate", "--motion", "sine:1,1,1", "--animate", str(file), "--fps", "5"]
    done = CliRunner().invoke(app, words, env={"FORCE_COLOR": "1", "COLUMNS": "120"})
    assert done.exit_code == 0
    assert "Drawing" in done.stderr


@pytest.mark.parametrize(
    ("shaking", "flags", "same"),
    [
        ("", ("--set", "shaking.scale=0.4"), "suite = {}\nscale = 0.4"),
        (
            "suite = { count = 2 }",
            ("--set", "shaking.scale=2"),
            "suite = { count = 2 }\nscale = 2.0",
        ),
        ("", ("--set", "shaking.pgv=0.5"), "pgv = 0.5"),
        ('builtin = "near-fault"', ("--intensity", "5.5"), 'builtin = "near-fault"\nintensity = 5.5'),
    ],
)
def test_a_flag_replaces_what_the_file_says_of_the_strength(
    tmp_path: Path, shaking: str, flags: tuple[str, ...], same: str
) -> None:
    file, other = tmp_path / "file.toml", tmp_path / "other.toml"
    file.write_text(SCENARIO.replace("SHAKING", shaking), encoding="utf-8")
    other.write_text(SCENARIO.replace('intensity = "6-upper"\nSHAKING', same), encoding="utf-8")
    flagged, stated = cli("simulate", file, "--json", *flags), cli("simulate", other, "--json")
    assert flagged.exit_code == stated.exit_code == 0, flagged.output + stated.output
    assert json.loads(flagged.stdout) == json.loads(stated.stdout)


def completed(line: str, shell: str = "zsh") -> tuple[list[str], float]:
    """Return what a shell is offered at the end of a line, and how long that takes [s]."""
    given = {"_STAYPUT_COMPLETE": f"complete_{shell}"}
    if shell == "bash":
        given |= {"COMP_WORDS": line, "COMP_CWORD": str(len(line.split(" ")) - 1)}
    else:
        given |= {"_TYPER_COMPLETE_ARGS": line}
    started = time.perf_counter()
    look = "import sys\nfrom stayput.cli import main\ntry: main()\nfinally: assert 'numba' not in sys.modules"
    done = subprocess.run(
        [sys.executable, "-c", look], env={**os.environ, **given}, capture_output=True, text=True, check=True
    )
    return done.stdout.splitlines(), time.perf_counter() - started


def test_completion_offers_measures_and_surfaces_and_is_quick() -> None:
    offered, seconds = completed("stayput simulate --measure tension", "bash")
    assert offered == ["tension_pole"]
    assert seconds < 3.0  # 0.4 s on an idle machine
    offered, _ = completed("stayput simulate --floor wood", "bash")
    assert offered == [r"wood\ flooring"]
    offered, _ = completed("stayput verify --intens", "bash")
    assert offered == ["--intensity"]


def test_every_list_of_words_has_its_words() -> None:
    offered = {
        "measures:MEASURES": MEASURES,
        "catalogue.names:SURFACES": SURFACES,
        "catalogue.names:INTENSITIES": [name for name, _ in CLASSES],
        "catalogue.names:FAMILIES": [MIXED, *FAMILIES],
        "fragility:INTENSITY_MEASURES": INTENSITY_MEASURES,
    }
    for listed, every in offered.items():
        assert words(listed)("") == list(every)
        assert words(listed)("?") == []
