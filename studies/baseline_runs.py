"""Runs of the baseline study: what the ideal block leaves out, one thing at a time, and published sizes."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from stayput.fragility import JMA_INTENSITY, PFV, Trials, fragility_curve
from stayput.measures import Element, Held
from stayput.measures.element import Line, damper
from stayput.model.gravity import STANDARD_GRAVITY
from stayput.model.panel import panel_restitution
from stayput.model.room import SURFACES, Floor, Room, Wall
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.levels import run_levels
from stayput.montecarlo.runs import run_level
from stayput.montecarlo.sampling import draws, rows_of, stated_rows
from stayput.motion.suites import Suite
from stayput.scenario.building import BuildingTable

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

    from stayput.fragility import FragilityCurve
    from stayput.model.body import Body
    from stayput.montecarlo.sampling import Rows
    from stayput.motion import Motion

LEVELS: NDArray[np.float64] = np.arange(4.0, 7.61, 0.15)
"""JMA intensities at which every body is run."""

PIECES = ("bookcase", "cupboard", "chest", "wardrobe")
"""Presets of which the effects are told."""

WOOD = Floor.of("wood flooring")
IDEAL = Room(Floor(WOOD.static_friction, WOOD.kinetic_friction))
"""Where the ideal block stands: free, on a rigid floor; it lands by Housner's rule."""

STANDS = 0.02
"""Gap to the wall behind in the rows with one [m]; it is the default of the app."""

PARTITION = 100e3
"""Stiffness of a partition wall at the height of the piece's top, in the rows with a massless one [N/m]."""

STUDS = 45.0
"""Mass that two studs with boards on both sides move where a piece of 1.8 m hits them [kg]: half of it, 22 kg
over the span, for either is in the first mode, which has half its swing there."""

STUD_DAMPING = 0.05
"""Damping ratio of such a wall; assumed."""


@dataclass(frozen=True, slots=True)
class Effect:
    """One thing that the ideal block leaves out.

    Parameters
    ----------
    name : str
        What it is, with its value.
    source : str
        Where the value comes from.
    held : callable
        Given the ideal body, what stands instead, and where.
    turned : bool
        Whether motions are turned so that the piece has the stronger horizontal direction across its depth.
    vertical : bool
        Whether the vertical motion acts.
    """

    name: str
    source: str
    held: Callable[[Body], Held]
    turned: bool = False
    vertical: bool = True


def _body(**change: Callable[[Body], object]) -> Callable[[Body], Held]:
    return lambda body: Held(replace(body, **{name: of(body) for name, of in change.items()}), IDEAL)


def _floor(**change: float) -> Callable[[Body], Held]:
    return lambda body: Held(body, replace(IDEAL, floor=replace(IDEAL.floor, **change)))


def _inset(share: float) -> Callable[[Body], Held]:
    return _body(base_insets=lambda body: (share * body.width, share * body.width))


def _soft_feet(settlement: float) -> Callable[[Body], Held]:
    """Return feet at the edges that sink in: E/mg = a²/(2z) − w₀/2, so that a'² = a² − z w₀."""

    def inset(body: Body) -> tuple[float, float]:
        a, z = body.width / 2, body.centre_of_gravity[1]
        less = a - math.sqrt(max(0.0, a * a - z * settlement))
        return less, less

    return _body(base_insets=inset)


def _lean(angle: float) -> Callable[[Body], Held]:
    return _body(base_heights=lambda body: (0.0, -angle * body.width))


def _wall(gap: float, restitution: float = Wall(0.0).restitution) -> Callable[[Body], Held]:
    return lambda body: Held(body, replace(IDEAL, left_wall=Wall(gap, restitution)))


def _studs(body: Body) -> Held:
    """Return a wall of studs: a rigid one that returns as much of the speed."""
    x, z = body.centre_of_gravity
    about_front = body.inertia_about_cg + body.mass * ((body.width / 2 - x) ** 2 + z**2)
    effective = about_front / body.height**2
    wall = Wall(STANDS, restitution=panel_restitution(effective, STUDS, STUD_DAMPING))
    return Held(body, replace(IDEAL, left_wall=wall))


def _partition(damping: float) -> Callable[[Body], Held]:
    """Return a wall without a mass: a spring, damped so far with the whole mass of the piece on it."""

    def held(body: Body) -> Held:
        push = Line(PARTITION, damper(damping, PARTITION, body.mass), slack_minus=STANDS)
        element = Element("wall", (-body.width / 2, body.height), push, facing=(1.0, 0.0))
        return Held(body, IDEAL, (element,))

    return held


