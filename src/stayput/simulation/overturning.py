"""`overturning_map`: at which amplitudes of its motion a case overturns, at samples of the amplitude."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.errors import InputError, instance_of
from stayput.simulation.outcome import Outcome
from stayput.simulation.sweep import sweep

if TYPE_CHECKING:
    from concurrent.futures import Executor

    import xarray as xr
    from numpy.typing import ArrayLike, NDArray

    from stayput.simulation.axes import Axes
    from stayput.simulation.case import Case

SCALE = "motion.scale"
"""The path of the amplitude: the factor on the motion's acceleration."""

FALLEN = [list(Outcome).index(outcome) for outcome in (Outcome.OVERTURNED, Outcome.FAILED)]
"""Numbers of the outcomes that count as a fall; a run that is given up never counts as standing."""


def overturning_map(
    case: Case,
    amplitudes: ArrayLike,
    axes: Axes | None = None,
    *,
    threads: int | None = None,
    executor: Executor | None = None,
    progress: bool | None = None,
) -> xr.Dataset:
    """Sample whether a case overturns, over the amplitude of its motion and other axes.

    Parameters
    ----------
    case : Case
        The base case: what no axis changes.
    amplitudes : array_like, shape (n,)
        Factors on the motion's acceleration, none negative, increasing.
    axes : mapping, optional
        Other axes, as for `sweep`; a *point* is a combination of their values.
    threads, executor, progress
        As for `simulate_many`.

    Returns
    -------
    xarray.Dataset
        Over the axes and ``motion.scale``: ``overturned``; ``failed``, which does not count as standing;
        ``floor_impacts``, those before the fall where it falls. Over the axes: ``first``, the lowest
        amplitude sampled at which it falls; ``last``, the lowest from which on it falls at all;
        ``fraction`` of the amplitudes at which it falls; ``islands``, the number of ranges in which it
        stands between two at which it falls. A given-up run counts as a fall in these four. NaN where there
        is no such amplitude: no ``first`` where it never falls, no ``last`` where it stands at the highest.
        The attributes say how wide a range must be not to be missed.

    Raises
    ------
    InputError
        Amplitudes that are not as above, ``motion.scale`` among the axes, or as for `sweep`.

    Examples
    --------
    >>> import stayput as sp
    >>> wave = sp.sine(9.81, 2.0, 0.5, quiet=10.0)
    >>> case = sp.Case(sp.Body(0.4, 1.8, 100.0), sp.Room(sp.Floor(3.0, 3.0)), wave)
    >>> result = overturning_map(case, [0.4, 0.5, 1.2, 1.33, 1.4, 1.5])
    >>> result.overturned.values.tolist()
    [False, True, True, False, True, True]
    >>> float(result["first"]), float(result["last"]), int(result["islands"])
    (0.5, 1.4, 1)
    """
    sampled = checked_amplitudes(amplitudes, axes)
    data = sweep(
        case, {**(axes or {}), SCALE: sampled}, threads=threads, executor=executor, progress=progress
    )
    falls = data["outcome"].isin(FALLEN)
    failed = data["outcome"] == list(Outcome).index(Outcome.FAILED)
    failed.attrs["long_name"] = "whether the run was given up"
    downward = falls.isel({SCALE: slice(None, None, -1)})
    falls_above = downward.cumprod(SCALE).astype(bool)
    back = (falls & ~falls.shift({SCALE: -1}, fill_value=True)).sum(SCALE)
    open_top = falls.any(SCALE) & ~falls.isel({SCALE: -1}, drop=True)
    summaries = {
        "first": (falls[SCALE].where(falls).min(SCALE), "lowest amplitude sampled at which it falls"),
        "last": (
            falls[SCALE].where(falls_above).min(SCALE),
            "lowest amplitude sampled above which none stands",
        ),
        "fraction": (falls.mean(SCALE), "part of the amplitudes at which it falls"),
        "islands": (back - open_top, "number of ranges of standing between two of falling"),
    }
    result = data[["overturned", "floor_impacts"]].assign(failed=failed)
    for name, (values, meaning) in summaries.items():
        result[name] = values.assign_attrs(long_name=meaning)
    return result.assign_attrs(_resolution(sampled))


def checked_amplitudes(amplitudes: ArrayLike, axes: Axes | None) -> NDArray[np.float64]:
    """Return the amplitudes as an array.

    Raises
    ------
    InputError
        They are not two or more increasing finite numbers, none negative, or they are on an axis too.
    """
    if axes is not None:
        instance_of("axes", axes, Mapping)
    for paths in axes or {}:
        if SCALE in ((paths,) if isinstance(paths, str) else paths):
            raise InputError("simulation.scale_on_axis", SCALE, path=SCALE)
    try:
        sampled = np.array(amplitudes, np.float64)
    except (TypeError, ValueError):
        raise InputError("simulation.amplitudes_not_numbers", "amplitudes") from None
    if sampled.ndim != 1 or len(sampled) < 2:
        raise InputError("simulation.amplitudes_shape", "amplitudes", shape=sampled.shape)
    bad = sampled[~np.isfinite(sampled) | (sampled < 0.0)]
    if len(bad):
        raise InputError("simulation.amplitude_not_possible", "amplitudes", value=bad[0])
    for low, high in pairwise(sampled.tolist()):
        if high <= low:
            raise InputError("simulation.amplitudes_not_increasing", "amplitudes", value=high, before=low)
    return sampled


def _resolution(sampled: NDArray[np.float64]) -> dict[str, Any]:
    steps = np.diff(sampled)
    return {
        "lowest_amplitude": float(sampled[0]),
        "highest_amplitude": float(sampled[-1]),
        "largest_step": float(steps.max()),
        "largest_relative_step": float((steps / sampled[1:]).max()),
        "resolution": "a range of standing or falling narrower than a step of the amplitudes can be missed",
    }
