"""The bits of an ensemble: whatever its threads, its chunks and the order of its cases."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

import stayput as sp

COUNT = 60
MOTIONS = [
    sp.near_fault().trimmed(5.0, 12.0),
    sp.sine(5.0, 1.3, 4.0),
    sp.pulse("half-sine", 6.0, 0.4, quiet=4.0),
]


CASE = sp.Case(sp.Body(1.0, 1.0, 100.0), sp.Room(), MOTIONS[0])

ROW = st.fixed_dictionaries(
    {
        "body.width": st.floats(0.2, 0.6),
        "body.height": st.floats(0.5, 2.0),
        "room.floor.static_friction": st.floats(0.1, 0.9),
        "part": st.floats(0.5, 1.0),  # kinetic as a part of static friction
        "room.right_wall.gap": st.floats(0.0, 0.3),
        "motion": st.sampled_from(MOTIONS),
        "motion.scale": st.floats(0.3, 1.5),
        "contact": st.sampled_from(["coulomb", "paper"]),
    }
)


@st.composite
def columns(draw: st.DrawFn) -> dict[str, list[object]]:
    """Draw the columns of an ensemble, a list for each."""
    rows = draw(st.lists(ROW, min_size=20, max_size=COUNT))
    table = {name: [row[name] for row in rows] for name in rows[0]}
    static, part = table["room.floor.static_friction"], table.pop("part")
    return table | {"room.floor.kinetic_friction": [s * p for s, p in zip(static, part, strict=True)]}


def bits(results: dict[str, np.ndarray]) -> dict[str, bytes]:
    return {name: values.tobytes() for name, values in results.items()}


@given(asked=columns(), threads=st.integers(1, 4), chunk=st.integers(1, 70))
def test_threads_and_chunks_change_no_bit(asked: dict[str, list[object]], threads: int, chunk: int) -> None:
    assert bits(sp.simulate_many(CASE, asked, threads=threads, chunk=chunk)) == bits(
        sp.simulate_many(CASE, asked, threads=1, chunk=1000)
    )


@given(asked=columns(), data=st.data())
def test_the_order_of_the_cases_changes_no_bit(asked: dict[str, list[object]], data: st.DataObject) -> None:
    order = np.array(data.draw(st.permutations(range(len(asked["motion"])))))
    mixed = {name: [values[n] for n in order] for name, values in asked.items()}
    found = sp.simulate_many(CASE, asked, chunk=7)
    again = sp.simulate_many(CASE, mixed, chunk=7)
    assert bits({name: values[order] for name, values in found.items()}) == bits(again)
