"""Synthetic suites, which stand in where the user has no records, and the cache of their motions."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from cachetools import LRUCache, cached

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of
from stayput.model.parameters import arguments, quantity
from stayput.motion.processing import whole
from stayput.motion.suites.families import FAMILIES, KINDS, MIX
from stayput.motion.suites.suite import Suite
from stayput.motion.suites.synthesis import SEED_RANGE, synthetic_motion
from stayput.motion.suites.target import DEFAULT_BAND, TargetSpectrum

if TYPE_CHECKING:
    from collections.abc import Callable

    from stayput.motion.record import Motion

MIXED = "mixed"
"""Name of the suite of all families."""

COUNT_RANGE = (1, 1000)
"""Fewest and most motions of a suite."""

CACHE_SIZE = 128 * 1024 * 1024
"""Most bytes of samples in the cache: 40 mixed motions have 9 MB, 100 of the longest kind 60 MB."""


def _samples_size(motion: Motion) -> int:
    return sum(samples.nbytes for samples in motion.components.values())


def with_cache(size: int) -> Callable[[str, int, int], Motion]:
    """Return `synthetic_motion` with a cache of so many bytes; the least recently used motions go first."""
    cache: LRUCache[Any, Motion] = LRUCache(size, getsizeof=_samples_size)
    return cached(cache, lock=threading.Lock())(synthetic_motion)


_cached_motion = with_cache(CACHE_SIZE)
"""One cache for the process: a verification, its report and the next one ask for the same motions."""


def mixed_order(count: int) -> list[str]:
    """Return the families of the first ``count`` motions of a mixed suite.

    Each is the family that lags most behind its share, so that any first n motions have about the shares.
    """
    order: list[str] = []
    for place in range(1, count + 1):
        order.append(max(MIX, key=lambda family: MIX[family] * place - order.count(family)))
    return order


@arguments(
    count=quantity("", *COUNT_RANGE, phrase("motion.name_count"), "Number of motions."),
    seed=quantity("", *SEED_RANGE, phrase("motion.name_seed"), "The same seed gives the same motions."),
)
def synthetic_suite(
    family: str = MIXED,
    count: int = 40,
    seed: int = 1,
    target: TargetSpectrum | None = None,
    band: tuple[float, float] = DEFAULT_BAND,
    *,
    together: bool = False,
) -> Suite:
    """Make a suite of synthetic motions of three components.

    Their amplitudes are those of the magnitudes and distances that are drawn (scale them with
    `Suite.to_intensity` or `Suite.to_spectrum`) or, with a target, the target's. The first n motions of
    a larger suite are the suite of n. Motions stay in a cache for the next call.

    Parameters
    ----------
    family : str
        "near-fault", "crustal", "subduction", "basin", or "mixed": all, in the shares of ``MIX``.
    count : int
        Number of motions, 1 to 1,000.
    seed : int
        0 to 2³² − 1.
    target : TargetSpectrum, optional
        Spectrum to be met; see `Suite.matched`.
    band : (float, float)
        Periods over which the target counts [s].
    together : bool
        Whether only the suite's geometric mean meets the target: each motion is scaled to it, then one
        filter serves all, and the variability of their shapes stays.

    Raises
    ------
    InputError
        No such family; a count or a seed out of range; a band outside the target.

    Examples
    --------
    >>> import stayput as sp
    >>> for motion in sp.synthetic_suite("mixed", count=4).to_intensity(6.0):
    ...     print(f"{motion.name}: {motion.pga:.1f} m/s², {100 * motion.pgv:.0f} cm/s")
    synthetic crustal 1: 7.7 m/s², 33 cm/s
    synthetic subduction 1: 7.4 m/s², 101 cm/s
    synthetic near-fault 1: 6.2 m/s², 76 cm/s
    synthetic long-period basin 1: 6.5 m/s², 73 cm/s
    """
    if family not in (MIXED, *FAMILIES):
        raise InputError(
            "motion.unknown_family", "family", family=family, known=", ".join((MIXED, *FAMILIES))
        )
    if target is not None:
        instance_of("target", target, TargetSpectrum)
    n, number = whole("count", count, *COUNT_RANGE), whole("seed", seed, *SEED_RANGE)
    families = mixed_order(n) if family == MIXED else [family] * n
    counts = dict.fromkeys(FAMILIES, 0)
    motions: list[Motion] = []
    for member in families:
        counts[member] += 1
        motions.append(_cached_motion(member, counts[member], number))
    label = MIXED if family == MIXED else KINDS[family].label
    suite = Suite(tuple(motions), f"synthetic {label} suite, seed {number}")
    if target is None:
        return suite
    start = suite.to_spectrum(target, band) if together else suite
    return start.matched(target, band, together=together)
