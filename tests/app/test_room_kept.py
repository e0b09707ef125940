"""What a reader keeps of a room: charts, films, programs, and small records in its link."""

# ruff: noqa: F811 - a fixture is imported, and then asked for by its name
from __future__ import annotations

import io
import tomllib
from typing import TYPE_CHECKING, Any

import pytest
from browsing import browser  # noqa: F401
from PIL import Image
from room_judge import Judge, after, judged, room_page
from serving import client_of
from test_figures import JAPANESE, executed, numbers
from test_figures import done as done_of_one_piece
from test_page_links import LOST, forget, small_record, small_vertical
from test_room_api import ROOM, ended

import stayput as sp
from stayput.report.space.animation import animate_space_run

if TYPE_CHECKING:
    from pathlib import Path

    import httpx
    from browsing import Opened
    from playwright.sync_api import Browser
    from serving import Running

CHARTS = ["room_plan", "room_hits", "room_changes"]


@pytest.fixture(scope="module")
def job(server: Running) -> dict[str, Any]:
    with client_of(server) as client:
        made = ended(client, client.post("/api/v1/room", json={"scene": ROOM}).json())
    assert made["state"] == "done", made["error"]
    return made


@pytest.mark.parametrize("name", CHARTS)
def test_charts_of_a_room_say_what_they_are_of(client: httpx.Client, job: dict[str, Any], name: str) -> None:
    address = f"/api/v1/jobs/{job['id']}/figures/{name}"
    drawn = client.get(f"{address}.svg")
    for part in ("seed 1", f"stayput {sp.__version__}", job["result"]["verdict"]["en"], "[plan]"):
        assert part in drawn.text
    assert client.get(f"{address}.svg").content == drawn.content
    assert client.get(f"{address}.pdf", params={"lang": "ja"}).content.startswith(b"%PDF-")
    about, rows = numbers(client.get(f"{address}.csv", params={"lang": "ja"}).content)
    assert JAPANESE.search(about[0])
    assert job["result"]["verdict"]["ja"] in about[1]
    scenario = sp.RoomScenario.parse(tomllib.loads("\n".join(about[about.index("") :])))
    assert scenario == sp.RoomScenario.parse(ROOM)
    assert rows


def test_the_numbers_of_charts_are_those_of_the_verdict_on_the_room(
    client: httpx.Client, job: dict[str, Any]
) -> None:
    tables = {
        name: numbers(client.get(f"/api/v1/jobs/{job['id']}/figures/{name}.csv").content)[1]
        for name in CHARTS
    }
    result = job["result"]
    places = [row for row in tables["room_hits"] if not row["piece"]]
    shown = [(one["name"], one["hit"]) for one in result["places"]]
    changed = [one["hit"] for one in result["changes"]]
    for rows, chances in (
        (places, [chance for _, chance in shown]),
        (tables["room_changes"], [result["hit"], *changed]),
    ):
        for row, chance in zip(rows, chances, strict=True):
            for end, key in (("", "estimate"), ("_low", "low"), ("_high", "high")):
                assert float(row[f"hit{end}"]) == pytest.approx(chance[key], rel=1e-8)
    for row, change in zip(tables["room_changes"][1:], result["changes"], strict=True):
        for event in ("hit", "shut_in", "overturned"):
            for key in (event, f"{event}_change"):
                told = row[key] if change[key] is None else float(row[key])
                assert told == (
                    "" if change[key] is None else pytest.approx(change[key]["estimate"], rel=1e-8)
                )
    verdict = sp.verify_room(sp.RoomScenario.parse(ROOM), progress=False)
    cells = tables["room_plan"]
    assert sum(float(row["fell"]) for row in cells) == pytest.approx(
        sum(piece.fell.sum() for piece in verdict.pieces)
    )
    first = cells[0]
    i, j = (int(float(first[key]) / 0.05) for key in ("x_m", "y_m"))
    assert float(first["stood"]) == pytest.approx(verdict.pieces[0].stood[i, j])


