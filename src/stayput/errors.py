"""How stayput refuses input, and how it warns of input that it takes."""

from __future__ import annotations

import errno
import math
import re
import sys
import warnings
from collections.abc import Callable, Collection, Generator, Iterable, Mapping, Sequence, Sized
from contextlib import contextmanager
from contextvars import ContextVar
from difflib import get_close_matches
from functools import partial
from pathlib import PurePath
from typing import TYPE_CHECKING, Any, Self, TypeVar
from unicodedata import normalize

from stayput.catalogue import TEXTS, Language, Phrase, is_phrase, phrase, say

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

T = TypeVar("T")

LONGEST_SENTENCE = 600
"""Longest sentence that is told [characters]; of a longer one the middle is left out."""

_LONGEST_QUOTE = 60
_BEGINNING = 400


_CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f\u200b\u200e\u200f\u2028-\u202e\u2060-\u2069\ud800-\udfff\ufeff]")
"""Control characters, invisible ones, those that change the direction of the text, and halves of a pair."""


_SYSTEM = {
    errno.ENOENT: "common.no_such_file",
    errno.EACCES: "common.no_access",
    errno.EPERM: "common.no_access",
    errno.EISDIR: "common.is_folder",
    errno.ENOTDIR: "common.no_folder",
    errno.EEXIST: "common.there_already",
    errno.ENAMETOOLONG: "common.long_name",
    errno.ENOSPC: "common.disk_full",
    errno.EROFS: "common.read_only",
    errno.EADDRINUSE: "common.address_in_use",
    errno.ECONNREFUSED: "common.connection_refused",
}
"""What the system says by numbers."""


def reason_of(error: Exception) -> Phrase:
    """Return what the system says of a failure: as it says it, and in Japanese where it is a usual one."""
    said = " ".join((getattr(error, "strerror", None) or str(error) or type(error).__name__).split()).lower()
    known = _SYSTEM.get(getattr(error, "errno", None) or 0)
    return said, say(known, "ja") if known else said


def has_control(text: str) -> bool:
    """Return whether a text holds a control character: one of a terminal, or of the direction of writing."""
    return _CONTROL.search(text) is not None


def visible(text: str) -> str:
    r"""Return a text with its control characters written out, as Python writes them.

    Examples
    --------
    >>> visible("red \x1b[31m")
    'red \\x1b[31m'
    """
    return _CONTROL.sub(lambda match: repr(match[0])[1:-1], text)


def without_control(text: str) -> str:
    """Return a text without its control characters; blanks and tabs stay."""
    return _CONTROL.sub(lambda match: match[0] if match[0].isspace() else "", text)


def readable(sentence: str) -> str:
    """Return a sentence, cut in its middle where it is too long: what is allowed stands at the end."""
    sentence = visible(sentence)
    if len(sentence) <= LONGEST_SENTENCE:
        return sentence
    return f"{sentence[:_BEGINNING]} … {sentence[_BEGINNING + 3 - LONGEST_SENTENCE :]}"


def quoted(value: str) -> str:
    """Return a piece of the input as a sentence quotes it: between quotation marks, the end left out."""
    return repr(value if len(value) <= _LONGEST_QUOTE else f"{value[:_LONGEST_QUOTE]}…")


def shown(value: object) -> str:
    """Return a value as a sentence shows it: as Python does, or its type and length where that is long."""
    text = repr(value)
    if len(text) <= _LONGEST_QUOTE and "\n" not in text:
        return text
    length = f" of length {len(value)}" if isinstance(value, Sized) else ""
    return f"{type(value).__name__}{length}"


def excerpt(value: str) -> Phrase:
    """Return a piece of the input between the quotation marks of each language, the end left out."""
    return quoted(value), f"「{quoted(value)[1:-1]}」"


