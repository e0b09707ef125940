"""`OptionRunner`: runs the options of a verification under its motions and draws, or one run again."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Hashable, Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.measures import Element, hold
from stayput.mechanics.runner import shaking, trace
from stayput.model.flat_fields import case_columns
from stayput.montecarlo.counting import OFFSETS, Members
from stayput.montecarlo.library import Library
from stayput.montecarlo.runs import Runs, run_level
from stayput.montecarlo.sampling import Rows, Settings, drawn_held, draws, rows_of
from stayput.montecarlo.scaled_motions import FloorMotions, ScaledMotions
from stayput.montecarlo.scenes import SceneRunner, replay
from stayput.motion.suites.suite import Suite
from stayput.simulation.case import Case, run_of
from stayput.simulation.space import warn_of_settlement
from stayput.verification.events import RoomEventDetector

if TYPE_CHECKING:
    from stayput.model.floor_plan import FloorPlan
    from stayput.montecarlo.counting import Member
    from stayput.motion.record import Motion
    from stayput.scenario import Scenario
    from stayput.scenario.measures import Option
    from stayput.simulation.run import Run
    from stayput.simulation.scene import Scene


MOST_EVENTS = 2000
"""Events of a run in the plane that its plot marks: the first ones, and the last."""


def floor_motion(scenario: Scenario, member: Member) -> tuple[Motion, float]:
    """Return a member's motion under the furniture, and the factor on it.

    Parameters
    ----------
    scenario : Scenario
        What was verified.
    member : Member
        Which of its motions.
    """
    shaken, ground, seed = scenario.shaking, scenario.ground(), scenario.uncertainty.seed
    alone = ScaledMotions.of(scenario, ground=Suite((ground[member.motion],)))
    strength = shaken.strength
    drawn = None if strength is None else strength.drawn(len(ground), seed)[member.motion]
    floors = alone.stated(drawn, shaken.scale, seed)
    return floors.motions[0], float(floors.scales[0])


def drawn_run(scenario: Scenario, option: Option, member: Member) -> Run:
    """Run a member of an option again, with its histories.

    Parameters
    ----------
    scenario : Scenario
        What was verified.
    option : Option
        What is in place; another option's run of the same member met the same motion and the same draw.
    member : Member
        Which motion, and which draw.
    """
    (motion, scale), stated = floor_motion(scenario, member), scenario.uncertainty
    counts, gravity = (member.motion + 1, member.sample + 1), scenario.gravity
    initial = scenario.initial.state()
    if scenario.dimensions == 3:
        with scenario.naming_keys():
            return replay(scenario, scenario.scene(option), member, motion, scale)
    scaled = motion.scaled(scale)
    each = draws(*counts, stated.seed, as_stated=stated.as_stated, quantities=stated.quantities)
    draw = each[member.motion][member.sample]
    body, room = scenario.piece.body(), scenario.room.room()
    held, elements = drawn_held(body, room, option.measures, draw)
    row = case_columns(held.body, held.room, initial, gravity)
    row["scale"] = scale
    traced = trace(row[0], shaking(motion.x, motion.z, motion.dt, 0), elements)
    case = Case(held.body, held.room, scaled, initial=initial, gravity=gravity)
    return run_of(case, traced, held, elements, MOST_EVENTS).named(scenario.names)


HeldBy = list[tuple[tuple[str, ...], Element | None]]
"""What holds the pieces of an option: the pieces, and the device; None of a joint."""


_latest: list[tuple[Callable[[], Scenario | None], Library]] = []


def _kept_library(scenario: Scenario, floors: FloorMotions) -> Library:
    """Return the library of a room if it is the one that was verified last: its plan needs most of its runs.

    It is kept as long as the scenario is, and that of one room alone: it takes hundreds of megabytes.
    """
    for of, library in _latest[:]:  # at once, as other threads may verify other rooms
        under, now = (each.of_ground[JMA_INTENSITY] for each in (library.floors, floors))
        if of() is scenario and np.array_equal(under, now):
            return library
    library = Library(scenario, floors)
    _latest[:] = [(weakref.ref(scenario, lambda _: library.clear()), library)]
    return library


def has_library(scenario: Scenario) -> bool:
    """Return whether the runs of a room are kept."""
    return any(of() is scenario for of, _ in _latest[:])


class OptionRunner:
    """Runs the options of a verification under its motions and draws.

    Parameters
    ----------
    scenario : Scenario
        What stands where.
    slide_limit : float
        Slide that counts as too far [m].
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    scaled_motions : ScaledMotions, optional
        The motions at any level; those of the scenario by default.
    floors : FloorMotions, optional
        The motions, where they are known at the one level that is run.
    beside : bool
        Whether two in five of the runs are at the levels beside the stated one; see `OFFSETS`.
    levels : sequence of float
        Further levels: JMA intensities of the ground.
    advance : callable
        Called with the number of runs just done; an exception that it raises stops the work.

    Attributes
    ----------
    floors : FloorMotions
        The motions at the shaking that the scenario states.
    all_floors : FloorMotions
        Those at all levels.
    settings : Settings
        Of the draws.
    members : Members
        All runs that an option may have, in the order in which they are made.
    detector : RoomEventDetector
        Who looks at the runs of a room with a plan.
    """

    def __init__(
        self,
        scenario: Scenario,
        slide_limit: float,
        threads: int | None,
        *,
        scaled_motions: ScaledMotions | None = None,
        floors: FloorMotions | None = None,
        beside: bool = False,
        levels: Sequence[float] = (),
        advance: Callable[[int], None] = lambda _runs: None,
    ) -> None:
        self.scenario, self.threads, self.advance = scenario, threads, advance
        if floors is None:
            motions = scaled_motions or ScaledMotions.of(scenario)
            self.floors = motions.stated_by(scenario)
            factors = [10.0 ** (0.5 * offset) for offset in OFFSETS[1:] if beside]
            nearby = [motions.stated_by(scenario, factor) for factor in factors]
            further = [motions.at(float(level)) for level in levels]
            self.all_floors = FloorMotions.joined([self.floors, *nearby, *further])
        else:
            self.floors = self.all_floors = floors
        self.settings = Settings.of(scenario, len(self.floors.motions), slide_limit)
        self.members = Members.in_turn(self.settings.motions, self.settings.runs, beside=beside)
        self.detector = RoomEventDetector()
        self._scenes: dict[int, tuple[Option, Scene]] = {}
        library = (Library if scenario.plan is None else _kept_library)(scenario, self.all_floors)
        self.scene_runner = SceneRunner(
            scenario, library, threads=threads, advance=advance, detect=self.detector
        )

    def go_on_from(self, first: OptionRunner) -> None:
        """Take over the scenes and runs of another, whose motions are the first of these."""
        self._scenes |= first._scenes
        self.scene_runner.library.add(first.scene_runner.library)

    @property
    def in_plane(self) -> bool:
        """Whether a lone piece is run in the plane."""
        return self.scenario.dimensions == 2

    def scene(self, option: Option) -> Scene:
        """Return the pieces where they stand with an option."""
        known = self._scenes.get(id(option))
        if known is None:  # the option is kept with its scene, so that the id stays its own
            if not self._scenes:
                warn_of_settlement(self._as_stated)
            known = self._scenes[id(option)] = option, self._scene(option)
        return known[1]

    @cached_property
    def _as_stated(self) -> Scene:
        return self.scenario.scene(self.scenario.stated)

    def _scene(self, option: Option) -> Scene:
        """Return the scene of an option: in a room of many pieces what is stated, with what is changed."""
        base, stated = self._as_stated, self.scenario.stated
        if base.plan is None or option.joined != stated.joined:
            return self.scenario.scene(option)
        with self.scenario.naming_keys():
            pieces = [
                piece if now == was else replace(piece, measures=now)
                for piece, now, was in zip(base.pieces, option.on, stated.on, strict=True)
            ]
            scene = replace(base, pieces=pieces)
            return scene.moved(option.moved) if option.moved else scene

    def plan(self, option: Option) -> FloorPlan:
        """Return the plan of a room with an option."""
        plan = self.scene(option).plan
        assert plan is not None
        return plan

    def copies(self, option: Option) -> list[list[int]]:
        """Return of each piece those of its kind, itself among them: one for each wall that they face.

        Copies that face the same way have the same runs; what is told of a kind rests on all its runs.
        """
        copies = [[number] for number in range(len(self.scenario.names))]
        if self.in_plane:
            return copies
        facing = dict[Hashable, dict[int, int]]()
        alone = [each for each in self.scene_runner.standings(self.scene(option)) if len(each.group) == 1]
        for standing in alone:
            same = facing.setdefault(standing.kind.key, {})
            same.setdefault(standing.axes.quarter_turns, standing.group[0])
        for standing in alone:
            copies[standing.group[0]] = [*facing[standing.kind.key].values()]
        return copies

    def held_by(self, option: Option) -> HeldBy:
        """Return what holds the pieces of an option, in the order of the devices of its runs."""
        scenario = self.scenario
        if self.in_plane:
            held = hold(scenario.piece.body(), scenario.room.room(), option.measures)
            return [(scenario.names, element) for element in held.elements]
        scene, each = self.scene(option), list[tuple[tuple[str, ...], Element | None]]()
        with scenario.naming_keys():
            standings = self.scene_runner.standings(scene)
            on = {
                number: elements
                for standing in standings
                for number, elements in zip(standing.group, standing.kind.elements, strict=True)
            }
        for number, name in enumerate(scene.names):
            each += [((name,), element) for element in on[number]]
        joined = ((scene.names[joint.first], scene.names[joint.second]) for joint in scene.joints)
        return [*each, *((pair, None) for pair in joined)]

    def rows(self, options: Sequence[Option], members: Members) -> list[Rows]:
        """Return the rows of options of a lone piece in the plane."""
        scenario, settings = self.scenario, self.settings
        body, room = scenario.piece.body(), scenario.room.room()
        samples = int(members.sample.max(initial=0)) + 1
        drawn = draws(
            *(settings.motions, samples, settings.seed),
            as_stated=settings.as_stated,
            quantities=settings.quantities,
        ).of(members)
        stands = settings.gravity, scenario.initial.state()
        return [rows_of(body, room, option.measures, drawn, *stands) for option in options]

    def run(self, options: Sequence[Option], members: Members, *, keep: bool = False) -> list[Runs]:
        """Run options; ``keep``: with the tracks of the pieces."""
        if self.in_plane:
            rows = self.rows(options, members)
            return run_level(rows, self.all_floors, members, threads=self.threads, progress=self.advance)
        with self.scenario.naming_keys():
            return self.scene_runner.run([*map(self.scene, options)], members, keep=keep)
