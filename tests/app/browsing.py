"""The page in Chromium: what every test of it opens, and what it watches."""

from __future__ import annotations

from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from functools import cache
from typing import TYPE_CHECKING, Any

import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import expect, sync_playwright

import prerequisites
from long_cases import long
from waiting import PATIENCE

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterator, Mapping

    from playwright.sync_api import Browser, FloatRect, Page, Playwright, Response, Route
    from serving import Running


PHONE = {"width": 390, "height": 844}
DESK = {"width": 1280, "height": 900}
FLAGS = ["--no-sandbox", "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1", "--process-per-site"]
WEBGL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]  # without a graphics card
FLAT = ["--disable-gpu", "--disable-3d-apis"]  # takes half as long as WebGL that no graphics card draws
LOCALES = {"en": "en-GB", "ja": "ja-JP"}
WAIT = 1000.0 * PATIENCE
"""How long the page may take for anything, on a machine that has much else to do [ms]."""

expect.set_options(timeout=WAIT)

COMPILING = 300_000
"""How long what is compiled first may take [ms]."""

SOONER = """{
  const later = setTimeout;
  window.setTimeout = (work, milliseconds, ...given) => later(work, milliseconds / 4, ...given);
}"""
"""Lets pages wait a quarter as long, for what settles and between looks: nothing comes in another order."""

FEW = 4
LOOKS = pytest.mark.parametrize(
    ("theme", "language", "size"),
    [("dark", "en", PHONE), *long(("light", "en", DESK), ("dark", "ja", DESK), ("light", "ja", PHONE))],
)


class Chromium:
    """Starts Chromium; the one without WebGL is the same for all tests until it is closed."""

    def __init__(self) -> None:
        self._ending = ExitStack()
        self._playwright: Playwright | None = None
        self._flat: Browser | None = None

    def start(self, flags: list[str]) -> Browser:
        path = prerequisites.find_chromium()
        if path is None:
            prerequisites.do_without(prerequisites.BROWSER)
        if self._playwright is None:
            self._playwright = self._ending.enter_context(sync_playwright())
        return self._playwright.chromium.launch(executable_path=path, args=[*FLAGS, *flags])

    def flat(self) -> Browser:
        self._flat = self._flat or self.start(FLAT)
        return self._flat

    def close(self) -> None:
        """End all of it, and with it the event loop of this thread, which other tests have none of."""
        self._ending.close()
        self._playwright = self._flat = None


CHROMIUM = Chromium()


@pytest.fixture(scope="module")
def browser() -> Browser:
    """A Chromium without WebGL, where scenes in space are drawn flat."""
    return CHROMIUM.flat()


@pytest.fixture(scope="module")
def webgl() -> Iterator[Browser]:
    """A Chromium with WebGL."""
    with CHROMIUM.start(WEBGL) as found:
        yield found


def grave(page: Page) -> list[str]:
    """Return what axe finds that is serious or critical."""
    return [
        f"{one['id']}: {one['nodes'][0]['html'][:120]} {one['nodes'][0]['failureSummary'][:160]}"
        for one in Axe().run(page).response["violations"]
        if one["impact"] in ("serious", "critical")
    ]


