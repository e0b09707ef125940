"""Measures: their parameters, what they make of a body and its room, and what they refuse."""

import math
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import stayput as sp
from stayput.measures import (
    MEASURES,
    AgainstWall,
    AntiSlipSheet,
    AwayFromWall,
    Ballast,
    Belt,
    GelMats,
    LBracket,
    LBracketInBoard,
    LowerShelves,
    Measure,
    TensionPole,
    WedgeStopper,
    element_rows,
    hold,
    parameters,
    sketch,
)
from stayput.measures.element import at_rest
from stayput.mechanics.devices.columns import NORMAL, TANGENT
from stayput.model.body import FURNITURE
from stayput.model.state import standing_corners, wall_faces

ROOM = sp.Room(left_wall=sp.Wall(0.03), ceiling=sp.Ceiling(2.4))
BOARD = sp.Room(left_wall=sp.Wall(0.0, construction="plasterboard"))
BODY = sp.Body(0.4, 1.8, 100.0)


@pytest.mark.parametrize("kind", MEASURES)
def test_a_measure_tells_what_is_known_of_it(kind):
    measure = MEASURES[kind]
    assert measure.kind == kind
    for english, japanese in (measure.label, measure.about):
        assert english.isascii()
        assert not japanese.isascii()
    assert measure.about[0].endswith(".")
    assert measure.about[1].endswith("。")
    for about in parameters(measure):
        assert about.label[0].isascii()
        assert not about.label[1].isascii()
        if about.choices:
            assert about.default in about.choices
        elif about.default is not None:
            assert about.low <= about.default <= about.high


@pytest.mark.parametrize("kind", MEASURES)
@pytest.mark.parametrize("name", FURNITURE)
def test_the_defaults_fit_every_piece_of_furniture(kind, name):
    preset = FURNITURE[name]
    body = sp.Body(preset.width, preset.height, preset.mass)
    held = hold(body, ROOM, [MEASURES[kind]()])
    assert (held.body, held.room, held.elements) != (body, ROOM, ())
    under_corners = ("gel_mats", "felt_glides", "sliding_glides", "free_casters", "locked_casters")
    assert held.body.base == ("feet" if kind in under_corners else "flat")
    run = sp.simulate(body, ROOM, sp.pulse("ricker", 3.0, frequency=1.0, quiet=1.0), held.measures)
    assert len(run.devices) == len(held.elements)
    assert run.outcome is not sp.Outcome.FAILED


@pytest.mark.parametrize("kind", MEASURES)
def test_every_number_out_of_range_is_refused_in_one_sentence(kind):
    for about in parameters(MEASURES[kind]):
        numbers = (about.low - 1.0, 2.0 * about.high + 1.0, math.nan)
        for value in ("sideways",) if about.choices else numbers:
            with pytest.raises(sp.InputError, match=rf"{about.name} is .*; it must be .*\.$"):
                MEASURES[kind](**{about.name: value})


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: LBracket(count=1.5), "whole number"),
        (lambda: AntiSlipSheet(kinetic_friction=0.9), "must be between 0 and 0.8"),
        (lambda: MEASURES["base_isolator"](kinetic_friction=0.9), "must be between 0 and 0.05"),
        (lambda: TensionPole(preload=600.0, strength=500.0), "below the ceiling's strength, 500 N"),
    ],
)
def test_numbers_that_contradict_each_other_are_refused(make, message):
    with pytest.raises(sp.InputError, match=message):
        make()


@pytest.mark.parametrize(
    ("measures", "message"),
    [
        ((AntiSlipSheet(), GelMats()), "^Anti-slip sheet and Adhesive gel mats are given together, both und"),
        ((WedgeStopper(), MEASURES["felt_glides"]()), "both under the base"),
        ((TensionPole(), TensionPole(count=1)), "^Tension poles is given twice, both on the top, 0.05 m"),
        ((AgainstWall(), AwayFromWall()), "both at a distance from the wall"),
        ((LBracket(), LBracketInBoard()), "both on the wall at 1 times the height"),
        ((LowerShelves(), LowerShelves(share=0.1)), "both on the shelves"),
        (("belt",), "^measures is 'belt'; it must be of type Measure"),
    ],
)
def test_two_measures_for_one_place_are_refused(measures, message):
    with pytest.raises(sp.InputError, match=message):
        hold(BODY, ROOM, measures)


