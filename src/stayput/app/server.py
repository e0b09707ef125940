"""The server: the app made of its parts, the address that it is bound to, its start and its end."""

from __future__ import annotations

import ipaddress
import json
import logging
import mimetypes
import os
import socket
import sys
import threading
import time
import warnings
import webbrowser
from collections.abc import AsyncGenerator, Awaitable, Callable, Sequence
from contextlib import asynccontextmanager, suppress
from functools import cache, partial
from importlib import resources
from typing import TYPE_CHECKING, cast

import uvicorn
from fastapi import FastAPI
from fastapi.exceptions import RequestValidationError
from starlette.exceptions import HTTPException
from starlette.middleware.gzip import GZipMiddleware
from starlette.responses import RedirectResponse, Response
from starlette.routing import Mount, Route
from starlette.staticfiles import StaticFiles

import stayput
from stayput.app.api import api
from stayput.app.connections import LimitedConnection
from stayput.app.limits import Limits
from stayput.app.messages import RefusedError, described, error_response, refusal_of_request
from stayput.app.middleware import Guard
from stayput.app.presets import SCENE, SCENE_MEASURES
from stayput.app.running import simulated
from stayput.app.service import Service
from stayput.catalogue import LANGUAGES, TEXTS, Language, earthquake, page, phrase, room_page, say
from stayput.errors import InputError, InputWarning, reason_of
from stayput.report.page import inks_css, rendered
from stayput.scenario import Scenario
from stayput.scenario.measures import YOURS
from stayput.verification import verify

if TYPE_CHECKING:
    from starlette.requests import Request
    from starlette.types import Scope


FOLDERS = {
    "": ("stayput.app", "page"),
    "room": ("stayput.app", "room_page"),
    "canvas": ("stayput.report", "canvas"),
}
"""The folders of the pages' files in the package, by their paths on the server."""


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
    # A browser that learned of each module from the one that imports it would wait for one after the other.
    needed = dict.fromkeys(("", "canvas", folder))
    modules = [f"{path}/{file}" for path in needed for file in _names(*FOLDERS[path]) if file.endswith(".js")]
    home = "../" if folder else ""
    addresses = [home + module.lstrip("/") for module in modules]
    return rendered(f"{FOLDERS[folder][1]}/index.html", {"modules": addresses}, "app")


@cache
def words(language: Language) -> dict[str, str]:
    """Return the texts of both pages in a language by their keys."""
    place = LANGUAGES.index(language)
    texts = {name.rpartition(".")[2]: TEXTS[name] for name in page.SHARED}
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


ABOUT = (
    "Furniture in earthquakes, without and with measures that hold it. Units stand in the names of the keys; "
    "a scene is a scenario file as JSON."
)
_log = logging.getLogger("stayput.app")

_ELSEWHERE = {socket.AF_INET: "192.0.2.1", socket.AF_INET6: "2001:db8::1"}
"""Addresses for documentation: nobody has them, and a socket of datagrams that is connected sends nothing."""

REFUSED_BY_STARLETTE = {400: "app.body_not_read", 404: "app.no_such_address", 405: "app.wrong_method"}
"""What is said of a request that no function answers, by its status."""


def create_app(names: Sequence[str] = (), limits: Limits | None = None, *, warming: bool = True) -> FastAPI:
    """Make the app.

    Parameters
    ----------
    names : sequence of str
        Names of the server besides this machine's.
    limits : Limits, optional
        What is accepted.
    warming : bool
        Whether to compile in the background as it starts.
    """
    service = Service(Limits() if limits is None else limits)

    @asynccontextmanager
    async def life(_app: FastAPI) -> AsyncGenerator[None]:
        if warming:
            threading.Thread(target=_warm, args=(service,), name="stayput-warm", daemon=True).start()
        try:
            yield
        finally:
            service.close()

    app = FastAPI(
        title="stayput",
        version=stayput.__version__,
        description=ABOUT,
        docs_url=None,  # FastAPI's own pages load scripts from other hosts
        redoc_url=None,
        openapi_url="/api/openapi.json",
        lifespan=life,
    )
    app.state.service = service
    app.include_router(api(service))
    app.router.routes.extend(page_routes())
    app.add_middleware(GZipMiddleware, minimum_size=1000, compresslevel=4)  # 9 takes thrice as long for 2 %
    app.add_middleware(Guard, limits=service.limits, names=names)
    _add_refusals(app, service.motions.with_file_names)
    app.openapi = described(app)
    return app


def warm() -> None:
    """Run the scene that the page begins with first; then upstairs and a small verification."""
    upstairs = {**SCENE["shaking"], "building": {"storeys": 10}, "storey": 5}
    simulated(Scenario.parse({**SCENE, "measures": [{"name": YOURS, "combine": SCENE_MEASURES}]}))
    simulated(Scenario.parse({**SCENE, "shaking": upstairs}))
    few = {"measures": [{"type": "belt"}], "uncertainty": {"samples": 1}}
    verify(Scenario.parse({**SCENE, **few}), levels=[6.0], threads=1, progress=False)


def _warm(service: Service) -> None:
    try:
        warm()
    except Exception:
        if service.closed:  # the server ends before they were done
            return
        _log.exception("The first runs, which compile, failed")
    service.ready = True


