"""A fundamental study on development of a verification system for earthquake-proof measures for furniture
(14WCEE, 2008), §4.5, Table 4.3: turnover over width and wall distance under JMA Kobe, 1995, NS.

The record is not part of the project; the tests that need it are skipped without it.
"""

import numpy as np
import pytest

import stayput as sp
from real_records import MOTIONS
from studies.wall_gap_record import wall_gap_record

RECORD = MOTIONS / "jma_kobe_1995_ns.AT2"
needs_record = pytest.mark.skipif(not RECORD.is_file(), reason="the record of JMA Kobe 1995 NS is absent")
LETTERS = {0.1: "T", 0.2: "T", 0.3: "T", 0.4: "T", 0.5: "T", 0.6: "N", 0.7: "N", 0.8: "N", 0.9: "N", 1.0: "N"}
LAST = {0.2: 0.50, 0.3: 0.77, 0.4: 0.85, 0.5: 0.93}


@pytest.fixture(scope="module")
def kobe():
    return wall_gap_record(sp.read_motion(RECORD).trimmed(0.0, 30.0))


@pytest.fixture(scope="module")
def built_in():
    return wall_gap_record(gaps=np.linspace(0.0, 0.4, 21))


def nearest(study):
    """The paper's law, and the wall on the side that the summary says comes nearest."""
    assert study.quantities["nearest"].value == "wall: left, the motion as recorded"
    return study.data.sel({"contact": "paper", "motion.scale": 1.0, "wall": "left"})


@needs_record
@pytest.mark.parametrize(("b", "letter"), LETTERS.items())
def test_t_and_n(kobe, b, letter):
    mine = nearest(kobe).sel({"body.width": b})
    assert ("T" if bool(mine.overturned_free) or mine.overturned.any() else "N") == letter
    row = kobe.tables["T or N and the wall distances [m], law 'paper'"].set_index("b [m]").loc[b]
    assert row["paper"][0] == row["left, as recorded"][0] == letter
    agree = kobe.quantities["agree"]
    assert (agree.value, agree.published) == (10, 10)


@needs_record
def test_the_narrowest_needs_no_wall(kobe):
    mine = nearest(kobe)
    assert list(mine.overturned_free.to_numpy()) == [True, *[False] * 9]
    assert bool(mine.overturned.sel({"body.width": 0.1}).all())


@needs_record
@pytest.mark.parametrize(("b", "first"), [(0.2, 0.0), (0.3, 0.0), (0.4, 0.02), (0.5, 0.05)])
def test_nearest_wall_that_turns_it_over(kobe, b, first):
    fallen = nearest(kobe).overturned.sel({"body.width": b})
    assert float(fallen.gap[fallen.to_numpy().argmax()]) == pytest.approx(first, abs=0.03)


@needs_record
def test_the_last_distances_are_shown_with_their_differences(kobe):
    table = kobe.tables["Difference from Table 4.3, the nearest variant"].set_index("b [m]")
    assert list(table.index) == list(LAST)
    for b, last in LAST.items():
        fallen = nearest(kobe).overturned.sel({"body.width": b})
        mine = float(fallen.gap[fallen.to_numpy()].max())
        assert table["last, paper [m]"][b] == last
        assert table["difference of last [m]"][b] == pytest.approx(mine - last, abs=1e-9)
        shown = kobe.quantities[f"last_{b:g}"]
        assert (shown.value, shown.published) == (pytest.approx(mine), last)


@needs_record
def test_the_papers_last_distances_are_out_of_reach(kobe):
    """Without a wall no body comes as far as the paper's farthest wall that turns it over."""
    mine = nearest(kobe)
    for b, last in LAST.items():
        body = mine.sel({"body.width": b})
        assert max(float(body.reach_left), float(body.reach_right)) < last - 0.2
    assert kobe.quantities["beyond"].value == kobe.quantities["ends"].value == 4


@needs_record
def test_a_wall_out_of_reach_changes_nothing(kobe):
    """0.01 m allows for what the samples of the record miss."""
    data = kobe.data
    for wall in ("left", "right"):
        far = data.gap > data[f"reach_{wall}"] + 0.01
        same = data.overturned.sel(wall=wall) == data.overturned_free
        assert int(far.sum()) > 1000
        assert bool(same.where(far, True).all())


@needs_record
def test_both_walls_keep_bodies_standing(kobe):
    mine = kobe.data.overturned.sel({"contact": "paper", "wall": "both", "body.width": slice(0.15, 1.0)})
    assert not mine.any()


@needs_record
def test_cells_are_those_of_single_runs(kobe):
    motion = sp.read_motion(RECORD).trimmed(0.0, 30.0)
    floor = sp.Floor(0.2, 0.1, 0.4, 0.3, restitution=0.6)
    for law, scale, wall, b, gap in (
        ("paper", 1.0, "left", 0.3, 0.15),
        ("paper", 1.0, "right", 0.3, 0.15),
        ("paper", -1.0, "right", 0.5, 0.08),
        ("coulomb", 1.0, "left", 0.4, 0.08),
        ("coulomb", -1.0, "left", 0.3, 0.6),
    ):
        run = sp.simulate(
            sp.Body(b, b / 0.339, 100.0),
            sp.Room(floor, **{f"{wall}_wall": sp.Wall(gap, 0.6)}),
            motion.scaled(scale),
            contact=law,
        )
        cell = kobe.data.overturned.sel(
            {"contact": law, "motion.scale": scale, "wall": wall, "body.width": b}
        ).sel(gap=gap, method="nearest")
        assert bool(cell) == run.overturned


def test_a_reversed_motion_is_the_mirror_image(built_in):
    as_recorded, reversed_ = (built_in.data.overturned.sel({"motion.scale": scale}) for scale in (1.0, -1.0))
    for wall, other in (("left", "right"), ("right", "left"), ("both", "both")):
        assert (as_recorded.sel(wall=wall).to_numpy() == reversed_.sel(wall=other).to_numpy()).all()
    assert as_recorded.any()
    assert built_in.quantities["mirrored"].value == built_in.quantities["mirrored"].published


def test_the_motion_and_the_papers_column_are_named(built_in):
    assert built_in.data.attrs["motion"] == "synthetic near-fault motion"
    table = built_in.tables["T or N and the wall distances [m], law 'paper'"]
    assert table["paper"][4] == "T, 0.05–0.93"


def test_only_the_horizontal_component_shakes(built_in):
    motion = sp.near_fault()
    assert motion.z is not None
    alone = wall_gap_record(motion.component("x"), gaps=np.linspace(0.0, 0.4, 21))
    assert (alone.data.overturned.to_numpy() == built_in.data.overturned.to_numpy()).all()
