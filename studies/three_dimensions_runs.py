"""Furniture run in the plane and in space under the same earthquakes: what stands where, and the runs.

Nothing is drawn but the friction of the floor, and the same for plane and space, so that what differs between
them is the third dimension.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.measures import GelMats, LBracket, TensionPole
from stayput.model.body import Body
from stayput.model.gravity import STANDARD_GRAVITY
from stayput.model.room import Ceiling, Floor, Room, Wall
from stayput.model.solid import Solid
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.runs import run_level
from stayput.montecarlo.sampling import draws, rows_of
from stayput.motion.suites import Suite, synthetic_suite
from stayput.simulation.case import simulate
from stayput.simulation.outcome import Outcome
from stayput.uncertainty import USUAL

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.measures import Measure
    from stayput.montecarlo.hazard import FloorMotions
    from stayput.montecarlo.sampling import DrawTable
    from stayput.motion import Motion

FAMILIES = ("near-fault", "crustal")
"""Earthquakes with a pulse along x, and some without direction; those of 100 to 300 s are left out."""

LEVELS = {"5-upper": 5.25, "6-lower": 5.75, "6-upper": 6.25}
"""Classes of intensity, and the middle at which each is run."""

HEADINGS = (0.0, 30.0, 60.0, 90.0)
"""Angles in plan from the motion's x, along which pulses are, to the depth of the piece [degrees]."""

FLOORING, RUBBER = (0.40, 0.30), (0.80, 0.60)
"""Static and kinetic friction: of wood flooring, and of rubber feet (assumed)."""

ENGINES = ("plane", "stronger", "space")
"""The plane under the component along the depth; the plane under the stronger one; space under all."""

GAP, CEILING = 0.02, 2.4
"""Distance to the wall behind, where there is one, and height of the ceiling above poles [m]."""


@dataclass(frozen=True, slots=True)
class ShapeSetting:
    """A piece of furniture, and how it stands.

    Parameters
    ----------
    name : str
        What the tables call it.
    depth, length, height : float
        [m]; a round piece has its diameter as depth and length, and in the plane is a box of that width.
    mass : float
        [kg]
    round : bool
        Whether it is a cylinder.
    friction : tuple of float
        Static and kinetic, as stated.
    wall : bool
        Whether a wall stands behind it.
    measures : tuple of Measure
        What holds it; two brackets, two poles or four mats in space, one or two in the plane.
    """

    name: str
    depth: float
    length: float
    height: float
    mass: float
    round: bool = False
    friction: tuple[float, float] = FLOORING
    wall: bool = False
    measures: tuple[Measure, ...] = ()

    @property
    def is_free(self) -> bool:
        """Whether neither a wall nor a device limits it."""
        return not self.wall and not self.measures

    @property
    def body(self) -> Body:
        """The piece as a box."""
        return Body(self.depth, self.height, self.mass, length=self.length)

    def room(self, factor: float = 1.0) -> Room:
        """Return the room, the friction of its floor times a factor."""
        static, kinetic = self.friction
        ceiling = Ceiling(CEILING) if any(isinstance(one, TensionPole) for one in self.measures) else None
        behind = Wall(GAP) if self.wall else None
        return Room(Floor(factor * static, factor * kinetic), left_wall=behind, ceiling=ceiling)


RATIOS = (0.5, 2 / 3, 1.0, 1.5, 2.0)
"""Length over depth of the cabinets."""

CABINET_DEPTH, CABINET_HEIGHT, CABINET_MASS = 0.45, 1.50, 80.0
"""Size [m] and mass [kg] of the cabinets, of whatever length: a box's motion does not depend on the mass."""


def _cabinet(ratio: float, friction: tuple[float, float], wall: bool = False) -> ShapeSetting:
    length = ratio * CABINET_DEPTH
    called = "square cabinet" if ratio == 1.0 else f"cabinet {CABINET_DEPTH:.2f} × {length:.2f}"
    feet = ", rubber feet" if friction == RUBBER else ""
    name = f"{called}{feet}{', wall' if wall else ''}"
    return ShapeSetting(
        name, CABINET_DEPTH, length, CABINET_HEIGHT, CABINET_MASS, friction=friction, wall=wall
    )


def _bookcase(how: str = "", *measures: Measure) -> ShapeSetting:
    return ShapeSetting(f"bookcase{how}", 0.30, 0.90, 1.80, 200.0, wall=bool(how), measures=tuple(measures))


CABINETS = tuple(_cabinet(ratio, friction) for friction in (FLOORING, RUBBER) for ratio in RATIOS)
"""Cabinets of all lengths on both floors."""

