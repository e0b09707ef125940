"""Limits on connections: time for the headers of a request, number in all and per client."""

from __future__ import annotations

import ipaddress
from typing import TYPE_CHECKING, Any, cast

from uvicorn.protocols.http.h11_impl import H11Protocol

from stayput.app.refusals import error_response
from stayput.errors import InputError

if TYPE_CHECKING:
    import asyncio
    from collections.abc import Callable

    from starlette.types import Receive, Scope, Send
    from uvicorn.config import Config
    from uvicorn.protocols.http.h11_impl import RequestResponseCycle
    from uvicorn.server import ServerState

    from stayput.app.limits import Limits


def client_of(address: str | None) -> str:
    """Return the key of a client: its IPv4 address, or the 64-bit network of its IPv6 address."""
    try:
        ip = ipaddress.ip_address(address or "")
    except ValueError:
        return ""
    if isinstance(ip, ipaddress.IPv4Address):
        return str(ip)
    if ip.ipv4_mapped is not None:
        return str(ip.ipv4_mapped)
    return str(ipaddress.ip_network((int(ip) >> 64 << 64, 64)))


async def _busy(scope: Scope, receive: Receive, send: Send) -> None:
    """Respond in place of the app where there are too many connections."""
    headers = {"Retry-After": "2", "Connection": "close"}
    await error_response(503, InputError("app.many_connections"), headers)(scope, receive, send)


class Connections:
    """All connections of a server.

    Where there is no room for a new one, the one that has waited longest for its client goes. Only where all
    others are being answered is the new one told that the server is busy.

    Parameters
    ----------
    limits : Limits
        How many.
    """

    def __init__(self, limits: Limits) -> None:
        self.limits = limits
        self._all: dict[Connection, str] = {}

    def add(self, new: Connection) -> bool:
        """Take a connection in; return whether there is room for it."""
        client = client_of(new.client and new.client[0])
        own = [connection for connection, name in self._all.items() if name == client]
        everybody = list(self._all)
        self._all[new] = client
        limits = self.limits
        return self._room(own, limits.connections_per_client) and self._room(everybody, limits.connections)

    def remove(self, connection: Connection) -> None:
        """Forget a connection."""
        self._all.pop(connection, None)

    def _room(self, others: list[Connection], most: int) -> bool:
        if sum(connection in self._all for connection in others) < most:
            return True
        waiting = [connection for connection in others if connection in self._all and connection.waits]
        if not waiting:
            return False
        longest = min(waiting, key=lambda connection: connection.since)
        self.remove(longest)
        longest.transport.abort()
        return True


class Connection(H11Protocol):
    """A connection whose client has a limited time for the headers of each request."""

    def __init__(
        self,
        config: Config,
        server_state: ServerState,
        app_state: dict[str, Any],
        _loop: asyncio.AbstractEventLoop | None = None,
        *,
        connections: Connections,
    ) -> None:
        super().__init__(config, server_state, app_state, _loop)
        self._connections = connections
        self._timer: asyncio.TimerHandle | None = None
        self.since = self.loop.time()

    @property
    def waits(self) -> bool:
        """Whether it is the client's turn: to send headers or a body, or to take its answer."""
        answering = self._answering()
        return answering is None or answering.more_body or self.flow.write_paused

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Begin to wait for the first request."""
        super().connection_made(transport)
        if not self._connections.add(self):
            self.app = _busy
        self._time_headers()

    def data_received(self, data: bytes) -> None:
        """Receive data; the time limit for headers ends when they are complete, not with their first byte."""
        before = self._answering()
        super().data_received(data)
        answering = self._answering()
        if answering is None:
            self._time_headers()
        else:
            self._end_timer()
            if answering is not before:
                self.since = self.loop.time()

    def on_response_complete(self) -> None:
        """Begin to wait for the next request."""
        self.since = self.loop.time()
        super().on_response_complete()
        if self._answering() is None and self.conn.trailing_data[0]:  # the next request has begun
            self._time_headers()

    def connection_lost(self, exc: Exception | None) -> None:
        """Stop its timer and forget it."""
        self._end_timer()
        self._connections.remove(self)
        super().connection_lost(exc)

    def _answering(self) -> RequestResponseCycle | None:
        """Return the request that is being answered: its headers are complete, its response is not."""
        cycle = cast("RequestResponseCycle | None", self.cycle)
        return None if cycle is None or cycle.response_complete else cycle

    def _time_headers(self) -> None:
        if self._timer is None:
            self._timer = self.loop.call_later(self._connections.limits.header_seconds, self._give_up)

    def _end_timer(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _give_up(self) -> None:
        self._timer = None
        if self._answering() is None and not self.transport.is_closing():
            self.transport.close()


def connection_maker(limits: Limits) -> Callable[..., Connection]:
    """Return a factory of the connections of one server."""
    connections = Connections(limits)

    def make(**options: Any) -> Connection:
        return Connection(**options, connections=connections)

    return make