class _Told:
    """A sentence of the catalogue with its values, the field it is about, and where it was met.

    Attributes
    ----------
    code : str
        Id of the sentence in `stayput.catalogue`; or a sentence of the user's own, without values.
    field : str or None
        Dotted name of the input that is wrong or doubtful, where one is.
    values : dict
        What stands in the sentence's braces, a path between quotation marks; ``name`` is the field where
        nothing else is given.
    context : tuple of Phrase
        Where it was met, the outermost first: a file, a table of the scenario.
    """

    def __init__(
        self, code: str, /, field: str | None = None, *, context: tuple[Phrase, ...] = (), **values: Any
    ) -> None:
        if field is not None:
            values.setdefault("name", field)
        values = {key: repr(str(v)) if isinstance(v, PurePath) else v for key, v in values.items()}
        self.code, self.field, self.context, self.values = code, field, context, values
        super().__init__(self.told("en"))  # pyright: ignore[reportCallIssue] - beside an exception

    def told(self, language: Language) -> str:
        """Return the sentence in "en" or "ja", cut in its middle where it is too long."""
        colon = say("common.colon", language)
        parts = [say(place, language) for place in self.context]
        # A measure of the user's own may refuse in its own words, which then stand for themselves.
        said = say(self.code, language, **self.values) if self.code in TEXTS else self.code
        return readable(colon.join((*parts, said)))

    def at(self, where: str | Phrase, field: str | None = None) -> Self:
        """Return the same with where it was met: a file's name, say; ``field`` may be told anew."""
        place = (where, where) if isinstance(where, str) else where
        return type(self)(self.code, field or self.field, context=(place, *self.context), **self.values)

    def about(self, field: str | None) -> Self:
        """Return the same, about another field."""
        return type(self)(self.code, field, context=self.context, **self.values)

    def anywhere(self) -> Self:
        """Return the same without where it was met."""
        return type(self)(self.code, self.field, **self.values)

    def rewritten(self, rewrite: Callable[[str], str]) -> Self:
        """Return the same with its field, its context and its values passed through a function of texts."""

        def again(value: Any) -> Any:
            if isinstance(value, str):
                return rewrite(value)
            return (rewrite(value[0]), rewrite(value[1])) if is_phrase(value) else value

        values = {key: again(value) for key, value in self.values.items()}
        context = tuple(again(place) for place in self.context)
        # A sentence that no catalogue holds is a value itself.
        code = self.code if self.code in TEXTS else rewrite(self.code)
        return type(self)(code, again(self.field), context=context, **values)

    def renamed(self, old: str, new: str) -> Self:
        """Return the same where the input goes by another name."""
        return self.rewritten(lambda text: text.replace(old, new))

    def __reduce__(self) -> tuple[Any, ...]:
        return partial(type(self), context=self.context, **self.values), (self.code, self.field)


class InputError(_Told, ValueError):
    """Input that is refused: one sentence with what is wrong, the value, and what is allowed.

    Examples
    --------
    >>> import stayput as sp
    >>> try:
    ...     sp.Body(width=-0.4, height=1.8, mass=100.0)
    ... except sp.InputError as error:
    ...     print(error)
    ...     print(error.field)
    Body width is -0.4 m; it must be between 0.001 and 30 m.
    width
    """


class InputWarning(_Told, UserWarning):
    """Input that is taken, but may not be what was meant, or a result that is not quite it: one sentence.

    Examples
    --------
    >>> import stayput as sp
    >>> issubclass(sp.InputWarning, UserWarning)
    True
    """


_listener: ContextVar[Callable[[InputWarning], None] | None] = ContextVar("listener", default=None)


def warn(warning: InputWarning) -> None:
    """Tell of input that may not be what was meant, as a warning of the code that called stayput.

    Parameters
    ----------
    warning : InputWarning
        What is doubtful, the value, and what to do.
    """
    listener = _listener.get()
    if listener is not None:
        listener(warning)
        return
    frame, level = sys._getframe(), 1  # pyright: ignore[reportPrivateUsage]
    while frame is not None and str(frame.f_globals.get("__name__")).split(".")[0] == "stayput":
        frame, level = frame.f_back, level + 1
    warnings.warn(warning, stacklevel=level)


