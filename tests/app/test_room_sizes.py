"""The page of a room on every size: what is seen first, on phones and wide screens, and axe."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest
from browsing import DESK, PHONE, opened
from room_judge import DONE, QUEUED, ROUGH, Judge, change, judged, made, room_page

from long_cases import long

if TYPE_CHECKING:
    from browsing import Opened
    from playwright.sync_api import Browser, Route
    from serving import Running


SIDE = {"width": 844, "height": 390}
WIDE = {"width": 1920, "height": 1080}
SCREENS = ("scene", "see", "understand", "keep")


@pytest.mark.parametrize("wider", [0.12, *long(0.0)], ids=["a font with wider letters", "own font"])
@pytest.mark.parametrize("size", [DESK, *long(WIDE, PHONE), SIDE], ids=["desk", "wide", "phone", "side"])
def test_the_plan_is_the_main_thing(browser: Browser, server: Running, size: Any, wider: float) -> None:
    with room_page(browser, server, Judge(), size=size) as it:
        it.page.add_style_tag(content=f"body {{ letter-spacing: {wider}em; }}")
        it.page.evaluate("() => new Promise(requestAnimationFrame)")
        palette, plan, sheet = (it.box(name) for name in ("#palette", "#plan", ".sheet"))
        bottom = size["height"] if size["width"] > 1000 else it.box("#steps")["y"]
        assert plan["y"] + plan["height"] <= bottom
        if size is SIDE:
            assert palette["x"] + palette["width"] <= plan["x"]
        else:
            assert plan["width"] > 0.9 * sheet["width"]
            assert palette["height"] < 160 or palette["x"] + palette["width"] <= plan["x"]
        it.page.locator(".kind").last.scroll_into_view_if_needed()
        it.page.locator(".kind").last.click()
        assert it.page.locator("#plan [data-thing=windows-1]").count() == 1


@pytest.mark.parametrize("size", [PHONE, *long(SIDE)], ids=["upright", "on its side"])
def test_a_palette_fades_where_there_is_more_of_it(browser: Browser, server: Running, size: Any) -> None:
    with room_page(browser, server, Judge(), size=size) as it:
        more = "() => document.getElementById('palette').dataset.more === '{}'"
        it.wait(more.format("after"))
        it.page.locator("#palette").evaluate("one => one.scrollBy(40, 40)")
        it.wait(more.format("before after"))
        it.page.locator("#palette").evaluate("one => one.scrollBy(9999, 9999)")
        it.wait(more.format("before"))


@pytest.mark.parametrize("size", [PHONE, *long(SIDE)], ids=["upright", "on its side"])
def test_a_phone_shows_the_verdict_in_one_line_beside_the_plan(
    browser: Browser, server: Running, size: dict[str, int]
) -> None:
    judge = Judge(ROUGH)
    with opened(browser, server, "room/", routes=judge.routes, size=size) as it:
        it.wait("() => document.getElementById('in-brief').textContent.includes('counting')")
        judge.stage = DONE
        judged(it)
        line = it.page.locator("#brief button")
        assert it.text("#brief") == "Somebody hit: about 80 % · shut in: about 10 %"
        seen = it.box("#brief")
        assert seen["y"] + seen["height"] <= size["height"]
        judge.stage = QUEUED
        it.page.locator("#palette [data-kind=chest]").click()
        it.wait("() => document.getElementById('brief').dataset.old === 'true'")
        assert (
            it.text("#brief")
            == "Before the change: somebody hit: about 80 % · shut in: about 10 % · counting …"
        )
        assert it.page.evaluate("document.documentElement.scrollWidth <= innerWidth")
        judge.stage = DONE
        judged(it)
        line.click()
        it.page.wait_for_selector("body[data-screen=understand]")
        assert it.page.locator("#verdict").is_visible()
        assert not line.is_visible()
        it.page.go_back()
        it.page.wait_for_selector("body[data-screen=scene]")


@pytest.mark.parametrize("size", [PHONE, *long(DESK)], ids=["phone", "desk"])
def test_the_plan_to_buy_and_do_is_beside_the_verdict_with_its_progress(
    browser: Browser, server: Running, size: dict[str, int]
) -> None:
    runs = [0]
    waiting: list[Route] = []
    asked: list[str] = []

    def progress(route: Route) -> None:
        route.fulfill(json={"made": False, "runs": runs[0]})

    def plan(route: Route) -> None:
        asked.append(route.request.url)
        waiting.append(route)

    with room_page(browser, server, Judge(), size=size, allowed=("Failed to load",)) as it:
        it.page.route("**/jobs/*/plan?*", plan)
        it.page.route("**/jobs/*/plan/progress?*", progress)
        it.go("understand")
        answer, todo, rest = (it.box(name) for name in ("#answer", "#todo", "#understand"))
        assert answer["y"] + answer["height"] <= todo["y"] < todo["y"] + todo["height"] <= rest["y"]
        assert answer["x"] == todo["x"]
        it.page.click("#make-plan")
        it.page.wait_for_selector("#plan-progress:visible")
        assert it.text("#plan-state") == "Runs so far: 0"
        runs[0] = 1120
        it.wait("() => document.getElementById('plan-state').textContent === 'Runs so far: 1,120'")
        it.page.click("#stop-plan")
        assert not it.page.locator("#plan-progress").is_visible()
        assert not it.page.locator("#card").is_visible()
        it.page.get_by_label("No drilling").check()
        it.page.click("#make-plan")
        wait_until_routed(it, waiting, 2)
        waiting.pop().fulfill(body="<p>The plan</p>", content_type="text/html")
        it.page.wait_for_selector("#card:visible")
        assert "no_drilling=true" in asked[-1]
        assert "no_drilling=true" in (it.page.get_attribute("#card", "href") or "")
        assert it.page.get_attribute("#card", "target") == "_blank"
        it.page.get_by_label("No drilling").uncheck()  # which is another plan
        assert not it.page.locator("#card").is_visible()
        it.page.click("#make-plan")
        wait_until_routed(it, waiting, 2)
        sentence = "It-cannot-be-" * 30
        refusal = {"message": sentence, "message_ja": None, "field": None}
        waiting.pop().fulfill(status=409, json=refusal)
        it.page.wait_for_selector("#plan-said:visible")
        assert sentence in it.text("#plan-said")
        assert it.page.evaluate("document.documentElement.scrollWidth <= innerWidth")


def wait_until_routed(it: Opened, waiting: list[Route], count: int) -> None:
    """Wait until so many questions have come; waiting lets the page's events be handled."""
    for _ in range(600):
        if len(waiting) >= count:
            return
        it.page.wait_for_timeout(100)
    raise AssertionError(waiting)


