"""Plain sockets to a server: what no client library sends."""

from __future__ import annotations

import socket
from contextlib import contextmanager
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

from waiting import PATIENCE

if TYPE_CHECKING:
    from collections.abc import Generator

    from serving import Running

PING = b"GET /api/v1/ping HTTP/1.1\r\nHost: localhost\r\n\r\n"


@contextmanager
def connected(server: Running) -> Generator[socket.socket]:
    place = urlsplit(server.address)
    assert place.hostname is not None
    assert place.port is not None
    with socket.create_connection((place.hostname, place.port), timeout=PATIENCE) as found:
        yield found


def request(path: str, body: bytes = b"", *headers: str, length: int | None = None) -> bytes:
    """Return a POST; ``length``: what it states instead of its body's own length."""
    stated = f"Content-Length: {len(body) if length is None else length}"
    return "\r\n".join([f"POST {path} HTTP/1.1", "Host: localhost", stated, *headers, "", ""]).encode() + body


def answer(connection: socket.socket) -> tuple[int, bytes]:
    """Return the status and the rest of what is answered, up to the end of the connection or of the body."""
    data = b""
    while True:
        head, _, body = data.partition(b"\r\n\r\n")
        if head.startswith(b"HTTP/1.1 100 "):  # the answer follows
            data = body
            continue
        lines = head.lower().split(b"\r\n")
        length = next((int(one.split(b":")[1]) for one in lines if one.startswith(b"content-length:")), None)
        if b"\r\n\r\n" in data and length is not None and len(body) >= length:
            break
        part = connection.recv(65536)
        if not part:
            break
        data += part
    return (int(data.split(b" ")[1]) if data else 0), data.partition(b"\r\n\r\n")[2]


def is_closed(connection: socket.socket) -> bool:
    """Return whether the server ends the connection before anything else comes, within the usual time."""
    try:
        return connection.recv(1) == b""
    except ConnectionError:
        return True
