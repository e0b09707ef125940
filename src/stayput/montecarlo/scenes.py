"""Monte Carlo runs of scenes: what became of all pieces under each draw.

Pieces run alone until they meet (see `stayput.simulation.groups`), so that what a group does serves every
option that leaves it as it is.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from stayput.execution import Pool
from stayput.measures.element import utilisation
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME, RESULT
from stayput.mechanics.devices.columns import HOLDS
from stayput.montecarlo.runs import Runs, without_free_slide
from stayput.montecarlo.sampling import drawn_floor
from stayput.montecarlo.scene_draws import DrawOfSeveral, drawn_scene, drawn_shaking, draws_of_scenario
from stayput.simulation.groups import Group, Track, groups_at_first, run_in_groups
from stayput.simulation.space import ENDS, names_of, results_of, run_of_trace, trace_groups, trace_together
from stayput.simulation.space_engine import STEP, SpaceShaking

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.model.floor_plan import FloorPlan
    from stayput.model.state import State
    from stayput.montecarlo.scaled_motions import FloorMotions
    from stayput.motion.record import Motion
    from stayput.scenario import Scenario
    from stayput.simulation.run import Run
    from stayput.simulation.scene import Scene
    from stayput.simulation.space import Trace


class GroupRun(NamedTuple):
    """What became of a group of pieces under a draw.

    Parameters
    ----------
    results : ndarray of RESULT, shape (pieces,)
        What became of each.
    devices : list of tuple of ndarray
        DEVICE and utilisation of what holds each piece, and of the joints between them at last.
    tracks : list of Track or None
        Where each was; None where nothing can reach it.
    """

    results: NDArray[np.void]
    devices: list[tuple[NDArray[np.void], NDArray[np.float64]]]
    tracks: list[Any]


KnownRuns: TypeAlias = dict[tuple[int, int], dict[tuple[str, float], GroupRun]]
"""Runs of groups by motion and sample, by what tells the group and how long it lies."""


class Seen(NamedTuple):
    """What happened in a run of a room.

    Parameters
    ----------
    hits : ndarray, shape (places, pieces, 4)
        Contacts of pieces with the places of people: time [s], speed [m/s], energy [J], and whether the piece
        falls there; NaN where none. See `stayput.verification.events.RoomContact`.
    blocked : ndarray of bool, shape (doors,)
        Whether a door is blocked at the end.
    shut_in : ndarray of bool, shape (places,)
        Whether no way leads out from a place at the end.
    """

    hits: NDArray[np.float64]
    blocked: NDArray[np.bool_]
    shut_in: NDArray[np.bool_]


SPEED, ENERGY, FALLS = 1, 2, 3
"""Columns of `Seen.hits`."""

Watch: TypeAlias = "Callable[[FloorPlan, Sequence[Track]], Seen]"
"""Looks at what happened in a run of a room, of its plan and where the pieces were."""


class SceneRunner:
    """Runs options of a scene under draws; what a group of pieces does is run once for all options.

    Parameters
    ----------
    scenario : Scenario
        What stands where, and what of it is uncertain.
    floors : FloorMotions
        The motions.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    advance : callable
        Called with the number of runs just done; an exception that it raises stops the work.
    watch : callable
        What looks at the runs of a room with a plan.
    known : dict, optional
        Runs of the same motions and draws that are known, to which those are added that are made.
    """

    def __init__(
        self,
        scenario: Scenario,
        floors: FloorMotions,
        *,
        threads: int | None,
        advance: Callable[[int], None],
        watch: Watch,
        known: KnownRuns | None,
    ) -> None:
        self._scenario, self.floors, self.threads = scenario, floors, threads
        self.advance, self._watch, self._counted = advance, watch, list(scenario.counted)
        self._gravity, self._initial = scenario.gravity, scenario.initial.state()
        self._draws: list[list[DrawOfSeveral]] = [[] for _ in floors.motions]
        self._known = {} if known is None else known

    def under(self, floors: FloorMotions, advance: Callable[[int], None] | None = None) -> SceneRunner:
        """Return the same under other motions, which knows of no run yet; another ``advance`` if given."""
        runner = copy(self)  # with the same draws
        runner.floors, runner.advance, runner._known = floors, advance or self.advance, {}
        return runner

    def draw(self, motion: int, sample: int) -> DrawOfSeveral:
        """Return the draw of a member."""
        done = len(self._draws[motion])
        if sample >= done:
            drawn = draws_of_scenario(self._scenario, len(self._draws), sample + 1 - done, done)
            for known, more in zip(self._draws, drawn, strict=True):
                known.extend(more)
        return self._draws[motion][sample]

    def run(self, scenes: Sequence[Scene], samples: int, start: int = 0, *, keep: bool = False) -> list[Runs]:
        """Run scenes of the same pieces under samples of each motion.

        Parameters
        ----------
        scenes : sequence of Scene
            The pieces with each option, as stated.
        samples, start : int
            Samples of each motion, and how many come before them.
        keep : bool
            Whether the tracks of the pieces are kept.

        Raises
        ------
        InputError
            Measures that cannot be put in place, as stated or in one of the draws.
        """
        shape = len(self.floors.motions), samples
        parts = [_Parts(scene) for scene in scenes]
        ran: dict[tuple[int, int], list[tuple[dict[Group, GroupRun], Seen]]] = {}
        self.draw(0, start + samples - 1)  # all are drawn before threads ask for them

        def run(motion: int, sample: int) -> None:
            shaking, ran[motion, sample] = self.shaking(motion, start + sample), []
            for of in parts:
                groups = self._groups(of, motion, start + sample, shaking)
                ran[motion, sample].append((groups, self._seen(of, groups)))

        with Pool(self.threads) as pool:
            for _ in pool.as_completed(partial(run, *place) for place in np.ndindex(*shape)):
                self.advance(len(scenes))
        return [
            _runs([ran[place][option] for place in np.ndindex(*shape)], shape, of.scene, self._counted, keep)
            for option, of in enumerate(parts)
        ]

    def falls(
        self, scenes: Sequence[Scene], chosen: NDArray[np.bool_]
    ) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Return which runs overturn and which are given up.

        Parameters
        ----------
        scenes : sequence of Scene
            The pieces with each option, as stated.
        chosen : ndarray of bool, shape (scenes, motions, samples)
            What is run; the other runs do neither.

        Raises
        ------
        InputError
            As for `run`.
        """
        parts = [_Parts(scene) for scene in scenes]
        overturned, missing = np.zeros_like(chosen), np.zeros_like(chosen)
        self.draw(0, chosen.shape[2] - 1)  # all are drawn before threads ask for them

        def run(motion: int, sample: int) -> int:
            wanted, shaking = np.flatnonzero(chosen[:, motion, sample]).tolist(), self.shaking(motion, sample)
            for option in wanted:
                outcomes = dict[int, int]()
                # what a lone piece does after it lies changes nothing
                lies = ENDS if len(scenes[option].pieces) == 1 else math.inf
                for group, ran in self._groups(parts[option], motion, sample, shaking, lies).items():
                    outcomes |= zip(group, ran.results["outcome"].tolist(), strict=True)
                overturned[option, motion, sample] = OVERTURNED_OUTCOME in map(outcomes.get, self._counted)
                missing[option, motion, sample] = FAILED_OUTCOME in outcomes.values()
            return len(wanted)

        places = np.argwhere(chosen.any(axis=0)).tolist()
        with Pool(self.threads) as pool:
            for _, count in pool.as_completed(partial(run, *place) for place in places):
                self.advance(count)
        return overturned, missing

    def devices_of(self, scene: Scene, body: int, samples: int) -> NDArray[np.void]:
        """Return what became of what holds a piece: DEVICE, shape (motions, samples, devices).

        It runs with what it runs together with from the beginning, whatever it meets.
        """
        of = _Parts(scene)
        group = next(group for group in of.at_first if body in group)

        def run(motion: int, sample: int) -> NDArray[np.void]:
            ran = self._group(of, group, motion, sample, self.shaking(motion, sample))
            return ran.devices[group.index(body)][0]

        self.draw(0, samples - 1)
        with Pool(self.threads) as pool:
            places = np.ndindex(len(self.floors.motions), samples)
            rows = [*pool.in_order(partial(run, *place) for place in places)]
        self.advance(len(rows))
        return np.array(rows).reshape(len(self.floors.motions), samples, -1)

    def shaking(self, motion: int, sample: int) -> SpaceShaking:
        """Return how the floor shakes in a member."""
        floor, scale = self.floors.motions[motion], float(self.floors.scales[motion])
        return drawn_shaking(floor, scale, self.draw(motion, sample), self._gravity)

    def _groups(
        self, of: _Parts, motion: int, sample: int, shaking: SpaceShaking, lies: float = math.inf
    ) -> dict[Group, GroupRun]:
        """Return the runs of the groups of a scene, as they are after all meetings."""
        run = partial(self._group, of, motion=motion, sample=sample, shaking=shaking, lies=lies)
        return run_in_groups(of.at_first, run, lambda ran: ran.tracks)

    def _group(
        self,
        of: _Parts,
        group: Group,
        motion: int,
        sample: int,
        shaking: SpaceShaking,
        lies: float = math.inf,
    ) -> GroupRun:
        """Run a group, or return its run where it is known."""
        (part, called, key), known = of.part(group), self._known.setdefault((motion, sample), {})
        if (key, lies) not in known:
            draw = self.draw(motion, sample).of(group)
            reached = len(of.at_first) > 1 or of.scene.plan is not None
            traced = trace_draw(part, draw, shaking, self._gravity, called, self._initial, lies=lies)
            ran = _group_run(traced, shaking, tracked=reached)
            if FAILED_OUTCOME in ran.results["outcome"]:  # as those are that an exception has cut off
                return ran
            known[key, lies] = ran
        return known[key, lies]

    def _seen(self, of: _Parts, groups: dict[Group, GroupRun]) -> Seen:
        """Return what happened in the room in the runs of the groups of a scene."""
        if of.scene.plan is None:
            nothing = np.zeros(0, np.bool_)
            return Seen(np.zeros((0, len(of.scene.pieces), 4)), nothing, nothing)
        tracks = dict[int, Track]()
        for group, ran in groups.items():
            tracks |= zip(group, ran.tracks, strict=True)
        return self._watch(of.scene.plan, [tracks[body] for body in sorted(tracks)])


