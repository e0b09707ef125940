"""Rest with devices: it ends exactly where contacts no longer balance the load."""

import numpy as np
import pytest
from mechanics_runs import G, case_of, plate, tie

import stayput as sp
from stayput.mechanics.columns import H_TILT
from stayput.mechanics.runner import shaking, trace


@pytest.mark.parametrize("stiffness", [10.0, 1000.0])
def test_rest_ends_where_the_load_leaves_the_cone_and_stretches_no_device(stiffness):
    n = 400
    ramp = shaking(0.01 * np.arange(n), None, 0.01, 0)  # ẍ_G = t [m/s²]
    rows = tie((0.0, 0.8), (-0.5, 1.6), stiffness=np.array([[stiffness, 0.0]]))
    run = trace(case_of(), ramp, rows)
    start = run.events[0]
    assert start.time == pytest.approx(0.25 * G, abs=1e-9)  # (b/h) g
    before = run.history[: int(start.time / 0.01), H_TILT]
    assert not before.any()


def test_a_preload_adds_to_what_friction_holds():
    """A pole pressed between body and ceiling adds its force to the weight: rest lasts to μ(g + P)."""
    mu, preload = 0.2, 3.0
    body = sp.Body(0.8, 0.8, 100.0)
    rows = plate((0.0, 0.4), cos=-1.0, sin=0.0)
    rows["slack_plus"], rows["stiffness"][:, 1] = np.inf, 0.0
    rows["slack_minus"][:, 0] = -preload / 1000.0
    ramp = shaking(0.01 * np.arange(400), None, 0.01, 0)
    run = trace(case_of(body, sp.Room(sp.Floor(mu, mu))), ramp, rows)
    assert run.events[0].time == pytest.approx(mu * (G + preload), rel=1e-9)
