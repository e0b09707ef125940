"""The map of size against intensity: which pieces of this kind overturn in which shaking."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from stayput.app.run_replies import Here, SizeMapReply
from stayput.app.running import yours
from stayput.body import SIZE_RANGE, Body
from stayput.cases import State, case_columns, refuse_penetration
from stayput.ensemble.columns import run_columns
from stayput.errors import InputError
from stayput.measures import element_rows, hold
from stayput.mechanics.columns import FAILED_OUTCOME, OVERTURNED_OUTCOME
from stayput.motion.suites import Suite
from stayput.verification.hazard import Hazard

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from stayput.measures import Measure
    from stayput.scenario import Scenario

INTENSITIES: NDArray[np.float64] = np.round(np.linspace(4.4, 7.0, 14), 2)
"""JMA intensities of the ground."""
INTENSITIES.setflags(write=False)

SIZES: NDArray[np.float64] = np.round(np.linspace(0.5, 1.5, 11), 2)
"""Factors on the size."""
SIZES.setflags(write=False)

MOTIONS = 12
"""Most motions of a suite that are run."""

MOTIONS_YIELDING, MOTIONS_HELD = 6, 4
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
        float(np.clip(area * body.mass, 1e-3, 1e6)),
        (across * body.cg_offset[0], up * body.cg_offset[1]),
        base_heights=body.base_heights,
    )
    return replace(grown, inertia=ratio * grown.uniform_inertia)


def size_map(scenario: Scenario, axis: str, threads: int) -> SizeMapReply:
    """Run pieces of all sizes at all intensities.

    Parameters
    ----------
    scenario : Scenario
        The scene.
    axis : str
        What grows: "height", "width" or "size", which is both.
    threads : int
        Threads.

    Raises
    ------
    InputError
        The paper's contact law, or measures that cannot be applied to the piece as it stands.
    """
    if scenario.contact != "coulomb":
        raise InputError(f'The contact is "{scenario.contact}"; the map needs "coulomb".')
    shaking = scenario.shaking
    body, measures = scenario.furniture.body(), yours(scenario)
    most = MOTIONS if shaking.building is None or not shaking.building.yields else MOTIONS_YIELDING
    if hold(body, scenario.room.room(), measures).elements:
        most = MOTIONS_HELD
    ground = Suite(shaking.ground(scenario.folder).motions[:most])
    hazard = Hazard(ground, shaking.building, shaking.storey or 1, vertical=bool(shaking.vertical))
    across = np.where(axis == "height", 1.0, SIZES)
    up = np.where(axis == "width", 1.0, SIZES)
    bodies = [scaled_body(body, float(a), float(u)) for a, u in zip(across, up, strict=True)]
    rows = [_row(one, scenario, measures) for one in bodies]
    possible = [i for i, row in enumerate(rows) if row is not None]
    share = np.full((len(bodies), len(INTENSITIES)), np.nan)
    if possible:
        cases = np.concatenate([rows[i][0] for i in possible])  # type: ignore[index]
        elements = np.stack([rows[i][1] for i in possible])  # type: ignore[index]
        for column, level in enumerate(INTENSITIES):
            share[possible, column] = _overturned(cases, elements, hazard, float(level), threads)
    wanted = shaking.wanted_intensity
    return SizeMapReply(
        axis=axis,
        intensity=INTENSITIES.tolist(),
        size=SIZES.tolist(),
        width_m=[one.width for one in bodies],
        height_m=[one.height for one in bodies],
        overturned=share.round(4).tolist(),
        motions=len(ground),
        here=Here(
            intensity=_own_intensity(ground, shaking.scale) if wanted is None else wanted,
            width_m=body.width,
            height_m=body.height,
        ),
    )


def _row(
    body: Body, scenario: Scenario, measures: tuple[Measure, ...]
) -> tuple[NDArray[np.void], NDArray[np.void]] | None:
    """Return the case and the elements of a piece; nothing where the measures do not fit it."""
    try:
        held = hold(body, scenario.room.room(), measures)
        refuse_penetration(held.body, held.room, State())
    except InputError:  # higher than the room, a pole that is too long
        return None
    return case_columns(held.body, held.room, State(), scenario.gravity), element_rows(held)


def _overturned(
    cases: NDArray[np.void], elements: NDArray[np.void], hazard: Hazard, level: float, threads: int
) -> NDArray[np.float64]:
    """Return the share of the motions that overturn each case at a level, shape [cases]."""
    floors = hazard.at(level, threads)
    motions = len(floors.motions)
    place = np.tile(np.arange(motions), len(cases))
    every = np.repeat(cases, motions)
    every["scale"] = floors.scales[place]
    given = np.repeat(elements, motions, axis=0) if elements.shape[1] else None
    results, _ = run_columns(every, given, floors.motions, place, threads=threads, progress=False)
    outcome = results["outcome"].reshape(len(cases), motions)
    fell, known = outcome == OVERTURNED_OUTCOME, outcome != FAILED_OUTCOME
    count = known.sum(axis=1)
    return np.divide(fell.sum(axis=1), count, out=np.full(len(cases), np.nan), where=count > 0)


def _own_intensity(ground: Suite, scale: float | None) -> float | None:
    """Return the intensity of motions that keep their own strength, in the middle of them."""
    factor = abs(1.0 if scale is None else scale)
    found = [motion.intensity + 2.0 * np.log10(factor) if factor > 0.0 else -np.inf for motion in ground]
    middle = float(np.median(found))
    return middle if np.isfinite(middle) else None
