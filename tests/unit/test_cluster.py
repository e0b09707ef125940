"""The same work on a Dask cluster of processes, and after one of them was killed."""

import numpy as np
import pytest
from clusters import killed_when, two_processes, workers

import stayput as sp

pytest.importorskip("dask.distributed", reason="Dask is not installed")

CASE = sp.Case(sp.Body(0.4, 1.8), sp.Room(right_wall=sp.Wall(0.1)), sp.near_fault())
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
    death = killed_when(client, victim, lambda: bool(client.processing([address])[address]))
    found = sp.sweep(CASE, AXES, client=client, chunk=40)
    death.result()
    assert found.identical(expected)


def test_an_error_on_the_cluster_comes_back(client):
    with pytest.raises(sp.InputError, match="Body width"):
        sp.sweep(CASE, {"body.width": [0.3, -1.0]}, client=client)
