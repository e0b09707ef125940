"""Clients that leave or are many."""

from __future__ import annotations

import json
import threading
from contextlib import ExitStack
from dataclasses import replace
from typing import TYPE_CHECKING

import pytest
from raw import PING, answer, connected, is_closed, request
from serving import SCENE, client_of, running
from test_api_space import PIECES

from stayput.app import downloads
from stayput.app import running as scene_runs
from stayput.app.limits import Limits
from stayput.app.running import runs_of
from waiting import PATIENCE, wait_until

if TYPE_CHECKING:
    from collections.abc import Callable

    from stayput.scenario import Scenario
    from stayput.simulation.run import Run

FORM = "Content-Type: multipart/form-data; boundary=b"
HEAD = b'--b\r\nContent-Disposition: form-data; name="file"; filename="a"\r\n\r\n'


def test_more_connections_than_allowed_are_told_that_the_server_is_busy() -> None:
    few = replace(Limits(), connections=5)
    with running(few) as server, ExitStack() as stack, client_of(server) as client:
        held = [stack.enter_context(connected(server)) for _ in range(5)]
        assert client.get("/api/v1/ping").status_code == 503
        for one in held:
            one.close()
        wait_until(lambda: client.get("/api/v1/ping").status_code == 200)


def test_a_connection_that_sends_no_whole_head_is_closed() -> None:
    with running(replace(Limits(), head_seconds=0.4)) as server, ExitStack() as stack:
        for before, begun in ((b"", b""), (b"", b"GET / HT"), (PING, b"GET / HT")):
            connection = stack.enter_context(connected(server))
            if before:  # then it is the head of the second request
                connection.sendall(before)
                assert answer(connection)[0] == 200
            connection.sendall(begun)
            assert is_closed(connection)


def test_an_address_that_is_no_proxy_has_few_connections(monkeypatch: pytest.MonkeyPatch) -> None:
    few = replace(Limits(), connections_per_address=3)
    for proxy, closed in (("127.0.0.1", 0), ("192.0.2.1", 2)):
        monkeypatch.setenv("FORWARDED_ALLOW_IPS", proxy)
        with running(few) as server, ExitStack() as stack:
            connections = [stack.enter_context(connected(server)) for _ in range(5)]
            for connection in connections[: 5 - closed]:
                connection.sendall(PING)
                assert answer(connection)[0] == 200
            assert all(map(is_closed, connections[5 - closed :]))


def test_a_body_that_drips_is_given_up() -> None:
    with running(replace(Limits(), seconds=0.4)) as server, connected(server) as connection:
        connection.sendall(request("/api/v1/simulate", b"{", "Content-Type: application/json", length=1000))
        status, body = answer(connection)
        assert status == 408
        assert json.loads(body)["message"] == "The body came too slowly."


def test_a_client_that_leaves_is_no_failure(caplog: pytest.LogCaptureFixture) -> None:
    with running() as server, client_of(server) as client:
        for path in ("/api/v1/motions", "/api/v1/simulate"):
            with connected(server) as connection:
                connection.sendall(request(path, HEAD, FORM, length=1000))
                assert client.get("/api/v1/ping").status_code == 200  # by then the server has read it
            assert client.get("/api/v1/ping").status_code == 200
    assert not [one for one in caplog.records if one.exc_info]


def test_a_thread_that_serves_ends_with_clients_still_connected() -> None:
    with ExitStack() as stack:
        with running() as server:
            held = [stack.enter_context(connected(server)) for _ in range(3)]
        assert all(map(is_closed, held))
        assert "stayput-worker" not in {thread.name for thread in threading.enumerate() if thread.is_alive()}


@pytest.mark.parametrize("path", ["simulate", "simulate/csv"])
def test_several_pieces_are_given_up_when_their_client_leaves(
    monkeypatch: pytest.MonkeyPatch, path: str
) -> None:
    """They would take for ever: only a run that is given up ends them."""
    begun = threading.Event()

    def run(scenario: Scenario, *_: object, **__: object) -> list[Run]:
        begun.set()
        while not (found := runs_of(scenario))[0].given_up:
            pass
        return found

    monkeypatch.setattr(scene_runs, "runs_of", run)
    monkeypatch.setattr(downloads, "runs_of", run)
    body = json.dumps({"scene": PIECES}).encode()
    with running() as server, client_of(server) as client:
        with connected(server) as connection:
            connection.sendall(request(f"/api/v1/{path}", body, "Content-Type: application/json"))
            assert begun.wait(PATIENCE)
        wait_until(lambda: not server.app.state.service.slow.asking)
        assert client.get("/api/v1/ping").status_code == 200


def test_a_film_is_drawn_no_further_when_its_client_leaves(monkeypatch: pytest.MonkeyPatch) -> None:
    begun = threading.Event()

    def endless(*_: object, progress: Callable[[int, int], None], **__: object) -> None:
        begun.set()
        while True:
            progress(1, 2)

    monkeypatch.setattr(downloads, "animate_run", endless)
    body = json.dumps({"scene": SCENE}).encode()
    with running() as server:
        with connected(server) as connection:
            connection.sendall(request("/api/v1/simulate/film", body, "Content-Type: application/json"))
            assert begun.wait(PATIENCE)
        wait_until(lambda: not server.app.state.service.slow.asking)
