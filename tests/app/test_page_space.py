"""The page in Chromium: a piece in space, and files of several pieces."""

from __future__ import annotations

import io
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from browsing import COMPILING, opened
from PIL import Image
from playwright.sync_api import expect
from test_space_in_browser import coloured, differ

from stayput.model.body import FURNITURE
from stayput.scenario import Scenario

if TYPE_CHECKING:
    from browsing import Opened
    from playwright.sync_api import Browser, FilePayload, Route
    from serving import Running

LINK = "#piece=refrigerator&width=0.6&length=0.7&height=1.8&mass=100&inSpace=1&wall=1&gap=0.05&member=3"
BELTED = LINK + "&measures=belt"
PIECES = """
[[furniture]]
name = "lower part"
width = 0.45
length = 0.9
height = 0.9
mass = 60.0
[[furniture]]
name = "upper part"
width = 0.35
length = 0.9
height = 1.0
mass = 40.0
on = "lower part"
[shaking]
sine = { amplitude = 6.0, frequency = 1.0, duration = 4.0 }
"""


def scenario_file(text: str | bytes, name: str = "dresser.toml") -> FilePayload:
    content = text if isinstance(text, bytes) else text.encode()
    return {"name": name, "mimeType": "application/toml", "buffer": content}


def drop(it: Opened, text: str) -> None:
    """Give the page a scenario file of several pieces and wait until they are drawn."""
    it.page.set_input_files("#file", scenario_file(text))
    it.page.wait_for_selector("#pieces:not([hidden])", state="attached")
    it.settle()


def picture(it: Opened, which: str = "without") -> np.ndarray[Any, Any]:
    it.draw()
    it.draw()
    taken = it.page.locator(f"#stage-{which}").screenshot()
    return np.asarray(Image.open(io.BytesIO(taken)).convert("RGB")).astype(int)


def test_space_is_the_default_and_the_plane_is_chosen_kept_and_taken_back(
    browser: Browser, server: Running
) -> None:
    with opened(browser, server) as it:
        assert it.page.locator("#engine input[value=space]").is_checked()
        assert it.page.locator("#in-plane-note").is_hidden()
        assert it.page.get_by_label("Corner", exact=True).is_checked()
        asked, answer = it.simulated(lambda: it.page.check("#engine input[value=plane]"))
        assert (asked["scene"]["dimensions"], answer["engine"]) == (2, "plane")
        assert it.page.locator("#in-plane-note").is_visible()
        assert it.page.get_by_label("Side", exact=True).is_checked()
        it.kept("inSpace=0")
        asked, answer = it.simulated(lambda: it.page.go_back())
        assert "dimensions" not in asked["scene"]
        assert answer["engine"] == "space"
        it.simulated(lambda: it.page.go_forward())
        it.page.reload()
        it.settle()
        assert it.page.locator("#engine input[value=plane]").is_checked()
        it.simulated(lambda: it.page.check("#engine input[value=space]"))
        assert it.page.locator("#in-plane-note").is_hidden()
        assert not any(url.endswith(".wasm") for url in it.asked)


def test_the_length_of_a_piece_is_its_presets_until_it_is_set(browser: Browser, server: Running) -> None:
    with opened(browser, server) as it:
        asked, _ = it.simulated(lambda: it.page.click("#presets button:has-text('Refrigerator')"))
        assert asked["scene"]["furniture"]["length"] == (own := FURNITURE["refrigerator"].length)
        field = it.page.get_by_label("Length, from side to side (cm)")
        asked, _ = it.simulated(lambda: field.fill("95"))
        assert asked["scene"]["furniture"]["length"] == 0.95
        it.kept("length=0.95")
    with opened(browser, server, "#piece=refrigerator&width=0.6&height=1.7&mass=90") as it:
        asked, _ = it.simulated(lambda: it.page.get_by_label("Mass with its content (kg)").fill("95"))
        assert asked["scene"]["furniture"]["length"] == own  # of a link that names none


