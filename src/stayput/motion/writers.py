"""Text of a motion in the formats that other programs, and `read_motion`, can read."""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.model.parameters import STANDARD_GRAVITY

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    import numpy as np
    from numpy.typing import NDArray

_VALUES_A_LINE = 5


def _one_line(text: str) -> str:
    return " ".join(text.split())


def csv_text(
    dt: float, components: Mapping[str, NDArray[np.float64]], name: str, source: str, synthetic: bool
) -> str:
    """Return time [s] and the components [m/s²] as columns that hold every bit; missing ones are zero.

    Parameters
    ----------
    dt : float
        Time step [s].
    components : mapping of str to ndarray, shape (n,)
        Accelerations [m/s²]: x, and y and z where there are such.
    name, source : str
        What stands above the columns.
    synthetic : bool
        Whether the motion was computed, not recorded.
    """
    names = ("x",) if list(components) == ["x"] else ("x", "y", "z")
    n = len(components["x"])
    columns = [components[name].tolist() if name in components else [0.0] * n for name in names]
    kind = " (synthetic)" if synthetic else ""
    head = [
        f"# {_one_line(name)}{kind}; {_one_line(source)}",
        "# acceleration, unit: m/s²",
        ",".join(("t", *names)),
    ]
    # Twelve digits: more would show the rounding of k·dt, 0.30000000000000004.
    times = [f"{k * dt:.12g}" for k in range(n)]
    rows = (",".join((t, *map(repr, row))) for t, *row in zip(times, *columns, strict=True))
    return "\n".join([*head, *rows, ""])


def at2_text(
    dt: float, components: Mapping[str, NDArray[np.float64]], name: str, source: str, synthetic: bool
) -> str:
    """Return x in the PEER AT2 format, in g; arguments as for `csv_text`.

    The first line, which holds any text, has the source.

    Raises
    ------
    InputError
        The motion has more than x: the format holds one component.
    """
    if list(components) != ["x"]:
        raise InputError("motion.at2_one_component", "component", components=", ".join(components))
    values = [f"{a / STANDARD_GRAVITY:.16E}" for a in components["x"].tolist()]
    lines = [" ".join(values[i : i + _VALUES_A_LINE]) for i in range(0, len(values), _VALUES_A_LINE)]
    head = [
        f"{'SYNTHETIC ' if synthetic else ''}ACCELERATION, WRITTEN BY STAYPUT; {_one_line(source)}",
        _one_line(name) or "MOTION",
        "ACCELERATION TIME SERIES IN UNITS OF G",
        f"NPTS= {len(values)}, DT= {dt!r} SEC",
    ]
    return "\n".join([*head, *lines, ""])


FORMATS: dict[str, Callable[[float, Mapping[str, NDArray[np.float64]], str, str, bool], str]] = {
    ".csv": csv_text,
    ".at2": at2_text,
}
"""How a motion is written, by the ending of the file's name."""
