"""The Tokyo Metropolitan Government's product test of 2015 with stated parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.patches import Patch

from stayput.errors import whole_within
from stayput.measures import parameters
from stayput.motion import near_fault
from stayput.progress import bar
from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import ALARM, INK, MUTED
from studies.study import NO, PARTLY, YES, Claim, Quantity, Study, claims_table, outcome_of, span
from studies.tokyo_runs import (
    ALONE,
    BODIES,
    LEVELS,
    MATS,
    OPTIONS,
    PIECE,
    POLES,
    PROBES,
    STOPPERS,
    TOGETHER,
    VARIATIONS,
    facings,
    severest,
    shares,
    tested,
    varied,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from stayput.motion import Motion
    from stayput.verification import Option

MOST = 0.5
"""Share of the draws from which on a result counts as ours."""

ALL, REDUCED = LEVELS

KINDS = {
    "overturned": ("overturns", ALARM, "////"),
    "far": ("moves 30 cm or more", "#e69f00", "...."),
    "some": ("moves 10 to 30 cm", "#f0e442", ""),
    "little": ("moves less", "#b9d9ee", ""),
}
"""What each outcome is called, its colour and its hatch."""

PROBE_LOOKS = (("#6b7580", "o"), ("#cc79a7", "^"), ("#8c5a2b", "v"), ("#0072b2", "s"), ("#009e73", "D"))
"""Colour and marker of each device that is varied."""


def tokyo(
    motion: Motion | None = None, *, samples: int = 32, seed: int = 1, variations: bool = True
) -> Study:
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
    variations : bool
        Whether to change stated values one at a time, too.

    Returns
    -------
    Study
        Figures "outcomes", "facings" and "variations". Data over ``body``, ``level``, ``device``, ``facing``
        and ``sample``, and ``overturned_share`` over ``variation``, ``level``, ``probe`` and ``facing``.

    Raises
    ------
    InputError
        A number of samples or a seed out of range.

    Examples
    --------
    >>> import studies
    >>> quick = studies.tokyo(samples=1, variations=False)
    >>> for claim in (quick.claims[0], quick.claims[3]):
    ...     print(f"{claim.published}: {claim.outcome}")
    all 7 devices alone fail: six let the piece overturn, with one mat it moves 30 cm or more: partly
    the cupboard with a stopper and a pole does not overturn, and moves 10 cm or less: yes
    """
    shaking = near_fault() if motion is None else motion
    count = whole_within("studies.samples", samples, 1, 10_000)
    changed = VARIATIONS if variations else VARIATIONS[:1]
    each = len(facings(shaking)) * count * len(LEVELS)
    touched = sum(variation.touches(option) for variation in changed for option in PROBES)
    with bar(each * (len(BODIES) * len(OPTIONS) + touched), "progress.studying") as advance:
        runs = tested(shaking, OPTIONS, count, seed, advance)
        change = varied(shaking, changed, count, seed, advance)
    outcomes = shares(runs)
    facing = severest(outcomes, names(ALONE))
    results = claims(outcomes, facing, "under a synthetic motion, " if shaking.synthetic else "")
    name = f"{shaking.name or 'the record'}{' (synthetic)' if shaking.synthetic else ''}"
    tables = {"The published result beside ours": claims_table(results)}
    for level in LEVELS:
        caption = (
            f"At {100 * level:g} % of the record: shares of the draws [%] facing {facing}, "
            "and over all facings in brackets"
        )
        tables[caption] = outcomes_table(outcomes, facing, level)
    figures = {"outcomes": draw_outcomes(outcomes, facing, name), "facings": draw_facings(outcomes, name)}
    if variations:
        figures["variations"] = draw_variations(change, PIECE, name)
        tables[
            f"Shares of the draws in which the {PIECE} overturns [%], over all facings, and the largest of a "
            "facing in brackets; empty: not touched"
        ] = variations_table(change)
    tables["What the devices are here; several values: one for each device"] = devices_table()
    return Study(
        name="tokyo",
        title="The Tokyo test of 2015, with stated parameters",
        quantities=_quantities(outcomes, facing, results),
        data=xr.merge([runs, change.rename(overturned="overturned_share")]).assign_attrs(
            motion=shaking.name, severest_facing=facing, seed=seed
        ),
        figures=figures,
        tables=tables,
        claims=tuple(results),
    )


def _percent(share: xr.DataArray) -> str:
    return f"{span(100.0 * share, '.0f')} %"


def names(options: tuple[Option, ...]) -> list[str]:
    """Return the names of options."""
    return [option.name for option in options]


def source_of(level: float) -> str:
    """Return what the test at a level of the record is called."""
    return f"Tokyo's product test 2015, {100.0 * level:g} % of JMA Kobe"


