"""Integer codes of the solver agree with the public enumerations, whose order they follow."""

import pytest

import stayput as sp
from stayput.mechanics import columns as col


@pytest.mark.parametrize(
    ("public", "ending"), [(sp.Mode, "_MODE"), (sp.EventKind, "_EVENT"), (sp.Outcome, "_OUTCOME")]
)
def test_codes_are_in_the_public_order(public, ending):
    for place, kind in enumerate(public):
        if kind not in (sp.Outcome.FELL_OFF, sp.Outcome.ROLLED):  # in space alone
            name = f"{kind.name}{ending}"
            assert getattr(col, name if hasattr(col, name) else kind.name) == place


def test_each_contact_has_a_corner_and_a_plane():
    assert len(col.CORNER) == len(col.PLANE) == col.CONTACTS
    floor = sum(1 << c for c in range(col.CONTACTS) if col.PLANE[c] == 0)
    assert floor == col.FLOOR_BITS
    assert len(set(zip(col.CORNER, col.PLANE, strict=True))) == col.CONTACTS