def test_the_pictures_follow_the_slider_the_views_and_the_keys(webgl: Browser, server: Running) -> None:
    with opened(webgl, server, BELTED) as it:
        assert it.page.locator("#flat").is_hidden()
        it.page.locator("#time").fill("0")
        first = picture(it)
        assert it.text("#now-without").startswith("stays put")
        assert max(coloured(first)) < 0.005
        it.page.locator("#time").fill("450")
        later = picture(it)
        assert it.text("#now-without").startswith("moves")
        assert coloured(later)[0] > 0.02
        assert differ(first, later) > 0.005
        beside = picture(it, "with")
        it.page.get_by_label("Top", exact=True).check()
        assert differ(picture(it), later) > 0.02
        assert differ(picture(it, "with"), beside) > 0.02  # both are seen from one side
        it.page.locator("#stage-without").focus()
        above = picture(it)
        it.page.keyboard.press("ArrowDown")
        assert differ(picture(it), above) > 0.01
        assert not it.page.get_by_label("Top", exact=True).is_checked()


SHOWN = """given => Promise.all([import("/canvas/digits.js"), import("/words.js")]).then(
  ([{ digits }, { number }]) => given.map((one) => [digits(one, 1), number(one, 1)]))"""


def test_a_picture_without_webgl_is_flat_and_led_by_the_wheel(browser: Browser, server: Running) -> None:
    with opened(browser, server, LINK + "&contents=books&doors=none") as it:
        assert "has no WebGL 2" in it.text("#flat")
        assert coloured(picture(it))[0] > 0.02
        it.page.locator("#stage-without").scroll_into_view_if_needed()
        box = it.box("#stage-without")
        it.page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        seen, before = picture(it), it.page.evaluate("() => scrollY")
        it.page.mouse.wheel(0, 60)
        it.wait("before => scrollY > before", before)
        it.page.mouse.wheel(0, -60)
        it.wait("before => scrollY === before", before)
        assert differ(picture(it), seen) < 0.01
        it.page.keyboard.down("Control")
        it.page.mouse.wheel(0, -300)
        it.page.keyboard.up("Control")
        assert coloured(picture(it))[0] > 1.1 * coloured(seen)[0]
        it.page.get_by_label("Top", exact=True).check()
        seen = picture(it)
        it.simulated(lambda: it.page.get_by_label("Mass with its content (kg)").fill("120"))
        assert differ(picture(it), seen) < 0.05  # a new scene is seen from where the one before was
        it.page.get_by_label("Front", exact=True).check()
        assert differ(picture(it), seen) > 0.1
        shown = it.page.evaluate(SHOWN, [-0.0, -0.04, -0.05, 0.04, -1.25, 12.345])  # none is a negative zero
        assert [one for one, _ in shown] == ["0.0", "0.0", "−0.1", "0.0", "−1.3", "12.3"]
        assert [one for _, one in shown] == ["0.0", "0.0", "-0.1", "0.0", "-1.3", "12.3"]
        contents = it.page.get_by_label("What may come out")
        asked, _ = it.simulated(lambda: contents.select_option("dishes"))
        assert "dimensions" not in asked["scene"]
        assert asked["scene"]["contents"] == {"kind": "dishes", "doors": "none"}
        asked, _ = it.simulated(lambda: it.page.check("#engine input[value=plane]"))
        assert asked["scene"]["contents"] == {"kind": "dishes", "doors": "none"}
        assert it.page.locator("#flat").is_visible()  # the plane is drawn in space too


def test_histories_and_sentences_are_those_of_space(browser: Browser, server: Running) -> None:
    with opened(browser, server, BELTED) as it:
        it.page.locator("#time").fill("1000")
        it.draw()
        assert "turned" in it.text("#now-without")
        assert "The refrigerator" in it.text("#says-without")
        assert "Turned by" in it.text("#story")
        assert "Belts, left" in it.text("#device-key")
        height = it.page.locator("#histories").evaluate("one => one.clientHeight")
        it.simulated(lambda: it.page.check("#engine input[value=plane]"))
        assert height > it.page.locator("#histories").evaluate("one => one.clientHeight")


def test_chances_in_space_come_with_their_curves(browser: Browser, server: Running) -> None:
    with opened(browser, server, BELTED, verify=True) as it:
        it.page.wait_for_selector("#understand[data-state=done]", timeout=COMPILING)
        assert "Simulated in space" in it.text("#also")
        assert it.page.locator("#ranking li").count() > 4
        it.speak("ja")
        assert "三次元で" in it.text("#also")
        assert it.page.locator("#fragility .curve.c1").count() >= 1


