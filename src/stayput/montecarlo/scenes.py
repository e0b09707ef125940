"""Monte Carlo runs of scenes, composed of the runs of a library: what became of each piece in each."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME, RESULT
from stayput.mechanics.devices.columns import HOLDS
from stayput.montecarlo.library import KindRun, Library, Standing, kind_run, standing_of, standings_of
from stayput.montecarlo.runs import Runs
from stayput.montecarlo.scene_draws import SceneDraw, SceneDraws, drawn_scene
from stayput.simulation.groups import Group, Track, groups_of_falls
from stayput.simulation.placement import ORIGIN, Placement
from stayput.simulation.space import Trace, joined_groups, run_of_trace

if TYPE_CHECKING:
    from stayput.model.floor_plan import FloorPlan
    from stayput.montecarlo.counting import Member, Members
    from stayput.motion.record import Motion
    from stayput.scenario import Scenario
    from stayput.simulation.piece import Piece
    from stayput.simulation.run import Run
    from stayput.simulation.scene import Scene


class RoomEvents(NamedTuple):
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
"""Columns of `RoomEvents.hits`."""

DetectEvents: TypeAlias = "Callable[[FloorPlan, Sequence[Track]], RoomEvents]"
"""Detects what happened in a run of a room, from its plan and where the pieces were."""


class SceneRunner:
    """Runs options of a scene under draws; runs of a kind serve all options and all pieces of that kind.

    Parameters
    ----------
    scenario : Scenario
        What stands where, and what of it is uncertain.
    library : Library
        The runs that are made, to which more are added.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    advance : callable
        Called with the number of runs just done; an exception that it raises stops the work.
    detect : callable
        What looks at the runs of a room with a plan.
    """

    def __init__(
        self,
        scenario: Scenario,
        library: Library,
        *,
        threads: int | None,
        advance: Callable[[int], None],
        detect: DetectEvents,
    ) -> None:
        self.library, self._threads, self._advance = library, threads, advance
        self._detect, self._counted = detect, list(scenario.counted)
        self._placed: dict[tuple[int, Placement], tuple[KindRun, list[Track]]] = {}
        self._standings: dict[tuple[int, ...], tuple[list[Piece], Standing]] = {}
        self._of_scenes: dict[int, tuple[Scene, list[Standing]]] = {}

    def anew(self, advance: Callable[[int], None]) -> SceneRunner:
        """Return the same with the same draws, which knows of no run yet."""
        runner = copy(self)
        runner.library, runner._advance = self.library.anew(), advance
        runner._placed, runner._standings, runner._of_scenes = {}, {}, {}
        return runner

    def standings(self, scene: Scene) -> list[Standing]:
        """Return the groups of pieces of a scene."""
        if id(scene) not in self._of_scenes:  # the scene is kept with them, so that the id stays its own
            self._of_scenes[id(scene)] = scene, self._find_standings(scene)
        return self._of_scenes[id(scene)][1]

    def _find_standings(self, scene: Scene) -> list[Standing]:
        """Return the same; groups that options of a room leave alone are made once."""
        draws, standings = self.library.draws, list[Standing]()
        for group in groups_of_falls(scene):
            pieces = [scene.pieces[number] for number in group]
            key = (len(scene.joints), *map(id, pieces))
            if scene.plan is None:  # how far away walls are depends on all pieces
                standings.append(standing_of(scene, group, draws))
                continue
            if key not in self._standings:  # the pieces are kept with it, so that the ids stay their own
                self._standings[key] = pieces, standing_of(scene, group, draws)
            standings.append(self._standings[key][1])
        return standings

    def run(self, scenes: Sequence[Scene], members: Members, *, keep: bool = False) -> list[Runs]:
        """Run scenes of the same pieces.

        Parameters
        ----------
        scenes : sequence of Scene
            The pieces with each option, as stated.
        members : Members
            The runs.
        keep : bool
            Whether the tracks of the pieces are kept; not of a lone piece without a plan.

        Raises
        ------
        InputError
            Measures that cannot be put in place, as stated or in one of the draws.
        """
        each = [*map(self.standings, scenes)]
        all_runs = iter(self._runs_of([standing for of_scene in each for standing in of_scene], members))
        composed: list[Runs] = []
        for scene, standings in zip(scenes, each, strict=True):
            runs_of_groups = [(standing, next(all_runs)) for standing in standings]
            composed.append(self._composed(scene, runs_of_groups, members, keep))
        return composed

    def _runs_of(self, standings: Sequence[Standing], members: Members) -> list[list[KindRun]]:
        return self.library.runs_of(standings, [*members], self._threads, self._advance)

    def _composed(
        self,
        scene: Scene,
        runs_of_groups: Sequence[tuple[Standing, Sequence[KindRun]]],
        members: Members,
        keep: bool,
    ) -> Runs:
        """Return the runs of a scene, composed of those of its groups of pieces."""
        shape = len(members), len(scene.pieces)
        keep = keep and all(standing.kind.tracked for standing, _ in runs_of_groups)
        results, tracks = np.zeros(shape, RESULT), np.empty(shape, object)
        columns: list[list[Any]] = [[] for _ in range(shape[1] + len(scene.joints))]
        for standing, runs in runs_of_groups:
            numbers = [*standing.group]
            results[:, numbers] = [run.results for run in runs]
            joints = [n for n, joint in enumerate(scene.joints) if joint.first in standing.group]
            for place, number in enumerate(numbers):
                columns[number] = [run.devices[place] for run in runs]
            for place, number in enumerate(joints):
                of_joint = slice(place, place + 1)
                columns[shape[1] + number] = [
                    tuple(column[of_joint] for column in run.devices[-1]) for run in runs
                ]
            if scene.plan is not None or keep:
                for row, run in enumerate(runs):
                    tracks[row, numbers] = self._in_room(standing, run)
        devices, used = (
            np.concatenate([[each[part] for each in column] for column in columns], axis=1)
            for part in range(2)
        )
        counted = results[:, self._counted]
        return Runs(
            members,
            overturned=(counted["outcome"] == OVERTURNED_OUTCOME).any(axis=1),
            missing=(results["outcome"] == FAILED_OUTCOME).any(axis=1),
            hit_wall=np.any(counted["wall_impacts"] > 0, axis=1),
            device_failed=(devices["failure"] != HOLDS).any(axis=1),
            slide=counted["peak_slide"].max(axis=1),
            tilt=counted["peak_tilt"].max(axis=1),
            devices=devices,
            used=used,
            masses=np.ones(len(members)),
            results=results,
            **self._events(scene, tracks)._asdict(),
            tracks=tracks if keep else tracks[:, :0],
        )

    def _in_room(self, standing: Standing, run: KindRun) -> list[Track]:
        """Return where the pieces of a group were in the room; that of one run and place is made once."""
        key = id(run), standing.axes
        if key not in self._placed:  # the run is kept with it, so that the id stays its own
            self._placed[key] = run, [track.placed(standing.axes) for track in run.tracks]
        return self._placed[key][1]

    def _events(self, scene: Scene, tracks: NDArray[np.object_]) -> RoomEvents:
        """Return what happened in a room in each run."""
        if scene.plan is None:
            nothing = np.zeros((len(tracks), 0), np.bool_)
            return RoomEvents(np.zeros((len(tracks), 0, len(scene.pieces), 4)), nothing, nothing)
        events = [self._detect(scene.plan, row) for row in tracks.tolist()]
        return RoomEvents(*map(np.array, zip(*events, strict=True)))


def replay(scenario: Scenario, scene: Scene, member: Member, motion: Motion, scale: float) -> Run:
    """Run a member of a scene again as it was run, with its histories.

    Parameters
    ----------
    scenario : Scenario
        What was verified.
    scene : Scene
        Its pieces with an option.
    member : Member
        Which of the motions, and which draw.
    motion, scale
        The floor's motion, and the factor on it.
    """
    draws, traces = SceneDraws(scenario, member.motion + 1), dict[Group, Trace]()

    def drawn(axes: Placement, streams: Sequence[str]) -> SceneDraw:
        return draws.draw(*member, streams, axes)

    for standing in standings_of(scene, draws):
        draw, axes = drawn(standing.axes, standing.kind.streams), standing.axes
        how = draw, motion, scale, scenario.gravity, scenario.initial.state()
        traced, shaking = standing.kind.run(*how)
        if standing.reaches_far_wall(kind_run(standing.kind, traced, shaking)):
            traced, _ = standing.walled.run(*how)
        traces[standing.group] = replace(traced.in_room(), axes=axes).in_room()
    draw = drawn(ORIGIN, draws.streams(range(len(scene.pieces))))
    shown, room = motion.scaled(scale).pointing(draw.direction), drawn_scene(scene, draw).room
    run = run_of_trace(joined_groups(scene, traces), scene.joints, room, shown)
    return replace(run, names=scene.names, plan=scene.plan)
