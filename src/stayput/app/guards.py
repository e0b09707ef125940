"""What every request passes: its host, its origin, its size, its time; and the headers of every answer."""

from __future__ import annotations

import asyncio
import ipaddress
import logging
import socket
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.exceptions import HTTPException

from stayput.app.refusals import error_response

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

_log = logging.getLogger("stayput.app")

_DRAINED = 64 * 1024 * 1024  # of a body that is refused so much is read, so that the answer can be seen
_DRAIN_SECONDS = 5.0


class Guard:
    """Middleware that refuses what should not come in.

    Parameters
    ----------
    app : ASGIApp
        What comes next.
    limits : Limits
        Sizes and times of bodies.
    host : str
        The address that the server is bound to.
    """

    def __init__(self, app: ASGIApp, limits: Limits, host: str) -> None:
        self._app = app
        self._limits = limits
        self._names = {"localhost", host.lower(), socket.gethostname().lower()}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or refuse it."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return

        begun = False

        async def answer(message: Message) -> None:
            nonlocal begun
            if message["type"] == "http.response.start":
                begun = True
                headers = MutableHeaders(scope=message)
                for name, value in HEADERS.items():
                    headers.setdefault(name, value)
                if scope["path"].startswith("/api/"):
                    headers.setdefault("Cache-Control", "no-store")
            await send(message)

        headers = Headers(scope=scope)
        if not self._is_ours(headers.get("host")):
            told = "The Host header names another server; open the address that stayput printed."
            await error_response(400, told)(scope, receive, answer)
            return
        origin = headers.get("origin")
        if origin is not None and urlsplit(origin).netloc.lower() != headers.get("host", "").lower():
            await error_response(403, "Requests from other sites are refused.")(scope, receive, answer)
            return
        most = self._limits.upload if scope["path"].rstrip("/") == UPLOADS else self._limits.body
        told = f"The body is too large; at most {most} bytes are accepted."
        stated = headers.get("content-length", "")
        if stated.isdigit() and int(stated[:20]) > most:
            await _drain(receive)
            await error_response(413, told)(scope, receive, answer)
            return
        try:
            await self._app(scope, self._counted(receive, most, told), answer)
        except Exception:
            if begun:
                raise
            _log.exception("%s %s failed", scope["method"], scope["path"])
            await error_response(500, "The server failed; its log says why.")(scope, receive, answer)

    def _is_ours(self, host: str | None) -> bool:
        """Return whether a Host header can only mean this server: a known name, or an address as such.

        A foreign page can make its own name point here, but it cannot make its requests carry another name.
        """
        if host is None:
            return False
        name = (urlsplit(f"//{host}").hostname or "") if "@" not in host else ""
        if name.lower() in self._names:
            return True
        try:
            ipaddress.ip_address(name)
        except ValueError:
            return False
        return True

    def _counted(self, receive: Receive, most: int, told: str) -> Receive:
        """Return a receive that refuses too much, chunked or not, and what comes too slowly."""
        seen, complete = 0, False
        deadline = asyncio.get_running_loop().time() + self._limits.seconds

        async def counted() -> Message:
            nonlocal seen, complete
            if complete:
                return await receive()
            try:
                async with asyncio.timeout_at(deadline):
                    message = await receive()
            except TimeoutError:
                raise HTTPException(408, "The body came too slowly.") from None
            if message["type"] == "http.request":
                seen += len(message.get("body", b""))
                complete = not message.get("more_body", False)
                if seen > most:
                    if not complete:
                        await _drain(receive)
                    raise HTTPException(413, told)
            return message

        return counted


async def _drain(receive: Receive) -> None:
    """Read the rest of a body that is refused, for a while, keeping nothing."""
    seen = 0
    try:
        async with asyncio.timeout(_DRAIN_SECONDS):
            while seen < _DRAINED:
                message = await receive()
                seen += len(message.get("body", b""))
                if message["type"] != "http.request" or not message.get("more_body", False):
                    return
    except TimeoutError:
        return
