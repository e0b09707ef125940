"""Which changes of a room are worth trying: places with least harm, and measures on what does harm or falls.

Where something is least in the way is looked for in the runs of the room as it is: a piece moves elsewhere as
it moves where it stands, turned with it. What a change brings is then told by runs of its own.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import suppress
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from stayput.errors import InputError
from stayput.model.floor_plan import FACING, PersonPlace
from stayput.simulation.groups import Track, outline_of
from stayput.simulation.space_fate import MAY_FALL_FROM
from stayput.verification import changes
from stayput.verification.options import TRIED_ALONE
from stayput.verification.people import hardest, harm_of, hits_in, risk_of

if TYPE_CHECKING:
    from stayput.montecarlo.runs import Runs
    from stayput.scenario.measures import Option
    from stayput.simulation.piece import Piece
    from stayput.verification.contest import Contest
    from stayput.verification.events import Ways

ALIKE = 1e-9
"""Chances that differ by no more are equal."""

SAME = 0.05
"""Distance below which another place is the one where something is already [m]."""


def tried_options(contest: Contest, base: Option, runs: Runs) -> Iterator[Option]:
    """Yield the room with single changes: another place first, then measures on what does most harm.

    After them come measures on what overturns without doing harm where it stands.

    Parameters
    ----------
    contest : Contest
        The room's motions and draws.
    base : Option
        The room as it is.
    runs : Runs
        Its runs, with their tracks.
    """
    scenario, names, plan = contest.scenario, contest.scenario.names, contest.plan(base)
    harmful, falling = harmful_pieces(contest, base, runs), falling_pieces(runs)
    for change in moves_of(contest, base, runs, harmful):
        contest.advance(0)  # who has left may end it here
        yield changes.with_changes(base, [change], names)

    def key(body: int) -> tuple[float, ...]:
        return body in harmful, harm_of(hardest(runs, [body]), plan.places, runs.missing), chances[body]

    chances = overturning(runs)
    for body in sorted(harmful | falling, key=key, reverse=True):
        for kind in TRIED_ALONE if scenario.pieces[body].is_furniture else ():
            (measure,) = changes.measures_for((kind,), contest.scene(base), body)
            option = changes.with_changes(base, [changes.Change(names[body], measure)], names)
            with suppress(InputError):  # it cannot be put there
                changes.refuse_unheld(contest.scene(option), body)
                yield option


def overturning(runs: Runs) -> list[float]:
    """Return the chance that each piece overturns."""
    return [outcomes.probability_of_overturning().estimate for outcomes in runs.of_bodies()]


def falling_pieces(runs: Runs) -> set[int]:
    """Return the pieces that overturn so often that they are to be held, wherever they fall."""
    return {body for body, chance in enumerate(overturning(runs)) if chance >= MAY_FALL_FROM}


def harmful_pieces(contest: Contest, option: Option, runs: Runs) -> set[int]:
    """Return the pieces without which fewer would be hit or shut in, or fewer doors blocked."""
    plan, count = contest.plan(option), len(contest.scenario.names)
    harmful: set[int] = set()
    hit, blocked = hits_in(runs), int(runs.blocked.sum() + runs.shut_in.sum())
    risk = risk_of(np.any(hit, axis=3), plan.places, runs.missing)
    for body in range(count):
        others = [number for number in range(count) if number != body]
        less = risk_of(np.any(hit[..., others], axis=3), plan.places, runs.missing) < risk
        if not less and blocked:
            each = runs.tracks[..., others].reshape(-1, count - 1).tolist()
            ends = (contest.watcher.ends(plan, tracks) for tracks in each)
            less = sum(sum(doors) + sum(people) for doors, people in ends) < blocked
        if less:
            harmful.add(body)
    return harmful


def moves_of(
    contest: Contest, option: Option, runs: Runs, harmful: Collection[int]
) -> Iterator[changes.Change]:
    """Yield the best spot for each place at which somebody is hit, and for harmful pieces at each wall.

    Parameters
    ----------
    contest : Contest
        The room's motions and draws.
    option : Option
        The room as it is.
    runs : Runs
        Its runs, with their tracks.
    harmful : collection of int
        The pieces that may be moved.
    """
    scenario, scene, plan, tracks = contest.scenario, contest.scene(option), contest.plan(option), runs.tracks
    _, ways = contest.watcher.ways(plan)
    floor, hit = changes.FreeFloor(plan, scene.pieces), hits_in(runs)
    outlines = [[reach(track) for track in tracks[..., body].ravel()] for body in range(len(scene.pieces))]
    struck = np.flatnonzero(hit.any(axis=(0, 1, 3))).tolist()
    if struck:  # where nobody is hit, what the pieces sweep is not needed
        over: NDArray[np.bool_] = np.any([swept(ways, of_piece) for of_piece in outlines], axis=0)
        for place in (plan.places[number] for number in struck):
            other = _best_place(place, changes.other_places(place, floor), over, contest, ways)
            if other is not None:
                yield changes.Change(other.name, at=other.at, heading=other.heading)
    cells = [ways.cells(place.corners) for place in plan.places]

    def risk(others: NDArray[np.bool_], outlines: Sequence[NDArray[np.float64]]) -> float:
        over = swept(ways, outlines)
        by_piece = np.stack([over[:, at].any(axis=1) for at in cells], -1) if cells else over[:, :0]
        return risk_of(others | by_piece.reshape(others.shape), plan.places, runs.missing)

    for body in sorted(changes.loose_pieces(scenario) & set(harmful)):
        if not scenario.pieces[body].is_furniture:
            continue
        risk_at = partial(risk, np.any(np.delete(hit, body, axis=3), axis=3))
        here = risk_at(outlines[body])
        for wall, middles in changes.places_at_walls(scene, body, floor):
            piece = scene.pieces[body]
            at = _best_at_wall(piece, wall, middles, outlines[body], risk_at, here, contest.advance)
            if at is not None:
                yield changes.Change(scenario.names[body], at=at, heading=FACING[wall])


def _best_at_wall(
    piece: Piece,
    wall: str,
    middles: list[tuple[float, float]],
    outlines: Sequence[NDArray[np.float64]],
    risk_at: Callable[[Sequence[NDArray[np.float64]]], float],
    here: float,
    advance: Callable[[int], None],
) -> tuple[float, float] | None:
    """Return where along a wall a piece does least harm, if no more than here.

    It is taken to reach there what it reaches here, turned with it.
    """
    angle = FACING[wall] - piece.heading
    same, origin = abs(math.remainder(angle, 2.0 * math.pi)) < 1e-9, np.array(piece.at[:2])
    cos, sin = math.cos(angle), math.sin(angle)
    turned = [(outline - origin) @ np.array([[cos, sin], [-sin, cos]]) for outline in outlines]
    best, least = None, here + 2.0 * ALIKE  # that of the same is no more
    for middle in middles:
        if same and math.dist(middle, piece.at[:2]) < SAME:
            continue
        advance(0)
        risk = risk_at([outline + np.array(middle) for outline in turned])
        if risk < least - ALIKE:
            best, least = middle, risk
    return best


def _best_place(
    here: PersonPlace, others: list[PersonPlace], over: NDArray[np.bool_], contest: Contest, ways: Ways
) -> PersonPlace | None:
    """Return where a place is hit least, the nearest of those that are alike."""

    def away(place: PersonPlace) -> float:
        shift = math.hypot(place.at[0] - here.at[0], place.at[1] - here.at[1])
        return shift + abs(math.remainder(place.heading - here.heading, math.pi))

    def key(place: PersonPlace) -> tuple[float, float]:
        contest.advance(0)
        share = over[:, ways.cells(place.corners)].any(axis=1).mean()
        return float(share), away(place)

    return min((place for place in others if away(place) >= SAME), key=key, default=None)


def reach(track: Track) -> NDArray[np.float64]:
    """Return the outline of all that a piece reaches at any time and height in a run [m], shape (n, 2)."""
    return outline_of(track.corners().reshape(-1, 3))


def swept(ways: Ways, outlines: Sequence[NDArray[np.float64]]) -> NDArray[np.bool_]:
    """Return over which cells of the floor a piece moves in each run at most, shape (runs, nx · ny).

    They are those within its `reach`: a place outside is not hit.
    """
    return np.array([ways.covered([outline]).ravel() for outline in outlines])
