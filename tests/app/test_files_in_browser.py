"""What is written as one HTML file, opened in Chromium: any name of the user's is only text in it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from browsing import DESK, PHONE, WAIT
from playwright.sync_api import expect

import stayput as sp
from long_cases import long
from stayput.report.animation import animate_run
from stayput.verification import verify

if TYPE_CHECKING:
    from pathlib import Path

    from playwright.sync_api import Browser, Page

NAMES = ["<!--<script>", "</script><script>document.title = 1</script>"]


def opened(browser: Browser, path: Path) -> tuple[Page, list[str]]:
    page = browser.new_page()
    page.set_default_timeout(WAIT)
    said: list[str] = []
    page.on("pageerror", lambda error: said.append(str(error)))
    page.goto(path.as_uri())
    return page, said


@pytest.mark.parametrize("size", [PHONE, *long(DESK)])
def test_players_in_a_report_are_shown_whole(browser: Browser, tmp_path: Path, size: dict[str, int]) -> None:
    scenario = sp.Scenario.parse(
        {
            "furniture": {"preset": "bookcase"},
            "dimensions": 3,
            "shaking": {"sine": {"amplitude": 4.0, "frequency": 1.0, "duration": 1.0}},
            "measures": [{"type": "anti_slip_sheet"}],
            "uncertainty": {"samples": 1},
        }
    )
    verify(scenario, levels=[], threads=1, progress=False).report(tmp_path / "report.html")
    page, said = opened(browser, tmp_path / "report.html")
    page.set_viewport_size(size)  # type: ignore[arg-type]
    player = page.locator("iframe").first
    player.scroll_into_view_if_needed()
    page.wait_for_function("document.querySelector('iframe').style.height !== ''")
    frame = page.frames[1]
    frame.wait_for_function("document.documentElement.scrollHeight <= innerHeight")
    frame.wait_for_function("document.documentElement.scrollWidth <= innerWidth")
    assert page.evaluate("document.documentElement.scrollWidth") <= size["width"]
    assert not said
    page.close()


def test_the_animation_plays_pauses_and_steps_under_any_name(browser: Browser, tmp_path: Path) -> None:
    run = sp.simulate(
        sp.Body(0.4, 1.8, 100.0), sp.Room(), sp.sine(amplitude=4.0, frequency=1.0, duration=2.0)
    )
    page, said = opened(browser, animate_run(run.named(["".join(NAMES)]), tmp_path / "run.html"))
    assert "".join(NAMES) in page.locator("h1").inner_text()
    assert page.locator("body > script").count() == 2
    page.wait_for_function("parseFloat(document.getElementById('clock').textContent) > 0.1")
    assert page.locator("#play").inner_text() == "Pause"
    page.keyboard.press(" ")
    assert page.locator("#play").inner_text() == "Play"
    paused = page.locator("#clock").inner_text()
    page.keyboard.press("ArrowLeft")  # the film may be at its end by now
    page.wait_for_function(f"document.getElementById('clock').textContent !== '{paused}'")
    page.locator("#theme").click()
    assert page.evaluate("document.documentElement.dataset.theme") == "dark"
    assert not said
    page.goto((tmp_path / "run.html").as_uri() + "#0.5")
    page.reload()
    page.wait_for_function("document.getElementById('clock').textContent === '0.50 s'")
    assert page.locator("#play").inner_text() == "Play"
    page.close()


def test_the_report_shows_what_says_most_and_plays_it_under_any_name(
    browser: Browser, tmp_path: Path
) -> None:
    scenario = sp.Scenario.parse(
        {
            "title": NAMES[0],
            "furniture": {"preset": "bookcase", "name": NAMES[1]},
            "shaking": {"sine": {"amplitude": 4.0, "frequency": 1.0, "duration": 2.0}},
            "measures": [{"type": "anti_slip_sheet", "name": NAMES[0]}],
            "uncertainty": {"samples": 1},
        }
    )
    verify(scenario, levels=[], threads=1, progress=False).report(tmp_path / "report.html")
    page, said = opened(browser, tmp_path / "report.html")
    assert page.title() == NAMES[0]
    page.locator("iframe").first.scroll_into_view_if_needed()
    player = page.frame_locator("iframe").first
    expect(player.locator(".stands").first).not_to_be_empty(timeout=WAIT)
    poster = player.locator("#clock").inner_text()
    assert poster != "0.00 s"  # of the moment that says most
    player.locator("#play").click()
    expect(player.locator("#play")).to_have_text("Pause")
    expect(player.locator("#clock")).not_to_have_text(poster, timeout=WAIT)
    assert NAMES[1] in (player.locator(".bodies").first.text_content() or "")
    assert not said
    page.close()


def test_a_report_plays_both_runs_in_step(browser: Browser, tmp_path: Path) -> None:
    scenario = sp.Scenario.parse(
        {
            "furniture": {"preset": "bookcase"},
            "room": {"left_wall": {"gap": 0.02}},
            "shaking": {"sine": {"amplitude": 4.0, "frequency": 1.0, "duration": 2.0}},
            "measures": [{"type": "belt"}],
            "uncertainty": {"samples": 24},
        }
    )
    verdict = verify(scenario, levels=[], threads=1, progress=False)
    assert verdict.best is not verdict.without
    verdict.report(tmp_path / "report.html")
    page, said = opened(browser, tmp_path / "report.html")
    player = page.frame_locator("iframe").first
    expect(player.locator(".scene")).to_have_count(2, timeout=WAIT)
    assert player.locator("h2").all_inner_texts() == ["Without measures", "Belts"]
    assert player.locator("#play").count() == 1
    player.locator("#time").fill("1000")
    end = "JSON.parse(document.getElementById('run').textContent).films[0].poses.end_s"
    expect(player.locator("#clock")).to_have_text(f"{page.frames[1].evaluate(end):.2f} s")
    tilts = [float(text.rstrip("°")) for text in player.locator(".tilt").all_inner_texts()]
    assert tilts[0] > 45.0 > tilts[1]
    assert not said
    page.close()


def report_of_a_bookcase(folder: Path) -> None:
    """Write the report of the least verification with a film."""
    scenario = sp.Scenario.parse(
        {
            "furniture": {"preset": "bookcase"},
            "shaking": {"sine": {"amplitude": 4.0, "frequency": 1.0, "duration": 1.0}},
            "uncertainty": {"samples": 1},
        }
    )
    verify(scenario, levels=[], threads=1, progress=False).report(folder / "report.html")


def test_a_link_opens_the_part_that_it_leads_to(browser: Browser, tmp_path: Path) -> None:
    report_of_a_bookcase(tmp_path)
    page, said = opened(browser, tmp_path / "report.html")
    assert page.locator("details.fold[open]").count() == 0
    page.get_by_role("link", name="How far to trust it").click()
    expect(page.locator("#trust")).to_have_attribute("open", "")
    page.goto((tmp_path / "report.html").as_uri() + "#estimates")
    page.reload()
    expect(page.locator("#estimates")).to_have_attribute("open", "")
    assert page.locator("details.fold[open]").count() == 1
    assert not said
    page.close()


def test_the_page_scrolls_on_over_a_film_and_without_scripts_drawings_stand_in(
    browser: Browser, tmp_path: Path
) -> None:
    report_of_a_bookcase(tmp_path)
    page, _ = opened(browser, tmp_path / "report.html")
    page.set_viewport_size({"width": 1000, "height": 500})
    scene = page.frame_locator("iframe").first.locator(".scene").first
    expect(scene).to_be_visible(timeout=WAIT)
    assert scene.evaluate("one => getComputedStyle(one).touchAction") == "pan-y"
    box = scene.bounding_box()
    assert box
    page.mouse.move(box["x"] + 50, box["y"] + 50)
    page.mouse.wheel(0, 120)
    page.wait_for_function("scrollY > 50")
    assert not page.locator(".twin").is_visible()
    page.close()
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto((tmp_path / "report.html").as_uri())
    assert page.locator(".twin img").first.is_visible()
    assert not page.locator("iframe.film").first.is_visible()
    context.close()