SETTINGS = (
    _bookcase(),
    ShapeSetting("refrigerator", 0.65, 0.65, 1.75, 100.0),
    ShapeSetting("refrigerator, rubber feet", 0.65, 0.65, 1.75, 100.0, friction=RUBBER),
    ShapeSetting("low chest, rubber feet", 0.45, 0.90, 0.80, 60.0, friction=RUBBER),
    *CABINETS,
    ShapeSetting("gas cylinder", 0.25, 0.25, 1.40, 60.0, round=True),
    ShapeSetting("water heater", 0.60, 0.60, 1.70, 420.0, round=True),
    ShapeSetting("water heater, rubber feet", 0.60, 0.60, 1.70, 420.0, round=True, friction=RUBBER),
    _cabinet(1.0, FLOORING, wall=True),
    _bookcase(", wall"),
    _bookcase(", wall, brackets", LBracket()),
    _bookcase(", wall, poles", TensionPole()),
    _bookcase(", wall, gel mats", GelMats()),
)
"""What is run: free pieces, then those before a wall and held ones."""


class EngineOutcomes(NamedTuple):
    """What became of a piece, by heading and motion.

    Parameters
    ----------
    overturned, missing : ndarray of bool, shape (headings, motions)
        Whether it overturned; whether the run was given up.
    slide : ndarray, shape (headings, motions)
        Peak slide [m]: along the depth in the plane, in any direction in space.
    """

    overturned: NDArray[np.bool_]
    missing: NDArray[np.bool_]
    slide: NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Shaken:
    """Earthquakes as pieces of all headings feel them, and the draws of the floor's friction.

    Parameters
    ----------
    plane, stronger, space : tuple of Hazard
        One for each heading; of ``stronger`` there is one, since it asks for no heading.
    drawn : DrawTable
        One draw for each motion.
    """

    plane: tuple[Hazard, ...]
    stronger: tuple[Hazard, ...]
    space: tuple[Hazard, ...]
    drawn: DrawTable

    @classmethod
    def of(cls, motions: int, headings: Sequence[float], seed: int) -> Shaken:
        """Make so many motions of each family."""
        made = [motion for family in FAMILIES for motion in synthetic_suite(family, motions, seed)]
        turned = [Suite(tuple(m.rotated(math.radians(h)) for m in made), f"{h:g}°") for h in headings]
        stated = [name for name in USUAL if name != "friction"]
        return cls(
            tuple(Hazard(suite) for suite in turned),
            (Hazard(Suite(tuple(map(_stronger_first, made)), "stronger component")),),
            tuple(Hazard(suite, dimensions=3) for suite in turned),
            draws(len(made), 1, seed, as_stated=stated),
        )


def _stronger_first(motion: Motion) -> Motion:
    """Return a motion turned so that the horizontal component with the larger peak velocity is its x."""
    other = motion.rotated(0.5 * math.pi)
    return other if other.pgv > motion.pgv else motion


def outcomes(setting: ShapeSetting, intensity: float, shaken: Shaken) -> dict[str, EngineOutcomes]:
    """Run a piece at an intensity; return what became of it by engine.

    Parameters
    ----------
    setting : ShapeSetting
        The piece.
    intensity : float
        JMA's, of all three components of the ground.
    shaken : Shaken
        The earthquakes.
    """
    in_space = shaken.space[:1] if setting.round else shaken.space  # a round piece faces everywhere
    found: dict[str, EngineOutcomes] = {}
    for engine, hazards in zip(ENGINES, (shaken.plane, shaken.stronger, in_space), strict=True):
        by_heading = [_under(setting, each.at(intensity), shaken.drawn) for each in hazards]
        repeats = len(shaken.space) // len(hazards)
        found[engine] = EngineOutcomes(
            *(np.repeat(field, repeats, axis=0) for field in zip(*by_heading, strict=True))
        )
    return found


def _under(setting: ShapeSetting, floors: FloorMotions, drawn: DrawTable) -> EngineOutcomes:
    if setting.round and floors.dimensions == 3:
        return _round_in_space(setting, floors, drawn)
    rows = rows_of(
        setting.body,
        setting.room(),
        setting.measures,
        drawn,
        STANDARD_GRAVITY,
        dimensions=floors.dimensions,
    )
    (runs,) = run_level([rows], floors)
    return EngineOutcomes(runs.overturned[:, 0], runs.missing[:, 0], runs.slide[:, 0])


def _round_in_space(setting: ShapeSetting, floors: FloorMotions, drawn: DrawTable) -> EngineOutcomes:
    solid = Solid.cylinder(setting.depth, setting.height, setting.mass)
    runs = [
        simulate(solid, setting.room(float(factor)), motion.scaled(float(scale)))
        for motion, scale, factor in zip(
            floors.motions, floors.scales, drawn.columns["friction"][:, 0], strict=True
        )
    ]
    return EngineOutcomes(
        np.array([run.outcome is Outcome.OVERTURNED for run in runs]),
        np.array([run.outcome is Outcome.FAILED for run in runs]),
        np.array([float(run.peak_slide[0]) for run in runs]),
    )
