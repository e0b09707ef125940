"""TOML of a scenario file to a table within bounds, and one plain sentence for what a file gets wrong.

`with_value` changes a table by its keys as refusals write them. What is allowed is read from the JSON Schema.

A dotted key of n parts takes memory that grows with n², nested brackets take the parser's own stack, and a
whole number of any length is a whole number: a scenario needs none of the three.
"""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from stayput.catalogue import LANGUAGES, Phrase, phrase, say
from stayput.errors import InputError, near_miss, reason_of, unknown
from stayput.vocabulary import also_called, listed

if TYPE_CHECKING:
    from pydantic_core import ErrorDetails


_LONGEST = 60  # characters of a value that are shown


def refusal_of(errors: Sequence[ErrorDetails], schema: dict[str, Any], within: str = "") -> InputError:
    """Return the refusal for the first error, unknown keys first: a misspelt key is the cause, not a sign.

    Parameters
    ----------
    errors : sequence of ErrorDetails
        What pydantic found.
    schema : dict
        The JSON Schema of what was checked: a scenario, or a table of it.
    within : str
        Dotted name of that table; "" for a whole scenario.
    """
    error = min(errors, key=lambda detail: detail["type"] != "extra_forbidden")
    place = error["loc"]
    name = ".".join(filter(None, (within, _dotted(place))))
    if error["type"] == "extra_forbidden":
        return _unknown_key(name, place, schema)
    raised = error.get("ctx", {}).get("error")
    if isinstance(raised, InputError):  # by a table's own check, which does not know its place in a list
        return _in_its_list(raised, name)
    if error["type"].startswith("union_tag"):
        return _wrong_type(name, error["input"], kinds(_node(place, schema), schema))
    allowed = _allowed(_node(place, schema), schema, error["input"])
    if error["type"] == "missing":
        return InputError("scenario.missing", name, allowed=allowed)
    hint, value = _hint(error["input"], place, schema), shown(error["input"])
    return InputError("common.not_allowed", name, value=value, hint=hint, allowed=allowed)


def _wrong_type(name: str, value: object, tables: list[dict[str, Any]]) -> InputError:
    """Return the refusal of what is none of several tables, which are told apart by their type."""
    known = [table["properties"]["type"]["const"] for table in tables if "type" in table["properties"]]
    if not isinstance(value, dict):
        allowed = phrase(
            "scenario.table_with_type" if len(known) == len(tables) else "scenario.one_of_tables"
        )
        return InputError("common.not_allowed", name, value=shown(value), hint="", allowed=allowed)
    stated, name = cast("dict[str, object]", value).get("type"), f"{name}.type"
    if stated is None:
        allowed = phrase("scenario.one_of", names=", ".join(known))
        return InputError("scenario.missing", name, allowed=allowed)
    return unknown(name, stated, known, name)


def _in_its_list(error: InputError, place: str) -> InputError:
    """Return a refusal of a table of a list, "furniture.mass", with its place there: "furniture[1].mass"."""
    plain = re.sub(r"\[\d+\]", "", place)
    beginning = re.compile(rf"\b{re.escape(plain)}(?=[.\[\]])")
    renamed = error.rewritten(lambda text: beginning.sub(place, text))
    return renamed.about(place) if error.field == plain else renamed


def _unknown_key(name: str, place: Sequence[str | int], schema: dict[str, Any]) -> InputError:
    known = [key for kind in kinds(_node(place[:-1], schema), schema) for key in kind.get("properties", {})]
    table = name.rpartition(".")[0]
    where = phrase("scenario.key_of_table", table=table) if table else phrase("scenario.top_level_key")
    hint = near_miss(str(place[-1]), known)
    return InputError("scenario.unknown_key", name, hint=hint, where=where, known=", ".join(known))


def _hint(value: object, place: Sequence[str | int], schema: dict[str, Any]) -> str | Phrase:
    names = [name for kind in kinds(_node(place, schema), schema) for name in kind.get("enum", [])]
    return near_miss(value, [*names, *also_called(names)]) if isinstance(value, str) else ""


def _dotted(place: Sequence[str | int]) -> str:
    parts = [
        f"[{part}]" if isinstance(part, int) else f".{_cut(part)}" for part in place if not _is_tag(part)
    ]
    return "".join(parts).removeprefix(".")


def _is_tag(part: str | int) -> bool:
    """Tell the tag of one of several tables from a key."""
    return str(part).startswith("<")


def shown(value: object) -> str | Phrase:
    """Return a value of the input as a sentence quotes it, the end left out; a table as "a table"."""
    if isinstance(value, dict):
        return phrase("scenario.table")
    if isinstance(value, str):
        return _cut(repr(value))
    try:
        written = json.dumps(value, ensure_ascii=False)
    except (TypeError, ValueError):
        written = str(value)
    return _cut(written)


