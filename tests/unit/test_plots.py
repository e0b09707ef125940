"""Plots on axes of the caller's, in Matplotlib's manner, and what notebooks show."""

from __future__ import annotations

import html
import re
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
import pytest
import report_runs
from matplotlib.figure import Figure
from space_runs import falling

import stayput as sp
from stayput.fragility.intensity_measures import JMA_INTENSITY, PGA
from stayput.measures import LBracket

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.axes import Axes

BODY = sp.Body(0.3, 1.8, 90.0, cg_offset=(0.02, -0.1))
ROOM = sp.Room(sp.Floor.of("carpet"), left_wall=sp.Wall(0.02), ceiling=sp.Ceiling(2.4))
SHAKING: dict[str, Any] = {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 4}}
MOTION = sp.near_fault()
SUITE = sp.synthetic_suite("crustal", 3)
BUILDING = sp.Building(5, "RC")
CURVE = sp.FragilityCurve("bookcase", sp.Trials.from_counts(PGA, [2.0, 4.0, 8.0], [4, 19, 36], [40, 40, 40]))


@pytest.fixture(scope="module")
def verdict() -> sp.Verdict:
    return sp.verify(BODY, ROOM, shaking=SHAKING, measures=[LBracket()], samples=8, progress=False)


@pytest.fixture
def ax() -> Axes:
    return Figure().subplots()


def plotted(ax: Axes, draw: Callable[..., Axes], **how: Any) -> Axes:
    """Return axes that were drawn on, after checks that hold for every plot."""
    assert draw(ax=ax, **how) is ax
    assert ax.get_title() == ""
    assert ax.get_xlabel()
    assert ax.get_ylabel() or ax.get_yticklabels()
    return ax


@pytest.mark.parametrize(
    ("draw", "what"),
    [
        (report_runs.rocking().plot, ("tilt", "slide", "acceleration")),
        (falling().plot, ("tilt", "slide", "yaw", "plan", "acceleration")),
        (MOTION.plot, ("acceleration", "velocity", "displacement")),
        (MOTION.spectrum().plot, ("sa", "sv", "sd", "psa", "psv", "sva")),
        (SUITE.plot, ("spectra", "scatter")),
        (BUILDING.respond(MOTION).plot, ("acceleration", "velocity", "spectra")),
    ],
)
def test_each_quantity_is_drawn_on_given_axes(draw: Callable[..., Axes], what: tuple[str, ...]):
    labels = set[str]()
    for one in what:
        axes = plotted(Figure().subplots(), draw, what=one)
        labels.add(axes.get_xlabel() + axes.get_ylabel())
    assert len(labels) == len(what)
    with pytest.raises(sp.InputError, match="must be one of"):
        draw(ax=Figure().subplots(), what="energy")


def test_a_run_is_drawn_with_its_modes_and_critical_angle(ax: Axes):
    run = sp.simulate(BODY, ROOM, MOTION)
    shown = [text.get_text() for text in plotted(ax, run.plot).get_legend().get_texts()]
    assert f"overturned at {run.overturn_time:.2f} s" in shown
    assert "rocks" in shown
    assert any(text.startswith("critical angle") for text in shown)


def test_lines_look_as_one_wants(ax: Axes):
    MOTION.plot(ax, component="y", color="red", label="mine")
    MOTION.spectrum().plot(ax=ax, what="psv", color="green", label="spectrum")
    assert [line.get_color() for line in ax.lines if line.get_label() in ("mine", "spectrum")] == [
        "red",
        "green",
    ]
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["mine", "spectrum"]


def test_curves_on_one_axes_differ_and_share_the_legend(ax: Axes):
    plotted(ax, CURVE.plot)
    CURVE.plot(ax, label="again")
    colours = {line.get_color() for line in ax.lines if len(line.get_xdata()) > 100}
    assert len(colours) == 2
    texts = [text.get_text() for text in ax.get_legend().get_texts()]
    assert texts[0].startswith("bookcase (half fall: 4.04")
    assert texts[1] == "again"
    with pytest.raises(sp.InputError, match="JMA"):
        sp.FragilityCurve("other", sp.Trials.from_counts(JMA_INTENSITY, [5.0, 6.0], [4, 19], [40, 40])).plot(
            ax
        )


