"""Rooms that are kept on the device, and two of them side by side, in Chromium."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from browsing import PHONE, WAIT
from room_judge import Judge, after, as_sent, chance, made, place_of, room_page

if TYPE_CHECKING:
    import pytest
    from browsing import Opened
    from playwright.sync_api import Browser, Page
    from serving import Running


def test_rooms_are_kept_renamed_removed(it: Opened, judge: Judge) -> None:
    it.page.once("dialog", lambda one: one.accept("Bedroom"))
    it.page.fill("#scene-name", "As it is")
    it.page.click("#keep-scene button")
    first = judge.scene
    assert it.text("#scenes-said") == "Kept as “As it is”."
    it.page.get_by_role("button", name="Rename: As it is").click()
    assert it.text("#scenes strong") == "Bedroom"
    after(it, judge, lambda: it.page.click("#best button"))
    it.page.fill("#scene-name", "Moved")
    it.page.click("#keep-scene button")
    assert it.page.locator("#scenes strong").all_inner_texts() == ["Bedroom", "Moved"]
    opened_again = after(it, judge, it.page.get_by_role("button", name="Open: Bedroom").click)
    assert opened_again == first
    it.page.reload()
    it.page.wait_for_selector("#scenes strong")
    assert it.page.input_value("#scene-name") == "Bedroom"
    it.page.once("dialog", lambda one: one.accept())
    it.page.get_by_role("button", name="Remove: Moved").click()
    assert it.page.locator("#scenes strong").all_inner_texts() == ["Bedroom"]


def test_two_tabs_do_not_write_over_each_other(it: Opened, judge: Judge) -> None:
    it.page.fill("#scene-name", "Bedroom")
    it.page.click("#keep-scene button")
    other = another_tab(it, judge)
    other.get_by_role("button", name="Open: Bedroom").click()
    other.click("#best button")
    other.click("#keep-scene button")  # over the one of this name
    assert other.locator("#scenes strong").all_inner_texts() == ["Bedroom"]
    it.page.click("#keep-scene button")
    assert "in another tab" in it.text("#scenes-said")
    assert it.page.locator("#scenes strong").all_inner_texts() == ["Bedroom", "Bedroom (2)"]
    other.wait_for_selector("#scenes > li:nth-child(2)")  # it hears of the other tab's
    along = other.evaluate(
        "() => Object.values(localStorage).map((text) => text.startsWith('{') && JSON.parse(text))"
        ".filter((one) => one.room).map((one) => one.room.furniture[0].along).sort()"
    )
    assert along == [0.4, 1.9]
    other.close()


def another_tab(it: Opened, judge: Judge) -> Page:
    page = it.page.context.new_page()
    page.set_default_timeout(WAIT)
    for pattern, answer in judge.routes.items():
        page.route(pattern, answer)
    page.goto(it.page.url.split("#")[0])
    page.wait_for_selector("#ranking > li", state="attached")
    return page


REFUSING = """(name) => {
  localStorage.other = "1";
  Storage.prototype.setItem = function () { throw new DOMException("", name); };
}"""


def test_it_is_said_where_nothing_can_be_kept(browser: Browser, server: Running) -> None:
    with room_page(browser, server, Judge()) as it:
        for error, said in (("QuotaExceededError", "page is full"), ("SecurityError", "private window")):
            it.page.evaluate(REFUSING, error)
            it.page.click("#keep-scene button")
            assert said in it.text("#scenes-said")
            assert it.page.locator("#scenes strong").count() == 0


def test_two_rooms_are_compared_under_one_earthquake(it: Opened, judge: Judge) -> None:
    it.page.fill("#scene-name", "A")
    it.page.click("#keep-scene button")
    after(it, judge, lambda: it.page.click("#best button"))
    after(it, judge, it.page.get_by_label("7", exact=True).check)
    it.page.fill("#scene-name", "B")
    it.page.click("#keep-scene button")
    for mark in it.page.get_by_label("Mark to compare").all():
        mark.check()
    it.page.click("#compare")
    it.page.wait_for_selector("#comparison table")
    first, second = judge.asked[-2:]
    assert (first["changes"], second["changes"]) == (False, False)
    assert first["scene"]["shaking"] == second["scene"]["shaking"]
    assert first["scene"]["shaking"]["intensity"] == "6-upper"
    assert first["scene"].get("uncertainty") == second["scene"].get("uncertainty")
    assert place_of(first["scene"], "bookcase") != place_of(second["scene"], "bookcase")
    assert it.page.locator("#comparison svg .cover").count() > 0
    rows = it.page.locator("#comparison tbody tr").all_inner_texts()
    assert [row.split("\t")[0] for row in rows] == [
        "Somebody is hit",
        "Somebody is shut in",
        "Hit here: Bed",
        "Door: stays blocked",
        *("Bookcase overturns", "Chest of drawers overturns", "Wardrobe overturns"),
    ]
    assert rows[0].endswith("no clear difference")
    assert "no clear difference" in it.text("#compared")
    it.page.get_by_role("button", name="Close the comparison").click()
    assert not it.page.locator("#comparison").is_visible()


def test_a_comparison_says_which_room_is_better_and_how_sure_that_is(
    browser: Browser, server: Running, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The interval is Newcombe's of 48 of 60 and 6 of 60, by their Wilson intervals."""
    first = {**made(), "hit": chance(0.8, 0.68, 0.88)}
    second = {**made(), "hit": chance(0.1, 0.047, 0.2), "doors": []}
    answers = iter([first, first, second])
    kept: dict[int, Any] = {}
    judge = Judge()
    reply = judge._reply  # pyright: ignore[reportPrivateUsage]

    def answered(place: int, stage: str) -> dict[str, Any]:
        if place not in kept:
            kept[place] = next(answers)
        return {**reply(place, stage), "result": as_sent(kept[place])}

    monkeypatch.setattr(judge, "_reply", answered)
    with room_page(browser, server, judge, size=PHONE) as it:
        it.go("keep")
        for name in ("A", "B"):
            it.page.fill("#scene-name", name)
            it.page.click("#keep-scene button")
        for mark in it.page.get_by_label("Mark to compare").all():
            mark.check()
        it.page.click("#compare")
        it.page.wait_for_selector("#comparison table")
        assert it.text("#compared").splitlines()[0] == (
            "Somebody is hit: about 10 % in “B” instead of about 80 %; difference: −80 to −54 points."
        )
        assert "not there" in it.text("#comparison table")  # the door of the one
        assert it.page.evaluate("document.documentElement.scrollWidth <= innerWidth")
        it.page.get_by_role("button", name="Open: A").click()
        assert it.page.locator("#plan").is_visible()
