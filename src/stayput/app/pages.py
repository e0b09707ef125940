"""Routes of the pages: their static files, and their texts as a module of JavaScript."""

from __future__ import annotations

import hashlib
import json
import mimetypes
from importlib import resources
from typing import TYPE_CHECKING

from starlette.exceptions import HTTPException
from starlette.responses import RedirectResponse, Response
from starlette.routing import Mount, Route
from starlette.staticfiles import StaticFiles

from stayput.catalogue import LANGUAGES, TEXTS, page, room_page, room_plan

if TYPE_CHECKING:
    from starlette.requests import Request
    from starlette.types import Scope

WORDS = "/words_table.js"
"""Path of the page's texts: a module made from the catalogue."""

# Windows reads the kinds of files from its registry, where programs may have changed them; a browser runs no
# module of another kind.
mimetypes.add_type("text/javascript", ".js")


class PackageFiles(StaticFiles):
    """Files of the package that the page loads; everything else that nobody serves is not found."""

    def __init__(self, package: str, folder: str) -> None:
        super().__init__(packages=[(package, folder)], html=True)
        # Only names that are there are looked up: others may be too long for the file system, or no names.
        files = resources.files(package).joinpath(folder)
        self._names = {".", *(file.name for file in files.iterdir())}

    async def get_response(self, path: str, scope: Scope) -> Response:
        """Return a file, or that it has not changed; a browser asks each time."""
        if path not in self._names:
            raise HTTPException(404)
        response = await super().get_response(path, scope)
        response.headers["Cache-Control"] = "no-cache"
        return response


def page_routes() -> list[Mount | Route]:
    """Return the routes of the page; they take all paths that those before them do not."""
    parts = (page, room_page, room_plan)
    texts = {name.rpartition(".")[2]: TEXTS[name] for part in parts for name in part.SHARED}
    for part in parts:
        texts |= part.TEXTS
    tables = {
        language: {key: text[place] for key, text in texts.items()}
        for place, language in enumerate(LANGUAGES)
    }
    content = f"export const TABLES = {json.dumps(tables, ensure_ascii=False)};\n"
    headers = {"Cache-Control": "no-cache", "ETag": f'"{hashlib.sha256(content.encode()).hexdigest()[:32]}"'}

    async def to_room(request: Request) -> Response:
        return RedirectResponse("room/")  # its files are beside it

    async def words(request: Request) -> Response:
        if request.headers.get("if-none-match") == headers["ETag"]:
            return Response(status_code=304, headers=headers)
        return Response(content, headers=headers, media_type="text/javascript")

    drawing = Mount("/canvas", PackageFiles("stayput.report", "canvas"))  # what the HTML files draw with too
    room = Mount("/room", PackageFiles("stayput.app", "room_page"))
    bare = Route("/room", to_room)
    return [Route(WORDS, words), drawing, bare, room, Mount("/", PackageFiles("stayput.app", "page"))]
