"""One plain sentence for what a scenario file gets wrong; what is allowed is read from the JSON Schema."""

from __future__ import annotations

import json
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

    from pydantic_core import ErrorDetails

_LONGEST = 60  # characters of a value that are shown


def sentence_of(errors: Sequence[ErrorDetails], schema: dict[str, Any]) -> str:
    """Return the sentence for the first error, unknown keys first: a misspelt key is the cause, not a sign.

    Parameters
    ----------
    errors : sequence of ErrorDetails
        What pydantic found.
    schema : dict
        The scenario's JSON Schema.
    """
    error = min(errors, key=lambda one: one["type"] != "extra_forbidden")
    place = error["loc"]
    name = _dotted(place)
    if error["type"] == "extra_forbidden":
        return _unknown(place, schema)
    if error["type"] == "value_error" and (said := str(error.get("ctx", {}).get("error", ""))):
        return said
    allowed = _allowed(_node(place, schema), schema)
    if error["type"] == "missing":
        return f"{name} is missing; it must be {allowed}."
    hint = _hint(error["input"], place, schema)
    return f"{name} is {_shown(error['input'])}{hint}; it must be {allowed}."


def _unknown(place: Sequence[str | int], schema: dict[str, Any]) -> str:
    name = _dotted(place)
    known = [key for kind in kinds(_node(place[:-1], schema), schema) for key in kind.get("properties", {})]
    near = get_close_matches(str(place[-1]), known, 1)
    hint = f" (did you mean {near[0]!r}?)" if near else ""
    table = _dotted(place[:-1])
    where = f"a key of [{table}]" if table else "a top-level key"
    return f"{name} is unknown{hint}; {where} must be one of {', '.join(known)}."


def _hint(value: object, place: Sequence[str | int], schema: dict[str, Any]) -> str:
    names = [name for kind in kinds(_node(place, schema), schema) for name in kind.get("enum", [])]
    near = get_close_matches(value, names, 1) if isinstance(value, str) else []
    return f" (did you mean {near[0]!r}?)" if near else ""


def _dotted(place: Sequence[str | int]) -> str:
    parts = [f"[{part}]" if isinstance(part, int) else f".{part}" for part in place if not _is_tag(part)]
    return "".join(parts).removeprefix(".")


def _is_tag(part: str | int) -> bool:
    """Tell the tag of one of several tables from a key."""
    return str(part).startswith("<")


def _shown(value: object) -> str:
    if isinstance(value, dict):
        return "a table"
    try:
        shown = json.dumps(value, ensure_ascii=False)
    except (TypeError, ValueError):
        shown = str(value)
    return shown if len(shown) <= _LONGEST else f"{shown[:_LONGEST]}…"


def kinds(node: dict[str, Any], schema: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the plain kinds of value that a node of the schema allows, references followed."""
    if "$ref" in node:
        return kinds(schema["$defs"][node["$ref"].rsplit("/", 1)[-1]], schema)
    several = node.get("anyOf") or node.get("oneOf")
    if several:
        return [kind for one in several if one.get("type") != "null" for kind in kinds(one, schema)]
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
    return node


def _allowed(node: dict[str, Any], schema: dict[str, Any]) -> str:
    allowed = kinds(node, schema)
    if sum("properties" in kind for kind in allowed) > 1:
        return "a table with type or combine"
    return " or ".join(_kind_in_words(kind, schema) for kind in allowed)


def _kind_in_words(kind: dict[str, Any], schema: dict[str, Any]) -> str:
    unit = f" {kind['unit']}" if "unit" in kind else ""
    if "const" in kind:
        return json.dumps(kind["const"])
    if "enum" in kind:
        return f"one of {', '.join(map(json.dumps, kind['enum']))}"
    match kind.get("type"):
        case "integer":
            return f"a whole number between {kind['minimum']:g} and {kind['maximum']:g}{unit}"
        case "number":
            return f"a number between {kind['minimum']:g} and {kind['maximum']:g}{unit}"
        case "boolean":
            return "true or false"
        case "array":
            few, many = kind["minItems"], kind["maxItems"]
            count = f"{few}" if few == many else f"{few} to {many}"
            return f"a list of {count} items, each {_allowed(kind['items'], schema)}"
        case "object":
            return f"a table of {', '.join(kind['properties'])}"
        case _:
            return f"a text of {kind['minLength']} to {kind['maxLength']} characters"
