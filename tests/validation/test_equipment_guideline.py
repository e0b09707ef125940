"""The Japanese guideline for building equipment: its coefficients, and forces as moments about an edge."""

import json

import numpy as np
import pytest

import stayput as sp
from stayput.standards.equipment import equipment_loads, position_of

G = 9.80665


def test_the_table_of_coefficients():
    table = {"upper": (2.0, 1.5, 1.0), "middle": (1.5, 1.0, 0.6), "ground": (1.0, 0.6, 0.4)}
    for position, values in table.items():
        assert tuple(sp.equipment_coefficient(position, grade) for grade in "SAB") == values
    assert sp.equipment_coefficient("upper", "S", 0.7) == pytest.approx(1.4)


@pytest.mark.parametrize(
    ("storeys", "uppers"), [(1, 0), (2, 1), (6, 1), (7, 2), (9, 2), (10, 3), (12, 3), (13, 4), (40, 4)]
)
def test_upper_storeys(storeys, uppers):
    positions = [position_of(storey, storeys) for storey in range(1, storeys + 2)]
    assert positions[0] == "ground"
    assert positions[-1] == "upper"  # the roof
    assert positions[:-1].count("upper") == uppers
    assert positions[1 : storeys - uppers] == ["middle"] * max(storeys - uppers - 1, 0)


@pytest.mark.parametrize("size", [(0.3, 1.8), (0.6, 1.9), (1.1, 1.0)])
def test_it_overturns_from_b_over_h_on(size):
    body = sp.Body(*size, 100.0)
    for load in equipment_loads(body, "upper"):
        assert load.overturns is (load.coefficient > size[0] / size[1])
        by_hand = 100.0 * G * (load.coefficient * size[1] - size[0]) / (2.0 * size[1])
        assert load.force == pytest.approx(max(by_hand, 0.0))


def test_a_tie_and_anchors_hold_in_equilibrium():
    body = sp.Body(0.5, 1.6, 120.0, (0.05, 0.2))
    x, z = body.centre_of_gravity
    k, spacing = 1.5, 0.4
    load, weight = k * body.mass * G, body.mass * G
    tie = sp.holding_force(body, k, 1.2)
    assert tie * 1.2 + weight * (0.25 - x) == pytest.approx(load * z)
    bolt = sp.anchor_tension(body, k, spacing, 3)
    about = 0.25 - 0.5 * (0.5 - spacing)  # from the middle of the base to the anchors that are pressed
    assert 3 * bolt * spacing + weight * (about - x) == pytest.approx(load * z)


def test_what_a_simulation_says_under_a_held_load():
    """A load just above the static limit, held for long, overturns; one just below it does not."""
    body, room = sp.Body(0.4, 1.8, 100.0), sp.Room(sp.Floor(3.0, 3.0))
    limit = 0.4 / 1.8
    for factor, falls in ((0.97, False), (1.03, True)):
        a = factor * limit * G * np.minimum(np.linspace(0.0, 4.0, 801), 1.0)
        run = sp.simulate(body, room, sp.Motion(0.01, a))
        assert run.overturned is falls
        assert (sp.holding_force(body, factor * limit) > 0.0) is falls


def test_refusals():
    body = sp.Body(0.4, 1.8, 100.0)
    for call, words in (
        (lambda: sp.equipment_coefficient("cellar", "A"), "position"),
        (lambda: sp.equipment_coefficient("upper", "C"), "grade"),
        (lambda: sp.equipment_coefficient("upper", "A", 1.2), "zone"),
        (lambda: position_of(9, 7), "storey"),
        (lambda: position_of(2.5, 10), "storey is 2.5; it must be a whole number"),
        (lambda: position_of(2, 10.5), "whole number"),
        (lambda: sp.anchor_tension(body, 1.0, 0.3, 2.5), "anchors is 2.5"),
        (lambda: equipment_loads(body, "upper", 0.6), "zone"),
        (lambda: equipment_loads(body, "upper", gravity=0.0), "Gravity is 0"),
        (lambda: sp.holding_force(body, 1.0, 2.5), "1.8"),
        (lambda: sp.anchor_tension(body, 1.0, 0.5), "spacing"),
        (lambda: sp.anchor_tension(body, 1.0, 0.3, 0), "anchors"),
    ):
        with pytest.raises(sp.InputError, match=words):
            call()


def test_the_verdict_has_the_loads_of_the_storey_in_every_form():
    shaking = {"intensity": 5.0, "suite": {"count": 2}}
    upstairs = {**shaking, "building": {"storeys": 10}, "storey": 9}
    body = sp.Body(0.3, 1.8, 200.0)
    for shaken, position in ((upstairs, "upper"), (shaking, "ground")):
        stated = {"furniture": {"preset": "bookcase"}, "shaking": shaken, "uncertainty": {"samples": 1}}
        verdict = sp.verify(sp.Scenario.parse(stated), levels=[], progress=False)
        assert [load.position for load in verdict.estimates.equipment] == [position] * 3
        assert verdict.estimates.equipment == equipment_loads(body, position)
    loads = json.loads(verdict.to_json())["estimates"]["equipment_loads"]
    assert [(load["equipment_class"], load["k_h"]) for load in loads] == [("B", 0.4), ("A", 0.6), ("S", 1.0)]
    assert all(load["overturns"] for load in loads)
    assert loads[0]["tie_force_n"] == pytest.approx(200.0 * G * (0.4 * 0.9 - 0.15) / 1.8)
    assert "Japanese equipment guideline, class S, ground floor" in verdict.to_markdown("en")
    assert "耐震クラスS、1階" in verdict.to_markdown("ja")
