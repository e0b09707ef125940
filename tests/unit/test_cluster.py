"""The same work on a Dask cluster of processes, and after one of them was killed."""

import os
import signal
import threading
import time

import numpy as np
import pytest

import stayput as sp

distributed = pytest.importorskip("dask.distributed", reason="Dask is not installed")

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
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, host="127.0.0.1"
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


@pytest.fixture(scope="module")
def expected():
    return sp.sweep(CASE, AXES)


def test_a_cluster_gives_the_same_bits(client, expected):
    assert sp.sweep(CASE, AXES, client=client, chunk=500).identical(expected)


def test_a_killed_worker_loses_nothing(client, expected):
    before = client.run(os.getpid)
    victim = next(iter(before.values()))
    killed = []

    def kill():
        os.kill(victim, signal.SIGKILL)
        killed.append(time.monotonic())

    timer = threading.Timer(0.2, kill)
    timer.start()
    found = sp.sweep(CASE, AXES, client=client, chunk=40)
    finished = time.monotonic()
    timer.join()
    assert killed[0] < finished  # it was killed while there was work
    assert found.identical(expected)


def test_an_error_on_the_cluster_comes_back(client):
    with pytest.raises(sp.InputError, match="Body width"):
        sp.sweep(CASE, {"body.width": [0.3, -1.0]}, client=client)
