"""Rooms that are kept on the device, and two of them side by side, in Chromium."""

# ruff: noqa: F811 - a fixture is imported, and then asked for by its name
from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from browsing import COMPILING, DESK, FEW, PHONE, WAIT, browser, opened  # noqa: F401
from room_judge import Judge, after, place_of, room_page

if TYPE_CHECKING:
    from browsing import Opened
    from playwright.sync_api import Browser, Page
    from serving import Running


def test_rooms_are_kept_renamed_removed(browser: Browser, server: Running) -> None:
    judge = Judge()
    with room_page(browser, server, judge) as it:
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


def test_two_tabs_do_not_write_over_each_other(browser: Browser, server: Running) -> None:
    judge = Judge()
    with room_page(browser, server, judge) as it:
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


def another_tab(it: Opened, judge: Judge) -> Page:
    page = it.page.context.new_page()
    page.set_default_timeout(WAIT)
    for pattern, answer in judge.routes.items():
        page.route(pattern, answer)
    page.goto(it.page.url.split("#")[0])
    page.wait_for_selector("#ranking > li", state="attached")
    return page


@pytest.mark.parametrize(
    ("error", "said"),
    [("QuotaExceededError", "storage for this page is full"), ("SecurityError", "private window")],
)
def test_it_is_said_where_nothing_can_be_kept(
    browser: Browser, server: Running, error: str, said: str
) -> None:
    with room_page(browser, server, Judge()) as it:
        it.page.evaluate(
            """(name) => {
              localStorage.setItem("other", "1");
              Storage.prototype.setItem = function () { throw new DOMException("", name); };
            }""",
            error,
        )
        it.page.click("#keep-scene button")
        assert said in it.text("#scenes-said")
        assert it.page.locator("#scenes strong").count() == 0


def test_two_rooms_are_compared_under_one_earthquake(browser: Browser, server: Running) -> None:
    judge = Judge()
    with room_page(browser, server, judge) as it:
        it.page.fill("#scene-name", "A")
        it.page.click("#keep-scene button")
        after(it, judge, lambda: it.page.click("#best button"))
        after(it, judge, it.page.get_by_label("7", exact=True).check)
        it.page.fill("#scene-name", "B")
        it.page.click("#keep-scene button")
        for mark in it.page.get_by_label("Mark to compare").all():
            mark.check()
        it.page.click("#compare")
        it.page.wait_for_selector("#comparison section:nth-child(2) dl")
        first, second = judge.asked[-2:]
        assert (first["changes"], second["changes"]) == (False, False)
        assert first["scene"]["shaking"] == second["scene"]["shaking"]
        assert first["scene"]["shaking"]["intensity"] == "6-upper"
        assert first["scene"]["uncertainty"] == second["scene"]["uncertainty"]
        assert place_of(first["scene"], "bookcase") != place_of(second["scene"], "bookcase")
        assert it.page.locator("#comparison svg .cover").count() > 0
        assert it.page.locator("#comparison dd").count() == 8
        it.page.get_by_role("button", name="Close the comparison").click()
        assert not it.page.locator("#comparison").is_visible()
