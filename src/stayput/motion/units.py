"""Units of acceleration and time steps, by the header of a file, by headings of columns or by the caller."""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from stayput.catalogue import Phrase, phrase
from stayput.errors import InputError, InputWarning, excerpt, not_allowed, unknown, warn, within
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.motion.channels import is_direction, is_vertical
from stayput.motion.processing import STEP_RANGE

if TYPE_CHECKING:
    from stayput.motion.readers.headings import Headings

ACCELERATION_UNITS = {
    "m/s²": 1.0,
    "cm/s²": 0.01,
    "gal": 0.01,
    "mm/s²": 0.001,
    "g": STANDARD_GRAVITY,
    "%g": 0.01 * STANDARD_GRAVITY,
    "mg": 0.001 * STANDARD_GRAVITY,
    "in/s²": 0.0254,
    "ft/s²": 0.3048,
}
"""Size of each accepted unit [m/s²]."""

UNIT_NAMES: Phrase = ", ".join(ACCELERATION_UNITS), "、".join(ACCELERATION_UNITS)
"""The accepted units, as a sentence lists them."""

_PER_SECOND_TWICE = r"(?:/s/s|[/p_.·⋅]?\(?s(?:\^|\*\*)?[-−]?2\)?)"
_LENGTHS = {"meters?|metres?|m": "m", "centimet(?:er|re)s?|cm": "cm", "millimet(?:er|re)s?|mm": "mm"} | {
    "inch(?:es)?|in\\.?": "in",
    "feet|foot|ft\\.?": "ft",
}
_SPELLINGS = {rf"(?:{length}){_PER_SECOND_TWICE}": f"{name}/s²" for length, name in _LENGTHS.items()} | {
    "gals?|ガル": "gal",
    "g's|gs?": "g",
    "(?:%|percent|pct)(?:of)?g": "%g",
    "milli-?g|mg": "mg",
}
_NAMED = {re.compile(spelling): name for spelling, name in _SPELLINGS.items()}
_BRACKET = re.compile(r"([^()\[\]]+)[(\[]([^()\[\]]*)[)\]]?")


def unit_factor(unit: str) -> float:
    """Return the size of a unit of acceleration [m/s²].

    Parameters
    ----------
    unit : str
        A name of `ACCELERATION_UNITS` in any spelling in use: ``cm/s/s``, ``gal(cm/s/s)``, ``m s^-2``, ...

    Raises
    ------
    InputError
        The name is none of them.
    """
    name = known_unit(str(unit))
    if name is None:
        raise unknown("motion.unknown_unit", str(unit), ACCELERATION_UNITS, "unit", listed=UNIT_NAMES)
    return ACCELERATION_UNITS[name]


def known_unit(unit: str) -> str | None:
    """Return the name that `ACCELERATION_UNITS` has for a unit, or None where it has none."""
    plain = re.sub(r"\s", "", unicodedata.normalize("NFKC", unit[:100]).lower()).rstrip(".")
    plain = re.sub(r"sec(?:ond)?s?", "s", plain)
    if twice := _BRACKET.fullmatch(plain):  # "gal(cm/s/s)"
        first, second = known_unit(twice[1]), known_unit(twice[2])
        same = first and second and ACCELERATION_UNITS[first] == ACCELERATION_UNITS[second]
        return first if same else None
    return next((name for spelling, name in _NAMED.items() if spelling.fullmatch(plain)), None)