@pytest.mark.parametrize(
    ("room", "measure", "message"),
    [
        (sp.Room(), LBracket(), "There is no wall behind the piece"),
        (sp.Room(), Belt(), "There is no wall behind the piece"),
        (sp.Room(), AgainstWall(), "There is no wall behind the piece"),
        (sp.Room(left_wall=sp.Wall(0.2)), LBracket(), "it must be between 0 and 0.15 m"),
        (sp.Room(), TensionPole(), "need a ceiling"),
        (sp.Room(ceiling=sp.Ceiling(4.0)), TensionPole(), "is 2.2 m; it must be between"),
        (sp.Room(), TensionPole(ceiling_height=1.81), "is 0.01 m; it must be between"),
        (ROOM, TensionPole(setback=0.5), "setback is 0.5 m; it must be between 0 and 0.4 m"),
        (ROOM, Belt(setback=0.5), "setback is 0.5 m; it must be between 0.02 and 0.4 m"),
        (ROOM, MEASURES["chain"](angle=1.4), "between floor and ceiling"),
        (ROOM, Ballast(height=2.0), "height is 2 m; it must be between 0 and 1.8 m"),
    ],
)
def test_a_measure_that_cannot_be_put_there_is_refused(room, measure, message):
    with pytest.raises(sp.InputError, match=message):
        hold(BODY, room, [measure])


def test_a_pole_brings_the_ceiling_that_the_room_does_not_tell():
    assert hold(BODY, sp.Room(), [TensionPole(ceiling_height=2.2)]).room.ceiling == sp.Ceiling(2.2)


def test_the_order_of_measures_changes_nothing_but_the_order_of_the_elements():
    poles = TensionPole(count=1), TensionPole(count=1, setback=0.3)
    assert len(hold(BODY, ROOM, poles).elements) == 2  # they are at different places
    measures = [TensionPole(), Ballast(), WedgeStopper(), LBracket(), AgainstWall()]
    one, other = hold(BODY, ROOM, measures), hold(BODY, ROOM, measures[::-1])
    assert (one.body, one.room) == (other.body, other.room)
    assert one.elements == other.elements[::-1]
    assert [element.kind for element in one.elements] == ["tension_pole", "l_bracket"]


def test_forces_in_newtons_become_forces_per_unit_mass():
    bracket = LBracket(stiffness=300e3, strength=1500.0)
    held = hold(BODY, ROOM, [bracket])
    row = element_rows(held)[0]
    assert row["stiffness"][NORMAL] == 2 * 300e3 / 100.0
    assert row["limit_plus"][NORMAL] == row["limit_plus"][TANGENT] == 2 * 1500.0 / 100.0
    assert row["limit_minus"][NORMAL] == math.inf
    assert row["damping"][NORMAL] == pytest.approx(2 * 0.05 * math.sqrt(600e3 * 100.0) / 100.0)
    assert (row["u"], row["v"]) == (-0.2, 0.9)
    assert math.isnan(row["x"])
    weak = element_rows(held, 0.5)[0]
    assert weak["limit_plus"][NORMAL] == 0.5 * row["limit_plus"][NORMAL]
    assert weak["stiffness"][NORMAL] == row["stiffness"][NORMAL]
    both = element_rows(hold(BODY, ROOM, [GelMats(area=0.0016)]), [1.0, 0.25])["limit_plus"][:, TANGENT]
    assert both[1] == 0.25 * both[0] == 0.25 * 0.7 * 2 * 0.0016 * 50e3 / 100.0


def test_a_pole_pushes_with_its_preload_at_rest():
    row = element_rows(hold(BODY, ROOM, [TensionPole()]))[0]
    assert -row["slack_minus"][NORMAL] * row["stiffness"][NORMAL] == pytest.approx(2 * 150.0 / 100.0)
    assert row["slack_plus"][NORMAL] == math.inf
    assert row["drops_out"] == 1


def test_a_pole_leans_before_it_slips_where_it_is_long():
    """Sideways it bears the push times the pad's width over the length, or times the friction if less."""
    short, long = (
        element_rows(hold(BODY, sp.Room(ceiling=sp.Ceiling(height)), [TensionPole()]))[0]
        for height in (1.9, 2.4)
    )
    assert short["friction"] == 0.4
    assert long["friction"] == pytest.approx(0.07 / 0.6)
    assert short["ultimate"][TANGENT] == long["ultimate"][TANGENT] == 0.07


def test_a_pole_is_tightened_as_far_as_its_ceiling_lets_it_be():
    for construction, preload in (("joist", 150.0), ("plasterboard", 0.5 * 360.0 * 0.35 / 0.455)):
        room = sp.Room(ceiling=sp.Ceiling(2.4, construction=construction))
        row = element_rows(hold(BODY, room, [TensionPole(count=1)]))[0]
        assert -row["slack_minus"][NORMAL] * row["stiffness"][NORMAL] == pytest.approx(preload / 100.0)
    dropped = sp.Room(ceiling=sp.Ceiling(2.4, construction="dropped"))
    with pytest.raises(sp.InputError, match="a dropped ceiling lifts"):
        hold(BODY, dropped, [TensionPole()])
    given = element_rows(hold(BODY, dropped, [TensionPole(count=1, strength=200.0)]))[0]
    assert given["limit_minus"][NORMAL] == 2.0


