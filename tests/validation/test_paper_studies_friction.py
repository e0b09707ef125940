"""The paper's §4.2 (14WCEE, 2008): slide over static and kinetic friction, of the study `friction`."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import stayput as sp
from studies.friction import (
    MODELS,
    PAPER_ROWS,
    PAPER_SLIDES,
    deviation,
    effects,
    friction,
    model,
    nearest_sine,
    slides_under,
    unit_sine,
)

G = sp.Case(sp.Body(0.5, 1.0, 100.0), sp.Room(), sp.sine(1.0, 1.0, 1.0)).gravity
COSINE = (90.0,)


@pytest.fixture(scope="module")
def study():
    return friction(amplitudes=np.arange(5.0, 11.1, 0.4), frequencies=np.arange(2.0, 4.6, 0.25), duration=4.0)


@pytest.fixture(scope="module")
def sliding():
    """The three rows of the body that only slides."""
    case = model("held", unit_sine(1.0, 4.0, 90.0))
    return slides_under(case, COSINE, np.array([1.0, 2.0, 3.0]), np.array([0.5, 0.8, 1.2]) * G)


def test_the_paper_s_differences_are_the_other_rows_slides():
    base, kinetic, static = PAPER_SLIDES
    assert base - kinetic == pytest.approx(0.0234, abs=1e-9)
    assert base - static == pytest.approx(0.0310, abs=1e-9)


def test_the_nearest_sine_gives_the_paper_s_slides_as_near_as_stated(study):
    """Each table row is run again on its own."""
    table = study.tables["The nearest sine for each model, with its three slides [cm]"]
    heads = [f"({static:g}, {kinetic:g})" for static, kinetic in PAPER_ROWS]
    for name, row in table.set_index("model").drop("the paper").iterrows():
        motion = unit_sine(row["f [Hz]"], 4.0, row["phase [°]"]).scaled(row["A [m/s²]"])
        case = model(next(key for key, called in MODELS.items() if called == name), motion)
        for head, (static, kinetic), paper in zip(heads, PAPER_ROWS, PAPER_SLIDES, strict=True):
            room = sp.Room(sp.Floor(static, kinetic))
            run = sp.simulate(case.body, room, motion, contact=case.contact)
            assert 100.0 * run.peak_slide == pytest.approx(row[head], rel=1e-6)
            assert abs(run.peak_slide / paper - 1.0) <= row["largest deviation [%]"] / 100.0 + 1e-9


def test_no_sine_gives_the_papers_three_slides(study):
    """So the paper's input was none of these, or its model none of ours."""
    for key in ("held", "paper", "coulomb"):
        assert study.quantities[f"deviation_{key}"].value > 5.0
        slides = [study.quantities[f"slide_{row}_{key}"] for row in (1, 2, 3)]
        assert [slide.published for slide in slides] == pytest.approx([5.44, 3.10, 2.34])
        largest = max(abs(slide.value / slide.published - 1.0) for slide in slides)
        assert 100.0 * largest == pytest.approx(study.quantities[f"deviation_{key}"].value)


def test_static_friction_matters_more_for_longer_where_the_body_may_rock(study):
    """In the paper's order, μ matters more; ours gives it back only for the bodies that are free to rock."""
    for key, static_wins in (("held", False), ("paper", True), ("coulomb", True)):
        by_static, by_kinetic = (study.quantities[f"by_{name}_{key}"] for name in ("static", "kinetic"))
        assert (by_static.value > by_kinetic.value) is static_wins
        assert by_static.published > by_kinetic.published
    slides = study.data.peak_slide.sel(phase=90.0)
    kinetic_wins = (slides.isel(row=1) < slides.isel(row=2)).mean(("frequency", "amplitude"))
    assert all(kinetic_wins.sel(model=name) < kinetic_wins.sel(model="held") for name in ("paper", "coulomb"))


