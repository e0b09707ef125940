"""The baseline: what the ideal block leaves out and is worth, and where bare furniture lies in the field.

Published medians of unanchored furniture are formulas where they could be read (`LOSS_MODEL`,
`stayput.estimates`); what was observed are shares in rooms. Both stand beside the simulation, nothing fitted.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from stayput import Suite, synthetic_suite
from stayput.estimates import kaneko_hayashi_velocity
from stayput.fragility.curve import FragilityCurve
from stayput.fragility.intensity_measures import JMA_INTENSITY, PFV
from stayput.fragility.trials import Trials
from stayput.measures import Held
from stayput.model.body import FURNITURE, Body
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.room import SURFACES, Floor, Room, Wall
from stayput.montecarlo.runs import run_level, run_levels
from stayput.montecarlo.sampling import draws, rows_of
from stayput.montecarlo.scaled_motions import ScaledMotions
from stayput.report.palette import INK
from stayput.scenario.tables import BuildingTable
from stayput.uncertainty import USUAL
from studies.study import Quantity, Study, claim, panels

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    import pandas as pd
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.montecarlo.sampling import Rows
    from stayput.motion.record import Motion

LEVELS: NDArray[np.float64] = np.arange(4.0, 7.61, 0.15)
"""JMA intensities at which every body is run."""

PIECES = ("bookcase", "cupboard", "chest", "wardrobe")
"""Presets of which the effects are told."""

AT_HOME = ("bookcase", "empty bookcase", "wardrobe", "cupboard", "chest", "refrigerator", "television")
"""Presets of a home, whose mean share is set beside what surveys tell of furniture at home."""

WOOD = Floor.of("wood flooring")
IDEAL = Room(Floor(WOOD.static_friction, WOOD.kinetic_friction))
"""Where the ideal block stands: free, on a rigid floor; it lands by Housner's rule."""

STANDS = 0.02
"""Gap to the wall behind in the rows with one [m]; it is the default of the app."""

STUDS, STUD_DAMPING = 45.0, 0.05
"""Mass that two studs with boards on both sides move where a piece of 1.8 m hits them [kg]: half of it, 22 kg
over the span, for either is in the first mode, which has half its swing there. Damping ratio, assumed."""

IDEAL_BLOCK = "the ideal block, free"
FREE, WALL = "as a verdict draws it, free", f"as a verdict draws it, a wall {100 * STANDS:g} cm behind"
"""Settings of the published sizes."""

STOREYS, GROUND_LEVELS = (1, 5, 10), (5.25, 5.75, 6.25)
"""Storeys of a reinforced-concrete building of ten, and JMA intensities of its ground."""

OBSERVED = {
    "5-upper": (5.25, "JMA's table: unfixed furniture may fall", (0.01, 0.1)),
    "6-lower": (5.75, "JMA's table: most of it moves, some falls", (0.02, 0.25)),
    "6-upper": (6.25, "JMA's table: nearly all of it moves, more of it falls", (0.2, 0.6)),
    "7": (6.75, "JMA's table: nearly all moves or falls; Kobe: it fell in 60 % of the rooms", (0.5, 1.0)),
}
"""JMA's classes: the middle of each, its explanatory table and the architects' survey of Kobe (of houses that
stood), and what the words are taken to mean here, as shares of pieces that fall."""

REPORTED = {
    "low storeys: about 20 %": (0.1, 0.3),
    "middle storeys: about 40 %": (0.3, 0.5),
    "upper storeys: over 60 %": (0.6, 1.0),
}
"""Furniture that fell in Kobe, by storey, the ground at 6-lower to 7 (second hand); and as a range."""


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

    @property
    def body(self) -> Body:
        """A uniform block of its size."""
        return Body(self.width, self.height, 100.0)


