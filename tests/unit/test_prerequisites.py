"""How ``make test`` comes to a Chromium and a Japanese font: there, installed, or a plain line for each."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(os.name != "posix", reason="programs of the tests are shell scripts")

TESTS = Path(__file__).parents[1]
WORKS, BROKEN = "exit 0", "exit 127"
PAGE = """
from browsing import browser, chromium

def test_of_the_page(browser):
    pass
"""


class Machine:
    """A machine that has the programs of one folder, and cannot download anything."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.programs = folder, folder / "bin"
        self.programs.mkdir()
        self.log = folder / "log"

    def has(self, name: str, does: str) -> None:
        program = self.programs / name
        program.write_text(f'#!{shutil.which("sh")}\necho "{name} $@" >> {self.log}\n{does}\n')
        program.chmod(0o755)

    def run(self, *arguments: str, ci: bool = False) -> subprocess.CompletedProcess[str]:
        environment = {
            "PATH": str(self.programs),
            "HOME": str(self.folder),
            "PLAYWRIGHT_BROWSERS_PATH": str(self.folder / "browsers"),
            "PLAYWRIGHT_DOWNLOAD_HOST": "http://127.0.0.1:9",
            "NO_PROXY": "127.0.0.1",
            "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",  # they take longer to load than the tests take
        }
        if ci:
            environment["CI"] = "true"
        return subprocess.run(
            [sys.executable, *arguments], env=environment, capture_output=True, text=True, check=False
        )

    def prepare(
        self, *, font: bool = True, driver: bool = True, ci: bool = False
    ) -> subprocess.CompletedProcess[str]:
        """Run what ``make test`` runs first, on a machine with or without a font and Playwright's library."""
        program = (
            f"import sys; sys.path.insert(0, {str(TESTS)!r}); import prerequisites as it\n"
            f"it.has_japanese_font = lambda: {font}; it.has_japanese_font.cache_clear = lambda: None\n"
            f"it._path_of_download = lambda: {'absent' if driver else None!r}\n"
            "sys.exit(it.main())"
        )
        return self.run("-c", program, ci=ci)

    def asked(self) -> list[str]:
        return self.log.read_text().splitlines() if self.log.exists() else []


@pytest.fixture
def machine(tmp_path):
    return Machine(tmp_path)


@pytest.mark.parametrize("name", ["chromium", "chromium-browser", "google-chrome"])
def test_a_browser_that_is_there_is_taken_without_a_word(machine, name):
    machine.has(name, WORKS)
    machine.has("apt-get", WORKS)
    done = machine.prepare()
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert machine.asked() == [f"{name} --version"]


def test_one_that_does_not_start_is_none(machine):
    machine.has("chromium", BROKEN)
    machine.has("google-chrome", WORKS)
    assert machine.prepare().returncode == 0
    assert machine.asked() == ["chromium --version", "google-chrome --version"]


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root installs packages")
def test_the_package_manager_installs_one(machine):
    made = machine.programs / "chromium"
    machine.has(
        "apt-get",
        f'case "$1" in install) printf "#!/bin/sh\\n" > {made}; {shutil.which("chmod")} 755 {made};; esac',
    )
    done = machine.prepare(ci=True)
    assert done.returncode == 0, done.stderr
    assert machine.asked() == [
        "apt-get update -q",
        "apt-get install -y -q --no-install-recommends chromium libatomic1",
    ]


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root installs packages")
@pytest.mark.parametrize(
    ("lacks", "package"),
    [({"font": False}, "fonts-ipafont-gothic"), ({"driver": False}, "chromium libatomic1")],
    ids=["font", "library of the driver"],
)
def test_what_is_missing_is_installed_and_only_that(machine, lacks, package):
    machine.has("chromium", WORKS)
    machine.has("apt-get", WORKS)
    machine.prepare(**lacks)
    installed = [line for line in machine.asked() if line.startswith("apt-get install")]
    assert installed == [f"apt-get install -y -q --no-install-recommends {package}"]


@pytest.mark.parametrize("ci", [False, True])
def test_where_none_can_be_had_a_line_says_how(machine, ci):
    machine.has("apt-get", BROKEN)
    done = machine.prepare(ci=ci)
    assert done.returncode == int(ci)
    *_, line = done.stderr.splitlines()
    assert "-m playwright install --with-deps chromium, or apt install chromium libatomic1." in line
    assert line.endswith("Until then these tests are skipped.") != ci


def test_each_missing_kind_has_one_line(machine):
    machine.has("chromium", WORKS)
    done = machine.prepare(font=False, driver=False)
    _, browser, font = done.stderr.splitlines()
    assert browser.startswith(
        "The page is tested in Chromium, and there is none that starts with its driver;"
    )
    assert font.startswith("Pictures with Japanese words are tested with a Japanese font;")


@pytest.mark.parametrize("ci", [False, True])
def test_tests_of_the_page_are_skipped_but_never_where_ci_is_set(machine, tmp_path, ci):
    (tmp_path / "test_page.py").write_text(PAGE)
    (tmp_path / "conftest.py").write_text(
        f"import sys; sys.path.insert(0, {str(TESTS / 'app')!r}); sys.path.insert(0, {str(TESTS)!r})"
    )
    done = machine.run("-m", "pytest", "-q", "-ra", "-p", "no:cacheprovider", str(tmp_path), ci=ci)
    assert (
        "The page is tested in Chromium, and there is none that starts with its driver; to get it: "
        in done.stdout
    )
    assert ("1 skipped" in done.stdout) != ci
    assert ("1 error" in done.stdout) == ci
    assert done.returncode == int(ci)
