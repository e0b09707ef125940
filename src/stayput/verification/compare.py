"""Monte Carlo comparison of a piece of furniture without and with each measure."""

from __future__ import annotations

import time
from dataclasses import replace
from functools import cache, partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.errors import InputError, not_allowed, numbers
from stayput.fragility import JMA_INTENSITY, Trials, difference, fragility_curve, probability
from stayput.fragility.intensity_measures import FLOOR_JMA
from stayput.measures import hold
from stayput.measures.results import weakest
from stayput.mechanics.devices.columns import HOLDS
from stayput.montecarlo.counting import Quantiles
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.levels import run_levels
from stayput.montecarlo.runs import run_level
from stayput.montecarlo.sampling import Settings, draws, rows_of, sample_until_precise
from stayput.progress import bar
from stayput.verification.contents import contents_verdicts
from stayput.verification.options import compared_options
from stayput.verification.ranking import members, severity
from stayput.verification.verdict import AsInstalled, DeviceSummary, Estimates, OptionVerdict, Verdict

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from numpy.typing import ArrayLike, NDArray

    from stayput.catalogue import Phrase
    from stayput.fragility import FragilityCurve, IntensityMeasure
    from stayput.measures import Held
    from stayput.montecarlo.hazard import FloorMotions
    from stayput.montecarlo.levels import Falls
    from stayput.montecarlo.runs import Runs
    from stayput.montecarlo.sampling import Rows
    from stayput.scenario import Scenario
    from stayput.verification.contents import ContentsVerdict
    from stayput.verification.options import Option

LEVELS: NDArray[np.float64] = np.linspace(4.1, 6.95, 20)
"""JMA intensities of the ground for the fragility curves: from 4 to 7."""
LEVELS.setflags(write=False)

LEVELS_IN_SPACE: NDArray[np.float64] = LEVELS[1::3]
"""Those of them that a verification in space takes, whose runs are longer."""

CAPACITIES = (0.1, 0.5)
"""Shares of overturning for which the intensity is given."""


def curve_levels(dimensions: int) -> NDArray[np.float64]:
    """Return the levels of the curves by default, in the plane or in space."""
    return LEVELS if dimensions == 2 else LEVELS_IN_SPACE


def compare(
    scenario: Scenario,
    *,
    levels: ArrayLike | None,
    further: Sequence[IntensityMeasure] = (),
    slide_limit: float,
    every_run: bool,
    threads: int | None,
    progress: bool | None,
    on_progress: Callable[[int, int], None] | None,
    on_verdict: Callable[[Verdict], None] | None,
) -> Verdict:
    """Compare the measures of a scenario of one piece; see `stayput.verify`."""
    began, limit = time.perf_counter(), slide_limit
    if levels is None:
        levels = curve_levels(scenario.dimensions)
    rows = numbers("fragility.level", levels, "levels")
    if rows.ndim != 1:
        raise not_allowed("fragility.level", repr(levels), "common.list", "levels")
    if np.any(np.diff(rows) <= 0.0):
        raise InputError("verification.levels_not_increasing", "levels")
    (options, impossible), shaking = compared_options(scenario), scenario.shaking
    ground, dimensions = scenario.ground(), scenario.dimensions
    place = shaking.building, shaking.storey or 1
    hazard = Hazard(ground, *place, bool(shaking.vertical), dimensions, tuple(further))
    settings = Settings.of(scenario, len(ground), limit)
    faulty = _faulty(options, scenario)
    body, room = scenario.furniture.body(), scenario.room.room()
    held = [hold(body, room, option.measures, dimensions=dimensions) for option in options]
    total = len(ground) * settings.samples * (len(options) * (1 + len(rows)) + len(faulty))
    with bar(total, "progress.verifying", progress) as advance:
        seen = 0

        def count(runs: int) -> None:
            nonlocal seen
            seen += runs
            advance(runs)
            if on_progress is not None:
                on_progress(seen, total)

        floors = hazard.stated(shaking.strength, shaking.scale, settings.seed, threads)
        batches: list[list[Rows]] = []

        def run(_: list[int], samples: int, start: int) -> list[Runs]:
            batches.append(_rows(options, scenario, settings, samples, start))
            return run_level(batches[-1], floors, threads=threads, progress=count)

        estimates = Estimates.of(body, floors, scenario, threads)

        def ranked(outcomes: list[Runs], samples: int) -> Verdict:
            made = len(options) * len(ground) * samples
            return Verdict(
                scenario=scenario,
                intensity=floors.median_intensity,
                slide_limit=limit,
                options=_verdicts(options, held, outcomes, [], [], limit, {}, [None] * len(options)),
                estimates=estimates,
                levels=np.empty(0),
                motions=len(ground),
                samples=samples,
                runs=made,
                settled=0,
                precise=False,
                seed=settings.seed,
                seconds=time.perf_counter() - began,
                impossible=impossible,
                complete=False,
                floor=floors.floor,
            )

        def tell(outcomes: list[Runs], samples: int) -> None:
            if on_verdict is not None:
                on_verdict(ranked(outcomes, samples))

        # All options go on together, since they are compared sample by sample.
        here, samples, precise = sample_until_precise(
            len(options), settings, run, together=True, on_batch=None if on_verdict is None else tell
        )
        tell(here, samples)
        at_a_level, badly = len(options) * len(ground) * samples, len(faulty) * len(ground) * samples
        if unneeded := total - at_a_level * (1 + len(rows)) - badly:  # samples beyond the asked precision
            count(unneeded)
        installed: dict[str, AsInstalled] = {}
        if faulty:
            bad = _rows(tuple(each.option for each in faulty), scenario, settings, samples)
            found = run_level(bad, floors, threads=threads, progress=count)
            well = {option.name: runs for option, runs in zip(options, here, strict=True)}
            for each, runs in zip(faulty, found, strict=True):
                installed[each.option.name] = _as_installed(each, well[each.option.name], runs, limit)
        inside = contents_verdicts(options, scenario, floors, settings.seed, threads)
        floors_at = cache(partial(hazard.at, threads=threads))
        falls: list[Falls] = []
        made = 0
        if len(rows):
            drawn = batches[0] if len(batches) == 1 else _rows(options, scenario, settings, samples)
            falls, made = run_levels(
                drawn, rows, floors_at, every_run=every_run, threads=threads, progress=count
            )
        measures = [floors_at(float(level)) for level in rows]
    return replace(
        ranked(here, samples),
        options=_verdicts(options, held, here, falls, measures, limit, installed, inside),
        levels=rows,
        runs=at_a_level + badly + made,
        settled=at_a_level * len(rows) - made,
        precise=precise,
        complete=True,
    )


