"""The description of the API (OpenAPI 3.1), with the schemas of scenes and measures in it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

from pydantic import TypeAdapter

from stayput.app.fields import STANDS_FOR
from stayput.scenario import Scenario
from stayput.scenario.measures import MeasureTable, SingleChoice

if TYPE_CHECKING:
    from collections.abc import Callable

    from fastapi import FastAPI

REFERENCE = "#/components/schemas/{model}"
"""Where a schema stands."""

UNUSED = ("HTTPValidationError", "ValidationError")
"""FastAPI's own form of errors, which this server does not use."""


def described(app: FastAPI) -> Callable[[], dict[str, Any]]:
    """Return what makes the description of an app; it is made once."""
    made = app.openapi
    kept: dict[str, Any] = {}

    def description() -> dict[str, Any]:
        if not kept:
            found = made()
            schemas = found["components"]["schemas"]
            scene = Scenario.schema(ref_template=REFERENCE)
            measure = TypeAdapter[MeasureTable](SingleChoice).json_schema(ref_template=REFERENCE)
            schemas |= {**scene.pop("$defs"), "Scenario": scene}
            measure.pop("$defs", None)
            schemas["Measure"] = measure
            for name in UNUSED:
                schemas.pop(name, None)
            kept.update(_placed(found))
        return kept

    return description


def _placed(node: Any) -> Any:
    """Return a schema with references in place of marks."""
    if isinstance(node, list):
        return [_placed(one) for one in cast("list[Any]", node)]
    if not isinstance(node, dict):
        return node
    table = cast("dict[str, Any]", node)
    if STANDS_FOR in table:
        return {"$ref": REFERENCE.format(model=table[STANDS_FOR])}
    return {key: _placed(value) for key, value in table.items()}
