"""How strongly the ground shakes, by what a scenario states: one way alone, its scatter, its words."""

from __future__ import annotations

import json
import math
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

import stayput as sp
from stayput.app.messages import RefusedError
from stayput.app.running import shaking_reply
from stayput.app.server import create_app
from stayput.catalogue import say
from stayput.fragility.intensity_measures import (
    INTENSITY_MEASURES,
    JMA_INTENSITY,
    MMI,
    PGA,
    IntensityMeasure,
    spectral_acceleration,
)
from stayput.montecarlo.counting import Member
from stayput.montecarlo.scaled_motions import ScaledMotions
from stayput.motion.ground_shaking import (
    EarthquakeSource,
    horizontal_peak,
    horizontal_sa,
    strength_of_earthquake,
    strength_of_intensity,
    strength_of_mercalli,
    strength_of_pga,
    strength_of_pgv,
    strength_of_sa,
)
from stayput.motion.intensity import mercalli
from stayput.report.verdict.data import verdict_data
from stayput.scenario import Scenario
from stayput.verification import verify
from stayput.verification.option_runner import floor_motion

if TYPE_CHECKING:
    from pathlib import Path

    from stayput.app.running import ShakingReply

QUAKE = {"magnitude": 7.0, "distance": 20.0}
NEAR = {"family": "near-fault"}
LEAST = {"furniture": {"preset": "bookcase"}}


def scenario(**shaking: Any) -> Scenario:
    return Scenario.parse({**LEAST, "shaking": shaking, "uncertainty": {"samples": 8, "seed": 3}})


@pytest.mark.parametrize(
    ("keys", "sentence"),
    [
        (
            {"mmi": 8.0, "intensity": 6.0},
            "shaking.mmi is given beside shaking.intensity; only one of the two must be given.",
        ),
        ({"pga": 3.0, "earthquake": QUAKE}, "shaking.earthquake is given beside shaking.pga"),
        ({"pgv": 0.3, "scale": 2.0}, "shaking.scale is given beside shaking.pgv"),
        (
            {"sa": {"period": 20.0, "value": 3.0}},
            "shaking.sa.period is 20.0; it must be a number between 0.01 and 10 s.",
        ),
        ({"sa": {"period": 0.3}}, "shaking.sa.value is missing"),
        ({"mmi": 11.0}, "shaking.mmi is 11.0; it must be a number between 2 and 10."),
        ({"pga": 0.0}, "shaking.pga is 0.0; it must be a number between 0.001 and 1000 m/s²."),
        (
            {"earthquake": {"magnitude": 9.0, "distance": 20.0}},
            "shaking.earthquake.magnitude is 9.0; it must be a number between 5.8 and 8.3.",
        ),
        (
            {"earthquake": {"magnitude": 7.0, "distance": 500.0}},
            "shaking.earthquake.distance is 500.0; it must be a number between 3 and 300 km.",
        ),
        ({"earthquake": {"magnitude": 7.0}}, "shaking.earthquake.distance is missing; it must be"),
    ],
)
def test_what_contradicts_or_lies_outside_the_model_is_refused(keys: dict[str, Any], sentence: str) -> None:
    with pytest.raises(sp.InputError) as refused:
        scenario(**keys)
    assert str(refused.value).startswith(sentence)


@pytest.mark.parametrize(
    ("keys", "measure"), [({"pga": 3.0}, "PGA"), ({"pgv": 0.3}, "PGV"), ({"mmi": 8.0}, "PGV")]
)
def test_a_motion_is_scaled_to_the_peak_of_its_larger_component(keys: dict[str, float], measure: str) -> None:
    table = scenario(**keys)
    motion = table.motion()
    assert table.shaking.strength is not None
    assert horizontal_peak(motion, measure) == pytest.approx(table.shaking.strength.median)  # type: ignore[arg-type]
    assert max(motion.peaks()[name].pga for name in ("x", "y")) == horizontal_peak(motion, "PGA")


def test_a_piece_that_faces_another_way_meets_the_same_earthquake() -> None:
    """The larger component is one of those that are given, not of those along and across the piece."""
    straight, turned = (
        Scenario.parse(
            {
                "furniture": {"preset": "bookcase", "heading": heading},
                "shaking": {"pgv": 0.4},
                "dimensions": 3,
            }
        ).ground()
        for heading in (0.0, 0.7)
    )
    for one, other in zip(straight, turned, strict=True):
        assert other.intensity == pytest.approx(one.intensity, abs=1e-9)


