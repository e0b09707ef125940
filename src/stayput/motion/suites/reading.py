"""A user's own suite: a folder or a list of records."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.motion.readers import read_motion
from stayput.motion.suites.suite import Suite

if TYPE_CHECKING:
    from collections.abc import Iterable

    from stayput.motion.record import Motion

PASSED_OVER = (".md",)
"""Endings of files of a folder that are not records."""


def read_suite(
    source: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    component: str | None = None,
    unit: str | None = None,
    *,
    dt: float | None = None,
    name: str | None = None,
) -> Suite:
    """Read a suite of records, in all the formats of `read_motion`.

    Each file is one motion; files that hold one component each are motions of one component (see
    `Motion.combine`). Nothing is scaled: see `Suite.to_intensity`, `Suite.to_spectrum` and `Suite.selected`.

    Parameters
    ----------
    source : path, or iterable of paths
        A folder, whose files are taken in the order of their names, all but hidden ones and Markdown; or
        the files themselves, in this order.
    component, unit, dt
        As for `read_motion`, for every file.
    name : str, optional
        Default: the folder's name.

    Raises
    ------
    InputError
        No folder, no files in it, or a file that cannot be read: its name is in the sentence.
    """
    if isinstance(source, str | os.PathLike):
        folder = Path(source)
        if not folder.is_dir():
            raise InputError(
                f"The suite {str(folder)!r} is no folder; it must be a folder or a list of files."
            )
        files = [
            file
            for file in sorted(folder.iterdir())
            if file.is_file() and not file.name.startswith(".") and file.suffix.lower() not in PASSED_OVER
        ]
        title = folder.resolve().name
    else:
        files, title = [Path(file) for file in source], "records"
    if not files:
        raise InputError(f"The suite {title!r} has no files; it must have at least one record.")
    motions = [_read(file, component, unit, dt) for file in files]
    return Suite(tuple(motions), title if name is None else name)


def _read(file: Path, component: str | None, unit: str | None, dt: float | None) -> Motion:
    try:
        return read_motion(file, component, unit, dt=dt)
    except InputError as error:
        told = str(error)
        raise InputError(told if file.name in told else f"{file.name}: {told}") from None