def test_a_finger_is_not_told_to_drop_files(browser: Browser, server: Running) -> None:
    context = browser.new_context(viewport=PHONE, has_touch=True, is_mobile=True, locale="en-GB")  # type: ignore[arg-type]
    page = context.new_page()
    page.goto(f"{server.address}/room/")
    page.wait_for_selector("#drop")
    assert page.inner_text("#drop label").replace("\n", " ") == "Your own record: choose one"
    context.close()
    with room_page(browser, server, Judge()) as it:
        assert "drop a file here" in it.text("#drop label")
        assert it.text("#drop label").count("Your own record") == 1


@pytest.mark.parametrize("language", ["ja", *long("en")])
def test_on_its_side_the_player_is_in_sight(
    browser: Browser, server: Running, monkeypatch: pytest.MonkeyPatch, language: str
) -> None:
    long = {
        **made(),
        "verdict": {
            "en": "The bookcase hits whoever is in bed. " * 8,
            "ja": "「本棚」がベッドにいる人に当たります。" * 8,
        },
    }
    monkeypatch.setattr("room_judge.made", lambda: long)
    with room_page(browser, server, Judge(), size=SIDE, language=language) as it:
        it.go("see")
        picture, player = it.box("#space"), it.box(".transport")
        assert picture["height"] > 110
        assert picture["y"] + picture["height"] <= player["y"] + 1
        assert player["y"] + player["height"] <= it.box("#steps")["y"]


@pytest.mark.parametrize("language", ["ja", *long("en")])
def test_nothing_is_beside_a_phone(
    browser: Browser, server: Running, monkeypatch: pytest.MonkeyPatch, language: str
) -> None:
    english = "L-brackets and belts on the upper cupboard of the dining room, and the bed moved"
    japanese = "「食堂の上の戸棚」をL字金具とベルトで固定し、さらに「寝室のベッド」を移動"
    many = [
        change(
            "bookcase",
            0.1,
            label=(english, japanese),
            better=["hit", "shut_in", "overturned"],
            worse=["blocked"],
        )
        for _ in range(20)
    ]
    long = {**made(), "changes": [*many, change("bookcase", 0.1, label=("averylongword" * 8, "棚" * 60))]}
    monkeypatch.setattr("room_judge.made", lambda: long)
    with room_page(browser, server, Judge(), size=PHONE, language=language) as it:
        it.go("understand")
        it.page.locator("#ranking > li").first.wait_for()
        if it.page.is_visible("#all-changes"):
            it.page.click("#all-changes")
        for width in (PHONE["width"], 360):
            it.page.set_viewport_size({**PHONE, "width": width})
            for screen in SCREENS:
                it.go(screen)
                assert it.page.evaluate("document.documentElement.scrollWidth <= innerWidth"), (screen, width)
            it.go("understand")
            for button in it.page.locator("#ranking button").all():
                box = button.bounding_box()
                assert box
                assert box["x"] + box["width"] <= width


@pytest.mark.parametrize(
    ("theme", "language", "size"),
    [
        ("dark", "ja", SIDE),
        *long(("light", "en", DESK), ("dark", "ja", DESK), ("light", "ja", PHONE), ("dark", "en", PHONE)),
    ],
)
def test_axe_finds_nothing_serious(
    browser: Browser, server: Running, theme: str, language: str, size: dict[str, int]
) -> None:
    with room_page(browser, server, Judge(), theme=theme, language=language, size=size) as it:
        it.go("keep")
        it.page.click("#keep-scene button")
        for screen in SCREENS if size in (PHONE, SIDE) else ("scene",):
            it.go(screen)
            assert it.grave() == []
        it.go("scene")
        for thing in ("furniture-0", "places-0", "doors-0"):
            it.page.focus(f"[data-thing={thing}]")
            assert it.grave() == []
            assert it.page.evaluate("document.documentElement.scrollWidth <= innerWidth")
