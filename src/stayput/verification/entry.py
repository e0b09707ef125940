"""`verify`: which measures keep furniture standing, of a scenario or of Python objects."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from os import PathLike
from typing import TYPE_CHECKING, Any

from stayput.catalogue import phrase
from stayput.errors import InputError, instance_of, list_of, within
from stayput.fragility.intensity_measures import IntensityMeasure, intensity_measure
from stayput.model.body import Body
from stayput.model.room import Room
from stayput.montecarlo.counting import SLIDE_LIMIT
from stayput.scenario import Scenario
from stayput.scenario.in_python import MeasureSets, StatedShaking, scenario_of, scenario_of_case
from stayput.simulation.case import Case
from stayput.verification.compare import compare

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from stayput.building.building import Building
    from stayput.building.model import ShearModel
    from stayput.uncertainty import Uncertainty
    from stayput.verification.verdict import Verdict


def verify(
    what: Scenario | Case | Body,
    room: Room | None = None,
    *,
    shaking: StatedShaking | None = None,
    building: Building | ShearModel | None = None,
    storey: int | None = None,
    measures: MeasureSets | None = None,
    changes: bool = True,
    uncertainty: Uncertainty | None = None,
    samples: int | None = None,
    seed: int | None = None,
    precision: float | None = None,
    levels: ArrayLike | None = None,
    intensity_measures: Sequence[IntensityMeasure] = (),
    slide_limit: float = SLIDE_LIMIT,
    every_run: bool = False,
    threads: int | None = None,
    progress: bool | None = None,
    on_progress: Callable[[int, int], None] | None = None,
    on_verdict: Callable[[Verdict], None] | None = None,
) -> Verdict:
    """Compare measures over motions and over draws of the uncertain quantities.

    Every option meets the same motions and the same draws. At the stated shaking samples are added until
    every probability has the precision that is asked for, or the most samples are done; then come the levels
    of the fragility curves, without the runs whose outcome stronger shaking tells: see
    `stayput.montecarlo.runs`.

    Parameters
    ----------
    what : Body, Case or Scenario
        What stands. A case has its room, its motion, which comes from where it says, and its own measures; a
        scenario says everything. Where the motions of a body come from is drawn, if it has a length. Of
        several pieces joints and measures on each are compared, and of a room single changes of it.
    room : Room, optional
        Where a body stands; on a wooden floor without walls by default.
    shaking : Motion, Suite, sequence of Motion, str, float or mapping
        How a body is shaken: by motions as they are; by the built-in suite to a JMA intensity of the ground
        or its class, "6-upper"; or as ``[shaking]`` of a scenario file says, ``{"pga": 4.0}``.
    building : Building or ShearModel, optional
        The building in which a body stands; the shaking is that of the ground below it.
    storey : int, optional
        The storey of the building where a body stands.
    measures : sequence or mapping, optional
        What a body or a case is compared with: each a `Measure`, of one's own as well, or several that are in
        place together; a mapping names them. With none in it only the furniture without measures is verified,
        or with a case's own. The usual ones by default.
    changes : bool
        Whether single changes are tried in a room that names no options: a measure on each piece that does
        harm or falls, another place for it, and for those whom it hits.
    uncertainty : Uncertainty, optional
        The quantities that are drawn for a body or a case, by the names of `stayput.uncertainty.USUAL`; what
        is not in it is as stated. All, as they are usually, by default.
    samples, seed : int, optional
        Most samples of each set of measures, and the seed of the draws, of a body or a case.
    precision : float, optional
        Half-width of the 95 % interval of the probability of overturning that is enough, of a body or a case.
    levels : array_like, optional
        JMA intensities of the ground for the fragility curves, increasing; with none in it there are no
        curves. Default `stayput.verification.LEVELS`; of several pieces and rooms none.
    intensity_measures : sequence of IntensityMeasure, optional
        What else the curves are drawn against, beside the usual measures: ``MMI`` of
        `stayput.fragility.intensity_measures`, or its ``spectral_acceleration`` at a period.
    slide_limit : float
        Slide that counts as too far [m].
    every_run : bool
        Whether to make all runs of the curves, to check those that are settled without.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    progress : bool, optional
        Whether to draw a bar on standard error; default on a terminal.
    on_progress : callable, optional
        Called with the runs made or settled and with all runs, for a bar of one's own; an exception that it
        raises stops the work.
    on_verdict : callable, optional
        Called with the ranking as it gets better, before it is `complete`: after some samples, after all and
        each change, and then come the curves and all else. The samples' bits do not depend on it.

    Returns
    -------
    Verdict
        The options, the best first.

    Raises
    ------
    InputError
        The paper's contact law, which knows no devices; measures of which none can be applied; a record
        that cannot be read; what a scenario says already, given beside it.

    Examples
    --------
    >>> import stayput as sp
    >>> bookcase, room = sp.Body(0.3, 1.8, 90.0), sp.Room(left_wall=sp.Wall(0.01))
    >>> brackets = sp.MEASURES["l_bracket"]()
    >>> verdict = sp.verify(bookcase, room, shaking="6-lower", measures=[brackets], samples=20, levels=[])
    >>> verdict.best.option.name
    'l_bracket'

    Motions of the ground, and a building between it and the bookcase:

    >>> tower, records = sp.Building(6, "RC"), [sp.near_fault(), sp.near_fault().scaled(0.5)]
    >>> verdict = sp.verify(bookcase, room, shaking=records, building=tower, storey=5, samples=4, levels=[])
    >>> verdict.motions
    2
    """
    limit = within("verification.slide_limit", slide_limit, 0.0, 1e3, "m", "slide_limit")
    settings = {"samples": samples, "seed": seed, "precision": precision}
    stated = {key: value for key, value in settings.items() if value is not None}
    place: dict[str, Any] = {"building": building, "storey": storey}
    in_python = {"room": room, "shaking": shaking, **place, "measures": measures, "uncertainty": uncertainty}
    if isinstance(what, str | PathLike):
        raise InputError("common.only_a_path", "what", value=repr(str(what)), reader="read_scenario")
    subject = instance_of("what", what, (Scenario, Case, Body))
    tables: dict[str, Any] = {"uncertainty": stated} if stated else {}
    match subject:
        case Body():
            if shaking is None:
                raise InputError("scenario.missing", "shaking", allowed=phrase("verification.no_shaking"))
            scenario = scenario_of(
                subject, room or Room(), shaking, measures, uncertainty, **place, tables=tables
            )
        case Case():
            _refuse_beside(subject, {key: in_python[key] for key in ("room", "shaking", *place)})
            scenario = scenario_of_case(subject, measures, uncertainty, tables=tables)
        case _:
            _refuse_beside(subject, in_python | settings)
            scenario = subject
    further = list_of("intensity_measures", intensity_measures, IntensityMeasure)
    known = dict.fromkeys(intensity_measure(measure.key, "intensity_measures") for measure in further)
    return compare(
        scenario,
        changes=changes,
        levels=levels,
        further=[*known],
        slide_limit=limit,
        every_run=every_run,
        threads=threads,
        progress=progress,
        on_progress=on_progress,
        on_verdict=on_verdict,
    )


def _refuse_beside(what: Scenario | Case, stated: dict[str, Any]) -> None:
    """Refuse what something says already, given beside it."""
    for name, value in stated.items():
        if value is not None:
            where = phrase("verification.said_already", kind=type(what).__name__)
            raise InputError("common.left_out", name, where=where)
