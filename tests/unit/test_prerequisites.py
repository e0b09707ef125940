"""Tests of the page where there is no Chromium: skipped with a line that says how to get one, or failed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from long_cases import long

TESTS = Path(__file__).parents[1]
PAGE = """
from browsing import browser

def test_of_the_page(browser):
    pass
"""


def without_chromium(folder: Path, *arguments: str, ci: bool) -> subprocess.CompletedProcess[str]:
    """Run a program on a machine without other programs, that cannot download anything."""
    environment = {
        "PATH": str(folder),
        "HOME": str(folder),
        "PLAYWRIGHT_BROWSERS_PATH": str(folder / "browsers"),
        "PLAYWRIGHT_DOWNLOAD_HOST": "http://127.0.0.1:9",
        "NO_PROXY": "127.0.0.1",
        "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",  # they take longer to load than the tests take
    } | ({"CI": "true"} if ci else {})
    line = [sys.executable, *arguments]
    return subprocess.run(line, env=environment, capture_output=True, text=True, check=False)


pytestmark = [
    pytest.mark.skipif(os.name != "posix", reason="programs are looked for as POSIX does"),
    pytest.mark.parametrize("ci", [False, *long(True)]),
]


def test_make_test_says_how_to_get_one(tmp_path, ci):
    done = without_chromium(tmp_path, str(TESTS / "prerequisites.py"), ci=ci)
    assert done.returncode == int(ci)
    (line,) = (line for line in done.stderr.splitlines() if "driver; to get it:" in line)
    assert "-m playwright install --with-deps chromium, or apt install chromium libatomic1." in line
    assert line.endswith("Until then these tests are skipped.") != ci


def test_tests_of_the_page_are_skipped_but_never_where_ci_is_set(tmp_path, ci):
    (tmp_path / "test_page.py").write_text(PAGE)
    paths = f"sys.path[:0] = [{str(TESTS / 'app')!r}, {str(TESTS)!r}]"
    (tmp_path / "conftest.py").write_text(f"import sys; {paths}")
    arguments = "-m", "pytest", "-q", "-ra", "-p", "no:cacheprovider", str(tmp_path)
    done = without_chromium(tmp_path, *arguments, ci=ci)
    assert "Chromium, and there is none that starts with its driver; to get it: " in done.stdout
    assert ("1 skipped" in done.stdout) != ci
    assert ("1 error" in done.stdout) == ci
    assert done.returncode == int(ci)
