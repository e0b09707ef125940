"""Changes on the page of a room: listed, tried, taken back, made, undone, and steps of the plan."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, Any

import pytest
from room_editing import editing
from room_judge import (
    DONE,
    QUEUED,
    Judge,
    after,
    chance,
    change,
    in_address,
    judged,
    made,
    place_of,
    room_page,
)
from test_room_api import ROOM, ended

if TYPE_CHECKING:
    import httpx
    from browsing import Opened
    from playwright.sync_api import Browser
    from serving import Running

NOTE = '"was"'
"""What the page notes, which nobody else is sent."""


def buttons(it: Opened, name: str) -> Any:
    return it.page.locator("#tried").get_by_role("button", name=name)


def lines(it: Opened) -> list[str]:
    return it.page.locator("#tried-list li > span").all_inner_texts()


def test_what_is_tried_is_listed_and_the_room_before_it_is_sent(it: Opened, judge: Judge) -> None:
    it.go("understand")
    first = judge.scene
    assert judge.asked[-1]["before"] is None
    assert not it.page.locator("#tried").is_visible()
    after(it, judge, lambda: it.page.click("#best button"))
    assert judge.asked[-1]["before"] == first
    held = after(it, judge, lambda: it.page.click("#ranking > li:nth-child(2) button"))
    assert judge.asked[-1]["before"] == first
    turned = after(it, judge, lambda: it.page.click("#ranking > li:nth-child(3) button"))
    assert judge.asked[-1]["before"] == first
    assert lines(it) == ["Bookcase moved", "Bookcase with belts", "Bed moved"]
    assert it.text("#with-tried").startswith("With what is being tried: Bookcase moved")
    assert NOTE not in str(judge.asked)
    in_address(it, "places", turned["places"])
    it.page.reload()
    it.settle()
    judged(it)
    assert (judge.scene, judge.asked[-1]["before"]) == (turned, first)
    it.go("understand")
    back = after(it, judge, buttons(it, "Take back: Bookcase moved").click)
    assert place_of(back, "bookcase") == place_of(first, "bookcase")
    assert back["furniture"][0]["measures"] == held["furniture"][0]["measures"]
    assert lines(it) == ["Bookcase with belts", "Bed moved"]


def test_what_is_made_is_the_room_as_it_is(it: Opened, judge: Judge) -> None:
    it.go("understand")
    first = judge.scene
    after(it, judge, lambda: it.page.click("#best button"))
    held = after(it, judge, lambda: it.page.click("#ranking > li:nth-child(2) button"))
    after(it, judge, buttons(it, "Already done: Bookcase with belts").click)
    before = copy.deepcopy(first)
    before["furniture"][0]["measures"] = held["furniture"][0]["measures"]
    assert judge.asked[-1]["before"] == before
    assert lines(it) == ["Bookcase moved"]
    after(it, judge, buttons(it, "Already done: Bookcase moved").click)
    assert judge.asked[-1]["before"] is None
    assert judge.scene == held
    assert not it.page.locator("#tried").is_visible()
    assert after(it, judge, lambda: it.page.click("#plan-undo")) == held
    assert lines(it) == ["Bookcase moved"]


def test_a_copy_of_what_is_tried_is_not_tried(it: Opened, judge: Judge) -> None:
    after(it, judge, lambda: it.page.click("#ranking > li:nth-child(2) button"))
    after(it, judge, lambda: it.page.locator("#plan [data-thing=furniture-0]").press("d"))
    copies = [one for one in judge.asked[-1]["before"]["furniture"] if one.get("measures")]
    assert len(copies) == 1
    assert lines(it) == ["Bookcase with belts"]


def test_what_is_tried_is_said_with_the_answer_to_it_alone(it: Opened, judge: Judge) -> None:
    it.go("understand")
    said = it.page.locator("#with-tried")
    judge.stage = QUEUED
    it.page.click("#best button")
    it.page.wait_for_selector("#tried:visible")
    it.wait("() => document.getElementById('answer').dataset.old === 'true'")
    assert not said.is_visible()  # the sentence is still that without it
    judge.stage = DONE
    judged(it)
    assert said.is_visible()


LINK = """async (room) => {
  const stream = new Blob([JSON.stringify(room)]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const letters = btoa(String.fromCharCode(...new Uint8Array(await new Response(stream).arrayBuffer())));
  location.hash = "room=" + letters.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}"""


def test_notes_of_a_link_that_can_be_none_are_left_out(browser: Browser, server: Running) -> None:
    judge = Judge()
    belt = [{"type": "belt"}]
    wrong: list[dict[str, Any]] = [
        {"was": {"measures": {"measures": "abc"}}},
        {"was": {"measures": {"measures": [1, None, "x"]}}},
        {"was": {"measures": [1, None, "x"]}},
        {"was": {"measures": belt[0], "place": {"at": 5}, "constructor": {}}, "measures": "zz"},
        {"was": [1, None, "x"]},
        {"was": "abc", "measures": [None]},
        {"was": None, "measures": [{"type": {"en": 5}}]},
        {"was": {"place": "abc"}, "measures": {"length": 2}},
    ]
    with room_page(browser, server, judge) as it:
        it.go("understand")
        first = copy.deepcopy(judge.scene)
        for number in range(0, len(wrong), 3):
            room = copy.deepcopy(first)
            for piece, notes in zip(room["furniture"], wrong[number : number + 3], strict=False):
                piece |= notes
            room |= {"home": ["no_drilling"], "title": f"link {number}"}
            now = after(it, judge, lambda room=room: it.page.evaluate(LINK, room))
            assert not any("measures" in piece for piece in now["furniture"])
        room = copy.deepcopy(first)
        it.go("scene")
        it.page.focus("#plan [data-thing=furniture-0]")
        room["furniture"][0] |= {"measures": belt, "was": {"measures": {}}}
        room["title"] = "a good one"
        after(it, judge, lambda: it.page.evaluate(LINK, room))
        assert "measures" not in judge.asked[-1]["before"]["furniture"][0]
        it.go("understand")
        assert lines(it) == ["Bookcase with belts"]


def test_what_is_ticked_of_the_home_stays_with_the_room(browser: Browser, server: Running) -> None:
    judge = Judge()
    with room_page(browser, server, judge) as it:
        it.go("understand")
        box = it.page.get_by_label("No drilling")
        plain = it.page.evaluate("location.hash")
        box.check()
        it.wait("(plain) => location.hash !== plain", plain)
        it.page.wait_for_timeout(300)  # longer than what settles before the server is asked
        assert len(judge.asked) == 1
        assert it.page.locator("#answer[data-old=false]").count() == 1
        link = it.page.url
        it.page.reload()
        it.settle()
        judged(it)
        assert box.is_checked()
        it.go("scene")
        it.page.click("#plan-undo")
        it.wait("() => !document.querySelector('#home input').checked")
        it.page.click("#plan-redo")
        it.wait("() => document.querySelector('#home input').checked")
        assert '"home"' not in str(judge.asked).replace("'", '"')
    with room_page(browser, server, judge, link.split("room/")[1]) as it:
        assert it.page.get_by_label("No drilling").is_checked()


def test_the_plan_begins_with_the_room_before_what_is_tried(client: httpx.Client) -> None:
    held = copy.deepcopy(ROOM)
    held["furniture"][0]["measures"] = [{"type": "l_bracket"}]
    asked: dict[str, Any] = {"scene": held, "before": ROOM, "changes": False}
    job = ended(client, client.post("/api/v1/room", json=asked).json())
    assert job["state"] == "done", job["error"]
    answer = client.get(f"/api/v1/jobs/{job['id']}/plan")
    assert "your choice" in answer.text


OTHER_ROOMS: list[tuple[str, Any]] = [
    ("plan", {"width": 3.1}),
    ("shaking", {"intensity": "5-upper"}),
    ("furniture", {"preset": "wardrobe"}),
    ("places", {"kind": "desk"}),
]
"""What is another in a room before; of a list, what is another of its first."""


@pytest.mark.parametrize(("key", "other"), OTHER_ROOMS)
def test_a_room_before_that_is_another_is_refused(client: httpx.Client, key: str, other: Any) -> None:
    value = copy.deepcopy(ROOM.get(key))
    if isinstance(value, list) and isinstance(other, dict):
        value[0] |= other
    else:
        value = {**value, **other} if isinstance(value, dict) else other
    refusal = client.post("/api/v1/room", json={"scene": ROOM, "before": {**ROOM, key: value}})
    assert refusal.status_code == 422
    assert refusal.json()["field"] == "before"
    assert f" in its {key};" in refusal.json()["message"]
    assert f"（{key}が違います）" in refusal.json()["message_ja"]


def test_a_room_before_may_differ_in_what_is_tried(client: httpx.Client) -> None:
    before = copy.deepcopy(ROOM)
    piece, place = before["furniture"][0], before["places"][0]
    piece["measures"] = [{"type": "l_bracket"}]
    piece["along"] += 0.01
    piece["gap"] = 0.03
    place |= {"name": "bed", "at": [place["at"][0] - 0.05, place["at"][1] - 0.05]}
    asked = {"scene": ROOM, "before": {**before, "title": "another"}, "changes": False}
    answer = client.post("/api/v1/room", json=asked)
    assert answer.status_code == 202, answer.text
    client.delete(answer.headers["location"])


def test_a_room_before_that_cannot_have_been_is_refused(client: httpx.Client) -> None:
    another = {**ROOM["furniture"][0], "name": "another"}
    for before, field in (([], "before.furniture"), ([another], "before")):
        asked = {"scene": ROOM, "before": {**ROOM, "furniture": before}}
        refusal = client.post("/api/v1/room", json=asked)
        assert refusal.status_code == 422
        assert refusal.json()["field"] == field
    elsewhere = copy.deepcopy(ROOM)
    (x, y), piece = ROOM["places"][0]["at"], elsewhere["furniture"][0]
    for key in ("against", "along", "gap"):
        piece.pop(key, None)
    piece |= {"at": [x, y], "heading": 0.0}  # on the bed
    asked = {"scene": ROOM, "before": elsewhere, "changes": False}
    job = ended(client, client.post("/api/v1/room", json=asked).json())
    assert job["state"] == "done"
    answer = client.get(f"/api/v1/jobs/{job['id']}/plan")
    assert answer.status_code == 422
    assert "Take them back" in answer.json()["message"]
    assert "元に戻す" in answer.json()["message_ja"]


def test_the_changes_that_help_come_first_and_the_others_are_asked_for(
    browser: Browser, server: Running, monkeypatch: pytest.MonkeyPatch
) -> None:
    helping = [change("bookcase", hit) for hit in (0.1, 0.2)]
    rarer = change("wardrobe", 0.8, helps=False, better=["overturned"], hit_change=chance(0.01))
    worse = change("chest", 0.9, better=["overturned"], worse=["shut_in"])
    unclear = [change("chest", 0.8) for _ in range(13)]
    verdict = {**made(), "changes": [*helping, rarer, worse, *unclear]}
    monkeypatch.setattr("room_judge.made", lambda: verdict)
    with room_page(browser, server, Judge()) as it:
        rows = it.page.locator("#ranking > li")
        assert rows.count() == 5
        tags = [one.get_attribute("class") for one in it.page.locator("#ranking .tag").all()]
        assert tags == ["tag", "tag", "tag", "tag gradeC", "tag unclear"]
        assert it.text("#all-changes") == "Show all 17"
        it.page.focus("#all-changes")
        it.page.keyboard.press("Enter")
        assert rows.count() == 17
        assert it.page.locator("#ranking > li:nth-child(6) button").evaluate(
            "one => one === document.activeElement"
        )
        assert it.page.locator("#all-changes").is_hidden()


def test_runs_of_the_room_and_of_pieces_are_told_apart(it: Opened, judge: Judge) -> None:
    assert it.text("#basis").startswith("Runs of the room: 40, under 20 earthquakes, ")
    assert "Runs of single pieces for that and for all changes: 360." in it.text("#basis")


REFUSING = """() => {
  Storage.prototype.setItem = () => { throw new DOMException("", "QuotaExceededError"); };
}"""


def reload(it: Opened) -> None:
    """Load the page again once its address has the room."""
    it.wait("() => document.getElementById('address').value === location.href")
    it.page.reload()
    it.settle()
    judged(it)


def test_the_history_goes_on_after_loading_again(it: Opened, judge: Judge) -> None:
    first = judge.scene
    before = it.page.evaluate("location.hash")
    moved = after(it, judge, lambda: it.page.click("#best button"))
    it.wait("before => location.hash !== before", before)
    reload(it)
    assert after(it, judge, lambda: it.page.click("#plan-undo")) == first
    assert it.page.is_disabled("#plan-undo")
    it.wait("before => location.hash === before", before)
    reload(it)
    assert after(it, judge, lambda: it.page.click("#plan-redo")) == moved


def test_a_history_that_is_damaged_or_cannot_be_kept_is_none(browser: Browser, server: Running) -> None:
    judge = Judge()
    with room_page(browser, server, judge) as it:
        before = it.page.evaluate("location.hash")
        it.page.evaluate(REFUSING)
        moved = after(it, judge, lambda: it.page.click("#best button"))
        it.wait("before => location.hash !== before", before)
        reload(it)
        assert judge.scene == moved
        assert it.page.is_disabled("#plan-undo")
        for kept in ("{", '{"past": [null], "future": []}'):
            it.page.add_init_script(f"sessionStorage.setItem('stayput-history', {kept!r});")
            reload(it)
            assert it.page.is_disabled("#plan-undo")


def test_a_long_history_is_cut_at_its_beginning(browser: Browser, server: Running) -> None:
    many = """async () => {
      const room = await import("/room/room.js");
      for (let i = 0; i < 120; i++) room.change({ ...room.current(), title: String(i).padStart(2e4) });
    }"""
    with editing(browser, server) as it:
        it.page.evaluate(many)
        it.page.reload()
        kept = it.page.evaluate("JSON.parse(sessionStorage.getItem('stayput-history')).past")
        assert 40 < len(kept) < 50
        assert kept[-1]["room"]["title"].strip() == "118"
