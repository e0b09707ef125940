"""`verify` of Python objects: the same as of a scenario file, and what a file cannot say."""

from __future__ import annotations

import pickle
import tomllib
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
import pytest

import stayput as sp
from stayput.measures import Belt, FreeCasters, GelMats, LBracket
from stayput.uncertainty import USUAL, Lognormal

BODY = sp.Body(0.3, 1.8, 90.0, cg_offset=(0.01, -0.05), length=0.9)
ROOM = sp.Room(sp.Floor.of("carpet"), left_wall=sp.Wall(0.01), ceiling=sp.Ceiling(2.4))
FRICT = sp.Uncertainty({"frict": Lognormal(1.0, 1.0)})
FEW: dict[str, Any] = {"samples": 4, "levels": [], "progress": False}


SHAKING: dict[str, Any] = {"intensity": "6-upper", "suite": {"family": "near-fault", "count": 4}}


def scenario(**tables: Any) -> sp.Scenario:
    size = {"width": 0.3, "height": 1.8, "mass": 90.0, "cg_offset": [0.01, -0.05], "length": 0.9}
    stated = {
        "furniture": size,
        "room": {"floor": "carpet", "left_wall": {"gap": 0.01}, "ceiling": {"height": 2.4}},
        "shaking": SHAKING,
        "measures": [
            {"type": "l_bracket"},
            {"name": "pair", "combine": [{"type": "belt"}, {"type": "gel_mats"}]},
        ],
        "uncertainty": {"samples": 4},
    }
    return sp.Scenario.parse({**stated, **tables})


def verified(**asked: Any) -> sp.Verdict:
    return sp.verify(BODY, ROOM, **{"shaking": SHAKING, "measures": [LBracket()], **FEW, **asked})


def chances(verdict: sp.Verdict) -> dict[str, Any]:
    return {one.option.name: (one.probabilities, one.slide, one.tilt) for one in verdict.options}


def test_objects_give_the_numbers_of_the_file_to_the_bit_whatever_its_piece_is_called():
    tables = scenario().stated_keys()
    named = sp.Scenario.parse(tables | {"furniture": tables["furniture"] | {"name": "My shelf"}})
    of_file = sp.verify(named, levels=[], progress=False)
    of_objects = verified(measures={"l_bracket": LBracket(), "pair": [Belt(), GelMats()]})
    assert chances(of_objects) == chances(of_file)
    again = sp.Scenario.parse(tomllib.loads(of_objects.scenario.to_toml()))
    assert chances(sp.verify(again, levels=[], progress=False)) == chances(of_file)


@pytest.mark.parametrize(
    "floor",
    [
        sp.Floor(),
        sp.Floor.of("carpet"),
        replace(sp.Floor.of("carpet"), static_friction=0.6, settlement=0.0),
        sp.Floor(0.7, 0.6, edge_static_friction=0.5, edge_kinetic_friction=0.4, restitution=0.9),
    ],
)
def test_body_and_room_are_those_that_were_given(floor: sp.Floor):
    room = sp.Room(floor, left_wall=sp.Wall(0.02, 0.4, construction="concrete"), right_wall=sp.Wall(1.0))
    body = sp.Body(0.4, 1.5, 100.0, base_heights=(0.0, -0.005), base_insets=(0.01, 0.02), inertia=30.0)
    made = sp.verify(body, room, shaking=sp.near_fault(), measures=[LBracket()], **FEW).scenario
    assert made.piece.body() == body
    assert made.room.room() == room
    assert made.room.room().floor.surface == floor.surface


