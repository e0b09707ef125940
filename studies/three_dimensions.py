"""Verdicts of the plane beside those of space: how often they differ, and for which pieces.

Nothing is drawn but the friction of the floor, and the same for plane and space, so that what differs between
them is the third dimension.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import pandas as pd
import xarray as xr

from stayput import Suite, synthetic_suite
from stayput.fragility.paired import difference
from stayput.fragility.probabilities import probability
from stayput.measures import GelMats, LBracket, TensionPole
from stayput.model.body import Body
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.room import Ceiling, Floor, Room, Wall
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.runs import run_level
from stayput.montecarlo.sampling import draws, rows_of
from stayput.simulation.case import simulate
from stayput.simulation.outcome import Outcome
from stayput.uncertainty import USUAL
from stayput.verification.notes import LONG
from studies.study import COLOURS, Quantity, Study, panels

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.fragility.paired import Difference
    from stayput.measures import Measure
    from stayput.montecarlo.hazard import FloorMotions
    from stayput.montecarlo.sampling import DrawTable
    from stayput.motion.record import Motion

FAMILIES = ("near-fault", "crustal")
"""Earthquakes with a pulse along x, and some without direction; those of 100 to 300 s are left out."""

LEVELS = {"5-upper": 5.25, "6-lower": 5.75, "6-upper": 6.25}
"""Classes of intensity, and the middle at which each is run."""

HEADINGS = (0.0, 30.0, 60.0, 90.0)
"""Angles in plan from the motion's x, along which pulses are, to the depth of the piece [degrees]."""

FLOORING, RUBBER = (0.40, 0.30), (0.80, 0.60)
"""Static and kinetic friction: of wood flooring, and of rubber feet (assumed)."""

ENGINES = PLANE, STRONGER, SPACE = ("plane", "stronger", "space")
"""The plane under the component along the depth; the plane under the stronger one; space under all."""

GAP, CEILING = 0.02, 2.4
"""Distance to the wall behind, where there is one, and height of the ceiling above poles [m]."""

CLASSES = {"short": "shorter than deep", "square": "square", "long": "1.5 times as long as deep, or more"}
"""Free boxes by shape, and what they are called; those of `ROUND` are cylinders."""

ROUND, LIMITED = "round", "limited"
"""Kinds of settings beside free boxes: free cylinders, and pieces before a wall or held."""

STRONGEST = "6-upper"
"""Class of intensity of the figure."""


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
    def body(self) -> Body:
        """The piece as a box."""
        return Body(self.depth, self.height, self.mass, length=self.length)

    @property
    def kind(self) -> str:
        """A class of `CLASSES`, `ROUND` or `LIMITED`."""
        if self.wall or self.measures:
            return LIMITED
        if self.round:
            return ROUND
        ratio = self.length / self.depth
        return "long" if ratio >= LONG - 1e-9 else "short" if ratio < 1.0 - 1e-9 else "square"

    def room(self, factor: float = 1.0) -> Room:
        """Return the room, the friction of its floor times a factor."""
        static, kinetic = self.friction
        ceiling = Ceiling(CEILING) if any(isinstance(one, TensionPole) for one in self.measures) else None
        behind = Wall(GAP) if self.wall else None
        return Room(Floor(factor * static, factor * kinetic), left_wall=behind, ceiling=ceiling)


def _cabinet(ratio: float, friction: tuple[float, float], wall: bool = False) -> ShapeSetting:
    length = ratio * 0.45
    called = "square cabinet" if ratio == 1.0 else f"cabinet 0.45 × {length:.2f}"
    name = f"{called}{', rubber feet' if friction == RUBBER else ''}{', wall' if wall else ''}"
    return ShapeSetting(name, 0.45, length, 1.50, 80.0, friction=friction, wall=wall)


def _bookcase(how: str = "", *measures: Measure) -> ShapeSetting:
    return ShapeSetting(f"bookcase{how}", 0.30, 0.90, 1.80, 200.0, wall=bool(how), measures=tuple(measures))


