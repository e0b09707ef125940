"""The studies of walls: ranges, words, files."""

import numpy as np
import pytest

import stayput as sp
from studies.wall_gap import ruled, table_4_2, turnover
from studies.wall_gap_record import paper_words, ranges, wall_gap_record, words


@pytest.mark.parametrize(
    ("fallen", "expected"),
    [
        ([0, 0, 0, 0], []),
        ([1, 1, 1, 1], [(0.0, 0.3)]),
        ([0, 1, 1, 0], [(0.1, 0.2)]),
        ([1, 0, 1, 1], [(0.0, 0.0), (0.2, 0.3)]),
    ],
)
def test_ranges(fallen, expected):
    assert ranges(np.array([0.0, 0.1, 0.2, 0.3]), np.array(fallen, bool)) == expected


def test_words():
    assert words([], free=False) == "N"
    assert words([], free=True) == "T without a wall only"
    assert words([(0.0, 0.1), (0.3, 0.3)], free=False) == "T, 0.00–0.10, 0.30"
    assert words([(0.0, 1.0)], free=True) == "T, 0.00–1.00; also without a wall"


def test_the_papers_words():
    assert paper_words(0.1) == "T, without influence of wall"
    assert paper_words(0.2) == "T, up to 0.50"
    assert paper_words(0.4) == "T, 0.02–0.85"
    assert paper_words(0.6) == "N"
    assert paper_words(0.25) == ""


def test_the_rule_is_for_wide_bodies_near_the_wall():
    assert ruled(np.array([1.0, 2.0]), np.array([0.0, 0.29, 0.3])).tolist() == [
        [False] * 3,
        [True, True, False],
    ]


def test_turnover_has_each_widths_own_distances():
    case = table_4_2(sp.sine(6.0, 0.8, 10.0), 0.25)
    widths, gaps = np.array([0.4, 0.8]), np.array([[0.0, 0.1, 0.2], [0.05, 0.15, 0.25]])
    found = turnover(case, widths, gaps, {"motion.scale": [0.5, 1.0]}, ("left", "both"))
    assert found.free.shape == found.free_tilt.shape == (2, 2)
    assert found.walled.shape == (2, 2, 2, 3)
    assert found.given_up == 0
    for i, b in enumerate(widths):
        alone = turnover(case, np.array([b]), gaps[i], {"motion.scale": [1.0]}, ("both", "left"))
        assert (found.walled[1, ::-1, i] == alone.walled[0, :, 0]).all()
        assert found.free_tilt[1, i] == alone.free_tilt[0, 0]


def test_files_of_a_record(tmp_path):
    study = wall_gap_record(widths=[0.1, 0.25], gaps=[0.05])
    assert {path.suffix for path in study.write(tmp_path)} == {".nc", ".csv", ".md", ".png"}
    assert study.tables["T or N and the wall distances [m], law 'paper'"]["paper"][1] == ""
