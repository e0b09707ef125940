"""The description of the API (OpenAPI 3.1), with the schemas of scenes and measures, and as a plain page."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any, cast

from jinja2 import Environment, PackageLoader
from pydantic import TypeAdapter
from starlette.responses import HTMLResponse, Response
from starlette.routing import Route

from stayput.app.requests import STANDS_FOR
from stayput.scenario import AssemblyScenario, Scenario
from stayput.scenario.measures import MeasureTable, SingleChoice
from stayput.scenario.room import RoomScenario

if TYPE_CHECKING:
    from collections.abc import Callable

    from fastapi import FastAPI
    from starlette.requests import Request

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


def docs_route(app: FastAPI) -> Route:
    """Return the route of the page that describes the API, with nothing loaded from elsewhere."""
    loader = PackageLoader("stayput.app", "templates")
    template = Environment(loader=loader, autoescape=True).get_template("api.html")

    async def serve(_request: Request) -> Response:
        return HTMLResponse(template.render(api=app.openapi(), name=_name, kind=kind_of))

    return Route("/api/docs", serve)


def _name(reference: str) -> str:
    return reference.rsplit("/", 1)[-1]


def kind_of(node: dict[str, Any]) -> list[tuple[str, str | None]]:
    """Return a schema's kind in words, as pieces of text with the name of the schema each links to."""
    if "$ref" in node:
        name = _name(node["$ref"])
        return [(name, name)]
    for key in ("anyOf", "oneOf"):
        if key in node:
            parts = [part for inner in node[key] for part in [(" or ", None), *kind_of(inner)]]
            return parts[1:]
    if "const" in node:
        return [(repr(node["const"]), None)]
    if "enum" in node:
        return [("one of " + ", ".join(map(repr, node["enum"])), None)]
    if node.get("type") == "array":
        if "prefixItems" in node:
            parts = [part for inner in node["prefixItems"] for part in [(", ", None), *kind_of(inner)]][1:]
            return [("[", None), *parts, ("]", None)]
        return [("list of ", None), *kind_of(node.get("items", {}))]
    return [(_bounds(node), None)]


def _bounds(node: dict[str, Any]) -> str:
    words = str(node.get("type", "anything"))
    low, high = node.get("minimum"), node.get("maximum")
    if low is not None and high is not None:
        words += f" from {low:g} to {high:g}"
    return f"{words} {node['unit']}" if node.get("unit") else words
