"""Clients that are silent, slow or many keep nobody else out."""

from __future__ import annotations

import json
import threading
import time
from contextlib import ExitStack
from dataclasses import replace
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, cast

from raw import PING, answer, connected, is_closed, request
from serving import client_of, running

from stayput.app import bodies
from stayput.app.connections import Connection, Connections
from stayput.app.connections import client_of as address_of_client
from stayput.app.limits import Limits
from waiting import wait_until

if TYPE_CHECKING:
    import httpx
    import pytest

FORM = "Content-Type: multipart/form-data; boundary=b"
HEAD = b'--b\r\nContent-Disposition: form-data; name="file"; filename="a"\r\n\r\n'
SHORT = replace(Limits(), header_seconds=0.4)
LONG = replace(Limits(), header_seconds=600.0)
RECORD = "1\n-1\n0\n2\n" * 100
GIVEN = {"unit": "gal", "dt": "0.01"}


def test_silent_connections_make_room() -> None:
    """As many as there may be, and more, of one client; those that wait longest go at once."""
    few = replace(LONG, connections=20, connections_per_client=12)
    with running(few) as server, ExitStack() as stack, client_of(server) as client:
        silent = [stack.enter_context(connected(server)) for _ in range(30)]
        assert client.get("/api/v1/ping").status_code == 200
        assert all(map(is_closed, silent[:19]))
        assert client.get("/api/v1/ping").status_code == 200


def test_silent_connections_are_closed() -> None:
    with running(SHORT) as server, ExitStack() as stack, client_of(server) as client:
        silent = [stack.enter_context(connected(server)) for _ in range(12)]
        assert all(map(is_closed, silent))
        assert client.get("/api/v1/ping").status_code == 200


def test_headers_have_a_limited_time_also_where_they_drip() -> None:
    with running(SHORT) as server, connected(server) as connection:
        connection.sendall(PING[:-2] + b"X: ")

        def refuses() -> bool:
            try:
                connection.sendall(b"a")
            except ConnectionError:
                return True
            return False

        wait_until(refuses)


def begins_anew(seconds: float) -> bool:
    """Send requests whose headers take almost as long as they may; False where this machine is too slow."""
    with running(replace(Limits(), header_seconds=seconds)) as server, connected(server) as connection:
        for _ in range(3):
            began = time.monotonic()
            connection.sendall(PING[:20])
            time.sleep(0.4 * seconds)
            connection.sendall(PING[20:])
            if time.monotonic() - began > 0.8 * seconds:
                return False
            assert answer(connection)[0] == 200
        connection.sendall(PING + PING[:10])  # the second one stays in its beginnings
        assert answer(connection)[0] == 200
        assert is_closed(connection)
    return True


def test_the_time_begins_anew_with_each_request() -> None:
    assert any(begins_anew(seconds) for seconds in (0.4, 2.0, 10.0))


def test_a_body_that_drips_is_given_up_soon() -> None:
    """Much sooner than the time that a whole body has."""
    with running(replace(SHORT, seconds=600.0)) as server, connected(server) as connection:
        connection.sendall(request("/api/v1/simulate", b"{", "Content-Type: application/json", length=1000))
        status, body = answer(connection)
        assert status == 408
        assert json.loads(body)["message"] == "The body came too slowly."


def test_uploads_that_drip_do_not_block_another(monkeypatch: pytest.MonkeyPatch) -> None:
    """Not even where they are as many as there may be, and are allowed to be slow."""
    monkeypatch.setattr(bodies, "_YOUNG", 0.02)
    limits = replace(LONG, uploads_per_client=2, seconds=600.0)
    with running(limits) as server, ExitStack() as stack, client_of(server) as client:
        slow = [stack.enter_context(connected(server)) for _ in range(4)]
        for one in slow:
            one.sendall(request("/api/v1/motions", HEAD, FORM, length=100_000))
            time.sleep(0.1)
        sent = client.post("/api/v1/motions", files={"file": ("a", RECORD)}, data=GIVEN)
        assert sent.status_code == 201, sent.text
        assert answer(slow[0])[0] == 408


