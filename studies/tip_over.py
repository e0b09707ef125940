"""Tip-over without an earthquake: the static margin of common pieces, on a hard floor and on carpet."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import xarray as xr

from stayput.everyday import ALL_DRAWERS, CARPET, LOAD, ONE_DRAWER, PULL, Everyday
from stayput.everyday import tip_over as cases_of
from stayput.model.body import Body
from stayput.model.furniture import FURNITURE
from stayput.report.figures import plain_log
from stayput.report.palette import INK
from studies.study import COLOURS, Quantity, Study, panels

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

FLOORS = {"hard floor": Everyday(), "carpet under the back": Everyday(carpet=CARPET)}
"""What people do to every piece, by the floor; its drawers are those of pieces that have some."""


def tip_over() -> Study:
    """Study what tips common pieces over without an earthquake, by statics.

    Returns
    -------
    Study
        Data over ``piece``, ``floor`` and ``case``: ``margin``, NaN where a piece has no drawers.
    """
    presets = {name: FURNITURE[name] for name in PRESETS}
    bodies = {name: Body(one.width, one.height, one.mass) for name, one in presets.items()}
    bodies = {"light chest of drawers": LIGHT_CHEST} | bodies
    margin = np.full((len(bodies), len(FLOORS), len(CASES)), np.nan)
    for row, (name, body) in enumerate(bodies.items()):
        for column, floor in enumerate(FLOORS.values()):
            for case in cases_of(body, replace(floor, drawers=DRAWERS.get(name, 0))):
                margin[row, column, list(CASES).index(case.name)] = case.margin
    margins = xr.DataArray(margin, {"piece": list(bodies), "floor": list(FLOORS), "case": list(CASES)})
    tips = (margins < 1.0).any("case").sum("piece").to_numpy().tolist()
    figure, (axis,) = panels(1, width=8.5, height=4.8)
    for (case, called), colour, marker in zip(CASES.items(), COLOURS, "os^D", strict=False):
        for floor, face in zip(FLOORS, (colour, "white"), strict=True):
            values = margins.sel(case=case, floor=floor)
            if np.isfinite(values).any():  # nothing on its front edge tips a piece on a hard floor
                look = {"color": colour, "markerfacecolor": face, "label": f"{called}, {floor}"}
                axis.plot(values, list(bodies), marker, **look)
    axis.axvline(1.0, color=INK, linestyle="--")
    plain_log(axis, y=False)
    axis.invert_yaxis()
    axis.set_xlabel("restoring over overturning moment [–]; left of the line it tips over")
    axis.legend(fontsize="small", loc="center left", bbox_to_anchor=(1.01, 0.5))
    shown = margins.stack(at=("floor", "case")).to_pandas().round(2)
    shown.columns = [f"{CASES[case]}, {floor}" for floor, case in shown.columns]
    return Study(
        name="tip_over",
        title="Tip-over without an earthquake",
        quantities={
            "on_floor": Quantity(
                "Pieces that some case tips over on a hard floor", tips[0], len(bodies), "d"
            ),
            "on_carpet": Quantity("Pieces that some case tips over on carpet", tips[1], len(bodies), "d"),
            "least": Quantity("Smallest margin", float(np.nanmin(margin)), form=".2f"),
        },
        data=margins.to_dataset(name="margin"),
        figure=figure,
        tables={"Margins; below 1 it tips over": shown.dropna(axis=1, how="all").reset_index()},
    )