def _add_refusals(app: FastAPI, with_file_names: Callable[[str], str]) -> None:
    """Let every refusal be one sentence, without the server's own paths, and a field."""

    async def refused(_request: Request, error: Exception) -> Response:
        if isinstance(error, InputError):
            error = RefusedError(422, error.about(None))
        refusal = cast("RefusedError", error)
        plain = refusal.error.rewritten(with_file_names)
        return error_response(refusal.status_code, plain, refusal.headers)

    async def invalid(_request: Request, error: Exception) -> Response:
        first = cast("RequestValidationError", error).errors()[0]
        if first["type"] == "json_invalid":
            return error_response(400, InputError("app.not_json"))
        if first["loc"][0] == "path":  # of no id that this server gave
            return error_response(404, InputError("app.no_such_id"))
        return error_response(422, refusal_of_request(first))

    async def http(_request: Request, error: Exception) -> Response:
        exception = cast("HTTPException", error)
        code = REFUSED_BY_STARLETTE.get(exception.status_code, "app.http")
        error = InputError(code, message=str(exception.detail).rstrip("."))
        return error_response(exception.status_code, error, exception.headers)

    app.add_exception_handler(RefusedError, refused)
    app.add_exception_handler(InputError, refused)
    app.add_exception_handler(RequestValidationError, invalid)
    app.add_exception_handler(HTTPException, http)


def server_of(app: FastAPI) -> uvicorn.Server:
    """Return the Uvicorn server of an app; it is run with sockets that are bound already."""
    config = uvicorn.Config(
        app,
        http=partial(LimitedConnection, limits=app.state.service.limits),  # type: ignore[arg-type]
        log_level="warning",
        server_header=False,
        timeout_keep_alive=30,
        timeout_graceful_shutdown=2,
        limit_concurrency=app.state.service.limits.connections,
        ws="none",
    )
    return uvicorn.Server(config)


def warning_of(bound: socket.socket, language: str = "en") -> str | None:
    """Return the warning about a bound socket that other machines can reach, or None where none can.

    Parameters
    ----------
    bound : socket
        The socket.
    language : str
        "en" or "ja".
    """
    host, port = str(bound.getsockname()[0]), int(bound.getsockname()[1])
    address = ipaddress.ip_address(host.partition("%")[0])
    if address.is_loopback:
        return None
    reachable = own_addresses(bound.family) if address.is_unspecified else [host]
    urls = [_url(ip, port) for ip in reachable]
    where = ", ".join(urls) or phrase("app.every_address", port=port)
    return say("app.reachable", language, where=where)


def own_addresses(family: socket.AddressFamily | int) -> list[str]:
    """Return this machine's addresses that others may know: the one that leads elsewhere first.

    Parameters
    ----------
    family : socket.AddressFamily
        AF_INET, or AF_INET6, which reaches both kinds.
    """
    addresses: list[str] = []
    for kind in (socket.AF_INET, *((socket.AF_INET6,) if family == socket.AF_INET6 else ())):
        with suppress(OSError), socket.socket(kind, socket.SOCK_DGRAM) as probe:
            probe.connect((_ELSEWHERE[kind], 9))
            addresses.append(str(probe.getsockname()[0]))
        with suppress(OSError):
            addresses += [str(info[4][0]) for info in socket.getaddrinfo(socket.gethostname(), None, kind)]

    def known_elsewhere(address: str) -> bool:
        ip = ipaddress.ip_address(address.partition("%")[0])
        return not (ip.is_loopback or ip.is_link_local or ip.is_unspecified)

    return [address for address in dict.fromkeys(addresses) if known_elsewhere(address)]


def bind(host: str, port: int) -> socket.socket:
    """Return a socket that is bound and listens.

    Raises
    ------
    InputError
        The address cannot be bound to.
    """
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
        listener = socket.socket(family, kind, protocol)
        try:
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            listener.bind(address)
            listener.listen(128)
        except OSError:
            listener.close()
            raise
    except (OSError, UnicodeError, OverflowError) as error:
        reason = reason_of(error)
        raise InputError("app.not_served", host=host, port=port, reason=reason) from None
    listener.setblocking(False)
    return listener


def address_of(bound: socket.socket) -> str:
    """Return the address of a bound socket as a browser takes it."""
    host, port = str(bound.getsockname()[0]), int(bound.getsockname()[1])
    return _url({"0.0.0.0": "127.0.0.1", "::": "::1"}.get(host, host), port)


def _url(host: str, port: int) -> str:
    return f"http://[{host}]:{port}/" if ":" in host else f"http://{host}:{port}/"


def serve(
    host: str = "127.0.0.1",
    port: int = 8000,
    *,
    names: Sequence[str] = (),
    browser: bool = True,
    language: str = "en",
) -> None:
    """Bind, print the address, and serve until interrupted.

    Parameters
    ----------
    host : str
        Address to bind to; others than loopback let other machines in.
    port : int
        Port; 0 takes one that is free.
    names : sequence of str
        Names by which a proxy calls the server.
    browser : bool
        Whether to open the page.
    language : str
        "en" or "ja", of what is printed; the page has that of the browser.

    Raises
    ------
    InputError
        The address cannot be bound to.
    """
    warnings.filterwarnings("ignore", category=InputWarning)  # who sent a record is told by the reply
    bound = bind(host, port)
    address = address_of(bound)
    app = create_app((host, *names))
    server = server_of(app)
    print(say("app.at_address", language, address=address), flush=True)
    warning = warning_of(bound, language)
    if warning is not None:
        print(warning, file=sys.stderr, flush=True)
    if browser:
        threading.Thread(target=_open, args=(server, address), daemon=True).start()
    with suppress(KeyboardInterrupt):
        server.run(sockets=[bound])
    if not app.state.service.ready:
        # LLVM, with which a thread still compiles, must not be torn down under it
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(0)


def _open(server: uvicorn.Server, address: str) -> None:
    while not server.started:
        if server.should_exit:
            return
        time.sleep(0.05)
    webbrowser.open(address)