def _rows(
    options: tuple[Option, ...], scenario: Scenario, settings: Settings, samples: int, start: int = 0
) -> list[Rows]:
    """Return the rows of every option, for some samples of each motion."""
    body, room = scenario.furniture.body(), scenario.room.room()
    drawn = draws(
        settings.motions,
        samples,
        settings.seed,
        start,
        as_stated=settings.as_stated,
        quantities=settings.quantities,
    )
    initial, gravity = scenario.initial.state(), settings.gravity
    dimensions = scenario.dimensions
    return [rows_of(body, room, each.measures, drawn, gravity, initial, dimensions) for each in options]


class _Faulty(NamedTuple):
    """An option badly installed, what is wrong with it, and in what share."""

    option: Option
    how: tuple[Phrase, ...]
    share: float


def _faulty(options: tuple[Option, ...], scenario: Scenario) -> list[_Faulty]:
    """Return those options badly installed of which the scenario asks a share."""
    found: list[_Faulty] = []
    room = scenario.room.room()
    for option in options:
        worse = option.badly_installed(room)
        if worse is None:
            continue
        bad, wrong = worse
        share = scenario.uncertainty.badly(max(each.share for each in wrong))
        if share > 0.0:
            found.append(_Faulty(bad, tuple(each.how for each in wrong), share))
    return found


def _as_installed(faulty: _Faulty, well: Runs, badly: Runs, slide_limit: float) -> AsInstalled:
    share, ends = faulty.share, (well.probabilities(slide_limit), badly.probabilities(slide_limit))
    usual = {
        event: (1.0 - share) * chance.estimate + share * ends[1][event].estimate
        for event, chance in ends[0].items()
    }
    return AsInstalled(share, faulty.how, ends[1], usual)


def _curves(name: str, falls: Falls, measures: list[FloorMotions]) -> dict[IntensityMeasure, FragilityCurve]:
    return {
        im: fragility_curve(
            Trials.from_runs(
                FLOOR_JMA if im == JMA_INTENSITY and measures[0].floor else im,
                np.stack([floors.measures[im] for floors in measures]),
                falls.overturned,
                falls.missing,
            ),
            name=name,
        )
        for im in measures[0].measures
    }


def _verdicts(
    options: tuple[Option, ...],
    held: list[Held],
    stated: list[Runs],
    falls: list[Falls],
    measures: list[FloorMotions],
    slide_limit: float,
    installed: Mapping[str, AsInstalled],
    inside: list[ContentsVerdict | None],
) -> tuple[OptionVerdict, ...]:
    chances = [runs.probabilities(slide_limit) for runs in stated]
    order = sorted(range(len(options)), key=lambda i: (*severity(chances[i], len(options[i].measures)), i))
    verdicts: list[OptionVerdict] = []
    for rank, i in enumerate(order, start=1):
        runs, option = stated[i], options[i]
        curves = _curves(option.name, falls[i], measures) if measures else {}
        typical, worst = members(runs)
        verdicts.append(
            OptionVerdict(
                option=option,
                rank=rank,
                probabilities=chances[i],
                change=difference(
                    runs.overturned,
                    stated[0].overturned,
                    runs.missing | stated[0].missing,
                    comparisons=len(options) - 1,
                )
                if option.measures
                else None,
                slide=Quantiles.of(runs.slide, runs.overturned),
                tilt=Quantiles.of(runs.tilt, runs.overturned),
                devices=device_summaries(held[i], runs),
                curves=curves,
                capacities={p: curves[JMA_INTENSITY].capacity(p) for p in CAPACITIES} if curves else {},
                typical=typical,
                worst=worst,
                installed=installed.get(option.name),
                contents=inside[i],
            )
        )
    return tuple(verdicts)


def device_summaries(held: Held, runs: Runs) -> tuple[DeviceSummary, ...]:
    """Return a summary of each force element of a measure.

    Parameters
    ----------
    held : Held
        The body with the measures, as stated.
    runs : Runs
        Its runs.
    """
    nowhere = np.zeros_like(runs.overturned)
    summaries: list[DeviceSummary] = []
    for number, element in enumerate(held.elements):
        device = runs.devices[:, :, number]
        along = np.maximum(device["peak_pull"], device["peak_push"])
        force = runs.masses * np.hypot(along, device["peak_shear"])
        failed = device["failure"] != HOLDS
        times = device["failure_time"][failed & ~runs.missing]
        summaries.append(
            DeviceSummary(
                kind=element.kind,
                name=f"{element.kind} {element.place}".strip(),
                failed=probability(failed, runs.missing),
                failure_time=float(np.median(times)) if times.size else np.nan,
                peak=Quantiles.of(force, nowhere),
                used=Quantiles.of(runs.used[:, :, number], nowhere),
                weakest=weakest(element, device[~runs.missing]),
            )
        )
    return tuple(summaries)
