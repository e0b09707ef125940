"""The Tokyo Metropolitan Government's product test of devices against overturning (2015), beside the model.

Furniture on flooring on a shaking table under JMA Kobe of 1995, three components, at 100 % and at 60 %. Seven
devices were tested alone, and a stopper together with a pole. What is used here is the published summary; the
products, which piece each device held, which way the pieces faced and how far the wall was are not part of
it. So the devices go over the usual ranges of the literature (defaults, low confidence), all pieces have all
devices in all facings, and nothing is fitted to the test.
"""

from __future__ import annotations

import math
from itertools import product
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput.measures import GelMats, TensionPole, WedgeStopper
from stayput.model.body import Body
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.room import Ceiling, Floor, Room, Wall
from stayput.montecarlo.runs import run_level
from stayput.montecarlo.sampling import draws, rows_of
from stayput.montecarlo.scaled_motions import FloorMotions
from stayput.motion.synthetic import near_fault
from stayput.report.palette import ALARM, INK
from stayput.scenario.measures import Option
from studies.study import Quantity, Study, claim, panels, span

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from stayput.montecarlo.runs import Runs
    from stayput.motion.record import Motion

BODIES = {"chest": Body(0.42, 1.365, 81.3), "cupboard": Body(0.40, 1.80, 100.4)}
"""The furniture of the test: a chest of drawers (tansu) and a cupboard; width is its depth."""

LEVELS = (1.0, 0.6)
"""Factors on the record."""

ROOM = Room(Floor.of("wood flooring"), left_wall=Wall(0.02), ceiling=Ceiling(2.4))
"""The room: friction is a default; distance to the wall and height of the ceiling are ours."""

FAR, SOME, MOST = 0.30, 0.10, 0.5
"""Movements that the published result tells apart [m]; share of the draws from which on a result is ours."""

NO_DEVICE = Option("no device")

MATS = tuple(
    Option(f"mats {side} × {side} × {thick} mm", ((GelMats(area=side**2 / 1e6, thickness=thick / 1e3),),))
    for side, thick in ((30, 3), (40, 4), (50, 5))
)
"""Four pads each; 100 kPa in tension and 50 kPa in shear on the label, of which 0.7 are reached."""

STOPPERS = tuple(Option(f"stopper {t} mm", ((WedgeStopper(thickness=t / 1e3),),)) for t in (5, 10))
"""About 0.7° and 1.4° of tilt for a cupboard."""

POLES = tuple(
    Option(f"poles {preload} N, ceiling {strength} N", ((TensionPole(preload=preload, strength=strength),),))
    for preload, strength in ((100, 300), (200, 1000))
)
"""Two poles each: the lower and the upper ends of the usual preload and of what a ceiling bears."""

ALONE = (*MATS, *STOPPERS, *POLES)
"""The seven devices that are tested alone."""

TOGETHER = tuple(
    Option(f"{stopper.name} + {poles.name}", (stopper.measures + poles.measures,))
    for stopper, poles in product(STOPPERS, POLES)
)
"""A stopper with poles."""

KINDS = {
    "overturned": ("overturns", ALARM, "////"),
    "far": ("moves 30 cm or more", "#e69f00", "...."),
    "some": ("moves 10 to 30 cm", "#f0e442", ""),
    "little": ("moves less", "#b9d9ee", ""),
}
"""What each outcome is called, its colour and its hatch."""


def facings(motion: Motion) -> dict[str, Motion]:
    """Return the motion as a piece feels it that faces +x, −x and, where there is a y, +y and −y."""
    by_facing = {"+x": motion, "−x": motion.flipped()}
    if motion.y is not None:
        by_facing |= {"+y": motion.rotated(math.pi / 2.0), "−y": motion.rotated(-math.pi / 2.0)}
    return by_facing


def runs_of(
    body: Body,
    room: Room,
    options: Sequence[Option],
    motions: Sequence[Motion],
    level: float,
    samples: int,
    seed: int,
) -> list[Runs]:
    """Run all options at a level, under the same draws of the uncertain quantities."""
    drawn = draws(len(motions), samples, seed)
    rows = [rows_of(body, room, option.measures, drawn, STANDARD_GRAVITY) for option in options]
    return run_level(rows, FloorMotions(tuple(motions), np.full(len(motions), level), {}))


