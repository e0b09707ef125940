"""Identifiers of curves that loss tools accept."""

from __future__ import annotations

import hashlib
import re
from typing import TYPE_CHECKING

from stayput.errors import InputError, list_of
from stayput.fragility.curve import CurveState, FragilityCurve

if TYPE_CHECKING:
    from collections.abc import Sequence

_LONGEST = 100


def identifiers(curves: Sequence[FragilityCurve]) -> list[str]:
    """Return a name of letters, digits and underscores for each curve; see `plain_names`.

    Raises
    ------
    InputError
        A curve that is not fitted or is of one motion, without a name, or two curves with the same name.
    """
    given = list_of("curves", curves, FragilityCurve)
    if not given:
        raise InputError("fragility.no_curves")
    for curve in given:
        if curve.state is not CurveState.FITTED:
            raise InputError("fragility.not_fitted", name=repr(curve.name), state=repr(curve.state.value))
        if curve.one_motion:
            raise InputError("fragility.of_one_motion", name=repr(curve.name))
    return plain_names([curve.name for curve in given])


def plain_names(names: Sequence[str]) -> list[str]:
    """Return ASCII letters, digits and underscores for each name, all different whatever their case.

    A name that loses a letter so, that is too long or that becomes like another's ends in eight digits of its
    digest: it is the same in every file, whatever stands beside it there.

    Parameters
    ----------
    names : sequence of str
        The names, in any script.

    Raises
    ------
    InputError
        An empty name, or the same name twice.

    Examples
    --------
    >>> plain_names(["l_bracket", "tension_pole + wedge_stopper", "ポールとストッパー"])
    ['l_bracket', 'tension_pole_and_wedge_stopper', 'measure_31dd036d']
    """
    for name in names:
        if not name or names.count(name) > 1:
            raise InputError("fragility.name_not_unique", name=repr(name))
    # pelicun takes a dash as the end of a part of a name
    plain = [re.sub(r"[^A-Za-z0-9]+", "_", name.replace("+", " and ")).strip("_") for name in names]
    plain_unique: list[str] = []
    for name, short in zip(names, plain, strict=True):
        alike = sum(other.casefold() == short.casefold() for other in plain) > 1
        lost = any(letter.isalnum() and not letter.isascii() for letter in name)
        if short and not (alike or lost or len(short) > _LONGEST):
            plain_unique.append(short)
        else:
            digest = hashlib.blake2s(name.encode(errors="surrogatepass"), digest_size=4).hexdigest()
            plain_unique.append(f"{short[: _LONGEST - 9] or 'measure'}_{digest}")
    return plain_unique
