"""A server for all tests of the app, a client of it, Chromium, and the pages in it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from browsing import Opened, browser, chromium, opened, webgl
from room_editing import Editor, editing
from room_judge import Judge, room_page
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


@pytest.fixture
def judge() -> Judge:
    """What answers about rooms in the server's place."""
    return Judge()


@pytest.fixture
def it(request: pytest.FixtureRequest, browser: Browser, server: Running) -> Iterator[Opened]:
    """The page of one piece; that of a room where a judge answers about it."""
    of_room = "judge" in request.fixturenames
    judge = request.getfixturevalue("judge") if of_room else None
    with room_page(browser, server, judge) if judge else opened(browser, server) as found:
        yield found


@pytest.fixture
def editor(browser: Browser, server: Running) -> Iterator[Editor]:
    """The editor with the usual room in it."""
    with editing(browser, server) as found:
        yield found
