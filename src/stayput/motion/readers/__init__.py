"""Readers of strong-motion files, one format a file; a file is recognised by its content.

A reader is a module with ``FORMAT`` (its name), ``recognise(text)`` and ``read(text, unit, dt)``, which
returns the file's channels in m/s². To add a format, write such a module and list it in `READERS`.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from stayput.errors import InputError, within
from stayput.motion.channels import motion_of_channels
from stayput.motion.readers import columns, cosmos, csmip, esm, jma, knet, knet_csv, peer
from stayput.motion.readers.text import check_end, file_text
from stayput.motion.samples import STEP_RANGE
from stayput.motion.units import unit_factor

if TYPE_CHECKING:
    import os

    from stayput.motion.channels import Channel
    from stayput.motion.record import Motion


class Reader(Protocol):
    """What a reader's module has."""

    @property
    def FORMAT(self) -> str:  # noqa: N802
        """Name of the format."""
        ...

    def recognise(self, text: str) -> bool:
        """Return whether the text is of this format."""
        ...

    def read(self, text: str, unit: str | None, dt: float | None) -> list[Channel]:
        """Return the channels; ``unit`` and ``dt`` are the caller's, for files that do not state theirs."""
        ...


_HEAD = 1000
"""A file that calls itself synthetic in so many of its first characters stays labelled so."""

READERS: tuple[Reader, ...] = (peer, jma, knet, knet_csv, esm, csmip, cosmos, columns)
"""The readers, in the order in which they look at a file; columns of bare numbers come last."""


def read_motion(
    path: str | os.PathLike[str],
    component: str | None = None,
    unit: str | None = None,
    *,
    dt: float | None = None,
) -> Motion:
    """Read a record in any of the formats of `READERS`, recognised by its content.

    Nothing is guessed and nothing is corrected: samples are as in the file, in m/s². Only a K-NET record
    has its offset taken off, as its own header's peak does, and a channel that points down is turned up.

    Parameters
    ----------
    path : str or path
        The file.
    component : str, optional
        Channel that becomes x: its direction ("NS", "EW", "360", "HNE", ...) or its place in the file
        ("channel 2"); default the first horizontal one. The other horizontal one becomes y and the
        vertical one z. PEER and K-NET files hold one channel each: see `Motion.combine`.
    unit : str, optional
        Unit of the numbers ("m/s²", "cm/s²", "gal", "mm/s²", "g"): required where the file does not
        state it, and refused where it contradicts the file.
    dt : float, optional
        Time step [s]: likewise.

    Raises
    ------
    InputError
        The file cannot be read, is damaged or contradicts itself, or lacks its unit or time step.
    """
    if unit is not None:
        unit_factor(unit)
    if dt is not None:
        within("dt", dt, *STEP_RANGE, "s")
    text = file_text(path)
    reader = next((reader for reader in READERS if reader.recognise(text)), None)
    if reader is None:
        formats = ", ".join(r.FORMAT for r in READERS)
        raise InputError(f"The motion file {str(path)!r} is in no known format; it must be one of {formats}.")
    try:
        check_end(text)
        channels = reader.read(text, unit, dt)
        motion = motion_of_channels(channels, component, reader.FORMAT, name=Path(path).stem)
    except InputError as error:
        raise InputError(f"{Path(path).name} ({reader.FORMAT}): {error}") from None
    return replace(motion, synthetic="synthetic" in text[:_HEAD].lower())
