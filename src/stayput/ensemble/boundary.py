"""The boundary between standing and fallen, over the amplitude of the shaking.

A body may fall at one amplitude, stand at a higher one and fall again above: it has *islands* of safety
(Zhang and Makris 2001, J. Eng. Mech. 127(5), 473-483). So there is no one critical amplitude; there are
edges, and each is named: `overturning_map` samples them, `trace_boundary` finds them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, get_args

import numpy as np

from stayput.ensemble.axes import make_grid
from stayput.ensemble.flips import Flips, flips_of, hidden_flips, refined
from stayput.ensemble.grid import Axis, Columns, Grid
from stayput.ensemble.many import run_grid
from stayput.ensemble.overturning import FALLEN, SCALE, checked_amplitudes, overturning_map
from stayput.errors import InputError, within

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import ArrayLike, NDArray

    from stayput.ensemble.axes import Axes
    from stayput.ensemble.flips import Runs
    from stayput.simulation import Case

__all__ = ["Edge", "overturning_map", "trace_boundary"]

Edge = Literal["first", "last", "all"]
"""Which edge to trace; see `trace_boundary`."""

MEANINGS: dict[str, str] = {
    "first": "lowest amplitude at which the body falls; below it every sampled case stands",
    "last": "lowest amplitude above which no sampled case stands",
    "all": "every edge, in order of amplitude, from standing to fallen and back",
}
"""What each edge is."""


def trace_boundary(
    case: Case,
    amplitudes: ArrayLike,
    axes: Axes | None = None,
    *,
    edge: Edge = "all",
    tolerance: float = 1e-4,
    threads: int | None = None,
    client: Any = None,
    progress: bool | None = None,
) -> xr.Dataset:
    """Find the amplitudes between standing and fallen: every flip of a sampled map, refined by bisection.

    An island between two samples is looked for where the number of landings before the fall changes from
    the one to the other; others that are narrower than a step of the amplitudes can be missed.

    Parameters
    ----------
    case, amplitudes, axes
        As for `overturning_map`.
    edge : {"first", "last", "all"}
        ``first``: the lowest amplitude at which the body falls. ``last``: the lowest above which no sampled
        case stands. ``all``: every edge, along a dimension ``edge`` that counts from 1 at the lowest.
    tolerance : float
        Distance of the two amplitudes that an edge lies between, relative to the upper one.
    threads, client, progress
        As for `simulate_many`.

    Returns
    -------
    xarray.Dataset
        Over the axes (and ``edge``): ``amplitude``, the middle of ``lower`` and ``upper``, at which the
        case was run on either side; ``direction``, +1 where it falls above the edge, −1 where it stands
        above, 0 where there is no edge; ``floor_impacts``, landings before the fall on the side where it
        falls, −1 where there is no edge. Amplitudes are NaN where there is no edge.
        Over the axes: ``falls_at_lowest`` of the amplitudes, for then there is no ``first`` among them;
        ``falls_at_highest``, for else there is no ``last``; ``islands``, the number of ranges of standing
        between two of falling, whichever edge is followed; ``failed``, the number of samples given up,
        which count as falls. The attributes say which edge it is, and how wide a range must be not to be
        missed.

    Raises
    ------
    InputError
        As for `overturning_map`, or an unknown edge or a tolerance outside 1e-12 to 0.1.
    """
    if edge not in get_args(Edge):
        raise InputError(f"Edge is {edge!r}; it must be one of {', '.join(get_args(Edge))}.")
    tolerance = within("Tolerance", tolerance, 1e-12, 0.1)
    sampled = checked_amplitudes(amplitudes, axes)
    grid = make_grid(case, axes or {})
    mapped = overturning_map(case, sampled, axes, threads=threads, client=client, progress=progress)
    shape = len(grid), len(sampled)
    falls = (mapped["overturned"] | mapped["failed"]).values.reshape(shape)

    def runs(
        points: NDArray[np.intp], scales: NDArray[np.float64]
    ) -> tuple[NDArray[np.bool_], NDArray[np.int32]]:
        cases = _cases(grid, points, scales)
        columns = run_grid(cases, threads=threads, client=client, progress=progress)
        return np.isin(columns["outcome"], FALLEN), columns["floor_impacts"].astype(np.int32)

    flips = flips_of(falls, sampled)
    landings = mapped["floor_impacts"].values.reshape(shape)
    flips = flips.along_with(hidden_flips(falls, landings, sampled, runs, tolerance))
    back = np.bincount(flips.point[flips.direction < 0], minlength=len(grid))
    summaries = {
        "islands": (back - (falls.any(1) & ~falls[:, -1]), "ranges of standing between two of falling"),
        "falls_at_lowest": (falls[:, 0], "whether it falls at the lowest amplitude"),
        "falls_at_highest": (falls[:, -1], "whether it falls at the highest amplitude"),
        "failed": (mapped["failed"].sum(SCALE).values, "number of samples given up"),
    }
    found = mapped[["islands"]]
    dims = found["islands"].dims
    for name, (values, meaning) in summaries.items():
        found[name] = (dims, values.reshape(grid.shape), {"long_name": meaning})
    found = _with_edges(found, refined(_followed(flips, edge, falls), runs, tolerance), runs, edge)
    return found.assign_attrs(edge=edge, edge_meaning=MEANINGS[edge], tolerance=tolerance)


def _with_edges(found: xr.Dataset, flips: Flips, runs: Runs, edge: Edge) -> xr.Dataset:
    """Return a dataset over the points with the edges put in; one to a point unless all are followed."""
    impacts = runs(flips.point, flips.fallen_side)[1] if len(flips) else np.zeros(0, np.int32)
    columns = {
        "amplitude": (0.5 * (flips.lower + flips.upper), np.nan, "amplitude between standing and fallen"),
        "lower": (flips.lower, np.nan, "amplitude just below the edge"),
        "upper": (flips.upper, np.nan, "amplitude just above the edge"),
        "direction": (flips.direction, 0, "+1: it falls above the edge; -1: it stands above; 0: no edge"),
        "floor_impacts": (impacts, -1, "landings before the fall, on the side where it falls; -1: no edge"),
    }
    points, dims = found["islands"], found["islands"].dims
    most = max(1, int(flips.number.max(initial=0)) + 1)
    for name, (values, missing, meaning) in columns.items():
        table = np.full((points.size, most), missing, values.dtype)
        table[flips.point, flips.number] = values
        if edge == "all":
            found[name] = ((*dims, "edge"), table.reshape(*points.shape, most), {"long_name": meaning})
        else:
            found[name] = (dims, table.reshape(points.shape), {"long_name": meaning})
    return found.assign_coords(edge=np.arange(1, most + 1)) if edge == "all" else found


def _followed(flips: Flips, edge: Edge, falls: NDArray[np.bool_]) -> Flips:
    """Return the flips that make an edge; none at a point whose edge lies outside the amplitudes."""
    if edge == "all":
        return flips
    if edge == "first":
        return flips.only((flips.number == 0) & ~falls[flips.point, 0])
    top = np.append(flips.point[1:] != flips.point[:-1], True)[: len(flips)]
    return flips.only(top & falls[flips.point, -1])


def _cases(grid: Grid, points: NDArray[np.intp], scales: NDArray[np.float64]) -> Grid:
    """Return some points of a grid as cases in a row, each at its own amplitude."""
    places = np.unravel_index(points, grid.shape) if grid.axes else ()
    columns: Columns = {SCALE: scales}
    for axis, place in zip(grid.axes, places, strict=True):
        columns |= {path: values[place] for path, values in axis.columns.items()}
    return Grid(grid.base, (Axis("case", columns, {}),), grid.motions, grid.measures)
