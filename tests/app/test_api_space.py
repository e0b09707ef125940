"""The API in space: one piece, several pieces, what is downloaded, and what is not offered."""

from __future__ import annotations

import csv
import gzip
import io
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import pytest
from serving import SCENE, client_of, running
from test_api import finished, numbers, simulated

import stayput as sp
from stayput.app.limits import Limits
from stayput.scenario import Scenario

if TYPE_CHECKING:
    import httpx

BELT = [{"type": "belt"}]
LASTING = 5.0
SPACE: dict[str, Any] = {
    **SCENE,
    "dimensions": 3,
    "direction": 0.0,
    "furniture": {"preset": "refrigerator", "length": 0.6, "heading": 0.5},
    "shaking": {"intensity": "6-upper", "member": 3},
}
PIECES: dict[str, Any] = {
    "furniture": [
        {"name": "lower", "width": 0.45, "length": 0.9, "height": 0.9, "mass": 60.0},
        {"name": "upper", "width": 0.35, "length": 0.9, "height": 0.9, "mass": 40.0, "on": "lower"},
    ],
    "shaking": {"sine": {"amplitude": 6.0, "frequency": 1.0, "duration": LASTING}},
}
TEXT = """
[[furniture]]
name = "vase"
bottom = 0.1
top = 0.2
height = 0.4
mass = 2.0
[[furniture]]
name = "chest"
preset = "chest"
at = [0.0, 1.5]
[shaking]
sine = { amplitude = 4.0, frequency = 2.0, duration = 4.0 }
"""


def refused(client: httpx.Client, path: str, asked: dict[str, Any], field: str | None) -> str:
    answer = client.post(f"/api/v1/{path}", json=asked)
    assert answer.status_code == 422, answer.text
    problem = answer.json()
    assert problem["field"] == field
    assert problem["message_ja"] != problem["message"]
    return str(problem["message"])


def test_a_run_in_space_is_that_of_the_scenario(client: httpx.Client) -> None:
    reply = client.post("/api/v1/simulate", json={"scene": SPACE, "measures": BELT})
    assert reply.headers["content-encoding"] == "gzip"
    assert len(gzip.compress(reply.content)) < 250_000  # 30 s, twice
    answer = reply.json()
    assert answer["engine"] == "space"
    for key, measures in (("without", ()), ("with", (sp.MEASURES["belt"](),))):
        run, told = Scenario.parse(SPACE).case(measures).run(), answer[key]
        (piece,), (body,) = told["pieces"], told["scene"]["bodies"]
        assert piece["peak_tilt_rad"] == run[0].peak_tilt
        assert piece["peak_slide_m"] == run[0].peak_slide
        assert piece["outcome"] == told["outcome"] == run.outcome.value
        assert body["shape"]["vertices_m"]
        tilts = numbers(body["tilt_rad"])
        assert len(tilts) == told["scene"]["poses"]["count"]
        assert tilts.max() == pytest.approx(run.tilt.max(), rel=0.05)
        assert len(told["devices"]) == len(run.devices)
        assert all(len(one["pull_n"]) == len(tilts) for one in told["devices"])
    assert {"x", "y", "z"} == set(answer["floor"]["acceleration_m_s2"])
    one, other = (answer[which]["scene"]["view"] for which in ("without", "with"))
    assert one == other  # both are drawn to one scale
    assert "refrigerator" in answer["without"]["sentence"]["en"]
    assert "冷蔵庫" in answer["without"]["sentence"]["ja"]


def test_what_happens_first_is_told_in_order(client: httpx.Client) -> None:
    room = {**SCENE["room"], "near_side_wall": {"gap": 0.01}, "far_side_wall": {"gap": 0.01}}
    scene = {**SPACE, "shaking": {**SPACE["shaking"], "intensity": 6.9}, "room": room}
    told = simulated(client, scene)["without"]
    times = [event["time_s"] for event in told["events"]]
    assert times == sorted(times)
    kinds = [event["kind"] for event in told["events"]]
    assert {"slip", "uplift", "floor impact", "wall impact"} <= set(kinds)
    assert ("overturned" in kinds) == told["overturned"]
    known = {one["id"] for one in client.get("/api/v1/presets").json()["events"]}
    assert set(kinds) <= known


def test_a_verification_in_space(client: httpx.Client) -> None:
    suite = {"suite": {"count": 2}, "intensity": 6.5}
    scene = {**SPACE, "shaking": suite, "uncertainty": {"samples": 2}}
    job = finished(client, {"scene": scene, "measures": BELT, "compare_usual": False})
    assert job["state"] == "done", job["error"]
    result = job["result"]
    for one in result["options"]:
        assert (
            len(one["curve"]["low"]) == len(one["curve"]["probability"]) > len(one["curve"]["observed"]) > 0
        )
    assert any("in space" in note["en"] and "29°" in note["en"] for note in result["notes"])
    report = client.get(f"/api/v1/jobs/{job['id']}/report").text
    assert report.count("<iframe") >= 2  # the typical and the worst case are played


def test_a_verification_in_space_is_allowed_fewer_runs() -> None:
    with running(replace(Limits(), runs_in_space=30)) as few, client_of(few) as client:
        message = refused(client, "verify", {"scene": SPACE}, "scene.uncertainty.samples")
        assert "this server allows 30" in message


