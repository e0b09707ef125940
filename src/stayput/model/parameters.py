"""What is known of a field: its default, unit, range, label, meaning; beside the field, and nowhere else.

A dataclass declares it with its fields (`parameter`; `quantity` for a number that must be given), a function
with its arguments (`arguments`). Checks, scenario files and their schema, the app and the documentation read
it: `parameters`.
"""

from __future__ import annotations

import dataclasses
import inspect
import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import MISSING, dataclass
from functools import cache
from typing import Any, TypedDict, TypeVar, Unpack, cast

from stayput.catalogue import Phrase, phrase
from stayput.errors import not_allowed, whole_within, within, word_of
from stayput.uncertainty import Confidence

F = TypeVar("F", bound="Callable[..., Any]")

SIZE_RANGE = (1e-3, 30.0)
"""Smallest and largest width and height that are accepted [m]: up to the racks of a warehouse."""

MASS_RANGE = (1e-3, 1e6)
"""Smallest and largest mass that is accepted [kg]."""

DENSITY_RANGE = (1.0, 25_000.0)
"""Smallest and largest mean density that is accepted [kg/m³]: about those of air and of platinum."""

GIVEN = "given"
"""Tag of a value that the user has given himself, beside those of `stayput.uncertainty.Confidence`."""


@dataclass(frozen=True, slots=True)
class Parameter:
    """What is known of one field of a dataclass, or of one argument of a function.

    Attributes
    ----------
    name : str
        Its name in Python, and in a scenario.
    default : object
        Its default; None where it is taken from elsewhere, `dataclasses.MISSING` where it must be given.
    unit : str
        SI unit; "" for a plain number.
    low, high : float
        Smallest and largest value that is accepted; of a list, each item's.
    label : Phrase
        What it is called, in English and Japanese.
    meaning : str
        What it is: the beginning of what the docstring says of it; "" where the label says it.
    confidence : Confidence
        How well founded the default is.
    choices : tuple of str
        The words that are accepted, where it is a word.
    words : tuple of str
        Words that are accepted beside numbers.
    decides : bool
        Whether the outcome hangs on it and only the product or the wall can tell it: strength, grip, slack.
        How many there are and where is the user's choice; stiffness and damping change little beside these.
    counts : bool
        Whether it counts something although its default, which is taken from elsewhere, is no whole number.

    Examples
    --------
    >>> from stayput.measures import AwayFromWall, parameters
    >>> gap = parameters(AwayFromWall)[0]
    >>> gap.name, gap.unit, gap.low
    ('gap', 'm', 0.0)
    """

    name: str
    default: Any
    unit: str
    low: float
    high: float
    label: Phrase
    meaning: str = ""
    confidence: Confidence = Confidence.LOW
    choices: tuple[str, ...] = ()
    words: tuple[str, ...] = ()
    decides: bool = False
    counts: bool = False

    @property
    def whole(self) -> bool:
        """Whether it counts something: its default is an int, or it says so."""
        return self.counts or isinstance(self.default, int)

    def tag(self, value: object) -> str:
        """Return how well founded a value is: its confidence if it is the default, else `GIVEN`."""
        return self.confidence.value if value == self.default else GIVEN

    def check(
        self,
        value: object,
        *,
        called: Phrase | None = None,
        field: str | None = None,
        bounds: tuple[float, float] | None = None,
    ) -> float:
        """Return a number as a float, or refuse what is none or out of range.

        Parameters
        ----------
        value : object
            What was given.
        called : Phrase, optional
            What it is called; default its label.
        field : str, optional
            Dotted name of the input; default its name.
        bounds : tuple of float, optional
            Smallest and largest value that other fields allow; default its own range.

        Raises
        ------
        InputError
            Not a number, out of range, or not whole where it counts something.
        """
        name, place = called or self.label, field or self.name
        if self.words and isinstance(value, str):
            allowed = phrase("common.number_or", words=", ".join(map(repr, self.words)))
            raise not_allowed(name, repr(value), allowed, place)
        low, high = bounds or (self.low, self.high)
        checked = whole_within if self.whole else within
        return float(checked(name, cast("float", value), low, high, self.unit, place))


class _More(TypedDict, total=False):
    confidence: Confidence
    choices: tuple[str, ...]
    words: tuple[str, ...]
    decides: bool
    counts: bool


def quantity(unit: str, low: float, high: float, label: Phrase, **more: Unpack[_More]) -> dict[str, Any]:
    """Return what is known of a number, as the metadata of a field without a default; see `Parameter`."""
    return {"unit": unit, "low": low, "high": high, "label": label, **more}


