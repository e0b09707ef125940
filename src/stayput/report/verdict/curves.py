"""The picture of the fragility curves, with JMA's classes and the shaking in question."""

from __future__ import annotations

from typing import TYPE_CHECKING

from stayput.catalogue import say
from stayput.fragility.curve import CurveState
from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.report.figures import classes_between
from stayput.report.verdict import numbers, svg
from stayput.report.verdict.numbers import word
from stayput.verification.words import class_label, title

if TYPE_CHECKING:
    from stayput.fragility.curve import FragilityCurve
    from stayput.verification import Verdict


WIDTH, HEIGHT = 600.0, 400.0
LEFT, RIGHT, TOP, BOTTOM = 74.0, 590.0, 34.0, 346.0
LOOKS = 11
"""Looks of lines that the page's style has: the first is that of no measure, the second of the best."""

_POINTS = 191


def looks(verdict: Verdict) -> dict[str, int]:
    """Return the look of each option's line, by its name: 0 without a measure, the others as they rank."""
    names = [result.option.name for result in verdict.options if result.option.measures]
    by_name = {name: 1 if n == 0 else 2 + (n - 1) % (LOOKS - 2) for n, name in enumerate(names)}
    return by_name | {verdict.without.option.name: 0}


def legend(verdict: Verdict, language: str) -> list[dict[str, object]]:
    """Return the legend, the best option first: each look, label, and whether there is a curve."""
    look_of, entries = looks(verdict), list[dict[str, object]]()
    for result in verdict.options:
        if result.curves:
            state = result.curves[JMA_INTENSITY].state
            label = title(result.option, verdict, language)
            note = "" if state is CurveState.FITTED else word("no_curve", language, state=state.phrase)
            entries.append({"look": look_of[result.option.name], "label": label, "note": note})
    return entries


def curves_svg(verdict: Verdict, language: str) -> str:
    """Return the picture: curves of all options, bands and counts of no measure and of the best.

    Parameters
    ----------
    verdict : Verdict
        A verdict with curves.
    language : str
        "en" or "ja".
    """
    levels = verdict.levels
    x = svg.PixelAxis(float(levels[0]) - 0.1, float(levels[-1]) + 0.1, LEFT, RIGHT)
    y = svg.PixelAxis(0.0, 1.0, BOTTOM, TOP)
    label = say("fragility.floor_jma" if verdict.floor else "report.axis_intensity", language)
    parts = [*([] if verdict.floor else _classes(x, language)), *_frame(x, y, label, language)]
    look_of = looks(verdict)
    shown = [verdict.without, *([verdict.best] if verdict.best.option.measures else [])]
    parts += [_band(x, y, result.curves[JMA_INTENSITY], look_of[result.option.name]) for result in shown]
    for result in reversed(verdict.options):
        curve = result.curves[JMA_INTENSITY]
        if curve.state is CurveState.FITTED:
            grid = curve.grid(_POINTS)
            style = f"curve look{look_of[result.option.name]}"
            parts.append(svg.polyline(x.at(grid), y.at(curve.probability(grid)), style))
    for result in shown:
        parts += _counts(x, y, result.curves[JMA_INTENSITY], look_of[result.option.name])
    if x.low <= verdict.intensity <= x.high:
        parts += _here(x, verdict.intensity, language)
    return svg.drawing(WIDTH, HEIGHT, parts, word("fragility_alt", language), "chart")


def _classes(x: svg.PixelAxis, language: str) -> list[str]:
    """Return bands of every second class of JMA's intensity, and the classes' names along the top."""
    parts: list[str] = []
    for shaded, name, low, high in classes_between(x.low, x.high):
        left, right = x.place(low), x.place(high)
        if shaded:
            parts.append(svg.box(left, TOP, right, BOTTOM, "classes"))
        if right - left > 40.0:
            name_shown = name if language == "en" else class_label(0.5 * (low + high), language)
            parts.append(svg.label(0.5 * (left + right), TOP - 8.0, name_shown))
    return parts


def _frame(x: svg.PixelAxis, y: svg.PixelAxis, label: str, language: str) -> list[str]:
    parts: list[str] = []
    for share in (0.0, 0.2, 0.4, 0.6, 0.8, 1.0):
        level = y.place(share)
        parts.append(svg.line(LEFT, level, RIGHT, level, "grid"))
        parts.append(svg.label(LEFT - 7.0, level + 4.5, numbers.share(share, language), anchor="end"))
    for value in svg.ticks(x.low, x.high, 7):
        parts += svg.tick(x.place(value), BOTTOM, f"{value:.1f}")
    parts.append(svg.line(LEFT, BOTTOM, RIGHT, BOTTOM, "axis"))
    parts.append(svg.label(0.5 * (LEFT + RIGHT), BOTTOM + 42.0, label, "name"))
    middle = 0.5 * (TOP + BOTTOM)
    turned = svg.label(0.0, 0.0, word("axis_share", language), "name")
    parts.append(svg.element("g", turned, transform=f"translate(14 {middle:.0f}) rotate(-90)"))
    return parts


def _band(x: svg.PixelAxis, y: svg.PixelAxis, curve: FragilityCurve, look: int) -> str:
    if curve.state is not CurveState.FITTED or curve.one_motion:
        return ""
    grid = curve.grid(_POINTS)
    low, high = curve.band(grid)
    upper = zip(x.at(grid).tolist(), y.at(high).tolist(), strict=True)
    lower = zip(x.at(grid[::-1]).tolist(), y.at(low[::-1]).tolist(), strict=True)
    return svg.polygon([*upper, *lower], f"band look{look}")


def _counts(x: svg.PixelAxis, y: svg.PixelAxis, curve: FragilityCurve, look: int) -> list[str]:
    """Return marks of the observed shares: circles without a measure, squares with one."""
    parts: list[str] = []
    for level in curve.levels:
        across, up = x.place(level.im), y.place(level.probability.estimate)
        if look == 0:
            parts.append(svg.element("circle", cx=across, cy=up, r=3.5, class_=f"mark look{look}"))
        else:
            parts.append(svg.box(across - 3.2, up - 3.2, across + 3.2, up + 3.2, f"mark look{look}"))
    return parts


def _here(x: svg.PixelAxis, intensity: float, language: str) -> list[str]:
    across = x.place(intensity)
    right = across < 0.5 * (LEFT + RIGHT)
    text = word("here", language, value=JMA_INTENSITY.text(intensity))
    place, anchor = (across + 6.0, "start") if right else (across - 6.0, "end")
    return [
        svg.line(across, TOP, across, BOTTOM, "here"),
        svg.label(place, TOP + 16.0, text, "name halo", anchor),
    ]
