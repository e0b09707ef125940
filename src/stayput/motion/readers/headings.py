"""What the headings of columns say: which column is the time, and the name and the unit of each other."""

from __future__ import annotations

import re
import unicodedata
from typing import TYPE_CHECKING, NamedTuple

from stayput.catalogue import phrase
from stayput.errors import InputError, excerpt, without_control
from stayput.motion.channels import is_direction
from stayput.motion.readers.header import acceleration_unit, mentioned_unit
from stayput.motion.units import unit_factor

if TYPE_CHECKING:
    from collections.abc import Sequence

    from stayput.catalogue import Phrase

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9\-]{0,11}")
_NOT_FINITE = re.compile(r"[+\-]?(?:nan|inf|infinity)", re.IGNORECASE)
_TIME = re.compile(r"t(?![a-z])|.*time(?![ _\-]?(?:history|series))|sec(?:onds?)?(?![a-z])", re.IGNORECASE)
_COUNTED = re.compile(r"(?:no|n|i|index|samples?|counts?|rows?|lines?)\.?", re.IGNORECASE)
_TIME_UNIT = re.compile(
    r"[(\[_] ?(?:(?P<s>s|secs?|seconds?)|(?P<ms>ms|msecs?|milliseconds?)|"
    r"[uµμ]s|ns|min|minutes?|hr?|hours?|d|days?) ?(?:[)\]]|$)",
    re.IGNORECASE,
)
_OF_TIME = re.compile(r"[(\[] ?(?:s|ms|m?sec) ?[)\]]")
_VELOCITY = re.compile(
    r"(?<![a-z])(?:vel(?:ocity)?(?![a-z])|(?:[cm]?m/s(?:ec)?|kines?)(?![a-z0-9/^²*]))", re.IGNORECASE
)
_DISPLACEMENT = re.compile(
    r"(?<![a-z])disp(?:lacement)?(?![a-z])|[(\[] ?[cm]?m ?[)\]]|_[cm]m$", re.IGNORECASE
)
_LONGEST_NAME = 40

_FULL_WIDTH = re.compile("[\u3000-\u30ff\u4e00-\u9fff\uff01-\uff5e]")
"""Kana, Chinese characters, and Latin letters and marks as wide as these."""

_JAPANESE = (
    (re.compile("^秒$"), "sec"),
    (re.compile("ミリ秒"), "ms"),
    (re.compile("(?:経過)?時間|時刻|秒数"), "time"),
    (re.compile("秒"), "s"),
    (re.compile("(?:データ|サンプル)?番号"), "no"),
    (re.compile("南北"), "NS"),
    (re.compile("東西"), "EW"),
    (re.compile("上下|鉛直"), "UD"),
    (re.compile("(?<=[A-Za-z])(?:方向|成分|軸|動)"), ""),
    (re.compile("ガル"), "gal"),
    (re.compile("カイン"), "kine"),
    (re.compile("加速度"), " acc "),
    (re.compile("速度"), " velocity "),
    (re.compile("変位"), " displacement "),
    (re.compile(r"^ *(acc|velocity|displacement)[ _\-・:]*(NS|EW|UD|[XYZ])(?![A-Za-z])"), r"\2 \1"),
)
"""What usual Japanese headings are in English, in the order in which they are replaced."""


class Headings(NamedTuple):
    """The headings of columns.

    Attributes
    ----------
    texts : tuple of str
        The headings as they stand in the file, one a column; none where it has none.
    time : int, optional
        Which column is the time; None of one column.
    time_factor : float
        Size of the unit of time [s].
    names : tuple of str
        What each column is called; none where it is not said.
    """

    texts: tuple[str, ...] = ()
    time: int | None = 0
    time_factor: float = 1.0
    names: tuple[str, ...] = ()


def split(line: str) -> list[str]:
    """Return the fields of a line of columns."""
    mark = _mark(line)
    if mark is None:
        return line.split()
    return [value.strip() for value in line.rstrip(f"{mark} \t").split(mark)]


def _mark(line: str) -> str | None:
    """Return what parts the fields of a line; None of blanks."""
    return next((mark for mark in (";", ",") if mark in line), None)


def headings_in(line: str) -> list[str]:
    """Return the fields of a line of headings, without quotation marks and characters that are not seen."""
    if _FULL_WIDTH.search(line):
        line = unicodedata.normalize("NFKC", line)
    # Of headings that are parted by blanks, "NS [gal]" is one.
    joined = re.sub(r"(?<!\s)\s+(?=[(\[])", " " if _mark(line) else "", without_control(line))
    return [_in_english(text.strip("\"' ")) for text in split(joined)]


