"""Turnover over width and wall distance under a sine (the paper, §4.4, Figs. 4.5 and 4.6).

The paper's 15 % rule, and how far it holds under other sines and aspect ratios, is tested as well.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.colors import ListedColormap
from matplotlib.patches import Polygon

from stayput.model.body import Body
from stayput.model.room import Floor, Room, Wall
from stayput.motion.synthetic import sine
from stayput.report.palette import ALARM, INK
from stayput.scenario.sweep import sweep
from stayput.simulation.case import Case
from stayput.simulation.outcome import OUTCOMES, Outcome
from stayput.simulation.run import LAWS
from studies.study import Quantity, Study, label_edges, panels, span

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

    from stayput.motion.record import Motion
    from stayput.simulation.grid import Axes

RATIO, MASS, DURATION = 0.339, 100.0, 30.0
"""Aspect ratio b/h [–], mass [kg] and analysis time [s] of Table 4.2."""

FLOOR = Floor(0.2, 0.1, edge_static_friction=0.4, edge_kinetic_friction=0.3, restitution=0.6)
"""Floor of Table 4.2."""

WALL_RESTITUTION = 0.6
"""Collision coefficient of the wall of Table 4.2 [–]."""

WALLS = ("left", "right", "both")
"""Where a wall stands; with both, at the same distance."""

FALLEN = "#f2b48a"
"""Colour of a body that turns over."""

WIDE, NEAR = 1.0, 0.15
"""The rule is for bodies wider than this [m] and walls nearer than this share of the width [–]."""

TURNS_OVER = (0.8, 1.0)
"""Widths of which the paper says that they turn over even at a small distance [m]."""

MAP_WIDTHS, MAP_GAPS = np.linspace(0.4, 1.6, 49), np.linspace(0.0, 0.8, 81)
"""Widths and distances of the map [m]."""

WIDTHS = np.linspace(1.05, 1.95, 10)
"""Widths that test the rule [m]."""

SHARES = np.linspace(0.0, 0.30, 16)
"""Distances that test the rule, over the width [–]; beyond 15 % they say where turnover begins."""


@dataclass(frozen=True, slots=True, eq=False)
class Turnover:
    """Which bodies turn over.

    Attributes
    ----------
    free : ndarray of bool, shape [..., width]
        Without a wall; the first dimensions are those of the other axes.
    free_tilt : ndarray, shape [..., width]
        Largest tilt without a wall [rad].
    walled : ndarray of bool, shape [..., wall, width, gap]
        With a wall.
    given_up : int
        Number of runs that were given up; they count as turned over.
    """

    free: NDArray[np.bool_]
    free_tilt: NDArray[np.float64]
    walled: NDArray[np.bool_]
    given_up: int


def table_4_2(motion: Motion, ratio: float = RATIO) -> Case:
    """Return a case with Table 4.2's coefficients under the paper's law; no wall yet."""
    return Case(Body(1.0, 1.0 / ratio, MASS), Room(FLOOR), motion, "paper")


def turnover(
    case: Case,
    widths: NDArray[np.float64],
    gaps: NDArray[np.float64],
    others: Axes,
    walls: Sequence[str] = WALLS,
) -> Turnover:
    """Simulate bodies of a case's aspect ratio beside walls, and without one.

    Parameters
    ----------
    case : Case
        What no axis changes.
    widths : ndarray, shape [width]
        Widths b [m].
    gaps : ndarray, shape [gap] or [width, gap]
        Distances l_w to the wall [m].
    others : mapping
        Further axes, as for `sweep`.
    walls : sequence of str
        Some of `WALLS`.
    """
    ratio = case.body.width / case.body.height
    rows = np.broadcast_to(gaps, (len(widths), gaps.shape[-1]))
    bodies: list[float] = []
    rooms: list[tuple[Wall | None, Wall | None]] = []
    for width, distances in zip(widths, rows, strict=True):
        rooms.append((None, None))
        for where, gap in product(walls, distances):
            wall = Wall(float(gap), WALL_RESTITUTION)
            rooms.append((None if where == "right" else wall, None if where == "left" else wall))
        bodies += [float(width)] * (1 + len(walls) * len(distances))
    cell = ("body.width", "body.height", "room.left_wall", "room.right_wall")
    columns = (bodies, [width / ratio for width in bodies], *zip(*rooms, strict=True))
    data = sweep(case, {**others, cell: columns}, progress=False)
    given_up = data["outcome"].to_numpy() == OUTCOMES.index(Outcome.FAILED.value)
    fallen, tilt = data["overturned"].to_numpy() | given_up, data["peak_tilt"].to_numpy()
    fallen, tilt = (values.reshape(*values.shape[:-1], len(widths), -1) for values in (fallen, tilt))
    walled = fallen[..., 1:].reshape(*fallen.shape[:-1], len(walls), gaps.shape[-1])
    return Turnover(fallen[..., 0], tilt[..., 0], np.moveaxis(walled, -2, -3), int(given_up.sum()))


def coordinates(widths: NDArray[np.float64], gaps: NDArray[np.float64]) -> dict[str, object]:
    """Return the coordinates that both studies of walls have."""
    return {
        "contact": list(LAWS),
        "wall": list(WALLS),
        "body.width": ("body.width", widths, {"units": "m"}),
        "gap": ("gap", gaps, {"units": "m", "long_name": "distance from the body to the wall"}),
    }


def wall_gap(
    amplitude: float = 5.0,
    frequency: float = 0.8,
    *,
    widths: ArrayLike = MAP_WIDTHS,
    gaps: ArrayLike = MAP_GAPS,
    amplitudes: Sequence[float] = (4.0, 5.0, 6.0, 8.0, 10.0),
    frequencies: Sequence[float] = (0.5, 0.8, 1.0, 1.5),
    ratios: Sequence[float] = (0.25, 0.3, RATIO, 0.4, 0.5),
) -> Study:
    """Map turnover over width and wall distance under a sine, and test the paper's 15 % rule.

    The rule: bodies wider than 1 m and nearer to the wall than 15 % of their width do not turn over. The
    map has the coefficients of the paper's Table 4.2, both contact laws, and a wall on the left, on the
    right and on both sides. The paper's input (Fig. 4.2) is not given in its text; ours is a stated one.

    Parameters
    ----------
    amplitude, frequency : float
        The map's sine [m/s², Hz], 30 s.
    widths, gaps : array_like
        The map's widths b and distances l_w from the body to the wall [m].
    amplitudes, frequencies, ratios : sequence of float
        Sines [m/s², Hz] and aspect ratios b/h [–] under which the rule is tested, all combinations.

    Returns
    -------
    Study
        Data: ``overturned`` over law, wall, width and distance, ``overturned_free`` without a wall, and what
        `rule_tested` gives, over law, aspect ratio and sine.
    """
    b, l_w = np.asarray(widths, np.float64), np.asarray(gaps, np.float64)
    motion = sine_of(amplitude, frequency)
    result = turnover(table_4_2(motion), b, l_w, {"contact": LAWS})
    mapped = xr.Dataset(
        {
            "overturned": (("contact", "wall", "body.width", "gap"), result.walled),
            "overturned_free": (("contact", "body.width"), result.free),
        },
        coordinates(b, l_w),
    )
    tested, lost = rule_tested(amplitudes, frequencies, ratios)
    data = xr.merge([mapped, tested])
    return Study(
        name="wall_gap",
        title="Turnover beside a wall under a sine",
        quantities=_quantities(data, result.given_up + lost),
        data=data,
        figure=_drawn(data, motion.name),
        tables={
            "Without a wall (T: it turns over), and the nearest wall [m] that turns it over": by_width(data),
            "Inputs (sine and aspect ratio) that break the 15 % rule": by_input(data),
        },
    )


def _quantities(data: xr.Dataset, given_up: int) -> dict[str, Quantity]:
    widths = data["body.width"].to_numpy()
    near = ruled(widths, data["gap"].to_numpy())
    middle = (widths >= TURNS_OVER[0] - 1e-9) & (widths <= TURNS_OVER[1] + 1e-9)
    quantities: dict[str, Quantity] = {}
    for law in LAWS[::-1]:
        of_law = data.sel(contact=law)
        fallen = of_law["overturned"].sel(wall=["left", "right"]).to_numpy()
        label = (
            f"Widths, distances and sides of the 15 % rule that break it, of {2 * near.sum()}, law {law!r}"
        )
        quantities[f"map_broken_{law}"] = Quantity(label, int(fallen[:, near].sum()), 0, "d")
        for wall in ("left", "right"):
            shares = 100.0 * (nearest_walls(data, law, wall) / widths)[middle]
            label = f"Nearest wall that turns over 0.8 to 1.0 m, {wall}, law {law!r} [% of the width]"
            quantities[f"nearest_{wall}_{law}"] = Quantity(label, span(shares, ".0f"), "small")
        broken = (of_law["broken_share"] > 0.0).to_numpy()
        alone = broken & (of_law["free_share"] == 0.0).to_numpy()
        label = f"Inputs of {broken.size} at which the rule is broken, law {law!r}"
        quantities[f"broken_{law}"] = Quantity(label, int(broken.sum()), 0, "d")
        label = "of these, at which no body turns over without a wall"
        quantities[f"broken_stands_{law}"] = Quantity(label, int(alone.sum()), form="d")
    quantities["given_up"] = Quantity("Runs given up, counted as turned over", given_up, form="d")
    return quantities


def sine_of(amplitude: float, frequency: float) -> Motion:
    """Return a sine of Table 4.2's duration [m/s², Hz]."""
    return sine(amplitude, frequency, DURATION, dt=min(0.01, 0.02 / frequency))


