"""Uploads are read in a process of their own, which is bounded, replaced, and gone with the server."""

from __future__ import annotations

import asyncio
import os
import re
import signal
import subprocess
import sys
import threading
from dataclasses import replace
from types import SimpleNamespace
from typing import TYPE_CHECKING, ClassVar

import numpy as np
import pytest
from serving import client_of, running
from test_api_uploads import RECORD, folder_of, upload

import stayput as sp
from stayput.app import reader
from stayput.app.limits import MEBIBYTE, Limits
from stayput.app.readers import Reader
from stayput.errors import InputError, warn
from waiting import PATIENCE, wait_until

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from stayput.app.service import Service

LONG = "".join(f"{0.01 * i:.2f},{i % 7 - 3}\n" for i in range(200_000))
"""Takes a second or so to be read."""

START = "from stayput.cli import main; main()"
ON_POSIX = pytest.mark.skipif(os.name != "posix", reason="signals and limits of memory are those of POSIX")


@pytest.fixture
def own() -> Iterator[Reader]:
    found = Reader(Limits())
    yield found
    found.close()


def children(parent: int) -> set[int]:
    """The processes that a process has started and that are still there."""
    told = subprocess.run(["ps", "-A", "-o", "pid=,ppid=,stat="], capture_output=True, text=True, check=True)
    rows = [line.split() for line in told.stdout.splitlines()]
    return {int(pid) for pid, of, state in rows if int(of) == parent and not state.startswith("Z")}


def alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    told = subprocess.run(["ps", "-o", "stat=", "-p", str(pid)], capture_output=True, text=True, check=False)
    return bool(told.stdout.strip()) and not told.stdout.strip().startswith("Z")


def gone(pids: set[int]) -> bool:
    """Wait for the end of processes."""
    wait_until(lambda: not any(map(alive, pids)))
    return True


def test_a_motion_is_the_one_that_is_read_here(tmp_path: Path, own: Reader) -> None:
    path = tmp_path / "record.csv"
    path.write_text(RECORD)
    found, _ = asyncio.run(own.read(path, unit="gal"))
    here = sp.read_motion(path, unit="gal")
    assert found == here
    assert not found.x.flags.writeable


@pytest.mark.parametrize("text", ["", "hello\n", "0.0,nan\n", "0.0,1\n0.5,1\n0.51,1\n", RECORD])
def test_refusals_are_the_same_as_here(tmp_path: Path, own: Reader, text: str) -> None:
    path = tmp_path / "記録.csv"
    path.write_text(text)
    with pytest.raises(InputError) as here:
        sp.read_motion(path)
    with pytest.raises(InputError) as there:
        asyncio.run(own.read(path))
    assert str(there.value) == str(here.value)


def test_warnings_come_across(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def read_shaking(*_: object, **__: object) -> sp.Motion:
        warn("It is very strong.")
        return sp.sine(1.0, 1.0, 2.0)

    path = tmp_path / "a"
    path.write_text("1")
    monkeypatch.setattr(reader, "read_shaking", read_shaking)
    task = reader.ReadingTask(str(path), None, None, None, False, Limits())
    assert reader.read(task).warnings == ("It is very strong.",)


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
        service.reader._limits = Limits()  # a small one takes less, but not on every machine
        assert asyncio.run(service.reader.read(_small(folder_of(server)), unit="gal", dt=0.01))


def _small(folder: Path) -> Path:
    path = folder / "small"
    path.write_text("1\n-1\n0\n" * 5)
    return path


class Patience:
    """Stands for the timers of the readers: it runs out when the test says so."""

    all: ClassVar[list[Patience]] = []

    def __init__(self, seconds: float, end: Callable[[], None]) -> None:
        self.seconds, self.end, self.daemon = seconds, end, False

    def start(self) -> None:
        self.all.append(self)

    def cancel(self) -> None:
        self.all.remove(self)


@ON_POSIX
def test_the_app_goes_on_while_a_file_is_stuck(monkeypatch: pytest.MonkeyPatch) -> None:
    """A process that is stopped stands for one that computes for ever."""
    monkeypatch.setattr(Patience, "all", [])
    with_patience = SimpleNamespace(**{**vars(threading), "Timer": Patience})
    monkeypatch.setattr("stayput.app.readers.threading", with_patience)
    others = _readers()  # other tests' servers have theirs
    with running() as server, client_of(server) as client:
        assert upload(client, RECORD, unit="gal").status_code == 201
        (stuck,) = children(os.getpid()) & _readers() - others
        os.kill(stuck, signal.SIGSTOP)
        answers: list[int] = []
        thread = threading.Thread(
            target=lambda: answers.append(upload(client, RECORD, unit="gal").status_code)
        )
        thread.start()
        wait_until(lambda: Patience.all)  # it has got its file
        (patience,) = Patience.all
        assert patience.seconds == Limits().reading_seconds
        assert client.get("/api/v1/ping").status_code == 200
        assert not answers
        patience.end()
        thread.join()
        assert answers == [422]
        assert gone({stuck})
        assert upload(client, RECORD, unit="gal").status_code == 201


def _readers() -> set[int]:
    told = subprocess.run(["ps", "-A", "-ww", "-o", "pid=,args="], capture_output=True, text=True, check=True)
    return {int(line.split()[0]) for line in told.stdout.splitlines() if "stayput.app.reader" in line}


@pytest.mark.skipif(sys.platform != "linux", reason="other systems do not limit a process's memory")
def test_a_file_that_needs_too_much_memory_is_refused() -> None:
    limits = replace(Limits(), reading_memory=4 * MEBIBYTE)
    with running(limits) as server, client_of(server) as client:
        answer = upload(client, LONG, unit="gal")
        assert answer.status_code == 422, answer.text
        assert "memory" in answer.json()["message"] or "too much" in answer.json()["message"]
        assert answer.json()["message_ja"]
        assert client.get("/api/v1/ping").status_code == 200


@ON_POSIX
def test_a_process_that_died_while_it_waited_is_not_the_file_s_fault(tmp_path: Path, own: Reader) -> None:
    path = tmp_path / "record.csv"
    path.write_text(RECORD)
    others = _readers()
    asyncio.run(own.read(path, unit="gal"))
    (first,) = children(os.getpid()) & _readers() - others
    os.kill(first, signal.SIGKILL)
    assert gone({first})
    found, _ = asyncio.run(own.read(path, unit="gal"))
    assert found == sp.read_motion(path, unit="gal")


@ON_POSIX
@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_no_process_outlives_the_server(how: signal.Signals) -> None:
    command = [sys.executable, "-c", START, "app", "--port", "0", "--no-browser"]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdout=pipe, stderr=pipe, text=True) as started:
        try:
            assert started.stdout is not None
            assert re.search(r"http://127\.0\.0\.1:\d+", started.stdout.readline())
            wait_until(lambda: children(started.pid) & _readers(), every=0.1)
            found = children(started.pid) & _readers()
            started.send_signal(how)
            _, told = started.communicate(timeout=PATIENCE)
        finally:
            started.kill()
    assert gone(found)
    assert "Traceback" not in told


def test_a_process_limits_its_memory_only_where_it_can(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "resource", None)  # as on Windows
    reader.limit_memory(MEBIBYTE)
    assert np.zeros(4 * MEBIBYTE, np.uint8).nbytes == 4 * MEBIBYTE
