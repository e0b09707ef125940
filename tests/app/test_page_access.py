"""The page in Chromium: for everybody. Screen readers, the keyboard, both themes, both languages."""

from __future__ import annotations

import json
import re
from importlib import resources
from typing import TYPE_CHECKING

import pytest
from browsing import COMPILING, DESK, LOOKS, PHONE, opened
from test_page_space import PIECES, scenario_file

from stayput.app.server import words
from stayput.catalogue import LANGUAGES, room_page
from stayput.report.page import canvas_files

if TYPE_CHECKING:
    from browsing import Opened
    from playwright.sync_api import Browser
    from serving import Running


PAGE, ROOM_PAGE = (resources.files("stayput.app").joinpath(name) for name in ("page", "room_page"))


@LOOKS
def test_axe_finds_nothing_serious(
    browser: Browser, server: Running, theme: str, language: str, size: dict[str, int]
) -> None:
    building = "&storeys=9&storey=4" if size is PHONE else ""  # it takes its time where it is verified
    scene = (
        "#piece=bookcase&width=0.3&height=1.8&mass=35&shelves=33,33&wall=0&intensity=6.25&member=3"
        f"&measures=gel_mats,tension_pole{building}"
    )
    with opened(browser, server, scene, theme=theme, language=language, size=size, verify=size is DESK) as it:
        for screen in ("scene", "see", "understand", "keep") if size is PHONE else ("see",):
            it.go(screen)
            for summary in it.page.locator("summary:visible").all():
                if summary.evaluate("one => !one.parentElement.open"):
                    summary.click()
            if size is DESK:
                it.page.wait_for_selector("#understand[data-state=done]", timeout=COMPILING)
            assert it.grave() == []
        it.page.set_input_files("#file", scenario_file(PIECES))
        it.page.wait_for_selector("#pieces:not([hidden])", state="attached")
        it.settle()
        it.go("see")
        assert it.grave() == []
        assert it.page.evaluate("document.documentElement.scrollWidth") <= size["width"]


def test_the_keyboard_reaches_and_works_everything(browser: Browser, server: Running) -> None:
    with opened(browser, server, size=PHONE) as it:
        page = it.page
        it.wait("() => document.querySelector('#understand').dataset.state === 'running'")  # it stays so
        for screen in ("scene", "see", "understand", "keep"):
            page.focus(f"#steps button[data-screen={screen}]")
            page.keyboard.press("Enter")
            reached = set()
            for _ in range(150):
                page.keyboard.press("Tab")
                mark = page.evaluate("document.activeElement.dataset.mark ??= String(Math.random())")
                if mark in reached:
                    break
                reached.add(mark)
            wanted = page.eval_on_selector_all(
                f"#{screen} :is(button, select, summary, input:not([type=radio]), a[href])",
                """all => all.filter(one => one.checkVisibility() && !one.disabled && !one.dataset.mark)
                         .map(one => one.outerHTML.slice(0, 90))""",
            )
            assert wanted == []
        page.focus("#steps button[data-screen=scene]")
        page.keyboard.press("Enter")
        slider = page.get_by_label("Height", exact=True)
        slider.focus()
        asked, _ = it.simulated(lambda: page.keyboard.press("ArrowRight"))
        assert asked["scene"]["furniture"]["height"] == pytest.approx(1.81)
        page.get_by_label("Belts").focus()
        asked, _ = it.simulated(lambda: page.keyboard.press("Space"))
        assert "belt" in [one["type"] for one in asked["measures"]]
        page.get_by_label("6-upper", exact=True).focus()
        asked, _ = it.simulated(lambda: page.keyboard.press("ArrowRight"))
        assert asked["scene"]["shaking"]["intensity"] == 6.75
        page.focus("#steps button[data-screen=see]")
        page.keyboard.press("Enter")
        before = float(page.input_value("#time"))
        page.keyboard.press("ArrowRight")
        it.draw()
        assert float(page.input_value("#time")) > before
        page.keyboard.press("Space")
        assert page.get_attribute("#play", "aria-label") == "Pause"


def test_both_languages_have_every_word() -> None:
    english, japanese = (words(language) for language in LANGUAGES)
    assert english.keys() == japanese.keys()
    for key, text in english.items():
        assert sorted(re.findall(r"\{\w+\}", text)) == sorted(re.findall(r"\{\w+\}", japanese[key])), key
    files = [one for folder in (PAGE, ROOM_PAGE) for one in folder.iterdir()]
    sources = "".join(one.read_text("utf-8") for one in files if one.name.endswith((".js", ".html")))
    used = set(re.findall(r'\bt\("(\w+)"', sources)) | set(re.findall(r'\bsay\("(\w+)"', sources))
    used |= set(re.findall(r'data-t(?:-label)?="(\w+)"', sources))
    assert used - english.keys() == set()
    for key, (_, text) in room_page.TEXTS.items():
        plain = re.sub(r"\{\w+\}|〔.*?〕|stayput|HTML|GIF|MP4|\b(?:c?m|kg)\b|J(?=以上)", "", text)
        assert re.search(r"[A-Za-z]", plain) is None, key


def test_language_and_theme_are_the_systems_until_chosen(browser: Browser, server: Running) -> None:
    paper = "getComputedStyle(document.body).backgroundColor"
    with opened(browser, server, language="ja", theme="dark") as it:
        dark = it.page.evaluate(paper)
        it.page.click("#theme")
        assert (light := it.page.evaluate(paper)) != dark
        assert it.page.get_attribute("html", "lang") == "ja"
        it.page.get_by_label("高さ (cm)", exact=True).fill("150")
        it.kept("height=1.5")
        it.speak("en")
        assert it.page.get_by_label("Height (cm)", exact=True).input_value() == "150"
        it.page.reload()
        it.settle()
        assert it.page.get_attribute("html", "lang") == "en"
        assert it.page.evaluate(paper) == light


def test_only_the_verdict_speaks_up(it: Opened) -> None:
    live = it.page.eval_on_selector_all("[aria-live], output", "all => all.map(one => one.id)")
    assert live == ["verdict"]
    unlabelled = it.page.eval_on_selector_all(
        "canvas", "all => all.filter(one => one.checkVisibility() && !one.ariaLabel).map(one => one.id)"
    )
    assert unlabelled == []


def test_the_colours_are_stayputs() -> None:
    from stayput.report import palette

    inks, style = canvas_files()["inks.css"].read_text("utf-8"), PAGE.joinpath("style.css").read_text("utf-8")
    light = dict(re.findall(r"--(\w+): (#\w+);", inks.split("}")[0] + style.split("}")[0]))
    wanted = {
        "card": palette.PAPER,
        "ink": palette.INK,
        "faint": palette.FAINT,
        "room": palette.ROOM,
        "alarm": palette.ALARM,
        "record": palette.COMPONENT_COLOURS["x"],
        **palette.ROLE_COLOURS,
    }
    assert {name: light[name] for name in wanted} == wanted
    for text in (inks, style):  # chosen, and the system's
        dark = re.findall(r"dark\W*\{(.*?)\}", text, re.DOTALL)
        assert len(dark) == 2
        assert len({json.dumps(re.findall(r"--(\w+): (#\w+);", one)) for one in dark}) == 1


def test_nothing_on_the_page_comes_from_elsewhere() -> None:
    files = [*PAGE.iterdir(), *ROOM_PAGE.iterdir(), *canvas_files().values()]
    for path, one in ((file.name, file) for file in files):
        text = one.read_text("utf-8").replace("http://www.w3.org/2000/svg", "")
        assert "http://" not in text, path
        assert "https://" not in text, path
        assert len(text.splitlines()) < 300, path