def tested(motion: Motion, options: Sequence[Option], samples: int, seed: int) -> xr.Dataset:
    """Run the furniture of the test with each option, in each direction, at each level.

    Returns
    -------
    xarray.Dataset
        Over ``body``, ``level``, ``device``, ``facing`` and ``sample``: ``overturned``, ``given_up``,
        ``peak_slide`` [m] and ``peak_tilt`` [rad].
    """
    by_facing = facings(motion)
    over = ("body", "level", "device", "facing", "sample")
    runs = [
        [runs_of(body, ROOM, options, tuple(by_facing.values()), level, samples, seed) for level in LEVELS]
        for body in BODIES.values()
    ]
    shape = len(BODIES), len(LEVELS), len(options), len(by_facing), samples
    fields = {"overturned": "overturned", "given_up": "missing", "peak_slide": "slide", "peak_tilt": "tilt"}
    return xr.Dataset(
        {
            name: (
                over,
                np.reshape([[[getattr(r, field) for r in row] for row in rows] for rows in runs], shape),
            )
            for name, field in fields.items()
        },
        {
            "body": list(BODIES),
            "level": list(LEVELS),
            "device": [option.name for option in options],
            "facing": list(by_facing),
        },
    )


def shares(runs: xr.Dataset) -> xr.Dataset:
    """Return shares of the draws in each facing, of those not given up.

    Returns
    -------
    xarray.Dataset
        Over ``body``, ``level``, ``device`` and ``facing``: ``overturned``; of those that stand, ``far`` that
        move 30 cm or more, ``some`` 10 to 30 cm and ``little`` less; ``failed``: overturned or far.
    """
    stands, slide = ~runs["overturned"], runs["peak_slide"]
    kinds = {
        "overturned": runs["overturned"],
        "far": stands & (slide >= FAR),
        "some": stands & (slide >= SOME) & (slide < FAR),
        "little": stands & (slide < SOME),
    }
    means = {name: kind.where(~runs["given_up"]).mean("sample") for name, kind in kinds.items()}
    return xr.Dataset(means | {"failed": means["overturned"] + means["far"]})


def severest(outcomes: xr.Dataset) -> str:
    """Return the facing in which most overturn, over both pieces and all devices alone at the first level."""
    mean = outcomes["overturned"].sel(device=names(ALONE)).isel(level=0).mean(("body", "device"))
    return str(mean["facing"].to_numpy()[int(np.argmax(mean.to_numpy()))])


def tokyo(motion: Motion | None = None, *, samples: int = 32, seed: int = 1) -> Study:
    """Repeat the Tokyo test of devices: what overturns or moves, with each alone and with two together.

    A chest and a cupboard with their backs to a wall, under the motion at 100 % and 60 %; every device and
    facing meets the same draws of what is not known.

    Parameters
    ----------
    motion : Motion, optional
        The record, with y and z where it has them; default `near_fault`. The test's is JMA Kobe 1995.
        The piece faces +x (the component x along its depth, its back to −x), −x and, with a y, +y and −y.
    samples : int
        Draws for each facing.
    seed : int
        Seed of the draws.

    Returns
    -------
    Study
        Data over ``body``, ``level``, ``device``, ``facing`` and ``sample``.
    """
    shaking = near_fault() if motion is None else motion
    runs = tested(shaking, (NO_DEVICE, *ALONE, *TOGETHER), samples, seed)
    outcomes = shares(runs)
    facing = severest(outcomes)
    results = claims(outcomes, facing, "under a synthetic motion, " if shaking.synthetic else "")
    name = f"{shaking.name}{' (synthetic)' if shaking.synthetic else ''}"
    tables = {
        "The published result beside ours": pd.DataFrame(results),
        **{
            f"At {100 * level:g} % of the record: shares of the draws [%] facing {facing}, and over all "
            "facings in brackets": outcomes_table(outcomes, facing, level)
            for level in LEVELS
        },
    }
    return Study(
        name="tokyo",
        title="The Tokyo test of 2015, with stated parameters",
        quantities=_quantities(outcomes, facing, shaking, name),
        data=runs.assign_attrs(motion=shaking.name, severest_facing=facing),
        figure=_drawn(outcomes, facing, name),
        tables=tables,
        claims=tuple(results),
    )


def names(options: Sequence[Option]) -> list[str]:
    """Return the names of options."""
    return [option.name for option in options]


def percent(share: xr.DataArray) -> str:
    """Return the span of some shares in per cent."""
    return f"{span(100.0 * share, '.0f')} %"


