"""The picture of fragility curves: what it must show, and what it refuses."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from stayput import InputError
from stayput.fragility.curve import FragilityCurve
from stayput.fragility.intensity_measures import JMA_INTENSITY, PGV, IntensityMeasure
from stayput.fragility.trials import Trials
from stayput.report.fragility import plot_fragility

if TYPE_CHECKING:
    from pathlib import Path


def _curve(
    name: str, fell: list[int], measure: IntensityMeasure = JMA_INTENSITY, first: float = 5.0
) -> FragilityCurve:
    im = [first + 0.5 * place for place in range(len(fell))]
    return FragilityCurve(name, Trials.from_counts(measure, im, fell, [40] * len(fell)))


def test_curves_with_and_without_a_median_are_drawn(tmp_path: Path) -> None:
    curves = [_curve("bare", [2, 15, 33, 39]), _curve("bracket", [0, 0, 0, 0])]
    path = tmp_path / "curves.png"
    figure = plot_fragility(curves, path, here=6.25, title="Bookcase", subtitle="40 runs a level")
    assert path.stat().st_size > 10_000
    (axis,) = figure.axes
    told = [text.get_text() for text in figure.legends[0].get_texts()]
    assert told[0].startswith("bare (half fall: 5.6")
    assert told[1] == "bracket (half fall: > 7.03)"
    assert told[2] == "this shaking: 6.25"
    assert len(axis.collections) >= 3  # a band, and bars of both
    assert {"5-upper", "6-lower", "6-upper"} <= {text.get_text() for text in axis.texts}


@pytest.mark.usefixtures("japanese_font")
def test_the_classes_along_the_top_are_named_in_japanese() -> None:
    figure = plot_fragility([_curve("bare", [2, 15, 33, 39])], language="ja")
    (axis,) = figure.axes
    named = {text.get_text() for text in axis.texts}
    assert {"5強", "6弱", "6強"} <= named
    assert not any("-upper" in name or "-lower" in name for name in named)


def test_a_peak_has_its_unit_and_a_logarithmic_axis() -> None:
    figure = plot_fragility([_curve("bare", [2, 15, 33, 39], PGV, 0.2)])
    (axis,) = figure.axes
    assert axis.get_xlabel() == "Peak ground velocity [cm/s]"
    assert axis.get_xscale() == "log"
    assert axis.get_xlim()[0] < 20.0 < axis.get_xlim()[1]


@pytest.mark.parametrize("fell", [[3], [0, 0, 40, 40], [30, 20, 10, 5], [40, 40]])
def test_whatever_fell_can_be_drawn(fell: list[int]) -> None:
    plot_fragility([_curve("x", fell)])


def test_refused() -> None:
    bare = _curve("bare", [2, 15, 33, 39])
    with pytest.raises(InputError, match="number of curves is 0"):
        plot_fragility([])
    with pytest.raises(InputError, match="number of curves is 9"):
        plot_fragility([bare] * 9)
    with pytest.raises(InputError, match="JMA, PGV"):
        plot_fragility([bare, _curve("other", [2, 15, 33], PGV, 0.2)])