def test_a_scene_gives_the_numbers_of_its_body_its_case_and_its_file():
    motion = sp.near_fault().component("x")
    of_body = verified(shaking=motion)
    scene = sp.Scene([sp.Piece(BODY, name="shelf")], ROOM)
    assert chances(sp.verify(scene, shaking=motion, measures=["l_bracket"], **FEW)) == chances(of_body)
    assert chances(sp.verify(sp.Case(BODY, ROOM, motion), measures=[LBracket()], **FEW)) == chances(of_body)
    chest = sp.Piece(BODY, at=(1.0, 1.0, 0.0), measures=[FreeCasters()], name="chest")
    jar = sp.Piece(sp.Body.cylinder(0.2, 0.3, 2.0), on="chest", velocity=(0.1, 0.0, 0.0), name="jar")
    plan = sp.FloorPlan(3.6, 2.7, [sp.Door("right_wall", 0.3, 0.8)], [sp.Window("far_side_wall", 0.5, 1.6)])
    room = sp.Scene([chest, jar], plan=replace(plan, places=[sp.PersonPlace.of("cot", (3.0, 2.0))]))
    with pytest.raises(sp.InputError, match="measures is given where furniture is not one"):
        sp.verify(room, shaking=motion, measures=["belt"], **FEW)
    verdict = sp.verify(room, shaking=motion, changes=False, **FEW)
    assert verdict.scenario.scene() == room
    assert verdict.without.option.on == ((FreeCasters(),), ())
    assert "pieces" in verdict.scenario.to_toml().splitlines()[-1]
    with pytest.raises(sp.InputError, match=r"^room "):
        sp.verify(room, ROOM, shaking=motion)


def test_verdicts_are_pickled_iterated_indexed_and_a_dataset():
    verdict = verified(shaking={**SHAKING, "intensity": "6+"}, measures=["l_bracket", ("belt", GelMats())])
    assert verdict.intensity == pytest.approx(6.25)
    assert [option.option.name for option in verdict] == [option.option.name for option in verdict.options]
    assert verdict["none"] is verdict.without is verdict[len(verdict) - 1]
    with pytest.raises(sp.InputError, match=r"no option 'glue'; the options are .*l_bracket"):
        verdict["glue"]
    again = pickle.loads(pickle.dumps(verdict))
    assert again.to_json() == verdict.to_json()
    assert f"{verdict.best.runs} runs each under {verdict.motions} motions" in repr(again)
    data = verdict.to_dataset()
    chance = verdict.without.pieces[0].probabilities["overturned"]
    told = data.piece_probability.sel(option="none", piece="piece", event="overturned")
    assert told.values.tolist() == [float(chance), chance.low, chance.high]
    assert data.slide_median.attrs["units"] == "m"


def test_motions_are_taken_as_they_are():
    suite = sp.synthetic_suite("crustal", 2).to_intensity(6.0)
    of_suite, of_list = verified(shaking=suite), verified(shaking=list(suite))
    assert of_suite.motions == 2
    assert chances(of_suite) == chances(of_list)
    for one, given in zip(of_suite.scenario.ground(), suite, strict=True):
        assert np.array_equal(one.x, given.x)
    assert "Given in Python" in of_suite.scenario.to_toml()


def test_a_case_is_compared_with_its_measures():
    motion = sp.near_fault().component("x")
    verdict = sp.verify(sp.Case(BODY, ROOM, motion, measures=(LBracket(),)), **FEW)
    assert {one.option.name for one in verdict.options} == {"none", "l_bracket"}
    assert chances(verdict) == chances(verified(shaking=motion))


@dataclass(frozen=True, slots=True)
class Doubled(LBracket):
    """L-brackets of twice the usual number, as a user may write a measure."""

    kind: ClassVar[str] = "doubled"
    label: ClassVar[tuple[str, str]] = ("Doubled brackets", "2倍の金具")


def test_measures_of_ones_own_are_compared():
    verdict = verified(measures=[Doubled(count=4), LBracket(count=4)])
    found = chances(verdict)
    assert found["doubled"] == found["l_bracket"]
    assert "Given in Python" in verdict.scenario.to_toml()


