"""Monte Carlo runs of a room: pieces that neither stand on nor hold each other run each by themselves.

All meet the same earthquakes from the same directions, so that what falls together is known. A long piece of
furniture on the floor runs in the plane across its length, with the motion's part in that direction; all
others in space.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.execution import Pool
from stayput.fragility.probabilities import probability
from stayput.measures.wall import WallDevice
from stayput.mechanics.columns import FAILED_OUTCOME, H_TILT, H_X, H_Z, OVERTURNED_OUTCOME, RESULT
from stayput.mechanics.devices.columns import HOLDS
from stayput.mechanics.runner import shaking as shaking_in_plane
from stayput.mechanics.runner import trace
from stayput.model.flat_fields import case_columns
from stayput.model.room import SIDE_WALLS
from stayput.model.state import State
from stayput.montecarlo.counting import Outcomes
from stayput.montecarlo.sampling import drawn_held
from stayput.montecarlo.several import DrawOfSeveral, drawn_shaking, trace_draw
from stayput.rooms.tracks import Track, at_rest, track_in_plane, tracks_of
from stayput.simulation.placing import placed_piece, planes_around, room_seen
from stayput.simulation.space import results_of
from stayput.verification.notes import LONG

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterable, Iterator, Sequence

    from numpy.typing import NDArray

    from stayput.fragility.probabilities import Probability
    from stayput.measures import Held, Measure
    from stayput.model.floor_plan import FloorPlan
    from stayput.montecarlo.hazard import FloorMotions
    from stayput.scenario import Scenario
    from stayput.simulation.piece import Piece
    from stayput.simulation.scene import Scene
    from stayput.simulation.space_engine import SpaceShaking


class DeviceForces(NamedTuple):
    """Forces on one device [N]: away from what it is fixed to, towards it, and across."""

    pull: float
    push: float
    shear: float

    def times(self, factor: float) -> DeviceForces:
        """Return them multiplied."""
        return DeviceForces(*(factor * force for force in self))


PeakForces = dict[tuple[int, str], DeviceForces]
"""Largest forces on any of the like devices in a run, by the piece's place in its part and the kind."""


def peak_forces(place: int, held: Held, devices: NDArray[np.void], mass: float) -> PeakForces:
    """Return the largest forces of a run on one of each kind of device of a piece.

    Parameters
    ----------
    place : int
        The place of the piece in its part.
    held : Held
        The piece with its devices.
    devices : ndarray of DEVICE
        What became of them.
    mass : float
        By what the forces are multiplied: the body's mass [kg] where they are per unit mass.
    """
    peaks: PeakForces = {}
    for element, device in zip(held.elements, devices, strict=True):
        each = mass / element.count
        new = DeviceForces(*(each * float(device[name]) for name in ("peak_pull", "peak_push", "peak_shear")))
        known = peaks.get((place, element.kind), new)
        peaks[place, element.kind] = DeviceForces(*map(max, new, known))
    return peaks


class RoomPart(NamedTuple):
    """Pieces of a room that are run together, as they stand and are held.

    Parameters
    ----------
    bodies : tuple of int
        Their numbers in the scenario.
    scene : Scene
        The pieces in the room.
    """

    bodies: tuple[int, ...]
    scene: Scene

    @classmethod
    def of(cls, whole: Scene, bodies: tuple[int, ...]) -> RoomPart:
        """Return some of the pieces of a scene."""
        return cls(bodies, whole.part(bodies))

    @property
    def in_plane(self) -> bool:
        """Whether the plane across its length tells how it falls; see `studies/three_dimensions.py`.

        It does not tell the forces on what holds it to the wall: shaking along the wall turns the piece about
        one of the devices and adds to what that one bears.
        """
        only = self.scene.pieces[0]
        return (
            len(self.bodies) == 1
            and only.body.shape is None
            and only.at[2] == 0.0
            and not any(isinstance(measure, WallDevice) for measure in only.measures)
            and (only.body.length or 0.0) >= LONG * only.body.width
        )


