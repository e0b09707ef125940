"""The description of the API (OpenAPI 3.1), with the schemas of scenes and measures."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any, cast

from pydantic import TypeAdapter

from stayput.app.requests import STANDS_FOR
from stayput.scenario import AssemblyScenario, Scenario
from stayput.scenario.measures import MeasureTable, SingleChoice
from stayput.scenario.room import RoomScenario

if TYPE_CHECKING:
    from collections.abc import Callable

    from fastapi import FastAPI

REFERENCE = "#/components/schemas/{model}"
"""Where a schema stands."""

UNUSED = ("HTTPValidationError", "ValidationError")
"""FastAPI's own form of errors, which this server does not use."""


def described(app: FastAPI) -> Callable[[], dict[str, Any]]:
    """Return the function that makes the description of an app, once."""
    generate = app.openapi

    @cache
    def description() -> dict[str, Any]:
        document = generate()
        schemas = document["components"]["schemas"]
        scene = Scenario.schema(ref_template=REFERENCE)
        measure = TypeAdapter[MeasureTable](SingleChoice).json_schema(ref_template=REFERENCE)
        pieces = AssemblyScenario.model_json_schema(ref_template=REFERENCE)
        schemas |= {**pieces.pop("$defs"), "AssemblyScenario": pieces}
        schemas |= {**scene.pop("$defs"), "Scenario": scene}
        room = RoomScenario.model_json_schema(ref_template=REFERENCE)
        schemas |= {**room.pop("$defs"), "RoomScenario": room}
        kinds = ("Scenario", "AssemblyScenario", "RoomScenario")
        either = [{"$ref": REFERENCE.format(model=model)} for model in kinds]
        schemas["AnyScene"] = {"anyOf": either}
        measure.pop("$defs", None)
        schemas["Measure"] = measure
        for name in UNUSED:
            schemas.pop(name, None)
        return _placed(document)

    return description


def _placed(node: Any) -> Any:
    """Return a schema with references in place of marks."""
    if isinstance(node, list):
        return [_placed(item) for item in cast("list[Any]", node)]
    if not isinstance(node, dict):
        return node
    table = cast("dict[str, Any]", node)
    if STANDS_FOR in table:
        return {"$ref": REFERENCE.format(model=table[STANDS_FOR])}
    return {key: _placed(value) for key, value in table.items()}