LOSS_MODEL = tuple(
    Published(f"{name} in", 0.0254 * depth, 0.0254 * height, velocity)
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


def panel_restitution(effective: float, panel: float, damping: float) -> float:
    """Return e_w, the part of its speed that a wall that gives returns to what hits it.

    Derived for the theory page; `tests/validation/test_panel.py` sets it beside two masses stepped in time.

    Parameters
    ----------
    effective : float
        m, of the piece at the height of the impact [kg].
    panel : float
        M, of the panel's first mode at the place of the impact [kg].
    damping : float
        Its damping ratio ζ, below 1.
    """
    together = effective + panel
    zeta = damping * math.sqrt(panel / together)
    root = math.sqrt(1.0 - zeta * zeta)
    phase = math.pi - math.atan2(2.0 * zeta * root, 1.0 - 2.0 * zeta * zeta)
    return effective / together * math.exp(-zeta * phase / root)


def _studs(body: Body) -> Held:
    """Return a wall of studs: a rigid one that returns as much of the speed."""
    x, z = body.centre_of_gravity
    about_front = body.inertia_about_cg + body.mass * ((body.width / 2 - x) ** 2 + z**2)
    returned = panel_restitution(about_front / body.height**2, STUDS, STUD_DAMPING)
    return _wall(STANDS, returned)(body)


def _raised(factor: float) -> Callable[[Body], Held]:
    return _body(cg_offset=lambda body: (0.0, 0.5 * (factor - 1.0) * body.height))


CARPET = SURFACES["carpet"].settlement

EFFECTS = (
    Effect("feet or plinth 2 % of the depth inside either edge", "geometry; assumed", _inset(0.02)),
    Effect("feet or plinth 4 % inside, or edges rounded so far", "geometry; assumed", _inset(0.04)),
    Effect("soft feet at the edges that sink in by 1 mm", "closed form; assumed", _soft_feet(1e-3)),
    Effect("a flat base on wood flooring, 0.05 mm", "assumed", _floor(settlement=WOOD.settlement)),
    Effect("a flat base on tatami, 0.5 mm", "assumed", _floor(settlement=0.5e-3)),
    Effect("a flat base on carpet, 1 mm", "Barnett 2020: tips 40 % easier", _floor(settlement=CARPET)),
    Effect(
        "the same, and its landings lose like rubber's, 0.67",
        "ElGawady, rubber; aspect 5",
        _floor(settlement=CARPET, restitution=0.67),
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
    Effect(
        "the stronger of the two horizontal directions", "bound", lambda body: Held(body, IDEAL), turned=True
    ),
    Effect("no vertical motion", "bound", lambda body: Held(body, IDEAL), vertical=False),
    Effect("a wall behind, touching", "the app's choice", _wall(0.0)),
    Effect("a wall 2 cm behind", "default, not measured", _wall(STANDS)),
    Effect("a wall 5 cm behind", "the same", _wall(0.05)),
    Effect("a wall 2 cm behind that returns 0.6 of the speed", "upper end of the draws", _wall(STANDS, 0.6)),
    Effect("a wall of two studs with boards 2 cm behind", "law of the theory page", _studs),
)
"""What the ideal block leaves out."""


def turned(motion: Motion) -> Motion:
    """Return a motion turned so that its peak horizontal velocity lies along x."""
    angles = np.linspace(0.0, math.pi, 36, endpoint=False)
    return max((motion.rotated(float(angle)) for angle in angles), key=lambda one: one.pgv)


def run_baselines(rows: Sequence[Rows], scaled_motions: ScaledMotions) -> xr.Dataset:
    """Run pieces at all levels.

    Returns
    -------
    xarray.Dataset
        ``velocity`` [m/s] and ``intensity`` at which half of each piece's runs overturn, NaN where that was
        not reached, over ``row``; ``share`` that overturns, over ``row`` and ``level``.
    """
    floors_at = cache(scaled_motions.at)
    falls = run_levels(rows, LEVELS, floors_at)
    medians: list[list[float]] = []
    for im in (PFV, JMA_INTENSITY):
        strength = np.stack([floors_at(float(level)).values(im) for level in LEVELS])
        trials = [Trials.from_runs(im, strength, one.overturned, one.missing) for one in falls]
        medians.append([FragilityCurve("", one).capacity(0.5).estimate for one in trials])
    shares = np.stack([one.overturned.mean(axis=(1, 2)) for one in falls])
    fields = {"velocity": ("row", medians[0]), "intensity": ("row", medians[1])}
    return xr.Dataset(fields | {"share": (("row", "level"), shares)})


def run_storeys(rows: Sequence[Rows], ground: Suite) -> NDArray[np.float64]:
    """Return the share of each piece that falls, shape [storey, level, piece]."""
    building = BuildingTable(storeys=STOREYS[-1], structure="RC")
    by_storey = [ScaledMotions(ground, building, storey) for storey in STOREYS]
    return np.array(
        [
            [[runs.overturned.mean() for runs in run_level(rows, one.at(level))] for level in GROUND_LEVELS]
            for one in by_storey
        ]
    )


def baseline(motions: int = 32, *, samples: int = 8, seed: int = 1) -> Study:
    """Tell what each thing that the ideal block leaves out is worth, and compare with the field.

    Parameters
    ----------
    motions : int
        Motions of the mixed built-in suite, at least 2, scaled to each intensity.
    samples : int
        Draws for each motion where a verdict's uncertain quantities are drawn.
    seed : int
        Seed of motions and draws.

    Returns
    -------
    Study
        Data over ``effect`` and ``piece``, over ``published`` and ``setting``, and over ``home`` and
        ``level``, and ``storey`` and ``ground``.
    """
    ground = synthetic_suite("mixed", motions, seed)

    @cache
    def motions_of(is_turned: bool = False, vertical: bool = True) -> ScaledMotions:
        return ScaledMotions(Suite(tuple(map(turned, ground))) if is_turned else ground, vertical=vertical)

    def drawn(bodies: Sequence[Body], wall: Wall | None) -> list[Rows]:
        room = Room(WOOD, left_wall=wall)
        return [rows_of(body, room, (), draws(motions, samples, seed), STANDARD_GRAVITY) for body in bodies]

    def stated(held: Sequence[Held]) -> list[Rows]:
        none_drawn = draws(motions, 1, seed, as_stated=tuple(USUAL))
        return [rows_of(one.body, one.room, (), none_drawn, STANDARD_GRAVITY) for one in held]

    def settings(bodies: Sequence[Body]) -> dict[str, xr.Dataset]:
        rows = {
            IDEAL_BLOCK: stated([Held(body, IDEAL) for body in bodies]),
            FREE: drawn(bodies, None),
            WALL: drawn(bodies, Wall(STANDS)),
        }
        return {name: run_baselines(of, motions_of()) for name, of in rows.items()}

    pieces, home = [_preset(name) for name in PIECES], [_preset(name) for name in AT_HOME]
    effects = settings(pieces) | {
        one.name: run_baselines(
            stated([one.held(body) for body in pieces]), motions_of(one.turned, one.vertical)
        )
        for one in EFFECTS
    }
    by_effect = xr.concat(list(effects.values()), xr.Variable("effect", list(effects))).rename(row="piece")
    field = settings([one.body for one in LOSS_MODEL])
    by_setting = xr.concat(list(field.values()), xr.Variable("setting", list(field))).rename(row="published")
    at_home = drawn(home, Wall(STANDS))
    ideal = by_effect.sel(effect=IDEAL_BLOCK)
    data = xr.Dataset(
        {
            "velocity": by_effect["velocity"].assign_attrs(units="m/s", long_name="median floor velocity"),
            "ratio": by_effect["velocity"] / ideal["velocity"],
            "shift": by_effect["intensity"] - ideal["intensity"],
            "simulated": by_setting["velocity"].assign_attrs(units="m/s"),
            "loss_model": ("published", [one.velocity for one in LOSS_MODEL], {"units": "m/s"}),
            "formula": (
                "published",
                [kaneko_hayashi_velocity(one.body) for one in LOSS_MODEL],
                {"units": "m/s"},
            ),
            "share": run_baselines(at_home, motions_of())["share"].rename(row="home"),
            "storey_share": (("storey", "ground", "home"), run_storeys(at_home, ground)),
        },
        {
            "piece": list(PIECES),
            "published": [one.name for one in LOSS_MODEL],
            "home": list(AT_HOME),
            "level": LEVELS,
            "storey": list(STOREYS),
            "ground": list(GROUND_LEVELS),
        },
    )
    return Study(
        name="baseline",
        title="The baseline: what the ideal block leaves out, and the field",
        quantities=_quantities(data),
        data=data,
        figure=_drawn(data),
        tables={
            "What the ideal block leaves out: peak floor velocity at which half overturn, over the ideal "
            "block's, and the mean change of the JMA intensity at which half do": effects_table(data),
            "Published medians, all of them formulas, and ours: peak floor velocity at which half overturn "
            "[cm/s]": field_table(data),
        },
        claims=tuple(claims(data)),
    )


def _preset(name: str) -> Body:
    preset = FURNITURE[name]
    return Body(preset.width, preset.height, preset.mass)


def field_of(data: xr.Dataset, setting: str, published: str = "formula") -> float:
    """Return the geometric mean of a setting's medians over the published ones.

    It is of the sizes that have a median in every setting, so that settings can be compared.
    """
    known = data["simulated"].notnull().all("setting")
    return float(mean_ratio((data["simulated"].sel(setting=setting) / data[published]).where(known)))


def mean_ratio(ratios: xr.DataArray, over: str | None = None) -> xr.DataArray:
    """Return the geometric mean of the ratios that are known."""
    logs: xr.DataArray = xr.apply_ufunc(np.log, ratios)
    return xr.apply_ufunc(np.exp, logs.mean(over))


def _quantities(data: xr.Dataset) -> dict[str, Quantity]:
    found: dict[str, Quantity] = {}
    for key, setting in {"ideal": IDEAL_BLOCK, "free": FREE, "wall": WALL}.items():
        for published, name in {"formula": "Kaneko and Hayashi's formula", "loss_model": "FEMA P-58"}.items():
            label = f"Median over {name}, {setting}"
            found[f"{key}_{published}"] = Quantity(label, field_of(data, setting, published), 1.0, ".2f")
    return found


def effects_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each thing left out: the ratio for every piece, and the shift of intensity."""
    table = data["ratio"].to_pandas().round(2).rename_axis("left out", axis=0)
    table["mean"] = mean_ratio(data["ratio"], "piece").round(2).to_numpy()
    table["JMA"] = data["shift"].mean("piece").round(2).to_numpy()
    sources = {effect.name: effect.source for effect in EFFECTS}
    table.insert(0, "source", [sources.get(name, "") for name in table.index])
    return table.reset_index()


def field_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each published piece: its medians by formula and by simulation [cm/s]."""
    table = 100.0 * data["simulated"].transpose("published", "setting").to_pandas()
    table.insert(0, "Kaneko and Hayashi", 100.0 * data["formula"].to_numpy())
    table.insert(0, "FEMA P-58", 100.0 * data["loss_model"].to_numpy())
    return table.round(0).rename_axis("piece, depth × height").reset_index()


def claims(data: xr.Dataset) -> list[dict[str, str]]:
    """Return what was observed and what formulas say, beside a verdict with everything drawn."""
    found: list[dict[str, str]] = []
    at_home = data["share"].mean("home")
    for name, (level, words, (low, high)) in OBSERVED.items():
        share = float(at_home.interp(level=level))
        ours = f"{100 * share:.0f} % of seven pieces fall, a wall {100 * STANDS:g} cm behind"
        found.append(claim(f"Furniture at home, JMA {name}", words, ours, int(low <= share <= high), 1))
    by_storey = data["storey_share"].mean("home")
    for storey, (reported, (low, high)) in zip(STOREYS, REPORTED.items(), strict=True):
        weak, strong = (float(by_storey.sel(storey=storey, ground=level)) for level in GROUND_LEVELS[1:])
        ours = (
            f"storey {storey} of {STOREYS[-1]}: {100 * weak:.0f} to {100 * strong:.0f} %, the ground at "
            f"{GROUND_LEVELS[1]:g} to {GROUND_LEVELS[2]:g}"
        )
        met = 2 if low <= weak and strong <= high else int(weak <= high and strong >= low)
        found.append(claim("Kobe 1995 by storey (second hand)", reported, ours, met, 2))
    for published, name in (
        ("formula", "Kaneko and Hayashi's formula, free pieces"),
        ("loss_model", "FEMA P-58's formula, unanchored"),
    ):
        free, wall = (field_of(data, setting, published) for setting in (FREE, WALL))
        ours = f"{free:.2f} times it free, {wall:.2f} times with a wall {100 * STANDS:g} cm behind"
        met = int(abs(free - 1.0) <= 0.2)
        found.append(claim(name, "median velocities of nine pieces", ours, met, 2))
    return found


def _drawn(data: xr.Dataset) -> Figure:
    """Draw the ratio to the ideal block's median for each thing left out: the mean, and every piece."""
    ratios = data["ratio"].isel(effect=slice(1, None))
    rows = np.arange(ratios.sizes["effect"])
    figure, (axis,) = panels(1, width=11.5, height=10.0)
    means = mean_ratio(ratios, "piece").to_numpy()
    axis.barh(rows, means - 1.0, 0.7, 1.0, color="#b9d9ee", edgecolor=INK, linewidth=0.5, label="mean")
    for piece, marker in zip(PIECES, "os^D", strict=True):
        axis.plot(ratios.sel(piece=piece), rows, marker, color=INK, fillstyle="none", label=piece)
    axis.axvline(1.0, color=INK, linewidth=1.0)
    axis.set_yticks(rows, ratios["effect"].to_numpy())
    axis.set(ylim=(len(rows) - 0.5, -0.5), xlabel="median floor velocity, over the ideal free block's [–]")
    axis.legend(loc="center right")
    return figure
