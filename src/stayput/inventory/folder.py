"""The folder of an assessment: whose it is, who works in it, and files that are whole or not there."""

from __future__ import annotations

import hashlib
import json
import os
import secrets
import shutil
from contextlib import contextmanager
from typing import IO, TYPE_CHECKING, Any, cast

import stayput
from stayput.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Generator, Mapping
    from pathlib import Path

FORMAT = 2
"""Changes with the files' layout or meaning."""

MANIFEST = "manifest.json"
WORK = "work"


def digest_of(path: Path) -> str:
    """Return the SHA-256 of a file."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


@contextmanager
def durable(path: Path) -> Generator[IO[bytes]]:
    """Give a file to write; whole and on the disk it takes its name, else it is removed.

    A process that is killed may leave one behind whose name begins with a dot: `sweep` removes it.
    """
    draft = path.with_name(f".{path.name}-{secrets.token_hex(4)}")
    try:
        with draft.open("wb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        draft.replace(path)
        sync_folder(path.parent)
    finally:
        draft.unlink(missing_ok=True)


def sync_folder(folder: Path) -> None:
    """Bring a folder's names to the disk, where the system can."""
    if os.name != "posix":
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def write_json(path: Path, content: Mapping[str, Any]) -> None:
    """Write a mapping as JSON, whole or not at all."""
    with durable(path) as file:
        file.write((json.dumps(content, indent=2, sort_keys=True) + "\n").encode())


def read_json(path: Path) -> dict[str, Any] | None:
    """Return what a JSON file says, or None where it is not there or not whole."""
    try:
        found: Any = json.loads(path.read_bytes())
    except (OSError, ValueError):
        return None
    return cast("dict[str, Any]", found) if isinstance(found, dict) else None


def sweep(folder: Path) -> None:
    """Remove what killed processes left of files that they had begun."""
    for path in sorted(folder.rglob(".*-????????")):
        if path.is_dir():
            shutil.rmtree(path)
        else:
            path.unlink(missing_ok=True)


@contextmanager
def claimed(folder: Path, inputs: Mapping[str, Any]) -> Generator[Path]:
    """Make the folder, with those that it lies in, or take it up again; nobody else works in it meanwhile.

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
            raise InputError(
                f"The folder is {str(folder)!r}; it must be a folder, and {str(path)!r} is a file."
            )
    folder.mkdir(parents=True, exist_ok=True)
    with _locked(folder):
        asked = {"format": FORMAT, "version of stayput": stayput.__version__, **inputs}
        path = folder / MANIFEST
        found = read_json(path)
        if found is None:
            strange = [one.name for one in folder.iterdir() if not one.name.startswith(".")]
            if strange:
                told = f"holds {strange[0]!r} and no assessment"
                raise InputError(f"The folder {str(folder)!r} {told}; it must be empty or new.")
            write_json(path, {"inputs": asked})
        elif (before := found.get("inputs")) != asked:
            told = cast("dict[str, Any]", before) if isinstance(before, dict) else {}
            other = next((name for name in asked if told.get(name) != asked[name]), "list of inputs")
            raise InputError(
                f"The folder {str(folder)!r} holds an assessment of another {other}; "
                "give the same one, or another folder."
            )
        (folder / WORK).mkdir(exist_ok=True)
        sweep(folder)
        yield folder / WORK


@contextmanager
def _locked(folder: Path) -> Generator[None]:
    """Keep other processes out; the system gives the lock back when this one ends, however it ends."""
    try:
        import fcntl
    except ImportError:  # pragma: no cover - not on this system
        yield
        return
    with (folder / ".lock").open("ab") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise InputError(f"Another command is at work in {str(folder)!r}; wait until it ends.") from None
        yield