def test_order_of_the_three_rows(study):
    """(.4, .1) slides furthest; with the body free to rock, (.6, .1) least: the paper's order."""
    table = study.tables["The nearest sine for each model, with its three slides [cm]"].set_index("model")
    for name in MODELS.values():
        first, second, third = table.loc[name, ["(0.4, 0.1)", "(0.4, 0.3)", "(0.6, 0.1)"]]
        assert first > max(second, third)
    for name in (MODELS["paper"], MODELS["coulomb"]):
        _, second, third = table.loc[name, ["(0.4, 0.1)", "(0.4, 0.3)", "(0.6, 0.1)"]]
        assert second > third


def test_the_nearest_sine_is_no_worse_than_the_grid():
    case = model("held", unit_sine(2.5, 4.0, 90.0))
    grid = slides_under(case, COSINE, np.array([2.4, 2.6, 2.8]), np.array([6.0, 6.4, 6.8]))
    assert nearest_sine(case, grid).deviation <= float(deviation(grid).min())


def test_pure_sliding_goes_with_the_period_squared(sliding):
    """x'·f² depends on the amplitude alone, at as many waves."""
    motions = {f: unit_sine(f, 4.0 / f, 90.0) for f in (1.0, 2.5)}
    slides = {
        f: slides_under(model("held", motion), COSINE, np.array([f]), np.array([8.0])).peak_slide * f**2
        for f, motion in motions.items()
    }
    assert slides[1.0].to_numpy().ravel() == pytest.approx(slides[2.5].to_numpy().ravel(), rel=1e-3)


def test_both_laws_slide_alike(sliding):
    motion = unit_sine(2.0, 4.0, 90.0)
    held = model("held", motion)
    for static, kinetic in PAPER_ROWS:
        room = sp.Room(sp.Floor(static, kinetic))
        slides = [
            sp.simulate(held.body, room, motion.scaled(0.8 * G), contact=law).peak_slide
            for law in ("coulomb", "paper")
        ]
        assert slides[0] == pytest.approx(slides[1], rel=1e-9)


def test_which_coefficient_matters_more_flips_with_the_amplitude(sliding):
    """Below 0.6 g the third body stays: μ wins. A cosine of 0.8 g slides all at once: μ does nothing."""
    static, kinetic = effects(sliding.sel(phase=90.0))
    assert np.all(sliding.peak_slide.isel(row=2, amplitude=0) == 0.0)
    assert np.all((static > kinetic).isel(amplitude=0))
    assert np.abs(static.isel(amplitude=1)).max() < 1e-9
    assert np.all(kinetic.isel(amplitude=1) > 0.01)


def test_more_kinetic_friction_can_lengthen_the_slide(sliding):
    """Under a slow and strong cosine a body that is slowed slides back less."""
    _, kinetic = effects(sliding.sel(phase=90.0, frequency=1.0, amplitude=1.2 * G))
    assert float(kinetic) < 0.0


@pytest.mark.parametrize("law", ["paper", "coulomb"])
def test_a_body_that_would_slide_at_more_than_b_over_h_rocks(law):
    """b/h = .5 < μ = .6: at 0.62 g it rocks on a corner that sticks, and does not slide."""
    case = model(law, unit_sine(2.6, 4.0, 90.0))
    found = slides_under(case, COSINE, np.array([2.6]), np.array([0.62 * G]))
    assert found.rocks.to_numpy().ravel().tolist() == [False, False, True]
    assert found.peak_slide.isel(row=2).item() == pytest.approx(0.0, abs=1e-9)


def test_its_files(study, tmp_path):
    files = {path.name for path in study.write(tmp_path)}
    assert files == {"friction.nc", "friction.md", "friction.png", "friction.csv", "friction_1.csv"}
    assert files == {path.name for path in tmp_path.iterdir()}
    with xr.open_dataset(tmp_path / "friction.nc", engine="scipy") as data:
        assert data.sizes == study.data.sizes
        assert data.peak_slide.attrs["units"] == "m"
    table = pd.read_csv(tmp_path / "friction_1.csv")
    assert table["model"].tolist() == [*MODELS.values(), "the paper"]
