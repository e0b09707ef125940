"""575 Market Street, San Francisco, 1989 Loma Prieta: a tall building's recorded top floor beside the model.

Records: USGS. The model knows the number of storeys, the measured period of 6.4 s, and the defaults of a
steel building; nothing is fitted. The bounds say how near such a model comes, and where it does not.
"""

import numpy as np
import pytest

from real_records import MOTIONS, recorded
from stayput.building.building import Building
from stayput.motion.readers import read_motion
from stayput.motion.response import PERIODS
from stayput.report.building import plot_building

pytestmark = recorded


@pytest.fixture(scope="module")
def ground():
    return read_motion(MOTIONS / "market575_1989_ground_gal_dt0.01.csv", unit="gal")


@pytest.fixture(scope="module")
def recorded():
    return read_motion(MOTIONS / "market575_1989_floor42_gal_dt0.01.csv", unit="gal")


@pytest.fixture(scope="module")
def response(ground):
    return Building(42, "steel", period=6.4, nonlinear=False).respond(ground)


def test_measured_period_is_in_the_record(recorded):
    """After 22 s, when the ground is nearly still, the floor goes on at its first period."""
    late = recorded.trimmed(22.0)
    amplitude = np.abs(np.fft.rfft(late.x * np.hanning(len(late)), 2**16))
    slow = np.fft.rfftfreq(2**16, late.dt) < 0.3
    assert 1.0 / np.fft.rfftfreq(2**16, late.dt)[slow][amplitude[slow].argmax()] == pytest.approx(
        6.4, rel=0.03
    )


def test_peaks_of_the_top_floor(response, recorded):
    floor = response.floor(42)
    assert floor.pga == pytest.approx(recorded.pga, rel=0.15)
    assert floor.pgv == pytest.approx(recorded.pgv, rel=0.15)


def test_spectrum_of_the_top_floor(response, recorded, ground):
    """Within a factor of 2.5 everywhere, 35 % on average; the ground's own spectrum is off by far more."""
    band = (PERIODS >= 0.1) & (PERIODS <= 8.0)
    truth = recorded.spectrum().sa[band]
    off = np.abs(np.log(response.floor(42).spectrum().sa[band] / truth))
    of_ground = np.abs(np.log(ground.spectrum().sa[band] / truth))
    assert off.max() < np.log(2.5)
    assert off.mean() < np.log(1.35)
    assert off.mean() < 0.4 * of_ground.mean()


def test_first_mode_of_the_top_floor(response, recorded):
    mine, truth = (m.spectrum([6.4]).sa[0] for m in (response.floor(42), recorded))
    assert mine == pytest.approx(truth, rel=0.2)


def test_the_rule_of_thumb_is_no_match_for_a_tall_building(response, recorded, ground):
    rule = ground.pga * (1.0 + 2.0 * 41.0 / 42.0)
    assert rule > 1.5 * recorded.pga
    assert abs(response.floor(42).pga - recorded.pga) < 0.3 * abs(rule - recorded.pga)


def test_it_is_drawn(response, tmp_path):
    plot_building(response, tmp_path / "all.png", [22, 42])
    assert (tmp_path / "all.png").stat().st_size > 10_000
