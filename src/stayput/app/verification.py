"""A verification as a job: which options it compares, and its verdict as plain data."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.app.fields import Problem, Words
from stayput.app.japanese import wording_of
from stayput.app.refusals import RefusedError
from stayput.app.running import class_of
from stayput.app.scenes import YOURS
from stayput.app.verdict_replies import (
    CapacitiesReply,
    CapacityReply,
    ChanceReply,
    ChangeReply,
    CurveReply,
    DeviceSummaryReply,
    EstimatesReply,
    JobReply,
    ObservedReply,
    OptionReply,
    QuantilesReply,
    VerdictReply,
)
from stayput.fragility import JMA_INTENSITY
from stayput.measures import MEASURES
from stayput.scenario import Scenario
from stayput.verification import verify
from stayput.verification.compare import LEVELS
from stayput.verification.options import NOTHING, options_of, usual_options
from stayput.verification.verdict import DEVICE_FAILED, HIT_WALL, OVERTURNED, SLID
from stayput.verification.words import headline, reason

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from stayput.app.jobs import Job
    from stayput.app.limits import Limits
    from stayput.fragility import Capacity, FragilityCurve, Probability
    from stayput.measures import Measure
    from stayput.verification import Verdict
    from stayput.verification.verdict import OptionVerdict, Quantiles

CURVE: NDArray[np.float64] = np.round(np.linspace(4.0, 7.0, 61), 3)
"""JMA intensities at which a curve is sent."""
CURVE.setflags(write=False)


def with_options(scenario: Scenario, data: dict[str, Any], compare_usual: bool) -> Scenario:
    """Return a scene with all options that are to be compared.

    Parameters
    ----------
    scenario : Scenario
        The scene with the user's set, if there is one.
    data : dict
        The scene as it came, which has passed as ``scenario``.
    compare_usual : bool
        Whether the usual measures are compared besides the user's.

    Raises
    ------
    InputError
        A measure that cannot be applied.
    """
    own = next((one for one in scenario.measures if one.name == YOURS), None)
    if own is None:
        options_of(scenario)
        return scenario
    tables: list[dict[str, Any]] = [{"name": YOURS, "combine": [table_of(one) for one in own.measures]}]
    seen = {own.measures}
    alone = [(measure,) for measure in own.measures]
    usual = usual_options(scenario.furniture.body(), scenario.room.room()) if compare_usual else ()
    for measures in (*alone, *(option.measures for option in usual)):
        if measures not in seen:
            seen.add(measures)
            tables.append(_option(measures, {one.get("name") for one in tables}))
    whole = Scenario.parse({**data, "measures": tables}, scenario.folder)
    options_of(whole)
    return whole


def _option(measures: tuple[Measure, ...], taken: set[Any]) -> dict[str, Any]:
    name = " + ".join(one.kind for one in measures)
    while name in taken:  # the same kind with parameters of the user's
        name += ", as usual"
    tables = [table_of(one) for one in measures]
    return {**tables[0], "name": name} if len(tables) == 1 else {"name": name, "combine": tables}


def table_of(measure: Measure) -> dict[str, Any]:
    """Return a measure as a scenario has it: its type, and what is not its default."""
    usual = MEASURES[measure.kind]()
    names = measure.__dataclass_fields__
    changed = {n: getattr(measure, n) for n in names if getattr(measure, n) != getattr(usual, n)}
    return {"type": measure.kind, **changed}


def runs_of(scenario: Scenario, limits: Limits, levels: int) -> int:
    """Return how many simulations a verification makes at most.

    Raises
    ------
    RefusedError
        More than this server allows.
    """
    options, shaking = len(options_of(scenario)), scenario.shaking
    motions = 1
    if shaking.of_a_suite:
        motions = (
            shaking.suite.count if shaking.suite is not None and not isinstance(shaking.suite, str) else 40
        )
    most = max(1, -(-scenario.uncertainty.samples // motions))
    runs = options * motions * most * (1 + levels)
    if runs > limits.runs:
        told = f"This verification makes {runs} simulations; this server allows {limits.runs}."
        raise RefusedError(422, told, "scene.uncertainty.samples")
    return runs


def verified(
    scenario: Scenario,
    slide_limit: float,
    curves: bool,
    threads: int,
    told: Callable[[int, int], None],
) -> Verdict:
    """Verify a scene on this thread; what ``told`` raises stops it."""
    levels = LEVELS if curves else LEVELS[:0]
    return verify(
        scenario, levels=levels, slide_limit=slide_limit, threads=threads, progress=False, told=told
    )


def job_reply(job: Job) -> JobReply:
    """Return how a job stands, with its verdict once there is one."""
    verdict = job.verdict if job.state == "done" else None
    return JobReply(
        id=job.id,
        state=job.state,
        done=job.done,
        total=job.total,
        progress=1.0 if job.state == "done" else min(1.0, job.done / max(1, job.total)),
        seconds=round(job.seconds, 3),
        error=None if job.message is None else _problem(job.message, job.about),
        result=None if verdict is None else verdict_reply(verdict),
    )


def _problem(message: str, field: str | None) -> Problem:
    return Problem(message=message, message_ja=wording_of(message)[0], field=field)


def verdict_reply(verdict: Verdict) -> VerdictReply:
    """Return a verdict as plain data."""
    estimates = verdict.estimates
    return VerdictReply(
        headline=Words(en=headline(verdict, "en"), ja=headline(verdict, "ja")),
        intensity=_finite(verdict.intensity),
        intensity_class=class_of(_finite(verdict.intensity)),
        slide_limit_m=verdict.slide_limit,
        motions=verdict.motions,
        samples=verdict.samples,
        runs=verdict.runs,
        precise=verdict.precise,
        seed=verdict.seed,
        seconds=round(verdict.seconds, 3),
        options=[_option_reply(one, verdict) for one in verdict.options],
        estimates=EstimatesReply(
            rocking_acceleration_m_s2=estimates.rocking_acceleration,
            overturning_velocity_m_s=estimates.overturning_velocity,
            possible=estimates.possible,
            overturning_ratio=estimates.overturning_ratio,
        ),
    )


def _option_reply(one: OptionVerdict, verdict: Verdict) -> OptionReply:
    option, chances = one.option, one.probabilities
    label = Words(en=option.label("en"), ja=option.label("ja")) if option.measures else Words.of(NOTHING)
    change = one.change
    curve = one.curves.get(JMA_INTENSITY)
    return OptionReply(
        rank=one.rank,
        name=option.name,
        label=label,
        measures=[table_of(measure) for measure in option.measures],
        reason=Words(en=reason(one, verdict, "en"), ja=reason(one, verdict, "ja")),
        yours=option.name == YOURS,
        overturned=_chance(chances[OVERTURNED]),
        slid=_chance(chances[SLID]),
        hit_wall=_chance(chances[HIT_WALL]),
        device_failed=_chance(chances[DEVICE_FAILED]),
        change=None
        if change is None
        else ChangeReply(
            estimate=_finite(change.estimate),
            low=_finite(change.low),
            high=_finite(change.high),
            clear=change.clear,
        ),
        slide_m=_quantiles(one.slide),
        tilt_rad=_quantiles(one.tilt),
        devices=[
            DeviceSummaryReply(
                kind=device.kind,
                name=device.name,
                label=Words.of(MEASURES[device.kind].label),
                failed=_chance(device.failed),
                peak_n=_quantiles(device.peak),
            )
            for device in one.devices
        ],
        capacity=CapacitiesReply(p10=_capacity(one.capacities[0.1]), p50=_capacity(one.capacities[0.5]))
        if one.capacities
        else None,
        curve=None if curve is None else _curve(curve),
    )


def _chance(found: Probability) -> ChanceReply:
    return ChanceReply(estimate=_finite(found.estimate), low=found.low, high=found.high, text=found.text)


def _quantiles(found: Quantiles) -> QuantilesReply:
    return QuantilesReply(median=_finite(found.median), p90=_finite(found.p90))


def _capacity(found: Capacity) -> CapacityReply:
    return CapacityReply(
        estimate=_finite(found.estimate), low=_finite(found.low), high=_finite(found.high), text=found.text
    )


def _curve(curve: FragilityCurve) -> CurveReply:
    fitted = bool(np.isfinite(curve.ab).all())
    low, high = curve.band(CURVE) if fitted else (None, None)
    return CurveReply(
        state=str(curve.state),
        text=curve.text,
        intensity=CURVE.tolist(),
        probability=_shares(curve.probability(CURVE)) if fitted else None,
        low=None if low is None else _shares(low),
        high=None if high is None else _shares(high),
        observed=[
            ObservedReply(
                intensity=level.im,
                estimate=_finite(level.probability.estimate),
                low=level.probability.low,
                high=level.probability.high,
            )
            for level in curve.levels
        ],
    )


def _shares(values: NDArray[np.float64]) -> list[float]:
    return np.round(values, 5).tolist()


def _finite(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
