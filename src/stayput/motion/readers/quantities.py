"""What the headings of columns say of quantity, unit and factor."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from stayput.catalogue import phrase
from stayput.errors import InputError, InputWarning, excerpt, warn
from stayput.motion.channels import is_direction, is_vertical
from stayput.motion.units import (
    MENTIONED,
    acceleration_unit,
    known_unit,
    mentioned_unit,
    not_the_files_own,
    quantity_of,
    unit_factor,
    unknown_unit,
)

if TYPE_CHECKING:
    from stayput.motion.readers.headings import Headings

_SPECTRAL = re.compile(
    r"P?S[avd](?= *(?:[(\[]|$))|PG[av](?![a-z])|(?:peak|max(?:imum)?\.?)[ _]"
    r"|.*(?:spectr|fourier|スペクトル|フーリエ|最大)",
    re.IGNORECASE,
)
_MAGNITUDE = re.compile(
    r".*(?<![a-z])(?:abs(?:olute)?|total|magnitude|norm|resultant|(?:vector )?sum)(?![a-z])|(?:a|acc)_?t\b",
    re.IGNORECASE,
)
_TIME_UNIT = re.compile(
    r"[(\[_] ?(?:(?P<s>s|secs?|seconds?)|(?P<ms>ms|msecs?|milliseconds?)|"
    r"[uµμdc]s|ns|min|minutes?|hr?|hours?|d|days?) ?(?:[)\]]|$)",
    re.IGNORECASE,
)
BRACKET = re.compile(r"[(\[]([^()\[\]]{1,40})[)\]]")
_LIKE_A_UNIT = re.compile(r"[^\W\d_]\S{0,5}|\S*[/%^²]\S*")  # "kip", "km/h2"; not "filtered"
_FACTOR = re.compile(
    r"[x×*·]?\s*[0-9.][0-9.^e+\-−]*\s*[x×*·]?\s*(?P<after>[^\d\s].*)"
    r"|(?P<before>.*?)\s*[x×*]\s*[0-9][0-9.^e+\-−]*",
    re.IGNORECASE,
)
_SCALED = re.compile(
    r"(?<=[\s)\]_])x ?(?:10+|[0-9]*\.[0-9]+)(?![a-z0-9])|(?<![a-z0-9])10+ ?x(?![a-z])"
    r"|(?:[×·⋅÷]|(?<!\*)\*) ?[0-9.]+|(?<![0-9.])[0-9.]+ ?(?:[×·⋅]|\*(?!\*))"
    r"|(?<!/[0-9])(?<!/[0-9]{2})/ ?10+(?![0-9/])|(?<![0-9/])1/10+"
    r"|10\^|(?<![a-z0-9.])[0-9.]+e[-+]?[0-9]",
    re.IGNORECASE,
)
"""A factor anywhere in a heading; "x 2" may be an axis, and "10^" is of a power."""
_SCALED_TIME = re.compile(r"[(\[] ?(?:1/)?[0-9.]+ ?m?s", re.IGNORECASE)


def is_motion(text: str) -> bool:
    """Return whether a heading has a unit of acceleration, or is of a velocity, a displacement or counts."""
    return _unit_in(text) is not None or quantity_of(text) is not None


def without_unit(text: str) -> str:
    """Return a heading without what it says of the unit: "NS (roof) [gal]" → "NS (roof) "."""
    return MENTIONED.sub("", BRACKET.sub(lambda match: "" if known_unit(match[1]) else match[0], text))


def _unit_in(text: str) -> str | None:
    """Return the unit of acceleration in a heading, or that is one; None of one with a factor."""
    if _unit_with_factor(text):
        return None
    return next(filter(known_unit, (*BRACKET.findall(text), text)), None) or mentioned_unit(text)


def _unit_with_factor(text: str) -> str | None:
    """Return a heading's factor: what stands in brackets as "0.1 gal" or "X 1000", or "*10" anywhere."""
    for content in BRACKET.findall(text):
        match = _FACTOR.fullmatch(content.strip())
        unit = match and (match["after"] or match["before"])
        if match and (known_unit(unit) if unit else mentioned_unit(text)):
            return content
    scaled = _SCALED.search(text)
    return scaled and scaled[0]


def time_factor(text: str) -> float:
    """Return the size of the unit in the heading of the time [s]; refuse any but s and ms."""
    unit = _TIME_UNIT.search(text)
    scaled = _SCALED.search(text) or _SCALED_TIME.search(text)
    if not scaled and (unit is None or unit["s"]):
        return 1.0
    if not scaled and unit and unit["ms"]:
        return 1e-3
    raise InputError("motion.column_time_unit", column=excerpt(text))