def test_the_scene_and_its_films_can_be_kept(browser: Browser, server: Running) -> None:
    with opened(browser, server, LINK) as it:
        with it.page.expect_download() as found:
            it.page.click("#toml")
        scenario = Scenario.parse(tomllib.loads(Path(found.value.path()).read_text(encoding="utf-8")))
        assert scenario.dimensions == 3
        assert scenario.piece.length == 0.7
        assert it.page.locator("#html-with").is_disabled()
        with it.page.expect_download() as found:
            it.page.click("#html-without")
        assert found.value.suggested_filename == "run_without.html"
        assert "webgl2" in Path(found.value.path()).read_text(encoding="utf-8")


def test_a_film_that_is_being_drawn_says_so_and_so_does_one_that_failed(
    browser: Browser, server: Running
) -> None:
    with opened(browser, server, LINK, allowed=("status of 503",)) as it:
        held: list[Route] = []
        it.page.route("**/simulate/film*", lambda route: held.append(route))
        button, other = it.page.locator("#film-without"), it.page.locator("#html-without")
        it.go("keep")
        button.click()
        expect(button).to_have_text("Drawing …")
        expect(button).to_be_disabled()
        expect(other).to_be_enabled()
        it.speak("ja")
        expect(button).to_have_text("作成中…")
        it.speak("en")
        held.pop().fulfill(status=503, json={"message": "busy", "message_ja": "busy", "field": None})
        expect(button).to_contain_text("Animation without measures, 10 s")
        expect(button).to_be_enabled()
        expect(it.page.locator("#kept")).to_contain_text("busy")
        with it.page.expect_download():
            button.click()
            expect(button).to_have_text("Drawing …")
            held.pop().fulfill(body=b"GIF89a", content_type="image/gif")
        expect(button).to_be_enabled()
        assert it.text("#kept") == ""


def test_a_file_of_several_pieces_is_shown_until_the_scene_changes(it: Opened) -> None:
    drop(it, PIECES)
    assert "lower part" in it.text("#pieces")
    assert "The pieces in “dresser.toml”" in it.text("#pieces")
    assert it.page.locator("#figure-with").is_hidden()
    it.page.locator("#time").fill("500")
    assert min(coloured(picture(it))) > 0.01  # of the two, what moves and what falls
    assert "upper part: " in it.text("#story")
    assert it.text("#pieces-key").split("\n") == ["lower part", "upper part"]
    assert it.box("#stage-without")["y"] < it.box("#pieces")["y"]  # a long list does not push it away
    with it.page.expect_download() as found:
        it.page.click("#toml")
    assert found.value.suggested_filename == "dresser.toml"
    assert Path(found.value.path()).read_text(encoding="utf-8") == PIECES
    it.page.wait_for_selector("#understand[data-state=pieces]")
    assert "for one piece" in it.text("#state")
    it.speak("ja")
    assert "「dresser.toml」の家具" in it.text("#pieces")
    with it.page.expect_download() as found:
        it.page.click("#csv-without")
    assert "upper part" in Path(found.value.path()).read_text(encoding="utf-8")
    asked, _ = it.simulated(lambda: it.page.click("#pieces button"))
    assert asked["scene"]["furniture"]["preset"] == "bookcase"
    assert it.page.locator("#pieces").is_hidden()
    drop(it, PIECES)
    asked, _ = it.simulated(lambda: it.page.click("#presets button >> nth=2"))
    assert asked["scene"]["furniture"]["preset"] == "wardrobe"
    assert it.page.locator("#pieces").is_hidden()


def test_a_verdict_that_the_server_refuses_of_a_file_says_why(browser: Browser, server: Running) -> None:
    drum = "[furniture]\ndiameter = 0.5\nheight = 1.6\nmass = 250.0\n[shaking]\nsuite = { count = 2 }\n"
    with opened(browser, server, verify=True, allowed=("status of 422",)) as it:
        drop(it, drum)
        it.page.wait_for_selector("#understand[data-state=refused]")
        assert "one preset or box written as [furniture]" in it.page.locator("#verdict").inner_text()
        assert it.page.locator("#verdict").is_visible()


