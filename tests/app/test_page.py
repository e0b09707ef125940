"""The page in Chromium: the scene is set, and what is sent and seen follows."""

from __future__ import annotations

import json
import re
from typing import TYPE_CHECKING

import pytest
from browsing import Opened, opened

import stayput as sp
from long_cases import long

if TYPE_CHECKING:
    from pathlib import Path

    from playwright.sync_api import Browser, Page
    from serving import Running

DRAWN = """canvas => {
  const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  return new Set(new Uint32Array(pixels.buffer)).size;
}"""


def pictures(page: Page) -> list[str]:
    return page.eval_on_selector_all("canvas.stage", "all => all.map(canvas => canvas.toDataURL())")


def test_the_first_picture_is_there_without_a_click_and_still_where_that_is_wanted(it: Opened) -> None:
    for stage in ("#stage-without", "#stage-with"):
        assert it.page.eval_on_selector(stage, DRAWN) > 10
    assert "overturned" in it.text("#says-without")
    assert "stayed upright" in it.text("#says-with")
    first = it.page.input_value("#time")
    it.page.wait_for_timeout(300)
    assert it.page.input_value("#time") == first
    assert float(first) > 0  # of the moment that says most
    it.page.click("#play")
    it.wait("first => document.getElementById('time').value !== first", first)


def test_every_piece_is_drawn_and_simulated_at_its_size(it: Opened, server: Running) -> None:
    presets = it.page.request.get(f"{server.address}/api/v1/presets").json()["furniture"]
    seen = set()
    for preset in reversed(presets):
        asked, answer = it.simulated(
            lambda preset=preset: it.page.click(f"#presets button:has-text('{preset['label']['en']}')")
        )
        assert asked["scene"]["furniture"]["preset"] == preset["id"]
        (body,) = answer["without"]["scene"]["bodies"]
        across = [corner[0] for corner in body["shape"]["vertices_m"]]
        assert max(across) - min(across) == pytest.approx(preset["width_m"])
        assert it.page.locator("#presets [aria-pressed=true]").count() == 1
        seen.add(it.page.eval_on_selector("#stage-without", "canvas => canvas.toDataURL()"))
    sizes = {(preset["width_m"], preset["length_m"], preset["height_m"]) for preset in presets}
    assert len(seen) == len(sizes)  # a full and an empty bookcase are one outline


def test_the_load_of_the_shelves_moves_the_centre_of_gravity(it: Opened) -> None:
    for button, compare in (("Heavy at the bottom", float.__lt__), ("Heavy at the top", float.__gt__)):
        _, answer = it.simulated(lambda button=button: it.page.click(f"text={button}"))
        up = answer["without"]["scene"]["bodies"][0]["centre_of_gravity_m"][2]
        assert compare(up, 0.9)
        shown = re.search(r"G is (.+?) above", it.text("#balance"))
        assert shown is not None
        value, unit = shown[1].split()
        assert float(value) * (1.0 if unit == "m" else 0.01) == pytest.approx(up, abs=0.006)
    it.page.click("#sizes summary")
    asked, _ = it.simulated(lambda: it.page.get_by_label("Shelf 1 from the bottom (kg)").fill("70"))
    assert asked["scene"]["furniture"]["shelves"][0] == 70


def test_floor_wall_and_building(it: Opened) -> None:
    asked, _ = it.simulated(lambda: it.page.get_by_label("On what floor").select_option("carpet"))
    assert asked["scene"]["room"]["floor"] == "carpet"
    asked, _ = it.simulated(lambda: it.page.get_by_label("Gap to the wall (cm)").fill("10"))
    assert asked["scene"]["room"]["left_wall"]["gap"] == pytest.approx(0.1)
    asked, answer = it.simulated(lambda: it.page.get_by_label("There is a wall behind it").uncheck())
    assert "left_wall" not in asked["scene"]["room"]
    assert asked["measures"] == []  # the bracket has nothing to hold to, and the page says so
    assert answer["with"] is None
    why = it.page.locator("#measures .why:visible").first.inner_text()
    assert why == "Left out for now. This needs a wall behind the piece."
    asked, answer = it.simulated(lambda: it.page.get_by_label("In a building").check())
    asked, answer = it.simulated(lambda: it.page.get_by_role("slider", name="On storey").fill("9"))
    assert asked["scene"]["shaking"]["storey"] == 9
    assert answer["building"]["storey"] == 9
    assert it.page.eval_on_selector("#tower", DRAWN) > 3
    assert "storey 9 of 10" in it.text("#summary")


