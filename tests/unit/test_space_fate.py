"""What becomes of bodies that stand on, lean on and fall onto others."""

import math

import numpy as np
import pytest

import stayput as sp
from stayput.execution import Stop
from stayput.report.summary import place_called, rows, sentences, summary
from stayput.simulation.space_fate import fates_of, lies_on_floor

BOX = sp.Body.box
TALL = BOX(0.3, 0.5, 1.6, 40.0)
CHEST = BOX(0.5, 0.8, 0.8, 60.0)
ROUGH = sp.Room(sp.Floor(0.8, 0.7))
STILL = sp.Motion(dt=0.01, x=np.zeros(301), name="still")
OVERTURNED, FELL_OFF, LEANING = sp.Outcome.OVERTURNED, sp.Outcome.FELL_OFF, sp.Outcome.LEANING
STOOD = (sp.Outcome.RESTED, sp.Outcome.SLID, sp.Outcome.ROCKED)


def tipped(body: sp.Body, at: tuple[float, float, float], rate: float, edge: float) -> sp.Piece:
    """Return a body that turns about its lower edge at x = edge in its frame [rad/s]."""
    arm = body.solid.centre_of_gravity - np.array([edge, 0.0, 0.0])
    velocity = np.cross([0.0, rate, 0.0], arm)
    return sp.Piece(body, at, rotation_rate=(0.0, rate, 0.0), velocity=tuple(velocity.tolist()))


def became(*bodies: sp.Piece, room: sp.Room = ROUGH, friction: tuple[float, float] = (0.4, 0.3)) -> sp.Run:
    run = sp.simulate(sp.Scene(bodies, room, friction=friction), STILL)
    assert np.abs(run.velocity[:, -1]).max() < 0.05
    return run


def outcomes(run: sp.Run) -> tuple[sp.Outcome, ...]:
    return tuple(piece.outcome for piece in run.pieces)


@pytest.mark.parametrize(
    ("gap", "outcome", "least", "most"),
    [(0.6, LEANING, 15.0, 30.0), (1.2, OVERTURNED, 45.0, 60.0), (2.0, OVERTURNED, 89.9, 90.1)],
)
def test_a_piece_that_falls_against_its_neighbour(
    gap: float, outcome: sp.Outcome, least: float, most: float
) -> None:
    """Up to 45° it leans; beyond it lies on it; farther away it reaches the floor."""
    neighbour = sp.Piece(BOX(1.0, 1.0, 2.0, 500.0))
    run = became(tipped(TALL, (-0.65 - gap, 0.0, 0.0), 2.0, 0.15), neighbour)
    assert run[0].outcome is outcome
    assert run[1].outcome in STOOD
    assert least < math.degrees(run[0].tilt[-1]) < most
    assert [piece.overturned for piece in run.pieces] == [outcome is OVERTURNED, False]
    if 45.0 < most < 90.0:  # since when it has been tilted by more than 45°
        after = run.time >= run[0].overturn_time
        assert (run[0].tilt[after] > math.pi / 4).all()
        assert run[0].tilt[~after][-1] <= math.pi / 4


def test_a_box_that_falls_over_on_what_it_stands_on() -> None:
    vase = sp.Body.cone(bottom=0.08, top=0.16, height=0.35, mass=1.5)
    table = sp.Piece(BOX(1.0, 1.0, 0.7, 100.0))
    run = became(table, tipped(vase, (0.0, 0.0, 0.7), 3.5, 0.04), friction=(0.6, 0.5))
    assert run[1].tilt[-1] < math.pi / 2  # it lies on its side
    assert run[1].outcome is OVERTURNED
    assert not any(piece.fell_off for piece in run.pieces)


def test_an_upper_part_that_falls_behind_the_lower_one() -> None:
    """It stands upright on the floor again: it did not turn over, and yet it fell off."""
    upper = sp.Piece(BOX(0.1, 0.3, 0.4, 3.0), (-0.1, 0.0, 0.8), velocity=(-1.2, 0.0, 0.0))
    run = became(sp.Piece(CHEST), upper, room=sp.Room(left_wall=sp.Wall(0.14)), friction=(0.2, 0.15))
    assert run[1].outcome is FELL_OFF
    assert run[1].tilt[-1] == pytest.approx(0.0, abs=1e-3)
    assert run.place[1, -1, 2] == pytest.approx(0.2, abs=1e-4)
    assert not any(piece.overturned for piece in run.pieces)
    assert 0.3 < run[1].fall_time < 1.0
    assert run.outcome is FELL_OFF