def _in_english(text: str) -> str:
    """Return a heading with the usual Japanese words of records in English: "NS acc (gal)"."""
    if not _FULL_WIDTH.search(text):
        return text
    for japanese, english in _JAPANESE:
        text = japanese.sub(english, text)
    return " ".join(text.split())


def are_headings(line: str) -> bool:
    """Return whether every field begins like a name, and none is a number that is not finite."""
    return all(_NAME.match(text) and not _NOT_FINITE.fullmatch(text) for text in headings_in(line))


def read_headings(line: str, count: int, row_below: str | None) -> Headings:
    """Return what the last line above the numbers says of the columns.

    Parameters
    ----------
    line : str
        The line, without the mark of a comment.
    count : int
        How many columns there are.
    row_below : str, optional
        The first line of numbers, where the headings are a comment. A comment may be about anything: only
        names are taken of it, unless its first field is the time, or any is and the numbers are parted as
        its fields are.

    Raises
    ------
    InputError
        No column or more than one is the time, or the time has a unit that is not read.
    """
    texts = tuple(headings_in(line))
    if len(texts) != count:
        return Headings()
    times = [i for i, text in enumerate(texts) if _TIME.match(text) and not _is_motion(text)]
    times = times or [i for i, text in enumerate(texts) if _OF_TIME.search(text)]
    names = _names(texts)
    alike = row_below is None or (bool(times) and (times[0] == 0 or _mark(line) == _mark(row_below)))
    if not alike:
        return Headings(names=names)
    if count == 1:
        return Headings(texts, None, names=names)
    if len(times) > 1:
        raise InputError("motion.column_times", columns=_listed([texts[i] for i in times]))
    if not times and (is_direction(names[0]) or _COUNTED.fullmatch(texts[0]) or _is_motion(texts[0])):
        raise InputError("motion.column_no_time", column=excerpt(texts[0]))
    time = times[0] if times else 0
    return Headings(texts, time, _time_factor(texts[time]), names)


def is_time(text: str) -> bool:
    """Return whether a heading says that its column is the time."""
    return bool(_TIME.match(text) or _OF_TIME.search(text))


def _listed(texts: Sequence[str]) -> Phrase:
    english, japanese = zip(*map(excerpt, texts), strict=True)
    return ", ".join(english), "、".join(japanese)


def _is_motion(text: str) -> bool:
    return mentioned_unit(text) is not None or _quantity(text) is not None


def _time_factor(text: str) -> float:
    unit = _TIME_UNIT.search(text)
    if unit is None or unit["s"]:
        return 1.0
    if unit["ms"]:
        return 1e-3
    raise InputError("motion.column_time_unit", column=excerpt(text))


def _names(texts: Sequence[str]) -> tuple[str, ...]:
    """Return the beginnings of headings as names, or the headings up to a bracket where those are alike."""
    found = [_NAME.match(text) for text in texts]
    names = [match[0] for match in found if match is not None]
    if len(names) < len(texts):
        return ()
    if len(set(names)) < len(names):
        names = [re.split(r"[(\[]", text)[0].strip()[:_LONGEST_NAME] for text in texts]
    return tuple(names)


def _quantity(text: str) -> str | None:
    """Return the name of what a heading is of, where that is not an acceleration."""
    if _VELOCITY.search(text):
        return "velocity"
    return "displacement" if _DISPLACEMENT.search(text) else None


def column_factors(
    headings: Headings, count: int, stated: str | None, given: str | None, above: str, *, step_missing: bool
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
    given : str, optional
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
    own = {i: unit_factor(unit) for i, text in columns.items() if (unit := _own_unit(text, stated, given))}
    if columns and len(own) == len(columns):
        return [own.get(i, 1.0) for i in range(count)]
    if len(set(own.values())) > 1:  # a unit that is stated or given contradicts none of them
        bare = next(text for i, text in columns.items() if i not in own)
        raise InputError("motion.column_no_unit", column=excerpt(bare))
    factor = acceleration_unit(stated, given, above, step_missing=step_missing)
    return [own.get(i, factor) for i in range(count)]


def _own_unit(text: str, stated: str | None, given: str | None) -> str | None:
    """Return the unit in a heading, which neither the comments nor the caller may contradict."""
    unit = mentioned_unit(text)
    if unit is None:
        if quantity := _quantity(text):
            name = phrase(f"motion.{quantity}")
            raise InputError("motion.column_quantity", column=excerpt(text), quantity=name)
        return None
    if stated is not None and unit_factor(stated) != unit_factor(unit):
        raise InputError("motion.column_header_unit", column=excerpt(text), stated=excerpt(stated))
    if given is not None and unit_factor(given) != unit_factor(unit):
        raise InputError("motion.column_another_unit", "unit", given=given, column=excerpt(text))
    return unit
