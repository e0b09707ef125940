"""A run of very many events: few are listed, all are counted, and memory stays small."""

from __future__ import annotations

import tracemalloc
from collections import Counter

import pytest
from serving import SCENE

import stayput as sp
from stayput.app.running import MOST_EVENTS, simulated
from stayput.scenario import Scenario

MANY = {
    "furniture": {"width": 0.4, "height": 1.8, "mass": 100.0},
    "room": {
        "floor": {"static_friction": 0.9, "kinetic_friction": 0.9, "restitution": 1.0},
        "left_wall": {"gap": 1e-5, "restitution": 1.0},
        "right_wall": {"gap": 1e-5, "restitution": 1.0},
    },
    "shaking": {"sine": {"amplitude": 3.0, "frequency": 8.0, "duration": 600.0}},
}


def test_the_reply_lists_some_and_says_how_many_there_were() -> None:
    simulated(Scenario.parse(SCENE))  # what is loaded once does not count
    tracemalloc.start()
    try:
        reply = simulated(Scenario.parse(MANY)).without
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert reply.events_total > 50_000
    assert reply.events_cut
    assert len(reply.events) == MOST_EVENTS
    assert f"{reply.pieces[0].wall_impacts} times" in reply.sentence.en
    room_for_events = 56e6  # its pages are taken from the system as they are written to
    assert peak < 60e6 + room_for_events
    few = simulated(Scenario.parse(SCENE)).without
    assert not few.events_cut
    assert few.events_total == len(few.events)


def test_a_cut_list_has_the_first_events_and_the_last_and_counts_the_others() -> None:
    body = sp.Body(width=0.3, height=1.8, mass=200.0)
    room = sp.Room(floor=sp.Floor(restitution=0.9), left_wall=sp.Wall(gap=0.01))
    motion = sp.sine(amplitude=6.0, frequency=0.8, duration=20.0)
    whole = sp.simulate(body, room, motion)
    assert whole.overturned
    cut = sp.simulate(body, room, motion, most_events=5)
    assert len(whole.events) > 5
    assert cut.events == (*whole.events[:4], whole.events[-1])
    assert cut.events_total == whole.events_total == len(whole.events)
    counts = Counter(event.kind for event in whole.events)
    assert all(cut.count(kind) == whole.count(kind) == counts[kind] for kind in sp.EventKind)
    assert not whole.unlisted
    one_less = sp.simulate(body, room, motion, most_events=len(whole.events) - 1)
    assert sum(one_less.unlisted.values()) == 1


@pytest.mark.parametrize("most", [1, 0, -1])
def test_at_least_two_are_listed(most: int) -> None:
    with pytest.raises(sp.InputError, match="most_events"):
        sp.simulate(sp.Body(0.3, 1.8, 200.0), sp.Room(), sp.sine(1.0, 1.0, 2.0), most_events=most)