def test_a_box_that_slides_from_a_table_to_a_stool() -> None:
    table, stool = BOX(0.6, 0.6, 0.7, 100.0), BOX(0.8, 0.8, 0.4, 100.0)
    box = sp.Piece(BOX(0.3, 0.3, 0.1, 5.0), (0.1, 0.0, 0.7), velocity=(1.4, 0.0, 0.0))
    run = became(sp.Piece(table), sp.Piece(stool, (0.71, 0.0, 0.0)), box, friction=(0.2, 0.15))
    assert run.place[2, -1, 2] == pytest.approx(0.45, abs=1e-3)
    assert run[2].outcome is FELL_OFF
    assert run[0].outcome in STOOD
    level = became(sp.Piece(table), sp.Piece(table, (0.61, 0.0, 0.0)), box, friction=(0.2, 0.15))
    assert level.place[2, -1, 0] > 0.35  # it has crossed over, at the same height
    assert level[2].outcome in STOOD


@pytest.mark.parametrize("joined", [True, False])
def test_two_parts_that_come_down_together_or_not(joined: bool) -> None:
    """A joined upper part overturns with the lower one; a loose one falls off it."""
    lower = upper = BOX(0.25, 0.9, 0.9, 50.0)
    rate, ends = 1.6, [(x, y, 0.9) for x in (-0.1, 0.1) for y in (-0.4, 0.4)]
    lift = np.array([-0.125, 0.0, 1.35])
    velocity = tuple(np.cross([0.0, rate, 0.0], lift).tolist())
    bodies = [
        tipped(lower, (0.0, 0.0, 0.0), rate, 0.125),
        sp.Piece(upper, (0.0, 0.0, 0.9), velocity=velocity, rotation_rate=(0.0, rate, 0.0)),
    ]
    joints = [sp.Joint(1, 0, end) for end in ends] if joined else []
    run = sp.simulate(sp.Scene(bodies, ROUGH, joints=joints), STILL)
    assert outcomes(run) == (OVERTURNED, OVERTURNED if joined else FELL_OFF)
    assert all(piece.overturned for piece in run.pieces)
    assert [piece.fell_off for piece in run.pieces] == [False, not joined]


def test_books_that_fall_against_each_other() -> None:
    """A push to all books: the row leans; without books at its end it would lie."""
    shelf, book, end = BOX(0.3, 1.0, 0.9, 50.0), BOX(0.2, 0.03, 0.25, 0.8), BOX(0.2, 0.2, 0.3, 12.0)
    rate = 4.0
    books = [
        sp.Piece(book, (0.0, 0.05 * n, 0.9), rotation_rate=(-rate, 0.0, 0.0), velocity=(0.0, 0.5, 0.0))
        for n in range(-6, 0)
    ]
    leaning = became(sp.Piece(shelf), *books, sp.Piece(end, (0.0, 0.12, 0.9)), friction=(0.5, 0.4))
    assert leaning[0].outcome in STOOD
    assert set(outcomes(leaning)[1:-1]) == {LEANING}
    assert leaning[-1].outcome in STOOD
    lying = became(sp.Piece(shelf), *books, friction=(0.5, 0.4))
    assert OVERTURNED in outcomes(lying)


def test_pieces_side_by_side_do_not_lean_while_they_stand() -> None:
    run = became(sp.Piece(TALL), sp.Piece(TALL, (0.0, 0.5, 0.0)), sp.Piece(TALL, (0.3, 0.0, 0.0)))
    assert outcomes(run) == (sp.Outcome.RESTED,) * 3


def test_what_flies_has_fallen_off_nothing() -> None:
    run = became(sp.Piece(TALL), sp.Piece(BOX(0.2, 0.2, 0.2, 5.0), (1.0, 0.0, 0.5)))
    assert not any(piece.fell_off for piece in run.pieces)
    assert outcomes(run) == (sp.Outcome.RESTED, sp.Outcome.ROCKED)


