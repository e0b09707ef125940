"""Columns of cases, each with its own devices, under motions, over threads."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError
from stayput.mechanics.columns import RESULT
from stayput.mechanics.restrained.columns import DEVICE, ELEMENT, NONE
from stayput.mechanics.runner import run_cases, shaking
from stayput.progress import bar

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    from stayput.mechanics.runner import Shaking
    from stayput.motion import Motion

PIECE = 64
"""Cases in a piece of work: cases with devices take a millisecond or so each."""


def run_rows(
    cases: NDArray[np.void], elements: NDArray[np.void], motion: Shaking
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Run rows under one motion on this thread; a case without elements takes the way of free bodies.

    Parameters
    ----------
    cases : ndarray of CASE, shape [m]
    elements : ndarray of ELEMENT, shape [m, n]
    motion : Shaking

    Returns
    -------
    tuple
        RESULT, shape [m], and DEVICE, shape [m, n].
    """
    results, devices = np.zeros(len(cases), RESULT), np.zeros(elements.shape, DEVICE)
    devices["failure_time"] = np.nan
    held = (elements["kind"] != NONE).any(axis=1)
    if not held.all():
        free = np.flatnonzero(~held)
        results[free] = run_cases(cases[free], motion)
    if held.any():
        from stayput.mechanics.restrained.runner import run_restrained_cases  # takes its time to load

        mine = np.flatnonzero(held)
        results[mine], devices[mine] = run_restrained_cases(cases[mine], elements[mine], motion)
    return results, devices


def run_columns(
    cases: NDArray[np.void],
    elements: NDArray[np.void] | None,
    motions: Sequence[Motion],
    motion: NDArray[np.int64],
    *,
    threads: int | None = None,
    progress: bool | None = None,
    told: Callable[[int], None] | None = None,
) -> tuple[NDArray[np.void], NDArray[np.void]]:
    """Run columns of cases over threads, each with its own row of elements, under the "coulomb" law.

    Parameters
    ----------
    cases : ndarray of CASE, shape [m]
        The cases, such as `stayput.cases.case_columns` makes them of a held body and room.
    elements : ndarray of ELEMENT, shape [m, n], or None
        Their devices, such as `stayput.measures.element_rows` makes them; rows of kind NONE fill up.
    motions : sequence of Motion
        The motions; each is prepared once.
    motion : ndarray of int, shape [m]
        Which of the motions shakes each case.
    threads : int, optional
        Threads; default one for each core that this process may use.
    progress : bool, optional
        Whether to draw a bar on standard error; default on a terminal.
    told : callable, optional
        Told, on this thread, how many more cases are done; what it raises stops the work.

    Returns
    -------
    tuple
        RESULT, shape [m], and DEVICE, shape [m, n] (`stayput.mechanics`), whatever the threads. Forces are
        per unit mass; `stayput.measures.results.failures_of` sums the devices up.

    Raises
    ------
    InputError
        Columns of other lengths, a place outside the motions, or elements that are not possible.
    """
    from stayput.ensemble.tasks import thread_count

    rows = np.zeros((len(cases), 0), ELEMENT) if elements is None else elements
    places = np.asarray(motion)
    if len(rows) != len(cases) or places.shape != (len(cases),):
        raise InputError(
            f"There are {len(cases)} cases, {len(rows)} rows of elements and {len(places)} places of "
            "motions; they must be as many."
        )
    if len(places) and (places.min() < 0 or places.max() >= len(motions)):
        raise InputError(
            f"A place of a motion is {places[(places < 0) | (places >= len(motions))][0]}; "
            f"it must be between 0 and {len(motions) - 1}."
        )
    met = {int(n): motions[int(n)] for n in np.unique(places)}
    shakings = {n: shaking(shaken.x, shaken.z, shaken.dt, 0) for n, shaken in met.items()}
    order = np.argsort(places, kind="stable")
    starts = np.flatnonzero(np.diff(places[order], prepend=-1))
    pieces = [
        piece
        for mine in np.split(order, starts[1:])
        for piece in np.split(mine, range(PIECE, len(mine), PIECE))
        if len(piece)
    ]
    results, devices = np.zeros(len(cases), RESULT), np.zeros(rows.shape, DEVICE)
    with bar(len(cases), "Simulating", progress) as tell, ThreadPoolExecutor(thread_count(threads)) as pool:

        def run(piece: NDArray[np.intp]) -> NDArray[np.intp]:
            found = run_rows(cases[piece], rows[piece], shakings[int(places[piece[0]])])
            results[piece], devices[piece] = found
            return piece

        try:
            for piece in pool.map(run, pieces):
                tell(len(piece))
                if told is not None:
                    told(len(piece))
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
    return results, devices
