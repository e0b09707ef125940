"""What the server refuses: sizes, lengths, counts, foreign hosts and origins, paths."""

from __future__ import annotations

import gzip
import json
import threading
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import pytest
from serving import SCENE, Clock, Running, client_of, hold_verifications, running

from stayput.app import jobs
from stayput.app.limits import Limits
from stayput.app.running import simulated
from waiting import PATIENCE, wait_until

if TYPE_CHECKING:
    from collections.abc import Iterator

    import httpx

    from stayput.app.service import Service

JSON = {"content-type": "application/json"}
SINE = {"amplitude": 1.0, "frequency": 1.0}


def refused(answer: httpx.Response, status: int, field: str | None = None) -> str:
    assert answer.status_code == status, answer.text
    problem = answer.json()
    assert set(problem) == {"message", "message_ja", "field", "perhaps", "also"}
    assert problem["message"].endswith((".", "…"))
    if field is not None:
        assert problem["field"] == field
    return problem["message"]


def simulate(client: httpx.Client, scene: Any, measures: Any = ()) -> httpx.Response:
    content = json.dumps({"scene": scene, "measures": list(measures)})  # in ASCII, halves of pairs too
    return client.post("/api/v1/simulate", content=content, headers=JSON)


@pytest.mark.parametrize(
    ("changed", "field"),
    [
        ({"furniture": {"preset": "chest", "shelvs": [1]}}, "scene.furniture.shelvs"),
        ({"shaking": {"sine": {**SINE, "duration": 1e4}}}, "scene.shaking.sine.duration"),
        ({"shaking": {"sine": {**SINE, "dt": 1e-6}}}, "scene.shaking.sine.dt"),
        ({"shaking": {"suite": {"count": 500}}}, "scene.shaking.suite.count"),
        ({"shaking": {"building": {"storeys": 150}, "storey": 1}}, "scene.shaking.building.storeys"),
        ({"shaking": {"building": {"storeys": 3}}}, None),
        ({"uncertainty": {"samples": 100_000}}, "scene.uncertainty.samples"),
        ({"title": "\ud800"}, "scene"),
        ({"measures": [{"type": "belt", "name": str(n)} for n in range(30)]}, "scene.measures"),
    ],
)
def test_a_scene_that_is_refused_says_where(client: httpx.Client, changed: Any, field: str | None) -> None:
    refused(simulate(client, {**SCENE, **changed}), 422, field)


@pytest.mark.parametrize(
    ("measures", "field"),
    [
        ([{"type": "gel_mats"}, {"type": "anti_slip_sheet"}], None),
        ([{"type": "gel_mats", "area": -1.0}], "measures[0].area"),
        (["gel_mats"], "measures.0"),
        ([{"type": "belt"}] * 9, "measures"),
        ([{"type": "tension_pole", "setback": 1.0}], "measures"),
    ],
)
def test_measures_that_are_refused(client: httpx.Client, measures: Any, field: str | None) -> None:
    refused(simulate(client, SCENE, measures), 422, field)


def test_a_scene_names_no_file_of_the_server(client: httpx.Client) -> None:
    for key, value in (
        ("record", "/etc/passwd"),
        ("record", "../x"),
        ("record", "0" * 32),
        ("across", "/etc/passwd"),
        ("vertical", "/etc/passwd"),
        ("suite", "/etc"),
    ):
        told = refused(simulate(client, {**SCENE, "shaking": {key: value}}), 422, f"scene.shaking.{key}")
        assert "passwd" not in told
    shaking = {"record": "0" * 32, "vertical": "/etc/hosts"}
    refused(simulate(client, {**SCENE, "shaking": shaking}), 422)


def test_what_is_no_json_is_refused(client: httpx.Client) -> None:
    def post(content: bytes) -> httpx.Response:
        return client.post("/api/v1/simulate", content=content, headers=JSON)

    refused(post(b"{"), 400)
    refused(post(b"[" * 100_000), 400)
    refused(post(b"\xff\xfe"), 400)
    refused(post(b'{"scene": NaN}'), 422)
    refused(post(b"[]"), 422)
    refused(post(gzip.compress(b'{"scene": {}}')), 400)
    assert client.get("/api/v1/ping").status_code == 200


