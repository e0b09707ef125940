"""Monte Carlo comparison of what may hold the furniture: nothing, measures, joints."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stayput.errors import InputError, not_allowed, numbers, within
from stayput.fragility.curve import FragilityCurve
from stayput.fragility.intensity_measures import FLOOR_JMA, JMA_INTENSITY, IntensityMeasure
from stayput.fragility.trials import Trials
from stayput.measures.element import weakest
from stayput.mechanics.devices.columns import HOLDS
from stayput.montecarlo.counting import OFFSETS, Members, Outcomes, Quantiles, worst_of
from stayput.montecarlo.sampling import Settings
from stayput.montecarlo.scaled_motions import FloorMotions, ScaledMotions
from stayput.motion.intensity import INTENSITY_RANGE
from stayput.progress import tally
from stayput.simulation.groups import at_rest
from stayput.simulation.placing import JOINT
from stayput.verification.contents import ContentsVerdict, contents_verdicts
from stayput.verification.demand import with_demand
from stayput.verification.events import zones_of
from stayput.verification.meetings import with_meetings
from stayput.verification.notes import Estimates
from stayput.verification.option_runner import OptionRunner, has_library
from stayput.verification.options import compared_options
from stayput.verification.people import hardest, harm_of, people_of, typical_of
from stayput.verification.race import FIRST_LOOK, Race, paired
from stayput.verification.ranking import in_order, ranks_of
from stayput.verification.search import tried_options
from stayput.verification.verdict import AsInstalled, DeviceSummary, OptionVerdict, PieceVerdict, Verdict

if TYPE_CHECKING:
    from stayput.catalogue import Phrase
    from stayput.fragility.paired import Difference
    from stayput.measures import Element
    from stayput.montecarlo.runs import Runs
    from stayput.motion.suites.suite import Suite
    from stayput.scenario import Scenario
    from stayput.scenario.measures import Option

CAPACITIES = (0.1, 0.5)
"""Shares of overturning for which the intensity is given."""


def compare(
    scenario: Scenario,
    *,
    changes: bool = True,
    levels: ArrayLike | None,
    further: Sequence[IntensityMeasure] = (),
    slide_limit: float,
    threads: int | None,
    progress: bool | None,
    on_progress: Callable[[int, int], None] | None,
    on_verdict: Callable[[Verdict], None] | None,
) -> Verdict:
    """Compare the options of a scenario; see `stayput.verify`."""
    began, limit = time.perf_counter(), slide_limit
    asked = _levels(levels)
    options, impossible = compared_options(scenario)
    search = changes and scenario.plan is not None and not scenario.options
    drawn = levels is None and (scenario.alone or bool(further))
    faulty = _badly_installed(options, scenario)
    synthetic = scenario.shaking.synthetic_suite
    recorded = scenario.ground() if synthetic is None else None
    settings = Settings.of(scenario, len(recorded or ()) if synthetic is None else synthetic.count, limit)
    most = settings.runs * (len(options) * (1 + len(asked)) + len(faulty))
    with tally(most, "progress.verifying", progress, on_progress) as count:

        def runner_under(ground: Suite | None) -> OptionRunner:
            motions = ScaledMotions.of(scenario, tuple(further), ground)
            return OptionRunner(
                scenario,
                limit,
                threads,
                scaled_motions=motions,
                beside=drawn,
                levels=asked.tolist(),
                advance=count,
            )

        early = on_verdict is not None and not settings.all_runs and not has_library(scenario)
        few = _first_motions(scenario) if early else None
        runner = runner_under(few or recorded)
        race = Race(runner, options)
        known: KnownVerdicts = {}

        def so_far(**more: Any) -> Verdict:
            return Verdict(
                scenario=scenario,
                intensity=runner.floors.median_intensity,
                slide_limit=limit,
                options=verdicts_of(runner, race.options, race.runs, known, **more),
                motions=settings.motions,
                runs=count.done,
                seed=settings.seed,
                seconds=time.perf_counter() - began,
                levels=asked,
                precise=race.precise or settings.precision is None,
                impossible=impossible,
                complete=False,
                floor=runner.floors.floor,
            )

        def run() -> None:
            nonlocal runner
            for _ in race.looks():
                if on_verdict is not None:
                    on_verdict(so_far())
                if runner.settings.motions < settings.motions:
                    first, runner = runner, runner_under(None)
                    runner.go_on_from(first)
                    race.runner = runner

        run()
        if search:
            race.add([*tried_options(runner, options[0], race.runs[0].stated)])
            run()
        more: dict[str, Any] = {"drawn": drawn or len(asked) > 0}
        if faulty:
            well = {option.name: runs for option, runs in zip(options, race.runs, strict=False)}
            more["installed"] = {
                option.name: _as_installed(how, share, runner, option, well[option.name])
                for option, how, share in faulty
            }
        counts = [len(runs.members) for runs in race.runs]
        more["inside"] = contents_verdicts(runner, options, counts)
        if len(asked):
            more["at_levels"] = [
                runner.run(
                    race.options, Members.of_samples(settings.motions, settings.samples, level=1 + level)
                )
                for level in range(len(asked))
            ]
        verdict = so_far(**more)
        alone, body = scenario.alone, scenario.piece.body() if scenario.alone else None
        looked_at = () if alone else (verdict.without, verdict.helping)
        best, *others = (
            with_meetings(runner, option) if any(option is each for each in looked_at) else option
            for option in verdict.options
        )
        verdict = replace(
            verdict,
            # the first answer does not wait for response spectra of all motions: they take as long as runs
            estimates=None if body is None else Estimates.of(body, runner.floors, scenario, threads),
            options=(with_demand(runner, best), *others),
            runs=count.done,
            kinds=(0,) if alone else runner.scene_runner.library.draws.kinds,
        )
    return replace(verdict, complete=True)


def _first_motions(scenario: Scenario) -> Suite | None:
    """Return the motions of the first look, where its answer does not wait for the others; else None.

    The intensity that is told is the median of all motions, and known before where each has the stated one.
    """
    strength = scenario.shaking.strength
    alike = strength is not None and strength.measure == "JMA" and strength.scatter == 0.0
    synthetic = scenario.shaking.synthetic_suite
    if not alike or synthetic is None or synthetic.count <= FIRST_LOOK or scenario.dimensions == 2:
        return None
    return scenario.ground(FIRST_LOOK)


def _levels(levels: ArrayLike | None) -> NDArray[np.float64]:
    """Return the levels that are asked for: JMA intensities of the ground at which all options run."""
    if levels is None:
        return np.empty(0)
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
    how: tuple[Phrase, ...], share: float, runner: OptionRunner, bad: Option, well: Runs
) -> AsInstalled:
    (badly,) = runner.run([bad], well.members)
    ends = [runs.probabilities(runner.settings.slide_limit) for runs in (well, badly)]
    usual = {
        event: (1.0 - share) * chance.estimate + share * ends[1][event].estimate
        for event, chance in ends[0].items()
    }
    return AsInstalled(share, how, ends[1], usual)


def _curves(name: str, floors: FloorMotions, runs: Sequence[Runs]) -> dict[IntensityMeasure, FragilityCurve]:
    """Return the curves of an option from all its runs."""
    made = Outcomes.joined([each.outcomes for each in runs])
    place, of_floors = floors.place(made.members), floors.floor != ""
    return {
        im: FragilityCurve(
            name,
            Trials.of_runs(
                FLOOR_JMA if im == JMA_INTENSITY and of_floors else im,
                floors.values(im, place),
                made.overturned,
                made.missing,
                made.members.motion,
                len(OFFSETS) if len(runs) == 1 else len(runs),
            ),
        )
        for im in floors.measures
    }


KnownVerdicts: TypeAlias = "dict[tuple[int, ...], tuple[Sequence[Runs], OptionVerdict]]"
"""Verdicts on options with the runs that they are of, by the number of options and the ids of these runs."""


def verdicts_of(
    runner: OptionRunner,
    options: Sequence[Option],
    outcomes: Sequence[Runs],
    known: KnownVerdicts,
    *,
    drawn: bool = False,
    at_levels: Sequence[Sequence[Runs]] = (),
    installed: Mapping[str, AsInstalled] = MappingProxyType({}),
    inside: Sequence[ContentsVerdict | None] = (),
) -> tuple[OptionVerdict, ...]:
    """Return the verdicts on options, that without anything first in its arguments, the best first.

    How they rank is in `stayput.verification.ranking`. Verdicts on options without new runs are used again.
    """
    verdicts: list[OptionVerdict] = []
    for i, (option, runs) in enumerate(zip(options, outcomes, strict=True)):
        further = [level[i] for level in at_levels]
        curves = _curves(option.name, runner.all_floors, [runs, *further]) if drawn else {}
        bare = outcomes[0] if i else None
        # where no curve is fitted, further runs of what is without change no difference from it
        used = (runs,) if bare is None or not runner.members.level.any() else (runs, bare)
        key = (len(options), *map(id, used))
        if key not in known:  # the runs are kept with it, so that the ids stay their own
            known[key] = used, option_verdict(runner, option, runs, bare, len(options) - 1)
        verdict = known[key][1]
        capacities = {p: curves[JMA_INTENSITY].capacity(p) for p in CAPACITIES} if curves else {}
        verdicts.append(
            replace(
                verdict,
                curves=curves,
                capacities=capacities,
                installed=installed.get(option.name),
                contents=inside[i] if i < len(inside) else None,
            )
        )

    order = in_order(verdicts)
    if runner.scenario.plan is None:  # both are shown under the same draw
        both = (runs.stated for runs in paired(outcomes[0], outcomes[order[0]]))
        verdicts[0] = replace(verdicts[0], typical=typical_of(*both))
    ordered, limit = [verdicts[i] for i in order], runner.settings.slide_limit
    ranks = ranks_of(ordered, [outcomes[i] for i in order], limit)
    return tuple(replace(verdict, rank=rank) for verdict, rank in zip(ordered, ranks, strict=True))


def option_verdict(
    runner: OptionRunner, option: Option, runs: Runs, bare: Runs | None, comparisons: int = 1
) -> OptionVerdict:
    """Return the verdict on an option, which has no rank yet.

    Parameters
    ----------
    runner : OptionRunner
        Under whose motions and draws it ran.
    option : Option
        What is in place.
    runs, bare : Runs
        Its runs, and those without anything; None of what is without.
    comparisons : int
        How many options are compared with what is without.
    """
    limit, scenario = runner.settings.slide_limit, runner.scenario
    held, failed = runner.held_by(option), runs.devices["failure"] != HOLDS
    each = [
        replace(outcomes, device_failed=failed[:, [name in pieces for pieces, _ in held]].any(axis=1))
        for name, outcomes in zip(scenario.names, runs.of_bodies(), strict=True)
    ]
    copies, stated = runner.copies(option), runs.stated
    of_kinds = [_of_kind(each, copies[n]) for n in range(len(each))]
    changes: list[Difference | None] = [None] * len(each)
    if bare is not None:
        both, of_bare = min(len(runs.members), len(bare.members)), [*bare.of_bodies()]
        pairs = ([_of_kind(of, numbers, both) for of in (each, of_bare)] for numbers in copies)
        changes = [now.difference(now.overturned, then, then.overturned, comparisons) for now, then in pairs]
    people, zones, harm = None, [None] * len(each), [0.0] * len(each)
    if scenario.plan is not None:
        plan, pieces = runner.plan(option), runner.scene(option).pieces
        masses = [(name, piece.body.mass) for name, piece in zip(scenario.names, pieces, strict=True)]
        ends = runner.detector.ends(plan, [at_rest(piece) for piece in pieces])
        people = people_of(stated, None if bare is None else bare.stated, plan, masses, ends)
        harm = [harm_of(hardest(stated, [n]), plan.places, stated.missing) for n in range(len(each))]
        zones = zones_of(stated, pieces, runner.detector, plan)

    def change(*, moved: bool = False) -> Difference | None:
        if bare is None:
            return None
        now, then = (each.moved(limit) if moved else each.overturned for each in (runs, bare))
        return runs.difference(now, bare, then, comparisons)

    return OptionVerdict(
        option=option,
        rank=0,
        runs=len(runs.members),
        probabilities=runs.probabilities(limit, has_devices=len(held) > 0),
        change=change(),
        slid=change(moved=True),
        slide=Quantiles.of(stated.slide, stated.overturned),
        tilt=Quantiles.of(stated.tilt, stated.overturned),
        typical=typical_of(stated),
        worst=worst_of(stated),
        pieces=tuple(
            PieceVerdict(
                name,
                outcomes.probabilities(limit, has_devices=any(name in pieces for pieces, _ in held)),
                Quantiles.of(outcomes.stated.slide, outcomes.stated.overturned),
                Quantiles.of(outcomes.stated.tilt, outcomes.stated.overturned),
                outcomes.stability(limit),
                changes[n],
                harm[n],
                zones[n],
            )
            for n, (name, outcomes) in enumerate(zip(scenario.names, of_kinds, strict=True))
        ),
        devices=tuple(
            device_summary(pieces, element, number, runs) for number, (pieces, element) in enumerate(held)
        ),
        curves={},
        capacities={},
        people=people,
    )


def _of_kind(outcomes: Sequence[Outcomes], copies: Sequence[int], count: int | None = None) -> Outcomes:
    """Return the first so many outcomes of each of some copies of a piece: they are of one kind."""
    return Outcomes.joined([outcomes[number].chosen(slice(count)) for number in copies])


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
    chance = runs.probability(runs.devices["failure"][:, number] != HOLDS)
    runs = runs.stated
    device, missing = runs.devices[:, number], runs.missing
    nowhere = np.zeros_like(missing)
    along = np.maximum(device["peak_pull"], device["peak_push"])
    failed = device["failure"] != HOLDS
    times = device["failure_time"][failed & ~missing]
    kind = JOINT if element is None else element.kind
    return DeviceSummary(
        kind=kind,
        name=kind if element is None else f"{kind} {element.place}".strip(),
        failed=chance,
        failure_time=float(np.median(times)) if times.size else np.nan,
        peak=Quantiles.of(runs.masses * np.hypot(along, device["peak_shear"]), nowhere),
        used=Quantiles.of(runs.used[:, number], nowhere),
        weakest=None if element is None else weakest(element, device[~missing]),
        pieces=pieces,
    )
