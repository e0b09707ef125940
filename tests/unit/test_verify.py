"""Verification: options, draws, levels, what they say; the same bits however it is run."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import stayput as sp
from stayput.fragility.intensity_measures import JMA_INTENSITY, PGA
from stayput.mechanics.columns import OVERTURNED_OUTCOME, RESTED, RESULT
from stayput.montecarlo.counting import (
    DEVICE_FAILED,
    EVENTS,
    OVERTURNED,
    Member,
    Members,
    Quantiles,
    worst_of,
)
from stayput.montecarlo.runs import Runs
from stayput.montecarlo.sampling import drawn_body, drawn_place, drawn_surfaces, draws, rows_of
from stayput.montecarlo.scaled_motions import ScaledMotions
from stayput.motion.suites import synthesis
from stayput.scenario import Scenario
from stayput.verification import verify
from stayput.verification.option_runner import drawn_run
from stayput.verification.options import compared_options
from stayput.verification.people import typical_of
from stayput.verification.race import FIRST_LOOK, STEP

ROOM = {"floor": "wood flooring", "left_wall": {"gap": 0.02}, "ceiling": {"height": 2.4}}
FEW = np.array([5.0, 5.75, 6.5])


def scenario(**tables):
    data = {
        "furniture": {"preset": "bookcase"},
        "room": ROOM,
        "shaking": {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 5}},
        "uncertainty": {"samples": 10},
        "measures": [{"type": "l_bracket"}, {"type": "felt_glides"}],
    }
    return Scenario.parse({**data, **tables})


@pytest.fixture(scope="module")
def verdict():
    return verify(scenario(), levels=FEW)


def test_every_option_is_there_ranked_and_counted(verdict):
    assert [one.rank for one in verdict.options] == [1, 2, 2]  # glides differ in nothing clear
    shares = {one.option.name: one.probabilities[OVERTURNED].estimate for one in verdict.options}
    assert list(shares) == ["l_bracket", "none", "felt_glides"]
    assert verdict.without.option.measures == ()
    assert verdict.without.change is None
    assert verdict.best is verdict.options[0]
    # a bracket holds what falls without it
    assert verdict.best.option.name == "l_bracket"
    assert (shares["none"] > 0.4, shares["l_bracket"]) == (True, 0.0)
    assert verdict.best.change.estimate < -0.4
    # and two more of the best one, unbreakable, in which a bracket reaches its strength
    assert (verdict.motions, verdict.runs) == (5, 3 * 5 * 2 * (1 + len(FEW)) + 2)
    assert [one.runs for one in verdict] == [10, 10, 10]
    for one in verdict.options:
        assert set(one.probabilities) == set(EVENTS)
        assert one.probabilities[OVERTURNED].runs == 10
        assert 0 <= one.typical.motion < 5
        assert 0 <= one.worst.sample < 2


def test_devices_are_those_of_the_measures(verdict):
    bracket, *others = sorted(verdict.options, key=lambda one: one.option.name != "l_bracket")
    assert bracket.devices
    for device in bracket.devices:
        assert 0.0 < device.peak.median < 1e5
        assert 0.0 < device.used.median <= device.used.p90
    assert all(one.devices == () for one in others)
    assert verdict.without.probabilities[DEVICE_FAILED].estimate == 0.0


def test_a_device_s_failures_and_margins_are_those_of_its_runs():
    weak = scenario(measures=[{"type": "belt", "strength": 700.0}])
    found = verify(weak, levels=())
    belt = next(one for one in found.options if one.option.measures)
    members = [Member(m, s) for m in range(found.motions) for s in range(2)]
    runs = [drawn_run(found.scenario, belt.option, member) for member in members]
    assert len(belt.devices) == 2
    for number, told in enumerate(belt.devices):
        results = [run.devices[number] for run in runs]
        times = [one.failure_time for one in results if one.failed]
        assert 0 < len(times) < len(results)
        assert told.failed.fell == len(times)
        assert told.failure_time == np.median(times)
        nowhere = np.zeros(len(results), bool)
        assert told.used == Quantiles.of(np.array([one.utilisation for one in results]), nowhere)
        assert told.used.p90 >= 1.0


def test_curves_against_every_measure_of_the_shaking(verdict):
    curve = verdict.without.curves[JMA_INTENSITY]
    assert [level.im for level in curve.levels] == pytest.approx(sorted({*FEW, verdict.intensity}))
    shares = [level.probability.estimate for level in curve.levels]
    assert shares[0] <= shares[-1]
    assert verdict.without.capacities.keys() == {0.1, 0.5}
    assert PGA in verdict.without.curves


def told_of(option):
    """Return what runs tell of an option."""
    peaks = [device.peak for device in option.devices]
    return option.option, option.probabilities, option.slide, option.tilt, option.change, option.worst, peaks


def test_bits_do_not_depend_on_threads(verdict):
    again = verify(scenario(), levels=FEW, threads=1)
    assert list(map(told_of, again.options)) == list(map(told_of, verdict.options))


def test_the_ranking_is_told_as_it_gets_better_and_its_bits_do_not_depend_on_that():
    asked, told = scenario(uncertainty={"samples": 20}, measures=[{"type": "l_bracket"}]), []
    plain, heard = verify(asked, levels=FEW[1:]), verify(asked, levels=FEW[1:], on_verdict=told.append)
    assert [one.without.runs for one in told] == [8, 20]
    assert not any(one.complete or one.without.curves for one in told)
    assert heard.complete
    for early in told:  # some of the runs of the final answer, by the same engine
        assert early.scenario is heard.scenario
        final = {each.option.name: each.probabilities["overturned"] for each in heard.options}
        for each in early.options:
            first, last = each.probabilities["overturned"], final[each.option.name]
            fell, falls = round(first.estimate * first.runs), round(last.estimate * last.runs)
            assert 0 <= falls - fell <= last.runs - first.runs
    for other in (told[-1], plain):
        assert list(map(told_of, other.options)) == list(map(told_of, heard.options))
    for one, other in zip(plain.options, heard.options, strict=True):
        for measure, curve in one.curves.items():
            shares = (each.probability(FEW[1:]) for each in (curve, other.curves[measure]))
            assert np.array_equal(*shares, equal_nan=True)
    assert (plain.runs, plain.precise) == (heard.runs, heard.precise)


def test_only_of_synthetic_motions_some_are_made():
    asked = scenario()
    assert (len(asked.ground()), len(asked.ground(2))) == (5, 2)
    given = asked.with_python(motions=sp.synthetic_suite("crustal", 3))
    assert (len(given.ground()), len(given.ground(2))) == (3, 3)


@pytest.mark.parametrize("above", [{}, {"building": {"storeys": 8, "structure": "RC"}, "storey": 6}])
def test_the_first_answer_waits_for_no_motions_but_its_own(above):
    shaking = {"intensity": "6-lower", "suite": {"family": "near-fault", "count": 12, "seed": 5}, **above}
    glides = [{"type": "felt_glides"}]
    asked = scenario(shaking=shaking, measures=glides, uncertainty={"precision": 0.45})
    synthesis._CACHE.clear()
    told, made = [], []

    def note(verdict):
        told.append(verdict)
        made.append(len(synthesis._CACHE))

    heard, plain = sp.verify(asked, progress=False, on_verdict=note), sp.verify(asked, progress=False)
    assert (made[0], told[0].motions, told[0].runs) == (FIRST_LOOK, 12, 2 * FIRST_LOOK)
    assert told[0].intensity == pytest.approx(heard.intensity, rel=1e-12)
    heard, plain = (replace(one, seconds=0.0).to_json() for one in (heard, plain))
    assert heard == plain


def test_an_option_does_not_depend_on_what_stands_beside_it(verdict):
    alone = verify(scenario(measures=[{"type": "felt_glides"}]), levels=())
    glides = next(one for one in verdict.options if one.option.name == "felt_glides")
    other = next(one for one in alone.options if one.option.name == "felt_glides")
    assert glides.probabilities == other.probabilities
    assert glides.slide == other.slide
    assert other.curves == {}


def test_samples_stop_at_the_asked_precision():
    rough = verify(scenario(uncertainty={"samples": 400, "precision": 0.49}), levels=())
    assert {one.runs for one in rough} <= {STEP, 2 * STEP}
    assert rough.precise
    exhausted = verify(scenario(uncertainty={"samples": 20, "precision": 0.001}), levels=())
    assert {one.runs for one in exhausted} == {20}
    assert not exhausted.precise


def test_more_samples_continue_the_draws_of_fewer():
    few, many = draws(3, 2, 7), draws(3, 5, 7)
    assert [row[:2] for row in many] == list(few)
    assert [row[2:] for row in many] == list(draws(3, 3, 7, start=2))


def test_draws_change_what_is_not_known_only():
    draw = draws(1, 1, 3)[0][0]
    body, room = sp.Body(0.4, 1.8, 100.0, cg_offset=(0.0, -0.1)), sp.Room(sp.Floor(0.4, 0.3), sp.Wall(0.02))
    drawn, around = drawn_body(body, draw), drawn_surfaces(drawn_place(room, draw), draw)
    assert (drawn.width, drawn.height) == (body.width, body.height)
    assert drawn.mass == pytest.approx(draw.mass * 100.0)
    assert 0.9 + drawn.cg_offset[1] == pytest.approx(draw.gravity_height * 0.8)
    assert around.floor.kinetic_friction == pytest.approx(draw.friction * 0.3)
    assert around.left_wall.gap == pytest.approx(draw.wall_gap * 0.02)
    insets = draw.back_inset * 0.4, draw.front_inset * 0.4
    assert drawn.base_insets == pytest.approx(insets)
    assert drawn.base_heights == pytest.approx((0.0, -draw.lean * (0.4 - sum(insets))))
    assert around.floor.landing_place == draw.landing_place
    assert around.left_wall.restitution == draw.wall_restitution
    assert 0.9 <= around.floor.restitution <= 1.0


@pytest.mark.parametrize("held", [(), (sp.measures.Belt(),)])
def test_a_base_that_carries_its_weight_as_stated_does_so_in_every_draw(held):
    """Insets near the centre of gravity or the largest allowed, on both ways of making rows."""
    room = sp.Room(sp.Floor(0.4, 0.3, settlement=0.05), sp.Wall(0.02))
    drawn = draws(3, 16, 1)
    for draw in drawn[0]:
        assert drawn_surfaces(room, draw).floor.settlement <= 0.05
    for body in (
        sp.Body(0.4, 1.8, 100.0, cg_offset=(0.03, 0.0), base_insets=(0.0, 0.16)),
        sp.Body(0.3, 1.2, 60.0, base_insets=(0.134, 0.134)),
    ):
        left, right = rows_of(body, room, held, drawn, 9.81).cases["u"][:, :2].T
        assert (left < 0.0).all()
        assert (right > 0.0).all()


@pytest.mark.parametrize("building", [None, {"storeys": 5}, {"storeys": 5, "nonlinear": False}])
def test_the_ground_has_the_level_and_the_floor_follows(building):
    keys = {"suite": {"family": "crustal", "count": 3}}
    if building:
        keys |= {"building": building, "storey": 5}
    shaking = scenario(shaking=keys).shaking
    scaled_motions = ScaledMotions(shaking.ground(Path()), shaking.building, shaking.storey or 1)
    floors = scaled_motions.at(5.5)
    assert floors.values(JMA_INTENSITY) == pytest.approx(np.full(3, 5.5), abs=1e-9)
    wanted = scenario(shaking={**keys, "intensity": 5.5}).shaking.motions(Path())
    for number in range(3):
        x = floors.scales[number] * floors.motions[number].x
        assert x == pytest.approx(wanted[number].x, rel=1e-6, abs=5e-6)  # floors are in whole 1e-6
    assert floors.values(PGA) == pytest.approx([m.to_intensity(5.5).pga for m in scaled_motions.ground])


def test_peaks_are_of_the_larger_component_that_acts_and_nothing_where_none_does():
    small = np.tile([0.0, 1.0, 0.0, -1.0], 50)
    large = -3.0 * small
    across = sp.Motion(0.01, small, y=large, z=small)
    upward = sp.Motion(0.01, 0.0 * small, z=large)
    for dimensions, pga in ((3, 3.0), (2, 1.0)):
        floors = ScaledMotions(sp.Suite((across,)), dimensions=dimensions).at(4.0)
        assert floors.values(PGA) == pytest.approx(pga * floors.scales)
    assert ScaledMotions(sp.Suite((upward,))).at(4.0).values(PGA) == [0.0]


def test_usual_measures_are_those_that_can_be_applied_here():
    furniture = {"preset": "bookcase"}
    near, open_room = (
        [option.name for option in compared_options(Scenario.parse({"furniture": furniture, **room}))[0]]
        for room in ({"room": ROOM}, {})
    )
    assert near[0] == open_room[0] == "none"
    assert "tension_pole" not in open_room
    assert {"l_bracket", "tension_pole", "wedge_stopper + tension_pole"} <= set(near)


@pytest.mark.parametrize(("stated", "meant"), [("6+", 6.25), ("６－", 5.75), ("5-", 4.75), ("5+", 5.25)])
def test_classes_are_known_by_their_signs(stated: str, meant: float):
    assert sp.near_fault().to_intensity(stated).intensity == pytest.approx(meant)


def test_the_scale_of_intensity_ends():
    with pytest.raises(sp.InputError, match=r"shaking\.intensity is 8; it must be .*-3 and 7\.5"):
        scenario(shaking={"intensity": 8})
    with pytest.warns(sp.InputWarning, match=r"none above 7 has been recorded"):
        scenario(shaking={"intensity": 7.2})


def test_what_cannot_be_verified():
    with pytest.raises(sp.InputError, match="must be 'coulomb' for a verification"):
        sp.verify(sp.Case(sp.Body(0.3, 1.8, 60.0), sp.Room(), sp.near_fault(), "paper"))
    with pytest.raises(sp.InputError, match="not increasing"):
        verify(scenario(), levels=[6.0, 5.0])
    with pytest.raises(sp.InputError, match=r"is 700; it must be between -3 and 7\.5"):
        verify(scenario(), levels=[6.0, 700.0])
    with pytest.raises(sp.InputError):
        verify(scenario(room={"floor": "carpet"}, measures=[{"type": "tension_pole"}]), levels=())


def test_it_can_be_stopped_from_outside():
    class StoppedError(Exception):
        pass

    seen = []

    def on_progress(done, total):
        seen.append((done, total))
        if len(seen) == 2:
            raise StoppedError

    with pytest.raises(StoppedError):
        verify(scenario(), levels=FEW, on_progress=on_progress)
    assert len(seen) == 2
    assert seen[1][0] < seen[1][1]


def test_a_record_keeps_its_own_strength():
    found = verify(scenario(shaking={"builtin": "near-fault", "scale": 0.5}), levels=())
    assert found.intensity == pytest.approx(sp.near_fault().intensity + 2.0 * math.log10(0.5))
    assert found.motions == 1


def test_quantiles_count_a_fall_as_infinite():
    peaks, fell = np.array([[0.1, 0.2, 0.3, 9.0]]), np.array([[False, False, False, True]])
    assert Quantiles.of(peaks, fell) == Quantiles(0.3, math.inf)
    assert Quantiles.of(peaks, np.zeros((1, 4), bool)).p90 == 9.0
    few = np.arange(1.0, 9.0)  # nine in ten of eight are all of them
    assert Quantiles.of(few, np.zeros(8, bool)).p90 == 8.0


def hand_made(overturned: NDArray[np.bool_], tilt: NDArray[np.float64]) -> Runs:
    """Runs of a lone piece without devices, of which some overturn."""
    overturned, tilt = overturned.ravel(), tilt.ravel()
    none, nothing = np.zeros_like(overturned), np.empty((len(tilt), 0))
    results = np.zeros((len(tilt), 1), RESULT)
    results["outcome"] = np.where(overturned, OVERTURNED_OUTCOME, RESTED)[:, np.newaxis]
    return Runs(
        Members.of_samples(2, 2),
        overturned=overturned,
        missing=none,
        hit_wall=none,
        device_failed=none,
        slide=0.0 * tilt,
        tilt=tilt,
        devices=nothing,
        used=nothing,
        masses=0.0 * tilt,
        results=results,
        hits=np.empty((len(tilt), 0, 1, 4)),
        blocked=nothing.astype(bool),
        shut_in=nothing.astype(bool),
        tracks=nothing.astype(object),
    )


def test_the_typical_run_is_in_the_middle_and_the_worst_at_the_end():
    tilt = np.array([[0.1, 0.3], [0.2, 0.0]])
    runs = hand_made(np.zeros((2, 2), bool), tilt)
    assert worst_of(runs) == Member(0, 1)
    assert typical_of(runs) == Member(0, 0)
    falls = hand_made(np.array([[False, True], [False, False]]), tilt)
    assert typical_of(falls) == Member(0, 0)  # as most do, it stands
    fails = replace(runs, device_failed=np.array([False, False, True, False]))
    assert worst_of(fails) == Member(1, 0)
    trembling = replace(runs, tilt=1e-6 * tilt.ravel(), slide=np.array([0.1, 0.2, 0.0, 1.0]))
    assert worst_of(trembling) == Member(1, 1)  # what only slides is worst where it slides farthest
    gone = replace(falls, missing=np.array([False, True, False, False]))
    assert worst_of(gone) == Member(1, 0)


def test_the_typical_draw_is_so_without_and_with_a_measure():
    fell = np.array([[True, True], [True, False]]), np.array([[True, False], [False, False]])
    bare, held = (hand_made(of, 0.1 * of) for of in fell)
    assert typical_of(bare, held) in (Member(0, 1), Member(1, 0))  # falls, and is held


def test_a_piece_is_safe_by_the_end_of_the_interval_alone():
    low = {"furniture": {"width": 2.0, "height": 0.2, "mass": 80.0}}
    doubt = "（今回の計算の範囲では。72%未満の場合に転倒する可能性は否定できません）"
    for count, english, japanese in (
        (3, " in these runs; it may overturn in under 72 % of the cases", doubt),
        (80, "", ""),
    ):
        shaking = {"intensity": 3.0, "suite": {"family": "crustal", "count": count}}
        stated = {**low, "shaking": shaking, "uncertainty": {"samples": count}}
        verdict = verify(sp.Scenario.parse(stated), levels=())
        assert f"stays upright without any measure{english}. " in verdict.sentence("en")
        assert f"対策なしで転倒しません{japanese}。" in verdict.sentence("ja")


@pytest.mark.parametrize(
    "tables",
    [
        {"room": {"ceiling": {"height": 0.5}}},
        {"room": {"ceiling": {"height": 1.79}}},
        {"room": {"left_wall": {"gap": 0.0}}, "initial": {"tilt": -0.05}},
    ],
)
def test_a_piece_inside_the_ceiling_or_the_wall_is_refused(tables):
    piece = {"furniture": {"preset": "cupboard"}, "shaking": {"intensity": 5.5}}
    with pytest.raises(sp.InputError, match="inside the"):
        sp.verify(sp.Scenario.parse({**piece, **tables}), levels=[])


def test_the_most_likely_level_is_told_where_the_interval_is_open() -> None:
    stone = sp.Fallen(sp.Body(0.24, 0.62, 95.0), fell=18, total=20, room=sp.Room(sp.Floor(0.6, 0.5)))
    found = sp.intensity_from_fallen([stone], motions=sp.synthetic_suite("crustal", 12), samples=4)
    assert found.high == float("inf")
    assert found.low < found.most_likely <= 7.5