def test_large_bodies_are_refused_with_a_length_and_without(client: httpx.Client) -> None:
    limits = Limits()
    refused(client.post("/api/v1/simulate", content=b"x" * (limits.body + 1), headers=JSON), 413)

    def chunks(first: bytes, count: int) -> Iterator[bytes]:
        yield first
        for _ in range(count):
            yield b"x" * 65536

    endless = chunks(b'{"scene": "', limits.body // 65536 + 1)
    refused(client.post("/api/v1/simulate", content=endless, headers=JSON), 413)
    head = b'--b\r\nContent-Disposition: form-data; name="file"; filename="a"\r\n\r\n'
    endless = chunks(head, limits.upload // 65536 + 1)
    form = {"content-type": "multipart/form-data; boundary=b"}
    refused(client.post("/api/v1/motions", content=endless, headers=form), 413)
    assert client.get("/api/v1/ping").status_code == 200


def test_other_hosts_and_origins_are_refused(client: httpx.Client, server: Running) -> None:
    refused(client.get("/api/v1/ping", headers={"host": "evil.example"}), 400)
    refused(client.get("/", headers={"host": "127.0.0.1.evil.example:80"}), 400)
    refused(client.get("/", headers={"host": "evil.example@127.0.0.1"}), 400)
    refused(client.post("/api/v1/simulate", json={}, headers={"origin": "http://evil.example"}), 403)
    refused(client.post("/api/v1/simulate", json={}, headers={"origin": "null"}), 403)
    for host in ("[::1]x", "[]", "", "[", "]", "localhost:x", "a@localhost"):
        refused(client.get("/api/v1/ping", headers={"host": host}), 400)
    for origin in ("http://[", "http://", "", "http://[::1", "ftp://localhost", "http://a@b", "\xe9"):
        refused(client.get("/api/v1/ping", headers={"origin": origin.encode("latin-1")}), 403)
    assert client.get("/api/v1/ping", headers={"host": "[::1]:8000"}).status_code == 200
    assert client.get("/api/v1/ping", headers={"host": "localhost:1234"}).status_code == 200
    own = {"origin": server.address}
    assert client.get("/api/v1/ping", headers=own).status_code == 200


def test_behind_a_proxy_the_server_goes_by_the_name_that_it_was_given() -> None:
    host, addresses = "stayput.example.org", ["192.0.2.1", "192.0.2.2"]
    with running(None, host) as server, client_of(server) as client:
        for origin, status in ((f"https://{host}", 422), ("https://evil.example", 403)):
            headers = {"host": host, "origin": origin}
            refused(client.post("/api/v1/simulate", json={}, headers=headers), status)
        refused(client.get("/", headers={"host": f"{host}.evil.example"}), 400)
        with client_of(server) as uploading:
            for address in addresses:
                forwarded = {"host": host, "x-forwarded-for": address}
                file = {"file": ("a", "1\n-1\n0\n" * 9)}
                given = {"unit": "gal", "dt": "0.01"}
                assert uploading.post("/api/v1/motions", files=file, data=given, headers=forwarded).is_success
        stored = server.app.state.service.motions._stored.values()
        assert [one.client.address for one in stored] == addresses


def test_every_answer_has_its_headers(client: httpx.Client) -> None:
    answers = [
        client.get("/"),
        client.get("/api/v1/ping"),
        client.get("/api/openapi.json"),
        client.get("/nothing"),
        client.post("/api/v1/simulate", content=b"x", headers=JSON),
        client.get("/", headers={"host": "evil.example"}),
        client.options("/api/v1/simulate", headers={"access-control-request-method": "POST"}),
    ]
    for one in answers:
        headers = one.headers
        assert "default-src 'self'" in headers["content-security-policy"]
        assert "frame-ancestors 'none'" in headers["content-security-policy"]
        assert headers["x-content-type-options"] == "nosniff"
        assert headers["referrer-policy"] == "no-referrer"
        assert not [name for name in headers if name.startswith("access-control")]
        assert "server" not in headers


def test_a_job_that_nobody_asks_for_gives_way(monkeypatch: pytest.MonkeyPatch) -> None:
    limits = replace(Limits(), jobs_running=1, jobs_waiting=2, threads=1)
    asked = {"scene": SCENE, "measures": [{"type": "anti_slip_sheet"}], "compare_usual": False}
    go_on, clock = hold_verifications(monkeypatch), Clock(monkeypatch, jobs)
    with running(limits) as server, client_of(server) as client:

        def post(**more: float) -> str:
            return client.post("/api/v1/verify", json={**asked, **more}).json()["id"]

        def state(name: str) -> str:
            return client.get(f"/api/v1/jobs/{name}").json()["state"]

        left, unasked, awaited = post(lease_s=300.0), post(lease_s=300.0), post(lease_s=3000.0)
        refused(client.post("/api/v1/verify", json=asked), 429)
        assert state(awaited) == "waiting"
        refused(client.get(f"/api/v1/jobs/{awaited}/report"), 409)
        clock.ahead += 1000.0
        wait_until(lambda: state(awaited) == "running")
        service: Service = server.app.state.service
        assert {service.jobs.get(name).state for name in (left, unasked)} == {"cancelled"}
        for _ in range(3):  # it goes on for as long as it is asked for
            clock.ahead += 2000.0
            assert state(awaited) == "running"
        refused(client.post("/api/v1/verify", json={**asked, "lease_s": 0.0}), 422, "lease_s")
        go_on.set()
        wait_until(lambda: state(awaited) == "done")


def test_a_busy_server_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    go_on = threading.Event()

    def held(*given: Any) -> Any:
        assert go_on.wait(PATIENCE)
        return simulated(*given)

    monkeypatch.setattr("stayput.app.api.simulated", held)
    limits = replace(Limits(), workers=1, waiting=1)
    with running(limits) as server, client_of(server) as client:
        with ThreadPoolExecutor(12) as pool:
            asked = [pool.submit(simulate, client, SCENE, [{"type": "belt"}]) for _ in range(12)]
            wait_until(lambda: sum(one.done() for one in asked) == 10)
            go_on.set()
            found = [one.result().status_code for one in asked]
        assert sorted(found) == [200] * 2 + [503] * 10
        assert simulate(client, SCENE).status_code == 200
