"""The cache of synthetic motions: the same ones again, and no more bytes than it may hold."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

from stayput.motion.suites.synthesis import CACHE_SIZE, with_cache


def test_a_motion_is_made_once() -> None:
    cached = with_cache(CACHE_SIZE)
    assert cached("near-fault", 1, 1) is cached("near-fault", 1, 1)
    assert cached("near-fault", 1, 1) != cached("near-fault", 1, 2)


def test_the_cache_holds_no_more_bytes_than_it_may() -> None:
    most = 200_000
    cached = with_cache(most)
    first = cached("near-fault", 1, 0)
    each = sum(samples.nbytes for samples in first.components.values())
    for seed in range(1, 20):
        cached("near-fault", 1, seed)
        assert each <= cached.cache.currsize <= most
    again = cached("near-fault", 1, 0)
    assert again == first
    assert again is not first


def test_what_was_used_last_stays() -> None:
    cached = with_cache(200_000)
    used = cached("near-fault", 1, 0)
    for seed in range(1, 10):
        cached("near-fault", 1, seed)
        assert cached("near-fault", 1, 0) is used


def test_a_motion_that_two_threads_ask_for_counts_once() -> None:
    cached = with_cache(CACHE_SIZE)
    with ThreadPoolExecutor(4) as pool:
        motions = list(pool.map(lambda _: cached("crustal", 1, 7), range(8)))
    assert all(motion == motions[0] for motion in motions)
    assert cached.cache.currsize == sum(samples.nbytes for samples in motions[0].components.values())
