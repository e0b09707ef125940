"""Tables and text of the study of walls under a sine."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pandas as pd

from stayput.simulation import LAWS
from stayput.studies.walls.map import DURATION, FLOOR, MASS, RATIO, WALLS, about_given_up
from stayput.studies.walls.rule import NEAR, SHARES, TURNS_OVER, WIDE, WIDTHS, ruled

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

MOST_ROWS = 13
"""Most rows of the table by width."""


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


def summary(data: xr.Dataset) -> pd.DataFrame:
    """Return how many sines break the rule, by law and aspect ratio."""
    rows: list[dict[str, object]] = []
    for law in LAWS[::-1]:
        for ratio in data["aspect_ratio"].to_numpy():
            mine = data.sel(contact=law, aspect_ratio=ratio)
            broken = mine["broken_share"].to_numpy() > 0.0
            stands = mine["free_share"].to_numpy() == 0.0
            rows.append(
                {
                    "law": law,
                    "b/h": float(ratio),
                    "sines": broken.size,
                    "some turn over without a wall": int((~stands).sum()),
                    "rule broken": int(broken.sum()),
                    "of these, none turns over without a wall": int((broken & stands).sum()),
                    "largest share that breaks it [%]": 100.0 * float(mine["broken_share"].max()),
                    "nearest wall [% of b]": 100.0 * float(mine["nearest_wall"].min()),
                }
            )
    return pd.DataFrame(rows)


def of_inputs(data: xr.Dataset, law: str) -> pd.DataFrame:
    """Return the nearest wall for each sine and aspect ratio, and the share that breaks the rule."""
    mine = data.sel(contact=law)
    rows: list[dict[str, object]] = []
    for ratio in data["aspect_ratio"].to_numpy():
        for frequency in data["frequency"].to_numpy():
            row: dict[str, object] = {"b/h": float(ratio), "f [Hz]": float(frequency)}
            for amplitude in data["amplitude"].to_numpy():
                cell = mine.sel(aspect_ratio=ratio, frequency=frequency, amplitude=amplitude)
                row[f"{amplitude:g} m/s²"] = in_words(cell)
            rows.append(row)
    return pd.DataFrame(rows)


def in_words(cell: xr.Dataset) -> str:
    """Return the nearest wall of one input [%], and a star where bodies turn over without a wall, too."""
    near = 100.0 * float(cell["nearest_wall"])
    star = "*" if float(cell["free_share"]) > 0.0 else ""
    return f"{'–' if np.isnan(near) else f'{near:.0f}'}{star}"


def text_of(data: xr.Dataset) -> str:
    """Return what was done and found."""
    given_up = about_given_up(int(data.attrs["map_given_up"]) + int(data.attrs["rule_given_up"]))
    done = (
        f"Bodies of the paper's Table 4.2 (b/h = {data.attrs['map_aspect_ratio']:g}, {MASS:g} kg) under the "
        f"{data.attrs['motion']}, {DURATION:g} s from phase 0. The paper's text does not give its sine "
        "(Fig. 4.2); this one is ours. The paper finds that widths of "
        f"{TURNS_OVER[0]:.1f} to {TURNS_OVER[1]:.1f} m turn over even at a small distance to the wall, and "
        f"that above {WIDE:.1f} m nothing turns over nearer than {100 * NEAR:.0f} % of the width.{given_up}"
    )
    return "\n\n".join((done, *(_map_text(data, law) for law in LAWS[::-1]), _rule_text(data)))


def _map_text(data: xr.Dataset, law: str) -> str:
    widths, gaps = data["body.width"].to_numpy(), data["gap"].to_numpy()
    fallen = data["overturned"].sel(contact=law)
    near = ruled(widths, gaps)
    free = widths[data["overturned_free"].sel(contact=law).to_numpy()]
    alone = f"the widest that turns over has {free.max():g} m" if len(free) else "none turns over"
    parts = [f"Law {law!r}, widths of {widths[0]:g} to {widths[-1]:g} m: without a wall {alone}."]
    parts += [_side_text(data, law, wall) for wall in WALLS[:2]]
    broken = int(fallen.sel(wall=list(WALLS[:2])).to_numpy()[:, near].sum())
    parts.append(
        f"So the rule is broken at {broken} of the {2 * int(near.sum())} widths, distances and sides that it "
        "is for."
    )
    both = fallen.sel(wall="both").to_numpy()
    narrow = widths[both.any(-1)]
    parts.append(
        "Walls on both sides: "
        + (f"the widest that turns over has {narrow.max():g} m." if len(narrow) else "none turns over.")
    )
    return " ".join(parts)


def _side_text(data: xr.Dataset, law: str, wall: str) -> str:
    widths, first = data["body.width"].to_numpy(), nearest_walls(data, law, wall)
    low, high = TURNS_OVER
    middle = (widths >= low - 1e-9) & (widths <= high + 1e-9)
    below = _nearest_text(widths, first, middle, f"of {low:.1f} to {high:.1f} m")
    above = _nearest_text(widths, first, widths > WIDE + 1e-9, f"above {WIDE:.1f} m")
    return f"Wall on the {wall}: {below}; {above}."


def _nearest_text(
    widths: NDArray[np.float64], first: NDArray[np.float64], chosen: NDArray[np.bool_], which: str
) -> str:
    mine = chosen & ~np.isnan(first)
    count = f"{int(mine.sum())} of {int(chosen.sum())} widths {which} turn over"
    if not mine.any():
        return count
    share = 100.0 * first[mine] / widths[mine]
    return (
        f"{count}, the nearest wall that does it being {first[mine].min():.2f} to {first[mine].max():.2f} m "
        f"away ({share.min():.0f} to {share.max():.0f} % of the width)"
    )


def _rule_text(data: xr.Dataset) -> str:
    ratios = data["aspect_ratio"].to_numpy()
    slender = ratios < RATIO - 1e-9
    parts = [
        f"The rule under other inputs: a wall on the left or the right, widths of {WIDTHS[0]:g} to",
        f"{WIDTHS[-1]:g} m, distances up to {100 * SHARES[-1]:.0f} % of the width in steps of",
        f"{100 * SHARES[1]:.0f} %.",
    ]
    for law in LAWS[::-1]:
        mine = data.sel(contact=law)
        broken = mine["broken_share"].to_numpy() > 0.0
        stands = mine["free_share"].to_numpy() == 0.0
        parts.append(
            f"Under the law {law!r} it is broken at {int(broken.sum())} of {broken.size} inputs, at "
            f"{int((broken & stands).sum())} of them though none of the bodies turns over without a wall. "
            f"Of the {int(broken.sum())}, {int(broken[slender].sum())} have a b/h below {RATIO:g}."
        )
    holds = [r for r in ratios if float(data["broken_share"].sel(aspect_ratio=r).max()) == 0.0]
    if holds:
        parts.append(f"With b/h of {_listed(holds)} it is never broken.")
    still = [r for r in ratios if float(data["free_tilt"].sel(aspect_ratio=r).max()) == 0.0]
    if still:
        parts.append(
            f"With b/h of {_listed(still)} no body so much as tilts without a wall: its foot slides, for its "
            f"friction is {FLOOR.edge_friction[0]:g} at rest and {FLOOR.edge_friction[1]:g} sliding."
        )
    parts.append(
        "In the tables of inputs, – means that no wall up to the farthest tried turns a body over, and * "
        "that some turn over without a wall, too."
    )
    return " ".join(parts)


def _listed(values: list[float]) -> str:
    return ", ".join(f"{value:g}" for value in values)
