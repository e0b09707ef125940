"""One plain sentence for what a scenario file gets wrong; what is allowed is read from the JSON Schema."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, cast

from stayput.catalogue import LANGUAGES, Phrase, phrase, say
from stayput.errors import InputError, near_miss, unknown
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
    name = _dotted(place) if not within else f"{within}.{_dotted(place)}"
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
