"""What a reader keeps of a room: films, its file, and small records in its link."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

import pytest
from PIL import Image
from room_judge import Judge, after, judged, room_page
from serving import client_of
from test_page_links import LOST, forget, small_record, small_vertical
from test_room_api import ROOM, ended

import stayput as sp
from stayput.report.animation import animate_run
from stayput.report.names import names_of

if TYPE_CHECKING:
    from pathlib import Path

    import httpx
    from browsing import Opened
    from playwright.sync_api import Browser
    from serving import Running

    from stayput.simulation.run import Run


@pytest.fixture(scope="module")
def job(server: Running) -> dict[str, Any]:
    with client_of(server) as client:
        made = ended(client, client.post("/api/v1/room", json={"scene": ROOM, "changes": False}).json())
    assert made["state"] == "done", made["error"]
    return made


def test_a_short_film_of_a_room_says_the_verdict(
    client: httpx.Client, job: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    said: list[dict[str, Any]] = []

    def noted(run: Run, *args: Any, **more: Any) -> Path:
        said.append({**more, "names": names_of(run, more["language"])})
        return animate_run(run, *args, **more)

    monkeypatch.setattr("stayput.app.downloads.animate_run", noted)
    query = {"kind": "gif", "seconds": 3, "job": job["id"], "lang": "ja"}
    drawn = client.post("/api/v1/simulate/film", params=query, json={"scene": ROOM}).content
    film = Image.open(io.BytesIO(drawn))
    assert 2.0 < film.n_frames * film.info["duration"] / 1000 < 3.0 + 1.5 + 0.3
    (told,) = said
    assert told["note"] == job["result"]["verdict"]["ja"]
    assert told["names"] == ("本棚",)
    page = client.post("/api/v1/simulate/film", params={"lang": "ja"}, json={"scene": ROOM}).text
    assert "家具を支えません" in page


def test_the_page_keeps_the_film(browser: Browser, server: Running) -> None:
    judge, seen = Judge(), list[str]()
    with room_page(browser, server, judge) as it:

        def drawn(route: Any) -> None:
            seen.append(route.request.url)
            route.fulfill(status=200, content_type="video/mp4", body="film")

        it.page.route("**/simulate/film*", drawn)
        for button in ("#film", "#html"):
            with it.page.expect_download():
                it.page.click(button)
            assert "job=" in seen[-1]
        assert "seconds=10" in seen[-2]


def sent(it: Opened, judge: Judge, path: Path) -> dict[str, Any]:
    """Drop a record whose file does not say its time step, and say it; return the room that is asked."""
    it.page.set_input_files("#file", path)
    it.page.fill("#step", "0.02")
    return after(it, judge, lambda: it.page.get_by_role("button", name="Send again").click())


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
