"""From the channels of a file to the components of a motion."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.errors import InputError
from stayput.motion.record import Motion

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from numpy.typing import NDArray

_VERTICAL = re.compile(r"UD\d?|UPDOWN|UP|[A-Z]{0,2}Z|V|VER|VERT|VERTICAL")
_DOWN = re.compile(r"DOWN|DWN|DN")
_DIRECTIONS = {"N": "0", "NS": "0", "NORTH": "0", "360": "0", "E": "90", "EW": "90", "EAST": "90"}
_UPWARDS = {"UD", "UP", "Z", "V", "VER", "VERT", "VERTICAL", "UPDOWN"}
_PEAK_TOLERANCE = 0.01
_PEAK_ROUNDING = 1e-5  # m/s², a header's last digit


@dataclass(frozen=True, slots=True)
class Channel:
    """One channel of a file.

    Parameters
    ----------
    label : str
        Direction as the file writes it: "N-S", "90 DEG", "UP", "HNE", ...; "" where it does not.
    acceleration : ndarray, shape (n,)
        Acceleration [m/s²].
    dt : float
        Time step [s].
    name : str
        Event and station as the file writes them.
    peak : float, optional
        Largest magnitude as the file's header states it [m/s²].
    note : str
        What else the motion's ``source`` should say.
    """

    label: str
    acceleration: NDArray[np.float64]
    dt: float
    name: str = ""
    peak: float | None = None
    note: str = ""


def plain_label(label: str) -> str:
    """Return a direction in one spelling: "N-S" → "NS", "090 deg" → "90", "Up" → "UP"."""
    plain = re.sub(r"[^A-Z0-9]", "", label.upper().removesuffix("."))
    plain = plain.removesuffix("DEGREES").removesuffix("DEG")
    return str(int(plain)) if re.fullmatch(r"[0-9]{1,6}", plain) else plain


def is_vertical(label: str) -> bool:
    """Return whether a direction is the vertical one, up or down."""
    plain = plain_label(label)
    return bool(_VERTICAL.fullmatch(plain) or _DOWN.fullmatch(plain))


def _meanings(label: str) -> set[str]:
    plain = plain_label(label)
    seed = re.fullmatch(r"[A-Z][HLGN][NEZ]", plain)  # band, instrument, direction
    code = plain[-1] if seed else plain
    if code in _UPWARDS:
        return {plain, code, "up"}
    return {plain, code, _DIRECTIONS.get(code, code)}


def check_peak(channel: Channel) -> None:
    """Raise `InputError` when a channel's samples contradict the peak in its header by more than 1 %."""
    if channel.peak is None or not math.isfinite(channel.peak) or channel.peak == 0.0:
        return
    found, stated = float(np.abs(channel.acceleration).max()), abs(channel.peak)
    if abs(found - stated) > _PEAK_TOLERANCE * stated + _PEAK_ROUNDING:
        raise InputError(
            f"The header's peak acceleration is {stated:g} m/s² and the samples' is {found:g} m/s²; "
            f"they must agree within 1 %, so the file is damaged."
        )


def common_length(lengths: Mapping[str, int]) -> tuple[int, str]:
    """Return the shortest of lengths that differ by at most 1 %, and a note that says what was cut."""
    shortest, longest = min(lengths.values()), max(lengths.values())
    if longest - shortest > 0.01 * longest:
        listing = ", ".join(f"{name} {length}" for name, length in lengths.items())
        raise InputError(f"The components have {listing} samples; their lengths must agree within 1 %.")
    cut = ", ".join(f"{name} from {length}" for name, length in lengths.items() if length > shortest)
    return shortest, f"; cut to {shortest} samples: {cut}" if cut else ""


