"""Assessments on a cluster that the command line starts, as on other machines: the same bytes."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from typing import TYPE_CHECKING

import pytest
from forks import start
from inventories import city, digests, pieces, table

import stayput as sp
from stayput.inventory import assess, work
from waiting import wait_until

if TYPE_CHECKING:
    from pathlib import Path

pytest.importorskip("dask.distributed", reason="Dask is not installed")
pytestmark = pytest.mark.processes


@pytest.fixture(scope="module")
def inputs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("inputs")
    return table(folder, pieces(120, 60)), city(folder)


@pytest.fixture(scope="module")
def expected(inputs, tmp_path_factory):
    done = assess(*inputs, tmp_path_factory.mktemp("expected") / "out", progress=False)
    return digests(done.folder)


def kill_the_scheduler(pid: int, said: Path, *inputs: Path, **given: object) -> None:
    """Kill it as soon as the first outcomes are kept, when most of the work is still to do."""

    def keep_and_kill(*arguments, write=work.write_records):
        write(*arguments)
        os.kill(pid, signal.SIGKILL)

    work.SECONDS, work.SAVE_AFTER, work.write_records = 0.005, 0.0, keep_and_kill
    try:
        assess(*inputs, **given)
    except sp.InputError as error:
        said.write_text(str(error))


class CommandLine:
    """A scheduler and workers that are started by the command line."""

    def __init__(self, folder: Path) -> None:
        self.file, self.processes = folder / "scheduler.json", []
        self.scheduler = self.start(
            "scheduler", "--port", "0", "--no-dashboard", "--scheduler-file", str(self.file)
        )
        wait_until(lambda: self.address)

    @property
    def address(self) -> str | None:
        try:
            return json.loads(self.file.read_text())["address"]
        except (OSError, ValueError):
            return None

    def start(self, *arguments: str) -> subprocess.Popen[bytes]:
        environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
        line = [sys.executable, "-m", "dask", *arguments, "--host", "127.0.0.1"]
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        self.processes.append(subprocess.Popen(line, env=environment, **quiet))
        return self.processes[-1]

    def worker(self) -> subprocess.Popen[bytes]:
        assert self.address
        return self.start("worker", self.address, "--nthreads", "1", "--no-dashboard", "--no-nanny")

    def stop(self) -> None:
        for process in self.processes:
            process.kill()
            process.wait()


@pytest.fixture
def command_line(tmp_path):
    made = CommandLine(tmp_path)
    yield made
    made.stop()


def test_workers_of_the_command_line_come_and_go(inputs, expected, command_line, tmp_path):
    first = command_line.worker()
    child = start(assess, *inputs, tmp_path / "out", scheduler=command_line.address, progress=False)
    wait_until(lambda: (tmp_path / "out" / "work" / "plan").exists() or not child.is_alive())
    command_line.worker()
    time.sleep(1.0)  # the second takes about so long to come; the first may go before or after
    first.kill()
    child.join()
    assert child.exitcode == 0
    assert digests(tmp_path / "out") == expected


def test_a_cluster_without_workers_is_said_and_waited_for(
    inputs, expected, command_line, tmp_path, monkeypatch
):
    monkeypatch.setattr("stayput.execution.WORKERS_CHECKED_EVERY", 0.1)
    monkeypatch.setattr("stayput.execution.PATIENCE", 0.0)
    said = []

    def say(text):
        said.append(text)
        if "no worker" in text:
            command_line.worker()

    assess(*inputs, tmp_path / "out", scheduler=command_line.address, progress=False, say=say)
    assert sum("no worker" in text for text in said) == 1
    assert digests(tmp_path / "out") == expected


def test_a_killed_scheduler_is_said_and_gone_on_from(inputs, expected, command_line, tmp_path):
    command_line.worker()
    said, pid = tmp_path / "said", command_line.scheduler.pid
    given = {"scheduler": command_line.address, "progress": False}
    child = start(kill_the_scheduler, pid, said, *inputs, tmp_path / "out", **given)
    child.join()
    assert "the same command goes on from it" in said.read_text()
    assess(*inputs, tmp_path / "out", progress=False)
    assert digests(tmp_path / "out") == expected