@contextmanager
def warnings_to(listener: Callable[[InputWarning], None]) -> Generator[None]:
    """Give what `warn` tells to a function instead, in this thread (or task) alone.

    Python's own ``warnings.catch_warnings`` is for a whole process, which in a server has other requests.

    Parameters
    ----------
    listener : function
        Called with each warning.
    """
    before = _listener.set(listener)
    try:
        yield
    finally:
        _listener.reset(before)


def near_miss(value: str, known: Iterable[str]) -> str | Phrase:
    """Return the aside "(did you mean …?)" for a name that is not known, or "" where none is like it."""
    near = get_close_matches(value[:_LONGEST_QUOTE], list(known), 1)
    return phrase("common.did_you_mean", name=repr(near[0])) if near else ""


def unknown(
    name: str | Phrase,
    value: object,
    known: Iterable[str],
    field: str | None = None,
    also: Iterable[str] = (),
    listed: Phrase | None = None,
) -> InputError:
    """Return the refusal of a name that is none of those known, nor of ``also``, which is not listed.

    ``listed`` has the known names in both languages, where those of Japanese may be given too.
    """
    names = list(known)
    hint = near_miss(value, [*names, *also]) if isinstance(value, str) else ""
    return InputError(
        "common.not_one_of",
        field,
        name=_called(name),
        value=repr(value),
        hint=hint,
        known=listed or ", ".join(map(repr, names)),
    )


def not_allowed(
    name: str | Phrase, value: str | Phrase | PurePath, allowed: str | Phrase, field: str | None = None
) -> InputError:
    """Return the refusal of a value, as a sentence shows it, with what is allowed; see `InputError`."""
    return InputError(
        "common.not_allowed", field, name=_called(name), value=value, hint="", allowed=_called(allowed)
    )


def too_many(name: str | Phrase, count: int, what: str, most: int, field: str | None = None) -> InputError:
    """Return the refusal of more items, numbers or characters than something may have."""
    return InputError("common.too_many", field, name=_called(name), count=count, what=phrase(what), most=most)


def no_length(field: str = "length") -> InputError:
    """Return the refusal of a body in space whose size across the shaking is not known."""
    return InputError("scenario.missing", field, allowed=phrase("solids.no_length"))


def word_of(name: str | Phrase, value: object, known: Collection[str], field: str | None = None) -> str:
    """Return a word that is one of those known, or raise `InputError`; see `finite`."""
    if not isinstance(value, str) or value not in known:
        raise unknown(name, value, known, field)
    return value


def instance_of(name: str, value: object, kind: type[T] | tuple[type[T], ...]) -> T:
    """Return a value of a type, or of one of several, or raise `InputError`.

    Parameters
    ----------
    name : str
        The argument.
    value : object
        What was given.
    kind : type or tuple of type
        What it must be.
    """
    if not isinstance(value, kind):
        kinds = (kind,) if isinstance(kind, type) else kind
        wanted = " | ".join(each.__name__ for each in kinds)
        raise not_allowed(name, shown(value), phrase("common.of_type", wanted=wanted), name)
    return value


def name_of(name: str, value: object) -> str:
    """Return what the user calls something, a text that is seen whole, or raise `InputError`."""
    text = instance_of(name, value, str)
    if not text.strip() or has_control(text):
        raise not_allowed(name, quoted(text), "common.plain_text", name)
    return text


def refuse_same_names(
    place: str, names: Sequence[str], taken: Mapping[str, str | Phrase] | None = None
) -> None:
    """Refuse two items of a list that have one name, or one that has a name which is taken already.

    Names that differ in spaces or capitals alone, or in how Unicode writes the same letters, are one.

    Parameters
    ----------
    place : str
        The list's key.
    names : sequence of str
        What its items are called.
    taken : mapping, optional
        Names of others, and what these are called in sentences.
    """

    def looks(name: str) -> str:
        return " ".join(normalize("NFC", name).casefold().split())

    seen: dict[str, str | Phrase] = {looks(name): other for name, other in (taken or {}).items()}
    for number, name in enumerate(names):
        if looks(name) in seen:
            key = f"{place}[{number}].name"
            raise InputError("scenario.same_name", key, value=repr(name), other=seen[looks(name)])
        seen[looks(name)] = f"{place}[{number}]"


