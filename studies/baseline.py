"""The baseline: what the ideal block leaves out and is worth, and where bare furniture lies in the field.

Published medians of unanchored furniture are formulas where they could be read (`baseline_runs.LOSS_MODEL`,
`stayput.estimates`); what was observed are shares in rooms. Both stand beside the simulation, nothing fitted.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
import xarray as xr

from stayput.errors import whole_within
from stayput.estimates import LOSS_MODEL_RATIO, kaneko_hayashi_velocity
from stayput.measures import Held
from stayput.model.body import Body
from stayput.model.furniture import FURNITURE
from stayput.motion.suites import synthetic_suite
from stayput.progress import bar
from stayput.report.figures import FONT, new_figure, plain_log, style
from stayput.report.palette import INK, MUTED
from studies.baseline_runs import (
    AT_HOME,
    EFFECTS,
    GROUND_LEVELS,
    IDEAL,
    LEVELS,
    LOSS_MODEL,
    PIECES,
    STANDS,
    STOREYS,
    Baseline,
    default_rows,
    hazards,
    ideal_rows,
    run_baselines,
    run_storeys,
)
from studies.study import NO, PARTLY, YES, Claim, Quantity, Study, outcome_of, span

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from stayput.montecarlo.sampling import Rows
    from studies.baseline_runs import Effect

CLASSES = {"5-upper": 5.25, "6-lower": 5.75, "6-upper": 6.25, "7": 6.75}
"""JMA classes of the table of observations, and the intensity in the middle of each."""

OBSERVED = {
    "5-upper": "JMA's table: unfixed furniture may fall",
    "6-lower": "JMA's table: most of it moves, some falls",
    "6-upper": "JMA's table: nearly all of it moves, more of it falls",
    "7": "JMA's table: nearly all moves or falls; Kobe: furniture fell in about 60 % of the rooms of houses "
    "that stood",
}
"""What was observed: JMA's explanatory table, and the survey of Kobe by architects."""

WORDS = {"5-upper": (0.01, 0.1), "6-lower": (0.02, 0.25), "6-upper": (0.2, 0.6), "7": (0.5, 1.0)}
"""What JMA's words are taken to mean here, as shares of pieces that fall: may, some, more, nearly all."""

REPORTED = {
    "low storeys: about 20 %": (0.1, 0.3),
    "middle storeys: about 40 %": (0.3, 0.5),
    "upper storeys: over 60 %": (0.6, 1.0),
}
"""Furniture that fell in Kobe, by storey, the ground at 6-lower to 7 (second hand); and as a range."""

EFFECTS_CAPTION = (
    "What the ideal block leaves out: peak floor velocity at which half overturn, over the ideal block's, "
    "and the mean change of the JMA intensity at which half do; – where half do not by 7.6"
)
FIELD_CAPTION = (
    "Published medians, all of them formulas, and ours: peak floor velocity at which half overturn [cm/s]; "
    "in brackets over Kaneko and Hayashi's and over FEMA P-58's; – where half do not by intensity 7.6"
)
HOME_CAPTION = "Observed, and the share of pieces at home that fall in a verdict, a wall 2 cm behind [%]"
STOREY_CAPTION = (
    "Kobe by storey, as reported at second hand, and the mean share of seven pieces at home that fall in a "
    "verdict [%]: ten storeys of reinforced concrete, by the intensity of the ground"
)

FREE, WALL = "as a verdict draws it, free", f"as a verdict draws it, a wall {100 * STANDS:g} cm behind"


