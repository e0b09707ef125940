"""Routes of the pages: each with one script, the static files that these are made of, and the texts."""

from __future__ import annotations

import gzip
import hashlib
import json
import mimetypes
from dataclasses import dataclass, field
from functools import cache
from importlib import resources
from typing import TYPE_CHECKING

from jinja2 import Environment, PackageLoader, StrictUndefined
from starlette.exceptions import HTTPException
from starlette.responses import RedirectResponse, Response
from starlette.routing import Mount, Route
from starlette.staticfiles import StaticFiles

from stayput.app.bundle import bundled, entry_of, page_with
from stayput.app.middleware import takes_gzip
from stayput.catalogue import LANGUAGES, TEXTS, earthquake, page, page_keep, room_page, room_plan

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from importlib.resources.abc import Traversable

    from starlette.requests import Request
    from starlette.types import Scope

    from stayput.catalogue import Language

WORDS = "/words_table.js"
"""Path of the page's texts: a module made from the catalogue."""

FOLDERS = {
    "": ("stayput.app", "page"),
    "room": ("stayput.app", "room_page"),
    "canvas": ("stayput.report", "canvas"),
}
"""The folders of the pages' files in the package, by their paths on the server."""

OF_A_PIECE = (page, page_keep, earthquake)
TEXTS_OF = {"": OF_A_PIECE, "room": (*OF_A_PIECE, room_page, room_plan)}
"""Where the texts of each page are, by its folder: that of rooms has parts of the page of one piece."""

SHARED = (*page.SHARED, *room_page.SHARED, *room_plan.SHARED)
"""Texts of other modules that the pages say too; the last parts of their ids are their keys."""

ASKED_EACH_TIME = "no-cache"
KEPT = "public, max-age=31536000, immutable"
"""What a browser does with a file: asks each time whether it has changed; keeps one that its hash names."""

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
        response.headers["Cache-Control"] = ASKED_EACH_TIME
        return response


@dataclass(frozen=True)
class MadeFile:
    """A file that the server makes, compressed once.

    Parameters
    ----------
    content : str
        Its text.
    kind : str
        Its media type.
    caching : str
        Its Cache-Control.
    """

    content: str
    kind: str
    caching: str = ASKED_EACH_TIME
    hash: str = field(init=False)
    packed: bytes = field(init=False)

    def __post_init__(self) -> None:
        data = self.content.encode()
        object.__setattr__(self, "hash", hashlib.sha256(data).hexdigest()[:16])
        object.__setattr__(self, "packed", gzip.compress(data, 9, mtime=0))

    def response(self, request: Request) -> Response:
        """Return the file, or that it has not changed."""
        headers = {
            "Cache-Control": self.caching,
            "ETag": f'"{self.hash}"',
            "Vary": "Accept-Encoding" if self.caching == KEPT else "Accept-Encoding, Accept-Language",
        }
        if request.headers.get("if-none-match") == headers["ETag"]:
            return Response(status_code=304, headers=headers)
        if not takes_gzip(request.headers):
            return Response(self.content, headers=headers, media_type=self.kind)
        headers["Content-Encoding"] = "gzip"
        return Response(self.packed, headers=headers, media_type=self.kind)


@dataclass(frozen=True)
class MadeFiles:
    """What is made for the readers of one language.

    Parameters
    ----------
    pages : mapping of MadeFile
        The pages, by their paths.
    words : MadeFile
        The module of texts, in this language alone.
    kept : mapping of MadeFile
        What a browser keeps, by names with their hashes.
    """

    pages: Mapping[str, MadeFile]
    words: MadeFile
    kept: Mapping[str, MadeFile]


def tables(folder: str) -> dict[Language, dict[str, str]]:
    """Return the texts of a page by their keys, in each language."""
    words = {name.rpartition(".")[2]: TEXTS[name] for name in SHARED}
    for part in TEXTS_OF[folder]:
        words |= part.TEXTS
    return {
        language: {key: text[place] for key, text in words.items()}
        for place, language in enumerate(LANGUAGES)
    }


