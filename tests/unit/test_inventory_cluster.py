"""Assessments on Dask clusters of processes, while workers and schedulers are killed: the same bytes."""

from __future__ import annotations

import pytest
from clusters import killed_when, two_processes, workers
from inventories import city, digests, pieces, table

from stayput.inventory import assess
from stayput.inventory.store import OutcomeStore

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
    done = assess(*inputs, tmp_path / "out", executor=client.get_executor(), progress=False)
    assert digests(done.folder) == expected


@pytest.mark.parametrize("kept", [0, 1, 12])
@pytest.mark.usefixtures("many_tasks")
def test_killed_workers_lose_nothing(inputs, expected, client, tmp_path, monkeypatch, kept):
    """Killed when outcomes were kept so many times, of some fifty."""
    victim = list(workers(client).values())[kept % 2]
    saved, save = [], OutcomeStore.save
    monkeypatch.setattr(OutcomeStore, "save", lambda *arguments: saved.append(save(*arguments)))
    with killed_when(client, victim, lambda: len(saved) >= kept):
        done = assess(*inputs, tmp_path / "out", executor=client.get_executor(), progress=False)
    assert digests(done.folder) == expected
