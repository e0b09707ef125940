"""Turnover over width and wall distance under a sine (the paper, §4.4, Figs. 4.5 and 4.6).

The paper's 15 % rule, and how far it holds under other sines and aspect ratios, is tested as well.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.colors import ListedColormap
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Polygon, Rectangle

from stayput.catalogue import phrase
from stayput.errors import InputError, within
from stayput.motion import sine
from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import ALARM, INK, MUTED
from stayput.simulation.run import LAWS
from studies.study import Quantity, Study, increasing, span
from studies.walls import DURATION, FALLEN, RATIO, SIDES, WALLS, results_about, table_4_2, turnover

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

    from stayput.motion import Motion
    from stayput.simulation.axes import Axes as Columns

WIDE = 1.0
"""The rule is for bodies wider than this [m]."""

NEAR = 0.15
"""The rule is for walls nearer than this share of the width [–]."""

TURNS_OVER = (0.8, 1.0)
"""Widths of which the paper says that they turn over even at a small distance [m]."""

WIDTHS = np.linspace(1.05, 1.95, 10)
"""Widths that test the rule [m]."""

SHARES = np.linspace(0.0, 0.30, 16)
"""Distances that test the rule, over the width [–]; beyond 15 % they say where turnover begins."""

STEP = 0.01
"""Time step of the sines, where that is fine enough [s]."""

RULE_RESULTS = {
    "nearest_wall": "nearest wall that turns a body wider than 1 m over, over its width",
    "broken_share": "share of the rule's widths, distances and sides that turn over",
    "free_share": "share of the widths above 1 m that turn over without a wall",
    "free_tilt": "largest tilt of the widths above 1 m without a wall [rad]",
}
"""What `rule_tested` gives."""

MOST_ROWS = 13
"""Most rows of the table by width."""

STILL, STANDS, HOLDS, BROKEN, ANYWAY = range(5)
"""Kinds of inputs under which the rule is tested."""

KINDS = (
    ("none tilts without a wall", "#dfe3e8", ""),
    ("none turns over", "#ffffff", ""),
    ("turnover at some distance, none nearer than 15 %", "#bfe0f2", "..."),
    ("rule broken; none turns over without a wall", "#f7d08a", "///"),
    ("rule broken; some turn over without a wall", "#e8946a", "xxx"),
)
"""Label, colour and hatch of each kind."""


def wall_gap(
    amplitude: float = 5.0,
    frequency: float = 0.8,
    *,
    widths: ArrayLike | None = None,
    gaps: ArrayLike | None = None,
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
    widths : array_like, shape [width], optional
        The map's widths b [m]; default 0.4 to 1.6 m by 0.025 m.
    gaps : array_like, shape [gap], optional
        The map's distances l_w from the body to the wall [m]; default 0 to 0.8 m by 0.01 m.
    amplitudes, frequencies, ratios : sequence of float
        Sines [m/s², Hz] and aspect ratios b/h [–] under which the rule is tested, all combinations.

    Returns
    -------
    Study
        ``data`` holds ``overturned`` over law, wall, width and distance, and ``overturned_free`` without a
        wall; and what `studies.wall_gap.rule_tested` gives, over law, aspect ratio and sine.

    Raises
    ------
    InputError
        A value out of range, or widths or distances that do not increase.

    Examples
    --------
    >>> import studies
    >>> quick = studies.wall_gap(
    ...     widths=[0.4, 0.8, 1.2], gaps=[0.0, 0.1, 0.2], amplitudes=[5.0], frequencies=[0.8], ratios=[0.36]
    ... )
    >>> quick.data.overturned.sel(contact="paper", wall="right").to_pandas()
    gap           0.0    0.1    0.2
    body.width
    0.4         False   True   True
    0.8         False  False   True
    1.2         False  False  False
    """
    b = increasing("studies.width", np.linspace(0.4, 1.6, 49) if widths is None else widths, 0.01, 10.0, "m")
    l_w = increasing("studies.wall_gap", np.linspace(0.0, 0.8, 81) if gaps is None else gaps, 0.0, 100.0, "m")
    sizes = _checked_values("studies.amplitude", (amplitude, *amplitudes), 0.1, 100.0, "m/s²")
    speeds = _checked_values("studies.frequency", (frequency, *frequencies), 0.05, 5.0, "Hz")
    shapes = _checked_values("studies.aspect_ratio", (RATIO, *ratios), 0.05, 2.0)
    motion = sine_of(sizes[0], speeds[0])
    tested = rule_tested(sizes[1:], speeds[1:], shapes[1:])
    data = xr.merge([_map(motion, b, l_w), tested], combine_attrs="no_conflicts")
    tables = {"Without a wall, and the nearest wall [m] that turns it over": by_width(data)}
    tables["Inputs (sine and aspect ratio) that break the 15 % rule"] = by_input(data)
    for law in LAWS[::-1]:
        caption = f"Nearest wall that turns over a body wider than 1 m [% of its width], law {law!r}"
        tables[caption] = of_inputs(data, law)
    return Study(
        name="wall-gap",
        title="Turnover beside a wall under a sine",
        quantities=_quantities(data),
        data=data,
        figures={"map": draw_map(data), "rule": draw_rule(data)},
        tables=tables,
    )


