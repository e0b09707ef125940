"""`simulate_many`: columns of cases to columns of results."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from stayput.ensemble.axes import make_grid
from stayput.ensemble.cluster import run_on_cluster
from stayput.ensemble.results import empty, fill
from stayput.ensemble.tasks import run_on_threads, thread_count
from stayput.errors import within
from stayput.progress import bar

if TYPE_CHECKING:
    from collections.abc import Mapping

    import numpy as np
    from numpy.typing import NDArray

    from stayput.ensemble.grid import Grid
    from stayput.simulation import Case

LARGEST_CHUNK = 2048
"""Most cases in a piece of work, unless told: some tens of milliseconds."""


def simulate_many(
    case: Case,
    columns: Mapping[str, Any],
    *,
    threads: int | None = None,
    client: Any = None,
    chunk: int | None = None,
    progress: bool | None = None,
) -> dict[str, NDArray[Any]]:
    """Simulate columns of cases: the n-th value of each column makes the n-th case.

    Parameters
    ----------
    case : Case
        What all cases have that no column changes.
    columns : mapping of str to array_like, shape (n,)
        Values by path, such as ``body.width``, ``room.right_wall.gap``, ``motion.scale``; also ``motion``
        (of `Motion`, of any lengths and steps), ``contact``, ``body``, ``room`` and its parts (of objects).
        A table of pandas will do.
    threads : int, optional
        Threads; default one for each core that this process may use.
    client : dask.distributed.Client, optional
        Runs the cases on its cluster instead.
    chunk : int, optional
        Cases in a piece of work; by default up to 2048.
    progress : bool, optional
        Whether to draw a bar on standard error; default on a terminal.

    Returns
    -------
    dict of str to ndarray, shape (n,)
        The columns of `stayput.ensemble.results.QUANTITIES`. They do not depend on threads, client or chunk.

    Raises
    ------
    InputError
        An unknown path, columns of different lengths, or a case that is not possible.
    """
    names = tuple(columns)
    grid = make_grid(case, {names: tuple(columns[name] for name in names)})
    return run_grid(grid, threads=threads, client=client, chunk=chunk, progress=progress)


def run_grid(
    grid: Grid,
    *,
    threads: int | None = None,
    client: Any = None,
    chunk: int | None = None,
    progress: bool | None = None,
) -> dict[str, NDArray[np.generic]]:
    """Run a grid's cases; return the columns of results, in the grid's order."""
    count = len(grid)
    threads = thread_count(threads)
    if chunk is None:
        chunk = min(LARGEST_CHUNK, -(-count // (8 * threads)))
    chunk = int(within("Chunk", chunk, 1, 1e9, "cases"))
    columns = empty(count)
    with bar(count, "Simulating", progress) as tell:

        def done(start: int, results: NDArray[np.void]) -> None:
            fill(columns, start, results)
            tell(len(results))

        if client is not None:
            run_on_cluster(grid, chunk, client, done)
        else:
            run_on_threads(grid, chunk, threads, done)
    return columns
