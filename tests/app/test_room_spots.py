"""Where what is added from the palette goes, in Chromium."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from room_editing import ROOM, editing

if TYPE_CHECKING:
    from playwright.sync_api import Browser
    from room_editing import Editor
    from serving import Running

EMPTY: dict[str, Any] = {**ROOM, "furniture": [], "places": [], "doors": [], "windows": []}
DOOR = {"wall": "left_wall", "start": 0.1, "width": 0.8}


def add(it: Editor, table: str, *kinds: str) -> None:
    for kind in kinds:
        it.page.click(f"#palette [data-table={table}][data-kind='{kind}']")


def test_pieces_are_spread_over_the_walls(browser: Browser, server: Running) -> None:
    window = {"wall": "near_side_wall", "start": 0.0, "width": 4.0, "sill": 0.8}
    with editing(browser, server, {**EMPTY, "doors": [DOOR], "windows": [window]}) as it:
        add(it, "furniture", "bookcase", "chest", "wardrobe", "bookcase", "refrigerator")
        pieces = it.room()["furniture"]
        assert it.wrong == ""
        assert {one["against"] for one in pieces[:3]} == {"left_wall", "right_wall", "far_side_wall"}
        assert all(one["against"] != "near_side_wall" for one in pieces)  # they are higher than its sill
        assert all(
            one["along"] > 1.0 for one in pieces if one["against"] == "left_wall"
        )  # not behind the door


def test_a_door_is_put_where_it_swings_freely(browser: Browser, server: Running) -> None:
    desks = [
        {"kind": "desk", "name": f"desk {i}", "at": [x, 2.5], "heading": 0.0}
        for i, x in enumerate((0.4, 1.2, 2.0, 2.8, 3.6), 2)
    ]
    with editing(browser, server, {**ROOM, "furniture": ROOM["furniture"][1:], "places": desks}) as it:
        add(it, "doors", "door")
        assert it.room()["doors"][1]["wall"] == "right_wall"
        assert it.wrong == ""


def test_a_door_that_opens_against_something_is_said(browser: Browser, server: Running) -> None:
    bed = {"kind": "bed", "at": [3.3, 1.2], "heading": 0.0}
    with editing(browser, server, {**ROOM, "places": [bed]}) as it:
        assert it.wrong == "Door does not open fully: Bed is in its way."
        assert it.page.locator("#plan .thing.wrong").count() == 2
        room = it.room()
        it.take({**room, "doors": [{**room["doors"][0], "opens": "outwards"}]})
        assert it.wrong == ""
