"""Synthetic motions that are kept in memory: the same ones again, and no more bytes than agreed."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

from stayput.motion.suites.kept import KeptMotions


def test_a_motion_is_made_once() -> None:
    kept = KeptMotions()
    assert kept.get("near-fault", 1, 1) is kept.get("near-fault", 1, 1)
    assert kept.get("near-fault", 1, 1) != kept.get("near-fault", 1, 2)


def test_no_more_bytes_are_kept_than_agreed_however_many_seeds() -> None:
    most = 200_000
    kept = KeptMotions(most)
    first = kept.get("near-fault", 1, 0)
    each = sum(samples.nbytes for samples in first.components.values())
    for seed in range(1, 20):
        kept.get("near-fault", 1, seed)
        assert each <= kept.size <= most
    again = kept.get("near-fault", 1, 0)
    assert again == first
    assert again is not first


def test_what_was_used_last_stays() -> None:
    kept = KeptMotions(200_000)
    used = kept.get("near-fault", 1, 0)
    for seed in range(1, 10):
        kept.get("near-fault", 1, seed)
        assert kept.get("near-fault", 1, 0) is used


def test_a_motion_that_two_threads_ask_for_counts_once() -> None:
    kept = KeptMotions()
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda _: kept.get("crustal", 1, 7), range(8)))
    assert all(motion == found[0] for motion in found)
    assert kept.size == sum(samples.nbytes for samples in found[0].components.values())
