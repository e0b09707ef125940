"""The notes of a release are its part of the changelog."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import stayput

ROOT = Path(__file__).parents[2]


def printed(*arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, str(ROOT / "docs" / "release_notes.py"), *arguments]
    return subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=False)


def test_a_version_has_its_part_alone():
    done = printed("0.1.0")
    assert done.stdout == printed("v0.1.0").stdout
    assert done.returncode == 0
    assert done.stdout.startswith("### Added")
    assert "`simulate`: one body, one motion" in done.stdout
    assert "## [" not in done.stdout
    assert "`sweep`" not in done.stdout  # of the version after


def test_the_newest_release_is_the_default_and_what_is_to_come_can_be_asked_for():
    assert printed().stdout == printed(stayput.__version__).stdout
    assert "`sweep`" in printed("Unreleased").stdout


def test_an_unknown_version_is_refused():
    done = printed("9.9.9")
    assert done.returncode == 2
    assert done.stdout == ""
    assert "'9.9.9'" in done.stderr
    assert "0.1.0" in done.stderr
