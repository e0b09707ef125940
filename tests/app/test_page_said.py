"""The page in Chromium: what is not as it was asked for is said where the reader looks, in both languages."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import pytest
from browsing import COMPILING, DESK, PHONE, opened

import stayput as sp
from long_cases import long
from stayput.model.body import SIZE_RANGE

if TYPE_CHECKING:
    from pathlib import Path

    from browsing import Opened
    from playwright.sync_api import Browser, Route
    from serving import Running

SIDEWAYS = {"width": 844, "height": 390}

CUT = """all => {
  const pen = document.createElement("canvas").getContext("2d");
  const spinner = 18;
  return all.filter(one => one.checkVisibility()).filter(one => {
    const style = getComputedStyle(one);
    pen.font = `${style.fontSize} ${style.fontFamily}`; // "font" is empty beside tabular figures
    const inside = one.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight) - spinner;
    return pen.measureText(one.value).width > inside;
  }).map(one => `${one.ariaLabel}: ${one.value}`);
}"""


def scene(**changed: object) -> str:
    usual = {
        "piece": "bookcase",
        "width": 0.3,
        "height": 1.8,
        "mass": 35,
        "shelves": "33,33,33,33,33",
        "wall": 1,
        "inSpace": 0,
    }
    return "#" + "&".join(f"{name}={value}" for name, value in {**usual, **changed}.items())


@pytest.mark.parametrize("size", [PHONE, *long(DESK)])
def test_number_fields_show_all_of_their_digits(
    browser: Browser, server: Running, size: dict[str, int]
) -> None:
    measures = "l_bracket;stiffness:123456,belt;stiffness:250000,gel_mats,tension_pole;stiffness:1000000"
    with opened(browser, server, scene(measures=measures, storeys=10, storey=3), size=size) as it:
        it.go("scene")
        for summary in it.page.locator("#measures summary:visible, #sizes summary").all():
            if summary.evaluate("one => !one.parentElement.open"):
                summary.click()
        values = it.page.eval_on_selector_all("input[type=number]", "all => all.map(one => one.value)")
        assert "123456" in values
        assert it.page.eval_on_selector_all("input[type=number]", CUT) == []
        it.go("understand")
        assert it.page.eval_on_selector_all("input[type=number]", CUT) == []


def test_a_number_is_shown_as_it_was_given_and_its_limits_are_said(it: Opened) -> None:
    height = it.page.get_by_label("Height (cm)")
    asked, _ = it.simulated(lambda: height.fill("181.5"))
    height.press("Tab")
    assert height.input_value() == "181.5"
    assert asked["scene"]["furniture"]["height"] == pytest.approx(1.815)
    asked, _ = it.simulated(lambda: height.fill("310"))  # beyond the slider, and still taken
    assert asked["scene"]["furniture"]["height"] == pytest.approx(3.1)
    low, high = SIZE_RANGE
    asked, _ = it.simulated(lambda: height.fill("100000"))
    assert asked["scene"]["furniture"]["height"] == pytest.approx(high)
    assert f"From {100 * low:g} to {100 * high:g} cm." in it.text("#sizes")
    it.simulated(lambda: height.fill("170"))
    assert "From " not in it.text("#sizes")


def test_a_link_whose_record_has_expired_says_so_above_the_picture(browser: Browser, server: Running) -> None:
    link = scene(record=32 * "0", name="my town.csv", wave="abc*")
    with opened(browser, server, link, allowed=("404",)) as it:
        assert "“my town.csv” is no longer on the server" in it.text("#notices")
        it.speak("ja")
        assert "「my town.csv」はサーバーに残っていません" in it.text("#notices")
        it.speak("en")
        it.page.click("text=Understood")
        it.page.locator("#notices").wait_for(state="hidden")


def test_an_old_picture_does_not_pass_for_the_answer(browser: Browser, server: Running) -> None:
    with opened(browser, server, motion="no-preference") as it:
        held: list[Route] = []
        it.page.route("**/simulate", lambda route: held.append(route))
        it.page.get_by_label("Height (cm)").fill("150")
        it.page.wait_for_selector("#see[data-old=true]")
        assert "from before the change" in it.text("#wait")
        assert it.page.get_attribute("#play", "aria-label") == "Play"  # it has stopped
        still = it.page.input_value("#time")
        it.page.wait_for_timeout(200)
        assert it.page.input_value("#time") == still
        it.page.unroute("**/simulate")
        held[0].continue_()
        it.page.wait_for_selector("#see[data-old=false]")
        assert not it.page.locator("#wait").is_visible()
        assert it.page.get_attribute("#play", "aria-label") == "Pause"


def test_what_has_no_wall_or_ceiling_is_said_to_be_left_out(browser: Browser, server: Running) -> None:
    with opened(browser, server, scene(measures="l_bracket,tension_pole")) as it:
        assert not it.page.locator("#notices").is_visible()
        it.simulated(lambda: it.page.get_by_label("There is a wall behind it").uncheck())
        told = "no wall behind the piece: Screwed L-brackets."
        assert told in it.text("#notices")
        assert told in it.text("#room")
        asked, _ = it.simulated(lambda: it.page.get_by_label("Height of the room (cm)").fill("180"))
        assert "ceiling" not in asked["scene"]["room"]
        assert asked["measures"] == []
        for place in ("#notices", "#room"):
            assert "does not go under this ceiling" in it.text(place)
            assert "no ceiling above the piece: Tension poles." in it.text(place)
        it.speak("ja")
        assert "家具が入りません" in it.text("#notices")
        assert "L型金具" in it.text("#room")


def record(folder: Path, name: str, motion: sp.Motion) -> Path:
    return motion.write(folder / name)


def test_the_component_of_a_record_is_said_and_chosen(
    browser: Browser, server: Running, tmp_path: Path
) -> None:
    motion = sp.near_fault()
    file = record(tmp_path, "three.csv", replace(motion, y=0.5 * motion.x, z=0.25 * motion.x))
    with opened(browser, server) as it:
        _, answer = it.simulated(lambda: it.page.set_input_files("#file", file))
        peak = answer["motion"]["pga_m_s2"]
        choice = it.page.locator("#uploaded select")
        assert choice.input_value() == "x"
        assert choice.locator("option").all_inner_texts() == ["x", "y"]
        assert it.page.locator("#strength input[type=radio]:checked").count() == 0  # it has its own strength
        asked, answer = it.simulated(lambda: choice.select_option("y"))
        assert asked["scene"]["shaking"]["component"] == "y"
        assert answer["motion"]["pga_m_s2"] == pytest.approx(0.5 * peak, rel=1e-6)
        assert "Vertical component: z." in it.text("#uploaded")
        it.kept("component=y")
        it.page.reload()
        it.settle()
        assert it.page.locator("#uploaded select").input_value() == "y"
        it.speak("ja")
        assert "上下動" in it.text("#uploaded")
        asked, _ = it.simulated(lambda: it.page.get_by_label("震度6強", exact=True).check())
        assert asked["scene"]["shaking"]["intensity"] == 6.25  # it is made as strong


def test_a_record_of_an_upper_floor_is_not_sent_through_a_building_without_a_word(
    browser: Browser, server: Running, tmp_path: Path
) -> None:
    with opened(browser, server, allowed=("422",)) as it:
        it.simulated(lambda: it.page.get_by_label("In a building").check())
        it.simulated(
            lambda: it.page.set_input_files("#file", record(tmp_path, "ground.csv", sp.near_fault()))
        )
        assert not it.page.locator("#notices").is_visible()
        it.simulated(
            lambda: it.page.set_input_files("#file", record(tmp_path, "floor42.csv", sp.near_fault()))
        )
        assert "of floor 42 of a building" in it.text("#uploaded")
        assert "with no building between" in it.text("#uploaded")
        _, refused = it.simulated(lambda: it.page.get_by_label("The ground", exact=True).check())
        assert "of floor 42, not of the ground; a building stands on the ground" in refused["message"]
        assert refused["message"] in it.text("main")
        it.simulated(lambda: it.page.get_by_label("On the ground").check())
        assert refused["message"] not in it.text("main")


SEEN = """() => {
  const box = document.getElementById("stage-with").getBoundingClientRect();
  return Math.min(box.bottom, innerHeight) - Math.max(box.top, 0) > 100;
}"""
"""Whether the picture is in sight."""

SPY = """() => {
  const write = CanvasRenderingContext2D.prototype.fillText;
  globalThis.written = [];
  CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
    written.push(text);
    return write.call(this, text, ...rest);
  };
}"""
"""Notes what is written into pictures."""


def test_nothing_lies_over_the_picture_of_a_phone_on_its_side(browser: Browser, server: Running) -> None:
    overlap = """() => {
      const bar = document.querySelector(".transport").getBoundingClientRect();
      return [...document.querySelectorAll("canvas.stage")].filter(one => one.checkVisibility())
        .some(one => one.getBoundingClientRect().bottom > bar.top + 1);
    }"""
    with opened(browser, server, size=SIDEWAYS) as it:
        for down in (0, 40, 120, 240):
            it.page.evaluate(f"scrollTo(0, {down})")
            it.draw()
            assert not it.page.evaluate(overlap), down
        # the picture and its buttons are on the screen together
        it.page.evaluate("document.querySelector('.theatre').scrollIntoView()")
        bar = it.box(".transport")
        assert it.box(".stage >> nth=0")["y"] >= 0
        assert bar["y"] + bar["height"] <= it.box("#steps")["y"]
        jump = it.page.locator("#story .jump").last
        for size in (SIDEWAYS, PHONE, {"width": 1280, "height": 700}):
            it.page.set_viewport_size(size)  # type: ignore[arg-type]
            jump.scroll_into_view_if_needed()
            jump.click()
            it.wait(SEEN)


def test_lines_of_devices_have_their_names_and_a_tilt_beyond_its_picture_is_marked(
    browser: Browser, server: Running
) -> None:
    link = scene(measures="l_bracket,gel_mats,tension_pole,belt", ceiling=2.4, gap=0.02)
    with opened(browser, server, link) as it:
        names = it.page.locator("#device-key li").all_inner_texts()
        assert "Adhesive gel mats, front" in names
        assert len(names) == 5
        assert names[-1] == "and 1 more"
        dashes = it.page.eval_on_selector_all(
            "#device-key path", "all => all.map(one => one.getAttribute('stroke-dasharray'))"
        )
        assert len(set(dashes)) == 4
        it.page.evaluate(SPY)
        it.page.click("#theme")  # by which everything is drawn again
        it.wait("() => written.includes('▲ up to 90 °')")


def test_the_slider_of_the_time_and_the_title_speak_the_language(browser: Browser, server: Running) -> None:
    with opened(browser, server, language="ja") as it:
        assert it.page.title().startswith("stayput：地震のとき")
        it.page.fill("#time", "500")
        it.draw()
        said = it.page.get_attribute("#time", "aria-valuetext")
        assert said is not None
        assert re.fullmatch(r"\d+秒のうち\d+\.\d秒", said)
        it.speak("en")
        assert it.page.title().startswith("stayput: will my furniture")


def test_what_is_not_known_is_no_chance_of_zero(browser: Browser, server: Running) -> None:
    def unknown(route: Route) -> None:
        answer = route.fetch()
        found: dict[str, Any] = answer.json()
        if found.get("result"):
            found["result"]["jma_intensity"] = None
            for option in found["result"]["options"]:
                option["probabilities"]["overturned"] |= {"estimate": None, "low": 0.0, "high": 1.0}
                for seen in (option["curve"] or {"observed": []})["observed"]:
                    seen["estimate"] = None
        route.fulfill(response=answer, json=found)

    link, routes = scene(measures="belt", ceiling=2.4, gap=0.02), {"**/api/v1/jobs/*": unknown}
    with opened(browser, server, link, verify=True, routes=routes) as it:
        it.page.wait_for_selector("#understand[data-state=done]", timeout=COMPILING)
        assert "not known, since no simulation came to its end" in it.text("#verdict")
        assert it.page.locator("#tens svg").count() == 0
        assert it.page.locator("#fragility .dot[d*='NaN'], #fragility .here").count() == 0
        assert set(it.page.locator("#ranking .share").all_inner_texts()) == {"not known"}
        assert it.page.locator("#ranking .bar .part").count() == 0


def test_a_refused_file_leaves_the_record_in_use_with_its_button(
    browser: Browser, server: Running, tmp_path: Path
) -> None:
    bad = tmp_path / "bad.csv"
    bad.write_text("no numbers\n" * 30)
    with opened(browser, server, allowed=("422",)) as it:
        it.simulated(lambda: it.page.set_input_files("#file", record(tmp_path, "good.csv", sp.near_fault())))
        it.page.set_input_files("#file", bad)
        it.page.locator("#uploaded .refusal").wait_for()
        assert "good.csv" in it.text("#uploaded")
        it.simulated(lambda: it.page.get_by_text("Without this record").click())
        assert it.text("#uploaded") == ""