def test_mats_are_bought_for_the_mass_and_leave_the_floor_as_it_is():
    for mass in (18.0, 100.0):
        held = hold(sp.Body(0.4, 1.0, mass), ROOM, [GelMats()])
        assert held.room.floor == ROOM.floor
        pull = sum(element.normal.limit_plus for element in held.elements)
        assert pull == pytest.approx(0.7 * 1e5 * mass / 1e4)
    assert GelMats().fitted_to(sp.Body(0.4, 1.0, 100.0)).area == pytest.approx(0.0025)
    assert GelMats(area=0.001).fitted_to(BODY).area == 0.001


@pytest.mark.parametrize("surface", ["carpet", "tatami, along the weave"])
def test_gel_does_not_stick_to_soft_floors(surface):
    with pytest.raises(sp.InputError, match="do not stick"):
        hold(BODY, sp.Room(sp.Floor.of(surface)), [GelMats()])


@pytest.mark.parametrize(
    ("measure", "body", "room", "words"),
    [
        (LBracket(), BODY, BOARD, "plasterboard alone"),
        (LBracketInBoard(), BODY, ROOM, "plasterboard alone"),
        (Belt(wall="stud"), BODY, BOARD, None),
        (LBracket(strength=100.0), BODY, BOARD, None),
        (TensionPole(), BODY, sp.Room(ceiling=sp.Ceiling(2.2, construction="plasterboard")), "put a board"),
        (TensionPole(), BODY, sp.Room(ceiling=sp.Ceiling(2.2)), None),
        (TensionPole(), BODY, sp.Room(ceiling=sp.Ceiling(2.5)), "longer than 0.6 m"),
        (WedgeStopper(), BODY, ROOM, None),
        (WedgeStopper(), sp.Body(0.27, 0.76, 18.0), ROOM, "slides before it tips"),
        (WedgeStopper(), BODY, sp.Room(sp.Floor.of("carpet")), "sinks"),
        (AntiSlipSheet(), BODY, sp.Room(sp.Floor.of("carpet")), "soft"),
        (AntiSlipSheet(), BODY, sp.Room(sp.Floor.of("vinyl")), None),
    ],
)
def test_a_measure_tells_why_it_may_not_do_much_here(measure, body, room, words):
    cautions = measure.cautions(body, room)
    assert len(cautions) == (words is not None)
    for english, japanese in cautions:
        assert words in english
        assert not japanese.isascii()


def test_the_anchor_of_a_belt_is_on_the_wall_at_its_angle():
    held = hold(BODY, ROOM, [Belt(setback=0.1, angle=0.3)])
    row = element_rows(held)[0]
    assert row["x"] == pytest.approx(-0.2 - 0.03)
    assert row["z"] == pytest.approx(1.8 + 0.13 * math.tan(0.3))
    assert row["length"] == pytest.approx(0.13 / math.cos(0.3))
    assert row["slack_minus"][NORMAL] == math.inf


def test_where_a_point_of_the_body_is_at_rest():
    assert at_rest(BODY, (-0.1, 1.0)) == pytest.approx((-0.1, 1.0), abs=1e-15)
    back, front = 0.002, -0.005
    tilted = sp.Body(0.4, 1.8, 100.0, base_heights=(back, front))
    left, right, top = (at_rest(tilted, point) for point in ((-0.2, back), (0.2, front), (-0.2, 1.8)))
    assert (left[1], right[1], left[0] + right[0]) == pytest.approx((0.0, 0.0, 0.0), abs=1e-15)
    assert top[0] - left[0] == pytest.approx(-1.798 * 0.007 / math.hypot(0.4, 0.007))


def test_a_wedge_tilts_the_body_back_by_a_degree():
    held = hold(BODY, replace(ROOM, left_wall=sp.Wall(0.1)), [WedgeStopper()])
    assert math.degrees(held.body.resting_tilt) == pytest.approx(-math.degrees(math.atan(0.007 / 0.4)))
    assert held.body.base_heights == (0.0, -0.007)
    assert held.room.floor == sp.Floor(right_edge_static_friction=0.8, right_edge_kinetic_friction=0.7)


