"""The page's files, out of the package, and the description of the API as a plain page."""

from __future__ import annotations

import hashlib
from importlib import resources
from typing import TYPE_CHECKING, Any

from jinja2 import Environment, PackageLoader
from starlette.responses import HTMLResponse, Response
from starlette.routing import Route

if TYPE_CHECKING:
    from collections.abc import Iterator
    from importlib.resources.abc import Traversable

    from fastapi import FastAPI
    from starlette.requests import Request

KINDS = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".json": "application/json",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".ico": "image/x-icon",
    ".woff2": "font/woff2",
}
"""Kinds of file that are served."""


def page_files() -> dict[str, Traversable]:
    """Return the files of the page by their paths: those that exist now, and no others."""
    return dict(_walk(resources.files("stayput.app").joinpath("page"), ""))


def _walk(folder: Traversable, place: str) -> Iterator[tuple[str, Traversable]]:
    if not folder.is_dir():
        return
    for one in folder.iterdir():
        path = f"{place}/{one.name}"
        if one.is_dir():
            yield from _walk(one, path)
        elif any(one.name.endswith(suffix) for suffix in KINDS):
            yield path, one


def page_routes() -> list[Route]:
    """Return a route for each file, and / for index.html."""
    files = page_files()
    routes = [Route(path, _serving(file)) for path, file in sorted(files.items())]
    if "/index.html" in files:
        routes.append(Route("/", _serving(files["/index.html"])))
    return routes


def _serving(file: Traversable) -> Any:
    kind = next(kind for suffix, kind in KINDS.items() if file.name.endswith(suffix))

    async def serve(request: Request) -> Response:
        content = file.read_bytes()
        tag = f'"{hashlib.sha256(content).hexdigest()[:32]}"'
        headers = {"ETag": tag, "Cache-Control": "no-cache"}
        if request.headers.get("if-none-match") == tag:
            return Response(status_code=304, headers=headers)
        return Response(content, headers={**headers, "Content-Type": kind})

    return serve


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
            pieces = [piece for one in node[key] for piece in [(" or ", None), *kind_of(one)]]
            return pieces[1:]
    if "const" in node:
        return [(repr(node["const"]), None)]
    if "enum" in node:
        return [("one of " + ", ".join(map(repr, node["enum"])), None)]
    if node.get("type") == "array":
        if "prefixItems" in node:
            inside = [piece for one in node["prefixItems"] for piece in [(", ", None), *kind_of(one)]][1:]
            return [("[", None), *inside, ("]", None)]
        return [("list of ", None), *kind_of(node.get("items", {}))]
    return [(_bounds(node), None)]


def _bounds(node: dict[str, Any]) -> str:
    words = str(node.get("type", "anything"))
    low, high = node.get("minimum"), node.get("maximum")
    if low is not None and high is not None:
        words += f" from {low:g} to {high:g}"
    return f"{words} {node['unit']}" if node.get("unit") else words