def test_the_strengths_of_the_motions_have_the_stated_middle_and_scatter() -> None:
    strength = strength_of_mercalli(8.0)
    levels = np.array([one.level for one in strength.drawn(24, 5)])
    assert float(np.mean(levels)) == pytest.approx(strength.level)
    assert float(np.std(levels)) == pytest.approx(strength.scatter)
    assert len(set(levels.tolist())) == 24
    assert [one.level for one in strength.drawn(24, 5)] == levels.tolist()
    other = [one.level for one in strength.drawn(24, 6)]
    assert other != levels.tolist()
    assert sorted(other) == sorted(levels.tolist())
    assert [one.level for one in strength.drawn(1, 5)] == [strength.level]
    assert all(one.scatter == 0.0 for one in strength.drawn(24, 5))


def test_a_stated_intensity_is_to_the_bit_what_a_level_of_a_curve_is() -> None:
    scaled_motions = ScaledMotions(scenario(intensity=5.9).ground())
    stated, level = scaled_motions.stated(strength_of_intensity(5.9), None, 1), scaled_motions.at(5.9)
    assert np.array_equal(stated.scales, level.scales)


@pytest.mark.parametrize("period", [0.1, 0.3, 1.0])
def test_a_motion_is_scaled_to_the_spectral_acceleration_of_both_components(period: float) -> None:
    motion = scenario(sa={"period": period, "value": 6.0}).motion()
    along, across = (motion.spectrum([period], 0.05, name).sa[0] for name in ("x", "y"))
    assert math.sqrt(along * across) == pytest.approx(6.0)
    assert along != pytest.approx(6.0, rel=1e-3)


def test_curves_are_drawn_over_mercalli_intensities_and_spectral_accelerations_too() -> None:
    sa = spectral_acceleration(0.3)
    wanted = scenario(intensity=6.0, suite=NEAR | {"count": 4})
    verdict = verify(wanted, levels=[5.5, 6.0], intensity_measures=[MMI, sa, PGA], progress=False)
    curve = verdict.without.curves
    assert set(curve) == {*INTENSITY_MEASURES.values(), MMI, sa}
    felt = [motion.to_intensity(6.0) for motion in wanted.ground()]
    expected = {
        sa: [horizontal_sa(motion, 0.3) for motion in felt],
        MMI: [mercalli(horizontal_peak(motion, "PGA"), horizontal_peak(motion, "PGV")) for motion in felt],
    }
    for measure, values in expected.items():
        assert set(np.round(values, 9)) <= set(np.round(curve[measure].trials.im, 9))
    usual = verify(wanted, levels=[5.5, 6.0], progress=False).without.curves
    assert set(usual) == set(INTENSITY_MEASURES.values())
    with pytest.raises(sp.InputError, match="intensity_measures is 'CAV'"):
        verify(wanted, intensity_measures=[IntensityMeasure("CAV", ("CAV", "CAV"), "m/s")])


@pytest.mark.parametrize(
    "keys",
    [{"pga": 4.0}, {"pgv": 0.4}, {"sa": {"period": 0.3, "value": 8.0}}, {"mmi": 8.0}, {"earthquake": QUAKE}],
)
def test_a_verdict_says_what_was_stated_and_by_which_source(keys: dict[str, Any]) -> None:
    verdict = verify(scenario(**keys, suite=NEAR | {"count": 6}), levels=[], progress=False)
    data = json.loads(json.dumps(verdict_data(verdict)))
    strength = verdict.scenario.shaking.strength
    assert strength is not None
    assert data["strength"]["stated"] == next(iter(keys))
    assert data["strength"]["median"] == pytest.approx(strength.median)
    assert data["strength"]["scatter_of_log10"] == strength.scatter
    told = {entry["what"]: entry["value"] for entry in data["assumptions"]}[
        "Strength of the ground's shaking"
    ]
    assert told == strength.told(6)[0]
    noted = [note["en"] for note in data["notes"] if told in note["en"]]
    if strength.scatter:
        assert "not the seismic hazard at your site" in noted[0]
        assert strength.source[0] in noted[0]
    else:
        assert not noted
    again = verify(verdict.scenario, levels=[], progress=False, threads=1)
    assert [one.probabilities for one in again.options] == [one.probabilities for one in verdict.options]


