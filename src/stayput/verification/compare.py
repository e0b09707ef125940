"""Monte Carlo comparison of what may hold the furniture: nothing, measures, joints."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache, partial
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.errors import InputError, not_allowed, numbers, within
from stayput.fragility.curve import FragilityCurve, fragility_curve
from stayput.fragility.intensity_measures import FLOOR_JMA, JMA_INTENSITY, IntensityMeasure
from stayput.fragility.paired import Difference, difference
from stayput.fragility.probabilities import probability
from stayput.fragility.trials import Trials
from stayput.measures.element import weakest
from stayput.mechanics.devices.columns import HOLDS
from stayput.montecarlo.counting import Outcomes, Quantiles, worst_of
from stayput.montecarlo.sampling import FIRST_SAMPLES, Settings, sample_until_precise
from stayput.montecarlo.scaled_motions import FloorMotions, ScaledMotions
from stayput.motion.intensity import INTENSITY_RANGE
from stayput.progress import tally
from stayput.simulation.groups import at_rest
from stayput.simulation.placing import JOINT
from stayput.verification.contents import ContentsVerdict, contents_verdicts
from stayput.verification.contest import Contest
from stayput.verification.events import zones_of
from stayput.verification.notes import Estimates
from stayput.verification.options import compared_options
from stayput.verification.people import hardest, harm_of, people_of, typical_of
from stayput.verification.ranking import in_order, ranks_of
from stayput.verification.search import tried_options
from stayput.verification.verdict import AsInstalled, DeviceSummary, OptionVerdict, PieceVerdict, Verdict

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.measures import Element
    from stayput.montecarlo.runs import Falls, Runs
    from stayput.scenario import Scenario
    from stayput.scenario.measures import Option

LEVELS: NDArray[np.float64] = np.linspace(4.25, 7.0, 12)
"""JMA intensities of the ground for the fragility curves: ends and middles of the classes from 4 to 7."""
LEVELS.setflags(write=False)

FIRST_RUNS = 20
"""Runs of a scene with each option after which there is a first answer, at least."""

CAPACITIES = (0.1, 0.5)
"""Shares of overturning for which the intensity is given."""


def compare(
    scenario: Scenario,
    *,
    changes: bool = True,
    levels: ArrayLike | None,
    further: Sequence[IntensityMeasure] = (),
    slide_limit: float,
    every_run: bool,
    threads: int | None,
    progress: bool | None,
    on_progress: Callable[[int, int], None] | None,
    on_verdict: Callable[[Verdict], None] | None,
) -> Verdict:
    """Compare the options of a scenario; see `stayput.verify`."""
    began, limit = time.perf_counter(), slide_limit
    rows = _levels(scenario, levels, further)
    options, impossible = compared_options(scenario)
    search = changes and scenario.plan is not None and not scenario.options
    scaled_motions = ScaledMotions.of(scenario, tuple(further))
    faulty = _badly_installed(options, scenario)
    runs_each = len(scaled_motions.ground) * Settings.of(scenario, len(scaled_motions.ground), limit).samples
    total = runs_each * (len(options) * (1 + len(rows)) + len(faulty))
    with tally(total, "progress.verifying", progress, on_progress) as count:
        contest = Contest(scenario, limit, threads, scaled_motions=scaled_motions, advance=count)
        floors, settings = contest.floors, contest.settings
        estimates = Estimates.of(scenario.piece.body(), floors, scenario, threads) if scenario.alone else None

        def so_far(outcomes: Sequence[Runs], samples: int) -> Verdict:
            verdict = Verdict(
                scenario=scenario,
                intensity=floors.median_intensity,
                slide_limit=limit,
                options=verdicts_of(contest, options, outcomes),
                estimates=estimates,
                motions=settings.motions,
                samples=samples,
                runs=len(options) * settings.motions * samples,
                seed=settings.seed,
                seconds=time.perf_counter() - began,
                impossible=impossible,
                complete=False,
                floor=floors.floor,
            )
            if on_verdict is not None:
                on_verdict(verdict)
            return verdict

        def run(_: list[int], samples: int, start: int) -> list[Runs]:
            return contest.run(options, samples, start, keep=scenario.plan is not None)

        first = FIRST_SAMPLES if contest.in_plane else -(-FIRST_RUNS // settings.motions)
        # All options go on together, since they are compared sample by sample.
        here, samples, precise = sample_until_precise(
            len(options),
            settings,
            run,
            together=True,
            first=first,
            on_batch=None if on_verdict is None else so_far,
        )
        verdict = so_far(here, samples)
        if search:
            tried = [*tried_options(contest, options[0], here[0])]
            count.total += len(tried) * settings.motions * samples
            for option in tried:
                options = (*options, option)
                here += contest.run([option], samples)
                verdict = so_far(here, samples)
        at_a_level, badly = (number * settings.motions * samples for number in (len(options), len(faulty)))
        if unneeded := total - at_a_level * (1 + len(rows)) - badly:  # samples beyond the asked precision
            count(max(0, unneeded))
        more: dict[str, Any] = {}
        if faulty:
            bad_runs = contest.run([option for option, *_ in faulty], samples)
            well = {option.name: runs for option, runs in zip(options, here, strict=True)}
            more["installed"] = {
                option.name: _as_installed(how, share, well[option.name], runs, limit)
                for (option, how, share), runs in zip(faulty, bad_runs, strict=True)
            }
        more["inside"] = contents_verdicts(contest, options)
        made = 0
        if len(rows):
            floors_at = cache(partial(scaled_motions.at, threads=threads))
            more["falls"], made = contest.falls(options, here, rows, floors_at, every_run=every_run)
            more["measures"] = [floors_at(float(level)) for level in rows]
        if more["inside"] or faulty or len(rows):
            verdict = replace(verdict, options=verdicts_of(contest, options, here, **more))
    return replace(
        verdict,
        seconds=time.perf_counter() - began,
        levels=rows,
        runs=at_a_level + badly + made,
        settled=at_a_level * len(rows) - made,
        precise=precise,
        complete=True,
    )


def _levels(
    scenario: Scenario, levels: ArrayLike | None, further: Sequence[IntensityMeasure]
) -> NDArray[np.float64]:
    """Return the levels of the fragility curves: those asked for, or the usual ones.

    Of scenes, whose runs are longer, there are none unless a measure for their curves is asked for.
    """
    if levels is None:
        return LEVELS if scenario.alone or further else np.empty(0)
    rows = numbers("fragility.level", levels, "levels")
    if rows.ndim != 1:
        raise not_allowed("fragility.level", repr(levels), "common.list", "levels")
    for level in rows.tolist():
        within("fragility.level", level, *INTENSITY_RANGE, "", "levels")
    if np.any(np.diff(rows) <= 0.0):
        raise InputError("verification.levels_not_increasing", "levels")
    return rows


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


def verdicts_of(
    contest: Contest,
    options: Sequence[Option],
    outcomes: Sequence[Runs],
    *,
    falls: Sequence[Falls] = (),
    measures: Sequence[FloorMotions] = (),
    installed: Mapping[str, AsInstalled] = MappingProxyType({}),
    inside: Sequence[ContentsVerdict | None] = (),
) -> tuple[OptionVerdict, ...]:
    """Return the verdicts on options, that without anything first in its arguments, the best first.

    How they rank is in `stayput.verification.ranking`.
    """
    verdicts: list[OptionVerdict] = []
    for i, (option, runs) in enumerate(zip(options, outcomes, strict=True)):
        curves = _curves(option.name, falls[i], measures) if measures else {}
        verdict = option_verdict(contest, option, runs, outcomes[0] if i else None, len(options) - 1)
        capacities = {p: curves[JMA_INTENSITY].capacity(p) for p in CAPACITIES} if curves else {}
        further = {"installed": installed.get(option.name), "contents": inside[i] if inside else None}
        verdicts.append(replace(verdict, curves=curves, capacities=capacities, **further))

    order = in_order(verdicts)
    best = outcomes[order[0]]
    if contest.scenario.plan is None:  # both are shown under the same draw
        verdicts[0] = replace(verdicts[0], typical=typical_of(outcomes[0], best))
    ordered, limit = [verdicts[i] for i in order], contest.settings.slide_limit
    ranks = ranks_of(ordered, [outcomes[i] for i in order], limit)
    return tuple(replace(verdict, rank=rank) for verdict, rank in zip(ordered, ranks, strict=True))


def option_verdict(
    contest: Contest, option: Option, runs: Runs, bare: Runs | None, comparisons: int = 1
) -> OptionVerdict:
    """Return the verdict on an option, which has no rank yet.

    Parameters
    ----------
    contest : Contest
        Under whose motions and draws it ran.
    option : Option
        What is in place.
    runs, bare : Runs
        Its runs, and those without anything; None of what is without.
    comparisons : int
        How many options are compared with what is without.
    """
    limit, scenario = contest.settings.slide_limit, contest.scenario
    held, failed = contest.held_by(option), runs.devices["failure"] != HOLDS
    each = [
        replace(outcomes, device_failed=failed[..., [name in pieces for pieces, _ in held]].any(axis=-1))
        for name, outcomes in zip(scenario.names, runs.of_bodies(), strict=True)
    ]
    of_bare = [None] * len(each) if bare is None else [*bare.of_bodies()]
    people, zones, harm = None, [None] * len(each), [0.0] * len(each)
    if scenario.plan is not None:
        plan, pieces = contest.plan(option), contest.scene(option).pieces
        masses = [(name, piece.body.mass) for name, piece in zip(scenario.names, pieces, strict=True)]
        ends = contest.watcher.ends(plan, [at_rest(piece) for piece in pieces])
        people = people_of(runs, bare, plan, masses, ends)
        harm = [harm_of(hardest(runs, [n]), plan.places, runs.missing) for n in range(len(each))]
        zones = zones_of(runs, pieces, contest.watcher, plan)

    def change(of: Outcomes, without: Outcomes | None, *, moved: bool = False) -> Difference | None:
        if without is None:
            return None
        now, then = (each.moved(limit) if moved else each.overturned for each in (of, without))
        return difference(now, then, of.missing | without.missing, comparisons=comparisons)

    return OptionVerdict(
        option=option,
        rank=0,
        probabilities=runs.probabilities(limit),
        change=change(runs, bare),
        slid=change(runs, bare, moved=True),
        slide=Quantiles.of(runs.slide, runs.overturned),
        tilt=Quantiles.of(runs.tilt, runs.overturned),
        typical=typical_of(runs),
        worst=worst_of(runs),
        pieces=tuple(
            PieceVerdict(
                name,
                outcomes.probabilities(limit),
                Quantiles.of(outcomes.slide, outcomes.overturned),
                Quantiles.of(outcomes.tilt, outcomes.overturned),
                outcomes.stability(limit),
                change(outcomes, without),
                harm[n],
                zones[n],
            )
            for n, (name, outcomes, without) in enumerate(zip(scenario.names, each, of_bare, strict=True))
        ),
        devices=tuple(
            device_summary(pieces, element, number, runs) for number, (pieces, element) in enumerate(held)
        ),
        curves={},
        capacities={},
        people=people,
    )


def device_summary(
    pieces: tuple[str, ...], element: Element | None, number: int, runs: Runs
) -> DeviceSummary:
    """Return a summary of the device of a number, or of a joint, which is no element of a measure.

    Parameters
    ----------
    pieces : tuple of str
        What it holds.
    element : Element or None
        The device.
    number : int
        Its place among all devices of the runs.
    runs : Runs
        The runs.
    """
    device, missing = runs.devices[:, :, number], runs.missing
    nowhere = np.zeros_like(missing)
    along = np.maximum(device["peak_pull"], device["peak_push"])
    failed = device["failure"] != HOLDS
    times = device["failure_time"][failed & ~missing]
    kind = JOINT if element is None else element.kind
    return DeviceSummary(
        kind=kind,
        name=kind if element is None else f"{kind} {element.place}".strip(),
        failed=probability(failed, missing),
        failure_time=float(np.median(times)) if times.size else np.nan,
        peak=Quantiles.of(runs.masses * np.hypot(along, device["peak_shear"]), nowhere),
        used=Quantiles.of(runs.used[:, :, number], nowhere),
        weakest=None if element is None else weakest(element, device[~missing]),
        pieces=pieces,
    )
