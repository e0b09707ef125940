"""Which lines of the page's modules run in Chromium; ``make coverage`` counts them.

The tests record where the environment variable PAGE_COVERAGE names a folder: a file for each page they open.
``python tests/app/page_coverage.py FOLDER`` prints the lines of each module and those that never ran.
"""

from __future__ import annotations

import json
import os
import re
import sys
from contextlib import contextmanager
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit
from uuid import uuid4

if TYPE_CHECKING:
    from collections.abc import Generator

    from playwright.sync_api import Page

SOURCES = Path(__file__).parents[2] / "src" / "stayput"
FOLDERS = {
    "": SOURCES / "app" / "page",
    "room/": SOURCES / "app" / "room_page",
    "canvas/": SOURCES / "report" / "canvas",
}
"""The folders of the pages' modules, by the paths under which the server has them."""

COMMENT = re.compile(r"^[^\S\n]*//[^\n]*$|/\*.*?\*/", re.MULTILINE | re.DOTALL)


def start() -> str:
    """Return where the page begins: where it is recorded, at that which loads each module by itself."""
    return "index.html" if os.environ.get("PAGE_COVERAGE") else ""


@contextmanager
def recorded(page: Page) -> Generator[None]:
    """Record which code of a page runs in the block, if PAGE_COVERAGE is set."""
    folder = os.environ.get("PAGE_COVERAGE")
    if not folder:
        yield
        return
    session = page.context.new_cdp_session(page)
    session.send("Profiler.enable")
    session.send("Profiler.startPreciseCoverage", {"callCount": True, "detailed": True})
    try:
        yield
    finally:
        scripts = session.send("Profiler.takePreciseCoverage")["result"]
        Path(folder, f"{uuid4().hex}.json").write_text(json.dumps(scripts), encoding="utf-8")
        session.detach()


def units_run(functions: list[dict[str, Any]], length: int) -> bytearray:
    """Return for each UTF-16 unit of a script whether it ran, from V8's ranges; inner ones overrule outer."""
    run = bytearray(length)
    ranges = [part for function in functions for part in function["ranges"]]
    for part in sorted(ranges, key=lambda part: (part["startOffset"], -part["endOffset"])):
        start, end = part["startOffset"], min(part["endOffset"], length)
        run[start:end] = bytes([part["count"] > 0]) * (end - start)
    return run


def code_lines(source: str) -> dict[int, slice]:
    """Return the lines that hold code, from 1, with their UTF-16 units: without blanks and comments."""
    blanked = COMMENT.sub(lambda comment: re.sub(r"[^\n]", " ", comment[0]), source)
    lines, start = {}, 0
    for number, (line, code) in enumerate(zip(source.split("\n"), blanked.split("\n"), strict=True), 1):
        end = start + _units(line)
        if code.strip():
            lines[number] = slice(start + _units(line[: len(line) - len(line.lstrip())]), end)
        start = end + 1
    return lines


def missed_lines(source: str, runs: list[list[dict[str, Any]]]) -> list[int]:
    """Return the lines of code of which no part ran, in any of the runs."""
    ran = [units_run(functions, _units(source)) for functions in runs]
    return [number for number, units in code_lines(source).items() if not any(any(run[units]) for run in ran)]


def _units(text: str) -> int:
    return len(text.encode("utf-16-le")) // 2


def _ranges(numbers: list[int]) -> str:
    groups = groupby(enumerate(numbers), key=lambda pair: pair[1] - pair[0])
    spans = [[number for _, number in group] for _, group in groups]
    return ", ".join(f"{span[0]}-{span[-1]}" if span[1:] else str(span[0]) for span in spans)


def main(folder: Path) -> int:
    """Print the modules of the page with their lines; return the exit code."""
    from rich.console import Console
    from rich.table import Table

    runs: dict[str, list[list[dict[str, Any]]]] = {}
    for file in folder.glob("*.json"):
        for script in json.loads(file.read_text(encoding="utf-8")):
            path = urlsplit(script["url"]).path.lstrip("/")
            runs.setdefault(path, []).append(script["functions"])
    table = Table(box=None)
    for heading in ("module", "lines", "run", "%"):
        table.add_column(heading, justify="left" if heading == "module" else "right")
    table.add_column("never run")
    lines = missed = 0
    modules = {
        f"{path}{file.relative_to(folder).as_posix()}": file
        for path, folder in FOLDERS.items()
        for file in sorted(folder.rglob("*.js"))
    }
    for name, file in modules.items():
        # as the browser got it: with its own line ends
        source = file.read_bytes().decode("utf-8")
        of_code, never = len(code_lines(source)), missed_lines(source, runs.get(name, []))
        lines, missed = lines + of_code, missed + len(never)
        table.add_row(name, *_counts(of_code, len(never)), _ranges(never))
    table.add_row("all", *_counts(lines, missed))
    Console().print(table)
    return 0 if runs else 1


def _counts(lines: int, missed: int) -> tuple[str, str, str]:
    run = lines - missed
    return str(lines), str(run), f"{100.0 * run / max(lines, 1):.0f}"


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