def test_the_intensity_says_what_it_does(it: Opened, server: Running) -> None:
    classes = it.page.request.get(f"{server.address}/api/v1/presets").json()["intensities"]
    asked, answer = it.simulated(lambda: it.page.get_by_label("5-upper", exact=True).check())
    wanted = next(one for one in classes if one["id"] == "5-upper")
    assert asked["scene"]["shaking"]["intensity"] == wanted["middle"]
    assert answer["motion"]["ground_class"] == "5-upper"
    assert it.text("#meaning") == f"{wanted['about']['en']} {wanted['furniture']['en']}"


def test_measures_several_at_once_one_in_a_place(it: Opened) -> None:
    it.simulated(lambda: it.page.get_by_label("Belts").check())
    asked, answer = it.simulated(lambda: it.page.get_by_label("Felt glides").check())
    assert [one["type"] for one in asked["measures"]] == ["l_bracket", "belt", "felt_glides"]
    assert {one["kind"] for one in answer["with"]["devices"]} == {"l_bracket", "belt"}
    asked, _ = it.simulated(lambda: it.page.get_by_label("Anti-slip sheet").check())
    assert [one["type"] for one in asked["measures"]] == ["l_bracket", "belt", "anti_slip_sheet"]
    assert not it.page.get_by_label("Felt glides").is_checked()
    it.page.locator(".measure", has=it.page.get_by_label("Screwed L-brackets")).locator("summary").click()
    weak = lambda: it.page.get_by_label("strength of one (N)").fill("30")  # noqa: E731
    asked, answer = it.simulated(weak)
    assert asked["measures"][0] == {"type": "l_bracket", "strength": 30}
    assert answer["with"]["devices"][0]["failed"]
    assert "Screwed L-brackets: fails" in it.text("#story")


PACE = """milliseconds => new Promise(done => {
  const time = document.getElementById("time"), start = Number(time.value);
  let passed = 0, last = null;
  requestAnimationFrame(function tick(stamp) {
    if (last !== null) passed += Math.min(250, stamp - last); // the clock leaves out what is longer
    last = stamp;
    if (passed < milliseconds) requestAnimationFrame(tick);
    else done((Number(time.value) - start) / passed);
  });
})"""
"""How fast the slider of the time moves, by the time of the frames that are drawn."""


def test_the_animation_plays_pauses_and_is_scrubbed(browser: Browser, server: Running) -> None:
    with opened(browser, server, motion="no-preference") as it:
        value = lambda: float(it.page.input_value("#time"))  # noqa: E731
        it.wait("first => Number(document.getElementById('time').value) !== first", value())  # by itself
        it.page.click("#play")
        it.draw()
        still = value()
        it.page.wait_for_timeout(200)
        assert value() == still
        it.page.fill("#time", "300")
        it.draw()
        early = pictures(it.page)
        it.page.fill("#time", "800")
        it.draw()
        assert pictures(it.page) != early
        seen = []
        for speed in ("1", "0.1"):
            it.page.select_option("#speed", speed)
            it.page.fill("#time", "300")
            it.page.click("#play")
            seen.append(it.page.evaluate(PACE, 600))
            it.page.click("#play")
        assert 0.0 < seen[1] < 0.2 * seen[0]
        it.page.locator("#story .jump").last.click()
        it.draw()
        jumped = value()
        it.page.locator("#histories").click(position={"x": 300, "y": 60})
        it.draw()
        assert value() != jumped


