"""Fallen gravestones against intensity, beside surveys: what closes the gap, and what does not.

Upper stones of Japanese gravestones. Widths of 8, 9 and 10 sun (24.2, 27.3, 30.3 cm) are those that
stonemasons sell most, with 7 and 11 sun; that the upper stone is a square prism of about two and a half times
its width is assumed, and so are the shares.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME
from stayput.model.body import Body
from stayput.model.parameters import STANDARD_GRAVITY
from stayput.model.room import Floor, Room
from stayput.montecarlo.sampling import draws, rows_of
from stayput.montecarlo.scaled_motions import factors_to_level_zero
from stayput.motion.suites.synthesis import synthetic_suite
from stayput.report.palette import ALARM, INK, MUTED
from stayput.simulation.case import simulate
from stayput.simulation.many import run_columns
from stayput.uncertainty import USUAL, Lognormal, Normal, random_bits, uniforms
from studies.study import Quantity, Study, claim, panels

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.montecarlo.sampling import DrawTable
    from stayput.motion.record import Motion
    from stayput.motion.suites.suite import Suite

SUN = 0.0303
"""A sun, a tenth of a shaku [m]."""

WIDTHS = {7: 0.10, 8: 0.40, 9: 0.25, 10: 0.20, 11: 0.05}
"""Widths of upper stones [sun] and their shares: the widths are sold, the shares assumed."""

DENSITY = 2650.0
"""Granite [kg/m³]."""

OBSERVED = {
    "5-upper": (5.25, 0.0, 0.23),
    "6-lower": (5.75, 0.13, 0.56),
    "6-upper": (6.25, 0.40, 0.90),
    "7": (6.75, 0.90, 1.0),
}
"""Classes of intensity, the middle at which each is run (7 has none), and shares that fell.

Hakuba 2014 at about 5-upper and 6-lower; the scale of the Yamagata survey of 2019.
"""

IN_SPACE, SPACE_STEP = 3, 1e-3
"""Stones of each place that are moved in space, where a run takes a tenth of a second; longest step [s]."""


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
        Median of height over width; its coefficient of variation is 10 % (assumed).
    smaller : float
        Factor on all sizes.
    base : float
        Part of the width that the base stands on: edges that are worn or rounded.
    lean : float
        Standard deviation of the stones' lean [degrees], to either side.
    friction : tuple of float
        Static and kinetic, of granite on granite (assumed).
    restitution : float
        Factor on Housner's rate: stone-like blocks of aspect 5 on concrete (ElGawady).
    drawn : bool
        Whether friction, landings and all else that a verdict draws is drawn; else stones are as stated, and
        the first `IN_SPACE` of each place stand for all, so that planes and space have the same.
    space : bool
        Whether stones are moved in space, by all components.
    stone_scatter, place_scatter : float
        Standard deviation of the intensity from stone to stone, and from the stated one to a place's.
    """

    name: str = "as stated"
    family: str = "crustal"
    vertical: bool = True
    both: bool = False
    aspect: float = 2.5
    smaller: float = 1.0
    base: float = 1.0
    lean: float = 0.0
    friction: tuple[float, float] = (0.6, 0.5)
    restitution: float = 0.95
    drawn: bool = True
    space: bool = False
    stone_scatter: float = 0.0
    place_scatter: float = 0.0


STATED = CemeterySetting()
_IDEAL = replace(STATED, name="ideal stones, nothing drawn: in one plane", drawn=False, restitution=1.0)
IDEALS = (
    _IDEAL,
    replace(_IDEAL, name="ideal stones, nothing drawn: in either of two planes", both=True),
    replace(_IDEAL, name="ideal stones, nothing drawn: in space", space=True),
)
"""Ideal stones by what moves them: the same otherwise."""