def baseline(motions: int = 48, *, samples: int = 8, seed: int = 1) -> Study:
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
        Figures "effects" and "field". Data over ``effect`` and ``piece``, over ``published`` and ``setting``,
        and over ``home`` and ``level``.

    Raises
    ------
    InputError
        A value out of range.

    Examples
    --------
    >>> import studies
    >>> quick = studies.baseline(motions=2, samples=1)
    >>> for name in ("free_formula", "wall_formula"):  # where half fall, over what the formula says
    ...     print(quick.quantities[name], quick.quantities[name].label.partition(", ")[2])
    0.74 as a verdict draws it, free
    1.76 as a verdict draws it, a wall 2 cm behind
    """
    count = whole_within("studies.motions", motions, 2, 1000)
    each = whole_within("studies.samples", samples, 1, 1000)
    ground = synthetic_suite("mixed", count, seed)
    hazard_of = hazards(ground)
    pieces = {name: _body(name) for name in PIECES}
    sizes = {one.name: Body(one.width, one.height, 100.0) for one in LOSS_MODEL}
    home = {name: _body(name) for name in AT_HOME}
    single = count * len(LEVELS)
    runs = single * len(pieces) * (1 + len(EFFECTS)) + single * each * (
        2 * len(pieces) + 2 * len(sizes) + len(home)
    )
    runs += count * each * len(home) * len(STOREYS) * len(GROUND_LEVELS)
    with bar(runs + single * len(sizes), "progress.studying") as advance:

        def run(rows: list[Rows], effect: Effect | None = None) -> list[Baseline]:
            return run_baselines(rows, hazard_of(effect), advance)

        def drawn(bodies: dict[str, Body], *, wall: bool) -> list[Baseline]:
            return run([default_rows(body, count, each, seed, wall=wall) for body in bodies.values()])

        ideal = run([ideal_rows(Held(body, IDEAL), count) for body in pieces.values()])
        changed = {
            effect.name: run([ideal_rows(effect.held(body), count) for body in pieces.values()], effect)
            for effect in EFFECTS
        }
        changed |= {FREE: drawn(pieces, wall=False), WALL: drawn(pieces, wall=True)}
        field = {
            "ideal": run([ideal_rows(Held(body, IDEAL), count) for body in sizes.values()]),
            FREE: drawn(sizes, wall=False),
            WALL: drawn(sizes, wall=True),
        }
        at_home = drawn(home, wall=True)
        at_home_rows = [default_rows(body, count, each, seed, wall=True) for body in home.values()]
        by_storey = run_storeys(at_home_rows, ground, advance)
    data = _dataset(ideal, changed, field, at_home, by_storey)
    return Study(
        name="baseline",
        title="The baseline: what the ideal block leaves out, and the field",
        quantities=_quantities(data),
        data=data,
        figures={"effects": draw_effects(data), "field": draw_field(data)},
        tables={
            EFFECTS_CAPTION: effects_table(data),
            FIELD_CAPTION: field_table(data),
            HOME_CAPTION: home_table(data),
            STOREY_CAPTION: storey_table(data),
        },
        claims=claims(data),
    )


def _body(name: str) -> Body:
    preset = FURNITURE[name]
    return Body(preset.width, preset.height, preset.mass)


def _dataset(
    ideal: list[Baseline],
    changed: dict[str, list[Baseline]],
    field: dict[str, list[Baseline]],
    at_home: list[Baseline],
    by_storey: NDArray[np.float64],
) -> xr.Dataset:
    def medians(runs: list[Baseline], name: str) -> list[float]:
        return [getattr(one, name) for one in runs]

    velocity, intensity = (
        np.array([medians(runs, name) for runs in changed.values()])
        for name in ("median_velocity", "median_intensity")
    )
    reference = np.array(medians(ideal, "median_velocity"))
    reference_intensity = np.array(medians(ideal, "median_intensity"))
    over = {"units": "m/s", "long_name": "median peak floor velocity"}
    return xr.Dataset(
        {
            "ideal": ("piece", reference, over),
            "ideal_intensity": ("piece", reference_intensity, {"long_name": "median JMA intensity"}),
            "velocity": (("effect", "piece"), velocity, over),
            "ratio": (("effect", "piece"), velocity / reference, {"long_name": "over the ideal block's"}),
            "shift": (
                ("effect", "piece"),
                intensity - reference_intensity,
                {"long_name": "median JMA intensity, less the ideal block's"},
            ),
            "simulated": (
                ("setting", "published"),
                np.array([medians(runs, "median_velocity") for runs in field.values()]),
                over,
            ),
            "loss_model": ("published", [one.velocity for one in LOSS_MODEL], over),
            "formula": (
                "published",
                [kaneko_hayashi_velocity(Body(one.width, one.height, 1.0)) for one in LOSS_MODEL],
                over,
            ),
            "share": (
                ("home", "level"),
                np.array([one.shares for one in at_home]),
                {"long_name": "share that overturns"},
            ),
            "storey_share": (
                ("storey", "ground", "home"),
                by_storey,
                {"long_name": "share that overturns in a building of ten storeys"},
            ),
        },
        {
            "piece": list(PIECES),
            "effect": list(changed),
            "setting": list(field),
            "published": [one.name for one in LOSS_MODEL],
            "home": list(AT_HOME),
            "level": ("level", LEVELS, {"long_name": "JMA intensity of the ground"}),
            "storey": list(STOREYS),
            "ground": ("ground", list(GROUND_LEVELS), {"long_name": "JMA intensity of the ground"}),
        },
    )


def mean_ratio(values: NDArray[np.float64]) -> float:
    """Return the geometric mean of the ratios that are known."""
    return float(np.exp(np.nanmean(np.log(values))))


@dataclass(frozen=True, slots=True)
class Field:
    """Where a setting lies against the published medians.

    Parameters
    ----------
    formula, loss_model : float
        Geometric means of the simulated medians over Kaneko and Hayashi's and over the loss model's, over the
        sizes that have a median in every setting, so that settings can be compared.
    """

    formula: float
    loss_model: float


def field_of(data: xr.Dataset, setting: str) -> Field:
    """Return where a setting lies against the published medians."""
    known = data["simulated"].notnull().all("setting")
    simulated = data["simulated"].sel(setting=setting).where(known).to_numpy()
    return Field(
        mean_ratio(simulated / data["formula"].to_numpy()),
        mean_ratio(simulated / data["loss_model"].to_numpy()),
    )


def _quantities(data: xr.Dataset) -> dict[str, Quantity]:
    settings = {"ideal": "the ideal block", "free": FREE, "wall": WALL}
    found: dict[str, Quantity] = {}
    for key, setting in settings.items():
        lies = field_of(data, "ideal" if key == "ideal" else setting)
        found[f"{key}_formula"] = Quantity(
            f"Median over Kaneko and Hayashi's formula, {setting}", lies.formula, 1.0, ".2f"
        )
        found[f"{key}_loss"] = Quantity(
            f"Median over the loss model's formula, {setting}", lies.loss_model, 1.0, ".2f"
        )
    margin = mean_ratio(data["loss_model"].to_numpy() / data["formula"].to_numpy())
    found["margin"] = Quantity("Loss model's median over Kaneko and Hayashi's", margin, form=".2f")
    ratio = data["ratio"]
    found["free_ratio"] = Quantity(f"Median over the ideal block's, {FREE}", span(ratio.sel(effect=FREE)))
    found["wall_ratio"] = Quantity(f"Median over the ideal block's, {WALL}", span(ratio.sel(effect=WALL)))
    return found


def _number(value: float, form: str) -> str:
    return format(value, form) if np.isfinite(value) else "–"


def effects_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each thing left out: the ratio for every piece, and the shift of intensity."""
    sources = {effect.name: effect.source for effect in EFFECTS}
    rows: list[dict[str, object]] = []
    reference = {
        str(piece): f"{_number(100 * float(value), '.0f')} cm/s"
        for piece, value in zip(data["piece"].to_numpy(), data["ideal"].to_numpy(), strict=True)
    }
    rows.append(
        {"left out": "the ideal block itself, free", "source": "", **reference, "mean": "1", "JMA": ""}
    )
    for name in data["effect"].to_numpy():
        at = data.sel(effect=name)
        ratios = at["ratio"].to_numpy()
        rows.append(
            {
                "left out": str(name),
                "source": sources.get(str(name), "all of a verdict's draws"),
                **{
                    str(piece): _number(ratio, ".2f")
                    for piece, ratio in zip(data["piece"].to_numpy(), ratios, strict=True)
                },
                "mean": f"{mean_ratio(ratios):.2f}",
                "JMA": f"{float(np.nanmean(at['shift'].to_numpy())):+.2f}",
            }
        )
    return pd.DataFrame(rows)


