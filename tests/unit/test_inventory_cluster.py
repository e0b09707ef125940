"""Assessments on Dask clusters of processes, while workers and schedulers are killed: the same bytes."""

from __future__ import annotations

import sys

import pytest
from clusters import killed_when, two_processes, workers
from inventories import city, digests, pieces, table

import stayput as sp
from stayput.execution import DaskExecutor
from stayput.inventory import assess

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


@pytest.fixture(scope="module")
def client(expected):  # after it, so that the workers find compiled code
    assert expected
    with two_processes() as client:
        yield client


@pytest.fixture
def many_tasks(monkeypatch):
    monkeypatch.setattr("stayput.inventory.work.SECONDS", 0.02)
    monkeypatch.setattr("stayput.inventory.work.SAVE_AFTER", 0.0)


def test_a_cluster_gives_the_same_bytes(inputs, expected, client, tmp_path):
    said = []
    done = assess(*inputs, tmp_path / "out", client=client, progress=False, say=said.append)
    assert digests(done.folder) == expected
    assert said
    assert said[0].startswith("Dashboard of the cluster")


@pytest.mark.parametrize("kept", [0, 1, 4, 12, 30])
@pytest.mark.usefixtures("many_tasks")
def test_killed_workers_lose_nothing(inputs, expected, client, tmp_path, kept):
    """Killed when the outcomes of so many tasks are kept, of some fifty."""
    victim = list(workers(client).values())[kept % 2]
    outcomes = tmp_path / "out" / "work" / "units"
    with killed_when(client, victim, lambda: len(list(outcomes.glob("*.units"))) >= kept):
        done = assess(*inputs, tmp_path / "out", client=client, progress=False)
    assert digests(done.folder) == expected


def test_a_client_that_lost_its_scheduler_is_said(client, monkeypatch):
    from dask.distributed import Client

    monkeypatch.setattr("stayput.execution.WORKERS_CHECKED_EVERY", 0.0)
    with Client(client.cluster, set_as_default=False) as lost:
        executor = DaskExecutor(lost, cluster_lost="inventory.cluster_lost")
    with pytest.raises(sp.InputError, match="the same command goes on from it"):
        executor.width()


def test_a_scheduler_that_is_not_there_is_refused(inputs, tmp_path, monkeypatch):
    monkeypatch.setattr(sys.modules["stayput.inventory.assess"], "CONNECTING", 0.5)
    with pytest.raises(sp.InputError, match="could not be reached"):
        assess(*inputs, tmp_path / "out", scheduler="tcp://127.0.0.1:9", progress=False)