def test_every_option_meets_the_same_strengths_and_a_replay_has_its_own() -> None:
    wanted = scenario(mmi=8.0, suite=NEAR | {"count": 6})
    verdict = verify(wanted, levels=[], progress=False)
    ground = wanted.ground()
    floors = ScaledMotions(ground).stated(wanted.shaking.strength, None, verdict.seed)
    assert float(np.std(np.log10(floors.scales))) == pytest.approx(0.38)
    for number in range(6):
        assert floor_motion(wanted, Member(number, 0))[1] == floors.scales[number]
    assert verdict.intensity == floors.median_intensity


def test_the_curves_are_those_of_the_same_scenario_at_an_intensity() -> None:
    """Curves are drawn against intensities, to which every motion is scaled, whatever is stated."""
    by_quake, by_intensity = (
        verify(scenario(**keys, suite=NEAR | {"count": 6}), levels=[5.0, 6.0], progress=False).without
        for keys in ({"earthquake": QUAKE}, {"intensity": 5.5})
    )
    first, second = (one.curves[JMA_INTENSITY] for one in (by_quake, by_intensity))
    for level in (1, 2):  # after those at the stated shaking, which differs and is in both fits
        counts = [
            (curve.trials.fell[curve.trials.level == level].sum(), (curve.trials.level == level).sum())
            for curve in (first, second)
        ]
        (fell, of), (others, of_others) = counts
        assert of == of_others > 0
        # factors differ by rounding, by which runs of many impacts may end otherwise
        assert abs(fell - others) <= 1
    medians = [curve.capacity(0.5) for curve in (first, second)]
    assert medians[0].low <= medians[1].estimate <= medians[0].high


def test_strengths_say_themselves_in_both_languages() -> None:
    for strength in (
        strength_of_pga(3.0),
        strength_of_pgv(0.3),
        strength_of_mercalli(7.0),
        strength_of_sa(0.3, 8.0),
        strength_of_earthquake(EarthquakeSource(7.0, 20.0, kind="intraslab")),
    ):
        for motions in (1, 12):
            english, japanese = strength.told(motions)
            assert "{" not in english + japanese
            assert not english.endswith(".")
            assert not japanese.endswith("。")
    assert "within a diving plate" in say(strength.told(12), "en")
    assert "without this scatter" in say(strength.told(1), "en")
    assert "1.7" in say(strength.told(12), "en")  # 10^0.23


def test_a_still_motion_has_no_peak_to_scale_to(tmp_path: Path) -> None:
    still = sp.Motion(0.01, np.zeros(400))
    with pytest.raises(sp.InputError, match="still"):
        horizontal_peak(still, "PGA")
    still.write(tmp_path / "still.csv")
    read = Scenario.parse({**LEAST, "shaking": {"record": "still.csv", "pgv": 0.3}}, tmp_path)
    with pytest.raises(sp.InputError, match="still"):
        read.ground()


def test_the_inventorys_ground_is_scaled_alike() -> None:
    wanted = scenario(earthquake=QUAKE, suite=NEAR | {"count": 6})
    ground = ScaledMotions(wanted.ground())
    factors = ground.stated_factors(wanted.shaking.strength, None, 3)
    peaks = [
        horizontal_peak(motion.scaled(float(k)), "PGV")
        for motion, k in zip(wanted.ground(), factors, strict=True)
    ]
    assert float(np.mean(np.log10(peaks))) == pytest.approx(math.log10(EarthquakeSource(7.0, 20.0).pgv))


def test_the_server_says_what_it_amounts_to() -> None:
    app = create_app(warming=False)
    service = app.state.service

    def asked(**shaking: Any) -> ShakingReply:
        return shaking_reply(service.shaken({**LEAST, "shaking": shaking}, []))

    try:
        told = asked(earthquake=QUAKE, suite=NEAR | {"count": 12})
        assert told.deviation > 0.3
        assert told.sentence.en.startswith(f"About JMA intensity {told.intensity:.1f} ± ")
        assert "震度" in told.sentence.ja
        assert told.about is not None
        assert "Si and Midorikawa (1999)" in told.about.en
        exact = asked(intensity="6-upper", suite=NEAR | {"count": 3})
        assert (exact.intensity, exact.deviation) == (pytest.approx(6.25), pytest.approx(0.0, abs=1e-9))
        assert exact.intensity_class == "6-upper"
        with pytest.raises(RefusedError) as refused:
            asked(earthquake={"magnitude": 5.0, "distance": 20.0})
        assert refused.value.error.field == "scene.shaking.earthquake.magnitude"
    finally:
        service.close()
