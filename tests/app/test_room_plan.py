"""The editor of a room's plan in Chromium: with mouse, finger and keyboard."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import pytest
from browsing import DESK, PHONE
from room_editing import ROOM, editing

import stayput as sp
from long_cases import long

if TYPE_CHECKING:
    from playwright.sync_api import Browser
    from room_editing import Editor
    from serving import Running


def test_a_piece_is_dragged_and_turns_its_back_to_a_wall_that_it_comes_near(editor: Editor) -> None:
    editor.drag((2.0, 1.0), (2.3, 1.7))
    chest = editor.room()["furniture"][1]
    assert chest["at"] == pytest.approx([2.3, 1.7], abs=0.02)
    assert chest["heading"] == 0.0
    assert "against" not in chest
    editor.drag((2.3, 1.7), (2.5, 0.2), drop=False)
    assert editor.room()["furniture"][1] == chest  # the room changes when it is dropped
    editor.page.mouse.up()
    chest = editor.room()["furniture"][1]
    assert chest["against"] == "near_side_wall"
    assert chest["along"] == pytest.approx(2.5, abs=0.02)
    assert "at" not in chest
    assert "heading" not in chest
    assert editor.said.startswith("Chest of drawers, at the near wall, 2.5")


def test_edges_and_corners_draw_with_a_line_and_not_with_alt(editor: Editor) -> None:
    editor.drag((2.0, 1.0), (3.5, 0.24))  # its side 6 cm from the right wall, along the near one
    assert editor.room()["furniture"][1]["along"] == pytest.approx(4.0 - 0.885 / 2)
    editor.press("Control+z")
    editor.drag((2.0, 1.0), (2.54, 1.0), drop=False)  # its front 5 cm from the side of the bed
    assert editor.page.locator("#plan .guide").count() >= 1
    editor.page.mouse.up()
    assert editor.page.locator("#plan .guide").count() == 0
    assert editor.room()["furniture"][1]["at"][0] == pytest.approx(2.8 - 0.21)
    editor.press("Control+z")
    editor.page.keyboard.down("Alt")
    editor.drag((2.0, 1.0), (2.54, 1.0))
    editor.page.keyboard.up("Alt")
    assert editor.room()["furniture"][1]["at"][0] == pytest.approx(2.54, abs=0.02)


def test_escape_gives_up_a_drag(editor: Editor) -> None:
    before = editor.room()
    editor.drag((2.0, 1.0), (1.0, 0.2), drop=False)
    editor.press("Escape")
    editor.page.mouse.up()
    assert editor.room() == before
    assert editor.page.locator("#plan-undo").is_disabled()


def test_undo_and_redo_go_through_all_changes(editor: Editor) -> None:
    states = [editor.room()]
    editor.drag((2.0, 1.0), (2.4, 1.2))
    states.append(editor.room())
    editor.press("r")
    states.append(editor.room())
    editor.press("Delete")
    states.append(editor.room())
    assert len(states[-1]["furniture"]) == 1
    editor.press("Control+z", "Control+z")
    assert editor.room() == states[1]
    editor.press("Control+Shift+z")
    assert editor.room() == states[2]
    editor.press("Control+y")
    assert editor.room() == states[3]
    assert editor.page.locator("#plan-redo").is_disabled()
    for _ in range(3):
        editor.page.click("#plan-undo")
    assert editor.room() == states[0]
    assert editor.page.locator("#plan-undo").is_disabled()


def test_what_follows_quickly_is_one_change(editor: Editor) -> None:
    editor.page.evaluate("() => { performance.now = () => 0; }")  # all at once, however slow the machine is
    editor.select("furniture-1")
    editor.press(*["ArrowRight"] * 4)
    assert editor.room()["furniture"][1]["at"] == pytest.approx([2.2, 1.0])
    editor.press("Control+z")
    assert editor.room() == ROOM


@pytest.mark.parametrize("size", [PHONE, *long(DESK)], ids=["phone", "desk"])
def test_a_finger_drags_kinds_and_pieces(browser: Browser, server: Running, size: dict[str, int]) -> None:
    with editing(browser, server, size=size, touch=True) as it:
        it.point(it.at(2.0, 1.0), it.at(1.4, 0.8))
        assert it.room()["furniture"][1]["at"] == pytest.approx([1.4, 0.8], abs=0.1)
        end = it.at(2.0, 1.6)
        box = it.page.locator("#palette [data-kind=wardrobe]").bounding_box()
        assert box is not None
        start = (box["x"] + 20, box["y"] + 20)
        scrolls = it.page.eval_on_selector("#palette .kind", "one => getComputedStyle(one).touchAction")
        # across the way in which the palette scrolls, then to the place
        off = (start[0] + 60, start[1]) if scrolls == "pan-y" else (start[0], start[1] + 60)
        it.point(start, off, end)
        wardrobe = it.room()["furniture"][2]
        assert wardrobe["preset"] == "wardrobe"
        assert wardrobe["at"] == pytest.approx([2.0, 1.6], abs=0.1)


def test_the_keyboard_moves_turns_doubles_and_removes(editor: Editor) -> None:
    editor.select("furniture-1")
    editor.press("ArrowRight", "ArrowUp", "Shift+ArrowLeft")
    assert editor.room()["furniture"][1]["at"] == pytest.approx([2.04, 1.05])
    assert "from the left wall" in editor.said
    editor.press("r")
    assert editor.room()["furniture"][1]["heading"] == pytest.approx(math.pi / 2)
    editor.press("d")
    assert [one["name"] for one in editor.room()["furniture"]][1:] == ["chest", "chest 2"]
    assert editor.page.evaluate("document.activeElement.dataset.thing") == "furniture-2"
    assert editor.wrong == ""
    editor.press("Delete")
    assert len(editor.room()["furniture"]) == 2
    assert editor.said == "Removed: Chest of drawers 2"
    editor.select("furniture-0")  # along its wall, then away from it
    editor.press("ArrowDown")
    assert editor.room()["furniture"][0]["along"] == pytest.approx(1.95)
    editor.press("ArrowRight")
    assert editor.room()["furniture"][0]["at"] == pytest.approx([0.22, 1.95])
    editor.press("ArrowLeft")
    assert editor.room()["furniture"][0]["against"] == "left_wall"
    editor.select("doors-0")
    editor.press("ArrowUp")
    assert editor.room()["doors"][0]["start"] == pytest.approx(0.15)
    editor.press("ArrowLeft")
    assert editor.room()["doors"][0]["wall"] == "left_wall"
    editor.press("r")
    assert editor.room()["doors"][0]["wall"] == "near_side_wall"


@pytest.mark.parametrize("size", [PHONE, *long(DESK)], ids=["phone", "desk"])
def test_what_is_selected_is_turned_and_removed_under_the_plan(
    browser: Browser, server: Running, size: dict[str, int]
) -> None:
    with editing(browser, server, size=size) as it:
        turn, remove = (it.page.locator(f"#plan-{name}") for name in ("turn", "remove"))
        assert turn.is_disabled()
        assert remove.is_disabled()
        it.select("furniture-1")
        plan, tools = (it.page.locator(name).bounding_box() for name in ("#plan", "#plan-tools"))
        assert plan
        assert tools
        assert 0 <= tools["y"] - (plan["y"] + plan["height"]) < 60
        turn.click()
        assert it.room()["furniture"][1]["heading"] == pytest.approx(math.pi / 2)
        remove.click()
        assert [one["name"] for one in it.room()["furniture"]] == ["bookcase"]
        assert remove.is_disabled()  # a second press removes nothing unseen
        assert it.page.locator("#plan .chosen").count() == 0
        assert it.said == "Removed: Chest of drawers"


def test_a_door_and_a_window_are_taken_beside_their_lines(editor: Editor) -> None:
    chosen = "import('/room/room.js').then((one) => one.selected())"
    for thing, point, off in (
        ({"table": "doors", "index": 0}, (3.75, 0.3), (0, 0)),  # within its swing
        ({"table": "doors", "index": 0}, (4.0, 0.45), (14, 0)),  # beside its opening, from outside
        ({"table": "windows", "index": 0}, (1.6, 3.0), (0, 6)),
        ({"table": "windows", "index": 0}, (1.6, 3.0), (0, -14)),
    ):
        editor.page.evaluate("import('/room/room.js').then((one) => one.select(null))")
        x, y = editor.at(*point)
        editor.page.mouse.click(x + off[0], y + off[1])
        assert editor.page.evaluate(chosen) == thing
    start = editor.at(3.75, 0.3)
    editor.pull(start, (start[0], start[1] - 60))  # by its swing
    assert editor.room()["doors"][0]["start"] > 0.3


OFFICE = {
    **ROOM,
    "plan": {"width": 6.0, "length": 5.0},
    "furniture": [
        {"name": "bookcase", "preset": "bookcase", "against": "left_wall", "along": 1.0},
        {"name": "Bookcase 2", "preset": "bookcase", "against": "left_wall", "along": 2.0},
        {"name": "vending machine", "preset": "vending machine", "against": "left_wall", "along": 3.2},
        {"name": "cupboard", "preset": "cupboard", "against": "far_side_wall", "along": 1.2},
        {"name": "refrigerator", "preset": "refrigerator", "against": "far_side_wall", "along": 2.4},
        {"name": "server rack", "preset": "server rack", "against": "far_side_wall", "along": 3.4},
        {"name": "Bookcase 3", "preset": "bookcase", "against": "right_wall", "along": 3.6},
        {"name": "Bookcase 4", "preset": "bookcase", "at": [3.6, 1.2], "heading": 0.0},
        {"name": "Bookcase 5", "preset": "bookcase", "at": [3.5, 3.7], "heading": -1.5708},
        {"name": "Bookcase 6", "preset": "bookcase", "at": [2.4, 3.7], "heading": -1.5708},
    ],
    "places": [
        {"kind": "desk", "at": [2.2, 2.4], "heading": 0.0},
        {"kind": "desk", "name": "Desk 2", "at": [4.2, 2.6], "heading": 0.0},
    ],
}
NAMES = """async () => {
  const view = await import("/room/view.js");
  const outlines = [...document.querySelectorAll("#plan .standing, #plan .place")];
  return [view.sheetNow().names, outlines.map((one) => {
    const { x, y, width, height } = one.getBBox();
    return [x, y, x + width, y + height];
  })];
}"""


def shared(one: list[float], other: list[float]) -> float:
    """Return what share of the first rectangle lies on the other."""
    wide, high = (min(one[i + 2], other[i + 2]) - max(one[i], other[i]) for i in (0, 1))
    return max(0.0, wide) * max(0.0, high) / ((one[2] - one[0]) * (one[3] - one[1]))


def apart(one: list[float], other: list[float]) -> float:
    """Return how far two rectangles are from each other."""
    return math.hypot(*(max(0.0, one[i] - other[i + 2], other[i] - one[i + 2]) for i in (0, 1)))


@pytest.mark.parametrize("size", [PHONE, *long(DESK)], ids=["phone", "desk"])
@pytest.mark.parametrize("language", ["ja", *long("en")])
def test_names_stand_beside_their_own_things(
    browser: Browser, server: Running, language: str, size: dict[str, int]
) -> None:
    told = """async (room) => (await import("/room/editor.js")).tellResult({ cell_m: 0.5, doors: [],
        pieces: room.furniture.map(({ name }) => (
          { name, probabilities: { overturned: { estimate: 0.83 } } })),
        places: ["desk", "Desk 2"].map((name) => ({ name, hit: { estimate: 0.88 } })) })"""
    with editing(browser, server, OFFICE, language=language, size=size) as it:
        with it.page.expect_request(
            lambda one: (
                one.url.endswith("/api/v1/room") and one.post_data_json["scene"].get("title") == "asked"
            )
        ):
            it.take({**OFFICE, "title": "asked"})
        it.page.evaluate(told, OFFICE)
        names, things = it.page.evaluate(NAMES)
        places = len(OFFICE["places"])
        assert len(names) == places + len(OFFICE["furniture"]) + 1
        for i, name in enumerate(names):
            for other in names[:i]:
                assert shared(name, other) < 0.1, (i, name, other)
            for j, thing in enumerate(things):
                assert j == i or shared(name, thing) < 0.25, (i, j)
        for i, own in enumerate(things):
            others = [thing for j, thing in enumerate(things) if j != i]
            off = apart(names[i], own)
            assert off == 0.0 or all(apart(names[i], other) > off for other in others), i
        assert it.page.locator("#plan .layer-names .note").count() == len(things)
        written = it.page.text_content("#plan .layer-names") or ""
        assert all(str(number) in written for number in range(2, 7))  # however short "Bookcase 5" is cut
        it.select("furniture-7")
        x, y = it.handle("turn")
        rectangles = "all => all.map((one) => one.getBoundingClientRect().toJSON())"
        plates = it.page.locator("#plan .plate").evaluate_all(rectangles)
        assert not any(
            one["x"] < x < one["x"] + one["width"] and one["y"] < y < one["y"] + one["height"]
            for one in plates
        )


def test_tab_goes_through_everything_and_out(editor: Editor) -> None:
    editor.page.focus("#palette button >> nth=-1")
    names = list[str]()
    for _ in range(40):
        editor.press("Tab")
        name = editor.page.evaluate(
            "document.activeElement.closest('#plan') && document.activeElement.ariaLabel"
        )
        if name:
            names.append(name.replace("\u00a0", " "))
        elif names:
            break
    assert names == [
        "Bed, 3.30 m from the left wall, 1.90 m from the near wall, head towards the near wall",
        "Bookcase, at the left wall, 2.00 m from the near wall",
        "Chest of drawers, 2.00 m from the left wall, 1.00 m from the near wall, facing the right wall",
        "Window, in the far wall, from 1.00 m to 2.20 m",
        "Door, in the right wall, from 0.10 m to 0.80 m, opens inwards",
    ]
    assert editor.page.evaluate("document.activeElement.closest('#plan')") is None


def test_a_press_in_the_palette_puts_things_into_free_spots(editor: Editor, server: Running) -> None:
    for kind in ("bookcase", "refrigerator", "cot", "desk", "sofa"):
        editor.page.focus(f"#palette [data-kind='{kind}']")
        editor.press("Enter")
        assert editor.wrong == ""
    room = editor.room()
    assert [one["name"] for one in room["furniture"]][2:] == ["bookcase 2", "refrigerator"]
    assert all(one["against"] for one in room["furniture"][2:])
    assert [one["kind"] for one in room["places"]] == ["bed", "cot", "desk", "sofa"]
    editor.page.click("#palette [data-table=doors]")
    editor.page.click("#palette [data-table=windows]")
    room = editor.room()
    assert len({one.get("name", "door") for one in room["doors"]}) == 2
    sp.Scenario.parse(room)  # the server takes it as it is


def test_a_kind_is_dragged_from_the_palette_to_where_it_shall_stand(editor: Editor) -> None:
    end = editor.at(2.0, 2.85)
    box = editor.page.locator("#palette [data-kind=television]").bounding_box()
    assert box is not None
    start = box["x"] + 20, box["y"] + 20
    editor.pull(start, end)
    made = editor.room()["furniture"][2]
    assert (made["preset"], made["against"]) == ("television", "far_side_wall")
    assert made["along"] == pytest.approx(2.0, abs=0.03)
    before = editor.room()
    editor.pull(start, (start[0] + 3.0, start[1] + 30.0))  # and dropped beside the plan
    assert editor.room() == before


def test_sides_are_pulled_and_a_wall_stays_at_the_back(editor: Editor) -> None:
    scale = editor.at(1.0, 0.0)[0] - editor.at(0.0, 0.0)[0]
    editor.select("furniture-0")
    assert editor.page.locator("[data-handle=back]").count() == 0
    x, y = editor.handle("front")
    editor.pull((x, y), (x + 0.2 * scale, y))
    bookcase = editor.room()["furniture"][0]
    assert bookcase["width"] == pytest.approx(0.5, abs=0.02)
    assert (bookcase["against"], bookcase["along"]) == ("left_wall", 2.0)
    assert (bookcase["height"], bookcase["mass"]) == (1.8, 200)
    assert "preset" not in bookcase  # which is a box of its own sizes now
    editor.select("places-0")
    x, y = editor.handle("left")  # the foot of the bed, at the far wall
    editor.pull((x, y), (x, y + 0.3 * scale))
    bed = editor.room()["places"][0]
    assert bed["length"] == pytest.approx(1.7, abs=0.02)
    assert bed["at"][1] - bed["length"] / 2 == pytest.approx(0.9, abs=0.02)  # the head stays
    editor.select("doors-0")
    x, y = editor.handle("end")
    editor.pull((x, y), (x, y - 0.2 * scale))
    assert editor.room()["doors"][0]["width"] == pytest.approx(0.9, abs=0.02)
    assert editor.room()["doors"][0]["start"] == 0.1


def test_a_piece_is_turned_in_steps_of_15_degrees(editor: Editor) -> None:
    editor.select("furniture-1")
    for angle, heading in ((math.radians(50), math.radians(45)), (1.5, math.pi / 2)):
        end = editor.at(2.0 + 0.8 * math.cos(angle), 1.0 + 0.8 * math.sin(angle))  # which scrolls
        editor.pull(editor.handle("turn"), end)
        assert editor.room()["furniture"][1]["heading"] == pytest.approx(heading)


def test_the_left_and_the_near_wall_are_pulled_and_what_stands_there_stays(editor: Editor) -> None:
    editor.page.evaluate("async () => (await import('/room/room.js')).select(null)")
    scale = editor.at(1.0, 0.0)[0] - editor.at(0.0, 0.0)[0]  # which scrolls
    chest = editor.at(2.0, 1.0)
    x, y = editor.handle("room-left")
    editor.pull((x, y), (x - 0.5 * scale, y), drop=False)
    drawn = editor.page.locator("[data-thing=furniture-1] .standing").bounding_box()
    assert drawn is not None
    middle = drawn["x"] + drawn["width"] / 2, drawn["y"] + drawn["height"] / 2
    assert middle == pytest.approx(chest, abs=2.0)  # on the screen
    editor.page.mouse.up()
    room = editor.room()
    width = room["plan"]["width"]
    assert width == pytest.approx(4.5, abs=0.03)
    moved = width - 4.0
    assert room["furniture"][0] == {**ROOM["furniture"][0], "gap": 0.02}  # its back stays at the left wall
    assert room["furniture"][1]["at"] == pytest.approx([2.0 + moved, 1.0])
    assert room["places"][0]["at"] == pytest.approx([3.3 + moved, 1.9])
    assert room["windows"][0]["start"] == pytest.approx(1.0 + moved)
    assert room["doors"][0]["start"] == 0.1  # in the right wall
    scale = editor.at(1.0, 0.0)[0] - editor.at(0.0, 0.0)[0]
    x, y = editor.handle("room-near")
    editor.pull((x, y), (x, y + 0.4 * scale))
    room = editor.room()
    moved_up = room["plan"]["length"] - 3.0
    assert moved_up == pytest.approx(0.4, abs=0.03)
    assert room["furniture"][0]["along"] == pytest.approx(2.0 + moved_up)
    assert room["furniture"][1]["at"] == pytest.approx([2.0 + moved, 1.0 + moved_up])
    assert room["doors"][0]["start"] == pytest.approx(0.1 + moved_up)
    editor.press("Control+z", "Control+z")
    assert editor.room() == ROOM


def test_a_smaller_room_takes_everything_with_it(editor: Editor) -> None:
    editor.page.evaluate("async () => (await import('/room/room.js')).select(null)")
    left, _ = editor.at(3.0, 0.0)  # which scrolls
    x, y = editor.handle("room-width")
    editor.pull((x, y), (left, y))
    room = editor.room()
    assert room["plan"]["width"] == pytest.approx(3.0, abs=0.05)
    assert room["places"][0]["at"][0] == pytest.approx(room["plan"]["width"] - 0.5)
    editor.field("From the near to the far wall", "2.2")
    room = editor.room()
    assert room["plan"]["length"] == 2.2
    assert room["furniture"][0]["along"] == pytest.approx(1.8)
    editor.press("Control+z")
    assert editor.page.locator("#plan").get_attribute("aria-label") is not None


def test_nothing_is_dragged_out_of_the_room(editor: Editor) -> None:
    for start, end in (((2.0, 1.0), (9.0, 1.5)), ((3.3, 1.9), (5.0, -3.0)), ((1.6, 3.02), (7.0, 3.0))):
        editor.pull(editor.at(*start), editor.at(*end))
    room = editor.room()
    assert room["furniture"][1]["against"] == "right_wall"
    assert room["places"][0]["at"] == pytest.approx([3.5, 1.0])
    window = room["windows"][0]
    assert window["start"] + window["width"] <= (4.0 if "side" in window["wall"] else 3.0) + 1e-9
    sp.Scenario.parse(room)


def test_what_stands_in_something_else_is_said_at_once(editor: Editor) -> None:
    editor.drag((2.0, 1.0), (3.1, 1.9), drop=False)
    assert re.fullmatch(r"Chest of drawers and Bed overlap by \d+ cm\.", editor.wrong)
    assert editor.page.locator("#plan .thing.wrong").count() == 2
    editor.page.mouse.up()
    assert editor.page.locator("#plan .thing.wrong").count() == 2
    editor.press("Control+z")
    assert editor.wrong == ""
    editor.take({**ROOM, "furniture": []})
    assert editor.wrong == "The room is empty; put at least one piece of furniture into it."
    editor.ask()
    editor.page.evaluate(
        """async () => (await import("/room/editor.js")).tellRefusal(
          new (await import("/api.js")).Refused(
            { message: "It must not.", field: "scene.doors[0].width" }, 422))"""
    )
    assert editor.wrong.endswith("It must not.")
    assert "wrong" in (editor.page.get_attribute("[data-thing=doors-0]", "class") or "")
