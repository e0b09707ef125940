"""Tip-over without an earthquake: the static margin of common pieces, on a hard floor and on carpet."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput.everyday import ALL_DRAWERS, CARPET, LOAD, ONE_DRAWER, PULL, Everyday, bearable_load
from stayput.everyday import tip_over as cases_of
from stayput.model.body import Body
from stayput.model.furniture import FURNITURE
from stayput.report.figures import FONT, new_figure, plain_log, style
from stayput.report.palette import ALARM, INK
from studies.study import Quantity, Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DRAWERS = {"light chest of drawers": 4, "chest": 4}
"""Drawers of the pieces that have some (a guess)."""

LIGHT_CHEST = Body(0.45, 1.20, 40.0)
"""A chest of drawers of boards, with clothes (assumed)."""

PRESETS = ("chest", "wardrobe", "cupboard", "bookcase", "empty bookcase", "refrigerator", "television")
"""Presets of furniture beside it."""

CASES = {
    PULL: "pull",
    LOAD: "load on the front edge",
    ONE_DRAWER: "load on one open drawer",
    ALL_DRAWERS: "all drawers open, load on one",
}
"""What the cases are called."""

LOOKS = {
    PULL: ("#0072b2", "o"),
    LOAD: ("#009e73", "s"),
    ONE_DRAWER: ("#e69f00", "^"),
    ALL_DRAWERS: (ALARM, "D"),
}
"""Colour and marker of each case."""


def tip_over(everyday: Everyday | None = None) -> Study:
    """Study what tips common pieces over without an earthquake, by statics.

    Parameters
    ----------
    everyday : Everyday, optional
        What people do to every piece; its drawers are those of pieces that have some, its carpet is left out:
        on carpet the back is lifted as the rule says.

    Returns
    -------
    Study
        Figure "margins". Data over ``piece``, ``floor`` and ``case``: ``margin``, NaN where a piece has no
        drawers; ``load`` [kg] that just tips.

    Examples
    --------
    >>> import studies
    >>> margin = studies.tip_over().data.margin.sel(piece="light chest of drawers")
    >>> margin.to_pandas().round(2)
    case                   pull  load  one_drawer  all_drawers
    floor
    hard floor             1.63   NaN        1.12         0.76
    carpet under the back  1.53   NaN        0.95         0.67
    """
    given = everyday or Everyday()
    bodies = {"light chest of drawers": LIGHT_CHEST}
    for name in PRESETS:
        preset = FURNITURE[name]
        bodies[name] = Body(preset.width, preset.height, preset.mass)
    floors = {
        "hard floor": replace(given, carpet=0.0),
        "carpet under the back": replace(given, carpet=CARPET),
    }
    margin = np.full((len(bodies), len(floors), len(CASES)), np.nan)
    load = np.zeros((len(bodies), len(floors)))
    for row, (name, body) in enumerate(bodies.items()):
        for column, stated in enumerate(floors.values()):
            here = replace(stated, drawers=DRAWERS.get(name, 0))
            load[row, column] = bearable_load(body, here)
            for case in cases_of(body, here):
                margin[row, column, list(CASES).index(case.name)] = case.margin
    data = xr.Dataset(
        {
            "margin": (
                ("piece", "floor", "case"),
                margin,
                {"long_name": "restoring over overturning moment"},
            ),
            "load": (("piece", "floor"), load, {"units": "kg", "long_name": "load that just tips"}),
        },
        {"piece": list(bodies), "floor": list(floors), "case": list(CASES)},
    )
    tips = (data["margin"] < 1.0).any("case")
    quantities = {
        "pieces": Quantity("Pieces", len(bodies), form="d"),
        "on_floor": Quantity(
            "Pieces that some case tips over on a hard floor", int(tips[:, 0].sum()), form="d"
        ),
        "on_carpet": Quantity("Pieces that some case tips over on carpet", int(tips[:, 1].sum()), form="d"),
        "least": Quantity("Smallest margin", float(np.nanmin(margin)), form=".2f"),
    }
    caption = "Margin on a hard floor, and with carpet under the back; below 1 it tips over"
    return Study(
        name="tip-over",
        title="Tip-over without an earthquake",
        quantities=quantities,
        data=data,
        figures={"margins": draw_margins(data)},
        tables={caption: margins_table(data)},
    )


def margins_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each piece: the margins of each case on both floors, and the load that just tips."""
    rows: list[dict[str, str]] = []
    for piece in data["piece"].to_numpy():
        cell = data.sel(piece=piece)
        row = {"piece": str(piece)}
        for case, called in CASES.items():
            values = cell["margin"].sel(case=case).to_numpy()
            row[called] = "" if np.isnan(values).all() else ", ".join(_margin(value) for value in values)
        row["load that just tips [kg]"] = ", ".join(_load(value) for value in cell["load"].to_numpy())
        rows.append(row)
    return pd.DataFrame(rows)


def _margin(value: float) -> str:
    return f"{value:.2f}" if np.isfinite(value) else "none tips it"


def _load(value: float) -> str:
    return f"{value:.0f}" if np.isfinite(value) else "none"


def draw_margins(data: xr.Dataset) -> Figure:
    """Draw the margins of every piece: filled on a hard floor, hollow on carpet."""
    pieces = data["piece"].to_numpy().tolist()
    figure = new_figure(8.5, 0.42 * len(pieces) + 1.6)
    axis = figure.subplots()
    style(axis, zero=False)
    rows = np.arange(len(pieces))
    for case, (colour, marker) in LOOKS.items():
        for floor, face in zip(data["floor"].to_numpy().tolist(), (colour, "white"), strict=True):
            values = data["margin"].sel(case=case, floor=floor).to_numpy()
            if not np.isfinite(values).any():  # nothing on its front edge tips a piece on a hard floor
                continue
            label = f"{CASES[case]}, {floor}"
            axis.plot(values, rows, marker, color=colour, markerfacecolor=face, markersize=7.0, label=label)
    axis.axvline(1.0, color=INK, linewidth=1.2, linestyle="--")
    plain_log(axis, y=False)
    axis.set_xticks((0.5, 1.0, 2.0, 5.0, 10.0, 20.0))
    axis.set_yticks(rows, pieces, fontsize=FONT)
    axis.set_ylim(len(pieces) - 0.5, -0.5)
    axis.set_xlabel("restoring over overturning moment [–]; left of the line it tips over", fontsize=FONT)
    axis.legend(fontsize=FONT - 2.0, loc="center left", bbox_to_anchor=(1.01, 0.5))
    return figure