class _Parts:
    """A scene with the groups of pieces that run together at first, and each group by itself."""

    def __init__(self, scene: Scene) -> None:
        self.scene, self.at_first, self._known = scene, groups_at_first(scene), dict[Group, Any]()

    def part(self, group: Group) -> tuple[Scene, list[str | Phrase], str]:
        """Return the scene of a group, how refusals call its pieces, and what tells it from other groups."""
        if group not in self._known:
            part, called = self.scene.part(group), names_of(self.scene, group)
            stands = [(piece.at, piece.heading, piece.measures) for piece in part.pieces]
            self._known[group] = part, called, repr((group, stands, part.joints, part.room))
        return self._known[group]


def _group_run(traced: Trace, shaking: SpaceShaking, *, tracked: bool) -> GroupRun:
    trace, first = traced.trace, 0
    used, devices = utilisation(trace.springs, trace.devices), list[tuple[Any, Any]]()
    for count in [*(len(body.springs) for body in traced.bodies), None]:
        rows = slice(first, None if count is None else first + count)
        devices.append((trace.devices[rows], used[rows]))
        first += count or 0
    tracks = traced.tracks(shaking.dt) if tracked else [None] * len(traced.bodies)
    results = results_of(traced, shaking.times)
    free = [0.0 if body.held is None else body.held.free_slide for body in traced.bodies]
    without_free_slide(results, free)
    return GroupRun(results, devices, tracks)


