"""A server for all tests of the app, a client of it, Chromium, and the pages in it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from browsing import Opened, browser, chromium, opened, webgl
from room_editing import Editor, editing
from room_judge import Judge, begin_anew, room_page
from serving import Running, client_of, running

if TYPE_CHECKING:
    from collections.abc import Iterator

    import httpx
    from playwright.sync_api import Browser


__all__ = ["browser", "chromium", "webgl"]


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
        with opened(browser, server) as found:
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