def claims(outcomes: xr.Dataset, facing: str, under: str = "") -> list[Claim]:
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
    here = outcomes.sel(facing=facing)
    alone, reduced = (here.sel(device=names(ALONE), level=level) for level in LEVELS)
    failed = alone["failed"].max("body")
    fail, over = int((failed >= MOST).sum()), int((alone["overturned"].max("body") >= MOST).sum())
    any_fail = int(
        (outcomes["failed"].sel(device=names(ALONE), level=ALL).max(("body", "facing")) > 0.0).sum()
    )
    cupboard = outcomes["overturned"].sel(body="cupboard", level=REDUCED)
    poles, others = (cupboard.sel(device=names(kind)) for kind in (POLES, MATS + STOPPERS))
    by_pole = poles.sel(facing=facing)
    moved = int((reduced["some"].max("body") >= MOST).sum())
    pairs = here.sel(body="cupboard", device=names(TOGETHER), level=ALL)
    held = int((pairs["little"] >= MOST).sum())
    said = f"{under}facing {facing}: "
    return [
        Claim(
            source_of(ALL),
            f"all {len(ALONE)} devices alone fail: six let the piece overturn, with one mat it moves 30 cm "
            "or more",
            f"{said}{fail} of {len(ALONE)} fail in most draws with one piece at least, {over} of them by "
            f"overturning; {any_fail} fail in some draw of some facing",
            outcome_of(fail, len(ALONE)),
        ),
        Claim(
            source_of(REDUCED),
            "with one pole the cupboard overturns",
            f"{said}by device, it overturns in {_percent(by_pole)} of the draws with poles and in "
            f"{_percent(others.sel(facing=facing))} with mats or stoppers; over all facings, in "
            f"{_percent(poles.mean('facing'))} and {_percent(others.mean('facing'))}",
            YES if float(by_pole.max()) >= MOST else PARTLY if float(by_pole.max()) > 0.0 else NO,
        ),
        Claim(
            source_of(REDUCED),
            "with two others the piece moves 10 to 30 cm",
            f"{said}with {moved} of {len(ALONE)} in most draws; by device and piece in "
            f"{_percent(reduced['some'])}",
            outcome_of(moved, 2),
        ),
        Claim(
            source_of(ALL),
            "the cupboard with a stopper and a pole does not overturn, and moves 10 cm or less",
            f"{said}so in {_percent(pairs['little'])} of the draws by pair, in most with {held} of "
            f"{len(TOGETHER)} pairs; it overturns in {_percent(pairs['overturned'])}",
            outcome_of(held, len(TOGETHER)),
        ),
    ]


def outcomes_table(outcomes: xr.Dataset, facing: str, level: float) -> pd.DataFrame:
    """Return a row for each device: shares of the draws [%] in one facing and, in brackets, over all."""
    at = outcomes.sel(level=level)
    rows: list[dict[str, str]] = []
    for device in at["device"].to_numpy():
        row = {"device": str(device)}
        for body in at["body"].to_numpy():
            share = 100.0 * at.sel(device=device, body=body)
            for name, words in (("overturned", "overturns"), ("far", "≥ 30 cm"), ("some", "10–30 cm")):
                here, mean = float(share[name].sel(facing=facing)), float(share[name].mean())
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
                share = 100.0 * varied["overturned"].sel(variation=name, level=level, probe=probe).to_numpy()
                text = "" if np.isnan(share).all() else f"{share.mean():.0f} ({share.max():.0f})"
                row[f"{probe}, {100 * float(level):g} %"] = text
        rows.append(row)
    return pd.DataFrame(rows)


def devices_table() -> pd.DataFrame:
    """Return the devices' parameters, each with its values over the devices of a kind."""
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
                    "value": ", ".join(
                        value if isinstance(value, str) else f"{value:.4g}" for value in values
                    ),
                    "unit": about.unit,
                    "confidence": str(about.confidence),
                }
            )
    return pd.DataFrame(rows)


def _quantities(outcomes: xr.Dataset, facing: str, results: list[Claim]) -> dict[str, Quantity]:
    quantities = {"facing": Quantity("Facing in which most overturn", facing)}
    for place, claim in enumerate(results, 1):
        label = f"{claim.source}, comes out: {claim.outcome}"
        quantities[f"claim_{place}"] = Quantity(label, claim.ours, claim.published)
    kinds = {"mats": MATS, "stoppers": STOPPERS, "poles": POLES, "both": TOGETHER}
    for kind, options in kinds.items():
        for level in LEVELS:
            failed = 100.0 * outcomes["failed"].sel(level=level, device=names(options))
            device = "a stopper with poles" if kind == "both" else kind
            label = f"Overturned or moved 30 cm or more at {100.0 * level:g} %, {device} [%]"
            mean = float(failed.mean(("body", "facing")).mean())
            quantities[f"{kind}_{100.0 * level:.0f}"] = Quantity(label, mean, form=".1f")
    return quantities