UNIT_OF_TIME = re.compile(r"m?s(?:ec(?:ond)?s?)?", re.IGNORECASE)
_STATED = re.compile(
    r"(?:(?<!time)(?<!time[ _-])units?(?:(?: of (?!time)[a-z]{1,20})? ?[:=] ?| of (?!time))"
    r"|(?P<doubtful>(?:(?<!time)(?<!time[ _-])units?|(?:series|history|raw pga values)(?! in units?))"
    r"(?: in | ?[(\[] ?))|単位 ?[:=：（(]? ?)"
    r"(?P<unit>(?:[0-9.]{1,12} )?[^\s,;)\]、。）]{1,40}(?: ?\(? ?[*×x/] ?[0-9][0-9.e+\-]{0,9}\)?)?)",
    re.IGNORECASE,
)
_STEP_TOLERANCE = 1e-4  # relative, of two time steps that are the same one, rounded to five digits or more
_ROUNDING_OF_TIMES = 0.2  # error of a printed time, in time steps; a missing sample is one of 1
_MOST_VARIATION = 0.01  # error of a time, as a share of the duration, where the sampling rate varies
_SQUARED_SECONDS = r"(?:/s(?:ec)?(?:/s(?:ec)?|²|\^?2|\*\*2)|[ .·⋅]?s\^?[-−⁻][2²])"
MENTIONED = re.compile(
    rf"(?<![a-zµμ])(gals?|(?:[cm]?m|in|ft){_SQUARED_SECONDS}|%g)(?![a-z0-9/^²*])"
    r"|[(\[_] ?(m?g|%g|[cm]?m_?p?s_?2|m_s_2)(?:[)\]]|(?![a-z0-9/^²*]))",
    re.IGNORECASE,
)
_VELOCITY_WORDS = r"(?<![a-z])vel(?:oc\w*)?(?![a-z])|(?<![加波大])速度|(?<!wellen)geschwindigkeit|vitesse"
_UNIT_OF_VELOCITY = r"(?:[cm]?m|in|ft|rad|deg)(?:/s(?:ec)?|[ .·⋅]?s\^?[-−⁻][1¹])|kines?"
_VELOCITY_UNITS = rf"(?<![a-z])(?:{_UNIT_OF_VELOCITY})(?![a-z0-9/^²*])|カイン"
_DISPLACEMENT_WORDS = r"(?<![a-z])disp(?:lacements?)?(?![a-z])|d[eé]placement|desplaza|verschiebung|変位|位移"
_VELOCITY = re.compile(f"{_VELOCITY_WORDS}|{_VELOCITY_UNITS}", re.IGNORECASE)
_DISPLACEMENT = re.compile(rf"{_DISPLACEMENT_WORDS}|[(\[] ?[cm]?m ?[)\]]|_[cm]m$|^[cm]?m$", re.IGNORECASE)
_OTHER_MOTION = re.compile(
    rf"(?<!wave )(?<!peak )(?<!peak ground )(?:(?P<velocity>{_VELOCITY_WORDS}"
    rf"|(?<![0-9])(?<![0-9] )(?:{_VELOCITY_UNITS})(?![)\]]?[ :=]*[0-9]))|{_DISPLACEMENT_WORDS}"
    r"|(?<![a-z0-9])(?<![0-9] )(?:[cm]m|[(\[] ?m ?[)\]])(?! ?[./·⋅]? ?s|[a-z0-9^²*]|[)\]]?[ :=]*[0-9]))",
    re.IGNORECASE,
)  # a unit beside a number is that of something else, such as a depth
_ACCELERATION = re.compile(r"acc(?![a-z])|accel|aceler|beschleunig|加速度", re.IGNORECASE)
_SPECTRUM = re.compile(r"(?:response|fourier|amplitude) spectr|(?:応答|フーリエ)スペクトル", re.IGNORECASE)
_HISTORY = re.compile(r"accelero|histor|time[ -]series|match|compatible|時刻歴|波形|適合", re.IGNORECASE)
_NUMBER = r"[0-9]*\.?[0-9]+(?:[eE][+\-]?[0-9]+)?"
_SHORT_NUMBER = r"[0-9]{0,9}\.?[0-9]{1,20}(?:[eE][+\-]?[0-9]{1,2})?"
_VALUE = (
    r"[^0-9a-z.\n-]{0,4}(?:(?P<bracketed_of>[a-zµμ]+)[)\]])?[ :=：＝]*"
    rf"(?P<of>{_SHORT_NUMBER})(?:/(?P<per_of>{_SHORT_NUMBER}))?"
    r"(?!,?[0-9]|/|e[+\-]?[0-9]) {0,9}(?P<unit_of>[a-zµμ]*)"
)
_STEP = re.compile(
    r"(?:(?<![a-z])(?:dt|delta[ _]?t|(?:time|sampl(?:e|ing))[ _-]?(?:step|interval|period|increment)"
    r"|equally[ -]spaced (?:at )?intervals? of)"
    r"|^(?:delta|interval)(?=[ :=]*0?\.)|時間(?:刻み|間隔)|サンプリング(?:間隔|周期))"
    rf"{_VALUE.replace('of>', 'step>')}"
    r"|(?:(?<![a-z])(?:sampl(?:e|ing)[ _-]?(?:rate|freq(?:uency)?)|fs|sps)|サンプリング(?:周波数|レート))"
    rf"{_VALUE.replace('of>', 'rate>')}"
    rf"|(?<![a-z0-9.,/])(?P<sps>{_SHORT_NUMBER}) ?(?:sps|samples?(?: per |/)s(?:ec(?:ond)?)?)(?![a-z])",
    re.IGNORECASE | re.MULTILINE,
)
_COUNT = re.compile(
    r"(?<![a-z])(?:(?:no|nr|num(?:ber)?|total)\.? (?:of )?(?:[a-z]{1,20} ){0,2}"
    r"(?:points?|pts|data|samples?|values)|npts|ndata)[ :=]{1,40}([0-9]{1,9})(?![0-9.,]*[0-9])"
    r"|(?:データ|サンプル)の?(?:個数|数)[ :=：＝]*([0-9]{1,9})",
    re.IGNORECASE,
)
_OTHER_UNIT = re.compile(
    r"[uµμn]s(?:ec)?|micro.*|m(?:in(?:ute)?s?)?|h(?:ours?|rs?)?|d(?:ays?)?|[km]hz|k", re.IGNORECASE
)
_FACTOR = re.compile(
    r"(?:(?<![a-z])(?:scal(?:e|ing)|(?:scal(?:e|ing)|conversion|calibration|multiplication)[ _-]?factor"
    r"|multipl(?:y|ied)[a-z ]{0,20} by)|^(?:factor|multiplier)|倍率|スケール(?:ファクター)?)"
    rf"[ :=：＝]{{0,4}}({_NUMBER})(?![\w.])",
    re.IGNORECASE,
)
_COUNTS = re.compile(r"(?:digital )?(?:counts?|cts|lsb|m?volts?)(?![a-z])", re.IGNORECASE)


