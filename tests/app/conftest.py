"""A server for all tests of the app, a client of it, Chromium, and the pages in it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from browsing import CHROMIUM, IN_PLANE, Opened, browser, opened, webgl
from room_editing import Editor, editing
from room_judge import Judge, begin_anew, room_page
from serving import Running, client_of, running

if TYPE_CHECKING:
    from collections.abc import Iterator

    import httpx
    from playwright.sync_api import Browser


__all__ = ["browser", "webgl"]

HERE = Path(__file__).parent


@pytest.hookimpl(trylast=True)
def pytest_runtest_teardown(nextitem: pytest.Item | None) -> None:
    """Close Chromium before other tests."""
    if nextitem is not None and not nextitem.path.is_relative_to(HERE):
        CHROMIUM.close()


def pytest_sessionfinish() -> None:
    """Close Chromium after all tests; not after the last one, which may be run again."""
    CHROMIUM.close()


@pytest.fixture(scope="session")
def server() -> Iterator[Running]:
    with running() as found:
        yield found


@pytest.fixture
def client(server: Running) -> Iterator[httpx.Client]:
    with client_of(server) as found:
        yield found


@pytest.fixture(scope="module")
def opened_room(browser: Browser, server: Running) -> Iterator[tuple[Opened, Judge]]:
    judge = Judge()
    with room_page(browser, server, judge) as found:
        yield found, judge


@pytest.fixture
def judge(opened_room: tuple[Opened, Judge]) -> Judge:
    """What answers about rooms in the server's place."""
    begin_anew(*opened_room)
    return opened_room[1]


@pytest.fixture
def it(request: pytest.FixtureRequest, browser: Browser, server: Running) -> Iterator[Opened]:
    """The page of one piece; where a judge answers that of a room, one for all tests of a module."""
    if "judge" not in request.fixturenames:
        with opened(browser, server, IN_PLANE) as found:
            yield found
        return
    request.getfixturevalue("judge")
    found, _ = request.getfixturevalue("opened_room")
    yield found
    found.check()


@pytest.fixture(scope="module")
def opened_editor(browser: Browser, server: Running) -> Iterator[Editor]:
    with editing(browser, server) as found:
        yield found


@pytest.fixture
def editor(opened_editor: Editor) -> Iterator[Editor]:
    """The editor with the usual room in it: one page for all tests of a module."""
    opened_editor.begin_anew()
    yield opened_editor
    assert opened_editor.console == []
