"""Whether motions that are put together are components of one record."""

from __future__ import annotations

import math
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, excerpt, warn
from stayput.motion.channels import direction, is_vertical, spellings

if TYPE_CHECKING:
    from collections.abc import Mapping

    from stayput.motion.channels import Listing
    from stayput.motion.record import Motion


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
        The time steps differ; one is of the ground and another of a floor; the files state another event,
        station or sensor, or directions that cannot be those of the components; or two have the same samples.
    """
    x = parts["x"]
    for name, motion in parts.items():
        if not math.isclose(motion.dt, x.dt, rel_tol=1e-6):
            raise InputError("motion.motion_dt_differs", name, component=name, dt=motion.dt, x_dt=x.dt)
        if motion.floor != x.floor:
            of, other = (one.floor or phrase("motion.ground") for one in (x, motion))
            raise InputError("motion.two_floors", name, component=name, of=of, other=other)
    recorded = {name: motion for name, motion in parts.items() if not motion.synthetic}
    for (first, a), (second, b) in combinations(recorded.items(), 2):
        if np.array_equal(a.x, b.x):
            raise InputError("motion.one_record", second, first=first, second=second, name=excerpt(a.name))
        if a.listing is not None and b.listing is not None:
            _check_origins(first, a.listing, second, b.listing)
            _check_directions(first, a.listing.label, second, b.listing.label)


def _check_origins(first: str, a: Listing, second: str, b: Listing) -> None:
    one, other = a.origin, b.origin
    if one and other and one.casefold() == other.casefold():
        return
    # A title in which no direction was found may have it among its words, and so differ.
    if one and other and a.label and b.label:
        about: dict[str, Any] = {"one": excerpt(one), "other": excerpt(other)}
        raise InputError("motion.two_records", second, first=first, second=second, **about)
    warn(InputWarning("motion.origin_unstated", second, first=first, second=second))


def _check_directions(first: str, label: str, second: str, other: str) -> None:
    axes = [_axis(label), _axis(other)]
    for component, axis, said in zip((first, second), axes, (label, other), strict=True):
        if axis is not None and (axis == "up") != (component == "z"):
            wanted = phrase(f"motion.{'vertical' if component == 'z' else 'horizontal'}")
            about: dict[str, Any] = {"label": excerpt(said), "wanted": wanted}
            raise InputError("motion.wrong_axis", component, component=component, **about)
    if axes[0] is not None and axes[0] == axes[1]:
        labels: dict[str, Any] = {"one": excerpt(label), "other": excerpt(other)}
        raise InputError("motion.one_direction", second, first=first, second=second, **labels)


def _axis(label: str) -> str | None:
    """Return the line along which a direction points, "up" or an azimuth below 180; None where unknown."""
    if is_vertical(label):
        return "up"
    azimuth = next((each for each in spellings(direction(label)) if each.isdecimal()), None)
    return None if azimuth is None else str(int(azimuth) % 180)