def test_mode_shapes_of_a_building_sum_to_one(ax: Axes):
    plotted(ax, BUILDING.plot, modes=5)
    shapes = [line.get_xdata() for line in ax.lines if len(line.get_xdata()) == 6]
    assert np.sum(shapes, axis=0)[1:] == pytest.approx(np.ones(5))


def test_a_body_is_drawn_to_scale_with_its_measures(ax: Axes):
    case = sp.Case(BODY, ROOM, MOTION, measures=(LBracket(),))
    bare = len(plotted(Figure().subplots(), BODY.plot).lines)
    assert len(plotted(ax, case.plot).lines) > bare
    assert ax.get_aspect() == 1.0
    (quantities,) = [text.get_text() for text in ax.texts if "R =" in text.get_text()]
    assert quantities == "R = 0.818 / 0.810 m\nα = 12.0° / 9.2°"  # (h, b) = (0.8, 0.17) and (0.8, 0.13)
    plotted(Figure().subplots(), ROOM.plot)


@pytest.mark.usefixtures("japanese_font")
def test_a_verdict_is_drawn_in_both_languages(verdict: sp.Verdict):
    for language, label in (("en", "Without measures"), ("ja", "対策なし")):
        axes = plotted(Figure().subplots(), verdict.plot, language=language)
        assert label in [text.get_text() for text in axes.get_yticklabels()]


def test_without_axes_a_figure_of_pyplot_is_made():
    from matplotlib import pyplot

    mpl.use("Agg")
    axes = MOTION.plot()
    assert pyplot.fignum_exists(axes.figure.number)
    pyplot.close(axes.figure)


def test_figures_have_a_title_only_where_one_is_given():
    made = (report_runs.rocking(), falling(), MOTION, SUITE, BUILDING.respond(MOTION))
    assert [one.figure().get_suptitle() for one in made] == [""] * len(made)
    assert [one.figure("Mine").get_suptitle() for one in made] == ["Mine"] * len(made)


NOTEBOOK: tuple[tuple[Any, str], ...] = (
    (BODY, "g tan α"),
    (ROOM, "friction"),
    (MOTION, "JMA intensity"),
    (MOTION.spectrum(), "ResponseSpectrum"),
    (SUITE, "synthetic crustal 3"),
    (BUILDING, "natural periods"),
    (CURVE, "50 % fall at"),
    (report_runs.rocking(), "Peak tilt"),
    (falling(), "Outcome"),
)


@pytest.mark.parametrize(("value", "said"), NOTEBOOK, ids=lambda one: type(one).__name__)
def test_notebooks_show_a_picture_and_key_numbers(value: Any, said: str):
    shown = value._repr_html_()
    assert said in shown
    assert re.search(r'src="data:image/png;base64,[\w+/=]+"', shown)
    assert len(shown) < 400_000


def test_notebooks_show_the_ranking_of_a_verdict(verdict: sp.Verdict):
    shown = verdict._repr_html_()
    assert verdict.sentence() in html.unescape(shown)
    assert shown.index("Screwed L-brackets") < shown.index("Without measures")
    # without a device none fails
    assert re.search(r"<tr><th>\d</th><td>Without measures</td>(<td>[^<]*\d[^<]*</td>)+<td>–</td>", shown)
    assert "<td>–</td>" not in shown.split("Without measures")[0]


def test_hostile_names_stay_text():
    shown = sp.Motion(0.01, MOTION.x, name="<script>alert(1)</script>")._repr_html_()
    assert "<script>" not in shown


HOSTILE = r"C:\new $x\y$ station, 50$ % 60$"


