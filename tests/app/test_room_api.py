"""Rooms over the API: a verdict that gets better, its files, refusals, the whole room in space."""

from __future__ import annotations

import base64
import json
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from serving import client_of, running

import stayput as sp
from stayput.app import api
from stayput.app.presets import ROOM_SCENE
from stayput.report.verdict.data import verdict_data
from stayput.verification.room_words import people_in
from waiting import wait_until

if TYPE_CHECKING:
    from collections.abc import Iterator

    import httpx

    from stayput.verification import Verdict

ROOM: dict[str, Any] = {
    **ROOM_SCENE,
    "furniture": ROOM_SCENE["furniture"][:1],
    "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 2}},
    "uncertainty": {"samples": 4, "seed": 2},
}


@pytest.fixture(scope="module")
def room_client() -> Iterator[httpx.Client]:
    with running() as server, client_of(server) as client:
        yield client


def ended(client: httpx.Client, job: dict[str, Any]) -> dict[str, Any]:
    wait_until(lambda: client.get(f"/api/v1/jobs/{job['id']}").json()["state"] not in ("waiting", "running"))
    return client.get(f"/api/v1/jobs/{job['id']}").json()


@pytest.fixture(scope="module")
def job(room_client: httpx.Client) -> dict[str, Any]:
    """The verification of the room with its changes, which is done."""
    found = ended(room_client, room_client.post("/api/v1/room", json={"scene": ROOM}).json())
    assert found["state"] == "done", found["error"]
    return found


def bare(result: dict[str, Any]) -> dict[str, Any]:
    """Return the room as it is among the options of a verdict."""
    (option,) = (one for one in result["options"] if one["overturned_change"] is None)
    return option


def test_a_verdict_is_that_of_the_library(room_client: httpx.Client, job: dict[str, Any]) -> None:
    result = job["result"]
    verdict = sp.verify(sp.Scenario.parse(ROOM), progress=False)
    assert result["complete"] is True
    data = verdict_data(verdict)
    for key in ("verdict", "best", "runs", "seed", "jma_intensity"):
        assert result[key] == data[key], key
    assert [one["people"] for one in result["options"]] == [one["people"] for one in data["options"]]
    zone = bare(result)["pieces"][0]["fell"]
    zones = verdict.without.pieces[0].zones
    assert zones is not None
    shares = np.frombuffer(base64.b64decode(zone["shares"]), np.uint8).reshape(zone["nx"], zone["ny"])
    assert np.abs(shares / 255.0 - zones.fell).max() <= 0.5 / 255.0 + 1e-9
    for lang in ("en", "ja"):
        report = room_client.get(f"/api/v1/jobs/{job['id']}/report?lang={lang}")
        assert report.status_code == 200
        assert data["verdict"][lang] in report.text.replace("\xa0", " ")
    table = room_client.get(f"/api/v1/jobs/{job['id']}/csv")
    assert table.content.decode("utf-8-sig") == verdict.to_csv()
    everyday = room_client.put(f"/api/v1/jobs/{job['id']}/everyday", json={"scene": {}})
    assert everyday.status_code == 409


def test_the_run_that_is_proposed_is_one_of_what_happens_most(
    room_client: httpx.Client, job: dict[str, Any]
) -> None:
    as_it_is = bare(job["result"])
    assert as_it_is["people"]["hit"]["estimate"] > 0.5
    run = as_it_is["typical"]
    scene = {**ROOM, "shaking": {**ROOM["shaking"], "member": run["motion"] + 1}}
    asked: dict[str, Any] = {"scene": scene, "measures": [], "sample": run["sample"]}
    shown = room_client.post("/api/v1/simulate", json=asked).json()["in_room"]
    assert shown["hits"] == [{"piece": "bookcase", "place": "bed"}]
    asked["scene"] = {**scene, "shaking": {**scene["shaking"], "intensity": 3.0}}
    shown = room_client.post("/api/v1/simulate", json=asked).json()["in_room"]
    assert shown == {"hits": [], "blocked": [], "shut_in": []}


def test_a_change_says_what_to_write_into_the_scene(room_client: httpx.Client, job: dict[str, Any]) -> None:
    options = [one for one in job["result"]["options"] if one["changes"]]
    changes = [change for one in options for change in one["changes"]]
    assert {one["table"] for one in changes} == {"furniture", "places"}
    fixed = next(one for one in changes if one["measures"])
    held = next(one for one in options if one["changes"] == [fixed])
    moved = next(one for one in changes if one["table"] == "furniture" and one["at_m"])
    (piece,) = ROOM["furniture"]
    other = {**piece, "measures": fixed["measures"]}
    found = sp.verify(sp.Scenario.parse({**ROOM, "furniture": [other]}), changes=False, progress=False)
    assert people_in(found).hit.chance.estimate == pytest.approx(held["people"]["hit"]["estimate"])
    other = {"name": piece["name"], "preset": piece["preset"], "at": moved["at_m"]}
    scene = {**ROOM, "furniture": [{**other, "heading": moved["heading_rad"]}]}
    assert room_client.post("/api/v1/room", json={"scene": scene, "changes": False}).status_code == 202


