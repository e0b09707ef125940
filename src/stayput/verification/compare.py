"""Monte Carlo comparison of one piece, or of several, without and with each measure or joint."""

from __future__ import annotations

import time
from dataclasses import replace
from functools import cache, partial
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from stayput.errors import InputError, not_allowed, numbers
from stayput.fragility import JMA_INTENSITY, Trials, difference, fragility_curve, probability
from stayput.fragility.intensity_measures import FLOOR_JMA
from stayput.measures import Element, Held, hold
from stayput.measures.element import weakest
from stayput.mechanics.devices.columns import HOLDS
from stayput.montecarlo.counting import Outcomes, Quantiles, members, severity
from stayput.montecarlo.hazard import FloorMotions, Hazard
from stayput.montecarlo.runs import Falls, Runs, run_level, run_levels
from stayput.montecarlo.sampling import Rows, Settings, draws, rows_of, sample_until_precise
from stayput.montecarlo.several import RunsOfSeveral, draws_of_several, run_several
from stayput.progress import tally
from stayput.simulation.placing import JOINT, placed
from stayput.simulation.space import warn_of_settlement
from stayput.verification.contents import ContentsVerdict, contents_verdicts
from stayput.verification.notes import Estimates
from stayput.verification.options import Option, compared_options, options_of_several
from stayput.verification.verdict import (
    AsInstalled,
    AssemblyOptionVerdict,
    AssemblyVerdict,
    DeviceOfSeveral,
    DeviceSummary,
    OptionVerdict,
    PieceVerdict,
    Verdict,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping, Sequence
    from typing import Any

    from numpy.typing import ArrayLike, NDArray

    from stayput.catalogue import Phrase
    from stayput.fragility import FragilityCurve, IntensityMeasure
    from stayput.scenario import Scenario
    from stayput.scenario.pieces import AssemblyOption
    from stayput.simulation.scene import Scene

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
    options, impossible = compared_options(scenario)
    hazard, dimensions = Hazard.of(scenario, tuple(further)), scenario.dimensions
    ground = hazard.ground
    settings = Settings.of(scenario, len(ground), limit)
    faulty = _badly_installed(options, scenario)
    body, room = scenario.piece.body(), scenario.room.room()
    held = [hold(body, room, option.measures, dimensions=dimensions) for option in options]
    total = len(ground) * settings.samples * (len(options) * (1 + len(rows)) + len(faulty))
    with tally(total, "progress.verifying", progress, on_progress) as count:
        floors = hazard.stated_by(scenario, threads)
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
                options=_verdicts(options, held, outcomes, limit),
                estimates=estimates,
                levels=np.empty(0),
                motions=len(ground),
                samples=samples,
                runs=made,
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
            bad = _rows(tuple(option for option, *_ in faulty), scenario, settings, samples)
            bad_runs = run_level(bad, floors, threads=threads, progress=count)
            well = {option.name: runs for option, runs in zip(options, here, strict=True)}
            for (option, how, share), runs in zip(faulty, bad_runs, strict=True):
                installed[option.name] = _as_installed(how, share, well[option.name], runs, limit)
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
        options=_verdicts(options, held, here, limit, falls, measures, installed, inside),
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
    body, room = scenario.piece.body(), scenario.room.room()
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


def _badly_installed(
    options: tuple[Option, ...], scenario: Scenario
) -> list[tuple[Option, tuple[Phrase, ...], float]]:
    """Return the options badly installed of which the scenario asks a share, what is wrong, and the share."""
    faulty: list[tuple[Option, tuple[Phrase, ...], float]] = []
    for option in options:
        bad, wrong = option.badly_installed(scenario.room.room()) or (option, ())
        share = scenario.uncertainty.badly(max(each.share for each in wrong)) if wrong else 0.0
        if share > 0.0:
            faulty.append((bad, tuple(each.how for each in wrong), share))
    return faulty


def _as_installed(
    how: tuple[Phrase, ...], share: float, well: Runs, badly: Runs, limit: float
) -> AsInstalled:
    ends = well.probabilities(limit), badly.probabilities(limit)
    usual = {
        event: (1.0 - share) * chance.estimate + share * ends[1][event].estimate
        for event, chance in ends[0].items()
    }
    return AsInstalled(share, how, ends[1], usual)


def _curves(
    name: str, falls: Falls, measures: Sequence[FloorMotions]
) -> dict[IntensityMeasure, FragilityCurve]:
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
    slide_limit: float,
    falls: Sequence[Falls] = (),
    measures: Sequence[FloorMotions] = (),
    installed: Mapping[str, AsInstalled] = MappingProxyType({}),
    inside: Sequence[ContentsVerdict | None] = (),
) -> tuple[OptionVerdict, ...]:
    verdicts: list[OptionVerdict] = []
    for i, outcomes in ranked_outcomes(stated, [len(option.measures) for option in options], slide_limit):
        option, runs = options[i], stated[i]
        curves = _curves(option.name, falls[i], measures) if measures else {}
        verdicts.append(
            OptionVerdict(
                option=option,
                **outcomes,
                devices=tuple(
                    device_summary(element.kind, element, number, runs, runs.masses)
                    for number, element in enumerate(held[i].elements)
                ),
                curves=curves,
                capacities={p: curves[JMA_INTENSITY].capacity(p) for p in CAPACITIES} if curves else {},
                installed=installed.get(option.name),
                contents=inside[i] if inside else None,
            )
        )
    return tuple(verdicts)