def test_a_run_in_space_as_a_table(client: httpx.Client) -> None:
    asked = {"scene": SPACE, "measures": BELT}
    answer = client.post("/api/v1/simulate/csv", params={"which": "with"}, json=asked)
    rows = list(csv.DictReader(io.StringIO(answer.text)))
    run = Scenario.parse(SPACE).case([sp.MEASURES["belt"]()]).run()
    assert [float(row["tilt_rad"]) for row in rows] == pytest.approx(run[0].tilt, rel=1e-8, abs=1e-12)
    assert [float(row["slide_y_m"]) for row in rows] == pytest.approx(
        run[0].slide_in_plan[:, 1], rel=1e-8, abs=1e-12
    )
    assert {row["piece"] for row in rows} == {"refrigerator"}
    assert len([name for name in rows[0] if name.endswith("_pull_n")]) == 2


@pytest.mark.parametrize("scene", [{**SPACE, "dimensions": 2}, PIECES], ids=["plane", "pieces"])
def test_a_run_as_a_page_that_plays_it(client: httpx.Client, scene: dict[str, Any]) -> None:
    answer = client.post("/api/v1/simulate/film", params={"lang": "ja"}, json={"scene": scene})
    assert answer.headers["content-type"] == "text/html; charset=utf-8"
    assert 'filename="run_without.html"' in answer.headers["content-disposition"]
    assert '<html lang="ja">' in answer.text
    assert "webgl2" in answer.text


def test_a_gif_that_would_take_too_long(client: httpx.Client) -> None:
    long = {**SPACE, "shaking": {"sine": {"amplitude": 1.0, "frequency": 1.0, "duration": 200.0}}}
    refused(client, "simulate/film?kind=gif", {"scene": long}, "scene.shaking")


def test_several_pieces(client: httpx.Client) -> None:
    answer = simulated(client, PIECES)
    run = Scenario.parse(PIECES).run()
    told = answer["without"]
    assert [one["name"] for one in told["pieces"]] == ["lower", "upper"]
    assert [one["peak_tilt_rad"] for one in told["pieces"]] == [piece.peak_tilt for piece in run.pieces]
    assert {event["piece"] for event in told["events"]} <= {0, 1}
    assert answer["with"] is None
    assert answer["motion"]["duration_s"] == pytest.approx(LASTING, abs=0.01)


def test_a_scenario_file_of_several_pieces_is_read(client: httpx.Client) -> None:
    answer = client.post("/api/v1/scenario/read", json={"toml": TEXT}).json()
    assert answer["pieces"] == ["vase", "chest"]
    names = [one["name"] for one in simulated(client, answer["scene"])["without"]["pieces"]]
    assert names == answer["pieces"]
    one = client.post("/api/v1/scenario/read", json={"toml": '[furniture]\npreset = "chest"'}).json()
    assert one == {"scene": {"furniture": {"preset": "chest"}}, "pieces": []}
    upstairs = f'{TEXT}\nstorey = 2\nbuilding = {{ storeys = 3, structure = "S" }}'
    scene = client.post("/api/v1/scenario/read", json={"toml": upstairs}).json()["scene"]
    assert scene["shaking"]["building"]["structure"] == "steel"  # as the fields of the page know it


def test_pieces_that_are_refused(client: httpx.Client) -> None:
    refused(client, "simulate", {"scene": PIECES, "measures": BELT}, "measures")
    refused(client, "verify", {"scene": PIECES}, "scene.furniture")
    many = [{"name": f"{i}", "preset": "chest", "at": [0.0, 2.0 * i]} for i in range(21)]
    refused(client, "simulate", {"scene": {**PIECES, "furniture": many}}, "scene.furniture")
    endless = {"sine": {"amplitude": 1.0, "frequency": 1.0, "duration": 500.0}}
    long = {**PIECES, "furniture": many[:6], "shaking": endless}
    message = refused(client, "simulate", {"scene": long}, "scene.shaking")
    assert "With 6 pieces the duration [s] is 500; this server allows 400" in message
    into = [{**PIECES["furniture"][0], "name": name} for name in ("one", "other")]
    refused(client, "simulate", {"scene": {**PIECES, "furniture": into}}, "scene")


def test_contents_are_of_a_lone_piece(client: httpx.Client) -> None:
    inside = {**PIECES, "contents": {"kind": "books"}}
    for path in ("simulate", "verify"):
        refused(client, path, {"scene": inside}, "scene.contents")


def test_the_server_prints_no_warning_of_what_it_is_asked(
    client: httpx.Client, recwarn: pytest.WarningsRecorder
) -> None:
    floor = {"static_friction": 0.6, "kinetic_friction": 0.5, "settlement": 0.01}
    sine = {"sine": {"amplitude": 1.0, "frequency": 1.0, "duration": 2.0}}
    drum = {"name": "drum", "diameter": 0.4, "height": 0.9, "mass": 20.0, "at": [0.0, 3.0]}
    scene = {"furniture": [*PIECES["furniture"], drum], "room": {"floor": floor}, "shaking": sine}
    with pytest.warns(sp.InputWarning, match="Sinking into the floor, by"):
        Scenario.parse(scene).run()  # which tells it in Python
    recwarn.clear()
    assert client.post("/api/v1/simulate", json={"scene": scene}).status_code == 200
    assert [one for one in recwarn if issubclass(one.category, sp.InputWarning)] == []


def test_a_name_in_a_table_of_a_run_is_no_formula(client: httpx.Client) -> None:
    name, (lower, upper) = "=cmd|' /C calc'!A0", PIECES["furniture"]
    furniture = [{**lower, "name": name}, {**upper, "on": name}]
    answer = client.post("/api/v1/simulate/csv", json={"scene": {**PIECES, "furniture": furniture}})
    assert {row["piece"] for row in csv.DictReader(io.StringIO(answer.text))} == {f"'{name}", "upper"}