def test_the_program_of_a_room_says_what_each_change_is_and_brings(
    client: httpx.Client, job: dict[str, Any], capsys: pytest.CaptureFixture[str]
) -> None:
    program = client.post("/api/v1/scenario/python", json={"scene": ROOM}).text
    capsys.readouterr()
    exec(compile(program, "room.py", "exec"), {})
    lines = capsys.readouterr().out.splitlines()
    for change in job["result"]["changes"]:
        first = lines.index(change["label"]["en"])
        shown = [("somebody is hit", "hit"), ("somebody is shut in", "shut_in")]
        shown += [("the piece overturns", "overturned")] if change["overturned"] else []
        for line, (words, key) in zip(lines[first + 1 :], shown, strict=False):
            label, _, values = line.strip().partition(": ")
            chance = change[key]
            assert (label, [float(value) for value in values.split()]) == (
                words,
                [chance["estimate"], chance["low"], chance["high"]],
            )


def test_charts_are_there_for_their_own_verdicts_alone(client: httpx.Client, job: dict[str, Any]) -> None:
    answer = client.get(f"/api/v1/jobs/{job['id']}/figures/ranking.svg")
    assert answer.status_code == 409
    assert "of a room" in answer.json()["message"]
    other = done_of_one_piece(client, curves=False, compare_usual=False)
    answer = client.get(f"/api/v1/jobs/{other['id']}/figures/room_plan.svg")
    assert answer.status_code == 409
    assert "verification of a room" in answer.json()["message"]


def test_histories_of_a_room_can_be_kept(client: httpx.Client) -> None:
    answer = client.post("/api/v1/simulate/figure", params={"kind": "csv"}, json={"scene": ROOM})
    assert answer.status_code == 200
    assert numbers(answer.content)[1]