SETTINGS = (
    STATED,
    CemeterySetting("intensity scatters by 0.5 from stone to stone", stone_scatter=0.5),
    CemeterySetting("intensity scatters by 0.5 from place to place", place_scatter=0.5),
    CemeterySetting("slenderer: height 3 times the width", aspect=3.0),
    CemeterySetting("slenderer: height 3.5 times the width", aspect=3.5),
    CemeterySetting("stockier: height 2 times the width", aspect=2.0),
    CemeterySetting("three quarters of all sizes (old stones)", smaller=0.75),
    CemeterySetting("worn edges: 90 % of the base", base=0.9),
    CemeterySetting("worn edges: 75 % of the base", base=0.75),
    CemeterySetting("stones lean by 1° (standard deviation)", lean=1.0),
    CemeterySetting("stones lean by 3°", lean=3.0),
    CemeterySetting("friction 0.4 and 0.35", friction=(0.4, 0.35)),
    CemeterySetting("landings of 0.85 times Housner's rate", restitution=0.85),
    CemeterySetting("near-fault motions", family="near-fault"),
    CemeterySetting("without vertical motion", vertical=False),
    CemeterySetting("falls in either of two planes", both=True),
    *IDEALS,
    CemeterySetting(
        "together: 90 % of the base, lean 1°, near-fault, either plane, 0.3 from stone to stone",
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


def upper_stones(setting: CemeterySetting, count: int, seed: int) -> list[Body]:
    """Return the upper stones of a cemetery: their sizes drawn, their bases and leans as in the setting."""
    of_width, of_aspect, of_lean = (_drawn(seed, place, count=count) for place in range(3))
    sun = np.array(list(WIDTHS))[np.searchsorted(np.cumsum(list(WIDTHS.values())), of_width)]
    width = setting.smaller * SUN * sun
    height = width * Lognormal(setting.aspect, 0.10).quantile(of_aspect)
    lean = np.zeros(count)
    if setting.lean:
        lean = np.deg2rad(Normal(0.0, setting.lean, -8.0, 8.0).quantile(of_lean))
    bodies: list[Body] = []
    for b, h, tilt in zip(width.tolist(), height.tolist(), lean.tolist(), strict=True):
        m, base = DENSITY * b**2 * h, setting.base * b
        feet = base * math.tan(tilt)
        inertia, heights = m * (b**2 + h**2) / 12.0, (max(feet, 0.0), max(-feet, 0.0))
        bodies.append(Body(base, h, m, inertia=inertia, base_heights=heights))
    return bodies


def cemeteries(
    setting: CemeterySetting, motions: int, count: int, seed: int
) -> tuple[NDArray[np.bool_], int]:
    """Run the stones under every motion at every level: each motion stands for a place, and its stones.

    Returns
    -------
    fell : ndarray of bool, shape (levels, motions, stones)
        Whether a stone fell.
    given_up : int
        Runs that were given up, counted as standing.
    """
    suite = synthetic_suite(setting.family, motions, seed)
    factors = factors_to_level_zero(JMA_INTENSITY, suite)
    if not setting.drawn:
        count = min(count, IN_SPACE)
    stones = upper_stones(setting, count, seed)
    if setting.space:
        return _fallen_in_space(setting, suite, factors, stones), 0
    drawn = draws(motions, count, seed, as_stated=() if setting.drawn else tuple(USUAL))
    room = Room(Floor(*setting.friction, restitution=setting.restitution))
    of_each = (_of_stone(drawn, place) for place in range(count))
    rows = [rows_of(b, room, (), one, STANDARD_GRAVITY) for b, one in zip(stones, of_each, strict=True)]
    cases = np.stack([one.cases for one in rows], axis=1)
    apart = np.zeros((motions, count))
    if setting.stone_scatter:
        u = _drawn(seed, 3, count=motions * count).reshape(motions, count)
        apart += Normal(0.0, setting.stone_scatter).quantile(u)
    if setting.place_scatter:
        apart += Normal(0.0, setting.place_scatter).quantile(_drawn(seed, 4, count=motions))[:, np.newaxis]
    place = np.repeat(np.arange(motions), count)
    fell, given_up = np.zeros((len(OBSERVED), motions, count), np.bool_), 0
    for component in ("x", "y") if setting.both else ("x",):
        shaking = [_along(motion, component, setting.vertical) for motion in suite]
        for row, (level, *_) in enumerate(OBSERVED.values()):
            cases["scale"] = 10.0 ** (0.5 * (level + apart)) * factors[:, np.newaxis]
            results, _ = run_columns(cases.ravel(), None, shaking, place)
            fell[row] |= (results["outcome"] == OVERTURNED_OUTCOME).reshape(motions, count)
            given_up += int((results["outcome"] == FAILED_OUTCOME).sum())
    return fell, given_up


def _fallen_in_space(
    setting: CemeterySetting, suite: Suite, factors: NDArray[np.float64], bodies: list[Body]
) -> NDArray[np.bool_]:
    """Run stones in space under every motion at every level: square prisms on whole bases."""
    room = Room(Floor(*setting.friction))
    stones = [Body.box(body.width, body.width, body.height, body.mass) for body in bodies]
    fell = np.zeros((len(OBSERVED), len(suite), len(bodies)), np.bool_)
    for row, (level, *_) in enumerate(OBSERVED.values()):
        for place, motion in enumerate(suite):
            scaled = motion.scaled(float(10.0 ** (0.5 * level) * factors[place]))
            fell[row, place] = [
                simulate(stone, room, scaled, dimensions=3, step=SPACE_STEP).overturned for stone in stones
            ]
    return fell


def _of_stone(drawn: DrawTable, place: int) -> DrawTable:
    """Return the draws of one stone under every motion."""
    columns = {name: column[:, place : place + 1] for name, column in drawn.columns.items()}
    return replace(drawn, columns=columns)


def _along(motion: Motion, component: str, vertical: bool) -> Motion:
    """Return a motion in the plane of one horizontal component."""
    return replace(motion, x=motion.components[component], y=None, z=motion.z if vertical else None)


def tombstones(
    motions: int = 32, *, stones: int = 24, settings: Sequence[CemeterySetting] = SETTINGS, seed: int = 1
) -> Study:
    """Study which share of gravestones falls at each class of intensity, changing one assumption at a time.

    Upper stones stand loose on flat bases and rock in one plane. Each motion stands for a place: the mean
    share is over all places, its spread from place to place that of the motions.

    Parameters
    ----------
    motions : int
        Earthquakes, at least 2, each scaled to the middle of each class.
    stones : int
        Stones of a place.
    settings : sequence of CemeterySetting
        What is assumed; the first is the setting as stated.
    seed : int
        Seed of motions, sizes and draws.

    Returns
    -------
    Study
        Data over ``setting``, ``level`` and ``place``.
    """
    found = [cemeteries(setting, motions, stones, seed) for setting in settings]
    _, low, high = np.array(list(OBSERVED.values())).T
    data = xr.Dataset(
        {
            "share": (("setting", "level", "place"), np.stack([fell.mean(axis=2) for fell, _ in found])),
            "observed_low": ("level", low),
            "observed_high": ("level", high),
        },
        {"setting": [setting.name for setting in settings], "level": list(OBSERVED)},
    )
    met = inside(data)
    mean = 100.0 * data["share"].isel(setting=0).mean("place")
    quantities = {
        f"share_{level.replace('-', '_')}": Quantity(
            f"Share that falls at {level}, {STATED.name} [%]",
            f"{float(mean.sel(level=level)):.0f}",
            f"{100.0 * low:.0f} to {100.0 * high:.0f}",
        )
        for level, (_, low, high) in OBSERVED.items()
    }
    counts = met.sum("level").to_numpy().tolist()
    for key, label, count in (
        ("met", "as stated", counts[0]),
        ("most_alone", "the most with one change", max(counts[1:-1], default=0)),
        ("together", "with the last row's changes", counts[-1]),
    ):
        quantities[key] = Quantity(f"Classes within what was observed, {label}", count, len(OBSERVED), "d")
    quantities["given_up"] = Quantity(
        "Runs given up, counted as standing", sum(lost for _, lost in found), form="d"
    )
    return Study(
        name="tombstones",
        title="Fallen gravestones and intensity",
        quantities=quantities,
        data=data,
        figure=_figure(data),
        tables={
            "Share of the stones that fall [%]: mean over the places, and the tenth and ninth tenth of the "
            "places in brackets": shares_table(data)
        },
        claims=tuple(
            claim(
                f"Gravestones, surveys: JMA {level}",
                f"{100.0 * low:.0f} to {100.0 * high:.0f} % fell",
                f"{float(mean.sel(level=level)):.0f} %, {STATED.name}",
                int(met.isel(setting=0).sel(level=level)),
                1,
            )
            for level, (_, low, high) in OBSERVED.items()
        ),
    )


def inside(data: xr.Dataset) -> xr.DataArray:
    """Return whether the mean share is within what was observed, over setting and level."""
    mean = data["share"].mean("place")
    return (mean >= data["observed_low"]) & (mean <= data["observed_high"])


def shares_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each setting, the observed shares first."""
    observed = {level: f"{100 * low:.0f} to {100 * high:.0f}" for level, (_, low, high) in OBSERVED.items()}
    rows = [{"setting": "**observed**", **observed, "within": ""}]
    met = inside(data).sum("level").to_numpy().tolist()
    for place, name in enumerate(data["setting"].to_numpy().tolist()):
        row = {"setting": name}
        for level in OBSERVED:
            share = 100.0 * data["share"].isel(setting=place).sel(level=level).to_numpy()
            low, high = np.quantile(share, [0.1, 0.9])
            row[level] = f"{share.mean():.0f} ({low:.0f} to {high:.0f})"
        rows.append(row | {"within": f"{met[place]} of {len(OBSERVED)}"})
    return pd.DataFrame(rows)


def _figure(data: xr.Dataset) -> Figure:
    """Draw the mean share of each setting over the classes, over the bands that were observed."""
    figure, (axis,) = panels(1, width=9.5, height=5.4)
    across = np.arange(len(OBSERVED), dtype=np.float64)
    low, high = 100.0 * data["observed_low"], 100.0 * data["observed_high"]
    axis.bar(across, high - low, 0.86, low, color="#b9d9ee", label="observed")
    mean = 100.0 * data["share"].mean("place")
    last = mean.sizes["setting"] - 1
    for place, shift in enumerate(np.linspace(-0.36, 0.36, last + 1)):
        colour = ALARM if place == 0 else INK if place == last else MUTED
        label = str(mean["setting"][place].item()) if place in (0, last) else "_"
        axis.plot(across + shift, mean.isel(setting=place), "o", color=colour, label=label)
    axis.set_xticks(across, list(OBSERVED))
    axis.set(xlabel="class of intensity", ylabel="stones that fall [%]; grey: one change each")
    figure.legend(loc="outside lower center", ncols=2, frameon=False)
    return figure
