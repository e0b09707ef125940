"""Arrays of cases, each with its own devices, under several motions, on threads."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError
from stayput.execution import Pool
from stayput.mechanics.columns import RESULT
from stayput.mechanics.devices.columns import DEVICE, ELEMENT, NONE
from stayput.mechanics.runner import Shaking, run_cases, shaking
from stayput.progress import bar

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from numpy.typing import NDArray

    from stayput.motion import Motion
    from stayput.simulation.space_case import SpaceShaking

CHUNK = 64
"""Most cases in a call of the executor: cases with devices take a millisecond or so each."""


def run_rows(
    cases: NDArray[np.void], elements: NDArray[np.void], motion: Shaking | SpaceShaking
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Run cases under one motion on this thread; those without devices by the faster solver for free bodies.

    Where the motion is prepared for the engine in space that one runs them.

    Parameters
    ----------
    cases : ndarray of CASE, shape [m]
    elements : ndarray of ELEMENT, shape [m, n]
    motion : Shaking or SpaceShaking

    Returns
    -------
    tuple
        RESULT, shape [m], and DEVICE, shape [m, n].
    """
    if not isinstance(motion, Shaking):
        from stayput.simulation.space_case import run_rows_in_space  # SciPy takes its time to load

        return run_rows_in_space(cases, elements, motion)
    results, devices = np.zeros(len(cases), RESULT), np.zeros(elements.shape, DEVICE)
    devices["failure_time"] = np.nan
    has_devices = (elements["kind"] != NONE).any(axis=1)
    if not has_devices.all():
        free = np.flatnonzero(~has_devices)
        results[free] = run_cases(cases[free], motion)
    if has_devices.any():
        from stayput.mechanics.devices.runner import run_cases_with_devices  # Numba takes its time to load

        held = np.flatnonzero(has_devices)
        results[held], devices[held] = run_cases_with_devices(cases[held], elements[held], motion)
    return results, devices


def prepared_motion(motion: Motion, dimensions: int, law: int = 0) -> Shaking | SpaceShaking:
    """Return a motion as the engine in the plane (2 dimensions) or in space (3) reads it.

    Parameters
    ----------
    motion : Motion
        The motion.
    dimensions : int
        2 or 3.
    law : int
        Number of the contact law in the plane.
    """
    if dimensions == 3:
        from stayput.simulation.space_case import SpaceShaking, acceleration_of

        return SpaceShaking(acceleration_of(motion), motion.dt)
    return shaking(motion.x, motion.z, motion.dt, law)


def run_columns(
    cases: NDArray[np.void],
    elements: NDArray[np.void] | None,
    motions: Sequence[Motion],
    motion: NDArray[np.int64],
    *,
    dimensions: int = 2,
    threads: int | None = None,
    progress: bool | None = None,
    on_progress: Callable[[int], None] | None = None,
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Run cases on threads, each with its own devices and motion, under the "coulomb" contact law.

    Parameters
    ----------
    cases : ndarray of CASE, shape [m]
        The cases, as `stayput.simulation.flat_fields.case_columns` makes them of a body and a room with
        measures in place.
    elements : ndarray of ELEMENT, shape [m, n], or None
        Their devices, as `stayput.measures.element_rows` makes them, filled up with elements of kind NONE.
    motions : sequence of Motion
        The motions; each is prepared once.
    motion : ndarray of int, shape [m]
        Index of each case's motion.
    dimensions : int
        2 in the plane, 3 in space: the cases have lengths then, and each device is an element of its own.
    threads : int, optional
        Threads; default one for each core that this process may use.
    progress : bool, optional
        Whether to draw a bar on standard error; default on a terminal.
    on_progress : callable, optional
        Called on this thread with the number of cases just done; an exception that it raises stops the work.

    Returns
    -------
    tuple
        RESULT, shape [m], and DEVICE, shape [m, n] (`stayput.mechanics`); the bits do not depend on the
        threads. Forces are per unit mass; `stayput.measures.element.failures_of` sums the devices up.

    Raises
    ------
    InputError
        Arrays of different lengths, an index outside the motions, or elements that are not possible.
    """
    rows = np.zeros((len(cases), 0), ELEMENT) if elements is None else elements
    indices = np.asarray(motion)
    if len(rows) != len(cases) or indices.shape != (len(cases),):
        raise InputError(
            "simulation.lengths_differ", cases=len(cases), elements=len(rows), motions=len(indices)
        )
    if len(indices) and (indices.min() < 0 or indices.max() >= len(motions)):
        wrong = indices[(indices < 0) | (indices >= len(motions))][0]
        raise InputError("simulation.motion_index", "motion", value=wrong, last=len(motions) - 1)
    used = {int(n): motions[int(n)] for n in np.unique(indices)}
    prepared = {n: prepared_motion(motion, dimensions) for n, motion in used.items()}
    results, devices = np.zeros(len(cases), RESULT), np.zeros(rows.shape, DEVICE)

    def run(chunk: NDArray[np.intp]) -> int:
        motion = prepared[int(indices[chunk[0]])]
        results[chunk], devices[chunk] = run_rows(cases[chunk], rows[chunk], motion)
        return len(chunk)

    with bar(len(cases), "progress.simulating", progress) as advance, Pool(threads) as pool:
        for _, done in pool.as_completed(partial(run, chunk) for chunk in _chunks(indices)):
            advance(done)
            if on_progress is not None:
                on_progress(done)
    return results, devices


def _chunks(indices: NDArray[np.int64]) -> Iterator[NDArray[np.intp]]:
    """Split cases into chunks that are shaken by one motion each, given the index of every case's motion."""
    order = np.argsort(indices, kind="stable")
    starts = np.flatnonzero(np.diff(indices[order], prepend=-1))
    for group in np.split(order, starts[1:]):
        for start in range(0, len(group), CHUNK):
            yield group[start : start + CHUNK]
