"""Assessments on a cluster that the command line starts, as on other machines: the same bytes."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from typing import TYPE_CHECKING

import pytest
from inventories import city, command, digests, pieces, started, table

from stayput.inventory import assess

if TYPE_CHECKING:
    from pathlib import Path

pytest.importorskip("dask.distributed", reason="Dask is not installed")

WAIT = 180.0
"""Processes may take so long to start on a machine that has much else to do [s]."""


@pytest.fixture(scope="module")
def inputs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("inputs")
    return table(folder, pieces(120, 60)), city(folder)


@pytest.fixture(scope="module")
def expected(inputs, tmp_path_factory):
    done = assess(*inputs, tmp_path_factory.mktemp("expected") / "out", progress=False)
    return digests(done.folder)


KILLS = """
import json, os, signal, sys
from stayput.inventory import assess, work

def keep_and_kill(*arguments, write=work.write_records):
    write(*arguments)
    os.kill(int(sys.argv[1]), signal.SIGKILL)

work.SECONDS, work.SAVE_AFTER, work.write_records = 0.005, 0.0, keep_and_kill
assess(**json.loads(sys.argv[2]))
"""
"""Kills the scheduler as soon as the first outcomes are kept, when most of the work is still to do."""


class CommandLine:
    """A scheduler and workers that are started by the command line."""

    def __init__(self, folder: Path) -> None:
        self.file, self.processes = folder / "scheduler.json", []
        self.scheduler = self.start(
            "scheduler", "--port", "0", "--no-dashboard", "--scheduler-file", str(self.file)
        )
        until = time.monotonic() + WAIT
        while not self.address:
            assert time.monotonic() < until
            time.sleep(0.05)

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
    child = started(command(*inputs, tmp_path / "out", scheduler=command_line.address))
    _wait_for(lambda: (tmp_path / "out" / "work" / "plan").exists(), child)
    command_line.worker()
    time.sleep(1.0)
    first.kill()
    assert child.wait(WAIT) == 0, child.stderr.read()
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
    said = {"inventory": str(inputs[0]), "scenario": str(inputs[1]), "out": str(tmp_path / "out")}
    said |= {"scheduler": command_line.address, "progress": False}
    child = started([sys.executable, "-c", KILLS, str(command_line.scheduler.pid), json.dumps(said)])
    assert child.wait(WAIT) != 0
    assert "the same command goes on from it" in " ".join(child.stderr.read().decode().split())
    assess(*inputs, tmp_path / "out", progress=False)
    assert digests(tmp_path / "out") == expected


def _wait_for(there, child) -> None:
    until = time.monotonic() + WAIT
    while not there():
        assert child.poll() is None, child.stderr.read()
        assert time.monotonic() < until
        time.sleep(0.01)
