"""The folder of an assessment: which inputs it belongs to, its lock, atomic writes, files of others.

Every file is made as a draft and takes its name when it is complete, but the data base of what is done, which
SQLite keeps whole.
"""

from __future__ import annotations

import hashlib
import itertools
import json
import os
import re
from collections.abc import Generator, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any, cast

import stayput
from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, not_allowed, reason_of

FORMAT = 12
"""Changes with the files' layout or meaning."""

MANIFEST, WORK, LOCK = "manifest.json", "work", ".lock"
DRAFTS, PLAN, OUTCOMES = "drafts", "plan.sqlite", "outcomes.sqlite"

BEGUN = re.compile(r"\.lock|work/(drafts/(draft-\d+)?)?")
"""What an assessment leaves that was killed before its manifest was written."""

OWN = re.compile(
    BEGUN.pattern
    + r"|manifest\.json|report(\.ja)?\.html|(summary|rejects)\.(parquet|csv)"
    + r"|pieces\.(csv|geojson)|pieces/(part-\d{6}\.parquet)?|work/(plan|outcomes)\.sqlite(-journal)?"
)
"""All that an assessment writes, by its path in the folder of the results; folders end in a slash."""

READ = re.compile(r"pieces/(.*/)?[^.][^/]*/?")
"""What would be read as ours."""


class Workspace:
    """Makes files by way of drafts; drafts of killed processes are removed.

    Parameters
    ----------
    folder : Path
        The work folder; it must be there.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        (folder / DRAFTS).mkdir(exist_ok=True)
        for leftover in (folder / DRAFTS).iterdir():
            if re.fullmatch(r"draft-\d+", leftover.name):
                leftover.unlink()
        self._numbers = itertools.count()

    @contextmanager
    def draft(self, path: Path) -> Generator[Path]:
        """Yield a path to make a file at, which takes its name once on disk, or is removed if it fails."""
        draft = self.folder / DRAFTS / f"draft-{next(self._numbers)}"
        try:
            yield draft
            with draft.open("rb+") as file:
                os.fsync(file.fileno())
            draft.replace(path)
        finally:
            draft.unlink(missing_ok=True)
        if os.name == "posix":  # the folder's names too
            descriptor = os.open(path.parent, os.O_RDONLY)
            try:
                os.fsync(descriptor)
            finally:
                os.close(descriptor)

    @contextmanager
    def durable(self, path: Path) -> Generator[IO[bytes]]:
        """Yield a file to write; once complete and on disk it takes its name, else it is removed."""
        with self.draft(path) as draft, draft.open("xb") as file:
            yield file

    def write_json(self, path: Path, content: Mapping[str, Any]) -> None:
        """Write a mapping as JSON, atomically."""
        with self.durable(path) as file:
            file.write((json.dumps(content, indent=2, sort_keys=True) + "\n").encode())


def digest_of(path: Path) -> str:
    """Return the SHA-256 of a file."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def called(name: str) -> Phrase:
    """Return what sentences call an input, such as "shake map"."""
    return phrase(f"inventory.input_{name.replace(' ', '_')}")


def unreadable(path: Path, error: Exception) -> InputError:
    """Return the refusal of an input that the system does not let be read."""
    return InputError("common.unreadable", file=path, reason=reason_of(error))


def input_digest(name: str, path: Path) -> str:
    """Return the SHA-256 of an input.

    Raises
    ------
    InputError
        No file, or one that cannot be read.
    """
    try:
        if path.is_file() or not path.exists():
            return digest_of(path)
    except (OSError, ValueError) as error:  # a name with a zero byte or half a surrogate pair is a ValueError
        raise unreadable(path, error) from None
    what = phrase("inventory.the", what=called(name))  # a pipe would be read but once, a device for ever
    raise not_allowed(what, path, "inventory.not_a_file")