def ranked_outcomes(
    runs: Sequence[Outcomes], costs: Sequence[int], slide_limit: float
) -> Iterator[tuple[int, dict[str, Any]]]:
    """Yield the number of each option, the best first, and what its verdict tells of all its runs, by field.

    Parameters
    ----------
    runs : sequence of Outcomes
        Those of each option, that without anything first.
    costs : sequence of int
        How many things each option puts in place.
    slide_limit : float
        Slide that counts as too far [m].
    """
    chances, bare, count = [each.probabilities(slide_limit) for each in runs], runs[0], len(runs) - 1
    order = sorted(range(len(runs)), key=lambda i: (*severity(chances[i], costs[i]), i))
    for rank, i in enumerate(order, start=1):
        held, missing = runs[i], runs[i].missing | bare.missing
        typical, worst = members(held)
        fields: dict[str, Any] = {
            "rank": rank,
            "probabilities": chances[i],
            "change": difference(held.overturned, bare.overturned, missing, comparisons=count) if i else None,
            "slide": Quantiles.of(held.slide, held.overturned),
            "tilt": Quantiles.of(held.tilt, held.overturned),
            "typical": typical,
            "worst": worst,
        }
        yield i, fields


def device_summary(
    kind: str,
    element: Element | None,
    number: int,
    runs: Runs | RunsOfSeveral,
    mass: NDArray[np.float64] | float = 1.0,
) -> DeviceSummary:
    """Return a summary of the device of a number, or of a joint, which is no element of a measure.

    Parameters
    ----------
    kind : str
        The measure that it belongs to.
    element : Element or None
        The device.
    number : int
        Its place among all devices of the runs.
    runs : Runs or RunsOfSeveral
        The runs.
    mass : ndarray or float
        By what their forces are multiplied: the body's mass [kg] where they are per unit mass.
    """
    device, missing = runs.devices[:, :, number], runs.missing
    nowhere = np.zeros_like(missing)
    along = np.maximum(device["peak_pull"], device["peak_push"])
    failed = device["failure"] != HOLDS
    times = device["failure_time"][failed & ~missing]
    return DeviceSummary(
        kind=kind,
        name=kind if element is None else f"{kind} {element.place}".strip(),
        failed=probability(failed, missing),
        failure_time=float(np.median(times)) if times.size else np.nan,
        peak=Quantiles.of(mass * np.hypot(along, device["peak_shear"]), nowhere),
        used=Quantiles.of(runs.used[:, :, number], nowhere),
        weakest=None if element is None else weakest(element, device[~missing]),
    )