def test_what_is_in_the_air_has_not_rested_as_in_the_plane() -> None:
    """Released above the floor, before and after it lands; thrown up by the floor, as the plane says."""
    for samples in (20, 200):
        still = sp.Motion(dt=0.01, x=np.zeros(samples))
        assert sp.simulate(sp.Piece(CHEST, (0.0, 0.0, 1.0)), ROUGH, still).outcome is sp.Outcome.ROCKED
    up = np.zeros(200)
    up[20:30] = -15.0
    thrown = sp.Motion(dt=0.01, x=np.zeros(200), z=up)
    body = sp.Body(0.5, 0.8, 60.0, length=0.8)
    planar = sp.simulate(body, ROUGH, thrown, dimensions=2)
    assert planar.outcome is sp.simulate(body, ROUGH, thrown, dimensions=3).outcome is sp.Outcome.ROCKED
    assert max(planar.peak_tilt, planar.peak_slide) < 1e-6


@pytest.mark.parametrize("turned", [0.0, math.pi / 32])
def test_a_drum_lies_on_its_circles(turned: float) -> None:
    """Between the corners of the polygon that stands for its circle, and tilted by a little less than 90°."""
    drum = sp.Piece(sp.Body.cylinder(0.4, 0.8, 30.0))
    tilt = math.pi / 2 - 1e-5
    c, s = math.cos(turned), math.sin(turned)
    about_z = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    over = np.array(
        [[math.cos(tilt), 0.0, math.sin(tilt)], [0.0, 1.0, 0.0], [-math.sin(tilt), 0.0, math.cos(tilt)]]
    )
    place = np.array([[0.0, 0.0, 0.2], [0.0, 0.0, 0.21]])
    assert lies_on_floor(drum, place, np.stack([over @ about_z] * 2)).tolist() == [True, False]


def test_a_piece_on_uneven_feet_has_not_overturned() -> None:
    """One that rests by a tenth of its height and more on the higher foot stands on its base."""
    low = sp.Body(0.6, 0.6, 40.0, length=0.6, base_heights=(0.0, 0.1))
    run = sp.simulate(low, sp.Room(), STILL, dimensions=3)
    assert run.outcome is sp.Outcome.RESTED


def test_what_is_told_of_what_fell_off() -> None:
    upper = sp.Piece(BOX(0.1, 0.3, 0.4, 3.0), (-0.1, 0.0, 0.8), velocity=(-1.2, 0.0, 0.0))
    run = became(sp.Piece(CHEST), upper, room=sp.Room(left_wall=sp.Wall(0.14)), friction=(0.2, 0.15))
    time = float(run[1].fall_time)
    english, japanese = sentences(run.named(["chest", "upper part"]))
    assert english == f"1 of 2 pieces overturned or fell off: upper part at {time:.1f} s."
    assert "落下" in japanese
    assert ("Fell off at", f"{time:.2f} s") in rows(run)
    lower, fallen = summary(run)["pieces"]
    assert (lower["fell_off"], lower["fall_time_s"]) == (False, None)
    assert (fallen["outcome"], fallen["fell_off"], fallen["overturned"]) == ("fell off", True, False)
    assert fallen["fall_time_s"] == pytest.approx(time)
    data = run.to_dataset()
    assert data.outcome.values.tolist() == [outcome.value for outcome in outcomes(run)]
    assert float(data.fall_time[1]) == time


def test_samples_at_which_nothing_moves_are_told_like_all_others() -> None:
    """Of a box that stands, slides and stands again, tilts and ways have the bits of all poses at once."""
    still, push = np.zeros(50), np.full(40, 6.0)
    motion = sp.Motion(dt=0.01, x=np.concatenate([still, push, -push, still, still]))
    run = sp.simulate(sp.Piece(sp.Body.box(0.6, 0.6, 0.5, 10.0)), sp.Room(sp.Floor(0.3, 0.25)), motion)
    (fate,) = fates_of(run.standing, run.place, run.turn, run.gaps)
    assert fate.way[-1] == fate.way[-40] > 0.01
    assert fate.tilt.tobytes() == run[0].tilt.tobytes()
    assert fate.way.tobytes() == run[0].slide.tobytes()


def test_a_stack_whose_impulses_do_not_converge_is_given_up():
    """26 t on 3 g: at this ratio of masses rounding is all that is left of the velocity below."""
    low, high = BOX(0.2, 0.2, 0.1, 0.003), BOX(0.3, 0.3, 1.9, 26_000.0)
    stack = sp.Piece(low), sp.Piece(high, at=(0.02, 0.01, 0.1), heading=0.3)
    motion = sp.near_fault()
    short = sp.Motion(dt=motion.dt, x=4.0 * np.sin(20.0 * motion.time[:20]))
    run = sp.simulate(sp.Scene(stack), short)
    assert run.unconverged > 0.02 * run.steps
    assert run.given_up
    assert set(outcomes(run)) == {sp.Outcome.FAILED}
    assert "given up" in sentences(run)[0]
    assert np.isfinite(run.place).all()
    assert not any(piece.overturned for piece in run.pieces)


