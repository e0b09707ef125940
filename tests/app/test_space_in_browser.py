"""The animation in space in Chromium: one file, without network, for everybody."""

from __future__ import annotations

import io
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from browsing import DESK, LOOKS, PHONE, WAIT, grave
from PIL import Image

import stayput as sp
from stayput.report.animation import film_of
from stayput.report.palette import STABILITY_COLOURS, rgb, stability_looks

if TYPE_CHECKING:
    from collections.abc import Generator
    from pathlib import Path

    from playwright.sync_api import Browser, Page

NAMES = {"en": ["lower part", "</script><b>"], "ja": ["下台", "上台"]}


@pytest.fixture(scope="module")
def run() -> Any:
    t = np.arange(0.0, 2.0, 0.01)
    shaking = sp.Motion(dt=0.01, x=6.0 * np.sin(7.0 * t), y=3.0 * np.sin(5.0 * t), name="two directions")
    parts = [
        sp.Piece(sp.Body.box(0.45, 0.9, 0.9, 60.0)),
        sp.Piece(sp.Body.cylinder(0.3, 0.8, 20.0), at=(0.0, 0.0, 0.9)),
    ]
    return sp.simulate(sp.Scene(parts, sp.Room(left_wall=sp.Wall(0.05))), shaking)


@contextmanager
def opened(
    browser: Browser, path: Path, *, size: dict[str, int] = DESK, mark: str = "#0.5", **given: Any
) -> Generator[Page]:
    """Open the file at half a second; nothing may be asked of a network, and nothing go wrong."""
    context = browser.new_context(viewport=size, reduced_motion="reduce", **given)  # type: ignore[arg-type]
    page = context.new_page()
    page.set_default_timeout(WAIT)
    said: list[str] = []
    page.on("pageerror", lambda error: said.append(str(error)))
    page.on("request", lambda one: one.url.startswith("file:") or said.append(one.url))
    page.goto(path.as_uri() + mark)
    page.wait_for_function("document.getElementById('clock').textContent !== ''")
    yield page
    assert said == []
    context.close()


def picture(page: Page) -> np.ndarray[Any, Any]:
    """The scene as it is seen, shape (height, width, 3)."""
    page.evaluate("new Promise(requestAnimationFrame).then(() => new Promise(requestAnimationFrame))")
    return np.asarray(Image.open(io.BytesIO(page.locator(".scene").screenshot())).convert("RGB")).astype(int)


def differ(one: np.ndarray[Any, Any], other: np.ndarray[Any, Any]) -> float:
    """What part of two pictures differs."""
    return float((np.abs(one - other).max(axis=2) > 12).mean())


def written(run: Any, folder: Path, language: str = "en") -> Path:
    return run.named(NAMES[language]).animate(folder / "run.html", language=language)


def coloured(shown: np.ndarray[Any, Any]) -> tuple[float, float]:
    """What parts of a picture are of what moves and of what falls: blue and red."""
    red, blue = shown[..., 0], shown[..., 2]
    return float((blue > red + 60).mean()), float((red > blue + 60).mean())


def shows_how_firmly_they_stand(page: Page, run: Any, time: float) -> None:
    """The page has the states and the colours that Python has."""
    scene = film_of(run).scene
    steps = [scene.stability_at(body, time) for body in range(2)]
    told = "all => all.map((one) => getComputedStyle(one).backgroundColor)"
    chips = page.eval_on_selector_all(".bodies .chip", told)
    assert chips == ["rgb({}, {}, {})".format(*rgb(STABILITY_COLOURS[step])) for step in steps]
    assert page.locator(".stands").inner_text() == stability_looks("en")[steps[0]][0]
    assert [share > 0.005 for share in coloured(picture(page))] == ["moves" in steps, "falls" in steps]


def test_the_scene_is_drawn_and_follows_the_slider_and_the_views(
    webgl: Browser, tmp_path: Path, run: Any
) -> None:
    with opened(webgl, written(run, tmp_path)) as page:
        assert page.locator("#flat").is_hidden()
        first = picture(page)
        shows_how_firmly_they_stand(page, run, 0.5)
        page.locator("#time").fill("900")
        page.wait_for_function("document.getElementById('clock').textContent === '1.79 s'")
        later = picture(page)
        shows_how_firmly_they_stand(page, run, 1.79)
        assert differ(first, later) > 0.005
        for view in ("Front", "Side", "Top", "Corner"):
            page.get_by_label(view, exact=True).check()
            assert (differ(picture(page), later) > 0.02) == (view != "Corner")


