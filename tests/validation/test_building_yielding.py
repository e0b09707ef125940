"""Yielding storeys: the linear limit, the energy balance, another integration, bounds on the floors."""

import math
from dataclasses import replace

import numpy as np
import pytest

import stayput as sp
from stayput.building import superposition as solution
from stayput.building.building import Building, Isolation
from stayput.building.model import ShearModel

GROUND = sp.near_fault().component("x")
KINDS = ("RC", "steel", "wood", "base-isolated")


@pytest.mark.parametrize("storeys", [1, 7, 40])
def test_below_yield_it_is_the_linear_building(storeys):
    linear = Building(storeys, nonlinear=False).model
    strong = replace(linear, yield_shears=[1e15] * storeys)
    mine, theirs = strong.respond(GROUND), linear.respond(GROUND)
    for table in ("acceleration", "drift"):
        a, b = getattr(mine, table)["x"], getattr(theirs, table)["x"]
        assert np.abs(a - b).max() < 1e-12 * np.abs(b).max()
    assert mine.energy["x"].plastic[-1] == 0.0
    assert mine.energy["x"].imbalance < 1e-8


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("factor", [0.5, 1.0, 3.0])
def test_energy_balances(kind, factor):
    energy = Building(6, kind, nonlinear=True).respond(GROUND.scaled(factor)).energy["x"]
    assert energy.imbalance < 2e-4
    assert np.all(np.diff(energy.plastic) >= 0.0)
    assert np.all(np.diff(energy.damping) >= -1e-9 * energy.input[-1])
    if factor == 3.0:
        assert energy.plastic[-1] > 0.3 * energy.input[-1]


def test_imbalance_falls_with_the_square_of_the_sub_step(monkeypatch):
    found = []
    for steps in (100.0, 400.0, 1600.0):
        monkeypatch.setattr(solution, "SUBSTEPS_IN_A_PERIOD", (steps, 4.0))
        found.append(Building(6, nonlinear=True).respond(GROUND).energy["x"].imbalance)
    assert found[0] > 6.0 * found[1] > 36.0 * found[2]


def central_differences(model, a, dt, parts):
    """Integrate M ü + C u̇ + F = −M a by central differences; F from each storey's elastoplastic spring."""
    m, k = np.array(model.masses), np.array(model.stiffnesses)
    r, strength = np.array(model.post_yield), np.array(model.yield_shears)
    phi, omega = model.modes.shapes, model.modes.omega
    C = np.diag(m) @ phi @ np.diag(2.0 * np.array(model.damping) * omega) @ phi.T @ np.diag(m)
    h = dt / parts
    left = np.linalg.inv(np.diag(m) / h**2 + C / (2.0 * h))
    right = np.diag(m) / h**2 - C / (2.0 * h)
    before, now, plastic = np.zeros_like(m), np.zeros_like(m), np.zeros_like(m)
    drift = np.zeros((len(a), len(m)))
    ground = np.interp(np.arange((len(a) - 1) * parts + 1) * h, np.arange(len(a)) * dt, a)
    for i, given in enumerate(ground):
        delta = np.diff(now, prepend=0.0)
        plastic = delta - np.clip(delta - plastic, -strength / k, strength / k)
        if i % parts == 0:
            drift[i // parts] = delta
        shear = k * delta - (1.0 - r) * k * plastic
        load = -m * given - (shear - np.append(shear[1:], 0.0)) + 2.0 * m / h**2 * now - right @ before
        before, now = now, left @ load
    return drift


def test_against_central_differences():
    model = ShearModel([2e5, 1e5], [8e7, 4e7], 0.03, [6e5, 4e5], [0.05, 0.02])
    ground = sp.sine(5.0, 1.8, 1.7, quiet=0.6, dt=0.01)
    response = model.respond(ground)
    theirs = central_differences(model, ground.x, ground.dt, 250)
    mine = response.drift["x"][:: round(ground.dt / response.dt)]
    assert response.energy["x"].plastic[-1] > 0.5 * response.energy["x"].input[-1]
    assert np.abs(mine - theirs).max() < 1e-3 * np.abs(theirs).max()


def test_floors_of_a_yielding_building_stay_bounded():
    """One elastoplastic storey: |ü + a| ≤ Q_y/m + 2ζω|u̇|, however strong the ground."""
    omega, zeta, mass, coefficient = 2.0 * math.pi / 0.3, 0.03, 1e5, 3.0
    model = ShearModel([mass], [mass * omega**2], zeta, [mass * coefficient], 0.0)
    for factor in (1.0, 3.0, 10.0):
        response = model.respond(GROUND.scaled(factor))
        rate = np.abs(np.gradient(response.drift["x"][:, 0], response.dt))
        bound = coefficient + 2.0 * zeta * omega * rate.max() * 1.01
        assert response.peak_acceleration()[-1] <= bound
        assert response.peak_acceleration()[-1] < 0.6 * factor * GROUND.pga


@pytest.mark.parametrize("kind", KINDS[:3])
def test_strong_shaking_does_not_reach_the_floors_in_proportion(kind):
    linear, yielding = Building(8, kind, nonlinear=False), Building(8, kind, nonlinear=True)
    strong = GROUND.scaled(2.0)
    assert (
        yielding.respond(strong).peak_acceleration()[-1]
        < 0.4 * linear.respond(strong).peak_acceleration()[-1]
    )
    weak = GROUND.scaled(0.01)
    assert yielding.respond(weak).peak_acceleration() == pytest.approx(
        linear.respond(weak).peak_acceleration(), rel=1e-12
    )


@pytest.mark.parametrize("given", [Isolation(), Isolation(3.0, 0.15, 0.3, 0.15)])
def test_bilinear_isolators_have_the_period_and_the_damping_they_were_made_for(given):
    """Secant stiffness and loop area of the bilinear law at the displacement it was made for."""
    mass, D, r = 4e6, given.displacement, given.post_yield
    first, force = given.bilinear(mass)
    y = force / first
    top = force + r * first * (D - y)
    assert top / D == pytest.approx(given.stiffness(mass), rel=1e-12)
    area = 4.0 * (1.0 - r) * force * (D - y)
    assert area / (2.0 * math.pi * given.stiffness(mass) * D**2) == pytest.approx(given.damping, rel=1e-12)
    assert y < 0.2 * D