@pytest.mark.parametrize("gap", [0.0, 0.005, 0.02, 0.03, 0.2])
def test_a_wedge_leaves_the_base_where_it_is(gap):
    """Its back stays off the wall by the gap; the top leans back until it meets the wall, and no farther."""
    body, place = sp.Body(0.3, 1.8, 100.0), sp.Room(left_wall=sp.Wall(gap), right_wall=sp.Wall(0.4))
    held = hold(body, place, [WedgeStopper()])
    (back, _), (front, _), (top, _), _ = standing_corners(held.body, sp.State())
    left, right = wall_faces(held.body, held.room)
    assert back - left == pytest.approx(gap, abs=1e-12)
    assert right - front == pytest.approx(0.4, abs=1e-4)  # the base is shorter by 1 − cos of the tilt
    lean = 1.8 * 0.007 / math.hypot(0.3, 0.007)
    assert top - left == pytest.approx(max(0.0, gap - lean), abs=1e-12)
    assert -math.sin(held.body.resting_tilt) == pytest.approx(min(gap, lean) / 1.8, abs=1e-12)
    run = sp.simulate(body, place, sp.Motion(0.01, np.zeros(200)), [WedgeStopper()])
    assert (run.outcome, run.peak_tilt) == (sp.Outcome.RESTED, 0.0)
    assert run.peak_slide == pytest.approx(0.0, abs=1e-12)


def test_ballast_is_a_part_more():
    body = sp.Body(0.4, 1.8, 100.0, cg_offset=(0.02, -0.1), inertia=30.0)
    x, z = body.centre_of_gravity
    half = math.sqrt(30.0 / 100.0 * 12.0)  # a rod of the body's inertia
    parts = [sp.Part(100.0, x, z, half, 0.0), sp.Part(20.0, 0.0, 0.1, 0.4, 0.0)]
    expected, found = sp.Body.from_parts(0.4, 1.8, parts), hold(body, ROOM, [Ballast()]).body
    assert found.mass == expected.mass
    assert found.cg_offset == pytest.approx(expected.cg_offset)
    assert found.inertia == pytest.approx(expected.inertia)


def test_heavy_things_on_the_lower_shelves_are_the_bookcase_loaded_so():
    even, uneven = (sp.Body.bookcase(0.4, 1.8, 40.0, loads) for loads in ([30.0, 30.0], [40.0, 20.0]))
    found = hold(even, ROOM, [LowerShelves(share=0.1)]).body
    assert found.mass == uneven.mass
    assert found.cg_offset == pytest.approx(uneven.cg_offset)
    assert found.inertia == pytest.approx(uneven.inertia)


def test_other_gaps_and_floors_take_the_place_of_the_rooms():
    assert hold(BODY, ROOM, [AwayFromWall(gap=0.25)]).room.left_wall == sp.Wall(0.25)
    floor = sp.Floor(0.4, 0.3, edge_static_friction=0.2, edge_kinetic_friction=0.1, restitution=0.9)
    held = hold(BODY, sp.Room(floor), [AntiSlipSheet()])
    assert held.room.floor == sp.Floor(0.8, 0.7, restitution=0.9)


@pytest.mark.parametrize("kind", MEASURES)
def test_a_drawing_has_what_can_be_seen(kind):
    drawn = sketch(hold(BODY, ROOM, [MEASURES[kind]()]))
    assert drawn or kind in ("lower_shelves", "against_wall", "away_from_wall")
    assert all(np.isfinite(shape.points).all() for shape in drawn)


def test_a_belt_is_drawn_as_long_as_it_is():
    held = hold(BODY, ROOM, [Belt()])
    (belt,) = sketch(held)
    assert math.dist(*belt.points) == pytest.approx(element_rows(held)[0]["length"])


@pytest.mark.parametrize("kind", MEASURES)
def test_a_measure_says_of_itself_what_plans_and_drawings_need(kind):
    measure = MEASURES[kind]
    of_its_own = {name for base in measure.__mro__ if base not in Measure.__mro__ for name in vars(base)}
    assert "cost_class" in of_its_own
    assert measure.cost_class in range(4)
    assert measure.__doc__
    held = hold(replace(BODY, length=0.8), ROOM, [measure()])
    assert bool(sketch(held)) == (kind not in ("lower_shelves", "against_wall", "away_from_wall"))
    assert all(measure().placed_at(held, 0.0))
    others = {other for sets in (measure.compared_by_default, measure.tried_in_rooms) for other in sets}
    assert set().union(*others) <= set(MEASURES)


def test_the_manual_tells_what_a_measure_of_ones_own_may_say():
    text = (Path(__file__).parents[2] / "docs" / "measures.md").read_text(encoding="utf-8")
    told = set(re.findall(r"`(\w+)`", text.partition("## A measure of your own")[2].partition("\n## ")[0]))
    assert {name for name in vars(Measure) if not name.startswith("_")} - {"check_most", "as_strong"} <= told
