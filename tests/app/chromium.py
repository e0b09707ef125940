"""Chromium for the tests of the page: finds one, and gets one where there is none.

``make test`` runs this file; the documentation's pictures of the app are taken in what it finds. What it
tries in turn: Playwright's own download; as root, the system's package manager. Where that fails the tests of
the page are skipped, except where CI is set.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
DOWNLOAD = [sys.executable, "-m", "playwright", "install", "chromium"]
MANAGERS = {
    "apt-get": [["update", "-q"], ["install", "-y", "-q", "--no-install-recommends", "chromium"]],
    "dnf": [["install", "-y", "-q", "chromium"]],
    "apk": [["add", "-q", "chromium"]],
    "pacman": [["-Sy", "--noconfirm", "-q", "chromium"]],
}
PATIENCE = 600.0
"""How long a download may take [s]."""

ABSENT = (
    "There is no Chromium, in which the page is tested; to get one: "
    f"{os.path.relpath(sys.executable)} -m playwright install --with-deps chromium, or apt install chromium."
)


def found() -> str | None:
    """Return a Chromium that starts: the system's, else Playwright's."""
    for name in NAMES:
        path = shutil.which(name)
        if path is not None and _starts(path):
            return path
    own = _of_playwright()
    return own if own is not None and _starts(own) else None


def wanted() -> bool:
    """Return whether the tests of the page must run: then no Chromium is a failure."""
    return bool(os.environ.get("CI"))


def _of_playwright() -> str | None:
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        path = playwright.chromium.executable_path
    return path if Path(path).is_file() else None


def _starts(path: str) -> bool:
    """Return whether a program starts, with all the libraries that it needs."""
    try:
        return _runs([path, "--version"], 60.0)
    except OSError:
        return False


def _runs(command: list[str], patience: float = PATIENCE) -> bool:
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    quiet = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    try:
        return (
            subprocess.run(command, env=environment, timeout=patience, check=False, **quiet).returncode == 0
        )
    except subprocess.TimeoutExpired:
        return False


def got() -> str | None:
    """Return a Chromium that was installed now, or None where that is not possible."""
    print("There is no Chromium, in which the page is tested: it is downloaded.", file=sys.stderr)
    if _runs(DOWNLOAD) and (path := found()) is not None:
        return path
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        for name, steps in MANAGERS.items():
            program = shutil.which(name)
            if program is not None and all(_runs([program, *step]) for step in steps):
                return found()
    return None


def main() -> int:
    """Have a Chromium, or say in a line how to get one; return the exit code."""
    if found() is not None or got() is not None:
        return 0
    print(ABSENT if wanted() else f"{ABSENT} Until then these tests are skipped.", file=sys.stderr)
    return int(wanted())


if __name__ == "__main__":
    sys.exit(main())