def field_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each published piece: its medians by formula and by simulation."""
    rows: list[dict[str, object]] = []
    for name in data["published"].to_numpy():
        at = data.sel(published=name)
        loss, formula = float(at["loss_model"]), float(at["formula"])
        row: dict[str, object] = {
            "piece, depth × height": str(name),
            "FEMA P-58": round(100 * loss),
            "Kaneko–Hayashi": round(100 * formula),
        }
        for setting in data["setting"].to_numpy():
            value = float(at["simulated"].sel(setting=setting))
            ratios = f" ({value / formula:.2f}, {value / loss:.2f})" if np.isfinite(value) else ""
            row[str(setting)] = _number(100 * value, ".0f") + ratios
        rows.append(row)
    return pd.DataFrame(rows)


def home_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each JMA class: what was observed, and the shares that fall in a verdict."""
    rows: list[dict[str, object]] = []
    for name, level in CLASSES.items():
        at = data["share"].interp(level=level)
        rows.append(
            {
                "class": name,
                "observed": OBSERVED[name],
                "mean of the pieces": f"{100 * float(at.mean()):.0f}",
                **{str(piece): f"{100 * float(at.sel(home=piece)):.0f}" for piece in at["home"].to_numpy()},
            }
        )
    return pd.DataFrame(rows)


def storey_table(data: xr.Dataset) -> pd.DataFrame:
    """Return a row for each storey: what was reported of Kobe, and mean shares by the ground's intensity."""
    share = 100.0 * data["storey_share"].mean("home")
    rows: list[dict[str, object]] = []
    for storey, reported in zip(STOREYS, REPORTED, strict=True):
        row: dict[str, object] = {"storey": storey, "Kobe, 1995": reported}
        for level in GROUND_LEVELS:
            row[f"ground {level:g}"] = f"{float(share.sel(storey=storey, ground=level)):.0f}"
        rows.append(row)
    return pd.DataFrame(rows)


