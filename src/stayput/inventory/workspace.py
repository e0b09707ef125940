"""The work folder of an assessment: atomic file writes, and no foreign file touched.

Every file or folder is made as a draft and takes its name when it is complete, but the data base of what is
done, which SQLite keeps whole.
"""

from __future__ import annotations

import itertools
import json
import os
import re
from contextlib import contextmanager
from typing import IO, TYPE_CHECKING, Any, cast

from stayput.catalogue import phrase
from stayput.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Generator, Iterator, Mapping
    from pathlib import Path

DRAFTS, OUTCOMES = "drafts", "outcomes.sqlite"

PLAN = re.compile(r"plan\.sqlite(-journal)?|rejects\.(parquet|csv)|rows/(part-\d{6}\.parquet)?")
"""What a plan consists of: paths in its folder, of which folders end in a slash."""

BEGUN = re.compile(r"\.lock|work/(claim\.json|drafts/(draft-\d+)?)?")
"""What an assessment leaves that was killed before its manifest was written."""

OWN = re.compile(
    BEGUN.pattern
    + r"|manifest\.json|report(\.ja)?\.html|(summary|rejects)\.(parquet|csv)"
    + r"|pieces\.(csv|geojson)|pieces/(part-\d{6}\.parquet)?"
    + rf"|work/(plan|drafts/draft-\d+)/({PLAN.pattern})?"
    + r"|work/outcomes\.sqlite(-journal)?"
)
"""All that an assessment writes, by its path in the folder of the results."""


class Workspace:
    """Makes files by way of drafts; drafts of killed processes are removed.

    Parameters
    ----------
    folder : Path
        The work folder; it must be there.

    Raises
    ------
    InputError
        A draft that is left holds somebody else's file.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        drafts = folder / DRAFTS
        drafts.mkdir(exist_ok=True)
        for leftover in sorted(drafts.iterdir()):
            if re.fullmatch(r"draft-\d+", leftover.name):
                remove(leftover)
        self._numbers = itertools.count()

    def draft(self) -> Path:
        """Return the path of a new draft, which does not exist yet."""
        return self.folder / DRAFTS / f"draft-{next(self._numbers)}"

    @contextmanager
    def durable(self, path: Path) -> Generator[IO[bytes]]:
        """Yield a file to write; once complete and on disk it takes its name, else it is removed."""
        draft = self.draft()
        try:
            with draft.open("xb") as file:
                yield file
                file.flush()
                os.fsync(file.fileno())
            draft.replace(path)
            sync_folder(path.parent)
        finally:
            draft.unlink(missing_ok=True)

    def publish(self, draft: Path, path: Path) -> None:
        """Bring a draft that a library has written to the disk, and give it its name."""
        with draft.open("rb+") as file:
            os.fsync(file.fileno())
        draft.replace(path)
        sync_folder(path.parent)

    def write_json(self, path: Path, content: Mapping[str, Any]) -> None:
        """Write a mapping as JSON, atomically."""
        with self.durable(path) as file:
            file.write((json.dumps(content, indent=2, sort_keys=True) + "\n").encode())


def sync_folder(folder: Path) -> None:
    """Bring a folder's names to the disk, where the system can."""
    if os.name != "posix":
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def read_json(path: Path) -> dict[str, Any] | None:
    """Return the object of a JSON file, or None where it is missing or incomplete."""
    try:
        content: Any = json.loads(path.read_bytes())
    except (FileNotFoundError, ValueError, RecursionError):
        return None
    return cast("dict[str, Any]", content) if isinstance(content, dict) else None


def entries(folder: Path, own: re.Pattern[str], below: str = "") -> Iterator[str]:
    """Give the paths of all that lies in a folder, from it: folders end in a slash, links in "@".

    Only folders that match ``own`` are looked into; a folder comes before what lies in it.
    """
    for entry in sorted(os.scandir(folder / below), key=lambda entry: entry.name):
        path = below + entry.name
        if entry.is_symlink():
            yield f"{path}@"
        elif entry.is_dir():
            yield f"{path}/"
            if own.fullmatch(f"{path}/"):
                yield from entries(folder, own, f"{path}/")
        else:
            yield path


def remove(path: Path) -> None:
    """Remove a draft or a plan: a file, or a folder with what a plan consists of; a link is left alone.

    Raises
    ------
    InputError
        The folder holds something else: nothing is removed.
    """
    if path.is_symlink():
        return
    if not path.is_dir():
        path.unlink(missing_ok=True)
        return
    contents = list(entries(path, PLAN))
    for entry in contents:
        if not PLAN.fullmatch(entry):
            raise in_the_way(path, entry)
    for entry in reversed(contents):
        if entry.endswith("/"):
            (path / entry).rmdir()
        else:
            (path / entry).unlink()
    path.rmdir()


def in_the_way(folder: Path, entry: str) -> InputError:
    """Return the refusal of something that lies where the assessment writes or reads."""
    kind = phrase(f"inventory.kind_{ {'/': 'folder', '@': 'link'}.get(entry[-1], 'file') }")
    name = repr(entry.rstrip("/@"))
    return InputError("inventory.in_the_way", "out", folder=repr(str(folder)), kind=kind, name=name)
