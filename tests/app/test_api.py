"""The API by what it answers: presets, runs, maps, verifications, files to keep."""

from __future__ import annotations

import base64
import csv
import io
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from serving import SCENE

import stayput as sp
from stayput.measures import MEASURES
from stayput.motion.intensity import CLASSES
from waiting import wait_until

if TYPE_CHECKING:
    import httpx
    from numpy.typing import NDArray

BRACKET = [{"type": "l_bracket"}]


def simulated(client: httpx.Client, scene: dict[str, Any], measures: list[Any] | None = None) -> Any:
    answer = client.post("/api/v1/simulate", json={"scene": scene, "measures": measures or []})
    assert answer.status_code == 200, answer.text
    return answer.json()


def numbers(text: str) -> NDArray[np.float64]:
    return np.frombuffer(base64.b64decode(text), "<f4").astype(np.float64)


def finished(client: httpx.Client, asked: dict[str, Any]) -> Any:
    """Start a verification and wait for its end."""
    answer = client.post("/api/v1/verify", json=asked)
    assert answer.status_code == 202, answer.text
    job: dict[str, Any] = {}

    def ended() -> bool:
        job.update(client.get(answer.headers["location"]).json())
        return job["state"] not in ("waiting", "running")

    wait_until(ended)
    return job


def test_presets_are_complete_in_both_languages(client: httpx.Client) -> None:
    found = client.get("/api/v1/presets").json()
    assert [one["type"] for one in found["measures"]] == list(MEASURES)
    assert [one["id"] for one in found["intensities"]] == [name for name, _ in CLASSES]
    assert {"wall"} == set(next(m for m in found["measures"] if m["type"] == "l_bracket")["needs"])
    assert {"ceiling"} == set(next(m for m in found["measures"] if m["type"] == "tension_pole")["needs"])

    def labels(node: Any) -> list[dict[str, str]]:
        if isinstance(node, list):
            return [text for one in node for text in labels(one)]
        if not isinstance(node, dict):
            return []
        if set(node) == {"en", "ja"}:
            return [node]
        return [text for one in node.values() for text in labels(one)]

    texts = labels(found)
    assert len(texts) > 100
    for text in texts:
        assert text["en"].strip()
        assert any(ord(character) > 0x3000 for character in text["ja"]) or text["ja"][-1].isdigit(), text


def test_a_run_is_the_simulation_s(client: httpx.Client) -> None:
    found = simulated(client, SCENE, BRACKET)
    case = sp.Scenario.parse(SCENE).case()
    for key, run in (
        ("without", case.run()),
        ("with", sp.Scenario.parse(SCENE).case((MEASURES["l_bracket"](),)).run()),
    ):
        reply = found[key]
        assert reply["outcome"] == run.outcome.value
        assert reply["pieces"][0]["peak_tilt_rad"] == run.peak_tilt
        assert reply["pieces"][0]["peak_slide_m"] == run.peak_slide
        assert reply["events_total"] == len(run.events)
        assert [event["time_s"] for event in reply["events"]] == pytest.approx(
            [event.time for event in run.events], abs=1e-4
        )
        (body,), poses = reply["scene"]["bodies"], reply["scene"]["poses"]
        times = np.linspace(poses["start_s"], poses["end_s"], poses["count"])
        assert poses["end_s"] == pytest.approx(case.motion.duration, abs=1e-4)  # of both
        assert np.diff(times).max() <= 1.0 / 60.0 + 1e-6
        tilts, before = numbers(body["tilt_rad"]), times < run.time[-1]
        assert tilts[before] == pytest.approx(np.interp(times, run.time, run.tilt)[before], abs=1e-5)
        assert abs(tilts[-1]) == pytest.approx(np.pi / 2 if run.overturned else abs(run.tilt[-1]), abs=1e-5)
    assert found["engine"] == "plane"
    assert found["without"]["devices"] == []
    (device,) = found["with"]["devices"]
    assert device["label"]["ja"]
    assert len(device["pull_n"]) == found["with"]["scene"]["poses"]["count"]
    assert len(found["with"]["scene"]["ties"]) == 2  # a pair of brackets, which acts as one
    assert numbers(found["floor"]["acceleration_m_s2"]["x"]) == pytest.approx(case.motion.x, abs=1e-5)


def test_a_building_shakes_more_at_its_roof(client: httpx.Client) -> None:
    shaking = {"builtin": "near-fault", "scale": 0.2, "building": {"storeys": 10}, "storey": 10}
    found = simulated(client, {**SCENE, "shaking": shaking})
    building = found["building"]
    assert (building["storeys"], building["storey"], building["structure"]) == (10, 10, "RC")
    assert found["motion"]["floor_intensity"] > found["motion"]["ground_intensity"]
    count = found["without"]["scene"]["poses"]["count"]
    assert len(building["ground_x_m"]) == len(building["roof_x_m"]) == count
    ground, roof = (max(map(abs, building[name])) for name in ("ground_x_m", "roof_x_m"))
    assert roof > ground


def test_a_table_of_a_run_has_the_floor_and_the_devices(client: httpx.Client) -> None:
    measures = [{"type": "l_bracket"}, {"type": "gel_mats"}]
    answer = client.post("/api/v1/simulate/csv?which=with", json={"scene": SCENE, "measures": measures})
    assert answer.headers["content-type"].startswith("text/csv")
    assert "attachment" in answer.headers["content-disposition"]
    rows = list(csv.DictReader(io.StringIO(answer.text)))
    case = sp.Scenario.parse(SCENE).case((MEASURES["l_bracket"](), MEASURES["gel_mats"]()))
    run = case.run()
    assert rows[500]["mode"] == run.mode[500]
    places = [one.place for one in run.devices]
    assert len(rows) == len(run.time)
    for name, values in (
        ("tilt_rad", run.tilt),
        ("floor_x_acceleration_m_s2", case.motion.x),
        ("floor_x_velocity_m_s", case.motion.velocity),
        ("floor_x_displacement_m", case.motion.displacement),
        ("device_1_l_bracket_pull_n", run.devices[0].pull),
        (f"device_3_gel_mats_{places[2]}_shear_n", run.devices[2].shear),
    ):
        found = [float(row[name]) for row in rows]
        assert found == pytest.approx(list(values[: len(found)]), rel=1e-8, abs=1e-12), name