def test_what_is_known_is_there_while_the_job_runs(
    room_client: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    verify, seen = api.verify, []

    def held(scenario: Any, *, on_verdict: Any, **more: Any) -> Verdict:
        def told(verdict: Verdict) -> None:
            on_verdict(verdict)
            wait_until(lambda: len(seen) > len(passed))
            passed.append(verdict)

        passed: list[Verdict] = []
        return verify(scenario, on_verdict=told, **more)

    monkeypatch.setattr(api, "verify", held)
    job = room_client.post("/api/v1/room", json={"scene": ROOM}).json()

    def state() -> dict[str, Any]:
        found = room_client.get(f"/api/v1/jobs/{job['id']}").json()
        if found["result"] is not None and (not seen or found["result"] != seen[-1]):
            seen.append(found["result"])
        return found

    wait_until(lambda: state()["state"] == "done")
    assert [one["complete"] for one in seen[:-1]] == [False] * (len(seen) - 1)
    assert seen[-1]["complete"]
    assert [len(one["options"]) for one in seen] == sorted(len(one["options"]) for one in seen)
    assert len(seen) >= 3


def test_a_room_that_is_cancelled_stops(room_client: httpx.Client, monkeypatch: pytest.MonkeyPatch) -> None:
    verify = api.verify
    began: list[Any] = []

    def endless(scenario: Any, **more: Any) -> Any:
        began.append(scenario)
        while True:
            verify(scenario, **more)

    monkeypatch.setattr(api, "verify", endless)
    job = room_client.post("/api/v1/room", json={"scene": ROOM}).json()
    wait_until(lambda: bool(began))
    assert room_client.delete(f"/api/v1/jobs/{job['id']}").json()["state"] == "cancelled"
    monkeypatch.undo()
    job = ended(room_client, room_client.post("/api/v1/room", json={"scene": ROOM, "changes": False}).json())
    assert job["state"] == "done"


@pytest.mark.parametrize(
    ("changed", "field"),
    [
        ({"furniture": [{"name": "b", "preset": "bookcase", "at": [0.1, 0.1]}]}, "scene.furniture[0].at"),
        ({"places": [{"kind": "bad", "at": [1.0, 1.0]}]}, "scene.places[0].kind"),
        ({"doors": [{"wall": "right_wall", "start": 2.5}]}, "scene.doors[0]"),
        ({"plan": {"width": 3.6}}, "scene.plan.length"),
        ({"shaking": {"record": "/etc/passwd"}}, "scene.shaking.record"),
        ({"uncertainty": {"samples": 3000}}, "scene.uncertainty.samples"),
        (
            {"furniture": [{"name": "m", "mesh": "chair.stl", "unit": "m", "mass": 3.0, "at": [1.0, 0.5]}]},
            "scene.furniture[0].mesh",
        ),
        (
            {"furniture": [{"name": f"c{n}", "preset": "chest", "at": [1.0, 1.0]} for n in range(25)]},
            "scene.furniture",
        ),
        ({"title": "\ud800"}, "scene"),
    ],
)
def test_a_room_that_is_refused_says_where(room_client: httpx.Client, changed: Any, field: str) -> None:

    content = json.dumps({"scene": {**ROOM, **changed}})
    headers = {"content-type": "application/json"}
    answer = room_client.post("/api/v1/room", content=content, headers=headers)
    assert answer.status_code == 422, answer.text
    assert answer.json()["field"] == field
    assert answer.json()["message"]


def test_a_room_is_run_as_a_whole_written_and_read(room_client: httpx.Client) -> None:
    run = room_client.post("/api/v1/simulate", json={"scene": ROOM_SCENE, "measures": []}).json()
    assert [one["name"] for one in run["without"]["pieces"]] == ["bookcase", "wardrobe", "chest"]
    written = room_client.post("/api/v1/scenario/toml", json={"scene": ROOM_SCENE, "measures": []})
    read = room_client.post("/api/v1/scenario/read", json={"toml": written.text}).json()
    assert read["scene"] == ROOM_SCENE
    assert read["pieces"] == ["bookcase", "wardrobe", "chest"]
