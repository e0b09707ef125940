"""A real server on a free port of the loopback, in a thread, and a client of it."""

from __future__ import annotations

import threading
import time
from contextlib import contextmanager
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, NamedTuple

import httpx

from stayput.app import api
from stayput.app.addresses import address_of, bind
from stayput.app.server import create_app, server_of
from waiting import wait_until

if TYPE_CHECKING:
    from collections.abc import Callable, Generator
    from types import ModuleType

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
def running(limits: Limits | None = None, *names: str, warming: bool = False) -> Generator[Running]:
    """Serve until the block ends."""
    app = create_app(names, limits, warming=warming)
    bound = bind("127.0.0.1", 0)
    server = server_of(app)
    thread = threading.Thread(target=lambda: server.run(sockets=[bound]), daemon=True)
    thread.start()
    wait_until(lambda: server.started or not thread.is_alive())
    assert thread.is_alive()
    try:
        yield Running(address_of(bound).rstrip("/"), app)
    finally:
        server.should_exit = True
        thread.join(10.0)
        bound.close()


def client_of(server: Running) -> httpx.Client:
    return httpx.Client(base_url=server.address, timeout=COMPILING, trust_env=False)


def hold_verifications(patched: pytest.MonkeyPatch, least: int = 0) -> threading.Event:
    """Keep verifications at their first simulation until the event is set, however fast the machine is.

    Those of fewer options than ``least`` go on.
    """
    go_on, verify = threading.Event(), api.verify

    def held(scenario: Any, *, on_progress: Callable[[int, int], None], **more: Any) -> Any:
        while len(scenario.measures) >= least and not go_on.wait(0.01):
            on_progress(1, 1000)
        return verify(scenario, on_progress=on_progress, **more)

    patched.setattr(api, "verify", held)
    return go_on


class Clock:
    """The time that modules of the server see, which a test moves on without waiting.

    What is made gets the real time, so it is made before the clock is moved.
    """

    def __init__(self, patched: pytest.MonkeyPatch, *modules: ModuleType) -> None:
        self.ahead = 0.0
        for module in modules:
            patched.setattr(module, "time", SimpleNamespace(monotonic=self))

    def __call__(self) -> float:
        return time.monotonic() + self.ahead
