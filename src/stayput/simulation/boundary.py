"""Overturning over the amplitude of the shaking: `overturning_map` samples it, `trace_boundary` finds edges.

A body may fall at one amplitude, stand at a higher one and fall again above: it has *islands* of safety
(Zhang and Makris 2001, J. Eng. Mech. 127(5), 473-483). So there is not one critical amplitude but a list of
*crossings* of the boundary between standing and falling. Crossings are taken from neighbouring samples of the
map that differ, and refined by bisection.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from concurrent.futures import Executor
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, within, word_of
from stayput.simulation.grid import Axes, Axis, Columns, Grid, finite_numbers, make_grid
from stayput.simulation.many import run_grid, sweep_case
from stayput.simulation.outcome import Outcome

if TYPE_CHECKING:
    import xarray as xr

    from stayput.simulation.case import Case

    RunPoints: TypeAlias = (
        "Callable[[NDArray[np.intp], NDArray[np.float64]], tuple[NDArray[np.bool_], NDArray[np.int32]]]"
    )
    """Runs points at amplitudes, shape (k,) each; returns whether the body falls, and its landings."""


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
    data = sweep_case(
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
    sampled = finite_numbers(phrase("simulation.amplitudes"), amplitudes, "amplitudes", least=2)
    before = [0.0] if sampled[0] < 0.0 else []
    for low, high in pairwise([*before, *sampled.tolist()]):
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


Edge = Literal["first", "last", "all"]
"""Which edge to trace; see `trace_boundary`."""

MEANINGS: dict[str, str] = {
    "first": "lowest amplitude at which the body falls; below it every sampled case stands",
    "last": "lowest amplitude above which no sampled case stands",
    "all": "every edge, in order of amplitude, from standing to fallen and back",
}
"""What each edge is."""

MOST_HALVINGS = 60
"""Most bisections of an interval: the tolerance is relative, and never met by one that begins at zero."""


CROSSING = np.dtype([("point", "i8"), ("lower", "f8"), ("upper", "f8"), ("direction", "i1")])
"""A crossing of the stability boundary: the point (the combination of the other axes' values) that it belongs
to, the amplitudes just below and above it, and +1 where it falls above, −1 where it stands above.
"""


def trace_boundary(
    case: Case,
    amplitudes: ArrayLike,
    axes: Axes | None = None,
    *,
    edge: Edge = "all",
    tolerance: float = 1e-4,
    threads: int | None = None,
    executor: Executor | None = None,
    progress: bool | None = None,
) -> xr.Dataset:
    """Find the amplitudes between standing and falling: the crossings of a sampled map, refined by bisection.

    Between two samples that both fall an island is looked for if the number of landings before the fall
    differs. Other islands that are narrower than a step of the amplitudes can be missed.

    Parameters
    ----------
    case, amplitudes, axes
        As for `overturning_map`.
    edge : {"first", "last", "all"}
        ``first``: the lowest amplitude at which the body falls. ``last``: the lowest above which no sampled
        case stands. ``all``: every edge, along a dimension ``edge`` that counts from 1 at the lowest.
    tolerance : float
        Width of the interval of amplitudes in which an edge lies, relative to its upper end.
    threads, executor, progress
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

    Examples
    --------
    >>> import stayput as sp
    >>> wave = sp.sine(amplitude=1.0, frequency=1.0, duration=1.0, quiet=8.0)  # one cycle, then rest
    >>> case = sp.Case(sp.Body(0.4, 1.2, 100.0), sp.Room(sp.Floor(3.0, 3.0)), wave)
    >>> sizes = {("body.width", "body.height"): ([0.2, 0.4, 0.8], [0.6, 1.2, 2.4])}
    >>> edges = sp.trace_boundary(case, [2.0, 3.0, 4.0, 5.0], sizes, edge="first")
    >>> edges.amplitude.round(2).values.tolist()  # of three bodies of one shape, the small one first [m/s²]
    [3.78, 3.96, 4.36]
    """
    word_of("simulation.edge", edge, get_args(Edge), "edge")
    tolerance = within("simulation.tolerance", tolerance, 1e-12, 0.1, field="tolerance")
    sampled = checked_amplitudes(amplitudes, axes)
    grid = make_grid(case, axes or {})
    mapped = overturning_map(case, sampled, axes, threads=threads, executor=executor, progress=progress)
    shape = len(grid), len(sampled)
    falls = (mapped["overturned"] | mapped["failed"]).values.reshape(shape)

    def runs(
        points: NDArray[np.intp], scales: NDArray[np.float64]
    ) -> tuple[NDArray[np.bool_], NDArray[np.int32]]:
        cases = _cases(grid, points, scales)
        columns = run_grid(cases, threads=threads, executor=executor, progress=progress)
        return np.isin(columns["outcome"], FALLEN), columns["floor_impacts"].astype(np.int32)

    crossings = sampled_crossings(falls, sampled)
    landings = mapped["floor_impacts"].values.reshape(shape)
    crossings = np.append(crossings, hidden_crossings(falls, landings, sampled, runs, tolerance))
    crossings = crossings[np.lexsort((crossings["lower"], crossings["point"]))]
    back = np.bincount(crossings["point"][crossings["direction"] < 0], minlength=len(grid))
    summaries = {
        "islands": (back - (falls.any(1) & ~falls[:, -1]), "ranges of standing between two of falling"),
        "falls_at_lowest": (falls[:, 0], "whether it falls at the lowest amplitude"),
        "falls_at_highest": (falls[:, -1], "whether it falls at the highest amplitude"),
        "failed": (mapped["failed"].sum(SCALE).values, "number of samples given up"),
    }
    data = mapped[["islands"]]
    dims = data["islands"].dims
    for name, (values, meaning) in summaries.items():
        data[name] = (dims, values.reshape(grid.shape), {"long_name": meaning})
    data = _with_edges(data, bisected(_of_edge(crossings, edge, falls), runs, tolerance), runs, edge)
    return data.assign_attrs(edge=edge, edge_meaning=MEANINGS[edge], tolerance=tolerance)


def _with_edges(data: xr.Dataset, crossings: NDArray[np.void], runs: RunPoints, edge: Edge) -> xr.Dataset:
    """Return a dataset over the points with the edges put in; one to a point unless all are followed."""
    point, lower, upper, direction = (crossings[name] for name in CROSSING.names or ())
    number = _numbered(crossings)
    fallen_side = np.where(direction > 0, upper, lower)
    impacts = runs(point, fallen_side)[1] if len(crossings) else np.zeros(0, np.int32)
    columns = {
        "amplitude": (0.5 * (lower + upper), np.nan, "amplitude between standing and fallen"),
        "lower": (lower, np.nan, "amplitude just below the edge"),
        "upper": (upper, np.nan, "amplitude just above the edge"),
        "direction": (direction, 0, "+1: it falls above the edge; -1: it stands above; 0: no edge"),
        "floor_impacts": (impacts, -1, "landings before the fall, on the side where it falls; -1: no edge"),
    }
    points, dims = data["islands"], data["islands"].dims
    most = max(1, int(number.max(initial=0)) + 1)
    for name, (values, missing, meaning) in columns.items():
        table = np.full((points.size, most), missing, values.dtype)
        table[point, number] = values
        if edge == "all":
            data[name] = ((*dims, "edge"), table.reshape(*points.shape, most), {"long_name": meaning})
        else:
            data[name] = (dims, table.reshape(points.shape), {"long_name": meaning})
    return data.assign_coords(edge=np.arange(1, most + 1)) if edge == "all" else data


def _numbered(crossings: NDArray[np.void]) -> NDArray[np.intp]:
    """Return the number of each crossing among those of its point, from 0 at the lowest."""
    return np.arange(len(crossings)) - np.searchsorted(crossings["point"], crossings["point"])


def _of_edge(crossings: NDArray[np.void], edge: Edge, falls: NDArray[np.bool_]) -> NDArray[np.void]:
    """Return the crossings that belong to an edge; none at a point whose edge lies outside the amplitudes."""
    if edge == "all":
        return crossings
    if edge == "first":
        return crossings[(_numbered(crossings) == 0) & ~falls[crossings["point"], 0]]
    top = np.append(crossings["point"][1:] != crossings["point"][:-1], True)[: len(crossings)]
    return crossings[top & falls[crossings["point"], -1]]


def _cases(grid: Grid, points: NDArray[np.intp], scales: NDArray[np.float64]) -> Grid:
    """Return some points of a grid as a list of cases, each at its own amplitude."""
    places = np.unravel_index(points, grid.shape) if grid.axes else ()
    columns: Columns = {SCALE: scales}
    for axis, place in zip(grid.axes, places, strict=True):
        columns |= {path: values[place] for path, values in axis.columns.items()}
    return Grid(grid.base, (Axis("case", columns, {}),), grid.motions, grid.measures)


def crossings_of(
    point: NDArray[np.intp], lower: ArrayLike, upper: ArrayLike, direction: ArrayLike
) -> NDArray[np.void]:
    """Return CROSSING records of columns, ordered by point and then by amplitude."""
    rows = np.zeros(len(point), CROSSING)
    rows["point"], rows["lower"], rows["upper"], rows["direction"] = point, lower, upper, direction
    return rows[np.lexsort((rows["lower"], rows["point"]))]


def sampled_crossings(falls: NDArray[np.bool_], amplitudes: NDArray[np.float64]) -> NDArray[np.void]:
    """Return the crossings between neighbouring samples; ``falls`` has shape (points, amplitudes)."""
    point, place = np.nonzero(falls[:, 1:] != falls[:, :-1])
    direction = np.where(falls[point, place], -1, 1).astype(np.int8)
    return crossings_of(point, amplitudes[place], amplitudes[place + 1], direction)


def bisected(crossings: NDArray[np.void], runs: RunPoints, tolerance: float) -> NDArray[np.void]:
    """Bisect all crossings together until each interval is within ``tolerance``, relative to its upper end.

    Where an interval has several crossings, one of the given direction is found; which one is not defined.
    """
    narrowed = crossings.copy()
    lower, upper = narrowed["lower"], narrowed["upper"]
    for _ in range(MOST_HALVINGS):
        wide = np.flatnonzero(upper - lower > tolerance * upper)
        if not len(wide):
            break
        middle = 0.5 * (lower[wide] + upper[wide])
        falls, _ = runs(narrowed["point"][wide], middle)
        below = falls == (narrowed["direction"][wide] < 0)
        lower[wide] = np.where(below, middle, lower[wide])
        upper[wide] = np.where(below, upper[wide], middle)
    return narrowed


def hidden_crossings(
    falls: NDArray[np.bool_],
    landings: NDArray[np.int32],
    amplitudes: NDArray[np.float64],
    runs: RunPoints,
    tolerance: float,
) -> NDArray[np.void]:
    """Look for islands between two neighbouring amplitudes at both of which the body falls.

    If the body falls after n landings at one and after another number at the other, then between them is an
    amplitude at which it reaches the point of unstable balance and stays there for as long as one likes. If
    it comes back from there once the shaking is over, it stands. So the change of the number of landings is
    bisected until a run stands, or the interval is within ``tolerance``.

    Parameters
    ----------
    falls, landings : ndarray, shape (points, amplitudes)
        Whether the body falls at the samples, and its landings before.
    amplitudes : ndarray, shape (amplitudes,)
        Increasing.
    runs, tolerance
        As for `bisected`.

    Returns
    -------
    ndarray of CROSSING
        Two for each island found: back to standing, and to falling again. They are not bisected yet.
    """
    changes = falls[:, 1:] & falls[:, :-1] & (landings[:, 1:] != landings[:, :-1])
    point, place = np.nonzero(changes)
    lower, upper = amplitudes[place], amplitudes[place + 1]
    below = landings[point, place]
    island = np.full(len(point), np.nan)
    for _ in range(MOST_HALVINGS):
        todo = np.flatnonzero(np.isnan(island) & (upper - lower > tolerance * upper))
        if not len(todo):
            break
        middle = 0.5 * (lower[todo] + upper[todo])
        fallen, landed = runs(point[todo], middle)
        island[todo] = np.where(fallen, np.nan, middle)
        same = landed == below[todo]
        lower[todo] = np.where(fallen & same, middle, lower[todo])
        upper[todo] = np.where(fallen & ~same, middle, upper[todo])
    has_island = ~np.isnan(island)
    point, lower, island, upper = (each[has_island] for each in (point, lower, island, upper))
    back, again = crossings_of(point, lower, island, -1), crossings_of(point, island, upper, 1)
    return np.append(back, again)
