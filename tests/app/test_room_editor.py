"""The editor of a room: its numbers, its layers and defaults, the keyboard alone, and where new things go."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from browsing import DESK, PHONE
from room_editing import ROOM, editing

import stayput as sp
from long_cases import long
from stayput.fragility.probabilities import percent, probability_of_counts
from stayput.scenario.pieces import PieceTable
from stayput.scenario.scene import DoorTable, PlaceTable, WindowTable

if TYPE_CHECKING:
    from playwright.sync_api import Browser
    from room_editing import Editor
    from serving import Running


@pytest.mark.parametrize("size", [PHONE, *long(DESK)], ids=["phone", "desk"])
def test_what_is_refused_breaks_no_layout(browser: Browser, server: Running, size: dict[str, int]) -> None:
    word = "averylongword" * 20
    refusal = {"message": word, "message_ja": None, "field": "scene.furniture[1].at"}
    fits = "document.documentElement.scrollWidth <= innerWidth"
    with editing(browser, server, size=size, refused=422) as it:
        it.take({**ROOM, "furniture": [{**ROOM["furniture"][0], "length": 90.0, "name": word}]})
        it.page.set_input_files("#file", {"name": f"{word}.txt"[-200:], "mimeType": "", "buffer": b"hello"})
        it.page.wait_for_selector("#uploaded .refusal")
        assert it.page.evaluate(fits)
        it.select("furniture-0")
        it.field("Mass with its content", "-5")
        assert it.page.locator("#inspector .why:visible").count() == 1
        assert it.page.evaluate(fits)
        for path in ("room", "simulate"):
            it.page.route(f"**/api/v1/{path}", lambda route: route.fulfill(status=422, json=refusal))
        it.take({**ROOM, "title": "refused"})
        it.page.wait_for_selector("#answer[data-state=refused]", state="attached")
        it.page.wait_for_selector("#plan-problems .refusal")
        for screen in ("scene", "see", "understand", "keep"):
            it.page.click(f"#steps button[data-screen={screen}]")
            assert it.page.evaluate(fits), screen


def test_numbers_are_typed_and_wrong_ones_are_said(editor: Editor) -> None:
    editor.select("furniture-0")
    editor.field("Gap to the wall", "5")
    assert editor.room()["furniture"][0]["gap"] == pytest.approx(0.05)
    editor.field("Height", "150")
    assert editor.room()["furniture"][0]["height"] == pytest.approx(1.5)
    before = editor.room()
    inspector = editor.page.locator("#inspector")
    for label, value, words in (
        ("Height", "0", "From 0.1 to 3000 cm."),
        ("Its middle along it, from the near or left end", "7", "From 0 to 3 m."),
        ("Mass with its content", "", "From 0.001 to 1000000 kg."),
    ):
        editor.field(label, value)
        assert editor.room() == before
        field = inspector.get_by_label(label, exact=True)
        assert field.get_attribute("aria-invalid") == "true"
        assert words in inspector.inner_text().replace("\u00a0", " ")
    editor.field("Name", "chest")
    assert editor.room() == before
    assert "is the name of something else" in inspector.inner_text()
    editor.field("Name", "Grandmother's")
    assert editor.room()["furniture"][0]["name"] == "Grandmother's"
    editor.page.locator("#inspector").get_by_label("Stands with its back to", exact=True).select_option("")
    assert editor.room()["furniture"][0]["at"] == pytest.approx([0.2, 2.0])


def test_places_doors_and_windows_have_their_numbers(editor: Editor) -> None:
    editor.select("places-0")
    editor.field("Share of the day with somebody there", "25")
    editor.field("up to this height", "40")  # below the lower one
    assert editor.room()["places"][0] == {**ROOM["places"][0], "day": 0.25}
    editor.field("up to this height", "90")
    assert editor.room()["places"][0]["high"] == pytest.approx(0.9)
    editor.select("doors-0")
    inspector = editor.page.locator("#inspector")
    inspector.get_by_label("How it opens", exact=True).select_option("outwards")
    inspector.get_by_label("Hinge", exact=True).select_option("end")
    inspector.get_by_label("It leads out", exact=True).uncheck()
    editor.field("Clear width", "300")  # longer than its wall
    door = {
        "wall": "right_wall",
        "start": 0.1,
        "width": 0.7,
        "opens": "outwards",
        "hinge": "end",
        "way_out": False,
    }
    assert editor.room()["doors"][0] == door
    editor.select("windows-0")
    editor.field("Sill above the floor", "60")
    assert editor.room()["windows"][0]["sill"] == pytest.approx(0.6)


def test_measures_that_fit_are_put_on_a_piece(editor: Editor) -> None:
    editor.select("furniture-0")
    inspector = editor.page.locator("#inspector")
    inspector.get_by_label("Screwed L-brackets", exact=True).check()
    inspector.get_by_label("Adhesive gel mats", exact=True).check()
    inspector.get_by_label("Anti-slip sheet", exact=True).check()  # in the place of the mats
    assert [one["type"] for one in editor.room()["furniture"][0]["measures"]] == [
        "l_bracket",
        "anti_slip_sheet",
    ]
    sp.Scenario.parse(editor.room())
    editor.select("furniture-1")
    assert inspector.get_by_label("Screwed L-brackets", exact=True).is_disabled()
    assert "This needs a wall behind the piece." in inspector.inner_text()


def test_a_verdict_is_drawn_in_layers(editor: Editor) -> None:
    grid = """(await import("/room/editor.js")).tellResult({ cell_m: 0.5,
        pieces: ["bookcase", "chest"].map((name, i) => ({ name, stability: ["may_fall", "moves"][i],
          probabilities: { overturned: { estimate: 0.4 } },
          fell: { nx: 2, ny: 1, shares: btoa(String.fromCharCode(255, 26)) },
          stood: { nx: 2, ny: 1, shares: btoa(String.fromCharCode(0, 0)) } })),
        places: [{ name: "bed", hit: { estimate: 0.3 } }],
        doors: [{ name: "door", blocked: { estimate: 0 } }] }"""
    editor.ask()
    assert not editor.page.locator("#plan-layers").is_visible()
    editor.page.evaluate(f"async () => {{ {grid}); }}")
    classes = editor.page.eval_on_selector_all(
        "#plan .cover", "all => all.map((one) => one.getAttribute('class'))"
    )
    assert sorted(classes) == sorted(2 * [f"cover fell step{step}" for step in (2, 10)])
    steps = editor.page.eval_on_selector_all(
        "#plan .standing", "all => all.map((one) => one.getAttribute('class'))"
    )
    assert steps == ["standing may_fall", "standing moves"]
    told = editor.page.text_content("#plan .layer-names") or ""
    assert "hit: 30" in told
    assert "overturns: 40" in told
    assert editor.page.locator("#plan .hit").count() == 1
    assert editor.page.locator("#plan .blocked").count() == 0
    editor.page.get_by_label("Where pieces fall").uncheck()
    assert editor.page.locator("#plan .cover").count() == 0
    editor.page.get_by_label("Who is hit").uncheck()
    assert "hit:" not in (editor.page.text_content("#plan .layer-names") or "")
    editor.page.evaluate(f"async () => {{ {grid}, {{ old: true }}); }}")
    assert "old" in (editor.page.get_attribute("#plan", "class") or "")


def test_defaults_of_the_page_are_those_of_the_scenario(editor: Editor) -> None:
    tables = {"furniture": PieceTable, "places": PlaceTable, "doors": DoorTable, "windows": WindowTable}
    found = editor.page.evaluate("import('/room/kinds.js').then((one) => one.DEFAULTS)")
    for name, table in tables.items():
        assert found[name] == {key: table.model_fields[key].default for key in found[name]}, name


def test_shares_are_rounded_as_the_server_rounds_them(editor: Editor) -> None:
    # what a change leaves is a difference, whose last digits are not those of the share itself
    told = """async (shares) => {
      const { percent } = await import("/words.js");
      return shares.map((share) => [percent(share), percent(share + 0.1 - 0.1), percent(1 - (1 - share))]);
    }"""
    shares = [hit / runs for runs in (20, 40, 60, 200) for hit in range(runs + 1)]
    for share, said in zip(shares, editor.page.evaluate(told, shares), strict=True):
        assert {one.replace("\u00a0", " ") for one in said} == {f"{percent(share)} %"}, share


def test_chances_are_told_as_the_server_tells_them(editor: Editor) -> None:
    chances = [
        probability_of_counts(np.full(motions, fell), np.full(motions, samples), missing)
        for motions, samples, missing in (
            (1, 1, 0),
            (1, 400, 0),
            (3, 2, 1),
            (20, 40, 0),
            (40, 10, 2),
            (400, 50, 0),
        )
        for fell in range(samples + 1)
    ]
    rows = [{"estimate": one.estimate, "low": one.low, "high": one.high} for one in chances]
    script = """async (rows) => {
      const { brief, chance, share } = await import("/words.js");
      return rows.map((row) => [share, chance, brief].map((told) => told(row).replaceAll("\u00a0", " ")));
    }"""
    said = editor.page.evaluate(script, rows)
    for one, told in zip(chances, said, strict=True):
        assert told == [one.share[0], one.texts[0], f"{one.brief} %"], one


def test_how_many_runs_a_file_asks_for_is_one_of_the_choices(editor: Editor) -> None:
    chosen = editor.page.locator("#precision option:checked")
    editor.page.wait_for_function("() => document.getElementById('precision').value === 'own'")
    assert chosen.text_content() == "as the file says"


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


def test_a_piece_is_put_turned_resized_moved_and_held(editor: Editor) -> None:
    editor.take({**ROOM, "furniture": []})
    editor.page.focus("#plan")
    tab_to(editor, "Wardrobe", "Shift+Tab")
    editor.press("Enter")
    (piece,) = editor.room()["furniture"]
    editor.press("r")
    (turned,) = editor.room()["furniture"]
    assert (piece.get("against"), turned.get("against")) == ("left_wall", None)
    editor.press("Enter")
    assert editor.page.evaluate(FOCUSED) == "Name"
    tab_to(editor, "Stands with its back to")
    editor.press("ArrowDown", "ArrowDown", "ArrowDown")
    (moved,) = editor.room()["furniture"]
    assert moved["against"] not in (None, "left_wall")
    tab_to(editor, "Height")
    editor.press("Control+a", "1", "2", "0", "Enter")
    tab_to(editor, "Anti-slip sheet")
    editor.press("Space")
    (held,) = editor.room()["furniture"]
    assert held["height"] == 1.2
    assert [one["type"] for one in held["measures"]] == ["anti_slip_sheet"]
    assert editor.page.evaluate(FOCUSED).startswith("Anti-slip sheet")  # the focus stays where it was
    editor.press("Escape")
    assert editor.page.evaluate("document.activeElement.dataset.thing") == "furniture-0"
    editor.press("Control+z")
    assert "measures" not in editor.room()["furniture"][0]


EMPTY: dict[str, Any] = {**ROOM, "furniture": [], "places": [], "doors": [], "windows": []}
DOOR = {"wall": "left_wall", "start": 0.1, "width": 0.8}


def add(it: Editor, table: str, *kinds: str) -> None:
    for kind in kinds:
        it.page.click(f"#palette [data-table={table}][data-kind='{kind}']")


def test_pieces_are_spread_over_the_walls(editor: Editor) -> None:
    window = {"wall": "near_side_wall", "start": 0.0, "width": 4.0, "sill": 0.8}
    editor.take({**EMPTY, "doors": [DOOR], "windows": [window]})
    add(editor, "furniture", "bookcase", "chest", "wardrobe", "bookcase", "refrigerator")
    pieces = editor.room()["furniture"]
    assert editor.wrong == ""
    assert {one["against"] for one in pieces[:3]} == {"left_wall", "right_wall", "far_side_wall"}
    assert all(one["against"] != "near_side_wall" for one in pieces)  # they are higher than its sill
    assert all(one["along"] > 1.0 for one in pieces if one["against"] == "left_wall")  # not behind the door


def test_a_door_is_put_where_it_swings_freely(editor: Editor) -> None:
    desks = [
        {"kind": "desk", "name": f"desk {i}", "at": [x, 2.5], "heading": 0.0}
        for i, x in enumerate((0.4, 1.2, 2.0, 2.8, 3.6), 2)
    ]
    editor.take({**ROOM, "furniture": ROOM["furniture"][1:], "places": desks})
    add(editor, "doors", "door")
    assert editor.room()["doors"][1]["wall"] == "right_wall"
    assert editor.wrong == ""


def test_a_door_that_opens_against_something_is_said(editor: Editor) -> None:
    bed = {"kind": "bed", "at": [3.3, 1.2], "heading": 0.0}
    editor.take({**ROOM, "places": [bed]})
    assert editor.wrong == "Door does not open fully: Bed is in its way."
    assert editor.page.locator("#plan .thing.wrong").count() == 2
    room = editor.room()
    editor.take({**room, "doors": [{**room["doors"][0], "opens": "outwards"}]})
    assert editor.wrong == ""
