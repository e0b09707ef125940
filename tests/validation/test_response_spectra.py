"""Response spectra against an independent library, against SciPy, and in closed form.

The library is pyRotd (frequency domain). It takes a record as a sum of sines between its samples, stayput as
straight lines: so both get the record with samples on its straight lines, and time for the last swings.
"""

import math

import numpy as np
import pyrotd
import pytest
from scipy.signal import StateSpace, lsim

from real_records import MOTIONS, recorded
from stayput.motion.readers import read_motion
from stayput.motion.record import Motion
from stayput.motion.suites.suite import Suite
from stayput.motion.synthetic import near_fault, sine

RECORDS = ("jma_kobe_1995_ns.AT2", "elcentro_1940_180.AT2", "jma_uki_2016.csv", "nishi_akashi_1995_090.AT2")


def library(motion, periods, damping, kind):
    rows = pyrotd.calc_spec_accels(motion.dt, motion.x, 1.0 / periods, damping, osc_type=kind)
    return np.abs(rows.spec_accel)


def compare(motion, damping):
    motion = motion.component("x").padded(0.0, 15.0 / damping)
    fine = motion.resampled(motion.dt / 8.0)
    periods = np.geomspace(0.05, 10.0, 40)
    ours = motion.spectrum(periods, damping)
    assert ours.psa == pytest.approx(library(fine, periods, damping, "psa"), rel=5e-3)
    assert ours.sd == pytest.approx(library(fine, periods, damping, "sd"), rel=5e-3)
    assert ours.sv == pytest.approx(library(fine, periods, damping, "sv"), rel=5e-3)


@pytest.mark.parametrize("damping", [0.02, 0.05, 0.2])
def test_synthetic_motion_against_pyrotd(damping):
    compare(near_fault(), damping)


@recorded
@pytest.mark.parametrize("name", RECORDS)
def test_records_against_pyrotd(name):
    compare(read_motion(MOTIONS / name).trimmed(0.0, 80.0 if "uki" in name else 30.0), 0.05)


@pytest.mark.parametrize(("period", "damping"), [(0.05, 0.05), (0.7, 0.02), (3.0, 0.0), (8.0, 0.4)])
def test_against_scipys_state_space(period, damping):
    motion = near_fault()
    fine = motion.resampled(0.0005)
    w = 2.0 * math.pi / period
    rows = [[1.0, 0.0], [0.0, 1.0], [-w * w, -2.0 * damping * w]]
    system = StateSpace([[0.0, 1.0], rows[2]], [[0.0], [-1.0]], rows, np.zeros((3, 1)))
    u, rate, force = lsim(system, fine.x, fine.time)[1].T
    found = motion.spectrum([period], damping)
    assert found.sd[0] == pytest.approx(np.abs(u).max(), rel=2e-4)
    assert found.sv[0] == pytest.approx(np.abs(rate).max(), rel=2e-4)
    assert found.sa[0] == pytest.approx(np.abs(force).max(), rel=2e-4)
    assert found.sva[0] == pytest.approx(np.abs(rate + fine.velocity).max(), rel=2e-4)


def test_step_in_closed_form():
    # without damping, a constant load moves an oscillator twice as far as it would hold it
    found = Motion(0.01, np.full(2001, 1.5)).spectrum([0.4, 2.0], 0.0)
    assert found.sd == pytest.approx(2.0 * 1.5 * (np.array([0.4, 2.0]) / (2.0 * math.pi)) ** 2, rel=1e-4)
    assert found.sa == pytest.approx([3.0, 3.0], rel=1e-4)


def test_harmonic_resonance_in_closed_form():
    found = sine(1.0, 1.0, 120.0, dt=0.005).spectrum([1.0], 0.05)
    assert found.psa[0] == pytest.approx(1.0 / (2.0 * 0.05), rel=1e-3)
    assert found.sa[0] == pytest.approx(math.hypot(1.0, 1.0 / (2.0 * 0.05)), rel=1e-3)


def test_stiff_and_soft_limits():
    motion = near_fault()
    found = motion.spectrum([0.005, 500.0], 0.05)
    assert found.sa[0] == pytest.approx(motion.pga, rel=0.01)
    assert found.sd[1] == pytest.approx(motion.pgd, rel=0.02)
    assert found.sv[1] == pytest.approx(motion.pgv, rel=0.02)


def test_the_spectra_of_a_suite_are_those_of_its_motions():
    motions = [near_fault().scaled(k) for k in (1.0, 0.5, 2.0)]
    together = Suite(tuple(motions)).spectra()
    assert np.array_equal(together, [motion.spectrum().sa for motion in motions])
