"""Writing a scenario as TOML: what was said, and nothing that was left to its default."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, cast

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from stayput.scenario.scenario import Scenario


def scenario_toml(scenario: Scenario) -> str:
    """Return a scenario's file: parsed again, it is the same scenario.

    Parameters
    ----------
    scenario : Scenario
        The scenario.

    Examples
    --------
    >>> from stayput import Scenario
    >>> print(scenario_toml(Scenario.parse({"furniture": {"preset": "chest"}})), end="")
    [furniture]
    preset = "chest"
    """
    said = scenario.model_dump(mode="json", exclude_unset=True, exclude_none=True, by_alias=True)
    return "\n".join(_table(said, ())).strip() + "\n"


def _table(values: Mapping[str, Any], place: tuple[str, ...]) -> Iterator[str]:
    """Give the lines of a table: its plain values first, then its tables, each under a heading."""
    tables: dict[str, dict[str, Any]] = {k: value for k, value in values.items() if isinstance(value, dict)}
    lists = {key: value for key, value in values.items() if _is_list_of_tables(value)}
    for key, value in values.items():
        if key not in tables and key not in lists:
            yield f"{key} = {_inline(value)}"
    for key, inside in tables.items():
        # a heading is needed where plain values follow it, and where nothing does
        if not inside or any(not isinstance(one, dict) for one in inside.values()):
            yield f"\n[{'.'.join((*place, key))}]"
        yield from _table(inside, (*place, key))
    for key, value in lists.items():
        for one in cast("list[dict[str, Any]]", value):
            yield f"\n[[{'.'.join((*place, key))}]]"
            yield from (f"{name} = {_inline(inside)}" for name, inside in one.items())


def _is_list_of_tables(value: object) -> bool:
    return isinstance(value, list) and any(isinstance(one, dict) for one in cast("list[object]", value))


def _inline(value: Any) -> str:
    """Return a value as it stands behind an equals sign."""
    if isinstance(value, dict):
        inside = cast("dict[str, Any]", value)
        return "{ " + ", ".join(f"{key} = {_inline(one)}" for key, one in inside.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(_inline(one) for one in cast("list[Any]", value)) + "]"
    if isinstance(value, str):
        # TOML takes JSON's escapes, but wants the one control character escaped that JSON does not
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007F")
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(value)
