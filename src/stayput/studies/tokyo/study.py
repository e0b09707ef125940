"""The Tokyo Metropolitan Government's product test of 2015 with stated parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING

import xarray as xr

from stayput.errors import within
from stayput.motion import near_fault
from stayput.progress import bar
from stayput.studies.study import Study
from stayput.studies.tokyo.devices import ALONE, OPTIONS
from stayput.studies.tokyo.figures import draw_facings, draw_outcomes, draw_variations
from stayput.studies.tokyo.published import BODIES, LEVELS
from stayput.studies.tokyo.runs import facings, severest, shares, tested
from stayput.studies.tokyo.tables import (
    claims,
    claims_table,
    devices_table,
    names,
    outcomes_table,
    variations_table,
)
from stayput.studies.tokyo.text import text_of
from stayput.studies.tokyo.variations import PIECE, PROBES, VARIATIONS, varied

if TYPE_CHECKING:
    from stayput.motion import Motion


def tokyo(
    motion: Motion | None = None, *, samples: int = 32, seed: int = 1, variations: bool = True
) -> Study:
    """Repeat the Tokyo test of devices: what overturns or moves, with each alone and with two together.

    A chest and a cupboard with their backs to a wall, under the motion at 100 % and 60 %; every device and
    facing meets the same draws of what is not known.

    Parameters
    ----------
    motion : Motion, optional
        The record, with y and z where it has them; default `near_fault`. The test's is JMA Kobe 1995.
        The piece faces +x (the component x along its depth, its back to −x), −x and, with a y, +y and −y.
    samples : int
        Draws for each facing.
    seed : int
        Seed of the draws.
    variations : bool
        Whether to change stated values one at a time, too.

    Returns
    -------
    Study
        Figures "outcomes", "facings" and "variations". Data over ``body``, ``level``, ``device``, ``facing``
        and ``sample``, and ``overturned_share`` over ``variation``, ``level``, ``probe`` and ``facing``.

    Raises
    ------
    InputError
        A number of samples or a seed out of range.
    """
    shaking = near_fault() if motion is None else motion
    count = int(within("Samples", samples, 1, 10_000))
    changed = VARIATIONS if variations else VARIATIONS[:1]
    each = len(facings(shaking)) * count * len(LEVELS)
    touched = sum(variation.touches(option) for variation in changed for option in PROBES)
    with bar(each * (len(BODIES) * len(OPTIONS) + touched), "Testing") as tell:
        runs = tested(shaking, OPTIONS, count, seed, tell)
        change = varied(shaking, changed, count, seed, tell)
    found = shares(runs)
    facing = severest(found, names(ALONE))
    said = claims(found, facing)
    name = f"{shaking.name or 'the record'}{' (synthetic)' if shaking.synthetic else ''}"
    tables = {"The published result beside ours": claims_table(said)}
    for level in LEVELS:
        caption = (
            f"At {100 * level:g} % of the record: shares of the draws [%] facing {facing}, "
            "and over all facings in brackets"
        )
        tables[caption] = outcomes_table(found, facing, level)
    figures = {
        "outcomes": draw_outcomes(found, facing, name),
        "facings": draw_facings(found, name),
    }
    if variations:
        figures["variations"] = draw_variations(change, PIECE, name)
        tables[
            f"Shares of the draws in which the {PIECE} overturns [%], over all facings, and the largest of a "
            "facing in brackets; empty: not touched"
        ] = variations_table(change)
    tables["What the devices are here; several values: one for each device"] = devices_table()
    return Study(
        name="tokyo",
        title="The Tokyo test of 2015, with stated parameters",
        text=text_of(shaking, runs, found, facing, said, change),
        data=xr.merge([runs, change.rename(overturned="overturned_share")]).assign_attrs(
            motion=shaking.name, severest_facing=facing, seed=seed
        ),
        figures=figures,
        tables=tables,
    )