def groups_of(scenario: Scenario) -> tuple[tuple[int, ...], ...]:
    """Return which pieces stand on or are joined to one another, in the order of the first of each group."""
    names, group = scenario.names, list(range(len(scenario.names)))
    bonds = [(number, names.index(piece.on)) for number, piece in enumerate(scenario.pieces) if piece.on]
    bonds += [(names.index(joint.first), names.index(joint.second)) for joint in scenario.joints]
    for first, second in bonds:
        kept, gone = sorted((group[first], group[second]))
        group = [kept if number == gone else number for number in group]
    return tuple(tuple(i for i, root in enumerate(group) if root == number) for number in sorted(set(group)))


def group_of(scenario: Scenario, body: int) -> tuple[int, ...]:
    """Return the pieces that run together with one of them."""
    return next(group for group in groups_of(scenario) if body in group)


def with_measures(whole: Scene, body: int, measures: Iterable[Measure]) -> Scene:
    """Return a scene with further measures on a piece; they have not been put in place."""
    piece = whole.pieces[body]
    return whole.with_piece(body, replace(piece, measures=(*piece.measures, *measures)))


def moved_to(piece: Piece, at: tuple[float, float], heading: float) -> Piece:
    """Return a piece at another place of the plan, at the same height."""
    return replace(piece, at=(*at, piece.at[2]), heading=heading)


def placed_elsewhere(whole: Scene, body: int, at: tuple[float, float], heading: float) -> RoomPart:
    """Return a piece by itself, moved to another place of the plan."""
    moved = moved_to(whole.pieces[body], at, heading)
    return RoomPart.of(whole.with_piece(body, moved), (body,))


@dataclass(frozen=True, slots=True, eq=False)
class PartRuns:
    """What became of the pieces of a part, over motions and samples.

    Parameters
    ----------
    results : ndarray of RESULT, shape (motions, samples, bodies)
        What became of each.
    device_failed : ndarray of bool, shape (motions, samples)
        Whether a device or joint failed.
    tracks : list, [run][body]
        Where each was; runs by motion and by sample within it.
    peaks : list of PeakForces
        Largest forces on devices, by run.
    """

    results: NDArray[np.void]
    device_failed: NDArray[np.bool_]
    tracks: list[list[Track]]
    peaks: list[PeakForces]

    @property
    def missing(self) -> NDArray[np.bool_]:
        """Which runs were given up, shape (motions, samples)."""
        return (self.results["outcome"] == FAILED_OUTCOME).any(axis=-1)

    def probability_of_failure(self) -> Probability:
        """Return how often a device or joint fails."""
        return probability(self.device_failed, self.missing)

    def of_tracks(self, place: int) -> list[Track]:
        """Return the tracks of one of the pieces, by its place in the part."""
        return [run[place] for run in self.tracks]

    def of_body(self, place: int) -> Outcomes:
        """Return the outcomes of one of the pieces, by its place in the part."""
        return Outcomes.of(self.results[..., place], self.device_failed)


FIRST_RUNS = 20
"""Runs of the room after which there is a first answer, at least."""


