"""Upper stones of Japanese gravestones under earthquakes: sizes, settings that change one thing, and runs.

Widths of 8, 9 and 10 sun (24.2, 27.3, 30.3 cm) are those that stonemasons sell most, with 7 and 11 sun; that
the upper stone is a square prism of about two and a half times its width is assumed, and so are the shares.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np

from stayput.fragility import JMA_INTENSITY
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME
from stayput.model.body import Body
from stayput.model.gravity import STANDARD_GRAVITY
from stayput.model.room import Floor, Room
from stayput.model.solid import Solid
from stayput.montecarlo.hazard import factors_to_level_zero
from stayput.montecarlo.sampling import draws, rows_of
from stayput.motion.suites import synthetic_suite
from stayput.randomness import random_bits, uniforms
from stayput.simulation.case import simulate
from stayput.simulation.columns import run_columns
from stayput.uncertainty import USUAL, Lognormal, Normal

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.montecarlo.sampling import DrawTable
    from stayput.motion import Motion
    from stayput.motion.suites import Suite

SUN = 0.0303
"""A sun, a tenth of a shaku [m]."""

WIDTHS = {7: 0.10, 8: 0.40, 9: 0.25, 10: 0.20, 11: 0.05}
"""Widths of upper stones [sun] and their shares: the widths are sold, the shares assumed."""

ASPECT, ASPECT_COV = 2.5, 0.10
"""Height over width: median and coefficient of variation (assumed)."""

DENSITY = 2650.0
"""Granite [kg/m³]."""

FRICTION = (0.6, 0.5)
"""Static and kinetic friction of granite on granite (assumed)."""

RESTITUTION = 0.95
"""Rotation rate after a landing over Housner's: stone-like blocks of aspect 5 on concrete (ElGawady)."""

LEVELS = {"5-upper": 5.25, "6-lower": 5.75, "6-upper": 6.25, "7": 6.75}
"""Classes of intensity, and the middle at which each is run; 7 has no middle."""

OBSERVED = {"5-upper": (0.0, 0.23), "6-lower": (0.13, 0.56), "6-upper": (0.40, 0.90), "7": (0.90, 1.0)}
"""Shares that fell: Hakuba 2014 at about 5-upper and 6-lower; the scale of the Yamagata survey of 2019."""


@dataclass(frozen=True, slots=True)
class CemeterySetting:
    """What is assumed of stones, places and earthquakes.

    Parameters
    ----------
    name : str
        What differs from the setting as stated.
    family : str
        Earthquakes.
    vertical : bool
        Whether the vertical motion acts.
    both : bool
        Whether a stone falls where it does in either of two planes, along x and along y.
    aspect : float
        Median of height over width.
    smaller : float
        Factor on all sizes.
    base : float
        Part of the width that the base stands on: edges that are worn or rounded.
    lean : float
        Standard deviation of the stones' lean [degrees], to either side.
    friction : tuple of float
        Static and kinetic.
    restitution : float
        Factor on Housner's rate.
    settlement : float
        How far a stone sinks into the joint under it [m].
    drawn : bool
        Whether friction, landings and all else that a verdict draws is drawn; else stones are as stated, and
        the first `IN_SPACE` of each place stand for all, so that planes and space have the same.
    space : bool
        Whether stones are moved in space, by all components.
    stone_scatter, place_scatter : float
        Standard deviation of the intensity from stone to stone, and from the stated one to a place's.
    """

    name: str
    family: str = "crustal"
    vertical: bool = True
    both: bool = False
    aspect: float = ASPECT
    smaller: float = 1.0
    base: float = 1.0
    lean: float = 0.0
    friction: tuple[float, float] = field(default=FRICTION)
    restitution: float = RESTITUTION
    settlement: float = 0.0
    drawn: bool = True
    space: bool = False
    stone_scatter: float = 0.0
    place_scatter: float = 0.0


IN_SPACE = 3
"""Stones of each place that are moved in space, where a run takes a tenth of a second."""

