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

from stayput.app.connections import Connection, Connections
from stayput.app.connections import client_of as address_of_client
from stayput.app.limits import Limits

if TYPE_CHECKING:
    import pytest

FORM = "Content-Type: multipart/form-data; boundary=b"
HEAD = b'--b\r\nContent-Disposition: form-data; name="file"; filename="a"\r\n\r\n'
SHORT = replace(Limits(), header_seconds=0.4)
RECORD = "1\n-1\n0\n2\n" * 100
GIVEN = {"unit": "gal", "dt": "0.01"}


def test_silent_connections_make_room_and_are_closed() -> None:
    """As many as there may be, and more, of one client."""
    few = replace(SHORT, header_seconds=2.0, connections=20, connections_per_client=12)
    with running(few) as server, ExitStack() as stack, client_of(server) as client:
        silent = [stack.enter_context(connected(server)) for _ in range(30)]
        began = time.monotonic()
        assert client.get("/api/v1/ping").status_code == 200
        assert time.monotonic() - began < 1.5
        assert all(map(is_closed, silent))
        assert client.get("/api/v1/ping").status_code == 200


def test_headers_have_a_limited_time_also_where_they_drip() -> None:
    with running(SHORT) as server, connected(server) as connection:
        began = time.monotonic()
        try:
            for byte in PING[:-2]:
                connection.sendall(bytes([byte]))
                time.sleep(0.05)
        except ConnectionError:
            pass
        assert is_closed(connection)
        assert time.monotonic() - began < 5.0


def test_the_time_begins_anew_with_each_request() -> None:
    with running(SHORT) as server, connected(server) as connection:
        for _ in range(3):
            connection.sendall(PING[:20])
            time.sleep(0.2)
            connection.sendall(PING[20:])
            assert answer(connection)[0] == 200
        connection.sendall(PING + PING[:10])  # the second one stays in its beginnings
        assert answer(connection)[0] == 200
        assert is_closed(connection)


def test_a_body_that_drips_is_given_up_soon() -> None:
    with running(SHORT) as server, connected(server) as connection:
        connection.sendall(request("/api/v1/simulate", b"{", "Content-Type: application/json", length=1000))
        began = time.monotonic()
        status, body = answer(connection)
        assert status == 408
        assert json.loads(body)["message"] == "The body came too slowly."
        assert time.monotonic() - began < 5.0


def test_uploads_that_drip_do_not_block_another() -> None:
    """Not even where they are as many as there may be, and are allowed to be slow."""
    limits = replace(Limits(), uploads_per_client=2)
    with running(limits) as server, ExitStack() as stack, client_of(server) as client:
        slow = [stack.enter_context(connected(server)) for _ in range(4)]
        for one in slow:
            one.sendall(request("/api/v1/motions", HEAD, FORM, length=100_000))
            time.sleep(1.1)
        began = time.monotonic()
        sent = client.post("/api/v1/motions", files={"file": ("a", RECORD)}, data=GIVEN)
        assert sent.status_code == 201, sent.text
        assert time.monotonic() - began < 5.0
        assert answer(slow[0])[0] == 408


def test_uploads_that_come_fast_are_not_ended_by_another() -> None:
    limits = replace(Limits(), uploads_per_client=1)
    with running(limits) as server, connected(server) as first, client_of(server) as client:
        first.sendall(request("/api/v1/motions", HEAD + b"1\n" * 100_000, FORM, length=300_000))
        time.sleep(0.3)
        sent = client.post("/api/v1/motions", files={"file": ("a", RECORD)}, data=GIVEN)
        assert sent.status_code == 429
        assert sent.json()["message_ja"]
        first.sendall(b"1\n" * 60_000)
        assert answer(first)[0] == 422


def test_one_client_has_so_many_requests_at_a_time() -> None:
    with running(replace(Limits(), requests_per_client=2)) as server, ExitStack() as stack:
        held = [stack.enter_context(connected(server)) for _ in range(2)]
        for one in held:
            one.sendall(request("/api/v1/simulate", b"{", "Content-Type: application/json", length=10))
        time.sleep(0.3)
        with client_of(server) as client:
            assert client.get("/api/v1/ping").status_code == 503
            for one in held:
                one.sendall(b"}" * 9)
                assert answer(one)[0] == 400
            assert client.get("/api/v1/ping").status_code == 200


def test_a_client_that_leaves_is_no_failure(caplog: pytest.LogCaptureFixture) -> None:
    with running() as server, client_of(server) as client:
        for path in ("/api/v1/motions", "/api/v1/simulate"):
            with connected(server) as connection:
                connection.sendall(request(path, HEAD, FORM, length=1000))
                time.sleep(0.1)
        assert client.get("/api/v1/ping").status_code == 200
        time.sleep(0.2)
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
