"""What the page asks of wall, ceiling, installation, contents and everyday use, and what it says of them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from browsing import PLANE, opened

if TYPE_CHECKING:
    from browsing import Opened
    from playwright.sync_api import Browser
    from serving import Running


def test_what_is_said_of_wall_ceiling_and_installation_goes_to_the_server(it: Opened) -> None:
    wall, ceiling = (it.page.get_by_label(name) for name in ("What the wall offers", "above the ceiling"))
    asked, _ = it.simulated(lambda: wall.select_option(label="concrete"))
    assert asked["scene"]["room"]["left_wall"]["construction"] == "concrete"
    asked, _ = it.simulated(lambda: ceiling.select_option(label="a dropped ceiling"))
    assert asked["scene"]["room"]["ceiling"]["construction"] == "dropped"
    it.kept("wallConstruction=concrete", "ceilingConstruction=dropped")
    it.simulated(lambda: it.page.get_by_label("There is a wall behind it").uncheck())
    assert not wall.is_visible()
    asked, _ = it.simulated(it.page.get_by_label("as people install it").check)
    assert asked["scene"]["uncertainty"] == {"installation": "as people install it"}
    it.kept("installed=1")


def test_the_tip_over_without_an_earthquake(browser: Browser, server: Running) -> None:
    with opened(browser, server, PLANE, verify=True) as it:
        it.page.get_by_role("button", name="Chest of drawers").click()
        it.kept("piece=chest", "drawers=4")
        it.go("understand")
        it.wait("() => document.querySelectorAll('#everyday-cases li').length === 3")
        assert "Without an earthquake" not in it.text("#also")
        it.wait("() => document.querySelector('#understand').dataset.state === 'done'")
        before = [url for url in it.asked if url.endswith(("/simulate", "/verify"))]
        with it.page.expect_response(lambda answer: answer.url.endswith("/everyday")) as told:
            it.page.get_by_label("Load on an open drawer").nth(1).fill("300")
        asked = told.value.request.post_data_json
        assert asked["scene"]["everyday"] == {"drawers": 4, "load": 300, "pull": 45}
        it.wait("() => /300\\skg.* tips the piece over/.test(document.querySelector('#everyday').innerText)")
        assert it.page.locator("#everyday-cases .gradeC").count() == 2
        it.page.get_by_label("Drawers that can be open").nth(1).fill("0")
        it.wait("() => /front edge/.test(document.querySelector('#everyday-cases').innerText)")
        it.kept("drawers=0", "drawerLoad=300", "pull=45")
        assert [url for url in it.asked if url.endswith(("/simulate", "/verify"))] == before


def test_a_link_and_a_reload_bring_all_of_it_back(browser: Browser, server: Running) -> None:
    link = (
        "#piece=chest&drawers=3&drawerLoad=40&pull=90&installed=1"
        "&wallConstruction=hanging+strip&ceilingConstruction=plasterboard&contents=books&doors=sliding"
    )
    with opened(browser, server, link) as it:
        page = it.page
        page.reload()
        it.settle()
        assert page.get_by_label("What may come out").input_value() == "books"
        assert page.get_by_label("Doors").input_value() == "sliding"
        assert page.get_by_label("What the wall offers").input_value() == "hanging strip"
        assert page.get_by_label("above the ceiling").input_value() == "plasterboard"
        assert page.get_by_label("as people install it").is_checked()
        shown = page.locator("#everyday-ask input[type=number]").all()
        assert [one.input_value() for one in shown] == ["3", "40", "90"]


def test_a_link_with_senseless_words_leaves_what_is_usual(browser: Browser, server: Running) -> None:
    with opened(browser, server, "#piece=chest&wallConstruction=gold&drawers=-2&pull=1e99") as it:
        assert it.page.get_by_label("What the wall offers").input_value() == "stud"
        shown = it.page.locator("#everyday-ask input[type=number]").all()
        assert [one.input_value() for one in shown] == ["0", "27.2", "10000"]


def test_what_is_inside_is_asked_and_the_ranking_says_what_comes_out(
    browser: Browser, server: Running
) -> None:
    with opened(browser, server, PLANE, verify=True) as it:
        assert not it.page.get_by_label("Doors").is_visible()
        asked, _ = it.simulated(lambda: it.page.get_by_label("What may come out").select_option("dishes"))
        assert asked["scene"]["contents"] == {"kind": "dishes", "doors": "none"}
        asked, _ = it.simulated(lambda: it.page.get_by_label("Doors").select_option("hinged"))
        assert asked["scene"]["contents"]["doors"] == "hinged"
        it.kept("contents=dishes", "doors=hinged")
        it.go("understand")
        it.wait("() => /dishes (come out|stay inside)/.test(document.querySelector('#ranking').innerText)")


def test_the_headline_says_what_comes_out_and_how_it_is_as_people_install_it(
    browser: Browser, server: Running
) -> None:
    address = "#piece=bookcase&inSpace=0&contents=books&measures=l_bracket&installed=1"
    with opened(browser, server, address, verify=True) as it:
        it.go("understand")
        it.wait("() => document.querySelectorAll('#also li:not(.hint)').length === 2")
        it.wait("() => /books/.test(document.querySelector('#also').innerText)")  # after the first looks
        without, held = it.page.locator("#also li:not(.hint)").all_inner_texts()
        comes_out = re.compile(r"%\sof the books come out\.|The books stay inside\.")
        assert without.startswith("Without measures: ")
        assert comes_out.search(without)
        assert "As people install it" not in without
        assert comes_out.search(held)
        assert re.search(r"As people install it, it overturns in (about |under |over )?\d", held)
        it.speak("ja")
        assert re.search(r"本(の.*が飛び出します|は飛び出しません)。", it.text("#also"))
        assert "実際の取付けでは" in it.text("#also")
