"""Middleware: host, origin and size of every request; headers of every answer."""

from __future__ import annotations

import asyncio
import ipaddress
import logging
import re
import socket
from collections.abc import Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import ClientDisconnect

from stayput.app.jobs import CLIENT, CLIENT_HEADER, Client
from stayput.app.messages import RefusedError, error_response, refused
from stayput.errors import InputError

if TYPE_CHECKING:
    from starlette.types import ASGIApp, Message, Receive, Scope, Send

    from stayput.app.limits import Limits

POLICY = (
    "default-src 'self'; img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; script-src 'self'; "
    "connect-src 'self'; object-src 'none'; base-uri 'none'; form-action 'self'; frame-ancestors 'none'"
)
"""What a page may load: nothing from elsewhere, no scripts within the page."""

HEADERS = {
    "Content-Security-Policy": POLICY,
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Permissions-Policy": "camera=(), microphone=(), geolocation=()",
}
"""Headers of every answer."""

REPORT_POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:"
"""For a downloaded report, which is one file with everything in it."""

UPLOADS = "/api/v1/motions"
"""Where larger bodies are accepted."""

LONGEST_PAGE = 64
"""So many characters of the header that names a page count."""

_PORT = re.compile(":[0-9]*$")

_log = logging.getLogger("stayput.app")


class Guard:
    """Middleware that refuses requests of other hosts and sites, and those beyond the limits.

    Parameters
    ----------
    app : ASGIApp
        What comes next.
    limits : Limits
        Sizes of bodies.
    names : sequence of str
        Names of the server besides this machine's: what it is bound to, and what a proxy calls it.
    """

    def __init__(self, app: ASGIApp, limits: Limits, names: Sequence[str]) -> None:
        self._app = app
        self._limits = limits
        self._names = {name.lower() for name in ("localhost", socket.gethostname(), *names)}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or refuse it."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return

        response_started = False

        async def answer(message: Message) -> None:
            nonlocal response_started
            if message["type"] == "http.response.start":
                response_started = True
                headers = MutableHeaders(scope=message)
                for name, value in HEADERS.items():
                    headers.setdefault(name, value)
                if scope["path"].startswith("/api/"):
                    headers.setdefault("Cache-Control", "no-store")
            await send(message)

        headers = Headers(scope=scope)
        host, origin = headers.get("host", ""), headers.get("origin")
        if not self._is_ours(host):
            await error_response(400, InputError("app.other_host"))(scope, receive, answer)
            return
        if origin is not None and origin.lower() not in (f"http://{host}".lower(), f"https://{host}".lower()):
            await error_response(403, InputError("app.other_site"))(scope, receive, answer)
            return
        is_upload = scope["path"].rstrip("/") == UPLOADS and scope["method"] == "POST"
        most = self._limits.upload if is_upload else self._limits.body
        # behind a proxy Uvicorn takes the address from X-Forwarded-For
        address = scope["client"][0] if scope["client"] else ""
        CLIENT.set(Client(address, headers.get(CLIENT_HEADER, "")[:LONGEST_PAGE]))
        seen, complete, deadline = 0, False, asyncio.get_running_loop().time() + self._limits.seconds

        async def counted() -> Message:
            nonlocal seen, complete
            try:
                async with asyncio.timeout_at(None if complete else deadline):
                    message = await receive()
                    seen += len(message.get("body", b""))
                    # more is read than is accepted, so that the client sees the answer
                    while most < seen < 4 * most and message.get("more_body"):
                        message = await receive()
                        seen += len(message.get("body", b""))
            except TimeoutError:
                raise refused(408, "app.body_too_slow") from None
            if seen > most:
                raise refused(413, "app.body_too_large", most=most)
            complete = not message.get("more_body", False)
            return message

        try:
            await self._app(scope, counted, answer)
        except RefusedError as refusal:
            response = error_response(refusal.status_code, refusal.error, refusal.headers)
            await response(scope, receive, answer)
        except ClientDisconnect:
            return
        except Exception:
            if response_started:
                raise
            _log.exception("%s %s failed", scope["method"], scope["path"])
            await error_response(500, InputError("app.failed"))(scope, receive, answer)

    def _is_ours(self, host: str) -> bool:
        """Return whether a Host header can only mean this server: a known name, or an address as such.

        A foreign page can make its own name point here, but it cannot make its requests carry another name.
        """
        name = _PORT.sub("", host.lower())
        with suppress(ValueError):
            return name in self._names or bool(ipaddress.ip_address(name.strip("[]")))
        return False