@dataclass
class Opened:
    """A page that is open, and what it has said and asked."""

    page: Page
    home: str
    console: list[str] = field(default_factory=list)
    asked: list[str] = field(default_factory=list)

    def check(self, *allowed: str) -> None:
        """Check that nothing has gone wrong but what is allowed, nor been asked of anybody else."""
        own = (self.home + "/", "blob:" + self.home)
        assert [url for url in self.asked if not url.startswith(own)] == []
        busy = ("status of 429", "status of 503")  # what the page waits for, on a machine that is slow
        assert [line for line in self.console if not any(part in line for part in (*allowed, *busy))] == []

    def simulated(self, act: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        """Do something and return what the simulation that follows was asked and what it answered."""
        self.settle()
        with self.page.expect_response(
            lambda answer: answer.url.endswith("/simulate"), timeout=WAIT
        ) as found:
            act()
        self.settle()
        return _body(found.value), found.value.json()

    def box(self, selector: str) -> FloatRect:
        """Return where an element is on the screen."""
        found = self.page.locator(selector).bounding_box()
        assert found
        return found

    def grave(self) -> list[str]:
        return grave(self.page)

    def settle(self) -> None:
        """Wait until the newest scene is drawn; the server's first one is compiled before."""
        self.page.wait_for_selector("html[data-drawn]", state="attached", timeout=COMPILING)
        self.page.wait_for_selector("#see:not([aria-busy])", state="attached", timeout=WAIT)
        self.draw()

    def draw(self) -> None:
        """Wait until the page has drawn what it was going to: it draws once before the next frame."""
        self.page.evaluate("new Promise(requestAnimationFrame)")

    def wait(self, so: str, value: Any = None) -> None:
        """Wait until a function of JavaScript returns true; the page's policy forbids mere expressions."""
        assert "=>" in so
        self.page.wait_for_function(so, arg=value)

    def kept(self, *parts: str) -> None:
        """Wait until the page's address has these parts of the scene."""
        self.wait("parts => parts.every(part => location.hash.slice(1).split('&').includes(part))", parts)
        self.wait("() => document.getElementById('address').value === location.href")

    def speak(self, language: str) -> None:
        """Choose a language, whose words may have to be fetched first."""
        self.page.click(f"#languages [lang={language}]")
        self.page.wait_for_selector(f"html[lang={language}]")

    def go(self, screen: str) -> None:
        """Choose a step."""
        self.page.click(f"#steps button[data-screen={screen}]")

    def text(self, selector: str) -> str:
        return self.page.locator(selector).inner_text().replace("\u00a0", " ")


def _body(answer: Response) -> dict[str, Any]:
    found: dict[str, Any] = answer.request.post_data_json
    return found


def _short(route: Route) -> None:
    asked: dict[str, Any] = route.request.post_data_json
    asked["scene"]["shaking"]["suite"] = {"family": "near-fault", "count": FEW}
    asked["scene"].setdefault("uncertainty", {})["samples"] = FEW
    route.continue_(post_data=asked)


@cache
def keeper_of(
    browser: Browser, home: str, size: tuple[int, int], language: str, theme: str, motion: str, touch: bool
) -> Page:
    """Return a page that stays open and does nothing.

    Pages that are looked at alike share its context and its process: they load and compile the scripts once.
    """
    context = browser.new_context(
        viewport={"width": size[0], "height": size[1]},
        locale=LOCALES[language],
        color_scheme=theme,  # type: ignore[arg-type]
        reduced_motion=motion,  # type: ignore[arg-type]
        has_touch=touch,
    )
    context.add_init_script(SOONER)
    keeper = context.new_page()
    keeper.goto(f"{home}/api/v1/ping")
    return keeper


def new_page(
    browser: Browser,
    server: Running,
    *,
    size: dict[str, int],
    language: str,
    theme: str,
    motion: str = "reduce",
    touch: bool = False,
) -> Page:
    """Return an empty page, for which nothing is kept of the pages before."""
    seen = size["width"], size["height"]
    keeper = keeper_of(browser, server.address, seen, language, theme, motion, touch)
    keeper.evaluate("localStorage.clear()")
    page = keeper.context.new_page()
    page.set_default_timeout(WAIT)
    return page


PLANE = "#piece=bookcase&inSpace=0"
IN_PLANE = "#piece=bookcase&shelves=33,33,33,33,33&inSpace=0&measures=l_bracket"
"""Address of the page with a piece that is shaken in the plane: its runs are quick, and list every event."""


@contextmanager
def opened(
    browser: Browser,
    server: Running,
    address: str = "",
    *,
    language: str = "en",
    theme: str = "light",
    size: dict[str, int] = DESK,
    motion: str = "reduce",
    verify: bool = False,
    allowed: tuple[str, ...] = (),
    routes: Mapping[str, Callable[[Route], None]] | None = None,
    headers: Mapping[str, str] | None = None,
) -> Generator[Opened]:
    """Open the page; at the end nothing may have gone wrong, nor have been asked of anybody else.

    Verifications are left out unless they are wanted, and then they are of a few motions; what "routes" match
    is answered by their functions. Everything that is asked has the headers.
    """
    page = new_page(browser, server, size=size, language=language, theme=theme, motion=motion)
    page.set_extra_http_headers(dict(headers or {}))
    found = Opened(page, server.address)
    page.on("console", lambda one: one.type in ("error", "warning") and found.console.append(one.text))
    page.on("pageerror", lambda error: found.console.append(str(error)))
    page.on("request", lambda one: found.asked.append(one.url))
    if verify:
        page.route("**/api/v1/verify", _short)
    else:
        page.route("**/api/v1/verify", lambda route: None)  # it is never answered
    for pattern, answer in (routes or {}).items():
        page.route(pattern, answer)
    with ExitStack() as ending:
        ending.callback(page.close)
        ending.callback(page.unroute_all, behavior="ignoreErrors")
        page.goto(f"{server.address}/{address}")
        found.settle()
        yield found
    found.check(*allowed)