def trace_draw(
    scene: Scene,
    draw: DrawOfSeveral,
    shaking: SpaceShaking,
    gravity: float,
    names: Sequence[str | Phrase] = (),
    initial: State | None = None,
    step: float = STEP,
    lies: float = math.inf,
) -> Trace:
    """Run the pieces of a scene together under one draw and its `drawn_shaking`; see `trace_together`."""
    floor = partial(drawn_floor, draw=draw.room)
    drawn = drawn_scene(scene, draw)
    return trace_together(drawn, shaking, gravity, step, draw.room.strength, floor, names, initial, lies)


def replay(
    scene: Scene,
    draw: DrawOfSeveral,
    motion: Motion,
    scale: float,
    gravity: float,
    initial: State | None = None,
) -> Run:
    """Run a scene under one draw again, with its histories.

    Parameters
    ----------
    scene, draw, gravity, initial
        As for `SceneRunner`.
    motion, scale
        The floor's motion, and the factor on it.
    """
    shaking = drawn_shaking(motion, scale, draw, gravity)

    def trace(group: Group) -> Trace:
        part, called = scene.part(group), names_of(scene, group)
        return trace_draw(part, draw.of(group), shaking, gravity, called, initial).in_room()

    traced = trace_groups(scene, trace, shaking.dt)
    shown = motion.scaled(scale).pointing(draw.direction)
    run = run_of_trace(traced, scene.joints, drawn_scene(scene, draw).room, shown)
    return replace(run, names=scene.names, plan=scene.plan)