@cache
def made(language: Language) -> MadeFiles:
    """Return what is made for the readers of a language; the words of the others are files that it names."""
    files, pages, kept, words = _files(), dict[str, MadeFile](), dict[str, MadeFile](), ""
    for folder in TEXTS_OF:
        texts = {
            one: MadeFile(json.dumps(table, ensure_ascii=False), "application/json", KEPT)
            for one, table in tables(folder).items()
        }
        names = {one: f"words-{one}-{text.hash}.json" for one, text in texts.items()}
        kept |= {names[one]: text for one, text in texts.items()}
        spoken = tables(folder)[language]
        words = "".join(
            f"export const {name} = {json.dumps(values, ensure_ascii=False)};\n"
            for name, values in (("LANGUAGES", LANGUAGES), ("FILES", names), ("TABLES", {language: spoken}))
        )
        html = files[f"{folder}/index.html".lstrip("/")]
        entry = f"{folder}/{entry_of(html)}".lstrip("/")
        script = MadeFile(bundled({**files, WORDS[1:]: words}, entry), "text/javascript", KEPT)
        name = f"{folder or 'page'}-{language}-{script.hash}.js"
        kept[name] = script
        address = "../" * bool(folder) + name
        place = f"/{folder}/".replace("//", "/")
        pages[place] = MadeFile(page_with(html, files, folder, address, language, spoken), "text/html")
        pages[f"{place}index.html"] = MadeFile(html, "text/html")
    # the texts of the last page, which has those of the others too, are the module that the files load
    return MadeFiles(pages, MadeFile(words, "text/javascript"), kept)


def _files() -> dict[str, str]:
    """Return the texts of the files that pages are made of, by their paths on the server.

    Pages get what both have from `templates/page_parts.html`.
    """
    templates = Environment(
        loader=PackageLoader("stayput.app"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )

    def text(file: Traversable) -> str:
        written = file.read_text(encoding="utf-8")
        return templates.from_string(written).render() if file.name.endswith(".html") else written

    return {
        f"{path}/{file.name}".lstrip("/"): text(file)
        for path, (package, folder) in FOLDERS.items()
        for file in resources.files(package).joinpath(folder).iterdir()
        if file.name.endswith((".html", ".css", ".js"))
    }


def language_of(request: Request) -> Language:
    """Return the first language that a browser asks for, of those there are; English for others."""
    for tag in request.headers.get("accept-language", "").lower().split(","):
        for language in LANGUAGES:
            if tag.strip()[:2] == language:
                return language
    return LANGUAGES[0]


def page_routes() -> list[Mount | Route]:
    """Return the routes of the page; they take all paths that those before them do not.

    The page at ``/`` has one script; ``/index.html`` and the modules that it loads are the files themselves.
    """
    first = made(LANGUAGES[0])
    spoken = [
        *(_route(path, lambda files, path=path: files.pages[path]) for path in first.pages),
        _route(WORDS, lambda files: files.words),
    ]
    kept = [
        _route(f"/{name}", lambda _, file=file: file)
        for language in LANGUAGES
        for name, file in made(language).kept.items()
    ]
    folders = [
        Mount(f"/{path}".rstrip("/"), PackageFiles(*folder)) for path, folder in reversed(FOLDERS.items())
    ]
    return [*spoken, *kept, Route("/room", _to_room), *folders]


async def _to_room(_request: Request) -> Response:
    """Lead to the page's folder, beside which its files are."""
    return RedirectResponse("room/")


def _route(path: str, choose: Callable[[MadeFiles], MadeFile]) -> Route:
    """Return the route of a file that is chosen of what is made for the reader's language."""

    async def answer(request: Request) -> Response:
        return choose(made(language_of(request))).response(request)

    return Route(path, answer)
