"""The synthetic suites: the motions that stand in where the user has no records."""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.errors import InputError
from stayput.motion.suites.families import FAMILIES, KINDS, MIX
from stayput.motion.suites.kept import KeptMotions
from stayput.motion.suites.suite import Suite
from stayput.motion.suites.synthesis import whole
from stayput.motion.suites.target import DEFAULT_BAND

if TYPE_CHECKING:
    from stayput.motion.record import Motion
    from stayput.motion.suites.target import TargetSpectrum

MIXED = "mixed"
"""Name of the suite of all families."""

_kept = KeptMotions()


def mixed_order(count: int) -> list[str]:
    """Return the families of the first ``count`` motions of a mixed suite: always the one most behind."""
    order: list[str] = []
    for place in range(1, count + 1):
        order.append(max(MIX, key=lambda family: MIX[family] * place - order.count(family)))
    return order


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
    a larger suite are the suite of n. Motions are kept in memory for the next call.

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
    """
    if family not in (MIXED, *FAMILIES):
        raise InputError(f"The family is {family!r}; it must be one of {', '.join((MIXED, *FAMILIES))}.")
    n = whole("Number of motions", count, 1, 1000)
    number = whole("Seed", seed, 0, 2**32 - 1)
    families = mixed_order(n) if family == MIXED else [family] * n
    seen = dict.fromkeys(FAMILIES, 0)
    motions: list[Motion] = []
    for one in families:
        seen[one] += 1
        motions.append(_kept.get(one, seen[one], number))
    label = MIXED if family == MIXED else KINDS[family].label
    suite = Suite(tuple(motions), f"synthetic {label} suite, seed {number}")
    if target is None:
        return suite
    start = suite.to_spectrum(target, band) if together else suite
    return start.matched(target, band, together=together)