class Question(NamedTuple):
    """What all runs of a verification share.

    Parameters
    ----------
    scenario : Scenario
        The room.
    whole : Scene
        All pieces, as stated, in its plan.
    drawn : list of list of DrawOfSeveral
        The draws of all pieces, by motion and sample.
    floors : FloorMotions
        The motions.
    threads : int or None
        As many as there are cores where it is None. The bits do not depend on them.
    advance : callable
        Called with the number of runs just done; an exception that it raises stops the work.
    """

    scenario: Scenario
    whole: Scene
    drawn: list[list[DrawOfSeveral]]
    floors: FloorMotions
    threads: int | None
    advance: Callable[[int], None] = lambda _runs: None

    @property
    def plan(self) -> FloorPlan:
        """Its plan."""
        assert self.whole.plan is not None
        return self.whole.plan

    def run(self, parts: Sequence[RoomPart]) -> list[PartRuns]:
        """Run parts of the room, each by itself, under all draws."""
        return [*self.runs_of_each(parts)]

    def runs_of_each(self, parts: Sequence[RoomPart]) -> Generator[PartRuns]:
        """Run parts of the room, and yield what became of each, in their order, as soon as it is known.

        No thread waits for the last runs of a part, nor for what is done with them: those of the next have
        begun.

        Raises
        ------
        InputError
            Measures that cannot be put in place, as stated or in one of the draws.
        """
        motions, samples = len(self.drawn), len(self.drawn[0])
        under_way: dict[int, PartRuns] = {}

        def run(number: int, motion: int, sample: int) -> None:
            part, runs, draw = parts[number], under_way[number], self.drawn[motion][sample]
            scale = float(self.floors.scales[motion])
            shaking = drawn_shaking(self.floors.motions[motion], scale, draw, self.scenario.gravity)
            act = _run_in_plane if part.in_plane else _run_in_space
            ran = act(part, draw.of(part.bodies), shaking, self.scenario.gravity)
            results, devices, runs.peaks[motion * samples + sample], tracks = ran
            runs.results[motion, sample] = results
            runs.device_failed[motion, sample] = (devices["failure"] != HOLDS).any()
            fell = (results["outcome"] == OVERTURNED_OUTCOME).tolist()
            runs.tracks[motion * samples + sample] = [
                replace(track, overturned=overturned) for track, overturned in zip(tracks, fell, strict=True)
            ]

        def calls() -> Generator[Callable[[], None]]:
            for number, part in enumerate(parts):
                under_way[number] = PartRuns(
                    np.zeros((motions, samples, len(part.bodies)), RESULT),
                    np.zeros((motions, samples), np.bool_),
                    [[] for _ in range(motions * samples)],
                    [{} for _ in range(motions * samples)],
                )
                for place in np.ndindex(motions, samples):
                    yield partial(run, number, *place)

        left, following = [motions * samples] * len(parts), 0
        with Pool(self.threads) as pool:
            for call, _ in pool.as_completed(calls()):
                left[call // (motions * samples)] -= 1
                self.advance(1)
                while following < len(parts) and left[following] == 0:
                    following += 1
                    yield under_way.pop(following - 1)

    def with_samples(self, start: int, end: int) -> Question:
        """Return the same with some of the samples of each motion only."""
        return self._replace(drawn=[row[start:end] for row in self.drawn])

    def blocks(self) -> Iterator[tuple[int, int]]:
        """Yield ranges of the samples of each motion: a few to begin with, then as many as before again."""
        motions, samples = len(self.drawn), len(self.drawn[0])
        end = 0
        while end < samples:
            start, end = end, min(samples, max(-(-FIRST_RUNS // motions), 2 * end))
            yield start, end


def _run_in_space(
    part: RoomPart, draw: DrawOfSeveral, shaking: SpaceShaking, gravity: float
) -> tuple[NDArray[np.void], NDArray[np.void], PeakForces, list[Track]]:
    """Return RESULT of the pieces of a part, DEVICE of what holds and joins them, forces, and tracks."""
    traced = trace_draw(part.scene, draw, shaking, gravity)
    results, pieces = results_of(traced, shaking.times), [body.piece for body in traced.bodies]
    peaks: PeakForces = {}
    for place, held, rows in traced.held():
        peaks |= peak_forces(place, held, traced.trace.devices[rows], 1.0)
    return results, traced.trace.devices, peaks, tracks_of(pieces, traced.trace, shaking.dt)


def _run_in_plane(
    part: RoomPart, draw: DrawOfSeveral, shaking: SpaceShaking, gravity: float
) -> tuple[NDArray[np.void], NDArray[np.void], PeakForces, list[Track]]:
    """Return the same of the one piece of a part, run in the plane across its length."""
    (piece,), around = part.scene.pieces, part.scene.around
    seen = room_seen(piece, around, planes_around([piece], around))
    place = replace(seen, **dict.fromkeys(SIDE_WALLS))
    held, elements = drawn_held(piece.body, place, piece.measures, draw.room)
    row = case_columns(held.body, held.room, State(), gravity)
    cos, sin = math.cos(piece.heading), math.sin(piece.heading)
    along, up = shaking.acceleration[:, :2] @ [cos, sin], shaking.acceleration[:, 2]
    traced = trace(row[0], shaking_in_plane(along, up, shaking.dt, 0), elements)
    start = at_rest(placed_piece(piece, held, elements[:0]).piece, shaking.dt)
    history = traced.history
    x, z, tilt = (history[:, column] for column in (H_X, H_Z, H_TILT))
    track = track_in_plane(start, x - x[0], z - z[0], tilt)
    peaks = peak_forces(0, held, traced.devices, held.body.mass)
    return np.array([traced.result]), traced.devices, peaks, [track]