def claims(outcomes: xr.Dataset, facing: str, under: str = "") -> list[dict[str, str]]:
    """Return each published result beside ours in one facing.

    Parameters
    ----------
    outcomes : xarray.Dataset
        Shares over body, level, device and facing.
    facing : str
        The facing.
    under : str
        The motion, where it is not that of the test.
    """
    here, count = outcomes.sel(facing=facing), len(ALONE)
    full, reduced = (f"Tokyo's product test 2015, {100.0 * level:g} % of JMA Kobe" for level in LEVELS)
    at_full, at_reduced = (here.sel(device=names(ALONE), level=level) for level in LEVELS)
    fail = int((at_full["failed"].max("body") >= MOST).sum())
    over = int((at_full["overturned"].max("body") >= MOST).sum())
    everywhere = outcomes["failed"].sel(device=names(ALONE), level=LEVELS[0]).max(("body", "facing"))
    cupboard = outcomes["overturned"].sel(body="cupboard", level=LEVELS[1])
    poles, others = (cupboard.sel(device=names(kind)) for kind in (POLES, MATS + STOPPERS))
    by_pole = poles.sel(facing=facing)
    moved = int((at_reduced["some"].max("body") >= MOST).sum())
    pairs = here.sel(body="cupboard", device=names(TOGETHER), level=LEVELS[0])
    held = int((pairs["little"] >= MOST).sum())
    said = f"{under}facing {facing}: "
    return [
        claim(
            full,
            f"all {count} devices alone fail; six let a piece overturn, with one mat it moves 30 cm or more",
            f"{said}{fail} of {count} fail in most draws with one piece at least, {over} of them by "
            f"overturning; {int((everywhere > 0.0).sum())} fail in some draw of some facing",
            fail,
            count,
        ),
        claim(
            reduced,
            "with one pole the cupboard overturns",
            f"{said}by device, it overturns in {percent(by_pole)} of the draws with poles and in "
            f"{percent(others.sel(facing=facing))} with mats or stoppers; over all facings, in "
            f"{percent(poles.mean('facing'))} and {percent(others.mean('facing'))}",
            int(float(by_pole.max()) > 0.0) + int(float(by_pole.max()) >= MOST),
            2,
        ),
        claim(
            reduced,
            "with two others the piece moves 10 to 30 cm",
            f"{said}with {moved} of {count} in most draws; by device and piece in "
            f"{percent(at_reduced['some'])}",
            moved,
            2,
        ),
        claim(
            full,
            "the cupboard with a stopper and a pole does not overturn, and moves 10 cm or less",
            f"{said}so in {percent(pairs['little'])} of the draws by pair, in most with {held} of "
            f"{len(TOGETHER)} pairs; it overturns in {percent(pairs['overturned'])}",
            held,
            len(TOGETHER),
        ),
    ]


def outcomes_table(outcomes: xr.Dataset, facing: str, level: float) -> pd.DataFrame:
    """Return a row for each device: shares of the draws [%] in one facing and, in brackets, over all."""
    rows: list[dict[str, str]] = []
    for device in outcomes["device"].to_numpy().tolist():
        row = {"device": device}
        for body, kind in product(BODIES, ("overturned", "far", "some")):
            share = 100.0 * outcomes[kind].sel(device=device, body=body, level=level)
            row[f"{body} {KINDS[kind][0]}"] = (
                f"{float(share.sel(facing=facing)):.0f} ({float(share.mean()):.0f})"
            )
        rows.append(row)
    return pd.DataFrame(rows)


def _quantities(outcomes: xr.Dataset, facing: str, motion: Motion, name: str) -> dict[str, Quantity]:
    quantities = {
        "motion": Quantity("Motion", name),
        "intensities": Quantity(
            "JMA intensities of the levels", " and ".join(f"{motion.scaled(x).intensity:.1f}" for x in LEVELS)
        ),
        "facing": Quantity("Facing in which most overturn", facing),
    }
    kinds = {"mats": MATS, "stoppers": STOPPERS, "poles": POLES, "both": TOGETHER}
    for (kind, options), level in product(kinds.items(), LEVELS):
        failed = outcomes["failed"].sel(level=level, device=names(options)).mean()
        label = f"Overturned or moved 30 cm or more at {100.0 * level:g} %, {kind} [%]"
        quantities[f"{kind}_{100.0 * level:.0f}"] = Quantity(label, 100.0 * float(failed), form=".1f")
    return quantities


def _drawn(outcomes: xr.Dataset, facing: str, motion: str) -> Figure:
    """Draw the shares of each outcome by device: a panel for each piece and level, in one facing."""
    devices = outcomes["device"].to_numpy().tolist()
    rows = np.arange(len(devices))
    figure, axes = panels(len(BODIES), len(LEVELS), width=6.2, height=4.4, sharex=True, sharey=True)
    for axis, (level, body) in zip(axes, product(LEVELS, BODIES), strict=True):
        at = 100.0 * outcomes.sel(level=level, body=body, facing=facing)
        start = np.zeros(len(devices))
        for kind, (words, colour, hatch) in KINDS.items():
            width = at[kind].to_numpy()
            axis.barh(rows, width, 0.74, start, color=colour, hatch=hatch, edgecolor=INK, label=words)
            start = start + width
        axis.set(title=f"{body}, {100 * level:g} % of the record", xlim=(0.0, 100.0))
        axis.set_yticks(rows, devices)
        axis.set_ylim(len(devices) - 0.5, -0.5)
    for axis in axes[-2:]:
        axis.set_xlabel("share of the draws [%]")
    figure.suptitle(f"{motion}, the piece faces {facing}")
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=len(KINDS), frameon=False)
    return figure