def verify_several(
    scenario: Scenario,
    *,
    slide_limit: float,
    threads: int | None = None,
    progress: bool | None = None,
    on_progress: Callable[[int, int], None] | None = None,
) -> AssemblyVerdict:
    """Compare what may hold several pieces, at the scenario's own shaking; see `stayput.verify`.

    Raises
    ------
    InputError
        Options of which none can be put in place, or a record that cannot be read.
    """
    began = time.perf_counter()
    options, rejected = options_of_several(scenario)
    hazard = Hazard.of(scenario)
    ground = hazard.ground
    settings = Settings.of(scenario, len(ground), slide_limit)
    scenes = [scenario.scene(option) for option in options]
    warn_of_settlement(scenes[0])
    total = len(ground) * settings.samples * len(options)
    draw = partial(
        draws_of_several,
        scenario.names,
        settings.motions,
        seed=settings.seed,
        as_stated=settings.as_stated,
        quantities=settings.quantities,
        direction=scenario.direction or 0.0,
    )
    with tally(total, "progress.verifying", progress, on_progress) as count:
        floors = hazard.stated_by(scenario, threads)

        def run(_: list[int], samples: int, start: int) -> list[RunsOfSeveral]:
            drawn = draw(samples, start=start)
            counted, gravity = scenario.counted, scenario.gravity
            return run_several(scenes, drawn, floors, gravity, counted, threads=threads, progress=count)

        with scenario.naming_keys():
            runs, samples, precise = sample_until_precise(len(options), settings, run, together=True)
        made = len(options) * len(ground) * samples
        if made < total:  # samples beyond the asked precision
            count(total - made)
    return AssemblyVerdict(
        scenario=scenario,
        intensity=floors.median_intensity,
        slide_limit=slide_limit,
        options=_verdicts_of_several(options, scenes, runs, slide_limit),
        motions=len(ground),
        samples=samples,
        runs=made,
        precise=precise,
        seed=settings.seed,
        seconds=time.perf_counter() - began,
        rejected=rejected,
        floor=floors.floor,
    )


def _verdicts_of_several(
    options: tuple[AssemblyOption, ...],
    scenes: list[Scene],
    runs: list[RunsOfSeveral],
    slide_limit: float,
) -> tuple[AssemblyOptionVerdict, ...]:
    return tuple(
        AssemblyOptionVerdict(
            option=options[i],
            **outcomes,
            pieces=tuple(
                PieceVerdict(
                    name,
                    outcomes.probabilities(slide_limit),
                    Quantiles.of(outcomes.slide, outcomes.overturned),
                    Quantiles.of(outcomes.tilt, outcomes.overturned),
                )
                for name, outcomes in zip(scenes[i].names, runs[i].of_bodies(), strict=True)
            ),
            devices=_devices(scenes[i], runs[i]),
        )
        for i, outcomes in ranked_outcomes(runs, [option.count for option in options], slide_limit)
    )


def _devices(scene: Scene, runs: RunsOfSeveral) -> tuple[DeviceOfSeveral, ...]:
    """Return a summary of each device and joint, in the order of the runs'."""
    names, devices = scene.names, list[DeviceOfSeveral]()
    for name, body in zip(names, placed(scene), strict=True):
        for element in () if body.held is None else body.held.elements:
            summary = device_summary(element.kind, element, len(devices), runs)
            devices.append(DeviceOfSeveral((name,), summary))
    for joint in scene.joints:
        pieces = names[joint.first], names[joint.second]
        devices.append(DeviceOfSeveral(pieces, device_summary(JOINT, None, len(devices), runs)))
    return tuple(devices)
