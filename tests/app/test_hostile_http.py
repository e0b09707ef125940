"""Hostile requests: each gets an answer that refuses it or a closed connection, and the server goes on.

Whatever comes, nothing fails inside: no status 500, nothing in the log with a traceback.
"""

from __future__ import annotations

import json
import logging
import time
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from raw import PING, answer, connected, request
from serving import SCENE, Running, client_of, running

from long_cases import long
from stayput.app.limits import Limits
from waiting import PATIENCE

if TYPE_CHECKING:
    from collections.abc import Iterator

pytestmark = pytest.mark.hostile

JSON = "Content-Type: application/json"
FORM = "Content-Type: multipart/form-data; boundary=b"

# what looks at the log does so once for all examples; a busy machine takes its time to draw them
PATIENT = [HealthCheck.function_scoped_fixture, HealthCheck.too_slow]
HTTP = settings(deadline=None, max_examples=40, suppress_health_check=PATIENT, derandomize=True)


@pytest.fixture(scope="module")
def server() -> Iterator[Running]:
    with running(replace(Limits(), seconds=0.5)) as found:
        with client_of(found) as client:  # what is compiled first takes its time
            assert client.post("/api/v1/simulate", json={"scene": SCENE}).status_code == 200
        yield found


@pytest.fixture(autouse=True)
def nothing_failed(server: Running, caplog: pytest.LogCaptureFixture) -> Iterator[None]:
    caplog.set_level(logging.ERROR)
    yield
    with connected(server) as connection:
        connection.sendall(PING)
        assert answer(connection)[0] == 200
    assert not [one.getMessage() for one in caplog.records]


def sent(server: Running, data: bytes) -> tuple[int, bytes]:
    """Send bytes and return the status (0: closed without an answer) and the body."""
    began = time.monotonic()
    with connected(server) as connection:
        try:
            connection.sendall(data)
            found = answer(connection)
        except ConnectionError:
            found = 0, b""
    assert time.monotonic() - began < PATIENCE
    return found


@pytest.mark.parametrize(
    ("data", "statuses"),
    [
        (b"GET / HTTP/1.1\r\n\r\n", {400}),
        (b"GET / HTTP/1.0\r\n\r\n", {400}),
        (b"GET http://evil.example/ HTTP/1.1\r\nHost: localhost\r\n\r\n", {200, 400, 404}),
        (b"GET /" + b"a" * 60_000 + b" HTTP/1.1\r\nHost: localhost\r\n\r\n", {404}),
        (b"GET / HTTP/1.1\r\nHost: localhost\r\nX: " + b"\xff\xfe\r\n\r\n", {200, 400}),
        (b"GET /%ff%fe%00 HTTP/1.1\r\nHost: localhost\r\n\r\n", {404}),
        (b"GET /api/v1/jobs/%00 HTTP/1.1\r\nHost: localhost\r\n\r\n", {404, 422}),
        (b"GET /api/v1/motions/" + b"0" * 9999 + b" HTTP/1.1\r\nHost: localhost\r\n\r\n", {404, 422}),
        (b"GET /api/v1/ping?" + b"&a=" * 9999 + b" HTTP/1.1\r\nHost: localhost\r\n\r\n", {200}),
        (b"GET /api/v1/jobs/x/report?lang=../../etc HTTP/1.1\r\nHost: localhost\r\n\r\n", {404, 422}),
        (b"TRACE / HTTP/1.1\r\nHost: localhost\r\n\r\n", {404, 405}),
        (
            b"GET / HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n\r\n",
            {200, 400},
        ),
        (b"GET / HTTP/1.1\r\nHost: localhost\r\nRange: bytes=0-,0-,0-,0-\r\n\r\n", {200, 206}),
        (PING * 50, {200}),
    ],
)
def test_odd_requests(server: Running, data: bytes, statuses: set[int]) -> None:
    status, _ = sent(server, data)
    assert status in statuses


@pytest.mark.parametrize("header", ["Host", "Origin", "Content-Type", "Content-Length", "If-None-Match"])
@HTTP
@given(value=st.text(st.characters(min_codepoint=33, max_codepoint=255), max_size=40))
def test_any_value_of_a_header(server: Running, header: str, value: str) -> None:
    host = "" if header == "Host" else "Host: localhost\r\n"
    head = f"POST /api/v1/simulate HTTP/1.1\r\n{host}{header}: {value}\r\n\r\n"
    status, body = sent(server, head.encode("latin-1") + b"{}")
    assert status < 500
    if status and body.startswith(b"{"):
        assert json.loads(body)["message"]


