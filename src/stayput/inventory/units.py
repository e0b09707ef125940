"""Simulation of units: a piece with a set of measures on a floor, under all motions and all draws."""

from __future__ import annotations

import time
from functools import lru_cache
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from stayput.errors import InputError
from stayput.inventory.store import measures_of, piece_of
from stayput.montecarlo.counting import OVERTURNED, Outcomes, Quantiles
from stayput.montecarlo.runs import run_prepared
from stayput.montecarlo.sampling import draws, rows_of, sample_until_precise
from stayput.verification.contents import first_draws, share_out, spilt_under

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from stayput.contents import Contents
    from stayput.measures import Measure
    from stayput.model.body import Body
    from stayput.model.room import Room
    from stayput.montecarlo.hazard import PreparedFloor
    from stayput.montecarlo.sampling import DrawTable, Rows, Settings

Unit: TypeAlias = "tuple[int, str]"
"""Number of a unit, and the spec of its piece."""

BLOCK = 32_768
"""Most runs that are held in memory at a time: some 10 MB."""

_draws, _first_draws = lru_cache(maxsize=64)(draws), lru_cache(maxsize=64)(first_draws)
"""The draws: all units of a scenario have the same."""


def evaluate(
    units: Sequence[Unit],
    measures: str,
    floor: PreparedFloor,
    settings: Settings,
    kind: np.dtype[np.void],
) -> tuple[NDArray[np.void], int, float]:
    """Simulate units of one set of measures and one floor on this thread.

    Parameters
    ----------
    units : sequence
        Numbers, and specs of the pieces.
    measures : str
        Spec of their measures.
    floor : PreparedFloor
        What shakes them.
    settings : Settings
        Monte Carlo settings.
    kind : dtype
        Type of their records; see `stayput.inventory.records.record_type`.

    Returns
    -------
    tuple
        Their records, the runs that were done, and the time they took [s].
    """
    began = time.perf_counter()
    option, runs = measures_of(measures), 0
    records = np.zeros(len(units), kind)
    records["unit"] = [number for number, _ in units]
    records["out"] = np.nan
    size = max(1, BLOCK // (settings.motions * settings.samples))
    for first in range(0, len(units), size):
        last = min(first + size, len(units))
        runs += _block([spec for _, spec in units[first:last]], option, floor, settings, records[first:last])
    return records, runs, time.perf_counter() - began


def _block(
    specs: list[str],
    option: tuple[Measure, ...],
    floor: PreparedFloor,
    settings: Settings,
    out: NDArray[np.void],
) -> int:
    """Simulate a block of units, fill in their records and return the number of runs."""
    runs = 0
    pieces = [piece_of(spec) for spec in specs]

    def run(places: list[int], samples: int, start: int) -> list[Outcomes]:
        nonlocal runs
        runs += len(places) * settings.motions * samples
        drawn = _draws(settings.motions, samples, settings.seed, start, as_stated=settings.as_stated)
        rows = [_rows_or_none(*pieces[place][:2], option, drawn, settings.gravity) for place in places]
        possible = [row for row in rows if row is not None]
        outcomes = iter(run_prepared(possible, floor) if possible else ())
        return [Outcomes.impossible(drawn.shape) if row is None else next(outcomes) for row in rows]

    outcomes, _, _ = sample_until_precise(len(specs), settings, run, together=False)
    for place, (outcome, (body, room, contents)) in enumerate(zip(outcomes, pieces, strict=True)):
        fill_record(out[place : place + 1], outcome, settings.slide_limit)
        if contents is not None:
            out["out"][place] = _share_out(body, room, contents, option, floor, settings)
    return runs


def _share_out(
    body: Body,
    room: Room,
    contents: Contents,
    option: tuple[Measure, ...],
    floor: PreparedFloor,
    settings: Settings,
) -> tuple[float, float, float]:
    """Return the share of the contents that comes out, and its interval, as a verification follows them."""
    drawn = _first_draws(settings.motions, settings.seed, settings.as_stated)
    rows = _rows_or_none(body, room, option, drawn, settings.gravity)
    if rows is None:
        return np.nan, np.nan, np.nan
    spilt = [spilt_under(rows, number, floor, body, contents, leaving=False) for number in range(len(drawn))]
    share = share_out(spilt, contents)
    return share.estimate, share.low, share.high


def _rows_or_none(
    body: Body, room: Room, option: tuple[Measure, ...], drawn: DrawTable, gravity: float
) -> Rows | None:
    try:
        return rows_of(body, room, option, drawn, gravity)
    except InputError:  # a draw in which the measure is not possible: all its runs count as given up
        return None


def fill_record(out: NDArray[np.void], outcomes: Outcomes, slide_limit: float) -> None:
    """Fill in the record of a unit, shape (1,)."""
    chances = outcomes.probabilities(slide_limit)
    fallen = chances[OVERTURNED]
    for name in ("motions", "runs", "missing", "fell"):
        out[name] = getattr(fallen, name)
    out["chances"][0] = [(chance.estimate, chance.low, chance.high) for chance in chances.values()]
    slide = Quantiles.of(outcomes.slide, outcomes.overturned)
    upright = outcomes.slide[~outcomes.missing & ~outcomes.overturned]
    mean = float(upright.sum() / len(upright)) if len(upright) else np.nan
    out["slide"][0] = (slide.median, slide.p90, mean)
    motions, samples = outcomes.missing.shape
    planes, rows, columns = out["each"].shape[1:]
    each = np.zeros((planes, rows, 8 * columns), np.bool_)
    each[-1] = True
    each[:, :motions, :samples] = (*outcomes.happened(slide_limit), outcomes.missing)
    out["each"][0] = np.packbits(each, axis=-1)
