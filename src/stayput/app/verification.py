"""A verification as a job: which options it compares, and its verdict as plain data."""

from __future__ import annotations

import base64
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from stayput.app import verdict_replies
from stayput.app.refusals import problem, too_many_runs
from stayput.app.replies import Words
from stayput.app.running import own_measures
from stayput.app.scenes import motions_of
from stayput.fragility.curve import METHOD, CurveState
from stayput.fragility.intensity_measures import JMA_INTENSITY
from stayput.measures import MEASURES, hold
from stayput.report.room.data import room_data
from stayput.report.verdict.data import everyday_data, verdict_data
from stayput.report.verdict.tables import estimate_rows
from stayput.rooms.verdict import RoomVerdict
from stayput.scenario import Scenario
from stayput.scenario.measures import table_of
from stayput.scenario.option import YOURS
from stayput.verification.contents import runs_of_contents
from stayput.verification.notes import everyday_note, shaken_notes
from stayput.verification.options import compared_options, usual, weakest
from stayput.verification.words import asides

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from stayput.app.jobs import AnyVerdict, Job
    from stayput.app.limits import Limits
    from stayput.fragility.curve import FragilityCurve
    from stayput.measures import Measure
    from stayput.scenario.tables import EverydayTable
    from stayput.verification import Verdict
    from stayput.verification.verdict import OptionVerdict

CURVE_POINTS = 96
"""Intensities at which a curve is sent, over what was run: five from level to level."""


def with_options(scenario: Scenario, data: dict[str, Any], compare_usual: bool) -> Scenario:
    """Return a scene with all options that are to be compared; not all usual ones need be possible.

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
        A measure of the user's that cannot be applied.
    """
    yours = own_measures(scenario)
    if not yours:
        compared_options(scenario)
        return scenario
    tables: list[dict[str, Any]] = [{"name": YOURS, "combine": [table_of(measure) for measure in yours]}]
    seen = {yours}
    alone = [(measure,) for measure in yours]
    body, room = scenario.piece.body(), scenario.room.room()
    for measures in (yours, *alone):
        hold(body, room, measures)
    for measures in (*alone, *(option.measures for option in usual() if compare_usual)):
        if measures not in seen:
            seen.add(measures)
            tables.append(_option(measures, {table.get("name") for table in tables}))
    return Scenario.parse({**data, "measures": tables}, scenario.folder)


def _option(measures: tuple[Measure, ...], taken: set[Any]) -> dict[str, Any]:
    name = " + ".join(measure.kind for measure in measures)
    while name in taken:  # the same kind with parameters of the user's
        name += ", as usual"
    tables = [table_of(measure) for measure in measures]
    return {**tables[0], "name": name} if len(tables) == 1 else {"name": name, "combine": tables}


