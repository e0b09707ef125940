"""The folder of an assessment: which inputs it belongs to, its lock, and foreign files in it."""

from __future__ import annotations

import hashlib
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, cast

import stayput
from stayput.catalogue import phrase
from stayput.errors import InputError
from stayput.inventory.workspace import (
    BEGUN,
    OUTCOMES,
    OWN,
    Workspace,
    entries,
    in_the_way,
    read_json,
)

if TYPE_CHECKING:
    from collections.abc import Generator, Mapping
    from pathlib import Path

FORMAT = 8
"""Changes with the files' layout or meaning."""

MANIFEST, CLAIM = "manifest.json", "claim.json"
WORK, LOCK = "work", ".lock"


def digest_of(path: Path) -> str:
    """Return the SHA-256 of a file."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


@contextmanager
def claimed(folder: Path, inputs: Mapping[str, Any]) -> Generator[Workspace]:
    """Create the folder with its parents, or open it again, and lock it against other processes.

    What the assessment is of stands in the manifest and, once more, in the work folder: where one of the
    two is damaged or gone the other holds.

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
                "inventory.folder_is_file", "out", folder=repr(str(folder)), path=repr(str(path))
            )
    folder.mkdir(parents=True, exist_ok=True)
    _refuse_strangers(folder)  # before the lock, which would be a file in somebody else's folder
    _inputs_before(folder)
    with _locked(folder):
        _refuse_strangers(folder)
        _refuse_what_is_in_the_way(folder)
        wanted = {"format": FORMAT, "version of stayput": stayput.__version__, **inputs}
        before = _inputs_before(folder)
        if before is not None and before != wanted and _holds_results(folder):
            other = next((name for name in wanted if before.get(name) != wanted[name]), "list of inputs")
            other = phrase(f"inventory.input_{other.replace(' ', '_')}")
            raise InputError("inventory.other_assessment", "out", folder=repr(str(folder)), other=other)
        (folder / WORK).mkdir(exist_ok=True)
        space = Workspace(folder / WORK)
        for path in (folder / WORK / CLAIM, folder / MANIFEST):
            claim = read_json(path)
            if claim is None or claim.get("inputs") != wanted:
                space.write_json(path, {"inputs": wanted})
        yield space


def check_parts(folder: Path, names: set[str]) -> None:
    """Refuse parts of results that are not among those of the plan: they would be read as results."""
    if folder.is_dir():
        for path in sorted(folder.glob("*.parquet")):
            if path.name not in names:
                raise in_the_way(folder, path.name)


def _refuse_strangers(folder: Path) -> None:
    """Refuse a folder that holds foreign files and no assessment; remains of a killed one are accepted."""
    if (folder / MANIFEST).exists() or (folder / WORK / CLAIM).exists():
        return
    present = list(entries(folder, OWN))
    for entry in present:
        if not BEGUN.fullmatch(entry) or (entry == LOCK and (folder / LOCK).stat().st_size):
            name = entry.rstrip("/@")
            raise InputError("inventory.strangers", "out", folder=repr(str(folder)), name=repr(name))


def _refuse_what_is_in_the_way(folder: Path) -> None:
    """Refuse entries that have the name of one of our files but another kind, or would be read as ours.

    Files that somebody put beside the results are left alone.
    """
    for entry in entries(folder, OWN):
        name = entry.rstrip("/@")
        read = entry.startswith((f"{WORK}/plan/", "pieces/")) and not name.rpartition("/")[2].startswith(".")
        if not OWN.fullmatch(entry) and (read or OWN.fullmatch(name) or OWN.fullmatch(f"{name}/")):
            raise in_the_way(folder, entry)


def _inputs_before(folder: Path) -> dict[str, Any] | None:
    """Return the inputs of the assessment in the folder, or None where the folder is new."""
    for claim in (read_json(folder / MANIFEST), read_json(folder / WORK / CLAIM)):
        if claim is not None and isinstance(inputs := claim.get("inputs"), dict):
            return cast("dict[str, Any]", inputs)
    if (folder / MANIFEST).exists():
        raise InputError("inventory.damaged_manifest", "out", folder=repr(str(folder)), manifest=MANIFEST)
    return None


def _holds_results(folder: Path) -> bool:
    """Return whether there are results of the inputs: there are none where the table was refused."""
    return not (folder / WORK / CLAIM).exists() or any(
        (folder / name).exists() for name in (f"{WORK}/plan", f"{WORK}/{OUTCOMES}", "pieces", "report.html")
    )


@contextmanager
def _locked(folder: Path) -> Generator[None]:
    """Lock the folder against other processes; the system releases the lock when this one ends."""
    try:
        import fcntl
    except ImportError:  # pragma: no cover - not on this system
        yield
        return
    if (folder / LOCK).is_symlink():
        raise in_the_way(folder, f"{LOCK}@")
    with (folder / LOCK).open("ab") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise InputError("inventory.at_work", "out", folder=repr(str(folder))) from None
        yield