def _raised(factor: float) -> Callable[[Body], Held]:
    return _body(cg_offset=lambda body: (0.0, 0.5 * (factor - 1.0) * body.height))


def _unchanged(body: Body) -> Held:
    return Held(body, IDEAL)


SOFT = "law of the theory page; the sinking is assumed"
CARPET = SURFACES["carpet"].settlement
RUBBER = 0.67
"""Measured restitution of a block on rubber over Housner's (ElGawady), for a carpet that damps like it."""

EFFECTS = (
    Effect("feet or plinth 2 % of the depth inside either edge", "geometry; assumed", _inset(0.02)),
    Effect("feet or plinth 4 % inside, or edges rounded so far", "geometry; assumed", _inset(0.04)),
    Effect("soft feet at the edges that sink in by 1 mm", "closed form; assumed", _soft_feet(1e-3)),
    Effect("a flat base on wood flooring, 0.05 mm", SOFT, _floor(settlement=WOOD.settlement)),
    Effect("a flat base on tatami, 0.5 mm", SOFT, _floor(settlement=0.5e-3)),
    Effect("a flat base on carpet, 1 mm", "Barnett 2020: tips 40 % easier", _floor(settlement=CARPET)),
    Effect(
        "the same, and its landings lose like rubber's, 0.67",
        "ElGawady, rubber; aspect 5",
        _floor(settlement=CARPET, restitution=RUBBER),
    ),
    Effect("landings push at 2/3 of half the base", "Kalliontzis et al. 2016", _floor(landing_place=2 / 3)),
    Effect("landings push at 1/3 of half the base", "bodies on springs", _floor(landing_place=1 / 3)),
    Effect("landings of 0.95 times Housner's rate", "ElGawady, concrete", _floor(restitution=0.95)),
    Effect("landings of 0.9 times Housner's rate", "assumed", _floor(restitution=0.9)),
    Effect("the floor leans forward, or a bulged base tips, by 3/1000", "Japanese quality act", _lean(0.003)),
    Effect("the floor leans forward by 6/1000", "the same; a likely defect", _lean(0.006)),
    Effect(
        "a fifth of the inertia is loose shelves, doors, contents",
        "bound, assumed",
        _body(inertia=lambda body: 0.8 * body.uniform_inertia),
    ),
    Effect("the centre of gravity 10 % lower", "heavy below; assumed", _raised(0.9)),
    Effect("the centre of gravity 10 % higher", "heavy above; assumed", _raised(1.1)),
    Effect("friction 0.3 and 0.25", "field's values", _floor(static_friction=0.3, kinetic_friction=0.25)),
    Effect("friction 0.6 and 0.5", "field's values", _floor(static_friction=0.6, kinetic_friction=0.5)),
    Effect("the stronger of the two horizontal directions", "bound until space", _unchanged, turned=True),
    Effect("no vertical motion", "bound", _unchanged, vertical=False),
    Effect("a wall behind, touching", "the app's choice", _wall(0.0)),
    Effect("a wall 2 cm behind", "default, not measured", _wall(STANDS)),
    Effect("a wall 5 cm behind", "the same", _wall(0.05)),
    Effect("a wall 2 cm behind that returns 0.6 of the speed", "upper end of the draws", _wall(STANDS, 0.6)),
    Effect("a wall of two studs with boards 2 cm behind", "law of the theory page", _studs),
    Effect("a spring of 100 kN/m 2 cm behind that returns 0.4", "bound: wall without mass", _partition(0.2)),
    Effect("the same that returns 0.8 of the speed", "the same, hardly damped", _partition(0.05)),
)
"""What the ideal block leaves out."""


@dataclass(frozen=True, slots=True)
class Published:
    """A published median of unanchored furniture.

    Parameters
    ----------
    name : str
        Its id and what it is.
    width, height : float
        Depth and height [m].
    velocity : float
        Median peak floor velocity at which it overturns [m/s].
    """

    name: str
    width: float
    height: float
    velocity: float


INCH = 0.0254