def ruled(widths: NDArray[np.float64], gaps: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return which widths and distances the rule is for, shape [width, gap]."""
    b, l_w = np.broadcast_arrays(widths[:, None], gaps)
    return (b > WIDE + 1e-9) & (l_w < NEAR * b - 1e-9)


def rule_tested(
    amplitudes: Sequence[float], frequencies: Sequence[float], ratios: Sequence[float]
) -> tuple[xr.Dataset, int]:
    """Test the rule under sines, for aspect ratios and both laws, with a wall on the left or the right.

    Returns
    -------
    data : xarray.Dataset
        Over contact law, aspect ratio, frequency and amplitude: ``nearest_wall``, over the width, that turns
        over a body of `WIDTHS`, nan where none of `SHARES` does; ``broken_share``, the share of the rule's
        widths, distances and sides at which the body turns over; ``free_share``, the share of the widths
        that turn over without a wall; ``free_tilt``, the largest tilt of any of them without a wall [rad].
    given_up : int
        Runs given up.
    """
    gaps = WIDTHS[:, None] * SHARES
    near = ruled(WIDTHS, gaps)
    sines = [sine_of(1.0, frequency) for frequency in frequencies]
    others: Axes = {"contact": LAWS, "motion": sines, "motion.scale": amplitudes}
    names = ("nearest_wall", "broken_share", "free_share", "free_tilt")
    parts: list[xr.Dataset] = []
    given_up = 0
    for ratio in ratios:
        result = turnover(table_4_2(sines[0], ratio), WIDTHS, gaps, others, WALLS[:2])
        somewhere = result.walled.any((-3, -2))
        nearest = np.where(somewhere.any(-1), SHARES[somewhere.argmax(-1)], np.nan)
        broken = result.walled[..., near].mean((-2, -1))
        values = nearest, broken, result.free.mean(-1), result.free_tilt.max(-1)
        dims = ("contact", "frequency", "amplitude")
        parts.append(xr.Dataset({name: (dims, array) for name, array in zip(names, values, strict=True)}))
        given_up += result.given_up
    coords = {
        "contact": list(LAWS),
        "frequency": ("frequency", list(frequencies), {"units": "Hz"}),
        "amplitude": ("amplitude", list(amplitudes), {"units": "m/s2"}),
    }
    return xr.concat(parts, xr.Variable("aspect_ratio", list(ratios))).assign_coords(coords), given_up


def nearest_walls(data: xr.Dataset, law: str, wall: str) -> NDArray[np.float64]:
    """Return the nearest wall of the map that turns each width over [m], nan where none does."""
    fallen = data["overturned"].sel(contact=law, wall=wall).to_numpy()
    return np.where(fallen.any(-1), data["gap"].to_numpy()[fallen.argmax(-1)], np.nan)


def by_width(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each of some widths: T or N without a wall, and the nearest wall [m]."""
    widths = data["body.width"].to_numpy()
    table: dict[str, object] = {"b [m]": widths, "15 % of b [m]": NEAR * widths}
    for law in LAWS[::-1]:
        free = data["overturned_free"].sel(contact=law).to_numpy()
        table[f"{law}: no wall"] = np.where(free, "T", "N")
        table |= {f"{law}: {wall}": nearest_walls(data, law, wall) for wall in WALLS}
    return pd.DataFrame(table).iloc[:: -(-len(widths) // 13)].reset_index(drop=True)


def by_input(data: xr.Dataset) -> pd.DataFrame:
    """Return how many sines break the rule, by law and aspect ratio."""
    broken, stands = data["broken_share"] > 0.0, data["free_share"] == 0.0
    kinds = {
        "none tilts without a wall": data["free_tilt"] == 0.0,
        "some turn over without a wall": ~stands,
        "rule broken": broken,
        "of these, none turns over without a wall": broken & stands,
    }
    counts = xr.Dataset(kinds).sum(("frequency", "amplitude"))
    counts["nearest wall [% of b]"] = 100.0 * data["nearest_wall"].min(("frequency", "amplitude"))
    return counts.to_dataframe().reset_index()


def _drawn(data: xr.Dataset, motion: str) -> Figure:
    """Draw turnover over width and distance, a panel for each law and wall; without a wall on top."""
    figure, axes = panels(len(WALLS), len(LAWS), width=4.0, height=3.6, sharex=True, sharey=True)
    widths, gaps = data["body.width"].to_numpy(), data["gap"].to_numpy()
    last = max(widths[-1], WIDE)
    corners = [(WIDE, 0.0), (last, 0.0), (last, NEAR * last), (WIDE, NEAR * WIDE)]
    for axis, (law, wall) in zip(axes, product(LAWS[::-1], WALLS), strict=True):
        fallen = data["overturned"].sel(contact=law, wall=wall).to_numpy().T
        shown = np.where(fallen, 0.0, np.nan)
        axis.pcolormesh(widths, gaps, shown, cmap=ListedColormap([FALLEN]), shading="nearest")
        axis.plot(widths, NEAR * widths, color=INK, linestyle="--", linewidth=1.0)
        axis.add_patch(Polygon(corners, fill=False, edgecolor=INK, linewidth=1.6))
        axis.plot(TURNS_OVER, (0.0, 0.0), color=INK, linewidth=4.0, solid_capstyle="butt")
        free = widths[data["overturned_free"].sel(contact=law).to_numpy()]
        axis.plot(free, np.full(len(free), 1.05 * gaps[-1]), "X", color=ALARM, markersize=5)
        axis.set_title(f"law “{law}”, wall: {wall}")
    label_edges(axes, len(WALLS), "width [m]", "distance to the wall [m]")
    figure.suptitle(
        f"{motion}, b/h = {RATIO:g}; filled: turns over; crosses on top: without a wall, too\n"
        "dashed: 15 % of the width; frame: the paper's rule; thick: the paper's 0.8 to 1.0 m"
    )
    return figure