def _cut(text: str) -> str:
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}…"


def kinds(node: dict[str, Any], schema: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the plain kinds of value that a node of the schema allows, references followed."""
    if "$ref" in node:
        return kinds(schema["$defs"][node["$ref"].rsplit("/", 1)[-1]], schema)
    several = node.get("anyOf") or node.get("oneOf")
    if several:
        return [kind for option in several if option.get("type") != "null" for kind in kinds(option, schema)]
    return [node]


def _tagged(node: dict[str, Any], tag: str, schema: dict[str, Any]) -> dict[str, Any]:
    """Return the one of several tables that a tag names: by its type, or by a key that only it has."""
    for kind in kinds(node, schema):
        properties = kind.get("properties", {})
        if properties.get("type", {}).get("const") == tag or tag in properties:
            return kind
    return node


def _node(place: Sequence[str | int], schema: dict[str, Any]) -> dict[str, Any]:
    node = schema
    for part in place:
        if _is_tag(part):
            node = _tagged(node, str(part).strip("<>"), schema)
            continue
        for kind in kinds(node, schema):
            if isinstance(part, int) and "items" in kind:
                node = kind["items"]
                break
            if part in kind.get("properties", {}):
                node = kind["properties"][part]
                break
            if kind.get("additionalProperties"):
                node = kind["additionalProperties"]
                break
    return node


def _allowed(node: dict[str, Any], schema: dict[str, Any], value: object = None) -> Phrase:
    """Return what a node of the schema allows, in words; where a name was given, no table beside names."""
    allowed = kinds(node, schema)
    if isinstance(value, str) and any("enum" in kind for kind in allowed):
        allowed = [kind for kind in allowed if "properties" not in kind]
    if sum("properties" in kind for kind in allowed) > 1:
        return phrase("scenario.one_of_tables")
    first, *others = (_in_words(kind, schema) for kind in allowed)
    english, japanese = (
        say("scenario.or", language).join(
            [first[n], *(other[n].replace(first[n], say("scenario.like_that", language)) for other in others)]
        )
        for n, language in enumerate(LANGUAGES)
    )
    return english, japanese


def _in_words(kind: dict[str, Any], schema: dict[str, Any]) -> Phrase:
    unit = f" {kind['unit']}" if "unit" in kind else ""
    if "const" in kind:
        value = repr(kind["const"])
        return value, value
    if "enum" in kind:
        return phrase("scenario.one_of", names=listed(kind["enum"]))
    match kind.get("type"):
        case "integer":
            low, high = kind["minimum"], kind["maximum"]
            return phrase("scenario.whole_number", low=low, high=high, unit=unit)
        case "number":
            return phrase("scenario.number", low=kind["minimum"], high=kind["maximum"], unit=unit)
        case "boolean":
            return phrase("scenario.true_or_false")
        case "array":
            few, many = kind.get("minItems", 0), kind["maxItems"]
            count = str(few) if few == many else phrase("scenario.few_to_many", few=few, many=many)
            return phrase("scenario.list", count=count, item=_allowed(kind["items"], schema))
        case "object":
            by_name = phrase("scenario.names_of_pieces")
            return phrase("scenario.table_of", keys=", ".join(kind.get("properties", ())) or by_name)
        case _:
            return phrase("scenario.text", few=kind["minLength"], many=kind["maxLength"])


LARGEST_FILE = 1024 * 1024
"""Largest scenario file [bytes]."""

MOST_EXTRA_PARTS = 300
"""Most parts of a file's dotted keys beyond two each."""

DEEPEST = 16
"""Deepest nesting of brackets and braces."""

_LITERAL = re.compile(  # strings and comments, up to their end where they are closed, or the file's or line's
    r'"""(?:[^"\\]|\\[\s\S]?|"(?!""))*+"{0,5}'
    r"|'''(?:[^']|'(?!''))*+'{0,5}"
    r'|"(?:[^"\\\n]|\\[^\n]?)*+"?'
    r"|'[^'\n]*+'?"
    r"|#[^\n]*+"
)
_BRACKET = re.compile(r"[\[\]{}]")
_BETWEEN_KEYS = re.compile(r"[=,{}\[\]\n]")

_KEY = re.compile(r"[^.\[\]=\s]+(?:\[\d{1,4}\])*(?:\.[^.\[\]=\s]+(?:\[\d{1,4}\])*)*", re.ASCII)
_STEP = re.compile(r"\[(\d+)\]|([^.\[\]]+)", re.ASCII)


def read_toml(file: Path) -> dict[str, object]:
    """Return the keys and values of a TOML file.

    Parameters
    ----------
    file : Path
        The file, UTF-8.

    Raises
    ------
    InputError
        It cannot be read, is too large, is not TOML, or has keys, brackets or numbers beyond the bounds.
    """
    try:
        if file.exists() and not (file.is_file() or file.is_dir()):  # a pipe that nobody writes to never ends
            raise _refused(file, "not_read", reason=phrase("motion.a_device"))
        with file.open("rb") as opened:
            data = opened.read(LARGEST_FILE + 1)
    except InputError:
        raise
    except (OSError, ValueError) as error:  # ValueError: a zero byte in the path
        raise _refused(file, "not_read", reason=reason_of(error)) from None
    return table_of_bytes(data, file)


def table_of_bytes(data: bytes, file: Path) -> dict[str, Any]:
    """Return the keys and values of a TOML file's bytes, UTF-8.

    Parameters
    ----------
    data : bytes
        The bytes; of a file beyond the bound its beginning is enough.
    file : Path
        What a refusal calls the file.

    Raises
    ------
    InputError
        As `read_toml`.
    """
    if len(data) > LARGEST_FILE:
        raise _refused(file, "too_long", most=LARGEST_FILE)
    try:
        return table_of_toml(data.decode("utf-8-sig"), file)
    except UnicodeDecodeError:
        raise _refused(file, "not_utf8") from None


def table_of_toml(text: str, file: Path) -> dict[str, Any]:
    """Return the keys and values of a TOML file's text.

    Parameters
    ----------
    text : str
        The text.
    file : Path
        What a refusal calls the file.

    Raises
    ------
    InputError
        It is not TOML, or has keys, brackets or numbers beyond the bounds.
    """
    _refuse_excess(file, text)
    try:
        table = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise _refused(file, "not_toml", reason=error) from None
    except (ValueError, RecursionError):  # of int(), which reads at most 4300 digits
        raise _refused(file, "long_number") from None
    if any(not -(2**63) <= number < 2**63 for number in _whole_numbers(table)):
        raise _refused(file, "long_number")
    return table


def _refused(file: Path, why: str, **values: object) -> InputError:
    reason = phrase(f"scenario.file_{why}", **values)
    return InputError("scenario.file", file=repr(str(file)), reason=reason)


def _refuse_excess(file: Path, text: str) -> None:
    """Refuse what goes beyond the bounds; the text is not yet known to be TOML."""
    bare = _LITERAL.sub(lambda match: "" if match[0].startswith("#") else "s", text)
    depth = 0
    for bracket in _BRACKET.finditer(bare):
        depth = depth + 1 if bracket[0] in "[{" else max(0, depth - 1)
        if depth > DEEPEST:
            raise _refused(file, "too_deep", most=DEEPEST)
    dots = (part.count(".") for part in _BETWEEN_KEYS.split(bare))
    extra = sum(count - 1 for count in dots if count > 1)
    if extra > MOST_EXTRA_PARTS:
        raise _refused(file, "long_keys", count=extra, most=MOST_EXTRA_PARTS)


def _whole_numbers(value: object) -> Iterator[int]:
    if isinstance(value, int):
        yield value
    elif isinstance(value, dict):
        for item in cast("dict[str, Any]", value).values():
            yield from _whole_numbers(item)
    elif isinstance(value, list):
        for item in cast("list[Any]", value):
            yield from _whole_numbers(item)


def steps_of(key: str) -> tuple[str | int, ...]:
    """Return the names and places of a key such as ``furniture[1].mass``; none of another text."""
    steps = _STEP.findall(key) if _KEY.fullmatch(key) else []
    return tuple(int(place) if place else name for place, name in steps)


def with_value(tables: dict[str, Any], key: str, value: object) -> dict[str, Any]:
    """Return tables with another value at a key; they themselves stay as they are.

    Parameters
    ----------
    tables : dict
        Keys and values of a file.
    key : str
        A dotted key. Below a list it is that of all its items, or of the one whose place is in brackets; the
        place behind the last adds one.
    value : object
        The value.

    Raises
    ------
    InputError
        No such key: a place of what is no list, or beyond its end.
    """

    def placed(node: Any, steps: tuple[str | int, ...]) -> Any:
        if not steps:
            return value
        step, below = steps[0], steps[1:]
        if isinstance(step, int):
            items = cast("list[Any]", node or [])
            if not isinstance(node, list | None) or step > len(items):
                raise InputError("scenario.no_such_path", key, path=key)
            item = items[step] if step < len(items) else None
            return [*items[:step], placed(item, below), *items[step + 1 :]]
        if isinstance(node, list):
            return [placed(item, steps) for item in cast("list[Any]", node)]
        table = cast("dict[str, Any]", node if isinstance(node, dict) else {})
        return {**table, step: placed(table.get(step), below)}

    steps = steps_of(key)
    if not steps:
        raise InputError("scenario.no_such_path", key, path=key)
    return placed(tables, steps)