COLOURED = """() => {
  const canvas = document.querySelector("#histories"), ratio = canvas.width / canvas.clientWidth;
  const { data, width } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  const isAlarm = (at) => data[at] > 180 && data[at + 1] < 120 && data[at + 2] < 40;
  const count = (panel, from, to) => {
    let found = 0;
    for (let y = Math.ceil((118 * panel + 40) * ratio); y < (118 * panel + 112) * ratio; y++)
      for (let x = Math.ceil(from * width); x < to * width; x++) found += isAlarm(4 * (y * width + x));
    return found;
  };
  return [1, 2].flatMap((panel) => [count(panel, 0.1, 0.9), count(panel, 0.9, 0.98)]);
}"""
"""Pixels of tilt and slide in the colour of the run without measures, before the last tenth and within it."""


def test_histories_are_grey_after_a_fall(browser: Browser, server: Running) -> None:
    with opened(browser, server) as it:
        _, answer = it.simulated(lambda: it.page.get_by_label("Gap to the wall (cm)").fill("7.5"))
        assert answer["without"]["overturned"]
        it.page.fill("#time", "0")
        it.draw()
        tilts, tilts_late, slides, slides_late = it.page.evaluate(COLOURED)
        assert min(tilts, slides) > 50
        assert max(tilts_late, slides_late) == 0


def test_a_link_shows_the_scene_again(browser: Browser, server: Running) -> None:
    with opened(browser, server) as it:
        it.simulated(lambda: it.page.click("#presets button:has-text('Wardrobe')"))
        it.simulated(lambda: it.page.get_by_label("In a building").check())
        it.simulated(lambda: it.page.get_by_label("Belts").check())
        asked, _ = it.simulated(lambda: it.page.get_by_label("Gap to the wall (cm)").fill("7.5"))
        it.kept("gap=0.075")
        address = it.page.input_value("#address")
    asked_again = {}
    with opened(browser, server) as it:
        it.page.on(
            "request", lambda one: one.url.endswith("/simulate") and asked_again.update(one.post_data_json)
        )
        it.page.goto("about:blank")
        it.page.goto(address)
        it.settle()
        it.asked.remove("about:blank") if "about:blank" in it.asked else None
    assert asked_again == asked


def test_a_wild_link_is_harmless(browser: Browser, server: Running) -> None:
    wild = (
        "#piece=<script>alert(1)</script>&floor=../../etc/passwd&width=NaN&height=1e99&shelves=1,x&storeys=-3"
        "&measures=nothing,belt;a:b,gel_mats,wedge_stopper"
    )
    with opened(browser, server, wild, allowed=("422",)) as it:
        assert it.page.locator("#presets [aria-pressed=true]").count() == 1
        assert it.page.locator("#problem").is_visible() or it.text("#says-without")


def test_what_is_refused_is_said_in_the_reader_s_language(browser: Browser, server: Running) -> None:
    def shown(it: Opened, what: str) -> str:
        text = it.text(what)
        assert not re.search("[A-Za-z]{3,}", re.sub("「.*?」|SAC|miniSEED", "", text)), (
            text
        )  # names stand between 「 and 」
        return text

    with opened(browser, server, language="ja", allowed=("422", "Failed to load")) as it:
        it.simulated(lambda: it.page.get_by_label("壁とのすき間 (cm)").fill("40"))
        assert "0～0.15 mに" in shown(it, "#problem")
        it.speak("en")
        assert "it must be between 0 and 0.15 m" in it.text("#problem")
        it.simulated(lambda: it.page.get_by_label("Gap to the wall (cm)").fill("4"))
        assert not it.page.locator("#problem").is_visible()
        it.simulated(lambda: it.page.get_by_label("Gap to the wall (cm)").fill("40"))
        it.speak("ja")
        assert "0～0.15 mに" in shown(it, "#problem")
        send = lambda data: it.page.set_input_files(  # noqa: E731
            "#file", {"name": "1.txt", "mimeType": "text/plain", "buffer": data}
        )
        send(b"\x00")
        it.page.wait_for_selector("#uploaded [role=alert]")
        assert "テキスト" in shown(it, "#uploaded")
        assert it.page.locator("#uploaded :is(input, select)").count() == 0  # no answer would help
        send(b"1\n2\n" * 30)
        it.page.wait_for_selector("#unit")
        assert "単位" in it.text("#uploaded [role=alert]")
        told = json.dumps({"message": "Nobody has put this into Japanese.", "field": None})
        it.page.route("**/simulate", lambda route: route.fulfill(status=422, body=told))
        it.page.get_by_label("壁とのすき間 (cm)").fill("5")
        it.page.wait_for_selector("#problem small")
        assert it.text("#problem").startswith("この条件では計算できません。")
        assert it.page.get_attribute("#problem small", "lang") == "en"


