"""What can be undone on the page of a room, in Chromium."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from room_editing import editing
from room_judge import Judge, after, judged

if TYPE_CHECKING:
    from browsing import Opened
    from playwright.sync_api import Browser
    from serving import Running

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


@pytest.mark.parametrize("kept", ["{", '{"past": [null], "future": []}'])
def test_a_damaged_history_is_none(it: Opened, judge: Judge, kept: str) -> None:
    it.page.add_init_script(f"sessionStorage.setItem('stayput-history', {kept!r});")
    reload(it)
    assert it.page.is_disabled("#plan-undo")


def test_storage_that_is_full_or_refused_is_no_error(it: Opened, judge: Judge) -> None:
    before = it.page.evaluate("location.hash")
    it.page.evaluate(REFUSING)
    moved = after(it, judge, lambda: it.page.click("#best button"))
    it.wait("before => location.hash !== before", before)
    reload(it)
    assert judge.scene == moved
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