def other_quantities(headings: Headings) -> list[int]:
    """Return the places of velocities and displacements, where another column is an acceleration.

    So is the magnitude of the acceleration beside its three components.
    """
    columns = {i: text for i, text in enumerate(headings.texts) if i != headings.time}
    bare = {i: re.split(r"[(\[]", text)[0].strip().lower() for i, text in columns.items()}
    of_letters = {"v", "d"} if {"a", "v", "d"} <= set(bare.values()) else set[str]()
    others = [
        i
        for i, text in columns.items()
        if bare[i] in of_letters or (mentioned_unit(text) is None and quantity_of(text) is not None)
    ]
    if len(axes_of(headings)) == len(("t", "x", "y", "z")):
        others += [i for i, text in columns.items() if i not in others and _MAGNITUDE.match(text)]
    return others if len(others) < len(columns) else []


def axes_of(headings: Headings) -> dict[str, int]:
    """Return which columns are the time, x, y and z, where headings name each once; none otherwise."""
    named = {i: name for i, name in enumerate(headings.names) if i != headings.time and is_direction(name)}
    level = sorted((name, i) for i, name in named.items() if not is_vertical(name))
    if not [name for name, _ in level if name.lower().endswith("x")]:
        level.sort(key=lambda each: each[1])
    upright = [i for i, name in named.items() if is_vertical(name)]
    if headings.time is None or len(level) != 2 or len(upright) != 1:
        return {}
    return {"t": headings.time, "x": level[0][1], "y": level[1][1], "z": upright[0]}


def column_factors(
    headings: Headings, count: int, stated: str | None, passed: str | None, above: str, *, step_missing: bool
) -> list[float]:
    """Return the size of each column's unit [m/s²]; that of the time's has no meaning.

    Parameters
    ----------
    headings : Headings
        What the headings say.
    count : int
        How many columns there are.
    stated : str, optional
        Unit that the comments state.
    passed : str, optional
        Unit that the caller states.
    above : str
        All that stands above the numbers.
    step_missing : bool
        See `acceleration_unit`.

    Raises
    ------
    InputError
        A column is no acceleration, no unit is stated or given, or two of them contradict each other.
    """
    columns = {i: text for i, text in enumerate(headings.texts) if i != headings.time}
    scale = {i: unit_factor(unit) for i, text in columns.items() if (unit := _own_unit(text, stated, passed))}
    if columns and len(scale) == len(columns):
        return [scale.get(i, 1.0) for i in range(count)]
    if len(set(scale.values())) > 1:  # a unit that is stated or given contradicts none of them
        bare = next(text for i, text in columns.items() if i not in scale)
        raise InputError("motion.column_no_unit", column=excerpt(bare))
    factor = acceleration_unit(stated, passed, above, step_missing=step_missing)
    return [scale.get(i, factor) for i in range(count)]


def _own_unit(text: str, stated: str | None, passed: str | None) -> str | None:
    """Return the unit in a heading, which neither the comments nor the caller may contradict."""
    if _SPECTRAL.match(text):
        raise InputError("motion.not_acceleration", where=excerpt(text), quantity=phrase("motion.spectral"))
    unit = _unit_in(text)
    if unit is None:
        if factor := _unit_with_factor(text):
            column, name = excerpt(text), excerpt(factor)
            raise InputError("motion.column_unit_factor", "unit", column=column, factor=name)
        if quantity := next(filter(None, map(quantity_of, (text, *BRACKET.findall(text)))), None):
            name = phrase(f"motion.{quantity}")
            raise InputError("motion.not_acceleration", where=excerpt(text), quantity=name)
        names = (name for name in BRACKET.findall(text) if not (is_direction(name) and name.isalnum()))
        unknown = next(filter(_LIKE_A_UNIT.fullmatch, names), None)
        if unknown is not None and passed is not None:
            warn(InputWarning("motion.unit_mentioned", "unit", given=passed, mentioned=unknown))
        elif unknown is not None and stated is None:
            raise unknown_unit(unknown)
        return None
    if stated is not None and unit_factor(stated) != unit_factor(unit):
        raise InputError("motion.two_units", first=excerpt(stated), second=excerpt(text))
    if passed is not None and unit_factor(passed) != unit_factor(unit):
        raise not_the_files_own("unit", excerpt(passed), excerpt(text))
    return unit
