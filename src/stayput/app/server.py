"""The server: its parts put together, and how it begins and ends."""

from __future__ import annotations

import contextlib
import gc
import logging
import socket
import sys
import tempfile
import threading
import time
import webbrowser
from contextlib import asynccontextmanager
from pathlib import Path
from typing import TYPE_CHECKING, cast

import uvicorn
from fastapi import FastAPI
from fastapi.exceptions import RequestValidationError
from starlette.exceptions import HTTPException

import stayput
from stayput.app.api import api
from stayput.app.description import described
from stayput.app.guards import Guard
from stayput.app.jobs import Jobs
from stayput.app.limits import Limits
from stayput.app.motions import Motions
from stayput.app.pages import docs_route, page_routes
from stayput.app.refusals import RefusedError, error_response
from stayput.app.service import Service
from stayput.app.warming import warm
from stayput.app.workers import Workers
from stayput.errors import InputError

if TYPE_CHECKING:
    from collections.abc import AsyncGenerator

    from starlette.requests import Request
    from starlette.responses import Response

ABOUT = (
    "Furniture in earthquakes, without and with measures that hold it. Units stand in the names of the keys; "
    "a scene is a scenario file as JSON."
)
SWITCH_SECONDS = 0.0005
"""How long a thread of Python keeps the others waiting: a ping is answered in between."""

_log = logging.getLogger("stayput.app")


def create_app(host: str = "127.0.0.1", limits: Limits | None = None, *, warming: bool = True) -> FastAPI:
    """Make the app.

    Parameters
    ----------
    host : str
        The address that it is bound to.
    limits : Limits, optional
        What is accepted.
    warming : bool
        Whether to compile in the background as it starts.
    """
    allowed = Limits() if limits is None else limits
    folder = Path(tempfile.mkdtemp(prefix="stayput-"))
    quick = Workers(allowed.workers, allowed.waiting)
    slow = Workers(allowed.slow_workers, allowed.slow_waiting)
    service = Service(allowed, quick, slow, Motions(folder, allowed), Jobs(allowed))

    @asynccontextmanager
    async def life(_app: FastAPI) -> AsyncGenerator[None]:
        if warming:
            threading.Thread(target=_warm, args=(service,), name="stayput-warm", daemon=True).start()
        interval = sys.getswitchinterval()
        sys.setswitchinterval(SWITCH_SECONDS)
        try:
            yield
        finally:
            sys.setswitchinterval(interval)
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
    app.router.routes.append(docs_route(app))
    app.router.routes.extend(page_routes())
    app.add_middleware(Guard, limits=allowed, host=host)
    _add_refusals(app)
    app.openapi = described(app)
    return app


def _warm(service: Service) -> None:
    try:
        warm()
    except Exception:
        if service.closed:  # the server ends before they were done
            return
        _log.exception("The first runs, which compile, failed")
    gc.collect()
    gc.freeze()  # what was loaded stays: looking through it again would make pings wait
    service.ready = True


def _add_refusals(app: FastAPI) -> None:
    """Let every refusal be one sentence and a field."""

    async def refused(_request: Request, error: Exception) -> Response:
        return cast("RefusedError", error).response()

    async def input_refused(_request: Request, error: Exception) -> Response:
        return error_response(422, str(error))

    async def invalid(_request: Request, error: Exception) -> Response:
        first = cast("RequestValidationError", error).errors()[0]
        place = [str(part) for part in first["loc"] if part not in ("body", "path", "query")]
        if first["type"] == "json_invalid":
            return error_response(400, "The body is not JSON.")
        field = ".".join(place) or None
        return error_response(422, f"{field or 'The body'}: {first['msg']}.", field)

    async def http(_request: Request, error: Exception) -> Response:
        found = cast("HTTPException", error)
        told = f"{str(found.detail).rstrip('.')}."
        return error_response(found.status_code, told, None, dict(found.headers or {}))

    app.add_exception_handler(RefusedError, refused)
    app.add_exception_handler(InputError, input_refused)
    app.add_exception_handler(RequestValidationError, invalid)
    app.add_exception_handler(HTTPException, http)


def server_of(app: FastAPI) -> uvicorn.Server:
    """Return what serves an app; it is run with sockets that are bound already."""
    config = uvicorn.Config(
        app,
        log_level="warning",
        server_header=False,
        timeout_keep_alive=30,
        timeout_graceful_shutdown=2,
        limit_concurrency=256,
        ws="none",
    )
    return uvicorn.Server(config)


def serve(host: str = "127.0.0.1", port: int = 8000, *, browser: bool = True) -> None:
    """Bind, print the address, and serve until interrupted.

    Parameters
    ----------
    host : str
        Address to bind to; others than loopback let other machines in.
    port : int
        Port; 0 takes one that is free.
    browser : bool
        Whether to open the page.

    Raises
    ------
    InputError
        The address cannot be bound to.
    """
    bound = bind(host, port)
    address = address_of(bound)
    server = server_of(create_app(host))
    print(f"stayput is at {address} (Ctrl-C ends it)", flush=True)
    if browser:
        threading.Thread(target=_open, args=(server, address), daemon=True).start()
    with contextlib.suppress(KeyboardInterrupt):
        server.run(sockets=[bound])


def _open(server: uvicorn.Server, address: str) -> None:
    while not server.started:
        if server.should_exit:
            return
        time.sleep(0.05)
    webbrowser.open(address)


def bind(host: str, port: int) -> socket.socket:
    """Return a socket that is bound and listens.

    Raises
    ------
    InputError
        The address cannot be bound to.
    """
    try:
        family, kind, protocol, _, place = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
        found = socket.socket(family, kind, protocol)
        try:
            found.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            found.bind(place)
            found.listen(128)
        except OSError:
            found.close()
            raise
    except (OSError, UnicodeError, OverflowError) as error:
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        told = f"The address is {host}, port {port}; it cannot be served: {reason}."
        raise InputError(told) from None
    found.setblocking(False)
    return found


def address_of(bound: socket.socket) -> str:
    """Return the address of a bound socket as a browser takes it."""
    host, port = str(bound.getsockname()[0]), int(bound.getsockname()[1])
    shown = {"0.0.0.0": "127.0.0.1", "::": "::1"}.get(host, host)
    return f"http://[{shown}]:{port}/" if ":" in shown else f"http://{shown}:{port}/"
