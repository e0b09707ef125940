"""Figures of the study of the Tokyo test."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import Patch

from stayput.report.figures import FONT, new_figure, style
from stayput.report.palette import ALARM, INK, MUTED
from stayput.studies.tokyo.devices import ALONE

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure

KINDS = {
    "overturned": ("overturns", ALARM, "////"),
    "far": ("moves 30 cm or more", "#e69f00", "...."),
    "some": ("moves 10 to 30 cm", "#f0e442", ""),
    "little": ("moves less", "#b9d9ee", ""),
}
"""What each outcome is called, its colour and its hatch."""

PROBE_LOOKS = (("#6b7580", "o"), ("#cc79a7", "^"), ("#8c5a2b", "v"), ("#0072b2", "s"), ("#009e73", "D"))
"""Colour and marker of each device that is varied."""


def draw_outcomes(found: xr.Dataset, facing: str, motion: str) -> Figure:
    """Draw the shares of each outcome by device: a panel for each piece and level, in one facing."""
    levels, bodies = found["level"].to_numpy(), found["body"].to_numpy()
    devices = [str(name) for name in found["device"].to_numpy()]
    rows = np.arange(len(devices))
    figure = new_figure(12.5, 0.36 * len(devices) * len(levels) + 1.8)
    panels = figure.subplots(len(levels), len(bodies), sharex=True, sharey=True, squeeze=False)
    for across, level in zip(panels, levels, strict=True):
        for axis, body in zip(across, bodies, strict=True):
            at = 100.0 * found.sel(level=level, body=body, facing=facing)
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


def draw_facings(found: xr.Dataset, motion: str) -> Figure:
    """Draw the share that overturns by device and facing: a panel for each piece and level."""
    levels, bodies = found["level"].to_numpy(), found["body"].to_numpy()
    devices = [str(name) for name in found["device"].to_numpy()]
    facings = [str(name) for name in found["facing"].to_numpy()]
    figure = new_figure(12.0, 0.36 * len(devices) + 1.6)
    panels = figure.subplots(1, len(levels) * len(bodies), sharey=True, squeeze=False).ravel()
    pairs = [(body, level) for body in bodies for level in levels]
    for axis, (body, level) in zip(panels, pairs, strict=True):
        share = 100.0 * found["overturned"].sel(body=body, level=level).to_numpy()
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
