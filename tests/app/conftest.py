"""A server for all tests of the app, a client of it, and Chromium."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest
from browsing import browser, chromium, webgl
from serving import Running, client_of, running

if TYPE_CHECKING:
    from collections.abc import Iterator

    import httpx


__all__ = ["browser", "chromium", "webgl"]


@pytest.fixture(scope="session")
def server() -> Iterator[Running]:
    with running() as found:
        yield found


@pytest.fixture
def client(server: Running) -> Iterator[httpx.Client]:
    with client_of(server) as found:
        yield found