def test_what_is_not_in_the_uncertainty_is_as_stated():
    verdict, of_usual = (
        verified(uncertainty=sp.Uncertainty({"friction": friction}))
        for friction in (Lognormal(1.0, 0.5), USUAL["friction"])
    )
    stated = [name for name in USUAL if name != "friction"]
    assert verdict.scenario.uncertainty.as_stated == stated
    file = scenario(measures=[{"type": "l_bracket"}], uncertainty={"samples": 4, "as_stated": stated})
    assert chances(of_usual) == chances(sp.verify(file, levels=[], progress=False))
    assert chances(verdict) != chances(of_usual)


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: sp.verify(BODY, ROOM), "shaking is missing"),
        (lambda: sp.verify(scenario(), ROOM), "room is given beside a Scenario"),
        (lambda: sp.verify(scenario(), samples=5), "samples is given beside a Scenario"),
        (lambda: sp.verify(BODY, ROOM, shaking="6-middle"), "6-middle"),
        (lambda: sp.verify(BODY, ROOM, shaking=[1.0, 2.0]), "Motion"),
        (
            lambda: sp.verify(BODY, ROOM, shaking=6.0, measures=["blet"]),
            r"measures is 'blet' \(did you mean 'belt'\?\)",
        ),
        (lambda: sp.verify(BODY, ROOM, shaking=6.0, measures=[Belt(), Belt()]), "belt"),
        (lambda: sp.verify(BODY, ROOM, shaking=6.0, uncertainty=FRICT), "friction"),
        (lambda: sp.verify("bookcase.toml"), r"read\('bookcase.toml'\)"),
        (lambda: sp.verify(BODY, ROOM, shaking=np.zeros(99)), r"ndarray of length 99; .* Motion\(dt=0.01"),
    ],
)
def test_what_is_wrong_is_refused_in_a_sentence(call: Any, told: str):
    with pytest.raises(sp.InputError, match=told):
        call()


def test_a_measure_of_ones_own_without_its_names_is_refused_at_once():
    with pytest.raises(sp.InputError, match="Odd has no kind or no label"):

        @dataclass(frozen=True, slots=True)
        class Odd(LBracket):
            label: ClassVar[Any] = "odd"

    @dataclass(frozen=True, slots=True)
    class Bare(sp.Measure):
        def apply(self, body: sp.Body, room: sp.Room) -> Any:
            return body

    with pytest.raises(sp.InputError, match="Bare has no kind or no label"):
        Bare()

    @dataclass(frozen=True, slots=True)
    class Wrong(Bare):
        kind: ClassVar[str] = "wrong"
        label: ClassVar[tuple[str, str]] = ("Wrong", "誤")

    with pytest.raises(sp.InputError, match=r"apply\(\) of wrong is Body"):
        sp.hold(BODY, ROOM, [Wrong()])


def test_with_no_measures_the_bare_body_alone_is_verified():
    of_list = verified(shaking="6-lower", measures=[])
    assert [one.option.name for one in of_list.options] == ["none"]
    assert "no measure that was compared" not in of_list.sentence()
    case = sp.Case(BODY, ROOM, sp.near_fault(), dimensions=2)
    assert len(sp.verify(case, measures={}, **FEW).options) == 1
    assert len(sp.verify(case, **FEW).options) > 5


def test_single_numbers_of_numpy_are_numbers():
    plain = chances(verified(shaking=6.0, seed=2, measures=[]))
    of_numpy = verified(shaking=np.float32(6.0), samples=np.int64(4), seed=np.int32(2), measures=[])
    assert chances(of_numpy) == plain
    for strength in (np.float32(6.0), np.array(6.0)):
        assert verified(shaking={**SHAKING, "intensity": strength}, measures=[]).intensity == 6.0


@pytest.mark.parametrize("switch", ["changes"])
def test_a_switch_is_true_or_false(switch: str):
    with pytest.raises(sp.InputError, match=f"^{switch} is 'no'; it must be of type bool"):
        verified(shaking="6-lower", **{switch: "no"})
