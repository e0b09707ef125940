"""What the headings of columns say: which column is the time, and the name and the unit of each other."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from typing import NamedTuple

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, excerpt, without_control
from stayput.motion.channels import LISTED, is_direction, is_down, is_vertical
from stayput.motion.units import (
    BRACKET,
    UNIT_OF_TIME,
    is_motion,
    known_unit,
    not_acceleration,
    quantity_of,
    time_factor,
)
from stayput.wording import joined

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9\-]{0,11}")
_NOT_FINITE = re.compile(r"[+\-]?(?:nan|inf|infinity)", re.IGNORECASE)
_TIME = re.compile(r"t(?![a-z])|.*time(?![ _\-]?(?:history|series))|sec(?:onds?)?(?![a-z])", re.IGNORECASE)
_COUNTED = re.compile(r"(?:no|n|i|index|samples?|counts?|rows?|lines?)\.?", re.IGNORECASE)
_AXIS_OF_SPECTRA = r"freq(?:uency|\.)?|f|(?:natural |vibration )?periods?|固有周期|周期|周波数|振動数"
_UNIT_BEHIND = r"(?:[ _]*[(\[_].*)?"
_OF_SPECTRA = re.compile(f"(?:{_AXIS_OF_SPECTRA}){_UNIT_BEHIND}", re.IGNORECASE)
_OTHER_THAN_TIME = re.compile(
    rf"(?:{_AXIS_OF_SPECTRA}|dist(?:ance|\.)?|depth|frame(?: ?no\.?)?|距離|深さ){_UNIT_BEHIND}", re.IGNORECASE
)
"""What heads the first column of spectra and other tables."""
_OF_TIME = re.compile(r"[(\[] ?m?s(?:ec(?:ond)?s?)? ?[)\]]", re.IGNORECASE)
_TRANSVERSE = re.compile(r"T(?![A-Za-z])")
_LONGITUDINAL = re.compile(r"[LR](?![A-Za-z])")
_NEGATIVE = re.compile(
    r"\([-−]\)|^[-−](?=[A-Za-z])|[A-Za-z][-−]$|.[\s_(+]down(?:wards?)?\b|下向き", re.IGNORECASE
)
_POSITIVE_DOWN = re.compile(
    r"(?:positive|\+ ?(?:is|=)?|plus) ?down|down(?:wards?)? ?(?:is|=|:)? ?(?:positive|\+)"
    r"|下(?:向き|方)?[がを、 ]?(?:正|プラス|[+＋])",
    re.IGNORECASE,
)
_LONGEST_NAME = 40

_ORDER = re.compile(
    r"(?:data[ _]?)?(?:sequence|(?:columns?|fields|channels|components)(?:[ _](?:order|names?))?"
    r"|order of (?:the )?columns)"
    r" ?[:=] ?(.*)",
    re.IGNORECASE,
)
_NUMBERED = re.compile(
    r"\b(?:(?:col(?:umn)?|(ch(?:an(?:nel)?)?))\.? ?#?([0-9]{1,2}) ?[:=\-]|([xyz]) ?[:=]) ?([^,;|]{1,80})",
    re.IGNORECASE,
)
_GLUED = re.compile(
    r"(?:(?:columns?|comp(?:onent)?s?|channels?|order)[ :=]*)?t?[ _]?([a-z]{3})(?: order)?", re.IGNORECASE
)
_GLUED_WORD = re.compile(r"(?<![A-Za-z])t?[ _]?([A-Z]{3})(?![A-Za-z])")
_AXES = ({"N", "E", "Z"}, {"N", "E", "U"}, {"X", "Y", "Z"}, {"L", "T", "V"}, {"L", "T", "Z"}, {"R", "T", "Z"})
_FIGURES = re.compile(
    r"(?:dir(?:ection)?s?|channels?|columns?|comp(?:onent)?s?|order)[ :=]+([0-9](?:[ ,;/-]+[0-9]){1,8})",
    re.IGNORECASE,
)
_PLACE = re.compile(r"(?<![a-z0-9])(?:first|second|third|last|[1-4](?:st|nd|rd|th))(?![a-z])", re.IGNORECASE)
_COMPONENT = re.compile(
    r"(?:(?:comp(?:onent)?|channel|direction|成分|方向) ?[:=：]|comp\.) ?(.*)", re.IGNORECASE
)
_TITLE = re.compile(r"[\"'(\[]?[^\W\d_]{2,}|[0-9/.\-]+ +[^\W\d_]{3,}")
_RULE = re.compile(r"[-=_+|,; \t]*[-=_]{3}[-=_+|,; \t]*")
_WORD = re.compile(r"(?<![A-Za-z0-9.°])[A-Za-z]+(?![A-Za-z0-9])")
_NUMERIC = re.compile(r"[+\-]?\.?[0-9][0-9.eE+\-]*")

_FULL_WIDTH = re.compile("[\u3000-\u30ff\u4e00-\u9fff\uff01-\uff5e]")
"""Kana, Chinese characters, and Latin letters and marks as wide as these."""

_JAPANESE = (
    (re.compile("^秒$"), "sec"),
    (re.compile("ミリ秒"), "ms"),
    (re.compile("(?:経過)?(?:時間|时间)|時刻|秒数"), "time"),
    (re.compile("秒"), "s"),
    (re.compile("(?:データ|サンプル)?番号"), "no"),
    (re.compile("南北"), "NS"),
    (re.compile("東西"), "EW"),
    (re.compile("上下|鉛直|垂直|縦揺れ"), "UD"),
    (re.compile("东西"), "EW"),
    (re.compile("水平|横揺れ"), "H"),
    (re.compile("(?<=[A-Za-z])(?:方向|成分|軸|動)"), ""),
    (re.compile("合成|ベクトル和"), "total"),
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
        Which column is the time; None of one column, and of directions alone below a time step.
    time_factor : float
        Size of the unit of time [s].
    names : tuple of str
        What each column is called; none where it is not said.
    """

    texts: tuple[str, ...] = ()
    time: int | None = 0
    time_factor: float = 1.0
    names: tuple[str, ...] = ()

    def at(self, places: Sequence[int]) -> Headings:
        """Return the headings of the columns at some places, of which one is the time."""
        names = tuple(self.names[place] for place in places) if self.names else ()
        time = None if self.time is None else places.index(self.time)
        return Headings(tuple(self.texts[place] for place in places), time, self.time_factor, names)

    def name_the_time(self) -> bool:
        """Return whether the heading of the time says that it is one."""
        heading = self.texts[self.time or 0] if self.texts else ""
        return bool(_TIME.match(heading) or _OF_TIME.search(heading))


