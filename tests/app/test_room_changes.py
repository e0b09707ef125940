"""The list of single changes on the page of a room, in Chromium."""

from __future__ import annotations

from typing import TYPE_CHECKING

from room_judge import Judge, chance, change, made, room_page

if TYPE_CHECKING:
    import pytest
    from browsing import Opened
    from playwright.sync_api import Browser
    from serving import Running


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
    assert it.text("#basis").startswith("Runs of the room: 40 = 20 earthquakes × 2, ")
    assert "Runs of single pieces for that and for all changes: 360." in it.text("#basis")
