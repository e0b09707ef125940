"""`verify` of several pieces: Monte Carlo comparison of their joints and of measures on them."""

from __future__ import annotations

import time
from functools import partial
from typing import TYPE_CHECKING

from stayput.montecarlo.counting import Quantiles
from stayput.montecarlo.hazard import Hazard
from stayput.montecarlo.sampling import Settings, sample_until_precise
from stayput.montecarlo.several import draws_of_several, run_several
from stayput.progress import tally
from stayput.simulation.placing import placed
from stayput.simulation.space import warn_of_settlement
from stayput.simulation.space_devices import JOINT
from stayput.verification.compare import device_summary, ranked_outcomes
from stayput.verification.options import options_of_several
from stayput.verification.verdict import (
    AssemblyOptionVerdict,
    AssemblyVerdict,
    DeviceOfSeveral,
    PieceVerdict,
)

if TYPE_CHECKING:
    from collections.abc import Callable

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
    with tally(total, "progress.verifying", progress, on_progress) as count:
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
    return tuple(
        AssemblyOptionVerdict(
            option=options[i],
            **outcomes,
            pieces=tuple(
                _piece(name, runs[i], body, slide_limit) for body, name in enumerate(scenario.names)
            ),
            devices=_devices(scenario, assemblies[i], runs[i]),
        )
        for i, outcomes in ranked_outcomes(runs, [option.count for option in options], slide_limit)
    )


def _piece(name: str, runs: RunsOfSeveral, body: int, slide_limit: float) -> PieceVerdict:
    own = runs.of_body(body)
    return PieceVerdict(
        name,
        own.probabilities(slide_limit),
        Quantiles.of(own.slide, own.overturned),
        Quantiles.of(own.tilt, own.overturned),
    )


def _devices(
    scenario: AssemblyScenario, assembly: Assembly, runs: RunsOfSeveral
) -> tuple[DeviceOfSeveral, ...]:
    """Return a summary of each device and joint, in the order of the runs'."""
    names, found = scenario.names, list[DeviceOfSeveral]()
    for name, body in zip(names, placed(assembly.members, scenario.surroundings()), strict=True):
        for element in () if body.held is None else body.held.elements:
            summary = device_summary(element.kind, element, len(found), runs)
            found.append(DeviceOfSeveral((name,), summary))
    for joint in assembly.joints:
        pieces = names[joint.first], names[joint.second]
        found.append(DeviceOfSeveral(pieces, device_summary(JOINT, None, len(found), runs)))
    return tuple(found)