def _checked_values(
    what: str, values: Sequence[float], low: float, high: float, unit: str = ""
) -> list[float]:
    """Return numbers within limits; the first is the map's, and one at least must follow it."""
    if len(values) < 2:
        raise InputError("studies.rule_without_values", name=phrase(what))
    return [within(what, value, low, high, unit) for value in values]


def _map(motion: Motion, widths: NDArray[np.float64], gaps: NDArray[np.float64]) -> xr.Dataset:
    result = turnover(table_4_2(motion), widths, gaps, {"contact": LAWS})
    about, coords = results_about(widths, gaps)
    return xr.Dataset(
        {
            "overturned": (("contact", "wall", "body.width", "gap"), result.walled, about["overturned"]),
            "overturned_free": (("contact", "body.width"), result.free, about["overturned_free"]),
        },
        coords,
        {"motion": motion.name, "map_aspect_ratio": RATIO, "map_given_up": result.given_up},
    )


def _quantities(data: xr.Dataset) -> dict[str, Quantity]:
    near = ruled(data["body.width"].to_numpy(), data["gap"].to_numpy())
    quantities: dict[str, Quantity] = {}
    for law in LAWS[::-1]:
        fallen = data["overturned"].sel(contact=law, wall=list(WALLS[:2])).to_numpy()
        label = (
            f"Map: of {2 * int(near.sum())} widths, distances and sides of the 15 % rule, broken, law {law!r}"
        )
        quantities[f"map_broken_{law}"] = Quantity(label, int(fallen[:, near].sum()), 0, "d")
        for wall in WALLS[:2]:
            shares = _shares_of_width(data, law, wall)
            label = f"Nearest wall that turns over 0.8 to 1.0 m, {wall}, law {law!r} [% of the width]"
            quantities[f"nearest_{wall}_{law}"] = Quantity(label, span(shares, ".0f"), "small")
        broken = data["broken_share"].sel(contact=law).to_numpy() > 0.0
        label = f"Inputs of {broken.size} at which the rule is broken, law {law!r}"
        quantities[f"broken_{law}"] = Quantity(label, int(broken.sum()), 0, "d")
    given_up = int(data.attrs["map_given_up"]) + int(data.attrs["rule_given_up"])
    quantities["given_up"] = Quantity("Runs given up, counted as turned over", given_up, form="d")
    return quantities


def _shares_of_width(data: xr.Dataset, law: str, wall: str) -> NDArray[np.float64]:
    """Return the nearest walls that turn over `TURNS_OVER`, in per cent of the width."""
    widths = data["body.width"].to_numpy()
    chosen = (widths >= TURNS_OVER[0] - 1e-9) & (widths <= TURNS_OVER[1] + 1e-9)
    return 100.0 * (nearest_walls(data, law, wall) / widths)[chosen]