def stated_unit(header: str) -> str | None:
    """Return the unit that a header states in so many words: "unit: gal", "UNITS OF G"."""
    for match in _STATED.finditer(" ".join(header.split())):
        unit = match["unit"].rstrip(".")
        stated = not match["doubtful"] or known_unit(unit) or quantity_of(unit)
        if stated and not UNIT_OF_TIME.fullmatch(unit):  # "Recorder unit (S/N 3)" states none
            return unit
    return None


def stated_step(header: str) -> float | None:
    """Return the one time step that a header states: "dt = 0.005", "Sampling rate: 100 Hz"; in s.

    None where it is in another unit, or not a plain number or fraction: the step must then be given.
    """
    steps = {_step(match) for match in _STEP.finditer(header)}
    return steps.pop() if len(steps) == 1 else None


def stated_count(header: str) -> int | None:
    """Return the one number of samples that a header states: "NO. OF POINTS: 4000"."""
    counts = {int(match[1] or match[2]) for match in _COUNT.finditer(header)}
    return counts.pop() if len(counts) == 1 else None


def _step(match: re.Match[str]) -> float | None:
    kind = next(name for name in ("step", "rate", "sps") if match[name])
    below, unit = 1.0, ""
    if kind != "sps":
        below = float(match[f"per_{kind}"] or 1.0)
        unit = (match[f"bracketed_{kind}"] or match[f"unit_{kind}"]).lower()
    in_time = UNIT_OF_TIME.fullmatch(unit) or unit.startswith("milli")
    value = float(match[kind]) / below if below > 0.0 else 0.0
    if value <= 0.0 or _OTHER_UNIT.fullmatch(unit) or (kind == "rate" and in_time):
        return None
    if kind != "step":
        return 1.0 / value
    return value * (1e-3 if in_time and unit.startswith("m") else 1.0)


