"""A run in words, as a record and as a dataset."""

import dataclasses
import json
import math

import numpy as np
import pytest
from report_runs import changed, falling, rocking
from space_runs import spinning

import stayput as sp
from stayput.errors import InputError
from stayput.model.room import Room
from stayput.report.animation import film_of
from stayput.report.summary import outcome_named, rows, sentence, sentences, summary
from stayput.simulation.outcome import EventKind, Outcome


@pytest.mark.parametrize(
    ("run", "said"),
    [
        (falling(), "“crate” overturned to the right 2.5 s into the motion after hitting the wall once."),
        (falling(-1.0), "“crate” overturned to the left 2.5 s into the motion after hitting the wall once."),
        (rocking(), "“crate” rocked by up to 2.9° and slid by up to 2.0 cm, and stayed upright."),
        (changed(rocking(), outcome=Outcome.RESTED), "“crate” stayed put: it neither slid nor rocked."),
    ],
)
def test_the_sentence(run, said):
    assert sentence(run.named(["crate"])) == said


def test_names_of_ones_own_are_quoted_and_others_have_an_article():
    for name, said in (("bookcase", "The bookcase "), ("bookcase 2", "Bookcase 2 "), ("piece", "The piece ")):
        assert sentence(rocking().named([name])).startswith(said)
    assert sentences(rocking().named(["本棚 A"]))[1].startswith("「本棚 A」は")


def test_the_peak_is_that_of_what_acted():
    """In the plane that along the depth, in the table as in the film."""
    motion = sp.Motion(dt=0.01, x=np.full(401, 3.0), y=np.full(401, 4.0))
    for run, said in ((rocking(), "along the depth 3.00"), (spinning(), "of all components 5.00")):
        shaken = dataclasses.replace(run, motion=motion)
        assert f"peak {said} m/s²" in rows(shaken)[0][1]
        assert f"peak {said} m/s²" in film_of(shaken, "en").strip_title


def test_a_run_shows_itself_with_the_names_of_several_pieces():
    run = spinning().named(["cupboard", "drum", "vase"])
    assert "cupboard: " in repr(run)
    assert repr(run["drum"]).startswith(f"PieceRun({run['drum'].outcome.value}")
    assert repr(run["drum"])[len("PieceRun(") : -1] in repr(run)
    assert "crate" not in repr(rocking().named(["crate"]))


# in the plane nothing falls off another body, or rolls
@pytest.mark.parametrize("outcome", sorted(set(Outcome) - {Outcome.FELL_OFF, Outcome.ROLLED}))
def test_every_outcome_has_a_sentence_and_a_record(outcome):
    run = changed(falling(), outcome=outcome)
    assert sentence(run).endswith(".")
    assert outcome_named(outcome, "ja")
    assert json.loads(json.dumps(summary(run), allow_nan=False))["outcome"] == outcome.value


def test_the_record_has_units_and_null_for_a_time_that_is_not():
    record = summary(rocking())
    assert record["pieces"][0]["overturn_time_s"] is None
    assert record["pieces"][0]["peak_tilt_rad"] == pytest.approx(0.05, rel=1e-3)
    assert summary(falling())["events"][1] == {
        "time_s": 1.2, "kind": "wall impact", "mode": "rest", "tilt_rad": 0.0, "tilt_rate_rad_s": 0.0,
        "slide_m": 0.0, "slide_rate_m_s": 0.0,
    }  # fmt: skip


@pytest.mark.parametrize("run", [rocking(), falling(), falling(-1.0)])
def test_a_run_ends_with_its_last_sample_event_or_overturning(run):
    record = summary(run)
    fell = record["pieces"][0]["overturn_time_s"] or 0.0
    times = [fell, run.time[-1], *(event["time_s"] for event in record["events"])]
    assert record["end_time_s"] == max(times)


def test_a_ceiling_hit_is_not_a_wall_hit():
    hit = dataclasses.replace(falling().events[1], kind=EventKind.CEILING_IMPACT)
    run = dataclasses.replace(rocking(), events=(hit, hit))
    assert "after hitting the ceiling twice" in sentence(run)


def test_wall_impacts_count_the_ceiling_and_say_so():
    hits = [
        dataclasses.replace(falling().events[1], kind=k)
        for k in (EventKind.WALL_IMPACT, EventKind.CEILING_IMPACT)
    ]
    run = dataclasses.replace(changed(rocking(), wall_impacts=2), events=tuple(hits))
    assert ("Wall and ceiling impacts", "2") in rows(run)
    assert summary(run)["pieces"][0]["wall_impacts"] == run.to_dataset().wall_impacts.item() == 2
    assert ("Wall impacts", "2") in rows(dataclasses.replace(run, room=Room()))


def test_the_dataset_has_every_history_and_event_with_its_unit():
    run = falling()
    data = run.to_dataset()
    for name, unit in {"slide": "m", "tilt": "rad"}.items():
        assert np.array_equal(data[name][0], getattr(run, name))
        assert data[name].attrs["units"] == unit
        assert data[name].dims == ("piece", "time")
    for name in ("place", "velocity", "attitude", "rotation_rate"):
        assert np.array_equal(data[name], getattr(run, name))
    assert data.time.attrs["units"] == "s"
    assert data.event_kind.values.tolist() == ["slip", "wall impact", "overturned"]
    assert data.event_time[2] == run.overturn_time
    assert data.peak_tilt.item() == run.peak_tilt
    assert data.outcome.values.tolist() == ["overturned"]
    assert rocking().to_dataset().sizes["event"] == 0
    assert math.isnan(rocking().to_dataset().overturn_time.item())


@pytest.mark.parametrize(
    ("ask", "told"),
    [
        (lambda run: run.named(["a", "b"]), "2 names for 3 pieces"),
        (lambda run: run.named("abc"), "must be a list"),
        (lambda run: run["piece 4"], "no piece 'piece 4' in the run; its pieces are piece 1, piece 2"),
        (lambda run: run.peak_tilt, "several pieces"),
        (lambda run: run[0].body, "is a solid"),
    ],
)
def test_what_a_run_does_not_know_is_refused(ask, told):
    with pytest.raises(InputError, match=told):
        ask(spinning())


def test_a_run_has_the_same_fields_whichever_engine_followed_it():
    for run, shape in ((rocking(), (1, 401)), (spinning(), (3, 201))):
        assert run.place.shape == run.velocity.shape == run.rotation_rate.shape == (*shape, 3)
        assert run.attitude.shape == (*shape, 4)
        assert all(one.tilt.shape == one.slide.shape == one.yaw.shape == shape[1:] for one in run.pieces)
        assert all(one.slide_in_plan.shape == (*shape[1:], 2) for one in run.pieces)
        assert run[run.names[-1]] is run.pieces[-1] is run[-1]
    assert (rocking().engine, spinning().engine) == ("plane", "space")
