"""The same work on a Dask cluster of processes, and after one of them was killed."""

import os

import numpy as np
import pytest
from clusters import killed_when, two_processes, workers

import stayput as sp
from stayput import execution
from stayput.execution import Call, DaskExecutor, Shared

pytest.importorskip("dask.distributed", reason="Dask is not installed")
pytestmark = pytest.mark.processes

CASE = sp.Case(sp.Body(0.4, 1.8, 100.0), sp.Room(right_wall=sp.Wall(0.1)), sp.near_fault())
AXES = {
    "body.width": np.linspace(0.2, 0.6, 30),
    "room.right_wall.gap": np.linspace(0.0, 0.3, 20),
    "motion": [sp.near_fault(), sp.sine(5.0, 1.0, 10.0)],
    "motion.scale": np.linspace(0.5, 1.5, 8),
}


@pytest.fixture(scope="module")
def client():
    sp.sweep(CASE, {"motion.scale": [1.0]})  # so that the workers find compiled code
    with two_processes() as client:
        yield client


@pytest.fixture(scope="module")
def expected():
    return sp.sweep(CASE, AXES)


def test_a_cluster_gives_the_same_bits(client, expected):
    assert sp.sweep(CASE, AXES, client=client, chunk=500).identical(expected)


def test_a_killed_worker_loses_nothing(client, expected):
    address, victim = next(iter(workers(client).items()))
    with killed_when(client, victim, lambda: bool(client.processing([address])[address])):
        found = sp.sweep(CASE, AXES, client=client, chunk=40)
    assert found.identical(expected)


def test_an_error_on_the_cluster_comes_back(client):
    with pytest.raises(sp.InputError, match="Body width"):
        sp.sweep(CASE, {"body.width": [0.3, -1.0]}, client=client)


def test_shared_values_are_computed_on_the_cluster(client):
    base = Shared.value(3)
    cubes = Shared(pow, base, 3)
    with DaskExecutor(client) as executor:
        assert list(executor.in_order(Call(divmod, cubes, n) for n in range(1, 30))) == [
            divmod(27, n) for n in range(1, 30)
        ]
        with pytest.raises(ZeroDivisionError):
            list(executor.in_order(Call(divmod, cubes, n) for n in (1, 0)))


def test_a_call_that_ends_its_workers_is_given_up(client, monkeypatch):
    monkeypatch.setattr(execution, "MOST_TRIES", 1)
    monkeypatch.setattr(client.cluster.scheduler, "allowed_failures", 0)  # one worker's death is enough
    with (
        DaskExecutor(client) as executor,
        pytest.raises(sp.InputError, match="ended 1 times"),
    ):
        list(executor.in_order([Call(os._exit, 1)]))
    workers(client)  # for the tests that follow


def test_a_worker_of_another_version_is_refused(client, monkeypatch):
    monkeypatch.setattr(sp, "__version__", "0.0.0")
    with DaskExecutor(client) as executor, pytest.raises(sp.InputError, match="that of this command"):
        list(executor.in_order([Call(pow, 2, 3)]))


def test_a_lost_scheduler_is_told(client, monkeypatch):
    from dask.distributed import Client

    monkeypatch.setattr(execution, "WORKERS_CHECKED_EVERY", 0.0)
    with Client(client.cluster, set_as_default=False) as lost:
        pass
    with pytest.raises(sp.InputError, match="The cluster is gone"):
        sp.sweep(CASE, {"motion.scale": [1.0]}, client=lost)


def test_a_cluster_without_workers_is_told_once(client, monkeypatch):
    monkeypatch.setattr(execution, "WORKERS_CHECKED_EVERY", 0.0)
    monkeypatch.setattr(execution, "PATIENCE", 0.0)
    said = []
    with DaskExecutor(client, said.append) as executor:
        monkeypatch.setattr(client, "scheduler_info", lambda **_: {"workers": {}})
        for _ in range(3):
            assert executor.width() == 1
    assert said == ["The cluster has no worker; waiting for one."]
