"""Writing a picture's file: whole, or not at all."""

from __future__ import annotations

import secrets
import shutil
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from stayput.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Generator, Sequence

PLOT_SUFFIXES = (".png", ".svg", ".pdf")
"""The kinds of file a plot is saved as."""

ANIMATION_SUFFIXES = (".gif", ".mp4", ".html")
"""The kinds of file an animation is written as."""


def check_target(path: str | Path, suffixes: Sequence[str]) -> Path:
    """Return where a file is to be written, or refuse it before any work is done.

    Parameters
    ----------
    path : str or Path
        The file to write.
    suffixes : sequence of str
        The endings that are allowed, with their dot.

    Raises
    ------
    InputError
        An unknown ending, a folder that does not exist, or a folder in the file's place.
    """
    target = Path(path)
    if target.suffix.lower() not in suffixes:
        raise InputError(f"The file to write is {str(target)!r}; its name must end in {', '.join(suffixes)}.")
    if not target.parent.is_dir():
        raise InputError(f"The file to write is {str(target)!r}; its folder must exist.")
    if target.is_dir():
        raise InputError(f"The file to write is {str(target)!r}; it must be a file, and that is a folder.")
    return target


@contextmanager
def draft(target: Path) -> Generator[Path]:
    """Give a temporary path beside ``target`` to write to; it takes the target's place at the end.

    When the writing fails or is interrupted the draft is removed and an older ``target`` stays as it was.

    Raises
    ------
    InputError
        The folder does not let a file be written.
    """
    path = target.with_name(f".{target.stem}-{secrets.token_hex(4)}{target.suffix}")
    try:
        yield path
        path.replace(target)
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise InputError(
            f"The file to write is {str(target)!r}; it could not be written: {reason}."
        ) from error
    finally:
        path.unlink(missing_ok=True)


def check_animation(path: str | Path) -> Path:
    """Return where an animation is to be written, or refuse it before any work is done.

    Raises
    ------
    InputError
        As `check_target`, and no ffmpeg for an MP4.
    """
    target = check_target(path, ANIMATION_SUFFIXES)
    if target.suffix.lower() == ".mp4" and shutil.which("ffmpeg") is None:
        raise InputError(
            f"The file to write is {str(target)!r}; an MP4 needs the program ffmpeg, which is not installed, "
            "so install it or choose .gif or .html."
        )
    return target