def split(line: str) -> list[str]:
    """Return the fields of a line of columns, those between quotation marks without them."""
    mark = _mark(line)
    fields = [text.strip() for text in line.rstrip(f"{mark or ''} \t").split(mark)]
    if '"' in line:
        fields = [text[1:-1] if len(text) > 1 and text[0] == text[-1] == '"' else text for text in fields]
    return fields


def _mark(line: str) -> str | None:
    """Return what parts the fields of a line; None of blanks."""
    return next((mark for mark in (";", ",") if mark in line), None)


def headings_in(line: str) -> list[str]:
    """Return the fields of a line of headings, without quotation marks and characters that are not seen."""
    if _FULL_WIDTH.search(line):
        line = unicodedata.normalize("NFKC", line)
    # Of headings that are parted by blanks, "NS [gal]" is one.
    line = without_control(line).strip("| ").replace("|", ";")
    joined = re.sub(r"(?<!\s) +(?=[(\[])", " " if _mark(line) else "", line)
    texts = joined.split("\t") if "\t" in line and not _mark(line) else split(joined)
    return [_in_english(text.strip("\"' ")) for text in texts if text.strip() or _mark(line)]


def _in_english(text: str) -> str:
    """Return a heading with the usual Japanese words of records in English: "NS acc (gal)"."""
    if not _FULL_WIDTH.search(text):
        return text
    for japanese, english in _JAPANESE:
        text = japanese.sub(english, text)
    return " ".join(text.split())


def is_title(line: str) -> bool:
    """Return whether a line is one of words: headings, units or a title, and no row with a damaged number."""
    fields = headings_in(line)
    if _RULE.fullmatch(line):
        return True
    if all(
        _NAME.match(text.lstrip("+-−")) and not _NOT_FINITE.fullmatch(text) for text in fields
    ) or units_in(line):
        return True
    figures = sum(bool(_NUMERIC.fullmatch(text) or _NOT_FINITE.fullmatch(text)) for text in fields)
    keyed = line[0].isalpha() and (":" in line or "=" in line)
    return _TITLE.match(line) is not None and (keyed or 2 * figures < len(fields))


def units_in(line: str) -> list[str]:
    """Return the units in a row of nothing else, as below headings: "[s], [gal], [gal]"."""
    fields = [_in_english(text) for text in split(without_control(line))]
    units = [text.strip("\"'()[]- ") for text in fields]
    whole = all(
        not unit
        or UNIT_OF_TIME.fullmatch(unit)
        or known_unit(unit)
        or quantity_of(unit)
        or (text[0] in "([" and not _NUMERIC.fullmatch(unit))
        for text, unit in zip(fields, units, strict=True)
    )
    return units if whole and any(units) else []


