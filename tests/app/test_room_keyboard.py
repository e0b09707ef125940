"""The page of a room with the keyboard alone, in Chromium."""

from __future__ import annotations

from typing import TYPE_CHECKING

from room_editing import ROOM, editing

if TYPE_CHECKING:
    from playwright.sync_api import Browser
    from room_editing import Editor
    from serving import Running

FOCUSED = """() => {
  const { labels, textContent } = document.activeElement;
  return (labels?.[0]?.textContent ?? textContent).trim();
}"""


def tab_to(it: Editor, label: str, key: str = "Tab") -> None:
    """Go on from what is focused until something of a label is."""
    seen: list[str] = []
    for _ in range(60):
        it.press(key)
        seen.append(it.page.evaluate(FOCUSED))
        if seen[-1].startswith(label):
            return
    raise AssertionError(seen)


def test_a_piece_is_put_turned_resized_moved_and_held(browser: Browser, server: Running) -> None:
    with editing(browser, server, {**ROOM, "furniture": []}) as it:
        it.page.focus("#plan")
        tab_to(it, "Wardrobe", "Shift+Tab")
        it.press("Enter")
        (piece,) = it.room()["furniture"]
        it.press("r")
        (turned,) = it.room()["furniture"]
        assert (piece.get("against"), turned.get("against")) == ("left_wall", None)
        it.press("Enter")
        assert it.page.evaluate(FOCUSED) == "Name"
        tab_to(it, "Stands with its back to")
        it.press("ArrowDown", "ArrowDown", "ArrowDown")
        (moved,) = it.room()["furniture"]
        assert moved["against"] not in (None, "left_wall")
        tab_to(it, "Height")
        it.press("Control+a", "1", "2", "0", "Enter")
        tab_to(it, "Anti-slip sheet")
        it.press("Space")
        (held,) = it.room()["furniture"]
        assert held["height"] == 1.2
        assert [one["type"] for one in held["measures"]] == ["anti_slip_sheet"]
        assert it.page.evaluate(FOCUSED).startswith("Anti-slip sheet")  # the focus stays where it was
        it.press("Escape")
        assert it.page.evaluate("document.activeElement.dataset.thing") == "furniture-0"
        it.press("Control+z")
        assert "measures" not in it.room()["furniture"][0]
