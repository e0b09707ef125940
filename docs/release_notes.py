"""Print one version's part of CHANGELOG.md: ``release_notes.py [VERSION]``, by default the newest release."""

from __future__ import annotations

import re
import sys
from pathlib import Path

CHANGELOG = Path(__file__).parents[1] / "CHANGELOG.md"

# "## [0.2.0]" or "## [0.2.0] - 2026-12-01", as Keep a Changelog writes it
HEADING = re.compile(r"^## \[(?P<version>[^\]]+)\].*$", re.MULTILINE)


def parts(changelog: str) -> dict[str, str]:
    """Return the text under each version's heading, the newest first; "Unreleased" is a version too."""
    headings = list(HEADING.finditer(changelog))
    ends = [heading.start() for heading in headings[1:]] + [len(changelog)]
    return {
        heading["version"]: changelog[heading.end() : end].strip()
        for heading, end in zip(headings, ends, strict=True)
    }


def release_notes(changelog: str, version: str | None = None) -> str:
    """Return what changed in a version.

    Parameters
    ----------
    changelog : str
        Text of the changelog.
    version : str, optional
        Such as "0.2.0" or, as tags are written, "v0.2.0"; "Unreleased" for what is to come. By default the
        newest release.

    Raises
    ------
    LookupError
        The changelog has no such version, or nothing stands under it.
    """
    found = parts(changelog)
    released = [name for name in found if name != "Unreleased"]
    name = version.removeprefix("v") if version else next(iter(released), "")
    if not found.get(name):
        known = ", ".join(found)
        raise LookupError(f"CHANGELOG.md has nothing for version {name!r}; its versions are {known}.")
    return found[name]


def main(arguments: list[str]) -> int:
    """Print the notes; return the exit code."""
    try:
        print(release_notes(CHANGELOG.read_text(encoding="utf-8"), *arguments[:1]))
    except LookupError as error:
        print(error.args[0], file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
