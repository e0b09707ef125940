"""A real server on a free port of the loopback, in a thread, and a client of it."""

from __future__ import annotations

import threading
import time
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, NamedTuple

import httpx

from stayput.app import api
from stayput.app.addresses import address_of, bind
from stayput.app.server import create_app, server_of

if TYPE_CHECKING:
    from collections.abc import Callable, Generator

    import pytest
    from fastapi import FastAPI

    from stayput.app.limits import Limits

SCENE = {
    "furniture": {"preset": "bookcase"},
    "room": {"floor": "wood flooring", "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}},
    "shaking": {"builtin": "near-fault"},
}


COMPILING = 300.0
"""How long an answer may take where the kernels are compiled first, on a slow machine [s]."""


class Running(NamedTuple):
    """A server that runs."""

    address: str
    app: FastAPI


@contextmanager
def running(limits: Limits | None = None, *, warming: bool = False) -> Generator[Running]:
    """Serve until the block ends."""
    app = create_app("127.0.0.1", limits, warming=warming)
    bound = bind("127.0.0.1", 0)
    server = server_of(app)
    thread = threading.Thread(target=lambda: server.run(sockets=[bound]), daemon=True)
    thread.start()
    while not server.started:
        assert thread.is_alive()
        time.sleep(0.01)
    try:
        yield Running(address_of(bound).rstrip("/"), app)
    finally:
        server.should_exit = True
        thread.join(10.0)
        bound.close()


def client_of(server: Running) -> httpx.Client:
    return httpx.Client(base_url=server.address, timeout=COMPILING, trust_env=False)


def hold_verifications(patched: pytest.MonkeyPatch) -> threading.Event:
    """Keep verifications at their first simulation until the event is set, however fast the machine is."""
    go_on, verify = threading.Event(), api.verify

    def held(scenario: Any, *, on_progress: Callable[[int, int], None], **more: Any) -> Any:
        while not go_on.wait(0.01):
            on_progress(1, 1000)
        return verify(scenario, on_progress=on_progress, **more)

    patched.setattr(api, "verify", held)
    return go_on
