"""What the server refuses: sizes, lengths, counts, foreign hosts and origins, paths."""

from __future__ import annotations

import gzip
import json
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import httpx
import pytest
from serving import SCENE, Running, client_of, hold_verifications, running

from stayput.app.limits import Limits

if TYPE_CHECKING:
    from collections.abc import Iterator

    from stayput.app.service import Service

JSON = {"content-type": "application/json"}
SINE = {"amplitude": 1.0, "frequency": 1.0}


def refused(answer: httpx.Response, status: int, field: str | None = None) -> str:
    assert answer.status_code == status, answer.text
    problem = answer.json()
    assert set(problem) == {"message", "message_ja", "field"}
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
        ({"furniture": {}}, "scene.furniture.width"),
        ({"furniture": {"preset": "bokcase"}}, "scene.furniture.preset"),
        ({"furniture": {"preset": "chest", "shelvs": [1]}}, "scene.furniture.shelvs"),
        ({"room": {"left_wall": {"gap": -1}}}, "scene.room.left_wall.gap"),
        (
            {"shaking": {"sine": {**SINE, "duration": 1e4}}},
            "scene.shaking.sine.duration",
        ),
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
        ([{"type": "glue"}], "measures[0].type"),
        ([{}], "measures[0].type"),
        ([{"type": "gel_mats", "area": -1.0}], "measures[0].area"),
        ([{"type": "gel_mats", "colour": 1}], "measures[0].colour"),
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
    for host in ("[::1", "[::1]x", "[1.2.3.4]", "::1", "[]", "", "[", "]", "localhost:x", "a@localhost"):
        refused(client.get("/api/v1/ping", headers={"host": host}), 400)
    for origin in ("http://[", "http://", "", "http://[::1", "ftp://localhost", "http://a@b", "\xe9"):
        refused(client.get("/api/v1/ping", headers={"origin": origin.encode("latin-1")}), 403)
    assert client.get("/api/v1/ping", headers={"host": "[::1]:8000"}).status_code == 200
    assert client.get("/api/v1/ping", headers={"host": "localhost:1234"}).status_code == 200
    own = {"origin": server.address}
    assert client.get("/api/v1/ping", headers=own).status_code == 200


def test_every_answer_has_its_headers(client: httpx.Client) -> None:
    answers = [
        client.get("/"),
        client.get("/api/v1/ping"),
        client.get("/api/docs"),
        client.get("/nothing"),
        client.post("/api/v1/simulate", content=b"x", headers=JSON),
        client.get("/", headers={"host": "evil.example"}),
        client.options("/api/v1/simulate", headers={"access-control-request-method": "POST"}),
    ]
    for answer in answers:
        headers = answer.headers
        assert "default-src 'self'" in headers["content-security-policy"]
        assert "frame-ancestors 'none'" in headers["content-security-policy"]
        assert headers["x-content-type-options"] == "nosniff"
        assert headers["referrer-policy"] == "no-referrer"
        assert not [name for name in headers if name.startswith("access-control")]
        assert "server" not in headers


def test_jobs_are_bounded_and_cancelled_ones_stop_computing() -> None:
    limits = replace(Limits(), jobs_running=1, jobs_waiting=1, threads=1, samples=20_000)
    scene = {**SCENE, "uncertainty": {"samples": 20_000}}  # seconds on any machine
    asked = {"scene": scene, "measures": [{"type": "anti_slip_sheet"}], "compare_usual": False}
    with running(limits) as server, client_of(server) as client:
        first, second = (client.post("/api/v1/verify", json=asked).json() for _ in range(2))
        assert second["state"] == "waiting"
        third = client.post("/api/v1/verify", json=asked)
        refused(third, 429)
        assert int(third.headers["retry-after"]) > 0
        deadline = time.monotonic() + 30.0
        while client.get(f"/api/v1/jobs/{first['id']}").json()["done"] == 0:
            assert time.monotonic() < deadline
            time.sleep(0.05)
        refused(client.get(f"/api/v1/jobs/{first['id']}/report"), 409)
        for job in (second, first):
            assert client.delete(f"/api/v1/jobs/{job['id']}").json()["state"] == "cancelled"
        # the only thread for jobs is free again long before the first could have ended
        few = {**asked, "scene": {**SCENE, "uncertainty": {"samples": 1}}}
        third = client.post("/api/v1/verify", json=few).json()
        while (job := client.get(f"/api/v1/jobs/{third['id']}").json())["state"] != "done":
            assert job["state"] in ("waiting", "running")
            assert time.monotonic() < deadline
            time.sleep(0.05)
        gone = client.get(f"/api/v1/jobs/{first['id']}").json()
        assert gone["state"] == "cancelled"
        assert gone["done"] < gone["total"]


