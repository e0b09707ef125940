"""The app's size map: how often a piece overturns, by its size and the intensity, with a verdict's draws."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from stayput.app.jobs import StoppedError
from stayput.app.refusals import problem, refused
from stayput.app.run_replies import OwnPieceReply, SizeMapReply
from stayput.app.running import own_measures
from stayput.errors import InputError
from stayput.measures import hold
from stayput.model.body import MASS_RANGE, SIZE_RANGE, Body
from stayput.model.state import State, refuse_bad_start
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.levels import run_levels
from stayput.montecarlo.sampling import DrawTable, Rows, draws, rows_of
from stayput.motion.channels import of_the_ground
from stayput.motion.suites import Suite
from stayput.verification.options import require_coulomb

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from stayput.measures import Measure
    from stayput.montecarlo.hazard import FloorMotions
    from stayput.scenario import Scenario

LOWEST, HIGHEST, STEP = 4.4, 7.0, 0.2
"""The JMA intensities of the ground that the map covers, and how far apart they are."""

SIZES: NDArray[np.float64] = np.round(np.linspace(0.5, 1.5, 11), 2)
"""Factors on the size."""
SIZES.setflags(write=False)

RUNS = 40
"""Runs of a size at an intensity: of as many motions, or of several samples of each where there are fewer."""

RUNS_YIELDING, RUNS_HELD = 10, 8
"""The same in a building whose storeys yield, and where devices hold the piece: both take longer."""


def scaled_body(body: Body, across: float, up: float) -> Body:
    """Return a piece of the same kind, wider and higher: mass and inertia grow with its section.

    Raises
    ------
    InputError
        A size that is not possible.
    """
    area = across * up
    # J = m (b² + h²)/12 of a rectangle; the given one keeps its ratio to that
    ratio = body.inertia_about_cg / body.uniform_inertia
    grown = Body(
        float(np.clip(across * body.width, *SIZE_RANGE)),
        float(np.clip(up * body.height, *SIZE_RANGE)),
        float(np.clip(area * body.mass, *MASS_RANGE)),
        (across * body.cg_offset[0], up * body.cg_offset[1]),
        base_heights=body.base_heights,
        length=body.length,
    )
    return replace(grown, inertia=ratio * grown.uniform_inertia)


def intensities(own: float | None) -> NDArray[np.float64]:
    """Return the intensities of a map's columns: the scene's own is one of them where the map covers it."""
    first = LOWEST
    if own is not None and LOWEST <= own <= HIGHEST:
        first = own - STEP * np.floor((own - LOWEST) / STEP + 1e-9)
    return np.round(np.arange(first, HIGHEST + 1e-9, STEP), 4)


def size_map(
    scenario: Scenario, axis: str, threads: int, awaited: Callable[[], bool] = lambda: True
) -> SizeMapReply:
    """Run pieces of all sizes at all intensities.

    Parameters
    ----------
    scenario : Scenario
        The scene.
    axis : str
        What grows: "height", "width" or "size", which is both.
    threads : int
        Threads.
    awaited : callable
        Whether anybody still waits for the map; asked before each intensity.

    Raises
    ------
    StoppedError
        Nobody waits for it.
    RefusedError
        A scene in space.
    InputError
        The paper's contact law, or measures that cannot be applied to the piece as it stands.
    """
    require_coulomb(scenario, "verification.the_map")
    if scenario.dimensions == 3:
        raise refused(422, "app.map_in_space", "scene.dimensions")
    shaking = scenario.shaking
    body, measures = scenario.furniture.body(), own_measures(scenario)
    runs = RUNS if shaking.building is None or not shaking.building.yields else RUNS_YIELDING
    if hold(body, scenario.room.room(), measures).elements:
        runs = RUNS_HELD
    ground = Suite(tuple(of_the_ground(motion, "map") for motion in scenario.ground().motions[:runs]))
    samples, uncertainty = -(-runs // len(ground)), scenario.uncertainty
    drawn = draws(len(ground), samples, uncertainty.seed, as_stated=uncertainty.as_stated)
    hazard = Hazard(ground, shaking.building, shaking.storey or 1, vertical=bool(shaking.vertical))
    across = np.where(axis == "height", 1.0, SIZES)
    up = np.where(axis == "width", 1.0, SIZES)
    bodies = [scaled_body(body, float(a), float(u)) for a, u in zip(across, up, strict=True)]
    rows = [_rows_or_refusal(scaled, scenario, measures, drawn) for scaled in bodies]
    possible = {place: row for place, row in enumerate(rows) if isinstance(row, Rows)}
    strength = shaking.strength
    if strength is None:
        own = _own_intensity(ground, shaking.scale)
    elif strength.measure == "JMA":
        own = strength.level
    else:
        own = hazard.stated(strength, None, uncertainty.seed, threads).median_intensity
    levels = intensities(own)
    share = np.full((len(bodies), len(levels)), np.nan)
    if possible:

        @cache
        def floors_at(level: float) -> FloorMotions:
            if not awaited():
                raise StoppedError
            return hazard.at(level, threads)

        by_size, _ = run_levels(list(possible.values()), levels, floors_at, threads=threads)
        for place, falls in zip(possible, by_size, strict=True):
            ended = np.sum(~falls.missing, axis=(1, 2))
            fell = np.sum(falls.overturned, axis=(1, 2))
            share[place] = np.where(ended > 0, fell / np.maximum(ended, 1), np.nan)
    return SizeMapReply(
        axis=axis,
        intensity=levels.tolist(),
        size=SIZES.tolist(),
        width_m=[scaled.width for scaled in bodies],
        height_m=[scaled.height for scaled in bodies],
        overturned=share.round(4).tolist(),
        refused=[problem(row.about(None)) if isinstance(row, InputError) else None for row in rows],
        motions=len(ground),
        runs=len(ground) * samples,
        here=OwnPieceReply(
            intensity=own,
            width_m=body.width,
            height_m=body.height,
        ),
    )


def _rows_or_refusal(
    body: Body, scenario: Scenario, measures: tuple[Measure, ...], drawn: DrawTable
) -> Rows | InputError:
    """Return the rows of a piece at rest under all draws, or why it is not possible."""
    room = scenario.room.room()
    try:
        held = hold(body, room, measures)
        refuse_bad_start(held.body, held.room, State())
        return rows_of(body, room, measures, drawn, scenario.gravity)
    except InputError as error:  # higher than the room, a pole that is too long
        return error


def _own_intensity(ground: Suite, scale: float | None) -> float | None:
    """Return the intensity of motions that keep their own strength, in the middle of them."""
    factor = abs(1.0 if scale is None else scale)
    intensities = [
        motion.intensity + 2.0 * np.log10(factor) if factor > 0.0 else -np.inf for motion in ground
    ]
    middle = float(np.median(intensities))
    return middle if np.isfinite(middle) else None