def runs_of(scenario: Scenario, limits: Limits, levels: int) -> int:
    """Return how many simulations a verification makes at most.

    Raises
    ------
    RefusedError
        More than this server allows.
    """
    (compared, _), shaking = compared_options(scenario), scenario.shaking
    options = len(compared)
    motions = motions_of(shaking)
    most = max(1, -(-scenario.samples // motions))
    badly = 1 if scenario.uncertainty.badly(1.0) > 0.0 else 0
    runs = options * motions * most * (1 + badly + levels)
    if scenario.contents is not None:
        runs += options * runs_of_contents(scenario.contents, motions)
    allowed = limits.runs if scenario.dimensions == 2 else limits.runs_in_space
    if runs > allowed:
        raise too_many_runs(runs, allowed)
    return runs


def job_reply(job: Job, rewrite: Callable[[str], str]) -> verdict_replies.JobReply:
    """Return the state of a job, with its verdict once it is done; that of a room as far as it is known.

    Parameters
    ----------
    job : Job
        The job.
    rewrite : callable
        Puts the users' names for their files into a sentence.
    """
    return verdict_replies.JobReply.from_attributes(
        job,
        state=job.state,  # before the verdict, which is the final one when the job is done
        progress=1.0 if job.state == "done" else min(1.0, job.done / max(1, job.total)),
        seconds=round(job.seconds, 3),
        error=None if job.error is None else problem(job.error.rewritten(rewrite)),
        result=None if job.verdict is None else _any_verdict_reply(job.verdict),
    )


def _any_verdict_reply(
    verdict: AnyVerdict,
) -> verdict_replies.VerdictReply | verdict_replies.RoomVerdictReply:
    return _room_verdict_reply(verdict) if isinstance(verdict, RoomVerdict) else verdict_reply(verdict)


def verdict_reply(verdict: Verdict) -> verdict_replies.VerdictReply:
    """Return a verdict as plain data: that of its JSON file, as the page reads it."""
    data = verdict_data(verdict)
    pairs = zip(verdict.options, data["options"], strict=True)
    looked_at = _looked_at(verdict)
    data |= {
        "complete": verdict.complete,
        "headline": data["verdict"],
        "notes": [Words.of(note) for note in shaken_notes(verdict, looked_at.option)],
        "intensity": data["jma_intensity"],
        "seconds": round(verdict.seconds, 3),
        "options": [_option_data(result, option, verdict) for result, option in pairs],
        "everyday": everyday_reply(verdict),
        "estimates": {**data["estimates"], "rows": _estimates(verdict)},
    }
    return verdict_replies.VerdictReply.model_validate(data)


def with_everyday(verdict: Verdict, everyday: EverydayTable) -> Verdict:
    """Return a verdict on the same piece with which people do something else."""
    return replace(verdict, scenario=verdict.scenario.model_copy(update={"everyday": everyday}))


def everyday_reply(verdict: Verdict) -> verdict_replies.EverydayReply:
    """Return what the piece of a verdict withstands without an earthquake."""
    return verdict_replies.EverydayReply.model_validate(
        {"sentence": Words.of(everyday_note(verdict)), "cases": everyday_data(verdict.scenario)}
    )


def _estimates(verdict: Verdict) -> list[verdict_replies.EstimateReply]:
    rows = zip(estimate_rows(verdict, "en"), estimate_rows(verdict, "ja"), strict=True)
    return [
        verdict_replies.EstimateReply(formula=formula, says=says, beside=beside)
        for formula, says, beside in (map(Words.of, zip(*row, strict=True)) for row in rows)
    ]


def _looked_at(verdict: Verdict) -> OptionVerdict:
    """Return the option that the page's reader has put together: without measures where there is none."""
    yours = (each for each in verdict.options if each.option.name == YOURS and each.option.measures)
    return next(yours, verdict.without)


def _option_data(result: OptionVerdict, data: dict[str, Any], verdict: Verdict) -> dict[str, Any]:
    """Return an option as the page reads it, from its data in the JSON file."""
    capacities = {f"p{100.0 * capacity['share']:.0f}": capacity for capacity in data["capacities"]}
    for capacity in capacities.values():
        capacity["estimate"] = capacity["jma_intensity"]
    curve = result.curves.get(JMA_INTENSITY)
    observed = [row["levels"] for row in data["curves"] if row["measure"] == JMA_INTENSITY.key]
    return {
        **data,
        **data["probabilities"],
        "measures": [table_of(measure) for measure in result.option.measures],
        "weakest": [Words.of(item.label) for item in weakest(result.option, verdict.scenario)],
        "asides": [Words.of(aside) for aside in asides(result, verdict)],
        "yours": result.option.name == YOURS,
        "change": data["overturned_change"],
        "slide_m": data["peak_slide_m"],
        "tilt_rad": data["peak_tilt_rad"],
        "devices": [
            {
                **device,
                "kind": device["type"],
                "label": Words.of(MEASURES[device["type"]].label),
                "peak_n": device["peak_force_n"],
            }
            for device in data["devices"]
        ],
        "capacity": capacities or None,
        "curve": None if curve is None else _curve(curve, observed[0]),
    }


def _curve(curve: FragilityCurve, levels: list[dict[str, Any]]) -> verdict_replies.CurveReply:
    grid, fitted = curve.grid(CURVE_POINTS), curve.state is CurveState.FITTED
    low, high = curve.band(grid)
    banded = fitted and not curve.one_motion
    return verdict_replies.CurveReply(
        state=str(curve.state),
        method=METHOD,
        text=curve.text,
        intensity=grid.round(3).tolist(),
        probability=_shares(curve.probability(grid)) if fitted else None,
        low=_shares(low) if banded else None,
        high=_shares(high) if banded else None,
        observed=[verdict_replies.ObservedReply(intensity=level["im"], **level) for level in levels],
    )


def _shares(values: NDArray[np.float64]) -> list[float]:
    return np.round(values, 5).tolist()


def _room_verdict_reply(verdict: RoomVerdict) -> verdict_replies.RoomVerdictReply:
    """Return a verdict on a room as plain data: that of its JSON file, as the page reads it."""
    data = room_data(verdict)
    data["complete"] = verdict.complete
    run = verdict.typical
    data["typical"] = None if run is None else {"member": run.member, "direction_rad": run.direction}
    for piece, result in zip(data["pieces"], verdict.pieces, strict=True):
        piece["fell"], piece["stood"] = _zone(result.fell), _zone(result.stood)
    for change, result in zip(data["changes"], verdict.changes, strict=True):
        measure = result.change.measure
        change["measures"] = None if measure is None else [table_of(measure)]
        change["table"] = "furniture" if result.change.what in verdict.scenario.names else "places"
    return verdict_replies.RoomVerdictReply.model_validate(data)


def _zone(shares: NDArray[np.float64]) -> verdict_replies.ZoneReply:
    nx, ny = shares.shape
    steps = np.round(255.0 * shares).astype(np.uint8)
    return verdict_replies.ZoneReply(nx=nx, ny=ny, shares=base64.b64encode(steps.tobytes()).decode("ascii"))
