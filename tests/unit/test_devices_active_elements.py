"""Active lines within a step: levels of margins, scaling in the event search, peak forces."""

import math

import numpy as np
import pytest
from mechanics_runs import case_of, plate, steady
from numba import njit

import stayput as sp
from stayput.mechanics.devices import lines
from stayput.mechanics.runner import trace


@njit
def weights(margin, slack):
    weight = lines.event_weight(margin)
    return lines.level_of(margin, slack), weight, lines.weighted_margin(margin, weight)


def test_a_margin_at_its_limit_must_pass_it_by_the_slack():
    assert weights(1.0, 1e-8)[0] == 0.0
    assert weights(0.0, 1e-8)[0] == -1e-8
    assert weights(-1e-3, 1e-8)[0] == -1e-3 - 1e-8


def test_margins_that_are_negative_at_the_end_of_a_search_are_scaled_to_minus_one():
    assert weights(-40.0, 0.0)[1:] == (1.0 / 40.0, -1.0)
    assert weights(3.0, 0.0)[1:] == (0.0, math.inf)


def test_the_peak_force_is_found_between_the_samples():
    """A body slides into a spring and turns back: the peak is v √(k/m), between two coarse samples."""
    body, room = sp.Body(1.0, 0.5, 100.0), sp.Room(sp.Floor(0.0, 0.0))
    rows = plate((0.0, 0.0))
    rows["stiffness"][:, 0] = 0.0
    rows["slack_plus"][:, 0] = rows["slack_minus"][:, 0] = np.inf
    rows["stiffness"][:, 1] = 5.0
    found = trace(case_of(body, room, slide_rate=0.1), steady(0.0, 1.2, dt=0.1), rows)
    assert found.devices["peak_shear"][0] == pytest.approx(0.1 * math.sqrt(5.0), rel=1e-5)
    assert np.abs(found.forces[:, 0, 1]).max() < found.devices["peak_shear"][0]
