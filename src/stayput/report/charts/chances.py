"""The chances of a verdict: ten pieces of which some lie, and the ranking of what helps."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import Rectangle

from stayput.catalogue import say
from stayput.montecarlo.counting import OVERTURNED
from stayput.report.charts.chart import Chart
from stayput.report.figures import FONT, style
from stayput.report.fonts import drawable
from stayput.report.palette import ALARM, COMPONENT_COLOURS, INK, MUTED
from stayput.report.verdict import numbers
from stayput.verification.words import reason, title

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from stayput.fragility import Probability
    from stayput.report.charts.chart import ChartSource
    from stayput.verification import Verdict
    from stayput.verification.verdict import OptionVerdict

PIECES = 10
"""Pieces that show a chance."""


def tens_chart(verdict: Verdict, shown: Sequence[OptionVerdict], source: ChartSource) -> Chart:
    """Return ten pieces for each option, as many lying as overturn of ten.

    Parameters
    ----------
    verdict : Verdict
        The verdict.
    shown : sequence of OptionVerdict
        The options that are looked at.
    source : ChartSource
        What it is of.
    """
    language = source.language
    chances = [option.probabilities[OVERTURNED] for option in shown]
    fallen = [0 if chance.runs == 0 else round(PIECES * chance.estimate) for chance in chances]
    labels = [title(option.option, verdict, language) for option in shown]

    def draw(figure: Figure) -> None:
        axes = np.atleast_1d(figure.subplots(len(shown), 1))
        for axis, label, chance, count in zip(axes, labels, chances, fallen, strict=True):
            share = numbers.with_interval(chance, language)
            axis.set_title(drawable(f"{label}  {share}"), fontsize=FONT, color=INK, loc="left")
            _draw_ten(axis, count)

    return Chart(
        say("figures.tens", language),
        verdict.sentence(language) + say("page.space", language) + say("figures.tens_note", language),
        source,
        {
            "option": [option.option.name for option in shown],
            "measures": labels,
            **_shares(shown),
            "fallen_of_ten": fallen,
        },
        draw,
        (8.4, 0.5 + 1.5 * len(shown)),
    )


def _draw_ten(axis: Axes, fallen: int) -> None:
    """Draw ten pieces on a floor: those that fell lie first."""
    for place in range(PIECES):
        lies = place < fallen
        x, width, height = (place + 0.05, 0.85, 0.3) if lies else (place + 0.33, 0.34, 0.95)
        colour = ALARM if lies else COMPONENT_COLOURS["x"]
        axis.add_patch(Rectangle((x, 0.0), width, height, facecolor=colour, edgecolor=INK, linewidth=0.6))
    axis.axhline(0.0, color=MUTED, linewidth=1.2)
    axis.set_xlim(-0.1, PIECES + 0.1)
    axis.set_ylim(-0.05, 1.05)
    axis.set_axis_off()


def _shares(options: Sequence[OptionVerdict]) -> dict[str, Sequence[object]]:
    chances = [option.probabilities[OVERTURNED] for option in options]
    return {
        "overturned": [chance.estimate for chance in chances],
        "overturned_low": [chance.low for chance in chances],
        "overturned_high": [chance.high for chance in chances],
        "runs": [chance.runs for chance in chances],
    }


def ranking_chart(verdict: Verdict, source: ChartSource) -> Chart:
    """Return the share that overturns with each option, with its 95 % interval, the best first."""
    language, options = source.language, verdict.options
    labels = [title(option.option, verdict, language) for option in options]
    columns = {
        "rank": [option.rank for option in options],
        "option": [option.option.name for option in options],
        "measures": labels,
        **_shares(options),
        "grade": [verdict.grade(option).value for option in options],
        "reason": [reason(option, verdict, language) for option in options],
    }

    def draw(figure: Figure) -> None:
        draw_ranking(figure.subplots(), verdict, language)

    caption = verdict.sentence(language) + say("page.space", language) + say("figures.ranking_note", language)
    size = (8.4, 1.2 + 0.42 * len(options))
    return Chart(say("figures.ranking", language), caption, source, columns, draw, size)


def draw_ranking(axis: Axes, verdict: Verdict, language: str) -> None:
    """Draw the share that overturns with each option, with its 95 % interval, the best first."""
    labels = [title(option.option, verdict, language) for option in verdict.options]
    draw_shares(axis, labels, [option.probabilities[OVERTURNED] for option in verdict.options], language)
    axis.set_xlabel(drawable(say("figures.axis_overturned", language)), fontsize=FONT)


def draw_shares(axis: Axes, labels: Sequence[str], chances: Sequence[Probability], language: str) -> None:
    """Draw a bar for each of some probabilities, from the top, with its 95 % interval and its value."""
    style(axis, zero=False)
    for place, chance in enumerate(chances):
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
        text = numbers.share(chance.estimate, language)
        axis.text(high + 1.5, place, text, va="center", fontsize=FONT - 1.0)
    axis.set_yticks(range(len(labels)), [drawable(label) for label in labels], fontsize=FONT - 1.0)
    axis.set_ylim(len(labels) - 0.4, -0.6)
    axis.set_xlim(0.0, 112.0)
    axis.set_xticks(range(0, 101, 20))
