"""What the critical-ratio study found, in words."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from stayput.motion.units import STANDARD_GRAVITY
from stayput.studies.critical_ratio.cases import (
    HEIGHTS,
    LARGEST,
    PHASES,
    RESTITUTIONS,
    STICKING,
    rows_of,
)
from stayput.studies.critical_ratio.fit import CONFIDENCE, EQUATION_4_1

if TYPE_CHECKING:
    import pandas as pd
    from numpy.typing import NDArray

    from stayput.studies.critical_ratio.cases import Conditions
    from stayput.studies.critical_ratio.fit import Fit


def text_of(base: Conditions, table: pd.DataFrame, fit: Fit, absolute: Fit, step: float) -> str:
    """Return the study's paragraphs.

    Parameters
    ----------
    base : Conditions
        What all cases have that nothing varies.
    table : DataFrame
        A row for each critical amplitude.
    fit, absolute : Fit
        Our regression of relative and of absolute residuals.
    step : float
        Step of the amplitudes that were run [g·b/h].
    """
    main = rows_of(table, part="main")
    return "\n\n".join(
        (
            _what_was_done(base, main, step),
            _against_the_paper(main),
            _regression(fit, absolute),
            _islands(main),
            _size(base, rows_of(table, part="size")),
            _influences(table),
        )
    )


def _what_was_done(base: Conditions, main: pd.DataFrame, step: float) -> str:
    b_h, f = main["ratio"], main["frequency"]
    return (
        f"A body of {base.height:g} m rocks on a floor on which it cannot slide (the paper's contact law, "
        f"e = {base.restitution:g}), under a sine of {base.duration:g} s with a phase of {base.phase:g}° "
        f"(90° is a cosine), for b/h of {b_h.min():g} to {b_h.max():g} and {f.min():g} to {f.max():g} Hz. "
        "The paper states none of height, restitution, phase and duration. Turnover is not monotonic in "
        f"amplitude, so amplitudes from g·b/h, below which the body does not rise, to {LARGEST:g} g·b/h "
        f"were run in steps of {step:g} g·b/h, and the first that turns the body over was refined: the "
        "critical amplitude."
    )


def _against_the_paper(main: pd.DataFrame) -> str:
    off = 100.0 * (main["critical"] / main["eq_4_1"] - 1.0).to_numpy()
    worst = int(np.nanargmax(np.abs(off)))
    at = main.iloc[worst]
    missing = int(np.isnan(off).sum())
    never = f" {missing} of the bodies never turned over and are left out." if missing else ""
    return (
        f"Our critical amplitudes are {np.nanmean(np.abs(off)):.1f} % from Eq. 4.1 on average "
        f"({np.nanmean(off):+.1f} % with sign), at worst {off[worst]:+.1f} %, at b/h = {at['ratio']:g} and "
        f"{at['frequency']:g} Hz.{never}"
    )


def _regression(fit: Fit, absolute: Fit) -> str:
    inside = np.abs(fit.coefficients - np.array(EQUATION_4_1)) <= fit.half_widths
    names = [f"c{place}" for place, yes in zip("₁₂₃₄", inside, strict=True) if yes]
    off, off_absolute = (100.0 * np.abs(which.residuals) for which in (fit, absolute))
    return (
        "The form of Eq. 4.1 was fitted to them by least squares of the relative residuals, so that small "
        f"amplitudes count as much as large ones. It is {off.mean():.1f} % off on average and "
        f"{off.max():.1f} % at worst; a fit of the absolute residuals is {off_absolute.mean():.1f} % and "
        f"{off_absolute.max():.1f} % off. Of the paper's four coefficients, {', '.join(names) or 'none'} "
        f"lies within our {100 * CONFIDENCE:.0f} % confidence intervals. These suppose residuals of pure "
        "chance, and ours run in curves (figure): the form does not quite fit."
    )


def _islands(main: pd.DataFrame) -> str:
    islands = main.loc[(main["safe_share"] > 0.0).to_numpy()]
    if islands.empty:
        return "No body stood again at an amplitude that was run above its first turnover."
    reach = (islands["last_safe"] / islands["critical"]).to_numpy()
    far = islands.iloc[int(reach.argmax())]
    return (
        f"{len(islands)} of the {len(main)} bodies stand again at some amplitude above the first that "
        f"turns them over: safe islands, on average {100 * islands['safe_share'].mean():.1f} % of the "
        f"amplitudes above it. They reach furthest at b/h = {far['ratio']:g} and {far['frequency']:g} Hz, "
        f"to {far['last_safe']:.2f} m/s², {reach.max():.2f} times the first of {far['critical']:.2f} m/s²."
    )


def _size(base: Conditions, sizes: pd.DataFrame) -> str:
    heights = [size * base.height for size in HEIGHTS]
    of_size = np.stack([rows_of(sizes, height=h)["scaled"].to_numpy(np.float64) for h in heights])
    spread = 100.0 * float(np.nanmax(np.ptp(of_size, axis=0) / of_size.mean(axis=0)))
    ratios: list[float] = sorted(sizes["ratio"].unique().tolist())
    ratio = ratios[len(ratios) // 2]
    mine = rows_of(sizes, ratio=ratio, height=base.height)
    middle = mine.iloc[len(mine) // 2]
    place, scaled = (mine[name].to_numpy(np.float64) for name in ("omega_over_p", "scaled"))
    wanted = float(middle["omega_over_p"]) * np.sqrt(HEIGHTS)
    read = np.asarray(np.interp(wanted, place, scaled, np.nan, np.nan), np.float64)
    amplitudes = (STANDARD_GRAVITY * ratio * read).tolist()
    told = [f"{S:.1f} m/s² for {h:g} m" for h, S in zip(heights, amplitudes, strict=True) if S == S]
    return (
        "Eq. 4.1 knows no size. In its scale-free form the critical amplitude, in g·b/h, depends on ω/p "
        "with p² = 3g/4R (R half the diagonal), on ωt, on b/h and on e: at the same ω/p and ωt, bodies of "
        f"{', '.join(f'{h:g}' for h in heights)} m differ by {spread:.1g} % at most. So at one frequency a "
        f"larger body needs more. At {middle['frequency']:g} Hz and b/h = {ratio:g} that curve gives "
        f"{', '.join(told)}; Eq. 4.1 gives {middle['eq_4_1']:.1f} m/s² for all."
    )


def _influences(table: pd.DataFrame) -> str:
    sway = rows_of(table, part="sway")
    alike = (sway["friction"] == sway["corner_friction"]).to_numpy()
    return (
        f"At b/h = {sway['ratio'].iloc[0]:g}, e between {min(RESTITUTIONS):g} and {max(RESTITUTIONS):g} "
        f"changes the critical amplitude by a factor of up to {_largest_factor(table, 'restitution')}, and "
        f"the phase, between {min(PHASES):g}° and {max(PHASES):g}°, by up to "
        f"{_largest_factor(table, 'phase')}. Where the floor lets the body slide too, μ being above b/h, "
        f"the critical amplitude is, under the paper's law, {_sway(sway, alike, 'paper')}, and under "
        f"Coulomb's {_sway(sway, alike, 'coulomb')}. With μ below b/h under the base and above it under a "
        f"corner, as in the paper's Table 4.2, it is {_sway(sway, ~alike, 'paper')}, and "
        f"{_sway(sway, ~alike, 'coulomb')}: a body that slides may begin to rock under the paper's rules, "
        "but slides on under Coulomb's law, so that it turns over only where the first instant sets it "
        "rocking."
    )


def _largest_factor(table: pd.DataFrame, part: str) -> str:
    grouped = rows_of(table, part=part).groupby("frequency")["critical"]
    factor = grouped.max() / grouped.min()
    place = int(np.nanargmax(factor.to_numpy()))
    return f"{factor.iloc[place]:.2f} (at {factor.index[place]:g} Hz)"


def _sway(sway: pd.DataFrame, kind: NDArray[np.bool_], law: str) -> str:
    """Return how the critical amplitudes of some frictions compare with those of a body that cannot slide."""
    without = rows_of(sway, friction=STICKING, contact=law).set_index("frequency")["critical"]
    chosen = rows_of(sway[kind & (sway["friction"] != STICKING).to_numpy()], contact=law)
    factor = chosen["critical"].to_numpy(np.float64) / without.loc[chosen["frequency"]].to_numpy(np.float64)
    count = int(np.isfinite(factor).sum())
    if not count:
        return f"not there in any of {len(chosen)} cases"
    return (
        f"{np.nanmin(factor):.2f} to {np.nanmax(factor):.2f} times that without sliding in {count} of "
        f"{len(chosen)} cases ({100.0 * chosen['safe_share'].mean():.0f} % of the amplitudes above it "
        f"being safe) and not there in {len(chosen) - count}"
    )