def test_uploads_that_come_fast_are_not_ended_by_another(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bodies, "_FAST", 64)  # so that it is fast on a slow machine too
    limits = replace(LONG, uploads_per_client=1)
    with running(limits) as server, connected(server) as first, client_of(server) as client:
        first.sendall(request("/api/v1/motions", HEAD + b"1\n" * 100_000, FORM, length=300_000))

        def posted() -> httpx.Response:
            return client.post("/api/v1/motions", files={"file": ("a", RECORD)}, data=GIVEN)

        wait_until(lambda: posted().status_code == 429)  # once the first has begun
        assert posted().json()["message_ja"]
        first.sendall(b"1\n" * 60_000)
        assert answer(first)[0] == 422


def test_one_client_has_so_many_requests_at_a_time() -> None:
    with running(replace(LONG, requests_per_client=2)) as server, ExitStack() as stack:
        held = [stack.enter_context(connected(server)) for _ in range(2)]
        for one in held:
            one.sendall(request("/api/v1/simulate", b"{", "Content-Type: application/json", length=10))
        with client_of(server) as client:

            def status() -> int:
                return client.get("/api/v1/ping").status_code

            wait_until(lambda: status() == 503)  # once both have begun
            for one in held:
                one.sendall(b"}" * 9)
                assert answer(one)[0] == 400
            wait_until(lambda: status() == 200)  # they end a moment after their answers


def test_a_client_that_leaves_is_no_failure(caplog: pytest.LogCaptureFixture) -> None:
    with running() as server, client_of(server) as client:
        for path in ("/api/v1/motions", "/api/v1/simulate"):
            with connected(server) as connection:
                connection.sendall(request(path, HEAD, FORM, length=1000))
                assert client.get("/api/v1/ping").status_code == 200  # by then the server has read it
            assert client.get("/api/v1/ping").status_code == 200
    assert not [one for one in caplog.records if one.exc_info]


def test_clients_are_addresses() -> None:
    assert address_of_client("192.0.2.1") == "192.0.2.1"
    assert address_of_client("::ffff:192.0.2.1") == "192.0.2.1"
    assert address_of_client("2001:db8::1") == address_of_client("2001:db8::ffff:2") == "2001:db8::/64"
    assert address_of_client("2001:db8:0:1::1") != address_of_client("2001:db8::1")
    assert address_of_client(None) == address_of_client("testclient") == ""


def test_who_waits_longest_makes_room_and_nobody_who_is_answered() -> None:
    ended: list[int] = []

    class Held:
        def __init__(self, number: int, address: str, *, waits: bool) -> None:
            self.client, self.waits, self.since = (address, 1), waits, float(number)
            self.transport = SimpleNamespace(abort=lambda: ended.append(number))

    def made(number: int, address: str, *, waits: bool) -> Connection:
        return cast("Connection", cast("Any", Held(number, address, waits=waits)))

    known = Connections(replace(Limits(), connections=4, connections_per_client=2))
    assert known.add(made(0, "192.0.2.1", waits=False))
    assert known.add(made(1, "192.0.2.1", waits=True))
    assert known.add(made(2, "192.0.2.1", waits=False))
    assert ended == [1]
    assert not known.add(made(3, "192.0.2.1", waits=False))
    assert known.add(made(4, "192.0.2.2", waits=True))
    assert known.add(made(5, "192.0.2.3", waits=True))
    assert ended == [1, 4]


def test_a_thread_that_serves_ends_with_clients_still_connected() -> None:
    with ExitStack() as stack:
        with running() as server:
            held = [stack.enter_context(connected(server)) for _ in range(3)]
        assert all(map(is_closed, held))
        assert "stayput-worker" not in {thread.name for thread in threading.enumerate() if thread.is_alive()}
