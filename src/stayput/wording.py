"""Helpers for sentences: language, labels, names, lists, counts, brackets, the limit of stated slides."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import fields
from typing import TYPE_CHECKING, Any

from stayput.catalogue import LANGUAGES, Phrase, phrase, say
from stayput.errors import word_of

if TYPE_CHECKING:
    from stayput.model.room import Room

FAR = 3.0
"""A slide beyond this, in a room that is open to a side, is told as no more than that [m].

On casters or glides a piece may go on for ten metres and more where no wall stands in its way: a true result
of the model, and none of a room.
"""


def check_language(language: str) -> str:
    """Return a language, or refuse it.

    Raises
    ------
    InputError
        It is neither "en" nor "ja".
    """
    return word_of("common.language", language, LANGUAGES, "language")


def brief(value: Any, first: int = 1) -> str:
    """Return a dataclass as Python makes it: its first fields, and others that differ from their defaults."""
    parts: list[str] = []
    for field in fields(value):
        now = getattr(value, field.name)
        usual = field.default_factory() if callable(field.default_factory) else field.default
        if field.compare and (now != usual or len(parts) < first):
            parts.append(f"{field.name}={now:.6g}" if isinstance(now, float) else f"{field.name}={now!r}")
    return f"{type(value).__name__}({', '.join(parts)})"


class Brief:
    """A dataclass that shows itself as Python makes it, without what has its default; see `brief`."""

    __slots__ = ()

    def __repr__(self) -> str:
        return brief(self)


def inside(label: str) -> str:
    """Return a measure's label as it stands within an English sentence.

    Examples
    --------
    >>> inside("Wedge stopper + Tension poles"), inside("Screwed L-brackets"), inside("PTFE glides")
    ('wedge stopper + tension poles', 'Screwed L-brackets', 'PTFE glides')
    """
    return " + ".join(
        part[:1].lower() + part[1:] if part[1:2].islower() else part for part in label.split(" + ")
    )


def joined(parts: Iterable[Phrase], by: str | Phrase = "common.listed") -> Phrase:
    """Return phrases as a list in one."""
    english, japanese = zip(*parts, strict=True)
    between = phrase(by)
    return between[0].join(english), between[1].join(japanese)


def default_name(name: str, kinds: Mapping[str, Phrase]) -> tuple[str, str] | None:
    """Return kind and number of a name such as "bookcase" or "bookcase 2"; None for a name of the user's own.

    With a number the kind may also be written as it is called in either language: "Bookcase 2", "本棚 2".
    """
    if name in kinds:
        return name, ""
    before, _, number = name.rpartition(" ")
    if not (number.isascii() and number.isdecimal()):
        return None
    called = (kind for kind, words in kinds.items() if before.lower() in (kind, *words))
    return next(((kind, number) for kind in called), None)


def called(name: str, kinds: Mapping[str, Phrase]) -> Phrase:
    """Return what something is called by itself, translated where that is a default name."""
    default = default_name(name, kinds)
    if default is None:
        return (name, name)
    kind, number = default
    return phrase("rooms.numbered", name=kinds[kind], number=number) if number else kinds[kind]


def name_quoted(name: str, kinds: Mapping[str, Phrase]) -> Phrase:
    """Return what something is called in a refusal: "“desk”", "「机」"."""
    return phrase("rooms.named", name=called(name, kinds))


def name_within(name: str, kinds: Mapping[str, Phrase]) -> Phrase:
    """Return what something is called within a sentence: "the desk", "desk 2", "“My own”"."""
    default = default_name(name, kinds)
    if default is None:
        return phrase("rooms.named", name=name)
    return called(name, kinds) if default[1] else phrase("rooms.the", name=called(name, kinds))


def counted(number: int, noun: str, plural: str | None = None) -> str:
    """Return a number with its noun in English.

    Examples
    --------
    >>> counted(1, "earthquake"), counted(1200, "run"), counted(2, "piece that fell", "pieces that fell")
    ('1 earthquake', '1,200 runs', '2 pieces that fell')
    """
    return f"{number:,} {noun if number == 1 else plural or f'{noun}s'}"


def with_aside(text: str, content: str, language: str) -> str:
    """Return a text with an addition in brackets; a Japanese text that ends in a bracket takes it in there.

    Examples
    --------
    >>> with_aside("Gel mats", "front", "en"), with_aside("ゲルマット（粘着式）", "前面側", "ja")
    ('Gel mats (front)', 'ゲルマット（粘着式、前面側）')
    """
    if language == "ja" and text.endswith("）"):
        return f"{text[:-1]}{say('common.listed', language)}{content}）"
    return text + say("common.aside", language, content=content)


def is_open(room: Room) -> bool:
    """Return whether a room has no wall on one side at least."""
    return room.left_wall is None or room.right_wall is None