def test_dollars_in_names_are_no_mathematics():
    motion = sp.Motion(0.01, MOTION.x, name=HOSTILE)
    run = sp.simulate(BODY, ROOM, motion)
    curve = sp.FragilityCurve(HOSTILE, CURVE.trials)
    shown = (run, motion, curve, sp.Suite((motion,), HOSTILE), falling())
    assert all("data:image/png" in one._repr_html_() for one in shown)
    for figure in (run.figure(HOSTILE), motion.figure(HOSTILE), falling().named([HOSTILE]).figure(HOSTILE)):
        figure.draw_without_rendering()
        assert figure.get_suptitle().replace(r"\$", "$").replace("\n", " ") == HOSTILE
    axes = curve.plot(Figure().subplots())
    axes.figure.draw_without_rendering()
    assert axes.get_legend().get_texts()[0].get_text().startswith(HOSTILE.replace("$", r"\$"))


def test_several_on_the_same_axes_differ_and_zero_is_drawn_once(ax: Axes):
    for factor in (1.0, 0.7, 0.4):
        MOTION.scaled(factor).plot(ax, label=f"{factor}")
    colours = [line.get_color() for line in ax.lines if not str(line.get_label()).startswith("_")]
    assert len(set(colours)) == 3
    assert len(ax.lines) == 4
    spectra = Figure().subplots()
    for factor in (1.0, 0.7):
        MOTION.scaled(factor).spectrum().plot(spectra)
    assert len({line.get_color() for line in spectra.lines}) == 2
    runs = Figure().subplots()
    for factor in (1.0, 0.4):
        sp.simulate(BODY, ROOM, MOTION.scaled(factor)).plot(runs, label=f"{factor}")
    texts = [text.get_text() for text in runs.get_legend().get_texts()]
    assert (texts.count("1.0"), texts.count("0.4"), texts.count("rocks")) == (1, 1, 1)


def test_suites_on_the_same_axes_are_told_apart(ax: Axes):
    other = sp.synthetic_suite("near-fault", 3)
    scatter = Figure().subplots()
    for axis, what, spans in ((ax, "spectra", 3), (scatter, "scatter", 2)):
        SUITE.plot(axis, what=what)
        other.plot(axis, what=what)
        SUITE.plot(axis, what=what, label="mine", color="black")
        texts = [text.get_text() for text in axis.get_legend().get_texts()]
        assert len(texts) == len(set(texts)) == spans + 2
        assert {"synthetic near-fault suite, seed 1", "mine"} <= set(texts)
        thick = [line for line in axis.lines if line.get_linewidth() >= 2.0]
        assert len({line.get_color() for line in thick}) == 3
        low, high = axis.get_ylim()
        assert all(low <= min(line.get_ydata()) and max(line.get_ydata()) <= high for line in thick)


def test_something_else_than_axes_is_refused():
    for wrong in (Figure().subplots(2, 2), Figure(), "ax"):
        with pytest.raises(sp.InputError, match="Axes"):
            MOTION.plot(wrong)
    for projection in ("polar", "3d"):
        with pytest.raises(sp.InputError, match=f"'{projection}'; it must be 'rectilinear'"):
            MOTION.plot(Figure().add_subplot(projection=projection))


def test_a_displacement_that_drifts_has_no_peak(ax: Axes):
    drifting = sp.Motion(0.01, np.sin(np.arange(2000) * 0.1) + 0.02)
    drifting.plot(ax, what="displacement")
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["drifts with the baseline"]


def test_animations_play_in_a_frame_of_their_own():
    for run in (report_runs.rocking(), falling()):
        shown = run.animate()._repr_html_()
        assert shown.startswith("<iframe")
        assert "&lt;script" in shown
        assert "<script" not in shown


def test_short_motions_are_shown_without_an_intensity():
    short = sp.Motion(0.01, [0.0, 1.0, 2.0, 3.0, 0.0])
    shown = short._repr_html_()
    assert "data:image/png" in shown
    assert "JMA intensity" not in shown
    listed = sp.Suite((short, MOTION))._repr_html_()
    assert "<td>–</td>" in listed
    assert f"<td>{MOTION.intensity:.2f}</td>" in listed