def sine_of(amplitude: float, frequency: float) -> Motion:
    """Return a sine of Table 4.2's duration [m/s², Hz]."""
    return sine(amplitude, frequency, DURATION, dt=min(STEP, 0.02 / frequency))


def ruled(widths: NDArray[np.float64], gaps: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return which widths and distances the rule is for, shape [width, gap]."""
    b, l_w = np.broadcast_arrays(widths[:, None], gaps)
    return (b > WIDE + 1e-9) & (l_w < NEAR * b - 1e-9)


def rule_tested(
    amplitudes: Sequence[float], frequencies: Sequence[float], ratios: Sequence[float]
) -> xr.Dataset:
    """Test the rule under sines, for aspect ratios and both laws, with a wall on the left or the right.

    Returns
    -------
    xarray.Dataset
        Over contact law, aspect ratio, frequency and amplitude: ``nearest_wall``, over the width, that turns
        over a body of `WIDTHS`, nan where none of `SHARES` does; ``broken_share``, the share of the rule's
        widths, distances and sides at which the body turns over; ``free_share``, the share of the widths
        that turn over without a wall; ``free_tilt``, the largest tilt of any of them without a wall [rad].
    """
    gaps = WIDTHS[:, None] * SHARES
    near = ruled(WIDTHS, gaps)
    columns: dict[str, list[NDArray[np.float64]]] = {name: [] for name in RULE_RESULTS}
    sines = [sine_of(1.0, frequency) for frequency in frequencies]
    others: Columns = {"contact": LAWS, "motion": sines, "motion.scale": amplitudes}
    given_up = 0
    for ratio in ratios:
        result = turnover(table_4_2(sines[0], ratio), WIDTHS, gaps, others, WALLS[:2])
        somewhere = result.walled.any((-3, -2))
        nearest = np.where(somewhere.any(-1), SHARES[somewhere.argmax(-1)], np.nan)
        broken = result.walled[..., near].mean((-2, -1))
        values = nearest, broken, result.free.mean(-1), result.free_tilt.max(-1)
        for name, array in zip(columns, values, strict=True):
            columns[name].append(array)
        given_up += result.given_up
    dims = ("contact", "aspect_ratio", "frequency", "amplitude")
    return xr.Dataset(
        {
            name: (dims, np.stack(columns[name], axis=1), {"long_name": RULE_RESULTS[name]})
            for name in columns
        },
        {
            "contact": list(LAWS),
            "aspect_ratio": list(ratios),
            "frequency": ("frequency", list(frequencies), {"units": "Hz"}),
            "amplitude": ("amplitude", list(amplitudes), {"units": "m/s2"}),
        },
        {"rule_given_up": given_up},
    )


def nearest_walls(data: xr.Dataset, law: str, wall: str) -> NDArray[np.float64]:
    """Return the nearest wall of the map that turns each width over [m], nan where none does."""
    fallen = data["overturned"].sel(contact=law, wall=wall).to_numpy()
    return np.where(fallen.any(-1), data["gap"].to_numpy()[fallen.argmax(-1)], np.nan)


def by_width(data: xr.Dataset) -> pd.DataFrame:
    """Return, for some widths of the map, T or N without a wall and the nearest wall that turns it over."""
    widths = data["body.width"].to_numpy()
    table: dict[str, object] = {"b [m]": widths, "15 % of b [m]": NEAR * widths}
    for law in LAWS[::-1]:
        free = data["overturned_free"].sel(contact=law).to_numpy()
        table[f"{law}: no wall"] = np.where(free, "T", "N")
        for wall in WALLS:
            table[f"{law}: {wall}"] = nearest_walls(data, law, wall)
    return pd.DataFrame(table).iloc[:: -(-len(widths) // MOST_ROWS)].reset_index(drop=True)


def by_input(data: xr.Dataset) -> pd.DataFrame:
    """Return how many sines break the rule, by law and aspect ratio."""
    rows: list[dict[str, object]] = []
    for law in LAWS[::-1]:
        for ratio in data["aspect_ratio"].to_numpy():
            cases = data.sel(contact=law, aspect_ratio=ratio)
            broken = cases["broken_share"].to_numpy() > 0.0
            stands = cases["free_share"].to_numpy() == 0.0
            rows.append(
                {
                    "law": law,
                    "b/h": float(ratio),
                    "sines": broken.size,
                    "some turn over without a wall": int((~stands).sum()),
                    "rule broken": int(broken.sum()),
                    "of these, none turns over without a wall": int((broken & stands).sum()),
                    "largest share that breaks it [%]": 100.0 * float(cases["broken_share"].max()),
                    "nearest wall [% of b]": 100.0 * float(cases["nearest_wall"].min()),
                }
            )
    return pd.DataFrame(rows)


def of_inputs(data: xr.Dataset, law: str) -> pd.DataFrame:
    """Return the nearest wall for each sine and aspect ratio, and the share that breaks the rule."""
    cases = data.sel(contact=law)
    rows: list[dict[str, object]] = []
    for ratio in data["aspect_ratio"].to_numpy():
        for frequency in data["frequency"].to_numpy():
            row: dict[str, object] = {"b/h": float(ratio), "f [Hz]": float(frequency)}
            for amplitude in data["amplitude"].to_numpy():
                cell = cases.sel(aspect_ratio=ratio, frequency=frequency, amplitude=amplitude)
                row[f"{amplitude:g} m/s²"] = cell_text(cell)
            rows.append(row)
    return pd.DataFrame(rows)


def cell_text(cell: xr.Dataset) -> str:
    """Return the nearest wall of one input [%], and a star where bodies turn over without a wall, too."""
    near = 100.0 * float(cell["nearest_wall"])
    star = "*" if float(cell["free_share"]) > 0.0 else ""
    return f"{'–' if np.isnan(near) else f'{near:.0f}'}{star}"


def draw_map(data: xr.Dataset) -> Figure:
    """Draw turnover over width and distance, a panel for each law and wall; without a wall on top."""
    figure = new_figure(12.0, 7.6)
    panels = figure.subplots(len(LAWS), len(WALLS), sharex=True, sharey=True)
    for row, law in zip(panels, LAWS[::-1], strict=True):
        for axis, wall in zip(row, WALLS, strict=True):
            _map_panel(axis, data, law, wall)
            axis.set_title(f"law “{law}”, {SIDES[wall]}", fontsize=FONT)
        row[0].set_ylabel("distance to the wall [m]", fontsize=FONT)
    for axis in panels[-1]:
        axis.set_xlabel("width [m]", fontsize=FONT)
    figure.suptitle(f"{data.attrs['motion']}, b/h = {data.attrs['map_aspect_ratio']:g}", fontsize=FONT + 1.0)
    figure.legend(
        handles=[
            Patch(facecolor=FALLEN, edgecolor=ALARM, label="turns over"),
            Line2D([], [], color=ALARM, marker="X", linestyle="", label="turns over without a wall"),
            Line2D([], [], color=INK, linestyle="--", label=f"distance = {100 * NEAR:.0f} % of the width"),
            Patch(facecolor="none", edgecolor=INK, linewidth=1.6, label="paper: no turnover here"),
            Line2D([], [], color=INK, linewidth=4.0, label="paper: turns over even at a small distance"),
        ],
        loc="outside lower center",
        ncols=3,
        fontsize=FONT,
        frameon=False,
    )
    return figure


def _map_panel(axis: Axes, data: xr.Dataset, law: str, wall: str) -> None:
    widths, gaps = data["body.width"].to_numpy(), data["gap"].to_numpy()
    fallen = data["overturned"].sel(contact=law, wall=wall).to_numpy().T
    edges = _edges(widths), _edges(gaps)
    axis.pcolormesh(*edges, np.where(fallen, 0.0, np.nan), cmap=ListedColormap([FALLEN]))
    axis.plot(widths, NEAR * widths, color=INK, linestyle="--", linewidth=1.0)
    last = max(widths[-1], WIDE)
    corners = [(WIDE, 0.0), (last, 0.0), (last, NEAR * last), (WIDE, NEAR * WIDE)]
    axis.add_patch(Polygon(corners, fill=False, edgecolor=INK, linewidth=1.6))
    axis.plot(TURNS_OVER, (0.0, 0.0), color=INK, linewidth=4.0, solid_capstyle="butt", clip_on=False)
    free = widths[data["overturned_free"].sel(contact=law).to_numpy()]
    top = 1.05 * gaps[-1]
    axis.plot(free, np.full(len(free), top), "X", color=ALARM, markersize=5)
    axis.set_xlim(edges[0][0], edges[0][-1])
    axis.set_ylim(0.0, 1.1 * gaps[-1])
    style(axis, zero=False)


def _edges(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the limits of cells about increasing values; the first cell starts at no less than 0."""
    middles = 0.5 * (values[1:] + values[:-1])
    half = 0.5 * np.diff(values) if len(values) > 1 else np.array([0.01])
    return np.concatenate(([max(values[0] - half[0], 0.0)], middles, [values[-1] + half[-1]]))


def draw_rule(data: xr.Dataset) -> Figure:
    """Draw the kind of each input and the nearest wall that turns a body over, by law and aspect ratio."""
    ratios = data["aspect_ratio"].to_numpy()
    figure = new_figure(max(2.6 * len(ratios) + 0.6, 8.0), 6.6)
    panels = figure.subplots(len(LAWS), len(ratios), sharex=True, sharey=True, squeeze=False)
    for row, law in zip(panels, LAWS[::-1], strict=True):
        for axis, ratio in zip(row, ratios, strict=True):
            _rule_panel(axis, data.sel(contact=law, aspect_ratio=ratio))
            axis.set_title(f"law “{law}”, b/h = {ratio:g}", fontsize=FONT)
        row[0].set_ylabel("frequency [Hz]", fontsize=FONT)
    for axis in panels[-1]:
        axis.set_xlabel("amplitude [m/s²]", fontsize=FONT)
    figure.suptitle(
        "Nearest wall that turns over a body wider than 1 m [% of its width]; "
        f"–: none up to {100 * SHARES[-1]:.0f} %; *: some turn over without a wall",
        fontsize=FONT + 1.0,
    )
    handles = [
        Patch(facecolor=colour, edgecolor=MUTED, hatch=hatch, label=label) for label, colour, hatch in KINDS
    ]
    figure.legend(handles=handles, loc="outside lower center", ncols=3, fontsize=FONT, frameon=False)
    return figure


def _rule_panel(axis: Axes, data: xr.Dataset) -> None:
    amplitudes, frequencies = data["amplitude"].to_numpy(), data["frequency"].to_numpy()
    for i, frequency in enumerate(frequencies):
        for j, amplitude in enumerate(amplitudes):
            cell = data.sel(frequency=frequency, amplitude=amplitude)
            _, colour, hatch = KINDS[_kind(cell)]
            place = (j - 0.5, i - 0.5), 1.0, 1.0
            axis.add_patch(Rectangle(*place, facecolor=colour, edgecolor=MUTED, hatch=hatch, linewidth=0.6))
            box = {"facecolor": "white", "edgecolor": "none", "pad": 1.2}
            axis.text(j, i, cell_text(cell), ha="center", va="center", fontsize=FONT, color=INK, bbox=box)
    axis.set_xticks(range(len(amplitudes)), [f"{value:g}" for value in amplitudes])
    axis.set_yticks(range(len(frequencies)), [f"{value:g}" for value in frequencies])
    axis.set_xlim(-0.5, len(amplitudes) - 0.5)
    axis.set_ylim(-0.5, len(frequencies) - 0.5)
    axis.tick_params(labelsize=FONT - 1.0, colors=INK)


def _kind(cell: xr.Dataset) -> int:
    if float(cell["broken_share"]) > 0.0:
        return ANYWAY if float(cell["free_share"]) > 0.0 else BROKEN
    if float(cell["free_share"]) > 0.0 or not np.isnan(float(cell["nearest_wall"])):
        return HOLDS
    return STANDS if float(cell["free_tilt"]) > 0.0 else STILL
