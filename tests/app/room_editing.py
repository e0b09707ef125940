"""The editor of a room's plan in Chromium, with what a person does to it."""

from __future__ import annotations

import itertools
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from browsing import DESK, new_page

if TYPE_CHECKING:
    from collections.abc import Generator

    from playwright.sync_api import Browser, Page
    from serving import Running

ROOM: dict[str, Any] = {
    "plan": {"width": 4.0, "length": 3.0},
    "furniture": [
        {"name": "bookcase", "preset": "bookcase", "against": "left_wall", "along": 2.0},
        {"name": "chest", "preset": "chest", "at": [2.0, 1.0], "heading": 0.0},
    ],
    "places": [{"kind": "bed", "at": [3.3, 1.9], "heading": 0.0}],
    "doors": [{"wall": "right_wall", "start": 0.1, "width": 0.7}],
    "windows": [{"wall": "far_side_wall", "start": 1.0, "width": 1.2}],
    "room": {"ceiling": {"height": 2.4}},
    "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 4}},
    "uncertainty": {"samples": 4},
}

TO_SCREEN = """async ([x, y]) => {
  const view = await import("/room/view.js");
  const [px, py] = view.sheetNow().place([x, y]);
  const at = new DOMPoint(px, py).matrixTransform(view.plan().getScreenCTM());
  return [at.x, at.y];
}"""

STILL = """async (name) => {
  const box = () => JSON.stringify(document.querySelector(name)?.getBoundingClientRect());
  const before = box();
  await new Promise(requestAnimationFrame);
  return before !== undefined && box() === before && JSON.parse(before);
}"""


@dataclass
class Editor:
    """The editor with a room in it."""

    page: Page
    console: list[str] = field(default_factory=list)

    def begin_anew(self) -> None:
        """Put the usual room into the editor as if the page had just been opened."""
        self.page.evaluate(
            "() => { delete performance.now; document.activeElement?.blur(); scrollTo(0, 0); }"
        )
        self.take(ROOM)

    def room(self) -> dict[str, Any]:
        found: dict[str, Any] = self.page.evaluate("import('/room/room.js').then((one) => one.current())")
        return found

    def take(self, room: dict[str, Any]) -> None:
        """Put another room into the editor."""
        self.page.evaluate("async (room) => (await import('/room/room.js')).replace(room)", room)

    def ask(self) -> None:
        """Put the room into the editor once more, and wait until the page has asked for its verdict.

        It is never answered, so that what the editor is told then is what it shows.
        """
        with self.page.expect_request(
            lambda one: (
                one.url.endswith("/api/v1/room") and one.post_data_json["scene"].get("title") == "asked"
            )
        ):
            self.take({**ROOM, "title": "asked"})

    def at(self, x: float, y: float) -> tuple[float, float]:
        """Return where a point of the plan is on the screen, scrolled to."""
        self.page.locator("#plan").scroll_into_view_if_needed()
        left, top = self.page.evaluate(TO_SCREEN, [x, y])
        return left, top

    def drag(self, start: tuple[float, float], end: tuple[float, float], *, drop: bool = True) -> None:
        """Drag on the plan from one point to another [m]."""
        self.pull(self.at(*start), self.at(*end), drop=drop)

    def pull(self, start: tuple[float, float], end: tuple[float, float], *, drop: bool = True) -> None:
        """Drag on the screen [px]."""
        self.page.mouse.move(*start)
        self.page.mouse.down()
        self.page.mouse.move(*end, steps=6)
        if drop:
            self.page.mouse.up()

    def point(self, *points: tuple[float, float]) -> None:
        """Drag with a finger from the first of some points on the screen over the others [px]."""
        touch = self.page.context.new_cdp_session(self.page)

        def send(kind: str, *fingers: tuple[float, float]) -> None:
            where = [{"x": x, "y": y} for x, y in fingers]
            touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": where})

        send("touchStart", points[0])
        for (x0, y0), (x1, y1) in itertools.pairwise(points):
            for step in range(1, 7):
                send("touchMove", (x0 + (x1 - x0) * step / 6, y0 + (y1 - y0) * step / 6))
        send("touchEnd")

    def handle(self, name: str) -> tuple[float, float]:
        """Return where the middle of a handle is on the screen, once it stays there.

        It is looked up anew in each frame, as the plan draws its handles anew.
        """
        box = self.page.wait_for_function(STILL, arg=f"[data-handle={name}] .felt").json_value()
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def select(self, thing: str) -> None:
        self.page.focus(f"[data-thing={thing}]")

    def press(self, *keys: str) -> None:
        for key in keys:
            self.page.keyboard.press(key)

    def field(self, label: str, value: str) -> None:
        """Type a value into a field of the inspector."""
        number = self.page.locator("#inspector").get_by_label(label, exact=True)
        number.fill(value)
        number.press("Enter")

    @property
    def said(self) -> str:
        return self.page.inner_text("#editor-said").replace("\u00a0", " ")

    @property
    def wrong(self) -> str:
        return self.page.inner_text("#plan-problems").replace("\u00a0", " ")


@contextmanager
def editing(
    browser: Browser,
    server: Running,
    room: dict[str, Any] = ROOM,
    *,
    language: str = "en",
    theme: str = "light",
    size: dict[str, int] = DESK,
    touch: bool = False,
    refused: int | None = None,
) -> Generator[Editor]:
    """Open the page of a room and put a room into it; at the end nothing may have gone wrong.

    Browsers note answers of the status that is "refused".
    """
    page = new_page(browser, server, size=size, language=language, theme=theme, touch=touch)
    try:
        editor = Editor(page)
        page.on("pageerror", lambda error: editor.console.append(str(error)))
        page.on("console", lambda one: editor.console.append(one.text) if one.type == "error" else None)
        for path in ("room", "simulate"):
            page.route(f"**/api/v1/{path}", lambda route: None)  # it is never answered
        # where each module is loaded by itself, so that a test can ask it
        page.goto(f"{server.address}/room/index.html")
        page.wait_for_selector("#plan .thing", state="attached")
        editor.take(room)
        yield editor
        assert [one for one in editor.console if refused is None or f"status of {refused}" not in one] == []
    finally:
        page.unroute_all(behavior="ignoreErrors")
        page.close()