def test_a_short_film_of_a_room_says_the_verdict(
    client: httpx.Client, job: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    said: list[dict[str, Any]] = []

    def noted(*args: Any, **more: Any) -> Path:
        said.append(more)
        return animate_space_run(*args, **more)

    monkeypatch.setattr("stayput.app.downloads.animate_space_run", noted)
    query = {"kind": "gif", "seconds": 3, "job": job["id"], "lang": "ja"}
    drawn = client.post("/api/v1/simulate/film", params=query, json={"scene": ROOM}).content
    film = Image.open(io.BytesIO(drawn))
    assert 2.0 < film.n_frames * film.info["duration"] / 1000 < 3.0 + 1.5 + 0.3
    (told,) = said
    assert told["note"] == job["result"]["verdict"]["ja"]
    assert told["names"] == ("本棚",)
    page = client.post("/api/v1/simulate/film", params={"lang": "ja"}, json={"scene": ROOM}).text
    assert "家具を支えません" in page


def test_the_program_and_the_file_of_a_room_give_the_page_s_numbers_to_the_bit(
    client: httpx.Client, job: dict[str, Any]
) -> None:
    asked = {"scene": ROOM, "measures": []}
    made = executed(client, asked)
    file = sp.RoomScenario.parse(tomllib.loads(client.post("/api/v1/scenario/toml", json=asked).text))
    told = client.post("/api/v1/simulate", json=asked).json()["without"]["pieces"]
    for run in (made["run"], file.run()):
        assert [one["peak_tilt_rad"] for one in told] == run.peak_tilt.tolist()
    for verdict in (made["verdict"], sp.verify_room(file, progress=False)):
        for key, mine in (("places", verdict.places), ("changes", verdict.changes)):
            for shown, one in zip(job["result"][key], mine, strict=True):
                hit = (one.hit.estimate, one.hit.low, one.hit.high)
                assert (shown["hit"]["estimate"], shown["hit"]["low"], shown["hit"]["high"]) == hit


def test_the_page_keeps_the_program_the_film_and_the_charts(browser: Browser, server: Running) -> None:
    judge, seen = Judge(), list[str]()
    with room_page(browser, server, judge) as it:

        def drawn(route: Any) -> None:
            seen.append(route.request.url)
            route.fulfill(status=200, content_type="image/svg+xml", body="<svg/>")

        it.page.route("**/figures/*", drawn)
        it.page.route("**/simulate/film*", drawn)
        for name in CHARTS:
            with it.page.expect_download() as found:
                it.page.locator(f"[data-figure={name}] button").first.click()
            assert found.value.suggested_filename == f"stayput_{name}.svg"
        for button in ("#film", "#html"):
            with it.page.expect_download():
                it.page.click(button)
            assert "job=" in seen[-1]
        assert "seconds=10" in seen[-2]
        it.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
        it.page.click("#python")
        it.wait("() => document.getElementById('kept').textContent.includes('clipboard')")
        assert "sp.verify_room(scenario" in it.page.evaluate("() => navigator.clipboard.readText()")


def sent(it: Opened, judge: Judge, path: Path) -> dict[str, Any]:
    """Drop a record whose file does not say its time step, and say it; return the room that is asked."""
    it.page.set_input_files("#file", path)
    it.page.fill("#step", "0.02")
    return after(it, judge, lambda: it.page.get_by_role("button", name="Send again").click())


def test_a_small_record_travels_in_a_room_s_link(browser: Browser, server: Running, tmp_path: Path) -> None:
    judge = Judge()
    with room_page(browser, server, judge, allowed=LOST) as it:
        room = sent(it, judge, small_record(tmp_path))
        it.wait("() => location.hash.includes('wave=')")
        assert it.page.locator("#link-record").is_hidden()
        link = it.page.input_value("#address")
    forget(server)
    with room_page(browser, server, judge, "#" + link.split("#")[1], allowed=LOST) as it:
        it.wait("() => document.getElementById('uploaded').textContent.includes('my town.csv')")
        it.wait("() => location.hash.includes('wave=')")
        judged(it)
        again = judge.scene["shaking"]
        assert again["record"] != room["shaking"]["record"]
        assert again == {**room["shaking"], "record": again["record"]}
        assert it.page.locator("#notices").is_hidden()
        it.page.reload()
        judged(it)
        assert judge.scene["shaking"] == again


def test_the_computed_earthquake_is_the_same_again_after_a_record(
    browser: Browser, server: Running, tmp_path: Path
) -> None:
    judge = Judge()
    with room_page(browser, server, judge, allowed=LOST) as it:
        family = it.page.get_by_label("Kind of earthquake")
        before = after(it, judge, lambda: family.select_option("near-fault"))
        it.page.get_by_role("slider", name="Which earthquake of this kind").fill("5")
        assert "suite" not in sent(it, judge, small_record(tmp_path))["shaking"]
        room = after(it, judge, lambda: it.page.click("text=Without this record"))
        assert room["shaking"] == {
            **before["shaking"],
            "member": 5,
            "intensity": 6.25,
        }  # the middle of 6 upper


def test_a_small_vertical_record_travels_in_a_room_s_link(
    browser: Browser, server: Running, tmp_path: Path
) -> None:
    judge = Judge()
    with room_page(browser, server, judge, allowed=LOST) as it:
        sent(it, judge, small_record(tmp_path, 6.0))
        it.page.set_input_files("#file", small_vertical(tmp_path))
        take = it.page.get_by_role("button", name="Take it as vertical")
        room = after(it, judge, take.click)
        it.wait("() => location.hash.includes('verticalWave=')")
        assert it.page.locator("#link-record").is_hidden()
        link = it.page.input_value("#address")
    forget(server)
    with room_page(browser, server, judge, "#" + link.split("#")[1], allowed=LOST) as it:
        it.wait("() => document.getElementById('uploaded').textContent.includes('up.csv')")
        judged(it)
        again = judge.scene["shaking"]
        assert again["vertical"] != room["shaking"]["vertical"]
        assert again == {**room["shaking"], **{key: again[key] for key in ("record", "vertical")}}
        assert it.page.locator("#notices").is_hidden()


def test_a_large_record_is_said_not_to_be_in_a_room_s_link(
    browser: Browser, server: Running, tmp_path: Path
) -> None:
    judge, path = Judge(), tmp_path / "large.csv"
    sp.near_fault().write(path)
    with room_page(browser, server, judge) as it:
        after(it, judge, lambda: it.page.set_input_files("#file", path))
        it.page.wait_for_selector("#link-record:not([hidden])", state="attached")
        assert "“large.csv” is too large for the link" in it.text("#link-record")
        link = it.page.input_value("#address")
        assert "wave=" not in link
    forget(server)
    with room_page(browser, server, judge, "#" + link.split("#")[1], allowed=LOST) as it:
        it.page.wait_for_selector("#notices:not([hidden])")
        judged(it)
        assert "record" not in judge.scene["shaking"]


def test_a_film_says_the_name_of_the_user_s_file(client: httpx.Client, tmp_path: Path) -> None:
    path = small_record(tmp_path)
    sent = client.post(
        "/api/v1/motions", files={"file": (path.name, path.read_bytes())}, data={"unit": "m/s2", "dt": "0.02"}
    ).json()
    scene = {**ROOM, "shaking": {"record": sent["id"]}}
    page = client.post("/api/v1/simulate/film", json={"scene": scene}).text
    assert sent["name"] in page
    assert sent["id"] not in page
