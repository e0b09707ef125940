"""The plane beside space: what the study says of free and of held pieces holds on fewer motions too."""

from dataclasses import replace

import numpy as np
import pytest

from stayput import Suite
from studies.three_dimensions import (
    DEVICES,
    ENGINES,
    FREE,
    HOLDS,
    LEVELS,
    PIECES,
    PLANE,
    SPACE,
    STRONGEST,
    Comparison,
    beside,
    outcomes,
    suite_of,
    three_dimensions,
)


@pytest.fixture(scope="module")
def study():
    return three_dimensions(2, headings=[60.0])


def compared(study, hold, piece=None):
    of_hold = study.data.sel(hold=hold, level=STRONGEST)
    return Comparison.of(of_hold if piece is None else of_hold.sel(piece=piece))


def test_under_one_component_along_the_depth_the_engines_agree_of_free_boxes():
    along = Suite(tuple(replace(motion, y=None) for motion in suite_of(4)), "along the depth")
    plane, space = (
        {name: values[: len(FREE)] for name, values in of_engine.items()}
        for of_engine in (outcomes("square cabinet", along, one, 0.0, LEVELS[STRONGEST]) for one in ENGINES)
    )
    assert plane["overturned"].any()
    assert (plane["overturned"] != space["overturned"]).mean() <= 1 / 16
    stand = ~(plane["overturned"] | space["overturned"])
    assert np.median(np.abs(plane["slide"] - space["slide"])[stand]) < 1e-3


def test_both_engines_meet_the_same_friction():
    # a motion too weak to tilt a low chest only slides it, along its depth alone: as far by both engines
    along = Suite(tuple(replace(motion, y=None, z=None) for motion in suite_of(2)), "along the depth")
    plane, space = (outcomes("low chest", along, engine, 0.0, 6.25)["slide"][0] for engine in ENGINES)
    assert plane.min() > 1e-3
    assert space == pytest.approx(plane, rel=0.02)
    assert len(set(plane.round(6))) == len(plane)


def test_the_plane_does_not_know_the_length(study):
    plane = study.data.sel(engine=PLANE, hold=list(FREE))
    for name in ("overturned", "slide"):
        short, long = (plane[name].sel(piece=f"{length} cabinet") for length in ("short", "long"))
        assert (short == long).all()


def test_what_is_shorter_than_deep_falls_over_its_length(study):
    for hold in FREE:
        assert compared(study, hold, "short cabinet").less.estimate < -0.2
    long = compared(study, "free", "long cabinet")
    assert long.less.estimate > compared(study, "free", "short cabinet").less.estimate


def test_under_both_components_pieces_slide_farther_and_brackets_bear_more(study):
    for hold in ("free", "wall alone", "L-brackets", "belts"):
        one = compared(study, hold)
        assert one.median[1] > 1.5 * one.median[0]
    brackets = compared(study, "L-brackets")
    assert brackets.used[1] > 1.5 * brackets.used[0]
    assert compared(study, "belts").used[1] > compared(study, "belts").used[0]
    for hold in DEVICES:
        one = compared(study, hold)
        assert one.failed[1] >= one.failed[0]


def test_brackets_hold_in_both(study):
    assert max(compared(study, "L-brackets").overturned) < 5.0


def test_tables_and_key_numbers_are_of_the_same_runs(study):
    tables, quantities = [*study.tables.values()], study.quantities
    assert [len(table) for table in tables] == [24, 12, 36, 8]
    assert quantities["given_up"].value == 0
    assert quantities["cases"].value == len(PIECES) * len(LEVELS) * len(HOLDS) * 4
    (row,) = tables[1][(tables[1]["hold"] == "L-brackets") & (tables[1]["level"] == STRONGEST)].to_dict(
        "records"
    )
    assert row["plane − space"] == quantities["brackets_less"].value
    assert row["one fails [%]"] == quantities["brackets_fail"].value
    assert row["median utilisation"] == quantities["brackets_used"].value
    bare = tables[1][~tables[1]["hold"].isin(DEVICES)]
    assert (bare["median utilisation"] == "").all()
    strongest = study.data.sel(level=STRONGEST, hold="free", piece="bookcase")
    shares = 100.0 * strongest["overturned"].mean(("heading", "motion"))
    (row,) = (
        tables[0]
        .query(f"piece == 'bookcase' and hold == 'free' and level == '{STRONGEST}'")
        .to_dict("records")
    )
    assert row["overturned [%]"] == beside((float(shares.sel(engine=PLANE)), float(shares.sel(engine=SPACE))))
    assert row["plane − space"] == quantities["bookcase_flooring"].value


def test_what_fails_is_used_up(study):
    failed = study.data["failed"]
    assert failed.any()
    assert (study.data["used"].where(failed, 1.0) >= 1.0).all()
    assert not failed.sel(hold=[hold for hold in HOLDS if hold not in DEVICES]).any()
