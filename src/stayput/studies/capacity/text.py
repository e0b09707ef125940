"""What the study of capacities found, in words."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from stayput.estimates import SCATTER
from stayput.studies.capacity.runs import STATED, STICKING
from stayput.studies.capacity.spectra import FAMILY
from stayput.studies.capacity.tables import inside, stated

if TYPE_CHECKING:
    import xarray as xr


def text_of(data: xr.Dataset) -> str:
    """Return what was done and found."""
    main = stated(data)
    parts = [_what_was_done(main), _medians(main), _scatter(main)]
    if data.sizes["run"] > main.sizes["run"]:
        parts.append(_variations(data))
    return "\n\n".join(parts)


def _what_was_done(main: xr.Dataset) -> str:
    factors = main["amplitude"].to_numpy()
    corners = ", ".join(f"{corner:g}" for corner in main["corner"].to_numpy())
    fe = main["frequency"].to_numpy()
    return (
        f"Uniform rectangles of {main.sizes['body']} sizes stand free on a floor of friction {STICKING:g}, "
        "so that they rock and do not slip; landings are Housner's, and the floor shakes along x alone. For "
        f"each of {main.sizes['run']} spectra, {main.sizes['motion']} synthetic {FAMILY} motions are made to "
        "meet it (the shape of Japan's design spectrum, constant acceleration to a corner period and "
        f"constant velocity beyond it: {corners} s). Their Fe = A/(2πV), from the floor's peaks A and V, has "
        f"medians from {fe.min():.2f} to {fe.max():.2f} Hz; the formula's branches meet at Fb, "
        f"{main['branch'].min():.2f} to {main['branch'].max():.2f} Hz for these sizes. Every motion is "
        f"scaled to {len(factors)} amplitudes, {factors[0]:g} to {factors[-1]:g} times the formula's "
        "A₅₀ for its own Fe. A body that stands at one amplitude and overturns at a lower one counts as "
        "standing there. The median is that of a lognormal curve, fitted by maximum likelihood to the "
        "shares that overturn."
    )


def _medians(main: xr.Dataset) -> str:
    ratio = main["ratio"].to_numpy()
    within = inside(ratio)
    level = main["frequency"].to_numpy()[:, np.newaxis] <= main["branch"].to_numpy()
    mean = np.exp(np.log(ratio).mean())
    said = [
        f"The simulated median is {ratio.min():.2f} to {ratio.max():.2f} times the formula's.",
        f"The geometric mean is {mean:.2f}; {int(within.sum())} of {ratio.size} are within ±20 %.",
    ]
    for name, mine in (("on the level branch (Fe ≤ Fb)", level), ("above it", ~level)):
        if mine.any():
            said.append(f"It is {ratio[mine].min():.2f} to {ratio[mine].max():.2f} {name}.")
    said.append(_farthest(main))
    first = main["first_ratio"].to_numpy()
    said.append(
        f"The first amplitude that overturns, with no regard to islands, has medians of {first.min():.2f} to "
        f"{first.max():.2f}, within ±20 % in {int(inside(first).sum())} of {first.size}."
    )
    lost = int(main["given_up"].sum())
    said += [f"{lost} runs were given up and are left out."] if lost else []
    return " ".join(said)


def _farthest(main: xr.Dataset) -> str:
    """Say which ratio is farthest from 1, and how many intervals reach beyond the band."""
    ratio, low, high = (main[name].to_numpy() for name in ("ratio", "ratio_low", "ratio_high"))
    run, body = np.unravel_index(int(np.abs(ratio - 1.0).argmax()), ratio.shape)
    beyond = int((~(inside(low) & inside(high))).sum())
    return (
        f"The farthest is the {main['body'].to_numpy()[body]} at Fe = "
        f"{float(main['frequency'][run]):.2f} Hz, {ratio[run, body]:.3f} (95 % interval "
        f"{low[run, body]:.2f} to {high[run, body]:.2f}); {beyond} of {ratio.size} intervals reach beyond "
        "±20 %."
    )


def _scatter(main: xr.Dataset) -> str:
    zeta, islands = main["dispersion"].to_numpy(), 100.0 * main["islands"].to_numpy()
    fe = main["frequency"].to_numpy()
    first, last = int(fe.argmin()), int(fe.argmax())
    return (
        f"The standard deviation of ln A is {zeta.min():.2f} to {zeta.max():.2f}, on average "
        f"{zeta[first].mean():.2f} at the lowest Fe and {zeta[last].mean():.2f} at the highest. The "
        f"formula's {SCATTER:g} also covers the scatter of real records, furniture and contact, which one "
        "body under motions of one spectrum does not have. By spectrum and size, "
        f"{islands.min():.0f} to {islands.max():.0f} % of the motions have islands: they leave the body "
        "standing at some amplitude above the first that overturns it."
    )


def _variations(data: xr.Dataset) -> str:
    said: list[str] = []
    for name in dict.fromkeys(data["setting"].to_numpy().tolist()):
        if name == STATED.name:
            continue
        ratio = data["ratio"].to_numpy()[data["setting"].to_numpy() == name]
        said.append(
            f"{name}: {ratio.min():.2f} to {ratio.max():.2f}, "
            f"{int(inside(ratio).sum())} of {ratio.size} within ±20 %"
        )
    return (
        f"Under other conditions the ratios are: {'; '.join(said)}. So the formula is near the simulation "
        "for free bodies that land by Housner's rule. Landings that lose more, and a wall that stops half of "
        "the rocking, raise the capacity. Motions as they are drawn meet no smooth spectrum: their two peaks "
        "need not come from the same waves, so Fe says less of each, and the scatter is larger."
    )