def test_answers_are_compressed_where_they_are_taken_so(client: httpx.Client) -> None:
    asked = {"scene": SCENE, "measures": BRACKET}
    packed = client.post("/api/v1/simulate", json=asked, headers={"accept-encoding": "br, gzip"})
    plain = client.post("/api/v1/simulate", json=asked, headers={"accept-encoding": "identity"})
    assert packed.headers["content-encoding"] == "gzip"
    assert "content-encoding" not in plain.headers
    assert packed.json() == plain.json()
    assert int(packed.headers["content-length"]) < 0.5 * int(plain.headers["content-length"])
    assert packed.headers["vary"] == plain.headers.get("vary", "Accept-Encoding") == "Accept-Encoding"
    page = client.get("/main.js", headers={"accept-encoding": "gzip"})
    assert page.headers["content-encoding"] == "gzip"
    again = client.get("/main.js", headers={"if-none-match": page.headers["etag"], "accept-encoding": "gzip"})
    assert again.status_code == 304
    assert "content-encoding" not in again.headers
    small = client.get("/api/v1/ping", headers={"accept-encoding": "gzip"})
    assert "content-encoding" not in small.headers


def test_a_verification_is_done_as_a_job(client: httpx.Client) -> None:
    scene = {**SCENE, "uncertainty": {"samples": 8}}
    own = [{"type": "l_bracket"}, {"type": "anti_slip_sheet"}]
    job = finished(client, {"scene": scene, "measures": own, "compare_usual": False})
    assert job["state"] == "done", job
    assert job["progress"] == 1.0
    verdict = job["result"]
    names = {one["name"] for one in verdict["options"]}
    assert names == {"none", "yours", "l_bracket", "anti_slip_sheet"}
    ranks = [one["rank"] for one in verdict["options"]]
    assert (len(ranks), ranks[0], ranks) == (4, 1, sorted(ranks))
    without = next(one for one in verdict["options"] if one["name"] == "none")
    assert without["probabilities"]["overturned"]["estimate"] > 0.8
    assert next(one for one in verdict["options"] if one["yours"])["measures"] == own
    for one in verdict["options"]:
        assert one["reason"]["en"]
        assert one["reason"]["ja"]
        assert one["curve"]["observed"]
        low, share, high = (one["probabilities"]["overturned"][key] for key in ("low", "estimate", "high"))
        assert low <= share <= high
    assert {one["runs"] for one in verdict["options"]} == {8}  # as many as were asked for
    assert verdict["runs"] == job["done"] == job["total"]
    text = client.get(f"/api/v1/jobs/{job['id']}/csv").content.decode("utf-8-sig")
    rows = list(csv.DictReader(io.StringIO(text)))
    assert [row["option"] for row in rows] == [one["name"] for one in verdict["options"]]
    forgotten = client.delete(f"/api/v1/jobs/{job['id']}")
    assert forgotten.status_code == 200
    assert client.get(f"/api/v1/jobs/{job['id']}").status_code == 404


def test_a_report_has_the_verdict_and_everyday_use_is_told_anew_without_a_run(client: httpx.Client) -> None:
    scene = {**SCENE, "uncertainty": {"samples": 2}}
    job = finished(client, {"scene": scene, "curves": False})
    assert len(job["result"]["options"]) > 4  # without measures of the user's the usual ones are compared
    assert (job["result"]["options"][0]["curve"], job["result"]["options"][0]["capacities"]) == (None, [])
    where = f"/api/v1/jobs/{job['id']}"
    for language in ("en", "ja"):  # it is kept, and must not be that of the other use
        answer = client.get(f"{where}/report?lang={language}")
        assert answer.headers["content-type"] == "text/html; charset=utf-8"
        assert "attachment" in answer.headers["content-disposition"]
        assert job["result"]["verdict"][language].split("。")[0].split(";")[0][:20] in answer.text
    other = client.put(f"{where}/everyday", json={"scene": {**scene, "everyday": {"pull": 300.0}}})
    assert other.status_code == 200, other.text
    again = client.get(where).json()["result"]
    assert again["everyday"] == other.json() != job["result"]["everyday"]
    assert again["options"] == job["result"]["options"]
    assert "300" in other.json()["sentence"]["en"]
    report = client.get(f"{where}/report").text.replace("\N{NO-BREAK SPACE}", " ")
    assert other.json()["sentence"]["en"] in report
    bad = client.put(f"{where}/everyday", json={"scene": {**scene, "everyday": {"pull": -1.0}}})
    assert (bad.status_code, bad.json()["field"]) == (422, "scene.everyday.pull")
    assert client.put(f"/api/v1/jobs/{'0' * 32}/everyday", json={"scene": scene}).status_code == 404


def test_numbers_that_are_not_finite_are_null(client: httpx.Client) -> None:
    still = {**SCENE, "shaking": {"sine": {"amplitude": 0.0, "frequency": 1.0, "duration": 2.0}}}
    found = simulated(client, still)
    assert found["motion"]["ground_intensity"] is None
    assert found["without"]["outcome"] == "rested"
    assert not numbers(found["floor"]["shift_m"]).any()
