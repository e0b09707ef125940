"""The plane beside space: what the study says of shapes holds on fewer motions too."""

import pytest

from stayput.simulation.case import simulate
from studies.three_dimensions import (
    PLANE,
    SETTINGS,
    SPACE,
    STRONGER,
    Shaken,
    differing,
    less_space,
    outcomes,
    three_dimensions,
)


@pytest.fixture(scope="module")
def study():
    return three_dimensions(2, headings=[0.0, 90.0])


def of(study, kind, level="6-upper"):
    return study.data.sel(setting=study.data["kind"] == kind, level=level)


def test_where_length_is_less_than_depth_the_plane_says_far_too_little(study):
    for level in ("6-lower", "6-upper"):
        assert less_space(of(study, "short", level), PLANE).estimate < -0.25
    assert differing(of(study, "short"), PLANE) > 2.0 * differing(of(study, "long"), PLANE)


def test_cylinders_roll_over(study):
    assert less_space(of(study, "round"), PLANE).estimate < -0.1


def test_of_long_pieces_the_plane_does_not_say_clearly_too_little(study):
    for engine in (PLANE, STRONGER):
        assert less_space(of(study, "long"), engine).high > 0.0


def test_brackets_hold_in_both(study):
    held = study.data.sel(setting="bookcase, wall, brackets")
    assert held["overturned"].mean(("level", "heading", "motion")).max() < 0.05


def test_no_run_is_given_up_and_no_share_is_of_itself(study):
    assert study.quantities["given_up"].value == 0
    assert differing(study.data, SPACE) == 0.0


def test_the_stronger_component_does_not_ask_for_the_heading(study):
    stronger = study.data.sel(engine=STRONGER)
    first = stronger.isel(heading=0)
    assert (stronger["overturned"] == first["overturned"]).all()
    assert (stronger["slide"] == first["slide"]).all()


def test_a_run_is_that_of_simulate():
    shaken = Shaken.of(1, [30.0], 1)
    setting = SETTINGS[0]
    found = outcomes(setting, 6.25, shaken)
    factor = float(shaken.drawn.columns["friction"][0, 0])
    floors = shaken.hazards[SPACE][0].at(6.25)
    motion = floors.motions[0].scaled(float(floors.scales[0]))
    for engine, dimensions in ((PLANE, 2), (SPACE, 3)):
        run = simulate(setting.body, setting.room(factor), motion, dimensions=dimensions)
        assert run.overturned == found[engine].overturned[0, 0]
        assert run.peak_slide == pytest.approx(found[engine].slide[0, 0], rel=1e-6)
