"""Monte Carlo comparison of what may hold the furniture: nothing, measures, joints."""

from __future__ import annotations

import time
from dataclasses import replace
from functools import cache, partial
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.catalogue import phrase
from stayput.errors import InputError, not_allowed, numbers
from stayput.fragility.curve import fragility_curve
from stayput.fragility.intensity_measures import FLOOR_JMA, JMA_INTENSITY
from stayput.fragility.paired import difference
from stayput.fragility.probabilities import probability
from stayput.fragility.trials import Trials
from stayput.measures import Element, hold
from stayput.measures.element import weakest
from stayput.mechanics.devices.columns import HOLDS
from stayput.montecarlo.counting import Quantiles, members, severity
from stayput.montecarlo.hazard import FloorMotions, Hazard
from stayput.montecarlo.runs import Falls, Runs, run_level, run_levels
from stayput.montecarlo.sampling import Rows, Settings, draws, rows_of, sample_until_precise
from stayput.montecarlo.several import draws_of_several, run_several
from stayput.progress import tally
from stayput.simulation.placing import JOINT, placed
from stayput.simulation.space import warn_of_settlement
from stayput.verification.contents import ContentsVerdict, contents_verdicts
from stayput.verification.notes import Estimates
from stayput.verification.options import compared_options
from stayput.verification.verdict import (
    AsInstalled,
    DeviceSummary,
    OptionVerdict,
    PieceVerdict,
    Verdict,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from numpy.typing import ArrayLike, NDArray

    from stayput.catalogue import Phrase
    from stayput.fragility.curve import FragilityCurve
    from stayput.fragility.intensity_measures import IntensityMeasure
    from stayput.scenario import Scenario
    from stayput.scenario.option import Option
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


class Contest:
    """The options of a verification, ready to meet motions and draws.

    Parameters
    ----------
    scenario : Scenario
        What stands where.
    options : tuple of Option
        What is in place, that with nothing first.
    settings : Settings
        Of the draws.
    threads : int, optional
        As many as there are cores by default. The bits do not depend on them.
    """

    def __init__(
        self, scenario: Scenario, options: tuple[Option, ...], settings: Settings, threads: int | None
    ) -> None:
        self.scenario, self.options, self._settings, self._threads = scenario, options, settings, threads
        self._drawn: dict[str, Any] = {"as_stated": settings.as_stated, "quantities": settings.quantities}
        self._scenes: list[Scene] = []
        self._last: tuple[object, list[Rows]] = None, []
        self.devices: list[list[tuple[tuple[str, ...], Element | None]]] = []
        """What holds the pieces of each option: the pieces, and the device; None of a joint."""
        if scenario.alone:
            body, room = scenario.piece.body(), scenario.room.room()
            for option in options:
                held = hold(body, room, option.measures, dimensions=scenario.dimensions)
                self.devices.append([(scenario.names, element) for element in held.elements])
            return
        self._scenes = [scenario.scene(option) for option in options]
        warn_of_settlement(self._scenes[0])
        for scene in self._scenes:
            on_pieces = zip(scene.names, placed(scene), strict=True)
            each = [
                ((name,), element) for name, body in on_pieces if body.held for element in body.held.elements
            ]
            joints = [((scene.names[joint.first], scene.names[joint.second]), None) for joint in scene.joints]
            self.devices.append([*each, *joints])

    def rows(self, options: tuple[Option, ...], samples: int, start: int = 0) -> list[Rows]:
        """Return the rows of options of a lone piece, for some samples of each motion."""
        asked = options, samples, start
        if asked == self._last[0]:
            return self._last[1]
        scenario, settings = self.scenario, self._settings
        body, room = scenario.piece.body(), scenario.room.room()
        drawn = draws(settings.motions, samples, settings.seed, start, **self._drawn)
        stands = settings.gravity, scenario.initial.state(), scenario.dimensions
        rows = [rows_of(body, room, option.measures, drawn, *stands) for option in options]
        self._last = asked, rows
        return rows

    def run(
        self, floors: FloorMotions, samples: int, start: int, progress: Callable[[int], None]
    ) -> list[Runs]:
        """Run all options at one level, for some samples of each motion."""
        if not self._scenes:
            rows = self.rows(self.options, samples, start)
            return run_level(rows, floors, threads=self._threads, progress=progress)
        scenario, settings = self.scenario, self._settings
        direction = scenario.direction or 0.0
        place = settings.motions, samples, settings.seed, start
        drawn = draws_of_several(scenario.names, *place, direction=direction, **self._drawn)
        shaken = floors, settings.gravity, scenario.counted
        with scenario.naming_keys():
            return run_several(self._scenes, drawn, *shaken, threads=self._threads, progress=progress)


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
    """Compare the options of a scenario; see `stayput.verify`."""
    began, limit = time.perf_counter(), slide_limit
    rows = _levels(scenario, levels)
    options, impossible = compared_options(scenario)
    hazard = Hazard.of(scenario, tuple(further))
    ground = hazard.ground
    settings = Settings.of(scenario, len(ground), limit)
    faulty = _badly_installed(options, scenario)
    contest = Contest(scenario, options, settings, threads)
    total = len(ground) * settings.samples * (len(options) * (1 + len(rows)) + len(faulty))
    with tally(total, "progress.verifying", progress, on_progress) as count:
        floors = hazard.stated_by(scenario, threads)

        def run(_: list[int], samples: int, start: int) -> list[Runs]:
            return contest.run(floors, samples, start, count)

        body = scenario.piece.body() if scenario.alone else None
        estimates = None if body is None else Estimates.of(body, floors, scenario, threads)

        def ranked(outcomes: list[Runs], samples: int) -> Verdict:
            return Verdict(
                scenario=scenario,
                intensity=floors.median_intensity,
                slide_limit=limit,
                options=_verdicts(contest, outcomes, limit),
                estimates=estimates,
                motions=len(ground),
                samples=samples,
                runs=len(options) * len(ground) * samples,
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
            bad = contest.rows(tuple(option for option, *_ in faulty), samples)
            bad_runs = run_level(bad, floors, threads=threads, progress=count)
            well = {option.name: runs for option, runs in zip(options, here, strict=True)}
            for (option, how, share), runs in zip(faulty, bad_runs, strict=True):
                installed[option.name] = _as_installed(how, share, well[option.name], runs, limit)
        inside = contents_verdicts(options, scenario, floors, settings.seed, threads)
        floors_at = cache(partial(hazard.at, threads=threads))
        falls: list[Falls] = []
        made = 0
        if len(rows):
            drawn = contest.rows(options, samples)
            falls, made = run_levels(
                drawn, rows, floors_at, every_run=every_run, threads=threads, progress=count
            )
        measures = [floors_at(float(level)) for level in rows]
    return replace(
        ranked(here, samples),
        options=_verdicts(contest, here, limit, falls, measures, installed, inside),
        levels=rows,
        runs=at_a_level + badly + made,
        settled=at_a_level * len(rows) - made,
        precise=precise,
        complete=True,
    )


def _levels(scenario: Scenario, levels: ArrayLike | None) -> NDArray[np.float64]:
    """Return the levels of the fragility curves: those asked for, or the usual ones."""
    if levels is None:
        return curve_levels(scenario.dimensions) if scenario.alone else np.empty(0)
    rows = numbers("fragility.level", levels, "levels")
    if rows.ndim != 1:
        raise not_allowed("fragility.level", repr(levels), "common.list", "levels")
    if np.any(np.diff(rows) <= 0.0):
        raise InputError("verification.levels_not_increasing", "levels")
    if len(rows) and not scenario.alone:
        raise InputError("common.left_out", "levels", where=phrase("several.for_levels"))
    return rows


def _badly_installed(
    options: tuple[Option, ...], scenario: Scenario
) -> list[tuple[Option, tuple[Phrase, ...], float]]:
    """Return the options badly installed of which the scenario asks a share, what is wrong, and the share."""
    faulty: list[tuple[Option, tuple[Phrase, ...], float]] = []
    for option in options if scenario.alone else ():
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
    contest: Contest,
    stated: list[Runs],
    slide_limit: float,
    falls: Sequence[Falls] = (),
    measures: Sequence[FloorMotions] = (),
    installed: Mapping[str, AsInstalled] = MappingProxyType({}),
    inside: Sequence[ContentsVerdict | None] = (),
) -> tuple[OptionVerdict, ...]:
    """Return the verdicts on all options, the best first."""
    options, bare, names = contest.options, stated[0], contest.scenario.names
    chances = [runs.probabilities(slide_limit) for runs in stated]
    order = sorted(range(len(stated)), key=lambda i: (*severity(chances[i], options[i].count), i))
    verdicts: list[OptionVerdict] = []
    for rank, i in enumerate(order, start=1):
        option, runs = options[i], stated[i]
        missing, comparisons = runs.missing | bare.missing, len(stated) - 1
        typical, worst = members(runs)
        curves = _curves(option.name, falls[i], measures) if measures else {}
        verdicts.append(
            OptionVerdict(
                option=option,
                rank=rank,
                probabilities=chances[i],
                change=difference(runs.overturned, bare.overturned, missing, comparisons=comparisons)
                if i
                else None,
                slide=Quantiles.of(runs.slide, runs.overturned),
                tilt=Quantiles.of(runs.tilt, runs.overturned),
                typical=typical,
                worst=worst,
                pieces=tuple(
                    PieceVerdict(
                        name,
                        outcomes.probabilities(slide_limit),
                        Quantiles.of(outcomes.slide, outcomes.overturned),
                        Quantiles.of(outcomes.tilt, outcomes.overturned),
                        outcomes.stability(slide_limit),
                    )
                    for name, outcomes in zip(names, runs.of_bodies(), strict=True)
                ),
                devices=tuple(
                    device_summary(pieces, element, number, runs)
                    for number, (pieces, element) in enumerate(contest.devices[i])
                ),
                curves=curves,
                capacities={p: curves[JMA_INTENSITY].capacity(p) for p in CAPACITIES} if curves else {},
                installed=installed.get(option.name),
                contents=inside[i] if inside else None,
            )
        )
    return tuple(verdicts)


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