def stated_factor(lines: Iterable[str]) -> str | None:
    """Return a line that states a factor of the numbers other than 1: "scale factor: 0.1"."""
    return next((line for line in lines if (m := _FACTOR.search(line)) and float(m[1]) != 1.0), None)


def mentioned_unit(header: str) -> str | None:
    """Return the one unit of acceleration that a header mentions: "acc_gal", "PGA [cm/s²]"."""
    names = {(m[1] or m[2]).lower() for m in MENTIONED.finditer(header)}
    return names.pop() if len({unit_factor(name) for name in names}) == 1 else None


def quantity_of(text: str) -> str | None:
    """Return the name of what a heading or a unit is of, where that is not an acceleration."""
    if _VELOCITY.search(text):
        return "velocity"
    if _COUNTS.fullmatch(text.strip()):
        return "counts"
    return "displacement" if _DISPLACEMENT.search(text) else None


def acceleration_unit(
    stated: str | None, passed: str | None, header: str = "", *, step_missing: bool = False
) -> float:
    """Return the size of the unit of a file's numbers [m/s²].

    Parameters
    ----------
    stated : str, optional
        Unit that the file states.
    passed : str, optional
        Unit that the caller states.
    header : str
        What the file says besides; a unit that it mentions is not taken, but compared.
    step_missing : bool
        Whether the time step must be given too, so that the refusal asks for both at once.

    Raises
    ------
    InputError
        Neither does, they contradict each other, the name is unknown, or no unit of acceleration.

    Warns
    -----
    InputWarning
        The file mentions another unit than the caller's, or states one that is not known.
    """
    if stated is not None and (quantity := quantity_of(stated)):
        raise not_acceleration(stated, quantity)
    known, mentioned = stated and known_unit(stated), stated or mentioned_unit(header)
    if known and passed is not None and unit_factor(known) != unit_factor(passed):
        raise not_the_files_own("unit", excerpt(passed), excerpt(stated or ""))
    if not known and passed is None:
        if stated is not None:
            raise unknown_unit(stated)
        code = "no_unit_but_mentioned" if mentioned else "no_unit_nor_step" if step_missing else "no_unit"
        about: dict[str, Any] = {"mentioned": mentioned, "option": "unit", "other_option": "dt"}
        raise InputError(f"motion.{code}", "unit", known=UNIT_NAMES, **about)
    factor = unit_factor(known or passed or "")
    if not known and mentioned and ACCELERATION_UNITS.get(known_unit(mentioned) or "") != factor:
        warn(InputWarning("motion.unit_mentioned", "unit", given=passed, mentioned=mentioned))
    return factor


def not_acceleration(where: str, quantity: str) -> InputError:
    """Return the refusal of a file whose text says that it is of another quantity: the key of its name."""
    return InputError("motion.not_acceleration", where=excerpt(where), quantity=phrase(f"motion.{quantity}"))


def check_quantity(lines: Sequence[str], header: str) -> None:
    """Refuse numbers that the lines above them say to be of a velocity, a displacement or a spectrum.

    Beside a word or a unit of acceleration they may say what it was made from, or be of something else.

    Parameters
    ----------
    lines : sequence of str
        The lines that are no headings of columns.
    header : str
        All that stands above the numbers.
    """
    of_acceleration = _ACCELERATION.search(header) or MENTIONED.search(header)
    statement = next(filter(None, map(_OTHER_MOTION.search, lines)), None)
    if statement and not (of_acceleration or known_unit(stated_unit(header) or "")):
        quantity = "velocity" if statement["velocity"] else "displacement"
        raise not_acceleration(statement.string, quantity)
    spectrum = next(filter(_SPECTRUM.search, header.split("\n")), None)
    if spectrum and not _HISTORY.search(header):
        raise not_acceleration(spectrum, "spectral")


