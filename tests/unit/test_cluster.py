"""The same work on a Dask cluster of processes, and after one of them was killed."""

import os
from functools import partial

import numpy as np
import pytest
from clusters import killed_when, two_processes, workers

import stayput as sp
from stayput.execution import Pool

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
    assert sp.sweep(CASE, AXES, executor=client.get_executor(), chunk=500).identical(expected)


def test_a_killed_worker_loses_nothing(client, expected):
    address, victim = next(iter(workers(client).items()))
    with killed_when(client, victim, lambda: bool(client.processing([address])[address])):
        found = sp.sweep(CASE, AXES, executor=client.get_executor(), chunk=40)
    assert found.identical(expected)


def test_a_lost_scheduler_is_told(client):
    from dask.distributed import Client

    with Client(client.cluster, set_as_default=False) as lost:
        executor = lost.get_executor()
    with pytest.raises(sp.InputError, match="The executor is lost"):
        sp.sweep(CASE, {"motion.scale": [1.0]}, executor=executor)


def test_a_call_that_ends_its_workers_is_given_up(client, monkeypatch):
    monkeypatch.setattr(client.cluster.scheduler, "allowed_failures", 0)  # one worker's death is enough
    with Pool(2, client.get_executor()) as pool, pytest.raises(sp.InputError, match="lost \\(KilledWorker"):
        list(pool.in_order([partial(os._exit, 1)]))
    workers(client)  # for the tests that follow
