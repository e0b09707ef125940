"""The scale of how firmly a piece stands, by statics: critical angles, walls that hold what would fall."""

import itertools
import math

import numpy as np
import pytest
from setups import still
from test_ladder import gap_for

import stayput as sp
from stayput.report.animation import film_of, player_page
from stayput.report.film.scene import posed
from stayput.report.page import inks_css
from stayput.report.palette import STABILITY_COLOURS, stability_looks
from stayput.simulation.space_fate import (
    FALLS_FROM,
    MAY_FALL_FROM,
    Stability,
    expected,
    over_time,
    past_critical,
)

BODY = sp.Body(0.3, 1.8, 90.0, length=0.9)
ORDER = list(Stability)


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_what_leans_at_50_degrees_against_a_wall_falls(side):
    tilt = math.radians(50.0)
    walls = dict.fromkeys(
        ["right_wall" if side > 0.0 else "left_wall"], sp.Wall(gap_for(BODY, tilt), friction=1.0)
    )
    room = sp.Room(sp.Floor(2.0, 2.0), **walls)
    run = sp.simulate(BODY, room, still(2.0), initial=sp.State(tilt=side * tilt))
    assert run.outcome is sp.Outcome.LEANING
    assert set(over_time(posed(run), 0)) == {"falls"}


@pytest.mark.parametrize("direction", np.linspace(0.0, 2.0 * math.pi, 9))
def test_a_box_is_past_its_critical_angle_where_its_centre_of_gravity_has_passed_its_foot(direction):
    """At atan(reach of the base that way / height of G): half a side over an edge, more over a corner."""
    piece = sp.Piece(sp.Body.box(0.3, 0.9, 1.8, 90.0))
    towards = np.array([math.cos(direction), math.sin(direction)])
    critical = math.atan(np.abs(towards) @ [0.15, 0.45] / 0.9)
    axis = np.array([-towards[1], towards[0], 0.0])
    across = np.cross(np.eye(3), axis)

    def past(angle: float) -> bool:
        turn = np.eye(3) + math.sin(angle) * across + (1.0 - math.cos(angle)) * across @ across
        assert turn[:2, 2] == pytest.approx(math.sin(angle) * towards)
        return bool(past_critical(piece, np.zeros((1, 3)), turn[np.newaxis])[0])

    assert not past(0.0)
    assert not past(critical - 1e-6)
    assert past(critical + 1e-6)
    assert past(2.0)


def test_a_run_stays_then_rocks_then_falls_for_good():
    body, room = sp.Body(0.3, 1.8, 90.0, length=0.9), sp.Room(sp.Floor(0.6, 0.5))
    run = posed(sp.simulate(body, room, sp.near_fault()))
    steps = over_time(run, 0)
    assert steps[0] == "stays"
    assert "moves" in steps
    overturns = run.time >= run.overturn_time
    assert set(steps[overturns]) == {"falls"}
    beyond = np.abs(run.tilt) > body.slenderness[0] + 1e-6
    assert set(steps[beyond]) == {"falls"}
    assert "falls" not in steps[~beyond & ~overturns]
    assert "stays" not in steps[np.abs(run.tilt) > math.radians(0.51)]


def test_what_slides_moves_and_stays_when_it_has_come_to_rest():
    run = sp.simulate(
        sp.Body(0.6, 0.6, 30.0, length=0.6), sp.Room(sp.Floor(0.2, 0.2)), sp.sine(4.0, 1.0, 3.0, quiet=3.0)
    )
    steps = over_time(posed(run), 0)
    assert run.peak_slide > 0.05
    assert set(steps) == {"stays", "moves"}
    assert steps[-1] == "stays"


def test_the_scale_over_many_runs_is_monotone():
    shares = [0.0, MAY_FALL_FROM - 1e-9, MAY_FALL_FROM, 0.3, FALLS_FROM - 1e-9, FALLS_FROM, 1.0]
    for falls, moves in itertools.combinations_with_replacement(shares, 2):
        step = ORDER.index(expected(falls, moves))
        for more in shares[shares.index(falls) :]:
            assert ORDER.index(expected(more, max(more, moves))) >= step
    assert [expected(*two) for two in ((0.0, 0.04), (0.04, 0.05), (0.05, 0.1), (0.5, 0.5))] == ORDER
    assert expected(math.nan, math.nan) is Stability.MAY_FALL  # where no run is known


def luminance(colour: str) -> float:
    parts = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)]) / 255.0
    return float(
        np.array([0.2126, 0.7152, 0.0722])
        @ np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
    )


def test_each_step_is_darker_than_the_one_before_in_the_colours_that_pages_have():
    colours = list(STABILITY_COLOURS.values())
    lights = [luminance(colour) for colour in colours]
    assert all(lighter > 1.25 * darker for lighter, darker in itertools.pairwise(lights))
    for step, colour in STABILITY_COLOURS.items():
        assert inks_css().count(f"--{step}: {colour};") == 1
    page = player_page([film_of(sp.simulate(BODY, sp.Room(), sp.near_fault()))], 1.0, 1.0)
    assert all(f"--{step}: {colour};" in page for step, colour in STABILITY_COLOURS.items())
    assert [name for name, _ in stability_looks("ja").values()] == [
        "動かない",
        "動く",
        "倒れることがある",
        "倒れる",
    ]
