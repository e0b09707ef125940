"""Response spectra of motions, of one and of many at once."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from stayput.execution import Pool
from stayput.motion.record import Motion
from stayput.motion.response import DAMPING, PERIODS, ResponseSpectrum, checked_periods

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike

__all__ = ["DAMPING", "PERIODS", "ResponseSpectrum", "response_spectrum", "spectra"]


def response_spectrum(
    motion: Motion, periods: ArrayLike = PERIODS, damping: float = DAMPING, component: str = "x"
) -> ResponseSpectrum:
    """Return the response spectrum of one component of a motion.

    The oscillators start at rest. The motion is linear between its samples and the responses are exact
    for it (Nigam and Jennings 1969), with their peaks between samples; nothing is sought after the
    motion's end (see `Motion.padded`).

    Parameters
    ----------
    motion : Motion
        The floor's motion.
    periods : array_like, shape (m,)
        Natural periods, increasing, 1e-3 to 1e3 s.
    damping : float
        Damping ratio, 0 to 0.95.
    component : str
        "x", "y" or "z".

    Raises
    ------
    InputError
        Periods or a damping out of range; a component that the motion has not.

    Examples
    --------
    >>> import stayput as sp
    >>> sp.response_spectrum(sp.near_fault(), periods=[1.0]).sa.round(2).tolist()
    [12.34]
    """
    return Motion.given(motion).spectrum(periods, damping, component)


def spectra(
    motions: Sequence[Motion],
    periods: ArrayLike = PERIODS,
    damping: float = DAMPING,
    component: str = "x",
    *,
    threads: int | None = None,
) -> list[ResponseSpectrum]:
    """Return the response spectra of many motions, in their order, computed on several threads.

    Parameters
    ----------
    motions : sequence of Motion
        The motions.
    periods, damping, component
        As for `response_spectrum`.
    threads : int, optional
        Threads; as many as there are cores by default. The bits do not depend on them.
    """
    checked = checked_periods(periods)
    with Pool(threads) as pool:
        calls = (partial(response_spectrum, motion, checked, damping, component) for motion in motions)
        return list(pool.in_order(calls))
