"""Connections: how long the head of a request may take, and how many one address may have."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, cast

import h11
from uvicorn.protocols.http.h11_impl import H11Protocol

if TYPE_CHECKING:
    import asyncio

    from stayput.app.limits import Limits


class LimitedConnection(H11Protocol):
    """A connection that is closed where a request's head takes too long, or its address has too many.

    Uvicorn limits connections only all together, so that one address that opens them and sends nothing would
    shut out all others. A proxy, whose connections are those of many, has no limit of its own: it is who
    Uvicorn trusts to name the client (``FORWARDED_ALLOW_IPS``).
    """

    def __init__(self, *args: Any, limits: Limits, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self._limits = limits
        self._head_timer: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Begin to wait for a request, or refuse the connection."""
        super().connection_made(transport)
        address = self.client[0] if self.client else ""
        proxies = str(self.config.forwarded_allow_ips).replace(" ", "").split(",")
        clients = [cast("H11Protocol", connection).client for connection in self.connections]
        from_address = sum(client is not None and client[0] == address for client in clients)
        if from_address > self._limits.connections_per_address and not {address, "*"} & {*proxies}:
            transport.abort()
            return
        self._start_head_timer()

    def data_received(self, data: bytes) -> None:
        """Take what has come; a head that has begun must end in time, also the second on a connection."""
        super().data_received(data)
        if self.conn.their_state is not h11.IDLE:
            self._stop_head_timer()
        elif self._head_timer is None:
            self._start_head_timer()

    def connection_lost(self, exc: Exception | None) -> None:
        """Wait no longer."""
        self._stop_head_timer()
        super().connection_lost(exc)

    def _start_head_timer(self) -> None:
        self._head_timer = self.loop.call_later(self._limits.head_seconds, self.transport.close)

    def _stop_head_timer(self) -> None:
        if self._head_timer is not None:
            self._head_timer.cancel()
            self._head_timer = None
