"""One client cannot keep others waiting, and cannot put out what is kept for them."""

from __future__ import annotations

import threading
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, cast

import httpx
import pytest
from hypothesis import given
from hypothesis import strategies as st
from raw import connected
from serving import COMPILING, SCENE, Running, client_of, running

from stayput.app import api, jobs
from stayput.app.jobs import CLIENT_HEADER, NOBODY, Client, StoppedError, Turn, Turns, first_to_go
from stayput.app.limits import Limits
from waiting import wait_until

if TYPE_CHECKING:
    from collections.abc import Callable

    from stayput.verification import Verdict

FEW = {**SCENE, "uncertainty": {"samples": 1}}
ASKED = {"scene": FEW, "measures": [{"type": "anti_slip_sheet"}], "compare_usual": False, "curves": False}


def page(server: Running, name: str, address: str = "127.0.0.1") -> httpx.Client:
    """Return a page at an address, as a proxy on this machine tells of it."""
    headers = {CLIENT_HEADER: name, "X-Forwarded-For": address}
    return httpx.Client(base_url=server.address, timeout=COMPILING, trust_env=False, headers=headers)


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

        def short(number: int) -> str:
            with page(server, str(number)) as own:
                return own.post("/api/v1/verify", json=ASKED).json()["id"]

        with ThreadPoolExecutor(9) as nine:
            names = list(nine.map(short, range(9)))
        wait_until(lambda: all(state(name)["state"] == "done" for name in names))
        assert all(state(name)["state"] == "running" for name in long)  # and go on
        go_on.set()
        wait_until(lambda: all(state(name)["state"] == "done" for name in long))
        assert all(state(name)["position"] is None for name in (*names, *long))


def test_a_client_may_not_fill_the_queue(monkeypatch: pytest.MonkeyPatch) -> None:
    go_on = slow_where(monkeypatch, "long")
    with running(replace(Limits(), threads=1, jobs_per_address=8)) as server:
        asked = {**ASKED, "scene": {**FEW, "title": "long"}, "lease_s": 300.0}

        def answered(name: str, count: int, address: str = "127.0.0.1") -> list[int]:
            with page(server, name, address) as own:
                return [own.post("/api/v1/verify", json=asked).status_code for _ in range(count)]

        assert answered("greedy", 7) == [202] * 5 + [429] * 2
        assert answered("other", 4) == [202] * 3 + [429]  # of the same address
        assert answered("greedy", 1, "192.0.2.7") == [202]
        go_on.set()


@pytest.mark.parametrize("names", [["greedy"] * 5, list("abcde")], ids=["one page", "invented pages"])
def test_requests_of_one_page_or_address_let_another_pass(
    monkeypatch: pytest.MonkeyPatch, names: list[str]
) -> None:
    held, order, simulated = threading.Event(), [], api.run_csv

    def counted(scenario: Any, **more: Any) -> str:
        held.wait(COMPILING)
        order.append(scenario.title)
        return simulated(scenario, **more)

    monkeypatch.setattr(api, "run_csv", counted)
    with running(replace(Limits(), slow_workers=1)) as server:

        def ask(name: str, address: str = "192.0.2.7") -> int:
            with page(server, name, address) as own:
                asked = {"scene": {**SCENE, "title": name}, "measures": []}
                return own.post("/api/v1/simulate/csv", json=asked).status_code

        asking = server.app.state.service.slow.asking
        with ThreadPoolExecutor(8) as threads:
            greedy = [threads.submit(ask, name) for name in names]
            wait_until(lambda: asking.total() == 5)
            other = threads.submit(ask, "other", "192.0.2.8")
            wait_until(lambda: asking.total() == 6)
            held.set()
            assert {one.result() for one in (*greedy, other)} == {200}
        wait_until(lambda: not asking)
    assert order.index("other") <= 2


@dataclass(eq=False)
class Record:
    client: Client
    last_used: float


@given(st.lists(st.tuples(st.sampled_from("AB"), st.sampled_from("xyz"), st.integers(0, 9)), min_size=1))
def test_nobody_who_has_less_gives_way(found: list[tuple[str, str, int]]) -> None:
    kept = [Record(Client(address, name), used) for address, name, used in found]

    def share(one: Record) -> tuple[int, int]:
        clients = [each.client for each in kept]
        return [each.address for each in clients].count(one.client.address), clients.count(one.client)

    gone = first_to_go(kept)
    largest = [one for one in kept if share(one) == max(map(share, kept))]
    assert gone in largest
    assert gone.last_used == min(one.last_used for one in largest)


def test_long_work_takes_turns_and_what_is_not_wanted_leaves(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jobs, "SLICE", 0.0)
    shared, order, wanted = Turns(1), [], {"a": True, "b": True, "c": True}
    begun = {name: Turn(shared, lambda name=name: wanted[name], "") for name in wanted}
    assert [begun[name].position for name in wanted] == [0, 1, 2]

    def work(name: str) -> None:
        with suppress(StoppedError), begun[name] as turn:
            for _ in range(3):
                order.append(name)
                wanted["b"] = order.count("b") < 2
                turn.go_on()

    threads = [threading.Thread(target=work, args=(name,)) for name in wanted]
    for one in threads:
        one.start()
    for one in threads:
        one.join(COMPILING)
    assert "".join(order) == "abcabcac"
    assert shared.queue == []
    with pytest.raises(StoppedError), Turn(shared, lambda: False, ""):
        pass
    assert shared.queue == []


def test_an_address_with_much_work_waits_no_less_than_one_with_little() -> None:
    shared = Turns(1)
    asked = [Turn(shared, lambda: True, address) for address in "AAAABAB"]
    assert [asked.index(turn) for turn in shared.in_order()] == [0, 4, 1, 6, 2, 3, 5]
    assert asked[4].position == 1


def test_a_plan_lets_another_pass_and_ends_when_its_client_leaves(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jobs, "SLICE", 0.02)
    monkeypatch.setattr(api, "plan_html", lambda *_: "made")

    def plan(job: jobs.Job, *_: object) -> None:
        *_, note_progress = _
        while job.id == endless.id:
            note_progress(1)

    monkeypatch.setattr(api, "_plan", plan)
    room = SimpleNamespace(scenario=SimpleNamespace(plan=object()))  # at more nothing looks
    verdict = cast("Verdict", room)
    endless, short = (jobs.Job(name * 32, 1, NOBODY, state="done", verdict=verdict) for name in "ab")
    with running() as server:
        service = server.app.state.service
        service.jobs._jobs |= {job.id: job for job in (endless, short)}
        with connected(server) as leaving, client_of(server) as client:
            head = f"GET /api/v1/jobs/{endless.id}/plan HTTP/1.1\r\nHost: localhost\r\n\r\n"
            leaving.sendall(head.encode())
            wait_until(lambda: sum(endless.plan_runs.values()) > 0)
            assert client.get(f"/api/v1/jobs/{short.id}/plan").text == "made"
            before = sum(endless.plan_runs.values())
            wait_until(lambda: sum(endless.plan_runs.values()) > before)  # and goes on
        wait_until(lambda: not service.planners.asking)
        assert service.turns.queue == []
