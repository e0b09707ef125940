"""The ranking of what helps, as bars."""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.catalogue import say
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.figures import FONT, style
from stayput.report.fonts import drawable
from stayput.report.palette import COMPONENT_COLOURS, INK
from stayput.report.verdict import numbers
from stayput.verification.words import title

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from stayput.verification import Verdict


def draw_ranking(axis: Axes, verdict: Verdict, language: str) -> None:
    """Draw the share that overturns with each option, with its 95 % interval and value, the best first."""
    style(axis, zero=False)
    for place, option in enumerate(verdict.options):
        chance = option.probabilities[OVERTURNED]
        if chance.runs == 0:
            continue
        low, estimate, high = (100.0 * value for value in (chance.low, chance.estimate, chance.high))
        axis.barh(place, estimate, 0.55, color=COMPONENT_COLOURS["x"])
        axis.errorbar(
            estimate,
            place,
            xerr=[[max(0.0, estimate - low)], [max(0.0, high - estimate)]],
            color=INK,
            capsize=3.0,
            linewidth=1.0,
        )
        axis.text(
            high + 1.5,
            place,
            numbers.share(chance.estimate, language),
            va="center",
            fontsize=FONT - 1.0,
        )
    labels = [drawable(title(option.option, verdict, language)) for option in verdict.options]
    axis.set_yticks(range(len(labels)), labels, fontsize=FONT - 1.0)
    axis.set_ylim(len(labels) - 0.4, -0.6)
    axis.set_xlim(0.0, 112.0)
    axis.set_xticks(range(0, 101, 20))
    axis.set_xlabel(drawable(say("plots.axis_overturned", language)), fontsize=FONT)
