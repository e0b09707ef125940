"""Names on the plan of a room: where they stand, and how they are wrapped."""

import re

import pytest

from stayput.report.room.sheet import LONGEST, PlanLabel, names_svg, overlap, places_of_names, wrapped


def test_names_do_not_overlap_where_there_is_room():
    labels = [PlanLabel(("wardrobe",), "overturns: 3 %", (100.0, 100.0, 130.0, 200.0)) for _ in range(3)]
    boxes = places_of_names(labels, [], (0.0, 0.0, 460.0, 460.0))
    assert not overlap(boxes)
    texts = names_svg(labels, boxes)
    places = {
        (float(x), float(y)) for x, y in re.findall(r'<text x="([\d.]+)" y="([\d.]+)" class="name', texts)
    }
    assert len(places) == 3
    found = sorted(places)
    for n, (x, y) in enumerate(found):
        assert all(abs(y - v) >= 30.0 or abs(x - u) >= 80.0 for u, v in found[n + 1 :])


@pytest.mark.parametrize(
    ("name", "lines"),
    [
        ("desk", ("desk",)),
        ("second bookcase by the wall", ("second bookcase by", "the wall")),
        ("本" * 40, ("本" * 10 + "…",)),
        ("a " * 60, ("a a a a a a a a a a", "a a a a a a a a a…")),
    ],
)
def test_long_names_are_wrapped_and_cut(name, lines):
    found = wrapped(name)
    assert len(found) == len(lines)
    assert found[0] == lines[0]
    assert all(len(line) <= LONGEST / 0.5 for line in found)
