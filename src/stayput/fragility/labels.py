"""Names that files of loss tools accept."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.fragility.curve import State

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.fragility.curve import FragilityCurve

_LONGEST = 100


def identifiers(curves: Sequence[FragilityCurve]) -> list[str]:
    """Return a name of letters, digits and underscores for each curve, all different.

    Raises
    ------
    InputError
        A curve that is not fitted, without a name, or two curves with the same name.
    """
    if not curves:
        raise InputError("There are 0 curves; a file of curves needs at least one.")
    found: list[str] = []
    for curve in curves:
        if curve.state is not State.FITTED:
            raise InputError(
                f"The curve {curve.name!r} is {curve.state.value!r}; it must be fitted to be written for "
                "loss tools."
            )
        # pelicun takes a dash as the end of a part of a name
        name = re.sub(r"[^A-Za-z0-9]+", "_", curve.name.replace("+", " and ")).strip("_")[:_LONGEST]
        if not name or name in found:
            raise InputError(
                f"The curve's name {curve.name!r} becomes {name!r} in the file; it must have letters or "
                "digits and differ from the others."
            )
        found.append(name)
    return found