def test_a_job_that_nobody_asks_for_gives_way(monkeypatch: pytest.MonkeyPatch) -> None:
    limits = replace(Limits(), jobs_running=1, jobs_waiting=2, threads=1)
    asked = {"scene": SCENE, "measures": [{"type": "anti_slip_sheet"}], "compare_usual": False}
    go_on = hold_verifications(monkeypatch)
    with running(limits) as server, client_of(server) as client:

        def post(**more: float) -> str:
            return client.post("/api/v1/verify", json={**asked, **more}).json()["id"]

        def state(name: str) -> str:
            return client.get(f"/api/v1/jobs/{name}").json()["state"]

        left, unasked, awaited = post(lease_s=1.0), post(lease_s=1.0), post(lease_s=3.0)
        refused(client.post("/api/v1/verify", json=asked), 429)
        deadline = time.monotonic() + 60.0
        while state(awaited) != "running":
            assert state(awaited) == "waiting"
            assert time.monotonic() < deadline
            time.sleep(0.2)
        service: Service = server.app.state.service
        assert {service.jobs.get(name).state for name in (left, unasked)} == {"cancelled"}
        until = time.monotonic() + 4.0
        while time.monotonic() < until:  # it goes on for as long as it is asked for
            assert state(awaited) == "running"
            time.sleep(0.2)
        refused(client.post("/api/v1/verify", json={**asked, "lease_s": 0.0}), 422, "lease_s")
        go_on.set()
        while state(awaited) != "done":
            assert time.monotonic() < deadline + 60.0
            time.sleep(0.2)


def test_a_map_whose_client_has_left_gives_way() -> None:
    slow = {"suite": {"count": 12}, "building": {"storeys": 8}, "storey": 7}
    asked = {"scene": {**SCENE, "shaking": {**slow, "intensity": 6.0}}, "measures": []}
    quick = {"scene": {**SCENE, "shaking": {"suite": {"count": 1}, "intensity": 6.0}}, "measures": []}
    limits = replace(Limits(), slow_workers=1, threads=1)
    with running(limits) as server, client_of(server) as client:
        client.post("/api/v1/size-map", json=quick)  # what is compiled, and the suite, are there
        start = time.monotonic()
        client.post("/api/v1/size-map", json=asked)
        whole = time.monotonic() - start
        changed = {**asked, "scene": {**asked["scene"], "shaking": {**slow, "storey": 6, "intensity": 6.0}}}
        with pytest.raises(httpx.ReadTimeout):
            client.post("/api/v1/size-map", json=changed, timeout=0.3)
        start = time.monotonic()
        assert client.post("/api/v1/size-map", json=quick).status_code == 200
        assert time.monotonic() - start < 0.7 * whole


def test_too_many_simulations_are_refused_before_any() -> None:
    with running(replace(Limits(), runs=1000)) as server, client_of(server) as client:
        answer = client.post("/api/v1/verify", json={"scene": SCENE})
        assert "simulations" in refused(answer, 422, "scene.uncertainty.samples")


def test_a_busy_server_says_so() -> None:
    limits = replace(Limits(), workers=1, waiting=1)
    with running(limits) as server, client_of(server) as client:
        with ThreadPoolExecutor(12) as pool:
            asked = [pool.submit(simulate, client, SCENE, [{"type": "belt"}]) for _ in range(12)]
            found = [one.result().status_code for one in asked]
        assert set(found) == {200, 503}
        assert simulate(client, SCENE).status_code == 200


def test_slow_bodies_are_given_up() -> None:
    def slowly() -> Iterator[bytes]:
        yield b"{"
        time.sleep(1.5)
        yield b"}"

    with running(replace(Limits(), seconds=0.3)) as server, client_of(server) as client:
        answer = client.post("/api/v1/simulate", content=slowly(), headers=JSON)
        refused(answer, 408)


def test_pings_are_answered_while_others_compute(client: httpx.Client) -> None:
    """A lenient bound: `benchmarks/app.py` measures it."""
    stop = threading.Event()
    scene = {**SCENE, "uncertainty": {"samples": 200}}
    job = client.post("/api/v1/verify", json={"scene": scene, "measures": [{"type": "belt"}]}).json()

    def load() -> None:
        while not stop.is_set():
            simulate(client, SCENE, [{"type": "l_bracket"}])

    loader = threading.Thread(target=load)
    loader.start()
    try:
        times = []
        for _ in range(100):
            start = time.perf_counter()
            assert client.get("/api/v1/ping").status_code == 200
            times.append(time.perf_counter() - start)
    finally:
        stop.set()
        loader.join()
        client.delete(f"/api/v1/jobs/{job['id']}")
    assert sorted(times)[90] < 0.25
