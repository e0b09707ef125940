"""What holds of every inventory: no row is lost, bad ones give a sentence, their order is nothing."""

from __future__ import annotations

import shutil
import sys
import tempfile
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import stayput as sp
from stayput.fragility.intensity_measures import JMA_INTENSITY, spectral_acceleration
from stayput.inventory import assess
from stayput.inventory.cells import number_of, plain
from stayput.inventory.shakemap import ShakeMap, distances, steps_of

sys.path.insert(0, str(Path(__file__).parents[1] / "unit"))
from inventories import city, pieces, table


@given(st.one_of(st.text(), st.floats(), st.integers(), st.none()))
def test_a_cell_is_a_finite_number_or_refused(cell):
    try:
        found = number_of("width", cell)
    except sp.InputError:
        return
    assert found is None or abs(found) < float("inf")
    assert (found is None) == (plain("width", cell) is None)


@settings(max_examples=3)
@given(st.permutations(pieces(12, 6)))
def test_the_order_of_rows_changes_nothing_of_a_piece(rows):
    with tempfile.TemporaryDirectory() as folder:
        found = {}
        for name, given_rows in (("sorted", sorted(rows)), ("mixed", rows)):
            here = Path(folder) / name
            here.mkdir()
            done = assess(table(here, given_rows), city(here), here / "out", progress=False)
            lines = done.pieces.to_table().drop_columns(["row"]).to_pylist()
            found[name] = sorted(lines, key=lambda line: line["id"])
            shutil.rmtree(here / "out" / "work")
        assert found["sorted"] == found["mixed"] or repr(found["sorted"]) == repr(found["mixed"])


@given(st.floats(-80, 80), st.floats(-180, 180), st.floats(-80, 80), st.floats(-180, 180))
def test_distances_are_alike_both_ways(lat, lon, other_lat, other_lon):
    there, back = distances(lat, lon, [other_lat], [other_lon]), distances(other_lat, other_lon, [lat], [lon])
    assert there[0] == pytest.approx(back[0], abs=1e-9)
    assert 0.0 <= there[0] <= 3.15


@pytest.mark.parametrize("measure", [JMA_INTENSITY, spectral_acceleration(0.3)])
@given(values=st.lists(st.floats(0.001, 7), min_size=6, max_size=6), lat=st.floats(0, 2), lon=st.floats(0, 1))
def test_a_map_stays_between_its_values(measure, values, lat, lon):
    import numpy as np

    levels = np.array([value if measure.is_logarithm else np.log10(value) for value in values])
    grid = ShakeMap(measure, np.array([0.0, 1.0, 2.0]), np.array([0.0, 1.0]), levels.reshape(3, 2))
    half = 0.501 / steps_of(measure)
    assert levels.min() - half <= grid.at(lat, lon).level <= levels.max() + half
