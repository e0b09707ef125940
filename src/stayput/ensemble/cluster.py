"""The same work on a Dask cluster."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from stayput.ensemble.tasks import groups_of, pieces, prepared, run_part

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import NDArray

    from stayput.ensemble.grid import Grid

AHEAD = 4
"""Pieces handed in for each thread of the cluster: enough that none waits, few enough for the scheduler."""


def run_on_cluster(
    grid: Grid, chunk: int, client: Any, done: Callable[[int, NDArray[np.void]], None]
) -> None:
    """Run all cases on the workers of a `dask.distributed.Client`; ``done`` is called as on threads.

    The motions are prepared by a task of their own, so a worker that is lost takes nothing with it that the
    cluster cannot make again. Pieces not finished are cancelled on an exception.
    """
    from dask.distributed import as_completed

    shakings = client.submit(prepared, grid.motions, groups_of(grid), pure=False)
    todo = pieces(len(grid), chunk)
    under_way: dict[Any, int] = {}

    def hand_in() -> Any:
        piece = next(todo, None)
        if piece is None:
            return None
        future = client.submit(run_part, grid.part(*piece), shakings, pure=False)
        under_way[future] = piece[0]
        return future

    ahead = AHEAD * max(1, sum(client.nthreads().values()))
    try:
        first = [future for _ in range(ahead) if (future := hand_in()) is not None]
        finished: Any = as_completed(first, loop=client.loop)
        for future in finished:
            results = future.result()
            done(under_way.pop(future), results)
            future.release()
            following = hand_in()
            if following is not None:
                finished.add(following)
    except BaseException:
        client.cancel([shakings, *under_way])
        raise
