"""A fundamental study on development of a verification system for earthquake-proof measures for furniture
(14WCEE, 2008), §4.4, Figs. 4.5 and 4.6: turnover over width and wall distance under a sine.

The paper's sine is not in its text; the one here is 5.0 m/s², 0.8 Hz.
"""

import numpy as np
import pytest

import stayput as sp
from studies.wall_gap import wall_gap

WIDTHS = np.round(np.concatenate((np.arange(0.8, 1.001, 0.05), np.arange(1.025, 1.6, 0.1))), 3)
GAPS = np.round(np.arange(0.0, 0.4001, 0.01), 2)


@pytest.fixture(scope="module")
def study():
    return wall_gap(
        widths=WIDTHS, gaps=GAPS, amplitudes=(5.0, 6.0), frequencies=(0.8,), ratios=(0.25, 0.339, 0.5)
    )


def turned_over(data, law, wall, low, high):
    """Shape [width, gap], for widths from ``low`` to ``high``."""
    return data.overturned.sel({"contact": law, "wall": wall, "body.width": slice(low, high)}).to_numpy()


@pytest.mark.parametrize("law", ["paper", "coulomb"])
@pytest.mark.parametrize("wall", ["left", "right", "both"])
def test_wider_than_1_m_and_nearer_than_15_per_cent_does_not_turn_over(study, law, wall):
    fallen = turned_over(study.data, law, wall, 1.001, 9.0)
    wide = WIDTHS[WIDTHS > 1.0]
    near = np.less(GAPS, 0.15 * wide[:, None] - 1e-9)
    assert near.sum() > 100
    assert not fallen[near].any()


@pytest.mark.parametrize("wall", ["left", "right"])
def test_widths_of_08_to_10_m_turn_over_at_a_small_distance(study, wall):
    """Only for the wall, and from a distance of at most a quarter of the width."""
    assert not study.data.overturned_free.sel(contact="paper").any()
    fallen = turned_over(study.data, "paper", wall, 0.8, 1.0)
    widths = WIDTHS[WIDTHS <= 1.0]
    assert fallen.any(-1).all()
    assert (GAPS[fallen.argmax(-1)] <= 0.25 * widths).all()


def test_beyond_15_per_cent_some_wider_than_1_m_turn_over(study):
    """So the rule is not empty."""
    assert turned_over(study.data, "paper", "right", 1.001, 9.0).any()


def test_cells_are_those_of_single_runs(study):
    floor = sp.Floor(0.2, 0.1, 0.4, 0.3, restitution=0.6)
    motion = sp.sine(5.0, 0.8, 30.0, dt=0.01)
    rng = np.random.default_rng(4)
    seen = set()
    for _ in range(40):
        law, wall = rng.choice(["paper", "coulomb"], p=[0.8, 0.2]), rng.choice(["left", "right", "both"])
        b, gap = float(rng.choice(WIDTHS)), float(rng.choice(GAPS))
        sides = {f"{side}_wall": sp.Wall(gap, 0.6) for side in ("left", "right") if wall in (side, "both")}
        run = sp.simulate(sp.Body(b, b / 0.339, 100.0), sp.Room(floor, **sides), motion, contact=law)
        cell = study.data.overturned.sel({"contact": law, "wall": wall, "body.width": b, "gap": gap})
        assert bool(cell) == run.overturned
        seen.add(run.overturned)
    assert seen == {True, False}


def test_the_rule_depends_on_the_input(study):
    """It holds at the map's sine and not at a stronger one, nor for a more slender body."""
    broken = study.data.broken_share.sel(contact="paper", frequency=0.8)
    assert float(broken.sel(aspect_ratio=0.339, amplitude=5.0)) == 0.0
    assert float(broken.sel(aspect_ratio=0.339, amplitude=6.0)) > 0.0
    assert float(broken.sel(aspect_ratio=0.25, amplitude=5.0)) > 0.0


def test_a_stocky_body_does_not_tilt(study):
    """b/h = 0.5 is above the edge's friction at rest, 0.4: its foot slides."""
    stocky = study.data.sel(aspect_ratio=0.5)
    assert float(stocky.free_tilt.max()) == 0.0
    assert float(stocky.broken_share.max()) == 0.0
    assert float(study.data.free_tilt.sel(aspect_ratio=0.339, contact="paper").min()) > 0.0


def test_the_rule_is_broken_where_the_nearest_wall_is_nearer_than_15_per_cent(study):
    near = study.data.nearest_wall < 0.15 - 1e-9
    assert (near == (study.data.broken_share > 0.0)).all()


def test_summary_and_tables_have_the_numbers_of_the_run(study):
    shares = study.data.broken_share.sel(contact="paper")
    broken = study.quantities["broken_paper"]
    assert broken.value == int((shares > 0).sum())
    assert broken.label == f"Inputs of {shares.size} at which the rule is broken, law 'paper'"
    assert [study.quantities[f"map_broken_{law}"].value for law in ("paper", "coulomb")] == [0, 0]
    table = study.tables["Inputs (sine and aspect ratio) that break the 15 % rule"]
    assert table["rule broken"].sum() == int((study.data.broken_share > 0).sum())
