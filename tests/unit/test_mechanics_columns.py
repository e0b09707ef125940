"""Integer codes of the solver agree with the public enumerations, whose order they follow."""

import stayput as sp
from stayput.mechanics import columns as col


def test_modes_are_in_the_public_order():
    codes = (
        col.REST_MODE,
        col.SLIDE_MODE,
        col.ROCK_MODE,
        col.SLIDE_ROCK_MODE,
        col.FLIGHT_MODE,
        col.LEAN_MODE,
        col.OVERTURNED_MODE,
    )
    names = ["rest", "slide", "rock", "slide-rock", "flight", "lean", "overturned"]
    assert [list(sp.Mode)[code].value for code in codes] == names


def test_event_kinds_are_in_the_public_order():
    for kind in sp.EventKind:
        name = "LIFT_OFF" if kind is sp.EventKind.LIFT_OFF else kind.name
        assert list(sp.EventKind)[getattr(col, f"{name}_EVENT")] is kind


def test_outcomes_are_in_the_public_order():
    codes = {
        sp.Outcome.RESTED: col.RESTED,
        sp.Outcome.SLID: col.SLID,
        sp.Outcome.ROCKED: col.ROCKED,
        sp.Outcome.LEANING: col.LEANING,
        sp.Outcome.OVERTURNED: col.OVERTURNED_OUTCOME,
        sp.Outcome.FAILED: col.FAILED_OUTCOME,
    }
    # a single body in the plane cannot fall off another
    numbers = {outcome: list(sp.Outcome).index(outcome) for outcome in sp.Outcome}
    assert numbers == codes | {sp.Outcome.FELL_OFF: len(codes)}


def test_each_contact_has_a_corner_and_a_plane():
    assert len(col.CORNER) == len(col.PLANE) == col.CONTACTS
    floor = sum(1 << c for c in range(col.CONTACTS) if col.PLANE[c] == 0)
    assert floor == col.FLOOR_BITS
    assert len(set(zip(col.CORNER, col.PLANE, strict=True))) == col.CONTACTS