def not_the_files_own(field: str, passed: str | Phrase, stated: str | Phrase) -> InputError:
    """Return the refusal of a unit or a time step ("dt") that is not the one that the file states."""
    what = phrase("motion.the_unit" if field == "unit" else "motion.the_time_step")
    return InputError("motion.not_the_files_own", field, what=what, given=passed, stated=stated)


def unknown_unit(unit: str) -> InputError:
    """Return the refusal of a unit that a file states and that is not known."""
    about: dict[str, Any] = {"unit": excerpt(unit), "known": UNIT_NAMES, "option": "unit"}
    return InputError("motion.unknown_stated_unit", "unit", **about)


def time_step(stated: float | None, dt: float | None) -> float:
    """Return the time step of a file's samples [s]; arguments and errors as for `acceleration_unit`."""
    if stated is None and dt is None:
        raise InputError("motion.no_time_step", "dt", option="dt")
    if stated is not None and dt is not None and not math.isclose(stated, dt, rel_tol=_STEP_TOLERANCE):
        raise not_the_files_own("dt", f"{dt:g} s", f"{stated:g} s")
    step = stated if stated is not None else dt or 0.0
    return within("motion.name_time_step", step, *STEP_RANGE, "s", "dt")


def regular_step(time: NDArray[np.float64], *, varying: bool = False) -> float:
    """Return the step of two or more equally spaced times [s]; they may be rounded to a fifth of it.

    Parameters
    ----------
    time : ndarray, shape (n,)
        Times [s].
    varying : bool
        Whether the mean step is taken where the sampling rate varies, as that of a phone's clock.

    Raises
    ------
    InputError
        The times do not grow, or not by equal steps.
    """
    n, step = len(time), float(time[-1] - time[0]) / (len(time) - 1)
    error = np.abs(time - (time[0] + step * np.arange(n)))
    if not step > 0.0 or error.max() > _ROUNDING_OF_TIMES * step:
        steps = np.diff(time)
        # No sample is missing where each step is nearly the mean one.
        complete = np.abs(steps - step).max() <= _ROUNDING_OF_TIMES * step
        if complete and error.max() <= _MOST_VARIATION * step * (n - 1):
            if varying:
                return step
            about: dict[str, Any] = {"shortest": float(steps.min()), "longest": float(steps.max())}
            raise InputError("motion.varying_step", "dt", mean=step, option="dt", **about)
        raise InputError("motion.irregular_sampling", time=float(time[error.argmax()]))
    # Printed times are rounded, and so is the step that they give: 0.0099999 s of 0.01 s. The shortest
    # decimal that keeps the last sample within a thousandth of a step is what was meant.
    for digits in range(1, 12):
        nominal = round(step, digits)
        if nominal > 0.0 and abs(nominal - step) * (n - 1) <= 1e-3 * step + 1e-9:
            return nominal
    return step


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
_SIZED = re.compile(
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
        match = _SIZED.fullmatch(content.strip())
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
    raise not_allowed("motion.the_time", excerpt(text), "motion.time_in")


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
        raise not_acceleration(text, "spectral")
    unit = _unit_in(text)
    if unit is None:
        if factor := _unit_with_factor(text):
            column, name = excerpt(text), excerpt(factor)
            raise InputError("motion.column_unit_factor", "unit", column=column, factor=name)
        if quantity := next(filter(None, map(quantity_of, (text, *BRACKET.findall(text)))), None):
            raise not_acceleration(text, quantity)
        names = (name for name in BRACKET.findall(text) if not (is_direction(name) and name.isalnum()))
        other = next(filter(_LIKE_A_UNIT.fullmatch, names), None)
        if other is not None and passed is not None:
            warn(InputWarning("motion.unit_mentioned", "unit", given=passed, mentioned=other))
        elif other is not None and stated is None:
            raise unknown_unit(other)
        return None
    if stated is not None and unit_factor(stated) != unit_factor(unit):
        first, second = excerpt(stated), excerpt(text)
        raise InputError("motion.stated_twice", what=phrase("motion.the_unit"), first=first, second=second)
    if passed is not None and unit_factor(passed) != unit_factor(unit):
        raise not_the_files_own("unit", excerpt(passed), excerpt(text))
    return unit
