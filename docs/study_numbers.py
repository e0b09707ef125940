"""The numbers that the texts about the studies (``studies/*.md``) quote, beyond the studies' own quantities.

A function for each study: it takes the study, run with its default settings, and its motion (None where it
has none), and returns numbers and lists by the names that stand in the text's braces.
"""

from __future__ import annotations

import inspect
import math
import re
from typing import TYPE_CHECKING, Any

import numpy as np
from beside_numbers import ac156, consumer_centre, three_dimensions, tip_over, tombstones

import studies.baseline_runs as baselines
import studies.capacity_runs as capacities
import studies.critical_ratio_runs as amplitudes
import studies.friction_runs as sliding
import studies.spectrum_runs as spectra
import studies.tokyo_runs as tokyo_test
import studies.walls as walls
import studies
from stayput.estimates import SCATTER
from stayput.model.gravity import STANDARD_GRAVITY
from stayput.model.room import Wall
from stayput.simulation.run import LAWS
from studies.capacity import inside, stated
from studies.contents import LIP, RANGES, SEVEN, SIX_UPPER, SLOPE, WALL
from studies.study import NO, listed, span
from studies.tokyo import names
from studies.wall_gap import NEAR, SHARES, TURNS_OVER, WIDE, WIDTHS, nearest_walls, ruled
from studies.wall_gap_record import differences, nearest, rows_of

if TYPE_CHECKING:
    from collections.abc import Callable

    import pandas as pd
    import xarray as xr

    import stayput as sp
    from studies import Study

Numbers = dict[str, Any]


def filled(text: str, numbers: Numbers) -> str:
    """Write numbers into a text: ``{{name}}`` or, with a format specification, ``{{name:.2f}}``.

    Raises
    ------
    KeyError
        The text names a number that there is not.
    """
    pattern = re.compile(r"\{\{(\w+)(?::([^}]*))?\}\}")
    return pattern.sub(lambda match: format(numbers[match[1]], match[2] or ""), text)


def numbers_of(study: Study, motion: sp.Motion | None = None) -> Numbers:
    """Return all numbers of a study's text; what the functions below return stands beside its quantities."""
    quantities = {name: str(quantity) for name, quantity in study.quantities.items()}
    own = set(quantities) & set(extra := NUMBERS[study.name](study, motion))
    if own:
        raise ValueError(f"{study.name} has two numbers of the name {', '.join(sorted(own))}")
    return quantities | extra


def default_of(function: Callable[..., Study], argument: str) -> Any:
    """Return the default of a study's argument."""
    return inspect.signature(function).parameters[argument].default


