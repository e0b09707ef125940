"""Edges between standing and falling: against runs on both sides, and against edges that are known."""

import numpy as np
import pytest

import stayput as sp
from stayput.simulation import boundary
from stayput.simulation.boundary import (
    bisected,
    hidden_crossings,
    overturning_map,
    sampled_crossings,
    trace_boundary,
)

SCALE = "motion.scale"
WAVE = sp.sine(9.81, 2.0, 0.5, quiet=10.0, dt=2.5e-3)
CASE = sp.Case(sp.Body(0.4, 1.8, 100.0), sp.Room(sp.Floor(3.0, 3.0)), WAVE, gravity=9.81)
ISLAND = [0.4548, 1.2946, 1.3676]


def falls(case, scale, **body):
    """Whether one run falls."""
    shape = {"width": case.body.width, "height": case.body.height, "mass": case.body.mass} | body
    run = sp.simulate(sp.Body(**shape), case.room, case.motion.scaled(scale), gravity=case.gravity)
    return run.overturned


def check_edges(point, fallen):
    """The edges of one point are in order, alternate, and separate what falls from what stands."""
    there = point["direction"].values != 0
    assert np.all(np.diff(there.astype(int)) <= 0)
    amplitude, direction = point["amplitude"].values[there], point["direction"].values[there]
    assert np.isnan(point["amplitude"].values[~there]).all()
    assert np.all(np.diff(amplitude) > 0)
    assert np.all(direction[1:] == -direction[:-1])
    if len(direction):
        assert bool(point["falls_at_lowest"]) is bool(direction[0] < 0)
        assert bool(point["falls_at_highest"]) is bool(direction[-1] > 0)
    assert int(point["islands"]) == max(0, (direction < 0).sum() - (not point["falls_at_highest"]))
    for low, up, way in zip(
        point["lower"].values[there], point["upper"].values[there], direction, strict=True
    ):
        assert up - low <= point.attrs["tolerance"] * up
        assert fallen(low) is bool(way < 0)
        assert fallen(up) is bool(way > 0)


@pytest.mark.parametrize(
    "amplitudes",
    [np.arange(0.2, 1.81, 0.05), [0.0, 0.6, 1.31, 2.0], [0.5, 1.2, 1.5], [0.5, 1.0, 1.3]],
    ids=["fine", "one sample in the island", "none in the island", "ends in the island"],
)
def test_edges_separate_runs(amplitudes):
    point = trace_boundary(CASE, amplitudes)
    check_edges(point, lambda scale: falls(CASE, scale))
    inside = [edge for edge in ISLAND if amplitudes[0] < edge < amplitudes[-1]]
    assert point["amplitude"].values == pytest.approx(inside, rel=2e-4)


def test_edges_separate_runs_under_a_record():
    record = sp.near_fault().component("x")
    case = sp.Case(CASE.body, CASE.room, record)
    widths, heights = [0.2, 0.5], [1.0, 2.5]
    data = trace_boundary(
        case, np.geomspace(0.1, 3.0, 60), {("body.width", "body.height"): (widths, heights)}
    )
    assert data["islands"].values.max() >= 1
    for place, (width, height) in enumerate(zip(widths, heights, strict=True)):
        point = data.isel({"body.width": place})
        check_edges(point, lambda scale, b=width, h=height: falls(case, scale, width=b, height=h))


def test_an_island_that_no_sample_meets():
    """The landings before the fall change from one to none, so there must be an island."""
    amplitudes = [0.3, 0.5, 1.25, 1.45, 2.0]
    mapped, traced = overturning_map(CASE, amplitudes), trace_boundary(CASE, amplitudes)
    assert mapped["overturned"].values.tolist() == [False, True, True, True, True]
    assert int(mapped["islands"]) == 0
    assert int(traced["islands"]) == 1
    assert traced["amplitude"].values == pytest.approx(ISLAND, rel=2e-4)
    assert traced["floor_impacts"].values.tolist() == [1, 1, 0]
    last = trace_boundary(CASE, amplitudes, edge="last")
    assert float(last["amplitude"]) == pytest.approx(ISLAND[2], rel=2e-4)