LOSS_MODEL = tuple(
    Published(f"{name} in", depth * INCH, height * INCH, velocity)
    for name, depth, height, velocity in (
        ("E2022.102a bookcase, 2 shelves, 12⅝ × 29", 12.625, 29.0, 0.724),
        ("E2022.103a bookcase, 3 shelves, 12⅝ × 41", 12.625, 41.0, 0.493),
        ("E2022.104a bookcase, 4 shelves, 12⅝ × 56", 12.625, 56.0, 0.361),
        ("E2022.105a bookcase, 5 shelves, 12⅝ × 71", 12.625, 71.0, 0.290),
        ("E2022.106a bookcase, 6 shelves, 12⅝ × 81¼", 12.625, 81.25, 0.251),
        ("E2022.112a filing cabinet, 2 drawers, 15 × 24", 15.0, 24.0, 1.229),
        ("E2022.114a filing cabinet, 4 drawers, 15 × 52", 15.0, 52.0, 0.498),
        ("E2022.124a lateral cabinet, 18.6 × 52.5", 18.6, 52.5, 0.688),
        ("E2022.125a lateral cabinet, 18.6 × 67.75", 18.6, 67.75, 0.526),
    )
)
"""Unanchored furniture of FEMA P-58 (second edition), as its fragility library lists it.

Its notes say how the velocities were found: "calculated as a function of the aspect ratio". They are a
formula's, not observations.
"""

AT_HOME = ("bookcase", "empty bookcase", "wardrobe", "cupboard", "chest", "refrigerator", "television")
"""Presets of a home, whose mean share is set beside what surveys tell of furniture at home."""


STOREYS, GROUND_LEVELS = (1, 5, 10), (5.25, 5.75, 6.25)
"""Storeys of a reinforced-concrete building of ten, and JMA intensities of its ground."""


@dataclass(frozen=True, slots=True, eq=False)
class Baseline:
    """What bodies do in one setting.

    Parameters
    ----------
    velocity, intensity : FragilityCurve
        Shares that overturn over the floor's peak velocity and over JMA's intensity.
    shares : ndarray, shape [level]
        Share that overturns at each of `LEVELS`.
    """

    velocity: FragilityCurve
    intensity: FragilityCurve
    shares: NDArray[np.float64]

    @property
    def median_velocity(self) -> float:
        """Peak floor velocity at which half overturn [m/s]; NaN where it was not reached."""
        return self.velocity.capacity(0.5).estimate

    @property
    def median_intensity(self) -> float:
        """JMA intensity at which half overturn; NaN where it was not reached."""
        return self.intensity.capacity(0.5).estimate


def turned(motion: Motion) -> Motion:
    """Return a motion turned so that its peak horizontal velocity lies along x."""
    angles = np.linspace(0.0, math.pi, 36, endpoint=False)
    return max((motion.rotated(float(angle)) for angle in angles), key=lambda one: one.pgv)


def hazards(ground: Suite) -> Callable[[Effect | None], Hazard]:
    """Return the motions of each effect; those of equal kind are prepared once."""

    @cache
    def prepared(is_turned: bool, vertical: bool) -> Hazard:
        motions = Suite(tuple(turned(motion) for motion in ground)) if is_turned else ground
        return Hazard(motions, vertical=vertical)

    return lambda effect: (
        prepared(False, True) if effect is None else prepared(effect.turned, effect.vertical)
    )


def run_baselines(rows: Sequence[Rows], hazard: Hazard, progress: Callable[[int], None]) -> list[Baseline]:
    """Run pieces at all levels, every run of them."""
    floors_at = cache(hazard.at)
    falls, _ = run_levels(rows, LEVELS, floors_at, progress=progress)
    measures = [floors_at(float(level)).measures for level in LEVELS]
    found: list[Baseline] = []
    for one in falls:
        velocity, intensity = (
            fragility_curve(
                Trials.from_runs(
                    im, np.stack([at_level[im] for at_level in measures]), one.overturned, one.missing
                )
            )
            for im in (PFV, JMA_INTENSITY)
        )
        found.append(Baseline(velocity, intensity, one.overturned.mean(axis=(1, 2))))
    return found


def run_storeys(rows: Sequence[Rows], ground: Suite, progress: Callable[[int], None]) -> NDArray[np.float64]:
    """Return the share of each piece that falls, shape [storey, level, piece]."""
    building = BuildingTable(storeys=STOREYS[-1], structure="RC")
    return np.array(
        [
            [
                [runs.overturned.mean() for runs in run_level(rows, hazard.at(level), progress=progress)]
                for level in GROUND_LEVELS
            ]
            for hazard in (Hazard(ground, building, storey) for storey in STOREYS)
        ]
    )


def ideal_rows(held: Held, motions: int) -> Rows:
    """Return one row for each motion, of a piece as it stands."""
    return stated_rows(held, motions, STANDARD_GRAVITY)


def default_rows(body: Body, motions: int, samples: int, seed: int, *, wall: bool) -> Rows:
    """Return rows as a verdict has them: on wood flooring, with everything drawn that is drawn there."""
    room = Room(WOOD, left_wall=Wall(STANDS) if wall else None)
    return rows_of(body, room, (), draws(motions, samples, seed), STANDARD_GRAVITY)
