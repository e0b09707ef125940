"""Tables of the study of the Tokyo test."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd

from stayput.measures import parameters
from stayput.studies.tokyo.devices import ALONE, MATS, POLES, STOPPERS, TOGETHER
from stayput.studies.tokyo.published import LEVELS

if TYPE_CHECKING:
    import xarray as xr

    from stayput.verification import Option

MOST = 0.5
"""Share of the draws from which on a result counts as ours."""

ALL, REDUCED = LEVELS


@dataclass(frozen=True, slots=True)
class Claim:
    """A published result beside ours.

    Parameters
    ----------
    level : float
        Factor on the record.
    published, ours : str
        What became of the devices.
    verdict : str
        "yes", "partly" or "no": whether it comes out.
    """

    level: float
    published: str
    ours: str
    verdict: str


def _verdict(met: int, wanted: int) -> str:
    return "yes" if met >= wanted else "partly" if met else "no"


def _percent(share: xr.DataArray) -> str:
    low, high = 100.0 * float(share.min()), 100.0 * float(share.max())
    return f"{low:.0f} %" if round(low) == round(high) else f"{low:.0f} to {high:.0f} %"


def names(options: tuple[Option, ...]) -> list[str]:
    """Return the names of options."""
    return [option.name for option in options]


def claims(found: xr.Dataset, facing: str) -> list[Claim]:
    """Return each published result beside ours in one facing.

    Parameters
    ----------
    found : xarray.Dataset
        Shares over body, level, device and facing.
    facing : str
        The facing.
    """
    here = found.sel(facing=facing)
    alone, reduced = (here.sel(device=names(ALONE), level=level) for level in LEVELS)
    failed = alone["failed"].max("body")
    fail, over = int((failed >= MOST).sum()), int((alone["overturned"].max("body") >= MOST).sum())
    any_fail = int((found["failed"].sel(device=names(ALONE), level=ALL).max(("body", "facing")) > 0.0).sum())
    poles = reduced["overturned"].sel(body="cupboard", device=names(POLES))
    others = reduced["overturned"].sel(device=names(MATS + STOPPERS)).max("body")
    moved = int((reduced["some"].max("body") >= MOST).sum())
    pairs = here.sel(body="cupboard", device=names(TOGETHER), level=ALL)
    held = int((pairs["little"] >= MOST).sum())
    return [
        Claim(
            ALL,
            f"all {len(ALONE)} devices alone fail: six let the piece overturn, with one mat it moves 30 cm "
            "or more",
            f"{fail} of {len(ALONE)} fail in most draws with one piece at least, {over} of them by "
            f"overturning; {any_fail} fail in some draw of some facing",
            _verdict(fail, len(ALONE)),
        ),
        Claim(
            REDUCED,
            "with one pole the cupboard overturns",
            f"with poles it overturns in {_percent(poles)} of the draws, with mats or stoppers a piece does "
            f"in {_percent(others)}",
            "yes" if float(poles.max()) >= MOST else "partly" if float(poles.max()) > 0.0 else "no",
        ),
        Claim(
            REDUCED,
            "with two others the piece moves 10 to 30 cm",
            f"with {moved} of {len(ALONE)} in most draws; by device and piece in {_percent(reduced['some'])}",
            _verdict(moved, 2),
        ),
        Claim(
            ALL,
            "the cupboard with a stopper and a pole does not overturn, and moves 10 cm or less",
            f"so in {_percent(pairs['little'])} of the draws by pair, in most with {held} of {len(TOGETHER)} "
            f"pairs; it overturns in {_percent(pairs['overturned'])}",
            _verdict(held, len(TOGETHER)),
        ),
    ]


def claims_table(found: list[Claim]) -> pd.DataFrame:
    """Return a row for each published result."""
    return pd.DataFrame(
        [
            {
                "record": f"{100 * claim.level:g} %",
                "published": claim.published,
                "ours, severest facing": claim.ours,
                "comes out": claim.verdict,
            }
            for claim in found
        ]
    )


def outcomes_table(found: xr.Dataset, facing: str, level: float) -> pd.DataFrame:
    """Return a row for each device: shares of the draws [%] in one facing and, in brackets, over all."""
    at = found.sel(level=level)
    rows: list[dict[str, str]] = []
    for device in at["device"].to_numpy():
        row = {"device": str(device)}
        for body in at["body"].to_numpy():
            one = 100.0 * at.sel(device=device, body=body)
            for name, words in (("overturned", "overturns"), ("far", "≥ 30 cm"), ("some", "10–30 cm")):
                here, mean = float(one[name].sel(facing=facing)), float(one[name].mean())
                row[f"{body} {words}"] = f"{here:.0f} ({mean:.0f})"
        rows.append(row)
    return pd.DataFrame(rows)


def variations_table(varied: xr.Dataset) -> pd.DataFrame:
    """Return a row for each variation: shares that overturn [%] over all facings, the largest in brackets."""
    rows: list[dict[str, str]] = []
    for name in varied["variation"].to_numpy():
        row = {"changed": str(name)}
        for level in varied["level"].to_numpy():
            for probe in varied["probe"].to_numpy():
                one = 100.0 * varied["overturned"].sel(variation=name, level=level, probe=probe).to_numpy()
                text = "" if np.isnan(one).all() else f"{one.mean():.0f} ({one.max():.0f})"
                row[f"{probe}, {100 * float(level):g} %"] = text
        rows.append(row)
    return pd.DataFrame(rows)


def devices_table() -> pd.DataFrame:
    """Return what the devices are: each parameter with its values over the devices of a kind."""
    rows: list[dict[str, str]] = []
    for options in (MATS, STOPPERS, POLES):
        measures = [option.measures[0] for option in options]
        for about in parameters(measures[0]):
            values = dict.fromkeys(getattr(measure, about.name) for measure in measures)
            if None in values:
                continue
            rows.append(
                {
                    "device": measures[0].label[0],
                    "parameter": about.label[0],
                    "value": ", ".join(f"{value:.4g}" for value in values),
                    "unit": about.unit,
                    "confidence": str(about.confidence),
                }
            )
    return pd.DataFrame(rows)
