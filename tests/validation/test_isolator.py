"""A furniture isolator in space: its stops and its spring act alike along any heading, as in the plane."""

import math

import numpy as np
import pytest

import stayput as sp
from stayput.measures import BaseIsolator

BODY = sp.Body(0.8, 0.4, 600.0, length=0.9)
STROKE, STOP, SPRING = 0.1, 2e5, 6e3
HEADINGS = [0.0, 0.7, math.pi / 2, 4.0]


def along(heading: float, acceleration: np.ndarray) -> sp.Motion:
    x, y = math.cos(heading) * acceleration, math.sin(heading) * acceleration
    return sp.Motion(dt=0.005, x=x, y=y, name="along a heading")


@pytest.mark.parametrize("faces", [0.0, 1.2])
@pytest.mark.parametrize("heading", HEADINGS)
def test_a_push_without_friction(heading: float, faces: float) -> None:
    """m ẍ = −k x, and beyond the stroke s also −K (x − s): sines, that meet at the stroke."""
    m, v = BODY.mass, 0.9
    omega, stopped = math.sqrt(SPRING / m), math.sqrt((SPRING + STOP) / m)
    until = math.asin(omega * STROKE / v) / omega
    rate = math.sqrt(v**2 - (omega * STROKE) ** 2)
    middle = STOP * STROKE / (SPRING + STOP)  # about which it swings there
    far = math.hypot(STROKE - middle, rate / stopped)
    back = 2.0 * (until + (math.pi / 2 - math.atan2(stopped * (STROKE - middle), rate)) / stopped)
    isolator = BaseIsolator(0.0, 0.0, STROKE, SPRING, STOP, damping=0.0)
    direction = np.array([math.cos(heading), math.sin(heading), 0.0])
    pushed = sp.Piece(BODY, heading=faces, velocity=tuple(v * direction), measures=[isolator])
    run = sp.simulate(pushed, sp.Room(), along(heading, np.zeros(401)))
    ahead, aside = run[0].slide_in_plan @ direction[:2], run[0].slide_in_plan @ [-direction[1], direction[0]]
    assert run.peak_slide == pytest.approx(middle + far, rel=2e-3)
    assert np.abs(aside).max() < 1e-6
    first = np.flatnonzero((ahead[1:] <= 0.0) & (ahead[:-1] > 0.0))[0]
    assert run.time[first] + 0.005 * ahead[first] / (ahead[first] - ahead[first + 1]) == pytest.approx(
        back, rel=2e-3
    )
    stops, spring = run.devices
    assert stops.peak_shear == pytest.approx(STOP * (middle + far - STROKE), rel=1e-2)
    assert spring.peak_shear == pytest.approx(SPRING * (middle + far), rel=1e-2)


@pytest.mark.parametrize("stiffness", [0.0, SPRING])
@pytest.mark.parametrize("heading", HEADINGS)
def test_a_sine_along_a_heading_as_in_the_plane(heading: float, stiffness: float) -> None:
    isolator, t = BaseIsolator(restoring_stiffness=stiffness), 0.005 * np.arange(1201)
    shaking = 3.0 * np.sin(2.0 * math.pi * t)
    flat = sp.simulate(BODY, sp.Room(), along(0.0, shaking), [isolator], dimensions=2)
    run = sp.simulate(BODY, sp.Room(), along(heading, shaking), [isolator], dimensions=3)
    assert flat.peak_slide > STROKE
    assert run.peak_slide == pytest.approx(flat.peak_slide, rel=5e-3)
    assert run.residual_slide == pytest.approx(abs(flat.residual_slide), abs=2e-3)
    assert run.devices[0].peak_shear == pytest.approx(flat.devices[0].peak_shear, rel=0.03)