@contextmanager
def claimed(folder: Path, inputs: Mapping[str, Any]) -> Generator[Workspace]:
    """Create the folder with its parents, or open it again, and lock it against other processes.

    What the assessment is of stands in the manifest.

    Parameters
    ----------
    folder : Path
        Where results go.
    inputs : mapping
        What the results depend on, each under what a sentence calls it.

    Raises
    ------
    InputError
        It holds something else, an assessment of other inputs, or another process is at work in it.
    """
    for path in (folder, *folder.parents):
        if path.exists() and not path.is_dir():
            raise InputError("common.folder_is_file", "out", folder=folder, path=path)
    folder.mkdir(parents=True, exist_ok=True)
    _refuse_others(folder)  # before the lock, which would be a file in somebody else's folder
    inputs_of(folder)
    with _locked(folder):
        wanted = {"format": FORMAT, "version of stayput": stayput.__version__, **inputs}
        before = inputs_of(folder)
        if before is not None and before != wanted and _holds_results(folder):
            other = next((name for name in wanted if before.get(name) != wanted[name]), "list of inputs")
            other = called(other)
            raise InputError("inventory.other_assessment", "out", folder=folder, other=other)
        (folder / WORK).mkdir(exist_ok=True)
        space = Workspace(folder / WORK)
        if before != wanted:
            space.write_json(folder / MANIFEST, {"inputs": wanted})
        yield space


def check_parts(folder: Path, names: set[str]) -> None:
    """Refuse parts of results that are not among those of the plan: they would be read as results."""
    if folder.is_dir():
        for path in sorted(folder.glob("*.parquet")):
            if path.name not in names:
                raise _in_the_way(folder, path.name)


def inputs_of(folder: Path) -> dict[str, Any] | None:
    """Return the inputs of the assessment in the folder, or None where the folder is new."""
    try:
        content: Any = json.loads((folder / MANIFEST).read_bytes())
    except FileNotFoundError:
        return None
    except (ValueError, RecursionError):
        content = None
    inputs = cast("dict[str, Any]", content).get("inputs") if isinstance(content, dict) else None
    if isinstance(inputs, dict):
        return cast("dict[str, Any]", inputs)
    raise InputError("inventory.strangers", "out", folder=folder, name=repr(MANIFEST))


def entries(folder: Path, below: str = "") -> Iterator[str]:
    """Give the paths of all that lies in a folder, from it: folders end in a slash, links in "@".

    Only folders of the assessment are looked into; a folder comes before what lies in it.
    """
    for entry in sorted(os.scandir(folder / below), key=lambda entry: entry.name):
        path = below + entry.name
        if entry.is_symlink():
            yield f"{path}@"
        elif entry.is_dir():
            yield f"{path}/"
            if OWN.fullmatch(f"{path}/"):
                yield from entries(folder, f"{path}/")
        else:
            yield path


def _refuse_others(folder: Path) -> None:
    """Refuse a folder of others, and what has the name of one of our files or would be read as one.

    A folder without a manifest may hold what a killed assessment leaves; files that somebody put beside the
    results are left alone.
    """
    new = not (folder / MANIFEST).exists()
    for entry in entries(folder):
        name = entry.rstrip("/@")
        if new and (not BEGUN.fullmatch(entry) or (entry == LOCK and (folder / LOCK).stat().st_size)):
            raise InputError("inventory.strangers", "out", folder=folder, name=repr(name))
        ours = OWN.fullmatch(name) or OWN.fullmatch(f"{name}/") or READ.fullmatch(entry)
        if ours and not OWN.fullmatch(entry):
            raise _in_the_way(folder, entry)


def _in_the_way(folder: Path, entry: str) -> InputError:
    """Return the refusal of something that lies where the assessment writes or reads."""
    name = repr(entry.rstrip("@"))
    return InputError("inventory.in_the_way", "out", folder=folder, name=name)


def _holds_results(folder: Path) -> bool:
    """Return whether there are results of the inputs: there are none where the table was refused."""
    return any(
        (folder / name).exists() for name in (f"{WORK}/{PLAN}", f"{WORK}/{OUTCOMES}", "pieces", "report.html")
    )


@contextmanager
def _locked(folder: Path) -> Generator[None]:
    """Lock the folder against other processes; the system releases the lock when this one ends."""
    try:
        import fcntl
    except ImportError:  # pragma: no cover - not on this system
        yield
        return
    with (folder / LOCK).open("ab") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise InputError("inventory.at_work", "out", folder=folder) from None
        yield