def test_which_edge():
    amplitudes = np.arange(0.2, 1.81, 0.05)
    axes = {"body.width": [0.35, 0.4], "body.height": [1.5, 1.8]}
    every = trace_boundary(CASE, amplitudes, axes)
    assert every["amplitude"].dims == ("body.width", "body.height", "edge")
    assert every["edge"].values.tolist() == [1, 2, 3]
    for edge, number in (("first", 1), ("last", 3)):
        one = trace_boundary(CASE, amplitudes, axes, edge=edge)
        assert one["amplitude"].dims == ("body.width", "body.height")
        assert np.array_equal(one["amplitude"], every["amplitude"].sel(edge=number))
        assert np.array_equal(one["islands"], every["islands"])
        assert one.attrs["edge"] == edge
    assert every.attrs["largest_step"] == pytest.approx(0.05)
    assert "narrower than a step" in every.attrs["resolution"]


@pytest.mark.parametrize(
    ("amplitudes", "first", "last", "at_lowest", "at_highest", "islands"),
    [
        ([0.1, 0.2], None, None, False, False, 0),
        ([0.6, 0.8], None, None, True, True, 0),
        ([0.3, 0.6, 1.33], ISLAND[0], None, False, False, 0),
        ([0.6, 1.33, 1.5], None, ISLAND[2], True, True, 1),
    ],
)
def test_edges_outside_the_amplitudes_are_not_made_up(
    amplitudes, first, last, at_lowest, at_highest, islands
):
    for edge, expected in (("first", first), ("last", last)):
        found = trace_boundary(CASE, amplitudes, edge=edge)
        assert bool(found["falls_at_lowest"]) is at_lowest
        assert bool(found["falls_at_highest"]) is at_highest
        assert int(found["islands"]) == islands
        if expected is None:
            assert np.isnan(found["amplitude"])
            assert (int(found["direction"]), int(found["floor_impacts"])) == (0, -1)
        else:
            assert float(found["amplitude"]) == pytest.approx(expected, rel=2e-4)


def test_the_map_keeps_islands():
    data = overturning_map(CASE, [0.3, 0.5, 1.33, 1.4], {"body.width": [0.4, 1.2]})
    assert data["overturned"].dims == ("body.width", SCALE)
    assert data["overturned"].values.tolist() == [[False, True, False, True], [False] * 4]
    assert data["islands"].values.tolist() == [1, 0]
    assert data["fraction"].values.tolist() == [0.5, 0.0]
    assert data["first"].values[0] == 0.5
    assert data["last"].values[0] == 1.4
    assert np.isnan(data["first"].values[1])
    assert np.isnan(data["last"].values[1])
    stands_again = overturning_map(CASE, [0.3, 0.5, 1.33])
    assert int(stands_again["islands"]) == 0
    assert np.isnan(stands_again["last"])
    assert int(overturning_map(CASE, [0.6, 0.8])["fraction"]) == 1


def test_a_run_that_is_given_up_does_not_stand(monkeypatch):
    def gives_up(*args, **kwargs):
        data = sp.sweep(*args, **kwargs)
        data["outcome"][0] = list(sp.Outcome).index(sp.Outcome.FAILED)
        return data

    monkeypatch.setattr(boundary, "sweep_case", gives_up)
    data = overturning_map(CASE, [0.2, 0.3, 0.5])
    assert data["overturned"].values.tolist() == [False, False, True]
    assert data["failed"].values.tolist() == [True, False, False]
    assert (float(data["first"]), int(data["islands"])) == (0.2, 1)
    traced = trace_boundary(CASE, [0.2, 0.3, 0.5])
    assert (bool(traced["falls_at_lowest"]), int(traced["failed"])) == (True, 1)


