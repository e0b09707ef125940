"""Writing a motion to a file that other programs, and `read_motion`, can read."""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.files import check_target, draft
from stayput.motion.units import STANDARD_GRAVITY

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from stayput.motion.record import Motion

_VALUES_A_LINE = 5


def _one_line(text: str) -> str:
    return " ".join(text.split())


def csv_text(motion: Motion) -> str:
    """Return time [s] and the components [m/s²] as columns that hold every bit; missing ones are zero."""
    names = ("x",) if motion.components.keys() == {"x"} else ("x", "y", "z")
    zeros = [0.0] * len(motion)
    columns = [motion.components[name].tolist() if name in motion.components else zeros for name in names]
    synthetic = " (synthetic)" if motion.synthetic else ""
    head = [
        f"# {_one_line(motion.name)}{synthetic}; {_one_line(motion.source)}",
        "# acceleration, unit: m/s²",
        ",".join(("t", *names)),
    ]
    digits = [f"{k * motion.dt:.12g}" for k in range(len(motion))]
    rows = (",".join((t, *map(repr, row))) for t, *row in zip(digits, *columns, strict=True))
    return "\n".join([*head, *rows, ""])


def at2_text(motion: Motion) -> str:
    """Return x in the PEER AT2 format, in g.

    Raises
    ------
    InputError
        The motion has more than x: the format holds one component.
    """
    if motion.components.keys() != {"x"}:
        raise InputError(
            f"The motion has {', '.join(motion.components)} and an AT2 file holds one component; "
            "it must be picked first."
        )
    values = [f"{a / STANDARD_GRAVITY:.16E}" for a in motion.x.tolist()]
    lines = [" ".join(values[i : i + _VALUES_A_LINE]) for i in range(0, len(values), _VALUES_A_LINE)]
    synthetic = "SYNTHETIC " if motion.synthetic else ""
    head = [
        f"{synthetic}ACCELERATION, WRITTEN BY STAYPUT",
        _one_line(motion.name) or "MOTION",
        "ACCELERATION TIME SERIES IN UNITS OF G",
        f"NPTS= {len(motion)}, DT= {motion.dt!r} SEC",
    ]
    return "\n".join([*head, *lines, ""])


FORMATS: dict[str, Callable[[Motion], str]] = {".csv": csv_text, ".at2": at2_text}
"""How a motion is written, by the ending of the file's name."""


def write_motion(motion: Motion, path: str | Path) -> Path:
    """Write a motion to a file: columns (.csv, all components) or PEER AT2 (.at2, x alone).

    Parameters
    ----------
    motion : Motion
        The motion.
    path : str or Path
        The file; its ending says the format.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    InputError
        An unknown ending, a folder that does not exist, or several components for AT2.
    """
    target = check_target(path, tuple(FORMATS))
    text = FORMATS[target.suffix.lower()](motion)
    with draft(target) as unfinished:
        unfinished.write_text(text, encoding="utf-8")
    return target