SPACE_STEP = 1e-3
"""Longest step in space [s]."""

STATED = CemeterySetting("as stated")
_IDEAL = replace(STATED, name="ideal stones, nothing drawn: in one plane", drawn=False, restitution=1.0)
IDEALS = (
    _IDEAL,
    replace(_IDEAL, name="ideal stones, nothing drawn: in either of two planes", both=True),
    replace(_IDEAL, name="ideal stones, nothing drawn: in space", space=True),
)
"""Ideal stones by what moves them: the same otherwise."""

SETTINGS = (
    STATED,
    replace(STATED, name="intensity scatters by 0.3 from stone to stone", stone_scatter=0.3),
    replace(STATED, name="intensity scatters by 0.5 from stone to stone", stone_scatter=0.5),
    replace(STATED, name="intensity scatters by 0.3 from place to place", place_scatter=0.3),
    replace(STATED, name="intensity scatters by 0.5 from place to place", place_scatter=0.5),
    replace(STATED, name="slenderer: height 3 times the width", aspect=3.0),
    replace(STATED, name="slenderer: height 3.5 times the width", aspect=3.5),
    replace(STATED, name="stockier: height 2 times the width", aspect=2.0),
    replace(STATED, name="three quarters of all sizes (old stones)", smaller=0.75),
    replace(STATED, name="worn edges: 90 % of the base", base=0.9),
    replace(STATED, name="worn edges: 75 % of the base", base=0.75),
    replace(STATED, name="stones lean by 1° (standard deviation)", lean=1.0),
    replace(STATED, name="stones lean by 3°", lean=3.0),
    replace(STATED, name="friction 0.4 and 0.35", friction=(0.4, 0.35)),
    replace(STATED, name="friction 0.8 and 0.7", friction=(0.8, 0.7)),
    replace(STATED, name="landings of 0.85 times Housner's rate", restitution=0.85),
    replace(STATED, name="joints that give by 0.1 mm", settlement=1e-4),
    replace(STATED, name="joints that give by 0.5 mm", settlement=5e-4),
    replace(STATED, name="near-fault motions", family="near-fault"),
    replace(STATED, name="subduction motions", family="subduction"),
    replace(STATED, name="without vertical motion", vertical=False),
    replace(STATED, name="falls in either of two planes", both=True),
    *IDEALS,
    replace(
        STATED,
        name="together: 90 % of the base, lean 1°, near-fault, either plane, 0.3 from stone to stone",
        family="near-fault",
        both=True,
        base=0.9,
        lean=1.0,
        stone_scatter=0.3,
    ),
)
"""The setting as stated, those that change one thing, and several changes together."""


def _drawn(*key: int, count: int) -> NDArray[np.float64]:
    """Return uniform numbers of a stream, shape (count,)."""
    return uniforms(random_bits(2014, *key).random_raw(count))


def stones(setting: CemeterySetting, count: int, seed: int) -> list[Body]:
    """Return the upper stones of a cemetery: their sizes drawn, their bases and leans as in the setting."""
    of_width, of_aspect, of_lean = (_drawn(seed, place, count=count) for place in range(3))
    sun = np.array(list(WIDTHS))[np.searchsorted(np.cumsum(list(WIDTHS.values())), of_width)]
    width = setting.smaller * SUN * sun
    height = width * Lognormal(setting.aspect, ASPECT_COV).quantile(of_aspect)
    mass = DENSITY * width**2 * height
    lean = np.zeros(count)
    if setting.lean:
        lean = np.deg2rad(Normal(0.0, setting.lean, -8.0, 8.0).quantile(of_lean))
    bodies: list[Body] = []
    for b, h, m, tilt in zip(width.tolist(), height.tolist(), mass.tolist(), lean.tolist(), strict=True):
        base = setting.base * b
        feet = base * math.tan(tilt)
        bodies.append(
            Body(
                base,
                h,
                m,
                inertia=m * (b**2 + h**2) / 12.0,
                base_heights=(max(feet, 0.0), max(-feet, 0.0)),
            )
        )
    return bodies