def read_headings(
    titles: Sequence[str], comments: Sequence[str], count: int, row: str, *, step_stated: bool = False
) -> Headings:
    """Return what stands above the numbers of the columns.

    Parameters
    ----------
    titles : sequence of str
        The lines of words above the numbers.
    comments : sequence of str
        The comments, without their marks.
    count : int
        How many columns there are.
    row : str
        The first line of numbers. A comment may be about anything: of one that does not say what each column
        is, only names are taken, unless its first field is the time, or any is and the numbers are parted as
        its fields are.
    step_stated : bool
        Whether the time step stands above, so that headings that are directions alone lack none.

    Raises
    ------
    InputError
        No column or more than one is the time, the time has a unit that is not read, or what is said of the
        columns is not understood.
    """
    lines = [*comments, *titles]
    component = next(
        filter(is_direction, (_in_english(m[1]) for m in map(_COMPONENT.match, lines) if m)), None
    )
    named = (component,) * count if component and count <= 2 else ()
    ordered = _stated_order(lines, count)
    texts, place = (ordered, 0) if ordered else _among(titles, comments, count)
    downward = next(filter(_POSITIVE_DOWN.search, lines), None)
    turned = len(texts) == count and any(map(is_down, texts))
    if downward and not turned and (count > 3 or any(map(is_vertical, texts))):
        raise InputError("motion.other_sign", said=excerpt(downward))
    if len(texts) != count:
        if ordered or (_states_columns(texts) and _all_names(texts)):
            raise InputError("motion.column_order", columns=_listed(texts), count=count)
        if count > 2 and (unread := _unread_order(lines)):
            raise InputError("motion.column_order_unread", line=excerpt(unread), option="columns")
        return Headings(names=named)
    times, names = _times(texts), _names(texts)
    called = zip(texts, names or texts, strict=True)
    if negative := next(
        (text for text, name in called if _NEGATIVE.search(text) and not is_down(name)), None
    ):
        raise InputError("motion.other_sign", said=excerpt(negative))
    first = names[0] if names else texts[0]
    names = names if any(map(is_direction, names)) else named or names
    alike = bool(times) and (times[0] == 0 or _mark(lines[place]) == _mark(row))
    if count > 2 and not any(map(is_vertical, names)) and (unread := _unread_order(lines)):
        raise InputError("motion.column_order_unread", line=excerpt(unread), option="columns")
    if _OF_SPECTRA.fullmatch(texts[0]) and not times:
        raise not_acceleration(texts[0], "spectral")
    if not times and names and all(map(is_direction, names)) and step_stated:
        return Headings(tuple(texts), None, names=names)
    of_another = _OTHER_THAN_TIME.fullmatch(texts[0]) is not None
    if not (ordered or titles or alike or (of_another and all(map(is_motion, texts[1:])))):
        return Headings(names=names if all(map(is_direction, names[1:])) else named)
    if count == 1:
        return Headings(tuple(texts), None, names=names)
    if len(times) > 1:
        raise InputError("motion.column_order", columns=_listed(texts), count=count)
    if not times and (
        of_another or is_direction(first) or _COUNTED.fullmatch(texts[0]) or is_motion(texts[0])
    ):
        raise InputError("motion.column_no_time", "columns", column=excerpt(texts[0]), option="columns")
    time = times[0] if times else 0
    if count > 2 and not names:  # of headings that are not understood any may be the vertical
        raise InputError("motion.column_order", columns=_listed(texts), count=count)
    return Headings(tuple(texts), time, time_factor(texts[time]), names)


def _stated_order(lines: Sequence[str], count: int) -> list[str]:
    """Return the headings that lines state: "columns: t, UD, NS", "column 1: t, column 2: UD", "ch1: UD"."""
    matches = [m for line in lines for m in _NUMBERED.finditer(line)]
    numbered = {int(m[2]): m[4].strip() for m in matches if m[2] and not m[1]}
    named = [m for m in matches if (m[1] or m[3]) and _all_directions([m[4]])]
    if named and not numbered and count > 1:  # behind the time; a channel that is not named keeps its letter
        numbered = dict(enumerate(("t", "x", "y", "z")[:count], 1))
        numbered |= {1 + (int(m[2]) if m[2] else "_xyz".index(m[3].lower())): m[4].strip() for m in named}
    texts = [_in_english(numbered[i]) for i in sorted(numbered)]
    if not texts:
        order = next((m[1] for m in map(_ORDER.match, lines) if m), "")
        glued = [m[1] for line in lines if (m := _GLUED.fullmatch(line)) and set(m[1].upper()) in _AXES]
        order = " ".join(glued[0]) if glued else order
        if not order.strip(" 0123456789,;/-"):
            return []
        texts = [text.strip() for text in re.split(r"[;,|\t]", order) if text.strip()]
        if len(texts) != count:
            texts = headings_in(re.sub("[;,|]", " ", order))
        texts = _with_time(texts, count)
    if max(numbered, default=0) != len(numbered) or not (_states_columns(texts) or len(texts) == 1):
        raise InputError("motion.column_order", columns=_listed(texts), count=count)
    return texts


