"""Text of a motion in the formats that other programs, and `read_motion`, can read."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.model.parameters import STANDARD_GRAVITY

if TYPE_CHECKING:
    from stayput.motion.record import Motion

_VALUES_A_LINE = 5


def _one_line(text: str) -> str:
    return " ".join(text.split())


def csv_text(motion: Motion) -> str:
    """Return time [s] and the components [m/s²] as columns that hold every bit; missing ones are zero."""
    components = motion.components
    names = ("x",) if list(components) == ["x"] else ("x", "y", "z")
    columns = [components[name].tolist() if name in components else [0.0] * len(motion) for name in names]
    kind = " (synthetic)" if motion.synthetic else ""
    head = [
        f"# {_one_line(motion.name)}{kind}; {_one_line(motion.source)}",
        "# acceleration, unit: m/s²",
        ",".join(("t", *names)),
    ]
    # Twelve digits: more would show the rounding of k·dt, 0.30000000000000004.
    times = [f"{k * motion.dt:.12g}" for k in range(len(motion))]
    rows = (",".join((t, *map(repr, row))) for t, *row in zip(times, *columns, strict=True))
    return "\n".join([*head, *rows, ""])


def at2_text(motion: Motion) -> str:
    """Return x in the PEER AT2 format, in g.

    The first line, which holds any text, has the source.

    Raises
    ------
    InputError
        The motion has more than x: the format holds one component.
    """
    if list(motion.components) != ["x"]:
        raise InputError("motion.at2_one_component", "component", components=", ".join(motion.components))
    values = [f"{a / STANDARD_GRAVITY:.16E}" for a in motion.x.tolist()]
    lines = [" ".join(values[i : i + _VALUES_A_LINE]) for i in range(0, len(values), _VALUES_A_LINE)]
    kind = "SYNTHETIC " if motion.synthetic else ""
    head = [
        f"{kind}ACCELERATION, WRITTEN BY STAYPUT; {_one_line(motion.source)}",
        _one_line(motion.name) or "MOTION",
        "ACCELERATION TIME SERIES IN UNITS OF G",
        f"NPTS= {len(values)}, DT= {motion.dt!r} SEC",
    ]
    return "\n".join([*head, *lines, ""])


FORMATS: dict[str, Callable[[Motion], str]] = {".csv": csv_text, ".at2": at2_text}
"""How a motion is written, by the ending of the file's name."""