def parameter(default: Any, unit: str, low: float, high: float, label: Phrase, **more: Unpack[_More]) -> Any:
    """Return the field of a number with a default; an int takes whole numbers only. See `Parameter`."""
    return dataclasses.field(default=default, metadata=quantity(unit, low, high, label, **more))


def choice(default: str, choices: Collection[str], label: Phrase) -> Any:
    """Return the field of one of several words."""
    return parameter(default, "", 0.0, 0.0, label, choices=tuple(choices))


def other_default(default: Any, kind: Any, name: str) -> Any:
    """Return a field like that of another dataclass, with a default of its own."""
    return dataclasses.field(default=default, metadata=kind.__dataclass_fields__[name].metadata)


def arguments(**about: Mapping[str, Any]) -> Callable[[F], F]:
    """Return a decorator that says what is known of a function's numbers; the signature has their defaults.

    Parameters
    ----------
    **about
        What `quantity` returns, by the names of the arguments.
    """

    def declare(function: F) -> F:
        signature = inspect.signature(function).parameters
        defaults = {name: signature[name].default for name in about}
        empty = inspect.Parameter.empty
        function.__dict__["parameters"] = tuple(
            _parameter(function, name, MISSING if default is empty else default, about[name])
            for name, default in defaults.items()
        )
        return function

    return declare


def parameters(of: Any) -> tuple[Parameter, ...]:
    """Return what is known of the numbers and words of a dataclass or of a function, in their order.

    Examples
    --------
    >>> from stayput.measures import Belt, parameters
    >>> [parameter.name for parameter in parameters(Belt)][:3]
    ['count', 'strength', 'stiffness']
    """
    if inspect.isfunction(of):
        return of.__dict__["parameters"]
    return _of_fields(of if isinstance(of, type) else type(of))


@cache
def _of_fields(kind: type[Any]) -> tuple[Parameter, ...]:
    fields = [field for field in dataclasses.fields(kind) if field.metadata]
    return tuple(_parameter(kind, field.name, field.default, field.metadata) for field in fields)


_ENTRY = re.compile(r"^(\w+(?:, \w+)*) : .*((?:\n    .+)+)", re.MULTILINE)
_MARKS = re.compile(r"[`*]| \[[^\]]*\]")


def _parameter(of: Any, name: str, default: Any, about: Mapping[str, Any]) -> Parameter:
    """Return what is known of a field, with the paragraph on it in the docstring, without units and marks."""
    entries = _ENTRY.findall(inspect.getdoc(of) or "")
    text = next((text for names, text in entries if name in names.split(", ")), "")
    return Parameter(name, default, **about, meaning=" ".join(_MARKS.sub("", text).split()))


def parameter_of(of: Any, name: str) -> Parameter:
    """Return what is known of one field of a dataclass, or of one argument of a function."""
    return next(about for about in parameters(of) if about.name == name)


def check_fields(
    value: Any, *, but: Collection[str] = (), place: str = "", owner: Phrase | None = None
) -> None:
    """Refuse a dataclass's value with a number out of its range, or a word that is none of its choices.

    Parameters
    ----------
    value : object
        The value.
    but : collection of str
        Fields that the class checks by itself: lists, and what other fields bound more narrowly.
    place : str
        What the fields' names begin with in the input, such as "isolation.".
    owner : Phrase, optional
        What a sentence calls the value, where its fields alone do not tell which one it is.

    Raises
    ------
    InputError
        The first that is.
    """
    for about in parameters(value):
        number, called, field = getattr(value, about.name), about.label, place + about.name
        if owner is not None:
            called = phrase("model.field_of", owner=owner, name=(about.name, about.label[1]))
        if about.choices:
            word_of(called, number, about.choices, field)
        elif number in about.words:
            continue
        elif about.name not in but and not (number is None and about.default is None):
            about.check(number, called=called, field=field)
            if number is not None and hasattr(number, "dtype"):  # out of an array: kept as Python's own
                object.__setattr__(value, about.name, number.item())


STANDARD_GRAVITY = 9.80665
"""Standard acceleration of gravity [m/s²]: one "g" of a record, and the default of a simulation."""

GRAVITY = Parameter("gravity", STANDARD_GRAVITY, "m/s²", 0.01, 1e3, ("Gravity", "重力加速度"))
"""Acceleration of gravity where a function asks for it."""
