"""Contents: what is refused, which items there are, doors, drawers, bounds of what they do to the piece."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import stayput as sp
from stayput.contents.contents import emptied, opened
from stayput.contents.spill import items_of, uncovered
from stayput.errors import InputError
from stayput.scenario import Scenario

BODY = sp.Body(0.4, 1.8, 100.0)
CASE = sp.Case(BODY, sp.Room(left_wall=sp.Wall(0.02)), sp.near_fault().to_intensity(6.5))
HELD = replace(CASE, measures=(sp.MEASURES["l_bracket"](),))


CONTRADICTIONS = [
    ({"loads": (20.0, 10.0), "shelves": 5}, "loads has 2 values; it must have 5"),
    ({"loads": (20.0, 10.0), "mass_share": 0.5}, "mass_share is given beside loads of the shelves"),
    ({"catch": 30.0}, "catch is given without hinged doors or drawers with catches"),
    ({"catch": 30.0, "doors": "sliding"}, "catch is given without hinged doors"),
    ({"catch": 30.0, "drawers": "stops"}, "catch is given without hinged doors"),
    ({"leaf": 0.5, "doors": "hinged"}, "leaf is given without doors that are 'sliding'"),
    ({"door_mass": 8.0}, "door_mass is given without doors that are 'hinged'"),
    ({"lip": 0.02, "drawers": "stops"}, "lip is given for contents in drawers"),
    ({"setback": 0.02, "drawers": "free"}, "setback is given for contents in drawers"),
    ({"height": 0.2, "drawers": "free"}, "height is given for contents in drawers"),
]
"""What contradicts itself, and what the refusal names."""


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"kind": "book"}, "did you mean 'books'"),
        ({"doors": "glass"}, "Doors is 'glass'"),
        ({"doors": "hinged", "drawers": "free"}, "drawers is given beside doors"),
        ({"loads": ()}, "is empty"),
        ({"loads": (10.0, -1.0)}, "load of a shelf is -1"),
        ({"lip": -0.1}, "lip height is -0.1"),
        ({"shelves": 0}, "number of shelves is 0"),
        ({"static_friction": 0.1}, "must be between 0 and 0.1"),
        ({"shelves": 2.5}, "must be a whole number"),
    ],
)
def test_what_cannot_be_is_refused(given, message):
    with pytest.raises(InputError, match=message):
        sp.Contents(**given)


@pytest.mark.parametrize(("given", "message"), CONTRADICTIONS)
def test_contradictions_of_a_scenario_are_refused_alike(given, message):
    table = {key: list(value) if isinstance(value, tuple) else value for key, value in given.items()}
    with pytest.raises(InputError, match=f"contents.*{message}") as refused:
        Scenario.parse({"furniture": {"preset": "bookcase"}, "contents": table})
    assert refused.value.told("ja").isascii() is False


def test_what_agrees_is_not_refused():
    assert sp.Contents(loads=(20.0, 10.0), shelves=2).levels == 2
    assert sp.Contents().levels == 5
    assert sp.Contents(doors="hinged", catch=50.0, door_mass=8.0, lip=0.02).holding_force == 50.0
    assert sp.Contents(drawers="catches", catch=50.0).holding_force == 50.0
    assert sp.Contents(doors="sliding", leaf=0.6, door_mass=8.0).leaf == 0.6


def test_what_is_not_given_is_of_the_kind():
    contents = sp.Contents("dishes", width=0.25)
    assert contents.of_kind.width == 0.25
    assert contents.of_kind.height == sp.CONTENTS["dishes"].height
    assert contents.friction == (0.25, 0.20)
    assert sp.Contents("dishes", drawers="free").friction == (0.10, 0.08)


def test_loads_are_the_shelves():
    contents = sp.Contents(loads=(20.0, 10.0, 5.0))
    assert contents.levels == 3
    assert contents.masses(BODY) == (20.0, 10.0, 5.0)
    with pytest.raises(InputError, match="100 kg"):
        sp.Contents(loads=(60.0, 50.0)).masses(BODY)


def test_the_same_items_for_every_piece_and_motion():
    first, second = (items_of(sp.Contents("books"), BODY, 9.81) for _ in range(2))
    assert first.cases.tobytes() == second.cases.tobytes()
    assert first.cases.shape == (5, 8)
    friction = first.cases["static_friction"]
    assert len(np.unique(friction)) == friction.size
    assert np.median(friction) == pytest.approx(0.35, rel=0.1)


def test_a_lip_meets_the_items_as_high_as_it_is():
    items = items_of(sp.Contents("bottles", lip=0.05, shelves=4), BODY, 9.81)
    base, top = items.cases["v"][..., 0], items.cases["v"][..., 3]
    assert top - base == pytest.approx(0.05)


def test_two_sliding_doors_uncover_half_at_most():
    assert uncovered(0.0, 0.4) == 0.0
    assert uncovered(0.1, 0.4) == 0.125
    assert uncovered(2.0, 0.4) == 0.5


def test_the_bits_are_those_of_the_run_and_of_its_case():
    by_case, by_run = sp.spill(HELD, sp.Contents("dishes")), sp.spill(HELD.run(), sp.Contents("dishes"))
    for name in ("out", "toppled", "time", "speed"):
        assert getattr(by_case, name).tobytes() == getattr(by_run, name).tobytes()


def test_a_catch_that_holds_more_opens_later():
    times = [sp.spill(HELD, sp.Contents("dishes", doors="hinged", catch=f)).open_from[0] for f in (0, 20, 60)]
    assert times == sorted(times)
    assert times[0] < times[-1]
    assert np.isinf(sp.spill(HELD, sp.Contents("dishes", doors="hinged, latched")).open_from).all()


def test_drawers_come_out_where_no_stop_holds_them():
    free, stopped = (sp.spill(HELD, sp.Contents("boxes", drawers=kind)) for kind in ("free", "stops"))
    assert free.share_out > 0.9
    assert stopped.share_out == 0.0


def test_items_in_the_middle_come_out_to_either_side():
    open_rack = sp.spill(HELD, sp.Contents("dishes", back=False))
    assert open_rack.share_out > sp.spill(HELD, sp.Contents("dishes")).share_out


def test_an_emptied_piece_is_the_piece_without_its_loads():
    loads = [30.0, 20.0, 10.0]
    carcass = sp.Body(0.4, 1.8, 40.0)
    full = sp.Body.bookcase(0.4, 1.8, 40.0, loads)
    left = emptied(full, sp.Contents(loads=tuple(loads)))
    assert left.mass == pytest.approx(carcass.mass)
    assert left.centre_of_gravity == pytest.approx(carcass.centre_of_gravity)
    assert left.inertia_about_cg == pytest.approx(carcass.inertia_about_cg)


def test_an_opened_piece_is_that_of_its_parts():
    contents = sp.Contents("boxes", loads=(30.0, 20.0), drawers="stops")
    full = sp.Body.bookcase(0.4, 1.8, 40.0, [30.0, 20.0])
    parts = [sp.Part(40.0, 0.0, 0.9, 0.4, 1.8)]
    parts += [sp.Part(mass, 0.1, 0.45 + 0.9 * i, 0.4, 0.9) for i, mass in enumerate((30.0, 20.0))]
    expected, found = sp.Body.from_parts(0.4, 1.8, parts), opened(full, contents, 0.1)
    assert found.cg_offset == pytest.approx(expected.cg_offset)
    assert found.inertia_about_cg == pytest.approx(expected.inertia_about_cg)
    with pytest.raises(InputError):
        opened(full, contents, 0.5)


def test_the_papers_law_is_refused():
    with pytest.raises(InputError, match="must be 'coulomb' where contents are followed"):
        sp.spill(replace(CASE, contact="paper"), sp.Contents())


def test_what_cannot_be_followed_in_space_is_refused():
    still, drum = sp.sine(1.0, 1.0, 1.0), sp.Body.cylinder(0.4, 1.8, 100.0)
    body = replace(BODY, length=0.9)
    both = sp.Scene([sp.Piece(body), sp.Piece(drum, at=(2.0, 0.0, 0.0))])
    run = sp.simulate(both, still.resampled(0.0025))
    assert sp.spill(run, sp.Contents(), 0).share_out == 0.0
    for piece, message in ((None, "piece is None"), (2, "between 0 and 1"), (1, "shape of its own")):
        with pytest.raises(InputError, match=message):
            sp.spill(run, sp.Contents(), piece)
    with pytest.raises(InputError, match="between 0 and 0"):
        sp.spill(CASE, sp.Contents(), 1)
    with pytest.raises(InputError, match=r"0\.005 s apart"):
        sp.spill(sp.simulate(body, sp.Room(), still, dimensions=3), sp.Contents())


def test_a_run_in_space_has_the_gravity_that_it_was_made_with():
    """On the moon dishes slide where they stay on the earth."""
    body, motion = replace(BODY, length=0.9), sp.sine(1.0, 1.0, 2.0, dt=0.0025)
    shares = [
        sp.spill(
            sp.simulate(body, sp.Room(sp.Floor(3.0, 3.0)), motion, dimensions=3, gravity=g),
            sp.Contents("boxes", drawers="free"),
        ).share_out
        for g in (9.81, 3.0)
    ]
    assert shares[0] == 0.0 < shares[1]


def test_a_scenario_takes_the_loads_of_the_furniture():
    data = {"furniture": {"preset": "bookcase", "shelves": [50.0, 40.0]}, "contents": {"kind": "books"}}
    scenario = Scenario.parse(data)
    assert scenario.contents is not None
    assert scenario.contents.loads == (50.0, 40.0)
    equal = Scenario.parse({**data, "contents": {"shelves": 4, "mass_share": 0.5}})
    assert equal.contents is not None
    assert (equal.contents.loads, equal.contents.levels) == (None, 4)
    assert Scenario.parse({"furniture": {"preset": "chest"}}).contents is None
    with pytest.raises(InputError, match="300 kg"):
        Scenario.parse({"furniture": {"preset": "bookcase"}, "contents": {"loads": [300.0]}})