def draw_outcomes(outcomes: xr.Dataset, facing: str, motion: str) -> Figure:
    """Draw the shares of each outcome by device: a panel for each piece and level, in one facing."""
    levels, bodies = outcomes["level"].to_numpy(), outcomes["body"].to_numpy()
    devices = [str(name) for name in outcomes["device"].to_numpy()]
    rows = np.arange(len(devices))
    figure = new_figure(12.5, 0.36 * len(devices) * len(levels) + 1.8)
    panels = figure.subplots(len(levels), len(bodies), sharex=True, sharey=True, squeeze=False)
    for across, level in zip(panels, levels, strict=True):
        for axis, body in zip(across, bodies, strict=True):
            at = 100.0 * outcomes.sel(level=level, body=body, facing=facing)
            start = np.zeros(len(devices))
            for name, (_, colour, hatch) in KINDS.items():
                width = at[name].to_numpy()
                axis.barh(rows, width, 0.74, start, color=colour, hatch=hatch, edgecolor=INK, linewidth=0.5)
                start = start + width
            style(axis, zero=False)
            for line in (0.5, 0.5 + len(ALONE)):
                axis.axhline(line, color=MUTED, linewidth=1.0, linestyle="--")
            axis.set_title(f"{body}, {100 * float(level):g} % of the record", fontsize=FONT, color=INK)
            axis.set_yticks(rows, devices, fontsize=FONT - 1.0)
            axis.set_ylim(len(devices) - 0.5, -0.5)
            axis.set_xlim(0.0, 100.0)
    for axis in panels[-1]:
        axis.set_xlabel("share of the draws [%]", fontsize=FONT)
    figure.suptitle(f"{motion}, the piece faces {facing}", fontsize=FONT + 1.0, color=INK)
    figure.legend(
        handles=[Patch(facecolor=c, hatch=h, edgecolor=INK, label=words) for words, c, h in KINDS.values()],
        loc="outside lower center",
        ncols=len(KINDS),
        fontsize=FONT,
        frameon=False,
    )
    return figure


def draw_facings(outcomes: xr.Dataset, motion: str) -> Figure:
    """Draw the share that overturns by device and facing: a panel for each piece and level."""
    levels, bodies = outcomes["level"].to_numpy(), outcomes["body"].to_numpy()
    devices = [str(name) for name in outcomes["device"].to_numpy()]
    facings = [str(name) for name in outcomes["facing"].to_numpy()]
    figure = new_figure(12.0, 0.36 * len(devices) + 1.6)
    panels = figure.subplots(1, len(levels) * len(bodies), sharey=True, squeeze=False).ravel()
    pairs = [(body, level) for body in bodies for level in levels]
    for axis, (body, level) in zip(panels, pairs, strict=True):
        share = 100.0 * outcomes["overturned"].sel(body=body, level=level).to_numpy()
        axis.imshow(share, cmap="Oranges", vmin=0.0, vmax=130.0, aspect="auto")
        for row, column in np.ndindex(*share.shape):
            value = share[row, column]
            axis.text(column, row, f"{value:.0f}", ha="center", va="center", fontsize=FONT - 1.0, color=INK)
        axis.axhline(0.5, color=MUTED, linewidth=1.0)
        axis.axhline(0.5 + len(ALONE), color=MUTED, linewidth=1.0)
        axis.set_xticks(range(len(facings)), facings, fontsize=FONT)
        axis.set_yticks(range(len(devices)), devices, fontsize=FONT - 1.0)
        axis.set_title(f"{body}, {100 * float(level):g} %", fontsize=FONT, color=INK)
        axis.set_xlabel("the piece faces", fontsize=FONT)
    figure.suptitle(f"Overturned under {motion} [% of the draws]", fontsize=FONT + 1.0, color=INK)
    return figure


def draw_variations(varied: xr.Dataset, piece: str, motion: str) -> Figure:
    """Draw the share that overturns over all facings under each variation: a panel for each level."""
    levels = varied["level"].to_numpy()
    names = [str(name) for name in varied["variation"].to_numpy()]
    probes = [str(name) for name in varied["probe"].to_numpy()]
    rows = np.arange(len(names))
    figure = new_figure(12.0, 0.34 * len(names) + 1.7)
    panels = figure.subplots(1, len(levels), sharex=True, sharey=True, squeeze=False).ravel()
    offsets = np.linspace(-0.3, 0.3, len(probes))
    for axis, level in zip(panels, levels, strict=True):
        for place, probe in enumerate(probes):
            share = 100.0 * varied["overturned"].sel(level=level, probe=probe).mean("facing").to_numpy()
            colour, marker = PROBE_LOOKS[place % len(PROBE_LOOKS)]
            axis.axvline(share[0], color=colour, linewidth=0.9, linestyle=":")
            axis.plot(share, rows + offsets[place], marker, color=colour, markersize=6.0, label=probe)
        style(axis, zero=False)
        for row in rows[1:]:
            axis.axhline(row - 0.5, color=MUTED, linewidth=0.3)
        axis.grid(False, axis="y")
        axis.set_yticks(rows, names, fontsize=FONT - 1.0)
        axis.set_ylim(len(names) - 0.5, -0.5)
        axis.set_xlim(-2.0, 102.0)
        axis.set_title(f"{piece}, {100 * float(level):g} % of the record", fontsize=FONT, color=INK)
        axis.set_xlabel("overturned, mean of all facings [% of the draws]", fontsize=FONT)
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(
        handles, labels, loc="outside lower center", ncols=len(probes), fontsize=FONT - 1.0, frameon=False
    )
    figure.suptitle(f"{motion}; dotted: as stated", fontsize=FONT + 1.0, color=INK)
    return figure
