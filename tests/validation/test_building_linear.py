"""Linear shear buildings against closed forms and against SciPy's state space (lsim, first-order hold)."""

import math

import numpy as np
import pytest
from scipy.linalg import eigh
from scipy.signal import StateSpace, lsim

import stayput as sp
from stayput.building.building import Building
from stayput.building.model import ShearModel, strain_energy_damping

RNG = np.random.default_rng(4)
MASSES = RNG.uniform(1e5, 5e5, 12)
STIFFNESSES = np.linspace(4.0, 1.0, 12) * 3e8
RATIOS = RNG.uniform(0.01, 0.1, 12)


def stiffness_matrix(k):
    return np.diag(k + np.append(k[1:], 0.0)) - np.diag(k[1:], 1) - np.diag(k[1:], -1)


def state_space(model):
    """Displacements and velocities in, absolute accelerations and drifts out; damping from the modes."""
    m, k, zeta = (np.array(v) for v in (model.masses, model.stiffnesses, model.damping))
    n = len(m)
    M, K = np.diag(m), stiffness_matrix(k)
    squares, shapes = eigh(K, M)
    C = M @ shapes @ np.diag(2.0 * zeta * np.sqrt(squares)) @ shapes.T @ M
    inverse = np.diag(1.0 / m)
    A = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ K, -inverse @ C]])
    B = np.concatenate((np.zeros(n), -np.ones(n)))[:, None]
    difference = np.eye(n) - np.eye(n, k=-1)
    out = np.block([[-inverse @ K, -inverse @ C], [difference, np.zeros((n, n))]])
    return StateSpace(A, B, out, np.zeros((2 * n, 1))), np.sqrt(squares)


def test_uniform_chain_has_its_closed_form():
    n, k, m = 25, 3e8, 2e5
    j = np.arange(1, n + 1)
    omega = 2.0 * math.sqrt(k / m) * np.sin((2 * j - 1) * math.pi / (2 * (2 * n + 1)))
    modes = ShearModel([m] * n, [k] * n, 0.05).modes
    assert modes.omega == pytest.approx(omega, rel=1e-11)
    assert modes.shapes.T @ np.diag([m] * n) @ modes.shapes == pytest.approx(np.eye(n), abs=1e-11)
    assert modes.effective_mass.sum() == pytest.approx(1.0, rel=1e-12)
    assert modes.shapes @ modes.participation == pytest.approx(np.ones(n), rel=1e-10)  # Σφ Γ = 1


@pytest.mark.parametrize(
    "model",
    [
        ShearModel(MASSES, STIFFNESSES, RATIOS.tolist()),
        Building(10, nonlinear=False).model,
        Building(20, "steel", nonlinear=False).model,
        Building(5, "base-isolated", nonlinear=False).model,
    ],
    ids=["own", "RC", "steel", "isolated"],
)
def test_histories_and_frequencies_against_state_space(model):
    ground = sp.near_fault().trimmed(0.0, 15.0)
    response = model.respond(ground)
    system, omega = state_space(model)
    assert model.modes.omega == pytest.approx(omega, rel=1e-6)
    _, found, _ = lsim(system, response.motion.resampled(response.dt).x, response.time)
    n = len(model.masses)
    floors = response.acceleration["x"][:, -n:]
    for mine, theirs in ((floors, found[:, :n]), (response.drift["x"], found[:, n:])):
        assert np.abs(mine - theirs).max() < 1e-6 * np.abs(theirs).max()


def test_the_same_answer_at_any_step():
    """The record is one function whatever its sampling: the recurrence is exact at the samples they share."""
    ground = sp.near_fault().component("x")
    coarse, fine = (Building(8, nonlinear=False).respond(g) for g in (ground, ground.resampled(0.001)))
    ours = coarse.acceleration["x"][:: round(0.01 / coarse.dt)]
    theirs = fine.acceleration["x"][:: round(0.01 / fine.dt)]
    assert np.abs(ours - theirs).max() < 1e-9 * np.abs(theirs).max()


@pytest.mark.parametrize("storeys", [1, 3, 10, 40])
def test_what_a_line_between_samples_costs(storeys):
    """Peaks and floor spectra change by less than 3 % when the floors are sampled 8 times as finely."""

    ground = sp.near_fault().component("x")
    used = Building(storeys, nonlinear=False).respond(ground)
    fine = Building(storeys, nonlinear=False).respond(ground.resampled(used.dt / 8.0))
    assert used.peak_acceleration() == pytest.approx(fine.peak_acceleration(), rel=0.02)
    assert used.peak_velocity() == pytest.approx(fine.peak_velocity(), rel=0.005)
    mine, theirs = (r.floor(storeys + 1).spectrum().sa for r in (used, fine))
    assert mine == pytest.approx(theirs, rel=0.03)


def test_composite_damping_of_two_storeys_by_hand():
    model = ShearModel([1.0, 1.0], [2.0, 1.0], 0.0)
    ratios = strain_energy_damping(model.modes, np.array([2.0, 1.0]), np.array([0.2, 0.02]))
    for j in range(2):
        lower, upper = model.modes.shapes[:, j]
        e = (2.0 * lower**2, (upper - lower) ** 2)
        assert ratios[j] == pytest.approx((0.2 * e[0] + 0.02 * e[1]) / sum(e), rel=1e-12)
    same = strain_energy_damping(model.modes, np.array([2.0, 1.0]), np.array([0.05, 0.05]))
    assert same == pytest.approx([0.05, 0.05], rel=1e-12)


def test_roofs_amplify_about_as_the_rule_of_thumb_says():
    """1 + 2z/h is 3 at the roof: a stiff or slow building lies below it, one in resonance far above."""
    ground = sp.near_fault().component("x")
    linear = {n: Building(n, nonlinear=False) for n in (1, 10, 60)}
    factors = {n: b.respond(ground).peak_acceleration()[-1] / ground.pga for n, b in linear.items()}
    assert factors[1] < 3.0 < factors[10]
    assert factors[60] < 3.0