def list_of(name: str, values: Any, kind: type | tuple[type, ...] = object) -> tuple[Any, ...]:
    """Return the items of a list, all of a type, or raise `InputError`; see `instance_of`."""
    try:
        if isinstance(values, str | bytes):  # whose items would be letters
            raise TypeError
        items: tuple[Any, ...] = tuple(values)
    except TypeError:
        raise not_allowed(name, repr(values), "common.list", name) from None
    for item in items:
        instance_of(name, item, kind)
    return items


def _is_number(value: object) -> bool:
    """Return whether a value is a number, or an array of numbers: no boolean, and no text of one."""
    kind = getattr(getattr(value, "dtype", None), "kind", None)
    return kind in "iuf" if kind else isinstance(value, int | float) and not isinstance(value, bool)


def numbers(
    name: str | Phrase, values: Any, field: str | None = None, count: int | None = None
) -> NDArray[np.float64]:
    """Return numbers as a new array of floats, of any shape or so many in a row, or raise `InputError`."""
    import numpy as np  # which takes its time to load

    try:
        array = np.array(values, np.float64)
        items = values
        if array.ndim != 1:
            items = [values] if hasattr(values, "dtype") else np.array(values, object).flat
        if not all(map(_is_number, items)):
            raise TypeError
    except (TypeError, ValueError, OverflowError):
        raise not_allowed(name, repr(values), "common.numbers", field) from None
    if count is not None and array.shape != (count,):
        raise not_allowed(name, repr(values), phrase("common.so_many_numbers", count=count), field)
    return array


def finite(name: str | Phrase, value: Any, field: str | None = None) -> float:
    """Return ``value`` as a float, or raise `InputError` when it is not a finite number.

    Parameters
    ----------
    name : str or Phrase
        What the number is called: an id of the catalogue, or a text in both languages.
    value : object
        The number.
    field : str, optional
        Dotted name of the input.
    """
    if not _is_number(value) or getattr(value, "ndim", 0):
        raise not_allowed(name, repr(value), "common.number", field)
    try:
        number = float(value)
    except OverflowError:
        raise InputError("common.too_large", field, name=_called(name)) from None
    if not math.isfinite(number):
        raise not_allowed(name, str(number), "common.finite_number", field)
    return number


def within(
    name: str | Phrase, value: float, low: float, high: float, unit: str = "", field: str | None = None
) -> float:
    """Return ``value`` as a float, or raise `InputError` when it is not in [low, high]; see `finite`."""
    if type(value) is float and low <= value <= high < math.inf:  # as most are: the rest takes its time
        return value
    number = finite(name, value, field)
    if not low <= number <= high:
        suffix = f" {unit}" if unit else ""
        raise InputError(
            "common.not_within", field, name=_called(name), value=number, unit=suffix, low=low, high=high
        )
    return number


def whole_within(
    name: str | Phrase, value: float, low: float, high: float, unit: str = "", field: str | None = None
) -> int:
    """Return ``value`` as an int, or raise `InputError` when it is not a whole number in [low, high]."""
    number = within(name, value, low, high, unit, field)
    if not number.is_integer():
        raise not_allowed(name, f"{number:g}", "common.whole_number", field)
    return int(number)


def _called(name: str | Phrase) -> Phrase:
    return (name, name) if isinstance(name, str) and name not in TEXTS else phrase(name)


def absent(what: str, module: str, extra: str) -> InputError:
    """Return the error for a feature whose optional library is not installed.

    Parameters
    ----------
    what : str
        The feature.
    module : str
        Import name of the library.
    extra : str
        Extra of the package that installs it.
    """
    return InputError("model.not_installed", what=what, module=module, extra=extra)
