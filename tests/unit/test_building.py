"""Buildings: which floor is whose, names, what is refused, tables, many motions, the command."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest
from typer.testing import CliRunner

import stayput as sp
from stayput.building.building import STRUCTURES, Building, Isolation
from stayput.building.model import (
    ShearModel,
    ai_distribution,
    spectral_factor,
    storey_stiffnesses,
    weight_above,
)
from stayput.cli import app
from stayput.motion.processing import peak_velocity

GROUND = sp.near_fault()
TWO = ShearModel([2.0, 1.0], [900.0, 400.0], 0.05)


def test_ai_by_hand():
    # T = 0.6: 2T/(1 + 3T) = 1.2/2.8; half of the weight above: 1/√0.5 − 0.5
    found = ai_distribution(np.ones(2), 0.6)
    assert found == pytest.approx([1.0, 1.0 + (math.sqrt(2.0) - 0.5) * 1.2 / 2.8], rel=1e-14)


def test_ai_shears_give_every_storey_the_same_drift():
    masses = np.array([3.0, 2.0, 2.0, 1.0])
    shears = ai_distribution(masses, 0.4) * weight_above(masses)
    drift = shears / storey_stiffnesses(masses, 0.4)
    assert drift == pytest.approx(drift[0], rel=1e-12)
    assert ShearModel(masses, storey_stiffnesses(masses, 0.4), 0.03).periods[0] == pytest.approx(
        0.4, rel=1e-12
    )


def test_spectral_factor_is_continuous_and_falls():
    assert spectral_factor(0.3) == 1.0
    assert spectral_factor(1.2) == pytest.approx(0.8)
    assert spectral_factor(1.2 - 1e-9) == pytest.approx(0.8)
    assert spectral_factor(6.0) == pytest.approx(0.16)


@pytest.mark.parametrize(("structure", "period"), [("RC", 0.6), ("steel", 0.9), ("wood", 0.9)])
def test_period_is_by_height_unless_given(structure, period):
    assert Building(10, structure).model.periods[0] == pytest.approx(period, rel=1e-10)
    assert Building(10, structure, storey_height=4.0).model.periods[0] == pytest.approx(4.0 / 3.0 * period)
    assert Building(10, structure, period=1.3).model.periods[0] == pytest.approx(1.3, rel=1e-10)
    assert set(Building(10, structure).model.damping) == {STRUCTURES[structure].damping}
    assert set(Building(10, structure, damping=0.07).model.damping) == {0.07}


def test_storey_1_is_the_ground_and_storey_n_the_slab_under_it():
    response = Building(4).respond(GROUND)
    parts = round(GROUND.dt / response.dt)
    for name in ("x", "y", "z"):
        assert np.array_equal(response.floor(1).components[name][::parts], GROUND.components[name])
    alone = Building(4).floor_motion(GROUND, 3)
    assert np.array_equal(alone.x, response.acceleration["x"][:, 2])
    assert np.array_equal(alone.y, response.acceleration["y"][:, 2])
    assert np.array_equal(response.floor(5).x, response.acceleration["x"][:, -1])
    assert response.drift["x"].shape == (len(response.time), 4)


def test_storey_1_of_an_isolated_building_is_above_the_isolators():
    isolated = Building(4, "base-isolated", nonlinear=False)
    response = isolated.respond(GROUND)
    assert len(isolated.model.masses) == 5
    assert response.acceleration["x"].shape[1] == 5
    assert response.peak_acceleration()[0] < 0.3 * GROUND.pga
    assert isolated.model.periods[0] == pytest.approx(4.0, rel=0.02)
    assert isolated.model.damping[0] == pytest.approx(0.20, rel=0.05)
    assert isolated.floor_motion(GROUND, 1) == response.floor(1)


def test_a_floor_motion_says_what_it_is():
    floor = Building(10).floor_motion(GROUND, 5)
    assert floor.synthetic
    assert floor.name == f"{GROUND.name}, storey 5 of 10-storey RC building"
    assert floor.source.startswith(GROUND.source)
    assert "computed: storey 5 of 10-storey RC building, T1 = 0.6 s" in floor.source
    recorded = sp.Motion(0.01, GROUND.x, name="a record")
    of_a_record = Building(10).floor_motion(recorded, 11)
    assert not of_a_record.synthetic
    assert "computed: roof" in of_a_record.source


def test_vertical_is_passed_through_or_grows_with_height():
    assert np.array_equal(TWO.floor_motion(GROUND, 2).z[:: _parts(TWO)], GROUND.z)
    doubled = replace(TWO, vertical_amplification=2.0)
    for storey, factor in ((1, 1.0), (2, 1.5), (3, 2.0)):
        floor = doubled.floor_motion(GROUND, storey)
        assert floor.z[:: _parts(TWO)] == pytest.approx(factor * GROUND.z, rel=1e-14)
    assert TWO.floor_motion(GROUND.component("x"), 2).z is None


def _parts(model):
    return round(GROUND.dt / model.floor_motion(GROUND, 1).dt)


def test_a_fast_building_goes_with_the_ground_and_a_slow_one_stands_still():
    stiff = ShearModel([1.0], [(2.0 * math.pi / 0.005) ** 2], 0.05)
    assert stiff.floor_motion(GROUND, 2).pga == pytest.approx(GROUND.pga, rel=0.01)
    slow = ShearModel([1.0], [(2.0 * math.pi / 200.0) ** 2], 0.0)
    assert slow.floor_motion(GROUND, 2).pga < 1e-3 * GROUND.pga
    slowest = ShearModel([1e12], [1e-9], 0.05)  # its period is 10¹¹ of the record's steps
    assert slowest.floor_motion(GROUND, 2).pga < 1e-3 * GROUND.pga


def test_steps_are_cut_for_fast_modes_only():
    assert Building(30).respond(GROUND).dt == GROUND.dt
    assert Building(1).respond(GROUND).dt == pytest.approx(GROUND.dt / 2.0)
    coarse = GROUND.resampled(0.02)
    assert Building(1).respond(coarse).dt == pytest.approx(0.005)


@pytest.mark.parametrize("nonlinear", [False, True])
def test_many_motions_in_order_and_with_the_same_bits(nonlinear):
    model = Building(6, "steel", nonlinear=nonlinear)
    grounds = [GROUND.scaled(k) for k in (0.5, 1.5, 1.0, 0.1, 2.0)]
    one, three = (list(model.floor_motions(iter(grounds), (4, 7), threads=n)) for n in (1, 3))
    assert one == three
    assert [roof for _, roof in one] == [model.floor_motion(g, 7) for g in grounds]
    peaks, again = (model.floor_peaks(iter(grounds), threads=n) for n in (1, 4))
    assert np.array_equal(peaks.acceleration, again.acceleration)
    assert np.array_equal(peaks.velocity, again.velocity)
    response = model.respond(grounds[1])
    assert np.array_equal(peaks.acceleration[1], response.peak_acceleration())
    assert peaks.velocity[1] == pytest.approx(response.peak_velocity(), rel=1e-12)
    assert model.floor_peaks([grounds[0]], component="y").velocity[0, 0] == pytest.approx(
        peak_velocity(grounds[0].y, GROUND.dt), rel=1e-12
    )


def test_only_a_few_motions_are_asked_for_ahead():
    asked = 0

    def grounds():
        nonlocal asked
        for _ in range(100):
            asked += 1
            yield GROUND

    floors = TWO.floor_motions(grounds(), [2], threads=2)
    next(floors)
    assert asked <= 5
    floors.close()


def test_a_floors_peak_velocity_is_that_of_its_motion():
    response = Building(3).respond(GROUND)
    assert response.peak_velocity()[2] == pytest.approx(response.floor(3).pgv, rel=1e-14)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Building(structure="brick"), "one of 'RC', 'steel', 'wood', 'base-isolated'"),
        (lambda: Building(0), "must be between 1 and 199"),
        (lambda: Building(2.5), "whole number"),
        (lambda: Building(period=-1.0), "Building period is -1 s"),
        (lambda: Building(damping=math.nan), "finite"),
        (lambda: Building(post_yield=0.1, nonlinear=False), "post_yield is given for a linear building"),
        (lambda: Building(structure="base-isolated", period=5.0), "must be below"),
        (lambda: Isolation(damping=0.5, post_yield=0.3), "must be below"),
        (lambda: ShearModel([1.0], [1.0, 2.0], 0.05), "stiffnesses has 2 values; it must have 1"),
        (lambda: ShearModel([], [], 0.05), "must be between 1 and"),
        (lambda: ShearModel([1.0], [-1.0], 0.05), "stiffnesses is -1"),
        (lambda: ShearModel([1.0], [1.0], 1.5), "damping is 1.5"),
        (lambda: ShearModel([1.0], [1.0], 0.05, isolated=True), "must be between 2 and"),
        (lambda: TWO.floor_motion(GROUND, 4), "storey is 4; it must be a whole number from 1 to 3, the roof"),
        (lambda: TWO.floor_motions([GROUND], [0]), "storey is 0"),
        (lambda: TWO.respond(GROUND).peak_drift("z"), "one of 'x', 'y'"),
        (lambda: TWO.floor_peaks([GROUND], threads=0), "Threads"),
        (lambda: TWO.floor_peaks([GROUND.component("x")], component="y"), "one of 'x'"),
    ],
)
def test_refused(make, words):
    with pytest.raises(sp.InputError, match=words):
        make()


def cli(*arguments):
    return CliRunner().invoke(app, ["motion", *map(str, arguments)])


def test_command_prints_every_floor():
    linear = ("--set", "shaking.building.nonlinear=false")
    result = cli("info", "near-fault", "--building", 3, *linear)
    assert result.exit_code == 0
    assert result.stdout.startswith("3-storey RC building, T1 = 0.18 s, linear")
    for word in ("ground", "storey 1", "storey 3", "roof", "PFA x", "PFV y", "synthetic"):
        assert word in result.stdout


def test_command_writes_and_says_the_same(tmp_path):
    file, picture = tmp_path / "floor.csv", tmp_path / "floors.png"
    of = ("near-fault", "--building", "5,steel", "--set", "shaking.building.damping=0.03")
    for words in (
        ("convert", of[0], file, *of[1:], "--storey", 4),
        ("plot", of[0], picture, *of[1:], "--spectra", "2,4"),
    ):
        assert cli(*words).exit_code == 0
    data, alone = (json.loads(cli("info", *of, "--json", *more).stdout) for more in ((), ("--storey", 4)))
    floor = sp.read_motion(file)
    response = sp.Building(5, "steel", damping=0.03).respond(sp.near_fault())
    assert np.array_equal(floor.x, response.floor(4).x)
    assert data["components"]["x"]["peak_floor_acceleration_m_s2"][3] == pytest.approx(floor.pga, rel=1e-12)
    assert alone["components"]["x"]["pga_m_s2"] == floor.pga
    assert data["nonlinear"] is True
    assert 0.0 < data["energy"]["x"]["imbalance"] < 1e-3
    assert picture.stat().st_size > 10_000


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("info", "near-fault", "--building", "10,brick"), "one of 'RC'"),
        (("info", "near-fault", "--building", 10, "--storey", 99), "from 1 to 11, the roof"),
        (("convert", "near-fault", "-", "--building", 10), "give both"),
        (("plot", "near-fault", "floor.txt", "--building", 10), ".png"),
        (("plot", "near-fault", "floor.png", "--building", 10, "--spectra", 99), "from 1 to 11"),
        (("plot", "near-fault", "floor.png", "--building", 10, "--spectra", "a"), "written like 3,8"),
        (("plot", "near-fault", "floor.png", "--spectra", 3), "--spectra is given without --building"),
        (("info", "near-fault", "--set", "room.floor=vinyl"), "--set room.floor is given for a motion"),
    ],
)
def test_command_refuses_in_one_sentence(arguments, words):
    result = cli(*arguments)
    assert result.exit_code == 2
    assert words in result.output
    assert result.output.count("\n") == 1
