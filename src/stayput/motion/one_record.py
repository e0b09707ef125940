"""Whether motions that are put together are components of one record."""

from __future__ import annotations

import math
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, excerpt, warn
from stayput.motion.channels import line_of, plain_origin
from stayput.motion.floors import floor_phrase

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import NDArray

    from stayput.catalogue import Phrase
    from stayput.motion.channels import Listing
    from stayput.motion.record import Motion

_ROUNDING = 0.01
"""Share of the peak up to which samples differ where one record is written with other digits."""


def check_one_record(parts: Mapping[str, Motion]) -> None:
    """Refuse components of two records, or of one direction; warn where the files do not say.

    What was computed is of no record.

    Parameters
    ----------
    parts : mapping
        The motions of which each one's x becomes a component, by its name: "x", "y", "z".

    Raises
    ------
    InputError
        Two have the same samples, but for rounding and zeros at the end; the files state another event,
        station or sensor, or directions that cannot be those of the components; the time steps differ; one is
        of the ground and another of a floor.
    """
    recorded = {name: motion for name, motion in parts.items() if not motion.synthetic}
    for (first, a), (second, b) in combinations(recorded.items(), 2):
        if _alike(a.x, b.x):
            raise InputError("motion.one_record", second, first=first, second=second, name=excerpt(a.name))
        if a.listing is not None and b.listing is not None:
            if a.listing.names is not b.listing.names:  # which components of one file share
                _check_origins(first, a.listing, second, b.listing)
            _check_directions(first, a.listing.labels["x"], second, b.listing.labels["x"])
    x = parts["x"]
    for name, motion in parts.items():
        if not math.isclose(motion.dt, x.dt, rel_tol=1e-6):
            raise InputError("motion.motion_dt_differs", name, component=name, dt=motion.dt, x_dt=x.dt)
        if motion.floor != x.floor:
            of, other = (
                floor_phrase(part.floor) if part.floor else phrase("motion.ground") for part in (x, motion)
            )
            raise _apart("same_place", "x", of, name, other)


def _alike(a: NDArray[np.float64], b: NDArray[np.float64]) -> bool:
    """Return whether two rows of samples are the same where both go on, to a share of their peak."""
    length = min(len(a), len(b))
    a, b = a[:length], b[:length]
    return bool(np.abs(a - b).max() <= _ROUNDING * np.abs(a).max())


def _check_origins(first: str, a: Listing, second: str, b: Listing) -> None:
    origin, other = a.origin, b.origin
    if origin and other and plain_origin(origin) == plain_origin(other):
        return
    # A title in which no direction was found may have it among its words, and so differ.
    if origin and other and a.labels["x"] and b.labels["x"]:
        raise _apart("same_record", first, _told(origin), second, _told(other))
    warn(InputWarning("motion.origin_unstated", second, first=first, second=second))


def _apart(what: str, first: str, of_first: Phrase, second: str, of_second: Phrase) -> InputError:
    """Return the refusal of two components that are not of the same record or place."""
    about: dict[str, Any] = {"one": of_first, "other": of_second, "what": phrase(f"motion.{what}")}
    return InputError("motion.two_records", second, first=first, second=second, **about)


def _told(origin: str) -> Phrase:
    """Return event and station as a sentence quotes them, the sensor of KiK-net in each language."""
    english, japanese = excerpt(origin)
    for word in ("borehole", "surface"):
        japanese = japanese.replace(f", {word},", f", {phrase(f'motion.sensor_{word}')[1]},")
    return english, japanese


def _check_directions(first: str, label: str, second: str, other: str) -> None:
    axes = [line_of(label), line_of(other)]
    for component, axis, said in zip((first, second), axes, (label, other), strict=True):
        if axis is not None and (axis == "up") != (component == "z"):
            wanted = phrase(f"motion.{'vertical' if component == 'z' else 'horizontal'}")
            about: dict[str, Any] = {"label": excerpt(said), "wanted": wanted}
            raise InputError("motion.wrong_axis", component, component=component, **about)
    if axes[0] is not None and axes[0] == axes[1]:
        labels: dict[str, Any] = {"one": excerpt(label), "other": excerpt(other)}
        raise InputError("motion.one_direction", second, first=first, second=second, **labels)
