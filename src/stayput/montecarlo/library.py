"""The library of runs of a verification: what becomes of each kind of piece under each motion and draw.

What becomes of a piece depends on its kind (its body, its measures, the floor, the walls that it reaches), on
the motion and the direction in which that shakes the piece, and on the draw: not on its name, where in the
room it stands, or what else is there. So each kind is run in axes of its own, and a room is composed of such
runs, turned and shifted to where its pieces stand.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, NamedTuple

from numpy.typing import NDArray

from stayput.execution import Pool
from stayput.measures.element import utilisation
from stayput.measures.measure import identity_of
from stayput.model.room import WALLS_AROUND
from stayput.montecarlo.runs import without_free_slide
from stayput.montecarlo.sampling import drawn_floor
from stayput.montecarlo.scene_draws import SceneDraw, SceneDraws, drawn_scene, drawn_shaking
from stayput.simulation.groups import Group, Track, falls_across, groups_of_falls
from stayput.simulation.placement import Placement
from stayput.simulation.placing import placed
from stayput.simulation.space import ENDS, names_of, results_of, trace_together
from stayput.simulation.space_engine import STEP, SpaceShaking
from stayput.simulation.space_records import NORMALS

if TYPE_CHECKING:
    import numpy as np

    from stayput.catalogue import Phrase
    from stayput.measures import Element
    from stayput.model.state import State
    from stayput.montecarlo.scaled_motions import FloorMotions
    from stayput.motion.record import Motion
    from stayput.scenario import Scenario
    from stayput.simulation.scene import Scene
    from stayput.simulation.space import Trace

NEAR_WALL = 0.3
"""Gap up to which a wall belongs to the kind of a piece [m]: it slides that far; devices reach less far."""


@dataclass(frozen=True, eq=False)
class PieceKind:
    """Pieces that run together, with their measures and the walls that they reach, in axes of their own.

    Parameters
    ----------
    scene : Scene
        The pieces; the first is at the origin.
    called : list of str or Phrase
        What refusals call them.
    streams : tuple of str
        The names of their draws; see `SceneDraws.streams`.
    key : hashable
        What tells it from other kinds: what it says of itself, and its measures, of which two of one's own
        may say the same.
    tracked : bool
        Whether something else than the pieces asks where they were: others, people, or walls left out.
    """

    scene: Scene
    called: Sequence[str | Phrase]
    streams: tuple[str, ...]
    key: Hashable
    tracked: bool

    @classmethod
    def of(
        cls, scene: Scene, called: Sequence[str | Phrase], streams: tuple[str, ...], *, tracked: bool
    ) -> PieceKind:
        """Return that of a scene in axes of its own."""
        pieces = [(piece.body, piece.at, piece.heading, piece.measures) for piece in scene.pieces]
        moves = [(piece.tilt, piece.velocity, piece.rotation_rate) for piece in scene.pieces]
        measures = tuple(identity_of(measure) for piece in scene.pieces for measure in piece.measures)
        key = repr((pieces, moves, scene.joints, scene.room, scene.friction, streams)), measures
        return cls(scene, called, streams, key, tracked)

    @cached_property
    def elements(self) -> list[tuple[Element, ...]]:
        """What holds each of the pieces.

        Raises
        ------
        InputError
            Measures that cannot be put in place.
        """
        bodies = placed(self.scene, names=self.called)
        return [() if body.held is None else body.held.elements for body in bodies]

    def run(
        self, draw: SceneDraw, floor: Motion, scale: float, gravity: float, initial: State | None
    ) -> tuple[Trace, SpaceShaking]:
        """Run the pieces under a draw, the floor moving by a factor on a motion."""
        shaking = drawn_shaking(floor, scale, draw, gravity)
        # what pieces do after all lie changes nothing
        how = gravity, self.called, initial
        return trace_draw(self.scene, draw, shaking, *how, stop_after_rest=ENDS), shaking


@dataclass(frozen=True, eq=False)
class Standing:
    """Pieces of a scene that run together, and where they stand in it.

    Parameters
    ----------
    group : Group
        Their numbers in the scene.
    axes : Placement
        Where the axes of their kind are in the scene.
    kind : PieceKind
        They with the walls that are near.
    walled : PieceKind
        They with all walls.
    """

    group: Group
    axes: Placement
    kind: PieceKind
    walled: PieceKind

    @cached_property
    def _far_walls(self) -> list[tuple[int, int, float]]:
        """Walls that the kind is without: the axis across each, its sign, and where it is [m]."""
        near, walls = self.kind.scene.room, list[tuple[int, int, float]]()
        for name in WALLS_AROUND:
            wall = getattr(self.walled.scene.room, name)
            if wall is not None and getattr(near, name) is None:
                normal = NORMALS[name]
                axis = 0 if normal[0] else 1
                outermost = min(piece.reach(normal)[0] for piece in self.kind.scene.pieces)
                walls.append((axis, round(normal[axis]), outermost - wall.gap))
        return walls

    def reaches_far_wall(self, run: KindRun) -> bool:
        """Return whether a piece came to a wall that its kind is without, so that it has to run with all."""
        return any(
            sign * track.span[0 if sign > 0 else 1, axis] < offset
            for axis, sign, offset in self._far_walls
            for track in run.tracks
        )


def standings_of(scene: Scene, draws: SceneDraws) -> list[Standing]:
    """Return the groups of pieces of a scene, each with its kind and where it stands."""
    return [standing_of(scene, group, draws) for group in groups_of_falls(scene)]


def standing_of(scene: Scene, group: Group, draws: SceneDraws) -> Standing:
    """Return a group of pieces of a scene with its kind and where it stands."""
    part, called, streams = scene.part(group), names_of(scene, group), draws.streams(group)
    first = part.pieces[0]
    axes = Placement.at(first.at[0], first.at[1], first.heading)
    in_axes = part.along(axes)
    near = in_axes.room
    for name in WALLS_AROUND:
        wall = getattr(in_axes.room, name)
        reach = max(NEAR_WALL, *(_falls_as_far(piece, name) for piece in in_axes.pieces))
        if wall is not None and wall.gap > reach:
            near = replace(near, **{name: None})
    tracked = scene.plan is not None or len(scene.pieces) > 1
    kind = walled = PieceKind.of(in_axes, called, streams, tracked=tracked)
    if near != in_axes.room:
        kind = PieceKind.of(replace(in_axes, room=near), called, streams, tracked=True)
    return Standing(group, axes, kind, walled)


def _falls_as_far(piece: Any, wall: str) -> float:
    """Return how far a piece comes towards a wall if it falls over an edge along that [m]."""
    towards = piece.turn.T @ NORMALS[wall]
    top = float(piece.solid.vertices[:, 2].max()) + piece.at[2]
    return top if abs(towards[falls_across(piece)]) > 0.5 else 0.0


class KindRun(NamedTuple):
    """What became of the pieces of a kind in a run.

    Parameters
    ----------
    results : ndarray of RESULT, shape (pieces,)
        What became of each.
    devices : list of tuple of ndarray
        DEVICE and utilisation of what holds each piece, and of the joints between them at last.
    tracks : list of Track
        Where each was, in the axes of the kind; of none where that is not `PieceKind.tracked`.
    """

    results: NDArray[np.void]
    devices: list[tuple[NDArray[np.void], NDArray[np.float64]]]
    tracks: list[Track]


class RunKey(NamedTuple):
    """Which run of a kind it is.

    Parameters
    ----------
    kind : hashable
        The key of the kind.
    motion, sample : int
        Numbers of the motion, and of the draw under it.
    quarter_turns : int
        By how many quarter turns the axes of the kind are turned, from which the motion is seen.
    level : int
        Number of the level of shaking.
    """

    kind: Hashable
    motion: int
    sample: int
    quarter_turns: int
    level: int


class Library:
    """Runs of the kinds of pieces of a scenario.

    Parameters
    ----------
    scenario : Scenario
        What stands where, and what of it is uncertain.
    floors : FloorMotions
        The motions.
    """

    def __init__(self, scenario: Scenario, floors: FloorMotions) -> None:
        self.floors, self._gravity, self._initial = floors, scenario.gravity, scenario.initial.state()
        self.draws = SceneDraws(scenario, floors.each)
        self._runs: dict[RunKey, KindRun] = {}

    def anew(self) -> Library:
        """Return one with the same draws and no runs."""
        library = copy(self)
        library._runs = {}
        return library

    def add(self, other: Library) -> None:
        """Take over the runs of another with the same draws, whose motions are the first of these."""
        self._runs |= other._runs

    def clear(self) -> None:
        """Forget all runs."""
        self._runs.clear()

    def runs_of(
        self,
        standings: Sequence[Standing],
        members: Sequence[tuple[int, int, int]],
        threads: int | None,
        advance: Callable[[int], None],
    ) -> list[list[KindRun]]:
        """Return the runs of groups of pieces, and make those that are not there yet.

        Parameters
        ----------
        standings : sequence of Standing
            The groups.
        members : sequence of tuple of int
            Motion, sample and level of each of the runs that each group has.
        threads : int, optional
            As many as there are cores by default. The bits do not depend on them.
        advance : callable
            Called with the number of runs just made; an exception that it raises stops the work.
        """
        keys = [
            [
                RunKey(each.kind.key, motion, sample, each.axes.quarter_turns, level)
                for motion, sample, level in members
            ]
            for each in standings
        ]
        of_groups = list(zip(standings, keys, strict=True))
        with Pool(threads) as pool:
            self._make({key: each.kind for each, of_group in of_groups for key in of_group}, pool, advance)
            with_walls = dict[RunKey, PieceKind]()
            for each, of_group in of_groups:
                for place, key in enumerate(of_group):
                    if each.reaches_far_wall(self._runs[key]):
                        of_group[place] = key._replace(kind=each.walled.key)
                        with_walls[of_group[place]] = each.walled
            self._make(with_walls, pool, advance)
        return [[self._runs[key] for key in of_group] for of_group in keys]

    def _make(self, needed: Mapping[RunKey, PieceKind], pool: Pool, advance: Callable[[int], None]) -> None:
        """Make those of some runs that are not there yet."""
        missing = [key for key in needed if key not in self._runs]
        self.draws.prepare(max((key.sample for key in missing), default=0))
        calls = (partial(self._run, needed[key], key) for key in missing)
        for number, run in pool.as_completed(calls):
            self._runs[missing[number]] = run
            advance(1)

    def _run(self, kind: PieceKind, key: RunKey) -> KindRun:
        place = key.level * self.floors.each + key.motion
        floor = self.floors.motions[place], float(self.floors.scales[place])
        axes = Placement(quarter_turns=key.quarter_turns)
        draw = self.draws.draw(key.motion, key.sample, kind.streams, axes)
        return kind_run(kind, *kind.run(draw, *floor, self._gravity, self._initial))


def kind_run(kind: PieceKind, traced: Trace, shaking: SpaceShaking) -> KindRun:
    """Return what became of the pieces of a kind in a run."""
    trace, first = traced.trace, 0
    used, devices = utilisation(trace.springs, trace.devices), list[tuple[Any, Any]]()
    for count in [*(len(body.springs) for body in traced.bodies), None]:
        rows = slice(first, None if count is None else first + count)
        devices.append((trace.devices[rows], used[rows]))
        first += count or 0
    results = results_of(traced, shaking.dt)
    free = [0.0 if body.held is None else body.held.free_slide for body in traced.bodies]
    without_free_slide(results, free)
    return KindRun(results, devices, traced.tracks(shaking.dt) if kind.tracked else [])


def trace_draw(
    scene: Scene,
    draw: SceneDraw,
    shaking: SpaceShaking,
    gravity: float,
    names: Sequence[str | Phrase] = (),
    initial: State | None = None,
    step: float = STEP,
    stop_after_rest: float = math.inf,
) -> Trace:
    """Run the pieces of a scene together under one draw and its `drawn_shaking`; see `trace_together`."""
    floor = partial(drawn_floor, draw=draw.room)
    drawn = drawn_scene(scene, draw)
    of_draw = step, draw.room.strength, floor, names, initial, stop_after_rest
    return trace_together(drawn, shaking, gravity, *of_draw, make_room=True)
