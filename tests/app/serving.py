"""A real server on a free port of the loopback, in a thread, and a client of it."""

from __future__ import annotations

import threading
import time
from contextlib import contextmanager
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, NamedTuple

import httpx

from stayput.app import api
from stayput.app.server import address_of, bind, create_app, server_of
from waiting import wait_until

if TYPE_CHECKING:
    from collections.abc import Callable, Generator
    from types import ModuleType

    import pytest
    from fastapi import FastAPI
    from starlette.types import ASGIApp, Message, Receive, Scope, Send

    from stayput.app.limits import Limits

SCENE = {
    "dimensions": 2,  # quick, with every event; the others are in test_api_space.py
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


AS_BEFORE = "x-stayput-as-before"
"""Header of pages to which any run will do: all are answered with the first that one of them asked for."""


SIMULATE = "/api/v1/simulate"


class Remembered:
    """An app that simulates for its pages once: the same question gets the bytes of the first answer again.

    So do the files that pages are made of, seventy each. Programs are always answered by the app itself, as
    are pages about records, which may be gone by then.
    """

    def __init__(self, app: ASGIApp) -> None:
        self._app = app
        self._answers: dict[tuple[bytes | None, ...], list[Message]] = {}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        headers = dict(scope.get("headers", ()))
        path = scope.get("path", "")
        is_file = not path.startswith("/api/")
        if b"sec-fetch-mode" not in headers or not (is_file or path == SIMULATE):  # which browsers send
            await self._app(scope, receive, send)
            return
        asked: list[Message] = [await receive()]
        while asked[-1].get("more_body"):
            asked.append(await receive())
        body = b"".join(message.get("body", b"") for message in asked)
        question = b"" if AS_BEFORE.encode() in headers else body
        key = (path.encode(), question, headers.get(b"accept-encoding"), headers.get(b"accept-language"))
        answer: list[Message] = []

        async def receive_again() -> Message:
            return asked.pop(0) if asked else await receive()

        async def send_and_keep(message: Message) -> None:
            answer.append(message)
            await send(message)

        if key in self._answers:
            for message in self._answers[key]:
                await send(message)
            return
        await self._app(scope, receive_again, send_and_keep)
        if answer and answer[0]["status"] == 200 and (not question or b'"record"' not in body):
            self._answers[key] = answer


@contextmanager
def running(limits: Limits | None = None, *names: str, warming: bool = False) -> Generator[Running]:
    """Serve until the block ends."""
    app = create_app(names, limits, warming=warming)
    app.add_middleware(Remembered)
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


def hold_verifications(patched: pytest.MonkeyPatch) -> threading.Event:
    """Keep verifications at their first simulation until the event is set, however fast the machine is."""
    go_on, verify = threading.Event(), api.verify

    def held(scenario: Any, *, on_progress: Callable[[int, int], None], **more: Any) -> Any:
        while not go_on.wait(0.01):
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
