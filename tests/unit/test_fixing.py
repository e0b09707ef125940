"""Chains of device, fastener and substrate: what is weakest, and the formulas behind the links."""

import math

import numpy as np
import pytest

import stayput as sp
from stayput.measures import Belt, Chain, LBracket, LBracketInBoard, TensionPole, fixing
from stayput.measures.fixing import PRYING, Link, bending_stiffness, in_series, screw_withdrawal
from stayput.model.room import CEILINGS, WALLS

WORDS = ("a link", "リンク")
LB_PER_IN = 4.4482216 / 0.0254


def link(stiffness, strength, ultimate=0.0):
    return Link(WORDS, (f"{strength:g} N is reached", "壊れる"), stiffness, strength, ultimate)


def test_links_in_series_share_the_force():
    """1/k = Σ 1/kᵢ; the weakest gives its strength, its plastic elongation and its name."""
    strong, weak, rigid = link(1e5, 900.0, 0.01), link(3e5, 500.0, 0.002), link(math.inf, math.inf)
    one = in_series(strong, weak, rigid)
    assert one.stiffness == pytest.approx(75e3)
    assert (one.strength, one.ultimate, one.fails) == (500.0, 0.002, weak.fails)
    assert one == in_series(in_series(strong, weak), rigid)
    assert in_series(rigid, rigid).stiffness == math.inf


def test_there_is_a_link_for_every_wall_and_ceiling():
    assert tuple(fixing.FASTENINGS) == WALLS
    assert set(fixing.CEILING_LINKS) == set(CEILINGS) - {"dropped"}
    links = [fixing.BRACKET, fixing.BELT, fixing.CHAIN, fixing.POLE]
    for ends in (*fixing.FASTENINGS.values(), *fixing.TOPS.values()):
        links += [ends.pull, ends.shear]
    links += [*fixing.CEILING_LINKS.values(), *fixing.TOP_BOARDS.values()]
    links += [fixing.panel(wall, 1.8, 2.4) for wall in WALLS]
    for one in links:
        assert one.source
        for english, japanese in (one.label, one.fails):
            assert not japanese.isascii()
            assert english


def test_the_withdrawal_formula_is_the_handbooks():
    """15,700 G² D lb per inch of thread; a #8 screw in red oak (G 0.70): 1262 lb an inch."""
    inch = 0.0254
    found = screw_withdrawal(0.70, 0.164 * inch, inch) / 4.4482216
    assert found == pytest.approx(1262.0, rel=2e-3)
    nail = fixing.nail_withdrawal(0.5, 0.131 * inch, inch) / 4.4482216
    assert nail == pytest.approx(7850.0 * 0.5**2.5 * 0.131, rel=2e-3)


def test_an_ultimate_load_is_some_five_times_the_allowable_one():
    """2850 G² D is the allowable load of design tables: a tenth to a half of the load at failure."""
    allowable = 2850.0 * 0.45**2 * 0.19 * LB_PER_IN * 0.0254
    assert 0.1 < allowable / screw_withdrawal(0.45, 0.19 * 0.0254, 0.0254) < 0.5


def test_a_beam_bends_by_its_closed_form():
    """48 E I / L³ at the middle; elsewhere as the unit-load integral of M m / E I, by quadrature."""
    modulus, breadth, depth, span = 7e9, 0.03, 0.105, 2.4
    stiffness = modulus * breadth * depth**3 / 12.0
    middle = bending_stiffness(modulus, breadth, depth, span, 0.5 * span)
    assert middle == pytest.approx(48.0 * stiffness / span**3)
    x = (np.arange(20_000) + 0.5) * span / 20_000
    for at in (0.3, 1.0, 1.8):
        moment = np.where(x < at, x * (span - at), at * (span - x)) / span
        bends = np.sum(moment**2) / stiffness * span / len(x)
        assert bending_stiffness(modulus, breadth, depth, span, at) == pytest.approx(1.0 / bends, rel=1e-6)
    assert bending_stiffness(modulus, breadth, depth, span, span) == math.inf


def test_a_brackets_leg_pries_on_its_screws():
    """It turns about its far end: with the screws' forces k r φ, moments give the force at its near end."""
    turn, k, (near, far), leg = 1e-3, 1e6, (0.015, 0.045), 0.06
    force = (k * near * turn * near + k * far * turn * far) / leg
    assert force / (k * far * turn) == pytest.approx(PRYING)
    assert force / (leg * turn) == pytest.approx(fixing.PRYING_STIFFNESS * k)


@pytest.mark.parametrize(
    ("measure", "wall", "strength", "fails"),
    [
        (LBracket(), "stud", 1303.0, "the screws pull out of the stud"),
        (LBracket(), "concrete", 1556.0, "the screws tear through the furniture's top board"),
        (LBracketInBoard(), "plasterboard", 361.0 * PRYING, "the screws pull out of the plasterboard"),
        (LBracket(), "hanging strip", 938.0, "the screws pull out of the hanging strip"),
        (Belt(), "stud", 1000.0, "the screws pull out of the furniture's top board"),
        (Belt(top="solid wood"), "plasterboard", 722.0, "the screws pull out of the plasterboard"),
        (Chain(), "stud", 810.0, "the chains' hooks bend open"),
    ],
)
def test_the_weakest_link_of_each_device(measure, wall, strength, fails):
    weakest = measure.drawn(wall, 1.8, 2.4)
    assert weakest.strength == pytest.approx(strength, rel=1e-3)
    assert weakest.fails[0] == fails


def test_what_is_given_takes_the_place_of_the_links():
    link = Belt(strength=700.0, stiffness=2e4, ultimate=0.0).drawn("stud", 1.8, 2.4)
    assert (link.strength, link.stiffness, link.ultimate) == (700.0, 2e4, 0.0)
    assert link.fails[0] == "they reach the strength that is given for them"
    assert Belt(stiffness=2e4).drawn("stud", 1.8, 2.4).fails == Belt().drawn("stud", 1.8, 2.4).fails


def test_a_device_takes_the_wall_of_the_room_unless_told():
    body = sp.Body(0.4, 1.8, 100.0)
    room = sp.Room(left_wall=sp.Wall(0.02, construction="plasterboard"))
    in_board, in_stud = (sp.hold(body, room, [LBracket(wall=wall)]).elements[0] for wall in ("room", "stud"))
    assert in_board.normal.limit_plus == pytest.approx(2.0 * 361.0 * PRYING)
    assert in_stud.normal.limit_plus > 4.0 * in_board.normal.limit_plus
    assert in_board.normal.weakest[0] == "the screws pull out of the plasterboard"


def test_a_pole_is_as_strong_as_its_ceiling():
    fails = {
        "joist": "the ceiling's joists lift",
        "plasterboard": "the pole goes through the ceiling's plasterboard",
        "concrete": "the pole's screw gives way",
    }
    assert {ceiling: TensionPole().chain(ceiling).fails[0] for ceiling in fails} == fails


def test_a_run_names_what_gave_way():
    body = sp.Body(0.3, 1.8, 200.0)
    room = sp.Room(left_wall=sp.Wall(0.02), ceiling=sp.Ceiling(2.4))
    run = sp.simulate(body, room, sp.near_fault(), [LBracketInBoard(count=1), TensionPole()])
    board, pole = run.devices
    assert board.failed
    assert board.weakest == ("the screws pull out of the plasterboard", "石こうボードからねじが抜ける")
    assert pole.failed
    assert pole.weakest[0] == "the poles lose their hold and drop out"