@dataclass(frozen=True, slots=True, eq=False)
class CemeteryFalls:
    """Which stones fell.

    Parameters
    ----------
    fell : ndarray of bool, shape (levels, motions, stones)
        Whether a stone fell.
    given_up : int
        Runs that were given up, counted as standing.
    """

    fell: NDArray[np.bool_]
    given_up: int


def cemeteries(setting: CemeterySetting, motions: int, count: int, seed: int) -> CemeteryFalls:
    """Run the stones under every motion at every level: each motion stands for a place, and its stones.

    Parameters
    ----------
    setting : CemeterySetting
        What is assumed.
    motions, count : int
        Earthquakes, and stones of each place.
    seed : int
        Seed of motions, sizes and draws.
    """
    suite = synthetic_suite(setting.family, motions, seed)
    factors = factors_to_level_zero(JMA_INTENSITY, suite)
    if not setting.drawn:
        count = min(count, IN_SPACE)
    if setting.space:
        return _fallen_in_space(setting, suite, factors, stones(setting, count, seed))
    drawn = draws(motions, count, seed, as_stated=() if setting.drawn else tuple(USUAL))
    room = Room(Floor(*setting.friction, restitution=setting.restitution, settlement=setting.settlement))
    cases = np.stack(
        [
            rows_of(stone, room, (), _of_stone(drawn, place), STANDARD_GRAVITY).cases
            for place, stone in enumerate(stones(setting, count, seed))
        ],
        axis=1,
    )
    apart = np.zeros((motions, count))
    if setting.stone_scatter:
        u = _drawn(seed, 3, count=motions * count).reshape(motions, count)
        apart += Normal(0.0, setting.stone_scatter).quantile(u)
    if setting.place_scatter:
        apart += Normal(0.0, setting.place_scatter).quantile(_drawn(seed, 4, count=motions))[:, np.newaxis]
    place = np.repeat(np.arange(motions), count)
    fell = np.zeros((len(LEVELS), motions, count), np.bool_)
    given_up = 0
    for component in ("x", "y") if setting.both else ("x",):
        shaking = [_along(motion, component, setting.vertical) for motion in suite]
        for row, level in enumerate(LEVELS.values()):
            cases["scale"] = 10.0 ** (0.5 * (level + apart)) * factors[:, np.newaxis]
            results, _ = run_columns(cases.ravel(), None, shaking, place, progress=False)
            fell[row] |= (results["outcome"] == OVERTURNED_OUTCOME).reshape(motions, count)
            given_up += int((results["outcome"] == FAILED_OUTCOME).sum())
    return CemeteryFalls(fell, given_up)


def _fallen_in_space(
    setting: CemeterySetting, suite: Suite, factors: NDArray[np.float64], bodies: list[Body]
) -> CemeteryFalls:
    """Run stones in space under every motion at every level: square prisms on whole bases."""
    room = Room(Floor(*setting.friction))
    fell = np.zeros((len(LEVELS), len(suite), len(bodies)), np.bool_)
    for place, motion in enumerate(suite):
        for row, level in enumerate(LEVELS.values()):
            scaled = motion.scaled(float(10.0 ** (0.5 * level) * factors[place]))
            for number, body in enumerate(bodies):
                stone = Solid.box(body.width, body.width, body.height, body.mass)
                run = simulate(stone, room, scaled, step=SPACE_STEP)
                fell[row, place, number] = run.overturned[0]
    return CemeteryFalls(fell, 0)


def _of_stone(drawn: DrawTable, place: int) -> DrawTable:
    """Return the draws of one stone under every motion."""
    columns = {name: column[:, place : place + 1] for name, column in drawn.columns.items()}
    return replace(drawn, columns=columns)


def _along(motion: Motion, component: str, vertical: bool) -> Motion:
    """Return a motion in the plane of one horizontal component."""
    x = motion.components[component]
    return replace(motion, x=x, y=None, z=motion.z if vertical else None)