def friction(study: Study, motion: sp.Motion | None) -> Numbers:
    body, mu = sliding.PAPER_BODY, sliding.PAPER_ROWS[2][0]
    table = study.data.to_dataframe()
    table = table[table["part"] == "search"]
    pairs = zip(table["static_friction"], table["kinetic_friction"], strict=True)
    table = table.assign(row=[sliding.PAPER_ROWS.index(pair) for pair in pairs])
    sines = study.tables["The nearest sine for each model, with its three slides [cm]"].set_index("model")
    phase, f, A = sines.loc[sliding.HELD, ["phase [°]", "f [Hz]", "A [m/s²]"]].astype(float)
    duration = default_of(studies.friction, "duration")
    ratio = body.height / body.width
    numbers: Numbers = {
        "width": body.width,
        "height": body.height,
        "mass": body.mass,
        "b_h": body.width / body.height,
        "third_mu": mu,
        "duration": duration,
        "amplitudes": span(table["amplitude"], "g"),
        "frequencies": span(table["frequency"], "g"),
        "phases": " and ".join(f"{value:g}" for value in sliding.PHASES),
        # Shenton (1996): the acceleration at which the corner slips at the first uplift [g]
        "slip": (mu * (1.0 + 4.0 * ratio**2) - 3.0 * ratio) / (4.0 + ratio**2 - 3.0 * ratio * mu),
    }
    paper = [100.0 * slide for slide in sliding.PAPER_SLIDES]
    numbers |= {f"paper_{row}": slide for row, slide in enumerate(paper, 1)}
    numbers |= {"paper_static": paper[0] - paper[2], "paper_kinetic": paper[0] - paper[1]}
    for key, model in {"held": sliding.HELD, **sliding.FREE}.items():
        of_model = table[table["body"] == model].set_index(["row", "phase", "frequency", "amplitude"])
        grid = of_model[["peak_slide"]].to_xarray()
        static, kinetic = sliding.effects(grid)
        slides = grid["peak_slide"].isel(row=0) > 0.0
        known = static.notnull() & kinetic.notnull() & slides
        lowest = grid["amplitude"].where(kinetic > static).min("amplitude")
        numbers[f"share_{key}"] = 100.0 * float((kinetic > static).sum()) / max(1, int(known.sum()))
        numbers[f"flip_{key}"] = float(lowest.median()) / STANDARD_GRAVITY
        by_static, by_kinetic = (study.quantities[f"by_{name}_{key}"].value for name in ("static", "kinetic"))
        numbers[f"order_{key}"] = "μ" if by_static > by_kinetic else "μ'"
        if key == "held":
            numbers["idle"] = 100.0 * float((abs(static) < 1e-9).where(slides).mean())
            numbers["longer"] = 100.0 * float((kinetic < 0.0).where(slides).mean())
            continue
        case = sliding.models(sliding.unit_sine(f, duration, phase))[model]
        third = sliding.slides_under(case, (phase,), np.array([f]), np.array([A])).isel(row=2).squeeze()
        does = "rocks" if bool(third["rocks"]) else "stands"
        numbers[f"third_{key}"] = f"{does} and slides {100.0 * float(third['peak_slide']):.2f} cm"
    return numbers