def _unread_order(lines: Sequence[str]) -> str | None:
    """Return a line that names the vertical beside a horizontal direction, or lines that do so together.

    Letters beside figures are left out, as they may be of a place: "35.1 N".
    """
    said: list[list[str]] = []
    for line in lines:
        plain = _in_english(unicodedata.normalize("NFKC", line) if _FULL_WIDTH.search(line) else line)
        words = [word for word in _WORD.findall(plain) if is_direction(word)]
        axes = [word.lower() for word in words]
        said.append([] if {"x", "y", "z"}.issuperset(axes) and axes == sorted(axes) else words)
        figures = _FIGURES.fullmatch(plain)
        if (
            {True, False} <= set(map(is_vertical, said[-1]))
            or (_PLACE.search(plain) and any(is_vertical(word) for word in words if word != "up"))
            or any(set(glued) in _AXES for glued in _GLUED_WORD.findall(plain))
            or (figures and (places := re.findall("[0-9]", figures[1])) != sorted(places))
        ):
            return line
    # One direction a line: names of one letter stand in too many comments.
    named = [word for words in said for word in words if len(word) > 1]
    upright = next((word for word in named if is_vertical(word)), None)
    return ", ".join(dict.fromkeys(named)) if upright and not all(map(is_vertical, named)) else None


def _among(titles: Sequence[str], comments: Sequence[str], count: int) -> tuple[list[str], int]:
    """Return the last headings above the numbers, or the last line, and which line that is."""
    lines = [*comments, *titles]
    rows = [headings_in(line) for line in lines]
    if len(lines) > 1 and len(units := units_in(lines[-1])) == len(rows[-2]):
        rows[-2:] = [[f"{text} [{u}]" if u else text for text, u in zip(rows[-2], units, strict=True)]]
    rows = [_with_time(texts, count) for texts in rows]
    stating = [i for i, texts in enumerate(rows) if _states_columns(texts)]
    fitting = [i for i in stating if len(rows[i]) == count] or [i for i in stating if _all_names(rows[i])]
    place = fitting[-1] if fitting else len(rows) - 1
    if len(comments) <= place < len(rows) - 1:
        wanted = phrase("motion.units_of_columns")
        raise InputError("motion.header_line", line=excerpt(titles[-1]), wanted=wanted)
    return (rows[place] if rows else []), place


def _states_columns(texts: Sequence[str]) -> bool:
    """Return whether texts are headings: the time, and of each other column direction or quantity."""
    times = _times(texts)
    others = [text for i, text in enumerate(texts) if i not in times]
    return bool(times and others) and all(
        is_direction(BRACKET.sub("", text)) or is_motion(text) or "acc" in text.lower() for text in others
    )


def _with_time(texts: list[str], count: int) -> list[str]:
    """Return headings with the time before them, where they are the directions of all other columns."""
    return ["t", *texts] if 1 < len(texts) == count - 1 and _all_directions(texts) else texts


def _all_directions(texts: Sequence[str]) -> bool:
    return _all_names(texts) and all(map(is_direction, texts))


def _all_names(texts: Sequence[str]) -> bool:
    return all(_NAME.fullmatch(BRACKET.sub("", text).strip()) for text in texts)


def _times(texts: Sequence[str]) -> list[int]:
    """Return which columns are headed as the time; a "T" beside an "L" is the transverse component."""
    beside = any(map(_LONGITUDINAL.match, texts))
    others = [i for i, text in enumerate(texts) if not _OTHER_THAN_TIME.fullmatch(text)]
    named = [i for i in others if _TIME.match(texts[i]) and not is_motion(texts[i])]
    times = [i for i in named if not (beside and _TRANSVERSE.match(texts[i]))]
    return times or [i for i in others if _OF_TIME.search(texts[i])]


def _listed(texts: Sequence[str]) -> Phrase:
    return joined(map(excerpt, texts), LISTED)


def _names(texts: Sequence[str]) -> tuple[str, ...]:
    """Return the beginnings of headings; up to a bracket where those are alike or lack the direction."""
    if not all(map(_NAME.match, texts)):
        return ()
    long = [re.split(r"[(\[]", text)[0].strip()[:_LONGEST_NAME] for text in texts]
    names = [m[0] for m in map(_NAME.match, texts) if m]
    if len(set(names)) < len(names):
        return tuple(long)
    return tuple(
        whole if is_direction(whole) and not is_direction(name) else name
        for name, whole in zip(names, long, strict=True)
    )
