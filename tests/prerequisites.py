"""What the tests need beside Python packages: Chromium, the libraries of its driver, and a Japanese font.

``make test`` runs this file. As root it installs what is missing with apt-get; where
that does not give a browser, Playwright downloads one. The tests of what is still missing are skipped, except
where CI is set.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from functools import cache
from typing import NoReturn

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
PLAYWRIGHT = [sys.executable, "-m", "playwright"]
BROWSER, FONT = "browser", "font"
PACKAGES = {BROWSER: ["chromium", "libatomic1"], FONT: ["fonts-ipafont-gothic"]}
INSTALL = ["install", "-y", "-q", "--no-install-recommends"]
PATIENCE = 600.0
"""How long a download may take [s]."""

ABSENT = {
    BROWSER: (
        "The page is tested in Chromium, and there is none that starts with its driver; to get it: "
        f"{os.path.relpath(sys.executable)} -m playwright install --with-deps chromium, "
        "or apt install chromium libatomic1."
    ),
    FONT: (
        "Pictures with Japanese words are tested with a Japanese font; to get one: "
        "apt install fonts-ipafont-gothic."
    ),
}
"""What is said where something is missing."""


@cache
def find_chromium() -> str | None:
    """Return a Chromium that starts, and whose driver does: the system's, else Playwright's."""
    downloaded = _path_of_download()
    if downloaded is None:
        return None
    found = filter(None, map(shutil.which, (*NAMES, downloaded)))
    return next((path for path in found if _runs([path, "--version"], 60.0)), None)


@cache
def has_japanese_font() -> bool:
    """Return whether the pictures find a font with Japanese letters."""
    # asked in a new process: Matplotlib looks for the system's fonts once in each
    search = "from stayput.report.figures import _other; raise SystemExit(_other(frozenset('対策')) is None)"
    return _runs([sys.executable, "-c", search])


def required() -> bool:
    """Return whether every test must run: then what is missing is a failure."""
    return bool(os.environ.get("CI"))


def do_without(what: str) -> NoReturn:
    """Skip the test that needs what is missing, or fail it where every test must run."""
    import pytest

    (pytest.fail if required() else pytest.skip)(ABSENT[what])


def missing() -> list[str]:
    """Return which prerequisites are missing."""
    return [BROWSER] * (find_chromium() is None) + [FONT] * (not has_japanese_font())


def install(wanted: list[str]) -> None:
    """Try to install prerequisites, as root by apt-get; a browser is also downloaded."""
    if shutil.which("apt-get") and hasattr(os, "geteuid") and os.geteuid() == 0:
        _runs(["apt-get", "update", "-q"])
        for one in wanted:
            _runs(["apt-get", *INSTALL, *PACKAGES[one]])
    for kept in (find_chromium, has_japanese_font):
        kept.cache_clear()
    if BROWSER in wanted and find_chromium() is None:
        _runs([*PLAYWRIGHT, "install", "chromium"])
        find_chromium.cache_clear()


def _path_of_download() -> str | None:
    """Return where Playwright puts the Chromium that it downloads; None where its driver does not start.

    The driver is a Node.js, which needs libatomic: Debian installs that apart.
    """
    from playwright.sync_api import sync_playwright

    try:
        with sync_playwright() as playwright:
            return playwright.chromium.executable_path
    except Exception:  # Playwright has no narrower class for it
        return None


def _runs(command: list[str], patience: float = PATIENCE) -> bool:
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    quiet = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    try:
        return (
            subprocess.run(command, env=environment, timeout=patience, check=False, **quiet).returncode == 0
        )
    except (OSError, subprocess.TimeoutExpired):
        return False


def main() -> int:
    """Have what the tests need, or say in a line each how to get it; return the exit code."""
    lacking = missing()
    if lacking:
        print(
            f"The tests need what is missing here, a {' and a '.join(lacking)}: installing ...",
            file=sys.stderr,
        )
        install(lacking)
        lacking = missing()
    for one in lacking:
        print(ABSENT[one] + ("" if required() else " Until then these tests are skipped."), file=sys.stderr)
    return int(required() and bool(lacking))


if __name__ == "__main__":
    sys.exit(main())