def test_motions_are_an_axis():
    motions = [WAVE, sp.sine(9.81, 2.5, 0.4, quiet=10.0, dt=2.5e-3)]
    found = trace_boundary(CASE, [0.2, 0.6, 1.0, 2.5], {"motion": motions}, edge="first")
    for motion, amplitude in zip(motions, found["amplitude"].values, strict=True):
        alone = trace_boundary(
            sp.Case(CASE.body, CASE.room, motion, gravity=9.81), [0.2, 0.6, 1.0, 2.5], edge="first"
        )
        assert float(alone["amplitude"]) == amplitude


@pytest.mark.parametrize(
    ("amplitudes", "more", "words"),
    [
        ([1.0], {}, "2 or more"),
        (1.0, {}, "2 or more"),
        (["a", "b"], {}, "numbers"),
        ([0.0, np.nan], {}, "finite"),
        ([-1.0, 1.0], {}, "from 0 or more"),
        ([1.0, 0.5], {}, "must increase"),
        ([1.0, 1.0], {}, "must increase"),
        ([0.5, 1.0], {"axes": {SCALE: [1.0]}}, "by the amplitudes only"),
        ([0.5, 1.0], {"axes": {("body.width", SCALE): ([0.4], [1.0])}}, "by the amplitudes only"),
        ([0.5, 1.0], {"axes": {"body.wide": [1.0]}}, "body.width"),
        ([0.5, 1.0], {"edge": "lowest"}, "'first', 'last', 'all'"),
        ([0.5, 1.0], {"tolerance": 0.0}, "Tolerance"),
    ],
)
def test_refusals(amplitudes, more, words):
    with pytest.raises(sp.InputError, match=words):
        trace_boundary(CASE, amplitudes, **more)


@pytest.mark.parametrize("seed", range(20))
def test_known_edges_are_found(seed):
    """Each point falls between every second pair of its own edges."""
    draw = np.random.default_rng(seed)
    amplitudes = np.sort(draw.uniform(0.0, 1.0, 200))
    edges = [np.sort(draw.uniform(0.05, 0.95, draw.integers(0, 6))) for _ in range(7)]

    def runs(point, amplitude):
        passed = np.array([np.searchsorted(edges[p], a) for p, a in zip(point, amplitude, strict=True)], int)
        return passed % 2 == 1, passed.astype(np.int32)

    grid = np.repeat(np.arange(7), 200), np.tile(amplitudes, 7)
    sampled = runs(*grid)[0].reshape(7, 200)
    found = bisected(sampled_crossings(sampled, amplitudes), runs, 1e-9)
    for point, known in enumerate(edges):
        mine = found["point"] == point
        lower, upper, place = found["lower"][mine], found["upper"][mine], np.searchsorted(amplitudes, known)
        assert np.all(found["direction"][mine] == np.resize([1, -1], mine.sum()))
        assert np.all(upper - lower <= 1e-9)
        for edge, step in zip(known, place, strict=True):
            if (place == step).sum() == 1:  # two in one step of the amplitudes are not seen
                assert np.any((lower <= edge) & (edge <= upper))


def test_an_island_of_known_width_is_found_where_the_landings_change():
    amplitudes = np.array([1.0, 2.0, 3.0])

    def runs(point, amplitude):
        island = (amplitude > 2.613) & (amplitude < 2.615)
        return ~island, np.where(amplitude < 2.614, 3, 2).astype(np.int32)

    sampled = np.array([[True, True, True]])
    found = hidden_crossings(sampled, np.array([[3, 3, 2]], np.int32), amplitudes, runs, 1e-6)
    assert found["direction"].tolist() == [-1, 1]
    near = bisected(found, runs, 1e-9)
    assert near["lower"] == pytest.approx([2.613, 2.615], rel=1e-8)
    assert not len(hidden_crossings(sampled, np.array([[3, 3, 3]], np.int32), amplitudes, runs, 1e-6))