def test_the_mouse_turns_moves_and_comes_nearer(browser: Browser, tmp_path: Path, run: Any) -> None:
    with opened(browser, written(run, tmp_path)) as page:
        box = page.locator(".scene").bounding_box()
        assert box
        middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        shown = picture(page)
        for button in ("left", "right"):
            page.mouse.move(*middle)
            page.mouse.down(button=button)  # type: ignore[arg-type]
            page.mouse.move(middle[0] + 80, middle[1] + 30, steps=4)
            page.mouse.up(button=button)  # type: ignore[arg-type]
            moved = picture(page)
            assert differ(shown, moved) > 0.01
            shown = moved
        assert not page.get_by_label("Corner", exact=True).is_checked()
        page.mouse.wheel(0, -400)
        assert sum(coloured(picture(page))) > 1.2 * sum(coloured(shown))
        page.keyboard.press("1")
        assert page.get_by_label("Corner", exact=True).is_checked()


def test_a_finger_turns_and_two_come_nearer(browser: Browser, tmp_path: Path, run: Any) -> None:
    with opened(browser, written(run, tmp_path), size=PHONE, has_touch=True) as page:
        box = page.locator(".scene").bounding_box()
        assert box
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        session = page.context.new_cdp_session(page)

        def touch(kind: str, *places: tuple[float, float]) -> None:
            points = [{"x": across, "y": down, "id": number} for number, (across, down) in enumerate(places)]
            session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

        shown = picture(page)
        touch("touchStart", (x, y))
        for way in (20, 40, 60):
            touch("touchMove", (x + way, y))
        touch("touchEnd")
        turned = picture(page)
        assert differ(shown, turned) > 0.01
        touch("touchStart", (x - 20, y), (x + 20, y))
        for way in (25, 30, 35):
            touch("touchMove", (x - way, y), (x + way, y))
        touch("touchEnd")
        assert sum(coloured(picture(page))) > 1.3 * sum(coloured(turned))


def test_the_keyboard_plays_steps_turns_and_chooses(browser: Browser, tmp_path: Path, run: Any) -> None:
    with opened(browser, written(run, tmp_path)) as page:
        page.keyboard.press("ArrowRight")
        page.wait_for_function("document.getElementById('clock').textContent === '0.52 s'")
        page.locator(".scene").focus()
        shown = picture(page)
        for key in ("ArrowLeft", "Shift+ArrowUp", "+"):
            page.keyboard.press(key)
            moved = picture(page)
            assert differ(shown, moved) > 0.01
            shown = moved
        assert page.locator("#clock").inner_text() == "0.52 s"
        tilts = page.locator(".tilt").inner_text(), page.locator(".slide").inner_text()
        page.get_by_label("lower part").focus()
        page.keyboard.press("ArrowRight")
        assert page.get_by_label("</script><b>").is_checked()
        assert (page.locator(".tilt").inner_text(), page.locator(".slide").inner_text()) != tilts
        page.locator(".scene").focus()
        page.keyboard.press(" ")
        assert page.locator("#play").inner_text() == "Pause"
        page.wait_for_function("document.getElementById('clock').textContent > '0.60 s'")
        page.keyboard.press(" ")
        assert "has no WebGL 2" in page.locator("#flat").inner_text()
        shaken = page.get_by_label("Move the room with the ground")
        assert not shaken.is_checked()
        shown = picture(page)
        shaken.check()
        assert differ(shown, picture(page)) > 0.005
        page.emulate_media(reduced_motion="no-preference")
        page.goto(page.url.partition("#")[0])
        page.reload()
        page.wait_for_function("parseFloat(document.getElementById('clock').textContent) > 0.1")
        assert page.locator("#play").inner_text() == "Pause"


@LOOKS
def test_axe_finds_nothing_serious_and_nothing_is_cut(
    browser: Browser, tmp_path: Path, run: Any, theme: str, language: str, size: dict[str, int]
) -> None:
    path = written(run, tmp_path, language)
    with opened(browser, path, size=size, color_scheme=theme) as page:
        assert grave(page) == []
        assert page.evaluate("document.documentElement.scrollWidth") <= size["width"]
        assert page.get_attribute("html", "lang") == language
        assert page.locator("#play").inner_text() == {"en": "Play", "ja": "再生"}[language]
        shown = picture(page)
        assert (np.median(shown) < 80) == (theme == "dark")
        page.locator("#theme").click()
        assert (np.median(picture(page)) < 80) == (theme == "light")


def test_a_context_that_is_lost_is_made_anew(webgl: Browser, tmp_path: Path, run: Any) -> None:
    with opened(webgl, written(run, tmp_path)) as page:
        shown = picture(page)
        page.evaluate(
            """() => {
              const canvas = document.querySelector(".scene");
              const found = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
              const back = new Promise((done) =>
                canvas.addEventListener("webglcontextrestored", () => done()));
              found.loseContext();
              setTimeout(() => found.restoreContext(), 100);
              return back;
            }"""
        )
        assert differ(shown, picture(page)) < 0.01
