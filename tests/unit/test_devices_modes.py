"""Mode selection with devices: the element forces decide with the contacts."""

import numpy as np
import pytest
from mechanics_runs import G, case_of, modes, plate, steady

import stayput as sp
from stayput.mechanics.runner import trace


@pytest.mark.parametrize(("stiffness", "mode"), [(0.0, sp.Mode.ROCK), (5000.0, sp.Mode.REST)])
def test_a_preloaded_pole_keeps_a_body_from_rocking(stiffness, mode):
    """Two poles press on the top's corners: the body rests under a load that would otherwise tip it."""
    poles = []
    for u in (-0.2, 0.2):
        pole = plate((u, 0.8), cos=-1.0, sin=0.0)
        pole["slack_plus"] = np.inf
        pole["stiffness"][:, 1] = 0.0
        pole["stiffness"][:, 0] = stiffness
        pole["slack_minus"][:, 0] = -0.002
        poles.append(pole)
    run = trace(case_of(), steady(0.3 * G, 0.1), np.concatenate(poles))
    assert modes(run)[-1] is mode


def test_a_device_that_pulls_harder_than_the_weight_lifts_the_body():
    rows = plate((0.0, 0.8), cos=-1.0, sin=0.0)
    rows["stiffness"][:, 1] = 0.0
    rows["slack_minus"] = np.inf
    rows["slack_plus"][:, 0] = -1.5 * G / 1000.0
    run = trace(case_of(), steady(0.0, 0.01), rows)
    assert modes(run)[-1] is sp.Mode.FLIGHT
