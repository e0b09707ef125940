"""The page of a room in Chromium: its verdict, its changes, its picture in space, and what is kept of it."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any

from browsing import COMPILING, DESK, PHONE, opened
from room_judge import (
    COUNTED,
    DONE,
    QUEUED,
    ROUGH,
    Judge,
    after,
    as_sent,
    chance,
    change,
    judged,
    made,
    place_of,
    room_page,
)

from stayput.app.verification import VerdictReply

if TYPE_CHECKING:
    import pytest
    from browsing import Opened
    from playwright.sync_api import Browser, Route
    from serving import Running


EXAMPLES = Path(__file__).parents[2] / "examples"


def test_the_made_up_verdict_is_one_of_the_server() -> None:
    VerdictReply.model_validate(as_sent(made()))


def few(route: Route) -> None:
    asked: dict[str, Any] = route.request.post_data_json
    scene = asked["scene"]
    scene["shaking"] |= {"suite": scene["shaking"]["suite"] | {"count": 2}, "member": 1}
    scene["uncertainty"] = {"samples": 2}
    scene["furniture"] = scene["furniture"][:1]
    route.continue_(post_data=asked)


def test_the_verdict_is_the_servers(browser: Browser, server: Running) -> None:
    with opened(browser, server, "room/", routes={"**/api/v1/room": few}) as it:
        it.page.wait_for_selector("#answer[data-state=done]", timeout=COMPILING)
        job = it.page.get_attribute("#answer", "data-job")
        reply = it.page.request.get(f"{server.address}/api/v1/jobs/{job}").json()
        result = reply["result"]
        assert it.text("#verdict") == result["verdict"]["en"].replace("\u00a0", " ")
        if it.page.is_visible("#all-changes"):
            it.page.click("#all-changes")
        assert it.page.locator("#ranking > li").count() == len(result["options"]) - 1
        assert it.page.locator("#pieces .finding").count() == len(result["options"][0]["pieces"])
        for link in ("report", "table"):
            address = it.page.get_attribute(f"#{link}", "href")
            assert it.page.request.get(address).ok
        assert "mixed" not in it.text("#summary")


def test_the_verdict_comes_bit_by_bit_and_is_stopped(browser: Browser, server: Running) -> None:
    judge = Judge(QUEUED)
    with opened(browser, server, "room/", routes=judge.routes) as it:
        it.wait("() => document.getElementById('state').textContent.includes('2 before you')")
        assert it.text("#verdict") == ""
        judge.stage = ROUGH
        it.page.wait_for_selector("#rough:visible")
        assert "few runs of the room (20)" in it.text("#rough")
        assert "about 80 %" in it.text("#verdict")
        assert it.page.locator("#changes-wait").is_visible()
        assert it.page.locator("#ranking > li").count() == 0
        assert it.page.get_attribute("#report", "aria-disabled") == "true"
        judge.stage = COUNTED  # only changes are still tried
        it.wait("() => document.getElementById('state').textContent.startsWith('The changes')")
        assert not it.page.locator("#rough").is_visible()
        it.page.click("#cancel")
        assert it.text("#state") == "Stopped."
        it.wait("() => !document.getElementById('verify').hidden")
        judge.stage = DONE
        it.page.click("#verify")
        judged(it)
        assert judge.ended[0] == 0
        assert not it.page.locator("#rough").is_visible()
        assert it.page.locator("#ranking > li").count() == 3
        assert it.page.get_attribute("#report", "aria-disabled") == "false"


def test_what_the_verdict_rests_on_is_told(it: Opened, judge: Judge) -> None:
    who = it.text("#who")
    assert "about 80 % (70 to 90 %)" in who
    assert "0 % by day, about 80 % (70 to 90 %) at night" in who
    assert "200 kg" in who
    assert "5.9 m/s, in 10 % of the hits over 6.0 m/s" in who
    assert "1,310 J" in who
    assert "Door: stays blocked\nabout 30 % (20 to 40 %)" in it.text("#ways")
    harm = it.page.locator("#pieces .finding strong").all_inner_texts()
    assert harm == ["Bookcase", "Chest of drawers", "Wardrobe"]
    pieces = it.text("#pieces")
    assert "about 90 % of the harm to people" in pieces
    assert pieces.count("of the harm to people") == 2  # nothing is said of the wardrobe, which hits nobody
    assert it.text("#falls") == "Overturning, hitting nobody: Chest of drawers (about 10 %)."


def test_what_falls_and_what_blocks_the_way_is_told_where_nobody_is_hit(
    browser: Browser, server: Running, monkeypatch: pytest.MonkeyPatch
) -> None:
    verdict = made()
    verdict["pieces"][2]["probabilities"]["overturned"] = chance(0.9)
    verdict["pieces"][2]["falls"] = True
    verdict["shut_in"] = chance(0.7)
    freed = change(
        "wardrobe",
        0.8,
        shut_in=chance(0.0),
        shut_in_change=chance(-0.7),
        helps=True,
        better=["shut_in", "blocked"],
        overturned=chance(0.9),
        overturned_change=chance(0.0),
    )
    belt = change(
        "wardrobe",
        0.8,
        overturned=chance(0.2),
        overturned_change=chance(-0.7),
        helps=True,
        better=["overturned"],
    )
    worse = change("chest", 0.9, worse=["hit"])
    verdict["changes"] = [freed, belt, worse]
    monkeypatch.setattr("room_judge.made", lambda: verdict)
    with room_page(browser, server, Judge(), size=PHONE) as it:
        it.go("understand")
        alone = it.box("#falls")
        assert alone["y"] + alone["height"] < it.box("#steps")["y"]  # on the first screen
        assert (
            it.text("#falls")
            == "Overturning, hitting nobody: Chest of drawers (about 10 %); Wardrobe (about 90 %)."
        )
        assert (
            "somebody is shut in about 70 %, and in under 10 % with this change: wardrobe moved"
            in it.text("#pieces")
        )
        tags = it.page.locator("#ranking .tag").all_inner_texts()
        assert tags == ["way out clearly free more often", "clearly overturns less often", "clearly more hit"]
        bars = it.page.locator("#ranking .barname").all_inner_texts()
        assert bars == ["Somebody is hit"] * 3
        shares = it.page.locator("#ranking .share").all_inner_texts()
        assert [one.replace("\u00a0", " ").split(" (")[0] for one in shares] == [
            "about 80 %",
            "about 80 %",
            "about 90 %",
        ]
        assert "It overturns: about 20 % (10 to 30 %); −80 to −60 points." in it.text("#ranking")


def test_a_room_without_furniture_has_no_chances(it: Opened, judge: Judge) -> None:
    it.page.click("#plan-empty")
    it.page.wait_for_selector("#answer[data-state=empty]")
    assert "Nothing in the room that can fall yet" in it.text("#answer")
    assert "%" not in it.text("#answer")
    assert not it.page.locator("#ranking").is_visible()
    assert "Nothing in the room that can fall yet" in it.text("#see")
    assert it.page.locator("#plan .thing").count() == 0
    assert len(judge.asked) == 1
    room = after(it, judge, lambda: it.page.click("#plan-undo"))
    assert len(room["furniture"]) == 3
    assert it.page.locator(".theatre").is_visible()


def test_what_the_film_shows_is_told_beside_how_often_that_is_so(browser: Browser, server: Running) -> None:
    films = list[dict[str, Any]]()

    def film(route: Route) -> None:
        """Nothing hits anybody, but in the run of the verdict that is proposed, of the fifth earthquake."""
        asked = route.request.post_data_json["scene"]
        sample = route.request.post_data_json.get("sample")
        films.append({**asked, "sample": sample})
        answer = route.fetch()
        reply = answer.json()
        usual = asked["shaking"]["member"] == 5 and sample == 1
        hits = [{"piece": "bookcase", "place": "bed"}] if usual else []
        reply["in_room"] = {"hits": hits, "blocked": [], "shut_in": []}
        route.fulfill(json=reply)

    judge = Judge(QUEUED)
    with opened(browser, server, "room/", routes={**judge.routes, "**/api/v1/simulate": film}) as it:
        assert not it.page.locator("#this-one").is_visible()  # as it is not known how often
        judge.stage = ROUGH
        it.wait("() => !document.getElementById('this-one').hidden")
        assert it.text("#this-one") == "In this one nothing reaches anybody; that is so in about 20 %."
        judge.stage = DONE
        it.wait("() => document.getElementById('this-one').textContent.includes('Bookcase')")
        assert it.text("#this-one") == "In this one somebody is hit (by: Bookcase); that is so in about 80 %."
        assert [one["shaking"]["member"] for one in films] == [3, 5]
        assert len(judge.asked) == 1  # which earthquake is shown changes nothing of the verdict
        assert it.page.locator("#plan-undo").is_disabled()
        which = it.page.get_by_label("Which earthquake").and_(it.page.locator("input[type=number]"))
        which.fill("7")
        which.press("Enter")
        it.wait("() => document.getElementById('this-one').textContent.includes('nothing')")
        assert films[-1]["shaking"]["member"] == 7  # the reader's own choice stays
        assert films[-1]["sample"] is None
        assert len(judge.asked) == 1


def test_the_film_begins_at_its_start_where_it_is_entered(browser: Browser, server: Running) -> None:
    with room_page(browser, server, Judge(), size=PHONE, motion="no-preference") as it:
        it.page.evaluate("document.getElementById('time').value = 900")
        it.page.locator("#time").evaluate("one => one.dispatchEvent(new Event('input'))")
        it.page.evaluate("document.getElementById('play').click()")
        it.go("see")
        it.wait("() => Number(document.getElementById('time').value) < 500")
        assert it.page.get_attribute("#play", "aria-label") == "Pause"


def test_the_filters_of_the_plan_start_from_the_room(it: Opened, judge: Judge) -> None:
    tatami = it.page.get_by_label("The floor is tatami")
    assert not tatami.is_checked()
    floor = it.page.get_by_label("On what floor")
    after(it, judge, lambda: floor.select_option("tatami, along the weave"))
    assert tatami.is_checked()
    assert after(it, judge, tatami.uncheck)["room"]["floor"] == floor.input_value() == "wood flooring"


def test_what_is_ticked_of_the_home_is_set_in_the_rooms_runs(it: Opened, judge: Judge) -> None:
    it.go("understand")
    ticked = [
        ("The floor is tatami", "floor", "tatami, along the weave", "wood flooring"),
        ("plasterboard without studs", "walls", "plasterboard", "stud"),
    ]
    for label, key, on, off in ticked:
        box = it.page.get_by_label(label)
        assert after(it, judge, box.check)["room"][key] == on
        assert after(it, judge, box.uncheck)["room"][key] == off
    room = after(it, judge, it.page.get_by_label("The ceiling is a dropped one").check)["room"]
    assert room["ceiling"] == {"height": 2.4, "construction": "dropped"}


def test_a_change_is_made_and_taken_back(it: Opened, judge: Judge) -> None:
    first = judge.scene
    assert place_of(first, "bookcase") == {"against": "left_wall", "along": 1.9}
    moved = after(it, judge, lambda: it.page.click("#best button"))
    assert place_of(moved, "bookcase") == {"against": "left_wall", "along": 0.4}
    held = after(it, judge, lambda: it.page.click("#ranking > li:nth-child(2) button"))
    assert held["furniture"][0]["measures"] == [{"type": "belt"}]
    turned = after(it, judge, lambda: it.page.click("#ranking > li:nth-child(3) button"))
    assert (turned["places"][0]["at"], turned["places"][0]["heading"]) == ([1.6, 1.26], 0)
    for room in (held, moved, first):  # one entry each
        assert after(it, judge, lambda: it.page.click("#plan-undo")) == room


def test_where_nothing_may_be_drilled_no_change_asks_for_it(it: Opened, judge: Judge) -> None:
    rows = it.page.locator("#ranking > li")
    (best,) = (one for one in made()["changes"] if one["measures"] == [{"type": "belt"}])
    drilled, all_of_them = best["label"]["en"], rows.count()
    assert drilled in " ".join(rows.all_inner_texts()).lower()
    it.page.get_by_label("No drilling (rented)").check()
    assert rows.count() == all_of_them - 1
    assert drilled not in " ".join(rows.all_inner_texts()).lower()


def test_the_old_verdict_is_marked_and_its_question_ends(it: Opened, judge: Judge) -> None:
    judge.stage = ROUGH
    it.page.click("#best button")
    it.wait("() => document.getElementById('answer').dataset.old === 'true'")
    assert it.page.locator("#answer .stale").is_visible()
    assert it.page.locator("#understand > .stale").is_visible()
    assert it.page.locator("#plan.old").count() == 1
    assert it.page.get_attribute("#report", "aria-disabled") == "true"
    it.page.wait_for_selector("#rough:visible")  # the second question is at work
    it.page.click("#plan-undo")
    it.wait("() => document.getElementById('answer').dataset.old === 'true'")
    judge.stage = DONE
    judged(it)
    assert len(judge.asked) == 3
    assert {0, 1} <= set(judge.ended)


def test_the_fields_are_the_rooms(it: Opened, judge: Judge) -> None:
    room = after(it, judge, it.page.get_by_label("6-lower", exact=True).check)
    assert room["shaking"]["intensity"] == 5.75
    known = it.page.locator("#entry select").first
    room = after(it, judge, lambda: known.select_option("pgv"))
    assert "pgv" in room["shaking"]
    assert "intensity" not in room["shaking"]
    room = after(it, judge, lambda: it.page.get_by_label("Kind of earthquake").select_option(index=1))
    assert room["shaking"]["suite"]["family"] != "mixed"
    assert room["shaking"]["suite"]["count"] == 20  # as it was
    room = after(it, judge, it.page.get_by_label("In a building").check)
    assert room["shaking"]["building"]["storeys"] == 10
    room = after(it, judge, lambda: it.page.get_by_label("On what floor").select_option(index=2))
    assert room["room"]["floor"] != "wood flooring"
    walls = it.page.get_by_label("What the wall offers to fix things to")
    room = after(it, judge, lambda: walls.select_option("plasterboard"))
    assert room["room"]["walls"] == "plasterboard"
    room = after(it, judge, it.page.get_by_label("There is a ceiling").uncheck)
    assert "ceiling" not in room["room"]
    room = after(it, judge, lambda: it.page.select_option("#precision", "0.25"))
    assert room["uncertainty"] == {"precision": 0.25}
    room = after(it, judge, lambda: it.page.click("#plan-undo"))
    assert it.page.input_value("#precision") == ""
    after(it, judge, lambda: it.page.click("#plan-undo"))
    assert it.page.get_by_label("There is a ceiling").is_checked()


def test_the_room_is_shaken_in_space(it: Opened, judge: Judge) -> None:
    fates = it.page.locator("#fates li").all_inner_texts()
    assert [one.split(":")[0] for one in fates] == ["Bookcase", "Wardrobe", "Chest of drawers"]
    assert it.page.get_attribute("#space", "aria-label")
    before = float(it.page.input_value("#time"))
    it.page.focus("#time")
    it.page.keyboard.press("End")
    assert float(it.page.input_value("#time")) > before
    it.page.click("#play")
    it.wait("() => document.getElementById('play').ariaLabel === 'Pause'")
    it.page.click("#play")
    with it.page.expect_response("**/api/v1/simulate"):
        it.page.click("#best button")
        it.wait("() => document.getElementById('see').dataset.old === 'true'")
    it.wait("() => document.getElementById('see').dataset.old === 'false'")


def test_links_loading_again_and_back_keep_the_room(browser: Browser, server: Running) -> None:
    judge = Judge()
    with room_page(browser, server, judge) as it:
        first = judge.scene
        it.wait("() => location.hash.startsWith('#room=')")
        before = it.page.evaluate("location.hash")
        it.page.evaluate("(now => { performance.now = () => now; })(performance.now() + 1e4)")
        moved = after(it, judge, lambda: it.page.click("#best button"))
        it.wait("before => location.hash !== before", before)
        link = it.page.evaluate("location.href")
        it.wait("() => document.getElementById('address').value === location.href")
        it.page.reload()
        it.settle()
        judged(it)
        assert judge.scene == moved
        assert after(it, judge, it.page.go_back) == first
        assert after(it, judge, it.page.go_forward) == moved
    with room_page(browser, server, judge, "#" + link.split("#")[1]):
        assert judge.scene == moved
    with room_page(browser, server, judge, link.split("/room/")[1][:-9]) as it:
        assert "damaged" in it.text("#notices")
        assert judge.scene == first  # the one that the server proposes


def test_files_are_opened_and_saved(browser: Browser, server: Running) -> None:
    judge = Judge()
    with room_page(browser, server, judge, allowed=("status of 422",)) as it:
        with it.page.expect_download() as found:
            it.page.click("#toml")
        kept = tomllib.loads(Path(found.value.path()).read_text("utf-8"))
        assert kept["furniture"] == judge.scene["furniture"]
        after(it, judge, lambda: it.page.click("#best button"))
        it.page.set_input_files("#open", EXAMPLES / "bedroom.toml")
        it.wait("() => document.getElementById('kept').textContent.includes('bedroom.toml')")
        judged(it)
        assert place_of(judge.scene, "bookcase")["along"] == 1.9
        it.page.set_input_files("#file", EXAMPLES / "bookcase.toml")
        it.wait("() => document.getElementById('uploaded').textContent.includes('no plan of a room')")
        it.page.set_input_files("#open", {"name": "a.toml", "mimeType": "", "buffer": b"plan = 3"})
        it.wait("() => document.getElementById('kept').textContent.includes('cannot be used')")


def test_the_page_goes_on_when_the_server_is_back(browser: Browser, server: Running) -> None:
    judge = Judge()
    with room_page(browser, server, judge, allowed=("Failed to load",)) as it:
        it.page.route("**/api/v1/**", lambda route: route.abort())
        it.page.click("#best button")
        it.page.wait_for_selector("#away:visible")
        assert it.page.get_attribute("#answer", "data-old") == "true"
        assert it.page.get_attribute("#see", "data-old") == "true"
        assert it.text("#state") == "The server does not answer; waiting for it."
        it.page.unroute("**/api/v1/**")  # nobody clicks
        judged(it)
        it.wait("() => document.getElementById('see').dataset.old === 'false'")
        assert not it.page.locator("#away").is_visible()
        assert place_of(judge.scene, "bookcase")["along"] == 0.4


def test_what_the_server_refuses_is_said(browser: Browser, server: Running) -> None:
    judge = Judge()
    with room_page(browser, server, judge, allowed=("status of 422",)) as it:
        sentence = {
            "message": "It must stand beside it.",
            "message_ja": None,
            "field": "scene.furniture[1].at",
        }
        it.page.route("**/api/v1/room", lambda route: route.fulfill(status=422, json=sentence))
        it.page.click("#best button")
        it.page.wait_for_selector("#answer[data-state=refused]")
        assert "It must stand beside it." in it.text("#verdict")
        assert "It must stand beside it." in it.text("#plan-problems")
        assert it.page.locator("#plan-problems").is_visible()  # at the thing
        assert it.page.locator("#answer .stale").is_hidden()  # the refusal is of the room as it is
        assert it.text("#understand > .stale") == "From the scene before."
        general = {**sentence, "field": "scene.shaking"}
        it.page.route("**/api/v1/room", lambda route: route.fulfill(status=422, json=general))
        it.page.route("**/api/v1/simulate", lambda route: route.fulfill(status=422, json=general))
        it.page.click("#plan-undo")
        it.wait("() => document.getElementById('problem').textContent.includes('beside it.')")
        it.wait("() => document.getElementById('plan-problems').classList.contains('general')")
        said = it.page.get_by_text("It must stand beside it.").locator("visible=true")
        assert said.count() == 1  # in the verdict
        it.page.set_viewport_size(PHONE)  # where the verdict is on other screens
        assert it.page.locator("#plan-problems").is_visible()
        it.page.set_viewport_size(DESK)
        it.page.click("#plan-redo")
        for pattern in ("room", "simulate"):
            it.page.unroute(f"**/api/v1/{pattern}")
        for pattern, answer in judge.routes.items():
            it.page.route(pattern, answer)
        after(it, judge, lambda: it.page.click("#plan-undo"))
        assert "about 80 %" in it.text("#verdict")
        assert it.text("#plan-problems") == ""


def test_both_pages_lead_to_each_other(it: Opened, judge: Judge) -> None:
    moved = after(it, judge, lambda: it.page.click("#best button"))
    it.wait("() => sessionStorage.getItem('stayput-room')?.includes('0.4')")
    it.page.click("header .elsewhere")
    it.page.wait_for_selector("#presets button")
    it.page.click("header .elsewhere")
    it.page.wait_for_selector("#plan .thing")
    judged(it)
    assert judge.scene == moved  # the room that this tab had


def test_the_language_is_switched_with_everything(it: Opened, judge: Judge) -> None:
    it.page.click("#languages [lang=ja]")
    it.wait("() => document.getElementById('ranking').textContent.includes('人に当たる確率')")
    assert it.page.title() == "stayput：地震のとき、この部屋にいる人は安全か"
    assert it.text("#verdict") == "「本棚」がベッドにいる人に当たります。"
    assert "「本棚」をベルトで固定" in it.text("#ranking")
    assert len(judge.asked) == 1  # nothing is worked out again