def test_a_record_that_the_server_forgets_is_missed(
    browser: Browser, server: Running, tmp_path: Path
) -> None:
    file = tmp_path / "<img src=x onerror=alert(1)>.csv"
    (motion := sp.near_fault()).write(file)
    with opened(browser, server, allowed=("404", "422")) as it:
        asked, answer = it.simulated(lambda: it.page.set_input_files("#file", file))
        it.page.wait_for_selector("#uploaded svg path")
        assert it.page.locator("#uploaded img").count() == 0
        assert "intensity" not in asked["scene"]["shaking"]
        assert answer["motion"]["pga_m_s2"] == pytest.approx(motion.pga, rel=1e-3)
        asked, _ = it.simulated(lambda: it.page.get_by_label("Make the record as strong").check())
        assert asked["scene"]["shaking"]["intensity"] == 6.25
        name = asked["scene"]["shaking"]["record"]
        assert it.page.request.delete(f"{server.address}/api/v1/motions/{name}").status == 204
        it.page.get_by_label("Height (cm)").fill("170")
        it.page.wait_for_selector("#uploaded [role=alert]")
        assert "no longer on the server" in it.text("#uploaded")
        it.page.wait_for_selector("#problem", state="hidden")  # the scene goes on without it
        assert "computed one" in it.text("#summary")


DROP = """(place, text) => {
  const carried = new DataTransfer();
  carried.items.add(new File([text], "numbers.txt"));
  place.dispatchEvent(new DragEvent("drop", { dataTransfer: carried, bubbles: true, cancelable: true }));
}"""


def test_a_record_is_dropped_and_its_unit_asked_for(browser: Browser, server: Running) -> None:
    numbers = "\n".join(f"{100 * (i % 7 - 3)}" for i in range(2000))
    with opened(browser, server, allowed=("422",)) as it:
        it.page.eval_on_selector("#drop", DROP, numbers)
        it.page.wait_for_selector("#unit")
        assert it.page.locator("#uploaded [role=alert]").is_visible()
        it.page.select_option("#unit", "gal")
        it.page.fill("#step", "0.01")
        asked, answer = it.simulated(lambda: it.page.click("text=Send again"))
        assert asked["scene"]["shaking"]["record"]
        assert answer["motion"]["pga_m_s2"] == pytest.approx(3.0)


@pytest.mark.parametrize(("up", "refused"), [(-9.81, True), *long((0.3, False))])
def test_the_mean_of_a_record_is_taken_off(
    browser: Browser, server: Running, up: float, refused: bool
) -> None:
    rows = (f"{0.01 * i:.2f},{i % 7 - 3},0,{up + 0.01 * (i % 3 - 1):.2f}" for i in range(1400))
    text = "\n".join(["t,x (m/s2),y (m/s2),z (m/s2)", *rows])
    with opened(browser, server, allowed=("422",)) as it:
        it.page.eval_on_selector("#drop", DROP, text)
        button = "text=Send again" if refused else "#uploaded button:has-text('Take the mean off')"
        it.page.wait_for_selector(button)
        assert ("gravity" if refused else "oscillates") in it.text("#uploaded .refusal")
        asked, _ = it.simulated(lambda: it.page.click(button))
        assert asked["scene"]["shaking"]["remove_mean"] is True
        it.page.wait_for_selector(button, state="detached")
        it.wait("() => location.hash.includes('remove_mean')")
