"""Who is crushed, hit and touched: by hand-made runs of a room, and along the tracks of a real one."""

from typing import Any

import numpy as np
import pytest
from html_pages import Page

import stayput as sp
from stayput.mechanics.columns import OVERTURNED_OUTCOME, RESTED, RESULT
from stayput.mechanics.devices.columns import DEVICE
from stayput.model.floor_plan import FloorPlan, PersonPlace
from stayput.montecarlo.counting import Members
from stayput.montecarlo.runs import Runs
from stayput.report.room.report import room_html
from stayput.simulation import groups
from stayput.simulation.groups import Track
from stayput.verification.events import happens_in
from stayput.verification.people import CRUSHING_ENERGY, people_of

PIECES = [("bookcase", 90.0), ("fridge", 70.0), ("lamp", 3.0), ("chest", 40.0)]


@pytest.fixture
def runs():
    """Ten runs: a bookcase falls on the bed in 4, a lamp in 2, a fridge nudges it in all."""
    fell = np.zeros((10, 4), np.bool_)
    fell[:4, 0] = fell[4:6, 2] = fell[:9, 3] = True
    energy = np.full((10, 1, 4), np.nan)
    energy[:4, 0, 0], energy[:, 0, 1], energy[4:6, 0, 2] = 1400.0, 25.0, 0.9 * CRUSHING_ENERGY
    results = np.zeros((10, 4), RESULT)
    results["outcome"] = np.where(fell, OVERTURNED_OUTCOME, RESTED)
    no, zero = np.zeros(10, np.bool_), np.zeros(10)
    falls = np.array([1.0, 0.0, 1.0, 1.0])
    return Runs(
        Members.of_samples(10, 1),
        overturned=fell.any(axis=1),
        missing=no,
        hit_wall=no,
        device_failed=no,
        slide=zero,
        tilt=zero,
        devices=np.zeros((10, 0), DEVICE),
        used=np.zeros((10, 0)),
        masses=1.0 + zero,
        results=results,
        hits=np.stack([energy * 0.0, energy * 0.0 + 0.6, energy, energy * 0.0 + falls], axis=-1),
        blocked=np.zeros((10, 0), np.bool_),
        shut_in=np.zeros((10, 1), np.bool_),
        tracks=np.empty((10, 0), object),
    )


def test_crushed_is_within_hit_within_falls_and_a_nudge_only_touches(runs: Runs) -> None:
    plan = FloorPlan(
        3.0, 3.0, places=[PersonPlace("bed", (1.5, 1.5), width=1.0, length=2.0, low=0.3, high=0.8)]
    )
    people = people_of(runs, None, plan, PIECES, ([], [False]))
    (place,) = people.places
    shares = [chance.estimate for chance in (place.crushed, place.hit, place.touched)]
    assert shares == [0.4, pytest.approx(0.6), 1.0]
    assert [people.crushed.chance, people.hit.chance] == [place.crushed, place.hit]
    by = [(hit.piece, hit.by_falling, hit.probability.estimate, hit.energy.median) for hit in place.by]
    assert by == [
        ("bookcase", True, 0.4, 1400.0),
        ("lamp", True, 0.2, pytest.approx(0.9 * CRUSHING_ENERGY)),
        ("fridge", False, 1.0, 25.0),
    ]
    falls = {
        name: outcomes.overturned.mean() for (name, _), outcomes in zip(PIECES, runs.of_bodies(), strict=True)
    }
    assert all(hit.probability.estimate <= falls[hit.piece] for hit in place.by if hit.by_falling)
    assert people.harm < 0.6 * 1400.0  # the nudge does none


PERSONS = {"en": ("omebody", "hit", "touch", "Harm", "beds"), "ja": ("人に", "人の", "ベッド")}


def test_a_room_without_persons_says_nothing_of_them():
    furniture = [{"preset": "bookcase", "against": "left_wall", "along": 1.0}]
    scenario = {
        "plan": {"width": 3.0, "length": 2.5},
        "doors": [{"wall": "right_wall", "start": 0.3, "width": 0.8}],
        "furniture": furniture,
        "shaking": {"sine": {"amplitude": 3.0, "frequency": 1.0, "duration": 3.0}},
        "uncertainty": {"samples": 3},
    }
    verdict = sp.verify(sp.Scenario.parse(scenario), progress=False)
    for language, words in PERSONS.items():
        texts = verdict.sentence(language), verdict.to_markdown(language), room_html(verdict, language)
        visible = [*texts[:2], " ".join(Page(texts[2]).words.split())]
        assert not [word for word in words if any(word in text for text in visible)]
    assert "hit_with" not in verdict.to_csv()


def test_what_happens_in_a_run_is_seen_of_its_pieces_as_they_turned(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a body whose principal axes are not those of its frame too."""
    tracks, tracks_of = list[Track](), groups.tracks_of

    def noted(*of_run: Any) -> list[Track]:
        tracks.extend(tracks_of(*of_run))
        return tracks

    monkeypatch.setattr(groups, "tracks_of", noted)
    own = np.array([[6.0, 1.5, 0.0], [1.5, 5.0, 0.0], [0.0, 0.0, 5.0]])
    box = sp.Body.box(0.4, 0.6, 1.2, 50.0, inertia=own)
    scene = sp.Scene([sp.Piece(box, (1.0, 1.0, 0.0))], plan=sp.FloorPlan(2.0, 2.0))
    run = sp.simulate(scene, sp.synthetic_suite(count=1)[0].to_intensity("7"))
    happens_in(run)
    (track,) = tracks
    assert len(track.sample) > 10
    np.testing.assert_array_equal(track.turn, run.turn[0][track.sample])
