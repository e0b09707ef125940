"""One client cannot keep others waiting: ten of them, with jobs that never end by themselves."""

from __future__ import annotations

import threading
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import httpx
from serving import COMPILING, SCENE, Running, client_of, running

from stayput.app import api, jobs
from stayput.app.limits import Limits
from stayput.app.turns import CLIENT_HEADER
from waiting import wait_until

if TYPE_CHECKING:
    from collections.abc import Callable

    import pytest

FEW = {**SCENE, "uncertainty": {"samples": 1}}
ASKED = {"scene": FEW, "measures": [{"type": "anti_slip_sheet"}], "compare_usual": False, "curves": False}


def page(server: Running, name: str) -> httpx.Client:
    return httpx.Client(
        base_url=server.address, timeout=COMPILING, trust_env=False, headers={CLIENT_HEADER: name}
    )


def slow_where(patched: pytest.MonkeyPatch, title: str) -> threading.Event:
    """Let jobs of scenes with a title go on until the event is set."""
    go_on, verify = threading.Event(), api.verify

    def held(scenario: Any, *, on_progress: Callable[[int, int], None], **more: Any) -> Any:
        while scenario.title == title and not go_on.wait(0.005):
            on_progress(1, 1000)
        return verify(scenario, on_progress=on_progress, **more)

    patched.setattr(api, "verify", held)
    return go_on


def test_nine_short_jobs_end_while_a_long_one_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jobs, "SLICE", 0.02)
    go_on = slow_where(monkeypatch, "long")
    with running(replace(Limits(), threads=1)) as server, client_of(server) as anybody:
        with page(server, "greedy") as greedy:
            long = [
                greedy.post("/api/v1/verify", json={**ASKED, "scene": {**FEW, "title": "long"}}).json()["id"]
                for _ in range(3)
            ]

        def state(name: str) -> Any:
            return anybody.get(f"/api/v1/jobs/{name}").json()

        wait_until(lambda: state(long[0])["state"] == "running")
        assert [state(name)["position"] for name in long[1:]] == [1, 2]

        def short(number: int) -> str:
            with page(server, str(number)) as own:
                return own.post("/api/v1/verify", json=ASKED).json()["id"]

        with ThreadPoolExecutor(9) as nine:
            names = list(nine.map(short, range(9)))
        wait_until(lambda: all(state(name)["state"] == "done" for name in names))
        assert state(long[0])["state"] == "running"  # and goes on
        assert [state(name)["state"] for name in long[1:]] == ["waiting", "waiting"]
        before = state(long[0])["seconds"]
        go_on.set()
        wait_until(lambda: all(state(name)["state"] == "done" for name in long))
        assert state(long[0])["seconds"] > before
        assert all(state(name)["position"] is None for name in (*names, *long))


def test_the_place_in_the_queue_gets_better(monkeypatch: pytest.MonkeyPatch) -> None:
    go_on = slow_where(monkeypatch, "long")
    monkeypatch.setattr(jobs, "SLICE", 1e9)  # the first keeps its turn
    with running(replace(Limits(), threads=1)) as server, client_of(server) as client:
        asked = {**ASKED, "scene": {**FEW, "title": "long"}}
        names = [client.post("/api/v1/verify", json=asked).json()["id"] for _ in range(3)]

        def position(name: str) -> int | None:
            return client.get(f"/api/v1/jobs/{name}").json()["position"]

        wait_until(lambda: position(names[0]) is None)
        assert [position(name) for name in names] == [None, 1, 2]
        client.delete(f"/api/v1/jobs/{names[1]}")
        assert [position(name) for name in names] == [None, None, 1]
        go_on.set()
        wait_until(lambda: client.get(f"/api/v1/jobs/{names[2]}").json()["state"] == "done")


def test_one_address_may_not_fill_the_queue(monkeypatch: pytest.MonkeyPatch) -> None:
    go_on = slow_where(monkeypatch, "long")
    with running(replace(Limits(), threads=1, jobs_per_address=3)) as server, client_of(server) as client:
        asked = {**ASKED, "scene": {**FEW, "title": "long"}, "lease_s": 300.0}
        for number in range(3):
            with page(server, str(number)) as own:
                assert own.post("/api/v1/verify", json=asked).status_code == 202
        assert client.post("/api/v1/verify", json=asked).status_code == 429
        go_on.set()


def test_a_greedy_page_leaves_room_for_the_others_of_its_address(monkeypatch: pytest.MonkeyPatch) -> None:
    go_on = slow_where(monkeypatch, "long")
    with running(replace(Limits(), threads=1)) as server:
        asked = {**ASKED, "scene": {**FEW, "title": "long"}, "lease_s": 300.0}
        with page(server, "greedy") as greedy:
            answers = [greedy.post("/api/v1/verify", json=asked).status_code for _ in range(8)]
        assert answers == [202] * 5 + [429] * 3
        for number in range(9):
            with page(server, str(number)) as own:
                assert own.post("/api/v1/verify", json=asked).status_code == 202
        go_on.set()


def test_requests_of_one_page_let_another_pass(monkeypatch: pytest.MonkeyPatch) -> None:
    held, order, simulated = threading.Event(), [], api.run_csv

    def counted(scenario: Any, **more: Any) -> str:
        held.wait(COMPILING)
        order.append(scenario.title)
        return simulated(scenario, **more)

    monkeypatch.setattr(api, "run_csv", counted)
    with running(replace(Limits(), slow_workers=1)) as server:

        def ask(name: str) -> int:
            with page(server, name) as own:
                asked = {"scene": {**SCENE, "title": name}, "measures": []}
                return own.post("/api/v1/simulate/csv", json=asked).status_code

        service = server.app.state.service
        with ThreadPoolExecutor(8) as threads:
            greedy = [threads.submit(ask, "greedy") for _ in range(5)]
            wait_until(lambda: len(service.slow.waiting) == 4)
            other = threads.submit(ask, "other")
            wait_until(lambda: len(service.slow.waiting) == 5)
            held.set()
            assert {one.result() for one in (*greedy, other)} == {200}
    assert order.index("other") <= 2