PART = b'--b\r\nContent-Disposition: form-data; name="file"; filename="a"\r\n\r\n1\n2\n\r\n--b--\r\n'


@pytest.mark.parametrize(
    "body",
    [
        b"",
        b"--b",
        b"--b\r\n\r\n\r\n--b--\r\n",
        PART[:-8],
        PART.replace(b"--b", b"--c"),
        PART.replace(b'name="file"', b""),
        PART.replace(b'name="file"', b'name="' + b"x" * 100_000 + b'"'),
        PART.replace(b"filename", b"filename*=utf-8''%ff%fe; filename"),
        PART.replace(b'filename="a"', b'filename="\xff\x00\xfe"'),
        PART.replace(b"\r\n\r\n1", b"\r\n" + b"X: y\r\n" * 5000 + b"\r\n1"),
        PART.replace(b"\r\n\r\n1", b"\r\nContent-Type: text/plain; charset=" + b"x" * 9999 + b"\r\n\r\n1"),
        PART[:-7] + b"\r\n" + PART,
        (b"--b\r\n" + PART[5:-7]) * 500,
        b"\x00" * 100_000,
    ],
)
def test_broken_forms(server: Running, body: bytes) -> None:
    status, told = sent(server, request("/api/v1/motions", body, FORM))
    assert status in (400, 422)
    assert json.loads(told)["message"]


@pytest.mark.parametrize(("path", "kind"), [("/api/v1/motions", FORM), ("/api/v1/simulate", JSON)])
@pytest.mark.parametrize("missing", [1, 50, 10**6])
def test_bodies_that_end_too_early(server: Running, path: str, kind: str, missing: int) -> None:
    body = PART if kind is FORM else json.dumps({"scene": SCENE}).encode()
    cut = body[: -min(missing, len(body))]
    length = None if missing < len(body) else len(body) + missing
    status, _ = sent(server, request(path, cut, kind, length=len(body) if length is None else length))
    assert status in (0, 400, 408, 413)


def nested(depth: int, *, lists: bool) -> bytes:
    open_, close = (b"[", b"]") if lists else (b'{"a":', b"}")
    return open_ * depth + b"1" + close * depth


@pytest.mark.parametrize(("depth", "lists"), [(50, False), (900, True), (1500, False), (40_000, True)])
@pytest.mark.parametrize("place", ["", "scene.furniture", "scene.title", "measures"])
def test_deep_json(server: Running, place: str, depth: int, lists: bool) -> None:
    body = nested(depth, lists=lists)
    for key in reversed(place.split(".") if place else []):
        body = b'{"' + key.encode() + b'":' + body + b"}"
    if place == "measures":
        body = b'{"scene":{},' + body[1:]
    status, told = sent(server, request("/api/v1/simulate", body, JSON))
    assert status in (400, 413, 422)
    problem = json.loads(told)
    assert problem["message"]
    assert len(problem["message"]) < 1000


def values() -> list[Any]:
    return [
        *("1" * 5000, "-" + "9" * 4400, "1" + "0" * 400, "0." + "1" * 90_000, "1e999", "1e-999"),
        *("NaN", "Infinity", '"\\ud800"', '"\\u0000"', "null", "true", "[]", "{}"),
        *(json.dumps(one * 90_000) for one in ("x", "'", "=", "1 ")),
        *(json.dumps(many) for many in (["a"] * 40_000, [1e308] * 20_000, {"a" * 100_000: 1})),
        json.dumps({str(n): n for n in range(15_000)}),
    ]


PLACES = ["scene.furniture.width", *long("scene", "scene.furniture", "scene.shaking.record")]


@pytest.mark.parametrize("place", PLACES)
def test_huge_and_odd_values(server: Running, place: str) -> None:
    for body in values():
        for key in reversed(place.split(".")):
            body = f'{{"{key}": {body}}}'
        for path in ("simulate", "verify", "scenario/toml"):
            status, told = sent(server, request(f"/api/v1/{path}", body.encode(), JSON))
            assert status in (400, 413, 422)
            assert len(json.loads(told)["message"]) < 1000
