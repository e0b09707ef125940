"""Assessments on a cluster, as on other machines: the same bytes."""

from __future__ import annotations

from threading import Thread
from typing import TYPE_CHECKING, Any

import pytest
from clusters import killed_when, two_processes, workers
from commands import cli
from inventories import city, digests, pieces, table

from stayput.inventory import assess
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


def assessed(inputs: tuple[Path, Path], out: Path, address: str) -> Any:
    inventory, scenario = inputs
    return cli("assess", inventory, "--scenario", scenario, "--out", out, "--scheduler", address)


def test_a_killed_worker_changes_nothing(inputs, expected, tmp_path):
    out = tmp_path / "out"
    with two_processes() as client:
        victim = next(iter(workers(client).values()))
        with killed_when(client, victim, (out / "work" / "plan.sqlite").exists):
            done = assessed(inputs, out, client.cluster.scheduler_address)
    assert done.exit_code == 0, done.output
    assert digests(out) == expected


def test_workers_may_come_later_which_is_said(inputs, expected, tmp_path):
    from dask.distributed import LocalCluster

    out = tmp_path / "out"
    with LocalCluster(n_workers=0, processes=False, protocol="tcp", dashboard_address=None) as cluster:

        def add_a_worker() -> None:
            wait_until((out / "work" / "plan.sqlite").exists)
            cluster.scale(1)

        late = Thread(target=add_a_worker)
        late.start()
        done = assessed(inputs, out, cluster.scheduler_address)
        late.join()
    assert "Dashboard of the cluster" in done.stderr
    assert "The cluster has no worker" in done.stderr
    assert digests(out) == expected


def test_a_scheduler_that_is_not_there_is_refused(inputs, tmp_path, monkeypatch):
    monkeypatch.setattr("stayput.cli.assess.CONNECTING", 0.5)
    done = assessed(inputs, tmp_path / "out", "tcp://127.0.0.1:9")
    assert done.exit_code == 2
    assert "could not be reached" in done.stderr