def _runs(
    members: Sequence[tuple[dict[Group, GroupRun], Seen]],
    shape: tuple[int, int],
    scene: Scene,
    counted: list[int],
    keep: bool,
) -> Runs:
    """Return the runs of an option, by motion and by sample within it."""
    count = len(scene.pieces)
    results = np.zeros((*shape, count), RESULT)
    columns, tracks = list[Any](), np.empty((*shape, count), object)
    for place, (groups, _) in zip(np.ndindex(*shape), members, strict=True):
        of_pieces, of_joints = dict[int, Any](), dict[int, Any]()
        for group, ran in groups.items():
            for number, result, held, track in zip(group, ran.results, ran.devices, ran.tracks, strict=False):
                results[(*place, number)], of_pieces[number] = result, held
                tracks[(*place, number)] = track
            inside = [n for n, joint in enumerate(scene.joints) if joint.first in group]
            of_joints |= {
                n: (ran.devices[-1][0][k : k + 1], ran.devices[-1][1][k : k + 1])
                for k, n in enumerate(inside)
            }
        held = *map(of_pieces.__getitem__, range(count)), *map(of_joints.__getitem__, sorted(of_joints))
        columns.append([np.concatenate(column) for column in zip(*held, strict=True)])
    devices, used = (np.array(column).reshape(*shape, -1) for column in zip(*columns, strict=True))
    seen = zip(*(seen for _, seen in members), strict=True)
    watched = [np.array(column).reshape(*shape, *np.shape(column[0])) for column in seen]
    counted_results = results[..., counted]
    return Runs(
        overturned=(counted_results["outcome"] == OVERTURNED_OUTCOME).any(axis=-1),
        missing=(results["outcome"] == FAILED_OUTCOME).any(axis=-1),
        hit_wall=np.any(counted_results["wall_impacts"] > 0, axis=-1),
        device_failed=(devices["failure"] != HOLDS).any(axis=-1),
        slide=counted_results["peak_slide"].max(axis=-1),
        tilt=counted_results["peak_tilt"].max(axis=-1),
        devices=devices,
        used=used,
        masses=np.ones(shape),
        results=results,
        **dict(zip(Seen._fields, watched, strict=True)),
        tracks=tracks if keep else tracks[..., :0],
    )
