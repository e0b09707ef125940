"""Every writer of the command line ends in a sentence where the disk is full, and leaves nothing behind."""

from __future__ import annotations

import errno
import os
import shutil
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest
from commands import BEDROOM, BOOKCASE
from typer.testing import CliRunner

from stayput.cli import app

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

WRITERS = [
    "verify piece.toml --report out/report.html",
    "verify piece.toml --csv out/ranking.csv",
    "verify room.toml --card out/plan.html",
    "simulate --motion sine:2,1,1 --plot out/run.png",
    "simulate --motion sine:2,1,1 --plot out/run.pdf",
    "simulate --motion sine:2,1,1 --animate out/run.html",
    "simulate --motion sine:2,1,1 --animate out/run.gif",
    "motion convert sine:2,1,1 out/floor.csv --building 2 --storey 2",
    "motion convert near-fault out/motion.csv",
    "motion plot near-fault out/motion.pdf",
    "motion spectrum near-fault --out out/spectra.csv",
    "motion suite --count 2 --out out/suite",
    "verify piece.toml --curves out/curves",
]


class _Full:
    """An open file on a disk that takes some bytes of it and no more."""

    def __init__(self, file) -> None:
        self._file = file

    def __getattr__(self, name: str):
        return getattr(self._file, name)

    def __enter__(self):
        return self

    def __exit__(self, *_: object) -> None:
        self._file.close()

    def write(self, content) -> int:
        self._file.write(content[:1])
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


@pytest.fixture
def full(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder on which the disk is full, in the working folder."""
    import builtins
    import io

    opened: Callable = builtins.open
    out = tmp_path / "out"
    out.mkdir()

    def on_a_full_disk(file, mode="r", *arguments, **options):
        there = opened(file, mode, *arguments, **options)
        return _Full(there) if "r" not in mode and str(file).startswith(("out/", str(out))) else there

    (tmp_path / "piece.toml").write_text(BOOKCASE + '[[measures]]\ntype = "belt"\n', encoding="utf-8")
    (tmp_path / "room.toml").write_text(BEDROOM, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    for module in (builtins, io):  # pathlib calls that of io
        monkeypatch.setattr(module, "open", on_a_full_disk)
    return out


@pytest.mark.long
@pytest.mark.parametrize("line", WRITERS)
def test_a_writer_that_meets_a_full_disk(full: Path, line: str) -> None:
    done = CliRunner().invoke(app, line.split())
    assert done.exit_code == 2, done.output
    assert done.stderr.endswith("could not be written: no space left on device.\n")
    assert done.stderr.count("\n") == 1
    assert not list(full.iterdir())


def test_what_was_found_is_told_even_if_it_cannot_be_written(full: Path) -> None:
    done = CliRunner().invoke(app, ["verify", "piece.toml", "--report", "out/report.html"])
    assert "overturns" in done.stdout
    assert "Wrote" not in done.stdout


def test_older_results_stay_as_they_were(full: Path) -> None:
    older = full / "suite"
    older.mkdir()
    (full.parent / "note").write_text("older", encoding="utf-8")
    (full.parent / "note").replace(older / "suite.csv")
    assert CliRunner().invoke(app, ["motion", "suite", "--count", "2", "--out", "out/suite"]).exit_code == 2
    assert [file.name for file in older.iterdir()] == ["suite.csv"]
    assert (older / "suite.csv").read_text(encoding="utf-8") == "older"


@pytest.mark.skipif(os.name != "posix" or shutil.which("ffmpeg") is None, reason="ffmpeg writes MP4 films")
def test_a_film_that_ffmpeg_cannot_write_whole_is_refused(tmp_path: Path) -> None:
    program = [sys.executable, "-m", "stayput", "simulate", "--animate", "film.mp4"]
    # no file may grow beyond 64 KiB, as if the disk were full by then
    limited = ["bash", "-c", 'trap "" XFSZ; ulimit -f 64; exec "$@"', "bash", *program]
    done = subprocess.run(limited, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 2, done.stderr
    assert "ffmpeg could not write .mp4: " in done.stderr
    assert not list(tmp_path.iterdir())
