"""Which changes of a room are worth trying: places with least harm, and measures on what does harm or falls.

Where something is least in the way is looked for by rectangles, in the runs of the room as it is: a piece is
taken to sweep elsewhere what it sweeps where it stands, turned with it. What a change brings is then told by
the runs of that room.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Sequence
from contextlib import suppress
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from stayput.errors import InputError
from stayput.model.floor_plan import FACING
from stayput.simulation.space_fate import MAY_FALL_FROM
from stayput.verification import changes
from stayput.verification.events import ENTERS_BY
from stayput.verification.options import TRIED_ALONE
from stayput.verification.people import hardest, harm_of, hits_in, risk_of

if TYPE_CHECKING:
    from stayput.model.floor_plan import PersonPlace
    from stayput.montecarlo.runs import Runs
    from stayput.scenario.measures import Option
    from stayput.simulation.groups import Track
    from stayput.verification.option_runner import OptionRunner

ALIKE = 1e-9
"""Chances that differ by no more are equal."""

SAME = 0.05
"""Distance below which another place is the one where something is already [m]."""


def tried_options(runner: OptionRunner, base: Option, runs: Runs) -> Iterator[Option]:
    """Yield the room with single changes: another place first, then measures on what does most harm.

    After them come measures on what overturns without doing harm where it stands.

    Parameters
    ----------
    runner : OptionRunner
        The room's motions and draws.
    base : Option
        The room as it is.
    runs : Runs
        Its runs, with their tracks.
    """
    scenario, names, plan = runner.scenario, runner.scenario.names, runner.plan(base)
    harmful, falling = harmful_pieces(runner, base, runs), falling_pieces(runs)
    for change in moves_of(runner, base, runs, harmful):
        runner.advance(0)  # who has left may end it here
        yield changes.with_changes(base, [change], names)

    def key(body: int) -> tuple[float, ...]:
        return body in harmful, harm_of(hardest(runs, [body]), plan.places, runs.missing), chances[body]

    chances = overturning(runs)
    for body in sorted(harmful | falling, key=key, reverse=True):
        for kind in TRIED_ALONE if scenario.pieces[body].is_furniture else ():
            (measure,) = changes.measures_for((kind,), runner.scene(base), body)
            option = changes.with_changes(base, [changes.Change(names[body], measure)], names)
            with suppress(InputError):  # it cannot be put there
                changes.refuse_unheld(runner.scene(option), body)
                yield option


def overturning(runs: Runs) -> list[float]:
    """Return the chance that each piece overturns."""
    return [outcomes.probability_of_overturning().estimate for outcomes in runs.of_bodies()]


def falling_pieces(runs: Runs) -> set[int]:
    """Return the pieces that overturn so often that they are to be held, wherever they fall."""
    return {body for body, chance in enumerate(overturning(runs)) if chance >= MAY_FALL_FROM}


def harmful_pieces(runner: OptionRunner, option: Option, runs: Runs) -> set[int]:
    """Return the pieces without which fewer would be hit or shut in, or fewer doors blocked."""
    plan, count = runner.plan(option), len(runner.scenario.names)
    harmful: set[int] = set()
    hit, blocked = hits_in(runs), int(runs.blocked.sum() + runs.shut_in.sum())
    risk = risk_of(np.any(hit, axis=2), plan.places, runs.missing)
    for body in range(count):
        others = [number for number in range(count) if number != body]
        less = risk_of(np.any(hit[..., others], axis=2), plan.places, runs.missing) < risk
        if not less and blocked:
            each = runs.tracks[:, others].tolist()
            ends = (runner.detector.ends(plan, tracks) for tracks in each)
            less = sum(sum(doors) + sum(people) for doors, people in ends) < blocked
        if less:
            harmful.add(body)
    return harmful


def moves_of(
    runner: OptionRunner, option: Option, runs: Runs, harmful: Collection[int]
) -> Iterator[changes.Change]:
    """Yield the best spot for each place at which somebody is hit, and for harmful pieces at each wall.

    Parameters
    ----------
    runner : OptionRunner
        The room's motions and draws.
    option : Option
        The room as it is.
    runs : Runs
        Its runs, with their tracks.
    harmful : collection of int
        The pieces that may be moved.
    """
    scenario, scene, plan = runner.scenario, runner.scene(option), runner.plan(option)
    floor, hit = changes.FreeFloor(plan, scene.pieces), hits_in(runs)
    swept = [swept_in_falling(tracks) for tracks in runs.tracks.T]
    for place in (plan.places[number] for number in np.flatnonzero(hit.any(axis=(0, 2))).tolist()):
        runner.advance(0)  # who has left may end it here
        others = [other for other in changes.other_places(place, floor) if _away(place, other) >= SAME]
        if others:
            over = np.any([reached(of_piece, others) for of_piece in swept], axis=0)
            share = dict(zip(others, over.mean(axis=0).tolist(), strict=True))
            other = min(others, key=lambda other: (share[other], _away(place, other)))
            yield changes.Change(other.name, at=other.at, heading=other.heading)
    for body in sorted(changes.loose_pieces(scenario) & set(harmful)):
        piece = scene.pieces[body]
        if not scenario.pieces[body].is_furniture:
            continue
        others_hit = np.any(np.delete(hit, body, axis=2), axis=2)
        risk_at = partial(_risk, others_hit, plan.places, runs.missing)
        origin, here = np.array(piece.at[:2]), risk_at(swept[body])
        for wall, middles in changes.places_at_walls(scene, body, floor):
            runner.advance(0)
            angle = FACING[wall] - piece.heading
            if abs(math.remainder(angle, 2.0 * math.pi)) < 1e-9:
                middles = [middle for middle in middles if math.dist(middle, piece.at[:2]) >= SAME]
            turned = turned_rectangles(swept[body] - origin, angle)
            best, least = None, here + 2.0 * ALIKE  # that of the same is no more
            for middle in middles:
                risk = risk_at(turned + np.array(middle))
                if risk < least - ALIKE:
                    best, least = middle, risk
            if best is not None:
                yield changes.Change(scenario.names[body], at=best, heading=FACING[wall])


def _risk(
    others_hit: NDArray[np.bool_],
    places: Sequence[PersonPlace],
    missing: NDArray[np.bool_],
    swept: NDArray[np.float64],
) -> float:
    """Return the chance that somebody is hit by other pieces or in the rectangles that one sweeps."""
    return risk_of(others_hit | reached(swept, places), places, missing)


def _away(place: PersonPlace, other: PersonPlace) -> float:
    """Return how far another place is from a place: its shift [m] and turn [rad]."""
    return math.dist(place.at, other.at) + abs(math.remainder(other.heading - place.heading, math.pi))


def swept_in_falling(tracks: Iterable[Track]) -> NDArray[np.float64]:
    """Return the rectangles that a piece sweeps in plan in the runs in which it falls [m].

    Returns
    -------
    ndarray, shape (runs, 2, 2)
        The least and the most of each; NaN where it does not fall, and so hits nobody.
    """
    return np.array([track.span[:, :2] if track.falls.any() else np.full((2, 2), np.nan) for track in tracks])


def turned_rectangles(rectangles: NDArray[np.float64], angle: float) -> NDArray[np.float64]:
    """Return rectangles around rectangles that are turned about the origin by an angle [rad]."""
    cos, sin = math.cos(angle), math.sin(angle)
    x, y = rectangles[:, [0, 0, 1, 1], 0], rectangles[:, [0, 1, 1, 0], 1]
    corners = np.stack([cos * x - sin * y, sin * x + cos * y], axis=-1)
    return np.stack([corners.min(axis=1), corners.max(axis=1)], axis=1)


def reached(rectangles: NDArray[np.float64], places: Sequence[PersonPlace]) -> NDArray[np.bool_]:
    """Return whether rectangles reach into places of people, both as seen along the walls.

    Parameters
    ----------
    rectangles : ndarray, shape (runs, 2, 2)
        The least and the most of each [m].
    places : sequence of PersonPlace
        The places.

    Returns
    -------
    ndarray of bool, shape (runs, places)
        Whether they do.
    """
    corners = np.array([place.corners for place in places]).reshape(-1, 4, 2)
    low, high = rectangles[:, np.newaxis, 0], rectangles[:, np.newaxis, 1]
    into = (low < corners.max(axis=1) - ENTERS_BY) & (high > corners.min(axis=1) + ENTERS_BY)
    return into.all(axis=-1)
