"""`verify` of several pieces: Monte Carlo comparison of their joints and of measures on them."""

from __future__ import annotations

import time
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from stayput.fragility import difference, probability
from stayput.measures.results import weakest
from stayput.mechanics.devices.columns import HOLDS
from stayput.montecarlo.counting import Quantiles
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.sampling import Settings, sample_until_precise
from stayput.montecarlo.several import draws_of_several, run_several
from stayput.progress import bar
from stayput.simulation.placing import JOINT, placed
from stayput.simulation.space import warn_of_settlement
from stayput.verification.ranking import members, severity
from stayput.verification.several_options import options_of_several
from stayput.verification.several_verdict import (
    AssemblyOptionVerdict,
    AssemblyVerdict,
    DeviceOfSeveral,
    PieceVerdict,
)
from stayput.verification.verdict import DeviceSummary

if TYPE_CHECKING:
    from collections.abc import Callable

    from stayput.measures.element import Element
    from stayput.montecarlo.several import RunsOfSeveral
    from stayput.scenario import AssemblyScenario
    from stayput.scenario.assembly_options import AssemblyOption
    from stayput.simulation.standing import Assembly


def verify_several(
    scenario: AssemblyScenario,
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
    room, gravity, shaking = scenario.surroundings(), scenario.gravity, scenario.shaking
    options, rejected = options_of_several(scenario)
    ground = scenario.ground()
    hazard = Hazard(ground, shaking.building, shaking.storey or 1, bool(shaking.vertical), 3)
    settings = Settings.of(scenario, len(ground), slide_limit)
    assemblies = [scenario.assembly(option) for option in options]
    warn_of_settlement(assemblies[0], room)
    total = len(ground) * settings.samples * len(options)
    draw = partial(
        draws_of_several,
        scenario.names,
        settings.motions,
        seed=settings.seed,
        as_stated=settings.as_stated,
    )
    with bar(total, "progress.verifying", progress) as advance:
        done = 0

        def count(runs: int) -> None:
            nonlocal done
            done += runs
            advance(runs)
            if on_progress is not None:
                on_progress(done, total)

        floors = hazard.stated(shaking.strength, shaking.scale, settings.seed, threads)

        def run(_: list[int], samples: int, start: int) -> list[RunsOfSeveral]:
            drawn = draw(samples, start=start)
            counted = scenario.counted
            return run_several(
                assemblies, room, drawn, floors, gravity, counted, threads=threads, progress=count
            )

        with scenario.naming_pieces():
            runs, samples, precise = sample_until_precise(len(options), settings, run, together=True)
        made = len(options) * len(ground) * samples
        if made < total:  # samples beyond the asked precision
            count(total - made)
    return AssemblyVerdict(
        scenario=scenario,
        intensity=floors.median_intensity,
        slide_limit=slide_limit,
        options=_verdicts(scenario, options, assemblies, runs, slide_limit),
        motions=len(ground),
        samples=samples,
        runs=made,
        precise=precise,
        seed=settings.seed,
        seconds=time.perf_counter() - began,
        rejected=rejected,
        floor=floors.floor,
    )


def _verdicts(
    scenario: AssemblyScenario,
    options: tuple[AssemblyOption, ...],
    assemblies: list[Assembly],
    runs: list[RunsOfSeveral],
    slide_limit: float,
) -> tuple[AssemblyOptionVerdict, ...]:
    chances = [one.probabilities(slide_limit) for one in runs]
    order = sorted(range(len(options)), key=lambda i: (*severity(chances[i], options[i].count), i))
    bare_runs, verdicts = runs[0], list[AssemblyOptionVerdict]()
    for rank, i in enumerate(order, start=1):
        own, missing = runs[i], runs[i].missing | bare_runs.missing
        typical, worst = members(own)
        verdicts.append(
            AssemblyOptionVerdict(
                option=options[i],
                rank=rank,
                probabilities=chances[i],
                change=difference(own.overturned, bare_runs.overturned, missing, comparisons=len(options) - 1)
                if i
                else None,
                slide=Quantiles.of(own.slide, own.overturned),
                tilt=Quantiles.of(own.tilt, own.overturned),
                pieces=tuple(
                    _piece(name, own, body, slide_limit) for body, name in enumerate(scenario.names)
                ),
                devices=_devices(scenario, assemblies[i], own),
                typical=typical,
                worst=worst,
            )
        )
    return tuple(verdicts)


def _piece(name: str, runs: RunsOfSeveral, body: int, slide_limit: float) -> PieceVerdict:
    own = runs.of_body(body)
    return PieceVerdict(
        name,
        own.probabilities(slide_limit),
        Quantiles.of(own.slide, own.overturned),
        Quantiles.of(own.tilt, own.overturned),
    )


class _Device(NamedTuple):
    """A device of an assembly, or a joint: whose it is, and what is known of it."""

    pieces: tuple[str, ...]
    kind: str
    place: str
    element: Element | None


def _devices(
    scenario: AssemblyScenario, assembly: Assembly, runs: RunsOfSeveral
) -> tuple[DeviceOfSeveral, ...]:
    """Return a summary of each device and joint, in the order of the runs'."""
    room, names = scenario.surroundings(), scenario.names
    bodies = placed(assembly.members, room)
    devices = [
        _Device((name,), element.kind, element.place, element)
        for name, body in zip(names, bodies, strict=True)
        if body.held is not None
        for element in body.held.elements
    ]
    devices += [_Device((names[one.first], names[one.second]), JOINT, "", None) for one in assembly.joints]
    nowhere = np.zeros_like(runs.overturned)
    found: list[DeviceOfSeveral] = []
    for number, one in enumerate(devices):
        device = runs.devices[:, :, number]
        along = np.maximum(device["peak_pull"], device["peak_push"])
        failed = device["failure"] != HOLDS
        times = device["failure_time"][failed & ~runs.missing]
        summary = DeviceSummary(
            kind=one.kind,
            name=f"{one.kind} {one.place}".strip(),
            failed=probability(failed, runs.missing),
            failure_time=float(np.median(times)) if times.size else np.nan,
            peak=Quantiles.of(np.hypot(along, device["peak_shear"]), nowhere),
            used=Quantiles.of(runs.used[:, :, number], nowhere),
            weakest=None if one.element is None else weakest(one.element, device[~runs.missing]),
        )
        found.append(DeviceOfSeveral(one.pieces, summary))
    return tuple(found)