def test_what_turns_in_plan_alone_has_slid_and_is_told_to_have_turned() -> None:
    spun = sp.Piece(BOX(0.4, 0.4, 0.2, 20.0), rotation_rate=(0.0, 0.0, 3.0))
    run = sp.simulate(spun, sp.Room(sp.Floor(0.3, 0.3)), STILL)
    assert run.outcome is sp.Outcome.SLID
    assert sentences(run.named(["box"]))[0] == "“box” turned by up to 15°."


def test_a_run_that_is_stopped_is_given_up() -> None:
    body, motion = sp.Piece(BOX(0.3, 0.3, 1.5, 20.0)), sp.near_fault()
    whole, stop = sp.simulate(body, sp.Room(), motion), Stop()
    with stop.ending_runs():
        same = sp.simulate(body, sp.Room(), motion)
        stop.set()
        stopped = sp.simulate(body, sp.Room(), motion)
    assert same.place.tobytes() == whole.place.tobytes()
    assert stopped.given_up
    assert stopped.steps < whole.steps
    assert not sp.simulate(body, sp.Room(), motion).given_up


def test_joints_of_the_same_two_bodies_have_names_of_their_own() -> None:
    bodies = [sp.Piece(sp.Body.box(0.4, 0.4, 0.4, 20.0), (0.0, 0.0, 0.4 * n)) for n in range(3)]
    ends = [(1, 0, (0.1, 0.0, 0.4)), (1, 0, (-0.1, 0.0, 0.4)), (2, 1, (0.0, 0.0, 0.8))]
    run = sp.simulate(sp.Scene(bodies, ROUGH, joints=[sp.Joint(*end) for end in ends]), STILL)
    assert [device.place for device in run.devices] == ["1-0, 1", "1-0, 2", "2-1"]
    names = ("low", "middle", "high")
    assert [place_called(device, names) for device in run.devices] == [
        "middle – low, 1",
        "middle – low, 2",
        "high – middle",
    ]


DRUM, ROLLS, SLIDES, RESTS = sp.Body.cylinder(0.25, 1.2, 50.0), "rolled", "slid", "rested"
G = 9.80665


@pytest.mark.parametrize(
    ("pushed", "shaken", "friction", "outcome", "way"),
    [
        # slips until it rolls at 2/3 of its speed: 5 v²/(18 μ g), then 2 v/3 (t - v/(3 μ g))
        ((0.0, 0.5), "", 0.5, ROLLS, 5.0 * 0.25 / (9.0 * G) + (3.0 - 0.5 / (1.5 * G)) / 3.0),
        ((0.5, 0.0), "", 0.05, SLIDES, 0.25 / (0.1 * G)),  # along its axis: v²/(2 μ g)
        ((0.0, 0.0), "y", 0.5, ROLLS, 2.0 / 3.0 * 3.0 / (2.0 * math.pi)),  # 2/3 of the floor's way
        ((0.0, 0.0), "x", 0.5, RESTS, 0.0),
    ],
)
def test_a_drum_on_its_side_rolls_across_its_axis_and_slides_along_it(
    pushed: tuple[float, float], shaken: str, friction: float, outcome: str, way: float
) -> None:
    """By Coulomb's law: the force of friction at its rim turns an even cylinder, of m R²/2."""
    t = np.arange(0.0, 3.005, 0.01)
    motion = sp.Motion(dt=0.01, **{"x": 0.0 * t} | ({shaken: np.sin(2.0 * np.pi * t)} if shaken else {}))
    drum = sp.Piece(DRUM, (0.0, 0.0, 0.125), tilt=(0.0, math.pi / 2, 0.0), velocity=(*pushed, 0.0))
    run = sp.simulate(drum, sp.Room(sp.Floor(friction, friction, rolling_resistance=0.0)), motion)
    assert run.outcome == outcome
    assert run[0].peak_slide == pytest.approx(way, rel=1e-3, abs=1e-9)
    assert run[0].peak_tilt < 1e-6
