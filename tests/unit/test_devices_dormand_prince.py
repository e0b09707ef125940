"""Butcher tableau of the Dormand–Prince method: its order conditions."""

import numpy as np
import pytest

from stayput.mechanics.devices.step import (
    POSITIONS,
    POSITIONS_ERROR,
    RATES,
    RATES_ERROR,
    STAGES,
    TIMES,
)


def test_rows_add_up_to_the_times_of_their_stages():
    assert RATES.sum(axis=1) == pytest.approx(TIMES, abs=1e-15)
    assert POSITIONS.sum(axis=1) == pytest.approx(TIMES**2 / 2 * (np.arange(STAGES) > 1), abs=1e-15)


def test_the_last_row_integrates_polynomials_of_fourth_degree():
    b = RATES[-1]
    for k in range(5):
        assert b @ TIMES**k == pytest.approx(1.0 / (k + 1), abs=1e-14)
    assert b @ RATES @ TIMES**3 == pytest.approx(1.0 / 20.0, abs=1e-14)


def test_the_error_weights_vanish_up_to_fourth_order():
    for k in range(4):
        assert RATES_ERROR @ TIMES**k == pytest.approx(0.0, abs=1e-15)
    assert abs(RATES_ERROR @ TIMES**4) > 1e-4
    assert pytest.approx(POSITIONS_ERROR) == RATES_ERROR @ RATES