CABINETS = tuple(
    _cabinet(ratio, friction) for friction in (FLOORING, RUBBER) for ratio in (0.5, 2 / 3, 1.0, 1.5, 2.0)
)
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
    hazards : dict of str to tuple of Hazard
        By engine, one for each heading; of `STRONGER` there is one, since it asks for no heading.
    drawn : DrawTable
        One draw for each motion.
    """

    hazards: dict[str, tuple[Hazard, ...]]
    drawn: DrawTable

    @classmethod
    def of(cls, motions: int, headings: Sequence[float], seed: int) -> Shaken:
        """Make so many motions of each family."""
        made = [motion for family in FAMILIES for motion in synthetic_suite(family, motions, seed)]
        turned = [Suite(tuple(m.rotated(math.radians(h)) for m in made), f"{h:g}°") for h in headings]
        stated = [name for name in USUAL if name != "friction"]
        hazards = {
            PLANE: tuple(Hazard(suite) for suite in turned),
            STRONGER: (Hazard(Suite(tuple(map(_stronger_first, made)), "stronger component")),),
            SPACE: tuple(Hazard(suite, dimensions=3) for suite in turned),
        }
        return cls(hazards, draws(len(made), 1, seed, as_stated=stated))


def _stronger_first(motion: Motion) -> Motion:
    """Return a motion turned so that the horizontal component with the larger peak velocity is its x."""
    other = motion.rotated(0.5 * math.pi)
    return other if other.pgv > motion.pgv else motion


def outcomes(setting: ShapeSetting, intensity: float, shaken: Shaken) -> dict[str, EngineOutcomes]:
    """Run a piece at a JMA intensity of the ground; return what became of it by engine."""
    found: dict[str, EngineOutcomes] = {}
    headings = len(shaken.hazards[SPACE])
    for engine, hazards in shaken.hazards.items():
        if setting.round and engine == SPACE:
            hazards = hazards[:1]  # a round piece faces everywhere
        by_heading = [_under(setting, each.at(intensity), shaken.drawn) for each in hazards]
        repeats = headings // len(hazards)
        fields = zip(*by_heading, strict=True)
        found[engine] = EngineOutcomes(*(np.repeat(field, repeats, axis=0) for field in fields))
    return found


def _under(setting: ShapeSetting, floors: FloorMotions, drawn: DrawTable) -> EngineOutcomes:
    if setting.round and floors.dimensions == 3:
        return _round_in_space(setting, floors, drawn)
    held = setting.body, setting.room(), setting.measures
    (runs,) = run_level([rows_of(*held, drawn, STANDARD_GRAVITY, dimensions=floors.dimensions)], floors)
    return EngineOutcomes(runs.overturned[:, 0], runs.missing[:, 0], runs.slide[:, 0])


def _round_in_space(setting: ShapeSetting, floors: FloorMotions, drawn: DrawTable) -> EngineOutcomes:
    body = Body.cylinder(setting.depth, setting.height, setting.mass)
    factors = drawn.columns["friction"][:, 0].tolist()
    runs = [
        simulate(body, setting.room(factor), motion.scaled(float(scale)), dimensions=3)
        for motion, scale, factor in zip(floors.motions, floors.scales, factors, strict=True)
    ]
    return EngineOutcomes(
        np.array([run.outcome is Outcome.OVERTURNED for run in runs]),
        np.array([run.outcome is Outcome.FAILED for run in runs]),
        np.array([run.peak_slide for run in runs]),
    )


def three_dimensions(motions: int = 12, *, headings: Sequence[float] = HEADINGS, seed: int = 1) -> Study:
    """Study how often the verdict of the plane differs from that of space, by shape, heading and device.

    Parameters
    ----------
    motions : int
        Synthetic motions of each family, at least 2, scaled to the middle of each class of intensity.
    headings : sequence of float
        Angles in plan from the motions' x to the depth of a piece [degrees], rising.
    seed : int
        Seed of motions and of the floor's friction.

    Returns
    -------
    Study
        Data over ``setting``, ``level``, ``engine``, ``heading`` and ``motion``: whether it overturned, was
        given up (``missing``), and the peak slide [m].
    """
    shaken = Shaken.of(motions, headings, seed)
    found = [
        [list(outcomes(one, intensity, shaken).values()) for intensity in LEVELS.values()] for one in SETTINGS
    ]
    over = ("setting", "level", "engine", "heading", "motion")
    fields = zip(EngineOutcomes._fields, np.moveaxis(np.array(found, np.float64), 3, 0), strict=True)
    values = {name: (over, array if name == "slide" else array > 0.0) for name, array in fields}
    data = xr.Dataset(
        values,
        {
            "setting": [setting.name for setting in SETTINGS],
            "kind": ("setting", [setting.kind for setting in SETTINGS]),
            "level": list(LEVELS),
            "engine": list(ENGINES),
            "heading": ("heading", list(headings), {"units": "degrees"}),
            "family": ("motion", np.repeat(FAMILIES, motions)),
        },
    )
    return Study(
        name="three_dimensions",
        title="The plane or space",
        quantities=_quantities(data),
        data=data,
        figure=_drawn(data),
        tables={
            f"Overturned at {level} [%], of pieces some of which do, differences from space in percentage "
            "points with their 95 % intervals, and median slides of those that stand in both "
            "[cm]": overturned_table(data, level)
            for level in ("6-upper", "6-lower")
        },
    )


def less_space(data: xr.Dataset, engine: str) -> Difference:
    """Return the probability of overturning by an engine less that in space, paired by motion.

    Parameters
    ----------
    data : xarray.Dataset
        What is to count of the study's data: runs of one motion are taken as dependent.
    engine : str
        One of `ENGINES`.
    """
    given_up = _by_motion(data, "missing", engine) | _by_motion(data, "missing", SPACE)
    return difference(_by_motion(data, "overturned", engine), _by_motion(data, "overturned", SPACE), given_up)


def _by_motion(data: xr.Dataset, name: str, engine: str) -> NDArray[np.bool_]:
    """Return a quantity by an engine, shape (motions, runs of each)."""
    part = data[name].sel(engine=engine).transpose("motion", ...)
    return part.to_numpy().reshape(part.sizes["motion"], -1)


def differing(data: xr.Dataset, engine: str) -> float:
    """Return the share of runs whose overturning differs between an engine and space."""
    return float((data["overturned"].sel(engine=engine) != data["overturned"].sel(engine=SPACE)).mean())


def points(one: Difference) -> str:
    """Return a difference with its interval in percentage points: "−12 (−20 to −3)"."""
    ends = (f"{100.0 * value:+.0f}".replace("-", "−") for value in (one.estimate, one.low, one.high))
    return "{} ({} to {})".format(*ends)


def _quantities(data: xr.Dataset) -> dict[str, Quantity]:
    quantities = {
        "cases": Quantity("Runs of each engine", data["overturned"].size // len(ENGINES), form="d"),
        "given_up": Quantity("Runs given up, and left out", int(data["missing"].sum()), form="d"),
    }
    for engine, label in ((PLANE, "component along the depth"), (STRONGER, "stronger component")):
        share = 100.0 * differing(data, engine)
        quantities[f"{engine}_differs"] = Quantity(f"Verdicts that differ, {label} [%]", share, form=".0f")
    for kind, label in (CLASSES | {ROUND: "cylinders"}).items():
        of_kind = data.sel(setting=data["kind"] == kind)
        strongest = of_kind.sel(level=STRONGEST)
        share = 100.0 * differing(strongest, PLANE)
        quantities[f"differ_{kind}"] = Quantity(
            f"{label}: runs that differ at {STRONGEST} [%]", share, form=".0f"
        )
        for engine in (PLANE, STRONGER):
            found = points(less_space(strongest, engine))
            quantities[f"{kind}_{engine}"] = Quantity(
                f"{label}: {engine} less space at {STRONGEST} [points]", found
            )
            cells = [
                less_space(of_kind.isel(setting=[row], level=level), engine)
                for row in range(of_kind.sizes["setting"])
                for level in range(of_kind.sizes["level"])
            ]
            label_of = f"{label}: {engine} clearly too low, of {len(cells)} settings and levels"
            low = sum(cell.high < 0.0 for cell in cells)
            quantities[f"{kind}_{engine}_less"] = Quantity(label_of, low, form="d")
    return quantities


def overturned_table(data: xr.Dataset, level: str) -> pd.DataFrame:
    """Return a row for each setting of which some overturn at a level."""
    rows: list[dict[str, str]] = []
    for place, name in enumerate(data["setting"].to_numpy().tolist()):
        part = data.isel(setting=place).sel(level=level)
        shares = 100.0 * part["overturned"].mean(("heading", "motion"))
        if not shares.any():
            continue
        row = {"piece": name}
        row |= {engine: f"{float(shares.sel(engine=engine)):.0f}" for engine in ENGINES}
        row["differ"] = f"{100.0 * differing(part, PLANE):.0f}"
        row |= {f"{engine} − space": points(less_space(part, engine)) for engine in (PLANE, STRONGER)}
        stands = ~part["overturned"].sel(engine=[PLANE, SPACE]).any("engine")
        for engine in (PLANE, SPACE):
            slides = 100.0 * float(part["slide"].sel(engine=engine).where(stands).median())
            row[f"slide, {engine}"] = "" if np.isnan(slides) else f"{slides:.1f}"
        rows.append(row)
    return pd.DataFrame(rows)


def _drawn(data: xr.Dataset) -> Figure:
    """Draw the share of cabinets that overturns over their length in planes and space, with intervals."""
    figure, axes = panels(2, width=5.0, sharey=True)
    half = len(CABINETS) // 2
    floors = {"wood flooring": CABINETS[:half], "rubber feet": CABINETS[half:]}
    for axis, (floor, cabinets) in zip(axes, floors.items(), strict=True):
        ratio = np.array([one.length / one.depth for one in cabinets])
        for engine, shift, colour in zip(ENGINES, (-0.02, 0.02, 0.0), COLOURS, strict=False):
            parts = [data.sel(setting=one.name, level=STRONGEST) for one in cabinets]
            found = [probability(_by_motion(part, "overturned", engine)) for part in parts]
            middle, low, high = (
                100.0 * np.array([getattr(one, end) for one in found]) for end in ("estimate", "low", "high")
            )
            ends = np.stack([middle - low, high - middle])
            axis.errorbar(ratio + shift, middle, yerr=ends, fmt="-o", color=colour, label=engine)
        axis.set(title=floor, xlabel="length over depth", ylim=(-3.0, 103.0))
    axes[0].set_ylabel(f"cabinets that overturn at {STRONGEST} [%]")
    axes[0].legend()
    return figure