def claims(data: xr.Dataset) -> tuple[Claim, ...]:
    """Return what was observed and what formulas say, beside a verdict with everything drawn."""
    found: list[Claim] = []
    at_home = data["share"].mean("home")
    for name, (low, high) in WORDS.items():
        share = float(at_home.interp(level=CLASSES[name]))
        found.append(
            Claim(
                f"Furniture at home, JMA {name}",
                OBSERVED[name],
                f"{100 * share:.0f} % of seven pieces fall, a wall {100 * STANDS:g} cm behind",
                outcome_of(int(low <= share <= high), 1),
            )
        )
    by_storey = data["storey_share"].mean("home")
    for storey, (reported, (low, high)) in zip(STOREYS, REPORTED.items(), strict=True):
        weak, strong = (float(by_storey.sel(storey=storey, ground=level)) for level in GROUND_LEVELS[1:])
        found.append(
            Claim(
                "Kobe 1995 by storey (second hand)",
                reported,
                f"storey {storey} of {STOREYS[-1]}: {100 * weak:.0f} to {100 * strong:.0f} %, the ground at "
                f"{GROUND_LEVELS[1]:g} to {GROUND_LEVELS[2]:g}",
                _of_a_range(weak, strong, low, high),
            )
        )
    free, wall = field_of(data, FREE), field_of(data, WALL)
    for name, one, other in (
        ("Kaneko and Hayashi's formula, free pieces", free.formula, wall.formula),
        ("FEMA P-58's formula, unanchored", free.loss_model, wall.loss_model),
    ):
        near = abs(one - 1.0) <= 0.2
        found.append(
            Claim(
                name,
                "median velocities of nine pieces",
                f"{one:.2f} times it free, {other:.2f} times with a wall {100 * STANDS:g} cm behind",
                PARTLY if near else NO,
            )
        )
    return tuple(found)


def _of_a_range(weak: float, strong: float, low: float, high: float) -> str:
    """Return the outcome where the ground was between two intensities: yes where both shares are as told."""
    if low <= weak and strong <= high:
        return YES
    return PARTLY if weak <= high and strong >= low else NO


def draw_effects(data: xr.Dataset) -> Figure:
    """Draw the ratio to the ideal block's median for each thing left out: the mean, and every piece."""
    names = [str(name) for name in data["effect"].to_numpy()]
    ratios = data["ratio"].to_numpy()
    rows = np.arange(len(names))
    figure = new_figure(11.5, 0.3 * len(names) + 1.6)
    axis = figure.subplots()
    means = np.array([mean_ratio(row) for row in ratios])
    axis.barh(rows, means - 1.0, 0.7, 1.0, color="#b9d9ee", edgecolor=INK, linewidth=0.5, label="mean")
    for place, (piece, marker) in enumerate(zip(data["piece"].to_numpy(), "os^D", strict=True)):
        axis.plot(
            ratios[:, place], rows, marker, color=INK, markersize=4.5, fillstyle="none", label=str(piece)
        )
    axis.axvline(1.0, color=INK, linewidth=1.0)
    style(axis, zero=False)
    axis.set_yticks(rows, names, fontsize=FONT - 1.0)
    axis.set_ylim(len(names) - 0.5, -0.5)
    axis.set_xlabel("median floor velocity that overturns, over the ideal free block's [–]", fontsize=FONT)
    axis.legend(loc="center right", fontsize=FONT - 1.0)
    return figure


def draw_field(data: xr.Dataset) -> Figure:
    """Draw the simulated medians over Kaneko and Hayashi's, beside both formulas."""
    figure = new_figure(7.5, 5.5)
    axis = figure.subplots()
    formula = 100 * data["formula"].to_numpy()
    looks = (("#6b7580", "o"), ("#d55e00", "s"), ("#0072b2", "^"))
    for setting, (colour, marker) in zip(data["setting"].to_numpy(), looks, strict=True):
        simulated = 100 * data["simulated"].sel(setting=setting).to_numpy()
        axis.plot(formula, simulated, marker, color=colour, markersize=7, label=str(setting))
    across = np.array([0.85 * formula.min(), 1.15 * formula.max()])
    axis.plot(across, across, color=INK, label="Kaneko and Hayashi (formula)")
    axis.plot(across, LOSS_MODEL_RATIO * across, "--", color=MUTED, label="FEMA P-58 (formula)")
    plain_log(axis)
    ticks = (20, 30, 40, 60, 80, 100, 150, 200, 300)
    axis.set_xticks([tick for tick in ticks if across[0] <= tick <= across[1]])
    axis.set_yticks([tick for tick in ticks if tick <= 1.2 * axis.get_ylim()[1]])
    style(axis, zero=False)
    axis.set_xlabel("median of Kaneko and Hayashi's formula [cm/s]", fontsize=FONT)
    axis.set_ylabel("peak floor velocity at which half overturn [cm/s]", fontsize=FONT)
    axis.legend(loc="upper left", fontsize=FONT - 1.0)
    return figure
