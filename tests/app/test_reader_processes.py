"""An upload is read in a process of its own, which is bounded and gone with the server."""

from __future__ import annotations

import asyncio
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from serving import client_of, running
from test_api_uploads import RECORD, folder_of, upload

import stayput as sp
from stayput.app import motions, reader
from stayput.app.limits import MEBIBYTE, Limits
from stayput.app.motions import Readers
from stayput.errors import InputError
from waiting import wait_until

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from stayput.app.service import Service

LONG = "".join(f"{0.01 * i:.2f},{i % 7 - 3}\n" for i in range(200_000))
"""Takes a second or so to be read."""


@pytest.fixture
def own() -> Iterator[Readers]:
    found = Readers(Limits())
    yield found
    found.close()


def read(readers: Readers, path: Path, **options: Any) -> Any:
    """Read on a thread: in this one Chromium may have the event loop."""
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(lambda: asyncio.run(readers.read(path, **options))).result()


def test_motions_and_refusals_are_those_of_reading_here(tmp_path: Path, own: Readers) -> None:
    path = tmp_path / "記録.csv"
    path.write_text(RECORD)
    found, _ = read(own, path, unit="gal")
    assert found == sp.read_motion(path, unit="gal")
    assert not found.x.flags.writeable
    with pytest.raises(InputError) as here:
        sp.read_motion(path)
    with pytest.raises(InputError) as there:
        read(own, path)
    assert str(there.value).replace("“Unit”", "unit") == str(here.value)  # called by its control


def test_a_file_that_takes_too_long_is_refused_and_the_next_one_is_read() -> None:
    limits = replace(Limits(), reading_seconds=0.01)
    with running(limits) as server, client_of(server) as client:
        answer = upload(client, LONG, unit="gal")
        assert answer.status_code == 422, answer.text
        problem = answer.json()
        assert problem["message"] == (
            "The file takes more than 0.01 s to read; it must be a record in one of the known formats."
        )
        assert "0.01秒" in problem["message_ja"]
        assert not list(folder_of(server).iterdir())
        service: Service = server.app.state.service
        service.readers._limits = Limits()  # a small one takes less, but not on every machine
        (small := folder_of(server) / "small").write_text("1\n-1\n0\n" * 5)
        assert read(service.readers, small, unit="gal", dt=0.01)


def test_the_app_goes_on_while_a_file_is_stuck(monkeypatch: pytest.MonkeyPatch) -> None:
    """A process that sleeps stands for one that computes for ever; it is ended with the server."""
    with running(replace(Limits(), reading_seconds=1e4)) as server, client_of(server) as client:
        service: Service = server.app.state.service
        monkeypatch.setattr(motions, "START", "import time; time.sleep(1e5)")
        with ThreadPoolExecutor(1) as pool:
            answer = pool.submit(upload, client, RECORD, unit="gal")
            wait_until(lambda: service.readers._process)
            assert client.get("/api/v1/ping").status_code == 200
            assert not answer.done()
            service.readers.close()
            assert answer.result().status_code == 422
        stuck = service.readers._process
        assert stuck is not None
        assert stuck.poll() is not None


@pytest.mark.skipif(sys.platform != "linux", reason="other systems do not limit a process's memory")
def test_a_file_that_needs_too_much_memory_is_refused() -> None:
    limits = replace(Limits(), reading_memory=4 * MEBIBYTE)
    with running(limits) as server, client_of(server) as client:
        answer = upload(client, LONG, unit="gal")
        assert answer.status_code == 422, answer.text
        assert "memory" in answer.json()["message"] or "too much" in answer.json()["message"]
        assert answer.json()["message_ja"]
        assert client.get("/api/v1/ping").status_code == 200


def test_a_process_that_dies_is_the_end_of_its_file_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    with running() as server, client_of(server) as client:
        with monkeypatch.context() as patched:
            patched.setattr(motions, "START", "import os; os._exit(0)")
            answer = upload(client, RECORD, unit="gal")
        assert answer.status_code == 422
        assert "was ended" in answer.json()["message"]
        assert upload(client, RECORD, unit="gal").status_code == 201


def test_a_process_limits_its_memory_only_where_it_can(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "resource", None)  # as on Windows
    reader.limit_memory(MEBIBYTE)
    assert np.zeros(4 * MEBIBYTE, np.uint8).nbytes == 4 * MEBIBYTE
