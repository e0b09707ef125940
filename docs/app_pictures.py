"""Screenshots of the app, taken as the pages are built; a line in their place where there is no Chromium."""

from __future__ import annotations

import threading
import time
from contextlib import contextmanager
from typing import TYPE_CHECKING, NamedTuple

import prerequisites

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from playwright.sync_api import Browser, Page

ABSENT = "*No Chromium was found when these pages were built, so the picture of {} is missing here.*\n"
PATIENCE = 300e3
"""How long the app may take to compute what is shown, on a slow machine [ms]."""


class Picture(NamedTuple):
    """A screenshot.

    Parameters
    ----------
    name : str
        Its file.
    about : str
        What is seen, for those who do not see it.
    page : str
        The page of the app.
    done : str
        The element that stands when everything is there.
    part : str
        The element that is shown from its top; where there is none, the top of the page.
    size : tuple
        Width and height of the window, and of the picture at most [px].
    """

    name: str
    about: str
    page: str
    done: str
    part: str = ""
    size: tuple[int, int] = (1280, 960)


PICTURES = (
    Picture(
        "app_scene",
        "a bookcase that overturns without measures and stands with brackets",
        "",
        "#see:not([aria-busy])",
    ),
    Picture(
        "app_verdict",
        "the verdict: which measure holds the bookcase, and how surely",
        "",
        "#understand[data-state=done]",
        "#understand",
    ),
    Picture(
        "app_room",
        "a bedroom in plan, with who is hit and what to change",
        "room/",
        "#answer[data-state=done]",
    ),
)


@contextmanager
def _served() -> Iterator[str]:
    from stayput.app.server import address_of, bind, create_app, server_of

    bound = bind("127.0.0.1", 0)
    server = server_of(create_app(warming=False))
    thread = threading.Thread(target=lambda: server.run(sockets=[bound]), daemon=True)
    thread.start()
    while not server.started and thread.is_alive():
        time.sleep(0.05)
    try:
        yield address_of(bound).rstrip("/")
    finally:
        server.should_exit = True
        thread.join(10.0)
        bound.close()


def _taken(browser: Browser, address: str, picture: Picture, path: Path) -> None:
    width, height = picture.size
    page: Page = browser.new_page(
        viewport={"width": width, "height": height},
        locale="en-US",
        color_scheme="light",
        reduced_motion="reduce",
    )
    page.set_default_timeout(PATIENCE)
    page.goto(f"{address}/{picture.page}")
    page.wait_for_selector(picture.done, state="attached")
    if picture.part:
        box = page.locator(picture.part).bounding_box()
        assert box is not None
        box["height"] = min(box["height"], height)
        page.screenshot(path=path, full_page=True, clip=box)
    else:
        page.screenshot(path=path)
    page.close()


def write(folder: Path) -> None:
    """Write each screenshot, and what a page includes to show it."""
    program = prerequisites.find_chromium()
    if program is not None:
        from playwright.sync_api import sync_playwright

        with _served() as address, sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
            for picture in PICTURES:
                _taken(browser, address, picture, folder / f"{picture.name}.png")
            browser.close()
    for picture in PICTURES:
        shown = f"![The app: {picture.about}](generated/{picture.name}.png)\n"
        text = ABSENT.format(picture.about) if program is None else shown
        (folder / f"{picture.name}.md").write_text(text, encoding="utf-8")