def critical_ratio(study: Study, motion: sp.Motion | None) -> Numbers:
    table = study.data.to_dataframe()
    main, sizes, sway = (amplitudes.rows_of(table, part=part) for part in ("main", "size", "sway"))
    worst = main.loc[(main["critical"] / main["eq_4_1"] - 1.0).abs().idxmax()]
    turned = main.dropna(subset="critical")
    columns = [turned[name].to_numpy() for name in ("ratio", "frequency", "critical")]
    relative, absolute = amplitudes.fitted(*columns), amplitudes.fitted(*columns, relative=False)
    off, off_absolute = (100.0 * np.abs(fit.residuals) for fit in (relative, absolute))
    inside_ours = np.abs(relative.coefficients - np.array(amplitudes.EQUATION_4_1)) <= relative.half_widths
    coefficients = [f"c{place}" for place, yes in zip("₁₂₃₄", inside_ours, strict=True) if yes]
    islands = main[main["safe_share"] > 0.0]
    far = islands.loc[(islands["last_safe"] / islands["critical"]).idxmax()]
    first = main.iloc[0]
    heights = first["height"] * np.array(amplitudes.HEIGHTS)
    scaled = np.stack([amplitudes.rows_of(sizes, height=h)["scaled"].to_numpy() for h in heights])
    ratio = float(sway["ratio"].iloc[0])
    curve = amplitudes.rows_of(sizes, ratio=ratio, height=first["height"])
    middle = curve.iloc[len(curve) // 2]
    # At one frequency a body of another size stands at another place of the curve over ω/p.
    places = middle["omega_over_p"] * np.sqrt(amplitudes.HEIGHTS)
    scale_free = np.interp(places, curve["omega_over_p"], curve["scaled"], np.nan, np.nan)
    by_height = zip(heights, STANDARD_GRAVITY * ratio * scale_free, strict=True)
    (e_low, *_, e_high), (phase_low, *_, phase_high) = amplitudes.RESTITUTIONS, amplitudes.PHASES
    numbers: Numbers = {
        **{name: first[name] for name in ("height", "restitution", "duration", "phase")},
        "ratios": span(main["ratio"], "g"),
        "frequencies": span(main["frequency"], "g"),
        "largest": amplitudes.LARGEST,
        "step": default_of(studies.critical_ratio, "step"),
        "worst_ratio": worst["ratio"],
        "worst_frequency": worst["frequency"],
        "fit_worst": off.max(),
        "absolute_off": off_absolute.mean(),
        "absolute_worst": off_absolute.max(),
        "inside": ", ".join(coefficients) or "none",
        "confidence": 100.0 * amplitudes.CONFIDENCE,
        "bodies": len(main),
        "island_share": 100.0 * islands["safe_share"].mean(),
        "far_ratio": far["ratio"],
        "far_frequency": far["frequency"],
        "far_safe": far["last_safe"],
        "far_first": far["critical"],
        "far_reach": far["last_safe"] / far["critical"],
        "heights": listed(heights),
        "size_spread": 100.0 * np.nanmax(np.ptp(scaled, axis=0) / scaled.mean(axis=0)),
        "size_frequency": middle["frequency"],
        "size_ratio": ratio,
        "size_eq": middle["eq_4_1"],
        "of_size": ", ".join(f"{S:.1f} m/s² for {h:g} m" for h, S in by_height if S == S),
        "restitutions": f"{e_low:g} and {e_high:g}",
        "phases": f"{phase_low:g} and {phase_high:g}",
    }
    for part in ("restitution", "phase"):
        critical = amplitudes.rows_of(table, part=part).groupby("frequency")["critical"]
        factor = critical.max() / critical.min()
        numbers |= {f"by_{part}": factor.max(), f"by_{part}_at": factor.idxmax()}
    alike = sway["friction"] == sway["corner_friction"]
    for law in LAWS:
        numbers[f"sway_{law}"], numbers[f"low_base_{law}"] = (
            _sway(sway, kind, law) for kind in (alike, ~alike)
        )
    return numbers


def _sway(sway: pd.DataFrame, kind: pd.Series, law: str) -> str:
    """Compare the critical amplitudes of some frictions with those of a body that cannot slide."""
    sticking = amplitudes.STICKING
    without = amplitudes.rows_of(sway, friction=sticking, contact=law).set_index("frequency")["critical"]
    chosen = amplitudes.rows_of(sway[kind & (sway["friction"] != sticking)], contact=law)
    factor = chosen["critical"].to_numpy() / without.loc[chosen["frequency"]].to_numpy()
    count = int(np.isfinite(factor).sum())
    if not count:
        return f"not there in any of {len(chosen)} cases"
    return (
        f"{span(factor)} times that without sliding in {count} of {len(chosen)} cases "
        f"({100.0 * chosen['safe_share'].mean():.0f} % of the amplitudes above it being safe) "
        f"and not there in {len(chosen) - count}"
    )


def wall_gap(study: Study, motion: sp.Motion | None) -> Numbers:
    data = study.data
    widths, ratios = data["body.width"].to_numpy(), data["aspect_ratio"].to_numpy()
    never = [ratio for ratio in ratios if not (data["broken_share"].sel(aspect_ratio=ratio) > 0.0).any()]
    still = [ratio for ratio in ratios if not data["free_tilt"].sel(aspect_ratio=ratio).any()]
    (low, high), wide = TURNS_OVER, WIDE
    numbers: Numbers = {
        "ratio": walls.RATIO,
        "mass": walls.MASS,
        "motion": data.attrs["motion"],
        "duration": walls.DURATION,
        "low": low,
        "high": high,
        "wide": wide,
        "near": 100.0 * NEAR,
        "widths": span(widths, "g"),
        "cells": 2 * int(ruled(widths, data["gap"].to_numpy()).sum()),
        "rule_widths": span(WIDTHS, "g"),
        "farthest": 100.0 * SHARES[-1],
        "rule_step": 100.0 * SHARES[1],
        "inputs": data["broken_share"].sel(contact="paper").size,
        "holds": listed(never),
        "still": listed(still),
        "foot_static": walls.FLOOR.edge_friction[0],
        "foot_kinetic": walls.FLOOR.edge_friction[1],
    }
    middle = (widths >= low - 1e-9) & (widths <= high + 1e-9)
    for law in LAWS:
        of_law = data.sel(contact=law)
        broken = of_law["broken_share"] > 0.0
        numbers[f"broken_stands_{law}"] = int((broken & (of_law["free_share"] == 0.0)).sum())
        numbers[f"broken_slender_{law}"] = int(broken.sel(aspect_ratio=ratios < walls.RATIO - 1e-9).sum())
        numbers[f"alone_{law}"] = _widest(widths, of_law["overturned_free"].to_numpy())
        numbers[f"both_{law}"] = _widest(widths, of_law["overturned"].sel(wall="both").to_numpy().any(-1))
        for wall in ("left", "right"):
            closest = nearest_walls(data, law, wall)
            of_middle = _nearest(widths, closest, middle, f"of {low:.1f} to {high:.1f} m")
            numbers[f"middle_{wall}_{law}"] = of_middle
            above = widths > wide + 1e-9
            numbers[f"above_{wall}_{law}"] = _nearest(widths, closest, above, f"above {wide:.1f} m")
    return numbers


def _widest(widths: np.ndarray, fallen: np.ndarray) -> str:
    return f"the widest that turns over has {widths[fallen].max():g} m" if fallen.any() else "none turns over"


def _nearest(widths: np.ndarray, closest: np.ndarray, chosen: np.ndarray, which: str) -> str:
    fallen = chosen & ~np.isnan(closest)
    count = f"{int(fallen.sum())} of {int(chosen.sum())} widths {which} turn over"
    if not fallen.any():
        return count
    share = 100.0 * closest[fallen] / widths[fallen]
    return (
        f"{count}, the nearest wall that does it being {span(closest[fallen])} m away "
        f"({span(share, '.0f')} % of the width)"
    )


def wall_gap_record(study: Study, motion: sp.Motion | None) -> Numbers:
    data, gaps = study.data, study.data["gap"].to_numpy()
    variant = nearest(data)
    shown = differences(data, variant)
    farther = data.sel({"contact": variant[0], "motion.scale": variant[1]})[["reach_left", "reach_right"]]
    reach = farther.to_array().max("variable")

    def at_widths(text: Callable[[pd.Series], str]) -> str:
        return ", ".join(f"{text(row)} m at b = {row['b [m]']:g} m" for _, row in shown.iterrows()) or "none"

    numbers: Numbers = {
        "ratio": data.attrs["aspect_ratio"],
        "mass": walls.MASS,
        "motion": f"{motion.name}{' (synthetic)' if motion.synthetic else ''}",
        "length": motion.duration,
        "pga": motion.component("x").pga,
        "gaps": len(gaps),
        "distances": span(gaps, "g"),
        "wall_friction": Wall(0.0).friction,
        "compared": study.quantities["agree"].published,
        "firsts": at_widths(lambda row: f"{row['first [m]']:.2f} ({row['first, paper [m]']:.2f})"),
        "lasts": at_widths(lambda row: f"{row['last [m]']:.2f} ({row['last, paper [m]']:.2f})"),
        "reaches": at_widths(lambda row: f"{float(reach.sel({'body.width': row['b [m]']})):.2f}"),
    }
    for law in LAWS:
        for wall in walls.WALLS:
            rows = rows_of(data, (law, 1.0, wall))
            numbers[f"{wall}_{law}"] = listed([b for b, ranges, free in rows if ranges and not free])
            numbers[f"alone_{law}"] = listed([b for b, _, free in rows if free])
    return numbers


def spectrum(study: Study, motion: sp.Motion | None) -> Numbers:
    pulse, under = study.data.isel(curve=0), study.data.isel(curve=slice(1, None))
    period = pulse["period"].to_numpy()
    diagonal = 2.0 * study.data["half_diagonal"].to_numpy()
    table = study.tables[f"Edges under one sine at ωp/p = {spectra.REFERENCE_RATIO:g}, a_p/(αg)"]
    lower, _, without = spectra.pulse_branches(pulse)
    both = ~np.isnan(lower) & ~np.isnan(without)
    first, last = spectra.outer_edges(under)
    ratio = (last / first)[under["islands"].to_numpy() > 0]
    falls = under["overturned"].to_numpy() > 0.0
    diagonals = np.broadcast_to(diagonal, falls.shape)
    alpha = under["slenderness"].to_numpy()
    tilt = np.where(falls, 0.0, under["peak_tilt"].to_numpy() / alpha[:, None])
    i, j = np.unravel_index(np.argmax(tilt), tilt.shape)
    return {
        "diagonals": span(diagonal, ".2g"),
        "periods": span(period, ".3g"),
        "sticking": spectra.STICKING.static_friction,
        "step": 100.0 * study.data.attrs["largest_relative_step"],
        "tolerance": 100.0 * study.data.attrs["tolerance"],
        "alpha": spectra.PULSE_SLENDERNESS,
        "e": spectra.PULSE_E,
        "e_factor": spectra.PULSE_E / spectra.housner_ratio(spectra.PULSE_SLENDERNESS),
        "p": spectra.REFERENCE_P,
        "at": spectra.REFERENCE_RATIO,
        "references": listed(spectra.REFERENCE_EDGES),
        "edges_off": table["difference [%]"].abs().max(),
        "both_ways": f"from {span(period[both] / spectra.PULSE_PERIOD, '.3g')}" if both.any() else "none",
        "both_factor": np.max(without[both] / lower[both], initial=math.nan if not both.any() else 0.0),
        "record": motion.name or "without a name",
        "peak": motion.pga / STANDARD_GRAVITY,
        "components": "with its vertical component" if motion.z is not None else "horizontal only",
        "quiet": spectra.QUIET,
        "edge_ratio": np.nanmedian(ratio),
        "edge_ratio_most": np.nanmax(ratio),
        "fallen_diagonal": np.median(diagonals[falls]),
        "standing_diagonal": np.median(diagonals[~falls]),
        "tilt": tilt[i, j],
        "tilt_alpha": alpha[i],
        "tilt_period": period[j],
    }


def tokyo(study: Study, motion: sp.Motion | None) -> Numbers:
    data, room = study.data, tokyo_test.ROOM
    full, reduced = tokyo_test.LEVELS
    outcomes = tokyo_test.shares(data)
    verdicts = [claim.outcome for claim in study.claims]
    pieces = [
        f"a {name} ({1e3 * body.height:g} mm high, {1e3 * body.width:g} mm deep, {body.mass:g} kg)"
        for name, body in tokyo_test.BODIES.items()
    ]
    levels = [f"{100 * at:g} % (JMA intensity {motion.scaled(at).intensity:.1f})" for at in tokyo_test.LEVELS]
    alone = outcomes["overturned"].sel(device=names(tokyo_test.ALONE), level=full).mean(("device", "body"))
    changed = 100.0 * data["overturned_share"].mean("facing")
    weak_poles = changed.sel(probe=names(tokyo_test.POLES)[0], level=reduced)
    return {
        "pieces": " and ".join(pieces),
        "motion": f"{motion.name}{' (synthetic)' if motion.synthetic else ''}",
        "length": motion.duration,
        "pga": motion.pga,
        "pgv": 100.0 * motion.pgv,
        "components": f"{'with its' if motion.z is not None else 'without a'} vertical component",
        "levels": " and ".join(levels),
        "samples": data.sizes["sample"],
        "flooring": tokyo_test.FLOORING,
        "static": room.floor.static_friction,
        "kinetic": room.floor.kinetic_friction,
        "wall": 100.0 * room.left_wall.gap,
        "ceiling": room.ceiling.height,
        "facings": ", ".join(data["facing"].to_numpy().tolist()),
        **{word: verdicts.count(word) for word in ("yes", "partly", "no")},
        "by_facing": ", ".join(
            f"{name} {100 * float(alone.sel(facing=name)):.0f} %" for name in alone["facing"].to_numpy()
        ),
        "piece": tokyo_test.PIECE,
        "decides": "; ".join(
            _decides(changed.sel(probe=name, level=full)) for name in data["probe"].to_numpy()
        ),
        "reduced": float(weak_poles.max()),
    }


def _decides(share: xr.DataArray) -> str:
    """Say how a device fares as stated, and under the changes at which it fares best and worst."""
    known = share.dropna("variation")
    ends = known.isel(variation=[int(known.argmin("variation")), int(known.argmax("variation"))])
    shown = [f"{float(end):.0f} % ({end['variation'].item()})" for end in ends]
    return f"{share['probe'].item()}: {float(share[0]):.0f} % as stated, {' to '.join(shown)}"


def baseline(study: Study, motion: sp.Motion | None) -> Numbers:
    return {
        "motions": default_of(studies.baseline, "motions"),
        "samples": default_of(studies.baseline, "samples"),
        "levels": len(baselines.LEVELS),
        "range": span(baselines.LEVELS, ".1f"),
        "static": baselines.IDEAL.floor.static_friction,
        "kinetic": baselines.IDEAL.floor.kinetic_friction,
    }


def capacity(study: Study, motion: sp.Motion | None) -> Numbers:
    data, main = study.data, stated(study.data)
    ratio, low, high = (main[name].to_numpy() for name in ("ratio", "ratio_low", "ratio_high"))
    fe, scatter = main["frequency"].to_numpy(), main["dispersion"].to_numpy()
    level = fe[:, None] <= main["branch"].to_numpy()
    run, body = np.unravel_index(int(np.abs(ratio - 1.0).argmax()), ratio.shape)
    setting = data["setting"].to_numpy()
    variations: list[str] = []
    for name in dict.fromkeys(setting.tolist()):
        if name != capacities.STATED.name:
            others = data["ratio"].to_numpy()[setting == name]
            near = f"{int(inside(others).sum())} of {others.size} within ±20 %"
            variations.append(f"{name}: {span(others)}, {near}")
    factors = main["amplitude"].to_numpy()
    return {
        "sizes": main.sizes["body"],
        "sticking": capacities.STICKING,
        "spectra": main.sizes["run"],
        "motions": main.sizes["motion"],
        "family": capacities.FAMILY,
        "corners": listed(main["corner"]),
        "fe": span(fe),
        "fb": span(main["branch"]),
        "amplitudes": len(factors),
        "factors": span(factors, "g"),
        "cells": ratio.size,
        "level": span(ratio[level]),
        "above": span(ratio[~level]),
        "far_body": main["body"].to_numpy()[body],
        "far_fe": fe[run],
        "far_ratio": ratio[run, body],
        "far_low": low[run, body],
        "far_high": high[run, body],
        "slow_scatter": scatter[fe.argmin()].mean(),
        "fast_scatter": scatter[fe.argmax()].mean(),
        "formula_scatter": SCATTER,
        "islands": span(100.0 * main["islands"].to_numpy(), ".0f"),
        "variations": "; ".join(variations),
    }


def contents(study: Study, motion: sp.Motion | None) -> Numbers:
    missed = [f"“{one.published}” ({one.ours})" for one in study.claims if one.outcome == NO]
    ranges = [f"{word}: {100 * low:.0f} to {100 * high:.0f} %" for word, (low, high) in RANGES.items()]
    return {
        "motion": "" if motion is None else motion.name,
        "gap": 100.0 * WALL,
        "lip": 100.0 * LIP,
        "slope": float(np.degrees(SLOPE)),
        "six_upper": SIX_UPPER,
        "seven": SEVEN,
        "ranges": "; ".join(ranges),
        "missed": "; ".join(missed) or "none",
        "reports": len(study.claims),
    }


NUMBERS: dict[str, Callable[[Study, sp.Motion | None], Numbers]] = {
    "friction": friction,
    "critical-ratio": critical_ratio,
    "wall-gap": wall_gap,
    "wall-gap-record": wall_gap_record,
    "spectrum": spectrum,
    "tokyo": tokyo,
    "baseline": baseline,
    "tip-over": tip_over,
    "tombstones": tombstones,
    "consumer-centre": consumer_centre,
    "ac156": ac156,
    "capacity": capacity,
    "contents": contents,
    "three-dimensions": three_dimensions,
}
"""The function of each study."""
