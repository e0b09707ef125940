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
from typer.testing import CliRunner

from stayput.cli import app
from stayput.inventory import assess, work
from stayput.inventory.store import OutcomeStore
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


def typed(inventory: Path, scenario: Path, out: Path, address: str) -> object:
    line = "assess", inventory, "--scenario", scenario, "--out", out, "--scheduler", address
    return CliRunner().invoke(app, [str(argument) for argument in line])


def assess_by_line(said: Path, *arguments: object) -> None:
    """Run the command line in this process, and write what it says to a file as it ends."""
    result = typed(*arguments)
    said.write_text(result.output + str(result.exception or ""))


def kill_the_scheduler(pid: int, *arguments: object) -> None:
    """Kill it as soon as the first outcomes are kept, when most of the work is still to do."""

    def keep_and_kill(*records, save=OutcomeStore.save):
        save(*records)
        os.kill(pid, signal.SIGKILL)

    work.SECONDS, work.SAVE_AFTER, OutcomeStore.save = 0.005, 0.0, keep_and_kill
    assess_by_line(*arguments)


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


def test_workers_come_and_go(inputs, expected, command_line, tmp_path):
    """There is none at first, which is said."""
    said, out = tmp_path / "said", tmp_path / "out"
    child = start(assess_by_line, said, *inputs, out, command_line.address)
    wait_until(lambda: (out / "work" / "plan").exists() or not child.is_alive())
    first = command_line.worker()
    command_line.worker()
    time.sleep(1.0)  # they take about so long to come; either may be at work by then
    first.kill()
    child.join()
    assert "Dashboard of the cluster" in said.read_text()
    assert "The cluster has no worker" in said.read_text()
    assert digests(out) == expected


def test_a_killed_scheduler_is_said_and_gone_on_from(inputs, expected, command_line, tmp_path):
    command_line.worker()
    said, pid, out = tmp_path / "said", command_line.scheduler.pid, tmp_path / "out"
    child = start(kill_the_scheduler, pid, said, *inputs, out, command_line.address)
    child.join()
    assert "The executor is lost" in said.read_text()
    assess(*inputs, out, progress=False)
    assert digests(out) == expected


def test_a_scheduler_that_is_not_there_is_refused(inputs, tmp_path, monkeypatch):
    monkeypatch.setattr("stayput.cli.assess.CONNECTING", 0.5)
    result = typed(*inputs, tmp_path / "out", "tcp://127.0.0.1:9")
    assert result.exit_code == 2
    assert "could not be reached" in str(result.exception) + result.output