def test_a_file_of_several_pieces_is_kept_by_reload_link_and_history(
    browser: Browser, server: Running
) -> None:
    with opened(browser, server, LINK) as it:
        drop(it, PIECES)
        it.kept("file=dresser.toml", "piece=refrigerator", "length=0.7")
        link = it.page.input_value("#address")
        it.page.reload()
        it.settle()
        assert "The pieces in “dresser.toml”" in it.text("#pieces")
        assert it.page.locator("#says-without").inner_text() != ""
        it.simulated(lambda: it.page.click("#pieces button"))
        assert it.page.locator("#pieces").is_hidden()
        it.wait("() => !location.hash.includes('pieces=')")
        it.page.go_back()
        it.page.wait_for_selector("#pieces:not([hidden])", state="attached")
        it.page.go_back()
        it.page.wait_for_selector("#pieces", state="hidden")
        assert it.page.locator("#sizes input").first.is_visible()
        it.page.go_forward()
        it.page.wait_for_selector("#pieces:not([hidden])", state="attached")
        it.wait(f"() => document.querySelector('#address').value === {link!r}")
    with opened(browser, server, link.partition("/#")[2].join(["#", ""])) as it:
        assert "upper part: " in it.text("#story")
        asked, _ = it.simulated(lambda: it.page.click("#pieces button"))
        assert asked["scene"]["furniture"]["preset"] == "refrigerator"


def test_a_file_too_long_for_a_link_says_so(browser: Browser, server: Running) -> None:
    noise = "".join(np.random.default_rng(1).choice(list("abcdefghijklmnopqrstuvwxyz0123456789"), 20_000))
    with opened(browser, server) as it:
        drop(it, f"{PIECES}# {noise}\n")
        it.go("keep")
        it.page.wait_for_selector("#link-long:text('too large for a link')")
        assert it.page.locator("#address").is_hidden()
        assert "pieces=" not in it.page.url
        it.simulated(lambda: it.page.locator("#pieces button").dispatch_event("click"))
        it.page.wait_for_selector("#address", state="visible")


def test_links_whose_pieces_cannot_be_shown_say_why(browser: Browser, server: Running) -> None:
    link = f"{LINK}&file=a.toml&pieces="
    with opened(browser, server, f"{link}AAAA", allowed=("status of 422",)) as it:
        assert "The link is damaged: it does not hold all of the file “a.toml”" in it.text("#notices")
        it.page.click("#notices button")
        it.page.wait_for_selector("#notices", state="hidden")
        it.page.evaluate("link => { location.hash = link }", f"{link}y0jNyclXKM8vyklRBAA")
        it.page.locator("#notices", has_text="The scenario file is 'a.toml'; it must be TOML").wait_for()
        assert it.page.locator("#pieces").is_hidden()


ONE = '[furniture]\npreset = "chest"'
INSIDE = PIECES.replace('on = "lower part"', "at = [0.1, 0.0]")
WRONG = {
    "one piece": (ONE, "This scenario has one piece"),
    "one piece, wrong": (ONE.replace("chest", "ches"), "did you mean 'chest'?"),
    "no TOML": ("[furniture", "'wrong.toml'"),
    "no text": (b"\xff\xfe[", "not text in UTF-8"),
    "a mesh": ('[[furniture]]\nname = "stone"\nmesh = "a.stl"\nunit = "m"\nmass = 3.0', "stone"),
    "a record": (f'{ONE}\n[shaking]\nrecord = "knet.EW"', "it names a record's file"),
    "inside each other": (INSIDE, "inside each other; they must begin apart"),
}
"""Files that are not shown, and what of that is said."""


def test_files_that_are_not_shown_say_why_and_change_nothing(browser: Browser, server: Running) -> None:
    with opened(browser, server, LINK, allowed=("status of 422",)) as it:
        drop(it, PIECES)
        it.kept("file=dresser.toml")
        address, seen, story = it.page.url, picture(it), it.text("#story")
        for text, said in WRONG.values():
            it.page.set_input_files("#file", scenario_file(text, "wrong.toml"))
            it.page.wait_for_selector(f'#uploaded .refusal:has-text("{said}")')
            assert it.page.locator("#problem").is_hidden()
        assert it.page.url == address
        assert it.text("#story") == story
        assert differ(picture(it), seen) == 0.0
        assert it.page.locator("#pieces").is_visible()
