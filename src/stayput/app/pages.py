"""Routes of the pages: the files that they are made of, and their texts."""

from __future__ import annotations

import json
import mimetypes
from functools import cache
from importlib import resources
from typing import TYPE_CHECKING

from jinja2 import Environment, PackageLoader, StrictUndefined
from starlette.exceptions import HTTPException
from starlette.responses import RedirectResponse, Response
from starlette.routing import Mount, Route
from starlette.staticfiles import StaticFiles

from stayput.catalogue import LANGUAGES, TEXTS, earthquake, page, room_page
from stayput.report.page import inks_css

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable

    from starlette.requests import Request
    from starlette.types import Scope

    from stayput.catalogue import Language

FOLDERS = {
    "": ("stayput.app", "page"),
    "room": ("stayput.app", "room_page"),
    "canvas": ("stayput.report", "canvas"),
}
"""The folders of the pages' files in the package, by their paths on the server."""

SHARED = (*page.SHARED, *room_page.SHARED)
"""Texts of other modules that the pages say too; the last parts of their ids are their keys."""

PAGES = ("", "room")
ASKED_EACH_TIME = {"Cache-Control": "no-cache"}
"""A browser asks each time whether a file has changed."""

# Windows reads the kinds of files from its registry, where programs may have changed them; a browser runs no
# module of another kind.
mimetypes.add_type("text/javascript", ".js")


class PackageFiles(StaticFiles):
    """Files of the package that the page loads; everything else that nobody serves is not found."""

    def __init__(self, package: str, folder: str) -> None:
        super().__init__(packages=[(package, folder)])
        # Only names that are there are looked up: others may be too long for the file system, or no names.
        self._names = _names(package, folder)

    async def get_response(self, path: str, scope: Scope) -> Response:
        """Return a file, or that it has not changed."""
        if path not in self._names:
            raise HTTPException(404)
        response = await super().get_response(path, scope)
        response.headers.update(ASKED_EACH_TIME)
        return response


def _names(package: str, folder: str) -> list[str]:
    return sorted(file.name for file in resources.files(package).joinpath(folder).iterdir())


@cache
def page_of(folder: str) -> str:
    """Return a page: its file, with what both pages have, and with all modules asked for at once."""
    templates = Environment(
        loader=PackageLoader("stayput.app"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    package, name = FOLDERS[folder]
    # A browser that learned of each module from the one that imports it would wait for one after the other.
    needed = dict.fromkeys(("", "canvas", folder))
    modules = [f"{path}/{file}" for path in needed for file in _names(*FOLDERS[path]) if file.endswith(".js")]
    home = "../" if folder else ""
    html = resources.files(package).joinpath(name, "index.html").read_text(encoding="utf-8")
    return templates.from_string(html).render(modules=[home + module.lstrip("/") for module in modules])


@cache
def words(language: Language) -> dict[str, str]:
    """Return the texts of both pages in a language by their keys."""
    place = LANGUAGES.index(language)
    texts = {name.rpartition(".")[2]: TEXTS[name] for name in SHARED}
    for part in (page, earthquake, room_page):
        texts |= part.TEXTS
    return {key: text[place] for key, text in texts.items()}


def page_routes() -> list[Mount | Route]:
    """Return the routes of the pages; they take all paths that those before them do not."""
    tables = json.dumps({language: words(language) for language in LANGUAGES}, ensure_ascii=False)

    async def to_room(_request: Request) -> Response:
        return RedirectResponse("room/")

    return [
        *(
            Route(f"/{folder}/{name}".replace("//", "/"), _file(page_of(folder), "text/html"))
            for folder in PAGES
            for name in ("", "index.html")
        ),
        Route("/canvas/inks.css", _file(inks_css(), "text/css")),
        Route("/words_table.js", _file(f"export const TABLES = {tables};\n", "text/javascript")),
        Route("/room", to_room),
        *(Mount(f"/{path}".rstrip("/"), PackageFiles(*folder)) for path, folder in reversed(FOLDERS.items())),
    ]


def _file(text: str, kind: str) -> Callable[[Request], Awaitable[Response]]:
    """Return what answers with a text that does not change while the server runs."""

    async def answer(_request: Request) -> Response:
        return Response(text, headers=ASKED_EACH_TIME, media_type=kind)

    return answer