def _chosen(channels: Sequence[Channel], component: str) -> int:
    wanted = str(component).strip()
    position = re.fullmatch(r"(?:ch|chan|channel)\s*([0-9]{1,4})", wanted.lower())
    if position:
        matches = [int(position[1]) - 1] if 1 <= int(position[1]) <= len(channels) else []
    else:
        matches = [
            i for i, c in enumerate(channels) if c.label and plain_label(c.label) == plain_label(wanted)
        ]
        matches = matches or [
            i for i, c in enumerate(channels) if c.label and _meanings(c.label) & _meanings(wanted)
        ]
    if len(matches) == 1:
        return matches[0]
    listing = ", ".join(f"{c.label or '(unnamed)'} (channel {i + 1})" for i, c in enumerate(channels))
    what = "more than one channel" if matches else "no channel"
    raise InputError(f"The component {component!r} is {what} of the file; it must be one of {listing}.")


def _arranged(channels: Sequence[Channel], component: str | None) -> dict[str, Channel]:
    vertical = [i for i, c in enumerate(channels) if is_vertical(c.label)]
    level = [i for i in range(len(channels)) if i not in vertical]
    if component is not None:
        x = _chosen(channels, component)
    elif len(level) > 2 or len(vertical) > 1:
        labels = ", ".join(f"{c.label or '(unnamed)'} (channel {i + 1})" for i, c in enumerate(channels))
        raise InputError(f"The file has {len(channels)} channels; component must name one of {labels}.")
    else:
        x = (level or vertical)[0]
    found = {"x": channels[x]}
    if x in level and len(level) <= 2 and len(vertical) <= 1:
        others = {"y": [i for i in level if i != x], "z": vertical}
        found |= {name: channels[places[0]] for name, places in others.items() if places}
    return found


def motion_of_channels(
    channels: Sequence[Channel], component: str | None, source: str, name: str = ""
) -> Motion:
    """Make a motion of a file's channels.

    The chosen channel becomes x, the other horizontal one y, the vertical one z, up. A file of more than
    two horizontal channels or one vertical one (a building's array) gives only the chosen channel.

    Parameters
    ----------
    channels : sequence of Channel
        All channels of the file.
    component : str, optional
        Direction or number ("channel 2") of the one that becomes x; default the first horizontal one.
    source : str
        The file's format.
    name : str
        Used when the file names neither event nor station.

    Raises
    ------
    InputError
        No such channel or more than one, different time steps or lengths, a peak unlike the header's.
    """
    for channel in channels:
        check_peak(channel)
    found = _arranged(channels, component)
    first = found["x"]
    for key, channel in found.items():
        if not math.isclose(channel.dt, first.dt, rel_tol=1e-6):
            raise InputError(
                f"The channels' dt are {first.dt:g} s and {channel.dt:g} s; they must be the same."
            )
        if _DOWN.fullmatch(plain_label(channel.label)):
            turned = replace(
                channel, acceleration=-channel.acceleration, note=f"{channel.note}, sign changed to up"
            )
            found[key] = turned
    length, cut = common_length({key: len(channel.acceleration) for key, channel in found.items()})
    roles = ", ".join(f"{key} = {c.label or 'unnamed'}{c.note}" for key, c in found.items())
    arrays: dict[str, Any] = {key: channel.acceleration[:length] for key, channel in found.items()}
    title = ", ".join(part for part in (first.name, first.label) if part) if first.name else name
    return Motion(first.dt, **arrays, name=title, source=f"{source}: {roles}{cut}")


def combined(parts: Mapping[str, Motion | None], name: str | None) -> Motion:
    """Make one motion of the x of one for each component; see `Motion.combine`."""
    given = {key: motion for key, motion in parts.items() if motion is not None}
    dt = given["x"].dt
    for key, motion in given.items():
        if not math.isclose(motion.dt, dt, rel_tol=1e-6):
            raise InputError(
                f"The {key} motion's dt is {motion.dt:g} s; it must be the x motion's, {dt:g} s."
            )
    length, cut = common_length({key: len(motion) for key, motion in given.items()})
    arrays: dict[str, Any] = {key: motion.x[:length] for key, motion in given.items()}
    source = "; ".join(f"{key}: {motion.name} ({motion.source})" for key, motion in given.items()) + cut
    synthetic = any(motion.synthetic for motion in given.values())
    return Motion(
        dt, **arrays, name=given["x"].name if name is None else name, synthetic=synthetic, source=source
    )
